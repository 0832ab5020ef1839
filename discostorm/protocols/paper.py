"""DDS and Zenoh discovery as the paper counts them (Sec. III, equations 1 to 10).

``data/paper/messages.csv`` says what each message is counted by, ``table2.csv`` its size. Timers,
for simulated recovery, are those of Fast DDS and of Zenoh, as the paper names none.
"""

from discostorm.data import read_data
from discostorm.messages import Family, Protocol
from discostorm.protocols.defaults import timers
from discostorm.protocols.measured_tables import messages_from_rows


def _table(name: Family, product: str) -> Protocol:
    sizes = {row["message"]: row for row in read_data("paper/table2.csv")}
    rows = [row for row in read_data("paper/messages.csv") if row["protocol"] == name]
    messages = messages_from_rows(row | sizes[row["message"]] for row in rows)
    return Protocol(name, messages, family=name, basis="paper", timers=timers(product), key=name)


DDS = _table("DDS", "Fast DDS")
ZENOH = _table("Zenoh", "Zenoh")

"""A discovery protocol is a table of messages; its load and utilization follow from it.

`units` says what is counted, `schedule` when it is sent, `message` is a row of the table, and
`protocol` the table. `legs` says which messages go through a server. `user_data` makes a table of
what a fleet sends besides discovery.
"""

from discostorm.messages.message import (
    HOPS as HOPS,
    Hop as Hop,
    Message as Message,
    Payload as Payload,
    Role as Role,
    Transport as Transport,
    header_bytes as header_bytes,
    hop_airtime as hop_airtime,
)
from discostorm.messages.protocol import (
    Basis as Basis,
    Family as Family,
    Protocol as Protocol,
    Timers as Timers,
)
from discostorm.messages.schedule import (
    ONCE as ONCE,
    PAPER_WINDOW as PAPER_WINDOW,
    Schedule as Schedule,
    checked_window as checked_window,
)
from discostorm.messages.units import (
    ENDPOINT as ENDPOINT,
    ENDPOINT_PAIR as ENDPOINT_PAIR,
    HOST as HOST,
    MATCHED_WRITER as MATCHED_WRITER,
    PAIR as PAIR,
    PROCESS as PROCESS,
    UNIT_IF_SERVER_ON_ROBOT as UNIT_IF_SERVER_ON_ROBOT,
    UNITS as UNITS,
    Hosts as Hosts,
    Unit as Unit,
)
from discostorm.messages.user_data import DATA as DATA, user_data_protocol as user_data_protocol

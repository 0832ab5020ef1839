"""Test that a new table of messages, of rows or in a file, is found everywhere."""

import json
import shutil
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import pytest
from support import ROOT

import discostorm as ds
from discostorm.messages import Message, Protocol, Schedule, Timers
from discostorm.protocols.defaults import defaults, timers
from discostorm.protocols.measured_tables import measured_table

PROTOCOL = '''
"""A protocol of a test."""

from discostorm.messages import PAIR, PROCESS, Message, Payload, Protocol, Schedule

_SIZE = Payload(100, 50, 150, "made up")

MADE_UP = Protocol(
    "Made up",
    (
        # Of the same name as a message of DDS, and of another size.
        Message("SPDP", "Hello", "multicast", "UDP", _SIZE, PROCESS, 1, Schedule((0,), 5)),
        Message("Answer", "Hello", "unicast", "UDP", _SIZE, PAIR, 2, answers="SPDP"),
    ),
    lease=30,
)
'''


PRODUCT = """
import json
import discostorm as ds

fleet = ds.Fleet.swarm(3, 2, 10)
new, old = ds.PROTOCOLS["Rust DDS"], ds.PROTOCOLS["Fast DDS"]
print(json.dumps({
    "names": list(ds.PROTOCOLS),
    "same": (new.messages, new.family, new.timers) == (old.messages, old.family, old.timers),
    "load": ds.utilization(new, fleet) == ds.utilization(old, fleet),
}))
"""


def test_another_measured_product_is_rows_of_data_alone(tmp_path: Path) -> None:
    """Here of what Fast DDS sends; what another does is counted by a program of the lab."""
    shutil.copytree(ROOT / "discostorm", tmp_path / "discostorm")
    for name in ("vendors/products", "vendors/as_built", "measured/as_built"):
        path = tmp_path / "discostorm" / "data" / f"{name}.csv"
        lines = path.read_text(encoding="utf-8").splitlines(keepends=True)
        new = [
            line.replace("Fast DDS,", "Rust DDS,", 1) for line in lines if line[:9] == "Fast DDS,"
        ]
        path.write_text("".join(lines + new), encoding="utf-8")
    done = subprocess.run(
        [sys.executable, "-c", PRODUCT], cwd=tmp_path, capture_output=True, text=True, check=True
    )
    found = json.loads(done.stdout)
    others = [name for name in found.pop("names") if name != "Rust DDS"]
    assert others == list(ds.PROTOCOLS)
    assert found == {"same": True, "load": True}


def test_two_protocols_of_one_name_are_refused(tmp_path: Path) -> None:
    shutil.copytree(ROOT / "discostorm", tmp_path / "discostorm")
    text = PROTOCOL.replace('"Made up"', '"DDS"')
    (tmp_path / "discostorm" / "protocols" / "made_up.py").write_text(text, encoding="utf-8")
    done = subprocess.run(
        [sys.executable, "-c", "import discostorm.protocols"],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        check=False,
    )
    assert "protocols must have distinct names; got two 'DDS'" in done.stderr


EVERY = [table for known in ds.PROTOCOLS.values() for table in (known, known.wired) if table]


@pytest.mark.parametrize("table", EVERY, ids=lambda table: table.name)
def test_every_table_says_whose_it_is_and_what_its_messages_are_for(table: Protocol) -> None:
    assert table.basis is not None
    assert table.timers is not None
    # Only a proposal is of no family; the paper's tables and proposals are of no product.
    assert (table.family is None) == (table.basis == "proposal")
    assert (table.product is None) == (table.basis in ("paper", "proposal"))
    if table.product is not None:  # releases differ in how they repair, not in their periods
        usual = timers(table.product)
        periods = [name for name in vars(usual) if "period" in name or "interval" in name]
        assert [getattr(table.timers, n) for n in periods] == [getattr(usual, n) for n in periods]
    roles = [message.role for message in table.messages]
    assert None not in roles
    assert "announcement" in roles or table.name.startswith("Zenoh router")
    assert any(message.informs for message in table.messages)
    # What is repeated until it is acknowledged is one message, and so is its answer.
    for role in ("heartbeat", "acknowledgement"):
        assert roles.count(role) <= 1 or "Discovery Server" in table.name


def test_what_is_said_of_a_table_is_checked() -> None:
    spdp, table = ds.DDS.messages[0], {"name": "own", "messages": ds.DDS.messages}
    for wrong, error in (
        ({"role": "Heartbeat"}, "role must be 'announcement' or .* or None; got 'Heartbeat'"),
        ({"informs": 1}, "informs must be .*bool"),
    ):
        with pytest.raises((ValueError, TypeError), match=error):
            replace(spdp, **wrong)
    for wrong, error in (
        ({"family": "RTPS"}, "family must be 'DDS' or 'Zenoh', or None; got 'RTPS'"),
        ({"basis": "own"}, "basis must be 'paper' or .* or None; got 'own'"),
        ({"product": 1}, "product must be .*str"),
        ({"timers": 1.0}, "timers must be .*Timers"),
    ):
        with pytest.raises((ValueError, TypeError), match=error):
            Protocol(**table, **wrong)
    for wrong, error in (
        ({"heartbeat_period_max": 0.0}, "heartbeat_period_max must be .* above 0"),
        (
            {"heartbeat_period_initial": 2.0},
            "heartbeat_period_initial must be .* at most 1; got 2.0",
        ),
        ({"announce_interval_initial": -1.0}, "announce_interval_initial must be .* at least 0"),
        ({"nack_response_delay": -0.1}, "nack_response_delay must be .* at least 0"),
    ):
        with pytest.raises(ValueError, match=error):
            Timers(**wrong)


def test_announcements_inform_unless_told_otherwise() -> None:
    rest = ("unicast", "UDP", ds.DDS.messages[0].payload, ds.DDS.messages[0].unit, 1)
    told = {
        role: Message("a", "b", *rest, role=role).informs for role in (None, "data", "announcement")
    }
    assert told == {None: False, "data": False, "announcement": True}
    # A Scout asks who is there; who answers it is known from the answer.
    assert [ds.ZENOH.message(name).informs for name in ("Scout", "Hello")] == [False, True]


@pytest.mark.parametrize(
    ("name", "ending"), [("a", "'a'"), ("fast-dds", r"'fast-dds'\. Did you mean 'Fast DDS'\?")]
)
def test_an_unknown_measured_table_is_answered_with_the_nearest(name: str, ending: str) -> None:
    with pytest.raises(ValueError, match=f"name must name a .*; got {ending}"):
        measured_table(name)
    with pytest.raises(TypeError, match="name must be a str; got 3"):
        measured_table(3)  # type: ignore[arg-type]


def test_timed_tables_have_the_defaults_of_their_products() -> None:
    """The rows of timed.csv, from middleware_defaults.csv, which has the vendors' sources."""
    fast, cyclone, zenoh = map(defaults, ("Fast DDS", "Cyclone DDS", "Zenoh"))
    again = (n * fast["initial_period"] for n in range(int(fast["initial_announcements"]) + 1))
    announced = Schedule(tuple(round(t, 9) for t in again), fast["announcement_period"])
    replies = (n * cyclone["directed_period"] for n in range(int(cyclone["directed_replies"])))
    alive = Schedule((0,), cyclone["lease"] - cyclone["liveliness_margin"])
    interval = min(cyclone["spdp_interval"], cyclone["lease"] - cyclone["spdp_margin"])
    scouts, gap = [0.0], zenoh["scout_first"]
    while gap < zenoh["scout_most"]:
        scouts.append(scouts[-1] + gap)
        gap *= zenoh["scout_factor"]
    scouting = Schedule(tuple(scouts), zenoh["scout_most"])
    quiet = zenoh["lease"] / zenoh["keep_alives"]
    expected = {
        "DDS, periods of Fast DDS": {
            "SPDP": (announced, 1),
            "UnicastSPDP": (announced, fast["unicast_copies"]),
        },
        "DDS, periods of Cyclone DDS": {
            "SPDP": (Schedule((0, cyclone["second_announcement"]), interval), 1),
            "DirectedSPDP": (Schedule(tuple(replies)), 1),
            "Liveliness": (alive, 1),
            "LivelinessACK": (alive, 1),
        },
        "Zenoh, periods of Zenoh peer": {
            "Scout": (scouting, 1),
            "Hello": (scouting, zenoh["hellos"]),
            "KeepAlive": (Schedule((quiet,), quiet), 1),
        },
    }
    for name, messages in expected.items():
        table, paper = ds.PROTOCOLS[name], ds.PROTOCOLS[name.partition(",")[0]]
        rows = {m.name: (m.schedule, m.per_unit) for m in table.messages}
        usual = {m.name: (m.schedule, m.per_unit) for m in paper.messages}
        assert rows == {key: value for key, value in usual.items() if key in rows} | messages
    payload = ds.PROTOCOLS["DDS, periods of Cyclone DDS"].message("Liveliness").payload
    assert payload.nominal == cyclone["liveliness_payload"]


def test_fast_dds_answers_discovery_between_its_first_two_announcements() -> None:
    messages = {message.name: message for message in ds.PROTOCOLS["Fast DDS"].messages}
    first, second = messages["SPDP"].schedule.starts[:2]
    answers = ("SPDP at discovery", "SPDP unicast at discovery", "SEDP", "Heartbeat")
    assert {messages[name].schedule.starts for name in answers} == {((first + second) / 2,)}

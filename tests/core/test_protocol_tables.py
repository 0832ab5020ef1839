"""A protocol is rows, or one file: all that takes protocols finds it; a table says what it is."""

import json
import shutil
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import pytest
from support import ROOT

import discostorm as ds
from discostorm.messages import Message, Protocol, Timers
from discostorm.protocols.defaults import timers

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

PROBE = """
import json, sys
import discostorm as ds
from discostorm import figures, timeline, uncertainty
from discostorm.cli import main
from write_calculator import javascript

made_up = ds.PROTOCOLS["Made up"]
swarm = {"hosts": 7, "processes": 2, "endpoints": 10}
script = javascript()
found = {
    "utilization": ds.utilization(made_up, **swarm),
    "dds": ds.utilization(ds.DDS, **swarm),
    "saturation": ds.saturation_hosts(made_up, 2, 10),
    "breakdown": list(ds.breakdown(made_up, **swarm).index),
    "plan": ds.plan(ds.Fleet.swarm(**swarm), made_up).protocol.name,
    "color": figures.COLORS["Made up"],
    "bounds": list(map(float, uncertainty.bounds(made_up, **swarm))),
    "outlook": timeline.outlook(made_up, **swarm),
    "calculator": '["SPDP", "multicast", 164,' in script and '"Made up": {' in script,
}
print(json.dumps(found))
main(["utilization", "--hosts", "7", "--processes", "2", "--endpoints", "10",
      "--protocol", "made up", "--json"])
"""


@pytest.mark.book
def test_a_new_file_of_protocols_is_found_everywhere(tmp_path: Path) -> None:
    for folder in ("discostorm", "scripts"):
        shutil.copytree(ROOT / folder, tmp_path / folder)
    (tmp_path / "discostorm" / "protocols" / "made_up.py").write_text(PROTOCOL, encoding="utf-8")
    (tmp_path / "probe.py").write_text(PROBE, encoding="utf-8")
    done = subprocess.run(
        [sys.executable, "probe.py"], cwd=tmp_path, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    first, printed = done.stdout.split("\n", 1)
    found = json.loads(first)
    # By hand: 14 multicasts of 164 B and 168 pairs with two answers, at the paper's rates.
    up = 8 * 164 / 144.4e6 + 180e-6
    down = 8 * 164 / 6e6 + 120e-6
    # One announcement at the start and one each 5 s, in an average second at most 6/5.
    by_hand = 14 * 1.2 * (up + down) + 168 * 2 * 2 * up
    assert found["utilization"] == pytest.approx(by_hand, rel=1e-12)
    assert found["dds"] == pytest.approx(0.95391, abs=1e-5)  # the other SPDP is as it was
    assert found["breakdown"] == ["SPDP", "Answer"]
    assert found["plan"] == "Made up"
    assert found["bounds"][0] < found["utilization"] < found["bounds"][1]
    assert found["calculator"]
    assert json.loads(printed)[0]["protocol"] == "Made up"


PRODUCT = """
import json
import discostorm as ds

fleet = ds.Fleet.swarm(3, 2, 10)
new, old = ds.PROTOCOLS["Rust DDS"], ds.PROTOCOLS["Fast DDS"]
print(json.dumps({
    "names": list(ds.PROTOCOLS),
    "same": (new.messages, new.family, new.timers) == (old.messages, old.family, old.timers),
    "plan": ds.plan(fleet, new).utilization == ds.plan(fleet, old).utilization,
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
    assert found == {"same": True, "plan": True}


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
    assert table.product is None or table.timers == timers(table.product)
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

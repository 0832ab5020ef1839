"""A protocol in a new file is found by every package and the calculator."""

import json
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from support import ROOT

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
from pathlib import Path
import discostorm as ds
from discostorm import figures, drain_times, uncertainty
from discostorm.cli import main

sys.path.extend(map(str, Path("scripts").rglob("")))
from discostorm_planner.calculator import model_js

made_up = ds.PROTOCOLS["Made up"]
swarm = {"hosts": 7, "processes": 2, "endpoints": 10}
script = model_js()
found = {
    "utilization": ds.utilization(made_up, **swarm),
    "dds": ds.utilization(ds.DDS, **swarm),
    "saturation": ds.saturation_hosts(made_up, 2, 10),
    "breakdown": list(ds.breakdown(made_up, **swarm).index),
    "plan": ds.plan(ds.Fleet.swarm(2, 1, 2), made_up).protocol.name,
    "color": figures.COLORS["Made up"],
    "bounds": list(map(float, uncertainty.bounds(made_up, **swarm))),
    "outlook": drain_times.outlook(made_up, **swarm),
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

"""The pages about the library: their code runs, and the reference has every public name."""

import re
from typing import Any

import pytest
from support import ROOT

import discostorm as ds

REUSE = (ROOT / "book" / "reuse.md").read_text(encoding="utf-8")
API = (ROOT / "book" / "api.md").read_text(encoding="utf-8")
#: The code that readers see, without what it is shown with.
CELLS = re.findall(
    r"^```\{code-cell\} ipython3\n(?!:tags)(?:---\n.+?^---\n)?(.+?)^```", REUSE, re.M | re.S
)


@pytest.fixture(scope="module")
def after() -> dict[str, Any]:
    """Return the names that the page's code defines."""
    names: dict[str, Any] = {}
    for cell in CELLS:
        exec(cell, names)
    return names


def test_each_example_has_ten_lines_at_most() -> None:
    assert len(CELLS) == REUSE.count("\n## Your ") == 5
    lines = [[line for line in cell.splitlines() if line] for cell in CELLS]
    assert max(map(len, lines)) <= 10
    assert max(len(line) for cell in lines for line in cell) <= 73  # all that a page shows


def test_the_examples_compute_what_the_page_says(
    after: dict[str, Any], capsys: pytest.CaptureFixture[str]
) -> None:
    hello, reply = after["beacon"].messages
    assert str(hello.schedule) == "at 0 and 1 s, then every 10 s"
    assert (hello.payload.nominal, reply.payload.nominal) == (120, 300)
    assert len(after["table"]) == 2 * 11
    # By hand, at the paper's rates: two processes on each of two hosts, eight ordered pairs.
    up, down = (lambda size: 8 * size / 144.4e6 + 180e-6), (lambda size: 8 * size / 6e6 + 120e-6)
    hellos = 4 * (1 + 9 / 10 + 1 / 10) * (up(120 + 64) + down(120 + 64))
    found = after["table"].query("protocol == 'Beacon' and hosts == 2")["utilization"].item()
    assert found == pytest.approx(hellos + 8 * 2 * up(300 + 64))
    assert after["longer"].message("SEDP").payload.source == "my capture of SEDP"
    assert after["low"] < ds.utilization(after["longer"], 7, 2, 10) < after["high"]
    assert ds.utilization(ds.DDS, 7, 2, 10) < ds.utilization(after["longer"], 7, 2, 10)
    assert after["fleet"].names == ("robots", "laptop", "server")
    exec(CELLS[2].replace("ds.sweep(", "hosts = ds.sweep("), after)
    channels = ["paper", "802.11ac 80 MHz", after["radio"].wifi().name, "my site"]
    assert after["hosts"]["wifi"].tolist() == channels
    assert after["hosts"]["saturation_hosts"].iloc[0] == ds.saturation_hosts("dds", 2, 10)
    assert not capsys.readouterr().err


def test_the_reference_has_every_public_function_and_class() -> None:
    listed = re.findall(r"^\.\. auto(?:function|class):: discostorm\.(\w+)$", API, re.MULTILINE)
    public = [name for name in dir(ds) if callable(getattr(ds, name))]
    assert sorted(listed) == sorted(public)
    members = re.findall(r"discostorm\.(\w+)\n   :members: (.+)$", API, re.MULTILINE)
    for name, methods in members:
        assert all(hasattr(getattr(ds, name), method) for method in methods.split(", ")), name
    for name in re.findall(r"`ds\.([A-Z_]+)`", API):
        assert hasattr(ds, name)

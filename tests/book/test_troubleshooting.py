"""The page "What is wrong with my robots?": no question is lost, and what it says is so."""

import ast
import json
import re
import shlex
from functools import cache
from typing import Any

import click
import pytest
from IPython.display import Markdown
from support import ROOT

from discostorm.cli import main
from discostorm.data import data_path, read_data
from discostorm.wording import TCPDUMP

PAGE = (ROOT / "book" / "what_is_wrong.md").read_text(encoding="utf-8")

#: The questions that the page must answer, as project and number.
_QUESTIONS = """
ProjectStarling#164 turtlebot4#17 turtlebot4#18 turtlebot4#406 turtlebot4#574
rmw_fastrtps#281 rmw_fastrtps#315 rmw_fastrtps#454 rmw_fastrtps#745
cyclonedds#1421 cyclonedds#1830 ros2_documentation#1453
Fast-DDS#1719 Fast-DDS#2201 Fast-DDS#2290 Fast-DDS#2624 Fast-DDS#2956 Fast-DDS#3163 Fast-DDS#3286
Fast-DDS#3472 Fast-DDS#3544 Fast-DDS#4111 Fast-DDS#5103 Fast-DDS#5396
rmw_cyclonedds#251 rmw_cyclonedds#328 rmw_cyclonedds#376 rmw_cyclonedds#458 rclpy#1212
navigation2#3560 navigation2#5557
rmw_zenoh#318 rmw_zenoh#468 rmw_zenoh#516 rmw_zenoh#522 rmw_zenoh#626 rmw_zenoh#914 rmw_zenoh#916
zenoh-plugin-dds#153 tailscale#11972 husarnet#100
ros2#264 ros2#1319 rmw_cyclonedds#184 rmw_cyclonedds#354 ros2cli#1168 kilted_tutorial_party#278
turtlebot4#145 turtlebot4#594 turtlebot4#601 rmw_zenoh#625 rmw_zenoh#688 zenoh#78 zenoh#2089
Fast-DDS#3053 Fast-DDS#4789 Fast-DDS#5158 Fast-DDS#5767 Fast-DDS#6062 Fast-DDS#6359 Fast-DDS#6383
mowglinext#606 rmw_fastrtps#640 rmw_fastrtps#750
rmw_fastrtps#842 rmw_fastrtps#392 rmw_fastrtps#706 ros2#1253 navigation2#6556
"""
QUESTIONS = _QUESTIONS.split()

#: What the entries are at least about, by a word that people search for.
SYMPTOMS = {
    "storm": "Discovery fills the Wi-Fi",
    "slow-start": "20 nodes",
    "server-worse": "A Discovery Server made it worse",
    "server-back": "The server came back",
    "roaming": "roaming",
    "no-multicast": "turn multicast off",
    "empty-list": "`ros2 topic list` shows nothing",
    "no-data": "Topics are listed, but no data come",
    "participant-index": "Failed to find a free participant index",
    "nav2": "Nav2 waits, or starves the other robot",
    "heartbeats": "idle robots use the CPU",
    "images": "Images and point clouds",
    "zenoh": "Which Zenoh configuration?",
    "network": "Corporate Wi-Fi, IGMP, client isolation, wrong interface",
    "vpn": "VPN",
    "docker": "Docker: topics are listed, and no data comes",
    "cable": "It works by cable",
    "mixed-rmw": "Cyclone DDS or Zenoh there",
    "localhost-peers": "`LOCALHOST` with static peers",
    "own-servers": "each with its own Discovery Server, and one laptop",
    "rviz-zenoh": "RViz on a laptop shows nothing with Zenoh",
    "nat": "VirtualBox NAT",
    "easy-mode": "Easy Mode",
    "hundred-processes": "more than 100 nodes",
    "cyclone-peers": "Cyclone DDS 11",
    "mtu": "large messages are lost",
    "large-data": "`LARGE_DATA` on a lossy Wi-Fi",
    "wifi-reboot": "After the Wi-Fi router rebooted",
    "zenoh-decay": "gets worse after weeks",
    "services": "client will not receive response",
    "collapse": "A release that collapses",
}
#: The entries that take twelve lines at most: they have no table.
SHORT = {
    "cable", "mixed-rmw", "localhost-peers", "own-servers", "rviz-zenoh", "nat", "easy-mode",
    "hundred-processes", "cyclone-peers", "mtu", "large-data", "wifi-reboot", "zenoh-decay",
    "collapse",
}  # fmt: skip
#: The groups of entries, in the order of the page.
GROUPS = ("symptom-nothing", "symptom-some", "symptom-slow", "symptom-lost")
#: The parts of an entry, in order.
PARTS = (
    "*Users ",
    "**Test.**",
    "**Meaning.**",
    "**Cure.**",
)
#: The entries for which the book has no number.
NUMBERLESS = {"empty-list", "no-data", "one-robot", "vpn", "docker", "capture"} | SHORT
#: What is not discovery at all.
NOT_DISCOVERY = {"storm", "images", "docker", "nav2"}


def entries() -> dict[str, str]:
    """Return the text of each entry, by its key."""
    page = re.sub(r"^\(symptom-\w+\)=\n## .+\n\n.+\n$", "", PAGE, flags=re.MULTILINE)
    parts = re.split(r"^\(wrong-([\w-]+)\)=$", page, flags=re.MULTILINE)
    return dict(zip(parts[1::2], parts[2::2], strict=True))


def run(code: str, names: dict[str, Any]) -> Any:
    """Run a cell, and return the value of its last line."""
    tree = ast.parse(code)
    last = tree.body.pop() if isinstance(tree.body[-1], ast.Expr) else None
    exec(compile(tree, "cell", "exec"), names)
    return last and eval(compile(ast.Expression(last.value), "cell", "eval"), names)


@cache
def outputs_of_entries() -> dict[str, str]:
    """Return what the cells of each entry show, by its key; and run those before the first."""
    names: dict[str, Any] = {}
    found = {}
    for key, text in {"": PAGE.partition("(wrong-")[0], **entries()}.items():
        cells = re.findall(r"```\{code-cell\} ipython3\n:tags: .*\n\n(.*?)```\n", text, re.DOTALL)
        values = [run(cell, names) for cell in cells]
        found[key] = "\n\n".join(value.data for value in values if isinstance(value, Markdown))
    return found


@cache
def chapter(label: str) -> str:
    """Return what a chapter says: its text, and what its cells show in words."""
    for path in sorted((ROOT / "notebooks").glob("*.ipynb")):
        text = path.read_text(encoding="utf-8")
        if f'"({label})=' in text:
            cells = json.loads(text)["cells"]
            data = (one.get("data", {}) for cell in cells for one in cell.get("outputs", []))
            said = ["".join(one.get("text/markdown", "")) for one in data]
            return "\n".join(
                ["".join(cell["source"]) for cell in cells if cell["cell_type"] == "markdown"]
                + said
            )
    raise AssertionError(label)


def test_no_question_is_lost() -> None:
    threads = read_data("field/threads.csv", "discostorm_book")
    found = [row["thread"].rpartition("/")[2] for row in threads]
    assert sorted(found) == sorted(QUESTIONS)
    for row in threads:
        name, _, number = row["thread"].partition("#")
        assert row["source"] == f"https://github.com/{name}/issues/{number}"
        assert f"[{row['thread']}]({row['source']})" in outputs_of_entries()[row["entry"]]


@pytest.mark.parametrize("key", SYMPTOMS)
def test_every_symptom_has_an_entry_with_its_words(key: str) -> None:
    assert SYMPTOMS[key].lower() in entries()[key].lower()


@pytest.mark.parametrize("key", entries())
def test_an_entry_has_all_its_parts_and_sources(key: str) -> None:
    text = entries()[key] + outputs_of_entries()[key]
    places = [text.find(part) for part in PARTS]
    assert -1 not in places
    assert places == sorted(places)
    meaning = text[places[2] : places[3]]
    assert ("\n\n| what you see | what it means |" in meaning) == (key not in SHORT)
    assert text.count("**The number.**") == (key not in NUMBERLESS)
    sources = [
        row for row in read_data("field/sources.csv", "discostorm_book") if row["entry"] == key
    ]
    assert sources
    assert all(row["source"] in outputs_of_entries()[key] for row in sources)


@pytest.mark.parametrize("key", sorted(SHORT))
def test_a_short_entry_has_twelve_lines_and_a_command(key: str) -> None:
    prose = re.sub(r"^```\{code-cell\}.*?^```$", "", entries()[key], flags=re.M | re.S)
    assert len([line for line in prose.splitlines() if line and line[:3] != "```"]) <= 12
    test = prose.partition("**Test.**")[2].partition("**Meaning.**")[0]
    assert re.search(r"`[^`]{5,}`", " ".join(test.split()))


def test_the_print_leaves_the_sources_to_the_html() -> None:
    tagged = re.findall(
        r"^:tags: \[remove-input, sources\]\n\nrelated_threads\(", PAGE, re.MULTILINE
    )
    assert len(tagged) == len(entries())


def test_five_lines_at_the_top_lead_to_the_groups() -> None:
    top = PAGE.partition("(symptom-")[0]
    lines = re.findall(r"^(\d)\. (.+(?:\n   .+)*)", top, re.MULTILINE)
    assert [int(number) for number, _ in lines] == [1, 2, 3, 4, 5]
    led = [link for _, line in lines for link in re.findall(r"\]\(#([\w-]+)\)", line)]
    groups = re.findall(r"^\((symptom-\w+)\)=\n## ", PAGE, re.MULTILINE)
    assert led == groups == list(GROUPS)
    # Entries are the headings below; none leads back to the contents.
    assert len(re.findall(r"^\(wrong-[\w-]+\)=\n### ", PAGE, re.MULTILINE)) == len(entries())
    assert ":backlinks: none" in top


def test_tables_know_the_entries_of_the_page_alone() -> None:
    for table in ("threads", "sources", "findings"):
        assert {
            row["entry"] for row in read_data(f"field/{table}.csv", "discostorm_book")
        } <= entries().keys()


@pytest.mark.parametrize("key", sorted(NOT_DISCOVERY))
def test_what_is_not_discovery_is_said(key: str) -> None:
    assert re.search(r"not discovery", entries()[key], re.IGNORECASE)


@pytest.mark.parametrize("key", sorted(entries().keys() - NUMBERLESS))
def test_numbers_are_those_of_the_chapter_that_is_linked(key: str) -> None:
    text = entries()[key] + outputs_of_entries()[key]
    paragraph = text.split("**The number.**")[1].split("\n\n")[0]
    labels = re.findall(r"<([\w-]+)>`", paragraph)
    prose = re.sub(r"\{numref\}`[^`]*`|`[^`]*`|Zenoh 1\.\d+", "", paragraph)
    numbers = re.findall(r"(?<![\w.-])\d[\d.,]*\d|(?<![\w.-])\d(?![\w-])", prose)
    if not labels:
        # Computed on the page, or another's.
        assert "of 1,500 bytes" in paragraph or "a user reported" in paragraph
        return
    known = "".join(map(chapter, labels))
    for number in numbers:
        assert re.search(rf"(?<![\d.]){re.escape(number)}(?![\d]|\.\d)", known), number


def test_commands_of_the_page_have_these_options() -> None:
    assert isinstance(main, click.Group)
    commands = re.findall(r"`(discostorm [^`]+)`|^(discostorm .+)$", PAGE, re.MULTILINE)
    assert len(commands) > 8
    for one in commands:
        name, *words = shlex.split(" ".join("".join(one).split()))[1:]
        command = main.get_command(click.Context(main), name)
        assert command is not None, name
        if words:  # else it is only named
            command.make_context(name, words)


def test_links_of_the_page_lead_somewhere() -> None:
    labels = {f"wrong-{key}" for key in entries()}
    assert set(re.findall(r"\]\(#(wrong-[\w-]+)\)", PAGE)) <= labels


def test_every_remedy_of_a_capture_has_an_entry() -> None:
    """Known remedies have one; a table of them that is there has no other."""
    findings = {
        row["remedy"]: row["entry"] for row in read_data("field/findings.csv", "discostorm_book")
    }
    assert len(findings) > 20
    if data_path("diagnosis/remedies.csv", "discostorm_capture").exists():
        assert findings.keys() == {
            row["remedy"] for row in read_data("diagnosis/remedies.csv", "discostorm_capture")
        }


@pytest.mark.parametrize("page", ["book/index.md", "book/calculator.md"])
def test_pages_link_to_it_at_their_top(page: str) -> None:
    text = (ROOT / page).read_text(encoding="utf-8")
    assert "(what_is_wrong.md)" in text
    assert text.index("(what_is_wrong.md)") < text.find("\n## ") % len(text)


def test_whoever_records_loses_nothing() -> None:
    (line,) = re.findall(r"^tcpdump .*$", PAGE, re.MULTILINE)
    assert line == TCPDUMP.format(file="discovery.pcap")


def test_help_names_it() -> None:
    assert "book/what_is_wrong" in (main.help or "")
    toc = (ROOT / "_toc.yml").read_text(encoding="utf-8")
    assert toc.index("book/what_is_wrong") < toc.index("Part I:")

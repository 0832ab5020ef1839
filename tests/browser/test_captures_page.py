"""The page on captures: lanes to touch, and what a reader's own capture says."""

import gzip
import json
import re
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner
from playwright.sync_api import Browser, Locator, Page, expect
from support import REFERENCE, ROOT
from test_interactive_figures import THEMES, data
from test_pages import AXE, BARRIERS, DESKTOP, show

import discostorm as ds
from discostorm.cli import main
from discostorm.data import data_path
from discostorm_book import capture_lanes
from discostorm_capture.cli.diagnosis_output import MAX_PRINTED_PAIRS

STATIC = ROOT / "book" / "_static"
PAGE = "00_captures"
FAILING = data_path("captures/cyclone_links_fail.pcap.xz", "discostorm_capture")
ILLS = REFERENCE / "captures" / "ills"
FILTERED = ILLS / "multicast_filtered-cyclone_dds_0_10.pcap.xz"

#: Drops a file on the box, as one does with the pointer.
DROP = """([text, name]) => {
    const files = new DataTransfer();
    files.items.add(new File([text], name));
    const box = document.querySelector(".own-drop");
    const options = { dataTransfer: files, bubbles: true, cancelable: true };
    for (const kind of ["dragover", "drop"]) box.dispatchEvent(new DragEvent(kind, options));
}"""


def command_output(capture: Path) -> str:
    """Return the command's output for a capture."""
    found = CliRunner().invoke(main, ["capture", str(capture), "--json"], catch_exceptions=False)
    return found.output


# ---- without a browser ----


def test_every_kind_of_message_says_what_it_does() -> None:
    paths = [
        *data_path("captures", "discostorm_capture").glob("*.xz"),
        *ROOT.glob("tests/reference/captures/**/*.pcap.xz"),
    ]
    kinds = {kind for path in paths for kind in ds.read_capture(path).messages()["kind"].unique()}
    assert len(kinds) > 20
    endings = tuple(capture_lanes.PURPOSES_BY_ENDING)
    assert {
        kind for kind in kinds - {*capture_lanes.PURPOSES} if not kind.endswith(endings)
    } == set()


def test_the_lanes_have_colors_of_the_palette() -> None:
    sheet = (STATIC / "palette.css").read_text(encoding="utf-8")
    for row in capture_lanes.lane_rows():
        assert sheet.count(f"{row['color']}:") == 2


def test_the_page_has_what_the_package_says_of_its_captures() -> None:
    page = data("lanes", ROOT / "notebooks" / f"{PAGE}.ipynb")
    assert [one["name"] for one in page["captures"]] == ["healthy", "failing links"]
    told = json.loads(json.dumps(ds.read_capture(FAILING).diagnosis().to_dict()))
    shown = page["captures"][1]["diagnosis"]
    assert shown["timeline"] == told["timeline"]
    assert shown["complete_s"] == told["complete_s"]


@pytest.mark.parametrize("path", sorted((STATIC / "captures").glob("*.js")), ids=lambda p: p.name)
def test_scripts_are_short_and_load_nothing(path: Path) -> None:
    text = path.read_text(encoding="utf-8")
    assert len(text.splitlines()) <= 300
    assert not re.search(r"https?://(?!www\.w3\.org/2000/svg)|\bfetch\b|XMLHttp|import ", text)


def test_they_weigh_little() -> None:
    files = (STATIC / "captures").iterdir()
    assert sum(len(gzip.compress(path.read_bytes(), 9)) for path in files) <= 15_000


# ---- in a browser ----


@pytest.fixture(scope="module")
def tab(open_tab: Callable[..., AbstractContextManager[Page]], book: Path) -> Iterator[Page]:
    with open_tab((book / "notebooks" / f"{PAGE}.html").as_uri(), DESKTOP) as page:
        yield page


@pytest.fixture
def own(tab: Page) -> Locator:
    tab.reload()
    return tab.locator(".own")


def lanes_of(box: Page | Locator, host: str) -> Locator:
    return box.get_by_role("slider", name=re.compile(rf"^Messages of {re.escape(host)},"))


def choose(own: Locator, content: str | bytes, name: str = "capture.json") -> None:
    given = content.encode() if isinstance(content, str) else content
    own.locator("input[type=file]").set_input_files(
        {"name": name, "mimeType": "application/json", "buffer": given}
    )


@pytest.mark.book
def test_arrow_keys_go_from_mark_to_mark_and_say_what_each_is(tab: Page) -> None:
    figure = tab.locator("#fig-capture-lanes")
    rows = ds.read_capture(FAILING).diagnosis().timeline()
    rows = rows[(rows["host"] == "10.77.0.2") & (rows["time_s"] <= 1.8)]
    lane = lanes_of(figure, "10.77.0.2").nth(1)
    assert lane.get_attribute("aria-label") == "Messages of 10.77.0.2, complete: 1.53 s"
    assert lane.get_attribute("aria-valuemax") == str(len(rows))
    lane.focus()
    for row in rows.head(8).to_dict("records"):
        tab.keyboard.press("ArrowRight")
        said = lane.get_attribute("aria-valuetext") or ""
        count = f"{row['messages']} × " if row["messages"] > 1 else ""
        assert said.startswith(f"{row['time_s']:.4f} s: {count}{row['kind']} from 10.77.0.2 to ")
        assert row["receiver"] in said
        assert f", {row['bytes']} bytes. {row['kind']} " in said
        expect(figure.locator(".lanes-told")).to_have_text(said)
    tab.keyboard.press("End")
    assert lane.get_attribute("aria-valuenow") == str(len(rows))
    tab.keyboard.press("Escape")
    expect(figure.locator(".lanes-told")).to_contain_text("Point at a mark")


@pytest.mark.book
def test_the_pointer_finds_the_mark_below_it(tab: Page) -> None:
    figure = tab.locator("#fig-capture-lanes")
    lane = lanes_of(figure, "10.77.0.1").first
    rows = (
        ds.read_capture(data_path("captures/cyclone_healthy.pcap.xz", "discostorm_capture"))
        .diagnosis()
        .timeline()
    )
    sedp = rows[(rows["host"] == "10.77.0.1") & (rows["kind"] == "SEDP")].iloc[0]
    lane.scroll_into_view_if_needed()
    box = lane.bounding_box()
    assert box is not None
    x = box["x"] + box["width"] * sedp["time_s"] / 1.8
    tab.mouse.move(x + 2, box["y"] + box["height"] / 2)
    expect(figure.locator(".lanes-told")).to_contain_text(f"{sedp['time_s']:.4f} s: ")
    expect(figure.locator(".lanes-told")).to_contain_text("SEDP announces an endpoint.")
    assert lane.get_attribute("aria-valuetext") == figure.locator(".lanes-told").inner_text()


@pytest.mark.book
def test_all_marks_stand_in_a_table_too(own: Locator) -> None:
    figure = own.page.locator("#fig-capture-lanes")
    figure.get_by_text("All messages as a table").click()
    page = data("lanes", ROOT / "notebooks" / f"{PAGE}.ipynb")
    many = sum(len(one["diagnosis"]["timeline"]["rows"]) for one in page["captures"])
    expect(figure.locator("tbody tr")).to_have_count(many)


@pytest.mark.book
@pytest.mark.parametrize("path", [FAILING, FILTERED], ids=["losses", "filtered"])
def test_a_file_of_the_command_is_told(own: Locator, path: Path) -> None:
    answer = json.loads(command_output(path))
    choose(own, json.dumps(answer))
    diagnosis = answer["diagnosis"]
    expect(own.locator(".told-answer")).to_have_text(diagnosis["summary"])
    expect(own.get_by_role("heading").first).to_be_focused()
    hosts = own.get_by_role("region", name="Hosts").locator("tbody tr")
    expect(hosts).to_have_count(len(diagnosis["hosts"]))
    for row, host in zip(hosts.all(), diagnosis["hosts"], strict=True):
        cells = row.locator("td").all_inner_texts()
        complete = host["knows_all_s"]
        assert cells[0] == host["host"]
        assert cells[5] == ("never" if complete is None else f"{complete:.2f}")
        assert cells[6:] == [str(host["sent"]), str(host["received"])]
        many = sum(row["host"] == host["host"] for row in diagnosis["timeline"]["rows"])
        lane = lanes_of(own, host["host"])
        own.get_by_label("Time shown").fill("24")
        assert lane.get_attribute("aria-valuemax") == str(many)
    pairs = own.get_by_role("region", name="Pairs that never completed").locator("tbody tr")
    expect(pairs).to_have_count(len(diagnosis["incomplete"]))
    for finding in diagnosis["findings"]:
        for piece in finding["paste"]:
            expect(own.locator("pre", has_text=piece["text"][:40]).first).to_be_attached()
    own.get_by_label("Show the healthy startup").check()
    expect(own.locator(".lanes-name")).to_have_text([Path(answer["file"]).name, "healthy"])


@pytest.mark.book
def test_many_pairs_are_listed_when_asked_for(own: Locator) -> None:
    answer = json.loads(command_output(FILTERED))
    answer["diagnosis"]["incomplete"] *= 5
    assert len(answer["diagnosis"]["incomplete"]) == 30 > MAX_PRINTED_PAIRS
    choose(own, json.dumps(answer))
    pairs = own.get_by_role("region", name="Pairs that never completed").locator("tbody tr")
    expect(pairs).to_have_count(MAX_PRINTED_PAIRS)
    own.get_by_role("button", name="Show all 30").click()
    expect(pairs).to_have_count(30)


def without(answer: str, key: str) -> str:
    """Return an answer whose diagnosis lacks something."""
    found = json.loads(answer)
    del found["diagnosis"][key]
    return json.dumps(found)


@pytest.mark.book
def test_wrong_files_are_refused_and_what_was_shown_stays(own: Locator) -> None:
    good = command_output(FAILING)
    wrong: list[tuple[Any, str]] = [
        (b"\xd4\xc3\xb2\xa1" + bytes(20), "It is the capture itself. Run discostorm capture x.bin"),
        (FAILING.read_bytes(), "It is the capture itself."),
        (b"\x0a\x0d\x0d\x0a" + bytes(20), "It is the capture itself."),
        ("", "It holds no JSON."),
        (good[:-10], "It holds no JSON."),
        ("[1, 2]", "It holds JSON, but no diagnosis."),
        ("null", "It holds JSON, but no diagnosis."),
        ('{"diagnosis": 1}', "Its diagnosis lacks what this page shows."),
        (without(good, "hosts"), "Its diagnosis lacks what this page shows."),
        (good.replace('"time_s": 0', '"time_s": "0', 1), "It holds no JSON."),
        (good.replace('"kind": "SPDP"', '"kind": 7', 1), "Its times of messages can't be read."),
    ]
    alert = own.get_by_role("alert")
    choose(own, wrong[0][0], "x.bin")
    expect(alert).to_contain_text(wrong[0][1])
    expect(alert).not_to_contain_text("Below is still")
    choose(own, good)
    expect(alert).to_have_text("")
    told = own.locator(".own-shown").inner_text()
    for content, said in wrong:
        choose(own, content, "x.bin")
        expect(alert).to_contain_text(f"x.bin: {said}")
        expect(alert).to_contain_text("Below is still the file that you chose before.")
        assert own.locator(".own-shown").inner_text() == told


@pytest.mark.book
def test_a_file_is_dropped_and_may_come_from_another_shell_or_version(own: Locator) -> None:
    good = command_output(FAILING)
    own.page.evaluate(DROP, [good, "capture.json"])
    expect(own.locator(".told-answer")).to_contain_text("many frames are lost")
    address = own.page.url
    choose(
        own, b"\xff\xfe" + command_output(FILTERED).encode("utf-16-le")
    )  # as PowerShell writes it
    expect(own.locator(".told-answer")).to_contain_text("either the network drops multicast")
    choose(own, without(good, "timeline"))
    expect(own).to_contain_text("Update discostorm and run the command once more.")
    expect(own.locator(".told-answer")).to_contain_text("many frames are lost")
    choose(own, good.replace("cyclone_links_fail", "<img src=x onerror=alert(1)>"))
    expect(own.get_by_role("heading").first).to_contain_text("<img src=x onerror=alert(1)>")
    assert own.page.url == address


@pytest.mark.book
def test_on_paper_and_without_scripts_the_picture_stands_there(
    browser: Browser, tab: Page, book: Path
) -> None:
    image = tab.locator("#fig-capture-lanes img")
    expect(image).to_be_hidden()
    tab.emulate_media(media="print")
    expect(image).to_be_visible()
    for name in (".lanes", ".own"):
        expect(tab.locator(name).first).to_be_hidden()
    tab.emulate_media(media="screen")
    with browser.new_context(java_script_enabled=False) as context:
        plain = context.new_page()
        plain.goto((book / "notebooks" / f"{PAGE}.html").as_uri())
        expect(plain.locator("#fig-capture-lanes img")).to_be_visible()
        expect(plain.locator(".own")).to_have_count(0)


@pytest.mark.book
def test_nothing_serious_keeps_anyone_out_of_captures(own: Locator) -> None:
    tab = own.page
    tab.evaluate(AXE)
    choose(own, command_output(FILTERED))
    tab.locator("#fig-capture-lanes").get_by_text("All messages as a table").click()
    choose_error = own.get_by_role("alert")
    choose(own, "no")
    expect(choose_error).to_contain_text("It holds no JSON.")
    for scheme, size in THEMES:
        show(tab, scheme, size)
        for part in (".own", "#fig-capture-lanes"):
            barriers = BARRIERS.replace("document,", f"document.querySelector('{part}'),")
            assert barriers != BARRIERS
            assert tab.evaluate(barriers, {}) == []
        assert tab.evaluate("document.documentElement.scrollWidth") == size["width"]

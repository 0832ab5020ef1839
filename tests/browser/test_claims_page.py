"""The ledger of claims in a browser: filters, sorting, a head that stays, cards on a phone."""

import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page
from test_pages import DESKTOP, PAGE_TEXT, PHONE

from discostorm_book.ledger import claims

pytestmark = pytest.mark.book

ROWS = ".tag_ledger tbody tr"
#: The texts of a column of the rows that are shown.
COLUMN = f"""(index) => [...document.querySelectorAll("{ROWS}")]
    .filter((row) => row.checkVisibility()).map((row) => row.cells[index].textContent.trim())"""

#: Takes back what a reader did: filters, order, folds and where one has scrolled to.
AS_IT_CAME = """async () => {
    document.querySelector(".ledger-filters").reset();
    await new Promise((resolve) => setTimeout(resolve, 50));
    document.querySelectorAll("details").forEach((details) => { details.open = false; });
    history.replaceState(null, "", location.pathname);
    scrollTo(0, 0);
}"""

#: What a reader sees first, first.
SEVERITY = ("fails", "weaker holds", "no test", "holds")


def by_severity() -> list[claims.Claim]:
    return sorted(claims.claims(), key=lambda claim: SEVERITY.index(claim.outcome()))


@pytest.fixture(scope="module")
def opened(browser: Browser, book: Path) -> Iterator[Page]:
    """Return the chapter, which takes seconds to come."""
    with browser.new_page(viewport=DESKTOP) as tab:
        (page,) = (book / "notebooks").glob("*_ledger.html")
        tab.goto(page.as_uri())
        tab.evaluate(PAGE_TEXT)
        yield tab


@pytest.fixture
def ledger(opened: Page) -> Page:
    """Return the chapter as it came: all claims, the severest first, no formal test open."""
    opened.set_viewport_size(DESKTOP)
    opened.evaluate(AS_IT_CAME)
    numbers = [int(number) for number in opened.evaluate(COLUMN, 0)]
    assert numbers == [claim.id for claim in by_severity()]
    return opened


def test_filters_leave_what_fits_all_of_them(ledger: Page) -> None:
    everything = claims.claims()
    assert len(ledger.evaluate(COLUMN, 0)) == len(everything)
    word = claims.VERDICTS["weaker holds"]["verdict"]
    ledger.get_by_role("button", name=word).click()
    qualified = [claim for claim in everything if claim.verdict() == word]
    assert [int(number) for number in ledger.evaluate(COLUMN, 0)] == [c.id for c in qualified]
    ledger.get_by_label(re.compile("^in the paper")).select_option("Fig. 3")
    here = [claim for claim in qualified if claim.where == "Fig. 3"]
    assert [int(number) for number in ledger.evaluate(COLUMN, 0)] == [c.id for c in here]
    assert 0 < len(here) < len(qualified)
    assert ledger.locator("output").inner_text() == f"{len(here)} of {len(everything)} rows"
    ledger.get_by_label("word").fill("no such word")
    assert ledger.evaluate(COLUMN, 0) == []
    ledger.get_by_role("button", name=word).click()
    ledger.get_by_label(re.compile("^in the paper")).select_option("")
    ledger.get_by_label("word").fill("s_rel")  # a symbol of the paper, which is typeset
    (keepalive,) = (claim for claim in everything if claim.key == "frame-keepalive")
    assert ledger.evaluate(COLUMN, 0) == [str(keepalive.id)]


def test_the_address_keeps_the_filter_and_a_link_to_a_part_shows_its_rows(
    ledger: Page, browser: Browser, book: Path
) -> None:
    word = claims.VERDICTS["weaker holds"]["verdict"]
    ledger.get_by_role("button", name=word).click()
    ledger.get_by_label(re.compile("^in the paper")).select_option("Fig. 2")
    ledger.get_by_label("word").fill("marginal")
    (page,) = (book / "notebooks").glob("*_ledger.html")
    assert str(ledger.evaluate("location.hash")) == "#verdict=qualified&where=Fig.+2&word=marginal"
    shown = ledger.evaluate(COLUMN, 0)
    assert len(shown) == 1
    with browser.new_page(viewport=DESKTOP) as tab:
        tab.goto(page.as_uri() + str(ledger.evaluate("location.hash")))
        assert tab.evaluate(COLUMN, 0) == shown
        assert tab.get_by_role("button", name=word).get_attribute("aria-pressed") == "true"
        tab.evaluate("location.hash = '#claims-hosts'")
        tab.wait_for_function(f"document.querySelectorAll('{ROWS}:not([hidden])').length > 1")
        part = [claim.id for claim in by_severity() if claim.section == "hosts"]
        assert [int(number) for number in tab.evaluate(COLUMN, 0)] == part
        # A row that the filter hides is shown to whoever follows a link to it.
        tab.evaluate("location.hash = '#claim-1'")
        tab.locator("#claim-1").wait_for(state="visible")


def test_the_ledger_needs_no_sideways_scroll(ledger: Page) -> None:
    ledger.set_viewport_size({"width": 1024, "height": 768})
    ledger.evaluate(PAGE_TEXT)
    assert ledger.evaluate("document.documentElement.scrollWidth") <= 1024
    table = ledger.locator(".tag_ledger table").bounding_box()
    assert table is not None
    assert table["x"] + table["width"] <= 1024


def test_enter_sorts_once_and_equals_keep_their_order(ledger: Page) -> None:
    verdicts = [claim.verdict() for claim in claims.claims()]
    ledger.locator(".tag_ledger thead button", has_text="verdict").focus()
    ledger.keyboard.press("Enter")
    numbers = [int(number) for number in ledger.evaluate(COLUMN, 0)]
    groups: dict[str, list[int]] = {}
    for number in numbers:
        groups.setdefault(verdicts[number - 1], []).append(number)
    assert [number for group in groups.values() for number in group] == numbers
    assert all(group == sorted(group) for group in groups.values())
    assert ledger.locator("th[aria-sort]").get_attribute("aria-sort") == "ascending"
    ledger.keyboard.press("Enter")
    backwards = [int(number) for number in ledger.evaluate(COLUMN, 0)]
    assert backwards == [number for group in reversed(groups.values()) for number in group]


def test_the_head_stays_in_sight(ledger: Page) -> None:
    ledger.locator(ROWS).nth(60).scroll_into_view_if_needed()
    ledger.mouse.wheel(0, 300)
    ledger.evaluate(PAGE_TEXT)
    box = ledger.locator(".tag_ledger thead th").first.bounding_box()
    assert box is not None
    assert 0 <= box["y"] < 120
    # Rows that pass below it do not shine through.
    ground = "(head) => getComputedStyle(head).backgroundColor"
    assert ledger.locator(".tag_ledger thead th").first.evaluate(ground).startswith("rgb(")


def test_a_claim_is_a_card_on_a_phone(ledger: Page) -> None:
    ledger.set_viewport_size(PHONE)
    ledger.evaluate(PAGE_TEXT)
    boxes = [cell.bounding_box() for cell in ledger.locator(f"{ROWS}:first-child td").all()]
    tops = [box["y"] for box in boxes if box]
    assert tops == sorted(set(tops))  # one below the other
    assert all(box and box["x"] + box["width"] <= PHONE["width"] for box in boxes)
    # Cards have no heads to sort them by: a select does it, by keyboard, too, and says how.
    ledger.get_by_label("sort by").focus()
    ledger.keyboard.press("v")
    sorted_by_select = ledger.evaluate(COLUMN, 0)
    assert ledger.locator("th[aria-sort=ascending]").inner_text() == "verdict"
    ledger.keyboard.press("Tab")
    ledger.keyboard.press("Enter")
    verdicts = [claim.verdict() for claim in claims.claims()]
    groups: dict[str, list[str]] = {}
    for number in sorted_by_select:
        groups.setdefault(verdicts[int(number) - 1], []).append(number)
    assert len(groups) == len(set(verdicts))
    assert all(group == sorted(group, key=int) for group in groups.values())
    backwards = [number for group in reversed(groups.values()) for number in group]
    assert ledger.evaluate(COLUMN, 0) == backwards
    assert ledger.locator(".ledger-sort button").inner_text() == "\u2193 descending"


def test_a_phone_shows_some_cards_until_it_is_asked_for_all(browser: Browser, book: Path) -> None:
    (page,) = (book / "notebooks").glob("*_ledger.html")
    shown = ".tag_ledger tbody tr:visible"
    with browser.new_page(viewport=PHONE) as tab:
        tab.goto(page.as_uri())
        everything = len(claims.claims())
        assert 1 < tab.locator(shown).count() < 10
        tab.get_by_role("button", name=f"Show all {everything}").click()
        assert tab.locator(shown).count() == everything
        tab.goto(f"{page.as_uri()}#claim-{everything}")
        tab.reload()
        assert tab.locator(f"#claim-{everything}").is_visible()


def test_the_number_of_a_claim_leads_to_its_formal_test(ledger: Page) -> None:
    assert not ledger.locator("#test-17").is_visible()
    ledger.locator(f"{ROWS} td a", has_text="17").first.click()
    ledger.locator("#test-17").wait_for(state="visible")


def test_every_claim_says_in_which_cell_it_is_decided(ledger: Page) -> None:
    links = ledger.locator(
        f"{ROWS} a", has_text=re.compile("^(computed|simulated|measured|more) here$")
    ).count()
    assert links == sum(bool(claim.link) for claim in claims.claims())

"""The PDF that `make pdf` made last: A4, no blank pages, vectors, numbered as the HTML."""

import re
import subprocess
import sys
from importlib import import_module
from types import SimpleNamespace

import pytest
import yaml
from bs4 import BeautifulSoup, SoupStrainer
from docutils import nodes
from pypdf import PdfReader
from support import BUILD, ROOT, book_sources, newest_modification_time, skip_or_fail
from test_pages import PAGES, source

import discostorm as ds

sys.path[:0] = [str(ROOT / folder) for folder in ("scripts", "book/_ext")]
check_pdf, printed = import_module("check_pdf"), import_module("printed")

pytestmark = pytest.mark.book

PDF = ROOT / "build" / "discostorm.pdf"
CHEAT_SHEET = ROOT / "build" / "cheat_sheet.pdf"
#: Where LaTeX says which number and page a label got.
LABELS = ROOT / "_build" / "latex" / "discostorm.aux"
LABEL = re.compile(r"\\newlabel\{equation:([\w/]+):([\w-]+)\}\{\{(.*?)\}\{(\d+)\}")


@pytest.fixture(scope="module")
def pdf() -> PdfReader:
    if not (PDF.exists() and LABELS.exists()):
        skip_or_fail("no PDF here: run `make pdf`")
    if PDF.stat().st_mtime < newest_modification_time(book_sources()):
        skip_or_fail("the PDF is older than its sources: run `make pdf`")
    return PdfReader(PDF)


@pytest.fixture(scope="module")
def text(pdf: PdfReader) -> list[str]:
    words: list[str] = check_pdf.page_texts(PDF)
    assert len(words) == len(pdf.pages)
    return words


def printed_equations() -> dict[tuple[str, str], tuple[str, str]]:
    """Return number and printed page of each equation, by its page in the HTML and its label.

    One that carries the paper's number has it in braces, as amsmath writes a tag.
    """
    lines = LABELS.read_text(encoding="utf-8")
    return {(m[1], m[2]): (m[3].strip("{}"), m[4]) for m in LABEL.finditer(lines)}


def test_pages_are_a4_and_none_is_blank(pdf: PdfReader, text: list[str]) -> None:
    sizes = {(round(float(p.mediabox.width)), round(float(p.mediabox.height))) for p in pdf.pages}
    assert sizes == {(595, 842)}
    assert len(text) > 100
    # A head and a foot alone have fewer letters.
    bare = [n for n, words in enumerate(text) if len("".join(words.split())) < 120]
    assert bare == [0]  # the title page


def test_the_title_page_has_the_date_of_the_release_not_of_the_build(text: list[str]) -> None:
    released = yaml.safe_load((ROOT / "CITATION.cff").read_text(encoding="utf-8"))["date-released"]
    day = released.strftime("%B %d, %Y").replace(" 0", " ")
    assert day in " ".join(text[0].split())


def test_each_part_begins_on_the_page_of_its_first_chapter(text: list[str]) -> None:
    parts = [match[1] for words in text if (match := re.search(r"^Part [IV]+: (.+)$", words, re.M))]
    contents = yaml.safe_load((ROOT / "_toc.yml").read_text(encoding="utf-8"))["parts"]
    captions = [part["caption"] for part in contents if "caption" in part]
    assert parts == [caption.rpartition(": ")[2] for caption in captions]


def test_the_book_is_no_longer_than_it_may_be(pdf: PdfReader) -> None:
    headings = [(page, title) for page, title in check_pdf.headings(pdf, pdf.outline) if page]
    begins = {re.sub(r"^\d+ ", "", title): page for page, title in headings}
    looked_up = (
        (begins["Cheat sheet: discovery on Wi-Fi"] - begins["What is wrong with my robots?"])
        + (begins["Enumeration"] - begins["Ledger"])
        + (len(pdf.pages) - begins["References"])
    )
    assert begins["Enumeration"] - begins["Ledger"] <= 7  # a page that explains, six of rows
    assert looked_up <= 40
    assert len(pdf.pages) - looked_up <= 120


def test_bookmarks_of_chapters_have_their_numbers(pdf: PdfReader) -> None:
    titles = [title for _, title in check_pdf.headings(pdf, pdf.outline)]
    numbers = [int(found[1]) for title in titles if (found := re.match(r"(\d+) ", title))]
    contents = yaml.safe_load((ROOT / "_toc.yml").read_text(encoding="utf-8"))["parts"]
    chapters = sum(len(part["chapters"]) for part in contents if part.get("numbered"))
    assert numbers == list(range(1, chapters + 1))


def test_the_title_page_says_version_and_commit(text: list[str]) -> None:
    title = yaml.safe_load((ROOT / "_config.yml").read_text(encoding="utf-8"))["title"]
    assert "".join(title.split()) in "".join(text[0].split())
    assert re.search(rf"{re.escape(ds.__version__)} \([0-9a-f]{{8}}(-dirty)?\)", text[0])


def test_nothing_runs_off_a_page_and_none_is_all_but_empty(pdf: PdfReader, text: list[str]) -> None:
    log = LABELS.with_suffix(".log").read_text(encoding="utf-8", errors="replace")
    assert not check_pdf.overfull_boxes(log)
    assert not check_pdf.missing_characters(log)
    assert not check_pdf.pages_with_gaps(pdf, check_pdf.filled_shares(PDF))
    assert not check_pdf.nearly_empty_pages(pdf, text)
    assert not check_pdf.stranded_headings(pdf, check_pdf.page_texts(PDF, "-layout"))


def test_what_does_not_fit_is_found(pdf: PdfReader, text: list[str]) -> None:
    log = (
        "Overfull \\hbox (4.9pt too wide) in paragraph at lines 1--2\n[]small\n"
        "Overfull \\hbox (48.2pt too wide) in paragraph at lines 3--4\n[]ledger\n"
        "LaTeX Warning: Float too large for page by 12.0pt on input line 5.\n\n"
        "Missing character: There is no → in font FreeMono!\n"
        "LaTeX Warning: Reference `nowhere' on page 7 undefined on input line 9.\n"
    )
    assert [line[:15] for line in check_pdf.missing_characters(log)] == [
        "LaTeX Warning: ",
        "Missing charact",
    ]
    assert [line.split(" pt")[0] for line in check_pdf.overfull_boxes(log)] == ["48.2", "12.0"]
    begins = check_pdf.first_pages(pdf)
    before_a_figure = next(
        number
        for number, page in enumerate(pdf.pages[1:])
        if check_pdf.is_drawn_on(page) and number + 1 not in begins
    )
    shares = [1.0] * len(pdf.pages)
    assert not check_pdf.pages_with_gaps(pdf, shares)
    shares[before_a_figure] = 0.4
    assert [line.split()[1] for line in check_pdf.pages_with_gaps(pdf, shares)] == [
        str(before_a_figure + 1)
    ]
    inside = next(
        number
        for number, page in enumerate(pdf.pages)
        if number > 0 and number not in begins and not check_pdf.is_drawn_on(page)
    )
    few = [*text[:inside], "head\n\nfour\nlines\nare\nleft\n\nfoot\n", *text[inside + 1 :]]
    assert check_pdf.nearly_empty_pages(pdf, few) == [
        f"page {inside + 1} of the file has only 4 lines"
    ]
    *_, (page, title) = check_pdf.headings(pdf, pdf.outline[-3:])
    text = check_pdf.page_texts(PDF, "-layout")
    running = text[-2].strip().splitlines()[0]
    last = f"7.2 {title}"
    ends = f"{running}\n\nwords\n\n{last}\n\n7. A section      9\n"
    worse = [*text[:page], ends, *text[page + 1 :]]
    assert check_pdf.stranded_headings(pdf, worse) == [
        f"page {page + 1} of the file ends with {last!r}"
    ]


def test_exercises_are_answered_and_no_reference_is_open(text: list[str]) -> None:
    whole = "\n".join(text)
    assert len(re.findall(r"^Answer$", whole, re.MULTILINE)) > 10
    assert "Show the solution" not in whole
    assert "??" not in whole


def test_the_cheat_sheet_is_one_page_with_what_it_promises() -> None:
    if not CHEAT_SHEET.exists():
        skip_or_fail("no cheat sheet here: run `make pdf`")
    (page,) = check_pdf.page_texts(CHEAT_SHEET)
    words = " ".join(page.split())
    for promised in ("Fast DDS", "Zenoh", "A Discovery Server", "tcpdump -i", "calculator.html"):
        assert promised in words


@pytest.mark.parametrize("address", ["", "https://example.org/book/"])
def test_chapters_lead_to_their_page(address: str) -> None:
    app = SimpleNamespace(config=SimpleNamespace(html_baseurl=address))
    link = printed._link(app, "notebooks/03_hosts").astext()  # type: ignore[arg-type]
    if address:
        assert r"\qrcode[height=1.6cm]{https://example.org/book/notebooks/03_hosts.html}" in link
    else:
        assert "html/notebooks/03_hosts.html" in link
        assert "qrcode" not in link


def table(*rows: tuple[str, ...]) -> nodes.table:
    """Return a table, the first row of which is its head, in the section of a chapter."""
    head, *body = (
        nodes.row("", *(nodes.entry("", nodes.paragraph("", cell)) for cell in row)) for row in rows
    )
    group = nodes.tgroup("", *(nodes.colspec() for _ in rows[0]), cols=len(rows[0]))
    group += [nodes.thead("", head), nodes.tbody("", *body)]
    made = nodes.table("", group)
    nodes.section("", nodes.title("", "A heading"), nodes.paragraph("", "Numbers:"), made)
    return made


def test_a_table_breaks_where_two_rows_are_left_and_begins_with_its_announcement() -> None:
    made = table(("a", "b"), *((str(number), "") for number in range(7)))
    section = made.parent
    printed._fit(made)
    raw = [each.astext() for each in section.findall(nodes.raw)]
    assert [text.startswith(r"\noalign{\nobreak}") for text in raw].count(True) == 3
    room, announcement = section[1], section[2]
    assert room.astext().startswith(r"\roomfor{")
    assert announcement.astext() == "Numbers:"
    # An empty paragraph in a cell would be a second line of its row.
    assert [len(entry) for entry in made.findall(nodes.entry)][-1] == 0


def test_a_long_text_is_printed_once_and_a_figure_leaves_no_heading_alone() -> None:
    long, short = "\n".join("abcdefghijklmnop"), "one line"
    blocks = [nodes.literal_block(text, text) for text in (long, short, long, short)]
    tree = nodes.section("", nodes.title("", "A heading"), nodes.figure("", nodes.image()), *blocks)
    section = nodes.section("", tree)
    printed._say_once(tree)
    assert [block.astext() for block in tree.findall(nodes.literal_block)] == [long, short, short]
    label = re.search(r"\\label\{([\w-]+)\}", tree.astext())
    assert label
    assert rf"As on page \pageref{{{label[1]}}}." in tree.astext()
    # A figure comes first after the heading and may move: the text below takes the heading along.
    printed._keep(blocks[0], 50)
    assert section[0].astext().startswith(r"\settlefigures\roomfor{95pt}")


def test_a_wide_table_has_its_narrow_columns_in_pairs() -> None:
    sentence = "words " * 100
    made = table(("no.", "where", "verdict", "by", "says"), ("1", "Sec. I", "yes", "us", sentence))
    printed._fit(made)
    cells = [[each.astext() for each in entry] for entry in made.findall(nodes.entry)]
    assert cells[:3] == [["no.", "where"], ["verdict", "by"], ["says"]]
    assert [cell[-2:] for cell in cells[3:]] == [["1", "Sec. I"], ["yes", "us"], [sentence]]


def test_figures_are_described(pdf: PdfReader) -> None:
    assert pdf.trailer["/Root"]["/Lang"] == "en"
    alternative = re.compile(rb"/Span\s*<<\s*/Alt\s*<FEFF([0-9A-F]*)>\s*>>\s*BDC", re.IGNORECASE)
    told = []
    for page in pdf.pages:
        contents = page.get_contents()
        drawn = b"" if contents is None else contents.get_data()
        told += [bytes.fromhex(each.decode()) for each in alternative.findall(drawn)]
        assert len(alternative.findall(drawn)) == drawn.count(b"EMC")
    assert len(told) == sum(len(source(page)[1]) for page in PAGES)
    assert min(len(each.decode("utf-16-be")) for each in told) > 30


def test_figures_are_vectors(pdf: PdfReader) -> None:
    images = subprocess.run(["pdfimages", "-list", PDF], capture_output=True, text=True, check=True)
    assert len(images.stdout.splitlines()) == 2, "pixels, below two lines of a head"
    drawn = 0
    for page in pdf.pages:
        drawings = page["/Resources"].get("/XObject") or {}  # type: ignore[union-attr]
        drawn += sum(thing.get_object()["/Subtype"] == "/Form" for thing in drawings.values())
    assert drawn == sum(len(source(page)[1]) for page in PAGES)


def test_equations_are_numbered_as_in_the_html(pdf: PdfReader, text: list[str]) -> None:
    if not (BUILD / "html").exists():
        skip_or_fail("no HTML here: run `make book`")
    shown = {}
    for page in PAGES:
        html = BeautifulSoup(
            (BUILD / "html" / f"{page}.html").read_text(encoding="utf-8"),
            "html.parser",
            parse_only=SoupStrainer("div", id=re.compile("^equation-")),
        )
        for equation in html.select("div.math[id^=equation-]"):
            number = equation.select_one(".eqno")
            assert number is not None
            label = str(equation["id"]).removeprefix("equation-")
            shown[page, label] = number.get_text().strip("()\N{PILCROW SIGN}# ")
    printed = printed_equations()
    assert len(shown) > 50
    assert {label: number for label, (number, _) in printed.items()} == shown
    pages = dict(zip(pdf.page_labels, text, strict=True))
    assert not {n for n, page in printed.values() if f"({n})" not in pages[page]}

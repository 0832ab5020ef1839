"""Check the book's PDF: nothing runs off a page, nothing is missing, no page is almost empty."""

import argparse
import re
import subprocess
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from pypdf import PageObject, PdfReader
from pypdf.generic import Destination

#: Width by which a box may visibly exceed its column [pt].
MAX_OVERFULL_PT = 5.0
#: Minimum number of lines on a page, without head and foot.
MIN_LINES_OF_PAGE = 5
#: Heights of a page's header and footer, which empty pages also have, as shares of the page.
HEAD, FOOT = 0.09, 0.91
OVERFULL_BOX = re.compile(
    r"(?:Overfull \\[hv]box \(|Float too large for page by )([\d.]+)pt([^\n]*)\n([^\n]*)"
)
#: Patterns of LaTeX's log: a letter missing from a font, and an undefined reference.
MISSING_CHARACTER = re.compile(
    r"Missing character: .*|LaTeX Warning: (?:Reference|Citation) .* undefined.*"
)


def overfull_boxes(log: str) -> list[str]:
    """Return LaTeX's warnings about boxes that are too wide or too high."""
    return [
        f"{float(points):.1f} pt{where}: {text.strip()[:90]}"
        for points, where, text in OVERFULL_BOX.findall(log)
        if float(points) > MAX_OVERFULL_PT
    ]


def missing_characters(log: str) -> list[str]:
    """Return LaTeX's warnings about missing letters and undefined references."""
    return sorted(set(MISSING_CHARACTER.findall(log)))


def page_texts(pdf: Path, *options: str) -> list[str]:
    """Return the text of each page."""
    command = ["pdftotext", *options, str(pdf), "-"]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    return done.stdout.split("\f")[:-1]


def filled_shares(pdf: Path) -> list[float]:
    """Return the printed share of each page's height."""
    done = subprocess.run(
        ["pdftoppm", "-r", "18", "-gray", str(pdf)], capture_output=True, check=True
    )
    shares = []
    data = done.stdout
    while data:
        # A PGM file: P5, width and height, 255, then a byte for each pixel; page after page.
        head = re.match(rb"P5\s(\d+)\s(\d+)\s255\s", data)
        assert head, "pdftoppm has written something else than PGM"
        width, height = int(head[1]), int(head[2])
        start, end = head.end(), head.end() + width * height
        rows = np.frombuffer(data[start:end], np.uint8).reshape(height, width).min(axis=1)
        first, last = round(HEAD * height), round(FOOT * height)
        ink = [row for row in range(first, last) if rows[row] < 200]
        shares.append((ink[-1] - first) / (last - first) if ink else 0.0)
        data = data[end:]
    return shares


def first_pages(reader: PdfReader) -> set[int]:
    """Return the first page of each part or chapter, counted from 0."""
    found: set[int] = set()
    for entry in reader.outline:
        for each in entry if isinstance(entry, list) else [entry]:
            if isinstance(each, Destination):
                page = reader.get_destination_page_number(each)
                found |= {page} if page is not None else set()
    return found


def is_drawn_on(page: PageObject) -> bool:
    """Return whether a page has a figure."""
    things = page.get("/Resources", {}).get("/XObject") or {}
    return any(thing.get_object()["/Subtype"] == "/Form" for thing in things.values())


def pages_with_gaps(reader: PdfReader, shares: list[float]) -> list[str]:
    """Return the pages that a figure leaves half empty: a figure there or on the next page."""
    begins = first_pages(reader) | {len(shares)}
    drawn = [is_drawn_on(page) for page in reader.pages]
    return [
        f"page {page + 1} of the file is only {share:.0%} full, because of a figure"
        for page, share in enumerate(shares)
        if share < 0.5 and page + 1 not in begins and (drawn[page] or drawn[page + 1])
    ]


def nearly_empty_pages(reader: PdfReader, texts: list[str]) -> list[str]:
    """Return the pages with only a few lines, except title pages."""
    begins = first_pages(reader) | {0}
    pages = [text.strip().splitlines() for text in texts]
    lines = [sum(map(bool, map(str.strip, page))) - 2 for page in pages]  # without head and foot
    return [
        f"page {page + 1} of the file has only {max(0, count)} lines"
        for page, count in enumerate(lines)
        if count < MIN_LINES_OF_PAGE and page not in begins and not is_drawn_on(reader.pages[page])
    ]


def headings(reader: PdfReader, outline: list[Any]) -> Iterator[tuple[int | None, str]]:
    """Yield page, counted from 0, and title of each heading in the outline."""
    for entry in outline:
        if isinstance(entry, list):
            yield from headings(reader, entry)
        else:
            yield reader.get_destination_page_number(entry), entry.title or ""


def stranded_headings(reader: PdfReader, texts: list[str]) -> list[str]:
    """Return the headings at the bottom of a page.

    Pass the texts of ``words(pdf, "-layout")``, whose lines come in the order of the page.
    """
    titles = {(page, "".join(title.split())) for page, title in headings(reader, reader.outline)}
    pages = [list(filter(None, map(str.strip, text.splitlines()))) for text in texts]
    ((head, _),) = Counter(lines[0] for lines in pages if lines).most_common(1)
    found = []
    for number, lines in enumerate(pages):
        # The last line holds the page number and the section's name.
        body = lines[1:-1] if lines[:1] == [head] else lines[:-1]
        last = "".join(body[-1].split()) if body else ""
        # A heading is "3.5 Words".
        is_title = {(number, last), (number, re.sub(r"^[\d.]*\d", "", last))} & titles
        if is_title and len(body) > 1:
            found.append(f"page {number + 1} of the file ends with {body[-1]!r}")
    return found


def main() -> None:
    """Check the PDF and its LaTeX log."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("pdf", type=Path, help="the file, with LaTeX's log beside it")
    parser.add_argument("--pages", type=int, help="how many pages there may be at most")
    arguments = parser.parse_args()
    pdf = arguments.pdf
    reader = PdfReader(pdf)
    log = pdf.with_suffix(".log").read_text(encoding="utf-8", errors="replace")
    texts = page_texts(pdf)
    wrong = (
        overfull_boxes(log) + missing_characters(log) + pages_with_gaps(reader, filled_shares(pdf))
    )
    wrong += nearly_empty_pages(reader, texts) + stranded_headings(
        reader, page_texts(pdf, "-layout")
    )
    if arguments.pages and len(reader.pages) > arguments.pages:
        wrong.append(f"{len(reader.pages)} pages; at most {arguments.pages} are wanted")
    if wrong:
        raise SystemExit("\n".join([f"discostorm: {pdf} does not fit its pages:", *wrong]))


if __name__ == "__main__":
    main()

"""The printed edition: in parts, without what is folded, with tables that fit."""

import math
import re
from pathlib import Path

import matplotlib
from docutils import nodes
from sphinx.addnodes import desc, start_of_file, tabular_col_spec, toctree
from sphinx.application import Sphinx
from sphinx.config import Config
from sphinx.environment import BuildEnvironment

from discostorm import wording

#: The page that is a document of its own, too.
CHEAT_SHEET = "book/cheat_sheet"
#: The page of which print has its beginning only: the rest says how to use what is there.
_CALCULATOR = "book/calculator"
#: How the names of pages that open a part begin: the HTML edition has no more to them.
_OPENING = "book/part_"
#: Points: the measure of an A4 page, and what a column adds to its text.
_MEASURE = 446.0
_GAP = 12.0
#: Size of type in a table [pt], from what is read well to what still is, and its command.
_SIZES = ((10.0, r"\normalsize"), (9.0, r"\small"), (8.0, r"\footnotesize"))
#: Width of a letter, on average, as a share of the size of its type: in tables, and in paragraphs,
#: of which those in lists are indented [pt].
_LETTER, _PROSE_LETTER, _INDENT = 0.51, 0.38, 25.0
#: Letters of a table's longest cells from which on it is read in small type only, with its first
#: columns in one if no cell of them has more than so many.
_TOWERS, _NARROW = 480, 26
#: Letters beyond which more room makes a column no shorter than the table is.
_SENTENCE = 100
#: Points: what is kept on one page of a table, what the rules of a row take, and those of a table.
_TOGETHER, _RULES, _AROUND = 120.0, 4.0, 36.0
#: Where a long word of a table may be broken, and what such a word is.
_BREAK, _LONG = "\N{ZERO WIDTH SPACE}", re.compile(r"\S{20,}")
#: Where text is as it is.
_NO_TEXT = (nodes.literal, nodes.literal_block, nodes.raw, nodes.math, nodes.math_block)
#: Sections that the contents need not name.
_IN_EVERY_CHAPTER = ("Exercise", "Exercises", "The answer")
#: Percent of a figure's size on the screen, in which its letters are no larger than the text's.
_SCALE = 78
#: Points that a line of code takes, and the frame around it; lines of it that stay together.
_CODE_LINE, _CODE_FRAME, _CODE_LINES = 9.8, 20.0, 7
#: What stands between blocks and is not seen.
_UNSEEN = (nodes.Invisible, nodes.raw)
#: Points that a heading takes, those with the lines that are to follow it, and those of a chapter's
#: last section that begins where it ends.
_HEADING, _BEGINNING, _ENDING = 45.0, 80.0, 160.0
#: Lines that the print shows of an output that is folded, such as a long file.
_LINES = 20
_MORE = "The HTML edition adds data, sources, code, further tables, and figures to try"
_TOOL = "The calculator is a page of the HTML edition"


def _latex(text: str) -> nodes.raw:
    return nodes.raw("", text, format="latex")


def _cells(chapter: nodes.Node) -> list[nodes.container]:
    found = chapter.findall(nodes.container)
    return [cell for cell in found if cell.get("nb_element") == "cell_code"]


def _leave_out_what_is_folded(chapter: start_of_file) -> None:
    """Take folded code from a chapter, and the tables in a fold; keep figures and equations.

    A table stays if a line announces it, or if its cell has the tag "printed".
    """
    for cell in _cells(chapter):
        if "tag_facts" in cell["classes"] and not _is_announced(cell):
            cell.parent.remove(cell)  # what the text below states
        elif "tag_sources" in cell["classes"]:
            cell.parent.remove(cell)  # who asked, and where it is written
        elif cell.get("hide_mode") in {"input", "all"}:
            source = cell.children[0]
            if isinstance(source, nodes.Element) and source.get("nb_element") == "cell_code_source":
                cell.remove(source)
            kept = _is_announced(cell) or next(cell.findall(_is_numbered), None)
            kept = kept or "tag_printed" in cell["classes"]
            if cell["hide_mode"] == "all" and not kept:
                cell.children = []
            if not cell.children:
                cell.parent.remove(cell)
        elif cell.get("hide_mode") == "output":
            for output in cell.findall(nodes.literal_block):
                _shorten(output)


def _number_the_ledger(chapter: nodes.Node) -> None:
    """Print the rows of the ledger as numbered paragraphs, each verdict above its rows."""
    for cell in _cells(chapter):
        if "tag_ledger" not in cell["classes"]:
            continue
        (table,) = cell.findall(nodes.table)
        printed: list[nodes.Node] = [_latex(r"\begingroup\footnotesize\parskip2pt" + "\n")]
        above = ""
        for row in next(table.findall(nodes.tbody)).children:
            for reference in row.findall(nodes.reference):
                _name_the_page(reference)
            number, verdict, place, said, decided = (_inline(entry) for entry in row.children)
            words = "".join(node.astext() for node in verdict)
            if words != above:
                above, (sign, _, name) = words, words.partition(" ")
                printed += [_latex(rf"\roomfor{{{_BEGINNING:.0f}pt}}" + "\n")]
                printed += [nodes.paragraph("", f"{sign} ", nodes.strong("", name))]
            parts = [nodes.strong("", "", *number), nodes.Text(" "), *said]
            parts += [nodes.Text(" ("), *place, nodes.Text("; ") if decided else nodes.Text("")]
            printed.append(nodes.paragraph("", "", *parts, *decided, nodes.Text(")")))
        table.replace_self([*printed, _latex(r"\endgroup" + "\n")])


def _name_the_page(reference: nodes.reference) -> None:
    """Let a link that says "here" name the page to which it leads."""
    words, label = reference.astext(), reference.get("refuri", "").lstrip("%").replace("#", ":")
    if words.endswith(" here"):
        page = _latex(rf"\pageref{{\detokenize{{{label}}}}}")
        reference.children = []
        reference += [nodes.Text(f"{words.removesuffix('here')}on page\N{NO-BREAK SPACE}"), page]


def _leave_out_how_to_use_it(page: nodes.section) -> None:
    for section in [node for node in page.children if isinstance(node, nodes.section)]:
        page.remove(section)


def _inline(entry: nodes.Node) -> list[nodes.Node]:
    """Return what is in the paragraph of a cell."""
    return [node for paragraph in entry.children for node in paragraph.children]


def _leave_out_what_python_prints(chapter: start_of_file) -> None:
    """Take the sections that describe names of the library, and their entries of an index."""
    for section in list(chapter.findall(nodes.section))[1:]:
        if next(section.findall(desc), None):
            section.parent.remove(section)


def _is_numbered(node: nodes.Node) -> bool:
    return isinstance(node, nodes.figure | nodes.math_block)


def _shorten(block: nodes.literal_block) -> None:
    """Leave the first lines of a long text, and say how many there were."""
    lines = block.astext().splitlines()
    if len(lines) > 2 * _LINES:
        rest = f"... and {len(lines) - _LINES} more lines, in the HTML edition"
        block.children = [nodes.Text("\n".join([*lines[:_LINES], rest]))]
        block.rawsource = block.astext()


def _link(app: Sphinx, name: str, text: str = _MORE) -> nodes.raw:
    """Return the line that leads to a page of the HTML: by a code if that has an address."""
    page = f"{name}.html"
    address = app.config.html_baseurl.rstrip("/")
    if not address:
        where = rf"\href{{html/{page}}}{{\nolinkurl{{html/{page}}}}}"
        return _latex(rf"{{\footnotesize\noindent {text}: {where} in the release.\par}}" + "\n\n")
    url = f"{address}/{page}"
    return _latex(
        rf"{{\footnotesize\noindent\begin{{minipage}}{{1.9cm}}\qrcode[height=1.6cm]{{{url}}}"
        rf"\end{{minipage}}\begin{{minipage}}{{\dimexpr\linewidth-2cm}}\raggedright {text}:\\"
        rf"\url{{{url}}}\end{{minipage}}\par\medskip}}" + "\n\n"
    )


def _breakable(word: re.Match[str]) -> str:
    return re.sub(r"(?<=[_/:.])(?=\w)", _BREAK, word[0])


def _seen(node: nodes.Node) -> str:
    """Return a text, of a formula about as many letters as are seen."""
    text = node.astext()
    return re.sub(r"\\[a-zA-Z]+\s?|[{}^_$]", "", text) if "\\" in text or "_{" in text else text


def _letters(entry: nodes.entry) -> int:
    """Return how many letters the longest paragraph of a cell has."""
    return max((len(_seen(each)) for each in entry.children), default=0)


def _longest_word(entry: nodes.entry) -> int:
    """Return how many letters the longest word of a cell has; a formula is a word."""
    formulas = [_seen(each) for each in entry.findall(nodes.math)]
    return max(map(len, formulas or re.split(rf"[ \n{_BREAK}]", entry.astext())))


def _shared(rows: list[list[nodes.entry]], size: float) -> list[float] | None:
    """Return a width for each column [pt], or nothing if the longest words do not fit.

    What these leave goes to the columns by the share of their longest cells.
    """
    columns = list(zip(*rows, strict=True))
    # The type of heads is wider.
    least = [max(map(_longest_word, column)) + 2 for column in columns]
    more = [
        max(0, min(max(map(_letters, column)), _SENTENCE) + 1 - word)
        for column, word in zip(columns, least, strict=True)
    ]
    left = (_MEASURE - _GAP * len(columns)) / (_LETTER * size) - sum(least)
    if left < 0:
        return None
    share = min(1.0, left / max(1, sum(more)))
    return [
        _LETTER * size * (word + share * letters) for word, letters in zip(least, more, strict=True)
    ]


def _height(row: list[nodes.entry], widths: list[float], size: float) -> float:
    """Return about how high a row is [pt]."""
    lines = (
        sum(math.ceil((len(_seen(e)) or 1) * _LETTER * size / width) for e in entry.children)
        for entry, width in zip(row, widths, strict=True)
    )
    return 1.2 * size * max(lines) + _RULES


def _rows(table: nodes.table) -> list[list[nodes.entry]]:
    return [list(row.findall(nodes.entry)) for row in table.findall(nodes.row)]


def _stack(table: nodes.table, letters: list[int]) -> None:
    """Put the narrow columns with which a table begins into half as many, two lines each."""
    rows = _rows(table)
    narrow = next((n for n, most in enumerate(letters) if most > _NARROW), len(letters))
    (group,) = table.findall(nodes.tgroup)
    for row in [*rows, list(group.findall(nodes.colspec))]:
        for upper, lower in zip(row[: narrow // 2 * 2 : 2], row[1:narrow:2], strict=True):
            upper += lower.children
            lower.parent.remove(lower)
    group["cols"] -= narrow // 2


def _keep_its_ends(table: nodes.table) -> None:
    """Break a table across pages only where two rows or more are left on either."""
    (body,) = table.findall(nodes.tbody)
    for number, row in enumerate(body.findall(nodes.row)):
        if number == 1 or number >= len(body) - 2:
            row[0].insert(0, _latex(r"\noalign{\nobreak}"))


def _fit(table: nodes.table, sizes: tuple[tuple[float, str], ...] = _SIZES) -> None:
    """Give a table columns that fit the page, in smaller type if they must, and room to begin."""
    for entry in table.findall(nodes.entry):
        if not entry.astext() and not next(entry.findall(nodes.target), None):
            entry.children = []  # an empty paragraph would be a line of its own
    for text in list(table.findall(nodes.Text)):
        if not isinstance(text.parent, nodes.math):
            text.parent.replace(text, nodes.Text(_LONG.sub(_breakable, text)))
    letters = [max(map(_letters, column)) for column in zip(*_rows(table), strict=True)]
    if sum(letters) > _TOWERS:
        sizes = _SIZES[-1:]
        _stack(table, letters)
    rows = _rows(table)
    right = [
        any("text-right" in e.get("classes", ()) for e in column)
        for column in zip(*rows, strict=True)
    ]
    for size, command in sizes:
        widths = _shared(rows, size)
        if widths is None:
            continue
        heights = [_height(row, widths, size) for row in rows]
        _keep(table, _AROUND + sum(heights if sum(heights) < _TOGETHER else heights[:4]))
        _keep_its_ends(table)
        spec = "".join(
            rf">{{\ragged{'left' if is_right else 'right'}\arraybackslash}}p{{{width:.1f}pt}}"
            for width, is_right in zip(widths, right, strict=True)
        )
        table["classes"].append("longtable")
        parent = table.parent
        at = parent.index(table)
        parent.insert(at + 1, _latex(r"\endgroup" + "\n"))
        parent.insert(at, tabular_col_spec(spec=spec))
        parent.insert(at, _latex(rf"\begingroup{command}" + "\n"))
        return
    raise ValueError(f"a table is too wide for a page: {table.astext()[:80]!r}")


def _keep(block: nodes.Element, room: float) -> None:
    """Begin a block, and the heading and the line that announce it, where there is room [pt]."""
    while True:
        around = block.parent
        ahead = around[: around.index(block)]
        before = next((n for n in reversed(ahead) if not _is_elsewhere(n)), None)
        if before is None and isinstance(around, nodes.container):
            block = around
        elif isinstance(before, nodes.title) and isinstance(around.parent, nodes.section):
            block, room = around, room + _HEADING
        elif isinstance(before, nodes.rubric):
            block, room = before, room + _HEADING
        elif isinstance(before, nodes.paragraph) and _announces(before):
            block, room = before, room + _natural_height(before)
        else:
            break
    # Figures that wait come before a section begins, and take of the room.
    first = r"\settlefigures" if isinstance(block, nodes.section) else ""
    begin = _latex(rf"{first}\roomfor{{{room:.0f}pt}}" + "\n")
    block.parent.insert(block.parent.index(block), begin)


def _is_elsewhere(node: nodes.Node) -> bool:
    """Return whether there is nothing to see where a node stands: figures may move."""
    if isinstance(node, nodes.Text | nodes.image):
        return False
    return isinstance(node, (*_UNSEEN, nodes.figure)) or all(map(_is_elsewhere, node.children))


def _keep_headings(chapter: nodes.section) -> None:
    """Begin each section where there is room for its heading and a few lines.

    A figure that comes first may move, so that LaTeX would leave the heading alone.
    """
    for section in list(chapter.findall(nodes.section)):
        if section is not chapter:
            begin = _latex(rf"\roomfor{{{_BEGINNING:.0f}pt}}" + "\n")
            section.parent.insert(section.parent.index(section), begin)


def _is_announced(cell: nodes.Element) -> bool:
    """Return whether the paragraph before a cell ends with a colon."""
    ahead = cell.parent[: cell.parent.index(cell)]
    before = next((node for node in reversed(ahead) if not _is_elsewhere(node)), None)
    return isinstance(before, nodes.paragraph) and _announces(before)


def _announces(paragraph: nodes.paragraph) -> bool:
    """Return whether a paragraph is nothing without what follows: a label, or words and a colon."""
    is_label = len(paragraph) == 1 and isinstance(paragraph[0], nodes.strong)
    return is_label or paragraph.astext().endswith(":")


def _natural_height(paragraph: nodes.paragraph) -> float:
    measure = _MEASURE - (0 if isinstance(paragraph.parent, nodes.section) else _INDENT)
    return 12 * math.ceil(_PROSE_LETTER * 10 * len(paragraph.astext()) / measure) + 6


def _say_once(tree: nodes.document) -> None:
    """Print a long text, such as a configuration, where it comes first, and refer to it later."""
    first: dict[str, str] = {}
    for block in list(tree.findall(nodes.literal_block)):
        text = block.astext().strip()
        if text.count("\n") < _CODE_LINES:
            continue
        if label := first.get(text):
            block.replace_self(_latex(rf"As on page \pageref{{{label}}}." + "\n\n"))
        else:
            first[text] = f"text-{len(first)}"
            begin = _latex(rf"\phantomsection\label{{{first[text]}}}" + "\n")
            block.parent.insert(block.parent.index(block), begin)


def _describe_and_scale(figure: nodes.figure) -> None:
    """Give a figure letters as small as the text's, and its alternative text to who reads aloud."""
    for image in list(figure.findall(nodes.image)):
        image["scale"] = _SCALE
        told = image.get("alt", "").encode("utf-16-be").hex().upper()
        at = figure.index(image)
        figure.insert(at + 1, _latex(r"\special{pdf:literal direct EMC}"))
        alternative = rf"\special{{pdf:literal direct /Span <</Alt <FEFF{told}>>> BDC}}"
        figure.insert(at, _latex(alternative))


def _keep_the_beginning(block: nodes.literal_block) -> None:
    """Begin a block of code where there is room for it, or, if it is long, for a part of it."""
    lines = block.astext().rstrip().count("\n") + 1
    _keep(block, _CODE_LINE * min(lines, _CODE_LINES) + _CODE_FRAME)


def _keep_the_end_together(chapter: nodes.Element) -> None:
    """Begin the last section of a chapter where there is room for it, if it is short and text."""
    section = next(chapter.findall(nodes.section))
    if not isinstance(section[-1], nodes.section):
        return
    section = section[-1]
    room = _HEADING + sum(map(_natural_height, section.findall(nodes.paragraph)))
    if room < _ENDING and not next(section.findall(_is_no_text), None):
        # LaTeX would begin no section in the last tenth of a page.
        begin = rf"\settlefigures\roomfor{{{room:.0f}pt}}\def\bottomtitlespace{{0pt}}"
        section.parent.insert(section.parent.index(section), _latex(begin + "\n"))
        section += _latex(r"\def\bottomtitlespace{.1\textheight}" + "\n")


def _is_no_text(node: nodes.Node) -> bool:
    return isinstance(node, nodes.table | nodes.figure | nodes.literal_block)


def _shorten_the_contents(chapter: nodes.Element) -> None:
    """Leave the sections with which every chapter ends out of the contents; bookmarks have them."""
    for section in list(chapter.findall(nodes.section)):
        if section[0].astext() in _IN_EVERY_CHAPTER:
            section.parent.insert(section.parent.index(section), _depth(0))
    chapter += _depth(1)


def _depth(level: int) -> nodes.raw:
    """Set down to which level the contents list what follows."""
    return _latex(rf"\addtocontents{{toc}}{{\protect\setcounter{{tocdepth}}{{{level}}}}}" + "\n")


def _leave_out_what_pages_carry(tree: nodes.document) -> None:
    """Take out what only a page can carry: links to data, and what its scripts read."""
    for cell in _cells(tree):
        carried = [
            output
            for output in cell.findall(nodes.literal_block)
            if "tag_page-data" in cell["classes"]
            or output.astext().startswith(("Data of this figure", "Data of this table"))
        ]
        for output in carried:
            output.parent.remove(output)
        if carried and not cell.astext().strip():
            cell.parent.remove(cell)


def _end_paragraphs(tree: nodes.document) -> None:
    """End the paragraph before an anchor: LaTeX would let the next one run on."""
    for anchor in list(tree.findall(nodes.target)):
        if isinstance(anchor.parent, nodes.section):
            anchor.parent.insert(anchor.parent.index(anchor), _latex(r"\par" + "\n"))


def _stand_alone(app: Sphinx, tree: nodes.document) -> None:
    """Make the cheat sheet a document of its own: what it refers to is in the HTML edition."""
    for reference in list(tree.findall(nodes.reference)):
        if reference.get("internal"):
            reference.replace_self(nodes.inline("", reference.astext()))
    next(tree.findall(nodes.section)).append(_link(app, _CALCULATOR, _TOOL))


def _arrange(app: Sphinx, tree: nodes.document, name: str) -> None:
    """Make the landing page a preface, the contents' captions parts, numbers those of the HTML."""
    if app.builder.name != "latex":
        return
    _leave_out_what_pages_carry(tree)
    _end_paragraphs(tree)
    chapters = {node["docname"]: node for node in tree.findall(start_of_file)}
    for chapter in chapters.values():
        _leave_out_what_is_folded(chapter)
        _leave_out_what_python_prints(chapter)
        _number_the_ledger(chapter)
    _say_once(tree)
    sheet = list(chapters[CHEAT_SHEET].findall(nodes.table)) if chapters else []
    for figure in tree.findall(nodes.figure):
        _describe_and_scale(figure)
    for block in list(tree.findall(nodes.literal_block)):
        _keep_the_beginning(block)
    for text in list(tree.findall(nodes.Text)):
        if not isinstance(text.parent, _NO_TEXT):
            text.parent.replace(text, nodes.Text(wording.no_break_spaces(text)))
    for table in list(tree.findall(nodes.table)):
        _fit(table, _SIZES[2:] if table in sheet else _SIZES)
    if name != app.config.root_doc:
        _stand_alone(app, tree)
        return
    for chapter_name, chapter in chapters.items():
        chapter.parent.remove(chapter)
        _keep_the_end_together(chapter)
        _shorten_the_contents(chapter)
        section = next(chapter.findall(nodes.section))
        if chapter_name == _CALCULATOR:
            _leave_out_how_to_use_it(section)
            section.insert(1, _link(app, chapter_name, _TOOL))
        elif app.config.html_baseurl and not chapter_name.startswith(_OPENING):
            section.insert(1, _link(app, chapter_name))
        _keep_headings(section)
        if chapter_name == CHEAT_SHEET:
            section.insert(1, _latex(r"\begingroup\small" + "\n"))
            section += _latex(r"\endgroup" + "\n")
    landing = next(tree.findall(nodes.section))
    title, *text = landing.children
    landing.children = []
    landing += [title, _latex(r"\setcounter{secnumdepth}{-1}")]
    preface = nodes.section("", nodes.title("", "Preface"), *text, ids=["preface"])
    preface.insert(1, _link(app, name))
    landing += preface
    for contents in app.env.get_doctree(name).findall(toctree):
        caption = (contents["caption"] or "").rpartition(": ")[2]
        depth = 2 if contents["numbered"] else -1
        part = rf"\part{{{caption}}}" if caption else ""
        landing += _latex(rf"\setcounter{{secnumdepth}}{{{depth}}}{part}")
        entries = [chapters[chapter] for _, chapter in contents["entries"]]
        for chapter in entries:
            chapter.insert(0, _latex(r"\runon" + "\n"))
        landing += entries


def _add_the_cheat_sheet(app: Sphinx, env: BuildEnvironment) -> list[str]:
    """Name the second document now, as Jupyter Book takes one only from the settings."""
    if app.builder.name == "latex":
        title, author = env.titles[CHEAT_SHEET].astext(), app.config.author
        sheet = (CHEAT_SHEET, f"{Path(CHEAT_SHEET).name}.tex", title, author, "howto", False)
        app.config.latex_documents = [*app.config.latex_documents, sheet]
    return []


def _add_the_fonts(app: Sphinx, config: Config) -> None:
    """Put the typeface of code, which the figures' Matplotlib brings, where LaTeX finds it."""
    fonts = sorted(Path(matplotlib.get_data_path(), "fonts/ttf").glob("DejaVuSansMono*.ttf"))
    config.latex_additional_files = [*config.latex_additional_files, *map(str, fonts)]


def setup(app: Sphinx) -> dict[str, bool]:
    """Connect to Sphinx."""
    app.connect("config-inited", _add_the_fonts)
    app.connect("env-updated", _add_the_cheat_sheet)
    app.connect("doctree-resolved", _arrange)
    return {"parallel_read_safe": True, "parallel_write_safe": True}

"""The printed edition: in parts, without what is folded, solutions last, tables that fit."""

import math
import re
from pathlib import Path

from docutils import nodes
from sphinx.addnodes import start_of_file, tabular_col_spec, toctree
from sphinx.application import Sphinx
from sphinx.environment import BuildEnvironment

#: The page that is a document of its own, too.
CHEAT_SHEET = "book/cheat_sheet"
#: Points: the measure of an A4 page, and what a column adds to its text.
_MEASURE = 446.0
_GAP = 12.0
#: Size of type in a table [pt], from what is read well to what still is, and its command.
_SIZES = ((10.0, r"\normalsize"), (9.0, r"\small"), (8.0, r"\footnotesize"))
#: Measures that a table would have if no line of it were broken: more is read in small type only,
#: and with its first columns in one if all that stands in them is at most so wide [pt].
_TOWERS, _NARROW = 4.5, 110.0
#: Points: what is kept on one page of a table, and what the rules of a row take.
_TOGETHER, _RULES = 230.0, 4.0
#: Where a long word of a table may be broken, and what such a word is.
_BREAK, _LONG = "\N{ZERO WIDTH SPACE}", re.compile(r"\S{20,}")
_SOLUTION = "Show the solution"
#: Lines that the print shows of an output that is folded, such as a long file.
_LINES = 20
_MORE = "In the HTML edition figures carry their data, code unfolds, and what can be tried is tried"


def _latex(text: str) -> nodes.raw:
    return nodes.raw("", text, format="latex")


def _cells(chapter: nodes.Node) -> list[nodes.container]:
    found = chapter.findall(nodes.container)
    return [cell for cell in found if cell.get("nb_element") == "cell_code"]


def _leave_out_what_is_folded(chapter: start_of_file) -> list[nodes.container]:
    """Take folded code from a chapter, keep what it shows; return the solutions, in order."""
    solutions = []
    for cell in _cells(chapter):
        if cell.get("prompt_show") == _SOLUTION:
            solutions.append(cell)
            label = f"solution-{chapter['docname'].replace('/', '-')}"
            cell.replace_self(_latex(rf"\emph{{Solution on page \pageref{{{label}}}.}}" + "\n\n"))
        elif cell.get("hide_mode") in {"input", "all"}:
            source = cell.children[0]
            if isinstance(source, nodes.Element) and source.get("nb_element") == "cell_code_source":
                cell.remove(source)
            if not cell.children:
                cell.parent.remove(cell)
        elif cell.get("hide_mode") == "output":
            for output in cell.findall(nodes.literal_block):
                _shorten(output)
    return solutions


def _shorten(block: nodes.literal_block) -> None:
    """Leave the first lines of a long text, and say how many there were."""
    lines = block.astext().splitlines()
    if len(lines) > 2 * _LINES:
        rest = f"... and {len(lines) - _LINES} more lines, in the HTML edition"
        block.children = [nodes.Text("\n".join([*lines[:_LINES], rest]))]
        block.rawsource = block.astext()


def _solutions(app: Sphinx, by_chapter: dict[str, list[nodes.container]]) -> nodes.section:
    """Return a chapter of solutions, a section for each chapter that has exercises."""
    last = nodes.section("", nodes.title("", "Solutions"), ids=["solutions"])
    for name, cells in by_chapter.items():
        number = ".".join(map(str, app.env.toc_secnumbers.get(name, {}).get("", ())))
        title = f"{number} {app.env.titles[name].astext()}".strip()
        label = f"solution-{name.replace('/', '-')}"
        section = nodes.section("", nodes.title("", title), ids=[f"{label}-section"])
        section += _latex(rf"\phantomsection\label{{{label}}}" + "\n")
        for count, cell in enumerate(cells, 1):
            if len(cells) > 1:
                section += nodes.paragraph("", "", nodes.strong("", f"Solution {count}"))
            section += cell
        last += section
    return last


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


def _width(text: str, size: float, *, is_code: bool) -> float:
    """Return roughly how wide a line is [pt]: letters of Times are half as wide as it is high."""
    if is_code:
        return 0.62 * size * len(text)
    capitals = sum(letter.isupper() for letter in text)
    return size * (0.5 * len(text) + 0.25 * capitals)


def _breakable(word: re.Match[str]) -> str:
    return re.sub(r"(?<=[_/:.])(?=\w)", _BREAK, word[0])


def _least(entry: nodes.entry, size: float) -> float:
    """Return how wide the longest word of a cell is [pt]; a formula is a word."""
    if entry.get("stacked"):
        return _natural(entry, size)
    is_code = any(True for _ in entry.findall(nodes.literal))
    # Code is broken at some signs, too.
    words = re.split(
        rf"[\s{_BREAK}]|(?<=[.,;?!/])" if is_code else rf"[\s{_BREAK}]", entry.astext()
    )
    formulas = [_formula(each.astext()) for each in entry.findall(nodes.math)]
    if formulas:
        words = formulas
    return max((_width(word, size, is_code=is_code) for word in words), default=0.0)


def _natural(entry: nodes.entry, size: float) -> float:
    """Return how wide a cell is on one line [pt], or each of those that were put together."""
    is_code = any(True for _ in entry.findall(nodes.literal))
    lines = [each.astext() for each in entry.children] if entry.get("stacked") else [entry.astext()]
    return max(_width(_formula(line), size, is_code=is_code) for line in lines)


def _formula(tex: str) -> str:
    """Return about as many letters as are seen of a formula."""
    return re.sub(r"\\[a-zA-Z]+\s?|[{}^_$]", "", tex) if "\\" in tex or "_{" in tex else tex


def _lines(row: list[nodes.entry], widths: list[float], size: float) -> list[float]:
    """Return how many lines each cell of a row takes, not in whole ones where it is broken."""
    return [
        max(len(entry.children) if entry.get("stacked") else 1, _natural(entry, size) / width)
        for entry, width in zip(row, widths, strict=True)
    ]


def _shared(rows: list[list[nodes.entry]], size: float) -> list[float] | None:
    """Return a width for each column [pt], or nothing if the longest words do not fit."""
    columns = list(zip(*rows, strict=True))
    widths = [max(_least(entry, size) for entry in column) + 2 for column in columns]
    left = _MEASURE - _GAP * len(columns) - sum(widths)
    if left < 0:
        return None
    full = [max(_natural(entry, size) for entry in column) + 2 for column in columns]
    if sum(full) - sum(widths) <= left:
        return full

    def height(widths: list[float]) -> tuple[float, float]:
        # Not in whole lines: a little more width that saves none yet is a step towards it.
        lines = [_lines(row, widths, size) for row in rows]
        return sum(map(max, lines)), sum(map(sum, lines))

    # What is left goes, a little at a time, to the column that makes the table shortest by it.
    step = left / 40
    for _ in range(40):
        wider = [[w + step * (i == j) for j, w in enumerate(widths)] for i in range(len(columns))]
        widths = min(wider, key=height)
    return widths


def _rows(table: nodes.table) -> list[list[nodes.entry]]:
    return [list(row.findall(nodes.entry)) for row in table.findall(nodes.row)]


def _stack(table: nodes.table, size: float) -> None:
    """Put the narrow columns with which a table begins into one, a line each."""
    rows = _rows(table)
    columns = zip(*rows, strict=True)
    widths = [max(_natural(entry, size) for entry in column) for column in columns]
    narrow = next((n for n, width in enumerate(widths) if width > _NARROW), len(widths))
    for row in rows if narrow > 1 else []:
        row[0]["stacked"] = True
        for entry in row[1:narrow]:
            row[0] += entry.children
            entry.parent.remove(entry)
    (group,) = table.findall(nodes.tgroup)
    for spec in list(group.findall(nodes.colspec))[1:narrow]:
        group.remove(spec)
    group["cols"] -= max(0, narrow - 1)


def _fit(table: nodes.table) -> None:
    """Give a table columns that fit the page, in smaller type if they must, and room to begin."""
    for text in list(table.findall(nodes.Text)):
        if not isinstance(text.parent, nodes.math):
            text.parent.replace(text, nodes.Text(_LONG.sub(_breakable, text)))
    sizes: tuple[tuple[float, str], ...] = _SIZES
    small, _ = _SIZES[-1]
    unbroken = sum(
        max(_natural(e, small) for e in column) for column in zip(*_rows(table), strict=True)
    )
    if unbroken > _TOWERS * _MEASURE:
        sizes = _SIZES[-1:]
        _stack(table, small)
    rows = _rows(table)
    right = [
        any("text-right" in e.get("classes", ()) for e in column)
        for column in zip(*rows, strict=True)
    ]
    for size, command in sizes:
        widths = _shared(rows, size)
        if widths is None:
            continue
        heights = [1.2 * size * math.ceil(max(_lines(row, widths, size))) + _RULES for row in rows]
        _keep(table, sum(heights) if sum(heights) < _TOGETHER else sum(heights[:4]))
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


def _keep(table: nodes.table, room: float) -> None:
    """Begin a table, and the line that announces it, where there is room for it [pt]."""
    block: nodes.Element = table
    while isinstance(block.parent, nodes.container) and block.parent.index(block) == 0:
        block = block.parent
    around = block.parent
    at = around.index(block)
    before = around[at - 1] if at else None
    if isinstance(before, nodes.paragraph) and before.astext().endswith(":"):
        at -= 1
        room += 30
    around.insert(at, _latex(rf"\roomfor{{{min(room, _TOGETHER + 30):.0f}pt}}" + "\n"))


def _keep_the_end_together(chapter: nodes.Element) -> None:
    """Keep the last paragraphs and lists of a chapter from leaving a line alone on a page."""
    section = next(chapter.findall(nodes.section))
    while isinstance(section[-1], nodes.section):
        section = section[-1]
    at = len(section)
    while at > 1 and isinstance(section[at - 1], nodes.paragraph | nodes.bullet_list):
        at -= 1
    if 1 < at < len(section):  # a heading stays with what follows it
        section.insert(at, _latex(r"\begin{together}" + "\n"))
        section += _latex("\\end{together}\n")


def _leave_out_what_pages_carry(tree: nodes.document) -> None:
    """Take out what only a page can carry: links to a figure's data, and what its scripts read."""
    for cell in _cells(tree):
        outputs = list(cell.findall(nodes.literal_block))
        carried = [
            output
            for output in outputs
            if "tag_page-data" in cell["classes"] or output.astext().startswith("Data of this ")
        ]
        for output in carried:
            output.parent.remove(output)
        if carried and not cell.astext().strip():
            cell.parent.remove(cell)


def _stand_alone(app: Sphinx, tree: nodes.document) -> None:
    """Make the cheat sheet a document of its own: what it refers to is in the HTML edition."""
    for reference in list(tree.findall(nodes.reference)):
        if reference.get("internal"):
            reference.replace_self(nodes.inline("", reference.astext()))
    page = "book/calculator"
    next(tree.findall(nodes.section)).append(
        _link(app, page, "The calculator is a page of the HTML edition")
    )


def _arrange(app: Sphinx, tree: nodes.document, name: str) -> None:
    """Make the landing page a preface, the contents' captions parts, numbers those of the HTML."""
    if app.builder.name != "latex":
        return
    _leave_out_what_pages_carry(tree)
    for table in list(tree.findall(nodes.table)):
        _fit(table)
    if name != app.config.root_doc:
        _stand_alone(app, tree)
        return
    chapters = {node["docname"]: node for node in tree.findall(start_of_file)}
    solutions = {}
    for chapter_name, chapter in chapters.items():
        chapter.parent.remove(chapter)
        if found := _leave_out_what_is_folded(chapter):
            solutions[chapter_name] = found
        _keep_the_end_together(chapter)
        next(chapter.findall(nodes.section)).insert(1, _link(app, chapter_name))
    landing = next(tree.findall(nodes.section))
    title, *text = landing.children
    landing.children = []
    landing += [title, _latex(r"\setcounter{secnumdepth}{-1}")]
    preface = nodes.section("", nodes.title("", "Preface"), *text, ids=["preface"])
    preface.insert(1, _link(app, name))
    landing += preface
    for contents in app.env.get_doctree(name).findall(toctree):
        number, _, caption = (contents["caption"] or "").rpartition(": ")
        depth = 2 if number else -1
        part = rf"\part{{{caption}}}" if caption else ""
        landing += _latex(rf"\setcounter{{secnumdepth}}{{{depth}}}{part}")
        landing += [chapters[chapter] for _, chapter in contents["entries"]]
    if solutions:
        landing += _solutions(app, solutions)


def _add_the_cheat_sheet(app: Sphinx, env: BuildEnvironment) -> list[str]:
    """Name the second document now, as Jupyter Book takes one only from the settings."""
    if app.builder.name == "latex":
        title, author = env.titles[CHEAT_SHEET].astext(), app.config.author
        sheet = (CHEAT_SHEET, f"{Path(CHEAT_SHEET).name}.tex", title, author, "howto", False)
        app.config.latex_documents = [*app.config.latex_documents, sheet]
    return []


def setup(app: Sphinx) -> dict[str, bool]:
    """Connect to Sphinx."""
    app.connect("env-updated", _add_the_cheat_sheet)
    app.connect("doctree-resolved", _arrange)
    return {"parallel_read_safe": True, "parallel_write_safe": True}

"""The printed edition: in parts, without what is folded, solutions last, tables that fit."""

import re
from pathlib import Path

from docutils import nodes
from sphinx.addnodes import start_of_file, tabular_col_spec, toctree
from sphinx.application import Sphinx
from sphinx.environment import BuildEnvironment

#: The page that is a document of its own, too.
CHEAT_SHEET = "book/cheat_sheet"
#: Points: the measure of an A4 page, upright and turned, and what a column adds to its text.
_UPRIGHT, _TURNED = 446.0, 680.0
_GAP = 12.0
#: Size of type in a table [pt], from what is read well to what still is, and its command.
_SIZES = ((10.0, r"\normalsize"), (9.0, r"\small"), (8.0, r"\footnotesize"))
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
        return _latex(rf"{{\footnotesize\noindent {text}: {where} of the release.\par}}" + "\n\n")
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


def _least(entry: nodes.entry, size: float) -> float:
    """Return how wide the longest word of a cell is [pt]; a formula is a word."""
    is_code = any(True for _ in entry.findall(nodes.literal))
    # Code is broken at some signs, too.
    words = re.split(r"(?<=[\s.,;?!/])", entry.astext()) if is_code else entry.astext().split()
    formulas = [_formula(each.astext()) for each in entry.findall(nodes.math)]
    if formulas:
        words = formulas
    return max((_width(word, size, is_code=is_code) for word in words), default=0.0)


def _natural(entry: nodes.entry, size: float) -> float:
    """Return how wide a cell is on one line [pt]."""
    is_code = any(True for _ in entry.findall(nodes.literal))
    return _width(_formula(entry.astext()), size, is_code=is_code)


def _formula(tex: str) -> str:
    """Return about as many letters as are seen of a formula."""
    return re.sub(r"\\[a-zA-Z]+\s?|[{}^_$]", "", tex) if "\\" in tex or "_{" in tex else tex


def _shared(rows: list[list[nodes.entry]], size: float, measure: float) -> list[float] | None:
    """Return a width for each column [pt], or nothing if the longest words do not fit."""
    count = len(rows[0])
    widths = [max(_least(row[i], size) for row in rows) + 2 for i in range(count)]
    natural = [[_natural(entry, size) + 2 for entry in row] for row in rows]
    left = measure - _GAP * count - sum(widths)
    if left < 0:
        return None
    full = [max(row[i] for row in natural) for i in range(count)]
    if sum(full) - sum(widths) <= left:
        return full

    def height(widths: list[float]) -> tuple[float, float]:
        # Not in whole lines: a little more width that saves none yet is a step towards it.
        lines = [[max(1, n / w) for n, w in zip(row, widths, strict=True)] for row in natural]
        return sum(map(max, lines)), sum(map(sum, lines))

    # What is left goes, a little at a time, to the column that makes the table shortest by it.
    step = left / 40
    for _ in range(40):
        wider = [[w + step * (i == j) for j, w in enumerate(widths)] for i in range(count)]
        widths = min(wider, key=height)
    return widths


def _fit(table: nodes.table) -> None:
    """Give a table columns that fit the page, smaller type or a turned page if they must."""
    rows = [list(row.findall(nodes.entry)) for row in table.findall(nodes.row)]
    right = [
        any("text-right" in e.get("classes", ()) for e in column)
        for column in zip(*rows, strict=True)
    ]
    for measure in (_UPRIGHT, _TURNED):
        for size, command in _SIZES:
            widths = _shared(rows, size, measure)
            # What would be a tower of words is better turned.
            most = sum(
                max(_natural(entry, size) for entry in column) for column in zip(*rows, strict=True)
            )
            if widths is None or (measure == _UPRIGHT and most > 4.5 * _UPRIGHT):
                continue
            spec = "".join(
                rf">{{\ragged{'left' if is_right else 'right'}\arraybackslash}}p{{{width:.1f}pt}}"
                for width, is_right in zip(widths, right, strict=True)
            )
            table["classes"].append("longtable")
            turn, back = (
                (r"\begin{landscape}", r"\end{landscape}") if measure == _TURNED else ("", "")
            )
            parent = table.parent
            at = parent.index(table)
            parent.insert(at + 1, _latex(rf"\endgroup{back}" + "\n"))
            parent.insert(at, tabular_col_spec(spec=spec))
            parent.insert(at, _latex(rf"{turn}\begingroup{command}" + "\n"))
            return
    raise ValueError(f"a table is too wide for a page: {table.astext()[:80]!r}")


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
    next(tree.findall(nodes.section)).append(_link(app, page, "The calculator"))


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

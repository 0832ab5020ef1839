"""What the chapter notebooks share: looks, sentences, numbered equations, tables, data."""

import os
import re
import shlex
from base64 import b64encode
from collections.abc import Collection, Mapping
from dataclasses import dataclass
from html import escape
from textwrap import wrap

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import sympy as sp
from IPython.core.getipython import get_ipython
from IPython.core.pylabtools import print_figure
from IPython.display import SVG, Markdown, display
from matplotlib.figure import Figure
from matplotlib_inline.backend_inline import set_matplotlib_formats

from discostorm import figures, words
from discostorm.data import data_path
from discostorm.messages import Message, Protocol
from discostorm.notation import N_H, NOTATION
from discostorm_book import mobile
from discostorm_book.ledger import claims
from discostorm_planner import Plan, Remedy

#: Under what a notebook keeps each figure once more, beside it: for phones, where pages show it,
#: see ``book/_ext/pictures.py``.
NARROW = "narrow"


def setup() -> None:
    """Make figures come out in the looks of the book, as vectors, the same every time.

    Each of them also for a phone.
    """
    # Matplotlib writes this date into SVG and PDF files instead of today's.
    os.environ["SOURCE_DATE_EPOCH"] = "0"
    plt.style.use(figures.SHEETS)
    set_matplotlib_formats("svg", bbox_inches=None)
    if (shell := get_ipython()) and shell.display_formatter:
        shell.display_formatter.formatters["image/svg+xml"].for_type(Figure, _both)


def _both(figure: Figure) -> tuple[str, dict[str, str]]:
    """Return a figure as SVG, and what is kept beside it."""
    wide = print_figure(figure, "svg", bbox_inches=None)
    return wide, {NARROW: print_figure(mobile.narrowed(figure), "svg", bbox_inches=None)}


def latex(expression: sp.Expr) -> str:
    r"""Return an expression as LaTeX; subscripts of more than a letter are upright.

    Examples
    --------
    >>> print(latex(sp.Symbol("R_uni") * sp.Symbol("N_H")))
    N_{H} R_\text{uni}
    """
    names = {}
    for symbol in expression.free_symbols:
        letter, _, below = symbol.name.partition("_")
        if len(below) > 1:
            words = below.replace("_", " ")
            names[symbol] = rf"{sp.latex(sp.Symbol(letter))}_\text{{{words}}}"
    return str(sp.latex(expression, symbol_names=names))


def of_all_hosts(of_one_host: sp.Expr) -> sp.Sum:
    """Return what all hosts send if each of them sends that.

    Examples
    --------
    >>> from discostorm.notation import N_P
    >>> of_all_hosts(N_P).doit()
    N_H*N_P
    """
    return sp.Sum(of_one_host, (sp.Symbol("i", integer=True), 1, N_H))


def equation(label: str, left: str | sp.Expr, *steps: sp.Expr | str) -> Markdown:
    """Show an equation that the book numbers and can refer to by its label.

    Parameters
    ----------
    label : str
        What a page refers to it by: ``{eq}`label` ``.
    left : str or sympy.Expr
        Left side, as LaTeX or an expression.
    *steps : sympy.Expr or str
        What it equals, one line each.
    """
    lines = [step if isinstance(step, str) else latex(step) for step in steps]
    start = left if isinstance(left, str) else latex(left)
    body = " \\\\[4pt]\n".join(f"&= {line}" for line in lines)
    return Markdown(f"$$\n\\begin{{aligned}}\n{start} {body}\n\\end{{aligned}}\n$$ ({label})")


def say(*sentences: str) -> None:
    """Show sentences with computed numbers in the type of the page; several of them as a list."""
    start = "- " if len(sentences) > 1 else ""
    display(Markdown("\n".join(start + typeset(sentence) for sentence in sentences)))


def answer(*paragraphs: str) -> Markdown:
    """Show what a chapter answers to its question, set off from the text as the question is."""
    first, *others = map(typeset, paragraphs)
    return Markdown("\n>\n".join(f"> {text}" for text in (f"**The answer.** {first}", *others)))


def badge(figure: str) -> Markdown:
    """Show what the ledger says of a figure of the paper, such as "2"."""
    return Markdown(claims.figures()[figure].caption())


@dataclass(frozen=True, repr=False)
class Advice:
    """The advice of a plan: as HTML in cards, elsewhere as text."""

    plan: Plan

    def __repr__(self) -> str:
        return self.plan.advice()

    def _repr_markdown_(self) -> str:
        return "\n\n".join(map(_block, self.plan.advice().split("\n\n")))

    def _repr_html_(self) -> str:
        blocks = self.plan.advice().split("\n\n")
        # The answer comes first; a host alone has none.
        before = 3 if self.plan.fleet.hosts() > 1 else 2
        *said, shares = (block.splitlines() for block in blocks[:before])
        parts = [
            *(f"<p>{_prose(' '.join(lines))}</p>" for lines in said),
            f"<p>{_prose(' '.join(line.removeprefix('- ').strip() for line in shares))}</p>",
        ]
        for title, remedies in self.plan.sections().items():
            cards = "".join(map(_card, remedies))
            parts.append(f'<p class="plan-title">{_prose(title)}</p>')
            parts.append(f'<div class="plan-cards">{cards}</div>')
        for block in blocks[before + len(self.plan.sections()) : -1]:
            title, *rows = block.splitlines()
            parts.append(f'<p class="plan-title">{_prose(title)}</p>')
            if _is_table(block):
                table = escape("\n".join(rows))
                parts.append(f'<div class="highlight"><pre tabindex="0">{table}</pre></div>')
            else:
                items = re.split(r"^- ", "\n".join(rows), flags=re.MULTILINE)[1:]
                told = (f"<li>{_prose(' '.join(item.split()))}</li>" for item in items)
                parts.append(f"<ul>{''.join(told)}</ul>")
        parts.append(f"<p>{_prose(' '.join(blocks[-1].split()))}</p>")
        return "".join(parts)


def _prose(text: str) -> str:
    """Return a sentence as HTML, with the book's apostrophes, and units that stay with numbers."""
    html = escape(words.unbroken(text.replace("'", "\N{RIGHT SINGLE QUOTATION MARK}")))
    return re.sub(r"`([^`]+)`", r"<code>\1</code>", html)


def _card(remedy: Remedy) -> str:
    """Return a remedy as HTML: what it brings, what it takes, and what to paste, folded."""
    how = "would fit" if remedy.best_case else "fits"
    how = "may fit" if remedy.may_now_fit else how
    better = remedy.now_fits or remedy.may_now_fit
    fits = f'<strong class="plan-fits">{how}</strong>' if better else ""
    what = words.capitalized(remedy.what)
    gain = words.capitalized(words.sentences(remedy.brings(), remedy.note))
    pieces = "".join(
        f"<details><summary>To copy: {escape(f'{piece.where} ({piece.version})')}</summary>"
        f'<div class="highlight"><pre tabindex="0">{escape(piece.text)}</pre></div></details>'
        for piece in remedy.snippets
    )
    return (
        f'<div class="plan-card"><p class="plan-what">{_prose(what)} {fits}</p>'
        f"<p>{_prose(gain)}.</p>"
        f'<p class="plan-mind">{_prose(remedy.caution())}</p>{pieces}</div>'
    )


def advice(plan: Plan) -> Advice:
    """Show the advice of a plan: cost, what dominates, and what would help, with what to paste."""
    return Advice(plan)


def _is_table(block: str) -> bool:
    """Return whether a part of an advice is a title and rows in columns."""
    _, *rows = block.splitlines()
    return bool(rows) and all(row.startswith("  ") for row in rows)


def _block(text: str) -> str:
    """Return a part of an advice, which is broken for a terminal, as Markdown."""
    # Names of groups may have what HTML would act on.
    text = escape(text, quote=False)
    if _is_table(text):
        title, *rows = text.splitlines()
        return "\n".join([f"**{title}**", "", *(f"  {row}" for row in rows)])
    items = re.split(r"\n *(?=- |\d+\. )", re.sub(r"\n +Effort:", " *Effort:*", text))
    head, *others = (" ".join(item.split()) for item in items)
    return "\n".join([f"**{head}**", "", *others] if others else [head])


_UNITS = {
    "us": "µs",
    "ms": "ms",
    "s": "s",
    "B": "B",
    "bits": "bits",
    "MHz": "MHz",
    "GHz": "GHz",
    "Mbit_s": "Mbit/s",
}
#: Names of the standard, which are not words.
_TERMS = {"sifs": "SIFS", "cw min": "CWmin", "cw max": "CWmax", "mpdus": "MPDUs"}
_NONE = "\N{EN DASH}"
_MINUS = "\N{MINUS SIGN}"
#: What stays as it is: code and formulas.
_AS_IT_IS = re.compile(r"(`[^`]*`|\$[^$]*\$)")
#: A hyphen that stands for a minus.
_HYPHEN = re.compile(r"(?<![\w.)/#-])-(?=\d)")
_NUMBER = re.compile(
    rf"[-+{_MINUS}<≤>≥≈ ]*(\d[\d,]*(\.\d+)?(e[-+]?\d+)?(\s?(%|[µmn]?s|k?B|[MG]Hz|Mbit/s))?|∞)"
    rf"|{_NONE}|"
)


def heading(name: str) -> str:
    """Return what a column of data is called in a table: words, and the unit in brackets.

    Examples
    --------
    >>> heading("sifs_us"), heading("rate_Mbit_s"), heading("how_many"), heading("hosts")
    ('SIFS [µs]', 'rate [Mbit/s]', 'how many', 'hosts')
    """
    if not re.fullmatch(r"\w+", name):
        return name
    if name in _UNITS and name != "bits":
        return f"[{_UNITS[name]}]"
    units = sorted(_UNITS, key=len, reverse=True)
    unit = next((unit for unit in units if name.endswith(f"_{unit}")), None)
    words = name.removesuffix(f"_{unit}").replace("_", " ")
    words = _TERMS.get(words, words)
    return f"{words} [{_UNITS[unit]}]" if unit else words


def typeset(text: str) -> str:
    """Return a text for people: a minus is no hyphen, and no line ends between number and unit.

    Code and formulas stay as they are.

    Examples
    --------
    >>> typeset("by -6% in 2020-2024; `x = -1`") == "by \N{MINUS SIGN}6% in 2020-2024; `x = -1`"
    True
    >>> typeset("3 s") == "3\N{NO-BREAK SPACE}s"
    True
    """
    parts = enumerate(_AS_IT_IS.split(text))
    return "".join(
        part if place % 2 else words.unbroken(_HYPHEN.sub(_MINUS, part)) for place, part in parts
    )


def _cell(value: object) -> str:
    """Return a value as a reader reads it: no True, no inf, no nan, no hyphen for a minus."""
    if isinstance(value, bool | np.bool_):
        return "yes" if value else "no"
    text = f"{value:g}" if isinstance(value, float) else str(value)
    if infinite := re.fullmatch(r"([-+]?)inf\b.*", text):
        return f"{_MINUS if infinite[1] == '-' else ''}∞"
    return _NONE if re.fullmatch(r"[-+]?nan\b.*", text) else typeset(text)


def table(
    frame: pd.DataFrame,
    formats: Mapping[str, str] | None = None,
    names: Collection[str] = (),
) -> Markdown:
    """Show a table; ``formats`` gives the format of a column's values, such as ``.3f``.

    Columns of numbers, also of numbers in words such as ``95%``, are aligned on the right, but
    not those of ``names``, which only look like numbers.
    """
    shown = frame.copy().astype(object)
    for column, spec in (formats or {}).items():
        shown[column] = [format(value, spec) for value in frame[column]]
    index = frame.index.name is not None
    if index:
        shown = shown.reset_index()
    shown = shown.map(_cell).rename(columns=heading)
    numeric = [
        name not in names and all(_NUMBER.fullmatch(str(value)) for value in shown[name])
        for name in shown
    ]
    alignment = ["right" if right else "left" for right in numeric]
    return Markdown(shown.to_markdown(index=False, colalign=alignment, disable_numparse=True))


@dataclass(frozen=True)
class Download:
    """A file that a page carries in itself: as HTML a link, as text the name of the file."""

    name: str
    content: str

    def _told(self) -> str:
        shown = "table" if self.name.startswith("table-") else "figure"
        return f"Data of this {shown}: {self.name}"

    def __repr__(self) -> str:
        """Return what is shown where links are not."""
        return f"{self._told()}, a link in the HTML edition."

    def _repr_html_(self) -> str:
        content = b64encode(self.content.encode()).decode()
        return (
            f'<a download="{self.name}" href="data:text/csv;charset=utf-8;base64,{content}">'
            f"{self._told()}</a>"
        )


def download(frame: pd.DataFrame, name: str) -> Download:
    """Offer what a figure or table shows as a CSV file, on the page itself: no server is needed.

    Numbers have ten digits, so that a last bit, which differs between processors, is not seen.

    Parameters
    ----------
    frame : pandas.DataFrame
        What the figure shows; its index is in the file if it has a name.
    name : str
        What the file is called, such as ``fig-paper-2``: lower-case letters, digits and hyphens.

    Returns
    -------
    Download
        What Jupyter and the book show as a link.

    Raises
    ------
    ValueError
        If the name has other characters, or the table is empty.

    Examples
    --------
    >>> link = download(pd.DataFrame({"hosts": [1, 2], "share": [1 / 3, 0.5]}), "fig-some")
    >>> link
    Data of this figure: fig-some.csv, a link in the HTML edition.
    >>> print(link.content)
    hosts,share
    1,0.3333333333
    2,0.5
    <BLANKLINE>
    """
    if not re.fullmatch(r"[a-z0-9]+(-[a-z0-9]+)*", name):
        raise ValueError(
            f"name must be made of lower-case letters, digits and hyphens; got {name!r}"
        )
    if frame.empty:
        raise ValueError("frame must have rows and columns; got an empty one")
    index = any(level is not None for level in frame.index.names)
    content = frame.to_csv(index=index, float_format="%.10g", lineterminator="\n")
    return Download(f"{name}.csv", content)


def drawing(name: str) -> SVG:
    """Show a drawing of the package, so that it is in the notebook wherever that goes."""
    return SVG(data=data_path(f"{name}.svg", "discostorm_book").read_text(encoding="utf-8"))


def messages(protocol: Protocol) -> Markdown:
    """Show a protocol's table of messages."""
    return table(
        pd.DataFrame(
            {
                "message": message.name,
                "phase": message.phase,
                "cast": message.cast,
                "over": message.transport,
                "how many": f"{message.per_unit:g} per {message.unit.name}",
            }
            for message in protocol.messages
        )
    )


def shell(*commands: str, lines: int | None = None) -> Markdown:
    """Run commands ``discostorm ...`` and show each with all that it prints.

    They run in this process, at a fixed width, so that the output is the same everywhere.
    Lines beyond this width are broken, as a terminal does. An exit code other than 0 is
    shown as well.

    Parameters
    ----------
    *commands : str
        As typed into a shell, without pipes.
    lines : int, optional
        Show so many lines of the output, and say how many more there were.
    """
    from click.testing import CliRunner

    from discostorm.cli import main

    width = 79
    shown = []
    for command in commands:
        program, *arguments = shlex.split(command)
        if program != "discostorm":
            raise ValueError(f"commands must start with discostorm; got {command!r}")
        result = CliRunner().invoke(main, arguments, prog_name=program, terminal_width=width)
        if result.exception and not isinstance(result.exception, SystemExit):
            raise result.exception
        printed = result.output.rstrip("\n").split("\n")
        rest = len(printed) - (lines or len(printed))
        shown += [f"$ {command}", *printed[:lines]]
        if rest > 0:
            shown.append(f"... and {rest} more lines")
        if result.exit_code != 0:
            shown.append(f"[exit code {result.exit_code}]")
        shown.append("")
    fitting = [
        part for line in shown[:-1] for part in (wrap(line, width) if len(line) > width else [line])
    ]
    return Markdown("\n".join(["```text", *fitting, "```"]))


def payload_meaning(protocol: Protocol, message: Message) -> str:
    """Return what the payload symbol of a message stands for."""
    return f"payload of {message.name}, a message of {protocol.name}"


def notation(*protocols: Protocol) -> Markdown:
    """Show the notation, and after it the payload symbol of each message of the protocols."""
    rows = [
        (quantity.symbol, quantity.meaning, quantity.unit, quantity.source)
        for quantity in NOTATION.values()
    ]
    rows += [
        (
            message.payload_symbol,
            payload_meaning(protocol, message),
            "B",
            message.payload.source,
        )
        for protocol in protocols
        for message in protocol.messages
    ]
    frame = pd.DataFrame(rows, columns=["symbol", "meaning", "unit", "source"])
    frame["symbol"] = [f"${latex(symbol)}$" for symbol in frame["symbol"]]
    return table(frame)

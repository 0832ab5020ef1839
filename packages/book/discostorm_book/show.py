"""Shared parts of the chapter notebooks: style, numbered equations, tables, downloads."""

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
from IPython.display import SVG, Markdown
from matplotlib.figure import Figure
from matplotlib_inline.backend_inline import set_matplotlib_formats

from discostorm import figures, wording
from discostorm.data import data_path
from discostorm.messages import Message, Protocol
from discostorm.notation import N_H, NOTATION
from discostorm_book.ledger import claims
from discostorm_book.phone_figures import adapt_for_phone
from discostorm_planner import Plan, Remedy

#: The key under which a notebook keeps each figure for phones; see ``book/_ext/pictures.py``.
PHONE_KEY = "narrow"


def setup() -> None:
    """Draw figures in the book's style as SVG, the same every time, and each for a phone, too."""
    # Matplotlib writes this date into SVG and PDF files instead of today's.
    os.environ["SOURCE_DATE_EPOCH"] = "0"
    plt.style.use(figures.STYLE_SHEETS)
    set_matplotlib_formats("svg", bbox_inches=None)
    if (shell := get_ipython()) and shell.display_formatter:
        formatter = shell.display_formatter.formatters["image/svg+xml"]
        formatter.for_type(Figure, _desktop_and_phone_figure)


def _desktop_and_phone_figure(figure: Figure) -> tuple[str, dict[str, str]]:
    """Return a figure as SVG, and as metadata the figure for phones."""
    wide = print_figure(figure, "svg", bbox_inches=None)
    return wide, {PHONE_KEY: print_figure(adapt_for_phone(figure), "svg", bbox_inches=None)}


def latex(expression: sp.Expr) -> str:
    r"""Return an expression as LaTeX; subscripts of more than a letter are upright."""
    names = {}
    for symbol in expression.free_symbols:
        letter, _, below = symbol.name.partition("_")
        if len(below) > 1:
            words = below.replace("_", " ")
            names[symbol] = rf"{sp.latex(sp.Symbol(letter))}_\text{{{words}}}"
    return str(sp.latex(expression, symbol_names=names))


def of_all_hosts(of_one_host: sp.Expr) -> sp.Sum:
    """Return the sum over all hosts if each host sends the same."""
    return sp.Sum(of_one_host, (sp.Symbol("i", integer=True), 1, N_H))


def equation(label: str, left: str | sp.Expr, *steps: sp.Expr | str) -> Markdown:
    """Show an equation with one line per step, to which pages refer as ``{eq}`label` ``."""
    start, *lines = (step if isinstance(step, str) else latex(step) for step in (left, *steps))
    body = " \\\\[4pt]\n".join(f"&= {line}" for line in lines)
    return Markdown(f"$$\n\\begin{{aligned}}\n{start} {body}\n\\end{{aligned}}\n$$ ({label})")


def badge(figure: str) -> Markdown:
    """Show the ledger's verdict on a figure of the paper, given its number, such as "2"."""
    return Markdown(claims.figures()[figure].caption())


@dataclass(frozen=True, repr=False)
class Advice:
    """The explanations of a plan, to show: as HTML in cards, elsewhere as text."""

    plan: Plan

    def __repr__(self) -> str:
        return self.plan.why()

    def _repr_markdown_(self) -> str:
        return "\n\n".join(map(_advice_part_as_markdown, self.plan.why().split("\n\n")))

    def _repr_html_(self) -> str:
        *blocks, end = self.plan.why().split("\n\n")
        remedies = self.plan.sections()
        # The answer comes first; a host alone has none.
        count = 3 if self.plan.fleet.hosts() > 1 else 2
        parts = [_paragraph_html(re.sub("^- ", "", block, flags=re.M)) for block in blocks[:count]]
        for title, cards in remedies.items():
            parts.append(_paragraph_html(title, "plan-title"))
            parts.append(f'<div class="plan-cards">{"".join(map(_remedy_card, cards))}</div>')
        for block in blocks[count + len(remedies) :]:
            title, rows = block.split("\n", 1)
            parts.append(_paragraph_html(title, "plan-title"))
            if _is_table(block):
                parts.append(_code_html(rows))
            else:
                items = re.split(r"^- ", rows, flags=re.MULTILINE)[1:]
                listed = (f"<li>{_as_html(' '.join(item.split()))}</li>" for item in items)
                parts.append(f"<ul>{''.join(listed)}</ul>")
        return "".join([*parts, _paragraph_html(end)])


def _paragraph_html(text: str, style: str = "") -> str:
    start = f'<p class="{style}">' if style else "<p>"
    return f"{start}{_as_html(' '.join(text.split()))}</p>"


def _code_html(text: str) -> str:
    return f'<div class="highlight"><pre tabindex="0">{escape(text)}</pre></div>'


def _as_html(text: str) -> str:
    """Return a sentence as HTML, with the book's apostrophes, and units that stay with numbers."""
    html = escape(wording.no_break_spaces(text.replace("'", "\N{RIGHT SINGLE QUOTATION MARK}")))
    return re.sub(r"`([^`]+)`", r"<code>\1</code>", html)


def _remedy_card(remedy: Remedy) -> str:
    """Return a remedy as HTML: gain, trade-offs, and the configuration to copy, folded."""
    how = "would fit" if remedy.best_case else "fits"
    how = "may fit" if remedy.may_now_fit else how
    better = remedy.now_fits or remedy.may_now_fit
    fits = f'<strong class="plan-fits">{how}</strong>' if better else ""
    gain = wording.capitalized(wording.join_sentences(remedy.gain_clause(), remedy.note))
    pieces = "".join(
        f"<details><summary>To copy: {escape(f'{piece.where} ({piece.version})')}</summary>"
        f"{_code_html(piece.text)}</details>"
        for piece in remedy.snippets
    )
    return (
        f'<div class="plan-card"><p class="plan-what">'
        f"{_as_html(wording.capitalized(remedy.what))} {fits}</p><p>{_as_html(gain)}.</p>"
        f'<p class="plan-mind">{_as_html(remedy.caution())}</p>{pieces}</div>'
    )


def _is_table(block: str) -> bool:
    """Return whether a part of an advice is a title and rows in columns."""
    return re.fullmatch(r".*(\n  .*)+\n?", block) is not None


def _advice_part_as_markdown(text: str) -> str:
    """Return a part of an advice, which is broken for a terminal, as Markdown."""
    # Names of groups may contain HTML.
    text = escape(text, quote=False)
    if _is_table(text):
        title, *rows = text.splitlines()
        return "\n".join([f"**{title}**", "", *(f"  {row}" for row in rows)])
    items = re.split(r"\n *(?=- |\d+\. )", re.sub(r"\n +Effort:", " *Effort:*", text))
    head, *others = (" ".join(item.split()) for item in items)
    return "\n".join([f"**{head}**", "", *others] if others else [head])


_HEADING_UNITS = {name: name for name in ("ms", "s", "B", "bits", "MHz", "GHz")}
_HEADING_UNITS |= {"us": "µs", "Mbit_s": "Mbit/s"}
#: Names of the standard, which are no wording.
_TERMS = {"sifs": "SIFS", "cw min": "CWmin", "cw max": "CWmax", "mpdus": "MPDUs"}
_MISSING_VALUE = "\N{EN DASH}"
_MINUS = "\N{MINUS SIGN}"
#: Code and formulas, which stay as they are.
_VERBATIM = re.compile(r"(`[^`]*`|\$[^$]*\$)")
#: A hyphen that stands for a minus.
_HYPHEN = re.compile(r"(?<![\w.)/#-])-(?=\d)")
_ONE_NUMBER = (
    rf"([-+{_MINUS}<≤>≥≈ ]*(\d[\d,]*(\.\d+)?(e[-+]?\d+)?(\s?(%|[µmn]?s|k?B|[MG]Hz|Mbit/s))?|∞)"
    rf"|never|not enough|{_MISSING_VALUE}|)"
)
_NUMBER = re.compile(rf"{_ONE_NUMBER}( / {_ONE_NUMBER})?")


def heading(name: str) -> str:
    """Return the heading of a column of data: words, and the unit in brackets.

    Examples
    --------
    >>> heading("sifs_us"), heading("rate_Mbit_s"), heading("how_many"), heading("hosts")
    ('SIFS [µs]', 'rate [Mbit/s]', 'how many', 'hosts')
    """
    if not re.fullmatch(r"\w+", name):
        return name
    if name in _HEADING_UNITS and name != "bits":
        return f"[{_HEADING_UNITS[name]}]"
    units = sorted(_HEADING_UNITS, key=len, reverse=True)
    unit = next((unit for unit in units if name.endswith(f"_{unit}")), None)
    words = name.removesuffix(f"_{unit}").replace("_", " ")
    words = _TERMS.get(words, words)
    return f"{words} [{_HEADING_UNITS[unit]}]" if unit else words


def typeset(text: str) -> str:
    """Return a text with minus signs, and without line ends between number and unit."""
    parts = _VERBATIM.split(text)
    parts[::2] = [wording.no_break_spaces(_HYPHEN.sub(_MINUS, part)) for part in parts[::2]]
    return "".join(parts)


def _format_cell(value: object) -> str:
    """Return a value for people: no True, no inf, no nan, no hyphen for a minus."""
    if isinstance(value, bool | np.bool_):
        return "yes" if value else "no"
    text = f"{value:g}" if isinstance(value, float) else str(value)
    if infinite := re.fullmatch(r"([-+]?)inf\b.*", text):
        return f"{_MINUS if infinite[1] == '-' else ''}∞"
    return _MISSING_VALUE if re.fullmatch(r"[-+]?nan\b.*", text) else typeset(text)


def table(
    frame: pd.DataFrame, formats: Mapping[str, str] | None = None, names: Collection[str] = ()
) -> Markdown:
    """Show a table, formatted by column; numbers align right, except in the columns ``names``."""
    shown = frame.copy().astype(object)
    for column, spec in (formats or {}).items():
        shown[column] = [format(value, spec) for value in frame[column]]
    if frame.index.name is not None:
        shown = shown.reset_index()
    shown = shown.map(_format_cell).rename(columns=heading)
    alignment = [
        "right" if name not in names and all(map(_NUMBER.fullmatch, shown[name])) else "left"
        for name in shown
    ]
    return Markdown(shown.to_markdown(index=False, colalign=alignment, disable_numparse=True))


@dataclass(frozen=True)
class Download:
    """A file that a page carries in itself: as HTML a link, as text the name of the file."""

    name: str
    content: str

    def __repr__(self) -> str:
        return f"{self._label()}, a link in the HTML edition."

    def _label(self) -> str:
        shown = "table" if self.name.startswith("table-") else "figure"
        return f"Data of this {shown}: {self.name}"

    def _repr_html_(self) -> str:
        content = b64encode(self.content.encode()).decode()
        address = f"data:text/csv;charset=utf-8;base64,{content}"
        return f'<a download="{self.name}" href="{address}">{self._label()}</a>'


def download(frame: pd.DataFrame, name: str) -> Download:
    """Offer a table as a CSV file under a name such as ``fig-paper-2``, inside the page itself.

    The index is in the file if it has a name.

    Examples
    --------
    >>> print(download(pd.DataFrame({"hosts": [1, 2], "share": [1 / 3, 0.5]}), "fig-some").content)
    hosts,share
    1,0.3333333333
    2,0.5
    <BLANKLINE>
    """
    if not re.fullmatch(r"[a-z0-9]+(-[a-z0-9]+)*", name):
        letters = "lower-case letters, digits and hyphens"
        raise ValueError(f"name must be made of {letters}; got {name!r}")
    if frame.empty:
        raise ValueError("frame must have rows and columns; got an empty one")
    index = any(level is not None for level in frame.index.names)
    # Ten digits, as the last bit differs between processors.
    content = frame.to_csv(index=index, float_format="%.10g", lineterminator="\n")
    return Download(f"{name}.csv", content)


def drawing(name: str) -> SVG:
    """Show a drawing of the package as a part of the notebook."""
    return SVG(data=data_path(f"{name}.svg", "discostorm_book").read_text(encoding="utf-8"))


def messages(protocol: Protocol) -> Markdown:
    """Show a protocol's table of messages."""
    return table(protocol.table().rename(columns={"cast": "delivery"}).loc[:, :"how many"])


def shell(*commands: str, lines: int | None = None) -> Markdown:
    """Run commands ``discostorm ...`` in this process, and show the first lines of their output."""
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
    """Return the meaning of the payload symbol of a message."""
    return f"payload of {message.name}, a message of {protocol.name}"


def notation(*protocols: Protocol) -> Markdown:
    """Show the notation, and after it the payload symbol of each message of the protocols."""
    rows = [(row.symbol, row.meaning, row.unit, row.source) for row in NOTATION.values()]
    rows += [
        (m.payload_symbol, payload_meaning(protocol, m), "B", m.payload.source)
        for protocol in protocols
        for m in protocol.messages
    ]
    frame = pd.DataFrame(rows, columns=["symbol", "meaning", "unit", "source"])
    return table(frame.assign(symbol=[f"${latex(symbol)}$" for symbol in frame["symbol"]]))

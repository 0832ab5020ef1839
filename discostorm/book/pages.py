"""What pages do in a browser: the data that their scripts read, and the questions that they ask.

A cell tagged ``remove-input`` and ``page-data`` shows what is made here. Nothing of it is seen
without JavaScript, on paper, in the PDF or in Jupyter.
"""

import json
from collections.abc import Mapping
from typing import Any

import sympy as sp
from IPython.display import HTML

from discostorm import figures
from discostorm.book.facts import unfounded
from discostorm.notation import N_E, N_H, N_P
from discostorm.wifi import PAPER

#: Endpoints that all processes of a robot have together: the fewest and the most to choose [1].
LINE = (4, 100)
#: Where the line begins: the paper's endpoints, in the most processes that Sec. IV-B names [1].
LINE_PROCESSES = 8


def carried(name: str, data: Any, *files: str) -> HTML:
    """Put data on a page under a name, and load style sheets and scripts of ``book/_static``."""
    text = json.dumps(data, separators=(",", ":"), ensure_ascii=False).replace("</", r"<\/")
    parts = [f'<script type="application/json" id="{name}-data">{text}</script>']
    for file in files:
        address = f"../_static/{file}"
        sheet = file.endswith(".css")
        parts.append(
            f'<link rel="stylesheet" href="{address}">'
            if sheet
            else f'<script src="{address}"></script>'
        )
    return HTML("\n".join(parts))


def guess(
    question: str,
    answer: float,
    *,
    least: float,
    most: float,
    step: float,
    unit: str,
    given: Mapping[str, float] | None = None,
) -> HTML:
    """Ask for a guess before a page's *In short* is read.

    Parameters
    ----------
    question : str
        What is asked; it says in words what it is about.
    answer : float
        What the package computes, in the unit: one of the facts of *In short*.
    least, most, step : float
        What the slider offers; the step has the digits that *In short* states.
    unit : str
        What stands behind the number, such as "s" or "times".
    given : mapping of str to float, optional
        Facts that the question states, in its order.

    Raises
    ------
    ValueError
        If the question states other numbers than those given, or the answer is out of reach.

    Examples
    --------
    >>> asked = guess("How many?", 4.62, least=1, most=10, step=0.1, unit="times")
    >>> print(asked.data.splitlines()[0][:96])
    <script type="application/json" id="guess-data">{"question":"How many?","answer":4.6,"least":1,"
    """
    if problem := unfounded(question, given or {}):
        raise ValueError(f"the question and what is given disagree: {problem}")
    if not least < answer < most:
        raise ValueError(f"the answer, {answer:g}, must lie between {least:g} and {most:g}")
    places = len(f"{step:g}".partition(".")[2])
    data = {
        "question": question,
        "answer": round(float(answer), places),
        "least": least,
        "most": most,
        "step": step,
        "places": places,
        "unit": unit,
    }
    return carried("guess", data, "chapters/pages.css", "guess.js")


def line_of_fig3() -> HTML:
    """Let the reader drag the line of Fig. 3: robots with so many endpoints in all."""
    return carried("line", _line(), "chapters/pages.css", "chapters/line.js")


def _line() -> dict[str, Any]:
    """Return where the panels of Fig. 3 are, and utilization as a polynomial of each protocol."""
    figure = figures.fig3()
    with figures.style():
        figure.draw_without_rendering()
    panels = []
    for axis in figure.axes:
        box = axis.get_position()
        panels.append(
            {
                # Parts of the figure: from the left and from above.
                "x": [round(float(x), 5) for x in (box.x0, box.x1)],
                "y": [round(1 - float(y), 5) for y in (box.y0, box.y1)],
                "xlim": [float(x) for x in axis.get_xlim()],
                "ylim": [float(y) for y in axis.get_ylim()],
            }
        )
    protocols = []
    for protocol in figures.PAPER_PROTOCOLS:
        known = protocol.values() | PAPER.values() | {N_H: figures.FIG3_HOSTS}
        terms = sp.Poly(protocol.utilization().subs(known), N_P, N_E).terms()
        protocols.append(
            {
                "name": protocol.name,
                "color": figures.property_of(protocol),
                # Powers of the processes and of the endpoints of each, and the factor.
                "terms": [[i, j, float(f"{float(factor):.12g}")] for (i, j), factor in terms],
            }
        )
    width, height = figure.get_size_inches()
    return {
        "hosts": figures.FIG3_HOSTS,
        "size": [round(96 * float(width), 2), round(96 * float(height), 2)],
        "panels": panels,
        "protocols": protocols,
        "endpoints": [*LINE, figures.FIG3_ENDPOINTS_IN_ALL],
        "processes": [1, 10, LINE_PROCESSES],
    }

"""What the chapter notebooks share: looks, numbered equations, tables."""

import os
from collections.abc import Mapping
from importlib.resources import as_file, files

import matplotlib.pyplot as plt
import pandas as pd
import sympy as sp
from IPython.display import Markdown
from matplotlib_inline.backend_inline import set_matplotlib_formats

from discostorm.messages import Protocol


def setup() -> None:
    """Make figures come out in the looks of the book, as vectors, the same every time."""
    # Matplotlib writes this date into SVG and PDF files instead of today's.
    os.environ["SOURCE_DATE_EPOCH"] = "0"
    with as_file(files("discostorm") / "data" / "discostorm.mplstyle") as path:
        plt.style.use(path)
    set_matplotlib_formats("svg", "pdf", bbox_inches=None)


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
    lines = [step if isinstance(step, str) else sp.latex(step) for step in steps]
    start = left if isinstance(left, str) else sp.latex(left)
    body = " \\\\\n".join(f"&= {line}" for line in lines)
    return Markdown(f"$$\n\\begin{{aligned}}\n{start} {body}\n\\end{{aligned}}\n$$ ({label})")


def table(frame: pd.DataFrame, formats: Mapping[str, str] | None = None) -> Markdown:
    """Show a table; ``formats`` gives the format of a column's values, such as ``.3f``."""
    shown = frame.copy().astype(object)
    for column, spec in (formats or {}).items():
        shown[column] = [format(value, spec) for value in frame[column]]
    index = frame.index.name is not None
    numeric = [
        pd.api.types.is_numeric_dtype(frame[column]) for column in frame.columns
    ]
    alignment = ["left"] * index + ["right" if right else "left" for right in numeric]
    return Markdown(
        shown.to_markdown(index=index, colalign=alignment, disable_numparse=True)
    )


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

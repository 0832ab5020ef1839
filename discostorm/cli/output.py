"""What an answer is printed as: a table for people, JSON or CSV for machines."""

from __future__ import annotations

import csv
import functools
import io
import json
import math
import os
import shutil
import sys
import textwrap
import unicodedata
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

import click

from discostorm import _checks, words
from discostorm.wifi import Wifi
from discostorm.wifi.radio import TOPOLOGY

Rows = Sequence[Mapping[Any, Any]]
Format = Callable[[Any], str]


class BadInput(click.ClickException):
    """What the user gave is wrong; the message says what and what is allowed."""

    exit_code = 2


@contextmanager
def bad_input() -> Iterator[None]:
    """Answer what the package refuses with its message and exit code 2."""
    try:
        yield
    except OSError as error:
        if error.filename is None:  # of the output
            raise
        name = _checks.brief(str(error.filename))
        raise BadInput(visible(f"{name}: {error.strerror}")) from error
    except MemoryError as error:
        raise BadInput(
            "there is not enough memory for this here; give a smaller fleet or file, or more memory"
        ) from error
    except ValueError as error:
        raise BadInput(visible(str(error))) from error


def visible(text: str) -> str:
    """Return a text with escapes for what a terminal would act on."""
    return "".join(
        ascii(character)[1:-1]
        if unicodedata.category(character) in ("Cc", "Cf", "Cs") and character != "\n"
        else character
        for character in text
    )


@dataclass(frozen=True)
class Output:
    """What an answer is printed as."""

    as_json: bool
    as_csv: bool

    @property
    def for_people(self) -> bool:
        """Whether it is a table."""
        return not (self.as_json or self.as_csv)


def _width() -> int:
    """Return the characters in a line, if a table can be made as narrow."""
    return max(shutil.get_terminal_size().columns - 1, 40)


def plain(value: Any) -> str:
    """Return a cell of a table, with escapes for what a terminal would act on."""
    if not isinstance(value, float):
        return visible(str(value)).replace("\n", "\\n")
    return f"{value:,.10g}" if value < 1e10 else f"{value:.3g}"


def percent(value: float) -> str:
    """Return a fraction in percent, to one decimal."""
    return words.percent(value, decimals=1, below="<")


def yes(value: bool) -> str:
    """Return a truth in words."""
    return "yes" if value else "no"


def seconds(value: float) -> str:
    """Return seconds to the microsecond, from ten on to the tenth."""
    if value < 10:
        return f"{value:.6f}"
    return f"{value:,.1f}" if value < words.HUGE else f"{value:.3g}"


def print_rows(
    rows: Rows,
    output: Output,
    formats: dict[str, Format] | None = None,
    headings: dict[str, str] | None = None,
) -> None:
    """Print a table for people, or all its digits for machines."""
    if output.as_json:
        click.echo(as_text(rows))
    elif output.as_csv:
        text = io.StringIO()
        writer = csv.DictWriter(text, list(rows[0]), lineterminator="\n")
        writer.writeheader()
        for row in rows:  # what is null in JSON, which has no infinity, is empty
            writer.writerow(
                {key: None if value == math.inf else value for key, value in row.items()}
            )
        click.echo(text.getvalue(), nl=False)
    else:
        click.echo(aligned(rows, formats or {}, headings or {}))


def print_channel(wifi: Wifi, output: Output) -> None:
    """Say below a table for which channel it holds, and for what kind of network."""
    if output.for_people:
        click.echo(f"\nChannel: {visible(wifi.name)}, {TOPOLOGY}.")


def as_text(value: Any) -> str:
    """Return JSON that every reader takes, in letters that the output can hold."""
    encoding = getattr(sys.stdout, "encoding", None) or "utf-8"
    text = functools.partial(json.dumps, value, indent=2, default=str, allow_nan=False)
    found = text(ensure_ascii=False)
    try:
        found.encode(encoding)
    except UnicodeEncodeError:
        return text(ensure_ascii=True)
    return found


def aligned(rows: Rows, formats: dict[str, Format], headings: dict[str, str]) -> str:
    """Return a table with aligned columns: numbers to the right, words to the left.

    Long words in the last column are broken into lines. A table that is too wide for a terminal all
    the same comes as a list: a line for each cell of a row, and a blank line between rows.
    """
    columns = []
    for name in rows[0]:
        values = [row[name] for row in rows]
        cells = [formats.get(name, plain)(value) for value in values]
        heading = headings.get(name, name.replace("_", " "))
        width = max(map(len, [heading, *cells]))
        there = [value for value in values if value is not None]
        number = all(type(value) in (int, float) for value in there)  # a truth is a word
        columns.append(
            [cell.rjust(width) if number else cell.ljust(width) for cell in (heading, *cells)]
        )
    start = sum(len(column[0]) + 2 for column in columns[:-1])
    lines: list[str] = []
    for *row, last in zip(*columns, strict=True):
        parts = textwrap.wrap(last.rstrip(), max(_width() - start, 20)) or [""]
        if last != last.lstrip():
            parts = [last]  # a number, already in its place
        lines.append(("  ".join([*row, parts[0]])).rstrip())
        lines += [" " * start + part for part in parts[1:]]
    if max(map(len, lines)) > shutil.get_terminal_size((10_000, 0)).columns:
        return _listed([[cell.strip() for cell in row] for row in zip(*columns, strict=True)])
    lines.insert(1, "-" * max(map(len, lines)))
    return "\n".join(lines)


def _listed(rows: list[list[str]]) -> str:
    """Return rows, the headings first, as blocks of lines: a heading and a cell."""
    headings, *others = rows
    start = max(map(len, headings)) + 2
    fill = functools.partial(
        textwrap.fill, width=max(_width(), start + 20), subsequent_indent=" " * start
    )
    blocks = (
        "\n".join(fill(f"{name:<{start}}{cell}") for name, cell in zip(headings, row, strict=True))
        for row in others
    )
    return "\n\n".join(blocks)


def live() -> bool:
    """Return whether a line of standard error can be written over."""
    return sys.stderr is not None and sys.stderr.isatty() and os.environ.get("TERM") != "dumb"


@contextmanager
def working(what: str) -> Iterator[None]:
    """Say on a terminal what takes its time, and wipe it out afterwards."""
    shown = live()
    if shown:
        click.echo(f"{what} ...", err=True, nl=False)
    try:
        yield
    finally:
        if shown:
            click.echo("\r" + " " * (len(what) + 4) + "\r", err=True, nl=False)

"""Output of commands: tables for people, JSON or CSV for machines, and files."""

import csv
import functools
import io
import json
import os
import shutil
import stat
import sys
import textwrap
import unicodedata
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import click

from discostorm import _checks, wording
from discostorm.files import atomic_write, json_ready

Rows = Sequence[Mapping[Any, Any]]
Format = Callable[[Any], str]


class BadInput(click.ClickException):
    """A wrong input; the message names the input and the allowed values."""

    exit_code = 2


@contextmanager
def bad_input() -> Iterator[None]:
    """Turn an error of the package into its message and exit code 2."""
    try:
        yield
    except OSError as error:
        if error.filename is None:  # the output failed, not an input file
            raise
        name = _checks.shorten_name(str(error.filename))
        raise BadInput(visible(f"{name}: {error.strerror}")) from error
    except MemoryError as error:
        why = "not enough memory for this; use a smaller fleet or file, or more memory"
        raise BadInput(why) from error
    except ValueError as error:
        given = [flag for one in click.get_current_context().command.params for flag in one.opts]
        flag = "--" * (f"--{str(error).split(' must ')[0]}" in given)
        raise BadInput(visible(flag + str(error))) from error


def visible(text: str) -> str:
    """Escape the characters that a terminal would act on."""
    unsafe = {c for c in text if unicodedata.category(c) in ("Cc", "Cf", "Cs")} - {"\n"}
    return text.translate({ord(character): ascii(character)[1:-1] for character in unsafe})


@dataclass(frozen=True)
class Output:
    """The format of an answer."""

    as_json: bool
    as_csv: bool

    def __post_init__(self) -> None:
        if self.as_json and self.as_csv:
            raise click.UsageError("use --json or --csv, not both")

    @property
    def for_people(self) -> bool:
        """Whether the format is a table for people."""
        return not (self.as_json or self.as_csv)


def as_text(value: Any) -> str:
    """Format a cell with all digits that matter, and without a terminal's control characters."""
    if not isinstance(value, float):
        return visible(str(value)).replace("\n", "\\n")
    return f"{value:,.10g}" if value < 1e10 else f"{value:.3g}"


def percent(value: float) -> str:
    """Format a fraction in percent with one decimal, from 1000% on with three digits."""
    if 10 <= value < wording.HUGE:
        return f"{float(f'{value:.3g}'):,.0%}"
    return wording.percent(value, decimals=1, below_prefix="<")


def format_bool(value: bool) -> str:
    """Format a truth value."""
    return "yes" if value else "no"


def format_seconds(value: float) -> str:
    """Format seconds with microseconds, from 10 s on with tenths."""
    if value < 10:
        return f"{value:.6f}"
    return f"{value:,.1f}" if value < wording.HUGE else f"{value:.3g}"


@dataclass(frozen=True)
class Column:
    """A column of a table for people: its key in the rows, heading, format and unit."""

    key: str
    heading: str = ""
    format: Format = as_text
    unit: str = ""

    @property
    def title(self) -> str:
        """The heading with its unit; without a heading the key."""
        title = self.heading or self.key.replace("_", " ")
        return f"{title} [{self.unit}]" if self.unit else title


def print_table(rows: Rows, output: Output, columns: Sequence[Column] | None = None) -> None:
    """Print a table: these columns or all for people, all keys and digits for machines."""
    if output.as_json:
        click.echo(to_json(rows))
    elif output.as_csv:
        text = io.StringIO()
        writer = csv.DictWriter(text, list(rows[0]), lineterminator="\n")
        writer.writeheader()
        writer.writerows(json_ready(rows))
        click.echo(text.getvalue(), nl=False)
    else:
        shown = columns_of(rows) if columns is None else columns
        click.echo(align_columns(rows, [column for column in shown if column.key in rows[0]]))


def columns_of(rows: Rows, *special: Column) -> list[Column]:
    """Return a column for each key of the rows: a given column, or a column without a format."""
    own = {column.key: column for column in special}
    return [own.get(key, Column(key)) for key in rows[0]]


def align_columns(rows: Rows, columns: Sequence[Column]) -> str:
    """Return a table with aligned columns: numbers to the right, words to the left.

    Long words in the last column are broken into lines. A table that is still wider than the
    terminal becomes a list: a line for each cell, and a blank line between rows.
    """
    cells = [[c.title, *(c.format(row[c.key]) for row in rows)] for c in columns]
    numeric = [  # a truth value is a word
        all(type(row[column.key]) in (int, float, type(None)) for row in rows) for column in columns
    ]
    widths = [max(map(len, column)) for column in cells]
    start = sum(widths[:-1]) + 2 * len(widths[:-1])
    lines: list[str] = []
    for row in zip(*cells, strict=True):
        *others, last = (
            cell.rjust(width) if number else cell.ljust(width)
            for cell, width, number in zip(row, widths, numeric, strict=True)
        )
        parts = [last] if numeric[-1] else textwrap.wrap(last, max(_width() - start, 20)) or [""]
        lines.append("  ".join([*others, parts[0]]).rstrip())
        lines += [" " * start + part for part in parts[1:]]
    if max(map(len, lines)) > shutil.get_terminal_size((10_000, 0)).columns:
        return _rows_as_blocks(list(zip(*cells, strict=True)))
    lines.insert(1, "-" * max(map(len, lines)))
    return "\n".join(lines)


def _rows_as_blocks(rows: Sequence[Sequence[str]]) -> str:
    """Return each row as a block with a line per cell, after its heading from the first row."""
    headings, *others = rows
    indent = min(max(map(len, headings)) + 2, max(_width() - 12, 8))
    fill = functools.partial(textwrap.fill, width=_width(), subsequent_indent=" " * indent)
    return "\n\n".join(
        "\n".join(
            fill(f"{heading + '  ':<{indent}}{cell}")
            for heading, cell in zip(headings, row, strict=True)
        )
        for row in others
    )


def _width() -> int:
    """Return the number of characters in a line of the terminal, at least 19."""
    return max(shutil.get_terminal_size().columns, 20) - 1


def print_paragraph(text: str) -> None:
    """Print a paragraph that fits the terminal, and at most 79 characters."""
    click.echo(visible(wording.wrap(text, min(_width(), 79))))


def print_note(text: str) -> None:
    """Print a paragraph below a blank line."""
    click.echo()
    print_paragraph(text)


def to_json(value: Any) -> str:
    """Return JSON without infinity and NaN, in letters that the output can encode."""
    dump = functools.partial(json.dumps, json_ready(value), indent=2, default=str, allow_nan=False)
    text = dump(ensure_ascii=False)
    try:
        text.encode(getattr(sys.stdout, "encoding", None) or "utf-8")
    except UnicodeEncodeError:
        return dump(ensure_ascii=True)
    return text


def write_file(option: str, name: str, content: bytes, *inputs: str | None) -> None:
    """Write the file that an option names; refuse to overwrite an input, or to write to ``-``."""
    if name == "-":
        raise BadInput(f"{option}: - is not a file; give a file name")
    path = Path(_checks.path(option, name, "a file"))
    named = visible(f"{option}: {_checks.shorten_name(name)}")
    if any(_is_input(path, each) for each in inputs if each is not None):
        raise BadInput(f"{named} is the input; name another file")
    try:
        atomic_write(path, content)
    except OSError as error:
        raise BadInput(f"{named}: {error.strerror}") from error


def _is_input(path: Path, name: str) -> bool:
    try:
        status = path.stat()
        source = os.fstat(0) if name == "-" else Path(name).stat()
    except (OSError, ValueError):
        return False
    return stat.S_ISREG(status.st_mode) and os.path.samestat(status, source)


def is_live_terminal() -> bool:
    """Return whether a line of standard error can be written over."""
    return sys.stderr is not None and sys.stderr.isatty() and os.environ.get("TERM") != "dumb"


@contextmanager
def show_slow_task(task: str) -> Iterator[None]:
    """Show the name of a slow task on a terminal until the task ends."""
    shown = is_live_terminal()
    if shown:
        click.echo(f"{task} ...", err=True, nl=False)
    try:
        yield
    finally:
        if shown:
            click.echo("\r" + " " * (len(task) + 4) + "\r", err=True, nl=False)

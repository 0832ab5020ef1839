"""The command ``discostorm figures``."""

from __future__ import annotations

from pathlib import Path
from typing import NoReturn

import click

from discostorm import _checks
from discostorm.cli.options import completes, output_options
from discostorm.cli.output import BadInput, Output, bad_input, print_rows, visible, working


@click.command()
@click.option(
    "--out",
    required=True,
    metavar="DIR",
    shell_complete=completes("dir"),
    help="Output folder, created if missing.",
)
@output_options
def figures(out: str, output: Output) -> None:
    """Write Figs. 2 to 4 of the paper as SVG, PDF and PNG, and their data as CSV.

    \b
    Example:
      discostorm figures --out figures
    """
    with bad_input():
        _checks.path("--out", out, "a folder")
    with working("loading"):
        from discostorm import figures as drawing
    paths: list[str] = []
    count = drawing.files_of_all()
    files = drawing.save_all(Path(out))
    while True:
        try:
            path = next(files, None)
        except OSError as error:
            _not_written(out, error)
        if path is None:
            break
        paths.append(str(path))
        click.echo(
            visible(f"[{len(paths):{len(str(count))}}/{count}] {path}"), err=not output.for_people
        )
    if not output.for_people:
        print_rows([{"path": path} for path in paths], output)


def _not_written(out: str, error: OSError) -> NoReturn:
    raise BadInput(
        visible(f"--out must be a folder to write to; got {_checks.brief(out)!r}: {error.strerror}")
    ) from error

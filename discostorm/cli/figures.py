"""The command ``discostorm figures``."""

from pathlib import Path

import click

from discostorm import _checks
from discostorm.cli.options import output_options, path_completion
from discostorm.cli.output import BadInput, Output, bad_input, print_table, show_slow_task, visible


@click.command()
@click.option(
    "--out",
    required=True,
    metavar="DIR",
    shell_complete=path_completion("dir"),
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
    with show_slow_task("loading"):
        from discostorm import figures as drawing
    paths = []
    files, count = drawing.save_all(Path(out)), len(drawing.FILES)
    while True:
        try:
            path = next(files, None)
        except OSError as error:
            message = f"--out must be a writable folder; got {_checks.shorten_name(out)!r}"
            raise BadInput(visible(f"{message}: {error.strerror}")) from error
        if path is None:
            break
        paths.append({"path": str(path)})
        line = f"[{len(paths):{len(str(count))}}/{count}] {path}"
        click.echo(visible(line), err=not output.for_people)
    if not output.for_people:
        print_table(paths, output)

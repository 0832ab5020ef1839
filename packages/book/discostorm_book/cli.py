"""The command ``discostorm claims``."""

from __future__ import annotations

import sys
from collections import Counter

import click

from discostorm.cli.options import output_options
from discostorm.cli.output import Output, is_live_terminal, print_table, show_slow_task
from discostorm.data import read_data

VERDICTS = [row["verdict"] for row in read_data("paper/verdicts.csv", "discostorm_book")]


@click.command()
@click.option("--verdict", type=click.Choice(VERDICTS), help="Show only claims with this verdict.")
@output_options
def claims(verdict: str | None, output: Output) -> None:
    """List the paper's claims with our results and verdicts.

    \b
    Examples:
      discostorm claims --verdict contradicted
      discostorm claims --csv > claims.csv
    """
    with show_slow_task("loading"):
        from discostorm_book.ledger import claims as ledger
    with click.progressbar(
        ledger.claims(), label="computing", file=sys.stderr, hidden=not is_live_terminal()
    ) as bar:
        rows = [row | {"ours": ledger.exact_quantity(row["ours"])} for row in map(ledger.row, bar)]
    counts = Counter(row["verdict"] for row in rows)
    chosen = [row for row in rows if verdict in (None, row["verdict"])]
    if output.for_people:
        shown = ("id", "where", "verdict", "statement")
        chosen = [{name: row[name] for name in shown} for row in chosen]
    print_table(chosen, output)
    if output.for_people:
        verdicts = ", ".join(f"{counts[verdict]} {verdict}" for verdict in VERDICTS)
        click.echo(f"\n{len(rows)} claims: {verdicts}.")

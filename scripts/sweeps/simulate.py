"""Simulate the sweeps that the chapters read, and write their tables to data/simulated/.

Every row is one setting: its options, then medians and quartiles over its runs. What has been
simulated is kept in build/simulate, by setting and by the sources of the simulator, so that what
is interrupted goes on where it stopped, and what has not changed is not done again.
"""

import argparse
import csv
import sys
from dataclasses import asdict

from sweep_ladder import decided, ladder
from sweep_others import (
    by_host,
    events,
    first_page_run,
    heard,
    mixed,
    saturation,
    user_data,
    waiting,
)
from sweep_setting import ROOT, SOURCE, Setting, path_of, result, table_path
from sweep_tables import SWEEPS, settings_of


def write(name: str, rows: list[dict[str, object]]) -> None:
    """Write one table."""
    path = table_path(name)
    columns: list[str] = []
    for row in rows:  # those of many runs have more columns
        for before, column in zip(["", *row], row, strict=False):
            if column not in columns:
                columns.insert(columns.index(before) + 1 if before else 0, column)
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, columns, lineterminator="\n", restval="")
        writer.writeheader()
        writer.writerows(rows)
    sys.stderr.write(f"{path.relative_to(ROOT)}: {len(rows)} rows\n")


def main() -> None:
    """Simulate what is missing and write the tables."""
    from tqdm import tqdm

    parser = argparse.ArgumentParser(prog="make simulate", description=__doc__)
    parser.add_argument(
        "--only", choices=[*SWEEPS, "air", "mixed", "user_data"], help="one table; default: all"
    )
    only = parser.parse_args().only
    wanted = {name: settings_of(name) for name in SWEEPS if only in (None, name)}
    todo = {one for settings in wanted.values() for one in settings if not path_of(one).exists()}

    # The short ones first.
    def size(one: Setting) -> tuple[int, int, str]:
        return one.hosts * one.processes, one.hosts, repr(one)

    for setting in tqdm(sorted(todo, key=size), "settings"):
        result(setting)
    if "fits" in wanted:
        wanted["fits"] = decided(wanted["fits"])
    for name, settings in wanted.items():
        write(name, [asdict(one) | result(one) | SOURCE for one in settings])
    if only in (None, "drain"):
        write("events", [row | SOURCE for row in events()])
        write("saturation", [row | SOURCE for row in saturation()])
    if only in (None, "air"):
        write("air", first_page_run())
    if only in (None, "user_data"):
        write("user_data", [row | SOURCE for row in user_data()])
    if only in (None, "mixed"):
        write("mixed", [row | SOURCE for row in mixed()])
    if only in (None, "queues"):
        write("hosts", [row | SOURCE for row in by_host()])
        write("heard", [row | SOURCE for row in heard()])
        write("waiting", [row | SOURCE for row in waiting()])
    if only in (None, "fits"):
        write("ladder", ladder([asdict(one) | result(one) for one in wanted["fits"]]))


if __name__ == "__main__":
    main()

"""Simulate the chapters' sweeps and write their tables to data/simulated/.

Every row is one setting: its options, then medians and quartiles over its runs. Results are cached
in build/simulate, by setting and engine, so that an interrupted sweep continues and unchanged
settings are not simulated again.
"""

import argparse
import csv
import sys
from dataclasses import asdict

from ladder_of_fleet_sizes import ladder_rows, settings_with_enough_runs
from single_simulations import (
    burst_transmissions,
    capture_effect,
    first_page_run,
    losses_by_host,
    mixed_traffic,
    queue_lengths,
    saturated_throughput,
    service_reply_wait,
    user_data_delays,
)
from sweep_definitions import SWEEPS, table_settings
from sweep_setting import ROOT, SOURCE, SweepSetting, cache_path, cached_result, table_path


def write_table(name: str, rows: list[dict[str, object]]) -> None:
    """Write one table."""
    path = table_path(name)
    columns: list[str] = []
    for row in rows:  # rows with many runs have more columns
        for before, column in zip(["", *row], row, strict=False):
            if column not in columns:
                columns.insert(columns.index(before) + 1 if before else 0, column)
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, columns, lineterminator="\n", restval="")
        writer.writeheader()
        writer.writerows(rows)
    sys.stderr.write(f"{path.relative_to(ROOT)}: {len(rows)} rows\n")


def main() -> None:
    """Simulate the missing settings and write the tables."""
    from tqdm import tqdm

    parser = argparse.ArgumentParser(prog="make simulate", description=__doc__)
    parser.add_argument(
        "--only",
        choices=[*SWEEPS, "air", "mixed", "services", "user_data"],
        help="one table; default: all",
    )
    only = parser.parse_args().only
    wanted = {name: table_settings(name) for name in SWEEPS if only in (None, name)}
    todo = {one for settings in wanted.values() for one in settings if not cache_path(one).exists()}

    # Start with the short runs.
    def size(one: SweepSetting) -> tuple[int, int, str]:
        return one.hosts * one.processes, one.hosts, repr(one)

    for setting in tqdm(sorted(todo, key=size), "settings"):
        cached_result(setting)
    if "fits" in wanted:
        wanted["fits"] = settings_with_enough_runs(wanted["fits"])
    for name, settings in wanted.items():
        write_table(name, [asdict(one) | cached_result(one) | SOURCE for one in settings])
    if only in (None, "drain"):
        write_table("events", [row | SOURCE for row in burst_transmissions()])
        write_table("saturation", [row | SOURCE for row in saturated_throughput()])
    if only in (None, "air"):
        write_table("air", first_page_run())
    if only in (None, "user_data"):
        write_table("user_data", [row | SOURCE for row in user_data_delays()])
    if only in (None, "services"):
        write_table("service_calls", [row | SOURCE for row in service_reply_wait()])
    if only in (None, "mixed"):
        write_table("mixed", [row | SOURCE for row in mixed_traffic()])
    if only in (None, "queues"):
        write_table("hosts", [row | SOURCE for row in losses_by_host()])
        write_table("heard", [row | SOURCE for row in capture_effect()])
        write_table("waiting", [row | SOURCE for row in queue_lengths()])
    if only in (None, "fits"):
        write_table(
            "ladder", ladder_rows([asdict(one) | cached_result(one) for one in wanted["fits"]])
        )


if __name__ == "__main__":
    main()

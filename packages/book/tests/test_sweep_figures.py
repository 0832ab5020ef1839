"""Test the chapters' figures of the stored sweeps."""

from collections.abc import Callable

import numpy as np
import pandas as pd
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

import discostorm as ds
from discostorm_book import sweeps
from discostorm_book.figures import burst, convergence

NAMES = {"DDS": "DDS, paper model", "Zenoh peer": "Zenoh peer"}
CHANGES = pd.DataFrame(
    {"DDS": [31, 26], "DDS_low": [29, 25], "DDS_high": [32, 27]}
    | {"Zenoh": [65, 20], "Zenoh_low": [64, 18], "Zenoh_high": [127, 21]},
    index=["as it is", "random starts"],
)
DRAWN: dict[str, Callable[[], Figure]] = {
    "frames": lambda: burst.first_transmissions(sweeps.load_sweep("events")),
    "drain": lambda: burst.drain_time_ratios(sweeps.drain_times()),
    "waiting": lambda: burst.waiting_frames(sweeps.load_sweep("waiting"), 7),
    "causes": lambda: burst.loss_causes(
        sweeps.load_sweep("queues").query("protocol == 'DDS' and hosts <= 30")
    ),
    "grid": lambda: convergence.times_by_robots(
        sweeps.load_sweep("convergence"), NAMES, (0.0, 0.3)
    ),
    "windows": lambda: convergence.times_by_window(
        sweeps.staggered_start_rows(start="random"),
        sweeps.staggered_start_rows(start="rule").assign(rule_s=5.0),
    ),
    "changes": lambda: convergence.effects_of_changes(CHANGES),
}


@pytest.mark.parametrize("name", DRAWN)
def test_a_figure_says_its_finding_and_stays_within_its_bounds(name: str) -> None:
    figure = DRAWN[name]()
    FigureCanvasAgg(figure).draw()
    assert figure._suptitle is not None  # type: ignore[attr-defined]
    assert len(figure._suptitle.get_text().split()) > 5  # type: ignore[attr-defined]
    inside, drawn = figure.bbox, figure.get_tightbbox().transformed(figure.dpi_scale_trans)
    assert drawn.x0 > inside.x0 - 1
    assert drawn.x1 < inside.x1 + 1


def test_the_formula_of_a_row_is_the_packages() -> None:
    rows = pd.DataFrame({"protocol": ["DDS", "Zenoh"], "hosts": [5, 7], "mpdus": [1, 64]})
    wanted = [
        ds.utilization(ds.DDS, 5, 2, 10, sweeps.sweep_channel()),
        ds.utilization(ds.ZENOH, 7, 2, 10, sweeps.sweep_channel(64)),
    ]
    assert np.allclose(sweeps.burst_airtimes(rows), wanted, rtol=1e-12)


def test_a_lone_station_of_bianchis_chain_waits_for_its_mean_backoff() -> None:
    wifi = sweeps.sweep_channel()
    assert wifi.radio is not None
    (rate,) = sweeps.bianchi_throughput([1], wifi, success=1e-3, collision=1e-3)
    assert rate == pytest.approx(1 / (1e-3 + 7.5 * wifi.radio.slot))


def test_largest_differences_are_rounded_up_and_whole_steps_kept() -> None:
    assert sweeps.round_up(2.01, 0.1) == pytest.approx(2.1)
    assert sweeps.round_up(2.0, 0.1) == pytest.approx(2.0)


def test_one_is_sooner_only_if_ranges_do_not_overlap() -> None:
    columns = ["convergence_time_s", "convergence_time_s_low", "convergence_time_s_high"]
    short, long, wide = (
        pd.Series(values, columns) for values in ([2.0, 1, 3], [8.0, 4, 9], [5.0, 2, 9])
    )
    assert sweeps.converges_sooner(short, long)
    assert not sweeps.converges_sooner(short, wide)
    assert sweeps.convergence_time_ratio(long, short) == pytest.approx((4, 4 / 3, 9))

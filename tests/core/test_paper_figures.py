"""Figs. 2-4: their data against formulas written here, their drawing, their files."""

from collections.abc import Callable
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import pytest
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

import discostorm as ds
from discostorm import figures


def frame(size: int) -> float:
    """Seconds of a unicast frame of so many bytes, up and down, with the paper's numbers."""
    return 2 * (8 * size / 144.4e6 + 180e-6)


def cast(size: int) -> float:
    """Seconds of a multicast frame: up as unicast, down once at the basic rate."""
    return frame(size) / 2 + 8 * size / 6e6 + 120e-6


def by_hand(
    protocol: str,
    phase: str,
    h: NDArray[np.float64],
    p: NDArray[np.float64],
    e: NDArray[np.float64],
) -> NDArray[np.float64]:
    pairs = h * (h - 1) * p**2
    phases = {
        "DDS": {
            "SPDP": h * p * cast(414),
            "SEDP": pairs * (e * frame(464) + 2 * frame(116) + 2 * frame(114)),
        },
        "Zenoh": {
            "Scouting": h * p * cast(80) + pairs * frame(144),
            "Declaration": pairs * (e * frame(176) + 2 * frame(84)),
        },
    }[protocol]
    return phases[phase] if phase != "total" else np.sum([*phases.values()], axis=0)


def test_the_figure_of_hosts_takes_other_robots_and_channels() -> None:
    wifi = ds.WIFI["802.11ax 80 MHz 2x2"]
    data = figures.fig2_data(4, 20, 8, "802.11ax 80 MHz")
    last = data[(data["hosts"] == 8) & (data["phase"] == "total")].set_index("protocol")
    assert last["utilization"].to_dict() == {
        name: ds.utilization(name, 8, 4, 20, wifi) for name in ("DDS", "Zenoh")
    }
    drawn = figures.fig2(4, 20, 8, wifi)
    assert drawn.axes[0].get_xlim() == (1, 8)
    assert drawn.axes[0].get_title() == "$N_P = 4$, $N_E = 20$"
    dds, zenoh = (ds.saturation_hosts(name, 4, 20, wifi) for name in ("DDS", "Zenoh"))
    assert drawn.get_suptitle().startswith(f"{dds:.2f} robots with DDS and {zenoh:.2f} with Zenoh")


def test_a_sweep_has_a_row_for_each_combination_of_named_axes() -> None:
    table = ds.sweep(
        protocol=["dds", ds.ZENOH], hosts=range(1, 4), processes=2, endpoints=10, wifi=ds.PAPER
    )
    axes = ["protocol", "hosts", "processes", "endpoints", "wifi"]
    assert [*table.columns] == [*axes, "utilization"]
    assert len(table) == 6
    for row in table.to_dict("records"):
        robots = (row["hosts"], row["processes"], row["endpoints"])
        assert row["utilization"] == ds.utilization(row["protocol"], *robots)
        assert row["wifi"] == ds.PAPER.name
    (panel,) = table[table["hosts"] > 1].plot().axes
    assert [line.get_label() for line in panel.lines] == ["dds", "Zenoh"]
    assert [[*line.get_xdata()] for line in panel.lines] == [[2, 3], [2, 3]]
    assert (panel.get_xlabel(), panel.get_ylabel()) == ("hosts", "utilization")


def test_a_sweep_takes_another_function_and_labels_of_values() -> None:
    fleets = {n: ds.Fleet.swarm(2, n, 10) for n in (1, 4)}
    table = ds.sweep(ds.saturation_hosts, protocol="dds", fleet=fleets)
    assert table["fleet"].tolist() == [1, 4]
    assert table["saturation_hosts"].tolist() == [ds.saturation_hosts("dds", n, 10) for n in (1, 4)]
    (panel,) = table.plot().axes
    assert (panel.get_xlabel(), panel.get_legend()) == ("fleet", None)


def test_steps_go_from_the_first_to_the_last() -> None:
    assert [*figures.smooth_steps(2, 3, per_one=4)] == [2, 2.25, 2.5, 2.75, 3]


@pytest.mark.parametrize(
    ("data", "hosts", "processes", "endpoints"),
    [(figures.fig2_data, 12, 2, 10), (figures.fig4_data, 5, 1, 678)],
    ids=["fig2", "fig4"],
)
def test_data_against_hosts_is_the_formula(
    data: Callable[[], pd.DataFrame], hosts: int, processes: int, endpoints: int
) -> None:
    rows = data()
    assert [*rows] == ["protocol", "phase", "hosts", "utilization"]
    assert {*zip(rows["protocol"], rows["phase"], strict=True)} == {
        ("DDS", "SPDP"),
        ("DDS", "SEDP"),
        ("DDS", "total"),
        ("Zenoh", "Scouting"),
        ("Zenoh", "Declaration"),
        ("Zenoh", "total"),
    }
    for (protocol, phase), part in rows.groupby(["protocol", "phase"]):
        h = part["hosts"].to_numpy()
        assert {*range(1, hosts + 1)} <= {*h}  # whole numbers are met exactly
        assert h.min() == 1
        assert h.max() == hosts
        hand = by_hand(str(protocol), str(phase), h, np.array(processes), np.array(endpoints))
        # Sums of a few float64 products: some rounding steps of 2e-16.
        np.testing.assert_allclose(part["utilization"], hand, rtol=1e-13)


def test_data_of_fig3_is_the_formula() -> None:
    rows = figures.fig3_data()
    assert [*rows] == ["protocol", "part", "processes", "endpoints", "utilization"]
    for protocol, part in rows.groupby("protocol"):
        hand = by_hand(
            str(protocol),
            "total",
            np.array(3.0),
            part["processes"].to_numpy(),
            part["endpoints"].to_numpy(),
        )
        np.testing.assert_allclose(part["utilization"], hand, rtol=1e-13)


def test_trajectory_of_fig3_keeps_the_endpoints_of_a_host() -> None:
    rows = figures.fig3_data()
    line = rows[rows["part"] == "trajectory"]
    np.testing.assert_allclose(line["processes"] * line["endpoints"], 40, rtol=1e-15)
    for ends in ((1, 40), (8, 5)):
        found = line[(line["processes"] == ends[0]) & (line["endpoints"] == ends[1])]
        assert [*found["protocol"]] == ["DDS", "Zenoh"]
    assert figures.even_process_counts() == [1, 2, 4, 5, 8, 10]


def test_surface_of_fig3_is_a_full_grid() -> None:
    rows = figures.fig3_data()
    surface = rows[rows["part"] == "surface"]
    assert [*surface["processes"].unique()] == [*range(1, 11)]
    assert [*surface["endpoints"].unique()] == [*range(0, 41, 2)]
    for _, part in surface.groupby("protocol"):
        assert len(part) == part["processes"].nunique() * part["endpoints"].nunique()


def test_saturation_is_marked_where_the_total_meets_the_limit() -> None:
    (axes,) = figures.fig2().axes
    marks = [np.ravel(line.get_xydata()) for line in axes.lines if line.get_marker() == "D"]
    assert panel_texts(axes, "full at") == ["full at 7.16 robots", "full at 7.63 robots"]
    for protocol, (hosts, height) in zip(("DDS", "Zenoh"), marks, strict=True):
        assert height == 1
        total = by_hand(protocol, "total", hosts, np.array(2), np.array(10))
        assert total == pytest.approx(1, rel=1e-12)


def panel_texts(axes: Axes, start: str = "") -> list[str]:
    """Return the texts of a panel, without line breaks."""
    texts = [" ".join(text.get_text().split()) for text in axes.texts]
    return [text for text in texts if text.startswith(start)]


@pytest.mark.parametrize("name", ["fig2", "fig4"])
def test_curves_are_named_at_their_ends_and_not_in_a_legend(name: str) -> None:
    panels = figures.FIGURES[name][1]().axes
    assert not any(axes.get_legend() for axes in panels)
    written = [text for axes in panels for text in panel_texts(axes)]
    for curve in ("DDS", "Zenoh", "dashed: SEDP", "dashed: Declaration", "SPDP", "Scouting"):
        assert written.count(curve) == 1, curve


@pytest.mark.parametrize("name", ["fig2", "fig4"])
def test_axes_are_those_of_the_paper(name: str) -> None:
    hosts, most = {"fig2": (12, 2), "fig4": (5, 4)}[name]
    axes = figures.FIGURES[name][1]().axes[0]
    assert (axes.get_xlim(), axes.get_ylim()) == ((1, hosts), (0, most))
    data = figures.FIGURES[name][0]()
    curves = [line for line in axes.lines if len(np.asarray(line.get_xdata())) > hosts]
    assert len(curves) == len(data.groupby(["protocol", "phase"]))


@pytest.mark.parametrize("name", figures.FIGURES)
def test_a_figure_is_drawn_once_for_each_file(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    drawn: list[Figure] = []
    draw = Figure.draw
    monkeypatch.setattr(Figure, "draw", lambda self, to: (drawn.append(self), draw(self, to)))
    files = list(figures.save(figures.FIGURES[name][1](), tmp_path, name))
    assert len(drawn) == len(files) == 3


def test_a_saved_figure_is_laid_out(tmp_path: Path) -> None:
    with figures.style():
        figure = Figure(figsize=(3, 2))
        axis = figure.subplots()
        axis.set_ylabel("three\nlines\nhigh")
    unplaced = axis.get_position().x0
    list(figures.save(figure, tmp_path, "small"))
    assert axis.get_position().x0 > unplaced
    assert axis.yaxis.label.get_window_extent().x0 >= 0


def test_pixels_are_two_hundred_an_inch(tmp_path: Path) -> None:
    figure = Figure(figsize=(1.5, 1))
    svg, pdf, png = figures.save(figure, tmp_path, "small")
    assert [path.suffix for path in (svg, pdf, png)] == [".svg", ".pdf", ".png"]
    assert plt.imread(png).shape[:2] == (200, 300)


def test_files_are_the_same_bytes_twice(tmp_path: Path) -> None:
    folders = [tmp_path / "made if missing" / "a", tmp_path / "b"]
    folders[1].mkdir()
    for folder in folders:
        paths = [*figures.save_all(folder)]
        assert [path.name for path in paths] == [*figures.FILES]
        assert (paths[0].name, paths[-1].name) == ("fig2.svg", "fig4.csv")
        assert {path.name for path in folder.iterdir()} == {*figures.FILES}
    for name in figures.FILES:
        first, second = ((folder / name).read_bytes() for folder in folders)
        assert first == second, name
        assert str(Path.cwd()).encode() not in first, name
    table = (folder / "fig2.csv").read_text(encoding="utf-8")
    assert table.startswith("protocol,phase,hosts,utilization\nDDS,SPDP,1.0,")


@pytest.mark.parametrize("name", figures.FIGURES)
def test_csv_holds_the_data_exactly(name: str, tmp_path: Path) -> None:
    data = figures.FIGURES[name][0]()
    data.to_csv(tmp_path / "data.csv", index=False, lineterminator="\n")
    read = pd.read_csv(tmp_path / "data.csv", dtype=str)
    # As text, since older versions of pandas read the last digit of a number wrongly.
    pd.testing.assert_frame_equal(
        read.astype({column: data[column].dtype for column in data}), data, check_exact=True
    )

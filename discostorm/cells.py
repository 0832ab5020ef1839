"""Cells: the access points of a fleet, each with a channel of its own."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations

from discostorm import _checks, _names
from discostorm.data import read_data
from discostorm.wifi.radio import AnyWifi, as_wifi

#: Largest channel number, in 6 GHz (IEEE Std 802.11ax-2021, Table E-4) [1].
MAX_CHANNEL = 233


@dataclass(frozen=True)
class Cell:
    """An access point and its channel; no other cell interferes with it.

    Parameters
    ----------
    name : str
        What groups call it: `HostGroup.cell`.
    wifi : Wifi, Radio or str
        Its channel, or a name such as "802.11ac 80 MHz"; kept as a `Wifi`.
    channel : int, optional
        Its number [1], from 1 to 233: two cells whose channels overlap share their airtime and are
        refused. Without a number, the cell is taken to have a channel of its own.
    """

    name: str
    wifi: AnyWifi
    channel: int | None = None

    def __post_init__(self) -> None:
        _checks.nonblank("name", self.name)
        with _checks.prefix_errors(f"cell {_checks.shorten_name(self.name)!r}"):
            object.__setattr__(self, "wifi", as_wifi(self.wifi))
            if self.channel is not None:
                _checks.integer("channel", self.channel, 1, MAX_CHANNEL)


def check_cells(cells: Sequence[Cell], groups: Sequence[tuple[str, str, bool]]) -> None:
    """Raise a ValueError unless cells and groups agree; a group is (name, cell, wired)."""
    names = [cell.name for cell in cells]
    _checks.distinct("cells", names)
    known = " or ".join(map(repr, names))
    for group, cell, wired in groups:
        if cell and (wired or not cells):
            why = "which is wired" if cells else "or defined in a [[cells]] table"
            raise ValueError(f"cell must be left out of {group}, {why}; got {cell!r}")
        if cell not in names and cells and not wired:
            got = f"{cell!r}{_names.did_you_mean(cell, names)}" if cell else "none"
            raise ValueError(f"cell of {group} must be {known}; got {got}")
    for name in names:
        if name not in [of for _, of, _ in groups]:
            raise ValueError(f"cell {name!r} must be used by a group; no group names it")
    for one, other in combinations([cell for cell in cells if cell.channel is not None], 2):
        (band, low, high), (also, least, most) = _band_and_channels(one), _band_and_channels(other)
        if band == also and low <= most and least <= high:
            named = [f"{cell.name} (channel {cell.channel})" for cell in (one, other)]
            raise ValueError(f"{' and '.join(named)} share airtime: make them one cell")


def _band_and_channels(cell: Cell) -> tuple[float, float, float]:
    """Return the band of a cell [GHz], and the first and last channel number that it covers."""
    radio, number = as_wifi(cell.wifi).radio, cell.channel or 0
    band, width = (radio.carrier or 0.0, radio.width) if radio else (0.0, 20e6)
    for row in read_data("wifi/channel_numbers.csv"):
        ghz, first, last, step, fixed = (float(row[name]) for name in [*row][:5])
        if (ghz == 6) == (band == 6e9) and first <= number <= last:
            if not fixed:  # a 40 MHz channel extends upwards or downwards
                more = (step - 1) * (width / 20e6 - 1)
                below, above = number - more >= first, number + more <= last
                return ghz, number - more * below, number + more * above + step - 1
            covered = step * width / 20e6
            low = number - (number - first) % covered
            return ghz, low, low + covered - 1
    return 0.0, number, number

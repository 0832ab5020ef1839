"""The palette: every color of figures, calculator, pages and ledger, from ``data/palette.csv``.

Style sheets and scripts of the book read the same colors from ``palette.css``, which `make palette`
writes. There, the custom property ``--ds-product-fast-dds`` is the color of Fast DDS.
"""

import re
from dataclasses import dataclass

from discostorm.data import read_data


@dataclass(frozen=True)
class Color:
    """A color of the palette: its group and key, and its hex codes on light and dark ground.

    Figures are drawn for light ground; the book's build draws them for dark ground, too.
    """

    group: str
    key: str
    light: str
    dark: str

    @property
    def property(self) -> str:
        """The custom property of style sheets, such as "--ds-product-fast-dds"."""
        return "--ds-" + re.sub(r"\W|_", "-", f"{self.group} {self.key}".lower())


PALETTE = {
    (row["group"], row["key"]): Color(row["group"], row["key"], row["light"], row["dark"])
    for row in read_data("palette.csv")
}


def light_colors(group: str) -> dict[str, str]:
    """Return the colors of a group on light ground by their keys, in the order of the file."""
    return {key: color.light for (of, key), color in PALETTE.items() if of == group}

"""Write the palette as a style sheet: `make palette`.

``book/_static/palette.css`` defines two custom properties for each color of
``discostorm/data/palette.csv``: for the light and for the dark theme.
"""

from pathlib import Path

from discostorm.palette import PALETTE

STYLE_SHEET_FILE = Path(__file__).parents[2] / "book/_static/palette.css"


def style_sheet_text() -> str:
    """Return the colors as CSS custom properties."""
    lines = ["/* Written by `make palette` from discostorm/data/palette.csv. */"]
    for theme in ("light", "dark"):
        lines += ["", f'html[data-theme="{theme}"] {{']
        lines += [f"  {one.property}: {getattr(one, theme).lower()};" for one in PALETTE.values()]
        lines += ["}"]
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    STYLE_SHEET_FILE.write_text(style_sheet_text(), encoding="utf-8")

"""Mend what the theme and the extensions write that a screen reader would tell wrongly."""

from pathlib import Path

from sphinx.application import Sphinx

_MENDED = {
    # A label that hides the text of the element: whoever speaks what they see is not understood.
    '<summary aria-label="Toggle hidden content">': "<summary>",
    'aria-label="Search" data-bs-placement="bottom" data-bs-toggle="tooltip">\n'
    '    <i class="fa-solid fa-magnifying-glass"></i>\n'
    '    <span class="search-button__default-text">': (
        'data-bs-placement="bottom" data-bs-toggle="tooltip">\n'
        '    <i class="fa-solid fa-magnifying-glass" aria-hidden="true"></i>\n'
        '    <span class="search-button__default-text">'
    ),
    # This button prints the page. The book's PDF is another file.
    '"btn__text-container">.pdf<': '"btn__text-container">print<',
    # A list has items; the role of an entry is deprecated in DPUB-ARIA 1.1.
    'role="doc-biblioentry"': 'role="listitem"',
}


def _mend(app: Sphinx, exception: Exception | None) -> None:
    if exception is None and app.builder.format == "html":
        for page in Path(app.outdir).rglob("*.html"):
            text = page.read_text(encoding="utf-8")
            for found, better in _MENDED.items():
                text = text.replace(found, better)
            page.write_text(text, encoding="utf-8")


def setup(app: Sphinx) -> dict[str, bool]:
    """Connect to Sphinx."""
    app.connect("build-finished", _mend)
    return {"parallel_read_safe": True, "parallel_write_safe": True}

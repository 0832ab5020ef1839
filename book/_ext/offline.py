"""Keep every page self-contained: nothing is loaded from elsewhere, over http or file://.

The style sheet brings its fonts along: one that comes later would break all lines anew.
"""

import re
from base64 import b64encode
from pathlib import Path
from typing import Any

from sphinx.application import Sphinx

# Written into the theme's template. From file:// browsers refuse them and log an error;
# the icons themselves come from a script, and the style sheet loads a font where needed.
_FONT_PRELOAD = re.compile(r'<link rel="preload" as="font"[^>]*>\n?')

# Live code would need a server: its settings are left out together with its script.
_LIVE_CODE = re.compile(
    r'<script type="text/x-thebe-config">.*?</script>\s*<script>.*?</script>', re.S
)


_FONT = re.compile(r'url\("(fonts/[\w.-]+\.woff2)"\)')


def _is_local(file: Any) -> bool:
    attributes = getattr(file, "attributes", {})
    text = f"{getattr(file, 'filename', file)} {attributes.get('body', '')}"
    return "://" not in text and "thebe" not in text


def _local_files_only(
    app: Sphinx, pagename: str, templatename: str, context: dict[str, Any], doctree: Any
) -> None:
    for kind in ("script_files", "css_files"):
        context[kind] = [file for file in context.get(kind, []) if _is_local(file)]
    if "body" in context:
        context["body"] = _LIVE_CODE.sub("", context["body"])


def _drop_font_preloads(app: Sphinx, exception: Exception | None) -> None:
    if exception is None and app.builder.format == "html":
        for page in Path(app.outdir).rglob("*.html"):
            text = page.read_text(encoding="utf-8")
            page.write_text(_FONT_PRELOAD.sub("", text), encoding="utf-8")


def _carry_fonts(app: Sphinx, exception: Exception | None) -> None:
    if exception is None and app.builder.format == "html":
        sheet = Path(app.outdir) / "_static" / "custom.css"

        def carried(found: re.Match[str]) -> str:
            content = b64encode((sheet.parent / found[1]).read_bytes()).decode()
            return f'url("data:font/woff2;base64,{content}")'

        text = sheet.read_text(encoding="utf-8")
        sheet.write_text(_FONT.sub(carried, text), encoding="utf-8")


def setup(app: Sphinx) -> dict[str, bool]:
    """Connect to Sphinx; late, so that the files of all extensions are seen."""
    app.connect("html-page-context", _local_files_only, priority=900)
    app.connect("build-finished", _drop_font_preloads)
    app.connect("build-finished", _carry_fonts)
    return {"parallel_read_safe": True, "parallel_write_safe": True}

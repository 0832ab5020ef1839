"""Addresses of pages that have moved lead to where their text is now: a page each, in HTML.

`book/moved.csv` says which; a row without an anchor is the whole page, one with an anchor a part of
it that went elsewhere. Any other anchor is the same on the new page.
"""

import csv
import json
import posixpath
from collections import defaultdict
from html import escape
from pathlib import Path

from sphinx.application import Sphinx

_PAGE = """<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="robots" content="noindex">
<title>This page has moved</title>
<link rel="canonical" href="{target}">
<script>
"use strict";
const elsewhere = {elsewhere};
const anchor = decodeURIComponent(location.hash.slice(1));
location.replace(elsewhere[anchor] || "{page}" + (location.hash || "{default}"));
</script>
<noscript><meta http-equiv="refresh" content="0; url={target}"></noscript>
</head>
<body><main><h1>This page has moved</h1><p><a href="{target}">It is here now.</a></p></main></body>
</html>
"""


def _write(app: Sphinx, error: Exception | None) -> None:
    if error or app.builder.name != "html":
        return
    with (Path(app.srcdir) / "book/moved.csv").open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    parts: dict[str, dict[str, str]] = defaultdict(dict)
    for row in rows:
        parts[row["page"]][row["anchor"]] = row["now"]
    for page, moved in parts.items():
        here = {
            anchor: posixpath.relpath(now, posixpath.dirname(page)) for anchor, now in moved.items()
        }
        target = here.pop("")
        path, _, default = target.partition("#")
        out = Path(app.outdir) / page
        if out.exists():
            raise ValueError(f"book/moved.csv: page {page} has moved, but there is one")
        out.write_text(
            _PAGE.format(
                target=escape(target),
                page=path,
                default=f"#{default}" if default else "",
                elsewhere=json.dumps(here),
            ),
            encoding="utf-8",
        )


def setup(app: Sphinx) -> dict[str, bool]:
    """Connect to Sphinx."""
    app.connect("build-finished", _write)
    return {"parallel_read_safe": True, "parallel_write_safe": True}

"""Leave private fields of classes out of the API reference: readers don't set them."""

import re
from typing import Any

from sphinx.application import Sphinx

_PRIVATE = re.compile(r"_\w+(, _\w+)*( : |$)")


def _shorten_signature(
    app: Sphinx, kind: str, name: str, of: Any, options: Any, signature: str, result: str
) -> tuple[str, str] | None:
    shown = re.sub(r", _\w+(?=[,)])", "", signature or "")
    return (shown, result) if shown != (signature or "") else None


def _drop_descriptions(
    app: Sphinx, kind: str, name: str, of: Any, options: Any, lines: list[str]
) -> None:
    shown, private = [], False
    for line in lines:
        if line[:1].strip():  # not what describes the parameter above
            private = bool(_PRIVATE.match(line))
        if not private or not line:
            shown.append(line)
    lines[:] = shown


def setup(app: Sphinx) -> dict[str, bool]:
    app.connect("autodoc-process-signature", _shorten_signature)
    app.connect("autodoc-process-docstring", _drop_descriptions, priority=400)  # before napoleon
    return {"parallel_read_safe": True, "parallel_write_safe": True}

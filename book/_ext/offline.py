"""Keep every page self-contained: drop scripts that the theme would load from elsewhere."""

from typing import Any

from sphinx.application import Sphinx


def _local_scripts_only(
    app: Sphinx, pagename: str, templatename: str, context: dict[str, Any], doctree: Any
) -> None:
    def is_local(script: Any) -> bool:
        name = str(getattr(script, "filename", script) or "")
        return "://" not in name and "thebe" not in name

    context["script_files"] = [
        script for script in context.get("script_files", []) if is_local(script)
    ]


def setup(app: Sphinx) -> dict[str, bool]:
    """Connect to Sphinx; late, so that the scripts of all extensions are seen."""
    app.connect("html-page-context", _local_scripts_only, priority=900)
    return {"parallel_read_safe": True, "parallel_write_safe": True}

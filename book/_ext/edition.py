"""Editions of the book say what they were made from."""

import subprocess
from os import PathLike
from pathlib import Path

import yaml  # type: ignore[import-untyped]
from sphinx.application import Sphinx
from sphinx.config import Config

import discostorm


def _commit(folder: str | PathLike[str]) -> str:
    """Return the commit that is checked out, or nothing outside of a git checkout."""
    done = subprocess.run(
        ["git", "describe", "--always", "--dirty", "--abbrev=8", "--exclude=*"],
        cwd=folder,
        capture_output=True,
        text=True,
        check=False,
    )
    return done.stdout.strip()


def _set_release(app: Sphinx, config: Config) -> None:
    commit = _commit(app.srcdir)
    config.version = discostorm.__version__
    config.release = f"{discostorm.__version__} ({commit})" if commit else config.version
    config.latex_elements["releasename"] = "Version"
    # The title page would name the day of the build.
    citation = yaml.safe_load(Path(app.srcdir, "CITATION.cff").read_text(encoding="utf-8"))
    config.today = f"{citation['date-released']:%B %-d, %Y}"


def setup(app: Sphinx) -> dict[str, bool]:
    """Connect to Sphinx."""
    app.connect("config-inited", _set_release)
    return {"parallel_read_safe": True, "parallel_write_safe": True}

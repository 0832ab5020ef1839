"""Links on every page: how to install, and the source, which is served if it has no address."""

import io
import subprocess
import tarfile
from multiprocessing import Process
from pathlib import Path
from typing import Any

from sphinx.application import Sphinx
from sphinx.errors import ConfigError, ExtensionError

import discostorm

ARCHIVE = f"discostorm-{discostorm.__version__}-source"
#: Outside of a git checkout: what was made, not written.
_MADE = {".venv", ".git", "_build", "build", "__pycache__"}


def _git(folder: Path, *arguments: str) -> str:
    done = subprocess.run(
        ["git", *arguments], cwd=folder, capture_output=True, text=True, check=False
    )
    return done.stdout


def _sources(folder: Path) -> list[Path]:
    """Return what is under version control; outside of a checkout, what was not made here."""
    listed = _git(folder, "ls-files", "-z").split("\0")[:-1]
    paths = (
        [folder / name for name in listed]
        if listed
        else [p for p in folder.rglob("*") if not _MADE & set(p.relative_to(folder).parts)]
    )
    return sorted(path for path in paths if path.is_file() and not path.is_symlink())


def _pack(folder: Path, path: Path) -> None:
    """Write the source archive, the same bytes every time."""
    time = int(_git(folder, "log", "-1", "--format=%ct").strip() or 0)
    with tarfile.open(path, "w:xz", preset=6) as archive:
        for source in _sources(folder):
            info = tarfile.TarInfo(f"{ARCHIVE}/{source.relative_to(folder).as_posix()}")
            content = source.read_bytes()
            info.size, info.mtime = len(content), time
            info.mode = 0o755 if source.stat().st_mode & 0o100 else 0o644
            archive.addfile(info, io.BytesIO(content))


#: It packs for seconds, and meanwhile pages are made.
_PACKING: list[Process] = []


def _start(app: Sphinx) -> None:
    if app.builder.format == "html" and not _address(app):
        path = Path(app.outdir) / f"{ARCHIVE}.tar.xz"
        path.parent.mkdir(parents=True, exist_ok=True)
        _PACKING.append(Process(target=_pack, args=(Path(app.srcdir), path)))
        _PACKING[-1].start()


def _finish(app: Sphinx, exception: Exception | None) -> None:
    for process in _PACKING:
        process.join()
        if process.exitcode and exception is None:
            raise ExtensionError("the source archive could not be packed; why stands above")


def _address(app: Sphinx) -> str:
    return str(app.config.html_theme_options.get("repository_url") or "")


def _add(
    app: Sphinx, pagename: str, templatename: str, context: dict[str, Any], doctree: Any
) -> None:
    labels = app.env.domaindata["std"]["anonlabels"]
    if "install" not in labels:
        raise ConfigError("no page has the label (install)=, which every page links to")
    page, anchor = labels["install"]
    context["install_url"] = f"{context['pathto'](page).removesuffix('#')}#{anchor}"
    context["source_is_online"] = bool(_address(app))
    context["source_url"] = _address(app) or context["pathto"](f"{ARCHIVE}.tar.xz", 1)
    # The landing page is called by what it is, the others by their own name and the book's.
    if pagename == app.config.root_doc:
        context["title"] = context["docstitle"]
        context["docstitle"] = ""
    else:
        context["docstitle"] = app.config.html_short_title


def setup(app: Sphinx) -> dict[str, bool]:
    """Connect to Sphinx."""
    app.connect("html-page-context", _add)
    app.connect("builder-inited", _start)
    app.connect("build-finished", _finish)
    return {"parallel_read_safe": True, "parallel_write_safe": True}

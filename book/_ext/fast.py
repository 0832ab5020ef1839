"""Build faster: parallel pages, prestarted kernels, and each page read once for all references."""

import os
import sys
from contextlib import ExitStack
from functools import cache
from pathlib import Path
from typing import Any
from uuid import uuid4

import jupyter_client.manager
from docutils import nodes
from sphinx.addnodes import pending_xref
from sphinx.application import Sphinx
from sphinx.builders import Builder
from sphinx.domains.std import StandardDomain
from sphinx.environment import BuildEnvironment

sys.path.append(str(Path(__file__).parents[2] / "scripts" / "book"))

from prestarted_notebook_kernels import prestarted_kernels, short_folder

_KERNELS = ExitStack()


class _Read:
    """The environment, which reads each document once; its readers change nothing in it."""

    def __init__(self, env: BuildEnvironment) -> None:
        self._env = env
        self.get_doctree = cache(env.get_doctree)

    def __getattr__(self, name: str) -> Any:
        return getattr(self._env, name)


class _Standard(StandardDomain):
    """The standard domain, which looks up each number in the whole document that has it."""

    _read: Any = None

    def resolve_xref(
        self,
        env: BuildEnvironment,
        fromdocname: str,
        builder: Builder,
        typ: str,
        target: str,
        node: pending_xref,
        contnode: nodes.Element,
    ) -> nodes.Element | None:
        if typ == "numref":
            self._read = self._read or _Read(env)
            env = self._read
        return super().resolve_xref(env, fromdocname, builder, typ, target, node, contnode)


class _SocketKernelManager(jupyter_client.manager.AsyncKernelManager):
    """Kernels on Unix sockets: another kernel could take a TCP port in the meantime."""

    folder = ""

    def __init__(self, **options: Any) -> None:
        file = f"{self.folder}/{uuid4().hex}.json"
        super().__init__(transport="ipc", connection_file=file, **options)


def _start(app: Sphinx) -> None:
    _KERNELS.enter_context(prestarted_kernels())
    if sys.platform != "win32":
        _SocketKernelManager.folder = _KERNELS.enter_context(short_folder())
        jupyter_client.AsyncKernelManager = _SocketKernelManager  # type: ignore[attr-defined]


def _declare(app: Sphinx, env: BuildEnvironment, names: list[str]) -> None:
    # It numbers pages after they have been read, but does not declare it.
    app.extensions["sphinx_multitoc_numbering"].parallel_read_safe = True


def _stop(app: Sphinx, exception: Exception | None) -> None:
    _KERNELS.close()


def setup(app: Sphinx) -> dict[str, bool]:
    """Connect to Sphinx."""
    app.parallel = os.cpu_count() or 1
    app.add_domain(_Standard, override=True)
    app.connect("builder-inited", _start)
    app.connect("env-before-read-docs", _declare)
    app.connect("build-finished", _stop, priority=100)
    return {"parallel_read_safe": True, "parallel_write_safe": True}

"""Warm kernels: copies of one process that has imported everything that chapters need.

Inside `warm_kernels`, the kernel "python3" is such a copy. A kernel specification names this
script, which asks the process with the imports for a copy and waits for its end. A cold kernel
takes longer to start than half of the chapters take to run.
"""

import json
import os
import select
import signal
import socket
import sys

SAID = "what kernels import at their start wrote to standard error:\n"
#: Not `matplotlib_inline`, which arranges the display of figures where there is a kernel.
MODULES = (
    "ipykernel.kernelapp",
    "ipykernel.ipkernel",
    "IPython.core.pylabtools",
    "matplotlib.backends.backend_svg",
    "matplotlib.pyplot",
    "sympy",
    "tabulate",
    "discostorm_capture",
    "discostorm.cli.main",
    "discostorm.figures",
    "discostorm.measured",
    "discostorm_book.ledger.claims",
    "discostorm_planner",
    "discostorm_planner.staggered",
    "discostorm.uncertainty",
)
# Kernels ask through `ask`, which starts for each of them: what only others need is imported there.
if __name__ != "__main__":
    import subprocess
    import tempfile
    from collections.abc import Iterator
    from contextlib import contextmanager
    from pathlib import Path

    def short_folder() -> tempfile.TemporaryDirectory[str]:
        """Return a folder for sockets: their paths have 107 bytes; TMPDIR may be too long."""
        folder = "/tmp" if os.access("/tmp", os.W_OK) else None
        return tempfile.TemporaryDirectory(prefix="kernel-", dir=folder)

    @contextmanager
    def warm_kernels() -> Iterator[None]:
        """Let kernels start warm on Linux; elsewhere they start cold."""
        if sys.platform != "linux":
            yield
            return
        with short_folder() as folder, socket.socket(socket.AF_UNIX) as listener:
            listener.bind(f"{folder}/asked")
            listener.listen(100)
            specification = Path(folder, "kernels", "python3", "kernel.json")
            specification.parent.mkdir(parents=True)
            asking = [sys.executable, "-IS", __file__, f"{folder}/asked", "-f", "{connection_file}"]
            names = {"display_name": "Python 3 (ipykernel)", "language": "python"}
            specification.write_text(json.dumps({"argv": asking, **names}), encoding="utf-8")
            number = listener.fileno()
            # Without this script's folder, from which a chapter imports nothing.
            serving = [sys.executable, "-P", __file__, str(number)]
            before = os.environ.get("JUPYTER_PATH")
            os.environ["JUPYTER_PATH"] = folder + (f"{os.pathsep}{before}" if before else "")
            try:
                # It ends when its input does, however that comes.
                with subprocess.Popen(serving, stdin=subprocess.PIPE, pass_fds=[number]):
                    listener.close()  # a kernel must not wait for it once it has failed
                    yield
            finally:
                if before is None:
                    del os.environ["JUPYTER_PATH"]
                else:
                    os.environ["JUPYTER_PATH"] = before


def request_kernel(path: str, arguments: list[str]) -> int:
    """Ask the server for a kernel; return its exit status when it has ended."""
    # Kernels are interrupted before they are told to end, which they do all the same.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    cwd = os.getcwd()  # noqa: PTH109 - pathlib takes longer to import than this runs
    wanted = {"argv": arguments, "cwd": cwd, "env": dict(os.environ)}
    with socket.socket(socket.AF_UNIX) as link:
        link.connect(path)
        link.sendall(json.dumps(wanted).encode() + b"\n")
        answer = link.recv(16)
    return int(answer or 1)


def import_modules() -> None:
    """Import the modules; skip one that fails, as its cell will show the error."""
    import contextlib
    import gc
    import importlib
    import io

    # As kernels set it for themselves, for Matplotlib reads it once.
    os.environ["MPLBACKEND"] = "module://matplotlib_inline.backend_inline"
    with contextlib.redirect_stderr(io.StringIO()) as said:
        for name in MODULES:
            with contextlib.suppress(Exception):
                importlib.import_module(name)
    # In a cell, too, it would be a failure.
    if said.getvalue():
        sys.exit(f"{SAID}{said.getvalue()}")
    gc.freeze()


def fork_process() -> int:
    """Return the new process's number in the parent, and 0 in the child."""
    import warnings

    with warnings.catch_warnings():
        # Of threads: those of NumPy's library know how to be copied, and there are no others.
        warnings.simplefilter("ignore", DeprecationWarning)
        return os.fork()


def serve_forks(listener: socket.socket) -> list[str]:
    """Fork on each request; return in the children, with their arguments."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGCHLD, signal.SIG_IGN)  # processes that `watch` need no wait
    while True:
        ready, _, _ = select.select([listener, sys.stdin], [], [])
        if sys.stdin in ready:
            os._exit(0)
        link, _ = listener.accept()
        if fork_process() == 0:
            listener.close()
            signal.signal(signal.SIGCHLD, signal.SIG_DFL)
            return supervise(link)
        link.close()


def supervise(link: socket.socket) -> list[str]:
    """Start a kernel and end it when the process that asked for it has ended."""
    import contextlib

    with link.makefile("r", encoding="utf-8") as asked:
        wanted = json.loads(asked.readline())
    lives, held = os.pipe()
    kernel = fork_process()
    if kernel:
        os.close(held)
        # Until who asked, the kernel, or who entered `warm_kernels` has ended.
        select.select([link.fileno(), lives, sys.stdin.fileno()], [], [])
        with contextlib.suppress(ProcessLookupError):  # it has not come as far as its own group
            os.killpg(kernel, signal.SIGKILL)
        with contextlib.suppress(ProcessLookupError):
            os.kill(kernel, signal.SIGKILL)
        _, status = os.waitpid(kernel, 0)
        with contextlib.suppress(OSError):  # who asked has ended
            link.sendall(b"%d" % os.waitstatus_to_exitcode(status))
        os._exit(0)
    link.close()
    os.close(lives)
    os.setsid()
    signal.signal(signal.SIGINT, signal.default_int_handler)
    os.dup2(os.open(os.devnull, os.O_RDONLY), 0)
    os.chdir(wanted["cwd"])
    os.environ.clear()
    os.environ.update(wanted["env"])
    arguments: list[str] = wanted["argv"]
    return arguments


def main(where: str, *arguments: str) -> None:
    """Ask for a kernel at a path, or be what is copied, with the number of an open socket."""
    if arguments:
        sys.exit(request_kernel(where, list(arguments)))
    import_modules()
    with socket.socket(fileno=int(where)) as listener:
        words = serve_forks(listener)
    # Read from the environment on import, which was too early.
    parent = f"--IPKernelApp.parent_handle={os.getppid()}"
    sys.argv = ["ipykernel_launcher.py", *words, parent]
    from ipykernel import kernelapp

    kernelapp.launch_new_instance()


if __name__ == "__main__":
    main(*sys.argv[1:])

"""Start notebook kernels ahead: copies of a process that has imported the chapters' modules.

Within `prestarted_kernels`, the kernel "python3" is such a copy. Its kernel specification names
this script, which requests a copy from the server process and waits for its end. Starting a cold
kernel takes longer than running half of the chapters.
"""

import json
import os
import select
import signal
import socket
import sys

IMPORT_ERRORS = "what kernels import at their start wrote to standard error:\n"
#: Without `matplotlib_inline`, which needs a running kernel to set up its display.
PRELOADED_MODULES = (
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
    "discostorm.prediction_error",
    "discostorm_book.ledger.claims",
    "discostorm_planner",
    "discostorm_planner.staggered_start",
    "discostorm.uncertainty",
)
# Each kernel starts this script through `request_kernel`, so other imports stay in functions.
if __name__ != "__main__":
    import subprocess
    import tempfile
    from collections.abc import Iterator
    from contextlib import contextmanager
    from pathlib import Path

    def short_folder() -> tempfile.TemporaryDirectory[str]:
        """Return a folder for sockets, whose paths may have at most 107 bytes."""
        folder = "/tmp" if os.access("/tmp", os.W_OK) else None
        return tempfile.TemporaryDirectory(prefix="kernel-", dir=folder)

    @contextmanager
    def prestarted_kernels() -> Iterator[None]:
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
            # Remove this script's folder from the path, because chapters do not import from it.
            serving = [sys.executable, "-P", __file__, str(number)]
            before = os.environ.get("JUPYTER_PATH")
            os.environ["JUPYTER_PATH"] = folder + (f"{os.pathsep}{before}" if before else "")
            try:
                # The server ends when its standard input ends, for whatever reason.
                with subprocess.Popen(serving, stdin=subprocess.PIPE, pass_fds=[number]):
                    listener.close()  # after a failure, a kernel must not wait here
                    yield
            finally:
                if before is None:
                    del os.environ["JUPYTER_PATH"]
                else:
                    os.environ["JUPYTER_PATH"] = before


def request_kernel(path: str, arguments: list[str]) -> int:
    """Request a kernel from the server; return its exit status when the kernel has ended."""
    # Jupyter interrupts kernels before it stops them; ignore that signal here.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    cwd = os.getcwd()  # noqa: PTH109 - pathlib takes longer to import than this runs
    wanted = {"argv": arguments, "cwd": cwd, "env": dict(os.environ)}
    with socket.socket(socket.AF_UNIX) as link:
        link.connect(path)
        link.sendall(json.dumps(wanted).encode() + b"\n")
        answer = link.recv(16)
    return int(answer or 1)


def import_modules() -> None:
    """Import the modules; skip a failing module, because its cell will show the error."""
    import contextlib
    import gc
    import importlib
    import io

    # Kernels set this variable, too; Matplotlib reads it only once.
    os.environ["MPLBACKEND"] = "module://matplotlib_inline.backend_inline"
    with contextlib.redirect_stderr(io.StringIO()) as said:
        for name in PRELOADED_MODULES:
            with contextlib.suppress(Exception):
                importlib.import_module(name)
    # A warning would be a failure in a cell, too.
    if said.getvalue():
        sys.exit(f"{IMPORT_ERRORS}{said.getvalue()}")
    gc.freeze()


def fork_process() -> int:
    """Fork this process; return the child's process id in the parent, and 0 in the child."""
    import warnings

    with warnings.catch_warnings():
        # The warning is about threads: only NumPy's library has some, and those survive a fork.
        warnings.simplefilter("ignore", DeprecationWarning)
        return os.fork()


def serve_forks(listener: socket.socket) -> list[str]:
    """Fork on each request; return in the child, with the kernel's arguments."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGCHLD, signal.SIG_IGN)  # no zombies of `run_kernel_until_parent_ends`
    while True:
        ready, _, _ = select.select([listener, sys.stdin], [], [])
        if sys.stdin in ready:
            os._exit(0)
        link, _ = listener.accept()
        if fork_process() == 0:
            listener.close()
            signal.signal(signal.SIGCHLD, signal.SIG_DFL)
            return run_kernel_until_parent_ends(link)
        link.close()


def run_kernel_until_parent_ends(link: socket.socket) -> list[str]:
    """Start a kernel; kill the kernel when the requesting process has ended."""
    import contextlib

    with link.makefile("r", encoding="utf-8") as asked:
        wanted = json.loads(asked.readline())
    lives, held = os.pipe()
    kernel = fork_process()
    if kernel:
        os.close(held)
        # Wait for the end of the requesting process, the kernel, or the server's creator.
        select.select([link.fileno(), lives, sys.stdin.fileno()], [], [])
        with contextlib.suppress(ProcessLookupError):  # it has no process group yet
            os.killpg(kernel, signal.SIGKILL)
        with contextlib.suppress(ProcessLookupError):
            os.kill(kernel, signal.SIGKILL)
        _, status = os.waitpid(kernel, 0)
        with contextlib.suppress(OSError):  # the requester has ended
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
    """Request a kernel at a socket's path, or serve kernels on an open socket's number."""
    if arguments:
        sys.exit(request_kernel(where, list(arguments)))
    import_modules()
    with socket.socket(fileno=int(where)) as listener:
        words = serve_forks(listener)
    # The import of these modules read the environment too early, so set the values again.
    parent = f"--IPKernelApp.parent_handle={os.getppid()}"
    sys.argv = ["ipykernel_launcher.py", *words, parent]
    from ipykernel import kernelapp

    kernelapp.launch_new_instance()


if __name__ == "__main__":
    main(*sys.argv[1:])

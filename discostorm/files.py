"""Read and write users' files safely, and prepare values for JSON."""

import errno
import math
import os
import shutil
import stat
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path
from tempfile import TemporaryDirectory
from threading import Thread
from typing import Any, BinaryIO

#: Maximum time to wait for a writer of a pipe [s].
PIPE_WAIT_S = 2.0


def atomic_write(path: Path, content: bytes) -> None:
    """Replace the whole content of a file; if that fails, leave the file unchanged.

    Links are followed, and the file keeps its mode and owner. A device, a pipe, or the file that
    this program prints to is written in place: replacing it would remove it for other programs.
    """
    try:
        status = path.stat()
    except FileNotFoundError:
        status = None
    descriptor = None if status is None else _open_in_place(path, status)
    if descriptor is None:
        _write_and_rename(path.resolve(), status, content)
    else:
        with os.fdopen(descriptor, "wb") as file:
            file.write(content)


def _open_in_place(path: Path, status: os.stat_result) -> int | None:
    """Return a descriptor of a file that must be written in place; None for any other file."""
    for stream in (1, 2):
        with suppress(OSError):  # closed
            if os.path.samestat(os.fstat(stream), status):
                return os.dup(stream)
    return None if stat.S_ISREG(status.st_mode) else os.open(path, os.O_WRONLY)


def _write_and_rename(path: Path, status: os.stat_result | None, content: bytes) -> None:
    part = path.with_name(f".{path.name}.{os.getpid()}.part")
    part.unlink(missing_ok=True)
    try:
        part.touch(exist_ok=False)  # do not follow a link of another user
        if status is not None:
            if not os.access(path, os.W_OK):
                raise PermissionError(errno.EACCES, os.strerror(errno.EACCES), str(path))
            with suppress(OSError, AttributeError):  # only root may give files away
                shutil.chown(part, status.st_uid, status.st_gid)
            part.chmod(stat.S_IMODE(status.st_mode))
        part.write_bytes(content)
        part.replace(path)
    finally:
        part.unlink(missing_ok=True)


def write_folder(path: Path, files: Mapping[str, str], *, replace: bool = False) -> None:
    """Write files, named by their paths in a folder, all of them or none.

    Raise a ValueError if the path is no folder or, without ``replace``, if a file exists.
    """
    if path.exists() and not path.is_dir():
        raise ValueError(f"{path} must be a folder, or not exist; it is a file")
    folder = path.resolve()
    if not folder.parent.is_dir():
        raise ValueError(f"{folder.parent} must be a folder, to hold {folder.name}; make it first")
    if not replace and (there := [name for name in files if os.path.lexists(folder / name)]):
        raise ValueError(f"{path / there[0]} exists; choose another folder, or replace its files")
    with TemporaryDirectory(dir=folder.parent, prefix=f".{folder.name}.") as hold:
        new, old = Path(hold) / "new", Path(hold) / "old"
        if folder.is_dir():
            shutil.copytree(folder, new, symlinks=True)
        for name, text in files.items():
            file = new / name
            file.parent.mkdir(parents=True, exist_ok=True)
            file.unlink(missing_ok=True)  # not through a link
            file.write_text(text, encoding="utf-8", newline="\n")
        if not folder.is_dir():
            new.rename(folder)
            return
        folder.rename(old)
        try:
            new.rename(folder)
        except BaseException:
            old.rename(folder)
            raise


def open_input(path: str | os.PathLike[str]) -> BinaryIO:
    """Open a file or a pipe to read its bytes; refuse devices, and pipes without a writer."""
    file = Path(path)
    mode = file.stat().st_mode
    if stat.S_ISCHR(mode) or stat.S_ISBLK(mode):
        raise OSError(errno.EINVAL, "is a device; give a file, or - for standard input", str(path))
    if not stat.S_ISFIFO(mode):
        return file.open("rb")
    opened: list[BinaryIO] = []
    thread = Thread(target=lambda: opened.append(file.open("rb")), daemon=True)
    thread.start()
    thread.join(PIPE_WAIT_S)  # opening a pipe waits for its writer
    if not opened:
        raise OSError(errno.ENXIO, "no program writes to this pipe", str(path))
    return opened[0]


def json_ready(value: Any) -> Any:
    """Return a value for JSON: arrays become lists, infinity and NaN become None."""
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, Mapping):
        return {key: json_ready(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [json_ready(item) for item in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value

"""Test output files, which replace nothing but files, and input that may not end."""

import json
import os
import stat
import subprocess
import sys
import threading
from pathlib import Path

import click
import pytest
from click.testing import CliRunner

import discostorm as ds
from discostorm import figures, files
from discostorm.cli import main, output

GROUP = b"[[groups]]\nhosts = 2\nprocesses = 1\nendpoints = 5\n"


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


def make_device(path: Path, minor: int) -> None:
    """Make a node like /dev/null (3) or /dev/zero (5) where only this test uses it."""
    try:
        os.mknod(path, stat.S_IFCHR | 0o666, os.makedev(1, minor))
        path.write_bytes(b"")
    except OSError:
        pytest.skip("only root may make devices here")


def test_a_device_stays_a_device(folder: Path) -> None:
    device = folder / "null"
    make_device(device, 3)
    files.atomic_write(device, b"gone")
    assert stat.S_ISCHR(device.stat().st_mode)
    link = folder / "link"
    link.symlink_to(device)
    files.atomic_write(link, b"gone")
    assert link.is_symlink()
    assert stat.S_ISCHR(device.stat().st_mode)


def test_a_pipe_gets_the_content(folder: Path) -> None:
    pipe = folder / "pipe"
    os.mkfifo(pipe)
    received: list[bytes] = []
    reader = threading.Thread(target=lambda: received.append(pipe.read_bytes()))
    reader.start()
    files.atomic_write(pipe, b"content")
    reader.join()
    assert received == [b"content"]
    assert stat.S_ISFIFO(pipe.stat().st_mode)


def test_links_are_followed_and_the_mode_stays(folder: Path) -> None:
    (folder / "sub").mkdir()
    target, link = folder / "sub" / "target", folder / "link"
    target.write_bytes(b"old")
    target.chmod(0o640)
    link.symlink_to("sub/target")
    files.atomic_write(link, b"new")
    assert (link.is_symlink(), target.read_bytes()) == (True, b"new")
    assert stat.S_IMODE(target.stat().st_mode) == 0o640
    dangling = folder / "dangling"
    dangling.symlink_to("sub/made")
    files.atomic_write(dangling, b"made")
    assert (dangling.is_symlink(), (folder / "sub" / "made").read_bytes()) == (True, b"made")
    umask = os.umask(0o022)
    os.umask(umask)
    assert stat.S_IMODE((folder / "sub" / "made").stat().st_mode) == 0o666 & ~umask


def test_a_file_is_written_whole_or_not_at_all(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = folder / "file"
    path.write_bytes(b"good")

    def full(self: Path, _: bytes) -> int:
        self.write_text("ba")
        raise OSError(28, "No space left on device")

    with monkeypatch.context() as patch:
        patch.setattr(Path, "write_bytes", full)
        with pytest.raises(OSError, match="No space left"):
            files.atomic_write(path, b"better")
    assert path.read_bytes() == b"good"
    files.atomic_write(path, b"better")
    assert path.read_bytes() == b"better"
    assert [each.name for each in folder.iterdir()] == ["file"]
    with pytest.raises(IsADirectoryError):
        files.atomic_write(folder, b"")


def test_the_file_that_is_printed_to_is_appended_to(folder: Path) -> None:
    code = (
        "import sys; from pathlib import Path; from discostorm.files import atomic_write\n"
        "print('before', flush=True); atomic_write(Path('/dev/stdout'), b'file\\n'); print('after')"
    )
    with (folder / "printed").open("wb") as printed:
        subprocess.run([sys.executable, "-c", code], stdout=printed, check=True)
    assert (folder / "printed").read_text() == "before\nfile\nafter\n"


def test_the_input_is_never_written(folder: Path) -> None:
    source = folder / "source"
    source.write_bytes(b"input")
    (folder / "link").symlink_to("source")
    for name in ("source", "link", str(source)):
        with pytest.raises(
            click.ClickException, match=r"--out: .* is the input; name another file"
        ):
            output.write_file("--out", name, b"gone", None, "source")
    with pytest.raises(click.ClickException, match="--out: - is not a file"):
        output.write_file("--out", "-", b"")
    with pytest.raises(click.ClickException, match="--out: x/y: No such file or directory"):
        output.write_file("--out", "x/y", b"")
    code = "from discostorm.cli.output import write_file; write_file('--out', 'source', b'', '-')"
    with source.open("rb") as standard_input:
        done = subprocess.run(
            [sys.executable, "-c", code], stdin=standard_input, capture_output=True, check=False
        )
    assert b"source is the input" in done.stderr
    assert source.read_bytes() == b"input"
    output.write_file("--out", "other", b"new", "source", "missing")
    assert (folder / "other").read_bytes() == b"new"


def test_figures_are_written_into_links_and_devices(folder: Path) -> None:
    (folder / "out").mkdir()
    (folder / "target.svg").write_text("old")
    (folder / "out" / "fig2.svg").symlink_to("../target.svg")
    make_device(folder / "out" / "fig2.pdf", 3)
    svg, pdf, _ = figures.save(figures.fig2(), folder / "out", "fig2")
    assert svg.is_symlink()
    assert (folder / "target.svg").read_text(encoding="utf-8").startswith("<?xml")
    assert stat.S_ISCHR(pdf.stat().st_mode)


def test_a_figure_that_cannot_be_written_is_told(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(*_: object, **__: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("discostorm.figures.atomic_write", full)
    result = CliRunner().invoke(main, ["figures", "--out", "out"])
    assert result.exit_code == 2
    assert "--out must be a writable folder; got 'out': No space left" in result.stderr
    assert not list((folder / "out").iterdir())


# Fleet files


def refused(name: str) -> str:
    result = CliRunner().invoke(main, ["utilization", name])
    assert (result.exit_code, result.stdout) == (2, "")
    assert len(result.stderr.splitlines()) == 1
    return result.stderr


def test_a_fleet_file_that_never_ends_is_refused(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(files, "PIPE_WAIT_S", 0.05)
    os.mkfifo(folder / "pipe")
    assert "pipe: no program writes to this pipe" in refused("pipe")
    make_device(folder / "zero", 5)
    assert "zero: is a device; give a file, or - for standard input" in refused("zero")


def test_a_fleet_file_may_be_a_pipe(folder: Path) -> None:
    os.mkfifo(folder / "pipe")
    writer = threading.Thread(target=lambda: (folder / "pipe").write_bytes(GROUP))
    writer.start()
    assert ds.Fleet.from_toml(folder / "pipe").hosts() == 2
    writer.join()


def test_a_fleet_file_has_a_limit(folder: Path) -> None:
    (folder / "large").write_bytes(GROUP + b"#" * 1_000_000)
    assert "large must be a TOML file of at most 1,000,000 bytes" in refused("large")
    result = CliRunner().invoke(main, ["utilization", "-"], input=GROUP + b"#" * 1_000_000)
    assert "standard input must be a TOML file of at most" in result.stderr
    (folder / "dotted").write_bytes(b".".join([b"a"] * 100_000) + b" = 1")
    assert "dotted must be a TOML file with at most 256 dots per line" in refused("dotted")
    assert ds.Fleet.from_bytes(GROUP + b"#" * (1_000_000 - len(GROUP)), "x").hosts() == 2


# Packages that are not installed


MISSING = {"plan": "planner", "simulate": "simulation", "read_capture": "capture"}


@pytest.mark.parametrize(("name", "extra"), MISSING.items())
def test_a_function_of_a_missing_package_names_the_line_to_type(
    name: str, extra: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delitem(vars(ds), name, raising=False)
    monkeypatch.setitem(sys.modules, f"discostorm_{extra}", None)
    with pytest.raises(ImportError, match=rf"pip install 'discostorm\[{extra}\]'"):
        getattr(ds, name)


def test_help_lists_what_is_installed_and_how_to_get_the_rest(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    from discostorm.cli import main as command
    from discostorm.cli.main import installed_commands

    own = {
        name: point
        for name, point in installed_commands().items()
        if point.module.startswith("discostorm.")
    }
    assert sorted(own) == ["breakdown", "figures", "robots", "saturation", "utilization"]
    monkeypatch.setattr(sys.modules["discostorm.cli.main"], "installed_commands", lambda: own)
    commands, rest = CliRunner().invoke(command, ["--help"]).output.split("Not installed:")
    for name in own:
        assert f"  {name} " in commands
    lines = dict(line.split(maxsplit=1) for line in rest.splitlines() if "pip" in line)
    assert lines == {
        name: f"pip install 'discostorm[{extra}]'"
        for name, extra in {
            "capture": "capture", "claims": "book", "fleet": "planner", "plan": "planner",
            "simulate": "simulation", "watch": "capture",
        }.items()
    }  # fmt: skip
    result = CliRunner().invoke(command, ["capture", "x.pcap"])
    assert result.exit_code == 2
    assert result.stderr.splitlines()[-1] == (
        "Error: 'capture' is not installed; to get it: pip install 'discostorm[capture]'"
    )


# One host, no Wi-Fi, narrow terminals, a home that cannot be written

WIRED = "[[groups]]\nhosts = 3\nprocesses = 2\nendpoints = 10\nwired = true\n"


@pytest.mark.parametrize("command", ["utilization", "breakdown", "saturation"])
def test_a_wired_fleet_needs_no_airtime(command: str) -> None:
    words = [command, "-", "--protocol", "all"]
    people = CliRunner(env={"COLUMNS": "80"}).invoke(main, words, input=WIRED)
    assert people.exit_code == 0, people.output
    assert "\nAll hosts are wired; discovery needs no airtime.\n" in people.stdout
    machines = CliRunner().invoke(main, [*words, "--json"], input=WIRED)
    assert "wired;" not in machines.stdout
    assert '"share": 0.0' in machines.stdout or command != "breakdown"
    assert '"hosts": null' in machines.stdout or command != "saturation"


def test_a_breakdown_of_one_host_has_shares_of_zero() -> None:
    words = ["--hosts", "1", "--processes", "2", "--endpoints", "10", "--protocol", "all"]
    for more in ([], ["--json"], ["--csv"]):
        done = CliRunner().invoke(main, ["breakdown", *words, *more])
        assert done.exit_code == 0, done.output


def test_lines_fit_a_narrow_terminal(folder: Path) -> None:
    (folder / "fleet.toml").write_bytes(GROUP)
    for words in (["utilization", "fleet.toml"], ["breakdown", "fleet.toml"], ["robots"]):
        for columns in (20, 40, 60):
            done = CliRunner(env={"COLUMNS": str(columns)}).invoke(main, words)
            assert max(map(len, done.stdout.splitlines())) <= columns, done.stdout


def test_figures_are_listed_with_progress_alone_also_where_home_cannot_be_written(
    folder: Path,
) -> None:
    (folder / "home").write_text("a file")
    env = os.environ | {"HOME": str(folder / "home"), "MPLCONFIGDIR": str(folder / "home" / "x")}
    done = subprocess.run(
        [sys.executable, "-m", "discostorm", "figures", "--out", "deep/out", "--json"],
        env=env, capture_output=True, text=True, check=False,
    )  # fmt: skip
    paths = [row["path"] for row in json.loads(done.stdout)]
    assert (done.returncode, len(paths)) == (0, 12)
    assert all((folder / path).is_file() for path in paths)
    progress = [f"[{number:2}/12] {path}" for number, path in enumerate(paths, start=1)]
    assert done.stderr.splitlines() == progress

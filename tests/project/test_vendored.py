"""Test the list of vendored files, with our changes to them."""

import hashlib
from pathlib import Path

import pytest
from list_vendored import REASONS_TO_KEEP, format_table, main, vendored_files

pytestmark = pytest.mark.book


def test_every_file_is_as_it_came() -> None:
    assert {row["state"] for row in vendored_files()} == {"as it came"}
    assert {row["npm_package"] for row in vendored_files()} >= REASONS_TO_KEEP.keys()


def test_a_file_that_changed_or_is_missing_is_told(tmp_path: Path) -> None:
    sha = hashlib.sha256(b"as it came").hexdigest()
    lines = [f"{name},x,1,MIT,LICENSE,{sha}" for name in ("same", "other", "none")]
    head = "file,npm_package,version,license,license_file,sha256"
    (tmp_path / "vendored.csv").write_text("\n".join([head, *lines]) + "\n")
    (tmp_path / "same").write_text("as it came")
    (tmp_path / "other").write_text("changed")
    assert [row["state"] for row in vendored_files(tmp_path)] == [
        "as it came",
        "changed",
        "missing",
    ]
    assert (
        format_table(vendored_files(tmp_path), ("file", "state")).splitlines()[2]
        == "other  changed"
    )


def test_the_list_asks_nobody_unless_told(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("sys.argv", ["list_vendored.py"])
    monkeypatch.setattr("subprocess.run", lambda *_, **__: pytest.fail("npm was asked"))
    assert main() == 0
    assert "mathjax stays at its version" in capsys.readouterr().out


def test_where_there_is_no_npm_it_is_said(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("sys.argv", ["list_vendored.py", "--newest"])
    monkeypatch.setenv("PATH", "")
    assert main() == 1
    assert "npm did not answer" in capsys.readouterr().err

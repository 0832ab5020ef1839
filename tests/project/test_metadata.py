"""Test the metadata for indexes and archives, and the index's page."""

import doctest
import hashlib
import json
import re
import shlex
import shutil
import tomllib
from pathlib import Path

import pytest
import yaml
from check_distributions import console_examples
from click.testing import CliRunner
from make_release import ARCHIVE_CONTENTS, is_leftover, ro_crate
from support import ROOT
from write_metadata import PROJECTS, generated_files

from discostorm.cli import main

pytestmark = pytest.mark.book

PAGE = (ROOT / "PYPI.md").read_text(encoding="utf-8")
SOURCES = ("CITATION.cff", "PYPI.md", "_config.yml", *PROJECTS)
BASE = "https://example.org/storm/"


@pytest.fixture
def published(tmp_path: Path) -> Path:
    """Return a folder with the sources, in which every address is known."""
    for name in SOURCES:
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / name, tmp_path / name)
    config = (ROOT / "_config.yml").read_text(encoding="utf-8")
    for key, address in (
        ("baseurl", BASE.rstrip("/")),
        ("repository:\n.*\n  url", "https://example.org/source"),
        ("index:\n.*\n.*\n  url", "https://example.org/simple"),
    ):
        config, count = re.subn(rf'({key}): ""', rf'\1: "{address}"', config)
        assert count == 1, key
    (tmp_path / "_config.yml").write_text(config, encoding="utf-8")
    cff = tmp_path / "CITATION.cff"
    cff.write_text(cff.read_text(encoding="utf-8") + "doi: 10.5281/zenodo.1\n", encoding="utf-8")
    return tmp_path


@pytest.mark.parametrize("name", generated_files())
def test_it_is_fresh(name: str) -> None:
    kept = (ROOT / name).read_text(encoding="utf-8")
    assert kept == generated_files()[name], "make metadata"


@pytest.mark.parametrize("name", [".zenodo.json", "codemeta.json", "pyproject.toml", "PYPI.md"])
def test_while_no_address_is_known_none_is_made_up(name: str) -> None:
    text = (ROOT / name).read_text(encoding="utf-8")
    found = set(re.findall(r"https?://[\w.]+", text))
    assert found <= {"https://spdx.org", "https://w3id.org"}
    assert "doi" not in text.lower()


def test_once_they_are_known_all_addresses_are_told(published: Path) -> None:
    files = generated_files(published)
    cff = yaml.safe_load(files["CITATION.cff"])
    assert (cff["url"], cff["repository-code"]) == (BASE, "https://example.org/source")
    urls = tomllib.loads(files["pyproject.toml"])["project"]["urls"]
    assert urls["Homepage"] == BASE
    assert urls["DOI"] == "https://doi.org/10.5281/zenodo.1"
    assert json.loads(files["codemeta.json"])["identifier"] == urls["DOI"]
    related = json.loads(files[".zenodo.json"])["related_identifiers"]
    assert {each["identifier"] for each in related} == {BASE, "https://example.org/source"}
    assert f"({BASE}_static/preview.png)" in files["PYPI.md"]
    assert "    pip install 'discostorm[all]'\n" in files["PYPI.md"]
    # Written once more, nothing changes.
    for name in ("CITATION.cff", "PYPI.md", *PROJECTS):
        (published / name).write_text(files[name], encoding="utf-8")
    assert generated_files(published) == files


def test_an_address_that_is_none_is_refused(published: Path) -> None:
    config = published / "_config.yml"
    config.write_text(config.read_text().replace("https://example.org/source", "example.org"))
    with pytest.raises(SystemExit, match=r"repository\.url in _config\.yml must be empty or"):
        generated_files(published)


def test_license_is_that_of_code_and_data() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    assert project["license"] == "BSD-3-Clause AND CC-BY-4.0"
    assert all((ROOT / name).exists() for name in project["license-files"])
    data = (ROOT / "discostorm" / "data" / "README.md").read_text(encoding="utf-8")
    assert "CC BY 4.0" in data
    cff = yaml.safe_load((ROOT / "CITATION.cff").read_text(encoding="utf-8"))
    names = {author["name"] for author in cff["authors"]}
    assert names == {author["name"] for author in project["maintainers"]}


def test_no_link_of_the_page_of_an_index_needs_the_checkout(published: Path) -> None:
    for page in (PAGE, generated_files(published)["PYPI.md"]):
        links = re.findall(r"\]\(([^)]*)\)|(?:src|href)=\"([^\"]*)\"", page)
        assert all((one or other).startswith("https://") for one, other in links)
    assert not re.search(r"\bmake \w+(?!.*-->)|\.venv", re.sub("<!--.*?-->", "", PAGE))


def test_python_of_the_page_of_an_index_runs() -> None:
    failed, tried = doctest.testfile(str(ROOT / "PYPI.md"), module_relative=False)
    assert (failed, tried) == (0, 2)


def test_commands_of_the_page_of_an_index_print_what_it_shows() -> None:
    examples = [*console_examples(PAGE)]
    assert len(examples) == 3
    for command, shown in examples:
        program, *arguments = shlex.split(command)
        assert program == "discostorm"
        assert CliRunner().invoke(main, arguments, catch_exceptions=False).output == shown


def test_the_release_says_what_it_holds_with_checksums() -> None:
    assert {"build/release/dist", "codemeta.json", ".zenodo.json"} <= ARCHIVE_CONTENTS.keys()
    contents = {"codemeta.json": (ROOT / "codemeta.json").read_bytes(), "data/a.csv": b"1\n"}
    graph = json.loads(ro_crate(contents, "0.4.0"))["@graph"]
    about, root, *files = graph
    assert about["about"] == {"@id": root["@id"]}
    assert {each["@id"] for each in files} == {each["@id"] for each in root["hasPart"]}
    assert {each["@id"]: each["sha256"] for each in files} == {
        name: hashlib.sha256(data).hexdigest() for name, data in contents.items()
    }
    assert "identifier" not in root


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("01_who_tells_whom.ipynb", False),
        (".nojekyll", False),
        ("_static/fonts/a.woff2", False),
        (".ruff_cache/0.17.5/1", True),
        (".ipynb_checkpoints/a.ipynb", True),
        ("ledger/__pycache__/a.pyc", True),
        (".buildinfo", True),
    ],
)
def test_archive_has_no_leftovers_of_tools(name: str, expected: bool) -> None:
    # Their content changes with each run: two releases of one commit would differ.
    assert is_leftover(Path(name)) is expected

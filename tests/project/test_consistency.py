"""Test that statements in several files of the project agree."""

import doctest
import re
from pathlib import Path

import pytest
import yaml
from support import ROOT

import discostorm as ds
from discostorm import figures

PAPER = (
    "Discovery Storm: Scalability Analysis of DDS and Zenoh "
    "in Large-Scale Wireless Robotic Networks"
)


def text(name: str) -> str:
    """Return a file's text on one line."""
    return " ".join((ROOT / name).read_text(encoding="utf-8").split())


def test_example_of_the_readme_runs() -> None:
    failed, tried = doctest.testfile(str(ROOT / "README.md"), module_relative=False)
    assert tried == 4
    assert failed == 0


def test_numbers_in_the_text_of_the_readme_are_those_of_its_example() -> None:
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    _, example, after = re.split(r"^```(?:python)?$", readme, flags=re.MULTILINE)[:3]
    said = re.findall(r"\d+\.\d+", after.split("\n## ")[0])
    assert len(said) == 2
    assert set(said) <= set(re.findall(r"^\d+\.\d+$", example, re.MULTILINE))


@pytest.mark.locked
def test_figure_of_the_readme_is_fresh(tmp_path: Path) -> None:
    list(figures.save(figures.fig2(), tmp_path, "fig2"))
    fresh = (tmp_path / "fig2.svg").read_text(encoding="utf-8")
    kept = (ROOT / "book" / "_static" / "fig2.svg").read_text(encoding="utf-8")
    assert kept == fresh, "make figures; cp build/figures/fig2.svg book/_static/"


def test_citation_is_of_this_version() -> None:
    cff = yaml.safe_load((ROOT / "CITATION.cff").read_text(encoding="utf-8"))
    assert cff["version"] == ds.__version__
    assert f"## [{cff['version']}] - {cff['date-released']}" in text("CHANGELOG.md")
    # What version 1.2.0 of the format requires.
    assert {"cff-version", "message", "title", "authors"} <= cff.keys()


@pytest.mark.parametrize("name", ["README.md", "CITATION.cff", "book/index.md"])
def test_paper_is_cited_by_its_title(name: str) -> None:
    assert PAPER in text(name)


def test_files_of_chapters_are_numbered_in_the_order_of_the_contents() -> None:
    contents = yaml.safe_load((ROOT / "_toc.yml").read_text(encoding="utf-8"))
    files = [chapter["file"] for part in contents["parts"] for chapter in part["chapters"]]
    numbers = [int(m[1]) for file in files if (m := re.match(r"notebooks/(\d+)_", file))]
    # With gaps, where chapters became one: an address changes once, to its last number.
    assert numbers == sorted(set(numbers))


def test_no_number_of_a_chapter_is_typed() -> None:
    pages = [*ROOT.glob("book/*.md"), *ROOT.glob("notebooks/*.ipynb")]
    typed = re.compile(r"\bchapters? \[?\d+", re.IGNORECASE)
    assert not {page.name for page in pages if typed.search(page.read_text(encoding="utf-8"))}


def test_every_reference_is_cited() -> None:
    bibliography = (ROOT / "book" / "references.bib").read_text(encoding="utf-8")
    keys = set(re.findall(r"^@\w+\{(.+),$", bibliography, re.MULTILINE))
    assert len(keys) == bibliography.count("@")
    pages = [*ROOT.glob("book/*.md"), *ROOT.glob("notebooks/*.ipynb")]
    prose = "".join(page.read_text(encoding="utf-8") for page in pages)
    assert not {key for key in keys if f"{{cite}}`{key}`" not in prose}

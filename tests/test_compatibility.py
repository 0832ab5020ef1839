"""What 0.2.0 offered is there, or is answered by an error that says what took its place."""

import csv
import importlib
import inspect
import json
import pkgutil
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import click
import pytest
import yaml
from playwright.sync_api import Browser

import discostorm as ds
from discostorm import _renamed
from discostorm.cli import main

ROOT = Path(__file__).parents[1]
#: Pages, and parts of them, that are elsewhere now.
with (ROOT / "book/moved.csv").open(encoding="utf-8", newline="") as _file:
    MOVED = list(csv.DictReader(_file))
#: Public names, options, pages, labels on pages and keys of fleet files, as 0.2.0 had them.
OLD = json.loads((ROOT / "tests" / "names_of_0.2.0.json").read_text(encoding="utf-8"))

GONE = {f"discostorm.{name}": new for name, new in _renamed.MODULES.items()}


def table() -> list[tuple[str, str]]:
    """Return the rows of the table of old and new names."""
    text = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
    section = text.split("### Old and new names")[1].split("\n## ")[0]
    rows = [line.strip("| ").split(" | ") for line in section.splitlines() if line.startswith("|")]
    return [(old, new) for old, new in rows[2:]]


def listed(name: str) -> bool:
    """Return whether the table has an old name, alone or behind the names before it."""
    return any(re.search(rf"(?<!\w){re.escape(name)}(?!\w)", old) for old, _ in table())


def refused(error: BaseException, new: str) -> bool:
    return isinstance(error, (AttributeError, ImportError, TypeError)) and new in str(error)


@pytest.mark.parametrize("module", OLD["modules"])
def test_every_module_is_there_or_says_what_took_its_place(module: str) -> None:
    if module not in GONE:
        importlib.import_module(module)
        return
    with pytest.raises(ImportError) as raised:
        importlib.import_module(module)
    assert refused(raised.value, GONE[module])
    assert listed(module.removeprefix("discostorm.")), "the CHANGELOG's table lacks it"


@pytest.mark.parametrize("module", sorted(OLD["names"].keys() - GONE.keys()))
def test_every_name_is_there_or_says_what_took_its_place(module: str) -> None:
    short = module.removeprefix("discostorm.")
    gone = _renamed.MODULES if module == "discostorm" else _renamed.NAMES.get(short, {})
    for name in OLD["names"][module]:
        if name not in gone:
            assert hasattr(importlib.import_module(module), name), f"{module}.{name}"


@pytest.mark.parametrize("module", _renamed.NAMES)
def test_a_name_that_is_gone_is_answered_however_it_is_asked_for(module: str) -> None:
    home = importlib.import_module(f"discostorm.{module}")
    for name, new in _renamed.NAMES[module].items():
        for ask in (f"from discostorm.{module} import {name}", f"home.{name}"):
            with pytest.raises(ImportError, match=re.escape(new)):
                exec(ask, {"home": home})
        assert listed(name), f"the CHANGELOG's table lacks {module}.{name}"
    with pytest.raises(AttributeError, match="has no attribute 'nothing'"):
        home.nothing  # noqa: B018


def test_a_module_that_is_gone_is_answered_as_an_attribute() -> None:
    with pytest.raises(AttributeError, match=r"discostorm\.model"):
        ds.scalability  # type: ignore[attr-defined]  # noqa: B018


def found(path: str) -> Any:
    """Return what a dotted name leads to, None if that itself is gone."""
    module, _, name = path.rpartition(".")
    if module in GONE or name in _renamed.NAMES.get(module.removeprefix("discostorm."), {}):
        return None
    try:
        return getattr(importlib.import_module(module), name)
    except ModuleNotFoundError:
        owner = found(module)
        return None if owner is None else getattr(owner, name, None)


def test_every_member_is_there_or_says_what_took_its_place() -> None:
    fleet = ds.Fleet.swarm(2, 1, 3)
    for path, members in OLD["members"].items():
        cls = found(path)
        if cls is None:
            continue
        for name in members:
            if cls is ds.Fleet and name in _renamed.OF_FLEET:
                with pytest.raises(AttributeError, match=re.escape(_renamed.OF_FLEET[name])):
                    getattr(fleet, name)
                assert listed(name), f"the CHANGELOG's table lacks Fleet.{name}"
            else:
                fields = getattr(cls, "__dataclass_fields__", {})
                assert name in fields or hasattr(cls, name), f"{path}.{name}"


def test_what_a_method_of_fleets_counted_is_counted_by_what_took_its_place() -> None:
    """Every message that names a unit is one that can be asked."""
    fleet = ds.Fleet.swarm(3, 2, 10)
    for name, new in _renamed.OF_FLEET.items():
        if name != "without":
            value = eval(new, {"discostorm": ds, "fleet": fleet})
            assert value >= 0, name
    assert eval(_renamed.OF_FLEET["pairs"], {"discostorm": ds, "fleet": fleet}) == 3 * 2 * 4


def test_every_parameter_is_there_or_says_what_took_its_place() -> None:
    for path, parameters in OLD["parameters"].items():
        function = found(path)
        if function is None:
            continue
        for name in set(parameters) - set(inspect.signature(function).parameters):
            with pytest.raises(TypeError, match=rf"has no parameter '{name}' since .*; use "):
                function(**{name: None})
            assert listed(name), f"the CHANGELOG's table lacks {path}({name}=)"


def test_what_took_the_place_of_a_name_is_there() -> None:
    news = [*GONE.values(), *(new for names in _renamed.NAMES.values() for new in names.values())]
    for path in {path for new in news for path in re.findall(r"discostorm(?:\.\w+)+", new)}:
        owner, _, name = path.rpartition(".")
        fields = getattr(pkgutil.resolve_name(owner), "__dataclass_fields__", {})
        assert name in fields or pkgutil.resolve_name(path), path


def test_imports_of_what_never_was_stay_plain() -> None:
    with pytest.raises(ModuleNotFoundError, match="No module named"):
        importlib.import_module("discostorm.nothing")


def test_old_imports_are_answered_in_a_fresh_python() -> None:
    for ask in ("import discostorm.scalability", "from discostorm import notebook"):
        done = subprocess.run(
            [sys.executable, "-c", ask], cwd=ROOT, text=True, capture_output=True, check=False
        )
        assert re.search(
            r"ImportError: discostorm\.\w+ is discostorm\..+ since 0\.3\.0", done.stderr
        )


@pytest.mark.parametrize("command", OLD["options"])
def test_every_command_has_the_options_that_it_had(command: str) -> None:
    assert isinstance(main, click.Group)
    found = main.get_command(click.Context(main), command)
    assert found is not None
    parameters = found.params
    today = {option for one in parameters for option in (*one.opts, *one.secondary_opts)}
    assert set(OLD["options"][command]) <= today


def test_every_key_of_fleet_files_is_read(tmp_path: Path) -> None:
    keys = OLD["fleet_file"]
    values = {"name": '"robots"', "endpoints": 12}
    group = "\n".join(f"{key} = {values.get(key, 1)}" for key in keys["group"])
    assert keys["fleet"] == ["groups", "matching"]
    file = tmp_path / "fleet.toml"
    file.write_text(f"matching = 0.5\n[[groups]]\n{group}\n", encoding="utf-8")
    fleet = ds.Fleet.from_toml(file)
    assert fleet.matching == 0.5
    assert fleet.groups[0] == ds.HostGroup(1, 1, 12, "robots", nodes=1, shared=1)


@pytest.mark.book
def test_every_page_is_at_its_address_and_every_label_on_a_page() -> None:
    contents = yaml.safe_load((ROOT / "_toc.yml").read_text(encoding="utf-8"))
    files = [chapter["file"] for part in contents["parts"] for chapter in part["chapters"]]
    moved = {row["page"] for row in MOVED}
    assert set(OLD["pages"]) <= {f"{file}.html" for file in [contents["root"], *files]} | moved
    pages = [*ROOT.glob("book/*.md"), *ROOT.glob("notebooks/*.ipynb")]
    text = "".join(page.read_text(encoding="utf-8") for page in pages)
    labels = re.findall(r"\(([\w-]+)\)=|:label: ([\w-]+)", text)
    assert set(OLD["labels"]) <= {label for pair in labels for label in pair}


@pytest.mark.book
@pytest.mark.parametrize("page", sorted({row["page"] for row in MOVED}))
def test_an_address_that_has_moved_leads_to_its_text(
    book: Path, browser: Browser, page: str
) -> None:
    tab = browser.new_page()
    page_start = {row["page"]: row["now"].partition("#")[2] for row in MOVED if not row["anchor"]}
    anchors = [label for label, where in OLD["labels"].items() if where == page]
    assert anchors
    for anchor in ["", *anchors]:
        tab.goto("about:blank")
        tab.goto((book / page).as_uri() + (f"#{anchor}" if anchor else ""))
        tab.wait_for_selector("article")
        hash_ = tab.evaluate("decodeURIComponent(location.hash)")
        assert hash_ == f"#{anchor}" if anchor else hash_ in {"", "#" + page_start[page]}
        assert tab.evaluate("id => !id || document.getElementById(id) !== null", hash_[1:]), anchor
    tab.close()

"""Write the metadata for indexes and archives from CITATION.cff, pyproject.toml and addresses.

All of .zenodo.json and codemeta.json is generated. In CITATION.cff, pyproject.toml and PYPI.md,
only the text between two marks is generated: how to install, and the addresses in `_config.yml`,
if there are any. Every pyproject.toml takes its version, and the version of required
packages of ours, from CITATION.cff.
"""

import json
import re
import tomllib
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import yaml  # type: ignore[import-untyped]

ROOT = Path(__file__).parents[2]
#: The core's file comes first; the packages that require the core follow.
PROJECTS = (
    "pyproject.toml",
    *(f"packages/{name}/pyproject.toml" for name in ("simulation", "planner", "capture", "book")),
)
MARKED_PART = re.compile(
    r"^((?:<!-- |# )(addresses|install)\b[^\n]*\n)(.*?)^((?:<!-- |# )end\b)", re.M | re.S
)


class MetadataSources:
    """The facts that all metadata files share."""

    def __init__(self, root: Path = ROOT) -> None:
        config = yaml.safe_load((root / "_config.yml").read_text(encoding="utf-8"))
        self.cff: dict[str, Any] = yaml.safe_load(
            (root / "CITATION.cff").read_text(encoding="utf-8")
        )
        self.project: dict[str, Any] = tomllib.loads(
            (root / "pyproject.toml").read_text(encoding="utf-8")
        )["project"]
        base = _checked_address("html.baseurl", config["html"]["baseurl"])
        self.base = base and base.rstrip("/") + "/"
        self.source = _checked_address("repository.url", config["repository"]["url"]).rstrip("/")
        self.index = _checked_address("index.url", config.get("index", {}).get("url", ""))
        self.doi = str(self.cff.get("doi", ""))


def _checked_address(name: str, given: str | None) -> str:
    parts = urlsplit(given or "")
    if given and not (parts.scheme in {"http", "https"} and parts.netloc):
        raise SystemExit(
            f"write_metadata: {name} in _config.yml must be empty or an address such as "
            f"https://example.org/storm/; got {given!r}"
        )
    return given or ""


def _nonempty_json(value: dict[str, Any]) -> str:
    kept = {key: content for key, content in value.items() if content not in ("", None, [])}
    return json.dumps(kept, indent=2, ensure_ascii=False) + "\n"


def zenodo_metadata(given: MetadataSources) -> str:
    """Return the metadata for Zenodo, which assigns the DOI itself."""
    cff = given.cff
    related = [
        {"identifier": address, "relation": relation, "scheme": "url"}
        for address, relation in ((given.base, "isDocumentedBy"), (given.source, "isSupplementTo"))
        if address
    ]
    return _nonempty_json(
        {
            "upload_type": "software",
            "title": cff["title"],
            "description": cff["abstract"],
            "creators": [{"name": author["name"]} for author in cff["authors"]],
            "version": cff["version"],
            "publication_date": str(cff["date-released"]),
            "license": cff["license"],
            "notes": f"{cff['message']} License: {given.project['license']}.",
            "keywords": cff["keywords"],
            "related_identifiers": related,
        }
    )


def codemeta_metadata(given: MetadataSources) -> str:
    """Return the software's metadata in the CodeMeta format."""
    cff, project = given.cff, given.project
    licenses = project["license"].split(" AND ")
    people = [{"@type": "Organization", "name": author["name"]} for author in cff["authors"]]
    return _nonempty_json(
        {
            "@context": "https://w3id.org/codemeta/3.0",
            "@type": "SoftwareSourceCode",
            "name": project["name"],
            "version": cff["version"],
            "identifier": f"https://doi.org/{given.doi}" if given.doi else "",
            "description": project["description"],
            "author": people,
            "maintainer": people,
            "datePublished": str(cff["date-released"]),
            "dateModified": str(cff["date-released"]),
            "developmentStatus": "active",
            "license": [f"https://spdx.org/licenses/{name}" for name in licenses],
            "url": given.base,
            "codeRepository": given.source,
            "programmingLanguage": "Python",
            "runtimePlatform": f"Python {project['requires-python']}",
            "operatingSystem": ["Linux", "macOS", "Windows"],
            "keywords": cff["keywords"],
            "softwareRequirements": project["dependencies"],
        }
    )


def _urls(given: MetadataSources) -> dict[str, str]:
    every = {
        "Homepage": given.base,
        "Documentation": given.base and f"{given.base}notebooks/21_command_line.html",
        "Source": given.source,
        "DOI": given.doi and f"https://doi.org/{given.doi}",
    }
    return {name: address for name, address in every.items() if address}


def generated_parts(name: str, given: MetadataSources) -> dict[str, str]:
    """Return the generated texts of a file by the word in the mark before each text."""
    if name in PROJECTS:
        lines = [f'{key} = "{address}"\n' for key, address in _urls(given).items()]
        return {"addresses": "".join(["[project.urls]\n", *lines, "\n"] if lines else [])}
    if name == "CITATION.cff":
        found = {"url": given.base, "repository-code": given.source}
        return {"addresses": "".join(f"{key}: {url}\n" for key, url in found.items() if url)}
    if given.index:
        install = "With Python 3.11 or newer:\n\n    pip install 'discostorm[all]'\n"
    else:
        install = (
            "The wheels are in the release's archive, in the folder `dist`. With Python 3.11 or "
            "newer, in that folder:\n\n    pip install --find-links . 'discostorm[all]'\n"
        )
    if not given.base:
        book = (
            "The book, with every equation, a calculator and the measurements, comes with the "
            "release: open `html/index.html`\nin its archive.\n"
        )
    else:
        calculator = f"[a calculator]({given.base}book/calculator.html)"
        book = (
            "![Robots around an access point, and a bar of airtime]"
            f"({given.base}_static/preview.png)\n\n"
            f"[The book]({given.base}) has every equation, {calculator} and the measurements.\n"
        )
    return {"addresses": book, "install": install}


def fill_marks(name: str, given: MetadataSources, root: Path = ROOT) -> str:
    """Return the text of a file with new text between its marks."""
    new = generated_parts(name, given)
    text = (root / name).read_text(encoding="utf-8")
    return MARKED_PART.sub(lambda found: found[1] + new[found[2]] + found[4], text)


def set_version(text: str, given: MetadataSources) -> str:
    """Set the version in a pyproject.toml, for its package and for required packages of ours."""
    version = str(given.cff["version"])
    text = re.sub(r"(?m)^(version = )\"[^\"]*\"", rf'\1"{version}"', text)
    return re.sub(r"(\"discostorm[\w-]*)==[^\"]*\"", rf'\1=={version}"', text)


def generated_files(root: Path = ROOT) -> dict[str, str]:
    """Return the text of every generated file."""
    given = MetadataSources(root)
    files = {name: fill_marks(name, given, root) for name in ("CITATION.cff", "PYPI.md")}
    for name in PROJECTS:
        files[name] = set_version(fill_marks(name, given, root), given)
    return files | {
        ".zenodo.json": zenodo_metadata(given),
        "codemeta.json": codemeta_metadata(given),
    }


def main() -> None:
    """Write the generated files."""
    for name, text in generated_files().items():
        (ROOT / name).write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()

"""Pack the built files into one archive; the same commit always gives the same bytes."""

import argparse
import hashlib
import json
import shutil
import time
import zipfile
from collections.abc import Mapping
from importlib.metadata import metadata
from pathlib import Path

ROOT = Path(__file__).parents[2]
#: Source of each file, and its path in the archive.
ARCHIVE_CONTENTS = {
    "_build/html": "html",
    "build/discostorm.pdf": "discostorm.pdf",
    "build/cheat_sheet.pdf": "cheat_sheet.pdf",
    "build/release/figures": "figures",
    "notebooks": "notebooks",
    "discostorm/data": "data/discostorm",
    "packages/planner/discostorm_planner/data": "data/discostorm_planner",
    "packages/capture/discostorm_capture/data": "data/discostorm_capture",
    "packages/book/discostorm_book/data": "data/discostorm_book",
    "requirements.lock": "requirements.lock",
    "environment.yml": "environment.yml",
    "build/release/dist": "dist",
    "CITATION.cff": "CITATION.cff",
    ".zenodo.json": ".zenodo.json",
    "codemeta.json": "codemeta.json",
    "CHANGELOG.md": "CHANGELOG.md",
    "README.md": "README.md",
    "LICENSE": "LICENSE",
    "LICENSE-CC-BY-4.0.txt": "LICENSE-CC-BY-4.0.txt",
}
#: Leftovers of tools; hidden folders, in which tools keep what they have seen, are left out, too.
EXCLUDED_NAMES = {".buildinfo", "__pycache__", "ruff.toml"}


def ro_crate(contents: Mapping[str, bytes], version: str) -> str:
    """Return the manifest, an RO-Crate: all files with their checksums."""
    cff = json.loads(contents["codemeta.json"])
    files = [
        {
            "@id": name,
            "@type": "File",
            "contentSize": str(len(data)),
            "sha256": hashlib.sha256(data).hexdigest(),
        }
        for name, data in sorted(contents.items())
    ]
    root = {
        "@id": "./",
        "@type": "Dataset",
        "name": f"discostorm {version}: book, data, figures, notebooks and package",
        "description": cff["description"],
        "datePublished": cff["datePublished"],
        "license": [{"@id": address} for address in cff["license"]],
        "hasPart": [{"@id": name} for name in sorted(contents)],
    }
    if "identifier" in cff:
        root["identifier"] = cff["identifier"]
    about = {
        "@id": "ro-crate-metadata.json",
        "@type": "CreativeWork",
        "conformsTo": {"@id": "https://w3id.org/ro/crate/1.1"},
        "about": {"@id": "./"},
    }
    context = [
        "https://w3id.org/ro/crate/1.1/context",
        {"sha256": "https://w3id.org/ro/terms/workflow-run#sha256"},
    ]
    graph = {"@context": context, "@graph": [about, root, *files]}
    return json.dumps(graph, indent=1, ensure_ascii=False) + "\n"


def is_leftover(path: Path) -> bool:
    """Return whether a path, relative to a packed folder, is what a tool has left there."""
    return bool(EXCLUDED_NAMES & set(path.parts)) or any(
        part.startswith(".") for part in path.parts[:-1]
    )


def collect_files() -> dict[str, bytes]:
    """Return the name and content of each file in the archive, checksums last."""
    found: dict[str, bytes] = {}
    for source, target in ARCHIVE_CONTENTS.items():
        path = ROOT / source
        if not path.exists():
            raise SystemExit(f"make_release: {source} is missing: run `make release`")
        for file in [path] if path.is_file() else sorted(path.rglob("*")):
            if file.is_file() and not is_leftover(file.relative_to(path)):
                name = (Path(target) / file.relative_to(path)).as_posix()
                found[name.removesuffix("/.")] = file.read_bytes()
    found["ro-crate-metadata.json"] = ro_crate(found, metadata("discostorm")["Version"]).encode()
    sums = (f"{hashlib.sha256(data).hexdigest()}  {name}\n" for name, data in sorted(found.items()))
    return dict(sorted(found.items())) | {"SHA256SUMS": "".join(sums).encode()}


def write_zip(path: Path, contents: dict[str, bytes], epoch: int) -> None:
    """Write a zip archive in which every file has the given time."""
    # Zip archives have no times before 1980.
    date = time.gmtime(max(epoch, 315_532_800))[:6]
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data in contents.items():
            info = zipfile.ZipInfo(f"{path.stem}/{name}", date)
            info.external_attr = 0o644 << 16
            info.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(info, data)


def main() -> None:
    """Pack the release into build/."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--epoch", type=int, default=0, help="time of the commit [s]")
    epoch = parser.parse_args().epoch
    path = ROOT / "build" / f"discostorm-{metadata('discostorm')['Version']}.zip"
    contents = collect_files()
    write_zip(path, contents, epoch)
    shutil.rmtree(ROOT / "build" / "release")
    print(f"\nThe release is ready: {path} ({len(contents)} files)")
    print(f"sha256 {hashlib.sha256(path.read_bytes()).hexdigest()}")


if __name__ == "__main__":
    main()

"""List the third-party files in the book: version, license and checksum.

With --newest, ask npm for the newest version of each package. The exit status is 1 if a file
differs from its original.
"""

import argparse
import csv
import hashlib
import subprocess
import sys
from pathlib import Path

STATIC = Path(__file__).parents[2] / "book" / "_static"

#: Reasons to keep an older version of a package.
REASONS_TO_KEEP = {
    "mathjax": "4 loads some of its font's data (SVG too) and its speech worker when a formula "
    "needs them,\nby default from a CDN. The book must show every formula offline, under file://, "
    "from one script: 3.2.2 does.",
}


def newest_npm_version(package: str) -> str:
    """Return the newest version of a package on npm."""
    command = ["npm", "view", package, "version"]
    done = subprocess.run(command, text=True, capture_output=True, timeout=60, check=True)
    return done.stdout.strip()


def vendored_files(static: Path = STATIC) -> list[dict[str, str]]:
    """Return the rows of vendored.csv, and whether each file is unchanged."""
    with (static / "vendored.csv").open(encoding="utf-8", newline="") as file:
        found = [*csv.DictReader(file)]
    for row in found:
        path = static / row["file"]
        content = path.read_bytes() if path.is_file() else b""
        same = hashlib.sha256(content).hexdigest() == row["sha256"]
        row["state"] = "as it came" if same else "changed" if content else "missing"
    return found


def format_table(rows: list[dict[str, str]], columns: tuple[str, ...]) -> str:
    """Format rows as text with aligned columns."""
    lines = [list(columns), *([row.get(name, "") for name in columns] for row in rows)]
    widths = [max(map(len, column)) for column in zip(*lines, strict=True)]
    texts = (
        "  ".join(cell.ljust(width) for cell, width in zip(line, widths, strict=True))
        for line in lines
    )
    return "\n".join(text.rstrip() for text in texts)


def main() -> int:
    """Print the list; return 1 if a file was changed or npm did not answer."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--newest", action="store_true", help="ask npm for newer versions")
    given = parser.parse_args()
    found = vendored_files()
    columns: tuple[str, ...] = ("file", "npm_package", "version", "license", "state", "sha256")
    if given.newest:
        try:
            known = {
                name: newest_npm_version(name)
                for name in sorted({row["npm_package"] for row in found})
            }
        except (OSError, subprocess.SubprocessError) as error:
            print(f"list_vendored: npm did not answer: {error}", file=sys.stderr)
            return 1
        for row in found:
            row["newest"] = known[row["npm_package"]]
        columns = (*columns[:3], "newest", *columns[3:])
    print(format_table(found, columns))
    for name, why in REASONS_TO_KEEP.items():
        print(f"\n{name} stays at its version: {why}")
    return int(any(row["state"] != "as it came" for row in found))


if __name__ == "__main__":
    sys.exit(main())

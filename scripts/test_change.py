"""Test the package in this folder, for `make mutation`: first what was changed since the commit."""

import resource
import subprocess
import sys
from pathlib import Path

import pytest

#: Too slow to be run a thousand times, and others notice what they would; and the one that looks
#: for the lines of the list in the code.
LEFT_OUT = (
    "million_samples_take or loads_neither or same_bytes_twice or figures_shows"
    " or examples_that_run or installed_script or what_mutation_leaves"
)
MOST_BYTES = 8 * 2**30


def main() -> int:
    """Run the tests until one fails; return their exit status."""
    resource.setrlimit(resource.RLIMIT_AS, (MOST_BYTES, MOST_BYTES))
    # The package of this folder, not the one that is installed.
    sys.path.insert(0, str(Path.cwd()))
    import discostorm

    assert Path(discostorm.__file__).is_relative_to(Path.cwd())
    git = ["git", "diff", "--name-only", "--", "discostorm"]
    changed = subprocess.run(git, text=True, capture_output=True, check=True).stdout.split()
    names = {part.strip("_") for path in changed for part in Path(path).with_suffix("").parts[1:]}
    first = sorted(str(path) for name in names for path in Path("tests").glob(f"test_*{name}*.py"))
    files = [*changed, *first, "tests", "discostorm"]
    options = ["-x", "-q", "--failed-first", "--assert=plain", "-m", "not book"]
    return pytest.main([*options, "-k", f"not ({LEFT_OUT})", *files])


if __name__ == "__main__":
    sys.exit(main())

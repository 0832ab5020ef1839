#!/bin/sh
# Make .venv with exactly the versions of requirements.lock: by uv if it is there, else by pip.
set -eu

stop() {
    echo "discostorm: $1" >&2
    exit 1
}

rm -rf .venv
if command -v uv >/dev/null 2>&1; then
    echo "Setting up .venv with uv (once) ..."
    uv venv --quiet --python '>=3.11' .venv || stop "uv found no Python 3.11 or newer: try 'uv python install 3.13'"
    uv pip install --quiet --python .venv/bin/python --require-hashes -r requirements.lock
    uv pip install --quiet --python .venv/bin/python --no-deps --no-build-isolation -e .
else
    command -v "$PYTHON" >/dev/null 2>&1 ||
        stop "no $PYTHON here: install Python 3.11 or newer (Debian: apt-get install python3 python3-venv), or uv"
    "$PYTHON" -c 'import sys; sys.exit(sys.version_info < (3, 11))' ||
        stop "$("$PYTHON" --version) is too old: install Python 3.11 or newer and run 'make PYTHON=python3.11 ...', or install uv"
    "$PYTHON" -c 'import ensurepip, venv' 2>/dev/null ||
        stop "$PYTHON has no venv module: install it (Debian: apt-get install python3-venv), or uv"
    echo "Setting up .venv with pip (once, about a minute) ..."
    "$PYTHON" -m venv .venv
    .venv/bin/python -m pip install --quiet --require-hashes -r requirements.lock
    .venv/bin/python -m pip install --quiet --no-deps --no-build-isolation -e .
fi
touch .venv/.ready

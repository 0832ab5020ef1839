#!/bin/sh
# Make .venv with exactly the versions of requirements.lock: by uv if it is there, else by pip.
# .venv/.ready comes last, so that a set-up that was interrupted is done again.
set -eu

stop() {
    echo "discostorm: $1" >&2
    exit 1
}

old='is too old: install Python 3.11 or newer and name it, as in "make PYTHON=python3.11 ...", or install uv'

rm -rf .venv
if command -v uv >/dev/null 2>&1; then
    echo "Setting up .venv with uv (once) ..."
    uv venv --quiet --no-project --python "${PYTHON:->=3.11}" .venv ||
        stop "uv found no Python ${PYTHON:-3.11 or newer}; to get one: uv python install 3.13"
    .venv/bin/python -c 'import sys; sys.exit(sys.version_info < (3, 11))' ||
        stop "$(.venv/bin/python --version) $old"
    uv pip install --quiet --python .venv/bin/python --require-hashes -r requirements.lock ||
        stop "could not install requirements.lock; is there a network?"
    uv pip install --quiet --python .venv/bin/python --no-deps --no-build-isolation -e .
else
    python=${PYTHON:-python3}
    command -v "$python" >/dev/null 2>&1 ||
        stop "there is no $python: install Python 3.11 or newer (Debian: apt-get install python3 python3-venv), or uv"
    "$python" -c 'import sys; sys.exit(sys.version_info < (3, 11))' ||
        stop "$("$python" --version 2>&1) $old"
    "$python" -c 'import ensurepip, venv' 2>/dev/null ||
        stop "$python has no venv module: install it (Debian: apt-get install python3-venv), or uv"
    echo "Setting up .venv with pip (once, about a minute) ..."
    "$python" -m venv .venv
    .venv/bin/python -m pip install --quiet --require-hashes -r requirements.lock ||
        stop "could not install requirements.lock; is there a network?"
    .venv/bin/python -m pip install --quiet --no-deps --no-build-isolation -e .
fi
touch .venv/.ready

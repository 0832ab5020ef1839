#!/bin/sh
# Install packages into a folder of their own, for .venv's Python: by uv if it is there, else by pip.
# usage: install.sh FOLDER PACKAGE ...
set -eu

folder=$1
shift
rm -rf "$folder"
if command -v uv >/dev/null 2>&1; then
    uv pip install --quiet --python .venv/bin/python --target "$folder" "$@"
else
    .venv/bin/python -m pip install --quiet --no-warn-conflicts --target "$folder" "$@"
fi

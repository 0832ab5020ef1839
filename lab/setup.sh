#!/bin/sh
# Make what the lab runs, in build/lab: its programs, and a venv of its own with the middleware of
# PyPI in exactly the versions of lab/requirements.lock. Touches nothing else.
set -eu

sh lab/check.sh
echo "Setting up the lab in build/lab ..."
rm -rf build/lab/bin build/lab/venv
mkdir -p build/lab/bin build/lab/idl
if command -v uv >/dev/null 2>&1; then
    uv venv --quiet --no-project --python .venv/bin/python build/lab/venv
    uv pip install --quiet --python build/lab/venv/bin/python --require-hashes -r lab/requirements.lock
else
    .venv/bin/python -m venv build/lab/venv
    build/lab/venv/bin/python -m pip install --quiet --require-hashes -r lab/requirements.lock
fi
# Without the description of the type (-t), as ROS 2 has it.
idlc -t -W no-implicit-extensibility -o build/lab/idl lab/programs/String_.idl
for program in cyclone_dds watch_cyclone_dds; do
    cc -O2 -Wall -Wextra -Ibuild/lab/idl -o build/lab/bin/$program lab/programs/$program.c \
        build/lab/idl/String_.c -lddsc
done
for program in fast_dds fast_dds_data fast_dds_load watch_fast_dds node_fast_dds; do
    c++ -std=c++17 -O2 -Wall -Wextra -o build/lab/bin/$program lab/programs/$program.cpp -lfastrtps -lfastcdr
done
sh lab/keystore.sh build/lab/keystore
touch build/lab/.ready

#!/bin/sh
# build.sh SOURCE WORK ROOT OPTION...: build a source with CMake in WORK, at the lowest priority, and install it into
# ROOT, where it finds what was installed before. It goes on where it was stopped. Fast DDS comes with a copy of SQLite; a
# source without it is linked with the machine's.
set -eu
source=$1 work=$2 root=$3
shift 3
mkdir -p "$work" "$root"
if [ ! -d "$work/source" ]; then
    rm -rf "$work/copy"
    cp -R "$source" "$work/copy"
    mv "$work/copy" "$work/source"
fi
copy=$work/source/src/cpp/rtps/persistence
if [ -d "$copy" ] && [ ! -s "$copy/sqlite3.c" ]; then
    : > "$copy/sqlite3.c"
    set -- "$@" -DCMAKE_CXX_STANDARD_LIBRARIES=-lsqlite3
fi
cmake -S "$work/source" -B "$work/build" -DCMAKE_INSTALL_PREFIX="$root" -DCMAKE_PREFIX_PATH="$root" \
    -DCMAKE_INSTALL_LIBDIR=lib -DCMAKE_INSTALL_RPATH="$root/lib" -DCMAKE_BUILD_TYPE=None -DBUILD_SHARED_LIBS=ON \
    '-DCMAKE_C_FLAGS=-O1' '-DCMAKE_CXX_FLAGS=-O1 -include cstdint -w' "$@"
nice -n 19 make -C "$work/build" -j2 install

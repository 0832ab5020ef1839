#!/bin/sh
# slow_edp_answers.sh WORK OUT: relink libfastrtps of Fast DDS 2.6.12 with one constant changed, the delay with
# which a writer of endpoints answers an ACKNACK: 100 ms, as its comment says, in place of 0.1 ms. WORK is the folder in
# which make lab-roots built the library; the new one is written to OUT. One file is compiled anew.
set -eu
mkdir -p "$2"
work=$1 out=$(cd "$2" && pwd)
cpp=$work/source/src/cpp/rtps/builtin/discovery/endpoint/EDPSimple.cpp
sed 's/edp_nack_response_delay{0, 100 \* 1000 }/edp_nack_response_delay{0, 100 * 1000 * 1000 }/' "$cpp" > "$out/EDPSimple.cpp"
if cmp -s "$cpp" "$out/EDPSimple.cpp"; then
    echo "$cpp: edp_nack_response_delay{0, 100 * 1000 } is not in it" >&2
    exit 1
fi
build=$work/build/src/cpp
flags=$(sed -n 's/^CXX_[A-Z]* = //p' "$build/CMakeFiles/fastrtps.dir/flags.make" | tr '\n' ' ')
eval "c++ $flags -I\"$(dirname "$cpp")\" -c \"$out/EDPSimple.cpp\" -o \"$out/EDPSimple.o\""
link=$(sed -e "s|[^ ]*/endpoint/EDPSimple.cpp.o|$out/EDPSimple.o|" -e "s| -o [^ ]*| -o $out/libfastrtps.so.2.6|" \
    "$build/CMakeFiles/fastrtps.dir/link.txt")
(cd "$build" && eval "$link")
ln -sf libfastrtps.so.2.6 "$out/libfastrtps.so"

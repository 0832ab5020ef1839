#!/bin/sh
# Make .venv with exactly the versions of requirements.lock: by uv if it is there, else by pip.
# .venv/.ready comes last, so that a set-up that was interrupted is done again.
set -eu

# What .venv takes [MB], with the compiled modules.
room=1200

stop() {
    echo "discostorm: $1" >&2
    exit 1
}

# usage: try WHAT COMMAND ...; if the command fails, shows what it says and what that means.
try() {
    what=$1
    shift
    # Kept in memory, as the disk may be full.
    words=$("$@" 2>&1) && return
    [ -z "$words" ] || printf '%s\n' "$words" >&2
    case $words in
        *'No space left'* | *'rrno 28]'* | *'os error 28'* | *'uota exceeded'*)
            stop "could not $what: the disk is full; .venv takes about $room MB" ;;
        *'No interpreter found'*)
            stop "could not $what: no Python ${PYTHON:-3.11 or newer}; to get one: uv python install 3.13" ;;
        *'dns error'* | *'name resolution'* | *'NewConnectionError'* | *'onnection refused'* | \
            *'timed out'* | *'unreachable'* | *'error sending request'*)
            stop "could not $what; is there a network?" ;;
        *) stop "could not $what; why stands above" ;;
    esac
}

old='is too old: install Python 3.11 or newer and name it, as in "make PYTHON=python3.11 ...", or install uv'

[ -w . ] || stop "cannot write into $PWD"
rm -rf .venv
free=$(df -Pk . | awk 'NR == 2 { print int($4 / 1024) }')
[ "$free" -ge "$room" ] || stop ".venv takes about $room MB, but the disk of $PWD has $free MB left"
# Paths are UTF-8 whatever the locale says of the rest.
export PYTHONUTF8=1
if command -v uv >/dev/null 2>&1; then
    echo "Setting up .venv with uv (once) ..."
    # uv stops where it cannot keep what it fetched; here that is only for the next time.
    cache=$(uv cache dir)
    if ! mkdir -p "$cache" 2>/dev/null || ! [ -w "$cache" ]; then
        export UV_NO_CACHE=1
        [ -d "$(uv python dir)" ] || export UV_PYTHON_INSTALL_DIR="$PWD/.python"
    fi
    try "make .venv" uv venv --quiet --no-project --python "${PYTHON:->=3.11}" .venv
    .venv/bin/python -c 'import sys; sys.exit(sys.version_info < (3, 11))' ||
        stop "$(.venv/bin/python --version) $old"
    install='uv pip install --quiet --python .venv/bin/python'
else
    python=${PYTHON:-python3}
    command -v "$python" >/dev/null 2>&1 ||
        stop "there is no $python: install Python 3.11 or newer (Debian: apt-get install python3 python3-venv), or uv"
    "$python" -c 'import sys; sys.exit(sys.version_info < (3, 11))' ||
        stop "$("$python" --version 2>&1) $old"
    "$python" -c 'import ensurepip, venv' 2>/dev/null ||
        stop "$python has no venv module: install it (Debian: apt-get install python3-venv), or uv"
    # The first line that pip writes for them is read by a shell where there is a space.
    case $PWD in
        *' '*[\"\$\`\\]* | *[\"\$\`\\]*' '*)
            stop "programs that pip installs do not start in a folder whose name has a space and one of \"\$\`\\, as $PWD: rename it, or install uv" ;;
    esac
    echo "Setting up .venv with pip (once, about a minute) ..."
    try "make .venv" "$python" -m venv .venv
    install='.venv/bin/python -m pip install --quiet'
fi
try "install requirements.lock" $install --require-hashes -r requirements.lock
for package in . packages/simulation packages/planner packages/capture packages/book; do
    try "install $package" $install --no-deps --no-build-isolation -e "$package"
done
# Matplotlib looks for fonts now, into the folder that the Makefile gives it, and not in each of
# the notebooks that run side by side.
try "find fonts" .venv/bin/python -c 'import matplotlib.font_manager'
touch .venv/.ready

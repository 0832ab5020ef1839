#!/bin/sh
# debian.sh WORK ROOT SUITES PACKAGE=VERSION...: unpack packages of Debian and what they need into ROOT; nothing is
# installed, and there is no chroot. SUITES: "trixie", or "sid experimental". MIRROR is the address of a mirror, else that of
# this machine's own apt.
set -eu
work=$1 root=$2 suites=$3
shift 3
if [ -z "${MIRROR-}" ]; then
    MIRROR=$(apt-get indextargets --format '$(REPO_URI)' 'Origin: Debian' 2>/dev/null | grep -v security | head -n 1)
fi
: "${MIRROR:?no Debian mirror is known to this machine: say MIRROR=ADDRESS}"
rm -rf "$work" "$root"
mkdir -p "$work/lists/partial" "$work/cache/archives/partial" "$root"
: > "$work/status"
for suite in $suites; do
    echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $MIRROR $suite main"
done > "$work/sources.list"
# The Release file of sid may have expired on a mirror.
cat > "$work/apt.conf" <<CONF
Dir::Etc::sourcelist "$work/sources.list";
Dir::Etc::sourceparts "-";
Dir::Etc::preferencesparts "-";
Dir::State::lists "$work/lists";
Dir::State::status "$work/status";
Dir::Cache "$work/cache";
Acquire::Check-Valid-Until "false";
Acquire::Languages "none";
APT::Install-Recommends "false";
APT::Sandbox::User "root";
APT::Default-Release "${suites##* }";
CONF
export APT_CONFIG="$work/apt.conf"
apt-get -qq update
apt-get -qq --download-only -y install "$@"
for deb in "$work"/cache/archives/*.deb; do
    dpkg-deb -x "$deb" "$root"
done

#!/bin/sh
# Say what to install if something that the lab needs is missing; --debian: all its packages.
set -eu

packages="cyclonedds-dev cyclonedds-tools ethtool fastdds-tools g++ iproute2 libfastcdr-dev"
packages="$packages libfastrtps-dev nftables openssl procps python3-venv tcpdump util-linux"
if [ "${1-}" = --debian ]; then
    echo "$packages"
    exit
fi
missing=
for program in ethtool fast-discovery-server g++ idlc ip nsenter openssl setpriv sysctl tcpdump unshare; do
    command -v "$program" >/dev/null 2>&1 || missing="$missing $program"
done
for header in dds/dds.h fastdds/dds/domain/DomainParticipant.hpp fastcdr/Cdr.h; do
    [ -e "/usr/include/$header" ] || missing="$missing $header"
done
if [ -n "$missing" ]; then
    echo "discostorm: the lab is missing:$missing" >&2
    echo "On Debian: apt-get install $packages" >&2
    exit 1
fi
if [ "$(id -u)" != 0 ]; then
    echo "discostorm: the lab makes network namespaces: run it as root" >&2
    exit 1
fi

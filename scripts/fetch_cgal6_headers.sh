#!/bin/sh
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
#
# Puts the headers of a newer CGAL beside the installed one, for compatibility builds on Debian.
# Nothing is installed and the system's package lists stay as they are: apt works in a folder of
# its own, and the package is only unpacked.
#
#   scripts/fetch_cgal6_headers.sh FOLDER [SUITE]      SUITE: trixie (default), sid, ...
#
# Afterwards: g++ -I include -isystem FOLDER/usr/include ...   (Boost 1.74 of Debian 12 will do).
# The mirror is the one that apt uses here; DEBIAN_MIRROR overrides it.
set -eu

if [ $# -lt 1 ] || [ $# -gt 2 ]; then
  echo "usage: $0 FOLDER [SUITE]" >&2
  exit 2
fi
suite=${2:-trixie}
mkdir -p "$1"
target=$(cd "$1" && pwd)

mirror=${DEBIAN_MIRROR:-$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' |
                          grep -E '/debian/?$' | head -n 1)}
mirror=${mirror:-http://deb.debian.org/debian}

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir -p "$scratch/state/lists/partial" "$scratch/cache/archives/partial"
: > "$scratch/status"
echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $mirror $suite main" \
  > "$scratch/sources.list"

private_apt() {
  apt-get -qq -o Dir::Etc::sourcelist="$scratch/sources.list" -o Dir::Etc::sourceparts=- \
          -o Dir::State="$scratch/state" -o Dir::State::status="$scratch/status" \
          -o Dir::Cache="$scratch/cache" -o APT::Sandbox::User= "$@"
}

private_apt update
(cd "$scratch" && private_apt download libcgal-dev)
dpkg-deb -x "$scratch"/libcgal-dev_*.deb "$target"

version=$(sed -n 's/^#define CGAL_VERSION \([0-9].*\)$/\1/p' "$target/usr/include/CGAL/version.h")
echo "CGAL $version: $target/usr/include"

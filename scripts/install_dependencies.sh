#!/usr/bin/env bash
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
#
# Installs what is missing to build and test PN_subdivision_3, from Debian packages only.
#
#   scripts/install_dependencies.sh [--compiler | --picture | --manual | --page | --python | --release]
#
#   --compiler: only what programs that use the package are compiled with; --picture: only what
#   scripts/render.py needs; --manual: also what the target doc needs; --page: only what the page needs; --python: only what
#   the module for Python, its wheel and their tests need; --release: what scripts/make_release.sh needs but for the page
set -euo pipefail

compiling=(g++ cmake ninja-build make libcgal-dev) # make: what CMake takes where no generator is named
drawing=(python3-vtk9 python3-numpy xvfb)
of_python=(python3-dev pybind11-dev python3-numpy python3-pytest python3-mesonpy python3-pip mypy)
required=("${compiling[@]}" libeigen3-dev libboost-dev libgmp-dev libmpfr-dev libgtest-dev)
optional=(libtbb-dev libcli11-dev nlohmann-json3-dev libbenchmark-dev libopenmesh-dev libosd-dev libcgal-demo libmpfi-dev python3
          clang lld libopenmpi-dev openmpi-bin pkgconf "${drawing[@]}" xauth)
case ${1:-} in
  --compiler)
    required=("${compiling[@]}")
    optional=()
    ;;
  --picture)
    required=()
    optional=("${drawing[@]}")
    ;;
  --page)
    required=(emscripten cmake ninja-build libcgal-dev libeigen3-dev libboost-dev)
    optional=(chromium) # its tests
    command -v node >/dev/null || required+=(nodejs)
    command -v npm >/dev/null || required+=(npm)
    ;;
  --python)
    required=("${compiling[@]}" libboost-dev "${of_python[@]}")
    optional=(clang libtbb-dev)
    ;;
  --release)
    required=("${compiling[@]}" libeigen3-dev libboost-dev libgmp-dev libmpfr-dev libtbb-dev libcli11-dev nlohmann-json3-dev
              python3 doxygen dpkg-dev lintian file xz-utils "${of_python[@]}")
    optional=(blahtexml)
    ;;
  --manual) optional+=(doxygen blahtexml) ;;
  "") ;;
  *)
    echo "usage: scripts/install_dependencies.sh [--compiler | --picture | --manual | --page | --python | --release]" >&2
    exit 2
    ;;
esac

cd "$(dirname "$0")/.."

# Archives with CGAL's real meshes and examples; lost where dpkg is told to leave out /usr/share/doc.
archives=/usr/share/doc/libcgal-dev
own_archives=build/debian

if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
  cat >&2 <<'TEXT'
This system is not Debian, so nothing is installed here. What PN_subdivision_3 needs:
  a C++17 compiler, CMake 3.21 or newer, Ninja, CGAL 5.5 or newer (with Boost, GMP and MPFR),
  Eigen 3.3 or newer, GoogleTest
and what it uses where it is found:
  TBB (threads), CLI11 and nlohmann-json (the command pn_subdivide), Google Benchmark, OpenMesh and OpenSubdiv (tests),
  MPI (the command on several machines),
  Python 3.11 or newer (a test of data/), with VTK and NumPy (pictures)
vcpkg.json names the same for vcpkg.
TEXT
  [[ ${#required[@]} -eq 0 ]] && exit 0
  command -v cmake >/dev/null && command -v ninja >/dev/null && exit 0
  echo "CMake or Ninja is missing: install the above and try again." >&2
  exit 1
fi

missing_of() {
  local package
  for package in "$@"; do
    [[ $(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null) == installed ]] ||
      echo "$package"
  done
}

as_root=()
if [[ $(id -u) != 0 ]]; then
  as_root=(sudo)
fi

apt() {
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -y -o DPkg::Lock::Timeout=600 "$@"
}

# by a call of this script a moment ago
has_recent_lists() {
  [[ -n $(find /var/lib/apt/lists -maxdepth 0 -mmin -15 2>/dev/null) &&
    -n $(find /var/lib/apt/lists -maxdepth 1 -name '*_Packages*' -print -quit 2>/dev/null) ]]
}

install_packages() {
  apt install --no-install-recommends "$@" >"$log" 2>&1
}

mapfile -t missing < <(missing_of "${required[@]}")
mapfile -t missing_optional < <(missing_of "${optional[@]}")

log=$(mktemp)
trap 'rm -f "$log"' EXIT

if [[ ${#missing[@]} -gt 0 || ${#missing_optional[@]} -gt 0 ]]; then
  if [[ $(id -u) != 0 ]] && ! command -v sudo >/dev/null; then
    echo "Not installed: ${missing[*]} ${missing_optional[*]}" >&2
    echo "There is no sudo. As root: apt-get install --no-install-recommends" \
         "${missing[*]} ${missing_optional[*]}" >&2
    [[ ${#missing[@]} -eq 0 ]] && exit 0
    exit 1
  fi
  echo "Installing: ${missing[*]} ${missing_optional[*]}"
  has_recent_lists || apt update >"$log" 2>&1 ||
    echo "The package lists could not be updated; trying those at hand." >&2
fi

if [[ ${#missing[@]} -gt 0 ]] && ! install_packages "${missing[@]}"; then
  tail -n 20 "$log" >&2
  echo "These packages are needed and could not be installed: ${missing[*]}" >&2
  exit 1
fi
if [[ ${#missing_optional[@]} -gt 0 ]] && ! install_packages "${missing_optional[@]}"; then
  for package in "${missing_optional[@]}"; do # one by one: keep what can be had
    install_packages "$package" ||
      echo "$package could not be installed; what needs it is left out." >&2
  done
fi

if [[ ${1:---manual} == --manual && ! -e $archives/data.tar.gz && ! -e $own_archives/data.tar.gz ]]; then
  mkdir -p "$own_archives"
  (
    cd "$own_archives"
    apt-get -q download libcgal-demo >"$log" 2>&1 &&
      dpkg-deb --fsys-tarfile libcgal-demo_*.deb |
        tar -x --strip-components=5 ".$archives/data.tar.gz" ".$archives/examples.tar.gz"
    rm -f libcgal-demo_*.deb
  )
  [[ -e $own_archives/data.tar.gz ]] ||
    echo "CGAL's meshes (package libcgal-demo) cannot be had; tests on them are skipped." >&2
fi

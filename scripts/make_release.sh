#!/usr/bin/env bash
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
#
# Makes what a release consists of, of a tag or another commit (default: HEAD), in build/release_files/VERSION:
# sources, a Debian package, a statically linked command, a wheel for Python, the manual, the page, the npm package, checksums.
# What that needs is installed (Debian packages, and npm's for the page).
#
#   scripts/make_release.sh [--maintainer "NAME <ADDRESS>"] [--without-page] [TAG or COMMIT]
#
# A tag vX.Y.Z makes release X.Y.Z, of which all files have to speak; nothing is tagged or published.
set -euo pipefail
cd "$(dirname "$0")/.."

fail() {
  echo "make_release.sh: $*" >&2
  exit 1
}

maintainer=
with_page=yes
while [[ ${1:-} == --* ]]; do
  case $1 in
    --maintainer) maintainer=${2:-} ; shift ;;
    --without-page) with_page=no ;;
    *) echo "usage: $0 [--maintainer \"NAME <ADDRESS>\"] [--without-page] [TAG or COMMIT]" >&2; exit 2 ;;
  esac
  shift
done
revision=${1:-HEAD}
commit=$(git rev-parse --verify --quiet "$revision^{commit}") || fail "$revision: there is no such tag or commit"
[[ -z $maintainer || $maintainer == *" <"*@*">" ]] || fail "--maintainer $maintainer: not of the form NAME <ADDRESS>"

SOURCE_DATE_EPOCH=$(git show -s --format=%ct "$commit")
export SOURCE_DATE_EPOCH # the same commit makes the same archives

number_of_cmake() {
  git show "$commit:CMakeLists.txt" | sed -n 's/^ *VERSION \([0-9.]*\)$/\1/p'
}

tag=$(git tag --points-at "$commit" 'v[0-9]*' | head -n 1)
if [[ -n $tag ]]; then
  version=${tag#v}
  npm_version=$version
else
  of_commit=$(date -u -d "@$SOURCE_DATE_EPOCH" +%Y%m%d%H%M).g$(git rev-parse --short=9 "$commit")
  version=$(number_of_cmake)~git$of_commit # sorts before the release
  npm_version=$(number_of_cmake)-git.$of_commit
fi

files=$PWD/build/release_files/$version
work=$PWD/build/release_work
name=pn_subdivision_3-$version
rm -rf "$files" "$work"
mkdir -p "$files" "$work"

echo "Version $version"
scripts/install_dependencies.sh --release

echo "Sources"
git archive --format=tar --prefix="$name/" "$commit" | xz -9 -T1 >"$files/$name.tar.xz"
mkdir "$work/source"
tar -xJf "$files/$name.tar.xz" -C "$work/source" --strip-components=1
cd "$work/source"

configure() { # FOLDER OPTION...
  local folder=$1
  shift
  cmake -S . -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX=/usr -DPN_SUBDIVISION_3_TESTS=OFF \
    -DPN_SUBDIVISION_3_EXAMPLES=OFF -DPN_SUBDIVISION_3_BENCHMARKS=OFF "$@"
}

attempt() { # WHAT COMMAND...
  "${@:2}" >"$work/log.txt" 2>&1 || {
    tail -n 40 "$work/log.txt" >&2
    fail "$1 could not be built"
  }
}

build() { # FOLDER TARGET
  attempt "target $2" cmake --build "$1" --target "$2"
}

if [[ -n $tag ]]; then
  [[ $(number_of_cmake) == "$version" ]] || fail "the tag is $tag, but CMakeLists.txt says $(number_of_cmake)"
  grep -qx "## $version" CHANGES.md || fail "CHANGES.md: the section $version is missing or still in development"
  python3 -B -c 'import sys
sys.path.insert(0, "scripts")
import check_sources
sys.exit("\n".join(check_sources.check_version()) or 0)' || fail "the files above are not of version $version"
fi

echo "Debian package"
hardening=$(dpkg-buildflags --get CXXFLAGS | sed 's/-g //; s/-ffile-prefix-map=[^ ]* //; s/-O2//')
configure "$work/deb" -DCMAKE_CXX_FLAGS="$hardening $(dpkg-buildflags --get CPPFLAGS)" \
  -DCMAKE_CXX_FLAGS_RELEASE="-O2 -DNDEBUG" -DCMAKE_EXE_LINKER_FLAGS="$(dpkg-buildflags --get LDFLAGS)" \
  -DCMAKE_POSITION_INDEPENDENT_CODE=ON -DPN_PACKAGE_VERSION="$version" \
  -DCMAKE_INSTALL_DOCDIR=share/doc/pn-subdivision-3 ${maintainer:+"-DPN_PACKAGE_CONTACT=$maintainer"} >"$work/log.txt"
build "$work/deb" pn_subdivide
(cd "$work/deb" && cpack -G DEB >"$work/log.txt") || { cat "$work/log.txt" >&2; fail "cpack has failed"; }
mv "$work"/deb/*.deb "$files/"
# only Debian can give a bug number that the first upload closes, and only a maintainer an address
unwanted=(initial-upload-closes-no-bugs)
[[ -n $maintainer ]] || unwanted+=(bogus-mail-host bogus-mail-host-in-debian-changelog)
lintian --allow-root --fail-on error,warning --suppress-tags "$(IFS=,; echo "${unwanted[*]}")" "$files"/*.deb ||
  fail "lintian objects to the Debian package"

echo "Statically linked command"
archive_of() {
  g++ -print-file-name="lib$1.a"
}
configure "$work/static" -DCMAKE_CXX_FLAGS_RELEASE="-O2 -DNDEBUG" -DCMAKE_EXE_LINKER_FLAGS="-static -s" \
  -DPN_SUBDIVISION_3_WITH_TBB=OFF -DPN_SUBDIVISION_3_INSTALL=OFF \
  -DGMP_LIBRARY_RELEASE="$(archive_of gmp)" -DGMPXX_LIBRARIES="$(archive_of gmpxx)" -DMPFR_LIBRARIES="$(archive_of mpfr)" \
  >"$work/log.txt"
# before minutes of compilation
[[ $(ninja -C "$work/static" -t commands pn_subdivide | tail -n 1) != *.so\ * ]] || fail "the command would be linked with shared libraries"
build "$work/static" pn_subdivide
program=$work/static/src/pn_subdivide/pn_subdivide
[[ $(file -b "$program") == *"statically linked"* ]] || fail "$program is not statically linked"
"$program" data/meshes/cube.off "$work/sphere.ply" --levels 3 --normals sphere:0,0,0 --quiet # it runs, too
folder=pn_subdivide-$version-linux-$(uname -m)
mkdir -p "$work/$folder"
cp "$program" src/pn_subdivide/pn_subdivide.1 LICENSE.GPL "$work/$folder/"

pack() { # ARCHIVE FOLDER
  tar -C "$work" --sort=name --owner=0 --group=0 --numeric-owner --mtime="@$SOURCE_DATE_EPOCH" -c "$2" | xz -9 -T1 >"$1"
}
pack "$files/$folder.tar.xz" "$folder"

echo "Wheel"
# without TBB, hence with one thread: it needs nothing but the libraries of C and C++
attempt "the wheel" /usr/bin/python3 -m pip wheel --quiet --no-index --no-deps --no-build-isolation \
  --config-settings=setup-args=-Dtbb=disabled -w "$files" ./python
scripts/test_python.sh --offline --command "$program" --wheel "$(echo "$files"/*.whl)"

echo "Manual"
build "$work/static" doc
mv "$work/static/doc/html" "$work/$name-manual"
pack "$files/$name-manual.tar.xz" "$name-manual"

if [[ $with_page == yes ]]; then
  echo "Page and npm package"
  attempt "the page" scripts/build_page.sh "$files/pn_subdivision_3-$version.html"
  npm pkg set "version=$npm_version" --prefix build/page/library
  npm pack ./build/page/library --pack-destination "$files" --silent >/dev/null
fi

cd "$files"
sha256sum -- * >"$work/SHA256SUMS"
mv "$work/SHA256SUMS" .
rm -rf "$work"
echo "In $files:"
ls -l --block-size=K | tail -n +2 | cut -d ' ' -f 5-

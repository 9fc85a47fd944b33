#!/usr/bin/env bash
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
#
# clang-format over all sources, clang-tidy over all headers, the README's example and the command (Debian packages
# clang, clang-format and clang-tidy). With file names: clang-tidy over these. All takes half an hour on two cores.
#
#   scripts/check_style.sh [SOURCE.cpp...]
set -euo pipefail
cd "$(dirname "$0")/.."

git ls-files -co --exclude-standard '*.h' '*.cpp' | xargs -r clang-format --dry-run -Werror
echo "clang-format: clean"

cmake --preset tidy >/dev/null
if [[ $# -gt 0 ]]; then
  sources=("$@")
else
  sources=(build/tidy/generated/headers_alone/all_headers.cpp
           examples/PN_subdivision_3/readme_example.cpp)
  mapfile -t -O 2 sources < <(git ls-files -co --exclude-standard 'src/*.cpp')
fi
printf '%s\0' "${sources[@]}" |
  xargs -0 -n 1 -P "$(nproc)" clang-tidy --quiet -p build/tidy --extra-arg=-Wno-unknown-warning-option
echo "clang-tidy: clean"

#!/usr/bin/env bash
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
#
# Builds the page and the library for JavaScript (scripts/build_page.sh) and tests them in headless Chromium, in Firefox where it
# is installed, and in Node.js, against the command.
#
#   scripts/test_page.sh [--offline] [--measure] [--command PN_SUBDIVIDE]
#
# --offline: nothing is installed; --measure: only measures how fast it is; --command: a build of the
# command pn_subdivide of these sources; without it, it is built.
set -euo pipefail
cd "$(dirname "$0")/.."

offline=()
measure=no
command=
while [[ $# -gt 0 ]]; do
  case $1 in
    --offline) offline=(--offline) ;;
    --measure) measure=yes ;;
    --command) command=$2; shift ;;
    *) echo "usage: $0 [--offline] [--measure] [--command PN_SUBDIVIDE]" >&2; exit 2 ;;
  esac
  shift
done

page=build/page/pn_subdivision_3.html
tests=demo/PN_subdivision_3/test
scripts/build_page.sh "${offline[@]}" $page
if [[ $measure == yes ]]; then
  exec node $tests/measure_page.mjs $page
fi
if [[ -z $command ]]; then
  scripts/build.sh pn_subdivide
  command=build/release/src/pn_subdivide/pn_subdivide
fi
export PN_PAGE=$page PN_LIBRARY=build/page/library PN_MODELER=build/page/modeler PN_SUBDIVIDE=$command
node --test $tests/test_*.mjs
if [[ -x ${FIREFOX:-/usr/bin/firefox-esr} ]]; then
  # what a visit begins with, and of the rest what browsers do each in their way
  export PN_BROWSER=firefox
  node --test $tests/test_visits.mjs
  node --test --test-name-pattern="browsers|chosen last|beside a surface|dropped together|every scheme takes every roundness: made|nobody has caught|own file|no manifold|GLB is|belongs to a mesh|announced|OBJ, STL|files are those|surfaces with creases|flat or smooth" \
    $tests/test_{library,worker,page,outputs,pictures}.mjs
else
  echo "left out: Firefox is not installed"
fi

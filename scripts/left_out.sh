#!/usr/bin/env bash
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
#
# Says what tests were left out because something is missing (cmake/PN_tiers.cmake): a line for each, and a
# last one that counts and names them. With --strict the exit code is 1 if there are any but optional ones.
#
#   scripts/left_out.sh [--strict] BUILD_FOLDER...       folders in which ctest has run
set -euo pipefail

strict=no
if [[ ${1:-} == --strict ]]; then
  strict=yes
  shift
fi
[[ $# -gt 0 ]] || { sed -n '/^#   scripts/p' "$0" >&2; exit 2; }

logs=()
for folder; do
  log=$folder/Testing/Temporary/LastTest.log
  grep -q " Test: " "$log" || { echo "$log has no tests: run ctest first" >&2; exit 2; }
  logs+=("$log")
done

# In a log "7/12 Test: NAME" and the command precede the output of a test.
awk -v strict=$strict '
  function leave_out(reason, optional) {
    if (seen[test, reason]++) return
    print "left out: " test ": " reason
    if (named[test]++) return
    names = names (names == "" ? "" : ", ") test
    ++count
    needed += !optional
  }
  /^[0-9]+\/[0-9]+ Test: / { test = $3; sub(/^left_out\./, "", test); said_why = 0 }
  /^Output:$/ { in_output = 1 }
  /^<end of output>$/ { in_output = 0 }
  in_output && /^left out(, as it may be)?: / {
    said_why = 1
    reason = $0
    sub(/^[^:]*: /, "", reason)
    leave_out(reason, /^left out, as it may be: /)
  }
  in_output && /^does not apply: / { said_why = 1 }
  /^Skip regular expression found in output/ && !said_why { leave_out("skipped, and does not say why", 0) }
  END {
    if (count == 0) print "No test was left out."
    else print count (count == 1 ? " test" : " tests") " left out, since something is missing: " names
    exit strict == "yes" && needed > 0
  }' "${logs[@]}"

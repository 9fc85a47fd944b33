#!/usr/bin/env python3
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""The tests that passed with the very program, command and data that are there now: scripts/test.sh does not run these again.

  scripts/unchanged_tests.py [--record] BUILD_FOLDER

Prints a regular expression for ctest --exclude-regex. With --record, after ctest: notes what has passed, but for tests that left
something out. The notes are in BUILD_FOLDER/passed.json.
"""
import hashlib
import json
import os
import pathlib
import re
import sys

SOURCES = pathlib.Path(__file__).resolve().parent.parent


def digest(*files):
    result = hashlib.sha256()
    for file in files:
        result.update(file.read_bytes())
    return result.hexdigest()


def programs(build):
    """Those of GoogleTest, with what they depend on; other tests read the sources, and take no time."""
    data = digest(*sorted(f for f in (SOURCES / "data").rglob("*") if f.is_file()))
    command = digest(*sorted(f for f in (build / "src/pn_subdivide").glob("pn_subdivide*") if f.suffix == ""),
                     SOURCES / "src/pn_subdivide/pn_subdivide.1")
    files = [f for f in build.glob("test/PN_subdivision_3/test_*") if f.is_file() and os.access(f, os.X_OK)]
    return {f.name: [digest(f), data] + [command] * bool(re.search("command|subdivide", f.name)) for f in files}


def passed(build):
    log = (build / "Testing/Temporary/LastTest.log").read_text(errors="replace")
    for section in re.split(r"^\d+/\d+ Test: ", log, flags=re.M)[1:]:
        if "\nTest Passed.\n" in section and "left out" not in section:
            yield section.split("\n", 1)[0]


def main(arguments):
    if len(arguments) not in (1, 2) or arguments[:-1] not in ([], ["--record"]):
        sys.exit(__doc__)
    build = pathlib.Path(arguments[-1]).resolve()
    notes = build / "passed.json"
    known = json.loads(notes.read_text()) if notes.exists() else {}
    there = programs(build)
    if arguments[0] == "--record":
        known.update((name, there[name]) for name in passed(build) if name in there)
        notes.write_text(json.dumps(known, indent=1))
    else:
        print("^(" + "|".join(sorted(name for name in there if known.get(name) == there[name])) + ")$")


if __name__ == "__main__":
    main(sys.argv[1:])

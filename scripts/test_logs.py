#!/usr/bin/env python3
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""What ctest has logged in build folders, for scripts/test.sh.

  scripts/test_logs.py --unchanged FOLDER    prints a regular expression for ctest --exclude-regex: the tests that passed with the
                                             very program, command and data that are there now, and are not run again
  scripts/test_logs.py --record FOLDER       notes in FOLDER/passed.json what has passed, but for tests that left something out
  scripts/test_logs.py --left-out [--strict] FOLDER...
                                             names the tests that were left out because something is missing (cmake/PN_tiers.cmake),
                                             and counts them; --strict: exit code 1 if there are any but optional ones
"""
import hashlib
import json
import os
import pathlib
import re
import sys

SOURCES = pathlib.Path(__file__).resolve().parent.parent


def sections(build):
    """Name and text of each test in the log."""
    log = build / "Testing/Temporary/LastTest.log"
    found = re.split(r"(?m)^\d+/\d+ Test: (.*)\n", log.read_text(errors="replace") if log.exists() else "")[1:]
    if not found:
        print(f"{log} has no tests: run ctest first", file=sys.stderr)
        sys.exit(2)
    return zip(found[::2], found[1::2])


# --- what has passed ---


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


def passed(build, record):
    notes = build / "passed.json"
    known = json.loads(notes.read_text()) if notes.exists() else {}
    there = programs(build)
    if record:
        good = [name for name, text in sections(build) if "\nTest Passed.\n" in text and "left out" not in text]
        known.update((name, there[name]) for name in good if name in there)
        notes.write_text(json.dumps(known, indent=1))
    else:
        print("^(" + "|".join(sorted(name for name in there if known.get(name) == there[name])) + ")$")


# --- what was left out ---


def reasons(text):
    """Why a test was left out, and whether it may be."""
    output = "".join(re.findall(r"(?ms)^Output:\n(.*?)^<end of output>$", text))
    found = [(reason, optional != "") for optional, reason in re.findall(r"(?m)^left out(, as it may be)?: (.*)", output)]
    is_silent = not found and not re.search("(?m)^does not apply: ", output)
    return found + [("skipped, and does not say why", False)] * (is_silent and "\nSkip regular expression found in output" in text)


def left_out(builds, strict):
    told, may_be = set(), {}
    for name, text in [section for build in builds for section in sections(build)]:
        name = name.removeprefix("left_out.")
        for reason, optional in reasons(text):
            if (name, reason) not in told:
                print(f"left out: {name}: {reason}")
            told.add((name, reason))
            may_be.setdefault(name, optional)
    print(f"{len(may_be)} test{'s' * (len(may_be) > 1)} left out, since something is missing: {', '.join(may_be)}" if may_be else
          "No test was left out.")
    sys.exit(int(strict and not all(may_be.values())))


def main(arguments):
    options = [word for word in arguments if word.startswith("--")]
    builds = [pathlib.Path(word).resolve() for word in arguments[len(options):]]
    if options in (["--unchanged"], ["--record"]) and len(builds) == 1:
        passed(builds[0], options == ["--record"])
    elif options in (["--left-out"], ["--left-out", "--strict"]) and builds:
        left_out(builds, len(options) > 1)
    else:
        sys.exit(__doc__)


if __name__ == "__main__":
    main(sys.argv[1:])

#!/usr/bin/env python3
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Which lines of include/ the tests run.

    scripts/coverage.py [--least PERCENT] [--jobs N] [TEST...]

Builds the tests (or those named, as test_curves) in build/coverage with g++ --coverage at -O0, runs them and asks
gcov, nothing else is needed. A line counts once, as run if any instance of its template ran. Prints every file
below 100 % with its lines that no test runs, then the sum. Exit code 1 below --least (default 95, for all tests).
"""

import argparse
import collections
import gzip
import json
import os
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
BUILD = ROOT / "build" / "coverage"


def build_and_run(tests, jobs):
    subprocess.run(["cmake", "-S", ROOT, "-B", BUILD, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Debug",
                    "-DCGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE=ON", "-DCMAKE_CXX_FLAGS=--coverage -O0 -g0",
                    "-DPN_TEST_OPTIMIZATION=-O0", "-DPN_SUBDIVISION_3_BENCHMARKS=OFF",
                    "-DPN_SUBDIVISION_3_EXAMPLES=OFF"], check=True, stdout=subprocess.DEVNULL)
    subprocess.run(["cmake", "--build", BUILD, "-j", str(jobs), *(["--target", *tests] if tests else [])], check=True)
    for old in BUILD.rglob("*.gcda"):
        old.unlink()
    select = ["-R", "^(" + "|".join(tests) + r")(\.|$)"] if tests else []
    run = subprocess.run(["ctest", "--test-dir", BUILD, "-j", str(jobs), "--no-tests=error", "-Q", *select])
    if run.returncode != 0:
        print("some tests fail")


def counts():
    """For each header of include/ how often its lines ran, all object files together."""
    result = collections.defaultdict(collections.Counter)
    for data in BUILD.rglob("*.gcda"):
        run = subprocess.run(["gcov", "--json-format", "--stdout", str(data)], capture_output=True, cwd=data.parent)
        text = gzip.decompress(run.stdout) if run.stdout[:2] == b"\x1f\x8b" else run.stdout
        for document in text.splitlines():
            for file in json.loads(document)["files"]:
                path = pathlib.Path(os.path.normpath(data.parent / file["file"]))
                if not path.is_absolute() or ROOT / "include" not in path.parents:
                    path = pathlib.Path(os.path.normpath(BUILD / file["file"]))
                if ROOT / "include" in path.parents:
                    for line in file["lines"]:
                        result[path.relative_to(ROOT / "include")][line["line_number"]] += line["count"]
    return result


def ranges(numbers):
    parts = []
    for n in numbers:
        if parts and n == parts[-1][1] + 1:
            parts[-1][1] = n
        else:
            parts.append([n, n])
    return ", ".join(str(a) if a == b else f"{a}-{b}" for a, b in parts)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tests", nargs="*", metavar="TEST")
    parser.add_argument("--least", type=float)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--report-only", action="store_true", help="of what has been run before")
    options = parser.parse_args()
    if not options.report_only:
        build_and_run(options.tests, options.jobs)

    lines = run = 0
    files = counts()
    for path, count in sorted(files.items()):
        missed = sorted(n for n, times in count.items() if times == 0)
        lines += len(count)
        run += len(count) - len(missed)
        if missed:
            print(f"{100 * (1 - len(missed) / len(count)):5.1f} %  {path}: {ranges(missed)}")
    unseen = [p.relative_to(ROOT / "include") for p in (ROOT / "include").rglob("*.h")
              if p.relative_to(ROOT / "include") not in files]
    if unseen:
        print("without code that these tests compile: " + ", ".join(map(str, sorted(unseen))))
    percent = 100 * run / max(lines, 1)
    print(f"{percent:.1f} % of {lines} lines in {len(files)} headers")
    least = options.least if options.least is not None else (0 if options.tests else 95)
    return 0 if percent >= least else 1


if __name__ == "__main__":
    sys.exit(main())

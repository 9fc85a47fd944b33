#!/usr/bin/env python3
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Which lines of include/ and test_support/ the tests run.

    scripts/coverage.py [--least PERCENT] [--jobs N] [TEST...]
    scripts/coverage.py --build build/asan-ubsan

The preset asan-ubsan compiles for this, too (clang++ -fprofile-instr-generate -fcoverage-mapping, and nothing
precompiled: clang++ 14 maps no lines of headers that are): scripts/sanitize.sh address builds it (or the programs named, as
test_curves) and runs the tests, in more than an hour on two cores. With --build it only counts what has been run in
a folder: all *.profraw and all programs there. Needs llvm-profdata and llvm-cov of
the version of clang++.

A line counts once, as run if any instance of its template ran. Prints every file below 100 % with its lines that no
test runs, then the sum. Exit code 1 below --least (default 95, for all tests).
"""

import argparse
import collections
import os
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
BUILD = ROOT / "build" / "asan-ubsan"
FOLDERS = (ROOT / "include", ROOT / "test_support")
# compiled, never run: what a parameter has to offer, for messages of static assertions
COMPILED_ONLY = {"concept_checks.h"}


def build_and_run(tests, jobs):
    for old in (BUILD / "profiles").glob("*.profraw"):
        old.unlink()
    run = subprocess.run(["scripts/sanitize.sh", "address", *tests], cwd=ROOT, env={**os.environ, "JOBS": str(jobs)})
    if run.returncode != 0:
        print("some tests fail")


def programs(build):
    names = [p for pattern in ("test_*", "smoke_*", "pn_subdivide") for p in build.rglob(pattern)]
    return sorted(p for p in names if p.is_file() and not p.suffix and os.access(p, os.X_OK))


def counts(build):
    """For each header of the package, and of test_support/, how often its lines ran, all programs together."""
    profiles = [str(p) for p in build.rglob("*.profraw") if p.stat().st_size > 0]
    if not profiles:
        sys.exit(f"{build}: no profiles; run the tests first, by scripts/sanitize.sh address")
    merged = build / "all.profdata"
    subprocess.run(["llvm-profdata", "merge", "-sparse", "-o", merged, *profiles], check=True)
    result = collections.defaultdict(collections.Counter)
    for program in programs(build):
        run = subprocess.run(["llvm-cov", "export", "-format=lcov", "-ignore-filename-regex=^/usr/",
                              f"-instr-profile={merged}", program], capture_output=True, text=True)
        if run.returncode != 0:
            print(f"{program.name}: not counted ({run.stderr.strip().splitlines()[-1]})")
        count = None
        for line in run.stdout.splitlines():
            if line.startswith("SF:"):
                path = pathlib.Path(os.path.normpath(line[3:]))
                folder = next((f for f in FOLDERS if f in path.parents), None)
                count = result[path.relative_to(folder)] if folder and path.name not in COMPILED_ONLY else None
            elif line.startswith("DA:") and count is not None:
                number, times = line[3:].split(",")[:2]
                count[int(number)] += int(times)
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
    parser.add_argument("--build", type=pathlib.Path, help="count what has been run in this folder")
    options = parser.parse_args()
    if options.build is None:
        build_and_run(options.tests, options.jobs)
    build = (options.build or BUILD).resolve()

    lines = run = 0
    files = counts(build)
    for path, count in sorted(files.items()):
        missed = sorted(n for n, times in count.items() if times == 0)
        lines += len(count)
        run += len(count) - len(missed)
        if missed:
            print(f"{100 * (1 - len(missed) / len(count)):5.1f} %  {path}: {ranges(missed)}")
    unseen = [p.relative_to(folder) for folder in FOLDERS for p in folder.rglob("*")
              if p.suffix in (".h", ".cpp") and p.relative_to(folder) not in files and p.name not in COMPILED_ONLY]
    if unseen:
        print("without code that these tests compile: " + ", ".join(map(str, sorted(unseen))))
    percent = 100 * run / max(lines, 1)
    print(f"{percent:.1f} % of {lines} lines in {len(files)} headers")
    least = options.least if options.least is not None else (0 if options.tests else 95)
    return 0 if percent >= least else 1


if __name__ == "__main__":
    sys.exit(main())

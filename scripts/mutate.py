#!/usr/bin/env python3
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Puts small wrong changes into the headers, one at a time, and runs the tests that must notice.

    scripts/mutate.py [--list] [--check] [--unchanged] [--first N] [NAME...]

NAME is a part of a name in scripts/mutations.toml; without one all are tried, which takes hours of one core: only
the named tests are compiled for each, at -O0, by $CXX or clang++. --check tells whether every pattern is still found, --unchanged
runs the tests of the selection on headers as they are (all have to pass), --first tries the first N.
Exit code 1 if a change survives that is not expected to, or cannot be made.
"""

import argparse
import os
import pathlib
import re
import resource
import shutil
import subprocess
import sys
import tomllib

ROOT = pathlib.Path(__file__).resolve().parent.parent
TESTS = ROOT / "test" / "PN_subdivision_3"
HEADERS = pathlib.Path("CGAL") / "PN_subdivision_3"
WORK = ROOT / "build" / "mutate"
TIME_LIMIT = 600  # seconds of one test
MEMORY_LIMIT = 4 << 30  # bytes, for wrong changes that do not end
COMPILER = os.environ.get("CXX") or shutil.which("clang++") or "g++"  # clang++ takes half the time
OPTIONS = ["-std=c++17", "-O0", "-w", "-DNOMINMAX", "-frounding-math", f"-I{TESTS}", f"-I{TESTS}/support",
           "-isystem", "/usr/include/eigen3"]


def mutations():
    with open(ROOT / "scripts" / "mutations.toml", "rb") as file:
        return tomllib.load(file)["mutation"]


def changed_text(mutation):
    """The file with the change, None if the pattern is not found exactly once or more."""
    text = (ROOT / "include" / HEADERS / mutation["file"]).read_text()
    words = (re.escape(word) for word in mutation["pattern"].split())
    pattern = re.compile(r"\s*".join(words))
    changed = pattern.sub(lambda _: mutation["replacement"], text)
    return None if changed == text else changed


def compile_references():
    """The reference implementations, which include nothing of the package."""
    for source in (TESTS / "reference").glob("*.cpp"):
        subprocess.run([COMPILER, *OPTIONS, "-c", str(source), "-o", str(WORK / (source.stem + ".o"))], check=True)


def compile_and_run(test, include):
    """What a test says of the headers in a folder: None if it passes, otherwise what failed."""
    program = WORK / test.replace("/", "_")
    program.unlink(missing_ok=True)
    command = [COMPILER, *OPTIONS, f"-I{include}", f'-DPN_DATA_DIR="{ROOT}/data/meshes"',
               f'-DPN_TEST_REAL_MESH_DIR="{WORK}"', '-DPN_TEST_EXTRA_MESH_DIR=""', str(TESTS / (test + ".cpp")),
               *map(str, WORK.glob("*.o")), "-o", str(program), "-lgtest", "-lgtest_main", "-lmpfr", "-lgmp",
               "-lpthread"]
    compilation = subprocess.run(command, capture_output=True, text=True)
    if compilation.returncode != 0:
        errors = [line for line in compilation.stderr.splitlines() if "error" in line]
        return "does not compile: " + (errors[0] if errors else compilation.stderr[:200])
    try:
        run = subprocess.run([program, "--gtest_fail_fast", "--gtest_brief=1"], capture_output=True, text=True,
                             errors="replace", timeout=TIME_LIMIT,
                             preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (MEMORY_LIMIT, MEMORY_LIMIT)))
    except subprocess.TimeoutExpired:
        return "does not end"
    if run.returncode == 0:
        return None
    failed = [line.split("]")[1].split(",")[0].split("(")[0].strip()
              for line in run.stdout.splitlines() if line.startswith("[  FAILED  ]") and "." in line]
    return failed[0] if failed else f"ends with {run.returncode}"


def try_mutation(mutation):
    """Whether all is as it should be; says what happened."""
    changed = changed_text(mutation)
    if changed is None:
        print(f"NOT FOUND  {mutation['name']}: {mutation['file']} lacks the pattern", flush=True)
        return False
    include = WORK / "include"
    file = include / HEADERS / mutation["file"]
    original = file.read_text()
    file.write_text(changed)
    try:
        for test in mutation["tests"]:
            failure = compile_and_run(test, include)
            if failure is not None and failure.startswith("does not compile"):
                print(f"INVALID    {mutation['name']}: {test} {failure}", flush=True)
                return False
            if failure is not None:
                print(f"caught     {mutation['name']}: {test}, {failure}", flush=True)
                return True
    finally:
        file.write_text(original)
    reason = mutation.get("survives")
    print(f"{'survives   ' if reason else 'SURVIVED   '}{mutation['name']}: {reason or mutation['tests']}", flush=True)
    return reason is not None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", metavar="NAME")
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--unchanged", action="store_true")
    parser.add_argument("--first", type=int)
    options = parser.parse_args()

    selected = [m for m in mutations()
                if not options.names or any(name in m["name"] for name in options.names)][:options.first]
    if options.list:
        for m in selected:
            print(m["name"])
        return 0
    if options.check:
        lost = [m["name"] for m in selected if changed_text(m) is None]
        for name in lost:
            print(f"NOT FOUND  {name}")
        print(f"{len(selected) - len(lost)} of {len(selected)} patterns are found")
        return 1 if lost else 0

    shutil.rmtree(WORK, ignore_errors=True)
    shutil.copytree(ROOT / "include", WORK / "include")
    compile_references()
    if options.unchanged:
        tests = sorted({test for m in selected for test in m["tests"]})
        results = {test: compile_and_run(test, WORK / "include") for test in tests}
    else:
        results = {m["name"]: None if try_mutation(m) else "see above" for m in selected}
    bad = {name: result for name, result in results.items() if result is not None}
    for name, result in bad.items():
        print(f"not as expected: {name}: {result}")
    print(f"{len(results) - len(bad)} of {len(results)} as expected")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())

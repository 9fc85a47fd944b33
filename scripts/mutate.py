#!/usr/bin/env python3
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Puts small wrong changes into the headers, one at a time, and runs the tests that must notice.

    scripts/mutate.py [--check] [--bare] [--tiers] [--unchanged] [--again] [--jobs N] [NAME...]

NAME is a part of a name in scripts/mutations.toml; without one all are tried, which takes an hour or two: only the
named tests are compiled for each, at -O0, by $CXX or clang++, up to the first that fails. Verdicts are added to
scripts/mutation_results.tsv; changes that have one there are only tried with --again. --check tells whether every
pattern is still found, --bare lists the headers of 100 lines and more that no change touches, --tiers the changes that no test of
scripts/test.sh is known to catch, with the long test that does (exit code 1 if they are more than 5 %), --unchanged runs the
tests of the selection on headers as they are (all have to pass). manual_pages.py writes the page of the manual from the verdicts.
Exit code 1 if a change survives that is not expected to, or cannot be made.
"""

import argparse
import concurrent.futures
import os
import pathlib
import queue
import re
import shutil
import signal
import subprocess
import sys
import threading
import time
import tomllib

ROOT = pathlib.Path(__file__).resolve().parent.parent
TESTS = ROOT / "test" / "PN_subdivision_3"
HEADERS = pathlib.Path("CGAL")
FOLDERS = ("include", "test_support")
RESULTS = ROOT / "scripts" / "mutation_results.tsv"
WORK = ROOT / "build" / "mutate"
TIME_LIMIT = 1800  # seconds of one change, after which there is no verdict
PROCESSOR_LIMIT = 240  # seconds of one test; far beyond what any takes
MEMORY_LIMIT = 4 << 30  # bytes of one test
# clang++ takes half the time; "ccache clang++" spares sources that do not see the change
COMPILER = (os.environ.get("CXX") or shutil.which("clang++") or "g++").split()
IS_CLANG = "clang" in COMPILER[-1]
OPTIONS = ["-std=c++17", "-O0", "-w", "-DNOMINMAX", "-DPN_TEST_LONG_CASES", "-frounding-math",
           "-isystem", "/usr/include/eigen3"]
# precompiled once: no change alters them
THIRD_PARTY = ["gtest/gtest.h", "CGAL/Exact_predicates_exact_constructions_kernel.h", "CGAL/Polyhedron_3.h",
               "CGAL/Simple_cartesian.h", "CGAL/Surface_mesh.h", "CGAL/subdivision_method_3.h", "Eigen/Dense"]
STATIC = "a static_assert of the test: "
# what the build has where it finds libraries; the TBB is that of the thread sanitizer
OPTIONS_OF_TESTS = {"kernels/test_enclose": ["-DCGAL_USE_MPFI", "-lmpfi"],
                    "kernels/test_kernels_parallel": ["-DCGAL_LINKED_WITH_TBB", f"-I{TESTS}/threads"]}
if pathlib.Path("/usr/include/opensubdiv").exists():
    for peer in ("attributes/test_texture_opensubdiv", "creases/test_creases_opensubdiv"):
        OPTIONS_OF_TESTS[peer] = ["-DPN_TEST_WITH_OPENSUBDIV", "-losdCPU"]
LONG = 100  # lines of a header that should have a change
COLUMNS = ["name", "verdict", "test", "what failed", "seconds"]
printing = threading.Lock()


def mutations():
    with open(ROOT / "scripts" / "mutations.toml", "rb") as file:
        return tomllib.load(file)["mutation"]


def file_of(mutation, root):
    name = mutation["file"]
    return root / name if name.startswith("test_support/") else root / "include" / HEADERS / name


def changed_text(mutation):
    """The file with the change, None if the pattern is not found exactly once or more."""
    text = file_of(mutation, ROOT).read_text()
    words = (re.escape(word) for word in mutation["pattern"].split())
    pattern = re.compile(r"\s*".join(words))
    changed = pattern.sub(lambda _: mutation["replacement"], text)
    return None if changed == text else changed


def bare_headers():
    """Lines and names of long headers without a change, the longest first."""
    touched = {m["file"] for m in mutations()}
    folder = ROOT / "include" / HEADERS
    lines = {str(f.relative_to(folder)): f.read_text().count("\n") for f in folder.rglob("*.*")}
    return sorted(((n, name) for name, n in lines.items() if n >= LONG and name not in touched), reverse=True)


# --- verdicts ---


def read_results():
    if not RESULTS.exists():
        return {}
    rows = [line.split("\t") for line in RESULTS.read_text().splitlines()[1:]]
    return {row[0]: dict(zip(COLUMNS, row)) for row in rows}


def add_result(result):
    with printing:
        results = {**read_results(), result["name"]: result}
        order = {m["name"]: i for i, m in enumerate(mutations())}
        rows = sorted((r for r in results.values() if r["name"] in order), key=lambda r: order[r["name"]])
        RESULTS.write_text("\n".join("\t".join(map(str, row)) for row in [COLUMNS, *(r.values() for r in rows)]) + "\n")
        print(f"{result['verdict']:<9} {result['name']}: {result['test']} {result['what failed']}", flush=True)


def caught_late():
    """The changes that are caught, and those of them by a long test."""
    long = set((TESTS / "long_tests.txt").read_text().split())
    caught = [r for r in read_results().values() if r["verdict"] == "caught"]
    return caught, [r for r in caught if {pathlib.PurePath(r["test"]).name, r["what failed"]} & long]


# --- compilation ---


def prepare(jobs):
    """Folders with a copy of the headers for each job, the third-party headers and the references compiled."""
    os.environ.setdefault("CCACHE_SLOPPINESS", "pch_defines,time_macros")
    WORK.mkdir(parents=True, exist_ok=True)
    folders = queue.Queue()
    for job in range(jobs):
        folder = WORK / str(job)
        shutil.rmtree(folder, ignore_errors=True)
        for name in FOLDERS:
            shutil.copytree(ROOT / name, folder / name)
        folders.put(folder)
    header = WORK / "third_party.h"
    if IS_CLANG and not header.with_suffix(".pch").exists():
        header.write_text("".join(f"#include <{name}>\n" for name in THIRD_PARTY))
        subprocess.run([*COMPILER, *OPTIONS, "-x", "c++-header", str(header), "-o", str(header.with_suffix(".pch"))],
                       check=True)
    for source in (TESTS / "reference").glob("*.cpp"):
        subprocess.run([*COMPILER, *OPTIONS, "-c", str(source), "-o", str(WORK / (source.stem + ".o"))], check=True)
    return folders


def sources(test):
    """A test has further sources as cmake/PN_unit_tests.cmake has it: test_NAME.cpp and NAME_*.cpp."""
    first = next(ROOT.glob(f"test/*/{test}.cpp"), TESTS / f"{test}.cpp")
    further = sorted(first.parent.glob(first.stem[len("test_"):] + "_*.cpp")) if first.stem.startswith("test_") else []
    if any(name in source.read_text() for source in [first, *further] for name in ("Scheme_named.h", "Feature_matrix.h")):
        further.append(TESTS / "support" / "scheme_named.cpp")
    return [first, *further]


def compile_test(test, folder, deadline):
    """The program, or None and the error."""
    program = folder / test.replace("/", "_")
    program.unlink(missing_ok=True)
    options = [*OPTIONS, f"-I{TESTS}", f"-I{TESTS}/support", *(f"-I{folder}/{name}" for name in FOLDERS),
               f'-DPN_DATA_DIR="{ROOT}/data/meshes"', f'-DPN_TEST_REAL_MESH_DIR="{WORK}"',
               '-DPN_TEST_EXTRA_MESH_DIR=""', *OPTIONS_OF_TESTS.get(test, [])]
    if IS_CLANG:
        options += ["-include-pch", str(WORK / "third_party.pch")]
    objects = [str(folder / (source.stem + ".o")) for source in sources(test)]
    link = [*COMPILER, *objects, *map(str, WORK.glob("*.o")), "-o", str(program), "-lgtest", "-lgtest_main",
            *OPTIONS_OF_TESTS.get(test, []), "-lmpfr", "-lgmp", "-lpthread"]
    for command in [[*COMPILER, *options, "-c", str(s), "-o", o] for s, o in zip(sources(test), objects)] + [link]:
        done = subprocess.run(command, capture_output=True, text=True, timeout=deadline - time.monotonic())
        if done.returncode != 0:
            errors = [line for line in done.stderr.splitlines() if "error" in line]
            failed = next((line for line in errors if line.startswith(str(TESTS.parent)) and "static" in line and "assert" in line), None)
            return None, f"{STATIC}{failed}" if failed else "does not compile: " + (errors[0] if errors else done.stderr[:200])
    return program, ""


def run_test(program, deadline):
    """None if it passes, otherwise what failed."""
    run = subprocess.run(["prlimit", f"--as={MEMORY_LIMIT}", f"--cpu={PROCESSOR_LIMIT}", program,
                          "--gtest_fail_fast", "--gtest_brief=1"], capture_output=True, text=True,
                         errors="replace", timeout=deadline - time.monotonic())
    if run.returncode == 0:
        return None
    if run.returncode in (-signal.SIGXCPU, -signal.SIGKILL):
        return "does not end"
    failed = [line.split("]")[1].split(",")[0].split("(")[0].strip()
              for line in run.stdout.splitlines() if line.startswith("[  FAILED  ]") and "." in line]
    return failed[0] if failed else f"ends with {run.returncode}"


def first_failure(tests, folder):
    """The verdict on the headers of a folder: invalid, caught or survived, the test and what failed."""
    deadline = time.monotonic() + TIME_LIMIT
    for test in tests:
        try:
            program, error = compile_test(test, folder, deadline)
            failure = run_test(program, deadline) if program else None
        except subprocess.TimeoutExpired:  # on a busy machine this says nothing of the change
            return "INVALID", test, "takes too long"
        if program is None and error.startswith(STATIC):
            return "caught", test, "static_assert in line " + error.removeprefix(STATIC).split(":")[1]
        if program is None:
            return "INVALID", test, error
        if failure is not None:
            return "caught", test, failure
    return "SURVIVED", " ".join(tests), ""


def try_mutation(mutation, folders):
    """The verdict on a change; it is added to the file of verdicts."""
    changed = changed_text(mutation)
    began = time.monotonic()
    verdict = "INVALID", "", "the pattern is not found"
    if changed is not None:
        folder = folders.get()
        file = file_of(mutation, folder)
        original = file.read_text()
        file.write_text(changed)
        try:
            verdict = first_failure(mutation["tests"], folder)
        finally:
            file.write_text(original)
            folders.put(folder)
    if verdict[0] == "SURVIVED" and "survives" in mutation:
        verdict = "survives", verdict[1], ""
    add_result(dict(zip(COLUMNS, [mutation["name"], *verdict, round(time.monotonic() - began)])))
    return verdict[0] in ("caught", "survives")


def try_unchanged(test, folders):
    folder = folders.get()
    verdict = first_failure([test], folder)
    folders.put(folder)
    print(f"{'passes' if verdict[0] == 'SURVIVED' else 'FAILS '} {test} {verdict[2]}", flush=True)
    return verdict[0] == "SURVIVED"


# --- the page of the manual ---

PAGE = """// written by scripts/mutate.py
namespace CGAL {{
/*!
\\page PN_subdivision_3_mutations Wrong Changes on Purpose

\\cgalAutoToc

A test suite is worth the errors it finds. `scripts/mutate.py` puts small defects into the headers, one at a time: a
weight, a sign, a border rule, an index that is off by one, a check left out. At least one of the tests named for the change must fail
that passes without it (`scripts/mutations.toml` lists changes and tests). A test that ends by a failed assertion, a signal or its
limit of processor time has failed, too, and so has one whose `static_assert` fails; any other change that does not compile has no verdict. Verdicts, with the test that failed first, are
in `scripts/mutation_results.tsv`; run the script again to get missing ones.

\\section PN_subdivision_3_mutations_numbers Numbers

Of {all} changes {run} were run, of which {caught} are caught and {survive} survive; {missing} were not run.
By the folder of the changed header below `include/CGAL/`:

| Headers | Changes | Caught | Survive | Not run |
|---|---:|---:|---:|---:|
{rows}

\\section PN_subdivision_3_mutations_survivors Changes that the Named Tests Do Not Notice

{survivors}

\\section PN_subdivision_3_mutations_not_run Changes that Were Not Run

{not_run}
*/
}} // namespace CGAL
"""


def write_table(name):
    results = read_results()
    subjects = {}
    for m in mutations():
        subject = str(pathlib.PurePath(m["file"].replace("/internal", "")).parent)
        verdict = results.get(m["name"], {"verdict": ""})["verdict"]
        subjects.setdefault(subject, []).append(verdict if verdict in ("caught", "survives", "SURVIVED") else "")
    subjects["**all**"] = sum(subjects.values(), [])

    def counts(verdicts):
        survivors = sum("surv" in v.lower() for v in verdicts)
        return [len(verdicts), verdicts.count("caught"), survivors, verdicts.count("")]

    def row(subject, verdicts):
        return " | ".join(["| " + subject, *map(str, counts(verdicts))]) + " |"

    def items(lines):
        return "\n".join(f"- {line}" for line in lines) or "None."

    total, caught, survivors, missing = counts(subjects["**all**"])
    pathlib.Path(name).write_text(PAGE.format(
        all=total, run=total - missing, caught=caught, survive=survivors, missing=missing,
        rows="\n".join(row(*item) for item in subjects.items()),
        survivors=items(f"*{m['name']}* (`{m['file']}`): {m.get('survives', 'not known whether another test notices it, or one is missing')}." for m in mutations()
                        if "surv" in results.get(m["name"], {"verdict": ""})["verdict"].lower()),
        not_run=items(f"*{m['name']}*" for m in mutations()
                      if results.get(m["name"], {"verdict": "INVALID"})["verdict"] == "INVALID")))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", metavar="NAME")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--bare", action="store_true")
    parser.add_argument("--tiers", action="store_true")
    parser.add_argument("--unchanged", action="store_true")
    parser.add_argument("--again", action="store_true")
    parser.add_argument("--jobs", type=int, default=1)
    options = parser.parse_args()
    if options.tiers:
        caught, late = caught_late()
        for result in late:
            print(f"{result['test']:<36} {result['name']}")
        print(f"{len(caught) - len(late)} of {len(caught)} changes are caught by the short tier")
        return 1 if len(late) > 0.05 * len(caught) else 0
    if options.bare:
        for n, name in bare_headers():
            print(f"{n:4} {name}")
        return 0
    selected = [m for m in mutations() if not options.names or any(name in m["name"] for name in options.names)]
    if options.check:
        lost = [m["name"] for m in selected if changed_text(m) is None]
        for name in lost:
            print(f"NOT FOUND  {name}")
        print(f"{len(selected) - len(lost)} of {len(selected)} patterns are found")
        return 1 if lost else 0

    folders = prepare(options.jobs)
    if options.unchanged:
        work = [(try_unchanged, test) for test in sorted({test for m in selected for test in m["tests"]})]
    else:
        done = {} if options.again else {n for n, r in read_results().items() if r["verdict"] != "INVALID"}
        work = [(try_mutation, m) for m in selected if m["name"] not in done]
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        as_expected = list(pool.map(lambda task: task[0](task[1], folders), work))
    print(f"{sum(as_expected)} of {len(work)} as expected")
    return 0 if all(as_expected) else 1


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""The long tests (test/PN_subdivision_3/long_tests.txt) that a change could break.

    scripts/long_tests.py [REV]                 their names, those first that a change since REV concerns most
    scripts/long_tests.py --run SECONDS [REV]   builds the command as users do and runs the documented commands with it, then
                                                builds and runs these tests in build/tests until the time is over
    scripts/long_tests.py --since               the default of REV: the last commit that is four hours older than HEAD

A test can break if a file that it is made of has changed: its sources, and what these include of the package. What did not fit
into the time is named, and kept in ~/.cache/PN_subdivision_3: it is run first the next time. Exit code 1 if a test fails.
"""

import argparse
import os
import re
import shutil
import subprocess
import sys
import time
from pathlib import Path

from refinery import ROOT
from refinery import run as output

TESTS = ROOT / "test" / "PN_subdivision_3"
EXAMPLES = ROOT / "examples" / "PN_subdivision_3"
BUILD = ROOT / "build" / "tests"
LEFT = Path(os.environ.get("XDG_CACHE_HOME", Path.home() / ".cache")) / "PN_subdivision_3" / "long_tests_left.txt"
FOLDERS = [ROOT / "include", ROOT / "test_support", TESTS, TESTS / "support", EXAMPLES, ROOT / "src" / "pn_subdivide"]
AT_A_TIME = 4  # programs that are built before their tests are run
COMMAND = "the command as users build it"
DRAWN = ("figure_", "numbers_", "control_meshes_")


def default_revision() -> str:
    date = int(output("git", "log", "-1", "--format=%ct"))
    found = output("git", "rev-list", "-1", f"--before={date - 4 * 3600}", "HEAD").strip()
    return found or output("git", "rev-list", "--max-parents=0", "HEAD").split()[-1]


def listed() -> list[str]:
    return [line for line in (TESTS / "long_tests.txt").read_text().splitlines() if re.match("[a-z]", line)]


def sources(name: str) -> list[Path]:
    """What a line of the list is made of."""
    if name.startswith("test_"):
        found = list(ROOT.glob(f"test/*/*/{name}.cpp"))
        return found + [path for first in found for path in first.parent.glob(f"{name.removeprefix('test_')}_*.cpp")]
    if name.startswith(("example_", "figure_")):
        return [*ROOT.glob(f"examples/*/{name.split('_', 1)[1]}.cpp"), *ROOT.glob(f"doc/PN_subdivision_3/fig/{name.removeprefix('figure_')}.svg")]
    if name.startswith("rejected_"):
        return list(ROOT.glob(f"test/*/*/{name}.cpp"))
    if name == "documented_commands":
        return [ROOT / "README.md", *ROOT.glob("doc/PN_subdivision_3/*.txt"), *ROOT.glob("src/pn_subdivide/*/*.cpp")]
    if name == "render_draws":
        return [ROOT / "scripts" / "render.py", TESTS / "pictures" / "test_render.py"]
    if name.startswith("peak_memory"):
        return [ROOT / "benchmark" / "PN_subdivision_3" / "peak_memory.cpp"]
    # the package as it is installed, and what is drawn with it
    return [ROOT / "CMakeLists.txt", EXAMPLES / "readme_example.cpp", *ROOT.glob("cmake/*"), *TESTS.glob("*consumer/*")]


def reached(sources: list[Path]) -> set[Path]:
    """The sources and all of the package that they include."""
    done: set[Path] = set()
    waiting = [path for path in sources if path.is_file()]
    while waiting:
        path = waiting.pop()
        if path in done:
            continue
        done.add(path)
        for name in re.findall(r'^ *# *include [<"]([^>"]+)[>"]', path.read_text(errors="replace"), re.MULTILINE):
            waiting += [f / name for f in (path.parent, *FOLDERS) if (f / name).is_file()][:1]
    return {path.resolve() for path in done}


def concerned(revision: str) -> list[str]:
    changed = {ROOT / line for line in output("git", "diff", "--name-only", revision).splitlines()}
    left = LEFT.read_text().split("\n") if LEFT.exists() else []
    order = {}
    for name in listed():
        own = sources(name)
        all_of_it = reached(own)
        share = len(all_of_it & changed) / max(1, len(all_of_it))
        if share > 0 or name in left:
            order[name] = (name not in left, not changed & {path.resolve() for path in own}, -share)
    return sorted(order, key=order.__getitem__)


# --- running ---


def tests_of_build() -> dict[str, list[str]]:
    """The entries of ctest in which a line of the list is run, and for sources the programs that they are part of."""
    names = re.findall(r"^ *Test +#\d+: (\S+)", output("ctest", "--test-dir", str(BUILD), "-N"), re.MULTILINE)
    result = {name: [name] for name in names}
    for joined in (BUILD / "test" / "PN_subdivision_3" / "joined").glob("test_long_*.cpp"):
        for source in re.findall(r"/(test_\w+)\.cpp\"", joined.read_text()):
            result[source] = [joined.stem]
    return result


def run(command: list[str], rest: float) -> bool | None:
    """Whether it succeeds; None if the time is over."""
    print("+", *command, flush=True)
    try:
        return subprocess.run(command, cwd=ROOT, timeout=max(1, rest)).returncode == 0
    except subprocess.TimeoutExpired:
        return None


def run_command(rest) -> bool | None:
    built = run(["scripts/build.sh", "pn_subdivide"], rest())
    command = "build/release/src/pn_subdivide/pn_subdivide"
    return built and run([sys.executable, "-B", "scripts/run_documented_commands.py", command], rest())


def run_some(entries: list[str], rest) -> bool | None:
    targets = output("ninja", "-C", str(BUILD), "-t", "targets", "all")
    # what is drawn and measured is drawn and measured by examples
    needed = [name for name in listed() if name.startswith("example_")] if any(e.startswith(DRAWN) for e in entries) else []
    programs = [re.sub("^example_|_is_.*", "", e) for e in {*entries, *needed}]
    programs = [p for p in programs if f"\n{p}: phony" in targets]
    built = not programs or run(["cmake", "--build", str(BUILD), "--target", *programs], rest())
    pattern = "^(" + "|".join(entries) + ")$"
    return built and run(["ctest", "--test-dir", str(BUILD), "--output-on-failure", "-j", str(os.cpu_count()), "-R", pattern], rest())


def run_all(names: list[str], seconds: float) -> int:
    end = time.monotonic() + seconds
    entries = tests_of_build()
    names = [name for name in names if name in entries]
    work = [([COMMAND], run_command)] if shutil.which("g++") else []
    for i in range(0, len(names), AT_A_TIME):
        some = names[i : i + AT_A_TIME]
        tests = sorted({e for name in some for e in entries[name]})
        work.append((some, lambda rest, tests=tests: run_some(tests, rest)))
    failed, left = [], []
    for some, action in work:
        passes = action(lambda: end - time.monotonic()) if time.monotonic() < end - 5 else None
        if passes is None:
            left += some
        elif not passes:
            failed += some
    LEFT.parent.mkdir(parents=True, exist_ok=True)
    LEFT.write_text("\n".join(left))
    print(f"{sum(len(some) for some, _ in work) - len(left)} long tests run, {len(left)} did not fit: {', '.join(left) or 'none'}")
    if failed:
        print(f"failed: {', '.join(failed)}", file=sys.stderr)
    return 1 if failed else 0


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("revision", nargs="?", metavar="REV")
    parser.add_argument("--run", type=float, metavar="SECONDS")
    parser.add_argument("--since", action="store_true")
    options = parser.parse_args()
    revision = options.revision or default_revision()
    if options.since:
        print(revision)
        return 0
    names = concerned(revision)
    if options.run is not None:
        return run_all(names, options.run)
    print("\n".join(names))
    return 0


if __name__ == "__main__":
    sys.exit(main())

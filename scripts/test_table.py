#!/usr/bin/env python3
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""The table of tests at the end of doc/PN_subdivision_3/Building.md: each entry of ctest, its tier, and the seconds that it took
in a build folder of scripts/test.sh to compile (all sources of its own, on one core) and to run.

    scripts/test_table.py [--check] [BUILD_FOLDER]     default: build/tests

Writes the table; a number that the folder does not have stays as it was. With --check nothing is written: the exit code is 1 if
names or tiers are not those of the folder.
"""

import argparse
import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PAGE = ROOT / "doc" / "PN_subdivision_3" / "Building.md"
HEADING = "## All tests\n"
SECTIONS = {"short": "### Short tests", "long": "### Long tests"}


def tiers(build: Path) -> dict[str, str]:
    with tempfile.TemporaryDirectory() as folder: # in the folder itself ctest would empty the log of the tests that are running
        Path(folder, "CTestTestfile.cmake").write_text(f'subdirs("{build.resolve()}")\n')
        shown = subprocess.run(["ctest", "--test-dir", folder, "--show-only=json-v1"], capture_output=True, text=True, check=True)
    result = {}
    for test in json.loads(shown.stdout)["tests"]:
        labels = next((p["value"] for p in test["properties"] if p["name"] == "LABELS"), [])
        result[test["name"]] = "long" if "long" in labels else "short"
    # what cannot be had on every machine
    return {name: tier for name, tier in result.items() if not name.startswith("left_out.") and name != "page"}


def compile_seconds(build: Path) -> dict[str, float]:
    """By target, as ninja has logged it last."""
    log = build / ".ninja_log"
    last = {}
    for line in log.read_text().splitlines()[1:] if log.exists() else []:
        begin, end, _, output, _ = line.split("\t")
        found = re.search(r"CMakeFiles/([^/]+)\.dir/.*\.o$", output)
        if found:
            last[output] = found[1], (int(end) - int(begin)) / 1000
    result: dict[str, float] = {}
    for target, seconds in last.values():
        result[target] = result.get(target, 0) + seconds
    return result


def run_seconds(build: Path) -> dict[str, float]:
    costs = build / "Testing" / "Temporary" / "CTestCostData.txt"
    lines = costs.read_text().split("---")[0].splitlines() if costs.exists() else []
    return {line.split()[0]: float(line.split()[2]) for line in lines}


def joined(build: Path, name: str) -> str:
    """The tests that a program is joined of; those of the command without its name."""
    source = build / "test" / "PN_subdivision_3" / "joined" / f"{name}.cpp"
    names = re.findall(r"/test_(?:pn_subdivide_)?(\w+)\.cpp\"", source.read_text()) if source.exists() else []
    return f": {', '.join(names)}" if names else ""


def old_rows() -> dict[str, tuple[str, list[str]]]:
    """The tier of each test, and its numbers."""
    rows, tier = {}, ""
    for line in PAGE.read_text().partition(HEADING)[2].splitlines():
        tier = next((name for name, heading in SECTIONS.items() if line == heading), tier)
        if line.startswith("|`"):
            name, *numbers = line.strip("|").split("|")
            rows[name.split("`")[1]] = tier, numbers
    return rows


def table(build: Path) -> str:
    compiled, run, old = compile_seconds(build), run_seconds(build), old_rows()
    rows: dict[str, list[str]] = {tier: [] for tier in SECTIONS}
    for name, tier in sorted(tiers(build).items()):
        before = old.get(name, ("", ["", ""]))[1]
        found = compiled.get(name.removeprefix("example_")), run.get(name)
        numbers = [was if seconds is None else f"{seconds:.0f}" for was, seconds in zip(before, found)]
        rows[tier].append("|".join([f"|`{name}`{joined(build, name)}", *numbers]) + "|\n")
    return "\n".join(f"{heading}\n\n|test|compile|run|\n|---|---:|---:|\n" + "".join(rows[tier])
                     for tier, heading in SECTIONS.items())


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", nargs="?", type=Path, default=ROOT / "build" / "tests")
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    if not options.check:
        text, heading, rest = PAGE.read_text().partition(HEADING)
        introduction = rest.partition("\n###")[0]
        PAGE.write_text(text + heading + introduction + "\n" + table(options.build))
        return
    expected = tiers(options.build)
    written = {name: tier for name, (tier, _) in old_rows().items()}
    wrong = [f"{name}: {expected.get(name, 'no such test')}, the table has {written.get(name, 'no row')}"
             for name in sorted(expected.keys() | written.keys()) if expected.get(name) != written.get(name)]
    sys.exit("\n".join(wrong) or 0)


if __name__ == "__main__":
    main()

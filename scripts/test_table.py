#!/usr/bin/env python3
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Prints a table of all tests of a build folder: each entry of ctest, its tier, and the seconds that it took there to compile (all
sources of its own, on one core) and to run. The manual has it as a page, of the folder that builds it.

    scripts/test_table.py [BUILD_FOLDER]     default: build/tests
"""

import argparse
import json
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


def tiers(build: Path) -> dict[str, str]:
    shown = subprocess.run(["ctest", "--show-only=json-v1"], cwd=build, capture_output=True, text=True, check=True)
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


def sources(build: Path, name: str) -> str:
    joined = build / "test" / "PN_subdivision_3" / "joined" / f"{name}.cpp"
    names = re.findall(r"/test_(\w+)\.cpp\"", joined.read_text()) if joined.exists() else []
    return ", ".join(names)


def table(build: Path) -> str:
    compiled, run = compile_seconds(build), run_seconds(build)

    def number(seconds: float | None) -> str:
        return "" if seconds is None else f"{seconds:.0f}"

    rows = [f"| `{name}` | {tier} | {number(compiled.get(name.removeprefix('example_')))} | {number(run.get(name))} | {sources(build, name)} |"
            for name, tier in sorted(tiers(build).items(), key=lambda item: (item[1] == "long", item[0]))]
    return "\n".join(["| test | tier | s to compile | s to run | joined of |", "|---|---|---:|---:|---|", *rows])


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", nargs="?", type=Path, default=ROOT / "build" / "tests")
    print(table(parser.parse_args().build))
    return 0


if __name__ == "__main__":
    sys.exit(main())

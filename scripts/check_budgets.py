#!/usr/bin/env python3
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Checks that the package does not grow unnoticed: scripts/budgets.tsv has, for every folder, the most files (of headers'
folders the headers, without the sources that one of them includes) and lines that it may have, and for the whole the most headers that only include another one, long headers that no wrong
change in scripts/mutations.toml touches, public headers behind each umbrella header (without those behind PN_subdivision_3.h for
the other two), and functions and classes of the manual's classified list, without named parameters and what is in sections of
analysis and of concepts. Further rows count the packages to come and the circles of folders, by scripts/check_layers.py. What is
sought, where it is known, stands in the last columns.

    scripts/check_budgets.py              exit code 1 if something is larger
    scripts/check_budgets.py --totals     prints what there is
    scripts/check_budgets.py --lower      writes what there is where it is less: what has been won is kept
    scripts/check_budgets.py --raise      writes what there is, more or less; the commit says why
"""

import argparse
import re
import sys
from pathlib import Path

import check_layers
import mutate

ROOT = Path(__file__).resolve().parent.parent
BUDGETS = ROOT / "scripts" / "budgets.tsv"
HEADERS = ROOT / "include" / "CGAL"
SOURCES = ROOT / "src"  # of the command, and of the library
PYTHON = [ROOT / "python" / "src", ROOT / "python" / "pn_subdivision"]
INTRODUCTION = """\
# The most that a folder may have; checked by scripts/check_budgets.py, which also lowers and raises it.
# A row is raised only by a commit that says why.
"""
PUBLIC = "(public names outside analysis and concepts)"
DESCRIPTION = ROOT / "doc" / "PN_subdivision_3" / "PackageDescription.txt"
COLUMNS = ["folder", "files", "lines", "goal: files", "lines"]
FORWARDING = "(headers that only include another one)"
PAIRS = "(pairs of folders that include each other)"
CIRCLES = "(folders in circles)"
UNTOUCHED = f"(headers of {mutate.LONG} lines and more without a wrong change)"


def lines_of(path: Path) -> int:
    return path.read_text().count("\n")


def only_forwards(header: Path) -> bool:
    """Whether nothing is there but comments, the guard and one include."""
    text = re.sub(r"/\*.*?\*/|//[^\n]*", "", header.read_text(), flags=re.DOTALL)
    rest = [line for line in text.splitlines() if line.strip()]
    guard = ("#ifndef", "#define", "#endif", "#pragma once")
    others = [line for line in rest if not line.startswith(guard)]
    return len(others) == 1 and others[0].startswith("#include")


def public_names() -> int:
    """How many functions and classes the classified list promises."""
    sections = re.split(r"\\cgalCRPSection\{", DESCRIPTION.read_text())[1:]
    promised = [section for section in sections if not section.startswith(("Analysis", "Concepts"))]
    names = [name for section in promised for name in re.findall(r"^- `([\w:]+)", section, re.MULTILINE)]
    return sum("parameters::" not in name for name in names)


def headers_behind(umbrella: str) -> set[Path]:
    """The public headers that an umbrella header includes, by others or itself."""
    included, reached, waiting = check_layers.headers(ROOT), set(), [Path(umbrella)]
    while waiting:
        header = waiting.pop()
        if header not in reached and header in included:
            reached.add(header)
            waiting += included[header]
    return {HEADERS / header for header in reached if "internal" not in header.parts}


def umbrellas() -> dict[str, tuple[int, int]]:
    of_meshes = headers_behind("PN_subdivision_3.h")
    parts = {"PN_subdivision_3.h": of_meshes}
    for name in ("PN_subdivision_limit_3.h", "PN_subdivision_curve.h"):
        parts[name] = headers_behind(name) - of_meshes
    return {f"(public headers behind {name})": (len(part), sum(map(lines_of, part))) for name, part in parts.items()}


def packages() -> dict[str, tuple[int, int]]:
    table = check_layers.layers()
    parts: dict[str, list[Path]] = {}
    for header, layer in check_layers.layers_of_headers(ROOT)[0].items():
        for part in ("(headers)", f"(package {table[layer].package})"):
            parts.setdefault(part, []).append(HEADERS / header)
    return {name: (sum(path.suffix == ".h" for path in paths), sum(map(lines_of, paths))) for name, paths in parts.items()}


def counted() -> dict[str, tuple[int, int]]:
    """Files and lines of each folder and behind each umbrella header, and the counts of the whole, which have no lines."""
    headers = sorted(HEADERS.rglob("*.h"))
    included = sorted(HEADERS.rglob("*.cpp"))
    sources = [path for folder in (SOURCES, *PYTHON) for path in folder.rglob("*") if path.suffix in (".h", ".cpp", ".py")]
    counts: dict[str, tuple[int, int]] = {}
    for path in headers + included + sources + sorted((ROOT / "test_support").rglob("*.h")):
        folder = str(path.parent.relative_to(ROOT))
        files, lines = counts.get(folder, (0, 0))
        counts[folder] = files + (path not in included), lines + lines_of(path)
    counts[FORWARDING] = sum(map(only_forwards, headers)), 0
    counts[UNTOUCHED] = len(mutate.bare_headers()), 0
    counts[PUBLIC] = public_names(), 0
    pairs, inside = check_layers.circles(ROOT)
    counts[PAIRS] = len(pairs), 0
    counts[CIRCLES] = len(inside), 0
    return counts | umbrellas() | packages()


def read_rows() -> list[list[str]]:
    rows = [line.split("\t") for line in BUDGETS.read_text().splitlines() if not line.startswith("#")]
    return rows[1:]


def read_budgets() -> dict[str, tuple[int, int]]:
    return {folder: (int(files), int(lines)) for folder, files, lines, *_ in read_rows()}


def write_budgets(budgets: dict[str, tuple[int, int]]) -> None:
    goals = {folder: goal for folder, _, _, *goal in read_rows()}
    rows = ["\t".join([folder, str(files), str(lines), *goals.get(folder, [])])
            for folder, (files, lines) in sorted(budgets.items())]
    BUDGETS.write_text(INTRODUCTION + "\n".join(["\t".join(COLUMNS), *rows]) + "\n")


def excesses(counts: dict[str, tuple[int, int]], budgets: dict[str, tuple[int, int]]) -> list[str]:
    wrong = []
    for folder, count in counts.items():
        if folder not in budgets:
            wrong.append(f"{folder}: has no row")
            continue
        for what, number, most in zip(COLUMNS[1:3], count, budgets[folder], strict=True):
            if number > most:
                wrong.append(f"{folder}: {number} {what}, {most} allowed")
    return wrong


def totals(counts: dict[str, tuple[int, int]]) -> list[str]:
    result = []
    for title, beginning in (("headers", "include/"), ("command", "src/pn_subdivide"), ("library", "src/PN_subdivision_3_double")):
        part = [count for folder, count in counts.items() if folder.startswith(beginning)]
        result.append(f"{title}: {sum(c[0] for c in part)} files, {sum(c[1] for c in part)} lines")
    result += [f"{name.strip('()')}: {lines} lines" for name, (_, lines) in umbrellas().items()]
    return result + [f"{name.strip('()')}: {counts[name][0]}" for name in (FORWARDING, UNTOUCHED, PUBLIC, PAIRS, CIRCLES)]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    action = parser.add_mutually_exclusive_group()
    action.add_argument("--totals", action="store_true")
    action.add_argument("--lower", action="store_true")
    action.add_argument("--raise", action="store_true", dest="raises")
    options = parser.parse_args()

    counts = counted()
    if options.totals:
        print("\n".join(totals(counts)))
        return
    budgets = read_budgets()
    wrong = [] if options.raises else excesses(counts, budgets)
    if options.raises:
        write_budgets(counts)
    elif options.lower and not wrong:
        write_budgets({folder: (min(count[0], budgets[folder][0]), min(count[1], budgets[folder][1]))
                       for folder, count in counts.items()})
    sys.exit("\n".join(f"{BUDGETS.relative_to(ROOT)}: {line}" for line in wrong) or 0)


if __name__ == "__main__":
    main()

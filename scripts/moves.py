#!/usr/bin/env python3
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Files that have moved: scripts/moves.tsv has the old and the new path of each.

    scripts/moves.py --includes FILE...   writes the new paths into the includes of your own sources
    scripts/moves.py --page               prints the page of the manual that lists the moved headers, and what was retired
                                          (scripts/retired.tsv)
"""

import argparse
import re
from pathlib import Path

from refinery import ROOT

INCLUDE = "include/CGAL/"
PATH = re.compile(r"(?<!\w)((?:include/)?CGAL/|test/|examples/|(?<!/))(PN_subdivision_3/[\w./]+)")


def table(name: str) -> list[tuple[str, str]]:
    lines = (ROOT / "scripts" / name).read_text().splitlines()
    return [tuple(line.split("\t")) for line in lines]  # type: ignore[misc]


def with_new_paths(text: str, moves: dict[str, str]) -> str:
    def new(match: re.Match[str]) -> str:
        before, path = match.groups()
        stem = path.rstrip(".")
        for folder in {"include/CGAL/": [INCLUDE], "CGAL/": [INCLUDE], "": [INCLUDE, "examples/"]}.get(before, [before]):
            if folder + stem in moves:
                return before + moves[folder + stem].removeprefix(folder) + path[len(stem):]
        return match[0]

    return PATH.sub(new, text)


def page() -> str:
    headers = [(old, new) for old, new in table("moves.tsv") if old.startswith(INCLUDE) and "/internal/" not in old]
    rows = [f"| `{old.removeprefix(INCLUDE)}` | `{new.removeprefix(INCLUDE)}` |" for old, new in headers]
    retired = [f"| {old} | {instead} |" for old, instead in table("retired.tsv")]
    return "\n".join([
        "// written by scripts/moves.py --page", "namespace CGAL {", "/*!",
        "\\page PN_subdivision_3_moving Moving from 0.1", "", "\\cgalAutoToc", "",
        "\\section PN_subdivision_3_moving_headers Headers", "",
        "The package has become several, each with its folder. `scripts/moves.py --includes FILE...` writes the new paths into your sources.",
        "", "| Before, below `CGAL/` | Now |", "|---|---|", *rows, "",
        "\\section PN_subdivision_3_moving_retired What Was Retired", "", "| Before | Instead |", "|---|---|", *retired,
        "*/", "} // namespace CGAL", ""])


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    action = parser.add_mutually_exclusive_group(required=True)
    action.add_argument("--includes", nargs="+", type=Path, metavar="FILE")
    action.add_argument("--page", action="store_true")
    options = parser.parse_args()
    if options.page:
        print(page(), end="")
    else:
        moves = dict(table("moves.tsv"))
        for path in options.includes:
            path.write_text(with_new_paths(path.read_text(), moves))


if __name__ == "__main__":
    main()

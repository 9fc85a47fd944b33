#!/usr/bin/env python3
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Puts the tables that programs print into the pages of the manual.

  fill_tables.py PAGE PROGRAM...    runs the programs, and writes doc/PN_subdivision_3/PAGE

A program prints a line `#table NAME` before the rows of each table, in HTML. In the page they take the place of the
lines between `<!-- table NAME -->` and `<!-- end of NAME -->`. It is an error if the page has no place for a table, or
has one that no program fills.
"""

import re
import subprocess
import sys
from pathlib import Path

DOC = Path(__file__).resolve().parent.parent / "doc" / "PN_subdivision_3"


def tables(printed: str) -> dict[str, str]:
    parts = re.split(r"(?m)^#table (\w+)\n", printed)
    return dict(zip(parts[1::2], map(short, parts[2::2])))


def short(rows: str) -> str:
    """Without the end tags that HTML does not need; after a letter, which may end the name of a file, with a space."""
    return re.sub(r"</t[dr]>", "", re.sub(r"(?<=[a-z])</td>(?=<)(?!</tr>)", " ", rows))


def filled(page: str, found: dict[str, str]) -> str:
    open_places = re.findall(r"<!-- table (\w+) -->", page)
    if sorted(open_places) != sorted(found):
        sys.exit(f"the page has places for {sorted(open_places)}, the programs print {sorted(found)}")

    def fill(match: re.Match[str]) -> str:
        name = match[1]
        return f"<!-- table {name} -->\n{found[name]}<!-- end of {name} -->"

    return re.sub(r"(?s)<!-- table (\w+) -->\n.*?<!-- end of \1 -->", fill, page)


def main() -> None:
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    page = DOC / sys.argv[1]
    found: dict[str, str] = {}
    for program in sys.argv[2:]:
        run = subprocess.run([program], check=True, capture_output=True, text=True)
        found |= tables(run.stdout)
    page.write_text(filled(page.read_text(), found))


if __name__ == "__main__":
    main()

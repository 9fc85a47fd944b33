#!/usr/bin/env python3
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Puts the tables of the manual's pages into the preprint, doc/PN_subdivision_3/approximation_order.tex.

  preprint_tables.py            writes the rows between `% table NAME` and `% end of NAME`
  preprint_tables.py --check    exit code 1 if they are not those of the manual

The rows in HTML stand between `<!-- table NAME -->` and `<!-- end of NAME -->` in the pages. LaTeX is not needed.
"""

import html
import re
import sys
from pathlib import Path

DOC = Path(__file__).resolve().parent.parent / "doc" / "PN_subdivision_3"
PAGES = ("approximation.txt", "curvature.txt")
PREPRINT = DOC / "approximation_order.tex"
NAMES = {"kobbelt": "Kobbelt", "doo-sabin": "Doo--Sabin", "butterfly": "Butterfly", "sqrt3": r"$\sqrt3$", "loop": "Loop",
         "catmull-clark": "Catmull--Clark"}


def cell(text: str) -> str:
    text = html.unescape(text)
    if number := re.fullmatch(r"(\d\.\d+)e([+-]\d+)", text):
        return rf"\e{{{number[1]}}}{{{int(number[2])}}}"
    if re.fullmatch(r"\d{5,}", text):
        return f"{int(text):,}".replace(",", r"\,")
    prefix, scheme = re.fullmatch(r"(modified-|ct-|)(.*)", text).groups()
    if scheme in NAMES:
        return {"modified-": "modified ", "ct-": "ct-", "": ""}[prefix] + NAMES[scheme]
    return text.replace("Catmull-Clark", "Catmull--Clark").replace("%", r"\%").replace("&", r"\&")


def tables() -> dict[str, str]:
    found = {}
    for page in PAGES:
        for name, rows in re.findall(r"(?s)<!-- table (\w+) -->\n(.*?)<!-- end of \1 -->", (DOC / page).read_text()):
            cells = ([text.strip() for text in row.split("<td>")[1:]] for row in rows.splitlines())
            found[name] = "".join(" & ".join(map(cell, row)) + r" \\" + "\n" for row in cells)
    return found


def filled(preprint: str, found: dict[str, str]) -> str:
    places = re.findall(r"(?m)^% table (\w+)$", preprint)
    if sorted(places) != sorted(found):
        sys.exit(f"preprint_tables.py: places for {sorted(places)}, the manual has {sorted(found)}")

    def fill(match: re.Match[str]) -> str:
        return f"% table {match[1]}\n{found[match[1]]}% end of {match[1]}"

    return re.sub(r"(?sm)^% table (\w+)\n.*?^% end of \1$", fill, preprint)


def main() -> None:
    if sys.argv[1:] not in ([], ["--check"]):
        sys.exit(__doc__)
    old = PREPRINT.read_text()
    new = filled(old, tables())
    if not sys.argv[1:]:
        PREPRINT.write_text(new)
    elif new != old:
        sys.exit(f"{PREPRINT.name} has other numbers than the manual: scripts/preprint_tables.py writes them anew")


if __name__ == "__main__":
    main()

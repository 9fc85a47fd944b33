#!/usr/bin/env python3
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Puts the tables that programs print into the pages of the manual, and those of the manual into the preprint.

  fill_tables.py PAGE PROGRAM...         runs the programs, and writes doc/PN_subdivision_3/PAGE
  fill_tables.py --preprint [--check]    writes doc/PN_subdivision_3/approximation_order.tex; with --check the exit code is 1
                                         if its numbers are not those of the manual (LaTeX is not needed)

A program prints a line `#table NAME` before the rows of each table, in HTML. In the page they take the place of the
lines between `<!-- table NAME -->` and `<!-- end of NAME -->`, in the preprint between `% table NAME` and `% end of NAME`. It
is an error if there is no place for a table, or a place that no table fills.
"""

import html
import re
import subprocess
import sys
from pathlib import Path

DOC = Path(__file__).resolve().parent.parent / "doc" / "PN_subdivision_3"
PREPRINT = DOC / "approximation_order.tex"
PAGES_OF_PREPRINT = ("approximation.txt", "curvature.txt")
IN_HTML, IN_TEX = ("<!-- ", " -->"), ("% ", "")
NAMES = {"kobbelt": "Kobbelt", "doo-sabin": "Doo--Sabin", "butterfly": "Butterfly", "sqrt3": r"$\sqrt3$", "loop": "Loop",
         "catmull-clark": "Catmull--Clark"}


def places(text: str, marks: tuple[str, str]) -> dict[str, str]:
    """The tables between marks, by name."""
    begin, end = map(re.escape, marks)
    return dict(re.findall(rf"(?sm)^{begin}table (\w+){end}\n(.*?)^{begin}end of \1{end}$", text))


def filled(text: str, found: dict[str, str], marks: tuple[str, str]) -> str:
    old = places(text, marks)
    if sorted(old) != sorted(found):
        sys.exit(f"fill_tables.py: places for {sorted(old)}, but there are {sorted(found)}")
    begin, end = marks
    for name, rows in old.items():
        frame = f"{begin}table {name}{end}\n%s{begin}end of {name}{end}"
        text = text.replace(frame.replace("%s", rows), frame.replace("%s", found[name]))
    return text


def printed_by(program: str) -> dict[str, str]:
    parts = re.split(r"(?m)^#table (\w+)\n", subprocess.run([program], check=True, capture_output=True, text=True).stdout)
    return dict(zip(parts[1::2], map(short, parts[2::2])))


def short(rows: str) -> str:
    """Without the end tags that HTML does not need; after a letter, which may end the name of a file, with a space."""
    return re.sub(r"</t[dr]>", "", re.sub(r"(?<=[a-z])</td>(?=<)(?!</tr>)", " ", rows))


# --- the preprint ---


def in_tex(cell: str) -> str:
    text = html.unescape(cell)
    if number := re.fullmatch(r"(\d\.\d+)e([+-]\d+)", text):
        return rf"\e{{{number[1]}}}{{{int(number[2])}}}"
    if re.fullmatch(r"\d{5,}", text):
        return f"{int(text):,}".replace(",", r"\,")
    prefix, scheme = re.fullmatch(r"(modified-|ct-|)(.*)", text).groups()  # type: ignore[union-attr]
    if scheme in NAMES:
        return {"modified-": "modified ", "ct-": "ct-", "": ""}[prefix] + NAMES[scheme]
    return text.replace("Catmull-Clark", "Catmull--Clark").replace("%", r"\%").replace("&", r"\&")


def of_manual() -> dict[str, str]:
    found = {}
    for page in PAGES_OF_PREPRINT:
        for name, rows in places((DOC / page).read_text(), IN_HTML).items():
            cells = ([text.strip() for text in row.split("<td>")[1:]] for row in rows.splitlines())
            found[name] = "".join(" & ".join(map(in_tex, row)) + r" \\" + "\n" for row in cells)
    return found


def main() -> None:
    arguments = sys.argv[1:]
    if arguments in (["--preprint"], ["--preprint", "--check"]):
        old = PREPRINT.read_text()
        new = filled(old, of_manual(), IN_TEX)
        if "--check" not in arguments:
            PREPRINT.write_text(new)
        elif new != old:
            sys.exit(f"{PREPRINT.name} has other numbers than the manual: scripts/fill_tables.py --preprint writes them anew")
    elif len(arguments) > 1:
        page = DOC / arguments[0]
        found = {name: rows for program in arguments[1:] for name, rows in printed_by(program).items()}
        page.write_text(filled(page.read_text(), found, IN_HTML))
    else:
        sys.exit(__doc__)


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Puts the tables that programs print into the pages of the manual and into the preprint.

  fill_tables.py PAGE PROGRAM...    runs the programs, and writes doc/PN_subdivision_3/PAGE and approximation_order.tex
  fill_tables.py --check            the exit code is 1 if tables of both have other numbers in one of them (LaTeX is not needed)

A program prints a line `#table NAME` before the rows of each table, in HTML. In the page they take the place of the
lines between `<!-- table NAME -->` and `<!-- end of NAME -->`, in the preprint between `% table NAME` and `% end of NAME`. A table
without a place is left out, and named; it is an error if no table fills a place of the page.
"""

import html
import re
import sys
from pathlib import Path

from refinery import ROOT, run

DOC = ROOT / "doc" / "PN_subdivision_3"
PREPRINT = DOC / "approximation_order.tex"
IN_HTML, IN_TEX = ("<!-- ", " -->"), ("% ", "")
NAMES = {"kobbelt": "Kobbelt", "doo-sabin": "Doo--Sabin", "butterfly": "Butterfly", "sqrt3": r"$\sqrt3$", "loop": "Loop",
         "catmull-clark": "Catmull--Clark"}


def places(text: str, marks: tuple[str, str]) -> dict[str, str]:
    """The tables between marks, by name."""
    begin, end = map(re.escape, marks)
    return dict(re.findall(rf"(?sm)^{begin}table (\w+){end}\n(.*?)^{begin}end of \1{end}$", text))


def filled(text: str, found: dict[str, str], marks: tuple[str, str]) -> str:
    begin, end = marks
    for name, rows in places(text, marks).items():
        frame = f"{begin}table {name}{end}\n%s{begin}end of {name}{end}"
        text = text.replace(frame.replace("%s", rows), frame.replace("%s", found.get(name, rows)))
    return text


def printed_by(program: str) -> dict[str, str]:
    parts = re.split(r"(?m)^#table (\w+)\n", run(program))
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


def rows_in_tex(rows: str) -> str:
    cells = ([text.strip() for text in row.split("<td>")[1:]] for row in rows.splitlines())
    return "".join(" & ".join(map(in_tex, row)) + r" \\" + "\n" for row in cells)


def check() -> None:
    preprint = places(PREPRINT.read_text(), IN_TEX)
    wrong = [f"{PREPRINT.name} has another table {name} than {page.name}: scripts/fill_tables.py {page.name} PROGRAM writes both"
             for page in sorted(DOC.glob("*.txt")) for name, rows in places(page.read_text(), IN_HTML).items()
             if name in preprint and preprint[name] != rows_in_tex(rows)]
    sys.exit("\n".join(wrong) or 0)


def fill(page: Path, programs: list[str]) -> None:
    found = {name: rows for program in programs for name, rows in printed_by(program).items()}
    text, preprint = page.read_text(), PREPRINT.read_text()
    of_page = places(text, IN_HTML).keys()
    if of_page - found.keys():
        sys.exit(f"fill_tables.py: {page.name} has places for {sorted(of_page)}, but there are {sorted(found)}")
    for name in sorted(found.keys() - of_page - places(preprint, IN_TEX).keys()):
        print(f"left out: {name}", file=sys.stderr)
    page.write_text(filled(text, found, IN_HTML))
    PREPRINT.write_text(filled(preprint, {name: rows_in_tex(rows) for name, rows in found.items()}, IN_TEX))


def main() -> None:
    arguments = sys.argv[1:]
    if arguments == ["--check"]:
        check()
    elif len(arguments) > 1:
        fill(DOC / arguments[0], arguments[1:])
    else:
        sys.exit(__doc__)


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Makes the figures of X. Yang, Point-Normal Subdivision Curves and Surfaces: draws doc/PN_subdivision_3/fig/paper/figure_N*.png
(scripts/pictures.toml), has the examples draw the curves, and puts numbers (scripts/paper_figures/numbers.py) into
doc/PN_subdivision_3/Paper_figures.md. Without N all 17 figures. With --output the page stays as it is, and the numbers are printed.
"""

import argparse
import re
import sys
import tempfile
from pathlib import Path

import pictures
from paper_figures.numbers import OF_EXAMPLES, OF_REFINED
from refinery import ROOT, Refinery, run

PAGE = ROOT / "doc/PN_subdivision_3/Paper_figures.md"
PLACE = re.compile(r"<!--(\d+_\w+)-->(-?\d+(?:\.\d+)?(?:e[-+]?\d+)?)")
ROUNDING = 2e-15  # below: what is exact but for rounding, whose last digit may be another elsewhere
NUMBER = re.compile(r"(?<![\w-])-?\d+(?:\.\d+)?(?:e[-+]?\d+)?(?![\w-])")


def printed_by(example: Path, drawing: Path) -> list[list[float]]:
    """The numbers of each line."""
    return [[float(number) for number in NUMBER.findall(line)] for line in run(example, drawing).splitlines()]


def numbers_of(figure: int, refinery: Refinery, folder: Path) -> dict[str, float]:
    """The drawing of an example goes to the folder."""
    if figure in OF_REFINED:
        return dict(OF_REFINED[figure](refinery))
    if figure in OF_EXAMPLES:
        name, numbers = OF_EXAMPLES[figure]
        example = pictures.Control_meshes(refinery.command, refinery.folder).example(name)
        return dict(numbers(printed_by(example, folder / f"{name}.svg")))
    return {}


# --- the numbers of the page: `<!--NAME-->value` ---


def shown(value: float) -> str:
    if value == 0 or value == int(value) and abs(value) < 1000:
        return str(int(value))
    text = f"{value:.2g}"
    if "e" in text:
        mantissa, exponent = text.split("e")
        return f"{mantissa}e{int(exponent)}"
    return text


def with_numbers(page: str, numbers: dict[str, float]) -> str:
    def put(place: re.Match[str]) -> str:
        name = place[1]
        return f"<!--{name}-->{shown(numbers[name])}" if name in numbers else place[0]

    return PLACE.sub(put, page)


def differences(page: str, numbers: dict[str, float]) -> list[str]:
    """What the page says otherwise."""
    wrong = []
    for name, text in PLACE.findall(page):
        if name not in numbers:
            continue
        value, stated = numbers[name], float(text)
        if max(value, stated) > ROUNDING and abs(value - stated) > 0.06 * abs(value):
            wrong.append(f"{name} is {shown(value)}, not {text}")
    return wrong


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("figures", nargs="*", type=int, metavar="N")
    parser.add_argument("--build", type=Path, default=ROOT / "build/release", metavar="FOLDER",
                        help="where command and examples are built (default: build/release)")
    parser.add_argument("--output", type=Path, metavar="FOLDER", help=f"where pictures go (default: {pictures.FIGURES})")
    parser.add_argument("--check", action="store_true", help="draw nothing, unless there is an --output; tell whether the "
                                                             "page's numbers are those of the present code")
    options = parser.parse_args()
    figures = options.figures or range(1, 18)
    if not set(figures) <= set(range(1, 18)):
        parser.error("N is a number from 1 to 17")
    command = options.build / "src/pn_subdivide/pn_subdivide"
    found: dict[str, float] = {}
    with tempfile.TemporaryDirectory() as work:
        folder = options.output or (Path(work) if options.check else pictures.FIGURES)
        folder.mkdir(parents=True, exist_ok=True)
        refinery = Refinery(command, Path(work))
        for figure in figures:
            print(f"figure {figure}", flush=True)
            try:
                found |= numbers_of(figure, refinery, folder)
            except pictures.Missing as reason:
                sys.exit(str(reason))
        if folder != Path(work):
            names = {f"paper/figure_{n}" for n in figures}
            pictures.draw([name for name in pictures.all_pictures() if re.sub(r"(\d)_\d", r"\1", name) in names], command, folder)
    if options.check:
        sys.exit("\n".join(f"{PAGE}: {line}" for line in differences(PAGE.read_text(), found)) or 0)
    if options.output:
        print("\n".join(f"{name} {value!r}" for name, value in found.items()))
    else:
        PAGE.write_text(with_numbers(PAGE.read_text(), found))


if __name__ == "__main__":
    main()

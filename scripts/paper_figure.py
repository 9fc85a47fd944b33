#!/usr/bin/env python3
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Used by scripts/make_paper_figures.sh, which refines the meshes.

  paper_figure.py rings FOLDER                  writes the meshes of figure 6
  paper_figure.py measure N FOLDER              prints the numbers of figure N, `name value` a line
  paper_figure.py page PAGE NUMBERS             puts such numbers into the page
  paper_figure.py check PAGE NUMBERS            tells which differ from those of the page
"""

import sys
from pathlib import Path

from paper_figures import numbers, page, rings


def main(arguments: list[str]) -> int:
    match arguments:
        case ["rings", folder]:
            rings.write_rings(Path(folder))
        case ["measure", number, folder]:
            for name, value in numbers.OF_FIGURE[int(number)](Path(folder)):
                print(name, repr(value))
        case ["page", file, found]:
            path = Path(file)
            path.write_text(page.with_numbers(path.read_text(), page.read_numbers(Path(found))))
        case ["check", file, found]:
            wrong = page.differences(Path(file).read_text(), page.read_numbers(Path(found)))
            for line in wrong:
                print(f"{file}: {line}", file=sys.stderr)
            return 1 if wrong else 0
        case _:
            print(__doc__, file=sys.stderr)
            return 2
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

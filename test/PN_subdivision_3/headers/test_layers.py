#!/usr/bin/env python3
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""What scripts/check_layers.py finds when an include, or a header, is put into a copy of the headers.

  test_layers.py
"""

import shutil
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent.parent
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "scripts"))

import check_layers  # noqa: E402


class Layers(unittest.TestCase):
    def setUp(self) -> None:
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.root = Path(self.folder.name)
        self.headers = self.root / "include" / "CGAL"
        shutil.copytree(ROOT / "include", self.root / "include")

    def put(self, header: str, included: str) -> None:
        path = self.headers / header
        text = path.read_text() if path.is_file() else ""
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(f"#include <CGAL/{included}>\n{text}")

    def test_headers_are_in_order(self) -> None:
        self.assertEqual(check_layers.check(self.root), [])

    def test_arrow_upward(self) -> None:
        self.put("PN_subdivision_3/average/PN_average.h", "PN_subdivision_3/subdivide.h")
        self.assertEqual(check_layers.check(self.root),
                         ["PN_subdivision_3/average/PN_average.h includes PN_subdivision_3/subdivide.h: "
                          "average may not include calls"])

    def test_arrow_of_an_included_source(self) -> None:
        self.put("PN_recognition_3/internal/Part.cpp", "PN_limit_surface_3/internal/limit_surface/Jet.h")
        self.assertEqual(check_layers.check(self.root),
                         ["PN_recognition_3/internal/Part.cpp includes PN_limit_surface_3/internal/limit_surface/"
                          "Jet.h: recognition may not include limit_surface"])

    def test_arrow_to_another_package(self) -> None:
        self.put("PN_curves/internal/Curve_points.h", "PN_limit_surface_3/internal/limit_surface/Jet.h")
        self.assertEqual(len(check_layers.check(self.root)), 1)

    def test_allowed_arrow(self) -> None:
        self.put("PN_limit_surface_3/internal/limit/Ring_class.h", "PN_subdivision_3/internal/attributes/Charts.h")
        self.assertEqual(check_layers.check(self.root), [])

    def test_folder_without_layer(self) -> None:
        self.put("PN_subdivision_3/internal/helpers/Helper.h", "PN_subdivision_3/average/PN_average.h")
        self.assertEqual(check_layers.check(self.root),
                         ["PN_subdivision_3/internal/helpers/Helper.h: belongs to no layer of the table in "
                          "scripts/check_layers.py"])

    def test_arrow_out_of_the_package(self) -> None:
        path = self.headers / "PN_subdivision_3" / "subdivide.h"
        path.write_text('#include "analysis/subdivision_matrix.h"\n' + path.read_text())
        self.assertEqual(check_layers.check(self.root),
                         ["PN_subdivision_3/subdivide.h includes analysis/subdivision_matrix.h, which is not installed: "
                          "it is not in include/CGAL"])

    def test_circles(self) -> None:
        before, inside = check_layers.circles(self.root)
        self.put("PN_subdivision_3/average/PN_average.h", "PN_subdivision_3/schemes/Loop_scheme.h")
        pairs, larger = check_layers.circles(self.root)
        self.assertEqual(set(pairs) - set(before),
                         {("PN_subdivision_3/average", "PN_subdivision_3/schemes")} - set(before))
        self.assertLessEqual(set(inside) | {"PN_subdivision_3/average", "PN_subdivision_3/schemes"}, set(larger))


if __name__ == "__main__":
    unittest.main()

# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Runs the notebooks, and looks at what they have found."""

import runpy
from pathlib import Path

import numpy as np
import pytest

NOTEBOOKS = sorted((Path(__file__).parent.parent / "notebooks").glob("*.py"))


@pytest.mark.parametrize("file", NOTEBOOKS, ids=lambda file: file.stem)
def test_notebook(file, capsys):
    assert file.read_text().count("\n# %%") >= 4
    found = runpy.run_path(str(file))
    assert capsys.readouterr().out
    CHECKS[file.stem](found)


def is_sphere(found):
    assert np.abs(found["radii"] - np.sqrt(3)).max() < 1e-14 * 2 and np.ptp(found["linear_radii"]) > 0.02
    assert 0 < len(found["changed"]) < len(found["refiner"].points)


def is_round(found):
    assert sorted(found["surfaces"]["kind"]) == [1] * 4 + [2] * 3
    assert found["error"] < 0.0021 and abs(found["volume"] / found["exact"] - 1) < 1e-3


def has_orders(found):
    order = {name: np.log2(values[-2] / values[-1]) for name, values in found["errors"].items()}
    assert order["PN-Butterfly"] > 3 and order["PN-Loop"] > 2.8 and 1.8 < order["Loop"] < 2.2
    assert max(found["errors"]["PN-Butterfly"][-1], found["errors"]["PN-Loop"][-1]) < 0.05 * found["errors"]["Loop"][-1]



CHECKS = {"sphere_from_cube": is_sphere, "stl_made_round": is_round, "error_against_n": has_orders}

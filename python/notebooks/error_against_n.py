# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
# %% [markdown]
# # A surface through points, with its error against their number
# Points of a torus, and nothing else: normals are estimated. PN-Butterfly subdivision passes through the points; PN-Loop subdivision passes
# next to them, and by less than their surface bends. The linear Loop scheme cuts corners.

# %%
import numpy as np
import pn_subdivision as pn


def torus(k):
    """k by k/2 points, with triangles."""
    u, v = np.meshgrid(2 * np.pi * np.arange(k) / k, 4 * np.pi * np.arange(k // 2) / k, indexing="ij")
    points = np.stack([(3 + np.cos(v)) * np.cos(u), (3 + np.cos(v)) * np.sin(u), np.sin(v)], -1)
    number = np.arange(k * (k // 2)).reshape(k, -1)
    a, b, c, d = number, np.roll(number, -1, 0), np.roll(number, -1, (0, 1)), np.roll(number, -1, 1)
    return points.reshape(-1, 3), np.concatenate([np.stack([a, b, c], -1).reshape(-1, 3), np.stack([a, c, d], -1).reshape(-1, 3)])


def error(points):
    return np.abs(np.hypot(np.hypot(points[:, 0], points[:, 1]) - 3, points[:, 2]) - 1).max()


# %%
sizes, errors = [12, 24, 48], {"PN-Butterfly": [], "PN-Loop": [], "Loop": []}
for k in sizes:
    points, triangles = torus(k)
    through = pn.subdivide(points, triangles, scheme="butterfly", levels=3)
    assert np.array_equal(through.points[:len(points)], points)
    errors["PN-Butterfly"].append(error(through.points))
    errors["PN-Loop"].append(error(pn.limit(points, triangles, levels=2).points))
    errors["Loop"].append(error(pn.limit(points, triangles, levels=2, linear=True).points))

# %%
print(f"{'points':>8}" + "".join(f"{name:>14}{'order':>7}" for name in errors))
for i, k in enumerate(sizes):
    row = f"{k * k // 2:8}"
    for values in errors.values():
        order = f"{np.log2(values[i - 1] / values[i]):7.2f}" if i else 7 * " "
        row += f"{values[i]:14.2e}" + order
    print(row)

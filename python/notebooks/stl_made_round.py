# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
# %% [markdown]
# # A stranger's STL file made round again
# A CAD system has written a shaft with a collar as triangles. The surfaces are recognized, and the edges between them stay sharp.

# %%
import struct
import tempfile
from pathlib import Path

import numpy as np
import pn_subdivision as pn

# %% [markdown]
# Such a file, binary, with single precision (take one of your own instead).

# %%
def write_stl(file, triangles):
    record = np.zeros(len(triangles), np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")]))
    record["corners"] = triangles
    Path(file).write_bytes(bytes(80) + struct.pack("<I", len(triangles)) + record.tobytes())


def shaft(sides=24):
    profile = np.array([[0, 0], [4, 0], [4, 10], [7, 10], [7, 13], [4, 13], [4, 30], [0, 30]], float)  # radius, height
    angle = 2 * np.pi * np.arange(sides + 1) / sides
    turn = np.stack([np.cos(angle), np.sin(angle)], 1)
    grid = np.concatenate([profile[:, None, :1] * turn, np.broadcast_to(profile[:, None, 1:], (len(profile), sides + 1, 1))], axis=2)
    a, b, c, d = grid[:-1, :-1], grid[:-1, 1:], grid[1:, 1:], grid[1:, :-1]
    triangles = np.concatenate([np.stack([a, b, c], 2).reshape(-1, 3, 3), np.stack([a, c, d], 2).reshape(-1, 3, 3)]).astype("<f4")
    area = np.linalg.norm(np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]), axis=1)
    return triangles[area > 1e-3]


file = Path(tempfile.mkdtemp()) / "shaft.stl"
write_stl(file, shaft())

# %% [markdown]
# Each triangle of an STL file has points of its own: equal ones are joined.

# %%
record = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
corners = np.frombuffer(file.read_bytes(), record, offset=84)["corners"].reshape(-1, 3)
points, inverse = np.unique(np.round(corners, 5), axis=0, return_inverse=True)
triangles = inverse.reshape(-1, 3)

# %%
part, surfaces, surface_of_face = pn.recognize(points, triangles)
for s in surfaces:
    print(f"{pn.KINDS[s['kind']]:10} of {s['number_of_faces']} triangles, radius {s['radius']:.4f}")

# %% [markdown]
# Rounds or, better, as many triangles as the tolerance needs.

# %%
fine = pn.tessellate(part, chord=0.002)
of_shaft = np.isin(surface_of_face[fine.face_parents], np.flatnonzero(surfaces["kind"] == pn.KINDS.index("cylinder")))
radii = np.hypot(*fine.points[fine.faces[of_shaft]].mean(1)[:, :2].T)
error = np.abs(radii - np.where(radii > 5.5, 7, 4)).max()
volume = np.sum(np.cross(*fine.points[fine.faces[:, :2]].transpose(1, 0, 2)) * fine.points[fine.faces[:, 2]]) / 6
exact = np.pi * (16 * 27 + 49 * 3)
print(f"{len(triangles)} -> {len(fine.faces)} triangles, {error:.1e} off the cylinders, volume {volume / exact:.5f} of the exact one")

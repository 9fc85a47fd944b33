# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
# %% [markdown]
# # A sphere from a cube
# A point-normal scheme averages points together with normals: where these are those of a sphere, so is the result.

# %%
import numpy as np
import pn_subdivision as pn

points = np.array([[x, y, z] for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)], float)
quads = np.array([[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]])

# %% [markdown]
# Without normals they are estimated. Those of a cube point away from its center.

# %%
sphere = pn.subdivide(points, quads, levels=5)
radii = np.linalg.norm(sphere.points, axis=1)
print(f"{len(sphere.faces)} faces, radius {radii.mean():.15f} +- {np.ptp(radii):.1e}")

# %% [markdown]
# The linear scheme shrinks the cube to something that is no sphere.

# %%
linear = pn.limit(points, quads, levels=5, linear=True)
linear_radii = np.linalg.norm(linear.points, axis=1)
print(f"linear: from {linear_radii.min():.3f} to {linear_radii.max():.3f}")

# %% [markdown]
# A vertex that moves takes the surface along. A refiner computes only what that reaches.

# %%
fine = pn.subdivide(points, quads, normals=points)
refiner = pn.Refiner(fine.points, fine.faces, normals=fine.normals, levels=4)
refiner.set_points([7], [[1.5, 1.5, 1.5]])
changed = refiner.update()
print(f"{len(changed)} of {len(refiner.points)} points are new, the farthest {np.linalg.norm(refiner.points, axis=1).max():.3f} from the center")

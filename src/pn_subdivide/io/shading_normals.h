// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_SHADING_NORMALS_H
#define PN_SUBDIVIDE_SHADING_NORMALS_H

#include "io/Mesh_data.h"

namespace pn_subdivide {

// Which of the sums that modelling programs write the normals of a mesh are: unit sums of the normals of the faces with
// weights 1, the area, the angle, the area times the angle, or |a x b| of the two edges of the corner. They are of this kind
// if at least 80 % of them agree with one and the same of these, within two units of their last digit and 2e-6, and less
// than 80 % with the sum of a x b / (|a|^2 |b|^2): true normals of many round shapes agree with all of them, by
// symmetry, but then with this one, too. Normals that are zero and corners without area do not count.
Shading find_shading(const Mesh_data& mesh);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_SHADING_NORMALS_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_FACE_NORMAL_H
#define PN_SUBDIVIDE_FACE_NORMAL_H

#include "io/Mesh_data.h"

namespace pn_subdivide {

// The unit vector of the area vector; zero if there is no area.
Triple face_normal(const Mesh_data& mesh, std::size_t f);

inline Triple difference(const Triple& a, const Triple& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Triple cross_product(const Triple& a, const Triple& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double scalar_product(const Triple& a, const Triple& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_FACE_NORMAL_H

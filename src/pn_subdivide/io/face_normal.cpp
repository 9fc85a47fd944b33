// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/face_normal.h"

#include "io/corner_normals.h"

#include <cmath>

namespace pn_subdivide {

Triple face_normal(const Mesh_data& mesh, std::size_t f)
{
  const Mesh_data::Face face = mesh.face(f);
  const Triple& origin = mesh.points[face.front()];
  double largest = 0; // so that no product overflows or vanishes
  for (const Mesh_data::Index v : face)
    for (const double x : difference(mesh.points[v], origin))
      largest = std::fmax(largest, std::abs(x));
  if (!(largest > 0)) return {0, 0, 0};

  const auto side = [&](const Mesh_data::Index& v) {
    Triple d = difference(mesh.points[v], origin);
    for (double& x : d) x /= largest;
    return d;
  };
  Triple before = side(face[1]), area = {0, 0, 0};
  for (std::ptrdiff_t i = 2; i < std::ptrdiff_t(face.size()); ++i) {
    const Triple now = side(face[i]), part = cross_product(before, now);
    if (i == 2)
      area = part; // with its signs of zero
    else
      for (std::size_t k = 0; k < 3; ++k) area[k] += part[k];
    before = now;
  }
  return normalized(area);
}

} // namespace pn_subdivide

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVISION_3_TEST_HEADERS_MESH_H
#define PN_SUBDIVISION_3_TEST_HEADERS_MESH_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

// What the headers are used with; included behind them.
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

inline auto normals_of(Mesh& mesh)
{
  return mesh.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>("v:normal").first;
}

#endif // PN_SUBDIVISION_3_TEST_HEADERS_MESH_H

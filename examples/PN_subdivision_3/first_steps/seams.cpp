// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Texture coordinates of two charts, with a seam between them, are refined with the surface.
#include <CGAL/PN_subdivision_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace PN = CGAL::PN_subdivision_3;

int main(int argc, char** argv)
{
  Mesh mesh;
  if (argc < 3 || !CGAL::IO::read_polygon_mesh(argv[1], mesh)) return 1;
  auto uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Vector_2>("h:uv").first;
  for (auto f : mesh.faces()) // two charts
    for (auto h : mesh.halfedges_around_face(mesh.halfedge(f)))
      uv[h] = Kernel::Vector_2(mesh.point(mesh.target(h)).y(), f.idx() % 2 * 5.);
  PN::CatmullClark_subdivision(mesh,
                               PN::parameters::attributes(PN::parameters::corner_attribute(uv)));
  return CGAL::IO::write_polygon_mesh(argv[2], mesh) ? 0 : 1;
}

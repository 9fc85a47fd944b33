// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The limit surface between its vertices: points, normals and curvature at any parameters of a face, and a box around all of it.
//
//   limit_surface_between [MESH]

#include <CGAL/PN_limit_surface_3/Face_patch.h>
#include <CGAL/PN_limit_surface_3/Limit_surface.h>
#include <CGAL/PN_subdivision_3.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace PN = CGAL::PN_subdivision_3;

int main(int argc, char** argv)
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/creature.obj");
  Mesh control;
  if (!CGAL::IO::read_polygon_mesh(filename, control) || control.is_empty()) {
    std::cerr << "Invalid input: " << filename << std::endl;
    return EXIT_FAILURE;
  }
  const PN::Limit_surface surface(control, PN::CatmullClark_scheme());
  std::cout << "The limit surface lies in " << surface.bbox() << '\n';

  // some places in the first faces, all at once
  std::vector<PN::Limit_surface<Mesh>::Location> places;
  for (Mesh::Face_index f : control.faces())
    if (f.idx() < 3)
      for (const double u : {0.25, 0.7}) places.push_back({f, u, 0.4});
  for (const auto& s : surface.evaluate(places)) {
    std::cout << "(" << s.point << ") +- " << s.error << ", normal (" << s.normal << ")";
    if (s.derivatives == 2) { // the Gaussian curvature
      const double e = s.du * s.du, f = s.du * s.dv, g = s.dv * s.dv;
      const double l = s.duu * s.normal, m = s.duv * s.normal, n = s.dvv * s.normal;
      std::cout << ", Gaussian curvature " << (l * n - m * m) / (e * g - f * f);
    }
    std::cout << '\n';
  }

  // the patch of the corners of the first face that has four of them
  for (Mesh::Face_index f : control.faces()) {
    if (control.degree(f) != 4) continue;
    std::vector<Kernel::Point_3> points;
    std::vector<Kernel::Vector_3> normals;
    for (const auto& s : surface.evaluate(std::vector<PN::Limit_surface<Mesh>::Location>{
           {f, 0, 0}, {f, 1, 0}, {f, 1, 1}, {f, 0, 1}})) {
      points.push_back(s.point);
      normals.push_back(s.normal);
    }
    const PN::Face_patch<Kernel> patch(points, normals);
    std::cout << "The patch of face " << f.idx() << " is "
              << std::sqrt(
                   CGAL::squared_distance(patch.point(0.5, 0.5), surface.point(f, 0.5, 0.5)))
              << " off the surface in the middle\n";
    break;
  }
  return EXIT_SUCCESS;
}

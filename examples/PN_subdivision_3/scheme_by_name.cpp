// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Schemes chosen at run time: prints how far those named move the vertices of a mesh.
// Without names, four schemes that take quadrilaterals.
//
//   scheme_by_name [MESH [SCHEME...]]

#include <CGAL/PN_subdivision_3.h>
#include <CGAL/PN_subdivision_3/schemes/Any_scheme.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;

// how far the old vertices, which are the first ones, have moved at most
template <class Scheme>
double largest_move(Mesh mesh, const Scheme& scheme)
{
  const std::vector<Kernel::Point_3> old(mesh.points().begin(), mesh.points().end());
  PN::subdivide(mesh, scheme, params::number_of_iterations(3));
  double largest = 0;
  for (std::size_t i = 0; i < old.size(); ++i)
    largest = (std::max)(
      largest, CGAL::squared_distance(old[i], mesh.point(Mesh::Vertex_index(Mesh::size_type(i)))));
  return std::sqrt(largest);
}

int main(int argc, char** argv)
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/creature.obj");
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(filename, mesh) || mesh.is_empty()) {
    std::cerr << "Invalid input: " << filename << std::endl;
    return EXIT_FAILURE;
  }
  std::vector<std::string> names(argv + (std::min)(argc, 2), argv + argc);
  if (names.empty())
    names = {"catmull-clark", "modified-catmull-clark", "ct-catmull-clark", "kobbelt"};
  try {
    for (const std::string& name : names) {
      const PN::Any_scheme<> scheme = PN::any_scheme(name);
      const double point_normal = largest_move(mesh, scheme);
      const double linear = largest_move(mesh, PN::linear(scheme));
      std::cout << scheme.name() << ": vertices move by at most " << point_normal
                << ", with its linear twin by " << linear
                << (scheme.interpolates() ? " (it interpolates)" : "") << std::endl;
    }
  } catch (const std::exception& e) { // an unknown name, or faces that a scheme does not take
    std::cerr << e.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}

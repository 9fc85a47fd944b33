// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The curvatures of a refined mesh, of the linear scheme and of its point-normal twin.
//
//   curvature_of_mesh [MESH]

#include <CGAL/PN_subdivision_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#if __has_include(<Eigen/Core>)
#  include <CGAL/PN_limit_surface_3/estimate_curvature.h>
#endif

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <string>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;

#if __has_include(<Eigen/Core>)
template <class Scheme>
void print_curvatures(const char* name, Mesh mesh, const Scheme& scheme)
{
  PN::subdivide(mesh, scheme, params::number_of_iterations(4));

  using Curvature = PN::Vertex_curvature<Kernel>;
  auto curvatures = mesh.add_property_map<Mesh::Vertex_index, Curvature>("v:curvature").first;
  PN::estimate_curvature(mesh, curvatures); // of the points: control normals are not its normals

  const auto less = [&](Mesh::Vertex_index v, Mesh::Vertex_index w) {
    return curvatures[v].gaussian < curvatures[w].gaussian;
  };
  const auto [least, greatest] =
    std::minmax_element(mesh.vertices_begin(), mesh.vertices_end(), less);
  const Curvature& c = curvatures[*greatest];
  std::cout << name << ": Gaussian curvature from " << curvatures[*least].gaussian << " to "
            << c.gaussian << "; there principal curvatures " << c.minimal << " in direction "
            << c.minimal_direction << " and " << c.maximal << " in direction "
            << c.maximal_direction << std::endl;
}
#endif

int main(int argc, char** argv)
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/creature.obj");
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(filename, mesh) || mesh.is_empty()) {
    std::cerr << "Invalid input: " << filename << std::endl;
    return EXIT_FAILURE;
  }
#if __has_include(<Eigen/Core>)
  print_curvatures("Catmull-Clark", mesh, PN::linear(PN::CatmullClark_scheme()));
  print_curvatures("PN-Catmull-Clark", mesh, PN::CatmullClark_scheme());
#else
  std::cout << "Curvatures need Eigen" << std::endl;
#endif
  return EXIT_SUCCESS;
}

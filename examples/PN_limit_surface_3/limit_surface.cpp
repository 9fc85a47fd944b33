// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// A point-normal surface for a renderer: refined, moved to the limit surface, with the surface's own
// normals. Prints by how much the control normals differ from these.
//
//   limit_surface [MESH [OUTPUT]]

#include <CGAL/PN_limit_surface_3/limit_points.h>
#include <CGAL/PN_limit_surface_3/subdivide_to_limit.h>
#include <CGAL/PN_subdivision_3.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

using Kernel = CGAL::Simple_cartesian<double>;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;

int main(int argc, char** argv)
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/creature.obj");
  const std::string output = argc > 2 ? argv[2] : "limit_surface.ply";
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(filename, mesh) || mesh.is_empty()) {
    std::cerr << "Invalid input: " << filename << std::endl;
    return EXIT_FAILURE;
  }
  auto normals = PN::estimate_control_normals(mesh);

  const PN::CatmullClark_scheme scheme;
  PN::subdivide(mesh, scheme, params::number_of_iterations(3).vertex_normal_map(normals));

  const auto np =
    PN::parameters::surface_normals(true).normal_tolerance(1e-5).vertex_normal_map(normals);

  // All that is known of the limit at each vertex, the mesh remaining as it is.
  using Limit = PN::Limit_point<Kernel>;
  auto limits = mesh.add_property_map<Mesh::Vertex_index, Limit>("v:limit").first;
  PN::limit_points(mesh, scheme, limits, np);
  double sum = 0;
  for (Mesh::Vertex_index v : mesh.vertices()) {
    const double cosine = limits[v].control_normal * limits[v].surface_normal;
    sum += std::acos((std::min)(1., cosine)) * 180 / std::acos(-1.);
  }
  std::cout << "Control and surface normals differ by "
            << sum / static_cast<double>(mesh.number_of_vertices()) << " degrees in the mean"
            << std::endl;

  // Or the vertices go there, and get the normals of the surface, which a PLY file holds.
  auto shading = mesh.add_property_map<Mesh::Vertex_index, Vector>("v:normal").first;
  const PN::Limit_report report =
    PN::subdivide_to_limit(mesh, scheme, np.limit_normal_map(shading).number_of_iterations(0));
  std::cout << "Limit points: estimated error " << report.error << ", normals "
            << report.normal_error << ", " << report.depth << " rounds at most" << std::endl;
  if (!report.is_within_tolerance())
    std::cout << "The tolerance is missed at " << report.number_of_misses << " vertices"
              << std::endl;
  return CGAL::IO::write_polygon_mesh(output, mesh, params::stream_precision(17)) ? EXIT_SUCCESS
                                                                                  : EXIT_FAILURE;
}

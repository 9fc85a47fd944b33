// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Triangles that are as close to a point-normal surface as it takes, and no closer: those of a tolerance, beside
// as many uniform rounds as it would take. Edges of more than 30 degrees are sharp.
//
//   tessellate_to_tolerance [MESH [PERCENT_OF_DIAGONAL [OUTPUT]]]

#include <CGAL/PN_limit_surface_3/tessellate.h>
#include <CGAL/PN_subdivision_3.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;

int main(int argc, char** argv)
{
  const std::string filename =
    argc > 1 ? argv[1] : CGAL::data_file_path("meshes/parts/bearing_housing.obj");
  const double percent = argc > 2 ? std::atof(argv[2]) : 0.05;
  const std::string output = argc > 3 ? argv[3] : "tessellated.ply";
  Mesh control;
  if (!CGAL::IO::read_polygon_mesh(filename, control) || control.is_empty()) {
    std::cerr << "Invalid input: " << filename << std::endl;
    return EXIT_FAILURE;
  }
  auto sharp = control.add_property_map<Mesh::Edge_index, bool>("e:sharp", false).first;
  PN::detect_creases(control, 30, sharp);

  CGAL::Bbox_3 box;
  for (Mesh::Vertex_index v : control.vertices()) box += control.point(v).bbox();
  const double diagonal = std::hypot(box.x_span(), std::hypot(box.y_span(), box.z_span()));

  Mesh mesh;
  auto normals = mesh.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>("v:normal").first;
  const PN::Tessellation_result result =
    PN::tessellate(control, PN::CatmullClark_scheme(), percent / 100 * diagonal, mesh,
                   params::edge_is_constrained_map(sharp), params::vertex_normal_map(normals));

  // two triangles for each quadrilateral; the first round makes one for each corner of a face
  double uniform = 0;
  for (Mesh::Face_index f : control.faces()) uniform += 2. * double(control.degree(f));
  uniform *= std::pow(4., double(result.depth) - 1);
  std::cout << result.number_of_triangles << " triangles, " << result.depth
            << " rounds where the surface is curved most; uniform rounds would make about "
            << uniform << '\n'
            << "Estimated distance from the surface: at most " << 100 * result.bound / diagonal
            << "% of the diagonal" << (result.reached ? "" : ", which is not what was asked for")
            << std::endl;
  return CGAL::IO::write_polygon_mesh(output, mesh, params::stream_precision(17)) ? EXIT_SUCCESS
                                                                                  : EXIT_FAILURE;
}

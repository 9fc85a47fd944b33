// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Colors of vertices, a number per vertex and texture coordinates of corners through a subdivision.
//
//   carry_colors [MESH [OUTPUT.off]]

#include <CGAL/PN_subdivision_3.h>

#include <CGAL/IO/Color.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
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
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/creature.obj");
  const std::string output = argc > 2 ? argv[2] : "carry_colors.off";
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(filename, mesh) || mesh.is_empty()) {
    std::cerr << "Invalid input: " << filename << std::endl;
    return EXIT_FAILURE;
  }

  // a color by direction, the height, and the place in a chart of its own for each face
  auto colors = mesh.add_property_map<Mesh::Vertex_index, CGAL::IO::Color>("v:color").first;
  auto heights = mesh.add_property_map<Mesh::Vertex_index, double>("v:height").first;
  auto uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  double greatest = 0;
  for (auto v : mesh.vertices()) {
    const auto& p = mesh.point(v);
    const double turn = std::atan2(p.y(), p.x()), pi = std::acos(-1.0);
    colors[v] = CGAL::IO::Color((unsigned char)(255 * (1 + std::sin(turn)) / 2), 120,
                                (unsigned char)(255 * std::abs(turn) / pi));
    heights[v] = p.z();
    greatest = (std::max)(greatest, std::abs(p.z()));
  }
  for (auto f : mesh.faces()) {
    double i = 0;
    for (auto h : mesh.halfedges_around_face(mesh.halfedge(f))) {
      uv[h] = {std::cos(i), std::sin(i)};
      i += 1;
    }
  }

  PN::subdivide(
    mesh, PN::CatmullClark_scheme(),
    PN::parameters::attributes(PN::parameters::vertex_attribute(colors),
                               PN::parameters::vertex_attribute(heights),
                               PN::parameters::corner_attribute(uv, PN::Corner_rule::all))
      .number_of_iterations(2));

  // averages of heights are heights again
  for (auto v : mesh.vertices())
    if (!(std::abs(heights[v]) <= greatest)) return EXIT_FAILURE;
  std::cout << mesh.number_of_vertices() << " vertices, the first one with the color "
            << colors[Mesh::Vertex_index(0)] << std::endl;
  return CGAL::IO::write_polygon_mesh(output, mesh, params::vertex_color_map(colors))
           ? EXIT_SUCCESS
           : EXIT_FAILURE;
}

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Patch ids on the faces of a Polyhedron_3: first carried by the library, then by a visitor of your own, which does
// the same and shows what it is told.
//
//   carry_patch_ids [MESH]

#include <CGAL/PN_subdivision_3.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <boost/property_map/property_map.hpp>

#include <cstdlib>
#include <functional>
#include <iostream>
#include <map>
#include <string>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Face = boost::graph_traits<Polyhedron>::face_descriptor;
namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;

// the patch of a control face: above or below the plane z = 0
int patch_of(Face f, const Polyhedron& mesh)
{
  double height = 0;
  for (auto v : CGAL::vertices_around_face(halfedge(f, mesh), mesh)) height += v->point().z();
  return height > 0 ? 1 : 2;
}

struct Patch_visitor
{
  void face_created(Face child, const PN::Control_element& parent)
  {
    patch[child] = control_patch[parent.index];
  }

  std::vector<int> control_patch; // in the order of the control faces
  std::map<Face, int> patch;
};

int main(int argc, char** argv)
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/creature.obj");
  Polyhedron mesh;
  if (!CGAL::IO::read_polygon_mesh(filename, mesh) || mesh.empty()) {
    std::cerr << "Invalid input: " << filename << std::endl;
    return EXIT_FAILURE;
  }

  std::map<Face, int> patches;
  Patch_visitor visitor;
  for (Face f : faces(mesh)) {
    patches[f] = patch_of(f, mesh);
    visitor.control_patch.push_back(patches[f]);
  }

  PN::subdivide(mesh, PN::CatmullClark_scheme(),
                PN::parameters::attributes(
                  PN::parameters::face_attribute(boost::make_assoc_property_map(patches)))
                  .number_of_iterations(2)
                  .visitor(std::ref(visitor)));

  std::map<int, std::size_t> sizes;
  for (Face f : faces(mesh)) {
    if (patches.at(f) != visitor.patch.at(f)) return EXIT_FAILURE;
    ++sizes[patches.at(f)];
  }
  for (const auto& [patch, size] : sizes)
    std::cout << "Patch " << patch << ": " << size << " faces" << std::endl;
  return EXIT_SUCCESS;
}

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "Control.h"

#include <CGAL/PN_recognition_3/recognize_surfaces.h>

#include <limits>

namespace pn_python {
namespace {

// Makes creases, normals and the roundness those of the surfaces that are
// found; returns these and the number of that of each face.
py::tuple recognize(Control& c, unsigned min_facets, double tolerance, double sharp_angle)
{
  const auto of_face = c.mesh.add_property_map<Mesh::Face_index, std::size_t>("f:surface", 0).first;
  const auto normals = c.mesh.add_property_map<Halfedge, Vector_3>("h:normal").first;
  const auto roundness = c.mesh.add_property_map<Vertex, double>("v:roundness", 1).first;
  const auto is_crease = c.mesh.add_property_map<Mesh::Edge_index, bool>("e:is_crease").first;
  const auto is_corner = c.mesh.add_property_map<Vertex, bool>("v:is_corner").first;
  std::vector<PN::Recognized_surface> surfaces;
  const auto find = [&](const auto& np) {
    surfaces = PN::recognize_surfaces(c.mesh, of_face, np);
    PN::surface_creases(c.mesh, of_face, surfaces, is_crease,
                        PN::parameters::join(PN::parameters::vertex_roundness_map(roundness)
                                               .vertex_is_constrained_map(is_corner)
                                               .vertex_normal_map(normals),
                                             np));
  };
  run(1, [&] {
    const auto np =
      PN::parameters::shared(PN::parameters::sharp_angle(sharp_angle).min_facets(min_facets));
    if (tolerance > 0)
      find(PN::parameters::join(PN::parameters::surface_tolerance(tolerance), np));
    else
      find(np);
  });
  constexpr double infinite = std::numeric_limits<double>::infinity();
  for (const auto e : c.mesh.edges()) c.edge_sharpness[e] = is_crease[e] ? infinite : 0;
  for (const Vertex v : c.mesh.vertices()) c.vertex_sharpness[v] = is_corner[v] ? infinite : 0;
  c.is_of_corners = true;
  for (const Halfedge h : corners_of(c.mesh)) {
    put(c.of_corners, h, normals[h]);
    put(c.of_corners.roundness_map(), h, roundness[c.mesh.target(h)]);
  }
  return py::make_tuple(to_array(surfaces),
                        to_array(std::vector<std::int64_t>(of_face.begin(), of_face.end())));
}

} // namespace

void add_recognize(py::module_& module)
{
  PYBIND11_NUMPY_DTYPE(PN::Recognized_surface, kind, point, direction, radius, tube_radius,
                       half_angle, residual, number_of_faces);
  module.def("recognize", recognize);
}

} // namespace pn_python

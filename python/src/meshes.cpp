// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "Control.h"

#include <CGAL/PN_limit_surface_3/subdivide_to_limit.h>
#include <CGAL/PN_limit_surface_3/tessellate.h>
#include <CGAL/PN_recognition_3/recognize_surfaces.h>

#include <limits>
#include <utility>

namespace pn_python {
namespace {

// Tells Python's function, if there is one, of each round; what that raises, or Ctrl-C, ends the call.
struct Progress
{
  void round_done(unsigned round, std::size_t faces) const
  {
    const py::gil_scoped_acquire locked;
    if (!function.is_none()) function(round, faces);
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  }

  py::object function;
};

void subdivide(Control& c, unsigned levels, const py::object& progress)
{
  const Progress told{progress};
  c.run([&](const auto& scheme, const auto& np, const auto&) {
    PN::subdivide<Tag>(
      c.mesh, scheme,
      PN::parameters::join(PN::parameters::attributes(c.table),
                           np.number_of_iterations(levels).visitor(std::cref(told))));
  });
}

py::array limit(Control& c, unsigned levels, double tolerance, double normal_tolerance,
                const py::object& progress)
{
  const Progress told{progress};
  PN::Limit_report report;
  c.run([&](const auto& scheme, const auto& np, const auto&) {
    report = PN::subdivide_to_limit<Tag>(
      c.mesh, scheme,
      PN::parameters::join(PN::parameters::attributes(c.table)
                             .tolerance(tolerance)
                             .normal_tolerance(normal_tolerance)
                             .surface_normals(true),
                           np.number_of_iterations(levels).visitor(std::cref(told))));
  });
  return py::array_t<PN::Limit_report>(1, &report);
}

py::array tessellate(Control& c, double chord)
{
  for (PN::Attribute_array& array : c.table.corners) array.rule = PN::Corner_rule::all;
  PN::Tessellation_result result;
  c.run([&](const auto& scheme, const auto& np, const auto& of_control) {
    const std::decay_t<decltype(of_control)> normals;
    Mesh triangles;
    result = PN::tessellate<Tag>(c.mesh, scheme, chord, triangles,
                                 PN::parameters::join(PN::parameters::attributes(c.table), np),
                                 CGAL::parameters::vertex_normal_map(normals));
    c.normals = normals;
    c.mesh = std::move(triangles);
  });
  return py::array_t<PN::Tessellation_result>(1, &result);
}

// Makes creases, normals and the roundness those of the surfaces that are found; returns these and the number of that of
// each face.
py::tuple recognize(Control& c, int min_facets, double tolerance, double sharp_angle)
{
  const auto of_face = c.mesh.add_property_map<Mesh::Face_index, std::size_t>("f:surface", 0).first;
  const auto roundness = c.mesh.add_property_map<Vertex, double>("v:roundness", 1).first;
  const auto is_crease = c.mesh.add_property_map<Mesh::Edge_index, bool>("e:is_crease").first;
  const auto is_corner = c.mesh.add_property_map<Vertex, bool>("v:is_corner").first;
  const Control::Of_corners normals;
  std::vector<PN::Recognized_surface> surfaces;
  run(1, [&] {
    const auto np = PN::parameters::shared(
      PN::parameters::sharp_angle(sharp_angle).min_facets(min_facets).surface_tolerance(tolerance));
    surfaces = PN::recognize_surfaces(c.mesh, of_face, np);
    PN::surface_creases(c.mesh, of_face, surfaces, is_crease,
                        PN::parameters::join(PN::parameters::vertex_roundness_map(roundness)
                                               .vertex_is_constrained_map(is_corner)
                                               .vertex_normal_map(normals),
                                             np));
  });
  constexpr double infinite = std::numeric_limits<double>::infinity();
  auto of_edges = c.edge_sharpness();
  auto of_vertices = c.vertex_sharpness();
  for (const auto e : c.mesh.edges()) of_edges[e] = is_crease[e] ? infinite : 0;
  for (const Vertex v : c.mesh.vertices()) of_vertices[v] = is_corner[v] ? infinite : 0;
  for (const Halfedge h : corners_of(c.mesh))
    put(normals.roundness_map(), h, roundness[c.mesh.target(h)]);
  c.normals = normals;
  return py::make_tuple(to_array(surfaces),
                        to_array(std::vector<std::int64_t>(of_face.begin(), of_face.end())));
}

} // namespace

void add_meshes(py::module_& module)
{
  PYBIND11_NUMPY_DTYPE(PN::Limit_report, error, normal_error, tolerance, number_of_misses,
                       number_of_stand_ins, depth);
  PYBIND11_NUMPY_DTYPE(PN::Tessellation_result, bound, worst_face, worst_place, reached, depth);
  PYBIND11_NUMPY_DTYPE(PN::Recognized_surface, kind, point, direction, radius, tube_radius,
                       half_angle, residual, number_of_faces);
  module.def("subdivide", subdivide, py::arg("control"), py::arg("levels"), py::arg("progress"));
  module.def("limit", limit, py::arg("control"), py::arg("levels"), py::arg("tolerance"),
             py::arg("normal_tolerance"), py::arg("progress"));
  module.def("tessellate", tessellate, py::arg("control"), py::arg("chord"));
  module.def("recognize", recognize, py::arg("control"), py::arg("min_facets"),
             py::arg("tolerance"), py::arg("sharp_angle"));
}

} // namespace pn_python

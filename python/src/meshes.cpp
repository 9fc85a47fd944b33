// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "Control.h"

#include <CGAL/PN_limit_surface_3/subdivide_to_limit.h>
#include <CGAL/PN_recognition_3/recognize_surfaces.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <stdexcept>
#include <string>

namespace pn_python {

py::dict faces_of(const Mesh& mesh)
{
  std::vector<std::int64_t> offsets(1, 0), vertices;
  for (const auto f : mesh.faces()) {
    for (const Vertex v : mesh.vertices_around_face(mesh.halfedge(f))) vertices.push_back(v);
    offsets.push_back(std::int64_t(vertices.size()));
  }
  return py::dict("offsets"_a = to_array(std::move(offsets)),
                  "indices"_a = to_array(std::move(vertices)));
}

namespace {

// the half-edges of the corners of all faces, in the order that arrays have
std::vector<std::int64_t> corners_of(const Mesh& mesh)
{
  std::vector<std::int64_t> result;
  for (const auto f : mesh.faces())
    for (const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f))) result.push_back(h);
  return result;
}

Control control_mesh(const Reals& points, const Integers& offsets, const Integers& indices,
                     const std::string& name, const std::map<std::string, double>& parameters,
                     bool is_linear, int threads, int border, int estimate)
{
  Control c{PN::any_scheme<double>(name, {parameters.begin(), parameters.end()}), is_linear,
            threads, PN::Border(border), PN::Control_normal_estimate(estimate)};
  c.table.has_face_parents = true;
  for (py::ssize_t v = 0; v < points.shape(0); ++v) c.mesh.add_vertex(rows_of<Point_3>(points)[v]);
  for (py::ssize_t f = 0; f + 1 < offsets.size(); ++f) {
    const std::vector<Vertex> face(indices.data() + offsets.at(f),
                                   indices.data() + offsets.at(f + 1));
    if (std::set<Vertex>(face.begin(), face.end()).size() != std::max<std::size_t>(face.size(), 3))
      throw py::value_error("face " + std::to_string(f) +
                            " has not three or more different vertices");
    if (c.mesh.add_face(face) == Mesh::null_face())
      throw py::value_error("face " + std::to_string(f) +
                            " does not fit to those before it: at an edge more than two meet, or "
                            "two of opposite orientation, or a vertex has no room between others");
    c.table.face_parents.push_back(std::uint32_t(f));
  }
  return c;
}

void set_sharpness(Control& c, const std::optional<double>& degrees, const Integers& creases,
                   const Reals& of_creases, const Integers& corners, const Reals& of_corners)
{
  c.may_be_sharp |= degrees || of_creases.size() + of_corners.size() != 0;
  auto of_edges = c.edge_sharpness();
  auto of_vertices = c.vertex_sharpness();
  if (degrees) PN::detect_creases(c.mesh, *degrees, of_edges);
  for (py::ssize_t i = 0; i < of_creases.size(); ++i) {
    const Vertex v = Vertex(creases.at(2 * i)), w = Vertex(creases.at(2 * i + 1));
    const Halfedge h = c.mesh.halfedge(v, w);
    if (h == Mesh::null_halfedge())
      throw py::value_error("no face has the crease from vertex " + std::to_string(v) +
                            " to vertex " + std::to_string(w));
    of_edges[c.mesh.edge(h)] = of_creases.at(i);
  }
  for (py::ssize_t i = 0; i < of_corners.size(); ++i)
    of_vertices[Vertex(corners.at(i))] = of_corners.at(i);
}

// Calls f(map, key, vertex, number) for the vertices or corners that have normals, in their order.
template <class Function>
void for_each_normal(const Control& c, const Function& f)
{
  std::size_t number = 0;
  if (const auto* of_vertices = std::get_if<Control::Of_vertices>(&c.normals))
    for (const Vertex v : c.mesh.vertices()) f(*of_vertices, v, v, number++);
  else
    for (const auto i : corners_of(c.mesh)) {
      const Halfedge h(static_cast<std::uint32_t>(i));
      f(std::get<Control::Of_corners>(c.normals), h, c.mesh.target(h), number++);
    }
}

// One of each vertex or corner; without normals they are estimated.
void set_normals(Control& c, const std::optional<Reals>& normals,
                 const std::optional<Reals>& roundness)
{
  if (c.is_linear) return;
  const auto n = py::ssize_t(c.mesh.number_of_vertices());
  const auto are_of_corners = [n](const auto& rows) { return rows && rows->shape(0) != n; };
  c.is_estimated = !normals && !roundness;
  if (are_of_corners(normals))
    c.normals = Control::Of_corners();
  else if (c.may_be_sharp || are_of_corners(roundness))
    c.normals = PN::estimate_control_normals(c.mesh, c.sharp());
  else if (!normals)
    c.normals = PN::estimate_control_normals(c.mesh, params::control_normal_estimate(c.estimate));
  // those of vertices are of all corners but where creases make several wedges
  const auto of_edges = c.edge_sharpness();
  std::vector<int> creases(std::size_t(n), 0);
  for (const Halfedge h : c.mesh.halfedges())
    creases[c.mesh.target(h)] += !c.mesh.is_border(c.mesh.edge(h)) && of_edges[c.mesh.edge(h)] > 0;
  for_each_normal(c, [&](const auto& map, const auto& key, Vertex v, std::size_t number) {
    if (normals && (are_of_corners(normals) || creases[v] + c.mesh.is_border(v) < 2))
      put(map, key, rows_of<Vector_3>(*normals)[are_of_corners(normals) ? number : v]);
    if (roundness)
      put(map.roundness_map(), key, roundness->data()[are_of_corners(roundness) ? number : v]);
  });
}

// What a mesh of Python is made of; those of limits have no roundness.
py::dict arrays(Control& c, bool are_of_limit)
{
  std::vector<std::int64_t> creases, corners;
  std::vector<double> of_creases, of_corners, roundness;
  std::vector<Vector_3> normals;
  const auto add = [](const auto& elements, const auto& map, auto& rounds, const auto& f) {
    for (const auto i : elements)
      if (map[i] != 0) f(i), rounds.push_back(map[i]);
  };
  add(c.mesh.edges(), c.edge_sharpness(), of_creases, [&](Edge e) {
    creases.insert(creases.end(), {c.mesh.vertex(e, 0), c.mesh.vertex(e, 1)});
  });
  add(c.mesh.vertices(), c.vertex_sharpness(), of_corners, [&](Vertex v) { corners.push_back(v); });
  if (!c.is_linear || are_of_limit)
    for_each_normal(c, [&](const auto& map, const auto& key, Vertex, std::size_t) {
      normals.push_back(get(map, key));
      roundness.push_back(get(map.roundness_map(), key));
    });
  py::dict result = faces_of(c.mesh);
  result["points"] = to_array(std::vector<Point_3>(c.mesh.points().begin(), c.mesh.points().end()));
  result["creases"] = to_array(std::move(creases)).attr("reshape")(-1, 2);
  result["crease_sharpness"] = to_array(std::move(of_creases));
  result["corners"] = to_array(std::move(corners));
  result["corner_sharpness"] = to_array(std::move(of_corners));
  result["face_parents"] = to_array(c.table.face_parents);
  py::list attributes; // of vertices, then of corners
  for (const auto* kind : {&c.table.vertices, &c.table.corners})
    for (const PN::Attribute_array& array : *kind) attributes.append(to_array(array.values));
  result["attributes"] = attributes;
  if (!c.is_linear || are_of_limit) result["normals"] = to_array(std::move(normals));
  if (!c.is_linear && !are_of_limit) result["roundness"] = to_array(std::move(roundness));
  return result;
}

void add_attribute(Control& c, const Reals& rows, bool is_of_corners, bool is_label)
{
  auto& array = (is_of_corners ? c.table.corners : c.table.vertices).emplace_back();
  array.dimension = std::size_t(rows.shape(1));
  array.values.assign(rows.data(), rows.data() + rows.size());
  if (is_label) array.rule_of_vertices = PN::Attribute_rule::nearest;
}

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

// To the limit if there is a tolerance, of which the report is.
py::array subdivide(Control& c, unsigned levels, const py::object& progress,
                    std::optional<double> tolerance, double normal_tolerance)
{
  const Progress told{progress};
  const auto accuracy = params::tolerance(tolerance.value_or(0))
                          .normal_tolerance(normal_tolerance)
                          .surface_normals(true);
  const auto report = c.run([&](const auto& scheme, const auto& of_mesh, const auto&) {
    const auto np = params::join(params::attributes(c.table),
                                 of_mesh.number_of_iterations(levels).visitor(std::cref(told)));
    if (tolerance) return PN::subdivide_to_limit<Tag>(c.mesh, scheme, params::join(accuracy, np));
    PN::subdivide<Tag>(c.mesh, scheme, np);
    return PN::Limit_report();
  });
  return py::array_t<PN::Limit_report>(1, &report);
}

// Makes creases (sharp for one round) and normals those of the surfaces that are found; returns these, the number of that
// of each face, and the roundness of the vertices.
py::tuple recognize(Control& c, int min_facets, double tolerance, double sharp_angle)
{
  const auto of_face = c.mesh.add_property_map<Mesh::Face_index, std::size_t>("f:surface", 0).first;
  const auto roundness = c.mesh.add_property_map<Vertex, double>("v:roundness", 1).first;
  const Control::Of_corners normals;
  std::vector<PN::Recognized_surface> surfaces;
  run(1, [&] {
    const auto np = params::shared(
      params::sharp_angle(sharp_angle).min_facets(min_facets).surface_tolerance(tolerance));
    surfaces = PN::recognize_surfaces(c.mesh, of_face, np);
    const auto written = params::vertex_roundness_map(roundness).vertex_normal_map(normals);
    PN::surface_creases(c.mesh, of_face, surfaces, c.edge_sharpness(),
                        params::join(written.vertex_is_constrained_map(c.vertex_sharpness()), np));
  });
  c.normals = normals;
  return py::make_tuple(py::array_t<PN::Recognized_surface>(surfaces.size(), surfaces.data()),
                        to_array(std::vector<std::int64_t>(of_face.begin(), of_face.end())),
                        to_array(std::vector<double>(roundness.begin(), roundness.end())));
}

} // namespace

PYBIND11_MODULE(_core, module)
{
  py::register_local_exception<std::overflow_error>(module, "Out_of_range", PyExc_ValueError);
  PYBIND11_NUMPY_DTYPE(PN::Limit_report, error, normal_error, tolerance, number_of_misses,
                       number_of_stand_ins, depth);
  PYBIND11_NUMPY_DTYPE(PN::Recognized_surface, kind, point, direction, radius, tube_radius,
                       half_angle, residual, number_of_faces, widest_step, widest_meridian_step);
  [[maybe_unused]] const auto& [k, p, d, r, t, a, e, n, s, m] = PN::Recognized_surface(); // all
  module.attr("KINDS") = py::tuple(py::cast(PN::Recognized_surface::kind_names));
  module.attr("version") = CGAL_PN_SUBDIVISION_3_VERSION;
  module.attr("has_threads") = std::is_convertible_v<Tag, CGAL::Parallel_tag>;
  py::class_<Control> control(module, "Control");
  control
    .def(py::init(&control_mesh), "points"_a, "offsets"_a, "indices"_a, "scheme"_a, "parameters"_a,
         "linear"_a, "threads"_a, "border"_a, "estimate"_a, Unlocked())
    .def("set_sharpness", set_sharpness, Unlocked())
    .def("set_normals", set_normals, Unlocked())
    .def("add_attribute", add_attribute)
    .def("halfedges", [](const Control& c) { return to_array(corners_of(c.mesh)); })
    .def("arrays", arrays)
    .def("subdivide", subdivide, "levels"_a, "progress"_a, "tolerance"_a, "normal_tolerance"_a)
    .def("recognize", recognize, "min_facets"_a, "tolerance"_a, "sharp_angle"_a);
  add_surfaces(module, control);
}

} // namespace pn_python

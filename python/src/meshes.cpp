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
#include <optional>
#include <set>
#include <stdexcept>

namespace pn_python {

py::tuple faces_of(const Mesh& mesh)
{
  std::vector<std::int64_t> offsets(1, 0), vertices;
  for (const auto f : mesh.faces()) {
    for (const Vertex v : mesh.vertices_around_face(mesh.halfedge(f))) vertices.push_back(v);
    offsets.push_back(std::int64_t(vertices.size()));
  }
  return py::make_tuple(to_array(std::move(offsets)), to_array(std::move(vertices)));
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

} // namespace

Control::Control(const Reals& points, const Integers& offsets, const Integers& indices,
                 const std::string& name, const std::map<std::string, double>& parameters,
                 bool is_linear_scheme, int number_of_threads)
  : scheme(PN::any_scheme<double>(name, {parameters.begin(), parameters.end()}))
  , is_linear(is_linear_scheme)
  , threads(number_of_threads)
{
  table.has_face_parents = true;
  for (py::ssize_t v = 0; v < points.shape(0); ++v) mesh.add_vertex(rows_of<Point_3>(points)[v]);
  std::vector<Vertex> face;
  for (py::ssize_t f = 0; f + 1 < offsets.size(); ++f) {
    face.clear();
    for (py::ssize_t i = offsets.data()[f]; i < offsets.data()[f + 1]; ++i)
      face.push_back(Vertex(indices.at(i)));
    if (std::set<Vertex>(face.begin(), face.end()).size() != std::max<std::size_t>(face.size(), 3))
      throw py::value_error("face " + std::to_string(f) +
                            " has not three or more different vertices");
    if (mesh.add_face(face) == Mesh::null_face())
      throw py::value_error("face " + std::to_string(f) +
                            " does not fit to those before it: at an edge more than two meet, or "
                            "two of opposite orientation, or a vertex has no room between others");
    table.face_parents.push_back(std::uint32_t(f));
  }
}

namespace {

void set_sharpness(Control& c, int border, const std::optional<double>& degrees,
                   const Integers& creases, const Reals& of_creases, const Integers& corners,
                   const Reals& of_corners)
{
  c.border = PN::Border(border);
  c.may_be_sharp = border != 0 || degrees || of_creases.size() != 0 || of_corners.size() != 0;
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
                 const std::optional<Reals>& roundness, int estimate)
{
  if (c.is_linear) return;
  const std::size_t n = c.mesh.number_of_vertices();
  const auto are_of_corners = [n](const std::optional<Reals>& rows) {
    return rows && std::size_t(rows->shape(0)) != n;
  };
  const auto of_edges = c.edge_sharpness();
  c.estimate = PN::Control_normal_estimate(estimate);
  c.is_estimated = !normals && !roundness;
  if (are_of_corners(normals))
    c.normals = Control::Of_corners();
  else if (c.may_be_sharp || are_of_corners(roundness))
    c.normals = PN::estimate_control_normals(c.mesh, c.sharp());
  else if (!normals)
    c.normals =
      PN::estimate_control_normals(c.mesh, PN::parameters::control_normal_estimate(c.estimate));
  // those of vertices are of all corners but where creases make several wedges
  std::vector<int> creases(n, 0);
  for (const auto e : c.mesh.edges())
    for (const unsigned i : {0u, 1u})
      creases[c.mesh.vertex(e, i)] += !c.mesh.is_border(e) && of_edges[e] > 0;
  for_each_normal(c, [&](const auto& map, const auto& key, Vertex v, std::size_t number) {
    if (normals &&
        (are_of_corners(normals) || creases[v] == 0 || (creases[v] == 1 && !c.mesh.is_border(v))))
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
  const auto add_sharp = [](const auto& elements, const auto& map, auto& rounds, auto add) {
    for (const auto i : elements)
      if (map[i] != 0) add(i), rounds.push_back(map[i]);
  };
  add_sharp(c.mesh.edges(), c.edge_sharpness(), of_creases, [&](auto e) {
    creases.insert(creases.end(), {c.mesh.vertex(e, 0), c.mesh.vertex(e, 1)});
  });
  add_sharp(c.mesh.vertices(), c.vertex_sharpness(), of_corners,
            [&](auto v) { corners.push_back(v); });
  if (!c.is_linear || are_of_limit)
    for_each_normal(c, [&](const auto& map, const auto& key, Vertex, std::size_t) {
      normals.push_back(get(map, key));
      roundness.push_back(get(map.roundness_map(), key));
    });
  const auto points = c.mesh.points();
  const py::tuple faces = faces_of(c.mesh);
  py::dict result("points"_a = to_array(std::vector<Point_3>(points.begin(), points.end())),
                  "offsets"_a = faces[0], "indices"_a = faces[1],
                  "creases"_a = to_array(std::move(creases)).attr("reshape")(-1, 2),
                  "crease_sharpness"_a = to_array(std::move(of_creases)),
                  "corners"_a = to_array(std::move(corners)),
                  "corner_sharpness"_a = to_array(std::move(of_corners)),
                  "face_parents"_a = to_array(c.table.face_parents));
  if (!c.is_linear || are_of_limit) result["normals"] = to_array(std::move(normals));
  if (!c.is_linear && !are_of_limit) result["roundness"] = to_array(std::move(roundness));
  return result;
}

std::size_t add_attribute(Control& c, const Reals& rows, bool is_of_corners, bool is_label)
{
  auto& arrays = is_of_corners ? c.table.corners : c.table.vertices;
  auto& array = arrays.emplace_back();
  array.dimension = std::size_t(rows.shape(1));
  array.values.assign(rows.data(), rows.data() + rows.size());
  if (is_label) array.rule_of_vertices = PN::Attribute_rule::nearest;
  return arrays.size() - 1;
}

py::array attribute(const Control& c, std::size_t number, bool is_of_corners)
{
  return to_array((is_of_corners ? c.table.corners : c.table.vertices).at(number).values);
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

// To the limit if there is a tolerance, and then returns the report.
py::object subdivide(Control& c, unsigned levels, const py::object& progress,
                     std::optional<double> tolerance, double normal_tolerance)
{
  const Progress told{progress};
  const auto accuracy = PN::parameters::tolerance(tolerance.value_or(0))
                          .normal_tolerance(normal_tolerance)
                          .surface_normals(true);
  PN::Limit_report report;
  c.run([&](const auto& scheme, const auto& of_mesh, const auto&) {
    const auto np =
      PN::parameters::join(PN::parameters::attributes(c.table),
                           of_mesh.number_of_iterations(levels).visitor(std::cref(told)));
    if (tolerance)
      report = PN::subdivide_to_limit<Tag>(c.mesh, scheme, PN::parameters::join(accuracy, np));
    else
      PN::subdivide<Tag>(c.mesh, scheme, np);
  });
  if (!tolerance) return py::none();
  return py::array_t<PN::Limit_report>(1, &report);
}

// Makes creases (sharp for one round), normals and the roundness those of the surfaces that are found; returns these and
// the number of that of each face.
py::tuple recognize(Control& c, int min_facets, double tolerance, double sharp_angle)
{
  const auto of_face = c.mesh.add_property_map<Mesh::Face_index, std::size_t>("f:surface", 0).first;
  const auto roundness = c.mesh.add_property_map<Vertex, double>("v:roundness", 1).first;
  auto of_edges = c.edge_sharpness();
  auto of_vertices = c.vertex_sharpness();
  const Control::Of_corners normals;
  std::vector<PN::Recognized_surface> surfaces;
  run(1, [&] {
    const auto np = PN::parameters::shared(
      PN::parameters::sharp_angle(sharp_angle).min_facets(min_facets).surface_tolerance(tolerance));
    surfaces = PN::recognize_surfaces(c.mesh, of_face, np);
    PN::surface_creases(c.mesh, of_face, surfaces, of_edges,
                        PN::parameters::join(PN::parameters::vertex_roundness_map(roundness)
                                               .vertex_is_constrained_map(of_vertices)
                                               .vertex_normal_map(normals),
                                             np));
  });
  c.normals = normals;
  for_each_normal(c, [&](const auto& map, const auto& key, Vertex v, std::size_t) {
    put(map.roundness_map(), key, roundness[v]);
  });
  return py::make_tuple(py::array_t<PN::Recognized_surface>(surfaces.size(), surfaces.data()),
                        to_array(std::vector<std::int64_t>(of_face.begin(), of_face.end())));
}

} // namespace

PYBIND11_MODULE(_core, module)
{
  py::register_local_exception<std::overflow_error>(module, "Out_of_range", PyExc_ValueError);
  PYBIND11_NUMPY_DTYPE(PN::Limit_report, error, normal_error, tolerance, number_of_misses,
                       number_of_stand_ins, depth);
  PYBIND11_NUMPY_DTYPE(PN::Recognized_surface, kind, point, direction, radius, tube_radius,
                       half_angle, residual, number_of_faces);
  module.attr("version") = CGAL_PN_SUBDIVISION_3_VERSION;
  module.attr("has_threads") = std::is_convertible_v<Tag, CGAL::Parallel_tag>;
  py::class_<Control> control(module, "Control");
  control
    .def(py::init<const Reals&, const Integers&, const Integers&, const std::string&,
                  const std::map<std::string, double>&, bool, int>(),
         "points"_a, "offsets"_a, "indices"_a, "scheme"_a, "parameters"_a, "linear"_a, "threads"_a,
         Unlocked())
    .def_readonly("threads", &Control::threads)
    .def("set_sharpness", set_sharpness, Unlocked())
    .def("set_normals", set_normals, Unlocked())
    .def("add_attribute", add_attribute)
    .def("attribute", attribute)
    .def("halfedges", [](const Control& c) { return to_array(corners_of(c.mesh)); })
    .def("arrays", arrays)
    .def("subdivide", subdivide, "levels"_a, "progress"_a, "tolerance"_a = py::none(),
         "normal_tolerance"_a = 0.)
    .def("recognize", recognize, "min_facets"_a, "tolerance"_a, "sharp_angle"_a);
  add_surfaces(module, control);
}

} // namespace pn_python

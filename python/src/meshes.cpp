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

#include <functional>
#include <limits>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

namespace pn_python {
namespace {

std::vector<Halfedge> corners_of(const Mesh& mesh)
{
  std::vector<Halfedge> result;
  for (const auto f : mesh.faces())
    for (const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f))) result.push_back(h);
  return result;
}

} // namespace

py::tuple faces_of(const Mesh& mesh)
{
  std::vector<std::int64_t> offsets(1, 0), vertices, halfedges;
  for (const Halfedge h : corners_of(mesh)) {
    vertices.push_back(std::int64_t(mesh.target(h)));
    halfedges.push_back(std::int64_t(h));
    if (mesh.next(h) == mesh.halfedge(mesh.face(h))) // the first one
      offsets.push_back(std::int64_t(vertices.size()));
  }
  return py::make_tuple(to_array(offsets), to_array(vertices), to_array(halfedges));
}

namespace {

void add_faces(Control& c, const Reals& points, const Integers& offsets, const Integers& indices)
{
  for (py::ssize_t v = 0; v < points.shape(0); ++v) c.mesh.add_vertex(rows_of<Point_3>(points)[v]);
  std::vector<Vertex> face;
  for (py::ssize_t f = 0; f + 1 < offsets.size(); ++f) {
    face.clear();
    for (py::ssize_t i = offsets.data()[f]; i < offsets.data()[f + 1]; ++i)
      face.push_back(Vertex(indices.at(i)));
    if (const std::set<Vertex> different(face.begin(), face.end());
        different.size() < 3 || different.size() != face.size())
      throw py::value_error("face " + std::to_string(f) +
                            " has not three or more different vertices");
    if (c.mesh.add_face(face) == Mesh::null_face())
      throw py::value_error("face " + std::to_string(f) +
                            " does not fit to those before it, which leave no room at one of its "
                            "edges or vertices: more than two faces meet, or two of opposite "
                            "orientation");
    c.table.face_parents.push_back(std::uint32_t(f));
  }
}

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
    for (const Halfedge h : corners_of(c.mesh))
      f(std::get<Control::Of_corners>(c.normals), h, c.mesh.target(h), number++);
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
  const py::gil_scoped_release unlocked;
  const auto np = PN::parameters::control_normal_estimate(c.estimate);
  if (are_of_corners(normals))
    c.normals = Control::Of_corners();
  else if (c.may_be_sharp || are_of_corners(roundness))
    c.normals = PN::estimate_control_normals(c.mesh, PN::parameters::join(np, c.sharp()));
  else if (!normals)
    c.normals = PN::estimate_control_normals(c.mesh, np);
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

// and the roundness, which those of limits have not
py::tuple normals_of(const Control& c, bool are_of_limit)
{
  if (c.is_linear && !are_of_limit) return py::make_tuple(py::none(), py::none());
  std::vector<Vector_3> normals;
  std::vector<double> roundness;
  for_each_normal(c, [&](const auto& map, const auto& key, Vertex, std::size_t) {
    normals.push_back(get(map, key));
    roundness.push_back(get(map.roundness_map(), key));
  });
  const py::object of_control = are_of_limit ? py::object(py::none()) : to_array(roundness);
  return py::make_tuple(to_rows(normals.data(), normals.size()), of_control);
}

// the ends of all edges and their sharpness, and that of the vertices
py::tuple edges_of(Control& c)
{
  const auto of_edges = c.edge_sharpness();
  const auto of_vertices = c.vertex_sharpness();
  std::vector<std::int64_t> ends;
  for (const auto e : c.mesh.edges())
    for (const unsigned i : {0u, 1u}) ends.push_back(std::int64_t(c.mesh.vertex(e, i)));
  return py::make_tuple(to_array(ends),
                        to_array(std::vector<double>(of_edges.begin(), of_edges.end())),
                        to_array(std::vector<double>(of_vertices.begin(), of_vertices.end())));
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

PYBIND11_MODULE(_core, module)
{
  py::register_local_exception<std::overflow_error>(module, "Out_of_range", PyExc_ValueError);
  module.attr("version") = CGAL_PN_SUBDIVISION_3_VERSION;
  module.attr("has_threads") = std::is_convertible_v<Tag, CGAL::Parallel_tag>;
  py::class_<Control>(module, "Control")
    .def(py::init<const std::string&, const std::map<std::string, double>&, bool, int>(),
         py::arg("scheme"), py::arg("parameters"), py::arg("linear"), py::arg("threads"))
    .def_readonly("threads", &Control::threads)
    .def("add_faces", add_faces)
    .def("set_sharpness", set_sharpness)
    .def("set_normals", set_normals)
    .def("add_attribute", add_attribute)
    .def("attribute", attribute)
    .def(
      "points",
      [](const Control& c) { return to_rows(c.mesh.points().data(), c.mesh.number_of_vertices()); })
    .def("faces", [](const Control& c) { return faces_of(c.mesh); })
    .def("normals", normals_of)
    .def("edges", edges_of)
    .def("face_parents", [](const Control& c) { return to_array(c.table.face_parents); });
  PYBIND11_NUMPY_DTYPE(PN::Limit_report, error, normal_error, tolerance, number_of_misses,
                       number_of_stand_ins, depth);
  PYBIND11_NUMPY_DTYPE(PN::Recognized_surface, kind, point, direction, radius, tube_radius,
                       half_angle, residual, number_of_faces);
  module.def("subdivide", subdivide, py::arg("control"), py::arg("levels"), py::arg("progress"));
  module.def("limit", limit, py::arg("control"), py::arg("levels"), py::arg("tolerance"),
             py::arg("normal_tolerance"), py::arg("progress"));
  module.def("recognize", recognize, py::arg("control"), py::arg("min_facets"),
             py::arg("tolerance"), py::arg("sharp_angle"));
  add_surfaces(module);
}

} // namespace pn_python

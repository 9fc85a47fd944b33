// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "Control.h"

#include <CGAL/PN_subdivision_3/detect_creases.h>
#include <CGAL/PN_subdivision_3/estimate_control_normals.h>
#include <CGAL/PN_subdivision_3/schemes/scheme_by_name.h>
#include <CGAL/PN_subdivision_3/version.h>

#include <pybind11/stl.h>

#include <exception>
#include <stdexcept>
#include <utility>

#ifdef CGAL_LINKED_WITH_TBB
#  include <tbb/task_arena.h>
#endif

namespace pn_python {

Control::Control(const Reals& points, const Integers& targets, const Integers& nexts,
                 const Integers& faces, const Integers& of_points, const Integers& of_faces)
{
  const auto n = std::uint32_t(of_points.size()), e = std::uint32_t(targets.size() / 2),
             m = std::uint32_t(of_faces.size());
  const auto at = [](const Integers& numbers, std::uint32_t i) {
    return std::uint32_t(numbers.data()[i]); // of -1 the greatest one, which stands for none
  };
  mesh.resize(n, e, m);
  for (std::uint32_t v = 0; v < n; ++v) {
    mesh.point(Vertex(v)) = point_at(points.data(), v);
    mesh.set_halfedge(Vertex(v), Halfedge(at(of_points, v)));
  }
  for (std::uint32_t h = 0; h < 2 * e; ++h) {
    mesh.set_target(Halfedge(h), Vertex(at(targets, h)));
    mesh.set_next(Halfedge(h), Halfedge(at(nexts, h)));
    mesh.set_face(Halfedge(h), Mesh::Face_index(at(faces, h)));
  }
  for (std::uint32_t f = 0; f < m; ++f)
    mesh.set_halfedge(Mesh::Face_index(f), Halfedge(at(of_faces, f)));
  table.has_face_parents = true;
  take_result(std::move(mesh));
}

void Control::take_result(Mesh&& result)
{
  if (&result != &mesh) mesh = std::move(result);
  edge_sharpness = mesh.add_property_map<Mesh::Edge_index, double>("e:sharpness", 0).first;
  vertex_sharpness = mesh.add_property_map<Vertex, double>("v:sharpness", 0).first;
}

std::vector<Halfedge> corners_of(const Mesh& mesh)
{
  std::vector<Halfedge> result;
  for (const auto f : mesh.faces())
    for (const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f))) result.push_back(h);
  return result;
}

void Control::set_scheme(const std::string& name, const std::map<std::string, double>& parameters,
                         bool linear)
{
  scheme = PN::any_scheme<double>(name, {parameters.begin(), parameters.end()});
  is_linear = linear;
}

void Control::set_sharpness(int border_number, const Reals& of_edges, const Reals& of_points,
                            double degrees)
{
  border = static_cast<PN::Border>(border_number);
  is_of_corners = border != PN::Border::surface;
  if (degrees >= 0) PN::detect_creases(mesh, degrees, edge_sharpness);
  for (const auto e : mesh.edges()) {
    if (of_edges.data()[e] != 0) edge_sharpness[e] = of_edges.data()[e];
    is_of_corners = is_of_corners || edge_sharpness[e] != 0;
  }
  for (const auto v : mesh.vertices()) {
    vertex_sharpness[v] = of_points.data()[v];
    is_of_corners = is_of_corners || vertex_sharpness[v] != 0;
  }
}

void Control::set_normals(const std::optional<Reals>& normals, bool are_of_corners,
                          const std::optional<Reals>& roundness, bool is_round_at_corners,
                          int estimate_number)
{
  is_of_corners = is_of_corners || are_of_corners || is_round_at_corners;
  is_estimated = !normals && !roundness;
  estimate = static_cast<PN::Control_normal_estimate>(estimate_number);
  if (is_linear) return;
  const py::gil_scoped_release unlocked;
  const auto np = PN::parameters::control_normal_estimate(estimate);
  if (is_of_corners && !are_of_corners)
    of_corners = PN::estimate_control_normals(mesh, np.border(border)
                                                      .edge_is_constrained_map(edge_sharpness)
                                                      .vertex_is_constrained_map(vertex_sharpness));
  else if (!normals)
    of_vertices = PN::estimate_control_normals(mesh, np);
  // normals of vertices are those of all corners but where creases make several
  // wedges of a vertex
  std::vector<int> wedges(mesh.number_of_vertices(), 0);
  for (const auto e : mesh.edges())
    for (unsigned i = 0; i < 2; ++i)
      wedges[mesh.vertex(e, i)] += !mesh.is_border(e) && edge_sharpness[e] > 0;
  for_each_normal(*this, [&](auto& map, const auto& key, std::size_t v, std::size_t corner) {
    const int most = mesh.is_border(Vertex(std::uint32_t(v))) ? 0 : 1;
    if (normals && (are_of_corners || wedges[v] <= most))
      put(map, key, vector_at(normals->data(), are_of_corners ? corner : v));
    if (roundness)
      put(map.roundness_map(), key, roundness->data()[is_round_at_corners ? corner : v]);
  });
}

py::tuple Control::faces() const
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

py::tuple Control::normals() const
{
  if (surface_normals) return py::make_tuple(to_rows(*surface_normals), py::none());
  if (is_linear) return py::make_tuple(py::none(), py::none());
  std::vector<Vector_3> normals;
  std::vector<double> roundness;
  for_each_normal(*this, [&](const auto& map, const auto& key, std::size_t, std::size_t) {
    normals.push_back(get(map, key));
    roundness.push_back(get(map.roundness_map(), key));
  });
  return py::make_tuple(to_rows(normals), to_array(roundness));
}

py::tuple Control::edges() const
{
  std::vector<std::int64_t> ends;
  for (const auto e : mesh.edges())
    for (unsigned i = 0; i < 2; ++i) ends.push_back(std::int64_t(mesh.vertex(e, i)));
  return py::make_tuple(
    to_array(ends), to_array(std::vector<double>(edge_sharpness.begin(), edge_sharpness.end())),
    to_array(std::vector<double>(vertex_sharpness.begin(), vertex_sharpness.end())));
}

void run([[maybe_unused]] int threads, const std::function<void()>& function)
{
  const py::gil_scoped_release unlocked;
#ifdef CGAL_LINKED_WITH_TBB
  tbb::task_arena(threads).execute(function);
#else
  function();
#endif
}

void Progress::round_done(unsigned round, std::size_t faces) const
{
  const py::gil_scoped_acquire locked;
  if (!function.is_none()) function(round, faces);
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
}

namespace {

void add_attribute(Control& c, const Reals& rows, bool is_of_corners, bool is_label)
{
  PN::Attribute_array array;
  array.dimension = std::size_t(rows.shape(1));
  array.values.assign(rows.data(), rows.data() + rows.size());
  if (is_label) array.rule_of_vertices = PN::Attribute_rule::nearest;
  (is_of_corners ? c.table.corners : c.table.vertices).push_back(std::move(array));
}

py::array_t<double> attribute(const Control& c, std::size_t number, bool is_of_corners)
{
  return to_array((is_of_corners ? c.table.corners : c.table.vertices).at(number).values);
}

} // namespace

PYBIND11_MODULE(_core, module)
{
  py::register_local_exception_translator([](std::exception_ptr exception) { // all else is one
    try {
      std::rethrow_exception(exception);
    } catch (const std::overflow_error& e) {
      PyErr_SetString(PyExc_ValueError, e.what());
    }
  });
  module.attr("version") = CGAL_PN_SUBDIVISION_3_VERSION;
#ifdef CGAL_LINKED_WITH_TBB
  module.attr("has_threads") = true;
#else
  module.attr("has_threads") = false;
#endif
  py::class_<Control>(module, "Control")
    .def(py::init<const Reals&, const Integers&, const Integers&, const Integers&, const Integers&,
                  const Integers&>())
    .def("set_scheme", &Control::set_scheme)
    .def("set_sharpness", &Control::set_sharpness)
    .def("set_normals", &Control::set_normals)
    .def("add_attribute", add_attribute)
    .def("attribute", attribute)
    .def("points", [](const Control& c) { return to_rows(c.mesh.points()); })
    .def("faces", &Control::faces)
    .def("normals", &Control::normals)
    .def("edges", &Control::edges)
    .def("face_parents", [](const Control& c) { return to_array(c.table.face_parents); })
    .def_readwrite("threads", &Control::threads);
  add_subdivide(module);
  add_tessellate(module);
  add_recognize(module);
  add_refiner(module);
  add_limit_surface(module);
  add_curve(module);
}

} // namespace pn_python

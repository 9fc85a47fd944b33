// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_PYTHON_CONTROL_H
#define PN_PYTHON_CONTROL_H

#include <CGAL/PN_subdivision_3/attributes/Attribute_traits.h>
#include <CGAL/PN_subdivision_3/parameters/Estimated_control_normals.h>
#include <CGAL/PN_subdivision_3/parameters/parameters.h>
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#include <CGAL/PN_subdivision_3/schemes/Any_scheme.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/tags.h>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace pn_python {

namespace py = pybind11;
namespace PN = CGAL::PN_subdivision_3;

using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Vector_3 = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Vertex = Mesh::Vertex_index;
using Halfedge = Mesh::Halfedge_index;
using Scheme = PN::Any_scheme<double>;
using Tag = CGAL::Parallel_if_available_tag;

// Arrays as Python gives them, which are copied only if they have another type
// or layout.
using Reals = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Integers = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>;

template <class T>
py::array_t<T> to_array(const std::vector<T>& values)
{
  return py::array_t<T>(py::ssize_t(values.size()), values.data());
}
// the rows of a range of points or vectors
template <int dimension = 3, class Range>
py::array_t<double> to_rows(const Range& range)
{
  py::array_t<double> result(
    {py::ssize_t(std::distance(range.begin(), range.end())), py::ssize_t(dimension)});
  double* x = result.mutable_data();
  for (const auto& p : range)
    for (int i = 0; i < dimension; ++i) *x++ = p[i];
  return result;
}
inline Point_3 point_at(const double* rows, std::size_t i)
{
  return {rows[3 * i], rows[3 * i + 1], rows[3 * i + 2]};
}
inline Vector_3 vector_at(const double* rows, std::size_t i)
{
  return point_at(rows, i) - CGAL::ORIGIN;
}

// of the faces in their order, each at its target
std::vector<Halfedge> corners_of(const Mesh& mesh);

// A control mesh with all that is told of it; functions that refine it leave
// the refined mesh here. Elements are numbered as in the arrays that it is made
// of; corners are those of the faces in their order. Python has checked the
// arrays.
struct Control
{
  // of the half-edges target, next one and face, of the vertices and faces a half-edge; a negative number: none
  Control(const Reals& points, const Integers& targets, const Integers& nexts,
          const Integers& faces, const Integers& of_points, const Integers& of_faces);

  void set_scheme(const std::string& name, const std::map<std::string, double>& parameters,
                  bool linear);
  // Of the edges, besides those at which faces meet at a greater angle, and of the vertices; before the normals.
  void set_sharpness(int border_number, const Reals& of_edges, const Reals& of_points,
                     double degrees);
  // One of each vertex or corner; without normals they are estimated.
  void set_normals(const std::optional<Reals>& normals, bool are_of_corners,
                   const std::optional<Reals>& roundness, bool is_round_at_corners,
                   int estimate_number);
  void take_result(Mesh&& result); // instead of the control mesh
  template <class Map>
  void take_surface_normals(const Map& map)
  {
    surface_normals.emplace();
    if constexpr (std::is_same_v<typename boost::property_traits<Map>::key_type, Halfedge>)
      for (const Halfedge h : corners_of(mesh)) surface_normals->push_back(get(map, h));
    else
      for (const Vertex v : mesh.vertices()) surface_normals->push_back(get(map, v));
  }

  py::tuple faces() const;   // offsets, vertices, half-edges
  py::tuple normals() const; // and the roundness
  py::tuple edges() const;   // their vertices and sharpness, and that of the vertices

  // Calls f(map, key, vertex, corner) for all vertices or corners that have
  // normals.
  template <class Self, class Function>
  static void for_each_normal(Self& self, const Function& f)
  {
    const std::vector<Halfedge> corners = corners_of(self.mesh);
    for (std::size_t i = 0; i < corners.size() && self.is_of_corners; ++i)
      f(self.of_corners, corners[i], std::size_t(self.mesh.target(corners[i])), i);
    for (std::size_t v = 0; v < self.mesh.number_of_vertices() && !self.is_of_corners; ++v)
      f(self.of_vertices, Vertex(std::uint32_t(v)), v, v);
  }

  Mesh mesh;
  std::optional<Scheme> scheme;
  bool is_linear = false;
  bool is_of_corners = false; // something may be sharp, or corners have normals of their own
  bool is_estimated = true;   // the normals and the roundness
  PN::Border border = PN::Border::surface;
  PN::Control_normal_estimate estimate = PN::Control_normal_estimate::coherent;
  Mesh::Property_map<Mesh::Edge_index, double> edge_sharpness;
  Mesh::Property_map<Vertex, double> vertex_sharpness;
  PN::Estimated_control_normals<Vertex, Kernel> of_vertices;
  PN::Estimated_control_normals<Halfedge, Kernel> of_corners;
  std::optional<std::vector<Vector_3>> surface_normals; // of what is no control mesh any more
  PN::Attribute_table table;
  int threads = 1;
};

// Calls f(scheme, np, are_of_corners) with the parameters that describe a
// control mesh.
template <class Function>
void with_parameters(const Control& c, const Function& f)
{
  const auto sharp = PN::parameters::border(c.border)
                       .edge_is_constrained_map(c.edge_sharpness)
                       .vertex_is_constrained_map(c.vertex_sharpness);
  if (c.is_linear)
    f(PN::linear(*c.scheme), sharp, std::false_type());
  else if (c.is_of_corners)
    f(*c.scheme, sharp.vertex_normal_map(c.of_corners), std::true_type());
  else
    f(*c.scheme, CGAL::parameters::vertex_normal_map(c.of_vertices), std::false_type());
}

// Calls a function with so many threads, without the lock of the interpreter.
void run(int threads, const std::function<void()>& function);

// Tells Python's function, if there is one, of each round; what that raises, or
// Ctrl-C, ends the call.
struct Progress
{
  void round_done(unsigned round, std::size_t faces) const;

  py::object function;
};

void add_subdivide(py::module_& module);
void add_tessellate(py::module_& module);
void add_recognize(py::module_& module);
void add_refiner(py::module_& module);
void add_limit_surface(py::module_& module);
void add_curve(py::module_& module);

} // namespace pn_python

#endif // PN_PYTHON_CONTROL_H

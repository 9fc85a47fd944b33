// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_PYTHON_CONTROL_H
#define PN_PYTHON_CONTROL_H

#include <CGAL/PN_subdivision_3.h>
#include <CGAL/PN_subdivision_3/schemes/scheme_by_name.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#ifdef CGAL_LINKED_WITH_TBB
#  include <tbb/task_arena.h>
#endif

namespace pn_python {

namespace py = pybind11;
using namespace py::literals;
namespace PN = CGAL::PN_subdivision_3;
namespace params = PN::parameters;

using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Vector_3 = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Vertex = Mesh::Vertex_index;
using Edge = Mesh::Edge_index;
using Halfedge = Mesh::Halfedge_index;
using Tag = CGAL::Parallel_if_available_tag;
using Reals = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Integers = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>;

// An array that shows values which an owner keeps: numbers, or rows of the doubles that points and vectors consist of.
template <class T>
py::array view(const std::vector<T>& values, py::handle owner)
{
  using Number = std::conditional_t<std::is_arithmetic_v<T>, T, double>;
  std::vector<std::size_t> shape(1, values.size());
  if (std::is_class_v<T>) shape.push_back(sizeof(T) / sizeof(double));
  return py::array_t<Number>(shape, reinterpret_cast<const Number*>(values.data()), owner);
}
// One that keeps them itself.
template <class T>
py::array to_array(std::vector<T> values)
{
  auto* const kept = new std::vector<T>(std::move(values));
  return view(*kept, py::capsule(kept, [](void* v) { delete static_cast<std::vector<T>*>(v); }));
}
template <class T>
const T* rows_of(const Reals& array)
{
  return reinterpret_cast<const T*>(array.data());
}

using Unlocked = py::call_guard<py::gil_scoped_release>; // of the lock of the interpreter

// Calls a function with so many threads, unlocked.
template <class Function>
auto run([[maybe_unused]] int threads, const Function& function)
{
  const py::gil_scoped_release unlocked;
#ifdef CGAL_LINKED_WITH_TBB
  return tbb::task_arena(threads).execute(function);
#else
  return function();
#endif
}

// A control mesh with all that is told of it; functions that refine it leave the refined mesh here. Elements have the
// numbers of the arrays that it is made of, which Python has checked; corners are those of the faces in their order.
struct Control
{
  using Of_vertices = PN::Estimated_control_normals<Vertex, Kernel>;
  using Of_corners = PN::Estimated_control_normals<Halfedge, Kernel>;

  auto edge_sharpness() { return mesh.add_property_map<Edge, double>("e:sharpness", 0).first; }
  auto vertex_sharpness() { return mesh.add_property_map<Vertex, double>("v:sharpness", 0).first; }
  auto sharp() // what is, as parameters of calls that may estimate normals
  {
    return params::border(border)
      .control_normal_estimate(estimate)
      .edge_is_constrained_map(edge_sharpness())
      .vertex_is_constrained_map(vertex_sharpness());
  }
  // Calls f(scheme, np, normals) with the parameters that describe the control mesh, as run() does.
  template <class Function>
  auto run(const Function& f)
  {
    return pn_python::run(threads, [&] {
      const auto* const of_vertices = std::get_if<Of_vertices>(&normals);
      if (is_linear)
        return f(PN::linear(scheme), sharp().vertex_normal_map(*of_vertices), *of_vertices);
      if (of_vertices != nullptr)
        return f(scheme, CGAL::parameters::vertex_normal_map(*of_vertices), *of_vertices);
      return f(scheme, sharp().vertex_normal_map(std::get<Of_corners>(normals)), Of_corners());
    });
  }

  const PN::Any_scheme<double> scheme;
  const bool is_linear; // then there are no normals but those of limits
  const int threads;
  const PN::Border border;
  const PN::Control_normal_estimate estimate;
  Mesh mesh{};
  std::variant<Of_vertices, Of_corners> normals{}; // of corners if something may be sharp
  bool may_be_sharp = border != PN::Border::surface, is_estimated = false;
  PN::Attribute_table table{};
};

py::dict faces_of(const Mesh& mesh); // offsets, indices
void add_surfaces(py::module_& module, py::class_<Control>& control);

} // namespace pn_python

#endif // PN_PYTHON_CONTROL_H

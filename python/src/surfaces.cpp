// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "Control.h"

#include <CGAL/PN_limit_surface_3/Limit_surface_queries.h>
#include <CGAL/PN_subdivision_curve.h>
#include <CGAL/PN_subdivision_limit_3.h>

#include <limits>
#include <memory>

namespace pn_python {
namespace {

template <class Scheme>
using Refiner = PN::Surface_refiner<Mesh, Scheme, Kernel, Tag>;
using PN_scheme = PN::Any_scheme<double>;
using Linear_scheme = PN::Linear_scheme<PN_scheme>;
using Any_refiner = std::variant<Refiner<PN_scheme>, Refiner<Linear_scheme>>;
using Surface = PN::Limit_surface<Mesh, Kernel>;
using Queries = PN::Limit_surface_queries<Mesh, Kernel>;

Any_refiner refiner(Control& c, unsigned levels)
{
  const auto make = [&](const auto& scheme, const auto& np, const auto&...) {
    using R = Refiner<std::decay_t<decltype(scheme)>>;
    return Any_refiner(R(c.mesh, scheme, np.number_of_iterations(levels)));
  };
  if (!c.is_estimated) return c.run(make);
  return run(c.threads, [&] { return make(c.scheme, c.sharp()); }); // again, when points move
}

template <class Scheme>
void add_refiner(py::module_& module, const char* name)
{
  using R = Refiner<Scheme>;
  const auto set = [](R& r, const Integers& vertices, const Reals& rows, bool are_normals) {
    for (py::ssize_t i = 0; i < vertices.size(); ++i)
      if (!are_normals)
        r.set_point(Vertex(vertices.at(i)), rows_of<Point_3>(rows)[i]);
      else if constexpr (std::is_same_v<Scheme, PN_scheme>)
        r.set_normal(Vertex(vertices.at(i)), rows_of<Vector_3>(rows)[i]);
      else
        throw py::value_error("a linear scheme has no control normals");
  };
  py::class_<R>(module, name)
    .def("set", set)
    .def("update", [](R& r, int n) { return to_array(run(n, [&] { return r.update(); })); })
    .def("points", [](const py::object& r) { return view(r.cast<const R&>().points(), r); })
    .def("normals", [](const py::object& r) { return view(r.cast<const R&>().normals(), r); })
    .def("faces", [](const R& r) {
      Mesh mesh;
      r.build_mesh(mesh);
      return faces_of(mesh);
    });
}

py::array tessellate(Control& c, double chord)
{
  for (PN::Attribute_array& array : c.table.corners) array.rule = PN::Corner_rule::all;
  PN::Tessellation_result result;
  c.run([&](const auto& scheme, const auto& np, const auto& of_control) {
    const std::decay_t<decltype(of_control)> normals;
    Mesh triangles;
    result = PN::tessellate<Tag>(c.mesh, scheme, chord, triangles,
                                 params::join(params::attributes(c.table), np),
                                 CGAL::parameters::vertex_normal_map(normals));
    c.normals = normals;
    c.mesh = std::move(triangles);
  });
  return py::array_t<PN::Tessellation_result>(1, &result);
}

std::unique_ptr<Surface> limit_surface(Control& c, double tolerance, double normal_tolerance)
{
  const auto tolerances = params::tolerance(tolerance).normal_tolerance(normal_tolerance);
  return c.run([&](const auto& scheme, const auto& np, const auto&) {
    return std::make_unique<Surface>(c.mesh, scheme, params::join(tolerances, np));
  });
}

// Python knows the structures of the results.
py::array evaluate(const Surface& surface, const Integers& faces, const Reals& uv)
{
  std::vector<Surface::Location> places;
  for (py::ssize_t i = 0; i < faces.size(); ++i)
    places.push_back({Mesh::Face_index(faces.at(i)), uv.at(i, 0), uv.at(i, 1)});
  return to_array(run(1, [&] { return surface.evaluate(places); }));
}

// The closest points, or the first ones in directions.
py::array hits(const Queries& queries, const Reals& points, const std::optional<Reals>& directions)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const Queries::Hit none{{{}, nan, nan}, {nan, nan, nan}, {nan, nan, nan}, nan, nan};
  std::vector<Queries::Hit> found;
  run(1, [&] {
    for (py::ssize_t i = 0; i < points.shape(0); ++i) {
      const Point_3& p = rows_of<Point_3>(points)[i];
      found.push_back(
        directions ? queries.first_intersection(p, rows_of<Vector_3>(*directions)[i]).value_or(none)
                   : queries.closest_point(p));
    }
  });
  return to_array(std::move(found));
}

template <class Point, class Vector>
py::array curve(const Reals& rows, bool has_normals, bool is_spline, int number, int end_number,
                unsigned levels, bool linear, double roundness)
{
  using Item = std::pair<Point, Vector>;
  std::vector<Item> polygon(rows_of<Item>(rows), rows_of<Item>(rows) + rows.shape(0));
  const auto end = PN::Curve_end(end_number);
  const auto np = params::roundness(roundness).number_of_iterations(levels);
  const auto refine = [&](const auto& mask) {
    const py::gil_scoped_release unlocked;
    if (!has_normals && !linear) polygon = PN::estimate_control_normals(polygon, end);
    return linear ? PN::subdivide_curve(polygon, PN::linear(mask), end, np)
                  : PN::subdivide_curve(polygon, mask, end, np);
  };
  return to_array(is_spline ? refine(PN::B_spline_mask(number))
                            : refine(PN::Dubuc_Deslauriers_mask(number)));
}

} // namespace

void add_surfaces(py::module_& module, py::class_<Control>& control)
{
  add_refiner<PN_scheme>(module, "Refiner");
  add_refiner<Linear_scheme>(module, "Linear_refiner");
  py::class_<Surface>(module, "Limit_surface").def("evaluate", evaluate);
  py::class_<Queries>(module, "Limit_surface_queries")
    .def(py::init<const Surface&>(), py::keep_alive<1, 2>(), Unlocked())
    .def("hits", hits);
  PYBIND11_NUMPY_DTYPE(PN::Tessellation_result, bound, worst_face, worst_place, reached, depth);
  control.def("tessellate", tessellate, "chord"_a)
    .def("refiner", refiner)
    .def("limit_surface", limit_surface);
  module.def("curve_2", curve<Kernel::Point_2, Kernel::Vector_2>);
  module.def("curve_3", curve<Point_3, Vector_3>);
}

} // namespace pn_python

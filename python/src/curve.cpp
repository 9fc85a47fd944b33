// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "Control.h"

#include <CGAL/PN_curves/curve_control_normals.h>
#include <CGAL/PN_curves/masks/curve_masks.h>
#include <CGAL/PN_curves/subdivide_curve.h>

#include <pybind11/stl.h>

namespace pn_python {
namespace {

using Mask = PN::Univariate_mask<double>;

template <class Point_or_vector, int dimension>
Point_or_vector row(const Reals& rows, py::ssize_t i)
{
  const double* const x = rows.data() + dimension * i;
  if constexpr (dimension == 2)
    return Point_or_vector(x[0], x[1]);
  else
    return Point_or_vector(x[0], x[1], x[2]);
}

template <int dimension, class Point, class Vector>
py::tuple refine(const Reals& points, const std::optional<Reals>& normals, const Mask& mask,
                 PN::Curve_end end, unsigned levels, bool linear, double roundness)
{
  std::vector<std::pair<Point, Vector>> curve;
  for (py::ssize_t i = 0; i < points.shape(0); ++i)
    curve.emplace_back(row<Point, dimension>(points, i),
                       normals ? row<Vector, dimension>(*normals, i) : Vector(CGAL::NULL_VECTOR));
  run(1, [&] {
    if (!normals && !linear) curve = PN::estimate_control_normals(curve, end);
    const auto np = PN::parameters::roundness(roundness).number_of_iterations(levels);
    curve = linear ? PN::subdivide_curve(curve, PN::linear(mask), end, np)
                   : PN::subdivide_curve(curve, mask, end, np);
  });
  std::vector<Point> new_points;
  std::vector<Vector> new_normals;
  for (const auto& [p, n] : curve) {
    new_points.push_back(p);
    new_normals.push_back(n);
  }
  return py::make_tuple(to_rows<dimension>(new_points), to_rows<dimension>(new_normals));
}

py::tuple refine_curve(const Reals& points, const std::optional<Reals>& normals, bool is_spline,
                       int number, int end, unsigned levels, bool linear, double roundness)
{
  const auto of = [](const auto& m) {
    return Mask(m.first_index(), m.template coefficients<double>());
  };
  const Mask mask =
    is_spline ? of(PN::B_spline_mask(number)) : of(PN::Dubuc_Deslauriers_mask(number));
  const auto f = points.shape(1) == 2 ? refine<2, Kernel::Point_2, Kernel::Vector_2>
                                      : refine<3, Point_3, Vector_3>;
  return f(points, normals, mask, static_cast<PN::Curve_end>(end), levels, linear, roundness);
}

} // namespace

void add_curve(py::module_& module)
{
  module.def("refine_curve", refine_curve);
}

} // namespace pn_python

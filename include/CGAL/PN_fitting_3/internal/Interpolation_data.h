// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_FITTING_3_INTERNAL_INTERPOLATION_DATA_H
#define CGAL_PN_FITTING_3_INTERNAL_INTERPOLATION_DATA_H

#include <CGAL/PN_fitting_3/interpolation/Limit_interpolation.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Limit_options.h>
#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

template <int dimension>
using Eigen_vector = Eigen::Matrix<double, dimension, 1>;
template <int dimension>
using Vectors = std::vector<Eigen_vector<dimension>>;

template <int dimension>
Eigen_vector<dimension> to_eigen(const Coordinates<double, dimension>& c)
{
  return Eigen::Map<const Eigen_vector<dimension>>(c.data());
}
template <int dimension>
Coordinates<double, dimension> to_coordinates(const Eigen_vector<dimension>& v)
{
  Coordinates<double, dimension> c;
  for (int i = 0; i < dimension; ++i) c[static_cast<std::size_t>(i)] = v[i];
  return c;
}

// How well limits shall be known.
struct Limit_precision
{
  double tolerance = 0; // absolute
  unsigned min_depth = 0, max_depth = 0;
  bool with_blocks = true; // not only the limits themselves
  double tangents = 0;     // their relative error; 0: that which comes with the limit point
  double second_forms = 0; // their relative error; 0: they are not wanted
};

// What is to be interpolated, and how well.
template <int dimension>
struct Interpolation_data
{
  using Index = std::uint32_t;

  Vectors<dimension> points;       // of all vertices
  Vectors<dimension> normals;      // of all vertices; unit vectors or zero
  Vectors<dimension> binormals;    // of all vertices, of curves in space only
  std::vector<Index> vertices;     // to be interpolated
  std::vector<double> roundness;   // of all vertices; empty: 1
  std::vector<char> is_at_border;  // of all vertices
  std::vector<double> edge_length; // the mean of the edges at each vertex
  std::vector<Index> components;   // to which each vertex belongs
  bool takes_normals = true;       // if not, the scheme is linear
  int exponent = 0;                // of the power of two by which lengths have been divided
  double tolerance = 0;            // absolute
  unsigned max_depth = 12, max_steps = 100;

  // the limit points shall be known better than they have to be met
  Limit_precision precision() const
  {
    Limit_precision p;
    p.tolerance = tolerance / 50;
    p.max_depth = max_depth;
    return p;
  }
};

template <int dimension>
struct Interpolation_result
{
  Vectors<dimension> points;  // of the control net
  Vectors<dimension> normals; // its control normals
  Limit_interpolation report;
};

// What is prescribed at a vertex.
struct Prescribed_vertex
{
  Level_connectivity::Index vertex = 0;
  std::optional<Eigen_vector<3>> point;  // of the limit
  std::optional<Eigen_vector<3>> normal; // of the surface; a unit vector
};

// The principal curvatures that are prescribed at a vertex, positive where the surface bends away from
// its normal: in a direction, which may be zero if both are equal, and across.
struct Prescribed_form
{
  Level_connectivity::Index vertex = 0;
  double along = 0, across = 0;
  Eigen_vector<3> direction = Eigen_vector<3>::Zero();
};

template <int dimension>
double box_size(const std::vector<Eigen::Matrix<double, dimension, 1>>& points)
{
  return box_size(points.size(), dimension, [&](std::size_t i, std::size_t c) {
    return points[i][static_cast<Eigen::Index>(c)];
  });
}

// Divides points of which squares would be out of range by a power of two, which changes no bit of the coordinates.
template <int dimension>
void divide_by_size(Interpolation_data<dimension>& data)
{
  constexpr int harmless = 64;
  const double size =
    (std::min)(box_size<dimension>(data.points), (std::numeric_limits<double>::max)());
  if (!(size > 0) || std::abs(std::ilogb(size)) <= harmless) return;
  data.exponent = std::ilogb(size);
  for (Eigen_vector<dimension>& p : data.points)
    for (double& x : p) x = std::ldexp(x, -data.exponent);
}

// Undoes divide_by_size().
template <class FT, int dimension>
void multiply_by_size(int exponent, Vectors<dimension>& points)
{
  if (exponent == 0) return;
  double largest = (std::numeric_limits<double>::max)();
  if constexpr (std::is_same_v<FT, float>) largest = double((std::numeric_limits<FT>::max)());
  for (std::size_t v = 0; v < points.size(); ++v)
    for (double& x : points[v]) {
      x = std::ldexp(x, exponent);
      if (!(std::abs(x) <= largest))
        throw std::overflow_error("PN_subdivision_3: the control point of vertex " +
                                  std::to_string(v) +
                                  " is out of the range of the number type: scale the points down");
    }
}
template <class FT, int dimension>
void multiply_by_size(Interpolation_data<dimension>& data, Interpolation_result<dimension>& result)
{
  Limit_interpolation& report = result.report;
  for (double* length : {&report.residual, &report.error, &report.tolerance, &report.slip})
    *length = std::ldexp(*length, data.exponent);
  report.curvature_residual = std::ldexp(report.curvature_residual, -data.exponent);
  multiply_by_size<FT, dimension>(data.exponent, data.points);
  multiply_by_size<FT, dimension>(data.exponent, result.points);
}

inline void check_interpolation_options(const Interpolation_options& options)
{
  check_tolerance(options.tolerance);
  if (options.mode == Limit_interpolation::Mode::slide &&
      options.free == Limit_interpolation::Free::smooth)
    throw std::invalid_argument(
      "PN_subdivision_3: control points slide where they are interpolated "
      "only: take Limit_interpolation::Free::fixed, or "
      "Limit_interpolation::Mode::strict");
}

template <int dimension>
void set_demand(const Interpolation_options& options, Interpolation_data<dimension>& data)
{
  data.tolerance = options.tolerance * box_size(data.points);
  data.max_depth = (std::max)(1u, options.max_depth); // the estimate of the error needs one
  data.max_steps = options.max_steps;
}

// NaN counts as infinite
inline double finite_or_infinite(double x)
{
  return std::isfinite(x) ? x : std::numeric_limits<double>::infinity();
}

inline double in_degrees(double radians)
{
  return radians * 57.29577951308232;
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_FITTING_3_INTERNAL_INTERPOLATION_DATA_H

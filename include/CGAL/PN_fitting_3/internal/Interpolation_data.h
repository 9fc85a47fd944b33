// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_FITTING_3_INTERNAL_INTERPOLATION_DATA_H
#define CGAL_PN_FITTING_3_INTERNAL_INTERPOLATION_DATA_H

#include <CGAL/PN_fitting_3/internal/Limit_functionals.h>
#include <CGAL/PN_fitting_3/interpolation/Limit_interpolation.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/meshes/read_mesh.h>
#include <CGAL/PN_subdivision_3/internal/schemes/scheme_of_call.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <Eigen/Core>
#include <boost/property_map/property_map.hpp>

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
  std::vector<Index> components;   // to which each vertex belongs; empty: all to one
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

// Control values with the roundness of the data; a linear scheme is one of zero normals.
template <int dimension>
std::vector<Point_normal<double, dimension>> to_values(const Vectors<dimension>& points,
                                                       const Vectors<dimension>& normals,
                                                       const Interpolation_data<dimension>& data)
{
  std::vector<Point_normal<double, dimension>> values(points.size());
  for (std::size_t v = 0; v < values.size(); ++v) {
    values[v].point = to_coordinates<dimension>(points[v]);
    values[v].normal.fill(0);
    if (data.takes_normals) values[v].normal = to_coordinates<dimension>(normals[v]);
    if (!data.roundness.empty()) values[v].roundness = data.roundness[v];
  }
  return values;
}

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
inline void multiply_by_size(int exponent, Limit_interpolation& report)
{
  for (double* length : {&report.residual, &report.error, &report.tolerance, &report.slip})
    *length = std::ldexp(*length, exponent);
  report.curvature_residual = std::ldexp(report.curvature_residual, -exponent);
}
template <class FT, int dimension>
void multiply_by_size(Interpolation_data<dimension>& data, Interpolation_result<dimension>& result)
{
  multiply_by_size(data.exponent, result.report);
  multiply_by_size<FT, dimension>(data.exponent, data.points);
  multiply_by_size<FT, dimension>(data.exponent, result.points);
}

template <int dimension>
void set_demand(const Interpolation_options& options, Interpolation_data<dimension>& data)
{
  data.tolerance = options.tolerance * box_size(data.points);
  data.max_depth = (std::max)(1u, options.max_depth); // the estimate of the error needs one
  data.max_steps = options.max_steps;
}

// takes vertices without a normal off those to be interpolated; how many
template <int dimension>
std::size_t leave_out_without_normal(Interpolation_data<dimension>& data)
{
  const auto has_none = [&](auto v) { return data.normals[v].isZero(0); };
  const std::size_t before = data.vertices.size();
  data.vertices.erase(std::remove_if(data.vertices.begin(), data.vertices.end(), has_none),
                      data.vertices.end());
  return before - data.vertices.size();
}

// The values of some vertices, one vertex after the other.
template <int dimension>
Eigen::VectorXd gathered(const Vectors<dimension>& values,
                         const std::vector<std::uint32_t>& vertices)
{
  Eigen::VectorXd x(dimension * static_cast<Eigen::Index>(vertices.size()));
  for (std::size_t i = 0; i < vertices.size(); ++i)
    x.segment<dimension>(dimension * static_cast<Eigen::Index>(i)) = values[vertices[i]];
  return x;
}

// puts them back
template <int dimension>
void put_gathered(const Eigen::VectorXd& x, const std::vector<std::uint32_t>& vertices,
                  Vectors<dimension>& values)
{
  for (std::size_t i = 0; i < vertices.size(); ++i)
    values[vertices[i]] = x.segment<dimension>(dimension * static_cast<Eigen::Index>(i));
}

template <class Functionals>
void note_evaluation(const std::vector<Functionals>& functionals, Limit_interpolation& report)
{
  report.error = 0;
  report.depth = 0;
  for (const Functionals& f : functionals) {
    report.error = (std::max)(report.error, f.error);
    report.depth = (std::max)(report.depth, f.depth);
  }
}

// NaN counts as infinite
inline double finite_or_infinite(double x)
{
  return std::isfinite(x) ? x : std::numeric_limits<double>::infinity();
}

// of the vectors that x has one after the other
template <int dimension>
double largest_length(const Eigen::VectorXd& x)
{
  double length = 0;
  for (Eigen::Index i = 0; i < x.size(); i += dimension)
    length = (std::max)(length, finite_or_infinite(x.segment<dimension>(i).norm()));
  return length;
}

inline double in_degrees(double radians)
{
  return radians * 57.29577951308232;
}

// points and normals in double
template <class FT>
Interpolation_data<3> data_in_double(const std::vector<Point_normal<FT, 3>>& values)
{
  Interpolation_data<3> data;
  for (const auto& value : values) {
    data.points.push_back(to_eigen<3>(to_double_3(value.point)));
    data.normals.push_back(to_eigen<3>(to_double_3(value.normal)));
  }
  divide_by_size(data);
  return data;
}

// Points and normals of a mesh in double. Without a map the normals are estimated.
template <class FT, class Scheme, class Access, class Point_map, class Normal_map>
Interpolation_data<3> read_points_and_normals(const Access& access, const Scheme& scheme,
                                              const Level_connectivity& level, Point_map points,
                                              Normal_map normals)
{
  return data_in_double<FT>(
    read_values<PN_average<FT, 3>>(access, level, points, normals, normal_estimate(scheme)));
}

// estimates the normals that are zero
inline void estimate_missing_normals(const Level_connectivity& level,
                                     Control_normal_estimate estimate, Interpolation_data<3>& data)
{
  const auto is_missing = [](const Eigen_vector<3>& n) { return n.isZero(0); };
  if (std::none_of(data.normals.begin(), data.normals.end(), is_missing)) return;
  using Value = Point_normal<double, 3>;
  std::vector<Value> values;
  for (const Eigen_vector<3>& p : data.points) values.push_back({to_coordinates<3>(p), {}});
  estimate_normals_of<double>(level, estimate, values);
  for (std::size_t v = 0; v < values.size(); ++v)
    if (is_missing(data.normals[v])) data.normals[v] = to_eigen<3>(values[v].normal);
}

// Estimates all normals, and the roundness if that is asked for, of points in the place of the data's own points.
inline void estimate_all_normals(const Level_connectivity& level, Control_normal_estimate estimate,
                                 const Vectors<3>& points, bool with_roundness,
                                 Interpolation_data<3>& data)
{
  using Value = Point_normal<double, 3>;
  std::vector<Value> values;
  for (const Eigen_vector<3>& p : points) values.push_back({to_coordinates<3>(p), {}, 1.});
  estimate_normals_of<double>(level, estimate, values);
  if (with_roundness) data.roundness.resize(values.size());
  for (std::size_t v = 0; v < values.size(); ++v) {
    data.normals[v] = to_eigen<3>(values[v].normal);
    if (with_roundness) data.roundness[v] = values[v].roundness;
  }
}

// the connected component of each vertex
inline std::vector<Level_connectivity::Index> components_of(const Level_connectivity& level)
{
  using Index = Level_connectivity::Index;
  std::vector<Index> component(level.number_of_vertices(), Level_connectivity::null), open;
  Index number = 0;
  for (Index v = 0; v < level.number_of_vertices(); ++v) {
    if (component[v] != Level_connectivity::null) continue;
    component[v] = number;
    open.assign(1, v);
    while (!open.empty()) {
      const Index u = open.back();
      open.pop_back();
      if (level.is_isolated(u)) continue;
      level.for_each_neighbor(level.halfedge_of_vertex(u), [&](Index w) {
        if (component[w] != Level_connectivity::null) return;
        component[w] = number;
        open.push_back(w);
      });
    }
    ++number;
  }
  return component;
}

// where the border is, how long the edges are, and what is connected
inline void set_surroundings(const Level_connectivity& level, Interpolation_data<3>& data)
{
  using Index = Level_connectivity::Index;
  const Index n = level.number_of_vertices();
  data.is_at_border.assign(n, 0);
  data.edge_length.assign(n, 0.);
  data.components = components_of(level);
  for (Index v = 0; v < n; ++v) {
    if (level.is_isolated(v)) continue;
    data.is_at_border[v] = level.is_border_vertex(v) ? 1 : 0;
    unsigned edges = 0;
    level.for_each_neighbor(level.halfedge_of_vertex(v), [&](Index w) {
      data.edge_length[v] += (data.points[w] - data.points[v]).norm();
      ++edges;
    });
    data.edge_length[v] /= edges;
  }
}

// the largest angle between the normals of neighbors, in degrees
inline double largest_normal_angle(const Level_connectivity& level, const Vectors<3>& normals)
{
  using Index = Level_connectivity::Index;
  double least = 1;
  for (Index e = 0; e < level.number_of_edges(); ++e) {
    const Eigen_vector<3>& a = normals[level.target(2 * e)];
    const Eigen_vector<3>& b = normals[level.target(2 * e + 1)];
    if (!a.isZero(0) && !b.isZero(0)) least = (std::min)(least, a.dot(b));
  }
  return in_degrees(std::acos((std::max)(-1., least)));
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_FITTING_3_INTERNAL_INTERPOLATION_DATA_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_SUBDIVISION_3_EXAMPLES_EXTRAORDINARY_FAIRNESS_H
#define CGAL_PN_SUBDIVISION_3_EXAMPLES_EXTRAORDINARY_FAIRNESS_H

#include "Extraordinary_data.h"
#include "analysis/extraordinary_curvature.h"

#include <CGAL/PN_limit_surface_3/internal/limit/Ring_geometry.h>

#include <array>
#include <cmath>
#include <vector>

// How fair surfaces are about an extraordinary vertex, and how close to the surface that their control
// data is sampled from. Used by an example and the tests.
namespace extraordinary_data {

// the points and normals of a graph on a layout with another spacing
inline Values sampled(const Extraordinary_net& net, const Graph& graph, double distance)
{
  Values values;
  for (Index v = 0; v < net.number_of_vertices(); ++v) {
    const auto p = layout(net, v);
    values.push_back(on_graph(graph, p[0] * distance / spacing, p[1] * distance / spacing));
  }
  return values;
}

inline Values with_constant_normals(Values values)
{
  for (Value& v : values) v.normal = {0, 0, 1};
  return values;
}

struct Exact_curvature
{
  double gaussian, mean;
};

// of a graph; the mean curvature is positive where it bends away from its upward normal
inline Exact_curvature exact_curvature(const Graph& graph, double x, double y)
{
  const double e = 1e-4;
  const Height at = graph(x, y), right = graph(x + e, y), left = graph(x - e, y),
               up = graph(x, y + e), down = graph(x, y - e);
  const double xx = (right.x - left.x) / (2 * e), yy = (up.y - down.y) / (2 * e);
  const double xy = (right.y - left.y + up.x - down.x) / (4 * e);
  const double s = 1 + at.x * at.x + at.y * at.y;
  const double sum = (1 + at.y * at.y) * xx - 2 * at.x * at.y * xy + (1 + at.x * at.x) * yy;
  return {(xx * yy - xy * xy) / (s * s), -sum / (2 * s * std::sqrt(s))};
}

// over the rings 0 to 9
struct Fairness
{
  double variation = 0;     // the integral of |grad H|^2
  double squared_error = 0; // of the mean curvature, summed over the vertices of the rings
  double squared_scale = 0; // of H^2 + |K|, so
  double gaussian = 0;      // the mean over ring 9
  double relative_error() const { return std::sqrt(squared_error / squared_scale); }
};

// Measures nets of one valence.
template <class Scheme>
class Fairness_measure
{
public:
  using Zoom = CGAL::PN_subdivision_3::Extraordinary_vertex_zoom<Scheme>;

  Fairness_measure(const Scheme& scheme, Index valence)
    : zoom_(scheme, valence)
    , finest_(Zoom::degree, valence, 17)
    , jet_(Zoom::degree)
  {
    const auto level = finest_.level();
    for (Index v = 0; v < finest_.number_of_vertices(); ++v) {
      number_.push_back(vertices_.size());
      if (finest_.norm(v) < 8 || finest_.norm(v) > 16) continue;
      vertices_.push_back(v);
      CGAL::PN_subdivision_3::append_regular_ring(level, v, stencils_);
    }
  }

  const Zoom& zoom() const { return zoom_; }

  // the values are those of the graph, if there is one, before they are turned
  Fairness operator()(Values values, const Graph& graph) const
  {
    Fairness result;
    Vector origin{};
    for (int m = 0; m <= 9; ++m) {
      const Values fine = zoom_.twice_refined(values);
      std::vector<double> mean;
      double sum = 0;
      for (std::size_t i = 0; i < vertices_.size(); ++i) {
        const auto k = jet_(&stencils_[i * jet_.size()], fine.data());
        mean.push_back(k.mean);
        sum += k.gaussian;
        if (!graph) continue;
        const Vector& p = fine[vertices_[i]].point;
        const Exact_curvature exact = exact_curvature(graph, origin[0] + p[0], origin[1] + p[1]);
        result.squared_error += (k.mean - exact.mean) * (k.mean - exact.mean);
        result.squared_scale += exact.mean * exact.mean + std::abs(exact.gaussian);
      }
      result.gaussian = sum / double(vertices_.size());
      result.variation += variation(fine, mean);
      values = zoom_.refined(values, origin);
    }
    return result;
  }

private:
  bool is_in_ring(Index v) const { return finest_.norm(v) >= 8 && finest_.norm(v) <= 16; }

  double variation(const Values& fine, const std::vector<double>& mean) const
  {
    double sum = 0;
    for (const auto& [sector, corners] : finest_.faces())
      for (std::size_t k = 2; k < corners.size(); ++k) {
        const std::array<Index, 3> v = {
          finest_.vertex(sector, corners[0][0], corners[0][1]),
          finest_.vertex(sector, corners[k - 1][0], corners[k - 1][1]),
          finest_.vertex(sector, corners[k][0], corners[k][1])};
        if (is_in_ring(v[0]) && is_in_ring(v[1]) && is_in_ring(v[2]))
          sum +=
            variation(fine, v, {mean[number_[v[0]]], mean[number_[v[1]]], mean[number_[v[2]]]});
      }
    return sum;
  }

  // the integral of the squared gradient of a linear function over a triangle
  static double variation(const Values& values, const std::array<Index, 3>& v,
                          const std::array<double, 3>& f)
  {
    std::array<Vector, 3> side; // opposite to the corners
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t c = 0; c < 3; ++c)
        side[i][c] = values[v[(i + 2) % 3]].point[c] - values[v[(i + 1) % 3]].point[c];
    const auto product = [](const Vector& a, const Vector& b) {
      return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    };
    const double a = product(side[0], side[0]), b = product(side[1], side[1]),
                 c = product(side[0], side[1]);
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) sum += f[i] * f[j] * product(side[i], side[j]);
    return sum / (2 * std::sqrt(a * b - c * c));
  }

  Zoom zoom_;
  Extraordinary_net finest_;
  CGAL::PN_subdivision_3::internal::Regular_jet<double> jet_;
  std::vector<std::size_t> number_; // of a vertex among those of a ring
  std::vector<Index> vertices_, stencils_;
};

} // namespace extraordinary_data

#endif // CGAL_PN_SUBDIVISION_3_EXAMPLES_EXTRAORDINARY_FAIRNESS_H

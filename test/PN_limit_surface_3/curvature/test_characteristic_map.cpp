// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Hypothesis (E) of the preprint for the modified schemes: their characteristic maps are
// regular and injective. Derivatives of a patch are in the hull of the differences of its control points.

#include "Extraordinary_checks.h"

#include <CGAL/PN_subdivision_3/schemes/Tuned_CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Tuned_Loop_scheme.h>

namespace {

namespace PN = CGAL::PN_subdivision_3;
namespace data = extraordinary_data;
using data::Index;
using Plane = std::array<double, 2>;
using Step = std::array<int, 2>;

// The characteristic net, after two rounds: the layout, refined until only the subdominant eigenvalue is left of it.
template <class Scheme>
class Characteristic_net
{
  using Linear = decltype(PN::linear(std::declval<Scheme>()));
  using Zoom = PN::Extraordinary_vertex_zoom<Linear>;

public:
  static constexpr int inner = 8, outer = 16; // of a ring

  Characteristic_net(const Scheme& scheme, Index valence)
    : zoom_(PN::linear(scheme), valence)
    , net_(Zoom::degree, valence, outer + 1)
  {
    data::Values values(zoom_.net().number_of_vertices());
    for (Index v = 0; v < values.size(); ++v) {
      const auto p = data::layout(zoom_.net(), v);
      values[v].point = {p[0], p[1], 0};
    }
    const double lambda = PN::extraordinary_eigenvalues(scheme, valence).subdominant;
    for (int m = 0; m < 80; ++m) {
      data::Vector origin{};
      const data::Values before = std::exchange(values, zoom_.refined(values, origin));
      change_ = 0;
      for (std::size_t v = 0; v < values.size(); ++v)
        for (std::size_t c = 0; c < 2; ++c) {
          values[v].point[c] /= lambda;
          change_ = (std::max)(change_, std::abs(values[v].point[c] - before[v].point[c]));
        }
    }
    fine_ = zoom_.twice_refined(values);
  }

  // the largest change by the last round, after which the net was scaled
  double change() const { return change_; }

  int norm(const std::array<Index, 2>& place) const { return int(net_.norm(place[0], place[1])); }

  Plane at(Index s, int i, int j) const
  {
    const int aside = Zoom::degree == 4 ? 0 : 1; // what a step across an edge goes along it
    const Index n = net_.valence();
    if (j < 0) return at(s + n - 1, -j, i + aside * j);
    if (i < 0) return at(s + 1, j + aside * i, -i);
    const auto& p = fine_[net_.vertex(s % n, Index(i), Index(j))].point;
    return {p[0], p[1]};
  }

  // the faces of a ring, as f(sector, corners in it)
  template <class Function>
  void for_faces(const Function& f) const
  {
    for (const auto& face : net_.faces()) {
      const auto is_inside = [&](const std::array<Index, 2>& c) {
        return norm(c) >= inner && norm(c) <= outer;
      };
      if (std::all_of(face.corners.begin(), face.corners.end(), is_inside))
        f(face.sector, face.corners);
    }
  }

private:
  Zoom zoom_;
  PN::Extraordinary_net net_;
  data::Values fine_;
  double change_ = 0;
};

double sine(const Plane& a, const Plane& b)
{
  return (a[0] * b[1] - a[1] * b[0]) / (std::hypot(a[0], a[1]) * std::hypot(b[0], b[1]));
}

// Whether (i, j) is a control point of the patch of a face: of it, or of a face that shares a corner.
template <class Corners>
bool is_control_point(const Corners& corners, int i, int j)
{
  return std::any_of(corners.begin(), corners.end(), [&](const std::array<Index, 2>& c) {
    const int x = i - int(c[0]), y = j - int(c[1]);
    const bool is_near = std::abs(x) <= 1 && std::abs(y) <= 1;
    return is_near && (corners.size() == 4 || std::abs(x + y) <= 1);
  });
}

template <class Corners, class Function>
void for_control_points(const Corners& corners, const Function& f)
{
  const int i = int(corners[0][0]), j = int(corners[0][1]);
  for (int x = i - 3; x <= i + 3; ++x)
    for (int y = j - 3; y <= j + 3; ++y)
      if (is_control_point(corners, x, y)) f(x, y);
}

// the differences of neighbors among the control points of a patch, along one kind of grid lines
template <class Net, class Corners>
std::vector<Plane> differences(const Net& net, Index s, const Corners& corners, const Step& step)
{
  std::vector<Plane> result;
  for_control_points(corners, [&](int i, int j) {
    if (!is_control_point(corners, i + step[0], j + step[1])) return;
    const Plane p = net.at(s, i, j), q = net.at(s, i + step[0], j + step[1]);
    result.push_back({q[0] - p[0], q[1] - p[1]});
  });
  return result;
}

// the least sine of the angle of a derivative along a grid line and one along the other
template <class Net>
double least_sine(const Net& net)
{
  double least = 1;
  net.for_faces([&](Index s, const auto& corners) {
    const auto second = differences(net, s, corners, {0, 1});
    for (const Plane& a : differences(net, s, corners, {1, 0}))
      for (const Plane& b : second) least = (std::min)(least, sine(a, b));
  });
  return least;
}

// Seen from the vertex the outer boundary of a ring goes counterclockwise: the derivatives along it do, at every point.
template <class Net, class Corners>
void check_boundary(const Net& net, Index s, const Corners& corners)
{
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const auto &from = corners[k], &to = corners[(k + 1) % corners.size()];
    if (net.norm(from) != Net::outer || net.norm(to) != Net::outer) continue;
    const Step step = {int(to[0]) - int(from[0]), int(to[1]) - int(from[1])};
    for (const Plane& d : differences(net, s, corners, step))
      for_control_points(corners, [&](int i, int j) { EXPECT_GT(sine(net.at(s, i, j), d), 0); });
  }
}

// and once
template <class Net>
double turns_of_boundary(const Net& net)
{
  double angle = 0;
  net.for_faces([&](Index s, const auto& corners) {
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const auto &from = corners[k], &to = corners[(k + 1) % corners.size()];
      if (net.norm(from) != Net::outer || net.norm(to) != Net::outer) continue;
      angle +=
        std::asin(sine(net.at(s, int(from[0]), int(from[1])), net.at(s, int(to[0]), int(to[1]))));
    }
  });
  return angle / (2 * std::acos(-1.));
}

template <class Scheme>
void check_map(const Scheme& scheme, Index valence)
{
  SCOPED_TRACE("valence " + std::to_string(valence));
  const Characteristic_net<Scheme> net(scheme, valence);
  EXPECT_LT(net.change(), 1e-12);
  EXPECT_GT(least_sine(net), .6);
  net.for_faces([&](Index s, const auto& corners) { check_boundary(net, s, corners); });
  EXPECT_NEAR(turns_of_boundary(net), 1, 1e-9);
}

TEST(Characteristic_map, OfModifiedCatmullClarkIsRegularAndInjective)
{
  for (const Index valence : {3u, 5u, 6u, 7u, 8u, 9u, 10u, 11u, 12u})
    check_map(PN::CatmullClark_scheme::Tuned(), valence);
}

TEST(Characteristic_map, OfModifiedLoopIsRegularAndInjective)
{
  for (const Index valence : {3u, 4u, 5u, 7u, 8u, 9u, 10u, 11u, 12u})
    check_map(PN::Loop_scheme::Tuned(), valence);
}

} // namespace

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_FAN_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_FAN_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/numbers/number_functions.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/numbers/Unit_normal_traits.h>
#include <CGAL/Uncertain.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// The fan of a vertex: the half-edges to it, clockwise, of which the one on the border comes last; their faces are those of the
// vertex. \pre v is not isolated
inline auto fan_of_vertex(const Level_connectivity& level, Level_connectivity::Index v)
{
  const Level_connectivity::Index h = level.halfedge_of_vertex(v);
  return halfedges_around_target(level, level.is_border(h) ? level.next_around_target(h) : h);
}

// calls function(half-edge) for the half-edges to a vertex, clockwise. \pre v is not isolated
template <class Function>
void for_each_halfedge_to(const Level_connectivity& level, Level_connectivity::Index v,
                          const Function& function)
{
  for (const auto h : halfedges_around_target(level, level.halfedge_of_vertex(v))) function(h);
}

// calls function(half-edge) for the half-edges of a face
template <class Function>
void for_each_halfedge_of_face(const Level_connectivity& level, Level_connectivity::Index f,
                               const Function& function)
{
  for (const auto h : halfedges_around_face(level, level.halfedge_of_face(f))) function(h);
}

// the points of vertices, with normals that are given or estimated
template <class FT>
using Point_normals = std::vector<Point_normal<FT, 3>>;

// The edges e of a fan inverted at its vertex, W = e/|e|^2, and the cross products of neighboring
// ones: the corner normals, each of the length |sin| / (|e||e'|). In double. Edges of length zero are
// left out. The fan is scaled by a power of two where squares would leave the range of double.
template <class FT>
class Inverted_fan
{
public:
  using Index = Level_connectivity::Index;
  using Vector = Coordinates<double, 3>;

  struct Ray
  {
    Index halfedge; // towards the vertex
    Vector inverted;
    double squared; // |W|^2
  };

  struct Corner
  {
    Vector normal; // outwards, for faces that are counterclockwise seen from there
    double squared;
    bool has_area; // more than the rounding of the points can make
  };

  void assign(const Level_connectivity& level, Index v, const Point_normals<FT>& values)
  {
    collect(level, v, values);
    invert();
    make_corners(!level.is_border_vertex(v));
  }

  const std::vector<Ray>& rays() const { return rays_; }
  const std::vector<Corner>& corners() const { return corners_; }
  // whether neither the first nor the last edge of an open fan has length zero
  bool has_ends() const { return has_ends_; }

private:
  using T = At_least_double<FT>;

  void collect(const Level_connectivity& level, Index v, const Point_normals<FT>& values)
  {
    rays_.clear();
    shortest_ = std::numeric_limits<double>::infinity();
    longest_ = 0;
    const auto& p = values[v].point;
    bool last_is_zero = false;
    has_ends_ = true;
    for (const Index h : fan_of_vertex(level, v)) {
      const auto& q = values[level.source(h)].point;
      const Vector e = to_double_3<T>({T(q[0]) - T(p[0]), T(q[1]) - T(p[1]), T(q[2]) - T(p[2])});
      const double size = largest_coordinate(e);
      last_is_zero = size == 0;
      if (last_is_zero && rays_.empty()) has_ends_ = false;
      if (last_is_zero) continue;
      shortest_ = (std::min)(shortest_, size);
      longest_ = (std::max)(longest_, size);
      rays_.push_back({h, e, 0});
    }
    if (last_is_zero) has_ends_ = false;
    if (!std::isfinite(longest_)) rays_.clear();
    if constexpr (!is_exact_v<FT>)
      point_error_ = epsilon() * (largest_coordinate(to_double_3<FT>(p)) + longest_);
  }

  // Inversions of edges that are too long for their squares are too short to count.
  void invert()
  {
    constexpr double largest = 0x1p100;
    int exponent = 0;
    if (!rays_.empty() && (shortest_ < 1 / largest || longest_ > largest))
      exponent = std::ilogb(shortest_);
    if (exponent != 0) point_error_ = std::ldexp(point_error_, -exponent);
    for (Ray& ray : rays_) {
      Vector& e = ray.inverted;
      bool counts = true;
      if (exponent != 0) {
        for (double& x : e) x = std::ldexp(x, -exponent);
        counts = largest_coordinate(e) <= largest;
      }
      ray.squared = counts ? 1 / dot(e, e) : 0;
      for (double& x : e) x = counts ? x * ray.squared : 0;
    }
  }

  void make_corners(bool closed)
  {
    const std::size_t n = rays_.size();
    const std::size_t count = closed ? n : n - (std::min)(n, std::size_t(1));
    const double squared_error = point_error_ * point_error_;
    corners_.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      const Ray &a = rays_[i], &b = rays_[i + 1 < n ? i + 1 : 0];
      const Vector c = cross(b.inverted, a.inverted);
      const auto squared = dot(c, c);
      const double nearer = (std::max)(a.squared, b.squared);
      const double rounding = 256 * (squared_error * nearer + conversion_error * conversion_error);
      corners_[i] = {c, squared, squared > rounding * a.squared * b.squared};
    }
  }

  static double epsilon() { return static_cast<double>(CGAL::to_double(machine_epsilon<FT>())); }

  static constexpr double conversion_error =
    std::is_same_v<T, double> ? 0 : std::numeric_limits<double>::epsilon();

  std::vector<Ray> rays_;
  std::vector<Corner> corners_;
  double shortest_ = 0, longest_ = 0;
  double point_error_ = 0; // of a coordinate, in the scale of the fan
  bool has_ends_ = true;
};

// N. Max, Weights for computing vertex normals from facet normals, 1999: the sum of the cross
// products of the inverted edges. Inversion at a point of a sphere maps the sphere to a plane; the
// inverted edges are a polygon in it, whose area vector this is. An open fan is closed through the
// vertex.

// the sum in the number type T: exact in exact types. Zero if the number type cannot tell.
template <class T, class FT>
Coordinates<T, 3> reciprocal_sum(const Level_connectivity& level, Level_connectivity::Index v,
                                 const Point_normals<FT>& values)
{
  using Vector = Coordinates<T, 3>;
  const auto& p = values[v].point;
  Vector sum{T(0), T(0), T(0)}, first = sum, before = sum;
  bool is_first = true, is_decided = true;
  const auto add = [&sum](const Vector& a, const Vector& b) {
    const Vector c = cross(b, a);
    for (int k = 0; k < 3; ++k) sum[k] += c[k];
  };
  for (const auto h : fan_of_vertex(level, v)) {
    const auto& q = values[level.source(h)].point;
    Vector w{T(q[0]) - T(p[0]), T(q[1]) - T(p[1]), T(q[2]) - T(p[2])};
    const T squared = dot(w, w);
    if (CGAL::certainly(squared == T(0))) continue;
    if (!CGAL::certainly(is_greater(squared, T(0)))) is_decided = false;
    for (T& x : w) x /= squared;
    if (is_first)
      first = w;
    else
      add(before, w);
    is_first = false;
    before = w;
  }
  if (!level.is_border_vertex(v)) add(before, first);
  if (!is_decided) return {T(0), T(0), T(0)};
  return sum;
}

// The unit reciprocal normal of a fan in double; zero if it vanishes.
template <class FT>
Coordinates<double, 3>
reciprocal_normal(const Level_connectivity& level, Level_connectivity::Index v,
                  const Point_normals<FT>& values, const Inverted_fan<FT>& inverted)
{
  using T = At_least_double<FT>;
  Coordinates<double, 3> sum{0, 0, 0};
  double size = 0; // at least the sum of all |W||W'|
  for (const auto& ray : inverted.rays()) size += ray.squared;
  for (const auto& corner : inverted.corners())
    for (int k = 0; k < 3; ++k) sum[k] += corner.normal[k];
  double sum_length = std::sqrt(dot(sum, sum));
  if (!(sum_length > vanishing_tolerance<FT>() * size)) {
    size = 0;
    const auto& rays = inverted.rays();
    for (std::size_t i = 0; i < inverted.corners().size(); ++i)
      size += std::sqrt(rays[i].squared * rays[i + 1 < rays.size() ? i + 1 : 0].squared);
    if constexpr (!std::is_same_v<T, double>) {
      if (!(sum_length > vanishing_tolerance<FT>() * size)) {
        sum = to_double_3<T>(reciprocal_sum<T>(level, v, values));
        sum_length = length(sum);
      }
    }
    const auto epsilon = static_cast<double>(CGAL::to_double(machine_epsilon<FT>()));
    if (!(sum_length > 4096 * epsilon * size) || !std::isfinite(sum_length)) return {0, 0, 0};
  }
  return quotient(sum, sum_length);
}

// an arc from a border vertex to a neighbor whose normal is known
struct Border_arc
{
  Coordinates<double, 3> direction, normal; // unit vectors
};

// The sum of the squares of r_j = (n + n_j).u_j at a normal n(phi): half its first and second
// derivative by phi. Where the arcs fit, r_j = 0, Newton's step is the step of Gauss and Newton; where
// the arcs contradict each other, the step of Gauss and Newton runs to and fro.
struct Border_arcs_sum
{
  using Vector = Coordinates<double, 3>;

  Border_arcs_sum(const std::vector<Border_arc>& arcs, const Vector& n, const Vector& derivative)
  {
    for (const Border_arc& arc : arcs) {
      const auto x = dot(n, arc.direction);
      const auto d = dot(derivative, arc.direction);
      const double r = x + dot(arc.normal, arc.direction);
      slope += d * d;
      first += r * d;
      second += d * d - r * x; // the second derivative of n is -n
    }
  }

  double newton_step(double longest) const
  {
    if (first == 0) return 0;
    if (second * longest > std::abs(first)) return -first / second;
    return std::copysign(longest, -first);
  }

  double slope = 0, first = 0, second = 0;
};

// The PN height between two points is zero if (n_i + n_j).(p_j - p_i) = 0; all pairs of points of a
// sphere or a circular cylinder fulfil it. The border normal is the one orthogonal to the tangent
// of the border that fulfils it best:
//   n = cos(phi) a + sin(phi) (a x t) minimizing the sum of (((n + n_j).e_j)/|e_j|)^2,
// where a is the open fan's normal made orthogonal to t. Returns nothing where that does not
// determine n. The open fan's normal and the tangent are unit vectors, or zero if there is none.
inline std::optional<Coordinates<double, 3>>
arc_border_normal(const Coordinates<double, 3>& open_normal, const Coordinates<double, 3>& tangent,
                  const std::vector<Border_arc>& arcs)
{
  using Vector = Coordinates<double, 3>;
  constexpr int most_steps = 8;
  constexpr double longest_step = 0.5, least_slope = 1e-12, least_agreement = 0.3;
  constexpr double solved = 0x1p-40; // its square is below all rounding

  if (is_zero(open_normal) || is_zero(tangent)) return std::nullopt;
  Vector a = open_normal;
  add_multiple(a, -dot(a, tangent), tangent);
  const double a_length = length(a);
  if (!(a_length > solved)) return std::nullopt;
  a = quotient(a, a_length);
  const Vector b = cross(a, tangent);

  double phi = 0;
  Vector n = a;
  for (int step = 0; step < most_steps; ++step) {
    const Border_arcs_sum sum(arcs, n, cross(n, tangent));
    if (!(sum.slope > least_slope)) {
      if (step == 0) return std::nullopt;
      break;
    }
    const double change = sum.newton_step(longest_step);
    phi += change;
    n = multiple(std::cos(phi), a);
    add_multiple(n, std::sin(phi), b);
    if (std::abs(change) <= solved) break;
  }
  if (!(dot(n, open_normal) > least_agreement)) return std::nullopt;
  return n;
}

// What share a reciprocal or border normal n, a unit vector, has beside the angle-weighted one: all
// if no corner of the fan with an area is turned more than 40 degrees away from n, nothing from 60
// degrees on or if no corner has an area. A corner of nearly 180 degrees is turned far on a smooth
// shape, too; a corner of a polygon, up to 60 degrees, counts as turned no more than the polygon. (From
// 60 to 90 degrees this fades out: reflex corners stay what they are.)
template <class FT, class Face_normal_of>
double blend_weight(const Coordinates<double, 3>& n, const Inverted_fan<FT>& fan,
                    Face_normal_of& face_normal)
{
  constexpr double cos_40 = 0.76604444311897803520, cos_60 = 0.5;
  double least = 2;
  for (std::size_t i = 0; i < fan.corners().size(); ++i) {
    const auto& corner = fan.corners()[i];
    if (!corner.has_area) continue;
    const auto d = dot(n, corner.normal);
    double turn = 1; // its cosine
    if (!(d > 0 && d * d >= cos_40 * cos_40 * corner.squared)) {
      turn = d / std::sqrt(corner.squared);
      if (turn > 0) {
        const double gain = dot(n, face_normal(fan.rays()[i].halfedge)) - turn;
        turn += smoothstep<double>(turn / cos_60) * (std::max)(gain, 0.);
      }
    }
    if (turn <= cos_60) return 0;
    least = (std::min)(least, turn);
  }
  if (least > 1) return 0;
  return smoothstep<double>((least - cos_60) / (cos_40 - cos_60));
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_FAN_H

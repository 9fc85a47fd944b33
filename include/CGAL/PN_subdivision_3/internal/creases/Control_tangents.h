// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_CONTROL_TANGENTS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_CONTROL_TANGENTS_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/normals/roundness.h>
#include <CGAL/PN_subdivision_3/internal/numbers/number_functions.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/numbers/Unit_normal_traits.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// x without its part along the direction of u, as far as u is long enough to tell a direction. u is the sum or the difference
// of two tangents, whose length is 1 where they are certain.
template <class FT>
void strip_direction(Coordinates<FT, 3>& x, const Coordinates<FT, 3>& original,
                     Coordinates<FT, 3> u)
{
  const FT squared_length = dot(u, u);
  const FT f = smoothstep<FT>(FT(32) * squared_length);
  if (f == FT(0) || squared_length == FT(0)) return;
  divide_by_length(u, squared_length);
  add_multiple(x, FT(-(f * dot(original, u))), u);
}

// x without its part in the span of a and b; continuous also where a and b become parallel
template <class FT>
Coordinates<FT, 3> strip(const Coordinates<FT, 3>& x, const Coordinates<FT, 3>& a,
                         const Coordinates<FT, 3>& b)
{
  Coordinates<FT, 3> sum = a, result = x;
  add_multiple(sum, FT(1), b);
  strip_direction<FT>(result, x, sum);
  strip_direction<FT>(result, x, difference(a, b));
  return result;
}

// the same if a and b are one vector, which intervals do not tell
template <class FT>
Coordinates<FT, 3> strip(const Coordinates<FT, 3>& x, const Coordinates<FT, 3>& a)
{
  Coordinates<FT, 3> sum = a, result = x;
  add_multiple(sum, FT(1), a);
  strip_direction<FT>(result, x, sum);
  return result;
}

// The tangents of the creases of a control level, where they are zero, from its points and the normals that are given.
template <class FT>
class Control_tangents
{
public:
  using Index = Level_connectivity::Index;
  using Value = Point_normal<FT, 3>;
  using Vector = Coordinates<FT, 3>;

  // values[slot] has the point, and the normal if that is given; with joints, lines and arcs may join where it is not
  Control_tangents(const Level_connectivity& level, Creases<FT>& creases,
                   const std::vector<Value>& values, const std::vector<bool>& is_given,
                   bool has_joints)
    : level_(level)
    , creases_(creases)
    , values_(values)
    , is_given_(is_given)
    , has_joints_(has_joints)
    , is_at_crease_vertex_(creases.edges.size(), {false, false})
  {}

  void operator()()
  {
    for (const Crease_star& star : creases_.stars)
      if (creases_.rule(star) == Vertex_rule::crease)
        name_undecided<FT>([&] { make_crease_tangents(star); }, name(star));
    turn_at_joints();
    for (const Crease_star& star : creases_.stars)
      if (creases_.rule(star) != Vertex_rule::crease)
        for (const Crease_halfedge& e : creases_.ends_of(star))
          if (!is_given(e)) name_undecided<FT>([&] { make_end_tangent(e); }, name(star));
    if (creases_.has_fixed_border)
      for (Crease_edge<FT>& e : creases_.edges)
        if (e.is_border()) e.tangent_from = {zero_vector<FT, 3>(), zero_vector<FT, 3>()};
  }

private:
  static auto name(const Crease_star& star)
  {
    return
      [v = star.vertex] { return "the tangents of the creases at vertex " + std::to_string(v); };
  }

  // the vector from the vertex of the end to the other end of the edge
  Vector along(const Crease_halfedge& e) const
  {
    const Index h = creases_.halfedge(e);
    return difference(values_[level_.source(h)].point, values_[level_.target(h)].point);
  }
  Vector given_normal(Index slot) const
  {
    return is_given_[slot] ? values_[slot].normal : zero_vector<FT, 3>();
  }
  bool has_joint(Index slot) const { return has_joints_ && !is_given_[slot]; }
  bool is_given(const Crease_halfedge& e) const
  {
    return !are_certainly_equal(creases_.tangent_from(e), zero_vector<FT, 3>());
  }

  void make_crease_tangents(const Crease_star& star)
  {
    const Crease_halfedge &to_a = creases_.end(star, 0), &to_b = creases_.end(star, 1);
    Vector &a = creases_.tangent_from(to_a), &b = creases_.tangent_from(to_b);
    if (is_given(to_a) && is_given(to_b))
      make_opposite_vectors<FT>(a, b);
    else if (is_given(to_a))
      b = opposite_vector(a);
    else {
      if (!is_given(to_b)) {
        b = made_certain(arc_tangent(along(to_a), along(to_b)), to_b);
        if (may_turn(to_b)) free_.push_back(&star);
      }
      a = opposite_vector(b);
    }
    for (const Crease_halfedge& e : {to_a, to_b}) is_at_crease_vertex_[e.crease][1 - e.side] = true;
  }

  // Where a line joins an arc the tangent has the direction of the longer edge, not of the circle through
  // three points. The tangents of the neighbors tell where.
  void turn_at_joints()
  {
    std::vector<Vector> tangents;
    for (const Crease_star* star : free_)
      name_undecided<FT>([&] { tangents.push_back(joint_tangent(*star)); }, name(*star));
    for (std::size_t i = 0; i < free_.size(); ++i) {
      creases_.tangent_from(creases_.end(*free_[i], 0)) = opposite_vector(tangents[i]);
      creases_.tangent_from(creases_.end(*free_[i], 1)) = tangents[i];
    }
  }

  Vector joint_tangent(const Crease_star& star)
  {
    const Crease_halfedge &to_a = creases_.end(star, 0), &to_b = creases_.end(star, 1);
    const Vector circle = creases_.tangent_from(to_b), x = along(to_b), y = along(to_a);
    const FT x_length = length_of(x), y_length = length_of(y);
    if (is_zero_not_unit(circle) || x_length == FT(0) || y_length == FT(0)) return circle;
    const FT of_x = x_length / (x_length + y_length), of_y = FT(1) - of_x;
    Vector line = zero_vector<FT, 3>();
    add_part(line, FT(of_x * of_x), x, x_length);
    add_part(line, FT(-(of_y * of_y)), y, y_length);
    line = unit_or_zero(line, FT(1));
    if (is_zero_not_unit(line)) return circle;

    const FT circle_length = length_of(circle);
    Vector t = circle;
    for (FT& c : t) c /= circle_length;
    Curvature_mismatch m;
    add_mismatch(m, to_a, t, line, FT(1), FT(y_length / x_length));
    add_mismatch(m, to_b, t, line, FT(-1), FT(1));
    const double share = m.share_of_first(vanishing_tolerance<FT>());
    if (share >= 1) return circle;
    scale(t, FT(share));
    add_multiple(t, FT(1 - share), line);
    t = unit_or_zero(t, FT(1));
    scale(t, circle_length);
    return t;
  }

  // adds two tangents at the vertex of an end, mirrored to the other end of the edge, against the tangent there, if known
  void add_mismatch(Curvature_mismatch& m, const Crease_halfedge& e, const Vector& first,
                    const Vector& second, const FT& sign, const FT& relative_length) const
  {
    if (!is_at_crease_vertex_[e.crease][e.side]) return;
    Vector other = creases_.tangent_towards(e), u = along(e);
    if (is_zero_not_unit(other)) return;
    scale(other, sign);
    const FT length = length_of(u);
    for (FT& c : u) c /= length;
    const auto square_of_difference = [&](const Vector& t) {
      Vector d = zero_vector<FT, 3>();
      add_multiple(d, FT(FT(2) * dot(t, u)), u);
      d = difference(difference(d, t), other);
      const auto x = to_double_3<FT>(d);
      return dot(x, x);
    };
    const double l = close_double(relative_length);
    m.add(square_of_difference(first), square_of_difference(second), 1 / (l * l));
  }

  bool may_turn(const Crease_halfedge& e) const
  {
    const Crease_edge<FT>& crease = creases_.edge(e);
    return (!crease.has_after(e.side) || has_joint(crease.after[e.side])) &&
           (!crease.has_before(e.side) || has_joint(crease.before[e.side]));
  }

  // adds a multiple of the unit vector of x
  static void add_part(Vector& t, const FT& multiple, Vector x, const FT& x_length)
  {
    FT factor = multiple / x_length;
    if constexpr (std::is_floating_point_v<FT>)
      if (!std::isfinite(factor)) { // denormal lengths have no inverse
        for (FT& coordinate : x) coordinate /= x_length;
        factor = multiple;
      }
    add_multiple(t, factor, x);
  }

  // the tangent at 0 of the circle from y through 0 to x: (x/|x|^2 - y/|y|^2) / (1/|x| + 1/|y|)
  static Vector arc_tangent(Vector y, Vector x)
  {
    const FT x_length = length_of(x), y_length = length_of(y);
    Vector t = zero_vector<FT, 3>();
    if (x_length == FT(0) && y_length == FT(0)) return t;
    const FT sum = x_length + y_length;
    if (x_length == FT(0)) {
      add_part(t, FT(-1), y, y_length);
    } else if (y_length == FT(0)) {
      add_part(t, FT(1), x, x_length);
    } else {
      add_part(t, FT(y_length / sum), x, x_length);
      add_part(t, FT(-(x_length / sum)), y, y_length);
    }
    return t;
  }

  // the tangent at a corner or dart: of the arc that has the tangent at the other end of the edge
  void make_end_tangent(const Crease_halfedge& e)
  {
    Vector u = along(e);
    const FT length = length_of(u);
    if (length == FT(0)) {
      creases_.tangent_from(e) = zero_vector<FT, 3>();
      return;
    }
    for (FT& x : u) x /= length;
    const Vector s = opposite_vector(creases_.tangent_towards(e));
    Vector t0 = u;
    const FT squared_length = dot(s, s);
    if (is_at_crease_vertex_[e.crease][e.side] && squared_length != FT(0)) {
      const FT factor = FT(2) * dot(s, u) + FT(1) - root_of_square<FT>(squared_length);
      scale(t0, factor);
      t0 = difference(t0, s);
    }
    creases_.tangent_from(e) = made_certain(t0, e);
  }

  // t0 made orthogonal to the given normals beside the edge, of length 1 unless too little of t0 is left
  Vector made_certain(const Vector& t0, const Crease_halfedge& e) const
  {
    const Crease_edge<FT>& crease = creases_.edge(e);
    Vector n1 = zero_vector<FT, 3>(), n2 = n1;
    if (crease.has_after(e.side)) n1 = given_normal(crease.after[e.side]);
    if (crease.has_before(e.side)) n2 = given_normal(crease.before[e.side]);
    if (is_zero_not_unit(n1)) std::swap(n1, n2);
    if (is_zero_not_unit(n1)) return of_certain_length(t0, t0);
    const bool has_both = !is_zero_not_unit(n2);
    return of_certain_length(t0, has_both ? strip<FT>(t0, n1, n2) : strip<FT>(t0, n1));
  }

  static Vector of_certain_length(const Vector& t0, Vector t)
  {
    const FT tau = Unit_normal_traits<FT>::vanishing_tolerance();
    const FT t0_square = dot(t0, t0), t_square = dot(t, t);
    if (t0_square <= tau * tau || t_square <= tau * tau * t0_square) return zero_vector<FT, 3>();
    divide_by_length(t, t_square);
    if (FT(64) * t0_square < FT(1)) scale(t, smoothstep<FT>(FT(8) * root_of_square<FT>(t0_square)));
    if (FT(4) * t_square < t0_square)
      scale(t, smoothstep<FT>(FT(2) * root_of_square<FT>(t_square / t0_square)));
    drop_short_tangent(t);
    return t;
  }

  const Level_connectivity& level_;
  Creases<FT>& creases_;
  const std::vector<Value>& values_;
  const std::vector<bool>& is_given_;
  const bool has_joints_;
  std::vector<const Crease_star*> free_;                 // stars whose tangents may turn
  std::vector<std::array<bool, 2>> is_at_crease_vertex_; // indexed as Crease_edge::tangent_from
};

template <class FT>
void make_control_tangents(const Level_connectivity& level, Creases<FT>& creases,
                           const std::vector<Point_normal<FT, 3>>& values,
                           const std::vector<bool>& is_given, bool has_joints)
{
  Control_tangents<FT>(level, creases, values, is_given, has_joints)();
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_CONTROL_TANGENTS_H

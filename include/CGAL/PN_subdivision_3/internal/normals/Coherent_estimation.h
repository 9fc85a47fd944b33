// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_COHERENT_ESTIMATION_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_COHERENT_ESTIMATION_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/normals/Fan.h>
#include <CGAL/PN_subdivision_3/internal/normals/Normal_estimation.h>
#include <CGAL/PN_subdivision_3/internal/normals/area_normals.h>
#include <CGAL/PN_subdivision_3/internal/normals/roundness.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// Estimates normals and roundness of sectors. A closed fan has the reciprocal normal where that agrees
// with the neighbors and the fan is not wide, the area normal where not; an open one that of
// Normal_estimation. Round is what is not wide, or is regular, and not at a bend beside what is not
// round.
template <class FT, class Sectors, class Point_of>
class Coherent_estimation
{
public:
  using Index = Level_connectivity::Index;
  using Vector = Coordinates<double, 3>;

  Coherent_estimation(const Level_connectivity& level, const Sectors& sectors,
                      const Point_of& point)
    : level_(level)
    , sectors_(sectors)
    , point_(point)
    , reciprocal_(level, sectors, point)
    , estimates_(sectors.number_of_sectors())
  {}

  // given(s) points to the given normal of a sector or is null; set_normal(s, n) and
  // set_roundness(s, w) get all others
  template <class Given, class Set_normal, class Set_roundness>
  void operator()(const Given& given, const Set_normal& set_normal,
                  const Set_roundness& set_roundness)
  {
    estimate_separately(given, set_normal);
    add_area_normals();
    for (Index s = 0; s < estimates_.size(); ++s)
      if (estimates_[s].kind == Kind::closed)
        estimate_closed(s, set_normal);
      else if (estimates_[s].kind == Kind::open)
        estimate_open(s);
    for (Index s = 0; s < estimates_.size(); ++s)
      if (estimates_[s].kind != Kind::given) set_roundness(s, final_roundness(s));
  }

private:
  enum class Kind { given, empty, open, closed };

  struct Estimate
  {
    Vector reciprocal{0, 0, 0}, area{0, 0, 0}; // unit vectors or zero
    Vector normal{0, 0, 0};                    // the result
    double roundness = 1;                      // but for what the neighbors do to it
    Kind kind = Kind::given;
    bool is_reciprocal = false; // not the area normal in its place
  };

  struct Mismatch
  {
    double reciprocal = 0, area = 0, rounding = 0; // sums of squares of curvatures
    double squared_arc_error = 0; // largest |(n + n_j) e_j|^2 / |e_j|^2 of the reciprocal
  };

  template <class Given, class Set_normal>
  void estimate_separately(const Given& given, const Set_normal& set_normal)
  {
    for (Index s = 0; s < estimates_.size(); ++s)
      if (const Coordinates<FT, 3>* n = given(s))
        estimates_[s].reciprocal = estimates_[s].normal = to_double_3<FT>(*n);
    const auto set_open = [&](Index s, const Coordinates<FT, 3>& n) {
      Estimate& e = estimates_[s];
      e.reciprocal = e.normal = to_double_3<FT>(n);
      e.is_reciprocal = !is_zero(e.normal);
      e.kind = sectors_.is_empty(s) ? Kind::empty : Kind::open;
      set_normal(s, n);
    };
    reciprocal_.estimate(given, set_open,
                         [&](Index s, const Fan&, const Inverted_fan<FT>& inverted) {
                           Estimate& e = estimates_[s];
                           e.reciprocal = reciprocal_.unblended(s);
                           e.is_reciprocal = !is_zero(e.reciprocal);
                           e.roundness = roundness_of_turn(e.reciprocal, inverted);
                           e.kind = Kind::closed;
                           return true;
                         });
  }

  // one normal in place of the other where that vanishes
  void add_area_normals()
  {
    const Area_normals<FT, Sectors, Point_of> area(level_, sectors_, point_);
    for (Index s = 0; s < estimates_.size(); ++s) {
      Estimate& e = estimates_[s];
      e.area = area(s);
      if (is_zero(e.area)) e.area = e.reciprocal;
      if (e.kind == Kind::closed && !e.is_reciprocal) e.reciprocal = e.area;
    }
  }

  template <class Set_normal>
  void estimate_closed(Index s, const Set_normal& set_normal)
  {
    Estimate& e = estimates_[s];
    const Fan fan = sectors_.fan(s);
    inverted_.assign_rays(level_, fan, point_);
    const Mismatch m = mismatch(e, fan);
    const double t = m.reciprocal <= m.rounding ? 1 : share_of_reciprocal(m.reciprocal, m.area);
    const double regular = regularity_of(e, m);
    const double share = t * either(e.roundness, regular);
    e.normal = e.reciprocal;
    if (e.is_reciprocal && share >= 1) {
      set_normal(s, reciprocal_.exact_normal(fan, e.normal));
    } else {
      e.normal = mixed(share, e.reciprocal, e.area);
      set_normal(s, reciprocal_.converted(e.normal));
      inverted_.assign(level_, fan, point_);
      e.roundness = roundness_of_turn(e.normal, inverted_);
    }
    e.roundness = is_zero(e.normal) ? 0 : either(e.roundness, regular);
    if (sectors_.is_at_crease(s)) e.roundness = 1;
  }

  void estimate_open(Index s)
  {
    Estimate& e = estimates_[s];
    if (sectors_.is_at_crease(s)) return;
    const Fan fan = sectors_.fan(s);
    inverted_.assign(level_, fan, point_);
    e.roundness = roundness_of_turn(e.normal, inverted_);
    if (e.roundness < 1) e.roundness = either(e.roundness, regularity_of(e, mismatch(e, fan)));
    if (is_zero(e.normal)) e.roundness = 0;
  }

  static double regularity_of(const Estimate& e, const Mismatch& m)
  {
    Vector difference = e.reciprocal;
    add_multiple<double, 3>(difference, -1, e.area);
    return regularity(length(difference), std::sqrt(m.squared_arc_error));
  }

  static Vector mixed(double share, const Vector& a, const Vector& b)
  {
    Vector n = multiple(share, a);
    add_multiple<double, 3>(n, 1 - share, b);
    const double n_length = length(n);
    return n_length > vanishing_tolerance<FT>() ? quotient(n, n_length) : b;
  }

  // f(inverted edge, its squared length, neighbor) for the edges at hand that have a length
  template <class Function>
  void for_each_edge(const Fan& fan, const Function& f) const
  {
    bool is_first = true;
    for (const auto& ray : inverted_.rays()) {
      const Index neighbor = neighbor_sector(sectors_, fan, ray.halfedge, is_first);
      is_first = false;
      if (ray.squared > 0) f(ray.inverted, ray.squared, estimates_[neighbor]);
    }
  }

  Mismatch mismatch(const Estimate& e, const Fan& fan) const
  {
    Mismatch m;
    for_each_edge(fan, [&](const Vector& inverted, double squared, const Estimate& neighbor) {
      if (is_zero(neighbor.reciprocal)) return;
      const auto of_neighbor = dot<double, 3>(neighbor.reciprocal, inverted);
      const double r = dot<double, 3>(e.reciprocal, inverted) + of_neighbor;
      const double a = dot<double, 3>(e.area, inverted) + of_neighbor;
      m.reciprocal += r * r;
      m.area += a * a;
      m.rounding += squared;
      m.squared_arc_error = (std::max)(m.squared_arc_error, r * r / squared);
    });
    m.rounding *= vanishing_tolerance<FT>() * vanishing_tolerance<FT>();
    return m;
  }

  double final_roundness(Index s)
  {
    const Estimate& e = estimates_[s];
    if (e.kind == Kind::empty || e.roundness == 0 || sectors_.is_at_crease(s)) return e.roundness;
    const Fan fan = sectors_.fan(s);
    if (!has_neighbor_that_is_not_round(fan)) return e.roundness;
    inverted_.assign_rays(level_, fan, point_);
    double least = 1;
    for_each_edge(fan, [&](const Vector& inverted, double squared, const Estimate& neighbor) {
      const double error =
        dot<double, 3>(e.normal, inverted) + dot<double, 3>(neighbor.normal, inverted);
      least = (std::min)(
        least, roundness_beside(neighbor.roundness, std::abs(error) / std::sqrt(squared)));
    });
    return e.roundness * least;
  }

  bool has_neighbor_that_is_not_round(const Fan& fan) const
  {
    bool is_found = false, is_first = true;
    for_each_halfedge(level_, fan, [&](Index h) {
      is_found = is_found || estimates_[neighbor_sector(sectors_, fan, h, is_first)].roundness < 1;
      is_first = false;
    });
    return is_found;
  }

  const Level_connectivity& level_;
  const Sectors& sectors_;
  const Point_of& point_;
  Normal_estimation<FT, Sectors, Point_of> reciprocal_;
  std::vector<Estimate> estimates_;
  Inverted_fan<FT> inverted_; // of the sector at hand
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_COHERENT_ESTIMATION_H

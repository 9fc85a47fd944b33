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
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/normals/Fan.h>
#include <CGAL/PN_subdivision_3/internal/normals/Reciprocal_estimation.h>
#include <CGAL/PN_subdivision_3/internal/normals/face_normals.h>
#include <CGAL/PN_subdivision_3/internal/normals/roundness.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// What is known of the vertices of a level that is cut open along creases.
template <class FT>
struct Wedges
{
  std::vector<bool> is_at_crease;
  std::vector<Coordinates<FT, 3>> area_normals; // in which neighbors have no part
};

// Estimates normals and roundness of vertices. A closed fan has the reciprocal normal where this agrees with
// the neighbors and the fan is not wide, the area normal elsewhere; an open fan has the normal of
// Reciprocal_estimation. A vertex is round if its fan is not wide, or is regular. Where arcs miss each other it
// is so only if its edges do not dip far, it is not at a bend beside a vertex that is not round, is not
// lifted off a plane, and has no faces over which arcs differ.
template <class FT>
class Coherent_estimation
{
public:
  using Index = Level_connectivity::Index;
  using Vector = Coordinates<double, 3>;

  // normals that are given stay, with their roundness; null: none are given, or there are no creases
  Coherent_estimation(const Level_connectivity& level, Point_normals<FT>& values,
                      const std::vector<bool>* is_given, const Wedges<FT>* wedges)
    : level_(level)
    , values_(values)
    , wedges_(wedges)
    , difference_(level, values)
    , reciprocal_(level, values, is_given)
    , estimates_(reciprocal_.estimates())
  {}

  void operator()()
  {
    estimate_separately();
    add_area_normals();
    compare_neighbors();
    bool are_round = true;
    for (Index s = 0; s < estimates_.size(); ++s) {
      Estimate& e = estimates_[s];
      if (e.kind == Kind::closed)
        estimate_closed(s);
      else if (e.kind == Kind::open)
        e.roundness = roundness_of(e, regularity_of(s));
      are_round = are_round && e.roundness == 1 && !(e.is_estimated() && e.dips.share() < 1) &&
                  share_of_arcs(s, std::sqrt(e.largest_squared_arc_error())) == 1;
      if (e.is_estimated()) values_[s].roundness = e.roundness;
    }
    if (are_round && !is_uneven_) return;
    const std::vector<double> misses = largest_misses();
    std::vector<double> shares(estimates_.size(), 1); // the factors where arcs miss each other
    for (Index s = 0; s < estimates_.size(); ++s)
      if (estimates_[s].is_estimated())
        shares[s] = estimates_[s].dips.share() * share_of_arcs(s, misses[s]);
    const auto roundness = [&](Index s) {
      return estimates_[s].roundness * (1 - share_of_miss(misses[s]) * (1 - shares[s]));
    };
    std::vector<double> alone;
    for (Index s = 0; s < estimates_.size(); ++s) alone.push_back(roundness(s));
    compare_roundness(alone, shares);
    if (is_uneven_) {
      compare_lifts(shares);
      compare_arcs_of_faces(shares);
    }
    for (Index s = 0; s < estimates_.size(); ++s)
      if (shares[s] < 1 && estimates_[s].is_estimated()) values_[s].roundness = roundness(s);
  }

private:
  enum class Kind : char { given, empty, open, closed };

public:
  // What is kept of a vertex beside its normal, which is first the reciprocal normal. Members serve for
  // one number after the other: new memory costs more than what is computed here.
  struct More
  {
    Area_sum area_sum; // the normal of an open vertex, then the area, then of length 1 or zero
    Curvature_mismatch mismatch;
    Dips dips;            // of the edges, below the tangent plane of the normal
    double roundness = 1; // without regard to neighbors
    Kind kind = Kind::given;
    bool is_reciprocal = false; // the normal is not the area normal
    bool has_normal = false;
    bool is_narrow = false; // turns little from the reciprocal normal

    bool is_estimated() const { return kind == Kind::open || kind == Kind::closed; }
    Vector& area() { return area_sum.area; }
    const Vector& area() const { return area_sum.area; }
    double& largest_squared_arc_error()
    {
      return area_sum.rounding;
    } // once the area is of length 1
  };
  using Reciprocal = Reciprocal_estimation<FT, More>;

private:
  using Estimate = typename Reciprocal::Estimate;

  void estimate_separately()
  {
    std::vector<Index> open;
    const auto set_open = [&](Index s, const Coordinates<FT, 3>& n) {
      estimates_[s].area() = to_double_3<FT>(n);
      estimates_[s].kind = level_.is_isolated(s) ? Kind::empty : Kind::open;
      open.push_back(s);
      values_[s].normal = n;
    };
    reciprocal_.estimate(set_open, [&](Index s, const Inverted_fan<FT>& inverted) {
      Estimate& e = estimates_[s];
      e.is_reciprocal = e.is_known;
      e.is_narrow = is_narrow(e.normal, inverted);
      e.roundness = e.is_narrow ? 1 : roundness_of_turn(e.normal, inverted);
      e.kind = Kind::closed;
      return true;
    });
    for (Index s : open)
      estimates_[s].normal = std::exchange(estimates_[s].area(), Vector{0, 0, 0});
  }

  // where the normal or the area normal vanishes, the other one takes its place
  void add_area_normals()
  {
    add_areas(level_, difference_, [&](Index s) -> Area_sum& { return estimates_[s].area_sum; });
    for (Estimate& e : estimates_) {
      e.area() = e.area_sum.unit();
      e.largest_squared_arc_error() = 0;
      if (is_zero(e.area())) e.area() = e.normal;
      if (e.kind == Kind::closed && !e.is_reciprocal) e.normal = e.area();
      e.has_normal = !is_zero(e.normal);
    }
  }

  // calls f(s, t, h) for the vertices s and t at the ends of every edge; the half-edge h leads from s to t
  template <class Function>
  void for_each_edge(const Function& f) const
  {
    for (Index e = 0; e < level_.number_of_edges(); ++e) {
      const Index h = level_.is_border(2 * e) ? 2 * e + 1 : 2 * e;
      if (!level_.is_border(h)) f(level_.source(h), level_.target(h), h);
    }
  }

  Vector edge(Index h) const { return difference_(level_.target(h), level_.source(h)); }

  // edges too short for squares are left out
  void compare_neighbors()
  {
    double longest = 0, inverse_of_shortest = 0; // squared
    for_each_edge([&](Index i, Index j, Index h) {
      Estimate &s = estimates_[i], &t = estimates_[j];
      const Vector e = edge(h);
      const double squared = dot(e, e), inverse = 1 / squared;
      inverse_of_shortest = (std::max)(inverse_of_shortest, inverse);
      if (!std::isfinite(inverse) || !s.has_normal || !t.has_normal) return;
      longest = (std::max)(longest, squared);
      const auto dip_s = dot(s.normal, e), dip_t = dot(t.normal, e);
      s.dips.add(dip_s * dip_s, inverse);
      t.dips.add(dip_t * dip_t, inverse);
      const double of_s = has_arc_normal(i) ? dot(evidence(i), e) : dip_s;
      const double of_t = has_arc_normal(j) ? dot(evidence(j), e) : dip_t;
      add_mismatch(s, of_s + of_t, dot(s.area(), e) + of_t, inverse);
      add_mismatch(t, of_s + of_t, dot(t.area(), e) + of_s, inverse);
    });
    longest_squared_ = longest;
    is_uneven_ = may_lift(inverse_of_shortest);
  }

  // The normal of a wedge is made to meet arcs: that it meets them proves nothing.
  bool has_arc_normal(Index s) const
  {
    return wedges_ != nullptr && wedges_->is_at_crease[s] && estimates_[s].kind == Kind::open;
  }
  Vector evidence(Index s) const
  {
    return has_arc_normal(s) ? to_double_3<FT>(wedges_->area_normals[s]) : estimates_[s].normal;
  }

  double share_of_arcs(Index s, double miss) const
  {
    return has_arc_normal(s) ? share_of_wedge(miss) : 1;
  }

  // The largest miss of the arcs of each vertex, relative to their lengths; where points coincide, the difference of normals.
  // Wedges of a plane meet all arcs to normals that are orthogonal to creases: the misses of their neighbors count, too.
  std::vector<double> largest_misses() const
  {
    std::vector<double> own(estimates_.size(), 0);
    for_each_edge([&](Index i, Index j, Index h) {
      const Vector e = edge(h), n = evidence(i), m = evidence(j);
      const double e_length = quick_length(e);
      const double miss =
        e_length > 0 ? std::abs(dot(n, e) + dot(m, e)) / e_length : quick_length(difference(n, m));
      for (Index s : {i, j}) own[s] = (std::max)(own[s], miss);
    });
    std::vector<double> result = own;
    for_each_edge([&](Index i, Index j, Index) {
      if (has_arc_normal(i)) result[i] = (std::max)(result[i], own[j]);
      if (has_arc_normal(j)) result[j] = (std::max)(result[j], own[i]);
    });
    return result;
  }

  bool may_lift(double inverse_of_shortest_squared) const
  {
    constexpr double least = Lift_above_neighbors::least_unevenness;
    return longest_squared_ * inverse_of_shortest_squared > least * least;
  }

  static void add_mismatch(Estimate& e, double of_normal, double of_area, double inverse)
  {
    const double arc_error = of_normal * of_normal * inverse;
    e.mismatch.add(arc_error, of_area * of_area * inverse, inverse);
    double& largest = e.largest_squared_arc_error();
    largest = (std::max)(largest, arc_error);
  }

  void estimate_closed(Index s)
  {
    Estimate& e = estimates_[s];
    const double t = e.mismatch.share_of_first(vanishing_tolerance<FT>());
    if (t >= 1 && e.roundness >= 1 && e.is_reciprocal) {
      values_[s].normal = reciprocal_.exact_normal(s, e.normal);
      return;
    }
    const bool was_narrow = e.is_narrow;
    double regular = was_narrow ? 1 : regularity_of(s);
    const double share = t * either(e.roundness, regular);
    if (share >= 1 && e.is_reciprocal) {
      values_[s].normal = reciprocal_.exact_normal(s, e.normal);
      e.roundness = either(e.roundness, regular);
    } else {
      const Vector n = mixed(share, e.normal, e.area());
      e.is_narrow = was_narrow && is_close(n, e.normal);
      if (was_narrow && !e.is_narrow) regular = regularity_of(s);
      e.normal = n;
      values_[s].normal = reciprocal_.converted(n);
      e.roundness = roundness_of(e, regular);
      e.dips = dips(s);
    }
  }

  // the dips of a closed vertex whose normal is no longer the reciprocal one
  Dips dips(Index s) const
  {
    Dips result;
    for (const Index h : fan_of_vertex(level_, s)) {
      const Vector e = edge(h);
      const double dip = dot(estimates_[s].normal, e), inverse = 1 / dot(e, e);
      if (std::isfinite(inverse)) result.add(dip * dip, inverse);
    }
    return result;
  }

  // the roundness of the vertex whose fan is inverted_
  double roundness_of(const Estimate& e, double regular) const
  {
    if (is_zero(e.normal)) return 0;
    return e.is_narrow ? 1 : either(roundness_of_turn(e.normal, inverted_), regular);
  }

  double regularity_of(Index s)
  {
    inverted_.assign(level_, s, values_);
    Estimate& e = estimates_[s];
    return regularity(quick_length(difference(e.normal, e.area())),
                      std::sqrt(e.largest_squared_arc_error()), evenness(inverted_));
  }

  static Vector mixed(double share, const Vector& a, const Vector& b)
  {
    Vector n = multiple(share, a);
    add_multiple(n, 1 - share, b);
    const double n_length = quick_length(n);
    return n_length > vanishing_tolerance<FT>() ? quotient(n, n_length) : b;
  }

  void compare_roundness(const std::vector<double>& alone, std::vector<double>& shares) const
  {
    const auto is_round = [&](Index s) { return alone[s] == 1; };
    if (std::all_of(alone.begin(), alone.end(), [](double w) { return w == 1; })) return;
    std::vector<double> uneven, least(shares.size(), 1); // no vertex is uneven
    if (is_uneven_) uneven = shares_of_uneven();
    for_each_edge([&](Index i, Index j, Index h) {
      const Estimate &s = estimates_[i], &t = estimates_[j];
      if (is_round(i) && is_round(j)) return;
      const Vector e = edge(h);
      const double e_length = quick_length(e);
      const double miss = std::abs(dot(s.normal, e) + dot(t.normal, e));
      const auto beside = [&](Index own, Index k) {
        const double share = uneven.empty() ? 0 : uneven[k];
        const bool is_evidence = e_length > 0 && !(has_arc_normal(own) && !has_arc_normal(k));
        const double error = is_evidence ? miss * inverse_width(k, share, e_length) : 1;
        return roundness_beside(alone[k], error);
      };
      least[i] = (std::min)(least[i], beside(i, j));
      least[j] = (std::min)(least[j], beside(j, i));
    });
    for (Index s = 0; s < shares.size(); ++s) shares[s] *= least[s];
  }

  // one over the width for the miss of an arc to a vertex: the arc's length, or where the vertex is uneven its shortest edge
  double inverse_width(Index s, double uneven, double length) const
  {
    return (1 - uneven) / length + uneven * std::sqrt(estimates_[s].dips.of_shortest);
  }

  std::vector<double> shares_of_uneven() const
  {
    std::vector<double> result(estimates_.size(), 0);
    for_each_edge([&](Index i, Index j, Index h) { // first the squared lengths of the longest edges
      const Vector e = edge(h);
      for (Index s : {i, j}) result[s] = (std::max)(result[s], dot(e, e));
    });
    for (Index s = 0; s < result.size(); ++s)
      result[s] = share_of_uneven(result[s], 1 / estimates_[s].dips.of_shortest);
    return result;
  }

  void compare_lifts(std::vector<double>& shares)
  {
    for (Index s = 0; s < shares.size(); ++s) {
      const Estimate& e = estimates_[s];
      if (e.kind == Kind::closed && e.roundness * shares[s] > 0 && may_lift(e.dips.of_shortest))
        shares[s] *= share_of_lift(s);
    }
  }

  void compare_arcs_of_faces(std::vector<double>& shares)
  {
    std::vector<double> of_faces(shares.size(), 1);
    for (Index f = 0; f < level_.number_of_faces(); ++f) {
      arcs_.clear();
      bool are_linear = true;
      const auto halfedges = halfedges_around_face(level_, level_.halfedge_of_face(f));
      for (const Index h : halfedges) {
        const Index s = level_.target(h);
        are_linear = are_linear && !(estimates_[s].roundness * shares[s] > 0);
        arcs_.add(edge(h), estimates_[s].normal);
      }
      const double share = are_linear ? 1 : arcs_.share();
      if (share < 1)
        for (const Index h : halfedges) {
          double& of_corner = of_faces[level_.target(h)];
          of_corner = (std::min)(of_corner, share);
        }
    }
    for (Index s = 0; s < shares.size(); ++s) shares[s] *= of_faces[s];
  }

  double share_of_lift(Index s)
  {
    lift_.clear();
    for (const Index h : fan_of_vertex(level_, s)) {
      const Vector e = difference_(level_.source(h), level_.target(h));
      if (std::isfinite(1 / dot(e, e))) lift_.add(e, estimates_[level_.source(h)].normal);
    }
    return lift_.share(estimates_[s].normal);
  }

  const Level_connectivity& level_;
  Point_normals<FT>& values_;
  const Wedges<FT>* const wedges_;
  const Scaled_differences<FT> difference_;
  Reciprocal reciprocal_;
  std::vector<Estimate>& estimates_; // of reciprocal_
  Inverted_fan<FT> inverted_;        // of the vertex at hand
  Lift_above_neighbors lift_;        // of the vertex at hand
  Spread_of_arcs arcs_;              // of the face at hand
  double longest_squared_ = 0;       // of all edges
  bool is_uneven_ = false;           // some vertex may be lifted
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_COHERENT_ESTIMATION_H

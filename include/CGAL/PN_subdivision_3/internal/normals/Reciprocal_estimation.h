// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_RECIPROCAL_ESTIMATION_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_RECIPROCAL_ESTIMATION_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/average/input_checks.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/normals/Fan.h>
#include <CGAL/PN_subdivision_3/internal/normals/face_normals.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <cmath>
#include <optional>
#include <type_traits>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// Estimates the normals of vertices: closed fans by reciprocal weights, then open fans by the arcs to closed fans, then
// open fans whose neighbors are all open by the arcs to open fans with a normal, and last mixes in the angle-weighted
// normals of wide fans. Coherent_estimation, which goes on from there, keeps More at each vertex.
template <class FT, class More>
class Reciprocal_estimation
{
public:
  using Index = Level_connectivity::Index;
  using Vector = Coordinates<double, 3>;

  struct Estimate : More
  {
    bool is_known = false;  // arcs may use it
    bool is_done = false;   // it is given or set
    bool is_corner = false; // of one face
    double weight = 0;      // of the normal beside the angle-weighted normal
    Vector normal{0, 0, 0}; // a unit vector, without the angle-weighted share; zero if unknown
  };

  // normals that are given stay; null: none are given
  Reciprocal_estimation(const Level_connectivity& level, Point_normals<FT>& values,
                        const std::vector<bool>* is_given)
    : level_(level)
    , values_(values)
    , is_given_(is_given)
    , face_normal_(level, values)
    , estimates_(level.number_of_vertices())
  {}

  using Set_normal = Function_ref<void(Index, const Coordinates<FT, 3>&)>;
  void operator()()
  {
    const auto set_normal = [this](Index s, const Coordinates<FT, 3>& n) { values_[s].normal = n; };
    estimate(set_normal, [&](Index s, const Inverted_fan<FT>& inverted) {
      Estimate& e = estimates_[s];
      if (!e.is_known) return false;
      e.weight = blend_weight(e.normal, inverted, face_normal_);
      if (e.weight >= 1) set_normal(s, exact_normal(s, e.normal));
      return e.weight >= 1;
    });
  }

  // The same, but that set_normal(v, n) gets all that are not given, and set_closed(v, inverted_fan) may take over a vertex
  // with a closed fan: its normal is not set if it returns true.
  using Set_closed = Function_ref<bool(Index, const Inverted_fan<FT>&)>;
  void estimate(Set_normal set_normal, Set_closed set_closed)
  {
    std::vector<Index> open;
    for (Index s = 0; s < estimates_.size(); ++s) {
      if (is_given_ != nullptr && (*is_given_)[s])
        take_given(s, values_[s].normal);
      else if (level_.is_isolated(s))
        finish(s, {FT(0), FT(0), FT(0)}, set_normal);
      else if (!level_.is_border_vertex(s))
        estimate_closed(s, set_closed);
      else
        open.push_back(s);
    }
    open = estimate_open(open, set_normal);
    open = estimate_open(open, set_normal);
    for (Index s : open) {
      inverted_.assign(level_, s, values_);
      set_open(s, reciprocal_normal(level_, s, values_, inverted_), set_normal);
    }
    blend(set_normal);
  }

  std::vector<Estimate>& estimates() { return estimates_; }

  // the reciprocal normal of a closed fan: in the number type, if that has more to tell than double
  Coordinates<FT, 3> exact_normal([[maybe_unused]] Index s, const Vector& normal) const
  {
    using T = At_least_double<FT>;
    if constexpr (!std::is_same_v<T, double>) {
      Coordinates<T, 3> n = reciprocal_sum<T>(level_, s, values_);
      if (is_finite_number(T(n[0] + n[1] + n[2])) && length(to_double_3<T>(n)) > 0) {
        normalize_control_normal<T, 3>(n);
        return n;
      }
    }
    return converted(normal);
  }

  static Coordinates<FT, 3> converted(const Vector& normal)
  {
    Coordinates<FT, 3> n{FT(normal[0]), FT(normal[1]), FT(normal[2])};
    if constexpr (!std::is_floating_point_v<FT>) normalize_control_normal<FT, 3>(n);
    return n;
  }

private:
  void take_given(Index s, const Coordinates<FT, 3>& normal)
  {
    Estimate& e = estimates_[s];
    e.normal = to_double_3<FT>(normal);
    e.is_known = !is_zero(e.normal);
    e.is_done = true;
  }

  void finish(Index s, const Coordinates<FT, 3>& normal, Set_normal set_normal)
  {
    estimates_[s].is_done = true;
    set_normal(s, normal);
  }

  void estimate_closed(Index s, Set_closed set_closed)
  {
    Estimate& e = estimates_[s];
    inverted_.assign(level_, s, values_);
    e.normal = reciprocal_normal(level_, s, values_, inverted_);
    e.is_known = !is_zero(e.normal);
    e.is_done = set_closed(s, inverted_);
  }

  // estimates open fans by the arcs to known neighbors; returns the fans without known neighbors
  std::vector<Index> estimate_open(const std::vector<Index>& open, Set_normal set_normal)
  {
    std::vector<Index> without_arcs, found;
    for (Index s : open) {
      inverted_.assign(level_, s, values_);
      collect_arcs();
      if (arcs_.empty()) {
        without_arcs.push_back(s);
        continue;
      }
      const Vector open_normal = reciprocal_normal(level_, s, values_, inverted_);
      const std::optional<Vector> n = arc_border_normal(open_normal, border_tangent(), arcs_);
      if (n) found.push_back(s);
      set_open(s, n.value_or(open_normal), set_normal);
    }
    for (Index s : found) estimates_[s].is_known = true; // only now: their order has no part
    return without_arcs;
  }

  void set_open(Index s, const Vector& normal, Set_normal set_normal)
  {
    Estimate& e = estimates_[s];
    e.normal = normal;
    if (is_zero(normal)) return;
    e.weight = blend_weight(normal, inverted_, face_normal_);
    e.is_corner = inverted_.corners().size() == 1;
    if (e.weight >= 1 && !e.is_corner) finish(s, converted(normal), set_normal);
  }

  // an arc to each neighbor whose normal is known
  void collect_arcs()
  {
    arcs_.clear();
    for (const auto& ray : inverted_.rays()) {
      const Estimate& e = estimates_[level_.source(ray.halfedge)];
      if (e.is_known && ray.squared > 0)
        arcs_.push_back({multiple(1 / std::sqrt(ray.squared), ray.inverted), e.normal});
    }
  }

  // The unit tangent, at the vertex of an open fan, of the circle through it and its two neighbors on
  // the border; zero if there is none.
  Vector border_tangent() const
  {
    if (!inverted_.has_ends() || inverted_.rays().size() < 2) return {0, 0, 0};
    const auto &first = inverted_.rays().front(), &last = inverted_.rays().back();
    Vector t = first.inverted;
    add_multiple(t, -1, last.inverted);
    const double size = std::sqrt(first.squared) + std::sqrt(last.squared);
    const double t_length = std::sqrt(dot(t, t));
    if (!(t_length > vanishing_tolerance<FT>() * size)) return {0, 0, 0};
    return quotient(t, t_length);
  }

  void blend(Set_normal set_normal)
  {
    bool all_done = true;
    for (const Estimate& e : estimates_) all_done = all_done && e.is_done;
    if (all_done) return;
    Angle_weighted_normals<FT> angle_weighted(level_, values_);
    for (Index f = 0; f < level_.number_of_faces(); ++f)
      if (!are_corners_done(f)) angle_weighted.add_face(f);
    for (Index s = 0; s < estimates_.size(); ++s)
      if (!estimates_[s].is_done) set_normal(s, blended(s, angle_weighted.normal(s)));
  }

  // A reflex corner beside others is turned by more than 60 degrees from their normal. The only
  // corner of a fan has to be compared with its face.
  bool is_reflex(Index s, const Vector& angle_weighted)
  {
    inverted_.assign(level_, s, values_);
    return dot(inverted_.corners().front().normal, angle_weighted) < 0;
  }

  bool are_corners_done(Index f) const
  {
    for (const Index h : halfedges_around_face(level_, level_.halfedge_of_face(f)))
      if (!estimates_[level_.target(h)].is_done) return false;
    return true;
  }

  Coordinates<FT, 3> blended(Index s, const Coordinates<FT, 3>& angle_weighted)
  {
    const Estimate& e = estimates_[s];
    const Vector other = to_double_3<FT>(angle_weighted);
    if (!(e.weight > 0) || (e.is_corner && is_reflex(s, other))) return angle_weighted;
    if constexpr (Angle_weighted_normals<FT>::has_own_angles)
      if (!level_.is_border_vertex(s)) return blended_in_number_type(s, e, angle_weighted);
    Vector n = multiple(e.weight, e.normal);
    add_multiple(n, 1 - e.weight, other);
    const double n_length = length(n);
    if (!(n_length > vanishing_tolerance<FT>())) return angle_weighted;
    return converted(quotient(n, n_length));
  }

  Coordinates<FT, 3> blended_in_number_type(Index s, const Estimate& e,
                                            const Coordinates<FT, 3>& angle_weighted) const
  {
    Coordinates<FT, 3> n = exact_normal(s, e.normal);
    scale(n, FT(e.weight));
    add_multiple(n, FT(1 - e.weight), angle_weighted);
    const Coordinates<FT, 3> unit = unit_or_zero(n, FT(1));
    return is_zero_not_unit(unit) ? angle_weighted : unit;
  }

  const Level_connectivity& level_;
  Point_normals<FT>& values_;
  const std::vector<bool>* const is_given_;
  Face_normals<FT> face_normal_;
  std::vector<Estimate> estimates_;
  Inverted_fan<FT> inverted_; // of the vertex at hand
  std::vector<Border_arc> arcs_;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_NORMALS_RECIPROCAL_ESTIMATION_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_RECOGNITION_LINEAR_GUARD_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_RECOGNITION_LINEAR_GUARD_H

#include <CGAL/PN_subdivision_3/Recognized_surface.h>
#include <CGAL/PN_subdivision_3/internal/creases/Control_creases.h>
#include <CGAL/PN_subdivision_3/internal/creases/Cut_level.h>
#include <CGAL/PN_subdivision_3/internal/normals/Fan.h>
#include <CGAL/PN_subdivision_3/internal/recognition/Refined_heights.h>
#include <CGAL/PN_subdivision_3/internal/recognition/Surface_tags.h>
#include <CGAL/PN_subdivision_3/internal/schemes/scheme_of_call.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// What has become of surfaces and their normals, beside creases and normals.
struct Surface_fallback
{
  std::size_t segments_given_up = 0, wedges_set_back = 0;
  std::vector<std::size_t> high_faces; // positions in faces(mesh)
  std::vector<std::size_t>
    corners; // positions in vertices(mesh): sharp by themselves, apexes among them
  double excess_of_volume = 0; // as a part of it; none where anything is round or open
};

namespace recognition {

// Sees to it that what has not been recognized is no worse than with the linear scheme: segments beside it that do harm are
// given up, and wedges whose estimated normals do harm get none.
class Linear_guard
{
public:
  using Value = Refined_heights::Value;
  static constexpr int most_refinements = 10;

  Linear_guard(const Level_connectivity& level, const Part& part,
               std::vector<Recognized_surface>& surfaces, const std::vector<std::size_t>& patches,
               double sharp_angle)
    : level_(level)
    , part_(part)
    , surfaces_(surfaces)
    , patch_(patches)
    , sharp_angle_(sharp_angle)
    , heights_(level, part)
  {}

  Surface_fallback operator()()
  {
    set_tags();
    is_zero_.assign(level_.number_of_halfedges(), false);
    if (has_unknown())
      check_tags();
    else
      linear_ = heights_.linear(is_crease_, is_corner_);
    check_normals();
    result_.high_faces.assign(high_.begin(), high_.end());
    result_.excess_of_volume = excess_of_volume();
    for (Index v = 0; v < is_corner_.size(); ++v)
      if (is_corner_[v]) result_.corners.push_back(v);
    return result_;
  }

  const std::vector<bool>& creases() const { return is_crease_; }
  // of half-edges
  const std::vector<Vec3>& normals() const { return corner_normal_; }
  double roundness(Index v) const { return values_[v].roundness; }

private:
  // By which part of it the volume of something closed without rounds, which would gain what the linear scheme loses, changes
  // beyond what it does with that.
  double excess_of_volume() const
  {
    const double before = heights_.volume();
    if (before == 0) return 0;
    for (Index f = 0; f < level_.number_of_faces(); ++f)
      if (tags_->is_round(f)) return 0;
    const double excess = std::abs(volume_ - before) - std::abs(linear_.volume - before);
    return excess > 0 ? excess / std::abs(before) : 0;
  }
  bool is_known(Index f) const { return surfaces_[patch_[f]].kind != Kind::unknown; }
  bool has_unknown() const
  {
    return std::any_of(patch_.begin(), patch_.end(),
                       [&](std::size_t patch) { return surfaces_[patch].kind == Kind::unknown; });
  }

  void set_tags()
  {
    tags_ = std::make_unique<Surface_tags>(level_, part_, surfaces_, patch_, sharp_angle_);
    heights_.measure_from(*tags_);
    is_crease_.resize(level_.number_of_edges());
    for (Index e = 0; e < is_crease_.size(); ++e) is_crease_[e] = tags_->is_crease(e);
    is_corner_.resize(level_.number_of_vertices(), false);
    for (Index v = 0; v < is_corner_.size(); ++v)
      if (tags_->is_corner(v)) is_corner_[v] = true;
  }

  // of faces and those that have a vertex in common with them
  std::vector<double> largest_around(const std::vector<double>& height) const
  {
    std::vector<double> of_vertex(level_.number_of_vertices(), 0), result(height.size(), 0);
    for (Index h = 0; h < level_.number_of_halfedges(); ++h)
      if (!level_.is_border(h)) {
        double& x = of_vertex[level_.target(h)];
        x = (std::max)(x, height[level_.face(h)]);
      }
    for (Index h = 0; h < level_.number_of_halfedges(); ++h)
      if (!level_.is_border(h)) {
        double& x = result[level_.face(h)];
        x = (std::max)(x, of_vertex[level_.target(h)]);
      }
    return result;
  }

  // corners of all faces at the vertices of a face
  template <class Function>
  void for_each_corner_around(Index f, const Function& function) const
  {
    for_each_halfedge_around(f, [&](Index h) {
      if (!level_.is_border(h)) function(h);
    });
  }
  // to the vertices of a face
  template <class Function>
  void for_each_halfedge_around(Index f, const Function& function) const
  {
    for_each_halfedge_of_face(level_, f, [&](Index h) {
      for_each_halfedge(level_, fan_of_vertex(level_, level_.target(h)), function);
    });
  }

  // The linear scheme with these tags against that with sharp edges by their angle.
  void check_tags()
  {
    std::vector<bool> by_angle(level_.number_of_edges(), false);
    for (Index e = 0; e < by_angle.size(); ++e)
      by_angle[e] = !level_.is_border_edge(e) &&
                    tags_->angle(level_.face(2 * e), level_.face(2 * e + 1)) > radians(30.1);
    const std::vector<double> limit = largest_around(
      heights_.linear(by_angle, std::vector<bool>(level_.number_of_vertices(), false)).height);
    constexpr int most = 3;
    for (int k = 0;; ++k) {
      linear_ = heights_.linear(is_crease_, is_corner_);
      if (k + 1 == most) return;
      std::vector<std::size_t> harmful;
      for (Index f = 0; f < level_.number_of_faces(); ++f)
        if (linear_.height[f] > 1.5 * limit[f] + 10 * part_.tolerance)
          for_each_corner_around(f, [&](Index h) {
            if (meets_unknown(h)) harmful.push_back(patch_[level_.face(h)]);
          });
      if (!give_up(harmful)) return;
      set_tags();
    }
  }
  // whether the face of a half-edge is of a small segment and meets something unknown smoothly there
  bool meets_unknown(Index h) const
  {
    const Index o = Level_connectivity::opposite(h), f = level_.face(h);
    if (level_.is_border(o) || !is_known(f) || is_known(level_.face(o))) return false;
    const std::size_t few = level_.uniform_degree() == 3 ? 24 : 12;
    return surfaces_[patch_[f]].number_of_faces < few &&
           tags_->angle(f, level_.face(o)) <= radians(30);
  }
  bool give_up(const std::vector<std::size_t>& segments)
  {
    bool has_changed = false;
    for (const std::size_t s : segments) {
      if (surfaces_[s].kind == Kind::unknown) continue;
      Recognized_surface unknown;
      unknown.number_of_faces = surfaces_[s].number_of_faces;
      surfaces_[s] = unknown;
      ++result_.segments_given_up;
      has_changed = true;
    }
    return has_changed;
  }

  // Point-normal against linear, with the same tags.
  void check_normals()
  {
    constexpr int most = 5;
    for (int k = 0; k < most; ++k) {
      set_values();
      const Face_changes changes = heights_.point_normal(creases_, values_);
      volume_ = changes.volume;
      const std::vector<double> around = largest_around(linear_.height);
      high_.clear();
      for (Index f = 0; f < level_.number_of_faces(); ++f)
        if (is_worse(f, changes, around[f])) high_.push_back(f);
      const bool is_last = k + 1 == most || heights_.refinements() + 2 > most_refinements;
      if (high_.empty() || is_last || !mend(k)) return;
      if (has_other_tags_) linear_ = heights_.linear(is_crease_, is_corner_);
      has_other_tags_ = false;
    }
  }
  // whether there has been anything to do about what is high
  bool mend(int k)
  {
    bool has_changed = false;
    std::vector<std::size_t> bent;
    for (const Index f : high_) {
      if (set_back(f))
        has_changed = true;
      else if (surfaces_[patch_[f]].kind == Kind::plane &&
               surfaces_[patch_[f]].number_of_faces < 12)
        bent.push_back(patch_[f]);
    }
    const bool gives_up = !has_given_up_planes_ && give_up(bent);
    if (k >= 2 || (!has_changed && !gives_up))
      for (const Index f : high_)
        if (make_corners(f)) has_changed = true;
    if (gives_up) return set_back_after_giving_up();
    if (!has_changed)
      for (const Index f : high_)
        if (tags_->is_round(f) && set_back(f, true)) has_changed = true;
    return has_changed;
  }
  bool set_back_after_giving_up()
  {
    has_given_up_planes_ = true;
    for (const Index f : high_)
      if (!is_known(f)) set_back(f);
    set_tags();
    has_other_tags_ = true;
    return true;
  }
  bool is_worse(Index f, const Face_changes& changes, double linear_around) const
  {
    if (changes.is_folded[f] && !linear_.is_folded[f]) return true;
    const double margin = 10 * part_.tolerance;
    if (!is_known(f)) return changes.height[f] > 1.25 * linear_around + margin;
    if (tags_->is_round(f)) return changes.deviation[f] > 1.25 * linear_.deviation[f] + margin;
    return changes.height[f] > linear_.height[f] + margin;
  }
  // the wedges of an unknown face, the unknown ones round another one; as the last resort its own
  bool set_back(Index f, bool is_last_resort = false)
  {
    bool has_changed = false;
    const auto zero = [&](Index h) {
      if (is_zero_[h] || (is_known(level_.face(h)) && !is_last_resort)) return;
      is_zero_[h] = true;
      has_changed = true;
    };
    if (is_known(f) && !is_last_resort)
      for_each_corner_around(f, zero);
    else
      for_each_halfedge_of_face(level_, f, zero);
    return has_changed;
  }
  bool make_corners(Index f)
  {
    bool has_changed = false;
    for_each_halfedge_around(f, [&](Index h) {
      const Index v = level_.target(h);
      if (is_crease_[Level_connectivity::edge(h)] && !is_corner_[v])
        is_corner_[v] = has_other_tags_ = has_changed = true;
    });
    return has_changed;
  }

  // Normals and roundness of the slots: given by surfaces, or none, or estimated.
  void set_values()
  {
    const Index n = level_.number_of_vertices();
    creases_ = heights_.creases(is_crease_, is_corner_);
    values_.assign(creases_.number_of_slots, Value());
    const std::vector<Index> extra = vertices_of_extra_slots(creases_, n);
    for (Index slot = 0; slot < values_.size(); ++slot) {
      values_[slot].point = heights_.points()[slot < n ? slot : extra[slot - n]];
      values_[slot].normal = {0, 0, 0};
      values_[slot].roundness = 1;
    }
    std::vector<bool> is_given(values_.size(), false), is_zero(values_.size(), false);
    std::vector<Vec3> sum(values_.size());
    const Cut_level<double> cut(level_, creases_);
    for_each_corner(level_, cut.connectivity(), [&](Index h, Index slot) {
      const Vec3 normal = tags_->normal(h);
      if (is_zero_[h]) is_zero[slot] = true;
      if (is_known(level_.face(h)) || dot(normal, normal) > 0) is_given[slot] = true;
      sum[slot] += normal;
    });
    result_.wedges_set_back = 0;
    for (Index slot = 0; slot < values_.size(); ++slot) {
      if (is_zero[slot]) {
        is_given[slot] = true;
        ++result_.wedges_set_back;
      } else if (is_given[slot])
        values_[slot].normal = as_array(unit(sum[slot]));
    }
    Control_creases<double, Value>(level_, creases_, values_, is_given,
                                   Control_normal_estimate::coherent)();
    for (std::size_t i = 0; i < extra.size(); ++i)
      share_roundness(values_[extra[i]], values_[n + i]);
    set_tangents();
    corner_normal_.assign(level_.number_of_halfedges(), Vec3());
    for_each_corner(level_, cut.connectivity(), [&](Index h, Index slot) {
      corner_normal_[h] = as_vec3(values_[slot].normal);
    });
  }

  // Who refines takes all normals for given, the estimated ones, too, and has other tangents than while these are estimated.
  void set_tangents()
  {
    creases_ = heights_.creases(is_crease_, is_corner_);
    Control_creases<double, Value>(level_, creases_, values_,
                                   std::vector<bool>(values_.size(), true))();
  }

  const Level_connectivity& level_;
  const Part& part_;
  std::vector<Recognized_surface>& surfaces_;
  const std::vector<std::size_t>& patch_;
  double sharp_angle_;
  Refined_heights heights_;
  std::unique_ptr<Surface_tags> tags_;
  std::vector<bool> is_crease_, is_corner_, is_zero_; // zero: half-edges
  Creases<double> creases_;
  std::vector<Value> values_;
  std::vector<Vec3> corner_normal_;
  Face_changes linear_;
  std::vector<Index> high_;
  Surface_fallback result_;
  bool has_given_up_planes_ = false, has_other_tags_ = false; // than those of linear_
  double volume_ = 0;
};

} // namespace recognition
} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_RECOGNITION_LINEAR_GUARD_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_CHARTS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_CHARTS_H

#include <CGAL/PN_subdivision_3/attributes/Corner_rule.h>
#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/attributes/Chart_rules.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/creases/Cut_level.h>
#include <CGAL/PN_subdivision_3/internal/creases/make_creases.h>
#include <CGAL/PN_subdivision_3/schemes/with_border.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// What is sharp on a control level, beside seams; empty if nothing is.
struct Control_sharpness
{
  std::vector<double> edges, vertices;
  Border border = Border::surface;
};

// The charts of the values of corners: the level cut open at their seams and at its creases. An edge is a seam if
// the values of its two faces differ at one of its ends.
template <class FT>
class Charts
{
public:
  using Index = Level_connectivity::Index;
  static constexpr Index null = Level_connectivity::null;

  // are_equal(h, g): of the values of two corners, given by the half-edges that lead to them
  template <class Are_equal>
  Charts(const Level_connectivity& level, Corner_rule rule, const Control_sharpness& sharpness,
         const Are_equal& are_equal)
    : level_(level)
  {
    std::vector<bool> is_seam = find_seams(are_equal);
    const bool is_straight = rule == Corner_rule::boundaries;
    is_cut_ = has_seams() || (is_straight && level.has_border());
    if (is_cut_) {
      make_creases(is_seam, sharpness, is_straight);
      rules_ = Chart_rules(level, rule, std::move(is_seam));
      Find_kept_spans<FT, Are_equal>(level, creases_, are_equal)(rules_);
    } else if (rule != Corner_rule::none)
      find_kept_vertices();
  }

  bool has_seams() const { return first_seam_ != null; }
  Index first_seam() const { return first_seam_; }
  // whether the charts have creases and rules of their own
  bool is_cut() const { return is_cut_; }
  // \pre is_cut()
  Creases<FT>& creases() { return creases_; }
  Chart_rules& rules() { return rules_; }
  // border vertices with a single face, if those stay; charts that are cut have this in their rules
  const std::vector<Index>& kept_vertices() const { return kept_vertices_; }

  // for each slot, or for each vertex if nothing is cut, one of its corners or null
  std::vector<Index> corner_of_slots() const
  {
    std::vector<Index> corner(is_cut_ ? creases_.number_of_slots : level_.number_of_vertices(),
                              null);
    if (is_cut_)
      for_each_corner(level_, Cut_level<FT>(level_, creases_).connectivity(),
                      [&](Index h, Index slot) { corner[slot] = h; });
    else
      for (Index h = 0; h < level_.number_of_halfedges(); ++h)
        if (!level_.is_border(h)) corner[level_.target(h)] = h;
    return corner;
  }

private:
  template <class Are_equal>
  std::vector<bool> find_seams(const Are_equal& are_equal)
  {
    std::vector<bool> is_seam(level_.number_of_edges(), false);
    std::vector<Index> previous(level_.number_of_halfedges());
    for (Index h = 0; h < level_.number_of_halfedges(); ++h) previous[level_.next(h)] = h;
    for (Index e = 0; e < level_.number_of_edges(); ++e) {
      if (level_.is_border_edge(e)) continue;
      const Index h = 2 * e, o = 2 * e + 1;
      if (are_equal(h, previous[o]) && are_equal(previous[h], o)) continue;
      is_seam[e] = true;
      if (first_seam_ == null) first_seam_ = e;
    }
    return is_seam;
  }

  // the rules of charts need the border among the creases; its rows are the same
  void make_creases(const std::vector<bool>& is_seam, const Control_sharpness& sharpness,
                    bool is_straight)
  {
    const Border border = is_straight                           ? Border::fixed
                          : sharpness.border == Border::surface ? Border::curve
                                                                : sharpness.border;
    creases_ = Make_creases<FT>(level_, border)(
      [&](Index e) {
        if (is_seam[e]) return infinite_sharpness;
        return sharpness.edges.empty() ? 0 : sharpness.edges[e];
      },
      [&](Index v) { return sharpness.vertices.empty() ? 0 : sharpness.vertices[v]; });
  }

  void find_kept_vertices()
  {
    if (!level_.has_border()) return;
    for (Index v = 0; v < level_.number_of_vertices(); ++v)
      if (!level_.is_isolated(v) && level_.is_border_vertex(v) && level_.valence(v) == 2)
        kept_vertices_.push_back(v);
  }

  const Level_connectivity& level_; // during the construction and corner_of_slots() only
  Index first_seam_ = null;
  bool is_cut_ = false;
  Creases<FT> creases_;
  Chart_rules rules_;
  std::vector<Index> kept_vertices_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_CHARTS_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_CHARTS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_CHARTS_H

#include <CGAL/PN_subdivision_3/attributes/Attribute_traits.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/creases/Cut_level.h>
#include <CGAL/PN_subdivision_3/internal/creases/make_creases.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/schemes/scheme_of_call.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// The wedges of a star between two bounds of charts, by the positions of the ends there, clockwise; both
// are the same one where a seam ends.
struct Chart_span
{
  using Index = Level_connectivity::Index;

  Index first, last;
};

// The rules of vertices where charts have bounds: seams, and the border. They need border edges to be
// creases. The spans that stay are found on the control level, see Find_kept_spans, and kept by the half-edges that
// begin spans at their vertices; parts of these half-edges on refined levels have the same side.
class Chart_rules
{
public:
  using Index = Level_connectivity::Index;

  Chart_rules() = default;
  Chart_rules(const Level_connectivity& control, Corner_rule rule, std::vector<bool> is_seam)
    : rule_(rule)
    , is_seam_(std::move(is_seam))
    , is_kept_(control.number_of_halfedges(), false)
  {}

  Corner_rule corner_rule() const { return rule_; }
  bool has_straight_bounds() const { return rule_ == Corner_rule::boundaries; }
  // at a vertex with two charts both are smooth, or none is
  bool are_charts_alike() const
  {
    return rule_ == Corner_rule::corners_plus1 || rule_ == Corner_rule::corners_plus2;
  }

  template <class FT>
  bool is_seam(const Crease_edge<FT>& e) const
  {
    return is_seam_[e.control_edge];
  }
  template <class FT>
  bool is_bound(const Crease_edge<FT>& e) const
  {
    return e.is_border() || is_seam(e);
  }
  template <class FT>
  bool is_on_seam(const Creases<FT>& creases, const Crease_star& star) const
  {
    for (const Crease_halfedge& e : creases.ends_of(star))
      if (is_seam(creases.edge(e))) return true;
    return false;
  }

  // \pre the star has bounds, and the wedge begins at the end of its number
  template <class FT>
  Chart_span span(const Creases<FT>& creases, const Crease_star& star, Index wedge) const
  {
    const Index k = star.number_of_ends;
    const auto is_bound_at = [&](Index i) { return is_bound(creases.edge(creases.end(star, i))); };
    Chart_span result{wedge, (wedge + 1) % k};
    while (!is_bound_at(result.first)) result.first = (result.first + k - 1) % k;
    while (!is_bound_at(result.last)) result.last = (result.last + 1) % k;
    return result;
  }

  // the rule of a span at a vertex on a seam. remains(end): whether an edge is sharp
  template <class FT, class Remains>
  Vertex_rule rule(const Creases<FT>& creases, const Crease_star& star, const Chart_span& span,
                   double sharpness, const Remains& remains) const
  {
    if (sharpness > 0 || has_straight_bounds() || is_kept(creases, star, span.first))
      return Vertex_rule::corner;
    const Index k = star.number_of_ends;
    const Index first = are_charts_alike() ? 0 : (span.first + 1) % k;
    const Index end = are_charts_alike() ? k : first + (span.last + k - first) % k;
    for (Index i = first; i < end; ++i) {
      const Crease_halfedge& e = creases.end(star, i % k);
      if (!is_bound(creases.edge(e)) && remains(e)) return Vertex_rule::corner;
    }
    return Vertex_rule::crease;
  }

  // whether the span that begins at an end stays, whatever its sharp edges
  template <class FT>
  bool is_kept(const Creases<FT>& creases, const Crease_star& star, Index end) const
  {
    return !is_inside_edge(creases, star) && is_kept_[control_halfedge(creases, star, end)];
  }
  template <class FT>
  void keep(const Creases<FT>& creases, const Crease_star& star, Index end)
  {
    is_kept_[control_halfedge(creases, star, end)] = true;
  }

private:
  // whether both ends are on one control edge
  template <class FT>
  static bool is_inside_edge(const Creases<FT>& creases, const Crease_star& star)
  {
    return star.number_of_ends == 2 && creases.edge(creases.end(star, 0)).control_edge ==
                                         creases.edge(creases.end(star, 1)).control_edge;
  }
  template <class FT>
  static std::size_t control_halfedge(const Creases<FT>& creases, const Crease_star& star,
                                      Index end)
  {
    const Crease_halfedge& e = creases.end(star, end);
    return 2 * std::size_t(creases.edge(e).control_edge) + e.side;
  }

  Corner_rule rule_ = Corner_rule::corners_plus1;
  std::vector<bool> is_seam_; // by control edges
  std::vector<bool> is_kept_; // by control half-edges
};

// of the values of two corners, given by the half-edges that lead to them
using Are_values_equal = Function_ref<bool(Level_connectivity::Index, Level_connectivity::Index)>;

// Finds out on a control level what spans stay.
template <class FT>
class Find_kept_spans
{
public:
  using Index = Level_connectivity::Index;

  Find_kept_spans(const Level_connectivity& level, const Creases<FT>& creases,
                  Are_values_equal are_equal)
    : level_(level)
    , creases_(creases)
    , are_equal_(are_equal)
  {}

  void operator()(Chart_rules& rules)
  {
    if (rules.has_straight_bounds()) return;
    const Corner_rule rule = rules.corner_rule();
    for (const Crease_star& star : creases_.stars) {
      if (rules.is_on_seam(creases_, star)) {
        find_spans(rules, star);
        const bool are_all_kept = are_all(rules, star);
        for (const Span& s : spans_)
          if (are_all_kept || is_sharp(s, rule) || is_apart(s)) rules.keep(creases_, star, s.first);
      } else if (star.is_border && rule != Corner_rule::none && level_.valence(star.vertex) == 2)
        rules.keep(creases_, star, 0);
    }
  }

private:
  struct Span : Chart_span
  {
    Index corner; // one of its half-edges
    std::size_t number_of_faces;
    bool has_sharp_edge;
  };

  void find_spans(const Chart_rules& rules, const Crease_star& star)
  {
    spans_.clear();
    for (Index i = 0; i < star.number_of_ends; ++i) {
      const Crease_halfedge& e = creases_.end(star, i);
      if (!rules.is_bound(creases_.edge(e)) || !creases_.edge(e).has_after(e.side)) continue;
      const Chart_span bounds = rules.span(creases_, star, i);
      spans_.push_back({bounds, creases_.halfedge(e), number_of_faces(star, bounds),
                        has_sharp_edge(star, bounds)});
    }
  }
  std::size_t number_of_faces(const Crease_star& star, const Chart_span& bounds) const
  {
    const Index last = creases_.halfedge(creases_.end(star, bounds.last));
    std::size_t result = 0;
    Index h = creases_.halfedge(creases_.end(star, bounds.first));
    do {
      ++result;
      h = level_.next_around_target(h);
    } while (h != last && !level_.is_border(h));
    return result;
  }
  bool has_sharp_edge(const Crease_star& star, const Chart_span& bounds) const
  {
    const Index k = star.number_of_ends;
    for (Index i = (bounds.first + 1) % k; i != bounds.last; i = (i + 1) % k)
      if (creases_.edge(creases_.end(star, i)).sharpness == infinite_sharpness) return true;
    return false;
  }

  static bool is_corner(const Span& s) { return s.number_of_faces == 1; }
  static bool is_sharp(const Span& s, Corner_rule rule)
  {
    return s.has_sharp_edge || (rule != Corner_rule::none && is_corner(s));
  }
  // whether the chart has another span at the vertex
  bool is_apart(const Span& s) const
  {
    for (const Span& other : spans_)
      if (&other != &s && are_equal_(other.corner, s.corner)) return true;
    return false;
  }
  bool are_all(const Chart_rules& rules, const Crease_star& star) const
  {
    if (!rules.are_charts_alike()) return false;
    if (spans_.size() > 2) return true;
    const bool keeps_more = rules.corner_rule() == Corner_rule::corners_plus2;
    if (keeps_more && spans_.size() == 1 && !star.is_border) return true;
    for (const Span& s : spans_)
      if (s.has_sharp_edge || (keeps_more && is_corner(s))) return true;
    return false;
  }

  const Level_connectivity& level_;
  const Creases<FT>& creases_;
  const Are_values_equal are_equal_;
  std::vector<Span> spans_;
};

// The charts of the values of corners: the level cut open at their seams and at its creases. An edge is a seam if
// the values of its two faces differ at one of its ends.
template <class FT>
class Charts
{
public:
  using Index = Level_connectivity::Index;
  static constexpr Index null = Level_connectivity::null;

  Charts(const Level_connectivity& level, Corner_rule rule, const Control_sharpness& sharpness,
         Are_values_equal are_equal)
    : level_(level)
  {
    std::vector<bool> is_seam = find_seams(are_equal);
    const bool is_straight = rule == Corner_rule::boundaries;
    is_cut_ = has_seams() || (is_straight && level.has_border());
    if (is_cut_) {
      make_creases(is_seam, sharpness, is_straight);
      rules_ = Chart_rules(level, rule, std::move(is_seam));
      Find_kept_spans<FT>(level, creases_, are_equal)(rules_);
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
  // border vertices with a single face, if corners stay; charts that are cut have this in their rules
  const std::vector<Index>& kept_vertices() const { return kept_vertices_; }

  // for each slot, or for each vertex if nothing is cut, one of its corners or null
  std::vector<Index> corner_of_slots() const
  {
    std::vector<Index> corner(is_cut_ ? creases_.number_of_slots : level_.number_of_vertices(),
                              null);
    if (is_cut_)
      for_each_corner(level_, Cut_copy<FT>(level_, creases_).connectivity(),
                      [&](Index h, Index slot) { corner[slot] = h; });
    else
      for (Index h = 0; h < level_.number_of_halfedges(); ++h)
        if (!level_.is_border(h)) corner[level_.target(h)] = h;
    return corner;
  }

private:
  std::vector<bool> find_seams(Are_values_equal are_equal)
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

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_CHARTS_H

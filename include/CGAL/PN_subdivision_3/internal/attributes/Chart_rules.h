// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_CHART_RULES_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_CHART_RULES_H

#include <CGAL/PN_subdivision_3/attributes/Corner_rule.h>
#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The wedges of a star between two bounds of charts, by the positions of the ends there, clockwise; both
// are the same one where a seam ends.
struct Chart_span
{
  using Index = Level_connectivity::Index;

  Index first, last;
};

// The rules of vertices where charts have bounds: seams, and the border. They need border edges to be
// creases. What stays is found out on the control level, see Find_kept_spans, and kept by the half-edges that begin
// spans at their vertices; parts of these on refined levels have their side.
class Chart_rules
{
public:
  using Index = Level_connectivity::Index;

  Chart_rules() = default;
  Chart_rules(const Level_connectivity& control, Corner_rule rule, std::vector<bool> is_seam)
    : rule_(rule)
    , is_seam_(std::move(is_seam))
    , is_kept_(control.number_of_halfedges(), false)
    , number_of_control_vertices_(control.number_of_vertices())
  {}

  Corner_rule corner_rule() const { return rule_; }
  bool has_straight_bounds() const { return rule_ == Corner_rule::boundaries; }
  // of two charts at a vertex, both are smooth or none
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
    for (Index i = 0; i < star.number_of_ends; ++i)
      if (is_seam(creases.edge(creases.end(star, i)))) return true;
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
      const Crease_end& e = creases.end(star, i % k);
      if (!is_bound(creases.edge(e)) && remains(e)) return Vertex_rule::corner;
    }
    return Vertex_rule::crease;
  }

  // whether the span that begins at an end stays, whatever its sharp edges
  template <class FT>
  bool is_kept(const Creases<FT>& creases, const Crease_star& star, Index end) const
  {
    return star.vertex < number_of_control_vertices_ &&
           is_kept_[control_halfedge(creases, star, end)];
  }
  template <class FT>
  void keep(const Creases<FT>& creases, const Crease_star& star, Index end)
  {
    is_kept_[control_halfedge(creases, star, end)] = true;
  }

private:
  template <class FT>
  static std::size_t control_halfedge(const Creases<FT>& creases, const Crease_star& star,
                                      Index end)
  {
    const Crease_end& e = creases.end(star, end);
    return 2 * std::size_t(creases.edge(e).control_edge) + e.side;
  }

  Corner_rule rule_ = Corner_rule::corners_plus1;
  std::vector<bool> is_seam_; // by control edges
  std::vector<bool> is_kept_; // by control half-edges
  Index number_of_control_vertices_ = 0;
};

// Finds out on a control level what spans stay.
template <class FT, class Are_equal>
class Find_kept_spans
{
public:
  using Index = Level_connectivity::Index;

  // are_equal(h, g): of the values of two corners, given by the half-edges that lead to them
  Find_kept_spans(const Level_connectivity& level, const Creases<FT>& creases,
                  const Are_equal& are_equal)
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
      const Crease_end& e = creases_.end(star, i);
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
  const Are_equal& are_equal_;
  std::vector<Span> spans_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_CHART_RULES_H

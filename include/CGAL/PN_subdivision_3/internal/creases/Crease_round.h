// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_CREASE_ROUND_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_CREASE_ROUND_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/creases/Crease_pass.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/creases/Cut_level.h>
#include <CGAL/PN_subdivision_3/internal/creases/soften_normals.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Round.h>
#include <CGAL/PN_subdivision_3/internal/refinement/for_chunks.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// One round of a scheme on a level with creases.
//
// The mask is that of the level cut open, so that rows far from creases and beside them are those of
// an ordinary round, over slots. What they give for new vertices on creases is replaced by the values
// of the crease pass, which has those of all their slots.
template <class Scheme, class Average>
class Crease_round
{
public:
  using One_round = Round<Scheme, Average>;
  using FT = typename Average::FT;
  using Index = Level_connectivity::Index;
  using Value = typename Average::Value;
  using Stored_value = typename One_round::Stored_value;
  using Slot_value = std::pair<Index, Value>;

  // `old` has the values of the slots; it is changed where normals are read softened
  Crease_round(const Scheme& scheme, Level_connectivity& level, const Creases<FT>& creases,
               Stored_value* old, unsigned number)
    : scheme_(scheme)
    , level_(level)
    , creases_(creases)
    , old_(old)
    , cut_(level, creases)
    , round_(scheme, level, cut_.connectivity(), number)
    , refined_(creases, level, number_of_vertices())
  {
    if (needs_smooth_rules()) {
      count_valences();
      smooth_round_.emplace(scheme, level, number);
    }
    if constexpr (!Is_linear<Scheme>::value) soften();
  }

  Crease_round(const Crease_round&) = delete;
  Crease_round& operator=(const Crease_round&) = delete;

  // of all new vertices; values on creases do not hold
  const One_round& round() const { return round_; }
  Index number_of_vertices() const { return static_cast<Index>(round_.refined_size().vertices); }

  // what the rows are made of: the level cut open, and the uncut one's round if some rule needs it
  const Cut_level<FT>& cut() const { return cut_; }
  const One_round* smooth_round() const { return smooth_round_ ? &*smooth_round_ : nullptr; }
  const Refined_creases<FT>& refined() const { return refined_; }

  // the values on the creases, for each of their slots
  std::vector<Slot_value> crease_values(const For_chunks& for_chunks)
  {
    const typename Crease_pass<Scheme, Average>::Data data{
      scheme_,  level_,         cut_.connectivity(),
      creases_, round_,         smooth_round_ ? &*smooth_round_ : nullptr,
      old_,     stored_normals_};
    return Crease_pass<Scheme, Average>(data, refined_)(for_chunks);
  }

  // those of the refined level, once their tangents have been made by crease_values()
  Creases<FT>& refined_creases() { return refined_.creases; }

private:
  bool needs_smooth_rules() const
  {
    const auto is_smooth = [](Vertex_rule r) {
      return r == Vertex_rule::smooth || r == Vertex_rule::dart;
    };
    for (std::size_t i = 0; i < creases_.stars.size(); ++i) {
      const Index child = refined_.star[i];
      if (is_smooth(creases_.rule(creases_.stars[i]))) return true;
      if (child == Level_connectivity::null ||
          is_smooth(refined_.creases.rule(refined_.creases.stars[child])))
        return true;
    }
    return std::any_of(creases_.edges.begin(), creases_.edges.end(),
                       [](const Crease_edge<FT>& e) { return e.sharpness < 1; });
  }

  // crease vertices and corners are not extraordinary, darts count but have no rules of their own
  void count_valences()
  {
    std::vector<Level_connectivity::Counted_valence> counted;
    for (const Crease_star& star : creases_.stars) {
      const bool is_dart = !star.is_border && creases_.rule(star) == Vertex_rule::dart;
      counted.push_back({star.vertex, is_dart ? level_.valence(star.vertex) : 0});
    }
    level_.set_counted_valences(std::move(counted));
  }

  void soften()
  {
    for (const Crease_star& star : creases_.stars)
      if (is_softened(creases_, star))
        for (Index w = 0; w < star.number_of_wedges; ++w)
          stored_normals_.emplace_back(star.slot(w), Value(old_[star.slot(w)]).normal);
    if (stored_normals_.empty()) return;
    for (const Crease_star& star : creases_.stars)
      if (is_softened(creases_, star))
        soften_normals(
          creases_, star, [&](Index slot) { return Value(old_[slot]).normal; },
          [&](Index slot, const Coordinates<FT, 3>& n) {
            Value value = old_[slot];
            value.normal = n;
            old_[slot] = value;
          });
    std::sort(stored_normals_.begin(), stored_normals_.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
  }

  const Scheme& scheme_;
  Level_connectivity& level_;
  const Creases<FT>& creases_;
  Stored_value* old_;
  Cut_level<FT> cut_;
  One_round round_;
  Refined_creases<FT> refined_;
  std::optional<One_round> smooth_round_;
  std::vector<std::pair<Index, Coordinates<FT, 3>>> stored_normals_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_CREASE_ROUND_H

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
#include <CGAL/PN_subdivision_3/internal/creases/Smooth_rows.h>
#include <CGAL/PN_subdivision_3/internal/creases/join_wedges.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Round.h>
#include <CGAL/PN_subdivision_3/internal/refinement/for_chunks.h>

#include <algorithm>
#include <optional>
#include <type_traits>
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
//
// Where nothing can be sharp it is an ordinary round, see Round.h.
template <class Scheme, class Average, class Level_creases>
class Crease_round
{
public:
  using One_round = Round<Scheme, Average>;
  using FT = typename Average::FT;
  using Index = Level_connectivity::Index;
  using Value = typename Average::Value;
  using Stored_value = typename One_round::Stored_value;
  using Slot_value = std::pair<Index, Value>;

  // `old` has the values of the slots; it is changed where normals are read softened. The level is cut
  // open until close() is called.
  Crease_round(const Scheme& scheme, Level_connectivity& level, const Creases<FT>& creases,
               Stored_value* old, unsigned number)
    : Crease_round(scheme, level, creases, number)
  {
    read(old);
  }
  // without values, until read() is called
  Crease_round(const Scheme& scheme, Level_connectivity& level, const Creases<FT>& creases,
               unsigned number)
    : scheme_(scheme)
    , level_(level)
    , creases_(creases)
    , refined_size_(Host::refined_size(level.size(), number))
    , refined_(creases, level, number_of_vertices())
  {
    if (needs_smooth_rules()) make_smooth_rows(number);
    round_.emplace(scheme, level, number, [&] { cut_.emplace(level, creases); });
    if constexpr (!std::is_floating_point_v<FT>)
      round_->set_vertices_of_others(vertices_on_creases());
  }

  Crease_round(const Crease_round&) = delete;
  Crease_round& operator=(const Crease_round&) = delete;

  // the values of the slots; changed where normals are read softened
  void read(Stored_value* old)
  {
    old_ = old;
    stored_normals_.clear();
    if constexpr (!Is_linear<Scheme>::value) soften();
  }
  // makes them again what they were
  void put_back_softened()
  {
    if constexpr (!Is_linear<Scheme>::value)
      for (const auto& [slot, normal] : stored_normals_) put_normal(slot, normal);
    stored_normals_.clear();
  }
  // calls f(slot) for the slots whose normals are read softened
  template <class Function>
  void for_each_softened(const Function& f) const
  {
    for (const auto& stored : stored_normals_) f(stored.first);
  }

  // of all new vertices; values on creases do not hold
  const One_round& round() const { return *round_; }
  Index number_of_vertices() const { return static_cast<Index>(refined_size_.vertices); }

  const Refined_creases<FT>& refined() const { return refined_; }

  bool needs_smooth_rules() const
  {
    return std::any_of(creases_.stars.begin(), creases_.stars.end(),
                       [this](const Crease_star& s) { return has_smooth_rule(s); }) ||
           std::any_of(creases_.edges.begin(), creases_.edges.end(),
                       [](const Crease_edge<FT>& e) { return e.sharpness < 1; });
  }
  // the values on the creases, for each of their slots
  std::vector<Slot_value> crease_values(const For_chunks& for_chunks)
  {
    const auto pointer = [](const auto& rows) { return rows ? &*rows : nullptr; };
    const typename Crease_pass<Scheme, Average>::Data data{scheme_,
                                                           level_,
                                                           creases_,
                                                           *round_,
                                                           pointer(smooth_rows_),
                                                           pointer(smooth_normal_rows_),
                                                           old_,
                                                           stored_normals_};
    return Crease_pass<Scheme, Average>(data, refined_)(for_chunks);
  }

  // makes the level whole again; to be called before a host connects the child
  void close() { cut_->close(); }

  // those of the refined level, once their tangents have been made by crease_values()
  Creases<FT>& refined_creases() { return refined_.creases; }

  // the new vertices that crease_values() has values for, in increasing order
  std::vector<Index> vertices_on_creases() const
  {
    std::vector<Index> vertices;
    for (const Crease_star& star : creases_.stars) vertices.push_back(star.vertex);
    for (const Crease_edge<FT>& e : creases_.edges)
      vertices.push_back(round_->host().vertex_of_edge(e.edge));
    return vertices;
  }

private:
  using Host = typename Scheme::Host;

  static bool is_smooth(Vertex_rule r)
  {
    return r == Vertex_rule::smooth || r == Vertex_rule::dart;
  }

  // before the round or after it
  bool has_smooth_rule(const Crease_star& star) const
  {
    const Index child = refined_.star[std::size_t(&star - creases_.stars.data())];
    return is_smooth(creases_.rule(star)) || child == Level_connectivity::null ||
           is_smooth(refined_.creases.rule(refined_.creases.stars[child]));
  }

  // from the mask of the whole level
  void make_smooth_rows(unsigned number)
  {
    count_valences(level_, creases_);
    const One_round smooth(scheme_, level_, number);
    const Corner_slots<FT> slots(level_, creases_);
    const auto needs_row = [this](const Crease_star& s) { return has_smooth_rule(s); };
    smooth_rows_.emplace(level_, creases_, slots, smooth.mask(), needs_row);
    if constexpr (Has_normal_mask<Scheme>::value)
      smooth_normal_rows_.emplace(level_, creases_, slots, smooth.normal_mask(), needs_row);
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
          [&](Index slot, const Coordinates<FT, 3>& n) { put_normal(slot, n); });
    std::sort(stored_normals_.begin(), stored_normals_.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
  }

  void put_normal(Index slot, const Coordinates<FT, 3>& n)
  {
    Value value = old_[slot];
    value.normal = n;
    old_[slot] = value;
  }

  const Scheme& scheme_;
  Level_connectivity& level_;
  const Creases<FT>& creases_;
  Stored_value* old_ = nullptr;
  const Level_size refined_size_;
  Refined_creases<FT> refined_;
  std::optional<Smooth_rows<FT>> smooth_rows_, smooth_normal_rows_;
  std::optional<Level_cut<FT>> cut_;
  std::optional<One_round> round_;
  std::vector<std::pair<Index, Coordinates<FT, 3>>> stored_normals_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_CREASE_ROUND_H

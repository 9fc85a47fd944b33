// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_CREASE_REFINER_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_CREASE_REFINER_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/creases/Crease_round.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/creases/Cut_level.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Level_refiner.h>
#include <CGAL/PN_subdivision_3/internal/refinement/for_chunks.h>

#include <utility>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// A level with creases, the values of its slots, and the rounds of a scheme on them. It knows neither
// a mesh nor its maps.
template <class Scheme, class Average>
class Crease_refiner
{
public:
  using Refiner = Level_refiner<Scheme, Average>;
  using One_round = Crease_round<Scheme, Average>;
  using FT = typename Average::FT;
  using Index = Level_connectivity::Index;
  using Values = typename Refiner::Values;

  // level, creases and values are those of the first round that is not done
  Crease_refiner(const Scheme& scheme, Level_connectivity&& level, Creases<FT>&& creases,
                 Values&& values, const For_chunks& for_chunks = For_chunks(),
                 unsigned rounds_done = 0)
    : scheme_(scheme)
    , refiner_(scheme, std::move(level), std::move(values), for_chunks, rounds_done)
    , creases_(std::move(creases))
    , for_chunks_(for_chunks)
  {}

  const Level_connectivity& level() const { return refiner_.level(); }
  const Creases<FT>& creases() const { return creases_; }
  // of the slots
  const Values& values() const { return refiner_.values(); }
  const Refiner& refiner() const { return refiner_; }
  // once nothing is evaluated any more
  void release_values() { refiner_.release_values(); }

  // \pre the level stays while the round is used
  One_round next_round()
  {
    return {scheme_, refiner_.level(), creases_, refiner_.values().data(),
            refiner_.rounds_done() + 1};
  }

  void refine()
  {
    One_round round = next_round();
    refine(round);
  }
  void refine(One_round& round, const typename Refiner::Rows_sink* rows_sink = nullptr,
              const typename Refiner::Child_sink* child_sink = nullptr)
  {
    const auto on_creases = round.crease_values(for_chunks_);
    Creases<FT> creases = std::move(round.refined_creases());
    Values values = refiner_.refined_values(round.round(), creases.number_of_slots, rows_sink);
    for (const auto& slot : on_creases) values[slot.first] = slot.second;
    round.close();
    const Level_size room = Level_cut<FT>::size(round.round().refined_size(), creases);
    refiner_.replace(round.round(), room, std::move(values), child_sink);
    creases_ = std::move(creases);
  }

private:
  const Scheme& scheme_;
  Refiner refiner_;
  Creases<FT> creases_;
  For_chunks for_chunks_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_CREASE_REFINER_H

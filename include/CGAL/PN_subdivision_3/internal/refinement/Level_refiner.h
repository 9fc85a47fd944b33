// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_REFINEMENT_LEVEL_REFINER_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_REFINEMENT_LEVEL_REFINER_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Caller_precision.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Function_ref.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Round.h>
#include <CGAL/PN_subdivision_3/internal/refinement/for_chunks.h>

#include <boost/container/vector.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// A level, the values of its vertices, and the rounds of a scheme on them. It knows neither a mesh
// nor its maps.
//
// refine() replaces the level by its child. A round that is not to be stored is a next_round():
// its values go to a sink, its connectivity to any child of a host. Where the rows are made on
// another level than the child (cut open along creases, say), every level has more values than
// vertices: those beyond the vertices are the caller's to set.
template <class Scheme, class Average>
class Level_refiner
{
public:
  using Index = Level_connectivity::Index;
  using One_round = Round<Scheme, Average>;
  using Value = typename One_round::Value;
  using Sink = typename One_round::Sink;
  using List_sink = typename One_round::List_sink;
  using Transfers = typename One_round::Transfers;
  using Rows_sink = typename One_round::Rows_sink;
  // takes the child of a level, which is still there
  using Child_sink = Function_ref<void(const Level_connectivity&)>;
  using Stored_value = typename One_round::Stored_value;
  using Values = boost::container::vector<Stored_value>;

  // Level and values are those of the first round that is not done.
  Level_refiner(const Scheme& scheme, Level_connectivity&& level, Values&& values,
                const For_chunks& for_chunks = For_chunks(), unsigned rounds_done = 0)
    : scheme_(scheme)
    , level_(std::move(level))
    , values_(std::move(values))
    , rounds_done_(rounds_done)
    , for_chunks_(for_chunks)
  {}

  const Level_connectivity& level() const { return level_; }
  Level_connectivity& level() { return level_; }
  const Values& values() const { return values_; }
  Values& values() { return values_; }
  // once nothing is evaluated any more
  void release_values() { Values().swap(values_); }
  unsigned rounds_done() const { return rounds_done_; }

  // \pre the level stays while the round is used
  One_round next_round() const { return {scheme_, level_, rounds_done_ + 1}; }

  void refine() { refine(next_round()); }
  void refine(const One_round& round, const Rows_sink* rows_sink = nullptr,
              const Child_sink* child_sink = nullptr)
  {
    Values values = refined_values(round, round.refined_size().vertices, rows_sink);
    replace(round, round.refined_size(), std::move(values), child_sink);
  }

  // the first ones are those of the new vertices
  Values refined_values(const One_round& round, std::size_t number_of_values,
                        const Rows_sink* rows_sink = nullptr) const
  {
    Values refined(number_of_values, boost::container::default_init);
    evaluate(
      round, transfers(round), 0, static_cast<Index>(round.refined_size().vertices),
      [&](Index first, const Value* values, Index number) {
        std::copy(values, values + number, refined.begin() + first);
      },
      rows_sink);
    return refined;
  }

  // the child, with room for further elements, and its values take the place of the level
  void replace(const One_round& round, const Level_size& room, Values&& values,
               const Child_sink* child_sink = nullptr)
  {
    Level_connectivity child(round.refined_size(), room);
    child.set_uniform_degree(Scheme::Host::refined_degree);
    connect(round, child);
    if (child_sink != nullptr) (*child_sink)(child);
    level_ = std::move(child);
    values_ = std::move(values);
    ++rounds_done_;
  }

  // to be found once for each round
  Transfers transfers(const One_round& round) const
  {
    return round.transfers(values_.data(), for_chunks_);
  }

  // The new vertices [begin, end) of a round. The sink gets a few neighboring ones with every call,
  // which come from several threads if for_chunks does.
  void evaluate(const One_round& round, const Transfers& transfers, Index begin, Index end,
                Sink sink, const Rows_sink* rows_sink = nullptr) const
  {
    const Precision precision;
    for_chunks_(end - begin, [&](Index first, Index last) {
      const typename Precision::In_this_thread scope(precision);
      round.evaluate(begin + first, begin + last, values_.data(), transfers, sink, rows_sink);
    });
  }

  // Only the new vertices that are listed, as their rows have them, without transfers.
  void evaluate(const One_round& round, const Index* vertices, Index number, List_sink sink) const
  {
    const Precision precision;
    for_chunks_(number, [&](Index first, Index last) {
      const typename Precision::In_this_thread scope(precision);
      round.evaluate(vertices + first, vertices + last, values_.data(), sink);
    });
  }

  template <class Child>
  void connect(const One_round& round, Child& child) const
  {
    round.host().connect(child, for_chunks_);
  }

private:
  using Precision = Caller_precision<typename Average::FT>;

  const Scheme& scheme_;
  Level_connectivity level_;
  Values values_;
  unsigned rounds_done_;
  For_chunks for_chunks_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_REFINEMENT_LEVEL_REFINER_H

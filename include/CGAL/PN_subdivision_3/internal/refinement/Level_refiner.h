// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_REFINEMENT_LEVEL_REFINER_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_REFINEMENT_LEVEL_REFINER_H

#include <CGAL/PN_subdivision_3/internal/creases/Crease_round.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/creases/Cut_level.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/rounds/Round.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <boost/container/vector.hpp>

#include <algorithm>
#include <utility>

namespace CGAL::PN_subdivision_3::internal {

// The child that a host makes of its level: of this size, with room for what a cut adds to it.
template <class Host>
Level_connectivity child_level(const Host& host, const Level_size& size, const Level_size& room,
                               const For_chunks& for_chunks)
{
  Level_connectivity child(size, room);
  child.set_uniform_degree(Host::refined_degree);
  host.connect(child, for_chunks);
  return child;
}

// the child of the level of a round
template <class Round>
Level_connectivity child_level(const Round& round, const For_chunks& for_chunks)
{
  return child_level(round.host(), round.refined_size(), round.refined_size(), for_chunks);
}

// the child of a level in the round of this number, without a Round
template <class Host>
Level_connectivity child_level(const Level_connectivity& level, unsigned round,
                               const For_chunks& for_chunks)
{
  const Level_size size = Host::refined_size(level.size(), round);
  return child_level(Host(level, round), size, size, for_chunks);
}

// the child of the level of a round, with room to be cut open
template <class Level_round, class Level_creases>
Level_connectivity child_level(const Level_round& round, const Level_creases& creases,
                               const For_chunks& for_chunks)
{
  const Level_size& size = round.round().refined_size();
  return child_level(round.round().host(), size, size_when_cut(size, creases), for_chunks);
}

// Evaluates a round on a level with creases into the slots of the refined one; makes the level whole again.
template <class Level_round, class Value, class Refined_values>
void evaluate_round(Level_round& round, const Value* old, const For_chunks& for_chunks,
                    Refined_values& refined,
                    const typename Level_round::Plain_round::Rows_sink* rows_sink = nullptr)
{
  using Plain_round = typename Level_round::Plain_round;
  using Index = typename Plain_round::Index;
  const auto on_creases = round.crease_values(for_chunks);
  const Plain_round& rows = round.round();
  evaluate_rows(
    rows, 0, round.number_of_vertices(), old, rows.transfers(old, for_chunks), for_chunks,
    [&](Index first, const typename Plain_round::Value* values, Index number) {
      std::copy(values, values + number, refined.begin() + static_cast<std::ptrdiff_t>(first));
    },
    rows_sink);
  for (const auto& [slot, value] : on_creases) refined[slot] = value;
  round.close();
}

// A level with its creases, the values of its slots, which are its vertices if there are no creases, and the
// rounds of a scheme on them. It knows neither a mesh nor its maps.
//
// refine() replaces the level by its child. A round that is not to be stored is a next_round():
// its values go to a sink, its connectivity to any child of a host. What is defined behind the class may be compiled once.
template <class Scheme, class Average, class Level_creases = No_creases>
class Level_refiner
{
public:
  using Index = Level_connectivity::Index;
  using Level_round = Crease_round<Scheme, Average, Level_creases>;
  using Plain_round = Round<Scheme, Average>;
  using Value = typename Plain_round::Value;
  using Sink = typename Plain_round::Sink;
  using List_sink = typename Plain_round::List_sink;
  using Transfers = typename Plain_round::Transfers;
  using Rows_sink = typename Plain_round::Rows_sink;
  // takes the child of a level while the level is still there
  using Child_sink = Function_ref<void(const Level_connectivity&)>;
  using Values = boost::container::vector<Value>;

  // Level, creases and values before the first round.
  Level_refiner(const Scheme& scheme, Level_connectivity&& level, Level_creases&& creases,
                Values&& values, const For_chunks& for_chunks = For_chunks(),
                unsigned rounds_done = 0)
    : scheme_(scheme)
    , level_(std::move(level))
    , creases_(std::move(creases))
    , values_(std::move(values))
    , rounds_done_(rounds_done)
    , for_chunks_(for_chunks)
  {}
  Level_refiner(const Scheme& scheme, Level_connectivity&& level, Values&& values,
                const For_chunks& for_chunks = For_chunks(), unsigned rounds_done = 0)
    : Level_refiner(scheme, std::move(level), Level_creases(level.number_of_vertices()),
                    std::move(values), for_chunks, rounds_done)
  {}

  const Level_connectivity& level() const { return level_; }
  const Level_creases& creases() const { return creases_; }
  const Values& values() const { return values_; }
  // once nothing is evaluated any more
  void release_values() { Values().swap(values_); }
  Level_connectivity take_level() { return std::move(level_); }
  unsigned rounds_done() const { return rounds_done_; }

  // \pre the level stays while the round is used
  Level_round next_round() { return {scheme_, level_, creases_, values_.data(), rounds_done_ + 1}; }

  void refine()
  {
    Level_round round = next_round();
    refine(round);
  }
  void refine(Level_round& round, const Rows_sink* rows_sink = nullptr,
              const Child_sink* child_sink = nullptr);

  // the values of the refined slots; makes the level of the round whole again
  Values refined_values(Level_round& round, const Rows_sink* rows_sink = nullptr) const;

  // the transfers are found once for each round
  Transfers transfers(const Plain_round& round) const
  {
    return round.transfers(values_.data(), for_chunks_);
  }

  // The new vertices [begin, end) of a round. The sink gets a few neighboring vertices with every call;
  // the calls come from several threads if for_chunks has them.
  void evaluate(const Plain_round& round, const Transfers& transfers, Index begin, Index end,
                Sink sink, const Rows_sink* rows_sink = nullptr) const
  {
    evaluate_rows(round, begin, end, values_.data(), transfers, for_chunks_, sink, rows_sink);
  }

  // Only the listed new vertices, by their rows alone, without transfers.
  void evaluate(const Plain_round& round, const Index* vertices, Index number, List_sink sink) const
  {
    evaluate_rows(round, vertices, number, values_.data(), for_chunks_, sink);
  }

private:
  const Scheme& scheme_;
  Level_connectivity level_;
  Level_creases creases_;
  Values values_;
  unsigned rounds_done_;
  For_chunks for_chunks_;
};

template <class Scheme, class Average, class Level_creases>
void Level_refiner<Scheme, Average, Level_creases>::refine(Level_round& round,
                                                           const Rows_sink* rows_sink,
                                                           const Child_sink* child_sink)
{
  Values values = refined_values(round, rows_sink);
  Level_connectivity child = child_level(round, round.refined_creases(), for_chunks_);
  if (child_sink != nullptr) (*child_sink)(child);
  creases_ = std::move(round.refined_creases());
  level_ = std::move(child);
  values_ = std::move(values);
  ++rounds_done_;
}

template <class Scheme, class Average, class Level_creases>
auto Level_refiner<Scheme, Average, Level_creases>::refined_values(Level_round& round,
                                                                   const Rows_sink* rows_sink) const
  -> Values
{
  Values refined(round.refined_creases().number_of_slots, boost::container::default_init);
  evaluate_round(round, values_.data(), for_chunks_, refined, rows_sink);
  return refined;
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_REFINEMENT_LEVEL_REFINER_H

// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_CREASE_REFINER_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_CREASE_REFINER_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/creases/Crease_round.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>

#include <boost/container/vector.hpp>

#include <utility>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// A level with creases, the values of its slots, and the rounds of a scheme on them. It knows neither
// a mesh nor its maps.
template <class Scheme, class Average, class For_chunks>
class Crease_refiner
{
public:
  using One_round = Crease_round<Scheme, Average>;
  using FT = typename Average::FT;
  using Index = Level_connectivity::Index;
  using Value = typename One_round::Value;
  using Values = boost::container::vector<typename One_round::Stored_value>;

  // level, creases and values are those of the first round
  Crease_refiner(const Scheme& scheme, Level_connectivity&& level, Creases<FT>&& creases,
                 Values&& values, const For_chunks& for_chunks = For_chunks())
    : scheme_(scheme)
    , level_(std::move(level))
    , creases_(std::move(creases))
    , values_(std::move(values))
    , for_chunks_(for_chunks)
  {}

  const Level_connectivity& level() const { return level_; }
  const Creases<FT>& creases() const { return creases_; }
  // of the slots
  const Values& values() const { return values_; }

  void refine()
  {
    One_round crease_round(scheme_, level_, creases_, values_.data(), rounds_done_ + 1);
    const auto& round = crease_round.round();
    Level_connectivity child(round.refined_size());
    child.set_uniform_degree(Scheme::Host::refined_degree);
    round.host().connect(child, for_chunks_);
    Creases<FT>& creases = crease_round.refined_creases();
    Values refined(creases.number_of_slots, boost::container::default_init);
    for_chunks_(child.number_of_vertices(), [&](Index begin, Index end) {
      round.evaluate(begin, end, values_.data(), [&](Index v, const Value* values, Index n) {
        for (Index i = 0; i < n; ++i) refined[v + i] = values[i];
      });
    });
    for (const auto& slot : crease_round.crease_values(for_chunks_))
      refined[slot.first] = slot.second;
    creases_ = std::move(creases);
    level_ = std::move(child);
    values_ = std::move(refined);
    ++rounds_done_;
  }

private:
  const Scheme& scheme_;
  Level_connectivity level_;
  Creases<FT> creases_;
  Values values_;
  For_chunks for_chunks_;
  unsigned rounds_done_ = 0;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_CREASE_REFINER_H

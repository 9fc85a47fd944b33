// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_REFINEMENT_KEPT_ROUNDS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_REFINEMENT_KEPT_ROUNDS_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Dependents.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Kept_refinement.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Round.h>
#include <CGAL/PN_subdivision_3/internal/refinement/for_chunks.h>

#include <boost/container/vector.hpp>

#include <algorithm>
#include <cstddef>
#include <deque>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The rounds of a scheme on a control level, kept with their levels. What is kept of the last round is
// its old level: its new values go to a sink.
template <class Scheme, class Average>
class Kept_rounds final : public Kept_refinement<Average>
{
  using Base = Kept_refinement<Average>;

public:
  using typename Base::Index;
  using typename Base::List_sink;
  using typename Base::Sink;
  using typename Base::Value;
  using One_round = Round<Scheme, Average>;
  using Stored_value = typename One_round::Stored_value;

  Kept_rounds(const Scheme& scheme, Level_connectivity&& control, unsigned number_of_rounds,
              const For_chunks& for_chunks)
    : Base(for_chunks)
    , scheme_(scheme)
  {
    levels_.emplace_back(std::move(control));
    for (unsigned k = 1; k <= number_of_rounds; ++k) {
      Level& level = levels_.back();
      level.round.emplace(scheme_, level.connectivity, k);
      if (k < number_of_rounds) levels_.emplace_back(refined_level());
    }
  }

  Level_size refined_size() const override
  {
    const Level& last = levels_.back();
    return last.round ? last.round->refined_size() : last.connectivity.size();
  }
  Level_connectivity refined_level() const override
  {
    const Level& last = levels_.back();
    if (!last.round) return last.connectivity;
    Level_connectivity result(last.round->refined_size());
    result.set_uniform_degree(Scheme::Host::refined_degree);
    last.round->host().connect(result, this->for_chunks_);
    return result;
  }

  std::vector<Index> take(Control_values<Average>& control) override
  {
    control.update_estimate(levels_.front().connectivity);
    std::vector<Index> changed = control.changes();
    control.forget_changes();
    for (Index v : changed) levels_.front().values[v] = control[v];
    return changed;
  }

  void evaluate(Sink sink) override
  {
    if (!levels_.back().round) return copy(sink);
    for (std::size_t k = 0; k + 1 < levels_.size(); ++k) {
      auto& refined = levels_[k + 1].values;
      evaluate(levels_[k], [&](Index first, const Value* values, Index n) {
        std::copy(values, values + n, refined.begin() + first);
      });
    }
    evaluate(levels_.back(), sink);
  }

  std::vector<Index> evaluate_from(std::vector<Index> changed, List_sink sink) override
  {
    if (!levels_.back().round) {
      for (const Index& v : changed) {
        const Value value = levels_.front().values[v];
        sink(&v, &value, 1);
      }
      return changed;
    }
    for (std::size_t k = 0; k < levels_.size(); ++k) {
      Level& level = levels_[k];
      changed = level.readers(*level.round, level.values.size(), changed);
      if (k + 1 == levels_.size())
        evaluate(level, changed, sink);
      else {
        auto& refined = levels_[k + 1].values;
        evaluate(level, changed, [&](const Index* vertices, const Value* values, Index n) {
          for (Index i = 0; i < n; ++i) refined[vertices[i]] = values[i];
        });
      }
    }
    return changed;
  }

  std::size_t memory() const override
  {
    std::size_t sum = 0;
    for (const Level& level : levels_) {
      const Level_size& size = level.connectivity.size();
      sum += sizeof(Index) * (3 * size.halfedges() + size.vertices + size.faces) +
             sizeof(Stored_value) * level.values.size() + level.readers.memory();
    }
    return sum;
  }

private:
  struct Level
  {
    explicit Level(Level_connectivity&& level)
      : connectivity(std::move(level))
      , values(connectivity.number_of_vertices(), boost::container::default_init)
    {}

    Level_connectivity connectivity;
    boost::container::vector<Stored_value> values;
    std::optional<One_round> round; // refers to the connectivity; none if there are no rounds
    Row_readers readers;
  };

  void copy(Sink sink) const
  {
    const auto& values = levels_.front().values;
    for (Index v = 0; v < values.size(); ++v) {
      const Value value = values[v];
      sink(v, &value, 1);
    }
  }

  void evaluate(const Level& level, Sink sink) const
  {
    const auto n = static_cast<Index>(level.round->refined_size().vertices);
    this->in_chunks(n, [&](Index begin, Index end) {
      level.round->evaluate(begin, end, level.values.data(), {}, sink);
    });
  }

  void evaluate(const Level& level, const std::vector<Index>& vertices, List_sink sink) const
  {
    this->in_chunks(static_cast<Index>(vertices.size()), [&](Index begin, Index end) {
      level.round->evaluate(vertices.data() + begin, vertices.data() + end, level.values.data(),
                            sink);
    });
  }

  const Scheme scheme_;      // the masks may refer to it
  std::deque<Level> levels_; // keeps its elements where they are
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_REFINEMENT_KEPT_ROUNDS_H

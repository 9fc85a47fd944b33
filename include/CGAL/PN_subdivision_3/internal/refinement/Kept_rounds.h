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
#include <CGAL/PN_subdivision_3/internal/refinement/Caller_precision.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Dependents.h>
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

// The rounds of a scheme on a control level, kept with their levels, so that other values of the
// control vertices are refined without anything of the connectivity. What is kept of the last round
// is its old level: its new values go to a sink.
template <class Scheme, class Average>
class Kept_rounds
{
public:
  using Index = Level_connectivity::Index;
  using One_round = Round<Scheme, Average>;
  using Value = typename One_round::Value;
  using Stored_value = typename One_round::Stored_value;
  // take new vertices of the last round, from several threads if for_chunks calls from them
  using Sink = typename One_round::Sink;
  using List_sink = typename One_round::List_sink;

  Kept_rounds(const Scheme& scheme, Level_connectivity&& control, unsigned number_of_rounds,
              const For_chunks& for_chunks)
    : scheme_(scheme)
    , for_chunks_(for_chunks)
  {
    levels_.emplace_back(std::move(control));
    for (unsigned k = 1; k <= number_of_rounds; ++k) {
      Level& level = levels_.back();
      level.round.emplace(scheme_, level.connectivity, k);
      if (k < number_of_rounds) levels_.emplace_back(refined_level());
    }
  }
  Kept_rounds(const Kept_rounds&) = delete;
  Kept_rounds& operator=(const Kept_rounds&) = delete;

  const Level_connectivity& control() const { return levels_.front().connectivity; }
  Level_size refined_size() const
  {
    const Level& last = levels_.back();
    return last.round ? last.round->refined_size() : last.connectivity.size();
  }
  Level_connectivity refined_level() const
  {
    const Level& last = levels_.back();
    if (!last.round) return last.connectivity;
    Level_connectivity result(last.round->refined_size());
    result.set_uniform_degree(Scheme::Host::refined_degree);
    last.round->host().connect(result, for_chunks_);
    return result;
  }

  void set_value(Index v, const Value& value) { levels_.front().values[v] = value; }

  void evaluate(Sink sink)
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

  // what the control vertices that are listed reach; returns it, in the order of the numbers. The
  // first such call finds out once what reads what.
  std::vector<Index> evaluate_from(std::vector<Index> changed, List_sink sink)
  {
    if (!levels_.back().round) {
      for (const Index& v : changed) {
        const Value value = levels_.front().values[v];
        sink(&v, &value, 1);
      }
      return changed;
    }
    for (std::size_t k = 0; k < levels_.size(); ++k) {
      changed = levels_[k].readers_of(changed);
      if (k + 1 == levels_.size())
        evaluate(levels_[k], changed, sink);
      else {
        auto& refined = levels_[k + 1].values;
        evaluate(levels_[k], changed, [&](const Index* vertices, const Value* values, Index n) {
          for (Index i = 0; i < n; ++i) refined[vertices[i]] = values[i];
        });
      }
    }
    return changed;
  }

  // in bytes, without what the masks of a scheme may keep
  std::size_t memory() const
  {
    std::size_t sum = 0;
    for (const Level& level : levels_) {
      const Level_size& size = level.connectivity.size();
      sum += sizeof(Index) * (3 * size.halfedges() + size.vertices + size.faces) +
             sizeof(Stored_value) * level.values.size() + level.dependents.memory() +
             level.is_marked.size();
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

    // the new vertices whose rows read one of the old ones, in the order of the numbers
    std::vector<Index> readers_of(const std::vector<Index>& old)
    {
      if (dependents.is_empty()) {
        is_marked.assign(round->refined_size().vertices, 0);
        dependents = Dependents(*round, values.size());
      }
      std::vector<Index> readers;
      for (Index v : old)
        dependents.for_each(v, [&](Index r) {
          if (is_marked[r] != 0) return;
          is_marked[r] = 1;
          readers.push_back(r);
        });
      // unless there are few, looking at all marks costs less than sorting
      if (readers.size() < is_marked.size() / 256)
        std::sort(readers.begin(), readers.end());
      else
        collect_marks(readers);
      for (Index r : readers) is_marked[r] = 0;
      return readers;
    }

    void collect_marks(std::vector<Index>& marked) const
    {
      auto end = marked.begin();
      const char* const marks = is_marked.data();
      const char* const last = marks + is_marked.size();
      for (const char* m = marks; (m = std::find(m, last, 1)) != last; ++m)
        *end++ = static_cast<Index>(m - marks);
    }

    Level_connectivity connectivity;
    boost::container::vector<Stored_value> values;
    std::optional<One_round> round; // refers to the connectivity; none if there are no rounds
    Dependents dependents;
    std::vector<char> is_marked; // none of them between two calls
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
    in_chunks(n, [&](Index begin, Index end) {
      level.round->evaluate(begin, end, level.values.data(), {}, sink);
    });
  }

  void evaluate(const Level& level, const std::vector<Index>& vertices, List_sink sink) const
  {
    in_chunks(static_cast<Index>(vertices.size()), [&](Index begin, Index end) {
      level.round->evaluate(vertices.data() + begin, vertices.data() + end, level.values.data(),
                            sink);
    });
  }

  void in_chunks(Index n, For_chunks::Function f) const
  {
    using Precision = Caller_precision<typename Average::FT>;
    const Precision precision;
    for_chunks_(n, [&](Index begin, Index end) {
      const typename Precision::In_this_thread scope(precision);
      f(begin, end);
    });
  }

  const Scheme scheme_; // the masks may refer to it
  For_chunks for_chunks_;
  std::deque<Level> levels_; // keeps its elements where they are
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_REFINEMENT_KEPT_ROUNDS_H

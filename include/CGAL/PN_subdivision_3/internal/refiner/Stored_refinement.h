// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_REFINER_STORED_REFINEMENT_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_REFINER_STORED_REFINEMENT_H

#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/refiner/Control_values.h>
#include <CGAL/PN_subdivision_3/internal/rows/Stencil_block.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// What a refiner keeps of a control mesh, a scheme and a number of rounds, so that other control values
// are refined without anything of the connectivity.
template <class Average>
class Stored_refinement
{
public:
  using Index = Level_connectivity::Index;
  using Value = typename Average::Value;
  // take refined values, from several threads if for_chunks calls from them
  using Sink = Function_ref<void(Index, const Value*, Index)>;
  using List_sink = Function_ref<void(const Index*, const Value*, Index)>;
  // takes (corner of the refined level, its value; none if it is that of the vertex)
  using Corner_sink = Function_ref<void(Index, const Value*)>;

  Stored_refinement(const Stored_refinement&) = delete;
  Stored_refinement& operator=(const Stored_refinement&) = delete;
  virtual ~Stored_refinement() = default;

  virtual Level_size refined_size() const = 0;
  virtual Level_connectivity refined_level() const = 0;

  // takes over what was set; returns what has changed by it, for evaluate_from()
  virtual std::vector<Index> take(Control_values<Average>& control) = 0;
  virtual void evaluate(Sink sink) = 0;
  // what this reaches; returns it, in the order of the numbers. The first such call finds out once what
  // reads what. Values were evaluated before.
  virtual std::vector<Index> evaluate_from(std::vector<Index> changed, List_sink sink) = 0;

  // as of the last evaluation
  virtual void for_each_corner(const Level_connectivity& refined, Corner_sink sink) const = 0;

  // in bytes, without what the masks of a scheme may keep
  virtual std::size_t memory() const = 0;

protected:
  explicit Stored_refinement(const For_chunks& for_chunks)
    : for_chunks_(for_chunks)
  {}

  void in_chunks(Index n, For_chunks::Function f) const
  {
    for_chunks_.in_precision<typename Average::FT>(n, f);
  }

  For_chunks for_chunks_;
};

// Finds the new vertices of a round whose rows read any of some old ones. Finds out in the first call what reads what:
// the rows of the round, transposed.
class Row_readers
{
public:
  using Index = Level_connectivity::Index;

  // in the order of the numbers
  template <class Round>
  std::vector<Index> operator()(const Round& round, std::size_t number_of_old_vertices,
                                const std::vector<Index>& old)
  {
    if (begin_.empty()) {
      is_marked_.assign(round.refined_size().vertices, 0);
      transpose(round, number_of_old_vertices);
    }
    std::vector<Index> readers;
    for (Index v : old)
      for (std::size_t i = begin_[v]; i < begin_[v + 1]; ++i) { // some come more than once
        const Index r = readers_[i];
        if (is_marked_[r] != 0) continue;
        is_marked_[r] = 1;
        readers.push_back(r);
      }
    // unless there are few, looking at all marks costs less than sorting
    if (readers.size() < is_marked_.size() / 256)
      std::sort(readers.begin(), readers.end());
    else
      collect_marks(readers);
    for (Index r : readers) is_marked_[r] = 0;
    return readers;
  }

  std::size_t memory() const
  {
    return begin_.capacity() * sizeof(std::size_t) + readers_.capacity() * sizeof(Index) +
           is_marked_.size();
  }

private:
  template <class Round>
  void transpose(const Round& round, std::size_t number_of_old_vertices)
  {
    std::vector<std::size_t> begin(number_of_old_vertices + 1, 0);
    const auto n = static_cast<Index>(is_marked_.size());
    Stencil_block<typename Round::FT> buffer;
    for (Index r = 0; r < n; ++r) round.for_each_entry(r, buffer, [&](Index v) { ++begin[v + 1]; });
    for (std::size_t v = 0; v < number_of_old_vertices; ++v) begin[v + 1] += begin[v];
    // while the lists are filled, the end of each is where it begins
    readers_.resize(begin.back());
    for (Index r = n; r-- > 0;)
      round.for_each_entry(r, buffer, [&](Index v) { readers_[--begin[v + 1]] = r; });
    begin.erase(begin.begin());
    begin.push_back(readers_.size());
    begin_ = std::move(begin);
  }

  void collect_marks(std::vector<Index>& marked) const
  {
    auto end = marked.begin();
    const char* const marks = is_marked_.data();
    const char* const last = marks + is_marked_.size();
    for (const char* m = marks; (m = std::find(m, last, 1)) != last; ++m)
      *end++ = static_cast<Index>(m - marks);
  }

  std::vector<std::size_t> begin_; // of the readers of each old vertex
  std::vector<Index> readers_;
  std::vector<char> is_marked_; // of each new vertex; false between two calls
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_REFINER_STORED_REFINEMENT_H

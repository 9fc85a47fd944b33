// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_REFINER_KEPT_REFINEMENT_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_REFINER_KEPT_REFINEMENT_H

#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/refiner/Control_values.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// What a refiner keeps of a control mesh, a scheme and a number of rounds, so that other control values
// are refined without anything of the connectivity.
template <class Average>
class Kept_refinement
{
public:
  using Index = Level_connectivity::Index;
  using Value = typename Average::Value;
  // take refined values, from several threads if for_chunks calls from them
  using Sink = Function_ref<void(Index, const Value*, Index)>;
  using List_sink = Function_ref<void(const Index*, const Value*, Index)>;
  // takes (corner of the refined level, its value; none if it is that of the vertex)
  using Corner_sink = Function_ref<void(Index, const Value*)>;

  Kept_refinement(const Kept_refinement&) = delete;
  Kept_refinement& operator=(const Kept_refinement&) = delete;
  virtual ~Kept_refinement() = default;

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
  explicit Kept_refinement(const For_chunks& for_chunks)
    : for_chunks_(for_chunks)
  {}

  void in_chunks(Index n, For_chunks::Function f) const
  {
    using Precision = Caller_precision<typename Average::FT>;
    const Precision precision;
    for_chunks_(n, [&](Index begin, Index end) {
      const typename Precision::In_this_thread scope(precision);
      f(begin, end);
    });
  }

  For_chunks for_chunks_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_REFINER_KEPT_REFINEMENT_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_CARRIED_VALUES_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_CARRIED_VALUES_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/average/Stencil_block.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The values of an attribute of the control mesh, which become those of the refined mesh: of faces or edges
// by a copy, of vertices or corners by rows. What is put can be taken back until it is kept.
class Copied_values
{
public:
  using Index = Level_connectivity::Index;
  static constexpr Index null = Level_connectivity::null;

  Copied_values() = default;
  Copied_values(const Copied_values&) = delete;
  Copied_values& operator=(const Copied_values&) = delete;
  virtual ~Copied_values() = default;

  // Element i of the refined mesh gets the value of control element sources[i], or that of a new element if
  // that is null.
  virtual void put(const std::vector<Index>& sources) = 0;
  virtual void keep() noexcept = 0;
};

// All levels have arrays of their own; a level is computed from the one before.
template <class FT>
class Row_values : public Copied_values
{
public:
  using Entry = typename Entry_row<FT>::Entry;

  // those of the control mesh
  virtual bool are_equal(Index a, Index b) const = 0;
  // value i of the first level is that of control element sources[i]; where that is null it does not matter
  virtual void begin(const std::vector<Index>& sources) = 0;

  virtual void begin_round(std::size_t number_of_values) = 0;
  // of a round whose value i is put for element i. Values may be put at once, but by several threads only if the
  // map allows it; put() comes nevertheless.
  virtual void begin_last_round(std::size_t number_of_values, bool /*has_threads*/)
  {
    begin_round(number_of_values);
  }
  // for the rows from value `first` on; from several threads
  virtual void evaluate(Index first, const Stencil_block<FT>& rows) = 0;
  virtual void evaluate(Index value, const Entry* begin, const Entry* end) = 0;
  // of the new level
  virtual void copy(Index from, Index to) = 0;
  virtual void end_round() = 0;

  // value i for element i
  virtual void put_all(Index number) = 0;

  // put(): element i of the refined mesh gets value sources[i] of the last level, and keeps what it has if that
  // is null.
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_CARRIED_VALUES_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_PIECES_KEPT_PIECES_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_PIECES_KEPT_PIECES_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/pieces/Piece_elements.h>
#include <CGAL/PN_subdivision_3/internal/pieces/Whole_levels.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Function_ref.h>

#include <cstddef>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// What pieces are asked for, whatever the scheme.
template <class Value>
class Kept_pieces
{
public:
  using Index = Level_connectivity::Index;

  // takes (connectivity, its vertices, its faces), to be moved, once and then (vertex, value), of different
  // vertices from different threads; at last (half-edge, wedge, value) for the corners of vertices with several
  // wedges, in increasing order
  struct Output
  {
    Function_ref<void(Level_connectivity&, Numbered_elements&, Numbered_elements&)> begin;
    Function_ref<void(Index, const Value&)> put;
    Function_ref<void(Index, Index, const Value&)> put_corner;
  };

  Kept_pieces() = default;
  Kept_pieces(const Kept_pieces&) = delete;
  Kept_pieces& operator=(const Kept_pieces&) = delete;
  virtual ~Kept_pieces() = default;

  // after all rounds
  virtual const Whole_level& result() const = 0;
  // the level that is divided
  virtual const Level_connectivity& base() const = 0;
  virtual unsigned base_round() const = 0;
  // the degree of all faces that a round makes, 0 if they are of different degrees
  virtual Index refined_degree() const = 0;
  virtual bool is_empty(std::size_t piece) const = 0;
  // the faces that the piece owns, and some rings around them
  virtual void refine(std::size_t piece, unsigned rings, const Output& out) const = 0;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_PIECES_KEPT_PIECES_H

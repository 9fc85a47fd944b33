// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_ANY_PIECES_H
#define PN_SUBDIVIDE_ANY_PIECES_H

#include "options.h"
#include "surface/Surface.h"
#include "surface/creases.h"
#include "surface/surface_schemes.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/PN_limit_surface_3/refine_in_pieces.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace pn_subdivide {

// The pieces of a surface refined by any scheme: Surface_pieces without its type.
class Any_pieces
{
public:
  using Piece = PN::Surface_piece<Kernel>;
  using Size = PN::Level_size;

  virtual ~Any_pieces() = default;
  virtual std::size_t number() const = 0;
  virtual bool is_empty(std::size_t i) const = 0;
  virtual const Size& size() const = 0;
  virtual std::uint64_t first_corner(std::uint64_t face) const = 0;
  virtual std::size_t largest_degree() const = 0;
  virtual Piece piece(std::size_t i, unsigned rings) const = 0;
  // The tolerance of limits is a part of the size of the box of all pieces, which has to be set.
  virtual CGAL::Bbox_3 box_of_piece(std::size_t i) const = 0;
  virtual void set_box(const CGAL::Bbox_3& box) = 0;
};

// The surface is not needed afterwards. Its normals are refined if it has some; with creases those of corners are
// removed. Vertices are on the limit surface, and have its normals, if that is asked for.
std::unique_ptr<Any_pieces> make_pieces(Surface& surface, const Scheme_choice& choice,
                                        unsigned levels, std::size_t number,
                                        const std::optional<Crease_maps>& creases,
                                        const Limit_choice& limit,
                                        const PN::Attribute_table& attributes);

// The bytes that so many pieces take in a process, about, with so many for each vertex besides.
double memory_of_pieces(const Surface& surface, const Scheme_choice& choice, unsigned levels,
                        std::size_t number, double of_vertex);

// "500M": bytes. Throws Usage_error.
double parse_memory(const std::string& text);

// How many pieces are made: as asked for, or so many that one of them fits into the memory. Throws Error if none
// does.
std::size_t piece_count(const Surface& surface, const Scheme_choice& scheme, unsigned levels,
                        const Pieces_options& options, unsigned ranks, bool with_limits,
                        double of_vertex);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_ANY_PIECES_H

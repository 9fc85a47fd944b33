// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_PIECE_OUTPUT_H
#define PN_SUBDIVIDE_PIECE_OUTPUT_H

#include "pieces/Any_pieces.h"
#include "pieces/Output_names.h"
#include "pieces/Piece_attributes.h"
#include "pieces/Piece_normals.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

namespace pn_subdivide {

// What pieces are written into, under a name of its own until all of them are there. The functions are called
// in the order in which they stand; create(), mend() and finish() by one rank, the others by all.
class Piece_output
{
public:
  virtual ~Piece_output() = default;

  // the bytes that it will take
  virtual std::uint64_t size() const = 0;
  // unless it is to be continued; throws Error if the name is taken
  virtual void create() = 0;
  // all but the pieces
  virtual void mend() {}
  // Is a piece there as it was when it was written? The receipt is that of write().
  virtual bool is_written(std::size_t i, const std::string& receipt) const = 0;
  virtual void open() {}
  virtual void write(std::size_t i, const Any_pieces::Piece& piece) = 0;
  // Until a piece that was just written is on the disk. Returns a receipt, without line ends.
  virtual std::string sync(std::size_t i) = 0;
  virtual void close() {}
  // gives it the name that was asked for
  virtual void finish() = 0;
  // instead of it: was there something to remove?
  virtual bool remove() = 0;
};

// Throws Error if the format cannot hold the surface.
std::unique_ptr<Piece_output> make_ply_output(const Any_pieces& pieces,
                                              const Piece_normals& normals,
                                              const Piece_attributes& attributes,
                                              const Output_names& names, bool keeps_receipts);
std::unique_ptr<Piece_output> make_pvtp_output(const Any_pieces& pieces,
                                               const Piece_normals& normals,
                                               const Piece_attributes& attributes,
                                               const Output_names& names);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_PIECE_OUTPUT_H

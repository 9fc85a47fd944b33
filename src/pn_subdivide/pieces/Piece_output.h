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

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>

namespace pn_subdivide {

// What pieces are written into, under a name of its own until all of them are there. The functions are called
// in the order in which they stand; create() and finish() by one rank, the others by all.
class Piece_output
{
public:
  virtual ~Piece_output() = default;

  // the bytes that it will take
  virtual std::uint64_t size() const = 0;
  // anew, or, to be continued, if it is not there
  virtual void create() = 0;
  virtual void open() = 0;
  virtual void write(std::size_t i, const Any_pieces::Piece& piece) = 0;
  // until a piece that was written is on the disk
  virtual void sync(std::size_t i) = 0;
  virtual void close() = 0;
  // gives it the name that was asked for
  virtual void finish() = 0;
};

// Throws Error if the format cannot hold the surface. `part` is the name until then: a file or a folder.
std::unique_ptr<Piece_output> make_ply_output(const Any_pieces& pieces, bool has_normals,
                                              const std::filesystem::path& part,
                                              const std::filesystem::path& target);
std::unique_ptr<Piece_output> make_pvtp_output(const Any_pieces& pieces, bool has_normals,
                                               const std::filesystem::path& part,
                                               const std::filesystem::path& target);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_PIECE_OUTPUT_H

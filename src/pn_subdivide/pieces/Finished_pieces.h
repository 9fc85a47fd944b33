// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_FINISHED_PIECES_H
#define PN_SUBDIVIDE_FINISHED_PIECES_H

#include <cstddef>
#include <filesystem>
#include <string>

namespace pn_subdivide {

// The folder that tells which pieces are on the disk: a file that names the job, and one for each piece, with a receipt by
// which what was written is known again. They are renamed into place, so that ranks need not know of each other.
class Finished_pieces
{
public:
  Finished_pieces(std::filesystem::path folder, std::string job);

  static bool are_of(const std::filesystem::path& folder, const std::string& job);

  // of no piece
  void create() const;
  void remove() const;
  std::size_t number() const;

  // empty if there is none
  std::string receipt(std::size_t i) const;
  // once the piece is on the disk
  void set_finished(std::size_t i, const std::string& receipt) const;

private:
  void write(const std::string& name, const std::string& text) const;
  std::string first_line(std::size_t i) const;

  std::filesystem::path folder_;
  std::string job_;
};

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_FINISHED_PIECES_H

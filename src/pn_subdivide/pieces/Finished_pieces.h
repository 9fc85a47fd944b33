// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_FINISHED_PIECES_H
#define PN_SUBDIVIDE_FINISHED_PIECES_H

#include "pieces/Shared_file.h"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>

namespace pn_subdivide {

// The file that tells which pieces are on the disk: a line that names the job, and a character for each piece,
// 0 or 1, so that ranks need not know of each other.
class Finished_pieces
{
public:
  Finished_pieces(std::filesystem::path file, const std::string& job, std::size_t pieces);

  bool exists() const { return std::filesystem::exists(file_); }
  // of no piece
  void create();
  // Throws Error if it is that of another job.
  void read();
  bool is_finished(std::size_t i) const { return marks_[i] == '1'; }
  std::size_t number() const;
  // and is on the disk then
  void set_finished(std::size_t i);

private:
  std::filesystem::path file_;
  std::string first_line_, marks_;
  std::unique_ptr<Shared_file> open_file_;
};

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_FINISHED_PIECES_H

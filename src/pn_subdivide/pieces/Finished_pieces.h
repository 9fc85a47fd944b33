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
#include <functional>
#include <string>
#include <vector>

namespace pn_subdivide {

// The file that tells which pieces are on the disk: a line that names the job, and a line for each piece, with a
// receipt by which what was written is known again. Lines are added at the end, so that ranks need not know of
// each other, and have a checksum: a damaged one says nothing.
class Finished_pieces
{
public:
  Finished_pieces(std::filesystem::path file, const std::string& job, std::size_t pieces);

  static bool are_of(const std::filesystem::path& file, const std::string& job);

  // of no piece
  void create();
  void remove() const;
  // Before lines are added to a file that may be cut off.
  void end_last_line() const;
  // for how many pieces there are lines
  std::size_t number_of_lines() const;
  // is_written(piece, receipt) decides which pieces are finished.
  void read(const std::function<bool(std::size_t, const std::string&)>& is_written);

  bool is_finished(std::size_t i) const { return is_finished_[i]; }
  // and the line is on the disk then
  void set_finished(std::size_t i, const std::string& receipt);

private:
  template <class Function>
  void for_each_line(const Function& f) const;
  std::string checksum(const std::string& line) const;

  std::filesystem::path file_;
  std::string first_line_;
  std::vector<bool> is_finished_;
};

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_FINISHED_PIECES_H

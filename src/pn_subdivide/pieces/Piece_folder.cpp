// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "pieces/Piece_folder.h"

#include <system_error>
#include <vector>

namespace fs = std::filesystem;

namespace pn_subdivide {
namespace {

bool is_piece_file(const fs::directory_entry& entry)
{
  const std::string begin = "piece_", end = ".vtp", name = entry.path().filename().string();
  std::error_code error;
  return name.size() > begin.size() + end.size() && name.rfind(begin, 0) == 0 &&
         name.find_first_not_of("0123456789", begin.size()) == name.size() - end.size() &&
         name.compare(name.size() - end.size(), end.size(), end) == 0 &&
         fs::is_regular_file(entry.symlink_status(error));
}

} // namespace

std::string piece_name(std::size_t i)
{
  return "piece_" + std::to_string(i) + ".vtp";
}

bool is_piece_folder(const fs::path& folder)
{
  std::error_code error;
  if (!fs::is_directory(fs::symlink_status(folder, error))) return false;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (!is_piece_file(entry)) return false;
  return true;
}

bool remove_piece_folder(const fs::path& folder)
{
  std::error_code error;
  std::vector<fs::path> files;
  for (fs::directory_iterator i(folder, error); !error && i != fs::directory_iterator();
       i.increment(error))
    if (is_piece_file(*i)) files.push_back(i->path());
  bool any = false;
  for (const fs::path& file : files) any = fs::remove(file, error) || any;
  return fs::remove(folder, error) || any;
}

} // namespace pn_subdivide

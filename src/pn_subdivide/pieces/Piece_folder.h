// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_PIECE_FOLDER_H
#define PN_SUBDIVIDE_PIECE_FOLDER_H

#include <cstddef>
#include <filesystem>
#include <string>

namespace pn_subdivide {

// The file of a piece in a folder of pieces.
std::string piece_name(std::size_t i);

// Is it a folder, with nothing but files of such names in it?
bool is_piece_folder(const std::filesystem::path& folder);

// Removes the files of pieces and, unless there are others, the folder. Was there something to remove?
bool remove_piece_folder(const std::filesystem::path& folder);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_PIECE_FOLDER_H

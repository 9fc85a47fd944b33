// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_PIECES_OPTIONS_H
#define PN_SUBDIVIDE_PIECES_OPTIONS_H

#include <cstddef>
#include <optional>
#include <string>

namespace pn_subdivide {

// --memory, --pieces and --resume as they are on the command line.
struct Pieces_options
{
  std::optional<std::string> memory;
  std::optional<std::size_t> pieces;
  bool resume = false;

  bool any() const { return memory || pieces || resume; }
};

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_PIECES_OPTIONS_H

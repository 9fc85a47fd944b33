// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_PIECE_COUNT_H
#define PN_SUBDIVIDE_PIECE_COUNT_H

#include "pieces/Pieces_options.h"
#include "surface/Surface.h"
#include "surface/surface_schemes.h"

#include <cstddef>
#include <string>

namespace pn_subdivide {

// "500M": bytes. Throws Usage_error.
double parse_memory(const std::string& text);

// How many pieces are made: as asked for, or so many that one of them fits into the memory. Throws Error if none
// does.
std::size_t piece_count(const Surface& surface, const Scheme_choice& scheme, unsigned levels,
                        const Pieces_options& options, unsigned ranks, bool with_limits,
                        double of_vertex);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_PIECE_COUNT_H

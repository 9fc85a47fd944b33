// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_PART_CHOICE_H
#define PN_SUBDIVIDE_PART_CHOICE_H

#include "options.h"

#include <string>

namespace pn_subdivide {

class Mesh_data;
struct Recognized_part;

// What --part stands for: --sharp surfaces --planes rims, and --chord 0.02% unless a chord or rounds are given. Throws Usage_error,
// which names --part, if it does not go with the other options.
Surface_options with_part(const Surface_options& options);

// A first look: flat patches behind sharp edges at a tenth of some vertices. It takes at most a twentieth of the time of a round.
bool looks_like_part(const Mesh_data& mesh);

// May --sharp auto take the mesh of a file without tags and normals for a part, as far as the options and the scheme go?
bool may_be_part(const Surface_options& options, const Scheme_choice& scheme);

// "taken for a part of 6 planes and 2 round surfaces on 100 % of its area ..."
std::string taken_for_part(const Recognized_part& part);

// What helps to keep edges: --part where surfaces cover half of the area, --sharp angle:40 where few of the edges turn, or nothing.
enum class Edge_advice { none, part, angle };
Edge_advice edge_advice(const Recognized_part* part, std::size_t turning, std::size_t edges);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_PART_CHOICE_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_NEAR_MISS_H
#define PN_SUBDIVIDE_NEAR_MISS_H

#include <string>
#include <vector>

namespace pn_subdivide {

// The word that was probably meant: at most a third of its letters are added, missing or others, or it
// goes on where `word` ends. Empty if there is none.
std::string near_miss(const std::string& word, const std::vector<std::string>& known);

// "; did you mean --levels?", or nothing
std::string did_you_mean(const std::string& word, const std::vector<std::string>& known);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_NEAR_MISS_H

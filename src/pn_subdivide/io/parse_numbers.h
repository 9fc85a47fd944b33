// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_PARSE_NUMBERS_H
#define PN_SUBDIVIDE_PARSE_NUMBERS_H

#include <string>
#include <utility>
#include <vector>

namespace pn_subdivide {

// "name:rest" as name and rest; the rest is empty if there is no colon.
std::pair<std::string, std::string> split_at_colon(const std::string& text);

// Finite numbers with commas between, for the argument of an option. Throws Usage_error, which
// begins with `option`.
std::vector<double> parse_numbers(const std::string& text, const std::string& option);
// exactly so many
std::vector<double> parse_numbers(const std::string& text, std::size_t number,
                                  const std::string& option);

// Throws Usage_error if the three numbers are zero.
void require_direction(const double* direction, const std::string& option);

// The number of --roundness, from 0 to 1. Throws Usage_error, which says what else might have been `expected`.
double parse_roundness(const std::string& text, const std::string& expected = "");

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_PARSE_NUMBERS_H

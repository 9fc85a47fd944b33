// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_PLURAL_H
#define PN_SUBDIVIDE_PLURAL_H

#include <cstddef>
#include <string>

namespace pn_subdivide {

// "1 face", "2 faces"
inline std::string plural(std::size_t n, const std::string& one, const std::string& many)
{
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_PLURAL_H

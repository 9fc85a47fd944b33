// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_CHECKSUM_H
#define PN_SUBDIVIDE_CHECKSUM_H

#include <boost/crc.hpp>

#include <cstdint>
#include <cstdio>
#include <string>

namespace pn_subdivide {

// that of ECMA-182
using Checksum = boost::crc_optimal<64, 0x42f0e1eba9ea3693u, ~0ull, ~0ull, true, true>;

inline std::string text_of(const Checksum& checksum)
{
  char text[20];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(checksum.checksum()));
  return text;
}

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_CHECKSUM_H

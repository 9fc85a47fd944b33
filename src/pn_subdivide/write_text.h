// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_WRITE_TEXT_H
#define PN_SUBDIVIDE_WRITE_TEXT_H

#include "Output_file.h"

namespace pn_subdivide {

// The three coordinates of a point or vector with blanks between.
template <class Triple>
void write_triple(Output_file& out, const Triple& t)
{
  out.number(t.x());
  out.text(" ");
  out.number(t.y());
  out.text(" ");
  out.number(t.z());
}

inline void write_count(Output_file& out, std::size_t n)
{
  out.number(static_cast<std::uint64_t>(n));
}

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_WRITE_TEXT_H

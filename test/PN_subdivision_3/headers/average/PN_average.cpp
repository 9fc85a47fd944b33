// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include <CGAL/PN_subdivision_3/average/PN_average.h>

using namespace CGAL::PN_subdivision_3;

namespace header_in_use {

struct Entry
{
  int vertex;
  double weight;
};

void use_average()
{
  const PN_average<double, 3>::Value values[1] = {{{0, 0, 0}, {0, 0, 1}}};
  const Entry entries[2] = {{0, 0.5}, {0, 0.5}};
  (void)PN_average<double, 3>()(entries, entries + 2, values);
}

} // namespace header_in_use

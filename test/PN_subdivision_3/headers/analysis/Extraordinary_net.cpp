// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "analysis/Extraordinary_net.h"

using namespace CGAL::PN_subdivision_3;

namespace header_in_use {

void use_extraordinary_net()
{
  Extraordinary_net net(4, 5, 2);
  (void)net;
}

} // namespace header_in_use

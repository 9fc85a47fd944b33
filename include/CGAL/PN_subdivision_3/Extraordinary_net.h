// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_EXTRAORDINARY_NET_H
#define CGAL_PN_SUBDIVISION_3_EXTRAORDINARY_NET_H

// The documented name of this header.
#include <CGAL/PN_subdivision_3/curvature/Extraordinary_net.h>

#endif // CGAL_PN_SUBDIVISION_3_EXTRAORDINARY_NET_H

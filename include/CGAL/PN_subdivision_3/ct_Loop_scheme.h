// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_CT_LOOP_SCHEME_H
#define CGAL_PN_SUBDIVISION_3_CT_LOOP_SCHEME_H

// The documented name of this header.
#include <CGAL/PN_subdivision_3/schemes/ct_Loop_scheme.h>

#endif // CGAL_PN_SUBDIVISION_3_CT_LOOP_SCHEME_H

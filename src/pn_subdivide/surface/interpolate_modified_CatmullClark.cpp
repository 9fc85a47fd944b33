// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/interpolate_scheme.h"

template struct pn_subdivide::Interpolating_scheme<
  CGAL::PN_subdivision_3::modified_CatmullClark_scheme>;

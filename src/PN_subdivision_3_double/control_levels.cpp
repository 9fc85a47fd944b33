// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// What is linked to the library has not the code of wide averages.
#undef CGAL_PN_SUBDIVISION_3_DOUBLE
#include <CGAL/PN_subdivision_3/internal/rows/Vectorized_PN_average.h>
#define CGAL_PN_SUBDIVISION_3_DOUBLE

#include <CGAL/PN_subdivision_3/internal/meshes/compiled_levels.h>

namespace CGAL::PN_subdivision_3::internal {

CGAL_PN_SUBDIVISION_3_CONTROL_LEVELS()
template void check_connectivity(Level_connectivity&, const Element_names&);
#ifdef CGAL_PN_SUBDIVISION_3_HAS_AVX2_FUNCTIONS
template struct Vectorized_PN_average<double, 2>;
template struct Vectorized_PN_average<double, 3>;
template struct Vectorized_PN_average<float, 2>;
template struct Vectorized_PN_average<float, 3>;
#endif

} // namespace CGAL::PN_subdivision_3::internal

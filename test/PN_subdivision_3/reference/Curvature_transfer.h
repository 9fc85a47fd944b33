// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The transfer of curvature of the schemes ct: the left eigenvectors of the plain matrix numerically, by
// a discrete Fourier transform and eigenvectors of its blocks; the quadratic form by a singular value
// decomposition. Compiled once, in Curvature_transfer.cpp.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_CURVATURE_TRANSFER_H
#define CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_CURVATURE_TRANSFER_H

#include "PN_rule.h"

namespace reference {

// After a round on `mesh` (quads or triangles), which has given the values of the new vertices.
void transfer_curvature(const Face_list& mesh, bool quads, Values& values);

} // namespace reference

#endif // CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_CURVATURE_TRANSFER_H

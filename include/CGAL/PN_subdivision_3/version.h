// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_VERSION_H
#define CGAL_PN_SUBDIVISION_3_VERSION_H

/*!
\file version.h
The version of the package, as `CGAL/version.h` gives CGAL's.
*/

/// \ingroup PkgPNSubdivision3Ref
/// The version as a text, `"major.minor.patch"`; before the release of that version with `"-dev"`.
#define CGAL_PN_SUBDIVISION_3_VERSION "0.2.0"

/// \ingroup PkgPNSubdivision3Ref
/// The version as a number that can be compared: 1 followed by two digits each for major, minor and patch.
#define CGAL_PN_SUBDIVISION_3_VERSION_NR 1000200

#endif // CGAL_PN_SUBDIVISION_3_VERSION_H

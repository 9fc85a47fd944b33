// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The shipped schemes by their names, compiled once for all tests: those which include this are not compiled again when one changes.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_SCHEME_NAMED_H
#define CGAL_PN_SUBDIVISION_3_TEST_SCHEME_NAMED_H

#include <CGAL/PN_subdivision_3/schemes/Any_scheme.h>

#include <string>
#include <vector>

CGAL::PN_subdivision_3::Any_scheme<> scheme_named(const std::string& name);
std::vector<std::string> names_of_schemes();

#endif // CGAL_PN_SUBDIVISION_3_TEST_SCHEME_NAMED_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_EXCLUSIONS_H
#define PN_SUBDIVIDE_EXCLUSIONS_H

#include <CLI/CLI.hpp>

namespace pn_subdivide {

// Throws Usage_error if options of a command that has been parsed exclude each other, and says why and what to do. What the
// schemes and the data do not allow is found where they are known.
void require_no_exclusions(const CLI::App& command);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_EXCLUSIONS_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_FILE_CONTENT_H
#define PN_SUBDIVIDE_FILE_CONTENT_H

#include <string>

namespace pn_subdivide {

// All bytes of a file or, for "-", of standard input. Throws Error if there are none or they cannot be read; the message does not
// name the file.
std::string file_content(const std::string& file);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_FILE_CONTENT_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_XML_TEXT_H
#define PN_SUBDIVIDE_XML_TEXT_H

#include <string>

namespace pn_subdivide {

// Text as it stands between quotes in XML, whose files are UTF-8. What XML cannot hold, most control characters
// and bytes that are no UTF-8, becomes '?'.
std::string xml_text(const std::string& text);

// Does XML hold all of it?
bool is_xml_text(const std::string& text);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_XML_TEXT_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/Error.h"

#include <boost/algorithm/string/replace.hpp>

#include <new>

namespace pn_subdivide {

std::string message_of(const std::exception& e)
{
  const std::string library = "PN_subdivision_3: ";
  const std::string what = e.what();
  const bool is_of_library = what.find(library) != std::string::npos;
  // what std::vector says of sizes that it cannot have is for programmers
  if (dynamic_cast<const std::bad_alloc*>(&e) ||
      (dynamic_cast<const std::length_error*>(&e) && !is_of_library))
    return "not enough memory";
  return boost::algorithm::replace_all_copy(what, library, "");
}

} // namespace pn_subdivide

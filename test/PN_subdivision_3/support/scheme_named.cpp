// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "Scheme_named.h"

#include <CGAL/PN_subdivision_3/schemes/scheme_by_name.h>

CGAL::PN_subdivision_3::Any_scheme<> scheme_named(const std::string& name)
{
  return CGAL::PN_subdivision_3::any_scheme(name);
}

std::vector<std::string> names_of_schemes()
{
  std::vector<std::string> result;
  CGAL::PN_subdivision_3::for_each_shipped_scheme(
    [&](const auto& scheme) { result.emplace_back(scheme.name()); });
  return result;
}

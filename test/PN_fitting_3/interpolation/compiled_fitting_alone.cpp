// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// A source of test_compiled_fitting.cpp that is not linked to the libraries: its macros are undefined. The schemes have types of their
// own, so that functions of users are not shared.

#include "compiled_fitting_cases.h"

#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>

namespace PN = CGAL::PN_subdivision_3;

namespace {

template <class Scheme>
struct Of_headers_alone : Scheme
{};

template <class Scheme>
std::vector<mesh_cases::Triple> by_headers(const mesh_cases::Soup& soup)
{
  using namespace compiled_fitting_cases;
  const Of_headers_alone<Scheme> scheme;
  std::vector<mesh_cases::Triple> all = interpolated(soup, scheme);
  const auto add = [&](const std::vector<mesh_cases::Triple>& more) {
    all.insert(all.end(), more.begin(), more.end());
  };
  for (const bool is_sharp : {false, true})
    add(interpolated_with_creases(soup, PN::linear(scheme), is_sharp).points);
  add(prescribed(soup, scheme));
  add(prescribed(soup, PN::linear(scheme)));
  return all;
}

} // namespace

std::vector<mesh_cases::Triple> fitted_by_headers(bool is_cube)
{
  static_assert(!PN::internal::is_linked_to_fitting && !PN::internal::is_linked_to_library);
  return is_cube ? by_headers<PN::CatmullClark_scheme>(mesh_cases::cube())
                 : by_headers<PN::Loop_scheme>(mesh_cases::tetrahedron());
}

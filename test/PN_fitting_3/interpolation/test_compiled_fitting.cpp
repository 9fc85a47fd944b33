// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// What the library PN_subdivision_3_fitting has the code of gives the same bits as the headers.

#include "compiled_fitting_cases.h"

#include <CGAL/PN_subdivision_3/schemes/Any_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>

namespace PN = CGAL::PN_subdivision_3;
using namespace compiled_fitting_cases;

std::vector<mesh_cases::Triple> fitted_by_headers(bool is_cube); // compiled_fitting_alone.cpp

namespace {

// the same in the same order; surfaces with creases shall be met
template <class Scheme>
std::vector<mesh_cases::Triple> fitted(const mesh_cases::Soup& soup, const Scheme& scheme)
{
  static_assert(PN::internal::is_linked_to_fitting);
  std::vector<mesh_cases::Triple> all = interpolated(soup, scheme);
  const auto add = [&](const std::vector<mesh_cases::Triple>& more) {
    all.insert(all.end(), more.begin(), more.end());
  };
  for (const bool is_sharp : {false, true}) {
    const Interpolated creased = interpolated_with_creases(soup, PN::linear(scheme), is_sharp);
    EXPECT_GT(creased.report.steps, 0u);
    EXPECT_LE(creased.report.residual, creased.report.tolerance);
    add(creased.points);
  }
  add(prescribed(soup, scheme));
  add(prescribed(soup, PN::linear(scheme)));
  return all;
}

TEST(Compiled_fitting, IsThatOfTheHeaders)
{
  const PN::CatmullClark_scheme quads;
  const auto of_cube = fitted_by_headers(true);
  EXPECT_EQ(of_cube, fitted(mesh_cases::cube(), quads));
  EXPECT_EQ(of_cube, fitted(mesh_cases::cube(), PN::Any_scheme<>(quads)));
  const PN::Loop_scheme triangles;
  const auto of_tetrahedron = fitted_by_headers(false);
  EXPECT_EQ(of_tetrahedron, fitted(mesh_cases::tetrahedron(), triangles));
  EXPECT_EQ(of_tetrahedron, fitted(mesh_cases::tetrahedron(), PN::Any_scheme<>(triangles)));
}

} // namespace

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
// Points and normals of a surface as control data: the orders of the manual's page "Approximation Order", by
// nets that shrink. The surface is known in closed form; no digits of errors are compared.

#include "../../examples/PN_certificates_3/Order_curves.h"
#include "../../examples/PN_certificates_3/Order_limits.h"

#include <CGAL/PN_curves/masks/curve_masks.h>
#include <CGAL/PN_subdivision_3/schemes/Any_scheme.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace {

namespace PN = CGAL::PN_subdivision_3;
using namespace order_samples;

const std::vector<double> lengths = {.02, .01};

double surface_order(const Layout& layout, const std::string& scheme, bool is_linear = false)
{
  return order(errors(layout, PN::any_scheme(scheme), is_linear, lengths));
}

TEST(Approximation_order, IsFourOnSmoothRegularLayouts)
{
  for (const char* name : {"catmull-clark", "kobbelt"})
    EXPECT_NEAR(surface_order(grid(false), name), 4, .25) << name;
  for (const char* name : {"loop", "butterfly"})
    EXPECT_NEAR(surface_order(grid(true), name), 4, .25) << name;
}

// their third moments do not vanish
TEST(Approximation_order, IsThreeOnSmoothLayoutsForDooSabinAndSqrt3)
{
  for (const char* name : {"doo-sabin", "sqrt3"}) {
    const double found = surface_order(grid(name[0] == 's'), name);
    EXPECT_GT(found, 2.8) << name;
    EXPECT_LT(found, 3.75) << name;
  }
}

TEST(Approximation_order, IsThreeOnUnevenLayouts)
{
  for (const char* name :
       {"catmull-clark", "modified-catmull-clark", "ct-catmull-clark", "kobbelt", "doo-sabin"})
    EXPECT_NEAR(surface_order(grid(false, .3), name), 3, .3) << name;
  for (const char* name : {"loop", "modified-loop", "ct-loop", "butterfly", "sqrt3"})
    EXPECT_NEAR(surface_order(grid(true, .3), name), 3, .3) << name;
}

TEST(Approximation_order, IsThreeAtExtraordinaryVertices)
{
  for (const char* name : {"catmull-clark", "modified-catmull-clark"})
    for (unsigned valence : {3u, 5u})
      EXPECT_NEAR(surface_order(sectors(false, valence), name), 3, .3) << name << valence;
  for (const char* name : {"loop", "butterfly"})
    EXPECT_NEAR(surface_order(sectors(true, 4), name), 3, .3) << name;
}

TEST(Approximation_order, OfLinearSubdivisionIsTwo)
{
  EXPECT_NEAR(surface_order(grid(false), "catmull-clark", true), 2, .15);
  EXPECT_NEAR(surface_order(grid(true, .3), "loop", true), 2, .15);
  EXPECT_NEAR(surface_order(grid(false, .3), "kobbelt", true), 2, .15);
}

// but four for interpolating schemes on smooth layouts
TEST(Approximation_order, OfLinearInterpolationIsFourOnSmoothLayouts)
{
  EXPECT_NEAR(surface_order(grid(false), "kobbelt", true), 4, .25);
  EXPECT_NEAR(surface_order(grid(true), "butterfly", true), 4, .25);
}

TEST(Approximation_order, OfCurves)
{
  const auto curve_order = [](const auto& mask, bool smooth, bool is_linear) {
    return order(curve_errors(mask, lengths, smooth, is_linear));
  };
  const PN::B_spline_mask cubic(3);
  const PN::Dubuc_Deslauriers_mask four(4);
  EXPECT_NEAR(curve_order(cubic, true, false), 4, .25);
  EXPECT_NEAR(curve_order(cubic, false, false), 3, .3);
  EXPECT_NEAR(curve_order(cubic, true, true), 2, .15);
  EXPECT_NEAR(curve_order(PN::B_spline_mask(2), true, false), 3, .4);
  EXPECT_NEAR(curve_order(four, true, true), 4, .25);
  EXPECT_NEAR(curve_order(four, false, false), 3, .3);
  EXPECT_NEAR(curve_order(four, false, true), 2, .2);
  // other weights for normals than for points cost the third order
  EXPECT_LT(curve_order(PN::with_normal_mask(cubic, four), false, false), 2.5);
}

} // namespace

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// All schemes, described for the typed tests. A scheme is tested by its entry in `Schemes`, and by nothing else.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_SCHEMES_H
#define CGAL_PN_SUBDIVISION_3_TEST_SCHEMES_H

#include "Extent.h"
#include "Scheme_description.h"
#include "reference/Butterfly.h"
#include "reference/Curvature_transfer.h"
#include "reference/DooSabin.h"
#include "reference/Kobbelt.h"
#include "reference/Sqrt3.h"
#include "reference/Upsampling.h"
#include "reference/modified_CatmullClark.h"
#include "reference/modified_Loop.h"

#include <CGAL/PN_subdivision_3/schemes/shipped_schemes.h>

#include <gtest/gtest.h>

#include <string_view>

struct DooSabin_description
  : Scheme_of_reference<CGAL::PN_subdivision_3::DooSabin_scheme, reference::doo_sabin>
{
  static constexpr bool takes_valence_2 = false;
  static constexpr bool is_primal = false;
  static constexpr unsigned rounds_of_reproduction = 4;
  using Cgal = ::DooSabin;
};

struct Sqrt3_description : Scheme_description
{
  static constexpr std::size_t degree = 3;
  static constexpr bool composes_single_rounds = false;
  static constexpr unsigned rounds_of_reproduction = 5;
  static constexpr double growth = 3;
  using Cgal = ::Sqrt3;
  static auto scheme() { return CGAL::PN_subdivision_3::Sqrt3_scheme(); }
  static reference::Refined refine(const reference::Face_list& mesh, unsigned round)
  {
    return reference::sqrt3(mesh, round);
  }
};

struct Butterfly_description
  : Scheme_of_reference<CGAL::PN_subdivision_3::Butterfly_scheme, reference::butterfly>
{
  static constexpr std::size_t degree = 3;
  static constexpr bool is_interpolatory = true;
  static constexpr bool takes_valence_2 = false;
  static constexpr unsigned rounds_of_reproduction = 4;
};

struct Kobbelt_description
  : Scheme_of_reference<CGAL::PN_subdivision_3::Kobbelt_scheme, reference::kobbelt, 1>
{
  static constexpr std::size_t degree = 4;
  static constexpr bool is_interpolatory = true;
  static constexpr bool takes_valence_2 = false;
  static constexpr unsigned rounds_of_reproduction = 4;
};

struct Modified_CatmullClark_description
  : Scheme_of_reference<CGAL::PN_subdivision_3::CatmullClark_scheme::Tuned,
                        reference::modified_catmull_clark, 8>
{};

struct Modified_Loop_description
  : Scheme_of_reference<CGAL::PN_subdivision_3::Loop_scheme::Tuned, reference::modified_loop, 8>
{
  static constexpr std::size_t degree = 3;
};

template <class Scheme, auto refined, bool of_quads>
struct Transfer_description : Scheme_of_reference<Scheme, refined, 0>
{
  static constexpr bool is_linear_for_equal_normals = false;
  static constexpr bool takes_intervals = false;
  static void finish_round(const reference::Face_list& mesh, reference::Values& values)
  {
    reference::transfer_curvature(mesh, of_quads, values);
  }
};

struct Ct_CatmullClark_description
  : Transfer_description<CGAL::PN_subdivision_3::CatmullClark_scheme::Transfer,
                         reference::modified_catmull_clark, true>
{};

struct Ct_Loop_description : Transfer_description<CGAL::PN_subdivision_3::Loop_scheme::Transfer,
                                                  reference::modified_loop, false>
{
  static constexpr std::size_t degree = 3;
};

struct Midpoint_description
  : Scheme_of_reference<CGAL::PN_subdivision_3::Midpoint_scheme, reference::midpoint>
{
  static constexpr std::size_t degree = 3;
  static constexpr bool is_interpolatory = true;
};

struct Bilinear_description
  : Scheme_of_reference<CGAL::PN_subdivision_3::Bilinear_scheme, reference::bilinear>
{
  static constexpr bool is_interpolatory = true;
};

using Schemes = testing::Types<CatmullClark_description, Loop_description, DooSabin_description,
                               Sqrt3_description, Butterfly_description, Kobbelt_description,
                               Modified_CatmullClark_description, Modified_Loop_description,
                               Ct_CatmullClark_description, Ct_Loop_description,
                               Midpoint_description, Bilinear_description>;

// Those that are tested with other number types than double and other meshes than Surface_mesh: one of quads
// and the one of triangles that has all that a scheme can have.
using Schemes_elsewhere =
  In_full<Schemes, testing::Types<CatmullClark_description, Ct_Loop_description>>;

// A scheme that is shipped has a description, and one alone has its name.
template <class Scheme, class... Descriptions>
constexpr bool is_described(testing::Types<Descriptions...>)
{
  const std::string_view name = Scheme::name();
  return (int(std::is_same_v<Scheme, decltype(Descriptions::scheme())>) + ...) == 1 &&
         (int(name == decltype(Descriptions::scheme())::name()) + ...) == 1;
}
template <class... Schemes_>
constexpr bool are_described(CGAL::PN_subdivision_3::Scheme_list<Schemes_...>)
{
  return (is_described<Schemes_>(Schemes()) && ...);
}
static_assert(are_described(CGAL::PN_subdivision_3::Shipped_schemes()),
              "a shipped scheme has no description here, or the name of another one");

#endif // CGAL_PN_SUBDIVISION_3_TEST_SCHEMES_H

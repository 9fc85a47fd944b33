// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// A scheme, described for the typed tests: what a test may expect of it, what it is compared with. Here are the two that most
// tests use, so that these are not compiled again when another one changes; Schemes.h has all.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_SCHEME_DESCRIPTION_H
#define CGAL_PN_SUBDIVISION_3_TEST_SCHEME_DESCRIPTION_H

#include "Test_meshes.h"
#include "reference/CatmullClark.h"
#include "reference/Loop.h"
#include "reference/PN_rule.h"

#include <CGAL/PN_cgal_masks_3/PN_mask_3.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>

#include <CGAL/subdivision_method_3.h>

#include <boost/core/demangle.hpp>

#include <type_traits>
#include <typeinfo>

// CGAL's masks, each with its host.
#define PN_MASK_OF_CGAL(NAME, HOST, TRIANGLES)                                                     \
  struct NAME                                                                                      \
  {                                                                                                \
    static constexpr bool triangles = TRIANGLES;                                                   \
    template <class Mesh, class Map>                                                               \
    static auto mask(const Mesh& mesh, const Map& map)                                             \
    {                                                                                              \
      return CGAL::PN_subdivision_3::make_PN_mask_3<CGAL::NAME##_mask_3>(mesh, map);               \
    }                                                                                              \
    template <class Mesh, class Mask, class NP>                                                    \
    static void host(Mesh& mesh, const Mask& pn_mask, const NP& np)                                \
    {                                                                                              \
      CGAL::Subdivision_method_3::HOST(mesh, pn_mask, np);                                         \
    }                                                                                              \
  };

PN_MASK_OF_CGAL(CatmullClark, PQQ, false)
PN_MASK_OF_CGAL(Loop, PTQ, true)
PN_MASK_OF_CGAL(DooSabin, DQQ, false)
PN_MASK_OF_CGAL(Sqrt3, Sqrt3, true)

#undef PN_MASK_OF_CGAL

// What most schemes have in common; a description overrides what differs.
struct Scheme_description
{
  // degree of the faces it takes, 0: any
  static constexpr std::size_t degree = 0;
  // old vertices come first, those without edges are kept
  static constexpr bool is_primal = true;
  // old points and normals are kept
  static constexpr bool is_interpolatory = false;
  // has a rule for interior vertices of valence 2
  static constexpr bool takes_valence_2 = true;
  // k calls with one round are one call with k rounds
  static constexpr bool composes_single_rounds = true;
  // after how many rounds spheres and cylinders are measured
  static constexpr unsigned rounds_of_reproduction = 6;
  // by how much at least a round multiplies the faces of a closed mesh of its kind, about
  static constexpr double growth = 4;
  // where all normals are equal it is its linear twin
  static constexpr bool is_linear_for_equal_normals = true;
  // intervals enclose the result, and normals are as exact as the number type
  static constexpr bool takes_intervals = true;
  // CGAL's mask in its host
  using Cgal = void;
  // what comes after a point-normal round on `mesh`, for the values of the new vertices
  static void finish_round(const reference::Face_list& /*mesh*/, reference::Values& /*values*/) {}
};

// a scheme whose reference does not know the round, but a parameter in some, which is given in sixteenths
template <class Scheme, auto refined, int... sixteenths>
struct Scheme_of_reference : Scheme_description
{
  static auto scheme() { return Scheme(); }
  static reference::Refined refine(const reference::Face_list& mesh, unsigned /*round*/)
  {
    return refined(mesh, reference::Real(sixteenths) / 16 ...);
  }
};

struct CatmullClark_description
  : Scheme_of_reference<CGAL::PN_subdivision_3::CatmullClark_scheme, reference::catmull_clark>
{
  using Cgal = ::CatmullClark;
};

struct Loop_description : Scheme_of_reference<CGAL::PN_subdivision_3::Loop_scheme, reference::loop>
{
  static constexpr std::size_t degree = 3;
  using Cgal = ::Loop;
};

// The names of the schemes in the output.
struct Scheme_names
{
  template <class Description>
  static std::string GetName(int)
  {
    return boost::core::demangle(typeid(Description::scheme()).name())
      .substr(std::string("CGAL::PN_subdivision_3::").size());
  }
};

template <class Description>
bool takes(const test_meshes::Control_mesh& mesh)
{
  return Description::degree == 0 || test_meshes::all_faces_have_degree(mesh, Description::degree);
}

template <class Description>
std::vector<test_meshes::Control_mesh> meshes_for()
{
  std::vector<test_meshes::Control_mesh> result;
  for (const test_meshes::Control_mesh& mesh : test_meshes::all())
    if (takes<Description>(mesh)) result.push_back(mesh);
  return result;
}

template <class Description>
constexpr bool has_cgal_peer = !std::is_void_v<typename Description::Cgal>;

// CGAL's hosts turn vertices without edges into NaN.
template <class Description>
std::vector<test_meshes::Control_mesh> meshes_for_cgal()
{
  std::vector<test_meshes::Control_mesh> result;
  for (const test_meshes::Control_mesh& mesh : meshes_for<Description>())
    if (!test_meshes::has_isolated_vertex(mesh)) result.push_back(mesh);
  return result;
}

#endif // CGAL_PN_SUBDIVISION_3_TEST_SCHEME_DESCRIPTION_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_COMPILED_LEVELS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_COMPILED_LEVELS_H

// What is computed of levels is the same for all meshes, maps and kernels of a number type. For double the library
// CGAL::PN_subdivision_3_double has it (src/PN_subdivision_3_double), and what is linked to it does not compile it again: EXTERN is
// `extern` there, and nothing in the library.

#include <CGAL/PN_subdivision_3/hosts/DQQ_host.h>
#include <CGAL/PN_subdivision_3/hosts/PQQ_host.h>
#include <CGAL/PN_subdivision_3/hosts/PTQ_host.h>
#include <CGAL/PN_subdivision_3/hosts/Sqrt3_host.h>
#include <CGAL/PN_subdivision_3/internal/creases/Wedge_estimation.h>
#include <CGAL/PN_subdivision_3/internal/creases/ended_creases.h>
#include <CGAL/PN_subdivision_3/internal/creases/make_creases.h>
#include <CGAL/PN_subdivision_3/internal/normals/estimate_normals.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Level_refiner.h>
#include <CGAL/PN_subdivision_3/internal/schemes/Scheme_on_host.h>
#include <CGAL/PN_subdivision_3/internal/schemes/scheme_of_call.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>

#include <vector>

// The schemes as scheme_of_rounds() makes them, for which the libraries have what is computed of levels.
namespace CGAL::PN_subdivision_3::internal::compiled_once {

using Any_of_quads = With_roundness<Scheme_on_host<PQQ_host, double>, double>;
using Any_of_triangles = With_roundness<Scheme_on_host<PTQ_host, double>, double>;
using Any_of_corners = With_roundness<Scheme_on_host<DQQ_host, double>, double>;
using Any_of_sqrt3 = With_roundness<Scheme_on_host<Sqrt3_host, double>, double>;
using Linear_of_quads = Linear_scheme<Scheme_on_host<PQQ_host, double>>;
using Linear_of_triangles = Linear_scheme<Scheme_on_host<PTQ_host, double>>;
using Linear_of_corners = Linear_scheme<Scheme_on_host<DQQ_host, double>>;
using Linear_of_sqrt3 = Linear_scheme<Scheme_on_host<Sqrt3_host, double>>;

template <class Scheme>
using Average = Average_of_scheme<Scheme, double>;
template <class Scheme>
using Value = typename Average<Scheme>::Value;

} // namespace CGAL::PN_subdivision_3::internal::compiled_once

#define CGAL_PN_SUBDIVISION_3_CONTROL_LEVELS(EXTERN)                                               \
  EXTERN template void estimate_normals_of(const Level_connectivity&, Control_normal_estimate,     \
                                           std::vector<Point_normal<double, 3>>&,                  \
                                           const std::vector<bool>*);                              \
  EXTERN template class Make_creases<double>;                                                      \
  EXTERN template void make_control_tangents(const Level_connectivity&, Creases<double>&,          \
                                             const std::vector<Point_normal<double, 3>>&,          \
                                             const std::vector<bool>&, bool);                      \
  EXTERN template void estimate_wedges(const Level_connectivity&, Creases<double>&,                \
                                       std::vector<Point_normal<double, 3>>&, std::vector<bool>,   \
                                       Control_normal_estimate);                                   \
  EXTERN template void keep_without_fractions<double>(                                             \
    const Level_connectivity&, Creases<double>&,                                                   \
    Function_ref<std::vector<Point_normal<double, 3>>(Creases<double>&)>);
#define CGAL_PN_SUBDIVISION_3_ROUNDS(EXTERN, SCHEME)                                               \
  EXTERN template class Round<compiled_once::SCHEME,                                               \
                              compiled_once::Average<compiled_once::SCHEME>>;                      \
  EXTERN template class Level_refiner<compiled_once::SCHEME,                                       \
                                      compiled_once::Average<compiled_once::SCHEME>, No_creases>;
#define CGAL_PN_SUBDIVISION_3_CREASED_ROUNDS(EXTERN, SCHEME)                                       \
  CGAL_PN_SUBDIVISION_3_ROUNDS(EXTERN, SCHEME)                                                     \
  EXTERN template class Crease_round<                                                              \
    compiled_once::SCHEME, compiled_once::Average<compiled_once::SCHEME>, Creases<double>>;        \
  EXTERN template class Level_refiner<                                                             \
    compiled_once::SCHEME, compiled_once::Average<compiled_once::SCHEME>, Creases<double>>;
#define CGAL_PN_SUBDIVISION_3_LEVELS(EXTERN)                                                       \
  CGAL_PN_SUBDIVISION_3_CREASED_ROUNDS(EXTERN, Any_of_quads)                                       \
  CGAL_PN_SUBDIVISION_3_CREASED_ROUNDS(EXTERN, Any_of_triangles)                                   \
  CGAL_PN_SUBDIVISION_3_ROUNDS(EXTERN, Any_of_corners)                                             \
  CGAL_PN_SUBDIVISION_3_ROUNDS(EXTERN, Any_of_sqrt3)                                               \
  CGAL_PN_SUBDIVISION_3_CREASED_ROUNDS(EXTERN, Linear_of_quads)                                    \
  CGAL_PN_SUBDIVISION_3_CREASED_ROUNDS(EXTERN, Linear_of_triangles)                                \
  CGAL_PN_SUBDIVISION_3_ROUNDS(EXTERN, Linear_of_corners)                                          \
  CGAL_PN_SUBDIVISION_3_ROUNDS(EXTERN, Linear_of_sqrt3)                                            \
  EXTERN template Erased_scheme<double> erased_scheme(const CatmullClark_scheme&);                 \
  EXTERN template Erased_scheme<double> erased_scheme(const Loop_scheme&);

#ifdef CGAL_PN_SUBDIVISION_3_DOUBLE
namespace CGAL::PN_subdivision_3::internal {

CGAL_PN_SUBDIVISION_3_CONTROL_LEVELS(extern)
CGAL_PN_SUBDIVISION_3_LEVELS(extern)

} // namespace CGAL::PN_subdivision_3::internal
#endif

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_COMPILED_LEVELS_H

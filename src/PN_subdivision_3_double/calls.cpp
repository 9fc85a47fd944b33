// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The usual calls of subdivide(), see internal/calls/Mesh_subdivision.h.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/PN_subdivision_3/internal/calls/Mesh_subdivision.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/DooSabin_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Sqrt3_scheme.h>
#include <CGAL/PN_subdivision_3/subdivide.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

namespace CGAL::PN_subdivision_3::internal {

// on its host, of which the library has the rounds; without edges where a scheme has no rules for creases
template <class Mesh, class Scheme, class Point_map, class Normal_map, class Edge_map>
void compiled_call(Mesh& mesh, const Scheme& scheme, unsigned rounds,
                   Function_ref<void(unsigned, std::size_t)> round_done, Point_map points,
                   Normal_map normals, Edge_map edges,
                   const Any_attributes<Surface_mesh_access<Mesh>>& attributes)
{
  using On_host = Scheme_on_host<typename Scheme::Host, double>;
  [[maybe_unused]] constexpr Not_given no_map{};
  [[maybe_unused]] Surface_mesh_access<Mesh> access(mesh);
  if constexpr (!std::is_same_v<Scheme, On_host>)
    compiled_call(mesh, On_host(scheme), rounds, round_done, points, normals, edges, attributes);
  else if constexpr (is_there_v<Edge_map> && !Has_crease_rules<Scheme>::value) {
    require_crease_rules(scheme, access, normals, edges, no_map);
    compiled_call(mesh, scheme, rounds, round_done, points, normals, no_map, attributes);
  } else {
    using Rounded = With_roundness<Scheme, double>;
    const Given_roundness<double> none;
    const Rounded rounded{{scheme}, &none, !is_there_v<Normal_map>};
    Mesh_subdivision<Sequential_tag, Rounded, double>(rounded, rounds, round_done)(
      access, points, normals, Not_given(), edges, no_map, attributes);
  }
}

template <class Kernel>
using Mesh_of = Surface_mesh<typename Kernel::Point_3>;

#define CGAL_PN_SUBDIVISION_3_CALL(KERNEL, NORMALS, EDGES, ...)                                    \
  template void compiled_call(Mesh_of<KERNEL>&, const __VA_ARGS__&, unsigned,                      \
                              Function_ref<void(unsigned, std::size_t)>,                           \
                              boost::property_map<Mesh_of<KERNEL>, vertex_point_t>::type, NORMALS, \
                              EDGES, const Any_attributes<Surface_mesh_access<Mesh_of<KERNEL>>>&);
#define CGAL_PN_SUBDIVISION_3_CALLS(KERNEL, EDGES, ...)                                            \
  CGAL_PN_SUBDIVISION_3_CALL(KERNEL, Usual_normal_map<Mesh_of<KERNEL>>, EDGES, __VA_ARGS__)        \
  CGAL_PN_SUBDIVISION_3_CALL(KERNEL, Not_given, EDGES, __VA_ARGS__)
#define CGAL_PN_SUBDIVISION_3_CALLS_OF(...)                                                        \
  CGAL_PN_SUBDIVISION_3_CALLS(Simple_cartesian<double>, Not_given, __VA_ARGS__)                    \
  CGAL_PN_SUBDIVISION_3_CALLS(Simple_cartesian<double>,                                            \
                              Usual_edge_map<Mesh_of<Simple_cartesian<double>>>, __VA_ARGS__)      \
  CGAL_PN_SUBDIVISION_3_CALLS(Epick, Not_given, __VA_ARGS__)                                       \
  CGAL_PN_SUBDIVISION_3_CALLS(Epick, Usual_edge_map<Mesh_of<Epick>>, __VA_ARGS__)
#define CGAL_PN_SUBDIVISION_3_CALLS_ON(HOST, SCHEME)                                               \
  CGAL_PN_SUBDIVISION_3_CALLS_OF(Scheme_on_host<HOST, double>)                                     \
  CGAL_PN_SUBDIVISION_3_CALLS_OF(SCHEME)

CGAL_PN_SUBDIVISION_3_CALLS_ON(PQQ_host, CatmullClark_scheme)
CGAL_PN_SUBDIVISION_3_CALLS_ON(PTQ_host, Loop_scheme)
CGAL_PN_SUBDIVISION_3_CALLS_ON(DQQ_host, DooSabin_scheme)
CGAL_PN_SUBDIVISION_3_CALLS_ON(Sqrt3_host, Sqrt3_scheme)

} // namespace CGAL::PN_subdivision_3::internal

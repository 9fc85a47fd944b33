// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The usual calls of subdivide(), see internal/meshes/compiled_call.h.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/PN_subdivision_3/internal/meshes/compiled_call.h>
#include <CGAL/PN_subdivision_3/parameters/parameters.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/DooSabin_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Sqrt3_scheme.h>
#include <CGAL/PN_subdivision_3/subdivide.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

namespace CGAL::PN_subdivision_3::internal {

using Rounds_done = Function_ref<void(unsigned, std::size_t)>;

struct Compiled_call_visitor
{
  void round_done(unsigned round, std::size_t faces) const { done(round, faces); }
  Rounds_done done;
};

// as any scheme on its host, of which the library has the rounds
template <class Mesh, class Scheme, class Point_map, class Normal_map, class Edge_map>
void compiled_call(Mesh& mesh, const Scheme& typed_scheme, unsigned rounds, Rounds_done round_done,
                   Point_map points, Normal_map normals, Edge_map edges)
{
  const Scheme_on_host<typename Scheme::Host, double> scheme(typed_scheme);
  const auto with_edges = [&](const auto& np) {
    if constexpr (std::is_same_v<Edge_map, No_constraint_map>)
      subdivide(mesh, scheme, np);
    else
      subdivide(mesh, scheme, np.edge_is_constrained_map(edges));
  };
  const auto all = CGAL::parameters::number_of_iterations(rounds).vertex_point_map(points).visitor(
    Compiled_call_visitor{round_done});
  if constexpr (std::is_same_v<Normal_map, No_normal_map>)
    with_edges(all);
  else
    with_edges(all.vertex_normal_map(normals));
}

template <class Kernel>
using Mesh_of = Surface_mesh<typename Kernel::Point_3>;
template <class Kernel>
using Points_of = typename boost::property_map<Mesh_of<Kernel>, vertex_point_t>::type;

#define CGAL_PN_SUBDIVISION_3_CALL(KERNEL, SCHEME, NORMALS, EDGES)                                 \
  template void compiled_call(Mesh_of<KERNEL>&, const SCHEME&, unsigned, Rounds_done,              \
                              Points_of<KERNEL>, NORMALS, EDGES);
#define CGAL_PN_SUBDIVISION_3_CALLS(KERNEL, SCHEME, EDGES)                                         \
  CGAL_PN_SUBDIVISION_3_CALL(KERNEL, SCHEME, Usual_normal_map<Mesh_of<KERNEL>>, EDGES)             \
  CGAL_PN_SUBDIVISION_3_CALL(KERNEL, SCHEME, No_normal_map, EDGES)
#define CGAL_PN_SUBDIVISION_3_CALLS_OF(KERNEL)                                                     \
  CGAL_PN_SUBDIVISION_3_CALLS(KERNEL, CatmullClark_scheme, No_constraint_map)                      \
  CGAL_PN_SUBDIVISION_3_CALLS(KERNEL, CatmullClark_scheme, Usual_edge_map<Mesh_of<KERNEL>>)        \
  CGAL_PN_SUBDIVISION_3_CALLS(KERNEL, Loop_scheme, No_constraint_map)                              \
  CGAL_PN_SUBDIVISION_3_CALLS(KERNEL, Loop_scheme, Usual_edge_map<Mesh_of<KERNEL>>)                \
  CGAL_PN_SUBDIVISION_3_CALLS(KERNEL, DooSabin_scheme, No_constraint_map)                          \
  CGAL_PN_SUBDIVISION_3_CALLS(KERNEL, Sqrt3_scheme, No_constraint_map)

CGAL_PN_SUBDIVISION_3_CALLS_OF(Simple_cartesian<double>)
CGAL_PN_SUBDIVISION_3_CALLS_OF(Epick)

} // namespace CGAL::PN_subdivision_3::internal

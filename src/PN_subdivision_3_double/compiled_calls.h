// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVISION_3_DOUBLE_COMPILED_CALLS_H
#define PN_SUBDIVISION_3_DOUBLE_COMPILED_CALLS_H

// What the library has the code of: see internal/meshes/compiled_call.h. It is compiled without the macro, as any other program.
#ifdef CGAL_PN_SUBDIVISION_3_DOUBLE
#  error "CGAL_PN_SUBDIVISION_3_DOUBLE is for what is linked to the library"
#endif

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/PN_subdivision_3/internal/meshes/compiled_call.h>
#include <CGAL/PN_subdivision_3/parameters/parameters.h>
#include <CGAL/PN_subdivision_3/subdivide.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

struct Compiled_call_visitor
{
  void round_done(unsigned round, std::size_t faces) const { done(round, faces); }
  Function_ref<void(unsigned, std::size_t)> done;
};

template <class Mesh, class Scheme, class Point_map, class Normal_map, class Edge_map>
void compiled_call(Mesh& mesh, const Scheme& scheme, unsigned rounds,
                   Function_ref<void(unsigned, std::size_t)> round_done, Point_map points,
                   Normal_map normals, Edge_map edges)
{
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

// the types of a call
template <class Kernel>
struct Usual
{
  using Mesh = Surface_mesh<typename Kernel::Point_3>;
  using Points = typename boost::property_map<Mesh, vertex_point_t>::type;
  using Normals = Usual_normal_map<Mesh>;
  using Edges = Usual_edge_map<Mesh>;
};
using Cartesian = Usual<Simple_cartesian<double>>;
using Inexact = Usual<Epick>;

using Rounds_done = Function_ref<void(unsigned, std::size_t)>;

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // PN_SUBDIVISION_3_DOUBLE_COMPILED_CALLS_H

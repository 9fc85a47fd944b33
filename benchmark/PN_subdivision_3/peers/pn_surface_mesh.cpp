// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "Cgal_meshes.h"
#include "for_each_scheme.h"

#include <CGAL/PN_subdivision_3/subdivide.h>

#include <string>

namespace {

namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;

template <class Concurrency_tag, class Scheme>
Result subdivide_with_normals(const Scheme& scheme, const Control& control, unsigned rounds)
{
  Surface_mesh mesh = surface_mesh(control);
  const Normals normals = add_normals(mesh);
  Result result = timed([&] {
    PN::subdivide<Concurrency_tag>(mesh, scheme,
                                   params::number_of_iterations(rounds).vertex_normal_map(normals));
  });
  result.faces = mesh.number_of_faces();
  return result;
}

template <class Scheme>
Result subdivide_points(const Scheme& scheme, const Control& control, unsigned rounds)
{
  Surface_mesh mesh = surface_mesh(control);
  Result result =
    timed([&] { PN::subdivide(mesh, PN::linear(scheme), params::number_of_iterations(rounds)); });
  result.faces = mesh.number_of_faces();
  return result;
}

} // namespace

void add_pn_surface_mesh(Jobs& jobs)
{
  for_each_scheme([&](const std::string& name, const auto& scheme) {
    jobs["pn/surface-mesh/" + name] = [scheme](const Control& control, unsigned rounds,
                                               unsigned threads) {
#ifdef CGAL_LINKED_WITH_TBB
      if (threads > 1) {
        Result result;
        with_threads(threads, [&] {
          result = subdivide_with_normals<CGAL::Parallel_tag>(scheme, control, rounds);
        });
        return result;
      }
#endif
      return subdivide_with_normals<CGAL::Sequential_tag>(scheme, control, rounds);
    };
    jobs["pn-linear/surface-mesh/" + name] = [scheme](const Control& control, unsigned rounds,
                                                      unsigned) {
      return subdivide_points(scheme, control, rounds);
    };
  });
}

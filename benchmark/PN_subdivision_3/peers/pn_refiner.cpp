// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// All control points and normals are set once more, and the refined points and normals computed again.

#include "Cgal_meshes.h"

#include <CGAL/PN_subdivision_3/Surface_refiner.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>

#include <string>

namespace {

namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;

template <class Refiner>
Result update(Refiner& refiner, const Surface_mesh& mesh)
{
  for (const auto v : mesh.vertices()) refiner.set_point(v, refiner.control_point(v));
  Result result = timed([&] { refiner.update(); });
  result.faces = refiner.number_of_faces();
  return result;
}

template <class Concurrency_tag, class Scheme>
Result with_normals(const Scheme& scheme, const Control& control, unsigned rounds)
{
  Surface_mesh mesh = surface_mesh(control);
  const Normals normals = add_normals(mesh);
  PN::Surface_refiner<Surface_mesh, Scheme, Kernel, Concurrency_tag> refiner(
    mesh, scheme, params::number_of_iterations(rounds).vertex_normal_map(normals));
  return update(refiner, mesh);
}

template <class Concurrency_tag, class Scheme>
Result of_points(const Scheme& scheme, const Control& control, unsigned rounds)
{
  using Linear = decltype(PN::linear(scheme));
  const Surface_mesh mesh = surface_mesh(control);
  PN::Surface_refiner<Surface_mesh, Linear, Kernel, Concurrency_tag> refiner(
    mesh, PN::linear(scheme), params::number_of_iterations(rounds));
  return update(refiner, mesh);
}

template <class Scheme>
void add(Jobs& jobs, const std::string& name, const Scheme& scheme)
{
#ifdef CGAL_LINKED_WITH_TBB
  using Parallel_tag = CGAL::Parallel_tag;
#else
  using Parallel_tag = CGAL::Sequential_tag;
#endif
  jobs["pn/refiner/" + name] = [scheme](const Control& control, unsigned rounds, unsigned threads) {
    if (threads == 1) return with_normals<CGAL::Sequential_tag>(scheme, control, rounds);
    Result result;
    with_threads(threads, [&] { result = with_normals<Parallel_tag>(scheme, control, rounds); });
    return result;
  };
  jobs["pn-linear/refiner/" + name] = [scheme](const Control& control, unsigned rounds,
                                               unsigned threads) {
    if (threads == 1) return of_points<CGAL::Sequential_tag>(scheme, control, rounds);
    Result result;
    with_threads(threads, [&] { result = of_points<Parallel_tag>(scheme, control, rounds); });
    return result;
  };
}

} // namespace

void add_pn_refiner(Jobs& jobs)
{
  add(jobs, "catmull-clark", PN::CatmullClark_scheme());
  add(jobs, "loop", PN::Loop_scheme());
}

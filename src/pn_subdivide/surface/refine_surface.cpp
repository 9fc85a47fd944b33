// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/refine_surface.h"

#include "io/Error.h"
#include "surface/refine.h"

#include <utility>
#include <vector>

#ifdef CGAL_LINKED_WITH_TBB
#  include <tbb/global_control.h>
#endif

namespace pn_subdivide {

void require_threads(unsigned threads)
{
#ifdef CGAL_LINKED_WITH_TBB
  (void)threads;
#else
  if (threads > 1)
    throw Usage_error("--threads: this program was built without TBB and has one thread only");
#endif
}

namespace {

// of vertices without faces, which have no corner to read them from
struct Isolated_normals
{
  Isolated_normals(const Surface& surface, Normal_map normals)
  {
    for (const Surface::Vertex_index v : surface.vertices())
      if (surface.is_isolated(v)) of_vertices.emplace_back(v, normals[v]);
  }
  void put_back(Normal_map normals) const
  {
    for (const auto& [v, n] : of_vertices) normals[v] = n;
  }
  std::vector<std::pair<Surface::Vertex_index, Vector_3>> of_vertices;
};

void refine_with_creases(Surface& surface, const Scheme_choice& choice,
                         const Refinement& refinement)
{
  const Scheme scheme = make_scheme("--scheme", choice.scheme, choice);
  const Crease_maps& creases = *refinement.creases;
  std::optional<Normal_map> of_vertices = normals_of(surface);
  if (!of_vertices) return refine_linearly(surface, scheme, creases, refinement);
  const std::vector<Vector_3> of_corners = take_corner_normals(surface);
  const Isolated_normals isolated(surface, *of_vertices);
  const Wedge_normals normals{{&of_corners}, *of_vertices, refinement.wedges};
  if (choice.normal_scheme && *choice.normal_scheme != choice.scheme)
    refine_with_normal_scheme(surface, normals, scheme,
                              make_scheme("--normal-scheme", *choice.normal_scheme, choice),
                              creases, refinement);
  else
    refine_with_normals(surface, normals, scheme, creases, refinement);
  isolated.put_back(*of_vertices);
}

} // namespace

void refine_surface(Surface& surface, const Scheme_choice& choice, const Refinement& refinement)
{
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, refinement.threads);
#endif
  if (refinement.creases) return refine_with_creases(surface, choice, refinement);
  const Scheme scheme = make_scheme("--scheme", choice.scheme, choice);
  const std::optional<Normal_map> normals = normals_of(surface);
  if (!normals) return refine_linearly(surface, scheme, refinement);
  if (choice.normal_scheme && *choice.normal_scheme != choice.scheme)
    return refine_with_normal_scheme(surface, *normals, scheme,
                                     make_scheme("--normal-scheme", *choice.normal_scheme, choice),
                                     refinement);
  refine_with_normals(surface, *normals, scheme, refinement);
}

} // namespace pn_subdivide

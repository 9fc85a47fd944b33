// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/refine_surface.h"

#include <CGAL/PN_subdivision_3/internal/meshes/read_mesh.h>
#include <CGAL/PN_subdivision_3/internal/meshes/slot_normals.h>
#include <CGAL/PN_subdivision_3/internal/meshes/with_mesh_access.h>
#include <CGAL/PN_subdivision_3/parameters/parameters.h>
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#include <CGAL/PN_subdivision_3/schemes/Any_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Grid_CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/estimated_row_entries.h>
#include <CGAL/PN_subdivision_3/subdivide.h>

#include <utility>
#include <vector>

namespace pn_subdivide {
namespace {

constexpr double seconds_of_an_entry = 5e-9; // as measured, on a usual computer
constexpr unsigned large = 1000;

// Is there a vertex of large valence, or a face with many vertices?
bool has_large_rings(const Surface& surface)
{
  std::vector<unsigned> valence(surface.num_vertices(), 0), degree(surface.num_faces(), 0);
  for (const Halfedge h : surface.halfedges()) {
    if (++valence[surface.target(h)] >= large) return true;
    if (!surface.is_border(h) && ++degree[surface.face(h)] >= large) return true;
  }
  return false;
}

struct Round_visitor
{
  template <class Round, class Number>
  void round_done(Round k, Number faces) const
  {
    if (report) report(static_cast<unsigned>(k), static_cast<std::size_t>(faces));
  }

  std::function<void(unsigned, std::size_t)> report;
};

using Wedge_normals = PN::internal::Wedge_normals<Control_corner_normals, Normal_map>;

// of vertices without faces, which have no corner to read them from
struct Isolated_normals
{
  Isolated_normals(const Surface& surface, Normal_map normals)
  {
    for (const Vertex v : surface.vertices())
      if (surface.is_isolated(v)) of_vertices.emplace_back(v, normals[v]);
  }
  void put_back(Normal_map normals) const
  {
    for (const auto& [v, n] : of_vertices) normals[v] = n;
  }
  std::vector<std::pair<Vertex, Vector_3>> of_vertices;
};

// With one thread the result is the same as with several, bit for bit.
template <class S, class NamedParameters>
void refine(Surface& surface, const S& scheme, const Refinement& refinement,
            const NamedParameters& np)
{
  PN::subdivide<CGAL::Parallel_if_available_tag>(
    surface, scheme,
    PN::parameters::join(
      PN::parameters::attributes(*refinement.attributes),
      np.number_of_iterations(refinement.levels).visitor(Round_visitor{refinement.round_done})));
}

void refine_with_creases(Surface& surface, const Scheme_choice& choice,
                         const Refinement& refinement)
{
  const Crease_maps& creases = *refinement.creases;
  const auto sharp = PN::parameters::border(creases.border)
                       .edge_is_constrained_map(creases.edges)
                       .vertex_is_constrained_map(creases.vertices);
  std::optional<Normal_map> of_vertices = normals_of(surface);
  if (!of_vertices) {
    const Scheme scheme = scheme_of(choice);
    return refine(surface, PN::linear(scheme), refinement, sharp);
  }
  const std::vector<Corner_value> of_corners = take_corner_normals(surface);
  const Isolated_normals isolated(surface, *of_vertices);
  const Wedge_normals normals{
    {of_corners, creases.without_fractions}, *of_vertices, refinement.wedges};
  const Roundness_map roundness = roundness_or_added(surface); // edges that end change it
  refine(surface, scheme_with_normals(choice), refinement,
         PN::parameters::join(
           PN::parameters::vertex_roundness_map(roundness).crease_tangent_map(creases.tangents),
           sharp.vertex_normal_map(normals)));
  isolated.put_back(*of_vertices);
}

} // namespace

double expected_seconds(Surface& surface, const Scheme_choice& choice, unsigned levels)
{
  if (!has_large_rings(surface)) return 0;
  const PN::Level_connectivity level =
    PN::internal::checked_level(PN::internal::Surface_mesh_access<Surface>(surface));
  const auto entries = [&](const Scheme& scheme) {
    return PN::estimated_row_entries(scheme, level, levels);
  };
  double sum = entries(scheme_of(choice));
  if (choice.normal_scheme && *choice.normal_scheme != choice.scheme)
    sum += entries(make_scheme("--normal-scheme", *choice.normal_scheme, choice));
  return seconds_of_an_entry * sum;
}

void refine_surface(Surface& surface, const Scheme_choice& choice, const Refinement& refinement)
{
  if (refinement.creases) return refine_with_creases(surface, choice, refinement);
  const std::optional<Normal_map> normals = normals_of(surface);
  const bool is_grid = is_grid_scheme(choice.scheme);
  if (!normals && is_grid)
    return refine(surface, PN::linear(PN::CatmullClark_scheme::Grid()), refinement,
                  CGAL::parameters::default_values());
  if (!normals)
    return refine(surface, PN::linear(scheme_of(choice)), refinement,
                  CGAL::parameters::default_values());
  const auto refine_by = [&](const auto& scheme) {
    with_normals_of_vertices(surface, *normals,
                             [&](const auto& np) { refine(surface, scheme, refinement, np); });
  };
  if (is_grid)
    refine_by(PN::CatmullClark_scheme::Grid());
  else
    refine_by(scheme_with_normals(choice));
}

} // namespace pn_subdivide

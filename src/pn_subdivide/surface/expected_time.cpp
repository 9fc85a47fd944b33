// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/expected_time.h"

#include "surface/Scheme.h"

#include <CGAL/PN_subdivision_3/internal/meshes/Surface_mesh_access.h>
#include <CGAL/PN_subdivision_3/internal/meshes/read_mesh.h>
#include <CGAL/PN_subdivision_3/schemes/estimated_row_entries.h>

#include <vector>

namespace pn_subdivide {
namespace {

namespace PN = CGAL::PN_subdivision_3;

constexpr double seconds_of_an_entry = 5e-9; // as measured, on a usual computer
constexpr unsigned large = 1000;

// Is there a vertex of large valence, or a face with many vertices?
bool has_large_rings(const Surface& surface)
{
  std::vector<unsigned> valence(surface.num_vertices(), 0), degree(surface.num_faces(), 0);
  for (const Surface::Halfedge_index h : surface.halfedges()) {
    if (++valence[surface.target(h)] >= large) return true;
    if (!surface.is_border(h) && ++degree[surface.face(h)] >= large) return true;
  }
  return false;
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
  double sum = entries(make_scheme("--scheme", choice.scheme, choice));
  if (choice.normal_scheme && *choice.normal_scheme != choice.scheme)
    sum += entries(make_scheme("--normal-scheme", *choice.normal_scheme, choice));
  return seconds_of_an_entry * sum;
}

} // namespace pn_subdivide

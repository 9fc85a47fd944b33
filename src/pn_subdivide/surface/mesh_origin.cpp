// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/mesh_origin.h"

#include "surface/Scheme.h"
#include "surface/Surface.h"
#include "surface/replayed_rounds.h"

#include <CGAL/PN_subdivision_3/schemes/shipped_schemes.h>

#include <algorithm>

namespace pn_subdivide {
namespace {

namespace PN = CGAL::PN_subdivision_3;

// The first of the schemes that split faces as this one does.
std::string first_of_its_kind(const std::string& scheme)
{
  const Scheme chosen = make_scheme("--scheme", scheme, {});
  std::string first;
  PN::for_each_shipped_scheme([&](const auto& other) {
    if (first.empty() && chosen.has_host_of(make_scheme("--scheme", other.name(), {})))
      first = other.name();
  });
  return first;
}

bool has_border(const Surface& surface)
{
  const auto edges = surface.edges();
  return std::any_of(edges.begin(), edges.end(),
                     [&](Surface::Edge_index e) { return surface.is_border(e); });
}

Mesh_origin first_origin(const Mesh_data& mesh)
{
  Mesh_origin origin;
  origin.vertices = mesh.points.size();
  origin.corners.reserve(mesh.number_of_corners());
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
    origin.corners.insert(origin.corners.end(), mesh.face(f).begin(), mesh.face(f).end());
    origin.face_end.push_back(origin.corners.size());
  }
  return origin;
}

} // namespace

Mesh_origin origin_after(const Mesh_data& mesh, const std::string& scheme, unsigned rounds)
{
  Mesh_origin origin = replayed_rounds(mesh) ? mesh.origin : Mesh_origin();
  if (rounds == 0) return origin;
  if (!origin.any()) origin = first_origin(mesh);
  const std::string kind = first_of_its_kind(scheme);
  // on borders odd and even rounds of sqrt(3) differ, and each call begins with an odd one
  const bool goes_on =
    !origin.rounds.empty() && origin.rounds.back().scheme == kind &&
    (kind != "sqrt3" || origin.rounds.back().number % 2 == 0 || !has_border(make_surface(mesh)));
  if (goes_on)
    origin.rounds.back().number += rounds;
  else
    origin.rounds.push_back({kind, rounds});
  return origin;
}

} // namespace pn_subdivide

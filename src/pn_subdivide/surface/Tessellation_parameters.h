// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_TESSELLATION_PARAMETERS_H
#define PN_SUBDIVIDE_TESSELLATION_PARAMETERS_H

#include "surface/Scheme.h"
#include "surface/Surface.h"
#include "surface/creases.h"

#include <CGAL/PN_subdivision_3.h>

#include <optional>

namespace pn_subdivide {

// Returns f(scheme, named parameters) of a tessellation of the surface, but for attributes and bounds.
template <class Function>
auto with_tessellation_parameters(Surface& surface, const Scheme_choice& choice,
                                  const std::optional<Crease_maps>& creases, const Function& f)
{
  namespace PN = CGAL::PN_subdivision_3;
  const std::optional<Normal_map> of_vertices = normals_of(surface);
  const auto linear = [&] { return PN::linear(make_scheme("--scheme", choice.scheme, choice)); };
  if (!creases) {
    if (!of_vertices) return f(linear(), CGAL::parameters::default_values());
    const std::optional<Roundness_map> given = roundness_of(surface);
    const auto np = PN::parameters::vertex_roundness_map(given ? *given : add_roundness(surface))
                      .vertex_normal_map(*of_vertices);
    return with_scheme(choice, [&](const auto& scheme) { return f(scheme, np); });
  }
  const auto sharp = PN::parameters::border(creases->border)
                       .edge_is_constrained_map(creases->edges)
                       .vertex_is_constrained_map(creases->vertices);
  if (!of_vertices) return f(linear(), sharp);
  std::optional<Corner_normal_map> normals = corner_normals_of(surface);
  if (!normals) normals = add_corner_normals(surface);
  const auto np = PN::parameters::join(PN::parameters::crease_tangent_map(creases->tangents),
                                       sharp.vertex_normal_map(*normals));
  return with_scheme(choice, [&](const auto& scheme) { return f(scheme, np); });
}

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_TESSELLATION_PARAMETERS_H

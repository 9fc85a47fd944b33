// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "Refinement.h"

#include "Creased_refinement.h"
#include "Refiner_refinement.h"
#include "io/Error.h"

namespace pn_demo {

std::unique_ptr<Refinement> make_refinement(const Control_mesh& mesh, const Scheme& scheme,
                                            unsigned rounds, bool is_linear)
{
  using Linear = CGAL::PN_subdivision_3::Linear_scheme<Scheme>;
  const Linear linear = CGAL::PN_subdivision_3::linear(scheme);
  const bool is_creased = mesh.number_of_sharp_edges() > 0;
  const bool is_carrying = is_creased || !mesh.uv().empty();
  if (is_creased && !scheme.has_crease_rules())
    throw pn_subdivide::Error(scheme.name() + " subdivision has no rules for creases");
  if (is_carrying && !is_linear && !scheme.has_crease_rules())
    throw pn_subdivide::Error(
      scheme.name() + " subdivision takes no texture coordinates here, but if it is linear");
  if (is_linear && is_carrying)
    return std::make_unique<Creased_refinement<Linear, true>>(mesh, linear, rounds);
  if (is_linear) return std::make_unique<Refiner_refinement<Linear, true>>(mesh, linear, rounds);
  if (is_carrying || scheme.transfers_curvature())
    return std::make_unique<Creased_refinement<Scheme, false>>(mesh, scheme, rounds);
  return std::make_unique<Refiner_refinement<Scheme, false>>(mesh, scheme, rounds);
}

} // namespace pn_demo

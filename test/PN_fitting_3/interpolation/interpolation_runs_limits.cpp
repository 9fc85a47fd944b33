// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "Interpolation_runs.h"
#include "support/Options.h"

#include <CGAL/PN_subdivision_3/schemes/Tuned_CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Tuned_Loop_scheme.h>

namespace interpolation_cases {

template <class Scheme>
Limits Limit_runs<Scheme>::at(Surface_mesh& mesh, const Scheme& scheme,
                              const test_options::Limit_options& options)
{
  return limit_cases::limits(mesh, scheme, options);
}

template <class Scheme>
Limits Limit_runs<Scheme>::refined(Surface_mesh& mesh, const Scheme& scheme, unsigned rounds)
{
  using CGAL::parameters::vertex_normal_map;
  PN::subdivide(mesh, scheme, vertex_normal_map(normal_map(mesh)).number_of_iterations(rounds));
  test_options::Limit_options options;
  options.rounds_done = rounds;
  options.curvatures = true;
  return at(mesh, scheme, options);
}

template struct Limit_runs<PN::CatmullClark_scheme>;
template struct Limit_runs<PN::Loop_scheme>;
template struct Limit_runs<PN::CatmullClark_scheme::Tuned>;
template struct Limit_runs<PN::Loop_scheme::Tuned>;
template struct Limit_runs<PN::Linear_scheme<PN::CatmullClark_scheme>>;
template struct Limit_runs<PN::Linear_scheme<PN::CatmullClark_scheme::Tuned>>;
template struct Limit_runs<PN::Linear_scheme<PN::Loop_scheme::Tuned>>;

} // namespace interpolation_cases

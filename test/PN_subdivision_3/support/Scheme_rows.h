// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The rows of weights that the mask of a scheme writes.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_SCHEME_ROWS_H
#define CGAL_PN_SUBDIVISION_3_TEST_SCHEME_ROWS_H

#include "Scheme_runs.h"

// Calls f(new vertex, begin, end) with the entries of every row of round k in the number type FT.
template <class FT, class Scheme, class Function>
void for_each_row(Surface_mesh& mesh, const Scheme& scheme, unsigned k, const Function& f)
{
  namespace PN = CGAL::PN_subdivision_3;
  const PN::internal::Surface_mesh_access<Surface_mesh> access(mesh);
  const PN::Level_connectivity level = PN::internal::checked_level(access);
  using Host = typename Scheme::Host;
  const Host host(level, k);
  const auto mask = scheme.template mask<FT>(level, k);
  const std::uint64_t size = Host::refined_size(level.size(), k).vertices;
  for (PN::Level_connectivity::Index v = 0; v < size; ++v) {
    PN::internal::Stencil_block<FT> row;
    host.stencil(mask, v, row.row());
    row.close_row();
    f(v, row.begin(0), row.end(0));
  }
}

template <class FT, class Scheme>
void expect_rows_that_sum_to_one(Surface_mesh& mesh, const Scheme& scheme, unsigned k,
                                 const std::string& name)
{
  for_each_row<FT>(mesh, scheme, k, [&](std::size_t v, const auto* begin, const auto* end) {
    FT sum(0);
    for (const auto* e = begin; e != end; ++e) sum += e->weight;
    EXPECT_TRUE(sum == FT(1)) << name << ", round " << k << ", vertex " << v;
  });
}

#endif // CGAL_PN_SUBDIVISION_3_TEST_SCHEME_ROWS_H

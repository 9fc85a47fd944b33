// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Schemes x normals x creases x attributes: what subdivide_to_limit() carries is what subdivide() carries, by bytes, and
// what one of them refuses the other refuses. Each call has all maps and a table, whatever is in them, so that few types
// are compiled.

#include "Feature_matrix.h"

#include <CGAL/PN_subdivision_3/subdivide_to_limit.h>

#include <functional>

namespace {

using namespace feature_matrix;

// Points and normals at the limit do not depend on what is carried.
struct At_the_limit
{
  template <class Scheme, class Np>
  void operator()(Case& c, const Scheme& scheme, const Np& np) const
  {
    PN::Limit_options options;
    options.max_depth = 1;
    PN::subdivide_to_limit(c.mesh, scheme, options, np.visitor(std::ref(c.log)), c.table);
  }
};

template <class Normals>
void compare(const std::string& scheme, Crease_kind creases, const Normals& normals)
{
  std::vector<double> points;
  for (const Attribute_kind attributes : attribute_kinds) {
    SCOPED_TRACE(name(attributes));
    Case plain(scheme, creases, attributes), limit(scheme, creases, attributes);
    run(plain, normals, Plain());
    run(limit, normals, At_the_limit());
    expect_same_but_values(limit, plain);
    EXPECT_EQ(plain.error.empty(), is_known(scheme, creases, normals, attributes)) << plain.error;
    if (attributes == Attribute_kind::none) points = limit.values();
    if (limit.error.empty()) EXPECT_TRUE(same_bytes(limit.values(), points));
  }
}

TEST(Matrix_of_features, TheLimitCarriesWhatSubdivideCarries)
{
  for_each_cell([](const std::string& scheme, Crease_kind creases, const auto& normals) {
    if (PN::any_scheme(scheme).keeps_vertices()) compare(scheme, creases, normals);
  });
}

} // namespace

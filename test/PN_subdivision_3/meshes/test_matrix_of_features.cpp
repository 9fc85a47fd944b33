// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Schemes x normals x creases x attributes: what subdivide_to_limit() and a Surface_refiner carry is what subdivide()
// carries, by bytes, the points and normals of a refiner are those of subdivide(), and what one of them refuses the
// others refuse. Each call has all maps and a table, whatever is in them, so that few types
// are compiled.

#include "Extent.h"
#include "Feature_matrix.h"
#include "support/Options.h"

#include <CGAL/PN_limit_surface_3/subdivide_to_limit.h>
#include <CGAL/PN_subdivision_3/Surface_refiner.h>

#include <functional>
#include <string>
#include <type_traits>
#include <vector>

namespace {

using namespace feature_matrix;

// Points and normals at the limit do not depend on what is carried.
struct At_the_limit
{
  template <class Scheme, class Np>
  void operator()(Case& c, const Scheme& scheme, const Np& np) const
  {
    test_options::Limit_options options;
    options.max_depth = 1;
    PN::subdivide_to_limit(c.mesh, scheme,
                           PN::parameters::join(PN::parameters::attributes(c.table), options.pack(),
                                                np.visitor(std::ref(c.log))));
  }
};

// The refined mesh replaces the control mesh of the case.
template <class Normals>
struct Refiner
{
  template <class Scheme, class Np>
  void operator()(Case& c, const Scheme& scheme, const Np& np) const
  {
    const PN::Surface_refiner refiner(
      c.mesh, scheme, PN::parameters::join(PN::parameters::attributes(c.table), np));
    c.mesh.clear_without_removing_property_maps();
    if constexpr (std::is_same_v<Normals, Of_corners>)
      refiner.build_mesh(c.mesh,
                         PN::parameters::attributes(c.table).vertex_normal_map(c.corner_normals));
    else
      refiner.build_mesh(c.mesh, PN::parameters::attributes(c.table).vertex_normal_map(c.normals));
  }
};

template <class Normals>
void compare_limits(const std::string& scheme, Crease_kind creases, const Normals& normals)
{
  const auto values = [](const Case& c) {
    return std::vector{c.points(), c.vertex_normals(), c.all_corner_normals()};
  };
  std::vector<std::vector<double>> without;
  for (const Attribute_kind attributes : attribute_kinds) {
    if (!tests_are_full && !std::is_same_v<Normals, Of_vertices> &&
        attributes != Attribute_kind::none && attributes != Attribute_kind::all)
      continue;
    SCOPED_TRACE(name(attributes));
    Case plain(scheme, creases, attributes), limit(scheme, creases, attributes);
    run(plain, normals, Plain());
    run(limit, normals, At_the_limit());
    expect_same_but_values(limit, plain);
    EXPECT_EQ(plain.error.empty(), is_known(scheme, creases, normals, attributes)) << plain.error;
    if (attributes == Attribute_kind::none) without = values(limit);
    for (std::size_t i = 0; i < 3 && limit.error.empty(); ++i)
      EXPECT_TRUE(same_bytes(values(limit)[i], without[i])) << i;
  }
}

TEST(Matrix_of_features, TheLimitCarriesWhatSubdivideCarries)
{
  for_each_cell([](const std::string& scheme, Crease_kind creases, const auto& normals) {
    if (scheme_named(scheme).keeps_vertices()) compare_limits(scheme, creases, normals);
  });
}

template <class Normals>
void compare_refiners(const std::string& scheme, Crease_kind creases, const Normals& normals)
{
  for (const Attribute_kind attributes : attribute_kinds) {
    SCOPED_TRACE(name(attributes));
    Case plain(scheme, creases, attributes), refiner(scheme, creases, attributes);
    run(plain, normals, Plain());
    run(refiner, normals, Refiner<Normals>());
    EXPECT_EQ(refiner.error, plain.error);
    expect_same_tables(refiner.table, plain.table);
    EXPECT_EQ(refiner.connectivity(), plain.connectivity());
    EXPECT_TRUE(same_bytes(refiner.points(), plain.points()));
    if (std::is_same_v<Normals, Of_vertices>) {
      EXPECT_TRUE(same_bytes(refiner.vertex_normals(), plain.vertex_normals()));
    }
    if (std::is_same_v<Normals, Of_corners>) {
      EXPECT_TRUE(same_bytes(refiner.all_corner_normals(), plain.all_corner_normals()));
    }
  }
}

TEST(Matrix_of_features, ARefinerCarriesWhatSubdivideCarries)
{
  for_each_cell([](const std::string& scheme, Crease_kind creases, const auto& normals) {
    if (!scheme_named(scheme).transfers_curvature()) compare_refiners(scheme, creases, normals);
  });
}

} // namespace

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Refiners with normals of corners that are edited, and with attributes in maps: what subdivide() gives, by bytes.

#include "Feature_matrix.h"
#include "Mesh_cases.h"
#include "Mesh_with_attributes.h"
#include "Messages.h"
#include "support/Options.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/PN_subdivision_3/Surface_refiner.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
#include <CGAL/PN_subdivision_3/subdivide.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <stdexcept>
#include <vector>

namespace {

using namespace feature_matrix;
using carrying_mesh::Mesh_with_attributes;

const Kernel::Point_3 moved(0.3, -0.2, 0.7);
const Vector turned(1, 2, 4);

// vertices of the control mesh: one beside the creases, and one on two of them
const Mesh::Vertex_index outer(10);
Mesh::Vertex_index on_creases(const Case& c)
{
  std::vector<int> sharp(c.mesh.number_of_vertices());
  for (auto e : c.mesh.edges())
    for (int i : {0, 1})
      if (c.sharpness[e] > 0 && ++sharp[c.mesh.vertex(e, unsigned(i)).idx()] == 2)
        return c.mesh.vertex(e, unsigned(i));
  return Mesh::null_vertex();
}

TEST(Refiner_with_normals_of_corners, FollowsPointsAndNormals)
{
  Case plain("catmull-clark", Crease_kind::edges, Attribute_kind::none),
    edited("catmull-clark", Crease_kind::edges, Attribute_kind::none);
  const Mesh::Vertex_index v = on_creases(edited);
  ASSERT_TRUE(v.is_valid());
  run(edited, Of_corners(), [&](Case& c, const auto& scheme, const auto& np) {
    PN::Surface_refiner refiner(c.mesh, scheme, np);
    refiner.set_point(v, moved);
    refiner.set_normal(outer, turned);
    EXPECT_LT(refiner.update().size(), refiner.number_of_vertices());
    messages::expect_refused([&] { refiner.set_normal(v, turned); }, {"given by its corners"});
    c.mesh.clear_without_removing_property_maps();
    refiner.build_mesh(c.mesh, params::vertex_normal_map(c.corner_normals));
  });
  plain.mesh.point(v) = moved;
  for (auto h : CGAL::halfedges_around_target(outer, plain.mesh))
    if (!plain.mesh.is_border(h)) plain.corner_normals[h] = turned;
  run(plain, Of_corners(), Plain());
  EXPECT_TRUE(same_bytes(edited.points(), plain.points()));
  EXPECT_TRUE(same_bytes(edited.all_corner_normals(), plain.all_corner_normals()));
}

template <class Control, class Built, class Number, class Scheme>
void compare(const mesh_cases::Soup& soup, const Scheme& scheme)
{
  for (const unsigned rounds : {0u, 1u, 2u}) {
    Mesh_with_attributes<Control, Number> control(soup), plain(soup);
    Mesh_with_attributes<Built, Number> built;
    const auto np = params::number_of_iterations(rounds);
    const PN::Surface_refiner refiner(
      control.mesh, scheme,
      PN::parameters::join(PN::parameters::attributes(control.attributes()), np));
    refiner.build_mesh(built.mesh, PN::parameters::attributes(built.attributes()));
    PN::subdivide(plain.mesh, scheme,
                  PN::parameters::join(PN::parameters::attributes(plain.attributes()), np));
    EXPECT_EQ(built.carried(), plain.carried()) << rounds << " rounds";
    EXPECT_EQ(control.carried(), (Mesh_with_attributes<Control, Number>(soup).carried()));
  }
}

TEST(Refiner_with_attributes, InMapsOfOtherMeshes)
{
  using Polyhedron = CGAL::Polyhedron_3<Kernel>;
  const PN::CatmullClark_scheme scheme;
  compare<Polyhedron, Mesh, double>(mesh_cases::mixed_with_border(), scheme);
  compare<Mesh, Polyhedron, double>(mesh_cases::mixed_with_border(), scheme);
}

#ifdef CGAL_LINKED_WITH_TBB
TEST(Refiner_with_attributes, OnSeveralThreads)
{
  const PN::CatmullClark_scheme scheme;
  const auto np = params::number_of_iterations(5); // some chunks of vertices
  Mesh_with_attributes<Mesh> control(mesh_cases::mixed_with_border()),
    plain(mesh_cases::mixed_with_border());
  Mesh_with_attributes<Mesh> built;
  const PN::Surface_refiner<Mesh, PN::CatmullClark_scheme, Kernel, CGAL::Parallel_tag> refiner(
    control.mesh, scheme,
    PN::parameters::join(PN::parameters::attributes(control.attributes()), np));
  refiner.build_mesh(built.mesh, PN::parameters::attributes(built.attributes()));
  PN::subdivide(plain.mesh, scheme,
                PN::parameters::join(PN::parameters::attributes(plain.attributes()), np));
  EXPECT_EQ(built.carried(), plain.carried());
}
#endif

TEST(Refiner_with_attributes, InExactNumbers)
{
  using FT = CGAL::Exact_rational;
  using Exact_mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<FT>::Point_3>;
  compare<Exact_mesh, Exact_mesh, FT>(mesh_cases::triangles_with_border(),
                                      PN::linear(PN::Loop_scheme()));
}

TEST(Refiner_with_attributes, ThatAreOthersAreRefused)
{
  Mesh_with_attributes<Mesh> control(mesh_cases::mixed_with_border()), built;
  const PN::Surface_refiner refiner(control.mesh, PN::CatmullClark_scheme(),
                                    PN::parameters::attributes(control.attributes()));
  const auto expect_refusal = [&](auto&& attributes) {
    EXPECT_THROW(refiner.build_mesh(built.mesh, PN::parameters::attributes(attributes)),
                 std::invalid_argument);
    EXPECT_TRUE(built.mesh.is_empty());
  };
  const auto vertices = PN::parameters::vertex_attribute(built.of_vertices);
  const auto corners = PN::parameters::corner_attribute(built.of_corners);
  const auto edges = PN::parameters::edge_attribute(built.of_edges);
  expect_refusal(test_options::attributes(vertices, corners, edges));
  expect_refusal(test_options::attributes(corners, vertices, edges,
                                          PN::parameters::face_attribute(built.of_faces)));
  expect_refusal(test_options::attributes(vertices, corners, edges, vertices));
  PN::Attribute_table table;
  expect_refusal(table);
  refiner.build_mesh(built.mesh); // attributes may be left out
  EXPECT_EQ(built.mesh.number_of_vertices(), refiner.number_of_vertices());
}

} // namespace

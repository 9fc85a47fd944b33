// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// What subdivide_to_limit() carries besides, on meshes and numbers that the matrix of features does not have, and what
// is left where a visitor ends it.

#include "Mesh_cases.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
#include <CGAL/PN_subdivision_3/subdivide.h>
#include <CGAL/PN_subdivision_3/subdivide_to_limit.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <cstddef>
#include <functional>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace {

namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;
using Kernel = CGAL::Simple_cartesian<double>;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;

// a mesh with values of all kinds of elements; those of the corners of every other face are a chart
template <class Mesh, class Number = double>
struct Carrying
{
  template <class Tag>
  using Map = typename boost::property_map<Mesh, Tag>::type;

  explicit Carrying(const mesh_cases::Soup& soup)
  {
    mesh_cases::build(soup, mesh);
    of_vertices = get(CGAL::dynamic_vertex_property_t<Number>(), mesh);
    of_corners = get(CGAL::dynamic_halfedge_property_t<Number>(), mesh);
    of_edges = get(CGAL::dynamic_edge_property_t<int>(), mesh);
    of_faces = get(CGAL::dynamic_face_property_t<int>(), mesh);
    int i = 0, j = 0, k = 0;
    for (auto v : vertices(mesh)) put(of_vertices, v, Number(7 * ++i % 13) / Number(10));
    for (auto h : halfedges(mesh)) put(of_corners, h, Number(0));
    for (auto f : faces(mesh)) {
      for (auto h : CGAL::halfedges_around_face(halfedge(f, mesh), mesh))
        put(of_corners, h, Number(get(of_vertices, target(h, mesh)) + Number(++j % 2)));
      put(of_faces, f, ++k);
    }
    for (auto e : edges(mesh)) put(of_edges, e, ++k);
  }
  auto attributes() const
  {
    return PN::attributes(PN::vertex_attribute(of_vertices), PN::corner_attribute(of_corners),
                          PN::edge_attribute(of_edges), PN::face_attribute(of_faces));
  }
  std::vector<Number> carried() const
  {
    std::vector<Number> result;
    for (auto v : vertices(mesh)) result.push_back(get(of_vertices, v));
    for (auto h : halfedges(mesh))
      if (!CGAL::is_border(h, mesh)) result.push_back(get(of_corners, h));
    for (auto e : edges(mesh)) result.push_back(Number(get(of_edges, e)));
    for (auto f : faces(mesh)) result.push_back(Number(get(of_faces, f)));
    return result;
  }

  Mesh mesh;
  Map<CGAL::dynamic_vertex_property_t<Number>> of_vertices;
  Map<CGAL::dynamic_halfedge_property_t<Number>> of_corners;
  Map<CGAL::dynamic_edge_property_t<int>> of_edges;
  Map<CGAL::dynamic_face_property_t<int>> of_faces;
};

template <class Mesh, class Concurrency_tag, class Number, class Scheme>
void compare(const mesh_cases::Soup& soup, const Scheme& scheme)
{
  for (const unsigned rounds : {0u, 1u, 2u}) {
    Carrying<Mesh, Number> limit(soup), plain(soup);
    const auto np = params::number_of_iterations(rounds);
    PN::subdivide_to_limit<Concurrency_tag>(limit.mesh, scheme, PN::Limit_options(), np,
                                            limit.attributes());
    PN::subdivide<Concurrency_tag>(plain.mesh, scheme, np, plain.attributes());
    EXPECT_EQ(limit.carried(), plain.carried()) << rounds << " rounds";
    EXPECT_NE(mesh_cases::points(limit.mesh), mesh_cases::points(plain.mesh));
    EXPECT_TRUE(CGAL::is_valid_polygon_mesh(limit.mesh));
  }
}

TEST(Carried_to_the_limit, OnEveryMesh)
{
  const PN::CatmullClark_scheme scheme;
  compare<Surface_mesh, CGAL::Sequential_tag, double>(mesh_cases::mixed_with_border(), scheme);
  compare<CGAL::Polyhedron_3<Kernel>, CGAL::Sequential_tag, double>(mesh_cases::mixed_with_border(),
                                                                    scheme);
#ifdef CGAL_LINKED_WITH_TBB
  compare<Surface_mesh, CGAL::Parallel_tag, double>(mesh_cases::mixed_with_border(), scheme);
#endif
}

TEST(Carried_to_the_limit, InExactNumbers)
{
  using FT = CGAL::Exact_rational;
  using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<FT>::Point_3>;
  compare<Mesh, CGAL::Sequential_tag, FT>(mesh_cases::triangles_with_border(),
                                          PN::linear(PN::Loop_scheme()));
}

struct Cancelled : std::runtime_error
{
  Cancelled()
    : std::runtime_error("cancelled")
  {}
};

// ends the call at the n-th time that it is told something
struct Canceller
{
  void count() const
  {
    if (--*left == 0) throw Cancelled();
  }
  void round_done(unsigned, std::size_t) const { count(); }
  void face_created(Surface_mesh::Face_index, const PN::Control_element&) const { count(); }

  int* left;
};

TEST(Carried_to_the_limit, AVisitorCancelsBeforeTheMeshIsTouched)
{
  const mesh_cases::Soup soup = mesh_cases::mixed_with_border();
  Carrying<Surface_mesh> whole(soup);
  const auto np = params::number_of_iterations(3);
  const PN::CatmullClark_scheme scheme;
  PN::subdivide_to_limit(whole.mesh, scheme, PN::Limit_options(), np, whole.attributes());
  for (int n = 1; n <= 5; ++n) {
    Carrying<Surface_mesh> c(soup), before(soup);
    int left = n;
    const Canceller visitor{&left};
    EXPECT_THROW(PN::subdivide_to_limit(c.mesh, scheme, PN::Limit_options(), np.visitor(visitor),
                                        c.attributes()),
                 Cancelled);
    // faces are told of when all is there
    const auto& expected = n <= 3 ? before : whole;
    EXPECT_EQ(c.carried(), expected.carried()) << n;
    EXPECT_EQ(mesh_cases::points(c.mesh), mesh_cases::points(expected.mesh)) << n;
    EXPECT_TRUE(c.mesh.is_valid());
  }
}

// the rounds can be done, the limits cannot
TEST(Carried_to_the_limit, WithoutLimitsNothingIsChanged)
{
  const mesh_cases::Soup soup = mesh_cases::mixed_with_border();
  Carrying<Surface_mesh> c(soup), before(soup);
  PN::Limit_options wrong;
  wrong.tolerance = -1;
  EXPECT_THROW(PN::subdivide_to_limit(c.mesh, PN::CatmullClark_scheme(), wrong,
                                      params::number_of_iterations(2), c.attributes()),
               std::invalid_argument);
  EXPECT_EQ(c.carried(), before.carried());
  EXPECT_EQ(c.mesh.number_of_vertices(), before.mesh.number_of_vertices());
}

} // namespace

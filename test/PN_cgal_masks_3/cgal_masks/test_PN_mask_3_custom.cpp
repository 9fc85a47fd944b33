// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// PN_mask_3 over masks that are not CGAL's own: the custom mask of CGAL's manual, as it stands in
// CGAL's examples, and masks with constructors and parameters of other kinds.

#include "PN_mask_3_cases.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Timer.h>
#include <CGAL/boost/graph/graph_traits_Surface_mesh.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/lexical_cast.hpp>

#include <gtest/gtest.h>

#include <fstream>
#include <iostream>

// Unpacked from CGAL's examples by the build; what it includes is included above.
#if __has_include(<Customized_subdivision.cpp>)
#  define PN_TEST_WITH_MASK_OF_MANUAL
namespace manual {
#  include <Customized_subdivision.cpp>
}
#endif

namespace {

namespace PN = CGAL::PN_subdivision_3;
using K = CGAL::Simple_cartesian<double>;
using Surface_mesh = CGAL::Surface_mesh<K::Point_3>;

template <class Pn_mask>
void keeps_sphere(Control<Surface_mesh>& control, Pn_mask mask)
{
  CGAL::Subdivision_method_3::PTQ(
    control.mesh, mask,
    CGAL::parameters::vertex_point_map(control.point_normals()).number_of_iterations(4));
  ASSERT_GT(num_vertices(control.mesh), 1000u);
  for (const auto& p : control.mesh.points())
    ASSERT_NEAR(std::sqrt((p - CGAL::ORIGIN).squared_length()), 3, 2e-14);
}

TEST(PN_mask_3_custom, MaskOfCGALsManual)
{
#ifdef PN_TEST_WITH_MASK_OF_MANUAL
  for (bool closed : {true, false}) {
    Control_mesh control = on_sphere(control_mesh<Loop>(closed), 3);
    Control<Surface_mesh> sphere(control);
    keeps_sphere(sphere,
                 PN::make_PN_mask_3<manual::WLoop_mask_3>(sphere.mesh, sphere.point_normals()));

    control.normals.assign(control.points.size(), {0, 0, 0});
    Control<Surface_mesh> pn(control), linear(control);
    const auto map = pn.point_normals();
    CGAL::Subdivision_method_3::PTQ(pn.mesh, PN::make_PN_mask_3<manual::WLoop_mask_3>(pn.mesh, map),
                                    CGAL::parameters::vertex_point_map(map));
    CGAL::Subdivision_method_3::PTQ(linear.mesh, manual::WLoop_mask_3<Surface_mesh>(linear.mesh),
                                    CGAL::parameters::number_of_iterations(1));
    EXPECT_EQ(mesh_cases::points(pn.mesh), mesh_cases::points(linear.mesh));
  }
#else
  GTEST_SKIP() << "left out: CGAL's examples not found (Debian: examples.tar.gz of libcgal-dev)";
#endif
}

// Takes the mesh by reference, points from the mesh, a map without default, and two parameters:
// an edge node is `share` of its target, 1 - share - far of its source, and `far` of the vertex to
// its left.
template <class Mesh, class PointMap>
class Skew_mask_3
{
  using Traits = boost::graph_traits<Mesh>;
  using Node = typename boost::property_traits<PointMap>::value_type;

public:
  Skew_mask_3(Mesh& mesh, const PointMap& points, double share, double far)
    : mesh_(mesh)
    , points_(points)
    , share_(share)
    , far_(far)
  {}

  void edge_node(typename Traits::halfedge_descriptor h, Node& node)
  {
    node = CGAL::barycenter(get(CGAL::vertex_point, mesh_, target(h, mesh_)), share_,
                            get(points_, source(h, mesh_)), 1 - share_ - far_,
                            get(points_, target(next(h, mesh_), mesh_)), far_);
  }
  void vertex_node(typename Traits::vertex_descriptor v, Node& node) { node = get(points_, v); }
  void border_node(typename Traits::halfedge_descriptor h, Node& edge, Node& vertex)
  {
    edge = CGAL::midpoint(get(points_, source(h, mesh_)), get(points_, target(h, mesh_)));
    vertex_node(target(h, mesh_), vertex);
  }

private:
  Mesh& mesh_;
  PointMap points_;
  double share_, far_;
};

TEST(PN_mask_3_custom, MaskWithParameters)
{
  Control<Surface_mesh> sphere(on_sphere(control_mesh<Loop>(false), 3));
  keeps_sphere(sphere,
               PN::make_PN_mask_3<Skew_mask_3>(sphere.mesh, sphere.point_normals(), 0.375, 0.125));
}

// Everything that a mask may ask of a mesh, asked through the view.
template <class Mesh>
class Curious_mask_3
{
  using Traits = boost::graph_traits<Mesh>;
  using Point_map = typename boost::property_map<Mesh, CGAL::vertex_point_t>::type;
  using Node = typename boost::property_traits<Point_map>::value_type;

public:
  explicit Curious_mask_3(const Mesh* mesh)
    : mesh_(mesh)
  {}

  void vertex_node(typename Traits::vertex_descriptor v, Node& node)
  {
    const auto index = get(boost::vertex_index, *mesh_);
    typename Traits::vertices_size_type degree_sum = 0;
    for (auto u : vertices(*mesh_)) degree_sum += degree(u, *mesh_);
    EXPECT_EQ(degree_sum, num_halfedges(*mesh_));
    EXPECT_EQ(std::size_t(num_edges(*mesh_)), edges(*mesh_).size());
    EXPECT_EQ(std::size_t(num_faces(*mesh_)), faces(*mesh_).size());
    EXPECT_EQ(std::size_t(num_vertices(*mesh_)), vertices(*mesh_).size());
    for (auto h : CGAL::halfedges_around_target(v, *mesh_)) {
      const auto u = source(h, *mesh_);
      EXPECT_EQ(halfedge(u, v, *mesh_).first, h);
      EXPECT_EQ(edge(u, v, *mesh_).first, edge(h, *mesh_));
      EXPECT_EQ(prev(next(h, *mesh_), *mesh_), h);
      EXPECT_EQ(face(halfedge(face(h, *mesh_), *mesh_), *mesh_), face(h, *mesh_));
      EXPECT_EQ(degree(face(h, *mesh_), *mesh_), 3u);
      EXPECT_NE(get(index, u), get(index, v));
      const auto e = edge(h, *mesh_);
      EXPECT_TRUE(halfedge(e, *mesh_) == h || halfedge(e, *mesh_) == opposite(h, *mesh_));
      EXPECT_EQ(source(e, *mesh_), source(halfedge(e, *mesh_), *mesh_));
      EXPECT_EQ(target(e, *mesh_), target(halfedge(e, *mesh_), *mesh_));
    }
    EXPECT_EQ(out_degree(v, *mesh_), in_degree(v, *mesh_));
    EXPECT_EQ(target(*in_edges(v, *mesh_).first, *mesh_), v);
    EXPECT_EQ(source(*out_edges(v, *mesh_).first, *mesh_), v);
    node = get(CGAL::vertex_point, *mesh_, v);
  }

private:
  const Mesh* mesh_;
};

TEST(PN_mask_3_custom, ViewAnswersLikeTheMesh)
{
  Control_mesh mesh = control_mesh<Loop>(true);
  test_meshes::set_uneven_normals(mesh, 3);
  Control<Surface_mesh> control(mesh);
  const auto map = control.point_normals();
  auto mask = PN::make_PN_mask_3<Curious_mask_3>(control.mesh, map);
  for (auto v : vertices(control.mesh)) {
    decltype(mask)::Point_normal node;
    mask.vertex_node(v, node);
    EXPECT_EQ(node.first, get(map, v).first);
    EXPECT_LE((node.second - get(map, v).second).squared_length(), 1e-30);
  }
}

} // namespace

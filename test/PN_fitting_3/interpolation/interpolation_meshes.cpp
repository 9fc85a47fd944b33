// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Interpolation with other meshes, number types and maps than those of the other tests.

#include "Failing_map.h"
#include "Interpolation_cases.h"
#include "Messages.h"

#include <CGAL/PN_fitting_3/interpolate_limit_points.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/copy_face_graph.h>

namespace {

using namespace interpolation_cases;

const PN::CatmullClark_scheme catmull_clark;

TEST(Interpolation_input, SharpEdgesAreRefusedByName)
{
  const Control_mesh data = ellipsoid_quads(2);
  Surface_mesh mesh = to_surface_mesh(data);
  const auto sharp = mesh.add_property_map<Surface_mesh::Edge_index, bool>("e:sharp", false).first;
  sharp[Surface_mesh::Edge_index(3)] = true;
  messages::expect_refused(
    [&] {
      PN::interpolate_limit_points(
        mesh, catmull_clark,
        CGAL::parameters::vertex_normal_map(normal_map(mesh)).edge_is_constrained_map(sharp));
    },
    {"edge", "is sharp"});
  EXPECT_EQ(control_net(mesh, data).points, data.points);
}

TEST(Interpolation_input, AFailureLeavesTheMeshAsItWas)
{
  const Control_mesh data = ellipsoid_quads(2);
  Surface_mesh mesh = to_surface_mesh(data);
  failing_maps::Calls_left writes(5);
  const auto points = failing(get(CGAL::vertex_point, mesh), writes);
  EXPECT_THROW(PN::interpolate_limit_points(
                 mesh, catmull_clark,
                 PN::parameters::join(
                   strict().pack(),
                   CGAL::parameters::vertex_point_map(points).vertex_normal_map(normal_map(mesh)))),
               failing_maps::User_failure);
  EXPECT_EQ(control_net(mesh, data).points, data.points);
}

// so are natural normals, which are written first
TEST(Interpolation_input, AFailureLeavesNormalsAsTheyWere)
{
  const Control_mesh data = ellipsoid_quads(2);
  Surface_mesh mesh = to_surface_mesh(data);
  const auto normals = normal_map(mesh);
  const Kernel::Vector_3 given(0.6, 0, 0.8);
  for (auto v : mesh.vertices()) normals[v] = given;
  const auto natural =
    PN::parameters::interpolation_normals(PN::Limit_interpolation::Normals::natural);
  failing_maps::Calls_left writes(5);
  const auto points = failing(get(CGAL::vertex_point, mesh), writes);
  EXPECT_THROW(PN::interpolate_limit_points(
                 mesh, catmull_clark, natural.vertex_point_map(points).vertex_normal_map(normals)),
               failing_maps::User_failure);
  for (auto v : mesh.vertices()) EXPECT_EQ(normals[v], given);
  EXPECT_EQ(control_net(mesh, data).points, data.points);

  EXPECT_THROW(PN::interpolate_limit_points(mesh, catmull_clark, natural), std::invalid_argument);
  EXPECT_THROW(PN::interpolate_limit_points(mesh, PN::linear(catmull_clark),
                                            natural.vertex_normal_map(normals)),
               std::invalid_argument);
}

// in double, whatever the mesh and its number type
template <class Mesh, class K>
void expect_same_net(const Control_mesh& data)
{
  Interpolated expected = interpolated(data, catmull_clark, strict());
  Surface_mesh mesh = to_surface_mesh(data);
  const auto normals = normal_map(mesh);
  Mesh other;
  using Other_vertex = typename boost::graph_traits<Mesh>::vertex_descriptor;
  std::vector<std::pair<Surface_mesh::Vertex_index, Other_vertex>> pairs;
  CGAL::copy_face_graph(
    mesh, other, CGAL::parameters::vertex_to_vertex_output_iterator(std::back_inserter(pairs)));
  std::map<Other_vertex, typename K::Vector_3> map;
  for (const auto& [v, w] : pairs) {
    const auto& n = normals[v];
    map[w] = typename K::Vector_3(n.x(), n.y(), n.z());
  }
  const Report report = PN::interpolate_limit_points(
    other, catmull_clark,
    PN::parameters::join(strict().pack(),
                         CGAL::parameters::vertex_normal_map(boost::make_assoc_property_map(map))));
  EXPECT_EQ(report.steps, expected.report.steps);
  const auto points = get(CGAL::vertex_point, other);
  for (const auto& [v, w] : pairs) {
    const auto& p = expected.mesh.point(v);
    const auto& q = get(points, w);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(CGAL::to_double(q[k]), p[k], 1e-13);
  }
}

TEST(Interpolation_input, OtherMeshesAndNumbers)
{
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  const Control_mesh data =
    sampled_surfaces::patch(3, 3, 0.2, test_meshes::Cells::mixed, 5, sampled_surfaces::on_waves);
  expect_same_net<CGAL::Polyhedron_3<Kernel>, Kernel>(data);
  expect_same_net<CGAL::Surface_mesh<Exact::Point_3>, Exact>(data);
}

} // namespace

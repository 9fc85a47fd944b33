// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Interpolation of difficult and wrong input, other meshes and number types.

#include "Interpolation_cases.h"
#include "Mesh_files.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/centroid.h>

#include <gtest/gtest.h>

namespace {

using namespace interpolation_cases;

const PN::CatmullClark_scheme scheme;

void expect_finite(const Surface_mesh& mesh)
{
  for (auto v : mesh.vertices())
    for (int k = 0; k < 3; ++k) ASSERT_TRUE(std::isfinite(mesh.point(v)[k]));
}

double distance_from_data(Surface_mesh& net, const Control_mesh& data)
{
  const Limits all = limit_cases::limits(net, scheme, limit_cases::close(1e-12));
  double largest = 0;
  for (std::size_t v = 0; v < data.points.size(); ++v)
    largest = (std::max)(
      largest, double((limit_cases::to_vector(all.at[v].point) - point_of(data, v)).norm()));
  return largest;
}

TEST(Interpolation_input, IsFiniteAndNoWorseThanTheData)
{
  for (Control_mesh data : meshes_for<CatmullClark_description>()) {
    if (data.points.size() > 30) continue; // all kinds of connectivity are among the small ones
    for (const int kind : {0, 1, 2, 3}) {
      if (kind == 0) test_meshes::set_wild_normals(data, 5);
      if (kind == 1) data.normals.assign(data.points.size(), {0, 0, 0});
      if (kind == 2) data.normals.assign(data.points.size(), {0, 0, 1});
      if (kind == 3) data.points.assign(data.points.size(), {1, 2, 3});
      for (const Options& options : {Options(), strict()}) {
        Interpolated result = interpolated(data, scheme, options);
        expect_finite(result.mesh);
        EXPECT_TRUE(std::isfinite(result.report.residual)) << data.name << kind;
        EXPECT_TRUE(std::isfinite(result.report.slip_of_edge)) << data.name << kind;
        if (options.mode == PN::Limit_interpolation_mode::slide) continue;
        Surface_mesh before = to_surface_mesh(data);
        EXPECT_LE(distance_from_data(result.mesh, data),
                  distance_from_data(before, data) * (1 + 1e-9) + 1e-12)
          << data.name << kind;
      }
    }
  }
}

// The matrix of the linear limit points of a cube's connectivity is singular: the vector that alternates.
TEST(Interpolation_input, TheCubeHasASolutionWithNormals)
{
  Surface_mesh cube = mesh_files::read(std::string(PN_DATA_DIR) + "/cube.off");
  const auto normals = normal_map(cube);
  PN::estimate_control_normals(cube, normals);
  for (const Options& options : {Options(), strict()}) {
    Surface_mesh net = cube;
    const Report report = PN::interpolate_limit_points(
      net, scheme, options, CGAL::parameters::vertex_normal_map(normal_map(net)));
    EXPECT_TRUE(report.is_within_tolerance()) << report.residual;
    expect_finite(net);
  }
  // one that is not on a sphere
  Surface_mesh brick = cube;
  for (auto v : brick.vertices()) {
    const auto& p = brick.point(v);
    brick.point(v) = Kernel::Point_3(p.x(), 1.2 * p.y(), 1.5 * p.z());
  }
  PN::estimate_control_normals(brick, normal_map(brick));
  const Report report = PN::interpolate_limit_points(
    brick, scheme, strict(), CGAL::parameters::vertex_normal_map(normal_map(brick)));
  EXPECT_GT(report.steps, 0u);
  EXPECT_TRUE(report.is_within_tolerance()) << report.residual;
  expect_finite(brick);
  // moved by that vector: linear interpolation cannot do it, and says so
  const Kernel::Point_3 middle =
    CGAL::centroid(cube.points().begin(), cube.points().end(), CGAL::Dimension_tag<0>());
  for (auto v : cube.vertices()) {
    const Kernel::Vector_3 d = cube.point(v) - middle;
    const double sign = d.x() * d.y() * d.z() > 0 ? 0.1 : -0.1;
    cube.point(v) = cube.point(v) + sign * Kernel::Vector_3(1, 1, 1);
  }
  const Report impossible = PN::interpolate_limit_points(cube, PN::linear(scheme), strict());
  EXPECT_FALSE(impossible.is_within_tolerance());
  expect_finite(cube);
}

TEST(Interpolation_input, RealMeshes)
{
  for (const char* file : {"/head.obj", "/spoon.obj", "/creature.obj"}) {
    Surface_mesh mesh = mesh_files::read(std::string(PN_DATA_DIR) + file);
    PN::estimate_control_normals(mesh, normal_map(mesh));
    Options options = strict();
    options.tolerance = 1e-9;
    for (const auto mode :
         {PN::Limit_interpolation_mode::slide, PN::Limit_interpolation_mode::limit_points}) {
      options.mode = mode;
      Surface_mesh net = mesh;
      const Report report = PN::interpolate_limit_points(
        net, scheme, options, CGAL::parameters::vertex_normal_map(normal_map(net)));
      EXPECT_TRUE(report.is_within_tolerance()) << file << " " << report.residual;
      expect_finite(net);
    }
  }
}

TEST(Interpolation_input, ATolerancePastReachGivesTheBest)
{
  Options options = strict();
  options.tolerance = 0;
  const Control_mesh data = ellipsoid_quads(3);
  Interpolated result = interpolated(data, scheme, options);
  EXPECT_GT(result.report.residual, 0);
  EXPECT_LE(result.report.residual, 1e-14);
  EXPECT_FALSE(result.report.is_within_tolerance());
}

TEST(Interpolation_input, WrongOptionsAreRefused)
{
  const Control_mesh data = ellipsoid_quads(2);
  Surface_mesh mesh = to_surface_mesh(data);
  const auto run = [&](const Options& options) {
    PN::interpolate_limit_points(mesh, scheme, options,
                                 CGAL::parameters::vertex_normal_map(normal_map(mesh)));
  };
  Options options;
  options.tolerance = -1;
  EXPECT_THROW(run(options), std::invalid_argument);
  options.tolerance = std::nan("");
  EXPECT_THROW(run(options), std::invalid_argument);
  options = Options();
  options.free = PN::Limit_interpolation_free::smooth;
  EXPECT_THROW(run(options), std::invalid_argument);
  EXPECT_EQ(control_net(mesh, data).points, data.points);
}

TEST(Interpolation_input, SharpEdgesAreRefusedByName)
{
  const Control_mesh data = ellipsoid_quads(2);
  Surface_mesh mesh = to_surface_mesh(data);
  const auto sharp = mesh.add_property_map<Surface_mesh::Edge_index, bool>("e:sharp", false).first;
  sharp[Surface_mesh::Edge_index(3)] = true;
  try {
    PN::interpolate_limit_points(
      mesh, scheme, Options(),
      CGAL::parameters::vertex_normal_map(normal_map(mesh)).edge_is_constrained_map(sharp));
    ADD_FAILURE() << "a sharp edge is taken for a smooth one";
  } catch (const std::invalid_argument& e) {
    EXPECT_NE(std::string(e.what()).find("edge"), std::string::npos) << e.what();
    EXPECT_NE(std::string(e.what()).find("is sharp"), std::string::npos) << e.what();
  }
  EXPECT_EQ(control_net(mesh, data).points, data.points);
}

// a map that refuses to be written after some values
struct Failing_map
{
  using key_type = Surface_mesh::Vertex_index;
  using value_type = Kernel::Point_3;
  using reference = value_type;
  using category = boost::read_write_property_map_tag;

  Surface_mesh* mesh;
  int* writes_left;

  friend value_type get(const Failing_map& map, key_type v) { return map.mesh->point(v); }
  friend void put(const Failing_map& map, key_type v, const value_type& p)
  {
    if ((*map.writes_left)-- == 0) throw std::runtime_error("no more");
    map.mesh->point(v) = p;
  }
};

TEST(Interpolation_input, AFailureLeavesTheMeshAsItWas)
{
  const Control_mesh data = ellipsoid_quads(2);
  Surface_mesh mesh = to_surface_mesh(data);
  int writes = 5;
  EXPECT_THROW(
    PN::interpolate_limit_points(mesh, scheme, strict(),
                                 CGAL::parameters::vertex_point_map(Failing_map{&mesh, &writes})
                                   .vertex_normal_map(normal_map(mesh))),
    std::runtime_error);
  EXPECT_EQ(control_net(mesh, data).points, data.points);
}

TEST(Interpolation_input, EmptyMeshesStayEmpty)
{
  Surface_mesh mesh;
  for (const Options& options : {Options(), strict()}) {
    const Report report = PN::interpolate_limit_points(
      mesh, scheme, options, CGAL::parameters::vertex_normal_map(normal_map(mesh)));
    EXPECT_TRUE(report.is_within_tolerance());
    EXPECT_EQ(report.steps, 0u);
  }
}

// in double, whatever the mesh and its number type
template <class Mesh, class K>
void expect_same_net(const Control_mesh& data)
{
  Interpolated expected = interpolated(data, scheme, strict());
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
    other, scheme, strict(),
    CGAL::parameters::vertex_normal_map(boost::make_assoc_property_map(map)));
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

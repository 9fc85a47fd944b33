// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
// Curvatures of limits where the roundness is not 1, against what limit normals of a fine mesh turn.

#include "Messages.h"
#include "Named_shapes.h"
#include "Scheme_runs.h"
#include "support/Options.h"

#include <CGAL/PN_fitting_3/prescribe_limit_data.h>
#include <CGAL/PN_limit_surface_3/limit_points.h>
#include <CGAL/PN_subdivision_3/schemes/Transfer_schemes.h>
#include <CGAL/PN_subdivision_3/schemes/Tuned_Loop_scheme.h>
#include <CGAL/Surface_mesh.h>
#include <Eigen/Dense>

#include <optional>

namespace PN = CGAL::PN_subdivision_3;

namespace {

using Vertex = Surface_mesh::Vertex_index;
using Roundness_map = Surface_mesh::Property_map<Vertex, double>;
using Limit = PN::Limit_point<Kernel>;
using Curvature = PN::Prescribed_curvature<Kernel>;

Roundness_map roundness_map(Surface_mesh& mesh)
{
  return mesh.add_property_map<Vertex, double>("v:roundness", 1).first;
}

auto with_maps(Surface_mesh& mesh)
{
  return PN::parameters::vertex_roundness_map(roundness_map(mesh))
    .vertex_normal_map(normal_map(mesh));
}

// an ellipsoid's part around a vertex, with normals of another one: no symmetry does what roundness should
Surface_mesh star(int valence, double roundness, double slope)
{
  auto control = test_meshes::star(valence, 2, test_meshes::Cells::triangles);
  control.normals.clear();
  for (auto& p : control.points) {
    const double x = p[0], y = p[1];
    p[2] = 0.1 * x * x + 0.15 * y * y;
    control.normals.push_back(test_meshes::unit({-0.3 * x, -0.5 * y, 1}));
  }
  Surface_mesh mesh = to_surface_mesh(control);
  for (auto v : mesh.vertices()) roundness_map(mesh)[v] = roundness + slope * mesh.point(v).x();
  return mesh;
}

template <class Scheme>
auto limits(Surface_mesh& mesh, const Scheme& scheme)
{
  const auto map = mesh.add_property_map<Vertex, Limit>("v:limit").first;
  test_options::Limit_options options;
  options.surface_normals = options.curvatures = true;
  PN::limit_points(mesh, scheme, map, PN::parameters::join(options.pack(), with_maps(mesh)));
  return map;
}

Eigen::Vector3d vector(const Kernel::Vector_3& x)
{
  return {x.x(), x.y(), x.z()};
}

// Gaussian and mean curvature at a vertex by its neighbors' limit points and normals, after some rounds. At an
// irregular vertex they are a tenth off then, with roundness 1 as with others.
template <class Scheme>
std::pair<double, double> turns(Surface_mesh mesh, const Scheme& scheme, Vertex v, unsigned rounds)
{
  PN::subdivide(
    mesh, scheme,
    PN::parameters::join(CGAL::parameters::number_of_iterations(rounds), with_maps(mesh)));
  const auto limit = limits(mesh, scheme);
  const Eigen::Vector3d n = vector(limit[v].surface_normal), e1 = n.unitOrthogonal();
  Eigen::Matrix<double, 2, 3> plane;
  plane << e1.transpose(), n.cross(e1).transpose();
  Eigen::Matrix2d a = Eigen::Matrix2d::Zero(), b = a;
  for (auto w : vertices_around_target(mesh.halfedge(v), mesh)) {
    const Eigen::Vector2d e = plane * vector(limit[w].point - limit[v].point);
    b += plane * (vector(limit[w].surface_normal) - n) * e.transpose();
    a += e * e.transpose();
  }
  const Eigen::Matrix2d s = b * a.inverse();
  return {s.determinant(), s.trace() / 2};
}

template <class Scheme>
void expect_curvature_of_turns(const Scheme& scheme, int valence)
{
  for (const auto& [roundness, slope] : {std::pair(1., 0.), {0.5, 0.1}}) {
    Surface_mesh mesh = star(valence, roundness, slope);
    const Vertex v(0);
    const Limit limit = limits(mesh, scheme)[v];
    ASSERT_TRUE(limit.has_curvature);
    const auto [gaussian, mean] = turns(mesh, scheme, v, 4);
    EXPECT_NEAR(limit.mean, mean, 0.15 * std::abs(mean)) << valence << ' ' << roundness;
    EXPECT_NEAR(limit.gaussian, gaussian, 0.3 * std::abs(gaussian)) << valence << ' ' << roundness;
  }
}

} // namespace

TEST(Round_curvature, IsWhatNormalsTurn)
{
  expect_curvature_of_turns(PN::Loop_scheme::Tuned(), 7);
}

TEST(Round_curvature, IsTransferred)
{
  expect_curvature_of_turns(PN::Loop_scheme::Transfer(), 7);
}

TEST(Round_curvature, CanBePrescribed)
{
  for (const int valence : {6, 7}) {
    Surface_mesh mesh = star(valence, 0.4, 0);
    PN::subdivide(mesh, PN::Loop_scheme::Tuned(),
                  PN::parameters::join(CGAL::parameters::number_of_iterations(1), with_maps(mesh)));
    const Vertex v(0);
    const Limit before = limits(mesh, PN::Loop_scheme::Tuned())[v];
    const auto curvatures = mesh.add_property_map<Vertex, std::optional<Curvature>>("v:c").first;
    const double unused = std::numeric_limits<double>::quiet_NaN();
    curvatures[v] = Curvature{-0.4, -0.4, {unused, unused, unused}};
    const auto report = PN::prescribe_limit_data(
      mesh, PN::Loop_scheme::Tuned(),
      PN::parameters::join(
        PN::parameters::prescribed_curvature_map(curvatures).curvature_tolerance(1e-4),
        with_maps(mesh)));
    EXPECT_LE(report.curvature_steps, 8u);
    const Limit after = limits(mesh, PN::Loop_scheme::Tuned())[v];
    EXPECT_GT(std::abs(before.mean + 0.4), 0.1);
    EXPECT_NEAR(after.mean, -0.4, 1e-3) << valence;
    EXPECT_NEAR(turns(mesh, PN::Loop_scheme::Tuned(), v, 3).second, -0.4, 0.08) << valence;
  }
}

TEST(Round_curvature, NeedsRoundnessAtIrregularVertices)
{
  Surface_mesh mesh = star(7, 0.05, 0);
  const auto curvatures = mesh.add_property_map<Vertex, std::optional<Curvature>>("v:c").first;
  curvatures[Vertex(0)] = Curvature{-0.2, -0.2};
  messages::expect_refused(
    [&] {
      PN::prescribe_limit_data(
        mesh, PN::Loop_scheme::Tuned(),
        PN::parameters::join(PN::parameters::prescribed_curvature_map(curvatures),
                             with_maps(mesh)));
    },
    {"vertex 0, where the roundness is below 0.1"});
}

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
// Interpolation where roundness is given: limits are evaluated by functions for limits, which solve nothing.

#include "Extent.h"
#include "Messages.h"
#include "Named_shapes.h"
#include "Scheme_runs.h"
#include "support/Options.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/PN_fitting_3/interpolate_limit_points.h>
#include <CGAL/PN_fitting_3/prescribe_limit_data.h>
#include <CGAL/PN_limit_surface_3/limit_points.h>
#include <CGAL/PN_limit_surface_3/subdivide_to_limit.h>
#include <CGAL/PN_subdivision_3/schemes/Tuned_Loop_scheme.h>

#include <optional>

namespace PN = CGAL::PN_subdivision_3;

namespace {

using test_meshes::Cells;
using test_meshes::Control_mesh;
using Vertex = Surface_mesh::Vertex_index;
using Roundness_map = Surface_mesh::Property_map<Vertex, double>;
using Mode = PN::Limit_interpolation::Mode;

Roundness_map roundness_map(Surface_mesh& mesh)
{
  return mesh.add_property_map<Vertex, double>("v:roundness", 1).first;
}

auto with_maps(Surface_mesh& mesh)
{
  return PN::parameters::vertex_roundness_map(roundness_map(mesh))
    .vertex_normal_map(normal_map(mesh));
}

// by its first face, of points around the origin
bool is_inside_out(const Control_mesh& mesh)
{
  const auto p = [&](std::size_t i) {
    const auto& x = mesh.points[std::size_t(mesh.faces[0][i])];
    return Kernel::Vector_3(x[0], x[1], x[2]);
  };
  return CGAL::determinant(p(0), p(1), p(2)) < 0;
}

// points that are moved, with normals away from a center, and any roundness
Surface_mesh uneven(Control_mesh control)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<> some(-0.04, 0.04);
  test_meshes::Triple mean{};
  for (const auto& p : control.points)
    for (std::size_t c = 0; c < 3; ++c) mean[c] += p[c] / double(control.points.size());
  control.normals.clear();
  if (!test_meshes::is_closed(control)) mean[2] -= 2; // a part of a sphere
  for (auto& p : control.points) {
    for (std::size_t c = 0; c < 3; ++c) p[c] -= mean[c];
    control.normals.push_back(test_meshes::unit(p));
    for (double& x : p) x += some(random);
  }
  if (is_inside_out(control))
    for (auto& f : control.faces) std::reverse(f.begin(), f.end());
  Surface_mesh mesh = to_surface_mesh(control);
  const Roundness_map w = roundness_map(mesh);
  for (auto v : mesh.vertices()) w[v] = double(random() % 65) / 64;
  return mesh;
}

std::vector<Surface_mesh> meshes_of(bool triangles)
{
  if (triangles)
    return {uneven(named_shapes::capped_antiprism(5)),
            uneven(test_meshes::star(7, 2, Cells::triangles))};
  return {uneven(test_meshes::in_quads(named_shapes::capped_antiprism(5))),
          uneven(test_meshes::star(5, 2, Cells::quads))};
}

double largest_distance(const Surface_mesh& a, const Surface_mesh& b)
{
  double largest = 0;
  for (auto v : a.vertices())
    largest = (std::max)(largest, std::sqrt(CGAL::squared_distance(a.point(v), b.point(v))));
  return largest;
}

// Points become their limits, and normals those of the surface, with the maps or without any.
template <class Scheme>
Surface_mesh at_limit(Surface_mesh mesh, const Scheme& scheme, bool has_maps = true)
{
  test_options::Limit_options options;
  options.tolerance = 1e-13;
  options.surface_normals = has_maps;
  const auto np = PN::parameters::join(CGAL::parameters::number_of_iterations(0), options.pack());
  if (has_maps)
    PN::subdivide_to_limit(mesh, scheme, PN::parameters::join(np, with_maps(mesh)));
  else
    PN::subdivide_to_limit(mesh, scheme, np);
  return mesh;
}

template <class Scheme>
PN::Limit_interpolation interpolate(Surface_mesh& mesh, const Scheme& scheme, Mode mode)
{
  test_options::Limit_interpolation_options<> options;
  options.mode = mode;
  return PN::interpolate_limit_points(mesh, scheme,
                                      PN::parameters::join(options.pack(), with_maps(mesh)));
}

template <class Scheme>
void expect_limits_at_data(const Scheme& scheme, bool triangles)
{
  for (const Surface_mesh& data : meshes_of(triangles)) {
    Surface_mesh mesh = data;
    interpolate(mesh, scheme, Mode::strict);
    EXPECT_LT(largest_distance(at_limit(mesh, scheme), data), 1e-11);
    EXPECT_GT(largest_distance(at_limit(data, scheme), data), 1e-3); // what has to be solved
    Surface_mesh before = data;
    for (auto v : mesh.vertices()) // it is only read
      EXPECT_EQ(roundness_map(mesh)[v], roundness_map(before)[v]);
  }
}

TEST(Round_interpolation, HasLimitsAtItsData)
{
  expect_limits_at_data(PN::CatmullClark_scheme(), false);
  expect_limits_at_data(PN::Loop_scheme(), true);
  expect_limits_at_data(PN::Loop_scheme::Tuned(), true);
}

// with roundness 1 everywhere they are those without, with 0 those of the linear scheme
TEST(Round_interpolation, HasTheUsualEnds)
{
  for (const Mode mode : {Mode::strict, Mode::slide})
    for (const Surface_mesh& data : meshes_of(true)) {
      Surface_mesh without = data, ones = data, zeros = data, linear = data;
      test_options::Limit_interpolation_options<> options;
      options.mode = mode;
      const auto normals = [](Surface_mesh& m) {
        return CGAL::parameters::vertex_normal_map(normal_map(m));
      };
      PN::interpolate_limit_points(without, PN::Loop_scheme(),
                                   PN::parameters::join(options.pack(), normals(without)));
      PN::interpolate_limit_points(
        ones, PN::Loop_scheme(),
        PN::parameters::join(options.pack(),
                             PN::parameters::roundness(1.).vertex_normal_map(normal_map(ones))));
      PN::interpolate_limit_points(linear, PN::linear(PN::Loop_scheme()),
                                   PN::parameters::join(options.pack(), normals(linear)));
      for (auto v : zeros.vertices()) roundness_map(zeros)[v] = 0;
      interpolate(zeros, PN::Loop_scheme(), mode);
      for (auto v : data.vertices()) {
        EXPECT_EQ(without.point(v), ones.point(v));
        if (mode == Mode::strict) { // sliding takes control normals on the border, if there are any
          EXPECT_LT(CGAL::squared_distance(zeros.point(v), linear.point(v)), 1e-22);
        }
      }
    }
}

// Without a map of normals the result is for calls without one: they estimate normals and roundness from its points. Where
// the tolerance cannot be met, as about antiprisms cut into triangles, the report says how far they are.
template <class Scheme>
void expect_limits_of_estimates_at_data(const Scheme& scheme, bool triangles)
{
  Mode mode = Mode::slide; // it plays no part
  for (const Surface_mesh& data : meshes_of(triangles)) {
    Surface_mesh mesh = data;
    test_options::Limit_interpolation_options<> options;
    options.mode = std::exchange(mode, Mode::strict);
    options.tolerance = 1e-10;
    options.max_steps = 100;
    const auto report = PN::interpolate_limit_points(mesh, scheme, options.pack());
    EXPECT_GT(report.steps, 0u);
    const double left = largest_distance(at_limit(mesh, scheme, false), data),
                 before = largest_distance(at_limit(data, scheme, false), data);
    EXPECT_LE(left, 1.1 * (std::max)(report.residual, report.tolerance));
    EXPECT_LE(left, before / 4);
    if (!triangles || options.mode == Mode::strict) {
      EXPECT_LE(report.residual, report.tolerance);
    }
  }
}

TEST(Round_interpolation, WithoutNormalsIsThatOfEstimatedOnes)
{
  expect_limits_of_estimates_at_data(PN::CatmullClark_scheme(), false);
  expect_limits_of_estimates_at_data(PN::Loop_scheme(), true);
}

TEST(Round_interpolation, WithoutNormalsTakesRoundnessAndEstimateThatAreGiven)
{
  for (const Surface_mesh& data : meshes_of(true)) {
    Surface_mesh mesh = data;
    test_options::Limit_interpolation_options<> options;
    options.max_steps = 200;
    const auto np =
      PN::parameters::roundness(.5).control_normal_estimate(PN::Control_normal_estimate::angle);
    const auto report = PN::interpolate_limit_points(mesh, PN::Loop_scheme(),
                                                     PN::parameters::join(options.pack(), np));
    EXPECT_LE(report.residual, report.tolerance);
    PN::subdivide_to_limit(mesh, PN::Loop_scheme(), np.number_of_iterations(0));
    for (auto v : mesh.vertices())
      EXPECT_LE(CGAL::squared_distance(mesh.point(v), data.point(v)), 1e-16);
  }
}

TEST(Round_interpolation, WithoutNormalsOthersDoNotMove)
{
  Surface_mesh data = meshes_of(true).back(), mesh = data;
  const auto some = [](Vertex v) { return v.idx() % 2 == 0; };
  test_options::Limit_interpolation_options<> smooth;
  smooth.mode = Mode::strict;
  smooth.free = PN::Limit_interpolation::Free::smooth;
  EXPECT_THROW(PN::interpolate_limit_points(mesh, PN::Loop_scheme(), smooth.pack()),
               std::invalid_argument);
  auto chosen = mesh.add_property_map<Vertex, bool>("v:chosen", false).first;
  for (auto v : mesh.vertices()) chosen[v] = some(v);
  test_options::Limit_interpolation_options<decltype(chosen)> options;
  options.vertices = chosen;
  options.max_steps = 200;
  const auto report = PN::interpolate_limit_points(mesh, PN::Loop_scheme(), options.pack());
  EXPECT_LE(report.residual, report.tolerance);
  for (auto v : mesh.vertices())
    if (!some(v)) {
      EXPECT_EQ(mesh.point(v), data.point(v));
    }
}

// the data point and the limit are the ends of an arc, along which the normal turns from one to the other
TEST(Round_interpolation, SlidesAlongArcs)
{
  for (const Surface_mesh& data : meshes_of(false)) {
    Surface_mesh mesh = data;
    interpolate(mesh, PN::CatmullClark_scheme(), Mode::slide);
    Surface_mesh limit = at_limit(mesh, PN::CatmullClark_scheme()), before = data;
    double farthest = 0;
    for (auto v : mesh.vertices()) {
      farthest = (std::max)(farthest, CGAL::squared_distance(data.point(v), limit.point(v)));
      const auto m = normal_map(before)[v];
      const auto n = normal_map(limit)[v];
      if (mesh.is_border(v)) continue; // there the control normal stands for that of the surface
      EXPECT_LT(std::abs((m + n) * (data.point(v) - limit.point(v))), 1e-7);
    }
    EXPECT_GT(farthest, 1e-4); // it slides
  }
}

TEST(Round_interpolation, PrescribesPointsAndNormals)
{
  for (const Surface_mesh& data : meshes_of(true)) {
    Surface_mesh mesh = data;
    const auto points = mesh.add_property_map<Vertex, std::optional<Kernel::Point_3>>("v:p").first;
    const auto normals =
      mesh.add_property_map<Vertex, std::optional<Kernel::Vector_3>>("v:n").first;
    const Vertex v(0);
    points[v] = mesh.point(v) + Kernel::Vector_3(0.05, -0.03, 0.02);
    const Kernel::Vector_3 n = normal_map(mesh)[v] + Kernel::Vector_3(0.2, 0.1, -0.1);
    normals[v] = n / std::sqrt(n.squared_length());
    PN::prescribe_limit_data(
      mesh, PN::Loop_scheme(),
      PN::parameters::join(
        PN::parameters::prescribed_point_map(points).prescribed_normal_map(normals),
        with_maps(mesh)));
    Surface_mesh limit = at_limit(mesh, PN::Loop_scheme());
    EXPECT_LT(CGAL::squared_distance(limit.point(v), *points[v]), 1e-22);
    EXPECT_LT((normal_map(limit)[v] - *normals[v]).squared_length(), 1e-12);
  }
}

TEST(Round_interpolation, RefusesWhatIsOutOfRange)
{
  Surface_mesh mesh = meshes_of(true)[0];
  const Surface_mesh before = mesh;
  roundness_map(mesh)[Vertex(3)] = 1.75;
  for (const Mode mode : {Mode::strict, Mode::slide})
    messages::expect_refused([&] { interpolate(mesh, PN::Loop_scheme(), mode); },
                             {"of vertex 3 is 1.75"});
  for (auto v : mesh.vertices()) EXPECT_EQ(mesh.point(v), before.point(v));
}

// roundness of the mesh's own numbers, which no conversion makes a double
TEST(Round_interpolation, TakesExactNumbers)
{
  long_test([](auto) {
    using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
    using Mesh = CGAL::Surface_mesh<Exact::Point_3>;
    Surface_mesh mesh = meshes_of(true)[0];
    Mesh exact;
    std::vector<Mesh::Vertex_index> of;
    const auto normals = exact.add_property_map<Mesh::Vertex_index, Exact::Vector_3>("n").first;
    const auto roundness = exact.add_property_map<Mesh::Vertex_index, Exact::FT>("w").first;
    for (auto v : mesh.vertices()) {
      const auto& p = mesh.point(v);
      const auto& n = normal_map(mesh)[v];
      of.push_back(exact.add_vertex(Exact::Point_3(p.x(), p.y(), p.z())));
      normals[of.back()] = Exact::Vector_3(n.x(), n.y(), n.z());
      roundness[of.back()] = roundness_map(mesh)[v];
    }
    for (auto f : mesh.faces()) {
      std::vector<Mesh::Vertex_index> corners;
      for (auto v : mesh.vertices_around_face(mesh.halfedge(f))) corners.push_back(of[v.idx()]);
      exact.add_face(corners);
    }
    test_options::Limit_interpolation_options<> options;
    options.mode = Mode::strict;
    interpolate(mesh, PN::Loop_scheme(), Mode::strict);
    PN::interpolate_limit_points(
      exact, PN::Loop_scheme(),
      PN::parameters::join(
        options.pack(),
        PN::parameters::vertex_roundness_map(roundness).vertex_normal_map(normals)));
    for (auto v : mesh.vertices()) {
      const auto& p = exact.point(of[v.idx()]);
      const Kernel::Point_3 q(CGAL::to_double(p.x()), CGAL::to_double(p.y()),
                              CGAL::to_double(p.z()));
      EXPECT_LT(CGAL::squared_distance(mesh.point(v), q), 1e-24);
    }
  });
}

} // namespace

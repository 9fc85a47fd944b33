// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Control normals by reciprocal weights and arcs: against true normals, against the reference, and
// what must not change them.

#include "Estimated_normals.h"

using namespace estimated_normals;
using namespace sampled_surfaces;

namespace {

const Cells all_cells[] = {Cells::quads, Cells::triangles, Cells::mixed};

std::vector<Control_mesh> exact_shapes()
{
  std::vector<Control_mesh> shapes;
  for (unsigned seed : {1u, 2u, 3u})
    for (int rounds : {1, 2}) shapes.push_back(scattered(rounds, 0.3, seed, on_sphere));
  shapes.push_back(scattered(0, 0.01, 4, on_sphere)); // icosahedron: 37 degrees
  std::mt19937 generator(5);
  const Numbers u = uneven(13, 0.4, generator), v = uneven(9, 0.5, generator);
  for (Cells cells : all_cells) {
    shapes.push_back(patch(12, 8, 0.3, cells, 6, cap(0.6)));
    shapes.push_back(cylinder(u, v, 3, cells));
    shapes.push_back(torus(u, v, cells));
  }
  shapes.push_back(cone(u, v, Cells::quads));
  return shapes;
}

// a few that leave no guard aside: wide fans, borders of all kinds, neighbors only on the border
std::vector<Control_mesh> any_shapes()
{
  std::vector<Control_mesh> shapes = exact_shapes();
  for (const Control_mesh& mesh : test_meshes::all())
    if (!test_meshes::has_isolated_vertex(mesh)) shapes.push_back(mesh);
  shapes.push_back(patch(12, 8, 0.25, Cells::triangles, 1, on_waves));
  shapes.push_back(scattered(1, 0.3, 1, on_ellipsoid));
  return shapes;
}

constexpr auto every_vertex = [](int) { return true; };

} // namespace

TEST(Reciprocal_normals, AreExactOnSpheresAndSurfacesOfRevolution)
{
  for (const Control_mesh& mesh : exact_shapes())
    EXPECT_LE(largest_distance(estimated(mesh), mesh.normals), 16 * ulp) << mesh.name;
}

TEST(Reciprocal_normals, AgreeWithTheReference)
{
  for (const Control_mesh& mesh : any_shapes()) {
    const reference::Face_list list = test_meshes::face_list(mesh);
    const auto points = reference_points(mesh);
    const reference::Control_normals normals(list, points);
    EXPECT_LE(largest_distance(estimated(mesh), triples(normals.reciprocal())), 16 * ulp)
      << mesh.name;
    EXPECT_LE(largest_distance(estimated(mesh, Control_normal_estimate::angle),
                               triples(normals.angle_weighted())),
              16 * ulp)
      << mesh.name;
  }
}

// General surfaces, sampled about as densely as those of the table in the manual: rms and largest
// angle in degrees, interior and border. The bars are 1.1 times what was measured.
TEST(Reciprocal_normals, ErrorsOnGeneralSurfaces)
{
  const auto ellipsoid = scattered(2, 0.35, 1, on_ellipsoid);
  const auto quads = patch(12, 8, 0, Cells::quads, 2, on_waves);
  const auto triangles = patch(12, 8, 0.25, Cells::triangles, 2, on_waves);
  const auto on_border = [](int v) { return v < 13 || v >= 8 * 13 || v % 13 == 0 || v % 13 == 12; };
  const auto inside = [&](int v) { return !on_border(v); };
  struct Row
  {
    const Control_mesh& mesh;
    std::function<bool(int)> counts;
    const char* name;
  };
  for (const auto& [mesh, counts, name] :
       {Row{ellipsoid, every_vertex, "ellipsoid"}, Row{quads, inside, "graph, quads, inside"},
        Row{quads, on_border, "graph, quads, border"},
        Row{triangles, inside, "graph, triangles, inside"},
        Row{triangles, on_border, "graph, triangles, border"}}) {
    const Angles a = angles(mesh, estimated(mesh, Control_normal_estimate::angle), counts);
    const Angles r = angles(mesh, estimated(mesh), counts);
    std::cout << name << ": angle " << a.rms << " / " << a.largest << ", reciprocal " << r.rms
              << " / " << r.largest << '\n';
    EXPECT_LT(r.rms, a.rms) << name;
  }
}

TEST(Reciprocal_normals, PlaceAndDirectionHaveNoPart)
{
  const auto estimate = [](const Control_mesh& mesh) { return Estimates{estimated(mesh), {}}; };
  const std::vector<Control_mesh> meshes = any_shapes();
  expect_similarities_commute(meshes, estimate, {-300}, 256 * ulp);
  expect_reversed_faces_reverse(meshes, estimate, 32 * ulp);
}

// Along a way from one set of points to another nothing jumps: the largest step falls with the
// number of steps. The way crosses the blend from 40 to 60 degrees many times.
TEST(Reciprocal_normals, AreContinuous)
{
  for (Control_mesh mesh :
       {patch(6, 5, 0.2, Cells::mixed, 3, cap(0.5)), scattered(1, 0.3, 2, on_ellipsoid)}) {
    const auto start = mesh.points;
    const auto largest_step = [&](int steps) {
      double largest = 0;
      std::vector<Triple> before;
      for (int i = 0; i <= steps; ++i) {
        const double t = double(i) / steps;
        for (std::size_t v = 0; v < start.size(); ++v)
          mesh.points[v] = {start[v][0], start[v][1],
                            (1 + t) * start[v][2] + 0.07 * t * std::sin(5. * double(v))};
        const auto now = estimated(mesh);
        if (i > 0) largest = (std::max)(largest, largest_distance(now, before));
        before = now;
      }
      return largest;
    };
    const double coarse = largest_step(100), fine = largest_step(1600);
    EXPECT_GT(coarse, 1e-3);
    EXPECT_LE(fine, coarse / 12) << mesh.name;
  }
}

// longer numbers give longer normals
TEST(Reciprocal_normals, LongDouble)
{
  using K = CGAL::Simple_cartesian<long double>;
  const Control_mesh rough = patch(6, 5, 0.3, Cells::mixed, 9, cap(0.5));
  auto mesh = to_mesh<K>(rough);
  for (auto v : mesh.vertices()) {
    const Vector p = Vector(mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()).normalized();
    mesh.point(v) = K::Point_3(p[0], p[1], p[2]);
  }
  auto n = mesh.add_property_map<CGAL::SM_Vertex_index, K::Vector_3>("n").first;
  CGAL::PN_subdivision_3::estimate_control_normals(mesh, n);
  for (auto v : mesh.vertices()) {
    const auto error = n[v] - (mesh.point(v) - CGAL::ORIGIN);
    EXPECT_LE(std::sqrt(error.squared_length()), mesh.is_border(v) ? 16 * ulp : ulp / 64);
  }
}

TEST(Reciprocal_normals, Float)
{
  using K = CGAL::Simple_cartesian<float>;
  for (const Control_mesh& mesh : exact_shapes()) {
    const auto n = estimate<K>(mesh);
    for (std::size_t v = 0; v < n.size(); ++v)
      EXPECT_LE(distance({n[v].x(), n[v].y(), n[v].z()}, mesh.normals[v]), 2e-6) << mesh.name;
  }
}

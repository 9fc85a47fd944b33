// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Control_normal_estimate::coherent: normals and roundness from points.

#include "Estimated_normals.h"
#include "Named_shapes.h"
#include "reference/Coherent_normals.h"
#include "support/Exact_rational.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/PN_certificates_3/compare_with_linear.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/subdivide.h>

#include <algorithm>
#include <set>

using namespace estimated_normals;
using namespace sampled_surfaces;
using named_shapes::renamed;
namespace PN = CGAL::PN_subdivision_3;

namespace {

template <class K = CGAL::Simple_cartesian<double>>
Estimates coherent(const Control_mesh& control)
{
  auto mesh = to_mesh<K>(control);
  using Vertex = CGAL::SM_Vertex_index;
  const auto normals = mesh.template add_property_map<Vertex, typename K::Vector_3>("n").first;
  const auto roundness = mesh.template add_property_map<Vertex, double>("w", -1).first;
  PN::estimate_control_normals(mesh, normals, PN::parameters::vertex_roundness_map(roundness));
  Estimates result;
  for (auto v : mesh.vertices()) {
    const auto& n = normals[v];
    result.normals.push_back(
      {CGAL::to_double(n.x()), CGAL::to_double(n.y()), CGAL::to_double(n.z())});
    result.roundness.push_back(roundness[v]);
  }
  return result;
}

Control_mesh scaled(const Control_mesh& mesh, double x, double y, double z)
{
  return moved(mesh, [&](const Vector& p) -> Vector { return p.cwiseProduct(Vector(x, y, z)); });
}

Control_mesh on_unit_sphere(Control_mesh mesh)
{
  mesh.normals.clear();
  for (Triple& p : mesh.points) mesh.normals.push_back(p = test_meshes::unit(p));
  return mesh;
}

Control_mesh octahedron()
{
  Control_mesh mesh = test_meshes::bipyramid(4);
  for (std::size_t i = 0; i < 4; ++i)
    mesh.points[i] = {double(i == 0) - double(i == 2), double(i == 1) - double(i == 3), 0};
  mesh.points[4] = {0, 0, 1};
  mesh.points[5] = {0, 0, -1};
  return renamed(on_unit_sphere(mesh), "octahedron");
}

// n x n squares bent by a right angle along the middle
Control_mesh bent_plane(int n)
{
  Control_mesh mesh = test_meshes::grid(2 * n, n, false, false, Cells::quads);
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const int i = int(v) % (2 * n + 1), j = int(v) / (2 * n + 1);
    mesh.points[v] = {double((std::max)(i - n, 0)), double(j), double((std::max)(n - i, 0))};
  }
  return mesh;
}

// a rectangle with corners rounded by arcs of 90 degrees
std::vector<Sample> rounded_rectangle(double a, double b, double radius, int steps)
{
  std::vector<Sample> outline;
  for (int corner = 0; corner < 4; ++corner)
    for (int k = 0; k <= steps; ++k) {
      const Real t = pi / 2 * (corner + Real(k) / steps);
      const Vector n(std::cos(t), std::sin(t), 0);
      const Real x = corner == 0 || corner == 3 ? a / 2 - radius : radius - a / 2;
      const Real y = corner < 2 ? b / 2 - radius : radius - b / 2;
      outline.push_back({Vector(x, y, 0) + radius * n, n});
    }
  return outline;
}

// quads between outlines of n points each
void add_strips(Control_mesh& mesh, int n, int rows)
{
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < n; ++i)
      mesh.faces.push_back(
        {n * j + i, n * j + (i + 1) % n, n * (j + 1) + (i + 1) % n, n * (j + 1) + i});
}

// a closed ring of `rows` strips around a rounded rectangle
Control_mesh rounded_beam(double a, double b, double radius, int steps, int rows)
{
  const std::vector<Sample> outline = rounded_rectangle(a, b, radius, steps);
  Control_mesh mesh{"rounded beam", {}, {}, {}};
  const int n = int(outline.size());
  for (int j = 0; j <= rows; ++j)
    for (const Sample& s : outline) add(mesh, {s.point + Vector(0, 0, 0.4L * j), s.normal});
  add_strips(mesh, n, rows);
  return mesh;
}

// a closed plate of thickness 1 with chamfers all around, its planes cut into triangles
Control_mesh chamfered_plate(double side, double chamfer = 0.2)
{
  Control_mesh mesh{"chamfered plate", {}, {}, {}};
  for (const double z : {0., chamfer, 1 - chamfer, 1.}) {
    const double inset = z == 0 || z == 1 ? chamfer : 0;
    for (const Sample& s : rounded_rectangle(side - 2 * inset, side - 2 * inset, 0.5 - inset, 3))
      add(mesh, {s.point + Vector(0, 0, z), s.normal});
  }
  const int n = int(mesh.points.size()) / 4;
  add_strips(mesh, n, 3);
  for (int i = 1; i + 1 < n; ++i) {
    mesh.faces.push_back({0, i + 1, i});
    mesh.faces.push_back({3 * n, 3 * n + i, 3 * n + i + 1});
  }
  return mesh;
}

// a closed plate of thickness 1: two rectangles that end in bevels of width 1, which fall by 1/3, and corners cut off
Control_mesh beveled_plate(double a, double b)
{
  constexpr double drop = 1 / 3.;
  Control_mesh mesh{"beveled plate", {}, {}, {}};
  const double x[4] = {a, 0, 0, a}, y[4] = {b, b, 0, 0};
  for (int corner = 0; corner < 4; ++corner) { // top and bottom, then the bevels counterclockwise
    const double out_x = corner == 0 || corner == 3 ? 1 : -1, out_y = corner < 2 ? 1 : -1;
    const bool x_first = corner % 2 == 0;
    for (double z : {0., 1.}) mesh.points.push_back({x[corner], y[corner], z});
    for (bool moves_x : {x_first, !x_first})
      for (double z : {drop, 1 - drop})
        mesh.points.push_back(
          {x[corner] + (moves_x ? out_x : 0), y[corner] + (moves_x ? 0 : out_y), z});
  }
  mesh.faces = {{18, 12, 6, 0}, {1, 7, 13, 19}};
  for (int k = 0; k < 24; k += 6) { // at a corner, and from there to the next one
    const int next = (k + 6) % 24;
    mesh.faces.push_back({k, k + 4, k + 2});
    mesh.faces.push_back({k + 1, k + 3, k + 5});
    mesh.faces.push_back({k + 2, k + 4, k + 5, k + 3});
    mesh.faces.push_back({k + 4, next + 2, next + 3, k + 5});
    mesh.faces.push_back({k, next, next + 2, k + 4});
    mesh.faces.push_back({k + 1, k + 5, next + 3, next + 1});
  }
  return mesh;
}

// Two planes with a bevel of two strips between them, long and narrow, which ends in inner corners; none of it even.
Control_mesh ends_of_bevels(unsigned seed)
{
  std::mt19937 generator(seed);
  const auto random = [&] { return double(generator()) / double(generator.max()); };
  const double length = 5 * std::pow(6, random()), width = 0.06 + 0.14 * random();
  Control_mesh mesh{"ends of bevels " + std::to_string(seed), {}, {}, {}};
  const std::vector<Triple> end = {
    {1, 0, 0.4},      {0, 0, 0},       {-0.4, 0, -1},  {-0.4, 1.4, 0.2}, {1, 1.4, 0.4},
    {-0.8, 1, -1},    {-1.8, 1.4, -1}, {-1.8, 1.8, 0}, {-0.4, 2.8, 0.4}, {1, 2.8, 0.4},
    {-1.8, 2.8, 0.4}, {40, 0, 0.4},    {40, 1.4, 0.4}, {-0.4, 0, -40},   {-0.8, 1, -40},
    {-1.8, 1.4, -40}, {40, 2.8, 0.4}};
  const int n = int(end.size());
  for (double side : {1., -1.})
    for (Triple p : end) {
      for (double& x : p)
        x = width * (std::abs(x) < 40 ? x + 0.6 * random() * (random() - 0.5) : x);
      mesh.points.push_back({p[0], side > 0 ? p[1] : -length - p[1], p[2]});
    }
  for (const reference::Face& f : std::vector<reference::Face>{{9, 8, 3, 4},
                                                               {10, 7, 3, 8},
                                                               {6, 5, 3, 7},
                                                               {2, 1, 3, 5},
                                                               {0, 4, 3, 1},
                                                               {0, 11, 12, 4},
                                                               {2, 5, 14, 13},
                                                               {5, 6, 15, 14},
                                                               {4, 12, 16, 9}}) {
    mesh.faces.push_back(f);
    mesh.faces.push_back({n + f[3], n + f[2], n + f[1], n + f[0]});
  }
  for (const auto& [a, b] : std::vector<std::pair<int, int>>{{1, 0}, {2, 1}, {0, 11}, {13, 2}})
    mesh.faces.push_back({a, n + a, n + b, b});
  return mesh;
}

// Of a lattice of 4 x 4 x 4 points what is outside, with the outer layers in the same place as those next to them: the
// points on the edges of the box have no normals.
Control_mesh box_with_bevels_of_no_width()
{
  Control_mesh mesh = renamed(test_meshes::box_of_cells({3, 3, 3}), "box with bevels of no width");
  for (Triple& p : mesh.points) p = {p[0] < 2 ? 0. : 12., p[1] < 2 ? 0. : 7., p[2] < 2 ? 0. : 3.};
  return mesh;
}

// `n` rows around a cylinder of radius 1, with steps along its axis that are shorter than those around it by far
Control_mesh short_rows(int n)
{
  std::mt19937 generator(3);
  const Numbers turns = uneven(65, 0.8, generator);
  return renamed(cylinder(turns, uneven(n, 0, generator), 0.002L * (n - 1), Cells::quads),
                 "short rows");
}

std::vector<Control_mesh> exact_shapes()
{
  std::vector<Control_mesh> shapes{on_unit_sphere(named_shapes::cube()), octahedron(),
                                   scattered(0, 0, 4, on_sphere)};
  shapes.push_back(on_unit_sphere(named_shapes::dual(shapes[2], "dodecahedron")));
  for (unsigned seed : {1u, 2u, 3u})
    for (int rounds : {1, 2}) shapes.push_back(scattered(rounds, 0.3, seed, on_sphere));
  std::mt19937 generator(5);
  for (Cells cells : {Cells::quads, Cells::triangles, Cells::mixed})
    shapes.push_back(patch(12, 8, 0.3, cells, 6, cap(0.6)));
  const Numbers heights = uneven(6, 0.5, generator);
  for (int n = 3; n <= 16; ++n)
    for (Real unevenness : {0., 0.25}) {
      if (unevenness == 0 ? n > 12 : n < 7) continue;
      const Numbers turns = uneven(n + 1, unevenness, generator);
      shapes.push_back(
        renamed(cylinder(turns, heights, 3, Cells::quads), "cylinder of " + std::to_string(n)));
    }
  return shapes;
}

std::vector<Control_mesh> any_shapes()
{
  std::vector<Control_mesh> shapes = exact_shapes();
  for (const Control_mesh& mesh : test_meshes::all())
    if (!test_meshes::has_isolated_vertex(mesh)) shapes.push_back(mesh);
  std::mt19937 generator(7);
  const Numbers u = uneven(13, 0.4, generator), v = uneven(9, 0.5, generator);
  shapes.push_back(torus(u, v, Cells::mixed));
  shapes.push_back(cone(u, v, Cells::quads));
  shapes.push_back(patch(12, 8, 0.25, Cells::triangles, 1, on_waves));
  shapes.push_back(scattered(1, 0.3, 1, on_ellipsoid));
  shapes.push_back(scattered(0, 0.2, 3, on_ellipsoid));
  shapes.push_back(bent_plane(5));
  for (int steps : {1, 2, 3, 6}) shapes.push_back(rounded_beam(4.6, 2.6, 0.3, steps, 4));
  for (int rows : {20, 26, 50}) // a square beam: the fans are regular but uneven
    shapes.push_back(
      cylinder(uneven(5, 0, generator), uneven(rows, 0.3, generator), 3, Cells::quads));
  for (double length : {1.3, 3., 50.})
    shapes.push_back(scaled(named_shapes::cube(), 1, 1.5, length));
  for (int n : {3, 4, 5, 8}) shapes.push_back(scaled(named_shapes::prism(n), 1, 1.1, 1.4));
  for (double side : {2., 4., 20.}) shapes.push_back(chamfered_plate(side));
  for (double side : {10., 15., 16., 17., 18., 19., 20., 70.})
    shapes.push_back(beveled_plate(side, 1.4 * side));
  for (unsigned seed = 0; seed < 12; ++seed) shapes.push_back(ends_of_bevels(seed));
  shapes.push_back(chamfered_plate(5, 0));
  shapes.push_back(box_with_bevels_of_no_width());
  return shapes;
}

// the convex hull of random points of a sphere: triangles of any shape
Control_mesh random_sphere(int n, unsigned seed)
{
  std::mt19937 generator(seed);
  std::normal_distribution<double> number;
  Control_mesh mesh{
    "random sphere of " + std::to_string(n) + ", " + std::to_string(seed), {}, {}, {}};
  for (int v = 0; v < n; ++v) {
    const double x = number(generator), y = number(generator), z = number(generator);
    mesh.points.push_back({x, y, z});
  }
  mesh = on_unit_sphere(mesh);
  const auto at = [&](int v) {
    return Vector(mesh.points[v][0], mesh.points[v][1], mesh.points[v][2]);
  };
  const auto is_seen = [&](const reference::Face& f, int v) {
    return (at(f[1]) - at(f[0])).cross(at(f[2]) - at(f[0])).dot(at(v) - at(f[0])) > 0;
  };
  mesh.faces = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  if (is_seen(mesh.faces[0], 3))
    for (reference::Face& f : mesh.faces) std::swap(f[0], f[1]);
  for (int v = 4; v < n; ++v) {
    std::set<std::pair<int, int>> edges; // of what the point sees
    std::vector<reference::Face> faces;
    for (const reference::Face& f : mesh.faces)
      if (!is_seen(f, v))
        faces.push_back(f);
      else
        for (std::size_t i = 0; i < 3; ++i) edges.emplace(f[i], f[(i + 1) % 3]);
    for (const auto& [a, b] : edges)
      if (edges.count({b, a}) == 0) faces.push_back({a, b, v});
    mesh.faces = faces;
  }
  return mesh;
}

// of the planes of faces from the normals at their corners, in degrees
double largest_turn(const Control_mesh& mesh)
{
  double least = 1;
  for (const reference::Face& f : mesh.faces) {
    const auto at = [&](std::size_t i) {
      const Triple& p = mesh.points[std::size_t(f[i])];
      return Vector(p[0], p[1], p[2]);
    };
    const Vector n = (at(1) - at(0)).cross(at(2) - at(0)).normalized();
    for (int v : f) {
      const Triple& m = mesh.normals[std::size_t(v)];
      least = (std::min)(least, double(n.dot(Vector(m[0], m[1], m[2]))));
    }
  }
  return std::acos(least) * 180 / double(pi);
}

// from 0 to 1; many a step is a thousandth of others
Numbers steps_of_any_size(int n, std::mt19937& generator)
{
  std::uniform_real_distribution<double> random(0, 1);
  Numbers x{0};
  for (int i = 0; i < n; ++i) {
    x.push_back(x.back() + 0.7 + 0.3 * random(generator));
    if (i % 2 == 0) x.push_back(x.back() + std::pow(10., -3 * random(generator)));
  }
  for (Real& y : x) y /= x.back();
  return x;
}

// triangles with a corner at a pole are needles
Control_mesh sphere_with_poles(const Numbers& turns, const Numbers& heights)
{
  Control_mesh mesh{"sphere with poles", {}, {}, {}};
  const int n = int(turns.size()) - 1, rows = int(heights.size()) - 2;
  for (int j = 1; j <= rows; ++j)
    for (int i = 0; i < n; ++i) {
      const Real u = 2 * pi * turns[std::size_t(i)], v = pi * heights[std::size_t(j)];
      const Vector p(std::sin(v) * std::cos(u), std::sin(v) * std::sin(u), -std::cos(v));
      add(mesh, {p, p});
    }
  add_strips(mesh, n, rows - 1);
  for (int side : {-1, 1}) {
    const int pole = int(mesh.points.size()), first = side < 0 ? 0 : n * (rows - 1);
    add(mesh, {Vector(0, 0, side), Vector(0, 0, side)});
    for (int i = 0; i < n; ++i) {
      const int a = first + i, b = first + (i + 1) % n;
      mesh.faces.push_back(side < 0 ? reference::Face{pole, b, a} : reference::Face{pole, a, b});
    }
  }
  return mesh;
}

} // namespace

TEST(Coherent_normals, AreExactOnRoundShapes)
{
  for (const Control_mesh& mesh : exact_shapes()) {
    const Estimates result = coherent(mesh);
    EXPECT_LE(largest_distance(result.normals, mesh.normals), 16 * ulp) << mesh.name;
    for (double w : result.roundness) EXPECT_EQ(w, 1) << mesh.name;
  }
}

TEST(Coherent_normals, AgreeWithTheReference)
{
  double worst = 0, worst_w = 0;
  int between = 0;
  for (const Control_mesh& mesh : any_shapes()) {
    const reference::Face_list list = test_meshes::face_list(mesh);
    const auto points = reference_points(mesh);
    const reference::Coherent_normals expected(list, points);
    const Estimates result = coherent(mesh);
    const double n = largest_distance(result.normals, triples(expected.normals));
    const double w =
      largest_difference(result.roundness, {expected.roundness.begin(), expected.roundness.end()});
    EXPECT_LE(n, 64 * ulp) << mesh.name;
    EXPECT_LE(w, 2048 * ulp) << mesh.name;
    worst = (std::max)(worst, n);
    worst_w = (std::max)(worst_w, w);
    for (double x : result.roundness) between += x > 0.01 && x < 0.99;
  }
  std::cout << "normals " << worst / ulp << ", roundness " << worst_w / ulp << " in 2^-52; "
            << between << " between 0 and 1\n";
  EXPECT_GE(between, 100);
}

TEST(Coherent_normals, SimilaritiesCommute)
{
  expect_similarities_commute(any_shapes(), coherent<>, {-600, -300, 300, 600}, 512 * ulp);
}

TEST(Coherent_normals, ReversedFacesReverseThem)
{
  expect_reversed_faces_reverse(any_shapes(), coherent<>, 64 * ulp);
}

TEST(Coherent_normals, AreTheReciprocalOnesBitForBitWhereTheseAreRight)
{
  int count = 0;
  for (const Control_mesh& mesh : exact_shapes()) {
    const bool is_wide = mesh.name == "cylinder of 3" || mesh.name == "cylinder of 4";
    if (is_wide || (mesh.name.find("cylinder") != 0 && mesh.name != "scattered")) continue;
    EXPECT_EQ(coherent(mesh).normals, estimated(mesh)) << mesh.name;
    ++count;
  }
  EXPECT_GE(count, 20);
}

TEST(Coherent_normals, RightAnglesBetweenPlanesAreNotRound)
{
  constexpr int n = 5;
  const Control_mesh mesh = bent_plane(n);
  const Estimates result = coherent(mesh);
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const int from_bend = std::abs(int(v) % (2 * n + 1) - n);
    EXPECT_EQ(result.roundness[v], from_bend < 2 ? 0 : 1) << v;
    if (from_bend == 0) continue;
    const Triple normal = int(v) % (2 * n + 1) < n ? Triple{1, 0, 0} : Triple{0, 0, 1};
    const Triple& m = result.normals[v];
    EXPECT_LE((std::min)(distance(m, normal), distance({-m[0], -m[1], -m[2]}, normal)), 4 * ulp);
  }
}

// Reciprocal weights bow the planes of a beam.
TEST(Coherent_normals, PlanesJoinBends)
{
  for (int steps : {2, 3, 6}) {
    const Control_mesh mesh = rounded_beam(4.6, 2.6, 0.3, steps, 4);
    const auto inside = [&](int v) {
      return v >= 4 * (steps + 1) && v < 16 * (steps + 1) && (v % (steps + 1) == 0);
    };
    const double now = angles(mesh, coherent(mesh).normals, inside).largest;
    const double before = angles(mesh, estimated(mesh), inside).largest;
    EXPECT_LT(now, before / 3) << steps;
  }
}

// Whatever the triangulation is, where no face turns by more than 36 degrees from the normals.
TEST(Coherent_normals, SpheresOfRandomPointsAreRound)
{
  const Eigen::AngleAxis<Real> turn(0.7L, Vector(1, 2, -0.5).normalized());
  int spheres = 0;
  for (int n : {40, 60, 100, 200})
    for (unsigned seed = 0; seed < 30; ++seed) {
      const Control_mesh mesh = random_sphere(n, seed);
      if (largest_turn(mesh) > 36) continue;
      ++spheres;
      const Control_mesh other =
        moved(mesh, [&](const Vector& p) -> Vector { return 1e-3L * (turn * p) + turn * p; });
      for (const Estimates& result : {coherent(mesh), coherent(other)})
        for (double w : result.roundness) EXPECT_EQ(w, 1) << mesh.name;
      EXPECT_LE(largest_distance(coherent(mesh).normals, mesh.normals), 1e-9) << mesh.name;
    }
  EXPECT_GE(spheres, 20);
}

// Meridians and parallels of which many are a thousandth of others apart, with poles. Exact normals of a cone do not
// meet by arcs across its quads.
TEST(Coherent_normals, GridsOfAnyStepsAreRound)
{
  for (unsigned seed = 0; seed < 8; ++seed) {
    std::mt19937 generator(seed);
    const Numbers turns = steps_of_any_size(14, generator),
                  heights = steps_of_any_size(7, generator);
    for (const Control_mesh& mesh :
         {renamed(cylinder(turns, heights, 3, Cells::quads), "cylinder of quads"),
          renamed(cylinder(turns, heights, 3, Cells::triangles), "cylinder of triangles"),
          renamed(cylinder(turns, heights, 3, Cells::mixed), "cylinder"),
          renamed(cone(turns, heights, Cells::quads), "cone"), sphere_with_poles(turns, heights)}) {
      const Estimates result = coherent(mesh);
      EXPECT_LE(largest_distance(result.normals, mesh.normals), 1e-9) << mesh.name << ' ' << seed;
      const auto least = std::min_element(result.roundness.begin(), result.roundness.end());
      EXPECT_EQ(*least, 1) << mesh.name << ' ' << seed << ", vertex "
                           << least - result.roundness.begin();
    }
  }
}

// They look like caps of a large sphere: normals at opposite rims fit an arc, and no face turns far.
TEST(Coherent_normals, PlanesThatEndInChamfersStayFlat)
{
  const Control_mesh control = chamfered_plate(20);
  auto mesh = to_mesh<CGAL::Simple_cartesian<double>>(control);
  PN::subdivide(mesh, PN::CatmullClark_scheme(), CGAL::parameters::number_of_iterations(2));
  double largest = 0;
  for (auto v : mesh.vertices()) largest = (std::max)(largest, std::abs(mesh.point(v).z() - 0.5));
  EXPECT_LT(largest, 0.75); // of 0.5 at first; 1.09 if they are caps
}

// New points slide along such planes, and the normals of the bevels would lift them: to 2.3 times the volume.
TEST(Coherent_normals, ThinPlatesWithBevelsAreNotWorseThanLinear)
{
  for (double side : {16., 20., 40., 70., 300.}) {
    const auto mesh = to_mesh<CGAL::Simple_cartesian<double>>(beveled_plate(side, 1.4 * side));
    const auto result = PN::compare_with_linear(mesh, PN::CatmullClark_scheme(),
                                                CGAL::parameters::number_of_iterations(2));
    ASSERT_TRUE(result.is_closed);
    EXPECT_FALSE(result.is_swollen())
      << side << ": " << result.volume_ratio << ", linear " << result.linear_volume_ratio;
  }
}

// Arcs over such narrow faces miss each other by more than their width, and new points would fold them.
TEST(Coherent_normals, EndsOfBevelsDoNotFold)
{
  for (unsigned seed = 0; seed < 40; ++seed) {
    const auto mesh = to_mesh<CGAL::Simple_cartesian<double>>(ends_of_bevels(seed));
    const auto result = PN::compare_with_linear(mesh, PN::CatmullClark_scheme(),
                                                CGAL::parameters::number_of_iterations(2));
    EXPECT_LE(result.folded_edges, result.linear_folded_edges) << seed;
  }
}

// The faces between the two are not narrow: arcs over them miss each other by rounding, no more.
TEST(Coherent_normals, PlanesWithARowTwiceAreRound)
{
  const Eigen::AngleAxis<Real> turn(0.7L, Vector(1, 2, -0.5).normalized());
  Control_mesh mesh = test_meshes::grid(6, 6, false, false, Cells::quads);
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const int i = int(v) % 7, j = int(v) / 7;
    const Vector p = turn * Vector(i, j < 3 ? j : j - 1, 0);
    mesh.points[v] = {double(p[0]), double(p[1]), double(p[2])};
  }
  for (double w : coherent(mesh).roundness) EXPECT_EQ(w, 1);
}

// poles of as many points as there are meridians, which have no normals
TEST(Coherent_normals, SpheresWithPointsThatCoincideAtThePolesAreRoundBesideThem)
{
  constexpr int n = 16, rows = 8;
  Control_mesh mesh{"sphere with poles", {}, {}, {}};
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i < n; ++i) {
      const Real u = 2 * pi * i / n, v = pi * j / rows, r = j % rows == 0 ? 0 : std::sin(v);
      const Vector p(r * std::cos(u), r * std::sin(u), -std::cos(v));
      add(mesh, {p, p});
    }
  add_strips(mesh, n, rows);
  const Estimates result = coherent(mesh);
  for (std::size_t v = 2 * n; v < n * (rows - 1); ++v) {
    EXPECT_LE(distance(result.normals[v], mesh.normals[v]), 64 * ulp) << v;
    EXPECT_EQ(result.roundness[v], 1) << v;
  }
}

TEST(Coherent_normals, PointsThatCoincideAreAlikeRound)
{
  const Control_mesh mesh = box_with_bevels_of_no_width();
  const Estimates result = coherent(mesh);
  int pairs = 0;
  for (const reference::Face& f : mesh.faces)
    for (std::size_t i = 0; i < 4; ++i) {
      const auto v = std::size_t(f[i]), w = std::size_t(f[(i + 1) % 4]);
      if (mesh.points[v] != mesh.points[w]) continue;
      EXPECT_EQ(result.roundness[v], result.roundness[w]) << v << ' ' << w;
      ++pairs;
    }
  EXPECT_EQ(pairs, 144); // 24 on each side
}

// Long edges dip far below the tangent planes there, and new points lie below these, but not below the neighbors.
TEST(Coherent_normals, ShortRowsOfACylinderAreRound)
{
  Control_mesh rows = short_rows(6);
  for (bool outward : {true, false}) {
    for (double w : coherent(rows).roundness) EXPECT_EQ(w, 1) << outward;
    for (reference::Face& f : rows.faces) std::reverse(f.begin(), f.end());
  }
}

TEST(Coherent_normals, PartsHaveNoPartInOthers)
{
  const Control_mesh sphere = scattered(2, 0.3, 2, on_sphere), plate = beveled_plate(70, 90);
  Control_mesh both = sphere;
  const int n = int(sphere.points.size());
  both.points.insert(both.points.end(), plate.points.begin(), plate.points.end());
  for (reference::Face f : plate.faces) {
    for (int& v : f) v += n;
    both.faces.push_back(f);
  }
  const Estimates of_both = coherent(both), of_sphere = coherent(sphere),
                  of_plate = coherent(plate);
  EXPECT_EQ(of_plate.roundness[0], 0);
  for (std::size_t v = 0; v < both.points.size(); ++v) {
    const bool is_first = v < sphere.points.size();
    const Estimates& one = is_first ? of_sphere : of_plate;
    const std::size_t i = is_first ? v : v - sphere.points.size();
    EXPECT_EQ(of_both.normals[v], one.normals[i]) << v;
    EXPECT_EQ(of_both.roundness[v], one.roundness[i]) << v;
  }
}

// the normals of the ellipsoid through the corners: a / (a^2, b^2, c^2)
TEST(Coherent_normals, BoxesHaveAreaNormals)
{
  const Control_mesh mesh = scaled(named_shapes::cube(), 1, 2, 5);
  const Estimates result = coherent(mesh);
  for (std::size_t v = 0; v < 8; ++v) {
    const Triple& p = mesh.points[v];
    const Triple expected = test_meshes::unit({1 / p[0], 1 / p[1], 1 / p[2]});
    EXPECT_LE(distance(result.normals[v], expected), 4 * ulp);
    EXPECT_EQ(result.roundness[v], 0);
  }
}

TEST(Coherent_normals, DegenerateMeshes)
{
  std::vector<Control_mesh> shapes;
  shapes.push_back({"empty", {}, {}, {}});
  shapes.push_back({"isolated", {{1, 2, 3}}, {}, {}});
  Control_mesh flat = scaled(scattered(1, 0.3, 1, on_sphere), 1, 1, 0);
  shapes.push_back(renamed(flat, "flat"));
  shapes.push_back(renamed(scaled(flat, 1, 0, 0), "a line"));
  shapes.push_back(renamed(scaled(flat, 0, 0, 0), "a point"));
  Control_mesh repeated = scattered(1, 0.3, 1, on_sphere);
  for (std::size_t v = 0; v + 1 < repeated.points.size(); v += 3)
    repeated.points[v] = repeated.points[v + 1];
  shapes.push_back(renamed(repeated, "repeated points"));
  shapes.push_back(
    renamed(scaled(scattered(1, 0.3, 1, on_sphere), 0x1p600, 0x1p-600, 1), "wide range"));
  shapes.push_back(
    renamed(scaled(scattered(1, 0.3, 1, on_sphere), 1e-320, 1e-320, 1e-320), "denormal"));
  for (const Control_mesh& mesh : shapes) {
    for (const Estimates& result :
         {coherent(mesh), coherent<CGAL::Exact_predicates_exact_constructions_kernel>(mesh)})
      for (std::size_t v = 0; v < mesh.points.size(); ++v) {
        const Triple& n = result.normals[v];
        const double length = std::hypot(n[0], n[1], n[2]), w = result.roundness[v];
        EXPECT_TRUE(length == 0 || std::abs(length - 1) < 64 * ulp) << mesh.name << ' ' << v;
        EXPECT_TRUE(w >= 0 && w <= 1) << mesh.name << ' ' << v << ' ' << w;
        if (length == 0 && mesh.name != "isolated") EXPECT_EQ(w, 0) << mesh.name << ' ' << v;
      }
  }
  EXPECT_EQ(coherent(shapes[1]).roundness[0], 1);
}

TEST(Coherent_normals, ExactTypesKeepExactDirections)
{
  using FT = CGAL::Exact_rational;
  using K = CGAL::Simple_cartesian<FT>;
  const Control_mesh rough = patch(6, 5, 0.3, Cells::mixed, 9, cap(0.5));
  auto mesh = to_mesh<K>(rough);
  for (auto v : mesh.vertices()) { // stereographic projection
    const FT x(rough.points[v][0] / 2), y(rough.points[v][1] / 2), d = 1 + x * x + y * y;
    mesh.point(v) = K::Point_3(2 * x / d, 2 * y / d, (1 - x * x - y * y) / d);
  }
  auto n = mesh.add_property_map<CGAL::SM_Vertex_index, K::Vector_3>("n").first;
  PN::estimate_control_normals(mesh, n);
  int interior = 0;
  for (auto v : mesh.vertices()) {
    const K::Vector_3 radius = mesh.point(v) - CGAL::ORIGIN;
    if (!mesh.is_border(v)) {
      EXPECT_EQ(CGAL::cross_product(n[v], radius), K::Vector_3(0, 0, 0));
      ++interior;
    }
    EXPECT_LE(CGAL::to_double((n[v] - radius).squared_length()), 256 * ulp * ulp);
    EXPECT_LE(CGAL::to_double(CGAL::abs(n[v].squared_length() - 1)), 0x1p-46);
  }
  EXPECT_EQ(interior, 20);
}

TEST(Coherent_normals, GivenNormalsAreRound)
{
  const Control_mesh control = bent_plane(4);
  const auto mesh = to_mesh<CGAL::Simple_cartesian<double>>(control);
  PN::internal::with_mesh_access(mesh, [&](const auto& access) {
    const auto level = PN::internal::checked_level(access);
    const Triple between = test_meshes::unit({-1, 0, -1}), none{0, 0, 0};
    constexpr double nobodys = 0.25;
    std::vector<PN::Point_normal<double, 3>> values;
    std::vector<bool> is_given; // along the bend
    for (unsigned v = 0; v < control.points.size(); ++v) {
      is_given.push_back(v % 9 == 4);
      values.push_back({control.points[v], is_given[v] ? between : none, nobodys});
    }
    EXPECT_EQ(std::count(is_given.begin(), is_given.end(), false), 40);
    PN::internal::estimate_normals_of(level, Control_normal_estimate::coherent, values, &is_given);
    for (unsigned v = 0; v < values.size(); ++v) {
      EXPECT_EQ(values[v].normal == between, is_given[v]) << v;
      EXPECT_NE(values[v].normal, none) << v;
      EXPECT_EQ(values[v].roundness, is_given[v] ? nobodys : 1) << v;
    }
  });
}

TEST(Coherent_normals, OtherEstimatesAreRound)
{
  const Control_mesh control = bent_plane(4);
  const auto mesh = to_mesh<CGAL::Simple_cartesian<double>>(control);
  for (auto how : {Control_normal_estimate::reciprocal, Control_normal_estimate::angle})
    PN::internal::with_mesh_access(mesh, [&](const auto& access) {
      std::vector<PN::Point_normal<double, 3>> values;
      for (const Triple& p : control.points) values.push_back({p, {}, 0.5});
      PN::internal::estimate_normals_of<double>(PN::internal::checked_level(access), how, values);
      for (const auto& value : values) EXPECT_EQ(value.roundness, 1);
    });
}

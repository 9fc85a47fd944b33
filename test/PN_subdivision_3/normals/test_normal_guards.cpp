// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Where reciprocal weights and arcs give way: wide fans, degenerate ones, borders that say nothing.

#include "Estimated_normals.h"
#include "Named_shapes.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace estimated_normals;
using namespace sampled_surfaces;
namespace PN = CGAL::PN_subdivision_3;

namespace {

std::vector<Triple> by_angles(const Control_mesh& mesh)
{
  return estimated(mesh, Control_normal_estimate::angle);
}

bool all_are_unit_or_zero(const std::vector<Triple>& normals)
{
  return std::all_of(normals.begin(), normals.end(), [](const Triple& n) {
    const double l = std::hypot(n[0], n[1], n[2]);
    return l == 0 || std::abs(l - 1) < 8 * ulp;
  });
}

Control_mesh box(double a, double b, double c)
{
  Control_mesh mesh = named_shapes::cube();
  for (Triple& p : mesh.points) p = {a * p[0], b * p[1], c * p[2]};
  return mesh;
}

// a cone of n faces over vertex 0; its corner normals are turned by `degrees` from the axis
Control_mesh pyramid(int n, double degrees)
{
  const double t = degrees * std::acos(-1.) / 180, middle = std::acos(-1.) / n;
  Control_mesh mesh{"pyramid", {{0, 0, 0}}, {}, {}};
  for (int i = 0; i < n; ++i)
    mesh.points.push_back({std::cos(2 * middle * i + 0.3 * std::sin(5. * i) / n),
                           std::sin(2 * middle * i + 0.3 * std::sin(5. * i) / n),
                           -std::tan(t) * std::cos(middle)});
  for (int i = 1; i <= n; ++i) mesh.faces.push_back({0, i, i % n + 1});
  return mesh;
}

// an uneven part of a sphere, whose normals are known
Control_mesh part_of_sphere()
{
  return patch(6, 5, 0.3, Cells::triangles, 7, cap(0.5));
}

double error(const Control_mesh& mesh, const std::vector<Triple>& normals, std::size_t v)
{
  return distance(normals[v], mesh.normals[v]);
}

} // namespace

// --- the blend with angle weights ---

TEST(Normal_guards, BoxesAndBeamsKeepTheirAngleWeights)
{
  for (double length : {1., 3., 50.})
    EXPECT_EQ(estimated(box(1, 1.5, length)), by_angles(box(1, 1.5, length)));
}

TEST(Normal_guards, BoxesAndBeamsSwellNoMoreThanByAngleWeights)
{
  std::vector<Control_mesh> shapes;
  for (double length : {1., 3., 50.}) shapes.push_back(box(1, 1.5, length));
  for (int n : {3, 4, 5, 6}) shapes.push_back(test_meshes::house(n));
  for (const Control_mesh& shape : shapes) {
    double largest[3] = {0, 0, 0};
    for (const Triple& p : shape.points)
      for (std::size_t k = 0; k < 3; ++k) largest[k] = (std::max)(largest[k], std::abs(p[k]));
    const auto beyond = [&](Control_normal_estimate how) {
      auto mesh = to_mesh<CGAL::Simple_cartesian<double>>(shape);
      PN::subdivide(mesh, PN::internal::with_normal_estimate(PN::CatmullClark_scheme(), how),
                    CGAL::parameters::number_of_iterations(3));
      double result = 0;
      for (auto v : mesh.vertices())
        for (int k = 0; k < 3; ++k)
          result = (std::max)(result, std::abs(mesh.point(v)[k]) - largest[k]);
      return result;
    };
    EXPECT_LE(beyond(Control_normal_estimate::reciprocal),
              beyond(Control_normal_estimate::angle) + 1e-12)
      << shape.name;
  }
}

TEST(Normal_guards, FullWeightUpTo40DegreesNoneFrom60)
{
  for (double degrees : {20., 39., 61., 80.}) {
    const Control_mesh mesh = pyramid(7, degrees);
    const reference::Face_list list = test_meshes::face_list(mesh);
    const auto points = reference_points(mesh);
    const reference::Control_normals reference(list, points);
    const Triple n = estimated(mesh)[0], a = by_angles(mesh)[0];
    EXPECT_LE(distance(n, triples(reference.reciprocal())[0]), 16 * ulp) << degrees;
    if (degrees > 60)
      EXPECT_EQ(n, a) << degrees;
    else
      EXPECT_GT(distance(n, a), 1e-3) << degrees;
  }
}

TEST(Normal_guards, ReflexCornersKeepTheirAngleWeights)
{
  // a single polygon, nearly planar: the normals of its inner corners point the wrong way
  Control_mesh mesh{"star", {}, {{}}, {}};
  for (int i = 0; i < 10; ++i) {
    const double r = i % 2 == 0 ? 1 : 0.3, t = std::acos(-1.) * i / 5;
    mesh.points.push_back({r * std::cos(t), r * std::sin(t), 0.05 * (i % 3)});
    mesh.faces[0].push_back(i);
  }
  const auto n = estimated(mesh), a = by_angles(mesh);
  for (std::size_t v = 1; v < 10; v += 2) EXPECT_EQ(n[v], a[v]) << v;
}

// The corners of a cap whose rim is uneven are turned far from its normal, the cap is not; sides slant, so
// that they are within 60 degrees, too.
TEST(Normal_guards, CornersOfLargeFacesAreTurnedNoMoreThanTheFaces)
{
  for (int n : {9, 16, 17, 40}) {
    Control_mesh drum{"drum", {}, {{}, {}}, {}};
    for (int ring : {1, 2})
      for (int i = 0; i < n; ++i) {
        const double t = 2 * std::acos(-1.) * i / n;
        drum.points.push_back({ring * std::cos(t), ring * std::sin(t),
                               -0.7 * ring + 0.3 / n * std::sin(2.4 * i) * (3 - ring)});
      }
    for (int i = 0, j = 1; i < n; ++i, j = (i + 1) % n) {
      drum.faces[0].push_back(i);
      drum.faces[1].push_back(2 * n - 1 - i);
      drum.faces.push_back({i, n + i, n + j, j});
    }
    const reference::Face_list list = test_meshes::face_list(drum);
    const auto points = reference_points(drum);
    const reference::Control_normals reference(list, points);
    const auto estimates = estimated(drum), angles = by_angles(drum);
    EXPECT_LE(largest_distance(estimates, triples(reference.reciprocal())), 64 * ulp) << n;
    int blended = 0;
    for (int i = 0; i < n; ++i)
      if (distance(estimates[std::size_t(i)], angles[std::size_t(i)]) > 1e-3) ++blended;
    EXPECT_GT(2 * blended, n);
  }
}

// the same inside: three edges within 120 degrees, and a polygon around the rest
TEST(Normal_guards, AReflexCornerOfAnInteriorVertex)
{
  const Control_mesh mesh{
    "reflex",
    {{0, 0, 0}, {1, 0, 0.05}, {0.5, 0.8, -0.05}, {-0.5, 0.8, 0.08}, {-2, -2, 0}, {2, -2, 0.1}},
    {{0, 1, 2}, {0, 2, 3}, {0, 3, 4, 5, 1}},
    {}};
  const Triple n = estimated(mesh)[0];
  EXPECT_EQ(n, by_angles(mesh)[0]);
  EXPECT_GT(n[2], 0.9);
}

// --- degenerate fans ---

TEST(Normal_guards, ARepeatedPointLeavesTheSphereExact)
{
  // a triangle without area between vertex 16, a copy of it and a neighbor
  Control_mesh mesh = part_of_sphere();
  const auto expected = estimated(mesh);
  const int v = 16, copy = int(mesh.points.size());
  reference::Face& f = *std::find_if(mesh.faces.begin(), mesh.faces.end(), [&](const auto& face) {
    return std::count(face.begin(), face.end(), v) != 0;
  });
  std::rotate(f.begin(), std::find(f.begin(), f.end(), v), f.end());
  const int b = f[1], c = f[2];
  f = {v, b, copy};
  mesh.faces.push_back({v, copy, c});
  mesh.faces.push_back({copy, b, c});
  mesh.points.push_back(mesh.points[std::size_t(v)]);
  const auto n = estimated(mesh);
  EXPECT_TRUE(all_are_unit_or_zero(n));
  EXPECT_LE(distance(n[std::size_t(v)], expected[std::size_t(v)]), 16 * ulp);
}

TEST(Normal_guards, FacesWithoutAreaDoNotWidenTheFan)
{
  // A vertex in the middle of an edge gives the triangle beside it a corner of 180 degrees, and with
  // rounding one without area whose normal points anywhere.
  Control_mesh mesh = part_of_sphere();
  const auto expected = estimated(mesh);
  const reference::Face f = mesh.faces[30];
  Triple middle;
  for (std::size_t k = 0; k < 3; ++k)
    middle[k] = 0.7 * mesh.points[std::size_t(f[0])][k] + 0.3 * mesh.points[std::size_t(f[1])][k];
  mesh.points.push_back(middle);
  const int m = int(mesh.points.size()) - 1;
  mesh.faces[30] = {f[0], m, f[2]};
  mesh.faces.push_back({m, f[1], f[2]});
  mesh.faces.push_back({f[0], f[1], m}); // without area
  const auto n = estimated(mesh);
  EXPECT_TRUE(all_are_unit_or_zero(n));
  // the term of an edge beside another one in the same direction vanishes, but for 1/|e|
  for (int v : {f[0], f[1]}) EXPECT_LE(distance(n[std::size_t(v)], expected[std::size_t(v)]), 0.2);
  for (int v : {f[0], f[1]})
    EXPECT_GT(distance(n[std::size_t(v)], by_angles(mesh)[std::size_t(v)]), 1e-4);
}

TEST(Normal_guards, SumsThatVanishTakeAngleWeights)
{
  // back and forth over the same edges: W_i x W_{i+1} cancel, the angles do not
  const Control_mesh mesh{"folded",
                          {{0.1, 0.2, 0.3}, {1.1, 0.3, 0.1}, {0.4, 1.3, 0.2}, {-0.7, 0.5, 0.9}},
                          {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}},
                          {}};
  EXPECT_TRUE(all_are_unit_or_zero(estimated(mesh)));
}

// W_2 - W_0 and W_3 - W_1 are parallel: what is left of their product is rounding, and no border normal
// may be led by it.
TEST(Normal_guards, RoundingIsNoNormal)
{
  Control_mesh mesh{
    "parallel tangents", {{0, 0, 0}}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}}, {}};
  for (const Vector& w :
       {Vector(1, 0, 0.2), Vector(0.5, 0.7, 0.4), Vector(-1, 0, 0.2), Vector(-0.65, 0.7, 0.4)}) {
    const Vector e = w / w.squaredNorm();
    mesh.points.push_back({double(e[0]), double(e[1]), double(e[2])});
  }
  const auto expected = estimated(mesh);
  for (double angle : {0.3, 0.9, 1.7, 2.4}) {
    const Eigen::AngleAxis<Real> turn(angle, Vector(1, 2, -0.5).normalized());
    Control_mesh turned = mesh;
    for (Triple& p : turned.points) {
      const Vector q = turn * Vector(p[0], p[1], p[2]);
      p = {double(q[0]), double(q[1]), double(q[2])};
    }
    const auto n = estimated(turned);
    for (std::size_t v = 0; v < 5; ++v) {
      const Vector m = turn * Vector(expected[v][0], expected[v][1], expected[v][2]);
      EXPECT_LE(distance(n[v], {double(m[0]), double(m[1]), double(m[2])}), 1e-12) << v;
    }
  }
}

// once a stack overflow (found by a search)
TEST(Normal_guards, LengthsOfWhatIsNoNumberOrOutOfRange)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (int k = 0; k < 3; ++k) {
    PN::Coordinates<double, 3> v{1, 2, 2};
    v[k] = nan;
    EXPECT_FALSE(std::isfinite(PN::internal::quick_length(v)));
  }
  for (const double size : {1e-320, 0x1p-1000, 1e300})
    EXPECT_DOUBLE_EQ(PN::internal::quick_length({size, -2 * size, 2 * size}), 3 * size);
}

TEST(Normal_guards, AnyPointsGiveFiniteNormals)
{
  std::mt19937 generator(3);
  std::vector<Control_mesh> shapes = test_meshes::all();
  shapes.push_back(part_of_sphere());
  for (const Control_mesh& shape : shapes)
    for (double scale : {1., 1e-308, 1e-160, 1e160, 1e300}) {
      Control_mesh mesh = shape;
      for (Triple& p : mesh.points)
        for (double& x : p) x *= scale;
      EXPECT_TRUE(all_are_unit_or_zero(estimated(mesh))) << mesh.name << ' ' << scale;
      for (std::size_t i = 0; i < mesh.points.size(); ++i) { // repeated, flattened and far points
        Triple& p = mesh.points[generator() % mesh.points.size()];
        if (i % 4 == 0) p = mesh.points[i];
        if (i % 4 == 1) p[generator() % 3] = 0;
        if (i % 4 == 2) p[generator() % 3] *= 1e-200;
        EXPECT_TRUE(all_are_unit_or_zero(estimated(mesh))) << mesh.name << ' ' << scale;
      }
      for (Triple& p : mesh.points) p = mesh.points[0];
      for (const Triple& n : estimated(mesh)) EXPECT_EQ(n, (Triple{0, 0, 0}));
    }
}

// the shortest edge is scaled to about 1: squares of the long ones may leave the range
TEST(Normal_guards, FansOfVeryDifferentEdges)
{
  Control_mesh mesh = part_of_sphere();
  mesh.points[16] = mesh.points[17];
  mesh.points[16][0] += 1e-170;
  EXPECT_TRUE(all_are_unit_or_zero(estimated(mesh)));
  for (Triple& p : mesh.points)
    for (double& x : p) x *= 1e200;
  EXPECT_TRUE(all_are_unit_or_zero(estimated(mesh)));
}

// --- borders ---

TEST(Normal_guards, ASinglePolygonHasItsCornersNormals)
{
  for (int n : {3, 4, 7, 12}) {
    Control_mesh mesh = test_meshes::single_polygon(n);
    for (Triple& p : mesh.points) p = {p[0], p[1] + p[0], 2 - p[0]}; // planar
    const Triple expected = test_meshes::unit({1, 0, 1});
    for (const Triple& normal : estimated(mesh)) EXPECT_LE(distance(normal, expected), 8 * ulp);
  }
}

// quads only: the ruling and the exact tangent of the rim
TEST(Normal_guards, AStripWithoutInteriorVerticesTakesItsOpenFans)
{
  std::mt19937 generator(5);
  const Control_mesh strip = cylinder(uneven(13, 0.4, generator), {0, 1}, 2, Cells::quads);
  EXPECT_LE(largest_distance(estimated(strip), strip.normals), 16 * ulp);
}

// A corner of a patch has neighbors on the border only; they are found first.
TEST(Normal_guards, CornersTakeTheSecondSweep)
{
  for (Cells cells : {Cells::quads, Cells::triangles}) {
    const Control_mesh mesh = patch(6, 5, 0.3, cells, 7, cap(0.5));
    const auto n = estimated(mesh);
    for (std::size_t v : {0, 6, 35, 41}) EXPECT_LE(error(mesh, n, v), 16 * ulp) << v;
  }
}

// two border neighbors in the same place: there is no tangent
TEST(Normal_guards, AFoldedBorderTakesItsOpenFan)
{
  const Control_mesh sphere = part_of_sphere();
  const reference::Face_list list = test_meshes::face_list(sphere);
  int folded = 0;
  for (int v = 0; v < list.number_of_vertices(); ++v) {
    const auto ring = list.ring(v);
    if (!list.is_border(v) || ring.size() < 4) continue;
    Control_mesh mesh = sphere;
    mesh.points[std::size_t(ring.front())] = mesh.points[std::size_t(ring.back())];
    const auto n = estimated(mesh);
    EXPECT_TRUE(all_are_unit_or_zero(n));
    EXPECT_NE(n[std::size_t(v)], (Triple{0, 0, 0}));
    ++folded;
  }
  EXPECT_GE(folded, 3);
}

// An inner edge along the border's tangent says nothing about the turn about it; and neighbors' normals
// that contradict the points do not turn the border over.
TEST(Normal_guards, ArcsThatSayNothingOrNonsense)
{
  using V = PN::Coordinates<double, 3>;
  const V up{0, 0, 1}, along{1, 0, 0};
  const auto arc_normal = [&](const std::vector<PN::internal::Border_arc>& arcs) {
    return PN::internal::arc_border_normal(up, along, arcs);
  };
  EXPECT_FALSE(arc_normal({{{1, 0, 0}, up}}));
  EXPECT_FALSE(arc_normal({{{1, 0, 0}, up}, {{-1, 1e-7, 0}, up}}));
  EXPECT_TRUE(arc_normal({{{0, 1, 0}, up}}));
  EXPECT_FALSE(arc_normal({{{0, 1, 0}, {0, 1, 0}}}));  // it would be (0, -1, 0)
  const double c = std::cos(1.2), s = std::sin(1.2);   // 69 degrees
  const auto n = arc_normal({{{0, 1, 0}, {0, s, c}}}); // the mirror image
  ASSERT_TRUE(n);
  EXPECT_LE(distance({(*n)[0], (*n)[1], (*n)[2]}, {0, -s, c}), 4 * ulp);
  EXPECT_FALSE(PN::internal::arc_border_normal(along, along, {{{0, 1, 0}, up}}));
  EXPECT_FALSE(PN::internal::arc_border_normal(up, {0, 0, 0}, {{{0, 1, 0}, up}}));
}

// --- meshes ---

TEST(Normal_guards, GarbageIsolatedVerticesAndComponents)
{
  const Control_mesh sphere = part_of_sphere();
  const auto expected = estimated(sphere);
  auto mesh = to_mesh<CGAL::Simple_cartesian<double>>(test_meshes::with_isolated_vertices(
    test_meshes::united(sphere, scattered(1, 0.2, 1, on_sphere))));
  CGAL::Euler::remove_face(mesh.halfedge(CGAL::SM_Face_index(62)), mesh);
  ASSERT_TRUE(mesh.has_garbage());
  auto n =
    mesh.add_property_map<CGAL::SM_Vertex_index, CGAL::Simple_cartesian<double>::Vector_3>("n")
      .first;
  PN::estimate_control_normals(mesh, n);
  for (std::size_t v = 0; v < expected.size(); ++v) {
    const auto& m = n[CGAL::SM_Vertex_index(unsigned(v + 1))];
    EXPECT_LE(distance({m.x(), m.y(), m.z()}, expected[v]), 16 * ulp) << v;
  }
  EXPECT_EQ(n[CGAL::SM_Vertex_index(0)], CGAL::NULL_VECTOR);
}

// Linear, or this would take minutes: a vertex of valence 10^5 and a face of as many corners, which
// are alone where the fan of triangles is left out.
TEST(Normal_guards, HugeFansAndFaces)
{
  using Level = PN::Level_connectivity;
  const unsigned n = 100000;
  const Control_mesh fan = pyramid(int(n), 30);
  Level level(PN::Level_size{n + 1, 2 * n, n + 1, 4 * n, 0, 0});
  for (unsigned i = 0; i < n; ++i) {
    const unsigned j = (i + 1) % n;
    const auto set = [&](unsigned h, unsigned to, unsigned next, unsigned face) {
      level.set_target(h, to);
      level.set_next(h, next);
      level.set_face(h, face);
    };
    set(2 * i, i + 1, 2 * (n + i), i);               // out along spoke i
    set(2 * (n + i), j + 1, 2 * j + 1, i);           // along the rim
    set(2 * j + 1, 0, 2 * i, i);                     // back along the next spoke
    set(2 * (n + j) + 1, j + 1, 2 * (n + i) + 1, n); // the large face
    level.set_halfedge_of_face(i, 2 * i);
    level.set_halfedge_of_vertex(i + 1, 2 * i);
  }
  level.set_halfedge_of_face(n, 2 * n + 1);
  level.set_halfedge_of_vertex(0, 1);
  std::vector<PN::Point_normal<double, 3>> values(n + 1);
  for (unsigned v = 0; v <= n; ++v) values[v].point = fan.points[v];
  PN::internal::estimate_normals_of<double>(level, Control_normal_estimate::reciprocal, values);
  std::vector<Triple> normals;
  for (const auto& value : values) normals.push_back(value.normal);
  EXPECT_LE(distance(normals[0], {0, 0, 1}), 1e-3);
  EXPECT_TRUE(all_are_unit_or_zero(normals));

  const Control_mesh polygon = test_meshes::single_polygon(int(n));
  EXPECT_TRUE(all_are_unit_or_zero(estimated(polygon)));
}

TEST(Normal_guards, GivenNormalsAreTakenAsTheyAre)
{
  const Control_mesh control = part_of_sphere();
  const auto mesh = to_mesh<CGAL::Simple_cartesian<double>>(control);
  PN::internal::with_mesh_access(mesh, [&](const auto& access) {
    const auto level = PN::internal::checked_level(access);
    // inside, where estimates are exact, nothing changes at the border if the exact ones are given
    std::vector<PN::Point_normal<double, 3>> values;
    std::vector<bool> is_given;
    for (unsigned v = 0; v < control.points.size(); ++v) {
      is_given.push_back(!level.is_border_vertex(v));
      values.push_back({control.points[v], is_given[v] ? control.normals[v] : Triple{0, 0, 0}});
    }
    EXPECT_EQ(std::count(is_given.begin(), is_given.end(), false), 22);
    PN::internal::estimate_normals_of(level, Control_normal_estimate::reciprocal, values,
                                      &is_given);
    for (unsigned v = 0; v < values.size(); ++v)
      if (is_given[v])
        EXPECT_EQ(values[v].normal, control.normals[v]);
      else
        EXPECT_LE(distance(values[v].normal, control.normals[v]), 16 * ulp);
  });
}

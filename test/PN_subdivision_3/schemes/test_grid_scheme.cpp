// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// CatmullClark_scheme::Grid: tori and parallels are exact, grids are those of an implementation by two indices, and irregular
// vertices have the rules of Catmull-Clark.

#include "Messages.h"

#include "reference/Grid_lines.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/PN_subdivision_3/parameters/parameters.h>
#include <CGAL/PN_subdivision_3/subdivision_methods_3.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/generators.h>

#include <functional>
#include <random>
#include <utility>

namespace {

namespace PN = CGAL::PN_subdivision_3;
namespace np = CGAL::parameters;
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;
using Normals = Mesh::Property_map<Vertex, Vector>;
using Shape = std::function<std::pair<Point, Vector>(int, int)>;

const double pi = std::acos(-1.);

Vector unit(const Vector& v)
{
  return v / std::sqrt(v.squared_length());
}

Normals normals_of(Mesh& mesh)
{
  return mesh.add_property_map<Vertex, Vector>("v:normal", CGAL::NULL_VECTOR).first;
}

// the vertex of (i, j) is i * m + j
Mesh grid(int n, int m, bool closed_n, bool closed_m, const Shape& shape)
{
  Mesh mesh;
  const Normals normals = normals_of(mesh);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) {
      const auto [p, normal] = shape(i, j);
      normals[mesh.add_vertex(p)] = normal;
    }
  const auto at = [&](int i, int j) { return Vertex(unsigned((i % n) * m + j % m)); };
  for (int i = 0; i < n - !closed_n; ++i)
    for (int j = 0; j < m - !closed_m; ++j)
      mesh.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
  return mesh;
}

void refine(Mesh& mesh, unsigned rounds)
{
  PN::subdivide(mesh, PN::CatmullClark_scheme::Grid(),
                np::number_of_iterations(rounds).vertex_normal_map(normals_of(mesh)));
}

struct Torus
{
  std::vector<double> u, w; // angles
  explicit Torus(int n, double unevenness)
  {
    std::mt19937 random(7);
    for (int i = 0; i < n; ++i)
      for (auto* angles : {&u, &w})
        angles->push_back(2 * pi * (i + unevenness * (double(random()) / 4294967296. - .5)) / n);
  }
  std::pair<Point, Vector> operator()(int i, int j) const
  {
    const double c = std::cos(u[i]), s = std::sin(u[i]), x = std::cos(w[j]), z = std::sin(w[j]);
    return {Point((2 + x) * c, (2 + x) * s, z), Vector(x * c, x * s, z)};
  }
};

void expect_torus(Mesh& mesh)
{
  const Normals normals = normals_of(mesh);
  for (const Vertex v : mesh.vertices()) {
    const Point p = mesh.point(v);
    const double rho = std::hypot(p.x(), p.y()), x = rho - 2;
    ASSERT_NEAR(std::hypot(x, p.z()), 1, 1e-14) << v;
    const Vector n = unit(Vector(x * p.x() / rho, x * p.y() / rho, p.z()));
    ASSERT_NEAR((normals[v] - n).squared_length(), 0, 1e-27) << v;
  }
}

TEST(Grid_scheme, KeepsTori)
{
  for (const int n : {3, 4, 5, 8})
    for (const double unevenness : {0., .6, .9}) {
      if (n == 3 && unevenness > .8) continue; // by more than half a turn
      SCOPED_TRACE(std::to_string(n) + " points, uneven by " + std::to_string(unevenness));
      const Torus torus(n, unevenness);
      const Shape turned = [&](int i, int j) { return torus(j, i); };
      Mesh closed = grid(n, n, true, true, torus), patch = grid(n, n, false, false, torus),
           ring = grid(n, n, false, true, torus), other_ring = grid(n, n, false, true, turned);
      for (Mesh* mesh : {&closed, &patch, &ring, &other_ring}) {
        refine(*mesh, 2);
        expect_torus(*mesh);
      }
    }
}

// r(z) has inflections, and a straight part
double profile(double z)
{
  return z < 0 ? 1 + z / 2 : 1 + .3 * std::sin(2.5 * z) + z * z / 8;
}
double slope(double z)
{
  return z < 0 ? .5 : .75 * std::cos(2.5 * z) + z / 4;
}

TEST(Grid_scheme, KeepsParallelsRound)
{
  const int n = 5, m = 12;
  Mesh mesh = grid(n, m, true, false, [&](int i, int j) {
    const double u = 2 * pi * (i + .3 * (i % 2)) / n, z = j * .25 - .8;
    return std::pair(Point(profile(z) * std::cos(u), profile(z) * std::sin(u), z),
                     unit(Vector(std::cos(u), std::sin(u), -slope(z))));
  });
  refine(mesh, 3);
  std::vector<std::pair<double, double>> found; // height and radius
  for (const Vertex v : mesh.vertices())
    found.emplace_back(mesh.point(v).z(), std::hypot(mesh.point(v).x(), mesh.point(v).y()));
  std::sort(found.begin(), found.end());
  const std::size_t around = std::size_t(8 * n);
  ASSERT_EQ(found.size() % around, 0u);
  for (std::size_t k = 0; k < found.size(); ++k) {
    ASSERT_NEAR(found[k].first, found[k - k % around].first, 1e-14);
    ASSERT_NEAR(found[k].second, found[k - k % around].second, 1e-14);
    EXPECT_NEAR(found[k].second, profile(found[k].first), .02);
  }
}

Mesh disturbed(int n, int m, bool closed_n, bool closed_m, unsigned seed)
{
  std::mt19937 random(seed);
  const auto noise = [&] { return .3 * (double(random()) / 4294967296. - .5); };
  return grid(n, m, closed_n, closed_m, [&](int i, int j) {
    const double u = closed_n ? 2 * pi * i / n : i * .5, w = closed_m ? 2 * pi * j / m : j * .6;
    const Point p(closed_n ? (3 + std::cos(w)) * std::cos(u) : u,
                  closed_n ? (3 + std::cos(w)) * std::sin(u) : w, std::sin(w + (closed_n ? 0 : u)));
    const Vector normal =
      closed_n ? Vector(std::cos(w) * std::cos(u), std::cos(w) * std::sin(u), std::sin(w))
               : Vector(-std::cos(w + u), -std::cos(w + u), 1);
    return std::pair(p + Vector(noise(), noise(), noise()),
                     unit(normal + Vector(noise(), noise(), noise())));
  });
}

reference::Space space(const Vector& v)
{
  return {v.x(), v.y(), v.z()};
}

TEST(Grid_scheme, IsTheReferenceOnGrids)
{
  for (const auto& [closed_n, closed_m] : {std::pair(true, true), {true, false}, {false, false}})
    for (unsigned seed = 1; seed <= 5; ++seed) {
      const int n = 6, m = 5;
      Mesh mesh = disturbed(n, m, closed_n, closed_m, seed);
      reference::Grid control{n, m, closed_n, closed_m, {}};
      for (const Vertex v : mesh.vertices())
        control.points.push_back({space(mesh.point(v) - CGAL::ORIGIN), space(normals_of(mesh)[v])});
      const reference::Grid fine = control.refined();
      refine(mesh, 1);
      const Normals normals = normals_of(mesh);
      ASSERT_EQ(mesh.number_of_vertices(), fine.points.size());
      std::vector<bool> is_found(fine.points.size());
      for (const Vertex v : mesh.vertices()) { // the nearest
        std::size_t best = 0;
        double least = 1e9;
        for (std::size_t k = 0; k < fine.points.size(); ++k) {
          const auto d =
            reference::plus(space(mesh.point(v) - CGAL::ORIGIN), fine.points[k].point, -1);
          const double distance = double(std::sqrt(reference::inner(d, d)));
          if (distance >= least) continue;
          least = distance;
          best = k;
        }
        const auto d = reference::plus(space(normals[v]), fine.points[best].normal, -1);
        EXPECT_LE(least, 2e-14) << v << ", seed " << seed;
        EXPECT_LE(double(std::sqrt(reference::inner(d, d))), 2e-13) << v << ", seed " << seed;
        is_found[best] = true;
      }
      EXPECT_EQ(std::count(is_found.begin(), is_found.end(), true),
                std::ptrdiff_t(is_found.size()));
    }
}

Mesh cuboid()
{
  Mesh mesh;
  CGAL::make_hexahedron(Point(0, 0, 0), Point(2, 0, 0), Point(2, 1, 0), Point(0, 1, 0),
                        Point(0, 1, 1), Point(0, 0, 1), Point(2, 0, 1), Point(2, 1, 1.5), mesh);
  for (const Vertex v : mesh.vertices())
    normals_of(mesh)[v] = unit(mesh.point(v) - Point(1, .5, .5));
  return mesh;
}

// the old vertices and their first rings, which depend on nothing else
TEST(Grid_scheme, HasTheRulesOfCatmullClarkAtIrregularVertices)
{
  Mesh mesh = cuboid(), plain = cuboid();
  refine(mesh, 3);
  PN::CatmullClark_subdivision(plain,
                               np::number_of_iterations(3).vertex_normal_map(normals_of(plain)));
  double elsewhere = 0;
  for (const Vertex v : mesh.vertices())
    elsewhere = (std::max)(elsewhere, CGAL::squared_distance(mesh.point(v), plain.point(v)));
  EXPECT_GT(elsewhere, 1e-8);
  for (unsigned k = 0; k < 8; ++k) {
    const Vertex v(k);
    EXPECT_LE(CGAL::squared_distance(mesh.point(v), plain.point(v)), 1e-29);
    EXPECT_LE((normals_of(mesh)[v] - normals_of(plain)[v]).squared_length(), 1e-29);
    for (const auto h : mesh.halfedges_around_target(mesh.halfedge(v)))
      for (const Vertex w : {mesh.source(h), mesh.target(mesh.next(mesh.next(h)))})
        EXPECT_LE(CGAL::squared_distance(mesh.point(w), plain.point(w)), 1e-29);
  }
}

double largest_turn(const Mesh& mesh)
{
  const auto normal = [&](Mesh::Halfedge_index h) {
    const auto at = [&](Mesh::Halfedge_index g) { return mesh.point(mesh.target(g)); };
    const auto g = mesh.next(mesh.next(h));
    return unit(CGAL::cross_product(at(g) - at(h), at(mesh.next(g)) - at(mesh.next(h))));
  };
  double worst = 0;
  for (const auto e : mesh.edges()) {
    const auto h = mesh.halfedge(e);
    if (!mesh.is_border(e))
      worst = (std::max)(worst, std::sqrt((normal(h) - normal(mesh.opposite(h))).squared_length()));
  }
  return worst;
}

// a fan of five quads with a border, whose corners stay
Mesh star()
{
  Mesh mesh;
  const Vertex c = mesh.add_vertex(Point(0, 0, .5));
  std::vector<Vertex> inner, outer;
  for (int i = 0; i < 5; ++i) {
    const double a = 2 * pi * i / 5, b = a + pi / 5;
    inner.push_back(mesh.add_vertex(Point(std::cos(a), std::sin(a), .1 * (i % 2))));
    outer.push_back(mesh.add_vertex(Point(1.5 * std::cos(b), 1.5 * std::sin(b), -.4)));
  }
  for (std::size_t i = 0; i < 5; ++i) mesh.add_face(c, inner[i], outer[i], inner[(i + 1) % 5]);
  for (const Vertex v : mesh.vertices())
    normals_of(mesh)[v] = unit(Vector(.4 * mesh.point(v).x(), .4 * mesh.point(v).y(), 1));
  return mesh;
}

// no more is meant than these rounds: the seams to the rules of irregular vertices are not smooth
TEST(Grid_scheme, AnglesOfFacesFallUpToTheFifthRound)
{
  for (Mesh mesh : {cuboid(), star()}) {
    refine(mesh, 2);
    double turn = largest_turn(mesh);
    for (int round = 3; round <= 5; ++round) {
      refine(mesh, 1);
      const double next = largest_turn(mesh);
      EXPECT_LT(next, .62 * turn) << "round " << round;
      turn = next;
    }
  }
}

// the same faces in another order, each from another corner on, so that the edges have other first half-edges
Mesh renumbered(Mesh& mesh)
{
  Mesh other;
  for (const Vertex v : mesh.vertices())
    normals_of(other)[other.add_vertex(mesh.point(v))] = normals_of(mesh)[v];
  for (std::size_t f = mesh.number_of_faces(); f-- > 0;) {
    auto h = mesh.halfedge(Mesh::Face_index(unsigned(f)));
    for (std::size_t k = 0; k <= f % 3; ++k) h = mesh.next(h);
    std::vector<Vertex> corners;
    for (const Vertex v : mesh.vertices_around_face(h)) corners.push_back(v);
    other.add_face(corners);
  }
  return other;
}

TEST(Grid_scheme, DoesNotDependOnTheNumbersOfFaces)
{
  for (Mesh mesh : {cuboid(), star()}) {
    refine(mesh, 2);
    Mesh other = renumbered(mesh);
    refine(mesh, 1);
    refine(other, 1);
    std::vector<Point> points[2];
    for (const Mesh* m : {&mesh, &other})
      for (const Vertex v : m->vertices()) points[m == &other].push_back(m->point(v));
    for (const Point& p : points[0]) {
      double least = 1e9;
      for (const Point& q : points[1]) least = (std::min)(least, CGAL::squared_distance(p, q));
      ASSERT_LE(least, 1e-28) << p;
    }
  }
}

TEST(Grid_scheme, LeavesCornersAndIsLinearWithoutRoundness)
{
  Mesh mesh = disturbed(4, 5, false, false, 3), linear = mesh, flat = mesh, half = mesh;
  refine(mesh, 2);
  for (const unsigned corner : {0u, 4u, 15u, 19u})
    EXPECT_EQ(mesh.point(Vertex(corner)), flat.point(Vertex(corner)));
  PN::subdivide(linear, PN::linear(PN::CatmullClark_scheme::Grid()), np::number_of_iterations(2));
  PN::subdivide(
    flat, PN::CatmullClark_scheme::Grid(),
    PN::parameters::roundness(0.).number_of_iterations(2).vertex_normal_map(normals_of(flat)));
  Mesh once = half, once_linear = half;
  refine(once, 1);
  PN::subdivide(once_linear, PN::linear(PN::CatmullClark_scheme::Grid()));
  PN::subdivide(half, PN::CatmullClark_scheme::Grid(),
                PN::parameters::roundness(.5).vertex_normal_map(normals_of(half)));
  for (const Vertex v : flat.vertices())
    EXPECT_LE(CGAL::squared_distance(flat.point(v), linear.point(v)), 1e-28);
  for (const Vertex v : half.vertices())
    EXPECT_LE(
      CGAL::squared_distance(half.point(v), CGAL::midpoint(once.point(v), once_linear.point(v))),
      1e-28);
}

template <class Other, class Get>
void expect_same_points(const Mesh& mesh, const Other& other, double tolerance,
                        const Get& get_point)
{
  ASSERT_EQ(num_vertices(other), mesh.number_of_vertices());
  auto v = vertices(other).begin();
  for (const Vertex w : mesh.vertices()) {
    const auto p = get_point(*v++);
    for (int c = 0; c < 3; ++c)
      ASSERT_NEAR(CGAL::to_double(p[c]), mesh.point(w)[c], tolerance) << w;
  }
}

TEST(Grid_scheme, ScalesWithTheMesh)
{
  Mesh mesh = disturbed(6, 8, true, true, 4);
  const Mesh control = mesh;
  refine(mesh, 2);
  for (const int exponent : {600, -600}) {
    const double scale = std::ldexp(1., exponent);
    Mesh scaled = control;
    for (const auto v : scaled.vertices()) {
      const Point p = scaled.point(v);
      scaled.point(v) = Point(scale * p.x(), scale * p.y(), scale * p.z());
    }
    refine(scaled, 2);
    for (const auto v : mesh.vertices()) {
      const Point p = mesh.point(v);
      EXPECT_EQ(scaled.point(v), Point(scale * p.x(), scale * p.y(), scale * p.z()));
    }
  }
}

TEST(Grid_scheme, TakesOtherMeshesAndNumbers)
{
  const Mesh control = disturbed(3, 3, false, false, 3);
  Mesh mesh;
  CGAL::copy_face_graph(control, mesh); // in the order of the copies
  CGAL::Polyhedron_3<Kernel> polyhedron;
  CGAL::copy_face_graph(control, polyhedron);
  using Exact_mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_exact_constructions_kernel::Point_3>;
  Exact_mesh exact;
  CGAL::copy_face_graph(control, exact);
  const PN::Control_normal_estimate estimate = PN::Control_normal_estimate::angle;
  PN::subdivide(mesh, PN::CatmullClark_scheme::Grid(),
                PN::parameters::control_normal_estimate(estimate));
  PN::subdivide(polyhedron, PN::CatmullClark_scheme::Grid(),
                PN::parameters::control_normal_estimate(estimate));
  PN::subdivide(exact, PN::CatmullClark_scheme::Grid(),
                PN::parameters::control_normal_estimate(estimate));
  expect_same_points(mesh, polyhedron, 1e-14, [](const auto& v) { return v->point(); });
  expect_same_points(mesh, exact, 1e-13, [&](const auto& v) { return exact.point(v); });
  Mesh nothing;
  PN::subdivide(nothing, PN::CatmullClark_scheme::Grid());
  EXPECT_EQ(nothing.number_of_vertices(), 0u);
  const Vertex lonely = nothing.add_vertex(Point(1, 2, 3));
  PN::subdivide(nothing, PN::CatmullClark_scheme::Grid());
  EXPECT_EQ(nothing.point(lonely), Point(1, 2, 3));
}

TEST(Grid_scheme, RefusesWhatItHasNoRulesFor)
{
  const auto expect_refused = [](Mesh& mesh, const auto& np, const char* words) {
    messages::expect_refused([&] { PN::subdivide(mesh, PN::CatmullClark_scheme::Grid(), np); },
                             {words});
  };
  Mesh mixed = cuboid();
  const Vertex a = mixed.add_vertex(Point(5, 0, 0)), b = mixed.add_vertex(Point(6, 0, 0)),
               c = mixed.add_vertex(Point(5, 1, 0));
  mixed.add_face(a, b, c);
  expect_refused(mixed, np::default_values(), "face 6 has 3 corners");
  EXPECT_EQ(mixed.number_of_vertices(), 11u);
  Mesh sharp = cuboid();
  const auto edges = sharp.add_property_map<Mesh::Edge_index, bool>("e:sharp", true).first;
  expect_refused(sharp, np::edge_is_constrained_map(edges), "no rules for creases");
  EXPECT_EQ(sharp.number_of_vertices(), 8u);
}

} // namespace

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Estimated curvatures of surfaces whose curvatures are known in closed form: how accurate they are,
// and what must not change them; degenerate and refused input, and other meshes, kernels and maps.

#include "Estimated_curvatures.h"
#include "Messages.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>

#include <limits>

using namespace estimated_curvatures;
namespace params = CGAL::parameters;

namespace {

// The largest sine of an angle between normals, or of the minimal direction where it is known.
double direction_error(const Curvatures& c, const Sampled_surface& s)
{
  double largest = 0;
  for (std::size_t v = 0; v < c.size(); ++v) {
    const Triple minimal = triple(c[v].minimal_direction);
    const Triple n = cross(minimal, triple(c[v].maximal_direction));
    EXPECT_GT(dot(n, s.exact[v].normal), 0);
    for (const Triple& sine :
         {cross(n, s.exact[v].normal), cross(minimal, s.exact[v].minimal_direction)})
      if (s.exact[v].minimal_direction != Triple{})
        largest = (std::max)(largest, std::sqrt(dot(sine, sine)));
  }
  return largest;
}

struct Errors
{
  double points, normals;
};

Errors errors(const Soup& plane_mesh, const Surface& surface)
{
  const Sampled_surface s = lay(plane_mesh, surface);
  return {error(from_points(s.soup), s), error(from_normals(s.soup, normals_of(s)), s)};
}

// A factor of 4 is the second order; the first order would be a factor of 2.
constexpr double second_order = 2.8;

void expect_second_order(const std::function<Soup(double)>& mesh, const Surface& surface, double h)
{
  const Errors coarse = errors(mesh(h), surface), fine = errors(mesh(h / 4), surface);
  const double factor = second_order * second_order;
  EXPECT_LT(factor * fine.points, coarse.points);
  EXPECT_LT(factor * fine.normals, (std::max)(coarse.normals, 1e-8));
  EXPECT_LT(fine.points, 0.04);
  EXPECT_LT(fine.normals, 0.02);
}

// --- accuracy ---

TEST(Estimate_curvature, SecondOrderAtAllValences)
{
  for (const Faces kind : {Faces::quads, Faces::triangles})
    for (int n : {3, 4, 5, 6, 7, 8, 10, 12})
      for (const Surface& surface : {Surface(saddle), Surface(waves), Surface(sphere)}) {
        SCOPED_TRACE("valence " + std::to_string(n) + (kind == Faces::quads ? " quads" : ""));
        expect_second_order([&](double h) { return star(n, kind, h); }, surface, 0.02);
      }
}

TEST(Estimate_curvature, SecondOrderOnUnevenMeshesWithBorder)
{
  for (const Faces kind : {Faces::quads, Faces::triangles, Faces::mixed})
    for (double jitter : {0., 0.25})
      for (const Surface& surface : {Surface(saddle), Surface(waves), Surface(cylinder)}) {
        SCOPED_TRACE(jitter);
        const auto mesh = [&](double h) { return square(std::size_t(1 / h), kind, jitter); };
        expect_second_order(mesh, surface, 1. / 12);
      }
}

TEST(Estimate_curvature, SecondOrderOnAClosedTorus)
{
  for (const Faces kind : {Faces::quads, Faces::triangles, Faces::mixed}) {
    const auto mesh = [&](double h) { return torus_grid(std::size_t(16 / h), kind); };
    expect_second_order(mesh, torus, 1);
    const Sampled_surface coarse = lay(mesh(1), torus), fine = lay(mesh(0.25), torus);
    EXPECT_LT(10 * direction_error(from_points(fine.soup), fine),
              direction_error(from_points(coarse.soup), coarse));
    EXPECT_LT(direction_error(from_points(fine.soup), fine), 0.01);
    EXPECT_LT(direction_error(from_normals(fine.soup, normals_of(fine)), fine), 0.01);
  }
}

// Rows of long and skew quads determine a cubic as well as those of squares.
TEST(Estimate_curvature, SecondOrderOnLongAndSkewFaces)
{
  for (const double length : {1., 5., 30.})
    for (const double shear : {0., 1., 3.}) {
      SCOPED_TRACE(std::to_string(length) + ' ' + std::to_string(shear));
      const auto mesh = [&length, &shear](double h) {
        Soup soup = square(std::size_t(1 / h), Faces::quads, 0);
        for (Triple& p : soup.points) p = {(p[0] + shear * p[1]) / (1 + shear), p[1] / length, 0};
        return soup;
      };
      const Errors coarse = errors(mesh(1. / 12), waves), fine = errors(mesh(1. / 48), waves);
      EXPECT_LT(7 * fine.points, coarse.points);
      EXPECT_LT(9 * fine.normals, coarse.normals);
      EXPECT_LT(fine.points, 0.7);
    }
}

// A cubic over the plane of the fit is fitted exactly, however steep it is at the vertex.
TEST(Estimate_curvature, SteepCubicsAreExact)
{
  const auto cubic = [](double x, double y) {
    const double z = 0.9 * x - 1.4 * y + x * x - 0.7 * x * y + 0.3 * y * y + 0.5 * x * x * y;
    return graph(x, y, z, 0.9 + 2 * x - 0.7 * y + x * y, -1.4 - 0.7 * x + 0.6 * y + 0.5 * x * x,
                 2 + y, -0.7 + x, 0.6);
  };
  const Surface_point exact = cubic(0, 0);
  for (double scale : {1., 4.}) {
    std::vector<PN::internal::Curvature_sample> samples;
    for (int i = -2; i <= 2; ++i)
      for (int j = -2; j <= 2; ++j) {
        const Triple p = cubic(0.1 * i + 0.05 * j, 0.13 * j).point;
        samples.push_back({Eigen::Vector3d(p[0], p[1], p[2]) / scale, {0, 0, 0}, 1});
      }
    PN::internal::Curvature_fit fit;
    ASSERT_TRUE(fit.fit(samples, {0, 0, 1}, 3));
    const auto c = PN::internal::to_vertex_curvature<Curvature>(fit.curvatures(scale));
    expect_consistent(c);
    EXPECT_NEAR(c.gaussian, exact.gaussian, 1e-12);
    EXPECT_NEAR(c.mean, exact.mean, 1e-12);
    const Triple d = triple(c.maximal_direction), n = cross(triple(c.minimal_direction), d);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(n[k], exact.normal[k], 1e-12);
    // the normal curvature of the graph in the direction d
    const double second = 2 * d[0] * d[0] - 2 * 0.7 * d[0] * d[1] + 0.6 * d[1] * d[1];
    EXPECT_NEAR(c.maximal, -second / std::sqrt(1 + 0.9 * 0.9 + 1.4 * 1.4), 1e-12);
  }
}

TEST(Estimate_curvature, PlanesAreFlat)
{
  for (const Faces kind : {Faces::quads, Faces::triangles, Faces::mixed}) {
    const Errors e = errors(square(10, kind, 0.25), plane);
    EXPECT_LT(e.points, 1e-12);
    EXPECT_LT(e.normals, 1e-12);
  }
}

// points of the unit sphere
Sampled_surface on_unit_sphere(Soup soup)
{
  Sampled_surface s{std::move(soup), {}};
  for (Triple& p : s.soup.points) {
    const double l = std::sqrt(dot(p, p));
    p = {p[0] / l, p[1] / l, p[2] / l};
    s.exact.push_back({p, p, 1, 1, {}});
  }
  return s;
}

// two poles and uneven rings of five vertices between them
Soup uneven_globe(std::size_t rings)
{
  constexpr std::size_t n = 5;
  std::mt19937 generator(3);
  std::uniform_real_distribution<> random(-0.35, 0.35);
  Soup soup{{{0, 0, 1}}, {}};
  for (std::size_t i = 0; i < rings; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      const double a = pi * (double(i) + 1 + random(generator)) / (double(rings) + 1);
      const double b = 2 * pi * (double(j) + random(generator)) / n;
      soup.points.push_back({std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a)});
    }
  soup.points.push_back({0, 0, -1});
  const auto v = [&](std::size_t i, std::size_t j) { return 1 + i * n + j % n; };
  for (std::size_t j = 0; j < n; ++j) {
    soup.faces.push_back({0, v(0, j), v(0, j + 1)});
    soup.faces.push_back({v(rings - 1, j + 1), v(rings - 1, j), 1 + rings * n});
    for (std::size_t i = 0; i + 1 < rings; ++i) {
      soup.faces.push_back({v(i, j), v(i + 1, j), v(i, j + 1)});
      soup.faces.push_back({v(i, j + 1), v(i + 1, j), v(i + 1, j + 1)});
    }
  }
  return soup;
}

// antiprisms of few sides on a cylinder of radius 1
Sampled_surface coarse_cylinder(std::size_t sides)
{
  Sampled_surface s;
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t i = 0; i < sides; ++i) {
      const double a = 2 * pi * (double(i) + 0.5 * double(j)) / double(sides);
      s.soup.points.push_back({std::cos(a), std::sin(a), 1.3 * double(j)});
      s.exact.push_back({{}, {std::cos(a), std::sin(a), 0}, 0, 0.5, {}});
    }
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t i = 0; i < sides; ++i) {
      const std::size_t a = j * sides + i, b = j * sides + (i + 1) % sides;
      s.soup.faces.push_back({a, b, a + sides});
      s.soup.faces.push_back({b, b + sides, a + sides});
    }
  return s;
}

// However coarse and uneven the triangles are.
TEST(Estimate_curvature, CoarseSpheresAndCylindersAreExactWithNormals)
{
  const Soup octahedron{
    {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
    {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}}};
  for (const Soup& soup : {tetrahedron(), octahedron, cube(), uneven_globe(3), uneven_globe(9)}) {
    SCOPED_TRACE(soup.points.size());
    const Sampled_surface s = on_unit_sphere(soup);
    EXPECT_LT(error(from_normals(s.soup, normals_of(s)), s), 1e-12);
  }
  for (std::size_t sides : {3, 4, 6}) {
    SCOPED_TRACE(sides);
    const Sampled_surface s = coarse_cylinder(sides);
    EXPECT_LT(error(from_normals(s.soup, normals_of(s)), s), 1e-13);
  }
}

// The largest errors of K and H on a torus of radii 2 and 0.8.
std::pair<double, double> torus_errors(std::size_t n, double jitter)
{
  constexpr double r = 0.8;
  Soup grid = torus_grid(n, Faces::triangles);
  std::mt19937 generator(5);
  std::uniform_real_distribution<> random(-jitter, jitter);
  for (Triple& p : grid.points)
    p = {p[0] + random(generator) * pi / double(n), p[1] + random(generator) * 2 * pi / double(n),
         0};
  const Sampled_surface s = lay(grid, [](double x, double y) -> Surface_point {
    const double rho = 2 + r * std::cos(y), across = std::cos(y) / rho;
    return {{rho * std::cos(x), rho * std::sin(x), r * std::sin(y)},
            {std::cos(y) * std::cos(x), std::cos(y) * std::sin(x), std::sin(y)},
            across / r,
            (1 / r + across) / 2,
            {}};
  });
  const Curvatures c = from_normals(s.soup, normals_of(s));
  std::pair<double, double> largest(0, 0);
  for (std::size_t v = 0; v < c.size(); ++v) {
    largest.first = (std::max)(largest.first, std::abs(c[v].gaussian - s.exact[v].gaussian));
    largest.second = (std::max)(largest.second, std::abs(c[v].mean - s.exact[v].mean));
  }
  return largest;
}

// Second derivatives are those of edges, (n_j - n_i).e/|e|^2, but for what points and normals together tell of the third and
// fourth ones. The edges alone are off by 0.079, 0.026 and 0.0065 (K), 0.009, 0.005 and 0.0015 (H) on the even torus, and by
// 0.35, 0.16 and 0.094, 0.11, 0.062 and 0.033 on the uneven one.
TEST(Estimate_curvature, NormalsOfATorusTellMoreThanItsEdges)
{
  const struct
  {
    std::size_t n;
    double even_gaussian, even_mean, uneven_gaussian, uneven_mean;
  } bounds[] = {{8, 0.02, 0.008, 0.06, 0.03},
                {16, 0.004, 0.001, 0.015, 0.008},
                {32, 0.001, 3e-4, 0.004, 0.002}};
  for (const auto& b : bounds) {
    SCOPED_TRACE(b.n);
    const auto [gaussian, mean] = torus_errors(b.n, 0);
    EXPECT_LT(gaussian, b.even_gaussian);
    EXPECT_LT(mean, b.even_mean);
    const auto [uneven_gaussian, uneven_mean] = torus_errors(b.n, 0.2);
    EXPECT_LT(uneven_gaussian, b.uneven_gaussian);
    EXPECT_LT(uneven_mean, b.uneven_mean);
  }
}

// --- invariance ---

TEST(Estimate_curvature, ReversedFacesChangeTheSignOfMeanCurvature)
{
  const Sampled_surface s = lay(square(8, Faces::mixed, 0.2), waves);
  Soup reversed = s.soup;
  for (Polygon& f : reversed.faces) std::reverse(f.begin(), f.end());
  std::vector<Triple> inward = normals_of(s);
  for (Triple& n : inward) n = {-n[0], -n[1], -n[2]};
  const auto expect_reversed = [](const Curvatures& a, const Curvatures& b) {
    for (std::size_t v = 0; v < a.size(); ++v) {
      EXPECT_NEAR(a[v].gaussian, b[v].gaussian, 1e-10);
      EXPECT_NEAR(a[v].mean, -b[v].mean, 1e-10);
      EXPECT_NEAR(a[v].minimal, -b[v].maximal, 1e-10);
      EXPECT_NEAR(std::abs(a[v].minimal_direction * b[v].maximal_direction), 1, 1e-10);
    }
  };
  expect_reversed(from_points(s.soup), from_points(reversed));
  expect_reversed(from_normals(s.soup, normals_of(s)), from_normals(s.soup, inward));
}

TEST(Estimate_curvature, RotationAndScale)
{
  const Sampled_surface s = lay(square(8, Faces::mixed, 0.2), waves);
  const Curvatures points = from_points(s.soup), normals = from_normals(s.soup, normals_of(s));
  const auto rotated = [](const Triple& p) { // by 1 about z, then by 2 about x
    const Triple q{std::cos(1.) * p[0] - std::sin(1.) * p[1],
                   std::sin(1.) * p[0] + std::cos(1.) * p[1], p[2]};
    return Triple{q[0], std::cos(2.) * q[1] - std::sin(2.) * q[2],
                  std::sin(2.) * q[1] + std::cos(2.) * q[2]};
  };
  for (double scale : {1e-140, 1e-3, 1., 1e5, 1e140}) {
    SCOPED_TRACE(scale);
    Sampled_surface t = s;
    for (std::size_t v = 0; v < t.exact.size(); ++v) {
      const Triple p = rotated(s.soup.points[v]);
      t.soup.points[v] = {scale * (p[0] + 1), scale * (p[1] - 2), scale * (p[2] + 3)};
      t.exact[v].normal = rotated(s.exact[v].normal);
    }
    const auto expect_same = [&](const Curvatures& a, const Curvatures& b) {
      for (std::size_t v = 0; v < a.size(); ++v) {
        EXPECT_NEAR(a[v].gaussian, scale * (scale * b[v].gaussian), 1e-10);
        EXPECT_NEAR(a[v].minimal, scale * b[v].minimal, 1e-10);
        EXPECT_NEAR(a[v].maximal, scale * b[v].maximal, 1e-10);
        const Triple d = rotated(triple(a[v].minimal_direction));
        EXPECT_NEAR(std::abs(dot(d, triple(b[v].minimal_direction))), 1, 1e-10);
      }
    };
    expect_same(points, from_points(t.soup));
    expect_same(normals, from_normals(t.soup, normals_of(t)));
  }
}

TEST(Estimate_curvature, NormalsMayHaveAnyLength)
{
  const Sampled_surface s = lay(square(6, Faces::mixed, 0.2), waves);
  std::vector<Triple> n = normals_of(s);
  for (Triple& m : n) m = {1e200 * m[0], 1e200 * m[1], 1e200 * m[2]};
  const Curvatures a = from_normals(s.soup, normals_of(s)), b = from_normals(s.soup, n);
  for (std::size_t v = 0; v < a.size(); ++v) EXPECT_NEAR(a[v].mean, b[v].mean, 1e-13);
}

// --- degenerate input ---

// What has no neighbors is not estimated, what has, is.
TEST(Estimate_curvature, ComponentsAndVerticesWithoutFaces)
{
  Sampled_surface s = lay(square(6, Faces::quads, 0), waves);
  const Curvatures alone = from_points(s.soup);
  const std::size_t n = s.soup.points.size();
  for (std::size_t v = 0; v < n; ++v) {
    const Triple p = s.soup.points[v];
    s.soup.points.push_back({p[0], p[1], p[2] + 1e-3}); // a second layer, closer than an edge
  }
  const std::size_t number_of_faces = s.soup.faces.size();
  for (std::size_t f = 0; f < number_of_faces; ++f) {
    Polygon face = s.soup.faces[f];
    for (std::size_t& v : face) v += n;
    s.soup.faces.push_back(face);
  }
  s.soup.points.push_back({0, 0, 0});
  const Curvatures c = from_points(s.soup);
  for (std::size_t v = 0; v < n; ++v) {
    EXPECT_EQ(c[v].mean, alone[v].mean);
    EXPECT_NEAR(c[n + v].mean, alone[v].mean, 1e-9);
  }
  EXPECT_FALSE(c.back().is_estimated);
  EXPECT_EQ(c.back().gaussian, 0);
  EXPECT_EQ(c.back().mean, 0);
  EXPECT_EQ(triple(c.back().minimal_direction), (Triple{0, 0, 0}));
  EXPECT_TRUE(from_points(Soup{}).empty());
}

TEST(Estimate_curvature, TooFewVertices)
{
  Soup triangle{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2}}};
  for (const Curvature& c : from_points(triangle)) EXPECT_FALSE(c.is_estimated);
  // its normals tell more, if it is not too large a part of the sphere
  triangle.points = {{0.8, 0, 0.6}, {0, 0.6, 0.8}, {0, 0, 1}};
  for (const Curvature& c : from_normals(triangle, triangle.points)) {
    EXPECT_NEAR(c.gaussian, 1, 1e-12);
    EXPECT_NEAR(c.mean, 1, 1e-12);
  }
  for (const Curvature& c : from_points(tetrahedron())) EXPECT_FALSE(c.is_estimated);
  // two rows of vertices do not tell how the surface bends across them
  Sampled_surface strip{{}, {}};
  for (double x = 0; x < 9; ++x)
    for (double y : {0., 1.}) {
      strip.exact.push_back(cylinder(y, 0.2 * x));
      strip.soup.points.push_back(strip.exact.back().point);
    }
  for (std::size_t i = 0; i < 8; ++i)
    strip.soup.faces.push_back({2 * i + 1, 2 * i + 3, 2 * i + 2, 2 * i});
  for (const Curvature& c : from_points(strip.soup)) EXPECT_FALSE(c.is_estimated);
  EXPECT_LT(error(from_normals(strip.soup, normals_of(strip)), strip), 1e-12);
}

// Three rows determine a quadric, not a cubic: the error is of first order, the cylinder of any.
TEST(Estimate_curvature, ThreeRowsGiveAQuadric)
{
  double last = 0;
  for (double h : {0.1, 0.05, 0.025}) {
    Soup soup;
    for (std::size_t i = 0; i < 9; ++i)
      for (std::size_t j = 0; j < 3; ++j) soup.points.push_back({h * double(i), h * double(j), 0});
    for (std::size_t i = 0; i < 8; ++i)
      for (std::size_t j = 0; j < 2; ++j)
        soup.faces.push_back({3 * i + j, 3 * i + j + 3, 3 * i + j + 4, 3 * i + j + 1});
    const Sampled_surface s = lay(soup, waves);
    const double e = error(from_points(s.soup), s);
    EXPECT_LT(e, 2 * h);
    if (last != 0) {
      EXPECT_LT(1.7 * e, last);
    }
    last = e;
  }
}

TEST(Estimate_curvature, EdgesWithoutLengthAndFacesWithoutArea)
{
  Sampled_surface s = lay(square(16, Faces::triangles, 0), waves);
  const double before = error(from_points(s.soup), s);
  for (std::size_t v : {40u, 100u, 150u}) {
    s.soup.points[v] = s.soup.points[v + 1];
    s.exact[v] = s.exact[v + 1];
  }
  EXPECT_LT(error(from_points(s.soup), s), 2 * before);
  EXPECT_LT(error(from_normals(s.soup, normals_of(s)), s), 2 * before);

  // all at one place, on a line, or folded back onto itself: no normal, nothing to fit
  for (const Triple& direction :
       {Triple{0, 0, 0}, Triple{1, 2, 3}, Triple{1 / 3., 1 / 7., 1 / 11.}}) {
    Soup soup = square(4, Faces::quads, 0);
    for (Triple& p : soup.points) {
      const double t = p[0] + 0.37 * p[1];
      p = {t * direction[0], t * direction[1], t * direction[2]};
    }
    for (const Curvature& c : from_points(soup)) EXPECT_FALSE(c.is_estimated);
    const std::vector<Triple> normals(soup.points.size(), Triple{0.6, 0, 0.8});
    for (const Curvature& c : from_normals(soup, normals)) EXPECT_FALSE(c.is_estimated);
  }
  const Soup folded{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {1, 0, 2}}};
  for (const Curvature& c : from_points(folded)) EXPECT_FALSE(c.is_estimated);
}

// In a thin plate the vertices of the other side are near, but no neighbors.
TEST(Estimate_curvature, OtherSideOfAPlateIsLeftOut)
{
  constexpr std::size_t n = 6, side = n + 1;
  Soup soup = square(n, Faces::quads, 0);
  const std::vector<Polygon> top = soup.faces;
  for (std::size_t v = 0; v < side * side; ++v) {
    const Triple p = soup.points[v];
    soup.points.push_back({p[0], p[1], -0.02});
  }
  for (Polygon f : top) {
    for (std::size_t& v : f) v += side * side;
    std::reverse(f.begin(), f.end());
    soup.faces.push_back(f);
  }
  Polygon rim; // counterclockwise
  for (std::size_t i = 0; i < n; ++i) rim.push_back(i * side);
  for (std::size_t i = 0; i < n; ++i) rim.push_back(n * side + i);
  for (std::size_t i = n; i > 0; --i) rim.push_back(i * side + n);
  for (std::size_t i = n; i > 0; --i) rim.push_back(i);
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const std::size_t a = rim[i], b = rim[(i + 1) % rim.size()];
    soup.faces.push_back({b, a, a + side * side, b + side * side});
  }
  const Curvatures c = from_points(soup);
  for (std::size_t v = 0; v < side * side; ++v) {
    const std::size_t i = v / side, j = v % side;
    if (i == 0 || i == n || j == 0 || j == n) continue;
    ASSERT_TRUE(c[v].is_estimated);
    EXPECT_NEAR(c[v].minimal, 0, 1e-12);
    EXPECT_NEAR(c[v].maximal, 0, 1e-12);
  }
}

// Where there is no normal, the point counts and the faces tell the side; the vertex itself is estimated from points.
TEST(Estimate_curvature, MissingNormals)
{
  const Sampled_surface s = lay(square(12, Faces::mixed, 0.1), waves);
  const double of_points = error(from_points(s.soup), s);
  EXPECT_LT(2 * error(from_normals(s.soup, normals_of(s)), s), of_points);
  std::vector<Triple> n = normals_of(s);
  for (std::size_t v = 0; v < n.size(); v += 3) n[v] = {0, 0, 0};
  const Curvatures some = from_normals(s.soup, n);
  EXPECT_LT(error(some, s), 1.5 * of_points);
  for (std::size_t v = 0; v < n.size(); ++v)
    if (v % 3 != 0) {
      EXPECT_NEAR(some[v].mean, s.exact[v].mean, 0.5 * of_points);
    }
  n.assign(n.size(), Triple{0, 0, 0});
  EXPECT_LT(error(from_normals(s.soup, n), s), 1.5 * of_points);
}

// Gaussian curvatures of 1e400 and more
TEST(Estimate_curvature, CurvaturesOutOfRange)
{
  Sampled_surface s = lay(square(4, Faces::quads, 0), sphere);
  for (Triple& p : s.soup.points) p = {1e-200 * p[0], 1e-200 * p[1], 1e-200 * p[2]};
  for (const Curvatures& c : {from_points(s.soup), from_normals(s.soup, normals_of(s))})
    for (const Curvature& d : c) {
      EXPECT_FALSE(d.is_estimated);
      EXPECT_EQ(d.gaussian, 0);
      EXPECT_EQ(d.maximal, 0);
    }
}

TEST(Estimate_curvature, NumbersThatAreNotFiniteAreRefused)
{
  const Sampled_surface s = lay(square(3, Faces::quads, 0), waves);
  for (double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    for (bool in_normal : {false, true}) {
      Mesh mesh = mesh_of(s.soup);
      const auto n = mesh.add_property_map<Vertex, Kernel::Vector_3>("n").first;
      put_normals(normals_of(s), mesh, n);
      if (in_normal)
        n[Vertex(7)] = {0, bad, 1};
      else
        mesh.point(Vertex(7)) = {0, bad, 1};
      Curvature untouched;
      untouched.mean = 42;
      const auto c = mesh.add_property_map<Vertex, Curvature>("c", untouched).first;
      messages::expect_refused(
        [&] { PN::estimate_curvature(mesh, c, params::vertex_normal_map(n)); },
        {in_normal ? "normal of vertex 7" : "point of vertex 7"});
      for (Vertex v : mesh.vertices()) EXPECT_EQ(c[v].mean, 42);
    }
  }
}

TEST(Estimate_curvature, BowTiesAreRefused)
{
  Mesh mesh = mesh_of({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}}, {{0, 1, 2}}});
  mesh.add_face(Vertex(0), Vertex(3), Vertex(4));
  const auto c = mesh.add_property_map<Vertex, Curvature>("c").first;
  EXPECT_THROW(PN::estimate_curvature(mesh, c), std::invalid_argument);
}

// --- types ---

TEST(Estimate_curvature, OtherMeshesKernelsAndMaps)
{
  const Sampled_surface s = lay(square(6, Faces::mixed, 0.2), waves);
  const Curvatures expected = from_points(s.soup);
  const auto expect_near = [&](const auto& c, double tolerance) {
    ASSERT_EQ(c.size(), expected.size());
    for (std::size_t v = 0; v < c.size(); ++v) {
      EXPECT_NEAR(c[v].mean, expected[v].mean, tolerance);
      const auto& d = c[v].minimal_direction;
      const Triple m{CGAL::to_double(d.x()), CGAL::to_double(d.y()), CGAL::to_double(d.z())};
      EXPECT_NEAR(std::abs(dot(m, triple(expected[v].minimal_direction))), 1, tolerance + 1e-14);
    }
  };
  {
    CGAL::Polyhedron_3<Kernel> mesh;
    build(s.soup, mesh);
    const auto c = get(CGAL::dynamic_vertex_property_t<Curvature>(), mesh);
    const auto& constant = mesh;
    PN::estimate_curvature(constant, c);
    expect_near(all_of(mesh, c), 0);
  }
  {
    using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;
    CGAL::Surface_mesh<Epeck::Point_3> mesh;
    build(s.soup, mesh);
    const auto c =
      mesh.add_property_map<CGAL::SM_Vertex_index, PN::Vertex_curvature<Epeck>>("c").first;
    PN::estimate_curvature(mesh, c);
    expect_near(all_of(mesh, c), 1e-12);
  }
  {
    CGAL::Surface_mesh<CGAL::Simple_cartesian<float>::Point_3> mesh;
    build(s.soup, mesh);
    const auto c = mesh.add_property_map<CGAL::SM_Vertex_index, Curvature>("c").first;
    PN::estimate_curvature(mesh, c);
    expect_near(all_of(mesh, c), 1e-3);
  }
  {
    Mesh mesh;
    const auto p = mesh.add_property_map<Vertex, Kernel::Point_3>("p").first;
    build(s.soup, mesh, p);
    for (Vertex v : mesh.vertices()) mesh.point(v) = Kernel::Point_3(0, 0, 0);
    const Vertex removed = mesh.add_vertex({0, 0, 0});
    mesh.remove_vertex(removed); // garbage
    const auto c = mesh.add_property_map<Vertex, Curvature>("c").first;
    PN::estimate_curvature(mesh, c, params::vertex_point_map(p).geom_traits(Kernel()));
    expect_near(all_of(mesh, c), 0);
  }
}

#ifdef CGAL_LINKED_WITH_TBB
TEST(Estimate_curvature, IsTheSameInParallel)
{
  const Sampled_surface s = lay(square(70, Faces::mixed, 0.2), waves);
  const auto expect_same = [](const Curvatures& a, const Curvatures& b) {
    for (std::size_t v = 0; v < a.size(); ++v) {
      EXPECT_EQ(a[v].gaussian, b[v].gaussian);
      EXPECT_EQ(a[v].mean, b[v].mean);
      EXPECT_EQ(a[v].minimal_direction, b[v].minimal_direction);
    }
  };
  expect_same(from_points(mesh_of(s.soup)), from_points<CGAL::Parallel_tag>(mesh_of(s.soup)));
  expect_same(from_normals(s.soup, normals_of(s)),
              from_normals<CGAL::Parallel_tag>(s.soup, normals_of(s)));
}
#endif

} // namespace

// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Estimated curvatures of surfaces whose curvatures are known in closed form.

#include "Curved_surfaces.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/PN_subdivision_3.h>
#include <CGAL/PN_subdivision_3/estimate_curvature.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

using namespace curved_surfaces;
using namespace mesh_cases;
namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Curvature = PN::Vertex_curvature<Kernel>;
using Curvatures = std::vector<Curvature>;

template <class Map, class Any_mesh>
auto all_of(const Any_mesh& mesh, Map map)
{
  std::vector<typename boost::property_traits<Map>::value_type> result;
  for (auto v : vertices(mesh)) result.push_back(get(map, v));
  return result;
}

Mesh mesh_of(const Soup& soup)
{
  Mesh mesh;
  build(soup, mesh);
  return mesh;
}

template <class Tag = CGAL::Sequential_tag>
Curvatures from_points(Mesh mesh)
{
  const auto c = mesh.add_property_map<Vertex, Curvature>("c").first;
  PN::estimate_curvature<Tag>(mesh, c);
  return all_of(mesh, c);
}

Curvatures from_points(const Soup& soup)
{
  return from_points(mesh_of(soup));
}

template <class Tag = CGAL::Sequential_tag>
Curvatures from_normals(const Soup& soup, const std::vector<Triple>& normals)
{
  Mesh mesh = mesh_of(soup);
  const auto c = mesh.add_property_map<Vertex, Curvature>("c").first;
  const auto n = mesh.add_property_map<Vertex, Kernel::Vector_3>("n").first;
  put_normals(normals, mesh, n);
  PN::estimate_curvature<Tag>(mesh, c, params::vertex_normal_map(n));
  return all_of(mesh, c);
}

std::vector<Triple> normals_of(const Sampled_surface& s)
{
  std::vector<Triple> normals;
  for (const Surface_point& p : s.exact) normals.push_back(p.normal);
  return normals;
}

Triple triple(const Kernel::Vector_3& v)
{
  return {v.x(), v.y(), v.z()};
}

double dot(const Triple& a, const Triple& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Triple cross(const Triple& a, const Triple& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// What holds of every result, whatever the surface.
void expect_consistent(const Curvature& c)
{
  ASSERT_TRUE(c.is_estimated);
  const double size = std::abs(c.minimal) + std::abs(c.maximal);
  EXPECT_LE(c.minimal, c.maximal);
  EXPECT_NEAR(c.mean, (c.minimal + c.maximal) / 2, 1e-14 * size);
  EXPECT_NEAR(c.gaussian, c.minimal * c.maximal, 1e-13 * size * size);
  EXPECT_NEAR(c.minimal_direction.squared_length(), 1, 1e-14);
  EXPECT_NEAR(c.maximal_direction.squared_length(), 1, 1e-14);
  EXPECT_NEAR(c.minimal_direction * c.maximal_direction, 0, 1e-14);
}

// The largest error of Gaussian and mean curvature, the latter times 2.
double error(const Curvatures& c, const Sampled_surface& s)
{
  double largest = 0;
  for (std::size_t v = 0; v < c.size(); ++v) {
    expect_consistent(c[v]);
    const double e = (std::max)(std::abs(c[v].gaussian - s.exact[v].gaussian),
                                2 * std::abs(c[v].mean - s.exact[v].mean));
    largest = (std::max)(largest, e);
  }
  return largest;
}

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

// a net over the surface of a file of data/, whose points and normals are exact
Sampled_surface read_sampled(const std::string& file, double gaussian, double mean)
{
  Mesh mesh;
  const auto normals = mesh.add_property_map<Vertex, Kernel::Vector_3>("v:normal").first;
  std::ifstream in(std::string(PN_DATA_DIR) + "/" + file, std::ios::binary);
  EXPECT_TRUE(CGAL::IO::read_PLY(in, mesh)) << file;
  Sampled_surface s{{points(mesh), faces_of(mesh)}, {}};
  for (const Triple& n : values(mesh, normals)) s.exact.push_back({{}, n, gaussian, mean, {}});
  return s;
}

} // namespace

// --- accuracy ---

TEST(Estimate_curvature, second_order_at_all_valences)
{
  for (const Faces kind : {Faces::quads, Faces::triangles})
    for (int n : {3, 4, 5, 6, 7, 8, 10, 12})
      for (const Surface& surface : {Surface(saddle), Surface(waves), Surface(sphere)}) {
        SCOPED_TRACE("valence " + std::to_string(n) + (kind == Faces::quads ? " quads" : ""));
        expect_second_order([&](double h) { return star(n, kind, h); }, surface, 0.02);
      }
}

TEST(Estimate_curvature, second_order_on_uneven_meshes_with_border)
{
  for (const Faces kind : {Faces::quads, Faces::triangles, Faces::mixed})
    for (double jitter : {0., 0.25})
      for (const Surface& surface : {Surface(saddle), Surface(waves), Surface(cylinder)}) {
        SCOPED_TRACE(jitter);
        const auto mesh = [&](double h) { return square(std::size_t(1 / h), kind, jitter); };
        expect_second_order(mesh, surface, 1. / 12);
      }
}

TEST(Estimate_curvature, second_order_on_a_closed_torus)
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
TEST(Estimate_curvature, second_order_on_long_and_skew_faces)
{
  for (const double length : {1., 5., 30.})
    for (const double shear : {0., 1., 3.}) {
      SCOPED_TRACE(std::to_string(length) + ' ' + std::to_string(shear));
      const auto mesh = [length = length, shear = shear](double h) {
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
TEST(Estimate_curvature, steep_cubics_are_exact)
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

TEST(Estimate_curvature, planes_are_flat)
{
  for (const Faces kind : {Faces::quads, Faces::triangles, Faces::mixed}) {
    const Errors e = errors(square(10, kind, 0.25), plane);
    EXPECT_LT(e.points, 1e-12);
    EXPECT_LT(e.normals, 1e-12);
  }
}

// Closed and open, triangles, quads, mixed polygons, valences 3 to 12: with exact normals spheres
// and cylinders are exact.
TEST(Estimate_curvature, spheres_and_cylinders_are_exact_with_normals)
{
  for (const auto& [file, radius] :
       {std::pair("sphere_triangles.ply", 1.), std::pair("sphere_cap.ply", 2.5),
        std::pair("sphere_quads.ply", 1.), std::pair("sphere_mixed.ply", 1.)}) {
    SCOPED_TRACE(file);
    const Sampled_surface s = read_sampled(file, 1 / (radius * radius), 1 / radius);
    EXPECT_LT(error(from_normals(s.soup, normals_of(s)), s), 1e-12);
  }
  for (const auto& [file, radius] :
       {std::pair("cylinder_triangles.ply", 0.75), std::pair("cylinder_quads.ply", 1.)}) {
    SCOPED_TRACE(file);
    const Sampled_surface s = read_sampled(file, 0, 0.5 / radius);
    EXPECT_LT(error(from_normals(s.soup, normals_of(s)), s), 1e-12);
  }
}

// The coarsest nets: the faces of a tetrahedron are too steep, those of an octahedron are not.
TEST(Estimate_curvature, coarse_spheres_are_exact_with_normals)
{
  Soup icosahedron;
  const double g = (1 + std::sqrt(5.)) / 2, l = std::sqrt(1 + g * g);
  for (double a : {-1., 1.})
    for (double b : {-g, g}) {
      icosahedron.points.push_back({a / l, b / l, 0});
      icosahedron.points.push_back({0, a / l, b / l});
      icosahedron.points.push_back({b / l, 0, a / l});
    }
  const auto& p = icosahedron.points;
  for (std::size_t i = 0; i < 12; ++i)
    for (std::size_t j = i + 1; j < 12; ++j)
      for (std::size_t k = i + 1; k < 12; ++k)
        if (k != j && dot(p[i], p[j]) > 0 && dot(p[j], p[k]) > 0 && dot(p[k], p[i]) > 0 &&
            dot(p[i], cross(p[j], p[k])) > 0)
          icosahedron.faces.push_back({i, j, k});
  ASSERT_EQ(icosahedron.faces.size(), 20u);
  for (const Curvature& c : from_normals(icosahedron, icosahedron.points)) {
    EXPECT_NEAR(c.gaussian, 1, 1e-13);
    EXPECT_NEAR(c.mean, 1, 1e-13);
  }
}

// --- invariance ---

TEST(Estimate_curvature, reversed_faces_change_the_sign_of_mean_curvature)
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

TEST(Estimate_curvature, rotation_and_scale)
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

TEST(Estimate_curvature, normals_may_have_any_length)
{
  const Sampled_surface s = lay(square(6, Faces::mixed, 0.2), waves);
  std::vector<Triple> n = normals_of(s);
  for (Triple& m : n) m = {1e200 * m[0], 1e200 * m[1], 1e200 * m[2]};
  const Curvatures a = from_normals(s.soup, normals_of(s)), b = from_normals(s.soup, n);
  for (std::size_t v = 0; v < a.size(); ++v) EXPECT_NEAR(a[v].mean, b[v].mean, 1e-13);
}

// --- degenerate input ---

// What has no neighbors is not estimated, what has, is.
TEST(Estimate_curvature, components_and_vertices_without_faces)
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

TEST(Estimate_curvature, too_few_vertices)
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
TEST(Estimate_curvature, three_rows_give_a_quadric)
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

TEST(Estimate_curvature, edges_without_length_and_faces_without_area)
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
TEST(Estimate_curvature, other_side_of_a_plate_is_left_out)
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

// Where there is no normal, the point counts and the faces tell the side.
TEST(Estimate_curvature, missing_normals)
{
  const Sampled_surface s = lay(square(12, Faces::mixed, 0.1), waves);
  const double from_all_normals = error(from_normals(s.soup, normals_of(s)), s);
  std::vector<Triple> n = normals_of(s);
  for (std::size_t v = 0; v < n.size(); v += 3) n[v] = {0, 0, 0};
  EXPECT_LT(error(from_normals(s.soup, n), s), 2 * from_all_normals);
  n.assign(n.size(), Triple{0, 0, 0});
  EXPECT_LT(error(from_normals(s.soup, n), s), 10 * from_all_normals);
}

// Gaussian curvatures of 1e400 and more
TEST(Estimate_curvature, curvatures_out_of_range)
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

TEST(Estimate_curvature, numbers_that_are_not_finite_are_refused)
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
      try {
        PN::estimate_curvature(mesh, c, params::vertex_normal_map(n));
        FAIL() << "no exception";
      } catch (const std::invalid_argument& e) {
        const std::string what = in_normal ? "normal of vertex 7" : "point of vertex 7";
        EXPECT_NE(std::string(e.what()).find(what), std::string::npos) << e.what();
      }
      for (Vertex v : mesh.vertices()) EXPECT_EQ(c[v].mean, 42);
    }
  }
}

TEST(Estimate_curvature, bow_ties_are_refused)
{
  Mesh mesh = mesh_of({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}}, {{0, 1, 2}}});
  mesh.add_face(Vertex(0), Vertex(3), Vertex(4));
  const auto c = mesh.add_property_map<Vertex, Curvature>("c").first;
  EXPECT_THROW(PN::estimate_curvature(mesh, c), std::invalid_argument);
}

// --- types ---

TEST(Estimate_curvature, scalar_maps)
{
  Mesh mesh = mesh_of(lay(square(4, Faces::quads, 0), waves).soup);
  const auto c = mesh.add_property_map<Vertex, Curvature>("c").first;
  PN::estimate_curvature(mesh, c);
  const auto gaussian = PN::gaussian_curvature_map(c);
  const auto mean = PN::mean_curvature_map(c);
  static_assert(std::is_same_v<boost::property_traits<decltype(mean)>::value_type, double>);
  for (Vertex v : mesh.vertices()) {
    EXPECT_NE(c[v].gaussian, c[v].mean);
    EXPECT_EQ(get(gaussian, v), c[v].gaussian);
    EXPECT_EQ(get(mean, v), c[v].mean);
  }
}

TEST(Estimate_curvature, other_meshes_kernels_and_maps)
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
TEST(Estimate_curvature, is_the_same_in_parallel)
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

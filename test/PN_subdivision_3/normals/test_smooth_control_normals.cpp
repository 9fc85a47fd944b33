// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Given normals that are smoothed using the points: a minimum by a dense solve, noise that is known, the mean change of
// curvature of the refined surface, what must not change.

#include "Extent.h"
#include "Failing_map.h"
#include "Mesh_cases.h"
#include "Sampled_surfaces.h"
#include "support/Exact_rational.h"

#include <CGAL/PN_fitting_3/smooth_control_normals.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
#include <CGAL/PN_subdivision_3/subdivide.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <limits>
#include <set>

namespace {

namespace PN = CGAL::PN_subdivision_3;
using sampled_surfaces::Cells;
using sampled_surfaces::Control_mesh;
using sampled_surfaces::Triple;
using Kernel = CGAL::Simple_cartesian<double>;
using Vector_3 = Kernel::Vector_3;

template <class K>
struct Mesh_with_normals
{
  using Mesh = CGAL::Surface_mesh<typename K::Point_3>;
  using Vertex = typename Mesh::Vertex_index;
  using Vector = typename K::Vector_3;

  explicit Mesh_with_normals(const Control_mesh& control)
  {
    normals = mesh.template add_property_map<Vertex, Vector>("v:normal").first;
    mesh_cases::build(control, mesh);
    mesh_cases::put_normals(control.normals, mesh, normals);
  }
  Mesh_with_normals(const Mesh_with_normals& other)
    : mesh(other.mesh)
    , normals(mesh.template add_property_map<Vertex, Vector>("v:normal").first)
  {}
  Mesh_with_normals& operator=(const Mesh_with_normals&) = delete;

  Mesh mesh;
  typename Mesh::template Property_map<Vertex, Vector> normals;
};
using Sampled = Mesh_with_normals<Kernel>;

// turns normals by angles with the root mean square of `degrees`
void disturb(Sampled& s, double degrees, unsigned seed = 1)
{
  std::mt19937 generator(seed);
  std::normal_distribution<double> random(0, degrees * CGAL_PI / 180 / std::sqrt(2.));
  for (const auto v : s.mesh.vertices()) {
    const double x = random(generator), y = random(generator), z = random(generator);
    const Vector_3 n = s.normals[v], r(x, y, z), m = n + r - (r * n) * n;
    s.normals[v] = m / std::sqrt(m.squared_length());
  }
}

Control_mesh sphere()
{
  return sampled_surfaces::scattered(3, 0.2, 3, sampled_surfaces::on_sphere);
}
Control_mesh ellipsoid()
{
  return sampled_surfaces::scattered(3, 0.2, 3, sampled_surfaces::on_ellipsoid);
}
Control_mesh torus(Cells cells)
{
  std::mt19937 generator(5);
  const auto u = sampled_surfaces::uneven(33, 0.2, generator);
  const auto v = sampled_surfaces::uneven(17, 0.2, generator);
  return sampled_surfaces::torus(u, v, cells);
}
Control_mesh waves(Cells cells)
{
  return sampled_surfaces::patch(20, 20, 0.1, cells, 7, sampled_surfaces::on_waves);
}

Sampled refined(Sampled s, double roundness)
{
  const auto np =
    PN::parameters::roundness(roundness).number_of_iterations(2).vertex_normal_map(s.normals);
  if (CGAL::is_triangle_mesh(s.mesh))
    PN::subdivide(s.mesh, PN::Loop_scheme(), np);
  else
    PN::subdivide(s.mesh, PN::CatmullClark_scheme(), np);
  return s;
}

// The mean of |grad H| of a refined surface: H by cotangents, of quads the mean of both ways to split them.
class Fairness
{
public:
  explicit Fairness(const Sampled& s)
  {
    for (const auto v : s.mesh.vertices()) {
      p_.push_back(s.mesh.point(v));
      n_.push_back(s.normals[v]);
      is_inner_.push_back(!s.mesh.is_border(v));
    }
    for (const auto f : s.mesh.faces()) {
      std::vector<std::size_t> c;
      for (const auto v : CGAL::vertices_around_face(s.mesh.halfedge(f), s.mesh)) c.push_back(v);
      if (c.size() == 3)
        triangles_.push_back({c[0], c[1], c[2]});
      else
        for (std::size_t i = 0; i < 4; ++i)
          triangles_.push_back({c[i], c[(i + 1) % 4], c[(i + 2) % 4]});
    }
  }

  double operator()() const
  {
    std::vector<Vector_3> laplacian(p_.size(), Vector_3(0, 0, 0));
    std::vector<double> area(p_.size(), 0);
    for (const auto& t : triangles_)
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t a = t[i], b = t[(i + 1) % 3], c = t[(i + 2) % 3];
        const Vector_3 u = p_[a] - p_[c], v = p_[b] - p_[c];
        const double twice = std::sqrt(CGAL::cross_product(u, v).squared_length());
        const Vector_3 flow = (u * v) / twice / 2 * (p_[a] - p_[b]);
        laplacian[a] = laplacian[a] + flow;
        laplacian[b] = laplacian[b] - flow;
        area[c] += twice / 6;
      }
    std::vector<double> mean(p_.size());
    for (std::size_t v = 0; v < p_.size(); ++v) mean[v] = laplacian[v] * n_[v] / area[v] / 2;
    double sum = 0, all = 0;
    for (const auto& t : triangles_) {
      if (!is_inner_[t[0]] || !is_inner_[t[1]] || !is_inner_[t[2]]) continue;
      const Vector_3 u = p_[t[1]] - p_[t[0]], v = p_[t[2]] - p_[t[0]];
      const Vector_3 w = (mean[t[2]] - mean[t[0]]) * u - (mean[t[1]] - mean[t[0]]) * v;
      sum += std::sqrt(w.squared_length()) / 2; // |grad H| times the area
      all += std::sqrt(CGAL::cross_product(u, v).squared_length()) / 2;
    }
    return sum / all;
  }

private:
  std::vector<Kernel::Point_3> p_;
  std::vector<Vector_3> n_;
  std::vector<bool> is_inner_;
  std::vector<std::array<std::size_t, 3>> triangles_;
};

double fairness(const Sampled& s, double roundness = 1)
{
  return Fairness(refined(s, roundness))();
}

// of faces that share an edge, in degrees
double mean_turn(const Sampled& control, double roundness)
{
  const Sampled s = refined(control, roundness);
  const auto normal = [&](auto h) { // by the diagonals of quads
    const auto &p = s.mesh.point(s.mesh.source(h)), &q = s.mesh.point(s.mesh.target(h));
    const auto &r = s.mesh.point(s.mesh.target(s.mesh.next(h))),
               &t = s.mesh.point(s.mesh.source(s.mesh.prev(h)));
    const Vector_3 n =
      p == t || r == t ? CGAL::cross_product(q - p, r - p) : CGAL::cross_product(r - p, t - q);
    return n / std::sqrt(n.squared_length());
  };
  double sum = 0, number = 0;
  for (const auto e : s.mesh.edges()) {
    const auto h = s.mesh.halfedge(e);
    if (s.mesh.is_border(e)) continue;
    sum += std::acos((std::min)(1., normal(h) * normal(s.mesh.opposite(h)))) * 180 / CGAL_PI;
    ++number;
  }
  return sum / number;
}

double error(const Sampled& s, const Control_mesh& exact)
{
  double sum = 0;
  for (const auto v : s.mesh.vertices()) {
    const Triple& n = exact.normals[v];
    sum += (s.normals[v] - Vector_3(n[0], n[1], n[2])).squared_length();
  }
  return std::sqrt(sum / double(s.mesh.number_of_vertices())) * 180 / CGAL_PI;
}

TEST(Smooth_normals, AreFairerAndCloserAndNoiseIsKnown)
{
  const std::pair<const char*, Control_mesh> shapes[] = {
    {"sphere", sphere()},
    {"ellipsoid", ellipsoid()},
    {"torus, quads", torus(Cells::quads)},
    {"torus, triangles", torus(Cells::triangles)},
    {"waves, quads", waves(Cells::quads)},
    {"waves, triangles", waves(Cells::triangles)}};
  for (const auto& [name, control] : shapes)
    for (const double noise : {0., 0.2, 1., 2., 5.}) {
      const bool may_stay = name == std::string("torus, triangles");
      if (!tests_are_full && noise < 5 && !(may_stay && (noise == 0 || noise == 1))) continue;
      SCOPED_TRACE(name + (" " + std::to_string(noise)));
      Sampled s(control);
      disturb(s, noise);
      const double angle = error(s, control), before = fairness(s);
      const auto report = PN::smooth_control_normals(s.mesh, s.normals);
      const double after = fairness(s);
      EXPECT_LE(after, before);
      EXPECT_LE(report.noise, report.arc_defect * 1.15);
      if (noise == 0) {
        EXPECT_EQ(report.changed_normals, 0u);
        EXPECT_EQ(error(s, control), angle);
        EXPECT_EQ(report.strength, 0);
      }
      if (noise < 1) continue;
      EXPECT_NEAR(report.noise, angle, 0.15 * angle);
      if (report.changed_normals == 0) { // there the shape counts for as much
        EXPECT_TRUE(may_stay);
        EXPECT_LT(noise, 5);
        continue;
      }
      EXPECT_LE(error(s, control), 0.5 * angle);
      EXPECT_GT(report.largest_turn, angle);
      EXPECT_LT(report.largest_turn, 4 * angle);
    }
}

// Points that are off by some percent of their edges: no normals take that off.
TEST(Smooth_normals, NoiseOfPointsLowersTheRoundness)
{
  for (const double part : {0.02, 0.05, 0.1}) {
    if (!tests_are_full && part < 0.1) continue;
    SCOPED_TRACE(part);
    Sampled s(waves(Cells::quads));
    std::mt19937 generator(3);
    std::normal_distribution<double> random(0, part);
    for (const auto v : s.mesh.vertices()) {
      double shortest = std::numeric_limits<double>::infinity();
      for (const auto u : CGAL::vertices_around_target(s.mesh.halfedge(v), s.mesh))
        shortest = (std::min)(shortest, CGAL::squared_distance(s.mesh.point(u), s.mesh.point(v)));
      s.mesh.point(v) = s.mesh.point(v) + random(generator) * std::sqrt(shortest) * s.normals[v];
    }
    disturb(s, 100 * part);
    const double before = fairness(s), linear = fairness(s, 0);
    const auto report = PN::smooth_control_normals(s.mesh, s.normals);
    EXPECT_LT(report.roundness, 1);
    EXPECT_LE(fairness(s, report.roundness), (std::min)(before, 1.001 * linear));
  }
}

// --- the minimum ---

std::vector<Vector_3> minimum(const Control_mesh& control, const std::vector<Vector_3>& m,
                              double lambda)
{
  const std::size_t n = m.size();
  const auto point = [&](int i) {
    const Triple& p = control.points[std::size_t(i)];
    return Kernel::Point_3(p[0], p[1], p[2]);
  };
  std::vector<double> area(n, 0);
  double sum = 0;
  std::set<std::pair<int, int>> edges;
  for (const auto& f : control.faces) {
    Vector_3 normal(0, 0, 0);
    for (std::size_t i = 0; i < f.size(); ++i) {
      const int a = f[i], b = f[(i + 1) % f.size()];
      normal = normal + CGAL::cross_product(point(a) - CGAL::ORIGIN, point(b) - CGAL::ORIGIN) / 2;
      edges.insert(std::minmax(a, b));
    }
    const double size = std::sqrt(normal.squared_length());
    for (const int v : f) area[std::size_t(v)] += size / double(f.size());
    sum += size;
  }
  const auto size = Eigen::Index(3 * n);
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(size, size);
  Eigen::VectorXd b(size);
  for (std::size_t v = 0; v < n; ++v)
    for (int k = 0; k < 3; ++k) {
      const auto i = Eigen::Index(3 * v) + k;
      a(i, i) = area[v] * double(n) / sum;
      b(i) = a(i, i) * m[v][k];
    }
  for (const auto& [i, j] : edges) {
    const Vector_3 e = point(j) - point(i);
    for (const int v : {i, j})
      for (const int w : {i, j})
        for (int k = 0; k < 3; ++k)
          for (int l = 0; l < 3; ++l)
            a(3 * v + k, 3 * w + l) += lambda * e[k] * e[l] / e.squared_length();
  }
  const Eigen::VectorXd x = a.partialPivLu().solve(b);
  std::vector<Vector_3> normals;
  for (Eigen::Index v = 0; v < size; v += 3) {
    const Vector_3 y(x(v), x(v + 1), x(v + 2));
    normals.push_back(y / std::sqrt(y.squared_length()));
  }
  return normals;
}

TEST(Smooth_normals, AreTheMinimum)
{
  for (const Control_mesh& control :
       {sampled_surfaces::scattered(1, 0.3, 3, sampled_surfaces::on_ellipsoid),
        sampled_surfaces::patch(6, 5, 0.2, Cells::mixed, 7, sampled_surfaces::on_waves)}) {
    Sampled s(control);
    disturb(s, 4);
    std::vector<Vector_3> given;
    for (const auto v : s.mesh.vertices()) given.push_back(s.normals[v]);
    const auto report = PN::smooth_control_normals(s.mesh, s.normals);
    const double noise = report.noise * report.noise, arcs = report.arc_defect * report.arc_defect;
    const double chance = (std::min)(2 / std::sqrt(double(given.size())), .2); // all have a fit
    const double shape = (std::max)(arcs - (1 + chance) * noise, noise / 1000);
    ASSERT_GT(report.strength, 0);
    EXPECT_NEAR(report.strength / ((noise - arcs / 10) / 2 / shape), 1, 1e-9);
    const std::vector<Vector_3> expected = minimum(control, given, report.strength);
    for (const auto v : s.mesh.vertices())
      EXPECT_LE(std::sqrt((s.normals[v] - expected[v]).squared_length()), 1e-9) << v;
    EXPECT_EQ(report.changed_normals, given.size());
  }
}

TEST(Smooth_normals, ScaleWithTheMesh)
{
  const Control_mesh control =
    sampled_surfaces::scattered(2, 0.3, 3, sampled_surfaces::on_ellipsoid);
  Sampled one(control);
  disturb(one, 3);
  const Sampled given(one);
  PN::smooth_control_normals(one.mesh, one.normals);
  for (const double scale : {0x1p-600, 0x1p600}) {
    Sampled other(given);
    for (const auto v : other.mesh.vertices())
      other.mesh.point(v) = CGAL::ORIGIN + scale * (given.mesh.point(v) - CGAL::ORIGIN);
    PN::smooth_control_normals(other.mesh, other.normals);
    for (const auto v : one.mesh.vertices())
      EXPECT_LE((one.normals[v] - other.normals[v]).squared_length(), 1e-24);
  }
}

// --- what stays ---

TEST(Smooth_normals, LeaveArcsThatHold)
{
  for (const Control_mesh& control : {sphere(), torus(Cells::quads)}) {
    Sampled s(control);
    for (const auto v : s.mesh.vertices()) s.normals[v] = 3 * s.normals[v]; // of any length
    const Sampled given(s);
    const auto report = PN::smooth_control_normals(s.mesh, s.normals);
    EXPECT_EQ(report.changed_normals, 0u);
    EXPECT_NEAR(report.mean_turn, mean_turn(given, 1), 1e-6);
    EXPECT_NEAR(report.linear_mean_turn, mean_turn(given, 0), 1e-6);
    for (const auto v : s.mesh.vertices()) EXPECT_EQ(s.normals[v], given.normals[v]);
  }
}

TEST(Smooth_normals, TakeTheLeastNoise)
{
  const Control_mesh control = sphere();
  Sampled s(control);
  disturb(s, 1e-6);
  const double angle = error(s, control);
  PN::smooth_control_normals(s.mesh, s.normals);
  EXPECT_LE(error(s, control), 0.1 * angle);
}

// A sphere with noise; beside it one without, an isolated vertex, a triangle of one line, and normals that are zero or
// reversed.
TEST(Smooth_normals, LeaveWhatHasNothingToSay)
{
  Control_mesh control = sphere();
  const auto n = std::uint32_t(control.points.size());
  Sampled disturbed(control);
  disturb(disturbed, 2);
  const Control_mesh clean = sampled_surfaces::scattered(1, 0.2, 3, sampled_surfaces::on_sphere);
  control = test_meshes::united(control, clean);
  control.normals.insert(control.normals.end(), clean.normals.begin(), clean.normals.end());
  const int isolated = int(control.points.size()); // and behind it a triangle of one line
  control.points.insert(control.points.end(), {{9, 9, 9}, {0, 7, 0}, {0, 7, 0}, {1, 7, 0}});
  control.normals.insert(control.normals.end(), {{0, 0, 2}, {0, .6, .8}, {0, .6, .8}, {0, .6, .8}});
  control.faces.push_back({isolated + 1, isolated + 2, isolated + 3});
  Sampled s(control);
  for (const auto v : disturbed.mesh.vertices()) s.normals[v] = disturbed.normals[v];
  s.normals[Sampled::Vertex(7)] = Vector_3(0, 0, 0);
  s.normals[Sampled::Vertex(50)] = -s.normals[Sampled::Vertex(50)];
  const Sampled given(s);
  PN::smooth_control_normals(s.mesh, s.normals);
  for (const auto v : s.mesh.vertices()) {
    const std::uint32_t i = v;
    if (i >= n || i == 7 || i == 50)
      EXPECT_EQ(s.normals[v], given.normals[v]) << v;
    else // nor do they spoil the others
      EXPECT_LE((s.normals[v] - (s.mesh.point(v) - CGAL::ORIGIN)).squared_length(), 1e-4) << v;
  }
}

TEST(Smooth_normals, OfNothing)
{
  Sampled empty(Control_mesh{"empty", {}, {}, {}});
  EXPECT_EQ(PN::smooth_control_normals(empty.mesh, empty.normals).changed_normals, 0u);
  Sampled one(Control_mesh{
    "one", {{0, 0, 0}, {1, 0, 0}, {0, 1, .1}}, {{0, 1, 2}}, {{0, 0, 1}, {.6, 0, .8}, {0, 0, 1}}});
  EXPECT_EQ(PN::smooth_control_normals(one.mesh, one.normals).changed_normals, 0u);
}

// --- wedges ---

// A half sphere and the disk below it, with noise on the sphere: its wedges are smoothed as if the disk were not there.
TEST(Smooth_normals, OfWedgesAreThoseOfTheParts)
{
  std::mt19937 generator(5);
  const auto u = sampled_surfaces::uneven(25, 0.2, generator);
  const auto v = sampled_surfaces::uneven(8, 0.2, generator);
  const Control_mesh dome = sampled_surfaces::revolution(
    u, v, false, Cells::quads, [](sampled_surfaces::Real s, sampled_surfaces::Real t) {
      const auto z = 0.9L * t, r = std::sqrt(1 - z * z);
      return sampled_surfaces::on_sphere({r * std::cos(s), r * std::sin(s), z});
    });
  Sampled alone(dome);
  disturb(alone, 2);
  Sampled whole(alone);
  std::vector<Sampled::Vertex> rim;
  for (std::uint32_t i = 24; i-- > 0;) rim.emplace_back(i);
  const auto disk = whole.mesh.add_face(rim);
  const auto sharp =
    whole.mesh.add_property_map<Sampled::Mesh::Edge_index, bool>("e:sharp", false).first;
  const auto corners =
    whole.mesh.add_property_map<Sampled::Mesh::Halfedge_index, Vector_3>("h:normal").first;
  for (const auto h : whole.mesh.halfedges()) corners[h] = whole.normals[whole.mesh.target(h)];
  for (const auto h : CGAL::halfedges_around_face(whole.mesh.halfedge(disk), whole.mesh)) {
    sharp[whole.mesh.edge(h)] = true;
    corners[h] = Vector_3(0, 0, -1);
  }
  const auto report = PN::smooth_control_normals(whole.mesh, corners,
                                                 CGAL::parameters::edge_is_constrained_map(sharp));
  const auto expected = PN::smooth_control_normals(alone.mesh, alone.normals);
  EXPECT_EQ(report.changed_normals, alone.mesh.number_of_vertices());
  EXPECT_NEAR(report.noise, expected.noise, 0.2);
  for (const auto h : whole.mesh.halfedges()) {
    if (whole.mesh.is_border(h)) continue;
    if (whole.mesh.face(h) == disk)
      EXPECT_EQ(corners[h], Vector_3(0, 0, -1));
    else // the strength and the mean area are of both
      EXPECT_LE((corners[h] - alone.normals[whole.mesh.target(h)]).squared_length(), 1e-3);
  }
}

// --- number types, faults ---

TEST(Smooth_normals, OfExactNumbersAreThoseOfDoubles)
{
  long_test([](auto) {
    const Control_mesh control =
      sampled_surfaces::patch(6, 5, 0.2, Cells::mixed, 7, sampled_surfaces::on_waves);
    Sampled s(control);
    disturb(s, 4);
    Mesh_with_normals<CGAL::Simple_cartesian<CGAL::Exact_rational>> exact(control);
    for (const auto v : s.mesh.vertices()) {
      const Vector_3 n = s.normals[v];
      exact.normals[CGAL::SM_Vertex_index(v)] =
        CGAL::Simple_cartesian<CGAL::Exact_rational>::Vector_3(n.x(), n.y(), n.z());
    }
    PN::smooth_control_normals(s.mesh, s.normals);
    PN::smooth_control_normals(exact.mesh, exact.normals);
    for (const auto v : s.mesh.vertices())
      for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(CGAL::to_double(exact.normals[CGAL::SM_Vertex_index(v)][k]), s.normals[v][k],
                    1e-13);
  });
}

TEST(Smooth_normals, AreAsBeforeAfterAnError)
{
  Sampled s(sphere());
  disturb(s, 2);
  const auto expect_unchanged = [&](const Sampled& given) {
    for (const auto v : s.mesh.vertices())
      if (s.normals[v] != given.normals[v] && s.normals[v] == s.normals[v]) ADD_FAILURE() << v;
  };
  const Sampled given(s);
  failing_maps::Calls_left left(99);
  EXPECT_THROW(PN::smooth_control_normals(s.mesh, failing(s.normals, left)),
               failing_maps::User_failure);
  expect_unchanged(given);
  s.normals[Sampled::Vertex(3)] = Vector_3(0, std::numeric_limits<double>::quiet_NaN(), 0);
  EXPECT_THROW(PN::smooth_control_normals(s.mesh, s.normals), std::invalid_argument);
  expect_unchanged(given);
}

} // namespace

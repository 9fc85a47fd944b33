// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Limits of meshes with creases, corners and borders that are creases.

#include "Random_creases.h"
#include "Tagged_meshes.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/PN_subdivision_3/subdivide_to_limit.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

using namespace tagged_meshes;
using Mesh = CGAL::Surface_mesh<Point_3>;
using PN::internal::Vertex_rule;

PN::Limit_options close(double tolerance)
{
  PN::Limit_options options;
  options.tolerance = tolerance;
  options.max_depth = 40;
  return options;
}

template <class Any_mesh, class Scheme, class Concurrency_tag = CGAL::Sequential_tag>
PN::Limit_report to_limit(Tagged<Any_mesh>& t, const Scheme& scheme, unsigned rounds,
                          const PN::Limit_options& options)
{
  return PN::subdivide_to_limit<Concurrency_tag>(t.mesh, scheme, options,
                                                 np::number_of_iterations(rounds)
                                                   .edge_is_constrained_map(t.sharp)
                                                   .vertex_is_constrained_map(t.corners)
                                                   .vertex_normal_map(t.normals));
}

// the limits at the control vertices, after some rounds: points, and the normals of all corners
struct Limits
{
  std::vector<Vector> points;
  std::vector<std::vector<Vector>> normals;
  PN::Limit_report report;
};

Vector vector(const Point_3& p)
{
  return {p.x(), p.y(), p.z()};
}
Vector vector(const Vector_3& p)
{
  return {p.x(), p.y(), p.z()};
}

template <class Scheme>
Limits limits(const Control& control, const Scheme& scheme, unsigned rounds,
              const PN::Limit_options& options)
{
  Tagged<Mesh> t(control);
  Limits result;
  result.report = to_limit(t, PN::with_border(scheme, control.border), rounds, options);
  for (std::size_t i = 0; i < control.points.size(); ++i) {
    const Mesh::Vertex_index v(static_cast<Mesh::size_type>(i));
    result.points.push_back(vector(t.mesh.point(v)));
    result.normals.emplace_back();
    if (t.mesh.is_isolated(v)) continue;
    for (const auto h : t.mesh.halfedges_around_target(t.mesh.halfedge(v)))
      if (!t.mesh.is_border(h)) result.normals.back().push_back(vector(get(t.normals, h)));
  }
  return result;
}

// the greatest distance of the points, and of any normal from the nearest one of the other limits
std::pair<double, double> difference(const Limits& a, const Limits& b)
{
  Real points = 0, normals = 0;
  for (std::size_t v = 0; v < a.points.size(); ++v) {
    points = (std::max)(points, (a.points[v] - b.points[v]).norm());
    for (const Vector& n : a.normals[v]) {
      Real least = std::numeric_limits<Real>::infinity();
      for (const Vector& m : b.normals[v]) least = (std::min)(least, Real((n - m).norm()));
      normals = (std::max)(normals, least);
    }
  }
  return {double(points), double(normals)};
}

// random nets with creases, corners, darts and one or the other border
Control random_net(int seed)
{
  std::mt19937 random(static_cast<unsigned>(seed));
  Control c = seed % 2 == 0 ? random_creases::patch() : random_creases::box();
  random_creases::perturb(c, random);
  c.border = std::array{Border::surface, Border::curve, Border::corners,
                        Border::fixed}[static_cast<std::size_t>(seed / 2 % 4)];
  random_creases::tag(c, random, 0.15, {infinity});
  if (seed % 3 == 0) c.sharp_vertices.clear();
  random_creases::give_normals(c, random);
  return c;
}

// --- shapes ---

// the surface of the part that the face lies on and whose normal it has, about; none of a face
// without an area
const Surface* surface_of(const Part& part, const Tagged<Mesh>& t, Mesh::Face_index f)
{
  Vector area = Vector::Zero(), mean = Vector::Zero();
  for (const auto h : t.mesh.halfedges_around_face(t.mesh.halfedge(f))) {
    const Vector p = vector(t.mesh.point(t.mesh.source(h)));
    area += p.cross(vector(t.mesh.point(t.mesh.target(h))));
    mean += p / Real(t.mesh.degree(f));
  }
  if (!(area.norm() > 1e-9)) return nullptr;
  area.normalize();
  // a face that is folded over lies on its surface, too
  const auto deviation = [&](const Surface& s) {
    Real greatest = (std::min)((s.normal(mean) - area).norm(), (s.normal(mean) + area).norm());
    for (const auto v : t.mesh.vertices_around_face(t.mesh.halfedge(f)))
      greatest = (std::max)(greatest, s.distance(vector(t.mesh.point(v))));
    return greatest;
  };
  return &*std::min_element(
    part.surfaces.begin(), part.surfaces.end(),
    [&](const Surface& a, const Surface& b) { return deviation(a) < deviation(b); });
}

template <class Scheme>
void expect_exact(const Part& part, const Control& control, const Scheme& scheme)
{
  for (const unsigned rounds : {1u, 2u}) {
    Tagged<Mesh> t(control);
    const PN::Limit_report report =
      to_limit(t, PN::with_border(scheme, part.border), rounds, PN::Limit_options());
    EXPECT_TRUE(report.is_within_tolerance());
    const Real bar = 8 * Real(std::numeric_limits<double>::epsilon());
    Real points = 0, normals = 0, border = 0;
    for (const auto f : t.mesh.faces()) {
      const Surface* const surface = surface_of(part, t, f);
      if (surface == nullptr) continue;
      const Surface& s = *surface;
      for (const auto h : t.mesh.halfedges_around_face(t.mesh.halfedge(f))) {
        const Vector p = vector(t.mesh.point(t.mesh.target(h)));
        points = (std::max)(points, s.distance(p));
        normals = (std::max)(normals, Real((vector(get(t.normals, h)) - s.normal(p)).norm()));
        if (part.of_border.empty() || !t.mesh.is_border(t.mesh.target(h))) continue;
        Real least = std::numeric_limits<Real>::infinity();
        for (const Surface& b : part.of_border) least = (std::min)(least, b.distance(p));
        border = (std::max)(border, least);
      }
    }
    EXPECT_LE(double(points), double(bar * part.scale()));
    EXPECT_LE(double(normals), double(bar));
    EXPECT_LE(double(border), double(bar * part.scale()));
  }
}

TEST(Limit_creases, PartsKeepTheirSurfacesRimsAndNormals)
{
  for (Part part : {capped_cylinder(uneven(7)), half_ball(), washer(), d_section(), cube(),
                    plate_with_hole(), octant()}) {
    SCOPED_TRACE("part with " + std::to_string(part.points.size()) + " vertices");
    part.place();
    const Control control = part.control();
    expect_exact(part, control, PN::CatmullClark_scheme());
    expect_exact(part, triangulated(control), PN::Loop_scheme());
  }
}

// rings of a capped cylinder, in float
TEST(Limit_creases, RimsAreCirclesInFloat)
{
  using Float = CGAL::Simple_cartesian<float>;
  using Float_mesh = CGAL::Surface_mesh<Float::Point_3>;
  const Part part = capped_cylinder(uneven(7));
  const Control c = part.control();
  Float_mesh mesh;
  for (const Triple& p : c.points)
    mesh.add_vertex(Float::Point_3(float(p[0]), float(p[1]), float(p[2])));
  for (const Face& f : c.faces) {
    std::vector<CGAL::SM_Vertex_index> corners;
    for (const int v : f) corners.emplace_back(CGAL::SM_Vertex_index::size_type(v));
    mesh.add_face(corners);
  }
  auto sharp = mesh.add_property_map<CGAL::SM_Edge_index, bool>("e:sharp", false).first;
  PN::detect_creases(mesh, 75, sharp);
  PN::subdivide_to_limit(mesh, PN::CatmullClark_scheme(), PN::Limit_options(),
                         np::number_of_iterations(2).edge_is_constrained_map(sharp));
  int rims = 0;
  for (const auto e : mesh.edges()) {
    if (!sharp[e]) continue;
    const auto p = mesh.point(mesh.vertex(e, 0));
    EXPECT_NEAR(std::hypot(p.x(), p.y()), 1, 8 * std::numeric_limits<float>::epsilon());
    ++rims;
  }
  EXPECT_EQ(rims, 2 * 7 * 4);
}

// --- the limit of all rounds ---

// The limits are those of every later level, and the points of the levels come closer to them.
template <class Scheme>
void expect_limit_of_rounds(const Control& control, const Scheme& scheme, bool is_linear)
{
  const double tolerance = 1e-11;
  const Limits last = limits(control, scheme, 3, close(tolerance));
  for (const unsigned rounds : {0u, 1u, 2u}) {
    const Limits l = limits(control, scheme, rounds, close(tolerance));
    EXPECT_EQ(l.report.number_of_misses, 0u);
    const auto [points, normals] = difference(l, last);
    EXPECT_LE(points, is_linear ? 1e-14 : 2e-11) << "from round " << rounds;
    if (!is_linear) {
      EXPECT_LE(normals, 1e-9) << "from round " << rounds;
    }
  }
  double before = std::numeric_limits<double>::infinity();
  Crease_run<double, Scheme> run(control, scheme);
  for (int k = 0; k < 5; ++k) {
    if (k != 0) run.refine();
    double distance = 0;
    for (std::size_t v = 0; v < last.points.size(); ++v) {
      const Triple p = run.point(static_cast<Index>(v));
      distance = (std::max)(distance, double((crease_shapes::vector(p) - last.points[v]).norm()));
    }
    EXPECT_LE(distance, 0.75 * before) << "after round " << k;
    before = distance;
  }
}

TEST(Limit_creases, AreTheSameFromEveryLevel)
{
  for (int seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Control c = random_net(seed);
    expect_limit_of_rounds(c, PN::CatmullClark_scheme(), false);
    expect_limit_of_rounds(c, PN::modified_CatmullClark_scheme(), false);
    expect_limit_of_rounds(triangulated(c), PN::Loop_scheme(), false);
    expect_limit_of_rounds(c, PN::linear(PN::CatmullClark_scheme()), true);
  }
}

// where rounds differ and where curvature is transferred, the whole level is refined
TEST(Limit_creases, AreTheSameWhereTheRulesSettleLate)
{
  const Control c = random_net(3);
  expect_limit_of_rounds(c, PN::modified_CatmullClark_scheme(.5, 3), false);
  expect_limit_of_rounds(triangulated(c), PN::ct_Loop_scheme(), false);
}

// A box of 1 x 2 x 2 cells: its corners are neighbors in pairs, and a crease ends at one of them, which so keeps the
// other one from being separated in the first round.
TEST(Limit_creases, AreTheSameBesideAnIrregularDart)
{
  const int cells[] = {1, 2, 2};
  Control c;
  std::map<std::array<int, 3>, int> index;
  const auto vertex = [&](const std::array<int, 3>& p) {
    const auto [it, is_new] = index.try_emplace(p, int(c.points.size()));
    if (is_new) c.points.push_back({double(p[0]), double(p[1]), double(p[2])});
    return it->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const int side : {0, 1})
      for (int i = 0; i < cells[(axis + 1) % 3]; ++i)
        for (int j = 0; j < cells[(axis + 2) % 3]; ++j) {
          Face f;
          for (const auto& [di, dj] : {Edge{0, 0}, Edge{1, 0}, Edge{1, 1}, Edge{0, 1}}) {
            std::array<int, 3> p{};
            p[axis] = side * cells[axis];
            p[(axis + 1) % 3] = i + di;
            p[(axis + 2) % 3] = j + dj;
            f.push_back(vertex(p));
          }
          if (side == 0) std::reverse(f.begin(), f.end());
          c.faces.push_back(f);
        }
  c.sharp_edges[undirected(index.at({0, 0, 0}), index.at({0, 1, 0}))] = infinity;
  std::mt19937 random(1);
  random_creases::perturb(c, random);
  random_creases::give_normals(c, random);
  expect_limit_of_rounds(c, PN::modified_CatmullClark_scheme(), false);
}

TEST(Limit_creases, TheErrorIsNotUnderestimated)
{
  for (const int seed : {1, 2, 3, 4, 5})
    for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
      const Control c = random_net(seed);
      const Limits exact = limits(c, PN::CatmullClark_scheme(), 1, close(1e-13)),
                   l = limits(c, PN::CatmullClark_scheme(), 1, close(tolerance));
      EXPECT_LE(difference(l, exact).first, l.report.error) << seed << ' ' << tolerance;
      EXPECT_LE(l.report.error, l.report.tolerance);
    }
}

// --- linear schemes ---

using Exact = CGAL::Exact_predicates_exact_constructions_kernel;

// on a crease (1, 4, 1)/6 of the control points, at corners the point itself, exactly
TEST(Limit_creases, LinearLimitsAreThoseOfTheCubicSpline)
{
  using Exact_mesh = CGAL::Surface_mesh<Exact::Point_3>;
  const Control c = random_net(1);
  Exact_mesh mesh;
  for (const Triple& p : c.points) mesh.add_vertex(Exact::Point_3(p[0], p[1], p[2]));
  for (const Face& f : c.faces) {
    std::vector<CGAL::SM_Vertex_index> corners;
    for (const int v : f) corners.emplace_back(CGAL::SM_Vertex_index::size_type(v));
    mesh.add_face(corners);
  }
  auto sharp = mesh.add_property_map<CGAL::SM_Edge_index, double>("e:sharp", 0).first;
  auto fixed = mesh.add_property_map<CGAL::SM_Vertex_index, bool>("v:fixed", false).first;
  for (const auto& v : c.sharp_vertices)
    fixed[CGAL::SM_Vertex_index(CGAL::SM_Vertex_index::size_type(v.first))] = v.second > 0;
  std::vector<std::vector<int>> ends(c.points.size());
  for (const auto e : mesh.edges()) {
    const auto a = int(mesh.vertex(e, 0)), b = int(mesh.vertex(e, 1));
    const auto it = c.sharp_edges.find(undirected(a, b));
    if (it == c.sharp_edges.end() || !(it->second > 0)) continue;
    sharp[e] = it->second;
    ends[std::size_t(a)].push_back(b);
    ends[std::size_t(b)].push_back(a);
  }
  const Exact_mesh control = mesh;
  PN::subdivide_to_limit(mesh, PN::linear(PN::CatmullClark_scheme()), PN::Limit_options(),
                         np::edge_is_constrained_map(sharp).vertex_is_constrained_map(fixed));
  const auto x = [&](int v) {
    return control.point(CGAL::SM_Vertex_index(CGAL::SM_Vertex_index::size_type(v))).x();
  };
  int creases = 0, corners = 0;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const int v = int(i);
    const Exact::FT limit =
      mesh.point(CGAL::SM_Vertex_index(CGAL::SM_Vertex_index::size_type(i))).x();
    const auto sharp_vertex = c.sharp_vertices.find(v);
    const bool is_fixed = sharp_vertex != c.sharp_vertices.end() && sharp_vertex->second > 0;
    if (ends[i].size() == 2 && !is_fixed) {
      EXPECT_EQ(limit, (x(ends[i][0]) + Exact::FT(4) * x(v) + x(ends[i][1])) / Exact::FT(6));
      ++creases;
    } else if (ends[i].size() > 2 || is_fixed) {
      EXPECT_EQ(limit, x(v));
      ++corners;
    }
  }
  EXPECT_GT(creases, 0);
  EXPECT_GT(corners, 0);
}

// one-sided, at vertices on creases, too, but not where a side has a single face
TEST(Limit_creases, LinearSurfaceNormalsOfFlatSidesAreTheirs)
{
  Part part = capped_cylinder(uneven(7));
  const Control control = part.control();
  Tagged<Mesh> t(control);
  PN::Limit_options options;
  options.surface_normals = true;
  const PN::Limit_report report = to_limit(t, PN::linear(PN::CatmullClark_scheme()), 2, options);
  EXPECT_EQ(report.number_of_stand_ins, 14u);
  for (const auto f : t.mesh.faces()) {
    const Surface& s = *surface_of(part, t, f);
    if (s.kind != Surface::plane) continue;
    for (const auto h : t.mesh.halfedges_around_face(t.mesh.halfedge(f))) {
      const Vector n = vector(get(t.normals, h));
      const bool has_normal = t.mesh.target(h).idx() >= control.points.size();
      EXPECT_LE(double((n - (has_normal ? s.direction : Vector(0, 0, 0))).norm()), 1e-12);
    }
  }
}

// --- calls ---

TEST(Limit_creases, SubdivideAndMoveAreTheSameByTwoCalls)
{
  for (const int seed : {1, 3, 4}) {
    const Control c = random_net(seed);
    for (const bool surface_normals : {false, true}) {
      Tagged<Mesh> one(c), two(c);
      PN::Limit_options options;
      options.surface_normals = surface_normals;
      const auto tangents_of = [](Mesh& mesh) {
        return mesh.add_property_map<Mesh::Halfedge_index, Vector_3>("h:t", Vector_3(0, 0, 0))
          .first;
      };
      const auto tangents = tangents_of(one.mesh), others = tangents_of(two.mesh);
      const auto scheme = [&](const auto& map) {
        return PN::with_crease_tangents(PN::with_border(PN::CatmullClark_scheme(), c.border), map);
      };
      const PN::Limit_report report = to_limit(one, scheme(tangents), 2, options);
      two.subdivide(scheme(others), 2);
      options.rounds_done = 2;
      const PN::Limit_report moved = PN::move_to_limit(two.mesh, scheme(others), options,
                                                       np::edge_is_constrained_map(two.sharp)
                                                         .vertex_is_constrained_map(two.corners)
                                                         .vertex_normal_map(two.normals));
      EXPECT_TRUE(state(one) == state(two)) << seed;
      for (const auto h : one.mesh.halfedges()) EXPECT_EQ(tangents[h], others[h]);
      EXPECT_EQ(report.error, moved.error);
      EXPECT_EQ(report.number_of_stand_ins, moved.number_of_stand_ins);
      EXPECT_EQ(report.number_of_stand_ins > 0, surface_normals);
    }
  }
}

// that of limit_points() is the mean of those of the corners
TEST(Limit_creases, VerticesHaveTheMeanOfTheirWedges)
{
  const Control c = random_net(3);
  Tagged<Mesh> corners(c), points(c);
  using Limit = PN::Limit_point<Kernel>;
  const auto limits = points.mesh.add_property_map<Mesh::Vertex_index, Limit>("v:l").first;
  const PN::CatmullClark_scheme scheme;
  to_limit(corners, scheme, 0, PN::Limit_options());
  PN::limit_points(points.mesh, scheme, limits, PN::Limit_options(),
                   np::edge_is_constrained_map(points.sharp)
                     .vertex_is_constrained_map(points.corners)
                     .vertex_normal_map(points.normals));
  for (const auto v : corners.mesh.vertices()) {
    EXPECT_EQ(limits[v].point, corners.mesh.point(v));
    std::set<Triple> wedges;
    for (const auto h : corners.mesh.halfedges_around_target(corners.mesh.halfedge(v)))
      if (!corners.mesh.is_border(h)) wedges.insert(triple(get(corners.normals, h)));
    Vector mean = Vector::Zero();
    for (const Triple& n : wedges) mean += crease_shapes::vector(n);
    EXPECT_LE(double((vector(limits[v].control_normal) - mean.normalized()).norm()), 1e-14);
  }
}

TEST(Limit_creases, AreTheSameInPolyhedraAndByThreads)
{
  const Control c = random_net(1);
  Tagged<Mesh> s(c);
  Tagged<CGAL::Polyhedron_3<Kernel>> p(c);
  const auto scheme = PN::with_border(PN::CatmullClark_scheme(), c.border);
  to_limit(s, scheme, 2, PN::Limit_options());
  to_limit(p, scheme, 2, PN::Limit_options());
  EXPECT_TRUE(state(s) == state(p));
#ifdef CGAL_LINKED_WITH_TBB
  Tagged<Mesh> parallel(c);
  to_limit<Mesh, std::decay_t<decltype(scheme)>, CGAL::Parallel_tag>(parallel, scheme, 2,
                                                                     PN::Limit_options());
  EXPECT_TRUE(state(s) == state(parallel));
#endif
}

TEST(Limit_creases, OfAnEmptyMeshAreNone)
{
  Tagged<Mesh> none{Control()};
  EXPECT_TRUE(
    to_limit(none, PN::CatmullClark_scheme(), 2, PN::Limit_options()).is_within_tolerance());
  EXPECT_EQ(none.mesh.number_of_vertices(), 0u);
}

// --- what is refused ---

template <class Scheme>
void expect_refusal(const Control& control, const Scheme& scheme, unsigned rounds,
                    const std::string& what)
{
  Tagged<Mesh> t(control);
  const State before = state(t);
  try {
    to_limit(t, scheme, rounds, PN::Limit_options());
    ADD_FAILURE() << "not refused: " << what;
  } catch (const std::invalid_argument& e) {
    EXPECT_NE(std::string(e.what()).find(what), std::string::npos) << e.what();
  }
  EXPECT_TRUE(state(t) == before);
}

TEST(Limit_creases, WhatIsNotSharpForEverIsRefused)
{
  Control c = cube().control();
  c.normals.clear();
  const PN::CatmullClark_scheme scheme;
  c.sharp_edges.begin()->second = 2.5;
  expect_refusal(c, scheme, 0, "is 2.5");
  expect_refusal(c, scheme, 1, "by 2 more rounds");
  expect_refusal(c, scheme, 2, "by 1 more round,");
  expect_refusal(c, scheme, 2, "the edge of half-edge");
  Tagged<Mesh> smooth(c);
  EXPECT_NO_THROW(to_limit(smooth, scheme, 3, PN::Limit_options()));
  c.sharp_edges.begin()->second = infinity;
  c.sharp_vertices[5] = 1.25;
  expect_refusal(c, scheme, 1, "the sharpness of vertex 5 is 1.25");
  Tagged<Mesh> corner(c);
  EXPECT_NO_THROW(to_limit(corner, scheme, 2, PN::Limit_options()));
}

TEST(Limit_creases, AMapThatThrowsLeavesTheMeshAsItWas)
{
  const Control c = random_net(3);
  for (const bool fails_at_points : {true, false})
    for (const int puts : {0, 20, 80, 300}) {
      Tagged<Mesh> t(c);
      const State before = state(t);
      int points_left = fails_at_points ? puts % 97 : 1000, normals_left = puts;
      EXPECT_THROW(
        PN::subdivide_to_limit(
          t.mesh, PN::CatmullClark_scheme(), PN::Limit_options(),
          np::vertex_point_map(Failing_map<decltype(t.points)>{t.points, &points_left})
            .vertex_normal_map(Failing_map<decltype(t.normals)>{t.normals, &normals_left})
            .edge_is_constrained_map(t.sharp)),
        std::runtime_error);
      EXPECT_TRUE(state(t) == before) << puts;
    }
}

} // namespace

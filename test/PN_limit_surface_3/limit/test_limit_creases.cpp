// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Limits of meshes with creases, corners and borders that are creases: what they are.

#include "Creased_limit_cases.h"
#include "Extent.h"
#include "Messages.h"
#include "support/Options.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/PN_subdivision_3/detect_creases.h>
#include <CGAL/PN_subdivision_3/schemes/Transfer_schemes.h>
#include <CGAL/PN_subdivision_3/schemes/Tuned_CatmullClark_scheme.h>
#include <CGAL/Polyhedron_3.h>

namespace {

using namespace creased_limit_cases;

// --- shapes ---

template <class Scheme>
void expect_exact(const Part& part, const Control& control, const Scheme& scheme)
{
  for (const unsigned rounds : {1u, 2u}) {
    Tagged<Mesh> t(control);
    const PN::Limit_report report = to_limit(t, PN::internal::with_border(scheme, part.border),
                                             rounds, test_options::Limit_options());
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
  long_test([](auto) {
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
    PN::subdivide_to_limit(mesh, PN::CatmullClark_scheme(),
                           np::number_of_iterations(2).edge_is_constrained_map(sharp));
    int rims = 0;
    for (const auto e : mesh.edges()) {
      if (!sharp[e]) continue;
      const auto p = mesh.point(mesh.vertex(e, 0));
      EXPECT_NEAR(std::hypot(p.x(), p.y()), 1, 8 * std::numeric_limits<float>::epsilon());
      ++rims;
    }
    EXPECT_EQ(rims, 2 * 7 * 4);
  });
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
    expect_limit_of_rounds(c, PN::CatmullClark_scheme::Tuned(), false);
    expect_limit_of_rounds(triangulated(c), PN::Loop_scheme(), false);
    expect_limit_of_rounds(c, PN::linear(PN::CatmullClark_scheme()), true);
  }
}

// where rounds differ and where curvature is transferred, the whole level is refined
TEST(Limit_creases, AreTheSameWhereTheRulesSettleLate)
{
  const Control c = random_net(3);
  expect_limit_of_rounds(c, PN::CatmullClark_scheme::Tuned(.5, 3), false);
  expect_limit_of_rounds(triangulated(c), PN::Loop_scheme::Transfer(), false);
}

// A box of 1 x 2 x 2 cells: its corners are neighbors in pairs, and a crease ends at one of them, which so keeps the
// other one from being separated in the first round.
TEST(Limit_creases, AreTheSameBesideAnIrregularDart)
{
  Control c = random_creases::box_of_cells({1, 2, 2});
  const auto vertex = [&](const Triple& p) {
    return int(std::find(c.points.begin(), c.points.end(), p) - c.points.begin());
  };
  c.sharp_edges[undirected(vertex({0, 0, 0}), vertex({0, 1, 0}))] = infinity;
  std::mt19937 random(1);
  random_creases::perturb(c, random);
  random_creases::give_normals(c, random);
  expect_limit_of_rounds(c, PN::CatmullClark_scheme::Tuned(), false);
}

// Roundness of its own at every vertex, or the same at all: a crease is then between its curve and the linear one.
template <class Scheme>
void expect_round_limit_of_rounds(const Control& control, const Scheme& scheme,
                                  double any_roundness)
{
  std::vector<std::vector<Vector>> of_rounds;
  for (const unsigned rounds : {0u, 1u, 3u}) {
    Tagged<Mesh> t(control);
    unsigned i = 0;
    for (const auto v : t.mesh.vertices())
      put(t.roundness, v, any_roundness < 0 ? (7 * i++ % 9) / 8. : any_roundness);
    to_round_limit(t, PN::internal::with_border(scheme, control.border), rounds, close(1e-11));
    of_rounds.emplace_back();
    for (std::size_t v = 0; v < control.points.size(); ++v)
      of_rounds.back().push_back(vector(t.mesh.point(Mesh::Vertex_index(Mesh::size_type(v)))));
  }
  for (std::size_t v = 0; v < control.points.size(); ++v)
    for (const std::size_t k : {0u, 1u})
      EXPECT_LE(double((of_rounds[k][v] - of_rounds[2][v]).norm()), 1e-10) << "vertex " << v;
}

TEST(Limit_creases, AreTheSameFromEveryLevelOfAnyRoundness)
{
  for (const double w : {-1., 0., .5})
    for (int seed = 1; seed <= 6; ++seed) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", roundness " + std::to_string(w));
      const Control c = random_net(seed);
      expect_round_limit_of_rounds(c, PN::CatmullClark_scheme(), w);
      expect_round_limit_of_rounds(triangulated(c), PN::Loop_scheme(), w);
    }
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
  PN::subdivide_to_limit(mesh, PN::linear(PN::CatmullClark_scheme()),
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
  test_options::Limit_options options;
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
      test_options::Limit_options options;
      options.surface_normals = surface_normals;
      const auto tangents_of = [](Mesh& mesh) {
        return mesh.add_property_map<Mesh::Halfedge_index, Vector_3>("h:t", Vector_3(0, 0, 0))
          .first;
      };
      const auto tangents = tangents_of(one.mesh), others = tangents_of(two.mesh);
      const auto scheme = [&](const auto& map) {
        return PN::internal::with_crease_tangents(
          PN::internal::with_border(PN::CatmullClark_scheme(), c.border), map);
      };
      const PN::Limit_report report = to_limit(one, scheme(tangents), 2, options);
      two.subdivide(scheme(others), 2);
      options.rounds_done = 2;
      const PN::Limit_report moved = PN::subdivide_to_limit(
        two.mesh, scheme(others),
        PN::parameters::join(CGAL::parameters::number_of_iterations(0), options.pack(),
                             np::edge_is_constrained_map(two.sharp)
                               .vertex_is_constrained_map(two.corners)
                               .vertex_normal_map(two.normals)));
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
  to_limit(corners, scheme, 0, test_options::Limit_options());
  PN::limit_points(points.mesh, scheme, limits,
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
  const auto scheme = PN::internal::with_border(PN::CatmullClark_scheme(), c.border);
  to_limit(s, scheme, 2, test_options::Limit_options());
  to_limit(p, scheme, 2, test_options::Limit_options());
  EXPECT_TRUE(state(s) == state(p));
#ifdef CGAL_LINKED_WITH_TBB
  Tagged<Mesh> parallel(c);
  to_limit<Mesh, std::decay_t<decltype(scheme)>, CGAL::Parallel_tag>(parallel, scheme, 2,
                                                                     test_options::Limit_options());
  EXPECT_TRUE(state(s) == state(parallel));
#endif
}

TEST(Limit_creases, OfAnEmptyMeshAreNone)
{
  Tagged<Mesh> none{Control()};
  EXPECT_TRUE(to_limit(none, PN::CatmullClark_scheme(), 2, test_options::Limit_options())
                .is_within_tolerance());
  EXPECT_EQ(none.mesh.number_of_vertices(), 0u);
}

// --- what is refused ---

template <class Scheme>
void expect_refusal(const Control& control, const Scheme& scheme, unsigned rounds,
                    const std::string& what)
{
  Tagged<Mesh> t(control);
  const State before = state(t);
  messages::expect_refused([&] { to_limit(t, scheme, rounds, test_options::Limit_options()); },
                           {what});
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
  EXPECT_NO_THROW(to_limit(smooth, scheme, 3, test_options::Limit_options()));
  c.sharp_edges.begin()->second = infinity;
  c.sharp_vertices[5] = 1.25;
  expect_refusal(c, scheme, 1, "the sharpness of vertex 5 is 1.25");
  Tagged<Mesh> corner(c);
  EXPECT_NO_THROW(to_limit(corner, scheme, 2, test_options::Limit_options()));
}

} // namespace

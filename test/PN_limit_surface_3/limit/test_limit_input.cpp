// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Limits of any mesh type and number type, faces of Doo-Sabin, huge valences, bad input, and what is
// left behind where something fails.

#include "Failing_map.h"
#include "Limit_cases.h"
#include "Mesh_cases.h"
#include "Messages.h"
#include "Schemes.h"
#include "support/Exact_rational.h"
#include "support/Options.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/PN_limit_surface_3/subdivide_to_limit.h>
#include <CGAL/PN_subdivision_3/estimate_control_normals.h>
#include <CGAL/PN_subdivision_3/schemes/Kobbelt_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Tuned_CatmullClark_scheme.h>
#include <CGAL/Polyhedron_3.h>

namespace {

using namespace limit_cases;
using test_meshes::Cells;
using test_meshes::Control_mesh;
namespace params = CGAL::parameters;

// --- mesh types ---

TEST(Limit_input, PolyhedronGivesWhatSurfaceMeshGives)
{
  using Polyhedron = CGAL::Polyhedron_3<Kernel>;
  const mesh_cases::Soup soup = mesh_cases::mixed_with_border();
  Polyhedron p;
  mesh_cases::build(soup, p);
  Surface_mesh s;
  mesh_cases::build(soup, s);
  const auto limits_in = [&](auto& mesh) {
    auto normals = get(CGAL::dynamic_vertex_property_t<Kernel::Vector_3>(), mesh);
    mesh_cases::put_normals(mesh_cases::normals(soup), mesh, normals);
    auto limits = get(CGAL::dynamic_vertex_property_t<Limit>(), mesh);
    test_options::Limit_options options;
    options.surface_normals = true;
    PN::limit_points(mesh, PN::CatmullClark_scheme(), limits,
                     PN::parameters::join(options.pack(), params::vertex_normal_map(normals)));
    std::vector<Limit> result;
    for (auto v : vertices(mesh)) result.push_back(get(limits, v));
    return result;
  };
  const std::vector<Limit> a = limits_in(p), b = limits_in(s);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t v = 0; v < a.size(); ++v) {
    EXPECT_LE(CGAL::squared_distance(a[v].point, b[v].point), 1e-29);
    EXPECT_LE((a[v].surface_normal - b[v].surface_normal).squared_length(), 1e-24);
  }
}

TEST(Limit_input, RemovedElementsAndIsolatedVerticesTakeNoPart)
{
  Control_mesh control = test_meshes::all()[0];
  Surface_mesh mesh = to_surface_mesh(control);
  const Limits whole = limits(mesh, PN::Loop_scheme(), close(1e-12));
  const auto lone = mesh.add_vertex(Kernel::Point_3(9, 8, 7));
  normal_map(mesh)[lone] = Kernel::Vector_3(0, 0, 1);
  mesh.remove_vertex(mesh.add_vertex(Kernel::Point_3(1, 1, 1)));
  const auto last = mesh.add_vertex(Kernel::Point_3(5, 5, 5));
  ASSERT_TRUE(mesh.has_garbage());
  test_options::Limit_options options = close(1e-12);
  options.surface_normals = true;
  const auto map = mesh.add_property_map<Surface_mesh::Vertex_index, Limit>("v:l").first;
  const PN::Limit_report report = PN::limit_points(
    mesh, PN::Loop_scheme(), map,
    PN::parameters::join(options.pack(), params::vertex_normal_map(normal_map(mesh))));
  EXPECT_EQ(map[lone].point, mesh.point(lone));
  EXPECT_EQ(map[lone].control_normal, Kernel::Vector_3(0, 0, 1));
  EXPECT_EQ(map[lone].surface_normal, Kernel::Vector_3(0, 0, 1));
  EXPECT_FALSE(map[lone].has_surface_normal);
  EXPECT_EQ(map[last].point, Kernel::Point_3(5, 5, 5));
  EXPECT_EQ(report.number_of_stand_ins, 2u);
  for (std::size_t v = 0; v < whole.at.size(); ++v) {
    const auto d = Surface_mesh::Vertex_index(Surface_mesh::size_type(v));
    EXPECT_LE(CGAL::squared_distance(map[d].point, whole.at[v].point), 1e-22);
  }
}

TEST(Limit_input, AnEmptyMeshHasNoLimits)
{
  Surface_mesh mesh;
  const Limits none = limits(mesh, PN::CatmullClark_scheme(), test_options::Limit_options());
  EXPECT_TRUE(none.at.empty());
  EXPECT_TRUE(none.report.is_within_tolerance());
}

// without a map of normals they are estimated as subdivide() does
TEST(Limit_input, NormalsAreEstimatedWhereNoneAreGiven)
{
  Surface_mesh mesh = to_surface_mesh(test_meshes::all()[4]);
  PN::estimate_control_normals(mesh, normal_map(mesh));
  const Limits given = limits(mesh, PN::Loop_scheme(), test_options::Limit_options());
  const auto map = mesh.add_property_map<Surface_mesh::Vertex_index, Limit>("v:l").first;
  PN::limit_points(mesh, PN::Loop_scheme(), map, PN::parameters::roundness(1));
  for (auto v : mesh.vertices()) EXPECT_EQ(map[v].point, given.at[v].point);
}

// --- moving a mesh ---

TEST(Move_to_limit, WritesPointsAndTheNormalsAskedFor)
{
  for (const bool surface_normals : {false, true}) {
    Surface_mesh mesh = to_surface_mesh(test_meshes::all()[0]);
    test_options::Limit_options options;
    options.surface_normals = surface_normals;
    const Limits all = limits(mesh, PN::Loop_scheme(), options);
    const PN::Limit_report report = PN::subdivide_to_limit(
      mesh, PN::Loop_scheme(),
      PN::parameters::join(CGAL::parameters::number_of_iterations(0), options.pack(),
                           params::vertex_normal_map(normal_map(mesh))));
    EXPECT_EQ(report.error, all.report.error);
    for (auto v : mesh.vertices()) {
      EXPECT_EQ(mesh.point(v), all.at[v].point);
      EXPECT_EQ(normal_map(mesh)[v],
                surface_normals ? all.at[v].surface_normal : all.at[v].control_normal);
    }
  }
}

TEST(Move_to_limit, OfALinearSchemeWritesNormalsOnlyWhenAskedFor)
{
  Surface_mesh mesh = to_surface_mesh(test_meshes::all()[0]);
  const auto before = normal_map(mesh)[Surface_mesh::Vertex_index(0)];
  PN::subdivide_to_limit(mesh, PN::linear(PN::Loop_scheme()),
                         params::vertex_normal_map(normal_map(mesh)).number_of_iterations(0));
  EXPECT_EQ(normal_map(mesh)[Surface_mesh::Vertex_index(0)], before);
  test_options::Limit_options options;
  options.surface_normals = true;
  PN::subdivide_to_limit(mesh, PN::linear(PN::Loop_scheme()),
                         PN::parameters::join(CGAL::parameters::number_of_iterations(0),
                                              options.pack(),
                                              params::vertex_normal_map(normal_map(mesh))));
  EXPECT_NE(normal_map(mesh)[Surface_mesh::Vertex_index(0)], before);
}

TEST(Move_to_limit, PutsBackWhatItHasWrittenIfAMapThrows)
{
  Surface_mesh mesh = to_surface_mesh(test_meshes::all()[0]);
  const Surface_mesh old = mesh;
  for (const int puts : {0, 3, 6}) {
    failing_maps::Calls_left left(puts);
    const auto points = failing(get(CGAL::vertex_point, mesh), left);
    EXPECT_THROW(PN::subdivide_to_limit(mesh, PN::Loop_scheme(),
                                        params::vertex_point_map(points)
                                          .vertex_normal_map(normal_map(mesh))
                                          .number_of_iterations(0)),
                 failing_maps::User_failure);
    Surface_mesh expected = old;
    EXPECT_TRUE(is_identical(mesh, expected));
  }
}

// --- bad input ---

TEST(Limit_input, BadInputIsRefusedByName)
{
  const auto refuses = [](Surface_mesh& mesh, const auto& scheme,
                          const test_options::Limit_options& options, const std::string& what) {
    messages::expect_refused([&] { limits(mesh, scheme, options); }, {what});
  };
  Surface_mesh quads = to_surface_mesh(test_meshes::star(5, 2, Cells::quads));
  refuses(quads, PN::Loop_scheme(), test_options::Limit_options(), "face 0 has 4 corners");
  for (const double wrong : {-1., std::nan("")}) {
    test_options::Limit_options options;
    options.tolerance = wrong;
    refuses(quads, PN::CatmullClark_scheme(), options, "tolerance");
    options = test_options::Limit_options();
    options.normal_tolerance = wrong;
    refuses(quads, PN::CatmullClark_scheme(), options, "tolerance");
  }
  quads.point(Surface_mesh::Vertex_index(3)) = Kernel::Point_3(0, HUGE_VAL, 0);
  refuses(quads, PN::CatmullClark_scheme(), test_options::Limit_options(), "the point of vertex 3");
  quads.point(Surface_mesh::Vertex_index(3)) = Kernel::Point_3(0, 0, 0);
  normal_map(quads)[Surface_mesh::Vertex_index(4)] = Kernel::Vector_3(std::nan(""), 0, 0);
  refuses(quads, PN::CatmullClark_scheme(), test_options::Limit_options(),
          "the normal of vertex 4");
}

TEST(Limit_input, BordersThatAreCreasesNeedRulesForThem)
{
  Surface_mesh quads = to_surface_mesh(test_meshes::star(5, 2, Cells::quads));
  test_meshes::Control_mesh torus = test_meshes::grid(5, 6, true, true, Cells::quads);
  test_meshes::set_uneven_normals(torus, 1);
  const Surface_mesh closed = to_surface_mesh(torus);
  const PN::CatmullClark_scheme scheme;
  const auto points = [](const Surface_mesh& mesh) {
    return std::vector<Kernel::Point_3>(mesh.points().begin(), mesh.points().end());
  };
  const auto before = points(quads);
  messages::expect_refused(
    [&] {
      PN::subdivide_to_limit(quads,
                             PN::internal::with_border(PN::Kobbelt_scheme(), PN::Border::curve),
                             CGAL::parameters::number_of_iterations(0));
    },
    {"is sharp, but the scheme kobbelt has no rules"});
  EXPECT_EQ(points(quads), before);
  // without a border nothing changes
  Surface_mesh same = closed, other = closed;
  PN::subdivide_to_limit(same, scheme, CGAL::parameters::number_of_iterations(0));
  PN::subdivide_to_limit(other, PN::internal::with_border(scheme, PN::Border::curve),
                         CGAL::parameters::number_of_iterations(0));
  EXPECT_EQ(points(same), points(other));
  Surface_mesh plain = quads;
  PN::subdivide_to_limit(plain, scheme, CGAL::parameters::number_of_iterations(0));
  PN::subdivide_to_limit(quads, PN::internal::with_border(scheme, PN::Border::surface),
                         CGAL::parameters::number_of_iterations(0));
  EXPECT_EQ(points(quads), points(plain));
}

// --- valences ---

// Linear cost for plain schemes, quadratic for modified ones as in their rounds; points on a sphere.
TEST(Limit_input, HugeValencesAreNoHarm)
{
  const int n = 2000;
  Control_mesh control = test_meshes::bipyramid(n);
  for (std::size_t i = 0; i < control.points.size(); ++i)
    control.points[i] = test_meshes::unit(control.points[i]);
  control.normals = control.points;
  Surface_mesh mesh = to_surface_mesh(control);
  const Limits all = limits(mesh, PN::Loop_scheme(), close(1e-12));
  for (const int pole : {n, n + 1}) {
    const Limit& l = all.at[std::size_t(pole)];
    EXPECT_NEAR((l.point - CGAL::ORIGIN).squared_length(), 1, 1e-14);
    EXPECT_TRUE(l.has_surface_normal);
    EXPECT_LE((l.surface_normal - l.control_normal).squared_length(), 1e-18);
  }
}

// Two faces at an interior vertex: a point and a control normal, no tangent plane.
TEST(Limit_input, AnInteriorVertexOfValence2HasALimitPoint)
{
  Control_mesh control{
    "two quads back to back",
    {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -2, 0}, {0, 2, 0.5}, {2, 0, 0}, {-2, 0, 0.2}},
    {{0, 1, 2, 3}, {0, 3, 4, 1}, {1, 6, 5, 2}, {2, 5, 7, 3}, {3, 7, 4}, {4, 6, 1}}};
  test_meshes::set_uneven_normals(control, 3);
  Surface_mesh mesh = to_surface_mesh(control);
  for (const Limits& all : {limits(mesh, PN::CatmullClark_scheme(), close(1e-10)),
                            limits(mesh, PN::CatmullClark_scheme::Tuned(), close(1e-10))}) {
    EXPECT_TRUE(all.report.is_within_tolerance());
    EXPECT_FALSE(all.at[0].has_surface_normal);
    EXPECT_EQ(all.at[0].surface_normal, all.at[0].control_normal);
    for (const Limit& l : all.at) EXPECT_TRUE(is_finite(l));
  }
}

// --- the faces of Doo-Sabin ---

TEST(Face_limit_points, AreTheCentroidsOfTheLinearScheme)
{
  for (const Control_mesh& control : {test_meshes::house(5), test_meshes::single_polygon(7)}) {
    Control_mesh c = control;
    test_meshes::set_uneven_normals(c, 2);
    Surface_mesh mesh = to_surface_mesh(c);
    const auto map = mesh.add_property_map<Surface_mesh::Face_index, Limit>("f:l").first;
    test_options::Limit_options options;
    options.surface_normals = true;
    const auto scheme = PN::linear(PN::DooSabin_scheme());
    EXPECT_EQ(PN::limit_points(mesh, scheme, map, options.pack()).error, 0);
    for (auto f : mesh.faces()) {
      reference::Vector sum = reference::Vector::Zero();
      for (auto v : mesh.vertices_around_face(mesh.halfedge(f))) sum += to_vector(mesh.point(v));
      sum /= reference::Real(mesh.degree(f));
      EXPECT_LE(double((to_vector(map[f].point) - sum).norm()), 1e-14);
      EXPECT_TRUE(map[f].has_surface_normal);
    }
  }
}

// A face keeps its limit while it shrinks, and its corners come to lie in its tangent plane.
TEST(Face_limit_points, AreTheSameAtEveryLevel)
{
  Control_mesh control = test_meshes::house(5);
  test_meshes::set_uneven_normals(control, 2);
  Surface_mesh mesh = to_surface_mesh(control);
  const auto limits_of_faces = [&](const test_options::Limit_options& options) {
    const auto map = mesh.add_property_map<Surface_mesh::Face_index, Limit>("f:l").first;
    const PN::Limit_report report = PN::limit_points(
      mesh, PN::DooSabin_scheme(), map,
      PN::parameters::join(options.pack(), params::vertex_normal_map(normal_map(mesh))));
    EXPECT_TRUE(report.is_within_tolerance());
    std::vector<Limit> result;
    for (std::size_t f = 0; f < control.faces.size(); ++f)
      result.push_back(map[Surface_mesh::Face_index(Surface_mesh::size_type(f))]);
    mesh.remove_property_map(const_cast<std::decay_t<decltype(map)>&>(map));
    return result;
  };
  const std::vector<Limit> base = limits_of_faces(close(1e-12, 1e-7));
  refine<DooSabin_description>(mesh, 4);
  const std::vector<Limit> fine = limits_of_faces(close(1e-12, 1e-7));
  for (std::size_t f = 0; f < base.size(); ++f) {
    EXPECT_LE(CGAL::squared_distance(base[f].point, fine[f].point), 1e-22) << f;
    EXPECT_LE((base[f].surface_normal - fine[f].surface_normal).squared_length(), 1e-12) << f;
    EXPECT_LE((base[f].control_normal - fine[f].control_normal).squared_length(), 1e-26) << f;
    // the polygon after four rounds
    const Surface_mesh::Face_index face(static_cast<Surface_mesh::size_type>(f));
    Kernel::Vector_3 area = CGAL::NULL_VECTOR;
    for (auto h : mesh.halfedges_around_face(mesh.halfedge(face)))
      area = area + CGAL::cross_product(mesh.point(mesh.source(h)) - base[f].point,
                                        mesh.point(mesh.target(h)) - base[f].point);
    EXPECT_GT(area * fine[f].surface_normal, 0.99 * std::sqrt(area.squared_length())) << f;
  }
}

TEST(Face_limit_points, StayOnASphere)
{
  Control_mesh control = test_meshes::house(7);
  for (auto& p : control.points) p = test_meshes::unit(p);
  control.normals = control.points;
  Surface_mesh mesh = to_surface_mesh(control);
  const auto map = mesh.add_property_map<Surface_mesh::Face_index, Limit>("f:l").first;
  test_options::Limit_options options;
  options.surface_normals = true;
  PN::limit_points(
    mesh, PN::DooSabin_scheme(), map,
    PN::parameters::join(options.pack(), params::vertex_normal_map(normal_map(mesh))));
  for (auto f : mesh.faces()) {
    EXPECT_NEAR((map[f].point - CGAL::ORIGIN).squared_length(), 1, 4e-15);
    EXPECT_LE(CGAL::squared_distance(CGAL::ORIGIN + map[f].surface_normal, map[f].point), 1e-20);
  }
}

// --- number types ---

template <class K>
struct Mesh_of
{
  using FT = typename K::FT;
  using Mesh = CGAL::Surface_mesh<typename K::Point_3>;
  using Vertex = CGAL::SM_Vertex_index;

  explicit Mesh_of(const Control_mesh& control)
  {
    const auto fraction = [](double x) { return FT(int(std::lround(x * 64))) / FT(64); };
    for (std::size_t i = 0; i < control.points.size(); ++i) {
      const auto &p = control.points[i], &n = control.normals[i];
      const auto v = mesh.add_vertex({fraction(p[0]), fraction(p[1]), fraction(p[2])});
      normals[v] = typename K::Vector_3(FT(n[0]), FT(n[1]), FT(n[2]));
    }
    for (const reference::Face& f : control.faces) {
      std::vector<Vertex> corners;
      for (int v : f) corners.emplace_back(Vertex::size_type(v));
      mesh.add_face(corners);
    }
  }

  template <class Scheme>
  PN::Limit_report limits(const Scheme& scheme, const test_options::Limit_options& options)
  {
    return PN::limit_points(
      mesh, scheme, limit,
      PN::parameters::join(options.pack(), params::vertex_normal_map(normals)));
  }

  Mesh mesh;
  typename Mesh::template Property_map<Vertex, typename K::Vector_3> normals =
    mesh.template add_property_map<Vertex, typename K::Vector_3>("v:n").first;
  typename Mesh::template Property_map<Vertex, PN::Limit_point<K>> limit =
    mesh.template add_property_map<Vertex, PN::Limit_point<K>>("v:l").first;
};

using Exact = CGAL::Exact_predicates_exact_constructions_kernel;

// rational masks at all valences: a linear limit point is a sum of fractions
TEST(Limit_numbers, ExactLinearLimitsAreExact)
{
  for (const int n : {3, 5, 7}) {
    Mesh_of<Exact> m(test_meshes::star(n, 2, Cells::quads));
    m.limits(PN::linear(PN::CatmullClark_scheme()), test_options::Limit_options());
    const auto v0 = CGAL::SM_Vertex_index(0);
    Exact::FT sum = Exact::FT(n) * m.mesh.point(v0).x() / Exact::FT(n + 5);
    for (auto h : m.mesh.halfedges_around_target(m.mesh.halfedge(v0))) {
      const auto weight = Exact::FT(n) * Exact::FT(n + 5);
      sum += Exact::FT(4) * m.mesh.point(m.mesh.source(h)).x() / weight;
      sum += m.mesh.point(m.mesh.target(m.mesh.next(m.mesh.next(h)))).x() / weight;
    }
    EXPECT_EQ(m.limit[v0].point.x(), sum) << n;
  }
}

// The weights sum to 1 exactly, irrational or not: the limit of equal points is the point.
TEST(Limit_numbers, ExactMasksSumToOne)
{
  for (const int n : {3, 5, 7, 8}) {
    Control_mesh control = test_meshes::star(n, 2, Cells::triangles);
    Mesh_of<Exact> m(control);
    for (auto v : m.mesh.vertices())
      m.mesh.point(v) = Exact::Point_3(Exact::FT(1) / 3, Exact::FT(2) / 7, 5);
    m.limits(PN::linear(PN::Loop_scheme()), test_options::Limit_options());
    for (auto v : m.mesh.vertices()) EXPECT_EQ(m.limit[v].point, m.mesh.point(v)) << n;
  }
}

TEST(Limit_numbers, ExactPointNormalLimitsAreCloseToThoseOfDouble)
{
  Control_mesh control = test_meshes::star(5, 2, Cells::quads);
  test_meshes::set_uneven_normals(control, 1);
  test_options::Limit_options once;
  once.max_depth = 1;
  once.surface_normals = true;
  Mesh_of<Exact> exact(control);
  Mesh_of<Kernel> rounded(control);
  exact.limits(PN::CatmullClark_scheme(), once);
  rounded.limits(PN::CatmullClark_scheme(), once);
  for (auto v : exact.mesh.vertices()) {
    const auto& a = exact.limit[v];
    const auto& b = rounded.limit[v];
    EXPECT_NEAR(CGAL::to_double(a.point.x()), b.point.x(), 1e-13);
    EXPECT_NEAR(CGAL::to_double(a.surface_normal.y()), b.surface_normal.y(), 1e-12);
    EXPECT_NEAR(a.error, b.error, 1e-12);
  }
}

TEST(Limit_numbers, IntervalsContainTheLinearLimitOfALevel)
{
  using Interval_kernel = CGAL::Simple_cartesian<CGAL::Interval_nt<false>>;
  CGAL::Protect_FPU_rounding<true> rounding;
  const Control_mesh control = test_meshes::star(4, 2, Cells::quads);
  const test_options::Limit_options options;
  Mesh_of<Exact> exact(control);
  exact.limits(PN::linear(PN::CatmullClark_scheme()), options);
  Mesh_of<Interval_kernel> linear(control);
  linear.limits(PN::linear(PN::CatmullClark_scheme()), options);
  for (auto v : linear.mesh.vertices()) {
    EXPECT_LE(linear.limit[v].point.x().sup() - linear.limit[v].point.x().inf(), 1e-14);
    const auto x = CGAL::to_interval(exact.limit[v].point.x());
    EXPECT_LE(linear.limit[v].point.x().inf(), x.second);
    EXPECT_GE(linear.limit[v].point.x().sup(), x.first);
  }
}

// --- schemes whose rounds differ ---

// The limits at all vertices of a level, as the mesh after each of some rounds tells of them.
template <class Scheme>
void expect_limits_that_continue_the_call(const Control_mesh& control, const Scheme& scheme,
                                          double tolerance)
{
  std::vector<Limits> from;
  for (unsigned rounds = 0; rounds <= 3; ++rounds) {
    Surface_mesh mesh = to_surface_mesh(control);
    PN::subdivide(
      mesh, scheme,
      CGAL::parameters::number_of_iterations(rounds).vertex_normal_map(normal_map(mesh)));
    test_options::Limit_options options = close(1e-12);
    options.rounds_done = rounds;
    from.push_back(limits(mesh, scheme, options));
    for (unsigned before = 0; before < rounds; ++before)
      for (std::size_t v = 0; v < from[before].at.size(); ++v)
        EXPECT_LE(
          std::sqrt(CGAL::squared_distance(from[before].at[v].point, from[rounds].at[v].point)),
          tolerance)
          << "vertex " << v << " of level " << before << ", from level " << rounds;
  }
}

// The border is refined in even rounds only: with the number of rounds done the limits of a mesh in the
// middle of a call are those of its beginning.
TEST(Limit_rounds, OfSqrt3ContinueTheCall)
{
  Control_mesh control = test_meshes::grid(4, 3, false, false, Cells::triangles);
  test_meshes::set_uneven_normals(control, 5);
  expect_limits_that_continue_the_call(control, PN::Sqrt3_scheme(), 1e-10);
}

TEST(Limit_rounds, OfModifiedSchemesContinueTheCall)
{
  Control_mesh quads = test_meshes::in_quads(test_meshes::bipyramid(5)),
               triangles = test_meshes::bipyramid(7);
  test_meshes::set_uneven_normals(quads, 5);
  test_meshes::set_uneven_normals(triangles, 6);
  for (const unsigned first : {1u, 2u, 3u, 4u}) {
    expect_limits_that_continue_the_call(quads, PN::CatmullClark_scheme::Tuned(.5, first), 1e-10);
    expect_limits_that_continue_the_call(
      triangles, PN::Loop_scheme::Tuned(.5, first, PN::Tuned_valences::diverging), 1e-10);
  }
}

TEST(Limit_rounds, AFirstRoundFarAwayIsRefused)
{
  Control_mesh control = test_meshes::bipyramid(7);
  test_meshes::set_uneven_normals(control, 1);
  Surface_mesh mesh = to_surface_mesh(control);
  messages::expect_refused([&] { limits(mesh, PN::Loop_scheme::Tuned(.5, 9), close(1e-3)); },
                           {"first round"});
  test_options::Limit_options options = close(1e-3);
  options.rounds_done = 8;
  EXPECT_NO_THROW(limits(mesh, PN::Loop_scheme::Tuned(.5, 9), options));
}

} // namespace

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Tessellations to a tolerance: against surfaces that are known, and against CGAL's own subdivision.

#include "Extent.h"
#include "Messages.h"
#include "Named_shapes.h"
#include "Scheme_named.h"
#include "Scheme_runs.h"
#include "Tessellation_cases.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/PN_limit_surface_3/subdivide_to_limit.h>
#include <CGAL/PN_limit_surface_3/tessellate.h>
#include <CGAL/PN_subdivision_3/schemes/DooSabin_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Sqrt3_scheme.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/copy_face_graph.h>

namespace {

namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;
using test_meshes::Cells;
using test_meshes::Control_mesh;
using Vector = Kernel::Vector_3;
using namespace tessellation_cases;
using named_shapes::on_unit_sphere;

double distance_from_unit_sphere(const std::vector<Triangle>& all)
{
  double largest = 0;
  for_each_sample(all, [&](const Point& p) {
    largest = (std::max)(largest, std::abs(1 - std::sqrt((p - CGAL::ORIGIN).squared_length())));
  });
  return largest;
}

struct Tessellated
{
  Surface_mesh mesh;
  Normal_map normals = normal_map(mesh);
  PN::Tessellation_result result;
};

template <class Scheme>
std::unique_ptr<Tessellated> tessellated(Surface_mesh control, const Scheme& scheme, double eps)
{
  auto t = std::make_unique<Tessellated>();
  t->result =
    PN::tessellate(control, scheme, eps, t->mesh, params::vertex_normal_map(normal_map(control)),
                   params::vertex_normal_map(t->normals));
  EXPECT_EQ(t->result.number_of_vertices, t->mesh.number_of_vertices());
  EXPECT_EQ(t->result.number_of_triangles, t->mesh.number_of_faces());
  return t;
}

// \name Spheres

// A corner of a face is at the target of its half-edge, so that the normal is that of this vertex of the sphere.
TEST(Tessellate, CornersHaveTheNormalsOfTheirVertices)
{
  Surface_mesh control = to_surface_mesh(on_unit_sphere(named_shapes::cube())), out;
  auto normals = out.add_property_map<Surface_mesh::Halfedge_index, Vector>("h:normal").first;
  PN::tessellate(control, PN::CatmullClark_scheme(), 0.1, out,
                 params::vertex_normal_map(normal_map(control)),
                 params::vertex_normal_map(normals));
  EXPECT_GT(out.number_of_faces(), 12u);
  for (auto h : out.halfedges()) {
    const Vector p = out.point(out.target(h)) - CGAL::ORIGIN;
    EXPECT_LE((normals[h] - p).squared_length(), 1e-8);
  }
}

template <class Scheme>
void expect_sphere(const Control_mesh& shape, const Scheme& scheme)
{
  const Surface_mesh control = to_surface_mesh(on_unit_sphere(shape));
  for (const double eps : {0.1, 0.01}) {
    const auto t = tessellated(control, scheme, eps);
    const double error = distance_from_unit_sphere(triangles(t->mesh));
    EXPECT_TRUE(t->result.reached);
    EXPECT_LE(t->result.bound, eps);
    EXPECT_LE(error, t->result.bound + 1e-9);
    EXPECT_GE(error, 0.15 * t->result.bound);
    expect_conforming(t->mesh, control);
    for (auto v : t->mesh.vertices()) {
      const Vector p = t->mesh.point(v) - CGAL::ORIGIN;
      EXPECT_NEAR(p.squared_length(), 1, 1e-8);
      EXPECT_LE((t->normals[v] - p).squared_length(), 1e-8);
    }
  }
}

TEST(Tessellate, SpheresOfCatmullClark)
{
  expect_sphere(named_shapes::cube(), PN::CatmullClark_scheme());
  expect_sphere(named_shapes::prism(5), PN::CatmullClark_scheme()); // pentagons
}
TEST(Tessellate, SpheresOfLoop)
{
  expect_sphere(named_shapes::tetrahedron(), PN::Loop_scheme());
  expect_sphere(test_meshes::bipyramid(7), PN::Loop_scheme());
}

TEST(Tessellate, ASphereHasNoMoreTrianglesThanUniformOnes)
{
  const Surface_mesh control = to_surface_mesh(on_unit_sphere(named_shapes::cube()));
  std::vector<std::pair<double, std::size_t>> uniform; // errors and numbers
  for (unsigned rounds = 2; rounds <= 4; ++rounds) {
    Surface_mesh mesh = control;
    PN::subdivide_to_limit(
      mesh, PN::CatmullClark_scheme(),
      params::number_of_iterations(rounds).vertex_normal_map(normal_map(mesh)));
    double error = 0;
    for (auto f : mesh.faces()) {
      Vector sum = CGAL::NULL_VECTOR;
      const auto h = mesh.halfedge(f);
      sum = (mesh.point(mesh.source(h)) - CGAL::ORIGIN) +
            (mesh.point(mesh.target(mesh.next(h))) - CGAL::ORIGIN);
      error = (std::max)(error, 1 - std::sqrt((sum / 2).squared_length()));
    }
    uniform.emplace_back(error, 2 * mesh.number_of_faces());
  }
  for (const auto& [error, number] : uniform) {
    const auto t = tessellated(control, PN::CatmullClark_scheme(), 1.11 * error);
    EXPECT_LE(t->mesh.number_of_faces(), number);
  }
}

TEST(Tessellate, AllSchemesThatSplitEdges)
{
  for (const char* name :
       {"catmull-clark", "modified-catmull-clark", "ct-catmull-clark", "kobbelt"})
    expect_sphere(named_shapes::cube(), scheme_named(name));
  for (const char* name : {"loop", "modified-loop", "ct-loop", "butterfly"})
    expect_sphere(test_meshes::bipyramid(5), scheme_named(name));
}

// \name Creases and borders

TEST(Tessellate, ACubeHasTwelveTriangles)
{
  Surface_mesh control = to_surface_mesh(
    named_shapes::with_normals(named_shapes::cube(), named_shapes::Normals::missing));
  const auto sharp =
    control.add_property_map<Surface_mesh::Edge_index, bool>("e:sharp", true).first;
  Surface_mesh out;
  const auto normals = out.add_property_map<Surface_mesh::Halfedge_index, Vector>("h:normal").first;
  const auto result =
    PN::tessellate(control, PN::CatmullClark_scheme(), 1e-6, out,
                   params::edge_is_constrained_map(sharp), params::vertex_normal_map(normals));
  EXPECT_EQ(result.number_of_triangles, 12U);
  EXPECT_EQ(result.bound, 0);
  EXPECT_EQ(result.depth, 0U);
  expect_conforming(out, control);
  ASSERT_EQ(out.number_of_vertices(), 8U);
  for (auto v : out.vertices()) EXPECT_EQ(out.point(v), control.point(v));
  for (auto f : out.faces()) {
    const auto h = out.halfedge(f);
    const Vector area =
      CGAL::cross_product(out.point(out.target(h)) - out.point(out.source(h)),
                          out.point(out.target(out.next(h))) - out.point(out.target(h)));
    for (auto g : out.halfedges_around_face(h))
      EXPECT_LE(CGAL::cross_product(normals[g], area).squared_length(), 1e-20);
  }
}

TEST(Tessellate, ACornerOnAStraightSideGetsADiagonal)
{
  Control_mesh quad{"quadrilateral", {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 2, 0}}, {{0, 1, 2, 3}}};
  quad.normals.assign(4, {0, 0, 1});
  Surface_mesh out, control = to_surface_mesh(quad);
  PN::tessellate(control, PN::internal::with_border(PN::CatmullClark_scheme(), PN::Border::fixed),
                 0.1, out, params::vertex_normal_map(normal_map(control)));
  EXPECT_EQ(out.number_of_faces(), 2U);
  expect_conforming(out, control);
}

// also beside parts that are left out of a round, where creases end
TEST(Tessellate, VerticesAreLimitPointsWhereCreasesEnd)
{
  Control_mesh grid = test_meshes::grid(6, 6, false, false, Cells::quads);
  for (std::size_t i = 0; i < grid.points.size(); ++i) {
    const double x = double(i % 7), y = double(i / 7);
    grid.points[i] = {x, y, std::exp(-(x - 3) * (x - 3) - (y - 3) * (y - 3) / 2)};
  }
  grid.normals.assign(grid.points.size(), {0, 0, 0});
  Surface_mesh control = to_surface_mesh(grid);
  const auto sharp =
    control.add_property_map<Surface_mesh::Edge_index, bool>("e:sharp", false).first;
  for (auto e : control.edges()) {
    const Point &p = control.point(control.vertex(e, 0)), &q = control.point(control.vertex(e, 1));
    sharp[e] =
      p.y() == 3 && q.y() == 3 && (std::max)(p.x(), q.x()) <= 4 && (std::min)(p.x(), q.x()) >= 1;
  }
  Surface_mesh out, uniform = control;
  const auto sharp_there =
    uniform.add_property_map<Surface_mesh::Edge_index, bool>("e:sharp", false).first;
  const auto np = params::number_of_iterations(3);
  PN::tessellate(control, PN::CatmullClark_scheme(), 0.004, out, np.edge_is_constrained_map(sharp));
  expect_conforming(out, control);
  PN::subdivide_to_limit(uniform, PN::CatmullClark_scheme(),
                         np.edge_is_constrained_map(sharp_there));
  EXPECT_LT(out.number_of_vertices(), uniform.number_of_vertices() / 2);
  for (auto v : out.vertices()) {
    double least = 1;
    for (auto w : uniform.vertices())
      least = (std::min)(least, CGAL::squared_distance(out.point(v), uniform.point(w)));
    EXPECT_LE(least, 1e-16);
  }
}

// \name Linear schemes, against CGAL

template <class Scheme, class Subdivide>
void expect_linear(const Control_mesh& shape, const Scheme& scheme, const Subdivide& subdivide)
{
  SCOPED_TRACE(shape.name);
  Surface_mesh control;
  {
    Control_mesh with = shape;
    with.normals.assign(with.points.size(), {0, 0, 0});
    control = to_surface_mesh(with);
  }
  for (const double eps : {0.03}) {
    Surface_mesh out;
    const auto result = PN::tessellate(control, PN::linear(scheme), eps, out);
    EXPECT_TRUE(result.reached);
    expect_conforming(out, control);
    Surface_mesh deep = control;
    subdivide(deep, 4);
    const std::vector<Triangle> all = triangles(out);
    double largest = 0;
    for (auto v : deep.vertices()) largest = (std::max)(largest, distance(deep.point(v), all));
    EXPECT_LE(largest, eps + 2e-3); // vertices after four rounds are not limit points yet
    EXPECT_GE(largest, 0.2 * eps);
  }
}

TEST(Tessellate, LinearCatmullClark)
{
  const auto subdivide = [](Surface_mesh& m, unsigned n) {
    CGAL::Subdivision_method_3::CatmullClark_subdivision(m, params::number_of_iterations(n));
  };
  expect_linear(named_shapes::cube(), PN::CatmullClark_scheme(), subdivide);
  expect_linear(test_meshes::house(5), PN::CatmullClark_scheme(), subdivide);
}
// Pentagons about a vertex of the border with too many edges to have a surface normal: what is known of their children
// are the points alone, which a round has to show first.
TEST(Tessellate, ChildrenOfPolygonsAreLookedAt)
{
  constexpr int n = 5;
  const auto at = [](double radius, double part, double z) {
    const double angle = part * std::acos(-1) / n;
    return std::array<double, 3>{radius * std::cos(angle), radius * std::sin(angle), z};
  };
  Control_mesh fan{"fan of pentagons", {{0, 0, 0}}, {}};
  for (int i = 0; i <= n; ++i) fan.points.push_back(at(0.3, i, 0));
  for (int i = 0; i < n; ++i) {
    const int spoke = i + 1, outer = int(fan.points.size());
    const double z = i % 2 == 0 ? -0.6 : 0.6;
    fan.points.push_back(at(0.6, i + 0.3, z));
    fan.points.push_back(at(0.6, i + 0.7, z));
    fan.faces.push_back({0, spoke, outer, outer + 1, spoke + 1});
  }
  expect_linear(fan, PN::CatmullClark_scheme(), [](Surface_mesh& m, unsigned k) {
    CGAL::Subdivision_method_3::CatmullClark_subdivision(m, params::number_of_iterations(k));
  });
}
TEST(Tessellate, LinearLoop)
{
  const auto subdivide = [](Surface_mesh& m, unsigned n) {
    CGAL::Subdivision_method_3::Loop_subdivision(m, params::number_of_iterations(n));
  };
  expect_linear(named_shapes::tetrahedron(), PN::Loop_scheme(), subdivide);
  expect_linear(test_meshes::grid(3, 3, false, false, Cells::triangles), PN::Loop_scheme(),
                subdivide);
}

// \name All shapes, without cracks

TEST(Tessellate, NamedShapesAreConforming)
{
  for (const named_shapes::Shape& shape : named_shapes::all()) {
    if (!shape.creases.empty()) continue;
    SCOPED_TRACE(shape.mesh.name);
    const Surface_mesh control =
      to_surface_mesh(named_shapes::with_normals(shape.mesh, named_shapes::Normals::missing));
    const auto t = tessellated(control, PN::CatmullClark_scheme(), 0.15);
    expect_conforming(t->mesh, control);
    if (test_meshes::all_faces_have_degree(shape.mesh, 3))
      expect_conforming(tessellated(control, PN::Loop_scheme(), 0.15)->mesh, control);
  }
}
TEST(Tessellate, IsolatedVerticesRemain)
{
  const Surface_mesh control = to_surface_mesh(named_shapes::with_normals(
    test_meshes::with_isolated_vertices(named_shapes::cube()), named_shapes::Normals::missing));
  const auto t = tessellated(control, PN::CatmullClark_scheme(), 0.05);
  std::size_t isolated = 0, in_control = 0;
  for (auto v : control.vertices()) in_control += control.is_isolated(v) ? 1 : 0;
  for (auto v : t->mesh.vertices())
    if (t->mesh.is_isolated(v)) {
      ++isolated;
      EXPECT_EQ(t->mesh.point(v), control.point(v));
    }
  EXPECT_GT(in_control, 0U);
  EXPECT_EQ(isolated, in_control);
}
TEST(Tessellate, NothingOfAnEmptyMesh)
{
  const auto t = tessellated(Surface_mesh(), PN::CatmullClark_scheme(), 1);
  EXPECT_EQ(t->mesh.number_of_vertices(), 0U);
  EXPECT_TRUE(t->result.reached);
}

// \name Meshes and numbers

TEST(Tessellate, PolyhedronHasTheSameTriangles)
{
  using Polyhedron = CGAL::Polyhedron_3<Kernel>;
  const Surface_mesh control = to_surface_mesh(
    named_shapes::with_normals(named_shapes::prism(5), named_shapes::Normals::missing));
  Polyhedron polyhedron, out;
  CGAL::copy_face_graph(control, polyhedron);
  const auto result = PN::tessellate(polyhedron, PN::CatmullClark_scheme(), 0.02, out);
  Surface_mesh mesh;
  PN::tessellate(control, PN::CatmullClark_scheme(), 0.02, mesh);
  EXPECT_EQ(result.number_of_triangles, mesh.number_of_faces());
  expect_conforming(out, polyhedron);
  // sums go in another order there
  for (const auto v : vertices(out)) {
    double least = 1;
    for (const auto w : mesh.vertices())
      least = (std::min)(least, CGAL::squared_distance(v->point(), mesh.point(w)));
    EXPECT_LE(least, 1e-20);
  }
}

template <class Other_kernel>
void expect_number_type(double close)
{
  using Mesh = CGAL::Surface_mesh<typename Other_kernel::Point_3>;
  const Surface_mesh control = to_surface_mesh(on_unit_sphere(named_shapes::cube()));
  Mesh other, out;
  const auto normals =
    other
      .template add_property_map<typename Mesh::Vertex_index, typename Other_kernel::Vector_3>(
        "v:normal")
      .first;
  CGAL::copy_face_graph(control, other);
  for (auto v : other.vertices()) normals[v] = other.point(v) - CGAL::ORIGIN;
  const auto result =
    PN::tessellate(other, PN::CatmullClark_scheme(), 0.05, out, params::vertex_normal_map(normals));
  EXPECT_TRUE(result.reached);
  expect_conforming(out, other);
  Surface_mesh in_double;
  CGAL::copy_face_graph(out, in_double);
  EXPECT_LE(distance_from_unit_sphere(triangles(in_double)), 0.05);
  for (auto v : in_double.vertices())
    EXPECT_NEAR((in_double.point(v) - CGAL::ORIGIN).squared_length(), 1, close);
}
TEST(Tessellate, FloatAndExactNumbers)
{
  long_test([](auto) {
    expect_number_type<CGAL::Simple_cartesian<float>>(1e-5);
    expect_number_type<CGAL::Exact_predicates_exact_constructions_kernel>(1e-9);
  });
}

TEST(Tessellate, ThreadsChangeNothing)
{
  const Surface_mesh control = to_surface_mesh(
    named_shapes::with_normals(named_shapes::prism(5), named_shapes::Normals::missing));
  Surface_mesh one, other;
  PN::tessellate(control, PN::CatmullClark_scheme(), 0.01, one);
  PN::tessellate<CGAL::Parallel_if_available_tag>(control, PN::CatmullClark_scheme(), 0.01, other);
  EXPECT_EQ(triangles(one), triangles(other));
}

TEST(Tessellate, ScalesWithTheMesh)
{
  Control_mesh shape = named_shapes::cube();
  test_meshes::set_uneven_normals(shape, 5);
  const Surface_mesh control = to_surface_mesh(shape);
  const auto one = tessellated(control, PN::CatmullClark_scheme(), 0.02);
  for (const int exponent : {600, -600}) {
    const double scale = std::ldexp(1., exponent);
    const auto times = [&](const auto& p) {
      return Point(scale * p[0], scale * p[1], scale * p[2]);
    };
    Surface_mesh scaled = control;
    for (auto v : scaled.vertices()) scaled.point(v) = times(scaled.point(v));
    const auto other = tessellated(scaled, PN::CatmullClark_scheme(), 0.02 * scale);
    ASSERT_EQ(other->mesh.number_of_vertices(), one->mesh.number_of_vertices());
    for (auto v : one->mesh.vertices()) EXPECT_EQ(other->mesh.point(v), times(one->mesh.point(v)));
    EXPECT_EQ(other->result.bound, scale * one->result.bound);
    EXPECT_EQ(other->result.worst_place[0], scale * one->result.worst_place[0]);
    EXPECT_TRUE(other->result.reached);
  }
}

// \name Attributes

// The limit masks of valence 3 on quadrilaterals: Halstead, Kass, DeRose (SIGGRAPH 1993), (n^2 v + 4 e + f) / (n (n + 5)).
TEST(Tessellate, AttributesOfVerticesAreTheirLinearLimits)
{
  Surface_mesh control = to_surface_mesh(on_unit_sphere(named_shapes::cube()));
  for (const double scale : {1., 1e9, 1e-9}) {
    PN::Attribute_table table;
    table.vertices = {{2, {}, PN::Corner_rule::corners_plus1},
                      {2, {}, PN::Corner_rule::corners_plus1}};
    const auto value = [&](auto v) { return scale * double((7 * std::size_t(v)) % 5); };
    for (auto v : control.vertices()) {
      table.vertices[0].values.insert(table.vertices[0].values.end(), {value(v), 3 * scale});
      table.vertices[1].values.insert(table.vertices[1].values.end(), {-value(v), 0});
    }
    Surface_mesh out;
    PN::tessellate(control, PN::CatmullClark_scheme(), 0.02, out,
                   PN::parameters::join(PN::parameters::attributes(table),
                                        params::vertex_normal_map(normal_map(control))));
    ASSERT_EQ(table.vertices[0].values.size(), 2 * out.number_of_vertices());
    for (auto v : control.vertices()) {
      double sum = 9 * value(v);
      for (auto h : control.halfedges_around_target(control.halfedge(v)))
        sum += 4 * value(control.source(h)) + value(control.target(control.next(control.next(h))));
      EXPECT_NEAR(table.vertices[0].values[2 * v], sum / 24, 1e-8 * scale);
      EXPECT_NEAR(table.vertices[1].values[2 * v], -sum / 24, 1e-8 * scale);
    }
    for (auto v : out.vertices()) {
      EXPECT_NEAR(table.vertices[0].values[2 * v + 1], 3 * scale, 1e-14 * scale);
      EXPECT_EQ(table.vertices[1].values[2 * v + 1], 0);
    }
  }
}

// The share of a corner in the place (x, y) of a face: bilinear in a unit square, otherwise the area of the triangle across.
double share_of_corner(const Surface_mesh& mesh, Surface_mesh::Face_index f, std::size_t corner,
                       double x, double y)
{
  std::vector<Point> p;
  for (auto v : mesh.vertices_around_face(mesh.halfedge(f))) p.push_back(mesh.point(v));
  const std::size_t n = p.size();
  if (n == 4) return (1 - std::abs(x - p[corner].x())) * (1 - std::abs(y - p[corner].y()));
  const Point &a = p[(corner + 1) % n], &b = p[(corner + 2) % n];
  return std::abs((a.x() - x) * (b.y() - y) - (a.y() - y) * (b.x() - x));
}

// Over a uniform grid the coordinates x, y of a point of the linear surface are its parameters, unless edges are sharp.
void expect_parameters(Cells cells)
{
  Control_mesh grid = test_meshes::grid(3, 3, false, false, cells);
  for (std::size_t i = 0; i < grid.points.size(); ++i) {
    const auto at = [&](std::size_t n) { return double((n * i) % 7) / 7; };
    grid.points[i] = {double(i % 4), double(i / 4), at(3)};
  }
  grid.normals.assign(grid.points.size(), {0, 0, 0});
  Surface_mesh control = to_surface_mesh(grid);
  for (const bool is_creased : {false, true}) {
    const auto sharp = control.add_property_map<Surface_mesh::Edge_index, bool>("e:s", false).first;
    for (auto e : control.edges()) sharp[e] = is_creased && std::size_t(e) % 4 == 0;
    PN::Attribute_table table;
    table.has_face_parents = true;
    table.vertices.resize(2);
    table.vertices[1].rule_of_vertices = PN::Attribute_rule::nearest;
    for (auto v : control.vertices()) {
      table.vertices[0].values.push_back(control.point(v).x() + 10 * control.point(v).y());
      table.vertices[1].values.push_back(std::size_t(v));
    }
    table.corners = {{1, {}, PN::Corner_rule::all}, {2, {}, PN::Corner_rule::all}};
    for (auto h : control.halfedges()) {
      const auto f = control.is_border(h) ? 0 : std::size_t(control.face(h));
      const Point& p = control.point(control.target(h));
      table.corners[0].values.push_back(1000. * double(f) + p.x());
      table.corners[1].values.insert(table.corners[1].values.end(), {p.x(), p.y()});
    }
    Surface_mesh out;
    const auto refine = [&](const auto& scheme) {
      PN::tessellate(control, PN::linear(scheme), 0.01, out,
                     PN::parameters::border(PN::Border::corners)
                       .attributes(table)
                       .edge_is_constrained_map(sharp));
    };
    if (cells == Cells::triangles)
      refine(PN::Loop_scheme());
    else
      refine(PN::CatmullClark_scheme());
    ASSERT_EQ(table.face_parents.size(), out.number_of_faces());
    ASSERT_EQ(table.vertices[0].values.size(), out.number_of_vertices());
    ASSERT_EQ(table.corners[1].values.size(), 2 * out.number_of_halfedges());
    std::set<std::uint32_t> parents;
    std::map<Surface_mesh::Vertex_index, std::pair<double, double>> places;
    for (auto v : out.vertices())
      EXPECT_NEAR(table.vertices[0].values[v], out.point(v).x() + 10 * out.point(v).y(), 1e-12);
    for (auto h : out.halfedges()) {
      if (out.is_border(h)) continue;
      const auto parent = table.face_parents[out.face(h)];
      parents.insert(parent);
      const double x = table.corners[1].values[2 * std::size_t(h)],
                   y = table.corners[1].values[2 * std::size_t(h) + 1];
      EXPECT_NEAR(table.corners[0].values[h], 1000. * parent + x, 1e-8);
      const Point& p = out.point(out.target(h));
      if (cells == Cells::quads && !is_creased) {
        EXPECT_NEAR(x, p.x(), 1e-12);
        EXPECT_NEAR(y, p.y(), 1e-12);
      }
      double largest = 0, own = 0;
      std::size_t i = 0;
      const Surface_mesh::Face_index control_face(parent);
      for (auto v : control.vertices_around_face(control.halfedge(control_face))) {
        const double share = share_of_corner(control, control_face, i++, x, y);
        largest = (std::max)(largest, share);
        if (table.vertices[1].values[out.target(h)] == double(std::size_t(v))) own = share;
      }
      EXPECT_NEAR(own, largest, 1e-8);
      // of a vertex between faces the same in all of them
      const auto [of_vertex, is_new] = places.insert({out.target(h), {x, y}});
      EXPECT_EQ(of_vertex->second, std::make_pair(x, y));
    }
    EXPECT_EQ(parents.size(), control.number_of_faces());
  }
}
TEST(Tessellate, AttributesOfCornersAreParameters)
{
  expect_parameters(Cells::quads);
  expect_parameters(Cells::triangles);
}
TEST(Tessellate, RefusedAttributesStayAsTheyAre)
{
  const Surface_mesh control = to_surface_mesh(on_unit_sphere(named_shapes::cube()));
  const auto expect = [&](PN::Attribute_table table, const std::string& part) {
    Surface_mesh out;
    const std::size_t sizes[] = {table.vertices.size(), table.corners.size(), table.edges.size()};
    messages::expect_refused(
      [&] {
        PN::tessellate(control, PN::CatmullClark_scheme(), 0.1, out,
                       PN::parameters::attributes(table));
      },
      {part});
    EXPECT_EQ(out.number_of_vertices(), 0U);
    EXPECT_EQ(table.vertices.size(), sizes[0]);
    EXPECT_EQ(table.corners.size(), sizes[1]);
    EXPECT_EQ(table.edges.size(), sizes[2]);
  };
  PN::Attribute_table table;
  table.vertices = {{1, std::vector<double>(7, 0), PN::Corner_rule::corners_plus1}};
  expect(table, "of vertices has 7 values");
  table.vertices.clear();
  table.corners = {{1, std::vector<double>(24, 0), PN::Corner_rule::corners_plus1}};
  expect(table, "Corner_rule::all");
  table.corners.clear();
  table.edges = {{1, std::vector<double>(12, 0), PN::Corner_rule::corners_plus1}};
  expect(table, "edges");
}

// \name Refused input

template <class Scheme>
void expect_refused(const Surface_mesh& control, const Scheme& scheme, double eps,
                    const std::string& part)
{
  Surface_mesh out;
  messages::expect_refused([&] { PN::tessellate(control, scheme, eps, out); }, {part});
  EXPECT_EQ(out.num_vertices() + out.num_halfedges() + out.num_faces(), 0U);
}

TEST(Tessellate, RefusesToleranceAndScheme)
{
  const Surface_mesh control = to_surface_mesh(
    named_shapes::with_normals(named_shapes::tetrahedron(), named_shapes::Normals::missing));
  for (const double eps :
       {0., -1., std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    expect_refused(control, PN::CatmullClark_scheme(), eps, "chord error");
  expect_refused(control, PN::Sqrt3_scheme(), 0.1, "sqrt3");
  expect_refused(control, PN::DooSabin_scheme(), 0.1, "doo-sabin");
  expect_refused(control, scheme_named("sqrt3"), 0.1, "sqrt3");
  expect_refused(control, scheme_named("doo-sabin"), 0.1, "doo-sabin");
}
TEST(Tessellate, RefusesMeshes)
{
  const Surface_mesh cube = to_surface_mesh(
    named_shapes::with_normals(named_shapes::cube(), named_shapes::Normals::missing));
  expect_refused(cube, PN::Loop_scheme(), 0.1, "4 corners");
  Surface_mesh full = cube;
  EXPECT_THROW(PN::tessellate(cube, PN::CatmullClark_scheme(), 0.1, full), std::invalid_argument);
  EXPECT_EQ(full.num_vertices(), cube.num_vertices());
  EXPECT_EQ(full.num_faces(), cube.num_faces());
}

TEST(Tessellate, TellsWhatIsNotReached)
{
  const Surface_mesh control = to_surface_mesh(on_unit_sphere(named_shapes::cube()));
  for (const unsigned rounds : {0U, 1U, 2U}) {
    Surface_mesh out, in = control;
    const auto result =
      PN::tessellate(in, PN::CatmullClark_scheme(), 1e-4, out,
                     params::number_of_iterations(rounds).vertex_normal_map(normal_map(in)));
    EXPECT_FALSE(result.reached);
    EXPECT_EQ(result.obstacle, PN::Tessellation_result::Obstacle::rounds);
    EXPECT_LT(result.worst_face, control.number_of_faces());
    const double away =
      std::hypot(result.worst_place[0], result.worst_place[1], result.worst_place[2]);
    EXPECT_LT(away, 1);
    EXPECT_GT(away, 0.5);
    EXPECT_EQ(result.depth, rounds);
    EXPECT_EQ(result.number_of_triangles, std::size_t(12) << 2 * rounds);
    const double error = distance_from_unit_sphere(triangles(out));
    EXPECT_GE(result.bound, error);
    EXPECT_LE(result.bound, 1.3 * error);
  }
}

} // namespace

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The functions of CGAL's Subdivision_method_3 by this package, beside CGAL's own: connectivity, order of the vertices,
// points; and what CGAL's cannot do.

#include "Mesh_cases.h"
#include "Messages.h"
#include "Named_shapes.h"
#include "Random_meshes.h"

#include <CGAL/Gmpq.h>
#include <CGAL/PN_cgal_masks_3/PN_mask_3.h>
#include <CGAL/PN_cgal_masks_3/Subdivision_method_3.h>
#include <CGAL/PN_subdivision_3/schemes/Bilinear_scheme.h>

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/subdivision_method_3.h>

#include <functional>

namespace {

namespace PN = CGAL::PN_subdivision_3;
namespace cgal = CGAL::Subdivision_method_3;
namespace ours = CGAL::PN_subdivision_3::Subdivision_method_3;
namespace np = CGAL::parameters;
using mesh_cases::built;
using mesh_cases::faces_of;
using mesh_cases::points;
using test_meshes::Control_mesh;
using K = CGAL::Simple_cartesian<double>;
using Surface_mesh = CGAL::Surface_mesh<K::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<K>;

// --- the four schemes, and their masks in their hosts ---

#define PN_SCHEME_AS_CGAL(NAME, HOST, TRIANGLES, IS_DUAL)                                          \
  struct NAME                                                                                      \
  {                                                                                                \
    static constexpr bool triangles = TRIANGLES, is_dual = IS_DUAL;                                \
    static auto scheme() { return PN::NAME##_scheme(); }                                           \
    template <class Mesh, class NP>                                                                \
    static void of_cgal(Mesh& mesh, const NP& p)                                                   \
    {                                                                                              \
      cgal::NAME##_subdivision(mesh, p);                                                           \
    }                                                                                              \
    template <class Mesh, class NP>                                                                \
    static void of_ours(Mesh& mesh, const NP& p)                                                   \
    {                                                                                              \
      ours::NAME##_subdivision(mesh, p);                                                           \
    }                                                                                              \
    template <class Mesh, class NP>                                                                \
    static void masked(Mesh& mesh, const NP& p)                                                    \
    {                                                                                              \
      ours::HOST(mesh, CGAL::NAME##_mask_3<Mesh>(&mesh, get(CGAL::vertex_point, mesh)), p);        \
    }                                                                                              \
  };

PN_SCHEME_AS_CGAL(CatmullClark, PQQ, false, false)
PN_SCHEME_AS_CGAL(Loop, PTQ, true, false)
PN_SCHEME_AS_CGAL(DooSabin, DQQ, false, true)
PN_SCHEME_AS_CGAL(Sqrt3, Sqrt3, true, false)

#undef PN_SCHEME_AS_CGAL

// --- meshes ---

// those that CGAL's functions can refine
template <class Scheme>
std::vector<Control_mesh> control_meshes()
{
  std::vector<Control_mesh> all;
  for (const named_shapes::Shape& shape : named_shapes::all()) all.push_back(shape.mesh);
  std::mt19937 generator(7);
  for (int i = 0; i < 20; ++i)
    all.push_back(random_meshes::random_mesh(Scheme::triangles ? random_meshes::Kind::triangles
                                                               : random_meshes::Kind::polygons,
                                             generator));
  std::vector<Control_mesh> result;
  for (const Control_mesh& mesh : all)
    if (!test_meshes::has_isolated_vertex(mesh) && mesh.points.size() <= 200 &&
        !(Scheme::triangles && !test_meshes::all_faces_have_degree(mesh, 3)) &&
        !named_shapes::has_interior_valence_2(mesh))
      result.push_back(mesh);
  return result;
}

// in an even round CGAL's host of sqrt(3) takes a triangle to have one border edge at most
template <class Mesh>
std::size_t most_border_edges_of_a_face(const Mesh& mesh)
{
  std::size_t most = 0;
  for (auto f : faces(mesh)) {
    std::size_t number = 0;
    for (auto h : halfedges_around_face(halfedge(f, mesh), mesh))
      number += CGAL::is_border(opposite(h, mesh), mesh);
    most = (std::max)(most, number);
  }
  return most;
}

template <class Mesh>
double box_size(const Mesh& mesh)
{
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  return (std::max)({box.x_span(), box.y_span(), box.z_span()});
}

constexpr double units = 8 * std::numeric_limits<double>::epsilon();

template <class Mesh, class Other>
void expect_same(const Mesh& mine, const Other& theirs, double box, double tolerance = units)
{
  const auto a = points(mine), b = points(theirs);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c)
      ASSERT_LE(std::abs(a[i][c] - b[i][c]), tolerance * box) << "vertex " << i;
  EXPECT_EQ(faces_of(mine), faces_of(theirs));
}

template <class Scheme, class Mesh>
void compare_with_cgal(const std::function<void(Mesh&, unsigned)>& refine)
{
  std::size_t compared = 0;
  for (const Control_mesh& control : control_meshes<Scheme>())
    for (unsigned rounds = 1; rounds <= 3; ++rounds) {
      if (rounds == 3 && control.faces.size() > 24) continue;
      SCOPED_TRACE(control.name + ", rounds " + std::to_string(rounds));
      Mesh mine = built<Mesh>(control);
      if (std::is_same_v<Scheme, Sqrt3> && rounds > 1 && most_border_edges_of_a_face(mine) > 1)
        continue;
      const double box = box_size(mine);
      const auto p = np::number_of_iterations(rounds);
      refine(mine, rounds);
      EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mine));
      // of a Surface_mesh CGAL's DQQ fills removed vertices again, in another order
      if (Scheme::is_dual && rounds > 1) {
        Polyhedron theirs = built<Polyhedron>(control);
        Scheme::of_cgal(theirs, p);
        expect_same(mine, theirs, box);
      } else {
        Mesh theirs = built<Mesh>(control);
        Scheme::of_cgal(theirs, p);
        expect_same(mine, theirs, box);
      }
      ++compared;
      if (testing::Test::HasFailure()) return;
    }
  EXPECT_GE(compared, 60u);
}

template <class Scheme>
class As_cgal : public testing::Test
{};
struct Names
{
  template <class Scheme>
  static std::string GetName(int)
  {
    return Scheme::scheme().name();
  }
};
using Four_schemes = testing::Types<CatmullClark, Loop, DooSabin, Sqrt3>;
TYPED_TEST_SUITE(As_cgal, Four_schemes, Names);

TYPED_TEST(As_cgal, RefinesSurfaceMeshes)
{
  compare_with_cgal<TypeParam, Surface_mesh>([](Surface_mesh& mesh, unsigned rounds) {
    TypeParam::of_ours(mesh, np::number_of_iterations(rounds));
  });
}
TYPED_TEST(As_cgal, RefinesPolyhedra)
{
  compare_with_cgal<TypeParam, Polyhedron>([](Polyhedron& mesh, unsigned rounds) {
    TypeParam::of_ours(mesh, np::number_of_iterations(rounds));
  });
}
TYPED_TEST(As_cgal, RefinesSurfaceMeshesWithMasks)
{
  compare_with_cgal<TypeParam, Surface_mesh>([](Surface_mesh& mesh, unsigned rounds) {
    TypeParam::masked(mesh, np::number_of_iterations(rounds));
  });
}
TYPED_TEST(As_cgal, RefinesPolyhedraWithMasks)
{
  compare_with_cgal<TypeParam, Polyhedron>([](Polyhedron& mesh, unsigned rounds) {
    TypeParam::masked(mesh, np::number_of_iterations(rounds));
  });
}

// Whether CGAL has a rational weight for a new vertex. Others, at irregular vertices and faces, have cosines of double.
bool has_rational_weight(CatmullClark, const Control_mesh&, int)
{
  return true;
}
bool has_rational_weight(Loop, const Control_mesh& control, int v)
{
  const reference::Face_list list = test_meshes::face_list(control);
  return v >= list.number_of_vertices() || list.is_border(v) || list.ring(v).size() == 6;
}
bool has_rational_weight(DooSabin, const Control_mesh& control, int)
{
  return test_meshes::all_faces_have_degree(control, 4);
}
bool has_rational_weight(Sqrt3, const Control_mesh& control, int v)
{
  return v >= int(control.points.size());
}

TYPED_TEST(As_cgal, RefinesMeshesOfRationalNumbersExactly)
{
  using Rational_mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<CGAL::Gmpq>::Point_3>;
  std::size_t equal = 0;
  for (const Control_mesh& control : control_meshes<TypeParam>()) {
    if (control.points.size() > 40) continue;
    Rational_mesh mine = built<Rational_mesh>(control), theirs = mine;
    const double box = box_size(mine);
    TypeParam::of_ours(mine, np::number_of_iterations(1));
    TypeParam::of_cgal(theirs, np::number_of_iterations(1));
    ASSERT_EQ(mine.number_of_vertices(), theirs.number_of_vertices()) << control.name;
    auto w = theirs.vertices().begin();
    for (auto v : mine.vertices()) {
      const auto &p = mine.point(v), &q = theirs.point(*w++);
      if (has_rational_weight(TypeParam(), control, int(v.idx()))) {
        ++equal;
        EXPECT_TRUE(p == q) << control.name << ", " << v;
      } else
        EXPECT_LE(std::sqrt(CGAL::to_double(CGAL::squared_distance(p, q))), 1e-15 * box)
          << control.name << ", " << v;
    }
  }
  EXPECT_GT(equal, 100u);
}

// the number of rounds as it was once given, and none
TYPED_TEST(As_cgal, TakesNumbersOfRounds)
{
  const Control_mesh control = control_meshes<TypeParam>().front();
  Surface_mesh a = built<Surface_mesh>(control), b = a, c = a;
  TypeParam::of_ours(a, 2);
  TypeParam::of_ours(b, np::number_of_iterations(2));
  expect_same(a, b, 1, 0);
  TypeParam::of_ours(c, 0);
  EXPECT_EQ(points(c), points(built<Surface_mesh>(control)));
  Surface_mesh d = built<Surface_mesh>(control), e = d;
  TypeParam::of_ours(d, np::default_values());
  TypeParam::masked(e, 1);
  expect_same(d, e, 1, 1e-13);
}

// with normals they are the point-normal schemes, which may have another order, and without them their linear twins
TYPED_TEST(As_cgal, IsPointNormalWithNormals)
{
  const auto normals_of = [](Surface_mesh& mesh) {
    const auto map =
      mesh.add_property_map<Surface_mesh::Vertex_index, K::Vector_3>("v:normal", CGAL::NULL_VECTOR)
        .first;
    for (auto v : mesh.vertices()) map[v] = mesh.point(v) - K::Point_3(0.1, 0.2, 0.3);
    return map;
  };
  std::size_t curved = 0;
  for (const Control_mesh& control : control_meshes<TypeParam>()) {
    Surface_mesh a = built<Surface_mesh>(control), b = a, linear = a, twin = a;
    const auto of_a = normals_of(a), of_b = normals_of(b);
    const auto rounds = np::number_of_iterations(1);
    TypeParam::of_ours(a, rounds.vertex_normal_map(of_a));
    PN::subdivide(b, TypeParam::scheme(), rounds.vertex_normal_map(of_b));
    TypeParam::of_ours(linear, rounds);
    PN::subdivide(twin, PN::linear(TypeParam::scheme()), rounds);
    const auto points_of = [](const Surface_mesh& mesh) {
      auto all = points(mesh);
      if (TypeParam::is_dual) std::sort(all.begin(), all.end());
      return all;
    };
    curved += points_of(a) != points_of(linear);
    EXPECT_EQ(points_of(a), points_of(b)) << control.name;
    EXPECT_EQ(points_of(linear), points_of(twin)) << control.name;
  }
  EXPECT_GE(curved, 20u);
}

// --- what CGAL's cannot do ---

// vertices without edges, which CGAL's hosts turn into NaN or a crash, and empty meshes
TYPED_TEST(As_cgal, KeepsVerticesWithoutEdges)
{
  for (bool masked : {false, true})
    for (const Control_mesh& control : control_meshes<TypeParam>()) {
      if (control.points.size() > 30) continue;
      Surface_mesh mesh = built<Surface_mesh>(control), with = mesh;
      with.add_vertex(K::Point_3(7, 8, 9));
      const auto run = [&](Surface_mesh& m) {
        masked ? TypeParam::masked(m, np::number_of_iterations(2))
               : TypeParam::of_ours(m, np::number_of_iterations(2));
      };
      if (std::is_same_v<TypeParam, Sqrt3> && most_border_edges_of_a_face(mesh) > 1) continue;
      run(mesh);
      run(with);
      auto expected = points(mesh);
      const auto found = points(with);
      if (!TypeParam::is_dual)
        expected.insert(expected.begin() + std::ptrdiff_t(control.points.size()),
                        mesh_cases::Triple{7, 8, 9});
      EXPECT_EQ(found, expected) << control.name;
    }
  Surface_mesh empty;
  TypeParam::of_ours(empty, np::number_of_iterations(3));
  TypeParam::masked(empty, np::number_of_iterations(3));
  EXPECT_TRUE(CGAL::is_empty(empty));
}

TEST(As_cgal_refusals, LeaveTheMeshAsItWas)
{
  Surface_mesh triangle, quad;
  triangle.add_face(triangle.add_vertex(K::Point_3(0, 0, 0)),
                    triangle.add_vertex(K::Point_3(1, 0, 0)),
                    triangle.add_vertex(K::Point_3(0, 1, 0)));
  quad.add_face(quad.add_vertex(K::Point_3(0, 0, 0)), quad.add_vertex(K::Point_3(1, 0, 0)),
                quad.add_vertex(K::Point_3(1, 1, 0)), quad.add_vertex(K::Point_3(0, 1, 0)));
  const std::string corners = "face 0 has 4 corners";
  messages::expect_refused([&] { ours::Loop_subdivision(quad); }, {corners});
  messages::expect_refused([&] { Loop::masked(quad, 1); }, {corners});
  messages::expect_refused([&] { ours::Sqrt3_subdivision(quad); }, {corners});
  messages::expect_refused([&] { Sqrt3::masked(quad, 1); }, {corners});
  EXPECT_EQ(quad.number_of_faces(), 1u);
  ours::Sqrt3_subdivision(triangle, np::number_of_iterations(2));
  EXPECT_EQ(triangle.number_of_faces(), 9u);
}

// Linear_mask_3 sets no vertices on borders: CGAL 5.5 moves them to where its memory happens to be
TEST(As_cgal_masks, LeaveWhatTheyDoNotSet)
{
  std::size_t bordered = 0;
  for (const Control_mesh& control : control_meshes<CatmullClark>()) {
    Surface_mesh mesh = built<Surface_mesh>(control), linear = mesh;
    ours::PQQ(mesh, CGAL::Linear_mask_3<Surface_mesh>(&mesh, get(CGAL::vertex_point, mesh)),
              np::number_of_iterations(2));
    PN::subdivide(linear, PN::internal::in_order_of_cgal<true>(PN::linear(PN::Bilinear_scheme())),
                  np::number_of_iterations(2));
    expect_same(mesh, linear, box_size(linear));
    bordered += !CGAL::is_closed(mesh);
  }
  EXPECT_GE(bordered, 10u);
}

// point maps of pairs: the point-normal masks of CGAL's masks, in these hosts
TEST(As_cgal_masks, MayBePointNormalOnes)
{
  const Control_mesh control = control_meshes<CatmullClark>().front();
  Surface_mesh mesh = built<Surface_mesh>(control), expected = mesh;
  const auto run = [](Surface_mesh& m, const auto& host) {
    const auto normals =
      m.add_property_map<Surface_mesh::Vertex_index, K::Vector_3>("v:normal", CGAL::NULL_VECTOR)
        .first;
    for (auto v : m.vertices()) normals[v] = m.point(v) - K::Point_3(0.1, 0.2, 0.3);
    const auto map = PN::Zipped_point_normal_map(get(CGAL::vertex_point, m), normals);
    host(m, PN::make_PN_mask_3<CGAL::CatmullClark_mask_3>(m, map),
         np::vertex_point_map(map).number_of_iterations(2));
  };
  run(mesh, [](auto& m, const auto& mask, const auto& p) { ours::PQQ(m, mask, p); });
  run(expected, [](auto& m, const auto& mask, const auto& p) { cgal::PQQ(m, mask, p); });
  expect_same(mesh, expected, box_size(expected), 1e-13);
}

TEST(As_cgal_creases, AreSharp)
{
  const Surface_mesh cube = built<Surface_mesh>([] {
    for (const named_shapes::Shape& shape : named_shapes::all())
      if (shape.mesh.name == "cube") return shape.mesh;
    throw std::logic_error("there is no cube");
  }());
  Surface_mesh sharp = cube, smooth = cube, expected = cube;
  const auto all_edges = [](Surface_mesh& mesh) {
    return mesh.add_property_map<Surface_mesh::Edge_index, bool>("e:sharp", true).first;
  };
  const auto rounds = np::number_of_iterations(3);
  ours::CatmullClark_subdivision(sharp, rounds.edge_is_constrained_map(all_edges(sharp)));
  ours::CatmullClark_subdivision(smooth, rounds);
  PN::subdivide(expected, PN::linear(PN::CatmullClark_scheme()),
                rounds.edge_is_constrained_map(all_edges(expected)));
  auto a = points(sharp), b = points(expected);
  EXPECT_NE(a, points(smooth));
  for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(a[i], points(cube)[i]); // corners
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(a[i][c], b[i][c], 1e-14);
}

} // namespace

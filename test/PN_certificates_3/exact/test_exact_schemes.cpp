// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// What holds exactly in exact numbers, for every scheme: invariance, reversal, reduction to the
// linear scheme. The linear twins against CGAL, whose weights are those of double.

#include "Exact_control.h"
#include "Schemes.h"

namespace {

namespace PN = CGAL::PN_subdivision_3;
using test_meshes::Control_mesh;

using Number = Exact_control::Number;
using Point = Exact_control::Point;
using Vector = Exact_control::Vector;
using Rational = rational_shapes::Rational;
using Rational_mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<Rational>::Point_3>;

template <class Description>
class Exact_scheme : public testing::Test
{};
TYPED_TEST_SUITE(Exact_scheme, Schemes, Scheme_names);

// uneven normals, and wild ones: missing, fading and opposite
template <class Description>
std::vector<Control_mesh> control_meshes()
{
  std::vector<Control_mesh> result;
  for (Control_mesh mesh : meshes_for<Description>()) {
    if (mesh.points.size() > 25) continue;
    result.push_back(mesh);
    test_meshes::set_wild_normals(mesh, 5);
    mesh.name += ", wild normals";
    result.push_back(mesh);
  }
  return result;
}

void expect_equal(const Exact_control& a, const Exact_control& b, const std::string& name)
{
  ASSERT_EQ(a.mesh.number_of_vertices(), b.mesh.number_of_vertices()) << name;
  std::size_t points = 0, normals = 0;
  for (auto v : a.mesh.vertices()) {
    points += !(a.mesh.point(v) == b.mesh.point(v));
    normals += !(a.normals[v] == b.normals[v]);
  }
  EXPECT_EQ(points, 0u) << name;
  EXPECT_EQ(normals, 0u) << name;
}

// The rotation of a quaternion with integer coefficients, or with the factor -1 a reflection in a
// point as well.
Vector rotated(const Vector& v, int w, int x, int y, int z, int factor = 1)
{
  const Number s = Number(Rational(factor, w * w + x * x + y * y + z * z));
  const Number ww(w * w), xx(x * x), yy(y * y), zz(z * z), wx(2 * w * x), wy(2 * w * y),
    wz(2 * w * z), xy(2 * x * y), xz(2 * x * z), yz(2 * y * z);
  return Vector(s * ((ww + xx - yy - zz) * v.x() + (xy - wz) * v.y() + (xz + wy) * v.z()),
                s * ((xy + wz) * v.x() + (ww - xx + yy - zz) * v.y() + (yz - wx) * v.z()),
                s * ((xz - wy) * v.x() + (yz + wx) * v.y() + (ww - xx - yy + zz) * v.z()));
}

TYPED_TEST(Exact_scheme, CommutesWithRationalSimilarities)
{
  if (!TypeParam::takes_intervals)
    GTEST_SKIP() << "does not apply: transferred curvature is rounded to double";
  const Vector shift(Number(Rational(1, 3)), -2, Number(Rational(5, 7)));
  const Number scale(Rational(11, 3));
  for (int factor : {1, -1}) {
    const auto of_normal = [&](const Vector& n) { return rotated(n, 1, 2, -3, 5, factor); };
    const auto of_point = [&](const Point& p) {
      return CGAL::ORIGIN + (scale * of_normal(p - CGAL::ORIGIN) + shift);
    };
    for (const Control_mesh& control : control_meshes<TypeParam>()) {
      Exact_control first(control), then(control);
      first.change(of_point, of_normal);
      first.refine(TypeParam::scheme());
      then.refine(TypeParam::scheme());
      then.change(of_point, of_normal);
      expect_equal(first, then, control.name);
    }
  }
}

TYPED_TEST(Exact_scheme, ReversedNormalsGiveTheSamePoints)
{
  if (!TypeParam::takes_intervals)
    GTEST_SKIP() << "does not apply: transferred curvature is rounded to double";
  const auto same = [](const Point& p) { return p; };
  const auto reversed = [](const Vector& n) { return -n; };
  for (const Control_mesh& control : control_meshes<TypeParam>()) {
    Exact_control first(control), then(control);
    first.change(same, reversed);
    first.refine(TypeParam::scheme());
    then.refine(TypeParam::scheme());
    then.change(same, reversed);
    expect_equal(first, then, control.name);
  }
}

// --- the linear twin ---

template <class FT>
auto mesh_of(const Control_mesh& control)
{
  CGAL::Surface_mesh<typename CGAL::Simple_cartesian<FT>::Point_3> mesh;
  for (const test_meshes::Triple& p : control.points)
    mesh.add_vertex({FT(p[0]), FT(p[1]), FT(p[2])});
  for (const reference::Face& face : control.faces) {
    std::vector<CGAL::SM_Vertex_index> corners;
    for (int v : face) corners.emplace_back(static_cast<CGAL::SM_Vertex_index::size_type>(v));
    mesh.add_face(corners);
  }
  return mesh;
}

template <class Description, class Mesh>
void refine_linearly_by(Mesh& mesh, unsigned rounds = 1)
{
  PN::subdivide(mesh, PN::linear(Description::scheme()),
                CGAL::parameters::number_of_iterations(rounds));
}

// Two rounds: with equal normals, or none, all numbers remain rational.
TYPED_TEST(Exact_scheme, EqualOrNoNormalsReduceToTheLinearScheme)
{
  if (!TypeParam::is_linear_for_equal_normals)
    GTEST_SKIP() << "does not apply: it keeps the curvature of points";
  const Number third(Rational(1, 3));
  for (const Vector& normal : {Vector(2 * third, -2 * third, third), Vector(0, 0, 0)})
    for (const Control_mesh& control : meshes_for<TypeParam>()) {
      Exact_control pn(control);
      for (auto v : pn.mesh.vertices()) pn.normals[v] = normal;
      pn.refine(TypeParam::scheme(), 2);
      Rational_mesh linear = mesh_of<Rational>(control);
      refine_linearly_by<TypeParam>(linear, 2);
      ASSERT_EQ(pn.mesh.number_of_vertices(), linear.number_of_vertices());
      std::size_t different = 0;
      for (auto v : linear.vertices()) {
        const auto& q = linear.point(v);
        different += !(pn.mesh.point(v) == Point(q.x(), q.y(), q.z()) && pn.normals[v] == normal);
      }
      EXPECT_EQ(different, 0u) << control.name;
    }
}

// --- against CGAL ---

// The values at the same vertices: by index, or by position where CGAL has an order of its own.
template <class Any_mesh>
Result rounded_result(const Any_mesh& mesh)
{
  Result result;
  for (auto v : mesh.vertices()) {
    const auto& p = mesh.point(v);
    result.values.points.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()),
                                      CGAL::to_double(p.z()));
  }
  return result;
}

// What of a mesh CGAL treats with rational weights: all but irregular vertices, or faces, of the
// schemes with cosines.
bool has_rational_weights(const ::CatmullClark&, const Control_mesh&, int)
{
  return true;
}
bool has_rational_weights(const ::Loop&, const Control_mesh& control, int new_vertex)
{
  const reference::Face_list list = test_meshes::face_list(control);
  return new_vertex >= list.number_of_vertices() || list.is_border(new_vertex) ||
         list.ring(new_vertex).size() == 6;
}
bool has_rational_weights(const ::DooSabin&, const Control_mesh& control, int)
{
  return test_meshes::all_faces_have_degree(control, 4);
}
bool has_rational_weights(const ::Sqrt3&, const Control_mesh& control, int new_vertex)
{
  return new_vertex >= int(control.points.size());
}

TYPED_TEST(Exact_scheme, LinearTwinEqualsCgalWhereWeightsAreRational)
{
  if constexpr (has_cgal_peer<TypeParam>) {
    std::size_t equal = 0, close = 0;
    for (const Control_mesh& control : meshes_for_cgal<TypeParam>()) {
      Rational_mesh ours = mesh_of<Rational>(control), cgal = ours;
      refine_linearly_by<TypeParam>(ours);
      TypeParam::Cgal::linear(cgal, CGAL::parameters::number_of_iterations(1));
      cgal.collect_garbage();
      ASSERT_EQ(ours.number_of_vertices(), cgal.number_of_vertices());
      const Result a = rounded_result(ours), b = rounded_result(cgal);
      std::vector<int> match = match_by_position(a, b);
      if (TypeParam::is_primal)
        for (std::size_t i = 0; i < match.size(); ++i) match[i] = int(i);
      for (auto v : ours.vertices()) {
        ASSERT_NE(match[v], -1);
        const CGAL::SM_Vertex_index partner(
          static_cast<CGAL::SM_Vertex_index::size_type>(match[v]));
        const auto &p = ours.point(v), &q = cgal.point(partner);
        if (has_rational_weights(typename TypeParam::Cgal(), control, int(v.idx()))) {
          ++equal;
          EXPECT_TRUE(p == q) << control.name << ", " << v;
        } else {
          ++close;
          const double distance = std::sqrt(CGAL::to_double(CGAL::squared_distance(p, q)));
          EXPECT_LE(distance, 1e-15 * size_of(a.values)) << control.name << ", " << v;
        }
      }
    }
    std::cout << equal << " vertices equal, " << close << " within 1e-15\n";
    EXPECT_GT(equal, 0u);
  } else
    GTEST_SKIP() << "does not apply: CGAL has no such function";
}

} // namespace

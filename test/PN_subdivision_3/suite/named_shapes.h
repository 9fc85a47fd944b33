// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
// What must hold of every scheme on every named shape with every kind of normals, as a test suite with the scheme
// as its parameter. Shapes and normals are looped over at run time; only schemes and mesh types cost compilation.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_SUITE_NAMED_SHAPES_H
#define CGAL_PN_SUBDIVISION_3_TEST_SUITE_NAMED_SHAPES_H

#include "Mesh_cases.h"
#include "Named_shapes.h"
#include "Scheme_runs.h"
#include "analysis/subdivision_matrix.h"

#include <CGAL/PN_subdivision_3/hosts/DQQ_host.h>
#include <CGAL/PN_subdivision_3/hosts/Sqrt3_host.h>
#include <CGAL/Polyhedron_3.h>

#include <functional>

namespace named_shapes {

namespace PN = CGAL::PN_subdivision_3;
namespace np = CGAL::parameters;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Vector_3 = Kernel::Vector_3;

template <class Description>
using Scheme_of = decltype(Description::scheme());
template <class Description>
using Host_of = typename Scheme_of<Description>::Host;
template <class Description>
constexpr bool is_dual = std::is_same_v<Host_of<Description>, PN::DQQ_host>;
template <class Description>
constexpr bool is_sqrt3 = std::is_same_v<Host_of<Description>, PN::Sqrt3_host>;

// --- which shapes ---

template <class Description>
bool is_refused(const Control_mesh& mesh)
{
  return !takes<Description>(mesh) ||
         (!Description::takes_valence_2 && has_interior_valence_2(mesh));
}

// f(shape, its mesh with normals n, n) for all shapes that the scheme takes
template <class Description>
void for_each_case(const std::function<void(const Shape&, const Control_mesh&, Normals)>& f)
{
  for (const Shape& shape : all())
    if (!is_refused<Description>(shape.mesh))
      for (Normals n : all_normals) {
        SCOPED_TRACE(shape.mesh.name + ", normals " + name_of(n));
        f(shape, with_normals(shape.mesh, n), n);
      }
}

// --- runs ---

template <class Description, class Mesh, class Normal_map>
void subdivide(Mesh& mesh, Normal_map normals, Normals n, unsigned rounds)
{
  if (n == Normals::linear)
    PN::subdivide(mesh, PN::linear(Description::scheme()), np::number_of_iterations(rounds));
  else
    PN::subdivide(mesh, Description::scheme(),
                  np::number_of_iterations(rounds).vertex_normal_map(normals));
}

template <class Mesh>
auto build(const Control_mesh& control, Mesh& mesh)
{
  mesh_cases::build(control, mesh);
  auto normals = get(CGAL::dynamic_vertex_property_t<Vector_3>(), mesh);
  mesh_cases::put_normals(control.normals, mesh, normals);
  return normals;
}

template <class Mesh>
auto crease_map(const Shape& shape, Mesh& mesh) // the map of a constant mesh could not grow
{
  auto map = get(CGAL::dynamic_edge_property_t<double>(), mesh);
  std::map<typename boost::graph_traits<Mesh>::vertex_descriptor, int> index;
  for (auto v : vertices(mesh)) index.emplace(v, int(index.size()));
  for (auto e : edges(mesh)) {
    const auto it = shape.creases.find({index.at(source(e, mesh)), index.at(target(e, mesh))});
    put(map, e, it == shape.creases.end() ? 0. : it->second);
  }
  return map;
}

// --- counts ---

struct Counts
{
  long vertices = 0, edges = 0, faces = 0, border_edges = 0, border_loops = 0;
  bool operator==(const Counts& c) const
  {
    return vertices == c.vertices && edges == c.edges && faces == c.faces &&
           border_edges == c.border_edges && border_loops == c.border_loops;
  }
  friend std::ostream& operator<<(std::ostream& out, const Counts& c)
  {
    return out << c.vertices << " vertices, " << c.edges << " edges, " << c.faces << " faces, "
               << c.border_edges << " border edges in " << c.border_loops << " loops";
  }
};

struct Old_mesh
{
  Counts counts;
  long corners = 0, isolated = 0, border_vertices = 0;
  long faces_at_border = 0;              // with a border edge
  long interior_edge_ends_on_border = 0; // counted once for each end
};

inline Old_mesh measure(const Surface_mesh& mesh)
{
  Old_mesh old;
  Counts& c = old.counts;
  c = {long(mesh.number_of_vertices()), long(mesh.number_of_edges()), long(mesh.number_of_faces())};
  std::set<Surface_mesh::Halfedge_index> seen;
  std::set<Surface_mesh::Face_index> at_border;
  for (auto h : mesh.halfedges()) {
    if (!mesh.is_border(h)) {
      ++old.corners;
      if (mesh.is_border(mesh.opposite(h)))
        at_border.insert(mesh.face(h));
      else if (mesh.is_border(mesh.target(h)))
        ++old.interior_edge_ends_on_border;
      continue;
    }
    ++c.border_edges;
    if (!seen.insert(h).second) continue;
    ++c.border_loops;
    for (auto g = mesh.next(h); g != h; g = mesh.next(g)) seen.insert(g);
  }
  old.faces_at_border = long(at_border.size());
  for (auto v : mesh.vertices()) {
    old.isolated += mesh.is_isolated(v);
    old.border_vertices += !mesh.is_isolated(v) && mesh.is_border(v);
  }
  return old;
}

// What a round makes of a mesh, by counting.
template <class Description>
Counts predicted(const Old_mesh& old, unsigned round)
{
  const auto& [v, e, f, b, loops] = old.counts;
  const long interior_edges = e - b;
  if constexpr (is_dual<Description>) {
    const long interior_vertices = v - old.isolated - old.border_vertices;
    return {old.corners, old.corners + 2 * interior_edges, f + interior_edges + interior_vertices,
            b + old.interior_edge_ends_on_border, loops};
  } else if constexpr (is_sqrt3<Description>) {
    if (round % 2 == 1) return {v + f, e + 3 * f, 3 * f, b, loops};
    // a border triangle becomes three with one side on the border each, all others give a centroid
    const long inner = f - old.faces_at_border;
    const long faces = 3 * inner + 3 * old.faces_at_border;
    return {v + inner + 2 * old.faces_at_border, (3 * faces + 3 * b) / 2, faces, 3 * b, loops};
  } else if (Description::degree == 3)
    return {v + e, 2 * e + 3 * f, 4 * f, 2 * b, loops};
  else
    return {v + e + f, 2 * e + old.corners, old.corners, 2 * b, loops};
}

// --- what must hold of a result ---

template <class Map>
void expect_finite(const Surface_mesh& mesh, Map normals)
{
  for (auto v : mesh.vertices()) {
    const auto& p = mesh.point(v);
    const auto& n = get(normals, v);
    ASSERT_TRUE(std::isfinite(p.x() + p.y() + p.z() + n.x() + n.y() + n.z())) << v;
    const double length = n.squared_length();
    ASSERT_TRUE(length == 0 || std::abs(length - 1) < 1e-14) << v << ": |n|^2 = " << length;
  }
}

template <class Description>
class Named_shapes : public testing::Test
{};
TYPED_TEST_SUITE_P(Named_shapes);

// A valid manifold with the faces, the border and the Euler characteristic that the host predicts; no NaN.
TYPED_TEST_P(Named_shapes, AreRefinedToTheManifoldsThatTheHostPredicts)
{
  for_each_case<TypeParam>([](const Shape&, const Control_mesh& control, Normals n) {
    Surface_mesh mesh = to_surface_mesh(control);
    for (unsigned round = 1; round <= 2; ++round) {
      if (is_sqrt3<TypeParam> && round == 2) { // which counts its rounds within one call
        mesh = to_surface_mesh(control);
        Surface_mesh once = mesh;
        subdivide<TypeParam>(once, normal_map(once), n, 1);
        const Counts expected = predicted<TypeParam>(measure(once), 2);
        subdivide<TypeParam>(mesh, normal_map(mesh), n, 2);
        EXPECT_EQ(measure(mesh).counts, expected);
      } else {
        const Old_mesh old = measure(mesh);
        subdivide<TypeParam>(mesh, normal_map(mesh), n, 1);
        EXPECT_EQ(measure(mesh).counts, predicted<TypeParam>(old, 1)) << "round " << round;
        EXPECT_EQ(euler_characteristic(mesh), old.counts.vertices - old.counts.edges +
                                                old.counts.faces -
                                                (TypeParam::is_primal ? 0 : old.isolated));
      }
      EXPECT_TRUE(is_valid_manifold(mesh)) << "round " << round;
      if (n == Normals::linear) // has written no normals
        for (auto v : mesh.vertices()) put(normal_map(mesh), v, CGAL::NULL_VECTOR);
      expect_finite(mesh, normal_map(mesh));
    }
  });
}

TYPED_TEST_P(Named_shapes, HaveTheSameBitsAsPolyhedra)
{
  for_each_case<TypeParam>([](const Shape&, const Control_mesh& control, Normals n) {
    if (control.points.size() > 200) return;
    Surface_mesh a;
    Polyhedron b;
    const auto na = build(control, a);
    const auto nb = build(control, b);
    subdivide<TypeParam>(a, na, n, 2);
    subdivide<TypeParam>(b, nb, n, 2);
    EXPECT_TRUE(mesh_cases::is_linked(b));
    EXPECT_EQ(mesh_cases::points(a), mesh_cases::points(b));
    EXPECT_EQ(mesh_cases::faces_of(a), mesh_cases::faces_of(b));
    if (n != Normals::linear) {
      EXPECT_EQ(mesh_cases::values(a, na), mesh_cases::values(b, nb));
    }
  });
}

// The three evaluators: subdivide(), the matrix of the scheme with the rule in its matrix form, and the textbook's
// form of the scheme, which shares nothing with the package.
TYPED_TEST_P(Named_shapes, GiveOneResultByThreeEvaluators)
{
  for (const Shape& shape : all()) {
    if (is_refused<TypeParam>(shape.mesh) || shape.mesh.points.size() > 200) continue;
    if (TypeParam::degree == 3 && has_interior_valence_2(shape.mesh))
      continue; // two edges with the same ends
    Surface_mesh old = to_surface_mesh(with_normals(shape.mesh, Normals::linear));
    const reference::Face_list list = ::face_list(old);
    const reference::Refined textbook = TypeParam::refine(list, 1);
    const reference::Matrix weights = textbook.weights(list.number_of_vertices());
    const Eigen::MatrixXd matrix = PN::subdivision_matrix(old, TypeParam::scheme());
    ASSERT_EQ(matrix.rows(), weights.rows()) << shape.mesh.name;
    EXPECT_LE(double((matrix.cast<reference::Real>() - weights).cwiseAbs().maxCoeff()), 4e-15)
      << shape.mesh.name;
    for (Normals n : all_normals) {
      SCOPED_TRACE(shape.mesh.name + ", normals " + name_of(n));
      Surface_mesh mesh = to_surface_mesh(with_normals(shape.mesh, n));
      Result expected = result_of(mesh);
      expected.values = n == Normals::linear ? linear_round(weights, expected.values)
                                             : pn_round(weights, expected.values);
      expected.faces = textbook.faces;
      subdivide<TypeParam>(mesh, normal_map(mesh), n, 1);
      if (n == Normals::linear)
        for (auto v : mesh.vertices()) put(normal_map(mesh), v, CGAL::NULL_VECTOR);
      EXPECT_TRUE(is_within(difference_by_index(result_of(mesh), expected), 1e-12));
    }
  }
}

// CGAL's mask and host with PN_mask_3, where CGAL has the scheme.
TYPED_TEST_P(Named_shapes, EqualPnMasksInHostsOfCgal)
{
  if constexpr (has_cgal_peer<TypeParam>) {
    for_each_case<TypeParam>([](const Shape&, const Control_mesh& control, Normals n) {
      if (n == Normals::linear || has_isolated_vertex(control) || control.points.size() > 200)
        return;
      if (TypeParam::degree == 3 && has_interior_valence_2(control))
        return; // two edges with the same ends
      Surface_mesh ours = to_surface_mesh(control), cgal = ours;
      subdivide<TypeParam>(ours, normal_map(ours), n, 1);
      const auto map = PN::Zipped_point_normal_map(get(CGAL::vertex_point, cgal), normal_map(cgal));
      TypeParam::Cgal::host(cgal, TypeParam::Cgal::mask(cgal, map), np::vertex_point_map(map));
      const Result a = result_of(ours), b = result_of(cgal);
      // the vertices of primal schemes are in the same order
      const Difference d = TypeParam::is_primal ? difference_by_index(a, b) : difference(a, b);
      EXPECT_TRUE(is_within(d, 1e-12));
    });
  } else
    GTEST_SKIP() << "does not apply: CGAL has no such mask";
}

// Creases change values, not faces; a mesh whose tags are all 0 is a mesh without tags.
TYPED_TEST_P(Named_shapes, WithCreasesAreRefinedAsWithoutThem)
{
  if constexpr (PN::internal::Has_crease_rules<Scheme_of<TypeParam>>::value) {
    std::size_t changed = 0;
    for_each_case<TypeParam>([&](const Shape& shape, const Control_mesh& control, Normals n) {
      if (n == Normals::linear || control.points.size() > 200) return;
      Surface_mesh plain, creased;
      Polyhedron polyhedron;
      const auto n_plain = build(control, plain);
      const auto n_creased = build(control, creased);
      const auto n_polyhedron = build(control, polyhedron);
      const auto run = [&](auto& mesh, auto normals) {
        PN::subdivide(
          mesh, TypeParam::scheme(),
          np::number_of_iterations(2).vertex_normal_map(normals).edge_is_constrained_map(
            crease_map(shape, mesh)));
      };
      subdivide<TypeParam>(plain, n_plain, n, 2);
      run(creased, n_creased);
      run(polyhedron, n_polyhedron);
      EXPECT_TRUE(is_valid_manifold(creased));
      EXPECT_EQ(measure(creased).counts, measure(plain).counts);
      EXPECT_EQ(mesh_cases::faces_of(creased), mesh_cases::faces_of(plain));
      EXPECT_EQ(mesh_cases::points(creased), mesh_cases::points(polyhedron));
      const bool is_same = mesh_cases::points(creased) == mesh_cases::points(plain);
      if (shape.creases.empty()) {
        EXPECT_TRUE(is_same);
        EXPECT_EQ(mesh_cases::values(creased, n_creased), mesh_cases::values(plain, n_plain));
      }
      changed += !is_same;
      for (const Triple& p : mesh_cases::points(creased))
        ASSERT_TRUE(std::isfinite(p[0] + p[1] + p[2]));
    });
    EXPECT_GE(changed, 10u);
  } else
    GTEST_SKIP() << "does not apply: has no rules for creases";
}

// Shapes that a scheme cannot take are refused and stay as they were.
TYPED_TEST_P(Named_shapes, ThatDoNotSuitTheSchemeAreRefusedUntouched)
{
  for (const Shape& shape : all()) {
    if (!is_refused<TypeParam>(shape.mesh)) continue;
    Surface_mesh mesh = to_surface_mesh(with_normals(shape.mesh, Normals::random)), old = mesh;
    EXPECT_THROW(subdivide<TypeParam>(mesh, normal_map(mesh), Normals::random, 1),
                 std::invalid_argument)
      << shape.mesh.name;
    EXPECT_TRUE(is_identical(mesh, old)) << shape.mesh.name;
  }
}

REGISTER_TYPED_TEST_SUITE_P(Named_shapes, AreRefinedToTheManifoldsThatTheHostPredicts,
                            HaveTheSameBitsAsPolyhedra, GiveOneResultByThreeEvaluators,
                            EqualPnMasksInHostsOfCgal, WithCreasesAreRefinedAsWithoutThem,
                            ThatDoNotSuitTheSchemeAreRefusedUntouched);

} // namespace named_shapes

#endif // CGAL_PN_SUBDIVISION_3_TEST_SUITE_NAMED_SHAPES_H

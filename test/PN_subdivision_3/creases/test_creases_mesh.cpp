// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Creases of meshes: what is read, written and refused.

#include "Messages.h"
#include "Tagged_meshes.h"
#include "analysis/subdivision_matrix.h"

#include <CGAL/PN_subdivision_3/detect_creases.h>
#include <CGAL/PN_subdivision_3/estimate_control_normals.h>
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#include <CGAL/PN_subdivision_3/schemes/Bilinear_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Butterfly_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/DooSabin_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Kobbelt_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Midpoint_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Sqrt3_scheme.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh.h>

#include <random>

namespace {

using namespace tagged_meshes;
using PN::internal::sharpness_of;

using Surface_mesh = CGAL::Surface_mesh<Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;

TEST(Creases_of_meshes, Are_those_of_levels_for_all_kinds_of_meshes)
{
  Control polygons = tagged_washer();
  // what less than one round is left of in the first round is another matter for meshes
  for (auto& edge : polygons.sharp_edges)
    if (edge.second > 0 && edge.second < 1) edge.second += 1;
  for (auto& vertex : polygons.sharp_vertices)
    if (vertex.second > 0 && vertex.second < 1) vertex.second += 1;
  const Control triangles = triangulated(polygons);
  const State expected = state(polygons, PN::CatmullClark_scheme(), 3);
  Tagged<Surface_mesh> a(polygons);
  a.subdivide(PN::CatmullClark_scheme(), 3);
  EXPECT_TRUE(state(a) == expected);
  Tagged<Polyhedron> b(polygons);
  b.subdivide(PN::CatmullClark_scheme(), 3);
  EXPECT_TRUE(state(b) == expected);
  EXPECT_TRUE(mesh_cases::is_linked(b.mesh));
  Tagged<Surface_mesh> c(triangles);
  c.subdivide(PN::Loop_scheme(), 2);
  EXPECT_TRUE(state(c) == state(triangles, PN::Loop_scheme(), 2));
}

// removed vertices, edges and faces, fewer than a round adds
TEST(Creases_of_meshes, Keep_the_indices_of_meshes_with_garbage)
{
  const Control control = tagged_washer();
  Tagged<Surface_mesh> plain(control), with_garbage(control);
  Surface_mesh& mesh = with_garbage.mesh;
  mesh.remove_vertex(mesh.add_vertex(Point_3(9, 9, 9)));
  const auto f = mesh.add_face(mesh.add_vertex(Point_3(9, 9, 9)), mesh.add_vertex(Point_3(9, 8, 9)),
                               mesh.add_vertex(Point_3(8, 9, 9)));
  for (auto e : mesh.edges()) // what is removed is sharp
    if (mesh.is_border(e)) put(with_garbage.sharp, e, 5);
  CGAL::Euler::remove_center_vertex(CGAL::Euler::add_center_vertex(mesh.halfedge(f), mesh), mesh);
  CGAL::Euler::remove_face(mesh.halfedge(*std::prev(mesh.faces().end())), mesh);
  EXPECT_EQ(mesh.number_of_faces(), plain.mesh.number_of_faces());
  EXPECT_GE(mesh.number_of_removed_edges(), 6u);
  plain.subdivide(PN::CatmullClark_scheme(), 2);
  with_garbage.subdivide(PN::CatmullClark_scheme(), 2);
  EXPECT_TRUE(mesh.has_garbage());
  EXPECT_TRUE(state(plain) == state(with_garbage));
}

#ifdef CGAL_LINKED_WITH_TBB
// more creases than one thread takes at a time
TEST(Creases_of_meshes, Are_the_same_in_parallel)
{
  Control control;
  const int n = 36;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      control.points.push_back({double(i), double(j), std::sin(0.7 * i) * std::cos(0.9 * j)});
      if (i == 0 || j == 0) continue;
      control.faces.push_back({n * (i - 1) + j - 1, n * i + j - 1, n * i + j, n * (i - 1) + j});
    }
  int k = 0;
  for (const Face& f : control.faces)
    for (std::size_t i = 0; i < 4; ++i)
      control.sharp_edges[undirected(f[i], f[(i + 1) % 4])] = 0.3 * (++k % 11);
  Tagged<Surface_mesh> one(control), several(control);
  one.subdivide(PN::CatmullClark_scheme(), 2);
  several.subdivide<PN::CatmullClark_scheme, CGAL::Parallel_tag>(PN::CatmullClark_scheme(), 2);
  EXPECT_TRUE(state(one) == state(several));
}
#endif

TEST(Creases_of_meshes, One_call_is_several_calls)
{
  // wedge normals that differ give the tangents again
  Part part = washer();
  part.place();
  Control c = part.control();
  for (auto& edge : c.sharp_edges) edge.second = 3; // nothing ends before the last round
  Tagged<Surface_mesh> once(c), thrice(c);
  once.subdivide(PN::CatmullClark_scheme(), 3);
  for (int k = 0; k < 3; ++k) thrice.subdivide(PN::CatmullClark_scheme(), 1);
  const State a = state(once), b = state(thrice);
  EXPECT_EQ(a.sharp, b.sharp);
  ASSERT_EQ(a.points.size(), b.points.size());
  const double bar = 8 * std::numeric_limits<double>::epsilon();
  for (std::size_t v = 0; v < a.points.size(); ++v)
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(a.points[v][k], b.points[v][k], bar * double(part.scale()));
  for (const auto& [corner, n] : a.normals)
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(n[k], b.normals.at(corner)[k], 2 * bar);
}

TEST(Creases_of_meshes, Prisms_need_points_and_tags_only)
{
  Part part = capped_cylinder(uneven(7));
  part.place();
  Tagged<Surface_mesh> t(part.control(false));
  auto sharp = t.mesh.add_property_map<Surface_mesh::Edge_index, bool>("e:sharp", true).first;
  EXPECT_EQ(PN::detect_creases(t.mesh, 75, sharp), 14u);
  for (auto e : t.mesh.edges()) EXPECT_EQ(sharp[e], get(t.sharp, e) > 0);
  auto estimated = t.mesh.add_property_map<Surface_mesh::Halfedge_index, Vector_3>("h:n").first;
  PN::estimate_control_normals(t.mesh, estimated, CGAL::parameters::edge_is_constrained_map(sharp));
  const double epsilon = std::numeric_limits<double>::epsilon();
  const auto error = [&](const Surface& s, const Point_3& p, const Vector_3& n) {
    const Vector q(p.x(), p.y(), p.z()), m(n.x(), n.y(), n.z());
    return double((m - s.normal(q)).norm());
  };
  // the rims; the ring of the side between them has no creases
  for (auto h : t.mesh.halfedges()) {
    const auto v = t.mesh.target(h);
    if (v.idx() >= 7 && v.idx() < 14) continue;
    EXPECT_LE(error(part.surfaces[part.group[t.mesh.face(h)]], t.mesh.point(v), estimated[h]),
              16 * epsilon);
  }
  PN::subdivide(t.mesh, PN::CatmullClark_scheme(),
                np::number_of_iterations(3).edge_is_constrained_map(sharp));
  std::size_t number = 0;
  for (auto e : t.mesh.edges()) number += sharp[e];
  EXPECT_EQ(number, 14u * 8);
  for (auto e : t.mesh.edges())
    if (sharp[e])
      for (int i = 0; i < 2; ++i) {
        const Point_3 p = t.mesh.point(t.mesh.vertex(e, unsigned(i)));
        EXPECT_LE(part.surfaces[0].distance(Vector(p.x(), p.y(), p.z())),
                  8 * epsilon * part.scale());
      }
}

// a straight prism as a new user has it: points, creases by their angle, calls one after the other
template <class Mesh, class Value, class Scheme>
void expect_cylinder(const Control& control, const Part& part, const Scheme& scheme)
{
  Tagged<Mesh> t(control);
  const auto sharp = get(CGAL::dynamic_edge_property_t<Value>(), t.mesh);
  EXPECT_EQ(PN::detect_creases(t.mesh, 75, sharp), 14u);
  PN::subdivide(t.mesh, scheme, np::edge_is_constrained_map(sharp));
  PN::subdivide(t.mesh, scheme, np::edge_is_constrained_map(sharp).number_of_iterations(2));
  std::size_t number = 0;
  for (auto e : edges(t.mesh)) number += sharpness_of(get(sharp, e)) > 3;
  EXPECT_EQ(number, 14u * 8);
  const Real bar = 8 * std::numeric_limits<double>::epsilon() * part.scale();
  const auto points = get(CGAL::vertex_point, t.mesh);
  int on_side = 0;
  for (auto v : vertices(t.mesh)) {
    const Triple x = triple(get(points, v));
    const Vector p(x[0], x[1], x[2]);
    const auto off = [&](int k) { return part.surfaces[std::size_t(k)].distance(p); };
    on_side += off(0) <= bar;
    EXPECT_LE((std::min)(off(0), (std::min)(off(1), off(2))), bar);
  }
  EXPECT_GE(on_side, 14 * 8 + 7 * 8);
}

TEST(Creases_of_meshes, Straight_prisms_become_cylinders)
{
  Part part;
  const Ring a = part.ring(1, 0, uneven(7)), b = part.ring(1, 2, uneven(7));
  part.tube(part.add(upright_cylinder(1)), a, b);
  part.face(part.add(plane(0, -1)), a);
  part.face(part.add(plane(2, 1)), b);
  part.place();
  const Control c = part.control(false);
  expect_cylinder<Surface_mesh, double>(c, part, PN::CatmullClark_scheme());
  expect_cylinder<Surface_mesh, int>(triangulated(c), part, PN::Loop_scheme());
  expect_cylinder<Polyhedron, bool>(triangulated(c), part, PN::Loop_scheme());
}

TEST(Creases_of_meshes, A_map_of_vertices_gives_the_mean_of_the_wedges)
{
  const Control control = crease_shapes::cube().control();
  Tagged<Surface_mesh> t(control);
  auto normals = t.mesh.add_property_map<Surface_mesh::Vertex_index, Vector_3>("v:n").first;
  for (auto v : t.mesh.vertices()) normals[v] = Vector_3(0, 0, 7); // not used at corners
  PN::subdivide(t.mesh, PN::CatmullClark_scheme(),
                np::edge_is_constrained_map(t.sharp).vertex_normal_map(normals));
  for (auto v : t.mesh.vertices()) {
    const Point_3& p = t.mesh.point(v);
    const Vector_3& n = normals[v];
    int on_sides = 0;
    for (int k = 0; k < 3; ++k) on_sides += p[k] == 0 || p[k] == 1;
    for (int k = 0; k < 3; ++k) {
      const double share = p[k] == 0 ? -1 : p[k] == 1 ? 1 : 0;
      EXPECT_NEAR(n[k], share / std::sqrt(double(on_sides)), 1e-15);
    }
  }
}

// bit for bit: the normals of both sides are estimated
TEST(Creases_of_meshes, A_map_of_vertices_is_not_used_on_creases)
{
  const Control control = capped_cylinder(uneven(7)).control();
  const auto refined = [&](const Vector_3& on_creases) {
    Tagged<Surface_mesh> t(control);
    auto normals = t.mesh.add_property_map<Surface_mesh::Vertex_index, Vector_3>("v:n").first;
    for (auto h : t.mesh.halfedges()) normals[t.mesh.target(h)] = get(t.normals, h);
    for (auto e : t.mesh.edges())
      if (get(t.sharp, e) > 0)
        for (const unsigned i : {0u, 1u}) normals[t.mesh.vertex(e, i)] = on_creases;
    PN::subdivide(t.mesh, PN::CatmullClark_scheme(),
                  np::edge_is_constrained_map(t.sharp).vertex_normal_map(normals));
    return state(t).points;
  };
  EXPECT_EQ(refined(Vector_3(0, 0, 1)), refined(Vector_3(1, 0, 0)));
}

// the corners of a cube have the normals of its sides, and no creases
TEST(Creases_of_meshes, Normals_of_one_wedge_count_as_their_sum)
{
  const Control control = crease_shapes::cube().control();
  Tagged<Surface_mesh> sides(control), sums(control);
  for (auto h : sums.mesh.halfedges()) {
    const Point_3& p = sums.mesh.point(sums.mesh.target(h));
    put(sums.normals, h, Vector_3(2 * p.x() - 1, 2 * p.y() - 1, 2 * p.z() - 1));
  }
  for (Tagged<Surface_mesh>* t : {&sides, &sums})
    PN::subdivide(t->mesh, PN::CatmullClark_scheme(), np::vertex_normal_map(t->normals));
  for (auto v : sides.mesh.vertices())
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(sides.mesh.point(v)[k], sums.mesh.point(v)[k], 1e-15);
}

// bit for bit
TEST(Creases_of_meshes, Cubes_stay_cubes)
{
  Tagged<Surface_mesh> t(crease_shapes::cube().control());
  t.subdivide(PN::CatmullClark_scheme(), 4);
  for (auto f : t.mesh.faces()) {
    const Vector_3 first = get(t.normals, t.mesh.halfedge(f));
    EXPECT_EQ(std::abs(first.x()) + std::abs(first.y()) + std::abs(first.z()), 1);
    for (auto h : t.mesh.halfedges_around_face(t.mesh.halfedge(f))) {
      EXPECT_EQ(get(t.normals, h), first);
      const Point_3& p = t.mesh.point(t.mesh.target(h));
      EXPECT_EQ((p - CGAL::ORIGIN) * first, first.x() + first.y() + first.z() > 0 ? 1 : 0);
      for (int k = 0; k < 3; ++k) EXPECT_EQ(p[k] * 16, std::round(p[k] * 16));
    }
  }
}

TEST(Creases_of_meshes, Border_rules)
{
  Part part = ball_cap();
  const Real z = part.of_border[0].point[2];
  const auto farthest = [&](PN::Border border) {
    Tagged<Surface_mesh> t(part.control());
    PN::subdivide(t.mesh, PN::internal::with_border(PN::CatmullClark_scheme(), border),
                  np::number_of_iterations(3).vertex_normal_map(t.normals));
    double greatest = 0;
    for (auto v : t.mesh.vertices())
      if (t.mesh.is_border(v))
        greatest =
          (std::max)(greatest, std::hypot(double(t.mesh.point(v).z() - z),
                                          std::hypot(t.mesh.point(v).x(), t.mesh.point(v).y()) -
                                            std::cos(0.3)));
    return greatest;
  };
  EXPECT_LE(farthest(PN::Border::curve), 1e-15);
  EXPECT_GE(farthest(PN::Border::surface), 0.05);
  EXPECT_GE(farthest(PN::Border::fixed), 0.05);
  Tagged<Surface_mesh> t(part.control());
  PN::subdivide(t.mesh, PN::internal::with_border(PN::CatmullClark_scheme(), PN::Border::fixed),
                np::number_of_iterations(1).vertex_normal_map(t.normals));
  for (std::size_t i = 0; i < part.points.size(); ++i)
    if (const Surface_mesh::Vertex_index v(static_cast<unsigned>(i)); t.mesh.is_border(v)) {
      EXPECT_EQ(t.mesh.point(v), Point_3(double(part.points[i][0]), double(part.points[i][1]),
                                         double(part.points[i][2])));
    }
}

// a map that cannot be written: the same surface
struct All_edges_are_sharp
{
  using key_type = Surface_mesh::Edge_index;
  using value_type = bool;
  using reference = bool;
  using category = boost::readable_property_map_tag;
  friend bool get(const All_edges_are_sharp&, key_type) { return true; }
};

TEST(Creases_of_meshes, Of_maps_that_are_only_read)
{
  const Control control = crease_shapes::cube().control(false);
  Tagged<Surface_mesh> read(control), written(control);
  PN::subdivide(read.mesh, PN::CatmullClark_scheme(),
                np::number_of_iterations(2).edge_is_constrained_map(All_edges_are_sharp()));
  PN::subdivide(written.mesh, PN::CatmullClark_scheme(),
                np::number_of_iterations(2).edge_is_constrained_map(written.sharp));
  EXPECT_EQ(state(read).points, state(written).points);
}

// \name Refusals
template <class Scheme>
void expect_refusal(const Control& control, const Scheme& scheme, const std::string& part)
{
  Tagged<Surface_mesh> t(control);
  const State before = state(t);
  messages::expect_refused(
    [&] {
      PN::subdivide(t.mesh, scheme,
                    np::edge_is_constrained_map(t.sharp).vertex_is_constrained_map(t.corners));
    },
    {part});
  EXPECT_TRUE(state(t) == before);
}

TEST(Creases_of_meshes, Refuse_sharpness_that_is_none)
{
  Control c = crease_shapes::cube().control();
  c.sharp_edges[{0, 1}] = -1;
  expect_refusal(c, PN::CatmullClark_scheme(), "the sharpness of the edge of half-edge ");
  c.sharp_edges[{0, 1}] = std::nan("");
  expect_refusal(c, PN::CatmullClark_scheme(), "not a number");
  c.sharp_edges[{0, 1}] = 1;
  c.sharp_vertices[5] = -0.5;
  expect_refusal(c, PN::CatmullClark_scheme(), "the sharpness of vertex 5 is negative");
  expect_refusal(c, PN::linear(PN::CatmullClark_scheme()), "vertex 5");
}

TEST(Creases_of_meshes, Are_refused_where_the_surface_is_none)
{
  // two fans that share their apex, all edges at it sharp
  Control c;
  c.points = {{0, 0, 0}};
  for (const double z : {1., -1.})
    for (const auto& [x, y] : {Edge{1, 0}, Edge{0, 1}, Edge{-1, 0}, Edge{0, -1}})
      c.points.push_back({double(x), double(y), z});
  for (int i = 1; i < 4; ++i) {
    c.faces.push_back({0, i, i + 1});
    c.faces.push_back({0, i + 5, i + 4});
  }
  for (int i = 1; i < 9; ++i) c.sharp_edges[{0, i}] = infinity;
  Tagged<Surface_mesh> t(c);
  const State before = state(t);
  messages::expect_refused([&] { t.subdivide(PN::CatmullClark_scheme(), 1); }, {"vertex 0"});
  messages::expect_refused([&] { PN::detect_creases(t.mesh, 30, t.sharp); }, {"vertex 0"});
  messages::expect_refused(
    [&] {
      PN::estimate_control_normals(t.mesh, t.normals,
                                   CGAL::parameters::edge_is_constrained_map(t.sharp));
    },
    {"vertex 0"});
  EXPECT_TRUE(state(t) == before);
}

TEST(Creases_of_meshes, Are_refused_by_schemes_without_rules_for_them)
{
  const Control quads = crease_shapes::cube().control();
  const Control triangles = triangulated(quads);
  // the first sharp edge and the scheme, also below adaptors
  const std::string edge = "the edge of half-edge 0 is sharp, but the scheme ";
  expect_refusal(quads, PN::DooSabin_scheme(), edge + "doo-sabin");
  expect_refusal(quads, PN::Kobbelt_scheme(), edge + "kobbelt");
  expect_refusal(triangles, PN::Butterfly_scheme(), edge + "butterfly");
  expect_refusal(triangles, PN::Midpoint_scheme(), edge + "midpoint");
  expect_refusal(quads, PN::Bilinear_scheme(), edge + "bilinear");
  expect_refusal(triangles, PN::linear(PN::Sqrt3_scheme()), edge + "sqrt3");
  Control corner = quads;
  corner.sharp_edges.clear();
  corner.sharp_vertices[2] = 1;
  expect_refusal(corner, PN::linear(PN::DooSabin_scheme()), "vertex 2 is sharp");
  expect_refusal(ball_cap().control(),
                 PN::internal::with_border(PN::Kobbelt_scheme(), PN::Border::curve), "is sharp");
  expect_refusal(ball_cap().control(),
                 PN::internal::with_border(PN::Bilinear_scheme(), PN::Border::curve), "is sharp");
  // nothing is sharp
  corner.sharp_vertices.clear();
  Tagged<Surface_mesh> t(corner);
  PN::subdivide(t.mesh, PN::DooSabin_scheme(), np::edge_is_constrained_map(t.sharp));
  EXPECT_EQ(t.mesh.number_of_vertices(), 24u);
}

// the weights of a round are not all there is to a crease
TEST(Creases_of_meshes, Are_refused_by_matrices)
{
  const Tagged<Surface_mesh> cap(ball_cap().control());
  const PN::Loop_scheme loop;
  const PN::CatmullClark_scheme cc;
  messages::expect_refused(
    [&] {
      PN::subdivision_matrix(cap.mesh,
                             PN::linear(PN::internal::with_border(cc, PN::Border::fixed)));
    },
    {"border makes the edge of half-edge "});
  const auto rows =
    PN::subdivision_matrix(cap.mesh, PN::internal::with_border(cc, PN::Border::surface));
  EXPECT_EQ(rows.cols(), Eigen::Index(cap.mesh.number_of_vertices()));
  // without a border there is nothing to refuse
  const Tagged<Surface_mesh> cube(triangulated(crease_shapes::cube().control()));
  EXPECT_EQ(
    PN::subdivision_matrix(cube.mesh, PN::internal::with_border(loop, PN::Border::curve)).rows(),
    26);
}

// whose inverses are no numbers; found by fuzzing
TEST(Creases_of_meshes, Of_denormal_length)
{
  const double tiny = std::numeric_limits<double>::denorm_min();
  for (const double x : {tiny, 1.}) {
    Surface_mesh mesh;
    const auto a = mesh.add_vertex(Point_3(0, 0, 0)), b = mesh.add_vertex(Point_3(tiny, tiny, 0)),
               c = mesh.add_vertex(Point_3(x, tiny, tiny));
    mesh.add_face(a, b, c);
    const auto sharp =
      mesh.add_property_map<Surface_mesh::Edge_index, double>("e:sharp", 1.5).first;
    PN::subdivide(mesh, PN::Loop_scheme(),
                  np::number_of_iterations(2).edge_is_constrained_map(sharp));
    for (auto v : mesh.vertices()) {
      const Point_3& p = mesh.point(v);
      EXPECT_TRUE(std::isfinite(p.x() + p.y() + p.z())) << x << ", " << v;
    }
  }
}

TEST(Creases_of_meshes, Angles_out_of_range)
{
  Tagged<Surface_mesh> t(crease_shapes::cube().control());
  auto sharp = t.mesh.add_property_map<Surface_mesh::Edge_index, bool>("e:sharp", true).first;
  for (const double angle : {-1., 181., std::nan("")})
    EXPECT_NE(messages::message_of([&] { PN::detect_creases(t.mesh, angle, sharp); }), "");
  EXPECT_EQ(PN::detect_creases(t.mesh, 89.8, sharp), 12u);
  EXPECT_EQ(PN::detect_creases(t.mesh, 89.95, sharp), 0u);
  EXPECT_EQ(PN::detect_creases(t.mesh, 90.1, sharp), 0u);
  EXPECT_EQ(PN::detect_creases(t.mesh, 180, sharp), 0u);
  for (auto e : t.mesh.edges()) EXPECT_FALSE(sharp[e]);
}

// a prism whose sides meet at this angle, in any pose: rounding does not decide
TEST(Creases_of_meshes, Edges_at_exactly_the_angle)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-3, 3);
  for (const int n : {5, 6, 8, 9, 10, 12, 18, 20, 24, 36})
    for (int pose = 0; pose < 12; ++pose) {
      const double a = uniform(random), b = uniform(random), shift = 10 * uniform(random);
      Control c;
      for (const double z : {0., 1.})
        for (int i = 0; i < n; ++i) {
          const double t = 2 * std::acos(-1.) * i / n;
          const double x = std::cos(t), y = std::cos(a) * std::sin(t) - std::sin(a) * z,
                       w = std::sin(a) * std::sin(t) + std::cos(a) * z;
          c.points.push_back(
            {std::cos(b) * x - std::sin(b) * y + shift, std::sin(b) * x + std::cos(b) * y, w});
        }
      Face low, high;
      for (int i = 0; i < n; ++i) {
        c.faces.push_back({i, (i + 1) % n, n + (i + 1) % n, n + i});
        low.push_back(n - 1 - i);
        high.push_back(n + i);
      }
      c.faces.push_back(low);
      c.faces.push_back(high);
      Tagged<Surface_mesh> t(c);
      const std::size_t rims = std::size_t(2 * n), all = std::size_t(3 * n);
      const double angle = 360. / n;
      EXPECT_EQ(PN::detect_creases(t.mesh, angle, t.sharp), rims) << n << ", pose " << pose;
      EXPECT_EQ(PN::detect_creases(t.mesh, angle - 0.05, t.sharp), rims);
      EXPECT_EQ(PN::detect_creases(t.mesh, angle - 0.15, t.sharp), all);
      EXPECT_EQ(PN::detect_creases(t.mesh, 90, t.sharp), 0u);
    }
}

// A tetrahedron with a triangle without area, but for rounding, between two sides, whose other one has a vertex on that edge.
TEST(Creases_of_meshes, Faces_without_area_have_no_angles)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0.1, 0.9);
  for (int pose = 0; pose < 100; ++pose) {
    const double x = uniform(random), y = uniform(random), z = uniform(random),
                 at = uniform(random);
    Control c;
    c.points = {{x, y, z}, {x + 1, y + z, 3 * z}, {-1, x, 1}, {0, y - 3, -2 * x}};
    Triple middle;
    for (std::size_t k = 0; k < 3; ++k) middle[k] = (1 - at) * c.points[0][k] + at * c.points[1][k];
    c.points.push_back(middle);
    c.faces = {{0, 1, 2}, {1, 0, 4}, {0, 3, 4}, {4, 3, 1}, {1, 3, 2}, {0, 2, 3}};
    Tagged<Surface_mesh> t(c);
    EXPECT_EQ(PN::detect_creases(t.mesh, 5, t.sharp), 5u)
      << pose; // but {0, 1}, {0, 4}, {4, 1} and {3, 4}
  }
}

// of all corners, with the weights that are asked for
TEST(Creases_of_meshes, Estimates_of_corners_by_angles)
{
  Part part = capped_cylinder(uneven(7));
  part.place();
  const Tagged<Surface_mesh> t(part.control(false));
  Surface_mesh mesh = t.mesh;
  auto corners = mesh.add_property_map<Surface_mesh::Halfedge_index, Vector_3>("h:n").first;
  auto plain = mesh.add_property_map<Surface_mesh::Vertex_index, Vector_3>("v:n").first;
  auto none = mesh.add_property_map<Surface_mesh::Edge_index, bool>("e:n", false).first;
  for (const auto estimate :
       {PN::Control_normal_estimate::angle, PN::Control_normal_estimate::reciprocal}) {
    const auto np = PN::parameters::control_normal_estimate(estimate);
    PN::estimate_control_normals(mesh, corners, np.edge_is_constrained_map(none));
    PN::estimate_control_normals(mesh, plain, PN::parameters::control_normal_estimate(estimate));
    for (auto h : mesh.halfedges()) EXPECT_EQ(corners[h], plain[mesh.target(h)]);
  }
}

} // namespace

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The tangents of creases in a map of the user's: read, written, refused. Several calls are one call.

#include "Crease_shapes.h"
#include "Messages.h"
#include "Random_creases.h"
#include "Tagged_meshes.h"
#include "reference/Crease_rule.h"

#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Tuned_CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Tuned_Loop_scheme.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_map/function_property_map.hpp>

namespace {

using namespace crease_shapes;
using namespace tagged_meshes;

using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;

// \name Meshes with tangents
template <class Mesh>
struct With_tangents : Tagged<Mesh>
{
  using Tangents = Dynamic_map<CGAL::dynamic_halfedge_property_t<Vector_3>, Mesh>;

  explicit With_tangents(const Control& control)
    : Tagged<Mesh>(control)
    , tangents(get(CGAL::dynamic_halfedge_property_t<Vector_3>(), this->mesh))
  {
    for (auto h : halfedges(this->mesh)) put(tangents, h, Vector_3(0, 0, 0));
  }

  // by source and target
  std::map<std::pair<int, int>, Triple> all_tangents() const
  {
    std::map<typename boost::graph_traits<Mesh>::vertex_descriptor, int> index;
    for (auto v : vertices(this->mesh)) index.emplace(v, int(index.size()));
    std::map<std::pair<int, int>, Triple> result;
    for (auto h : halfedges(this->mesh))
      result[{index[source(h, this->mesh)], index[target(h, this->mesh)]}] =
        triple(get(tangents, h));
    return result;
  }

  Tangents tangents;
};

// n calls with one round each, or as many rounds in one call
template <class Mesh, class Scheme>
void expect_calls_are_rounds(const Control& control, const Scheme& scheme, unsigned n)
{
  With_tangents<Mesh> once(control), often(control);
  const auto with_tangents = [&](const auto& t) {
    return PN::internal::with_border(PN::internal::with_crease_tangents(scheme, t.tangents),
                                     control.border);
  };
  once.subdivide(with_tangents(once), n);
  for (unsigned k = 0; k < n; ++k) often.subdivide(with_tangents(often), 1);
  EXPECT_TRUE(state(once) == state(often));
  EXPECT_TRUE(once.all_tangents() == often.all_tangents());
}

void expect_calls_are_rounds(const Control& control, unsigned n = 3)
{
  expect_calls_are_rounds<Surface_mesh>(control, PN::CatmullClark_scheme(), n);
  expect_calls_are_rounds<Surface_mesh>(triangulated(control), PN::Loop_scheme(), n);
}

// Where edges end each wedge of a vertex has a roundness of its own, of which a map of vertices holds one: with
// several of them a further call does not go on from where the last one was, unless the scheme is linear.
void expect_linear_calls_are_rounds(const Control& control, unsigned n)
{
  const auto scheme =
    PN::internal::with_border(PN::linear(PN::CatmullClark_scheme()), control.border);
  Tagged<Surface_mesh> once(control), often(control);
  once.subdivide(scheme, n);
  for (unsigned k = 0; k < n; ++k) often.subdivide(scheme, 1);
  EXPECT_TRUE(state(once).points == state(often).points);
  EXPECT_TRUE(state(once).sharp == state(often).sharp);
}

// the sharpness of some edges and vertices becomes finite, with all kinds of fractions
Control semi_sharp(Control c)
{
  const double values[] = {0.4, 1, infinity, 1.3, 2.6, infinity, 2, 0.7};
  std::size_t k = 0;
  for (auto& edge : c.sharp_edges) edge.second = values[k++ % 8];
  for (int v = 0; v < int(c.points.size()); v += 5) c.sharp_vertices[v] = values[k++ % 8];
  return c;
}

TEST(Crease_tangents, Calls_are_rounds_on_the_parts)
{
  for (const Part& part : {capped_cylinder(uneven(7)), half_ball(), lens(), bullet(), washer(),
                           countersink(), d_section(), rounded_box(), bolt()}) {
    expect_calls_are_rounds(part.control(), 2);
    expect_linear_calls_are_rounds(semi_sharp(part.control()), 2);
  }
}

TEST(Crease_tangents, Calls_are_rounds_for_all_borders)
{
  for (const Border border : {Border::surface, Border::curve, Border::corners, Border::fixed})
    for (const Part& part : {ball_cap(), plate_with_hole(), octant()}) {
      Control c = part.control();
      c.border = border;
      expect_calls_are_rounds(c);
      c.sharp_edges[undirected(c.faces[0][0], c.faces[0][1])] = 1.4;
      c.sharp_edges[undirected(c.faces[0][1], c.faces[0][2])] = infinity;
      expect_calls_are_rounds(c);
    }
}

TEST(Crease_tangents, Calls_are_rounds_with_random_creases)
{
  std::mt19937 random(7);
  for (int k = 0; k < 6; ++k) {
    Control c = k % 2 == 0 ? random_creases::box() : random_creases::patch();
    random_creases::perturb(c, random);
    Control ending = c;
    random_creases::tag(c, random, 0.5, {infinity});
    random_creases::tag(ending, random, 0.5, {0.5, 1, 1.7, 2.2, infinity});
    random_creases::give_normals(c, random);
    expect_linear_calls_are_rounds(ending, 3);
    expect_calls_are_rounds<Surface_mesh>(c, PN::CatmullClark_scheme(), 3);
    expect_calls_are_rounds<Polyhedron>(c, PN::CatmullClark_scheme::Tuned(), 2);
    expect_calls_are_rounds<Surface_mesh>(triangulated(c), PN::Loop_scheme::Tuned(), 3);
  }
}

// \name What is given
Control cylinder()
{
  Part part = capped_cylinder(uneven(7));
  part.place();
  return part.control();
}

// the ring 0, 1, ..., 6 is the lower rim: tangents that leave its plane and are not those of the circle
Triple slanted(int v)
{
  Triple t{std::sin(0.9 * v + 1), std::cos(0.7 * v), 0.3 + 0.1 * v};
  const double length = std::sqrt(t[0] * t[0] + t[1] * t[1] + t[2] * t[2]);
  for (double& x : t) x /= length;
  return t;
}

enum class Given { both, one_way, other_way };

void give(With_tangents<Surface_mesh>& t, Given given)
{
  for (auto h : t.mesh.halfedges()) {
    const int v = int(t.mesh.source(h)), w = int(t.mesh.target(h));
    if (v > 6 || w > 6 || !(get(t.sharp, t.mesh.edge(h)) > 0)) continue;
    const bool is_forward = w == (v + 1) % 7;
    if (given == (is_forward ? Given::other_way : Given::one_way)) continue;
    const Triple x = slanted(v);
    const double sign = is_forward ? 1 : -1;
    put(t.tangents, h, Vector_3(sign * x[0], sign * x[1], sign * x[2]));
  }
}

TEST(Crease_tangents, Those_that_are_given_are_used)
{
  const Control control = cylinder();
  With_tangents<Surface_mesh> t(control);
  give(t, Given::both);
  t.subdivide(PN::internal::with_crease_tangents(PN::CatmullClark_scheme(), t.tangents), 1);
  std::map<std::pair<int, int>, int> on_edge; // the new vertex between two old ones
  for (auto v : t.mesh.vertices()) {
    std::vector<int> ends;
    for (auto w : t.mesh.vertices_around_target(t.mesh.halfedge(v)))
      if (int(v) > 20 && int(w) < 7) ends.push_back(int(w));
    if (ends.size() == 2) on_edge[undirected(ends[0], ends[1])] = int(v);
  }
  const auto vector = [](const Triple& x) { return reference::Vector(x[0], x[1], x[2]); };
  const auto point = [&](int v) { return vector(control.points[std::size_t(v)]); };
  const auto expect_near = [&](int v, const reference::Crease_rule& rule) {
    const auto& p = t.mesh.point(Surface_mesh::Vertex_index(unsigned(v)));
    EXPECT_LE(double((vector(triple(p)) - rule.point()).norm()), 1e-15);
  };
  const auto now = t.all_tangents();
  for (int v = 0; v < 7; ++v) {
    const int a = (v + 6) % 7, b = (v + 1) % 7, m = on_edge.at(undirected(v, b));
    reference::Crease_entries edge, vertex;
    edge.weights = {reference::Real(0.5), reference::Real(0.5)};
    edge.points = {point(v), point(b)};
    edge.tangents = {vector(slanted(v)), vector(slanted(b))};
    vertex.weights = {reference::Real(0.125), reference::Real(0.125), reference::Real(0.75)};
    vertex.points = {point(a), point(b), point(v)};
    vertex.tangents = {vector(slanted(a)), vector(slanted(b)), vector(slanted(v))};
    const reference::Crease_rule of_edge(edge), of_vertex(vertex);
    expect_near(m, of_edge);
    expect_near(v, of_vertex);
    EXPECT_LE(double((vector(now.at({m, b})) - of_edge.tangent()).norm()), 1e-15);
    EXPECT_LE(double((vector(now.at({v, m})) - of_vertex.tangent()).norm()), 1e-15);
    EXPECT_LE(
      double((vector(now.at({v, on_edge.at(undirected(a, v))})) + of_vertex.tangent()).norm()),
      1e-15);
  }
}

template <class Scheme_of>
State refined(const Control& control, const Scheme_of& scheme_of)
{
  With_tangents<Surface_mesh> t(control);
  t.subdivide(scheme_of(t), 2);
  return state(t);
}

TEST(Crease_tangents, One_way_is_enough)
{
  const Control control = cylinder();
  const auto given = [&](Given g) {
    return refined(control, [&](auto& t) {
      give(t, g);
      return PN::internal::with_crease_tangents(PN::CatmullClark_scheme(), t.tangents);
    });
  };
  EXPECT_TRUE(given(Given::both) == given(Given::one_way));
  EXPECT_TRUE(given(Given::both) == given(Given::other_way));
}

TEST(Crease_tangents, None_given_are_made)
{
  const Control control = cylinder();
  const auto made = refined(control, [](auto&) { return PN::CatmullClark_scheme(); });
  const auto zero = refined(control, [](auto& t) {
    return PN::internal::with_crease_tangents(PN::CatmullClark_scheme(), t.tangents);
  });
  EXPECT_TRUE(made == zero);
}

TEST(Crease_tangents, Those_that_are_not_opposite_give_their_difference)
{
  const Control control = cylinder();
  const auto run = [&](const Vector_3& to_1, const Vector_3& to_6) {
    return refined(control, [&](auto& t) {
      const Surface_mesh::Vertex_index v(0);
      put(t.tangents, t.mesh.halfedge(v, Surface_mesh::Vertex_index(1)), to_1);
      put(t.tangents, t.mesh.halfedge(v, Surface_mesh::Vertex_index(6)), to_6);
      return PN::internal::with_crease_tangents(PN::CatmullClark_scheme(), t.tangents);
    });
  };
  const State kinked = run({0.6, 0.8, 0}, {0.6, -0.8, 0});
  EXPECT_TRUE(kinked == run({0, 1, 0}, {0, -1, 0}));
  EXPECT_FALSE(kinked == run({0.6, 0.8, 0}, {-0.6, -0.8, 0}));
}

TEST(Crease_tangents, A_map_that_cannot_be_written_is_read)
{
  const Control control = cylinder();
  const auto written = refined(control, [&](auto& t) {
    give(t, Given::both);
    return PN::internal::with_crease_tangents(PN::CatmullClark_scheme(), t.tangents);
  });
  const auto read = refined(control, [&](auto& t) {
    give(t, Given::both);
    const auto map = boost::make_function_property_map<Surface_mesh::Halfedge_index>(
      [tangents = t.tangents](Surface_mesh::Halfedge_index h) { return get(tangents, h); });
    return PN::internal::with_crease_tangents(PN::CatmullClark_scheme(), map);
  });
  EXPECT_TRUE(read == written);
}

TEST(Crease_tangents, Afterwards_they_are_those_of_the_creases)
{
  Control c = ball_cap().control();
  c.sharp_edges[undirected(c.faces[0][0], c.faces[0][1])] = 0.5; // on the border: for ever
  c.sharp_edges[undirected(c.faces[0][1], c.faces[0][2])] = 1.5; // over after two rounds
  for (const unsigned rounds : {1u, 2u}) {
    With_tangents<Surface_mesh> t(c);
    for (auto h : t.mesh.halfedges())
      if (!(get(t.sharp, t.mesh.edge(h)) > 0)) put(t.tangents, h, Vector_3(1, 0, 0)); // stale
    t.subdivide(PN::internal::with_crease_tangents(PN::CatmullClark_scheme(), t.tangents), rounds);
    int number = 0;
    for (auto h : t.mesh.halfedges()) {
      const bool is_crease = get(t.sharp, t.mesh.edge(h)) > 0;
      EXPECT_NEAR(get(t.tangents, h).squared_length(), is_crease ? 1 : 0, 1e-15);
      number += is_crease;
    }
    EXPECT_EQ(number, 8); // 4 and 4, then 8 of the border
  }
}

TEST(Crease_tangents, Are_nothing_to_a_linear_scheme)
{
  With_tangents<Surface_mesh> t(cylinder()), plain(cylinder());
  const Vector_3 nonsense(7, 8, std::nan(""));
  for (auto h : t.mesh.halfedges()) put(t.tangents, h, nonsense);
  t.subdivide(PN::linear(PN::internal::with_crease_tangents(PN::CatmullClark_scheme(), t.tangents)),
              1);
  plain.subdivide(PN::linear(PN::CatmullClark_scheme()), 1);
  EXPECT_TRUE(state(t).points == state(plain).points);
  EXPECT_EQ(get(t.tangents, Surface_mesh::Halfedge_index(0)).x(), 7);
}

TEST(Crease_tangents, Adaptors_nest_in_any_order)
{
  const Control c = ball_cap().control(false);
  const auto result = [&](const auto& scheme_of) {
    With_tangents<Surface_mesh> t(c);
    PN::subdivide(t.mesh, scheme_of(t.tangents), np::number_of_iterations(2));
    return std::make_pair(state(t).points, t.all_tangents());
  };
  const PN::CatmullClark_scheme cc;
  const auto angle = PN::Control_normal_estimate::angle;
  const auto a = result([&](auto t) {
    return PN::internal::with_normal_estimate(
      PN::internal::with_border(PN::internal::with_crease_tangents(cc, t), Border::curve), angle);
  });
  const auto b = result([&](auto t) {
    return PN::internal::with_crease_tangents(
      PN::internal::with_border(PN::internal::with_normal_estimate(cc, angle), Border::curve), t);
  });
  const auto other = result([&](auto t) {
    return PN::internal::with_crease_tangents(PN::internal::with_border(cc, Border::curve), t);
  });
  EXPECT_TRUE(a == b);
  EXPECT_FALSE(a.first == other.first); // the estimate counts
  // of two the outer one
  const auto outer = result([&](auto t) {
    return PN::internal::with_crease_tangents(
      PN::internal::with_border(PN::internal::with_border(cc, Border::fixed), Border::curve), t);
  });
  EXPECT_TRUE(outer == other);
}

// \name Refusals
void expect_refusal(const Vector_3& tangent, const std::string& part)
{
  With_tangents<Surface_mesh> t(cylinder());
  const Surface_mesh::Halfedge_index h =
    t.mesh.halfedge(Surface_mesh::Vertex_index(2), Surface_mesh::Vertex_index(3));
  put(t.tangents, h, tangent);
  const State before = state(t);
  messages::expect_refused(
    [&] {
      t.subdivide(PN::internal::with_crease_tangents(PN::CatmullClark_scheme(), t.tangents), 1);
    },
    {"the tangent of half-edge " + std::to_string(h.idx()) + part});
  EXPECT_TRUE(state(t) == before);
}

TEST(Crease_tangents, Are_refused_where_they_are_none)
{
  expect_refusal({0, std::nan(""), 0}, " is not finite");
  expect_refusal({0, std::numeric_limits<double>::infinity(), 0}, " is not finite");
  expect_refusal({0, 2, 0}, " is longer than 1");
  expect_refusal({0, 1 + 1e-9, 0}, " is longer than 1");
}

TEST(Crease_tangents, What_fails_leaves_all_as_it_was)
{
  int failures = 0;
  for (int left = 0;; left = left < 5 ? left + 1 : left * 3) {
    With_tangents<Surface_mesh> t(cylinder());
    give(t, Given::both);
    const State before = state(t);
    const auto tangents = t.all_tangents();
    failing_maps::Calls_left puts(left);
    try {
      t.subdivide(
        PN::internal::with_crease_tangents(PN::CatmullClark_scheme(), failing(t.tangents, puts)),
        1);
      break;
    } catch (const std::runtime_error&) {
      ++failures;
    }
    EXPECT_TRUE(state(t) == before) << left;
    EXPECT_TRUE(t.all_tangents() == tangents) << left;
  }
  EXPECT_GE(failures, 8);
}

} // namespace

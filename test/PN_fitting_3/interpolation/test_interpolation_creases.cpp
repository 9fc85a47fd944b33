// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
// Interpolation with creases that are sharp forever: limits of the control net, as subdivide_to_limit() has them, are the
// data. The limits are evaluated by another call, with the normals and tangents that were written.

#include "Extent.h"
#include "Feature_matrix.h"
#include "Messages.h"

#include <CGAL/PN_fitting_3/interpolate_limit_points.h>
#include <CGAL/PN_limit_surface_3/subdivide_to_limit.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Polyhedron_3.h>

namespace {

using namespace feature_matrix;
using Tangents = Mesh::Property_map<Mesh::Halfedge_index, Vector>;

constexpr const char* scheme_names[] = {"catmull-clark", "loop", "modified-catmull-clark",
                                        "modified-loop"};
constexpr Crease_kind kinds[] = {Crease_kind::none, Crease_kind::edges, Crease_kind::corners,
                                 Crease_kind::border};

auto points_mode()
{
  return PN::parameters::interpolation_mode(PN::Limit_interpolation::Mode::strict);
}

struct Tangled_case : Case
{
  Tangled_case(const std::string& name, Crease_kind creases)
    : Case(name, creases, Attribute_kind::none)
    , tangents(mesh.add_property_map<Mesh::Halfedge_index, Vector>("t", CGAL::NULL_VECTOR).first)
  {
    if (creases == Crease_kind::edges) sharpen_around_a_face();
    // a net that is no smooth surface's
    for (auto v : mesh.vertices()) {
      const auto p = mesh.point(v);
      mesh.point(v) = Kernel::Point_3(p.x(), p.y() + 0.1 * std::sin(3. * v.idx()),
                                      p.z() + 0.2 * std::cos(1. * v.idx()));
    }
  }

  template <class Np>
  auto with_sharp(const Np& np) const
  {
    return np.edge_is_constrained_map(sharpness).vertex_is_constrained_map(vertex_sharpness);
  }
  auto sharp() const { return with_sharp(points_mode()); }
  auto with_tangents() const { return with_sharp(points_mode().crease_tangent_map(tangents)); }

  Tangents tangents;

private:
  // a crease with vertices inside, and ends of other creases
  void sharpen_around_a_face()
  {
    for (auto h : halfedges_around_face(mesh.halfedge(Mesh::Face_index(0)), mesh))
      sharpness[mesh.edge(h)] = std::numeric_limits<double>::infinity();
  }
};

template <class Any_mesh, class Scheme, class Np>
void to_limit(Any_mesh& mesh, const Scheme& scheme, const Np& np)
{
  PN::subdivide_to_limit(
    mesh, scheme,
    PN::parameters::shared(PN::parameters::join(params::number_of_iterations(0), np)));
}

double size_of(const Case& c)
{
  CGAL::Bbox_3 box;
  for (auto v : c.mesh.vertices()) box += c.mesh.point(v).bbox();
  return std::max({box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin()});
}

double largest_distance(const std::vector<double>& a, const std::vector<double>& b)
{
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

template <class Scheme, class Np>
void expect_limits(Case& c, const Scheme& scheme, const Np& np)
{
  const std::vector<double> data = c.points();
  const auto report = PN::interpolate_limit_points(
    c.mesh, scheme, PN::parameters::join(PN::parameters::tolerance(1e-11), np));
  EXPECT_TRUE(report.is_within_tolerance()) << report.residual;
  EXPECT_GT(report.steps, 0u);
  EXPECT_LE(
    report.steps,
    38u); // limit masks of Catmull-Clark have eigenvalues in [1/9, 1]: a step halves what is missing
  const std::vector<double> net = c.points();
  EXPECT_GT(largest_distance(net, data), 1e-3 * size_of(c)); // it had something to do
  to_limit(c.mesh, scheme, PN::parameters::join(PN::parameters::tolerance(1e-12), np));
  EXPECT_LE(largest_distance(c.points(), data), 1e-9 * size_of(c));
  for (auto v : c.mesh.vertices()) // a corner is its own limit, bit for bit
    if (c.vertex_sharpness[v] > 0)
      for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(net[3 * v.idx() + k], data[3 * v.idx() + k]);
}

TEST(Interpolation_creases, LimitPointsAreTheData)
{
  for (const char* const name : scheme_names)
    for (const Crease_kind kind : kinds) {
      SCOPED_TRACE(std::string(name) + ", " + feature_matrix::name(kind));
      Tangled_case c(name, kind);
      expect_limits(c, c.scheme, c.with_tangents().vertex_normal_map(c.corner_normals));
      Tangled_case linear(name, kind);
      expect_limits(linear, PN::linear(linear.scheme), linear.sharp());
    }
}

// Vertices that are not to be interpolated stay, bit for bit.
TEST(Interpolation_creases, SomeVertices)
{
  Tangled_case c("catmull-clark", Crease_kind::edges);
  const auto chosen = c.mesh.add_property_map<Mesh::Vertex_index, bool>("chosen", false).first;
  for (auto v : c.mesh.vertices()) chosen[v] = v.idx() % 2 == 0;
  const std::vector<double> data = c.points();
  const auto scheme = PN::linear(c.scheme);
  EXPECT_TRUE(PN::interpolate_limit_points(
                c.mesh, scheme, c.with_sharp(points_mode().vertex_is_interpolated_map(chosen)))
                .is_within_tolerance());
  const std::vector<double> net = c.points();
  to_limit(c.mesh, scheme, c.sharp());
  const std::vector<double> limits = c.points();
  for (auto v : c.mesh.vertices())
    for (std::size_t i = 3 * v.idx(); i < 3 * v.idx() + 3; ++i) {
      if (chosen[v]) {
        EXPECT_NEAR(limits[i], data[i], 1e-9);
      } else {
        EXPECT_EQ(net[i], data[i]);
      }
    }
}

// Another mesh with exact numbers: they are computed in double, and limits are exact.
TEST(Interpolation_creases, ExactPolyhedron)
{
  long_test([](auto) {
    using Exact = CGAL::Simple_cartesian<CGAL::Gmpq>;
    using Polyhedron = CGAL::Polyhedron_3<Exact>;
    const mesh_cases::Soup soup = mesh_cases::triangles_with_border();
    Polyhedron mesh;
    mesh_cases::build(soup, mesh, get(CGAL::vertex_point, mesh));
    std::vector<Exact::Point_3> data;
    for (auto v : vertices(mesh)) data.push_back(v->point());
    const auto scheme = PN::linear(PN::Loop_scheme());
    const auto report =
      PN::interpolate_limit_points(mesh, scheme, points_mode().border(PN::Border::curve));
    EXPECT_TRUE(report.is_within_tolerance()) << report.residual;
    EXPECT_GT(report.steps, 0u);
    to_limit(mesh, scheme, PN::parameters::border(PN::Border::curve));
    std::size_t i = 0;
    for (auto v : vertices(mesh)) {
      EXPECT_LE(CGAL::to_double(CGAL::squared_distance(v->point(), data[i])), 1e-18) << i;
      ++i;
    }
  });
}

// the net by a scheme with normals, a border curve and its tangents
template <class Any_kernel>
std::vector<double> net_with_tangents()
{
  using Vector_3 = typename Any_kernel::Vector_3;
  CGAL::Surface_mesh<typename Any_kernel::Point_3> mesh;
  mesh_cases::build(mesh_cases::triangles_with_border(), mesh);
  const auto tangents =
    mesh.template add_property_map<CGAL::SM_Halfedge_index, Vector_3>("t", CGAL::NULL_VECTOR).first;
  const auto report = PN::interpolate_limit_points(
    mesh, PN::Loop_scheme(), points_mode().border(PN::Border::curve).crease_tangent_map(tangents));
  EXPECT_TRUE(report.is_within_tolerance()) << report.residual;
  EXPECT_GT(report.steps, 0u);
  std::vector<double> net;
  for (auto v : mesh.vertices())
    for (int k = 0; k < 3; ++k) net.push_back(CGAL::to_double(mesh.point(v)[k]));
  return net;
}

TEST(Interpolation_creases, ExactNumbersAreComputedInDouble)
{
  long_test([](auto) {
    EXPECT_LE(largest_distance(net_with_tangents<CGAL::Epeck>(), net_with_tangents<Kernel>()),
              1e-9);
  });
}

template <class Scheme, class Np>
void expect_refusal(Case& c, const Scheme& scheme, const Np& np, const std::string& part)
{
  const std::vector<double> data = c.points(), normals = c.all_corner_normals();
  messages::expect_refused([&] { PN::interpolate_limit_points(c.mesh, scheme, np); }, {part});
  EXPECT_EQ(c.points(), data);
  EXPECT_EQ(c.all_corner_normals(), normals);
}

TEST(Interpolation_creases, WhatIsRefused)
{
  Tangled_case c("catmull-clark", Crease_kind::edges);
  const auto sharp = c.with_tangents();
  const auto of_corners = sharp.vertex_normal_map(c.corner_normals);
  const auto with = [&](const auto& first) { return PN::parameters::join(first, of_corners); };
  expect_refusal(c, c.scheme, c.sharp().vertex_normal_map(c.corner_normals), "crease_tangent_map");
  expect_refusal(c, c.scheme, sharp.vertex_normal_map(c.normals), "half-edges");
  expect_refusal(c, c.scheme,
                 with(PN::parameters::interpolation_mode(PN::Limit_interpolation::Mode::slide)),
                 "is sharp, but control points slide");
  expect_refusal(
    c, c.scheme,
    with(PN::parameters::interpolation_normals(PN::Limit_interpolation::Normals::solved)),
    "control normals are found");
  expect_refusal(c, c.scheme,
                 with(PN::parameters::free_vertices(PN::Limit_interpolation::Free::smooth)),
                 "move along");
  Tangled_case semi_sharp("catmull-clark", Crease_kind::semi_sharp);
  expect_refusal(semi_sharp, PN::linear(semi_sharp.scheme), semi_sharp.sharp(), "make it infinite");
}

} // namespace

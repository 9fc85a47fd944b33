// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Named parameters of the package: chained with each other and with those of CGAL, and what they say of the border and of
// creases.

#include <CGAL/PN_limit_surface_3/limit_points.h>
#include <CGAL/PN_limit_surface_3/refine_in_pieces.h>
#include <CGAL/PN_limit_surface_3/subdivide_to_limit.h>
#include <CGAL/PN_subdivision_3/Surface_refiner.h>
#include <CGAL/PN_subdivision_3/attributes.h>
#include <CGAL/PN_subdivision_3/estimate_control_normals.h>
#include <CGAL/PN_subdivision_3/parameters/parameters.h>
#include <CGAL/PN_subdivision_3/schemes/Any_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/DooSabin_scheme.h>
#include <CGAL/PN_subdivision_3/subdivide.h>
#include <CGAL/PN_subdivision_3/subdivision_methods_3.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace {

namespace PN = CGAL::PN_subdivision_3;
namespace of_call = PN::parameters;
namespace params = CGAL::parameters;
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;

// a grid on a paraboloid, whose border bends
Mesh bowl()
{
  Mesh mesh;
  CGAL::make_grid(3, 3, mesh, [](std::size_t i, std::size_t j) {
    const double x = double(i) - 1.5, y = double(j) - 1.5;
    return Point(x, y, .3 * (x * x + y * y));
  });
  return mesh;
}

std::vector<Point> points(const Mesh& mesh)
{
  std::vector<Point> all;
  for (const auto v : mesh.vertices()) all.push_back(mesh.point(v));
  return all;
}

template <class Function>
std::vector<Point> changed(const Function& f)
{
  Mesh mesh = bowl();
  f(mesh);
  return points(mesh);
}

const PN::CatmullClark_scheme scheme;

TEST(Own_parameters, AreChainedInAnyOrder)
{
  const auto refined = [](const auto& np) {
    return changed([&](Mesh& mesh) { PN::subdivide(mesh, scheme, np); });
  };
  const auto expected =
    refined(of_call::roundness(.5).border(PN::Border::curve).number_of_iterations(2));
  EXPECT_EQ(refined(of_call::border(PN::Border::curve).roundness(.5).number_of_iterations(2)),
            expected);
  EXPECT_EQ(refined(of_call::roundness(.5).number_of_iterations(2).border(PN::Border::curve)),
            expected);
  EXPECT_EQ(refined(of_call::border(PN::Border::curve)
                      .number_of_iterations(7)
                      .geom_traits(Kernel())
                      .roundness(1)
                      .number_of_iterations(2)
                      .roundness(.5)),
            expected);
  const auto rounds = params::number_of_iterations(2);
  EXPECT_EQ(refined(of_call::join(rounds, of_call::border(PN::Border::curve).roundness(.5))),
            expected);
  EXPECT_EQ(refined(of_call::join(of_call::roundness(.5), rounds,
                                  of_call::border(PN::Border::curve), params::default_values())),
            expected);
  EXPECT_NE(refined(of_call::roundness(.5).number_of_iterations(2)), expected);
  EXPECT_NE(refined(of_call::border(PN::Border::curve).number_of_iterations(2)), expected);
  // what a function does not know it ignores in a pack that is marked, wherever the mark is
  EXPECT_EQ(refined(of_call::shared(of_call::border(PN::Border::curve).roundness(.5).rings(7))
                      .number_of_iterations(2)),
            expected);
  EXPECT_EQ(refined(of_call::shared(of_call::border(PN::Border::curve).number_of_iterations(2))
                      .rings(7)
                      .roundness(.5)),
            expected);
  EXPECT_EQ(refined(of_call::join(of_call::rings(7), of_call::roundness(.5),
                                  of_call::shared(rounds), of_call::border(PN::Border::curve))),
            expected);
  // of two packs that say different things the first one counts
  EXPECT_EQ(refined(of_call::join(of_call::roundness(.5), of_call::roundness(1.),
                                  of_call::border(PN::Border::curve), rounds,
                                  params::number_of_iterations(1))),
            expected);
}

// a border that is fixed has the old vertices, and the midpoints between them
void expect_fixed_border(const Mesh& mesh)
{
  const Mesh control = bowl();
  for (const auto v : control.vertices())
    if (control.is_border(v)) {
      EXPECT_EQ(mesh.point(v), control.point(v));
    }
  std::size_t at_border = 0;
  for (const auto v : mesh.vertices())
    if (mesh.is_border(v)) ++at_border;
  EXPECT_EQ(at_border, 24u);
}

TEST(Own_parameters, BorderCountsInAllFunctions)
{
  const auto fixed = of_call::border(PN::Border::fixed);
  Mesh mesh = bowl();
  PN::subdivide(mesh, scheme, fixed);
  expect_fixed_border(mesh);
  const std::vector<Point> expected = points(mesh);
  EXPECT_NE(changed([](Mesh& m) { PN::subdivide(m, scheme); }), expected);
  EXPECT_EQ(changed([&](Mesh& m) { PN::subdivide(m, PN::Any_scheme<>(scheme), fixed); }), expected);
  EXPECT_EQ(changed([&](Mesh& m) {
              const PN::Surface_refiner refiner(m, scheme, fixed);
              m.clear();
              refiner.build_mesh(m);
            }),
            expected);
  std::size_t faces = 0;
  const PN::Surface_pieces pieces(bowl(), scheme, fixed.number_of_pieces(2));
  for (std::size_t i = 0; i < 2; ++i) {
    const auto piece = pieces.piece(i);
    faces += piece.number_of_faces();
    for (std::size_t v = 0; v < piece.points().size(); ++v)
      EXPECT_EQ(piece.points()[v], expected[piece.vertex_number(v)]);
  }
  EXPECT_EQ(faces, 36u);

  Mesh at_limit = bowl();
  PN::subdivide_to_limit(at_limit, scheme, fixed);
  expect_fixed_border(at_limit);
  PN::subdivide_to_limit(
    mesh, scheme,
    PN::parameters::join(CGAL::parameters::number_of_iterations(0), fixed.rounds_done(1)));
  expect_fixed_border(mesh);
  Mesh control = bowl();
  const auto limits =
    control.add_property_map<Mesh::Vertex_index, PN::Limit_point<Kernel>>("v:limit").first;
  PN::limit_points(control, scheme, limits, fixed);
  for (const auto v : control.vertices())
    if (control.is_border(v)) {
      EXPECT_EQ(limits[v].point, control.point(v));
    }
}

// maps of points, normals and errors get what the map of all has, at vertices or at faces
template <class Element, class Scheme>
void expect_limits_in_maps(const Scheme& of_call_scheme)
{
  Mesh mesh = bowl();
  const auto all = mesh.add_property_map<Element, PN::Limit_point<Kernel>>("limit").first;
  const auto at = mesh.add_property_map<Element, Point>("point").first;
  const auto normals = mesh.add_property_map<Element, Vector>("normal").first;
  const auto errors = mesh.add_property_map<Element, double>("error", -1.).first;
  const auto np = of_call::surface_normals(true).tolerance(1e-4);
  const PN::Limit_report report = PN::limit_points(mesh, of_call_scheme, all, np);
  const PN::Limit_report of_maps = PN::limit_points(
    mesh, of_call_scheme, np.limit_point_map(at).limit_normal_map(normals).limit_error_map(errors));
  EXPECT_EQ(report.error, of_maps.error);
  double largest = 0;
  for (std::size_t i = 0; i < (std::is_same_v<Element, Mesh::Face_index> ? 9u : 16u); ++i) {
    const Element e(static_cast<Mesh::size_type>(i));
    EXPECT_EQ(at[e], all[e].point);
    EXPECT_EQ(normals[e], all[e].surface_normal);
    EXPECT_EQ(errors[e], all[e].error);
    largest = (std::max)(largest, errors[e]);
  }
  EXPECT_EQ(largest, report.error);
  const auto points_alone = mesh.add_property_map<Element, Point>("alone").first;
  PN::limit_points(mesh, of_call_scheme, np.limit_point_map(points_alone));
  EXPECT_EQ(points_alone[Element(3)], all[Element(3)].point);
}

TEST(Own_parameters, AttributesInAChainAreTheUsers)
{
  Mesh mesh = bowl();
  const std::size_t n = mesh.number_of_vertices();
  PN::Attribute_table table;
  table.vertices = {{1, std::vector<double>(n, 7), PN::Corner_rule::corners_plus1}};
  const auto weight = mesh.add_property_map<Mesh::Vertex_index, double>("w", 3).first;
  PN::subdivide(mesh, scheme, of_call::roundness(.5).attributes(table).number_of_iterations(1));
  ASSERT_GT(mesh.number_of_vertices(), n);
  EXPECT_EQ(table.vertices[0].values, std::vector<double>(mesh.number_of_vertices(), 7));
  const std::size_t level_1 = mesh.number_of_vertices();
  for (const auto v : mesh.vertices()) weight[v] = 3;
  PN::subdivide(mesh, scheme,
                of_call::roundness(.5).attributes(PN::parameters::vertex_attribute(weight)));
  ASSERT_GT(mesh.number_of_vertices(), level_1);
  for (const auto v : mesh.vertices()) EXPECT_EQ(weight[v], 3);
}

TEST(Own_parameters, LimitsAreWrittenIntoMaps)
{
  expect_limits_in_maps<Mesh::Vertex_index>(scheme);
  expect_limits_in_maps<Mesh::Face_index>(PN::DooSabin_scheme());
}

// subdivide_to_limit() writes the same maps as limit_points() of the mesh after as many rounds, and moves the points there
TEST(Own_parameters, LimitsOfTheMovedMeshAreWrittenIntoMaps)
{
  for (const unsigned rounds : {0u, 1u, 2u})
    for (const bool has_corners : {false, true}) {
      Mesh moved = bowl(), control = bowl();
      const auto of_mesh = [](Mesh& mesh) {
        return of_call::limit_point_map(mesh.add_property_map<Mesh::Vertex_index, Point>("p").first)
          .limit_normal_map(mesh.add_property_map<Mesh::Vertex_index, Vector>("n").first)
          .limit_error_map(mesh.add_property_map<Mesh::Vertex_index, double>("e", -1).first)
          .surface_normals(true);
      };
      const auto call = [&](const auto& given) {
        PN::subdivide(control, scheme, given.number_of_iterations(rounds));
        PN::limit_points(control, scheme, of_call::join(of_mesh(control), given));
      };
      const auto move = [&](const auto& given) {
        PN::subdivide_to_limit(moved, scheme,
                               of_call::join(of_mesh(moved), given.number_of_iterations(rounds)));
      };
      if (has_corners) { // with a crease through the middle
        const auto with_crease = [](Mesh& mesh) {
          const auto sharp = mesh.add_property_map<Mesh::Edge_index, bool>("s", false).first;
          for (const auto e : mesh.edges())
            sharp[e] =
              mesh.point(mesh.vertex(e, 0)).x() == -.5 && mesh.point(mesh.vertex(e, 1)).x() == -.5;
          const auto np = params::edge_is_constrained_map(sharp);
          return of_call::crease_tangent_map(
                   mesh.add_property_map<Mesh::Halfedge_index, Vector>("t", Vector(0, 0, 0)).first)
            .edge_is_constrained_map(sharp)
            .vertex_normal_map(PN::estimate_control_normals(mesh, np));
        };
        move(with_crease(moved));
        call(with_crease(control));
      } else {
        move(params::vertex_normal_map(PN::estimate_control_normals(moved)));
        call(params::vertex_normal_map(PN::estimate_control_normals(control)));
      }
      const auto map = [](Mesh& mesh, auto value, const char* name) {
        using Value = decltype(value);
        return PN::internal::find_property_map<Mesh::Vertex_index, Value>(mesh, name).value();
      };
      ASSERT_EQ(moved.number_of_vertices(), control.number_of_vertices());
      for (const auto v : moved.vertices()) {
        EXPECT_EQ(map(moved, Point(), "p")[v], moved.point(v));
        EXPECT_EQ(map(moved, Point(), "p")[v], map(control, Point(), "p")[v]);
        EXPECT_EQ(map(moved, Vector(), "n")[v], map(control, Vector(), "n")[v]);
        EXPECT_NEAR(map(moved, Vector(), "n")[v].squared_length(), 1, 1e-12);
        EXPECT_EQ(map(moved, 0., "e")[v], map(control, 0., "e")[v]);
        EXPECT_GE(map(moved, 0., "e")[v], 0);
      }
    }
}

template <class Scheme, class Function>
void expect_variant(const Function& f)
{
  const auto refined = [](const auto& refine) {
    Mesh mesh;
    CGAL::make_tetrahedron(Point(1, 1, 1), Point(-1, -1, 1), Point(-1, 1, -1), Point(1, -1, -1),
                           mesh);
    refine(mesh);
    return points(mesh);
  };
  const auto expected =
    refined([](Mesh& mesh) { PN::subdivide(mesh, Scheme(), params::number_of_iterations(3)); });
  EXPECT_EQ(refined(f), expected);
}

TEST(Own_parameters, VariantsArePartOfTheFunctions)
{
  const auto loop = [](const auto& np) {
    return [np](Mesh& mesh) { PN::Loop_subdivision(mesh, np.number_of_iterations(3)); };
  };
  const auto catmull_clark = [](const auto& np) {
    return [np](Mesh& mesh) { PN::CatmullClark_subdivision(mesh, np.number_of_iterations(3)); };
  };
  expect_variant<PN::Loop_scheme::Tuned>(loop(of_call::tuned(true)));
  expect_variant<PN::Loop_scheme::Transfer>(loop(of_call::curvature_transfer(true)));
  expect_variant<PN::Loop_scheme>(loop(of_call::tuned(false).curvature_transfer(false)));
  expect_variant<PN::CatmullClark_scheme::Tuned>(catmull_clark(of_call::tuned(true)));
  expect_variant<PN::CatmullClark_scheme::Transfer>(
    catmull_clark(of_call::tuned(true).curvature_transfer(true)));
  expect_variant<PN::CatmullClark_scheme>(catmull_clark(of_call::tuned(false)));
}

// the tangents of the result are those of its border, of unit length, and go on from call to call
TEST(Own_parameters, TangentsAreReadAndWritten)
{
  Mesh once = bowl(), twice = bowl();
  const auto add = [](Mesh& mesh) {
    return mesh.add_property_map<Mesh::Halfedge_index, Vector>("h:tangent", Vector(0, 0, 0)).first;
  };
  const auto corners = [](Mesh& mesh) {
    const auto normals = mesh.add_property_map<Mesh::Halfedge_index, Vector>("h:normal").first;
    for (const auto h : mesh.halfedges()) {
      const Point& p = mesh.point(mesh.target(h));
      normals[h] = Vector(-.6 * p.x(), -.6 * p.y(), 1);
    }
    return normals;
  };
  const auto of_once = add(once), of_twice = add(twice);
  const auto np = [](auto tangents, auto normals) {
    return of_call::border(PN::Border::curve)
      .crease_tangent_map(tangents)
      .vertex_normal_map(normals);
  };
  PN::subdivide(once, scheme, np(of_once, corners(once)).number_of_iterations(2));
  const auto normals = corners(twice);
  PN::subdivide(twice, scheme, np(of_twice, normals));
  PN::subdivide(twice, scheme, np(of_twice, normals));
  EXPECT_EQ(points(once), points(twice));
  std::size_t given = 0;
  for (const auto h : once.halfedges()) {
    EXPECT_EQ(of_once[h], of_twice[h]);
    if (!once.is_border(once.edge(h)) || of_once[h] == Vector(0, 0, 0)) continue;
    ++given;
    EXPECT_NEAR(of_once[h].squared_length(), 1, 1e-12);
    EXPECT_GT(of_once[h] * (once.point(once.target(h)) - once.point(once.source(h))), 0);
  }
  EXPECT_EQ(given, 96u);
}

} // namespace

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Queries at creases of a part whose surface is known; derivatives, rays and closest points of all schemes in all kinds of faces.

#include "Crease_shapes.h"
#include "Extent.h"
#include "Named_shapes.h"
#include "Scheme_named.h"
#include "Scheme_runs.h"
#include "Surface_checks.h"
#include "Tagged_meshes.h"

#include <CGAL/PN_limit_surface_3/Limit_surface_queries.h>
#include <CGAL/PN_limit_surface_3/subdivide_to_limit.h>

namespace {

namespace PN = CGAL::PN_subdivision_3;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Queries = PN::Limit_surface_queries<Surface_mesh, Kernel>;

using surface_checks::length;

void expect_point(const Queries::Hit& hit, const Point& expected, double distance)
{
  surface_checks::expect_point(hit, expected, distance, 2e-5);
}

// A closed cylinder of radius 1 between z = 0 and z = 2, whose rims are sharp.
TEST(LimitSurfaceQueries, RimsOfACylinder)
{
  const auto data = crease_shapes::capped_cylinder(crease_shapes::uneven(7)).control();
  tagged_meshes::Tagged<Surface_mesh> control(data);
  const PN::Limit_surface surface(control.mesh, PN::CatmullClark_scheme(),
                                  PN::parameters::border(data.border)
                                    .tolerance(2e-6)
                                    .vertex_normal_map(control.normals)
                                    .edge_is_constrained_map(control.sharp)
                                    .vertex_is_constrained_map(control.corners));
  const Queries queries(surface);
  for (int i = 0; i < 2; ++i) {
    const double angle = 0.2 + 2.9 * i, x = std::cos(angle), y = std::sin(angle);
    const auto at = [&](double r, double z) { return Point(r * x, r * y, z); };
    expect_point(queries.closest_point(at(1.3, 2.4)), at(1, 2), 0.5); // of the rims
    expect_point(queries.closest_point(at(1.05, -0.12)), at(1, 0), 0.13);
    expect_point(queries.closest_point(at(1.5, 1.99)), at(1, 1.99), 0.5); // beside them
    expect_point(queries.closest_point(at(0.98, 2.5)), at(0.98, 2), 0.5);
    const auto on_side = queries.first_intersection(at(3, 1.98), Vector(-x, -y, 0));
    ASSERT_TRUE(on_side);
    expect_point(*on_side, at(1, 1.98), 2);
    EXPECT_LE(length(on_side->normal - Vector(x, y, 0)), 1e-3);
    const auto on_top = queries.first_intersection(at(0.98, 4), Vector(0, 0, -1));
    ASSERT_TRUE(on_top);
    expect_point(*on_top, at(0.98, 2), 2);
    EXPECT_FALSE(queries.first_intersection(at(1.02, 4), Vector(0, 0, -1)));
  }
}

// \name All schemes, in all kinds of faces, at borders and creases

using Surface = PN::Limit_surface<Surface_mesh, Kernel>;
using Face = Surface_mesh::Face_index;
using test_meshes::Cells;
using test_meshes::Control_mesh;

enum class Creases { none, darts, corners, finite };

struct Combination
{
  std::string scheme;
  int corners; // of faces, or how many triangles or quads meet
  bool is_open;
  Creases creases;
  double roundness, tolerance;

  bool is_spline() const { return scheme != "kobbelt" && scheme != "butterfly"; }
};

// Open grids have a regular face, and vertices of all kinds.
Control_mesh shape(const Combination& c)
{
  using namespace named_shapes;
  const int n = c.corners;
  const bool is_triangular = c.scheme == "butterfly" || c.scheme.find("loop") != std::string::npos;
  const Cells cells = is_triangular ? Cells::triangles : Cells::quads;
  if (c.is_open && n == (is_triangular ? 6 : 4)) return grid(3, 3, false, false, cells);
  if (is_triangular) return c.is_open ? star(n, 1, cells) : bipyramid(n);
  if (!c.is_spline()) return c.is_open ? star(n, 1, cells) : quads_between_poles(n);
  return c.is_open ? single_polygon(n) : prism(n);
}

// A mesh with creases along sides of a face in its middle: some end, some meet.
struct Tagged_control
{
  explicit Tagged_control(const Combination& c)
  {
    Control_mesh control = shape(c);
    test_meshes::set_uneven_normals(control, 5);
    mesh = to_surface_mesh(control);
    sharp = mesh.add_property_map<Surface_mesh::Edge_index, double>("e:sharp", 0).first;
    corners = mesh.add_property_map<Surface_mesh::Vertex_index, double>("v:sharp", 0).first;
    if (c.creases == Creases::none) return;
    const double infinity = std::numeric_limits<double>::infinity(),
                 sharpness = c.creases == Creases::finite ? 0.7 : infinity;
    const auto first = mesh.halfedge(Face(mesh.number_of_faces() / 2));
    sharp[mesh.edge(first)] = sharp[mesh.edge(mesh.next(first))] = sharpness;
    if (c.creases == Creases::darts) return;
    for (auto h : mesh.halfedges_around_face(first)) sharp[mesh.edge(h)] = sharpness;
    sharp[mesh.edge(mesh.next(mesh.opposite(first)))] = sharpness;
    if (c.creases == Creases::corners) corners[mesh.target(first)] = infinity;
  }

  // a round, after which nothing is sharp that is not for ever
  template <class Scheme>
  void refine(const Scheme& scheme)
  {
    PN::subdivide(mesh, scheme,
                  CGAL::parameters::number_of_iterations(1)
                    .vertex_normal_map(normal_map(mesh))
                    .edge_is_constrained_map(sharp));
  }

  auto parameters(const Combination& c)
  {
    return PN::parameters::roundness(c.roundness)
      .vertex_normal_map(normal_map(mesh))
      .edge_is_constrained_map(sharp)
      .vertex_is_constrained_map(corners);
  }

  bool is_at_curve(Face f) const
  {
    for (auto v : mesh.vertices_around_face(mesh.halfedge(f)))
      for (auto h : mesh.halfedges_around_target(mesh.halfedge(v)))
        if (std::isinf(sharp[mesh.edge(h)]) || mesh.is_border(mesh.edge(h))) return true;
    return false;
  }

  Surface_mesh mesh;
  Surface_mesh::Property_map<Surface_mesh::Edge_index, double> sharp;
  Surface_mesh::Property_map<Surface_mesh::Vertex_index, double> corners;
};

// Limit points of the mesh that is refined as a whole are on the surface.
void expect_surface(const Combination& c, int number)
{
  SCOPED_TRACE(testing::Message() << c.scheme << (c.is_open ? ", open" : ", closed") << ", creases "
                                  << int(c.creases) << ", roundness " << c.roundness
                                  << ", tolerance " << c.tolerance);
  Tagged_control control(c);
  const PN::Any_scheme<double> scheme = scheme_named(c.scheme);
  if (c.creases == Creases::finite) {
    if (control.mesh.number_of_faces() > 1) // borders have no sharpness
      EXPECT_THROW(Surface(control.mesh, scheme, control.parameters(c)), std::invalid_argument);
    if (CGAL::is_triangle_mesh(control.mesh))
      control.refine(PN::Loop_scheme());
    else
      control.refine(PN::CatmullClark_scheme());
  }
  const Surface surface(control.mesh, scheme, control.parameters(c).tolerance(c.tolerance));
  // on curves of point-normal schemes second derivatives across are not those of the limit
  const auto bounds = [&](Face f) {
    if (!c.is_spline()) return surface_checks::Derivative_bounds{1, 0.05, 0};
    if (c.roundness == 0 || !control.is_at_curve(f))
      return surface_checks::Derivative_bounds{2, 1e-3, 5e-2};
    return surface_checks::Derivative_bounds{2, 5e-3, std::numeric_limits<double>::infinity()};
  };
  const surface_checks::Some_places some{tests_are_full ? 1U : 9U, std::size_t(number)};
  surface_checks::expect_derivatives(
    surface, [&](Face f) { return control.mesh.degree(f); }, bounds, some);
  const Queries queries(surface, 2);
  PN::subdivide_to_limit(control.mesh, scheme,
                         control.parameters(c).tolerance(1e-10).number_of_iterations(2));
  const surface_checks::Fine_triangles triangles(control.mesh, 1e-9);
  const int queried = tests_are_full ? 12 : 4;
  surface_checks::expect_rays(surface, queries, triangles, queried, number);
  surface_checks::expect_closest_points(surface, queries, triangles, queried, number);
}

// In a fold beside a corner a place may be nearer than those about it, and the corner nearer still. Corners have no derivatives.
TEST(LimitSurfaceQueries, PointsBesideAndBeforeCorners)
{
  const auto expect = [](const Combination& c, const Point& p, double most) {
    Tagged_control control(c);
    const Surface surface(control.mesh, scheme_named(c.scheme),
                          control.parameters(c).tolerance(c.tolerance));
    EXPECT_LE(Queries(surface, 2).closest_point(p).distance, most);
  };
  // a limit point
  expect({"modified-catmull-clark", 6, true, Creases::darts, 1, 1e-9},
         {0.44230323409675038, 0.95372469590494602, 0.046647072678230428}, 2e-8);
  // nearest of 1891 places of each face
  expect({"loop", 6, true, Creases::darts, 1, 1e-9},
         {-0.50069986623341789, -0.48416537743181809, -0.94367184299150131}, 1.49433);
}

TEST(LimitSurfaceQueries, ARayMeetsAFoldAtANarrowAngle)
{
  const Combination c{"modified-loop", 4, false, Creases::corners, 1, 1e-12};
  Tagged_control control(c);
  const Surface surface(control.mesh, scheme_named(c.scheme),
                        control.parameters(c).tolerance(c.tolerance));
  const auto hit =
    Queries(surface, 2)
      .first_intersection({-1.2936604309226376, 0.096491418059726802, 0.84882942862309885},
                          {0.55131356667734976, 0.70738448073782911, -0.44233533389134927});
  ASSERT_TRUE(hit);
  EXPECT_LE(hit->distance, 0.9343262); // a limit point
}

// All combinations, of which one in 27 has nearly all pairs.
TEST(LimitSurfaceQueries, AllKindsOfSurfaces)
{
  constexpr const char* schemes[] = {"catmull-clark",
                                     "loop",
                                     "modified-catmull-clark",
                                     "modified-loop",
                                     "ct-catmull-clark",
                                     "ct-loop",
                                     "kobbelt",
                                     "butterfly"};
  constexpr double tolerances[] = {1e-12, 1e-9, 1e-6};
  int number = 0;
  for (int k = 0; k < 512; k += tests_are_full ? 1 : 27) {
    Combination c{schemes[k % 8],      3 + k / 8 % 4, k / 32 % 2 != 0,
                  Creases(k / 64 % 4), k / 256 * 1.,  tolerances[++number % 3]};
    if (!c.is_spline()) c.creases = Creases::none, c.tolerance = 1e-4;
    expect_surface(c, number);
  }
}

} // namespace

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Edges that are sharp for a number of rounds: no flare, and continuous in that number.

#include "Random_creases.h"
#include "Tagged_meshes.h"

#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
#include <CGAL/Surface_mesh.h>

using namespace tagged_meshes;

namespace {

using Mesh = CGAL::Surface_mesh<Point_3>;
using V = Mesh::Vertex_index;

// \name Shapes, with the normals of their faces and sides

Control sharpened(Control c, double s)
{
  for (auto& edge : c.sharp_edges) edge.second = s;
  return c;
}

Control cube(double s)
{
  return sharpened(crease_shapes::cube().control(), s);
}

// radius 4, height 3, 8 sides, caps of triangles; its rims are tagged
Control cylinder(double s)
{
  Part part;
  std::vector<Real> angles;
  for (int i = 0; i < 8; ++i) angles.push_back(Real(i) * pi / 4);
  const Ring low = part.ring(4, 0, angles), high = part.ring(4, 3, angles);
  part.tube(part.add(upright_cylinder(4)), low, high);
  for (const Ring* ring : {&low, &high}) {
    const Real z = ring == &low ? 0 : 3;
    const auto cap = part.add(plane(z, z - 1 > 0 ? 1 : -1));
    const int center = part.vertex({0, 0, z});
    for (std::size_t i = 0; i < 8; ++i) part.face(cap, {center, (*ring)[i], (*ring)[(i + 1) % 8]});
  }
  return sharpened(part.control(), s);
}

double outside_cube(const Point_3& p)
{
  double d = 0;
  for (int k = 0; k < 3; ++k) d = (std::max)({d, p[k] - 1, -p[k]});
  return d;
}
double outside_cylinder(const Point_3& p)
{
  return (std::max)({std::hypot(p.x(), p.y()) - 4, p.z() - 3, -p.z(), 0.}) / 8;
}

template <class Np>
void subdivide(Mesh& mesh, bool is_loop, const Np& parameters)
{
  if (is_loop)
    PN::subdivide(mesh, PN::Loop_scheme(), parameters);
  else
    PN::subdivide(mesh, PN::CatmullClark_scheme(), parameters);
}

void subdivide_by_corners(Tagged<Mesh>& tagged, unsigned rounds, bool is_loop)
{
  if (is_loop)
    tagged.subdivide(PN::Loop_scheme(), rounds);
  else
    tagged.subdivide(PN::CatmullClark_scheme(), rounds);
}

struct Shape
{
  const char* name;
  Control (*control)(double);
  double (*outside)(const Point_3&); // of the sharp result, in parts of the size
  double size;
  bool is_loop;

  Mesh refined(double s, unsigned rounds = 4) const
  {
    return refined_with(s, subdivide_by_corners, rounds);
  }
  // with the normals of points, of vertices or of corners
  template <class Normals>
  Mesh refined_with(double s, const Normals& normals, unsigned rounds = 4) const
  {
    Tagged<Mesh> tagged(is_loop ? triangulated(control(s)) : control(s));
    normals(tagged, rounds, is_loop);
    return tagged.mesh;
  }
};

void subdivide_by_points(Tagged<Mesh>& tagged, unsigned rounds, bool is_loop)
{
  subdivide(tagged.mesh, is_loop,
            np::number_of_iterations(rounds).edge_is_constrained_map(tagged.sharp));
}

void subdivide_by_vertices(Tagged<Mesh>& tagged, unsigned rounds, bool is_loop)
{
  auto normals = tagged.mesh.add_property_map<V, Vector_3>("v:n").first;
  for (const V v : tagged.mesh.vertices()) {
    const Vector_3 d = tagged.mesh.point(v) - Point_3(0.4, 0.5, 0.6);
    normals[v] = d / std::sqrt(d.squared_length());
  }
  subdivide(tagged.mesh, is_loop,
            np::number_of_iterations(rounds)
              .edge_is_constrained_map(tagged.sharp)
              .vertex_normal_map(normals));
}

double volume(const Mesh& mesh)
{
  double sum = 0;
  for (const auto f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    const Point_3& a = mesh.point(mesh.target(h));
    for (auto g = mesh.next(h); mesh.next(g) != h; g = mesh.next(g)) {
      const Point_3 &b = mesh.point(mesh.target(g)), &c = mesh.point(mesh.target(mesh.next(g)));
      sum += CGAL::determinant(a - CGAL::ORIGIN, b - CGAL::ORIGIN, c - CGAL::ORIGIN) / 6;
    }
  }
  return sum;
}

double farthest(const Mesh& a, const Mesh& b)
{
  double d = 0;
  EXPECT_EQ(a.number_of_vertices(), b.number_of_vertices());
  for (const V v : a.vertices())
    d = (std::max)(d, std::sqrt(CGAL::squared_distance(a.point(v), b.point(v))));
  return d;
}

class Semi_sharp : public ::testing::TestWithParam<Shape>
{};

TEST_P(Semi_sharp, Stays_inside_the_sharp_result)
{
  const Shape& shape = GetParam();
  for (const double s : {1., 1.001, 1.3, 1.5, 1.8, 2., 2.5, 3., 3.7, infinity}) {
    const Mesh mesh = shape.refined(s);
    for (const V v : mesh.vertices())
      EXPECT_LE(shape.outside(mesh.point(v)), 0.005) << "s = " << s << ", " << v;
  }
}

TEST_P(Semi_sharp, Volume_grows_with_the_sharpness)
{
  double before = 0;
  for (const double s : {1., 1.2, 1.4, 1.6, 1.8, 2., 2.2, 2.6, 3., 3.5, 3.9, infinity}) {
    const double now = volume(GetParam().refined(s));
    EXPECT_GT(now, before) << s;
    before = now;
  }
}

TEST_P(Semi_sharp, Is_continuous_in_the_sharpness)
{
  const Shape& shape = GetParam();
  for (const double s : {1., 2., 3.}) {
    const Mesh mesh = shape.refined(s);
    for (const double d : {-0.001, 0.001})
      EXPECT_LE(farthest(mesh, shape.refined(s + d)), 0.003 * shape.size) << s << " + " << d;
  }
  EXPECT_LE(farthest(shape.refined(1e-9), shape.refined(0.001)), 0.003 * shape.size);
}

// a sharpness of next to nothing is none, whether normals are estimated, or given to vertices or corners
TEST_P(Semi_sharp, Begins_at_the_untagged_result)
{
  const Shape& shape = GetParam();
  for (const auto& subdivide : {subdivide_by_points, subdivide_by_vertices, subdivide_by_corners}) {
    const Mesh untagged = shape.refined_with(0, subdivide);
    EXPECT_LE(farthest(untagged, shape.refined_with(1e-9, subdivide)), 1e-8 * shape.size);
    EXPECT_LE(farthest(untagged, shape.refined_with(0.001, subdivide)), 0.003 * shape.size);
    EXPECT_GE(farthest(untagged, shape.refined_with(1, subdivide)), 0.02 * shape.size);
  }
}

TEST_P(Semi_sharp, Sharp_rounds_are_those_of_infinite_creases)
{
  const Shape& shape = GetParam();
  for (unsigned rounds = 1; rounds <= 3; ++rounds) {
    const Mesh sharp = shape.refined(infinity, rounds);
    for (const double s : {rounds + 0.001, rounds + 0.5, rounds + 1.}) {
      const Mesh mesh = shape.refined(s, rounds);
      for (const V v : mesh.vertices()) EXPECT_EQ(mesh.point(v), sharp.point(v)) << s << ", " << v;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, Semi_sharp,
                         ::testing::Values(Shape{"cube", cube, outside_cube, 1, false},
                                           Shape{"cylinder", cylinder, outside_cylinder, 8, false},
                                           Shape{"cube_of_triangles", cube, outside_cube, 1, true},
                                           Shape{"cylinder_of_triangles", cylinder,
                                                 outside_cylinder, 8, true}),
                         [](const auto& shape) { return std::string(shape.param.name); });

} // namespace

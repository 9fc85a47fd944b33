// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The first programs of a new user, examples/PN_subdivision_3/first_steps, compiled at once: what they include comes first.

#include "support/Temporary_folder.h"

#include <CGAL/Gmpq.h>
#include <CGAL/PN_certificates_3/reproduction.h>
#include <CGAL/PN_fitting_3/interpolate_limit_points.h>
#include <CGAL/PN_limit_surface_3/Limit_surface_queries.h>
#include <CGAL/PN_limit_surface_3/subdivide_to_limit.h>
#include <CGAL/PN_limit_surface_3/tessellate.h>
#include <CGAL/PN_subdivision_3.h>
#include <CGAL/PN_subdivision_3/Surface_refiner.h>
#include <CGAL/PN_subdivision_3/sqrt_extension_normals.h>
#include <CGAL/PN_subdivision_curve.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/generators.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <vector>

namespace obj_to_limit {
#include "../../../examples/PN_subdivision_3/first_steps/obj_to_limit.cpp"
}
namespace creases_by_angle {
#include "../../../examples/PN_subdivision_3/first_steps/creases_by_angle.cpp"
}
namespace certificate {
#include "../../../examples/PN_subdivision_3/first_steps/certificate.cpp"
}
namespace own_scheme {
#include "../../../examples/PN_subdivision_3/first_steps/own_scheme.cpp"
}
namespace seams {
#include "../../../examples/PN_subdivision_3/first_steps/seams.cpp"
}
namespace refiner {
#include "../../../examples/PN_subdivision_3/first_steps/refiner.cpp"
}
namespace curve {
#include "../../../examples/PN_subdivision_3/first_steps/curve.cpp"
}
namespace fit_tessellate_query {
#include "../../../examples/PN_subdivision_3/first_steps/fit_tessellate_query.cpp"
}

namespace {

namespace PN = CGAL::PN_subdivision_3;
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;

class First_steps : public testing::Test
{
protected:
  // what a program makes of a mesh
  template <class Program>
  Mesh run(const Program& program, const Mesh& control, const std::string& format)
  {
    std::string name = "program", in = folder_.file("in.obj");
    std::string out = folder_.file("out." + format);
    CGAL::IO::write_polygon_mesh(in, control, CGAL::parameters::stream_precision(17));
    char* arguments[] = {name.data(), in.data(), out.data(), nullptr};
    EXPECT_EQ(program(3, arguments), 0);
    EXPECT_NE(program(1, arguments), 0);
    Mesh result;
    EXPECT_TRUE(CGAL::IO::read_polygon_mesh(out, result));
    return result;
  }

  Temporary_folder folder_;
};

Mesh cube()
{
  Mesh mesh;
  CGAL::make_hexahedron(Point(-1, -1, -1), Point(1, -1, -1), Point(1, 1, -1), Point(-1, 1, -1),
                        Point(-1, 1, 1), Point(-1, -1, 1), Point(1, -1, 1), Point(1, 1, 1), mesh);
  return mesh;
}

TEST_F(First_steps, TheLimitOfACubeIsASphere)
{
  run(obj_to_limit::main, cube(), "ply");
  Mesh sphere; // with the normals of the file
  std::ifstream file(folder_.file("out.ply"), std::ios::binary);
  ASSERT_TRUE(CGAL::IO::read_PLY(file, sphere));
  ASSERT_EQ(sphere.number_of_faces(), 6u * 64);
  const auto normals =
    PN::internal::find_property_map<Vertex, Kernel::Vector_3>(sphere, "v:normal").value();
  for (const Vertex v : sphere.vertices()) {
    const Kernel::Vector_3 p = sphere.point(v) - CGAL::ORIGIN;
    EXPECT_NEAR(p.squared_length(), 3, 1e-5); // six digits
    EXPECT_NEAR(normals[v] * p, std::sqrt(3.), 1e-3);
  }
}

// a prism of twelve sides without fans in its ends: these are sharp, its sides are a cylinder
TEST_F(First_steps, SharpEdgesOfAPrismStay)
{
  Mesh prism;
  std::vector<Vertex> ends[2];
  for (int i = 0; i < 24; ++i) {
    const double t = i / 2 * std::acos(-1.) / 6;
    ends[i % 2].push_back(prism.add_vertex(Point(std::cos(t), std::sin(t), i % 2)));
  }
  for (int i = 0; i < 12; ++i) {
    const int j = (i + 1) % 12;
    prism.add_face(ends[0][i], ends[0][j], ends[1][j], ends[1][i]);
  }
  prism.add_face(ends[1]);
  std::reverse(ends[0].begin(), ends[0].end());
  prism.add_face(ends[0]);
  const Mesh round = run(creases_by_angle::main, prism, "off");
  std::size_t on_cylinder = 0;
  for (const Point& p : round.points()) {
    const double r = std::hypot(p.x(), p.y());
    EXPECT_TRUE(std::abs(r - 1) < 1e-5 || (r < 1 && (std::abs(p.z() - .5) > .5 - 1e-6)))
      << p; // six digits; or in an end
    on_cylinder += std::abs(r - 1) < 1e-5;
  }
  EXPECT_EQ(on_cylinder, 96u * 9);
}

TEST_F(First_steps, ASphereIsProvedToBeKept)
{
  EXPECT_EQ(certificate::main(), 0);
}

TEST_F(First_steps, MiddlesOfAnIcosahedronAreOnItsSphere)
{
  EXPECT_EQ(own_scheme::main(), 0);
  Mesh mesh;
  CGAL::make_icosahedron(mesh, Point(0, 0, 0), 1.);
  PN::subdivide(mesh, own_scheme::Middles(), CGAL::parameters::number_of_iterations(2));
  for (const Point& p : mesh.points()) EXPECT_NEAR((p - CGAL::ORIGIN).squared_length(), 1, 1e-13);
}

TEST_F(First_steps, SeamsChangeNoPoint)
{
  EXPECT_EQ(run(seams::main, cube(), "off").number_of_faces(), 6u * 4);
}

TEST_F(First_steps, ARefinerFollowsAPoint)
{
  const Mesh followed = run(refiner::main, cube(), "off");
  Mesh expected; // with the numbers that elements have in the file
  ASSERT_TRUE(CGAL::IO::read_polygon_mesh(folder_.file("in.obj"), expected));
  expected.point(Vertex(0)) = Point(0, 0, 0);
  PN::CatmullClark_subdivision(expected, CGAL::parameters::number_of_iterations(3));
  ASSERT_EQ(followed.number_of_vertices(), expected.number_of_vertices());
  for (const Vertex v : followed.vertices())
    EXPECT_LE(CGAL::squared_distance(followed.point(v), expected.point(v)), 1e-9);
}

TEST_F(First_steps, ACurveOfPointsOfACircleIsTheCircle)
{
  std::string points, name = "program", out = folder_.file("out.txt");
  for (const double degrees : {0, 40, 70, 115, 160, 200, 230, 280, 315}) {
    const double t = degrees * std::acos(-1.) / 180;
    points += std::to_string(std::cos(t)) + ' ' + std::to_string(std::sin(t)) + '\n';
  }
  std::string in = folder_.write("in.txt", points);
  char* arguments[] = {name.data(), in.data(), out.data(), nullptr};
  ASSERT_EQ(curve::main(3, arguments), 0);
  EXPECT_NE(curve::main(1, arguments), 0);
  std::ifstream file(out);
  const std::vector<Kernel::Point_2> result(std::istream_iterator<Kernel::Point_2>(file), {});
  ASSERT_EQ(result.size(), 9u * 32);
  for (const Kernel::Point_2& p : result)
    EXPECT_NEAR((p - CGAL::ORIGIN).squared_length(), 1, 1e-4); // normals are estimated
}

TEST_F(First_steps, ASurfaceThroughPointsIsAsked)
{
  testing::internal::CaptureStdout();
  const Mesh control = cube(), triangles = run(fit_tessellate_query::main, control, "off");
  std::istringstream said(testing::internal::GetCapturedStdout());
  Point closest;
  ASSERT_TRUE(said >> closest);
  const double distance = (closest - CGAL::ORIGIN).squared_length();
  const auto distance_from = [&](const Point& p) {
    double least = 100;
    for (const Point& q : triangles.points())
      least = (std::min)(least, CGAL::squared_distance(p, q));
    return least;
  };
  for (const Point& p : control.points()) EXPECT_LT(distance_from(p), 1e-10); // six digits
  for (const Point& p : triangles.points())
    EXPECT_GT((p - CGAL::ORIGIN).squared_length(), distance - 1e-4);
  EXPECT_LT(distance_from(closest), 0.3);
}

} // namespace

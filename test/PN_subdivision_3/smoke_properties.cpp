// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// What CGAL's test suite runs without GoogleTest: every scheme keeps a sphere, borders included; linear
// twins are CGAL's own schemes; creases, Polyhedron_3, curves; refused input leaves the mesh as it was.

#include <CGAL/PN_subdivision_3.h>
#include <CGAL/PN_subdivision_curve.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/subdivision_method_3.h>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;
namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;

int failures = 0;

void check(bool holds, const std::string& what)
{
  if (!holds) std::cerr << "failed: " << what << "\n";
  failures += holds ? 0 : 1;
}

// Points off a regular arrangement, on the sphere of radius 2 about c.
const Point c(1, -2, 0.5);

Point on_sphere(const Point& p)
{
  const Vector v(p.x() + 0.2 * p.y(), p.y() - 0.1 * p.z(), 1.3 * p.z());
  return c + 2 * v / std::sqrt(v.squared_length());
}

Mesh cube(bool open)
{
  Mesh mesh;
  CGAL::make_hexahedron(Point(-1, -1, -1), Point(1, -1, -1), Point(1, 1, -1), Point(-1, 1, -1),
                        Point(-1, 1, 1), Point(-1, -1, 1), Point(1, -1, 1), Point(1, 1, 1), mesh);
  if (open) CGAL::Euler::remove_face(halfedge(*faces(mesh).begin(), mesh), mesh);
  mesh.collect_garbage();
  return mesh;
}

Mesh icosahedron(bool open)
{
  Mesh mesh;
  CGAL::make_icosahedron(mesh, Point(0, 0, 0), 1);
  if (open) CGAL::Euler::remove_face(halfedge(*faces(mesh).begin(), mesh), mesh);
  mesh.collect_garbage();
  return mesh;
}

double off_sphere(const Mesh& mesh)
{
  double off = 0;
  for (const Point& p : mesh.points())
    off = (std::max)(off, std::abs((p - c).squared_length() / 4 - 1));
  return off;
}

template <class Scheme>
void keeps_sphere(const Scheme& scheme, bool triangles, bool open)
{
  Mesh mesh = triangles ? icosahedron(open) : cube(open);
  auto normals = mesh.add_property_map<Mesh::Vertex_index, Vector>("v:normal").first;
  for (Mesh::Vertex_index v : mesh.vertices()) {
    mesh.point(v) = on_sphere(mesh.point(v));
    normals[v] = mesh.point(v) - c;
  }
  const std::size_t before = mesh.number_of_faces();
  PN::subdivide(mesh, scheme, params::number_of_iterations(2).vertex_normal_map(normals));
  const std::string name = std::string(Scheme::name()) + (open ? ", open" : ", closed");
  check(mesh.is_valid() && mesh.number_of_faces() > 2 * before, name + ": faces");
  check(off_sphere(mesh) < 1e-14, name + ": the sphere");
  for (Mesh::Vertex_index v : mesh.vertices())
    check((2 * normals[v] - (mesh.point(v) - c)).squared_length() < 1e-28, name + ": normals");
}

void all_schemes_keep_spheres()
{
  PN::for_each_shipped_scheme([](const auto& scheme) {
    const std::string name = scheme.name();
    const bool triangles = name.find("loop") != std::string::npos || name == "butterfly" ||
                           name == "sqrt3" || name == "midpoint";
    for (const bool open : {false, true}) keeps_sphere(scheme, triangles, open);
  });
}

// the largest distance of a vertex of a from the nearest one of b
double distance(const Mesh& a, const Mesh& b)
{
  if (a.number_of_vertices() != b.number_of_vertices()) return HUGE_VAL;
  double largest = 0;
  for (const Point& p : a.points()) {
    double nearest = HUGE_VAL;
    for (const Point& q : b.points()) nearest = (std::min)(nearest, (p - q).squared_length());
    largest = (std::max)(largest, nearest);
  }
  return std::sqrt(largest);
}

void linear_twins_are_those_of_CGAL()
{
  Mesh ours = cube(false), theirs = ours;
  PN::subdivide(ours, PN::linear(PN::CatmullClark_scheme()), params::number_of_iterations(2));
  CGAL::Subdivision_method_3::CatmullClark_subdivision(theirs, params::number_of_iterations(2));
  check(distance(ours, theirs) < 1e-14, "linear Catmull-Clark");
  ours = theirs = icosahedron(false);
  PN::subdivide(ours, PN::linear(PN::Loop_scheme()), params::number_of_iterations(2));
  CGAL::Subdivision_method_3::Loop_subdivision(theirs, params::number_of_iterations(2));
  check(distance(ours, theirs) < 1e-14, "linear Loop");
}

// with all edges sharp a cube remains a cube
void creases_keep_faces_plane()
{
  Mesh mesh = cube(false);
  auto sharp = mesh.add_property_map<Mesh::Edge_index, bool>("e:sharp", false).first;
  for (Mesh::Edge_index e : mesh.edges()) sharp[e] = true;
  PN::CatmullClark_subdivision(mesh,
                               params::number_of_iterations(3).edge_is_constrained_map(sharp));
  for (const Point& p : mesh.points()) {
    const double largest = (std::max)({std::abs(p.x()), std::abs(p.y()), std::abs(p.z())});
    check(std::abs(largest - 1) < 1e-14, "the faces of a cube with sharp edges");
  }
}

void refused_input_stays()
{
  const Mesh before = cube(true);
  Mesh mesh = before;
  bool refused = false;
  try {
    PN::Loop_subdivision(mesh);
  } catch (const std::invalid_argument& error) {
    refused = std::string(error.what()).find("face") != std::string::npos;
  }
  check(refused, "quads are refused for Loop subdivision, with a message that names a face");
  check(mesh.number_of_faces() == before.number_of_faces() && distance(mesh, before) == 0,
        "the mesh is as it was");
}

void polyhedron_with_an_external_map()
{
  using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Polyhedron = CGAL::Polyhedron_3<Epick>;
  using Vertex = boost::graph_traits<Polyhedron>::vertex_descriptor;
  Polyhedron mesh;
  CGAL::make_tetrahedron(Epick::Point_3(1, 1, 1), Epick::Point_3(1, -1, -1),
                         Epick::Point_3(-1, 1, -1), Epick::Point_3(-1, -1, 1), mesh);
  std::map<Vertex, Epick::Vector_3> normals;
  for (Vertex v : vertices(mesh)) normals[v] = v->point() - CGAL::ORIGIN;
  PN::Loop_subdivision(mesh, params::number_of_iterations(3).vertex_normal_map(
                               boost::make_assoc_property_map(normals)));
  check(mesh.is_valid() && mesh.size_of_facets() == 256, "Polyhedron_3: faces");
  for (Vertex v : vertices(mesh))
    check(std::abs((v->point() - CGAL::ORIGIN).squared_length() / 3 - 1) < 1e-14,
          "Polyhedron_3: sphere");
}

void circles_stay_circles()
{
  using Point_2 = Kernel::Point_2;
  using Vector_2 = Kernel::Vector_2;
  std::vector<std::pair<Point_2, Vector_2>> polygon;
  for (const double t : {0.0, 0.4, 1.5, 2.0, 3.3, 4.1, 5.2}) {
    const Vector_2 normal(std::cos(t), std::sin(t));
    polygon.emplace_back(Point_2(3, 1) + 5 * normal, normal);
  }
  const auto check_circle = [](const auto& curve, std::size_t least, const char* what) {
    check(curve.size() >= least, what);
    for (const auto& [point, normal] : curve)
      check(std::abs((point - Point_2(3, 1)).squared_length() / 25 - 1) < 1e-14, what);
  };
  const auto closed = PN::Curve_end::closed;
  check_circle(
    PN::subdivide_curve(polygon, PN::B_spline_mask(3), closed, params::number_of_iterations(5)),
    7 * 32, "a circle by the cubic B-spline");
  check_circle(PN::subdivide_curve(polygon, PN::Dubuc_Deslauriers_mask(2), closed,
                                   params::number_of_iterations(5)),
               7 * 32, "a circle by the four-point mask");
}

} // namespace

int main()
{
  all_schemes_keep_spheres();
  linear_twins_are_those_of_CGAL();
  creases_keep_faces_plane();
  refused_input_stays();
  polyhedron_with_an_external_map();
  circles_stay_circles();
  if (failures == 0) std::cout << "done\n";
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

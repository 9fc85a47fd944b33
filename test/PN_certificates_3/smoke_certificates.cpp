// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Certificates without GoogleTest: one round from rational points and normals on a sphere, a cylinder and a
// circle is proved to end exactly on it, open and closed, and what is off by 2^-60 is refused.

#include "support/One_root_number.h"
#include "support/Rational_shapes.h"

#include <CGAL/PN_certificates_3/reproduction.h>
#include <CGAL/PN_subdivision_3.h>
#include <CGAL/PN_subdivision_curve.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <initializer_list>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;

using Kernel = One_root_kernel;
using Number = Kernel::FT;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Normals = Mesh::Property_map<Mesh::Vertex_index, Vector>;
using Curve = std::vector<std::pair<Kernel::Point_2, Kernel::Vector_2>>;
using rational_shapes::Shape;
using Face = std::vector<std::size_t>;

const double tiny = std::ldexp(1., -60);

int failures = 0;

void check(bool holds, const std::string& what)
{
  if (!holds) std::cerr << "failed: " << what << "\n";
  failures += holds ? 0 : 1;
}

// --- surfaces ---

struct Control
{
  std::string name;
  std::vector<std::array<double, 3>> directions;
  std::vector<Face> faces;
};

// faces that are given by the numbers 1 to 8 of the corners of a box that is not regular
Control box(const std::string& name, std::initializer_list<Face> faces)
{
  return {name,
          {{-1, -1, -1.1},
           {1, -1.2, -1},
           {1.1, 1, -1},
           {-1, 1, -0.9},
           {-1, -1, 1},
           {1, -1, 1.2},
           {1, 0.9, 1},
           {-1.1, 1, 1}},
          faces};
}

Control quads()
{
  return box("box",
             {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}});
}
Control open_quads()
{
  return box("open box", {{3, 2, 1, 0}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}});
}
Control triangles()
{
  return box("triangles", {{0, 2, 1},
                           {0, 3, 2},
                           {4, 5, 6},
                           {4, 6, 7},
                           {0, 1, 5},
                           {0, 5, 4},
                           {1, 2, 6},
                           {1, 6, 5},
                           {2, 3, 7},
                           {2, 7, 6},
                           {3, 0, 4},
                           {3, 4, 7}});
}
Control open_triangles()
{
  return box("open triangles", {{0, 2, 1},
                                {0, 3, 2},
                                {0, 1, 5},
                                {0, 5, 4},
                                {1, 2, 6},
                                {1, 6, 5},
                                {2, 3, 7},
                                {2, 7, 6},
                                {3, 0, 4},
                                {3, 4, 7}});
}

Normals put_on(const Shape& shape, const Control& control, Mesh& mesh)
{
  const Normals normals = mesh.add_property_map<Mesh::Vertex_index, Vector>("v:normal").first;
  for (const auto& d : control.directions) {
    const auto [p, n] = shape.sample(d);
    normals[mesh.add_vertex(Point(p[0], p[1], p[2]))] = Vector(n[0], n[1], n[2]);
  }
  for (const Face& face : control.faces) {
    std::vector<Mesh::Vertex_index> corners;
    for (const std::size_t v : face) corners.emplace_back(static_cast<Mesh::size_type>(v));
    mesh.add_face(corners);
  }
  return normals;
}

Point center(const Shape& shape)
{
  return Point(shape.center[0], shape.center[1], shape.center[2]);
}

Kernel::Sphere_3 exact_shape(const Shape& shape, std::true_type)
{
  return Kernel::Sphere_3(center(shape), Number(shape.radius * shape.radius));
}
PN::Cylinder_3<Kernel> exact_shape(const Shape& shape, std::false_type)
{
  const Vector axis(shape.axis[0], shape.axis[1], shape.axis[2]);
  return {Kernel::Line_3(center(shape), axis), Number(shape.radius * shape.radius)};
}

template <class Deviation>
bool is_proved(const Deviation& d)
{
  return CGAL::certainly(d.points_are_on_shape) && CGAL::certainly(d.normals_are_exact) &&
         d.squared_deviation == Number(0) && d.squared_normal_deviation == Number(0);
}

// What is proved, and that a point and a normal that are hardly moved are refused, by name.
template <class Of_scheme, class Is_sphere>
void certify(const std::string& name, const Of_scheme& scheme, const Control& control,
             const Shape& shape, Is_sphere is_sphere)
{
  const std::string what = name + ", " + control.name + (is_sphere ? ", sphere" : ", cylinder");
  Mesh mesh;
  const Normals normals = put_on(shape, control, mesh);
  const std::size_t before = mesh.number_of_vertices();
  PN::subdivide(mesh, scheme, params::vertex_normal_map(normals));
  const auto exact = exact_shape(shape, is_sphere);
  const auto deviation = [&] {
    return PN::mesh_deviation(mesh, exact, params::vertex_normal_map(normals));
  };
  check(mesh.number_of_vertices() > before, what + ": refined");
  check(is_proved(deviation()), what + ": proved");

  const Mesh::Vertex_index last(static_cast<Mesh::size_type>(mesh.number_of_vertices() - 1));
  const Point p = mesh.point(last);
  const Vector n = normals[last];
  mesh.point(last) = p + Number(tiny) * n;
  const auto moved = deviation();
  check(CGAL::certainly_not(moved.points_are_on_shape) && moved.farthest_point == last,
        what + ": a moved point is refused");
  mesh.point(last) = p;
  normals[last] = n + Number(tiny) * Vector(n.y() - n.z(), n.z() - n.x(), n.x() - n.y());
  const auto turned = deviation();
  check(CGAL::certainly_not(turned.normals_are_exact) && turned.most_turned_normal == last &&
          CGAL::certainly(turned.points_are_on_shape),
        what + ": a turned normal is refused");
}

template <class Of_scheme>
void certify(const std::string& name, const Of_scheme& scheme, const Control& control)
{
  certify(name, scheme, control, rational_shapes::sphere(), std::true_type());
  certify(name, scheme, control, rational_shapes::cylinder(), std::false_type());
}

// The linear scheme does not keep the sphere: the proof is one of the formula.
void linear_subdivision_is_refused()
{
  const Shape shape = rational_shapes::sphere();
  Mesh mesh;
  put_on(shape, quads(), mesh);
  PN::subdivide(mesh, PN::linear(PN::CatmullClark_scheme()));
  check(CGAL::certainly_not(
          PN::mesh_deviation(mesh, exact_shape(shape, std::true_type())).points_are_on_shape),
        "linear subdivision leaves the sphere");
}

// --- curves ---

void curves_keep_circles()
{
  const Kernel::Point_2 middle(Number(rational_shapes::Rational(1, 2)), Number(-3));
  const Number radius = rational_shapes::Rational(7, 3);
  const Kernel::Circle_2 circle(middle, radius * radius);
  Curve polygon;
  for (const double angle : {0.1, 1.3, 2., 3.2, 4.4, 5.7}) {
    const auto n = rational_shapes::unit_2(std::cos(angle), std::sin(angle));
    const Kernel::Vector_2 normal(n[0], n[1]);
    polygon.emplace_back(middle + radius * normal, normal);
  }
  for (const PN::Curve_end end : {PN::Curve_end::closed, PN::Curve_end::reflect}) {
    Curve curve = PN::subdivide_curve(polygon, PN::B_spline_mask(3), end);
    check(curve.size() > polygon.size() && is_proved(PN::curve_deviation(curve, circle)),
          "the circle is kept");
    curve[1].first = curve[1].first + Number(tiny) * curve[1].second;
    const auto moved = PN::curve_deviation(curve, circle);
    check(CGAL::certainly_not(moved.points_are_on_shape) && moved.farthest_point == 1,
          "a point off the circle is refused");
  }
}

} // namespace

int main()
{
  for (const Control& control : {quads(), open_quads()}) {
    certify("Catmull-Clark", PN::CatmullClark_scheme(), control);
    certify("Doo-Sabin", PN::DooSabin_scheme(), control);
  }
  for (const Control& control : {triangles(), open_triangles()})
    certify("Loop", PN::Loop_scheme(), control);
  linear_subdivision_is_refused();
  curves_keep_circles();
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

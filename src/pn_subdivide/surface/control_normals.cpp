// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/control_normals.h"

#include "io/Error.h"
#include "io/parse_numbers.h"
#include "surface/Surface.h"

#include <CGAL/PN_subdivision_3.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pn_subdivide {
namespace {

using Source = Normals_option::Source;

// In long double, so that normals of exact control data are correct to the last bit or nearly so.
using Long_vector = CGAL::Simple_cartesian<long double>::Vector_3;

Long_vector between(const Point_3& p, const Point_3& q)
{
  return Long_vector(static_cast<long double>(q.x()) - p.x(),
                     static_cast<long double>(q.y()) - p.y(),
                     static_cast<long double>(q.z()) - p.z());
}

Vector_3 unit(const Long_vector& v)
{
  const long double length = std::sqrt(v.squared_length());
  if (!(length > 0)) return Vector_3(0, 0, 0);
  return Vector_3(static_cast<double>(v.x() / length), static_cast<double>(v.y() / length),
                  static_cast<double>(v.z() / length));
}

void point_away(Mesh_data& mesh, const Normals_option& option)
{
  const Long_vector d(option.axis.x(), option.axis.y(), option.axis.z());
  mesh.normals.clear();
  mesh.normals.reserve(mesh.points.size());
  for (const Point_3& p : mesh.points) {
    Long_vector v = between(option.center, p);
    if (option.source == Source::cylinder) v = v - d * ((v * d) / d.squared_length());
    mesh.normals.push_back(unit(v));
  }
}

void estimate(Mesh_data& mesh)
{
  mesh.normals.clear();
  Surface surface = make_surface(mesh);
  auto normals = surface.add_property_map<Surface::Vertex_index, Vector_3>("v:normal").first;
  CGAL::PN_subdivision_3::estimate_control_normals(surface, normals);
  mesh.normals.reserve(mesh.points.size());
  for (const Surface::Vertex_index v : surface.vertices()) mesh.normals.push_back(normals[v]);
}

// As the library does it on entry, so that no round and several rounds start from the same normals.
Vector_3 normalized(const Vector_3& n)
{
  using Traits = CGAL::PN_subdivision_3::Unit_normal_traits<double>;
  if (std::abs(n.squared_length() - 1) <= Traits::unit_tolerance()) return n;
  const double largest = (std::max)({std::abs(n.x()), std::abs(n.y()), std::abs(n.z())});
  if (largest == 0) return n;
  const Vector_3 scaled = n / largest;
  return scaled * Traits::inverse_length(scaled.squared_length());
}

} // namespace

Normals_option parse_normals_option(const std::string& text)
{
  Normals_option option;
  const auto [name, arguments] = split_at_colon(text);

  if (text == "auto")
    option.source = Source::automatic;
  else if (text == "file")
    option.source = Source::file;
  else if (text == "estimate")
    option.source = Source::estimate;
  else if (text == "none")
    option.source = Source::none;
  else if (name == "sphere") {
    const std::vector<double> x = parse_numbers(arguments, 3, "--normals sphere:X,Y,Z");
    option.source = Source::sphere;
    option.center = Point_3(x[0], x[1], x[2]);
  } else if (name == "cylinder") {
    const std::vector<double> x = parse_numbers(arguments, 6, "--normals cylinder:X,Y,Z,DX,DY,DZ");
    require_direction(&x[3], "--normals cylinder");
    option.source = Source::cylinder;
    option.center = Point_3(x[0], x[1], x[2]);
    const double largest = (std::max)({std::abs(x[3]), std::abs(x[4]), std::abs(x[5])});
    option.axis = Vector_3(x[3] / largest, x[4] / largest, x[5] / largest);
  } else
    throw Usage_error("--normals '" + text + "': expected auto, file, estimate, none, " +
                      "sphere:X,Y,Z or cylinder:X,Y,Z,DX,DY,DZ");
  return option;
}

void set_control_normals(Mesh_data& mesh, const Normals_option& option)
{
  switch (option.source) {
  case Source::file:
    if (!mesh.has_normals())
      throw Error("--normals file, but the file has no vertex normals; --normals estimate makes "
                  "some");
    break;
  case Source::automatic:
    if (!mesh.has_normals()) estimate(mesh);
    break;
  case Source::estimate:
    estimate(mesh);
    break;
  case Source::none:
    mesh.normals.clear();
    break;
  case Source::sphere:
  case Source::cylinder:
    point_away(mesh, option);
    break;
  }
  for (Vector_3& n : mesh.normals) n = normalized(n);
}

} // namespace pn_subdivide

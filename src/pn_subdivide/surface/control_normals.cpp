// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
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

namespace PN = CGAL::PN_subdivision_3;

using Source = Normals_option::Source;

// In long double, so that normals of exact control data are correct to the last bit or nearly so.
using Long_vector = CGAL::Simple_cartesian<long double>::Vector_3;

Long_vector between(const Triple& p, const Triple& q)
{
  return Long_vector(static_cast<long double>(q[0]) - p[0], static_cast<long double>(q[1]) - p[1],
                     static_cast<long double>(q[2]) - p[2]);
}

Triple unit(const Long_vector& v)
{
  const long double length = std::sqrt(v.squared_length());
  if (!(length > 0)) return {0, 0, 0};
  return {static_cast<double>(v.x() / length), static_cast<double>(v.y() / length),
          static_cast<double>(v.z() / length)};
}

void point_away(Mesh_data& mesh, const Normals_option& option)
{
  const Long_vector d(option.axis[0], option.axis[1], option.axis[2]);
  mesh.normals.clear();
  mesh.normals.reserve(mesh.points.size());
  for (const Triple& p : mesh.points) {
    Long_vector v = between(option.center, p);
    if (option.source == Source::cylinder) v = v - d * ((v * d) / d.squared_length());
    mesh.normals.push_back(unit(v));
  }
}

void estimate(Mesh_data& mesh, PN::Control_normal_estimate how)
{
  mesh.normals.clear();
  Surface surface = make_surface(mesh);
  auto normals = surface.add_property_map<Surface::Vertex_index, Vector_3>("v:normal").first;
  PN::estimate_control_normals(surface, normals, CGAL::parameters::default_values(), how);
  mesh.normals.reserve(mesh.points.size());
  for (const Surface::Vertex_index v : surface.vertices())
    mesh.normals.push_back(to_triple(normals[v]));
}

// As the library does it on entry, so that no round and several rounds start from the same normals.
Vector_3 normalized(const Vector_3& n)
{
  using Traits = PN::Unit_normal_traits<double>;
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
  else if (text == "angle")
    option.source = Source::angle;
  else if (text == "none")
    option.source = Source::none;
  else if (name == "sphere") {
    const std::vector<double> x = parse_numbers(arguments, 3, "--normals sphere:X,Y,Z");
    option.source = Source::sphere;
    option.center = {x[0], x[1], x[2]};
  } else if (name == "cylinder") {
    const std::vector<double> x = parse_numbers(arguments, 6, "--normals cylinder:X,Y,Z,DX,DY,DZ");
    require_direction(&x[3], "--normals cylinder");
    option.source = Source::cylinder;
    option.center = {x[0], x[1], x[2]};
    const double largest = (std::max)({std::abs(x[3]), std::abs(x[4]), std::abs(x[5])});
    option.axis = {x[3] / largest, x[4] / largest, x[5] / largest};
  } else
    throw Usage_error("--normals '" + text + "': expected auto, file, estimate, angle, none, " +
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
    if (!mesh.has_normals()) estimate(mesh, PN::Control_normal_estimate::reciprocal);
    break;
  case Source::estimate:
    estimate(mesh, PN::Control_normal_estimate::reciprocal);
    break;
  case Source::angle:
    estimate(mesh, PN::Control_normal_estimate::angle);
    break;
  case Source::none:
    mesh.normals.clear();
    break;
  case Source::sphere:
  case Source::cylinder:
    point_away(mesh, option);
    break;
  }
  for (Triple& n : mesh.normals) n = to_triple(normalized(to_vector(n)));
}

} // namespace pn_subdivide

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/verification.h"

#include "io/Error.h"
#include "io/Text_reader.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

namespace pn_subdivide {
namespace {

constexpr double ulp = std::numeric_limits<double>::epsilon(); // 2^-52

template <class Point, class Vector>
const Point& point_of(const std::pair<Point, Vector>& item)
{
  return item.first;
}
const Curve_kernel::Point_3& point_of(const Curve_kernel::Point_3& p)
{
  return p;
}

// Scaled by a power of two: its square neither overflows nor vanishes then. Exact, but for
// coordinates beside which others are far greater.
Curve_kernel::Vector_3 of_size_one(const Curve_kernel::Vector_3& d)
{
  const int e = -std::ilogb((std::max)({std::abs(d.x()), std::abs(d.y()), std::abs(d.z())}));
  return {std::scalbn(d.x(), e), std::scalbn(d.y(), e), std::scalbn(d.z(), e)};
}

} // namespace

Verification::Parts Verification::parse_parts(const std::string& text)
{
  const auto [kind, arguments] = split_at_colon(text);
  const std::string option = "--verify " + kind;
  std::vector<double> x;
  if (kind == "sphere")
    x = parse_numbers(arguments, 4, option + ":X,Y,Z,R");
  else if (kind == "cylinder")
    x = parse_numbers(arguments, 7, option + ":X,Y,Z,DX,DY,DZ,R");
  else if (kind == "circle") {
    x = parse_numbers(arguments, option);
    if (x.size() != 3 && x.size() != 7)
      throw Usage_error(option + ": X,Y,R or, in space, X,Y,Z,NX,NY,NZ,R are expected");
  } else
    throw Usage_error("--verify '" + text +
                      "': expected sphere:X,Y,Z,R, cylinder:X,Y,Z,DX,DY,DZ,R, circle:X,Y,R or "
                      "circle:X,Y,Z,NX,NY,NZ,R");
  if (!(x.back() > 0)) throw Usage_error(option + ": the radius must be positive");
  if (x.size() == 7) require_direction(&x[3], option);
  Parts parts{{x[0], x[1], x.size() > 3 ? x[2] : 0}, {0, 0, 0}, x.back()};
  if (x.size() == 7) parts.direction = of_size_one(Curve_kernel::Vector_3(x[3], x[4], x[5]));
  return parts;
}

Verification::Shape Verification::make_shape(const std::string& text, const Parts& parts)
{
  const auto& c = parts.center;
  const auto& d = parts.direction;
  const Exact::Point_3 center(c.x(), c.y(), c.z());
  const Exact::Vector_3 direction(d.x(), d.y(), d.z());
  const Exact::FT squared_radius = CGAL::square(Exact::FT(parts.radius));
  const std::string kind = split_at_colon(text).first;
  if (kind == "sphere") return Exact::Sphere_3(center, squared_radius);
  if (kind == "cylinder")
    return PN::Cylinder_3<Exact>(Exact::Line_3(center, direction), squared_radius);
  if (direction == CGAL::NULL_VECTOR)
    return Exact::Circle_2(Exact::Point_2(c.x(), c.y()), squared_radius);
  return Exact::Circle_3(center, squared_radius, direction);
}

Verification::Verification(const Verify_options& options)
  : text_(*options.shape)
  , parts_(parse_parts(text_))
  , shape_(make_shape(text_, parts_))
  , tolerance_(options.tolerance)
{
  if (tolerance_ && !(*tolerance_ >= 0))
    throw Usage_error("--tolerance: it must be a number that is not negative");
}

void Verification::require_surface() const
{
  if (std::holds_alternative<Exact::Circle_2>(shape_) ||
      std::holds_alternative<Exact::Circle_3>(shape_))
    throw Usage_error("--verify " + text_ +
                      ": no surface is a circle; surfaces take sphere and cylinder");
}

// How far from the origin the center is or, on a cylinder, the axis beside any of the points.
template <class Points>
double Verification::farthest_center(const Points& points) const
{
  const Curve_kernel::Vector_3 c = parts_.center - CGAL::ORIGIN;
  double squared = c.squared_length();
  if (std::holds_alternative<PN::Cylinder_3<Exact>>(shape_)) {
    squared = 0;
    const auto& d = parts_.direction;
    for (const auto& item : points)
      if constexpr (std::is_same_v<std::decay_t<decltype(point_of(item))>, Curve_kernel::Point_3>) {
        const double t = (point_of(item) - parts_.center) * d / d.squared_length();
        squared = (std::max)(squared, (c + t * d).squared_length());
      }
  }
  return std::sqrt(squared);
}

template <class Points>
void Verification::measure_points(const Points& points)
{
  using Point = std::decay_t<decltype(point_of(points.front()))>;
  std::visit(
    [&](const auto& shape) {
      constexpr bool planar_shape = std::is_same_v<std::decay_t<decltype(shape)>, Exact::Circle_2>;
      if constexpr (planar_shape == std::is_same_v<Point, Curve_kernel::Point_2>)
        deviation_ = PN::curve_deviation(points, shape).distance.sup();
      else
        throw Error(planar_shape ? "--verify " + text_ +
                                     ": the curve is in space; a circle there is given "
                                     "as circle:X,Y,Z,NX,NY,NZ,R"
                                 : "--verify " + text_ +
                                     ": the curve is in the plane; only circle:X,Y,R is "
                                     "there");
    },
    shape_);
  bound_ = (5 * parts_.radius + 3 * farthest_center(points)) * ulp;
}

void Verification::measure(const std::vector<Triple>& triples)
{
  std::vector<Curve_kernel::Point_3> points;
  points.reserve(triples.size());
  for (const Triple& t : triples) points.emplace_back(t[0], t[1], t[2]);
  measure_points(points);
}

void Verification::measure(const Curve_data& curve)
{
  std::visit([this](const auto& points) { measure_points(points); }, curve.points);
}

void Verification::print(std::FILE* stream) const
{
  std::fprintf(stream, "deviation %.6g (D/R in 2^-52: %.6g) bound %.6g\n", deviation_,
               deviation_ / parts_.radius / ulp, bound_);
  if (std::fflush(stream) != 0 || std::ferror(stream))
    throw Error("--verify: the deviation cannot be printed");
}

void Verification::require_tolerance() const
{
  if (tolerance_ && deviation_ > *tolerance_ * parts_.radius)
    throw Tolerance_error(formatted("the deviation %.6g is more than %.6g times the radius %.6g",
                                    deviation_, *tolerance_, parts_.radius));
}

} // namespace pn_subdivide

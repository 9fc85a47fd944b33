// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_CERTIFICATES_3_REPRODUCTION_H
#define CGAL_PN_CERTIFICATES_3_REPRODUCTION_H

#include <CGAL/Dimension.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/PN_certificates_3/internal/Shape_measure.h>
#include <CGAL/PN_certificates_3/internal/measure_number.h>
#include <CGAL/PN_curves/internal/Curve_points.h>
#include <CGAL/PN_subdivision_3/internal/average/input_checks.h>
#include <CGAL/PN_subdivision_3/internal/hosts/check_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
#include <CGAL/Uncertain.h>

#include <boost/graph/graph_traits.hpp>

#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace CGAL::PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Reproduction

A circular cylinder: the points at a given distance from a line.

\tparam Kernel a model of `Kernel`
*/
template <class Kernel>
class Cylinder_3
{
public:
  /// the number type.
  using FT = typename Kernel::FT;
  /// the type of the axis.
  using Line_3 = typename Kernel::Line_3;

  /// the cylinder of radius R about the axis, given R<sup>2</sup>.
  Cylinder_3(const Line_3& axis, const FT& squared_radius)
    : axis_(axis)
    , squared_radius_(squared_radius)
  {}

  /// the axis.
  const Line_3& axis() const { return axis_; }
  /// the squared radius.
  const FT& squared_radius() const { return squared_radius_; }

private:
  Line_3 axis_;
  FT squared_radius_;
};

/*!
\ingroup PkgPNSubdivision3Reproduction

The deviation of a mesh or curve from a shape, as `mesh_deviation()` and `curve_deviation()` return it.

\tparam Number see `Deviation_number`
\tparam Element the vertex descriptor of a mesh; the position in a curve
*/
template <class Number_, class Element_>
struct Deviation
{
  /// the number type of the deviations.
  using Number = Number_;
  /// names the vertex of a deviation.
  using Element = Element_;

  /// how many points were looked at
  std::size_t number_of_points = 0;
  /// the `squared_deviation()` of the point that is farthest from the shape
  Number squared_deviation = Number(0);
  /// that point; of several equal ones the first
  Element farthest_point = Element();
  /// an interval around the largest distance of all points from the shape
  Interval_nt<> distance = 0;
  /// whether all points are on the shape, without any tolerance
  Uncertain<bool> points_are_on_shape = true;

  /// how many normals were looked at: those that are not zero
  std::size_t number_of_normals = 0;
  /// the largest `squared_normal_deviation()`
  Number squared_normal_deviation = Number(0);
  /// the point whose normal it is
  Element most_turned_normal = Element();
  /// an interval around the largest sine of all normals
  Interval_nt<> normal_sine = 0;
  /// whether all normals are those of the shape or opposite to them
  Uncertain<bool> normals_are_exact = true;

  /// empty, or what to do where one of the two answers is indeterminate: the message names a header and a function
  const char* advice = "";
};

/*!
\ingroup PkgPNSubdivision3Reproduction

The number type of the deviations of coordinates in `FT`. It is `FT` itself for exact numbers and intervals.
It is `CGAL::Exact_rational` for floating point types, `Gmpfr` and all types that round and have the radix 2 by their
`std::numeric_limits`, since it holds their numbers as they are. So deviations are never rounded. Other types that
round are refused when they are compiled.
*/
#ifdef DOXYGEN_RUNNING
template <class FT>
using Deviation_number = unspecified_type;
#else
template <class FT>
using Deviation_number = internal::Measure_number<FT>;
#endif

namespace internal {

template <class Point_or_vector>
using FT_of = typename CGAL::Kernel_traits<Point_or_vector>::Kernel::FT;

template <class Point>
using Number_of_point = Measure_number<FT_of<Point>>;

template <class Point, class Shape>
auto shape_for(const Shape& shape)
{
  auto measure = shape_measure<Number_of_point<Point>>(shape);
  measure.check();
  static_assert(decltype(measure)::dimension == Ambient_dimension<Point>::value,
                "the shape and the point must have the same dimension");
  return measure;
}

template <class Point, class Point_or_vector, class Name>
auto checked_coordinates(const Point_or_vector& p, const char* what, const Name& name)
{
  constexpr int dimension = Ambient_dimension<Point>::value;
  using FT = FT_of<Point>;
  Coordinates<FT, dimension> c;
  for (int i = 0; i < dimension; ++i) c[i] = FT(p.cartesian(i));
  check_finite<FT, dimension>(c, what, name);
  return measure_coordinates<Number_of_point<Point>, dimension>(p);
}

inline std::string the_point()
{
  return "the point";
}
template <class Point>
auto position_of(const Point& p)
{
  return checked_coordinates<Point>(p, "position", the_point);
}

template <class FT, class Number>
Number unit_of_last_place()
{
  if constexpr (is_exact_v<FT>)
    return Number(std::numeric_limits<double>::epsilon());
  else
    return measure_number<Number>(machine_epsilon<FT>());
}

// of the items of a range; element(item, i) names the i-th one
template <class Range, class Point_map, class Normal_map, class Shape, class Name_element>
auto deviation_of(const Range& range, const char* kind, Point_map points,
                  [[maybe_unused]] Normal_map normals, const Shape& shape,
                  const Name_element& element)
{
  using Point = std::decay_t<typename boost::property_traits<Point_map>::value_type>;
  using FT = FT_of<Point>;
  using Element = decltype(element(*std::begin(range), std::size_t()));
  const auto measure = shape_for<Point>(shape);
  Deviation_of_all<FT, Deviation<Deviation_number<FT>, Element>, decltype(measure)> all(measure);
  std::size_t i = 0;
  const auto name = [&] { return numbered_name(kind, i); };
  for (const auto& item : range) {
    const auto p = checked_coordinates<Point>(get(points, item), "position", name);
    all.add_point(element(item, i), p);
    if constexpr (is_there_v<Normal_map>)
      all.add_normal(element(item, i), p,
                     checked_coordinates<Point>(get(normals, item), "normal", name));
    ++i;
  }
  return all.result();
}

} // namespace internal

/*!
\ingroup PkgPNSubdivision3Reproduction

returns how far a point is from a shape, as a number that is 0 on the shape and only there, without
roots and without rounding:
 - plane and line: d<sup>2</sup>, where d is the distance;
 - sphere, cylinder, circle in the plane: (|r|<sup>2</sup> - R<sup>2</sup>)<sup>2</sup> /
   4R<sup>2</sup> = d<sup>2</sup> (1 &plusmn; d/2R)<sup>2</sup>, where r is the vector from the center
   or axis, + outside and - inside;
 - circle in space: the latter, with r in its plane, plus the squared distance from the plane.

\tparam Point `Point_2` or `Point_3` of any kernel
\tparam Shape `Circle_2`, `Line_2`, `Sphere_3`, `Circle_3`, `Plane_3` or `Line_3` of any kernel whose numbers are
  exact or of radix 2, or `Cylinder_3`. Its kernel may be another one than that of the point: the squared
  radius 1.1<sup>2</sup> has no exact `double`. Shapes of intervals go with points of intervals.
\returns a `Deviation_number<FT>` for the number type `FT` of the point; an interval number type
  gives an interval around the deviation
\throws std::invalid_argument if the point or the shape is not finite, a floating point coordinate is out of the range
  of `double`, the squared radius of the shape is not positive, or its direction is zero
*/
template <class Point, class Shape>
auto squared_deviation(const Point& p, const Shape& shape)
{
  const auto measure = internal::shape_for<Point>(shape);
  return measure.squared_deviation(measure.residual(internal::position_of(p)));
}

/*!
\ingroup PkgPNSubdivision3Reproduction

returns sin<sup>2</sup> of the angle between a vector and the normal of the shape at a point, that is
|n &times; r|<sup>2</sup> / |n|<sup>2</sup>|r|<sup>2</sup>, where r is the vector from the center or
axis, without rounding; for a line in space, which has many normals, of the angle between the vector
and the plane perpendicular to the line. The point need not be on the shape. Vectors of opposite
direction have the same deviation; the length of the vector does not matter.

\returns a number of the type that `squared_deviation()` returns; 1 if the point is the center or on
  the axis
\throws std::invalid_argument also if `n` is the zero vector
*/
template <class Vector, class Point, class Shape>
auto squared_normal_deviation(const Vector& n, const Point& p, const Shape& shape)
{
  const auto measure = internal::shape_for<Point>(shape);
  const auto normal = internal::checked_coordinates<Point>(n, "normal", internal::the_point);
  if (certainly(measure.squared_length(normal) == internal::Number_of_point<Point>(0)))
    throw std::invalid_argument("PN_subdivision_3: the normal is the zero vector, whose deviation "
                                "is undefined: give another one");
  return measure.squared_sine(normal, internal::position_of(p));
}

/*!
\ingroup PkgPNSubdivision3Reproduction

returns an interval of two doubles around the Euclidean distance of a point from a shape. It is a few
units in the last place wide unless the coordinates are intervals, whatever the cancellation: it is
rounded once, from exact numbers.

\tparam Point, Shape as for `squared_deviation()`
*/
template <class Point, class Shape>
Interval_nt<> distance_interval(const Point& p, const Shape& shape)
{
  const auto measure = internal::shape_for<Point>(shape);
  return measure.distance(measure.residual(internal::position_of(p))).interval();
}

/*!
\ingroup PkgPNSubdivision3Reproduction

returns an interval around the distance of a point from a shape in units of the last place. The distance is relative to
the radius, for planes and lines as it is, and divided by the epsilon of the point's number type. The epsilon is that of
`std::numeric_limits`, that of the default precision of `Gmpfr` and `Gmpfi`, and 2<sup>-52</sup> for exact types.

\tparam Point, Shape as for `squared_deviation()`
*/
template <class Point, class Shape>
Interval_nt<> distance_in_ulps(const Point& p, const Shape& shape)
{
  using FT = internal::FT_of<Point>;
  using Number = internal::Number_of_point<Point>;
  const auto measure = internal::shape_for<Point>(shape);
  const auto ulp = internal::Scaled_interval::of(internal::unit_of_last_place<FT, Number>());
  const auto distance = measure.distance(measure.residual(internal::position_of(p)));
  return (distance / (measure.is_round() ? measure.radius() * ulp : ulp)).interval();
}

/*!
\ingroup PkgPNSubdivision3Reproduction

returns whether a point is on a shape, which in exact numbers is a proof that it is kept:
 - where lengths of normals are exact (fields with square root, `Sqrt_extension` with the header `sqrt_extension_normals.h`)
   `true` or `false`;
 - where they are rounded (`Gmpq`, EPECK, `Sqrt_extension` without the header; `Unit_normal_traits::rounds_exact_numbers`) `true` or
   `indeterminate`, since a point may have left the shape for that alone;
 - for intervals `true`, `false` or `indeterminate`;
 - for floating point numbers `true` or `false` as they are: computed points that are on a sphere up to rounding are not on it.

`CGAL::Uncertain<bool>` converts to `bool`, which throws if it is indeterminate. Whether the coordinates as they are
fulfill the equation of the shape is told by the tolerance 0 below.

\tparam Point, Shape as for `squared_deviation()`
*/
template <class Point, class Shape>
Uncertain<bool> is_on(const Point& p, const Shape& shape)
{
  const auto r = internal::shape_for<Point>(shape).residual(internal::position_of(p));
  using FT = internal::FT_of<Point>;
  return internal::is_proved_zero<FT>(r.radial) & internal::is_proved_zero<FT>(r.squared_distance);
}

/*!
\ingroup PkgPNSubdivision3Reproduction

returns whether the distance of a point from a shape is at most `tolerance` times its radius, or for
planes and lines at most `tolerance`. The answer is certified: it is not computed with rounding, and
for intervals it may be indeterminate.

For `double`, `5 * std::numeric_limits<double>::epsilon()` as tolerance asks for 5 units of
2<sup>-52</sup>.

\tparam Point, Shape as for `squared_deviation()`
\throws std::invalid_argument also if `tolerance` is negative or not finite
*/
template <class Point, class Shape>
Uncertain<bool> is_on(const Point& p, const Shape& shape, double tolerance)
{
  using Number = internal::Number_of_point<Point>;
  if (!(tolerance >= 0 && std::isfinite(tolerance)))
    throw std::invalid_argument(
      "PN_subdivision_3: the tolerance must be a finite number that is not negative");
  const auto measure = internal::shape_for<Point>(shape);
  return measure.is_near(measure.residual(internal::position_of(p)), Number(tolerance));
}

/*!
\ingroup PkgPNSubdivision3Reproduction

returns how far the vertices of a mesh, and their normals, are from a shape. Nothing is rounded but
the two intervals of the result; in particular an exact number type proves that all points are on the shape, or refutes
it if lengths of normals are exact, see `is_on()`.

\tparam PolygonMesh a model of `VertexListGraph` with a vertex point map
\tparam Shape `Sphere_3`, `Circle_3`, `Plane_3` or `Line_3` of any kernel, or `Cylinder_3`
\param mesh the mesh
\param shape the shape
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `vertex_point_map`,
  and `vertex_normal_map`, without which no normals are looked at; as in `subdivide()`
\returns a `Deviation<Deviation_number<FT>, boost::graph_traits<PolygonMesh>::%vertex_descriptor>`
\throws std::invalid_argument as `squared_deviation()` does; the message names the vertex
<br><b>Cost:</b> linear in the number of vertices; some microseconds a vertex
*/
template <class PolygonMesh, class Shape,
          class NamedParameters = parameters::Default_named_parameters>
auto mesh_deviation(const PolygonMesh& mesh, const Shape& shape,
                    const NamedParameters& np = parameters::default_values())
{
  internal::check_are_read<NamedParameters>();
  using Parameters = internal::Surface_parameters<PolygonMesh, NamedParameters>;
  using Vertex = typename boost::graph_traits<PolygonMesh>::vertex_descriptor;
  return internal::deviation_of(vertices(mesh), "vertex", Parameters::const_point_map(mesh, np),
                                Parameters::normal_map(np), shape,
                                [](Vertex v, std::size_t) { return v; });
}

/*!
\ingroup PkgPNSubdivision3Reproduction

returns how far the points of a curve, and its normals, are from a shape, see `mesh_deviation()`.

\tparam Range a model of `ConstRange` whose items are points, pairs of a point and a normal as
  `subdivide_curve()` returns them, or anything that the named parameters make points and normals of
\tparam Shape `Circle_2` or `Line_2` for a planar curve; for a curve in space as for
  `mesh_deviation()`
\param curve the curve
\param shape the shape
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `point_map` and
  `normal_map`. The normals of pairs are looked at without it, those of other items not.
\returns a `Deviation<Deviation_number<FT>, std::size_t>` whose elements are positions in the range
\throws std::invalid_argument as `squared_deviation()` does; the message gives the position
<br><b>Cost:</b> linear in the number of points; some microseconds a point
*/
template <class Range, class Shape, class NamedParameters = parameters::Default_named_parameters>
auto curve_deviation(const Range& curve, const Shape& shape,
                     const NamedParameters& np = parameters::default_values())
{
  internal::check_are_read<NamedParameters>();
  using Points = internal::Curve_points<Range, NamedParameters>;
  return internal::deviation_of(curve, "point", Points::point_map(np), Points::normal_map(np),
                                shape, [](const auto&, std::size_t i) { return i; });
}

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_CERTIFICATES_3_REPRODUCTION_H

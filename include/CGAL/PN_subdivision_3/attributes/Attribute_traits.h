// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_ATTRIBUTES_ATTRIBUTE_TRAITS_H
#define CGAL_PN_SUBDIVISION_3_ATTRIBUTES_ATTRIBUTE_TRAITS_H

#include <CGAL/Kernel_traits.h>
#include <CGAL/number_type_basic.h>

#include <boost/type_traits/is_detected.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Attributes
how the values of corners are refined. Inside the charts, where values agree, the scheme's linear rows apply. At seams
and borders of charts one of the six rules applies that OpenSubdiv has for face-varying data.

Seams and borders are refined as borders of the surface. The rules differ in what stays where it is. Whatever the
rule, the value of a chart stays at three kinds of vertices: with a sharp edge inside the chart, at corners of the
surface, and where several parts of the chart meet.
*/
enum class Corner_rule {
  /// nothing else stays.
  none,
  /// the values of charts that have one face at a vertex.
  corners_only,
  /// as `corners_only`, and all values at vertices that three or more charts meet at; of two charts at a vertex,
  /// both or none are kept for sharp edges inside.
  corners_plus1,
  /// as `corners_plus1`, and the values at ends of seams inside a chart, and both values at vertices where one of
  /// two charts has one face, so also that of the concave corner beside it.
  corners_plus2,
  /// all values at seams and borders, which are straight then.
  boundaries,
  /// all values: linearly inside every face.
  all
};

/*!
\ingroup PkgPNSubdivision3Attributes
how the values of vertices are refined.
*/
enum class Attribute_rule {
  /// they are averaged by the linear rows of the scheme.
  average,
  /// labels: every value is that of the nearest control vertex, by linear interpolation inside the control faces; of
  /// several nearest ones, that of the first.
  nearest,
  /// directions: they are averaged, and divided by their length in the end. Zero stays zero.
  direction
};

namespace internal {

// the base of traits that compute in the values themselves, by + and a product
struct Arithmetic_of_values
{};

template <class T, class FT>
using Product_of = decltype(T(std::declval<const T&>() * std::declval<const FT&>()));
template <class T, class FT>
using Has_product = boost::is_detected<Product_of, T, FT>;

template <class T>
using Product_with_weight_first = decltype(T(std::declval<double>() * std::declval<const T&>()));
template <class T>
using Has_product_with_weight_first = boost::is_detected<Product_with_weight_first, T>;

// w v for a value of the user's, with the weight on whatever side and in whatever precision it is taken
template <class T, class FT>
T scaled_value(const T& v, const FT& w)
{
  if constexpr (Has_product<T, FT>::value)
    return T(v * w);
  else if constexpr (Has_product<T, double>::value)
    return T(v * double(CGAL::to_double(w)));
  else
    return T(double(CGAL::to_double(w)) * v);
}

// A component of an attribute, which is computed in FT. Integers are rounded, and kept in the range of their type.
template <class T, class FT>
FT component_to_ft(const T& t)
{
  if constexpr (std::is_same_v<T, FT>)
    return t;
  else
    return FT(static_cast<double>(t));
}
template <class T, class FT>
T component_from_ft(const FT& x)
{
  if constexpr (std::is_same_v<T, FT>)
    return x;
  else if constexpr (std::is_integral_v<T>) {
    const double rounded = std::round(double(CGAL::to_double(x)));
    constexpr auto least = (std::numeric_limits<T>::min)(), most = (std::numeric_limits<T>::max)();
    if (!(rounded > static_cast<double>(least))) return least;
    return rounded < static_cast<double>(most) ? static_cast<T>(rounded) : most;
  } else
    return static_cast<T>(CGAL::to_double(x));
}

template <class T, class FT>
constexpr bool is_component_v = std::is_arithmetic_v<T> || std::is_same_v<T, FT>;

template <class FT, std::size_t n>
struct Components
{
  using Sum = std::array<FT, n>;
  static constexpr bool has_components = true;
  static constexpr Attribute_rule rule = Attribute_rule::average;
};

template <class T, class = void>
struct Cartesian_dimension
{
  static constexpr int value = 0;
};
template <class T>
struct Cartesian_dimension<T, std::void_t<typename Kernel_traits<T>::Kernel::Vector_2>>
{
  using Kernel = typename Kernel_traits<T>::Kernel;
  template <class U>
  static constexpr bool is = std::is_same_v<T, U>;
  static constexpr int value = is<typename Kernel::Point_2> || is<typename Kernel::Vector_2>   ? 2
                               : is<typename Kernel::Point_3> || is<typename Kernel::Vector_3> ? 3
                                                                                               : 0;
};

// the number of numbers of a std::array, or of a vector or matrix of Eigen, below 0 if its size is dynamic
template <class T, class FT, class = void>
constexpr int size_of_data_v = 0;
template <class T, std::size_t n, class FT>
inline constexpr int
  size_of_data_v<std::array<T, n>, FT, std::enable_if_t<is_component_v<T, FT>>> = int(n);
template <class T, class FT>
inline constexpr int
  size_of_data_v<T, FT, std::void_t<typename T::Scalar, decltype(T::SizeAtCompileTime)>> =
    std::is_arithmetic_v<typename T::Scalar> ? int(T::SizeAtCompileTime) : 0;

template <class T, class = void>
constexpr bool is_color_v = false;
template <class T>
inline constexpr bool is_color_v<
  T, std::void_t<decltype(std::declval<T&>().red()), decltype(std::declval<T&>().green()),
                 decltype(std::declval<T&>().blue()), decltype(std::declval<T&>().alpha()),
                 decltype(T(std::declval<unsigned char>(), std::declval<unsigned char>(),
                            std::declval<unsigned char>(), std::declval<unsigned char>()))>> = true;

} // namespace internal

/*!
\ingroup PkgPNSubdivision3Attributes

How values of type `T` are averaged with weights of type `FT`. Specialize it for a type of your own that has no `+`
and no product with numbers, or that is to be computed in another type than itself.

`Sum` is what values are held as between the rounds; `to_sum()` and `to_value()` convert once, before the first round
and after the last. The average of v<sub>0</sub>, v<sub>1</sub>, ... is v<sub>0</sub> + &sum; w<sub>j</sub>
(v<sub>j</sub> - v<sub>0</sub>): equal values stay equal, bit for bit.

Known are
<ul>
<li> `float`, `double` and the number type of the computation itself,
<li> integers: labels at vertices, and at corners rounded and kept in their range at the end, as in arrays,
<li> enumerations: labels at vertices,
<li> `std::array` of numbers, Eigen's vectors and matrices of fixed size,
<li> points and vectors of \cgal, in 2D and 3D,
<li> `CGAL::IO::Color`, rounded and kept between 0 and 255 at the end,
<li> every other type with `a + b` and `a * w` (or `w * a`), which is computed in itself.
</ul>
*/
template <class T, class FT, class = void>
struct Attribute_traits : private internal::Arithmetic_of_values
{
  /// the rule of `parameters::vertex_attribute()`: `nearest` for integers and enumerations, `average` for all else, and where
  /// a specialization does not say. With `Attribute_rule::nearest` no other member is needed.
  static constexpr Attribute_rule rule =
    std::is_enum_v<T> ? Attribute_rule::nearest : Attribute_rule::average;

  /// the type in which values are summed.
  using Sum = T;

  /// the value as a sum of one term.
  static Sum to_sum(const T& t) { return t; }
  /// the sum as a value.
  static T to_value(const Sum& s) { return s; }
  /// `Sum` is an array of numbers `FT`, which need no `difference()`.
  static constexpr bool has_components = false;
  /// returns w (v - origin).
  static Sum difference(const FT& w, const Sum& v, const Sum& origin)
  {
    return internal::scaled_value(Sum(v + internal::scaled_value(origin, FT(-1))), w);
  }
};

/// \cond SKIP_IN_MANUAL
template <class T, class FT>
struct Attribute_traits<T, FT, std::enable_if_t<internal::is_component_v<T, FT>>>
  : internal::Components<FT, 1>
{
  static constexpr Attribute_rule rule =
    std::is_integral_v<T> ? Attribute_rule::nearest : Attribute_rule::average;
  using Sum = typename internal::Components<FT, 1>::Sum;
  static Sum to_sum(const T& t) { return {internal::component_to_ft<T, FT>(t)}; }
  static T to_value(const Sum& s) { return internal::component_from_ft<T, FT>(s[0]); }
};

template <class T, class FT>
struct Attribute_traits<T, FT, std::enable_if_t<(internal::size_of_data_v<T, FT> > 0)>>
  : internal::Components<FT, std::size_t(internal::size_of_data_v<T, FT>)>
{
  using Scalar = std::decay_t<decltype(*std::declval<T&>().data())>;
  static constexpr auto n = std::size_t(internal::size_of_data_v<T, FT>);
  using Sum = typename internal::Components<FT, n>::Sum;
  static Sum to_sum(const T& t)
  {
    Sum s;
    for (std::size_t c = 0; c < n; ++c) s[c] = internal::component_to_ft<Scalar, FT>(t.data()[c]);
    return s;
  }
  static T to_value(const Sum& s)
  {
    T t;
    for (std::size_t c = 0; c < n; ++c) t.data()[c] = internal::component_from_ft<Scalar, FT>(s[c]);
    return t;
  }
};

template <class T, class FT>
struct Attribute_traits<
  T, FT,
  std::enable_if_t<(internal::Cartesian_dimension<T>::value > 0) &&
                   internal::is_component_v<typename Kernel_traits<T>::Kernel::FT, FT>>>
  : internal::Components<FT, std::size_t(internal::Cartesian_dimension<T>::value)>
{
  using Coordinate = typename Kernel_traits<T>::Kernel::FT;
  static constexpr int n = internal::Cartesian_dimension<T>::value;
  using Sum = typename internal::Components<FT, std::size_t(n)>::Sum;
  static Sum to_sum(const T& t)
  {
    Sum s;
    for (int c = 0; c < n; ++c)
      s[std::size_t(c)] = internal::component_to_ft<Coordinate, FT>(t.cartesian(c));
    return s;
  }
  static T to_value(const Sum& s)
  {
    const auto x = [&](std::size_t c) { return internal::component_from_ft<Coordinate, FT>(s[c]); };
    if constexpr (n == 2)
      return T(x(0), x(1));
    else
      return T(x(0), x(1), x(2));
  }
};

template <class T, class FT>
struct Attribute_traits<T, FT, std::enable_if_t<internal::is_color_v<T>>>
  : internal::Components<FT, 4>
{
  using Sum = typename internal::Components<FT, 4>::Sum;
  static Sum to_sum(const T& t)
  {
    return {FT(int(t.red())), FT(int(t.green())), FT(int(t.blue())), FT(int(t.alpha()))};
  }
  static T to_value(const Sum& s)
  {
    const auto channel = [&](std::size_t c) {
      return internal::component_from_ft<unsigned char, FT>(s[c]);
    };
    return T(channel(0), channel(1), channel(2), channel(3));
  }
};
/// \endcond

/*!
\ingroup PkgPNSubdivision3Attributes
Numbers for all elements of one kind, `dimension` of them for each: those of element `i` are from
`values[i * dimension]` on.
*/
struct Attribute_array
{
  /// how many numbers each element has.
  std::size_t dimension = 1;
  /// the numbers, those of an element next to each other.
  std::vector<double> values;
  /// of values of corners only.
  Corner_rule rule = Corner_rule::corners_plus1;
  /// of values of vertices only.
  Attribute_rule rule_of_vertices = Attribute_rule::average;
};

/*!
\ingroup PkgPNSubdivision3Attributes

Attributes in arrays, of which the number and the dimensions are known at run time only; see `attributes()` for maps.
Elements are numbered in the order of `vertices(mesh)`, `edges(mesh)` and `faces(mesh)`. Corners are in the order of
`halfedge(e, mesh)` and its opposite for every edge `e` of `edges(mesh)`. For a `Surface_mesh` without removed
elements these are the numbers of the descriptors. `subdivide()` reads the arrays and leaves in them the values of the
refined mesh, in its order.
*/
struct Attribute_table
{
  /// of vertices: by their `Attribute_rule`.
  std::vector<Attribute_array> vertices;
  /// of corners: that of a half-edge belongs to its face, at its target. Those of border half-edges are not read,
  /// and 0 afterwards.
  std::vector<Attribute_array> corners;
  /// of edges: the halves of an edge get its values, all other edges 0.
  std::vector<Attribute_array> edges;
  /// whether `face_parents` are wanted.
  bool has_face_parents = false;
  /// for every refined face the number of the control face that it comes from, see `face_parents()`. Not read.
  std::vector<std::uint32_t> face_parents;
};

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_SUBDIVISION_3_ATTRIBUTES_ATTRIBUTE_TRAITS_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_AVERAGE_INPUT_CHECKS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_AVERAGE_INPUT_CHECKS_H

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/numbers/number_functions.h>
#include <CGAL/PN_subdivision_3/numbers/Unit_normal_traits.h>
#include <CGAL/Real_embeddable_traits.h>
#include <CGAL/Uncertain.h>
#include <CGAL/number_type_basic.h>
#include <CGAL/representation_tags.h>
#include <CGAL/tags.h>
#include <CGAL/utils.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

// What is asked of kernels and number types when a call is compiled, each said in one readable line (a function whose
// check returns false has nothing else to compile), and of coordinates when it runs.

namespace CGAL::PN_subdivision_3::internal {

template <class FT, class = void>
constexpr bool has_number_traits_v = false;
template <class FT>
inline constexpr bool has_number_traits_v<
  FT, std::enable_if_t<
        std::is_same_v<typename Real_embeddable_traits<FT>::Is_real_embeddable, Tag_true> &&
        std::is_invocable_v<typename Real_embeddable_traits<FT>::To_double, const FT&> &&
        std::is_invocable_v<typename Real_embeddable_traits<FT>::To_interval, const FT&> &&
        !std::is_same_v<typename Algebraic_structure_traits<FT>::Algebraic_category, Null_tag>>> =
  true;

template <class FT>
constexpr bool is_field_v =
  std::is_convertible_v<typename Algebraic_structure_traits<FT>::Algebraic_category*, Field_tag*>;

// Intervals whose comparisons are bool, as those of Boost: they abort or lie where they cannot decide.
template <class FT, class = void>
constexpr bool has_ends_v = false;
template <class FT>
inline constexpr bool has_ends_v<
  FT, std::void_t<decltype(lower(std::declval<const FT&>()), upper(std::declval<const FT&>()))>> =
  !std::is_same_v<std::decay_t<decltype(lower(std::declval<const FT&>()))>, FT>;

template <class Kernel, class = void>
constexpr bool has_points_v = false;
template <class Kernel>
inline constexpr bool
  has_points_v<Kernel, std::void_t<typename Kernel::FT, typename Kernel::Point_3>> = true;

template <class Kernel, class = void>
constexpr bool is_homogeneous_v = false;
template <class Kernel>
inline constexpr bool is_homogeneous_v<Kernel, std::void_t<typename Kernel::Kernel_tag>> =
  std::is_same_v<typename Kernel::Kernel_tag, Homogeneous_tag>;

enum class Kernel_fault { none, no_points, homogeneous, no_traits, no_field, interval_of_bool };

template <class Kernel>
constexpr Kernel_fault fault_of_kernel()
{
  if constexpr (!has_points_v<Kernel>)
    return Kernel_fault::no_points;
  else if constexpr (is_homogeneous_v<Kernel>)
    return Kernel_fault::homogeneous;
  else {
    using FT = typename Kernel::FT;
    if constexpr (!has_number_traits_v<FT>)
      return Kernel_fault::no_traits;
    else if constexpr (!is_field_v<FT>)
      return Kernel_fault::no_field;
    else
      return has_ends_v<FT> && !is_interval_v<FT> ? Kernel_fault::interval_of_bool
                                                  : Kernel_fault::none;
  }
}

template <class Kernel>
constexpr bool check_kernel()
{
  constexpr Kernel_fault fault = fault_of_kernel<Kernel>();
  static_assert(fault != Kernel_fault::no_points,
                "PN_subdivision_3: the points do not belong to a CGAL kernel, and none is given: "
                "take Point_3 of a kernel, or name one by the parameter geom_traits");
  static_assert(fault != Kernel_fault::homogeneous,
                "PN_subdivision_3: the kernel is homogeneous, and its quotients would grow without "
                "bound: take a Cartesian one");
  static_assert(
    fault != Kernel_fault::no_traits,
    "PN_subdivision_3: the number type of the kernel has no CGAL::Algebraic_structure_traits and "
    "CGAL::Real_embeddable_traits with To_double and To_interval: specialize them (Boost's floats: "
    "include CGAL/PN_subdivision_3/boost_multiprecision_floats.h)");
  static_assert(
    fault != Kernel_fault::no_field,
    "PN_subdivision_3: the number type of the kernel is not a field, and all weights are "
    "quotients: take double, or CGAL::Gmpq for exact numbers");
  static_assert(fault != Kernel_fault::interval_of_bool,
                "PN_subdivision_3: comparisons of this interval type cannot be undecided: take "
                "CGAL::Interval_nt or CGAL::Gmpfi");
  return fault == Kernel_fault::none;
}

// A type of points or vectors may be the user's own; one of CGAL's has to be the right one.
template <class T, class FT, class = void>
constexpr bool has_coordinates_3_v = false;
template <class T, class FT>
inline constexpr bool has_coordinates_3_v<
  T, FT,
  std::void_t<decltype(T(std::declval<FT>(), std::declval<FT>(), std::declval<FT>())),
              decltype(FT(std::declval<const T&>().x())),
              decltype(FT(std::declval<const T&>().y())),
              decltype(FT(std::declval<const T&>().z()))>> = true;

template <class T, class = void>
struct Kernel_of_type
{
  static constexpr bool exists = false;
};
template <class T>
struct Kernel_of_type<T, std::void_t<typename Kernel_traits<T>::Kernel::Point_3>>
{
  static constexpr bool exists = true;
  using type = typename Kernel_traits<T>::Kernel;
};

template <class T, class FT>
constexpr bool may_be_point_3()
{
  if constexpr (Kernel_of_type<T>::exists)
    return std::is_same_v<T, typename Kernel_of_type<T>::type::Point_3>;
  else
    return has_coordinates_3_v<T, FT>;
}

// with the number type of the points or of the computation
template <class T, class Point, class FT>
constexpr bool may_be_vector_3()
{
  if constexpr (!Kernel_of_type<T>::exists)
    return has_coordinates_3_v<T, FT>;
  else if constexpr (!Kernel_of_type<Point>::exists)
    return true;
  else {
    using Kernel = typename Kernel_of_type<T>::type;
    return std::is_same_v<T, typename Kernel::Vector_3> &&
           (std::is_same_v<typename Kernel::FT, typename Kernel_of_type<Point>::type::FT> ||
            std::is_same_v<typename Kernel::FT, FT>);
  }
}

// also where -ffast-math tells the compiler that nothing else occurs: by the exponent's bits
template <class FT>
bool is_finite_number(const FT& x)
{
  if constexpr (std::is_same_v<FT, float> || std::is_same_v<FT, double>) {
    using Bits = std::conditional_t<std::is_same_v<FT, float>, std::uint32_t, std::uint64_t>;
    static_assert(sizeof(Bits) == sizeof(FT) && std::numeric_limits<FT>::is_iec559);
    constexpr int fraction_bits = std::numeric_limits<FT>::digits - 1;
    constexpr Bits all_ones = (Bits(-1) << fraction_bits) & (Bits(-1) >> 1);
    Bits bits;
    std::memcpy(&bits, &x, sizeof bits);
    return (bits & all_ones) != all_ones;
  } else if constexpr (std::is_floating_point_v<FT>)
    return std::isfinite(x);
  else {
    // types whose traits know neither NaN nor infinity, but which have them
    using Limits = std::numeric_limits<FT>;
    if constexpr (Limits::is_specialized && (Limits::has_infinity || Limits::has_quiet_NaN) &&
                  !is_exact_v<FT> && !is_interval_v<FT>)
      if (!(FT(x - x) == FT(0))) return false;
    return CGAL::is_valid(x) && CGAL::is_finite(x);
  }
}

template <class FT, class Point_or_vector>
Coordinates<FT, 3> coordinates_3(const Point_or_vector& p)
{
  return {FT(p.x()), FT(p.y()), FT(p.z())};
}

template <class FT, int dimension, class Name>
void check_finite(const Coordinates<FT, dimension>& x, const char* what, const Name& name)
{
  for (const FT& c : x)
    if (!is_finite_number(c))
      throw std::invalid_argument("PN_subdivision_3: the " + std::string(what) + " of " + name() +
                                  " is not finite: give it finite coordinates");
}

// Coordinates near the end of the range of a floating point type may overflow in between. Below the
// root of the largest number new points are not looked at: they grow by small factors only.
template <class FT, std::size_t dimension>
bool is_near_overflow([[maybe_unused]] const std::array<FT, dimension>& p)
{
  if constexpr (std::is_floating_point_v<FT>) {
    static const FT root_of_largest = std::ldexp(FT(1), std::numeric_limits<FT>::max_exponent / 2);
    for (const FT& x : p)
      if (std::abs(x) >= root_of_largest) return true;
  }
  return false;
}

template <class FT, std::size_t dimension, class Name>
void check_in_range([[maybe_unused]] const std::array<FT, dimension>& p,
                    [[maybe_unused]] const Name& name)
{
  if constexpr (std::is_floating_point_v<FT>)
    for (const FT& x : p)
      if (!is_finite_number(x))
        throw std::overflow_error("PN_subdivision_3: " + name() +
                                  " is out of the range of the number type: scale the input down");
}

// So that its square neither overflows nor underflows; whether it is not zero.
template <class FT, int dimension>
bool scale_to_about_one(Coordinates<FT, dimension>& n)
{
  if constexpr (is_interval_v<FT>) {
    scale_to_one(n);
    return FT(0) < dot(n, n);
  } else
    return !(divide_by_largest(n) == FT(0));
}

// Normals of any length become unit vectors once; unit vectors and zero are taken as they are.
// Intervals that may be unit vectors or not are normalized: the result contains both.
template <class FT, int dimension>
void normalize_control_normal(Coordinates<FT, dimension>& n)
{
  using Traits = Unit_normal_traits<FT>;
  const FT squared_length = dot(n, n);
  const FT tolerance = Traits::unit_tolerance();
  if (CGAL::certainly(is_at_most(FT(FT(1) - tolerance), squared_length)) &&
      CGAL::certainly(is_at_most(squared_length, FT(FT(1) + tolerance))))
    return;
  if (!scale_to_about_one<FT, dimension>(n)) return;
  const FT inverse = Traits::inverse_length(dot(n, n));
  for (FT& x : n) x *= inverse;
}

// names the element whose normal may be zero or not
template <class FT, int dimension, class Name>
void normalize_control_normal(Coordinates<FT, dimension>& n, const Name& name)
{
  try {
    normalize_control_normal<FT, dimension>(n);
  } catch (const Uncertain_conversion_exception&) {
    throw std::domain_error("PN_subdivision_3: the precision of the number type does not decide "
                            "whether the normal of " +
                            name() + " is zero: give it a narrower interval");
  }
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_AVERAGE_INPUT_CHECKS_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_AVERAGE_KERNEL_CHECKS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_AVERAGE_KERNEL_CHECKS_H

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/PN_subdivision_3/internal/numbers/is_interval.h>
#include <CGAL/Real_embeddable_traits.h>
#include <CGAL/representation_tags.h>
#include <CGAL/tags.h>

#include <type_traits>
#include <utility>

// What is asked of kernels and number types, each said in one readable line at compile time.
// A function whose check returns false has nothing else to compile.

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

template <class FT, class = void>
constexpr bool has_number_traits_v = false;
template <class FT>
constexpr bool has_number_traits_v<
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
constexpr bool has_ends_v<
  FT, std::void_t<decltype(lower(std::declval<const FT&>()), upper(std::declval<const FT&>()))>> =
  !std::is_same_v<std::decay_t<decltype(lower(std::declval<const FT&>()))>, FT>;

template <class Kernel, class = void>
constexpr bool has_points_v = false;
template <class Kernel>
constexpr bool has_points_v<Kernel, std::void_t<typename Kernel::FT, typename Kernel::Point_3>> =
  true;

template <class Kernel, class = void>
constexpr bool is_homogeneous_v = false;
template <class Kernel>
constexpr bool is_homogeneous_v<Kernel, std::void_t<typename Kernel::Kernel_tag>> =
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
constexpr bool has_coordinates_3_v<
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

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_AVERAGE_KERNEL_CHECKS_H

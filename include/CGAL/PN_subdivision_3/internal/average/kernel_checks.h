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
struct Has_number_traits : std::false_type
{};
template <class FT>
struct Has_number_traits<
  FT, std::enable_if_t<
        std::is_same_v<typename Real_embeddable_traits<FT>::Is_real_embeddable, Tag_true> &&
        std::is_invocable_v<typename Real_embeddable_traits<FT>::To_double, const FT&> &&
        std::is_invocable_v<typename Real_embeddable_traits<FT>::To_interval, const FT&> &&
        !std::is_same_v<typename Algebraic_structure_traits<FT>::Algebraic_category, Null_tag>>>
  : std::true_type
{};

template <class FT>
constexpr bool is_field_v =
  std::is_convertible_v<typename Algebraic_structure_traits<FT>::Algebraic_category*, Field_tag*>;

// Intervals whose comparisons are bool, as those of Boost: they abort or lie where they cannot decide.
template <class FT, class = void>
struct Has_ends : std::false_type
{};
template <class FT>
struct Has_ends<
  FT, std::void_t<decltype(lower(std::declval<const FT&>()), upper(std::declval<const FT&>()))>>
  : std::bool_constant<
      !std::is_same_v<std::decay_t<decltype(lower(std::declval<const FT&>()))>, FT>>
{};

template <class Kernel, class = void>
struct Has_points : std::false_type
{};
template <class Kernel>
struct Has_points<Kernel, std::void_t<typename Kernel::FT, typename Kernel::Point_3>>
  : std::true_type
{};

template <class Kernel, class = void>
struct Is_homogeneous : std::false_type
{};
template <class Kernel>
struct Is_homogeneous<Kernel, std::void_t<typename Kernel::Kernel_tag>>
  : std::is_same<typename Kernel::Kernel_tag, Homogeneous_tag>
{};

enum class Kernel_fault { none, no_points, homogeneous, no_traits, no_field, interval_of_bool };

template <class Kernel>
constexpr Kernel_fault fault_of_kernel()
{
  if constexpr (!Has_points<Kernel>::value)
    return Kernel_fault::no_points;
  else if constexpr (Is_homogeneous<Kernel>::value)
    return Kernel_fault::homogeneous;
  else {
    using FT = typename Kernel::FT;
    if constexpr (!Has_number_traits<FT>::value)
      return Kernel_fault::no_traits;
    else if constexpr (!is_field_v<FT>)
      return Kernel_fault::no_field;
    else
      return Has_ends<FT>::value && !is_interval_v<FT> ? Kernel_fault::interval_of_bool
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

// a type of the user's own for points or vectors
template <class T, class FT, class = void>
struct Has_coordinates_3 : std::false_type
{};
template <class T, class FT>
struct Has_coordinates_3<
  T, FT,
  std::void_t<decltype(T(std::declval<FT>(), std::declval<FT>(), std::declval<FT>())),
              decltype(FT(std::declval<const T&>().x())),
              decltype(FT(std::declval<const T&>().y())),
              decltype(FT(std::declval<const T&>().z()))>> : std::true_type
{};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_AVERAGE_KERNEL_CHECKS_H

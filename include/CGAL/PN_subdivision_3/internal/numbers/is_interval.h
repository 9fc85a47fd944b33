// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_NUMBERS_IS_INTERVAL_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_NUMBERS_IS_INTERVAL_H

#include <CGAL/Interval_traits.h>
#include <CGAL/Uncertain.h>
#include <CGAL/number_type_basic.h>

#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// Comparisons of intervals may be undecided.
template <class FT>
constexpr bool is_interval_v =
  std::is_same_v<decltype(std::declval<const FT&>() < std::declval<const FT&>()), Uncertain<bool>>;

// Some interval types have a < that may be undecided, while their other comparisons are made of it and throw.
template <class FT>
auto is_greater(const FT& a, const FT& b)
{
  if constexpr (is_interval_v<FT>)
    return b < a;
  else
    return a > b;
}
template <class FT>
auto is_at_most(const FT& a, const FT& b)
{
  if constexpr (is_interval_v<FT>)
    return !(b < a);
  else
    return a <= b;
}

// Ends of intervals, which are numbers that any two can be compared of; doubles around the interval for types without
// CGAL::Interval_traits.
template <class FT, class = void>
struct Interval_bounds
{
  using Bound = double;
  static Bound lower(const FT& x) { return CGAL::to_interval(x).first; }
  static Bound upper(const FT& x) { return CGAL::to_interval(x).second; }
};
template <class FT>
struct Interval_bounds<
  FT, std::enable_if_t<std::is_same_v<typename CGAL::Interval_traits<FT>::Is_interval, Tag_true>>>
{
  using Traits = CGAL::Interval_traits<FT>;
  using Bound = typename Traits::Bound;
  static Bound lower(const FT& x) { return typename Traits::Lower()(x); }
  static Bound upper(const FT& x) { return typename Traits::Upper()(x); }
};

// an interval without width near the middle of x
template <class FT>
FT middle(const FT& x)
{
  using Bounds = Interval_bounds<FT>;
  return FT(typename Bounds::Bound((Bounds::lower(x) + Bounds::upper(x)) / 2));
}

// the least one that contains both
template <class FT>
FT interval_around_both(const FT& a, const FT& b)
{
  using Bounds = Interval_bounds<FT>;
  const auto al = Bounds::lower(a), bl = Bounds::lower(b);
  const auto au = Bounds::upper(a), bu = Bounds::upper(b);
  return FT(std::make_pair(al < bl ? al : bl, au < bu ? bu : au));
}

// [-radius, radius], of doubles
template <class FT>
FT symmetric_interval(double radius)
{
  return FT(std::make_pair(-radius, radius));
}

// calls f(); where the precision of the number type does not suffice, what() says for what
template <class FT, class Function, class What>
void decided(const Function& f, [[maybe_unused]] const What& what)
{
  if constexpr (std::is_floating_point_v<FT>)
    f();
  else
    try {
      f();
    } catch (const Uncertain_conversion_exception&) {
      throw std::domain_error(
        "PN_subdivision_3: the precision of the number type does not decide " +
        std::string(what()) + ": use a higher precision");
    }
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_NUMBERS_IS_INTERVAL_H

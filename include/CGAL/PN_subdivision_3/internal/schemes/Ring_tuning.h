// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_RING_TUNING_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_RING_TUNING_H

#include <CGAL/PN_subdivision_3/internal/schemes/eigenvalue_cap.h>
#include <CGAL/PN_subdivision_3/schemes/Tuned_valences.h>
#include <CGAL/PN_subdivision_3/schemes/scheme_adaptors.h>

#include <algorithm>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// What becomes of the eigenvalues of the ring matrix of a separated vertex, and when.
struct Ring_tuning
{
  Ring_tuning() = default;
  Ring_tuning(const Scheme_parameter& a_cap, unsigned a_first_round, Tuned_valences some_valences)
    : cap(checked_cap(a_cap))
    , first_round(a_first_round)
    , valences(some_valences)
  {
    if (first_round == 0)
      throw std::invalid_argument(
        "PN_subdivision_3: the first round of a modified scheme must be at least 1");
  }

  bool holds_in(unsigned round) const { return round >= first_round; }

  // The new value of one that is neither 1 nor lambda. The quadratic ones belong to the quadratic
  // part of the surface.
  template <class Number>
  Number other(const Number& eigenvalue, bool is_quadratic, const Number& new_lambda) const
  {
    if (is_quadratic && keeps_quadratic) return new_lambda * new_lambda;
    const Number bound = cap.value<Number>() * new_lambda * new_lambda;
    return capped(eigenvalue, bound);
  }

  Scheme_parameter cap = 0.5;
  unsigned first_round = 1;
  Tuned_valences valences = Tuned_valences::all;
  bool keeps_quadratic = false;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_RING_TUNING_H

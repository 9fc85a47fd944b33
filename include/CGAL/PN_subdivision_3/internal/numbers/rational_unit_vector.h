// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_NUMBERS_RATIONAL_UNIT_VECTOR_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_NUMBERS_RATIONAL_UNIT_VECTOR_H

#include <CGAL/PN_subdivision_3/internal/numbers/number_functions.h>
#include <CGAL/PN_subdivision_3/numbers/Unit_normal_traits.h>
#include <CGAL/number_type_basic.h>

#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>

namespace CGAL::PN_subdivision_3::internal {

// x 2^k, of any k
template <class FT>
FT times_power(FT x, int k)
{
  constexpr int step = 1000;
  for (; k > step; k -= step) x = times_power_of_two(x, step);
  for (; k < -step; k += step) x = times_power_of_two(x, -step);
  return times_power_of_two(x, k);
}

// The multiple of 2^-bits that is nearest to an exact number below 2^100, or nearly so, by doubles that are integers.
template <class FT>
FT rounded_to_bits(const FT& x, int bits)
{
  constexpr int most = 900; // in the range of double
  if (bits > most) {
    const FT head = rounded_to_bits(x, most);
    const FT tail = rounded_to_bits(times_power(FT(x - head), most), bits - most);
    return head + times_power(tail, -most);
  }
  FT rest = times_power(x, bits), sum(0);
  for (;;) {
    const double head = std::nearbyint(close_double(rest));
    if (head == 0 || !std::isfinite(head)) break;
    sum = sum + FT(head);
    rest = rest - FT(head);
  }
  return times_power(sum, -bits);
}

// the root of a number from 1 to some thousands: Newton's iteration, each step of which is rounded
template <class FT>
FT rounded_root(const FT& square, int bits)
{
  FT root(std::sqrt(close_double(square)));
  for (int exact = 45; exact < bits; exact *= 2)
    root = rounded_to_bits(FT((root + square / root) / FT(2)), bits);
  return root;
}

// The vector of length 1, exactly, whose direction is that of v, but for an angle below 1.5 2^-bits: the
// stereographic projection, from the pole opposite to the axis that v is next to, with the coordinates rounded to
// bits. v may be zero, and is then returned.
template <class FT, std::size_t dimension>
std::array<FT, dimension> rational_unit_vector(const std::array<FT, dimension>& v, int bits)
{
  std::size_t axis = 0;
  for (std::size_t c = 1; c < dimension; ++c)
    if (CGAL::abs(v[axis]) < CGAL::abs(v[c])) axis = c;
  const FT largest = CGAL::abs(v[axis]);
  if (largest == FT(0)) return v;
  FT square(0);
  for (const FT& x : v) square = square + CGAL::square(FT(x / largest));
  const FT distance = FT(1) + rounded_root(square, bits + 8);
  std::array<FT, dimension> n;
  FT sum(0);
  for (std::size_t c = 0; c < dimension; ++c) {
    if (c == axis) continue;
    n[c] = rounded_to_bits(FT(v[c] / largest / distance), bits);
    sum = sum + CGAL::square(n[c]);
  }
  const FT factor = FT(2) / (FT(1) + sum);
  for (std::size_t c = 0; c < dimension; ++c)
    if (c != axis) n[c] = n[c] * factor;
  n[axis] = v[axis] < FT(0) ? FT(FT(1) - factor) : FT(factor - FT(1));
  return n;
}

// to how many bits refined normals of exact types without square root are rounded; 0: they are not
inline std::atomic<int>& bits_of_refined_normals()
{
  static std::atomic<int> bits{0};
  return bits;
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_NUMBERS_RATIONAL_UNIT_VECTOR_H

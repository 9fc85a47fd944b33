// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_AVERAGE_LANES_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_AVERAGE_LANES_H

#include <cstring>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// Two numbers that are computed with side by side. Compilers seldom pack the arithmetic of gathered
// numbers by themselves; with two doubles to a register the PN heights take 2/3 of the time.
template <class FT>
struct Lanes
{
  static Lanes both(FT x) { return {x, x}; }
  static Lanes of(FT x, FT y) { return {x, y}; }
  static Lanes at(const FT* x) { return {x[0], x[1]}; }
  FT operator[](int i) const { return i == 0 ? x0 : x1; }
  friend Lanes operator+(Lanes a, Lanes b) { return {a.x0 + b.x0, a.x1 + b.x1}; }
  friend Lanes operator-(Lanes a, Lanes b) { return {a.x0 - b.x0, a.x1 - b.x1}; }
  friend Lanes operator*(Lanes a, Lanes b) { return {a.x0 * b.x0, a.x1 * b.x1}; }
  friend Lanes operator/(Lanes a, Lanes b) { return {a.x0 / b.x0, a.x1 / b.x1}; }
  friend Lanes first_of(Lanes a, Lanes b) { return {a.x0, b.x0}; }
  friend Lanes second_of(Lanes a, Lanes b) { return {a.x1, b.x1}; }
  friend Lanes lesser(Lanes a, Lanes b)
  {
    return {a.x0 < b.x0 ? a.x0 : b.x0, a.x1 < b.x1 ? a.x1 : b.x1};
  }
  friend Lanes greater(Lanes a, Lanes b)
  {
    return {a.x0 > b.x0 ? a.x0 : b.x0, a.x1 > b.x1 ? a.x1 : b.x1};
  }

  FT x0, x1;
};

#if defined(__GNUC__) // and clang
template <>
struct Lanes<double>
{
  using Packed __attribute__((vector_size(16))) = double;

  static Lanes both(double x) { return {Packed{x, x}}; }
  static Lanes of(double x, double y) { return {Packed{x, y}}; }
  static Lanes at(const double* x) // need not be aligned as the registers are
  {
    Lanes a;
    std::memcpy(&a.packed, x, sizeof a.packed);
    return a;
  }
  double operator[](int i) const { return packed[i]; }
  friend Lanes operator+(Lanes a, Lanes b) { return {a.packed + b.packed}; }
  friend Lanes operator-(Lanes a, Lanes b) { return {a.packed - b.packed}; }
  friend Lanes operator*(Lanes a, Lanes b) { return {a.packed * b.packed}; }
  friend Lanes operator/(Lanes a, Lanes b) { return {a.packed / b.packed}; }
  friend Lanes first_of(Lanes a, Lanes b) { return {Packed{a.packed[0], b.packed[0]}}; }
  friend Lanes second_of(Lanes a, Lanes b) { return {Packed{a.packed[1], b.packed[1]}}; }
  friend Lanes lesser(Lanes a, Lanes b) { return {a.packed < b.packed ? a.packed : b.packed}; }
  friend Lanes greater(Lanes a, Lanes b) { return {a.packed > b.packed ? a.packed : b.packed}; }

  Packed packed;
};
#endif

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_AVERAGE_LANES_H

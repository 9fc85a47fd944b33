// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// One round of univariate schemes by their meaning: B-splines by inserting a knot in the middle of
// every interval, which evaluates the polar form of the polynomial pieces; Dubuc-Deslauriers by
// Neville's interpolation. Positions are counted in quarters: old point j is at 4j.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_CURVE_H
#define CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_CURVE_H

#include "Face_list.h"

#include <map>

namespace reference {

using Sparse_row = std::map<long, Real>; // old point, weight

inline Sparse_row affine(const Sparse_row& a, const Sparse_row& b, Real t)
{
  Sparse_row c;
  for (const auto& [j, w] : a) c[j] += (1 - t) * w;
  for (const auto& [j, w] : b) c[j] += t * w;
  return c;
}

// the row without the entries that are zero, weights rounded to multiples of 1/unit
inline Sparse_row rounded(const Sparse_row& row, Real unit)
{
  Sparse_row result;
  for (const auto& [j, w] : row) {
    const Real r = std::round(w * unit) / unit;
    if (r != 0) result[j] = r;
  }
  return result;
}

// The new control point of a uniform B-spline at position x, by de Boor's algorithm for polar forms:
// with knots at the integers, old point j is the polar form at j + 1, ..., j + degree.
inline Sparse_row b_spline_row(int degree, long x)
{
  const long i = (x + degree + 1) / 2;        // its polar form is at (i + 1)/2, ..., (i + degree)/2
  const long span = (2 * i + degree + 1) / 4; // the interval in the middle of its support
  std::vector<Sparse_row> d;
  for (long j = span - degree; j <= span; ++j) d.push_back({{j, Real(1)}});
  for (int r = 1; r <= degree; ++r) {
    const Real u = Real(i + r) / 2;
    for (int k = degree; k >= r; --k) {
      const long j = span - degree + k;
      const Real t = (u - Real(j)) / Real(degree + 1 - r);
      d[std::size_t(k)] = affine(d[std::size_t(k - 1)], d[std::size_t(k)], t);
    }
  }
  return rounded(d.back(), std::ldexp(Real(1), degree));
}

// Interpolation of 2 * half points at x, which is an old point or the middle of two.
inline Sparse_row interpolating_row(int half, long x)
{
  if (x % 4 == 0) return {{x / 4, Real(1)}};
  const long first = (x - 2) / 4 - half + 1;
  std::vector<Sparse_row> p;
  for (long j = first; j < first + 2 * half; ++j) p.push_back({{j, Real(1)}});
  for (int r = 1; r < 2 * half; ++r)
    for (int k = 0; k + r < 2 * half; ++k)
      p[std::size_t(k)] =
        affine(p[std::size_t(k)], p[std::size_t(k + 1)], (Real(x) / 4 - Real(first + k)) / r);
  return rounded(p[0], std::ldexp(Real(1), 8 * half));
}

enum class End { closed, reflect, none };

struct Curve_scheme
{
  bool interpolating;
  int parameter; // degree, or half the number of points

  bool primal() const { return interpolating || parameter % 2 != 0; }
  // far from the start, where the integer divisions need no care
  Sparse_row row(long x) const
  {
    const long shift = 64;
    const Sparse_row moved = interpolating ? interpolating_row(parameter, x + 4 * shift)
                                           : b_spline_row(parameter, x + 4 * shift);
    Sparse_row result;
    for (const auto& [j, w] : moved) result[j - shift] = w;
    return result;
  }
};

// The extended polygon's point j by the given points.
inline Sparse_row old_point(long j, long n, End end)
{
  if (end == End::closed) return {{((j % n) + n) % n, Real(1)}};
  if (j >= 0 && j < n) return {{j, Real(1)}};
  if (n == 1) return {{0, Real(1)}};
  const long pole = j < 0 ? 0 : n - 1;
  Sparse_row row = {{pole, Real(2)}};
  for (const auto& [k, w] : old_point(2 * pole - j, n, end)) row[k] -= w;
  return row;
}

// All new points of a polygon of n points.
class Curve_rows
{
public:
  Curve_rows(const Curve_scheme& scheme, long n, End end)
    : n_(n)
    , end_(end)
    , rows_{scheme.row(scheme.primal() ? 0 : 1), scheme.row(scheme.primal() ? 2 : 3)}
  {
    if (end == End::none)
      find_existing();
    else
      size_ = end == End::closed ? 2 * n : scheme.primal() ? 2 * n - 1 : 2 * n - 2;
  }

  long size() const { return size_; }
  Sparse_row operator[](long i) const
  {
    Sparse_row row;
    for (const auto& [j, w] : raw(i + first_))
      for (const auto& [k, v] : old_point(j, n_, end_)) row[k] += v * w;
    for (auto e = row.begin(); e != row.end();) e = e->second == 0 ? row.erase(e) : std::next(e);
    return row;
  }

private:
  Sparse_row raw(long i) const
  {
    const long parity = ((i % 2) + 2) % 2;
    Sparse_row row;
    for (const auto& [j, w] : rows_[parity]) row[j + (i - parity) / 2] = w;
    return row;
  }

  // the longest run of rows that use existing points only
  void find_existing()
  {
    long run = 0;
    for (long i = -2; i <= 2 * n_ + 1; ++i) {
      const Sparse_row row = raw(i);
      run = row.begin()->first >= 0 && row.rbegin()->first < n_ ? run + 1 : 0;
      if (run > size_) {
        size_ = run;
        first_ = i - run + 1;
      }
    }
  }

  long n_;
  End end_;
  Sparse_row rows_[2];
  long first_ = 0, size_ = 0;
};

inline Matrix curve_matrix(const Curve_scheme& scheme, long n, End end)
{
  const Curve_rows rows(scheme, n, end);
  Matrix m = Matrix::Zero(rows.size(), n);
  for (long i = 0; i < rows.size(); ++i)
    for (const auto& [j, w] : rows[i]) m(i, j) = w;
  return m;
}

} // namespace reference

#endif // CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_CURVE_H

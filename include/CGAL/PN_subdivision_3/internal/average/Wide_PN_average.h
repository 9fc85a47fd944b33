// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_AVERAGE_WIDE_PN_AVERAGE_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_AVERAGE_WIDE_PN_AVERAGE_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/average/Stencil_block.h>

#include <cstddef>
#include <cstdint>

// g++ and clang++. On Windows the stack is aligned for 16 bytes, and wide registers spilled there
// crash (MinGW).
#if defined(__GNUC__) && defined(__x86_64__) && !defined(_WIN32) && !defined(__CYGWIN__) &&        \
  !defined(CGAL_PN_SUBDIVISION_3_NO_AVX2)
#  include <immintrin.h>
#  define CGAL_PN_SUBDIVISION_3_HAS_AVX2_FUNCTIONS
#endif

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// What a row's fast forms are good for: a 1/|N| below greatest_scale(), which is far from vanishing
// for any mask that is of use, and no d_j below fade_begin(). Both are limited before something is
// divided by them, so that rows left to PN_average divide by zero nowhere: programs may trap that.
template <class FT>
constexpr FT greatest_scale()
{
  return FT(4);
}
template <class FT>
constexpr FT least_squared_length() // of a normal that is too short
{
  return FT(1) / FT(64);
}

// The PN averages of rows of the same length side by side in the lanes of wide registers. For this
// number type and compiler there are none.
template <class FT, int dimension>
struct Wide_PN_average
{
  static constexpr std::size_t maximum_length = 0;
};

#ifdef CGAL_PN_SUBDIVISION_3_HAS_AVX2_FUNCTIONS
// Four doubles to a register. Whether the processor has AVX2 is asked at run time, so that programs
// built for any x86-64 gain a third. Every row is summed in the order of Staged_PN_average_block:
// the results are the same bit by bit, unless the whole program is built for processors with FMA and
// the compiler fuses operations as it likes.
template <int dimension>
class Wide_PN_average<double, dimension>
{
public:
  using Entry = Stencil_block<double>::Entry;
  using Value = Point_normal<double, dimension>;

  static constexpr std::size_t maximum_length = 32;
  // four registers of rows hide the latency of square root and division
  static constexpr std::size_t maximum_number_of_rows = 16;

  static bool is_available() { return __builtin_cpu_supports("avx2"); }

  // Averages rows that lie one after another. Bit r of what is returned is set where result[r] does
  // not hold: entries of the row fade, or its normal may vanish. The pairs of a stored value are the
  // coordinates of its point and normal.
  template <class Stored_value>
  [[gnu::target("avx2")]] static std::uint32_t average(const Entry* rows, std::size_t length,
                                                       std::size_t number, const Stored_value* old,
                                                       Value* result)
  {
    static_assert(sizeof(Entry) == 16 && sizeof(Stored_value) == std::size_t(16) * dimension);
    Old entries[maximum_length * maximum_number_of_rows / 4];
    Sums sums[maximum_number_of_rows / 4];
    const std::size_t groups = (number + 3) / 4;
    for (std::size_t g = 0; g < groups; ++g) {
      const Entry* row[4];
      for (std::size_t i = 0; i < 4; ++i) row[i] = rows + row_of_lane(g, i, number) * length;
      sum(row, length, old, entries + g * length, sums[g]);
    }
    for (std::size_t g = 0; g < groups; ++g)
      sums[g].scale = _mm256_set1_pd(1) / _mm256_sqrt_pd(sums[g].squared_length);
    std::uint32_t fails = 0;
    for (std::size_t g = 0; g < groups; ++g) {
      Value* values[4];
      for (std::size_t i = 0; i < 4; ++i) values[i] = result + row_of_lane(g, i, number);
      fails |= put_averages(entries + g * length, length, sums[g], values) << (4 * g);
    }
    return fails;
  }

private:
  using Packed = __m256d;

  // the j-th entries of four rows
  struct Old
  {
    Packed weight, point[dimension], normal[dimension];
  };
  // their q, N, |N|^2 and 1/|N|
  struct Sums
  {
    Packed q[dimension], normal[dimension], squared_length, scale;
  };

  // lanes without a row repeat the last one
  static std::size_t row_of_lane(std::size_t group, std::size_t lane, std::size_t number)
  {
    const std::size_t r = 4 * group + lane;
    return r < number ? r : number - 1;
  }

  // all of the sums but the scale; keeps the entries
  template <class Stored_value>
  [[gnu::target("avx2"), gnu::always_inline]] static inline void
  sum(const Entry* const (&row)[4], std::size_t length, const Stored_value* old, Old* entries,
      Sums& sums)
  {
    Packed q[dimension], n[dimension];
    for (int c = 0; c < dimension; ++c) q[c] = n[c] = _mm256_setzero_pd();
    for (std::size_t j = 0; j < length; ++j) {
      gather(row, j, old, entries[j]);
      for (int c = 0; c < dimension; ++c) {
        q[c] += entries[j].weight * entries[j].point[c];
        n[c] += entries[j].weight * entries[j].normal[c];
      }
    }
    sums.squared_length = n[0] * n[0];
    for (int c = 1; c < dimension; ++c) sums.squared_length += n[c] * n[c];
    sums.squared_length =
      _mm256_max_pd(sums.squared_length, _mm256_set1_pd(least_squared_length<double>()));
    for (int c = 0; c < dimension; ++c) {
      sums.q[c] = q[c];
      sums.normal[c] = n[c];
    }
  }

  template <class Stored_value>
  [[gnu::target("avx2"), gnu::always_inline]] static inline void
  gather(const Entry* const (&row)[4], std::size_t j, const Stored_value* old, Old& entry)
  {
    // the weight is the second half of a (vertex, weight)
    entry.weight = _mm256_unpackhi_pd(two(row[0] + j, row[2] + j), two(row[1] + j, row[3] + j));
    const Stored_value* const v[4] = {old + row[0][j].vertex, old + row[1][j].vertex,
                                      old + row[2][j].vertex, old + row[3][j].vertex};
    for (int c = 0; c < dimension; ++c) {
      const Packed v02 = two(&v[0]->pairs[c], &v[2]->pairs[c]);
      const Packed v13 = two(&v[1]->pairs[c], &v[3]->pairs[c]);
      entry.point[c] = _mm256_unpacklo_pd(v02, v13);
      entry.normal[c] = _mm256_unpackhi_pd(v02, v13);
    }
  }

  // the sixteen bytes at each of two places
  [[gnu::target("avx2"), gnu::always_inline]] static inline Packed two(const void* a, const void* b)
  {
    return _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_loadu_pd(static_cast<const double*>(a))),
                                _mm_loadu_pd(static_cast<const double*>(b)), 1);
  }

  // returns the lanes that fail
  [[gnu::target("avx2"), gnu::always_inline]] static inline std::uint32_t
  put_averages(const Old* entries, std::size_t length, const Sums& sums, Value* const (&values)[4])
  {
    Packed q[dimension], n[dimension];
    for (int c = 0; c < dimension; ++c) {
      q[c] = sums.q[c];
      n[c] = sums.normal[c] * sums.scale;
    }
    Packed even = _mm256_setzero_pd(), odd = even, last = even, least = _mm256_set1_pd(2);
    std::size_t j = 0;
    for (; j + 1 < length; j += 2) {
      even += weighted_height(entries[j], q, n, least);
      odd += weighted_height(entries[j + 1], q, n, least);
    }
    if (j < length) last = weighted_height(entries[j], q, n, least);
    const Packed height = even + odd + last;
    for (int c = 0; c < dimension; ++c) {
      q[c] += height * n[c];
      for (int i = 0; i < 4; ++i) {
        values[i]->point[c] = q[c][i];
        values[i]->normal[c] = n[c][i];
      }
    }
    const Packed holds = _mm256_and_pd(
      _mm256_cmp_pd(least, _mm256_set1_pd(fade_begin<double>()), _CMP_GE_OQ),
      _mm256_cmp_pd(sums.scale, _mm256_set1_pd(greatest_scale<double>()), _CMP_LT_OQ));
    return static_cast<std::uint32_t>(_mm256_movemask_pd(holds)) ^ 15u;
  }

  [[gnu::target("avx2"), gnu::always_inline]] static inline Packed
  weighted_height(const Old& entry, const Packed (&q)[dimension], const Packed (&n)[dimension],
                  Packed& least_denominator)
  {
    Packed s = entry.normal[0] + n[0];
    Packed numerator = s * (entry.point[0] - q[0]), denominator = s * n[0];
    for (int c = 1; c < dimension; ++c) {
      s = entry.normal[c] + n[c];
      numerator += s * (entry.point[c] - q[c]);
      denominator += s * n[c];
    }
    least_denominator = _mm256_min_pd(denominator, least_denominator);
    return entry.weight *
           (numerator / _mm256_max_pd(denominator, _mm256_set1_pd(fade_begin<double>())));
  }
};
#endif

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_AVERAGE_WIDE_PN_AVERAGE_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_ROWS_VECTORIZED_PN_AVERAGE_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_ROWS_VECTORIZED_PN_AVERAGE_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/rows/Stencil_block.h>

#include <cstddef>
#include <cstdint>
#include <cstring>

// g++ and clang++. On Windows the stack is aligned for 16 bytes, and wide registers spilled there
// crash (MinGW).
#if defined(__GNUC__) && defined(__x86_64__) && !defined(_WIN32) && !defined(__CYGWIN__) &&        \
  !defined(CGAL_PN_SUBDIVISION_3_NO_AVX2)
#  define CGAL_PN_SUBDIVISION_3_HAS_AVX2_FUNCTIONS
#  ifndef CGAL_PN_SUBDIVISION_3_DOUBLE // the library has the code; the header of the processor is long
#    define CGAL_PN_SUBDIVISION_3_DEFINES_AVX2_FUNCTIONS
#    include <immintrin.h>
#  endif
#endif

namespace CGAL::PN_subdivision_3::internal {

// how many numbers an AVX2 register has, if there are functions for it
template <class FT>
constexpr std::size_t number_of_lanes_v = 0;
#ifdef CGAL_PN_SUBDIVISION_3_HAS_AVX2_FUNCTIONS
template <>
inline constexpr std::size_t number_of_lanes_v<double> = 4;
template <>
inline constexpr std::size_t number_of_lanes_v<float> = 8;
#endif

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
template <class FT, int dimension, bool has_lanes = (number_of_lanes_v<FT> > 0)>
struct Vectorized_PN_average
{
  static constexpr std::size_t maximum_length = 0;
};

#ifdef CGAL_PN_SUBDIVISION_3_HAS_AVX2_FUNCTIONS
// Whether the processor has AVX2 is asked at run time, so that programs built for any x86-64 gain a
// third. Every row is summed in the order of Staged_PN_average_block: the results are the same bit by
// bit, unless the whole program is built for processors with FMA and the compiler fuses operations as
// it likes.
template <class FT, int dimension>
struct Vectorized_PN_average<FT, dimension, true>
{
  using Entry = typename Stencil_block<FT>::Entry;
  using Value = Point_normal<FT, dimension>;

  static constexpr std::size_t maximum_length = 32;
  // four registers of rows hide the latency of square root and division
  static constexpr std::size_t maximum_number_of_rows = 4 * number_of_lanes_v<FT>;

  static bool is_available() { return __builtin_cpu_supports("avx2"); }

  // Averages rows that lie one after another. Bit r of what is returned is set where result[r] does
  // not hold: entries of the row fade, or its normal may vanish. A value is the numbers of its point,
  // its normal and its roundness; `roundness` is that of all values, if it is one.
  static std::uint32_t average(const Entry* rows, std::size_t length, std::size_t number,
                               const Value* old, const FT* roundness, Value* result);
};
#endif

#ifdef CGAL_PN_SUBDIVISION_3_DEFINES_AVX2_FUNCTIONS
// The numbers of an AVX2 register, and what the wide averages do with them besides arithmetic.
template <class FT>
struct Avx2_lanes;

#  define CGAL_PN_SUBDIVISION_3_AVX2_INLINE                                                        \
    [[gnu::target("avx2"), gnu::always_inline]] static inline

template <>
struct Avx2_lanes<double>
{
  using Packed = __m256d;
  static constexpr std::size_t width = number_of_lanes_v<double>;
  // the first numbers of some pairs, and the second ones
  struct Pairs
  {
    Packed first, second;
  };

  CGAL_PN_SUBDIVISION_3_AVX2_INLINE Packed all(double x) { return _mm256_set1_pd(x); }
  CGAL_PN_SUBDIVISION_3_AVX2_INLINE Packed sqrt(Packed a) { return _mm256_sqrt_pd(a); }
  // the second one where one is not a number
  CGAL_PN_SUBDIVISION_3_AVX2_INLINE Packed lesser(Packed a, Packed b)
  {
    return _mm256_min_pd(a, b);
  }
  CGAL_PN_SUBDIVISION_3_AVX2_INLINE Packed greater(Packed a, Packed b)
  {
    return _mm256_max_pd(a, b);
  }
  // a bit for each lane in which a >= b and c < d
  CGAL_PN_SUBDIVISION_3_AVX2_INLINE std::uint32_t at_least_and_less(Packed a, Packed b, Packed c,
                                                                    Packed d)
  {
    return static_cast<std::uint32_t>(_mm256_movemask_pd(
      _mm256_and_pd(_mm256_cmp_pd(a, b, _CMP_GE_OQ), _mm256_cmp_pd(c, d, _CMP_LT_OQ))));
  }
  // the pairs `k` numbers behind these places
  CGAL_PN_SUBDIVISION_3_AVX2_INLINE Pairs pairs(const double* const (&at)[width], int k)
  {
    const Packed p02 = two(at[0] + k, at[2] + k), p13 = two(at[1] + k, at[3] + k);
    return {_mm256_unpacklo_pd(p02, p13), _mm256_unpackhi_pd(p02, p13)};
  }
  // the numbers there
  CGAL_PN_SUBDIVISION_3_AVX2_INLINE Packed numbers(const double* const (&at)[width], int k)
  {
    return _mm256_set_pd(at[3][k], at[2][k], at[1][k], at[0][k]);
  }

private:
  CGAL_PN_SUBDIVISION_3_AVX2_INLINE Packed two(const double* a, const double* b)
  {
    return _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_loadu_pd(a)), _mm_loadu_pd(b), 1);
  }
};

template <>
struct Avx2_lanes<float>
{
  using Packed = __m256;
  static constexpr std::size_t width = number_of_lanes_v<float>;
  // the first numbers of some pairs, and the second ones
  struct Pairs
  {
    Packed first, second;
  };

  CGAL_PN_SUBDIVISION_3_AVX2_INLINE Packed all(float x) { return _mm256_set1_ps(x); }
  CGAL_PN_SUBDIVISION_3_AVX2_INLINE Packed sqrt(Packed a) { return _mm256_sqrt_ps(a); }
  CGAL_PN_SUBDIVISION_3_AVX2_INLINE Packed lesser(Packed a, Packed b)
  {
    return _mm256_min_ps(a, b);
  }
  CGAL_PN_SUBDIVISION_3_AVX2_INLINE Packed greater(Packed a, Packed b)
  {
    return _mm256_max_ps(a, b);
  }
  CGAL_PN_SUBDIVISION_3_AVX2_INLINE std::uint32_t at_least_and_less(Packed a, Packed b, Packed c,
                                                                    Packed d)
  {
    return static_cast<std::uint32_t>(_mm256_movemask_ps(
      _mm256_and_ps(_mm256_cmp_ps(a, b, _CMP_GE_OQ), _mm256_cmp_ps(c, d, _CMP_LT_OQ))));
  }
  CGAL_PN_SUBDIVISION_3_AVX2_INLINE Pairs pairs(const float* const (&at)[width], int k)
  {
    const Packed p0145 = four(at[0] + k, at[1] + k, at[4] + k, at[5] + k),
                 p2367 = four(at[2] + k, at[3] + k, at[6] + k, at[7] + k);
    return {_mm256_shuffle_ps(p0145, p2367, 0x88), _mm256_shuffle_ps(p0145, p2367, 0xdd)};
  }
  CGAL_PN_SUBDIVISION_3_AVX2_INLINE Packed numbers(const float* const (&at)[width], int k)
  {
    return _mm256_set_ps(at[7][k], at[6][k], at[5][k], at[4][k], at[3][k], at[2][k], at[1][k],
                         at[0][k]);
  }

private:
  CGAL_PN_SUBDIVISION_3_AVX2_INLINE Packed four(const float* a, const float* b, const float* c,
                                                const float* d)
  {
    return _mm256_castpd_ps(_mm256_set_pd(pair(d), pair(c), pair(b), pair(a)));
  }
  // both numbers as the bits of a larger one
  CGAL_PN_SUBDIVISION_3_AVX2_INLINE double pair(const float* at)
  {
    double bits;
    std::memcpy(&bits, at, sizeof bits);
    return bits;
  }
};

template <class FT, int dimension>
class Avx2_PN_average
{
  using Lanes = Avx2_lanes<FT>;
  using Packed = typename Lanes::Packed;
  static constexpr std::size_t width = Lanes::width;

  using Vectorized = Vectorized_PN_average<FT, dimension>;
  static constexpr std::size_t maximum_length = Vectorized::maximum_length;
  static constexpr std::size_t maximum_number_of_rows = Vectorized::maximum_number_of_rows;

public:
  using Entry = typename Vectorized::Entry;
  using Value = typename Vectorized::Value;

  [[gnu::target("avx2")]] static std::uint32_t average(const Entry* rows, std::size_t length,
                                                       std::size_t number, const Value* old,
                                                       const FT* roundness, Value* result)
  {
    static_assert(sizeof(Entry) == 2 * sizeof(FT) &&
                  sizeof(Value) == (2 * dimension + 1) * sizeof(FT));
    Old entries[maximum_length * maximum_number_of_rows / width];
    Sums sums[maximum_number_of_rows / width];
    const std::size_t groups = (number + width - 1) / width;
    for (std::size_t g = 0; g < groups; ++g) {
      const Entry* row[width];
      for (std::size_t i = 0; i < width; ++i) row[i] = rows + row_of_lane(g, i, number) * length;
      sum(row, length, old, entries + g * length, sums[g], roundness);
    }
    for (std::size_t g = 0; g < groups; ++g)
      sums[g].scale = Lanes::all(1) / Lanes::sqrt(sums[g].squared_length);
    std::uint32_t fails = 0;
    for (std::size_t g = 0; g < groups; ++g) {
      Value* values[width];
      for (std::size_t i = 0; i < width; ++i) values[i] = result + row_of_lane(g, i, number);
      fails |= put_averages(entries + g * length, length, sums[g], values) << (width * g);
    }
    return fails;
  }

private:
  // the j-th entries of a register of rows
  struct Old
  {
    Packed weight, numbers[2 * dimension]; // of points and normals
  };
  // their q, N, |N|^2 and 1/|N|, and their roundness
  struct Sums
  {
    Packed q[dimension], normal[dimension], squared_length, scale, roundness;
  };

  // lanes without a row repeat the last one
  static std::size_t row_of_lane(std::size_t group, std::size_t lane, std::size_t number)
  {
    const std::size_t r = width * group + lane;
    return r < number ? r : number - 1;
  }

  // all of the sums but the scale; keeps the entries
  CGAL_PN_SUBDIVISION_3_AVX2_INLINE void sum(const Entry* const (&row)[width], std::size_t length,
                                             const Value* old, Old* entries, Sums& sums,
                                             const FT* of_all)
  {
    Packed q[dimension], n[dimension];
    Packed roundness = Lanes::all(of_all == nullptr ? FT(0) : *of_all);
    for (int c = 0; c < dimension; ++c) q[c] = n[c] = Lanes::all(0);
    for (std::size_t j = 0; j < length; ++j) {
      gather(row, j, old, entries[j], of_all == nullptr ? &roundness : nullptr);
      for (int c = 0; c < dimension; ++c) {
        q[c] += entries[j].weight * entries[j].numbers[c];
        n[c] += entries[j].weight * entries[j].numbers[dimension + c];
      }
    }
    sums.roundness = roundness;
    sums.squared_length = n[0] * n[0];
    for (int c = 1; c < dimension; ++c) sums.squared_length += n[c] * n[c];
    sums.squared_length =
      Lanes::greater(sums.squared_length, Lanes::all(least_squared_length<FT>()));
    for (int c = 0; c < dimension; ++c) {
      sums.q[c] = q[c];
      sums.normal[c] = n[c];
    }
  }

  // the roundness of the entries is added
  CGAL_PN_SUBDIVISION_3_AVX2_INLINE void gather(const Entry* const (&row)[width], std::size_t j,
                                                const Value* old, Old& entry, Packed* roundness)
  {
    const FT* at[width];
    for (std::size_t i = 0; i < width; ++i) at[i] = reinterpret_cast<const FT*>(row[i] + j);
    entry.weight = Lanes::pairs(at, 0).second; // of a (vertex, weight)
    for (std::size_t i = 0; i < width; ++i)
      at[i] = reinterpret_cast<const FT*>(old + row[i][j].vertex);
    for (int k = 0; k < 2 * dimension; k += 2) {
      const typename Lanes::Pairs pairs = Lanes::pairs(at, k);
      entry.numbers[k] = pairs.first;
      entry.numbers[k + 1] = pairs.second;
    }
    if (roundness != nullptr) *roundness += entry.weight * Lanes::numbers(at, 2 * dimension);
  }

  // returns the lanes that fail
  CGAL_PN_SUBDIVISION_3_AVX2_INLINE std::uint32_t put_averages(const Old* entries,
                                                               std::size_t length, const Sums& sums,
                                                               Value* const (&values)[width])
  {
    Packed q[dimension], n[dimension];
    for (int c = 0; c < dimension; ++c) {
      q[c] = sums.q[c];
      n[c] = sums.normal[c] * sums.scale;
    }
    Packed even = Lanes::all(0), odd = even, last = even, least = Lanes::all(2);
    std::size_t j = 0;
    for (; j + 1 < length; j += 2) {
      even += weighted_height(entries[j], q, n, least);
      odd += weighted_height(entries[j + 1], q, n, least);
    }
    if (j < length) last = weighted_height(entries[j], q, n, least);
    Packed height = even + odd + last;
    height *= sums.roundness;
    for (std::size_t i = 0; i < width; ++i) values[i]->roundness = sums.roundness[i];
    for (int c = 0; c < dimension; ++c) {
      q[c] += height * n[c];
      for (std::size_t i = 0; i < width; ++i) {
        values[i]->point[c] = q[c][i];
        values[i]->normal[c] = n[c][i];
      }
    }
    const std::uint32_t holds = Lanes::at_least_and_less(
      least, Lanes::all(fade_begin<FT>()), sums.scale, Lanes::all(greatest_scale<FT>()));
    return holds ^ ((1u << width) - 1u);
  }

  CGAL_PN_SUBDIVISION_3_AVX2_INLINE Packed weighted_height(const Old& entry,
                                                           const Packed (&q)[dimension],
                                                           const Packed (&n)[dimension],
                                                           Packed& least_denominator)
  {
    Packed s = entry.numbers[dimension] + n[0];
    Packed numerator = s * (entry.numbers[0] - q[0]), denominator = s * n[0];
    for (int c = 1; c < dimension; ++c) {
      s = entry.numbers[dimension + c] + n[c];
      numerator += s * (entry.numbers[c] - q[c]);
      denominator += s * n[c];
    }
    least_denominator = Lanes::lesser(denominator, least_denominator);
    return entry.weight * (numerator / Lanes::greater(denominator, Lanes::all(fade_begin<FT>())));
  }
};

template <class FT, int dimension>
std::uint32_t
Vectorized_PN_average<FT, dimension, true>::average(const Entry* rows, std::size_t length,
                                                    std::size_t number, const Value* old,
                                                    const FT* roundness, Value* result)
{
  return Avx2_PN_average<FT, dimension>::average(rows, length, number, old, roundness, result);
}
#  undef CGAL_PN_SUBDIVISION_3_AVX2_INLINE
#endif

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_ROWS_VECTORIZED_PN_AVERAGE_H

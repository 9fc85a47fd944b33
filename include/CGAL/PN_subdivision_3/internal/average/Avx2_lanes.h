// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_AVERAGE_AVX2_LANES_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_AVERAGE_AVX2_LANES_H

#include <cstddef>
#include <cstdint>
#include <cstring>

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

// The numbers of an AVX2 register, and what the wide averages do with them besides arithmetic.
template <class FT>
struct Avx2_lanes
{
  static constexpr std::size_t width = 0; // there are none
};

#ifdef CGAL_PN_SUBDIVISION_3_HAS_AVX2_FUNCTIONS
#  define CGAL_PN_SUBDIVISION_3_AVX2_INLINE                                                        \
    [[gnu::target("avx2"), gnu::always_inline]] static inline

template <>
struct Avx2_lanes<double>
{
  using Packed = __m256d;
  static constexpr std::size_t width = 4;
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
  static constexpr std::size_t width = 8;
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
#endif

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_AVERAGE_AVX2_LANES_H

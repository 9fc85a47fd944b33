// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_RATIONAL_NORMALS_H
#define CGAL_PN_SUBDIVISION_3_RATIONAL_NORMALS_H

#include <CGAL/PN_subdivision_3/internal/numbers/number_functions.h>
#include <CGAL/Vector_3.h>

#include <stdexcept>

namespace CGAL::PN_subdivision_3 {
namespace internal {

inline int checked_bits(int bits)
{
  constexpr int most = 100000;
  if (bits < 1 || bits > most)
    throw std::invalid_argument("PN_subdivision_3: normals are rounded to 1 to 100000 bits");
  return bits;
}

} // namespace internal

/*!
\ingroup PkgPNSubdivision3Kernels

returns a vector of an exact kernel whose length is 1, exactly, and whose direction is that of `v` up to an angle of less than
1.5 &middot; 2<sup>-bits</sup>. Its coordinates are fractions with a common denominator of at most 2 `bits` + 1 bits, whatever the
length of the numbers of `v`.

It is the stereographic projection of a point whose coordinates are rounded to `bits`. From rational points of a
sphere with such normals through its center each point of the first round is on the sphere up to the rounding of one
length. Control normals that are not unit vectors would be rounded before.

\tparam Kernel a Cartesian kernel with an exact number type
\param v any vector; zero is returned as it is
\param bits from 1 to 100000
\throws std::invalid_argument if `bits` is not in this range
*/
template <class Kernel>
typename Kernel::Vector_3 rational_unit_normal(const CGAL::Vector_3<Kernel>& v, int bits)
{
  using FT = typename Kernel::FT;
  static_assert(internal::is_exact_v<FT>,
                "PN_subdivision_3: rational unit normals are those of exact number types");
  const auto n = internal::rational_unit_vector<FT, 3>({FT(v.x()), FT(v.y()), FT(v.z())},
                                                       internal::checked_bits(bits));
  return typename Kernel::Vector_3(n[0], n[1], n[2]);
}

/*!
\ingroup PkgPNSubdivision3Kernels

While an object of this class exists, refined normals in exact number types without square root (`Gmpq`, that of
EPECK) are rounded as `rational_unit_normal()` does. They are unit vectors exactly, and no longer than 2 `bits` + 1
bits. Otherwise they have the exact direction, and unit length up to 2<sup>-48</sup>. The numbers of the points still
grow from round to round, but slower.

It holds for all threads of the program. Objects are made and destroyed by one thread, not while functions of the package run, and
in the reverse order.
*/
class Rounded_exact_normals
{
public:
  /// begins to round to `bits`. \throws std::invalid_argument if `bits` is not between 1 and 100000
  explicit Rounded_exact_normals(int bits)
    : old_(internal::bits_of_refined_normals().exchange(internal::checked_bits(bits)))
  {}
  /// gives the setting before back.
  ~Rounded_exact_normals() { internal::bits_of_refined_normals() = old_; }
  Rounded_exact_normals(const Rounded_exact_normals&) = delete;
  Rounded_exact_normals& operator=(const Rounded_exact_normals&) = delete;

private:
  int old_;
};

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_SUBDIVISION_3_RATIONAL_NORMALS_H

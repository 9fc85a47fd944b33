// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_CREASES_CREASE_AVERAGE_H
#define CGAL_PN_SUBDIVISION_3_CREASES_CREASE_AVERAGE_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/numbers/Unit_normal_traits.h>
#include <CGAL/Uncertain.h>
#include <CGAL/number_type_basic.h>

#include <boost/container/small_vector.hpp>

#include <cstddef>

namespace CGAL::PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Average

The rule along a crease, a curve on which the surfaces of several wedges meet.

For weights a<sub>j</sub> with sum 1, points p<sub>j</sub>, tangents t<sub>j</sub> of the curve in one direction
of travel, and normals n<sub>wj</sub> of each wedge w,

 - q = &sum; a<sub>j</sub> p<sub>j</sub>, T = &sum; a<sub>j</sub> t<sub>j</sub>, t = T/|T|,
 - the operator T<sub>j</sub> x = x - (x&middot;t)(t<sub>j</sub> + t)/d<sub>j</sub>,
   d<sub>j</sub> = 1 + t<sub>j</sub>&middot;t, carries from p<sub>j</sub> to the new vertex. On vectors orthogonal to
   t<sub>j</sub> it is the smallest rotation from t<sub>j</sub> to t,
 - p = q + &sum; a<sub>j</sub> T<sub>j</sub>(p<sub>j</sub> - q),
 - n<sub>w</sub> is the unit vector of &sum; a<sub>j</sub> T<sub>j</sub> n<sub>wj</sub>.

A circle with its tangents is kept, for any weights, and with it the normals of every surface of
revolution along one of its parallels; straight lines and planes are kept, too. The point and the
tangent do not depend on the normals.

Tangents and normals are unit vectors or zero. (Tangents may be shorter than 1 where the control data
hardly define them.) A zero tangent enters as it is: T<sub>j</sub> x = x - (x&middot;t)t.

<em>Guards.</em> T vanishes if |T| &le; &tau; &sum; |a<sub>j</sub>||t<sub>j</sub>|, see
`Unit_normal_traits::vanishing_tolerance()`; then p = q, t = 0, and n<sub>w</sub> is the unit vector
of &sum; a<sub>j</sub> n<sub>wj</sub>. Otherwise t = S(8|T| / &sum; |a<sub>j</sub>||t<sub>j</sub>|)
T/|T| with S(x) = x<sup>2</sup>(3 - 2x) between 0 and 1; if it is shorter than 10<sup>-6</sup> it is 0. If
t<sub>j</sub> is nearly opposite to t the entry fades. Let &chi;<sub>j</sub> = S((d<sub>j</sub> - 1/64)/(1/4 - 1/64))
and W = &sum; a<sub>j</sub>&chi;<sub>j</sub>. Then the point is q + (&sum; a<sub>j</sub> &chi;<sub>j</sub>
T<sub>j</sub>(p<sub>j</sub> - q))/W, or q if W < 1/64, and the sum of normals has a<sub>j</sub> &chi;<sub>j</sub> for
a<sub>j</sub>. A vanishing sum of normals gives a zero normal.

With a roundness w = &sum; a<sub>j</sub> w<sub>j</sub> the point is q + w &sum; a<sub>j</sub>
T<sub>j</sub>(p<sub>j</sub> - q).

The constructor evaluates the point and the tangent, once for all wedges.
*/
template <class FT_, int dimension>
class Crease_average
{
public:
  /// the number type.
  using FT = FT_;
  /// a vector.
  using Vector = Coordinates<FT, dimension>;

  struct Entry
  {
    FT weight;
    Vector point;
    Vector tangent;
  };

  /// averages the entries `[begin, end)`; the point lies at the fraction `roundness` of the way from q.
  Crease_average(const Entry* begin, const Entry* end, const FT& roundness = FT(1))
    : point_(internal::zero_vector<FT, dimension>())
    , tangent_(internal::zero_vector<FT, dimension>())
  {
    FT length_sum(0);
    for (const Entry* e = begin; e != end; ++e) {
      internal::add_multiple(point_, e->weight, e->point);
      internal::add_multiple(tangent_, e->weight, e->tangent);
      length_sum +=
        CGAL::abs(e->weight) * internal::root_of_square<FT>(internal::dot(e->tangent, e->tangent));
    }
    make_tangent(length_sum);
    for (const Entry* e = begin; e != end; ++e) transports_.push_back(transport(*e));
    add_offset(begin, end, roundness);
  }

  /// the new point.
  const Vector& point() const { return point_; }
  /// the new tangent, a unit vector unless the data hardly define it.
  const Vector& tangent() const { return tangent_; }

  /// the new normal of a wedge with the unit or zero normal `normal_of(j)` at the j-th entry.
  template <class Normal_of>
  Vector normal(const Normal_of& normal_of) const
  {
    Vector sum = internal::zero_vector<FT, dimension>();
    FT length_sum(0);
    for (std::size_t j = 0; j < transports_.size(); ++j) {
      const Transport& t = transports_[j];
      const Vector& n = normal_of(j);
      if (!internal::is_zero_not_unit(n)) length_sum += CGAL::abs(t.weight);
      if (t.takes_part) internal::add_multiple(sum, t.faded_weight, transported(n, t));
    }
    return internal::unit_or_zero(sum, length_sum);
  }

private:
  struct Transport
  {
    FT weight, faded_weight, denominator;
    Vector direction; // t_j + t
    bool takes_part, is_faded;
  };

  void make_tangent(const FT& length_sum)
  {
    const FT squared_length = internal::dot(tangent_, tangent_);
    const FT least = Unit_normal_traits<FT>::vanishing_tolerance() * length_sum;
    if (squared_length <= least * least) {
      tangent_.fill(FT(0));
      return;
    }
    internal::divide_by_length(tangent_, squared_length);
    // the tangents cancel nearly
    if (FT(64) * squared_length < length_sum * length_sum) {
      internal::scale(tangent_,
                      internal::smoothstep<FT>(
                        FT(8) * internal::root_of_square<FT>(squared_length) / length_sum));
      internal::drop_short_tangent(tangent_);
    }
  }

  Transport transport(const Entry& e) const
  {
    static const FT begin = FT(1) / FT(4), end = FT(1) / FT(64);
    Transport t;
    t.weight = t.faded_weight = e.weight;
    t.denominator = FT(1) + internal::dot(e.tangent, tangent_);
    t.direction = tangent_;
    internal::add_multiple(t.direction, FT(1), e.tangent);
    t.is_faded = t.denominator < begin;
    t.takes_part = !t.is_faded || t.denominator > end;
    if (t.is_faded && t.takes_part)
      t.faded_weight *= internal::smoothstep<FT>((t.denominator - end) / (begin - end));
    return t;
  }

  Vector transported(Vector x, const Transport& t) const
  {
    const FT along = internal::dot(x, tangent_) / t.denominator;
    internal::add_multiple(x, FT(-along), t.direction);
    return x;
  }

  void add_offset(const Entry* begin, const Entry* end, const FT& roundness)
  {
    if (CGAL::certainly(internal::dot(tangent_, tangent_) == FT(0))) return;
    const Vector q = point_;
    Vector offset = internal::zero_vector<FT, dimension>();
    FT weight(0);
    bool is_faded = false;
    for (const Entry* e = begin; e != end; ++e) {
      const Transport& t = transports_[std::size_t(e - begin)];
      is_faded = is_faded || t.is_faded;
      if (!t.takes_part) continue;
      weight += t.faded_weight;
      internal::add_multiple(offset, t.faded_weight,
                             transported(internal::difference(e->point, q), t));
    }
    if (is_faded) {
      if (weight < FT(1) / FT(64)) return;
      for (FT& x : offset) x /= weight;
    }
    internal::add_multiple(point_, roundness, offset);
  }

  Vector point_, tangent_;
  boost::container::small_vector<Transport, 4> transports_;
};

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_SUBDIVISION_3_CREASES_CREASE_AVERAGE_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_ROWS_STENCIL_H
#define CGAL_PN_SUBDIVISION_3_ROWS_STENCIL_H

#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>

namespace CGAL::PN_subdivision_3 {
namespace internal {

template <class FT>
class Stencil_block;

} // namespace internal

/*!
\ingroup PkgPNSubdivision3Schemes

The stencil of a new vertex, a row of (old vertex, weight) entries, which a mask writes.

An old vertex may occur more than once in a row; its weights then add up.

\tparam FT_ the number type of the weights
*/
template <class FT_>
class Stencil
{
public:
  /// the number type of the weights.
  using FT = FT_;
  /// numbers an old vertex.
  using Index = std::uint32_t;

  struct Entry
  {
    Index vertex;
    FT weight;
  };

  /// adds the entry (`vertex`, `weight`) to the row.
  BOOST_FORCEINLINE void add(Index vertex, const FT& weight)
  {
    if (size_ == capacity_) grow();
    entries_[size_].vertex = vertex;
    entries_[size_].weight = weight;
    ++size_;
  }

  /// adds `vertex` with the weight that makes the row sum to 1: 1 minus the weights added so far.
  ///
  /// The sum is then exactly 1 in exact number types, and in floating point if the weights are added in the
  /// order in which they were written. Write the largest weight in this way. In an empty row the weight is 1,
  /// and the row a copy of the vertex.
  void add_rest(Index vertex)
  {
    FT sum(0);
    for (std::size_t i = begin_; i < size_; ++i) sum += entries_[i].weight;
    add(vertex, FT(1) - sum);
  }

private:
  friend class internal::Stencil_block<FT>;

  BOOST_NOINLINE void grow()
  {
    std::unique_ptr<Entry[]> larger(new Entry[2 * capacity_]);
    std::move(entries_.get(), entries_.get() + size_, larger.get());
    entries_ = std::move(larger);
    capacity_ *= 2;
  }

  // The rows of a block lie behind each other; the last one, from begin_ on, is being written.
  std::size_t capacity_ = 512;
  std::unique_ptr<Entry[]> entries_{new Entry[capacity_]};
  std::size_t begin_ = 0;
  std::size_t size_ = 0;
};

/*!
\ingroup PkgPNSubdivision3Schemes
writes the row of a border vertex, the one that the border half-edge `border` leads to: `w` for its two
neighbors on the border and 1 - 2`w` for itself.
\pre `level.is_border(border)`
*/
template <class FT, class Stencil>
void add_along_border(const Level_connectivity& level, Level_connectivity::Index border,
                      const FT& w, Stencil& s)
{
  s.add(level.source(border), w);
  s.add(level.target(level.next(border)), w);
  s.add_rest(level.target(border));
}

/*!
\ingroup PkgPNSubdivision3Schemes

The region around a vertex that has to be regular, so that a scheme does the same there in every round from now on.
One matrix then maps the ring of the vertex to the ring of its successor. A scheme has a static constant
`limit_neighborhood` of this type; without it, these are the defaults, which serve all schemes with masks no larger
than those of the package.
*/
struct Limit_neighborhood
{
  /// in how many rings the other vertices have to be regular. With 0 the rules at a vertex depend on its valence and
  /// the degrees of its faces alone.
  unsigned regular_rings = 2;
  /// whether these vertices may lie on the border.
  bool takes_border = false;
  /// whether the surface is one of piecewise polynomials where all vertices are regular, its border a cubic spline.
  bool is_spline = false;
  /// whether vertices keep their points and normals.
  bool keeps_points = false;
  /// whether the surface has tangent planes. If it has none, control normals stand in for its normals; vertices
  /// then have to keep their points.
  bool has_tangent_planes = true;
};

namespace internal {

// The base of schemes whose masks need no more than a level.
template <class Host_, template <class> class Mask>
struct Scheme_of_mask
{
  using Host = Host_;

  template <class FT>
  Mask<FT> mask(const Level_connectivity& level, unsigned /*round*/) const
  {
    return Mask<FT>(level);
  }
};

} // namespace internal

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_SUBDIVISION_3_ROWS_STENCIL_H

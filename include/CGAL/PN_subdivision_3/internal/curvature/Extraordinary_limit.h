// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_CURVATURE_EXTRAORDINARY_LIMIT_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_CURVATURE_EXTRAORDINARY_LIMIT_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/curvature/Extraordinary_net.h>
#include <CGAL/PN_subdivision_3/internal/curvature/Local_frame.h>
#include <CGAL/PN_subdivision_3/internal/curvature/Ring_functionals.h>

#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// Left eigenvectors of Catmull-Clark and Loop subdivision at a vertex of any valence, over its
// 1-ring: that of 1, the limit mask, and the complex one of the subdominant eigenvalue. Tuned rules
// with the same eigenvectors share them.
template <class FT>
class Extraordinary_limit
{
public:
  using Index = Level_connectivity::Index;
  using Value = Point_normal<FT, 3>;

  explicit Extraordinary_limit(const Extraordinary_net& net)
  {
    const Index n = net.valence();
    const Ring_functionals<FT> ring(net.degree(), n);
    const auto add = [&](Index v, Index place) {
      entries_.push_back(
        {v, ring.limit()[place].weight, {ring.tangent(0)[place], ring.tangent(1)[place]}});
    };
    add(0, 0);
    for (Index s = 0; s < n; ++s) {
      add(net.vertex(s, 1, 0), 1 + s);
      if (net.degree() == 4) add(net.vertex(s, 1, 1), 1 + n + s);
    }
  }

  // The limit point and the limit control normal, zero without control normals: the PN average.
  Value limit(const std::vector<Value>& values) const
  {
    const Entry* const first = entries_.data();
    return PN_average<FT, 3>()(first, first + entries_.size(), values.data());
  }

  // applies the tangent mask to f(value), a scalar
  template <class Function>
  Pair<FT> tangent(const std::vector<Value>& values, const Function& f) const
  {
    Pair<FT> t{};
    for (const Entry& e : entries_) {
      const FT x = f(values[e.vertex]);
      t[0] += e.tangent[0] * x;
      t[1] += e.tangent[1] * x;
    }
    return t;
  }

private:
  struct Entry
  {
    Index vertex;
    FT weight;        // of the limit mask
    Pair<FT> tangent; // real and imaginary part
  };

  std::vector<Entry> entries_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_CURVATURE_EXTRAORDINARY_LIMIT_H

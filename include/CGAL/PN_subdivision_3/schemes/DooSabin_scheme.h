// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_SCHEMES_DOOSABIN_SCHEME_H
#define CGAL_PN_SUBDIVISION_3_SCHEMES_DOOSABIN_SCHEME_H

#include <CGAL/PN_subdivision_3/hosts/DQQ_host.h>
#include <CGAL/PN_subdivision_3/internal/hosts/check_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/schemes/Ring_tuning.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/rows/Stencil.h>
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_weights.h>

#include <cstddef>
#include <map>
#include <vector>

namespace CGAL::PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Schemes

The original weights of Doo-Sabin subdivision, as in `CGAL::Subdivision_method_3::DooSabin_mask_3`. The corner of an
n-gon has the weight (n + 5)/(4n) for itself and (3 + 2cos(2&pi;k/n))/(4n) for the vertex k steps along the face.

\tparam FT a field; the cosines are those of `cosine_weight()`
\cgalModels{PNSubdivisionMask_3}
*/
template <class FT>
class DooSabin_mask
{
public:
  /// numbers an element.
  using Index = Level_connectivity::Index;

  /// makes the mask of a level, which has to live as long.
  explicit DooSabin_mask(const Level_connectivity& level)
    : level_(level)
  {
    if (level.uniform_degree() == 4) return;
    for (Index f = 0; f < level.number_of_faces(); ++f) {
      const Index h = level.halfedge_of_face(f);
      if (level.has_degree(h, 4)) continue;
      const Index n = level.degree(h);
      if (weights_.find(n) == weights_.end()) weights_.emplace(n, weights(n));
    }
  }

  /// the corner of the face of `h` at the target of `h`.
  template <class Stencil>
  void corner(Index h, Stencil& s) const
  {
    if (level_.has_degree(h, 4)) {
      const Index h1 = level_.next(h), h2 = level_.next(h1);
      s.add(level_.target(h1), three_16ths_);
      s.add(level_.target(h2), one_16th_);
      s.add(level_.target(level_.next(h2)), three_16ths_);
      s.add(level_.target(h), nine_16ths_);
      return;
    }
    const std::vector<FT>& weights = weights_.find(level_.degree(h))->second;
    std::size_t k = 1;
    for (Index g = level_.next(h); g != h; g = level_.next(g), ++k)
      s.add(level_.target(g), weights[k]);
    s.add_rest(level_.target(h));
  }

private:
  // the weights of the vertices k steps along a face of degree n; the weight of k = 0 is not used
  static std::vector<FT> weights(Index n)
  {
    std::vector<FT> result;
    for (Index k = 0; k < n; ++k)
      result.push_back((FT(3) + FT(2) * cosine_weight<FT>(k, n)) / FT(int(4 * n)));
    return result;
  }

  const Level_connectivity& level_;
  std::map<Index, std::vector<FT>> weights_; // for every degree but 4
  FT one_16th_ = FT(1) / FT(16), three_16ths_ = FT(3) / FT(16), nine_16ths_ = FT(9) / FT(16);
};

/*!
\ingroup PkgPNSubdivision3Schemes
Doo-Sabin subdivision: `DooSabin_mask` on `DQQ_host`. Accepts any polygons, and no interior vertex of
valence 2, of which a face with two corners would be left.
\cgalModels{PNSubdivisionScheme_3}
*/
struct DooSabin_scheme : internal::Scheme_of_mask<DQQ_host, DooSabin_mask>
{
  /// the name of the scheme, as in the command `pn_subdivide`.
  static constexpr const char* name() { return "doo-sabin"; }
  /// how many rings of faces a piece of a mesh needs around it, see `Surface_pieces`.
  static constexpr unsigned ghost_rings = 1;

  /// refuses an interior vertex of valence 2.
  template <class Element_names>
  static void check(const Level_connectivity& level, const Element_names& names)
  {
    internal::check_interior_valences(level, names);
  }

  /// see `estimated_row_entries()`: the m corners of a face have m entries each. Vertices are faces from the first round on.
  static double dense_row_entries(const Level_connectivity& level, unsigned round)
  {
    return internal::squared_irregular_degrees(level) +
           (round == 1 ? 0 : internal::squared_irregular_valences(level, 4));
  }
};

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_SUBDIVISION_3_SCHEMES_DOOSABIN_SCHEME_H

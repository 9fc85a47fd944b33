// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_SCHEMES_BILINEAR_SCHEME_H
#define CGAL_PN_SUBDIVISION_3_SCHEMES_BILINEAR_SCHEME_H

#include <CGAL/PN_subdivision_3/hosts/PQQ_host.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/rows/Stencil.h>
#include <CGAL/PN_subdivision_3/schemes/Midpoint_scheme.h>

namespace CGAL::PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Schemes

The weights of `Midpoint_mask` for vertices and edges; the new vertex of a face is the mean of its corners.

\tparam FT a field
\cgalModels{PNSubdivisionMask_3}
*/
template <class FT>
class Bilinear_mask : public Midpoint_mask<FT>
{
public:
  /// numbers an element.
  using Index = Level_connectivity::Index;

  /// makes the mask of a level, which has to live as long.
  explicit Bilinear_mask(const Level_connectivity& level)
    : Midpoint_mask<FT>(level)
    , level_(level)
  {}

  /// the row of the new vertex of a face.
  template <class Stencil>
  void face(Index f, Stencil& s) const
  {
    const Index h = level_.halfedge_of_face(f);
    const FT weight = FT(1) / FT(int(level_.degree(h)));
    for (Index g = level_.next(h); g != h; g = level_.next(g)) s.add(level_.target(g), weight);
    s.add_rest(level_.target(h));
  }

private:
  const Level_connectivity& level_;
};

/*!
\ingroup PkgPNSubdivision3Schemes
Upsampling of polygons: `Bilinear_mask` on `PQQ_host`. The linear scheme leaves planar faces as they are, and bends
others into bilinear patches; see `Midpoint_scheme` for the rest. Accepts any polygons.
\cgalModels{PNSubdivisionScheme_3}
*/
struct Bilinear_scheme : internal::Scheme_of_mask<PQQ_host, Bilinear_mask>
{
  /// the name of the scheme, as in the command `pn_subdivide`.
  static constexpr const char* name() { return "bilinear"; }
  /// how many rings of faces a piece of a mesh needs around it, see `Surface_pieces`.
  static constexpr unsigned ghost_rings = 1;
  /// what has to be regular around a vertex for its limit.
  static constexpr Limit_neighborhood limit_neighborhood = Midpoint_scheme::limit_neighborhood;
};

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_SUBDIVISION_3_SCHEMES_BILINEAR_SCHEME_H

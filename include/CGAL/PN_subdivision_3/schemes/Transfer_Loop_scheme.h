// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_SUBDIVISION_3_SCHEMES_TRANSFER_LOOP_SCHEME_H
#define CGAL_PN_SUBDIVISION_3_SCHEMES_TRANSFER_LOOP_SCHEME_H

#include <CGAL/PN_subdivision_3/internal/schemes/Ring_tuning.h>
#include <CGAL/PN_subdivision_3/schemes/Limit_neighborhood.h>
#include <CGAL/PN_subdivision_3/schemes/Tuned_Loop_scheme.h>

namespace CGAL {
namespace PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Schemes
Loop subdivision with transfer of curvature, see `CatmullClark_scheme::Transfer`, which has all that is said
here in common with it: `Tuned_Loop_mask` on `PTQ_host`, where the quadratic eigenvalues (that of
frequency 0 besides 1, and of frequencies 2 and n-2) become &lambda;'<sup>2</sup>. At valence 3 there
is one functional, at valence 4 there are two: of the three components of Q the least ones that they
allow are taken, and directions of curvature are not preserved there.

Accepts triangles only.
\cgalModels{PNSubdivisionScheme_3}
*/
class Loop_scheme::Transfer
{
public:
  /// the host of the scheme.
  using Host = PTQ_host;

  /// the name of the scheme, as in the command `pn_subdivide`.
  static constexpr const char* name() { return "ct-loop"; }
  /// how many rings of faces a piece of a mesh needs around it, see `Surface_pieces`.
  static constexpr unsigned ghost_rings = 3;
  /// what has to be regular around a vertex for its limit.
  static constexpr Limit_neighborhood limit_neighborhood = Loop_scheme::Tuned::limit_neighborhood;

  /// along creases the rules are those of the border.
  static constexpr bool has_crease_rules = true;

  /// after every round normals are corrected at separated vertices.
  static constexpr bool transfers_curvature = true;

  /// the mask of a round; see `PNSubdivisionScheme_3`.
  template <class FT>
  Tuned_Loop_mask<FT> mask(const Level_connectivity& level, unsigned round) const
  {
    internal::Ring_tuning tuning;
    tuning.keeps_quadratic = true;
    return Tuned_Loop_mask<FT>(level, round, tuning);
  }

  /// see `estimated_row_entries()`, which counts them twice for the transfer: those of `Loop_scheme::Tuned`.
  static double dense_row_entries(const Level_connectivity& level, unsigned round)
  {
    return Loop_scheme::Tuned::dense_row_entries(level, round);
  }
};

} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_SCHEMES_TRANSFER_LOOP_SCHEME_H

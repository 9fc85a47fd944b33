// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

/*!
\ingroup PkgPNSubdivision3Concepts
\cgalConcept

A subdivision scheme: a host, which says how the connectivity is refined, and a mask, which gives
the weights of the new vertices.

\cgalHasModelsBegin
\cgalHasModels{CGAL::PN_subdivision_3::CatmullClark_scheme}
\cgalHasModels{CGAL::PN_subdivision_3::Loop_scheme}
\cgalHasModelsEnd
*/
class PNSubdivisionScheme_3
{
public:
  /// a model of `PNSubdivisionHost_3`.
  using Host = unspecified_type;

  /// returns a model of `PNSubdivisionMask_3` for `level`, in the number type `FT`.
  /// Rounds are counted from 0 in one call of a subdivision function.
  template <class FT>
  unspecified_type mask(const CGAL::PN_subdivision_3::Level_connectivity& level,
                        unsigned round) const;
};

// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

/*!
\ingroup PkgPNSubdivision3Concepts
\cgalConcept

A mask of curves: finitely many coefficients \f$a_i\f$. The new point \f$i\f$ has the weights
\f$a_{i-2j}\f$ on the old points \f$j\f$.

- The coefficients of even and those of odd index each sum to 1.
- An odd number of coefficients makes a primal mask, with a new point for every old one and for every
  edge; an even number makes a dual one.

\cgalHasModelsBegin
\cgalHasModels{CGAL::PN_subdivision_3::B_spline_mask}
\cgalHasModels{CGAL::PN_subdivision_3::Dubuc_Deslauriers_mask}
\cgalHasModels{CGAL::PN_subdivision_3::Univariate_mask}
\cgalHasModelsEnd

\sa `CGAL::PN_subdivision_3::subdivide_curve()`
*/
class PNSubdivisionCurveMask
{
public:
  /// returns the index of the first coefficient.
  int first_index() const;

  /// returns the coefficients in the order of their indices, in the number type of the curve.
  template <class FT>
  std::vector<FT> coefficients() const;
};

// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

/*!
\ingroup PkgPNSubdivision3Concepts
\cgalConcept

A value at vertices or corners that `CGAL::PN_subdivision_3::subdivide()` refines by the linear rows of a scheme, see
`CGAL::PN_subdivision_3::parameters::vertex_attribute()`. A type that is not among the models below
specializes `CGAL::PN_subdivision_3::Attribute_traits`, or has the following; values of corners must also be comparable by `==`.
Values of other types are refused when a call is compiled, by one line. Labels, of `CGAL::PN_subdivision_3::parameters::nearest_attribute()`, need
only be copied.

All built-in numbers are models, the number type of the points, and `std::array` of these.

\cgalHasModelsBegin
\cgalHasModels{float}
\cgalHasModels{double}
\cgalHasModels{int}
\cgalHasModels{std::array}
\cgalHasModels{CGAL::Point_2}
\cgalHasModels{CGAL::Point_3}
\cgalHasModels{CGAL::Vector_2}
\cgalHasModels{CGAL::Vector_3}
\cgalHasModels{CGAL::IO::Color}
\cgalHasModels{Eigen::Matrix}
\cgalHasModelsEnd

\sa `CGAL::PN_subdivision_3::parameters::attributes()`
*/
class PNSubdivisionAttribute
{
public:
  /// the value of new elements until they are computed.
  PNSubdivisionAttribute();
};

/// returns the sum.
/// \relates PNSubdivisionAttribute
PNSubdivisionAttribute operator+(const PNSubdivisionAttribute& a, const PNSubdivisionAttribute& b);
/// returns the product with a weight; the weight may stand before the value.
/// \relates PNSubdivisionAttribute
PNSubdivisionAttribute operator*(const PNSubdivisionAttribute& a, double w);

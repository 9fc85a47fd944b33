// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

/*!
\ingroup PkgPNSubdivision3Concepts
\cgalConcept

A value at vertices or corners that `CGAL::PN_subdivision_3::subdivide()` refines by the linear rows of a scheme, see
`CGAL::PN_subdivision_3::parameters::vertex_attribute()`. Numbers, arrays of them, and points and vectors of \cgal are models. Other types
specialize `CGAL::PN_subdivision_3::Attribute_traits`, or have the following; values of corners must also be comparable by `==`.

Models are built-in numbers, number types of \cgal, `std::array` of them, `CGAL::Point_2`, `CGAL::Point_3`, `CGAL::Vector_2`,
`CGAL::Vector_3`, `CGAL::IO::Color`, and vectors and matrices of fixed size of Eigen. Values that are not are refused when a call is
compiled, by one line.

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

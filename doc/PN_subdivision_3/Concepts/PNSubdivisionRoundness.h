// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

/*!
\ingroup PkgPNSubdivision3Concepts
\cgalConcept

The roundness of a vertex: a number from 0, linear, to 1, point-normal, which the number type of the points is constructed
from. Maps of them are given by `CGAL::PN_subdivision_3::parameters::vertex_roundness_map()`, one number by
`CGAL::PN_subdivision_3::parameters::roundness()`. In a map that is written, masks with negative weights leave values up to 1/2 beyond.

All built-in numbers except `bool` are models, and number types of \cgal that are constructed from that of the points.

\cgalHasModelsBegin
\cgalHasModels{float}
\cgalHasModels{double}
\cgalHasModels{CGAL::Gmpq}
\cgalHasModelsEnd

\sa `CGAL::PN_subdivision_3::PN_average`
*/
class PNSubdivisionRoundness
{};

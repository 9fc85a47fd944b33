// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_SCHEMES_TRANSFER_SCHEMES_H
#define CGAL_PN_SUBDIVISION_3_SCHEMES_TRANSFER_SCHEMES_H

#include <CGAL/PN_subdivision_3/schemes/Tuned_CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Tuned_Loop_scheme.h>

namespace CGAL::PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Schemes
Catmull-Clark subdivision with transfer of curvature: the PN scheme keeps at extraordinary vertices the
curvature that is in the control points, too, and not only that of the control normals, as
`CatmullClark_scheme::Tuned` does.

<b>Weights.</b> Those of `Tuned_CatmullClark_mask` on `PQQ_host`, with other eigenvalues. The *quadratic* ones become
&lambda;'<sup>2</sup>: the larger one of frequency 0 besides 1, and the larger one of frequencies 2 and n-2, for n = 3
the smaller one of frequencies 1 and 2. All others are bounded by &lambda;'<sup>2</sup>/2.

<b>Transfer.</b> After every round, in the new 1-ring of each vertex with these weights, let N be the limit control
normal and o the limit point. Let u<sub>j</sub> be the coordinates of the points in the plane perpendicular to N
through o, and w<sub>j</sub> their point-normal heights over it less the slope of the surface. Let g<sub>j</sub> be
the slopes of the control normals. The left eigenvectors L of the quadratic eigenvalues give the quadratic form Q with
L(u<sup>T</sup>Qu/2) = L(w), the least one if it is not determined. Then g<sub>j</sub> becomes g<sub>j</sub> + Q
u<sub>j</sub>/2: half of the quadratic part of the heights goes to the normals. Points stay. Nothing is done

 - where a normal of the ring is zero or more than 60 degrees from N,
 - where all |L(w)| are at most 64 machine epsilons of the largest coordinate: spheres and cylinders
   stay what they are,
 - where the ring has collapsed to a line or a point.

The transfer is computed in the number type if that rounds and has square roots (`long double`, `Gmpfr`, Boost's
floats; `float` is widened to `double`), otherwise in `double`. In exact types the points remain exact, and Q is rounded. With interval number types
`std::invalid_argument` is thrown. The result is the same for any number of threads, and it does not depend on the
place, orientation and unit of the mesh up to rounding. `linear()` has the weights and no transfer. Near creases all is as at borders, where nothing is transferred. `with_normal_scheme()`
refuses it, since points and normals belong together.

This is no scheme of the paper; neither is it better everywhere, see the manual. Accepts any polygons.
<br><b>Cost:</b> of a round besides that of `CatmullClark_scheme::Tuned`: the rows of the 1-rings once more, and
linear in their size
\cgalModels{PNSubdivisionScheme_3}
*/
class CatmullClark_scheme::Transfer : public CatmullClark_scheme::Tuned
{
public:
  /// the name of the scheme, as in the command `pn_subdivide`.
  static constexpr const char* name() { return "ct-catmull-clark"; }

  /// after every round normals are corrected at separated vertices.
  static constexpr bool transfers_curvature = true;

  /// the scheme takes no parameter.
  Transfer() { tuning_.keeps_quadratic = true; }
};

/*!
\ingroup PkgPNSubdivision3Schemes
Loop subdivision with transfer of curvature, see `CatmullClark_scheme::Transfer`. The weights are those of
`Tuned_Loop_mask` on `PTQ_host`, but the quadratic eigenvalues (that of frequency 0 besides 1, and of frequencies 2
and n-2) become &lambda;'<sup>2</sup>. At valence 3 there is one functional, at valence 4 there are two: of the three
components of Q the least ones that they allow are taken, and directions of curvature are not preserved there.

Accepts triangles only.
\cgalModels{PNSubdivisionScheme_3}
*/
class Loop_scheme::Transfer : public Loop_scheme::Tuned
{
public:
  /// the name of the scheme, as in the command `pn_subdivide`.
  static constexpr const char* name() { return "ct-loop"; }

  /// after every round normals are corrected at separated vertices.
  static constexpr bool transfers_curvature = true;

  /// the scheme takes no parameter.
  Transfer() { tuning_.keeps_quadratic = true; }
};

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_SUBDIVISION_3_SCHEMES_TRANSFER_SCHEMES_H

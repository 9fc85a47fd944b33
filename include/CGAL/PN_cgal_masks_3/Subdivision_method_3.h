// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_CGAL_MASKS_3_SUBDIVISION_METHOD_3_H
#define CGAL_PN_CGAL_MASKS_3_SUBDIVISION_METHOD_3_H

#include <CGAL/PN_cgal_masks_3/internal/Cgal_ordered_host.h>
#include <CGAL/PN_cgal_masks_3/internal/Masked_round.h>
#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
#include <CGAL/PN_subdivision_3/parameters/parameters.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/DooSabin_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Sqrt3_scheme.h>
#include <CGAL/PN_subdivision_3/subdivide.h>

#include <type_traits>

namespace CGAL::PN_subdivision_3 {
namespace internal {

template <class Scheme, class PolygonMesh, class NamedParameters>
void subdivide_as_cgal(PolygonMesh& mesh, const Scheme& scheme, const NamedParameters& np)
{
  using Parameters = Surface_parameters<PolygonMesh, NamedParameters>;
  const auto ordered = in_order_of_cgal<recycles_v<PolygonMesh>>(scheme);
  if constexpr (std::is_same_v<typename Parameters::Normal_map, No_normal_map>)
    PN_subdivision_3::subdivide(mesh, linear(ordered), np);
  else
    PN_subdivision_3::subdivide(mesh, ordered, np);
}

// Calls round(r, i) for the rounds i = 0, 1, ... The values of the point map may be anything that the mask sets.
template <class PolygonMesh, class Mask, class NamedParameters, class Round>
void masked_rounds(PolygonMesh& mesh, const Mask& mask, const NamedParameters& np,
                   const Round& round)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const auto iterations = CGAL::parameters::number_of_iterations(
    choose_parameter(get_parameter(np, internal_np::number_of_iterations), 1u));
  const unsigned rounds =
    Surface_parameters<PolygonMesh, std::decay_t<decltype(iterations)>>::number_of_iterations(
      iterations);
  using Point_map = typename GetVertexPointMap<PolygonMesh, NamedParameters>::type;
  const Point_map points = choose_parameter(get_parameter(np, internal_np::vertex_point),
                                            get_property_map(vertex_point, mesh));
  for (unsigned i = 0; i < rounds; ++i) {
    Masked_round<PolygonMesh, Point_map, Mask> one(mesh, points, mask);
    round(one, i);
  }
}

inline auto iterations(int number)
{
  return CGAL::parameters::number_of_iterations(number < 0 ? 0 : number);
}

} // namespace internal

/*!
\ingroup PkgPNSubdivision3Functions

The functions of `CGAL::Subdivision_method_3`, with the same signatures, by this package: a program changes an
`#include` and a namespace. The connectivity and the order of the vertices are the same. Points differ from those of
\cgal by not more than 8 &middot; 2<sup>-52</sup> of the box of the points. (`DooSabin_subdivision()` and `DQQ()` have
the order of a `Polyhedron_3` whose border vertices have a half-edge on the border. In a `Surface_mesh` \cgal's own functions use the places of removed vertices again from the second round
on, and leave others behind.)

With a `vertex_normal_map` the point-normal schemes are applied, without it the linear ones: no normals are estimated. All other
named parameters of `PN_subdivision_3::subdivide()` serve here as there, sharp edges by `edge_is_constrained_map` among them.

\cgal crashes or writes NaN on some meshes. These functions keep vertices without edges (dual schemes drop them).
Faces that cannot be refined are a `std::invalid_argument` that names the element, and leaves the mesh as it was.
*/
namespace Subdivision_method_3 {

namespace parameters = PN_subdivision_3::parameters;

/// \ingroup PkgPNSubdivision3Functions
/// applies Catmull-Clark subdivision.
template <class PolygonMesh, class NamedParameters = parameters::Default_named_parameters,
          class = std::enable_if_t<!std::is_arithmetic_v<NamedParameters>>>
void CatmullClark_subdivision(PolygonMesh& mesh,
                              const NamedParameters& np = parameters::default_values())
{
  internal::subdivide_as_cgal(mesh, CatmullClark_scheme(), np);
}
/// \ingroup PkgPNSubdivision3Functions
/// applies Loop subdivision, to triangles.
template <class PolygonMesh, class NamedParameters = parameters::Default_named_parameters,
          class = std::enable_if_t<!std::is_arithmetic_v<NamedParameters>>>
void Loop_subdivision(PolygonMesh& mesh, const NamedParameters& np = parameters::default_values())
{
  internal::subdivide_as_cgal(mesh, Loop_scheme(), np);
}
/// \ingroup PkgPNSubdivision3Functions
/// applies Doo-Sabin subdivision.
template <class PolygonMesh, class NamedParameters = parameters::Default_named_parameters,
          class = std::enable_if_t<!std::is_arithmetic_v<NamedParameters>>>
void DooSabin_subdivision(PolygonMesh& mesh,
                          const NamedParameters& np = parameters::default_values())
{
  internal::subdivide_as_cgal(mesh, DooSabin_scheme(), np);
}
/// \ingroup PkgPNSubdivision3Functions
/// applies \f$ \sqrt{3} \f$ subdivision, to triangles; even rounds of a call refine the border.
template <class PolygonMesh, class NamedParameters = parameters::Default_named_parameters,
          class = std::enable_if_t<!std::is_arithmetic_v<NamedParameters>>>
void Sqrt3_subdivision(PolygonMesh& mesh, const NamedParameters& np = parameters::default_values())
{
  internal::subdivide_as_cgal(mesh, Sqrt3_scheme(), np);
}

/*!
\ingroup PkgPNSubdivision3Functions
splits polygons into quadrilaterals, at points of the user's mask. It is asked for all points of a round before
the mesh is changed.
\tparam Mask a model of \cgal's `PQQMask_3`: `face_node()`, `edge_node()`, `vertex_node()` and `border_node()`
\param mesh,mask,np as of \cgal's function; of named parameters `vertex_point_map` and `number_of_iterations` are used
*/
template <class PolygonMesh, class Mask, class NamedParameters,
          class = std::enable_if_t<!std::is_arithmetic_v<NamedParameters>>>
void PQQ(PolygonMesh& mesh, Mask mask, const NamedParameters& np)
{
  internal::masked_rounds(mesh, mask, np, [](auto& round, unsigned) { round.pqq(); });
}
/// \ingroup PkgPNSubdivision3Functions
/// splits triangles into four; the mask is a model of \cgal's `PTQMask_3`.
template <class PolygonMesh, class Mask, class NamedParameters,
          class = std::enable_if_t<!std::is_arithmetic_v<NamedParameters>>>
void PTQ(PolygonMesh& mesh, Mask mask, const NamedParameters& np)
{
  internal::masked_rounds(mesh, mask, np, [](auto& round, unsigned) { round.ptq(); });
}
/// \ingroup PkgPNSubdivision3Functions
/// makes a vertex of every corner of a face; the mask is a model of \cgal's `DQQMask_3`, with `corner_node()`.
template <class PolygonMesh, class Mask, class NamedParameters,
          class = std::enable_if_t<!std::is_arithmetic_v<NamedParameters>>>
void DQQ(PolygonMesh& mesh, Mask mask, const NamedParameters& np)
{
  internal::masked_rounds(mesh, mask, np, [](auto& round, unsigned) { round.dqq(); });
}
/// \ingroup PkgPNSubdivision3Functions
/// splits triangles into three and flips the old edges; the mask is a model of \cgal's `Sqrt3Mask_3`.
template <class PolygonMesh, class Mask, class NamedParameters,
          class = std::enable_if_t<!std::is_arithmetic_v<NamedParameters>>>
void Sqrt3(PolygonMesh& mesh, Mask mask, const NamedParameters& np)
{
  internal::masked_rounds(mesh, mask, np, [](auto& round, unsigned i) { round.sqrt3(i % 2 == 1); });
}

/// \cond
// the number of rounds as it was once given
template <class PolygonMesh>
void CatmullClark_subdivision(PolygonMesh& mesh, int step)
{
  CatmullClark_subdivision(mesh, internal::iterations(step));
}
template <class PolygonMesh>
void Loop_subdivision(PolygonMesh& mesh, int step)
{
  Loop_subdivision(mesh, internal::iterations(step));
}
template <class PolygonMesh>
void DooSabin_subdivision(PolygonMesh& mesh, int step)
{
  DooSabin_subdivision(mesh, internal::iterations(step));
}
template <class PolygonMesh>
void Sqrt3_subdivision(PolygonMesh& mesh, int step)
{
  Sqrt3_subdivision(mesh, internal::iterations(step));
}
template <class PolygonMesh, class Mask>
void PQQ(PolygonMesh& mesh, Mask mask, int step = 1)
{
  PQQ(mesh, mask, internal::iterations(step));
}
template <class PolygonMesh, class Mask>
void PTQ(PolygonMesh& mesh, Mask mask, int step = 1)
{
  PTQ(mesh, mask, internal::iterations(step));
}
template <class PolygonMesh, class Mask>
void DQQ(PolygonMesh& mesh, Mask mask, int step = 1)
{
  DQQ(mesh, mask, internal::iterations(step));
}
template <class PolygonMesh, class Mask>
void Sqrt3(PolygonMesh& mesh, Mask mask, int step = 1)
{
  Sqrt3(mesh, mask, internal::iterations(step));
}
/// \endcond

} // namespace Subdivision_method_3
} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_CGAL_MASKS_3_SUBDIVISION_METHOD_3_H

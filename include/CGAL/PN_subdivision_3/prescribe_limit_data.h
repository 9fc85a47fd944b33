// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_PRESCRIBE_LIMIT_DATA_H
#define CGAL_PN_SUBDIVISION_3_PRESCRIBE_LIMIT_DATA_H

#include <CGAL/PN_subdivision_3/internal/interpolation/Prescription.h>
#include <CGAL/PN_subdivision_3/interpolate_limit_points.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {

/// \ingroup PkgPNSubdivision3Interpolation
/// Stands for a map when nothing of its kind is prescribed.
struct Nothing_prescribed
{};

/// \ingroup PkgPNSubdivision3Interpolation
/// How `prescribe_limit_data()` proceeds.
struct Limit_prescription_options
{
  /// how far limit points may be from the prescribed ones, as a part of the largest side of the bounding
  /// box of the control points.
  double tolerance = 1e-12;
  /// the most rounds of refinement about a vertex.
  unsigned max_depth = 12;
  /// control points move within so many rings of faces about the vertices with prescribed data.
  unsigned rings = 2;
};

namespace internal {

// the unit vector of x; throws with the name of the vertex if there is none
template <class Name>
Eigen_vector<3> prescribed_unit(const Eigen_vector<3>& x, const Name& name)
{
  const double length = x.stableNorm();
  if (!(length > 0) || !std::isfinite(length))
    throw std::invalid_argument("PN_subdivision_3: the normal that is prescribed at " + name() +
                                " has no direction: give it finite coordinates that are not all "
                                "zero, or std::nullopt");
  return x / length;
}

template <class Access, class Map>
std::optional<Eigen_vector<3>>
prescribed_at([[maybe_unused]] const Access& access, [[maybe_unused]] const Map& map,
              [[maybe_unused]] Level_connectivity::Index v, [[maybe_unused]] const char* what)
{
  if constexpr (!std::is_same_v<Map, Nothing_prescribed>) {
    const auto& value = get(map, access.vertex(v));
    if (value) {
      const Eigen_vector<3> x(close_double(value->x()), close_double(value->y()),
                              close_double(value->z()));
      if (!x.allFinite())
        throw std::invalid_argument("PN_subdivision_3: the " + std::string(what) +
                                    " that is prescribed at " + access.vertex_name(v) +
                                    " is not finite: give it finite coordinates");
      return x;
    }
  }
  return std::nullopt;
}

template <class Access, class Prescribed_points, class Prescribed_normals>
std::vector<Prescribed_vertex>
read_prescribed(const Access& access, const Level_connectivity& level,
                const Prescribed_points& points, const Prescribed_normals& normals)
{
  std::vector<Prescribed_vertex> all;
  for (Level_connectivity::Index v = 0; v < level.number_of_vertices(); ++v) {
    Prescribed_vertex p;
    p.vertex = v;
    p.point = prescribed_at(access, points, v, "limit point");
    p.normal = prescribed_at(access, normals, v, "normal");
    if (p.normal) p.normal = prescribed_unit(*p.normal, [&] { return access.vertex_name(v); });
    if (p.point || p.normal) all.push_back(p);
  }
  return all;
}

} // namespace internal

/*!
\ingroup PkgPNSubdivision3Interpolation

changes the control points of a mesh so that the limit surface has prescribed points and unit normals at
some vertices. Control normals stay. Both kinds of conditions are linear in the control points, so that
there is nothing to iterate: one system with the conditions and the smoothest change of the net is
solved,

  minimize &sum; |U &delta;<sub>v</sub>|<sup>2</sup> + 10<sup>-6</sup> |&delta;<sub>v</sub>|<sup>2</sup>

with the umbrella Laplacian U, over the vertices within `options.rings` rings of faces about those with
prescribed data; all others stay. Where conditions contradict each other, or are more than there are
control points to move, the least-squares solution results, and the report says what is left: with all
points and all normals prescribed, subdivide once before, and prescribe at the old vertices.

Normals can be prescribed where the scheme tells of a tangent plane, see `limit_points()`: at interior
vertices, and on the border at valence 3 (Catmull-Clark) or 3 to 6 (Loop). Two patches that prescribe the
same points and normals along a common border meet with common tangent planes at its vertices.

Computed in `double`, whatever the number type.

\tparam PrescribedPoints a model of `ReadablePropertyMap` from vertices to `std::optional` of a point, or
  `Nothing_prescribed`
\tparam PrescribedNormals likewise, of a vector of any length

\param mesh an oriented 2-manifold with border; its points are changed
\param scheme as for `interpolate_limit_points()`
\param points the limit points that are prescribed
\param normals the surface normals that are prescribed
\param options how to proceed
\param np as for `interpolate_limit_points()`; the `vertex_normal_map` is read only, and without it
  control normals are estimated from the given points

\returns what was reached: `residual` for the points, `normal_residual` for the normals. The control net is
  never further from what is prescribed than it was.

\throws std::invalid_argument as `interpolate_limit_points()` does, and with the name of the vertex if what
  is prescribed is not finite, or a normal is prescribed where the scheme tells of no tangent plane;
  the mesh has not been changed then
<br><b>Cost:</b> that of a sparse factorization over the control points that may move
*/
template <class Concurrency_tag = Sequential_tag, class PolygonMesh, class Scheme,
          class PrescribedPoints, class PrescribedNormals,
          class NamedParameters = parameters::Default_named_parameters>
Limit_interpolation_report
prescribe_limit_data(PolygonMesh& mesh, const Scheme& scheme, const PrescribedPoints& points,
                     const PrescribedNormals& normals,
                     const Limit_prescription_options& options = Limit_prescription_options(),
                     const NamedParameters& np = parameters::default_values())
{
  internal::check_interpolation_arguments<PolygonMesh, Scheme, NamedParameters>();
  internal::check_tolerance(options.tolerance);
  using Parameters = internal::Surface_parameters<PolygonMesh, NamedParameters>;
  using FT = typename Parameters::FT;
  const auto point_map = Parameters::point_map(mesh, np);
  Limit_interpolation_report report;
  internal::with_mesh_access(mesh, [&](auto& access) {
    const Level_connectivity level = internal::checked_level(access);
    internal::Interpolation_data<3> data =
      internal::read_interpolation_data<FT>(access, scheme, level, mesh, np);
    const auto prescribed = internal::read_prescribed(access, level, points, normals);
    data.tolerance = options.tolerance * internal::box_size(data.points);
    data.max_depth = (std::max)(1u, options.max_depth);
    internal::Mesh_limit_functionals<Scheme> source(scheme, level,
                                                    internal::For_chunks::with(Concurrency_tag()));
    internal::Prescription prescription(level, data, source, prescribed);
    if (const auto v = prescription.vertex_without_tangents())
      throw std::invalid_argument(
        "PN_subdivision_3: a normal is prescribed at " + access.vertex_name(*v) +
        ", where the scheme tells of no tangent plane: prescribe none there");
    const auto result = prescription(options.rings);
    report = result.report;
    internal::write_control_net<FT>(access, point_map, internal::No_normal_map(), data.points,
                                    result.points, data.normals, data.normals);
  });
  return report;
}

} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_PRESCRIBE_LIMIT_DATA_H

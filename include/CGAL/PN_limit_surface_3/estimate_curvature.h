// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_ESTIMATE_CURVATURE_H
#define CGAL_PN_LIMIT_SURFACE_3_ESTIMATE_CURVATURE_H

#include <CGAL/PN_subdivision_3/internal/needs_eigen.h>

#include <CGAL/PN_limit_surface_3/internal/curvature/Curvature_estimation.h>
#include <CGAL/PN_subdivision_3/internal/normals/estimate_normals.h>
#include <CGAL/PN_subdivision_3/subdivide.h>

#include <boost/property_map/property_map.hpp>
#include <boost/property_map/transform_value_property_map.hpp>

#include <algorithm>
#include <type_traits>
#include <vector>

namespace CGAL::PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Functions

The curvatures of a surface at a vertex.

A curvature is positive where the surface bends away from its normal: a sphere of radius R with
outward normals has the principal curvatures 1/R. Reversing the normals (or the orientation of the
faces, if they give the normals) changes the signs of the mean curvature and of the principal
curvatures, and exchanges the latter; the Gaussian curvature stays.

\tparam GeomTraits a model of `Kernel`
*/
template <class GeomTraits>
struct Vertex_curvature
{
  /// the product of the principal curvatures.
  double gaussian = 0;
  /// the mean of the principal curvatures.
  double mean = 0;
  /// \name Principal curvatures
  /// @{

  /// the smaller one.
  double minimal = 0;
  /// the larger one.
  double maximal = 0;
  /// @}
  /// \name Principal directions
  /// Unit vectors with an arbitrary sign; where both principal curvatures are equal, any pair of
  /// orthogonal ones. Their cross product, minimal times maximal, is the normal of the surface.
  /// @{

  /// that of `minimal`.
  typename GeomTraits::Vector_3 minimal_direction{0, 0, 0};
  /// that of `maximal`.
  typename GeomTraits::Vector_3 maximal_direction{0, 0, 0};
  /// @}
  /// whether there were enough neighbors to tell the curvatures from; otherwise everything is zero.
  bool is_estimated = false;
};

namespace internal {

template <class Value>
Value to_vertex_curvature(const Principal_curvatures& c)
{
  Value v;
  using Vector = std::decay_t<decltype(v.minimal_direction)>;
  const auto vector = [](const Eigen::Vector3d& d) { return Vector(d[0], d[1], d[2]); };
  v.gaussian = c.gaussian;
  v.mean = c.mean;
  v.minimal = c.minimal;
  v.maximal = c.maximal;
  v.minimal_direction = vector(c.minimal_direction);
  v.maximal_direction = vector(c.maximal_direction);
  v.is_estimated = c.is_estimated;
  return v;
}

template <class FT, class Access, class Point_map, class Normal_map>
Curvature_data curvature_data(const Access& access, Point_map points, Normal_map normals)
{
  using Index = Level_connectivity::Index;
  using Vector = Coordinates<double, 3>;
  const auto vector = [](const Vector& c) { return Eigen::Vector3d(c[0], c[1], c[2]); };
  Curvature_data data;
  data.level = checked_level(access);
  const Index n = data.level.number_of_vertices();
  std::vector<Point_normal<double, 3>> values(n);
  for (Index v = 0; v < n; ++v) values[v].point = to_double_3(checked_point<FT>(access, points, v));
  estimate_normals_of<double>(data.level, Control_normal_estimate::angle, values);
  data.vertices.reserve(n);
  for (const auto& value : values)
    data.vertices.push_back({vector(value.point), vector(value.normal)});
  if constexpr (is_there_v<Normal_map>) {
    data.fits_normals = true;
    data.face_normals.resize(n);
    for (Index v = 0; v < n; ++v) {
      data.face_normals[v] = data.vertices[v].normal;
      const Coordinates<FT, 3> m = coordinates_3<FT>(get(normals, access.vertex(v)));
      check_finite<FT, 3>(m, "normal", [&] { return access.vertex_name(v); });
      Vector unit = to_double_3(m);
      normalize_control_normal<double, 3>(unit);
      data.vertices[v].normal = vector(unit);
    }
  }
  return data;
}

} // namespace internal

/*!
\ingroup PkgPNSubdivision3Functions

estimates the curvatures of the surface that a mesh samples, at each vertex. It takes the normals around the vertex,
or fits a cubic to the vertices (Cazals and Pouget, <em>Estimating differential quantities using polynomial fitting of
osculating jets</em>, 2005). \cgal 6's `interpolated_corrected_curvatures()` measures the mesh with its normals. A fit
of points needs none, and has the order below.

<b>The fit.</b> The surface is a graph over the plane normal to the vertex normal, a cubic polynomial
through the vertex. It is fitted by weighted least squares to rings of vertices around it, where a
ring has the vertices that share a face with the ring before it. As many rings are taken as determine
the cubic: two in the interior and more at most border vertices. If no number of rings does (up to 4 are tried), a
quadric is fitted. Vertices whose normals form an angle of 90 degrees or more with that of the vertex are left out.
The vertex normals of the planes are those of `estimate_control_normals()` with `Control_normal_estimate::angle`.

<b>With normals.</b> An edge e between vertices i and j whose normals are n<sub>i</sub> and n<sub>j</sub> tells the
normal curvature -(3n<sub>i</sub> + n<sub>j</sub>)&middot;e/|e|<sup>2</sup> of i in its direction. This is the change
of the normals, (n<sub>j</sub> - n<sub>i</sub>)&middot;e/|e|<sup>2</sup>, without its part of fourth order,
2(n<sub>i</sub> + n<sub>j</sub>)&middot;e/|e|<sup>2</sup>. Its direction is that of e without its part along
n<sub>i</sub> + n<sub>j</sub>, turned into the tangent plane. The shape operator and its derivatives are fitted to the
edges and diagonals at i, mostly of one ring. It takes the normals for those of the surface. *Control normals of a
point-normal surface are not the normals of the surface*, nor do they in general become so under refinement: give the
map the normals of `subdivide_to_limit()` there, or leave it out.

<b>Accuracy.</b> On points sampled from a smooth surface by a mesh with edges of length h and faces of bounded shape,
curvatures have errors of order h<sup>2</sup>, at extraordinary and at border vertices too. If only a quadric is
determined, the order is h. On a plane all curvatures are 0, and with exact normals those of spheres and circular
cylinders are exact, up to rounding, whatever the triangles. Close to a vertex where the surface is not smooth, as it
is at the extraordinary vertices of most schemes, an estimate is a mean over the rings, and need not converge.

<b>Without a result.</b> `Vertex_curvature::is_estimated` is `false` for a vertex without faces or without a vertex
normal (all its faces have no area, say). It is `false` if too few vertices surround the vertex, or vertices on two
lines, as in a strip of triangles, and if a curvature is out of the range of `double`.

Coordinates are rounded to `double`, and the fit computes in `double`, whatever the number type. This
header is not part of `CGAL/PN_subdivision_3.h`, since it needs \ref thirdpartyEigen "Eigen".

\tparam Concurrency_tag `Sequential_tag`, `Parallel_tag` (which needs TBB) or
  `Parallel_if_available_tag`. The result is the same, bit for bit; maps are read and written by one
  thread.
\tparam PolygonMesh a model of `FaceListGraph`
\tparam CurvatureMap a model of `WritablePropertyMap` with
  `boost::graph_traits<PolygonMesh>::%vertex_descriptor` as key type and `Vertex_curvature` as value
  type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param mesh an oriented 2-manifold with border
\param curvatures the map to write
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
  below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `mesh`}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                          `boost::graph_traits<PolygonMesh>::%vertex_descriptor` as key type and
                          `geom_traits::Point_3` as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_normal_map}
    \cgalParamDescription{a property map with the normals of the surface, of any length. A zero
                          vector means "no normal here": of such a vertex the point counts; its own
                          curvatures are those of the points around it.}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                          `boost::graph_traits<PolygonMesh>::%vertex_descriptor` as key type and
                          `geom_traits::Vector_3` as value type}
    \cgalParamDefault{none: the fit uses points only}
  \cgalParamNEnd
  \cgalParamNBegin{geom_traits}
    \cgalParamDescription{an instance of a geometric traits class}
    \cgalParamType{a class model of `Kernel`}
    \cgalParamDefault{a \cgal Kernel deduced from the point type, using `CGAL::Kernel_traits`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\throws std::invalid_argument if the mesh is not an oriented 2-manifold with border, or if a point or
  normal is not finite; nothing has been written then. The message names the element.
<br><b>Cost:</b> linear in the size of the mesh, while the degrees of the faces and the valences are bounded

Functions that take a number for each vertex get one by
`boost::make_transform_value_property_map<double>([](const auto& c) { return c.mean; }, curvatures)`.
*/
template <class Concurrency_tag = Sequential_tag, class PolygonMesh, class CurvatureMap,
          class NamedParameters = parameters::Default_named_parameters>
void estimate_curvature(const PolygonMesh& mesh, CurvatureMap curvatures,
                        const NamedParameters& np = parameters::default_values())
{
  internal::check_are_read<NamedParameters>();
  using Parameters = internal::Surface_parameters<PolygonMesh, NamedParameters>;
  using Value = typename boost::property_traits<CurvatureMap>::value_type;
  using Index = Level_connectivity::Index;
  const auto points = Parameters::const_point_map(mesh, np);
  const auto for_chunks = internal::For_chunks::with(Concurrency_tag());
  internal::with_mesh_access(mesh, [&](const auto& access) {
    const internal::Curvature_data data =
      internal::curvature_data<typename Parameters::FT>(access, points, Parameters::normal_map(np));
    const std::vector<Index> order = internal::order_by_faces(data.level);
    // from here on nothing is refused: what is written need not wait for the rest
    const Index n = data.level.number_of_vertices();
    constexpr Index some = 1 << 15;
    std::vector<internal::Principal_curvatures> results((std::min)(n, some));
    for (Index first = 0, number; first < n; first += number) {
      number = (std::min)(n - first, some);
      for_chunks(number, [&](Index begin, Index end) {
        internal::Curvature_estimation estimate(data);
        for (Index i = begin; i < end; ++i) results[i] = estimate(order[first + i]);
      });
      for (Index i = 0; i < number; ++i)
        put(curvatures, access.vertex(order[first + i]),
            internal::to_vertex_curvature<Value>(results[i]));
    }
  });
}

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_LIMIT_SURFACE_3_ESTIMATE_CURVATURE_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_FITTING_3_PRESCRIBE_LIMIT_DATA_H
#define CGAL_PN_FITTING_3_PRESCRIBE_LIMIT_DATA_H

#include <CGAL/PN_subdivision_3/internal/needs_eigen.h>

#include <CGAL/PN_fitting_3/internal/Interpolation_data.h>
#include <CGAL/PN_fitting_3/internal/interpolate_mesh.h>
#include <CGAL/PN_fitting_3/interpolate_limit_points.h>
#include <CGAL/PN_fitting_3/interpolation/Limit_interpolation.h>
#include <CGAL/PN_subdivision_3/internal/schemes/on_host.h>

#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3 {

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
  if constexpr (is_there_v<Map>) {
    const auto vertex = access.vertex(v);
    const auto& value = get(map, vertex);
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
                const Prescribed_points& points, const Prescribed_normals& normals, int exponent)
{
  std::vector<Prescribed_vertex> all;
  for (Level_connectivity::Index v = 0; v < level.number_of_vertices(); ++v) {
    Prescribed_vertex p;
    p.vertex = v;
    p.point = prescribed_at(access, points, v, "limit point");
    p.normal = prescribed_at(access, normals, v, "normal");
    if (p.point)
      for (double& x : *p.point) x = std::ldexp(x, -exponent);
    if (p.normal) p.normal = prescribed_unit(*p.normal, [&] { return access.vertex_name(v); });
    if (p.point || p.normal) all.push_back(p);
  }
  return all;
}

template <class Access, class Curvatures>
std::vector<Prescribed_form> read_prescribed_forms(const Access& access,
                                                   const Level_connectivity& level,
                                                   const Curvatures& curvatures, int exponent)
{
  std::vector<Prescribed_form> all;
  for (Level_connectivity::Index v = 0; v < level.number_of_vertices(); ++v) {
    const auto vertex = access.vertex(v);
    if (const auto& value = get(curvatures, vertex)) {
      const auto& d = value->direction;
      Prescribed_form f;
      f.vertex = v;
      f.along = std::ldexp(value->along, exponent);
      f.across = std::ldexp(value->across, exponent);
      if (f.along != f.across)
        f.direction = {close_double(d.x()), close_double(d.y()), close_double(d.z())};
      if (!std::isfinite(f.along) || !std::isfinite(f.across) || !f.direction.allFinite())
        throw std::invalid_argument("PN_subdivision_3: the curvature that is prescribed at " +
                                    access.vertex_name(v) +
                                    " is not finite: give it finite numbers");
      all.push_back(f);
    }
  }
  return all;
}

template <class PolygonMesh, class Scheme, class NamedParameters>
constexpr void check_prescribed_curvatures()
{
  using Normal_map = typename Surface_parameters<PolygonMesh, NamedParameters>::Normal_map;
  constexpr bool has_curvatures = is_given_v<prescribed_curvature_map_t, NamedParameters>;
  static_assert(!has_curvatures || !Is_linear<Scheme>::value,
                "PN_subdivision_3: curvature is prescribed by the control normals too, and linear "
                "schemes have none");
  static_assert(!has_curvatures || is_there_v<Normal_map>,
                "PN_subdivision_3: prescribed curvatures change the control normals: give a "
                "vertex_normal_map that takes them");
}

// Reads a mesh and what is prescribed, and writes the control points, and normals if there are curvatures.
template <class Access, class Mesh, class Scheme, class NamedParameters>
Limit_interpolation prescribe_on(const Access& access, Mesh& mesh, const Scheme& scheme,
                                 const NamedParameters& np, const Interpolation_options& options,
                                 const For_chunks& for_chunks)
{
  using Parameters = Surface_parameters<Mesh, NamedParameters>;
  using FT = typename Parameters::FT;
  constexpr Not_given nothing;
  constexpr bool has_curvatures = is_given_v<prescribed_curvature_map_t, NamedParameters>;
  const Level_connectivity level = checked_level(access);
  Interpolation_data<3> data =
    read_interpolation_data<FT>(access, scheme, level, mesh, np, Parameters::normal_map(np));
  set_demand(options, data);
  data.max_steps = (std::numeric_limits<unsigned>::max)();
  auto prescribed =
    read_prescribed(access, level, parameter_or<prescribed_point_map_t>(np, nothing),
                    parameter_or<prescribed_normal_map_t>(np, nothing), data.exponent);
  std::vector<Prescribed_form> forms;
  if constexpr (has_curvatures)
    forms = read_prescribed_forms(
      access, level, parameter_or<prescribed_curvature_map_t>(np, nothing), data.exponent);
  auto result =
    prescribe(fitted_surface(scheme, level, for_chunks), options, data, std::move(prescribed),
              forms, [&](Level_connectivity::Index v) { return access.vertex_name(v); });
  multiply_by_size<FT>(data, result);
  write_control_net<FT, has_curvatures>(access, Parameters::point_map(mesh, np),
                                        Parameters::normal_map(np), data.points, data.normals,
                                        result);
  return result.report;
}

} // namespace internal

/*!
\ingroup PkgPNSubdivision3Interpolation

changes the control points of a mesh so that the limit surface has prescribed points and unit normals at
some vertices, and curvatures.

<b>Points and normals.</b> Control normals stay. Both kinds of conditions are linear in the control points, so that
there is nothing to iterate: one system with the conditions and the smoothest change of the net is solved,

  minimize &sum; |U &delta;<sub>v</sub>|<sup>2</sup> + 10<sup>-6</sup> |&delta;<sub>v</sub>|<sup>2</sup>

with the umbrella Laplacian U, over the vertices within `parameters::rings()` rings of faces about those with
prescribed data; all others stay. If conditions contradict each other, or are more than there are control points to
move, the least-squares solution results, and the report says how far it is off. With all points and all normals
prescribed, subdivide once before, and prescribe at the old vertices.

Normals can be prescribed where the scheme has a tangent plane, see `limit_points()`: at interior
vertices, and on the border at valence 3 (Catmull-Clark) or 3 to 6 (Loop). Two patches that prescribe the
same points and normals along a common border meet with common tangent planes at its vertices.

<b>Curvatures.</b> The quadratic form that the surface lacks at a vertex is added to the control points and the
control normals of its 1-ring together. This keeps the limit point and the tangent plane up to terms of higher order,
which the system above restores. Both steps are repeated while the curvature comes closer: by a factor of a thousand a
step if the surface is smooth against its edges, of 3 to 10 on coarse nets. If a curvature but no point or no normal
is prescribed, limit point and normal stay. Curvature can be prescribed where the scheme has it as a limit: at regular
vertices, and at extraordinary ones with the modified schemes. The faces about the vertex have to be those that the
scheme makes, and the rules of the scheme have to be settled there. With the modified schemes no other extraordinary
vertex may be next to it. No two of these vertices may have a vertex of their faces in common. Subdivide the mesh first if
one of these conditions fails.

Computed in `double`, whatever the number type.

\param mesh an oriented 2-manifold with border; its points are changed
\param scheme as for `interpolate_limit_points()`; no linear one for curvatures
\param np as for `interpolate_limit_points()`. Without curvatures the `vertex_normal_map` is read only, and
  without it control normals are estimated from the given points; curvatures need it, and write the
  control normals of the 1-rings. In `CGAL::PN_subdivision_3::parameters` `prescribed_point_map`,
  `prescribed_normal_map` and `prescribed_curvature_map` have the data; `tolerance`, `max_depth`, `rings`,
  `curvature_tolerance` and `max_curvature_steps` control the method

\returns what was reached: `residual` for the points, `normal_residual` for the normals, `curvature_residual` and
  `curvature_steps` for the curvatures. The control net is never further from what is prescribed than it was; with
  curvatures, points and normals may miss it by up to four times their tolerances.

\throws std::invalid_argument as `interpolate_limit_points()` does, with the mesh unchanged, and with the name of the
  vertex if
  - prescribed data are not finite;
  - a normal is prescribed at a vertex without a tangent plane of the scheme;
  - a curvature is prescribed at a vertex that cannot have it, see above, or whose control normals on the 1-ring are
    zero or more than 60 degrees from their limit;
  - the direction of a curvature is zero or that of the normal
<br><b>Cost:</b> That of a sparse factorization over the control points that may move, in every step. A vertex of
  valence n alone fills n<sup>2</sup> of its entries
*/
template <class Concurrency_tag = Sequential_tag, class PolygonMesh, class Scheme,
          class NamedParameters = parameters::Default_named_parameters>
Limit_interpolation prescribe_limit_data(PolygonMesh& mesh, const Scheme& scheme,
                                         const NamedParameters& np = parameters::default_values())
{
  internal::check_are_read<NamedParameters, internal::Read_of_control_mesh,
                           internal::prescribed_point_map_t, internal::prescribed_normal_map_t,
                           internal::prescribed_curvature_map_t, internal::tolerance_t,
                           internal::max_depth_t, internal::rings_t,
                           internal::curvature_tolerance_t, internal::max_curvature_steps_t>();
  if constexpr (internal::is_open_v<Scheme, NamedParameters>)
    return internal::with_scheme_of_call<Limit_interpolation,
                                         internal::Surface_call<PolygonMesh, NamedParameters>,
                                         internal::Hosts::of_interpolation>(
      scheme, np, [&](const auto& s, const auto& others) {
        return prescribe_limit_data<Concurrency_tag>(mesh, s, others);
      });
  else {
    internal::check_interpolation_arguments<Scheme>();
    const internal::Interpolation_options options = internal::interpolation_options(np);
    internal::check_tolerance(options.tolerance);
    internal::check_tolerance(options.curvature_tolerance);
    internal::check_prescribed_curvatures<PolygonMesh, Scheme, NamedParameters>();
    return internal::with_mesh_access(mesh, [&](const auto& access) {
      return internal::prescribe_on(access, mesh, scheme, np, options,
                                    internal::For_chunks::with(Concurrency_tag()));
    });
  }
}

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_FITTING_3_PRESCRIBE_LIMIT_DATA_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_FITTING_3_INTERNAL_INTERPOLATE_MESH_H
#define CGAL_PN_FITTING_3_INTERNAL_INTERPOLATE_MESH_H

#include <CGAL/PN_fitting_3/internal/Interpolation_data.h>
#include <CGAL/PN_fitting_3/internal/Limit_functionals.h>
#include <CGAL/PN_fitting_3/internal/Mesh_limit_functionals.h>
#include <CGAL/PN_fitting_3/internal/Ring_limit_functionals.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Limit_options.h>
#include <CGAL/PN_subdivision_3/hosts/Sqrt3_host.h>
#include <CGAL/PN_subdivision_3/internal/calls/concept_checks.h>
#include <CGAL/PN_subdivision_3/internal/meshes/Undoable_map.h>
#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#include <CGAL/number_utils.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

template <class Access, class Map>
using Undoable_vertices = Undoable_map<Access, Map, Vertex_of_mesh>;

template <class FT>
Coordinates<FT, 3> coordinates_of(const Eigen_vector<3>& x)
{
  return {FT(x[0]), FT(x[1]), FT(x[2])};
}

template <class FT, class Undoable>
void put_changed(Undoable& map, const Vectors<3>& old, const Vectors<3>& now)
{
  for (std::size_t v = 0; v < now.size(); ++v)
    if (now[v] != old[v])
      map.change_vector(static_cast<Level_connectivity::Index>(v), coordinates_of<FT>(now[v]));
}

// Writes the control net in place of the data; points and normals that are the same stay untouched.
template <class FT, class Access, class Point_map, class Normal_map>
void write_control_net(const Access& access, Point_map points, [[maybe_unused]] Normal_map normals,
                       const Vectors<3>& old_points, const Vectors<3>& new_points,
                       [[maybe_unused]] const Vectors<3>& old_normals,
                       [[maybe_unused]] const Vectors<3>& new_normals)
{
  Undoable_vertices<Access, Point_map> new_point(access, points);
  put_changed<FT>(new_point, old_points, new_points);
  if constexpr (!std::is_same_v<Normal_map, No_normal_map>) {
    Undoable_vertices<Access, Normal_map> new_normal(access, normals);
    put_changed<FT>(new_normal, old_normals, new_normals);
    new_normal.keep();
  }
  new_point.keep();
}

template <class PolygonMesh, class Scheme, class NamedParameters>
constexpr void check_interpolation_arguments()
{
  static_assert(check_no_grid_rows<Scheme>());
  static_assert(
    Scheme::Host::keeps_vertices && !std::is_same_v<typename Scheme::Host, Sqrt3_host>,
    "PN_subdivision_3: interpolation is not known for this scheme: take Catmull-Clark or "
    "Loop, or their modified forms");
  static_assert(is_chosen_at_run_time<Scheme>() || !Has_curvature_transfer<Scheme>::value,
                "PN_subdivision_3: interpolation is not known for schemes that transfer curvature, "
                "whose normals depend on the points: take their modified forms");
}

template <class Options>
void check_interpolation_options(const Options& options)
{
  check_tolerance(options.tolerance);
  if (options.mode == Limit_interpolation::Mode::slide &&
      options.free == Limit_interpolation::Free::smooth)
    throw std::invalid_argument(
      "PN_subdivision_3: control points slide where they are interpolated "
      "only: take Limit_interpolation::Free::fixed, or "
      "Limit_interpolation::Mode::strict");
}

// The roundness that is given, of vertices of a mesh; nothing where none is.
template <class FT, class Parameters, class Access, class NamedParameters>
std::vector<double> read_roundness_of_vertices(const Access& access, std::size_t n,
                                               const NamedParameters& np)
{
  const Given_roundness<FT> given = read_roundness<FT, Parameters>(access, np);
  if (given.of_all) return std::vector<double>(n, CGAL::to_double(*given.of_all));
  std::vector<double> roundness;
  for (const FT& w : given.of_vertices) roundness.push_back(CGAL::to_double(w));
  return roundness;
}

// replaces the normals of the data, which are first estimates, by those of the surface that slides along them
template <int dimension>
void find_natural_normals(Interpolation_data<dimension>& data, Limit_source<dimension, 2>& source);

// puts the natural normals that are found from those of the data
template <class FT, class Scheme, class New_normals>
void put_natural_normals(const Scheme& scheme, const Level_connectivity& level,
                         const For_chunks& for_chunks, Interpolation_data<3> data,
                         New_normals& new_normals)
{
  const Level_connectivity::Index n = level.number_of_vertices();
  for (Level_connectivity::Index v = 0; v < n; ++v)
    if (!data.normals[v].isZero(0)) data.vertices.push_back(v);
  data.tolerance = 1e-9 * box_size(data.points);
  const Rules_of<Scheme>& rules = rules_of(scheme);
  Mesh_limit_functionals<Rules_of<Scheme>> source(rules, level, for_chunks);
  find_natural_normals(data, source);
  for (Level_connectivity::Index v = 0; v < n; ++v)
    new_normals.change_vector(v, coordinates_of<FT>(data.normals[v]));
}

// Points, normals and roundness of a mesh, and what is around the vertices; refuses what is sharp.
template <class FT, class Access, class Scheme, class Mesh, class NamedParameters, class Normal_map>
Interpolation_data<3> read_interpolation_data(const Access& access, const Scheme& scheme,
                                              const Level_connectivity& level, const Mesh& mesh,
                                              const NamedParameters& np, Normal_map normals)
{
  using Parameters = Surface_parameters<Mesh, NamedParameters>;
  check_scheme(scheme, level, access);
  if (!limit_neighborhood(scheme).has_tangent_planes)
    throw std::invalid_argument("PN_subdivision_3: surfaces of " + name_in_message(scheme) +
                                " pass through the control points as they are, and have no "
                                "tangent planes there: nothing is left to interpolate");
  refuse_sharp_elements(scheme, access, level, Parameters::edge_constraint_map(np),
                        Parameters::vertex_constraint_map(np), [](const std::string& element) {
                          throw std::invalid_argument(
                            "PN_subdivision_3: " + element +
                            " is sharp, but interpolation is for surfaces without creases: make "
                            "all edges and vertices smooth");
                        });
  Interpolation_data<3> data = read_points_and_normals<FT>(
    access, scheme, level, Parameters::const_point_map(mesh, np), normals);
  data.takes_normals = is_pn_v<Scheme>;
  data.roundness =
    read_roundness_of_vertices<FT, Parameters>(access, level.number_of_vertices(), np);
  set_surroundings(level, data);
  return data;
}

// The control net of data that have been read: their normals are control normals, or are found.
template <class Options>
Interpolation_result<3> interpolate_strictly(const Level_connectivity& level,
                                             const Options& options, Interpolation_data<3>& data,
                                             Surface_limits& source);

// with normals that are estimated of the control points, again in each step
template <int dimension>
Interpolation_result<dimension>
interpolate_estimated(const Level_connectivity& level, Control_normal_estimate estimate,
                      Interpolation_data<dimension>& data, Limit_source<dimension, 2>& source);

template <int dimension>
Interpolation_result<dimension>
slide_along_normals(const Level_connectivity& level, Control_normal_estimate estimate,
                    Interpolation_data<dimension>& data, Limit_source<dimension, 2>& source,
                    typename Limit_source<dimension, 2>::Farthest farthest);

// The control net for limit points, normals and curvatures. Without curvatures control normals stay.
template <int dimension, class Options>
Interpolation_result<dimension>
prescribe(const Level_connectivity& level, const Options& options,
          const Interpolation_data<dimension>& data, Limit_source<dimension, 2>& source,
          std::vector<Prescribed_vertex> prescribed, const std::vector<Prescribed_form>& forms,
          Function_ref<std::string(Level_connectivity::Index)> names);

// on a surface with creases
template <int dimension>
Interpolation_result<dimension>
interpolate_creased(const Interpolation_data<dimension>& data,
                    Function_ref<void(Vectors<dimension>&, double, Limit_interpolation*)> limits);

// of a polygon
template <int dimension, class Options>
Interpolation_result<dimension> interpolate_polygon(bool is_closed, const Options& options,
                                                    Interpolation_data<dimension>& data);

} // namespace CGAL::PN_subdivision_3::internal

// The library CGAL::PN_subdivision_3_fitting has it (src/PN_subdivision_3_fitting).
#ifndef CGAL_PN_SUBDIVISION_3_FITTING
#  include <CGAL/PN_fitting_3/internal/find_control_net.h>
#endif

#endif // CGAL_PN_FITTING_3_INTERNAL_INTERPOLATE_MESH_H

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
#include <CGAL/PN_fitting_3/interpolation/Limit_interpolation.h>
#include <CGAL/PN_subdivision_3/hosts/Sqrt3_host.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/meshes/Mesh_values.h>
#include <CGAL/PN_subdivision_3/internal/meshes/Undoable_map.h>
#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
#include <CGAL/PN_subdivision_3/internal/meshes/read_mesh.h>
#include <CGAL/PN_subdivision_3/internal/meshes/slot_normals.h>
#include <CGAL/PN_subdivision_3/internal/rounds/Round.h>
#include <CGAL/PN_subdivision_3/internal/schemes/scheme_of_call.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/number_utils.h>
#ifdef CGAL_PN_SUBDIVISION_3_FITTING
#  include <CGAL/PN_subdivision_3/internal/meshes/compiled_levels.h>
#endif

#include <Eigen/Core>

#include <array>
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
template <class FT, bool has_new_normals, class Access, class Point_map, class Normal_map>
void write_control_net(const Access& access, Point_map points, [[maybe_unused]] Normal_map normals,
                       const Vectors<3>& old_points, [[maybe_unused]] const Vectors<3>& old_normals,
                       const Interpolation_result<3>& result)
{
  Undoable_vertices<Access, Point_map> new_point(access, points);
  put_changed<FT>(new_point, old_points, result.points);
  if constexpr (has_new_normals && is_there_v<Normal_map>) {
    Undoable_vertices<Access, Normal_map> new_normal(access, normals);
    put_changed<FT>(new_normal, old_normals, result.normals);
    new_normal.commit();
  }
  new_point.commit();
}

// points and normals in double
template <class FT>
Interpolation_data<3> data_in_double(const std::vector<Point_normal<FT, 3>>& values)
{
  Interpolation_data<3> data;
  for (const auto& value : values) {
    data.points.push_back(to_eigen<3>(to_double_3(value.point)));
    data.normals.push_back(to_eigen<3>(to_double_3(value.normal)));
  }
  divide_by_size(data);
  return data;
}

// Points and normals of a mesh in double. Without a map the normals are estimated.
template <class FT, class Scheme, class Access, class Point_map, class Normal_map>
Interpolation_data<3> read_points_and_normals(const Access& access, const Scheme& scheme,
                                              const Level_connectivity& level, Point_map points,
                                              Normal_map normals)
{
  return data_in_double<FT>(
    read_values<PN_average<FT, 3>>(access, level, points, normals, normal_estimate(scheme)));
}

template <class Scheme>
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

// Points, normals and roundness of a mesh; refuses what is sharp.
template <class FT, class Access, class Scheme, class Mesh, class NamedParameters, class Normal_map>
Interpolation_data<3> read_interpolation_data(const Access& access, const Scheme& scheme,
                                              const Level_connectivity& level, const Mesh& mesh,
                                              const NamedParameters& np, Normal_map normals)
{
  using Parameters = Surface_parameters<Mesh, NamedParameters>;
  check_scheme(scheme, level, access);
  if (!facts_of(scheme).limit_neighborhood.has_tangent_planes)
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
  return data;
}

// A surface whose control net is sought, with the scheme that scheme_of_fitting() makes.
template <class Scheme>
struct Fitted_surface
{
  Scheme scheme;
  const Level_connectivity& level;
  For_chunks for_chunks;
};

// a program that is linked to the library CGAL::PN_subdivision_3_fitting has this macro
#ifdef CGAL_PN_SUBDIVISION_3_FITTING
constexpr bool is_linked_to_fitting = true;
#else
constexpr bool is_linked_to_fitting = false;
#endif

template <class Scheme>
auto on_host_in_double(const Scheme& scheme)
{
  if constexpr (Is_said_by_call<Scheme>::value)
    return on_host_in_double(scheme.scheme);
  else
    return Scheme_on_host<typename Scheme::Host, double>(scheme);
}
template <class Scheme>
auto on_host_in_double(const Linear_scheme<Scheme>& scheme)
{
  return on_host_in_double(scheme.scheme);
}

// A scheme as the library has it, in the company of which a program may also have the headers alone.
template <bool is_linked = is_linked_to_fitting, class Scheme>
auto scheme_of_fitting(const Scheme& scheme)
{
  if constexpr (!is_linked)
    return scheme_of_rounds<false>(scheme);
  else if constexpr (Is_linear<Scheme>::value)
    return linear(on_host_in_double(scheme));
  else
    return on_host_in_double(scheme);
}

template <bool is_linked = is_linked_to_fitting, class Scheme>
auto fitted_surface(const Scheme& scheme, const Level_connectivity& level,
                    const For_chunks& for_chunks)
{
  const auto rules = scheme_of_fitting<is_linked>(scheme);
  return Fitted_surface<std::decay_t<decltype(rules)>>{rules, level, for_chunks};
}
// the same for slots of creases, which have a roundness
template <bool is_linked = is_linked_to_fitting, class Scheme>
auto fitted_creases(const Scheme& scheme, const Level_connectivity& level,
                    const For_chunks& for_chunks)
{
  if constexpr (is_pn_v<Scheme>) {
    const auto rules = scheme_of_fitting<is_linked>(scheme);
    using Rounded = With_roundness<std::decay_t<decltype(rules)>, double, true, is_linked>;
    return Fitted_surface<Rounded>{Rounded{{rules}}, level, for_chunks};
  } else
    return fitted_surface<is_linked>(scheme, level, for_chunks);
}

// The control net of data that have been read: their normals are control normals, or are found. If it estimates normals, they are
// estimated of the control points, again in each step.
template <bool estimates_normals, bool may_be_strict, class Scheme>
Interpolation_result<3>
find_control_net(const Fitted_surface<Scheme>& surface, const Interpolation_options& options,
                 Control_normal_estimate estimate, Interpolation_data<3>& data);

// replaces the normals of the data, which are first estimates, by those of the surface that slides along them
template <class Scheme>
void find_natural_normals(const Fitted_surface<Scheme>& surface, Interpolation_data<3>& data);

// The control net for limit points, normals and curvatures. Without curvatures control normals stay.
template <class Scheme>
Interpolation_result<3>
prescribe(const Fitted_surface<Scheme>& surface, const Interpolation_options& options,
          const Interpolation_data<3>& data, std::vector<Prescribed_vertex> prescribed,
          const std::vector<Prescribed_form>& forms,
          Function_ref<std::string(Level_connectivity::Index)> names);

template <class Scheme>
using Slot_value = typename Average_of_scheme<Scheme, double>::Value;

// Strict interpolation of a surface with creases, with the normals of the wedges and the tangents of the creases as they are. `values`
// has the values of the slots; the vertices of the data are sorted.
template <class Scheme>
Interpolation_result<3>
interpolate_creased(const Fitted_surface<Scheme>& surface, std::vector<Slot_value<Scheme>> values,
                    const Creases<double>& creases, const Interpolation_data<3>& data);

template <class FT>
Creases<double> in_double(const Creases<FT>& creases)
{
  if constexpr (std::is_same_v<FT, double>)
    return creases;
  else {
    Creases<double> result;
    for (const Crease_edge<FT>& e : creases.edges) {
      const auto& [t, u] = e.tangent_from;
      result.edges.push_back({e.edge, e.control_edge, e.sharpness, e.border_side, e.after, e.before,
                              std::array{to_double_3(t), to_double_3(u)}});
    }
    result.ends = creases.ends;
    result.stars = creases.stars;
    result.number_of_slots = creases.number_of_slots;
    result.has_fixed_border = creases.has_fixed_border;
    return result;
  }
}

template <class Scheme, class Value>
auto slots_in_double(const std::vector<Value>& values)
{
  std::vector<Slot_value<Scheme>> result(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    point_of(result[i]) = to_double_3(point_of(values[i]));
    if constexpr (is_pn_v<Scheme>) {
      result[i].normal = to_double_3(values[i].normal);
      result[i].roundness = CGAL::to_double(values[i].roundness);
    }
  }
  return result;
}

// What stays that of the data has to reach the calls that refine the result.
template <class Scheme, class FT, class Access, class Normal_map>
void require_fixed_creases([[maybe_unused]] const Access& access,
                           [[maybe_unused]] const Creases<FT>& creases, const Normal_map&)
{
  if constexpr (is_pn_v<Scheme>) {
    if (!has_crease_tangents_v<Scheme> && !creases.edges.empty())
      throw std::invalid_argument(
        "PN_subdivision_3: " + Edge_of_mesh::name(access, creases.edges.front().edge) +
        " is sharp, and the result is interpolated with the tangents of the data: take "
        "a crease_tangent_map, with which the result is refined, too");
    if constexpr (!has_corner_normals_v<Access, Normal_map>)
      for (const Crease_star& star : creases.stars)
        if (star.number_of_wedges > 1)
          throw std::invalid_argument(
            "PN_subdivision_3: " + access.vertex_name(star.vertex) +
            " has a normal on each side of its creases, which has to stay that of the data: give "
            "a vertex_normal_map of half-edges, see estimate_control_normals()");
  }
}

// the part of a call by which something is sharp, or that it has normals of wedges; empty if there is neither
template <class Scheme, class Access, class Normal_map, class Edge_map, class Vertex_map>
std::string what_is_sharp(const Scheme& scheme, const Access& access,
                          const Level_connectivity& level, const Normal_map&, Edge_map edge_map,
                          Vertex_map vertex_map)
{
  std::string what;
  refuse_sharp_elements(scheme, access, level, edge_map, vertex_map,
                        [&](const std::string& element) {
                          if (what.empty()) what = element + " is sharp";
                        });
  if (what.empty() && has_corner_normals_v<Access, Normal_map>) what = "corners have normals";
  return what;
}

inline void require_creased_options(const Interpolation_options& options,
                                    const std::string& what_is_sharp)
{
  const auto require = [&](bool is_so, const std::string& what) {
    if (!is_so)
      throw std::invalid_argument("PN_subdivision_3: " + what_is_sharp + ", but " + what +
                                  ": take Limit_interpolation::Mode::strict with given "
                                  "normals and Limit_interpolation::Free::fixed, or make all edges "
                                  "and vertices smooth");
  };
  require(options.mode == Limit_interpolation::Mode::strict,
          "control points slide on surfaces without creases only");
  require(options.normals == Limit_interpolation::Normals::given,
          "control normals are found on surfaces without creases only");
  require(options.free == Limit_interpolation::Free::fixed,
          "control points move along on surfaces without creases only");
}

// Reads a mesh with edges that are sharp forever, interpolates, and writes the control points, the normals of the wedges
// and the tangents of the creases. is_interpolated(v) tells the vertices.
template <class FT, class Access, class Scheme, class Mesh, class NamedParameters,
          class Is_interpolated>
Limit_interpolation
interpolate_with_creases(const Access& access, const Scheme& given_scheme,
                         const Level_connectivity& level, Mesh& mesh, const NamedParameters& np,
                         const Interpolation_options& options, const std::string& what_is_sharp,
                         const For_chunks& for_chunks, const Is_interpolated& is_interpolated)
{
  using Parameters = Surface_parameters<Mesh, NamedParameters>;
  const auto normals = Parameters::normal_map(np);
  const auto points = Parameters::point_map(mesh, np);
  using Normal_map = std::decay_t<decltype(normals)>;
  check_scheme(given_scheme, level, access);
  const Given_roundness<FT> roundness = read_roundness<FT, Parameters>(access, np);
  using Scheme_of_call = With_roundness<Scheme, FT>;
  const Scheme_of_call scheme{{given_scheme}, &roundness};
  const auto edge_map = Parameters::edge_constraint_map(np);
  const auto vertex_map = Parameters::vertex_constraint_map(np);
  require_crease_rules(scheme, access, normals, edge_map, vertex_map);
  Mesh_values<Scheme_of_call, FT, Access, std::decay_t<decltype(edge_map)>,
              std::decay_t<decltype(vertex_map)>, true>
    of_mesh(scheme, access, level, edge_map, vertex_map);
  Creases<FT> creases = of_mesh.creases(level);
  require_sharp_for_ever<FT>(access, creases, 0);
  require_creased_options(options, what_is_sharp);
  require_fixed_creases<Scheme>(access, creases, normals);
  of_mesh.read_tangents(creases);
  const auto values = of_mesh.values(level, points, normals, creases);

  Interpolation_data<3> data;
  const Level_connectivity::Index n = level.number_of_vertices();
  for (Level_connectivity::Index v = 0; v < n; ++v) {
    data.points.push_back(to_eigen<3>(to_double_3(point_of(values[v]))));
    if (is_interpolated(v)) data.vertices.push_back(v);
  }
  divide_by_size(data);
  set_demand(options, data);
  auto result = interpolate_creased(fitted_creases(given_scheme, level, for_chunks),
                                    slots_in_double<Scheme>(values), in_double(creases), data);
  multiply_by_size<FT>(data, result);

  Undoable_vertices<Access, std::decay_t<decltype(points)>> new_points(access, points);
  put_changed<FT>(new_points, data.points, result.points);
  using Writers = Normal_writers<Access, Normal_map>;
  typename Writers::Corner_writer corners(access, level, normals);
  if constexpr (Writers::Corner_writer::takes_corners && is_pn_v<Scheme>)
    corners.put_all(level, creases, values);
  of_mesh.put_tangents(creases, level.size());
  new_points.commit();
  corners.commit();
  of_mesh.commit();
  return result.report;
}

} // namespace CGAL::PN_subdivision_3::internal

#ifndef CGAL_PN_SUBDIVISION_3_FITTING // the library has it (src/PN_subdivision_3_fitting)
#  include <CGAL/PN_fitting_3/internal/find_control_net.h>
#endif

#endif // CGAL_PN_FITTING_3_INTERNAL_INTERPOLATE_MESH_H

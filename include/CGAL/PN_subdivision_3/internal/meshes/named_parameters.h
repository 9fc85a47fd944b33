// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_NAMED_PARAMETERS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_NAMED_PARAMETERS_H

#include <CGAL/Named_function_parameters.h>
#include <CGAL/PN_subdivision_3/internal/concepts/scheme_traits.h>
#include <CGAL/PN_subdivision_3/internal/schemes/scheme_of_call.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/parameters/Default_visitor.h>
#include <CGAL/PN_subdivision_3/parameters/Estimated_control_normals.h>
#include <CGAL/PN_subdivision_3/parameters/parameters.h>
#include <CGAL/Uncertain.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <boost/property_map/property_map.hpp>
#include <boost/type_traits/detected_or.hpp>

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL::PN_subdivision_3::internal {

template <class Map>
using Key_type_of = typename boost::property_traits<Map>::key_type;
template <class Map>
using Key_of_map = boost::detected_or_t<void, Key_type_of, Map>;

template <class T>
T& unwrapped(T& t)
{
  return t;
}
template <class T>
T& unwrapped(std::reference_wrapper<T>& t)
{
  return t.get();
}

// The roundness of the normals that a call gives: if it counts, the roundness of an estimate is a map beside the normals of
// vertices, and goes with the normals of corners.
template <bool is_beside, class Map>
auto roundness_of([[maybe_unused]] const Map& normals)
{
  if constexpr (Is_estimate<Map>::value && is_beside)
    return normals.roundness_map();
  else
    return Not_given();
}

// this package's parameters that tell of a control mesh
struct Read_of_control_mesh
  : Read_parameters<roundness_t, vertex_roundness_map_t, control_normal_estimate_t, border_t,
                    crease_tangent_map_t>
{};

// The named parameters of the surface functions.
template <class PolygonMesh, class NamedParameters>
struct Surface_parameters
{
  using Point_map = typename GetVertexPointMap<PolygonMesh, NamedParameters>::type;
  using Geom_traits = typename GetGeomTraits<PolygonMesh, NamedParameters>::type;
  using FT = typename Geom_traits::FT;
  using Given_normals = Parameter_type<internal_np::vertex_normal_map_t, NamedParameters>;
  using Roundness = Parameter_type<roundness_t, NamedParameters>;

  static constexpr bool has_roundness_of_estimate =
    Is_estimate<Given_normals>::value && !is_given_v<vertex_roundness_map_t, NamedParameters> &&
    !is_given_v<roundness_t, NamedParameters>;
  static constexpr bool are_of_corners =
    std::is_same_v<typename Is_estimate<Given_normals>::key_type,
                   typename boost::graph_traits<PolygonMesh>::halfedge_descriptor>;
  static constexpr bool go_with_roundness = has_roundness_of_estimate && are_of_corners;
  static constexpr bool are_beside_roundness = has_roundness_of_estimate && !are_of_corners;

  using Normal_map = decltype(normals_of<go_with_roundness>(std::declval<const Given_normals&>()));
  using Roundness_map = Parameter_type<vertex_roundness_map_t, NamedParameters,
                                       decltype(roundness_of<are_beside_roundness>(
                                         std::declval<const Given_normals&>()))>;

  using Edge_constraint_map = Parameter_type<internal_np::edge_is_constrained_t, NamedParameters>;
  using Vertex_constraint_map =
    Parameter_type<internal_np::vertex_is_constrained_t, NamedParameters>;

  static unsigned number_of_iterations(const NamedParameters& np)
  {
    const auto n = parameters::choose_parameter(
      parameters::get_parameter(np, internal_np::number_of_iterations), 1u);
    if constexpr (std::is_signed_v<decltype(n)>)
      if (n < 0)
        throw std::invalid_argument("PN_subdivision_3: the number of iterations is negative");
    constexpr std::uintmax_t most = (std::numeric_limits<unsigned>::max)();
    return static_cast<unsigned>((std::min)(static_cast<std::uintmax_t>(n), most));
  }
  static Point_map point_map(PolygonMesh& mesh, const NamedParameters& np)
  {
    return parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                        get_property_map(vertex_point, mesh));
  }
  static auto const_point_map(const PolygonMesh& mesh, const NamedParameters& np)
  {
    return parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                        get_const_property_map(vertex_point, mesh));
  }
  static Normal_map normal_map(const NamedParameters& np)
  {
    return normals_of<go_with_roundness>(given_normals(np));
  }
  // none where they are not used, as by a linear scheme
  template <bool are_used>
  static auto used_normal_map([[maybe_unused]] const NamedParameters& np)
  {
    if constexpr (are_used)
      return normal_map(np);
    else
      return Not_given();
  }
  static Roundness_map roundness_map(const NamedParameters& np)
  {
    return parameter_or<vertex_roundness_map_t>(
      np, roundness_of<are_beside_roundness>(given_normals(np)));
  }
  static Roundness roundness(const NamedParameters& np) { return parameter_or<roundness_t>(np); }
  static auto attributes(const NamedParameters& np) { return parameter_or<attributes_t>(np); }
  static Edge_constraint_map edge_constraint_map(const NamedParameters& np)
  {
    return parameter_or<internal_np::edge_is_constrained_t>(np);
  }
  static Vertex_constraint_map vertex_constraint_map(const NamedParameters& np)
  {
    return parameter_or<internal_np::vertex_is_constrained_t>(np);
  }
  static auto visitor(const NamedParameters& np)
  {
    return parameter_or<internal_np::visitor_t>(np, Default_visitor());
  }

private:
  static Given_normals given_normals(const NamedParameters& np)
  {
    return parameter_or<internal_np::vertex_normal_map_t>(np);
  }
};

// what an Any_scheme has to fit: the number type of a call, and whether its normals are those of corners
template <class PolygonMesh, class NamedParameters>
struct Surface_call
{
  using FT = typename GetGeomTraits<PolygonMesh, NamedParameters>::type::FT;
  static constexpr bool has_corner_normals = std::is_same_v<
    Key_of_map<typename Surface_parameters<PolygonMesh, NamedParameters>::Normal_map>,
    typename boost::graph_traits<PolygonMesh>::halfedge_descriptor>;
};

// The property map of a CGAL::Surface_mesh that has this name and type, if it has one.
// Surface_mesh::property_map() returns a pair before CGAL 6 and an optional since.
template <class Element, class Value, class Mesh>
auto find_property_map(const Mesh& mesh, const std::string& name)
{
  using Found = std::optional<typename Mesh::template Property_map<Element, Value>>;
  auto found = mesh.template property_map<Element, Value>(name);
  if constexpr (std::is_same_v<decltype(found), Found>)
    return found;
  else
    return found.second ? Found(found.first) : Found();
}

// whether edges may be sharp for a number of rounds: a map of bool has edges that are so for ever
template <class Edge_map>
constexpr bool may_be_semi_sharp()
{
  if constexpr (is_there_v<Edge_map>)
    return !std::is_same_v<std::decay_t<typename boost::property_traits<Edge_map>::value_type>,
                           bool>;
  else
    return false;
}

// Whether the roundness of a call may vary: where normals are estimated it does unless it is given as a number, sharp
// edges that end take it away, and it may be given as a map. A call of which its type says that it does not has no time
// for it.
template <class Scheme, class Parameters>
constexpr bool varies_in_roundness_v =
  is_pn_v<Scheme> &&
  ((!is_there_v<typename Parameters::Normal_map> && !is_there_v<typename Parameters::Roundness>) ||
   is_there_v<typename Parameters::Roundness_map> ||
   goes_with_roundness_v<typename Parameters::Normal_map> ||
   (Has_crease_rules<Scheme>::value &&
    may_be_semi_sharp<typename Parameters::Edge_constraint_map>()));

// Whether what a call names as sharp may end. The libraries are compiled for maps of all kinds, as are calls that name nothing.
template <class Parameters>
constexpr bool creases_may_end_in_call()
{
  using Edge_map = typename Parameters::Edge_constraint_map;
  using Vertex_map = typename Parameters::Vertex_constraint_map;
  return is_linked_to_library || (!is_there_v<Edge_map> && !is_there_v<Vertex_map>) ||
         may_be_semi_sharp<Edge_map>() || may_be_semi_sharp<Vertex_map>();
}

// Masks with negative weights take what is from 0 to 1 a little beyond, from which a further call goes on.
template <class FT, class Name>
FT checked_roundness(const FT& w, bool may_be_refined, const Name& name)
{
  const FT beyond = may_be_refined ? FT(1) / FT(2) : FT(0);
  if (CGAL::certainly(w >= -beyond) && CGAL::certainly(w <= FT(1) + beyond)) return w;
  throw std::invalid_argument("PN_subdivision_3: the roundness of " + name() + " is " +
                              std::to_string(CGAL::to_double(w)) + ": it must be from 0 to 1");
}

template <class FT, class Parameters, class Access, class NamedParameters>
Given_roundness<FT> read_roundness(const Access& access, const NamedParameters& np)
{
  Given_roundness<FT> given;
  given.is_of_estimate = Parameters::has_roundness_of_estimate;
  if constexpr (is_there_v<typename Parameters::Roundness>)
    given.of_all = checked_roundness<FT>(FT(Parameters::roundness(np)), false,
                                         [] { return std::string("all vertices"); });
  if constexpr (is_there_v<typename Parameters::Roundness_map>) {
    const auto map = Parameters::roundness_map(np);
    const auto n = static_cast<Level_connectivity::Index>(access.size().vertices);
    given.of_vertices.reserve(n);
    for (Level_connectivity::Index v = 0; v < n; ++v)
      given.of_vertices.push_back(checked_roundness<FT>(FT(get(map, access.vertex(v))), true,
                                                        [&] { return access.vertex_name(v); }));
  }
  return given;
}

// f(scheme), where the scheme has the roundness of the call
template <class Parameters, class Access, class Scheme, class NamedParameters, class Function>
decltype(auto) with_roundness_of_call([[maybe_unused]] const Access& access, const Scheme& scheme,
                                      [[maybe_unused]] const NamedParameters& np, const Function& f)
{
  using FT = typename Parameters::FT;
  if constexpr (is_pn_v<Scheme>) {
    const auto given = read_roundness<FT, Parameters>(access, np);
    return f(With_roundness<Scheme, FT, creases_may_end_in_call<Parameters>()>{
      {scheme}, &given, varies_in_roundness_v<Scheme, Parameters>});
  } else
    return f(scheme);
}

// a roundness as a map of the user's stores it
template <class T, class FT>
T roundness_as(const FT& w)
{
  if constexpr (std::is_constructible_v<T, const FT&>)
    return T(w);
  else
    return T(CGAL::to_double(w));
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_NAMED_PARAMETERS_H

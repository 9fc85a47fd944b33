// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_ON_HOST_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_ON_HOST_H

#include <CGAL/PN_subdivision_3/hosts/PQQ_host.h>
#include <CGAL/PN_subdivision_3/hosts/PTQ_host.h>
#include <CGAL/PN_subdivision_3/internal/concepts/scheme_traits.h>
#include <CGAL/PN_subdivision_3/internal/schemes/scheme_of_call.h>
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>

#include <boost/type_traits/is_detected_exact.hpp>

#include <stdexcept>
#include <string>
#include <type_traits>

namespace CGAL::PN_subdivision_3::internal {

// the Host of an Any_scheme: functions that take an Any_scheme call themselves with the scheme on its host
struct Host_at_run_time
{};

// whether a scheme is an Any_scheme, or adapts one
template <class Scheme>
using Host_of = typename Scheme::Host;
template <class Scheme>
using Is_any = boost::is_detected_exact<Host_at_run_time, Host_of, Scheme>;

template <class Scheme>
constexpr auto number_type_of_any(const Scheme* scheme)
{
  if constexpr (Is_adaptor<Scheme>::value)
    return number_type_of_any(&scheme->scheme);
  else
    return typename Scheme::Number_type();
}

template <class Scheme, class Other>
auto adapted_alike(const Linear_scheme<Scheme>&, const Other& other)
{
  return linear(other);
}
template <class Scheme, bool has_border, class Map, class Other>
auto adapted_alike(const Scheme_of_call<Scheme, has_border, Map>& adaptor, const Other& other)
{
  return Scheme_of_call<Other, has_border, Map>{
    {other}, adaptor.border, adaptor.estimate, adaptor.tangents};
}

// a call for points of a number type, without normals of corners
template <class FT_>
struct Number_call
{
  using FT = FT_;
  static constexpr bool has_corner_normals = false;
};

// calls f(s) with the scheme as s, on its host
template <class Result, class Scheme, class Function>
Result with_host(const Scheme& scheme, const Function& f)
{
  if constexpr (Is_with_normals<Scheme>::value)
    return with_host<Result>(scheme.scheme, [&](const auto& points) -> Result {
      return with_host<Result>(
        scheme.normal_scheme, [&]([[maybe_unused]] const auto& normals) -> Result {
          if (facts_of(points).transfers_curvature || facts_of(normals).transfers_curvature)
            throw std::invalid_argument("PN_subdivision_3: a scheme that transfers curvature "
                                        "refines points and normals together: it goes with no "
                                        "other scheme of normals");
          if constexpr (std::is_same_v<typename std::decay_t<decltype(points)>::Host,
                                       typename std::decay_t<decltype(normals)>::Host>)
            if constexpr (Is_on_host<std::decay_t<decltype(points)>>::value &&
                          Is_on_host<std::decay_t<decltype(normals)>>::value)
              return f(points.with_normals_of(normals));
            else // one of them is adapted
              return f(with_normal_scheme(points, normals));
          else
            throw std::invalid_argument("PN_subdivision_3: " + name_in_message(points) +
                                        " does not go with " + name_in_message(normals) +
                                        " for the normals: they split the faces differently");
        });
    });
  else if constexpr (Is_adaptor<Scheme>::value)
    return with_host<Result>(scheme.scheme,
                             [&](const auto& s) -> Result { return f(adapted_alike(scheme, s)); });
  else
    return scheme.visit([&](const auto& s) -> Result { return f(s); });
}

// whether a scheme splits edges in halves, and faces between the halves
template <class Scheme>
inline constexpr bool halves_edges_v = std::is_same_v<typename Scheme::Host, PQQ_host> ||
                                       std::is_same_v<typename Scheme::Host, PTQ_host>;

// the message on a scheme that does not split edges in halves
template <class Scheme>
std::string no_halves(const Scheme& scheme, const std::string& consequence,
                      const std::string& instead = "")
{
  return "PN_subdivision_3: " + name_in_message(scheme) + " does not split edges in halves, " +
         consequence + ": take " + instead +
         "Catmull-Clark or Loop, or another scheme that splits "
         "faces as they do";
}

// which schemes that are chosen at run time a call takes
enum class Hosts { all, of_vertex_limits, of_face_limits, of_interpolation };

// with_host() in a call. What the scheme does not support is refused at run time, since it is chosen at run time.
template <class Result, class Call, Hosts hosts, class Scheme, class Function>
Result on_host([[maybe_unused]] const Scheme& scheme, [[maybe_unused]] const Function& f)
{
  constexpr bool fits = std::is_same_v<typename Call::FT, decltype(number_type_of_any(&scheme))>;
  static_assert(fits, "PN_subdivision_3: the points have another number type than the Any_scheme: "
                      "take Any_scheme<FT> with that of their kernel");
  if constexpr (fits)
    return with_host<Result>(scheme, [&](const auto& s) -> Result {
      using Hosted = std::decay_t<decltype(s)>;
      constexpr bool is_creased = Call::has_corner_normals || has_crease_tangents_v<Hosted>;
      constexpr bool lacks_rules = is_creased && !Has_crease_rules<Hosted>::value;
      constexpr bool is_primal = Hosted::Host::keeps_vertices;
      constexpr bool lacks_limits =
        hosts == (is_primal ? Hosts::of_face_limits : Hosts::of_vertex_limits);
      constexpr bool interpolates = hosts == Hosts::of_interpolation;
      if constexpr (!lacks_rules && !lacks_limits && (!interpolates || halves_edges_v<Hosted>))
        if (!interpolates || !facts_of(s).transfers_curvature) return f(s);
      const std::string name = name_in_message(s);
      throw std::invalid_argument(
        "PN_subdivision_3: " +
        (lacks_rules
           ? name + " has no rules for creases: it takes a normal per vertex, and no tangents"
         : interpolates ? "interpolation is not known for " + name +
                            ": take Catmull-Clark or Loop, or their modified forms"
         : is_primal ? "the limit points of " + name +
                         " belong to the vertices, not to the faces: give a map of vertices"
                     : "the limit points of " + name +
                         " belong to the faces, not to the vertices: see limit_points() with a map "
                         "of faces"));
    });
  else
    return Result();
}

// whether something of a call has still to be put around its scheme, or its host to be found
template <class Scheme, class NamedParameters>
constexpr bool is_open_v = adapts_scheme_v<Scheme, NamedParameters> || Is_any<Scheme>::value;

// f(scheme, np), with the scheme as the call says, on its host, and parameters that do not say it again
template <class Result, class Call, Hosts hosts = Hosts::all, class Scheme, class NamedParameters,
          class Function>
Result with_scheme_of_call(const Scheme& scheme, const NamedParameters& np, const Function& f)
{
  if constexpr (adapts_scheme_v<Scheme, NamedParameters>)
    return with_adapted_scheme(scheme, np, [&](const auto& s, const auto& others) -> Result {
      return with_scheme_of_call<Result, Call, hosts>(s, others, f);
    });
  else if constexpr (!Is_any<Scheme>::value)
    return f(scheme, np);
  else
    return on_host<Result, Call, hosts>(scheme, [&](const auto& s) -> Result { return f(s, np); });
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_SCHEMES_ON_HOST_H

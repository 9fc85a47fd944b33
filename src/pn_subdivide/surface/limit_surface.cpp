// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/refine_surface.h"

#include "io/Error.h"

#include <CGAL/PN_limit_surface_3/limit_points.h>
#include <CGAL/PN_subdivision_3/schemes/Any_scheme.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace pn_subdivide {
namespace {

using Tag = CGAL::Parallel_if_available_tag;
using Limit_report = PN::Limit_report;
using Limit_point = PN::Limit_point<Kernel>;

// A map of limits that hands each to a function, so that none is kept that is not wanted.
class Limit_map
{
public:
  using key_type = Vertex;
  using value_type = Limit_point;
  using reference = void;
  using category = boost::writable_property_map_tag;
  using Take_limit = std::function<void(key_type, const Limit_point&)>;

  explicit Limit_map(Take_limit take)
    : take_(std::move(take))
  {}

  friend void put(const Limit_map& map, key_type v, const value_type& limit)
  {
    map.take_(v, limit);
  }

private:
  Take_limit take_;
};

template <class Options>
Limit_report limits_of(const Surface& surface, const std::optional<Normal_map>& normals,
                       const Scheme_choice& choice, const Limit_map& limits, const Options& options)
{
  if (!normals)
    return PN::limit_points<Tag>(surface, PN::linear(scheme_of(choice)), limits, options);
  const Scheme scheme = scheme_with_normals(choice);
  return with_normals_of_vertices(surface, *normals, [&](const auto& np) {
    return PN::limit_points<Tag>(surface, scheme, limits, PN::parameters::join(options, np));
  });
}

// The mesh gets the limit points and the normals that are asked for, by corners; with a linear scheme, only normals of
// the surface.
template <class S, class Options>
Limit_report move_to_limits(Surface& surface, Corner_normal_map normals, const S& scheme,
                            const Crease_maps& creases, const Options& options)
{
  return PN::internal::move_to_limit_of_call<Tag>(
    surface, scheme,
    PN::parameters::join(options, CGAL::parameters::vertex_normal_map(normals)
                                    .edge_is_constrained_map(creases.edges)
                                    .vertex_is_constrained_map(creases.vertices)));
}

template <class Options>
Limit_report move_to_limits_of(Surface& surface, const Scheme_choice& choice,
                               const Crease_maps& creases, bool surface_normals,
                               const Options& options)
{
  const bool is_linear = !normals_of(surface);
  if (is_linear) add_normals(surface);
  const Corner_normal_map normals = corner_normals_or_added(surface);
  if (!is_linear)
    return move_to_limits(surface, normals, scheme_with_normals(choice), creases,
                          options.crease_tangent_map(creases.tangents));
  const Limit_report report =
    move_to_limits(surface, normals, PN::linear(scheme_of(choice)), creases, options);
  if (!surface_normals) remove_normals(surface);
  return report;
}

// Writes over the points and the normals, whichever are asked for.
Limit_map write_limits(Surface& surface, std::optional<Normal_map> normals,
                       const Limit_choice& choice)
{
  return Limit_map([&surface, normals, &choice](Vertex v, const Limit_point& limit) {
    if (choice.points) surface.point(v) = limit.point;
    if (!normals) return;
    Normal_map written = *normals;
    written[v] = choice.normals ? limit.surface_normal : limit.control_normal;
  });
}

auto make_options(const Limit_choice& choice, unsigned levels)
{
  return PN::parameters::tolerance(choice.tolerance_or_default())
    .points(choice.points)
    .surface_normals(choice.normals)
    .rounds_done(levels);
}

bool are_limits_known(const Surface& surface, const Scheme_choice& choice,
                      const std::optional<Crease_maps>& creases)
{
  if (is_grid_scheme(choice.scheme) || !scheme_of(choice).keeps_vertices()) return false;
  if (!creases) return true;
  const auto is_settled = [](double sharpness) {
    return !(sharpness > 0) || std::isinf(sharpness);
  };
  const auto edges = surface.edges();
  const auto vertices = surface.vertices();
  return std::all_of(edges.begin(), edges.end(),
                     [&](auto e) { return is_settled(creases->edges[e]); }) &&
         std::all_of(vertices.begin(), vertices.end(),
                     [&](auto v) { return is_settled(creases->vertices[v]); });
}

// Those of the corners on creases, at which control normals stand in for those of the surface.
void remove_normals_on_creases(const Surface& surface, Corner_normal_map normals,
                               const Crease_maps& creases)
{
  std::vector<bool> is_on_crease(surface.number_of_vertices());
  for (const Edge e : surface.edges())
    if (creases.edges[e] > 0 || (creases.border != Border::surface && surface.is_border(e)))
      is_on_crease[surface.vertex(e, 0)] = is_on_crease[surface.vertex(e, 1)] = true;
  for (const Halfedge h : surface.halfedges()) {
    const Vertex v = surface.target(h);
    if (is_on_crease[v] || creases.vertices[v] > 0) normals[h] = Vector_3(0, 0, 0);
  }
}

} // namespace

void require_limit_of_vertices(const std::string& scheme, const Limit_choice& choice)
{
  if (!choice.is_used()) return;
  if (!make_scheme("--scheme", scheme, {}).keeps_vertices())
    throw Usage_error(std::string(choice.points ? "--limit" : choice.normals_option) +
                      ": the limit points of " + scheme +
                      " belong to the faces, not to the vertices; take another scheme");
}

Limit_summary set_limits(Surface& surface, const Scheme_choice& scheme, const Limit_choice& choice,
                         const std::optional<Crease_maps>& creases, unsigned levels)
{
  const auto options = make_options(choice, levels);
  if (creases)
    return {
      move_to_limits_of(surface, scheme, *creases, choice.normals, options.border(creases->border)),
      choice};
  const std::optional<Normal_map> control = normals_of(surface);
  std::optional<Normal_map> written = control;
  if (choice.normals && !control) written = add_normals(surface);
  return {limits_of(surface, control, scheme, write_limits(surface, written, choice), options),
          choice};
}

bool move_to_surface(Surface& surface, const Scheme_choice& scheme,
                     const std::optional<Crease_maps>& creases, unsigned levels)
{
  if (!are_limits_known(surface, scheme, creases)) return false;
  Limit_choice choice;
  choice.points = choice.normals = true;
  if (creases) {
    set_limits(surface, scheme, choice, creases, levels);
    remove_normals_on_creases(surface, *corner_normals_of(surface), *creases);
    return true;
  }
  const std::optional<Normal_map> control = normals_of(surface);
  Normal_map normals = control ? *control : add_normals(surface);
  const Limit_map limits([&](Vertex v, const Limit_point& limit) {
    surface.point(v) = limit.point;
    normals[v] = limit.has_surface_normal ? limit.surface_normal : Vector_3(0, 0, 0);
  });
  limits_of(surface, control, scheme, limits, make_options(choice, levels));
  return true;
}

} // namespace pn_subdivide

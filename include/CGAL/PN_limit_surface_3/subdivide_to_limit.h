// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_SUBDIVIDE_TO_LIMIT_H
#define CGAL_PN_LIMIT_SURFACE_3_SUBDIVIDE_TO_LIMIT_H

#include <CGAL/Named_function_parameters.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Limit_evaluation.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Limit_writer.h>
#include <CGAL/PN_limit_surface_3/internal/limit/limits_at_slots.h>
#include <CGAL/PN_limit_surface_3/limit/Limit_point.h>
#include <CGAL/PN_limit_surface_3/limit_points.h>
#include <CGAL/PN_subdivision_3/attributes.h>
#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/attributes/Call_attributes.h>
#include <CGAL/PN_subdivision_3/internal/calls/concept_checks.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/meshes/Mesh_values.h>
#include <CGAL/PN_subdivision_3/internal/meshes/Mesh_writer.h>
#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
#include <CGAL/PN_subdivision_3/internal/meshes/read_mesh.h>
#include <CGAL/PN_subdivision_3/internal/meshes/slot_normals.h>
#include <CGAL/PN_subdivision_3/internal/meshes/with_mesh_access.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Level_refiner.h>
#include <CGAL/PN_subdivision_3/internal/rounds/Round.h>
#include <CGAL/PN_subdivision_3/internal/schemes/on_host.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3 {
namespace internal {

// The rounds of a call, and then the limits of the vertices that they make. The mesh and its maps are touched when
// all limits are known; attributes are those of the rounds.
template <class Concurrency_tag, class Scheme, class Kernel>
class Limit_subdivision
{
public:
  using Round_done = Function_ref<void(unsigned, std::size_t)>;

  // options and round_done have to live as long
  template <class Function>
  Limit_subdivision(const Scheme& scheme, unsigned rounds, const Limit_options& options,
                    const Function& round_done)
    : scheme_(scheme)
    , options_(options)
    , rounds_(rounds)
    , round_done_(round_done)
    , for_chunks_(For_chunks::with(Concurrency_tag()))
  {}
  template <class Function>
  Limit_subdivision(const Scheme&, unsigned, const Limit_options&, const Function&&) = delete;

  template <class Access, class Point_map, class Normal_map, class Edge_map, class Vertex_map,
            class Attributes, class NamedParameters>
  Limit_report operator()(Access& access, Point_map points, Normal_map normals, Edge_map edge_map,
                          Vertex_map vertex_map, const Attributes& attributes,
                          const NamedParameters& np) const
  {
    static_assert(check_no_grid_rows<Scheme>());
    Limit_report report;
    if constexpr (check_corner_normals<Scheme, Access, Normal_map>()) {
      require_crease_rules(scheme_, access, normals, edge_map, vertex_map);
      report = subdivide(access, points, normals, edge_map, vertex_map, attributes, np);
    }
    return report;
  }

private:
  using FT = typename Kernel::FT;
  using Index = Level_connectivity::Index;
  using Host = typename Scheme::Host;
  using Average = Average_of_scheme<Scheme, FT>;
  using Value = typename Average::Value;
  using Level = Valued_level<Value>;
  using Limit_value = Point_normal<FT, 3>;

  template <class Access, class Point_map, class Normal_map, class Edge_map, class Vertex_map,
            class Attributes, class NamedParameters>
  Limit_report subdivide(Access& access, Point_map points, Normal_map normals, Edge_map edge_map,
                         Vertex_map vertex_map, const Attributes& attributes,
                         const NamedParameters& np) const
  {
    Control_mesh control(scheme_, access, normals, edge_map, vertex_map, FT());
    Level_connectivity& level = control.level;
    auto& of_mesh = control.maps;
    auto& creases = control.creases;
    const unsigned rounds = number_of_rounds(level, rounds_);
    require_sharp_for_ever<FT>(access, creases, rounds);
    of_mesh.read_tangents(creases);
    const Level_size size = checked_refined_size<Host>(level.size(), rounds, Access::index_limit());
    std::vector<Value> values = of_mesh.values(level, points, normals, creases);
    using Writers = Normal_writers<Access, Normal_map>;
    typename Writers::Corner_writer corners(access, level, normals);
    auto attribute_rounds =
      attribute_rounds_of_call<FT, Host>(attributes, access, level, creases, of_mesh, for_chunks_);
    const Scheme_of_rounds<Scheme>& round_scheme = scheme_of_rounds(scheme_);
    using Level_creases = typename decltype(control)::Level_creases;
    Level_refiner<Scheme_of_rounds<Scheme>, Average, Level_creases> refiner(
      round_scheme, std::move(level), std::move(creases), {values.begin(), values.end()},
      for_chunks_);
    std::vector<Value>().swap(values);
    refine(rounds, round_scheme, refiner, attribute_rounds);
    auto last = refiner.next_round();
    attribute_rounds.begin_round(round_scheme, refiner, last, Kind_of_round::last_put_later);
    Level refined = refined_level(refiner, last, attribute_rounds.rows());
    refiner.release_values();
    report_last_round(round_done_, rounds, rounds_, size);
    auto limit_creases = last.refined_creases();
    const Limit_demand demand = limit_demand<FT>(options_, box_size(refined));
    auto limits = limits_of(refined, limit_creases, demand, rounds + 1);

    if constexpr (!Writers::Corner_writer::takes_corners) put_mean_normals(limit_creases, limits);
    const auto put = [&](auto vertex_normals) {
      Mesh_writer<Limit_value, Access, Point_map, decltype(vertex_normals)> writer(
        access, points, vertex_normals, false);
      using Maps_writer = Limit_maps_writer<Access, Kernel, NamedParameters>;
      Maps_writer of_limits(access, np);
      access.grow(size);
      put_limits(limits, refined.values, static_cast<Index>(size.vertices), writer);
      put_corner_normals<Maps_writer::is_any_given>(corners, refined.level, limit_creases, limits);
      of_limits.write(limits, static_cast<Index>(size.vertices));
      attribute_rounds.put(refiner, last.round(), for_chunks_);
      of_mesh.put_sharpness(limit_creases, size, rounds);
      of_mesh.put_tangents(limit_creases, size);
      put_connectivity(last.round(), access, for_chunks_, [&] {
        writer.commit();
        of_limits.commit();
        corners.commit();
        of_mesh.commit();
        attribute_rounds.commit();
      });
    };
    if (puts_normals())
      put(Writers::vertex_map(normals));
    else
      put(Not_given());
    if constexpr (Attributes::visited.any())
      attributes.visit(access, size, attribute_rounds->rules(last.round(), refiner.level()));
    limits.resize(size.vertices);
    return limit_report(limits, demand);
  }

  // with a linear scheme normals are written as surface normals only
  bool puts_normals() const { return is_pn_v<Scheme> || options_.surface_normals; }

  // all rounds but the last one
  template <class Refiner, class Attribute_rounds>
  void refine(unsigned rounds, const Scheme_of_rounds<Scheme>& round_scheme, Refiner& refiner,
              Attribute_rounds& attribute_rounds) const
  {
    for (unsigned k = 1; k < rounds; ++k) {
      attribute_rounds.refine(round_scheme, refiner);
      round_done_(k, static_cast<std::size_t>(refiner.level().size().faces));
    }
    attribute_rounds.before_cut(refiner);
  }

  // the limits at the slots of the refined level; the creases get the tangents of the limit
  template <class Level_creases>
  auto limits_of(Level& refined, Level_creases& creases, const Limit_demand& demand,
                 unsigned next_round) const
  {
    auto limits = limits_at_slots<FT>(scheme_of_rounds(scheme_), demand, for_chunks_, refined,
                                      creases, next_round);
    if (asks_for_points(options_))
      std::vector<Value>().swap(refined.values); // else they are written
    check_limits<FT>(limits, [](std::size_t v) { return "vertex number " + std::to_string(v); });
    return limits;
  }

  // the normals of the wedges at the corners; then vertices have the means, where another map takes these
  template <bool needs_means, class Corner_writer, class Level_creases, class Limits>
  void put_corner_normals([[maybe_unused]] Corner_writer& corners,
                          [[maybe_unused]] const Level_connectivity& level,
                          [[maybe_unused]] const Level_creases& creases,
                          [[maybe_unused]] Limits& limits) const
  {
    if constexpr (Corner_writer::takes_corners) {
      if (puts_normals())
        corners.put_all(level, creases, limit_normals<FT>(limits, options_.surface_normals));
      if constexpr (needs_means) put_mean_normals(creases, limits);
    }
  }

  // The refined level with the values of its slots; the level before it is whole again afterwards.
  template <class Refiner, class Last>
  Level refined_level(const Refiner& refiner, Last& last,
                      const typename Refiner::Rows_sink* rows) const
  {
    const auto values = refiner.refined_values(last, rows);
    Level refined;
    refined.values.assign(values.begin(), values.end());
    refined.level = child_level(last, last.refined_creases(), for_chunks_);
    return refined;
  }

  template <class Limits, class Writer>
  void put_limits(const Limits& limits, const std::vector<Value>& refined, Index number,
                  Writer& writer) const
  {
    const bool moves = asks_for_points(options_);
    const auto put_range = [&](Index begin, Index end) {
      for (Index v = begin; v < end; ++v) {
        const Limit_value value{point_of(moves ? limits[v].value : refined[v]),
                                limit_normal(limits[v], options_.surface_normals)};
        writer.put_values(v, &value, 1);
      }
    };
    const Index old_vertices = (std::min)(number, writer.number_of_old_vertices());
    put_range(old_vertices, number);
    writer.begin_old_vertices();
    put_range(0, old_vertices);
  }

  const Scheme& scheme_;
  const Limit_options& options_;
  unsigned rounds_;
  Round_done round_done_;
  For_chunks for_chunks_;
};

} // namespace internal

/*!
\ingroup PkgPNSubdivision3Limit

subdivides a mesh and puts its vertices on the limit surface. With 0 rounds, after `subdivide()` with the same scheme, the
result is the same. Limits are computed before the mesh is touched, so that the strong guarantee is that of one
call.

Points become the limit points. `limit_normal_map` gets the normals for shading. Normals, if there is a `vertex_normal_map`, become the surface normals if
`parameters::surface_normals()` asks for them, and otherwise the limit control normals. With a linear scheme normals
are written only as surface normals. With a map of half-edges the wedges
of creases have their own, and `crease_tangent_map` gets the tangents of the limit; with a map of
vertices the mean counts. *The mesh is no control mesh any more:* its points and normals are not meant to be
subdivided further.

<b>Creases.</b> With `edge_is_constrained_map`, `vertex_is_constrained_map`, `border` and `crease_tangent_map` the
mesh has creases as in `subdivide()`, and the limits are those of `limit_points()`. An edge that is sharp for a finite
number of rounds has to be smooth after those of the call. The maps are written as by `subdivide()`; the tangents are
those of the limit.

<b>Attributes</b> are those that `subdivide()` leaves after as many rounds, bit for bit: values of vertices and corners are
not moved to their limits. With 0 rounds they stay as they are, and the visitor is not called. It may cancel the call by
an exception of `round_done()`, also of the last round, after which limits are computed.

<b>Strong guarantee.</b> If an exception leaves the function, the maps are as they were, except for maps of
the user's whose `put()` throws also while old values are put back, or which cannot be read.

\param mesh an oriented 2-manifold with border
\param scheme the scheme
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `number_of_iterations`,
  `vertex_point_map`, `vertex_normal_map` with the control normals (without it they are estimated), `control_normal_estimate`,
  `vertex_roundness_map` or `roundness`, `edge_is_constrained_map`, `vertex_is_constrained_map`, `border`,
  `crease_tangent_map`, `attributes`, `visitor` and `geom_traits` as in `subdivide()`. As in `limit_points()` are
  `tolerance`, `normal_tolerance`, `max_depth`, `points`, `surface_normals`, `limit_point_map`, `limit_normal_map` and
  `limit_error_map` (of the vertices of the result). With 0 rounds `rounds_done` counts, too; otherwise the call
  counts its rounds itself

\returns what was reached

\throws std::invalid_argument as `subdivide()` and `limit_points()` do, and if `rounds_done` is not 0 where there are rounds
\throws std::length_error,std::overflow_error,std::domain_error as `subdivide()` and `limit_points()` do
<br><b>Cost:</b> that of both functions; the refined level is kept in memory besides the mesh
*/
template <class Concurrency_tag = Sequential_tag, class PolygonMesh, class Scheme,
          class NamedParameters = parameters::Default_named_parameters>
Limit_report subdivide_to_limit(PolygonMesh& mesh, const Scheme& scheme,
                                const NamedParameters& np = parameters::default_values())
{
  internal::check_are_read<NamedParameters, internal::Read_of_control_mesh, internal::attributes_t,
                           internal::tolerance_t, internal::normal_tolerance_t,
                           internal::max_depth_t, internal::points_t, internal::surface_normals_t,
                           internal::rounds_done_t, internal::limit_point_map_t,
                           internal::limit_normal_map_t, internal::limit_error_map_t>();
  if constexpr (internal::is_open_v<Scheme, NamedParameters>)
    return internal::with_scheme_of_call<Limit_report,
                                         internal::Surface_call<PolygonMesh, NamedParameters>,
                                         internal::Hosts::of_vertex_limits>(
      scheme, np, [&](const auto& s, const auto& others) {
        return subdivide_to_limit<Concurrency_tag>(mesh, s, others);
      });
  else {
    static_assert(Scheme::Host::keeps_vertices,
                  "the limit points of a dual scheme belong to the faces: see limit_points()");
    using Parameters = internal::Surface_parameters<PolygonMesh, NamedParameters>;
    const internal::Limit_options options = internal::limit_options(np);
    const unsigned rounds = Parameters::number_of_iterations(np);
    if (rounds == 0) return internal::move_to_limit<Concurrency_tag, Parameters>(mesh, scheme, np);
    if (options.rounds_done != 0)
      throw std::invalid_argument(
        "PN_subdivision_3: subdivide_to_limit() counts its rounds itself: "
        "leave rounds_done 0");
    Limit_report report;
    if constexpr (internal::check_subdivision_arguments<PolygonMesh, Scheme, NamedParameters>() &&
                  internal::check_attributes<PolygonMesh, NamedParameters>()) {
      auto visitor = Parameters::visitor(np);
      auto& unwrapped = internal::unwrapped(visitor);
      using Visitor = std::remove_reference_t<decltype(unwrapped)>;
      const internal::Call_round_done<Visitor> round_done{unwrapped};
      if constexpr (!internal::check_visitor<Visitor, PolygonMesh>()) return report;
      auto attributes = Parameters::attributes(np);
      auto& carried = internal::unwrapped(attributes);
      const internal::Call_attributes<PolygonMesh, Visitor,
                                      std::remove_reference_t<decltype(carried)>>
        attributes_of_call{unwrapped, carried};
      internal::with_mesh_access(mesh, [&](auto& access) {
        report =
          internal::with_roundness_of_call<Parameters>(access, scheme, np, [&](const auto& s) {
            const internal::Limit_subdivision<Concurrency_tag, std::decay_t<decltype(s)>,
                                              typename Parameters::Geom_traits>
              subdivision(s, rounds, options, round_done);
            return subdivision(access, Parameters::point_map(mesh, np), Parameters::normal_map(np),
                               Parameters::edge_constraint_map(np),
                               Parameters::vertex_constraint_map(np), attributes_of_call, np);
          });
      });
    }
    return report;
  }
}

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_LIMIT_SURFACE_3_SUBDIVIDE_TO_LIMIT_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_REFINE_SURFACE_H
#define PN_SUBDIVIDE_REFINE_SURFACE_H

#include "io/Limit_choice.h"
#include "surface/Surface.h"
#include "surface/control_mesh.h"
#include "surface/creases.h"

#include <CGAL/PN_limit_surface_3/tessellation/Tessellation_result.h>
#include <CGAL/PN_subdivision_3/attributes.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

namespace pn_subdivide {

// About how many seconds the rounds take on one thread; 0 for meshes without large valences and large
// faces, whose rounds are reported one by one. Some schemes combine, for each edge at a vertex, all of its
// neighbors: the time then grows with the square of the valence.
double expected_seconds(Surface& surface, const Scheme_choice& choice, unsigned levels);

struct Refinement
{
  unsigned levels = 1;
  std::optional<Crease_maps> creases;
  Wedge_list* wedges = nullptr;                          // with creases: gets the normals
  PN::Attribute_table* attributes = nullptr;             // there must be one, perhaps empty
  std::function<void(unsigned, std::size_t)> round_done; // (round, faces), after each round
};

// f(named parameters) of the normals of vertices, and the roundness if there is some
template <class Function>
auto with_normals_of_vertices(const Surface& surface, const Normal_map& normals, const Function& f)
{
  const auto np = CGAL::parameters::vertex_normal_map(normals);
  if (const std::optional<Roundness_map> roundness = roundness_of(surface))
    return f(PN::parameters::join(PN::parameters::vertex_roundness_map(*roundness), np));
  return f(np);
}

// Refines with the scheme, point-normal if the mesh has normals, linear if not. Old vertices come
// first in the result, in their order, but for Doo-Sabin. With creases, which the schemes must have
// rules for, the normals of vertices that have several are in the list of wedges afterwards. The roundness of the mesh, if it has one, is refined with
// it. Passes on the library's
// exceptions.
void refine_surface(Surface& surface, const Scheme_choice& choice, const Refinement& refinement);

// --chord and --chord-bound: throws Usage_error if they are wrong.
std::optional<Box_length> parse_chord(const Surface_options& options);

// The surface becomes triangles between points of its limit surface, of which these are no farther than `chord`, as is estimated or
// proved. With
// normals of vertices, with creases of corners; without creases and control data. Passes on the library's exceptions.
PN::Tessellation_result tessellate_surface(Surface& surface, const Scheme_choice& scheme,
                                           const std::optional<Crease_maps>& creases, double chord,
                                           bool is_proven, PN::Attribute_table& attributes);

// Says what was reached, and warns if that is not what was asked for.
void report_tessellation(const PN::Tessellation_result& tessellation, double chord, bool is_proven,
                         const std::string& output, Report& report);

// Throws Usage_error if the scheme has no limit points at vertices.
void require_limit_of_vertices(const std::string& scheme, const Limit_choice& choice);

// Puts the vertices of a mesh of the given level on the limit surface, gives them the surface's normals,
// or both. Points without normals count as those of the linear scheme. Of a mesh that has creases or crease borders, with
// their tangents if it is refined, normals are those of corners afterwards. Passes on the library's exceptions.
Limit_summary set_limits(Surface& surface, const Scheme_choice& scheme, const Limit_choice& choice,
                         const std::optional<Crease_maps>& creases, unsigned levels);

// Puts the vertices on the limit surface, with its normals: zero where it is not known to have one, on creases for
// instance. False if limits are not known: of schemes without limits at vertices, and of edges that are sharp for some
// more rounds.
bool move_to_surface(Surface& surface, const Scheme_choice& scheme,
                     const std::optional<Crease_maps>& creases, unsigned levels);

// Throws Usage_error if surfaces of the scheme cannot be made to pass through points.
void require_interpolation(const Scheme_choice& choice);
bool can_interpolate(const Scheme_choice& choice);

// Makes a mesh the control net of a surface through its vertices; without normals by the linear scheme. With creases
// it gets the normals of their wedges, and the tangents. Normals that were estimated are improved. Passes on the library's
// exceptions.
Interpolation_report interpolate_surface(Surface& surface, const Scheme_choice& choice,
                                         Interpolation_mode mode, bool improves_normals,
                                         const std::optional<Crease_maps>& creases);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_REFINE_SURFACE_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/refine_surface.h"

#include "io/Error.h"
#include "io/Text_reader.h"
#include "options.h"

#include <CGAL/PN_limit_surface_3/tessellate.h>
#include <CGAL/PN_subdivision_3/parameters/parameters.h>
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#include <CGAL/PN_subdivision_3/schemes/Any_scheme.h>

#include <utility>

namespace pn_subdivide {
namespace {

using Tag = CGAL::Parallel_if_available_tag;
using PN::Attribute_table;
using Result = PN::Tessellation_result;

// Returns f(scheme, named parameters) of a tessellation of the surface, but for attributes and bounds.
template <class Function>
auto with_tessellation_parameters(Surface& surface, const Scheme_choice& choice,
                                  const std::optional<Crease_maps>& creases, const Function& f)
{
  const std::optional<Normal_map> of_vertices = normals_of(surface);
  const auto linear = [&] { return PN::linear(scheme_of(choice)); };
  if (!creases) {
    if (!of_vertices) return f(linear(), CGAL::parameters::default_values());
    const auto np = PN::parameters::vertex_roundness_map(roundness_or_added(surface))
                      .vertex_normal_map(*of_vertices);
    return f(scheme_with_normals(choice), np);
  }
  const auto sharp = PN::parameters::border(creases->border)
                       .edge_is_constrained_map(creases->edges)
                       .vertex_is_constrained_map(creases->vertices);
  if (!of_vertices) return f(linear(), sharp);
  const auto np = PN::parameters::join(PN::parameters::crease_tangent_map(creases->tangents),
                                       sharp.vertex_normal_map(corner_normals_or_added(surface)));
  return f(scheme_with_normals(choice), np);
}

// With maps of the result's normals, of vertices or of corners.
template <class S, class NamedParameters>
Result tessellated(const Surface& surface, const S& scheme, double chord, bool is_proven,
                   Surface& result, bool has_corners, const NamedParameters& np,
                   Attribute_table& attributes)
{
  const Normal_map normals = add_normals(result);
  const auto all =
    PN::parameters::join(PN::parameters::attributes(attributes).proven_bound(is_proven), np);
  if (!has_corners)
    return PN::tessellate<Tag>(surface, scheme, chord, result, all,
                               CGAL::parameters::vertex_normal_map(normals));
  return PN::tessellate<Tag>(surface, scheme, chord, result, all,
                             CGAL::parameters::vertex_normal_map(add_corner_normals(result)));
}

const char* text_of(Result::Obstacle obstacle)
{
  using Obstacle = Result::Obstacle;
  switch (obstacle) {
  case Obstacle::rounds:
    return " in 12 rounds";
  case Obstacle::triangles:
    return " with 260,000 triangles";
  case Obstacle::digits:
    return ", for which coordinates have too few digits";
  case Obstacle::none:
    break;
  }
  return "";
}

void require_chord_bound(const Surface_options& options)
{
  if (!options.chord_bound) return;
  parse_word<bool>("--chord-bound", *options.chord_bound, {{"estimated", false}, {"proven", true}});
  if (!options.chord) throw Usage_error("--chord-bound needs --chord");
}

} // namespace

std::optional<Box_length> parse_chord(const Surface_options& options)
{
  require_chord_bound(options);
  if (!options.chord) return std::nullopt;
  const Box_length chord = parse_box_length(*options.chord, "--chord");
  if (!(chord.value > 0)) throw Usage_error("--chord " + *options.chord + ": it must be positive");
  return chord;
}

Result tessellate_surface(Surface& surface, const Scheme_choice& scheme,
                          const std::optional<Crease_maps>& creases, double chord, bool is_proven,
                          Attribute_table& attributes)
{
  Surface result;
  const Result reached =
    with_tessellation_parameters(surface, scheme, creases, [&](const auto& s, const auto& np) {
      return tessellated(surface, s, chord, is_proven, result, creases.has_value(), np, attributes);
    });
  surface = std::move(result);
  return reached;
}

void report_tessellation(const Result& tessellation, double chord, bool is_proven,
                         const std::string& output, Report& report)
{
  report.set_tessellation({{"reached", tessellation.reached},
                           {"bound", tessellation.bound},
                           {"asked", chord},
                           {"triangles", tessellation.number_of_triangles}});
  const char* const what = is_proven ? "proven bound" : "estimated error";
  report.note(formatted("chord: %.6g asked for, %s %.3g against the limit surface", chord, what,
                        tessellation.bound));
  if (tessellation.reached) return;
  const auto& p = tessellation.worst_place;
  report.warn(output + formatted(": --chord %.6g is not reached%s: the %s is %.3g at control face "
                                 "%zu, near %.6g %.6g %.6g",
                                 chord, text_of(tessellation.obstacle), what, tessellation.bound,
                                 tessellation.worst_face, p[0], p[1], p[2]));
}

} // namespace pn_subdivide

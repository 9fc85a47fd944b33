// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/chord_rounds.h"

#include "io/Error.h"
#include "surface/refine_surface.h"
#include "surface/surface_command.h"

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace pn_subdivide {
namespace {

using Kind = Recognized_surface::Kind;
using Vertex = Surface::Vertex_index;

constexpr unsigned most_rounds = 12;
constexpr double most_faces = 2147483648.;

// Of a circle in steps of `angle` after k rounds, each of which halves the widest.
double sagitta(double radius, double angle, unsigned k)
{
  return radius * (1 - std::cos(std::ldexp(angle, -static_cast<int>(k) - 1)));
}

// `farthest`: from the apex along the axis of a cone
double chord_error(const Recognized_surface& s, double farthest, unsigned k)
{
  switch (s.kind) {
  case Kind::cylinder:
  case Kind::sphere:
    return sagitta(s.radius, s.widest_step, k);
  case Kind::cone:
    return sagitta(farthest * std::sin(s.half_angle), s.widest_step, k);
  case Kind::torus:
    return sagitta(s.tube_radius, s.widest_meridian_step, k) +
           sagitta(s.radius + s.tube_radius, s.widest_step, k);
  case Kind::plane:
  case Kind::unknown:
    break;
  }
  return 0;
}

// Of each segment that is a cone, else 0.
std::vector<double> farthest_from_apices(const Mesh_data& mesh, const Recognized_part& part)
{
  std::vector<double> farthest(part.surfaces.size(), 0.);
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
    const Recognized_surface& s = part.surfaces[part.segments[f]];
    if (s.kind != Kind::cone) continue;
    double& largest = farthest[part.segments[f]];
    for (const Mesh_data::Index v : mesh.face(f)) {
      const Vector_3 d = to_point(mesh.points[v]) - to_point(s.point);
      largest = (std::max)(largest, std::abs(d * to_vector(s.direction)));
    }
  }
  return farthest;
}

[[noreturn]] void refuse(double chord, const std::string& what)
{
  char length[40];
  std::snprintf(length, sizeof length, "%g", chord);
  throw Error(std::string("--levels auto: --chord ") + length + " takes more than " + what +
              "; take a larger one");
}

unsigned rounds_of_surfaces(const Mesh_data& mesh, const Recognized_part& part, double chord)
{
  const std::vector<double> farthest = farthest_from_apices(mesh, part);
  unsigned k = 0;
  for (std::size_t i = 0; i < part.surfaces.size(); ++i)
    while (chord_error(part.surfaces[i], farthest[i], k) > chord)
      if (++k > most_rounds) refuse(chord, std::to_string(most_rounds) + " rounds");
  return k;
}

// What is farthest in the unknown segments from the middles of the edges when these are split once more.
class Unknown_segments
{
public:
  Unknown_segments(const Mesh_data& mesh, const Recognized_part& part, const Creases& creases,
                   const Scheme_choice& scheme, unsigned threads)
    : surface_(make_surface(mesh))
    , part_(part)
    , scheme_(scheme)
    , segments_(part.segments)
  {
    rounds_.levels = 1;
    rounds_.threads = threads;
    rounds_.wedges = &wedges_;
    rounds_.attributes = &table_;
    if (creases.any() || creases.border != Border::surface)
      rounds_.creases = add_creases(surface_, creases, true);
  }

  std::size_t number_of_faces() const { return surface_.number_of_faces(); }

  // Refines.
  double next_distance()
  {
    std::vector<Point_3> old;
    for (const Vertex v : surface_.vertices()) old.push_back(surface_.point(v));
    table_ = {};
    table_.has_face_parents = true;
    if (!wedges_.empty()) put_corner_normals(surface_, std::exchange(wedges_, {}));
    refine_surface(surface_, scheme_, rounds_);
    std::vector<std::size_t> segments;
    for (const auto parent : table_.face_parents)
      segments.push_back(segments_[static_cast<std::size_t>(parent)]);
    segments_ = std::move(segments);
    double largest = 0;
    for (const Vertex v : surface_.vertices())
      if (std::size_t(v) >= old.size()) largest = (std::max)(largest, from_middle(v, old));
    return largest;
  }

private:
  // Points of edges, and no others, have two old neighbors.
  double from_middle(Vertex v, const std::vector<Point_3>& old) const
  {
    std::vector<Vertex> ends;
    bool is_unknown = false;
    for (const auto h : CGAL::halfedges_around_target(surface_.halfedge(v), surface_)) {
      if (std::size_t(surface_.source(h)) < old.size()) ends.push_back(surface_.source(h));
      is_unknown =
        is_unknown || (!surface_.is_border(h) && !part_.is_known(segments_[surface_.face(h)]));
    }
    if (!is_unknown || ends.size() != 2) return 0;
    const Point_3 middle = CGAL::midpoint(old[ends[0]], old[ends[1]]);
    return std::sqrt(CGAL::squared_distance(surface_.point(v), middle));
  }

  Surface surface_;
  const Recognized_part& part_;
  const Scheme_choice& scheme_;
  std::vector<std::size_t> segments_;
  Refinement rounds_;
  Wedge_list wedges_;
  CGAL::PN_subdivision_3::Attribute_table table_;
};

bool has_unknown_faces(const Recognized_part& part)
{
  return std::any_of(part.segments.begin(), part.segments.end(),
                     [&](std::size_t segment) { return !part.is_known(segment); });
}

// Distances that shrink by 4 add up to 4/3 of the first. They shrink less at corners; what would take more memory than most
// results is foreseen from the last two.
Chord_rounds rounds_of_unknown(Unknown_segments& unknown, double chord)
{
  constexpr std::size_t most_faces_tried = 1000000;
  double distance = unknown.next_distance(), factor = 0.25;
  unsigned k = 0;
  for (; 4 * distance > 3 * chord; ++k) {
    if (k == most_rounds) refuse(chord, std::to_string(most_rounds) + " rounds");
    const double before = distance;
    distance =
      unknown.number_of_faces() < most_faces_tried ? unknown.next_distance() : factor * distance;
    factor = (std::max)(0.25, distance / before);
  }
  return {k, 4 * distance / 3};
}

double faces_after(const Mesh_data& mesh, const Scheme_choice& scheme, unsigned rounds)
{
  if (rounds == 0) return static_cast<double>(mesh.number_of_faces());
  const int k = static_cast<int>(rounds);
  return needs_triangles(scheme.scheme)
           ? std::ldexp(static_cast<double>(mesh.number_of_faces()), 2 * k)
           : std::ldexp(static_cast<double>(mesh.number_of_corners()), 2 * (k - 1));
}

} // namespace

std::optional<Box_length> parse_chord(const Surface_options& options)
{
  if (options.chord) {
    const Box_length chord = parse_box_length(*options.chord, "--chord");
    if (!(chord.value > 0))
      throw Usage_error("--chord " + *options.chord + ": it must be positive");
    const std::string& scheme = options.scheme.scheme;
    if (scheme == "sqrt3" || scheme == "doo-sabin")
      throw Usage_error("--chord and --scheme " + scheme +
                        " exclude each other: a round of that scheme halves no edge");
    if (options.has_levels && !options.auto_levels)
      throw Usage_error("--chord and --levels " + std::to_string(options.levels) +
                        " exclude each other: take --levels auto");
    if (!options.auto_levels) throw Usage_error("--chord needs --levels auto");
    if (!wants_surfaces(options.creases)) throw Usage_error("--chord needs --sharp surfaces");
    return chord;
  }
  if (options.auto_levels) throw Usage_error("--levels auto needs --chord");
  return std::nullopt;
}

Chord_rounds rounds_for_chord(const Mesh_data& mesh, const Recognized_part& part,
                              const Creases& creases, const Scheme_choice& scheme, double chord,
                              unsigned threads)
{
  Chord_rounds result;
  result.rounds = rounds_of_surfaces(mesh, part, chord);
  if (has_unknown_faces(part)) {
    Unknown_segments unknown(mesh, part, creases, scheme, threads);
    const Chord_rounds of_unknown = rounds_of_unknown(unknown, chord);
    result.estimate = std::ldexp(of_unknown.estimate,
                                 -2 * ((std::max)(0, int(result.rounds) - int(of_unknown.rounds))));
    result.rounds = (std::max)(result.rounds, of_unknown.rounds);
  }
  if (faces_after(mesh, scheme, result.rounds) > most_faces)
    refuse(chord, "2^31 faces, in " + std::to_string(result.rounds) + " rounds");
  return result;
}

} // namespace pn_subdivide

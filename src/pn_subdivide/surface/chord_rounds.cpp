// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/chord_rounds.h"

#include "io/Error.h"
#include "surface/limit_surface.h"
#include "surface/refine_surface.h"
#include "surface/surface_command.h"

#include <CGAL/PN_subdivision_3/internal/limit_surface/Flatness.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
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

// A surface that is refined round by round.
class Refined_surface
{
public:
  Refined_surface(const Mesh_data& mesh, const Creases& creases, const Scheme_choice& scheme,
                  unsigned threads)
    : surface_(make_surface(mesh))
    , scheme_(scheme)
  {
    scale();
    rounds_.levels = 1;
    rounds_.threads = threads;
    if (creases.any() || creases.border != Border::surface)
      rounds_.creases = add_creases(surface_, creases, true);
  }

  const Surface& surface() const { return surface_; }
  // of what is measured there
  double length(double scaled) const { return std::ldexp(scaled, exponent_); }
  // Of each face the number of the one that it was before.
  std::vector<std::uint32_t> refine()
  {
    table_ = {};
    table_.has_face_parents = true;
    rounds_.wedges = &wedges_; // here, since this object may have been moved
    rounds_.attributes = &table_;
    refine_surface(surface_, scheme_, rounds_);
    if (!wedges_.empty()) put_corner_normals(surface_, std::exchange(wedges_, {}));
    return std::move(table_.face_parents);
  }
  std::vector<Point_3> points() const
  {
    std::vector<Point_3> result;
    for (const Vertex v : surface_.vertices()) result.push_back(surface_.point(v));
    return result;
  }
  // of the vertices, after so many rounds
  std::vector<Point_3> limits(unsigned rounds) const
  {
    Surface copy = surface_;
    Limit_choice choice;
    choice.points = true;
    if (const auto creases = creases_of(copy, rounds_.creases))
      set_limits(copy, scheme_, choice, *creases, rounds, rounds_.threads);
    else
      set_limits(copy, scheme_, choice, rounds, rounds_.threads);
    std::vector<Point_3> result;
    for (const Vertex v : copy.vertices()) result.push_back(copy.point(v));
    return result;
  }

private:
  // by a power of two, so that squares neither overflow nor underflow
  void scale()
  {
    double largest = 0;
    for (const Vertex v : surface_.vertices())
      for (int c = 0; c < 3; ++c) largest = (std::max)(largest, std::abs(surface_.point(v)[c]));
    if (!(largest > 0)) return;
    exponent_ = std::ilogb(largest);
    for (const Vertex v : surface_.vertices()) {
      const Point_3 p = surface_.point(v);
      surface_.point(v) = Point_3(std::ldexp(p[0], -exponent_), std::ldexp(p[1], -exponent_),
                                  std::ldexp(p[2], -exponent_));
    }
  }

  Surface surface_;
  int exponent_ = 0;
  const Scheme_choice& scheme_;
  Refinement rounds_;
  Wedge_list wedges_;
  CGAL::PN_subdivision_3::Attribute_table table_;
};

// What is farthest in the unknown segments from the middles of the edges when these are split once more.
class Unknown_segments
{
public:
  Unknown_segments(Refined_surface&& surface, const Recognized_part& part)
    : refined_(std::move(surface))
    , part_(part)
    , segments_(part.segments)
  {}

  std::size_t number_of_faces() const { return refined_.surface().number_of_faces(); }

  // Refines.
  double next_distance()
  {
    const std::vector<Point_3> old = refined_.points();
    std::vector<std::size_t> segments;
    for (const auto parent : refined_.refine())
      segments.push_back(segments_[static_cast<std::size_t>(parent)]);
    segments_ = std::move(segments);
    double largest = 0;
    for (const Vertex v : refined_.surface().vertices())
      if (std::size_t(v) >= old.size()) largest = (std::max)(largest, from_middle(v, old));
    return refined_.length(largest);
  }

private:
  // Points of edges, and no others, have two old neighbors.
  double from_middle(Vertex v, const std::vector<Point_3>& old) const
  {
    const Surface& surface = refined_.surface();
    std::vector<Vertex> ends;
    bool is_unknown = false;
    for (const auto h : CGAL::halfedges_around_target(surface.halfedge(v), surface)) {
      if (std::size_t(surface.source(h)) < old.size()) ends.push_back(surface.source(h));
      is_unknown =
        is_unknown || (!surface.is_border(h) && !part_.is_known(segments_[surface.face(h)]));
    }
    if (!is_unknown || ends.size() != 2) return 0;
    const Point_3 middle = CGAL::midpoint(old[ends[0]], old[ends[1]]);
    return std::sqrt(CGAL::squared_distance(surface.point(v), middle));
  }

  Refined_surface refined_;
  const Recognized_part& part_;
  std::vector<std::size_t> segments_;
};

// How far the limit surface is from the faces of a level: measured at its vertices and at the middles of edges and faces,
// and between these as with a surface of second order.
class Distance_from_limit
{
public:
  // `before`: the level, `points` as they are written; a round later it is `after`, with the limits there
  Distance_from_limit(const Surface& before, const std::vector<Point_3>& points,
                      const Surface& after, const std::vector<std::uint32_t>& parents,
                      const std::vector<Point_3>& limits)
    : before_(before)
    , points_(points)
    , limits_(limits)
    , of_edge_(before.number_of_edges())
    , of_face_(before.number_of_faces())
  {
    for (const Surface::Face_index f : after.faces()) find_middles(after, f, parents[f]);
  }

  double operator()() const
  {
    Distances from_edges(before_.number_of_edges(), infinity),
      from_vertices(points_.size(), infinity);
    for (const Surface::Face_index f : before_.faces()) measure(f, from_edges, from_vertices);
    double largest = 0;
    for (const Surface::Face_index f : before_.faces())
      largest = (std::max)(largest, over(f, from_edges));
    for (const Vertex v : before_.vertices())
      if (!before_.is_isolated(v)) largest = (std::max)(largest, from_vertices[v]);
    return largest;
  }

private:
  using Triangle_3 = Kernel::Triangle_3;
  using Distances = std::vector<double>;
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  // The next vertex after an old one is on the edge, and of a quadrilateral the one opposite in the face.
  void find_middles(const Surface& after, Surface::Face_index f, std::uint32_t parent)
  {
    for (const auto h : halfedges_around_face(after.halfedge(f), after)) {
      if (std::size_t(after.target(h)) >= points_.size()) continue;
      const Surface::Face_index old(parent);
      for (const auto g : halfedges_around_face(before_.halfedge(old), before_))
        if (before_.source(g) == after.target(h))
          of_edge_[before_.edge(g)] = after.target(after.next(h));
      if (after.degree(f) == 4) of_face_[old] = after.target(after.next(after.next(h)));
    }
  }

  double distance(const Point_3& p, Vertex a, Vertex b, Vertex c) const
  {
    const Point_3 &p0 = points_[a], &p1 = points_[b], &p2 = points_[c];
    if (CGAL::cross_product(p1 - p0, p2 - p0).squared_length() > 0)
      return std::sqrt(CGAL::squared_distance(p, Triangle_3(p0, p1, p2)));
    return std::sqrt((std::min)(CGAL::squared_distance(p, Kernel::Segment_3(p0, p1)),
                                CGAL::squared_distance(p, Kernel::Segment_3(p0, p2))));
  }

  // A fan of triangles: triangle i has the corners first, first + i and first + i + 1.
  double from_fan(const std::vector<Vertex>& v, const Point_3& p, std::size_t first,
                  std::size_t begin, std::size_t end) const
  {
    const std::size_t n = v.size();
    double least = infinity;
    for (std::size_t i = begin; i < end; ++i)
      least = (std::min)(least, distance(p, v[first], v[(first + i) % n], v[(first + i + 1) % n]));
    return least;
  }
  double from_fan(const std::vector<Vertex>& v, const Point_3& p, std::size_t first) const
  {
    return from_fan(v, p, first, 1, v.size() - 1);
  }
  std::vector<Vertex> corners(Surface::Face_index f) const
  {
    std::vector<Vertex> v;
    for (const auto h : halfedges_around_face(before_.halfedge(f), before_))
      v.push_back(before_.target(h));
    return v;
  }

  // The distances of its edges and corners from a face. Of a large one the triangles beside them are looked at only,
  // since all would take the square of its size.
  void measure(Surface::Face_index f, Distances& from_edges, Distances& from_vertices) const
  {
    constexpr std::size_t large = 64;
    const std::vector<Vertex> v = corners(f);
    const std::size_t n = v.size();
    const auto from = [&](const Point_3& p, std::size_t i) {
      if (n <= large || i == 0) return from_fan(v, p, 0);
      return from_fan(v, p, 0, (std::max)(std::size_t(1), i - 1), (std::min)(n - 1, i + 1));
    };
    std::size_t i = 0;
    for (const auto h : halfedges_around_face(before_.halfedge(f), before_)) {
      double &of_edge = from_edges[before_.edge(h)], &of_vertex = from_vertices[v[i]];
      of_edge = (std::min)(of_edge, from(limits_[of_edge_[before_.edge(h)]], i));
      of_vertex = (std::min)(of_vertex, from(limits_[v[i]], i));
      ++i;
    }
  }

  // Both diagonals of quadrilaterals, since nobody knows which will be taken.
  double over(Surface::Face_index f, const Distances& from_edges) const
  {
    using CGAL::PN_subdivision_3::internal::flatness::over_triangle;
    std::vector<double> sides;
    for (const auto h : halfedges_around_face(before_.halfedge(f), before_))
      sides.push_back(from_edges[before_.edge(h)]);
    if (sides.size() == 3) return over_triangle(sides[0], sides[1], sides[2]);
    const Point_3& middle = limits_[of_face_[f]];
    const std::vector<Vertex> v = corners(f);
    const double over_middle = (std::max)(from_fan(v, middle, 0), from_fan(v, middle, 1));
    double largest = over_middle;
    for (const double side : sides) largest = (std::max)(largest, side);
    if (sides.size() != 4) return largest;
    for (const std::size_t i : {0u, 1u})
      largest = (std::max)({largest, over_triangle(sides[i], sides[i + 1], over_middle),
                            over_triangle(sides[i + 2], sides[(i + 3) % 4], over_middle)});
    return largest;
  }

  const Surface& before_;
  const std::vector<Point_3>&points_, &limits_;
  std::vector<Vertex> of_edge_, of_face_;
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

void require_faces(const Mesh_data& mesh, const Scheme_choice& scheme, unsigned rounds,
                   double chord)
{
  if (faces_after(mesh, scheme, rounds) > most_faces)
    refuse(chord, "2^31 faces, in " + std::to_string(rounds) + " rounds");
}

void require_chord_bound(const Surface_options& options)
{
  if (!options.chord_bound) return;
  const std::string& bound = *options.chord_bound;
  if (bound != "estimated" && bound != "proven")
    throw Usage_error("--chord-bound '" + bound + "': expected estimated or proven" +
                      did_you_mean(bound, {"estimated", "proven"}));
  if (!options.chord) throw Usage_error("--chord-bound needs --chord");
  if (bound == "proven" && options.auto_levels)
    throw Usage_error("--chord-bound proven and --levels auto exclude each other: distances of "
                      "uniformly refined meshes are measured");
}

} // namespace

std::optional<Box_length> parse_chord(const Surface_options& options)
{
  require_chord_bound(options);
  if (!options.chord) {
    if (options.auto_levels) throw Usage_error("--levels auto needs --chord");
    return std::nullopt;
  }
  const Box_length chord = parse_box_length(*options.chord, "--chord");
  if (!(chord.value > 0)) throw Usage_error("--chord " + *options.chord + ": it must be positive");
  const std::string& scheme = options.scheme.scheme;
  if (scheme == "sqrt3" || scheme == "doo-sabin")
    throw Usage_error("--chord and --scheme " + scheme +
                      " exclude each other: a round of that scheme halves no edge");
  if (options.has_levels && !options.auto_levels)
    throw Usage_error("--chord and --levels " + std::to_string(options.levels) +
                      " exclude each other: leave --levels out, or take --levels auto");
  return chord;
}

Chord_rounds rounds_for_chord(const Mesh_data& mesh, const Recognized_part& part,
                              const Creases& creases, const Scheme_choice& scheme, double chord,
                              unsigned threads)
{
  Chord_rounds result;
  result.rounds = rounds_of_surfaces(mesh, part, chord);
  if (has_unknown_faces(part)) {
    Unknown_segments unknown(Refined_surface(mesh, creases, scheme, threads), part);
    const Chord_rounds of_unknown = rounds_of_unknown(unknown, chord);
    result.estimate = std::ldexp(of_unknown.estimate,
                                 -2 * ((std::max)(0, int(result.rounds) - int(of_unknown.rounds))));
    result.rounds = (std::max)(result.rounds, of_unknown.rounds);
  }
  require_faces(mesh, scheme, result.rounds, chord);
  return result;
}

Chord_rounds rounds_for_chord(const Mesh_data& mesh, const Creases& creases,
                              const Scheme_choice& scheme, double chord, bool at_limits,
                              unsigned threads)
{
  constexpr std::size_t most_faces_measured = 1000000;
  Refined_surface refined(mesh, creases, scheme, threads);
  unsigned first = 0; // limits are known only of edges that are smooth or sharp forever
  for (const double s : creases.edges)
    if (!std::isinf(s)) first = (std::max)(first, static_cast<unsigned>(std::ceil(s)));
  double error = std::numeric_limits<double>::infinity(), factor = 0.25;
  for (unsigned k = 0;; ++k) {
    if (k > most_rounds) refuse(chord, std::to_string(most_rounds) + " rounds");
    require_faces(mesh, scheme, k, chord);
    const double before = error;
    if (refined.surface().number_of_faces() <= most_faces_measured) {
      const Surface level = refined.surface();
      const std::vector<Point_3> points =
        at_limits && k >= first ? refined.limits(k) : refined.points();
      const auto parents = refined.refine();
      if (k + 1 < first) continue;
      error = refined.length(
        Distance_from_limit(level, points, refined.surface(), parents, refined.limits(k + 1))());
      if (before > 0 && std::isfinite(before)) factor = (std::max)(0.25, error / before);
    } else
      error *= factor;
    if (error <= chord && k >= (at_limits ? first : 0)) return {k, error};
  }
}

} // namespace pn_subdivide

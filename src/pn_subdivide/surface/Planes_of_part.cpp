// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/Planes_of_part.h"

#include "io/Error.h"
#include "options.h"
#include "surface/creases.h"
#include "surface/refine_surface.h"

#include <CGAL/PN_recognition_3/triangulate_planes.h>
#include <CGAL/PN_subdivision_3/attributes.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <unordered_map>
#include <utility>

namespace pn_subdivide {
namespace {

constexpr std::size_t none = static_cast<std::size_t>(-1);

// How far some vertices of a mesh move if the others do: harmonically along its edges, which pull the more the shorter they are.
class Harmonic_moves
{
public:
  // is_free: whether a vertex is one of them; moves: of the others
  Harmonic_moves(const Surface& mesh, const std::vector<bool>& is_free, std::vector<Vector_3> moves)
    : moves_(std::move(moves))
    , number_(mesh.number_of_vertices(), none)
  {
    for (const Vertex v : mesh.vertices())
      if (is_free[v]) {
        number_[v] = vertices_.size();
        vertices_.push_back(v);
      }
    std::vector<Vector_3> pulls(vertices_.size(), CGAL::NULL_VECTOR);
    weights_of_.assign(vertices_.size(), 0);
    first_.push_back(0);
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      for (const auto h : CGAL::halfedges_around_target(mesh.halfedge(vertices_[i]), mesh)) {
        const Vertex w = mesh.source(h);
        const double squared = CGAL::squared_distance(mesh.point(vertices_[i]), mesh.point(w));
        const double weight = squared > 0 ? 1 / std::sqrt(squared) : 1;
        weights_of_[i] += weight;
        if (number_[w] != none)
          entries_.emplace_back(number_[w], weight);
        else
          pulls[i] += weight * moves_[w];
      }
      first_.push_back(entries_.size());
    }
    solve(pulls);
  }

  const std::vector<Vertex>& vertices() const { return vertices_; }
  const Vector_3& operator()(Vertex v) const { return moves_[v]; }

private:
  using Vectors = std::vector<Vector_3>;

  static double product(const Vectors& a, const Vectors& b)
  {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.);
  }
  Vectors applied(const Vectors& x) const
  {
    Vectors y;
    for (std::size_t i = 0; i < x.size(); ++i) {
      Vector_3 sum = weights_of_[i] * x[i];
      for (std::size_t k = first_[i]; k < first_[i + 1]; ++k)
        sum -= entries_[k].second * x[entries_[k].first];
      y.push_back(sum);
    }
    return y;
  }

  // by conjugate gradients
  void solve(Vectors rest)
  {
    constexpr double squared_tolerance = 1e-28;
    Vectors x(rest.size(), CGAL::NULL_VECTOR), scaled(rest), direction;
    const auto scale = [&] {
      for (std::size_t i = 0; i < rest.size(); ++i) scaled[i] = rest[i] / weights_of_[i];
    };
    scale();
    direction = scaled;
    double square = product(rest, scaled);
    const double end = squared_tolerance * square;
    for (std::size_t step = 0; square > end && step < 4 * rest.size(); ++step) {
      const Vectors image = applied(direction);
      const double length = square / product(direction, image);
      for (std::size_t i = 0; i < x.size(); ++i) {
        x[i] += length * direction[i];
        rest[i] -= length * image[i];
      }
      scale();
      const double next = product(rest, scaled);
      for (std::size_t i = 0; i < x.size(); ++i)
        direction[i] = scaled[i] + (next / square) * direction[i];
      square = next;
    }
    for (std::size_t i = 0; i < x.size(); ++i) moves_[vertices_[i]] = x[i];
  }

  Vectors moves_;
  std::vector<std::size_t> number_, first_;
  std::vector<Vertex> vertices_;
  std::vector<std::pair<std::size_t, double>> entries_;
  std::vector<double> weights_of_;
};

// The first corner of each vertex in a segment, and its face.
class First_corners
{
public:
  First_corners(const Mesh_data& mesh, const std::vector<std::size_t>& segments,
                const std::vector<bool>& is_wanted)
  {
    for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
      if (!is_wanted[segments[f]]) continue;
      std::size_t corner = mesh.first_corner(f);
      for (const Index v : mesh.face(f)) of_.emplace(key(segments[f], v), Place{corner++, f});
    }
  }
  struct Place
  {
    std::size_t corner, face;
  };
  const Place& at(std::size_t segment, Index v) const { return of_.at(key(segment, v)); }

private:
  static std::uint64_t key(std::size_t segment, Index v)
  {
    return (static_cast<std::uint64_t>(segment) << 32) | v;
  }
  std::unordered_map<std::uint64_t, Place> of_;
};

// Vertices that had faces and have none any more go; the others keep their order.
std::vector<Index> kept_vertices(const Mesh_data& mesh, const Mesh_data& faces)
{
  std::vector<bool> had(mesh.points.size(), false), has(mesh.points.size(), false);
  for (const Index v : mesh.vertices_of_corners()) had[v] = true;
  for (const Index v : faces.vertices_of_corners()) has[v] = true;
  std::vector<Index> kept;
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    if (has[v] || !had[v]) kept.push_back(static_cast<Index>(v));
  return kept;
}

void select_vertices(Mesh_data& mesh, const std::vector<Index>& kept)
{
  std::vector<Index> numbers(mesh.points.size(), 0);
  for (std::size_t i = 0; i < kept.size(); ++i) numbers[kept[i]] = static_cast<Index>(i);
  mesh.renumber_vertices(numbers);
  for (Corner_normal& n : mesh.several_normals) n.vertex = numbers[n.vertex];
  select(mesh.points, kept);
  select(mesh.normals, kept);
  select(mesh.roundness, kept);
  select(mesh.attributes.of_vertices, kept);
}

void select_corners(Mesh_data& mesh, const std::vector<std::size_t>& corners)
{
  select(mesh.corner_normals, corners);
  select(mesh.corner_roundness, corners);
  select(mesh.attributes.texture, corners);
  std::unordered_map<std::size_t, const Corner_normal*> old;
  for (const Corner_normal& n : mesh.several_normals) old.emplace(n.corner, &n);
  std::vector<Corner_normal> several;
  for (std::size_t c = 0; c < corners.size() && !old.empty(); ++c) {
    const auto found = old.find(corners[c]);
    if (found == old.end()) continue;
    several.push_back(*found->second);
    several.back().corner = c;
  }
  mesh.several_normals = std::move(several);
}

} // namespace

Planes_of_part::Planes_of_part(const Surface& control, const Recognized_part& part)
  : control_(control)
  , part_(part)
{
  remove_normals_and_roundness(control_);
  was_crossed_ = crossed(control_, std::vector<double>(part.segments.begin(), part.segments.end()));
}

void Planes_of_part::place_inside(Surface& refined, const std::vector<double>& parents,
                                  const Scheme_choice& scheme, unsigned levels) const
{
  std::vector<bool> is_inside(refined.number_of_vertices(), false);
  for (const Vertex v : refined.vertices()) {
    if (refined.is_isolated(v) || refined.is_border(v)) continue;
    const auto segment_at = [&](Halfedge h) {
      return part_.segments[std::size_t(parents[refined.face(h)])];
    };
    const std::size_t segment = segment_at(refined.halfedge(v));
    is_inside[v] = part_.surfaces[segment].kind == Recognized_surface::Kind::plane;
    for (const auto h : CGAL::halfedges_around_target(refined.halfedge(v), refined))
      is_inside[v] = is_inside[v] && segment_at(h) == segment;
  }
  if (std::none_of(is_inside.begin(), is_inside.end(), [](bool is) { return is; })) return;
  Surface even = control_;
  Creases all; // sharp
  constexpr double infinity = std::numeric_limits<double>::infinity();
  all.edges.assign(even.number_of_edges(), infinity);
  all.vertices.assign(even.number_of_vertices(), infinity);
  all.count();
  PN::Attribute_table no_attributes;
  refine_surface(even, scheme, {levels, add_creases(even, all), nullptr, &no_attributes, {}});
  std::vector<Vector_3> moves;
  for (const Vertex v : refined.vertices())
    moves.push_back(is_inside[v] ? CGAL::NULL_VECTOR : refined.point(v) - even.point(v));
  const Harmonic_moves move(even, is_inside, std::move(moves));
  for (const Vertex v : move.vertices()) refined.point(v) = even.point(v) + move(v);
}

std::vector<bool> Planes_of_part::crossed(const Surface& surface,
                                          const std::vector<double>& segments) const
{
  std::vector<bool> result(part_.surfaces.size(), false);
  const std::vector<std::size_t> numbers(segments.begin(), segments.end());
  for (const auto& plane : PN::triangulate_planes(surface, Segment_map{&numbers}, part_.surfaces))
    result[plane.surface] = !plane.is_triangulated;
  return result;
}

std::size_t Planes_of_part::number_of_crossed(const Surface& refined,
                                              const std::vector<double>& segments) const
{
  const std::vector<bool> now = crossed(refined, segments);
  std::size_t number = 0;
  for (std::size_t s = 0; s < now.size(); ++s) number += now[s] && !was_crossed_[s] ? 1 : 0;
  return number;
}

void require_options_for_planes(const Surface_options& options)
{
  if (!options.planes) return;
  if (*options.planes != "rims")
    throw Usage_error("--planes '" + *options.planes + "': expected rims");
  if (!wants_surfaces(options.creases))
    throw Usage_error("--planes rims needs --sharp surfaces or --part");
}

bool takes_planes_from_rims(const Surface_options& options, const Output_normals& normals)
{
  return options.planes || (wants_surfaces(options.creases) && options.levels > 0 &&
                            !are_tags_written(options, normals));
}

Planes_from_rims::Planes_from_rims(const Surface& surface, const std::vector<double>& segments,
                                   const Recognized_part& part)
  : segment_(segments.begin(), segments.end())
  , is_replaced_(part.surfaces.size(), false)
{
  for (const auto& plane : PN::triangulate_planes(surface, Segment_map{&segment_}, part.surfaces)) {
    ++(plane.is_triangulated ? replaced_planes_ : kept_planes_);
    is_replaced_[plane.surface] = plane.is_triangulated;
    for (const auto& t : plane.triangles) {
      triangles_.push_back({Index(t[0]), Index(t[1]), Index(t[2])});
      segment_of_triangle_.push_back(plane.surface);
    }
  }
  for (const std::size_t s : segment_) replaced_faces_ += is_replaced_[s];
}

void Planes_from_rims::put_into(Mesh_data& mesh) const
{
  Mesh_data now;                           // the faces
  std::vector<std::size_t> corners, faces; // what each has been
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
    if (is_replaced_[segment_[f]]) continue;
    now.add_face(mesh.face(f));
    faces.push_back(f);
    for (std::size_t i = 0; i < mesh.face(f).size(); ++i)
      corners.push_back(mesh.first_corner(f) + i);
  }
  const First_corners old(mesh, segment_, is_replaced_);
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    const std::size_t segment = segment_of_triangle_[t];
    now.add_face(triangles_[t]);
    faces.push_back(old.at(segment, triangles_[t][0]).face);
    for (const Index v : triangles_[t]) corners.push_back(old.at(segment, v).corner);
  }
  const std::vector<Index> kept = kept_vertices(mesh, now);
  select_corners(mesh, corners);
  select(mesh.attributes.of_faces, faces);
  mesh.take_faces(now);
  select_vertices(mesh, kept);
}

void Planes_from_rims::report(const std::string& output, Report& report) const
{
  report.note(output + ": " + plural(replaced_planes_, "plane", "planes") + " of " +
              plural(replaced_faces_, "face", "faces") + " made of " +
              plural(triangles_.size(), "triangle", "triangles") + " between their rims");
  if (kept_planes_ > 0)
    report.warn(output + ": " + plural(kept_planes_, "plane", "planes") +
                (kept_planes_ == 1 ? " keeps its faces: its" : " keep their faces: their") +
                " rims cross or touch each other");
}

} // namespace pn_subdivide

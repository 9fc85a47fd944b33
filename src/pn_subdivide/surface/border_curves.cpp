// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/Recognized_part.h"
#include "surface/Surface.h"
#include "surface/creases.h"

#include <CGAL/PN_recognition_3/recognize_arcs.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

namespace pn_subdivide {
namespace {

constexpr double forever = std::numeric_limits<double>::infinity();

// Vertices are those of which they are copies; curves are of edges that there are several times.
class Common_curves
{
public:
  Common_curves(const Surface& surface, const Mesh_data& mesh)
    : surface_(surface)
    , mesh_(mesh)
    , is_corner_(mesh.points.size(), false)
  {
    std::vector<bool> has_copies(mesh.points.size(), false);
    for (const Index v : mesh.copied_from) has_copies[mesh.original(v)] = true;
    std::map<std::pair<Index, Index>, std::vector<Edge>> copies;
    for (const Edge e : surface.edges()) {
      const Halfedge h = surface.halfedge(e, 0);
      const Index v = original(surface.source(h)), w = original(surface.target(h));
      if (has_copies[v] && has_copies[w]) copies[std::minmax({v, w})].push_back(e);
    }
    for (const auto& [ends, edges] : copies) {
      if (edges.size() < 2) continue;
      edges_.insert(edges_.end(), edges.begin(), edges.end());
      neighbors_[ends.first].push_back(ends.second);
      neighbors_[ends.second].push_back(ends.first);
    }
  }

  bool any() const { return !edges_.empty(); }

  // the original of a vertex on such a curve, or null
  const Index* find(Index v) const
  {
    const auto it = neighbors_.find(mesh_.original(v));
    return it == neighbors_.end() ? nullptr : &it->first;
  }

  void put(Creases& creases)
  {
    creases.edges.resize(surface_.number_of_edges(), 0.);
    creases.vertices.resize(surface_.number_of_vertices(), 0.);
    creases.tangents.resize(surface_.number_of_halfedges(), CGAL::NULL_VECTOR);
    for (const Edge e : edges_) creases.edges[e] = forever;
    for (const Edge e : edges_)
      for (const int side : {0, 1})
        find_corner(creases, surface_.source(surface_.halfedge(e, side)));
    const bool is_straight = creases.border == Border::fixed;
    for (const Edge e : edges_)
      for (const int side : {0, 1}) {
        const Halfedge h = surface_.halfedge(e, side);
        const Vertex v = surface_.source(h);
        const Index from = original(v), to = original(surface_.target(h));
        if (is_corner_[from]) creases.vertices[v] = forever;
        creases.tangents[h] = tangent(from, to, is_straight);
      }
  }

private:
  Index original(Vertex v) const { return mesh_.original(Index(v)); }
  const std::vector<Index>& neighbors(Index v) const { return neighbors_.at(v); }

  // where a copy has no crease through it
  void find_corner(const Creases& creases, Vertex v)
  {
    const bool is_at_border = surface_.is_border(v);
    std::size_t ends = 0;
    for (const Halfedge h : CGAL::halfedges_around_target(v, surface_)) {
      const Edge e = surface_.edge(h);
      ends += creases.edges[e] > 0 || (creases.border != Border::surface && surface_.is_border(e));
    }
    if (ends != 2 || neighbors(original(v)).size() != 2 || creases.vertices[v] > 0 ||
        (is_at_border && (creases.border == Border::corners || creases.border == Border::fixed)))
      is_corner_[original(v)] = true;
  }

  // from v, over the square of the distance: an inversion, in which circles through v are lines
  Vector_3 inverse(Index v, Index w) const
  {
    const Vector_3 d = to_point(mesh_.points[w]) - to_point(mesh_.points[v]);
    return d.squared_length() > 0 ? d / d.squared_length() : CGAL::NULL_VECTOR;
  }

  // at v, on the way to w, of the circle through three points in a row; straight between corners
  Vector_3 tangent(Index v, Index w, bool is_straight) const
  {
    const Vector_3 along = inverse(v, w);
    Vector_3 t = along;
    if (!is_corner_[v])
      t = along - inverse(v, other_neighbor(v, w));
    else if (!is_corner_[w] && !is_straight)
      t = along - inverse(v, other_neighbor(w, v));
    const double length = std::sqrt(t.squared_length());
    if (!(length > 0)) return CGAL::NULL_VECTOR;
    return (t * along < 0 ? -1 : 1) / length * t;
  }
  Index other_neighbor(Index v, Index w) const
  {
    const std::vector<Index>& both = neighbors(v);
    return both[0] == w ? both[1] : both[0];
  }

  const Surface& surface_;
  const Mesh_data& mesh_;
  std::vector<Edge> edges_;
  std::map<Index, std::vector<Index>> neighbors_;
  std::vector<bool> is_corner_;
};

using Loop = std::vector<Halfedge>; // half-edges of the border in a row

Vector_3 unit(const Vector_3& v)
{
  const double length = std::sqrt(v.squared_length());
  return length > 0 ? v / length : CGAL::NULL_VECTOR;
}

class Part_borders
{
public:
  Part_borders(const Surface& surface, const Recognized_part& part, Creases& creases)
    : surface_(surface)
    , part_(part)
    , creases_(creases)
  {}

  void operator()()
  {
    std::vector<bool> is_done(surface_.number_of_halfedges(), false);
    for (const Halfedge first : surface_.halfedges()) {
      if (!surface_.is_border(first) || is_done[first]) continue;
      Loop loop;
      for (Halfedge h = first; !is_done[h]; h = surface_.next(h)) {
        is_done[h] = true;
        loop.push_back(h);
      }
      split(loop);
    }
  }

private:
  Vector_3 direction(Halfedge h) const
  {
    return unit(surface_.point(surface_.target(h)) - surface_.point(surface_.source(h)));
  }
  std::size_t segment(Halfedge h) const
  {
    return part_.segments[surface_.face(surface_.opposite(h))];
  }
  bool is_of_plane(Halfedge h) const
  {
    return part_.surfaces[segment(h)].kind == Recognized_surface::Kind::plane;
  }
  void put_corner(Vertex v) { creases_.vertices[v] = forever; }

  // Does the border end where this half-edge begins, for another surface or at a corner?
  bool is_end(Halfedge before, Halfedge h) const
  {
    constexpr double cosine_of_61_degrees = 0.4848;
    if (is_of_plane(before) || is_of_plane(h)) return segment(before) != segment(h);
    return direction(before) * direction(h) < cosine_of_61_degrees;
  }

  void split(Loop loop)
  {
    const std::size_t n = loop.size();
    std::vector<std::size_t> ends;
    for (std::size_t i = 0; i < n; ++i)
      if (is_end(loop[(i + n - 1) % n], loop[i])) ends.push_back(i);
    if (ends.empty()) return put_piece(loop, true);
    for (std::size_t k = 0; k < ends.size(); ++k) {
      put_corner(surface_.source(loop[ends[k]]));
      Loop piece;
      const std::size_t end = k + 1 < ends.size() ? ends[k + 1] : ends[0] + n;
      for (std::size_t i = ends[k]; i < end; ++i) piece.push_back(loop[i % n]);
      put_piece(piece, false);
    }
  }

  void put_piece(const Loop& piece, bool closed)
  {
    if (!is_of_plane(piece.front())) return;
    std::vector<Point_3> points;
    for (const Halfedge h : piece) points.push_back(surface_.point(surface_.source(h)));
    if (!closed) points.push_back(surface_.point(surface_.target(piece.back())));
    try {
      const auto arcs =
        PN::recognize_arcs(points, closed ? PN::Curve_end::closed : PN::Curve_end::none);
      for (const PN::Recognized_arc& arc : arcs) put_arc(arc, piece, closed && arcs.size() == 1);
    } catch (const std::invalid_argument&) {
      // in no plane within the rounding of so few points
      for (const Halfedge h : piece) put_corner(surface_.source(h));
    }
  }

  void put_arc(const PN::Recognized_arc& arc, const Loop& piece, bool is_all)
  {
    const auto at = [&](std::size_t i) { return piece[i % piece.size()]; };
    if (!is_all) put_corner(surface_.source(at(arc.first)));
    for (std::size_t i = arc.first; i < arc.last; ++i) put_tangents(arc, at(i));
  }

  // along the edge from its ends
  void put_tangents(const PN::Recognized_arc& arc, Halfedge h)
  {
    if (arc.kind == PN::Recognized_arc::Kind::unknown) return;
    const Vector_3 along = direction(h);
    const bool is_line = arc.kind == PN::Recognized_arc::Kind::line;
    const auto tangent = [&](Vertex v) {
      const Vector_3 r = unit(surface_.point(v) - to_point(arc.center));
      return is_line ? along : tangent_of_circle(along, r, h);
    };
    creases_.tangents[h] = tangent(surface_.source(h));
    creases_.tangents[surface_.opposite(h)] = -tangent(surface_.target(h));
  }
  // in its plane, across the radius, the way of the edge
  Vector_3 tangent_of_circle(const Vector_3& along, const Vector_3& radius, Halfedge h) const
  {
    const auto& plane = part_.surfaces[segment(h)];
    const Vector_3 t = unit(CGAL::cross_product(to_vector(plane.direction), radius));
    return t * along < 0 ? -t : t;
  }

  const Surface& surface_;
  const Recognized_part& part_;
  Creases& creases_;
};

} // namespace

void put_common_curves(Creases& creases, const Mesh_data& mesh)
{
  if (mesh.copied_from.empty()) return;
  const Surface surface = make_surface(mesh);
  Common_curves curves(surface, mesh);
  if (!curves.any()) return;
  curves.put(creases);
  creases.count();
}

void share_roundness(Mesh_data& mesh)
{
  if (mesh.copied_from.empty() || mesh.roundness.empty()) return;
  const Surface surface = make_surface(mesh);
  const Common_curves curves(surface, mesh);
  if (!curves.any()) return;
  std::vector<double> least(mesh.roundness);
  for (Index v = 0; v < least.size(); ++v)
    if (const Index* first = curves.find(v))
      least[*first] = (std::min)(least[*first], mesh.roundness[v]);
  for (Index v = 0; v < least.size(); ++v)
    if (const Index* first = curves.find(v)) mesh.roundness[v] = least[*first];
  if (mesh.corner_roundness.empty()) return;
  for (std::size_t c = 0; c < mesh.number_of_corners(); ++c)
    if (const Index v = mesh.vertices_of_corners()[c]; curves.find(v) != nullptr)
      mesh.corner_roundness[c] = mesh.roundness[v];
}

void put_part_borders(Creases& creases, const Mesh_data& mesh, const Recognized_part& part)
{
  const Surface surface = make_surface(mesh);
  const auto halfedges = surface.halfedges();
  if (std::none_of(halfedges.begin(), halfedges.end(),
                   [&](Halfedge h) { return surface.is_border(h); }))
    return;
  creases.border = Border::curve;
  creases.tangents.assign(surface.number_of_halfedges(), CGAL::NULL_VECTOR);
  Part_borders(surface, part, creases)();
  creases.count();
}

} // namespace pn_subdivide

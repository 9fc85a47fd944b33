// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/common_curves.h"

#include "surface/Surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace pn_subdivide {
namespace {

using Index = Mesh_data::Index;
using Edge = Surface::Edge_index;
using Halfedge = Surface::Halfedge_index;

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
        const Surface::Vertex_index v = surface_.source(h);
        const Index from = original(v), to = original(surface_.target(h));
        if (is_corner_[from]) creases.vertices[v] = forever;
        creases.tangents[h] = tangent(from, to, is_straight);
      }
  }

private:
  Index original(Surface::Vertex_index v) const { return mesh_.original(Index(v)); }
  const std::vector<Index>& neighbors(Index v) const { return neighbors_.at(v); }

  // where a copy has no crease through it
  void find_corner(const Creases& creases, Surface::Vertex_index v)
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
  std::size_t corner = 0;
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    for (const Index v : mesh.face(f)) {
      if (curves.find(v) != nullptr) mesh.corner_roundness[corner] = mesh.roundness[v];
      ++corner;
    }
}

} // namespace pn_subdivide

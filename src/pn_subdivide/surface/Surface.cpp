// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/Surface.h"

#include "io/Error.h"
#include "io/mesh_normals.h"

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <limits>
#include <unordered_map>
#include <unordered_set>

namespace pn_subdivide {
namespace {

constexpr Index none = std::numeric_limits<Index>::max();
constexpr const char* normals_name = "v:normal";
constexpr const char* corner_normals_name = "h:normal";
constexpr const char* roundness_name = "v:roundness";

// The sides of all faces, numbered through; side i of a face goes from its vertex i to the next.
struct Side_list
{
  struct Side
  {
    Index source, target;
  };
  std::vector<Side> sides;
  std::vector<Index> across; // the side of the next face, or `none`

  explicit Side_list(const Mesh_data& mesh)
  {
    sides.reserve(mesh.number_of_corners());
    for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
      const Mesh_data::Face face = mesh.face(f);
      for (const Index& v : face)
        sides.push_back({v, &v + 1 == face.end() ? *face.begin() : *(&v + 1)});
    }
    across.assign(sides.size(), none);
    join(mesh.points.size());
  }

private:
  struct At_low_end
  {
    Index high, side;
  };

  // Each side is looked for among those whose end with the lower number is the same.
  void join(std::size_t number_of_vertices)
  {
    const auto low = [](const Side& s) { return (std::min)(s.source, s.target); };
    std::vector<std::size_t> end(number_of_vertices + 1, 0);
    for (const Side& s : sides) ++end[low(s) + std::size_t(1)];
    for (std::size_t v = 0; v < number_of_vertices; ++v) end[v + 1] += end[v];
    std::vector<At_low_end> by_low(sides.size());
    std::vector<std::size_t> place(end.begin(), end.end() - 1);
    for (std::size_t i = 0; i < sides.size(); ++i)
      by_low[place[low(sides[i])]++] = {(std::max)(sides[i].source, sides[i].target), Index(i)};
    for (std::size_t v = 0; v < number_of_vertices; ++v)
      join_equal(by_low.begin() + std::ptrdiff_t(end[v]),
                 by_low.begin() + std::ptrdiff_t(end[v + 1]));
  }

  template <class Iterator>
  void join_equal(Iterator begin, Iterator end)
  {
    std::sort(begin, end, [](const At_low_end& a, const At_low_end& b) {
      return a.high != b.high ? a.high < b.high : a.side < b.side;
    });
    for (Iterator i = begin; i != end && i + 1 != end; ++i) {
      const Index s = i->side, t = (i + 1)->side;
      if (i->high != (i + 1)->high) continue;
      if (across[s] != none || sides[s].source == sides[t].source)
        throw Error("the faces at the edge from vertex " + std::to_string(sides[t].source) +
                    " to " + std::to_string(sides[t].target) +
                    " do not fit into an oriented 2-manifold");
      across[s] = t;
      across[t] = s;
    }
  }
};

void require_room(const Mesh_data& mesh)
{
  if (mesh.number_of_corners() >= std::numeric_limits<Index>::max() / 2)
    throw Error("too large: the faces have " + std::to_string(mesh.number_of_corners()) +
                " corners, and CGAL's Surface_mesh numbers half-edges with 32 bits");
}

// Edges in the order in which the faces first come to them.
std::vector<Halfedge> add_edges(Surface& surface, const Side_list& list)
{
  std::vector<Halfedge> halfedge_of(list.sides.size());
  for (std::size_t i = 0; i < list.sides.size(); ++i) {
    const Index across = list.across[i];
    halfedge_of[i] =
      across < i ? surface.opposite(halfedge_of[across])
                 : surface.add_edge(Vertex(list.sides[i].source), Vertex(list.sides[i].target));
  }
  return halfedge_of;
}

void add_faces(Surface& surface, const Mesh_data& mesh, const std::vector<Halfedge>& halfedge_of)
{
  std::size_t first = 0;
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
    const auto size = static_cast<std::size_t>(mesh.face(f).size());
    const Face face = surface.add_face();
    Halfedge last = halfedge_of[first + size - 1];
    surface.set_halfedge(face, last);
    for (std::size_t i = first; i < first + size; ++i) {
      const Halfedge h = halfedge_of[i];
      surface.set_face(h, face);
      surface.set_next(last, h);
      surface.set_halfedge(surface.target(h), h); // at inner vertices that of the last face
      last = h;
    }
    first += size;
  }
}

// At each vertex of the border one half-edge of it ends and one begins.
void add_border(Surface& surface)
{
  std::vector<Halfedge> leaving(surface.num_vertices());
  for (const Halfedge h : surface.halfedges())
    if (surface.is_border(h)) leaving[surface.source(h)] = h;
  for (const Halfedge h : surface.halfedges()) {
    if (!surface.is_border(h)) continue;
    surface.set_next(h, leaving[surface.target(h)]);
    surface.set_halfedge(surface.target(h), h);
  }
}

// All but the points, in the order of to_mesh_data().
void put_values(Surface& surface, const Mesh_data& mesh)
{
  if (!mesh.roundness.empty()) {
    const Roundness_map roundness = add_roundness(surface);
    for (const Vertex v : surface.vertices()) roundness[v] = mesh.roundness[v];
  }
  if (!mesh.has_normals()) return;
  const Normal_map normals = add_normals(surface);
  for (const Vertex v : surface.vertices()) normals[v] = to_vector(mesh.normals[v]);
  if (mesh.corner_normals.empty() && mesh.corner_roundness.empty()) return;
  const Corner_normal_map of_corners = add_corner_normals(surface);
  std::size_t corner = 0;
  for (const Halfedge h : corners_of(surface)) {
    Corner_value& value = of_corners.values[h];
    if (!mesh.corner_normals.empty()) value.normal = to_vector(mesh.corner_normals[corner]);
    if (!mesh.corner_roundness.empty()) value.roundness = mesh.corner_roundness[corner];
    ++corner;
  }
}

// calls f(half-edge, value) for all corners of the wedges
template <class Function>
void for_each_corner_of(const Surface& surface, const Wedge_list& wedges, const Function& f)
{
  std::unordered_set<Index> begins;
  for (const auto& wedge : wedges) begins.insert(Index(wedge.first));
  for (const auto& [first, value] : wedges) {
    Halfedge h = first;
    do {
      f(h, value);
      h = surface.opposite(surface.next(h));
    } while (!surface.is_border(h) && begins.count(Index(h)) == 0);
  }
}

// The values of corners at vertices that have several.
class Values_of_several
{
public:
  Values_of_several(const Surface& surface, const Wedge_list& wedges)
    : has_several_(wedges.empty() ? 0 : surface.number_of_vertices(), false)
  {
    for_each_corner_of(surface, wedges, [&](Halfedge h, const Corner_value& value) {
      of_corner_.emplace(Index(h), value);
      has_several_[surface.target(h)] = true;
    });
  }
  bool at(Vertex v) const { return !has_several_.empty() && has_several_[v]; }
  // \pre at(the target)
  Corner_value operator()(Halfedge h, const Corner_value& of_vertex) const
  {
    const auto own = of_corner_.find(Index(h));
    return own == of_corner_.end() ? of_vertex : own->second;
  }

private:
  std::vector<bool> has_several_;
  std::unordered_map<Index, Corner_value> of_corner_;
};

} // namespace

Surface make_surface(const Mesh_data& mesh)
{
  require_room(mesh);
  Surface surface;
  surface.reserve(static_cast<Surface::size_type>(mesh.points.size()),
                  static_cast<Surface::size_type>(mesh.number_of_corners()),
                  static_cast<Surface::size_type>(mesh.number_of_faces()));
  for (const Triple& p : mesh.points) surface.add_vertex(to_point(p));
  const std::vector<Halfedge> halfedge_of = add_edges(surface, Side_list(mesh));
  add_faces(surface, mesh, halfedge_of);
  add_border(surface);
  put_values(surface, mesh);
  return surface;
}

std::optional<Normal_map> normals_of(const Surface& surface)
{
  return find_property_map<Vertex, Vector_3>(surface, normals_name);
}

std::optional<Roundness_map> roundness_of(const Surface& surface)
{
  return find_property_map<Vertex, double>(surface, roundness_name);
}

Roundness_map add_roundness(Surface& surface)
{
  Roundness_map roundness = surface.add_property_map<Vertex, double>(roundness_name, 1).first;
  for (const Vertex v : surface.vertices()) roundness[v] = 1;
  return roundness;
}

Normal_map add_normals(Surface& surface)
{
  return surface.add_property_map<Vertex, Vector_3>(normals_name, CGAL::NULL_VECTOR).first;
}

void remove_normals(Surface& surface)
{
  if (std::optional<Normal_map> normals = normals_of(surface))
    surface.remove_property_map(*normals);
  if (std::optional<Corner_normal_map> normals = corner_normals_of(surface))
    surface.remove_property_map(normals->values);
}

void remove_normals_and_roundness(Surface& surface)
{
  remove_normals(surface);
  if (std::optional<Roundness_map> roundness = roundness_of(surface))
    surface.remove_property_map(*roundness);
}

std::optional<Corner_normal_map> corner_normals_of(const Surface& surface)
{
  const auto values = find_property_map<Halfedge, Corner_value>(surface, corner_normals_name);
  return values ? std::optional<Corner_normal_map>(Corner_normal_map{*values}) : std::nullopt;
}

Corner_normal_map add_corner_normals(Surface& surface)
{
  const Normal_map of_vertices = *normals_of(surface);
  const std::optional<Roundness_map> roundness = roundness_of(surface);
  Corner_normal_map normals{
    surface.add_property_map<Halfedge, Corner_value>(corner_normals_name).first};
  for (const Halfedge h : surface.halfedges()) {
    const Vertex v = surface.target(h);
    normals.values[h] = {of_vertices[v], roundness ? (*roundness)[v] : 1};
  }
  return normals;
}

std::vector<Corner_value> take_corner_normals(Surface& surface)
{
  Corner_normal_map normals = corner_normals_or_added(surface);
  std::vector<Corner_value> result;
  for (const Halfedge h : surface.halfedges()) result.push_back(normals.values[h]);
  surface.remove_property_map(normals.values);
  return result;
}

void put_corner_normals(Surface& surface, const Wedge_list& wedges)
{
  const Corner_normal_map normals = add_corner_normals(surface);
  for_each_corner_of(surface, wedges,
                     [&](Halfedge h, const Corner_value& value) { normals.put_whole(h, value); });
}

std::vector<Halfedge> corners_of(const Surface& surface)
{
  std::vector<Halfedge> corners;
  corners.reserve(surface.number_of_halfedges());
  for (const Face f : surface.faces())
    for (const Halfedge h : halfedges_around_face(surface.halfedge(f), surface))
      corners.push_back(h);
  return corners;
}

Mesh_data to_mesh_data(const Surface& surface, const Wedge_list& wedges)
{
  Mesh_data mesh;
  mesh.points.reserve(surface.number_of_vertices());
  for (const Vertex v : surface.vertices()) mesh.points.push_back(to_triple(surface.point(v)));
  const std::optional<Normal_map> normals = normals_of(surface);
  if (normals) {
    mesh.normals.reserve(surface.number_of_vertices());
    for (const Vertex v : surface.vertices()) mesh.normals.push_back(to_triple((*normals)[v]));
  }

  const std::optional<Roundness_map> roundness = roundness_of(surface);
  if (roundness)
    for (const Vertex v : surface.vertices()) mesh.roundness.push_back((*roundness)[v]);

  mesh.reserve_faces(surface.number_of_faces(), surface.number_of_halfedges());
  const std::optional<Corner_normal_map> corner_normals = corner_normals_of(surface);
  const Values_of_several of_several(surface, wedges);
  std::vector<Corner_normal> several;
  std::vector<Index> face;
  for (const Face f : surface.faces()) {
    face.clear();
    for (const Halfedge h : halfedges_around_face(surface.halfedge(f), surface)) {
      const Vertex v = surface.target(h);
      if (corner_normals) {
        mesh.corner_normals.push_back(to_triple((*corner_normals)[h]));
        mesh.corner_roundness.push_back(corner_normals->values[h].roundness);
      }
      if (of_several.at(v)) {
        const Corner_value value = of_several(h, {(*normals)[v], roundness ? (*roundness)[v] : 1});
        several.push_back({mesh.number_of_corners() + face.size(), static_cast<Index>(v),
                           to_triple(value.normal), value.roundness});
        if (roundness) mesh.roundness[v] = (std::min)(mesh.roundness[v], value.roundness);
      }
      face.push_back(static_cast<Index>(v));
    }
    mesh.add_face(face);
  }
  if (corner_normals) set_vertex_normals(mesh);
  set_vertex_roundness(mesh);
  if (!several.empty()) set_several_normals(mesh, std::move(several));
  return mesh;
}

} // namespace pn_subdivide

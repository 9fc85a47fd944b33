// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_CREASES_H
#define PN_SUBDIVIDE_CREASES_H

#include "io/Mesh_data.h"
#include "io/Report.h"
#include "io/mesh_io.h"
#include "surface/Surface.h"
#include "surface/surface_schemes.h"

#include <CGAL/PN_subdivision_3/parameters/parameters.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pn_subdivide {

struct Crease_options;

// How --sharp surfaces looks for surfaces, as --min-facets, --surface-tolerance and --sharp-angle say it.
struct Recognition_plan
{
  unsigned min_facets = 8;
  std::optional<double> tolerance; // without: of the rounding of the file
  double sharp_angle = 30;         // in degrees
  bool tries_tolerances = true;    // whether another one recognizes more

  // Throws Usage_error, also if the options are given without --sharp surfaces.
  static Recognition_plan make(const Crease_options& options);
};

bool wants_surfaces(const Crease_options& options);

using Border = PN::Border;

// What is to be sharp, as --sharp, --sharpness and --border say it.
struct Crease_plan
{
  enum class Source { automatic, none, normals, angle, selection, surfaces };

  Source source = Source::automatic;
  double degrees = 0;  // of an angle
  std::string file;    // of a selection
  Selection selection; // what is in it
  double sharpness = std::numeric_limits<double>::infinity();
  bool has_sharpness = false;
  Border border = Border::surface;
  Recognition_plan recognition; // of surfaces

  // Throws Usage_error, and Error if the file of a selection cannot be read.
  static Crease_plan make(const Crease_options& options);

  // Throws Usage_error if the plan needs rules for creases that the schemes do not have. Without a
  // name the scheme is one that has.
  void require_schemes(const Crease_options& options, const Scheme_choice& choice) const;
};

// Of the mesh without edges whose sharpness is less than 1, where these have estimated normals beside them: what an edge leads
// to as its sharpness goes to 0. By half-edge; the roundness may be that of the mesh.
struct Normals_without_fractions
{
  std::vector<Corner_value> values;
  bool has_roundness;
};

// What is sharp in a mesh.
struct Creases
{
  std::vector<double> edges, vertices; // sharpness, by the numbers of make_surface()
  std::size_t number_of_edges = 0, number_of_vertices = 0; // that are sharp
  Border border = Border::surface;
  bool are_by_normals = false;    // edges: where the normals of the file differ
  std::vector<Vector_3> tangents; // by half-edge, from its source; or empty
  std::size_t number_of_close_edges =
    0;                // whose angle is within a degree of the one that was asked for
  double degrees = 0; // that angle
  std::shared_ptr<Normals_without_fractions> without_fractions; // if there are any

  void count(); // what is sharp
  bool any() const { return number_of_edges + number_of_vertices > 0; }
  bool is_sharp(Edge e) const { return !edges.empty() && edges[e] > 0; }
  std::string description() const; // empty, or for the closing line: ", 14 sharp edges"
};

struct Recognized_part;

// Those between recognized surfaces.
void put_surface_creases(Creases& creases, const Mesh_data& mesh, const Recognized_part& part);

// Warns if nothing is sharp although it was asked for, and if there are normals for creases that are
// none; `scheme` is the scheme without rules for creases, or empty, `part` what was recognized if
// surfaces were asked for. Throws Error.
Creases find_creases(const Mesh_data& mesh, const Crease_plan& plan, const std::string& scheme,
                     const Recognized_part* part, const std::string& name, Report& report);

using Edge_sharpness = Surface::Property_map<Edge, double>;
using Vertex_sharpness = Surface::Property_map<Vertex, double>;

// The tangents of creases, from the source of a half-edge along it. Without a map none are given, and those
// that are got are dropped.
struct Crease_tangents
{
  using key_type = Halfedge;
  using value_type = Vector_3;
  using reference = Vector_3;
  using category = boost::read_write_property_map_tag;

  std::optional<Surface::Property_map<Halfedge, Vector_3>> map;

  friend Vector_3 get(const Crease_tangents& t, key_type h)
  {
    return t.map ? (*t.map)[h] : Vector_3(0, 0, 0);
  }
  friend void put(const Crease_tangents& t, key_type h, const Vector_3& v)
  {
    if (t.map) (*t.map)[h] = v;
  }
};

struct Crease_maps
{
  Edge_sharpness edges;
  Vertex_sharpness vertices;
  Border border;
  Crease_tangents tangents;
  std::shared_ptr<const Normals_without_fractions> without_fractions = nullptr;
};
// What is sharp in a surface whose vertices are numbered as they are written. With a border that is a crease,
// also that.
Crease_tags tags_of(const Surface& surface, const Crease_maps& maps);
// with_tangents: whether there is a map of them, for what goes on from the refined mesh
Crease_maps add_creases(Surface& surface, const Creases& creases, bool with_tangents = false);
void remove_creases(Surface& surface, Crease_maps& maps);
// whether edges are, by the maps; of none without them
std::vector<bool> sharp_edges_of(const Surface& surface);
// the maps of a copy
std::optional<Crease_maps> creases_of(const Surface& copy, const std::optional<Crease_maps>& maps);

// Copies that were made of edges of more than two faces become creases with the same tangents, and with corners where one of
// them has a corner: the sheets keep one curve, which they would leave each by its own normals.
void put_common_curves(Creases& creases, const Mesh_data& mesh);

// The other half of that, when the roundness is known: the least of the copies is that of all.
void share_roundness(Mesh_data& mesh);

// Borders of a part that is open become curves: lines and arcs where they are those of planes, with corners between them, and
// elsewhere with corners where they turn by more than arcs do.
void put_part_borders(Creases& creases, const Mesh_data& mesh, const Recognized_part& part);

// The wedges of all vertices: runs of faces round a vertex between sharp edges and border edges.
struct Wedges
{
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  std::vector<std::size_t> of_corner; // of the face of a half-edge at its target; by half-edge
  std::vector<Vertex> vertex;         // of each wedge
  std::vector<std::size_t> number;    // at each vertex

  // `is_sharp(edge)`
  template <class Is_sharp>
  Wedges(const Surface& surface, const Is_sharp& is_sharp)
    : of_corner(surface.number_of_halfedges(), none)
    , number(surface.number_of_vertices(), 0)
  {
    for (const Halfedge h : surface.halfedges()) {
      if (surface.is_border(h) || of_corner[h] != none) continue;
      fill(surface, is_sharp, h);
      ++number[surface.target(h)];
      vertex.push_back(surface.target(h));
    }
  }

private:
  // Both ways round the vertex.
  template <class Is_sharp>
  void fill(const Surface& surface, const Is_sharp& is_sharp, Halfedge first)
  {
    const auto is_new = [&](Halfedge h) { return !surface.is_border(h) && of_corner[h] == none; };
    Halfedge h = first;
    of_corner[h] = vertex.size();
    while (!is_sharp(surface.edge(surface.next(h)))) {
      h = surface.opposite(surface.next(h));
      if (!is_new(h)) break;
      of_corner[h] = vertex.size();
    }
    for (h = first; !is_sharp(surface.edge(h)) && !surface.is_border(surface.opposite(h));) {
      h = surface.prev(surface.opposite(h));
      if (!is_new(h)) break;
      of_corner[h] = vertex.size();
    }
  }
};

// What take_corner_normals() takes, by half-edge, and that without edges that hardly are sharp.
struct Control_corner_normals
{
  Control_corner_normals(const std::vector<Corner_value>& of_corners,
                         std::shared_ptr<const Normals_without_fractions> of_others)
    : values(&of_corners)
    , roundness(&of_corners)
    , without_fractions(std::move(of_others))
  {
    if (without_fractions && without_fractions->values.size() != of_corners.size())
      without_fractions = nullptr; // those of the control mesh
  }

  using key_type = Halfedge;
  using value_type = Vector_3;
  using reference = const Vector_3&;
  using category = boost::readable_property_map_tag;

  static constexpr bool goes_with_roundness = true;

  Corner_value whole(key_type h) const { return {(*values)[h].normal, (*roundness)[h].roundness}; }
  friend const Vector_3& get(const Control_corner_normals& n, key_type h)
  {
    return (*n.values)[h].normal;
  }
  friend Control_corner_normals normals_without_fractions(Control_corner_normals n)
  {
    if (!n.without_fractions) return n;
    n.values = &n.without_fractions->values;
    if (n.without_fractions->has_roundness) n.roundness = n.values;
    return n;
  }
  const std::vector<Corner_value>*values, *roundness; // these of those
  std::shared_ptr<const Normals_without_fractions> without_fractions;
};

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_CREASES_H

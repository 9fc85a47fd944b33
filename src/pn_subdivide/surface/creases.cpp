// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/creases.h"

#include "io/Error.h"
#include "io/corner_normals.h"

#include <CGAL/PN_subdivision_3/detect_creases.h>

#include <algorithm>
#include <utility>

namespace pn_subdivide {
namespace {

using Index = Mesh_data::Index;
using Edge = Surface::Edge_index;
using Vertex = Surface::Vertex_index;
using Source = Crease_plan::Source;

std::string plural(std::size_t n, const std::string& one, const std::string& many)
{
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

// --- by the normals of the file ---

bool differ(const Vector_3& m, const Vector_3& n)
{
  return m != CGAL::NULL_VECTOR && n != CGAL::NULL_VECTOR &&
         directions_differ(to_triple(m), to_triple(n));
}

// Do the normals of the two faces of an edge differ at one of its ends?
std::vector<bool> edges_where_normals_differ(const Surface& surface)
{
  std::vector<bool> result(surface.number_of_edges(), false);
  const std::optional<Corner_normal_map> normals = corner_normals_of(surface);
  if (!normals) return result;
  for (const Edge e : surface.edges()) {
    if (surface.is_border(e)) continue;
    const auto h = surface.halfedge(e), g = surface.opposite(h);
    result[e] = differ((*normals)[h], (*normals)[surface.prev(g)]) ||
                differ((*normals)[g], (*normals)[surface.prev(h)]);
  }
  return result;
}

// --- of a selection ---

class Selected
{
public:
  Selected(const Mesh_data& mesh, const Crease_plan& plan)
    : mesh_(mesh)
    , plan_(plan)
    , copies_begin_(mesh.points.size() - mesh.copied_from.size())
  {}

  std::vector<bool> edges(const Surface& surface) const
  {
    using Pair = std::pair<Index, Index>;
    const auto ordered = [](Index a, Index b) { return Pair((std::min)(a, b), (std::max)(a, b)); };
    std::vector<Pair> wanted;
    for (const auto& [a, b] : plan_.selection.edges)
      wanted.push_back(ordered(number_now(a), number_now(b)));
    std::vector<Pair> sorted = wanted;
    std::sort(sorted.begin(), sorted.end());

    std::vector<bool> result(surface.number_of_edges(), false);
    std::vector<Pair> found;
    for (const Edge e : surface.edges()) {
      const Pair ends = ordered(original(surface.vertex(e, 0)), original(surface.vertex(e, 1)));
      result[e] = std::binary_search(sorted.begin(), sorted.end(), ends);
      if (result[e]) found.push_back(ends);
    }
    std::sort(found.begin(), found.end());
    for (std::size_t i = 0; i < wanted.size(); ++i)
      if (!std::binary_search(found.begin(), found.end(), wanted[i]))
        throw Error(plan_.file + ": the mesh has no edge between the vertices " +
                    std::to_string(plan_.selection.edges[i][0]) + " and " +
                    std::to_string(plan_.selection.edges[i][1]));
    return result;
  }

  std::vector<bool> vertices() const
  {
    std::vector<bool> wanted(copies_begin_, false), result(mesh_.points.size());
    for (const std::int64_t v : plan_.selection.vertices) wanted[number_now(v)] = true;
    for (std::size_t v = 0; v < result.size(); ++v) result[v] = wanted[original(Vertex(Index(v)))];
    return result;
  }

private:
  Index number_now(std::int64_t v) const
  {
    const std::size_t in_file =
      mesh_.merged_into.empty() ? copies_begin_ : mesh_.merged_into.size();
    if (v < 0 || static_cast<std::uint64_t>(v) >= in_file)
      throw Error(plan_.file + ": vertex " + std::to_string(v) + " is out of range, the mesh has " +
                  plural(in_file, "vertex", "vertices"));
    const auto i = static_cast<std::size_t>(v);
    return mesh_.merged_into.empty() ? static_cast<Index>(i) : mesh_.merged_into[i];
  }

  Index original(Vertex vertex) const
  {
    std::size_t v = vertex;
    while (v >= copies_begin_) v = mesh_.copied_from[v - copies_begin_];
    return static_cast<Index>(v);
  }

  const Mesh_data& mesh_;
  const Crease_plan& plan_;
  std::size_t copies_begin_; // the vertices that are copies are behind the others
};

std::vector<bool> edges_of_angle(Surface& surface, double degrees, Creases& creases)
{
  const auto map = surface.add_property_map<Edge, bool>("e:is_sharp", false).first;
  const auto number_above = [&](double angle) {
    constexpr double margin = 0.1; // that detect_creases() adds
    if (angle >= margin)
      return CGAL::PN_subdivision_3::detect_creases(surface, (std::min)(angle - margin, 180.), map);
    const auto all = surface.edges();
    return std::size_t(
      std::count_if(all.begin(), all.end(), [&](Edge e) { return !surface.is_border(e); }));
  };
  constexpr double close = 1 + 1e-6; // angles in whole degrees count whatever their rounding
  creases.degrees = degrees;
  creases.number_of_close_edges = number_above(degrees - close) - number_above(degrees + close);
  CGAL::PN_subdivision_3::detect_creases(surface, degrees, map);
  std::vector<bool> result;
  for (const Edge e : surface.edges()) result.push_back(map[e]);
  return result;
}

// Edges have the sharpness of the options, vertices are corners for ever.
void set_sharpness(Creases& creases, const std::vector<bool>& edges,
                   const std::vector<bool>& vertices, double of_edges)
{
  creases.edges.assign(edges.size(), 0.);
  for (std::size_t e = 0; e < edges.size(); ++e)
    if (edges[e] && of_edges > 0) {
      creases.edges[e] = of_edges;
      ++creases.number_of_edges;
    }
  creases.vertices.assign(vertices.size(), 0.);
  for (std::size_t v = 0; v < vertices.size(); ++v)
    if (vertices[v]) {
      creases.vertices[v] = std::numeric_limits<double>::infinity();
      ++creases.number_of_vertices;
    }
}

bool has_border(const Surface& surface)
{
  const auto edges = surface.edges();
  return std::any_of(edges.begin(), edges.end(), [&](Edge e) { return surface.is_border(e); });
}

// As few digits as it takes.
std::string short_number(double x)
{
  std::string text = std::to_string(x);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

} // namespace

std::string Creases::description() const
{
  std::string s;
  if (number_of_edges > 0) {
    s += ", " + plural(number_of_edges, "sharp edge", "sharp edges");
    const double sharpness = *std::max_element(edges.begin(), edges.end());
    if (sharpness < std::numeric_limits<double>::infinity())
      s += " of sharpness " + short_number(sharpness);
  }
  if (number_of_close_edges > 0)
    s += ", " + plural(number_of_close_edges, "edge", "edges") + " within 1 degree of " +
         short_number(degrees);
  if (number_of_vertices > 0) s += ", " + plural(number_of_vertices, "corner", "corners");
  if (border == Border::curve) s += ", the border a curve";
  if (border == Border::corners) s += ", the border a curve with corners";
  if (border == Border::fixed) s += ", the border fixed";
  return s;
}

Creases find_creases(const Mesh_data& mesh, const Crease_plan& plan, const std::string& scheme,
                     const std::string& name, Report& report)
{
  Creases creases;
  creases.border = plan.border;
  const bool by_normals = plan.source == Source::automatic || plan.source == Source::normals;
  const bool can_be_sharp =
    scheme.empty() && plan.source != Source::none && (!by_normals || mesh.has_corner_normals());
  if (plan.source == Source::normals && !mesh.has_normals())
    throw Error("--sharp file, but the file has no normals, and without normals of its corners it "
                "says nothing of creases");
  if (!can_be_sharp && plan.border == Border::surface) {
    if (plan.source == Source::normals || plan.has_sharpness)
      report.warn(name + ": no edge is sharp");
    return creases;
  }

  Surface surface = make_surface(mesh);
  std::vector<bool> edges(surface.number_of_edges(), false), vertices(mesh.points.size(), false);
  if (plan.source == Source::angle)
    edges = edges_of_angle(surface, plan.degrees, creases);
  else if (plan.source == Source::selection) {
    const Selected selected(mesh, plan);
    edges = selected.edges(surface);
    vertices = selected.vertices();
    if (!plan.selection.faces.empty())
      report.warn(plan.file + ": the faces of the selection take no part");
  } else if (can_be_sharp) {
    const bool says_nothing = mesh.flat_shading.is_there() && !mesh.flat_shading.makes_creases();
    if (plan.source == Source::normals || !says_nothing)
      edges = edges_where_normals_differ(surface);
  }
  set_sharpness(creases, edges, vertices, plan.sharpness);
  creases.are_by_normals = by_normals && creases.any();
  const bool wants_some = plan.source != Source::automatic && plan.source != Source::none;
  if (!creases.any() && (wants_some || plan.has_sharpness))
    report.warn(name + ": no edge is sharp");
  if (plan.border != Border::surface && !has_border(surface)) {
    report.warn(name + ": there is no border for --border");
    creases.border = Border::surface;
  }
  return creases;
}

Crease_maps add_creases(Surface& surface, const Creases& creases, bool with_tangents)
{
  Crease_maps maps{surface.add_property_map<Edge, double>("e:sharpness", 0).first,
                   surface.add_property_map<Vertex, double>("v:sharpness", 0).first,
                   creases.border,
                   {}};
  if (with_tangents)
    maps.tangents.map =
      surface.add_property_map<Surface::Halfedge_index, Vector_3>("h:tangent", Vector_3(0, 0, 0))
        .first;
  if (!creases.edges.empty())
    for (const Edge e : surface.edges()) maps.edges[e] = creases.edges[e];
  if (!creases.vertices.empty())
    for (const Vertex v : surface.vertices()) maps.vertices[v] = creases.vertices[v];
  return maps;
}

void remove_creases(Surface& surface, Crease_maps& maps)
{
  surface.remove_property_map(maps.edges);
  surface.remove_property_map(maps.vertices);
  if (maps.tangents.map) surface.remove_property_map(*maps.tangents.map);
}

} // namespace pn_subdivide

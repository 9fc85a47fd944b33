// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/creases.h"

#include "io/Error.h"
#include "io/mesh_normals.h"
#include "surface/Recognized_part.h"

#include <CGAL/PN_subdivision_3/detect_creases.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>

namespace pn_subdivide {
namespace {

using Source = Crease_plan::Source;

constexpr const char* edges_name = "e:sharpness";
constexpr const char* vertices_name = "v:sharpness";
constexpr const char* tangents_name = "h:tangent";

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

// --- by the numbers of a file ---

// What a file says of edges and vertices, by their numbers there, in the mesh that has become of it.
class Numbers_of_file
{
public:
  using Pair = std::pair<Index, Index>;

  // file: for messages
  Numbers_of_file(const Mesh_data& mesh, std::string file)
    : mesh_(mesh)
    , file_(std::move(file))
    , copies_begin_(mesh.points.size() - mesh.copied_from.size())
  {}

  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  // For each edge of the surface the place of its ends among `wanted`, or `none`. Throws Error if one is no edge,
  // unless edges have gone because the mesh was mended.
  std::vector<std::size_t> places_of_edges(const Surface& surface, const std::vector<Pair>& wanted,
                                           bool is_mended_file) const
  {
    const auto ordered = [](Index a, Index b) { return Pair((std::min)(a, b), (std::max)(a, b)); };
    std::vector<std::pair<Pair, std::size_t>> sorted;
    for (std::size_t i = 0; i < wanted.size(); ++i)
      sorted.emplace_back(ordered(number_now(wanted[i].first), number_now(wanted[i].second)), i);
    std::sort(sorted.begin(), sorted.end());
    std::vector<bool> is_found(wanted.size(), false);
    std::vector<std::size_t> result(surface.number_of_edges(), none);
    for (const Edge e : surface.edges()) {
      const Pair ends = ordered(original(surface.vertex(e, 0)), original(surface.vertex(e, 1)));
      auto it =
        std::lower_bound(sorted.begin(), sorted.end(), std::make_pair(ends, std::size_t(0)));
      if (it != sorted.end() && it->first == ends) result[e] = it->second;
      for (; it != sorted.end() && it->first == ends; ++it) is_found[it->second] = true;
    }
    const auto missing = std::find(is_found.begin(), is_found.end(), false);
    if (missing == is_found.end() || (is_mended_file && is_mended())) return result;
    const Pair& ends = wanted[std::size_t(missing - is_found.begin())];
    throw Error(file_ + ": the mesh has no edge between the vertices " +
                std::to_string(ends.first) + " and " + std::to_string(ends.second));
  }

  // The largest of the values of what each vertex has been in the file; `values(set)` calls set(number, value).
  template <class Values>
  std::vector<double> of_vertices(const Values& values) const
  {
    std::vector<double> of_originals(copies_begin_, 0.), result(mesh_.points.size());
    values([&](std::int64_t v, double value) {
      double& x = of_originals[number_now(v)];
      x = (std::max)(x, value);
    });
    for (std::size_t v = 0; v < result.size(); ++v)
      result[v] = of_originals[original(Vertex(Index(v)))];
    return result;
  }

  Index original(Vertex v) const { return mesh_.original(Index(v)); }

  Index number_now(std::int64_t v) const
  {
    const std::size_t in_file =
      mesh_.merged_into.empty() ? copies_begin_ : mesh_.merged_into.size();
    if (v < 0 || static_cast<std::uint64_t>(v) >= in_file)
      throw Error(file_ + ": vertex " + std::to_string(v) + " is out of range, the mesh has " +
                  plural(in_file, "vertex", "vertices"));
    const auto i = static_cast<std::size_t>(v);
    return mesh_.merged_into.empty() ? static_cast<Index>(i) : mesh_.merged_into[i];
  }

private:
  bool is_mended() const { return !mesh_.merged_into.empty() || !mesh_.copied_from.empty(); }

  const Mesh_data& mesh_;
  const std::string file_;
  std::size_t copies_begin_; // the vertices that are copies are behind the others
};

// Sharp by nothing else yet; numbers of edges are those of the surface.
void set_selection(Creases& creases, const Surface& surface, const Mesh_data& mesh,
                   const Crease_plan& plan)
{
  const Numbers_of_file numbers(mesh, plan.file);
  std::vector<Numbers_of_file::Pair> wanted;
  for (const auto& [a, b] : plan.selection.edges) {
    numbers.number_now(a); // is it in range?
    numbers.number_now(b);
    wanted.emplace_back(static_cast<Index>(a), static_cast<Index>(b));
  }
  const std::vector<std::size_t> places = numbers.places_of_edges(surface, wanted, false);
  for (std::size_t e = 0; e < places.size(); ++e)
    if (places[e] != Numbers_of_file::none) creases.edges[e] = plan.sharpness;
  creases.vertices = numbers.of_vertices([&](const auto& set) {
    for (const std::int64_t v : plan.selection.vertices)
      set(v, std::numeric_limits<double>::infinity());
  });
}

// The same by the tags of the mesh's own file.
void set_tags(Creases& creases, const Surface& surface, const Mesh_data& mesh,
              const Crease_plan& plan, const std::string& name)
{
  const Numbers_of_file numbers(mesh, name);
  const std::vector<Crease_tags::Edge>& tags = mesh.tags.edges;
  std::vector<Numbers_of_file::Pair> wanted;
  for (const Crease_tags::Edge& tag : tags) wanted.emplace_back(tag.ends[0], tag.ends[1]);
  const std::vector<std::size_t> places = numbers.places_of_edges(surface, wanted, true);
  creases.tangents.assign(surface.number_of_halfedges(), Vector_3(0, 0, 0));
  for (const Edge e : surface.edges()) {
    if (places[e] == Numbers_of_file::none) continue;
    const Crease_tags::Edge& tag = tags[places[e]];
    creases.edges[e] = plan.has_sharpness ? plan.sharpness : tag.sharpness;
    const auto h = surface.halfedge(e, 0);
    const bool is_along = numbers.original(surface.source(h)) == numbers.number_now(tag.ends[0]);
    creases.tangents[h] = to_vector(tag.tangents[is_along ? 0 : 1]);
    creases.tangents[surface.opposite(h)] = to_vector(tag.tangents[is_along ? 1 : 0]);
  }
  creases.vertices = numbers.of_vertices([&](const auto& set) {
    for (std::size_t v = 0; v < mesh.tags.vertices.size(); ++v)
      set(static_cast<std::int64_t>(v), mesh.tags.vertices[v]);
  });
}

std::vector<bool> edges_of_angle(Surface& surface, double degrees, Creases& creases)
{
  const auto map = surface.add_property_map<Edge, bool>("e:is_sharp", false).first;
  const auto number_above = [&](double angle) {
    constexpr double margin = 0.1; // that detect_creases() adds
    if (angle >= margin) return PN::detect_creases(surface, (std::min)(angle - margin, 180.), map);
    const auto all = surface.edges();
    return std::size_t(
      std::count_if(all.begin(), all.end(), [&](Edge e) { return !surface.is_border(e); }));
  };
  constexpr double close = 1 + 1e-6; // angles in whole degrees count whatever their rounding
  creases.degrees = degrees;
  creases.number_of_close_edges = number_above(degrees - close) - number_above(degrees + close);
  PN::detect_creases(surface, degrees, map);
  std::vector<bool> result;
  for (const Edge e : surface.edges()) result.push_back(map[e]);
  return result;
}

void set_edges(Creases& creases, const std::vector<bool>& edges, double sharpness)
{
  for (std::size_t e = 0; e < edges.size(); ++e)
    if (edges[e]) creases.edges[e] = sharpness;
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

void Creases::count()
{
  const auto number_of_sharp = [](const std::vector<double>& sharpness) {
    return std::size_t(
      std::count_if(sharpness.begin(), sharpness.end(), [](double s) { return s > 0; }));
  };
  number_of_edges = number_of_sharp(edges);
  number_of_vertices = number_of_sharp(vertices);
}

std::string Creases::description() const
{
  std::string s;
  if (number_of_edges > 0) {
    s += ", " + plural(number_of_edges, "sharp edge", "sharp edges");
    const double most = *std::max_element(edges.begin(), edges.end());
    double least = most;
    for (const double x : edges)
      if (x > 0) least = (std::min)(least, x);
    if (least < std::numeric_limits<double>::infinity())
      s += " of sharpness " + short_number(least) +
           (least < most ? " to " + short_number(most) : std::string());
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

void put_surface_creases(Creases& creases, const Mesh_data& mesh, const Recognized_part& part)
{
  constexpr double forever = std::numeric_limits<double>::infinity();
  creases.edges.assign(part.creases.size(), 0.);
  creases.vertices.assign(mesh.points.size(), 0.);
  set_edges(creases, part.creases, forever);
  for (const std::size_t v : part.corners) creases.vertices[v] = forever;
  creases.count();
}

Creases find_creases(const Mesh_data& mesh, const Crease_plan& plan, const std::string& scheme,
                     const Recognized_part* part, const std::string& name, Report& report)
{
  Creases creases;
  creases.border = plan.border;
  const bool by_file = plan.source == Source::automatic || plan.source == Source::normals;
  const bool by_tags = by_file && mesh.tags.any(), by_normals = by_file && !by_tags;
  const bool can_be_sharp =
    scheme.empty() && plan.source != Source::none && (!by_normals || mesh.has_corner_normals());
  if (by_tags && !scheme.empty())
    report.warn(name + ": what is tagged as sharp in it takes no part: " + scheme +
                " has no rules for creases");
  if (plan.source == Source::normals && !by_tags && !mesh.has_normals())
    throw Error("--sharp file, but the file has no normals and no tags of sharp edges, and without "
                "normals of its corners or tags it says nothing of creases");
  if (!can_be_sharp && plan.border == Border::surface) {
    if (plan.source == Source::normals || plan.has_sharpness)
      report.warn(name + ": no edge is sharp");
    return creases;
  }

  Surface surface = make_surface(mesh);
  creases.edges.assign(surface.number_of_edges(), 0.);
  creases.vertices.assign(mesh.points.size(), 0.);
  if (plan.source == Source::angle)
    set_edges(creases, edges_of_angle(surface, plan.degrees, creases), plan.sharpness);
  else if (part != nullptr)
    put_surface_creases(creases, mesh, *part);
  else if (plan.source == Source::selection) {
    set_selection(creases, surface, mesh, plan);
    if (!plan.selection.faces.empty())
      report.warn(plan.file + ": the faces of the selection take no part");
  } else if (can_be_sharp && by_tags)
    set_tags(creases, surface, mesh, plan, name);
  else if (can_be_sharp) {
    const bool says_nothing = mesh.flat_shading.is_there() && !mesh.flat_shading.makes_creases();
    if (plan.source == Source::normals || !says_nothing)
      set_edges(creases, edges_where_normals_differ(surface), plan.sharpness);
  }
  creases.count();
  creases.are_by_normals = by_normals && creases.any();
  const bool wants_some = plan.source != Source::automatic && plan.source != Source::none &&
                          plan.source != Source::surfaces; // a sphere has no edges
  if (!creases.any() && (wants_some || plan.has_sharpness))
    report.warn(name + ": no edge is sharp");
  if (plan.border != Border::surface && CGAL::is_closed(surface)) {
    report.warn(name + ": there is no border for --border");
    creases.border = Border::surface;
  }
  return creases;
}

Crease_tags tags_of(const Surface& surface, const Crease_maps& maps)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Crease_tags tags;
  for (const Edge e : surface.edges()) {
    const bool is_crease = surface.is_border(e) && maps.border != Border::surface;
    const double sharpness = is_crease ? infinity : maps.edges[e];
    if (!(sharpness > 0)) continue;
    const auto h = surface.halfedge(e, 0), g = surface.opposite(h);
    tags.edges.push_back({{Index(surface.source(h)), Index(surface.target(h))},
                          sharpness,
                          {to_triple(get(maps.tangents, h)), to_triple(get(maps.tangents, g))}});
  }
  const auto is_kept = [&](Vertex v) {
    if (maps.border != Border::corners && maps.border != Border::fixed) return false;
    if (surface.is_isolated(v) || !surface.is_border(v)) return false;
    return maps.border == Border::fixed || surface.degree(v) == 2;
  };
  for (const Vertex v : surface.vertices()) {
    const double sharpness = is_kept(v) ? infinity : maps.vertices[v];
    if (!(sharpness > 0)) continue;
    tags.vertices.resize(surface.number_of_vertices(), 0.);
    tags.vertices[v] = sharpness;
  }
  return tags;
}

std::optional<Crease_maps> creases_of(const Surface& copy, const std::optional<Crease_maps>& maps)
{
  if (!maps) return std::nullopt;
  return Crease_maps{find_property_map<Edge, double>(copy, edges_name).value(),
                     find_property_map<Vertex, double>(copy, vertices_name).value(),
                     maps->border,
                     {find_property_map<Halfedge, Vector_3>(copy, tangents_name)}};
}

std::vector<bool> sharp_edges_of(const Surface& surface)
{
  std::vector<bool> are_sharp;
  if (const auto sharpness = PN::internal::find_property_map<Edge, double>(surface, edges_name))
    for (const Edge e : surface.edges()) are_sharp.push_back((*sharpness)[e] > 0);
  return are_sharp;
}

Crease_maps add_creases(Surface& surface, const Creases& creases, bool with_tangents)
{
  Crease_maps maps{surface.add_property_map<Edge, double>(edges_name, 0).first,
                   surface.add_property_map<Vertex, double>(vertices_name, 0).first,
                   creases.border,
                   {},
                   creases.without_fractions};
  if (with_tangents || !creases.tangents.empty())
    maps.tangents.map =
      surface.add_property_map<Halfedge, Vector_3>(tangents_name, Vector_3(0, 0, 0)).first;
  if (!creases.tangents.empty())
    for (const auto h : surface.halfedges()) put(maps.tangents, h, creases.tangents[h]);
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

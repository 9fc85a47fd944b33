// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/soup_repair.h"

#include "io/Error.h"

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>

namespace pn_subdivide {
namespace {

// A side of a face; corners are numbered through all faces.
struct Side
{
  Index low, high;
  bool upwards; // from `low` to `high`
  std::size_t corner_at_low, corner_at_high;
};

bool is_same_edge(const Side& s, const Side& t)
{
  return s.low == t.low && s.high == t.high;
}

std::vector<Side> sorted_sides(const Mesh_data& mesh)
{
  std::vector<Side> sides;
  sides.reserve(mesh.number_of_corners());
  std::size_t first = 0;
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
    const Mesh_data::Face face = mesh.face(f);
    const auto n = static_cast<std::size_t>(face.size());
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t j = (i + 1) % n;
      const Index a = face.begin()[i], b = face.begin()[j];
      if (a < b)
        sides.push_back({a, b, true, first + i, first + j});
      else
        sides.push_back({b, a, false, first + j, first + i});
    }
    first += n;
  }
  std::sort(sides.begin(), sides.end(), [](const Side& s, const Side& t) {
    return s.low != t.low ? s.low < t.low : s.high < t.high;
  });
  return sides;
}

void count(Soup_defects::Edges& edges, const Side& side)
{
  if (edges.number++ != 0) return;
  edges.first[0] = side.low;
  edges.first[1] = side.high;
}

// Corners that neighbour across an edge are in the same fan; a vertex must have one fan only.
Soup_defects::Vertices find_pinched(const Mesh_data& mesh, const std::vector<Side>& sides)
{
  boost::disjoint_sets_with_storage<> fans(mesh.number_of_corners());
  for (std::size_t c = 0; c < mesh.number_of_corners(); ++c) fans.make_set(c);
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    const Side &s = sides[i], &t = sides[i + 1];
    if (!is_same_edge(s, t)) continue;
    fans.union_set(s.corner_at_low, t.corner_at_low);
    fans.union_set(s.corner_at_high, t.corner_at_high);
  }

  const auto none = static_cast<std::size_t>(-1);
  std::vector<std::size_t> fan(mesh.points.size(), none);
  std::vector<bool> pinched(mesh.points.size(), false);
  for (std::size_t c = 0; c < mesh.number_of_corners(); ++c) {
    const Index v = mesh.vertices_of_corners()[c];
    const std::size_t root = fans.find_set(c);
    if (fan[v] == none) fan[v] = root;
    if (fan[v] != root) pinched[v] = true;
  }

  Soup_defects::Vertices result;
  result.number = static_cast<std::size_t>(std::count(pinched.begin(), pinched.end(), true));
  result.first =
    static_cast<Index>(std::find(pinched.begin(), pinched.end(), true) - pinched.begin());
  return result;
}

std::string first_of(const Soup_defects::Edges& edges, const Mesh_data& mesh)
{
  return " (first: " + std::to_string(mesh.number_in_file(edges.first[0])) + "-" +
         std::to_string(mesh.number_in_file(edges.first[1])) + ")";
}

} // namespace

Soup_defects find_defects(const Mesh_data& mesh)
{
  const std::vector<Side> sides = sorted_sides(mesh);
  Soup_defects defects;
  for (std::size_t i = 0, end; i < sides.size(); i = end) {
    for (end = i + 1; end < sides.size() && is_same_edge(sides[i], sides[end]);) ++end;
    if (end - i > 2)
      count(defects.crowded, sides[i]);
    else if (end - i == 2 && sides[i].upwards == sides[i + 1].upwards)
      count(defects.unoriented, sides[i]);
    else if (end - i == 1)
      defects.border.push_back({sides[i].low, sides[i].high});
  }
  if (defects.none()) defects.pinched = find_pinched(mesh, sides);
  return defects;
}

std::vector<Index> vertices_at_open_edges(const Mesh_data& mesh)
{
  std::vector<bool> is_open(mesh.points.size(), true);
  for (const Index v : mesh.vertices_of_corners()) is_open[v] = false;
  const std::vector<Side> sides = sorted_sides(mesh);
  for (std::size_t i = 0, end; i < sides.size(); i = end) {
    for (end = i + 1; end < sides.size() && is_same_edge(sides[i], sides[end]);) ++end;
    if (end - i == 2) continue;
    is_open[sides[i].low] = is_open[sides[i].high] = true;
  }
  std::vector<Index> result;
  for (std::size_t v = 0; v < is_open.size(); ++v)
    if (is_open[v]) result.push_back(Index(v));
  return result;
}

std::string Soup_defects::description(const Mesh_data& mesh) const
{
  std::string s;
  const auto add = [&s](const std::string& part) { s += (s.empty() ? "" : "; ") + part; };
  if (crowded.number > 0)
    add(plural(crowded.number, "edge has", "edges have") + " more than two faces" +
        first_of(crowded, mesh));
  if (unoriented.number > 0)
    add(plural(unoriented.number, "edge has", "edges have") + " two faces of opposite orientation" +
        first_of(unoriented, mesh));
  if (pinched.number > 0)
    add(plural(pinched.number, "vertex joins", "vertices join") +
        " fans of faces that share no edge (first: " +
        std::to_string(mesh.number_in_file(pinched.first)) + ")");
  return s;
}

void require_finite_elements(const Mesh_data& mesh)
{
  if (mesh.points.empty() || mesh.number_of_faces() == 0)
    throw Error("there is no face in " + plural(mesh.points.size(), "vertex", "vertices"));
  if (mesh.has_normals() && mesh.normals.size() != mesh.points.size())
    throw Error(plural(mesh.normals.size(), "normal", "normals") + " for " +
                plural(mesh.points.size(), "vertex", "vertices"));
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const Triple& p = mesh.points[v];
    if (std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2])) continue;
    throw Error("vertex " + std::to_string(v) + " has a coordinate that is not finite: " +
                formatted("(%g, %g, %g)", p[0], p[1], p[2]));
  }
}

void require_sound_elements(const Mesh_data& mesh)
{
  require_finite_elements(mesh);
  if (mesh.short_faces.number > 0)
    throw Error(mesh.short_faces.first + "; --repair removes such faces");
  std::vector<std::size_t> last_face(mesh.points.size(), static_cast<std::size_t>(-1));
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
    if (mesh.face(f).size() < 3)
      throw Error("face " + std::to_string(f) + " has less than three vertices");
    for (const Index v : mesh.face(f)) {
      if (v >= mesh.points.size())
        throw Error("face " + std::to_string(f) + ": vertex " + std::to_string(v) +
                    " is out of range");
      if (last_face[v] == f)
        throw Error("face " + std::to_string(f) + " visits vertex " + std::to_string(v) +
                    " twice; --repair splits or removes such faces");
      last_face[v] = f;
    }
  }
}

} // namespace pn_subdivide

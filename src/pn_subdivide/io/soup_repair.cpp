// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/soup_repair.h"

#include "io/Error.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace pn_subdivide {
namespace {

using Polygon = std::vector<Index>;

// The soup as it was and which face of it each face comes from, for what its faces and corners have.
class Old_faces
{
public:
  explicit Old_faces(const Mesh_data& mesh)
    : vertices_(mesh.points.size())
    , is_needed_(mesh.has_corner_normals() || !mesh.corner_roundness.empty() ||
                 !mesh.attributes.texture.empty() || !mesh.attributes.of_faces.empty())
  {
    if (!is_needed_) return;
    for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) old_.add_face(mesh.face(f));
    face_.resize(mesh.number_of_faces());
    std::iota(face_.begin(), face_.end(), std::size_t(0));
  }

  // The i-th face is now what the faces[i]-th was.
  void renumber(const std::vector<std::size_t>& faces)
  {
    if (is_needed_) select(face_, faces);
  }

  void put_values(Mesh_data& mesh) const
  {
    if (!is_needed_) return;
    const std::vector<std::size_t> corners = old_corners(mesh);
    select(mesh.corner_normals, corners);
    select(mesh.corner_roundness, corners);
    select(mesh.attributes.texture, corners);
    select(mesh.attributes.of_faces, face_);
  }

private:
  // A vertex that a face visited twice has the corner of the first visit.
  std::vector<std::size_t> old_corners(const Mesh_data& mesh) const
  {
    std::vector<std::size_t> corners;
    corners.reserve(mesh.number_of_corners());
    for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
      for (const Index v : mesh.face(f)) {
        Index original = v;
        while (original >= vertices_) original = mesh.copied_from[original - vertices_];
        const Mesh_data::Face face = old_.face(face_[f]);
        const auto place = std::find(face.begin(), face.end(), original) - face.begin();
        corners.push_back(old_.first_corner(face_[f]) + std::size_t(place));
      }
    return corners;
  }

  std::size_t vertices_;
  bool is_needed_;
  Mesh_data old_; // without points
  std::vector<std::size_t> face_;
};

// Cuts the loops off faces that visit a vertex twice.
class Face_splitter
{
public:
  explicit Face_splitter(std::size_t number_of_vertices)
    : place_(number_of_vertices, none)
  {}

  // The parts with three vertices or more; the face itself if it visits no vertex twice.
  std::vector<Polygon> parts(const Mesh_data::Face& face)
  {
    std::vector<Polygon> result;
    Polygon path;
    for (const Index v : face) {
      if (place_[v] != none) {
        const auto loop = path.begin() + std::ptrdiff_t(place_[v]);
        for (auto i = loop; i != path.end(); ++i) place_[*i] = none;
        keep(Polygon(loop, path.end()), result);
        path.erase(loop, path.end());
      }
      place_[v] = path.size();
      path.push_back(v);
    }
    for (const Index v : path) place_[v] = none;
    keep(std::move(path), result);
    return result;
  }

private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  static void keep(Polygon polygon, std::vector<Polygon>& polygons)
  {
    if (polygon.size() >= 3) polygons.push_back(std::move(polygon));
  }

  std::vector<std::size_t> place_; // of a vertex in the path so far
};

void split_faces(Mesh_data& mesh, Soup_repair& repair, Old_faces& old_faces)
{
  repair.removed_degenerate_faces += std::exchange(mesh.short_faces, {}).number;
  Face_splitter splitter(mesh.points.size());
  std::vector<Polygon> faces;
  std::vector<std::size_t> origins;
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
    std::vector<Polygon> parts = splitter.parts(mesh.face(f));
    if (parts.empty())
      ++repair.removed_degenerate_faces;
    else if (parts.size() > 1 || parts[0].size() != std::size_t(mesh.face(f).size()))
      ++repair.split_faces;
    origins.insert(origins.end(), parts.size(), f);
    for (Polygon& part : parts) faces.push_back(std::move(part));
  }
  if (faces.size() == mesh.number_of_faces() && repair.split_faces == 0) return;
  mesh.clear_faces();
  for (const Polygon& face : faces) mesh.add_face(face);
  old_faces.renumber(origins);
}

// The same for all faces with these vertices in this order or its reverse.
Polygon key_of(const Mesh_data::Face& face)
{
  Polygon key(face.begin(), face.end());
  std::rotate(key.begin(), std::min_element(key.begin(), key.end()), key.end());
  if (key.back() < key[1]) std::reverse(key.begin() + 1, key.end());
  return key;
}

void remove_duplicates(Mesh_data& mesh, Soup_repair& repair, Old_faces& old_faces)
{
  const std::size_t n = mesh.number_of_faces();
  std::vector<Polygon> keys(n);
  for (std::size_t f = 0; f < n; ++f) keys[f] = key_of(mesh.face(f));
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&keys](std::size_t a, std::size_t b) { return keys[a] < keys[b]; });
  std::vector<bool> is_duplicate(n, false);
  for (std::size_t i = 1; i < n; ++i)
    if (keys[order[i]] == keys[order[i - 1]]) is_duplicate[order[i]] = true;

  Mesh_data kept;
  std::vector<std::size_t> origins;
  for (std::size_t f = 0; f < n; ++f)
    if (!is_duplicate[f]) {
      kept.add_face(mesh.face(f));
      origins.push_back(f);
    }
  mesh.take_faces(kept);
  old_faces.renumber(origins);
  repair.removed_duplicate_faces = n - mesh.number_of_faces();
}

} // namespace

std::size_t split_fans(Mesh_data& mesh)
{
  const Old_faces old_faces(mesh);
  std::vector<bool> is_reversed(mesh.number_of_faces(), false);
  const std::size_t added = orient_soup(mesh, is_reversed);
  old_faces.put_values(mesh);
  return added;
}

Soup_repair repair_soup(Mesh_data& mesh)
{
  Soup_repair repair;
  Old_faces old_faces(mesh);
  split_faces(mesh, repair, old_faces);
  std::vector<bool> is_reversed(mesh.number_of_faces(), false);
  if (!find_defects(mesh).none()) {
    remove_duplicates(mesh, repair, old_faces);
    is_reversed.assign(mesh.number_of_faces(), false);
    if (!find_defects(mesh).none()) repair.added_vertices += orient_soup(mesh, is_reversed);
  }
  if (find_defects(mesh).none()) repair.turned_components = orient_outwards(mesh, is_reversed);
  repair.reversed_faces =
    static_cast<std::size_t>(std::count(is_reversed.begin(), is_reversed.end(), true));
  if (repair.changed_anything()) old_faces.put_values(mesh);
  return repair;
}

std::string Soup_repair::description() const
{
  std::string s = "repaired: ";
  if (removed_degenerate_faces > 0)
    s += plural(removed_degenerate_faces, "degenerate face", "degenerate faces") + " removed, ";
  if (split_faces > 0)
    s += plural(split_faces, "face", "faces") + " split at vertices visited twice, ";
  if (removed_duplicate_faces > 0)
    s += plural(removed_duplicate_faces, "duplicate face", "duplicate faces") + " removed, ";
  s += plural(reversed_faces, "face", "faces") + " reversed, " +
       plural(added_vertices, "vertex", "vertices") + " added as copies";
  if (turned_components > 0)
    s += ", " + plural(turned_components, "closed component", "closed components") +
         " turned right side out";
  if (turned_normals > 0)
    s += ", " + plural(turned_normals, "normal", "normals") +
         " that opposed all faces turned over (first: at vertex " +
         std::to_string(first_turned_normal) + ")";
  return s;
}

} // namespace pn_subdivide

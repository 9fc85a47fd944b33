// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/Planes_from_rims.h"

#include "io/Error.h"
#include "surface/Planes_of_part.h"
#include "surface/output_tags.h"
#include "surface/surface_command.h"

#include <CGAL/PN_recognition_3/triangulate_planes.h>

#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <utility>

namespace pn_subdivide {
namespace {

using Index = Mesh_data::Index;

void refuse(bool is_given, const std::string& option, const std::string& why)
{
  if (is_given) throw Usage_error("--planes rims and " + option + " exclude each other: " + why);
}

// New faces made of old corners.
class New_faces
{
public:
  std::vector<std::size_t> corners, faces; // what each has been
  Mesh_data mesh;                          // faces only

  template <class Range>
  void add(const Range& vertices, std::size_t old_face)
  {
    mesh.add_face(vertices);
    faces.push_back(old_face);
  }
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
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    for (const Index v : mesh.face(f)) had[v] = true;
  for (std::size_t f = 0; f < faces.number_of_faces(); ++f)
    for (const Index v : faces.face(f)) has[v] = true;
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

void require_options_for_planes(const Surface_options& options)
{
  if (!options.planes) return;
  if (*options.planes != "rims")
    throw Usage_error("--planes '" + *options.planes + "': expected rims");
  if (!wants_surfaces(options.creases))
    throw Usage_error("--planes rims needs --sharp surfaces or --part");
  const std::string why = "its triangles are no control mesh for further rounds";
  for (const char* const choice : {"control", "both"})
    refuse(options.output_normals == choice, std::string("--output-normals ") + choice, why);
  refuse(options.write_tags.has_value(), "--write-tags", why);
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
  for (const auto& plane :
       CGAL::PN_subdivision_3::triangulate_planes(surface, Segment_map{&segment_}, part.surfaces)) {
    ++(plane.is_triangulated ? replaced_planes_ : kept_planes_);
    is_replaced_[plane.surface] = plane.is_triangulated;
    for (const auto& t : plane.triangles) {
      triangles_.push_back({Index(t[0]), Index(t[1]), Index(t[2])});
      segment_of_triangle_.push_back(plane.surface);
    }
  }
  for (const std::size_t s : segment_) ++(is_replaced_[s] ? replaced_faces_ : kept_faces_);
}

void Planes_from_rims::put_into(Mesh_data& mesh) const
{
  New_faces now;
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
    if (is_replaced_[segment_[f]]) continue;
    now.add(mesh.face(f), f);
    for (std::size_t i = 0; i < std::size_t(mesh.face(f).size()); ++i)
      now.corners.push_back(mesh.first_corner(f) + i);
  }
  const First_corners old(mesh, segment_, is_replaced_);
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    const std::size_t segment = segment_of_triangle_[t];
    now.add(triangles_[t], old.at(segment, triangles_[t][0]).face);
    for (const Index v : triangles_[t]) now.corners.push_back(old.at(segment, v).corner);
  }
  const std::vector<Index> kept = kept_vertices(mesh, now.mesh);
  select_corners(mesh, now.corners);
  select(mesh.attributes.of_faces, now.faces);
  mesh.clear_faces();
  mesh.reserve_faces(now.mesh.number_of_faces(), now.mesh.number_of_corners());
  for (std::size_t f = 0; f < now.mesh.number_of_faces(); ++f) mesh.add_face(now.mesh.face(f));
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

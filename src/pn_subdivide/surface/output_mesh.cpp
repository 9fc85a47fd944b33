// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/output_mesh.h"

#include "surface/Area_normals.h"
#include "surface/Several_wedges.h"

#include <CGAL/boost/graph/iterator.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace pn_subdivide {
namespace {

using Halfedge = Surface::Halfedge_index;
using Vertex = Surface::Vertex_index;

// `f(corners)` with the half-edges of each face, in the order of to_mesh_data()
template <class Function>
void for_each_face(const Surface& surface, const Function& f)
{
  std::vector<Halfedge> corners;
  for (const Surface::Face_index face : surface.faces()) {
    corners.clear();
    for (const Halfedge h : halfedges_around_face(surface.halfedge(face), surface))
      corners.push_back(h);
    f(corners);
  }
}

// Of vertices with several wedges `normals` get the normalized sum of those.
void set_normals_of_wedges(Mesh_data& mesh, const Surface& surface, const Several_wedges& wedges,
                           double scale)
{
  const std::size_t vertices = mesh.points.size();
  Area_normals sums(vertices + wedges.size(), scale);
  for_each_face(surface, [&](const std::vector<Halfedge>& corners) {
    sums.add_face(
      corners.size(),
      [&](std::size_t i) { return to_triple(surface.point(surface.target(corners[i]))); },
      [&](std::size_t i) -> std::size_t {
        const Vertex v = surface.target(corners[i]);
        return wedges.at(v) ? vertices + wedges.of(corners[i]) : std::size_t(v);
      });
  });
  mesh.normals = sums.take();
  const std::vector<Triple> of_wedges(mesh.normals.begin() + std::ptrdiff_t(vertices),
                                      mesh.normals.end());
  mesh.normals.resize(vertices);
  for (std::size_t w = 0; w < of_wedges.size(); ++w)
    for (std::size_t k = 0; k < 3; ++k) mesh.normals[wedges.vertex(w)][k] += of_wedges[w][k];
  for (const Vertex v : surface.vertices())
    if (wedges.at(v)) mesh.normals[v] = normalized(mesh.normals[v]);
  std::size_t corner = 0;
  for_each_face(surface, [&](const std::vector<Halfedge>& corners) {
    for (const Halfedge h : corners) {
      const Vertex v = surface.target(h);
      if (wedges.at(v))
        mesh.several_normals.push_back(
          {corner, static_cast<Mesh_data::Index>(v), of_wedges[wedges.of(h)]});
      ++corner;
    }
  });
}

void set_normals_of_vertices(Mesh_data& mesh, double scale)
{
  Area_normals sums(mesh.points.size(), scale);
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
    const Mesh_data::Index* const corner = mesh.face(f).begin();
    sums.add_face(
      std::size_t(mesh.face(f).size()), [&](std::size_t i) { return mesh.points[corner[i]]; },
      [&](std::size_t i) { return corner[i]; });
  }
  mesh.normals = sums.take();
}

// If a vertex has several.
std::optional<Several_wedges> wedges_of(const Surface& surface,
                                        const std::optional<Crease_maps>& creases)
{
  if (!creases) return std::nullopt;
  Several_wedges wedges(surface, [&](Surface::Edge_index e) { return creases->edges[e] > 0; });
  if (wedges.size() == 0) return std::nullopt;
  return wedges;
}

// Control normals and creases go before others take their room.
Mesh_data with_normals_of_faces(Surface& surface, std::optional<Crease_maps>& creases, double scale)
{
  remove_normals(surface);
  const std::optional<Several_wedges> wedges = wedges_of(surface, creases);
  if (creases) remove_creases(surface, *creases);
  Mesh_data mesh = to_mesh_data(surface);
  if (wedges)
    set_normals_of_wedges(mesh, surface, *wedges, scale);
  else
    set_normals_of_vertices(mesh, scale);
  return mesh;
}

} // namespace

Kept_normals kept_normals(const Surface& surface, const Wedge_list& wedges)
{
  Mesh_data mesh = to_mesh_data(surface, wedges);
  if (mesh.several_normals.empty())
    return {std::move(mesh.normals), std::move(mesh.corner_normals)};
  std::vector<Triple> of_corners;
  of_corners.reserve(mesh.number_of_corners());
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    for (const Mesh_data::Index v : mesh.face(f)) of_corners.push_back(mesh.normals[v]);
  for (const Corner_normal& n : mesh.several_normals) of_corners[n.corner] = n.normal;
  return {std::move(mesh.normals), std::move(of_corners)};
}

Mesh_data output_mesh(Surface& surface, std::optional<Crease_maps>& creases,
                      const Wedge_list& of_wedges, const Output_normals& normals,
                      Kept_normals control)
{
  if (!normals.any()) remove_normals(surface);
  const bool has_normals = normals_of(surface).has_value();
  const bool of_faces = normals.are_of_faces() && has_normals;
  if (of_faces && normals.with_control()) control = kept_normals(surface, of_wedges);
  if (!of_faces && creases) remove_creases(surface, *creases);
  Mesh_data mesh = of_faces ? with_normals_of_faces(surface, creases, normals.scale)
                            : to_mesh_data(surface, has_normals ? of_wedges : Wedge_list());
  mesh.normal_kind = normals.kind;
  mesh.control_normals = std::move(control.of_vertices);
  mesh.corner_control_normals = std::move(control.of_corners);
  if (normals.kind == Normal_kind::control) put_control_normals(mesh, normals);
  return mesh;
}

void put_control_normals(Mesh_data& mesh, const Output_normals& normals)
{
  if (!normals.any()) {
    mesh.normals.clear();
    mesh.corner_normals.clear();
    mesh.several_normals.clear();
  }
  if (!normals.with_control()) return;
  mesh.control_normals = mesh.normals;
  mesh.corner_control_normals = mesh.corner_normals;
}

} // namespace pn_subdivide

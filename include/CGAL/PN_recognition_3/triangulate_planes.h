// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_RECOGNITION_3_TRIANGULATE_PLANES_H
#define CGAL_PN_RECOGNITION_3_TRIANGULATE_PLANES_H

#include <CGAL/PN_recognition_3/surfaces/Recognized_surface.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/package_parameters.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Functions

a plane of a mesh, triangulated anew by `triangulate_planes()`.
*/
template <class Vertex>
struct Triangulated_plane
{
  /// the number of the plane among the recognized surfaces.
  std::size_t surface = 0;
  /// whether it could be triangulated: not if its rims cross or touch each other.
  bool is_triangulated = false;
  /// the triangles, oriented as the faces of the mesh; empty if it could not be triangulated.
  std::vector<std::array<Vertex, 3>> triangles;
};

namespace internal {

// The faces of a plane from its rims: directed edges with the plane on their left, in coordinates of the plane.
class Plane_from_rims
{
public:
  using Point = std::array<double, 2>;
  using Edge = std::array<std::size_t, 2>;
  using Triangle = std::array<std::size_t, 3>;

  // points by number; those without an edge take no part
  Plane_from_rims(const std::vector<std::pair<std::size_t, Point>>& points, std::vector<Edge> rims)
    : rims_(std::move(rims))
  {
    std::sort(rims_.begin(), rims_.end());
    is_good_ = insert(points) && constrain() && collect();
    if (!is_good_) triangles_.clear();
  }

  bool is_good() const { return is_good_; }
  const std::vector<Triangle>& triangles() const { return triangles_; }
  // edges that are no rims
  const std::vector<Edge>& inner_edges() const { return inner_edges_; }

private:
  using Kernel = Exact_predicates_inexact_constructions_kernel;
  using Vertex_base = Triangulation_vertex_base_with_info_2<std::size_t, Kernel>;
  using Face_base =
    Constrained_triangulation_face_base_2<Kernel,
                                          Triangulation_face_base_with_info_2<signed char, Kernel>>;
  using Triangulation = Constrained_Delaunay_triangulation_2<
    Kernel, Triangulation_data_structure_2<Vertex_base, Face_base>, No_constraint_intersection_tag>;
  using Face_handle = Triangulation::Face_handle;

  bool insert(const std::vector<std::pair<std::size_t, Point>>& points)
  {
    std::vector<std::pair<Kernel::Point_2, std::size_t>> all;
    for (const auto& [v, p] : points) all.emplace_back(Kernel::Point_2(p[0], p[1]), v);
    triangulation_.insert(all.begin(), all.end());
    return triangulation_.number_of_vertices() == points.size() && triangulation_.dimension() == 2;
  }

  bool constrain()
  {
    std::map<std::size_t, Triangulation::Vertex_handle> handles;
    for (const auto v : triangulation_.finite_vertex_handles()) handles.emplace(v->info(), v);
    try {
      for (const Edge& e : rims_)
        triangulation_.insert_constraint(handles.at(e[0]), handles.at(e[1]));
    } catch (const Triangulation::Intersection_of_constraints_exception&) {
      return false;
    }
    return true;
  }

  // The faces are inside that an odd number of rims parts from outside. Each rim has to run round
  // them; one through another vertex is in parts and does not.
  bool collect()
  {
    for (const Face_handle f : triangulation_.all_face_handles()) f->info() = -1;
    std::vector<Face_handle> open(1, triangulation_.infinite_face());
    open[0]->info() = 0;
    while (!open.empty()) {
      const Face_handle f = open.back();
      open.pop_back();
      for (int i = 0; i < 3; ++i) {
        const Face_handle g = f->neighbor(i);
        if (g->info() >= 0) continue;
        g->info() = static_cast<signed char>(f->is_constrained(i) ? 1 - f->info() : f->info());
        open.push_back(g);
      }
    }
    std::size_t rims = 0;
    for (const Face_handle f : triangulation_.finite_face_handles()) {
      if (f->info() == 0) continue;
      triangles_.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
      for (int i = 0; i < 3; ++i) {
        const Edge e = {f->vertex(f->ccw(i))->info(), f->vertex(f->cw(i))->info()};
        if (!f->is_constrained(i))
          inner_edges_.push_back(e);
        else if (std::binary_search(rims_.begin(), rims_.end(), e))
          ++rims;
      }
    }
    return rims == rims_.size();
  }

  std::vector<Edge> rims_;
  Triangulation triangulation_;
  std::vector<Triangle> triangles_;
  std::vector<Edge> inner_edges_;
  bool is_good_ = false;
};

// All planes of a mesh.
template <class FaceGraph, class FacePatchMap, class PointMap>
class Triangulate_planes
{
public:
  using Graph = boost::graph_traits<FaceGraph>;
  using Vertex = typename Graph::vertex_descriptor;
  using Halfedge = typename Graph::halfedge_descriptor;
  using Face = typename Graph::face_descriptor;
  using Vector = std::array<double, 3>;

  Triangulate_planes(const FaceGraph& mesh, FacePatchMap patches,
                     const std::vector<Recognized_surface>& surfaces, PointMap points)
    : mesh_(mesh)
    , patches_(patches)
    , points_(points)
    , index_(get_initialized_vertex_index_map(mesh))
    , vertices_(vertices(mesh).begin(), vertices(mesh).end())
    , rims_(surfaces.size())
    , normals_(surfaces.size(), Vector{0, 0, 0})
  {
    for (const Face f : faces(mesh)) add_area(f);
    for (const Halfedge h : halfedges(mesh))
      if (!is_border(h, mesh) && (is_border(opposite(h, mesh), mesh) ||
                                  patch(face(opposite(h, mesh), mesh)) != patch(face(h, mesh))))
        rims_[patch(face(h, mesh))].push_back(h);
  }

  Triangulated_plane<Vertex> operator()(std::size_t surface) const
  {
    Triangulated_plane<Vertex> result;
    result.surface = surface;
    std::vector<Plane_from_rims::Edge> rims;
    std::vector<std::size_t> on_rims;
    for (const Halfedge h : rims_[surface]) {
      rims.push_back({number(source(h, mesh_)), number(target(h, mesh_))});
      on_rims.push_back(rims.back()[1]);
      on_rims.push_back(rims.back()[0]);
    }
    std::sort(on_rims.begin(), on_rims.end());
    on_rims.erase(std::unique(on_rims.begin(), on_rims.end()), on_rims.end());
    const Plane_from_rims plane(projected(on_rims, normals_[surface]), std::move(rims));
    result.is_triangulated = plane.is_good() && !has_foreign_edge(plane, surface);
    if (!result.is_triangulated) return result;
    for (const auto& t : plane.triangles())
      result.triangles.push_back({vertices_[t[0]], vertices_[t[1]], vertices_[t[2]]});
    return result;
  }

private:
  std::size_t number(Vertex v) const { return static_cast<std::size_t>(get(index_, v)); }

  std::size_t patch(Face f) const
  {
    const auto s = get(patches_, f);
    if (!(static_cast<std::size_t>(s) < rims_.size()))
      throw std::invalid_argument("PN_subdivision_3: a face has surface number " +
                                  std::to_string(s) + ", and there are " +
                                  std::to_string(rims_.size()));
    return static_cast<std::size_t>(s);
  }

  Vector point(Vertex v) const
  {
    const auto& p = get(points_, v);
    return {to_double(p.x()), to_double(p.y()), to_double(p.z())};
  }

  void add_area(Face f)
  {
    Vector& sum = normals_[patch(f)];
    const Halfedge first = halfedge(f, mesh_);
    const Vector p = point(target(first, mesh_));
    for (Halfedge h = next(first, mesh_); next(h, mesh_) != first; h = next(h, mesh_)) {
      const Vector area = cross(difference(point(target(h, mesh_)), p),
                                difference(point(target(next(h, mesh_), mesh_)), p));
      for (std::size_t k = 0; k < 3; ++k) sum[k] += area[k];
    }
  }

  // Seen against the normal.
  std::vector<std::pair<std::size_t, Plane_from_rims::Point>>
  projected(const std::vector<std::size_t>& numbers, Vector normal) const
  {
    std::vector<std::pair<std::size_t, Plane_from_rims::Point>> result;
    if (numbers.empty()) return result;
    normalize(normal);
    const Local_frame<double> frame(point(vertices_[numbers[0]]), normal);
    for (const std::size_t i : numbers) result.push_back({i, frame.u(point(vertices_[i]))});
    return result;
  }

  // Is an edge across the plane one that other faces have already?
  bool has_foreign_edge(const Plane_from_rims& plane, std::size_t surface) const
  {
    const auto is_foreign = [&](Halfedge h) {
      return !is_border(h, mesh_) && patch(face(h, mesh_)) != surface;
    };
    const auto& edges = plane.inner_edges();
    return std::any_of(edges.begin(), edges.end(), [&](const Plane_from_rims::Edge& e) {
      const auto found = halfedge(vertices_[e[0]], vertices_[e[1]], mesh_);
      return found.second && (is_foreign(found.first) || is_foreign(opposite(found.first, mesh_)));
    });
  }

  const FaceGraph& mesh_;
  FacePatchMap patches_;
  PointMap points_;
  typename GetInitializedVertexIndexMap<FaceGraph>::const_type index_;
  std::vector<Vertex> vertices_;
  std::vector<std::vector<Halfedge>> rims_; // of each surface
  std::vector<Vector> normals_;
};

} // namespace internal

/*!
\ingroup PkgPNSubdivision3Functions

triangulates recognized planes anew, from their rims.

The faces of a refined plane hold nothing but its rims, the edges that it shares with other surfaces. The constrained
Delaunay triangulation of these rims has about a quarter of the faces after two rounds, none of them folded. It has no
vertices of its own, so that the faces of the neighbors fit to it as before; vertices inside planes are left without
faces. The mesh itself is not changed, as it becomes no control mesh for further rounds.

This header uses the 2D triangulations of CGAL, which are under the GPL, and so is what is made with it. No other header
of this package includes it.

\tparam FaceGraph a model of `FaceListGraph`
\tparam FacePatchMap a model of `ReadablePropertyMap` with `boost::graph_traits<FaceGraph>::%face_descriptor` as key type and
  an integer as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param mesh an oriented 2-manifold with border
\param patch_map the surface of each face, as `recognize_surfaces()` writes it, of a refined mesh that of its control face
\param surfaces the result of `recognize_surfaces()`
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `vertex_point_map`

\return for each surface that is a plane and has faces its triangles. A plane whose rims cross or touch each other, or across which
  neighbors have an edge of their own, is not triangulated.
\throws std::invalid_argument if a face has a number that no surface has
<br><b>Cost:</b> that of the triangulations, about linear in the size of the mesh
*/
template <class FaceGraph, class FacePatchMap,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
std::vector<Triangulated_plane<typename boost::graph_traits<FaceGraph>::vertex_descriptor>>
triangulate_planes(const FaceGraph& mesh, FacePatchMap patch_map,
                   const std::vector<Recognized_surface>& surfaces,
                   const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::check_are_read<NamedParameters>();
  const auto points = CGAL::parameters::choose_parameter(
    CGAL::parameters::get_parameter(np, internal_np::vertex_point),
    get_const_property_map(vertex_point, mesh));
  const internal::Triangulate_planes<FaceGraph, FacePatchMap, std::decay_t<decltype(points)>>
    triangulate(mesh, patch_map, surfaces, points);
  std::vector<bool> has_faces(surfaces.size(), false);
  for (const auto f : faces(mesh)) has_faces[static_cast<std::size_t>(get(patch_map, f))] = true;
  std::vector<Triangulated_plane<typename boost::graph_traits<FaceGraph>::vertex_descriptor>>
    result;
  for (std::size_t s = 0; s < surfaces.size(); ++s)
    if (has_faces[s] && surfaces[s].kind == Recognized_surface::Kind::plane)
      result.push_back(triangulate(s));
  return result;
}

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_RECOGNITION_3_TRIANGULATE_PLANES_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "Refined_surface.h"

#include "io/Error.h"

#include <CGAL/PN_limit_surface_3/estimate_curvature.h>
#include <CGAL/PN_limit_surface_3/limit_points.h>
#include <CGAL/PN_subdivision_3/parameters/parameters.h>
#include <CGAL/PN_subdivision_3/schemes/shipped_schemes.h>

#include <numeric>
#include <type_traits>
#include <utility>

namespace pn_demo {
namespace {

namespace PN = CGAL::PN_subdivision_3;
using pn_subdivide::Error;

Scheme make_scheme(const std::string& name)
{
  return pn_subdivide::make_scheme("scheme", name, {});
}

Display_mesh make_display(const Refinement& refinement, const Point_3& origin)
{
  const Faces* const cut = refinement.cut_faces();
  return Display_mesh(cut ? *cut : refinement.faces(), refinement.cut_vertices(),
                      refinement.points().size(), origin);
}

Surface make_surface(const Faces& faces, const std::vector<Index>& vertices,
                     const std::vector<Point_3>& points)
{
  Mesh_data mesh;
  for (const Index v : vertices) mesh.points.push_back(pn_subdivide::to_triple(points[v]));
  auto corner = faces.corners.begin();
  for (const Index end : faces.end) {
    const auto face_end = faces.corners.begin() + std::ptrdiff_t(end);
    mesh.add_face(std::vector<Index>(corner, face_end));
    corner = face_end;
  }
  return pn_subdivide::make_surface(mesh);
}

} // namespace

std::vector<Scheme_traits> scheme_traits()
{
  std::vector<Scheme_traits> result;
  PN::for_each_shipped_scheme([&](const auto& s) {
    const Scheme scheme = make_scheme(s.name());
    result.push_back({scheme.name(), scheme.needs_triangles(),
                      std::is_same_v<std::decay_t<decltype(s)>, PN::Kobbelt_scheme>,
                      scheme.has_crease_rules(), scheme.keeps_vertices()});
  });
  return result;
}

Refined_surface::Refined_surface(const Control_mesh& mesh, const std::string& scheme,
                                 unsigned rounds, bool is_linear, const Point_3& origin)
  : scheme_(make_scheme(scheme))
  , is_linear_(is_linear)
  , rounds_(rounds)
  , refinement_(make_refinement(mesh, scheme_, rounds, is_linear))
  , display_(make_display(*refinement_, origin))
{
  show_all();
}

void Refined_surface::follow(const Control_mesh& mesh, std::size_t vertex)
{
  refinement_->follow(mesh, vertex);
}

void Refined_surface::update(const Control_mesh& mesh)
{
  const std::vector<Index>& moved = refinement_->update(mesh);
  gaussian_curvature_.clear();
  if (limit_points_.empty())
    display_.update(moved, points());
  else
    hide_limit();
}

void Refined_surface::hide_limit()
{
  if (limit_points_.empty()) return;
  limit_points_.clear();
  limit_normals_.clear();
  gaussian_curvature_.clear();
  show_all();
}

void Refined_surface::show_all()
{
  std::vector<Index> all(points().size());
  std::iota(all.begin(), all.end(), Index(0));
  display_.update(all, points());
}

const std::vector<Point_3>& Refined_surface::points() const
{
  return limit_points_.empty() ? refinement_->points() : limit_points_;
}

const std::vector<Vector_3>& Refined_surface::normals() const
{
  return limit_normals_.empty() ? refinement_->normals() : limit_normals_;
}

void Refined_surface::show_limit(const Control_mesh& mesh)
{
  if (!limit_points_.empty()) return;
  if (refinement_->cut_faces() &&
      refinement_->cut_vertices().size() != refinement_->points().size())
    throw Error("limit points are not computed for surfaces with creases");
  const std::vector<Index>& vertices = display_.vertices();
  Surface surface = make_surface(display_.faces(), vertices, refinement_->points());
  using Limit_point = PN::Limit_point<pn_subdivide::Kernel>;
  const auto limits = surface.add_property_map<Surface::Vertex_index, Limit_point>("v:limit").first;
  const auto np = PN::parameters::tolerance(1e-7) // a pixel is a thousandth
                    .surface_normals(true)
                    .rounds_done(rounds_);
  if (is_linear_)
    PN::limit_points(surface, PN::linear(scheme_), limits, np);
  else {
    const auto normals = pn_subdivide::add_normals(surface);
    const pn_subdivide::Roundness_map roundness = pn_subdivide::add_roundness(surface);
    const std::vector<double> refined = refinement_->roundness(mesh);
    for (const auto v : surface.vertices()) {
      normals[v] = refinement_->normals()[vertices[v]];
      if (!refined.empty()) roundness[v] = refined[vertices[v]];
    }
    PN::limit_points(surface, scheme_, limits,
                     np.vertex_roundness_map(roundness).vertex_normal_map(normals));
  }
  limit_points_.resize(vertices.size());
  limit_normals_.resize(vertices.size());
  for (const auto v : surface.vertices()) {
    limit_points_[vertices[v]] = limits[v].point;
    // where the eigenvectors tell of no tangent plane the normals of the faces are closer to it
    const auto& n = display_.normals();
    limit_normals_[vertices[v]] = limits[v].has_surface_normal
                                    ? limits[v].surface_normal
                                    : Vector_3(n[3 * v], n[3 * v + 1], n[3 * v + 2]);
  }
  display_.set(limit_points_, limit_normals_);
  gaussian_curvature_.clear();
}

const std::vector<float>& Refined_surface::curvature(bool is_gaussian)
{
  if (gaussian_curvature_.empty()) compute_curvatures();
  return is_gaussian ? gaussian_curvature_ : mean_curvature_;
}

void Refined_surface::compute_curvatures()
{
  using Curvature = PN::Vertex_curvature<pn_subdivide::Kernel>;
  Surface surface = make_surface(display_.faces(), display_.vertices(), points());
  const auto curvatures =
    surface.add_property_map<Surface::Vertex_index, Curvature>("v:curvature").first;
  PN::estimate_curvature(surface, curvatures);
  mean_curvature_.clear();
  for (const auto v : surface.vertices()) {
    gaussian_curvature_.push_back(static_cast<float>(curvatures[v].gaussian));
    mean_curvature_.push_back(static_cast<float>(curvatures[v].mean));
  }
}

} // namespace pn_demo

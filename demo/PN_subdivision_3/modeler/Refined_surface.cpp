// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "Refined_surface.h"

#include "io/Error.h"
#include "surface/limit.h"

#include <CGAL/PN_subdivision_3/estimate_curvature.h>
#include <CGAL/PN_subdivision_3/hosts/PTQ_host.h>
#include <CGAL/PN_subdivision_3/hosts/Sqrt3_host.h>

#include <numeric>
#include <type_traits>
#include <utility>

namespace pn_demo {
namespace {

namespace PN = CGAL::PN_subdivision_3;
using pn_subdivide::Error;

template <class S>
constexpr bool takes_triangles_v = std::is_same_v<typename S::Host, PN::PTQ_host> ||
                                   std::is_same_v<typename S::Host, PN::Sqrt3_host>;

Scheme make_scheme(const std::string& name)
{
  return pn_subdivide::make_scheme("scheme", name, {});
}

std::unique_ptr<Refinement> make_refinement(const Control_mesh& mesh, const Scheme& scheme,
                                            unsigned rounds, bool is_linear)
{
  const bool can_be_creased = std::visit(
    [](const auto& s) { return pn_subdivide::can_crease<std::decay_t<decltype(s)>>; }, scheme);
  const bool transfers = std::visit(
    [](const auto& s) {
      return pn_subdivide::Transfers_curvature<std::decay_t<decltype(s)>>::value;
    },
    scheme);
  const bool is_creased = mesh.number_of_sharp_edges() > 0;
  if (is_creased && !can_be_creased)
    throw Error(std::visit([](const auto& s) { return std::string(s.name()); }, scheme) +
                " subdivision has no rules for creases");
  if (is_creased || (transfers && !is_linear))
    return is_linear ? make_linear_refinement_with_creases(mesh, scheme, rounds)
                     : make_pn_refinement_with_creases(mesh, scheme, rounds);
  return is_linear ? make_linear_refinement(mesh, scheme, rounds)
                   : make_pn_refinement(mesh, scheme, rounds);
}

Display_mesh make_display(const Refinement& refinement)
{
  const Faces* const cut = refinement.cut_faces();
  return Display_mesh(cut ? *cut : refinement.faces(), refinement.cut_vertices(),
                      refinement.points().size());
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
    using S = std::decay_t<decltype(s)>;
    result.push_back({s.name(), takes_triangles_v<S>, std::is_same_v<S, PN::Kobbelt_scheme>,
                      pn_subdivide::can_crease<S>, S::Host::keeps_vertices});
  });
  return result;
}

Refined_surface::Refined_surface(const Control_mesh& mesh, const std::string& scheme,
                                 unsigned rounds, bool is_linear)
  : scheme_(make_scheme(scheme))
  , is_linear_(is_linear)
  , rounds_(rounds)
  , refinement_(make_refinement(mesh, scheme_, rounds, is_linear))
  , display_(make_display(*refinement_))
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

void Refined_surface::show_limit()
{
  if (!limit_points_.empty()) return;
  if (refinement_->cut_faces() &&
      refinement_->cut_vertices().size() != refinement_->points().size())
    throw Error("limit points are not computed for surfaces with creases");
  Surface surface =
    make_surface(refinement_->faces(), refinement_->cut_vertices(), refinement_->points());
  const auto& n = display_.normals();
  std::vector<Point_3> limit_points(surface.number_of_vertices());
  std::vector<Vector_3> limit_normals(surface.number_of_vertices());
  const auto keep = [&](Surface::Vertex_index v, const pn_subdivide::Limit_point& limit) {
    limit_points[v] = limit.point;
    // where the eigenvectors tell of no tangent plane the normals of the faces are closer to it
    limit_normals[v] = limit.has_surface_normal ? limit.surface_normal
                                                : Vector_3(n[3 * v], n[3 * v + 1], n[3 * v + 2]);
  };
  const pn_subdivide::Limit_map limits(keep);
  pn_subdivide::Limit_options options;
  options.tolerance = 1e-7; // a pixel is a thousandth
  options.surface_normals = true;
  options.rounds_done = rounds_;
  if (is_linear_)
    pn_subdivide::linear_limits(surface, scheme_, limits, options);
  else {
    const Normal_map normals = pn_subdivide::add_normals(surface);
    for (const auto v : surface.vertices()) normals[v] = refinement_->normals()[v];
    pn_subdivide::limits_with_normals(surface, normals, scheme_, limits, options);
  }
  limit_points_ = std::move(limit_points);
  limit_normals_ = std::move(limit_normals);
  display_.set(limit_points_, limit_normals_);
}

std::vector<float> Refined_surface::curvature(bool is_gaussian) const
{
  using Curvature = PN::Vertex_curvature<pn_subdivide::Kernel>;
  Surface surface = make_surface(display_.faces(), display_.vertices(), points());
  const auto curvatures =
    surface.add_property_map<Surface::Vertex_index, Curvature>("v:curvature").first;
  PN::estimate_curvature(surface, curvatures);
  std::vector<float> values;
  values.reserve(surface.number_of_vertices());
  for (const auto v : surface.vertices())
    values.push_back(static_cast<float>(is_gaussian ? curvatures[v].gaussian : curvatures[v].mean));
  return values;
}

} // namespace pn_demo

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVISION_3_DEMO_CREASED_REFINEMENT_H
#define PN_SUBDIVISION_3_DEMO_CREASED_REFINEMENT_H

#include "Refinement.h"

#include <CGAL/PN_subdivision_3.h>
#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
#include <CGAL/PN_subdivision_3/parameters/parameters.h>
#include <CGAL/boost/graph/iterator.h>

namespace pn_demo {

// Subdivides anew in every update().
template <class S, bool is_linear>
class Creased_refinement : public Refinement
{
public:
  Creased_refinement(const Control_mesh& mesh, const S& scheme, unsigned rounds)
    : scheme_(scheme)
    , rounds_(rounds)
  {
    CGAL::PN_subdivision_3::Attribute_table carried;
    const Surface refined = subdivide(mesh, carried);
    const Wedges wedges(refined, [&](Surface::Edge_index e) {
      return !carried.edges.empty() && carried.edges[0].values[e] > 0;
    });
    put_sides(mesh, refined, carried);
    for (const auto v : wedges.vertex) cut_vertices_.push_back(Index(v));
    for (const auto f : refined.faces()) {
      for (const auto h : halfedges_around_face(refined.halfedge(f), refined)) {
        faces_.corners.push_back(Index(refined.target(h)));
        cut_faces_.corners.push_back(Index(wedges.of_corner[h]));
        for (std::size_t k = 0; k < 2 && !carried.corners.empty(); ++k)
          uv_.push_back(carried.corners[0].values[2 * h + k]);
      }
      faces_.end.push_back(Index(faces_.corners.size()));
    }
    cut_faces_.end = faces_.end;
    all_.resize(points_.size());
    for (std::size_t v = 0; v < all_.size(); ++v) all_[v] = Index(v);
  }

  void follow(const Control_mesh&, std::size_t) override {}

  const std::vector<Index>& update(const Control_mesh& mesh) override
  {
    CGAL::PN_subdivision_3::Attribute_table carried;
    put_sides(mesh, subdivide(mesh, carried), carried);
    return all_;
  }

  const std::vector<Point_3>& points() const override { return points_; }
  const std::vector<Vector_3>& normals() const override { return normals_; }
  std::vector<double> roundness(const Control_mesh& mesh) const override
  {
    return mesh.has_roundness() ? roundness_ : std::vector<double>();
  }
  Faces faces() const override { return faces_; }
  const Faces* cut_faces() const override { return &cut_faces_; }
  const std::vector<Index>& cut_vertices() const override { return cut_vertices_; }
  const std::vector<double>& uv() const override { return uv_; }
  const Sides& sides() const override { return sides_; }

private:
  using Halfedge = Surface::Halfedge_index;

  template <class Key, class Value>
  static auto map_of(const Surface& surface, const char* name)
  {
    return CGAL::PN_subdivision_3::internal::find_property_map<Key, Value>(surface, name).value();
  }

  void put_sides(const Control_mesh& mesh, const Surface& refined,
                 const CGAL::PN_subdivision_3::Attribute_table& carried)
  {
    sides_ = Sides();
    if (mesh.number_of_sharp_edges() == 0) return;
    for (const auto e : refined.edges())
      for (unsigned i = 0; i < 2 && carried.edges[0].values[e] > 0; ++i)
        sides_.sharp_edges.push_back(Index(refined.source(refined.halfedge(e, i))));
    if constexpr (!is_linear) {
      const auto tangents = map_of<Halfedge, Vector_3>(refined, tangents_name);
      for (const Halfedge h : refined.halfedges())
        if (carried.edges[0].values[refined.edge(h)] > 0) sides_.tangents.push_back(tangents[h]);
      const auto of_corners = *pn_subdivide::corner_normals_of(refined);
      for (const auto f : refined.faces())
        for (const Halfedge h : halfedges_around_face(refined.halfedge(f), refined)) {
          const Corner_value& value = of_corners.whole(h);
          sides_.normals.push_back(value.normal);
          if (mesh.has_roundness()) sides_.roundness.push_back(value.roundness);
        }
    }
  }

  // `carried` gets the sharpness of the refined edges and the texture coordinates of the corners.
  Surface subdivide(const Control_mesh& mesh, CGAL::PN_subdivision_3::Attribute_table& carried)
  {
    namespace PN = CGAL::PN_subdivision_3;
    Surface surface = mesh.surface();
    const auto sharpness = map_of<Surface::Edge_index, double>(surface, "e:sharpness");
    if (mesh.number_of_sharp_edges() > 0) {
      carried.edges.emplace_back();
      for (const auto e : surface.edges()) carried.edges[0].values.push_back(sharpness[e]);
    }
    if (!mesh.uv().empty()) {
      carried.corners.emplace_back();
      carried.corners[0].dimension = 2;
      carried.corners[0].values = mesh.uv();
    }
    const auto np =
      PN::parameters::attributes(carried).number_of_iterations(rounds_).edge_is_constrained_map(
        sharpness);
    if constexpr (is_linear)
      PN::subdivide(surface, scheme_, np);
    else {
      const auto normals = *pn_subdivide::corner_normals_of(surface);
      const auto roundness = pn_subdivide::add_roundness(surface);
      for (const auto v : surface.vertices()) roundness[v] = mesh.value_at(v).roundness;
      const auto tangents =
        surface.add_property_map<Halfedge, Vector_3>(tangents_name, CGAL::NULL_VECTOR).first;
      PN::subdivide(surface, scheme_,
                    PN::parameters::join(
                      PN::parameters::vertex_roundness_map(roundness).crease_tangent_map(tangents),
                      np.vertex_normal_map(normals)));
      roundness_.assign(surface.number_of_vertices(), 1);
      normals_.assign(surface.number_of_vertices(), CGAL::NULL_VECTOR);
      for (const auto v : surface.vertices()) roundness_[v] = roundness[v];
      for (const Halfedge h : surface.halfedges())
        if (!surface.is_border(h)) normals_[surface.target(h)] = normals[h];
    }
    points_.assign(surface.points().begin(), surface.points().end());
    return surface;
  }

  static constexpr const char* tangents_name = "h:tangent";

  S scheme_;
  unsigned rounds_;
  std::vector<Point_3> points_;
  std::vector<Vector_3> normals_;
  std::vector<double> roundness_, uv_;
  Sides sides_;
  Faces faces_, cut_faces_;
  std::vector<Index> cut_vertices_, all_;
};

} // namespace pn_demo

#endif // PN_SUBDIVISION_3_DEMO_CREASED_REFINEMENT_H

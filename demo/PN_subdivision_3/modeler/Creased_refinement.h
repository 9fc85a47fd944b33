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
    if (mesh.number_of_sharp_edges() > 0)
      for (const auto e : refined.edges())
        if (carried.edges[0].values[e] > 0)
          for (unsigned i = 0; i < 2; ++i)
            sides_.sharp_edges.push_back(Index(refined.vertex(e, i)));
    for (const auto v : wedges.vertex) cut_vertices_.push_back(Index(v));
    const auto of_corners = pn_subdivide::corner_normals_of(refined);
    for (const auto f : refined.faces()) {
      for (const auto h : halfedges_around_face(refined.halfedge(f), refined)) {
        faces_.corners.push_back(Index(refined.target(h)));
        cut_faces_.corners.push_back(Index(wedges.of_corner[h]));
        if (!is_linear && !sides_.sharp_edges.empty()) {
          const Corner_value& value = of_corners->whole(h);
          sides_.normals.push_back(value.normal);
          if (mesh.has_roundness()) sides_.roundness.push_back(value.roundness);
        }
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
    subdivide(mesh, carried);
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
  static auto sharpness_of(const Surface& surface)
  {
    namespace PN = CGAL::PN_subdivision_3;
    return PN::internal::find_property_map<Surface::Edge_index, double>(surface, "e:sharpness")
      .value();
  }

  // `carried` gets the sharpness of the refined edges and the texture coordinates of the corners.
  Surface subdivide(const Control_mesh& mesh, CGAL::PN_subdivision_3::Attribute_table& carried)
  {
    namespace PN = CGAL::PN_subdivision_3;
    using Halfedge = Surface::Halfedge_index;
    Surface surface = mesh.surface();
    const auto sharpness = sharpness_of(surface);
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
      PN::subdivide(surface, scheme_,
                    PN::parameters::join(PN::parameters::vertex_roundness_map(roundness),
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

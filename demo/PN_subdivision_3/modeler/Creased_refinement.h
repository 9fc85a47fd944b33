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
#include <CGAL/PN_subdivision_3/parameters.h>
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
    const Surface refined = subdivide(mesh);
    const auto is_sharp = sharpness_of(refined);
    const Wedges wedges(refined, [&](Surface::Edge_index e) { return is_sharp[e] > 0; });
    for (const auto v : wedges.vertex) cut_vertices_.push_back(Index(v));
    for (const auto f : refined.faces()) {
      for (const auto h : halfedges_around_face(refined.halfedge(f), refined)) {
        faces_.corners.push_back(Index(refined.target(h)));
        cut_faces_.corners.push_back(Index(wedges.of_corner[h]));
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
    subdivide(mesh);
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

private:
  static auto sharpness_of(const Surface& surface)
  {
    namespace PN = CGAL::PN_subdivision_3;
    return PN::internal::find_property_map<Surface::Edge_index, double>(surface, "e:sharpness")
      .value();
  }

  Surface subdivide(const Control_mesh& mesh)
  {
    namespace PN = CGAL::PN_subdivision_3;
    using Halfedge = Surface::Halfedge_index;
    Surface surface = mesh.surface();
    const auto sharpness = sharpness_of(surface);
    const auto np = PN::parameters::attributes(PN::parameters::edge_attribute(sharpness))
                      .number_of_iterations(rounds_)
                      .edge_is_constrained_map(sharpness);
    if constexpr (is_linear)
      PN::subdivide(surface, scheme_, np);
    else {
      const auto normals =
        PN::internal::find_property_map<Halfedge, Vector_3>(surface, "h:normal").value();
      const pn_subdivide::Roundness_map roundness = *pn_subdivide::roundness_of(surface);
      PN::subdivide(surface, scheme_,
                    PN::parameters::join(PN::parameters::vertex_roundness_map(roundness),
                                         np.vertex_normal_map(normals)));
      roundness_.clear();
      for (const auto v : surface.vertices()) roundness_.push_back(roundness[v]);
      normals_.assign(surface.number_of_vertices(), CGAL::NULL_VECTOR);
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
  std::vector<double> roundness_;
  Faces faces_, cut_faces_;
  std::vector<Index> cut_vertices_, all_;
};

} // namespace pn_demo

#endif // PN_SUBDIVISION_3_DEMO_CREASED_REFINEMENT_H

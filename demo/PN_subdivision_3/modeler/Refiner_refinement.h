// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVISION_3_DEMO_REFINER_REFINEMENT_H
#define PN_SUBDIVISION_3_DEMO_REFINER_REFINEMENT_H

#include "Creased_refinement.h"

#include <CGAL/PN_subdivision_3/Surface_refiner.h>

namespace pn_demo {

// By a Surface_refiner, so that an update costs what the change reaches.
template <class S, bool is_linear>
class Refiner_refinement : public Refinement
{
  using Refiner = CGAL::PN_subdivision_3::Surface_refiner<Surface, S, pn_subdivide::Kernel>;

public:
  Refiner_refinement(const Control_mesh& mesh, const S& scheme, unsigned rounds)
    : scheme_(scheme)
    , rounds_(rounds)
    , refiner_(make(mesh, scheme, rounds))
  {
    all_.resize(refiner_->number_of_vertices());
    for (std::size_t v = 0; v < all_.size(); ++v) all_[v] = Index(v);
  }

  void follow(const Control_mesh& mesh, std::size_t vertex) override
  {
    const Surface& surface = mesh.surface();
    const Surface::Vertex_index v{Surface::size_type(vertex)};
    refiner_->set_point(v, surface.point(v));
    if constexpr (!is_linear) refiner_->set_normal(v, normal_at(mesh, v));
  }

  const std::vector<Index>& update(const Control_mesh&) override { return refiner_->update(); }

  const std::vector<Point_3>& points() const override { return refiner_->points(); }
  const std::vector<Vector_3>& normals() const override { return refiner_->normals(); }
  const std::vector<Index>& cut_vertices() const override { return all_; }

  // A refiner does not tell: the mesh is subdivided once more, which limit points take longer than.
  std::vector<double> roundness(const Control_mesh& mesh) const override
  {
    if (is_linear || !mesh.has_roundness()) return {};
    return Creased_refinement<S, is_linear>(mesh, scheme_, rounds_).roundness(mesh);
  }

  Faces faces() const override
  {
    const auto level = refiner_->connectivity();
    Faces faces;
    for (Index f = 0; f < level.number_of_faces(); ++f) {
      const Index first = level.halfedge_of_face(f);
      Index h = first;
      do {
        faces.corners.push_back(level.target(h));
        h = level.next(h);
      } while (h != first);
      faces.end.push_back(Index(faces.corners.size()));
    }
    return faces;
  }

private:
  static Vector_3 normal_at(const Control_mesh& mesh, Surface::Vertex_index v)
  {
    const Surface& surface = mesh.surface();
    if (surface.is_isolated(v)) return CGAL::NULL_VECTOR;
    Surface::Halfedge_index h = surface.halfedge(v);
    if (surface.is_border(h)) h = surface.prev(surface.opposite(h));
    return mesh.normal_at(h);
  }

  static std::unique_ptr<Refiner> make(const Control_mesh& mesh, const S& scheme, unsigned rounds)
  {
    const auto np = CGAL::parameters::number_of_iterations(rounds);
    if constexpr (is_linear)
      return std::make_unique<Refiner>(mesh.surface(), scheme, np);
    else {
      Surface copy = mesh.surface();
      const auto normals = copy.add_property_map<Surface::Vertex_index, Vector_3>("v:normal").first;
      for (const auto v : copy.vertices()) normals[v] = normal_at(mesh, v);
      const pn_subdivide::Roundness_map roundness = *pn_subdivide::roundness_of(copy);
      return std::make_unique<Refiner>(
        copy, scheme,
        CGAL::PN_subdivision_3::parameters::join(
          CGAL::PN_subdivision_3::parameters::vertex_roundness_map(roundness),
          np.vertex_normal_map(normals)));
    }
  }

  S scheme_;
  unsigned rounds_;
  std::unique_ptr<Refiner> refiner_;
  std::vector<Index> all_;
};

} // namespace pn_demo

#endif // PN_SUBDIVISION_3_DEMO_REFINER_REFINEMENT_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVISION_3_DEMO_REFINER_REFINEMENT_H
#define PN_SUBDIVISION_3_DEMO_REFINER_REFINEMENT_H

#include "Refinement.h"

#include <CGAL/PN_subdivision_3/Surface_refiner.h>
#include <CGAL/PN_subdivision_3/parameters/parameters.h>

#include <type_traits>

namespace pn_demo {

// By a Surface_refiner, so that an update costs what the change reaches.
template <class S, bool is_linear>
class Refiner_refinement : public Refinement
{
  using Refiner = CGAL::PN_subdivision_3::Surface_refiner<Surface, S, pn_subdivide::Kernel>;

public:
  // `mesh`: a Control_mesh or, for a linear scheme, a Surface
  template <class Mesh>
  Refiner_refinement(const Mesh& mesh, const S& scheme, unsigned rounds)
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
    if constexpr (!is_linear) refiner_->set_normal(v, mesh.value_at(v).normal);
  }

  const std::vector<Index>& update(const Control_mesh&) override { return refiner_->update(); }

  const std::vector<Point_3>& points() const override { return refiner_->points(); }
  const std::vector<Vector_3>& normals() const override { return refiner_->normals(); }
  const std::vector<Index>& cut_vertices() const override { return all_; }

  // That of a new vertex is the average of the old ones with the weights of the points: a coordinate of the linear surface.
  std::vector<double> roundness(const Control_mesh& mesh) const override
  {
    std::vector<double> result;
    if constexpr (!is_linear) {
      if (!mesh.has_roundness()) return result;
      Surface copy = mesh.surface();
      for (const auto v : copy.vertices())
        copy.point(v) = Point_3(mesh.value_at(v).roundness, 0, 0);
      const auto linear = CGAL::PN_subdivision_3::linear(scheme_);
      const Refiner_refinement<std::decay_t<decltype(linear)>, true> refined(copy, linear, rounds_);
      for (const Point_3& p : refined.points()) result.push_back(p.x());
    }
    return result;
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
  static std::unique_ptr<Refiner> make(const Surface& surface, const S& scheme, unsigned rounds)
  {
    return std::make_unique<Refiner>(surface, scheme,
                                     CGAL::parameters::number_of_iterations(rounds));
  }
  static std::unique_ptr<Refiner> make(const Control_mesh& mesh, const S& scheme, unsigned rounds)
  {
    if constexpr (is_linear)
      return make(mesh.surface(), scheme, rounds);
    else {
      Surface copy = mesh.surface();
      const auto normals = pn_subdivide::add_normals(copy);
      const auto roundness = pn_subdivide::add_roundness(copy);
      for (const auto v : copy.vertices()) {
        const Corner_value value = mesh.value_at(v);
        normals[v] = value.normal;
        roundness[v] = value.roundness;
      }
      return std::make_unique<Refiner>(
        copy, scheme,
        CGAL::PN_subdivision_3::parameters::join(
          CGAL::PN_subdivision_3::parameters::vertex_roundness_map(roundness),
          CGAL::parameters::number_of_iterations(rounds).vertex_normal_map(normals)));
    }
  }

  S scheme_;
  unsigned rounds_;
  std::unique_ptr<Refiner> refiner_;
  std::vector<Index> all_;
};

} // namespace pn_demo

#endif // PN_SUBDIVISION_3_DEMO_REFINER_REFINEMENT_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVISION_3_DEMO_REFINED_SURFACE_H
#define PN_SUBDIVISION_3_DEMO_REFINED_SURFACE_H

#include "Control_mesh.h"
#include "Display_mesh.h"
#include "Refinement.h"

#include <memory>
#include <string>
#include <vector>

namespace pn_demo {

// What the page knows about a scheme.
struct Scheme_traits
{
  std::string name;
  bool takes_triangles, takes_quads, has_crease_rules, has_limit_points;
};
std::vector<Scheme_traits> scheme_traits();

// The surface of a control mesh after some rounds of a scheme, and what is shown of it. Throws
// std::exception with a line for the user.
class Refined_surface
{
public:
  // `origin`: what the display's positions are relative to.
  Refined_surface(const Control_mesh& mesh, const std::string& scheme, unsigned rounds,
                  bool is_linear, const Point_3& origin);

  // A control vertex has moved or its normal has turned. To be called before update().
  void follow(const Control_mesh& mesh, std::size_t vertex);
  void update(const Control_mesh& mesh);
  // Shows the points of the limit surface and its normals, until hide_limit() or the next update().
  void show_limit(const Control_mesh& mesh);
  void hide_limit();
  // 0 where there is no estimate; by the vertices of the display. Both are kept until something is shown anew.
  const std::vector<float>& curvature(bool is_gaussian);

  const Display_mesh& display() const { return display_; }
  // Points, control normals and faces as for a file; with show_limit() those of the limit.
  const std::vector<Point_3>& points() const;
  const std::vector<Vector_3>& normals() const;
  Faces faces() const { return refinement_->faces(); }
  // Of the corners of faces().
  const std::vector<double>& uv() const { return refinement_->uv(); }
  const Sides& sides() const { return refinement_->sides(); }
  // Beside the control normals; empty: 1.
  std::vector<double> roundness(const Control_mesh& mesh) const
  {
    return refinement_->roundness(mesh);
  }

private:
  void show_all();
  void compute_curvatures();

  Scheme scheme_;
  bool is_linear_;
  unsigned rounds_;
  std::unique_ptr<Refinement> refinement_;
  Display_mesh display_;
  std::vector<Point_3> limit_points_; // if they are shown
  std::vector<Vector_3> limit_normals_;
  std::vector<float> gaussian_curvature_, mean_curvature_; // empty if not computed yet
};

} // namespace pn_demo

#endif // PN_SUBDIVISION_3_DEMO_REFINED_SURFACE_H

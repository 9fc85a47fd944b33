// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVISION_3_DEMO_REFINEMENT_H
#define PN_SUBDIVISION_3_DEMO_REFINEMENT_H

#include "Control_mesh.h"
#include "surface/surface_schemes.h"

#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/schemes/Any_scheme.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace pn_demo {

using Index = std::uint32_t;
using pn_subdivide::Scheme;

// Faces as vertices one after the other.
struct Faces
{
  std::vector<Index> end; // where each face ends in `corners`
  std::vector<Index> corners;
};

// What has another value on each side of a crease: for the corners of the faces.
struct Sides
{
  std::vector<Index> sharp_edges; // pairs of vertices; empty: there is nothing
  std::vector<Vector_3> tangents; // at these, into the edges; empty if linear
  std::vector<Vector_3> normals;  // empty if linear
  std::vector<double> roundness;  // empty: 1
};

// The refined surface of a control mesh, which follows it.
class Refinement
{
public:
  virtual ~Refinement() = default;

  // What is said of a control vertex counts from the next update() on.
  virtual void follow(const Control_mesh& mesh, std::size_t vertex) = 0;
  // Returns the vertices that have new points.
  virtual const std::vector<Index>& update(const Control_mesh& mesh) = 0;

  virtual const std::vector<Point_3>& points() const = 0;
  // Control normals; empty with linear schemes.
  virtual const std::vector<Vector_3>& normals() const = 0;
  // Of the refined vertices, from the control mesh as it is; empty: 1.
  virtual std::vector<double> roundness(const Control_mesh& mesh) const = 0;
  virtual Faces faces() const = 0;
  // Vertices as a renderer needs them, those on creases several times: the faces, and for each of these
  // vertices its number in points(). Empty: no creases.
  virtual const Faces* cut_faces() const { return nullptr; }
  virtual const std::vector<Index>& cut_vertices() const = 0;
  // Texture coordinates, two of each corner of faces(); empty: the control mesh has none.
  virtual const std::vector<double>& uv() const
  {
    static const std::vector<double> none;
    return none;
  }
  virtual const Sides& sides() const
  {
    static const Sides none;
    return none;
  }
};

// Throws if the mesh has creases and the scheme no rules for them.
std::unique_ptr<Refinement> make_refinement(const Control_mesh& mesh, const Scheme& scheme,
                                            unsigned rounds, bool is_linear);

} // namespace pn_demo

#endif // PN_SUBDIVISION_3_DEMO_REFINEMENT_H

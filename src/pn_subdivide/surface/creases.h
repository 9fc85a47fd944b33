// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_CREASES_H
#define PN_SUBDIVIDE_CREASES_H

#include "io/Report.h"
#include "surface/Crease_plan.h"
#include "surface/Surface.h"

#include <optional>
#include <string>
#include <vector>

namespace pn_subdivide {

// What is sharp in a mesh.
struct Creases
{
  std::vector<double> edges, vertices; // sharpness, by the numbers of make_surface()
  std::size_t number_of_edges = 0, number_of_vertices = 0; // that are sharp
  Border border = Border::surface;

  bool any() const { return number_of_edges + number_of_vertices > 0; }
  bool is_sharp(Surface::Edge_index e) const { return !edges.empty() && edges[e] > 0; }
  std::string description() const; // empty, or for the closing line: ", 14 sharp edges"
};

// Warns if nothing is sharp although it was asked for, and if there are normals for creases that are
// none; `scheme` is the scheme without rules for creases, or empty. Throws Error.
Creases find_creases(const Mesh_data& mesh, const Crease_plan& plan, const std::string& scheme,
                     const std::string& name, Report& report);

using Edge_sharpness = Surface::Property_map<Surface::Edge_index, double>;
using Vertex_sharpness = Surface::Property_map<Surface::Vertex_index, double>;

struct Crease_maps
{
  Edge_sharpness edges;
  Vertex_sharpness vertices;
  Border border;
};
Crease_maps add_creases(Surface& surface, const Creases& creases);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_CREASES_H

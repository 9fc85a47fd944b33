// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_VERTEX_CURVATURE_H
#define PN_SUBDIVIDE_VERTEX_CURVATURE_H

#include "io/Mesh_data.h"
#include "io/mesh_io.h"
#include "surface/Surface.h"
#include "surface/creases.h"
#include "surface/surface_schemes.h"

#include <cstddef>
#include <optional>
#include <string>

namespace pn_subdivide {

// The color of a value between -1 and 1, beyond which it stays: blue, white at 0, red. Lightness and
// hue change evenly (linear in CIELAB); the ends are equally dark, and those of Moreland, "Diverging
// Color Maps for Scientific Visualization" (2009). scripts/render.py draws with the same colors.
Color diverging_color(double value);

enum class Curvature_kind { gaussian, mean };

// `gaussian` or `mean`, and a file that can hold it. Throws Usage_error.
Curvature_kind parse_curvature_option(const std::string& text, const Mesh_file& output);

struct Curvature_range
{
  double least = 0, greatest = 0;   // of the values
  double end = 0;                   // the value at the end of the colors, the other one is -end
  std::size_t without_estimate = 0; // vertices
  bool replaces_attributes = false;

  std::string description(Curvature_kind kind) const;
};

// One value a vertex of a mesh without garbage, positive where the surface bends away from the side from which its faces
// are seen counterclockwise. Vertices at which it cannot be estimated get 0 and are counted. Passes on the library's
// exceptions.
struct Curvature_values
{
  std::vector<double> values;
  std::size_t without_estimate = 0;
};
// Of points and normals of the surface. Across creases nothing is measured: vertices with several wedges have the mean of
// their curvatures.
Curvature_values measure_curvature(const Surface& surface,
                                   const std::optional<Crease_maps>& creases, Curvature_kind kind);
// Of the limit of a mesh of the given level with its control normals; of its points alone where limits are not known.
Curvature_values measure_limit_curvature(Surface mesh, const Wedge_list& wedges,
                                         const Scheme_choice& scheme,
                                         const std::optional<Crease_maps>& creases, unsigned levels,
                                         Curvature_kind kind);

// Gives the vertices the values and colors for them, in place of attributes of the same name.
Curvature_range set_curvature(Mesh_data& mesh, Curvature_kind kind, Curvature_values curvature);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_VERTEX_CURVATURE_H

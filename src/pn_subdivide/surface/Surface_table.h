// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_SURFACE_TABLE_H
#define PN_SUBDIVIDE_SURFACE_TABLE_H

#include "io/Report.h"
#include "surface/Recognized_part.h"

#include <string>
#include <vector>

namespace pn_subdivide {

// How far a mesh is from the surfaces that its faces belong to: its vertices, and the middles of its edges and faces.
struct Deviation
{
  double of_vertices = 0, of_faces = 0;
};
// One a segment; zero for unknown ones. Segments are those of the faces.
std::vector<Deviation> deviations(const Surface& surface, const std::vector<double>& segments,
                                  const std::vector<Recognized_surface>& surfaces);

// What was found in a part, and what has become of it.
class Surface_table
{
public:
  Surface_table(const Recognized_part& part, const Mesh_data& control);

  // of the refined mesh
  void measure(const Surface& refined, const std::vector<double>& segments);
  // the largest that was measured on known surfaces
  double largest_deviation() const;

  // Several lines: numbers of each kind, and a table of what is round.
  std::string text() const;
  std::vector<Report::Row> rows() const;
  void warn(const std::string& input, Report& report) const;

private:
  const Recognized_part& part_;
  std::vector<Deviation> before_, after_;
};

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_SURFACE_TABLE_H

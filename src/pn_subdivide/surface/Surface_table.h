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

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace pn_subdivide {

// How far a mesh is from the surfaces that its faces belong to: its vertices, and the middles of its edges and faces.
struct Deviation
{
  double of_vertices = 0, of_faces = 0;
};

// What was found in a part, and what has become of it.
class Surface_table
{
public:
  Surface_table(const Recognized_part& part, const Surface& control);

  // The numbers of the faces take the place of the segments until the refined mesh is measured.
  void number_faces(Attributes& attributes) const;
  void measure(const Surface& refined, Attributes& attributes);
  void set_crossed_planes(std::size_t number) { crossed_planes_ = number; }
  // Forgets the folds of what has got other faces: is_replaced(segment).
  template <class Is_replaced>
  void forget_folds(const Is_replaced& is_replaced)
  {
    folded_faces_.erase(
      std::remove_if(folded_faces_.begin(), folded_faces_.end(),
                     [&](std::size_t f) { return is_replaced(part_.segments[f]); }),
      folded_faces_.end());
  }

  // Several lines: numbers of each kind, and a table of what is round.
  std::string text() const;
  std::vector<Report::Row> rows() const;
  void warn(const std::string& input, Report& report) const;
  // How far triangles within a tolerance of the limit surface are from the surfaces themselves, which need not be the same.
  void report_chord(double chord, const std::string& output, Report& report) const;

private:
  double along(const Face_place& place, std::size_t segment) const;
  bool is_folded(const Face_place& place, std::size_t segment) const;

  const Recognized_part& part_;
  std::vector<Deviation> before_, after_;
  std::vector<double> along_;             // of the segments: their faces' sum
  std::vector<bool> was_folded_;          // of the control faces
  std::vector<std::size_t> folded_faces_; // that were not
  std::size_t crossed_planes_ = 0;
};

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_SURFACE_TABLE_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_REFERENCE_SURFACE_H
#define PN_SUBDIVIDE_REFERENCE_SURFACE_H

#include "surface/Surface.h"

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace pn_subdivide {

struct Recognized_part;

// What results are held against: a control mesh whose faces on recognized round surfaces are replaced by pieces of these.
// Coordinates are those of a frame, (x - shift) / scale.
class Reference_surface
{
public:
  using Triple = std::array<double, 3>;
  struct Frame
  {
    double scale;
    Triple shift;
  };

  // points: of the control mesh, in the frame; part: what is recognized there, or nullptr
  Reference_surface(const Surface& control, const std::vector<Triple>& points, const Frame& frame,
                    const Recognized_part* part);
  ~Reference_surface();

  bool has_round_surfaces() const { return has_round_surfaces_; }
  // by which the volume of closed control meshes is less
  double gained_volume() const { return gained_volume_; }
  double distance(const Triple& p) const;

private:
  class Pieces;
  struct Tree;

  bool has_round_surfaces_ = false;
  double gained_volume_ = 0;
  std::unique_ptr<Tree> tree_;
};

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_REFERENCE_SURFACE_H

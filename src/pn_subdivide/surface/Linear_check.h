// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_LINEAR_CHECK_H
#define PN_SUBDIVIDE_LINEAR_CHECK_H

#include "io/Limit_choice.h"
#include "io/Report.h"
#include "surface/Surface.h"
#include "surface/creases.h"
#include "surface/surface_schemes.h"

#include <CGAL/PN_subdivision_3/compare_with_linear.h>

#include <cstddef>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

namespace pn_subdivide {

// Edges that are not sharp and that --sharp angle:40 would make sharp.
std::size_t number_of_turning_edges(const Mesh_data& mesh, const Creases& creases);
// "12 edges turn by more than 40 degrees"
std::string turning_edges_text(std::size_t number, const std::string& edge = "edge");

// --check: what is worse than in the linear result, and what helps.
class Linear_check
{
public:
  using Comparison = CGAL::PN_subdivision_3::Comparison_with_linear;

  // What was chosen, which the advice depends on.
  struct Choices
  {
    bool may_tag = false; // edges could be sharp, and nobody said which
    bool has_given_normals = false;
    std::optional<double> roundness; // the same everywhere
    // if it varies, of control vertices
    std::size_t of_roundness_0 = 0, of_roundness_below_1 = 0;
  };
  struct Rounds
  {
    unsigned levels, threads;
    Limit_choice limit;
  };

  // The control mesh as it was read; the creases are those of its edges.
  Linear_check(const Surface& control, const Creases& creases, const Choices& choices);
  // What is refined: the control mesh, or what interpolation has made of it.
  void set_net(const Surface& net, const std::optional<Crease_maps>& creases);

  // Makes the linear result, and measures.
  void compare(const Surface& result, const std::optional<Crease_maps>& creases,
               const Scheme_choice& scheme, const Rounds& rounds);

  // Throws Error if that cannot be written. To be called before a file is.
  void print(std::FILE* stream) const;
  std::vector<Report::Value> values() const;

private:
  std::string verdict() const; // of words for --check, or empty
  std::string advice() const;
  std::vector<std::string> lines() const;

  Choices choices_;
  Surface control_, net_;
  std::optional<Crease_maps> control_creases_, net_creases_;
  Comparison comparison_;
};

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_LINEAR_CHECK_H

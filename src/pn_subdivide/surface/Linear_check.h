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

#include <array>
#include <cstddef>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
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

// Edges that are not sharp and that --sharp angle:40 would make sharp, and all edges.
struct Turning_edges
{
  std::size_t number = 0, of = 0;
};
Turning_edges find_turning_edges(const Mesh_data& mesh, const Creases& creases);
// "12 edges turn by more than 40 degrees"
std::string turning_edges_text(std::size_t number, const std::string& edge = "edge");

// What is measured of a mesh against the control mesh and its recognized surfaces.
struct Mesh_measures
{
  std::optional<double> volume; // as a part of theirs, of closed meshes that have one
  // by more than 90, and 150, degrees; but sharp ones, if both results tell which these are
  std::size_t folded_edges = 0, sharply_folded_edges = 0;
  // of these edges, by the size of the mesh; without those of right angles, whatever their rounding
  double folded_length = 0, sharply_folded_length = 0;
  double distance = 0; // the largest of a vertex
  std::size_t farthest_vertex = 0;

  bool is_swollen() const;
  bool is_lost() const;
  // beyond the folds of the control mesh
  bool is_folded(const Mesh_measures& control) const;
};

// --check: whether the shape of the control mesh is kept, beside the linear result, and what helps.
class Linear_check
{
public:
  // What was chosen, which the advice depends on.
  struct Choices
  {
    bool may_tag = false;     // edges could be sharp, and nobody said which
    bool may_be_part = false; // --part would be another way
    bool has_given_normals = false;
    bool may_interpolate = false;
    std::optional<double> roundness;       // the same everywhere
    const Recognized_part* part = nullptr; // what is recognized, or nullptr
  };
  struct Rounds
  {
    unsigned levels;
    Limit_choice limit;
    std::optional<double> chord; // triangles within that
  };

  // The control mesh as it was read; the creases are those of its edges.
  Linear_check(const Surface& control, const Creases& creases, const Choices& choices);
  // What is refined: the control mesh, or what interpolation has made of it.
  void set_net(const Surface& net, const std::optional<Crease_maps>& creases);

  // Makes the linear result, and measures.
  void compare(const Surface& result, const Scheme_choice& scheme, const Rounds& rounds);

  // Throws Error if that cannot be written. To be called before a file is.
  void print(std::FILE* stream) const;
  Report::Row values() const;

private:
  void make_linear(const Scheme_choice& scheme, const Rounds& rounds);
  std::string verdict(const Mesh_measures& m) const; // "SWOLLEN, FOLDED", "kept"
  bool is_bad(const Mesh_measures& m) const;
  std::string advice() const;
  std::vector<std::string> lines() const;

  Choices choices_;
  Surface control_, net_;
  std::vector<bool> is_sharp_; // of the edges of the control mesh
  std::optional<Crease_maps> net_creases_;
  Turning_edges turning_;
  std::size_t of_roundness_0_ = 0, of_roundness_below_1_ = 0; // if it varies, of control vertices
  std::string reference_;                                     // its name
  Mesh_measures of_control_, of_result_, of_linear_;
};

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_LINEAR_CHECK_H

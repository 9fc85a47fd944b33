// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_TESSELLATION_FACE_SELECTION_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_TESSELLATION_FACE_SELECTION_H

#include <CGAL/PN_limit_surface_3/internal/tessellation/Adaptive_level.h>
#include <CGAL/PN_limit_surface_3/internal/tessellation/Split_edges.h>
#include <CGAL/PN_limit_surface_3/tessellation/Tessellation_result.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// how many triangles there are where the tolerance is out of reach
constexpr double triangles_out_of_reach = 0x1p18;

struct Tessellation_demand
{
  double tolerance; // of the triangles, divided by 2^exponent, as is what flatness is told from
  int exponent;
  unsigned most_rounds; // at least one is done where faces are not triangles or quadrilaterals
  std::uint64_t most_triangles;
  Limit_demand limits;
  bool is_proven = false;
};

// Selects the faces of the levels that are split: they are not flat enough for a tolerance that the number of triangles allows.
// Every face becomes a node of a tree once it is decided; faces that are not split are its leaves.
template <class Host, class FT, class Value, class Level_creases>
class Face_selection
{
public:
  using Index = Level_connectivity::Index;
  using Level = Adaptive_level<Value, Level_creases>;
  using Bounds = Face_bounds<Value, Level_creases>;
  using Flatness = Face_flatness<FT, Level>;
  using Obstacle = Tessellation_result::Obstacle;

  Face_selection(const Tessellation_demand& demand, const For_chunks& for_chunks, Bounds* bounds,
                 Split_edges<FT>& all)
    : demand_(demand)
    , tolerance_((std::max)(demand.tolerance, least_tolerance))
    , obstacle_(demand.tolerance < least_tolerance ? Obstacle::digits : Obstacle::none)
    , for_chunks_(for_chunks)
    , bounds_(bounds)
    , all_(all)
  {}

  // nodes of an earlier refinement of the same mesh, of which some have to be split now
  void begin(std::deque<Tessellation_node>&& before) { before_ = std::move(before); }
  void end() { before_.clear(); }

  const Tessellation_demand& demand() const { return demand_; }
  // the tolerance of the demand, or a larger one that is in reach
  double tolerance() const { return tolerance_; }
  Obstacle obstacle() const { return obstacle_; }
  std::deque<Tessellation_node>& nodes() { return nodes_; }
  // the corners of each node, if there are any
  const std::vector<std::vector<double>>& corners_of_nodes() const { return corners_of_nodes_; }

  // whether a face may be a leaf, as a triangle or a quadrilateral
  static bool is_leaf(const Level& level, Index f)
  {
    const Index h = level.level.level.halfedge_of_face(f);
    return level.level.level.has_degree(h, 3) || level.level.level.has_degree(h, 4);
  }

  // marks the faces that get a round to be seen; whether there are any
  static bool mark_unseen(Level& level)
  {
    bool has_unseen = false;
    for (Index f = 0; f < level.faces.size(); ++f) {
      Adaptive_face& face = level.faces[f];
      face.is_split = face.is_wanted && face.seen == Adaptive_face::Seen::none && is_leaf(level, f);
      has_unseen = has_unseen || face.is_split;
    }
    return has_unseen;
  }

  // Decides which faces are split, and stores the others; whether there are any to be split. Faces that go by their parents
  // come first, then faces whose limits after the round are known. `rounds` have been made of these faces.
  bool select(Level& level, bool is_second, unsigned rounds)
  {
    using Seen = Adaptive_face::Seen;
    const auto is_candidate = [&](Index f) {
      const Adaptive_face& face = level.faces[f];
      return face.is_wanted && (is_second ? face.seen == Seen::of_itself
                                          : face.seen == Seen::of_parent || !is_leaf(level, f));
    };
    std::vector<Index> faces;
    for (Index f = 0; f < level.faces.size(); ++f)
      if (is_candidate(f)) faces.push_back(f);
    if (faces.empty()) return false;
    const Flatness flatness(level, all_);
    std::vector<Face_error> errors(faces.size());
    if (bounds_ != nullptr) bounds_->begin(level);
    for_chunks_(static_cast<Index>(faces.size()), [&](Index begin, Index end) {
      for (Index i = begin; i < end; ++i) errors[i] = error(level, flatness, faces[i]);
    });
    constexpr std::uint64_t triangles = Host::refined_degree == 4 ? 8 : 4;
    relax(errors, triangles / 4);
    std::uint64_t number = 0;
    for (std::size_t i = 0; i < faces.size(); ++i) {
      Adaptive_face& face = level.faces[faces[i]];
      add_node(face, rounds);
      face.is_split = nodes_[face.node].has_to_be_split || !(errors[i].error <= tolerance_);
      number += face.is_split ? 1 : 0;
    }
    const bool are_too_many = number_of_leaves_ * 2 + number * triangles > demand_.most_triangles;
    const bool is_last = rounds >= demand_.most_rounds || are_too_many;
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const Index f = faces[i];
      Adaptive_face& face = level.faces[f];
      if (is_last && face.is_split && is_leaf(level, f)) {
        face.is_split = false;
        --number;
        if (!(errors[i].error <= tolerance_))
          meet(are_too_many ? Obstacle::triangles : Obstacle::rounds);
        if (bounds_ != nullptr) errors[i].error = (*bounds_)(f, flatness.places(f), infinity);
      }
      fill_node(level, flatness, f, errors[i]);
    }
    return number != 0;
  }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr Index null = Level_connectivity::null;
  struct Face_error
  {
    double error = 0;
    bool has_flatter_second = false; // see Tessellation_leaf
  };

  static constexpr double least_tolerance = 0x1p-48; // what coordinates in double can tell
  // The sagitta of halves is a fourth; errors that are known badly may fall more slowly.
  static constexpr double rest_of_discrepancy = 0.5, rest_of_distance = 0.45, least_rest = 0.27;
  // where a normal is not to be trusted, and the surface not smooth about the vertex
  static constexpr double distrust = 2;

  // The number of triangles is inverse to the tolerance. If more would be needed than are allowed, the tolerance becomes one
  // that is in reach.
  void relax(const std::vector<Face_error>& errors, unsigned triangles)
  {
    double expected = 0;
    for (const Face_error& e : errors)
      if (e.error > tolerance_ && e.error < infinity)
        expected += triangles * (e.error / tolerance_);
    if (!(expected > double(demand_.most_triangles))) return;
    tolerance_ *= expected / triangles_out_of_reach;
    meet(Obstacle::triangles);
  }

  // the first one counts
  void meet(Obstacle obstacle)
  {
    if (obstacle_ == Obstacle::none) obstacle_ = obstacle;
  }

  // Children have the order that they had before.
  void add_node(Adaptive_face& face, unsigned rounds)
  {
    const Index parent = face.node;
    face.node = static_cast<Index>(nodes_.size());
    nodes_.emplace_back();
    nodes_.back().may_be_split = rounds < demand_.most_rounds;
    if (parent != null) {
      if (face.before != null)
        face.before = before_[face.before].child(nodes_[parent].number_of_children);
      nodes_[parent].add_child(face.node);
    } else
      face.before = before_.empty() ? null : face.node;
    if (face.before != null) nodes_.back().has_to_be_split = before_[face.before].has_to_be_split;
  }
  void fill_node(Level& level, const Flatness& flatness, Index f, const Face_error& error)
  {
    const Adaptive_face& face = level.faces[f];
    Tessellation_node& node = nodes_[face.node];
    node.is_leaf = !face.is_split;
    number_of_leaves_ += node.is_leaf ? 1 : 0;
    if (!is_leaf(level, f))
      for_each_halfedge_of_face(
        level.level.level, f, [&](Index h) { all_.pin(level.edges[Level_connectivity::edge(h)]); });
    else {
      node.leaf.error = error.error;
      node.leaf.has_flatter_second = error.has_flatter_second;
      flatness.read(f, node.leaf);
    }
    if (!level.corners.empty()) corners_of_nodes_.push_back(level.corners[f]);
  }

  Face_error error(const Level& level, const Flatness& flatness, Index f) const
  {
    if (!is_leaf(level, f)) return {infinity, false};
    const auto estimate = flatness.estimate(f);
    const Adaptive_face& face = level.faces[f];
    const bool is_seen = face.seen == Adaptive_face::Seen::of_itself;
    double e = (is_seen ? 1 : rest_of_distance) * face.measured;
    if (estimate.knows_normals) {
      const double by_normals =
        estimate.error + (is_seen ? 1 : rest_of_discrepancy) * face.discrepancy;
      e = is_seen ? (std::max)(e, by_normals) : by_normals;
    } else if (!estimate.trusts_normals)
      e *= distrust;
    else if (!is_seen) // control normals may be off, but tell which way the surface goes
      e = (std::max)(least_rest * face.measured,
                     (std::min)(e, estimate.error + rest_of_discrepancy * face.discrepancy));
    e = (estimate.is_at_curve ? safety_at_curves : tessellation_safety) *
        (std::max)(e, estimate.along_curves);
    if (bounds_ != nullptr && e <= tolerance_) e = (*bounds_)(f, flatness.places(f), tolerance_);
    return {e, estimate.has_flatter_second};
  }

  const Tessellation_demand demand_;
  double tolerance_;
  Obstacle obstacle_;
  For_chunks for_chunks_;
  Bounds* const bounds_; // are there if they are demanded
  Split_edges<FT>& all_;
  std::vector<std::vector<double>> corners_of_nodes_;
  std::deque<Tessellation_node> nodes_; // a deque does not copy nodes when it grows
  std::deque<Tessellation_node> before_;
  std::uint64_t number_of_leaves_ = 0;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_TESSELLATION_FACE_SELECTION_H

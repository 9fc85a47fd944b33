// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_TESSELLATION_MERGED_LEAVES_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_TESSELLATION_MERGED_LEAVES_H

#include <CGAL/PN_limit_surface_3/internal/limit_surface/Flatness.h>
#include <CGAL/PN_limit_surface_3/internal/tessellation/Leaf_triangles.h>
#include <CGAL/PN_limit_surface_3/internal/tessellation/Split_edges.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <deque>
#include <limits>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// Takes splits back that did not have to be, since faces are split both ways although the surface is bent one way
// only: a face becomes a leaf again, with the vertices on its sides, where its triangles are flat enough without the
// vertices inside. Straight sides lose their vertices, if no face beyond needs them.
template <class FT>
class Merged_leaves
{
public:
  using Index = Level_connectivity::Index;

  // `tolerance` is that of the triangles
  Merged_leaves(Split_edges<FT>& all, std::deque<Tessellation_node>& nodes, double tolerance)
    : all_(all)
    , nodes_(nodes)
    , tolerance_(tolerance)
    , users_(all.number_of_edges(), 0)
    , trial_(all, tolerance)
  {
    for (Index e = 0; e < users_.size(); ++e) users_[e] = all.edge(e).is_pinned ? 1 : 0;
    for (const Tessellation_node& node : nodes_)
      if (!node.is_leaf)
        for (Index i = 0; i < node.leaf.degree; ++i) ++users_[node.leaf.halfedges[i] / 2];
  }

  // children come after their parents
  void operator()()
  {
    for (std::size_t n = nodes_.size(); n-- > 0;)
      if (may_merge(nodes_[n])) merge(nodes_[n]);
  }

private:
  // of the tolerance: what counts as straight
  static constexpr double straight = 1. / 1024;

  bool may_merge(const Tessellation_node& node) const
  {
    if (node.is_leaf || node.has_to_be_split || node.leaf.degree == 0 ||
        node.number_of_children == 0)
      return false;
    for (Index i = 0; i < node.number_of_children; ++i)
      if (!nodes_[node.child(i)].is_leaf) return false;
    return true;
  }

  void merge(Tessellation_node& node)
  {
    const double discrepancy = node.discrepancy();
    if (!(discrepancy <= tolerance_)) return;
    std::array<Index, 4> straight_edges;
    std::size_t number = 0;
    for (Index i = 0; i < node.leaf.degree; ++i)
      if (is_straight(node.leaf, i)) straight_edges[number++] = node.leaf.halfedges[i] / 2;
    for (std::size_t i = 0; i < number; ++i) all_.hide(straight_edges[i], true);
    const double error = error_of(node) + discrepancy;
    const bool is_flat = error <= tolerance_;
    if (is_flat) {
      node.is_leaf = true;
      node.leaf.error = tessellation_safety * error;
      for (Index i = 0; i < node.number_of_children; ++i) nodes_[node.child(i)].is_leaf = false;
      for (Index i = 0; i < node.leaf.degree; ++i) --users_[node.leaf.halfedges[i] / 2];
    }
    for (std::size_t i = 0; i < number; ++i)
      all_.hide(straight_edges[i], is_flat && users_[straight_edges[i]] == 0);
  }

  bool is_straight(const Tessellation_leaf& leaf, Index i) const
  {
    if (!all_.edge(leaf.halfedges[i] / 2).is_seen_split()) return false;
    const flatness::Vector a = all_.corner(leaf.slot_ids[i]).point,
                           b = all_.corner(leaf.slot_ids[(i + 1) % leaf.degree]).point;
    bool result = true;
    all_.for_each_part(leaf.slot_ids[i], leaf.halfedges[i], [&](Index slot, Index, double) {
      result = result &&
               flatness::distance_from_line(all_.corner(slot).point, a, b) <= straight * tolerance_;
    });
    return result;
  }

  // of the triangles of a leaf, by the normals and by the vertices that its children have besides
  double error_of(const Tessellation_node& node)
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double error = trial_.try_alone(node.leaf, tolerance_ - node.discrepancy());
    if (error == infinity) return infinity;
    for (const Tessellation_triangle& t : trial_.triangles()) {
      const auto a = all_.corner(t.slot_ids[0]), b = all_.corner(t.slot_ids[1]),
                 c = all_.corner(t.slot_ids[2]);
      if (flatness::is_turned_or_thin(a, b, c, 1e-4)) return infinity;
    }
    seen_.clear();
    for (const Tessellation_triangle& t : trial_.triangles())
      for (const Index s : t.slot_ids) note(s);
    for (Index c = 0; c < node.number_of_children; ++c) {
      const Tessellation_leaf& child = nodes_[node.child(c)].leaf;
      for (Index i = 0; i < child.degree; ++i)
        all_.for_each_part(child.slot_ids[i], child.halfedges[i], [&](Index slot, Index, double) {
          if (note(slot)) error = (std::max)(error, distance(all_.corner(slot).point));
        });
    }
    return error;
  }

  // whether its vertex is new
  bool note(Index slot)
  {
    const Index v = all_.slot(slot).vertex;
    if (std::find(seen_.begin(), seen_.end(), v) != seen_.end()) return false;
    seen_.push_back(v);
    return true;
  }

  // from the triangles on trial
  double distance(const flatness::Vector& p) const
  {
    using Kernel = Simple_cartesian<double>;
    const auto point = [](const flatness::Vector& q) { return Kernel::Point_3(q[0], q[1], q[2]); };
    double least = std::numeric_limits<double>::infinity();
    for (const Tessellation_triangle& t : trial_.triangles())
      least =
        (std::min)(least, CGAL::squared_distance(
                            point(p), Kernel::Triangle_3(point(all_.corner(t.slot_ids[0]).point),
                                                         point(all_.corner(t.slot_ids[1]).point),
                                                         point(all_.corner(t.slot_ids[2]).point))));
    return std::sqrt(least);
  }

  Split_edges<FT>& all_;
  std::deque<Tessellation_node>& nodes_;
  const double tolerance_;
  std::vector<unsigned char> users_; // faces that are split, of each edge
  std::vector<Index> seen_;
  Leaf_triangles<FT> trial_;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_TESSELLATION_MERGED_LEAVES_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_TESSELLATION_RUN_TESSELLATION_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_TESSELLATION_RUN_TESSELLATION_H

#include <CGAL/PN_limit_surface_3/internal/limit/limits_at_slots.h>
#include <CGAL/PN_limit_surface_3/internal/limit_surface/Flatness.h>
#include <CGAL/PN_limit_surface_3/internal/tessellation/Adaptive_refinement.h>
#include <CGAL/PN_limit_surface_3/internal/tessellation/Leaf_triangles.h>
#include <CGAL/PN_limit_surface_3/internal/tessellation/Split_edges.h>
#include <CGAL/PN_limit_surface_3/internal/tessellation/Tessellation_attributes.h>
#include <CGAL/PN_limit_surface_3/tessellation/Tessellation_result.h>
#include <CGAL/PN_subdivision_3/attributes/Attribute_traits.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <deque>
#include <limits>
#include <utility>
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
  // the share of the tolerance that counts as straight
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

  // the error of the triangles of a leaf, by the normals and by the vertices that its children have besides
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

  // the distance from the triangles on trial
  double distance(const flatness::Vector& p) const
  {
    double least = std::numeric_limits<double>::infinity();
    for (const Tessellation_triangle& t : trial_.triangles()) {
      const auto at = [&](std::size_t i) { return all_.corner(t.slot_ids[i]).point; };
      least = (std::min)(least, flatness::distance_from_triangle(p, at(0), at(1), at(2)));
    }
    return least;
  }

  Split_edges<FT>& all_;
  std::deque<Tessellation_node>& nodes_;
  const double tolerance_;
  std::vector<unsigned char> users_; // faces that are split, of each edge
  std::vector<Index> seen_;
  Leaf_triangles<FT> trial_;
};

// The triangles of all leaves as a level of their own. They are joined along the half-edges that they have from the
// edges of the levels, not by their vertices: two vertices may have several edges.
template <class FT>
class Tessellation_mesh
{
public:
  using Index = Level_connectivity::Index;
  using Vector = flatness::Vector;

  Tessellation_mesh(const Split_edges<FT>& all, const Leaf_triangles<FT>& triangles)
    : all_(all)
    , triangles_(triangles.triangles())
  {
    Level_size size;
    size.vertices = all.number_of_vertices();
    size.edges = triangles.number_of_edges();
    size.faces = triangles_.size();
    size.corners = 3 * size.faces;
    level_ = Level_connectivity(size);
    level_.set_uniform_degree(3);
    connect(triangles.number_of_edges());
    for (Index v = 0; v < level_.number_of_vertices(); ++v)
      if (level_.is_isolated(v)) ++size.isolated_vertices;
    level_.set_size(size);
  }

  const Level_connectivity& level() const { return level_; }
  // calls f(half-edge, normal) for all corners
  template <class Function>
  void for_each_corner(const Function& f) const
  {
    for (const Tessellation_triangle& t : triangles_)
      for (std::size_t i = 0; i < 3; ++i)
        f(t.halfedges[i == 0 ? 2 : i - 1], all_.slot(t.slot_ids[i]).normal);
  }
  // the normals of the vertices; where there are several wedges, their mean
  std::vector<Vector> normals() const
  {
    std::vector<Vector> sums(all_.number_of_vertices(), Vector{});
    std::vector<unsigned> wedges(sums.size(), 0);
    for (Index s = 0; s < all_.number_of_slots(); ++s) {
      const auto& slot = all_.slot(s);
      if (slot.vertex == null) continue;
      add_multiple<double, 3>(sums[slot.vertex], 1, slot.normal);
      ++wedges[slot.vertex];
    }
    for (std::size_t v = 0; v < sums.size(); ++v)
      if (wedges[v] > 1) sums[v] = unit_or_zero<double, 3>(sums[v], wedges[v]);
    return sums;
  }

private:
  static constexpr Index null = Level_connectivity::null;
  static Index opposite(Index h) { return Level_connectivity::opposite(h); }

  void connect(Index number_of_edges)
  {
    std::vector<Index> before(2 * std::size_t(number_of_edges), null);
    for (Index v = 0; v < level_.number_of_vertices(); ++v) level_.set_isolated(v);
    for (Index t = 0; t < triangles_.size(); ++t) {
      const auto& triangle = triangles_[t];
      for (std::size_t i = 0; i < 3; ++i) {
        const Index h = triangle.halfedges[i], next = triangle.halfedges[(i + 1) % 3];
        const Index target = all_.slot(triangle.slot_ids[(i + 1) % 3]).vertex;
        level_.set_next(h, next);
        before[next] = h;
        level_.set_face(h, t);
        level_.set_target(h, target);
        level_.set_halfedge_of_vertex(target, h);
      }
      level_.set_halfedge_of_face(t, triangle.halfedges[0]);
    }
    for (Index h = 0; h < before.size(); ++h)
      if (before[h] == null) connect_border(h, before);
  }

  // the border goes on where the fan of triangles at its target ends
  void connect_border(Index h, const std::vector<Index>& before)
  {
    Index last = before[opposite(h)];
    const Index target = level_.target(last);
    while (before[opposite(last)] != null) last = before[opposite(last)];
    level_.set_border(h);
    level_.set_target(h, target);
    level_.set_next(h, opposite(last));
    level_.set_halfedge_of_vertex(target, h);
  }

  const Split_edges<FT>& all_;
  const std::vector<Tessellation_triangle>& triangles_;
  Level_connectivity level_;
};

// The runs of a tessellation. Finer neighbors put vertices on the sides of a leaf, whose triangles may then miss the
// tolerance: it is split in another run.
template <class FT>
class Tessellation_runs
{
public:
  using Obstacle = Tessellation_result::Obstacle;

  explicit Tessellation_runs(unsigned most)
    : most_(most)
  {}

  // the nodes of the last run
  std::deque<Tessellation_node> take_nodes() { return std::move(nodes_); }

  // The triangles of the leaves, once needless splits are taken back.
  template <class Refinement>
  Leaf_triangles<FT> triangles(Refinement& refinement, std::size_t dimension_of_corners)
  {
    const bool is_proven = refinement.selection().demand().is_proven;
    const double tolerance = refinement.selection().tolerance() / tessellation_safety;
    if (!is_proven)
      Merged_leaves<FT>(refinement.all(), refinement.selection().nodes(), tolerance)();
    Leaf_triangles<FT> triangles(refinement.all(), tolerance, dimension_of_corners, is_proven);
    triangles.reserve(2 * std::size_t(refinement.all().number_of_vertices()));
    const auto& corners = refinement.selection().corners_of_nodes();
    are_missed_ = false;
    for (std::size_t i = 0; i < refinement.selection().nodes().size(); ++i) {
      Tessellation_node& node = refinement.selection().nodes()[i];
      if (!node.is_leaf) continue;
      const double error = triangles.add(node.leaf, corners.empty() ? nullptr : corners[i].data());
      if (error > with_rounding * refinement.selection().tolerance()) miss(node);
    }
    return triangles;
  }

  // Whether there has to be another run, with nodes of which some have to be split now.
  template <class Refinement>
  bool go_on(Refinement& refinement, const Leaf_triangles<FT>& triangles)
  {
    ++number_;
    if (!are_missed_ || number_ >= most_) return false;
    if (number_ > 1 && triangles.triangles().size() > triangles_out_of_reach) return false;
    nodes_ = std::move(refinement.selection().nodes());
    return true;
  }

  // What has been reached, in the unit of the coordinates.
  template <class Refinement>
  void report(Refinement& refinement, const Leaf_triangles<FT>& triangles,
              Tessellation_result& report) const
  {
    const Tessellation_demand& demand = refinement.selection().demand();
    report.bound = std::ldexp(triangles.bound(), demand.exponent);
    report.worst_face = triangles.worst_face();
    report.worst_place = triangles.worst_place();
    for (double& x : report.worst_place) x = std::ldexp(x, demand.exponent);
    report.reached = triangles.bound() <= with_rounding * demand.tolerance;
    report.depth = refinement.depth();
    if (report.reached) return;
    report.obstacle = refinement.selection().obstacle();
    if (report.obstacle == Obstacle::none)
      report.obstacle = are_missed_ ? Obstacle::triangles : Obstacle::rounds;
  }

private:
  // a product and a quotient
  static constexpr double with_rounding = 1 + 0x1p-50;

  void miss(Tessellation_node& node)
  {
    if (node.has_to_be_split || (node.number_of_children == 0 && !node.may_be_split)) return;
    node.has_to_be_split = true;
    are_missed_ = true;
  }

  const unsigned most_;
  unsigned number_ = 0;
  bool are_missed_ = false; // leaves that can be split
  std::deque<Tessellation_node> nodes_;
};

// Whether a call names attributes, without which what carries them is not compiled. The library is for all calls.
template <class NamedParameters>
constexpr bool may_carry_attributes()
{
#ifdef CGAL_PN_SUBDIVISION_3_LIMITS
  return true;
#else
  return is_given_v<attributes_t, NamedParameters>;
#endif
}

// One run on a control mesh that has been read. The last one calls build(all, mesh).
template <class FT, bool carries_attributes, class Scheme, class Value, class Level_creases>
bool run_tessellation(
  const Scheme& scheme, const Tessellation_demand& demand, const For_chunks& for_chunks,
  const Tessellation_table& table, Valued_level<Value>& control, Level_creases& creases,
  Face_bounds<Value, Level_creases>* bounds, Tessellation_runs<FT>& runs,
  Tessellation_result& report,
  Function_ref<void(const Split_edges<FT>&, const Tessellation_mesh<FT>&)> build)
{
  using Index = Level_connectivity::Index;
  const Index control_vertices = control.level.number_of_vertices();
  [[maybe_unused]] Carried<carries_attributes, Tessellation_data> attributes;
  std::size_t dimension_of_corners = 0;
  if constexpr (carries_attributes) {
    attributes = table.read(control.level);
    dimension_of_corners = table.dimension_of_corners();
  }
  Adaptive_refinement<Scheme, FT, Level_creases, carries_attributes> refinement(scheme, demand,
                                                                                for_chunks, bounds);
  refinement(std::move(control), std::move(creases), runs.take_nodes(), attributes);
  const Leaf_triangles<FT> triangles = runs.triangles(refinement, dimension_of_corners);
  if (runs.go_on(refinement, triangles)) return true;
  std::vector<bool> used(refinement.all().number_of_vertices(), false);
  std::fill_n(used.begin(), control_vertices, true);
  for (const Tessellation_triangle& t : triangles.triangles())
    for (const Index slot : t.slot_ids) used[refinement.all().slot(slot).vertex] = true;
  refinement.remove_unused(used);
  const Tessellation_mesh<FT> mesh(refinement.all(), triangles);
  [[maybe_unused]] Carried<carries_attributes, Attribute_table> carried;
  if constexpr (carries_attributes)
    if (table.any())
      carried = table.of_result(refinement, triangles, attributes, first_indices(control_vertices));
  build(refinement.all(), mesh);
  if constexpr (carries_attributes) table.set(std::move(carried));
  runs.report(refinement, triangles, report);
  report.number_of_vertices = mesh.level().number_of_vertices();
  report.number_of_triangles = mesh.level().number_of_faces();
  return false;
}

// for the library CGAL::PN_subdivision_3_limits, see limits_at_slots.h
#define CGAL_PN_SUBDIVISION_3_TESSELLATION_OF(EXTERN, SCHEME, CREASES)                             \
  EXTERN template bool run_tessellation<double, true>(                                             \
    const compiled_once::SCHEME&, const Tessellation_demand&, const For_chunks&,                   \
    const Tessellation_table&, Valued_level<compiled_once::Value<compiled_once::SCHEME>>&,         \
    CREASES&, Face_bounds<compiled_once::Value<compiled_once::SCHEME>, CREASES>*,                  \
    Tessellation_runs<double>&, Tessellation_result&,                                              \
    Function_ref<void(const Split_edges<double>&, const Tessellation_mesh<double>&)>);
#ifdef CGAL_PN_SUBDIVISION_3_LIMITS
CGAL_PN_SUBDIVISION_3_OF_QUADS(CGAL_PN_SUBDIVISION_3_TESSELLATION_OF, extern)
CGAL_PN_SUBDIVISION_3_OF_TRIANGLES(CGAL_PN_SUBDIVISION_3_TESSELLATION_OF, extern)
#endif

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_TESSELLATION_RUN_TESSELLATION_H

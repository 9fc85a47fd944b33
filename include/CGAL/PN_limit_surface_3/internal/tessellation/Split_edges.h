// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_TESSELLATION_SPLIT_EDGES_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_TESSELLATION_SPLIT_EDGES_H

#include <CGAL/PN_limit_surface_3/internal/limit_surface/Flatness.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// Room for more elements, which is not all used up by the next few.
template <class Elements>
void make_room(std::size_t more, Elements& elements)
{
  const std::size_t needed = elements.size() + more;
  if (needed > elements.capacity())
    elements.reserve((std::max)(needed, elements.capacity() + elements.capacity() / 2));
}

// The vertices and edges of all levels of an adaptive refinement. A vertex has a slot for each of its wedges. A
// half-edge of edge e is 2 * e or 2 * e + 1, and its halves go the same way.
template <class FT>
class Split_edges
{
public:
  using Index = Level_connectivity::Index;
  using Vector = flatness::Vector;
  static constexpr Index null = Level_connectivity::null;

  struct Slot
  {
    Vector normal; // unit or zero
    Index vertex;
    bool has_surface_normal;
    bool is_trusted; // whether flatness goes by the normal
  };
  struct Edge
  {
    std::array<Index, 2> middle{null, null}; // slots, in the faces of the half-edges
    Index halves = null;                     // the first of the two, at the source of half-edge 2e
    bool is_hidden = false; // the split is: all vertices are on a line, and no face needs them
    bool is_pinned = false; // the split stays seen
    bool is_split() const { return halves != null; }
    bool is_seen_split() const { return is_split() && !is_hidden; }
  };

  Index number_of_vertices() const { return static_cast<Index>(points_.size()); }
  Index number_of_slots() const { return static_cast<Index>(slots_.size()); }
  Index number_of_edges() const { return static_cast<Index>(edges_.size()); }

  // reserves memory for so many more elements
  void reserve(std::size_t vertices, std::size_t edges)
  {
    make_room(vertices, points_);
    if constexpr (keeps_places) make_room(vertices, places_);
    make_room(vertices, slots_);
    make_room(edges, edges_);
  }

  Index add_vertex()
  {
    points_.emplace_back();
    if constexpr (keeps_places) places_.emplace_back();
    return number_of_vertices() - 1;
  }
  Index add_slot(Index vertex)
  {
    slots_.push_back({{}, vertex, false, false});
    return number_of_slots() - 1;
  }
  Index add_edge()
  {
    edges_.emplace_back();
    return number_of_edges() - 1;
  }

  // Flatness is told from points that are divided by a power of two, so that squares neither overflow nor underflow.
  void set_exponent(int exponent) { scale_ = std::ldexp(1., -exponent); }
  Vector place(const Coordinates<FT, 3>& point) const
  {
    Vector place = to_double_3(point);
    for (double& x : place) x *= scale_;
    return place;
  }
  void set_point(Index vertex, const Coordinates<FT, 3>& point)
  {
    points_[vertex] = point;
    if constexpr (keeps_places) places_[vertex] = place(point);
  }
  Slot& slot(Index s) { return slots_[s]; }
  const Slot& slot(Index s) const { return slots_[s]; }
  const Edge& edge(Index e) const { return edges_[e]; }
  const Coordinates<FT, 3>& point(Index vertex) const { return points_[vertex]; }
  flatness::Corner corner(Index s) const
  {
    const Slot& slot = slots_[s];
    return {place_of(slot.vertex), slot.is_trusted ? slot.normal : Vector{}};
  }
  Vector place_of(Index vertex) const
  {
    if constexpr (keeps_places)
      return places_[vertex];
    else
      return place(points_[vertex]);
  }

  // Removes vertices that are not used, and renumbers the others in their order.
  void keep_vertices(const std::vector<bool>& used)
  {
    std::vector<Index> number(used.size(), null);
    Index kept = 0;
    for (Index v = 0; v < used.size(); ++v)
      if (used[v]) {
        points_[kept] = points_[v];
        if constexpr (keeps_places) places_[kept] = places_[v];
        number[v] = kept++;
      }
    points_.resize(kept);
    if constexpr (keeps_places) places_.resize(kept);
    for (Slot& s : slots_)
      if (s.vertex != null) s.vertex = number[s.vertex];
  }

  // \pre it is not split
  void split(Index e, std::array<Index, 2> middle)
  {
    const Index halves = add_edge();
    add_edge();
    edges_[e].middle = middle;
    edges_[e].halves = halves;
  }

  void pin(Index e) { edges_[e].is_pinned = true; }
  void hide(Index e, bool is_hidden) { edges_[e].is_hidden = is_hidden; }

  // the halves of a half-edge
  Index first_half(Index h) const { return 2 * (edges_[h / 2].halves + h % 2) + h % 2; }
  Index second_half(Index h) const { return 2 * (edges_[h / 2].halves + 1 - h % 2) + h % 2; }

  // Calls f(slot, half-edge, t) for the parts of a half-edge that are not split, each with the slot from which it comes,
  // and where this is between the ends, 0 and 1.
  template <class Function>
  void for_each_part(Index slot, Index h, const Function& f, double from = 0, double to = 1) const
  {
    const Edge& e = edges_[h / 2];
    if (!e.is_seen_split()) return f(slot, h, from);
    const double middle = (from + to) / 2;
    for_each_part(slot, first_half(h), f, from, middle);
    for_each_part(e.middle[h % 2], second_half(h), f, middle, to);
  }

private:
  // where they are not as quickly found again
  static constexpr bool keeps_places = !std::is_same_v<FT, double>;

  std::vector<Coordinates<FT, 3>> points_;
  std::vector<Vector> places_;
  double scale_ = 1;
  std::vector<Slot> slots_;
  std::vector<Edge> edges_;
};

// A face of some level that is not refined further.
struct Tessellation_leaf
{
  using Index = Level_connectivity::Index;

  double error = 0;                 // estimated
  Index origin = 0;                 // the face of the control mesh
  std::array<Index, 4> slot_ids{};  // of the corners
  std::array<Index, 4> halfedges{}; // to the next corner
  unsigned char degree = 0;         // 3 or 4
  bool has_flatter_second = false;  // of a quadrilateral: the diagonal from its second corner
};

// A face of some level, with the faces that it was split into.
struct Tessellation_node
{
  using Index = Level_connectivity::Index;

  // if it is split, its error is how far the middles were from where the normals had them
  Tessellation_leaf leaf; // without corners, if it is no triangle or quadrilateral
  Index first_child = null, other_children = null; // the others follow each other
  Index number_of_children = 0;
  bool is_leaf = false;
  bool has_to_be_split = false; // whatever its error
  bool may_be_split = false;    // as far as rounds go

  double discrepancy() const { return leaf.error; }
  // null if it has fewer
  Index child(Index i) const
  {
    if (i >= number_of_children) return null;
    return i == 0 ? first_child : other_children + i - 1;
  }
  void add_child(Index node)
  {
    if (number_of_children < 2) (number_of_children == 0 ? first_child : other_children) = node;
    ++number_of_children;
  }

  static constexpr Index null = Level_connectivity::null;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_TESSELLATION_SPLIT_EDGES_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_CREASES_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_CREASES_H

#include <CGAL/Iterator_range.h>
#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/numbers/number_functions.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <type_traits>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

constexpr double infinite_sharpness = std::numeric_limits<double>::infinity();

// the sharpness that is left after a round
inline double refined_sharpness(double s)
{
  return s > 1 ? s - 1 : 0;
}

// An edge of positive sharpness.
//
// A slot is a pair of a vertex and one of its wedges, the runs of faces between crease edges; it has
// the number of the vertex in the first wedge, and one behind all vertices in others. Everything at
// an end of the edge is indexed by the side 0 or 1: the half-edge 2 * edge + side leads to that end.
template <class FT>
struct Crease_edge
{
  using Index = Level_connectivity::Index;

  Index edge;
  Index control_edge; // the control edge that this edge is a part of
  double sharpness;
  Index border_side = no_side;   // of the half-edge that has no face
  std::array<Index, 2> after{};  // the slot of the end in the face of the half-edge
  std::array<Index, 2> before{}; // the slot of the end in the face of the opposite half-edge
  std::array<Coordinates<FT, 3>, 2> tangent_from{}; // at the source of the half-edge, along it

  static constexpr Index no_side = 2;

  bool is_border() const { return border_side != no_side; }
  bool has_after(Index side) const { return border_side != side; }
  bool has_before(Index side) const { return border_side != 1 - side; }
  Index halfedge(Index side) const { return 2 * edge + side; }
};

// Makes the tangents a and b of both directions along a crease opposite, unless they are: b becomes the direction of b - a.
template <class FT>
void make_opposite_vectors(Coordinates<FT, 3>& a, Coordinates<FT, 3>& b)
{
  if (are_certainly_equal(a, opposite_vector(b))) return;
  b = unit_or_zero(difference(b, a), FT(2));
  a = opposite_vector(b);
}

// An end of a crease edge at a vertex: the half-edge of the edge that leads to the vertex.
struct Crease_halfedge
{
  using Index = Level_connectivity::Index;

  Index crease; // the position of the edge in Creases::edges
  Index side;
};

enum class Vertex_rule { smooth, dart, crease, corner }; // dart: a single crease edge ends there

// The star of a vertex with crease edges or a sharpness of its own: the vertex, the ends of these edges there, its wedges.
struct Crease_star
{
  using Index = Level_connectivity::Index;

  Index vertex;
  double sharpness;
  bool is_border;
  Index first_end = 0, number_of_ends = 0; // in Creases::ends, clockwise, from the border on
  Index first_extra_slot = 0, number_of_wedges = 1;

  Index slot(Index wedge) const { return wedge == 0 ? vertex : first_extra_slot + wedge - 1; }
  Index wedge(Index slot) const { return slot == vertex ? 0 : slot - first_extra_slot + 1; }
};

// a border vertex where an inner crease ends is a corner
inline Vertex_rule vertex_rule(double sharpness, std::size_t number_of_ends, bool ends_at_border)
{
  if (sharpness > 0 || number_of_ends > 2 || ends_at_border) return Vertex_rule::corner;
  if (number_of_ends == 2) return Vertex_rule::crease;
  return number_of_ends == 1 ? Vertex_rule::dart : Vertex_rule::smooth;
}

// The control level without edges and vertices whose sharpness is less than 1.
template <class FT>
struct Control_without_fractions;

// The creases of a level: sharp edges and vertices, slots, and tangents. All sizes grow with the
// tagged part of the level only.
template <class FT>
struct Creases
{
  using Index = Level_connectivity::Index;

  std::vector<Crease_edge<FT>> edges; // in the order of the edges
  std::vector<Crease_halfedge> ends;
  std::vector<Crease_star> stars;
  Index number_of_slots = 0;
  bool has_fixed_border = false; // all vertices of border creases are corners
  // null but for a control level that has fractions and no normals of corners
  std::shared_ptr<const Control_without_fractions<FT>> without_fractions;

  explicit Creases(Index number_of_vertices = 0)
    : number_of_slots(number_of_vertices)
  {}

  bool empty() const { return edges.empty() && stars.empty(); }

  const Crease_halfedge& end(const Crease_star& star, Index i) const
  {
    return ends[star.first_end + i];
  }
  // all ends of a star, clockwise
  auto ends_of(const Crease_star& star) const
  {
    const auto first = ends.begin() + star.first_end;
    return CGAL::make_range(first, first + star.number_of_ends);
  }
  const Crease_edge<FT>& edge(const Crease_halfedge& e) const { return edges[e.crease]; }
  Index halfedge(const Crease_halfedge& e) const { return edge(e).halfedge(e.side); }
  bool is_inner(const Crease_halfedge& e) const { return !edge(e).is_border(); }
  // of an edge and a vertex of the level; null if they are not sharp
  const Crease_edge<FT>* edge_at(Index e) const { return find(edges, e, &Crease_edge<FT>::edge); }
  const Crease_star* star_at(Index v) const { return find(stars, v, &Crease_star::vertex); }
  // the tangent at the star, along the edge to its other end; tangent_towards() is at the other end, along the edge to the star
  Coordinates<FT, 3>& tangent_from(const Crease_halfedge& e)
  {
    return edges[e.crease].tangent_from[1 - e.side];
  }
  const Coordinates<FT, 3>& tangent_from(const Crease_halfedge& e) const
  {
    return edge(e).tangent_from[1 - e.side];
  }
  const Coordinates<FT, 3>& tangent_towards(const Crease_halfedge& e) const
  {
    return edge(e).tangent_from[e.side];
  }
  // the slots of the other end of the edge, in the faces after and before this end
  Index far_after(const Crease_halfedge& e) const { return edge(e).before[1 - e.side]; }
  Index far_before(const Crease_halfedge& e) const { return edge(e).after[1 - e.side]; }

  Vertex_rule rule(const Crease_star& star) const
  {
    bool has_inner = false;
    for (const Crease_halfedge& e : ends_of(star)) has_inner = has_inner || is_inner(e);
    return vertex_rule(star.sharpness, star.number_of_ends, star.is_border && has_inner);
  }

  // Adds a star, to which the ends from first_end on belong, and numbers its wedges, clockwise as the ends:
  //
  //            end 0                      border | wedge 0
  //     wedge 2  |  wedge 0                      |
  //    ----------*----------                     *---------- an end
  //    end 2  wedge 1   end 1                    |
  //                                       border | wedge 1
  //
  // Inside wedge i begins at end i. At the border wedge 0 begins at the border, and an end inside the surface begins the next wedge.
  void add_star(Crease_star star, Index first_end)
  {
    star.first_end = first_end;
    star.number_of_ends = static_cast<Index>(ends.size()) - first_end;
    star.first_extra_slot = number_of_slots;
    const Index k = star.number_of_ends;
    star.number_of_wedges = star.is_border || k == 0 ? 1 : k;
    for (Index i = 0; i < k; ++i) {
      const Crease_halfedge& e = ends[first_end + i];
      Crease_edge<FT>& crease = edges[e.crease];
      Index before = i == 0 ? k - 1 : i - 1, after = i;
      if (star.is_border) {
        before = star.number_of_wedges - 1;
        after = crease.is_border() ? before : star.number_of_wedges++;
      }
      if (crease.has_before(e.side)) crease.before[e.side] = star.slot(before);
      if (crease.has_after(e.side)) crease.after[e.side] = star.slot(after);
    }
    number_of_slots += star.number_of_wedges - 1;
    stars.push_back(star);
  }

private:
  template <class T>
  static const T* find(const std::vector<T>& sorted, Index i, Index T::*number)
  {
    const auto it = std::lower_bound(sorted.begin(), sorted.end(), i,
                                     [=](const T& x, Index other) { return x.*number < other; });
    return it != sorted.end() && (*it).*number == i ? &*it : nullptr;
  }
};

template <class FT>
struct Control_without_fractions
{
  Creases<FT> creases;
  std::vector<Point_normal<FT, 3>> values; // of the slots of these creases
};

// The creases of a level where nothing can be sharp, which is known when the call is compiled.
struct No_creases
{
  using Index = Level_connectivity::Index;

  explicit No_creases(Index number_of_vertices = 0)
    : number_of_slots(number_of_vertices)
  {}

  static constexpr bool empty() { return true; }

  Index number_of_slots;
};

template <class Level_creases>
constexpr bool are_creases_v = !std::is_same_v<Level_creases, No_creases>;

// Whether is(s) is true of the sharpness s of an edge or of a vertex.
template <class FT, class Predicate>
bool is_any_sharpness(const Creases<FT>& creases, const Predicate& is)
{
  const auto is_one = [&](const auto& element) { return is(element.sharpness); };
  return std::any_of(creases.edges.begin(), creases.edges.end(), is_one) ||
         std::any_of(creases.stars.begin(), creases.stars.end(), is_one);
}
template <class Predicate>
bool is_any_sharpness(No_creases, const Predicate&)
{
  return false;
}

// whether the sharpness s lasts for less than a round
inline bool is_fraction(double s)
{
  return s > 0 && s < 1;
}
template <class Level_creases>
bool has_fractions(const Level_creases& creases)
{
  return is_any_sharpness(creases, is_fraction);
}
// whether an edge or vertex is sharp, but not for ever
template <class Level_creases>
bool is_anything_ending(const Level_creases& creases)
{
  return is_any_sharpness(creases, [](double s) { return s > 0 && s < infinite_sharpness; });
}

// The vertex of each slot that is numbered behind the vertices.
template <class FT>
std::vector<Level_connectivity::Index> vertices_of_extra_slots(const Creases<FT>& creases,
                                                               Level_connectivity::Index vertices)
{
  using Index = Level_connectivity::Index;
  std::vector<Index> result(creases.number_of_slots - vertices);
  for (const Crease_star& star : creases.stars)
    for (Index w = 1; w < star.number_of_wedges; ++w) result[star.slot(w) - vertices] = star.vertex;
  return result;
}

inline std::vector<Level_connectivity::Index> vertices_of_extra_slots(No_creases,
                                                                      Level_connectivity::Index)
{
  return {};
}

// Calls f(half-edge, slot) for the corners, at one star or of a level, whose slot is not the first slot of their vertex.
template <class FT, class Function>
void for_each_extra_corner(const Level_connectivity& level, const Creases<FT>& creases,
                           const Crease_star& star, const Function& f)
{
  using Index = Level_connectivity::Index;
  if (star.number_of_wedges == 1) return;
  for (Index i = 0; i < star.number_of_ends; ++i) {
    const Crease_halfedge& e = creases.end(star, i);
    const Crease_edge<FT>& crease = creases.edge(e);
    if (!crease.has_after(e.side) || crease.after[e.side] == star.vertex) continue;
    // clockwise up to the next crease or the border
    const Index last = creases.halfedge(creases.end(star, i + 1 < star.number_of_ends ? i + 1 : 0));
    Index h = creases.halfedge(e);
    do {
      f(h, crease.after[e.side]);
      h = level.next_around_target(h);
    } while (h != last && !level.is_border(h));
  }
}
template <class FT, class Function>
void for_each_extra_corner(const Level_connectivity& level, const Creases<FT>& creases,
                           const Function& f)
{
  for (const Crease_star& star : creases.stars) for_each_extra_corner(level, creases, star, f);
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_CREASES_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_TESSELLATION_ADAPTIVE_LEVEL_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_TESSELLATION_ADAPTIVE_LEVEL_H

#include <CGAL/PN_limit_surface_3/internal/limit/Limit_evaluation.h>
#include <CGAL/PN_limit_surface_3/internal/limit_surface/Flatness.h>
#include <CGAL/PN_limit_surface_3/internal/limit_surface/Limit_cells.h>
#include <CGAL/PN_limit_surface_3/internal/tessellation/Split_edges.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/normals/Fan.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Level_part.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Piece_candidates.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// What is known of a face of a level: where it comes from, and what limit points have told of it.
struct Adaptive_face
{
  using Index = Level_connectivity::Index;

  // of which face the middles have been seen: none of control faces and children of polygons, before their first round
  enum class Seen : unsigned char { none, of_parent, of_itself };

  Index origin = 0;       // the face of the control mesh
  bool is_wanted = false; // a part of what is tessellated here, not of a ring around it
  bool is_split = false;  // not flat enough, or to be seen
  Seen seen = Seen::none;
  Index node = Level_connectivity::null, before = Level_connectivity::null;
  double measured = 0;    // how far the middles were from the triangles
  double discrepancy = 0; // how far the middles were from where they had been expected
};

// The part of a level that is refined further: the faces that are wanted, with rings around them; their slots and edges
// have the numbers of Split_edges, or null.
template <class Value, class Level_creases>
struct Adaptive_level
{
  using Index = Level_connectivity::Index;

  Valued_level<Value> level; // values are those of the slots
  Level_creases creases;
  std::vector<Index> slot_ids, edges;
  std::vector<Adaptive_face> faces;
  std::vector<std::vector<Value>>
    planes{}; // attributes of vertices, three a plane, as points of the slots without normals
  std::vector<std::vector<double>>
    corners{}; // attributes of the corners of each face that is wanted
};

// What bounds the distance of the faces of a level, where a call asks for proofs.
template <class Value, class Level_creases>
struct Face_bounds
{
  virtual ~Face_bounds() = default;
  virtual void begin(const Adaptive_level<Value, Level_creases>& level) = 0;
  // the bound of the triangles between these corners; infinite beyond the tolerance
  virtual double operator()(Level_connectivity::Index face,
                            const std::array<flatness::Vector, 4>& corners,
                            double tolerance) const = 0;
};

// Leaves the faces that are marked, and some rings around them.
template <class Level>
void cut_adaptive_level(Level& level, Face_marks kept, unsigned rings)
{
  const Level_connectivity& whole = level.level.level;
  for (unsigned r = 0; r < rings; ++r) add_ring(whole, kept);
  const auto number = static_cast<std::size_t>(std::count(kept.begin(), kept.end(), char(1)));
  if (10 * number > 9 * kept.size()) return; // it would save little
  const Ring_candidates candidates(whole, kept);
  Piece_extraction<Ring_candidates> extraction(whole, candidates, false);
  Level_part part(extraction, true);
  auto [creases, origins] = part.creases_and_slots(whole, level.creases);
  Level left{{std::move(part.level), values_of_part(level.level.values, origins)},
             std::move(creases),
             values_of_part(level.slot_ids, origins),
             values_of_part(level.edges, part.edges),
             values_of_part(level.faces, part.faces)};
  for (const auto& plane : level.planes) left.planes.push_back(values_of_part(plane, origins));
  if (!level.corners.empty())
    for (const Level_part::Index f : part.faces)
      left.corners.push_back(std::move(level.corners[f]));
  level = std::move(left);
}

// How far the limit surface is from the triangles of a face, estimated from limit points and surface normals at its
// corners, and from what was seen on its parent. Along creases and the border, whose curves count for themselves, from
// the turns of the points of the level along them.
template <class FT, class Level>
class Face_flatness
{
public:
  using Index = Level_connectivity::Index;
  using Vector = flatness::Vector;

  // the estimate of a face: two triangles, or one
  struct Estimate
  {
    double error = 0;                // by the normals
    bool has_flatter_second = false; // of the diagonals of a quadrilateral
    double along_curves = 0;         // of its edges on creases and the border
    bool knows_normals = true, trusts_normals = true, is_at_curve = false;
  };
  // limit points on the middles of the edges, and of the face
  struct Middles
  {
    std::array<Vector, 4> of_edges;
    Vector of_face;
    bool has_face = false;
  };
  struct Measure
  {
    double distance = 0, discrepancy = 0;
  };

  Face_flatness(const Level& level, const Split_edges<FT>& all)
    : level_(level)
    , connectivity_(level.level.level)
    , all_(all)
    , slot_of_(connectivity_, level.creases)
    , is_curve_(connectivity_.number_of_edges(), 0)
  {
    if (connectivity_.has_border())
      for (Index e = 0; e < is_curve_.size(); ++e) is_curve_[e] = connectivity_.is_border_edge(e);
    if constexpr (is_creased)
      for (const auto& e : level.creases.edges)
        if (std::isinf(e.sharpness)) is_curve_[e.edge] = 1;
  }

  void read(Index f, Tessellation_leaf& leaf) const
  {
    leaf.origin = level_.faces[f].origin;
    for_each_halfedge_of_face(connectivity_, f, [&](Index h) {
      const Index next = connectivity_.next(h);
      leaf.slot_ids[leaf.degree] = level_.slot_ids[slot_of_(h)];
      leaf.halfedges[leaf.degree++] =
        2 * level_.edges[Level_connectivity::edge(next)] + (next & 1u);
    });
  }

  std::array<Vector, 4> places(Index f) const
  {
    const Corners c = corners(f);
    return {c[0].point, c[1].point, c[2].point, c[3].point};
  }

  // \pre the face has three or four corners
  Estimate estimate(Index f) const
  {
    const Corners c = corners(f);
    Estimate result;
    result.knows_normals = c.know_normals;
    result.trusts_normals = c.are_trusted;
    result.is_at_curve = c.are_at_curve;
    if (c.number == 3)
      result.error = flatness::over_triangle(c[0], c[1], c[2]);
    else {
      const auto over = flatness::over_quadrilateral(c[0], c[1], c[2], c[3]);
      result.error = (std::min)(over[0], over[1]);
      result.has_flatter_second = !(over[0] + weight_of_length * flatness::distance(c[0], c[2]) <=
                                    over[1] + weight_of_length * flatness::distance(c[1], c[3]));
    }
    for (std::size_t i = 0; i < c.number; ++i)
      if (is_curve_[Level_connectivity::edge(c.halfedges[i])] != 0)
        result.along_curves = (std::max)(result.along_curves, along_curve(c, i));
    return result;
  }

  Measure measure(Index f, const Middles& middles) const
  {
    const Corners c = corners(f);
    Measure result;
    for (std::size_t i = 0; i < c.number; ++i) {
      const flatness::Corner &a = c[i], &b = c[(i + 1) % c.number];
      const bool is_curve = is_curve_[Level_connectivity::edge(c.halfedges[i])] != 0;
      note(flatness::Section(a, b), a, b, middles.of_edges[i], is_curve, result);
    }
    if (!middles.has_face || c.number != 4) return result;
    Measure one, other;
    note(flatness::Section(c[0], c[2]), c[0], c[2], middles.of_face, false, one);
    note(flatness::Section(c[1], c[3]), c[1], c[3], middles.of_face, false, other);
    result.distance = (std::max)(result.distance, (std::min)(one.distance, other.distance));
    result.discrepancy =
      (std::max)(result.discrepancy, (std::min)(one.discrepancy, other.discrepancy));
    return result;
  }

  // calls f(i, half-edge) for the edges of a face in the order of the middles
  template <class Function>
  void for_each_edge(Index f, const Function& function) const
  {
    std::size_t i = 0;
    for_each_halfedge_of_face(connectivity_, f,
                              [&](Index h) { function(i++, connectivity_.next(h)); });
  }

private:
  using Creases_of_level = std::decay_t<decltype(Level::creases)>;
  static constexpr bool is_creased = are_creases_v<Creases_of_level>;

  struct Corners
  {
    std::array<flatness::Corner, 4> corners;
    std::array<Index, 4> halfedges; // from each corner to the next
    std::size_t number = 0;
    bool know_normals = true, are_trusted = true, are_at_curve = false;
    const flatness::Corner& operator[](std::size_t i) const { return corners[i]; }
  };

  Corners corners(Index f) const
  {
    Corners c;
    for_each_halfedge_of_face(connectivity_, f, [&](Index h) {
      const Index slot = level_.slot_ids[slot_of_(h)];
      c.corners[c.number] = all_.corner(slot);
      c.know_normals = c.know_normals && all_.slot(slot).has_surface_normal;
      c.are_trusted = c.are_trusted && !(c.corners[c.number].normal == Vector{});
      c.are_at_curve = c.are_at_curve || connectivity_.is_border_vertex(connectivity_.target(h));
      c.halfedges[c.number++] = connectivity_.next(h);
    });
    return c;
  }

  static void note(const flatness::Section& section, const flatness::Corner& a,
                   const flatness::Corner& b, const Vector& middle, bool is_curve, Measure& result)
  {
    const bool has_side = dot(section.normal(), section.normal()) > 0;
    const double distance = is_curve || !has_side
                              ? flatness::distance_from_line(middle, a.point, b.point)
                              : std::abs(section.height_of(middle));
    result.distance = (std::max)(result.distance, distance);
    result.discrepancy =
      (std::max)(result.discrepancy, has_side ? std::abs(section.excess_of(middle)) : distance);
  }

  // the sagitta of an edge on a curve, if the curve is bent as at the ends
  double along_curve(const Corners& c, std::size_t i) const
  {
    const Index h = c.halfedges[i];
    const double chord = quick_length(difference(c[(i + 1) % c.number].point, c[i].point));
    const double bend =
      (std::max)(bend_at(connectivity_.source(h)), bend_at(connectivity_.target(h)));
    return bend * chord * chord / 8;
  }

  Vector place(Index v) const { return all_.place(point_of(level_.level.values[v])); }

  // the curvature of the curve through a vertex: the turn there by the mean length; 0 where it ends
  double bend_at(Index v) const
  {
    Index before = v, after = v;
    bool is_star = false;
    if constexpr (is_creased) {
      const auto& creases = level_.creases;
      const Crease_star* const star = creases.star_at(v);
      is_star = star != nullptr;
      if (is_star && creases.rule(*star) == Vertex_rule::crease) {
        before = connectivity_.source(creases.halfedge(creases.end(*star, 0)));
        after = connectivity_.source(creases.halfedge(creases.end(*star, 1)));
      }
    }
    if (!is_star && connectivity_.is_border_vertex(v)) {
      const Index h = connectivity_.halfedge_of_vertex(v);
      before = connectivity_.source(h);
      after = connectivity_.target(connectivity_.next(h));
    }
    if (before == v || after == v) return 0;
    const Vector in = difference(place(v), place(before));
    const Vector out = difference(place(after), place(v));
    const double lengths = quick_length(in) + quick_length(out);
    const Vector turn = difference(flatness::unit(out), flatness::unit(in));
    return lengths > 0 ? 2 * quick_length(turn) / lengths : 0;
  }

  const Level& level_;
  const Level_connectivity& connectivity_;
  const Split_edges<FT>& all_;
  Slots_of_corners<Creases_of_level> slot_of_;
  std::vector<char> is_curve_;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_TESSELLATION_ADAPTIVE_LEVEL_H

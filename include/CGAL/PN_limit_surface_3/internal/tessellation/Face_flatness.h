// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_TESSELLATION_FACE_FLATNESS_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_TESSELLATION_FACE_FLATNESS_H

#include <CGAL/PN_limit_surface_3/internal/limit_surface/Adaptive_level.h>
#include <CGAL/PN_limit_surface_3/internal/limit_surface/Flatness.h>
#include <CGAL/PN_limit_surface_3/internal/tessellation/Split_edges.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/meshes/read_mesh.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// How far the limit surface is from the triangles of a face, estimated from limit points and surface normals at its
// corners, and from what was seen on its parent. Along creases and the border, whose curves count for themselves, from
// the turns of the points of the level along them.
template <class FT, class Level>
class Face_flatness
{
public:
  using Index = Level_connectivity::Index;
  using Vector = flatness::Vector;

  // of a face: two triangles, or one
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
    const Index first = connectivity_.halfedge_of_face(f);
    Index h = first;
    do {
      const Index next = connectivity_.next(h);
      leaf.slot_ids[leaf.degree] = level_.slot_ids[slot_of_(h)];
      leaf.halfedges[leaf.degree++] =
        2 * level_.edges[Level_connectivity::edge(next)] + (next & 1u);
      h = next;
    } while (h != first);
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
    const Index first = connectivity_.next(connectivity_.halfedge_of_face(f));
    Index h = first;
    std::size_t i = 0;
    do {
      function(i++, h);
      h = connectivity_.next(h);
    } while (h != first);
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
    const Index first = connectivity_.halfedge_of_face(f);
    Index h = first;
    do {
      const Index slot = level_.slot_ids[slot_of_(h)];
      c.corners[c.number] = all_.corner(slot);
      c.know_normals = c.know_normals && all_.slot(slot).has_surface_normal;
      c.are_trusted = c.are_trusted && !(c.corners[c.number].normal == Vector{});
      c.are_at_curve = c.are_at_curve || connectivity_.is_border_vertex(connectivity_.target(h));
      h = connectivity_.next(h);
      c.halfedges[c.number++] = h;
    } while (h != first);
    return c;
  }

  static void note(const flatness::Section& section, const flatness::Corner& a,
                   const flatness::Corner& b, const Vector& middle, bool is_curve, Measure& result)
  {
    const bool has_side = flatness::product(section.normal(), section.normal()) > 0;
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
    const double chord = flatness::length(flatness::minus(c[(i + 1) % c.number].point, c[i].point));
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
      const auto star =
        std::lower_bound(creases.stars.begin(), creases.stars.end(), v,
                         [](const Crease_star& s, Index vertex) { return s.vertex < vertex; });
      is_star = star != creases.stars.end() && star->vertex == v;
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
    const Vector in = flatness::minus(place(v), place(before));
    const Vector out = flatness::minus(place(after), place(v));
    const double lengths = flatness::length(in) + flatness::length(out);
    const Vector turn = flatness::minus(flatness::unit(out), flatness::unit(in));
    return lengths > 0 ? 2 * flatness::length(turn) / lengths : 0;
  }

  const Level& level_;
  const Level_connectivity& connectivity_;
  const Split_edges<FT>& all_;
  Slots_of_corners<Creases_of_level> slot_of_;
  std::vector<char> is_curve_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_TESSELLATION_FACE_FLATNESS_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_SURFACE_CELL_ENCLOSURE_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_SURFACE_CELL_ENCLOSURE_H

#include <CGAL/Bbox_3.h>
#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/limit_surface/Limit_cells.h>
#include <CGAL/PN_subdivision_3/internal/limit_surface/Proven_bound.h>
#include <CGAL/PN_subdivision_3/internal/meshes/read_mesh.h>
#include <CGAL/PN_subdivision_3/internal/schemes/scheme_facts.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// A box of the limit of a face, and how far the limit is at most from that of the linear scheme on the nets that were looked at.
struct Surface_box
{
  Bbox_3 box;
  double distance = 0;
};

// Boxes of the net that the linear limit of a cell depends on, grown by how far the point-normal limit is from that. Cells are
// refined by some rounds, and by more where no bound is known.
template <class Cells>
class Cell_enclosure
{
public:
  using Index = Level_connectivity::Index;
  using Cell = typename Cells::Cell;

  Cell_enclosure(const Cells& cells, unsigned degree, bool is_pn, bool is_proven, unsigned rounds,
                 unsigned more_rounds)
    : cells_(cells)
    , degree_(degree)
    , is_pn_(is_pn)
    , is_proven_(is_proven)
    , rounds_(rounds)
    , more_rounds_(more_rounds)
  {}

  void add(Cell&& cell)
  {
    const Level_connectivity& level = cell.level.level;
    const bool is_known = level.has_degree(cell.base, degree_) && has_uniform_faces(cell);
    if (is_known && cell.rounds >= rounds_ && add_box(cell)) return;
    if (cell.rounds >= rounds_ + more_rounds_)
      throw std::domain_error("PN_subdivision_3: the normals of neighbors differ so much that no "
                              "bound is proven, even after " +
                              std::to_string(cell.rounds) + " rounds: use bbox()");
    const auto n = static_cast<Index>(cell.halfedges().size());
    const typename Cells::Round round(cells_, std::move(cell));
    for (Index i = 0; i < (degree_ == 3 ? 4 : n); ++i) add(round.child(i));
  }

  const Surface_box& result() const { return result_; }

private:
  // calls f(half-edge) with all of the faces round the corners
  template <class Function>
  static void for_each_halfedge(const Cell& cell, const Function& f)
  {
    const Level_connectivity& level = cell.level.level;
    for (const Index corner : cell.halfedges()) {
      Index h = corner;
      do {
        if (!level.is_border(h)) {
          Index g = h;
          do {
            f(g);
            g = level.next(g);
          } while (g != h);
        }
        h = level.next_around_target(h);
      } while (h != corner);
    }
  }

  bool has_uniform_faces(const Cell& cell) const
  {
    bool all = true;
    for_each_halfedge(cell, [&](Index h) { all = all && cell.level.level.has_degree(h, degree_); });
    return all;
  }

  // false if there is no finite bound
  bool add_box(const Cell& cell)
  {
    const Level_connectivity& level = cell.level.level;
    const typename Cells::Cell_slots slots(level, cell.creases);
    Bbox_3 box;
    double delta = 0, d = 0, largest = 0;
    for_each_halfedge(cell, [&](Index h) {
      const auto &a = cell.level.values[slots(h)], &b = cell.level.values[slots(level.next(h))];
      const auto &p = point_of(a), &q = point_of(b);
      box += Bbox_3(p[0], p[1], p[2], p[0], p[1], p[2]);
      d = (std::max)(d, quick_length(difference<double, 3>(p, q)));
      if constexpr (has_normal_v<typename Cells::Value>) {
        const bool have_normals =
          a.normal != zero_vector<double, 3>() && b.normal != zero_vector<double, 3>();
        delta =
          (std::max)(delta, have_normals ? quick_length(difference<double, 3>(a.normal, b.normal))
                                         : std::numeric_limits<double>::infinity());
      }
      for (const double x : p) largest = (std::max)(largest, std::abs(x));
    });
    const double distance = is_pn_ ? this->distance(cell, delta, d) : 0;
    if (!std::isfinite(distance)) return false;
    const double growth = distance + 64 * std::numeric_limits<double>::epsilon() * largest;
    result_.box += Bbox_3(box.xmin() - growth, box.ymin() - growth, box.zmin() - growth,
                          box.xmax() + growth, box.ymax() + growth, box.zmax() + growth);
    result_.distance = (std::max)(result_.distance, distance);
    return true;
  }

  // of the limit from that of the linear scheme
  double distance(const Cell& cell, double delta, double d) const
  {
    Proven_bound bound(degree_);
    for (const Index h : cell.halfedges()) include(bound, cell.level.level, h);
    const double proven = bound(delta, d);
    return is_proven_ ? proven : (std::min)(proven, estimated_part() * (std::min)(delta, 2.) * d);
  }
  // Of a surface with two equal curvatures a round raises points by 1/4 of delta d, or 3/16 in triangles, and all rounds by 4/3 of
  // this.
  double estimated_part() const { return degree_ == 4 ? 0.4 : 0.3; }

  static void include(Proven_bound& bound, const Level_connectivity& level, Index h)
  {
    const auto valence = static_cast<unsigned>(level.valence(level.target(h)));
    if (valence >= Proven_bound::least_valence && valence <= Proven_bound::most_valence)
      bound.include(valence);
  }

  const Cells& cells_;
  const unsigned degree_;
  const bool is_pn_, is_proven_;
  const unsigned rounds_, more_rounds_;
  Surface_box result_;
};

// whether it is Catmull-Clark or Loop, with the same weights for points and normals
template <class Scheme>
bool has_proven_bound(const Scheme& scheme)
{
  if constexpr (Is_with_normals<Scheme>::value)
    return false;
  else if constexpr (Is_adaptor<Scheme>::value)
    return has_proven_bound(scheme.scheme);
  else
    return name_in_message(scheme) == name_in_message(CatmullClark_scheme()) ||
           name_in_message(scheme) == name_in_message(Loop_scheme());
}

// Refuses what the proof does not cover, naming the first vertex of the face.
template <class Cells>
void require_proof(const Cells& cells, Level_connectivity::Index face, unsigned degree)
{
  using Index = Level_connectivity::Index;
  const Level_connectivity& level = cells.control().level;
  const auto refuse = [](Index v, const std::string& what) {
    throw std::invalid_argument("PN_subdivision_3: no enclosure is proven at vertex number " +
                                std::to_string(v) + ", " + what + ": use bbox()");
  };
  const auto is_covered = [](Index n) {
    return n >= Proven_bound::least_valence && n <= Proven_bound::most_valence;
  };
  const Index first = level.halfedge_of_face(face);
  Index h = first;
  do {
    const Index v = level.target(h);
    if (level.is_border_vertex(v)) refuse(v, "which is on the border");
    if (!is_covered(level.valence(v)))
      refuse(v, "whose valence is " + std::to_string(level.valence(v)) + ", not from 3 to 12");
    if constexpr (are_creases_v<std::decay_t<decltype(cells.creases())>>)
      for (const Crease_star& star : cells.creases().stars)
        if (star.vertex == v) refuse(v, "which is sharp");
    Index g = h;
    do {
      if (degree == 4 && !is_covered(level.degree(g)))
        refuse(v, "which has a face with more than 12 corners");
      g = level.next_around_target(g);
    } while (g != h);
    h = level.next(h);
  } while (h != first);
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_SURFACE_CELL_ENCLOSURE_H

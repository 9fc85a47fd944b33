// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_SURFACE_CELL_ENCLOSURE_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_SURFACE_CELL_ENCLOSURE_H

#include <CGAL/Bbox_3.h>
#include <CGAL/PN_limit_surface_3/internal/limit_surface/Limit_cells.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/concepts/scheme_traits.h>
#include <CGAL/PN_subdivision_3/internal/normals/Fan.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

namespace CGAL::PN_subdivision_3::internal {

// A bound of the distance of a point-normal limit from that of the linear scheme on the same net, whose edges have ends no
// farther apart than D, with unit normals that differ by delta at most. With non-negative weights the height H of a
// point-normal average is bounded by its covariances, and both differences contract:
//   eta = ((1 - (1 - sigma2 delta^2)^(1/2)) / (2 - d0^2 delta^2 / 2))^(1/2) sigma D >= |H|,
//   delta' = gamma delta / (1 - sigma2 delta^2)^(1/2),  D' = gamma D + 2 eta;
// the bound is the sum of all eta, infinite where the normals differ too much. The constants are those of
// scripts/enclosure_constants.py, rounded up.
class Proven_bound
{
public:
  static constexpr unsigned least_valence = 3, most_valence = 12;

  // degree: of the faces; valence: the one at a corner with the largest gamma is decisive, see include()
  explicit Proven_bound(unsigned degree)
    : is_quads_(degree == 4)
    , sigma2_(is_quads_ ? 0.75 : 0.4258)
    , d0_(is_quads_ ? 4 : 2)
  {}

  // \pre least_valence <= valence <= most_valence
  void include(unsigned valence)
  {
    constexpr double of_quads[] = {0.5,    0.5,    0.67,   0.75,   0.7909,
                                   0.8125, 0.8241, 0.8300, 0.8327, 0.8334};
    constexpr double of_triangles[] = {0.5,   0.5,    0.5,    0.5,    0.5760,
                                       0.625, 0.6588, 0.6834, 0.7021, 0.7168};
    const double gamma = (is_quads_ ? of_quads : of_triangles)[valence - least_valence];
    if (gamma > gamma_) gamma_ = gamma;
    if (is_quads_ && valence == 3) sigma2_ = 0.8426;
  }

  double operator()(double delta, double d) const
  {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    double sum = 0;
    for (int i = 0; i < 1000 && delta * d > 0; ++i) {
      const double remaining = 1 - sigma2_ * delta * delta;
      const double cosine = 2 - d0_ * d0_ * delta * delta / 2;
      if (!(remaining > 0) || !(cosine >= 1)) return infinite;
      const double root = std::sqrt(remaining);
      // 1 - root without cancellation
      const double eta =
        std::sqrt(sigma2_ * delta * delta / (1 + root) / cosine) * std::sqrt(sigma2_) * d;
      sum += eta;
      delta = gamma_ * delta / root;
      d = gamma_ * d + 2 * eta;
      if (delta < 1e-40) break;
    }
    return sum * (1 + 1e-12);
  }

private:
  bool is_quads_;
  double gamma_ = 0.5, sigma2_, d0_;
};

// the error that computing with the points of a net adds to a bound, per unit of the largest coordinate
constexpr double rounding_of_bound = 64 * std::numeric_limits<double>::epsilon();

// The faces round the corners of a cell, on whose vertices the linear limit of its face depends.
template <class Cells>
class Cell_net
{
public:
  using Index = Level_connectivity::Index;
  using Cell = typename Cells::Cell;

  explicit Cell_net(const Cell& cell)
    : cell_(cell)
  {}

  // calls f(half-edge) with all of the faces
  template <class Function>
  void for_each_halfedge(const Function& f) const
  {
    const Level_connectivity& level = cell_.level.level;
    for (const Index corner : cell_.corners())
      for_each_halfedge_to(level, corner, [&](Index h) {
        if (!level.is_border(h)) for_each_halfedge_of_face(level, level.face(h), f);
      });
  }

  bool has_uniform_faces() const
  {
    bool all = true;
    for_each_halfedge(
      [&](Index h) { all = all && cell_.level.level.has_degree(h, Cells::degree); });
    return all;
  }

  // The largest differences over edges, infinite where one end has no normal; without any the average is linear. Calls
  // f(point).
  template <class Function>
  std::pair<double, double> differences(const Function& f) const
  {
    const typename Cells::Cell_slots slot_of(cell_.level.level, cell_.creases);
    double delta = 0, d = 0;
    for_each_halfedge([&](Index h) {
      const auto &a = cell_.level.values[slot_of(h)],
                 &b = cell_.level.values[slot_of(cell_.level.level.next(h))];
      f(point_of(a));
      d = (std::max)(d, quick_length(difference(point_of(a), point_of(b))));
      if constexpr (has_normal_v<typename Cells::Value>) {
        const auto none = zero_vector<double, 3>();
        delta = (std::max)(delta, (a.normal == none) == (b.normal == none)
                                    ? quick_length(difference(a.normal, b.normal))
                                    : std::numeric_limits<double>::infinity());
      }
    });
    return {delta, d};
  }

  // how far the limit is from that of the linear scheme, with such differences
  double proven_distance(double delta, double d) const
  {
    Proven_bound bound(Cells::degree);
    for (const Index h : cell_.halfedges()) {
      const auto valence =
        static_cast<unsigned>(cell_.level.level.valence(cell_.level.level.target(h)));
      if (valence >= Proven_bound::least_valence && valence <= Proven_bound::most_valence)
        bound.include(valence);
    }
    return bound(delta, d);
  }

private:
  const Cell& cell_;
};

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

  Cell_enclosure(const Cells& cells, bool is_proven, unsigned rounds, unsigned more_rounds)
    : cells_(cells)
    , is_proven_(is_proven)
    , rounds_(rounds)
    , more_rounds_(more_rounds)
  {}

  void add(Cell&& cell)
  {
    const Level_connectivity& level = cell.level.level;
    const bool is_known =
      level.has_degree(cell.base, Cells::degree) && Cell_net<Cells>(cell).has_uniform_faces();
    if (is_known && cell.rounds >= rounds_ && add_box(cell)) return;
    if (cell.rounds >= rounds_ + more_rounds_)
      throw std::domain_error("PN_subdivision_3: the normals of neighbors differ so much that no "
                              "bound is proven, even after " +
                              std::to_string(cell.rounds) + " rounds: use bbox()");
    const auto n = static_cast<Index>(cell.halfedges().size());
    const typename Cells::Round round(cells_, std::move(cell));
    for (Index i = 0; i < (Cells::degree == 3 ? 4 : n); ++i) add(round.child(i));
  }

  const Surface_box& result() const { return result_; }

private:
  // false if there is no finite bound
  bool add_box(const Cell& cell)
  {
    const Cell_net<Cells> net(cell);
    Bbox_3 box;
    double largest = 0;
    const auto [delta, d] = net.differences([&](const auto& p) {
      box += Bbox_3(p[0], p[1], p[2], p[0], p[1], p[2]);
      for (const double x : p) largest = (std::max)(largest, std::abs(x));
    });
    double distance = is_pn ? net.proven_distance(delta, d) : 0;
    if (is_pn && !is_proven_)
      distance = (std::min)(distance, estimated_part() * (std::min)(delta, 2.) * d);
    if (!std::isfinite(distance)) return false;
    const double growth = distance + rounding_of_bound * largest;
    result_.box += Bbox_3(box.xmin() - growth, box.ymin() - growth, box.zmin() - growth,
                          box.xmax() + growth, box.ymax() + growth, box.zmax() + growth);
    result_.distance = (std::max)(result_.distance, distance);
    return true;
  }

  // Of a surface with two equal curvatures a round raises points by 1/4 of delta d, or 3/16 in triangles, and all rounds by 4/3 of
  // this.
  static double estimated_part() { return Cells::degree == 4 ? 0.4 : 0.3; }

  static constexpr bool is_pn = is_pn_v<typename Cells::Scheme_type>;

  const Cells& cells_;
  const bool is_proven_;
  const unsigned rounds_, more_rounds_;
  Surface_box result_;
};

inline std::string text_of(double x)
{
  std::ostringstream text;
  text.precision(3);
  text << x;
  return text.str();
}

// whether it is Catmull-Clark or Loop, with the same weights for points and normals
template <class Scheme>
bool has_proven_bound(const Scheme& scheme)
{
  if (facts_of(scheme).has_normal_mask) return false;
  if constexpr (Is_adaptor<Scheme>::value)
    return has_proven_bound(scheme.scheme);
  else
    return name_in_message(scheme) == name_in_message(CatmullClark_scheme()) ||
           name_in_message(scheme) == name_in_message(Loop_scheme());
}

// Whether there is a normal in the faces at a vertex. A vertex without has none after any round.
template <class Cells>
bool has_normals_about(const Cells& cells, Level_connectivity::Index v)
{
  using Index = Level_connectivity::Index;
  const Level_connectivity& level = cells.control().level;
  bool result = false;
  const auto look = [&](Index h) {
    result = result || cells.control().values[level.target(h)].normal != zero_vector<double, 3>();
  };
  for_each_halfedge_to(level, v, [&](Index h) {
    look(h);
    if (!level.is_border(h)) for_each_halfedge_of_face(level, level.face(h), look);
  });
  return result;
}

// Calls f(vertex, what) with what the proof does not cover about a face. Rounding may take half of a tolerance: it counts on
// the surface and on its sides, and points may be farther out than those of the control mesh.
template <class Cells, class Function>
void for_each_unproven(const Cells& cells, Level_connectivity::Index face, const Function& f,
                       double tolerance = std::numeric_limits<double>::infinity())
{
  using Index = Level_connectivity::Index;
  const Level_connectivity& level = cells.control().level;
  const auto is_covered = [](Index n) {
    return n >= Proven_bound::least_valence && n <= Proven_bound::most_valence;
  };
  for_each_halfedge_of_face(level, face, [&](Index h) {
    const Index v = level.target(h);
    if (level.is_border_vertex(v)) f(v, std::string("which is on the border"));
    if (!is_covered(level.valence(v)))
      f(v, "whose valence is " + std::to_string(level.valence(v)) + ", not from 3 to 12");
    const double rounding =
      4 * rounding_of_bound * largest_coordinate(point_of(cells.control().values[v]));
    if (!(rounding <= tolerance))
      f(v, "whose coordinates leave " + text_of(rounding) +
             " to rounding, more than the tolerance (move the mesh to the origin)");
    if constexpr (has_normal_v<typename Cells::Value>)
      if (!has_normals_about(cells, v) && has_normals_about(cells, level.target(level.next(h))))
        f(v, std::string("which has no normals about it, while a neighbor has"));
    if constexpr (are_creases_v<std::decay_t<decltype(cells.creases())>>)
      for (const Crease_star& star : cells.creases().stars)
        if (star.vertex == v) f(v, std::string("which is sharp"));
    if constexpr (has_normal_v<typename Cells::Value>) {
      const double w = cells.control().values[v].roundness;
      if (!(w >= 0 && w <= 1)) f(v, std::string("whose roundness is not from 0 to 1"));
    }
    for_each_halfedge_to(level, v, [&](Index g) {
      if (Cells::degree == 4 && !is_covered(level.degree(g)))
        f(v, std::string("which has a face with more than 12 corners"));
    });
  });
}

// Refuses that, naming the first vertex of the face.
template <class Cells>
void require_proof(const Cells& cells, Level_connectivity::Index face)
{
  for_each_unproven(cells, face, [](Level_connectivity::Index v, const std::string& what) {
    throw std::invalid_argument("PN_subdivision_3: no enclosure is proven at vertex number " +
                                std::to_string(v) + ", " + what + ": use bbox()");
  });
}

// Refuses what distances of tessellations are not proven for, naming the first vertex of all.
template <class Cells>
void require_proof_of_all(const Cells& cells, double tolerance)
{
  using Index = Level_connectivity::Index;
  const std::string rest = ": take the estimated one";
  if (!has_proven_bound(cells.scheme()))
    throw std::invalid_argument("PN_subdivision_3: no distance is proven for " +
                                name_in_message(cells.scheme()) +
                                ", except for Catmull-Clark and Loop" + rest);
  Index first = Level_connectivity::null;
  std::string why;
  const auto note = [&](Index v, const std::string& what) {
    if (first != Level_connectivity::null && v >= first) return;
    first = v;
    why = what;
  };
  for (Index f = 0; f < cells.control().level.number_of_faces(); ++f)
    for_each_unproven(cells, f, note, tolerance);
  if (first != Level_connectivity::null)
    throw std::invalid_argument("PN_subdivision_3: no distance is proven at vertex number " +
                                std::to_string(first) + ", " + why + rest);
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_SURFACE_CELL_ENCLOSURE_H

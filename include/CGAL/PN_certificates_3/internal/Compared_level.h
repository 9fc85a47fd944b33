// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_CERTIFICATES_3_INTERNAL_COMPARED_LEVEL_H
#define CGAL_PN_CERTIFICATES_3_INTERNAL_COMPARED_LEVEL_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/average/input_checks.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/meshes/Mesh_values.h>
#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
#include <CGAL/PN_subdivision_3/internal/meshes/read_mesh.h>
#include <CGAL/PN_subdivision_3/internal/normals/Fan.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Level_refiner.h>
#include <CGAL/PN_subdivision_3/internal/rounds/Round.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/Uncertain.h>
#include <CGAL/number_type_basic.h>
#include <CGAL/utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

template <class FT>
struct Level_with_points
{
  Level_connectivity level;
  std::vector<Coordinates<FT, 3>> points;
  std::vector<bool> is_sharp = {}; // of edges; or empty
  // how many control vertices have them, if the roundness varies
  std::size_t of_roundness_0 = 0, of_roundness_below_1 = 0;
};

template <class FT, class Value>
void count_roundness([[maybe_unused]] const std::vector<Value>& values,
                     [[maybe_unused]] Level_connectivity::Index number_of_vertices,
                     [[maybe_unused]] Level_with_points<FT>& result)
{
  if constexpr (has_normal_v<Value>) {
    bool varies = false;
    for (Level_connectivity::Index v = 0; v < number_of_vertices; ++v)
      varies = varies || CGAL::possibly(values[v].roundness != values[0].roundness);
    for (Level_connectivity::Index v = 0; varies && v < number_of_vertices; ++v) {
      result.of_roundness_0 += CGAL::certainly(values[v].roundness == FT(0));
      result.of_roundness_below_1 += CGAL::certainly(values[v].roundness < FT(1));
    }
  }
}

// the points of the vertices, which are the first values
template <class Average, class Values>
auto points_of(const Values& values, Level_connectivity::Index number)
{
  std::vector<Coordinates<typename Average::FT, 3>> points;
  points.reserve(number);
  for (Level_connectivity::Index v = 0; v < number; ++v) // values may be stored in another way
    points.push_back(point_of(typename Average::Value(values[v])));
  return points;
}

// The level that the rounds of a scheme make of a mesh, as subdivide() does it; mesh and maps are only read.
template <class Concurrency_tag, class FT, class Scheme, class Access, class Point_map,
          class Normal_map, class Edge_map, class Vertex_map>
Level_with_points<FT> refined_aside(const Scheme& scheme, const Access& access, unsigned rounds,
                                    Point_map points, Normal_map normals, Edge_map edge_map,
                                    Vertex_map vertex_map)
{
  if constexpr (!is_pn_v<Scheme> && is_there_v<Normal_map>)
    return refined_aside<Concurrency_tag, FT>(scheme, access, rounds, points, Not_given(), edge_map,
                                              vertex_map);
  else if constexpr (check_corner_normals<Scheme, Access, Normal_map>()) {
    using Average = Average_of_scheme<Scheme, FT>;
    require_crease_rules(scheme, access, normals, edge_map, vertex_map);
    Control_mesh control(scheme, access, normals, edge_map, vertex_map, FT());
    using Level_creases = typename decltype(control)::Level_creases;
    control.maps.read_tangents(control.creases);
    rounds = number_of_rounds(control.level, rounds);
    checked_refined_size<typename Scheme::Host>(control.level.size(), rounds,
                                                Level_connectivity::null);
    const auto values = control.maps.values(control.level, points, normals, control.creases);
    Level_with_points<FT> result;
    count_roundness(values, control.level.number_of_vertices(), result);
    const Scheme_of_rounds<Scheme>& round_scheme = scheme_of_rounds(scheme);
    Level_refiner<Scheme_of_rounds<Scheme>, Average, Level_creases> refiner(
      round_scheme, std::move(control.level), std::move(control.creases),
      {values.begin(), values.end()}, For_chunks::with(Concurrency_tag()));
    while (refiner.rounds_done() < rounds) refiner.refine();
    result.level = refiner.level();
    result.points = points_of<Average>(refiner.values(), result.level.number_of_vertices());
    if constexpr (are_creases_v<Level_creases>) {
      result.is_sharp.assign(result.level.number_of_edges(), false);
      for (const auto& e : refiner.creases().edges) result.is_sharp[e.edge] = e.sharpness > 0;
    }
    for (Level_connectivity::Index v = 0; v < result.points.size(); ++v)
      check_in_range(result.points[v],
                     [&] { return "the point of the new vertex " + std::to_string(v); });
    return result;
  }
}

// Points in double that are compared: relative to a point of the control mesh, divided by a power of two that is
// about its size, so that neither far places nor large or small numbers cost digits.
template <class FT>
class Unit_frame
{
  using Coordinate = At_least_double<FT>;
  using Point_of_frame = Coordinates<Coordinate, 3>;

public:
  using Points = std::vector<Coordinates<double, 3>>;

  explicit Unit_frame(const std::vector<Coordinates<FT, 3>>& control)
    : origin_(control.empty() ? zero_vector<Coordinate, 3>() : widened(control.front()))
  {
    double size = 0;
    for (const Coordinates<double, 3>& p : (*this)(control))
      for (const double x : p) size = (std::max)(size, std::abs(x));
    if (size > 0 && std::isfinite(size)) exponent_ = std::ilogb(size) + 1;
    double farthest = 0;
    for (const Coordinate& x : origin_) farthest = (std::max)(farthest, std::abs(close_double(x)));
    const double epsilon = (std::max)(close_double(machine_epsilon<FT>()), 0x1p-53);
    if (is_exact_v<FT>) farthest = 0; // only what is relative to the origin is rounded
    rounding_ = epsilon * (1 + std::ldexp(farthest, -exponent_));
  }

  Points operator()(const std::vector<Coordinates<FT, 3>>& points) const
  {
    Points result;
    result.reserve(points.size());
    for (const Coordinates<FT, 3>& p : points) {
      result.push_back(to_double_3(difference(widened(p), origin_)));
      for (double& x : result.back()) x = std::ldexp(x, -exponent_);
    }
    return result;
  }

  // the rounding of coordinates
  double rounding() const { return rounding_; }
  // the power of two that coordinates are divided by
  int exponent() const { return exponent_; }

private:
  static Point_of_frame widened(const Coordinates<FT, 3>& p)
  {
    return {Coordinate(p[0]), Coordinate(p[1]), Coordinate(p[2])};
  }

  Point_of_frame origin_;
  int exponent_ = 0;
  double rounding_ = 0;
};

// What is measured of a level whose points are in a Unit_frame. A polygon is taken as triangles round its mean.
class Level_shape
{
public:
  using Index = Level_connectivity::Index;
  using Vector = Coordinates<double, 3>;

  // is_sharp: of edges, or empty
  Level_shape(Level_connectivity level, std::vector<Vector> points, std::vector<bool> is_sharp,
              double rounding)
    : level_(std::move(level))
    , points_(std::move(points))
    , is_sharp_(std::move(is_sharp))
    , rounding_(rounding)
  {
    areas_.reserve(level_.number_of_faces());
    for (Index f = 0; f < level_.number_of_faces(); ++f) add_face(f);
  }

  const std::vector<Vector>& points() const { return points_; }
  bool is_closed() const { return level_.number_of_faces() > 0 && !level_.has_border(); }
  // the volume of a closed level; 0 if it is no more than rounding
  double volume() const
  {
    return std::abs(volume_) <= 1e-13 * volume_terms_ + rounding_ * area_ ? 0 : volume_;
  }

  // Edges that are not sharp, at which two faces with an area meet at an angle greater than this, which has a cosine, by more
  // than what rounding makes of rectangular ones.
  std::size_t edges_beyond(double cosine) const { return folds_beyond(cosine).edges; }
  struct Folds
  {
    std::size_t edges = 0;
    double length = 0; // in all
  };
  Folds folds_beyond(double cosine) const
  {
    constexpr double margin = 1e-10;
    Folds folds;
    for (Index e = 0; e < level_.number_of_edges(); ++e) {
      if (level_.is_border_edge(e) || (!is_sharp_.empty() && is_sharp_[e])) continue;
      const Vector &m = areas_[level_.face(2 * e)], &n = areas_[level_.face(2 * e + 1)];
      if (!(dot(m, n) < (cosine - margin) * quick_length(m) * quick_length(n))) continue;
      ++folds.edges;
      folds.length +=
        quick_length(difference(points_[level_.source(2 * e)], points_[level_.target(2 * e)]));
    }
    return folds;
  }

  // the mean length of the edges at each vertex, 0 without edges
  std::vector<double> edge_lengths() const
  {
    std::vector<double> sum(points_.size(), 0.);
    std::vector<std::size_t> valence(points_.size(), 0);
    for (Index h = 0; h < level_.number_of_halfedges(); ++h) {
      const Index v = level_.target(h);
      sum[v] += quick_length(difference(points_[level_.source(h)], points_[v]));
      ++valence[v];
    }
    for (std::size_t v = 0; v < sum.size(); ++v)
      if (valence[v] > 0) sum[v] /= double(valence[v]);
    return sum;
  }

private:
  void add_face(Index f)
  {
    Vector mean{0, 0, 0};
    double degree = 0;
    for_each_halfedge_of_face(level_, f, [&](Index h) {
      add_multiple<double, 3>(mean, 1., points_[level_.target(h)]);
      ++degree;
    });
    mean = quotient(mean, degree);
    Vector area{0, 0, 0};
    double noise = 0;
    for_each_halfedge_of_face(level_, f, [&](Index h) {
      const Vector before = difference(points_[level_.target(h)], mean),
                   corner = difference(points_[level_.target(level_.next(h))], mean);
      add_multiple<double, 3>(area, 0.5, cross(before, corner));
      const double r = quick_length(corner);
      noise += r * (0x1p-46 * r + 2 * rounding_);
    });
    const double size = quick_length(area);
    volume_ += dot(mean, area) / 3;
    volume_terms_ += quick_length(mean) * size;
    area_ += size;
    areas_.push_back(size <= noise ? Vector{0, 0, 0} : quotient(area, size));
  }

  Level_connectivity level_;
  std::vector<Vector> points_;
  std::vector<bool> is_sharp_;
  double rounding_;
  std::vector<Vector> areas_; // their directions, 0 of faces without area
  double volume_ = 0, volume_terms_ = 0, area_ = 0;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_CERTIFICATES_3_INTERNAL_COMPARED_LEVEL_H

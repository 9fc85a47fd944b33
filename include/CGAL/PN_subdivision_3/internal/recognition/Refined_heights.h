// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_RECOGNITION_REFINED_HEIGHTS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_RECOGNITION_REFINED_HEIGHTS_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/comparison/Level_shape.h>
#include <CGAL/PN_subdivision_3/internal/comparison/refined_aside.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/creases/make_creases.h>
#include <CGAL/PN_subdivision_3/internal/recognition/Part.h>
#include <CGAL/PN_subdivision_3/internal/recognition/Surface_tags.h>
#include <CGAL/PN_subdivision_3/internal/recognition/linear_algebra.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Average_of_scheme.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Level_refiner.h>
#include <CGAL/PN_subdivision_3/internal/schemes/scheme_of_call.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/scheme_adaptors.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {
namespace recognition {

// Of each control face how far two rounds move it out of its plane, where it is on a round surface how far out of that, and
// whether they fold it.
struct Face_changes
{
  std::vector<double> height, deviation;
  std::vector<bool> is_folded;
  double volume = 0; // of the whole; 0 if it is open
};

// A control mesh with its tags, and what a scheme makes of it.
class Refined_heights
{
public:
  Refined_heights(const Level_connectivity& level, const Part& part)
    : level_(level)
    , part_(part)
  {
    for (Index v = 0; v < level.number_of_vertices(); ++v) {
      const Index rank = part.rank_of_vertex[v];
      points_.push_back(as_array(rank == null ? Vec3() : part.points[rank]));
    }
  }

  void measure_from(const Surface_tags& tags) { tags_ = &tags; }

  using Value = Point_normal_roundness<double, 3>;

  Creases<double> creases(const std::vector<bool>& is_crease,
                          const std::vector<bool>& is_corner) const
  {
    return Make_creases<double>(level_, Border::surface)(
      [&](Index e) { return is_crease[e] ? infinite_sharpness : 0.; },
      [&](Index v) { return is_corner[v] ? infinite_sharpness : 0.; });
  }

  Face_changes linear(const std::vector<bool>& is_crease, const std::vector<bool>& is_corner)
  {
    Creases<double> c = creases(is_crease, is_corner);
    std::vector<Coordinates<double, 3>> values = points_;
    for (const Index v : vertices_of_extra_slots(c, level_.number_of_vertices()))
      values.push_back(points_[v]);
    return level_.uniform_degree() == 3
             ? changes(PN_subdivision_3::linear(Loop_scheme()), std::move(c), values)
             : changes(PN_subdivision_3::linear(CatmullClark_scheme()), std::move(c), values);
  }

  // with the values of the slots
  Face_changes point_normal(Creases<double> c, const std::vector<Value>& values)
  {
    return level_.uniform_degree() == 3
             ? changes(With_roundness<Loop_scheme, double>{{Loop_scheme()}}, std::move(c), values)
             : changes(With_roundness<CatmullClark_scheme, double>{{CatmullClark_scheme()}},
                       std::move(c), values);
  }

  const std::vector<Coordinates<double, 3>>& points() const { return points_; }
  double volume() const { return volume_of(level_, points_); }
  int refinements() const { return refinements_; } // so far

private:
  template <class Scheme, class Values>
  Face_changes changes(const Scheme& scheme, Creases<double>&& c, const Values& values)
  {
    ++refinements_;
    using Average = Average_of_scheme<Scheme, double>;
    using Refiner = Level_refiner<Scheme, Average, Creases<double>>;
    Level_connectivity level = level_;
    std::vector<Index> origin(level_.number_of_faces());
    for (Index f = 0; f < origin.size(); ++f) origin[f] = f;
    Refiner refiner(scheme, std::move(level), std::move(c), {values.begin(), values.end()});
    for (unsigned round = 1; round <= 2; ++round) {
      const typename Scheme::Host host(refiner.level(), round);
      std::vector<Index> next(Scheme::Host::refined_size(refiner.level().size(), round).faces);
      for (Index f = 0; f < next.size(); ++f) next[f] = origin[host.parent_of_face(f).index];
      refiner.refine();
      origin = std::move(next);
    }
    return measured(refiner.level(),
                    points_of<Average>(refiner.values(), refiner.level().number_of_vertices()),
                    origin);
  }

  Face_changes measured(const Level_connectivity& level,
                        const std::vector<Coordinates<double, 3>>& points,
                        const std::vector<Index>& origin) const
  {
    Face_changes result{std::vector<double>(level_.number_of_faces(), 0),
                        std::vector<double>(level_.number_of_faces(), 0),
                        std::vector<bool>(level_.number_of_faces(), false),
                        volume_of(level, points)};
    std::vector<double> distance(points.size(), std::numeric_limits<double>::infinity());
    for (Index h = 0; h < level.number_of_halfedges(); ++h) {
      if (level.is_border(h)) continue;
      const Index v = level.target(h);
      const Index f = origin[level.face(h)];
      const double d = distance_from_plane(f, as_vec3(points[v]));
      if (tags_ != nullptr && tags_->is_round(f))
        result.deviation[f] =
          (std::max)(result.deviation[f], std::abs(tags_->shape(f).distance(as_vec3(points[v]))));
      distance[v] = (std::min)(distance[v], d);
    }
    for (Index h = 0; h < level.number_of_halfedges(); ++h) {
      if (level.is_border(h) || std::isinf(distance[level.target(h)])) continue;
      double& height = result.height[origin[level.face(h)]];
      height = (std::max)(height, distance[level.target(h)]);
    }
    for (Index f = 0; f < level.number_of_faces(); ++f)
      if (is_turned_over(level, points, f, normal_of(origin[f])))
        result.is_folded[origin[f]] = true;
    return result;
  }
  static double volume_of(const Level_connectivity& level,
                          const std::vector<Coordinates<double, 3>>& points)
  {
    constexpr double rounding = 0x1p-52; // of the points of a Part
    return level.has_border() ? 0 : Level_shape(level, points, rounding).volume();
  }
  const Vec3& normal_of(Index f) const { return part_.normal[part_.rank_of_face[f]]; }
  // infinite of slivers
  double distance_from_plane(Index f, const Vec3& p) const
  {
    const Vec3& n = normal_of(f);
    if (!(dot(n, n) > 0)) return std::numeric_limits<double>::infinity();
    return std::abs(dot(n, p - as_vec3(points_[level_.target(level_.halfedge_of_face(f))])));
  }
  static bool is_turned_over(const Level_connectivity& level,
                             const std::vector<Coordinates<double, 3>>& points, Index f,
                             const Vec3& normal)
  {
    const Index first = level.halfedge_of_face(f);
    const Vec3 origin = as_vec3(points[level.target(first)]);
    Vec3 area, before;
    double size = 0;
    for (Index h = level.next(first); h != first; h = level.next(h)) {
      const Vec3 p = as_vec3(points[level.target(h)]) - origin;
      area += cross(before, p);
      size = (std::max)(size, dot(p, p));
      before = p;
    }
    return dot(area, normal) < -1e-9 * size;
  }

  const Level_connectivity& level_;
  const Part& part_;
  const Surface_tags* tags_ = nullptr;
  std::vector<Coordinates<double, 3>> points_;
  int refinements_ = 0;
};

} // namespace recognition
} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_RECOGNITION_REFINED_HEIGHTS_H

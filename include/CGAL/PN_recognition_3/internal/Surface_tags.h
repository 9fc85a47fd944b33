// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_RECOGNITION_3_INTERNAL_SURFACE_TAGS_H
#define CGAL_PN_RECOGNITION_3_INTERNAL_SURFACE_TAGS_H

#include <CGAL/PN_recognition_3/internal/Part.h>
#include <CGAL/PN_recognition_3/internal/Shape.h>
#include <CGAL/PN_subdivision_3/internal/normals/Fan.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {
namespace recognition {

// What follows from the surface of each face: creases, corners, and normals of corners of faces.
class Surface_tags
{
public:
  Surface_tags(const Level_connectivity& level, const Part& part,
               const std::vector<Recognized_surface>& surfaces, std::vector<std::size_t> patches,
               double sharp_angle)
    : level_(level)
    , part_(part)
    , patch_(std::move(patches))
    , sharp_angle_(sharp_angle)
  {
    for (const Recognized_surface& s : surfaces)
      shapes_.push_back(as_shape(s, part.scale, part.shift));
    set_face_normals();
    set_sides();
  }

  bool is_crease(Index e) const
  {
    if (level_.is_border_edge(e)) return false;
    const Index f = level_.face(2 * e), g = level_.face(2 * e + 1);
    if (is_known(f) || is_known(g)) return patch_[f] != patch_[g];
    return angle(f, g) > sharp_angle_;
  }

  // the apex of a cone
  bool is_corner(Index v) const
  {
    bool result = false;
    if (!level_.is_isolated(v))
      for_each_halfedge(level_, fan_of_vertex(level_, v),
                        [&](Index h) { result = result || (!level_.is_border(h) && is_apex(h)); });
    return result;
  }

  // whether all faces at a vertex are of unknown surfaces
  bool is_unknown(Index v) const
  {
    bool has_unknown = false, has_known = false;
    if (!level_.is_isolated(v))
      for_each_halfedge(level_, fan_of_vertex(level_, v), [&](Index h) {
        if (!level_.is_border(h)) (is_known(level_.face(h)) ? has_known : has_unknown) = true;
      });
    return has_unknown && !has_known;
  }

  // of the corner of face(h) at target(h); zero: none
  Vec3 normal(Index h) const
  {
    if (level_.is_border(h) || !is_known(level_.face(h)) || is_apex(h)) return {};
    const std::size_t patch = patch_[level_.face(h)];
    return double(side_[patch]) * shapes_[patch].normal(point(level_.target(h)));
  }

private:
  bool is_known(Index f) const { return shapes_[patch_[f]].kind != Kind::unknown; }
  // between the normals of faces
  double angle(Index f, Index g) const { return angle_between(normal_[f], normal_[g]); }

  const Vec3& point(Index v) const { return part_.points[part_.rank_of_vertex[v]]; }

  // slivers have that of the face that they join
  void set_face_normals()
  {
    normal_.resize(level_.number_of_faces());
    std::vector<Index> slivers;
    for (Index f = 0; f < normal_.size(); ++f) {
      normal_[f] = part_.normal[part_.rank_of_face[f]];
      if (part_.is_sliver(part_.rank_of_face[f])) slivers.push_back(f);
    }
    while (!slivers.empty()) {
      std::vector<std::pair<Index, Vec3>> found;
      std::vector<Index> rest;
      for (const Index f : slivers) {
        const Vec3 n = normal_of_neighbor(f);
        if (dot(n, n) > 0)
          found.emplace_back(f, n);
        else
          rest.push_back(f);
      }
      if (found.empty()) break;
      for (const auto& n : found) normal_[n.first] = n.second;
      slivers = rest;
    }
  }
  Vec3 normal_of_neighbor(Index f) const
  {
    Vec3 result;
    double longest = -1;
    for_each_halfedge_of_face(level_, f, [&](Index h) {
      const Index o = Level_connectivity::opposite(h);
      const double length = norm(point(level_.target(h)) - point(level_.target(o)));
      if (level_.is_border(o) || patch_[level_.face(o)] != patch_[f] || !(length > longest)) return;
      const Vec3& n = normal_[level_.face(o)];
      if (!(dot(n, n) > 0)) return;
      longest = length;
      result = n;
    });
    return result;
  }

  // the faces' side of each surface
  void set_sides()
  {
    std::vector<double> sums(shapes_.size(), 0);
    for (Index f = 0; f < level_.number_of_faces(); ++f) {
      if (!is_known(f)) continue;
      Vec3 mean;
      double n = 0;
      for_each_halfedge_of_face(level_, f, [&](Index h) {
        mean += point(level_.target(h));
        ++n;
      });
      sums[patch_[f]] +=
        dot(part_.area[part_.rank_of_face[f]], shapes_[patch_[f]].normal((1 / n) * mean));
    }
    for (const double s : sums) side_.push_back(s < 0 ? -1 : 1);
  }

  bool is_apex(Index h) const
  {
    const Shape& s = shapes_[patch_[level_.face(h)]];
    return s.kind == Kind::cone &&
           norm(point(level_.target(h)) - s.center) <= 10 * part_.tolerance / s.sine;
  }

  const Level_connectivity& level_;
  const Part& part_;
  std::vector<std::size_t> patch_;
  double sharp_angle_;
  std::vector<Shape> shapes_;
  std::vector<Vec3> normal_;
  std::vector<int> side_;
};

} // namespace recognition
} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_RECOGNITION_3_INTERNAL_SURFACE_TAGS_H

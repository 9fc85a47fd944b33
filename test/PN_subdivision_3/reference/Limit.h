// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The limit at a vertex by brute force: round after round of the reference form of a scheme on the
// faces around it, with all that is farther away cut off. Nothing is known of limit masks.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_LIMIT_H
#define CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_LIMIT_H

#include "PN_rule.h"

#include <set>

namespace reference {

// The faces within some rings of faces about vertex 0, and their vertices; that one stays the first.
struct Patch
{
  std::vector<Face> faces;
  Values values;

  Face_list face_list() const { return Face_list(int(values.points.size()), faces); }
};

// The vertices that the patch has, as numbers in the whole, and its faces in its own numbers.
inline std::pair<std::vector<int>, std::vector<Face>> cut_out(const std::vector<Face>& faces,
                                                              int center, int rings)
{
  std::set<int> inside = {center};
  std::set<std::size_t> kept;
  for (int r = 0; r < rings; ++r) {
    std::set<int> next = inside;
    for (std::size_t f = 0; f < faces.size(); ++f)
      for (int v : faces[f])
        if (inside.count(v) != 0) {
          kept.insert(f);
          next.insert(faces[f].begin(), faces[f].end());
          break;
        }
    inside.swap(next);
  }
  std::vector<int> vertices = {center};
  std::map<int, int> number = {{center, 0}};
  std::vector<Face> result;
  for (std::size_t f : kept) {
    result.emplace_back();
    for (int v : faces[f]) {
      if (number.emplace(v, int(number.size())).second) vertices.push_back(v);
      result.back().push_back(number.at(v));
    }
  }
  return {vertices, result};
}

// the rule, of the entries that are not zero
inline Point_normal new_value(const Row& row, const Values& old, bool linear)
{
  Values used;
  std::vector<Real> weights;
  for (Eigen::Index j = 0; j < row.size(); ++j)
    if (row[j] != 0) {
      weights.push_back(row[j]);
      used.points.push_back(old.points[std::size_t(j)]);
      used.normals.push_back(linear ? Vector(Vector::Zero()) : old.normals[std::size_t(j)]);
    }
  const Row shorter = Eigen::Map<const Row>(weights.data(), Eigen::Index(weights.size()));
  return pn_rule(shorter, shorter, used);
}

// Refine is a function (Face_list, round) -> Refined, finish one (Face_list, new values).
template <class Refine, class Finish>
Patch refined(const Patch& patch, const Refine& refine, const Finish& finish, unsigned round,
              int rings, bool linear)
{
  const Face_list list = patch.face_list();
  const Refined all = refine(list, round);
  Values values;
  for (const Row& row : all.points) {
    const Point_normal value = new_value(row, patch.values, linear);
    values.points.push_back(value.point);
    values.normals.push_back(value.normal);
  }
  if (!linear) finish(list, values);
  const auto [vertices, faces] = cut_out(all.faces, 0, rings);
  Patch result{faces, {}};
  for (int v : vertices) {
    result.values.points.push_back(values.points[std::size_t(v)]);
    result.values.normals.push_back(values.normals[std::size_t(v)]);
  }
  return result;
}

struct Limit
{
  Vector point, control_normal, surface_normal;
  Real normal_change; // of the surface normal in the last ten rounds
};

// The normal of the polygon of the neighbors. As the ring shrinks its shape tends to an affine image
// of that of the scheme's characteristic map.
inline Vector polygon_normal(const Patch& patch)
{
  const Face_list list = patch.face_list();
  const std::vector<int> ring = list.ring(0);
  Vector sum = Vector::Zero();
  const auto& p = patch.values.points;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const bool is_gap = i + 1 == ring.size() && list.is_border(0);
    if (is_gap) break;
    const Vector a = p[std::size_t(ring[i])] - p[0],
                 b = p[std::size_t(ring[(i + 1) % ring.size()])] - p[0];
    sum += a.cross(b);
  }
  return sum.norm() > 0 ? Vector(sum / sum.norm()) : sum;
}

// The point is moved to the origin after each round, so that small rings keep their digits.
template <class Refine, class Finish>
Limit limit_by_rounds(Patch patch, const Refine& refine, const Finish& finish, int rounds,
                      int rings, bool linear)
{
  Vector origin = Vector::Zero(), earlier = Vector::Zero();
  for (int k = 0;; ++k) {
    if (k == rounds - 10) earlier = polygon_normal(patch);
    const Vector p = patch.values.points[0];
    for (Vector& q : patch.values.points) q -= p;
    origin += p;
    if (k == rounds) break;
    patch = refined(patch, refine, finish, unsigned(k + 1), rings, linear);
  }
  const Vector normal = polygon_normal(patch);
  return {origin, patch.values.normals[0], normal, (normal - earlier).norm()};
}

} // namespace reference

#endif // CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_LIMIT_H

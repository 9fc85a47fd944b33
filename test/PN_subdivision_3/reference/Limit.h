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

#include <map>
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
  Real normal_change;  // of the surface normal in the last ten rounds
  Real normal_spread;  // the largest distance of it from the normal of a corner, see face_corners()
  Real earlier_spread; // half of the rounds before
  Real turn; // of the faces at the vertex, side by side: half a full turn on a smooth border
};

// The faces at vertex 0, as the corners there of triangles that their edges and diagonals make: the two
// sides. As the ring shrinks its shape tends to an affine image of that of the scheme's characteristic map.
inline std::vector<std::pair<Vector, Vector>> face_corners(const Patch& patch)
{
  const Face_list list = patch.face_list();
  const std::vector<int> ring = list.ring(0);
  std::vector<Vector> sides;
  const auto& p = patch.values.points;
  const auto add = [&](int w) { sides.push_back(p[std::size_t(w)] - p[0]); };
  for (const int w : ring) {
    add(w);
    if (w == ring.back() && list.is_border(0)) break;
    const int diagonal = list.after(0, w); // of a triangle the next neighbor
    if (std::find(ring.begin(), ring.end(), diagonal) == ring.end()) add(diagonal);
  }
  if (!list.is_border(0)) add(ring.front());
  std::vector<std::pair<Vector, Vector>> corners;
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) corners.emplace_back(sides[i], sides[i + 1]);
  return corners;
}

inline Vector unit(const Vector& v)
{
  return v.norm() > 0 ? Vector(v / v.norm()) : v;
}

inline Vector polygon_normal(const Patch& patch)
{
  Vector sum = Vector::Zero();
  for (const auto& [a, b] : face_corners(patch)) sum += a.cross(b);
  return unit(sum);
}

inline Real normal_spread(const Patch& patch)
{
  const Vector normal = polygon_normal(patch);
  Real spread = 0;
  for (const auto& [a, b] : face_corners(patch)) {
    const Real distance = (unit(a.cross(b)) - normal).norm();
    spread = (std::max)(spread, distance);
  }
  return spread;
}

// The point is moved to the origin after each round, so that small rings keep their digits.
template <class Refine, class Finish>
Limit limit_by_rounds(Patch patch, const Refine& refine, const Finish& finish, int rounds,
                      int rings, bool linear)
{
  Vector origin = Vector::Zero(), earlier = Vector::Zero();
  Real earlier_spread = 0;
  for (int k = 0;; ++k) {
    if (k == rounds - 10) earlier = polygon_normal(patch);
    if (k == rounds / 2) earlier_spread = normal_spread(patch);
    const Vector p = patch.values.points[0];
    for (Vector& q : patch.values.points) q -= p;
    origin += p;
    if (k == rounds) break;
    patch = refined(patch, refine, finish, unsigned(k + 1), rings, linear);
  }
  const Vector normal = polygon_normal(patch);
  Real turn = 0;
  for (const auto& [a, b] : face_corners(patch)) turn += std::atan2(a.cross(b).norm(), a.dot(b));
  return {origin,
          patch.values.normals[0],
          normal,
          (normal - earlier).norm(),
          normal_spread(patch),
          earlier_spread,
          turn};
}

} // namespace reference

#endif // CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_LIMIT_H

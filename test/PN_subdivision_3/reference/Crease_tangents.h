// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The tangents of the creases of a control mesh, from its points and given normals.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_CREASE_TANGENTS_H
#define CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_CREASE_TANGENTS_H

#include "Crease_rule.h"
#include "Creases.h"

namespace reference {

class Crease_tangents
{
public:
  // zero normals of corners are not given
  explicit Crease_tangents(const Creased_mesh& mesh)
    : mesh_(mesh)
  {
    const int n = mesh.mesh.number_of_vertices();
    for (int v = 0; v < n; ++v)
      if (is_crease_vertex(mesh, v)) make_on_crease(v);
    const std::map<Edge, Vector> on_creases = tangents_;
    for (int v = 0; v < n; ++v)
      if (!is_crease_vertex(mesh, v))
        for (const int a : sharp_neighbors(mesh, v)) make_end(v, a, on_creases);
    if (!mesh.has_fixed_border) return;
    for (auto& [ends, t] : tangents_)
      if (mesh.mesh.is_border(ends.first, ends.second)) t = Vector::Zero();
  }

  const Vector& at(int v, int a) const { return tangents_.at({v, a}); }

private:
  static Vector unit(const Vector& x) { return x.norm() == 0 ? x : Vector(x / x.norm()); }

  void make_on_crease(int v)
  {
    const std::vector<int> ends = sharp_neighbors(mesh_, v);
    const Vector y = mesh_.point(ends[0]) - mesh_.point(v),
                 x = mesh_.point(ends[1]) - mesh_.point(v);
    // the tangent at v of the circle through all three: the chords' directions, each weighted by the
    // other one's length
    Vector t0 = Vector::Zero();
    if (x.norm() == 0 || y.norm() == 0)
      t0 = x.norm() == 0 ? Vector(-unit(y)) : unit(x);
    else
      t0 = (y.norm() * unit(x) - x.norm() * unit(y)) / (x.norm() + y.norm());
    const Vector t = made_certain(t0, v, ends[1]);
    tangents_[{v, ends[1]}] = t;
    tangents_[{v, ends[0]}] = -t;
  }

  void make_end(int v, int a, const std::map<Edge, Vector>& on_creases)
  {
    const Vector u = unit(mesh_.point(a) - mesh_.point(v));
    const auto it = on_creases.find({a, v});
    Vector t0 = u;
    if (it != on_creases.end() && it->second.norm() != 0) {
      // the other end's tangent, mirrored in the plane between the ends
      const Vector s = -it->second;
      t0 = 2 * s.dot(u) * u - s + (1 - s.norm()) * u;
    }
    tangents_[{v, a}] = u.norm() == 0 ? u : made_certain(t0, v, a);
  }

  // without its part in the plane of the normals beside the edge va, at v
  Vector made_certain(const Vector& t0, int v, int a) const
  {
    std::vector<Vector> given;
    for (const int f : {mesh_.mesh.face(v, a), mesh_.mesh.face(a, v)})
      if (f >= 0 && mesh_.normal({f, v}).norm() != 0) given.push_back(mesh_.normal({f, v}));
    Vector t = t0;
    if (!given.empty()) {
      const Vector &m = given.front(), &n = given.back();
      const Vector sum = unit(m + n), difference = unit(m - n);
      t -= smooth_step(64 * (1 + m.dot(n))) * t0.dot(sum) * sum;
      t -= smooth_step(64 * (1 - m.dot(n))) * t0.dot(difference) * difference;
    }
    const Real least = 4096 * Real(std::numeric_limits<double>::epsilon());
    if (t0.norm() <= least || t.norm() <= least * t0.norm()) return Vector::Zero();
    const Real length = smooth_step(8 * t0.norm()) * smooth_step(2 * t.norm() / t0.norm());
    return length < Real(1e-6) ? Vector(Vector::Zero()) : Vector(length * unit(t));
  }

  const Creased_mesh& mesh_;
  std::map<Edge, Vector> tangents_;
};

} // namespace reference

#endif // CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_CREASE_TANGENTS_H

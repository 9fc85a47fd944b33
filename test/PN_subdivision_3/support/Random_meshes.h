// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
// Control meshes, spheres, cylinders and similarities made from a random generator.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_RANDOM_MESHES_H
#define CGAL_PN_SUBDIVISION_3_TEST_RANDOM_MESHES_H

#include "Test_meshes.h"
#include "reference/PN_rule.h"

namespace random_meshes {

using namespace test_meshes;
using reference::Real;
using Vector = reference::Vector;

// The same numbers with every standard library, other than std::uniform_real_distribution.
inline double between(std::mt19937& generator, double least, double greatest)
{
  return least + (greatest - least) * (double(generator() >> 8) / double(1 << 24));
}
inline int between(std::mt19937& generator, int least, int greatest)
{
  return least + int(generator() % unsigned(greatest - least + 1));
}

inline Triple random_direction(std::mt19937& generator)
{
  for (;;) {
    const Triple v{between(generator, -1., 1.), between(generator, -1., 1.),
                   between(generator, -1., 1.)};
    const double l = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    if (l > 0.01 && l < 1) return unit(v);
  }
}

// --- meshes ---

enum class Kind { triangles, quads, polygons };

inline Control_mesh random_grid(Cells cells, std::mt19937& generator)
{
  const bool is_tube = generator() % 2 == 0, is_torus = is_tube && generator() % 2 == 0;
  const int nx = between(generator, is_tube ? 3 : 1, 6),
            ny = between(generator, is_torus ? 3 : 1, 5);
  return grid(nx, ny, is_tube, is_torus, cells);
}

inline Control_mesh random_component(Kind kind, std::mt19937& generator)
{
  const int n = between(generator, 3, 14);
  const unsigned shape = generator() % 4;
  if (kind == Kind::triangles) {
    if (shape == 0) return random_grid(Cells::triangles, generator);
    if (shape == 1) return star(n, between(generator, 1, 2), Cells::triangles);
    if (shape == 2) return with_centers(bipyramid(n), generator() % 3 + 1);
    return bipyramid(n);
  }
  if (kind == Kind::quads) {
    if (shape < 2) return random_grid(Cells::quads, generator);
    if (shape == 2) return star(n, between(generator, 1, 2), Cells::quads);
    return in_quads(bipyramid((std::min)(n, 7)));
  }
  if (shape == 0) return house(n);
  if (shape == 1) return single_polygon(n);
  if (shape == 2) return random_grid(Cells::mixed, generator);
  return random_component(generator() % 2 == 0 ? Kind::triangles : Kind::quads, generator);
}

inline Control_mesh random_mesh(Kind kind, std::mt19937& generator)
{
  Control_mesh mesh = random_component(kind, generator);
  if (generator() % 3 == 0) mesh = part_of(mesh, unsigned(generator()));
  if (generator() % 4 == 0) mesh = united(mesh, random_component(kind, generator));
  if (generator() % 5 == 0) mesh = with_isolated_vertices(mesh);
  for (Triple& p : mesh.points)
    for (double& x : p) x += between(generator, -0.15, 0.15);
  set_uneven_normals(mesh, unsigned(generator()));
  return mesh;
}

// --- shapes that are kept ---

inline reference::Square random_rotation(std::mt19937& generator)
{
  const Triple a = random_direction(generator), b = random_direction(generator);
  const Vector u = Vector(a[0], a[1], a[2]).normalized();
  const Vector v = u.cross(Vector(b[0], b[1], b[2])).normalized();
  reference::Square rotation;
  rotation << u, v, u.cross(v);
  return rotation;
}

// A sphere or a cylinder about the third axis of a frame. Meshes are moved onto the part of it whose normals are
// within 50 degrees of the first axis, where no rule fades or is ill conditioned.
class Shape
{
public:
  Shape(bool is_cylinder, std::mt19937& generator)
    : is_cylinder_(is_cylinder)
    , radius_(between(generator, 0.5, 4.))
    , center_(between(generator, -2., 2.), between(generator, -2., 2.), between(generator, -2., 2.))
    , frame_(random_rotation(generator))
  {}

  Control_mesh moved_to(Control_mesh mesh) const
  {
    double size = 0;
    for (const Triple& p : mesh.points)
      for (double x : p) size = (std::max)(size, std::abs(x));
    mesh.normals.clear();
    for (Triple& p : mesh.points) {
      const Real turn = Real(0.8) * p[0] / size, along = Real(0.6) * p[1] / size;
      const Vector outward = is_cylinder_
                               ? Vector(std::cos(turn), std::sin(turn), 0)
                               : Vector(std::cos(turn) * std::cos(along),
                                        std::sin(turn) * std::cos(along), std::sin(along));
      const Vector n = frame_ * outward;
      const Vector q = center_ + radius_ * n +
                       (is_cylinder_ ? Vector(2 * along * frame_.col(2)) : Vector(Vector::Zero()));
      p = {double(q[0]), double(q[1]), double(q[2])};
      mesh.normals.push_back({double(n[0]), double(n[1]), double(n[2])});
    }
    return mesh;
  }

  // of a point in units of the radius, and of a normal
  std::pair<double, double> deviation(const Vector& p, const Vector& n) const
  {
    Vector r = p - center_;
    if (is_cylinder_) r -= r.dot(frame_.col(2)) * frame_.col(2);
    return {double(std::abs(r.norm() / radius_ - 1)), double((r / r.norm() - n).norm())};
  }

private:
  bool is_cylinder_;
  Real radius_;
  Vector center_;
  reference::Square frame_;
};

// --- similarities ---

class Similarity
{
public:
  explicit Similarity(std::mt19937& generator)
    : rotation_(random_rotation(generator))
    , scale_(between(generator, 0.3, 5.))
    , shift_(between(generator, -3., 3.), between(generator, -3., 3.), between(generator, -3., 3.))
  {}
  Vector point(const Vector& p) const { return scale_ * (rotation_ * p) + shift_; }
  Vector normal(const Vector& n) const { return rotation_ * n; }
  Control_mesh moved(Control_mesh mesh) const
  {
    const auto triple = [](const Vector& v) {
      return Triple{double(v[0]), double(v[1]), double(v[2])};
    };
    for (Triple& p : mesh.points) p = triple(point({p[0], p[1], p[2]}));
    for (Triple& n : mesh.normals) n = triple(normal({n[0], n[1], n[2]}));
    return mesh;
  }

private:
  reference::Square rotation_;
  Real scale_;
  Vector shift_;
};

} // namespace random_meshes

#endif // CGAL_PN_SUBDIVISION_3_TEST_RANDOM_MESHES_H

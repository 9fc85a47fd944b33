// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Coarse parts of planes, cylinders and spheres, unevenly sampled and moved to a general position,
// with the distance of points and normals to their surfaces.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_CREASE_SHAPES_H
#define CGAL_PN_SUBDIVISION_3_TEST_CREASE_SHAPES_H

#include "Crease_levels.h"

#include <Eigen/Dense>

#include <cmath>
#include <limits>

namespace crease_shapes {

using crease_levels::Border;
using crease_levels::Control;
using crease_levels::Crease_run;
using crease_levels::Edge;
using crease_levels::Face;
using crease_levels::Index;
using crease_levels::Level_connectivity;
using crease_levels::triangulated;
using crease_levels::Triple;
using crease_levels::undirected;

using Real = long double;
using Vector = Eigen::Matrix<Real, 3, 1>;
using Ring = std::vector<int>;

const Real pi = std::acos(Real(-1));
constexpr double infinity = std::numeric_limits<double>::infinity();

inline Triple triple(const Vector& v)
{
  return {double(v[0]), double(v[1]), double(v[2])};
}
inline Vector vector(const Triple& x)
{
  return {Real(x[0]), Real(x[1]), Real(x[2])};
}

struct Surface
{
  enum Kind { plane, cylinder, sphere } kind;
  Vector point, direction; // direction: of a plane's normal or a cylinder's axis
  Real radius;
  Real sign = 1; // -1: the normals point inwards

  Vector normal(const Vector& p) const
  {
    if (kind == plane) return direction;
    Vector r = p - point;
    if (kind == cylinder) r -= r.dot(direction) * direction;
    return sign * r / r.norm();
  }
  Real distance(const Vector& p) const
  {
    Vector r = p - point;
    if (kind == plane) return std::abs(r.dot(direction));
    if (kind == cylinder) r -= r.dot(direction) * direction;
    return std::abs(r.norm() - radius);
  }
};

// Faces with their surfaces. Edges between faces of different surfaces are creases.
class Part
{
public:
  Border border = Border::surface;
  std::vector<Surface> surfaces;  // of the groups
  std::vector<Surface> of_border; // all border vertices lie on one of them
  std::vector<std::size_t> group; // of the faces
  std::vector<Face> faces;
  std::vector<Vector> points;
  std::map<int, double> sharp_vertices;

  std::size_t add(const Surface& s)
  {
    surfaces.push_back(s);
    return surfaces.size() - 1;
  }
  int vertex(const Vector& p)
  {
    points.push_back(p);
    return int(points.size()) - 1;
  }
  Ring ring(Real radius, Real z, const std::vector<Real>& angles)
  {
    Ring r;
    for (const Real a : angles)
      r.push_back(vertex({radius * std::cos(a), radius * std::sin(a), z}));
    return r;
  }
  // turned so that it looks along the normal of its surface
  void face(std::size_t surface, Face f)
  {
    Vector area = Vector::Zero(), mean = Vector::Zero();
    for (std::size_t i = 0; i < f.size(); ++i) {
      area += points[std::size_t(f[i])].cross(points[std::size_t(f[(i + 1) % f.size()])]);
      mean += points[std::size_t(f[i])] / Real(f.size());
    }
    if (area.dot(surfaces[surface].normal(mean)) < 0) std::reverse(f.begin(), f.end());
    faces.push_back(f);
    group.push_back(surface);
  }
  void tube(std::size_t surface, const Ring& a, const Ring& b, bool is_closed = true)
  {
    for (std::size_t i = 0; i + (is_closed ? 0 : 1) < a.size(); ++i) {
      const std::size_t j = (i + 1) % a.size();
      face(surface, {a[i], a[j], b[j], b[i]});
    }
  }
  // a rotation and a move
  void place(const Eigen::Quaternion<Real>& rotation, const Vector& by)
  {
    const auto move = [&](Surface& s) {
      s.point = rotation * s.point + by;
      s.direction = rotation * s.direction;
    };
    for (Vector& p : points) p = rotation * p + by;
    for (Surface& s : surfaces) move(s);
    for (Surface& s : of_border) move(s);
  }
  void place()
  {
    place(Eigen::Quaternion<Real>(Real(0.62), Real(-0.31), Real(0.47), Real(0.55)).normalized(),
          {Real(0.3), Real(-0.2), Real(0.25)});
  }

  Control control(bool with_normals = true) const
  {
    Control c;
    c.border = border;
    c.faces = faces;
    c.sharp_vertices = sharp_vertices;
    for (const Vector& p : points) c.points.push_back({double(p[0]), double(p[1]), double(p[2])});
    std::map<Edge, std::size_t> group_of_side;
    for (std::size_t f = 0; f < faces.size(); ++f)
      for (std::size_t i = 0; i < faces[f].size(); ++i) {
        const int v = faces[f][i];
        group_of_side[{v, faces[f][(i + 1) % faces[f].size()]}] = group[f];
        const Vector n = surfaces[group[f]].normal(points[std::size_t(v)]);
        if (with_normals) c.normals[{int(f), v}] = {double(n[0]), double(n[1]), double(n[2])};
      }
    for (const auto& [side, g] : group_of_side) {
      const auto it = group_of_side.find({side.second, side.first});
      if (it != group_of_side.end() && it->second != g)
        c.sharp_edges[crease_levels::undirected(side.first, side.second)] = infinity;
    }
    return c;
  }

  // the greatest coordinate, but at least the size
  Real scale() const
  {
    Real greatest = 0;
    for (const Vector& p : points) {
      greatest = (std::max)(greatest, p.cwiseAbs().maxCoeff());
      for (const Vector& q : points) greatest = (std::max)(greatest, (p - q).norm());
    }
    return greatest;
  }
};

inline Surface plane(Real z, Real up)
{
  return {Surface::plane, {0, 0, z}, {0, 0, up}, 0};
}
inline Surface upright_cylinder(Real radius, Real sign = 1)
{
  return {Surface::cylinder, {0, 0, 0}, {0, 0, 1}, radius, sign};
}
inline Surface sphere(Real z, Real radius, Real sign = 1)
{
  return {Surface::sphere, {0, 0, z}, {0, 0, 1}, radius, sign};
}

// n angles, the steps between them up to twice as large as others
inline std::vector<Real> uneven(int n)
{
  std::vector<Real> angles;
  Real sum = 0;
  for (int k = 0; k < n; ++k) sum += 3 + std::sin(Real(5 * k + 1));
  Real a = Real(0.1);
  for (int k = 0; k < n; ++k) {
    angles.push_back(a);
    a += 2 * pi * (3 + std::sin(Real(5 * k + 1))) / sum;
  }
  return angles;
}

inline Part capped_cylinder(const std::vector<Real>& angles)
{
  Part p;
  const auto side = p.add(upright_cylinder(1)), bottom = p.add(plane(0, -1)),
             top = p.add(plane(2, 1));
  const Ring a = p.ring(1, 0, angles), b = p.ring(1, Real(0.8), angles), c = p.ring(1, 2, angles);
  p.tube(side, a, b);
  p.tube(side, b, c);
  p.face(bottom, a);
  p.face(top, c);
  return p;
}

// rings of a sphere at these latitudes, from the given one on; the last one is closed by a polygon
inline void dome(Part& p, std::size_t surface, Ring rim, const std::vector<Real>& latitudes,
                 const std::vector<Real>& angles)
{
  const Surface s = p.surfaces[surface];
  for (const Real latitude : latitudes) {
    const Ring next =
      p.ring(s.radius * std::cos(latitude), s.point[2] + s.radius * std::sin(latitude), angles);
    p.tube(surface, rim, next);
    rim = next;
  }
  p.face(surface, rim);
}

inline Part half_ball()
{
  Part p;
  const auto angles = uneven(7);
  const auto ball = p.add(sphere(0, 1)), base = p.add(plane(0, -1));
  const Ring rim = p.ring(1, 0, angles);
  dome(p, ball, rim, {Real(0.55), Real(1.15)}, angles);
  p.face(base, rim);
  return p;
}

inline Part lens()
{
  Part p;
  const auto angles = uneven(8);
  const Real slope = Real(0.6), other = Real(1.05);
  const Ring rim = p.ring(1, 0, angles);
  const auto front = p.add(sphere(-std::tan(slope), 1 / std::cos(slope)));
  const auto back = p.add(sphere(std::tan(other), 1 / std::cos(other)));
  dome(p, front, rim, {slope + Real(0.4), slope + Real(0.7)}, angles);
  dome(p, back, rim, {-other - Real(0.2), -other - Real(0.35)}, angles);
  return p;
}

// a cylinder with a tangent half ball
inline Part bullet()
{
  Part p;
  const auto angles = uneven(8);
  const auto side = p.add(upright_cylinder(1)), ball = p.add(sphere(Real(1.2), 1)),
             base = p.add(plane(0, -1));
  const Ring a = p.ring(1, 0, angles), b = p.ring(1, Real(1.2), angles);
  p.tube(side, a, b);
  p.face(base, a);
  dome(p, ball, b, {Real(0.5), Real(1.1)}, angles);
  return p;
}

inline Part washer()
{
  Part p;
  const auto angles = uneven(8);
  const Ring a = p.ring(1, 0, angles), b = p.ring(2, 0, angles), c = p.ring(2, Real(0.4), angles),
             d = p.ring(1, Real(0.4), angles);
  p.tube(p.add(plane(0, -1)), a, b);
  p.tube(p.add(upright_cylinder(2)), b, c);
  p.tube(p.add(plane(Real(0.4), 1)), c, d);
  p.tube(p.add(upright_cylinder(1, -1)), d, a);
  return p;
}

// a hole that opens as a sphere
inline Part countersink()
{
  Part p;
  const auto angles = uneven(9);
  const Real depth = std::sqrt(Real(0.75));
  const Ring a = p.ring(Real(0.5), -2, angles), b = p.ring(Real(0.5), -depth, angles),
             middle = p.ring(std::cos(Real(-0.5)), std::sin(Real(-0.5)), angles),
             c = p.ring(1, 0, angles), d = p.ring(2, 0, angles), e = p.ring(2, -2, angles);
  p.tube(p.add(upright_cylinder(Real(0.5), -1)), a, b);
  const auto seat = p.add(sphere(0, 1, -1));
  p.tube(seat, b, middle);
  p.tube(seat, middle, c);
  p.tube(p.add(plane(0, 1)), c, d);
  p.tube(p.add(upright_cylinder(2)), d, e);
  p.tube(p.add(plane(-2, -1)), e, a);
  return p;
}

inline Part d_section()
{
  Part p;
  std::vector<Real> arc;
  for (const int degrees : {-130, -85, -30, 20, 85, 130}) arc.push_back(Real(degrees) * pi / 180);
  const auto shaft = p.add(upright_cylinder(1));
  const Real x = std::cos(arc.front());
  const auto flat = p.add({Surface::plane, {x, 0, 0}, {-1, 0, 0}, 0});
  std::vector<Ring> rings;
  for (const Real z : {Real(0), Real(1), Real(2.5)}) {
    rings.push_back(p.ring(1, z, arc));
    rings.back().push_back(p.vertex({x, Real(0.1), z}));
  }
  for (std::size_t k = 0; k < 2; ++k)
    for (std::size_t i = 0; i < 7; ++i) {
      const std::size_t j = (i + 1) % 7;
      p.face(i < 5 ? shaft : flat, {rings[k][i], rings[k][j], rings[k + 1][j], rings[k + 1][i]});
    }
  p.face(p.add(plane(0, -1)), rings[0]);
  p.face(p.add(plane(Real(2.5), 1)), rings[2]);
  return p;
}

// a box with rounded upright edges: planes tangent to cylinders
inline Part rounded_box()
{
  Part p;
  const Real half = 1, radius = Real(0.5);
  Ring low, middle, high;
  std::vector<std::size_t> side;
  for (int corner = 0; corner < 4; ++corner) {
    const Real start = Real(corner) * pi / 2;
    const Vector center((half - radius) * (corner == 0 || corner == 3 ? 1 : -1),
                        (half - radius) * (corner < 2 ? 1 : -1), 0);
    const auto round = p.add({Surface::cylinder, center, {0, 0, 1}, radius});
    const Vector out(std::cos(start + pi / 2), std::sin(start + pi / 2), 0);
    const auto flat = p.add({Surface::plane, Vector(out * half), out, 0});
    for (const Real a : {Real(0), Real(0.6), pi / 2}) {
      const Vector q = center + radius * Vector(std::cos(start + a), std::sin(start + a), 0);
      low.push_back(p.vertex(q));
      middle.push_back(p.vertex(q + Vector(0, 0, Real(0.7))));
      high.push_back(p.vertex(q + Vector(0, 0, 2)));
      side.push_back(a > 1 ? flat : round);
    }
  }
  for (std::size_t i = 0; i < low.size(); ++i) {
    const std::size_t j = (i + 1) % low.size();
    p.face(side[i], {low[i], low[j], middle[j], middle[i]});
    p.face(side[i], {middle[i], middle[j], high[j], high[i]});
  }
  p.face(p.add(plane(0, -1)), low);
  p.face(p.add(plane(2, 1)), high);
  return p;
}

// a hexagonal head, a shank and a round end
inline Part bolt()
{
  Part p;
  std::vector<Real> six, twelve;
  for (int k = 0; k < 6; ++k) six.push_back(Real(k) * pi / 3);
  const auto angles = uneven(12);
  Ring low, high;
  for (int k = 0; k < 6; ++k)
    for (const Real share : {Real(0), Real(0.45)}) {
      const Vector a(2 * std::cos(six[std::size_t(k)]), 2 * std::sin(six[std::size_t(k)]), 0);
      const Real next = Real(k + 1) * pi / 3;
      const Vector b(2 * std::cos(next), 2 * std::sin(next), 0);
      low.push_back(p.vertex((1 - share) * a + share * b));
      high.push_back(p.vertex((1 - share) * a + share * b + Vector(0, 0, 1)));
    }
  for (std::size_t k = 0; k < 6; ++k) {
    const Real middle = (Real(k) + Real(0.5)) * pi / 3;
    const Vector out(std::cos(middle), std::sin(middle), 0);
    const auto wall = p.add({Surface::plane, Vector(out * 2 * std::cos(pi / 6)), out, 0});
    for (std::size_t i = 2 * k; i < 2 * k + 2; ++i) {
      const std::size_t j = (i + 1) % 12;
      p.face(wall, {low[i], low[j], high[j], high[i]});
    }
  }
  p.face(p.add(plane(0, -1)), low);
  const Real r = Real(1.2);
  const Ring a = p.ring(r, 1, angles), b = p.ring(r, Real(1.7), angles),
             c = p.ring(r, Real(2.4), angles);
  p.tube(p.add(plane(1, 1)), high, a);
  const auto shank = p.add(upright_cylinder(r));
  p.tube(shank, a, b);
  p.tube(shank, b, c);
  dome(p, p.add(sphere(Real(2.4), r)), c, {Real(0.5), Real(1)}, angles);
  return p;
}

inline Part cube()
{
  Part p;
  Ring r;
  for (int k = 0; k < 8; ++k)
    r.push_back(p.vertex({Real(k & 1), Real((k >> 1) & 1), Real(k >> 2)}));
  for (int axis = 0; axis < 3; ++axis)
    for (int side = 0; side < 2; ++side) {
      Vector out = Vector::Zero();
      out[axis] = side == 0 ? -1 : 1;
      const auto s = p.add({Surface::plane, side == 0 ? Vector(Vector::Zero()) : out, out, 0});
      const int u = 1 << ((axis + 1) % 3), v = 1 << ((axis + 2) % 3), o = side << axis;
      p.face(s, {r[std::size_t(o)], r[std::size_t(o + u)], r[std::size_t(o + u + v)],
                 r[std::size_t(o + v)]});
    }
  return p;
}

// open: a round plate with a round hole
inline Part plate_with_hole()
{
  Part p;
  const auto angles = uneven(9);
  const Ring a = p.ring(1, 0, angles), b = p.ring(2, 0, angles), c = p.ring(3, 0, angles);
  const auto s = p.add(plane(0, 1));
  p.tube(s, a, b);
  p.tube(s, b, c);
  p.border = Border::curve;
  p.of_border = {upright_cylinder(1), upright_cylinder(3)};
  return p;
}

// open: half of a disk, with corners where its arc ends
inline Part half_disk()
{
  Part p;
  const std::vector<Real> angles{0, Real(0.5), Real(1.3), Real(1.8), Real(2.5), pi};
  const auto s = p.add(plane(0, 1));
  const Ring arc = p.ring(1, 0, angles), inner = p.ring(Real(0.5), 0, angles);
  p.tube(s, arc, inner, false);
  const int center = p.vertex({0, 0, 0});
  for (std::size_t i = 0; i + 1 < inner.size(); ++i) p.face(s, {center, inner[i], inner[i + 1]});
  p.border = Border::curve;
  p.sharp_vertices = {{arc.front(), infinity}, {arc.back(), infinity}};
  p.of_border = {upright_cylinder(1), {Surface::plane, {0, 0, 0}, {0, 1, 0}, 0}};
  return p;
}

inline Part ball_cap()
{
  Part p;
  const auto angles = uneven(8);
  const auto s = p.add(sphere(0, 1));
  dome(p, s, p.ring(std::cos(Real(0.3)), std::sin(Real(0.3)), angles), {Real(0.7), Real(1.1)},
       angles);
  p.border = Border::curve;
  p.of_border = {plane(std::sin(Real(0.3)), 1)};
  return p;
}

// an eighth of a sphere between three great circles
inline Part octant()
{
  Part p;
  const auto s = p.add(sphere(0, 1));
  const auto at = [&](Real x, Real y, Real z) { return p.vertex(Vector(x, y, z).normalized()); };
  const int a = at(1, 0, 0), b = at(0, 1, 0), c = at(0, 0, 1), ab = at(1, Real(0.8), 0),
            bc = at(0, 1, Real(0.9)), ca = at(Real(0.7), 0, 1), m = at(1, Real(0.9), Real(1.1));
  // triangles leave the corners a single face
  p.face(s, {ab, m, ca, a});
  p.face(s, {bc, m, ab, b});
  p.face(s, {ca, m, bc, c});
  p.border = Border::corners;
  for (const Vector& out : {Vector(1, 0, 0), Vector(0, 1, 0), Vector(0, 0, 1)})
    p.of_border.push_back({Surface::plane, {0, 0, 0}, out, 0});
  return p;
}

// \name Results
struct Slots
{
  std::vector<Vector> points, normals;

  bool operator==(const Slots& s) const { return points == s.points && normals == s.normals; }
};

template <class Scheme>
Slots slots(const Control& control, const Scheme& scheme, int rounds)
{
  crease_levels::Crease_run<double, Scheme> run(control, scheme);
  run.refine(rounds);
  Slots s;
  for (crease_levels::Index i = 0; i < run.number_of_slots(); ++i) {
    const auto p = run.point(i), n = run.normal(i);
    s.points.emplace_back(p[0], p[1], p[2]);
    s.normals.emplace_back(n[0], n[1], n[2]);
  }
  return s;
}

} // namespace crease_shapes

#endif // CGAL_PN_SUBDIVISION_3_TEST_CREASE_SHAPES_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_SUBDIVISION_3_BENCHMARK_BY_METHOD_PATCHES_H
#define CGAL_PN_SUBDIVISION_3_BENCHMARK_BY_METHOD_PATCHES_H

#include <CGAL/Simple_cartesian.h>

#include <array>
#include <cmath>
#include <cstddef>

// Other methods that make a curved patch of a triangle with points and unit normals at its corners. A patch is made
// of the corners and evaluated at barycentric coordinates. Written from the papers that are named.
namespace by_method {

using Vector = CGAL::Simple_cartesian<double>::Vector_3;

struct Corner
{
  Vector point, normal;
};
using Triangle = std::array<Corner, 3>;
using Barycentric = std::array<double, 3>;

inline double length(const Vector& v)
{
  return std::sqrt(v.squared_length());
}

// the triangle itself
class Flat
{
public:
  explicit Flat(const Triangle& t)
    : m_t(t)
  {}
  Vector operator()(const Barycentric& b) const
  {
    return b[0] * m_t[0].point + b[1] * m_t[1].point + b[2] * m_t[2].point;
  }

private:
  Triangle m_t;
};

// Vlachos, Peters, Boyd, Mitchell, Curved PN triangles, I3D 2001
class PN_triangle
{
public:
  explicit PN_triangle(const Triangle& t)
  {
    Vector edges(0, 0, 0), corners(0, 0, 0);
    for (std::size_t i = 0; i < 3; ++i) {
      const Corner &a = t[i], &b = t[(i + 1) % 3];
      m_corner[i] = a.point;
      m_first[i] = (2 * a.point + b.point - ((b.point - a.point) * a.normal) * a.normal) / 3;
      m_second[i] = (2 * b.point + a.point - ((a.point - b.point) * b.normal) * b.normal) / 3;
      edges = edges + (m_first[i] + m_second[i]) / 6;
      corners = corners + a.point / 3;
    }
    m_middle = edges + (edges - corners) / 2;
  }
  Vector operator()(const Barycentric& b) const
  {
    Vector p = 6 * b[0] * b[1] * b[2] * m_middle;
    for (std::size_t i = 0; i < 3; ++i) {
      const double x = b[i], y = b[(i + 1) % 3];
      p = p + x * x * x * m_corner[i] + 3 * x * y * (x * m_first[i] + y * m_second[i]);
    }
    return p;
  }

private:
  std::array<Vector, 3> m_corner, m_first,
    m_second; // the latter two along the edge from corner i to i + 1
  Vector m_middle;
};

// Boubekeur, Alexa, Phong tessellation, ACM Transactions on Graphics 27(5), 2008
class Phong_tessellation
{
public:
  Phong_tessellation(const Triangle& t, double shape)
    : m_t(t)
    , m_shape(shape)
  {}
  Vector operator()(const Barycentric& b) const
  {
    const Vector p = Flat(m_t)(b);
    Vector projected(0, 0, 0);
    for (std::size_t i = 0; i < 3; ++i)
      projected = projected + b[i] * (p - ((p - m_t[i].point) * m_t[i].normal) * m_t[i].normal);
    return (1 - m_shape) * p + m_shape * projected;
  }

private:
  Triangle m_t;
  double m_shape;
};

// Yang, Matrix weighted rational curves and surfaces, CAGD 42, 2016, of degree 1, with the weights I + n n^T: to second order
// the arcs of point-normal averages
class Matrix_weighted_patch
{
public:
  explicit Matrix_weighted_patch(const Triangle& t)
    : m_t(t)
  {}
  Vector operator()(const Barycentric& b) const
  {
    Vector x(1, 0, 0), y(0, 1, 0), z(0, 0, 1), right(0, 0, 0); // the rows of the sum of weights
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector& n = m_t[i].normal;
      x = x + b[i] * n.x() * n;
      y = y + b[i] * n.y() * n;
      z = z + b[i] * n.z() * n;
      right = right + b[i] * (m_t[i].point + (n * m_t[i].point) * n);
    }
    const Vector yz = CGAL::cross_product(y, z), zx = CGAL::cross_product(z, x),
                 xy = CGAL::cross_product(x, y);
    return (right.x() * yz + right.y() * zx + right.z() * xy) / (x * yz);
  }

private:
  Triangle m_t;
};

// Nagata, Simple local interpolation of surfaces using normal vectors, CAGD 22(4), 2005
class Nagata_patch
{
public:
  explicit Nagata_patch(const Triangle& t)
  {
    const Vector a = bend(t[0], t[1]), b = bend(t[1], t[2]), c = bend(t[0], t[2]);
    m_0 = t[0].point;
    m_x = t[1].point - t[0].point - a;
    m_y = t[2].point - t[1].point + a - c;
    m_xy = c - a - b;
    m_xx = a;
    m_yy = b;
  }
  Vector operator()(const Barycentric& b) const
  {
    const double x = 1 - b[0], y = b[2];
    return m_0 + x * m_x + y * m_y + x * y * m_xy + x * x * m_xx + y * y * m_yy;
  }

private:
  // the shortest quadratic term with which an edge is perpendicular to both normals
  static Vector bend(const Corner& a, const Corner& b)
  {
    const double c = a.normal * b.normal, s = 1 - c * c;
    if (s < 1e-12) return {0, 0, 0};
    const Vector d = b.point - a.point;
    const double x = a.normal * d, y = -(b.normal * d);
    return ((x - c * y) * a.normal + (y - c * x) * b.normal) / s;
  }
  Vector m_0, m_x, m_y, m_xy, m_xx, m_yy;
};

// Walton, Meek, A triangular G1 patch from boundary curves, Computer-Aided Design 28(2), 1996: quartic,
// with inner control points that depend on the parameters
class Walton_Meek_patch
{
public:
  explicit Walton_Meek_patch(const Triangle& t)
  {
    std::array<std::array<Vector, 4>, 3> cubic;
    for (std::size_t i = 0; i < 3; ++i) {
      cubic[i] = boundary(t[i], t[(i + 1) % 3]);
      m_edge[i] = {cubic[i][0], (cubic[i][0] + 3 * cubic[i][1]) / 4,
                   (cubic[i][1] + cubic[i][2]) / 2, (3 * cubic[i][2] + cubic[i][3]) / 4};
    }
    for (std::size_t i = 0; i < 3; ++i) set_inner(i, cubic[i], t);
  }

  Vector operator()(const Barycentric& b) const
  {
    const auto& [u, v, w] = b;
    Vector p = 12 * u * v * w *
               (u * blended(v, m_inner[0][0], w, m_inner[2][1]) +
                v * blended(w, m_inner[1][0], u, m_inner[0][1]) +
                w * blended(u, m_inner[2][0], v, m_inner[1][1]));
    for (std::size_t i = 0; i < 3; ++i) {
      const double x = b[i], y = b[(i + 1) % 3];
      p = p + x * x * x * x * m_edge[i][0] +
          x * y * (4 * x * x * m_edge[i][1] + 6 * x * y * m_edge[i][2] + 4 * y * y * m_edge[i][3]);
    }
    return p;
  }

private:
  static Vector blended(double x, const Vector& p, double y, const Vector& q)
  {
    return x + y > 0 ? (x * p + y * q) / (x + y) : (p + q) / 2;
  }

  static std::array<Vector, 4> boundary(const Corner& a, const Corner& b)
  {
    const Vector d = b.point - a.point;
    const double c = a.normal * b.normal, x = a.normal * d, y = b.normal * d;
    const double r = 6 * (2 * x + c * y) / (4 - c * c), s = 6 * (2 * y + c * x) / (4 - c * c);
    return {a.point, a.point + (6 * d - 2 * r * a.normal + s * b.normal) / 18,
            b.point - (6 * d + r * a.normal - 2 * s * b.normal) / 18, b.point};
  }

  void set_inner(std::size_t i, const std::array<Vector, 4>& cubic, const Triangle& t)
  {
    const std::size_t next = (i + 1) % 3, last = (i + 2) % 3;
    std::array<Vector, 3> w, a;
    for (std::size_t k = 0; k < 3; ++k) w[k] = cubic[k + 1] - cubic[k];
    a[0] = CGAL::cross_product(t[i].normal, w[0]) / length(w[0]);
    a[2] = CGAL::cross_product(t[next].normal, w[2]) / length(w[2]);
    a[1] = (a[0] + a[2]) / length(a[0] + a[2]);
    const std::array<Vector, 4>& l = m_edge[i];
    const Vector end = cubic[3];
    const Vector d0 = m_edge[last][3] - (l[0] + l[1]) / 2, d3 = m_edge[next][1] - (l[3] + end) / 2;
    const double lambda0 = d0 * w[0] / w[0].squared_length(),
                 lambda1 = d3 * w[2] / w[2].squared_length(), mu0 = d0 * a[0], mu1 = d3 * a[2];
    m_inner[i] = {(l[1] + l[2]) / 2 + (2 * lambda0 * w[1] + lambda1 * w[0]) / 3 +
                    (2 * mu0 * a[1] + mu1 * a[0]) / 3,
                  (l[2] + l[3]) / 2 + (lambda0 * w[2] + 2 * lambda1 * w[1]) / 3 +
                    (mu0 * a[2] + 2 * mu1 * a[1]) / 3};
  }

  std::array<std::array<Vector, 4>, 3> m_edge; // of degree 4, without the last one
  std::array<std::array<Vector, 2>, 3>
    m_inner; // that edge i asks for, at its first and second corner
};

} // namespace by_method

#endif // CGAL_PN_SUBDIVISION_3_BENCHMARK_BY_METHOD_PATCHES_H

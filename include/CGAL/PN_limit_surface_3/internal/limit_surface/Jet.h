// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_SURFACE_JET_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_SURFACE_JET_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/average/input_checks.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL::PN_subdivision_3::internal {

// A function of two parameters with its derivatives up to the second ones.
struct Jet
{
  double value = 0, u = 0, v = 0, uu = 0, uv = 0, vv = 0;

  static Jet of_u(double u) { return {u, 1, 0, 0, 0, 0}; }
  static Jet of_v(double v) { return {v, 0, 1, 0, 0, 0}; }

  Jet& operator+=(const Jet& b)
  {
    value += b.value, u += b.u, v += b.v, uu += b.uu, uv += b.uv, vv += b.vv;
    return *this;
  }
  friend Jet operator+(Jet a, const Jet& b) { return a += b; }
  friend Jet operator+(Jet a, double b)
  {
    a.value += b;
    return a;
  }
  friend Jet operator*(const Jet& a, double b)
  {
    return {a.value * b, a.u * b, a.v * b, a.uu * b, a.uv * b, a.vv * b};
  }
  friend Jet operator-(const Jet& a, const Jet& b) { return a + b * -1; }
  friend Jet operator*(const Jet& a, const Jet& b)
  {
    return {a.value * b.value,
            a.u * b.value + a.value * b.u,
            a.v * b.value + a.value * b.v,
            a.uu * b.value + 2 * a.u * b.u + a.value * b.uu,
            a.uv * b.value + a.u * b.v + a.v * b.u + a.value * b.uv,
            a.vv * b.value + 2 * a.v * b.v + a.value * b.vv};
  }
  // the jet of f(x); given are the value of f and its first two derivatives
  Jet mapped(double f, double f1, double f2) const
  {
    return {f, f1 * u, f1 * v, f1 * uu + f2 * u * u, f1 * uv + f2 * u * v, f1 * vv + f2 * v * v};
  }
  Jet inverse() const
  {
    const double r = 1 / value;
    return mapped(r, -r * r, 2 * r * r * r);
  }
  Jet inverse_root() const
  {
    const double r = 1 / std::sqrt(value), cube = r * r * r;
    return mapped(r, -0.5 * cube, 0.75 * cube * r * r);
  }
};

using Jet_vector = std::array<Jet, 3>;

template <class A, class B>
Jet jet_product(const A& a, const B& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Where the quadratic function of steps with these derivatives, nowhere concave, is least in the square or triangle: inside, or on a side.
inline std::array<double, 2> least_place(const Jet& g, bool is_triangle, double u, double v)
{
  using Place = std::array<double, 2>;
  if (const double det = g.uu * g.vv - g.uv * g.uv; det > 0) {
    const Place s = {u + (g.uv * g.v - g.vv * g.u) / det, v + (g.uv * g.u - g.uu * g.v) / det};
    if (s[0] >= 0 && s[1] >= 0 && (is_triangle ? s[0] + s[1] <= 1 : s[0] <= 1 && s[1] <= 1))
      return s;
  }
  const Place corners[] = {{0, 0}, {1, 0}, {is_triangle ? 0. : 1., 1}, {0, 1}};
  Place best = {u, v};
  double least = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const Place &p = corners[k], &q = corners[(k + 1) % 4];
    const auto slope = [&](double x, double y, double dx, double dy) {
      return (g.u + g.uu * x + g.uv * y) * dx + (g.v + g.uv * x + g.vv * y) * dy;
    };
    const double dx = q[0] - p[0], dy = q[1] - p[1], start = slope(p[0] - u, p[1] - v, dx, dy),
                 bend = slope(q[0] - u, q[1] - v, dx, dy) - start,
                 t = bend > 0 ? (std::min)(1., (std::max)(0., -start / bend)) : start < 0;
    const Place s = {p[0] + t * dx, p[1] + t * dy};
    const double x = s[0] - u, y = s[1] - v, value = (g.u * x + g.v * y + slope(x, y, x, y)) / 2;
    if (value < least) least = value, best = s;
  }
  return best;
}

// Where Newton's method for the half square of the length of r goes.
inline std::array<double, 2> next_foot(const Jet_vector& r, bool is_triangle, double u, double v)
{
  Jet f = jet_product(r, r) * 0.5;
  double a = 0, b = 0, c = 0;
  for (const Jet& x : r) a += x.u * x.u, b += x.u * x.v, c += x.v * x.v;
  if (!(f.uu > 0 && f.uu * f.vv - f.uv * f.uv > 1e-3 * a * c)) f.uu = a, f.uv = b, f.vv = c;
  return least_place(f, is_triangle, u, v);
}

// What is averaged.
struct Jet_entry
{
  Jet weight{};
  std::array<double, 3> point{}, normal{};
  double roundness = 1;
};

// The rule of PN_average, with weights that are jets: of entries with a weight and a value, and of one where is_pn is false
// the linear rule. Normals that vanish leave the linear point.
struct Jet_average
{
  Jet_vector point{}, normal{};

  // about the point of the first entry, so that differences keep their digits
  template <class Entries>
  Jet_average(Entries entries, bool is_pn)
  {
    const std::array<double, 3> origin = entries[0].point;
    for (auto& e : entries)
      for (std::size_t c = 0; c < 3; ++c) e.point[c] -= origin[c];
    evaluate(entries, is_pn);
    for (std::size_t c = 0; c < 3; ++c) point[c].value += origin[c];
  }

  // the normal of the surface that the jet describes, or else of the average
  std::array<double, 3> unit_normal() const
  {
    std::array<double, 3> u{point[0].u, point[1].u, point[2].u},
      v{point[0].v, point[1].v, point[2].v}, n{};
    if (scale_to_about_one<double, 3>(u) && scale_to_about_one<double, 3>(v)) n = cross(u, v);
    const double square = dot(n, n);
    if (!(square > 1e-18 * dot(u, u) * dot(v, v)))
      return {normal[0].value, normal[1].value, normal[2].value};
    divide_by_length<double, 3>(n, square);
    return n;
  }

private:
  template <class Entries>
  void evaluate(const Entries& entries, bool is_pn)
  {
    for (const auto& e : entries)
      for (std::size_t c = 0; c < 3; ++c) {
        point[c] += e.weight * e.point[c];
        if (is_pn) normal[c] += e.weight * e.normal[c];
      }
    const Jet square = jet_product(normal, normal);
    if (!is_pn || !(square.value > least_square)) {
      normal = {};
      return;
    }
    const Jet factor = square.inverse_root();
    for (Jet& n : normal) n = n * factor;
    const Jet height = this->height(entries);
    for (std::size_t c = 0; c < 3; ++c) point[c] += height * normal[c];
  }

  static constexpr double least_square = 0x1p-60;

  template <class Entries>
  Jet height(const Entries& entries) const
  {
    Jet sum, roundness, remaining;
    bool fades = false;
    for (const auto& e : entries) {
      Jet s, d;
      for (std::size_t c = 0; c < 3; ++c) {
        const Jet m = normal[c] + e.normal[c];
        s += m * ((point[c] + -e.point[c]) * -1);
        d += m * normal[c];
      }
      Jet weight = e.weight;
      if (d.value < fade_begin<double>()) {
        fades = true;
        if (d.value <= fade_end<double>())
          weight = {};
        else
          weight = weight * faded(d);
      }
      remaining += weight;
      if (weight.value != 0 || d.value > fade_end<double>()) sum += weight * s * d.inverse();
      roundness += e.weight * e.roundness;
    }
    if (fades) {
      if (remaining.value < 1. / 64) return {};
      sum = sum * remaining.inverse();
    }
    return sum * roundness;
  }

  static Jet faded(const Jet& d)
  {
    const double width = fade_begin<double>() - fade_end<double>();
    const double t = (d.value - fade_end<double>()) / width;
    return d.mapped(t * t * (3 - 2 * t), 6 * t * (1 - t) / width, (6 - 12 * t) / (width * width));
  }
};

// between the corners of a triangle or quadrilateral, whose weights are set
template <class Corners>
Jet_average patch_average(Corners corners, double u, double v)
{
  const Jet x = Jet::of_u(u), y = Jet::of_v(v);
  const Jet rest_x = x * -1 + 1, rest_y = y * -1 + 1;
  if (corners.size() == 3) {
    corners[0].weight = rest_x - y;
    corners[1].weight = x;
    corners[2].weight = y;
  } else {
    corners[0].weight = rest_x * rest_y;
    corners[1].weight = x * rest_y;
    corners[2].weight = x * y;
    corners[3].weight = rest_x * y;
  }
  return Jet_average(corners, true);
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_SURFACE_JET_H

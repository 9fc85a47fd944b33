// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Point-normal Catmull-Clark subdivision by grid lines, on grids given by two indices: circles by their centers,
// rotations by their axes and angles, heights by the bisectors of normals. Includes nothing of the package.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_GRID_LINES_H
#define CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_GRID_LINES_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace reference {

using Number = long double;
using Space = std::array<Number, 3>;

inline Space plus(const Space& a, const Space& b, Number factor = 1)
{
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}
inline Space times(Number factor, const Space& a)
{
  return plus({0, 0, 0}, a, factor);
}
inline Number inner(const Space& a, const Space& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Space outer(const Space& a, const Space& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Space normalized(const Space& a)
{
  return times(1 / std::sqrt(inner(a, a)), a);
}
inline Number smooth_step(Number x, Number a, Number b)
{
  const Number t = std::clamp((x - a) / (b - a), Number(0), Number(1));
  return t * t * (3 - 2 * t);
}

struct Grid_point
{
  Space point, normal;
};
using Maybe = std::optional<Grid_point>;

// v turned about the axis a x b by the angle between a and b
inline Space rotated(const Space& v, const Space& a, const Space& b)
{
  const Space axis = outer(a, b);
  const Number sine = std::sqrt(inner(axis, axis));
  if (sine < 1e-15L) return v;
  const Number angle = std::atan2(sine, inner(a, b));
  const Space k = times(1 / sine, axis);
  return plus(plus(times(std::cos(angle), v), outer(k, v), std::sin(angle)), k,
              inner(k, v) * (1 - std::cos(angle)));
}

class Line_of_grid
{
public:
  explicit Line_of_grid(const std::vector<Maybe>& points)
    : points_(points)
  {}

  Grid_point middle() const
  {
    const int n = int(points_.size());
    const std::vector<Number> weights =
      n == 4 ? std::vector<Number>{0, .5L, .5L, 0} : std::vector<Number>{0, .125L, .75L, .125L, 0};
    std::vector<Space> normals(points_.size());
    Number largest = 0;
    for (int i = 1; i < n - 1; ++i) largest = std::max(largest, curvature(i));
    for (int i = 1; i < n - 1; ++i) normals[i] = curve_normal(i, largest);
    const int from = n == 4 ? 1 : 2;
    for (int i = 1; i < n - 1;
         ++i) { // on the side of the first one, seen in the mirror that exchanges the points
      if (i == from) continue;
      const Space e = normalized(plus(at(i), at(from), -1));
      if (inner(plus(normals[from], e, -2 * inner(e, normals[from])), normals[i]) < 0)
        normals[i] = times(-1, normals[i]);
    }
    Space q{}, sum{}, turned{};
    for (int i = 1; i < n - 1; ++i) {
      q = plus(q, points_[i]->point, weights[i]);
      sum = plus(sum, normals[i], weights[i]);
    }
    const Space normal = normalized(sum);
    Number height = 0;
    for (int i = 1; i < n - 1; ++i) {
      const Space bisector = plus(normals[i], normal);
      height +=
        weights[i] * inner(bisector, plus(points_[i]->point, q, -1)) / inner(bisector, normal);
      turned = plus(turned, rotated(points_[i]->normal, normals[i], normal), weights[i]);
    }
    return {plus(q, normal, height), normalized(turned)};
  }

private:
  bool has(int i) const { return i >= 0 && i < int(points_.size()) && points_[i]; }
  const Space& at(int i) const { return points_[i]->point; }

  std::array<int, 2> others(int i) const
  {
    if (has(i - 1) && has(i + 1)) return {i - 1, i + 1};
    return has(i + 1) ? std::array<int, 2>{i + 2, i + 1} : std::array<int, 2>{i - 1, i - 2};
  }
  // from the center of the circle to the point
  Space radius(int i) const
  {
    const auto o = others(i);
    const Space a = plus(at(o[0]), at(i), -1), b = plus(at(o[1]), at(i), -1), axis = outer(a, b);
    const Space to_center =
      times(1 / (2 * inner(axis, axis)),
            plus(times(inner(a, a), outer(b, axis)), outer(axis, a), inner(b, b)));
    return times(-1, to_center);
  }
  Number curvature(int i) const
  {
    const Space r = radius(i);
    return 1 / std::sqrt(inner(r, r));
  }

  Space curve_normal(int i, Number largest) const
  {
    const auto o = others(i);
    const Space r = radius(i), n = points_[i]->normal;
    const Space axis = outer(plus(at(o[0]), at(i), -1), plus(at(o[1]), at(i), -1));
    Space t = normalized(outer(axis, r));
    t = normalized(plus(t, n, -inner(t, n)));
    const Space c = normalized(plus(r, t, -inner(r, t)));
    const Number ratio = curvature(i) / largest,
                 part = smooth_step(ratio * ratio, 1 / 256.L, 1 / 16.L);
    return normalized(plus(times(part, c), n, (1 - part) * (inner(c, n) < 0 ? -1 : 1)));
  }

  const std::vector<Maybe>& points_;
};

// n x m points, closed in either direction or open
struct Grid
{
  int n, m;
  bool closed_n, closed_m;
  std::vector<Grid_point> points; // of index i * m + j

  Maybe at(int i, int j) const
  {
    if (closed_n) i = (i + n) % n;
    if (closed_m) j = (j + m) % m;
    if (i < 0 || j < 0 || i >= n || j >= m) return std::nullopt;
    return points[std::size_t(i * m + j)];
  }

  Grid refined() const
  {
    Grid fine{closed_n ? 2 * n : 2 * n - 1, closed_m ? 2 * m : 2 * m - 1, closed_n, closed_m, {}};
    for (int i = 0; i < fine.n; ++i)
      for (int j = 0; j < fine.m; ++j) fine.points.push_back(new_point(i, j));
    return fine;
  }

private:
  Grid_point new_point(int i, int j) const
  {
    const bool along_n = !closed_n && (i == 0 || i == 2 * n - 2), // of a border, or crossing none
      along_m = !closed_m && (j == 0 || j == 2 * m - 2);
    if (along_n && along_m) return *at(i / 2, j / 2);
    const int rows = along_n ? 1 : i % 2 ? 4 : 5, columns = along_m ? 1 : j % 2 ? 4 : 5;
    std::vector<std::vector<Maybe>> cells(static_cast<std::size_t>(rows));
    for (int r = 0; r < rows; ++r)
      for (int c = 0; c < columns; ++c)
        cells[r].push_back(at(i / 2 + r - first(rows), j / 2 + c - first(columns)));
    const Grid_point a = by_rows(cells);
    std::vector<std::vector<Maybe>> turned(static_cast<std::size_t>(columns));
    for (int c = 0; c < columns; ++c)
      for (int r = 0; r < rows; ++r) turned[c].push_back(cells[r][c]);
    const Grid_point b = by_rows(turned);
    return {times(.5L, plus(a.point, b.point)), normalized(plus(a.normal, b.normal))};
  }
  static int first(int size) { return size == 1 ? 0 : size == 4 ? 1 : 2; }

  static Grid_point of_line(const std::vector<Maybe>& line)
  {
    return line.size() == 1 ? *line[0] : Line_of_grid(line).middle();
  }
  static Grid_point by_rows(const std::vector<std::vector<Maybe>>& rows)
  {
    std::vector<Maybe> column;
    for (const auto& row : rows) {
      bool is_whole = row.size() == 1 ? row[0].has_value() : true;
      for (std::size_t i = 1; i + 1 < row.size(); ++i) is_whole = is_whole && row[i];
      column.push_back(is_whole ? Maybe(of_line(row)) : std::nullopt);
    }
    return of_line(column);
  }
};

} // namespace reference

#endif // CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_GRID_LINES_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_SCHEMES_GRID_AVERAGE_H
#define CGAL_PN_SUBDIVISION_3_SCHEMES_GRID_AVERAGE_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace CGAL::PN_subdivision_3 {
namespace internal {

// A grid in a row of a mask: `columns` x `rows` entries, row by row, filled with zero weights up to an even number that
// no other row has. Where the grid has no vertex it repeats the one of the cell `center`.
struct Grid_shape
{
  int columns = 0, rows = 0, entries = 0, center = 0;

  static constexpr Grid_shape of(int columns, int rows)
  {
    const int cells = columns * rows, middle_row = rows == 1 ? 0 : rows == 4 ? 1 : 2;
    return {columns, rows, rows == 1 ? 2 * cells : cells + cells % 2,
            (columns == 4 ? 1 : 2) + columns * middle_row};
  }
  // no columns if the row of a mask is no grid
  static Grid_shape of_entries(std::ptrdiff_t entries)
  {
    for (const auto& shape : {of(4, 1), of(5, 1), of(4, 4), of(4, 5), of(5, 5)})
      if (shape.entries == entries) return shape;
    return {};
  }
};

// One line of a grid: of 4 points, a new one between the middle ones by weights (1, 1)/2, or of 5, one for the middle
// one by (1, 6, 1)/8; the outer points, which may be missing, only tell curve normals.
template <class FT>
class Grid_line
{
public:
  using Vector = Coordinates<FT, 3>;
  using Node = Point_normal<FT, 3>;
  struct Optional_node
  {
    Node value;
    bool exists = false;
  };
  using Nodes = std::array<Optional_node, 5>;

  static FT weight(int size, int i)
  {
    if (i == 0 || i == size - 1) return FT(0);
    if (size == 4) return FT(1) / FT(2);
    return FT(i == 2 ? 6 : 1) / FT(8);
  }

  Grid_line(const Nodes& nodes, int size)
    : nodes_(nodes)
    , size_(size)
  {
    find_scale();
    FT largest(0);
    for (int i = 1; i < size - 1; ++i) {
      find_circle(i);
      if (largest < circles_[i].squared_length) largest = circles_[i].squared_length;
    }
    for (int i = 1; i < size - 1; ++i) find_normal(i, largest);
    const int middle = size / 2 - (size == 4);
    for (int i = 1; i < size - 1; ++i)
      if (i != middle) turn_like(middle, i);
  }

  Node new_node() const
  {
    struct Entry
    {
      int vertex;
      FT weight;
    };
    std::array<Entry, 3> entries;
    std::array<Node, 5> old;
    for (int i = 1; i < size_ - 1; ++i) {
      entries[i - 1] = {i, weight(size_, i)};
      old[i] = {nodes_[i].value.point, normals_[i]};
    }
    Node node = PN_average<FT, 3>()(entries.data(), entries.data() + size_ - 2, old.data());
    Vector sum = zero_vector<FT, 3>();
    for (int i = 1; i < size_ - 1; ++i)
      add_carried(sum, weight(size_, i), nodes_[i].value.normal, normals_[i], node.normal);
    node.normal = unit_or_zero(sum);
    return node;
  }

  static Vector unit_or_zero(Vector v)
  {
    const FT squared_length = dot(v, v);
    const FT tolerance = Unit_normal_traits<FT>::vanishing_tolerance();
    if (squared_length <= tolerance * tolerance) return zero_vector<FT, 3>();
    make_unit(v, squared_length);
    return v;
  }

  // Of exact numbers a unit vector in double: its direction is an estimate anyway, and exact ones grow without bounds.
  static void make_unit(Vector& v, const FT& squared_length)
  {
    divide_by_length(v, squared_length);
    if constexpr (is_exact_v<FT>)
      for (FT& x : v) x = FT(close_double(x));
  }

private:
  // The circle through a point of the line and two others, inverted at this point: a straight line.
  struct Circle
  {
    Vector direction = zero_vector<FT, 3>(); // of the line: the tangent of the circle
    Vector foot =
      zero_vector<FT, 3>();    // its point next to the origin: half of the curvature vector
    FT squared_length = FT(0); // of the foot
    FT squared_size = FT(0);   // of the inverted points
    bool exists = false;
  };

  static FT step(const FT& x, const FT& begin, const FT& end)
  {
    if (x <= begin) return FT(0);
    if (x >= end) return FT(1);
    return smoothstep<FT>((x - begin) / (end - begin));
  }

  bool has(int i) const { return i >= 0 && i < size_ && nodes_[i].exists; }

  // A power of two by which the squares of chords and of their inverses neither overflow nor underflow. Exact numbers need none.
  void find_scale()
  {
    if constexpr (!is_exact_v<FT>) {
      double largest = 0;
      for (int i = 1; i < size_; ++i)
        if (has(i - 1) && has(i))
          for (const FT& x : difference(nodes_[i].value.point, nodes_[i - 1].value.point))
            largest = (std::max)(largest, std::abs(close_double(x)));
      if (largest > 0 && std::isfinite(largest)) exponent_ = -std::ilogb(largest);
    }
  }
  // the chord from a point to another point, scaled
  Vector chord(int from, int to) const
  {
    Vector c = difference(nodes_[to].value.point, nodes_[from].value.point);
    if (exponent_ != 0)
      for (FT& x : c) x = times_power_of_two(x, exponent_);
    return c;
  }

  void find_circle(int i)
  {
    int a = i - 1, b = i + 1;
    if (!has(a)) a = i + 2;
    if (!has(b)) b = i - 2;
    if (!has(a) || !has(b)) return;
    Vector x = chord(i, a), y = chord(i, b);
    const FT xx = dot(x, x), yy = dot(y, y);
    if (!(xx > FT(0)) || !(yy > FT(0))) return;
    scale(x, FT(1) / xx);
    scale(y, FT(1) / yy);
    Circle& circle = circles_[i];
    circle.direction = difference(y, x);
    const FT squared_length = dot(circle.direction, circle.direction);
    if (!(squared_length > FT(0))) return;
    make_unit(circle.direction, squared_length);
    circle.foot = without(x, circle.direction);
    circle.squared_length = dot(circle.foot, circle.foot);
    circle.squared_size = (std::max)(FT(1) / xx, FT(1) / yy);
    circle.exists = true;
  }

  // v less its part along the unit vector t
  static Vector without(Vector v, const Vector& t)
  {
    add_multiple(v, -dot(v, t), t);
    return v;
  }

  // The curve normal of a point: that of its circle, made perpendicular to the tangent that the surface normal leaves.
  // Where the line is much straighter than beside it the surface normal stands in.
  void find_normal(int i, const FT& largest)
  {
    const Vector& n = nodes_[i].value.normal;
    Circle& circle = circles_[i];
    normals_[i] = n;
    if (!circle.exists) return;
    const bool has_normal = dot(n, n) > FT(1) / FT(2);
    Vector t = circle.direction;
    if (has_normal) {
      const Vector tangent = without(t, n);
      const FT squared_length = dot(tangent, tangent);
      if (squared_length > FT(1) / FT(16)) {
        t = tangent;
        make_unit(t, squared_length);
      }
    }
    FT bent = step(circle.squared_length, machine_epsilon<FT>() * circle.squared_size,
                   FT(16) * machine_epsilon<FT>() * circle.squared_size);
    if (has_normal) bent *= step(circle.squared_length, largest / FT(256), largest / FT(16));
    const Vector of_surface = unit_or_zero(without(n, t));
    if (bent == FT(0)) {
      normals_[i] = of_surface;
      return;
    }
    Vector normal = without(opposite_vector(circle.foot), t);
    const FT squared_length = dot(normal, normal);
    if (!(squared_length > FT(0))) return;
    make_unit(normal, squared_length);
    normals_[i] = normal;
    if (bent == FT(1) || !has_normal) return;
    scale(normals_[i], bent);
    const FT rest = FT(1) - bent;
    add_multiple(normals_[i], dot(normal, of_surface) < FT(0) ? -rest : rest, of_surface);
    normals_[i] = unit_or_zero(normals_[i]);
  }

  // Of the two unit normals at point j the one that the reflection at the middle of the chord makes of that at point i:
  // along a circle exactly that one, across an inflection the one on the same side.
  void turn_like(int i, int j)
  {
    const Vector e = chord(i, j);
    const FT ee = dot(e, e);
    Vector mirrored = normals_[i];
    if (ee > FT(0)) add_multiple(mirrored, FT(-2) * dot(mirrored, e) / ee, e);
    if (dot(mirrored, normals_[j]) < FT(0)) normals_[j] = opposite_vector(normals_[j]);
  }

  // Adds v, turned by the smallest rotation that takes the unit vector a to b; the weight fades as in PN_average.
  static void add_carried(Vector& sum, FT weight, const Vector& v, const Vector& a, const Vector& b)
  {
    const FT d = FT(1) + dot(a, b);
    Vector result = v;
    if (!PN_average<FT, 3>::is_zero(a) && !PN_average<FT, 3>::is_zero(b)) {
      if (d <= fade_end<FT>()) return;
      if (d < fade_begin<FT>()) weight *= fade(d);
      Vector both = a;
      add_multiple(both, FT(1), b);
      add_multiple(result, -dot(v, both) / d, both);
      add_multiple(result, FT(2) * dot(v, a), b);
    }
    add_multiple(sum, weight, result);
  }

  const Nodes& nodes_;
  int size_, exponent_ = 0;
  std::array<Circle, 5> circles_;
  std::array<Vector, 5> normals_;
};

} // namespace internal

/*!
\ingroup PkgPNSubdivision3Average

The rule of `CatmullClark_scheme::Grid` for the rows of its mask that hold a grid; all others are averaged by
`PN_average`.

A grid line is a curve, and has a *curve normal* at each of its points. It is that of the circle through the point and
its neighbors in the line, perpendicular to the tangent of this circle less its part along the control normal. The
rule takes the rows of the grid first. Each gives one point, by `PN_average` of its points with their curve normals
and the weights of the cubic B-spline. It also gives a control normal, the mean of those of the row, each turned by
the smallest rotation that takes its curve normal to the new one. Then it does the same with the line of these points.
The result is the mean of this and of what the columns first and then the rows give, so that it does not matter which
are which.

 - If the lines of a grid lie on circles, each row and the line of the new points do, too, and the new point is on the
   circle. Grids of parallels and meridians of a torus keep the torus, those of a surface of revolution round
   parallels, if neighbors are less than half a turn apart.
 - In exact number types curve normals, and the new control normals, are rounded to `double`.
 - Across inflections, and along lines that are straight, circles tell nothing. There, continuously, from a quarter down to
   1/16 of the largest curvature of the points that are averaged, the control normal stands in for the curve normal.

Roundness w is applied at the end: the fraction w of the way from the linear point.
*/
template <class FT_>
struct Grid_average
{
  /// the number type.
  using FT = FT_;
  /// what is averaged.
  using Value = Point_normal<FT, 3>;

  /// that of all values, if it is one: then it is not read from them.
  std::optional<FT> roundness;

  /// averages the old values of the entries of a row.
  template <class Entry, class Values>
  Value operator()(const Entry* begin, const Entry* end, const Values& old) const
  {
    const auto shape = internal::Grid_shape::of_entries(end - begin);
    if (shape.columns == 0) {
      PN_average<FT, 3> average;
      average.roundness = roundness;
      return average(begin, end, old);
    }
    const auto a = by_lines(begin, shape, shape.columns, shape.rows, 1, shape.columns, old);
    Value result;
    result.point = a.point;
    result.normal = a.normal;
    if (shape.rows > 1) {
      const auto b = by_lines(begin, shape, shape.rows, shape.columns, shape.columns, 1, old);
      for (int c = 0; c < 3; ++c) {
        result.point[c] = (a.point[c] + b.point[c]) / FT(2);
        result.normal[c] += b.normal[c];
      }
      result.normal = Line::unit_or_zero(result.normal);
    }
    set_roundness(begin, end, old, result);
    return result;
  }

private:
  using Line = internal::Grid_line<FT>;
  using Nodes = typename Line::Nodes;

  // `lines` lines of `size` points, then the line of what they give; a step within a line and from line to line
  template <class Entry, class Values>
  static Point_normal<FT, 3> by_lines(const Entry* begin, const internal::Grid_shape& shape,
                                      int size, int lines, int step, int line_step,
                                      const Values& old)
  {
    Nodes across;
    for (int l = 0; l < lines; ++l) {
      Nodes line;
      bool is_whole = true;
      for (int i = 0; i < size; ++i) {
        const int cell = i * step + l * line_step;
        const auto vertex = begin[cell].vertex;
        line[i].exists = cell == shape.center || vertex != begin[shape.center].vertex;
        line[i].value = {old[vertex].point, old[vertex].normal};
        is_whole = is_whole && (line[i].exists || i == 0 || i == size - 1);
      }
      if (is_whole) across[l] = {Line(line, size).new_node(), true};
    }
    return lines == 1 ? across[0].value : Line(across, lines).new_node();
  }

  template <class Entry, class Values>
  void set_roundness(const Entry* begin, const Entry* end, const Values& old, Value& result) const
  {
    FT& w = result.roundness;
    w = roundness.value_or(FT(0));
    for (const Entry* e = begin; !roundness && e != end; ++e)
      w += e->weight * old[e->vertex].roundness;
    if (CGAL::certainly(w == FT(1))) return;
    auto linear = internal::zero_vector<FT, 3>();
    for (const Entry* e = begin; e != end; ++e)
      internal::add_multiple(linear, e->weight, old[e->vertex].point);
    const auto height = internal::difference(result.point, linear);
    result.point = linear;
    internal::add_multiple(result.point, w, height);
  }
};

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_SUBDIVISION_3_SCHEMES_GRID_AVERAGE_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "curve/Curve_data.h"
#include "io/Error.h"
#include "io/Text_reader.h"

#include <CGAL/PN_recognition_3/recognize_arcs.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <type_traits>

namespace pn_subdivide {
namespace {

using Row = std::array<double, 6>;

const char* const columns_message =
  "a vertex is a line 'x y', 'x y nx ny', 'x y z' or 'x y z nx ny nz'";

std::string count(std::size_t n)
{
  return plural(n, "number", "numbers");
}

std::size_t columns_of(Text_reader& in)
{
  const std::size_t columns = in.words_left();
  if (columns != 2 && columns != 3 && columns != 4 && columns != 6)
    in.fail(count(columns) + ", but " + columns_message);
  return columns;
}

double finite_number(Text_reader& in, bool is_normal)
{
  const double x = in.number(is_normal ? "a coordinate of a normal" : "a coordinate");
  if (!std::isfinite(x))
    in.fail(is_normal ? "the normal is not finite" : "the position is not finite");
  return x;
}

void append(Curve_2& curve, const Row& r)
{
  curve.emplace_back(Curve_kernel::Point_2(r[0], r[1]), Curve_kernel::Vector_2(r[2], r[3]));
}
void append(Curve_3& curve, const Row& r)
{
  curve.emplace_back(Curve_kernel::Point_3(r[0], r[1], r[2]),
                     Curve_kernel::Vector_3(r[3], r[4], r[5]));
}

Curve_data parse_curve(const std::string& text)
{
  Text_reader in(text, '#');
  if (!in.next_line()) throw Error("there are no vertices in this file");
  const std::size_t columns = columns_of(in), first_line = in.line();
  const std::size_t dimension = columns % 3 == 0 ? 3 : 2;

  Curve_data curve;
  curve.has_normals = columns == 2 * dimension;
  if (dimension == 3) curve.points = Curve_3();
  do {
    if (columns_of(in) != columns)
      in.fail(count(in.words_left()) + ", but " + std::to_string(columns) + " in line " +
              std::to_string(first_line) + ": all lines need the same form");
    Row row{};
    for (std::size_t i = 0; i < columns; ++i) row[i] = finite_number(in, i >= dimension);
    std::visit([&row](auto& points) { append(points, row); }, curve.points);
  } while (in.next_line());
  return curve;
}

} // namespace

Curve_data read_curve(const std::string& file)
{
  return naming(file == "-" ? "standard input" : file,
                [&] { return parse_curve(file_content(file)); });
}

void write_curve(Output_file& out, const Curve_data& curve)
{
  const auto write = [&out](const auto& p) {
    for (int i = 0; i < p.dimension(); ++i) {
      if (i > 0) out.text(" ");
      out.number(p.cartesian(i));
    }
  };
  std::visit(
    [&](const auto& points) {
      for (const auto& [point, normal] : points) {
        write(point);
        if (curve.has_normals) {
          out.text(" ");
          write(normal);
        }
        out.text("\n");
      }
    },
    curve.points);
}

std::vector<std::size_t> read_corners(const std::string& file, std::size_t size)
{
  const std::string text = file_content(file);
  std::vector<std::size_t> corners;
  naming(file, [&] {
    Text_reader in(text, '#');
    while (in.next_line())
      while (!in.at_end_of_line()) {
        const std::int64_t corner = in.integer("the number of a vertex");
        if (corner < 0 || static_cast<std::size_t>(corner) >= size)
          in.fail("there is no vertex " + std::to_string(corner) + ", only 0 to " +
                  std::to_string(size - 1));
        corners.push_back(static_cast<std::size_t>(corner));
      }
    if (corners.empty()) throw Error("there are no numbers of vertices in this file");
  });
  return corners;
}

std::vector<Curve_data> split_curve(const Curve_data& polygon, PN::Curve_end end,
                                    const std::vector<std::size_t>& corners, bool estimate)
{
  std::vector<Curve_data> parts;
  std::visit(
    [&](const auto& points) {
      for (auto& part : PN::split_at_corners(points, end, corners))
        parts.push_back({polygon.has_normals || !estimate
                           ? part
                           : PN::estimate_control_normals(part, PN::Curve_end::reflect),
                         true});
    },
    polygon.points);
  return parts;
}

Arc_parts split_into_arcs(const Curve_data& polygon, PN::Curve_end end, bool linear)
{
  Arc_parts result;
  std::size_t number[3] = {};
  const auto take = [&](const auto& points, const auto& for_normals) {
    const std::vector<PN::Recognized_arc> arcs = PN::recognize_arcs(points, end);
    for (const PN::Recognized_arc& arc : arcs) {
      ++number[int(arc.kind)];
      if (arcs.size() > 1) result.corners.push_back(arc.first);
    }
    for (auto& part : PN::split_at_arcs(for_normals, end, arcs))
      result.parts.push_back({std::move(part), !linear || polygon.has_normals});
  };
  std::visit(
    [&](const auto& points) {
      std::vector<std::decay_t<decltype(points[0].first)>> without_normals;
      if (polygon.has_normals) return take(points, points);
      for (const auto& item : points) without_normals.push_back(item.first);
      take(points, without_normals);
    },
    polygon.points);
  const auto counted = [](std::size_t n, const std::string& name) {
    return plural(n, name, name + "s");
  };
  result.found_any = number[1] + number[2] > 0;
  result.summary = counted(number[1], "line") + ", " + counted(number[2], "arc") + ", " +
                   counted(number[0], "unknown piece");
  return result;
}

Curve_data joined_curve(const std::vector<Curve_data>& parts, PN::Curve_end end, std::size_t first)
{
  Curve_data joined;
  joined.has_normals = parts.front().has_normals;
  std::visit(
    [&](const auto& first_part) {
      using Curve = std::decay_t<decltype(first_part)>;
      std::vector<Curve> curves;
      curves.reserve(parts.size());
      for (const Curve_data& part : parts) curves.push_back(std::get<Curve>(part.points));
      Curve curve = PN::join_at_corners(curves, end);
      if (end == PN::Curve_end::closed && first < curve.size())
        std::rotate(curve.begin(), curve.begin() + static_cast<std::ptrdiff_t>(first), curve.end());
      joined.points = std::move(curve);
    },
    parts.front().points);
  return joined;
}

} // namespace pn_subdivide

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/curve_io.h"

#include "io/Error.h"
#include "io/Text_reader.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <new>

namespace pn_subdivide {
namespace {

using Row = std::array<double, 6>;

const char* const columns_message =
  "a vertex is a line 'x y', 'x y nx ny', 'x y z' or 'x y z nx ny nz'";

std::string count(std::size_t n)
{
  return std::to_string(n) + (n == 1 ? " number" : " numbers");
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
  try {
    return parse_curve(file_content(file));
  } catch (const std::bad_alloc&) {
    throw; // has no file to blame
  } catch (const std::exception& e) {
    throw Error((file == "-" ? "standard input" : file) + ": " + e.what());
  }
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

} // namespace pn_subdivide

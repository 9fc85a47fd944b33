// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#include "curve/curve_schemes.h"

#include "io/Error.h"
#include "io/Text_reader.h"

#include <cmath>
#include <sstream>
#include <utility>

namespace pn_subdivide {
namespace {

constexpr double greatest_error_of_sum = 1e-12; // of decimal numbers in a file
constexpr int greatest_index = 1000;

struct Line
{
  std::string place; // for people
  int first_index = 0;
  std::vector<double> coefficients;
};

Line parse_line(const std::string& text, const std::string& place)
{
  Line line{place, 0, {}};
  std::istringstream words(text);
  std::string index;
  words >> index;
  const std::optional<int> first = to_int(index);
  line.first_index = first.value_or(0);
  for (double c = 0; words >> c;) line.coefficients.push_back(c);
  if (!first || !words.eof() || line.coefficients.empty())
    throw Error(place + ": a mask is an integer, the index of its first coefficient, and the "
                        "coefficients, as in -2 0.125 0.5 0.75 0.5 0.125");
  const int last = int((std::min)(line.coefficients.size(), std::size_t(3 * greatest_index)));
  if (line.first_index < -greatest_index || line.first_index > greatest_index - last)
    throw Error(place + ": indices of coefficients go from -1000 to 1000");
  return line;
}

// Coefficients of even and of odd index are the weights of the two kinds of new points.
void require_sums(const Line& line)
{
  for (const int parity : {0, 1}) {
    double sum = 0;
    for (std::size_t i = 0; i < line.coefficients.size(); ++i)
      if (std::abs(line.first_index + int(i)) % 2 == parity) sum += line.coefficients[i];
    if (!(std::abs(sum - 1) <= greatest_error_of_sum))
      throw Error(line.place + formatted(": the coefficients of %s index sum to %.15g instead of 1",
                                         parity == 0 ? "even" : "odd", sum));
  }
}

// centered at 0: a new point for each old one and for each edge
bool is_primal(const Line& line)
{
  return 2 * line.first_index + int(line.coefficients.size()) == 1;
}

std::vector<Line> read_lines(const std::string& file)
{
  std::istringstream in(naming(file, [&] { return file_content(file); }));
  std::vector<Line> lines;
  std::string text;
  for (int number = 1; std::getline(in, text); ++number) {
    const std::size_t first = text.find_first_not_of(" \t\r");
    if (first == std::string::npos || text[first] == '#') continue;
    text.erase(text.find_last_not_of(" \t\r") + 1);
    lines.push_back(parse_line(text, file + ", line " + std::to_string(number)));
    require_sums(lines.back());
    if (is_primal(lines.back()) != is_primal(lines.front()))
      throw Error(lines.back().place + ": the masks before are " +
                  (is_primal(lines.front()) ? "" : "not ") +
                  "centered at 0; all have to be, or none");
  }
  if (lines.empty()) throw Error(file + ": has no mask");
  return lines;
}

} // namespace

Curve_scheme read_level_masks(const std::string& file)
{
  std::vector<Curve_mask> masks;
  std::size_t longest = 2;
  bool primal = true;
  for (Line& line : read_lines(file)) {
    primal = is_primal(line);
    longest = (std::max)(longest, line.coefficients.size());
    masks.emplace_back(line.first_index, std::move(line.coefficients));
  }
  return {"masks of " + file, masks.back(), primal, longest - 2, false, masks};
}

} // namespace pn_subdivide

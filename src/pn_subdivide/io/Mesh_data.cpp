// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/Mesh_data.h"

#include <cstdlib>

namespace pn_subdivide {

const char* comment_of(Normal_kind kind)
{
  switch (kind) {
  case Normal_kind::of_mesh:
    return "normals of the mesh";
  case Normal_kind::of_surface:
    return "normals of the surface";
  case Normal_kind::control:
    break;
  }
  return "control normals";
}

namespace {

bool is_said(const std::vector<std::string>& comments, Normal_kind kind)
{
  return std::find(comments.begin(), comments.end(), comment_of(kind)) != comments.end();
}

bool is_digit(char c)
{
  return c >= '0' && c <= '9';
}

double largest(const std::array<double, 3>& v)
{
  return (std::max)({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
}

} // namespace

Normal_kind normal_kind_of(const std::vector<std::string>& comments)
{
  for (const Normal_kind kind : {Normal_kind::of_mesh, Normal_kind::of_surface})
    if (is_said(comments, kind)) return kind;
  return Normal_kind::control;
}

bool are_said_to_be_control(const std::vector<std::string>& comments)
{
  return normal_kind_of(comments) == Normal_kind::control &&
         is_said(comments, Normal_kind::control);
}

void Written_digits::see(const std::array<std::string_view, 3>& words,
                         const std::array<double, 3>& vector)
{
  const double x = largest(vector);
  if (!(x > 0) || !std::isfinite(x)) return;
  for (std::size_t k = 0; k < 3; ++k)
    if (std::abs(vector[k]) == x) see(words[k]);
}

// "-12.50e-3" has 4 significant digits and 5 decimals.
void Written_digits::see(std::string_view word)
{
  int decimals = 0, significant = 0;
  bool is_behind_point = false;
  std::size_t i = 0;
  for (; i < word.size() && word[i] != 'e' && word[i] != 'E'; ++i) {
    if (word[i] == '.') is_behind_point = true;
    if (!is_digit(word[i])) continue;
    decimals += is_behind_point;
    significant += significant > 0 || word[i] != '0';
  }
  if (i < word.size()) {
    constexpr long most = 999; // beyond those of numbers
    const long exponent = std::strtol(std::string(word.substr(i + 1)).c_str(), nullptr, 10);
    decimals -= int((std::clamp)(exponent, -most, most));
  }
  decimals_ = (std::max)(decimals_, decimals);
  significant_ = (std::max)(significant_, significant);
}

double Written_digits::unit(const std::array<double, 3>& vector) const
{
  const double x = largest(vector);
  if (significant_ == none || !(x > 0)) return 0;
  return (std::max)(std::pow(10., -decimals_),
                    std::pow(10., std::floor(std::log10(x)) + 1 - significant_));
}

Bounding_box::Bounding_box(const std::vector<Triple>& points)
  : low(points.front())
  , high(points.front())
{
  for (const Triple& p : points)
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = (std::min)(low[i], p[i]);
      high[i] = (std::max)(high[i], p[i]);
    }
}

double diagonal_of(const Bounding_box& box)
{
  return std::hypot(box.high[0] - box.low[0], box.high[1] - box.low[1], box.high[2] - box.low[2]);
}

double scale_to_unit_size(const std::vector<Triple>& points)
{
  if (points.empty()) return 1;
  const Bounding_box box(points);
  double size = 0;
  for (std::size_t i = 0; i < 3; ++i) size = (std::max)(size, box.high[i] - box.low[i]);
  return size > 0 && std::isfinite(size) ? std::ldexp(1., -std::ilogb(size)) : 1.;
}

} // namespace pn_subdivide

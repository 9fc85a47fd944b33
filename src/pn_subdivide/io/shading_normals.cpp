// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/shading_normals.h"

#include "io/corner_normals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace pn_subdivide {
namespace {

constexpr std::size_t reciprocal = 5; // behind those of modelling programs
constexpr std::array<const char*, reciprocal> names = {
  "with equal weights", "weighted by area", "weighted by angle", "weighted by area times angle",
  "weighted by the areas that their corners span"};
using Sums = std::array<Triple, reciprocal + 1>;

void add(Triple& sum, double weight, const Triple& v)
{
  for (std::size_t k = 0; k < 3; ++k) sum[k] += weight * v[k];
}

double length(const Triple& v)
{
  return std::sqrt(scalar_product(v, v));
}

// A power of 2 that makes the mesh about as large as 1, so that no product overflows or vanishes.
double scale_of(const std::vector<Triple>& points)
{
  double size = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Triple& p : points) {
      low = (std::min)(low, p[k]);
      high = (std::max)(high, p[k]);
    }
    size = (std::max)(size, high - low);
  }
  return size > 0 && std::isfinite(size) ? std::ldexp(1., -std::ilogb(size)) : 1.;
}

class Sums_of_faces
{
public:
  Sums_of_faces(const Mesh_data& mesh, const Normal_slots& slots)
    : mesh_(mesh)
    , scale_(scale_of(mesh.points))
    , sums_(slots.size(), Sums{})
  {
    for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) add_face(slots, f);
  }
  const Sums& operator[](std::size_t slot) const { return sums_[slot]; }

private:
  Triple edge(Mesh_data::Index from, Mesh_data::Index to) const
  {
    Triple e = difference(mesh_.points[to], mesh_.points[from]);
    for (double& x : e) x *= scale_;
    return e;
  }

  void add_face(const Normal_slots& slots, std::size_t f)
  {
    const Mesh_data::Index* const v = mesh_.face(f).begin();
    const auto n = std::size_t(mesh_.face(f).size());
    Triple twice_area = {0, 0, 0};
    for (std::size_t i = 2; i < n; ++i)
      add(twice_area, 1, cross_product(edge(v[0], v[i - 1]), edge(v[0], v[i])));
    const Triple normal = normalized(twice_area);
    const double area = length(twice_area);
    slots.for_each(f, [&](std::size_t i, std::size_t slot, const Triple&) {
      const Triple a = edge(v[i], v[(i + 1) % n]), b = edge(v[i], v[(i + n - 1) % n]);
      const Triple c = cross_product(a, b);
      const double span = length(c), angle = std::atan2(span, scalar_product(a, b));
      const std::array<double, reciprocal> weights = {1, area, angle, area * angle, span};
      for (std::size_t k = 0; k < reciprocal; ++k) add(sums_[slot][k], weights[k], normal);
      const double lengths = scalar_product(a, a) * scalar_product(b, b);
      if (lengths > 0) add(sums_[slot][reciprocal], 1 / lengths, c);
    });
  }

  const Mesh_data& mesh_;
  double scale_;
  std::vector<Sums> sums_;
};

bool are_close(const Triple& unit, const Triple& sum, double distance)
{
  const Triple s = normalized(sum);
  if (is_zero(s)) return false;
  for (std::size_t k = 0; k < 3; ++k)
    if (!(std::abs(unit[k] - s[k]) <= distance)) return false;
  return true;
}

} // namespace

Shading find_shading(const Mesh_data& mesh)
{
  if (!mesh.has_normals()) return {};
  const Normal_slots slots(mesh);
  const Sums_of_faces sums(mesh, slots);
  std::array<std::size_t, reciprocal + 1> agree{};
  std::size_t all = 0;
  for (std::size_t slot = 0; slot < slots.size(); ++slot) {
    const Triple& n = slots.normal(slot);
    if (is_zero(n) || is_zero(sums[slot][0])) continue;
    const double distance =
      2 * mesh.digits_of_normals.unit(n) / std::hypot(n[0], n[1], n[2]) + 2e-6;
    ++all;
    for (std::size_t k = 0; k <= reciprocal; ++k)
      agree[k] += are_close(normalized(n), sums[slot][k], distance);
  }
  const auto are_most = [all](std::size_t number) { return 5 * number >= 4 * all; };
  const auto best =
    std::size_t(std::max_element(agree.begin(), agree.begin() + reciprocal) - agree.begin());
  if (all == 0 || !are_most(agree[best]) || are_most(agree[reciprocal])) return {};
  return {names[best], agree[best], all};
}

} // namespace pn_subdivide

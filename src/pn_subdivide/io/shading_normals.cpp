// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/mesh_normals.h"

#include <CGAL/PN_recognition_3/internal/recognition.h>
#include <CGAL/number_utils.h>

#include <boost/pending/disjoint_sets.hpp>

#include <array>
#include <map>
#include <set>

namespace pn_subdivide {
namespace {

constexpr std::size_t reciprocal = 5; // behind those of modelling programs
constexpr std::array<const char*, reciprocal> names = {
  "with equal weights", "weighted by area", "weighted by angle", "weighted by area times angle",
  "weighted by the areas that their corners span"};
// of the normals of the faces of a slot
struct Sums
{
  std::array<Triple, reciprocal + 1> sums{};
  std::array<double, reciprocal + 1> errors{}; // by the rounding of the points

  void add(std::size_t kind, double weight, const Triple& normal, double error)
  {
    for (std::size_t k = 0; k < 3; ++k) sums[kind][k] += weight * normal[k];
    errors[kind] += weight * error;
  }
  // of the direction, in radians
  double error(std::size_t kind) const
  {
    return errors[kind] / std::sqrt(scalar_product(sums[kind], sums[kind]));
  }
};

void add(Triple& sum, double weight, const Triple& v)
{
  for (std::size_t k = 0; k < 3; ++k) sum[k] += weight * v[k];
}

double length(const Triple& v)
{
  return std::sqrt(scalar_product(v, v));
}

class Sums_of_faces
{
public:
  Sums_of_faces(const Mesh_data& mesh, const Normal_slots& slots)
    : mesh_(mesh)
    , scale_(scale_to_unit_size(mesh.points))
    , rounding_(scale_ * rounding_of(mesh.points))
    , sums_(slots.size())
  {
    for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) add_face(slots, f);
  }
  const Sums& operator[](std::size_t slot) const { return sums_[slot]; }

private:
  Triple edge(Index from, Index to) const
  {
    Triple e = difference(mesh_.points[to], mesh_.points[from]);
    for (double& x : e) x *= scale_;
    return e;
  }

  void add_face(const Normal_slots& slots, std::size_t f)
  {
    const Index* const v = mesh_.face(f).begin();
    const auto n = std::size_t(mesh_.face(f).size());
    Triple twice_area = {0, 0, 0};
    for (std::size_t i = 2; i < n; ++i)
      add(twice_area, 1, cross_product(edge(v[0], v[i - 1]), edge(v[0], v[i])));
    const Triple normal = normalized(twice_area);
    const double area = length(twice_area);
    double around = 0;
    for (std::size_t i = 0; i < n; ++i) around += length(edge(v[i], v[(i + 1) % n]));
    const double error = area > 0 ? 2 * rounding_ * around / area : 0;
    slots.for_each(f, [&](std::size_t i, std::size_t slot, const Triple&) {
      const Triple a = edge(v[i], v[(i + 1) % n]), b = edge(v[i], v[(i + n - 1) % n]);
      const Triple c = cross_product(a, b);
      const double span = length(c), angle = std::atan2(span, scalar_product(a, b));
      const std::array<double, reciprocal> weights = {1, area, angle, area * angle, span};
      for (std::size_t k = 0; k < reciprocal; ++k) sums_[slot].add(k, weights[k], normal, error);
      const double lengths = scalar_product(a, a) * scalar_product(b, b);
      if (lengths > 0) sums_[slot].add(reciprocal, 1 / lengths, c, span * error);
    });
  }

  const Mesh_data& mesh_;
  double scale_, rounding_; // of coordinates
  std::vector<Sums> sums_;
};

constexpr double largest_error = 0.05; // of what is still compared

bool are_close(const Triple& unit, const Triple& sum, double distance)
{
  const Triple s = normalized(sum);
  if (is_zero(s)) return false;
  for (std::size_t k = 0; k < 3; ++k)
    if (!(std::abs(unit[k] - s[k]) <= distance)) return false;
  return true;
}

// of each vertex a number of its component
std::vector<std::size_t> components_of(const Mesh_data& mesh)
{
  boost::disjoint_sets_with_storage<> sets(mesh.points.size());
  std::vector<std::size_t> result(mesh.points.size());
  for (std::size_t v = 0; v < result.size(); ++v) sets.make_set(v);
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    for (const Index v : mesh.face(f)) sets.union_set(mesh.face(f).front(), v);
  for (std::size_t v = 0; v < result.size(); ++v) result[v] = sets.find_set(v);
  return result;
}

// of lines, for normals that all point inside are another matter
double degrees_between(const Triple& m, const Triple& n)
{
  return std::atan2(length(cross_product(m, n)), std::abs(scalar_product(m, n))) * 180 / CGAL_PI;
}

double median(std::vector<double>& x)
{
  const auto middle = x.begin() + std::ptrdiff_t(x.size() / 2);
  std::nth_element(x.begin(), middle, x.end());
  return *middle;
}

} // namespace

double rounding_of(const std::vector<Triple>& points)
{
  std::vector<double> coordinates;
  for (const Triple& p : points) coordinates.insert(coordinates.end(), p.begin(), p.end());
  return CGAL::PN_subdivision_3::internal::recognition::file_rounding(coordinates);
}

Shading find_shading(const Mesh_data& mesh)
{
  if (!mesh.has_normals()) return {};
  const Normal_slots slots(mesh);
  const Sums_of_faces sums(mesh, slots);
  std::array<std::size_t, reciprocal + 1> agree{};
  std::size_t all = 0;
  for (std::size_t slot = 0; slot < slots.size(); ++slot) {
    const Triple& n = slots.normal(slot);
    const Sums& of_slot = sums[slot];
    if (is_zero(n) || is_zero(of_slot.sums[0]) || !(of_slot.error(0) < largest_error)) continue;
    const double distance =
      2 * mesh.digits_of_normals.unit(n) / std::hypot(n[0], n[1], n[2]) + 2e-6;
    ++all;
    for (std::size_t k = 0; k <= reciprocal; ++k)
      agree[k] += are_close(normalized(n), of_slot.sums[k],
                            distance + (std::min)(of_slot.error(k), largest_error));
  }
  const auto are_most = [all](std::size_t number) { return 5 * number >= 4 * all; };
  const auto best =
    std::size_t(std::max_element(agree.begin(), agree.begin() + reciprocal) - agree.begin());
  if (all == 0 || !are_most(agree[best]) || are_most(agree[reciprocal])) return {};
  return {names[best], agree[best], all};
}

Stray_normals find_stray_normals(const Mesh_data& mesh)
{
  constexpr std::size_t area = 1, angle = 2;
  constexpr double most = 10;
  const Normal_slots slots(mesh);
  const Sums_of_faces sums(mesh, slots);
  const std::vector<std::size_t> component = components_of(mesh);
  std::map<std::size_t, std::array<std::vector<double>, 3>> degrees;
  for (std::size_t slot = 0; slot < slots.size(); ++slot) {
    const Triple& n = slots.normal(slot);
    std::size_t i = 0;
    for (const std::size_t kind : {area, angle, reciprocal})
      if (const Triple& sum = sums[slot].sums[kind]; !is_zero(n) && !is_zero(sum))
        degrees[component[slots.vertex(slot)]][i++].push_back(degrees_between(n, sum));
  }
  Stray_normals result;
  result.is_stray.assign(mesh.points.size(), false);
  std::set<std::size_t> stray;
  for (auto& [number, of_kinds] : degrees) {
    double least = 180;
    for (std::vector<double>& x : of_kinds) least = x.empty() ? 0 : (std::min)(least, median(x));
    if (!(least > most)) continue;
    stray.insert(number);
    result.degrees = (std::max)(result.degrees, least);
  }
  result.components = stray.size();
  result.of = degrees.size();
  for (std::size_t v = 0; v < component.size(); ++v)
    result.is_stray[v] = stray.count(component[v]) > 0;
  return result;
}

} // namespace pn_subdivide

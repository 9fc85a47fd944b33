// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/Error.h"
#include "io/Mesh_data.h"
#include "surface/Recognized_part.h"
#include "surface/Surface.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace pn_subdivide {
namespace {

// The faces around a vertex; corners in their order.
class Star
{
public:
  void add(const Mesh_data& mesh, std::size_t f, Index v)
  {
    const Mesh_data::Face face = mesh.face(f);
    const auto n = std::size_t(face.size());
    const auto at = [&](std::size_t i) { return *(face.begin() + std::ptrdiff_t(i % n)); };
    std::size_t i = 0;
    while (at(i) != v) ++i;
    Vector_3 area(0, 0, 0);
    const Point_3 p = to_point(mesh.points[v]);
    for (std::size_t k = 1; k + 1 < n; ++k)
      area += CGAL::cross_product(to_point(mesh.points[at(i + k)]) - p,
                                  to_point(mesh.points[at(i + k + 1)]) - p);
    const double length = std::sqrt(area.squared_length());
    if (!(length > 0)) return;
    const Vector_3 normal = area / length;
    if (n > 3) is_flat_ = is_flat_ || is_flat(mesh, face, p, normal);
    sides_.push_back({at(i + n - 1), at(i + 1), normal});
  }

  // Do flat patches end here at a sharp edge?
  bool is_of_part() const
  {
    constexpr double cosine_of_20_degrees = 0.94, flat = 1 - 1e-6;
    bool has_sharp = false, has_flat = is_flat_;
    for (const Side& a : sides_)
      for (const Side& b : sides_) {
        if (a.next != b.before || &a == &b) continue;
        has_sharp = has_sharp || a.normal * b.normal < cosine_of_20_degrees;
        has_flat = has_flat || a.normal * b.normal > flat;
      }
    return has_sharp && has_flat;
  }
  bool any() const { return !sides_.empty(); }

private:
  struct Side
  {
    Index before, next;
    Vector_3 normal;
  };

  // a polygon
  static bool is_flat(const Mesh_data& mesh, const Mesh_data::Face& face, const Point_3& p,
                      const Vector_3& normal)
  {
    constexpr double part_of_size = 1e-4;
    return std::all_of(face.begin(), face.end(), [&](Index v) {
      const Vector_3 d = to_point(mesh.points[v]) - p;
      return std::abs(d * normal) <= part_of_size * std::sqrt(d.squared_length());
    });
  }

  std::vector<Side> sides_;
  bool is_flat_ = false;
};

struct Look
{
  std::size_t of_part = 0, all = 0; // vertices
};

// at one vertex in `step`, of whatever rows the mesh may have
Look look_at(const Mesh_data& mesh, std::size_t step)
{
  constexpr std::size_t most_faces = 64;
  const auto is_looked_at = [step](Index v) {
    return step == 1 || (v * std::uint64_t(0x9e3779b97f4a7c15) >> 32) % step == 0;
  };
  std::unordered_map<Index, std::vector<std::size_t>> faces; // of these
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    for (const Index v : mesh.face(f))
      if (is_looked_at(v)) faces[v].push_back(f);
  Look look;
  for (const auto& [v, around] : faces) {
    if (around.size() > most_faces) continue;
    Star star;
    for (const std::size_t f : around) star.add(mesh, f, v);
    look.all += star.any();
    look.of_part += star.is_of_part();
  }
  return look;
}

} // namespace

Surface_options with_part(const Surface_options& given)
{
  if (!given.part) return given;
  require_surface_schemes(given.scheme);
  const std::string scheme = scheme_without_creases(given.scheme);
  if (!scheme.empty())
    throw Usage_error("--part and --scheme " + scheme +
                      " exclude each other: it has no rules for creases; " +
                      creasing_scheme_names() + " have");
  Surface_options options = given;
  options.creases.sharp = "surfaces";
  options.planes = options.planes.value_or("rims");
  if (!options.chord && !options.has_levels) options.chord = "0.02%";
  return options;
}

bool looks_like_part(const Mesh_data& mesh)
{
  constexpr std::size_t least = 400, most = 2000;
  const std::size_t n = mesh.points.size();
  // a look at all of them would take a third of the time of a round
  const std::size_t number = (std::min)(most, (std::max)(least, n / 16));
  const std::size_t step = (std::max)(std::size_t(1), n / number);
  Look look = look_at(mesh, step);
  // the numbers of the vertices decide which are looked at, but not what the mesh is
  if (step > 1 && 20 * look.of_part > look.all && 5 * look.of_part < look.all)
    look = look_at(mesh, 1);
  return look.of_part > 0 &&
         10 * look.of_part >= look.all; // parts have a quarter and more, animals a twentieth
}

bool may_be_part(const Surface_options& options, const Scheme_choice& scheme)
{
  const auto is_default = [](const std::optional<std::string>& option) {
    return option.value_or("auto") == "auto";
  };
  const bool is_copy = options.levels == 0 && !options.limit.points && !options.write_tags &&
                       options.output_normals != "control" && options.output_normals != "both";
  return is_default(options.creases.sharp) && is_default(options.normals) &&
         !options.creases.sharpness && !options.linear && !options.interpolate && !is_copy &&
         scheme_without_creases(scheme).empty();
}

std::string taken_for_part(const Recognized_part& part)
{
  std::size_t planes = 0, rounds = 0;
  for (const Recognized_surface& s : part.surfaces) {
    planes += s.kind == Recognized_surface::Kind::plane;
    rounds += is_round(s.kind);
  }
  return "taken for a part, with " + plural(planes, "plane", "planes") + " and " +
         plural(rounds, "round surface", "round surfaces") + " on " +
         std::to_string(std::lround(100 * (1 - part.unknown_area / part.area))) +
         " % of its area: --part makes planes of few triangles and rounds within a tolerance, "
         "--sharp none smooths everything";
}

Edge_advice edge_advice(const Recognized_part* part, std::size_t turning, std::size_t edges)
{
  if (turning == 0) return Edge_advice::none;
  if (part != nullptr && part->sure_area >= part->area / 2) return Edge_advice::part;
  return 10 * turning <= edges ? Edge_advice::angle : Edge_advice::none;
}

} // namespace pn_subdivide

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_RECOGNITION_RECOGNIZE_PART_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_RECOGNITION_RECOGNIZE_PART_H

#include <CGAL/PN_subdivision_3/internal/recognition/Found_regions.h>
#include <CGAL/PN_subdivision_3/internal/recognition/Patches.h>
#include <CGAL/PN_subdivision_3/internal/recognition/Region.h>
#include <CGAL/PN_subdivision_3/internal/recognition/Rounds.h>
#include <CGAL/PN_subdivision_3/internal/recognition/Segments.h>
#include <CGAL/PN_subdivision_3/internal/recognition/fit_neighborhoods.h>
#include <CGAL/PN_subdivision_3/internal/recognition/guess_shapes.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {
namespace recognition {

// the largest part of some facets that is connected by smooth joints
inline std::vector<Index> largest_connected(const Context& c, const std::vector<Index>& sorted)
{
  std::vector<Index> best;
  std::vector<bool> is_seen(sorted.size(), false);
  for (std::size_t first = 0; first < sorted.size(); ++first) {
    if (is_seen[first]) continue;
    is_seen[first] = true;
    std::vector<Index> component{sorted[first]};
    for (std::size_t i = 0; i < component.size(); ++i)
      for (const Index number : c.patches[component[i]].joints) {
        const Joint& j = c.patches.joints[number];
        if (!j.is_smooth) continue;
        const auto it = std::lower_bound(sorted.begin(), sorted.end(), j.other(component[i]));
        if (it == sorted.end() || *it != j.other(component[i]) ||
            is_seen[std::size_t(it - sorted.begin())])
          continue;
        is_seen[std::size_t(it - sorted.begin())] = true;
        component.push_back(*it);
      }
    if (component.size() > best.size()) best = component;
  }
  std::sort(best.begin(), best.end());
  return best;
}

inline int rank_of(Kind kind)
{
  return kind == Kind::cylinder ? 0 : kind == Kind::sphere ? 1 : kind == Kind::cone ? 2 : 3;
}

// Else its facets are planes later, and must not be kept from what they may be.
inline bool may_be_round(const Context& c, const Region& r)
{
  if (r.shape.kind == Kind::sphere && r.patches.size() >= 24) return true;
  const double step = r.step();
  return (1 - 1e-4) * step * c.min_facets <= 2 * std::acos(-1.) ||
         (r.number_of_tangent_ends() == 2 && step <= radians(61));
}

// Of regions that overlap those of most facets, so that a sphere wins over its rows, which are exact cones.
inline std::vector<Region> choose_regions(const Context& c, Found_regions& found)
{
  std::vector<Region> all = found.regions();
  std::stable_sort(all.begin(), all.end(), [&](const Region& a, const Region& b) {
    if (may_be_round(c, a) != may_be_round(c, b)) return may_be_round(c, a);
    if (a.patches.size() != b.patches.size()) return a.patches.size() > b.patches.size();
    if (a.number_of_tangent_ends() != b.number_of_tangent_ends())
      return a.number_of_tangent_ends() > b.number_of_tangent_ends();
    if (a.shape.kind != b.shape.kind) return rank_of(a.shape.kind) < rank_of(b.shape.kind);
    return a.patches < b.patches; // patches are numbered in the order of their vertices
  });
  std::vector<bool> is_taken(c.patches.size(), false);
  std::vector<Region> result;
  for (Region& r : all) {
    std::vector<Index> rest;
    for (const Index p : r.patches)
      if (!is_taken[p]) rest.push_back(p);
    if (rest.size() < r.patches.size()) {
      if (5 * rest.size() < 3 * r.patches.size()) continue;
      rest = largest_connected(c, rest);
      if (5 * rest.size() < 3 * r.patches.size()) continue;
      r.patches = rest;
      if (!found.evidence().still_holds(r)) continue;
    }
    for (const Index p : r.patches) is_taken[p] = true;
    result.push_back(std::move(r));
  }
  return result;
}

// Some facets first, since in the large regions that they are in there is nothing left to guess.
inline void find_regions(const Context& context, Found_regions& found)
{
  constexpr Index samples = 200;
  Guess_by_rows by_rows(context, found);
  Fit_neighborhoods by_fits(context, found);
  for (Index p = 0; p < context.patches.size(); p += context.patches.size() / samples + 1) {
    by_rows.guess_at(p);
    by_fits.fit_at(p);
  }
  guess_by_apexes(context, found);
  guess_by_rulings(context, found);
  by_rows();
  by_fits();
}

// All of it, in the frame of the part.
inline Segments recognize_part(const Part& part, unsigned min_facets)
{
  const double greatest = (std::max)(radians(61), radians(360. / min_facets + 0.5));
  const Patches patches = Make_patches(part, greatest)();
  const Context context{part, patches, greatest, min_facets};
  Found_regions found(context);
  find_regions(context, found);
  std::vector<Region> regions = choose_regions(context, found);
  const auto prisms = Rounds(context, regions)();
  Region_borders borders(context, regions, prisms);
  borders();
  return Make_segments(context, regions, borders)();
}

// The surfaces in the frame of the mesh. Axes point to the greater coordinates, those of cones from the apex into the cone,
// normals of planes to the outside.
inline std::vector<Recognized_surface> surfaces_of(const Part& part, const Segments& segments)
{
  std::vector<Recognized_surface> result;
  for (const Segments::Segment& s : segments.segments) {
    Shape shape = s.shape;
    if ((shape.kind == Kind::cylinder || shape.kind == Kind::torus) && is_less(shape.axis, Vec3()))
      shape.axis = -shape.axis;
    result.push_back(as_surface(shape, part.scale, part.shift));
    result.back().residual = part.scale * s.residual;
    result.back().number_of_faces = s.faces.size();
    result.back().widest_step = s.widest_step;
    result.back().widest_meridian_step = s.widest_meridian_step;
  }
  return result;
}

} // namespace recognition
} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_RECOGNITION_RECOGNIZE_PART_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_RECOGNITION_RECOGNIZE_PART_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_RECOGNITION_RECOGNIZE_PART_H

#include <CGAL/PN_subdivision_3/internal/recognition/Patches.h>
#include <CGAL/PN_subdivision_3/internal/recognition/Rounds.h>
#include <CGAL/PN_subdivision_3/internal/recognition/Segments.h>
#include <CGAL/PN_subdivision_3/internal/recognition/choose_regions.h>
#include <CGAL/PN_subdivision_3/internal/recognition/fit_neighborhoods.h>
#include <CGAL/PN_subdivision_3/internal/recognition/guess_shapes.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {
namespace recognition {

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
  const std::vector<Index> prisms = Rounds(context, regions)();
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

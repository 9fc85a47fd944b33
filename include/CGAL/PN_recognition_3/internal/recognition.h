// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_RECOGNITION_3_INTERNAL_RECOGNITION_H
#define CGAL_PN_RECOGNITION_3_INTERNAL_RECOGNITION_H

// Recognition is ordinary code, in double whatever the kernel. Its sources are included here and nowhere else, but in
// the library; they include the interface, or Part.h.

#include <CGAL/PN_recognition_3/internal/recognition_interface.h>
#include <CGAL/PN_subdivision_3/internal/average/input_checks.h>
#include <CGAL/PN_subdivision_3/parameters/parameters.h>
#include <CGAL/number_utils.h>

#include <stdexcept>

#ifndef CGAL_PN_SUBDIVISION_3_RECOGNITION
#  include <CGAL/PN_recognition_3/internal/Evidence.cpp>
#  include <CGAL/PN_recognition_3/internal/Found_regions.cpp>
#  include <CGAL/PN_recognition_3/internal/Part.cpp>
#  include <CGAL/PN_recognition_3/internal/Patches.cpp>
#  include <CGAL/PN_recognition_3/internal/Plane_of_polygon.cpp>
#  include <CGAL/PN_recognition_3/internal/Prism_filter.cpp>
#  include <CGAL/PN_recognition_3/internal/Region.cpp>
#  include <CGAL/PN_recognition_3/internal/Region_borders.cpp>
#  include <CGAL/PN_recognition_3/internal/Segments.cpp>
#  include <CGAL/PN_recognition_3/internal/Shape.cpp>
#  include <CGAL/PN_recognition_3/internal/arcs.cpp>
#  include <CGAL/PN_recognition_3/internal/guess_shapes.cpp>
#  include <CGAL/PN_recognition_3/internal/surfaces.cpp>
#endif

namespace CGAL::PN_subdivision_3::internal {

template <class NamedParameters>
struct Recognition_parameters
{
  explicit Recognition_parameters(const NamedParameters& np)
  {
    using parameters::choose_parameter;
    using parameters::get_parameter;
    const auto facets = choose_parameter(get_parameter(np, min_facets_t()), 8u);
    if (!(facets >= 3 && facets <= 1000000))
      throw std::invalid_argument(
        "PN_subdivision_3: min_facets must be at least 3, the number of sides of a prism");
    min_facets = static_cast<unsigned>(facets);
    tolerance = CGAL::to_double(choose_parameter(get_parameter(np, surface_tolerance_t()), 0.));
    if (!(tolerance >= 0) || !is_finite_number(tolerance))
      throw std::invalid_argument("PN_subdivision_3: surface_tolerance must be a positive length, "
                                  "or 0 for that of the coordinates");
    sharp_angle = CGAL::to_double(choose_parameter(get_parameter(np, sharp_angle_t()), 30.));
    if (!(sharp_angle >= 0 && sharp_angle <= 180))
      throw std::invalid_argument(
        "PN_subdivision_3: sharp_angle must be between 0 and 180 degrees");
  }

  unsigned min_facets;
  double tolerance, sharp_angle;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_RECOGNITION_3_INTERNAL_RECOGNITION_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_RECOGNITION_3_INTERNAL_RECOGNIZE_PART_H
#define CGAL_PN_RECOGNITION_3_INTERNAL_RECOGNIZE_PART_H

#include <CGAL/PN_recognition_3/internal/Found_regions.h>
#include <CGAL/PN_recognition_3/internal/Part.h>
#include <CGAL/PN_recognition_3/internal/Patches.h>
#include <CGAL/PN_recognition_3/internal/Region.h>
#include <CGAL/PN_recognition_3/internal/Rounds.h>
#include <CGAL/PN_recognition_3/internal/Segments.h>
#include <CGAL/PN_recognition_3/internal/Surface_tags.h>
#include <CGAL/PN_recognition_3/internal/fit_neighborhoods.h>
#include <CGAL/PN_recognition_3/internal/guess_shapes.h>
#include <CGAL/PN_recognition_3/surfaces/Recognized_surface.h>
#include <CGAL/PN_subdivision_3/internal/average/checked_coordinates.h>
#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
#include <CGAL/PN_subdivision_3/internal/meshes/read_mesh.h>
#include <CGAL/PN_subdivision_3/internal/meshes/with_mesh_access.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/parameters/parameters.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
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
  const Context context{part, patches, greatest, min_facets,
                        std::vector<bool>(part.points.size(), false)};
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

struct Read_part
{
  Level_connectivity level;
  recognition::Part part;
};

template <class Mesh, class Access, class NamedParameters>
Read_part read_part(const Mesh& mesh, const Access& access, const NamedParameters& np,
                    double tolerance)
{
  using Parameters = Surface_parameters<Mesh, NamedParameters>;
  using FT = typename Parameters::FT;
  Read_part result;
  result.level = checked_level(access);
  const auto map = Parameters::const_point_map(mesh, np);
  std::vector<std::array<double, 3>> points;
  for (Level_connectivity::Index v = 0; v < result.level.number_of_vertices(); ++v) {
    points.push_back(to_double_3(checked_point<FT>(access, map, v)));
    check_finite<double, 3>(points.back(), "point", [&] { return access.vertex_name(v); });
  }
  result.part = recognition::Make_part()(result.level, points, tolerance);
  return result;
}

// the number of each face's surface, in the order of the mesh
template <class Access, class Patch_map>
std::vector<std::size_t> checked_patches(const Access& access, Patch_map patch_map,
                                         std::size_t faces, std::size_t surfaces)
{
  std::vector<std::size_t> result;
  for (Level_connectivity::Index f = 0; f < faces; ++f) {
    const auto number = get(patch_map, access.face_at(f));
    if (static_cast<long long>(number) < 0 || std::size_t(number) >= surfaces)
      throw std::invalid_argument("PN_subdivision_3: " + access.face_name(f) +
                                  " has the number of a surface that there is not: take those of "
                                  "recognize_surfaces() for this mesh");
    result.push_back(std::size_t(number));
  }
  return result;
}

template <class Mesh, class Patch_map, class NamedParameters, class Function>
void with_surface_tags(const Mesh& mesh, Patch_map patch_map,
                       const std::vector<Recognized_surface>& surfaces, const NamedParameters& np,
                       const Function& function)
{
  const Recognition_parameters<NamedParameters> options(np);
  with_mesh_access(mesh, [&](const auto& access) {
    const Read_part read = read_part(mesh, access, np, options.tolerance);
    const recognition::Surface_tags tags(
      read.level, read.part, surfaces,
      checked_patches(access, patch_map, read.level.number_of_faces(), surfaces.size()),
      recognition::radians(options.sharp_angle));
    function(access, read.level, tags);
  });
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_RECOGNITION_3_INTERNAL_RECOGNIZE_PART_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include <CGAL/PN_recognition_3/internal/Part.h>
#include <CGAL/PN_subdivision_3/internal/normals/Fan.h>

namespace CGAL::PN_subdivision_3::internal::recognition {

// All of it, in the frame of the part.
inline Segments recognize_part(const Part& part, unsigned min_facets)
{
  const double greatest = (std::max)(radians(61), radians(360. / min_facets + 0.5));
  const Patches patches = make_patches(part, greatest);
  const Context context{part,
                        patches,
                        greatest,
                        min_facets,
                        std::vector<bool>(part.points.size(), false),
                        std::vector<bool>(patches.size(), false)};
  std::vector<Region> regions = find_regions(context);
  const std::vector<double> prism_step = take_prisms_out(context, regions);
  const std::vector<Index> owners = close_borders(context, regions, prism_step);
  return make_segments(context, regions, owners, prism_step);
}

// The surfaces in the frame of the mesh. Axes point to the greater coordinates, those of cones from the apex into the cone,
// normals of planes to the outside.
inline std::vector<Recognized_surface> surfaces_of(const Part& part, const Segments& segments)
{
  std::vector<Recognized_surface> result;
  for (const Segments::Segment& s : segments.segments) {
    Shape shape = s.shape;
    const bool is_its_own_reverse =
      facts_of(shape.kind).turns_about_axis && shape.kind != Kind::cone;
    if (is_its_own_reverse && shape.axis < Vec3()) shape.axis = -shape.axis;
    result.push_back(as_surface(shape, part.scale, part.shift));
    result.back().residual = part.scale * s.residual;
    result.back().number_of_faces = s.faces.size();
    result.back().widest_step = s.widest_step;
    result.back().widest_meridian_step = s.widest_meridian_step;
  }
  return result;
}

CGAL_PN_RECOGNITION_3_INLINE Found_surfaces find_surfaces(const Level_connectivity& level,
                                                          const Points& points, double tolerance,
                                                          unsigned min_facets)
{
  const Part part = make_part(level, points, tolerance);
  const Segments segments = recognize_part(part, min_facets);
  Found_surfaces result{surfaces_of(part, segments), {}};
  for (const Index rank : part.rank_of_face)
    result.surface_of_face.push_back(segments.segment_of_face[rank]);
  return result;
}

// --- tags ---

CGAL_PN_RECOGNITION_3_INLINE
Surface_tags::Surface_tags(const Level_connectivity& level, const Points& points, double tolerance,
                           const std::vector<Recognized_surface>& surfaces,
                           std::vector<std::size_t> patches, double sharp_angle)
  : level_(level)
  , patch_(std::move(patches))
  , sharp_angle_(sharp_angle)
{
  const Part part = make_part(level, points, tolerance);
  tolerance_ = part.tolerance;
  for (const Index rank : part.rank_of_vertex)
    point_.push_back(rank == null ? Vec3() : part.points[rank]);
  for (const Recognized_surface& s : surfaces)
    shapes_.push_back(as_shape(s, part.scale, part.shift));
  set_face_normals(part);
  set_sides(part);
}

CGAL_PN_RECOGNITION_3_INLINE bool Surface_tags::is_crease(Index e) const
{
  if (level_.is_border_edge(e)) return false;
  const Index f = level_.face(2 * e), g = level_.face(2 * e + 1);
  if (is_known(f) || is_known(g)) return patch_[f] != patch_[g];
  return angle_between(normal_[f], normal_[g]) > sharp_angle_;
}

CGAL_PN_RECOGNITION_3_INLINE bool Surface_tags::is_corner(Index v) const
{
  bool result = false;
  if (!level_.is_isolated(v))
    for (const Index h : fan_of_vertex(level_, v))
      result = result || (!level_.is_border(h) && is_apex(h));
  return result;
}

CGAL_PN_RECOGNITION_3_INLINE bool Surface_tags::is_unknown(Index v) const
{
  bool has_unknown = false, has_known = false;
  if (!level_.is_isolated(v))
    for (const Index h : fan_of_vertex(level_, v))
      if (!level_.is_border(h)) (is_known(level_.face(h)) ? has_known : has_unknown) = true;
  return has_unknown && !has_known;
}

CGAL_PN_RECOGNITION_3_INLINE Vec3 Surface_tags::normal(Index h) const
{
  if (level_.is_border(h) || !is_known(level_.face(h)) || is_apex(h)) return {};
  const std::size_t patch = patch_[level_.face(h)];
  return double(side_[patch]) * shapes_[patch].normal(point_[level_.target(h)]);
}

inline bool Surface_tags::is_apex(Index h) const
{
  const Shape& s = shapes_[patch_[level_.face(h)]];
  return s.kind == Kind::cone &&
         norm(point_[level_.target(h)] - s.center) <= 10 * tolerance_ / s.sine;
}

// slivers have that of the face that they join
inline void Surface_tags::set_face_normals(const Part& part)
{
  normal_.resize(level_.number_of_faces());
  std::vector<Index> slivers;
  for (Index f = 0; f < normal_.size(); ++f) {
    normal_[f] = part.normal[part.rank_of_face[f]];
    if (part.is_sliver(part.rank_of_face[f])) slivers.push_back(f);
  }
  while (!slivers.empty()) {
    std::vector<std::pair<Index, Vec3>> found;
    std::vector<Index> rest;
    for (const Index f : slivers) {
      const Vec3 n = normal_of_neighbor(f);
      if (dot(n, n) > 0)
        found.emplace_back(f, n);
      else
        rest.push_back(f);
    }
    if (found.empty()) break;
    for (const auto& n : found) normal_[n.first] = n.second;
    slivers = rest;
  }
}

inline Vec3 Surface_tags::normal_of_neighbor(Index f) const
{
  Vec3 result;
  double longest = -1;
  for_each_halfedge_of_face(level_, f, [&](Index h) {
    const Index o = Level_connectivity::opposite(h);
    const double length = norm(point_[level_.target(h)] - point_[level_.target(o)]);
    if (level_.is_border(o) || patch_[level_.face(o)] != patch_[f] || !(length > longest)) return;
    const Vec3& n = normal_[level_.face(o)];
    if (!(dot(n, n) > 0)) return;
    longest = length;
    result = n;
  });
  return result;
}

// the faces' side of each surface
inline void Surface_tags::set_sides(const Part& part)
{
  std::vector<double> sums(shapes_.size(), 0);
  for (Index f = 0; f < level_.number_of_faces(); ++f) {
    if (!is_known(f)) continue;
    Vec3 mean;
    double n = 0;
    for_each_halfedge_of_face(level_, f, [&](Index h) {
      mean += point_[level_.target(h)];
      ++n;
    });
    sums[patch_[f]] +=
      dot(part.area[part.rank_of_face[f]], shapes_[patch_[f]].normal((1 / n) * mean));
  }
  for (const double s : sums) side_.push_back(s < 0 ? -1 : 1);
}

} // namespace CGAL::PN_subdivision_3::internal::recognition

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_RECOGNITION_3_INTERNAL_RECOGNITION_INTERFACE_H
#define CGAL_PN_RECOGNITION_3_INTERNAL_RECOGNITION_INTERFACE_H

#include <CGAL/PN_recognition_3/internal/linear_algebra.h>
#include <CGAL/PN_recognition_3/surfaces/Recognized_surface.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

// Recognition is compiled where it is included, or once in the library CGAL::PN_subdivision_3_recognition. What is declared
// here is inline or not, the rest of its sources always.
#ifdef CGAL_PN_SUBDIVISION_3_RECOGNITION
#  define CGAL_PN_RECOGNITION_3_INLINE
#else
#  define CGAL_PN_RECOGNITION_3_INLINE inline
#endif

namespace CGAL::PN_subdivision_3::internal::recognition {

using Index = Level_connectivity::Index;
using Kind = Recognized_surface::Kind;

// What is asked about a kind of surface. Here, and in the switches over kinds, which have no default, the compiler tells
// of a new kind that has no answer yet.
struct Kind_facts
{
  bool turns_about_axis = false, is_ruled = false, is_doubly_curved = false, has_tube = false;
  int unknowns = 0;             // of fit_shape()
  std::size_t least_points = 0; // that it is fitted to
  int rank = 0;                 // of regions that are alike the one of the least rank is taken

  constexpr bool is_round() const { return is_ruled || is_doubly_curved; }
};

constexpr Kind_facts facts_of(Kind kind)
{
  switch (kind) {
  case Kind::unknown:
  case Kind::plane:
    break;
  case Kind::cylinder:
    return {true, true, false, false, 5, 6, 0};
  case Kind::sphere:
    return {false, false, true, false, 4, 5, 1};
  case Kind::cone:
    return {true, true, false, false, 6, 7, 2};
  case Kind::torus:
    return {true, false, true, true, 7, 9, 3};
  }
  return {};
}

// the coordinates of a point about an axis
struct Cylindrical
{
  double rho = 0, z = 0;
  Vec3 outward; // unit, zero on the axis
};
Cylindrical cylindrical(const Vec3& p, const Vec3& center, const Vec3& axis);

// A surface in the frame of the part. The cone is (rho - radius) cos(angle) = z sin(angle), with its center on the axis
// among the vertices and not in its apex, which may be far away.
struct Shape
{
  Kind kind = Kind::unknown;
  Vec3 center, axis;
  double radius = 0, tube = 0;
  double angle = 0, cosine = 1, sine = 0; // of a cone, by set_angle()

  void set_angle(double x);
  Cylindrical local(const Vec3& p) const { return cylindrical(p, center, axis); }
  Vec3 apex() const { return center - (radius / std::tan(angle)) * axis; }

  // sets where p is about the axis of a shape that turns about it
  double distance(const Vec3& p, Cylindrical& q) const;
  // the gradient of the distance; zero where there is none
  Vec3 normal(const Vec3& p, const Cylindrical& q) const;

  double distance(const Vec3& p) const
  {
    Cylindrical q;
    return distance(p, q);
  }
  Vec3 normal(const Vec3& p) const
  {
    return normal(p, facts_of(kind).turns_about_axis ? local(p) : Cylindrical());
  }
  // of a shape that has a tube, where the point is on the circle of the tube
  double meridian_angle(const Vec3& p) const;
};

// a shape in another frame, x -> scale x + shift, in terms that have a meaning for users
Recognized_surface as_surface(const Shape& s, double scale, const Vec3& shift);
// and back
Shape as_shape(const Recognized_surface& surface, double scale, const Vec3& shift);

// How far the numbers of a file may be from what was meant: it holds floats, or decimals of few digits, or else `double`s
// with what computations have left in them.
double file_rounding(const std::vector<double>& x);

// --- surfaces of a mesh ---

using Points = std::vector<std::array<double, 3>>;

struct Found_surfaces
{
  std::vector<Recognized_surface> surfaces;
  std::vector<Index> surface_of_face;
};
// a tolerance of 0 is chosen
Found_surfaces find_surfaces(const Level_connectivity& level, const Points& points,
                             double tolerance, unsigned min_facets);

struct Part;

// What follows from the surface of each face: creases, corners, and normals of corners of faces.
class Surface_tags
{
public:
  Surface_tags(const Level_connectivity& level, const Points& points, double tolerance,
               const std::vector<Recognized_surface>& surfaces, std::vector<std::size_t> patches,
               double sharp_angle);

  bool is_crease(Index e) const;
  // the apex of a cone
  bool is_corner(Index v) const;
  // whether all faces at a vertex are of unknown surfaces
  bool is_unknown(Index v) const;
  // the normal of the corner of face(h) at target(h); zero: none
  Vec3 normal(Index h) const;

private:
  bool is_known(Index f) const { return shapes_[patch_[f]].kind != Kind::unknown; }
  bool is_apex(Index h) const;
  void set_face_normals(const Part& part);
  Vec3 normal_of_neighbor(Index f) const;
  void set_sides(const Part& part);

  const Level_connectivity& level_;
  std::vector<std::size_t> patch_;
  double sharp_angle_, tolerance_ = 0;
  std::vector<Vec3> point_;
  std::vector<Shape> shapes_;
  std::vector<Vec3> normal_;
  std::vector<int> side_;
};

// --- lines and arcs of a polygon ---

// A polygon in coordinates of its plane, scaled to its box. In space more turns are to the left than to the right.
class Plane_of_polygon
{
public:
  using Point = std::array<double, 2>;

  // a tolerance of 0 is chosen
  template <std::size_t dimension>
  Plane_of_polygon(const std::vector<std::array<double, dimension>>& points, bool closed,
                   double tolerance)
  {
    std::vector<Vec3> p;
    for (const auto& q : points) p.push_back({q[0], q[1], dimension == 3 ? q[dimension - 1] : 0});
    set(std::move(p), dimension == 3, closed, tolerance);
  }

  const std::vector<Point>& points() const { return points_; }
  double tolerance() const { return tolerance_; }
  double scale() const { return scale_; }
  std::array<double, 3> in_space(const Point& p) const;
  Point in_plane(const std::array<double, 3>& p) const;
  std::array<double, 3> direction_in_space(const Point& d) const;

private:
  void set(std::vector<Vec3> p, bool is_in_space, bool closed, double tolerance);
  void scale(std::vector<Vec3>& p);
  void find_plane(const std::vector<Vec3>& p, bool closed);

  Vec3 origin_, u_{1, 0, 0}, v_{0, 1, 0};
  double scale_ = 1, tolerance_ = 0, height_ = 0;
  std::vector<Point> points_;
};

// Edges first, ..., last - 1 of a polygon, in a numbering that goes on behind the end of a closed one.
struct Arc_run
{
  enum class Kind { unknown, line, circle };
  Kind kind = Kind::unknown;
  std::ptrdiff_t first = 0, last = 0;
  std::array<double, 2> center{};    // of a line a point of it
  std::array<double, 2> direction{}; // of a line
  double radius = 0, residual = 0, widest = 0;

  std::ptrdiff_t edges() const { return last - first; }
};

// from the first corner on; a closed polygon that is one piece begins at 0. Points without repeated neighbors.
std::vector<Arc_run> find_arcs(std::vector<std::array<double, 2>> points, bool closed,
                               double tolerance, unsigned min_facets);

} // namespace CGAL::PN_subdivision_3::internal::recognition

#endif // CGAL_PN_RECOGNITION_3_INTERNAL_RECOGNITION_INTERFACE_H

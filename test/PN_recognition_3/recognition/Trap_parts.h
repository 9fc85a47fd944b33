// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef PN_TEST_TRAP_PARTS_H
#define PN_TEST_TRAP_PARTS_H

// Parts that have misled recognition.

#include "Named_parts.h"

namespace synthetic_parts {

inline Part turned_part(const std::string& name, const Chain& profile, int n,
                        bool are_triangles = true)
{
  return swept(name, 5, circle(0, 0, 0, steps(n), false, 0.1), profile, are_triangles);
}

// from the plane z = 0 up, with flat ends
inline Part straight_part(const std::string& name, unsigned seed, const Chain& outline,
                          double height)
{
  return swept(name, seed, outline, Chain(0, 0).line_to(0, height));
}

// the end of the sphere is a plane, all corners of which are on the sphere
inline Part zone_of_a_sphere(int n, bool are_triangles)
{
  const Chain profile =
    Chain(1, 0).line_to(1, 1).arc(0, 1, 60, steps(4)); // 60 degrees: not to the pole
  return turned_part("zone of a sphere", profile, n, are_triangles);
}

// An octahedron whose triangles are split into four, all vertices on a sphere.
inline Part geodesic_ball(int splits)
{
  Part part;
  part.name = "geodesic ball";
  part.surfaces = {{Kind::sphere, {}, {}, 1, 0, 0}};
  part.points = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  part.faces = {{0, 1, 2}, {1, 3, 2}, {3, 4, 2}, {4, 0, 2},
                {1, 0, 5}, {3, 1, 5}, {4, 3, 5}, {0, 4, 5}};
  for (; splits > 0; --splits) {
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> middles;
    const auto middle = [&](std::size_t a, std::size_t b) {
      const auto [it, is_new] = middles.try_emplace(std::minmax(a, b), part.points.size());
      if (is_new) part.points.push_back(unit(part.points[a] + part.points[b]));
      return it->second;
    };
    std::vector<std::vector<std::size_t>> faces;
    for (const auto& f : part.faces) {
      const std::size_t p = middle(f[0], f[1]), q = middle(f[1], f[2]), r = middle(f[2], f[0]);
      faces.insert(faces.end(), {{f[0], p, r}, {p, f[1], q}, {r, q, f[2]}, {p, q, r}});
    }
    part.faces = faces;
  }
  part.surface_of_face.assign(part.faces.size(), 0);
  return part;
}

// `flat`: length of the face between two fillets of three facets each
inline Part narrow_plate(double flat, int facets)
{
  return straight_part("narrow plate", 6,
                       rounded_rectangle(0, 0, 3, 0.8 + flat, 0.4, steps(facets)), 0.7);
}

// cut off by a plane
inline Part oblique_cylinder(int n, double slope)
{
  Part part;
  part.name = "cylinder with an oblique end";
  part.surfaces = {{Kind::cylinder, {}, {0, 0, 1}, 0.5, 0, 0},
                   {Kind::plane, {}, {0, 0, -1}, 0, 0, 0},
                   {Kind::plane, {0, 0, 2}, unit({-slope, 0, 1}), 0, 0, 0}};
  std::vector<std::size_t> low, high;
  for (int i = 0; i < n; ++i) {
    const double t = 2 * pi * i / n, x = 0.5 * std::cos(t), y = 0.5 * std::sin(t);
    low.push_back(part.points.size());
    part.points.push_back({x, y, 0});
    high.push_back(part.points.size());
    part.points.push_back({x, y, 2 + slope * x});
  }
  for (std::size_t i = 0; i < low.size(); ++i) {
    const std::size_t k = (i + 1) % low.size();
    part.faces.push_back({low[i], low[k], high[k], high[i]});
  }
  part.surface_of_face.assign(part.faces.size(), 0);
  part.faces.push_back({low.rbegin(), low.rend()});
  part.faces.push_back(high);
  part.surface_of_face.insert(part.surface_of_face.end(), {1, 2});
  return part;
}

// In a plate: half a hexagon, its left side going on in a wall.
inline Part open_nut_trap()
{
  const double s = std::sqrt(0.75);
  const Chain outline = polygon(
    {{-2, -2}, {2.5, -2}, {2.5, 0}, {1, 0}, {0.5, -s}, {-0.5, -s}, {-1, 0}, {-1, 1.5}, {-2, 1.5}});
  return straight_part("open nut trap", 7, outline, 1);
}

// half a turn of three facets, both walls tangent
inline Part open_slot()
{
  const Chain outline = Chain(-2, -2)
                          .line_to(2.5, -2)
                          .line_to(2.5, 1.5)
                          .line_to(1, 1.5)
                          .line_to(1, 0)
                          .arc(0, 0, -180, steps(3))
                          .line_to(-1, 1.5)
                          .line_to(-2, 1.5)
                          .line_to(-2, -2)
                          .close();
  return straight_part("open slot", 8, outline, 1);
}

// The flat's corners are on the cylinder.
inline Part shaft_with_flat(int n, double chord)
{
  const int facets = static_cast<int>(std::lround(n * (360 - chord) / 360));
  const Chain outline = Chain(1, 0).arc(0, 0, 360 - chord, steps(facets)).line_to(1, 0).close();
  return straight_part("shaft with a flat", 11, outline, 2);
}

// The disc at its end is tangent to the fillet.
inline Part rounded_stub(int n, int quarter)
{
  return turned_part("rounded stub", Chain(1, 0).line_to(1, 1).arc(0.7, 1, 90, steps(quarter)), n);
}

// A groove of half a circle: the angles about the tube's center go beyond pi.
inline Part grooved_shaft(int n, int half)
{
  return turned_part("grooved shaft",
                     Chain(1, 0).line_to(1, 1).arc(1, 1.3, -180, steps(half)).line_to(1, 2.6), n);
}

// with a hole about (0.9, 0.8), to the bottom if it is no point there
inline Part plate_with(const std::string& name, unsigned seed, double radius, int n,
                       const Chain& profile)
{
  Random random(seed);
  Part_builder b(name, random);
  const auto side =
    b.sweep(polygon({{0, 0}, {2, 0}, {2, 1.5}, {0, 1.5}}), Chain(0, 0).line_to(0, 1));
  const auto hole = b.sweep(circle(0.9, 0.8, radius, steps(n), true), profile);
  std::vector<Rim> bottom{side.start};
  if (hole.start.size() > 2) bottom.push_back(hole.start);
  b.cap(bottom);
  b.cap({side.end, hole.end});
  return b.take();
}

inline Part plate_with_drilled_hole(int n)
{
  return plate_with("plate with a drilled hole", 9, 0.3, n,
                    Chain(0.3, 0.2).line_to(0, 0.35).line_to(0, 1));
}

inline Part plate_with_hole(int n)
{
  return plate_with("plate with a hole", 10, 0.4, n, Chain(0, 0).line_to(0, 1));
}

// A facet of altitude 0 along an edge between faces of these kinds: a vertex in the middle of the edge, on the side of the first kind
// only. Says which face it is; its truth is the first surface.
inline std::size_t insert_sliver(Part& part, Kind first, Kind second)
{
  const Edge_faces faces = halfedges(part);
  for (const auto& [edge, f] : faces) {
    const auto [a, b] = edge;
    const std::size_t g = faces.at({b, a}), s = part.surface_of_face[f];
    if (part.surfaces[s].kind != first || part.surfaces[part.surface_of_face[g]].kind != second ||
        s == part.surface_of_face[g])
      continue;
    const std::vector<std::size_t> face = part.faces[f];
    const std::size_t c = face[0] != a && face[0] != b   ? face[0]
                          : face[1] != a && face[1] != b ? face[1]
                                                         : face[2];
    const std::size_t m = part.points.size();
    part.points.push_back(0.5 * (part.points[a] + part.points[b]));
    part.faces[f] = {a, m, c};
    part.faces.push_back({m, b, c});
    part.faces.push_back({a, b, m});
    part.surface_of_face.insert(part.surface_of_face.end(), 2, s);
    check_closed(part);
    return part.faces.size() - 1;
  }
  throw std::logic_error("no such edge");
}

// of radius 1 at z = 0 and `top` at `height`
inline True_surface round_side(double top, double height)
{
  if (top == 1) return {Kind::cylinder, {}, {0, 0, 1}, 1, 0, 0};
  const double slope = (1 - top) / height;
  return {Kind::cone, {0, 0, 1 / slope},         {0, 0, slope > 0 ? -1. : 1.}, 0,
          0,          std::atan(std::abs(slope))};
}

// A cylinder or frustum of n facets from which the plane x = at has cut a piece off, not at rulings: vertices on chords.
inline Part cut_at_side(int n, double top, double at)
{
  Convex_builder b;
  b.add_plane({0, 0, -1}, {0, 0, 0});
  b.add_plane({0, 0, 1}, {0, 0, 1});
  const std::size_t side = b.add(round_side(top, 1));
  for (int i = 0; i < n; ++i) {
    const double t = 2 * pi * (i + 0.5) / n, r = std::cos(pi / n);
    b.add_facet({std::cos(t), std::sin(t), r * (1 - top)}, {r * std::cos(t), r * std::sin(t), 0},
                side);
  }
  b.add_plane({1, 0, 0}, {at, 0, 0});
  return b.take("cut at a side", false);
}

// At either side a plane has cut two facets, and has left their end chords in the middle.
inline Part bitten_cylinder(int n)
{
  Convex_builder b;
  b.add_plane({0, 0, -1}, {0, 0, 0});
  b.add_plane({0, 0, 1}, {0, 0, 5});
  b.add_fillet(0, 0, 1, 0, 360, n);
  const double at = (1 + std::cos(2 * pi / n)) / 2;
  for (const double side : {-1., 1.}) b.add_plane({side, 0, 1}, {side * at, 0, 5});
  return b.take("bitten cylinder", false);
}

// As openscad writes frusta, and cylinders that it has turned: two triangles a facet, with a vertex in the middle of each chord
// where a plane has cut them.
inline Part cut_between_circles(int n, double top, double height, double slope)
{
  const Vec middle{0, 0, height / 2}, normal = unit({-slope, 0, 1});
  Part part;
  part.name = "cut between circles";
  part.surfaces = {{Kind::plane, {}, {0, 0, -1}, 0, 0, 0},
                   {Kind::plane, middle, normal, 0, 0, 0},
                   round_side(top, height)};
  const auto on_circle = [&](std::size_t i, double r, double z) {
    const double t = 2 * pi * static_cast<double>(i) / n;
    return Vec{r * std::cos(t), r * std::sin(t), z};
  };
  const auto cut = [&](const Vec& p, const Vec& q) {
    const double a = dot(normal, middle - p), b = dot(normal, q - p);
    return p + (a / b) * (q - p);
  };
  std::vector<std::size_t> low, high;
  for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) {
    const Vec p = on_circle(i, 1, 0);
    part.points.insert(part.points.end(), {p, cut(p, on_circle(i, top, height)),
                                           cut(p, on_circle(i + 1, top, height))});
    low.push_back(3 * i);
    high.insert(high.end(), {3 * i + 1, 3 * i + 2});
  }
  part.faces = {{low.rbegin(), low.rend()}, high};
  for (std::size_t i = 0; i < low.size(); ++i) {
    const std::size_t k = (i + 1) % low.size();
    part.faces.push_back({low[i], low[k], high[2 * k], high[2 * i + 1]});
    part.faces.push_back({low[i], high[2 * i + 1], high[2 * i]});
  }
  part.surface_of_face.assign(part.faces.size(), 2);
  part.surface_of_face[0] = 0;
  part.surface_of_face[1] = 1;
  check_closed(part);
  return part;
}

} // namespace synthetic_parts

#endif // PN_TEST_TRAP_PARTS_H

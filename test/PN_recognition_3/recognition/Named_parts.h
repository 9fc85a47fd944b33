// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef PN_TEST_NAMED_PARTS_H
#define PN_TEST_NAMED_PARTS_H

// Parts with known counts of surfaces.

#include "Part_builder.h"

namespace synthetic_parts {

// closed where it does not end in a point
inline Part swept(const std::string& name, unsigned seed, const Chain& outline,
                  const Chain& profile, bool are_triangles = true)
{
  Random random(seed);
  Part_builder b(name, random, are_triangles);
  const auto side = b.sweep(outline, profile);
  for (const Rim& rim : {side.start, side.end})
    if (rim.size() > 2) b.cap({rim});
  return b.take();
}

inline Part regular_prism(int n, double top = 1) // top: the inner radius there over that below
{
  return swept("prism of " + std::to_string(n) + " sides", 1, regular_polygon(n, 0, 0, 1),
               Chain(0, 0).line_to((top - 1) * std::cos(pi / n), 0.8));
}

// of n sides on a shank of m, its end chamfered
inline Part bolt(int n, int m, double shank = 0.5)
{
  Random random(2);
  Part_builder b("bolt", random);
  const auto head = b.sweep(regular_polygon(n, 0, 0, 1), Chain(0, 0).line_to(0, 0.6));
  const auto end =
    b.sweep(circle(0, 0, shank, steps(m)), Chain(0, 0.6).line_to(0, 2.4).line_to(-0.1, 2.5));
  b.cap({head.start});
  b.cap({head.end, end.start});
  b.cap({end.end});
  return b.take();
}

// all of n sides: a prism with a chamfer and a bore
inline Part bored_prism(int n)
{
  Random random(3);
  Part_builder b("bored prism", random);
  const auto side =
    b.sweep(regular_polygon(n, 0, 0, 1), Chain(0, 0).line_to(0, 1.8).line_to(-0.2, 2));
  const auto bore = b.sweep(regular_polygon(n, 0, 0, 0.4, true), Chain(0, 0).line_to(0, 2));
  b.cap({side.start, bore.start});
  b.cap({side.end, bore.end});
  return b.take();
}

// from (x0, y0) to (x1, y1), radius r, counterclockwise
inline Chain rounded_rectangle(double x0, double y0, double x1, double y1, double r,
                               const std::vector<double>& at)
{
  return Chain(x0 + r, y0)
    .line_to(x1 - r, y0)
    .arc(x1 - r, y0 + r, 90, at)
    .line_to(x1, y1 - r)
    .arc(x1 - r, y1 - r, 90, at)
    .line_to(x0 + r, y1)
    .arc(x0 + r, y1 - r, 90, at)
    .line_to(x0, y0 + r)
    .arc(x0 + r, y0 + r, 90, at)
    .close();
}

inline Part rounded_box(const Vec& size, double r, const std::vector<double>& across,
                        const std::vector<double>& up, Random& random)
{
  Part_builder b("rounded box", random);
  const auto side =
    b.sweep(rounded_rectangle(0, 0, size[0], size[1], r, across),
            Chain(-r, 0).arc(-r, r, 90, up).line_to(0, size[2] - r).arc(-r, size[2] - r, 90, up));
  b.cap({side.start});
  b.cap({side.end});
  return b.take();
}

// n sides, two diameters, a rounded shoulder, both ends chamfered
inline Part shaft(int n, int quarter)
{
  return swept("shaft", 4, circle(0, 0, 0, steps(n)),
               Chain(0.9, 0)
                 .line_to(1, 0.1)
                 .line_to(1, 1.8)
                 .arc(0.8, 1.8, 90, steps(quarter))
                 .line_to(0.5, 2)
                 .line_to(0.5, 2.9)
                 .line_to(0.4, 3));
}

inline Part elbow(const std::vector<double>& around, const std::vector<double>& bend, double angle,
                  double inner, Random& random, double from = 0)
{
  Part_builder b("elbow", random);
  const Elbow e{1.2, 0.9, 1.5, angle, bend};
  const auto out = e.add_to(b, circle(0, 0, 0.5, around, false, from));
  std::vector<Rim> first{out.start}, last{out.end};
  if (inner > 0) {
    const auto in = e.add_to(b, circle(0, 0, inner, around, true, from));
    first.push_back(in.start);
    last.push_back(in.end);
  }
  b.cap(first, e.frame(0));
  b.cap(last, e.frame(bend.size() + 1));
  return b.take();
}

// --- convex parts: where half spaces meet ---

struct Half_space // normal * x <= offset
{
  Vec normal;
  double offset;
  std::size_t surface;
};

class Convex_builder
{
public:
  std::size_t add(const True_surface& s)
  {
    part_.surfaces.push_back(s);
    return part_.surfaces.size() - 1;
  }
  void add_plane(const Vec& normal, const Vec& point)
  {
    True_surface s;
    s.point = point;
    s.direction = unit(normal);
    add_facet(s.direction, point, add(s));
  }
  void add_facet(const Vec& normal, const Vec& point, std::size_t surface)
  {
    half_spaces_.push_back({unit(normal), dot(unit(normal), point), surface});
  }
  // a fillet about the z-axis through (x, y): from angle `from` on, `sweep`, n facets
  void add_fillet(double x, double y, double r, double from, double sweep, int n)
  {
    const std::size_t s = add({Kind::cylinder, {x, y, 0}, {0, 0, 1}, r, 0, 0});
    for (int i = 0; i < n; ++i) {
      const double t = (from + sweep * (i + 0.5) / n) * pi / 180;
      const double h = r * std::cos(sweep / n / 2 * pi / 180);
      const Vec normal{std::cos(t), std::sin(t), 0};
      add_facet(normal, Vec{x, y, 0} + h * normal, s);
    }
  }
  // polygons; the truth is checked unless vertices may be on chords
  Part take(const std::string& name, bool are_on_surfaces = true)
  {
    part_.name = name;
    for (std::size_t i = 0; i < half_spaces_.size(); ++i) add_face(i);
    check_closed(part_);
    if (are_on_surfaces) check_truth(part_);
    return part_;
  }

private:
  void add_face(std::size_t i)
  {
    std::vector<std::size_t> face;
    for (std::size_t j = 0; j < half_spaces_.size(); ++j)
      for (std::size_t k = j + 1; k < half_spaces_.size(); ++k)
        if (j != i && k != i) add_corner(i, j, k, face);
    if (face.size() < 3) return;
    Vec c{}, u, n = half_spaces_[i].normal;
    for (std::size_t v : face) c = c + (1. / static_cast<double>(face.size())) * part_.points[v];
    u = part_.points[face[0]] - c;
    const auto angle = [&](std::size_t v) {
      const Vec d = part_.points[v] - c;
      return std::atan2(dot(d, cross(n, u)), dot(d, u));
    };
    std::sort(face.begin(), face.end(),
              [&](std::size_t a, std::size_t b) { return angle(a) < angle(b); });
    part_.faces.push_back(face);
    part_.surface_of_face.push_back(half_spaces_[i].surface);
  }

  void add_corner(std::size_t i, std::size_t j, std::size_t k, std::vector<std::size_t>& face)
  {
    const Half_space &a = half_spaces_[i], &b = half_spaces_[j], &c = half_spaces_[k];
    const double det = dot(a.normal, cross(b.normal, c.normal));
    if (std::abs(det) < 1e-9) return;
    const Vec p =
      (1 / det) * (a.offset * cross(b.normal, c.normal) + b.offset * cross(c.normal, a.normal) +
                   c.offset * cross(a.normal, b.normal));
    for (const Half_space& h : half_spaces_)
      if (dot(h.normal, p) > h.offset + 1e-9) return;
    std::size_t v = 0;
    while (v < part_.points.size() && length(part_.points[v] - p) > 1e-9) ++v;
    if (v == part_.points.size()) part_.points.push_back(p);
    if (std::find(face.begin(), face.end(), v) == face.end()) face.push_back(v);
  }

  std::vector<Half_space> half_spaces_;
  Part part_;
};

// three chamfers meet at the end of the box that has no fillets
inline Part box_with_fillets_and_chamfers()
{
  Convex_builder b;
  b.add_plane({0, 0, -1}, {0, 0, 0});
  b.add_plane({0, 0, 1}, {0, 0, 1.5});
  b.add_plane({-1, 0, 0}, {0, 0, 0});
  b.add_plane({1, 0, 0}, {3, 0, 0});
  b.add_plane({0, -1, 0}, {0, 0, 0});
  b.add_plane({0, 1, 0}, {0, 2, 0});
  b.add_plane({-1, 0, 1}, {0, 0, 1.3});   // along y, across the other two chamfers
  b.add_plane({-1, -1, 0}, {0.25, 0, 0}); // along z
  b.add_plane({-1, 1, 0}, {0.4, 2, 0});   // along z
  b.add_fillet(2.5, 0.5, 0.5, -90, 90, 6);
  b.add_fillet(2.3, 1.3, 0.7, 0, 90, 8);
  return b.take("box with two fillets and three chamfers");
}

} // namespace synthetic_parts

#endif // PN_TEST_NAMED_PARTS_H

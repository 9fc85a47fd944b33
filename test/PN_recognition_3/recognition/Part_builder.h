// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef PN_TEST_PART_BUILDER_H
#define PN_TEST_PART_BUILDER_H

// Parts from outlines and profiles, both of lines and arcs: a profile (d, z) says how far the outline is
// moved outward at which height. An outline that is a circle of radius 0 makes a surface of revolution.

#include "Polygon_triangles.h"
#include "Synthetic_part.h"

namespace synthetic_parts {

// where the steps of an arc end, as fractions of it: `unevenness` 0 for equal ones
inline std::vector<double> steps(int n, double unevenness, Random& random)
{
  std::vector<double> s{0};
  for (int i = 0; i < n; ++i) s.push_back(s.back() + 1 + random(-unevenness, unevenness));
  for (double& x : s) x /= s.back();
  return s;
}
inline std::vector<double> steps(int n)
{
  std::vector<double> s;
  for (int i = 0; i <= n; ++i) s.push_back(static_cast<double>(i) / n);
  return s;
}

// Lines and arcs in the plane, one after the other. The normal is to the right.
struct Chain
{
  using Vec2 = std::array<double, 2>;
  struct Piece
  {
    bool is_arc;
    Vec2 point, normal;   // of a line
    Vec2 center;          // of an arc, whose points are center + signed_radius * normal
    double signed_radius; // > 0: counterclockwise
  };
  std::vector<Vec2> points, normals; // of an outline: by which the offset moves the point
  std::vector<std::size_t> piece_of_edge;
  std::vector<Piece> pieces;

  Chain() = default;
  Chain(double x, double y)
    : points{{x, y}}
  {}

  Chain& line_to(double x, double y, const std::vector<double>& at = {0, 1})
  {
    const Vec2 p = points.back(), q{x, y};
    const double l = std::hypot(x - p[0], y - p[1]);
    pieces.push_back({false, p, {(y - p[1]) / l, (p[0] - x) / l}, {}, 0});
    for (std::size_t i = 1; i < at.size(); ++i)
      add({p[0] + at[i] * (q[0] - p[0]), p[1] + at[i] * (q[1] - p[1])});
    points.back() = q;
    return *this;
  }
  // `sweep` in degrees, > 0 counterclockwise
  Chain& arc(double x, double y, double sweep, const std::vector<double>& at)
  {
    const double dx = points.back()[0] - x, dy = points.back()[1] - y;
    const double r = std::hypot(dx, dy), from = std::atan2(dy, dx);
    pieces.push_back({true, {}, {}, {x, y}, sweep > 0 ? r : -r});
    for (std::size_t i = 1; i < at.size(); ++i) {
      const double t = from + at[i] * sweep * pi / 180;
      add({x + r * std::cos(t), y + r * std::sin(t)});
    }
    return *this;
  }
  // the outline ends where it begins: miters at its corners
  Chain& close()
  {
    const std::size_t n = points.size() - 1;
    if (std::hypot(points[n][0] - points[0][0], points[n][1] - points[0][1]) > 1e-9)
      throw std::logic_error("open outline");
    points.pop_back();
    for (std::size_t i = 0; i < n; ++i) {
      const Vec2 a = normal_at((i + n - 1) % n, points[i]), b = normal_at(i, points[i]);
      const double c = 1 + a[0] * b[0] + a[1] * b[1];
      normals.push_back({(a[0] + b[0]) / c, (a[1] + b[1]) / c});
    }
    return *this;
  }
  Vec2 normal_at(std::size_t edge, const Vec2& p) const
  {
    const Piece& s = pieces[piece_of_edge[edge]];
    if (!s.is_arc) return s.normal;
    return {(p[0] - s.center[0]) / s.signed_radius, (p[1] - s.center[1]) / s.signed_radius};
  }

private:
  void add(const Vec2& p)
  {
    points.push_back(p);
    piece_of_edge.push_back(pieces.size() - 1);
  }
};

// a circle, closed; `is_hole`: clockwise
inline Chain circle(double x, double y, double r, const std::vector<double>& at,
                    bool is_hole = false, double from = 0)
{
  Chain c;
  const double sign = is_hole ? -1 : 1;
  c.pieces.push_back({true, {}, {}, {x, y}, sign * r});
  for (std::size_t i = 0; i + 1 < at.size(); ++i) {
    const double t = from + sign * 2 * pi * at[i];
    c.points.push_back({x + r * std::cos(t), y + r * std::sin(t)});
    c.normals.push_back({sign * std::cos(t), sign * std::sin(t)});
    c.piece_of_edge.push_back(0);
  }
  return c;
}

// the polygon through points, closed
inline Chain polygon(const std::vector<std::array<double, 2>>& p)
{
  Chain c(p[0][0], p[0][1]);
  for (std::size_t i = 1; i <= p.size(); ++i) c.line_to(p[i % p.size()][0], p[i % p.size()][1]);
  return c.close();
}
inline Chain regular_polygon(int n, double x, double y, double r, bool is_hole = false,
                             double from = 0)
{
  std::vector<std::array<double, 2>> p;
  for (int i = 0; i < n; ++i) {
    const double t = from + (is_hole ? -1 : 1) * 2 * pi * i / n;
    p.push_back({x + r * std::cos(t), y + r * std::sin(t)});
  }
  return polygon(p);
}

class Part_builder
{
public:
  using Ids = std::vector<std::size_t>;
  struct Side // of a part
  {
    Rim start, end; // as a cap there goes round them
  };

  // `are_triangles`: all faces are; else what is plane may be a polygon
  Part_builder(const std::string& name, Random& random, bool are_triangles = true)
    : random_(random)
    , are_triangles_(are_triangles)
  {
    part_.name = name;
  }

  Side sweep(const Chain& outline, const Chain& profile)
  {
    const std::size_t n = outline.points.size();
    std::vector<Ids> rings;
    for (const auto& [d, z] : profile.points) {
      std::vector<Vec> ring;
      for (std::size_t i = 0; i < n; ++i)
        ring.push_back({outline.points[i][0] + d * outline.normals[i][0],
                        outline.points[i][1] + d * outline.normals[i][1], z});
      rings.push_back(add_ring(ring));
    }
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> ids;
    for (std::size_t j = 0; j + 1 < rings.size(); ++j)
      for (std::size_t i = 0; i < n; ++i) {
        const std::size_t a = outline.piece_of_edge[i], b = profile.piece_of_edge[j];
        const True_surface s = surface(outline.pieces[a], profile.pieces[b]);
        const bool is_level = s.kind == Kind::plane && std::abs(s.direction[2]) > 1 - 1e-12;
        const auto key = std::make_pair(is_level ? outline.pieces.size() : a, b);
        if (ids.count(key) == 0) ids[key] = add(s);
        add_quad(rings, j, i, ids[key]);
      }
    return {rim(rings.front(), true), rim(rings.back(), false)};
  }

  // a level plane with these rims
  void cap(const std::vector<Rim>& rims) { cap(rims, Pose()); }

  // the rims' coordinates are those before `pose`
  void cap(std::vector<Rim> rims, const Pose& pose)
  {
    double area = 0;
    for (const Rim& r : rims) area += area_of(r);
    const double sign = area > 0 ? 1 : -1;
    True_surface s;
    s.point = part_.points[rims[0][0].vertex];
    s.direction = sign * pose.turned({0, 0, 1});
    const std::size_t id = add(s);
    if (!are_triangles_ && rims.size() == 1) {
      Ids face;
      for (const Rim_corner& c : rims[0]) face.push_back(c.vertex);
      add_face(face, id);
      return;
    }
    for (Rim& r : rims)
      for (Rim_corner& c : r) c.y *= sign;
    const Polygon_triangles triangles(rims, static_cast<std::size_t>(random_.integer(0, 1000)));
    for (const auto& t : triangles.triangles()) add_face({t[0], t[1], t[2]}, id);
  }

  // --- for other builders ---
  Ids add_ring(const std::vector<Vec>& ring) // neighbors in one place are one
  {
    Ids ids;
    for (std::size_t i = 0; i < ring.size(); ++i)
      if (i > 0 && length(ring[i] - ring[i - 1]) < 1e-9)
        ids.push_back(ids.back());
      else {
        ids.push_back(part_.points.size());
        part_.points.push_back(ring[i]);
      }
    if (ids.back() != ids[0] && length(ring.back() - ring[0]) < 1e-9) {
      part_.points.pop_back();
      std::replace(ids.begin(), ids.end(), std::size_t(ids.back()), std::size_t(ids[0]));
    }
    return ids;
  }
  std::size_t add(const True_surface& s)
  {
    part_.surfaces.push_back(s);
    return part_.surfaces.size() - 1;
  }
  void add_quad(const std::vector<Ids>& rings, std::size_t j, std::size_t i, std::size_t surface)
  {
    const std::size_t k = (i + 1) % rings[j].size();
    Ids face;
    for (std::size_t v : {rings[j][i], rings[j][k], rings[j + 1][k], rings[j + 1][i]})
      if (std::find(face.begin(), face.end(), v) == face.end()) face.push_back(v);
    if (face.size() < 3) return;
    if (!are_triangles_ || face.size() == 3) return add_face(face, surface);
    if (random_.chance(0.5)) std::rotate(face.begin(), face.begin() + 1, face.end());
    add_face({face[0], face[1], face[2]}, surface);
    add_face({face[0], face[2], face[3]}, surface);
  }
  void add_face(const Ids& face, std::size_t surface)
  {
    part_.faces.push_back(face);
    part_.surface_of_face.push_back(surface);
  }

  // the part, checked; surfaces that have collapsed are left out
  Part take()
  {
    std::vector<std::size_t> to(part_.surfaces.size(), part_.surfaces.size());
    std::vector<True_surface> used;
    for (std::size_t& s : part_.surface_of_face) {
      if (to[s] == part_.surfaces.size()) {
        to[s] = used.size();
        used.push_back(part_.surfaces[s]);
      }
      s = to[s];
    }
    part_.surfaces = used;
    check_closed(part_);
    check_truth(part_);
    return part_;
  }

private:
  Rim rim(const Ids& ring, bool is_start) const
  {
    Rim r;
    for (std::size_t v : ring)
      if (r.empty() || (r.back().vertex != v && r.front().vertex != v))
        r.push_back({v, part_.points[v][0], part_.points[v][1]});
    if (is_start) std::reverse(r.begin(), r.end());
    return r;
  }

  static True_surface surface(const Chain::Piece& a, const Chain::Piece& b)
  {
    True_surface s;
    if (!a.is_arc) {
      const double d = b.is_arc ? b.center[0] : b.point[0], z = b.is_arc ? b.center[1] : b.point[1];
      s.point = {a.point[0] + d * a.normal[0], a.point[1] + d * a.normal[1], z};
      s.kind = b.is_arc ? Kind::cylinder : Kind::plane;
      s.radius = std::abs(b.signed_radius);
      if (b.is_arc)
        s.direction = {-a.normal[1], a.normal[0], 0};
      else
        s.direction = {b.normal[0] * a.normal[0], b.normal[0] * a.normal[1], b.normal[1]};
      return s;
    }
    s.point = {a.center[0], a.center[1], b.is_arc ? b.center[1] : b.point[1]};
    s.direction = {0, 0, 1};
    const double r = a.signed_radius + (b.is_arc ? b.center[0] : b.point[0]);
    if (b.is_arc) {
      s.kind = std::abs(r) < 1e-12 ? Kind::sphere : Kind::torus;
      s.radius = std::abs(s.kind == Kind::sphere ? b.signed_radius : r);
      s.tube_radius = s.kind == Kind::sphere ? 0 : std::abs(b.signed_radius);
    } else if (std::abs(b.normal[0]) < 1e-12) {
      s.direction[2] = b.normal[1];
    } else if (std::abs(b.normal[1]) < 1e-12) {
      s.kind = Kind::cylinder;
      s.radius = std::abs(r);
    } else {
      s.kind = Kind::cone; // r + (z - z0) dd/dz = 0 at the apex, the tangent is (-n_1, n_0)
      s.point[2] += r * b.normal[0] / b.normal[1];
      s.half_angle = std::atan(std::abs(b.normal[1] / b.normal[0]));
    }
    return s;
  }

  Random& random_;
  bool are_triangles_;
  Part part_;
};

// A bent pipe, possibly hollow: lines of length `first` and `last`, between them an arc of `radius` over
// `angle` degrees in steps `bend`.
struct Elbow
{
  double first, last, radius, angle;
  std::vector<double> bend;

  Pose frame(std::size_t j) const
  {
    const bool is_last = j == bend.size() + 1;
    const double t = j == 0 ? 0 : (is_last ? 1 : bend[j - 1]) * angle * pi / 180;
    const double l = is_last ? last : 0;
    Pose p;
    p.axes = {{{std::cos(t), 0, -std::sin(t)}, {0, 1, 0}, {std::sin(t), 0, std::cos(t)}}};
    const Vec o{radius - radius * std::cos(t) + l * std::sin(t), 0,
                (j == 0 ? 0 : first) + radius * std::sin(t) + l * std::cos(t)};
    p.shift = o;
    return p;
  }

  Part_builder::Side add_to(Part_builder& b, const Chain& section) const
  {
    const std::size_t n = section.points.size(), m = bend.size() + 2;
    std::vector<Part_builder::Ids> rings;
    for (std::size_t j = 0; j < m; ++j) {
      std::vector<Vec> ring;
      for (const auto& p : section.points) ring.push_back(frame(j)({p[0], p[1], 0}));
      rings.push_back(b.add_ring(ring));
    }
    const double r = std::abs(section.pieces[0].signed_radius);
    const std::size_t ids[] = {
      b.add({Kind::cylinder, {0, 0, 0}, {0, 0, 1}, r, 0, 0}),
      b.add({Kind::torus, {radius, 0, first}, {0, 1, 0}, radius, r, 0}),
      b.add({Kind::cylinder, frame(m - 1).shift, frame(m - 1).axes[2], r, 0, 0})};
    for (std::size_t j = 0; j + 1 < m; ++j)
      for (std::size_t i = 0; i < n; ++i)
        b.add_quad(rings, j, i, ids[j == 0 ? 0 : j + 2 == m ? 2 : 1]);
    Part_builder::Side side;
    for (std::size_t i = 0; i < n; ++i) {
      side.start.insert(side.start.begin(),
                        {rings[0][i], section.points[i][0], section.points[i][1]});
      side.end.push_back({rings[m - 1][i], section.points[i][0], section.points[i][1]});
    }
    return side;
  }
};

} // namespace synthetic_parts

#endif // PN_TEST_PART_BUILDER_H

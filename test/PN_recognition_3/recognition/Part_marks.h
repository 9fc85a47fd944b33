// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef PN_TEST_PART_MARKS_H
#define PN_TEST_PART_MARKS_H

// What recognition says about a part against its truth.

#include "Synthetic_part.h"

#include <CGAL/PN_recognition_3/recognize_surfaces.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <set>

namespace synthetic_parts {

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Recognized_surface = CGAL::PN_subdivision_3::Recognized_surface;

inline const char* name_of(Recognized_surface::Kind k)
{
  static const char* const names[] = {"unknown", "plane", "cylinder", "cone", "sphere", "torus"};
  return names[static_cast<int>(k)];
}
inline Kind truth(Recognized_surface::Kind k) // not of `unknown`
{
  return static_cast<Kind>(static_cast<int>(k) - 1);
}
inline Recognized_surface::Kind recognized(Kind k)
{
  return static_cast<Recognized_surface::Kind>(static_cast<int>(k) + 1);
}
inline True_surface as_truth(const Recognized_surface& s)
{
  return {truth(s.kind), s.point, s.direction, s.radius, s.tube_radius, s.half_angle};
}

// vertices and faces by the numbers that they have in the part
template <class Mesh_>
Mesh_ mesh_of(const Part& part)
{
  Mesh_ mesh;
  std::vector<typename Mesh_::Vertex_index> v;
  for (const Vec& p : part.points)
    v.push_back(mesh.add_vertex(typename Mesh_::Point(p[0], p[1], p[2])));
  for (const auto& face : part.faces) {
    std::vector<typename Mesh_::Vertex_index> corners;
    for (std::size_t i : face) corners.push_back(v[i]);
    if (!mesh.is_valid(mesh.add_face(corners))) throw std::logic_error(part.name + ": no mesh");
  }
  return mesh;
}

struct Recognition
{
  std::vector<std::size_t> segment_of_face;
  std::vector<Recognized_surface> surfaces;
  std::set<std::pair<std::size_t, std::size_t>> creases; // by vertices, the lower one first
  std::size_t number_of_creases = 0;                     // as it is returned

  std::size_t count(Recognized_surface::Kind k) const
  {
    return static_cast<std::size_t>(std::count_if(
      surfaces.begin(), surfaces.end(), [k](const Recognized_surface& s) { return s.kind == k; }));
  }
};

template <class Mesh_, class NamedParameters>
Recognition recognition_of(Mesh_& mesh, const NamedParameters& parameters)
{
  namespace PN = CGAL::PN_subdivision_3;
  const auto np = PN::parameters::shared(parameters);
  Recognition r;
  auto patches =
    mesh.template add_property_map<typename Mesh_::Face_index, std::size_t>("f:segment").first;
  auto creases = mesh.template add_property_map<typename Mesh_::Edge_index, bool>("e:crease").first;
  r.surfaces = PN::recognize_surfaces(mesh, patches, np);
  r.number_of_creases = PN::surface_creases(mesh, patches, r.surfaces, creases, np);
  for (const auto f : mesh.faces()) r.segment_of_face.push_back(patches[f]);
  for (const auto e : mesh.edges())
    if (creases[e]) {
      const std::size_t a = mesh.vertex(e, 0), b = mesh.vertex(e, 1);
      r.creases.insert(std::minmax(a, b));
    }
  return r;
}
inline Recognition recognition_of(const Part& part)
{
  Mesh mesh = mesh_of<Mesh>(part);
  return recognition_of(mesh, CGAL::parameters::default_values());
}

class Part_marks
{
public:
  // What is wrong; `smallest`: the smallest multiple of the diagonal that counts as an error (2^-40)
  Part_marks(const Part& part, const Recognition& r, double smallest = std::ldexp(1., -40))
    : part_(part)
    , r_(r)
    , faces_(halfedges(part))
    , bar_((std::max)(8 * rounding(part), smallest * diagonal(part.points)))
    , tolerance_(4 * rounding(part) + 1e-7 * diagonal(part.points))
  {
    for (std::size_t s : r.segment_of_face)
      if (s >= r.surfaces.size()) {
        wrong_.insert("segment without a surface");
        return;
      }
    mark_boundaries();
    mark_counts();
    for (std::size_t s = 0; s < part.surfaces.size(); ++s) mark_surface(s);
  }

  const std::set<std::string>& wrong() const { return wrong_; }
  bool is_right() const { return wrong_.empty(); }
  // numbers aside
  bool are_segments_right() const
  {
    return std::all_of(wrong_.begin(), wrong_.end(), [](const std::string& w) {
      return w.find("vertices off") == 0 || w.find("numbers of") == 0 || w.find("residual") == 0;
    });
  }
  std::string text() const
  {
    std::string t;
    for (const std::string& s : wrong_) t += (t.empty() ? "" : "; ") + s;
    return t;
  }

private:
  Kind kind_at(std::size_t f) const { return part_.surfaces[part_.surface_of_face[f]].kind; }

  void mark_boundaries()
  {
    std::size_t number = 0;
    for (const auto& [edge, f] : faces_) {
      const std::size_t g = faces_.at({edge.second, edge.first});
      const bool differs = part_.surface_of_face[f] != part_.surface_of_face[g];
      const bool is_found = r_.segment_of_face[f] != r_.segment_of_face[g];
      const std::string kinds = std::string(name_of((std::min)(kind_at(f), kind_at(g)))) + " and " +
                                name_of((std::max)(kind_at(f), kind_at(g)));
      if (differs && !is_found) wrong_.insert("no boundary between " + kinds);
      if (is_found && !differs)
        wrong_.insert("boundary inside " + std::string(name_of(kind_at(f))));
      const bool is_crease =
        r_.creases.count(std::minmax(std::size_t(edge.first), std::size_t(edge.second))) > 0;
      if (is_crease != differs) wrong_.insert("creases");
      if (is_crease) ++number; // from either side
    }
    if (number != 2 * r_.creases.size() || r_.number_of_creases != r_.creases.size())
      wrong_.insert("number of creases");
  }
  void mark_counts()
  {
    std::vector<std::size_t> n(r_.surfaces.size(), 0);
    for (std::size_t s : r_.segment_of_face) ++n[s];
    for (std::size_t s = 0; s < n.size(); ++s) {
      if (n[s] == 0) wrong_.insert("surface without a face");
      if (n[s] != r_.surfaces[s].number_of_faces) wrong_.insert("number of faces");
    }
  }

  void mark_surface(std::size_t s)
  {
    std::set<std::size_t> segments, vertices;
    for (std::size_t f = 0; f < part_.faces.size(); ++f)
      if (part_.surface_of_face[f] == s) {
        segments.insert(r_.segment_of_face[f]);
        vertices.insert(part_.faces[f].begin(), part_.faces[f].end());
      }
    const True_surface& t = part_.surfaces[s];
    bool is_of_its_kind = true;
    for (std::size_t k : segments)
      if (r_.surfaces[k].kind != recognized(t.kind)) {
        wrong_.insert(std::string(name_of(t.kind)) + " as " + name_of(r_.surfaces[k].kind));
        is_of_its_kind = false;
      }
    if (!is_of_its_kind || segments.size() != 1) return;
    std::vector<Vec> points;
    for (std::size_t v : vertices) points.push_back(part_.points[v]);
    mark_numbers(t, r_.surfaces[*segments.begin()], points);
  }

  void mark_numbers(const True_surface& t, const Recognized_surface& r,
                    const std::vector<Vec>& points)
  {
    const bool is_exact = t.kind != Kind::cone && t.kind != Kind::torus; // under refinement
    const double bar = is_exact ? bar_ : tolerance_;
    double largest = 0;
    for (const Vec& p : points)
      largest = (std::max)(largest, std::abs(signed_distance(as_truth(r), p)));
    const std::string kind = name_of(t.kind);
    if (!(largest <= bar)) wrong_.insert("vertices off the " + kind);
    if (!(std::abs(largest - r.residual) <= 0.01 * bar + 1e-3 * largest))
      wrong_.insert("residual of a " + kind);
    if (!are_close(t, r, points, 10 * bar)) wrong_.insert("numbers of a " + kind);
  }

  // `e`: allowed error of a number that is as sure as the points are
  bool are_close(const True_surface& t, const Recognized_surface& r, const std::vector<Vec>& points,
                 double e) const
  {
    const double size = diagonal(points);
    switch (t.kind) {
    case Kind::plane:
      return length(r.direction - t.direction) <= e / width(t, points);
    case Kind::sphere: {
      const double m = e / bend_of_cap(t, points);
      return length(r.point - t.point) <= m && std::abs(r.radius - t.radius) <= m;
    }
    case Kind::cylinder: {
      const double m = e / bend_about_axis(t, points), turned = m / length_along(t, points);
      return std::abs(r.radius - t.radius) <= m && between(t.direction, r.direction) <= turned &&
             off_axis(t, r.point) <= m + turned * length(r.point - middle(points));
    }
    case Kind::cone: {
      const double m = e / bend_about_axis(t, points), turned = 4 * m / width_of_cone(t, points);
      return std::abs(r.half_angle - t.half_angle) <= turned &&
             between(t.direction, r.direction) <= turned &&
             length(r.point - t.point) <=
               turned * (length(t.point - middle(points)) + size) / std::sin(t.half_angle);
    }
    case Kind::torus: {
      const double m = 40 * e / bend_about_axis(t, points);
      return std::abs(r.radius - t.radius) <= m && std::abs(r.tube_radius - t.tube_radius) <= m &&
             length(r.point - t.point) <= m &&
             between(t.direction, r.direction) <= m / t.tube_radius;
    }
    }
    return false;
  }

  static double between(const Vec& a, const Vec& b) { return length(cross(a, b)); }
  static double off_axis(const True_surface& t, const Vec& p)
  {
    return length(cross(p - t.point, t.direction));
  }
  static Vec middle(const std::vector<Vec>& points)
  {
    Vec m{};
    for (const Vec& p : points) m = m + (1. / static_cast<double>(points.size())) * p;
    return m;
  }
  static double length_along(const True_surface& t, const std::vector<Vec>& points)
  {
    double low = 1e300, high = -1e300;
    for (const Vec& p : points) {
      low = (std::min)(low, dot(p - t.point, t.direction));
      high = (std::max)(high, dot(p - t.point, t.direction));
    }
    return high - low;
  }
  static double width_of_cone(const True_surface& t, const std::vector<Vec>& points)
  {
    return length_along(t, points) / std::cos(t.half_angle);
  }
  // of points in a plane, across the longest distance from one of them
  static double width(const True_surface& t, const std::vector<Vec>& points)
  {
    Vec d{};
    for (const Vec& p : points)
      if (length(p - points[0]) > length(d)) d = p - points[0];
    const Vec across = unit(cross(t.direction, d));
    double low = 0, high = 0;
    for (const Vec& p : points) {
      low = (std::min)(low, dot(p - points[0], across));
      high = (std::max)(high, dot(p - points[0], across));
    }
    return high - low;
  }
  // 1 - cos of half the angle that the points span about the axis, 1 if that is half a turn or more
  static double bend_about_axis(const True_surface& t, const std::vector<Vec>& points)
  {
    const Vec x =
      unit(cross(t.direction, std::abs(t.direction[0]) < 0.7 ? Vec{1, 0, 0} : Vec{0, 1, 0}));
    const Vec y = cross(t.direction, x);
    std::vector<double> angles;
    for (const Vec& p : points)
      if (off_axis(t, p) > 1e-6 * diagonal(points))
        angles.push_back(std::atan2(dot(p - t.point, y), dot(p - t.point, x)));
    std::sort(angles.begin(), angles.end());
    double gap = angles.front() + 2 * pi - angles.back();
    for (std::size_t i = 1; i < angles.size(); ++i)
      gap = (std::max)(gap, angles[i] - angles[i - 1]);
    const double span = 2 * pi - gap;
    return span > pi ? 1 : 1 - std::cos(span / 2);
  }
  static double bend_of_cap(const True_surface& t, const std::vector<Vec>& points)
  {
    const Vec m = middle(points) - t.point;
    if (length(m) < 0.5 * t.radius) return 1;
    double least = 1;
    for (const Vec& p : points) least = (std::min)(least, dot(unit(m), unit(p - t.point)));
    return (std::min)(1 - least, 1.);
  }

  const Part& part_;
  const Recognition& r_;
  Edge_faces faces_;
  double bar_, tolerance_;
  std::set<std::string> wrong_;
};

} // namespace synthetic_parts

#endif // PN_TEST_PART_MARKS_H

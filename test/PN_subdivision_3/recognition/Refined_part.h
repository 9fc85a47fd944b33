// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef PN_TEST_REFINED_PART_H
#define PN_TEST_REFINED_PART_H

// Recognized parts after two rounds, point-normal and linear with the same tags, and what this does to each control face.

#include "Part_marks.h"

#include <CGAL/PN_subdivision_3.h>
#include <CGAL/PN_subdivision_3/internal/recognition/Fallback.h>
#include <CGAL/PN_subdivision_3/internal/recognition/file_rounding.h>

namespace synthetic_parts {

struct Face_change
{
  double height = 0, deviation = 0; // out of its plane, out of its round surface
  bool is_folded = false;
};

// what is high or folded, and is it named
struct Broken_promises
{
  std::size_t planes = 0, unknown = 0, rounds = 0, folded = 0, not_named = 0;
  std::size_t all() const { return planes + unknown + rounds + folded; }
};

class Refined_part
{
public:
  using Surface_kind = Recognized_surface::Kind;
  using Fallback = CGAL::PN_subdivision_3::internal::Surface_fallback;

  explicit Refined_part(const Part& part)
    : part_(part)
    , mesh_(mesh_of<Mesh>(part))
    , crease_(mesh_.add_property_map<Mesh::Edge_index, bool>("e:crease", false).first)
    , corner_(mesh_.add_property_map<Mesh::Vertex_index, bool>("v:corner", false).first)
    , roundness_(mesh_.add_property_map<Mesh::Vertex_index, double>("v:roundness", 1).first)
    , normal_(mesh_.add_property_map<Mesh::Halfedge_index, Kernel::Vector_3>("h:normal").first)
    , origin_(mesh_.add_property_map<Mesh::Face_index, int>("f:origin", 0).first)
  {
    namespace PN = CGAL::PN_subdivision_3;
    const auto segment = mesh_.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
    surfaces = PN::recognize_surfaces(mesh_, segment);
    fallback = PN::internal::never_worse_than_linear(
      mesh_, segment, surfaces, crease_, normal_, PN::parameters::vertex_roundness_map(roundness_));
    for (const std::size_t v : fallback.corners)
      corner_[Mesh::Vertex_index(static_cast<Mesh::size_type>(v))] = true;
    for (const auto f : mesh_.faces()) {
      origin_[f] = static_cast<int>(f);
      segment_of_face.push_back(segment[f]);
    }
    std::vector<double> coordinates;
    for (const Vec& p : part.points) coordinates.insert(coordinates.end(), p.begin(), p.end());
    tolerance =
      4 * PN::internal::recognition::file_rounding(coordinates) + 1e-7 * diagonal(part.points);
    const bool are_triangles = CGAL::is_triangle_mesh(mesh_);
    point_normal = are_triangles ? changes(PN::Loop_scheme(), volume)
                                 : changes(PN::CatmullClark_scheme(), volume);
    linear = are_triangles ? changes(PN::linear(PN::Loop_scheme()), linear_volume)
                           : changes(PN::linear(PN::CatmullClark_scheme()), linear_volume);
  }

  Surface_kind kind(std::size_t f) const { return surfaces[segment_of_face[f]].kind; }
  bool is_round(std::size_t f) const
  {
    return kind(f) != Surface_kind::plane && kind(f) != Surface_kind::unknown;
  }

  Broken_promises broken_promises() const
  {
    const std::vector<double> around = largest_around();
    const double margin = 10 * tolerance;
    Broken_promises broken;
    for (std::size_t f = 0; f < part_.faces.size(); ++f) {
      const Face_change &pn = point_normal[f], &l = linear[f];
      const bool is_folded = pn.is_folded && !l.is_folded;
      const bool is_bent = kind(f) == Surface_kind::plane && pn.height > l.height + margin;
      const bool is_high =
        kind(f) == Surface_kind::unknown && pn.height > 1.25 * around[f] + margin;
      const bool is_off = is_round(f) && pn.deviation > 1.25 * l.deviation + margin;
      broken.folded += is_folded;
      broken.planes += is_bent;
      broken.unknown += is_high;
      broken.rounds += is_off;
      if ((is_folded || is_bent || is_high || is_off) && !is_named(f)) ++broken.not_named;
    }
    return broken;
  }

  std::vector<Recognized_surface> surfaces;
  std::vector<std::size_t> segment_of_face;
  Fallback fallback;
  double tolerance = 0;
  std::vector<Face_change> point_normal, linear;
  double volume = 0, linear_volume = 0; // refined

private:
  bool is_named(std::size_t f) const
  {
    return std::find(fallback.high_faces.begin(), fallback.high_faces.end(), f) !=
           fallback.high_faces.end();
  }

  Vec normal_of(std::size_t f) const // a zero vector: a sliver
  {
    const auto& corners = part_.faces[f];
    Vec area{};
    double longest = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vec &o = part_.points[corners[0]], &p = part_.points[corners[i]],
                &q = part_.points[corners[(i + 1) % corners.size()]];
      area = area + cross(p - o, q - o);
      longest = (std::max)(longest, length(q - p));
    }
    return length(area) < 4 * tolerance * longest ? Vec{} : unit(area);
  }

  template <class Scheme>
  std::vector<Face_change> changes(const Scheme& scheme, double& volume_after) const
  {
    namespace PN = CGAL::PN_subdivision_3;
    Mesh mesh = mesh_; // which has all these maps: CGAL 5 and 6 find them in different ways
    const auto origin = mesh.add_property_map<Mesh::Face_index, int>("f:origin").first;
    PN::subdivide(
      mesh, scheme,
      PN::parameters::attributes(PN::parameters::face_attribute(origin))
        .number_of_iterations(2)
        .edge_is_constrained_map(mesh.add_property_map<Mesh::Edge_index, bool>("e:crease").first)
        .vertex_is_constrained_map(
          mesh.add_property_map<Mesh::Vertex_index, bool>("v:corner").first)
        .vertex_roundness_map(
          mesh.add_property_map<Mesh::Vertex_index, double>("v:roundness").first)
        .vertex_normal_map(
          mesh.add_property_map<Mesh::Halfedge_index, Kernel::Vector_3>("h:normal").first));
    volume_after = volume_of(mesh);
    return measured(mesh, origin);
  }

  static double volume_of(const Mesh& mesh)
  {
    double result = 0;
    for (const auto f : mesh.faces()) {
      std::vector<Vec> p;
      for (const auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
        p.push_back({mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()});
      for (std::size_t i = 2; i < p.size(); ++i) result += dot(p[0], cross(p[i - 1], p[i])) / 6;
    }
    return result;
  }

  template <class Origin>
  std::vector<Face_change> measured(const Mesh& mesh, Origin origin) const
  {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    std::vector<Face_change> result(part_.faces.size());
    std::vector<double> least(mesh.number_of_vertices(), infinite);
    const auto for_each_corner = [&](const auto& function) {
      for (const auto f : mesh.faces())
        for (const auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh)) {
          const auto& p = mesh.point(v);
          function(static_cast<std::size_t>(origin[f]), v, Vec{p.x(), p.y(), p.z()});
        }
    };
    for_each_corner([&](std::size_t f, Mesh::Vertex_index v, const Vec& p) {
      const Vec n = normal_of(f);
      if (length(n) > 0)
        least[v] = (std::min)(least[v], std::abs(dot(n, p - part_.points[part_.faces[f][0]])));
      if (is_round(f))
        result[f].deviation =
          (std::max)(result[f].deviation,
                     std::abs(signed_distance(as_truth(surfaces[segment_of_face[f]]), p)));
    });
    for_each_corner([&](std::size_t f, Mesh::Vertex_index v, const Vec&) {
      if (least[v] < infinite) result[f].height = (std::max)(result[f].height, least[v]);
    });
    for (const auto f : mesh.faces())
      if (turns_over(mesh, f, normal_of(static_cast<std::size_t>(origin[f]))))
        result[static_cast<std::size_t>(origin[f])].is_folded = true;
    return result;
  }
  static bool turns_over(const Mesh& mesh, Mesh::Face_index f, const Vec& normal)
  {
    std::vector<Vec> p;
    for (const auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
      p.push_back({mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()});
    Vec area{};
    double longest = 0;
    for (std::size_t i = 2; i < p.size(); ++i) {
      area = area + cross(p[i - 1] - p[0], p[i] - p[0]);
      longest = (std::max)({longest, length(p[i] - p[0]), length(p[i - 1] - p[0])});
    }
    return dot(area, normal) < -1e-9 * longest * longest;
  }

  // linear heights of faces and those at their vertices
  std::vector<double> largest_around() const
  {
    std::vector<double> of_vertex(part_.points.size(), 0), result(part_.faces.size(), 0);
    for (std::size_t f = 0; f < part_.faces.size(); ++f)
      for (const std::size_t v : part_.faces[f])
        of_vertex[v] = (std::max)(of_vertex[v], linear[f].height);
    for (std::size_t f = 0; f < part_.faces.size(); ++f)
      for (const std::size_t v : part_.faces[f]) result[f] = (std::max)(result[f], of_vertex[v]);
    return result;
  }

  const Part& part_;
  Mesh mesh_;
  Mesh::Property_map<Mesh::Edge_index, bool> crease_;
  Mesh::Property_map<Mesh::Vertex_index, bool> corner_;
  Mesh::Property_map<Mesh::Vertex_index, double> roundness_;
  Mesh::Property_map<Mesh::Halfedge_index, Kernel::Vector_3> normal_;
  Mesh::Property_map<Mesh::Face_index, int> origin_;
};

} // namespace synthetic_parts

#endif // PN_TEST_REFINED_PART_H

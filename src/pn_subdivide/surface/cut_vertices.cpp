// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/cut_vertices.h"

#include <CGAL/PN_recognition_3/internal/recognition.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace pn_subdivide {
namespace {

namespace Recognition = CGAL::PN_subdivision_3::internal::recognition;

using CGAL::PN_subdivision_3::Recognized_surface;
using Kind = Recognized_surface::Kind;
using Recognition::Shape;
using Recognition::Vec3;
using Vertex = Surface::Vertex_index;

class Cut_vertices
{
public:
  Cut_vertices(const Surface& surface, const std::vector<std::size_t>& segments,
               const std::vector<Recognized_surface>& surfaces)
    : surface_(surface)
    , segments_(segments)
    , surfaces_(surfaces)
  {
    for (const Recognized_surface& s : surfaces) shapes_.push_back(Recognition::as_shape(s, 1, {}));
  }

  std::vector<Moved_vertex> operator()()
  {
    std::vector<Moved_vertex> result;
    for (const Vertex v : surface_.vertices())
      if (find_surfaces(v) && is_cut(v))
        if (const std::optional<Vec3> p = place_of(v))
          result.push_back({std::size_t(v), Point_3(p->x, p->y, p->z)});
    return result;
  }

private:
  Vec3 at(Vertex v) const
  {
    const Point_3& p = surface_.point(v);
    return {p.x(), p.y(), p.z()};
  }

  // whether all around are known
  bool find_surfaces(Vertex v)
  {
    around_.clear();
    if (surface_.is_isolated(v)) return false;
    for (const auto f : CGAL::faces_around_target(surface_.halfedge(v), surface_))
      if (f != Surface::null_face()) around_.push_back(segments_[f]);
    std::sort(around_.begin(), around_.end());
    around_.erase(std::unique(around_.begin(), around_.end()), around_.end());
    return std::none_of(around_.begin(), around_.end(),
                        [&](std::size_t s) { return surfaces_[s].kind == Kind::unknown; });
  }

  // how far the middle of a facet may be from its surface
  double sagitta(std::size_t segment, const Vec3& p) const
  {
    const Recognized_surface& s = surfaces_[segment];
    const auto height = [](double radius, double step) {
      return radius * (1 - std::cos(step / 2));
    };
    switch (s.kind) {
    case Kind::unknown:
    case Kind::plane:
      break;
    case Kind::cone:
      return height(shapes_[segment].local(p).rho, s.widest_step);
    case Kind::cylinder:
    case Kind::sphere:
    case Kind::torus:
      return height(s.radius + s.tube_radius, s.widest_step) +
             height(s.tube_radius, s.widest_meridian_step);
    }
    return 0;
  }

  // well off a round surface, by no more than a chord is
  bool is_cut(Vertex v) const
  {
    const Vec3 p = at(v);
    bool is_off = false;
    for (const std::size_t s : around_) {
      const double distance = std::abs(shapes_[s].distance(p)), most = sagitta(s, p);
      if (surfaces_[s].kind == Kind::plane) continue;
      if (!(distance <= 1.1 * most)) return false;
      is_off = is_off || distance > 0.02 * most;
    }
    return is_off;
  }

  // by projections in turn, which go to a near point of all of them if they meet at an angle
  std::optional<Vec3> place_of(Vertex v) const
  {
    const Vec3 start = at(v);
    Vec3 p = start;
    double off = 0;
    for (int k = 0; k < 200; ++k) {
      for (const std::size_t s : around_) p = p - shapes_[s].distance(p) * shapes_[s].normal(p);
      off = 0;
      for (const std::size_t s : around_) off = (std::max)(off, std::abs(shapes_[s].distance(p)));
      if (off <= 1e-9 * shortest_edge(v)) break;
    }
    const double edge = shortest_edge(v);
    if (!(off <= 1e-6 * edge && Recognition::norm(p - start) <= 0.4 * edge)) return std::nullopt;
    return p;
  }
  double shortest_edge(Vertex v) const
  {
    double shortest = -1;
    for (const auto h : CGAL::halfedges_around_target(surface_.halfedge(v), surface_)) {
      const double length = Recognition::norm(at(surface_.source(h)) - at(v));
      if (shortest < 0 || length < shortest) shortest = length;
    }
    return shortest;
  }

  const Surface& surface_;
  const std::vector<std::size_t>& segments_;
  const std::vector<Recognized_surface>& surfaces_;
  std::vector<Shape> shapes_;
  std::vector<std::size_t> around_; // a vertex: the surfaces
};

} // namespace

std::vector<Moved_vertex> cut_vertices(const Surface& surface,
                                       const std::vector<std::size_t>& segments,
                                       const std::vector<Recognized_surface>& surfaces)
{
  return Cut_vertices(surface, segments, surfaces)();
}

} // namespace pn_subdivide

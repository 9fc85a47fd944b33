// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_CGAL_MASKS_3_INTERNAL_MASK_MESH_VIEW_H
#define CGAL_PN_CGAL_MASKS_3_INTERNAL_MASK_MESH_VIEW_H

#include <CGAL/Kernel_traits.h>
#include <CGAL/Origin.h>
#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/average/input_checks.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_type_basic.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace PN_subdivision_3::internal {

// What a mask is told when it asks for the point of a vertex: the point, the normal read as a
// point, or the vertex's share (chi h, chi, 0) in the height over q along n.
template <class PointNormalMap>
class Mask_probe
{
public:
  using Vertex = typename boost::property_traits<PointNormalMap>::key_type;
  using Point_normal = typename boost::property_traits<PointNormalMap>::value_type;
  using Point = typename Point_normal::first_type;
  using Vector = typename Point_normal::second_type;
  using FT = typename Kernel_traits<Point>::Kernel::FT;

  explicit Mask_probe(const PointNormalMap& point_normals)
    : point_normals_(point_normals)
  {}

  void answer_points() { answer_ = Answer::points; }
  void answer_normals() { answer_ = Answer::normals; }
  void answer_heights(const Point& q, const Vector& n)
  {
    answer_ = Answer::heights;
    q_ = q;
    n_ = n;
    fading_ = false;
  }

  Point operator()(const Vertex& v) const
  {
    const Point_normal pn = get(point_normals_, v);
    if (answer_ == Answer::points) return pn.first;
    Coordinates<FT, 3> n = coordinates_3<FT>(pn.second);
    normalize_control_normal<FT, 3>(n);
    return answer_ == Answer::normals ? ORIGIN + vector(n) : height(pn.first, vector(n));
  }

  // The new normal for the mask's sum of the normals, zero if it vanishes.
  Vector normal(const Vector& sum) const
  {
    return vector(unit_or_zero<FT, 3>(coordinates_3<FT>(sum), FT(1)));
  }

  // The new height for the mask's sum of the heights.
  FT height(const Point& sum) const
  {
    if (!fading_) return sum.x();
    if (sum.y() < FT(1) / FT(64)) return FT(0);
    return sum.x() / sum.y();
  }

private:
  enum class Answer { points, normals, heights };

  static Vector vector(const Coordinates<FT, 3>& n) { return Vector(n[0], n[1], n[2]); }

  // The fade is decided before the division by d, which may be zero.
  Point height(const Point& p, const Vector& n_p) const
  {
    const Vector s = n_p + n_;
    const FT d = s * n_;
    const FT chi = fade(d);
    if (chi != FT(1)) fading_ = true;
    if (chi == FT(0)) return Point(FT(0), FT(0), FT(0));
    return Point(chi * ((s * (p - q_)) / d), chi, FT(0));
  }

  static FT fade(const FT& d) { return d < fade_begin<FT>() ? internal::fade(d) : FT(1); }

  PointNormalMap point_normals_;
  Answer answer_ = Answer::points;
  Point q_ = ORIGIN;
  Vector n_ = NULL_VECTOR;
  mutable bool fading_ = false;
};

// The vertex point map that a mask sees: it hands out the probe's answers.
template <class PointNormalMap>
class Mask_point_map
{
  using Probe = Mask_probe<PointNormalMap>;

public:
  using key_type = typename Probe::Vertex;
  using value_type = typename Probe::Point;
  using reference = value_type;
  using category = boost::readable_property_map_tag;

  Mask_point_map() = default;
  explicit Mask_point_map(const Probe& probe)
    : probe_(&probe)
  {}

  friend reference get(const Mask_point_map& map, const key_type& v) { return (*map.probe_)(v); }

private:
  const Probe* probe_ = nullptr;
};

// The mesh that a mask sees: connectivity and descriptors of the user's mesh, points of the probe.
// All free functions of a face graph are friends, hence found by argument-dependent lookup only.
template <class PolygonMesh, class PointNormalMap>
class Mask_mesh_view
{
  using Traits = boost::graph_traits<PolygonMesh>;
  using Vertex = typename Traits::vertex_descriptor;
  using Halfedge = typename Traits::halfedge_descriptor;
  using Edge = typename Traits::edge_descriptor;
  using Face = typename Traits::face_descriptor;
  using View = Mask_mesh_view;

public:
  using Point_map = Mask_point_map<PointNormalMap>;

  Mask_mesh_view(const PolygonMesh& mesh, const Mask_probe<PointNormalMap>& probe)
    : mesh_(&mesh)
    , point_map_(probe)
  {}

  friend auto vertices(const View& g) { return vertices(*g.mesh_); }
  friend auto halfedges(const View& g) { return halfedges(*g.mesh_); }
  friend auto edges(const View& g) { return edges(*g.mesh_); }
  friend auto faces(const View& g) { return faces(*g.mesh_); }

  friend auto num_vertices(const View& g) { return num_vertices(*g.mesh_); }
  friend auto num_halfedges(const View& g) { return num_halfedges(*g.mesh_); }
  friend auto num_edges(const View& g) { return num_edges(*g.mesh_); }
  friend auto num_faces(const View& g) { return num_faces(*g.mesh_); }

  friend Halfedge halfedge(Vertex v, const View& g) { return halfedge(v, *g.mesh_); }
  friend Halfedge halfedge(Edge e, const View& g) { return halfedge(e, *g.mesh_); }
  friend Halfedge halfedge(Face f, const View& g) { return halfedge(f, *g.mesh_); }
  friend std::pair<Halfedge, bool> halfedge(Vertex s, Vertex t, const View& g)
  {
    return halfedge(s, t, *g.mesh_);
  }

  friend Halfedge next(Halfedge h, const View& g) { return next(h, *g.mesh_); }
  friend Halfedge prev(Halfedge h, const View& g) { return prev(h, *g.mesh_); }
  friend Halfedge opposite(Halfedge h, const View& g) { return opposite(h, *g.mesh_); }
  friend Vertex source(Halfedge h, const View& g) { return source(h, *g.mesh_); }
  friend Vertex target(Halfedge h, const View& g) { return target(h, *g.mesh_); }
  friend Vertex source(Edge e, const View& g) { return source(e, *g.mesh_); }
  friend Vertex target(Edge e, const View& g) { return target(e, *g.mesh_); }
  friend Edge edge(Halfedge h, const View& g) { return edge(h, *g.mesh_); }
  friend auto edge(Vertex s, Vertex t, const View& g) { return edge(s, t, *g.mesh_); }
  friend Face face(Halfedge h, const View& g) { return face(h, *g.mesh_); }

  friend auto degree(Vertex v, const View& g) { return degree(v, *g.mesh_); }
  friend auto degree(Face f, const View& g) { return degree(f, *g.mesh_); }
  friend auto in_degree(Vertex v, const View& g) { return in_degree(v, *g.mesh_); }
  friend auto out_degree(Vertex v, const View& g) { return out_degree(v, *g.mesh_); }
  friend auto in_edges(Vertex v, const View& g) { return in_edges(v, *g.mesh_); }
  friend auto out_edges(Vertex v, const View& g) { return out_edges(v, *g.mesh_); }

  friend Point_map get(vertex_point_t, const View& g) { return g.point_map_; }
  friend typename Point_map::reference get(vertex_point_t, const View& g, Vertex v)
  {
    return get(g.point_map_, v);
  }
  template <class Property>
  friend auto get(Property property, const View& g)
  {
    return get(property, *g.mesh_);
  }

private:
  const PolygonMesh* mesh_;
  Point_map point_map_;
};

} // namespace PN_subdivision_3::internal

template <class PolygonMesh, class PointNormalMap>
struct graph_has_property<PN_subdivision_3::internal::Mask_mesh_view<PolygonMesh, PointNormalMap>,
                          vertex_point_t> : Tag_true
{};

} // namespace CGAL

namespace boost {

template <class PolygonMesh, class PointNormalMap>
struct graph_traits<CGAL::PN_subdivision_3::internal::Mask_mesh_view<PolygonMesh, PointNormalMap>>
  : graph_traits<PolygonMesh>
{};

template <class PolygonMesh, class PointNormalMap, class Property>
struct property_map<CGAL::PN_subdivision_3::internal::Mask_mesh_view<PolygonMesh, PointNormalMap>,
                    Property>
{
  using type = typename property_map<PolygonMesh, Property>::const_type;
  using const_type = type;
};

template <class PolygonMesh, class PointNormalMap>
struct property_map<CGAL::PN_subdivision_3::internal::Mask_mesh_view<PolygonMesh, PointNormalMap>,
                    vertex_point_t>
{
  using type = CGAL::PN_subdivision_3::internal::Mask_point_map<PointNormalMap>;
  using const_type = type;
};

} // namespace boost

namespace CGAL::PN_subdivision_3::internal {

// The user's mask template on the view: Mask<View>, or Mask<View, point map> if that is needed.
template <class View, template <class...> class Mask, class = void>
struct Mask_on_view
{
  using type = Mask<View, typename View::Point_map>;
};

template <class View, template <class...> class Mask>
struct Mask_on_view<View, Mask, std::void_t<Mask<View>>>
{
  using type = Mask<View>;
};

// CGAL's masks take a pointer to the mesh, the manual's a reference; not all take a point map.
template <class Mask, class View, class PointMap, class... Args>
Mask make_mask_on_view(View& view, const PointMap& points, const Args&... args)
{
  if constexpr (std::is_constructible_v<Mask, View*, PointMap, const Args&...>)
    return Mask(&view, points, args...);
  else if constexpr (std::is_constructible_v<Mask, View&, PointMap, const Args&...>)
    return Mask(view, points, args...);
  else if constexpr (std::is_constructible_v<Mask, View*, const Args&...>)
    return Mask(&view, args...);
  else {
    static_assert(std::is_constructible_v<Mask, View&, const Args&...>,
                  "The mask must be constructible from a pointer or a reference to the mesh, then "
                  "the vertex point map (if it takes one), then the arguments given here.");
    return Mask(view, args...);
  }
}

template <class Coordinates>
bool has_finite_coordinates(const Coordinates& c)
{
  return CGAL::is_finite(c.x()) && CGAL::is_finite(c.y()) && CGAL::is_finite(c.z());
}

// Once, before CGAL's hosts begin, since they do not check and leak when a mask throws.
template <class PolygonMesh, class PointNormalMap>
void check_mask_input(const PolygonMesh& mesh, const PointNormalMap& point_normals)
{
  std::size_t index = 0;
  const auto require = [&index](bool holds, const char* otherwise) {
    if (!holds)
      throw std::invalid_argument("PN_mask_3: vertex " + std::to_string(index) +
                                  " (counting from 0 in vertices(mesh)) " + otherwise);
  };
  for (auto v : vertices(mesh)) {
    require(halfedge(v, mesh) != boost::graph_traits<PolygonMesh>::null_halfedge(),
            "has no edge, which CGAL's hosts cannot treat; remove it");
    const auto point_normal = get(point_normals, v);
    require(has_finite_coordinates(point_normal.first),
            "has a point with an infinite or NaN coordinate; correct or remove it");
    require(has_finite_coordinates(point_normal.second),
            "has a normal with an infinite or NaN coordinate; give a unit or a zero normal");
    ++index;
  }
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_CGAL_MASKS_3_INTERNAL_MASK_MESH_VIEW_H

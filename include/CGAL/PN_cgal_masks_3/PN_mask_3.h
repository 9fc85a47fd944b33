// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_CGAL_MASKS_3_PN_MASK_3_H
#define CGAL_PN_CGAL_MASKS_3_PN_MASK_3_H

#include <CGAL/PN_cgal_masks_3/internal/Mask_mesh_view.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <memory>
#include <tuple>
#include <utility>

namespace CGAL::PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Ref

A vertex point map and a vertex normal map as one property map of (point, normal) pairs.
Given to a function of `CGAL::Subdivision_method_3` as `vertex_point_map`, it lets CGAL's own hosts
carry normals along.

\tparam VertexPointMap a model of `ReadWritePropertyMap` with value type `Kernel::Point_3`
\tparam VertexNormalMap a model of `ReadWritePropertyMap` with the same key type and with value
  type `Kernel::Vector_3`

Both must accept vertices that are added to the mesh after the map was made.

\cgalModels{ReadWritePropertyMap}
\sa `CGAL::PN_subdivision_3::PN_mask_3`
*/
template <class VertexPointMap, class VertexNormalMap>
class Zipped_point_normal_map
{
public:
  /// the vertex descriptor.
  using key_type = typename boost::property_traits<VertexPointMap>::key_type;
  /// a point with its normal.
  using value_type = std::pair<typename boost::property_traits<VertexPointMap>::value_type,
                               typename boost::property_traits<VertexNormalMap>::value_type>;
  /// values are made of the two maps on request.
  using reference = value_type;
  /// readable and writable.
  using category = boost::read_write_property_map_tag;

  /// zips the two maps.
  Zipped_point_normal_map(const VertexPointMap& points, const VertexNormalMap& normals)
    : points_(points)
    , normals_(normals)
  {}

  /// the point and the normal of `v`.
  friend reference get(const Zipped_point_normal_map& map, const key_type& v)
  {
    return reference(get(map.points_, v), get(map.normals_, v));
  }

  /// sets the point and the normal of `v`.
  friend void put(const Zipped_point_normal_map& map, const key_type& v, const value_type& value)
  {
    put(map.points_, v, value.first);
    put(map.normals_, v, value.second);
  }

private:
  VertexPointMap points_;
  VertexNormalMap normals_;
};

/*!
\ingroup PkgPNSubdivision3Ref

Turns a geometry mask of `CGAL::Subdivision_method_3` into a point-normal mask for CGAL's own hosts
`PQQ()`, `PTQ()`, `DQQ()` and `Sqrt3()`, without its source being touched.

For each new vertex the mask runs three times. On the points it gives the linear point q, on the normals read as points,
after normalization, the new normal n. On the heights, over q along n, of the arcs from the old vertices it gives the
height of the new point. This is slow,
and independent of how this package evaluates its own schemes; to subdivide a mesh with one of
these, use `subdivide()`.

\code
auto point_normals = Zipped_point_normal_map(get(CGAL::vertex_point, mesh), normals);
CGAL::Subdivision_method_3::PQQ(
    mesh, make_PN_mask_3<CGAL::CatmullClark_mask_3>(mesh, point_normals),
    CGAL::parameters::vertex_point_map(point_normals).number_of_iterations(5));
\endcode

Requirements on the mask:
<ul>
<li> It is a class template over the type of the mesh, or over the types of the mesh and the vertex
     point map. Further parameters are fixed by an alias template.
<li> It is constructed from a pointer or a reference to the mesh, then the vertex point map if it
     takes one, then the further arguments given to `make_PN_mask_3()`.
<li> It reaches the mesh through the free functions of `MutableFaceGraph`, reading only, and the
     points through the vertex point map or `get(CGAL::vertex_point, mesh)`, whenever it is called.
<li> Each new point is an affine combination of old points, coordinate by coordinate, computed in
     the kernel's number type; every node that is passed is set.
</ul>

Control normals are unit vectors, or zero where there is none; others are normalized on reading. New
normals are unit vectors or exactly zero. With an exact number type without square root (such as
that of `CGAL::Exact_predicates_exact_constructions_kernel`) normals are parallel to their exact
direction, and of squared length 1 up to 2<sup>-50</sup>.

Since a mask does not tell its weights, a normal vanishes when the mask's sum of unit normals is
not longer than 2<sup>12</sup> times the epsilon of the number type (exact types: is zero).

Copies share their state: one mask must not be used by two threads at a time.
The hosts' own requirements stay, such as triangle meshes for `PTQ()`.

\tparam Mask the mask's class template
\tparam PolygonMesh a model of `MutableFaceGraph`
\tparam PointNormalMap a model of `ReadablePropertyMap` with the vertex descriptor as key type and
  `std::pair<Kernel::Point_3, Kernel::Vector_3>` as value type

\cgalModels{PQQMask_3,PTQMask_3,DQQMask_3,Sqrt3Mask_3}, whichever `Mask` models
\sa `CGAL::PN_subdivision_3::make_PN_mask_3()`
*/
template <template <class...> class Mask, class PolygonMesh, class PointNormalMap>
class PN_mask_3
{
  using Probe = internal::Mask_probe<PointNormalMap>;
  using View = internal::Mask_mesh_view<PolygonMesh, PointNormalMap>;
  using View_mask = typename internal::Mask_on_view<View, Mask>::type;
  using Point = typename Probe::Point;
  using Vector = typename Probe::Vector;

public:
  /// a point with its normal, `std::pair<Kernel::Point_3, Kernel::Vector_3>`.
  using Point_normal = typename Probe::Point_normal;
  /// a vertex of the mesh.
  using vertex_descriptor = typename boost::graph_traits<PolygonMesh>::vertex_descriptor;
  /// a half-edge of the mesh.
  using halfedge_descriptor = typename boost::graph_traits<PolygonMesh>::halfedge_descriptor;
  /// a face of the mesh.
  using face_descriptor = typename boost::graph_traits<PolygonMesh>::face_descriptor;

  /// constructs the mask for `mesh`, with `args` for `Mask`. The points and normals are read when
  /// the mask is used; `mesh` must live as long.
  /// \throws std::invalid_argument if a vertex has no edge, which CGAL's hosts turn into NaN or a
  /// crash, or if a point or a normal has a coordinate that is not finite.
  template <class... Args>
  explicit PN_mask_3(const PolygonMesh& mesh, const PointNormalMap& point_normals,
                     const Args&... args)
    : state_(std::make_shared<State>(mesh, point_normals, args...))
  {
    internal::check_mask_input(mesh, point_normals);
  }

  /// \name Nodes
  /// @{

  /// the new vertex of a face.
  void face_node(face_descriptor f, Point_normal& node)
  {
    evaluate([f](View_mask& mask, Point& p) { mask.face_node(f, p); }, node);
  }

  /// the new vertex of an edge.
  void edge_node(halfedge_descriptor h, Point_normal& node)
  {
    evaluate([h](View_mask& mask, Point& p) { mask.edge_node(h, p); }, node);
  }

  /// the new vertex of a vertex.
  void vertex_node(vertex_descriptor v, Point_normal& node)
  {
    evaluate([v](View_mask& mask, Point& p) { mask.vertex_node(v, p); }, node);
  }

  /// the new vertex of a corner of a face.
  void corner_node(halfedge_descriptor h, Point_normal& node)
  {
    evaluate([h](View_mask& mask, Point& p) { mask.corner_node(h, p); }, node);
  }

  /// for `PQQ()` and `PTQ()`: the edge's and the vertex's node. For `Sqrt3()`: two edge nodes and
  /// the vertex's node.
  template <class... Nodes>
  void border_node(halfedge_descriptor h, Nodes&... nodes)
  {
    evaluate([h](View_mask& mask, auto&... p) { mask.border_node(h, p...); }, nodes...);
  }
  /// @}

private:
  // The mask keeps the address of the view, and the view that of the probe.
  struct State
  {
    template <class... Args>
    State(const PolygonMesh& mesh, const PointNormalMap& point_normals, const Args&... args)
      : probe(point_normals)
      , view(mesh, probe)
      , mask(internal::make_mask_on_view<View_mask>(view, get(vertex_point, view), args...))
    {}
    State(const State&) = delete;
    State& operator=(const State&) = delete;

    Probe probe;
    View view;
    View_mask mask;
  };

  template <std::size_t n, class Call>
  std::array<Point, n> run(const Call& call)
  {
    std::array<Point, n> sums;
    sums.fill(Point(ORIGIN));
    std::apply([&](auto&... p) { call(state_->mask, p...); }, sums);
    return sums;
  }

  template <class Call, class... Nodes>
  void evaluate(const Call& call, Nodes&... nodes)
  {
    constexpr std::size_t n = sizeof...(Nodes);
    Probe& probe = state_->probe;
    probe.answer_points();
    const std::array<Point, n> q = run<n>(call);
    probe.answer_normals();
    const std::array<Point, n> normal_sums = run<n>(call);

    std::size_t i = 0;
    const auto lift = [&](Point_normal& node) {
      const Vector normal = probe.normal(normal_sums[i] - ORIGIN);
      node = Point_normal(q[i], normal);
      if (normal != NULL_VECTOR) {
        probe.answer_heights(q[i], normal);
        node.first = q[i] + normal * probe.height(run<n>(call)[i]);
      }
      ++i;
    };
    (lift(nodes), ...);
  }

  std::shared_ptr<State> state_;
};

/*!
\ingroup PkgPNSubdivision3Ref

makes the point-normal mask of the mask `Mask`, constructed with `args` behind the mesh and the
vertex point map.

\relates PN_mask_3
*/
template <template <class...> class Mask, class PolygonMesh, class PointNormalMap, class... Args>
PN_mask_3<Mask, PolygonMesh, PointNormalMap>
make_PN_mask_3(const PolygonMesh& mesh, const PointNormalMap& point_normals, const Args&... args)
{
  return PN_mask_3<Mask, PolygonMesh, PointNormalMap>(mesh, point_normals, args...);
}

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_CGAL_MASKS_3_PN_MASK_3_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_CGAL_MASKS_3_SUBDIVISION_METHOD_3_H
#define CGAL_PN_CGAL_MASKS_3_SUBDIVISION_METHOD_3_H

#include <CGAL/Origin.h>
#include <CGAL/PN_cgal_masks_3/internal/Cgal_ordered_host.h>
#include <CGAL/PN_subdivision_3/hosts/Sqrt3_host.h>
#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/meshes/Refinable_mesh_traits.h>
#include <CGAL/PN_subdivision_3/parameters/parameters.h>
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/DooSabin_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Sqrt3_scheme.h>
#include <CGAL/PN_subdivision_3/subdivide.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL::PN_subdivision_3 {
namespace internal {

// in the place of points that others compute
template <class Vertex>
struct No_points
{
  using key_type = Vertex;
  using value_type = Simple_cartesian<double>::Point_3;
  using reference = value_type;
  using category = boost::read_write_property_map_tag;

  friend value_type get(const No_points&, const Vertex&) { return value_type(ORIGIN); }
  friend void put(const No_points&, const Vertex&, const value_type&) {}
};

template <class Mesh>
constexpr bool recycles_v = Refinable_mesh_traits<Mesh>::recycles;

// Refines the connectivity of a mesh as a scheme does, in the order of CGAL's; points stay as they are.
template <class Mesh, class Scheme>
void refine_connectivity(Mesh& mesh, const Scheme& scheme)
{
  using Vertex = typename boost::graph_traits<Mesh>::vertex_descriptor;
  PN_subdivision_3::subdivide(mesh, linear(in_order_of_cgal<recycles_v<Mesh>>(scheme)),
                              CGAL::parameters::vertex_point_map(No_points<Vertex>()));
}

// Rounds with a geometry policy of CGAL's. All its nodes are computed before the mesh is touched, in the order in which
// CGAL's hosts ask for them; what it does not set, such as vertices without edges, stays as it is.
template <class Mesh, class Point_map, class Mask>
class Masked_round
{
  using Traits = boost::graph_traits<Mesh>;
  using Vertex = typename Traits::vertex_descriptor;
  using Halfedge = typename Traits::halfedge_descriptor;
  using Point = typename boost::property_traits<Point_map>::value_type;

public:
  // the mask is a copy, as that of CGAL's hosts
  Masked_round(Mesh& mesh, Point_map points, const Mask& mask)
    : mesh_(mesh)
    , points_(points)
    , mask_(mask)
    , index_(get(dynamic_vertex_property_t<std::size_t>(), mesh))
  {
    for (Vertex v : vertices(mesh_)) {
      put(index_, v, nodes_.size());
      nodes_.push_back(get(points_, v));
    }
    is_on_border_.assign(nodes_.size(), false);
  }

  void pqq()
  {
    std::vector<Point> of_faces;
    for (auto f : faces(mesh_)) {
      of_faces.push_back(some_point(f));
      mask_.face_node(f, of_faces.back());
    }
    edges_and_vertices();
    nodes_.insert(nodes_.end(), of_faces.begin(), of_faces.end());
    refine(CatmullClark_scheme());
  }

  void ptq()
  {
    edges_and_vertices();
    refine(Loop_scheme());
  }

  void dqq()
  {
    nodes_.clear();
    for (Vertex v : vertices(mesh_)) {
      const Halfedge first = first_around(v);
      if (first == Traits::null_halfedge()) continue;
      for (const Halfedge h : CGAL::halfedges_around_target(first, mesh_)) {
        if (CGAL::is_border(h, mesh_)) continue;
        nodes_.push_back(get(points_, target(h, mesh_)));
        mask_.corner_node(h, nodes_.back());
      }
    }
    refine(DooSabin_scheme());
  }

  void sqrt3(bool refines_border)
  {
    const std::vector<Point> old = nodes_;
    for (auto f : faces(mesh_)) {
      const Halfedge h = refines_border ? border_side(halfedge(f, mesh_)) : Traits::null_halfedge();
      if (h == Traits::null_halfedge()) {
        nodes_.push_back(some_point(f));
        mask_.face_node(f, nodes_.back());
        continue;
      }
      const std::size_t v = get(index_, target(h, mesh_));
      Point first = nodes_[v], second = nodes_[v], at = old[v];
      mask_.border_node(h, first, second, at);
      nodes_[v] = at;
      nodes_.push_back(second);
      nodes_.push_back(first);
    }
    std::size_t i = 0;
    for (Vertex v : vertices(mesh_)) {
      if (!is_isolated(v) && !is_border_vertex(v)) mask_.vertex_node(v, nodes_[i]);
      ++i;
    }
    if (refines_border)
      refine(Border_refining_sqrt3());
    else
      refine(Sqrt3_scheme());
  }

private:
  // the second round of sqrt(3)
  struct Border_refining_sqrt3_host : Sqrt3_host
  {
    Border_refining_sqrt3_host(const Level_connectivity& level, unsigned)
      : Sqrt3_host(level, 2)
    {}
    static Level_size refined_size(const Level_size& size, unsigned)
    {
      return Sqrt3_host::refined_size(size, 2);
    }
  };
  struct Border_refining_sqrt3 : Scheme_adaptor<Sqrt3_scheme>
  {
    using Host = Border_refining_sqrt3_host;
  };

  template <class Face>
  Point some_point(Face f) const
  {
    return get(points_, target(halfedge(f, mesh_), mesh_));
  }
  bool is_isolated(Vertex v) const { return halfedge(v, mesh_) == Traits::null_halfedge(); }
  bool is_border_vertex(Vertex v) const { return CGAL::is_border(first_around(v), mesh_); }

  // a half-edge to v, on the border if v is
  Halfedge first_around(Vertex v) const
  {
    const Halfedge first = halfedge(v, mesh_);
    if (first != Traits::null_halfedge())
      for (const Halfedge h : CGAL::halfedges_around_target(first, mesh_))
        if (CGAL::is_border(h, mesh_)) return h;
    return first;
  }

  Halfedge border_side(Halfedge first) const
  {
    for (const Halfedge h : CGAL::halfedges_around_face(first, mesh_))
      if (CGAL::is_border(opposite(h, mesh_), mesh_)) return h;
    return Traits::null_halfedge();
  }

  void edges_and_vertices()
  {
    const std::size_t number = nodes_.size();
    for (auto e : edges(mesh_)) {
      Halfedge h = halfedge(e, mesh_);
      nodes_.push_back(get(points_, target(h, mesh_)));
      Point& node = nodes_.back();
      if (!CGAL::is_border(h, mesh_) && !CGAL::is_border(opposite(h, mesh_), mesh_)) {
        mask_.edge_node(h, node);
        continue;
      }
      if (CGAL::is_border(h, mesh_)) h = opposite(h, mesh_);
      const std::size_t v = get(index_, target(h, mesh_));
      mask_.border_node(h, node, nodes_[v]);
      is_on_border_[v] = true;
    }
    std::size_t i = 0;
    for (Vertex v : vertices(mesh_)) {
      if (!is_on_border_[i] && !is_isolated(v)) mask_.vertex_node(v, nodes_[i]);
      if (++i == number) break;
    }
  }

  template <class Scheme>
  void refine(const Scheme& scheme)
  {
    refine_connectivity(mesh_, scheme);
    std::size_t i = 0;
    for (Vertex v : vertices(mesh_)) put(points_, v, nodes_[i++]);
  }

  Mesh& mesh_;
  Point_map points_;
  Mask mask_;
  std::vector<Point>
    nodes_; // of the vertices, then of what becomes one, in the order of the refined mesh
  std::vector<bool> is_on_border_;
  typename boost::property_map<Mesh, dynamic_vertex_property_t<std::size_t>>::type index_;
};

// The parameters of a call; it may give the number of rounds alone, as it was once given.
template <class NamedParameters>
decltype(auto) parameters_of_method(const NamedParameters& np)
{
  if constexpr (std::is_arithmetic_v<NamedParameters>)
    return CGAL::parameters::number_of_iterations((std::max)(0, static_cast<int>(np)));
  else
    return (np);
}

template <class Scheme, class PolygonMesh, class Given>
void subdivide_as_cgal(PolygonMesh& mesh, const Scheme& scheme, const Given& given)
{
  const auto& np = parameters_of_method(given);
  using Parameters = Surface_parameters<PolygonMesh, std::decay_t<decltype(np)>>;
  const auto ordered = in_order_of_cgal<recycles_v<PolygonMesh>>(scheme);
  if constexpr (!is_there_v<typename Parameters::Normal_map>)
    PN_subdivision_3::subdivide(mesh, linear(ordered), np);
  else
    PN_subdivision_3::subdivide(mesh, ordered, np);
}

// Calls round(r, i) for the rounds i = 0, 1, ... The values of the point map may be anything that the mask sets.
template <class PolygonMesh, class Mask, class Given, class Round>
void masked_rounds(PolygonMesh& mesh, const Mask& mask, const Given& given, const Round& round)
{
  const auto& np = parameters_of_method(given);
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const auto iterations = CGAL::parameters::number_of_iterations(
    choose_parameter(get_parameter(np, internal_np::number_of_iterations), 1u));
  const unsigned rounds =
    Surface_parameters<PolygonMesh, std::decay_t<decltype(iterations)>>::number_of_iterations(
      iterations);
  using Point_map = typename GetVertexPointMap<PolygonMesh, std::decay_t<decltype(np)>>::type;
  const Point_map points = choose_parameter(get_parameter(np, internal_np::vertex_point),
                                            get_property_map(vertex_point, mesh));
  for (unsigned i = 0; i < rounds; ++i) {
    Masked_round<PolygonMesh, Point_map, Mask> one(mesh, points, mask);
    round(one, i);
  }
}

} // namespace internal

/*!
\ingroup PkgPNSubdivision3Functions

The functions of `CGAL::Subdivision_method_3`, with the same signatures, by this package: a program changes an
`#include` and a namespace. The connectivity and the order of the vertices are the same. Points differ from those of
\cgal by not more than 8 &middot; 2<sup>-52</sup> of the box of the points. (`DooSabin_subdivision()` and `DQQ()` have
the order of a `Polyhedron_3` whose border vertices have a half-edge on the border. In a `Surface_mesh` \cgal's own functions use the places of removed vertices again from the second round
on, and leave others behind.)

With a `vertex_normal_map` the point-normal schemes are applied, without it the linear ones: no normals are estimated. All other
named parameters of `PN_subdivision_3::subdivide()` serve here as there, sharp edges by `edge_is_constrained_map` among them.

\cgal crashes or writes NaN on some meshes. These functions keep vertices without edges (dual schemes drop them).
Faces that cannot be refined are a `std::invalid_argument` that names the element, and leaves the mesh as it was.
*/
namespace Subdivision_method_3 {

namespace parameters = PN_subdivision_3::parameters;

/// \ingroup PkgPNSubdivision3Functions
/// applies Catmull-Clark subdivision.
template <class PolygonMesh, class NamedParameters = parameters::Default_named_parameters>
void CatmullClark_subdivision(PolygonMesh& mesh,
                              const NamedParameters& np = parameters::default_values())
{
  internal::subdivide_as_cgal(mesh, CatmullClark_scheme(), np);
}
/// \ingroup PkgPNSubdivision3Functions
/// applies Loop subdivision, to triangles.
template <class PolygonMesh, class NamedParameters = parameters::Default_named_parameters>
void Loop_subdivision(PolygonMesh& mesh, const NamedParameters& np = parameters::default_values())
{
  internal::subdivide_as_cgal(mesh, Loop_scheme(), np);
}
/// \ingroup PkgPNSubdivision3Functions
/// applies Doo-Sabin subdivision.
template <class PolygonMesh, class NamedParameters = parameters::Default_named_parameters>
void DooSabin_subdivision(PolygonMesh& mesh,
                          const NamedParameters& np = parameters::default_values())
{
  internal::subdivide_as_cgal(mesh, DooSabin_scheme(), np);
}
/// \ingroup PkgPNSubdivision3Functions
/// applies \f$ \sqrt{3} \f$ subdivision, to triangles; even rounds of a call refine the border.
template <class PolygonMesh, class NamedParameters = parameters::Default_named_parameters>
void Sqrt3_subdivision(PolygonMesh& mesh, const NamedParameters& np = parameters::default_values())
{
  internal::subdivide_as_cgal(mesh, Sqrt3_scheme(), np);
}

/*!
\ingroup PkgPNSubdivision3Functions
splits polygons into quadrilaterals, at points of the user's mask. It is asked for all points of a round before
the mesh is changed.
\tparam Mask a model of \cgal's `PQQMask_3`: `face_node()`, `edge_node()`, `vertex_node()` and `border_node()`
\param mesh,mask,np as of \cgal's function; of named parameters `vertex_point_map` and `number_of_iterations` are used
*/
template <class PolygonMesh, class Mask,
          class NamedParameters = parameters::Default_named_parameters>
void PQQ(PolygonMesh& mesh, Mask mask, const NamedParameters& np = parameters::default_values())
{
  internal::masked_rounds(mesh, mask, np, [](auto& round, unsigned) { round.pqq(); });
}
/// \ingroup PkgPNSubdivision3Functions
/// splits triangles into four; the mask is a model of \cgal's `PTQMask_3`.
template <class PolygonMesh, class Mask,
          class NamedParameters = parameters::Default_named_parameters>
void PTQ(PolygonMesh& mesh, Mask mask, const NamedParameters& np = parameters::default_values())
{
  internal::masked_rounds(mesh, mask, np, [](auto& round, unsigned) { round.ptq(); });
}
/// \ingroup PkgPNSubdivision3Functions
/// makes a vertex of every corner of a face; the mask is a model of \cgal's `DQQMask_3`, with `corner_node()`.
template <class PolygonMesh, class Mask,
          class NamedParameters = parameters::Default_named_parameters>
void DQQ(PolygonMesh& mesh, Mask mask, const NamedParameters& np = parameters::default_values())
{
  internal::masked_rounds(mesh, mask, np, [](auto& round, unsigned) { round.dqq(); });
}
/// \ingroup PkgPNSubdivision3Functions
/// splits triangles into three and flips the old edges; the mask is a model of \cgal's `Sqrt3Mask_3`.
template <class PolygonMesh, class Mask,
          class NamedParameters = parameters::Default_named_parameters>
void Sqrt3(PolygonMesh& mesh, Mask mask, const NamedParameters& np = parameters::default_values())
{
  internal::masked_rounds(mesh, mask, np, [](auto& round, unsigned i) { round.sqrt3(i % 2 == 1); });
}

} // namespace Subdivision_method_3
} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_CGAL_MASKS_3_SUBDIVISION_METHOD_3_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVISION_3_DEMO_GRAPH_TRAITS_ARRAY_MESH_H
#define PN_SUBDIVISION_3_DEMO_GRAPH_TRAITS_ARRAY_MESH_H

// An Array_mesh as a MutableFaceGraph from which nothing is removed.

#include "Array_mesh.h"

#include <CGAL/PN_subdivision_3/meshes/Refinable_mesh_traits.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <utility>

namespace boost {

template <class P>
struct graph_traits<pn_demo::Array_mesh<P>>
{
  using Mesh = pn_demo::Array_mesh<P>;

  using vertex_descriptor = typename Mesh::Vertex_index;
  using halfedge_descriptor = typename Mesh::Halfedge_index;
  using edge_descriptor = typename Mesh::Edge_index;
  using face_descriptor = typename Mesh::Face_index;
  using vertex_iterator = pn_demo::Index_iterator<vertex_descriptor>;
  using halfedge_iterator = pn_demo::Index_iterator<halfedge_descriptor>;
  using edge_iterator = pn_demo::Index_iterator<edge_descriptor>;
  using face_iterator = pn_demo::Index_iterator<face_descriptor>;
  using vertices_size_type = typename Mesh::size_type;
  using halfedges_size_type = vertices_size_type;
  using edges_size_type = vertices_size_type;
  using faces_size_type = vertices_size_type;
  using degree_size_type = vertices_size_type;
  using directed_category = undirected_tag;
  using edge_parallel_category = disallow_parallel_edge_tag;
  struct traversal_category : virtual vertex_list_graph_tag, virtual edge_list_graph_tag
  {};

  static vertex_descriptor null_vertex() { return Mesh::null_vertex(); }
  static halfedge_descriptor null_halfedge() { return Mesh::null_halfedge(); }
  static face_descriptor null_face() { return Mesh::null_face(); }
};
template <class P>
struct graph_traits<const pn_demo::Array_mesh<P>> : graph_traits<pn_demo::Array_mesh<P>>
{};

template <class P>
struct property_map<pn_demo::Array_mesh<P>, vertex_point_t>
{
  using type = typename pn_demo::Array_mesh<P>::template Property_map<
    typename pn_demo::Array_mesh<P>::Vertex_index, P>;
  using const_type = type;
};

} // namespace boost

namespace pn_demo {

template <class P>
auto get(boost::vertex_point_t, const Array_mesh<P>& mesh)
{
  return mesh.points();
}

template <class P>
auto vertices(const Array_mesh<P>& mesh)
{
  return mesh.vertices();
}
template <class P>
auto halfedges(const Array_mesh<P>& mesh)
{
  return mesh.halfedges();
}
template <class P>
auto edges(const Array_mesh<P>& mesh)
{
  return mesh.edges();
}
template <class P>
auto faces(const Array_mesh<P>& mesh)
{
  return mesh.faces();
}
template <class P>
auto num_vertices(const Array_mesh<P>& mesh)
{
  return mesh.number_of_vertices();
}
template <class P>
auto num_halfedges(const Array_mesh<P>& mesh)
{
  return mesh.number_of_halfedges();
}
template <class P>
auto num_edges(const Array_mesh<P>& mesh)
{
  return mesh.number_of_edges();
}
template <class P>
auto num_faces(const Array_mesh<P>& mesh)
{
  return mesh.number_of_faces();
}

template <class P>
auto target(typename Array_mesh<P>::Halfedge_index h, const Array_mesh<P>& mesh)
{
  return mesh.target(h);
}
template <class P>
auto source(typename Array_mesh<P>::Halfedge_index h, const Array_mesh<P>& mesh)
{
  return mesh.source(h);
}
template <class P>
auto target(typename Array_mesh<P>::Edge_index e, const Array_mesh<P>& mesh)
{
  return mesh.vertex(e, 0);
}
template <class P>
auto source(typename Array_mesh<P>::Edge_index e, const Array_mesh<P>& mesh)
{
  return mesh.vertex(e, 1);
}
template <class P>
auto next(typename Array_mesh<P>::Halfedge_index h, const Array_mesh<P>& mesh)
{
  return mesh.next(h);
}
template <class P>
auto prev(typename Array_mesh<P>::Halfedge_index h, const Array_mesh<P>& mesh)
{
  return mesh.prev(h);
}
template <class P>
auto opposite(typename Array_mesh<P>::Halfedge_index h, const Array_mesh<P>& mesh)
{
  return mesh.opposite(h);
}
template <class P>
auto edge(typename Array_mesh<P>::Halfedge_index h, const Array_mesh<P>& mesh)
{
  return mesh.edge(h);
}
template <class P>
auto face(typename Array_mesh<P>::Halfedge_index h, const Array_mesh<P>& mesh)
{
  return mesh.face(h);
}
template <class P>
auto halfedge(typename Array_mesh<P>::Edge_index e, const Array_mesh<P>& mesh)
{
  return mesh.halfedge(e);
}
template <class P>
auto halfedge(typename Array_mesh<P>::Vertex_index v, const Array_mesh<P>& mesh)
{
  return mesh.halfedge(v);
}
template <class P>
auto halfedge(typename Array_mesh<P>::Face_index f, const Array_mesh<P>& mesh)
{
  return mesh.halfedge(f);
}
// and whether there is one
template <class P>
auto halfedge(typename Array_mesh<P>::Vertex_index from, typename Array_mesh<P>::Vertex_index to,
              const Array_mesh<P>& mesh)
{
  const auto h = mesh.halfedge(from, to);
  return std::make_pair(h, h.is_valid());
}

template <class P>
auto add_vertex(Array_mesh<P>& mesh)
{
  return mesh.add_vertex();
}
template <class P>
auto add_edge(Array_mesh<P>& mesh)
{
  return mesh.edge(mesh.add_edge(mesh.null_vertex(), mesh.null_vertex()));
}
template <class P>
auto add_face(Array_mesh<P>& mesh)
{
  return mesh.add_face();
}
template <class P>
void set_target(typename Array_mesh<P>::Halfedge_index h, typename Array_mesh<P>::Vertex_index v,
                Array_mesh<P>& mesh)
{
  mesh.set_target(h, v);
}
template <class P>
void set_next(typename Array_mesh<P>::Halfedge_index h, typename Array_mesh<P>::Halfedge_index n,
              Array_mesh<P>& mesh)
{
  mesh.set_next(h, n);
}
template <class P>
void set_face(typename Array_mesh<P>::Halfedge_index h, typename Array_mesh<P>::Face_index f,
              Array_mesh<P>& mesh)
{
  mesh.set_face(h, f);
}
template <class P>
void set_halfedge(typename Array_mesh<P>::Vertex_index v, typename Array_mesh<P>::Halfedge_index h,
                  Array_mesh<P>& mesh)
{
  mesh.set_halfedge(v, h);
}
template <class P>
void set_halfedge(typename Array_mesh<P>::Face_index f, typename Array_mesh<P>::Halfedge_index h,
                  Array_mesh<P>& mesh)
{
  mesh.set_halfedge(f, h);
}

} // namespace pn_demo

template <class P>
struct CGAL::graph_has_property<pn_demo::Array_mesh<P>, boost::vertex_point_t> : CGAL::Tag_true
{};

template <class P>
struct CGAL::PN_subdivision_3::Refinable_mesh_traits<pn_demo::Array_mesh<P>> : Any_mesh_traits
{
  static constexpr bool has_resize = true;
  static constexpr bool has_slots = true;
  static constexpr bool has_concurrent_connectivity = true;
};

#endif // PN_SUBDIVISION_3_DEMO_GRAPH_TRAITS_ARRAY_MESH_H

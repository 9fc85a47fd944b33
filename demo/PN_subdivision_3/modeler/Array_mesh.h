// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVISION_3_DEMO_ARRAY_MESH_H
#define PN_SUBDIVISION_3_DEMO_ARRAY_MESH_H

#include "Property_arrays.h"

#include <CGAL/Iterator_range.h>

#include <boost/iterator/iterator_facade.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace pn_demo {

// The number of an element; the largest is that of none.
template <class Kind>
class Element_index
{
public:
  using size_type = std::uint32_t;
  static constexpr size_type none = std::numeric_limits<size_type>::max();

  constexpr Element_index() = default;
  constexpr explicit Element_index(size_type i)
    : i_(i)
  {}
  constexpr operator size_type() const { return i_; }
  constexpr size_type idx() const { return i_; }
  constexpr bool is_valid() const { return i_ != none; }

private:
  size_type i_ = none;
};

template <class Index>
class Index_iterator
  : public boost::iterator_facade<Index_iterator<Index>, Index, boost::random_access_traversal_tag,
                                  Index, std::ptrdiff_t>
{
public:
  Index_iterator() = default;
  explicit Index_iterator(std::size_t i)
    : i_(i)
  {}

private:
  friend class boost::iterator_core_access;
  Index dereference() const { return Index(static_cast<typename Index::size_type>(i_)); }
  bool equal(const Index_iterator& other) const { return i_ == other.i_; }
  void increment() { ++i_; }
  void decrement() { --i_; }
  void advance(std::ptrdiff_t n) { i_ += static_cast<std::size_t>(n); }
  std::ptrdiff_t distance_to(const Index_iterator& other) const
  {
    return static_cast<std::ptrdiff_t>(other.i_) - static_cast<std::ptrdiff_t>(i_);
  }

  std::size_t i_ = 0;
};

// Half-edges in arrays, with the members of CGAL::Surface_mesh that are needed here; that class is under the GPL. Nothing
// can be removed. Half-edges 2 e and 2 e + 1 are those of edge e.
template <class P>
class Array_mesh
{
  struct Vertex_kind;
  struct Halfedge_kind;
  struct Edge_kind;
  struct Face_kind;

public:
  using Point = P;
  using size_type = std::uint32_t;
  using Vertex_index = Element_index<Vertex_kind>;
  using Halfedge_index = Element_index<Halfedge_kind>;
  using Edge_index = Element_index<Edge_kind>;
  using Face_index = Element_index<Face_kind>;
  template <class Index>
  using Index_range = CGAL::Iterator_range<Index_iterator<Index>>;
  template <class Index, class T>
  using Property_map = Array_property_map<Index, T>;

  Array_mesh()
    : points_(add_property_map<Vertex_index, Point>(points_name).first)
  {}
  Array_mesh(const Array_mesh& other)
    : halfedge_of_vertex_(other.halfedge_of_vertex_)
    , halfedge_of_face_(other.halfedge_of_face_)
    , links_(other.links_)
    , of_vertices_(other.of_vertices_)
    , of_halfedges_(other.of_halfedges_)
    , of_edges_(other.of_edges_)
    , of_faces_(other.of_faces_)
    , points_(property_map<Vertex_index, Point>(points_name).first)
  {}
  Array_mesh(Array_mesh&&) = default;
  Array_mesh& operator=(const Array_mesh& other) { return *this = Array_mesh(other); }
  Array_mesh& operator=(Array_mesh&&) = default;

  // --- elements ---

  size_type number_of_vertices() const { return size_type(halfedge_of_vertex_.size()); }
  size_type number_of_halfedges() const { return size_type(links_.size()); }
  size_type number_of_edges() const { return number_of_halfedges() / 2; }
  size_type number_of_faces() const { return size_type(halfedge_of_face_.size()); }
  // the same, since nothing is removed
  size_type num_vertices() const { return number_of_vertices(); }
  size_type num_halfedges() const { return number_of_halfedges(); }
  size_type num_edges() const { return number_of_edges(); }
  size_type num_faces() const { return number_of_faces(); }
  template <class Index>
  bool is_removed(Index) const
  {
    return false;
  }

  Index_range<Vertex_index> vertices() const { return range<Vertex_index>(number_of_vertices()); }
  Index_range<Halfedge_index> halfedges() const
  {
    return range<Halfedge_index>(number_of_halfedges());
  }
  Index_range<Edge_index> edges() const { return range<Edge_index>(number_of_edges()); }
  Index_range<Face_index> faces() const { return range<Face_index>(number_of_faces()); }

  static Vertex_index null_vertex() { return Vertex_index(); }
  static Halfedge_index null_halfedge() { return Halfedge_index(); }
  static Face_index null_face() { return Face_index(); }

  void reserve(size_type vertices, size_type edges, size_type faces)
  {
    halfedge_of_vertex_.reserve(vertices);
    links_.reserve(2 * std::size_t(edges));
    halfedge_of_face_.reserve(faces);
  }
  void resize(size_type vertices, size_type edges, size_type faces)
  {
    of(Vertex_index()).resize(vertices);
    of(Halfedge_index()).resize(2 * std::size_t(edges));
    of(Edge_index()).resize(edges);
    of(Face_index()).resize(faces);
    halfedge_of_vertex_.resize(vertices);
    links_.resize(2 * std::size_t(edges));
    halfedge_of_face_.resize(faces);
  }
  Vertex_index add_vertex() { return add_vertex(Point()); }
  Vertex_index add_vertex(const Point& p)
  {
    resize(number_of_vertices() + 1, number_of_edges(), number_of_faces());
    const Vertex_index v(number_of_vertices() - 1);
    point(v) = p;
    return v;
  }
  Halfedge_index add_edge(Vertex_index from, Vertex_index to)
  {
    resize(number_of_vertices(), number_of_edges() + 1, number_of_faces());
    const Halfedge_index h(number_of_halfedges() - 2);
    set_target(h, to);
    set_target(opposite(h), from);
    return h;
  }
  Face_index add_face()
  {
    resize(number_of_vertices(), number_of_edges(), number_of_faces() + 1);
    return Face_index(number_of_faces() - 1);
  }

  // --- connectivity ---

  Vertex_index target(Halfedge_index h) const { return links_[h].target; }
  Vertex_index source(Halfedge_index h) const { return target(opposite(h)); }
  Halfedge_index next(Halfedge_index h) const { return links_[h].next; }
  Halfedge_index prev(Halfedge_index h) const { return links_[h].prev; }
  static Halfedge_index opposite(Halfedge_index h) { return Halfedge_index(h ^ size_type(1)); }
  static Edge_index edge(Halfedge_index h) { return Edge_index(h >> 1); }
  static Halfedge_index halfedge(Edge_index e) { return Halfedge_index(2 * e); }
  static Halfedge_index halfedge(Edge_index e, unsigned i) { return Halfedge_index(2 * e + i); }
  Halfedge_index halfedge(Vertex_index v) const { return halfedge_of_vertex_[v]; }
  Halfedge_index halfedge(Face_index f) const { return halfedge_of_face_[f]; }
  // from one vertex to another one
  Halfedge_index halfedge(Vertex_index from, Vertex_index to) const
  {
    const Halfedge_index first = halfedge(to);
    if (!first.is_valid()) return first;
    Halfedge_index h = first;
    do {
      if (source(h) == from) return h;
      h = opposite(next(h));
    } while (h != first);
    return null_halfedge();
  }
  Face_index face(Halfedge_index h) const { return links_[h].face; }
  Vertex_index vertex(Edge_index e, unsigned i) const { return target(halfedge(e, i)); }
  bool is_border(Halfedge_index h) const { return !face(h).is_valid(); }
  bool is_border(Edge_index e) const
  {
    return is_border(halfedge(e, 0)) || is_border(halfedge(e, 1));
  }
  bool is_isolated(Vertex_index v) const { return !halfedge(v).is_valid(); }
  size_type degree(Face_index f) const
  {
    size_type n = 0;
    Halfedge_index h = halfedge(f);
    do {
      ++n;
      h = next(h);
    } while (h != halfedge(f));
    return n;
  }

  void set_target(Halfedge_index h, Vertex_index v) { links_[h].target = v; }
  void set_next(Halfedge_index h, Halfedge_index n)
  {
    links_[h].next = n;
    links_[n].prev = h;
  }
  void set_face(Halfedge_index h, Face_index f) { links_[h].face = f; }
  void set_halfedge(Vertex_index v, Halfedge_index h) { halfedge_of_vertex_[v] = h; }
  void set_halfedge(Face_index f, Halfedge_index h) { halfedge_of_face_[f] = h; }

  // --- values ---

  Point& point(Vertex_index v) { return points_[v]; }
  const Point& point(Vertex_index v) const { return points_[v]; }
  const Property_map<Vertex_index, Point>& points() const { return points_; }

  // and whether it is new
  template <class Index, class T>
  std::pair<Property_map<Index, T>, bool> add_property_map(const std::string& name, T value = T())
  {
    return of(Index()).template add<Index, T>(name, std::move(value), size_of(Index()));
  }
  template <class Index, class T>
  std::pair<Property_map<Index, T>, bool> property_map(const std::string& name) const
  {
    return const_cast<Array_mesh*>(this)->of(Index()).template find<Index, T>(name);
  }
  template <class Index, class T>
  void remove_property_map(Property_map<Index, T>& map)
  {
    of(Index()).remove(map);
  }

private:
  struct Links
  {
    Vertex_index target;
    Halfedge_index next, prev;
    Face_index face;
  };

  template <class Index>
  static Index_range<Index> range(size_type n)
  {
    return {Index_iterator<Index>(0), Index_iterator<Index>(n)};
  }
  Property_arrays& of(Vertex_index) { return of_vertices_; }
  Property_arrays& of(Halfedge_index) { return of_halfedges_; }
  Property_arrays& of(Edge_index) { return of_edges_; }
  Property_arrays& of(Face_index) { return of_faces_; }
  std::size_t size_of(Vertex_index) const { return number_of_vertices(); }
  std::size_t size_of(Halfedge_index) const { return number_of_halfedges(); }
  std::size_t size_of(Edge_index) const { return number_of_edges(); }
  std::size_t size_of(Face_index) const { return number_of_faces(); }

  static constexpr const char* points_name = "v:point";

  std::vector<Halfedge_index> halfedge_of_vertex_, halfedge_of_face_;
  std::vector<Links> links_;
  Property_arrays of_vertices_, of_halfedges_, of_edges_, of_faces_;
  Property_map<Vertex_index, Point> points_;
};

} // namespace pn_demo

template <class Kind>
struct std::hash<pn_demo::Element_index<Kind>>
{
  std::size_t operator()(pn_demo::Element_index<Kind> i) const { return i.idx(); }
};

#endif // PN_SUBDIVISION_3_DEMO_ARRAY_MESH_H

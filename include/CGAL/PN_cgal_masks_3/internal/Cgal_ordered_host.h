// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_CGAL_MASKS_3_INTERNAL_CGAL_ORDERED_HOST_H
#define CGAL_PN_CGAL_MASKS_3_INTERNAL_CGAL_ORDERED_HOST_H

#include <CGAL/PN_cgal_masks_3/internal/Cgal_order.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>

#include <boost/container/vector.hpp>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The child of a host in another order.
template <class Child>
class Reordered_child
{
public:
  using Index = Level_connectivity::Index;

  Reordered_child(Child& child, const Cgal_order& order)
    : child_(child)
    , order_(order)
  {}

  void set_next(Index h, Index n) { child_.set_next(order_.halfedge(h), order_.halfedge(n)); }
  void set_target(Index h, Index v) { child_.set_target(order_.halfedge(h), order_.vertex(v)); }
  void set_face(Index h, Index f) { child_.set_face(order_.halfedge(h), order_.face(f)); }
  void set_border(Index h) { child_.set_border(order_.halfedge(h)); }
  void set_isolated(Index v) { child_.set_isolated(order_.vertex(v)); }
  void set_halfedge_of_vertex(Index v, Index h)
  {
    child_.set_halfedge_of_vertex(order_.vertex(v), order_.halfedge(h));
  }
  void set_halfedge_of_face(Index f, Index h)
  {
    child_.set_halfedge_of_face(order_.face(f), order_.halfedge_of_face(f, h));
  }

private:
  Child& child_;
  const Cgal_order& order_;
};

// A host whose children have the numbers of CGAL's. `recycles`: whether the mesh puts new elements in the places of removed
// ones. Its parents are asked for vertices alone.
template <class Host, bool recycles>
class Cgal_ordered_host : public Host
{
public:
  using Index = Level_connectivity::Index;

  Cgal_ordered_host(const Level_connectivity& level, unsigned round)
    : Host(level, round)
  {
    order_.number(static_cast<const Host&>(*this), level, recycles);
    if constexpr (!Host::keeps_vertices) {
      base_vertex_.resize(level.size().corners, boost::container::default_init);
      for (Index v = 0; v < base_vertex_.size(); ++v) base_vertex_[order_.vertex(v)] = v;
    }
  }

  Element_parent parent_of_vertex(Index v) const { return Host::parent_of_vertex(base_vertex(v)); }
  void parent_of_edge(Index) const = delete;
  void parent_of_face(Index) const = delete;

  template <class Mask, class Stencil>
  void stencil(const Mask& mask, Index v, Stencil& s) const
  {
    Host::stencil(mask, base_vertex(v), s);
  }

  template <class Child, class For_chunks>
  void connect(Child& child, const For_chunks& for_chunks) const
  {
    Reordered_child<Child> reordered(child, order_);
    Host::connect(reordered, for_chunks);
  }

private:
  Index base_vertex(Index v) const { return base_vertex_.empty() ? v : base_vertex_[v]; }

  Cgal_order order_;
  boost::container::vector<Index> base_vertex_; // empty if all have the same number
};

// A scheme whose host is such a one.
template <class Scheme, bool recycles>
struct Cgal_ordered : Scheme_adaptor<Scheme>
{
  using Host = Cgal_ordered_host<typename Scheme::Host, recycles>;
};

template <bool recycles, class Scheme>
Cgal_ordered<Scheme, recycles> in_order_of_cgal(const Scheme& scheme)
{
  return {{scheme}};
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_CGAL_MASKS_3_INTERNAL_CGAL_ORDERED_HOST_H

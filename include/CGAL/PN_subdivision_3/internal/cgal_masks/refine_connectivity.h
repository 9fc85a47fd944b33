// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_CGAL_MASKS_REFINE_CONNECTIVITY_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_CGAL_MASKS_REFINE_CONNECTIVITY_H

#include <CGAL/PN_subdivision_3/Refinable_mesh_traits.h>
#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/hosts/Cgal_ordered_host.h>
#include <CGAL/PN_subdivision_3/subdivide.h>

#include <CGAL/Origin.h>
#include <CGAL/Simple_cartesian.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// every new vertex is a copy of an old one
class Copying_mask
{
public:
  using Index = Level_connectivity::Index;

  explicit Copying_mask(const Level_connectivity& level)
    : level_(level)
  {}

  template <class Stencil>
  void vertex(Index v, Stencil& s) const
  {
    s.add(v, 1);
  }
  template <class Stencil>
  void edge(Index e, Stencil& s) const
  {
    s.add(level_.target(Level_connectivity::halfedge_of_edge(e)), 1);
  }
  template <class Stencil>
  void face(Index f, Stencil& s) const
  {
    s.add(level_.target(level_.halfedge_of_face(f)), 1);
  }
  template <class Stencil>
  void corner(Index h, Stencil& s) const
  {
    s.add(level_.target(h), 1);
  }
  template <class Stencil>
  void border_vertex(Index h, Stencil& s) const
  {
    s.add(level_.target(h), 1);
  }
  template <class Stencil>
  void border_edge(Index h, Index, Stencil& s) const
  {
    s.add(level_.target(h), 1);
  }

private:
  const Level_connectivity& level_;
};

template <class Host_>
struct Copying_scheme
{
  using Host = Host_;
  template <class FT>
  Copying_mask mask(const Level_connectivity& level, unsigned /*round*/) const
  {
    return Copying_mask(level);
  }
};

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

// Refines the connectivity of a mesh as the host does, in the order of CGAL's; points stay as they are.
template <class Host, class Mesh>
void refine_connectivity(Mesh& mesh)
{
  using Vertex = typename boost::graph_traits<Mesh>::vertex_descriptor;
  PN_subdivision_3::subdivide(mesh,
                              linear(Copying_scheme<Cgal_ordered_host<Host, recycles_v<Mesh>>>()),
                              CGAL::parameters::vertex_point_map(No_points<Vertex>()));
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_CGAL_MASKS_REFINE_CONNECTIVITY_H

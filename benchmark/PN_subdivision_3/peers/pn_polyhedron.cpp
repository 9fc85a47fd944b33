// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "Cgal_meshes.h"

#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
#include <CGAL/PN_subdivision_3/subdivide.h>

#include <boost/property_map/property_map.hpp>

#include <string>

namespace {

namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;

// vertices that have a normal
template <class Refs, class Point>
struct Vertex_with_normal : CGAL::HalfedgeDS_vertex_base<Refs, CGAL::Tag_true, Point>
{
  using CGAL::HalfedgeDS_vertex_base<Refs, CGAL::Tag_true, Point>::HalfedgeDS_vertex_base;
  Kernel::Vector_3 normal{0, 0, 0};
};

struct Items : CGAL::Polyhedron_items_3
{
  template <class Refs, class Traits>
  struct Vertex_wrapper
  {
    using Vertex = Vertex_with_normal<Refs, typename Traits::Point_3>;
  };
};

using Polyhedron = CGAL::Polyhedron_3<Kernel, Items>;

struct Normal_map
{
  using key_type = Polyhedron::Vertex_handle;
  using value_type = Kernel::Vector_3;
  using reference = const value_type&;
  using category = boost::read_write_property_map_tag;
  friend reference get(Normal_map, key_type v) { return v->normal; }
  friend void put(Normal_map, key_type v, const value_type& n) { v->normal = n; }
};

template <class Scheme>
void add(Jobs& jobs, const std::string& name, const Scheme& scheme)
{
  jobs["pn/polyhedron/" + name] = [scheme](const Control& control, unsigned rounds, unsigned) {
    auto mesh = polyhedron<Polyhedron>(control);
    PN::estimate_control_normals(mesh, Normal_map());
    Result result = timed([&] {
      PN::subdivide(mesh, scheme,
                    params::number_of_iterations(rounds).vertex_normal_map(Normal_map()));
    });
    result.faces = mesh.size_of_facets();
    return result;
  };
  jobs["pn-linear/polyhedron/" + name] = [scheme](const Control& control, unsigned rounds,
                                                  unsigned) {
    auto mesh = polyhedron<CGAL::Polyhedron_3<Kernel>>(control);
    Result result =
      timed([&] { PN::subdivide(mesh, PN::linear(scheme), params::number_of_iterations(rounds)); });
    result.faces = mesh.size_of_facets();
    return result;
  };
}

} // namespace

void add_pn_polyhedron(Jobs& jobs)
{
  add(jobs, "catmull-clark", PN::CatmullClark_scheme());
  add(jobs, "loop", PN::Loop_scheme());
}

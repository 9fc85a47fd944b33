// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// A scheme of one's own: new points on the middles of the edges; of an icosahedron they are on its sphere.
// clang-format off
#include <CGAL/PN_subdivision_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
namespace PN = CGAL::PN_subdivision_3;
struct Middles { // the scheme, and for a level its mask
  using Host = PN::PTQ_host; // splits a triangle into four
  const PN::Level_connectivity* level = nullptr;
  template <class FT> Middles mask(const PN::Level_connectivity& l, unsigned) const { return {&l}; }
  template <class Stencil> void vertex(unsigned v, Stencil& s) const { s.add_rest(v); }
  template <class Stencil> void edge(unsigned e, Stencil& s) const {
    s.add(level->target(level->halfedge_of_edge(e)), 0.5);
    s.add_rest(level->source(level->halfedge_of_edge(e))); }
};
int main() {
  CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> mesh;
  CGAL::make_icosahedron(mesh, CGAL::Simple_cartesian<double>::Point_3(0, 0, 0), 1.);
  PN::subdivide(mesh, Middles(), CGAL::parameters::number_of_iterations(3));
  return mesh.number_of_faces() == 20 * 64 ? 0 : 1;
}

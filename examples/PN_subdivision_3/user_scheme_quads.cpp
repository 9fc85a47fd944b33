// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// A scheme of your own for any polygons: Catmull-Clark with a tension between -1 and 1. Tension 0
// is Catmull-Clark itself; the nearer the tension to 1, the nearer the surface to the control mesh.
//
// The weights are all that is written here. Linear and point-normal subdivision, several threads,
// exact numbers and eigenvalues come with them.
//
//   user_scheme_quads [MESH [TENSION]]

#include "try_scheme.h"

#include <cstdlib>
#include <string>

template <class FT>
struct Tension_mask
{
  using Index = PN::Level_connectivity::Index;

  template <class Stencil>
  void vertex(Index v, Stencil& s) const
  {
    const Index first = level.halfedge_of_vertex(v);
    if (level.is_isolated(v)) return s.add_rest(v);
    if (level.is_border(first)) {
      s.add(level.source(first), smoothing / FT(8));
      s.add(level.target(level.next(first)), smoothing / FT(8));
      return s.add_rest(v);
    }
    const FT n(static_cast<int>(level.valence(v)));
    Index h = first;
    do {
      s.add(level.source(h), smoothing / (n * n));
      corners(h, smoothing / (n * n), s);
      h = level.next_around_target(h);
    } while (h != first);
    s.add_rest(v);
  }

  template <class Stencil>
  void edge(Index e, Stencil& s) const
  {
    const Index h = level.halfedge_of_edge(e);
    const FT share = level.is_border_edge(e) ? FT(0) : smoothing / FT(4);
    if (share != FT(0)) {
      corners(h, share, s);
      corners(level.opposite(h), share, s);
    }
    s.add(level.source(h), FT(1) / FT(2) - share);
    s.add_rest(level.target(h));
  }

  template <class Stencil>
  void face(Index f, Stencil& s) const
  {
    corners(level.halfedge_of_face(f), FT(1), s);
    s.add_rest(level.target(level.halfedge_of_face(f))); // what rounding leaves
  }

  // shares a weight among the corners of the face of a half-edge
  template <class Stencil>
  void corners(Index h, const FT& weight, Stencil& s) const
  {
    const FT share = weight / FT(static_cast<int>(level.degree(h)));
    Index g = h;
    do s.add(level.target(g), share);
    while ((g = level.next(g)) != h);
  }

  const PN::Level_connectivity& level;
  FT smoothing; // 1 - tension
};

struct Tension_scheme
{
  using Host = PN::PQQ_host;

  template <class FT>
  Tension_mask<FT> mask(const PN::Level_connectivity& level, unsigned /*round*/) const
  {
    return {level, FT(1 - tension)};
  }

  double tension;
};

// Tension 0 is Catmull-Clark.
bool is_generalization(const Mesh& control)
{
  const Normals normals = PN::estimate_control_normals(control);
  return largest_distance(
           refined<CGAL::Sequential_tag>(control, normals, Tension_scheme{0}, 2),
           refined<CGAL::Sequential_tag>(control, normals, PN::CatmullClark_scheme(), 2)) < 1e-13;
}

int main(int argc, char** argv)
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/wheel.off");
  const Tension_scheme scheme{argc > 2 ? std::atof(argv[2]) : 0.25};
  if (!try_scheme(filename, scheme, "user_scheme_quads.ply")) return EXIT_FAILURE;
  Mesh control;
  CGAL::IO::read_polygon_mesh(filename, control);
  return is_generalization(control) ? EXIT_SUCCESS : EXIT_FAILURE;
}

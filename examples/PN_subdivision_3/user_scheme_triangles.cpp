// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// A scheme of your own for triangles: Loop subdivision with the weights of Warren at extraordinary
// vertices. They are rational, hence exact in exact numbers.
//
// The weights are all that is written here. Linear and point-normal subdivision, several threads,
// exact numbers and eigenvalues come with them.
//
//   user_scheme_triangles [MESH]

#include "try_scheme.h"

#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <string>

template <class FT>
struct Warren_mask
{
  using Index = PN::Level_connectivity::Index;

  template <class Stencil>
  void vertex(Index v, Stencil& s) const
  {
    const Index first = level.halfedge_of_vertex(v);
    if (level.is_isolated(v)) return s.add_rest(v);
    if (level.is_border(first)) {
      s.add(level.source(first), FT(1) / FT(8));
      s.add(level.target(level.next(first)), FT(1) / FT(8));
      return s.add_rest(v);
    }
    const int n = static_cast<int>(level.valence(v));
    Index h = first;
    do {
      s.add(level.source(h), n == 3 ? FT(3) / FT(16) : FT(3) / FT(8 * n));
      h = level.next_around_target(h);
    } while (h != first);
    s.add_rest(v);
  }

  template <class Stencil>
  void edge(Index e, Stencil& s) const
  {
    const Index h = level.halfedge_of_edge(e), o = level.opposite(h);
    const bool interior = !level.is_border_edge(e);
    if (interior) {
      s.add(level.target(level.next(h)), FT(1) / FT(8));
      s.add(level.target(level.next(o)), FT(1) / FT(8));
    }
    s.add(level.target(h), FT(interior ? 3 : 4) / FT(8));
    s.add_rest(level.target(o));
  }

  const PN::Level_connectivity& level;
};

struct Warren_scheme
{
  using Host = PN::PTQ_host;

  template <class FT>
  Warren_mask<FT> mask(const PN::Level_connectivity& level, unsigned /*round*/) const
  {
    return {level};
  }
};

int main(int argc, char** argv)
{
  const std::string filename =
    argc > 1 ? argv[1] : CGAL::data_file_path("meshes/valences_3_to_12.ply");
  try {
    return try_scheme(filename, Warren_scheme(), "user_scheme_triangles.ply") ? EXIT_SUCCESS
                                                                              : EXIT_FAILURE;
  } catch (const std::invalid_argument& e) { // the mesh has other faces than triangles
    std::cerr << e.what() << std::endl;
    return EXIT_FAILURE;
  }
}

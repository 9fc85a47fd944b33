// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "pieces/make_pieces.h"

namespace pn_subdivide {

std::unique_ptr<Any_pieces> make_pieces(const Surface& surface, const Scheme_choice& choice,
                                        unsigned levels, std::size_t number)
{
  const Scheme scheme = make_scheme("--scheme", choice.scheme, choice);
  const std::optional<Normal_map> normals = normals_of(surface);
  if (!normals) return make_pieces_linearly(surface, scheme, levels, number);
  if (choice.normal_scheme && *choice.normal_scheme != choice.scheme)
    return make_pieces_with_normal_scheme(
      surface, *normals, scheme, make_scheme("--normal-scheme", *choice.normal_scheme, choice),
      levels, number);
  return make_pieces_with_normals(surface, *normals, scheme, levels, number);
}

double memory_of_pieces(const Surface& surface, const Scheme_choice& choice, unsigned levels,
                        std::size_t number)
{
  Any_pieces::Size size;
  size.vertices = surface.number_of_vertices();
  size.edges = surface.number_of_edges();
  size.faces = surface.number_of_faces();
  for (const Surface::Halfedge_index h : surface.halfedges())
    if (!surface.is_border(h)) ++size.corners;
  return std::visit(
    [&](const auto& s) {
      return CGAL::PN_subdivision_3::memory_of_pieces<std::decay_t<decltype(s)>, Kernel>(
        size, levels, number);
    },
    make_scheme("--scheme", choice.scheme, choice));
}

} // namespace pn_subdivide

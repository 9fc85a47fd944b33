// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_PIECE_ATTRIBUTES_H
#define PN_SUBDIVIDE_PIECE_ATTRIBUTES_H

#include "io/formats.h"
#include "pieces/Any_pieces.h"
#include "surface/attributes.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace pn_subdivide {

// The attributes of pieces in the output.
class Piece_attributes
{
public:
  using Piece = Any_pieces::Piece;

  Piece_attributes(Carried_attributes carried, Mesh_file output)
    : carried_(std::move(carried))
    , output_(std::move(output))
  {}

  const Carried_attributes::Table& table() const { return carried_.table(); }
  bool has_texture() const { return !table().corners.empty(); }

  // with the columns and the types of those of pieces, but without values
  Attributes like() const
  {
    Carried_attributes::Table table = this->table();
    for (auto* arrays : {&table.vertices, &table.corners})
      for (auto& array : *arrays) array.values.clear();
    return of(table, {});
  }
  // of all its vertices, faces and, face by face, corners
  Attributes of(const Piece& piece) const
  {
    if (piece.attributes() == nullptr) return like();
    const auto& level = piece.connectivity();
    std::vector<std::size_t> corners;
    for (Piece::Index f = 0; has_texture() && f < piece.number_of_faces(); ++f) {
      const Piece::Index first = level.halfedge_of_face(f);
      Piece::Index h = first;
      do {
        corners.push_back(h);
        h = level.next(h);
      } while (h != first);
    }
    return of(*piece.attributes(), corners);
  }

private:
  Attributes of(const Carried_attributes::Table& table,
                const std::vector<std::size_t>& corners) const
  {
    Attributes attributes = carried_.of_piece(table, corners);
    take_types_of_format(output_, attributes);
    return attributes;
  }

  Carried_attributes carried_;
  Mesh_file output_;
};

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_PIECE_ATTRIBUTES_H

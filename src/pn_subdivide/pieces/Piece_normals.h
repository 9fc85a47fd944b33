// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_PIECE_NORMALS_H
#define PN_SUBDIVIDE_PIECE_NORMALS_H

#include "pieces/Any_pieces.h"
#include "surface/Area_normals.h"
#include "surface/Output_normals.h"

#include <cstddef>
#include <vector>

namespace pn_subdivide {

// Which normals pieces have in the output.
struct Piece_normals
{
  bool are_written = false, with_control = false;
  bool are_of_faces = false; // of those around, and not control normals
  Normal_kind kind = Normal_kind::control;
  double scale = 1;

  Piece_normals() = default;
  Piece_normals(const Output_normals& normals, bool has_normals)
    : are_written(has_normals && normals.any())
    , with_control(has_normals && normals.with_control())
    , are_of_faces(are_written && normals.are_of_faces())
    , kind(normals.kind)
    , scale(normals.scale)
  {}

  // so many a vertex
  unsigned number() const { return (are_written ? 1 : 0) + (with_control ? 1 : 0); }
  // of faces around a piece that its own normals depend on
  unsigned rings() const { return are_of_faces ? 1 : 0; }
};

// The normals of a piece with its rings.
class Normals_of_piece
{
public:
  using Piece = Any_pieces::Piece;

  // The piece must stay.
  Normals_of_piece(const Piece& piece, const Piece_normals& normals)
    : piece_(piece)
  {
    if (!normals.are_of_faces) return;
    const auto& level = piece.connectivity();
    Area_normals sums(piece.number_of_vertices(), normals.scale);
    std::vector<Piece::Index> corners;
    for (Piece::Index f = 0; f < piece.number_of_faces(); ++f) {
      corners.clear();
      const Piece::Index first = level.halfedge_of_face(f);
      Piece::Index h = first;
      do {
        corners.push_back(level.target(h));
        h = level.next(h);
      } while (h != first);
      sums.add_face(
        corners.size(), [&](std::size_t i) { return to_triple(piece.points()[corners[i]]); },
        [&](std::size_t i) { return corners[i]; });
    }
    of_faces_ = sums.take();
  }

  Triple operator[](Piece::Index v) const { return of_faces_.empty() ? control(v) : of_faces_[v]; }
  Triple control(Piece::Index v) const { return to_triple(piece_.normals()[v]); }

private:
  const Piece& piece_;
  std::vector<Triple> of_faces_;
};

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_PIECE_NORMALS_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_PIECE_NORMALS_H
#define PN_SUBDIVIDE_PIECE_NORMALS_H

#include "io/Limit_choice.h"
#include "io/corner_normals.h"
#include "pieces/Any_pieces.h"
#include "surface/Area_normals.h"
#include "surface/Output_normals.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace pn_subdivide {

// Which normals pieces have in the output.
struct Piece_normals
{
  bool are_written = false, with_control = false;
  bool with_roundness = false;
  bool are_of_faces = false; // of those around, and not control normals
  bool are_of_wedges =
    false; // at vertices with several the sums of their different normals at the limit
  Normal_kind kind = Normal_kind::control;
  double scale = 1;

  Piece_normals() = default;
  Piece_normals(const Output_normals& normals, bool has_normals, const Limit_choice& limit)
    : are_written((has_normals || limit.normals) && normals.any())
    , with_control(has_normals && normals.with_control())
    , are_of_faces(are_written && normals.are_of_faces())
    , are_of_wedges(are_written && !are_of_faces && limit.is_used())
    , kind(normals.kind)
    , scale(normals.scale)
  {}

  // roundness goes with control normals alone
  void add_roundness()
  {
    with_roundness = with_control || (are_written && kind == Normal_kind::control);
  }

  // the numbers of a vertex, its point among them
  unsigned numbers() const
  {
    return 3 + (are_written ? 3 : 0) + (with_control ? 3 : 0) + (with_roundness ? 1 : 0);
  }
  // of faces around a piece that its own normals depend on; with creases control normals are not written
  unsigned rings() const { return are_of_faces || are_of_wedges ? 1 : 0; }
};

// The wedges of vertices that have several: at a vertex in the order of their least half-edges, as Several_wedges has
// them in the whole surface.
class Wedges_of_piece
{
public:
  using Piece = Any_pieces::Piece;
  using Index = Piece::Index;

  // The piece must stay.
  explicit Wedges_of_piece(const Piece& piece)
    : corners_(piece.corners_of_several_wedges())
    , has_several_(corners_.empty() ? 0 : piece.number_of_vertices(), false)
  {
    std::unordered_map<std::uint64_t, std::size_t> number;
    for (const Piece::Corner& c : corners_) {
      const Index v = piece.connectivity().target(c.halfedge);
      has_several_[v] = true;
      const auto [it, is_new] =
        number.try_emplace((std::uint64_t(v) << 32) + c.wedge, vertex_.size());
      if (is_new) vertex_.push_back(v);
      of_corner_.push_back(it->second);
    }
  }

  std::size_t number() const { return vertex_.size(); }
  bool at(Index v) const { return !has_several_.empty() && has_several_[v]; }
  // \pre at(the target)
  std::size_t of(Index h) const
  {
    const auto it =
      std::lower_bound(corners_.begin(), corners_.end(), h,
                       [](const Piece::Corner& c, Index other) { return c.halfedge < other; });
    return of_corner_[std::size_t(it - corners_.begin())];
  }

  // Those of the vertices, which are zero, become the sums of those of the wedges, which are behind them and go.
  void add_to_vertices(std::vector<Triple>& normals) const
  {
    const std::size_t vertices = normals.size() - vertex_.size();
    for (std::size_t w = 0; w < vertex_.size(); ++w)
      for (std::size_t k = 0; k < 3; ++k) normals[vertex_[w]][k] += normals[vertices + w][k];
    normals.resize(vertices);
    for (std::size_t v = 0; v < has_several_.size(); ++v)
      if (has_several_[v]) normals[v] = normalized(normals[v]);
  }

private:
  const std::vector<Piece::Corner>& corners_;
  std::vector<bool> has_several_;
  std::vector<Index> vertex_;          // of each wedge
  std::vector<std::size_t> of_corner_; // by their places in corners_
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
    if (normals.are_of_wedges) add_normals_of_wedges();
    if (!normals.are_of_faces) return;
    const auto& level = piece.connectivity();
    const std::size_t vertices = piece.number_of_vertices();
    const Wedges_of_piece wedges(piece);
    Area_normals sums(vertices + wedges.number(), normals.scale);
    std::vector<Piece::Index> corners;
    std::vector<std::size_t> places;
    for (Piece::Index f = 0; f < piece.number_of_faces(); ++f) {
      corners.clear();
      places.clear();
      const Piece::Index first = level.halfedge_of_face(f);
      Piece::Index h = first;
      do {
        corners.push_back(level.target(h));
        places.push_back(wedges.at(corners.back()) ? vertices + wedges.of(h) : corners.back());
        h = level.next(h);
      } while (h != first);
      sums.add_face(
        corners.size(), [&](std::size_t i) { return to_triple(piece.points()[corners[i]]); },
        [&](std::size_t i) { return places[i]; });
    }
    of_faces_ = sums.take();
    wedges.add_to_vertices(of_faces_);
  }

  Triple operator[](Piece::Index v) const
  {
    const auto sum = sums_.find(v);
    if (sum != sums_.end())
      return sum->second.number > 1 ? normalized(sum->second.of) : sum->second.of;
    return of_faces_.empty() ? control(v) : of_faces_[v];
  }
  Triple control(Piece::Index v) const { return to_triple(piece_.normals()[v]); }

private:
  struct Sum
  {
    Triple of;
    int number;
    std::vector<Triple> summands;
  };

  // as set_vertex_normals() has them, in the order of the faces
  void add_normals_of_wedges()
  {
    if (piece_.corners_of_several_wedges().empty()) return;
    std::vector<const Piece::Corner*> corners;
    for (const Piece::Corner& c : piece_.corners_of_several_wedges()) corners.push_back(&c);
    const auto& level = piece_.connectivity();
    std::sort(corners.begin(), corners.end(), [&](const auto* a, const auto* b) {
      return level.face(a->halfedge) < level.face(b->halfedge);
    });
    for (const Piece::Corner* c : corners) {
      const Triple n = to_triple(c->normal);
      Sum& sum = sums_.try_emplace(level.target(c->halfedge), Sum{{0, 0, 0}, 0, {}}).first->second;
      const auto is_same = [&](const Triple& other) { return are_equal(other, n); };
      if (std::any_of(sum.summands.begin(), sum.summands.end(), is_same)) continue;
      for (std::size_t k = 0; k < 3; ++k) sum.of[k] = sum.number == 0 ? n[k] : sum.of[k] + n[k];
      ++sum.number;
      sum.summands.push_back(n);
    }
  }

  const Piece& piece_;
  std::vector<Triple> of_faces_;
  std::unordered_map<Piece::Index, Sum> sums_; // of vertices with several wedges
};

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_PIECE_NORMALS_H

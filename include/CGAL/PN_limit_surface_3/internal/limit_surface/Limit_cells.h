// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_SURFACE_LIMIT_CELLS_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_SURFACE_LIMIT_CELLS_H

#include <CGAL/PN_limit_surface_3/internal/limit/Limit_evaluation.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Sub_level.h>
#include <CGAL/PN_limit_surface_3/internal/limit_surface/Spline_piece.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/creases/Cut_level.h>
#include <CGAL/PN_subdivision_3/internal/hosts/Edge_split.h>
#include <CGAL/PN_subdivision_3/internal/normals/Fan.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Level_refiner.h>
#include <CGAL/PN_subdivision_3/internal/rounds/Round.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// The slots of the corners of a level.
template <class Level_creases>
class Slots_of_corners
{
public:
  using Index = Level_connectivity::Index;
  Slots_of_corners(const Level_connectivity& level, No_creases)
    : level_(level)
  {}
  Index operator()(Index h) const { return level_.target(h); }

private:
  const Level_connectivity& level_;
};
template <class FT>
class Slots_of_corners<Creases<FT>> : public Corner_slots<FT>
{
  using Corner_slots<FT>::Corner_slots;
};

// A face of some level with the faces around it that its rounds and limits read. Corner 0 is at the target of `base`.
template <class Value, class Level_creases>
struct Limit_cell
{
  using Index = Level_connectivity::Index;

  Valued_level<Value> level; // values are those of the slots
  Level_creases creases;
  Index base;
  unsigned rounds; // that made the level

  Index face() const { return level.level.face(base); }
  std::vector<Index> halfedges() const
  {
    std::vector<Index> all;
    for (const Index h : halfedges_around_face(level.level, base)) all.push_back(h);
    return all;
  }
  std::vector<Index> corners() const
  {
    std::vector<Index> all = halfedges();
    for (Index& h : all) h = level.level.target(h);
    return all;
  }
};

// Cells of the control level, and the cells that a round makes of the face of a cell, each cut out with its surroundings: the
// cost does not depend on the size of the level.
template <class Scheme, class Level_creases>
class Limit_cells
{
public:
  using Index = Level_connectivity::Index;
  using FT = double;
  using Scheme_type = Scheme;
  static constexpr Index degree = Scheme::Host::refined_degree;
  using Average = Average_of_scheme<Scheme, FT>;
  using Value = typename Average::Value;
  using Cell = Limit_cell<Value, Level_creases>;
  using Level = Valued_level<Value>;
  using Cell_slots = Slots_of_corners<Level_creases>;

  Limit_cells(const Scheme& scheme, Level&& level, Level_creases&& creases)
    : scheme_(scheme)
    , control_(std::move(level))
    , creases_(std::move(creases))
    , slots_(control_.level, creases_)
  {}
  Limit_cells(const Limit_cells&) = delete;
  Limit_cells& operator=(const Limit_cells&) = delete;

  const Scheme& scheme() const { return scheme_; }
  const Level& control() const { return control_; }
  const Level_creases& creases() const { return creases_; }

  Cell of_face(Index f) const
  {
    return cut(control_.level, creases_, control_.values, slots_,
               control_.level.halfedge_of_face(f), 0);
  }

  // What a round makes of a cell: child(i) is the face at corner i, child(3) of a triangle the one in the middle. Frames are
  // parallel to the frame of the cell (of the middle triangle opposite); in a polygon the frame of each child begins at its corner.
  class Round
  {
  public:
    Round(const Limit_cells& cells, Cell&& cell)
      : cells_(cells)
      , rounds_(cell.rounds)
      , halfedges_(second_halves(cell))
      , refiner_(cells.scheme_, std::move(cell.level.level), std::move(cell.creases),
                 {cell.level.values.begin(), cell.level.values.end()}, For_chunks(), rounds_)
    {
      refiner_.refine();
      values_.assign(refiner_.values().begin(), refiner_.values().end());
      slots_.emplace(refiner_.level(), refiner_.creases());
    }

    Cell child(Index i) const
    {
      return cells_.cut(refiner_.level(), refiner_.creases(), values_, *slots_, base(i),
                        rounds_ + 1);
    }

  private:
    using Refiner = Level_refiner<Scheme, Average, Level_creases>;

    static std::vector<Index> second_halves(const Cell& cell)
    {
      const Edge_split split(cell.level.level);
      std::vector<Index> all = cell.halfedges();
      for (Index& h : all) h = split.second_half(h);
      return all;
    }

    Index next(Index h, Index n) const
    {
      for (Index i = 0; i < n; ++i) h = refiner_.level().next(h);
      return h;
    }
    Index base(Index i) const
    {
      if constexpr (degree == 4)
        return next(halfedges_[i], halfedges_.size() == 4 ? (4 - i) % 4 : 0);
      else if (i == 3)
        return Level_connectivity::opposite(next(halfedges_[1], 2));
      else
        return next(halfedges_[i], (3 - i) % 3);
    }

    const Limit_cells& cells_;
    const unsigned rounds_;
    const std::vector<Index> halfedges_; // to the corners
    Refiner refiner_;
    std::vector<Value> values_;
    std::optional<Cell_slots> slots_;
  };

  static std::vector<Index> distinct(std::vector<Index> all)
  {
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
  }

  // \name What is known of the vertices
  // calls f(level, base, kind) with the level of a cell cut open, the base there, and kind(v)
  template <class Function>
  void with_kinds(Cell& cell, const Function& f) const
  {
    Level_connectivity& level = cell.level.level;
    const auto kinds = [&](Index base, const std::vector<char>& is_corner) {
      f(level, base, [&](Index v) { return kind(level, v, is_corner); });
    };
    if constexpr (are_creases_v<Level_creases>) {
      std::vector<char> is_corner(cell.creases.number_of_slots, 0);
      for (const Crease_star& star : cell.creases.stars)
        if (cell.creases.rule(star) == Vertex_rule::corner)
          for (Index w = 0; w < star.number_of_wedges; ++w) is_corner[star.slot(w)] = 1;
      const Index face = cell.face();
      Index steps =
        0; // from the half-edge of the face, which the cut exchanges, as it may the base
      for (Index h = level.halfedge_of_face(face); h != cell.base; h = level.next(h)) ++steps;
      Cut_in_place<FT> cut(level, cell.creases);
      Index base = level.halfedge_of_face(face);
      for (; steps > 0; --steps) base = level.next(base);
      kinds(base, is_corner);
      cut.close();
    } else
      kinds(cell.base, {});
  }

private:
  static Piece_vertex kind(const Level_connectivity& level, Index v,
                           const std::vector<char>& is_corner)
  {
    constexpr Index regular = Scheme::Host::refined_degree == 4 ? 4 : 6;
    if (counted_valence(level, v) != nullptr) return Piece_vertex::irregular;
    if (!level.is_border_vertex(v))
      return level.valence(v) == regular ? Piece_vertex::interior : Piece_vertex::irregular;
    return !is_corner.empty() && is_corner[v] != 0 ? Piece_vertex::corner : Piece_vertex::border;
  }

  Cell cut(const Level_connectivity& level, const Level_creases& creases,
           const std::vector<Value>& values, const Cell_slots& slot_of, Index base,
           unsigned rounds) const
  {
    std::vector<Index> centers;
    for_each_halfedge_of_face(level, level.face(base),
                              [&](Index h) { centers.push_back(level.target(h)); });
    Sub_level part(level, distinct(centers), cut_rings(scheme_, creases), Sub_level::Keeps::walks);
    Cell cell{{{}, {}}, Level_creases(static_cast<Index>(part.vertices.size())), 0, rounds};
    std::vector<Index> origins = part.vertices;
    if constexpr (are_creases_v<Level_creases>) {
      cell.creases = part.creases(creases);
      origins = part.slot_origins(cell.creases, slot_of);
    }
    cell.level.values = values_of_part(values, origins);
    for (Index g = 0; g < part.level.number_of_halfedges(); ++g)
      if (part.halfedge(g) == base) cell.base = g;
    cell.level.level = std::move(part.level);
    return cell;
  }

  const Scheme scheme_;
  Level control_;
  Level_creases creases_;
  Cell_slots slots_;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_SURFACE_LIMIT_CELLS_H

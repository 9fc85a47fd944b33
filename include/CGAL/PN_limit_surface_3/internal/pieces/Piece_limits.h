// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_PIECES_PIECE_LIMITS_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_PIECES_PIECE_LIMITS_H

#include <CGAL/PN_limit_surface_3/internal/limit/Limit_options.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Sub_level.h>
#include <CGAL/PN_limit_surface_3/internal/limit/limits_at_slots.h>
#include <CGAL/PN_limit_surface_3/internal/pieces/Piece_refiner.h>
#include <CGAL/PN_limit_surface_3/limit/Limit_point.h>

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// Refines pieces, and puts their vertices on the limit surface.
template <class Scheme, class Average, class Level_creases, bool has_attributes>
class Piece_limits final : public Piece_refiner<Scheme, Average, Level_creases, has_attributes>
{
  using Base = Piece_refiner<Scheme, Average, Level_creases, has_attributes>;
  using typename Base::Attribute_rounds;
  using typename Base::FT;
  using Index = typename Base::Index;
  using typename Base::Last_level;
  using typename Base::Output;
  using typename Base::Part;
  using typename Base::Value;
  using typename Base::Values;
  using Result = Limit_result<Average>;

public:
  Piece_limits(const Scheme& scheme, Level_connectivity&& control, Level_creases&& creases,
               Values&& values, Attribute_rounds&& attributes, unsigned rounds,
               std::size_t number_of_pieces, unsigned rings, const For_chunks& for_chunks)
    : Base(scheme, std::move(control), std::move(creases), std::move(values), std::move(attributes),
           rounds, number_of_pieces, rings, for_chunks, cut_rings(scheme) + more_rings)
  {}

  Limit_report refine_to_limit(std::size_t piece, unsigned rings, const Limit_demand& demand,
                               const Output& out) const override
  {
    const bool has_isolated = piece == 0;
    Part part = this->last_part(piece, has_isolated);
    Valued_level<Value> level{std::move(part.level), {part.values.begin(), part.values.end()}};
    Values().swap(part.values);
    const std::vector<Index> some = vertices_of(level.level, part.elements, has_isolated,
                                                rings + (demand.surface_normals ? 1 : 0));
    Limit_demand here = demand;
    here.has_neighbors = true;
    auto limits = limits_at_slots<FT>(this->scheme(), here, this->for_chunks(), level, part.creases,
                                      this->rounds() + 1, &some, rules_cache_);
    const Last_level last_level(level.level, part.elements, part.creases, has_isolated, rings,
                                part.attributes, out);
    last_level.for_each_corner([&](Index h, Index wedge, Index slot) {
      out.put_corner(h, wedge, level.values[slot], &limits[slot]);
    });
    put_mean_normals(part.creases, limits);
    return put(last_level, part.elements.vertices, level.values, limits, demand, out);
  }

private:
  // one ring about the vertices that are kept, whose limits tell on which side normals are; one more ring that is kept;
  // and one, so that where a limit is sought by itself the rim of the piece is not the rim of the part about the vertex
  static constexpr unsigned more_rings = 3;

  // the vertices in increasing order
  static std::vector<Index> vertices_of(const Level_connectivity& level,
                                        const Piece_elements& elements, bool has_isolated,
                                        unsigned rings)
  {
    const Face_marks kept = owned_with_rings(level, elements, rings);
    std::vector<char> is_kept(level.number_of_vertices(), 0);
    for (Index h = 0; h < level.number_of_halfedges(); ++h)
      if (!level.is_border(h) && kept[level.face(h)] != 0) is_kept[level.target(h)] = 1;
    std::vector<Index> vertices;
    for (Index v = 0; v < is_kept.size(); ++v)
      if (is_kept[v] != 0 || (has_isolated && level.is_isolated(v))) vertices.push_back(v);
    return vertices;
  }

  static Limit_report put(const Last_level& last_level, const Global_ids& elements,
                          const std::vector<Value>& values, const std::vector<Result>& limits,
                          const Limit_demand& demand, const Output& out)
  {
    std::vector<Result> owned;
    const auto& vertices = last_level.vertices();
    for (Index i = 0; i < vertices.size(); ++i) {
      const Index v = vertices[i];
      out.put(i, values[v], &limits[v]);
      const bool is_first = i == 0 || vertices[i - 1] != v;
      if (is_first && elements.is_owned(v)) owned.push_back(limits[v]);
    }
    return limit_report(owned, demand);
  }

  // one cache for all pieces: rules of large valences take long to make
  const std::shared_ptr<Ring_rules_cache<Scheme, FT>> rules_cache_ =
    std::make_shared<Ring_rules_cache<Scheme, FT>>(this->scheme());
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_PIECES_PIECE_LIMITS_H

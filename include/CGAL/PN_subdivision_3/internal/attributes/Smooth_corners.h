// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_SMOOTH_CORNERS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_SMOOTH_CORNERS_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/attributes/Carried_values.h>
#include <CGAL/PN_subdivision_3/internal/attributes/Charts.h>
#include <CGAL/PN_subdivision_3/internal/attributes/Crease_rows.h>
#include <CGAL/PN_subdivision_3/internal/average/Stencil_block.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/creases/Cut_level.h>
#include <CGAL/PN_subdivision_3/internal/creases/Entry_row.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Caller_precision.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Function_ref.h>
#include <CGAL/PN_subdivision_3/internal/refinement/for_chunks.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The values of corners in charts that have seams: a value for every slot, by the rows of the level cut open.
template <class FT>
class Smooth_corners
{
public:
  using Index = Level_connectivity::Index;

  Smooth_corners(Row_values<FT>& values, Charts<FT>&& charts)
    : values_(values)
    , creases_(std::move(charts.creases()))
    , is_seam_(charts.is_seam())
    , kept_vertices_(charts.kept_vertices())
  {}

  // `smooth_mask` is that of the uncut level; null if nothing there is less than infinitely sharp
  template <class Scheme, class One_round, class Mask>
  void refine(const Scheme& scheme, const One_round& round, const Level_connectivity& level,
              const Mask* smooth_mask, const For_chunks& for_chunks)
  {
    const Cut_level<FT> cut(level, creases_);
    const Mask mask = scheme.template mask<FT>(cut.connectivity(), round.number());
    const auto vertices = static_cast<Index>(round.refined_size().vertices);
    Refined_creases<FT> refined(creases_, level, vertices);
    values_.begin_round(refined.creases.number_of_slots);
    evaluate(round.host(), mask, vertices, for_chunks);
    Crease_rows<FT, Mask> rows(level, cut, creases_, refined, mask, smooth_mask, &is_seam_);
    rows.for_each([&](Index slot, const Entry_row<FT>& row) {
      values_.evaluate(slot, row.begin(), row.end());
    });
    keep_values(values_, kept_vertices_);
    values_.end_round();
    creases_ = std::move(refined.creases);
  }

  // of every half-edge of the refined level that has a face
  template <class Function>
  void for_each_slot(const Level_connectivity& refined, const Function& f) const
  {
    for_each_corner(refined, Cut_level<FT>(refined, creases_).connectivity(), f);
  }

  static void keep_values(Row_values<FT>& values, const std::vector<Index>& vertices)
  {
    Entry_row<FT> row;
    for (const Index v : vertices) {
      row.clear();
      row.add(v, FT(1));
      values.evaluate(v, row.begin(), row.end());
    }
  }

private:
  template <class Host, class Mask>
  void evaluate(const Host& host, const Mask& mask, Index vertices,
                const For_chunks& for_chunks) const
  {
    using Rows = Stencil_block<FT>;
    const Caller_precision<FT> precision;
    for_chunks(vertices, [&](Index begin, Index end) {
      const typename Caller_precision<FT>::In_this_thread scope(precision);
      Rows rows;
      for (Index v = begin; v < end;) {
        rows.clear();
        const Index first = v;
        for (; v < end && rows.number_of_rows() < Rows::maximum_number_of_rows; ++v) {
          host.stencil(mask, v, rows.row());
          rows.close_row();
        }
        values_.evaluate(first, rows);
      }
    });
  }

  Row_values<FT>& values_;
  Creases<FT> creases_;
  std::vector<bool> is_seam_; // by control edges
  std::vector<Index> kept_vertices_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_SMOOTH_CORNERS_H

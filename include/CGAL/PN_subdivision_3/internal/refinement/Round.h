// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_REFINEMENT_ROUND_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_REFINEMENT_ROUND_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/average/PN_average_block.h>
#include <CGAL/PN_subdivision_3/schemes/Stencil.h>
#include <CGAL/PN_subdivision_3/schemes/scheme_adaptors.h>
#include <CGAL/Uncertain.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// One round of a scheme on a level: its host, its mask and the average of the rows.
template <class Scheme, class Average>
class Round
{
public:
  using Index = Level_connectivity::Index;
  using FT = typename Average::FT;
  using Value = typename Average::Value;
  using Block = typename Block_of<Average>::type;
  using Stored_value = typename Block::Stored_value;
  using Host = typename Scheme::Host;

  Round(const Scheme& scheme, const Level_connectivity& level, unsigned number)
    : host_(level, number)
    , mask_(scheme.template mask<FT>(level, number))
    , normal_mask_(make_normal_mask(scheme, level, number))
    , size_(Host::refined_size(level.size(), number))
    , number_(number)
  {}

  const Level_size& refined_size() const { return size_; }
  const Host& host() const { return host_; }

  // computes the new vertices [begin, end) from the old values, and hands them to
  // sink(first new vertex, values, how many) block by block
  template <class Sink>
  void evaluate(Index begin, Index end, const Stored_value* old, const Sink& sink) const
  {
    Stencil<FT> rows;
    [[maybe_unused]] Normal_rows normal_rows{};
    std::array<Value, block_size_v<FT>> values;
    const Block average{};
    for (Index first = begin; first < end;) {
      const Index n = std::min<Index>(end - first, block_size_v<FT>);
      rows.clear();
      for (Index i = 0; i < n; ++i) {
        host_.stencil(mask_, first + i, rows);
        rows.close_row();
      }
      if constexpr (has_normal_mask) {
        normal_rows.clear();
        for (Index i = 0; i < n; ++i) {
          host_.stencil(normal_mask_, first + i, normal_rows);
          normal_rows.close_row();
        }
      }
      evaluate_block(average, rows, normal_rows, old, values.data(), first);
      sink(first, values.data(), n);
      first += n;
    }
  }

private:
  static constexpr bool has_normal_mask = Has_normal_mask<Scheme>::value;

  struct No_mask
  {};

  using Normal_rows = std::conditional_t<has_normal_mask, Stencil<FT>, No_mask>;

  static auto make_normal_mask(const Scheme& scheme, const Level_connectivity& level,
                               unsigned number)
  {
    if constexpr (has_normal_mask)
      return scheme.template normal_mask<FT>(level, number);
    else
      return No_mask();
  }

  using Mask = decltype(std::declval<const Scheme&>().template mask<FT>(
    std::declval<const Level_connectivity&>(), 0u));
  using Normal_mask = decltype(make_normal_mask(std::declval<const Scheme&>(),
                                                std::declval<const Level_connectivity&>(), 0u));

  static void average_rows(const Block& average, const Stencil<FT>& rows,
                           [[maybe_unused]] const Normal_rows& normal_rows, const Stored_value* old,
                           Value* result)
  {
    if constexpr (has_normal_mask)
      average(rows, normal_rows, old, result);
    else
      average(rows, old, result);
  }

  void evaluate_block(const Block& average, const Stencil<FT>& rows, const Normal_rows& normal_rows,
                      const Stored_value* old, Value* result, Index first) const
  {
    if constexpr (std::is_floating_point_v<FT>)
      average_rows(average, rows, normal_rows, old, result);
    else
      try {
        average_rows(average, rows, normal_rows, old, result);
      } catch (const Uncertain_conversion_exception&) {
        throw std::domain_error(
          "PN_subdivision_3: the precision of the number type does not decide "
          "whether the normal of vertex " +
          std::to_string(first) + " in round " + std::to_string(number_) +
          " vanishes or is opposite to a neighbor's: use a higher precision");
      }
  }

  Host host_;
  Mask mask_;
  Normal_mask normal_mask_;
  Level_size size_;
  unsigned number_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_REFINEMENT_ROUND_H

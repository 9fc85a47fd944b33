// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_ROUNDS_ROUND_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_ROUNDS_ROUND_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/concepts/scheme_traits.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/numbers/number_functions.h>
#include <CGAL/PN_subdivision_3/internal/package_parameters.h>
#include <CGAL/PN_subdivision_3/internal/rounds/Curvature_transfer.h>
#include <CGAL/PN_subdivision_3/internal/rows/PN_average_block.h>
#include <CGAL/PN_subdivision_3/internal/rows/Stencil_block.h>
#include <CGAL/PN_subdivision_3/internal/schemes/scheme_of_call.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#include <CGAL/PN_subdivision_3/schemes/Grid_average.h>
#include <CGAL/Uncertain.h>
#include <CGAL/assertions.h>
#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <array>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

template <class Scheme, class FT>
using Average_of_scheme = std::conditional_t<is_pn_v<Scheme> && Has_grid_rows<Scheme>::value,
                                             Grid_average<FT>, Average_of<is_pn_v<Scheme>, FT, 3>>;

// the average with the roundness of the scheme, where that is one number
template <class Average, class Scheme>
Average average_of([[maybe_unused]] const Scheme& scheme)
{
  Average average{};
  if constexpr (!std::is_null_pointer_v<Outermost<Is_with_roundness, Scheme>> &&
                has_normal_v<typename Average::Value>)
    average.roundness = outermost<Is_with_roundness>(scheme)->of_all();
  return average;
}

// One round of a scheme (what is defined behind the class may be compiled once): its host on a level, its mask, and the average of the rows. The mask may
// see another level than the host; the old values belong to the mask's level.
template <class Scheme, class Average>
class Round
{
public:
  using Index = Level_connectivity::Index;
  using FT = typename Average::FT;
  using Value = typename Average::Value;
  using Block = typename Block_of<Average>::type;
  using Host = typename Scheme::Host;
  static constexpr bool has_transfers = Has_curvature_transfer<Scheme>::value;
  // takes (first new vertex, the rows of it and of the vertices behind it)
  using Rows_sink = Function_ref<void(Index, const Stencil_block<FT>&)>;
  // takes (first new vertex, values, how many)
  using Sink = Function_ref<void(Index, const Value*, Index)>;
  // takes (new vertices, values, how many)
  using List_sink = Function_ref<void(const Index*, const Value*, Index)>;

  Round(const Scheme& scheme, const Level_connectivity& level, unsigned number)
    : Round(scheme, level, number, [] {})
  {}
  // cut() may cut the level open, for the masks, once its host has been made
  template <class Cut>
  Round(const Scheme& scheme, const Level_connectivity& level, unsigned number, const Cut& cut)
    : mask_level_(level)
    , host_(level, number)
    , size_(Host::refined_size(level.size(), number))
    , mask_((cut(), scheme.template mask<FT>(level, number)))
    , normal_mask_(make_normal_mask(scheme, level, number))
    , has_own_normals_(internal::facts_of(scheme).has_normal_mask)
    , average_(average_of<Average>(scheme))
    , number_(number)
  {}

  const Level_size& refined_size() const { return size_; }
  const Host& host() const { return host_; }
  const auto& mask() const { return mask_; }
  // where the normals have one of their own
  bool has_own_normals() const { return has_own_normals_; }
  const auto& normal_mask() const { return normal_mask_; }
  const Average& average() const { return average_; }
  unsigned number() const { return number_; }

  // The rows of these vertices, in increasing order, are not needed: the values come from elsewhere.
  // An undecided comparison in these rows is no error.
  void set_vertices_on_creases(std::vector<Index> vertices) { on_creases_ = std::move(vertices); }

  // What stands in place of the normals of the rows, where the scheme transfers curvature; found from
  // the old values, before the round is evaluated.
  using Transfers = std::conditional_t<has_transfers, Transferred_normals<FT>, No_transfers>;
  Transfers transfers(const Value* old, const For_chunks& for_chunks) const;

  // Computes the new vertices [begin, end) from the old values, and hands them to the sink block by
  // block. A rows_sink, which averages other values, too, gets the rows of the blocks.
  void evaluate(Index begin, Index end, const Value* old, const Transfers& transfers, Sink sink,
                const Rows_sink* rows_sink = nullptr) const;

  // the new vertices that are listed, to the same bits; as the rows have them, without transfers
  void evaluate(const Index* begin, const Index* end, const Value* old, List_sink sink) const;

  // calls f(vertex) for every entry of the rows of a new vertex
  template <class Function>
  void for_each_entry(Index new_vertex, Stencil_block<FT>& buffer, const Function& f) const
  {
    const auto call = [&](const auto& mask) {
      buffer.clear();
      host_.stencil(mask, new_vertex, buffer.row());
      buffer.close_row();
      for (const auto* e = buffer.begin(0); e != buffer.end(0); ++e) f(e->vertex);
    };
    call(mask_);
    if constexpr (has_normal_mask)
      if (has_own_normals_) call(normal_mask_);
  }

private:
  static constexpr bool has_normal_mask = Has_normal_mask<Scheme>::value;

  using Normal_rows = std::conditional_t<has_normal_mask, Stencil_block<FT>, Not_given>;

  static auto make_normal_mask(const Scheme& scheme, const Level_connectivity& level,
                               unsigned number)
  {
    if constexpr (has_normal_mask)
      return scheme.template normal_mask<FT>(level, number);
    else
      return Not_given();
  }

  using Mask = decltype(std::declval<const Scheme&>().template mask<FT>(
    std::declval<const Level_connectivity&>(), 0u));
  using Normal_mask = decltype(make_normal_mask(std::declval<const Scheme&>(),
                                                std::declval<const Level_connectivity&>(), 0u));

  // the i-th of the new vertices is vertex(i)
  template <class Vertex, class Block_sink>
  void evaluate_blocks(Index begin, Index end, const Value* old, const Vertex& vertex,
                       const Block_sink& sink, const Rows_sink* rows_sink = nullptr) const
  {
    Stencil_block<FT> rows;
    [[maybe_unused]] Normal_rows normal_rows{};
    std::array<Value, block_size_v<FT>> values;
    Index most = block_size_v<FT>;
    for (Index first = begin; first < end;) {
      const Index n = (std::min<Index>)(end - first, most);
      compute(first, n, vertex, rows, normal_rows, old, values.data());
      if (rows_sink != nullptr) (*rows_sink)(first, rows);
      sink(first, values.data(), n);
      first += n;
      // rows as long as large valences come alone, so that a block stays in the cache
      constexpr std::size_t many_entries = 1 << 14;
      most = rows.number_of_entries() > many_entries ? 1 : Index(block_size_v<FT>);
    }
  }

  template <class Any_mask, class Vertex>
  void emit_row(const Any_mask& mask, Index first, Index n, const Vertex& vertex,
                Stencil_block<FT>& rows) const
  {
    rows.clear();
    for (Index i = 0; i < n; ++i) {
      host_.stencil(mask, vertex(first + i), rows.row());
      rows.close_row();
      CGAL_precondition_msg(is_affine_row(rows.begin(i), rows.end(i)),
                            "PN_subdivision_3: a row of the mask is empty, names a vertex that "
                            "does not exist, or has weights that do not sum to 1");
    }
  }

  // Debug builds only: the rows may be those of a user's mask
  template <class Entry>
  bool is_affine_row(const Entry* begin, const Entry* end) const
  {
    FT sum(0), sizes(0);
    for (const Entry* e = begin; e != end; ++e) {
      if (e->vertex >= mask_level_.number_of_vertices()) return false;
      sum += e->weight;
      sizes += CGAL::abs(e->weight);
    }
    const FT error = CGAL::abs(FT(sum - FT(1)));
    return begin != end &&
           !CGAL::certainly(is_greater(error, FT(FT(64) * machine_epsilon<FT>() * sizes)));
  }

  template <class Vertex>
  void compute(Index first, Index n, const Vertex& vertex, Stencil_block<FT>& rows,
               [[maybe_unused]] Normal_rows& normal_rows, const Value* old, Value* result) const
  {
    const auto averages = [&](Index begin, Index number, Value* values) {
      const Block block(average_);
      emit_row(mask_, begin, number, vertex, rows);
      if constexpr (has_normal_mask)
        if (has_own_normals_) {
          emit_row(normal_mask_, begin, number, vertex, normal_rows);
          block(rows, normal_rows, old, values);
          return;
        }
      block(rows, old, values);
    };
    if constexpr (std::is_floating_point_v<FT>)
      averages(first, n, result);
    else
      try {
        averages(first, n, result);
      } catch (const Uncertain_conversion_exception&) {
        for (Index i = 0; i < n; ++i)
          compute_alone(
            vertex(first + i), [&] { averages(first + i, 1, result + i); }, result[i]);
      }
  }

  // a row of a block in which a comparison is undecided
  template <class Average_row>
  void compute_alone(Index vertex, const Average_row& average_row, Value& result) const
  {
    if (std::binary_search(on_creases_.begin(), on_creases_.end(), vertex)) {
      result = Value{};
      return;
    }
    name_undecided<FT>(average_row, [&] {
      return "whether the normal of vertex " + std::to_string(vertex) + " in round " +
             std::to_string(number_) + " vanishes or is opposite to a neighbor's";
    });
  }

  const Level_connectivity& mask_level_;
  Host host_;
  Level_size size_;
  Mask mask_;
  Normal_mask normal_mask_;
  bool has_own_normals_;
  Average average_;
  unsigned number_;
  std::vector<Index> on_creases_;
};

template <class Scheme, class Average>
auto Round<Scheme, Average>::transfers([[maybe_unused]] const Value* old,
                                       [[maybe_unused]] const For_chunks& for_chunks) const
  -> Transfers
{
  if constexpr (has_transfers)
    return Transferred_normals<FT>(
      mask_level_, mask_.separated_vertices(), Host::refined_degree, for_chunks,
      [&](Index v, std::vector<Index>& ring) { append_new_ring(mask_level_, host_, v, ring); },
      [&](const Index* vertices, Index number, Value* values) {
        evaluate(vertices, vertices + number, old,
                 [&](const Index* first, const Value* v, Index n) {
                   std::copy(v, v + n, values + (first - vertices));
                 });
      });
  else
    return {};
}

template <class Scheme, class Average>
void Round<Scheme, Average>::evaluate(Index begin, Index end, const Value* old,
                                      const Transfers& transfers, Sink sink,
                                      const Rows_sink* rows_sink) const
{
  evaluate_blocks(
    begin, end, old, [](Index i) { return i; },
    [&](Index first, Value* values, Index n) {
      transfers.put(first, n, values);
      sink(first, values, n);
    },
    rows_sink);
}

template <class Scheme, class Average>
void Round<Scheme, Average>::evaluate(const Index* begin, const Index* end, const Value* old,
                                      List_sink sink) const
{
  evaluate_blocks(
    0, static_cast<Index>(end - begin), old, [&](Index i) { return begin[i]; },
    [&](Index first, const Value* values, Index n) { sink(begin + first, values, n); });
}

// The new vertices [begin, end) of a round, by chunks. The sink gets a few neighboring ones with every call, which come from
// several threads if for_chunks does.
template <class Plain_round>
void evaluate_rows(const Plain_round& round, typename Plain_round::Index begin,
                   typename Plain_round::Index end, const typename Plain_round::Value* old,
                   const typename Plain_round::Transfers& transfers, const For_chunks& for_chunks,
                   typename Plain_round::Sink sink,
                   const typename Plain_round::Rows_sink* rows_sink = nullptr)
{
  using Index = typename Plain_round::Index;
  for_chunks.in_precision<typename Plain_round::FT>(end - begin, [&](Index first, Index last) {
    round.evaluate(begin + first, begin + last, old, transfers, sink, rows_sink);
  });
}

// only the new vertices that are listed, as their rows have them, without transfers
template <class Plain_round>
void evaluate_rows(const Plain_round& round, const typename Plain_round::Index* vertices,
                   typename Plain_round::Index number, const typename Plain_round::Value* old,
                   const For_chunks& for_chunks, typename Plain_round::List_sink sink)
{
  using Index = typename Plain_round::Index;
  for_chunks.in_precision<typename Plain_round::FT>(number, [&](Index first, Index last) {
    round.evaluate(vertices + first, vertices + last, old, sink);
  });
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_ROUNDS_ROUND_H

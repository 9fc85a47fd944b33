// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_RING_RULES_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_RING_RULES_H

#include <CGAL/PN_limit_surface_3/internal/limit/Limit_options.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Limit_weights.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Ring_eigenvectors.h>
#include <CGAL/PN_subdivision_3/hosts/Sqrt3_host.h>
#include <CGAL/PN_subdivision_3/internal/concepts/scheme_traits.h>
#include <CGAL/PN_subdivision_3/internal/rounds/Round.h>
#include <CGAL/PN_subdivision_3/internal/rows/PN_average_block.h>
#include <CGAL/PN_subdivision_3/internal/rows/Stencil_block.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <type_traits>
#include <unordered_map>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// A ring in a level, and in the next one.
struct Ring_pair
{
  std::vector<Level_connectivity::Index> ring, next_ring;
};

// A round on a level about a ring. Where the rules of rounds take turns, some of them make a ring class.
struct Ring_round
{
  const Level_connectivity& level;
  unsigned number;
  Ring_pair rings;
};

// In this order, too, the weights of a row shall sum to 1: the largest, the first one of those that are equal but for rounding, comes
// last and is what the others leave.
template <class FT>
void put_rest_last([[maybe_unused]] Ring_row<FT>& row)
{
  if constexpr (std::is_floating_point_v<FT>) {
    FT largest(0), sum(0);
    for (const auto& [place, weight] : row) largest = (std::max)(largest, std::abs(weight));
    const auto rest = std::find_if(row.begin(), row.end(), [&](const auto& e) {
      return std::abs(e.weight) >= largest * FT(1 - 1e-5);
    });
    std::rotate(rest, rest + 1, row.end());
    for (std::size_t i = 0; i + 1 < row.size(); ++i) sum += row[i].weight;
    row.back().weight = FT(1) - sum;
  }
}

// The rows of the next ring over the places of the ring, in the order of these: a mask begins where edges of the
// level do, and sums shall have the same bits wherever a ring of the kind was met first. None if a row leaves the ring.
template <class FT, class Host, class Mask>
std::optional<Ring_matrix<FT>> ring_matrix(const Host& host, const Mask& mask,
                                           const Ring_pair& rings)
{
  std::unordered_map<std::uint32_t, std::uint32_t> place;
  for (const auto v : rings.ring) place.emplace(v, static_cast<std::uint32_t>(place.size()));
  Ring_matrix<FT> matrix;
  Stencil_block<FT> rows;
  for (const auto v : rings.next_ring) {
    rows.clear();
    host.stencil(mask, v, rows.row());
    rows.close_row();
    matrix.emplace_back();
    for (auto e = rows.begin(0); e != rows.end(0); ++e) {
      const auto found = place.find(e->vertex);
      if (found == place.end()) return std::nullopt;
      matrix.back().push_back({found->second, e->weight});
    }
    sort_stably(matrix.back(), [](const auto& entry) { return entry.vertex; });
    put_rest_last<FT>(matrix.back());
  }
  return matrix;
}

// the matrix of one round after the other
template <class FT>
Ring_matrix<FT> product(const Ring_matrix<FT>& last, const Ring_matrix<FT>& first)
{
  Ring_matrix<FT> result;
  for (const Ring_row<FT>& row : last) {
    std::map<std::uint32_t, FT> sums;
    for (const auto& [i, x] : row)
      for (const auto& [j, weight] : first[i]) {
        const auto at = sums.emplace(j, FT(0)).first;
        at->second += x * weight;
      }
    result.emplace_back();
    for (const auto& [j, sum] : sums) result.back().push_back({j, sum});
  }
  return result;
}

// Rows over rings that lie side by side, the values of place p of ring c at p * copies + c, ready for
// the average of a block.
template <class FT>
std::vector<Stencil_block<FT>> ring_blocks(const Ring_matrix<FT>& matrix, std::size_t copies)
{
  constexpr std::size_t most = Stencil_block<FT>::maximum_number_of_rows;
  std::vector<Stencil_block<FT>> blocks;
  for (const auto& row : matrix)
    for (std::size_t c = 0; c < copies; ++c) {
      if (blocks.empty() || blocks.back().number_of_rows() == most) blocks.emplace_back();
      for (const auto& [place, weight] : row)
        blocks.back().row().add(static_cast<std::uint32_t>(place * copies + c), weight);
      blocks.back().close_row();
    }
  return blocks;
}

// All that rings of one kind share, made of the rows of the scheme's own mask: their matrix, the limit
// mask, the tangent masks.
template <class Scheme, class FT>
class Ring_rules
{
public:
  using Average = Average_of_scheme<Scheme, FT>;
  using Value = typename Average::Value;
  using Block = typename Block_of<Average>::type;

  // Of the scheme in some rounds, each on the level that the one before makes; not valid if the rows leave
  // the ring, or if the limit mask does not exist.
  Ring_rules(const Scheme& scheme, const std::vector<Ring_round>& rounds, const Ring_layout& layout)
    : block_(average_of<Average>(scheme))
    , size_(rounds.front().rings.ring.size())
  {
    for (const Ring_round& r : rounds)
      largest_size_ = (std::max)(largest_size_, r.rings.ring.size());
    copies_ = (std::max)(std::size_t(1), block_size_v<FT> / largest_size_);
    const auto mask_of = [&](auto number, const Ring_round& r) {
      return scheme.template mask<decltype(number)>(r.level, r.number);
    };
    const auto masks = set_rules(rounds, layout, mask_of, points_);
    if (!masks) return;
    is_interpolating_ = points_.limit_row.size() == 1;
    if constexpr (may_have_normal_rows) {
      has_normal_rows_ = facts_of(scheme).has_normal_mask;
      const auto normal_mask_of = [&](auto number, const Ring_round& r) {
        return scheme.template normal_mask<decltype(number)>(r.level, r.number);
      };
      if (has_normal_rows_ && !set_rules(rounds, layout, normal_mask_of, normals_)) return;
    }
    if (facts_of(scheme).transfers_curvature && !layout.at_border && layout.number > 2 &&
        layout.number != (Scheme::Host::refined_degree == 4 ? 4 : 6))
      transfer_valence_ = static_cast<Level_connectivity::Index>(layout.number);
    is_at_border_ = layout.at_border;
    if (layout.first == 1) number_of_neighbors_ = layout.number;
    masks_ = *masks;
    is_valid_ = true;
  }

  bool is_valid() const { return is_valid_; }
  std::size_t size() const { return size_; }
  // the largest size of the ring in any round
  std::size_t largest_size() const { return largest_size_; }
  // how many rounds make a step
  unsigned rounds() const { return static_cast<unsigned>(points_.rows.size()); }
  // how many rings are refined together
  std::size_t copies() const { return copies_; }
  // whether the limit point is the vertex
  bool is_interpolating() const { return is_interpolating_; }

  // the rows as they are, for the points and for the normals
  const Ring_matrix<FT>& matrix() const { return points_.matrix; }
  const Ring_matrix<FT>& normal_matrix() const { return of_normals().matrix; }
  const Ring_row<FT>& limit_row() const { return points_.limit_row; }
  const Ring_row<FT>& normal_limit_row() const { return of_normals().limit_row; }

  bool has_tangents() const { return !tangents()[0].empty(); }
  const std::array<std::vector<double>, 2>& tangents() const { return masks_.tangents; }
  double lambda() const { return masks_.lambda; }
  double normal_ratio() const { return masks_.normal_ratio; }
  double largest_other() const { return masks_.largest_other; }
  bool is_at_border() const { return is_at_border_; }
  bool has_own_normals() const { return has_normal_rows_; }
  // the neighbors of the vertex at place 0; 0 about faces
  std::size_t number_of_neighbors() const { return number_of_neighbors_; }

  // the roundness at a limit
  static double roundness_at([[maybe_unused]] const Value& limit)
  {
    if constexpr (is_pn_v<Scheme>)
      return close_double(limit.roundness);
    else
      return 1;
  }

  // the valence of the vertex, if the rounds transfer curvature in its ring; otherwise 0
  Level_connectivity::Index transfer_valence() const { return transfer_valence_; }

  // The ratio of the geometric series that the differences |L_{k+1} - L_k| become. What is transferred
  // falls by 1/2 a round, and its effect on L by lambda^2 more.
  double error_ratio() const
  {
    const double lambda2 = lambda() * lambda();
    const double ratio = (std::max)(lambda2 * lambda2, largest_other() * largest_other());
    return (std::min)(0.9, transfer_valence_ == 0 ? ratio : (std::max)(ratio, lambda2 / 2));
  }
  double error_factor() const { return limit_error_factor(error_ratio()); }

  // the rings after a step; the rings before it may be overwritten
  void refine(Value* rings, Value* next) const
  {
    for (unsigned r = 0; r < rounds(); ++r) {
      if (r != 0) std::copy(next, next + largest_size_ * copies_, rings);
      average(points_.rows[r], has_normal_rows_ ? &normals_.rows[r] : nullptr, rings, next);
    }
  }
  // the averages of the limit mask, one a ring
  void limit(const Value* rings, Value* result) const
  {
    average(points_.limit, has_normal_rows_ ? &normals_.limit : nullptr, rings, result);
  }

private:
  static constexpr bool may_have_normal_rows = Has_normal_mask<Scheme>::value;

  using Blocks = std::vector<Stencil_block<FT>>;

  // the weights of points, or of normals
  struct Weights
  {
    std::vector<Blocks> rows; // of each round
    Blocks limit;
    Ring_matrix<FT> matrix; // of all rounds
    Ring_row<FT> limit_row;
  };

  struct Tangents
  {
    std::array<std::vector<double>, 2> tangents;
    double lambda = 0, normal_ratio = 0, largest_other = 0;
  };

  const Weights& of_normals() const { return has_normal_rows_ ? normals_ : points_; }

  // mask_of(number, round) gives the mask of a round in a number type
  template <class Mask_of>
  std::optional<Tangents> set_rules(const std::vector<Ring_round>& rounds,
                                    const Ring_layout& layout, const Mask_of& mask_of,
                                    Weights& rules) const
  {
    using Real = Ring_eigenvectors::Real;
    Ring_matrix<Real> real_matrix;
    for (const Ring_round& r : rounds) {
      const typename Scheme::Host host(r.level, r.number);
      const auto rows = ring_matrix<FT>(host, mask_of(FT(), r), r.rings);
      const auto real_rows = ring_matrix<Real>(host, mask_of(Real(), r), r.rings);
      if (!rows || !real_rows) return std::nullopt;
      rules.matrix = after<FT>(*rows, rules.matrix);
      real_matrix = after<Real>(*real_rows, real_matrix);
      rules.rows.push_back(ring_blocks<FT>(*rows, copies_));
    }
    const Ring_eigenvectors masks(real_matrix, layout);
    if (masks.limit().empty()) return std::nullopt;
    rules.limit_row = limit_weights<FT>(masks.limit(), rules.matrix);
    rules.limit = ring_blocks<FT>({rules.limit_row}, copies_);
    Tangents result{{}, masks.lambda(), masks.normal_ratio(), masks.largest_other()};
    if (masks.has_tangents())
      for (std::size_t i = 0; i < 2; ++i)
        result.tangents[i].assign(masks.tangents()[i].begin(), masks.tangents()[i].end());
    return result;
  }

  // the matrix of a round after those before; other hosts than that of sqrt(3) have one
  template <class Number>
  static Ring_matrix<Number> after(const Ring_matrix<Number>& last,
                                   [[maybe_unused]] const Ring_matrix<Number>& first)
  {
    if constexpr (std::is_same_v<typename Scheme::Host, Sqrt3_host>)
      if (!first.empty()) return product<Number>(last, first);
    return last;
  }

  void average(const Blocks& rows, const Blocks* normal_rows, const Value* old, Value* result) const
  {
    for (std::size_t b = 0; b < rows.size(); ++b) {
      if (normal_rows == nullptr) block_(rows[b], old, result);
      if constexpr (may_have_normal_rows)
        if (normal_rows != nullptr) block_(rows[b], (*normal_rows)[b], old, result);
      result += rows[b].number_of_rows();
    }
  }

  Block block_;
  std::size_t size_, largest_size_ = 0, copies_ = 1, number_of_neighbors_ = 0;
  bool is_valid_ = false, is_interpolating_ = false, is_at_border_ = false;
  bool has_normal_rows_ = false; // otherwise the normals are refined by the rows of the points
  Weights points_, normals_;
  Tangents masks_;
  Level_connectivity::Index transfer_valence_ = 0;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_RING_RULES_H

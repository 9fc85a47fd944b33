// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_RING_CLASS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_RING_CLASS_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/average/PN_average_block.h>
#include <CGAL/PN_subdivision_3/internal/average/Stencil_block.h>
#include <CGAL/PN_subdivision_3/internal/limit/Limit_weights.h>
#include <CGAL/PN_subdivision_3/internal/limit/Ring_masks.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Round.h>
#include <CGAL/PN_subdivision_3/schemes/scheme_adaptors.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// A ring in a level, and in the next one.
struct Ring_pair
{
  std::vector<Level_connectivity::Index> ring, next_ring;
};

// The rows of the next ring over the places of the ring; none if a row leaves the ring.
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
      matrix.back().emplace_back(found->second, e->weight);
    }
  }
  return matrix;
}

template <class Scheme>
constexpr bool is_pn_v = !Is_linear<Scheme>::value;

template <class Scheme, class FT>
using Average_of_scheme =
  std::conditional_t<is_pn_v<Scheme>, PN_average<FT, 3>, Linear_average<FT, 3>>;

// Rows over rings that lie side by side, the values of place p of ring c at p * copies + c, ready for
// the average of a block.
template <class FT>
class Ring_rows
{
public:
  static constexpr std::size_t most = Stencil_block<FT>::maximum_number_of_rows;

  Ring_rows() = default;
  Ring_rows(const Ring_matrix<FT>& matrix, std::size_t copies)
  {
    for (const auto& row : matrix)
      for (std::size_t c = 0; c < copies; ++c) {
        if (blocks_.empty() || blocks_.back().number_of_rows() == most) blocks_.emplace_back();
        for (const auto& [place, weight] : row)
          blocks_.back().row().add(static_cast<std::uint32_t>(place * copies + c), weight);
        blocks_.back().close_row();
      }
  }

  const std::vector<Stencil_block<FT>>& blocks() const { return blocks_; }

private:
  std::vector<Stencil_block<FT>> blocks_;
};

// All that rings of one kind share, made of the rows of the scheme's own mask: their matrix, the limit
// mask, the tangent masks.
template <class Scheme, class FT>
class Ring_class
{
public:
  using Average = Average_of_scheme<Scheme, FT>;
  using Value = typename Average::Value;
  using Block = typename Block_of<Average>::type;
  using Stored_value = typename Block::Stored_value;

  // Of the scheme on a level in a round; not valid if the rows leave the ring, or if the limit mask
  // does not exist.
  Ring_class(const Scheme& scheme, const Level_connectivity& level, unsigned round,
             const Ring_pair& rings, const Ring_layout& layout)
    : size_(rings.ring.size())
    , copies_((std::max)(std::size_t(1), block_size_v<FT> / size_))
  {
    using Real = Ring_masks::Real;
    const typename Scheme::Host host(level, round);
    const auto rows = ring_matrix<FT>(host, scheme.template mask<FT>(level, round), rings);
    const auto real_rows = ring_matrix<Real>(host, scheme.template mask<Real>(level, round), rings);
    if (!rows || !real_rows) return;
    const Ring_masks masks(*real_rows, layout);
    if (masks.limit().empty()) return;
    rows_ = Ring_rows<FT>(*rows, copies_);
    matrix_ = *rows;
    limit_row_ = limit_weights(masks.limit(), *rows);
    limit_ = Ring_rows<FT>({limit_row_}, copies_);
    is_interpolating_ = limit_.blocks()[0].end(0) - limit_.blocks()[0].begin(0) == 1;
    if constexpr (has_normal_rows) {
      const auto normals =
        ring_matrix<FT>(host, scheme.template normal_mask<FT>(level, round), rings);
      const auto real_normals =
        ring_matrix<Real>(host, scheme.template normal_mask<Real>(level, round), rings);
      if (!normals || !real_normals) return;
      const Ring_masks normal_masks(*real_normals, layout);
      if (normal_masks.limit().empty()) return;
      normal_rows_ = Ring_rows<FT>(*normals, copies_);
      normal_matrix_ = *normals;
      normal_limit_row_ = limit_weights(normal_masks.limit(), *normals);
      normal_limit_ = Ring_rows<FT>({normal_limit_row_}, copies_);
    }
    if (Has_curvature_transfer<Scheme>::value && !layout.at_border && layout.number > 2 &&
        layout.number != (Scheme::Host::refined_degree == 4 ? 4 : 6))
      transfer_valence_ = static_cast<Level_connectivity::Index>(layout.number);
    lambda_ = masks.lambda();
    largest_other_ = masks.largest_other();
    if (masks.has_tangents())
      for (std::size_t i = 0; i < 2; ++i)
        tangents_[i].assign(masks.tangents()[i].begin(), masks.tangents()[i].end());
    is_valid_ = true;
  }

  bool is_valid() const { return is_valid_; }
  std::size_t size() const { return size_; }
  // how many rings are refined together
  std::size_t copies() const { return copies_; }
  // whether the limit point is the vertex
  bool is_interpolating() const { return is_interpolating_; }

  // the rows as they are, for the points and for the normals
  const Ring_matrix<FT>& matrix() const { return matrix_; }
  const Ring_matrix<FT>& normal_matrix() const
  {
    return has_normal_rows ? normal_matrix_ : matrix_;
  }
  const Ring_row<FT>& limit_row() const { return limit_row_; }
  const Ring_row<FT>& normal_limit_row() const
  {
    return has_normal_rows ? normal_limit_row_ : limit_row_;
  }

  bool has_tangents() const { return !tangents_[0].empty(); }
  const std::array<std::vector<double>, 2>& tangents() const { return tangents_; }
  double lambda() const { return lambda_; }
  double largest_other() const { return largest_other_; }

  // the valence of the vertex, if the rounds transfer curvature in its ring; otherwise 0
  Level_connectivity::Index transfer_valence() const { return transfer_valence_; }

  // The ratio of the geometric series that the differences |L_{k+1} - L_k| become. What is transferred
  // falls by 1/2 a round, and its effect on L by lambda^2 more.
  double error_ratio() const
  {
    const double lambda2 = lambda_ * lambda_;
    const double ratio = (std::max)(lambda2 * lambda2, largest_other_ * largest_other_);
    return (std::min)(0.9, transfer_valence_ == 0 ? ratio : (std::max)(ratio, lambda2 / 2));
  }
  // An estimate of |limit - L_{k+1}| / |L_{k+1} - L_k|: 3/2 of the sum of that series, and 1 at least,
  // while it is not one yet; up to 0.8 was measured then.
  double error_factor() const { return (std::max)(1., 1.5 * error_ratio() / (1 - error_ratio())); }

  // the rings of the next round
  void refine(const Stored_value* rings, Value* next) const
  {
    average(rows_, normal_rows_, rings, next);
  }
  // the averages of the limit mask, one a ring
  void limit(const Stored_value* rings, Value* result) const
  {
    average(limit_, normal_limit_, rings, result);
  }

private:
  static constexpr bool has_normal_rows = Has_normal_mask<Scheme>::value;

  static void average(const Ring_rows<FT>& rows, [[maybe_unused]] const Ring_rows<FT>& normal_rows,
                      const Stored_value* old, Value* result)
  {
    const Block block{};
    for (std::size_t b = 0; b < rows.blocks().size(); ++b) {
      const Stencil_block<FT>& part = rows.blocks()[b];
      if constexpr (has_normal_rows)
        block(part, normal_rows.blocks()[b], old, result);
      else
        block(part, old, result);
      result += part.number_of_rows();
    }
  }

  std::size_t size_, copies_;
  bool is_valid_ = false, is_interpolating_ = false;
  Ring_rows<FT> rows_, normal_rows_, limit_, normal_limit_;
  Ring_matrix<FT> matrix_, normal_matrix_;
  Ring_row<FT> limit_row_, normal_limit_row_;
  std::array<std::vector<double>, 2> tangents_;
  double lambda_ = 0, largest_other_ = 0;
  Level_connectivity::Index transfer_valence_ = 0;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_RING_CLASS_H

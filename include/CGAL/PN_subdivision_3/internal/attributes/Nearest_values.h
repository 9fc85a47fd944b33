// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_NEAREST_VALUES_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_NEAREST_VALUES_H

#include <CGAL/PN_subdivision_3/internal/attributes/Attribute_values.h>
#include <CGAL/PN_subdivision_3/internal/attributes/Map_values.h>
#include <CGAL/PN_subdivision_3/internal/rows/Stencil_block.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <any>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// The shares that control vertices have in a place of the control mesh, by linear interpolation: one at a control vertex,
// two on an edge, as many as it has corners in a face.
class Control_shares
{
public:
  using Index = Level_connectivity::Index;

  Control_shares() = default;
  explicit Control_shares(Index v)
    : shares_(1, {v, 1})
  {}

  void add(const Control_shares& other, float weight)
  {
    for (const Share& added : other.shares_) {
      const auto own = std::find_if(shares_.begin(), shares_.end(),
                                    [&](const Share& s) { return s.first == added.first; });
      if (own != shares_.end())
        own->second += weight * added.second;
      else
        shares_.push_back({added.first, weight * added.second});
    }
  }

  // the control vertex with the largest share; of several the first
  Index nearest() const
  {
    constexpr float rounding = 1e-5f;
    float largest = 0;
    for (const Share& s : shares_) largest = (std::max)(largest, s.second);
    Index result = Level_connectivity::null;
    for (const auto& [v, share] : shares_)
      if (share >= largest - rounding) result = (std::min)(result, v); // null is the largest
    return result;
  }

private:
  using Share = std::pair<Index, float>;

  std::vector<Share> shares_;
};

// Values that vertices have from the nearest control vertices. A new vertex is in the middle of the vertices with the main
// weights in its row: an old vertex, the ends of an edge, or the corners of a face.
template <class FT>
class Nearest_values : public Row_values<FT>
{
public:
  using typename Row_values<FT>::Index;
  using typename Row_values<FT>::Entry;
  using Row_values<FT>::null;

  explicit Nearest_values(std::unique_ptr<Copied_values> copied)
    : copied_(std::move(copied))
  {}
  // the values of a part
  Nearest_values(const Nearest_values& whole, const std::vector<Index>& sources)
    : copied_(whole.copied_->part())
  {
    take(whole.old_, sources);
  }

  bool are_equal(Index a, Index b) const override { return a == b; }
  void begin(const std::vector<Index>& sources) override
  {
    old_.clear();
    for (const Index i : sources) old_.push_back(i == null ? Control_shares() : Control_shares(i));
  }

  void begin_round(std::size_t number_of_values) override { new_.resize(number_of_values); }
  void evaluate(Index first, const Stencil_block<FT>& rows) override
  {
    for (std::size_t r = 0; r < rows.number_of_rows(); ++r)
      Nearest_values::evaluate(first + Index(r), rows.begin(r), rows.end(r));
  }
  void evaluate(Index value, const Entry* begin, const Entry* end) override
  {
    double largest = 0;
    for (const Entry* e = begin; e != end; ++e) largest = (std::max)(largest, weight(e->weight));
    const auto is_main = [&](const Entry& e) { return weight(e.weight) > largest / 2; };
    const auto number = std::count_if(begin, end, is_main);
    Control_shares& shares = new_[value] = {};
    for (const Entry* e = begin; e != end; ++e)
      if (is_main(*e)) shares.add(old_[e->vertex], 1 / float(number));
  }
  void copy(Index from, Index to) override { new_[to] = new_[from]; }
  void end_round() override
  {
    old_ = std::move(new_);
    new_.clear();
  }

  void put_all(Index number) override { put(first_indices(number)); }
  void put(const std::vector<Index>& sources) override
  {
    std::vector<Index> nearest;
    nearest.reserve(sources.size());
    for (const Index i : sources) nearest.push_back(i == null ? null : old_[i].nearest());
    copied_->put(nearest);
  }
  void keep() noexcept override { copied_->keep(); }

  std::unique_ptr<Row_values<FT>> part(const std::vector<Index>& sources) const override
  {
    return std::make_unique<Nearest_values>(*this, sources);
  }
  std::any kept_of_part() override { return copied_->kept_of_part(); }

private:
  static double weight(const FT& w) { return double(CGAL::to_double(w)); }

  void take(const std::vector<Control_shares>& from, const std::vector<Index>& sources)
  {
    std::vector<Control_shares> taken;
    for (const Index i : sources) taken.push_back(i == null ? Control_shares() : from[i]);
    old_.insert(old_.end(), taken.begin(), taken.end());
  }

  std::unique_ptr<Copied_values> copied_;
  std::vector<Control_shares> old_, new_;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_NEAREST_VALUES_H

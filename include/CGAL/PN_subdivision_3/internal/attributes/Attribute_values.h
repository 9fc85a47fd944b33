// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_ATTRIBUTE_VALUES_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_ATTRIBUTE_VALUES_H

#include <CGAL/PN_subdivision_3/attributes/Attribute_traits.h>
#include <CGAL/PN_subdivision_3/internal/attributes/Attribute_averages.h>
#include <CGAL/PN_subdivision_3/internal/attributes/Attribute_origins.h>
#include <CGAL/PN_subdivision_3/internal/attributes/Columns.h>
#include <CGAL/PN_subdivision_3/internal/hosts/Edge_split.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/rows/Stencil_block.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <boost/container/small_vector.hpp>
#include <boost/container/vector.hpp>

#include <algorithm>
#include <any>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// The values of an attribute of vertices or corners through the rounds. All levels have arrays of their own; a level is computed
// from the one before.
template <class FT>
class Row_values
{
public:
  using Index = Level_connectivity::Index;
  using Entry = typename Entry_row<FT>::Entry;
  static constexpr Index null = Level_connectivity::null;

  Row_values() = default;
  Row_values(const Row_values&) = delete;
  Row_values& operator=(const Row_values&) = delete;
  virtual ~Row_values() = default;

  // see Column
  virtual bool are_equal(Index a, Index b) const = 0;
  virtual void commit() noexcept = 0;
  virtual std::any take_list() = 0;

  // value i of the first level is the value of control element sources[i], any value where this is null
  virtual void begin(const std::vector<Index>& sources) = 0;
  virtual void begin_round(std::size_t number_of_values) = 0;
  // Begins a round whose first values, one for each element, are put. This may be at once, but by several threads only if the
  // column allows it; then all is_put() after the round.
  virtual void begin_last_round(std::size_t number_of_values, std::size_t number_of_elements,
                                bool has_threads) = 0;
  virtual void evaluate(Index value, const Entry* begin, const Entry* end) = 0;
  // for the rows from value `first` on; from several threads
  virtual void evaluate(Index first, const Stencil_block<FT>& rows) = 0;
  // a value of the new level
  virtual void copy(Index from, Index to) = 0;
  virtual void end_round() = 0;
  virtual bool is_put() const = 0;
  // puts the values of the last level: for element i value sources[i]; an element keeps its value if this is null
  virtual void put(const std::vector<Index>& sources) = 0;

  // The values of a part of the level: value i is value sources[i], any value where this is null.
  virtual std::unique_ptr<Row_values> part(const std::vector<Index>& sources) const = 0;
};

template <class FT, class Kind>
class Rows final : public Row_values<FT>
{
public:
  using Number = typename Kind::Number;
  using Of_column = typename Kind::Of_column;
  using typename Row_values<FT>::Index;
  using typename Row_values<FT>::Entry;
  using Row_values<FT>::null;

  explicit Rows(std::unique_ptr<Column<Of_column>> column, bool are_directions = false)
    : column_(std::move(column))
    , n_(column_->numbers_of_value())
    , are_directions_(are_directions)
  {}

  bool are_equal(Index a, Index b) const override { return column_->are_equal(a, b); }
  void commit() noexcept override { column_->commit(); }
  std::any take_list() override { return column_->take_list(); }

  void begin(const std::vector<Index>& sources) override
  {
    old_.clear();
    old_.resize(sources.size() * n_);
    for (std::size_t i = 0; i < sources.size(); ++i)
      if (sources[i] != null) read(sources[i], old_.data() + i * n_);
  }
  void begin_round(std::size_t number_of_values) override
  {
    new_.resize(number_of_values * n_, boost::container::default_init);
  }
  void begin_last_round(std::size_t number_of_values, std::size_t number_of_elements,
                        bool has_threads) override
  {
    puts_at_once_ = !has_threads || column_->has_concurrent_put();
    if (puts_at_once_)
      column_->begin(number_of_elements);
    else
      begin_round(number_of_values);
  }
  void evaluate(Index value, const Entry* begin, const Entry* end) override
  {
    if (!puts_at_once_) return Kind::average(begin, end, n_, old_.data(), new_.data() + value * n_);
    Buffer average(n_);
    Kind::average(begin, end, n_, old_.data(), average.data());
    put(value, 1, average);
  }
  void evaluate(Index first, const Stencil_block<FT>& rows) override
  {
    if (!puts_at_once_) return averages(rows, new_.data() + first * n_);
    Buffer results(rows.number_of_rows() * n_);
    averages(rows, results.data());
    put(first, rows.number_of_rows(), results);
  }
  void copy(Index from, Index to) override
  {
    for (std::size_t c = 0; !puts_at_once_ && c < n_; ++c) new_[to * n_ + c] = new_[from * n_ + c];
  }
  void end_round() override
  {
    if (puts_at_once_) return;
    old_ = std::move(new_);
    new_ = Values();
  }

  bool is_put() const override { return puts_at_once_; }
  void put(const std::vector<Index>& sources) override
  {
    column_->begin(sources.size());
    put(0, sources.size(), old_, sources.data());
  }

  std::unique_ptr<Row_values<FT>> part(const std::vector<Index>& sources) const override
  {
    auto result = std::make_unique<Rows>(column_->part(), are_directions_);
    result->old_.resize(sources.size() * n_);
    for (std::size_t i = 0; i < sources.size(); ++i)
      if (sources[i] != null)
        std::copy_n(old_.begin() + sources[i] * n_, n_, result->old_.begin() + i * n_);
    return result;
  }

private:
  using Values = boost::container::vector<Number>;
  using Buffer = boost::container::small_vector<Number, 32>;

  void read(Index element, Number* to) const
  {
    if constexpr (std::is_same_v<Number, Of_column>)
      column_->read(element, to);
    else
      *to = Number(element);
  }
  void averages(const Stencil_block<FT>& rows, Number* results) const
  {
    const std::size_t number = rows.number_of_rows();
    if constexpr (std::is_floating_point_v<Number> && std::is_same_v<Kind, Number_values<FT>>)
      if (n_ == 1 && rows.uniform_length() > 1)
        return scalar_averages(rows.begin(0), rows.uniform_length(), number, old_.data(), results);
    for (std::size_t r = 0; r < number; ++r)
      Kind::average(rows.begin(r), rows.end(r), n_, old_.data(), results + r * n_);
  }
  // all values are changed to what the column takes
  template <class Any_values>
  void put(Index first, std::size_t number, Any_values& values, const Index* sources = nullptr)
  {
    if constexpr (std::is_same_v<Number, Of_column>) {
      if constexpr (std::is_same_v<Kind, Number_values<FT>>)
        if (are_directions_) make_units(n_, values);
      column_->put(first, number, values.data(), sources);
    } else {
      boost::container::small_vector<Of_column, 32> nearest;
      for (const Number& shares : values) nearest.push_back(shares.nearest());
      column_->put(first, number, nearest.data(), sources);
    }
  }

  const std::unique_ptr<Column<Of_column>> column_;
  const std::size_t n_; // the numbers of a value
  const bool are_directions_;
  Values old_, new_;
  bool puts_at_once_ = false;
};

// A round of the values of corners linearly inside faces, in a host that splits edges: old corners keep their values,
// new corners get the mean of an edge or a face. Values belong to half-edges.
template <class FT, class Host>
class Linear_corners
{
public:
  using Index = Level_connectivity::Index;

  Linear_corners(const Host& host, const Level_connectivity& level, const Level_connectivity& child,
                 Row_values<FT>& values)
    : host_(host)
    , level_(level)
    , child_(child)
    , split_(level)
    , values_(values)
  {}

  void operator()(const For_chunks& for_chunks) const
  {
    for_chunks.in_precision<FT>(level_.number_of_faces(), [&](Index begin, Index end) {
      Entry_row<FT> row;
      for (Index f = begin; f < end; ++f) face(f, row);
    });
  }

private:
  static constexpr Index null = Level_connectivity::null;
  using Kind = Element_parent::Kind;

  void face(Index f, Entry_row<FT>& row) const
  {
    Index in_middle = null; // a new half-edge that leads to the middle of the face
    for (const Index h : halfedges_around_face(level_, level_.halfedge_of_face(f))) {
      const Index n = level_.next(h), begin = split_.second_half(h);
      row.clear();
      row.add(h, FT(1));
      set(begin, row);
      for (Index g = child_.next(begin); g != begin; g = child_.next(g)) {
        const Element_parent parent = host_.parent_of_vertex(child_.target(g));
        if (parent.kind == Kind::face)
          set_middle(g, h, in_middle, row);
        else if (parent.index == Level_connectivity::edge(n))
          set_behind(g, h, n, row); // the other edge is behind the corner before
      }
    }
  }

  void set(Index value, const Entry_row<FT>& row) const
  {
    values_.evaluate(value, row.begin(), row.end());
  }

  // g leads to the new vertex of the edge of n = next(h); so do other new half-edges inside the face
  void set_behind(Index g, Index h, Index n, Entry_row<FT>& row) const
  {
    const bool is_first =
      (n & 1u) == 0; // in one order on both sides of the edge, for the same bits
    row.clear();
    row.add(is_first ? h : n, FT(1) / FT(2));
    row.add(is_first ? n : h, FT(1) / FT(2));
    set(g, row);
    // round the new vertex, to the other half of the edge
    for (Index x = child_.next_around_target(g);
         x != g && child_.face(x) != null && is_inside(x, g); x = child_.next_around_target(x))
      values_.copy(g, x);
  }
  bool is_inside(Index x, Index g) const
  {
    return host_.parent_of_face(child_.face(x)).index == host_.parent_of_face(child_.face(g)).index;
  }

  void set_middle(Index g, Index h, Index& in_middle, Entry_row<FT>& row) const
  {
    if (in_middle != null) return values_.copy(in_middle, g);
    in_middle = g;
    const FT weight = FT(1) / FT(int(level_.degree(h)));
    row.clear();
    for (const Index x : halfedges_around_face(level_, h)) row.add(x, weight);
    set(g, row);
  }

  const Host& host_;
  const Level_connectivity& level_;
  const Level_connectivity& child_;
  const Edge_split split_;
  Row_values<FT>& values_;
};

// The attributes of a call, read from the mesh and its maps before the first round.
template <class FT>
struct Control_attributes : Columns_of_call
{
  std::vector<std::unique_ptr<Row_values<FT>>> vertices, corners;
  std::vector<Corner_rule> corner_rules;

  void commit() noexcept
  {
    const auto commit_all = [](auto&... lists) {
      const auto commit_list = [](auto& list) {
        for (auto& column : list) column->commit();
      };
      (commit_list(lists), ...);
    };
    commit_all(vertices, corners, edges, faces, vertex_origins, edge_origins, face_origins);
  }
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_ATTRIBUTE_VALUES_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_MAP_VALUES_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_MAP_VALUES_H

#include <CGAL/PN_subdivision_3/attributes/Attribute_traits.h>
#include <CGAL/PN_subdivision_3/internal/attributes/Attribute_values.h>
#include <CGAL/PN_subdivision_3/internal/meshes/Undoable_map.h>
#include <CGAL/PN_subdivision_3/internal/meshes/with_mesh_access.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/assertions.h>

#include <boost/container/vector.hpp>
#include <boost/property_map/property_map.hpp>

#include <any>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// an access whose elements are numbers, and a map of numbers
struct Numbers_as_elements
{
  using Index = Level_connectivity::Index;
  static Index vertex(Index i) { return i; }
  static Index halfedge_at(Index i) { return i; }
  static Index edge_at(Index i) { return i; }
  static Index face_at(Index i) { return i; }
};
template <class T, class Keys>
struct Map_of_numbers
{
  using key_type = Level_connectivity::Index;
  using value_type = T;
  using reference = const T&;
  using category = boost::read_write_property_map_tag;
  using List = boost::container::vector<T>;

  friend const T& get(const Map_of_numbers& m, key_type i) { return (*m.list)[i]; }
  friend void put(const Map_of_numbers& m, key_type i, const T& x) { (*m.list)[i] = x; }
  std::shared_ptr<List> list = std::make_shared<List>();
};
// called before the first of `number` new values is set
template <class Access, class Map, class Keys>
void begin_map(Undoable_map<Access, Map, Keys>& map, std::size_t /*number*/)
{
  map.begin();
}
template <class Access, class T, class Keys>
void begin_map(Undoable_map<Access, Map_of_numbers<T, Keys>, Keys>& map, std::size_t number)
{
  map.begin();
  map.map().list->resize(number);
}

struct Of_part
{};
// Values for a part: a map of numbers can be cut, a user's map belongs to the whole mesh.
template <class Access, class Values, class Any_map, class... Arguments>
std::unique_ptr<Values> part_of_map([[maybe_unused]] const Any_map& whole,
                                    [[maybe_unused]] const Arguments&... arguments)
{
  CGAL_assertion((std::is_same_v<Access, Numbers_as_elements>));
  if constexpr (std::is_same_v<Access, Numbers_as_elements>)
    return std::make_unique<Any_map>(whole, arguments...);
  else
    return nullptr;
}

// A map of faces or edges.
template <class Access, class Map, class Keys>
class Copied_map : public Copied_values
{
public:
  Copied_map(const Access& access, Map map, std::size_t number)
    : map_(access, map, number)
    , old_(map_.old())
  {}
  // the values of a part
  Copied_map(const Copied_map& whole, Of_part)
    : map_(whole.map_.access(), Map())
    , old_(whole.old_)
  {}

  void put(const std::vector<Index>& sources) override
  {
    begin_map(map_, sources.size());
    for (Index i = 0; i < sources.size(); ++i)
      map_.set(i, sources[i] == null ? T() : T(old_[sources[i]]));
  }
  void commit() noexcept override { map_.commit(); }
  std::unique_ptr<Copied_values> part() const override
  {
    return part_of_map<Access, Copied_values>(*this, Of_part());
  }
  std::any kept_of_part() override { return std::any(map_.map()); }

private:
  using Undoable = Undoable_map<Access, Map, Keys>;
  using T = typename Undoable::Value;

  Undoable map_;
  const std::vector<T>& old_;
};

// A map of vertices or corners.
template <class Access, class Map, class Keys, class FT,
          Attribute_rule rule = Attribute_rule::average>
class Row_map : public Row_values<FT>
{
public:
  using typename Row_values<FT>::Index;
  using typename Row_values<FT>::Entry;

  Row_map(const Access& access, Map map, const std::vector<Index>& elements)
    : map_(access, map, elements)
    , position_(elements.empty() ? 0 : elements.back() + 1)
  {
    for (Index i = 0; i < elements.size(); ++i) position_[elements[i]] = i;
  }

  bool are_equal(Index a, Index b) const override
  {
    if constexpr (std::is_same_v<Keys, Halfedge_of_mesh>)
      return map_.old()[position_[a]] == map_.old()[position_[b]];
    else
      return a == b;
  }
  // the values of a part
  Row_map(const Row_map& whole, const std::vector<Index>& sources)
    : map_(whole.map_.access(), Map())
  {
    old_.reserve(sources.size());
    for (const Index i : sources) old_.push_back(i == Row_values<FT>::null ? Sum() : whole.old_[i]);
  }

  void begin(const std::vector<Index>& sources) override
  {
    old_.clear();
    old_.reserve(sources.size());
    for (const Index i : sources)
      old_.push_back(i == Row_values<FT>::null ? Sum() : Traits::to_sum(map_.old()[position_[i]]));
  }

  void begin_round(std::size_t number_of_values) override
  {
    new_.resize(number_of_values, boost::container::default_init);
  }
  void begin_last_round(std::size_t number_of_values, bool has_threads) override
  {
    puts_at_once_ = !has_threads || has_concurrent_put_v<Map>;
    if (puts_at_once_)
      begin_map(map_, number_of_values);
    else
      begin_round(number_of_values);
  }
  void evaluate(Index first, const Stencil_block<FT>& rows) override
  {
    if (puts_at_once_)
      averages(rows, [&](std::size_t r, const Sum& x) { map_.set(first + Index(r), to_value(x)); });
    else
      averages(rows, [&](std::size_t r, const Sum& x) { new_[first + r] = x; });
  }
  void evaluate(Index value, const Entry* begin, const Entry* end) override
  {
    const auto average = affine_average<FT, Traits>(begin, end, old_.data());
    if (puts_at_once_)
      map_.set(value, to_value(average));
    else
      new_[value] = average;
  }
  void copy(Index from, Index to) override
  {
    if (!puts_at_once_) new_[to] = new_[from];
  }
  void end_round() override
  {
    if (puts_at_once_) return;
    old_ = std::move(new_);
    new_ = Values();
  }

  void put_all(Index number) override
  {
    if (!puts_at_once_) put(first_indices(number));
  }
  void put(const std::vector<Index>& sources) override
  {
    begin_map(map_, sources.size());
    for (Index i = 0; i < sources.size(); ++i)
      if (sources[i] != Row_values<FT>::null) map_.set(i, to_value(old_[sources[i]]));
  }
  void commit() noexcept override { map_.commit(); }

  std::unique_ptr<Row_values<FT>> part(const std::vector<Index>& sources) const override
  {
    return part_of_map<Access, Row_values<FT>>(*this, sources);
  }
  std::any kept_of_part() override { return std::any(map_.map()); }

private:
  using Undoable = Undoable_map<Access, Map, Keys>;
  using Traits = Attribute_traits<typename Undoable::Value, FT>;
  using Sum = typename Traits::Sum;
  using Values = boost::container::vector<Sum>;

  static typename Undoable::Value to_value(const Sum& sum)
  {
    if constexpr (rule == Attribute_rule::direction) {
      Sum unit = sum;
      make_unit(unit.data(), unit.data() + unit.size());
      return Traits::to_value(unit);
    } else
      return Traits::to_value(sum);
  }

  template <class Result>
  void averages(const Stencil_block<FT>& rows, const Result& result) const
  {
    const std::size_t n = rows.number_of_rows();
    if constexpr (std::is_same_v<Sum, std::array<FT, 1>> && std::is_floating_point_v<FT>)
      if (rows.uniform_length() > 1)
        return scalar_averages<FT>(rows.begin(0), rows.uniform_length(), n, old_.data(), result);
    for (std::size_t r = 0; r < n; ++r)
      result(r, affine_average<FT, Traits>(rows.begin(r), rows.end(r), old_.data()));
  }

  Undoable map_;
  std::vector<Index> position_; // of a control element among the elements that are read
  Values old_, new_;
  bool puts_at_once_ = false;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_MAP_VALUES_H

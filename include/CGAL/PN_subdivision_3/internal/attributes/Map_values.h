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
#include <CGAL/PN_subdivision_3/internal/meshes/with_mesh_access.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/assertions.h>

#include <boost/container/vector.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <any>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

template <class Map>
constexpr bool is_readable_v = std::is_convertible_v<typename boost::property_traits<Map>::category,
                                                     boost::readable_property_map_tag>;

// elements that are their numbers, and a map of them
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
template <class Map>
void make_room(const Map&, std::size_t /*number*/)
{}
template <class T, class Keys>
void make_room(const Map_of_numbers<T, Keys>& map, std::size_t number)
{
  map.list->resize(number);
}

// A map of the user's and what it had for the control elements, which it gets back unless the new values
// are kept.
template <class Access, class Map, class Keys>
class Restored_map
{
public:
  using Index = Level_connectivity::Index;
  using T = std::decay_t<typename boost::property_traits<Map>::value_type>;

  // `elements` are those that are read, in ascending order; none if the map cannot be read
  Restored_map(const Access& access, Map map, const std::vector<Index>& elements)
    : access_(access)
    , map_(map)
    , elements_(elements)
  {
    if constexpr (is_readable_v<Map>) {
      old_.reserve(elements.size());
      for (const Index i : elements) old_.push_back(get(map_, Keys::at(access_, i)));
    }
  }
  ~Restored_map()
  {
    if (!is_changed_) return;
    for (std::size_t i = 0; i < old_.size(); ++i) try {
        put(map_, Keys::at(access_, elements_[i]), T(old_[i]));
      } catch (...) {
      }
  }
  Restored_map(const Restored_map&) = delete;
  Restored_map& operator=(const Restored_map&) = delete;

  // the position in elements() is not the number of the element where some are left out
  const std::vector<Index>& elements() const { return elements_; }
  const std::vector<T>& old() const { return old_; }
  const Access& access() const { return access_; }
  const Map& map() const { return map_; }
  void begin(std::size_t number_of_elements)
  {
    is_changed_ = true;
    make_room(map_, number_of_elements);
  }
  void set(Index element, const T& value) { put(map_, Keys::at(access_, element), value); }
  void keep() noexcept { is_changed_ = false; }

private:
  const Access& access_;
  Map map_;
  std::vector<Index> elements_;
  std::vector<T> old_;
  bool is_changed_ = false;
};

struct Of_part
{};
// Values for a part: those of maps of numbers can be cut, a user's map is that of the whole mesh.
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

// all control elements
inline std::vector<Level_connectivity::Index> first_indices(std::size_t n)
{
  std::vector<Level_connectivity::Index> result(n);
  for (std::size_t i = 0; i < n; ++i) result[i] = static_cast<Level_connectivity::Index>(i);
  return result;
}

// A map of faces or edges.
template <class Access, class Map, class Keys>
class Copied_map : public Copied_values
{
public:
  Copied_map(const Access& access, Map map, std::size_t number)
    : map_(access, map, first_indices(number))
    , old_(map_.old())
  {}
  // of a part
  Copied_map(const Copied_map& whole, Of_part)
    : map_(whole.map_.access(), Map(), {})
    , old_(whole.old_)
  {}

  void put(const std::vector<Index>& sources) override
  {
    map_.begin(sources.size());
    for (Index i = 0; i < sources.size(); ++i)
      map_.set(i, sources[i] == null ? T() : T(old_[sources[i]]));
  }
  void keep() noexcept override { map_.keep(); }
  std::unique_ptr<Copied_values> part() const override
  {
    return part_of_map<Access, Copied_values>(*this, Of_part());
  }
  std::any kept_of_part() override { return std::any(map_.map()); }

private:
  using T = typename Restored_map<Access, Map, Keys>::T;

  Restored_map<Access, Map, Keys> map_;
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
  // of a part
  Row_map(const Row_map& whole, const std::vector<Index>& sources)
    : map_(whole.map_.access(), Map(), {})
  {
    take(whole.old_, sources);
  }

  void begin(const std::vector<Index>& sources) override
  {
    old_.clear();
    old_.reserve(sources.size());
    for (const Index i : sources)
      old_.push_back(i == Row_values<FT>::null ? typename Traits::Sum()
                                               : Traits::to_sum(map_.old()[position_[i]]));
  }

  void begin_round(std::size_t number_of_values) override
  {
    new_.resize(number_of_values, boost::container::default_init);
  }
  void begin_last_round(std::size_t number_of_values, bool has_threads) override
  {
    puts_at_once_ = !has_threads || has_concurrent_put_v<Map>;
    if (puts_at_once_)
      map_.begin(number_of_values);
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
    map_.begin(sources.size());
    for (Index i = 0; i < sources.size(); ++i)
      if (sources[i] != Row_values<FT>::null) map_.set(i, to_value(old_[sources[i]]));
  }
  void keep() noexcept override { map_.keep(); }

  std::unique_ptr<Row_values<FT>> part(const std::vector<Index>& sources) const override
  {
    return part_of_map<Access, Row_values<FT>>(*this, sources);
  }
  std::any kept_of_part() override { return std::any(map_.map()); }

private:
  using Restored = Restored_map<Access, Map, Keys>;
  using Traits = Attribute_traits<typename Restored::T, FT>;
  using Sum = typename Traits::Sum;
  using Values = boost::container::vector<Sum>;

  static auto to_value(const Sum& sum)
  {
    if constexpr (rule == Attribute_rule::direction) {
      Sum unit = sum;
      make_unit(unit.data(), unit.data() + unit.size());
      return Traits::to_value(unit);
    } else
      return Traits::to_value(sum);
  }

  void take(const Values& from, const std::vector<Index>& sources)
  {
    old_.reserve(old_.size() + sources.size());
    for (const Index i : sources)
      old_.push_back(i == Row_values<FT>::null ? typename Traits::Sum() : from[i]);
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

  Restored map_;
  std::vector<Index> position_; // of a control element among those that are read
  Values old_, new_;
  bool puts_at_once_ = false;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_MAP_VALUES_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_COLUMNS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_COLUMNS_H

#include <CGAL/PN_subdivision_3/attributes/Attribute_traits.h>
#include <CGAL/PN_subdivision_3/internal/meshes/Undoable_map.h>
#include <CGAL/PN_subdivision_3/internal/meshes/with_mesh_access.h>
#include <CGAL/PN_subdivision_3/internal/rows/Level_origins.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/parameters/Default_visitor.h>
#include <CGAL/assertions.h>

#include <boost/property_map/property_map.hpp>
#include <boost/type_traits/is_detected.hpp>

#include <any>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// The values of an attribute on the user's side: a map, an array, or a list that nobody has yet. A value is a few numbers, or
// one Number of another type. What is put can be taken back until commit().
template <class Number>
class Column
{
public:
  using Index = Level_connectivity::Index;

  Column() = default;
  Column(const Column&) = delete;
  Column& operator=(const Column&) = delete;
  virtual ~Column() = default;

  virtual std::size_t numbers_of_value() const = 0;
  // of the control mesh: whether the values of two corners are equal, and the value of an element
  virtual bool are_equal(Index a, Index b) const = 0;
  virtual void read(Index element, Number* to) const = 0;

  // to be called before the first value is put
  virtual void begin(std::size_t number_of_elements) = 0;
  // Puts the values of elements that follow one another: the values in their order or, if sources are given, those of
  // these positions; an element keeps its value if its source is null.
  virtual void put(Index first, std::size_t number, const Number* values,
                   const Index* sources = nullptr) = 0;
  virtual bool has_concurrent_put() const = 0;
  virtual void commit() noexcept = 0;

  // of a list: one for a part of the mesh with the same control values, and the values, a std::vector
  virtual std::unique_ptr<Column> part() const = 0;
  virtual std::any take_list() = 0;
};

// \name What holds the values
// Values of the control mesh are old().

template <class Access, class Map, class Keys>
class Map_store : public Undoable_map<Access, Map, Keys>
{
  using Base = Undoable_map<Access, Map, Keys>;
  static constexpr bool is_of_corners = std::is_same_v<Keys, Halfedge_of_mesh>;

public:
  using Index = Level_connectivity::Index;
  static constexpr bool has_concurrent_put = has_concurrent_put_v<Map>, is_list = false;

  Map_store(const Access& access, const Level_connectivity& level, Map map)
    : Base(access, map, elements(level))
  {
    if constexpr (is_of_corners) {
      position_.resize(level.number_of_halfedges());
      Index next = 0;
      for (const Index h : corners_of(level)) position_[h] = next++;
    }
  }

  decltype(auto) old(std::size_t i) const
  {
    if constexpr (is_of_corners)
      return Base::old()[position_[i]];
    else
      return Base::old()[i];
  }
  void begin(std::size_t) { Base::begin(); }

private:
  static auto elements(const Level_connectivity& level)
  {
    if constexpr (is_of_corners)
      return corners_of(level);
    else
      return Keys::number(level.size());
  }

  std::vector<Index> position_; // of the half-edges among those that have a face
};

// A list. A target has the values of the control mesh, and gets the list; else the lists of parts share these values.
template <class T>
class List_store
{
public:
  using List = std::vector<T>;
  static constexpr bool has_concurrent_put = !std::is_same_v<T, bool>, is_list = true;

  explicit List_store(std::shared_ptr<const List> old)
    : old_(std::move(old))
  {}
  explicit List_store(List& target)
    : old_(std::shared_ptr<const List>(), &target)
    , target_(&target)
  {}

  List_store part() const { return List_store(old_); }
  decltype(auto) old(std::size_t i) const { return (*old_)[i]; }
  void begin(std::size_t number) { list_.assign(number, T()); }
  void set(std::size_t i, const T& value) { list_[i] = value; }
  void commit() noexcept
  {
    if (target_ != nullptr) target_->swap(list_);
  }
  List take_list() { return list_.empty() ? *old_ : std::move(list_); }

private:
  std::shared_ptr<const List> old_;
  List* target_ = nullptr;
  List list_;
};

// \name Conversions
// between the numbers of an element and its values in the store, which are one, or several next to each other

template <class T>
using Equality_of = decltype(bool(std::declval<const T&>() == std::declval<const T&>()));
template <class T>
using Has_equality = boost::is_detected<Equality_of, T>;

// the components of each value as numbers FT, or one sum of the type that the traits say
template <class T, class FT>
struct Averaged
{
  using Traits = Attribute_traits<T, FT>;
  using Sum = typename Traits::Sum;
  using Number = std::conditional_t<Traits::has_components, FT, Sum>;

  static std::size_t numbers(std::size_t width)
  {
    if constexpr (Traits::has_components)
      return width * Sum().size();
    else
      return width;
  }
  static bool are_equal([[maybe_unused]] const T& a, [[maybe_unused]] const T& b)
  {
    if constexpr (Has_equality<T>::value) // of corners
      return a == b;
    else
      return false;
  }
  template <class Store>
  static void read(const Store& store, std::size_t i, std::size_t width, Number* to)
  {
    for (std::size_t j = i * width; j < (i + 1) * width; ++j) {
      const Sum sum = Traits::to_sum(store.old(j));
      if constexpr (Traits::has_components)
        for (std::size_t c = 0; c < sum.size(); ++c) *to++ = sum[c];
      else
        *to++ = sum;
    }
  }
  template <class Store>
  static T value(const Store&, const Number* from, std::size_t j, std::size_t)
  {
    if constexpr (Traits::has_components) {
      Sum sum;
      for (std::size_t c = 0; c < sum.size(); ++c) sum[c] = from[j * sum.size() + c];
      return Traits::to_value(sum);
    } else
      return Traits::to_value(from[j]);
  }
};

// Elements have one number, and control values are not asked for.
struct Without_rows
{
  static std::size_t numbers(std::size_t) { return 1; }
  template <class T>
  static bool are_equal(const T&, const T&)
  {
    return false;
  }
  template <class Store, class Number>
  static void read(const Store&, std::size_t, std::size_t, Number*)
  {}
};

// The number is that of a control element with the same value, or null for a new value.
template <class T>
struct Copied : Without_rows
{
  using Number = Level_connectivity::Index;

  template <class Store>
  static T value(const Store& store, const Number* from, std::size_t j, std::size_t width)
  {
    return *from == Level_connectivity::null ? T() : T(store.old(*from * width + j));
  }
};

// Where an element comes from, and the first control face there. The value is the former, or the number of the face.
struct Origin_and_face
{
  Control_element origin;
  Level_connectivity::Index face;
};
inline Control_element control_element(const Origin& origin)
{
  return {origin.kind, origin.index};
}
template <class T>
struct Parent : Without_rows
{
  using Number = Origin_and_face;

  template <class Store>
  static T value(const Store&, const Number* from, std::size_t, std::size_t)
  {
    if constexpr (std::is_same_v<T, Control_element>)
      return from->origin;
    else
      return static_cast<T>(from->face);
  }
};

// The column of what a store holds: element i has `width` values there, from i * width on, which are read and put by a conversion.
template <class Store, class Conversion>
class Column_of final : public Column<typename Conversion::Number>
{
public:
  using Number = typename Conversion::Number;
  using Base = Column<Number>;
  using typename Base::Index;

  template <class... Arguments>
  explicit Column_of(std::size_t width, Arguments&&... arguments)
    : store_(std::forward<Arguments>(arguments)...)
    , width_(width)
  {}

  std::size_t numbers_of_value() const override { return Conversion::numbers(width()); }
  bool are_equal(Index a, Index b) const override
  {
    for (std::size_t j = 0; j < width(); ++j)
      if (!Conversion::are_equal(store_.old(a * width() + j), store_.old(b * width() + j)))
        return false;
    return true;
  }
  void read(Index element, Number* to) const override
  {
    Conversion::read(store_, element, width(), to);
  }

  void begin(std::size_t number_of_elements) override
  {
    store_.begin(number_of_elements * width());
  }
  void put(Index first, std::size_t number, const Number* values, const Index* sources) override
  {
    const std::size_t numbers = Conversion::numbers(width());
    for (std::size_t i = 0; i < number; ++i) {
      const std::size_t source = sources == nullptr ? i : sources[i];
      if (source == Level_connectivity::null) continue;
      for (std::size_t j = 0; j < width(); ++j)
        store_.set((first + i) * width() + j,
                   Conversion::value(store_, values + source * numbers, j, width()));
    }
  }
  bool has_concurrent_put() const override { return Store::has_concurrent_put; }
  void commit() noexcept override { store_.commit(); }

  std::unique_ptr<Base> part() const override
  {
    CGAL_assertion(Store::is_list);
    if constexpr (Store::is_list)
      return std::make_unique<Column_of>(width_, store_.part());
    else
      return nullptr;
  }
  std::any take_list() override
  {
    if constexpr (Store::is_list)
      return std::any(store_.take_list());
    else
      return {};
  }

private:
  // known where it costs time
  std::size_t width() const { return Store::is_list ? width_ : 1; }

  Store store_;
  const std::size_t width_;
};

// \name Columns of a call

template <class Conversion>
using Column_pointer = std::unique_ptr<Column<typename Conversion::Number>>;
template <class Map>
using Value_of_map = std::decay_t<typename boost::property_traits<Map>::value_type>;

// an access to a mesh whose maps are read only, into lists
template <class Access>
struct Into_lists
{
  const Access& access;
};

template <class Keys, class Conversion, class Access, class Map>
Column_pointer<Conversion> column_of_map(const Access& access, const Level_connectivity& level,
                                         Map map)
{
  return std::make_unique<Column_of<Map_store<Access, Map, Keys>, Conversion>>(1, access, level,
                                                                               map);
}
// calls f(i) for the elements of a level that have values: half-edges have if they are no border
template <class Keys, class Function>
void for_each_element(const Level_connectivity& level, const Function& f)
{
  for (Level_connectivity::Index i = 0; i < Keys::number(level.size()); ++i)
    if (!std::is_same_v<Keys, Halfedge_of_mesh> || !level.is_border(i)) f(i);
}
template <class Keys, class Conversion, class Access, class Map>
Column_pointer<Conversion> column_of_map(const Into_lists<Access>& into_lists,
                                         const Level_connectivity& level, const Map& map)
{
  using T = Value_of_map<Map>;
  auto old = std::make_shared<std::vector<T>>(Keys::number(level.size()), T());
  if constexpr (is_readable_v<Map>)
    for_each_element<Keys>(level,
                           [&](auto i) { (*old)[i] = get(map, Keys::at(into_lists.access, i)); });
  return std::make_unique<Column_of<List_store<T>, Conversion>>(1, List_store<T>(std::move(old)));
}

// an array of a table, which gets the values
template <class Conversion, class Access, class Array>
Column_pointer<Conversion> column_of_array(const Access&, std::size_t width, Array& array)
{
  using Store = List_store<typename Array::value_type>;
  return std::make_unique<Column_of<Store, Conversion>>(width, array);
}
template <class Conversion, class Access, class Array>
Column_pointer<Conversion> column_of_array(const Into_lists<Access>&, std::size_t width,
                                           const Array& array)
{
  using Store = List_store<typename Array::value_type>;
  return std::make_unique<Column_of<Store, Conversion>>(width,
                                                        Store(std::make_shared<Array>(array)));
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_COLUMNS_H

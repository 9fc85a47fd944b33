// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVISION_3_DEMO_PROPERTY_ARRAYS_H
#define PN_SUBDIVISION_3_DEMO_PROPERTY_ARRAYS_H

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace pn_demo {

// Values of the elements of one kind.
class Property_array
{
public:
  explicit Property_array(std::string its_name)
    : name(std::move(its_name))
  {}
  virtual ~Property_array() = default;
  virtual void resize(std::size_t n) = 0;
  virtual std::unique_ptr<Property_array> copy() const = 0;

  const std::string name;
};

template <class T>
class Property_array_of : public Property_array
{
public:
  Property_array_of(std::string its_name, T new_value, std::size_t n)
    : Property_array(std::move(its_name))
    , values(n, new_value)
    , new_value_(std::move(new_value))
  {}
  void resize(std::size_t n) override { values.resize(n, new_value_); }
  std::unique_ptr<Property_array> copy() const override
  {
    return std::make_unique<Property_array_of>(*this);
  }

  std::vector<T> values;

private:
  T new_value_;
};

// Stays valid while the mesh grows and is moved.
template <class Index, class T>
class Array_property_map
{
public:
  using key_type = Index;
  using value_type = T;
  using reference = T&;
  using category = boost::lvalue_property_map_tag;

  Array_property_map() = default;
  explicit Array_property_map(Property_array_of<T>* array)
    : array_(array)
  {}
  T& operator[](Index i) const { return array_->values[i]; }
  friend T& get(const Array_property_map& map, Index i) { return map[i]; }
  friend void put(const Array_property_map& map, Index i, T value) { map[i] = std::move(value); }

  auto begin() const { return array_->values.cbegin(); }
  auto end() const { return array_->values.cend(); }
  Property_array_of<T>* array() const { return array_; }

private:
  Property_array_of<T>* array_ = nullptr;
};

// All arrays of the elements of one kind.
class Property_arrays
{
public:
  Property_arrays() = default;
  Property_arrays(const Property_arrays& other)
  {
    for (const auto& array : other.arrays_) arrays_.push_back(array->copy());
  }
  Property_arrays(Property_arrays&&) = default;
  Property_arrays& operator=(Property_arrays other)
  {
    arrays_.swap(other.arrays_);
    return *this;
  }

  void resize(std::size_t n)
  {
    for (const auto& array : arrays_) array->resize(n);
  }
  template <class Index, class T>
  std::pair<Array_property_map<Index, T>, bool> add(const std::string& name, T new_value,
                                                    std::size_t n)
  {
    const auto found = find<Index, T>(name);
    if (found.second) return {found.first, false};
    auto array = std::make_unique<Property_array_of<T>>(name, std::move(new_value), n);
    const Array_property_map<Index, T> map(array.get());
    arrays_.push_back(std::move(array));
    return {map, true};
  }
  template <class Index, class T>
  std::pair<Array_property_map<Index, T>, bool> find(const std::string& name) const
  {
    for (const auto& array : arrays_)
      if (array->name == name)
        if (auto* const a = dynamic_cast<Property_array_of<T>*>(array.get()))
          return {Array_property_map<Index, T>(a), true};
    return {};
  }
  template <class Map>
  void remove(Map& map)
  {
    arrays_.erase(std::find_if(arrays_.begin(), arrays_.end(),
                               [&](const auto& array) { return array.get() == map.array(); }));
    map = Map();
  }

private:
  std::vector<std::unique_ptr<Property_array>> arrays_;
};

} // namespace pn_demo

#endif // PN_SUBDIVISION_3_DEMO_PROPERTY_ARRAYS_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_ARRAY_VALUES_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_ARRAY_VALUES_H

#include <CGAL/PN_subdivision_3/attributes/Attribute_traits.h>
#include <CGAL/PN_subdivision_3/internal/attributes/Attribute_values.h>
#include <CGAL/PN_subdivision_3/internal/attributes/Map_values.h>
#include <CGAL/PN_subdivision_3/internal/rows/Level_origins.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/parameters/Default_visitor.h>

#include <CGAL/number_type_basic.h>

#include <boost/container/vector.hpp>
#include <boost/property_map/property_map.hpp>

#include <any>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

inline Control_element control_element(const Origin& origin)
{
  using Kind = Control_element::Kind;
  const Kind kind = origin.kind == Origin::Kind::vertex ? Kind::vertex
                    : origin.kind == Origin::Kind::edge ? Kind::edge
                                                        : Kind::face;
  return {kind, origin.index};
}

// What is put for the elements of the refined mesh by where they come from; `face` is the first control face
// there.
class Origin_values : public Kept_values
{
public:
  virtual void begin(std::size_t number_of_elements) = 0;
  virtual void set(Index element, const Control_element& origin, Index face) = 0;
  virtual std::unique_ptr<Origin_values> part() const = 0; // see Copied_values
};

template <class FT>
struct Corner_attribute_values
{
  std::unique_ptr<Row_values<FT>> values;
  Corner_rule rule;
};

// The attributes of a call that are copied without rows; all parts of a level share them.
struct Copied_attributes
{
  template <class T>
  using List = std::vector<std::unique_ptr<T>>;

  List<Copied_values> edges, faces;
  List<Origin_values> vertex_origins, edge_origins, face_origins;

  template <class Function>
  void for_each_list(const Copied_attributes& others, const Function& f)
  {
    f(edges, others.edges);
    f(faces, others.faces);
    f(vertex_origins, others.vertex_origins);
    f(edge_origins, others.edge_origins);
    f(face_origins, others.face_origins);
  }
  void take_parts_of_copied(const Copied_attributes& whole)
  {
    for_each_list(whole, [](auto& parts, const auto& list) {
      for (const auto& values : list) parts.push_back(values->part());
    });
  }

  Level_origins::Kinds needed_origins() const
  {
    return {!vertex_origins.empty(), !edge_origins.empty() || !edges.empty(),
            !face_origins.empty() || !faces.empty()};
  }

  void commit() noexcept
  {
    for_each_list(*this, [](auto& list, const auto&) {
      for (auto& values : list) values->commit();
    });
  }
};

// The attributes of a call, read from the mesh and its maps before the first round.
template <class FT>
struct Control_attributes : Copied_attributes
{
  List<Row_values<FT>> vertices;
  std::vector<Corner_attribute_values<FT>> corners;

  void commit() noexcept
  {
    for (auto& values : vertices) values->commit();
    for (auto& corner : corners) corner.values->commit();
    Copied_attributes::commit();
  }
};

// refuses an array that does not fit its elements
inline void check_array(const Attribute_array& array, std::size_t number, const char* kind)
{
  const auto n = [](std::size_t x) { return std::to_string(x); };
  if (array.dimension == 0)
    throw std::invalid_argument(std::string("PN_subdivision_3: an attribute of ") + kind +
                                " has dimension 0");
  if (array.values.size() / array.dimension == number && array.values.size() % array.dimension == 0)
    return;
  throw std::invalid_argument(std::string("PN_subdivision_3: an attribute of ") + kind + " has " +
                              n(array.values.size()) + " values, but the mesh has " + n(number) +
                              " of them with " + n(array.dimension) + " each");
}

// An array of edges, or of labels of vertices.
class Copied_array : public Copied_values
{
public:
  Copied_array(Attribute_array& array, std::size_t number, const char* kind)
    : array_(array)
    , old_(array.values)
  {
    check_array(array, number, kind);
  }

  // the values of a part
  Copied_array(const Copied_array& whole, Of_part)
    : array_(own_)
    , old_(whole.old_)
  {
    own_.dimension = whole.array_.dimension;
    own_.rule_of_vertices = whole.array_.rule_of_vertices;
  }

  void put(const std::vector<Index>& sources) override
  {
    const std::size_t d = array_.dimension;
    result_.assign(sources.size() * d, 0);
    for (std::size_t i = 0; i < sources.size(); ++i)
      if (sources[i] != null)
        for (std::size_t c = 0; c < d; ++c) result_[i * d + c] = old_[sources[i] * d + c];
  }
  void commit() noexcept override { array_.values.swap(result_); }
  std::unique_ptr<Copied_values> part() const override
  {
    return std::make_unique<Copied_array>(*this, Of_part());
  }
  std::any kept_of_part() override { return std::any(std::move(own_)); }

private:
  Attribute_array own_; // the values of a part
  Attribute_array& array_;
  const std::vector<double>& old_;
  std::vector<double> result_;
};

// An array of vertices or corners, computed in FT.
template <class FT>
class Array_values : public Row_values<FT>
{
public:
  using typename Row_values<FT>::Index;
  using typename Row_values<FT>::Entry;
  using Row_values<FT>::evaluate;
  using Row_values<FT>::null;

  Array_values(Attribute_array& array, std::size_t number, const char* kind)
    : array_(array)
    , dimension_(array.dimension)
  {
    check_array(array, number, kind);
  }
  // the values of a part
  Array_values(const Array_values& whole, const std::vector<Index>& sources)
    : array_(own_)
    , dimension_(whole.dimension_)
  {
    own_.dimension = dimension_;
    own_.rule = whole.array_.rule;
    own_.rule_of_vertices = whole.array_.rule_of_vertices;
    take(whole.old_, sources);
  }

  bool are_equal(Index a, Index b) const override
  {
    for (std::size_t c = 0; c < dimension_; ++c)
      if (!(array_.values[a * dimension_ + c] == array_.values[b * dimension_ + c])) return false;
    return true;
  }
  void begin(const std::vector<Index>& sources) override { take(array_.values, sources); }

  void begin_round(std::size_t number_of_values) override
  {
    new_.resize(number_of_values * dimension_, boost::container::default_init);
  }
  void evaluate(Index value, const Entry* begin, const Entry* end) override
  {
    component_average<FT>(
      begin, end, dimension_,
      [&](std::size_t v, std::size_t c) -> const FT& { return old_[v * dimension_ + c]; },
      [&](std::size_t c, const FT& x) { new_[value * dimension_ + c] = x; });
  }
  void copy(Index from, Index to) override
  {
    for (std::size_t c = 0; c < dimension_; ++c)
      new_[to * dimension_ + c] = new_[from * dimension_ + c];
  }
  void end_round() override
  {
    old_ = std::move(new_);
    new_ = Values();
  }

  void put_all(Index number) override { put(first_indices(number)); }
  void put(const std::vector<Index>& sources) override
  {
    result_.assign(sources.size() * dimension_, 0);
    for (std::size_t i = 0; i < sources.size(); ++i)
      for (std::size_t c = 0; sources[i] != null && c < dimension_; ++c)
        result_[i * dimension_ + c] = double(CGAL::to_double(old_[sources[i] * dimension_ + c]));
    if (array_.rule_of_vertices == Attribute_rule::direction) make_units(dimension_, result_);
  }
  void commit() noexcept override { array_.values.swap(result_); }

  std::unique_ptr<Row_values<FT>> part(const std::vector<Index>& sources) const override
  {
    return std::make_unique<Array_values>(*this, sources);
  }
  std::any kept_of_part() override { return std::any(std::move(own_)); }

private:
  using Values = boost::container::vector<FT>;

  template <class Numbers>
  void take(const Numbers& from, const std::vector<Index>& sources)
  {
    old_.resize(sources.size() * dimension_);
    for (std::size_t i = 0; i < sources.size(); ++i)
      for (std::size_t c = 0; sources[i] != null && c < dimension_; ++c)
        old_[i * dimension_ + c] = FT(from[sources[i] * dimension_ + c]);
  }

  Attribute_array own_; // the values of a part
  Attribute_array& array_;
  const std::size_t dimension_;
  Values old_, new_;
  std::vector<double> result_;
};

// The parents of the faces of a table.
class Face_parent_array : public Origin_values
{
public:
  explicit Face_parent_array(std::vector<std::uint32_t>& parents)
    : parents_(parents)
  {}
  // the values of a part
  Face_parent_array()
    : parents_(own_)
  {}

  void begin(std::size_t number_of_elements) override { result_.resize(number_of_elements); }
  void set(Index element, const Control_element&, Index face) override { result_[element] = face; }
  void commit() noexcept override { parents_.swap(result_); }
  std::unique_ptr<Origin_values> part() const override
  {
    return std::make_unique<Face_parent_array>();
  }
  std::any kept_of_part() override { return std::any(std::move(own_)); }

private:
  std::vector<std::uint32_t> own_; // the values of a part
  std::vector<std::uint32_t>& parents_;
  std::vector<std::uint32_t> result_;
};

// A map that gets where elements come from: a Control_element, or the number of the first control face. What it
// had is put back if it can be read.
template <class Access, class Map, class Keys>
class Origin_map : public Origin_values
{
public:
  Origin_map(const Access& access, Map map, std::size_t number)
    : map_(access, map, number)
  {}
  // the values of a part
  Origin_map(const Origin_map& whole, Of_part)
    : map_(whole.map_.access(), Map())
  {}

  void begin(std::size_t number) override { begin_map(map_, number); }
  void set(Index element, const Control_element& origin, [[maybe_unused]] Index face) override
  {
    if constexpr (std::is_same_v<Value, Control_element>)
      map_.set(element, origin);
    else
      map_.set(element, static_cast<Value>(face));
  }
  void commit() noexcept override { map_.commit(); }
  std::unique_ptr<Origin_values> part() const override
  {
    return part_of_map<Access, Origin_values>(*this, Of_part());
  }
  std::any kept_of_part() override { return std::any(map_.map()); }

private:
  using Value = std::decay_t<typename boost::property_traits<Map>::value_type>;

  Undoable_map<Access, Map, Keys> map_;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_ARRAY_VALUES_H

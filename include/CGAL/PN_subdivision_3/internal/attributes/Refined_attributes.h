// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_REFINED_ATTRIBUTES_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_REFINED_ATTRIBUTES_H

#include <CGAL/PN_subdivision_3/attributes/Attribute_traits.h>
#include <CGAL/PN_subdivision_3/internal/attributes/Attribute_rounds.h>
#include <CGAL/PN_subdivision_3/internal/attributes/Call_attribute_rounds.h>
#include <CGAL/PN_subdivision_3/internal/attributes/Charts.h>
#include <CGAL/PN_subdivision_3/internal/attributes/Map_values.h>
#include <CGAL/PN_subdivision_3/internal/attributes/read_attributes.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Level_refiner.h>
#include <CGAL/PN_subdivision_3/internal/rounds/Average_of_scheme.h>
#include <CGAL/PN_subdivision_3/internal/rows/Level_origins.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>

#include <boost/container/vector.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <any>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <stdexcept>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// The attributes of a refined mesh that nobody holds: read from the control mesh, refined once, and put into the maps
// of meshes that are made later.
class Refined_attributes
{
  using Index = Level_connectivity::Index;

public:
  Refined_attributes() = default;

  std::size_t memory() const { return memory_; }

  // reads and refines the attributes of a control mesh whose creases are known
  template <class FT, class Scheme, class Access, class Level_creases, class Attributes>
  void refine(const Scheme& scheme, const Access& access, const Level_connectivity& level,
              const Level_creases& creases, const Control_sharpness& sharpness, unsigned rounds,
              const Level_size& refined_size, const Attributes& attributes,
              const For_chunks& for_chunks)
  {
    auto kept = read(access, level, refined_size, attributes);
    if (rounds > 0)
      refine_kept<FT>(linear(scheme), access, level, creases, sharpness, rounds, kept, for_chunks);
    if constexpr (std::is_same_v<Attributes, Attribute_table>) {
      for (const auto* arrays : {&kept.vertices, &kept.corners, &kept.edges})
        for (const Attribute_array& array : *arrays)
          memory_ += array.values.size() * sizeof(double);
      lists_.emplace_back(std::move(kept));
    }
  }

  // Begins to refine the attributes of a control mesh for parts of the mesh. The returned function takes the attributes of a
  // part whose values have been put, and keeps the values of the mesh.
  template <class FT, class Host, class Access, class Level_creases, class Attributes>
  static auto for_pieces(const Access& access, const Level_connectivity& level,
                         const Level_creases& creases, const Control_sharpness& sharpness,
                         const Attributes& attributes, const For_chunks& for_chunks)
  {
    Refined_attributes lists; // of the control mesh
    auto kept = std::make_shared<decltype(lists.read(access, level, level.size(), attributes))>(
      lists.read(access, level, level.size(), attributes));
    static constexpr Numbers_as_elements numbers{};
    auto rounds = std::make_unique<Attribute_rounds<FT>>(
      read_attributes<FT>(numbers, level, *kept), kept_elements_v<Host>, Level_origins::Kinds(),
      level, vertices_of_extra_slots(creases, level.number_of_vertices()), sharpness, access,
      for_chunks);
    const std::function<Refined_attributes(Control_attributes<FT>&)> of_part =
      [kept](Control_attributes<FT>& put) {
        Refined_attributes part;
        part.take(put, *kept);
        return part;
      };
    return std::make_pair(std::move(rounds), of_part);
  }

  bool empty() const { return lists_.empty(); }
  // null if the attributes are no table
  const Attribute_table* table() const
  {
    return lists_.size() == 1 ? std::any_cast<Attribute_table>(&lists_[0]) : nullptr;
  }

  // puts all values into maps of the elements of a mesh with the refined level
  template <class Access, class... Items>
  void put_all(const Access& access, const Level_connectivity& refined,
               const Attributes<Items...>& attributes) const
  {
    require(lists_.size() == sizeof...(Items));
    std::size_t i = 0;
    std::apply([&](const Items&... items) { (put_item(access, refined, items, lists_[i++]), ...); },
               attributes.items);
  }
  template <class Access>
  void put_all(const Access&, const Level_connectivity&, Attribute_table& table) const
  {
    require(this->table() != nullptr);
    Attribute_table copy = *this->table();
    std::swap(table, copy);
  }
  template <class Access>
  void put_all(const Access&, const Level_connectivity&, const Not_given&) const
  {}

private:
  // the points of the linear twin are all 0: only its rows count
  template <class FT, class Scheme, class Access, class Level_creases, class Attributes>
  static void refine_kept(const Scheme& scheme, const Access& access, Level_connectivity level,
                          Level_creases creases, const Control_sharpness& sharpness,
                          unsigned rounds, Attributes& attributes, const For_chunks& for_chunks)
  {
    using Average = Average_of_scheme<Scheme, FT>;
    using Refiner = Level_refiner<Scheme, Average, Level_creases>;
    static constexpr Numbers_as_elements numbers{};
    Optional_attribute_rounds<FT> attribute_rounds(std::make_unique<Attribute_rounds<FT>>(
      read_attributes<FT>(numbers, level, attributes), kept_elements_v<typename Scheme::Host>,
      Level_origins::Kinds(), level, vertices_of_extra_slots(creases, level.number_of_vertices()),
      sharpness, access, for_chunks));
    typename Refiner::Values points(creases.number_of_slots, zero_vector<FT, 3>());
    Refiner refiner(scheme, std::move(level), std::move(creases), std::move(points), for_chunks);
    for (unsigned k = 1; k < rounds; ++k) attribute_rounds.refine(scheme, refiner);
    attribute_rounds.before_cut(refiner);
    auto last = refiner.next_round();
    attribute_rounds.begin_round(scheme, refiner, last, Kind_of_round::last_put_later);
    refiner.refined_values(last, attribute_rounds.rows());
    attribute_rounds.put(refiner, last.round(), for_chunks);
    attribute_rounds.commit();
  }

  template <class FT>
  void take(Control_attributes<FT>& put, const Attribute_table& control)
  {
    Attribute_table table;
    const auto take = [](auto& arrays, const auto& list) {
      for (const auto& values : list)
        arrays.push_back(std::any_cast<Attribute_array>(values_of(values).kept_of_part()));
    };
    take(table.vertices, put.vertices);
    take(table.corners, put.corners);
    take(table.edges, put.edges);
    table.has_face_parents = control.has_face_parents;
    for (const auto& values : put.face_origins)
      table.face_parents = std::any_cast<std::vector<std::uint32_t>>(values->kept_of_part());
    lists_.emplace_back(std::move(table));
  }
  template <class FT, class... Items>
  void take(Control_attributes<FT>& put, const Attributes<Items...>&)
  {
    // attributes of a kind are in the order in which the call names them
    (lists_.push_back(take_first(Items::list(put))), ...);
  }
  template <class List>
  static std::any take_first(List& list)
  {
    std::any first = values_of(list.front()).kept_of_part();
    list.erase(list.begin());
    return first;
  }
  template <class FT>
  static Row_values<FT>& values_of(const Corner_attribute_values<FT>& corner)
  {
    return *corner.values;
  }
  template <class Values>
  static Values& values_of(const std::unique_ptr<Values>& values)
  {
    return *values;
  }

  template <class Access>
  Attribute_table read(const Access&, const Level_connectivity&, const Level_size&,
                       const Attribute_table& table)
  {
    return table;
  }
  template <class Access, class... Items>
  auto read(const Access& access, const Level_connectivity& level, const Level_size& refined_size,
            const Attributes<Items...>& attributes)
  {
    return std::apply(
      [&](const Items&... items) {
        // items are read from left to right
        return attributes_of(std::tuple{read_item(access, level, refined_size, items)...});
      },
      attributes.items);
  }
  template <class... Items>
  static Attributes<Items...> attributes_of(std::tuple<Items...> items)
  {
    return {std::move(items)};
  }

  template <class Map>
  using Value_of = std::decay_t<typename boost::property_traits<Map>::value_type>;

  template <class Access, template <class> class Item, class Map>
  auto read_item(const Access& access, const Level_connectivity& level,
                 const Level_size& refined_size, const Item<Map>& item)
  {
    using Keys = typename Item<Map>::Keys;
    using Refined_map = Map_of_numbers<Value_of<Map>, Keys>;
    const std::size_t n = Keys::number(level.size());
    const Refined_map map{std::make_shared<typename Refined_map::List>(
      (std::max)(n, Keys::number(refined_size)), Value_of<Map>())};
    if constexpr (is_readable_v<Map>)
      for (Index i = 0; i < n; ++i)
        if (has_value<Keys>(level, i)) put(map, i, get(item.map, Keys::at(access, i)));
    lists_.emplace_back(map);
    memory_ += map.list->size() * sizeof(Value_of<Map>);
    if constexpr (std::is_same_v<Item<Map>, Corner_attribute<Map>>)
      return Corner_attribute<Refined_map>{map, item.rule};
    else
      return Item<Refined_map>{{map}};
  }

  template <class Access, class Item>
  static void put_item(const Access& access, const Level_connectivity& refined, const Item& item,
                       const std::any& kept)
  {
    using Keys = typename Item::Keys;
    using Refined_map = Map_of_numbers<Value_of<decltype(item.map)>, Keys>;
    const Refined_map* map = std::any_cast<Refined_map>(&kept);
    require(map != nullptr);
    for (Index i = 0; i < Keys::number(refined.size()); ++i)
      if (has_value<Keys>(refined, i)) put(item.map, Keys::at(access, i), get(*map, i));
  }

  template <class Keys>
  static bool has_value([[maybe_unused]] const Level_connectivity& level, [[maybe_unused]] Index i)
  {
    if constexpr (std::is_same_v<Keys, Halfedge_of_mesh>)
      return !level.is_border(i);
    else
      return true;
  }

  static void require(bool is_same)
  {
    if (!is_same)
      throw std::invalid_argument(
        "PN_subdivision_3: the attributes to be put are not those that were read: name the same "
        "kinds, with the same types of values, in the same order");
  }

  std::vector<std::any> lists_; // a Map_of_numbers for each attribute, or a table
  std::size_t memory_ = 0;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_REFINED_ATTRIBUTES_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_KEPT_ATTRIBUTES_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_KEPT_ATTRIBUTES_H

#include <CGAL/PN_subdivision_3/attributes/Attribute_traits.h>
#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/attributes/Attribute_rounds.h>
#include <CGAL/PN_subdivision_3/internal/attributes/Charts.h>
#include <CGAL/PN_subdivision_3/internal/attributes/Map_values.h>
#include <CGAL/PN_subdivision_3/internal/attributes/read_attributes.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/hosts/Level_origins.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Average_of_scheme.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Level_refiner.h>
#include <CGAL/PN_subdivision_3/internal/refinement/for_chunks.h>
#include <CGAL/PN_subdivision_3/schemes/scheme_adaptors.h>

#include <boost/container/vector.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <any>
#include <cstddef>
#include <memory>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// What a Carrier carries through the rounds of a call, and the steps of the call that serve it.
template <class FT, class Host, class Carry, bool = Carry::is_empty>
class Carried_through
{
public:
  using Index = Level_connectivity::Index;
  using Rounds = Attribute_rounds<FT, Host>;

  // `extra_slots` are the vertices of the slots behind those of the vertices, see Creases
  template <class Access>
  Carried_through(const Carry& carry, const Access& access, const Level_connectivity& level,
                  const std::vector<Index>& extra_slots, const Control_sharpness& sharpness,
                  const For_chunks& for_chunks)
    : carry_(carry)
    , for_chunks_(for_chunks)
    , rounds_(carry.template read<FT>(access, level), Carry::visited, level, extra_slots, sharpness,
              access, for_chunks)
  {}

  // a round with creases cuts its level open
  template <class Refiner>
  void before_cut(const Refiner& refiner)
  {
    if constexpr (are_creases_v<Creases_of<Refiner>>) whole_.emplace(refiner.level());
  }
  template <class Scheme, class Refiner, class One_round>
  void begin_round(const Scheme& scheme, const Refiner& refiner, const One_round& round,
                   Kind_of_round kind)
  {
    if constexpr (are_creases_v<Creases_of<Refiner>>)
      rounds_.begin_creased_round(scheme, round, *whole_, refiner.creases(), kind);
    else
      rounds_.begin_round(scheme, round.round(), refiner.level(), kind);
  }
  const typename Rounds::Rows_sink* rows() const { return rounds_.rows(); }

  // a round before the last one
  template <class Scheme, class Refiner>
  void refine(const Scheme& scheme, Refiner& refiner)
  {
    before_cut(refiner);
    auto round = refiner.next_round();
    begin_round(scheme, refiner, round, Kind_of_round::inner);
    refiner.refine(round, rows(), rounds_.child());
    rounds_.end_round();
  }

  // ends the last round, of which the refiner has the level, and puts what it gives
  template <class Refiner, class Round>
  void put(const Refiner& refiner, const Round& last)
  {
    std::optional<Level_connectivity> refined;
    if (rounds_.needs_refined_level()) {
      refined = child_level(last, for_chunks_);
      if (rounds_.child() != nullptr) (*rounds_.child())(*refined);
    }
    rounds_.end_round();
    rounds_.put(last.refined_size(), refined ? &*refined : nullptr,
                rounds_.rules(last, refiner.level()));
  }
  void keep() noexcept { rounds_.keep(); }

  template <class Access, class Refiner, class One_round>
  void visit(const Access& access, const Refiner& refiner, const One_round& last) const
  {
    carry_.visit(access, last.refined_size(), rounds_.rules(last, refiner.level()));
  }

private:
  template <class Refiner>
  using Creases_of = std::decay_t<decltype(std::declval<const Refiner&>().creases())>;

  const Carry& carry_;
  const For_chunks for_chunks_;
  Rounds rounds_;
  std::optional<Level_connectivity> whole_; // the level of a round with creases, before it is cut
};

// With nothing to carry there is nothing to do.
template <class FT, class Host, class Carry>
class Carried_through<FT, Host, Carry, true>
{
public:
  template <class... Arguments>
  explicit Carried_through(const Carry&, const Arguments&...)
  {}
  template <class Refiner>
  void before_cut(const Refiner&) const
  {}
  template <class... Arguments>
  void begin_round(const Arguments&...) const
  {}
  static constexpr std::nullptr_t rows() { return nullptr; }
  template <class Scheme, class Refiner>
  void refine(const Scheme&, Refiner& refiner) const
  {
    refiner.refine();
  }
  template <class... Arguments>
  void put(const Arguments&...) const
  {}
  void keep() const noexcept {}
  template <class... Arguments>
  void visit(const Arguments&...) const
  {}
};

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
  std::shared_ptr<List> list;
};

// The attributes of a refined mesh that nobody holds: read from the control mesh, refined once, and put into the maps
// of meshes that are made later.
class Kept_attributes
{
  using Index = Level_connectivity::Index;

public:
  std::size_t memory() const { return memory_; }

  // those of a control mesh, of which the creases are known
  template <class FT, class Scheme, class Access, class Level_creases, class Attributes>
  void refine(const Scheme& scheme, const Access& access, const Level_connectivity& level,
              const Level_creases& creases, const Control_sharpness& sharpness, unsigned rounds,
              const Level_size& refined_size, const Attributes& attributes,
              const For_chunks& for_chunks)
  {
    auto kept = read(access, level, refined_size, attributes);
    if (rounds > 0)
      refine_kept<FT>(linear(scheme), access, level, creases, sharpness, rounds,
                      Carry<decltype(kept)>{kept}, for_chunks);
    if constexpr (std::is_same_v<Attributes, Attribute_table>) {
      for (const auto* arrays : {&kept.vertices, &kept.corners, &kept.edges})
        for (const Attribute_array& array : *arrays)
          memory_ += array.values.size() * sizeof(double);
      lists_.emplace_back(std::move(kept));
    }
  }

  // into maps of the elements of a mesh with the refined level
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
    const auto* kept = lists_.size() == 1 ? std::any_cast<Attribute_table>(&lists_[0]) : nullptr;
    require(kept != nullptr);
    Attribute_table copy = *kept;
    std::swap(table, copy);
  }
  template <class Access>
  void put_all(const Access&, const Level_connectivity&, const No_attributes&) const
  {}

private:
  // the points of the linear twin are all 0: only its rows count
  template <class FT, class Scheme, class Access, class Level_creases, class Carry>
  static void refine_kept(const Scheme& scheme, const Access& access, Level_connectivity level,
                          Level_creases creases, const Control_sharpness& sharpness,
                          unsigned rounds, const Carry& carry, const For_chunks& for_chunks)
  {
    using Average = Average_of_scheme<Scheme, FT>;
    using Refiner = Level_refiner<Scheme, Average, Level_creases>;
    Carried_through<FT, typename Scheme::Host, Carry> carried(
      carry, access, level, vertices_of_extra_slots(creases, level.number_of_vertices()), sharpness,
      for_chunks);
    typename Refiner::Values points(creases.number_of_slots, zero_vector<FT, 3>());
    Refiner refiner(scheme, std::move(level), std::move(creases), std::move(points), for_chunks);
    for (unsigned k = 1; k < rounds; ++k) carried.refine(scheme, refiner);
    carried.before_cut(refiner);
    auto last = refiner.next_round();
    carried.begin_round(scheme, refiner, last, Kind_of_round::last_put_later);
    refiner.refined_values(last, carried.rows());
    carried.put(refiner, last.round());
    carried.keep();
  }

  template <class Attributes>
  struct Carry
  {
    static constexpr bool is_empty = false;
    static constexpr Level_origins::Kinds visited{};

    template <class FT, class Access>
    Carried_attributes<FT> read(const Access&, const Level_connectivity& level) const
    {
      static constexpr Numbers_as_elements numbers{};
      return read_attributes<FT>(numbers, level, attributes);
    }
    Attributes& attributes;
  };

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
        // from left to right
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
    using Kept = Map_of_numbers<Value_of<Map>, Keys>;
    const std::size_t n = Keys::number(level.size());
    const Kept map{std::make_shared<typename Kept::List>((std::max)(n, Keys::number(refined_size)),
                                                         Value_of<Map>())};
    if constexpr (is_readable_v<Map>)
      for (Index i = 0; i < n; ++i)
        if (has_value<Keys>(level, i)) put(map, i, get(item.map, Keys::at(access, i)));
    lists_.emplace_back(map);
    memory_ += map.list->size() * sizeof(Value_of<Map>);
    if constexpr (std::is_same_v<Item<Map>, Corner_attribute<Map>>)
      return Corner_attribute<Kept>{map, item.rule};
    else
      return Item<Kept>{map};
  }

  template <class Access, class Item>
  static void put_item(const Access& access, const Level_connectivity& refined, const Item& item,
                       const std::any& kept)
  {
    using Keys = typename Item::Keys;
    using Kept = Map_of_numbers<Value_of<decltype(item.map)>, Keys>;
    const Kept* map = std::any_cast<Kept>(&kept);
    require(map != nullptr);
    for (Index i = 0; i < Keys::number(refined.size()); ++i)
      if (has_value<Keys>(refined, i)) put(item.map, Keys::at(access, i), get(*map, i));
  }

  template <class Keys>
  static bool has_value([[maybe_unused]] const Level_connectivity& level, [[maybe_unused]] Index i)
  {
    if constexpr (std::is_same_v<Keys, Corner_keys>)
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

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_KEPT_ATTRIBUTES_H

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
#include <CGAL/PN_subdivision_3/internal/attributes/Charts.h>
#include <CGAL/PN_subdivision_3/internal/attributes/Columns.h>
#include <CGAL/PN_subdivision_3/internal/attributes/read_attributes.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/creases/Cut_level.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Level_refiner.h>
#include <CGAL/PN_subdivision_3/internal/rounds/Round.h>
#include <CGAL/PN_subdivision_3/internal/rows/Level_origins.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#ifdef CGAL_PN_SUBDIVISION_3_DOUBLE
#  include <CGAL/PN_subdivision_3/internal/creases/Crease_round.h>
#  include <CGAL/PN_subdivision_3/internal/meshes/compiled_levels.h>
#endif

#include <any>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// Attribute_rounds, if there are any, and the steps of a round of a Level_refiner that serve them.
template <class FT, bool may_be_any = true>
class Optional_attribute_rounds
{
public:
  using Rounds = Attribute_rounds<FT>;

  Optional_attribute_rounds() = default;
  explicit Optional_attribute_rounds(std::unique_ptr<Rounds> rounds)
    : rounds_(std::move(rounds))
  {}
  Rounds* operator->() const { return rounds_.get(); }
  Rounds& operator*() const { return *rounds_; }
  explicit operator bool() const { return rounds_ != nullptr; }

  // a round with creases cuts its level open; then attributes have a copy of the whole one
  template <class Refiner>
  void before_cut(const Refiner& refiner)
  {
    if constexpr (are_creases_v<std::decay_t<decltype(refiner.creases())>>)
      if (rounds_) {
        whole_.emplace(refiner.level());
        count_valences(*whole_, refiner.creases());
      }
  }
  template <class Scheme, class Refiner, class Level_round>
  void begin_round(const Scheme& scheme, const Refiner& refiner, const Level_round& round,
                   Kind_of_round kind)
  {
    if (rounds_)
      rounds_->begin_round(scheme, round, whole_ ? *whole_ : refiner.level(), refiner.creases(),
                           kind);
  }
  const typename Rounds::Rows_sink* rows() const { return rounds_ ? rounds_->rows() : nullptr; }

  // a round before the last one, which has been made
  template <class Scheme, class Refiner, class Level_round>
  void refine(const Scheme& scheme, Refiner& refiner, Level_round& round)
  {
    begin_round(scheme, refiner, round, Kind_of_round::inner);
    refiner.refine(round, rows(), rounds_ ? rounds_->child() : nullptr);
    if (rounds_) rounds_->end_round();
  }
  template <class Scheme, class Refiner>
  void refine(const Scheme& scheme, Refiner& refiner)
  {
    before_cut(refiner);
    auto round = refiner.next_round();
    refine(scheme, refiner, round);
  }

  // ends the last round, of which the refiner has the level, and puts what it gives
  template <class Refiner, class Round>
  void put(const Refiner& refiner, const Round& last, const For_chunks& for_chunks)
  {
    if (!rounds_) return;
    std::optional<Level_connectivity> refined;
    if (rounds_->needs_refined_level()) {
      refined = child_level(last, for_chunks);
      if (rounds_->child() != nullptr) (*rounds_->child())(*refined);
    }
    rounds_->end_round();
    rounds_->put(last.refined_size(), refined ? &*refined : nullptr,
                 rounds_->rules(last, refiner.level()));
  }
  void commit() noexcept
  {
    if (rounds_) rounds_->commit();
  }

  // The attributes of a part of the level, given its slots in the level.
  Optional_attribute_rounds part(const Level_part& part,
                                 const std::vector<Level_part::Index>& slot_ids,
                                 const typename Rounds::Chart_slots& chart_slots) const
  {
    return Optional_attribute_rounds(
      std::make_unique<Rounds>(*rounds_, part, slot_ids, chart_slots));
  }

private:
  std::unique_ptr<Rounds> rounds_;
  std::optional<Level_connectivity> whole_; // the level of a round with creases, before it is cut
};

// Without attributes there is nothing to do.
template <class FT>
class Optional_attribute_rounds<FT, false>
{
public:
  explicit constexpr operator bool() const { return false; }
  template <class... Arguments>
  void before_cut(const Arguments&...) const
  {}
  template <class... Arguments>
  void begin_round(const Arguments&...) const
  {}
  template <class... Arguments>
  void put(const Arguments&...) const
  {}
  void commit() const noexcept {}
  static constexpr std::nullptr_t rows() { return nullptr; }
  template <class Scheme, class Refiner, class... Level_round>
  void refine(const Scheme&, Refiner& refiner, Level_round&... round) const
  {
    refiner.refine(round...);
  }
};

// the rounds of attributes that have been read
template <class FT, class Host, class Level_creases>
auto make_attribute_rounds(Control_attributes<FT>&& attributes, Level_origins::Kinds visited,
                           const Level_connectivity& level, const Level_creases& creases,
                           const Control_sharpness& sharpness, const Element_names& names,
                           const For_chunks& for_chunks)
{
  return Optional_attribute_rounds<FT>(std::make_unique<Attribute_rounds<FT>>(
    std::move(attributes), kept_elements_v<Host>, visited, level,
    vertices_of_extra_slots(creases, level.number_of_vertices()), sharpness, names, for_chunks));
}

// the attributes of a call in its rounds, with the values of the call's mesh
template <class FT, class Host, class Attributes, class Access, class Level_creases, class Values>
auto attribute_rounds_of_call([[maybe_unused]] const Attributes& attributes,
                              [[maybe_unused]] const Access& access,
                              [[maybe_unused]] const Level_connectivity& level,
                              [[maybe_unused]] const Level_creases& creases,
                              [[maybe_unused]] const Values& of_mesh,
                              [[maybe_unused]] const For_chunks& for_chunks)
{
  if constexpr (!Attributes::is_empty)
    if (attributes.is_any())
      return make_attribute_rounds<FT, Host>(attributes.template read<FT>(access, level),
                                             Attributes::visited, level, creases,
                                             of_mesh.sharpness(level), access, for_chunks);
  return Optional_attribute_rounds<FT, !Attributes::is_empty>();
}

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
              const Attributes& attributes, const For_chunks& for_chunks)
  {
    auto read = read_attributes<FT>(Into_lists<Access>{access}, level, attributes);
    if (rounds == 0) return take(read, attributes);
    auto all = make_attribute_rounds<FT, typename Scheme::Host>(
      std::move(read), Level_origins::Kinds(), level, creases, sharpness, access, for_chunks);
    refine_all<FT>(linear(scheme), level, creases, rounds, all, for_chunks);
    take(all->attributes(), attributes);
  }

  // Begins to refine the attributes of a control mesh for parts of the mesh. The returned function takes the attributes of a
  // part whose values have been put.
  template <class FT, class Host, class Access, class Level_creases, class Attributes>
  static auto for_pieces(const Access& access, const Level_connectivity& level,
                         const Level_creases& creases, const Control_sharpness& sharpness,
                         const Attributes& attributes, const For_chunks& for_chunks)
  {
    auto rounds = make_attribute_rounds<FT, Host>(
      read_attributes<FT>(Into_lists<Access>{access}, level, attributes), Level_origins::Kinds(),
      level, creases, sharpness, access, for_chunks);
    const std::function<Refined_attributes(Control_attributes<FT>&)> of_part =
      [kinds = without_values(attributes)](Control_attributes<FT>& put) {
        Refined_attributes part;
        part.take(put, kinds);
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
  template <class FT, class Scheme, class Level_creases>
  static void refine_all(const Scheme& scheme, Level_connectivity level, Level_creases creases,
                         unsigned rounds, Optional_attribute_rounds<FT>& attribute_rounds,
                         const For_chunks& for_chunks)
  {
    using Refiner = Level_refiner<Scheme, Average_of_scheme<Scheme, FT>, Level_creases>;
    typename Refiner::Values points(creases.number_of_slots, zero_vector<FT, 3>());
    Refiner refiner(scheme, std::move(level), std::move(creases), std::move(points), for_chunks);
    for (unsigned k = 1; k < rounds; ++k) attribute_rounds.refine(scheme, refiner);
    attribute_rounds.before_cut(refiner);
    auto last = refiner.next_round();
    attribute_rounds.begin_round(scheme, refiner, last, Kind_of_round::last_put_later);
    refiner.refined_values(last, attribute_rounds.rows());
    attribute_rounds.put(refiner, last.round(), for_chunks);
  }

  template <class T, class Values>
  T taken(Values& values)
  {
    T list = std::any_cast<T>(values.take_list());
    memory_ += list.size() * sizeof(typename T::value_type);
    return list;
  }
  template <class FT>
  void take(Control_attributes<FT>& put, const Attribute_table& shape)
  {
    Attribute_table table = without_values(shape);
    const auto take_arrays = [this](auto& arrays, const auto& list) {
      for (std::size_t i = 0; i < arrays.size(); ++i)
        arrays[i].values = this->template taken<std::vector<double>>(*list[i]);
    };
    take_arrays(table.vertices, put.vertices);
    take_arrays(table.corners, put.corners);
    take_arrays(table.edges, put.edges);
    for (const auto& parents : put.face_origins)
      table.face_parents = taken<std::vector<std::uint32_t>>(*parents);
    lists_.emplace_back(std::move(table));
  }
  template <class FT, class... Items>
  void take(Control_attributes<FT>& put, const Attributes<Items...>&)
  {
    // attributes of a kind are in the order in which the call names them
    (take_first<Items>(Items::list(put)), ...);
  }
  template <class Item, class Attributes_of_kind>
  void take_first(Attributes_of_kind& list)
  {
    using Values = decltype(List_of<Item>::values);
    lists_.emplace_back(List_of<Item>{taken<Values>(*list.front())});
    list.erase(list.begin());
  }

  static Attribute_table without_values(const Attribute_table& table)
  {
    Attribute_table result;
    for (const auto arrays :
         {&Attribute_table::vertices, &Attribute_table::corners, &Attribute_table::edges})
      for (const Attribute_array& array : table.*arrays)
        (result.*arrays).push_back({array.dimension, {}, array.rule, array.rule_of_vertices});
    result.has_face_parents = table.has_face_parents;
    return result;
  }
  template <class... Items>
  static Attributes<Items...> without_values(const Attributes<Items...>& attributes)
  {
    return attributes;
  }

  // attributes that are put have elements of the same kind, and values of the same type
  template <class T, class Keys>
  struct List
  {
    std::vector<T> values;
  };
  template <class Item>
  using List_of = List<Value_of_map<decltype(Item::map)>, typename Item::Keys>;

  template <class Access, class Item>
  static void put_item(const Access& access, const Level_connectivity& refined, const Item& item,
                       const std::any& kept)
  {
    using Keys = typename Item::Keys;
    const List_of<Item>* list = std::any_cast<List_of<Item>>(&kept);
    require(list != nullptr);
    for_each_element<Keys>(refined,
                           [&](Index i) { put(item.map, Keys::at(access, i), list->values[i]); });
  }

  static void require(bool is_same)
  {
    if (!is_same)
      throw std::invalid_argument(
        "PN_subdivision_3: the attributes to be put are not those that were read: name the same "
        "kinds, with the same types of values, in the same order");
  }

  std::vector<std::any> lists_; // of the values of each attribute, or a table
  std::size_t memory_ = 0;
};

// The rounds of attributes of double, see meshes/compiled_levels.h.
#ifdef CGAL_PN_SUBDIVISION_3_DOUBLE
#  define CGAL_PN_SUBDIVISION_3_ATTRIBUTES_IN_ROUNDS(EXTERN, SCHEME, CREASES)                      \
    EXTERN template void Attribute_rounds<double>::begin_round(                                    \
      const compiled_once::SCHEME&,                                                                \
      const Crease_round<compiled_once::SCHEME, compiled_once::Average<compiled_once::SCHEME>,     \
                         CREASES>&,                                                                \
      const Level_connectivity&, const CREASES&, Kind_of_round);
#  define CGAL_PN_SUBDIVISION_3_ATTRIBUTES_ON_CREASES(EXTERN, SCHEME)                              \
    CGAL_PN_SUBDIVISION_3_ATTRIBUTES_IN_ROUNDS(EXTERN, SCHEME, No_creases)                         \
    CGAL_PN_SUBDIVISION_3_ATTRIBUTES_IN_ROUNDS(EXTERN, SCHEME, Creases<double>)
#  define CGAL_PN_SUBDIVISION_3_ATTRIBUTES_OF_ALL(EXTERN)                                          \
    EXTERN template class Rows<double, Number_values<double>>;                                     \
    EXTERN template class Rows<double, Label_values<double>>;                                      \
    EXTERN template class Attribute_rounds<double>;                                                \
    CGAL_PN_SUBDIVISION_3_ATTRIBUTES_ON_CREASES(EXTERN, Any_of_quads)                              \
    CGAL_PN_SUBDIVISION_3_ATTRIBUTES_ON_CREASES(EXTERN, Any_of_triangles)                          \
    CGAL_PN_SUBDIVISION_3_ATTRIBUTES_ON_CREASES(EXTERN, Linear_of_quads)                           \
    CGAL_PN_SUBDIVISION_3_ATTRIBUTES_ON_CREASES(EXTERN, Linear_of_triangles)                       \
    CGAL_PN_SUBDIVISION_3_ATTRIBUTES_IN_ROUNDS(EXTERN, Any_of_corners, No_creases)                 \
    CGAL_PN_SUBDIVISION_3_ATTRIBUTES_IN_ROUNDS(EXTERN, Any_of_sqrt3, No_creases)                   \
    CGAL_PN_SUBDIVISION_3_ATTRIBUTES_IN_ROUNDS(EXTERN, Linear_of_corners, No_creases)              \
    CGAL_PN_SUBDIVISION_3_ATTRIBUTES_IN_ROUNDS(EXTERN, Linear_of_sqrt3, No_creases)

CGAL_PN_SUBDIVISION_3_ATTRIBUTES_OF_ALL(extern)
#endif

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_REFINED_ATTRIBUTES_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_CALL_ATTRIBUTE_ROUNDS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_CALL_ATTRIBUTE_ROUNDS_H

#include <CGAL/PN_subdivision_3/internal/attributes/Attribute_rounds.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/creases/Cut_level.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Level_refiner.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#ifdef CGAL_PN_SUBDIVISION_3_DOUBLE
#  include <CGAL/PN_subdivision_3/internal/attributes/compiled_attributes.h>
#endif

#include <cstddef>
#include <memory>
#include <optional>
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

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_CALL_ATTRIBUTE_ROUNDS_H

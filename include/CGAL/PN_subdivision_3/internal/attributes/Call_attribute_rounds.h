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
template <class FT, class Host, bool may_be_any = true>
class Optional_attribute_rounds
{
public:
  using Rounds = Attribute_rounds<FT, Host>;

  Optional_attribute_rounds() = default;
  explicit Optional_attribute_rounds(std::unique_ptr<Rounds> rounds)
    : rounds_(std::move(rounds))
  {}
  Rounds* operator->() const { return rounds_.get(); }
  Rounds& operator*() const { return *rounds_; }
  explicit operator bool() const { return rounds_ != nullptr; }

  // a round with creases cuts its level open
  template <class Refiner>
  void before_cut(const Refiner& refiner)
  {
    if constexpr (are_creases_v<Creases_of<Refiner>>)
      if (rounds_) whole_.emplace(refiner.level());
  }
  template <class Scheme, class Refiner, class One_round>
  void begin_round(const Scheme& scheme, const Refiner& refiner, const One_round& round,
                   Kind_of_round kind)
  {
    if (!rounds_) return;
    if constexpr (are_creases_v<Creases_of<Refiner>>)
      rounds_->begin_creased_round(scheme, round, *whole_, refiner.creases(), kind);
    else
      rounds_->begin_round(scheme, round.round(), refiner.level(), kind);
  }
  const typename Rounds::Rows_sink* rows() const { return rounds_ ? rounds_->rows() : nullptr; }

  // a round before the last one, which has been made
  template <class Scheme, class Refiner, class One_round>
  void refine(const Scheme& scheme, Refiner& refiner, One_round& round)
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

  // The attributes of a part of the level, given its slots in the level.
  Optional_attribute_rounds part(const Level_part& part,
                                 const std::vector<Level_part::Index>& slot_ids,
                                 const typename Rounds::Chart_slots& chart_slots) const
  {
    return Optional_attribute_rounds(
      std::make_unique<Rounds>(*rounds_, part, slot_ids, chart_slots));
  }
  Optional_attribute_rounds part(const Level_part& part,
                                 const std::vector<Level_part::Index>& slot_ids,
                                 const Level_connectivity& level) const
  {
    return this->part(part, slot_ids, rounds_->slots_of_charts(level));
  }

private:
  template <class Refiner>
  using Creases_of = std::decay_t<decltype(std::declval<const Refiner&>().creases())>;

  std::unique_ptr<Rounds> rounds_;
  std::optional<Level_connectivity> whole_; // the level of a round with creases, before it is cut
};

// Without attributes there is nothing to do.
template <class FT, class Host>
class Optional_attribute_rounds<FT, Host, false>
{
public:
  explicit constexpr operator bool() const { return false; }
  template <class... Arguments>
  void before_cut(const Arguments&...) const
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
  template <class Scheme, class Refiner, class One_round>
  void refine(const Scheme&, Refiner& refiner, One_round& round) const
  {
    refiner.refine(round);
  }
};

// The attributes of a call in its rounds.
template <class FT, class Host, class Attributes, bool = Attributes::is_empty>
class Call_attribute_rounds : public Optional_attribute_rounds<FT, Host>
{
  using Base = Optional_attribute_rounds<FT, Host>;
  using typename Base::Rounds;

public:
  using Index = Level_connectivity::Index;

  // `extra_slots` has the vertices of the further slots, see Creases
  template <class Access>
  Call_attribute_rounds(const Attributes& attributes, const Access& access,
                        const Level_connectivity& level, const std::vector<Index>& extra_slots,
                        const Control_sharpness& sharpness, const For_chunks& for_chunks)
    : Base(std::make_unique<Rounds>(attributes.template read<FT>(access, level),
                                    Attributes::visited, level, extra_slots, sharpness, access,
                                    for_chunks))
    , attributes_(attributes)
    , for_chunks_(for_chunks)
  {}

  // ends the last round, of which the refiner has the level, and puts what it gives
  template <class Refiner, class Round>
  void put(const Refiner& refiner, const Round& last)
  {
    Rounds& rounds = **this;
    std::optional<Level_connectivity> refined;
    if (rounds.needs_refined_level()) {
      refined = child_level(last, for_chunks_);
      if (rounds.child() != nullptr) (*rounds.child())(*refined);
    }
    rounds.end_round();
    rounds.put(last.refined_size(), refined ? &*refined : nullptr,
               rounds.rules(last, refiner.level()));
  }
  void keep() noexcept { (*this)->keep(); }

  template <class Access, class Refiner, class One_round>
  void visit(const Access& access, const Refiner& refiner, const One_round& last) const
  {
    attributes_.visit(access, last.refined_size(), (*this)->rules(last, refiner.level()));
  }

private:
  const Attributes& attributes_;
  const For_chunks for_chunks_;
};

template <class FT, class Host, class Attributes>
class Call_attribute_rounds<FT, Host, Attributes, true>
  : public Optional_attribute_rounds<FT, Host, false>
{
public:
  template <class... Arguments>
  explicit Call_attribute_rounds(const Attributes&, const Arguments&...)
  {}
  template <class... Arguments>
  void put(const Arguments&...) const
  {}
  void keep() const noexcept {}
  template <class... Arguments>
  void visit(const Arguments&...) const
  {}
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_CALL_ATTRIBUTE_ROUNDS_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_PIECES_PIECE_REFINER_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_PIECES_PIECE_REFINER_H

#include <CGAL/PN_limit_surface_3/internal/pieces/Divided_level.h>
#include <CGAL/PN_limit_surface_3/internal/pieces/Piece_levels.h>
#include <CGAL/PN_subdivision_3/internal/attributes/Refined_attributes.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/creases/Smooth_rows.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Level_part.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Level_refiner.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Piece_candidates.h>
#include <CGAL/PN_subdivision_3/internal/rounds/Round.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// How far a level has to be refined as a whole before it is divided.
template <class Host>
unsigned dividing_round(Level_size size, unsigned rounds, std::size_t number_of_pieces)
{
  constexpr std::uint64_t faces_of_a_piece = 16; // so that pieces can be about equal
  unsigned k = 0;
  while (k < rounds && size.faces / number_of_pieces < faces_of_a_piece)
    size = Host::refined_size(size, ++k);
  return k;
}

// Refines a control level piece by piece. A piece owns faces of the level where it is divided; it is refined
// together with the rings of faces around these. The last rings go wrong in each round, since faces are
// missing there, and are cut off. The rules of creases, too, know only what is near: a part of a level has its part of
// the creases.
template <class Scheme, class Average, class Level_creases = No_creases,
          bool has_attributes = false>
class Piece_refiner : public Abstract_pieces<Average>
{
public:
  using Host = typename Scheme::Host;
  using Index = Level_connectivity::Index;
  using Refiner = Level_refiner<Scheme, Average, Level_creases>;
  using Level_round = typename Refiner::Level_round;
  using FT = typename Average::FT;
  using Value = typename Refiner::Value;
  using Values = typename Refiner::Values;

  using Output = typename Abstract_pieces<Average>::Output;
  using Attribute_rounds = Optional_attribute_rounds<FT, has_attributes>; // of the control level

  // `last_rings`: how many rings of faces the last level shall have right, at least
  Piece_refiner(const Scheme& scheme, Level_connectivity&& control, Level_creases&& creases,
                Values&& values, Attribute_rounds&& attributes, unsigned rounds,
                std::size_t number_of_pieces, unsigned rings, const For_chunks& for_chunks,
                unsigned last_rings = 0)
    : scheme_(scheme)
    , rings_(rings)
    , rounds_(rounds)
    , base_round_(least_base_round(dividing_round<Host>(control.size(), rounds, number_of_pieces),
                                   rounds, creases))
    , for_chunks_(for_chunks)
    , base_(scheme_, std::move(control), std::move(creases), std::move(values), for_chunks)
    , attributes_(std::move(attributes))
  {
    while (base_.rounds_done() < base_round_) attributes_.refine(scheme_, base_);
    wholes_.emplace(base_.level(), base_round_, rounds_);
    division_.emplace(base_.level(), number_of_pieces, [this](Index v) {
      const Value value = base_.values()[v];
      const auto& p = point_of(value);
      return Face_division::Center{CGAL::to_double(p[0]), CGAL::to_double(p[1]),
                                   CGAL::to_double(p[2])};
    });
    if constexpr (is_creased) {
      if (!base_.creases().empty()) rings_ += more_rings;
      base_slots_.emplace(base_.level(), base_.creases());
    }
    if constexpr (has_attributes)
      if (attributes_) {
        chart_slots_ = attributes_->slots_of_charts(base_.level());
        if (attributes_->has_charts() && base_.creases().empty()) ++rings_; // as around creases
      }
    more_last_rings_ = last_rings > rings_ ? last_rings - rings_ : 0;
  }

  const Global_level& result() const override { return wholes_->back(); }
  const Level_connectivity& base() const override { return base_.level(); }
  Index refined_degree() const override { return Host::refined_degree; }

  bool is_empty(std::size_t piece) const override
  {
    return division_->begin(piece) == division_->end(piece) &&
           (piece != 0 || division_->isolated_vertices().empty());
  }

  void refine(std::size_t piece, unsigned rings, const Output& out) const override
  {
    const bool has_isolated = piece == 0;
    if (base_round_ == rounds_ || attributes_)
      return put(last_part(piece, has_isolated), has_isolated, rings, out);
    Part part = first_part(piece, has_isolated);
    for (unsigned k = base_round_ + 1; k < rounds_; ++k) part = refined(part, k, has_isolated);
    put_last_round(part, has_isolated, rings, out);
  }

  Limit_report refine_to_limit(std::size_t, unsigned, const Limit_demand&,
                               const Output&) const override
  {
    return {}; // see Piece_limits
  }

protected:
  static constexpr bool is_creased = are_creases_v<Level_creases>;
  using Last_level = Last_level_of_piece<Average, Level_creases>;

  struct Part
  {
    Level_connectivity level;
    Piece_elements elements;
    Level_creases creases;
    Values values; // of the slots
    Attribute_rounds attributes;
  };

  // the part after all rounds
  Part last_part(std::size_t piece, bool has_isolated) const
  {
    Part part = first_part(piece, has_isolated);
    for (unsigned k = base_round_ + 1; k <= rounds_; ++k) part = refined(part, k, has_isolated);
    return part;
  }
  const Scheme& scheme() const { return scheme_; }
  const For_chunks& for_chunks() const { return for_chunks_; }
  unsigned rounds() const { return rounds_; }

private:
  // The rules of creases read what the mask does, but of each vertex all wedges where creases run out: with one ring
  // more no vertex that is read misses faces. With two, nor does a vertex beside it, where a crease may end that takes
  // away its roundness.
  static constexpr unsigned more_rings = is_pn_v<Scheme> ? 2 : 1;

  // Creases::without_fractions belongs to the whole control level, which is then not divided
  static unsigned least_base_round(unsigned round, unsigned rounds,
                                   [[maybe_unused]] const Level_creases& creases)
  {
    if constexpr (is_creased)
      if (creases.without_fractions && round == 0) return (std::min)(rounds, 1u);
    return round;
  }

  struct Nothing
  {};
  using Slots = std::conditional_t<is_creased, std::optional<Corner_slots<FT>>, Nothing>;
  using Chart_slots = std::conditional_t<has_attributes, std::vector<Corner_slots<FT>>, Nothing>;

  // Elements of the level that is divided, which keep their numbers.
  template <class Is_owned>
  struct Base_elements
  {
    Is_owned is_owned;
    Global_ids::Number number(Index i) const { return i; }
  };
  template <class Is_owned>
  static Base_elements<Is_owned> base_elements(const Is_owned& is_owned)
  {
    return {is_owned};
  }

  Part first_part(std::size_t piece, bool has_isolated) const
  {
    Candidate_tables::Table table = tables_.take(base_.level());
    table->list(division_->begin(piece), division_->end(piece), rings_after(base_round_),
                has_isolated ? division_->isolated_vertices() : std::vector<Index>());
    Part part = first_part(piece, has_isolated, *table);
    tables_.give_back(std::move(table));
    return part;
  }
  Part first_part(std::size_t piece, bool has_isolated, const Listed_candidates& candidates) const
  {
    Piece_extraction<Listed_candidates> extraction(base_.level(), candidates, has_isolated);
    const Divided_level& all = *division_;
    Piece_elements elements{
      elements_of_part(extraction.old_vertices(),
                       base_elements([&](Index v) { return all.owns_vertex(piece, v); })),
      elements_of_part(extraction.old_edges(),
                       base_elements([&](Index e) { return all.owns_edge(piece, e); })),
      elements_of_part(extraction.old_faces(),
                       base_elements([&](Index f) { return all.owns_face(piece, f); }))};
    return part_of(base_, attributes_, extraction, std::move(elements), base_slots_, chart_slots_);
  }

  // `slots` and `chart_slots` belong to the level
  template <class Candidates>
  static Part part_of(const Refiner& level, [[maybe_unused]] const Attribute_rounds& attributes,
                      Piece_extraction<Candidates>& extraction, Piece_elements&& elements,
                      [[maybe_unused]] const Slots& slot_of,
                      [[maybe_unused]] const Chart_slots& chart_slots)
  {
    const bool has_creases = !level.creases().empty();
    Level_part cut(extraction, has_creases || bool(attributes));
    Part part{{}, std::move(elements), Level_creases(Index(cut.vertices.size())), {}, {}};
    std::vector<Index> slots_of_part;
    if constexpr (is_creased)
      if (has_creases) {
        part.creases = cut.creases(level.creases());
        slots_of_part = cut.slot_origins(part.creases, *slot_of);
      }
    const std::vector<Index>& origins = has_creases ? slots_of_part : cut.vertices;
    part.values = values_of_part(level.values(), origins);
    if constexpr (has_attributes)
      if (attributes) part.attributes = attributes.part(cut, origins, chart_slots);
    part.level = std::move(cut.level);
    return part;
  }

  // A ring more before a round is two more after it.
  unsigned rings_after(unsigned round) const
  {
    unsigned more = more_last_rings_;
    for (unsigned k = round; k < rounds_; ++k) more = (more + 1) / 2;
    return rings_ + more;
  }

  // the elements that are owned, and the rings around them
  Part with_rings(const Refiner& level, const Attribute_rounds& attributes,
                  const Piece_elements& elements, bool has_isolated) const
  {
    const Face_marks kept =
      owned_with_rings(level.level(), elements, rings_after(level.rounds_done()));
    const All_candidates candidates(level.level(), kept);
    Piece_extraction<All_candidates> extraction(level.level(), candidates, has_isolated);
    Slots slot_of;
    if constexpr (is_creased) slot_of.emplace(level.level(), level.creases());
    Chart_slots chart_slots;
    if constexpr (has_attributes)
      if (attributes) chart_slots = attributes->slots_of_charts(level.level());
    return part_of(level, attributes, extraction,
                   {elements_of_part(extraction.old_vertices(), elements.vertices),
                    elements_of_part(extraction.old_edges(), elements.edges),
                    elements_of_part(extraction.old_faces(), elements.faces)},
                   slot_of, chart_slots);
  }

  Refiner refiner(Part& part, unsigned round) const
  {
    const Level_size size = Host::refined_size(part.level.size(), round);
    if (size.halfedges() >= Level_connectivity::null || size.vertices >= Level_connectivity::null)
      throw std::length_error("PN_subdivision_3: a piece would have " +
                              std::to_string(size.halfedges()) +
                              " half-edges, more than can be numbered: ask for more pieces");
    if constexpr (!is_creased) part.creases = No_creases(part.level.number_of_vertices());
    return Refiner(scheme_, std::move(part.level), std::move(part.creases), std::move(part.values),
                   for_chunks_, round - 1);
  }

  Part refined(Part& part, unsigned round, bool has_isolated) const
  {
    Refiner level = refiner(part, round);
    const auto children = [&](const Host& host) {
      return Child_elements<Host>(part.elements, host, (*wholes_)[round - 1], for_chunks_)
        .all(Host::refined_size(level.level().size(), round));
    };
    Piece_elements elements;
    if constexpr (is_creased) elements = children(Host(level.level(), round)); // is cut open next
    part.attributes.before_cut(level);
    Level_round one = level.next_round();
    if constexpr (!is_creased) elements = children(one.host());
    part.elements = Piece_elements();
    part.attributes.refine(scheme_, level, one);
    return with_rings(level, part.attributes, elements, has_isolated);
  }

  void put_last_round(Part& part, bool has_isolated, unsigned rings, const Output& out) const
  {
    Refiner level = refiner(part, rounds_);
    const auto put_connectivity = [&](const Host& host, const Level_creases& creases) {
      return this->put_connectivity(level, host, part.elements, creases, has_isolated, rings, out);
    };
    if constexpr (is_creased) {
      const Level_size size = Host::refined_size(level.level().size(), rounds_);
      const auto vertices = static_cast<Index>(size.vertices);
      const Last_level last_level =
        put_connectivity(Host(level.level(), rounds_),
                         Refined_creases<FT>(level.creases(), level.level(), vertices).creases);
      Level_round one = level.next_round();
      put_values(level, one.round(), last_level, out);
      last_level.put_on_creases(one.crease_values(for_chunks_), vertices, out);
    } else {
      Level_round one = level.next_round();
      put_values(level, one, put_connectivity(one.host(), one.refined_creases()), out);
    }
  }

  void put_values(const Refiner& level, const typename Refiner::Plain_round& rows,
                  const Last_level& last_level, const Output& out) const
  {
    const auto& vertices = last_level.vertices();
    const auto put = [&](const Index* vertex, const Value* values, Index n) {
      for (Index i = 0; i < n; ++i)
        out.put(static_cast<Index>(vertex + i - vertices.data()), values[i], nullptr);
    };
    const auto transfers = level.transfers(rows);
    if (!transfers.is_empty())
      level.evaluate(rows, transfers, 0, static_cast<Index>(rows.refined_size().vertices),
                     [&](Index first, const Value* values, Index n) {
                       auto it = std::lower_bound(vertices.begin(), vertices.end(), first);
                       for (; it != vertices.end() && *it - first < n; ++it)
                         put(&*it, values + (*it - first), 1);
                     });
    else
      level.evaluate(rows, vertices.data(), static_cast<Index>(vertices.size()), put);
  }

  Last_level put_connectivity(const Refiner& level, const Host& host,
                              const Piece_elements& elements, const Level_creases& creases,
                              bool has_isolated, unsigned rings, const Output& out) const
  {
    const Child_elements<Host> children(elements, host, (*wholes_)[rounds_ - 1], for_chunks_);
    const Level_size size = Host::refined_size(level.level().size(), rounds_);
    const Level_connectivity child = child_level(host, size, size, for_chunks_);
    const Piece_elements all{children.vertices(child.size().vertices), Global_ids(),
                             children.faces(child.size().faces)};
    return Last_level(child, all, creases, has_isolated, rings,
                      Optional_attribute_rounds<FT, false>(), out);
  }

  // puts a part without a round
  static void put(const Part& part, bool has_isolated, unsigned rings, const Output& out)
  {
    const Last_level last_level(part.level, part.elements, part.creases, has_isolated, rings,
                                part.attributes, out);
    const auto& vertices = last_level.vertices();
    for (Index v = 0; v < vertices.size(); ++v) out.put(v, part.values[vertices[v]], nullptr);
    if constexpr (is_creased) {
      std::vector<typename Last_level::Slot_value> on_creases;
      for (const Crease_star& star : part.creases.stars)
        for (Index w = 0; w < star.number_of_wedges; ++w)
          on_creases.emplace_back(star.slot(w), part.values[star.slot(w)]);
      last_level.put_on_creases(std::move(on_creases), part.level.number_of_vertices(), out);
    }
  }

  const Scheme scheme_; // the levels refer to it
  unsigned rings_, more_last_rings_ = 0, rounds_, base_round_;
  For_chunks for_chunks_;
  Refiner base_;
  Attribute_rounds attributes_;
  std::optional<Global_levels<Host>> wholes_;
  // the slots of the level that is divided
  Slots base_slots_;
  Chart_slots chart_slots_;
  std::optional<Divided_level> division_;
  mutable Candidate_tables tables_;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_PIECES_PIECE_REFINER_H

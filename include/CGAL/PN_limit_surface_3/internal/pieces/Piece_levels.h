// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_PIECES_PIECE_LEVELS_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_PIECES_PIECE_LEVELS_H

#include <CGAL/PN_limit_surface_3/limit/Limit_point.h>
#include <CGAL/PN_subdivision_3/hosts/PQQ_host.h>
#include <CGAL/PN_subdivision_3/hosts/PTQ_host.h>
#include <CGAL/PN_subdivision_3/internal/attributes/Attribute_values.h>
#include <CGAL/PN_subdivision_3/internal/creases/Crease_round.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/creases/Smooth_rows.h>
#include <CGAL/PN_subdivision_3/internal/hosts/Edge_split.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/normals/Fan.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Level_part.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Piece_candidates.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <boost/container/vector.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// Elements of one kind in a piece: their numbers in the whole level, and whether the piece owns them. Every
// element of the whole level has one owner.
class Global_ids
{
public:
  using Number = std::uint64_t;

  Global_ids() = default;
  explicit Global_ids(std::size_t size)
    : number_(size, boost::container::default_init)
    , is_owned_(size, boost::container::default_init)
  {}

  std::size_t size() const { return number_.size(); }
  Number number(std::size_t i) const { return number_[i]; }
  bool is_owned(std::size_t i) const { return is_owned_[i] != 0; }

  // different elements by different threads
  void set(std::size_t i, Number number, bool is_owned)
  {
    number_[i] = number;
    is_owned_[i] = is_owned ? 1 : 0;
  }

private:
  boost::container::vector<Number> number_;
  boost::container::vector<char> is_owned_;
};

// The elements of a level of a piece, beside its connectivity. In all three kinds the numbers increase.
struct Piece_elements
{
  Global_ids vertices, edges, faces;
};

// The elements of a part of a level, whose elements in the level are `origins`; of a vertex that is there several times the
// first one may be owned.
template <class Elements>
Global_ids elements_of_part(const std::vector<Level_connectivity::Index>& origins,
                            const Elements& whole)
{
  Global_ids part(origins.size());
  for (std::size_t i = 0; i < origins.size(); ++i) {
    const bool is_first = i == 0 || origins[i - 1] != origins[i];
    part.set(i, whole.number(origins[i]), is_first && whole.is_owned(origins[i]));
  }
  return part;
}

// What the numbers of the children of a level depend on, besides their parents.
struct Global_level
{
  Level_size size;
  Face_corners<std::uint64_t> corners;
};

// The numbers that the children of elements have in a level that is not held, from those of their parents.
// The formulas are the hosts' own, in 64 bits. Only hosts that split edges have one: the numbers of others depend on
// the border of the whole level, too.
using Global_parent = Basic_element_parent<std::uint64_t>;

template <class Host>
class Global_numbering
{
  static constexpr bool is_pqq = std::is_same_v<Host, PQQ_host>;
  static_assert(is_pqq || std::is_same_v<Host, PTQ_host>);

public:
  using Number = std::uint64_t;

  explicit Global_numbering(const Global_level& level)
    : numbering_(of_host(level))
  {}

  Number vertex(const Global_parent& p) const
  {
    if (p.kind == Global_parent::Kind::vertex) return p.index;
    if constexpr (is_pqq)
      if (p.kind != Global_parent::Kind::edge) return numbering_.vertex_of_face(p.index);
    return numbering_.halves().vertex_of_edge(p.index);
  }
  Number edge(const Global_parent& p) const
  {
    if (p.kind == Global_parent::Kind::edge)
      return numbering_.halves().half_of_edge(p.index, p.ordinal);
    if constexpr (is_pqq)
      return numbering_.spoke(numbering_.first_corner(p.index), p.ordinal);
    else
      return numbering_.inner_edge(p.index, p.ordinal);
  }
  Number face(const Global_parent& p) const
  {
    if constexpr (is_pqq)
      return numbering_.quad(p.index, numbering_.first_corner(p.index), p.ordinal);
    else
      return p.ordinal == 0 ? numbering_.middle_triangle(p.index)
                            : numbering_.corner_triangle(p.index, p.ordinal - 1);
  }

private:
  static auto of_host(const Global_level& level)
  {
    if constexpr (is_pqq)
      return PQQ_numbering<Number>(level.size, level.corners);
    else
      return PTQ_numbering<Number>(level.size);
  }

  std::conditional_t<is_pqq, PQQ_numbering<Number>, PTQ_numbering<Number>> numbering_;
};

// The elements of the child of a level of a piece: their numbers follow from those of their parents, and who
// owns a parent owns its children.
template <class Host>
class Child_elements
{
public:
  using Index = Level_connectivity::Index;

  // the arguments must stay
  Child_elements(const Piece_elements& elements, const Host& host, const Global_level& whole,
                 const For_chunks& for_chunks)
    : elements_(elements)
    , host_(host)
    , numbering_(whole)
    , for_chunks_(for_chunks)
  {}

  Global_ids vertices(std::size_t size) const
  {
    return children(
      size, [&](Index c) { return host_.parent_of_vertex(c); },
      [&](const Global_parent& p) { return numbering_.vertex(p); });
  }
  Global_ids edges(std::size_t size) const
  {
    return children(
      size, [&](Index c) { return host_.parent_of_edge(c); },
      [&](const Global_parent& p) { return numbering_.edge(p); });
  }
  Global_ids faces(std::size_t size) const
  {
    return children(
      size, [&](Index c) { return host_.parent_of_face(c); },
      [&](const Global_parent& p) { return numbering_.face(p); });
  }
  Piece_elements all(const Level_size& size) const
  {
    return {vertices(size.vertices), edges(size.edges), faces(size.faces)};
  }

private:
  using Kind = Element_parent::Kind;

  template <class Parent_of, class Number_of>
  Global_ids children(std::size_t size, const Parent_of& parent_of, const Number_of& number) const
  {
    Global_ids result(size);
    for_chunks_(static_cast<Index>(size), [&](Index begin, Index end) {
      for (Index c = begin; c < end; ++c) {
        const Element_parent p = parent_of(c);
        const Global_ids& parents = p.kind == Kind::vertex ? elements_.vertices
                                    : p.kind == Kind::edge ? elements_.edges
                                                           : elements_.faces;
        const auto kind = static_cast<Global_parent::Kind>(p.kind);
        result.set(c, number(Global_parent{kind, parents.number(p.index), p.ordinal}),
                   parents.is_owned(p.index));
      }
    });
    return result;
  }

  const Piece_elements& elements_;
  const Host& host_;
  Global_numbering<Host> numbering_;
  const For_chunks& for_chunks_;
};

// What the numbers of the elements depend on, from a level that is held up to the last one.
template <class Host>
class Global_levels
{
public:
  // the first level, the number of its round, and the number of the last round
  Global_levels(const Level_connectivity& base, unsigned base_round, unsigned last_round)
    : base_round_(base_round)
  {
    levels_.push_back({base.size(), Face_corners<std::uint64_t>(base)});
    for (unsigned k = base_round + 1; k <= last_round; ++k)
      levels_.push_back({Host::refined_size(levels_.back().size, k),
                         Face_corners<std::uint64_t>(Host::refined_degree)});
  }

  // the level after round k
  const Global_level& operator[](unsigned k) const { return levels_[k - base_round_]; }
  const Global_level& back() const { return levels_.back(); }

private:
  unsigned base_round_;
  std::vector<Global_level> levels_;
};

template <class Average>
struct Limit_result;
struct Limit_demand;

// What pieces are asked for, whatever the scheme.
template <class Average>
class Abstract_pieces
{
public:
  using Index = Level_connectivity::Index;
  using Value = typename Average::Value;
  using Attributes = Control_attributes<typename Average::FT>;

  using Limit = Limit_result<Average>;

  // takes (connectivity, its vertices, its faces), to be moved, once and then (vertex, value, limit), of different
  // vertices from different threads; at last (half-edge, wedge, value, limit) for the corners of vertices with several
  // wedges, in increasing order; limits are null unless they are asked for
  struct Output
  {
    Function_ref<void(Level_connectivity&, Global_ids&, Global_ids&)> begin;
    Function_ref<void(Index, const Value&, const Limit*)> put;
    Function_ref<void(Index, Index, const Value&, const Limit*)> put_corner;
    Function_ref<void(Attributes&)> put_attributes; // if there are any, before the end
  };

  Abstract_pieces() = default;
  Abstract_pieces(const Abstract_pieces&) = delete;
  Abstract_pieces& operator=(const Abstract_pieces&) = delete;
  virtual ~Abstract_pieces() = default;

  // the level after all rounds
  virtual const Global_level& result() const = 0;
  // the level that is divided
  virtual const Level_connectivity& base() const = 0;
  // the degree of all faces that a round makes
  virtual Index refined_degree() const = 0;
  virtual bool is_empty(std::size_t piece) const = 0;
  // the faces that the piece owns, and some rings around them
  virtual void refine(std::size_t piece, unsigned rings, const Output& out) const = 0;
  // The same on the limit surface; what has been reached at the vertices that are owned. \pre the pieces have limits
  virtual Limit_report refine_to_limit(std::size_t piece, unsigned rings,
                                       const Limit_demand& demand, const Output& out) const = 0;
};

inline Face_marks owned_with_rings(const Level_connectivity& level, const Piece_elements& elements,
                                   unsigned rings)
{
  Face_marks marks(elements.faces.size());
  for (std::size_t f = 0; f < marks.size(); ++f) marks[f] = elements.faces.is_owned(f) ? 1 : 0;
  for (unsigned i = 0; i < rings; ++i) add_ring(level, marks);
  return marks;
}

// What a piece keeps of its last level: faces, their vertices, and the corners of vertices with several wedges.
template <class Average, class Level_creases>
class Last_level_of_piece
{
public:
  using FT = typename Average::FT;
  using Value = typename Average::Value;
  using Index = Level_connectivity::Index;
  using Output = typename Abstract_pieces<Average>::Output;
  using Slot_value = std::pair<Index, Value>;

  // Puts the connectivity of the faces that are owned and of the rings around them, and their attributes.
  template <class Attribute_rounds>
  Last_level_of_piece(const Level_connectivity& level, const Piece_elements& elements,
                      [[maybe_unused]] const Level_creases& creases, bool has_isolated,
                      unsigned rings, const Attribute_rounds& attributes, const Output& out)
  {
    const Face_marks kept = owned_with_rings(level, elements, rings);
    const All_candidates candidates(level, kept);
    Extraction extraction(level, candidates, has_isolated);
    Global_ids vertices = elements_of_part(extraction.old_vertices(), elements.vertices);
    Global_ids faces = elements_of_part(extraction.old_faces(), elements.faces);
    Level_part part(extraction, bool(attributes));
    if constexpr (!std::is_empty_v<Attribute_rounds>)
      if (attributes)
        out.put_attributes(attributes
                             .part(part, part.creases_and_slots(level, creases).second,
                                   attributes->slots_of_charts(level))
                             ->put_part(part));
    out.begin(part.level, vertices, faces);
    vertices_ = std::move(part.vertices);
    if constexpr (are_creases_v<Level_creases>) list_corners(extraction, level, creases);
  }

  // calls f(half-edge, wedge, slot) with the corners of vertices with several wedges, in the order of the half-edges
  template <class Function>
  void for_each_corner(const Function& f) const
  {
    for (const Corner& c : corners_) f(c.halfedge, c.wedge, c.slot);
  }

  // the vertices of the level that the piece owns, in increasing order
  const std::vector<Index>& vertices() const { return vertices_; }

  // instead of what the rows have given there; the slots of a vertex follow one another
  void put_on_creases(std::vector<Slot_value> values, Index number_of_vertices,
                      const Output& out) const
  {
    for_each_crease_vertex<Average>(
      values, number_of_vertices, [&](std::size_t, Index v, const Value& value) {
        auto it = std::lower_bound(vertices_.begin(), vertices_.end(), v);
        for (; it != vertices_.end() && *it == v; ++it)
          out.put(static_cast<Index>(it - vertices_.begin()), value, nullptr);
      });
    const auto is_before = [](const Slot_value& a, const Slot_value& b) {
      return a.first < b.first;
    };
    std::sort(values.begin(), values.end(), is_before);
    for_each_corner([&](Index h, Index wedge, Index slot) {
      out.put_corner(
        h, wedge,
        std::lower_bound(values.begin(), values.end(), Slot_value(slot, {}), is_before)->second,
        nullptr);
    });
  }

private:
  using Extraction = Piece_extraction<All_candidates>;

  struct Corner
  {
    Index halfedge; // of the piece
    Index slot, wedge;
  };

  void list_corners(const Extraction& extraction, const Level_connectivity& level,
                    const Creases<FT>& creases)
  {
    const Corner_slots<FT> slot_of(level, creases);
    for (const Crease_star& star : creases.stars) {
      if (star.number_of_wedges == 1) continue;
      for_each_halfedge_to(level, star.vertex, [&](Index h) {
        if (extraction.is_inside(h))
          corners_.push_back({extraction.new_halfedge(h), slot_of(h), star.wedge(slot_of(h))});
      });
    }
    std::sort(corners_.begin(), corners_.end(),
              [](const Corner& a, const Corner& b) { return a.halfedge < b.halfedge; });
  }

  std::vector<Index> vertices_;
  std::vector<Corner> corners_; // in the order of the half-edges
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_PIECES_PIECE_LEVELS_H

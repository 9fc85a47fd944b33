// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_PIECES_WHOLE_LEVELS_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_PIECES_WHOLE_LEVELS_H

#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Divided_level.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Level_refiner.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Piece_extraction.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Whole_level.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The elements of the child of a level of a piece: their numbers follow from those of their parents, and who
// owns a parent owns its children.
template <class Host>
class Child_elements
{
public:
  using Index = Level_connectivity::Index;
  using Number = Numbered_elements::Number;

  // all of it must stay
  Child_elements(const Level_connectivity& level, const Piece_elements& elements, const Host& host,
                 const Whole_level& whole, const For_chunks& for_chunks)
    : level_(level)
    , elements_(elements)
    , host_(host)
    , numbering_(whole)
    , for_chunks_(for_chunks)
  {}

  Numbered_elements vertices(std::size_t size) const
  {
    return children(
      size, [&](Index c) { return host_.parent_of_vertex(c); },
      [&](const Whole_parent& p) { return numbering_.vertex(p); }, 0);
  }
  Numbered_elements edges(std::size_t size) const
  {
    return children(
      size, [&](Index c) { return host_.parent_of_edge(c); },
      [&](const Whole_parent& p) { return numbering_.edge(p); }, 1);
  }
  Numbered_elements faces(std::size_t size) const
  {
    return children(
      size, [&](Index c) { return host_.parent_of_face(c); },
      [&](const Whole_parent& p) { return numbering_.face(p); }, 0);
  }
  Piece_elements all(const Level_size& size) const
  {
    return {vertices(size.vertices), edges(size.edges), faces(size.faces)};
  }

private:
  using Kind = Element_parent::Kind;
  using Whole_kind = Whole_parent::Kind;

  struct Origin
  {
    Whole_parent parent;
    bool is_owned;
  };

  template <class Parent_of, class Number_of>
  Numbered_elements children(std::size_t size, const Parent_of& parent_of, const Number_of& number,
                             Index border_ordinal) const
  {
    Numbered_elements result(size);
    for_chunks_(static_cast<Index>(size), [&](Index begin, Index end) {
      for (Index c = begin; c < end; ++c) {
        const Origin o = origin(parent_of(c), border_ordinal);
        if (o.parent.index == Numbered_elements::no_number)
          result.set(c, Numbered_elements::no_number, false);
        else
          result.set(c, number(o.parent), o.is_owned);
      }
    });
    return result;
  }

  static Origin origin_in(const Numbered_elements& of, Index i, Whole_kind kind, Index ordinal)
  {
    return {{kind, of.number(i), ordinal}, of.is_owned(i)};
  }

  Origin origin(const Element_parent& p, Index border_ordinal) const
  {
    switch (p.kind) {
    case Kind::vertex:
      return origin_in(elements_.vertices, p.index, Whole_kind::vertex, p.ordinal);
    case Kind::edge:
      return origin_in(elements_.edges, p.index, Whole_kind::edge, p.ordinal);
    case Kind::face:
      return origin_in(elements_.faces, p.index, Whole_kind::face, p.ordinal);
    case Kind::corner:
      return origin_in_corner(p.index);
    default:
      return origin_in_border_edge(p, border_ordinal);
    }
  }

  Origin origin_in_corner([[maybe_unused]] Index h) const
  {
    if constexpr (std::is_same_v<Host, DQQ_host>) {
      const Index f = level_.face(h), first = level_.halfedge_of_face(f);
      return origin_in(elements_.faces, f, Whole_kind::corner,
                       host_.vertex_of_corner(h) - host_.vertex_of_corner(first));
    } else
      return {{Whole_kind::corner, Numbered_elements::no_number}, false};
  }

  // The first part of a refined border edge has the number of the edge, all else those of the face. The parts
  // are numbered behind its inner edges.
  Origin origin_in_border_edge(const Element_parent& p, Index border_ordinal) const
  {
    if (border_ordinal != 0 && p.ordinal == 0)
      return origin_in(elements_.edges, Level_connectivity::edge(p.index), Whole_kind::edge, 0);
    return origin_in(elements_.faces, level_.face(p.index), Whole_kind::face,
                     p.ordinal + border_ordinal);
  }

  const Level_connectivity& level_;
  const Piece_elements& elements_;
  const Host& host_;
  Whole_numbering<Host> numbering_;
  const For_chunks& for_chunks_;
};

// Elements of a level that is held: of faces `is_owned`, of all others nothing is owned.
inline Piece_elements elements_of(const Level_size& size, const Face_marks& is_owned)
{
  Piece_elements elements{Numbered_elements(size.vertices), Numbered_elements(size.edges),
                          Numbered_elements(size.faces)};
  for (std::size_t v = 0; v < size.vertices; ++v) elements.vertices.set(v, v, false);
  for (std::size_t e = 0; e < size.edges; ++e) elements.edges.set(e, e, false);
  for (std::size_t f = 0; f < size.faces; ++f) elements.faces.set(f, f, is_owned[f] != 0);
  return elements;
}

inline Face_marks owned_faces(const Numbered_elements& faces)
{
  Face_marks is_owned(faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f) is_owned[f] = faces.is_owned(f) ? 1 : 0;
  return is_owned;
}

// What the numbers of the elements depend on, from a level that is held up to the last one. Where that is
// the border, a strip along it is refined, which takes memory and time in proportion to the border.
template <class Host>
class Whole_levels
{
public:
  using Index = Level_connectivity::Index;

  // the first level, the number of its round, and that of the last one
  Whole_levels(const Level_connectivity& base, unsigned base_round, unsigned last_round)
    : base_round_(base_round)
  {
    Level_size size = base.size();
    const First_corners corners(base);
    for (unsigned k = base_round; k <= last_round; ++k) {
      if (k > base_round) size = Host::refined_size(size, k);
      const bool is_uniform = k > base_round && Host::refined_degree != 0;
      levels_.push_back(
        {size, is_uniform ? First_corners(Host::refined_degree) : corners, {}, {}, {}});
    }
    if (numbers_depend_on_border && base.has_border()) follow_border(base, last_round);
  }

  // after round k
  const Whole_level& operator[](unsigned k) const { return levels_[k - base_round_]; }
  const Whole_level& back() const { return levels_.back(); }

private:
  static constexpr bool numbers_depend_on_border =
    std::is_same_v<Host, Sqrt3_host> || std::is_same_v<Host, DQQ_host>;
  static constexpr unsigned rings = 2; // for sqrt(3), whose triangles reach into their neighbors

  void follow_border(const Level_connectivity& base, unsigned last_round)
  {
    const For_chunks for_chunks;
    Face_marks at_border = faces_at_border(base, Face_marks(base.number_of_faces(), 1));
    Piece_elements elements = elements_of(base.size(), at_border);
    Level_connectivity strip = extract(base, elements, std::move(at_border));
    for (unsigned k = base_round_; k < last_round; ++k) {
      Whole_level& whole = levels_[k - base_round_];
      find_border(strip, elements, refines_border<Host>(k + 1), whole);
      if (refines_border<Host>(k + 1)) close_rim(strip, elements, whole);
      const Host host(strip, k + 1);
      const Level_size child_size = Host::refined_size(strip.size(), k + 1);
      const Level_connectivity child = child_level(host, child_size, child_size, for_chunks);
      elements = Child_elements<Host>(strip, elements, host, whole, for_chunks).all(child.size());
      Face_marks kept = faces_at_border(child, owned_faces(elements.faces));
      for (std::size_t f = 0; f < kept.size(); ++f)
        elements.faces.set(f, elements.faces.number(f), kept[f] != 0);
      strip = extract(child, elements, std::move(kept));
    }
  }

  static Level_connectivity extract(const Level_connectivity& level, Piece_elements& elements,
                                    Face_marks faces)
  {
    for (unsigned i = 0; i < rings; ++i) add_ring(level, faces);
    const All_candidates candidates(level, faces);
    Piece_extraction<All_candidates> extraction(level, candidates, false);
    elements = extraction.elements(elements);
    own_edges(extraction.piece(), elements);
    return std::move(extraction.piece());
  }

  // those between owned faces, since Doo-Sabin makes faces of them
  static void own_edges(const Level_connectivity& level, Piece_elements& elements)
  {
    const auto is_owned = [&](Index h) {
      return !level.is_border(h) && elements.faces.is_owned(level.face(h));
    };
    for (Index e = 0; e < level.number_of_edges(); ++e)
      elements.edges.set(e, elements.edges.number(e), is_owned(2 * e) && is_owned(2 * e + 1));
  }

  // The half-edges on the border, not on the rim: the vertices of owned faces have all their faces.
  template <class Function>
  static void for_each_on_border(const Level_connectivity& level, const Face_marks& is_owned,
                                 const Function& f)
  {
    for (Index h = 0; h < level.number_of_halfedges(); ++h)
      if (level.is_border(h) && is_owned[level.face(Level_connectivity::opposite(h))] != 0) f(h);
  }

  // those that share a vertex with it
  static Face_marks faces_at_border(const Level_connectivity& level, const Face_marks& is_owned)
  {
    std::vector<char> is_on_border(level.number_of_vertices(), 0);
    for_each_on_border(level, is_owned, [&](Index h) { is_on_border[level.target(h)] = 1; });
    Face_marks result(level.number_of_faces(), 0);
    for (Index h = 0; h < level.number_of_halfedges(); ++h)
      if (!level.is_border(h) && is_on_border[level.target(h)] != 0) result[level.face(h)] = 1;
    return result;
  }

  static void find_border(const Level_connectivity& strip, const Piece_elements& elements,
                          bool is_refined, Whole_level& whole)
  {
    std::vector<Some_elements::Number> faces, edges, vertices;
    for_each_on_border(strip, owned_faces(elements.faces), [&](Index h) {
      faces.push_back(elements.faces.number(strip.face(Level_connectivity::opposite(h))));
      edges.push_back(elements.edges.number(Level_connectivity::edge(h)));
      vertices.push_back(elements.vertices.number(strip.target(h)));
    });
    if (is_refined) whole.border_faces = Some_elements(std::move(faces));
    if constexpr (std::is_same_v<Host, DQQ_host>) {
      whole.border_edges = Some_elements(std::move(edges));
      whole.border_vertices = Some_elements(std::move(vertices));
    }
  }

  unsigned base_round_;
  std::vector<Whole_level> levels_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_PIECES_WHOLE_LEVELS_H

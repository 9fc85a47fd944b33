// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_ATTRIBUTE_ORIGINS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_ATTRIBUTE_ORIGINS_H

#include <CGAL/PN_subdivision_3/internal/attributes/Columns.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Level_part.h>
#include <CGAL/PN_subdivision_3/internal/rows/Level_origins.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// The attributes of a call that are copied without rows, and the parents that it asks for.
struct Columns_of_call
{
  template <class Number>
  using List = std::vector<std::unique_ptr<Column<Number>>>;

  List<Level_connectivity::Index> edges, faces;
  List<Origin_and_face> vertex_origins, edge_origins, face_origins;

  void take_parts_of_columns(const Columns_of_call& whole)
  {
    const auto take = [](auto& parts, const auto& columns) {
      for (const auto& column : columns) parts.push_back(column->part());
    };
    take(edges, whole.edges);
    take(faces, whole.faces);
    take(vertex_origins, whole.vertex_origins);
    take(edge_origins, whole.edge_origins);
    take(face_origins, whole.face_origins);
  }
  // with the origins that a visitor asks for
  Level_origins::Kinds needed_origins(const Level_origins::Kinds& visited) const
  {
    return {visited.vertices || !vertex_origins.empty(),
            visited.edges || !edge_origins.empty() || !edges.empty(),
            visited.faces || !face_origins.empty() || !faces.empty()};
  }
};

// The first control face at an origin, that is the one with the least number at an edge or a vertex. Where
// faces come from faces only, nothing is stored.
class Control_faces
{
public:
  using Index = Level_connectivity::Index;

  Control_faces() = default;
  explicit Control_faces(const Level_connectivity& level)
    : of_edge_(level.number_of_edges(), Level_connectivity::null)
    , of_vertex_(level.number_of_vertices(), Level_connectivity::null)
  {
    for (Index h = 0; h < level.number_of_halfedges(); ++h) {
      if (level.is_border(h)) continue;
      const Index f = level.face(h);
      for (Index* first : {&of_edge_[Level_connectivity::edge(h)], &of_vertex_[level.target(h)]})
        *first = (std::min)(*first, f); // null is the largest
    }
  }

  Index operator()(const Origin& origin) const
  {
    if (origin.kind == Origin::Kind::face) return origin.index;
    const std::vector<Index>& faces = origin.kind == Origin::Kind::edge ? of_edge_ : of_vertex_;
    return faces.empty() ? Level_connectivity::null : faces[origin.index];
  }

private:
  std::vector<Index> of_edge_, of_vertex_;
};

// Where the elements of a level come from through the rounds of a call, as far as columns, or a visitor, ask for it.
class Origin_rounds
{
public:
  using Index = Level_connectivity::Index;
  using Kinds = Level_origins::Kinds;

  Origin_rounds(const Level_connectivity& control, Kinds wanted, bool splits_edges)
    : wanted_(wanted)
    , splits_edges_(splits_edges)
  {
    if (!splits_edges && wanted.faces) control_faces_ = std::make_shared<Control_faces>(control);
  }
  // of a part of the level of `whole`
  Origin_rounds(const Origin_rounds& whole, const Level_part& part, const For_chunks& for_chunks)
    : wanted_(whole.wanted_)
    , splits_edges_(whole.splits_edges_)
    , control_faces_(whole.control_faces_)
  {
    if (wanted_.any())
      origins_ = child_origins(Of_part(whole.origins_, part), part.level.size(), for_chunks);
  }

  const Level_origins& origins() const { return origins_; }

  // `rules` tell where the elements of the refined level come from
  void begin_round(const Origin_source& rules, const Level_size& refined,
                   const For_chunks& for_chunks)
  {
    if (wanted_.any()) refined_origins_ = child_origins(rules, refined, for_chunks);
  }
  void end_round()
  {
    if (refined_origins_) origins_ = std::move(*refined_origins_);
    refined_origins_.reset();
  }

  // puts the columns for the elements of the refined mesh
  void put(const Columns_of_call& columns, const Level_size& size, const Origin_source& rules) const
  {
    const auto edge = [](const Origin& o) {
      return o.kind == Origin::Kind::edge ? o.index : Level_connectivity::null;
    };
    const auto face = [this](const Origin& o) { return control_face(o); };
    const auto both = [this](const Origin& o) {
      return Origin_and_face{control_element(o), control_face(o)};
    };
    put_columns(columns.edges, size.edges, rules, &Origin_source::edge, edge);
    put_columns(columns.faces, size.faces, rules, &Origin_source::face, face);
    put_columns(columns.vertex_origins, size.vertices, rules, &Origin_source::vertex, both);
    put_columns(columns.edge_origins, size.edges, rules, &Origin_source::edge, both);
    put_columns(columns.face_origins, size.faces, rules, &Origin_source::face, both);
  }

private:
  struct Of_part final : Origin_source
  {
    Of_part(const Level_origins& origins_of_whole, const Level_part& part_of_level)
      : whole(origins_of_whole)
      , part(part_of_level)
    {}
    Origin vertex(Index v) const override { return whole.vertex(part.vertices[v]); }
    Origin edge(Index e) const override { return whole.edge(part.edges[e]); }
    Origin face(Index f) const override { return whole.face(part.faces[f]); }

    const Level_origins& whole;
    const Level_part& part;
  };

  Level_origins child_origins(const Origin_source& rules, const Level_size& child,
                              const For_chunks& for_chunks) const
  {
    return Level_origins::of_child(rules, child, Level_origins::needed(wanted_, splits_edges_),
                                   for_chunks);
  }

  // puts the values of copies or the origins of the elements of a kind; of(origin) is what the columns take
  template <class Columns, class Function>
  static void put_columns(const Columns& columns, std::uint64_t number, const Origin_source& rules,
                          Origin (Origin_source::*origin)(Index) const, const Function& of)
  {
    if (columns.empty()) return;
    constexpr Index most = 64; // at once
    std::array<decltype(of(Origin())), most> values;
    const auto end = static_cast<Index>(number);
    for (auto& column : columns) column->begin(end);
    for (Index first = 0; first < end; first += most) {
      const Index n = (std::min)(most, end - first);
      for (Index i = 0; i < n; ++i) values[i] = of((rules.*origin)(first + i));
      for (auto& column : columns) column->put(first, n, values.data());
    }
  }

  Index control_face(const Origin& origin) const
  {
    return control_faces_ == nullptr ? Control_faces()(origin) : (*control_faces_)(origin);
  }

  Kinds wanted_;
  bool splits_edges_;
  std::shared_ptr<const Control_faces> control_faces_; // where faces do not come from faces alone
  Level_origins origins_;
  std::optional<Level_origins> refined_origins_;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_ATTRIBUTE_ORIGINS_H

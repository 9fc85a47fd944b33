// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_CARRIED_ATTRIBUTES_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_CARRIED_ATTRIBUTES_H

#include <CGAL/PN_subdivision_3/Control_element.h>
#include <CGAL/PN_subdivision_3/attributes/Corner_rule.h>
#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/attributes/Carried_values.h>
#include <CGAL/PN_subdivision_3/internal/hosts/Level_origins.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

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
class Origin_values
{
public:
  using Index = Level_connectivity::Index;

  Origin_values() = default;
  Origin_values(const Origin_values&) = delete;
  Origin_values& operator=(const Origin_values&) = delete;
  virtual ~Origin_values() = default;

  virtual void begin(std::size_t number_of_elements) = 0;
  virtual void set(Index element, const Control_element& origin, Index face) = 0;
  virtual void keep() noexcept = 0;
};

template <class FT>
struct Corner_attribute_values
{
  std::unique_ptr<Row_values<FT>> values;
  Corner_rule rule;
};

// What a call carries, read from the mesh and its maps before the first round.
template <class FT>
struct Carried_attributes
{
  template <class T>
  using List = std::vector<std::unique_ptr<T>>;

  List<Row_values<FT>> vertices;
  std::vector<Corner_attribute_values<FT>> corners;
  List<Copied_values> edges, faces;
  List<Origin_values> vertex_origins, edge_origins, face_origins;

  Level_origins::Kinds needed_origins() const
  {
    return {!vertex_origins.empty(), !edge_origins.empty() || !edges.empty(),
            !face_origins.empty() || !faces.empty()};
  }

  void keep() noexcept
  {
    const auto keep_all = [](auto& list) {
      for (auto& values : list) values->keep();
    };
    keep_all(vertices);
    for (Corner_attribute_values<FT>& corner : corners) corner.values->keep();
    keep_all(edges);
    keep_all(faces);
    keep_all(vertex_origins);
    keep_all(edge_origins);
    keep_all(face_origins);
  }
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_ATTRIBUTES_CARRIED_ATTRIBUTES_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_TESSELLATION_TESSELLATION_TABLE_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_TESSELLATION_TESSELLATION_TABLE_H

#include <CGAL/PN_subdivision_3/attributes/Attribute_traits.h>
#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/attributes/Array_values.h>
#include <CGAL/PN_subdivision_3/internal/tessellation/Leaf_triangles.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The arrays of a user's table, of which a tessellation carries the numbers.
class Tessellation_table
{
public:
  using Index = Level_connectivity::Index;

  // null: there are none. The table must stay.
  explicit Tessellation_table(Attribute_table* table)
    : table_(table)
  {}

  bool any() const { return table_ != nullptr; }
  // its arrays without values
  std::optional<Attribute_table> shape() const
  {
    if (table_ == nullptr) return std::nullopt;
    Attribute_table shape;
    shape.has_face_parents = table_->has_face_parents;
    for (const Attribute_array& a : table_->vertices)
      shape.vertices.push_back({a.dimension, {}, a.rule});
    for (const Attribute_array& a : table_->corners)
      shape.corners.push_back({a.dimension, {}, a.rule});
    return shape;
  }
  void set(Attribute_table&& result) const
  {
    if (table_ != nullptr) *table_ = std::move(result);
  }
  std::size_t dimension_of_corners() const
  {
    std::size_t n = 0;
    if (table_ != nullptr)
      for (const Attribute_array& array : table_->corners) n += array.dimension;
    return n;
  }

  template <class Data>
  Data read(const Level_connectivity& level) const
  {
    Data result;
    if (table_ == nullptr) return result;
    if (!table_->edges.empty())
      throw std::invalid_argument("PN_subdivision_3: there is an attribute of edges, but the edges "
                                  "of a tessellation are not parts of those of the control mesh");
    for (const Attribute_array& array : table_->corners)
      if (array.rule != Corner_rule::all)
        throw std::invalid_argument("PN_subdivision_3: tessellations carry attributes of corners "
                                    "by Corner_rule::all only, which is linear inside the faces");
    result.vertices =
      joined(table_->vertices, level.number_of_vertices(), "vertices", result.of_vertices);
    result.corners = joined(table_->corners, level.number_of_halfedges(), "corners (half-edges)",
                            result.of_corners);
    result.largest.assign(result.of_vertices, 0);
    for (std::size_t i = 0; i < result.vertices.size(); ++i) {
      double& largest = result.largest[i % result.of_vertices];
      largest = (std::max)(largest, std::abs(result.vertices[i]));
    }
    return result;
  }

  // the arrays of the result; half-edges have the numbers that the level of the triangles gives them
  template <class Refinement, class FT>
  Attribute_table of_result(const Refinement& refinement, const Leaf_triangles<FT>& triangles) const
  {
    Attribute_table result;
    result.has_face_parents = table_->has_face_parents;
    if (result.has_face_parents)
      for (const Tessellation_triangle& t : triangles.triangles())
        result.face_parents.push_back(t.origin);
    std::size_t first = 0;
    for (const Attribute_array& array : table_->vertices) {
      result.vertices.push_back({array.dimension, {}, array.rule});
      for (Index v = 0; v < refinement.all().number_of_vertices(); ++v)
        for (std::size_t k = 0; k < array.dimension; ++k)
          result.vertices.back().values.push_back(refinement.attributes().value(v, first + k));
      first += array.dimension;
    }
    first = 0;
    const std::size_t all = dimension_of_corners();
    for (const Attribute_array& array : table_->corners) {
      const std::size_t n = array.dimension;
      result.corners.push_back(
        {n, std::vector<double>(2 * n * triangles.number_of_edges()), array.rule});
      std::size_t corner = 0;
      for (const Tessellation_triangle& t : triangles.triangles())
        for (std::size_t i = 0; i < 3; ++i, ++corner) // the half-edge before leads to it
          std::copy_n(triangles.corner_values().begin() + std::ptrdiff_t(corner * all + first), n,
                      result.corners.back().values.begin() +
                        std::ptrdiff_t(n * t.halfedges[i == 0 ? 2 : i - 1]));
      first += n;
    }
    return result;
  }

private:
  // those of an element next to each other
  static std::vector<double> joined(const std::vector<Attribute_array>& arrays,
                                    std::size_t elements, const char* kind, std::size_t& dimension)
  {
    dimension = 0;
    for (const Attribute_array& array : arrays) {
      check_array(array, elements, kind);
      dimension += array.dimension;
    }
    std::vector<double> values(dimension * elements);
    std::size_t first = 0;
    for (const Attribute_array& array : arrays) {
      for (std::size_t i = 0; i < elements; ++i)
        std::copy_n(array.values.begin() + std::ptrdiff_t(i * array.dimension), array.dimension,
                    values.begin() + std::ptrdiff_t(i * dimension + first));
      first += array.dimension;
    }
    return values;
  }

  Attribute_table* table_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_TESSELLATION_TESSELLATION_TABLE_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_TESSELLATION_TESSELLATION_OUTPUT_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_TESSELLATION_TESSELLATION_OUTPUT_H

#include <CGAL/PN_limit_surface_3/internal/limit_surface/Flatness.h>
#include <CGAL/PN_limit_surface_3/internal/tessellation/Leaf_triangles.h>
#include <CGAL/PN_limit_surface_3/internal/tessellation/Split_edges.h>
#include <CGAL/PN_limit_surface_3/internal/tessellation/Tessellation_attributes.h>
#include <CGAL/PN_subdivision_3/attributes/Attribute_traits.h>
#include <CGAL/PN_subdivision_3/internal/attributes/Array_values.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// The triangles of all leaves as a level of their own. They are joined along the half-edges that they have from the
// edges of the levels, not by their vertices: two of these may have several edges.
template <class FT>
class Tessellation_mesh
{
public:
  using Index = Level_connectivity::Index;
  using Vector = flatness::Vector;

  Tessellation_mesh(const Split_edges<FT>& all, const Leaf_triangles<FT>& triangles)
    : all_(all)
    , triangles_(triangles.triangles())
  {
    Level_size size;
    size.vertices = all.number_of_vertices();
    size.edges = triangles.number_of_edges();
    size.faces = triangles_.size();
    size.corners = 3 * size.faces;
    level_ = Level_connectivity(size);
    level_.set_uniform_degree(3);
    connect(triangles.number_of_edges());
    find_isolated(size);
  }

  const Level_connectivity& level() const { return level_; }
  // calls f(half-edge, normal) for all corners
  template <class Function>
  void for_each_corner(const Function& f) const
  {
    for (const Tessellation_triangle& t : triangles_)
      for (std::size_t i = 0; i < 3; ++i)
        f(t.halfedges[i == 0 ? 2 : i - 1], all_.slot(t.slot_ids[i]).normal);
  }
  // of the vertices, where there are several wedges the mean of these
  std::vector<Vector> normals() const
  {
    std::vector<Vector> sums(all_.number_of_vertices(), Vector{});
    std::vector<unsigned> wedges(sums.size(), 0);
    for (Index s = 0; s < all_.number_of_slots(); ++s) {
      const auto& slot = all_.slot(s);
      if (slot.vertex == null) continue;
      add_multiple<double, 3>(sums[slot.vertex], 1, slot.normal);
      ++wedges[slot.vertex];
    }
    for (std::size_t v = 0; v < sums.size(); ++v)
      if (wedges[v] > 1) sums[v] = unit_or_zero<double, 3>(sums[v], wedges[v]);
    return sums;
  }

private:
  static constexpr Index null = Level_connectivity::null;
  static Index opposite(Index h) { return Level_connectivity::opposite(h); }

  void connect(Index number_of_edges)
  {
    std::vector<Index> before(2 * std::size_t(number_of_edges), null);
    for (Index v = 0; v < level_.number_of_vertices(); ++v) level_.set_isolated(v);
    for (Index t = 0; t < triangles_.size(); ++t) {
      const auto& triangle = triangles_[t];
      for (std::size_t i = 0; i < 3; ++i) {
        const Index h = triangle.halfedges[i], next = triangle.halfedges[(i + 1) % 3];
        const Index target = all_.slot(triangle.slot_ids[(i + 1) % 3]).vertex;
        level_.set_next(h, next);
        before[next] = h;
        level_.set_face(h, t);
        level_.set_target(h, target);
        level_.set_halfedge_of_vertex(target, h);
      }
      level_.set_halfedge_of_face(t, triangle.halfedges[0]);
    }
    for (Index h = 0; h < before.size(); ++h)
      if (before[h] == null) connect_border(h, before);
  }

  // the border goes on where the fan of triangles at its target ends
  void connect_border(Index h, const std::vector<Index>& before)
  {
    Index last = before[opposite(h)];
    const Index target = level_.target(last);
    while (before[opposite(last)] != null) last = before[opposite(last)];
    level_.set_border(h);
    level_.set_target(h, target);
    level_.set_next(h, opposite(last));
    level_.set_halfedge_of_vertex(target, h);
  }

  void find_isolated(Level_size size)
  {
    for (Index v = 0; v < level_.number_of_vertices(); ++v)
      if (level_.is_isolated(v)) ++size.isolated_vertices;
    level_.set_size(size);
  }

  const Split_edges<FT>& all_;
  const std::vector<Tessellation_triangle>& triangles_;
  Level_connectivity level_;
};

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
  void set(Attribute_table&& result) const
  {
    if (table_ != nullptr) *table_ = std::move(result);
  }
  std::size_t dimension_of_corners() const
  {
    std::size_t n = 0;
    if (table_ != nullptr)
      for (const Attribute_array& array : table_->corners) n += array.dimension;
    return n + (has_labels() ? dimension_of_places : 0);
  }

  Tessellation_data read(const Level_connectivity& level) const
  {
    Tessellation_data result;
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
    if (has_labels()) add_places(level, result);
    for (std::size_t i = 0; i < result.vertices.size(); ++i) {
      double& largest = result.largest[i % result.of_vertices];
      largest = (std::max)(largest, std::abs(result.vertices[i]));
    }
    return result;
  }

  // The arrays of the result; half-edges have the numbers that the level of the triangles gives them. `data` comes from
  // read(), and `vertices` has the control vertices that the first vertices of the result are.
  template <class Refinement, class FT>
  Attribute_table of_result(const Refinement& refinement, const Leaf_triangles<FT>& triangles,
                            const Tessellation_data& data, std::vector<Index> vertices) const
  {
    if (has_labels()) set_nearest(refinement, triangles, data, vertices);
    Attribute_table result;
    result.has_face_parents = table_->has_face_parents;
    if (result.has_face_parents)
      for (const Tessellation_triangle& t : triangles.triangles())
        result.face_parents.push_back(t.origin);
    std::size_t first = 0;
    for (const Attribute_array& array : table_->vertices) {
      result.vertices.push_back(shape_of(array));
      std::vector<double>& values = result.vertices.back().values;
      if (is_label(array)) {
        for (const Index v : vertices)
          for (std::size_t k = 0; k < array.dimension; ++k)
            values.push_back(array.values[v * array.dimension + k]);
        continue;
      }
      for (Index v = 0; v < refinement.all().number_of_vertices(); ++v)
        for (std::size_t k = 0; k < array.dimension; ++k)
          values.push_back(refinement.attributes().value(v, first + k));
      if (array.rule_of_vertices == Attribute_rule::direction) make_units(array.dimension, values);
      first += array.dimension;
    }
    first = 0;
    const std::size_t all = dimension_of_corners();
    for (const Attribute_array& array : table_->corners) {
      const std::size_t n = array.dimension;
      result.corners.push_back(shape_of(array));
      result.corners.back().values.resize(2 * n * triangles.number_of_edges());
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
  // Behind the attributes of corners, if there are labels: coordinates in a regular polygon, in which the place of a vertex tells the
  // nearest corner.
  static constexpr std::size_t dimension_of_places = 2;

  static bool is_label(const Attribute_array& array)
  {
    return array.rule_of_vertices == Attribute_rule::nearest;
  }
  bool has_labels() const
  {
    return table_ != nullptr &&
           std::any_of(table_->vertices.begin(), table_->vertices.end(), is_label);
  }
  static Attribute_array shape_of(const Attribute_array& array)
  {
    return {array.dimension, {}, array.rule, array.rule_of_vertices};
  }
  static std::array<double, 2> place(std::size_t corner, std::size_t degree)
  {
    const double angle = 2 * CGAL_PI * double(corner) / double(degree);
    return {std::cos(angle), std::sin(angle)};
  }

  static void add_places(const Level_connectivity& level, Tessellation_data& data)
  {
    const std::size_t old = data.of_corners, all = old + dimension_of_places;
    std::vector<double> corners(all * level.number_of_halfedges());
    for (std::size_t h = 0; h < level.number_of_halfedges() && old > 0; ++h)
      std::copy_n(data.corners.begin() + std::ptrdiff_t(h * old), old,
                  corners.begin() + std::ptrdiff_t(h * all));
    data.first_corner.assign(1, 0);
    for (Index f = 0; f < level.number_of_faces(); ++f) {
      const Index first = level.halfedge_of_face(f);
      const std::size_t degree = level.degree(first);
      std::size_t corner = 0;
      for_each_halfedge_of_face(level, f, [&](Index h) {
        const std::array<double, 2> p = place(corner++, degree);
        std::copy(p.begin(), p.end(), corners.begin() + std::ptrdiff_t(h * all + old));
        data.corner_vertices.push_back(level.target(h));
      });
      data.first_corner.push_back(static_cast<Index>(data.corner_vertices.size()));
    }
    data.of_corners = all;
    data.corners = std::move(corners);
  }

  // of each vertex of the result, where there are triangles
  template <class Refinement, class FT>
  void set_nearest(const Refinement& refinement, const Leaf_triangles<FT>& triangles,
                   const Tessellation_data& data, std::vector<Index>& vertices) const
  {
    vertices.resize(refinement.all().number_of_vertices(), 0);
    const std::size_t all = dimension_of_corners();
    const double* p = triangles.corner_values().data() + all - dimension_of_places;
    for (const Tessellation_triangle& t : triangles.triangles())
      for (const Index slot : t.slot_ids) {
        vertices[refinement.all().slot(slot).vertex] = nearest_corner(data, t.origin, p);
        p += all;
      }
  }

  // of several the first one
  static Index nearest_corner(const Tessellation_data& data, Index face, const double* p)
  {
    constexpr double rounding = 1e-9;
    const Index first = data.first_corner[face];
    const std::size_t degree = data.first_corner[face + 1] - first;
    double largest = -1;
    Index result = 0;
    for (std::size_t i = 0; i < degree; ++i) {
      const std::array<double, 2> q = place(i, degree);
      const double product = p[0] * q[0] + p[1] * q[1];
      const Index v = data.corner_vertices[first + i];
      if (product < largest - rounding || (product < largest + rounding && v > result)) continue;
      largest = (std::max)(largest, product);
      result = v;
    }
    return result;
  }

  // numbers of an element are next to each other
  static std::vector<double> joined(const std::vector<Attribute_array>& arrays,
                                    std::size_t elements, const char* kind, std::size_t& dimension)
  {
    dimension = 0;
    for (const Attribute_array& array : arrays) {
      check_array(array, elements, kind);
      if (!is_label(array)) dimension += array.dimension;
    }
    std::vector<double> values(dimension * elements);
    std::size_t first = 0;
    for (const Attribute_array& array : arrays) {
      if (is_label(array)) continue;
      for (std::size_t i = 0; i < elements; ++i)
        std::copy_n(array.values.begin() + std::ptrdiff_t(i * array.dimension), array.dimension,
                    values.begin() + std::ptrdiff_t(i * dimension + first));
      first += array.dimension;
    }
    return values;
  }

  Attribute_table* table_;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_TESSELLATION_TESSELLATION_OUTPUT_H

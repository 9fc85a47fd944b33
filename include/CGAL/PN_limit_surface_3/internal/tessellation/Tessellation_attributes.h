// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_TESSELLATION_TESSELLATION_ATTRIBUTES_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_TESSELLATION_TESSELLATION_ATTRIBUTES_H

#include <CGAL/PN_limit_surface_3/internal/limit/Creased_limits.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Limit_evaluation.h>
#include <CGAL/PN_limit_surface_3/internal/tessellation/Adaptive_level.h>
#include <CGAL/PN_limit_surface_3/internal/tessellation/Leaf_triangles.h>
#include <CGAL/PN_subdivision_3/attributes/Attribute_traits.h>
#include <CGAL/PN_subdivision_3/internal/attributes/read_attributes.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Level_refiner.h>
#include <CGAL/PN_subdivision_3/internal/rounds/Round.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// `of_vertices` numbers for each vertex of the control mesh and `of_corners` for each half-edge
struct Tessellation_data
{
  std::size_t of_vertices = 0, of_corners = 0;
  std::vector<double> vertices, corners;
  std::vector<double> largest{}; // of each number of vertices, in the whole control mesh
  // the corners of the control faces, where there are labels
  std::vector<Level_connectivity::Index> first_corner{}, corner_vertices{};
};

// What an adaptive refinement carries besides the points: attributes of vertices as points without normals, three numbers
// a plane, which go to their limits; those of corners linear inside the faces of the control mesh.
template <class Scheme, class FT, class Level_creases>
class Tessellation_attributes
{
public:
  using Index = Level_connectivity::Index;
  using Value = typename Average_of_scheme<Scheme, FT>::Value;
  using Level = Adaptive_level<Value, Level_creases>;
  using Results = std::vector<Limit_result<Average_of_scheme<Scheme, FT>>>;

  // With the tolerance of the points.
  Tessellation_attributes(const Scheme& scheme, const Limit_demand& demand,
                          const For_chunks& for_chunks)
    : scheme_(scheme)
    , for_chunks_(for_chunks)
    , demand_{demand.tolerance, 0, demand.max_depth}
    , evaluation_(scheme, demand_, for_chunks)
  {}

  // Columns are scaled by powers of 2 to the size of the points, whose tolerance they then have.
  void read(const Tessellation_data& attributes, Level& level)
  {
    const auto& connectivity = level.level.level;
    const std::size_t n = attributes.of_vertices, m = attributes.of_corners;
    const double size = demand_.tolerance * 0x1p30;
    std::vector<Index> vertices = first_indices(connectivity.number_of_vertices());
    for (const Index v : vertices_of_extra_slots(level.creases, connectivity.number_of_vertices()))
      vertices.push_back(v);
    level.planes.resize((n + 2) / 3);
    limits_.resize(level.planes.size());
    for (auto& plane : level.planes) plane = std::vector<Value>(vertices.size());
    for (std::size_t i = 0; i < n; ++i) {
      const double largest = attributes.largest[i];
      exponents_.push_back(largest > 0 && std::isfinite(largest) && size > 0
                             ? std::ilogb(size) - std::ilogb(largest)
                             : 0);
      for (std::size_t s = 0; s < vertices.size(); ++s)
        point_of(level.planes[i / 3][s])[i % 3] =
          FT(std::ldexp(attributes.vertices[vertices[s] * n + i], exponents_[i]));
    }
    if (m == 0) return;
    level.corners.resize(connectivity.number_of_faces());
    for (Index f = 0; f < level.corners.size(); ++f)
      for_each_halfedge_of_face(connectivity, f, [&](Index h) {
        const auto from = attributes.corners.begin() + std::ptrdiff_t(h * m);
        level.corners[f].insert(level.corners[f].end(), from, from + std::ptrdiff_t(m));
      });
    of_corners_ = m;
  }

  // the limits of each plane after so many rounds, of some vertices or all
  std::vector<Results> limits(const Level& level, unsigned rounds, const std::vector<Index>* some)
  {
    std::vector<Results> of_planes;
    for (const auto& plane : level.planes) {
      Valued_level<Value> values{level.level.level, plane};
      Level_creases creases = without_tangents(level.creases);
      of_planes.push_back(evaluation_(values, creases, rounds + 1, some));
    }
    return of_planes;
  }
  void set(Index vertex, const std::vector<Results>& of_planes, Index slot)
  {
    for (std::size_t p = 0; p < of_planes.size(); ++p) {
      if (limits_[p].size() <= vertex) limits_[p].resize(vertex + 1);
      limits_[p][vertex] = point_of(of_planes[p][slot].value);
    }
  }
  // refines one round
  void refine(const Level& level, unsigned rounds, Level& next) const
  {
    for (const auto& plane : level.planes) {
      Refiner refiner(scheme_, Level_connectivity(level.level.level),
                      without_tangents(level.creases), {plane.begin(), plane.end()}, for_chunks_,
                      rounds);
      refiner.refine();
      next.planes.emplace_back(refiner.values().begin(), refiner.values().end());
    }
  }

  // Corners that are new are in the middle, of an edge or of the face.
  template <class Host>
  void split_corners(const Level& level, const Host& host, Level& next) const
  {
    const Level_connectivity &old = level.level.level, &refined = next.level.level;
    next.corners.resize(next.faces.size());
    for (Index f = 0; f < next.faces.size(); ++f) {
      const Index parent = host.parent_of_face(f).index;
      if (!level.faces[parent].is_split) continue;
      const std::vector<double>& values = level.corners[parent];
      for_each_halfedge_of_face(refined, f, [&](Index h) {
        append_middle(old, parent, values, host.parent_of_vertex(refined.target(h)),
                      next.corners[f]);
      });
    }
  }

  // vertices that are not used go
  void keep_vertices(const std::vector<bool>& used)
  {
    for (auto& limits : limits_) {
      std::size_t kept = 0;
      for (std::size_t v = 0; v < used.size(); ++v)
        if (used[v]) limits[kept++] = limits[v];
      limits.resize(kept);
    }
  }
  // a number of a vertex of the result
  double value(Index vertex, std::size_t i) const
  {
    return std::ldexp(CGAL::to_double(limits_[i / 3][vertex][i % 3]), -exponents_[i]);
  }

private:
  using Refiner = Level_refiner<Scheme, Average_of_scheme<Scheme, FT>, Level_creases>;

  // The curves of creases are those of the points alone, without normals.
  static Level_creases without_tangents(Level_creases creases)
  {
    if constexpr (are_creases_v<Level_creases>) {
      for (auto& e : creases.edges) e.tangent_from = {};
      creases.without_fractions.reset();
    }
    return creases;
  }

  void append_middle(const Level_connectivity& old, Index parent, const std::vector<double>& values,
                     const Element_parent& origin, std::vector<double>& to) const
  {
    using Kind = Element_parent::Kind;
    std::vector<std::size_t> corners;
    std::size_t i = 0, n = values.size() / of_corners_;
    for_each_halfedge_of_face(old, parent, [&](Index h) {
      const bool is_end = origin.kind == Kind::edge && Level_connectivity::edge(h) == origin.index;
      if (origin.kind == Kind::face ||
          (origin.kind == Kind::vertex && old.target(h) == origin.index))
        corners.push_back(i);
      if (is_end) corners.insert(corners.end(), {i, (i + n - 1) % n});
      ++i;
    });
    for (std::size_t k = 0; k < of_corners_; ++k) {
      double sum = 0;
      for (const std::size_t c : corners) sum += values[c * of_corners_ + k];
      to.push_back(sum / double(corners.size()));
    }
  }

  const Scheme& scheme_;
  For_chunks for_chunks_;
  const Limit_demand demand_;
  Limits_of_level<Scheme, FT, Level_creases> evaluation_;
  std::vector<std::vector<Coordinates<FT, 3>>> limits_; // of each plane
  std::vector<int> exponents_;                          // of the scales of attributes
  std::size_t of_corners_ = 0;
};

// What stands for it in calls that name no attributes.
struct No_tessellation_attributes
{
  No_tessellation_attributes() = default;
  template <class Scheme>
  No_tessellation_attributes(const Scheme&, const Limit_demand&, const For_chunks&)
  {}
};
template <bool carries_attributes, class Attributes>
using Carried = std::conditional_t<carries_attributes, Attributes, No_tessellation_attributes>;

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

  // sets the nearest control vertex of each vertex of the result, where there are triangles
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

  // the nearest corner; of several, the first one
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

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_TESSELLATION_TESSELLATION_ATTRIBUTES_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_RING_PLANES_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_RING_PLANES_H

#include <CGAL/PN_limit_surface_3/internal/limit/Ring_geometry.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Ring_lanes.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Ring_rules.h>
#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/normals/Fan.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/numbers/Unit_normal_traits.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// Whether the sum of the area vectors of triangles is on the other side than a normal. for_each(f) calls f(a, b)
// with two sides of each.
template <class For_each_triangle>
bool is_against_area(const Coordinates<double, 3>& normal, const For_each_triangle& for_each)
{
  using Vector = Coordinates<double, 3>;
  constexpr double greatest = 0x1p300; // whose products are in range, as those of its reciprocal
  for (int exponent = 0;;) {
    double height = 0, size = 0;
    for_each([&](Vector a, Vector b) {
      if (exponent != 0)
        for (Vector* v : {&a, &b})
          for (double& x : *v) x = std::ldexp(x, -exponent);
      size = (std::max)({size, largest_coordinate(a), largest_coordinate(b)});
      height += dot(cross(a, b), normal);
    });
    const bool is_in_range = size >= 1 / greatest && size <= greatest;
    if (is_in_range || exponent != 0 || !(size > 0 && std::isfinite(size))) return height < 0;
    exponent = std::ilogb(size);
  }
}

// Whether a normal at a vertex is on the other side than those of the faces around, which have the corners point(v).
template <class Point_of>
bool is_against_faces(const Level_connectivity& level, Level_connectivity::Index v,
                      const Point_of& point, const Coordinates<double, 3>& normal)
{
  using Index = Level_connectivity::Index;
  const Coordinates<double, 3> center = point(v);
  const auto away = [&](Index w) { return difference(point(w), center); };
  return is_against_area(normal, [&](const auto& add) {
    for_each_halfedge_to(level, v, [&](Index h) {
      if (!level.is_border(h)) add(away(level.target(level.next(h))), away(level.source(h)));
    });
  });
}

// The same of a normal at a face.
template <class Point_of>
bool is_against_face(const Level_connectivity& level, Level_connectivity::Index first,
                     const Point_of& point, const Coordinates<double, 3>& normal)
{
  using Index = Level_connectivity::Index;
  const Coordinates<double, 3> corner = point(level.target(first));
  const auto away = [&](Index h) { return difference(point(level.target(h)), corner); };
  return is_against_area(normal, [&](const auto& add) {
    for (Index h = level.next(first); level.next(h) != first; h = level.next(h))
      add(away(h), away(level.next(h)));
  });
}

// The frame of a surface normal is that of the control normal, which may be on the wrong side: is_against(i, normal).
template <class Results, class Is_against>
void orient_normals(Results& results, const For_chunks& for_chunks, const Is_against& is_against)
{
  using Index = Level_connectivity::Index;
  for_chunks(static_cast<Index>(results.size()), [&](Index begin, Index end) {
    for (Index i = begin; i < end; ++i) {
      auto& result = results[i];
      if (result.has_surface_normal && is_against(i, result.surface_normal))
        result.surface_normal = opposite_vector(result.surface_normal);
    }
  });
}
// At vertices, by the faces around them: between the limits of all, or, where the neighbors of some have none, between the points
// of the level.
template <class Level, class Results>
void orient_normals(const Level& level, Results& results, const For_chunks& for_chunks,
                    bool are_all)
{
  using Index = Level_connectivity::Index;
  const auto point = [&](Index v) {
    return to_double_3(point_of(are_all ? results[v].value : level.values[v]));
  };
  orient_normals(results, for_chunks, [&](Index v, const auto& normal) {
    return !level.level.is_isolated(v) && is_against_faces(level.level, v, point, normal);
  });
}

// The planes tangent to rings of one class at their limits. The value of place p of ring c is
// rings[p * copies + c].
template <class Scheme, class FT>
class Ring_planes
{
public:
  using Rules = Ring_rules<Scheme, FT>;
  using Value = typename Rules::Value;
  using Vector = Coordinates<double, 3>;

  // tangent to a ring at its limit, if there is one
  struct Plane
  {
    bool exists = false;
    Vector normal{};
    double rounding = 0; // of the normal: small rings have that of large coordinates
    // the error of the normal as far as the ring alone tells it
    double error = std::numeric_limits<double>::infinity();
    bool is_against_faces = false; // the faces around the vertex at place 0
  };

  explicit Ring_planes(const Rules& ring_rules)
    : rules_(ring_rules)
    , planes_(ring_rules.copies())
  {}

  // `ring()` becomes ring c about its limit, divided by a power of two if squares of its size would be out of
  // range. The limit is taken away before coordinates are rounded to double.
  Ring_geometry geometry(const Value* rings, const Value* limits, std::size_t c)
  {
    constexpr int harmless = 200;
    double size = 0, largest = 0;
    const Coordinates<FT, 3>& center = point_of(limits[c]);
    ring_.resize(rules_.size());
    for (std::size_t p = 0; p < rules_.size(); ++p) {
      Value v(rings[p * rules_.copies() + c]);
      for (const FT& x : point_of(v)) largest = (std::max)(largest, std::abs(close_double(x)));
      add_multiple<FT, 3>(point_of(v), FT(-1), center);
      ring_[p] = to_double_value(v);
      for (const double x : ring_[p].point) size = (std::max)(size, std::abs(x));
    }
    exponent_ = size > 0 && std::isfinite(size) ? std::ilogb(size) : 0;
    if (std::abs(exponent_) <= harmless) exponent_ = 0;
    if (exponent_ != 0)
      for (Point_normal<double, 3>& v : ring_) v.point = divided(v.point);
    rounding_ = rounding_of(std::ldexp(largest, -exponent_));
    Point_normal<double, 3> limit = to_double_value(limits[c]);
    limit.point = {};
    return Ring_geometry(ring_, limit, rules_.tangents(), rules_.roundness_at(limits[c]));
  }
  const std::vector<Point_normal<double, 3>>& ring() const { return ring_; }
  // the exponent of the power of two by which `ring()` is divided
  int exponent() const { return exponent_; }
  Vector divided(Vector v) const
  {
    for (double& x : v) x = std::ldexp(x, -exponent_);
    return v;
  }

  // planes of the first rings, but for rings that are done
  template <class Is_done>
  void find(const Value* rings, const Value* limits, std::size_t number, const Is_done& is_done)
  {
    constexpr std::size_t lanes = Ring_lanes::lanes;
    for (std::size_t c = 0; c < number; c += lanes) {
      const std::size_t end = (std::min)(number, c + lanes);
      std::size_t first = c;
      while (first != end && is_done(first)) ++first;
      if (first == end) continue;
      if constexpr (has_lanes) find_side_by_side(rings, limits, c, end);
      for (std::size_t i = first; i < end; ++i)
        if (!is_done(i) && !(has_lanes && lanes_.is_found[i - c]))
          planes_[i] = plane(rings, limits, i);
    }
  }
  const Plane& operator[](std::size_t c) const { return planes_[c]; }

private:
  void find_side_by_side(const Value* rings, const Value* limits, std::size_t first,
                         std::size_t end)
  {
    lanes_.ring.resize(rules_.size());
    for (std::size_t l = 0; l < Ring_lanes::lanes; ++l) {
      const std::size_t c = (std::min)(first + l, end - 1);
      for (std::size_t p = 0; p < rules_.size(); ++p)
        set_place(lanes_.ring[p], l, rings[p * rules_.copies() + c]);
      set_place(lanes_.limit, l, limits[c]);
      lanes_.roundness[l] = rules_.roundness_at(limits[c]);
    }
    lanes_.find(rules_.tangents(), fan());
    for (std::size_t l = 0; first + l < end; ++l)
      if (lanes_.is_found[l])
        planes_[first + l] = {true,
                              {lanes_.normal[0][l], lanes_.normal[1][l], lanes_.normal[2][l]},
                              rounding_of_normal(rounding_of(lanes_.largest[l]), lanes_.size[l]),
                              lanes_.error[l],
                              lanes_.side[l] < 0};
  }
  static void set_place(Ring_lanes::Place& place, std::size_t lane, const Value& v)
  {
    for (std::size_t i = 0; i < 3; ++i) {
      place.point[i][lane] = v.point[i];
      place.normal[i][lane] = v.normal[i];
    }
  }
  Plane plane(const Value* rings, const Value* limits, std::size_t c)
  {
    const Ring_geometry g = geometry(rings, limits, c);
    if (!g.is_regular()) return {};
    Plane result{true, g.normal(), is_pn_v<Scheme> ? rounding_of_normal(rounding_, g.size()) : 0.};
    result.error = g.error();
    result.is_against_faces = is_against_area(result.normal, [&](const auto& add) {
      const Vector& v = ring_[0].point;
      const auto [neighbors, is_closed] = fan();
      for (std::size_t i = 1; i < neighbors; ++i)
        add(difference(ring_[1 + i].point, v), difference(ring_[i].point, v));
      if (is_closed && neighbors != 0)
        add(difference(ring_[1].point, v), difference(ring_[neighbors].point, v));
    });
    return result;
  }

  Ring_lanes::Fan fan() const { return {rules_.number_of_neighbors(), !rules_.is_at_border()}; }

  static constexpr bool has_lanes = is_pn_v<Scheme> && std::is_same_v<FT, double>;

  static Point_normal<double, 3> to_double_value(const Value& v)
  {
    if constexpr (is_pn_v<Scheme>)
      return {to_double_3(v.point), to_double_3(v.normal)};
    else
      return {to_double_3(v), {}};
  }

  static double rounding_of(double largest)
  {
    return largest * close_double(machine_epsilon<FT>());
  }
  // how far the rounding of the coordinates may turn a normal in a ring of some size
  static double rounding_of_normal(double rounding, double size)
  {
    return 4 * (rounding / size + std::numeric_limits<double>::epsilon());
  }

  const Rules& rules_;
  std::vector<Plane> planes_;
  std::vector<Point_normal<double, 3>> ring_;
  int exponent_ = 0;
  double rounding_ = 0; // of the coordinates that `ring_` was taken from, divided like these
  Ring_lanes lanes_;
};

// The valences of some vertices, at most `most_at_once`, isolated ones too. They are found side by side: each step round a
// vertex waits for memory, and the steps round several do so at the same time.
constexpr std::size_t most_at_once = 32;
inline void find_valences(const Level_connectivity& level, const Level_connectivity::Index* begin,
                          std::size_t number, Level_connectivity::Index* valences)
{
  using Index = Level_connectivity::Index;
  Index at[most_at_once] = {};
  std::size_t left = 0;
  std::size_t unfinished[most_at_once]; // rings that are not yet gone round
  for (std::size_t i = 0; i < number; ++i) {
    valences[i] = 0;
    if (level.is_isolated(begin[i])) continue;
    at[i] = level.halfedge_of_vertex(begin[i]);
    unfinished[left++] = i;
  }
  while (left != 0) {
    std::size_t still = 0;
    for (std::size_t k = 0; k < left; ++k) {
      const std::size_t i = unfinished[k];
      at[i] = level.next_around_target(at[i]);
      ++valences[i];
      if (at[i] != level.halfedge_of_vertex(begin[i])) unfinished[still++] = i;
    }
    left = still;
  }
}

// Rings of a level before they are refined. Values are far from each other in a level: they are asked for when a ring
// is found, and used some rings later, when they have come from memory.
template <class Value, class Vertex>
class Gathered_rings
{
public:
  using Index = Level_connectivity::Index;

  explicit Gathered_rings(const std::vector<Value>& values)
    : values_(values)
  {}

  bool is_full() const { return vertices_.size() == most_at_once; }

  // append(ring) appends the ring of the vertex
  template <class Append>
  void add(const Vertex& vertex, const Append& append)
  {
    const std::size_t begin = ring_.size();
    append(ring_);
    for (std::size_t i = begin; i < ring_.size(); ++i) prefetch(values_[ring_[i]]);
    vertices_.emplace_back(vertex, begin);
  }

  // calls f(vertex, value_of), where value_of(place) is a value of its ring, and is empty again
  template <class Function>
  void take(const Function& f)
  {
    for (const auto& entry : vertices_) {
      const Index* const ring = ring_.data() + entry.second;
      f(entry.first, [&](std::size_t place) -> const Value& { return values_[ring[place]]; });
    }
    vertices_.clear();
    ring_.clear();
  }

private:
  static void prefetch([[maybe_unused]] const Value& value)
  {
#if defined(__GNUC__) // and clang
    __builtin_prefetch(&value);
    __builtin_prefetch(reinterpret_cast<const char*>(&value + 1) - 1);
#endif
  }

  const std::vector<Value>& values_;
  std::vector<Index> ring_;
  std::vector<std::pair<Vertex, std::size_t>> vertices_; // and where their rings begin
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_RING_PLANES_H

// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_MESH_SUBDIVISION_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_MESH_SUBDIVISION_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/meshes/Control_geometry.h>
#include <CGAL/PN_subdivision_3/internal/meshes/Surface_mesh_access.h>
#include <CGAL/PN_subdivision_3/internal/meshes/check_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/normals/angle_weighted_normals.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Round.h>
#include <CGAL/PN_subdivision_3/internal/refinement/for_chunks.h>
#include <CGAL/PN_subdivision_3/schemes/scheme_adaptors.h>

#include <boost/container/vector.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// stands for a normal map that the user has not given
struct No_normal_map
{};

// reads the connectivity of a mesh and checks it
template <class Access>
Level_connectivity checked_level(const Access& access)
{
  const Level_size size = access.size();
  if (size.halfedges() >= Level_connectivity::null || size.vertices >= Level_connectivity::null)
    throw std::length_error("PN_subdivision_3: the mesh has " + std::to_string(size.halfedges()) +
                            " half-edges, more than can be numbered");
  Level_connectivity level(size);
  access.read(level);
  Connectivity_check<Access>(level, access)();
  return level;
}

// the points of a mesh, checked
template <class FT, class Access, class Point_map>
Coordinates<FT, 3> checked_point(const Access& access, Point_map points,
                                 Level_connectivity::Index v)
{
  const Coordinates<FT, 3> p = coordinates_3<FT>(get(points, access.vertex(v)));
  check_finite<FT, 3>(p, "point", [&] { return access.vertex_name(v); });
  return p;
}

// Subdivision of a mesh: read, refine flat levels, write the last one. The mesh and its maps are
// untouched until everything that a user's data can make fail has been checked; what fails
// afterwards (an allocation, a map of the user's) is taken back.
template <class Concurrency_tag, class Access, class Scheme, class FT, class Point_map,
          class Normal_map>
class Mesh_subdivision
{
  static constexpr bool is_pn = !Is_linear<Scheme>::value;
  static constexpr bool has_normal_map = is_pn && !std::is_same_v<Normal_map, No_normal_map>;

  // the maps are those of a Surface_mesh
  static constexpr bool has_own_maps =
    has_concurrent_put_v<Point_map> && (!has_normal_map || has_concurrent_put_v<Normal_map>);

  using Index = Level_connectivity::Index;
  using Average = std::conditional_t<is_pn, PN_average<FT, 3>, Linear_average<FT, 3>>;
  using Value = typename Average::Value;
  using One_round = Round<Scheme, Average>;
  using Values = boost::container::vector<Value>;
  using Stored_values = boost::container::vector<typename One_round::Stored_value>;
  using Point = typename boost::property_traits<Point_map>::value_type;

public:
  Mesh_subdivision(Access& access, const Scheme& scheme, Point_map points, Normal_map normals)
    : access_(access)
    , scheme_(scheme)
    , points_(points)
    , normals_(normals)
  {}

  template <class Visitor>
  void operator()(unsigned iterations, Visitor& visitor)
  {
    level_ = checked_level(access_);
    check_scheme(scheme_, level_, access_);
    if (level_.size().faces == 0) iterations = 1; // all rounds are alike
    const Level_size size = checked_refined_size(iterations);
    read_values();
    try {
      // the mesh grows while the levels before the last one are made
      run_together<Concurrency_tag>([&] { access_.grow(size); },
                                    [&] { refine_up_to_last(iterations, visitor); });
      write(iterations, visitor);
    } catch (...) {
      if (old_values_put_) put_old_values();
      access_.shrink();
      throw;
    }
    connect();
    if constexpr (!Scheme::Host::keeps_vertices) access_.trim(size, has_own_maps);
  }

private:
  // \name Reading
  // the size of the last level
  Level_size checked_refined_size(unsigned iterations) const
  {
    Level_size size = level_.size();
    for (unsigned k = 1; k <= iterations; ++k) {
      size = Scheme::Host::refined_size(size, k);
      const std::uint64_t limit = Access::index_limit();
      if (size.halfedges() < limit && size.vertices < limit && size.faces < limit) continue;
      throw std::length_error("PN_subdivision_3: round " + std::to_string(k) + " would need " +
                              std::to_string(size.vertices) + " vertices, " +
                              std::to_string(size.halfedges()) + " half-edges and " +
                              std::to_string(size.faces) + " faces, more than the " +
                              std::to_string(limit - 1) +
                              " that the index type of the mesh can number: ask for at most " +
                              std::to_string(k - 1) + " rounds");
    }
    return size;
  }

  void read_values()
  {
    const Index n = level_.number_of_vertices();
    Values values(n, boost::container::default_init);
    old_points_.reserve(n);
    for (Index v = 0; v < n; ++v) {
      point_of(values[v]) = checked_point<FT>(access_, points_, v);
      if (is_near_overflow<FT, 3>(point_of(values[v]))) is_near_overflow_ = true;
      old_points_.push_back(get(points_, access_.vertex(v)));
    }
    if constexpr (has_normal_map)
      read_normals(values);
    else if constexpr (is_pn)
      angle_weighted_normals<FT>(
        level_, [&](Index v) -> const Coordinates<FT, 3>& { return values[v].point; },
        [&](Index v, const Coordinates<FT, 3>& m) { values[v].normal = m; });
    values_ = Stored_values(values.begin(), values.end());
  }

  void read_normals(Values& values)
  {
    const Index n = level_.number_of_vertices();
    old_normals_.reserve(n);
    for (Index v = 0; v < n; ++v) {
      old_normals_.push_back(get(normals_, access_.vertex(v)));
      values[v].normal = coordinates_3<FT>(old_normals_.back());
      const auto name = [&] { return access_.vertex_name(v); };
      check_finite<FT, 3>(values[v].normal, "normal", name);
      normalize_control_normal<FT, 3>(values[v].normal, name);
    }
  }

  static Coordinates<FT, 3>& point_of(Coordinates<FT, 3>& value) { return value; }
  static Coordinates<FT, 3>& point_of(Point_normal<FT, 3>& value) { return value.point; }
  static const Coordinates<FT, 3>& point_of(const Coordinates<FT, 3>& value) { return value; }
  static const Coordinates<FT, 3>& point_of(const Point_normal<FT, 3>& value)
  {
    return value.point;
  }

  // \name Refining
  template <class Visitor>
  void refine_up_to_last(unsigned iterations, Visitor& visitor)
  {
    for (unsigned k = 1; k < iterations; ++k) {
      refine(k);
      visitor.round_done(k, static_cast<std::size_t>(level_.size().faces));
    }
  }

  void refine(unsigned k)
  {
    const One_round round(scheme_, level_, k);
    Level_connectivity child(round.refined_size());
    child.set_uniform_degree(Scheme::Host::refined_degree);
    round.host().connect(child, for_chunks_);
    Stored_values refined(round.refined_size().vertices, boost::container::default_init);
    evaluate(round, 0, child.number_of_vertices(), refined);
    level_ = std::move(child);
    values_ = std::move(refined);
  }

  template <class Refined>
  void evaluate(const One_round& round, Index begin, Index end, Refined& refined) const
  {
    for_chunks_(end - begin, [&](Index first, Index last) {
      round.evaluate(begin + first, begin + last, values_.data(),
                     [&](Index v, const Value* values, Index n) {
                       for (Index i = 0; i < n; ++i) refined[v - begin + i] = values[i];
                     });
    });
  }

  // \name Writing
  template <class Visitor>
  void write(unsigned k, Visitor& visitor)
  {
    last_round_.emplace(scheme_, level_, k);
    const Level_size& size = last_round_->refined_size();
    const auto new_vertices = static_cast<Index>(size.vertices);
    const Index old_vertices = (std::min)(new_vertices, static_cast<Index>(old_points_.size()));
    put_range(*last_round_, old_vertices, new_vertices);
    old_values_put_ = true;
    put_range(*last_round_, 0, old_vertices);
    visitor.round_done(k, static_cast<std::size_t>(size.faces));
  }

  void put_range(const One_round& round, Index begin, Index end)
  {
    if constexpr (has_own_maps || !is_parallel_v<Concurrency_tag>)
      for_chunks_(end - begin, [&](Index first, Index last) {
        round.evaluate(begin + first, begin + last, values_.data(),
                       [&](Index v, const Value* values, Index n) { put_values(v, values, n); });
      });
    else {
      Values refined(end - begin, boost::container::default_init);
      evaluate(round, begin, end, refined);
      put_values(begin, refined.data(), end - begin);
    }
  }

  void put_values(Index first, const Value* values, Index n)
  {
    for (Index i = 0; i < n; ++i) {
      const auto v = access_.vertex(first + i);
      const Coordinates<FT, 3>& p = point_of(values[i]);
      if (is_near_overflow_)
        check_in_range<FT, 3>(
          p, [&] { return "the point of the new vertex " + std::to_string(first + i); });
      put(points_, v, Point(p[0], p[1], p[2]));
      if constexpr (has_normal_map) {
        using Normal = typename boost::property_traits<Normal_map>::value_type;
        const Coordinates<FT, 3>& m = values[i].normal;
        put(normals_, v, Normal(m[0], m[1], m[2]));
      }
    }
  }

  // a map that throws here too keeps what it has
  void put_old_values() noexcept
  {
    for (Index v = 0; v < old_points_.size(); ++v) {
      try {
        put(points_, access_.vertex(v), old_points_[v]);
      } catch (...) {
      }
      if constexpr (has_normal_map) try {
          put(normals_, access_.vertex(v), old_normals_[v]);
        } catch (...) {
        }
    }
  }

  // Nothing may fail here. Threads may; then one alone repeats what they have begun.
  void connect()
  {
    try {
      last_round_->host().connect(access_, for_chunks_);
    } catch (...) {
      last_round_->host().connect(access_, For_chunks<Sequential_tag>());
    }
    access_.finish_connectivity();
  }

  template <class Map>
  struct Value_type
  {
    using type = typename boost::property_traits<Map>::value_type;
  };

  Access& access_;
  const Scheme& scheme_;
  Point_map points_;
  Normal_map normals_;
  For_chunks<Concurrency_tag> for_chunks_;
  Level_connectivity level_;
  Stored_values values_;
  std::optional<One_round> last_round_;
  bool old_values_put_ = false;
  bool is_near_overflow_ = false;
  std::vector<Point> old_points_;
  std::vector<typename std::conditional_t<has_normal_map, Value_type<Normal_map>,
                                          Value_type<Point_map>>::type>
    old_normals_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_MESH_SUBDIVISION_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_CURVATURE_CURVATURE_ESTIMATIONS_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_CURVATURE_CURVATURE_ESTIMATIONS_H

#include <CGAL/PN_limit_surface_3/internal/curvature/Cubic_lanes.h>
#include <CGAL/PN_limit_surface_3/internal/curvature/Curvature_data.h>
#include <CGAL/PN_limit_surface_3/internal/curvature/Curvature_estimation.h>
#include <CGAL/PN_limit_surface_3/internal/curvature/Curvature_fit.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The vertices around a vertex of the interior from which a cubic is fitted there: one ring, or two if it
// has less than 12 vertices, where a ring has the vertices that share a face with the ring before. What
// faces the other way belongs to another part of the surface and is not entered.
class Near_vertices
{
public:
  using Index = Level_connectivity::Index;
  using Vector = Coordinates<double, 3>;
  static constexpr std::size_t capacity = 96;
  static constexpr std::size_t least = 12;

  struct Neighbor
  {
    Index vertex;
    double cosine; // of the angle between the normals
  };

  Near_vertices(const Curvature_data& data, const Face_neighbors& faces)
    : data_(data)
    , faces_(faces)
  {}

  // Whether they have been found: not at the border or next to it, nor where there are too few or too many.
  bool find(Index v)
  {
    ++turn_;
    collisions_ = 0;
    listed_ = 0;
    list(&v, &v + 1);
    normal_ = data_.vertices[v].normal;
    size_ = 0;
    if (!add_ring(v)) return false;
    add_listed(1);
    if (size_ < least) {
      const std::size_t ring = size_, ring_listed = listed_;
      for (std::size_t i = 0; i < ring; ++i)
        if (!add_ring(neighbors_[i].vertex)) return false;
      if (listed_ > capacity) return false;
      add_listed(ring_listed);
    }
    return size_ >= least;
  }

  std::size_t size() const { return size_; }
  const Neighbor& operator[](std::size_t i) const { return neighbors_[i]; }

private:
  // lists the ring of a vertex; false at the border, and where there are too many
  bool add_ring(Index v)
  {
    const Index *const begin = faces_.begin(v), *const end = faces_.end(v);
    const auto length = static_cast<std::size_t>(end - begin);
    if (length == 0 || listed_ + length > capacity) return false;
    const std::size_t old = listed_;
    list(begin, end);
    if (collisions_ != 0) list_again(old, begin, end);
    return true;
  }

  // Lists those that are not in the list, without branches, which would be mispredicted. The table holds the number
  // that was listed last of those with the same remainder; another one there tells of a collision.
  void list(const Index* begin, const Index* end)
  {
    for (; begin != end; ++begin) {
      const std::uint64_t mark = turn_ << 32 | *begin;
      std::uint64_t& last = last_[*begin % last_.size()];
      const std::uint64_t difference = last ^ mark;
      const auto is_new = static_cast<unsigned>(difference != 0);
      collisions_ += is_new & static_cast<unsigned>(difference >> 32 == 0);
      list_[listed_] = *begin;
      listed_ += is_new;
      last = mark;
    }
  }

  // the same by searching, from the end that the list had
  void list_again(std::size_t old, const Index* begin, const Index* end)
  {
    listed_ = old;
    for (; begin != end; ++begin)
      if (std::find(list_.begin(), list_.begin() + std::ptrdiff_t(listed_), *begin) ==
          list_.begin() + std::ptrdiff_t(listed_))
        list_[listed_++] = *begin;
  }

  // takes those from the i-th on
  void add_listed(std::size_t i)
  {
    for (; i < listed_; ++i) {
      const Vector& n = data_.vertices[list_[i]].normal;
      const double cosine = dot<double, 3>(n, normal_);
      if (cosine > 0)
        neighbors_[size_++] = {list_[i], cosine};
      else if (is_zero(n))
        neighbors_[size_++] = {list_[i], 1};
    }
  }

  const Curvature_data& data_;
  const Face_neighbors& faces_;
  Vector normal_;
  std::uint64_t turn_ = 0; // counts the vertices
  unsigned collisions_ = 0;
  std::size_t size_ = 0, listed_ = 0; // how many are taken, and how many have been looked at
  std::array<Neighbor, capacity> neighbors_;
  std::array<Index, capacity + 1> list_;
  std::array<std::uint64_t, 1024> last_{}; // turn and vertex
};

// The curvatures at many vertices. Cubics through two well-spread rings of points are fitted several at once, by
// normal equations; all else, and what these turn out not to be good for, is left to Curvature_estimation. What
// comes out at a vertex does not depend on the others.
class Curvature_estimations
{
public:
  using Index = Level_connectivity::Index;

  Curvature_estimations(const Curvature_data& data, const Face_neighbors& faces)
    : data_(data)
    , one_(data)
    , near_(data, faces)
  {}

  // of the vertices [begin, end)
  void operator()(Index begin, Index end, Principal_curvatures* results)
  {
    used_ = 0;
    for (Index v = begin; v < end; ++v) {
      result_[used_] = results + (v - begin);
      vertex_[used_] = v;
      if (!fill_lane(v)) {
        results[v - begin] = one_(v);
        continue;
      }
      if (++used_ == Cubic_lanes::lanes) solve();
    }
    if (used_ != 0) solve();
  }

private:
  using Vector = Coordinates<double, 3>;

  // The measure of condition up to which normal equations, whose errors are as its square, do: even meshes
  // have 5 in the interior.
  static constexpr double max_condition = 20;

  // whether the vertex is one for a lane
  bool fill_lane(Index v)
  {
    const Vector& normal = data_.vertices[v].normal;
    if (data_.fits_normals || data_.level.is_isolated(v) || is_zero(normal) || !near_.find(v))
      return false;
    const std::size_t l = used_;
    sizes_[l] = near_.size();
    for (std::size_t j = 0; j < near_.size(); ++j) {
      const Vector offset = data_.offset(v, near_[j].vertex);
      for (std::size_t c = 0; c < 3; ++c) lanes_.sample[c][j][l] = offset[c];
      lanes_.cosine[j][l] = near_[j].cosine;
    }
    set_frame(l, normal);
    return true;
  }

  // Duff et al., Building an orthonormal basis, revisited, JCGT 6 (2017)
  void set_frame(std::size_t l, const Vector& n)
  {
    const double sign = std::copysign(1., n[2]), a = -1 / (sign + n[2]), b = n[0] * n[1] * a;
    const Vector axes[] = {
      {1 + sign * n[0] * n[0] * a, sign * b, -sign * n[0]}, {b, sign + n[1] * n[1] * a, -n[1]}, n};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t c = 0; c < 3; ++c) lanes_.frame[i][c][l] = axes[i][c];
  }

  void solve()
  {
    lanes_.size = *std::max_element(sizes_.begin(), sizes_.begin() + std::ptrdiff_t(used_));
    for (std::size_t l = 0; l < Cubic_lanes::lanes; ++l)
      if (l < used_)
        fill_up(l);
      else
        repeat_first_lane(l);
    lanes_.solve();
    for (std::size_t l = 0; l < used_; ++l)
      *result_[l] =
        is_determined(l) ? principal_curvatures(graph(l), 1 / data_.unit) : one_(vertex_[l]);
    used_ = 0;
  }

  void fill_up(std::size_t l)
  {
    lanes_.number[l] = double(sizes_[l]);
    for (std::size_t j = sizes_[l]; j < lanes_.size; ++j)
      lanes_.sample[0][j][l] = lanes_.sample[1][j][l] = lanes_.sample[2][j][l] =
        lanes_.cosine[j][l] = 0;
  }

  void repeat_first_lane(std::size_t l)
  {
    lanes_.number[l] = lanes_.number[0];
    for (std::size_t j = 0; j < lanes_.size; ++j) {
      for (std::size_t c = 0; c < 3; ++c) lanes_.sample[c][j][l] = lanes_.sample[c][j][0];
      lanes_.cosine[j][l] = lanes_.cosine[j][0];
    }
    for (auto& axis : lanes_.frame)
      for (auto& c : axis) c[l] = c[0];
  }

  // false also where something is not a number
  bool is_determined(std::size_t l) const
  {
    const double xx = lanes_.unit[0][l], yx = lanes_.unit[1][l], yy = lanes_.unit[2][l];
    const double trace = xx * xx + yx * yx + yy * yy;
    constexpr double on_a_line = 1e-12, in_range = 1e60;
    return trace > 1 / in_range && trace < in_range &&
           xx * xx * (yy * yy) > on_a_line * trace * trace && lanes_.least_pivot[l] > 0 &&
           lanes_.square_of_inverse[l] <= max_condition * max_condition;
  }

  Graph_derivatives graph(std::size_t l) const
  {
    Graph_derivatives f;
    for (int i = 0; i < 3; ++i)
      for (int c = 0; c < 3; ++c) f.frame(c, i) = lanes_.frame[std::size_t(i)][std::size_t(c)][l];
    const auto& of = lanes_.coefficient;
    // the inverse of the units
    const double a = 1 / lanes_.unit[0][l], c = 1 / lanes_.unit[2][l],
                 b = -lanes_.unit[1][l] * a * c;
    f.gradient << a * of[0][l] + b * of[1][l], c * of[1][l];
    const double xx = 2 * of[2][l], xy = of[3][l], yy = 2 * of[4][l];
    const double mixed = c * (a * xy + b * yy);
    f.hessian << a * a * xx + 2 * a * b * xy + b * b * yy, mixed, mixed, c * c * yy;
    return f;
  }

  const Curvature_data& data_;
  Curvature_estimation one_;
  Near_vertices near_;
  Cubic_lanes lanes_;
  std::size_t used_ = 0; // lanes
  std::array<std::size_t, Cubic_lanes::lanes> sizes_{};
  std::array<Index, Cubic_lanes::lanes> vertex_{};
  std::array<Principal_curvatures*, Cubic_lanes::lanes> result_{};
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_CURVATURE_CURVATURE_ESTIMATIONS_H

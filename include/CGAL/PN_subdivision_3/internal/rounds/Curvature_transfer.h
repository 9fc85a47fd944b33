// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_ROUNDS_CURVATURE_TRANSFER_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_ROUNDS_CURVATURE_TRANSFER_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/average/input_checks.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/numbers/number_functions.h>
#include <CGAL/PN_subdivision_3/internal/rounds/Ring_functionals.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// The shortest x with A x = b, for the columns of a 3x3 matrix A. Singular values below 1e-8 of the
// largest count as 0. By rotations of pairs of columns until all are perpendicular (one-sided Jacobi
// method), always in the same order.
template <class FT>
Coordinates<FT, 3> least_norm_solution(std::array<Coordinates<FT, 3>, 3> columns,
                                       const Coordinates<FT, 3>& b)
{
  std::array<Coordinates<FT, 3>, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  constexpr std::size_t pairs[3][2] = {{0, 1}, {0, 2}, {1, 2}};
  for (int sweep = 0; sweep < 12; ++sweep)
    for (const auto& [i, j] : pairs) {
      const FT product = dot(columns[i], columns[j]);
      if (product == FT(0)) continue;
      const FT difference = dot(columns[j], columns[j]) - dot(columns[i], columns[i]);
      // tan of the smaller angle that makes them perpendicular
      const FT zeta = difference / (2 * product);
      const FT t = sign_of(zeta) / (absolute_value(zeta) + square_root_of<FT>(1 + zeta * zeta));
      const FT c = 1 / square_root_of<FT>(1 + t * t), s = c * t;
      for (auto* m : {&columns, &axes})
        for (std::size_t r = 0; r < 3; ++r) {
          const FT x = (*m)[i][r], y = (*m)[j][r];
          (*m)[i][r] = c * x - s * y;
          (*m)[j][r] = s * x + c * y;
        }
    }
  FT largest(0);
  for (const auto& column : columns) largest = (std::max)(largest, dot(column, column));
  Coordinates<FT, 3> x{};
  for (std::size_t k = 0; k < 3; ++k) {
    const FT square = dot(columns[k], columns[k]);
    if (!(square > FT(1e-16) * largest)) continue;
    const FT share = dot(columns[k], b) / square;
    for (std::size_t r = 0; r < 3; ++r) x[r] += share * axes[k][r];
  }
  return x;
}

// A quadratic form u^T Q v over the plane of a frame.
template <class Real>
struct Quadratic_part
{
  Local_frame<Real> frame;
  Real xx, xy, yy;

  // of vectors in space
  Real operator()(const Coordinates<Real, 3>& a, const Coordinates<Real, 3>& b) const
  {
    const Real a1 = dot(a, frame.e1()), a2 = dot(a, frame.e2());
    const Real b1 = dot(b, frame.e1()), b2 = dot(b, frame.e2());
    return xx * a1 * b1 + xy * (a1 * b2 + a2 * b1) + yy * a2 * b2;
  }

  // Q u, in the plane
  Pair<Real> gradient(const Pair<Real>& u) const
  {
    return {xx * u[0] + xy * u[1], xy * u[0] + yy * u[1]};
  }
};

// The transfer of curvature at an extraordinary vertex, after a round of tuned rules that keep the
// quadratic part of the heights w of a ring: half of it goes to the slopes of the control normals,
// which the PN rule keeps for ever.
template <class Real>
class Curvature_transfer
{
public:
  using Index = Level_connectivity::Index;
  using Value = Point_normal<Real, 3>;
  using Ring = std::vector<Value>;

  Curvature_transfer(Index degree, Index valence)
    : functionals_(degree, valence)
  {}

  std::size_t size() const { return functionals_.size(); }

  // The quadratic part left in the heights of a ring, in the order of Ring_functionals. None where the
  // normals spread over more than 60 degrees or are not all there, where the ring has collapsed, and
  // where the part is no more than `noise`.
  std::optional<Quadratic_part<Real>> operator()(const Ring& ring, const Real& noise) const
  {
    const auto* const mask = functionals_.limit().data();
    const Value limit = PN_average<Real, 3>{Real(1)}(mask, mask + size(), ring.data());
    for (const Value& v : ring)
      if (!(dot(v.normal, limit.normal) >= Real(1) / 2)) return std::nullopt;
    const Local_frame<Real> frame(limit.point, limit.normal);
    std::vector<Pair<Real>> u(size());
    std::vector<Real> w(size());
    for (std::size_t j = 0; j < size(); ++j) {
      u[j] = frame.u(ring[j].point);
      const auto h = pn_height<Real, 3>(ring[j], frame.origin(), frame.normal());
      w[j] = h.numerator / (std::max)(h.denominator, Real(Real(1) / Real(1000)));
    }
    const Pair<Real> slope = slope_of(u, w);
    if (!is_finite_number(slope[0]) || !is_finite_number(slope[1])) return std::nullopt;
    for (std::size_t j = 0; j < size(); ++j) w[j] -= slope[0] * u[j][0] + slope[1] * u[j][1];

    Coordinates<Real, 3> rest{};
    for (std::size_t k = 0; k < functionals_.quadratic().size(); ++k)
      rest[k] = applied(functionals_.quadratic()[k], [&](std::size_t j) { return w[j]; });
    const auto exceeds = [&](const Real& x) { return absolute_value(x) > noise; };
    if (std::none_of(rest.begin(), rest.end(), exceeds)) return std::nullopt;
    return with_rest(frame, u, rest);
  }

private:
  using Functional = typename Ring_functionals<Real>::Functional;

  template <class Function>
  static Real applied(const Functional& functional, const Function& f)
  {
    Real sum(0);
    for (std::size_t j = 0; j < functional.size(); ++j) sum += functional[j] * f(j);
    return sum;
  }

  Pair<Real> slope_of(const std::vector<Pair<Real>>& u, const std::vector<Real>& w) const
  {
    std::array<Pair<Real>, 2> size;
    Pair<Real> heights;
    for (std::size_t r = 0; r < 2; ++r) {
      for (std::size_t c = 0; c < 2; ++c)
        size[r][c] = applied(functionals_.tangent(r), [&](std::size_t j) { return u[j][c]; });
      heights[r] = applied(functionals_.tangent(r), [&](std::size_t j) { return w[j]; });
    }
    return solve(size, heights);
  }

  // The form that the functionals see as `rest`. The solution of least norm is the matrix of least norm, and does
  // not depend on the frame, if the unknown besides the diagonal is sqrt(2) Q_xy.
  std::optional<Quadratic_part<Real>> with_rest(const Local_frame<Real>& frame,
                                                const std::vector<Pair<Real>>& u,
                                                const Coordinates<Real, 3>& rest) const
  {
    const Real root = square_root_of(Real(2));
    std::array<Coordinates<Real, 3>, 3> columns{};
    for (std::size_t k = 0; k < functionals_.quadratic().size(); ++k) {
      const Functional& f = functionals_.quadratic()[k];
      columns[0][k] = applied(f, [&](std::size_t j) { return u[j][0] * u[j][0] / 2; });
      columns[1][k] = applied(f, [&](std::size_t j) { return u[j][1] * u[j][1] / 2; });
      columns[2][k] = applied(f, [&](std::size_t j) { return u[j][0] * u[j][1] / root; });
    }
    const Coordinates<Real, 3> q = least_norm_solution(columns, rest);
    for (const Real& x : q)
      if (!is_finite_number(x)) return std::nullopt;
    return Quadratic_part<Real>{frame, q[0], q[2] / root, q[1]};
  }

  Ring_functionals<Real> functionals_;
};

// Curvature_transfer on rings of any number type: in double, or long double, about the middle of the ring.
template <class FT>
class Normal_transfer
{
public:
  using Real = Rooted_number<FT>;
  using Value = Point_normal<FT, 3>;
  using Part = Quadratic_part<Real>;

  Normal_transfer(Level_connectivity::Index degree, Level_connectivity::Index valence)
    : transfer_(degree, valence)
  {}

  std::size_t size() const { return transfer_.size(); }

  // The quadratic part of a ring. A part as small as the rounding on spheres and cylinders is none; the rounding is that of
  // coordinates about the origin of the mesh, even if the points are given about another origin. The frame of the part is
  // the frame of the ring, divided by a power of two if squares of its size would be out of range.
  std::optional<Part> operator()(const std::vector<Value>& ring,
                                 const Coordinates<FT, 3>& origin = {FT(0), FT(0), FT(0)})
  {
    Real largest(0);
    Size size = 0;
    ring_.resize(ring.size());
    for (std::size_t j = 0; j < ring.size(); ++j)
      for (std::size_t c = 0; c < 3; ++c) {
        largest = (std::max)(largest, absolute_value(as<Real>(FT(origin[c] + ring[j].point[c]))));
        ring_[j].point[c] = as<Real>(FT(ring[j].point[c] - ring[0].point[c]));
        ring_[j].normal[c] = as<Real>(ring[j].normal[c]);
        size = (std::max)(size, std::abs(as<Size>(ring_[j].point[c])));
      }
    constexpr int harmless = 64;
    exponent_ = size > 0 && std::isfinite(size) ? std::ilogb(size) : 0;
    if (std::abs(exponent_) <= harmless) exponent_ = 0;
    if (exponent_ == 0) return transfer_(ring_, 64 * epsilon() * largest);
    for (Point_normal<Real, 3>& v : ring_)
      for (Real& x : v.point) x = scaled(x, -exponent_);
    auto part = transfer_(ring_, 64 * epsilon() * scaled(largest, -exponent_));
    if (part)
      for (Real* x : {&part->xx, &part->xy, &part->yy}) *x = scaled(*x, -exponent_);
    return part;
  }

  // Adds half of the part to the slopes of the normals of the ring that it was found in last.
  template <class Normal_of>
  void add_half(const Part& part, const Normal_of& normal) const
  {
    for (std::size_t j = 0; j < ring_.size(); ++j) {
      Pair<Real> g = part.gradient(part.frame.u(ring_[j].point));
      if (exponent_ != 0)
        for (Real& x : g) x = scaled(x, exponent_);
      const Real half = dot(ring_[j].normal, part.frame.normal()) / 2;
      Coordinates<FT, 3>& n = normal(j);
      for (std::size_t c = 0; c < 3; ++c)
        n[c] -= FT(half * (g[0] * part.frame.e1()[c] + g[1] * part.frame.e2()[c]));
      n = unit_or_zero(n, FT(1));
    }
  }

private:
  // a size whose exponent is asked
  using Size = std::conditional_t<std::is_floating_point_v<Real>, Real, double>;
  template <class To, class From>
  static To as(const From& x)
  {
    if constexpr (std::is_floating_point_v<From> || std::is_same_v<From, To>)
      return x;
    else
      return close_double(x);
  }
  static Real epsilon()
  {
    if constexpr (std::is_floating_point_v<FT>)
      return std::numeric_limits<FT>::epsilon();
    else
      return machine_epsilon<Real>();
  }
  static Real scaled(const Real& x, int exponent)
  {
    if constexpr (std::is_floating_point_v<Real>)
      return std::ldexp(x, exponent);
    else
      return times_power_of_two(x, exponent);
  }

  Curvature_transfer<Real> transfer_;
  std::vector<Point_normal<Real, 3>> ring_;
  int exponent_ = 0; // of the power of two by which `ring_` is divided
};

// the transfers of a round that leaves the normals of the rows as they are
struct No_transfers
{
  bool is_empty() const { return true; }
  template <class Index, class Value>
  void put(Index, Index, Value*) const
  {}
};

// appends the new ring of a vertex in the order of Ring_functionals
template <class Host>
void append_new_ring(const Level_connectivity& level, const Host& host, Level_connectivity::Index v,
                     std::vector<Level_connectivity::Index>& vertices)
{
  vertices.push_back(v);
  const auto ring = halfedges_around_target(level, level.halfedge_of_vertex(v));
  for (const auto h : ring) vertices.push_back(host.vertex_of_edge(Level_connectivity::edge(h)));
  if constexpr (Host::refined_degree == 4)
    for (const auto h : ring) vertices.push_back(host.vertex_of_face(level.face(h)));
}

// The normals that a round gives to the rings of its separated vertices by the transfer of curvature.
// The rows of the rings are evaluated for it, besides the round itself, which is not stored in any
// call: a round's values go by in blocks. Rings have no vertex in common, and each has one owner among
// the threads.
template <class FT>
class Transferred_normals
{
public:
  using Index = Level_connectivity::Index;

  // no normals are transferred
  Transferred_normals() = default;

  // append_ring(vertex, vertices) appends the new ring of a vertex, see append_new_ring(); evaluate(vertices, how many, values)
  // gives new vertices their values by the rows.
  Transferred_normals(const Level_connectivity& level, const std::vector<Index>& separated,
                      Index degree, const For_chunks& for_chunks,
                      Function_ref<void(Index, std::vector<Index>&)> append_ring,
                      Function_ref<void(const Index*, Index, Point_normal<FT, 3>*)> evaluate)
  {
    if (separated.empty()) return;
    if constexpr (is_interval_v<FT>)
      throw std::invalid_argument("PN_subdivision_3: the transfer of curvature is computed in "
                                  "double, and its results are not "
                                  "intervals: take another scheme or number type");
    std::vector<Index> vertices; // of the rings
    std::vector<std::size_t> begin{0};
    for (const Index v : separated) {
      append_ring(v, vertices);
      begin.push_back(vertices.size());
    }
    std::vector<Point_normal<FT, 3>> values(vertices.size());
    std::vector<char> is_changed(separated.size(), 0);
    for_chunks.in_precision<FT>(static_cast<Index>(separated.size()), [&](Index first, Index last) {
      std::map<std::size_t, Normal_transfer<FT>> transfers; // for each size of a ring
      std::vector<Point_normal<FT, 3>> ring;
      for (Index i = first; i < last; ++i) {
        const std::size_t size = begin[i + 1] - begin[i];
        ring.resize(size);
        evaluate(&vertices[begin[i]], static_cast<Index>(size), ring.data());
        auto transfer = transfers.find(size);
        if (transfer == transfers.end())
          transfer =
            transfers.emplace(size, Normal_transfer<FT>(degree, level.valence(separated[i]))).first;
        const auto part = transfer->second(ring);
        if (!part) continue;
        transfer->second.add_half(
          *part, [&](std::size_t j) -> auto& { return ring[j].normal; });
        is_changed[i] = 1;
        std::copy(ring.begin(), ring.end(), values.begin() + static_cast<std::ptrdiff_t>(begin[i]));
      }
    });
    for (std::size_t i = 0; i < separated.size(); ++i)
      if (is_changed[i] != 0)
        for (std::size_t j = begin[i]; j < begin[i + 1]; ++j)
          normals_.emplace_back(vertices[j], values[j].normal);
    std::sort(normals_.begin(), normals_.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
  }

  bool is_empty() const { return normals_.empty(); }
  // into the values of the new vertices [first, first + n)
  void put(Index first, Index n, Point_normal<FT, 3>* values) const
  {
    if (normals_.empty()) return;
    auto it = std::lower_bound(normals_.begin(), normals_.end(), first,
                               [](const auto& a, Index v) { return a.first < v; });
    for (; it != normals_.end() && it->first - first < n; ++it)
      values[it->first - first].normal = it->second;
  }

private:
  std::vector<std::pair<Index, Coordinates<FT, 3>>> normals_;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_ROUNDS_CURVATURE_TRANSFER_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_CURVES_INTERNAL_CURVE_WINDOWS_H
#define CGAL_PN_CURVES_INTERNAL_CURVE_WINDOWS_H

#include <CGAL/PN_curves/internal/Univariate_rows.h>
#include <CGAL/PN_curves/internal/Window_functionals.h>
#include <CGAL/PN_curves/masks/Curve_end.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Limit_weights.h>
#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/rows/Stencil_block.h>
#include <CGAL/PN_subdivision_3/numbers/Unit_normal_traits.h>
#include <CGAL/PN_subdivision_3/rows/Stencil.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The points of a window before and behind its center: that is a vertex if the mask is primal, and the first
// point of an edge if it is dual. Smaller numbers than the mask asks for mean that the polygon ends there.
using Window_size = std::pair<std::int64_t, std::int64_t>;

// How the points of a window become those of the next round.
template <class FT>
struct Curve_window
{
  using Entry = typename Stencil<FT>::Entry;
  using Rows = std::vector<std::vector<Entry>>;

  Rows rows;
  Window_size next;

  // the rest is there if `next` is the window itself, so that the next rounds are all alike
  std::vector<Entry> limit_row;
  // of the points: functionals in double, empty if there is none
  std::vector<double> first_derivative, second_derivative;
  bool has_curvature = false;
  double largest_other = 0;
};

// The windows of a mask, each made where it is met first.
template <class FT>
class Curve_windows
{
public:
  using Index = std::int64_t;
  using Window = Curve_window<FT>;
  using Entry = typename Window::Entry;

  template <class Mask>
  explicit Curve_windows(const Mask& mask)
    : rows_(mask)
  {
    const std::vector<double> a = mask.template coefficients<double>();
    const auto width = static_cast<Index>(a.size());
    half_ = rows_.is_primal() ? (width - 1) / 2 - 1 : (width - 2) / 2;
    half_ = (std::max)(half_, rows_.is_primal() ? Index(0) : Index(1));
    outer_ = (std::max)(std::abs(a.front()), std::abs(a.back()));
  }

  bool is_primal() const { return rows_.is_primal(); }
  bool has_same_center(const Curve_windows& other) const
  {
    return rows_.has_same_center(other.rows_);
  }
  // what a polygon of n points becomes; throws if it is too short
  void check_size(Index n, Curve_end end) const { rows_.range(n, end); }

  // the size of a window with both sides inside of the polygon
  Window_size full() const { return {is_primal() ? half_ : half_ - 1, half_}; }
  void widen(const Window_size& other) { half_ = (std::max)(half_, other.second); }

  const Window& at(const Window_size& size)
  {
    const auto [window, is_new] = windows_.try_emplace(size);
    if (is_new) make(size, window->second);
    return window->second;
  }

private:
  using Real = Window_functionals::Real;

  // a side that ends with the polygon has twice as many points in the next round
  Window_size next_size(const Window_size& size) const
  {
    const Index behind = is_primal() ? 2 * size.second : 2 * size.second - 1;
    return {(std::min)(2 * size.first, full().first), (std::min)(behind, full().second)};
  }

  // rows from a polygon that is no longer than the window; no row leaves it where it does not end there
  typename Window::Rows rows(const Window_size& size, const Window_size& next) const
  {
    typename Window::Rows result;
    const Index center = 2 * size.first + rows_.first_point();
    Stencil_block<FT> block;
    for (Index i = center - next.first; i <= center + next.second; ++i) {
      block.clear();
      rows_.emit_row(i, size.first + size.second + 1, Curve_end::reflect, block.row());
      block.close_row();
      result.emplace_back(block.begin(0), block.end(0));
    }
    return result;
  }

  static Ring_matrix<FT> matrix(const typename Window::Rows& rows)
  {
    Ring_matrix<FT> m;
    for (const auto& row : rows) {
      m.emplace_back();
      for (const auto& e : row) m.back().emplace_back(e.vertex, e.weight);
    }
    return m;
  }

  // Rows that sum to 1 but for the rounding of Real: the largest weight, which is the last, is the rest.
  static Ring_matrix<Real> real_matrix(const typename Window::Rows& rows)
  {
    Ring_matrix<Real> m;
    for (const auto& row : rows) {
      m.emplace_back();
      Real rest = 1;
      for (const auto& e : row) {
        const bool is_last = &e == &row.back();
        const Real weight = is_last ? rest : real(e.weight);
        m.back().emplace_back(e.vertex, weight);
        rest -= weight;
      }
    }
    return m;
  }
  static Real real(const FT& x)
  {
    if constexpr (std::is_floating_point_v<FT>)
      return x;
    else
      return close_double(x);
  }

  void make(const Window_size& size, Window& window) const
  {
    window.next = next_size(size);
    window.rows = rows(size, window.next);
    if (window.next != size) return;
    const Ring_matrix<Real> reals = real_matrix(window.rows);
    const Window_functionals f(reals, outer_);
    if (f.limit().empty())
      throw std::invalid_argument("PN_subdivision_3: the mask has no limit points: the powers of "
                                  "its matrix do not converge");
    for (const auto& [place, weight] : limit_row(f.limit(), matrix(window.rows)))
      window.limit_row.push_back({place, weight});
    window.first_derivative.assign(f.first_derivative().begin(), f.first_derivative().end());
    window.second_derivative.assign(f.second_derivative().begin(), f.second_derivative().end());
    window.has_curvature = f.has_curvature();
    window.largest_other = static_cast<double>(f.largest_other());
  }

  static Ring_row<FT> limit_row(const Window_functionals::Vector& limit,
                                const Ring_matrix<FT>& matrix)
  {
    if constexpr (is_exact_v<FT>) {
      Ring_row<FT> row = exact_limit_row(matrix);
      if (!row.empty()) return row;
    }
    return limit_weights(limit, matrix);
  }

  Univariate_rows<FT> rows_;
  Index half_ = 0;
  Real outer_ = 0;
  std::map<Window_size, Window> windows_;
};

// First and second order of a curve at the limit of a window, in double. In the frame of the limit control
// normal N points have a part u perpendicular to N and a height z over it; slopes of normals are g. With the roundness r and
// the point-normal height h, which is z - g.u / 2, the three u, w = z + r (h - z) and g are refined linearly but for terms of
// third order.
template <int dimension>
class Window_geometry
{
public:
  using Vector = Coordinates<double, dimension>;
  using Value = Point_normal<double, dimension>;

  // N is zero without control normals
  Window_geometry(const std::vector<Value>& window, const Value& limit, double roundness = 1)
    : roundness_(roundness)
    , normal_(limit.normal)
    , has_normal_(dot<double, dimension>(normal_, normal_) > 0.5)
  {
    for (const Value& v : window) {
      Vector u = v.point;
      add_multiple<double, dimension>(u, -1, limit.point);
      double w = 0;
      if (has_normal_) {
        const PN_height<double> h = pn_height<double, dimension>(v, limit.point, normal_);
        w = h.numerator / (std::max)(h.denominator, 1. / 1024);
        const auto z = dot<double, dimension>(u, normal_);
        if (roundness_ != 1) w = z + roundness_ * (w - z);
        add_multiple<double, dimension>(u, -z, normal_);
      }
      u_.push_back(u);
      w_.push_back(w);
    }
    if (has_normal_)
      for (const Value& v : window) {
        const auto height = dot<double, dimension>(v.normal, normal_);
        Vector g = normal_;
        for (std::size_t c = 0; c < dimension; ++c) g[c] -= v.normal[c] / height;
        g_.push_back(g);
      }
  }

  // the derivative with respect to the parameter
  Vector derivative(const std::vector<double>& first) const
  {
    Vector d = masked(first, u_);
    add_multiple<double, dimension>(d, masked(first, w_), normal_);
    return d;
  }

  // The curvature vector. `second` may be empty, and `normal_first` is the first derivative of the normals.
  // It is not finite where the derivative is zero or normals are turned by a right angle.
  Vector curvature_vector(const std::vector<double>& first, const std::vector<double>& normal_first,
                          const std::vector<double>& second) const
  {
    const Vector d = derivative(first);
    Vector dd{};
    double height = 0;
    if (!second.empty()) {
      dd = masked(second, u_);
      height = masked(second, w_);
    }
    if (has_normal_) {
      const Vector slope = masked(normal_first, g_), u = masked(first, u_);
      height += roundness_ * dot<double, dimension>(slope, u);
    }
    add_multiple<double, dimension>(dd, height, normal_);
    const auto square = dot<double, dimension>(d, d);
    add_multiple<double, dimension>(dd, -dot<double, dimension>(d, dd) / square, d);
    for (double& x : dd) x /= square;
    return dd;
  }

private:
  static Vector masked(const std::vector<double>& mask, const std::vector<Vector>& values)
  {
    Vector sum{};
    for (std::size_t j = 0; j < mask.size(); ++j)
      add_multiple<double, dimension>(sum, mask[j], values[j]);
    return sum;
  }
  static double masked(const std::vector<double>& mask, const std::vector<double>& values)
  {
    double sum = 0;
    for (std::size_t j = 0; j < mask.size(); ++j) sum += mask[j] * values[j];
    return sum;
  }

  double roundness_;
  Vector normal_;
  bool has_normal_;
  std::vector<Vector> u_, g_;
  std::vector<double> w_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_CURVES_INTERNAL_CURVE_WINDOWS_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_RING_EIGENVECTORS_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_RING_EIGENVECTORS_H

#include <CGAL/PN_subdivision_3/rows/Stencil.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// A row over the places of a ring, which stand for vertices.
template <class FT>
using Ring_row = std::vector<typename Stencil<FT>::Entry>;

// The matrix that maps the values of a ring to those of the next round, by its rows.
template <class FT>
using Ring_matrix = std::vector<Ring_row<FT>>;

// What the places of a ring tell of the plane: the neighbors, or the corners of a face, in turn.
struct Ring_layout
{
  std::size_t first = 1, number = 0; // the places of the neighbors
  bool at_border = false;            // then they take a half turn, and otherwise a full one
  bool clockwise = true;
  bool has_diagonals = false; // on the border: one between any two neighbors, behind all of these
};

// Left eigenvectors of a ring matrix, by iteration: that of the eigenvalue 1, the limit mask; two that
// span the space of the next two, the tangent masks, if these are set apart from all others. The
// iteration starts with the sine and cosine of the angle of the neighbors. About an interior vertex
// it then stays among the vectors of that frequency, and ends after some fifty steps for any valence.
// On the border the next two may belong to a net that folds: the right eigenvectors tell.
class Ring_eigenvectors
{
public:
  using Real = long double;
  using Vector = std::vector<Real>;

  Ring_eigenvectors(const Ring_matrix<Real>& matrix, const Ring_layout& layout)
    : matrix_(matrix)
  {
    find_limit();
    find_tangents(layout);
    find_largest_other();
    if (layout.at_border && has_tangents()) check_border(layout);
  }

  // sums to 1 but for rounding; empty if the powers of the matrix do not converge
  const Vector& limit() const { return limit_; }
  // Applied to the points of a surface, their cross product is on the outer side. Empty if there
  // is no plane that nets tend to.
  const std::array<Vector, 2>& tangents() const { return tangents_; }
  bool has_tangents() const { return !tangents_[0].empty(); }
  // the root of the product of the two eigenvalues of the tangents
  double lambda() const { return lambda_; }
  // the square of the larger one of these eigenvalues: what errors of a normal by the tangents fall by in a
  // round
  double normal_ratio() const { return normal_ratio_; }
  // the modulus of the largest eigenvalue besides 1 and those of the tangents, within some percent
  double largest_other() const { return largest_other_; }

  // The modulus of the largest eigenvalue, within some percent, of what `multiply` does to a vector that it is given; 0 if
  // all vanishes.
  template <class Multiply>
  static double largest_modulus(Vector x, const Multiply& multiply)
  {
    Real logarithm = 0;
    constexpr int skipped = 30, measured = 60;
    for (int k = 0; k < skipped + measured; ++k) {
      const Real length = normalize(x);
      if (!(length > 1e-15L)) return 0;
      if (k > skipped) logarithm += std::log(length);
      multiply(x);
    }
    return static_cast<double>(std::exp(logarithm / (measured - 1)));
  }
  static Vector noise(std::size_t size, int seed)
  {
    Vector x(size);
    for (std::size_t i = 0; i < x.size(); ++i)
      x[i] = std::sin(static_cast<Real>(seed) + static_cast<Real>(i) * static_cast<Real>(i + 3));
    return x;
  }

private:
  static constexpr int max_steps = 3000;

  // the possible error of sums over a large ring
  Real rounding() const { return 1e-18L * (1 + static_cast<Real>(matrix_.size()) / 16); }

  Vector times_matrix(const Vector& x) const
  {
    Vector y(x.size(), Real(0));
    for (std::size_t i = 0; i < x.size(); ++i)
      if (x[i] != 0)
        for (const auto& [j, weight] : matrix_[i]) y[j] += x[i] * weight;
    return y;
  }
  Vector matrix_times(const Vector& x) const
  {
    Vector y(x.size(), Real(0));
    for (std::size_t i = 0; i < x.size(); ++i)
      for (const auto& [j, weight] : matrix_[i]) y[i] += weight * x[j];
    return y;
  }
  static Real dot(const Vector& a, const Vector& b)
  {
    return std::inner_product(a.begin(), a.end(), b.begin(), Real(0));
  }
  static void add(Vector& a, Real factor, const Vector& b)
  {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] += factor * b[i];
  }
  // divides by the length, which is returned
  static Real normalize(Vector& a)
  {
    const Real length = std::sqrt(dot(a, a));
    if (length > 0)
      for (Real& x : a) x /= length;
    return length;
  }

  void find_limit()
  {
    Vector x(matrix_.size(), Real(0));
    x[0] = 1;
    for (int k = 0; k < max_steps; ++k) {
      Vector y = times_matrix(x);
      Real change = 0, sum = 0;
      for (std::size_t i = 0; i < x.size(); ++i) {
        change = (std::max)(change, std::abs(y[i] - x[i]));
        sum += y[i];
      }
      for (Real& w : y) w /= sum;
      x.swap(y);
      if (change <= rounding()) {
        limit_ = std::move(x);
        return;
      }
    }
  }

  // takes the part in the eigenvector of 1 away
  void remove_constant(Vector& x) const
  {
    add(x, -std::accumulate(x.begin(), x.end(), Real(0)), limit_);
  }

  void find_tangents(const Ring_layout& layout)
  {
    if (limit_.empty() || layout.number < 2) return;
    std::array<Vector, 2> x;
    Vector cosine(layout.number), sine(layout.number);
    const Real turn = 2 * std::acos(Real(-1)) /
                      static_cast<Real>(layout.at_border ? 2 * (layout.number - 1) : layout.number);
    for (std::size_t s = 0; s < layout.number; ++s) {
      cosine[s] = std::cos(turn * static_cast<Real>(s));
      sine[s] = std::sin(turn * static_cast<Real>(s));
    }
    x[0] = start(cosine, layout, 1);
    x[1] = start(sine, layout, 2);
    for (int k = 0; k < max_steps; ++k) {
      if (!orthonormalize(x)) return;
      std::array<Vector, 2> y = {times_matrix(x[0]), times_matrix(x[1])};
      Real rest = 0, length = 0;
      std::array<std::array<Real, 2>, 2> b{};
      for (std::size_t i = 0; i < 2; ++i) {
        remove_constant(y[i]);
        Vector r = y[i];
        for (std::size_t j = 0; j < 2; ++j) {
          b[i][j] = dot(y[i], x[j]);
          add(r, -b[i][j], x[j]);
        }
        rest += dot(r, r);
        length += dot(y[i], y[i]);
      }
      if (rest <= 100 * rounding() * rounding() * length) {
        accept_tangents(x, b, cosine, sine, layout);
        return;
      }
      x = std::move(y);
    }
  }

  // at the border nothing keeps the iteration among vectors of one kind, and it shall not seem so
  Vector start(const Vector& wave, const Ring_layout& layout, int seed) const
  {
    Vector x(matrix_.size(), Real(0));
    for (std::size_t s = 0; s < layout.number; ++s) x[layout.first + s] = wave[s];
    if (layout.at_border) add(x, Real(1) / 100, noise(x.size(), seed));
    remove_constant(x);
    return x;
  }

  static bool orthonormalize(std::array<Vector, 2>& x)
  {
    if (!(normalize(x[0]) > 0) || !(normalize(x[1]) > 0)) return false;
    for (int twice = 0; twice < 2; ++twice) {
      add(x[1], -dot(x[0], x[1]), x[0]);
      if (!(normalize(x[1]) > 1e-6L)) return false;
    }
    return true;
  }

  void accept_tangents(std::array<Vector, 2>& x, const std::array<std::array<Real, 2>, 2>& b,
                       const Vector& cosine, const Vector& sine, const Ring_layout& layout)
  {
    const Real product = b[0][0] * b[1][1] - b[0][1] * b[1][0], half = (b[0][0] + b[1][1]) / 2;
    const Real square = half * half - product;
    if (!(product > 0)) return;
    const Real larger = square > 0 ? std::abs(half) + std::sqrt(square) : std::sqrt(product);
    const Real smaller = product / larger;
    // what shrinks by the square of the larger one is no part of a plane
    if (!(smaller > larger * larger * 1.001L)) return;
    lambda_ = static_cast<double>(std::sqrt(product));
    normal_ratio_ = static_cast<double>(larger * larger);
    smaller_ = static_cast<double>(smaller);
    const auto part = [&](std::size_t i, const Vector& wave) {
      Real sum = 0;
      for (std::size_t s = 0; s < layout.number; ++s) sum += x[i][layout.first + s] * wave[s];
      return sum;
    };
    const Real orientation = part(0, cosine) * part(1, sine) - part(0, sine) * part(1, cosine);
    if ((orientation < 0) != layout.clockwise)
      for (Real& w : x[1]) w = -w;
    tangents_ = std::move(x);
  }

  // right vectors that the left ones annihilate stay so
  void find_largest_other()
  {
    if (limit_.empty()) return;
    std::vector<Vector> basis = {limit_};
    if (has_tangents()) basis.insert(basis.end(), tangents_.begin(), tangents_.end());
    for (std::size_t i = 0; i < basis.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) add(basis[i], -dot(basis[i], basis[j]), basis[j]);
      normalize(basis[i]);
    }
    const auto project = [&](Vector& z) {
      for (const Vector& b : basis) add(z, -dot(z, b), b);
    };
    Vector z = noise(matrix_.size(), 3);
    project(z);
    largest_other_ = largest_modulus(std::move(z), [&](Vector& x) {
      x = matrix_times(x);
      project(x);
    });
    // a plane that is not the largest part of the net is not the tangent plane
    if (has_tangents() && largest_other_ > smaller_ * (1 - 1e-4)) tangents_ = {};
  }

  // Right vectors that the left ones of the tangents belong to, in some basis: nets tend to an affine
  // image of the plane net that they are the coordinates of. Empty if they are not found.
  std::array<Vector, 2> plane_net() const
  {
    std::array<Vector, 2> u = {noise(matrix_.size(), 4), noise(matrix_.size(), 5)};
    const double ratio = largest_other_ / smaller_;
    const int steps = ratio > 1e-4 ? static_cast<int>(40 / -std::log(ratio)) : 4;
    for (int k = 0; k < (std::min)(steps, max_steps); ++k) {
      for (Vector& x : u) {
        x = matrix_times(x);
        const Real constant = dot(limit_, x);
        for (Real& value : x) value -= constant;
      }
      if (!orthonormalize(u)) return {};
    }
    return u;
  }

  // There is a tangent plane if the faces at the vertex lie side by side in the plane net, in less than a full
  // turn. This tells the sides of the plane, too.
  void check_border(const Ring_layout& layout)
  {
    const std::array<Vector, 2> u = plane_net();
    const std::array<Vector, 2> t = std::exchange(tangents_, {});
    if (u[0].empty()) return;
    std::vector<std::size_t> places;
    for (std::size_t s = 0; s < layout.number; ++s) {
      places.push_back(layout.first + s);
      if (layout.has_diagonals && s + 1 < layout.number)
        places.push_back(layout.first + layout.number + s);
    }
    const auto place = [&](std::size_t k) { return Vector{u[0][places[k]], u[1][places[k]]}; };
    Real largest = 0, turn = 0;
    for (std::size_t k = 0; k < places.size(); ++k)
      largest = (std::max)(largest, dot(place(k), place(k)));
    bool is_left = false;
    for (std::size_t k = 0; k + 1 < places.size(); ++k) {
      const Vector a = place(k), b = place(k + 1);
      const Real sine = a[0] * b[1] - a[1] * b[0];
      if (k == 0) is_left = sine > 0;
      if (!((is_left ? sine : -sine) > 1e-6L * largest)) return;
      turn += std::atan2(std::abs(sine), dot(a, b));
    }
    if (!(turn < 2 * std::acos(Real(-1)) - 1e-6L)) return;
    tangents_ = t;
    const Real area = dot(t[0], u[0]) * dot(t[1], u[1]) - dot(t[0], u[1]) * dot(t[1], u[0]);
    if ((area > 0) == (is_left == layout.clockwise))
      for (Real& w : tangents_[1]) w = -w;
  }

  const Ring_matrix<Real>& matrix_;
  Vector limit_;
  std::array<Vector, 2> tangents_;
  double lambda_ = 0, smaller_ = 0, normal_ratio_ = 0, largest_other_ = 0;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_RING_EIGENVECTORS_H

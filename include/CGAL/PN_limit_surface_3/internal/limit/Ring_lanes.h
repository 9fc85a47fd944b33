// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_RING_LANES_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_RING_LANES_H

#include <CGAL/PN_subdivision_3/internal/rows/Vectorized_PN_average.h>

#include <boost/config.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// The surface normals of four rings of one class side by side, as Ring_geometry finds them one by one, in wide
// registers where the processor has them. Rings that are not of ordinary size, or have no tangent plane, or no
// control normal at the limit, are left to it.
class Ring_lanes
{
public:
  static constexpr std::size_t lanes = 4;
  using Lanes = double[lanes];
  using Masks = std::array<std::vector<double>, 2>;

  struct Place
  {
    Lanes point[3], normal[3];
  };
  // The neighbors of the vertex at place 0, clockwise, from place 1 on; on the border the last one and the first one
  // have no face between them.
  struct Fan
  {
    std::size_t neighbors = 0;
    bool is_closed = true;
  };

  // --- input ---
  std::vector<Place> ring;
  Place limit;
  Lanes roundness = {1, 1, 1, 1};

  // --- output ---
  bool is_found[lanes];
  Lanes normal[3];
  Lanes size;    // as Ring_geometry::size()
  Lanes largest; // coordinate of the ring
  // An estimate of the error of the normal from this ring alone, the larger one of two terms: four times what the arcs
  // of the ring turn the normal by, which may be small by chance, and half the square of the largest angle between
  // control normals, which is not. Where it was below 1e-3, no error was above three quarters of that.
  Lanes error;
  Lanes side; // negative where the normal is against those of the faces between the neighbors

  void find(const Masks& tangents, const Fan& fan)
  {
#ifdef CGAL_PN_SUBDIVISION_3_HAS_AVX2_FUNCTIONS
    if (__builtin_cpu_supports("avx2")) return find_wide(tangents, fan);
#endif
    find_lanes(tangents, fan);
  }

private:
#ifdef CGAL_PN_SUBDIVISION_3_HAS_AVX2_FUNCTIONS
  [[gnu::target("avx2")]] void find_wide(const Masks& tangents, const Fan& fan)
  {
    find_lanes(tangents, fan);
  }
#endif

  BOOST_FORCEINLINE void find_lanes(const Masks& tangents, const Fan& fan)
  {
    set_frame();
    set_sums(tangents);
    set_normals();
    set_side(fan);
  }

  // sets the frame of Local_frame
  BOOST_FORCEINLINE void set_frame()
  {
    for (std::size_t l = 0; l < lanes; ++l) {
      const double x = limit.normal[0][l], y = limit.normal[1][l], z = limit.normal[2][l];
      const double a = std::abs(x), b = std::abs(y), c = std::abs(z);
      const bool is_first = a <= b && a <= c, is_second = !is_first && b <= c;
      const double e0 = is_first ? 0 : is_second ? z : -y;
      const double e1 = is_first ? -z : is_second ? 0 : x;
      const double e2 = is_first ? y : is_second ? -x : 0;
      const double of_length = std::sqrt(e0 * e0 + e1 * e1 + e2 * e2);
      first_[0][l] = e0 / of_length;
      first_[1][l] = e1 / of_length;
      first_[2][l] = e2 / of_length;
    }
    for (std::size_t l = 0; l < lanes; ++l) {
      const double x = limit.normal[0][l], y = limit.normal[1][l], z = limit.normal[2][l];
      second_[0][l] = y * first_[2][l] - z * first_[1][l];
      second_[1][l] = z * first_[0][l] - x * first_[2][l];
      second_[2][l] = x * first_[1][l] - y * first_[0][l];
    }
  }

  // sets the sums of the tangent masks over the ring: coordinates in the frame, heights, and the arcs' part of the heights
  BOOST_FORCEINLINE void set_sums(const Masks& tangents)
  {
    // local, so that compilers see that nothing overlaps
    Lanes sums[8] = {}, extent = {}, coordinate = {}, turn = {}, frame[3][3], origin[3], round;
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t l = 0; l < lanes; ++l) {
        frame[0][c][l] = first_[c][l];
        frame[1][c][l] = second_[c][l];
        frame[2][c][l] = limit.normal[c][l];
        origin[c][l] = limit.point[c][l];
      }
    for (std::size_t l = 0; l < lanes; ++l) round[l] = roundness[l];
    const std::size_t size_of_ring = ring.size();
    for (std::size_t i = 0; i < size_of_ring; ++i) {
      const double t = tangents[0][i], s = tangents[1][i];
      const Place& at = ring[i];
      for (std::size_t l = 0; l < lanes; ++l) {
        const double px = at.point[0][l], py = at.point[1][l], pz = at.point[2][l];
        const double x = px - origin[0][l], y = py - origin[1][l], z = pz - origin[2][l];
        const double n0 = frame[2][0][l], n1 = frame[2][1][l], n2 = frame[2][2][l];
        coordinate[l] = greater(coordinate[l], px, py, pz);
        extent[l] = greater(extent[l], x, y, z);
        const double u = x * frame[0][0][l] + y * frame[0][1][l] + z * frame[0][2][l];
        const double v = x * frame[1][0][l] + y * frame[1][1][l] + z * frame[1][2][l];
        const double a = at.normal[0][l] + n0, b = at.normal[1][l] + n1, c = at.normal[2][l] + n2;
        const double denominator = a * n0 + b * n1 + c * n2;
        const double divisor = denominator < 1. / 1024 ? 1. / 1024 : denominator;
        const double pn_height = (a * x + b * y + c * z) / divisor;
        const double of_arc = pn_height - (x * n0 + y * n1 + z * n2);
        const double height = pn_height - (1 - round[l]) * of_arc;
        const double chord2 = 4 - 2 * denominator; // between the unit normals
        turn[l] = chord2 > turn[l] ? chord2 : turn[l];
        sums[0][l] += t * u;
        sums[1][l] += s * u;
        sums[2][l] += t * v;
        sums[3][l] += s * v;
        sums[4][l] += t * height;
        sums[5][l] += s * height;
        sums[6][l] += t * of_arc;
        sums[7][l] += s * of_arc;
      }
    }
    for (std::size_t l = 0; l < lanes; ++l) {
      for (std::size_t k = 0; k < 8; ++k) sums_[k][l] = sums[k][l];
      extent_[l] = extent[l];
      turn_[l] = turn[l];
      largest[l] = coordinate[l];
    }
  }

  BOOST_FORCEINLINE static double greater(double a, double x, double y, double z)
  {
    x = std::abs(x);
    y = std::abs(y);
    z = std::abs(z);
    a = x > a ? x : a;
    a = y > a ? y : a;
    return z > a ? z : a;
  }

  BOOST_FORCEINLINE void set_normals()
  {
    for (std::size_t l = 0; l < lanes; ++l) {
      const double tu = sums_[0][l], su = sums_[1][l], tv = sums_[2][l], sv = sums_[3][l];
      const double det = tu * sv - tv * su, squares = tu * tu + tv * tv + su * su + sv * sv;
      const double a = (sums_[4][l] * sv - sums_[5][l] * tv) / det;
      const double b = (tu * sums_[5][l] - su * sums_[4][l]) / det;
      const double of_arcs_a = (sums_[6][l] * sv - sums_[7][l] * tv) / det;
      const double of_arcs_b = (tu * sums_[7][l] - su * sums_[6][l]) / det;
      const double gap = 4 * std::sqrt(of_arcs_a * of_arcs_a + of_arcs_b * of_arcs_b);
      error[l] = turn_[l] / 2 > gap ? turn_[l] / 2 : gap;
      double n[3], square_of_control = 0;
      for (std::size_t c = 0; c < 3; ++c) {
        n[c] = limit.normal[c][l] - a * first_[c][l] - b * second_[c][l];
        square_of_control += limit.normal[c][l] * limit.normal[c][l];
      }
      const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
      for (std::size_t c = 0; c < 3; ++c) normal[c][l] = n[c] / length;
      size[l] = std::abs(det) / std::sqrt(squares);
      is_found[l] = square_of_control > 0.5 && extent_[l] > 0x1p-200 && extent_[l] < 0x1p200 &&
                    std::abs(det) > 64 * std::numeric_limits<double>::epsilon() * squares &&
                    length < (std::numeric_limits<double>::max)();
    }
  }

  BOOST_FORCEINLINE void set_side(const Fan& fan)
  {
    for (double& x : side) x = 0;
    for (std::size_t i = 0; i < fan.neighbors; ++i) {
      const bool is_last = i + 1 == fan.neighbors;
      if (is_last && !fan.is_closed) break;
      const Place &v = ring[0], &p = ring[1 + i], &q = ring[is_last ? 1 : 2 + i];
      for (std::size_t l = 0; l < lanes; ++l) {
        const double a0 = q.point[0][l] - v.point[0][l], b0 = p.point[0][l] - v.point[0][l];
        const double a1 = q.point[1][l] - v.point[1][l], b1 = p.point[1][l] - v.point[1][l];
        const double a2 = q.point[2][l] - v.point[2][l], b2 = p.point[2][l] - v.point[2][l];
        side[l] += (a1 * b2 - a2 * b1) * normal[0][l] + (a2 * b0 - a0 * b2) * normal[1][l] +
                   (a0 * b1 - a1 * b0) * normal[2][l];
      }
    }
  }

  Lanes first_[3], second_[3]; // with the control normal of the limit, the frame
  Lanes sums_[8], extent_, turn_;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_LIMIT_RING_LANES_H

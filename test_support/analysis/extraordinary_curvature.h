// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_TEST_SUPPORT_EXTRAORDINARY_CURVATURE_H
#define CGAL_PN_SUBDIVISION_3_TEST_SUPPORT_EXTRAORDINARY_CURVATURE_H

#include "analysis/Extraordinary_limit.h"
#include "analysis/Extraordinary_net.h"

#include <CGAL/PN_limit_surface_3/internal/limit/Ring_geometry.h>
#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/rounds/Curvature_transfer.h>
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {

/*!
The extent of the curvatures on one ring about an extraordinary vertex. The sign of the mean curvature is
that of `Vertex_curvature`: positive where the surface bends away from its normal, as spheres with outward
normals do. Both ends are NaN if a curvature on the ring is, as where the surface degenerates.
*/
template <class FT>
struct Ring_curvature
{
  /// the least Gaussian curvature on the ring.
  FT gaussian_min;
  /// the largest Gaussian curvature on the ring.
  FT gaussian_max;
  /// the least mean curvature on the ring.
  FT mean_min;
  /// the largest mean curvature on the ring.
  FT mean_max;
  /// an estimate of what rounding makes of a mean curvature on this ring.
  FT noise;

  /// the largest |K| plus the largest H<sup>2</sup>.
  FT scale() const
  {
    const FT h = (std::max)(std::abs(mean_min), std::abs(mean_max));
    return (std::max)(std::abs(gaussian_min), std::abs(gaussian_max)) + h * h;
  }
  /// the extent of the Gaussian curvature, relative to `scale()`.
  FT oscillation() const
  {
    const FT s = scale();
    return s == FT(0) ? s : (gaussian_max - gaussian_min) / s;
  }
};

/*!
The second order data that is predicted for a PN scheme with modified rules at an extraordinary vertex, see
`Extraordinary_vertex_zoom::limit()`. The sign of the mean curvature is that of `Ring_curvature`.
*/
template <class FT>
struct Limit_curvature
{
  /// the limit point.
  Coordinates<FT, 3> point;
  /// the limit control normal N, in general not the normal of the surface.
  Coordinates<FT, 3> normal;
  /// a unit vector perpendicular to N.
  Coordinates<FT, 3> e1;
  /// the unit vector perpendicular to N and `e1`.
  Coordinates<FT, 3> e2;
  /// the slope a of the surface over the plane perpendicular to N.
  std::array<FT, 2> slope;
  /// the derivative H of the slopes of the control normals; its symmetric part is that of the
  /// surface.
  std::array<std::array<FT, 2>, 2> derivative_of_slopes;
  /// the Gaussian curvature.
  FT gaussian;
  /// the mean curvature.
  FT mean;
};

/*!
What `Extraordinary_vertex_zoom::measure()` returns.
*/
template <class FT>
struct Extraordinary_curvature
{
  /// the curvatures of the rings, from the outermost one inwards.
  std::vector<Ring_curvature<FT>> rings;
  /// predicted from the last net.
  Limit_curvature<FT> limit;

  /// returns the factor per ring by which the extent of the mean curvature changes on the last six
  /// rings, by a least squares fit of its logarithm; rings below ten times the noise are left out,
  /// and if less than two remain, the result is 0; NaN if a curvature is.
  FT rate() const
  {
    FT n(0), x(0), y(0), xx(0), xy(0);
    for (std::size_t m = rings.size() - (std::min)(rings.size(), std::size_t(6)); m < rings.size();
         ++m) {
      const FT extent = rings[m].mean_max - rings[m].mean_min;
      if (extent <= 10 * rings[m].noise) continue;
      const FT k = static_cast<FT>(m), l = std::log(extent);
      n += 1;
      x += k;
      y += l;
      xx += k * k;
      xy += k * l;
    }
    return n < 2 ? FT(0) : std::exp((n * xy - x * y) / (n * xx - x * x));
  }

  /// returns the difference between the middle of the Gaussian curvatures on the last ring and the
  /// predicted one, relative to the scale of the ring.
  FT prediction_error() const
  {
    const Ring_curvature<FT>& last = rings.back();
    const FT error = std::abs((last.gaussian_min + last.gaussian_max) / 2 - limit.gaussian);
    return error == FT(0) ? error : error / last.scale();
  }
};

/*!
measures the curvature of a subdivision surface near one extraordinary vertex as deep as the number
type allows: a control net of five rings is refined, cropped to five rings, moved so that its middle
vertex is the origin, and so on. Coordinates then shrink with the net and keep their relative
accuracy; the cost of a round does not grow.

<em>Ring m</em> is the part of the surface between the second and the fourth ring of the net of level
m, sampled at the vertices after two further rounds. Their curvatures are those of regular spline
surfaces: in the frame of the limit control normal at a vertex, control points (u, z) and control
normals (-g, 1) give u, g and w = z - g&middot;u/2, which the PN rule refines linearly up to third
order; the derivatives of the splines of u, g and w are combined by the product rule to those of z =
w + g&middot;u/2.

Of a scheme that changes its rules in some round, those of the later rounds are measured.

An object may be used for any number of control nets, also by several threads at once.

\tparam Scheme a model of `PNSubdivisionScheme_3`, or its `linear()` twin, whose rules at regular
  vertices are those of Catmull-Clark or of Loop subdivision
\tparam FT `float`, `double` or `long double`
*/
template <class Scheme, class FT = double>
class Extraordinary_vertex_zoom
{
  static_assert(std::is_floating_point_v<FT>, "curvatures are measured in floating point");

  using Level = internal::Zoom_level<Scheme, FT>;
  using Pair = internal::Pair<FT>;
  using Frame = internal::Local_frame<FT>;

public:
  /// numbers vertices.
  using Index = Level_connectivity::Index;
  /// a vector in space, and a point as its position.
  using Vector = Coordinates<FT, 3>;
  /// a control point with its normal, which is a unit vector or zero.
  using Value = Point_normal<FT, 3>;
  /// the vertices of `net()`.
  using Values = std::vector<Value>;

  /// the number of rings of the nets.
  static constexpr Index rings = 5;
  /// the degree of the faces.
  static constexpr Index degree = Scheme::Host::refined_degree;

  /// \throws std::invalid_argument if the valence is less than 3
  explicit Extraordinary_vertex_zoom(const Scheme& scheme, Index valence)
    : level_(scheme, valence, rings)
    , fine_level_(scheme, valence, 9)
    , cropped_(level_.children(level_.net()))
    , fine_(level_.children(fine_level_.net()))
    , jet_(degree)
    , limit_(level_.net())
  {
    const Extraordinary_net finest(degree, valence, 17);
    finest_ = fine_level_.children(finest);
    const Level_connectivity finest_level = finest.level();
    for (Index v = 0; v < finest.number_of_vertices(); ++v)
      if (finest.norm(v) >= 8 && finest.norm(v) <= 16)
        append_regular_ring(finest_level, v, stencils_);
  }

  /// the control net.
  const Extraordinary_net& net() const { return level_.net(); }

  /// returns the net of the next level, moved by minus the point of the middle vertex, which is added
  /// to `origin`.
  Values refined(const Values& values, Vector& origin) const
  {
    Values control = checked(values);
    move_to_origin(control, origin);
    Values result = level_.refined(control, cropped_);
    move_to_origin(result, origin);
    return result;
  }

  /// returns the net of level m after two further rounds, cropped to 17 rings; those from 8 to 16 are
  /// ring m.
  Values twice_refined(const Values& values) const
  {
    return fine_level_.refined(level_.refined(checked(values), fine_), finest_);
  }

  /// returns the curvatures on ring m, given the net of level m; NaN if it has collapsed to a point.
  Ring_curvature<FT> ring_curvature(const Values& values) const
  {
    Values control = checked(values);
    Vector origin{};
    move_to_origin(control, origin);
    const Values fine = twice_refined(control);
    const FT infinity = std::numeric_limits<FT>::infinity();
    Ring_curvature<FT> ring{infinity, -infinity, infinity, -infinity, noise(values)};
    for (std::size_t i = 0; i < stencils_.size(); i += jet_.size()) {
      const internal::Curvatures<FT> c = jet_(&stencils_[i], fine.data());
      extend(ring.gaussian_min, ring.gaussian_max, c.gaussian);
      extend(ring.mean_min, ring.mean_max, c.mean);
    }
    return ring;
  }

  /*!
  returns the curvature that is predicted for the vertex, from a net. With the limit point o, the
  limit control normal N and the left eigenvector T of the subdominant eigenvalue, all on the 1-ring,
  and with u, g and w as above in the frame of o and N,

   - U = T u, a = U<sup>-1</sup> T w, H<sup>T</sup> = U<sup>-1</sup> T g,
   - II = sym(H) / (1 + |a|<sup>2</sup>)<sup>1/2</sup>, I = 1 + a a<sup>T</sup>,
   - K = det sym(H) / (1 + |a|<sup>2</sup>)<sup>2</sup>, mean curvature -tr(I<sup>-1</sup> II) / 2.

  Of a scheme that transfers curvature, what is still to be transferred is added to H.

  It is meant for schemes whose eigenvalues besides 1 and the subdominant ones are less than the
  square of the latter; the curvature of others need not settle at extraordinary vertices. That the
  rings tend to it is proved for the modified schemes, see \ref PNSubdivision_proofs_curvature. The error falls
  from level to level as the square of the size of the net.

  Slope, derivative and curvatures are NaN if U is singular but for rounding, as where the 1-ring has
  collapsed to a line or to a point: then there is no tangent plane to speak of.
  */
  Limit_curvature<FT> limit(const Values& control) const
  {
    Values values = checked(control);
    Vector middle{};
    move_to_origin(values, middle);
    const Value o = limit_.limit(values);
    const Frame frame(o.point, has_no_normal(o) ? tangent_plane_normal(values) : o.normal);
    std::array<Pair, 2> size; // U: row r is the r-th part of T u
    std::array<Pair, 2> slopes;
    for (std::size_t c = 0; c < 2; ++c) {
      const Pair u = limit_.tangent(values, [&](const Value& v) { return frame.u(v.point)[c]; });
      const Pair g =
        limit_.tangent(values, [&](const Value& v) { return frame.slope(v.normal)[c]; });
      for (std::size_t r = 0; r < 2; ++r) {
        size[r][c] = u[r];
        slopes[c][r] = g[r];
      }
    }
    // the heights of the PN rule: w up to fourth order, and zero on spheres
    const auto height = [&](const Value& v) -> FT {
      const auto h = internal::pn_height<FT, 3>(v, o.point, frame.normal());
      return h.numerator / (std::max)(h.denominator, FT(1) / FT(1024));
    };
    std::array<Pair, 2> derivative{internal::solve(size, slopes[0]),
                                   internal::solve(size, slopes[1])};
    if constexpr (internal::Has_curvature_transfer<Scheme>::value)
      add_remaining_part(values, frame, derivative);
    Limit_curvature<FT> result =
      curvature_at(frame, internal::solve(size, limit_.tangent(values, height)), derivative);
    internal::add_multiple<FT, 3>(result.point, FT(1), middle);
    return result;
  }

  /*!
  returns the curvatures on the rings 0 to `last_ring` and the predicted limit.
  \throws std::invalid_argument if there are not as many values as `net()` has vertices
  <br><b>Cost:</b> linear in the valence and in the number of rings
  */
  Extraordinary_curvature<FT> measure(Values values, unsigned last_ring = 20) const
  {
    Extraordinary_curvature<FT> result;
    Vector origin{};
    for (unsigned m = 0;; ++m) {
      result.rings.push_back(ring_curvature(values));
      if (m == last_ring) break;
      values = refined(values, origin);
    }
    result.limit = limit(values);
    return result;
  }

private:
  // the values, without normals for a linear scheme
  Values checked(Values values) const
  {
    if (values.size() != net().number_of_vertices())
      throw std::invalid_argument("PN_subdivision_3: the net has " +
                                  std::to_string(net().number_of_vertices()) + " vertices, but " +
                                  std::to_string(values.size()) + " are given");
    if constexpr (internal::Is_linear<Scheme>::value)
      for (Value& v : values) v.normal = Vector{};
    return values;
  }

  // Moves the middle vertex to the origin and adds its point to `origin`. Points that are equal become
  // exactly zero, and remain so in every round: elsewhere rounding would spread them.
  static void move_to_origin(Values& values, Vector& origin)
  {
    const Vector middle = values.front().point;
    internal::add_multiple<FT, 3>(origin, FT(1), middle);
    for (Value& v : values) internal::add_multiple<FT, 3>(v.point, FT(-1), middle);
  }

  static bool has_no_normal(const Value& v) { return PN_average<FT, 3>::is_zero(v.normal); }

  static void extend(FT& least, FT& greatest, const FT& x)
  {
    if (std::isnan(x)) least = greatest = x;
    least = (std::min)(least, x); // of NaN and a number: NaN, the first
    greatest = (std::max)(greatest, x);
  }

  // Unit normals have an absolute error, their derivatives thus one inverse to the size of the net.
  // The factor was measured on spheres and cylinders.
  FT noise(const Values& values) const
  {
    FT length(0);
    for (Index s = 0; s < net().valence(); ++s) {
      const Vector& p = values[net().vertex(s, 1, 0)].point;
      const Vector& q = values[0].point;
      length += std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
    }
    const FT n(net().valence());
    return (4 * n * n + 30) * std::numeric_limits<FT>::epsilon() * n / length;
  }

  Vector tangent_plane_normal(const Values& values) const
  {
    Vector real, imaginary;
    for (std::size_t c = 0; c < 3; ++c) {
      const Pair t = limit_.tangent(values, [c](const Value& v) { return v.point[c]; });
      real[c] = t[0];
      imaginary[c] = t[1];
    }
    Vector n = internal::cross<FT>(imaginary, real);
    internal::normalize(n);
    return n;
  }

  // what the slopes will still get by the transfer of curvature
  void add_remaining_part(const Values& values, const Frame& frame,
                          std::array<Pair, 2>& derivative) const
  {
    Values ring{values[0]};
    for (Index s = 0; s < net().valence(); ++s) ring.push_back(values[net().vertex(s, 1, 0)]);
    if (degree == 4)
      for (Index s = 0; s < net().valence(); ++s) ring.push_back(values[net().vertex(s, 1, 1)]);
    const auto part = internal::Normal_transfer<FT>(degree, net().valence())(ring);
    if (!part) return;
    using Wide = Coordinates<typename internal::Normal_transfer<FT>::Real, 3>;
    const auto wide = [](const Vector& v) { return Wide{v[0], v[1], v[2]}; };
    const Vector axes[2] = {frame.e1(), frame.e2()};
    for (std::size_t r = 0; r < 2; ++r)
      for (std::size_t c = 0; c < 2; ++c)
        derivative[r][c] += static_cast<FT>((*part)(wide(axes[r]), wide(axes[c])));
  }

  static Limit_curvature<FT> curvature_at(const Frame& frame, const Pair& a,
                                          const std::array<Pair, 2>& h)
  {
    const FT xx = h[0][0], xy = (h[0][1] + h[1][0]) / 2, yy = h[1][1];
    const FT s = 1 + a[0] * a[0] + a[1] * a[1];
    // I^-1 = (1 + a2^2, -a1 a2; -a1 a2, 1 + a1^2) / s
    const FT trace = ((1 + a[1] * a[1]) * xx - 2 * a[0] * a[1] * xy + (1 + a[0] * a[0]) * yy) / s;
    return {frame.origin(),
            frame.normal(),
            frame.e1(),
            frame.e2(),
            a,
            h,
            (xx * yy - xy * xy) / (s * s),
            -trace / (2 * std::sqrt(s))};
  }

  Level level_, fine_level_;
  std::vector<Index> cropped_, fine_, finest_;
  internal::Regular_jet<FT> jet_;
  internal::Extraordinary_limit<FT> limit_;
  std::vector<Index> stencils_; // of the vertices of a ring, one after the other
};

} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_TEST_SUPPORT_EXTRAORDINARY_CURVATURE_H

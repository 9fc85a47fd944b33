// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_FITTING_3_INTERNAL_LIMIT_FUNCTIONALS_H
#define CGAL_PN_FITTING_3_INTERNAL_LIMIT_FUNCTIONALS_H

#include <CGAL/PN_fitting_3/internal/Interpolation_data.h>
#include <CGAL/PN_fitting_3/internal/Limit_distance.h>
#include <CGAL/PN_fitting_3/internal/Ring_limit_functionals.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// The limit at a vertex, and the tangents there, for fixed control normals as linear functions of the
// control points.
template <int dimension, int tangents>
struct Limit_functionals
{
  using Index = std::uint32_t;
  using Vector = Eigen_vector<dimension>;
  using Block = typename Ring_limit_functionals<dimension, tangents>::Block;

  struct Entry
  {
    Index vertex;
    Block block;

    static Block zero() { return Block::Zero(); }
  };

  std::vector<Entry> entries; // a vertex may occur more than once
  Index center = 0;
  Vector control_normal = Vector::Zero(); // of the limit
  Vector limit_point = Vector::Zero();    // of the points that it was evaluated for
  // Of the limit surface as a map of vectors: its normal turns by -second_form x towards a point at x.
  // Zero where it is not known.
  Eigen::Matrix<double, dimension, dimension> second_form =
    Eigen::Matrix<double, dimension, dimension>::Zero();
  bool has_second_form = false; // if it was asked for and is known
  double share_of_slopes = 1;   // of the control normals, in the second form
  double error = 0;             // estimated, of the limit point
  unsigned depth = 0;
  unsigned rounds = 0; // of the mesh, before its rules settled about the vertex
  bool has_tangents = false;

  // Fills in the limit of a ring, given by its vertices; entries if there are blocks.
  template <class Values>
  void run(Ring_limit_functionals<dimension, tangents>& of_ring, const Ring_averages& rule,
           const Values& values, const std::vector<Index>& ring, const Limit_precision& precision)
  {
    const auto& origin = values[ring[0]].point;
    Values relative;
    for (const Index w : ring) {
      relative.push_back(values[w]);
      for (std::size_t c = 0; c < dimension; ++c) relative.back().point[c] -= origin[c];
    }
    of_ring.run(rule, relative, precision);
    limit_point = to_eigen<dimension>(of_ring.limit().point) + to_eigen<dimension>(origin);
    control_normal = to_eigen<dimension>(of_ring.limit().normal);
    error = of_ring.error();
    depth += of_ring.depth();
    has_tangents = !rule.tangents.empty();
    if (!precision.with_blocks) return;
    for (std::size_t p = 0; p < ring.size(); ++p) entries.push_back({ring[p], of_ring.block(p)});
  }

  // The blocks of a limit point sum to the identity and those of a tangent to 0: taking the points
  // relative to the center saves digits.
  Vector limit(const Vectors<dimension>& p) const
  {
    Vector sum = p[center];
    for (const Entry& e : entries)
      sum += e.block.template topRows<dimension>() * (p[e.vertex] - p[center]);
    return sum;
  }
  Vector tangent(int a, const Vectors<dimension>& p) const
  {
    Vector sum = Vector::Zero();
    for (const Entry& e : entries)
      sum +=
        e.block.template middleRows<dimension>(dimension * (1 + a)) * (p[e.vertex] - p[center]);
    return sum;
  }

  // The normal of the limit surface or curve, on the side of the control normal; the control normal
  // where there is none, and `other` where there is not even that.
  Vector surface_normal(const Vectors<dimension>& p, const Vector& other) const
  {
    Vector n = control_normal.squaredNorm() > 0.5 ? control_normal : other;
    if constexpr (tangents > 0)
      if (has_tangents) {
        const Vector normal = normal_of_tangents(p, n);
        const double cosine = normal.dot(n), length = normal.norm();
        if (std::isfinite(length) && std::abs(cosine) > 1e-10 * length && length > 0)
          return (cosine < 0 ? -1 : 1) / length * normal;
      }
    return n;
  }

private:
  Vector normal_of_tangents(const Vectors<dimension>& p, [[maybe_unused]] const Vector& n) const
  {
    const Vector t = tangent(0, p);
    if constexpr (tangents == 2) {
      const Vector u = tangent(1, p);
      const double size = t.squaredNorm() + u.squaredNorm();
      const Vector normal = t.cross(u);
      return normal.norm() > 1e-10 * size ? normal : Vector(Vector::Zero());
    } else {
      const double size = t.squaredNorm();
      return size > 0 ? Vector(n - t.dot(n) / size * t) : Vector(Vector::Zero());
    }
  }
};

// Control values with the roundness of the data; a linear scheme is one of zero normals.
template <int dimension>
std::vector<Point_normal<double, dimension>> to_values(const Vectors<dimension>& points,
                                                       const Vectors<dimension>& normals,
                                                       const Interpolation_data<dimension>& data)
{
  std::vector<Point_normal<double, dimension>> values(points.size());
  for (std::size_t v = 0; v < values.size(); ++v) {
    values[v].point = to_coordinates<dimension>(points[v]);
    values[v].normal.fill(0);
    if (data.takes_normals) values[v].normal = to_coordinates<dimension>(normals[v]);
    if (!data.roundness.empty()) values[v].roundness = data.roundness[v];
  }
  return values;
}

template <class Functionals>
void note_evaluation(const std::vector<Functionals>& functionals, Limit_interpolation& report)
{
  report.error = 0;
  report.depth = 0;
  for (const Functionals& f : functionals) {
    report.error = (std::max)(report.error, f.error);
    report.depth = (std::max)(report.depth, f.depth);
  }
}

// Where limit functionals come from: a mesh with a scheme, or a polygon with a mask. What solves for
// control points knows no more of either.
template <int dimension, int tangents>
class Limit_source
{
public:
  using Index = std::uint32_t;
  using Functionals = Limit_functionals<dimension, tangents>;
  using Values = std::vector<Point_normal<double, dimension>>;

  Limit_source() = default;
  Limit_source(const Limit_source&) = delete;
  Limit_source& operator=(const Limit_source&) = delete;
  virtual ~Limit_source() = default;

  // at some vertices, none twice, of the control points and normals `values`
  virtual std::vector<Functionals> operator()(const Values& values,
                                              const std::vector<Index>& vertices,
                                              const Limit_precision& precision) = 0;

  // The largest distance of the limit from the points of some vertices, each sought about its vertex; distances below the
  // tolerance need not be known any better. Apart from the class, so that only what slides compiles it.
  using Farthest = Function_ref<Farthest_point(const Values&, const Vectors<dimension>&,
                                               const std::vector<Index>&, double)>;
};

using Surface_limits = Limit_source<3, 2>;

// The limit functionals of cubic B-spline curves, on rings of a vertex and its two neighbors. The ends
// of open curves, which are reflected, stay where they are.
template <int dimension>
class Curve_limit_functionals final : public Limit_source<dimension, 1>
{
public:
  using Index = std::uint32_t;
  using typename Limit_source<dimension, 1>::Functionals;
  using typename Limit_source<dimension, 1>::Values;

  explicit Curve_limit_functionals(bool is_closed)
    : is_closed_(is_closed)
  {
    inner_.rows_of_points = {{{1, 1. / 8}, {2, 1. / 8}, {0, 6. / 8}},
                             {{1, 1. / 2}, {0, 1. / 2}},
                             {{2, 1. / 2}, {0, 1. / 2}}};
    inner_.limit = {{1, 1. / 6}, {2, 1. / 6}, {0, 4. / 6}};
    inner_.tangents = {{0, -1, 1}};
    // as on surfaces: the differences of the limits fall by 1/16
    inner_.error_ratio = 1. / 16;
    inner_.error_factor = 1;
    end_.rows_of_points = {{{0, 1.}}};
    end_.limit = {{0, 1.}};
    for (Ring_averages* rule : {&inner_, &end_}) {
      rule->rows_of_normals = rule->rows_of_points;
      rule->normal_limit = rule->limit;
    }
  }

  std::vector<Functionals> operator()(const Values& values, const std::vector<Index>& vertices,
                                      const Limit_precision& precision) override
  {
    std::vector<Functionals> result;
    Ring_limit_functionals<dimension, 1> of_ring;
    const auto n = static_cast<Index>(values.size());
    for (const Index v : vertices) {
      std::vector<Index> ring = {v};
      if (is_closed_ || (v != 0 && v + 1 != n)) ring = {v, (v + n - 1) % n, (v + 1) % n};
      result.emplace_back().center = v;
      result.back().run(of_ring, ring.size() == 1 ? end_ : inner_, values, ring, precision);
    }
    return result;
  }

private:
  bool is_closed_;
  Ring_averages inner_, end_;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_FITTING_3_INTERNAL_LIMIT_FUNCTIONALS_H

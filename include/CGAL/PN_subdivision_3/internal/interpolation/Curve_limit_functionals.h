// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_INTERPOLATION_CURVE_LIMIT_FUNCTIONALS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_INTERPOLATION_CURVE_LIMIT_FUNCTIONALS_H

#include <CGAL/PN_subdivision_3/curves/Curve_end.h>
#include <CGAL/PN_subdivision_3/internal/interpolation/Limit_functionals.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The limit functionals of cubic B-spline curves, on rings of a vertex and its two neighbors. The ends
// of open curves, which are reflected, stay where they are.
template <int dimension>
class Curve_limit_functionals final : public Limit_source<dimension, 1>
{
public:
  using Index = std::uint32_t;
  using Value = Point_normal_roundness<double, dimension>;
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
    for (Ring_rule* rule : {&inner_, &end_}) {
      rule->rows_of_normals = rule->rows_of_points;
      rule->normal_limit = rule->limit;
    }
  }

  std::vector<Functionals> operator()(const Values& values, const std::vector<Index>& vertices,
                                      const Limit_precision& precision) override
  {
    std::vector<Functionals> result;
    Functional_tower<dimension, 1> tower;
    const auto n = static_cast<Index>(values.size());
    for (const Index v : vertices) {
      std::vector<Index> ring = {v};
      if (is_closed_ || (v != 0 && v + 1 != n)) ring = {v, (v + n - 1) % n, (v + 1) % n};
      run(values, ring, precision, tower, result.emplace_back());
    }
    return result;
  }

private:
  void run(const std::vector<Value>& values, const std::vector<Index>& ring,
           const Limit_precision& precision, Functional_tower<dimension, 1>& tower,
           Functionals& f) const
  {
    const Ring_rule& rule = ring.size() == 1 ? end_ : inner_;
    const Value& center = values[ring[0]];
    std::vector<Value> relative;
    for (const Index w : ring) {
      relative.push_back(values[w]);
      for (std::size_t c = 0; c < dimension; ++c) relative.back().point[c] -= center.point[c];
    }
    tower.run(rule, relative, precision);
    f.center = ring[0];
    f.limit_point = to_eigen<dimension>(tower.limit().point) + to_eigen<dimension>(center.point);
    f.control_normal = to_eigen<dimension>(tower.limit().normal);
    f.error = tower.error();
    f.depth = tower.depth();
    f.has_tangents = !rule.tangents.empty();
    std::vector<double> weights(ring.size());
    for (const auto& e : rule.limit) weights[e.vertex] = e.weight;
    for (std::size_t p = 0; p < ring.size(); ++p)
      f.entries.push_back({ring[p], weights[p], tower.block(p)});
  }

  bool is_closed_;
  Ring_rule inner_, end_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_INTERPOLATION_CURVE_LIMIT_FUNCTIONALS_H

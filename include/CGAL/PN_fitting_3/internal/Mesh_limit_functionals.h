// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_FITTING_3_INTERNAL_MESH_LIMIT_FUNCTIONALS_H
#define CGAL_PN_FITTING_3_INTERNAL_MESH_LIMIT_FUNCTIONALS_H

#include <CGAL/PN_fitting_3/internal/Limit_distance.h>
#include <CGAL/PN_fitting_3/internal/Limit_functionals.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Limit_evaluation.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Ring_geometry.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Ring_rules_cache.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Sub_level.h>
#include <CGAL/PN_subdivision_3/internal/concepts/scheme_traits.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/rounds/Round.h>
#include <CGAL/PN_subdivision_3/internal/rows/Stencil_block.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// The second fundamental form of a jet as a symmetric map in space, zero along the normal; positive where
// the surface bends towards the normal of its frame. Zero if the jet is degenerate.
template <class FT>
Eigen::Matrix<FT, 3, 3> second_form(const Surface_jet<FT>& jet)
{
  using Vector = Eigen::Matrix<FT, 3, 1>;
  using Matrix = Eigen::Matrix<FT, 3, 3>;
  const Vector e1 = to_eigen<3>(jet.frame.e1()), e2 = to_eigen<3>(jet.frame.e2()),
               e3 = to_eigen<3>(jet.frame.normal());
  Eigen::Matrix<FT, 3, 2> x;
  x.col(0) = jet.u[0].a * e1 + jet.u[1].a * e2 + jet.z.a * e3;
  x.col(1) = jet.u[0].b * e1 + jet.u[1].b * e2 + jet.z.b * e3;
  Vector n = x.col(0).cross(x.col(1));
  if (n.dot(e3) < 0) n = -n;
  n.normalize();
  const auto second = [&](FT u, FT v, FT z) { return n.dot(u * e1 + v * e2 + z * e3); };
  Eigen::Matrix<FT, 2, 2> form;
  form(0, 0) = second(jet.u[0].aa, jet.u[1].aa, jet.z.aa);
  form(0, 1) = form(1, 0) = second(jet.u[0].ab, jet.u[1].ab, jet.z.ab);
  form(1, 1) = second(jet.u[0].bb, jet.u[1].bb, jet.z.bb);
  const Eigen::Matrix<FT, 2, 2> inverse = (x.transpose() * x).inverse();
  const Matrix result = x * inverse * form * inverse * x.transpose();
  return result.allFinite() ? result : Matrix(Matrix::Zero());
}

// The limit functionals at vertices of a control mesh. As in Limit_evaluation, the faces around
// vertices whose neighborhood is not settled are cut out and refined until it is; the functionals are
// then pulled back through these rounds too. A linear scheme is one of zero normals.
template <class Scheme>
class Mesh_limit_functionals final : public Surface_limits
{
public:
  using Index = Level_connectivity::Index;
  using Value = Point_normal<double, 3>;
  using typename Surface_limits::Functionals;
  using typename Surface_limits::Values;

  Mesh_limit_functionals(const Scheme& scheme, const Level_connectivity& level,
                         const For_chunks& for_chunks)
    : scheme_(scheme)
    , level_(level)
    , for_chunks_(for_chunks)
    , rules_cache_(scheme)
  {}

  std::vector<Functionals> operator()(const Values& values, const std::vector<Index>& vertices,
                                      const Limit_precision& precision) override;

  Farthest_point farthest(const Values& values, const Vectors<3>& points,
                          const std::vector<Index>& vertices, double tolerance) const;

private:
  using Average = PN_average<double, 3>;
  using Plain_round = Round<Scheme, Average>;
  using Kind = typename Ring_rules_cache<Scheme, double>::Kind;
  using Functionals_of_ring = Ring_limit_functionals<3, 2>;
  using Entry = Functionals::Entry;

  using Foot = typename Limit_distance<Scheme>::Foot;

  static constexpr unsigned most_rounds = 6;

  // The surface may be nearer to a point about other vertices than about its own.
  Farthest_point about_others(const Limit_distance<Scheme>& distance, const Values& values,
                              Farthest_point nearest, const Vectors<3>& points,
                              double tolerance) const
  {
    const Eigen_vector<3>& p = points[nearest.vertex];
    const auto at = [&](Index v) { return to_eigen<3>(values[v].point); };
    for (Index v = 0; v < level_.number_of_vertices(); ++v) {
      if (v == nearest.vertex || level_.is_isolated(v)) continue;
      double edge = 0;
      level_.for_each_neighbor(level_.halfedge_of_vertex(v),
                               [&](Index w) { edge = (std::max)(edge, (at(w) - at(v)).norm()); });
      if (!((at(v) - p).norm() <= nearest.distance + edge)) continue;
      const Farthest_point other =
        distance(level_, values, {Foot(to_coordinates<3>(p), nearest.vertex, v)}, tolerance);
      if (other.distance < 31. / 32 * nearest.distance) nearest = other;
    }
    return nearest;
  }

  // A level that is evaluated at, and how it came from the one before.
  struct Stage
  {
    const Level_connectivity& level;
    const std::vector<Value>& values;
    const Stage* parent;
    const Sub_level* cut;
    const Plain_round* round;
  };

  // the values that the round has refined
  struct Cut_values
  {
    const std::vector<Value>& values;
    const std::vector<Index>& origin;
    const Value& operator[](std::size_t v) const { return values[origin[v]]; }
  };

  using Rings = std::map<const Kind*, Ring_averages>;
  using Ring_of_kind = typename Rings::value_type;

  // result[positions[i]] is that of vertices[i]
  void evaluate(const Stage& stage, const std::vector<Index>& vertices,
                const std::vector<std::size_t>& positions, unsigned next_round, unsigned depth,
                std::vector<Functionals>& result)
  {
    const unsigned first_final_round = facts_of(scheme_).first_round;
    const Has_final_rules<Scheme> has_final_rules(scheme_, stage.level,
                                                  next_round >= first_final_round);
    std::vector<const Ring_of_kind*> kinds(vertices.size(), nullptr);
    std::vector<Index> unsettled;
    std::vector<std::size_t> unsettled_positions;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const Index v = vertices[i];
      if (stage.level.is_isolated(v))
        continue;
      else if (has_final_rules(v))
        kinds[i] = &ring_of_kind(stage.level, v, next_round);
      else {
        unsettled.push_back(v);
        unsettled_positions.push_back(positions[i]);
      }
    }
    for_chunks_(static_cast<Index>(vertices.size()), [&](Index begin, Index end) {
      Functionals_of_ring of_ring;
      std::vector<Index> ring;
      for (Index i = begin; i < end; ++i) {
        Functionals& f = result[positions[i]];
        f.depth = f.rounds = depth;
        if (kinds[i] != nullptr)
          run(stage, vertices[i], *kinds[i], of_ring, ring, f);
        else if (stage.level.is_isolated(vertices[i]))
          set_isolated(stage, vertices[i], f);
      }
    });
    if (unsettled.empty()) return;
    if (depth == most_rounds && next_round < first_final_round)
      throw std::invalid_argument(
        "PN_subdivision_3: the first round of the rules of the scheme is " +
        std::to_string(first_final_round) + ", but interpolation looks for limits in the first " +
        std::to_string(most_rounds) + " rounds: take an earlier first round");
    if (depth == most_rounds)
      throw std::invalid_argument(
        "PN_subdivision_3: the scheme does not settle about its vertices: "
        "it has no limit masks");
    const Sub_level cut(stage.level, unsettled, cut_rings(scheme_));
    const Plain_round round(scheme_, cut.level, next_round);
    const Valued_level<Value> fine =
      level_of_round(round, values_of_part(stage.values, cut.vertices), for_chunks_);
    evaluate(Stage{fine.level, fine.values, &stage, &cut, &round}, cut.centers, unsettled_positions,
             next_round + 1, depth + 1, result);
  }

  const Ring_of_kind& ring_of_kind(const Level_connectivity& level, Index v, unsigned next_round)
  {
    const Kind& kind = rules_cache_.at(level, v, next_round);
    const auto [ring, is_new] = rings_.try_emplace(&kind);
    if (!is_new) return *ring;
    const auto& c = *kind.ring_rules;
    Ring_averages& rule = ring->second;
    rule.rows_of_points = c.matrix();
    rule.rows_of_normals = c.normal_matrix();
    rule.limit = c.limit_row();
    rule.normal_limit = c.normal_limit_row();
    if (c.has_tangents()) rule.tangents.assign(c.tangents().begin(), c.tangents().end());
    rule.error_factor = c.error_factor();
    rule.error_ratio = c.error_ratio();
    return *ring;
  }

  void run(const Stage& stage, Index v, const Ring_of_kind& of_kind, Functionals_of_ring& of_ring,
           std::vector<Index>& ring, Functionals& f) const
  {
    const auto& [kind, rule] = of_kind;
    ring.clear();
    Vertex_ring::append(stage.level, v, kind->rings, ring);
    f.run(of_ring, rule, stage.values, ring,
          precision_at(*kind->ring_rules, stage.level.is_border_vertex(v)));
    if (precision_.second_forms > 0)
      if (const auto jet = surface_jet(stage.level, v, *kind->ring_rules, of_ring)) {
        f.second_form = second_form(*jet);
        f.has_second_form = true;
        if (!is_spline_at(stage.level, v)) f.share_of_slopes = of_ring.limit().roundness;
      }
    for (const Stage* s = &stage; s->parent != nullptr; s = s->parent)
      f.entries = pulled_back(*s, f.entries);
  }

  // Errors of tangents and second forms fall by lambda^2 a round, on borders by lambda.
  template <class Ring_rules>
  Limit_precision precision_at(const Ring_rules& ring_rules, bool is_at_border) const
  {
    Limit_precision p = precision_;
    const double factor = ring_rules.lambda() * (is_at_border ? 1 : ring_rules.lambda());
    if (!ring_rules.has_tangents() || !(factor < 1)) return p;
    for (const double error : {p.tangents, p.second_forms})
      if (error > 0)
        p.min_depth = (std::max)(
          p.min_depth, static_cast<unsigned>(std::ceil(std::log(error) / std::log(factor))));
    p.min_depth = (std::min)(p.min_depth, p.max_depth);
    // deeper down they drown in rounding
    if (p.second_forms > 0) p.max_depth = p.min_depth;
    return p;
  }

  // through the round that has made the stage's level
  std::vector<Entry> pulled_back(const Stage& stage, const std::vector<Entry>& entries) const
  {
    const std::vector<Index>& origin = stage.cut->vertices;
    std::vector<Entry> result;
    std::unordered_map<Index, std::size_t> place;
    PN_row_blocks<3> row_blocks;
    Stencil_block<double> rows;
    for (const Entry& x : entries) {
      rows.clear();
      stage.round->host().stencil(stage.round->mask(), x.vertex, rows.row());
      rows.close_row();
      row_blocks.assign(rows.begin(0), rows.end(0), Cut_values{stage.parent->values, origin},
                        stage.values[x.vertex]);
      const auto xn = (x.block * row_blocks.normal()).eval();
      for (auto e = rows.begin(0); e != rows.end(0); ++e) {
        const Index w = origin[e->vertex];
        const auto found = place.emplace(w, result.size());
        if (found.second) result.push_back({w, Entry::zero()});
        Entry& y = result[found.first->second];
        const auto j = static_cast<std::size_t>(e - rows.begin(0));
        y.block += e->weight * (x.block + xn * row_blocks.direction(j).transpose());
      }
    }
    return result;
  }

  // at regular vertices the jet of the spline; by the slopes of the control normals where the ring matrix
  // has no part of second order that would last
  std::optional<Surface_jet<double>>
  surface_jet(const Level_connectivity& level, Index v,
              const typename Ring_rules_cache<Scheme, double>::Rules& ring_rules,
              const Functionals_of_ring& of_ring) const
  {
    if (level.is_border_vertex(v) || !ring_rules.has_tangents() ||
        Average::is_zero(of_ring.limit().normal))
      return std::nullopt;
    const std::vector<Point_normal<double, 3>> ring(of_ring.top().begin(), of_ring.top().end());
    if (is_spline_at(level, v))
      return spline_jet(Scheme::Host::refined_degree == 4, ring, of_ring.limit().roundness);
    const double lambda2 = ring_rules.lambda() * ring_rules.lambda();
    const Ring_geometry geometry(ring, of_ring.limit(), ring_rules.tangents(),
                                 of_ring.limit().roundness);
    if (!(ring_rules.largest_other() < 0.9 * lambda2) || !geometry.is_regular())
      return std::nullopt;
    return geometry.extraordinary_jet();
  }

  bool is_spline_at(const Level_connectivity& level, Index v) const
  {
    return facts_of(scheme_).limit_neighborhood.is_spline &&
           level.valence(v) == Has_final_rules<Scheme>::regular_valence;
  }

  static void set_isolated(const Stage& stage, Index v, Functionals& f)
  {
    Entry e{v, Entry::zero()};
    e.block.template topRows<3>().setIdentity();
    f.entries.assign(1, e);
    f.control_normal = to_eigen<3>(stage.values[v].normal);
    f.limit_point = to_eigen<3>(stage.values[v].point);
  }

  const Scheme& scheme_;
  const Level_connectivity& level_;
  For_chunks for_chunks_;
  Ring_rules_cache<Scheme, double> rules_cache_;
  Rings rings_;
  Limit_precision precision_;
};

template <class Scheme>
auto Mesh_limit_functionals<Scheme>::operator()(const Values& values,
                                                const std::vector<Index>& vertices,
                                                const Limit_precision& precision)
  -> std::vector<Functionals>
{
  precision_ = precision;
  std::vector<Functionals> result(vertices.size());
  std::vector<std::size_t> all(vertices.size());
  std::iota(all.begin(), all.end(), std::size_t(0));
  evaluate(Stage{level_, values, nullptr, nullptr, nullptr}, vertices, all, 1, 0, result);
  for (std::size_t i = 0; i < vertices.size(); ++i) result[i].center = vertices[i];
  return result;
}

template <class Scheme>
Farthest_point
Mesh_limit_functionals<Scheme>::farthest(const Values& values, const Vectors<3>& points,
                                         const std::vector<Index>& vertices, double tolerance) const
{
  constexpr unsigned most_checks = 16;
  std::vector<Foot> feet;
  for (const Index v : vertices)
    if (!level_.is_isolated(v)) feet.emplace_back(to_coordinates<3>(points[v]), v, v);
  const Limit_distance<Scheme> distance(scheme_, for_chunks_);
  Farthest_point known;
  for (unsigned k = 0;; ++k) {
    const Farthest_point next = distance(level_, values, feet, tolerance, known);
    if (!(next.distance > known.distance) || k == most_checks) return next;
    const Farthest_point nearest = about_others(distance, values, next, points, tolerance);
    if (nearest.distance > known.distance) known = nearest;
    if (nearest.distance == next.distance) return known;
    feet.erase(std::find_if(feet.begin(), feet.end(),
                            [&](const Foot& f) { return f.vertex == next.vertex; }));
  }
}

// The library CGAL::PN_subdivision_3_fitting has the functionals of these schemes; EXTERN is `extern` in all but one of its sources.
#define CGAL_PN_SUBDIVISION_3_FUNCTIONALS(EXTERN)                                                  \
  EXTERN template class Mesh_limit_functionals<Scheme_on_host<PQQ_host, double>>;                  \
  EXTERN template class Mesh_limit_functionals<Scheme_on_host<PTQ_host, double>>;                  \
  EXTERN template class Mesh_limit_functionals<compiled_once::Linear_of_quads>;                    \
  EXTERN template class Mesh_limit_functionals<compiled_once::Linear_of_triangles>;

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_FITTING_3_INTERNAL_MESH_LIMIT_FUNCTIONALS_H

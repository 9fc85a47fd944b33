// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_FITTING_3_INTERNAL_NORMAL_SMOOTHING_H
#define CGAL_PN_FITTING_3_INTERNAL_NORMAL_SMOOTHING_H

#include <CGAL/PN_fitting_3/internal/Ring_limit_functionals.h>
#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/normals/Fan.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Level_refiner.h>
#include <CGAL/PN_subdivision_3/internal/rounds/Round.h>
#include <CGAL/PN_subdivision_3/internal/schemes/scheme_of_call.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>

#include <Eigen/Core>
#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// The mean of |grad H| over triangles, but for those at vertices that do not count: H by cotangents (Meyer, Desbrun,
// Schroeder and Barr), with a third of the area of each triangle.
inline double mean_change_of_curvature(const Vectors<3>& points,
                                       const std::vector<std::array<std::size_t, 3>>& triangles,
                                       std::vector<bool> counts)
{
  using Vector = Eigen_vector<3>;
  Vectors<3> flow(points.size(), Vector::Zero()), normal = flow;
  std::vector<double> area(points.size(), 0), mean(points.size(), 0);
  for (const auto& t : triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t a = t[i], b = t[(i + 1) % 3], c = t[(i + 2) % 3];
      const Vector u = points[a] - points[c], v = points[b] - points[c], n = u.cross(v);
      if (!(n.norm() > 0)) continue;
      const Vector f = u.dot(v) / n.norm() / 2 * (points[a] - points[b]);
      flow[a] += f;
      flow[b] -= f;
      area[c] += n.norm() / 6;
      normal[c] += n;
    }
  for (std::size_t v = 0; v < points.size(); ++v) {
    mean[v] = flow[v].dot(normal[v].normalized()) / area[v] / 2;
    if (!std::isfinite(mean[v])) counts[v] = false;
  }
  double sum = 0, all = 0;
  for (const auto& t : triangles) {
    if (!counts[t[0]] || !counts[t[1]] || !counts[t[2]]) continue;
    const Vector u = points[t[1]] - points[t[0]], v = points[t[2]] - points[t[0]];
    sum += ((mean[t[2]] - mean[t[0]]) * u - (mean[t[1]] - mean[t[0]]) * v).norm();
    all += u.cross(v).norm();
  }
  return all > 0 ? sum / all : std::numeric_limits<double>::infinity();
}

// The mean angle between faces that share an edge, in radians.
inline double mean_turn(const Level_connectivity& level, const Vectors<3>& points)
{
  using Index = Level_connectivity::Index;
  Vectors<3> areas;
  for (Index f = 0; f < level.number_of_faces(); ++f) {
    areas.push_back(Eigen_vector<3>::Zero());
    for_each_halfedge_of_face(level, f, [&](Index h) {
      const auto& origin = points[level.target(level.halfedge_of_face(f))];
      areas[f] += (points[level.source(h)] - origin).cross(points[level.target(h)] - origin);
    });
    areas[f].normalize();
  }
  double sum = 0, number = 0;
  for (Index e = 0; e < level.number_of_edges(); ++e)
    if (!level.is_border_edge(e)) {
      const auto &a = areas[level.face(2 * e)], &b = areas[level.face(2 * e + 1)];
      sum += std::atan2(a.cross(b).norm(), a.dot(b));
      ++number;
    }
  return number > 0 ? sum / number : 0;
}

struct Fairness
{
  double change_of_curvature, mean_turn;
};

// Of the surface after two rounds. Of each quad both pairs of triangles count.
template <class Scheme_>
Fairness fairness(const Scheme_& rules, const Level_connectivity& control, const Vectors<3>& points,
                  const Vectors<3>& normals, double roundness)
{
  using Index = Level_connectivity::Index;
  using Scheme = With_roundness<Scheme_, double>;
  using Refiner = Level_refiner<Scheme, Average_of_scheme<Scheme, double>>;
  using Value = Point_normal<double, 3>;
  const Scheme scheme{{rules}};
  typename Refiner::Values values;
  for (std::size_t v = 0; v < points.size(); ++v)
    values.push_back(Value{to_coordinates<3>(points[v]), to_coordinates<3>(normals[v]), roundness});
  Refiner refiner(scheme, Level_connectivity(control), std::move(values));
  for (int k = 0; k < 2; ++k) refiner.refine();
  const Level_connectivity& level = refiner.level();
  Vectors<3> refined;
  std::vector<bool> counts;
  for (Index v = 0; v < level.number_of_vertices(); ++v) {
    const Value value = refiner.values()[v];
    refined.push_back(to_eigen<3>(value.point));
    counts.push_back(!level.is_isolated(v) && !level.is_border_vertex(v));
  }
  std::vector<std::array<std::size_t, 3>> triangles;
  for (Index f = 0; f < level.number_of_faces(); ++f) {
    std::array<Index, 4> c;
    Index h = level.halfedge_of_face(f);
    for (Index& v : c) {
      v = level.target(h);
      h = level.next(h);
    }
    const std::size_t number = c[3] == c[0] ? 1 : 4;
    for (std::size_t i = 0; i < number; ++i)
      triangles.push_back({c[i], c[(i + 1) % 4], c[(i + 2) % 4]});
  }
  return {mean_change_of_curvature(refined, triangles, std::move(counts)),
          mean_turn(level, refined)};
}

// the fairness of the surface by Loop or Catmull-Clark subdivision
inline Fairness fairness(const Level_connectivity& level, const Vectors<3>& points,
                         const Vectors<3>& normals, double roundness = 1)
{
  bool triangles = true;
  for (Level_connectivity::Index f = 0; f < level.number_of_faces() && triangles; ++f)
    triangles = level.has_degree(level.halfedge_of_face(f), 3);
  return triangles ? fairness(Loop_scheme(), level, points, normals, roundness)
                   : fairness(CatmullClark_scheme(), level, points, normals, roundness);
}

// See smooth_control_normals(). Points and unit normals, or zero ones, of the vertices of a level that is cut open
// along creases; lengths have squares in the range of double.
template <int dimension>
class Normal_smoothing
{
public:
  using Index = Level_connectivity::Index;
  using Vector = Eigen_vector<3>;

  Normal_smoothing(const Level_connectivity& level, const Vectors<3>& points,
                   const Vectors<3>& normals)
    : level_(level)
    , points_(points)
    , normals_(normals)
    , arc_of_edge_(level.number_of_edges(), none)
    , is_free_(normals.size(), false)
  {
    collect_arcs();
  }

  // the new normals; vertices that are not free have the old ones
  Vectors<3> operator()()
  {
    if (std::find(is_free_.begin(), is_free_.end(), true) == is_free_.end()) return normals_;
    estimate_noise();
    if (!(strength_ > 0)) return normals_;
    Vectors<3> smooth = solution();
    double least = fairness(level_, points_, normals_).change_of_curvature;
    if (fairness(level_, points_, smooth).change_of_curvature < least) return smooth;
    // the points themselves have noise, then, or the shape is like that
    for (const double w : {0.75, 0.5, 0.25, 0.}) {
      const double change = fairness(level_, points_, smooth, w).change_of_curvature;
      if (!(change < least)) continue;
      least = change;
      roundness_ = w;
    }
    if (roundness_ > 0 && roundness_ < 1) return smooth;
    strength_ = 0;
    return normals_;
  }

  // root mean squares, in radians
  double noise() const { return std::sqrt(noise_); }
  double defect() const { return std::sqrt(defect_); }
  double strength() const { return strength_; }
  // the roundness with which the surface is the fairest
  double roundness() const { return roundness_; }

private:
  struct Arc
  {
    Index from, to;
    Vector direction;
    double length, defect;
  };

  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();
  static constexpr double holds = 1e-9;
  static constexpr int least_freedom = 3;
  static constexpr std::size_t most_arcs = 64; // of a neighborhood, the factors of which are dense
  // of the squared defects of arcs that are that of the shape in any case
  static constexpr double least_share = 0.1;
  static constexpr double least_model = 1e-3; // of the noise

  void collect_arcs()
  {
    for (Index e = 0; e < level_.number_of_edges(); ++e) {
      const Index a = level_.source(2 * e), b = level_.target(2 * e);
      const Vector d = points_[b] - points_[a];
      const double length = d.norm();
      // nor is there one from a normal to one that is reversed
      if (!(normals_[a].dot(normals_[b]) > 0) || !(length > 0)) continue;
      const double defect = (normals_[a] + normals_[b]).dot(d) / length;
      arc_of_edge_[e] = arcs_.size();
      arcs_.push_back({a, b, d / length, length, defect});
      if (std::abs(defect) > holds) is_free_[a] = is_free_[b] = true;
    }
  }

  // the arcs along the edges of the faces of a vertex
  std::vector<std::size_t> arcs_about(Index v) const
  {
    std::vector<std::size_t> arcs;
    if (level_.is_isolated(v)) return arcs;
    for (const Index h : halfedges_around_target(level_, level_.halfedge_of_vertex(v)))
      if (!level_.is_border(h))
        for (const Index g : halfedges_around_face(level_, h)) {
          if (arcs.size() > 2 * most_arcs) break;
          const std::size_t arc = arc_of_edge_[Level_connectivity::edge(g)];
          if (arc != none) arcs.push_back(arc);
        }
    std::sort(arcs.begin(), arcs.end());
    arcs.erase(std::unique(arcs.begin(), arcs.end()), arcs.end());
    return arcs;
  }

  // a row: the cubic form of the tangent plane at v in the vector of an arc, over its length
  Eigen::MatrixXd cubic_forms(Index v, const std::vector<std::size_t>& arcs) const
  {
    const Vector t = normals_[v].unitOrthogonal(), u = normals_[v].cross(t);
    double longest = 0;
    for (const std::size_t i : arcs) longest = (std::max)(longest, arcs_[i].length);
    Eigen::MatrixXd forms(static_cast<Eigen::Index>(arcs.size()), 4);
    for (std::size_t i = 0; i < arcs.size(); ++i) {
      const Arc& arc = arcs_[arcs[i]];
      const double x = arc.direction.dot(t), y = arc.direction.dot(u);
      const double square = (arc.length / longest) * (arc.length / longest);
      forms.row(static_cast<Eigen::Index>(i)) << square * x * x * x, square * x * x * y,
        square * x * y * y, square * y * y * y;
    }
    return forms;
  }

  // a row: how a defect depends on the normals of the vertices about, which turn only
  Eigen::MatrixXd turns(const std::vector<std::size_t>& arcs) const
  {
    std::vector<Index> vertices;
    for (const std::size_t i : arcs)
      for (const Index w : {arcs_[i].from, arcs_[i].to}) vertices.push_back(w);
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    Eigen::MatrixXd all = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(arcs.size()),
                                                static_cast<Eigen::Index>(3 * vertices.size()));
    for (std::size_t i = 0; i < arcs.size(); ++i) {
      const Arc& arc = arcs_[arcs[i]];
      for (const Index w : {arc.from, arc.to}) {
        const auto place = std::lower_bound(vertices.begin(), vertices.end(), w);
        const Vector turn = arc.direction - normals_[w].dot(arc.direction) * normals_[w];
        all.block<1, 3>(static_cast<Eigen::Index>(i), 3 * (place - vertices.begin())) =
          turn.transpose();
      }
    }
    return all;
  }

  // the mean of n squares of normal variables, by their median (Wilson and Hilferty)
  static double mean_of_median(double median, double n)
  {
    const double root = 1 - 2 / (9 * n);
    return median / (root * root * root);
  }

  static double median(std::vector<double>& x)
  {
    if (x.empty()) return 0;
    const auto middle = x.begin() + std::ptrdiff_t(x.size() / 2);
    std::nth_element(x.begin(), middle, x.end());
    return *middle;
  }

  // Where the normals are exact the defects next to a vertex are a cubic form, the derivative of the second fundamental
  // form, but for terms of higher order. What a fit of it leaves is noise.
  void estimate_noise()
  {
    std::vector<double> noise, defect;
    for (Index v = 0; v < normals_.size(); ++v) {
      if (normals_[v].isZero(0)) continue;
      const std::vector<std::size_t> arcs = arcs_about(v);
      const auto n = static_cast<Eigen::Index>(arcs.size());
      if (n < least_freedom || arcs.size() > most_arcs) continue;
      Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factors(n, 4);
      factors.setThreshold(1e-6);
      factors.compute(cubic_forms(v, arcs));
      const Eigen::Index freedom = n - factors.rank();
      if (freedom < least_freedom) continue;
      Eigen::VectorXd r(n);
      for (Eigen::Index i = 0; i < n; ++i) r[i] = arcs_[arcs[std::size_t(i)]].defect;
      const Eigen::MatrixXd q = factors.householderQ();
      const auto rest = q.rightCols(freedom).transpose();
      // each of the two directions has half of the square of a turn
      const double share = (rest * turns(arcs)).squaredNorm() / 2;
      noise.push_back(mean_of_median((rest * r).squaredNorm() / share, double(freedom)));
      defect.push_back(mean_of_median(r.squaredNorm() / double(n), double(n)));
    }
    noise_ = median(noise);
    defect_ = median(defect);
    const double above = noise_ - least_share * defect_;
    if (!(above > 0)) return;
    // how far the two may be off by chance
    const double error = (std::min)(0.2, 2 / std::sqrt(double(noise.size())));
    strength_ = above / 2 / (std::max)(defect_ - (1 + error) * noise_, least_model * noise_);
  }

  // a third of each triangle's area, and so on, relative to the mean
  std::vector<double> areas() const
  {
    constexpr double least = 1e-3;
    std::vector<double> area(normals_.size(), 0);
    double sum = 0, number = 0;
    for (Index f = 0; f < level_.number_of_faces(); ++f) {
      const Vector origin = points_[level_.target(level_.halfedge_of_face(f))];
      Vector normal = Vector::Zero();
      double degree = 0;
      for_each_halfedge_of_face(level_, f, [&](Index h) {
        normal +=
          (points_[level_.source(h)] - origin).cross(points_[level_.target(h)] - origin) / 2;
        ++degree;
      });
      for_each_halfedge_of_face(level_, f,
                                [&](Index h) { area[level_.target(h)] += normal.norm() / degree; });
      sum += normal.norm();
    }
    for (Index v = 0; v < area.size(); ++v) number += level_.is_isolated(v) ? 0 : 1;
    for (double& a : area) a = sum > 0 ? (std::max)(a * number / sum, least) : 1;
    return area;
  }

  Vectors<3> solution() const
  {
    const std::vector<double> area = areas();
    const std::size_t entries = 3 * normals_.size() + 36 * arcs_.size();
    if (entries > std::size_t((std::numeric_limits<int>::max)()))
      throw std::length_error("PN_subdivision_3: the mesh has more vertices than Eigen's int can "
                              "number entries of a matrix: smooth the normals of a smaller one");
    std::vector<Eigen::Triplet<double>> triplets;
    triplets.reserve(entries);
    Eigen::VectorXd right(static_cast<Eigen::Index>(3 * normals_.size()));
    for (std::size_t v = 0; v < normals_.size(); ++v) {
      for (int k = 0; k < 3; ++k) triplets.emplace_back(int(3 * v) + k, int(3 * v) + k, area[v]);
      right.segment<3>(static_cast<Eigen::Index>(3 * v)) = area[v] * normals_[v];
    }
    for (const Arc& arc : arcs_)
      for (const Index a : {arc.from, arc.to})
        for (const Index b : {arc.from, arc.to})
          for (int k = 0; k < 3; ++k)
            for (int l = 0; l < 3; ++l)
              triplets.emplace_back(int(3 * a) + k, int(3 * b) + l,
                                    strength_ * arc.direction[k] * arc.direction[l]);
    Eigen::SparseMatrix<double> matrix(right.size(), right.size());
    matrix.setFromTriplets(triplets.begin(), triplets.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(matrix);
    // ComputationInfo() is Success, of which X11 has a macro
    if (factors.info() != Eigen::ComputationInfo()) return normals_;
    const Eigen::VectorXd x = factors.solve(right);
    Vectors<3> smooth = normals_;
    for (std::size_t v = 0; v < normals_.size(); ++v) {
      const Vector n = x.segment<3>(static_cast<Eigen::Index>(3 * v));
      const double length = n.norm();
      if (is_free_[v] && n.dot(normals_[v]) > 0) smooth[v] = n / length;
    }
    return smooth;
  }

  const Level_connectivity& level_;
  const Vectors<3>&points_, &normals_;
  std::vector<Arc> arcs_;
  std::vector<std::size_t> arc_of_edge_;
  std::vector<bool> is_free_; // has an arc that does not hold
  double noise_ = 0, defect_ = 0, strength_ = 0, roundness_ = 1;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_FITTING_3_INTERNAL_NORMAL_SMOOTHING_H

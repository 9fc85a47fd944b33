// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The parts of estimate_curvature() that make it fast, against slow ways to the same: normal equations in lanes
// against a singular value decomposition, rings against sets, angles against those of the mathematical library.

#include "Estimated_curvatures.h"

#include <CGAL/PN_limit_surface_3/internal/curvature/Cubic_lanes.h>
#include <CGAL/PN_limit_surface_3/internal/curvature/Curvature_data.h>
#include <CGAL/PN_limit_surface_3/internal/curvature/Curvature_estimations.h>
#include <CGAL/PN_subdivision_3/internal/average/Local_frame.h>
#include <CGAL/PN_subdivision_3/internal/normals/estimate_normals.h>

#include <Eigen/SVD>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <random>
#include <set>
#include <vector>

using namespace estimated_curvatures;
namespace in = PN::internal;

namespace {

using Index = PN::Level_connectivity::Index;
using Generator = std::mt19937;

double uniform(Generator& g, double a, double b)
{
  return std::uniform_real_distribution<double>(a, b)(g);
}

// --- normal equations ---

struct Sample
{
  double x, y, z, weight;
};
using Samples = std::vector<Sample>;

// Around the origin, long and skew as well.
Samples random_samples(Generator& g)
{
  Samples s(std::size_t(uniform(g, 12, 60)));
  const double length = uniform(g, 0.2, 5), shear = uniform(g, -2, 2);
  for (Sample& p : s) {
    const double x = uniform(g, -1, 1), y = uniform(g, -1, 1);
    p = {length * x + shear * y, y, uniform(g, -1, 1), uniform(g, 0.1, 1)};
  }
  return s;
}

// The unit vectors of the frame are those of space.
void put(const Samples& s, std::size_t lane, in::Cubic_lanes& lanes)
{
  lanes.number[lane] = double(s.size());
  for (std::size_t j = 0; j < lanes.size; ++j) {
    const Sample p = j < s.size() ? s[j] : Sample{0, 0, 0, 0};
    lanes.sample[0][j][lane] = p.x;
    lanes.sample[1][j][lane] = p.y;
    lanes.sample[2][j][lane] = p.z;
    lanes.cosine[j][lane] = p.weight;
  }
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t c = 0; c < 3; ++c) lanes.frame[i][c][lane] = i == c ? 1 : 0;
}

std::unique_ptr<in::Cubic_lanes> solved(const std::vector<Samples>& samples)
{
  auto lanes = std::make_unique<in::Cubic_lanes>();
  for (const Samples& s : samples) lanes->size = (std::max)(lanes->size, s.size());
  for (std::size_t l = 0; l < in::Cubic_lanes::lanes; ++l)
    put(samples[l % samples.size()], l, *lanes);
  lanes->solve();
  return lanes;
}

// x, y in units in which their second moments, with the vertex, are those of a unit square; then rows of the
// monomials times root of the binomial coefficient over the factorial, as a norm of derivatives has them.
struct Reference
{
  Eigen::Matrix2d units = Eigen::Matrix2d::Zero(); // lower triangular
  double norm_of_inverse = 0;
  Eigen::VectorXd coefficients = Eigen::VectorXd(9);

  explicit Reference(const Samples& s)
  {
    Eigen::Matrix2d moments = Eigen::Matrix2d::Zero();
    for (const Sample& p : s)
      moments += Eigen::Vector2d(p.x, p.y) * Eigen::RowVector2d(p.x, p.y) / double(s.size() + 1);
    units = moments.llt().matrixL();
    Eigen::MatrixXd a(s.size(), 9);
    Eigen::VectorXd b(s.size());
    for (std::size_t i = 0; i < s.size(); ++i) {
      const Eigen::Vector2d u = units.inverse() * Eigen::Vector2d(s[i].x, s[i].y);
      const double weight = s[i].weight / (1 + u.squaredNorm() / 2);
      for (int degree = 1, column = 0; degree <= 3; ++degree)
        for (int k = 0; k <= degree; ++k, ++column)
          a(Eigen::Index(i), column) = weight * std::pow(u[0], degree - k) * std::pow(u[1], k);
      b[Eigen::Index(i)] = weight * s[i].z;
    }
    coefficients = a.jacobiSvd(Eigen::ComputeThinU | Eigen::ComputeThinV).solve(b);
    const double binomials[] = {1, 1, 1, 2, 1, 1, 3, 3, 1};
    for (int i = 0; i < 9; ++i) a.col(i) *= std::sqrt(binomials[i]);
    for (const auto& [first, n] : {std::pair(0, 2), std::pair(2, 3), std::pair(5, 4)})
      a.middleCols(first, n) /= a.middleCols(first, n).norm() / std::sqrt(double(n));
    norm_of_inverse = a.jacobiSvd().singularValues().cwiseInverse().norm();
  }
};

} // namespace

TEST(Curvature_fit, NormalEquationsAgreeWithSingularValues)
{
  Generator g(1);
  for (int i = 0; i < 200; ++i) {
    std::vector<Samples> samples;
    for (std::size_t l = 0; l < in::Cubic_lanes::lanes; ++l) samples.push_back(random_samples(g));
    const auto lanes = solved(samples);
    for (std::size_t l = 0; l < samples.size(); ++l) {
      const Reference expected(samples[l]);
      const double inverse = expected.norm_of_inverse, error = 1e-14 * inverse * inverse;
      EXPECT_GT(lanes->least_pivot[l], 0);
      EXPECT_NEAR(std::sqrt(lanes->square_of_inverse[l]) / inverse, 1, error);
      EXPECT_NEAR(lanes->unit[0][l], expected.units(0, 0), 1e-14 * expected.units.norm());
      EXPECT_NEAR(lanes->unit[1][l], expected.units(1, 0), 1e-14 * expected.units.norm());
      EXPECT_NEAR(lanes->unit[2][l], expected.units(1, 1), 1e-13 * expected.units.norm());
      for (int k = 0; k < 5; ++k)
        EXPECT_NEAR(lanes->coefficient[k][l], expected.coefficients[k],
                    10 * error * (1 + expected.coefficients.norm()));
    }
  }
}

TEST(Curvature_fit, ALaneIsItsOwn)
{
  Generator g(2);
  for (int i = 0; i < 50; ++i) {
    std::vector<Samples> samples;
    for (std::size_t l = 0; l < in::Cubic_lanes::lanes; ++l) samples.push_back(random_samples(g));
    const auto together = solved(samples);
    for (std::size_t l = 0; l < samples.size(); ++l) {
      const auto alone = solved({samples[l]});
      for (std::size_t other = 0; other < in::Cubic_lanes::lanes; ++other) {
        EXPECT_EQ(together->square_of_inverse[l], alone->square_of_inverse[other]);
        for (std::size_t k = 0; k < 5; ++k)
          EXPECT_EQ(together->coefficient[k][l], alone->coefficient[k][other]);
      }
    }
  }
}

// Points on two lines leave one cubic undetermined, those on one line more.
TEST(Curvature_fit, UndeterminedCubicsAreToldApart)
{
  Generator g(3);
  for (const double angle : {0.3, 1.2}) {
    Samples cross;
    for (int i = 1; i <= 8; ++i)
      for (const double t : {0., angle})
        for (const double r : {0.1 * i, -0.1 * i})
          cross.push_back({r * std::cos(t), r * std::sin(t), uniform(g, -1, 1), 1});
    const auto lanes = solved({cross});
    EXPECT_FALSE(lanes->least_pivot[0] > 0 && lanes->square_of_inverse[0] < 1e6);
  }
}

// --- neighborhoods, normals ---

namespace {

in::Curvature_data data_of(const Mesh& mesh)
{
  std::unique_ptr<in::Curvature_data> data;
  in::with_mesh_access(mesh, [&](const auto& access) {
    data = std::make_unique<in::Curvature_data>(
      in::curvature_data<double>(access, get(CGAL::vertex_point, mesh), in::No_normal_map()));
  });
  return *data;
}

struct Estimation
{
  explicit Estimation(const Mesh& mesh)
    : data(data_of(mesh))
    , faces(data)
  {
    in::set_faces(data, faces, in::For_chunks());
  }
  in::Curvature_data data;
  in::Face_neighbors faces;
};

// Random quadrilaterals, triangles and others over a torus and a square, with flat and with steep parts. About the tube
// of the coarse torus two rings reach vertices that face the other way.
std::vector<Sampled_surface> surfaces()
{
  std::vector<Sampled_surface> result;
  for (const Faces kind : {Faces::quads, Faces::triangles, Faces::mixed}) {
    result.push_back(lay(torus_grid(24, kind), torus));
    result.push_back(lay(torus_grid(5, kind), torus));
    result.push_back(lay(square(24, kind, 0.3), waves));
  }
  for (const int n : {3, 5, 9, 12}) result.push_back(lay(star(n, Faces::quads, 0.1), saddle));
  return result;
}

// the vertices of the faces at those of a set
std::set<Index> grown(const PN::Level_connectivity& level, const std::set<Index>& vertices)
{
  std::set<Index> result;
  for (Index h = 0; h < level.number_of_halfedges(); ++h) {
    if (level.is_border(h) || vertices.count(level.target(h)) == 0) continue;
    for (Index g = level.next(h); g != h; g = level.next(g)) result.insert(level.target(g));
  }
  return result;
}

} // namespace

TEST(Curvature_fit, NeighborsAreThoseOfRings)
{
  std::size_t found = 0;
  for (const Sampled_surface& s : surfaces()) {
    const Estimation e(mesh_of(s.soup));
    const auto& level = e.data.level;
    in::Near_vertices near(e.data, e.faces);
    const auto faces_same_way = [&](Index v, Index w) {
      double sum = 0;
      for (std::size_t c = 0; c < 3; ++c)
        sum += e.data.vertices[v].normal[c] * e.data.vertices[w].normal[c];
      return sum > 0;
    };
    for (Index v = 0; v < level.number_of_vertices(); v += 3) {
      if (!near.find(v)) continue;
      ++found;
      std::set<Index> expected;
      for (const Index w : grown(level, {v}))
        if (faces_same_way(v, w)) expected.insert(w);
      if (expected.size() < 12) {
        for (const Index w : grown(level, expected))
          if (faces_same_way(v, w)) expected.insert(w);
      }
      expected.erase(v);
      std::set<Index> vertices;
      for (std::size_t i = 0; i < near.size(); ++i) vertices.insert(near[i].vertex);
      EXPECT_EQ(vertices.size(), near.size());
      EXPECT_EQ(vertices, expected);
    }
  }
  EXPECT_GT(found, 500u);
}

TEST(Curvature_fit, AnglesAreGoodToSevenDigits)
{
  for (int i = -10000; i <= 10000; ++i)
    EXPECT_NEAR(in::Corner_normals::arc_cosine(i / 10000.), std::acos(i / 10000.), 3e-8);
}

TEST(Curvature_fit, NormalsAreThoseOfAngles)
{
  for (const Sampled_surface& s : surfaces())
    for (const double scale : {1e-200, 1., 1e100}) {
      Soup soup = s.soup;
      for (Triple& p : soup.points) p = {scale * p[0], scale * p[1], scale * p[2]};
      const Estimation e(mesh_of(soup));
      in::estimate_normals<double>(
        e.data.level, PN::Control_normal_estimate::angle,
        [&](Index v) -> const auto& { return e.data.vertices[v].point; },
        [&](Index v, const PN::Coordinates<double, 3>& n) {
          for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(e.data.vertices[v].normal[c], n[c], 1e-7);
        });
    }
}

TEST(Curvature_fit, HalfAngles)
{
  for (int i = -179; i <= 180; ++i) {
    const double angle = i * std::acos(-1.) / 180;
    const Eigen::Vector2d half = in::half_angle(3 * std::cos(angle), 3 * std::sin(angle), 3);
    EXPECT_NEAR(half[0], std::cos(angle / 2), 1e-15);
    EXPECT_NEAR(half[1], std::sin(angle / 2), 1e-15);
  }
}

// What the lanes give is what one vertex after the other is given by orthogonal transformations.
TEST(Curvature_fit, SeveralAtOnceAreThoseOfOneAtATime)
{
  for (const Sampled_surface& s : surfaces()) {
    const Estimation e(mesh_of(s.soup));
    const Index n = e.data.level.number_of_vertices();
    std::vector<in::Principal_curvatures> several(n);
    in::Curvature_estimations(e.data, e.faces)(0, n, several.data());
    in::Curvature_estimation one(e.data);
    for (Index v = 0; v < n; ++v) {
      const in::Principal_curvatures expected = one(v);
      const double size = 1 + std::abs(expected.minimal) + std::abs(expected.maximal);
      EXPECT_EQ(several[v].is_estimated, expected.is_estimated);
      EXPECT_NEAR(several[v].minimal, expected.minimal, 1e-11 * size);
      EXPECT_NEAR(several[v].maximal, expected.maximal, 1e-11 * size);
      EXPECT_NEAR(several[v].mean, expected.mean, 1e-11 * size);
      EXPECT_NEAR(several[v].gaussian, expected.gaussian, 1e-11 * size * size);
    }
  }
}

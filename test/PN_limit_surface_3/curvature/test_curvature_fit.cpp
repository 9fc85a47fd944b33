// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Curvatures estimated from points against the same by singular value decompositions, sets of vertices and normals of its
// own: which neighbors take part, when they determine a cubic, and what it is.

#include "Estimated_curvatures.h"

#include <CGAL/Surface_mesh/IO/PLY.h>

#include <Eigen/SVD>

#include <fstream>
#include <set>

using namespace estimated_curvatures;
namespace in = PN::internal;

namespace {

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

// Around the origin, long and skew as well, and every second time close to two lines, which do not determine a cubic.
Samples random_samples(Generator& g, bool close_to_lines)
{
  Samples s(std::size_t(uniform(g, 12, 60)));
  const double length = uniform(g, 0.2, 5), shear = uniform(g, -2, 2), width = uniform(g, 0, 0.03);
  double side = 1;
  for (Sample& p : s) {
    const double x = uniform(g, -1, 1), y = uniform(g, -1, 1);
    p = {length * x + shear * y, y, uniform(g, -1, 1), uniform(g, 0.1, 1)};
    if (close_to_lines) p.y = side * x + width * y;
    side = -side;
  }
  return s;
}

// x, y in units in which their second moments, with the vertex, are those of a unit square; then rows of the
// monomials times root of the binomial coefficient over the factorial, as a norm of derivatives has them.
struct Reference
{
  Eigen::Matrix2d units = Eigen::Matrix2d::Zero(); // lower triangular
  double norm_of_inverse = 0;
  Eigen::VectorXd coefficients = Eigen::VectorXd(9);
  double gaussian = 0, mean = 0;

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
    set_curvatures();
  }

private:
  void set_curvatures()
  {
    const Eigen::Matrix2d to_units = units.inverse();
    Eigen::Matrix2d second;
    second << 2 * coefficients[2], coefficients[3], coefficients[3], 2 * coefficients[4];
    const Eigen::Vector2d g = to_units.transpose() * coefficients.head<2>();
    second = to_units.transpose() * second * to_units;
    const double p = g[0], q = g[1], w = std::sqrt(1 + p * p + q * q);
    gaussian = second.determinant() / std::pow(w, 4);
    mean = -((1 + q * q) * second(0, 0) - 2 * p * q * second(0, 1) + (1 + p * p) * second(1, 1)) /
           (2 * std::pow(w, 3));
  }
};

bool is_fitted(const Samples& samples, in::Curvature_fit& fit)
{
  std::vector<in::Curvature_sample> all;
  for (const Sample& s : samples) all.push_back({{s.x, s.y, s.z}, {0, 0, 0}, s.weight});
  all.push_back({{0, 0, 0}, {0, 0, 0}, 1});
  return fit.fit(all, {0, 0, 1}, 3);
}

TEST(Curvature_fit, NormalEquationsAgreeWithSingularValues)
{
  Generator g(1);
  std::size_t determined = 0;
  constexpr int times = 120;
  for (int i = 0; i < times; ++i) {
    const Samples samples = random_samples(g, i % 2 != 0);
    const Reference expected(samples);
    in::Curvature_fit fit;
    const bool is_determined = is_fitted(samples, fit);
    EXPECT_EQ(is_determined, expected.norm_of_inverse <= 50) << expected.norm_of_inverse;
    if (!is_determined) continue;
    ++determined;
    const in::Principal_curvatures c = fit.curvatures(1);
    const double size = std::abs(c.minimal) + std::abs(c.maximal);
    EXPECT_NEAR(c.mean, expected.mean, 1e-12 * size);
    EXPECT_NEAR(c.gaussian, expected.gaussian, 1e-12 * size * size);
  }
  EXPECT_GT(determined, times / 4u);
  EXPECT_LT(determined, times - 2u);
}

// Points on two lines leave one cubic undetermined, those on one line more.
TEST(Curvature_fit, UndeterminedCubicsAreToldApart)
{
  Generator g(3);
  for (const double angle : {0., 0.3, 1.2}) {
    Samples cross;
    for (int i = 1; i <= 8; ++i)
      for (const double t : {0., angle})
        for (const double r : {0.1 * i, -0.1 * i})
          cross.push_back({r * std::cos(t), r * std::sin(t), uniform(g, -1, 1), 1});
    in::Curvature_fit fit;
    EXPECT_FALSE(is_fitted(cross, fit));
  }
}

// --- neighborhoods, normals ---

// Random quadrilaterals, triangles and others over a torus and a square, with flat and with steep parts. About the tube
// of the coarse torus two rings reach vertices that face the other way.
std::vector<Sampled_surface> surfaces()
{
  std::vector<Sampled_surface> result;
  for (const Faces kind : {Faces::quads, Faces::triangles, Faces::mixed}) {
    result.push_back(lay(torus_grid(12, kind), torus));
    result.push_back(lay(torus_grid(5, kind), torus));
    result.push_back(lay(square(12, kind, 0.3), waves));
  }
  for (const int n : {3, 5, 9, 12}) result.push_back(lay(star(n, Faces::quads, 0.1), saddle));
  return result;
}

using Vectors = std::vector<Eigen::Vector3d>;

// weighted by angles
Vectors vertex_normals(const Soup& soup, const Vectors& p)
{
  Vectors normals(p.size(), Eigen::Vector3d::Zero());
  for (const Polygon& f : soup.faces) {
    const std::size_t n = f.size();
    Eigen::Vector3d area = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < n; ++i)
      area += (p[f[i]] - p[f[0]]).cross(p[f[(i + 1) % n]] - p[f[0]]);
    for (std::size_t i = 0; i < n; ++i) {
      const Eigen::Vector3d a = p[f[(i + 1) % n]] - p[f[i]], b = p[f[(i + n - 1) % n]] - p[f[i]];
      normals[f[i]] += std::acos(a.normalized().dot(b.normalized())) * area.normalized();
    }
  }
  for (Eigen::Vector3d& m : normals) m.normalize();
  return normals;
}

// The vertices of the faces at those of a set that face the same way, but the vertex.
std::set<std::size_t> grown(const Soup& soup, const std::set<std::size_t>& vertices,
                            const Vectors& normals, std::size_t v)
{
  std::set<std::size_t> result = vertices;
  for (const Polygon& f : soup.faces) {
    const auto is_near = [&](std::size_t w) { return w == v || vertices.count(w) != 0; };
    if (std::none_of(f.begin(), f.end(), is_near)) continue;
    for (const std::size_t w : f)
      if (w != v && normals[w].dot(normals[v]) > 0) result.insert(w);
  }
  return result;
}

Samples samples_of(const std::set<std::size_t>& vertices, const Vectors& p, const Vectors& normals,
                   std::size_t v)
{
  const Eigen::Vector3d n = normals[v], x = n.cross(Eigen::Vector3d(0.3, 0.5, 0.8)).normalized();
  const Eigen::Vector3d y = n.cross(x);
  Samples samples;
  for (const std::size_t w : vertices) {
    const Eigen::Vector3d d = p[w] - p[v];
    samples.push_back({d.dot(x), d.dot(y), d.dot(n), normals[w].dot(n)});
  }
  return samples;
}

// Rings grow until they determine a cubic, at the border, too.
TEST(Curvature_fit, EstimatesAreThoseOfSetsOfVertices)
{
  std::size_t found = 0, of_more_rings = 0;
  for (const Sampled_surface& s : surfaces()) {
    const Curvatures c = from_points(s.soup);
    Vectors p;
    for (const Triple& q : s.soup.points) p.emplace_back(q[0], q[1], q[2]);
    const Vectors normals = vertex_normals(s.soup, p);
    for (std::size_t v = 0; v < p.size(); v += 11) {
      std::set<std::size_t> near;
      for (int rings = 1; rings <= 4; ++rings) {
        near = grown(s.soup, near, normals, v);
        if (near.size() < 12) continue;
        const Reference expected(samples_of(near, p, normals, v));
        if (!(expected.norm_of_inverse <= 50)) continue;
        ++found;
        if (rings > 2) ++of_more_rings;
        const double size = std::abs(c[v].minimal) + std::abs(c[v].maximal) + 1e-3;
        EXPECT_NEAR(c[v].mean, expected.mean, 1e-9 * size) << v << ", rings: " << rings;
        EXPECT_NEAR(c[v].gaussian, expected.gaussian, 1e-9 * size * size);
        break;
      }
    }
  }
  EXPECT_GT(found, 80u);
  EXPECT_GT(of_more_rings, 5u);
}

// a net over the surface of a file of data/, whose points and normals are exact
Sampled_surface read_sampled(const std::string& file, double gaussian, double mean)
{
  Mesh mesh;
  const auto normals = mesh.add_property_map<Vertex, Kernel::Vector_3>("v:normal").first;
  std::ifstream in(std::string(PN_DATA_DIR) + "/" + file, std::ios::binary);
  EXPECT_TRUE(CGAL::IO::read_PLY(in, mesh)) << file;
  Sampled_surface s{{points(mesh), faces_of(mesh)}, {}};
  for (const Triple& n : values(mesh, normals)) s.exact.push_back({{}, n, gaussian, mean, {}});
  return s;
}

// Closed and open, triangles, quads, mixed polygons, valences 3 to 12: with exact normals spheres
// and cylinders are exact.
TEST(Curvature_fit, SpheresAndCylindersAreExactWithNormals)
{
  for (const auto& [file, radius] :
       {std::pair("sphere_triangles.ply", 1.), std::pair("sphere_cap.ply", 2.5),
        std::pair("sphere_quads.ply", 1.), std::pair("sphere_mixed.ply", 1.)}) {
    SCOPED_TRACE(file);
    const Sampled_surface s = read_sampled(file, 1 / (radius * radius), 1 / radius);
    EXPECT_LT(error(from_normals(s.soup, normals_of(s)), s), 2e-12);
  }
  for (const auto& [file, radius] :
       {std::pair("cylinder_triangles.ply", 0.75), std::pair("cylinder_quads.ply", 1.)}) {
    SCOPED_TRACE(file);
    const Sampled_surface s = read_sampled(file, 0, 0.5 / radius);
    EXPECT_LT(error(from_normals(s.soup, normals_of(s)), s), 1e-12);
  }
}

// Edges alone tell the curvatures of a saddle to first order; with what the offsets tell of the third derivatives a fourth of the
// length leaves a sixteenth of the error, not a fourth.
TEST(Curvature_fit, NormalsTellCurvaturesToSecondOrder)
{
  for (int valence : {5, 7}) {
    const auto largest = [&](double h) {
      const Sampled_surface s = lay(star(valence, Faces::triangles, h), saddle);
      return error(from_normals(s.soup, normals_of(s)), s);
    };
    EXPECT_LT(8 * largest(0.005), largest(0.02)) << valence;
  }
}

} // namespace

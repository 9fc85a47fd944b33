// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_CURVATURE_CURVATURE_ESTIMATION_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_CURVATURE_CURVATURE_ESTIMATION_H

#include <CGAL/PN_subdivision_3/internal/normals/Fan.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// The derivatives of the unit normal in an orthonormal basis of eigenvectors.
struct Principal_curvatures
{
  double minimal = 0, maximal = 0, gaussian = 0, mean = 0;
  Eigen::Vector3d minimal_direction{0, 0, 0}, maximal_direction{0, 0, 0};
  bool is_estimated = false;
};

// What is known of a graph z = f(u) at u = 0; z is along the last column of the frame.
struct Graph_derivatives
{
  Eigen::Matrix3d frame;
  Eigen::Vector2d gradient;
  Eigen::Matrix2d hessian;
};

// The curvatures of the graph, whose lengths have been divided by `scale`. The shape operator is that of
// the derivative of the normal (-grad f, 1)/W, so that a sphere with outward normals has positive curvatures.
inline Principal_curvatures principal_curvatures(const Graph_derivatives& f, double scale)
{
  const double a = f.gradient[0], b = f.gradient[1], w = std::sqrt(1 + a * a + b * b);
  // the columns of `basis` are the projections of an orthonormal basis of the tangent plane
  const double l = std::sqrt(1 + a * a);
  Eigen::Matrix2d basis;
  basis << 1 / l, -a * b / (l * w), 0, l / w;
  const Eigen::Matrix2d shape = -basis.transpose() * f.hessian * basis / w;

  Principal_curvatures c;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen;
  eigen.computeDirect(shape);
  c.mean = shape.trace() / 2 / scale;
  c.minimal = eigen.eigenvalues()[0] / scale;
  c.maximal = eigen.eigenvalues()[1] / scale;
  c.gaussian =
    shape(0, 0) / scale * (shape(1, 1) / scale) - shape(0, 1) / scale * (shape(0, 1) / scale);
  const Eigen::Vector2d along = eigen.eigenvectors().col(1), across(along[1], -along[0]);
  const auto in_space = [&](const Eigen::Vector2d& t) -> Eigen::Vector3d {
    const Eigen::Vector2d u = basis * t;
    return (f.frame * Eigen::Vector3d(u[0], u[1], f.gradient.dot(u))).normalized();
  };
  c.minimal_direction = in_space(across);
  c.maximal_direction = in_space(along);
  c.is_estimated =
    std::isfinite(c.gaussian) && std::isfinite(c.minimal) && std::isfinite(c.maximal);
  return c.is_estimated ? c : Principal_curvatures();
}

// A point of the neighborhood, relative to the vertex, and its normal, zero if it has none.
struct Curvature_sample
{
  Eigen::Vector3d offset;
  Eigen::Vector3d normal;
  double weight;
};

// The second derivatives of the graph z = f(u), f(0) = 0, over the plane normal to a given unit vector, by least squares. To
// points a polynomial of degree 2 or 3 is fitted; unknown are its derivatives at 0. Where there are normals, the vector is that of
// the vertex, the gradient is 0, and every normal tells of the second derivatives and, with degree 3, of the third ones.
class Curvature_fit
{
  static constexpr double root_2 = 1.41421356237309505, root_3 = 1.73205080756887729;
  using Row = Eigen::Matrix<double, 9, 1>; // of a matrix with up to 9 columns
  using Samples = std::vector<Curvature_sample>;

public:
  // The Frobenius norm of the pseudoinverse, beyond which the samples do not determine the fit. Two
  // rings of an even mesh have 5 in the interior and hundreds at the border, where three have 30.
  static constexpr double max_condition = 50;

  // whether the points determine all derivatives
  bool fit(const Samples& samples, const Eigen::Vector3d& normal, int degree)
  {
    if (!begin(samples, normal)) return false;
    for (const Curvature_sample& s : samples) add_point(s);
    if (!(degree == 3 ? solve<9>(2) : solve<5>(2))) return false;
    set_derivatives(solution_.head<2>(), solution_.segment<3>(2));
    return true;
  }

  // whether the normals do, and the points of samples without one
  bool fit_normals(const Samples& samples, const Eigen::Vector3d& normal, int degree)
  {
    if (!begin(samples, normal)) return false;
    for (const Curvature_sample& s : samples) add_normal(s, degree == 3);
    if (!(degree == 3 ? solve<7>(3) : solve<3>(3))) return false;
    set_derivatives({0, 0}, -solution_.head<3>());
    return true;
  }

  // The fitted surface at the vertex.
  Principal_curvatures curvatures(double scale) const
  {
    return principal_curvatures(graph_, scale);
  }

private:
  bool begin(const Samples& samples, const Eigen::Vector3d& normal)
  {
    graph_.frame.col(2) = normal;
    graph_.frame.col(0) = normal.unitOrthogonal();
    graph_.frame.col(1) = normal.cross(graph_.frame.col(0));
    rows_.clear();
    right_sides_.clear();
    return set_units(samples);
  }

  // Units in which the second moments of the samples are 1 make the fit independent of affine maps
  // of the plane: quads may be long or skew.
  bool set_units(const Samples& samples)
  {
    Eigen::Matrix2d moments = Eigen::Matrix2d::Zero();
    for (const Curvature_sample& s : samples) {
      const Eigen::Vector2d u = graph_.frame.leftCols<2>().transpose() * s.offset;
      moments += u * u.transpose() / double(samples.size());
    }
    constexpr double on_a_line = 1e-12;
    const double determinant = moments.determinant();
    if (!(determinant > on_a_line * moments.trace() * moments.trace())) return false;
    units_ = Eigen::LLT<Eigen::Matrix2d>(moments).matrixL();
    inverse_units_ = units_.inverse();
    return true;
  }

  static double weight_of(const Curvature_sample& s, const Eigen::Vector2d& u)
  {
    return s.weight / (1 + u.squaredNorm() / 2);
  }

  void add_point(const Curvature_sample& s)
  {
    const Eigen::Vector3d p = graph_.frame.transpose() * s.offset;
    const Eigen::Vector2d u = inverse_units_ * p.head<2>();
    const double x = u[0], y = u[1];
    Row value;
    value << x, y, x * x / 2, x * y / root_2, y * y / 2, x * x * x / 6, x * x * y / (2 * root_3),
      x * y * y / (2 * root_3), y * y * y / 6;
    if (x != 0 || y != 0) add_row(weight_of(s, u), value, p[2]);
  }

  // Let m be half-way between the normals of frame and sample. What is perpendicular to it, as the change n of the normals and a
  // part of the offset are, is turned into the plane of the frame, where n and u then are; h is the rest of the offset. In the
  // direction t of u, |u| = r, with the shape operator S and its derivative C,
  //   n.t / r = S(t,t) + r/2 C(t,t,t) + r^2 E,   12 h / r^2 = r C(t,t,t) + 3 r^2 E,
  // and E, h and C vanish on spheres and circular cylinders, of any triangulation. From both E is eliminated. What tells of C
  // alone, and of S across t, where E is another one, has a small weight: it is for rings that do not tell otherwise.
  void add_normal(const Curvature_sample& s, bool is_cubic)
  {
    constexpr double part = 0.3; // less suits exact normals, more those that are estimated
    const Eigen::Vector3d p = graph_.frame.transpose() * s.offset;
    const bool has_normal = !s.normal.isZero(0);
    Eigen::Vector3d m(0, 0, 1);
    if (has_normal) m = (m + graph_.frame.transpose() * s.normal).normalized();
    const double h = p.dot(m);
    const Eigen::Vector2d u =
      inverse_units_ * (p.head<2>() - m.head<2>() * ((h + p[2]) / (1 + m[2])));
    const double r = u.norm(), weight = weight_of(s, u);
    if (!(r > 0)) return;
    const double x = u[0] / r, y = u[1] / r;
    Row along, third, across;
    along << x * x, root_2 * x * y, y * y, 0, 0, 0, 0, 0, 0;
    third << 0, 0, 0, x * x * x, root_3 * x * x * y, root_3 * x * y * y, y * y * y, 0, 0;
    if (!has_normal) return add_row(weight, along + r / 3 * third, -2 * h / (r * r));
    const Eigen::Vector2d n = 2 * units_.transpose() * m.head<2>() / r;
    const double of_third = h / (r * r);
    add_row(weight, along + r / 6 * third, n[0] * x + n[1] * y - (is_cubic ? 4 : 6) * of_third);
    across << -x * y, (x * x - y * y) / root_2, x * y, -r / 2 * x * x * y,
      r / 2 * (x * x - 2 * y * y) * x / root_3, r / 2 * (2 * x * x - y * y) * y / root_3,
      r / 2 * x * y * y, 0, 0;
    add_row(part * weight, across, n[1] * x - n[0] * y);
    if (is_cubic) add_row(part * weight, r / 2 * third, 6 * of_third);
  }

  void add_row(double weight, const Row& row, double right_side)
  {
    rows_.emplace_back(weight * row);
    right_sides_.push_back(weight * right_side);
  }

  // By normal equations, whose solution is then corrected by what it leaves of the right side: as accurate as by
  // orthogonal transformations. The columns of each degree, of which the lowest has so many, count as if they had a mean
  // square of 1. That, the coefficients of binomials in front of the unknowns and Frobenius norms make the condition
  // independent of the choice of the frame.
  template <int unknowns>
  bool solve(int of_lowest)
  {
    using Vector = Eigen::Matrix<double, unknowns, 1>;
    using Square = Eigen::Matrix<double, unknowns, unknowns>;
    Square matrix = Square::Zero();
    for (const Row& row : rows_)
      matrix.noalias() += row.head<unknowns>() * row.head<unknowns>().transpose();
    Vector size; // of the columns
    for (int first = 0, n = of_lowest; first < unknowns; first += n, ++n)
      size.segment(first, n).setConstant(std::sqrt(matrix.diagonal().segment(first, n).sum() / n));
    if (!(size.minCoeff() > 0)) return false;
    const Eigen::LLT<Square> factors(matrix);
    if (int(factors.info()) != 0) return false; // Eigen's name of 0 is a macro of X11
    Eigen::Matrix<double, unknowns, unknowns, Eigen::RowMajor> inverse; // of the lower triangle
    for (int i = 0; i < unknowns; ++i) {
      inverse.row(i) = Square::Identity().row(i);
      for (int k = 0; k < i; ++k) inverse.row(i) -= factors.matrixLLT()(i, k) * inverse.row(k);
      inverse.row(i) *= 1 / factors.matrixLLT()(i, i);
    }
    if (!((inverse * size.asDiagonal()).norm() <= max_condition)) return false;
    Vector solution = Vector::Zero();
    for (int i = 0; i < 2; ++i) {
      Vector right_side = Vector::Zero();
      for (std::size_t k = 0; k < rows_.size(); ++k) {
        const auto row = rows_[k].head<unknowns>();
        right_side += (right_sides_[k] - row.dot(solution)) * row;
      }
      solution += inverse.transpose() * (inverse * right_side);
    }
    solution_.head<unknowns>() = solution;
    return true;
  }

  void set_derivatives(const Eigen::Vector2d& first, const Eigen::Vector3d& second)
  {
    Eigen::Matrix2d hessian;
    hessian << second[0], second[1] / root_2, second[1] / root_2, second[2];
    graph_.gradient = inverse_units_.transpose() * first;
    graph_.hessian = inverse_units_.transpose() * hessian * inverse_units_;
  }

  Graph_derivatives graph_;
  Eigen::Matrix2d units_, inverse_units_; // lower triangular
  std::vector<Row> rows_;
  std::vector<double> right_sides_;
  Row solution_ = Row::Zero();
};

// What is known of the vertices of a mesh. A normal is a unit vector or zero.
struct Curvature_data
{
  using Index = Level_connectivity::Index;

  struct Vertex
  {
    Eigen::Vector3d point, normal;
  };

  // the normal of the plane of the fit
  const Eigen::Vector3d& frame_normal(Index v) const
  {
    return fits_normals && vertices[v].normal.isZero(0) ? face_normals[v] : vertices[v].normal;
  }

  Level_connectivity level;
  std::vector<Vertex> vertices;
  bool fits_normals =
    false; // otherwise normals come from the faces, and only tell the sides of the surface apart
  std::vector<Eigen::Vector3d> face_normals; // where normals are fitted
};

// The vertices in an order in which near ones follow each other: in a refined mesh those of old vertices, edges and faces
// have numbers far apart, and what looks at one after the other waits for memory most of the time.
inline std::vector<Level_connectivity::Index> order_by_faces(const Level_connectivity& level)
{
  using Index = Level_connectivity::Index;
  std::vector<Index> order;
  std::vector<char> is_listed(level.number_of_vertices(), 0);
  const auto add = [&](Index v) {
    if (is_listed[v] == 0) order.push_back(v);
    is_listed[v] = 1;
  };
  for (Index f = 0; f < level.number_of_faces(); ++f)
    for_each_halfedge_of_face(level, f, [&](Index h) { add(level.target(h)); });
  for (Index v = 0; v < level.number_of_vertices(); ++v) add(v);
  return order;
}

// The curvatures at one vertex after the other. The neighborhood of a vertex grows by rings, each
// the vertices that share a face with the ring before, until a cubic is determined; where none is,
// a quadric is taken.
class Curvature_estimation
{
public:
  using Index = Level_connectivity::Index;

  explicit Curvature_estimation(const Curvature_data& data)
    : data_(data)
  {}

  Principal_curvatures operator()(Index v)
  {
    const Eigen::Vector3d& normal = data_.frame_normal(v);
    if (data_.level.is_isolated(v) || normal.isZero(0)) return {};
    takes_normals_ = data_.fits_normals && !data_.vertices[v].normal.isZero(0);
    vertex_ = v;
    for (int degree : {3, 2}) {
      neighbors_.clear();
      ring_.assign(1, v);
      number_of_rings_ = 0;
      while (number_of_rings_ < max_rings && grow(normal)) {
        if (neighbors_.size() < least_number_of_neighbors(degree)) continue;
        const double scale = set_samples(v, normal);
        if (scale > 0 && (takes_normals_ ? fit_.fit_normals(samples_, normal, degree)
                                         : fit_.fit(samples_, normal, degree)))
          return fit_.curvatures(scale);
      }
    }
    return {};
  }

private:
  static constexpr int max_rings = 4;
  static constexpr double least_weight = 1. / 16; // 151 degrees

  // Without normals somewhat more equations than unknowns; with them there are three a neighbor.
  std::size_t least_number_of_neighbors(int degree) const
  {
    if (takes_normals_) return degree == 3 ? 3 : 2;
    return degree == 3 ? 12 : 6;
  }

  // Adds a ring; false if it is empty. What faces the other way belongs to another part of the
  // surface and is not entered.
  bool grow(const Eigen::Vector3d& normal)
  {
    next_ring_.clear();
    for (Index v : ring_) add_face_neighbors(v);
    std::sort(next_ring_.begin(), next_ring_.end());
    next_ring_.erase(std::unique(next_ring_.begin(), next_ring_.end()), next_ring_.end());
    const auto is_known_or_behind = [&](Index v) {
      return v == vertex_ || std::binary_search(neighbors_.begin(), neighbors_.end(), v) ||
             weight(v, normal) <= (takes_normals_ ? least_weight : 0);
    };
    next_ring_.erase(std::remove_if(next_ring_.begin(), next_ring_.end(), is_known_or_behind),
                     next_ring_.end());
    const auto old_size = static_cast<std::ptrdiff_t>(neighbors_.size());
    neighbors_.insert(neighbors_.end(), next_ring_.begin(), next_ring_.end());
    std::inplace_merge(neighbors_.begin(), neighbors_.begin() + old_size, neighbors_.end());
    ring_.swap(next_ring_);
    ++number_of_rings_;
    return !ring_.empty();
  }

  void add_face_neighbors(Index v)
  {
    const Level_connectivity& level = data_.level;
    for_each_halfedge_to(level, v, [&](Index h) { // the one after h has the edge of the next one
      next_ring_.push_back(level.source(h));
      if (!level.is_border(h))
        for (Index g = level.next(level.next(h)); level.next(g) != h; g = level.next(g))
          next_ring_.push_back(level.target(g));
    });
  }

  // The cosine of the angle to the normal; where normals are fitted, which tell also what is steep, the square of that of
  // half the angle.
  double weight(Index v, const Eigen::Vector3d& normal) const
  {
    const Eigen::Vector3d& n = data_.vertices[v].normal;
    if (n.isZero(0)) return 1;
    return takes_normals_ ? (1 + n.dot(normal)) / 2 : n.dot(normal);
  }

  // Lengths are divided by the largest coordinate, which is returned.
  double set_samples(Index v, const Eigen::Vector3d& normal)
  {
    double scale = 0;
    samples_.clear();
    for (Index w : neighbors_) {
      const Eigen::Vector3d offset = data_.vertices[w].point - data_.vertices[v].point;
      samples_.push_back({offset, fitted_normal(w), weight(w, normal)});
      scale = (std::max)(scale, offset.lpNorm<Eigen::Infinity>());
    }
    for (Curvature_sample& s : samples_) s.offset *= 1 / scale;
    samples_.push_back({Eigen::Vector3d::Zero(), fitted_normal(v), 1});
    return scale;
  }

  Eigen::Vector3d fitted_normal(Index v) const
  {
    return takes_normals_ ? data_.vertices[v].normal : Eigen::Vector3d::Zero();
  }

  const Curvature_data& data_;
  Curvature_fit fit_;
  Index vertex_ = 0;
  bool takes_normals_ = false; // the vertex has a normal, which is fitted, too
  int number_of_rings_ = 0;
  std::vector<Index> neighbors_, ring_, next_ring_; // without the vertex; `neighbors_` is sorted
  std::vector<Curvature_sample> samples_;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_CURVATURE_CURVATURE_ESTIMATION_H

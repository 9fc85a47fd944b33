// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Samples of surfaces to be interpolated, and how far an interpolating surface is from them.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_INTERPOLATION_CASES_H
#define CGAL_PN_SUBDIVISION_3_TEST_INTERPOLATION_CASES_H

#include "Interpolation_runs.h"
#include "Sampled_surfaces.h"

namespace interpolation_cases {

using reference::Real;
using reference::Vector;
using test_meshes::Control_mesh;

// the distance of a point from a surface, to first order
using Distance = std::function<double(const Vector&)>;

inline Vector ellipsoid_axes()
{
  return {1.5, 1, 0.8L};
}
inline sampled_surfaces::Sample on_ellipsoid(const Vector& direction)
{
  const Vector axes = ellipsoid_axes();
  const Vector p = axes.cwiseProduct(direction.normalized());
  return {p, p.cwiseQuotient(axes).cwiseQuotient(axes)};
}
inline double to_ellipsoid(const Vector& p)
{
  const Vector axes = ellipsoid_axes();
  const Vector q = p.cwiseQuotient(axes);
  return double((q.squaredNorm() - 1) / (2 * q.cwiseQuotient(axes).norm()));
}
inline double to_torus(const Vector& p) // that of Sampled_surfaces
{
  const Real r = std::hypot(p[0], p[1]) - 2.5L;
  return double(std::hypot(r, p[2]) - 1);
}

inline double to_waves(const Vector& p) // the graph of Sampled_surfaces
{
  const auto sample = sampled_surfaces::on_waves(p[0], p[1]);
  return double((p[2] - sample.point[2]) / sample.normal.norm());
}

// the faces of a cube cut in n x n, laid on an ellipsoid: valence 3 at the corners
inline Control_mesh ellipsoid_quads(int n)
{
  Control_mesh mesh{"ellipsoid", {}, {}, {}};
  std::map<std::array<int, 3>, int> number;
  const auto vertex = [&](const std::array<int, 3>& c) {
    const auto found = number.emplace(c, int(number.size()));
    if (found.second) {
      Vector d;
      for (std::size_t k = 0; k < 3; ++k)
        d[Eigen::Index(k)] = std::tan(sampled_surfaces::pi / 4 * (2 * Real(c[k]) / n - 1));
      sampled_surfaces::add(mesh, on_ellipsoid(d));
    }
    return found.first->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const int side : {0, n})
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          reference::Face face;
          for (const auto& [di, dj] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
            std::array<int, 3> c{};
            c[axis] = side;
            c[(axis + 1) % 3] = side == 0 ? j + dj : i + di;
            c[(axis + 2) % 3] = side == 0 ? i + di : j + dj;
            face.push_back(vertex(c));
          }
          mesh.faces.push_back(face);
        }
  return mesh;
}

inline Control_mesh ellipsoid_triangles(int rounds)
{
  return sampled_surfaces::scattered(rounds, 0, 1, on_ellipsoid);
}

inline Control_mesh torus(int n)
{
  sampled_surfaces::Numbers u;
  for (int i = 0; i <= n; ++i) u.push_back(Real(i) / n);
  return sampled_surfaces::torus(u, u, test_meshes::Cells::quads);
}

// turns, moves and scales
inline Vector moved(const Vector& p, Real scale)
{
  const Vector axis = Vector(1, 2, -0.5L).normalized();
  const Eigen::Matrix<Real, 3, 3> turn = Eigen::AngleAxis<Real>(0.7L, axis).toRotationMatrix();
  return scale * (turn * p) + (scale == 0 ? Vector(Vector::Zero()) : Vector(0.3L, -0.2L, 0.5L));
}

// the mean square of the distances of the limit points at some level
template <class Scheme>
double rms_error(const Surface_mesh& net, const Scheme& scheme, const Distance& distance,
                 unsigned rounds = 2)
{
  Surface_mesh mesh = net;
  const Limits all = Limit_runs<Scheme>::refined(mesh, scheme, rounds);
  double sum = 0;
  for (const auto& limit : all.at) {
    const double d = distance(limit_cases::to_vector(limit.point));
    sum += d * d;
  }
  return std::sqrt(sum / double(all.at.size()));
}

// the integral of |grad H|^2 over the limit surface, H linear between the vertices of some level
template <class Scheme>
double unfairness(const Surface_mesh& net, const Scheme& scheme, unsigned rounds = 2)
{
  Surface_mesh mesh = net;
  const Limits all = Limit_runs<Scheme>::refined(mesh, scheme, rounds);
  double sum = 0;
  const auto add = [&](const std::array<std::size_t, 3>& v) {
    Vector e[3], gradient = Vector::Zero();
    for (std::size_t k = 0; k < 3; ++k)
      e[k] = limit_cases::to_vector(all.at[v[(k + 2) % 3]].point) -
             limit_cases::to_vector(all.at[v[(k + 1) % 3]].point);
    const Vector n = e[0].cross(e[1]); // twice the area long
    for (std::size_t k = 0; k < 3; ++k) gradient += Real(all.at[v[k]].mean) * n.cross(e[k]);
    gradient /= n.squaredNorm();
    sum += double(gradient.squaredNorm() * n.norm() / 2);
  };
  for (auto f : mesh.faces()) {
    std::vector<std::size_t> corners;
    for (auto v : mesh.vertices_around_face(mesh.halfedge(f))) corners.push_back(v.idx());
    for (std::size_t k = 2; k < corners.size(); ++k) add({corners[0], corners[k - 1], corners[k]});
  }
  return sum;
}

struct Interpolated
{
  Surface_mesh mesh;
  Report report;
};

template <class Scheme>
Interpolated interpolated(const Control_mesh& control, const Scheme& scheme,
                          const Options& options = Options())
{
  Interpolated result{to_surface_mesh(control), {}};
  result.report = Interpolation_runs<Scheme>::interpolate(result.mesh, scheme, options);
  return result;
}

inline Options strict()
{
  Options options;
  options.mode = PN::Limit_interpolation::Mode::strict;
  return options;
}

// the control net as test data
inline Control_mesh control_net(Surface_mesh& mesh, const Control_mesh& control)
{
  Control_mesh net = control;
  const auto normals = normal_map(mesh);
  for (auto v : mesh.vertices()) {
    const auto& p = mesh.point(v);
    const auto& n = normals[v];
    net.points[v] = {p.x(), p.y(), p.z()};
    net.normals[v] = {n.x(), n.y(), n.z()};
  }
  return net;
}

inline Vector point_of(const Control_mesh& mesh, std::size_t v)
{
  return {mesh.points[v][0], mesh.points[v][1], mesh.points[v][2]};
}

} // namespace interpolation_cases

#endif // CGAL_PN_SUBDIVISION_3_TEST_INTERPOLATION_CASES_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_TEST_PART_FILES_H
#define PN_TEST_PART_FILES_H

#include "io/mesh_io.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

// Parts of known planes and cylinders, and their files.

namespace pn_subdivide {

// Macros do not take braces.
inline Triple triple(double x, double y, double z)
{
  return {x, y, z};
}
inline Triple sum(const Triple& a, const Triple& b, double factor = 1)
{
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}
inline Triple difference(const Triple& a, const Triple& b)
{
  return sum(a, b, -1);
}
inline Triple cross(const Triple& a, const Triple& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double dot(const Triple& a, const Triple& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline double length(const Triple& a)
{
  return std::hypot(a[0], a[1], a[2]);
}
// zero if there is no direction
inline Triple unit(const Triple& a)
{
  const double size = length(a);
  return size > 0 ? Triple{a[0] / size, a[1] / size, a[2] / size} : Triple{0, 0, 0};
}
inline double distance(const Triple& a, const Triple& b)
{
  return length(difference(a, b));
}
inline double distance_to_nearest(const Triple& p, const std::vector<Triple>& points)
{
  double least = HUGE_VAL;
  for (const Triple& q : points) least = (std::min)(least, distance(p, q));
  return least;
}
// so many digits, or decimals
struct Digits
{
  int number = 17;
  bool is_fixed = false;
};
inline std::string text(const Triple& a, const Digits& digits = {})
{
  std::ostringstream s;
  s.precision(digits.number);
  if (digits.is_fixed) s << std::fixed;
  for (const double x : a) s << ' ' << x;
  return s.str();
}
inline double largest_distance(const std::vector<Triple>& a, const std::vector<Triple>& b)
{
  EXPECT_EQ(a.size(), b.size());
  double largest = 0;
  for (std::size_t i = 0; i < (std::min)(a.size(), b.size()); ++i)
    largest = (std::max)(largest, distance(a[i], b[i]));
  return largest;
}

// Faces that are oriented outwards, of any degree.
struct Part
{
  std::vector<Triple> points;
  std::vector<std::vector<std::size_t>> faces;

  // points that are there already are the same ones
  std::size_t vertex(const Triple& p)
  {
    for (std::size_t v = 0; v < points.size(); ++v)
      if (distance(points[v], p) < 1e-9) return v;
    points.push_back(p);
    return points.size() - 1;
  }
  // corners in one place are one
  void add(const std::vector<Triple>& corners)
  {
    std::vector<std::size_t> face;
    for (const Triple& p : corners)
      if (const std::size_t v = vertex(p); std::find(face.begin(), face.end(), v) == face.end())
        face.push_back(v);
    faces.push_back(face);
  }
  // with faces of its own
  void add(const Part& other, const Triple& shift, bool is_turned)
  {
    const std::size_t first = points.size();
    for (const Triple& p : other.points)
      points.push_back({p[0] + shift[0], p[1] + shift[1], p[2] + shift[2]});
    for (std::vector<std::size_t> face : other.faces) {
      for (std::size_t& v : face) v += first;
      if (is_turned) std::reverse(face.begin(), face.end());
      faces.push_back(face);
    }
  }
  void triangulate()
  {
    std::vector<std::vector<std::size_t>> triangles;
    for (const auto& f : faces)
      for (std::size_t i = 2; i < f.size(); ++i) triangles.push_back({f[0], f[i - 1], f[i]});
    faces = triangles;
  }
  // by Newell's formula, about the first corner
  Triple area(std::size_t f) const
  {
    Triple result{};
    for (std::size_t i = 0; i < faces[f].size(); ++i) {
      const auto at = [&](std::size_t k) {
        return difference(points[faces[f][k % faces[f].size()]], points[faces[f][0]]);
      };
      result = sum(result, cross(at(i), at(i + 1)), 0.5);
    }
    return result;
  }
  // numbers of vertices by name, which only these files have
  using Columns_by_name = std::vector<std::pair<std::string, std::vector<double>>>;
  std::string ply(const std::vector<Triple>& normals = {}, const Columns_by_name& columns = {},
                  const Digits& of_normals = {}) const
  {
    std::string s = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(points.size()) + "\n";
    for (const char* const name : {"x", "y", "z", "nx", "ny", "nz"})
      if (name[0] != 'n' || !normals.empty()) s += "property double " + std::string(name) + "\n";
    for (const auto& [name, values] : columns) s += "property double " + name + "\n";
    return s + "element face " + std::to_string(faces.size()) +
           "\nproperty list uchar int vertex_indices\nend_header\n" +
           rows(normals, columns, of_normals);
  }
  std::string off(const std::vector<Triple>& normals = {}, const Digits& of_normals = {}) const
  {
    return (normals.empty() ? "OFF\n" : "NOFF\n") + std::to_string(points.size()) + " " +
           std::to_string(faces.size()) + " 0\n" + rows(normals, {}, of_normals);
  }
  std::string obj(const std::vector<Triple>& normals = {}, const Digits& of_normals = {}) const
  {
    std::ostringstream s;
    for (const Triple& p : points) s << "v" << text(p) << "\n";
    for (const Triple& n : normals) s << "vn" << text(n, of_normals) << "\n";
    for (const auto& f : faces) {
      s << "f";
      for (const std::size_t v : f) {
        s << ' ' << v + 1;
        if (!normals.empty()) s << "//" << v + 1;
      }
      s << "\n";
    }
    return s.str();
  }
  // with a normal for each corner, a function of the face and the number of the corner there
  template <class Normal>
  std::string obj_of_corners(const Normal& normal, const Digits& of_normals = {}) const
  {
    std::string s = Part{points, {}}.obj(), lines;
    std::size_t corner = 0;
    for (std::size_t f = 0; f < faces.size(); ++f) {
      lines += "f";
      for (std::size_t i = 0; i < faces[f].size(); ++i) {
        s += "vn" + text(normal(f, i), of_normals) + "\n";
        lines += " " + std::to_string(faces[f][i] + 1) + "//" + std::to_string(++corner);
      }
      lines += "\n";
    }
    return s + lines;
  }
  // text, with coordinates that are a function of those here
  template <class Rounded>
  std::string stl(Rounded rounded, int digits = 17) const
  {
    std::ostringstream s;
    s.precision(digits);
    s << "solid part\n";
    for (const auto& f : faces) {
      s << "facet normal 0 0 0\nouter loop\n";
      for (const std::size_t v : f) {
        s << "vertex";
        for (const double x : points[v]) s << ' ' << rounded(x);
        s << "\n";
      }
      s << "endloop\nendfacet\n";
    }
    return s.str() + "endsolid part\n";
  }
  // every triangle has corners of its own, which are off by a unit in the last place here and there
  std::string stl() const
  {
    const auto rounded = [state = 1u](double coordinate) mutable {
      state = state * 1664525u + 1013904223u;
      const auto x = static_cast<float>(coordinate);
      return double((state >> 24) % 5 == 0 ? std::nextafter(x, 10.f) : x);
    };
    return stl(rounded, 9);
  }

private:
  std::string rows(const std::vector<Triple>& normals, const Columns_by_name& columns,
                   const Digits& of_normals) const
  {
    std::ostringstream s;
    s.precision(17);
    for (std::size_t v = 0; v < points.size(); ++v) {
      s << text(points[v]).substr(1) << (normals.empty() ? "" : text(normals[v], of_normals));
      for (const auto& [name, values] : columns) s << ' ' << values[v];
      s << "\n";
    }
    for (const auto& f : faces) {
      s << f.size();
      for (const std::size_t v : f) s << ' ' << v;
      s << "\n";
    }
    return s.str();
  }
};

inline Triple on_circle(double radius, double degrees, double z)
{
  const double angle = degrees * 3.14159265358979323846 / 180;
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

inline Part triangulated(Part part)
{
  part.triangulate();
  return part;
}

// The boundary of a box, each side in m x m quads.
inline Part box_of_squares(int m, const Triple& low, const Triple& size)
{
  Part part;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const int end : {0, 1})
      for (int i = 0; i < m; ++i)
        for (int j = 0; j < m; ++j) {
          std::vector<Triple> face;
          for (const auto& [a, b] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
            Triple p{};
            p[axis] = end;
            p[(axis + 1) % 3] = double(i + (end == 1 ? a : b)) / m;
            p[(axis + 2) % 3] = double(j + (end == 1 ? b : a)) / m;
            for (std::size_t k = 0; k < 3; ++k) p[k] = low[k] + size[k] * p[k];
            face.push_back(p);
          }
          part.add(face);
        }
  return part;
}

// Rings of n vertices about the z axis, closed by fans about two poles; the point of the angles from the axis and about it is
// a function.
template <class Point>
Part ball_of(std::size_t n, std::size_t rings, const Point& at)
{
  const double pi = std::acos(-1.);
  Part ball;
  ball.points.push_back(at(0., 0.));
  for (std::size_t j = 1; j < rings; ++j)
    for (std::size_t i = 0; i < n; ++i)
      ball.points.push_back(at(pi * double(j) / double(rings), 2 * pi * double(i) / double(n)));
  ball.points.push_back(at(pi, 0.));
  const auto number = [n](std::size_t j, std::size_t i) { return 1 + n * (j - 1) + i % n; };
  for (std::size_t i = 0; i < n; ++i) {
    ball.faces.push_back({0, number(1, i), number(1, i + 1)});
    for (std::size_t j = 1; j + 1 < rings; ++j)
      ball.faces.push_back(
        {number(j, i), number(j + 1, i), number(j + 1, i + 1), number(j, i + 1)});
    ball.faces.push_back({number(rings - 1, i), ball.points.size() - 1, number(rings - 1, i + 1)});
  }
  return ball;
}
inline Triple on_sphere(double t, double u)
{
  return {std::sin(t) * std::cos(u), std::sin(t) * std::sin(u), std::cos(t)};
}

// n x m quads about the z axis
struct Torus : Part
{
  std::vector<Triple> normals;

  Torus(std::size_t n, std::size_t m, double radius, double tube_radius)
  {
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < m; ++j) {
        const double u = 360. * double(i) / double(n), v = 360. * double(j) / double(m);
        const Triple rho_z = on_circle(1, v, 0);
        normals.push_back(on_circle(rho_z[0], u, rho_z[1]));
        points.push_back(sum(on_circle(radius, u, 0), normals.back(), tube_radius));
        const std::size_t k = (i + 1) % n, l = (j + 1) % m;
        faces.push_back({m * i + j, m * k + j, m * k + l, m * i + l});
      }
  }
};

// Of three lengths, about the origin; without its lid it has a border.
inline Part uneven_box(bool is_triangles = false, bool is_open = false)
{
  Part part;
  part.points = {{-1, -2, -3}, {1, -2, -3}, {1, 2, -3}, {-1, 2, -3},
                 {-1, -2, 3},  {1, -2, 3},  {1, 2, 3},  {-1, 2, 3}};
  part.faces = {{3, 2, 1, 0}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}, {4, 5, 6, 7}};
  if (is_open) part.faces.pop_back();
  if (is_triangles) part.triangulate();
  return part;
}

// m x n squares above the plane, their corners (i, j) one after the other.
template <class Height>
Part grid(std::size_t m, std::size_t n, const Height& height)
{
  Part part;
  for (std::size_t i = 0; i <= m; ++i)
    for (std::size_t j = 0; j <= n; ++j)
      part.points.push_back({double(i), double(j), double(height(int(i), int(j)))});
  for (std::size_t v = 0; v < m * (n + 1); ++v)
    if (v % (n + 1) < n) part.faces.push_back({v, v + n + 1, v + n + 2, v + 1});
  return part;
}
inline Part grid(std::size_t m, std::size_t n)
{
  return grid(m, n, [](int, int) { return 0; });
}

// From the plane z = 0 up; the corners below come first.
inline Part prism(const std::vector<Triple>& corners, double height)
{
  const std::size_t n = corners.size();
  Part part;
  part.points = corners;
  part.faces.resize(2);
  for (std::size_t i = 0; i < n; ++i) {
    part.points.push_back({corners[i][0], corners[i][1], height});
    part.faces[0].push_back(n - 1 - i);
    part.faces[1].push_back(n + i);
    part.faces.push_back({i, (i + 1) % n, n + (i + 1) % n, n + i});
  }
  return part;
}
inline Part regular_prism(int n, double height)
{
  std::vector<Triple> corners;
  for (int i = 0; i < n; ++i) corners.push_back(on_circle(1, 360. * i / n, 0));
  return prism(corners, height);
}

// n quads about a point above the plane; the others are on the unit circle.
inline Part cone_of_quads(std::size_t n)
{
  Part part;
  part.points = {{0, 0, 1}};
  for (std::size_t i = 0; i < 2 * n; ++i)
    part.points.push_back(on_circle(1, 180. * double(i) / double(n), 0));
  for (std::size_t i = 1; i < 2 * n; i += 2)
    part.faces.push_back({0, i, i + 1, (i + 1) % (2 * n) + 1});
  return part;
}

// A square plate of height 1 with a hole of radius 1, whose 24 sides, from an angle on, are rows of quads.
inline Part drilled_plate(int rows = 1, double width = 4, double from = 0)
{
  const auto outer = [width](double degrees, double z) {
    const Triple p = on_circle(1, degrees, z);
    const double largest = 2 * (std::max)(std::abs(p[0]), std::abs(p[1]));
    return Triple{width * p[0] / largest, width * p[1] / largest, z};
  };
  const auto inner = [](double degrees, double z) { return on_circle(1, degrees, z); };
  Part part;
  for (int i = 0; i < 24; ++i) {
    const double a = 15. * i + from, b = a + 15;
    part.add({inner(a, 0), inner(b, 0), outer(b, 0), outer(a, 0)});
    part.add({outer(a, 1), outer(b, 1), inner(b, 1), inner(a, 1)});
    for (int j = 0; j < rows; ++j) {
      const double low = double(j) / rows, high = double(j + 1) / rows;
      part.add({outer(a, low), outer(b, low), outer(b, high), outer(a, high)});
      part.add({inner(a, high), inner(b, high), inner(b, low), inner(a, low)});
    }
  }
  return part;
}

// Bands of n sides about the z axis, with flat ends. The profile has radii and heights, upwards; where it begins or ends
// on the axis there is a point.
using Profile = std::vector<std::array<double, 2>>;
inline Part turned(const Profile& profile, int n = 24, bool is_open_above = false)
{
  Part part;
  std::vector<Triple> bottom, top;
  for (int i = 0; i < n; ++i) {
    const double a = 360. * i / n, b = 360. * (i + 1) / n;
    bottom.push_back(on_circle(profile.front()[0], 360 - b, profile.front()[1]));
    top.push_back(on_circle(profile.back()[0], a, profile.back()[1]));
    for (std::size_t k = 0; k + 1 < profile.size(); ++k) {
      const auto [r, z] = profile[k];
      const auto [s, y] = profile[k + 1];
      part.add({on_circle(r, a, z), on_circle(r, b, z), on_circle(s, b, y), on_circle(s, a, y)});
    }
  }
  if (profile.front()[0] > 0) part.add(bottom);
  if (profile.back()[0] > 0 && !is_open_above) part.add(top);
  return part;
}

// A number "surface" of the user's for each face, whose degree is the same everywhere.
inline std::string with_own_surfaces(std::string ply, const std::string& degree)
{
  const std::string list = "property list uchar int vertex_indices\n", row = "\n" + degree + " ";
  ply.replace(ply.find(list), list.size(), list + "property int surface\n");
  for (std::size_t line = ply.find(row); line != std::string::npos; line = ply.find(row, line + 1))
    ply.insert(ply.find('\n', line + 1), " 77");
  return ply;
}

// edges of a PLY file, with a sharpness each
using Edge_tag = std::pair<std::array<int, 2>, double>;
inline std::string with_edges(std::string ply, const std::vector<Edge_tag>& edges)
{
  std::ostringstream rows;
  for (const auto& [ends, sharpness] : edges)
    rows << ends[0] << ' ' << ends[1] << ' ' << sharpness << "\n";
  ply.insert(ply.find("end_header"), "element edge " + std::to_string(edges.size()) +
                                       "\nproperty int vertex1\nproperty int vertex2\n"
                                       "property double sharpness\n");
  return ply + rows.str();
}

// Cylinders of radius 2 up to z = 1 and of radius 1 above.
inline Part shaft()
{
  return turned({{2, 0}, {2, 1}, {1, 1}, {1, 3}});
}

} // namespace pn_subdivide

#endif // PN_TEST_PART_FILES_H

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

// Faces that are oriented outwards, of any degree.
struct Part
{
  std::vector<Triple> points;
  std::vector<std::vector<std::size_t>> faces;

  // points that are there already are the same ones
  std::size_t vertex(const Triple& p)
  {
    for (std::size_t v = 0; v < points.size(); ++v)
      if (std::hypot(points[v][0] - p[0], points[v][1] - p[1], points[v][2] - p[2]) < 1e-9)
        return v;
    points.push_back(p);
    return points.size() - 1;
  }
  void add(const std::vector<Triple>& corners)
  {
    std::vector<std::size_t> face;
    for (const Triple& p : corners) face.push_back(vertex(p));
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
  std::string ply(const std::vector<Triple>& normals = {}) const
  {
    std::ostringstream s;
    s.precision(17);
    s << "ply\nformat ascii 1.0\nelement vertex " << points.size()
      << "\nproperty double x\nproperty double y\nproperty double z\n";
    if (!normals.empty()) s << "property double nx\nproperty double ny\nproperty double nz\n";
    s << "element face " << faces.size()
      << "\nproperty list uchar int vertex_indices\nend_header\n";
    for (std::size_t v = 0; v < points.size(); ++v) {
      for (const double x : points[v]) s << x << ' ';
      if (!normals.empty())
        for (const double x : normals[v]) s << x << ' ';
      s << "\n";
    }
    for (const auto& f : faces) {
      s << f.size();
      for (const std::size_t v : f) s << ' ' << v;
      s << "\n";
    }
    return s.str();
  }
  std::string obj() const
  {
    std::ostringstream s;
    s.precision(17);
    for (const Triple& p : points) s << "v " << p[0] << ' ' << p[1] << ' ' << p[2] << "\n";
    for (const auto& f : faces) {
      s << "f";
      for (const std::size_t v : f) s << ' ' << v + 1;
      s << "\n";
    }
    return s.str();
  }
  // every triangle has corners of its own, which are off by a unit in the last place here and there
  std::string stl() const
  {
    std::string s = "solid part\n";
    unsigned state = 1;
    for (const auto& f : faces) {
      s += "facet normal 0 0 0\nouter loop\n";
      for (const std::size_t v : f) {
        char line[100];
        std::array<float, 3> p{};
        for (std::size_t k = 0; k < 3; ++k) {
          state = state * 1664525u + 1013904223u;
          const auto x = static_cast<float>(points[v][k]);
          p[k] = (state >> 24) % 5 == 0 ? std::nextafter(x, 10.f) : x;
        }
        std::snprintf(line, sizeof line, "vertex %.9g %.9g %.9g\n", double(p[0]), double(p[1]),
                      double(p[2]));
        s += line;
      }
      s += "endloop\nendfacet\n";
    }
    return s + "endsolid part\n";
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

// A ball of 12 meridians and 6 parallels, with poles: the point of two of them is a function.
template <class Point>
Part ball_of(const Point& point)
{
  Part ball;
  for (int i = 0; i < 12; ++i)
    for (int j = 0; j < 6; ++j)
      if (j == 0)
        ball.add({point(0, 0), point(i + 1, 1), point(i, 1)});
      else if (j == 5)
        ball.add({point(i, 5), point(i + 1, 5), point(0, 6)});
      else
        ball.add({point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)});
  return ball;
}

// A square plate of width 4 and height 1 with a hole of radius 1, whose 24 sides are rows of quads.
inline Part drilled_plate(int rows = 1)
{
  const auto outer = [](double degrees, double z) {
    const Triple p = on_circle(1, degrees, z);
    const double largest = (std::max)(std::abs(p[0]), std::abs(p[1]));
    return Triple{2 * p[0] / largest, 2 * p[1] / largest, z};
  };
  const auto inner = [](double degrees, double z) { return on_circle(1, degrees, z); };
  Part part;
  for (int i = 0; i < 24; ++i) {
    const double a = 15. * i, b = a + 15;
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

// Bands of 24 sides about the z axis, with flat ends. The profile has radii and heights, upwards.
inline Part turned(const std::vector<std::array<double, 2>>& profile)
{
  Part part;
  std::vector<Triple> bottom, top;
  for (int i = 0; i < 24; ++i) {
    const double a = 15. * i, b = a + 15;
    bottom.push_back(on_circle(profile.front()[0], 345 - a, profile.front()[1]));
    top.push_back(on_circle(profile.back()[0], a, profile.back()[1]));
    for (std::size_t k = 0; k + 1 < profile.size(); ++k) {
      const auto [r, z] = profile[k];
      const auto [s, y] = profile[k + 1];
      part.add({on_circle(r, a, z), on_circle(r, b, z), on_circle(s, b, y), on_circle(s, a, y)});
    }
  }
  part.add(bottom);
  part.add(top);
  return part;
}

// Cylinders of radius 2 up to z = 1 and of radius 1 above.
inline Part shaft()
{
  return turned({{2, 0}, {2, 1}, {1, 1}, {1, 3}});
}

} // namespace pn_subdivide

#endif // PN_TEST_PART_FILES_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef PN_TEST_SYNTHETIC_PART_H
#define PN_TEST_SYNTHETIC_PART_H

// A tessellated part whose true surfaces are known: independent of the package.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace synthetic_parts {

using Vec = std::array<double, 3>;
constexpr double pi = 3.14159265358979323846;

inline Vec operator+(const Vec& a, const Vec& b)
{
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Vec operator-(const Vec& a, const Vec& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Vec operator*(double s, const Vec& a)
{
  return {s * a[0], s * a[1], s * a[2]};
}
inline double dot(const Vec& a, const Vec& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Vec cross(const Vec& a, const Vec& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double length(const Vec& a)
{
  return std::sqrt(dot(a, a));
}
inline Vec unit(const Vec& a)
{
  return (1 / length(a)) * a;
}

// the same numbers with every standard library
class Random
{
public:
  explicit Random(std::uint32_t seed)
    : engine_(seed)
  {}
  double operator()(double low, double high)
  {
    return low + (high - low) * (engine_() / 4294967296.);
  }
  int integer(int low, int high) // both included
  {
    return low + static_cast<int>(engine_() % static_cast<std::uint32_t>(high - low + 1));
  }
  bool chance(double p) { return (*this)(0, 1) < p; }
  template <class T>
  void shuffle(std::vector<T>& v)
  {
    for (std::size_t i = v.size(); i > 1; --i) std::swap(v[i - 1], v[engine_() % i]);
  }

private:
  std::mt19937 engine_;
};

enum class Kind { plane, cylinder, cone, sphere, torus };

inline const char* name_of(Kind k)
{
  static const char* const names[] = {"plane", "cylinder", "cone", "sphere", "torus"};
  return names[static_cast<int>(k)];
}

// point: on the plane, on the axis, center, apex; radius of a torus: circle of the tube's centers
struct True_surface
{
  Kind kind = Kind::plane;
  Vec point{}, direction{};
  double radius = 0, tube_radius = 0, half_angle = 0;
};

// from the surface, outside (or above) positive
inline double signed_distance(const True_surface& s, const Vec& p)
{
  const Vec d = p - s.point;
  const double z = dot(d, s.direction), rho = length(d - z * s.direction);
  switch (s.kind) {
  case Kind::plane:
    return z;
  case Kind::cylinder:
    return rho - s.radius;
  case Kind::cone:
    return rho * std::cos(s.half_angle) - std::abs(z) * std::sin(s.half_angle);
  case Kind::sphere:
    return length(d) - s.radius;
  case Kind::torus:
    return std::hypot(rho - s.radius, z) - s.tube_radius;
  }
  return 0;
}

enum class File { exact, single, six_digits, seven_digits, six_decimals };

struct Part
{
  std::string name;
  std::vector<Vec> points;
  std::vector<std::vector<std::size_t>> faces;
  std::vector<std::size_t> surface_of_face;
  std::vector<True_surface> surfaces;
  File file = File::exact;

  std::size_t count(Kind k) const
  {
    return static_cast<std::size_t>(std::count_if(
      surfaces.begin(), surfaces.end(), [k](const True_surface& s) { return s.kind == k; }));
  }
};

inline double diagonal(const std::vector<Vec>& points)
{
  Vec low = points.at(0), high = low;
  for (const Vec& p : points)
    for (std::size_t c = 0; c < 3; ++c) {
      low[c] = (std::min)(low[c], p[c]);
      high[c] = (std::max)(high[c], p[c]);
    }
  return length(high - low);
}

inline double largest_coordinate(const Part& part)
{
  double m = 0;
  for (const Vec& p : part.points)
    for (double x : p) m = (std::max)(m, std::abs(x));
  return m;
}

// largest error of a coordinate of the file
inline double rounding(const Part& part)
{
  const double m = largest_coordinate(part);
  if (part.file == File::single) return std::ldexp(m, -24);
  if (part.file == File::six_decimals) return 0.5e-6;
  const double digit = std::pow(10., std::floor(std::log10(m)));
  if (part.file == File::six_digits) return 0.5e-5 * digit;
  if (part.file == File::seven_digits) return 0.5e-6 * digit;
  return std::ldexp(m, -50);
}

// --- checks ---

using Edge_faces = std::map<std::pair<std::size_t, std::size_t>, std::size_t>;

// face at each halfedge; throws if a halfedge has two
inline Edge_faces halfedges(const Part& part)
{
  Edge_faces result;
  for (std::size_t f = 0; f < part.faces.size(); ++f) {
    const auto& face = part.faces[f];
    for (std::size_t i = 0; i < face.size(); ++i)
      if (!result.emplace(std::make_pair(face[i], face[(i + 1) % face.size()]), f).second)
        throw std::logic_error(part.name + ": not a manifold");
  }
  return result;
}

inline double volume(const Part& part)
{
  double v = 0;
  const Vec o = part.points.at(0);
  for (const auto& f : part.faces)
    for (std::size_t i = 2; i < f.size(); ++i)
      v += dot(part.points[f[0]] - o, cross(part.points[f[i - 1]] - o, part.points[f[i]] - o)) / 6;
  return v;
}

// closed, oriented outward, every vertex used, every vertex with a single fan of faces
inline void check_closed(const Part& part)
{
  const Edge_faces faces = halfedges(part);
  std::vector<std::map<std::size_t, std::size_t>> next(part.points.size());
  for (const auto& [edge, f] : faces) {
    (void)f;
    if (faces.count({edge.second, edge.first}) == 0)
      throw std::logic_error(part.name + ": not closed");
  }
  for (const auto& face : part.faces)
    for (std::size_t i = 0; i < face.size(); ++i)
      next[face[i]][face[(i + 1) % face.size()]] = face[(i + face.size() - 1) % face.size()];
  for (const auto& ring : next) {
    if (ring.empty()) throw std::logic_error(part.name + ": isolated vertex");
    std::size_t n = 0, v = ring.begin()->first;
    do v = ring.at(v);
    while (++n <= ring.size() && v != ring.begin()->first);
    if (n != ring.size()) throw std::logic_error(part.name + ": two fans at a vertex");
  }
  if (!(volume(part) > 0)) throw std::logic_error(part.name + ": inside out");
}

// All vertices are on the surfaces of their faces, and each surface has faces.
inline void check_truth(const Part& part)
{
  const double bar = 4 * rounding(part) + std::ldexp(diagonal(part.points), -44);
  std::vector<bool> is_used(part.surfaces.size(), false);
  for (std::size_t f = 0; f < part.faces.size(); ++f) {
    const True_surface& s = part.surfaces.at(part.surface_of_face.at(f));
    is_used[part.surface_of_face[f]] = true;
    for (std::size_t v : part.faces[f])
      if (!(std::abs(signed_distance(s, part.points[v])) <= bar))
        throw std::logic_error(part.name + ": vertex off its " + name_of(s.kind));
  }
  if (std::find(is_used.begin(), is_used.end(), false) != is_used.end())
    throw std::logic_error(part.name + ": surface without faces");
}

// --- what files do to a part ---

struct Pose
{
  std::array<Vec, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  Vec shift{};
  double scale = 1;

  Vec turned(const Vec& v) const { return v[0] * axes[0] + v[1] * axes[1] + v[2] * axes[2]; }
  Vec operator()(const Vec& p) const { return scale * (turned(p) + shift); }
};

inline Pose random_pose(Random& random, double largest_shift, double log10_of_scale)
{
  Pose pose;
  Vec a, b;
  do {
    a = {random(-1, 1), random(-1, 1), random(-1, 1)};
    b = {random(-1, 1), random(-1, 1), random(-1, 1)};
  } while (length(cross(a, b)) < 0.1);
  pose.axes[0] = unit(a);
  pose.axes[2] = unit(cross(a, b));
  pose.axes[1] = cross(pose.axes[2], pose.axes[0]);
  for (double& x : pose.shift) x = random(-largest_shift, largest_shift);
  pose.scale = std::pow(10., random(-log10_of_scale, log10_of_scale));
  return pose;
}

inline void place(Part& part, const Pose& pose)
{
  for (Vec& p : part.points) p = pose(p);
  for (True_surface& s : part.surfaces) {
    s.point = pose(s.point);
    s.direction = pose.turned(s.direction);
    s.radius *= pose.scale;
    s.tube_radius *= pose.scale;
  }
}

inline double as_in_file(double x, File file)
{
  if (file == File::single) return static_cast<double>(static_cast<float>(x));
  if (file == File::exact) return x;
  char text[400];
  std::snprintf(text, sizeof text, file == File::six_decimals ? "%.*f" : "%.*g",
                file == File::seven_digits ? 7 : 6, x);
  return std::strtod(text, nullptr);
}

inline void write_as(Part& part, File file)
{
  part.file = file;
  for (Vec& p : part.points)
    for (double& x : p) x = as_in_file(x, file);
}

// the old number of each face
inline std::vector<std::size_t> renumber(Part& part, Random& random)
{
  std::vector<std::size_t> to(part.points.size()), order(part.faces.size());
  for (std::size_t i = 0; i < to.size(); ++i) to[i] = i;
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  random.shuffle(to);
  random.shuffle(order);
  Part old = part;
  for (std::size_t i = 0; i < to.size(); ++i) part.points[to[i]] = old.points[i];
  for (std::size_t i = 0; i < order.size(); ++i) {
    auto& face = old.faces[order[i]];
    for (std::size_t& v : face) v = to[v];
    std::rotate(face.begin(), face.begin() + random.integer(0, static_cast<int>(face.size()) - 1),
                face.end());
    part.faces[i] = face;
    part.surface_of_face[i] = old.surface_of_face[order[i]];
  }
  return order;
}

} // namespace synthetic_parts

#endif // PN_TEST_SYNTHETIC_PART_H

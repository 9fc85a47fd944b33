// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Control meshes with normals, and CGAL's four masks with their hosts, for the tests of PN_mask_3.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_PN_MASK_3_CASES_H
#define CGAL_PN_SUBDIVISION_3_TEST_PN_MASK_3_CASES_H

#include <CGAL/PN_cgal_masks_3/PN_mask_3.h>

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/subdivision_method_3.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <memory>
#include <random>
#include <vector>

using Triple = std::array<double, 3>;

struct Soup
{
  std::vector<Triple> points;
  std::vector<std::vector<std::size_t>> faces;
};

// A pentagonal prism with a roof: triangles, quads and a pentagon. Open: without one wall and two
// neighbouring roof faces.
inline Soup prism(bool closed)
{
  Soup soup;
  for (int level = 0; level < 2; ++level)
    for (double angle : {0.1, 1.2, 2.6, 3.9, 5.3})
      soup.points.push_back({2 * std::cos(angle), 1.7 * std::sin(angle), 1.5 * level - 0.8});
  soup.points.push_back({0.1, -0.2, 1.9});
  soup.faces.push_back({4, 3, 2, 1, 0});
  for (std::size_t i = 0; i < 5; ++i) {
    const std::size_t j = (i + 1) % 5;
    if (closed || i != 0) soup.faces.push_back({i, j, 5 + j, 5 + i});
    if (closed || i > 1) soup.faces.push_back({5 + i, 5 + j, 10});
  }
  return soup;
}

// Triangles, interior valences 3 to 7. Open: without two faces.
inline Soup pebble(bool closed)
{
  Soup soup;
  for (int i = 0; i < 7; ++i)
    soup.points.push_back({1.8 * std::cos(0.9 * i), 1.5 * std::sin(0.9 * i), 0.2 * (i % 3)});
  soup.points.push_back({0.2, 0.1, 1.4});
  soup.points.push_back({-0.1, 0.3, -1.3});
  soup.points.push_back({1.3, 0.6, 1.2});
  for (std::size_t i = 0; i < 7; ++i) {
    const std::size_t j = (i + 1) % 7;
    if (i == 0) {
      soup.faces.push_back({0, 1, 9});
      soup.faces.push_back({1, 7, 9});
      soup.faces.push_back({7, 0, 9});
    } else
      soup.faces.push_back({i, j, 7});
    if (closed || (i != 3 && i != 4)) soup.faces.push_back({j, i, 8});
  }
  return soup;
}

inline Soup on_sphere(Soup soup, double radius)
{
  for (Triple& p : soup.points) {
    const double scale = radius / std::hypot(p[0], p[1], p[2]);
    for (double& x : p) x *= scale;
  }
  return soup;
}

inline std::vector<Triple> random_normals(std::size_t n, unsigned int seed)
{
  std::mt19937 generator(seed);
  std::uniform_real_distribution<> coordinate(-1, 1);
  std::vector<Triple> normals(n);
  for (Triple& v : normals) {
    for (double& x : v) x = coordinate(generator);
    const double length = std::hypot(v[0], v[1], v[2]);
    for (double& x : v) x /= length;
  }
  return normals;
}

// A mesh with a normal map, made from a soup and its normals.
template <class Mesh_>
struct Control
{
  using Mesh = Mesh_;
  using Point_map = typename boost::property_map<Mesh, CGAL::vertex_point_t>::type;
  using Point = typename boost::property_traits<Point_map>::value_type;
  using Kernel = typename CGAL::Kernel_traits<Point>::Kernel;
  using FT = typename Kernel::FT;
  using Vector = typename Kernel::Vector_3;
  using Normals = std::map<typename boost::graph_traits<Mesh>::vertex_descriptor, Vector>;
  using Normal_map = boost::associative_property_map<Normals>;

  Mesh mesh;
  std::shared_ptr<Normals> store = std::make_shared<Normals>();
  Normal_map normals{*store};

  Control(const Soup& soup, const std::vector<Triple>& control_normals)
  {
    std::vector<Point> points;
    for (const Triple& p : soup.points) points.emplace_back(FT(p[0]), FT(p[1]), FT(p[2]));
    CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, soup.faces, mesh);
    std::size_t i = 0;
    for (auto v : vertices(mesh)) {
      const Triple& n = control_normals[i++];
      put(normals, v, Vector(FT(n[0]), FT(n[1]), FT(n[2])));
    }
  }

  auto point_normals()
  {
    return CGAL::PN_subdivision_3::Zipped_point_normal_map(get(CGAL::vertex_point, mesh), normals);
  }

  std::vector<Point> points() const
  {
    std::vector<Point> result;
    for (auto v : vertices(mesh)) result.push_back(get(get(CGAL::vertex_point, mesh), v));
    return result;
  }

  std::vector<Vector> normal_vectors() const
  {
    std::vector<Vector> result;
    for (auto v : vertices(mesh)) result.push_back(get(normals, v));
    return result;
  }
};

// CGAL's masks, each with its host and CGAL's own linear function.
#define PN_MASK_OF_CGAL(NAME, HOST, TRIANGLES)                                                     \
  struct NAME                                                                                      \
  {                                                                                                \
    static constexpr bool triangles = TRIANGLES;                                                   \
    template <class Mesh, class Map>                                                               \
    static auto mask(const Mesh& mesh, const Map& map)                                             \
    {                                                                                              \
      return CGAL::PN_subdivision_3::make_PN_mask_3<CGAL::NAME##_mask_3>(mesh, map);               \
    }                                                                                              \
    template <class Mesh, class Mask, class NP>                                                    \
    static void host(Mesh& mesh, const Mask& pn_mask, const NP& np)                                \
    {                                                                                              \
      CGAL::Subdivision_method_3::HOST(mesh, pn_mask, np);                                         \
    }                                                                                              \
    template <class Mesh, class NP>                                                                \
    static void linear(Mesh& mesh, const NP& np)                                                   \
    {                                                                                              \
      CGAL::Subdivision_method_3::NAME##_subdivision(mesh, np);                                    \
    }                                                                                              \
  };

PN_MASK_OF_CGAL(CatmullClark, PQQ, false)
PN_MASK_OF_CGAL(Loop, PTQ, true)
PN_MASK_OF_CGAL(DooSabin, DQQ, false)
PN_MASK_OF_CGAL(Sqrt3, Sqrt3, true)

#undef PN_MASK_OF_CGAL

template <class Scheme>
Soup control_soup(bool closed)
{
  return Scheme::triangles ? pebble(closed) : prism(closed);
}

template <class Scheme, class Control>
void subdivide_pn(Control& control, unsigned int rounds)
{
  const auto map = control.point_normals();
  Scheme::host(control.mesh, Scheme::mask(control.mesh, map),
               CGAL::parameters::vertex_point_map(map).number_of_iterations(rounds));
}

template <class Scheme, class Control>
void subdivide_linear(Control& control, unsigned int rounds)
{
  Scheme::linear(control.mesh, CGAL::parameters::number_of_iterations(rounds));
}

template <class P>
double distance(const P& a, const P& b)
{
  return std::sqrt(CGAL::to_double((a - b).squared_length()));
}

template <class T>
double largest_distance(const std::vector<T>& a, const std::vector<T>& b)
{
  if (a.size() != b.size()) return HUGE_VAL;
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!(distance(a[i], b[i]) <= largest)) largest = distance(a[i], b[i]);
  return largest;
}

#endif // CGAL_PN_SUBDIVISION_3_TEST_PN_MASK_3_CASES_H

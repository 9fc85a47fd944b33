// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Meshes with edges without length, coincident points and faces without area: what becomes of them turns with them, in each of
// the 48 exact ways to exchange and reflect the axes, and does not depend on numbers of vertices and faces and first corners.

#include "Mesh_cases.h"
#include "Mesh_shapes.h"

#include <CGAL/PN_limit_surface_3/subdivide_to_limit.h>
#include <CGAL/PN_limit_surface_3/tessellate.h>
#include <CGAL/PN_subdivision_3/detect_creases.h>
#include <CGAL/PN_subdivision_3/parameters/parameters.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/DooSabin_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
#include <CGAL/PN_subdivision_3/subdivide.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <functional>
#include <iterator>
#include <limits>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace PN = CGAL::PN_subdivision_3;
namespace np = CGAL::parameters;
using mesh_cases::built;
using mesh_cases::points;
using mesh_cases::Triple;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Points = std::vector<Triple>;

struct Control
{
  std::string name;
  Points points;
  std::vector<std::vector<int>> faces;
  std::vector<std::pair<int, int>> sharp = {}; // edges
};

// --- meshes ---

void tilt(Control& c)
{
  for (Triple& p : c.points) {
    const double x = p[0] + 0.25 * p[1] - 0.125 * p[2], y = p[1] + 0.375 * p[2];
    p = {x, y, p[2] - 0.3125 * x};
  }
}

// a shape, of which some vertices are moved to the points of other ones
Control coincident(const std::string& name, const test_meshes::Control_mesh& shape,
                   const std::vector<std::pair<std::size_t, std::size_t>>& moved)
{
  Control c{name, shape.points, shape.faces};
  for (const auto& [v, to] : moved) c.points[v] = c.points[to];
  tilt(c);
  return c;
}

// a triangle between the middle of an edge and its ends
Control box_with_flat_triangle()
{
  Control c{
    "box with a triangle without area",
    {{3, 2, 0}, {0, 2, 0}, {0, 0, 0}, {3, 0, 0}, {3, 2, 1}, {3, 0, 1}, {0, 2, 1}, {0, 0, 1}},
    {{0, 3, 2, 1},
     {4, 6, 7, 5},
     {0, 1, 6, 4},
     {1, 2, 7, 6},
     {2, 3, 8, 7},
     {8, 5, 7},
     {3, 5, 8},
     {3, 0, 4, 5}}};
  tilt(c);
  Triple middle;
  for (std::size_t k = 0; k < 3; ++k) middle[k] = (c.points[3][k] + c.points[5][k]) / 2;
  c.points.push_back(middle);
  return c;
}

std::vector<Control> controls()
{
  const auto bipyramid = test_meshes::bipyramid(4);
  return {coincident("house with an edge without length", test_meshes::house(4), {{0, 1}}),
          // all vertices of the ring at a pole are at one point, and its cap is a face there
          coincident("house with a pole", test_meshes::house(5), {{1, 0}, {2, 0}, {3, 0}, {4, 0}}),
          box_with_flat_triangle(),
          coincident("bipyramids that touch", test_meshes::united(bipyramid, bipyramid), {{8, 0}}),
          coincident("open grid with an edge without length at its border",
                     test_meshes::grid(2, 2, false, false, test_meshes::Cells::quads), {{1, 2}})};
}

Control triangulated(Control c)
{
  std::vector<std::vector<int>> faces;
  for (const std::vector<int>& f : c.faces)
    for (std::size_t i = 2; i < f.size(); ++i) faces.push_back({f[0], f[i - 1], f[i]});
  c.faces = std::move(faces);
  return c;
}

// a ball in triangles with a sharp face and a fold
Control creased_ball()
{
  const double points[] = {
    0.914,  -0.339, 0.191,  0.004,  0.517,  -0.883, -0.390, -0.545, -0.874, -0.834, -0.584, -0.361,
    -0.810, 0.436,  -0.555, -0.986, 0.372,  -0.025, -0.888, 0.305,  0.375,  -0.030, -0.902, 0.176,
    -0.696, 0.510,  -0.553, -0.622, 0.000,  0.742,  -0.039, 0.106,  -0.980, -0.434, -0.517, -0.893,
    0.815,  -0.630, -0.156, -0.758, 0.042,  -0.670, -0.536, 0.818,  0.149,  -0.073, 0.030,  -0.921,
    -0.416, 0.072,  -0.783, -0.001, -1.014, 0.046,  -0.627, 0.726,  0.306,  -0.246, -0.822, -0.382};
  const int corners[] = {0, 1,  18, 0,  7,  12, 0,  9,  7,  0,  12, 1,  0,  18, 9,  1,  8,  14,
                         1, 10, 16, 1,  12, 10, 1,  14, 18, 1,  16, 8,  2,  3,  11, 2,  11, 15,
                         2, 12, 19, 2,  15, 12, 2,  19, 3,  3,  5,  13, 3,  6,  5,  3,  7,  9,
                         3, 9,  6,  3,  13, 11, 3,  19, 7,  4,  5,  8,  4,  8,  16, 4,  13, 5,
                         4, 16, 13, 5,  6,  14, 5,  14, 8,  6,  9,  18, 6,  18, 14, 7,  17, 12,
                         7, 19, 17, 10, 12, 15, 10, 15, 16, 11, 13, 16, 11, 16, 15, 12, 17, 19};
  Control c{"creased ball", {}, {}, {{2, 11}, {2, 15}, {11, 13}, {11, 15}, {12, 15}}};
  for (std::size_t i = 0; i < std::size(points); i += 3)
    c.points.push_back({points[i], points[i + 1], points[i + 2]});
  for (std::size_t i = 0; i < std::size(corners); i += 3)
    c.faces.push_back({corners[i], corners[i + 1], corners[i + 2]});
  return c;
}

// a box in quads, without symmetries
Control creased_box()
{
  Control c{
    "creased box",
    {{3, 2, 0}, {0, 2, 0}, {0, 0, 0}, {3, 0, 0}, {3, 2, 1}, {3, 0, 1}, {0, 2, 1}, {0, 0, 1}},
    {{0, 3, 2, 1}, {4, 6, 7, 5}, {0, 1, 6, 4}, {1, 2, 7, 6}, {2, 3, 5, 7}, {3, 0, 4, 5}},
    {{0, 1}, {1, 2}, {1, 6}, {6, 7}}};
  tilt(c);
  for (std::size_t v = 0; v < c.points.size(); ++v)
    for (std::size_t k = 0; k < 3; ++k)
      c.points[v][k] += 0.2 * std::sin(7. * double(v) + 3. * double(k));
  return c;
}

// --- what is done with them ---

template <class Scheme>
Points subdivided(const Control& c, const Scheme& scheme, PN::Control_normal_estimate how)
{
  Mesh mesh = built<Mesh>(c);
  PN::subdivide(mesh, scheme, PN::parameters::control_normal_estimate(how).number_of_iterations(1));
  return points(mesh);
}

struct Action
{
  const char* name;
  bool takes_triangles;
  std::function<Points(const Control&)> result;
};

std::vector<Action> runs()
{
  using Estimate = PN::Control_normal_estimate;
  const PN::CatmullClark_scheme catmull_clark;
  std::vector<Action> result;
  for (const auto& [name, how] :
       {std::pair("coherent", Estimate::coherent), std::pair("reciprocal", Estimate::reciprocal),
        std::pair("angle", Estimate::angle)})
    result.push_back({name, false, [estimate = how, catmull_clark](const Control& c) {
                        return subdivided(c, catmull_clark, estimate);
                      }});
  result.push_back({"Loop", true, [](const Control& c) {
                      return subdivided(c, PN::Loop_scheme(), Estimate::coherent);
                    }});
  result.push_back({"Doo-Sabin", false, [](const Control& c) {
                      return subdivided(c, PN::DooSabin_scheme(), Estimate::angle);
                    }});
  result.push_back({"creases", false, [catmull_clark](const Control& c) {
                      Mesh mesh = built<Mesh>(c);
                      const auto sharp =
                        mesh.add_property_map<Mesh::Edge_index, bool>("e:sharp", false).first;
                      PN::detect_creases(mesh, 50, sharp);
                      PN::subdivide(mesh, catmull_clark,
                                    np::number_of_iterations(2).edge_is_constrained_map(sharp));
                      return points(mesh);
                    }});
  result.push_back({"limits", false, [catmull_clark](const Control& c) {
                      Mesh mesh = built<Mesh>(c);
                      PN::subdivide_to_limit(mesh, catmull_clark, np::number_of_iterations(1));
                      return points(mesh);
                    }});
  result.push_back({"tessellation", false, [catmull_clark](const Control& c) {
                      Mesh triangles;
                      PN::tessellate(built<Mesh>(c), catmull_clark, 0.15, triangles);
                      return points(triangles);
                    }});
  return result;
}

// --- other forms of a mesh ---

class Axes
{
public:
  explicit Axes(int number) // of 48
    : signs_(number % 8)
  {
    for (int k = number / 8; k > 0; --k) std::next_permutation(axis_.begin(), axis_.end());
  }
  Points operator()(Points points) const
  {
    for (Triple& p : points) {
      const Triple old = p;
      for (std::size_t k = 0; k < 3; ++k) p[k] = (signs_ >> k & 1 ? -1 : 1) * old[axis_[k]];
    }
    return points;
  }

private:
  int signs_;
  std::array<std::size_t, 3> axis_{0, 1, 2};
};

Control renumbered(const Control& c, std::mt19937& random)
{
  std::vector<int> number(c.points.size());
  std::iota(number.begin(), number.end(), 0);
  std::shuffle(number.begin(), number.end(), random);
  Control result = c;
  for (std::size_t v = 0; v < number.size(); ++v)
    result.points[std::size_t(number[v])] = c.points[v];
  for (auto& [a, b] : result.sharp) a = number[std::size_t(a)], b = number[std::size_t(b)];
  for (std::vector<int>& f : result.faces) {
    for (int& v : f) v = number[std::size_t(v)];
    std::rotate(f.begin(), f.begin() + std::ptrdiff_t(random() % f.size()), f.end());
  }
  std::shuffle(result.faces.begin(), result.faces.end(), random);
  return result;
}

double distance(const Triple& p, const Triple& q)
{
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

constexpr double rounding = 1e-10;

Mesh creased_tessellation(const Control& c)
{
  Mesh mesh = built<Mesh>(c), triangles;
  const auto sharp = mesh.add_property_map<Mesh::Edge_index, bool>("e:sharp", false).first;
  const auto vertex = [](int v) { return Mesh::Vertex_index(Mesh::size_type(v)); };
  for (const auto& [a, b] : c.sharp) sharp[mesh.edge(mesh.halfedge(vertex(a), vertex(b)))] = true;
  const auto result = PN::tessellate(mesh, PN::CatmullClark_scheme(), 0.03, triangles,
                                     np::edge_is_constrained_map(sharp));
  EXPECT_TRUE(result.reached);
  return triangles;
}

// the triangles, each by the places of its corners in a list of points
std::set<std::array<std::size_t, 3>> triangles_by_place(const Mesh& mesh, const Points& places)
{
  std::vector<std::size_t> nearest;
  for (const Triple& p : points(mesh)) {
    nearest.push_back(0);
    for (std::size_t i = 0; i < places.size(); ++i)
      if (distance(p, places[i]) < distance(p, places[nearest.back()])) nearest.back() = i;
    EXPECT_LE(distance(p, places[nearest.back()]), rounding);
  }
  std::set<std::array<std::size_t, 3>> result;
  for (const auto f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    std::array<std::size_t, 3> corners{nearest[mesh.source(h)], nearest[mesh.target(h)],
                                       nearest[mesh.target(mesh.next(h))]};
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    result.insert(corners);
  }
  return result;
}

} // namespace

TEST(Symmetries, results_turn_with_the_mesh)
{
  for (const Control& control : controls())
    for (const Action& run : runs()) {
      const Control c = run.takes_triangles ? triangulated(control) : control;
      const Points expected = run.result(c);
      double worst = 0;
      for (int k = 1; k < 48; ++k) {
        const Axes axes(k);
        const Points points = run.result({c.name, axes(c.points), c.faces}),
                     turned = axes(expected);
        ASSERT_EQ(points.size(), turned.size()) << c.name << ", " << run.name;
        for (std::size_t v = 0; v < points.size(); ++v)
          worst = (std::max)(worst, distance(points[v], turned[v]));
      }
      EXPECT_LE(worst, rounding) << c.name << ", " << run.name;
    }
}

TEST(Symmetries, numbers_mean_nothing)
{
  std::mt19937 random(5);
  for (const Control& control : controls())
    for (const Action& run : runs()) {
      const Control c = run.takes_triangles ? triangulated(control) : control;
      const Points expected = run.result(c);
      double worst = 0;
      for (int k = 0; k < 3; ++k) {
        const Points points = run.result(renumbered(c, random));
        ASSERT_EQ(points.size(), expected.size()) << c.name << ", " << run.name;
        for (const Triple& p : points) {
          double nearest = std::numeric_limits<double>::infinity();
          for (const Triple& q : expected) nearest = (std::min)(nearest, distance(p, q));
          worst = (std::max)(worst, nearest);
        }
      }
      EXPECT_LE(worst, rounding) << c.name << ", " << run.name;
    }
}

// nor those of a tessellation with creases, triangle by triangle
TEST(Symmetries, creased_tessellations_are_the_same)
{
  std::mt19937 random(7);
  for (const Control& c : {creased_ball(), creased_box()}) {
    const Mesh expected = creased_tessellation(c);
    const Points places = points(expected);
    const auto triangles = triangles_by_place(expected, places);
    EXPECT_EQ(triangles.size(), expected.number_of_faces()) << c.name;
    for (int k = 0; k < 3; ++k) {
      const Mesh mesh = creased_tessellation(renumbered(c, random));
      EXPECT_EQ(mesh.number_of_vertices(), expected.number_of_vertices()) << c.name;
      EXPECT_TRUE(triangles_by_place(mesh, places) == triangles) << c.name;
    }
  }
}

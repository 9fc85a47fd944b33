// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Single parts, and what they must give.

#include "Named_parts.h"
#include "Part_marks.h"

#include <CGAL/PN_recognition_3/internal/recognition.h>

#include <gtest/gtest.h>

using namespace synthetic_parts;
namespace PN = CGAL::PN_subdivision_3;
using Recognized_kind = Recognized_surface::Kind;

namespace {

// planes, cylinders, cones, spheres, tori
using Counts = std::array<std::size_t, 5>;

Counts counts(const Recognition& r)
{
  Counts n{};
  for (const Recognized_surface& s : r.surfaces) {
    EXPECT_NE(s.kind, Recognized_kind::unknown);
    if (s.kind != Recognized_kind::unknown) ++n[static_cast<std::size_t>(truth(s.kind))];
  }
  return n;
}

Recognition expect_right(const Part& part, const Counts& expected)
{
  const Recognition r = recognition_of(part);
  EXPECT_EQ(counts(r), expected) << part.name;
  EXPECT_EQ(Part_marks(part, r).text(), "") << part.name;
  return r;
}

template <class NamedParameters>
Counts counts_with(const Part& part, const NamedParameters& np)
{
  Mesh mesh = mesh_of<Mesh>(part);
  return counts(recognition_of(mesh, np));
}

// of the surfaces of a kind
double widest_step(const Recognition& r, Recognized_kind kind)
{
  double widest = 0;
  for (const Recognized_surface& s : r.surfaces)
    if (s.kind == kind) widest = (std::max)(widest, s.widest_step);
  return widest;
}

} // namespace

TEST(Recognize_surfaces, box_with_fillets_and_chamfers)
{
  expect_right(box_with_fillets_and_chamfers(), {9, 2, 0, 0, 0});
}

TEST(Recognize_surfaces, bolt_with_a_head_of_eight_sides)
{
  const Recognition r = expect_right(bolt(8, 24), {11, 1, 1, 0, 0});
  EXPECT_NEAR(widest_step(r, Recognized_kind::cylinder), 2 * pi / 24, 1e-9);
  EXPECT_NEAR(widest_step(r, Recognized_kind::cone), 2 * pi / 24, 1e-9);
}

// Nothing finer says that the head is a prism: both are round.
TEST(Recognize_surfaces, bolt_of_one_step)
{
  const Recognition r = recognition_of(bolt(8, 8));
  EXPECT_EQ(counts(r), (Counts{3, 2, 1, 0, 0}));
}

TEST(Recognize_surfaces, shaft_of_seven_sides)
{
  expect_right(bored_prism(7), {23, 0, 0, 0, 0});
}

TEST(Recognize_surfaces, rounded_box)
{
  Random random(11);
  const Part part = rounded_box({3, 2, 1.5}, 0.3, steps(6), steps(6), random);
  const Recognition r = expect_right(part, {6, 12, 0, 8, 0});
  EXPECT_NEAR(widest_step(r, Recognized_kind::cylinder), pi / 12, 1e-9);
}

TEST(Recognize_surfaces, shaft)
{
  const Recognition r = expect_right(shaft(48, 12), {3, 2, 2, 0, 1});
  EXPECT_NEAR(widest_step(r, Recognized_kind::torus), 2 * pi / 48, 1e-9);
  for (const Recognized_surface& s : r.surfaces)
    if (s.kind == Recognized_kind::torus) {
      EXPECT_NEAR(s.radius, 0.8, 1e-9);
      EXPECT_NEAR(s.tube_radius, 0.2, 1e-9);
      EXPECT_NEAR(s.widest_meridian_step, pi / 24, 1e-9);
    } else
      EXPECT_EQ(s.widest_meridian_step, 0);
}

TEST(Recognize_surfaces, prisms_pyramids_and_frusta)
{
  for (int n = 3; n <= 7; ++n) {
    const auto sides = static_cast<std::size_t>(n);
    expect_right(regular_prism(n), {sides + 2, 0, 0, 0, 0});
    expect_right(regular_prism(n, 0), {sides + 1, 0, 0, 0, 0});
    expect_right(regular_prism(n, 0.6), {sides + 2, 0, 0, 0, 0});
  }
}

// Their sides meet at angles at which what is round does.
TEST(Recognize_surfaces, flat_pyramids_and_frusta)
{
  for (int n = 3; n <= 7; ++n)
    for (double stretch : {1., 1.3})
      for (double top : {0., 0.5}) {
        if (top > 0 && stretch > 1) continue; // some of the sides meet at more than that
        SCOPED_TRACE(n);
        Part part = regular_prism(n, top);
        for (Vec& p : part.points) p = {stretch * p[0], p[1], (top > 0 ? 0.4 : 0.15) * p[2]};
        Mesh mesh = mesh_of<Mesh>(part);
        const Recognition r = recognition_of(mesh, CGAL::parameters::default_values());
        const auto planes = static_cast<std::size_t>(top > 0 ? n + 2 : n + 1);
        EXPECT_EQ(counts(r), (Counts{planes, 0, 0, 0, 0})) << stretch << ' ' << top;
      }
}

TEST(Recognize_surfaces, prism_of_eight_sides_is_round)
{
  EXPECT_EQ(counts(recognition_of(regular_prism(8))), (Counts{2, 1, 0, 0, 0}));
  EXPECT_EQ(counts(recognition_of(regular_prism(8, 0.6))), (Counts{2, 0, 1, 0, 0}));
}

TEST(Recognize_surfaces, elbow)
{
  Random random(12);
  expect_right(elbow(steps(16), steps(4), 90, 0, random), {2, 2, 0, 0, 1});
  expect_right(elbow(steps(16), steps(4), 90, 0.3, random), {2, 4, 0, 0, 2});
}

TEST(Recognize_surfaces, fewest_facets)
{
  EXPECT_EQ(counts_with(regular_prism(6), PN::parameters::min_facets(6)), (Counts{2, 1, 0, 0, 0}));
  EXPECT_EQ(counts_with(regular_prism(6), PN::parameters::min_facets(7)), (Counts{8, 0, 0, 0, 0}));
  EXPECT_EQ(counts_with(regular_prism(11), PN::parameters::min_facets(12)),
            (Counts{13, 0, 0, 0, 0}));
  EXPECT_EQ(counts_with(regular_prism(11), PN::parameters::min_facets(11)),
            (Counts{2, 1, 0, 0, 0}));
}

// Radii that vary by more than a file's rounding are those of a cylinder only if one says so.
TEST(Recognize_surfaces, tolerance)
{
  Part part = regular_prism(20);
  for (std::size_t v = 0; v < part.points.size(); ++v) {
    const double s = 1 + 1e-4 * std::sin(7. * static_cast<double>(v));
    part.points[v] = {s * part.points[v][0], s * part.points[v][1], part.points[v][2]};
  }
  Mesh mesh = mesh_of<Mesh>(part);
  EXPECT_EQ(
    recognition_of(mesh, CGAL::parameters::default_values()).count(Recognized_kind::cylinder), 0u);
  EXPECT_EQ(counts_with(part, PN::parameters::surface_tolerance(4e-4)), (Counts{2, 1, 0, 0, 0}));
}

// What the coordinates of a file may be off by.
TEST(Recognize_surfaces, rounding_of_files)
{
  using CGAL::PN_subdivision_3::internal::recognition::file_rounding;
  std::vector<double> x;
  for (int i = 1; i < 400; ++i) x.push_back(30 * std::sin(1. * i));
  const double largest = *std::max_element(x.begin(), x.end());
  const auto in_file = [&](const char* format) {
    std::vector<double> y;
    for (double c : x) {
      char text[40];
      std::snprintf(text, sizeof text, format, c);
      y.push_back(std::strtod(text, nullptr));
    }
    return y;
  };
  EXPECT_NEAR(file_rounding(x) / std::ldexp(largest, -50), 1, 1e-3);
  EXPECT_EQ(file_rounding(in_file("%.6g")), 0.5e-4);
  EXPECT_EQ(file_rounding(in_file("%.9g")), 0.5e-7);
  EXPECT_EQ(file_rounding(in_file("%.3f")), 0.5e-3); // 30 and three digits: five
  EXPECT_NEAR(file_rounding(in_file("%.7f")) / 0.5e-7, 1, 1e-9);
  std::vector<double> singles;
  for (double c : x) singles.push_back(static_cast<double>(static_cast<float>(c)));
  EXPECT_NEAR(file_rounding(singles) / std::ldexp(largest, -24), 1, 1e-3);
  singles.push_back(-64); // the largest counts, whatever its sign
  EXPECT_EQ(file_rounding(singles), std::ldexp(64., -24));
}

// Rows that are multiples of each other determine one unknown; the other is left at zero, whatever rounding is left.
TEST(Recognize_surfaces, unknowns_that_rows_do_not_determine)
{
  CGAL::PN_subdivision_3::internal::recognition::Least_squares system(2);
  for (int k = 1; k < 20; ++k) system.add({0.1 * k, 0.3 * k}, 2 * k);
  const auto x = system.solve();
  EXPECT_NEAR(x[0], 20, 1e-12);
  EXPECT_EQ(x[1], 0);
}

// A file of floats is taken at its word, too: what is off by more than its rounding allows is no cylinder.
// As a polyhedral Boolean joins them, at whose seam vertices are on chords of the ball, and every other one on those of the stem.
TEST(Recognize_surfaces, ball_on_a_stem)
{
  constexpr int n = 20, first = 3; // of the rings of the ball, of which the stem takes three
  Mesh mesh;
  const auto ring = [](int i, int k) {
    const double polar = (i + 0.5) * pi / n, t = 2 * pi * k / n, r = 10 * std::sin(polar);
    return Mesh::Point(r * std::cos(t), r * std::sin(t), -10 * std::cos(polar));
  };
  const double r2 = 10 * std::sin(2.5 * pi / n), r3 = 10 * std::sin(3.5 * pi / n);
  const double part = (4 - r2) / (r3 - r2); // of the facet above
  std::vector<std::vector<Mesh::Vertex_index>> rings(n);
  std::vector<Mesh::Vertex_index> foot, seam, middle;
  for (int k = 0; k < n; ++k) {
    const double t = 2 * pi * k / n;
    foot.push_back(mesh.add_vertex({4 * std::cos(t), 4 * std::sin(t), -20}));
    seam.push_back(mesh.add_vertex(ring(2, k) + part * (ring(3, k) - ring(2, k))));
    middle.push_back(mesh.add_vertex(ring(2, k) + part * (ring(3, k + 1) - ring(2, k))));
    for (int i = first; i < n; ++i) rings[i].push_back(mesh.add_vertex(ring(i, k)));
  }
  for (int k = 0; k < n; ++k) {
    const int l = (k + 1) % n;
    mesh.add_face(std::vector{foot[k], foot[l], seam[l], middle[k], seam[k]});
    mesh.add_face(std::vector{seam[k], middle[k], seam[l], rings[first][l], rings[first][k]});
    for (int i = first; i + 1 < n; ++i)
      mesh.add_face(rings[i][k], rings[i][l], rings[i + 1][l], rings[i + 1][k]);
  }
  mesh.add_face(rings[n - 1]);
  std::reverse(foot.begin(), foot.end());
  mesh.add_face(foot);
  // the polygon at its pole is a facet of the ball, too
  EXPECT_EQ(counts(recognition_of(mesh, PN::parameters::min_facets(8))), (Counts{1, 1, 0, 1, 0}));
}

TEST(Recognize_surfaces, tolerance_of_floats)
{
  for (const double error : {0., 4e-6}) {
    Part part = regular_prism(20);
    for (std::size_t v = 0; v < part.points.size(); ++v) {
      const double s = 1 + error * std::sin(7. * static_cast<double>(v));
      part.points[v] = {s * part.points[v][0], s * part.points[v][1], part.points[v][2]};
    }
    write_as(part, File::single);
    bool has_whole = false;
    for (const Recognized_surface& r : recognition_of(part).surfaces)
      has_whole = has_whole || (r.kind == Recognized_kind::cylinder && r.number_of_faces == 40);
    EXPECT_EQ(has_whole, error == 0);
  }
}

// A cylinder that is no cylinder: its side is unknown, with creases inside where it bends by more than the angle.
TEST(Recognize_surfaces, elliptic_cylinder_is_unknown)
{
  Part part = regular_prism(40);
  for (Vec& p : part.points) p[0] *= 2.3;
  Mesh mesh = mesh_of<Mesh>(part);
  const Recognition r = recognition_of(mesh, CGAL::parameters::default_values());
  EXPECT_EQ(r.count(Recognized_kind::unknown), 1u);
  EXPECT_EQ(r.count(Recognized_kind::plane), 2u);
  EXPECT_EQ(r.surfaces.size(), 3u);
  EXPECT_EQ(r.creases.size(), 80u); // the rims

  // joints of these rulings: 3 to 20 degrees
  Mesh again = mesh_of<Mesh>(part);
  const Recognition s = recognition_of(again, PN::parameters::sharp_angle(15));
  std::size_t sharp = 0;
  for (int i = 0; i < 40; ++i) {
    const auto normal = [](int k) {
      const double t = 2 * pi * (k + 0.5) / 40;
      return unit({std::cos(t), 2.3 * std::sin(t), 0});
    };
    if (dot(normal(i), normal(i - 1)) < std::cos(15 * pi / 180)) ++sharp;
  }
  EXPECT_GT(sharp, 0u);
  EXPECT_EQ(s.creases.size(), 80 + sharp);
}

// Prisms of few sides stay, and their sides say so.
TEST(Recognize_surfaces, sides_of_prisms_that_are_left)
{
  for (int n : {6, 7}) {
    std::size_t sides = 0;
    for (const Recognized_surface& r : recognition_of(regular_prism(n)).surfaces) {
      EXPECT_EQ(r.kind, Recognized_kind::plane);
      if (r.widest_step == 0) continue;
      ++sides;
      EXPECT_NEAR(2 * pi / r.widest_step, n, 1e-6);
    }
    EXPECT_EQ(sides, std::size_t(n));
  }
}

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// --chord: distances are measured here, on surfaces that are known.

#include "Part_files.h"
#include "Refined_files.h"

namespace pn_subdivide {
namespace {

using Json = nlohmann::json;

// A square of 3 x 3 unequal faces in a plane, with an index and texture coordinates; x is an attribute, too.
std::string plate()
{
  const std::array<double, 4> at{0, 1, 2.5, 3};
  std::ostringstream ply;
  ply << "ply\nformat ascii 1.0\nelement vertex 16\nproperty double x\nproperty double y\nproperty "
         "double z\nproperty double twice\nelement face 9\nproperty list uchar int "
         "vertex_indices\nproperty int part\nproperty list uchar float texcoord\nend_header\n";
  for (const double y : at)
    for (const double x : at) ply << x << ' ' << y << " 0 " << 2 * x + 100 * y << '\n';
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i) {
      const std::array<int, 4> c{4 * j + i, 4 * j + i + 1, 4 * j + i + 5, 4 * j + i + 4};
      ply << 4;
      for (const int v : c) ply << ' ' << v;
      ply << ' ' << 10 + 3 * j + i << " 8";
      for (const int v : c) ply << ' ' << at[std::size_t(v % 4)] << ' ' << at[std::size_t(v / 4)];
      ply << '\n';
    }
  return ply.str();
}

class Pn_subdivide_chord : public Refined_files
{
protected:
  void SetUp() override
  {
    folder.write("cube.off", cube_off);
    folder.write("octahedron.off", octahedron_off);
    folder.write("plate.ply", plate());
  }
  std::string ball() const { return " --normals sphere:0,0,0 "; }
};

// the largest distance of points of the faces from the sphere of radius r about the origin
double distance_from_sphere(const Mesh_data& mesh, double r)
{
  double largest = 0;
  constexpr int n = 8;
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
    const auto face = mesh.face(f);
    const std::size_t degree = std::size_t(face.size());
    for (std::size_t c = 1; c + 1 < degree; ++c)
      for (int i = 0; i <= n; ++i)
        for (int k = 0; i + k <= n; ++k) {
          Triple p{};
          for (std::size_t d = 0; d < 3; ++d)
            p[d] = (i * mesh.points[face.begin()[0]][d] + k * mesh.points[face.begin()[c]][d] +
                    (n - i - k) * mesh.points[face.begin()[c + 1]][d]) /
                   n;
          largest = (std::max)(largest, std::abs(length(p) - r));
        }
  }
  return largest;
}

TEST_F(Pn_subdivide_chord, ASphereIsTessellated)
{
  const double radius = std::sqrt(3.);
  for (const double eps : {0.05, 0.004}) {
    const Mesh_data mesh =
      refined("cube.off", "o.ply", "--chord " + std::to_string(eps) + ball() + reported());
    const double error = distance_from_sphere(mesh, radius);
    EXPECT_LE(error, eps);
    EXPECT_GE(error, eps / 8);
    EXPECT_TRUE(is_watertight(mesh));
    ASSERT_TRUE(mesh.has_normals());
    EXPECT_EQ(mesh.normal_kind, Normal_kind::of_surface);
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      EXPECT_NEAR(length(mesh.points[v]), radius, 1e-8);
      for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(mesh.normals[v][i], mesh.points[v][i] / radius, 1e-4);
    }
    const Json json = report()["tessellation"];
    EXPECT_TRUE(json["reached"].get<bool>());
    EXPECT_GE(json["bound"].get<double>(), error);
    EXPECT_LE(json["bound"].get<double>(), eps);
    EXPECT_NEAR(json["asked"].get<double>(), eps, 1e-12);
    EXPECT_EQ(report()["faces"].get<std::size_t>(), mesh.number_of_faces());
  }
}

TEST_F(Pn_subdivide_chord, ChordMayBeAPartOfTheDiagonal)
{
  written("cube.off", "o.ply", "--chord 1%" + ball() + reported());
  EXPECT_NEAR(report()["tessellation"]["asked"].get<double>(), std::sqrt(12.) / 100, 1e-12);
}

TEST_F(Pn_subdivide_chord, SchemesAndLinearOnes)
{
  for (const std::string scheme : {"catmull-clark", "modified-catmull-clark", "ct-catmull-clark",
                                   "kobbelt", "loop", "butterfly"}) {
    const bool has_triangles = scheme == "loop" || scheme == "butterfly";
    const Mesh_data mesh = refined(has_triangles ? "octahedron.off" : "cube.off", "o.ply",
                                   "--chord 0.02 --scheme " + scheme + ball());
    EXPECT_LE(distance_from_sphere(mesh, has_triangles ? 1 : std::sqrt(3.)), 0.02) << scheme;
  }
  const Mesh_data linear = refined("cube.off", "l.ply", "--linear --chord 0.02"),
                  flat = refined("cube.off", "f.ply", "--roundness 0 --chord 0.02");
  EXPECT_TRUE(linear.has_normals());
  ASSERT_EQ(linear.points.size(), flat.points.size());
  for (std::size_t v = 0; v < flat.points.size(); ++v)
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(linear.points[v][i], flat.points[v][i], 1e-8);
  // the limit of a vertex of valence 3 of the unit cube's: 5/18 of itself and so on is 1/2 in all
  for (std::size_t v = 0; v < 8; ++v)
    for (const double x : linear.points[v]) EXPECT_NEAR(std::abs(x), 0.5, 1e-8);
}

TEST_F(Pn_subdivide_chord, CreasesAndBorders)
{
  const Mesh_data box = refined("cube.off", "o.obj", "--chord 0.001 --sharp angle:30");
  EXPECT_EQ(box.number_of_faces(), 12u);
  EXPECT_EQ(box.points.size(), 8u);
  EXPECT_TRUE(box.has_corner_normals());
  for (const std::string border : {"surface", "curve", "corners", "fixed"}) {
    const Mesh_data mesh = refined("plate.ply", "o.ply", "--chord 0.001 --border " + border);
    double area = 0;
    for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
      const auto v = mesh.face(f).begin();
      const Triple &a = mesh.points[v[0]], &b = mesh.points[v[1]], &c = mesh.points[v[2]];
      area += ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
    }
    const bool is_square = border == "corners" || border == "fixed";
    EXPECT_EQ(std::abs(area - 9) < 1e-9, is_square) << area;
    if (border == "fixed") {
      EXPECT_EQ(mesh.number_of_faces(), 18u);
    }
  }
}

TEST_F(Pn_subdivide_chord, OutputNormals)
{
  EXPECT_FALSE(refined("cube.off", "o.ply", "--chord 0.1 --output-normals none").has_normals());
  EXPECT_TRUE(refined("cube.off", "o.ply", "--chord 0.1 --output-normals surface").has_normals());
  EXPECT_TRUE(refined("cube.off", "o.ply", "--chord 0.1 --surface-normals").has_normals());
  EXPECT_EQ(refined("cube.off", "o.stl", "--chord 0.1 --linear").number_of_faces() % 12, 0u);
}

// What is linear on the plane stays so.
TEST_F(Pn_subdivide_chord, AttributesAreCarried)
{
  const std::string options = "--chord 0.01 --border curve --ascii";
  for (const std::string more : {" --linear", ""}) {
    const Mesh_data mesh = refined("plate.ply", "o.ply", options + more);
    ASSERT_EQ(mesh.attributes.of_vertices.size(), 1u);
    const auto& twice = mesh.attributes.of_vertices[0].values;
    ASSERT_EQ(twice.size(), mesh.points.size());
    for (std::size_t v = 0; v < twice.size(); ++v)
      EXPECT_NEAR(twice[v], 2 * mesh.points[v][0] + 100 * mesh.points[v][1],
                  more.empty() ? 30 : 1e-6);
    ASSERT_EQ(mesh.attributes.of_faces.size(), 1u);
    ASSERT_EQ(mesh.attributes.texture.size(), 3 * mesh.number_of_faces());
    // the triangles lie in the squares of their parts
    const std::array<double, 4> at{0, 1, 2.5, 3};
    for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
      const int part = int(mesh.attributes.of_faces[0].values[f]) - 10;
      for (std::size_t i = 0; i < 3; ++i) {
        const auto& t = mesh.attributes.texture[3 * f + i];
        EXPECT_GE(t[0], at[std::size_t(part % 3)] - 1e-6);
        EXPECT_LE(t[0], at[std::size_t(part % 3 + 1)] + 1e-6);
        EXPECT_GE(t[1], at[std::size_t(part / 3)] - 1e-6);
        EXPECT_LE(t[1], at[std::size_t(part / 3 + 1)] + 1e-6);
      }
    }
    // and texture coordinates that are equal on control faces stay so: each place has one
    std::map<Mesh_data::Index, std::set<std::pair<double, double>>> of_vertex;
    for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
      for (std::size_t i = 0; i < 3; ++i) {
        const auto& t = mesh.attributes.texture[3 * f + i];
        of_vertex[mesh.face(f).begin()[i]].insert({double(t[0]), double(t[1])});
      }
    std::set<std::pair<double, double>> all;
    for (const auto& [v, values] : of_vertex) {
      EXPECT_EQ(values.size(), 1u);
      all.insert(values.begin(), values.end());
    }
    EXPECT_EQ(all.size(), mesh.points.size());
  }
  const Mesh_data dropped = refined("plate.ply", "o.ply", options + " --drop-attributes");
  EXPECT_TRUE(dropped.attributes.of_vertices.empty());
  EXPECT_TRUE(dropped.attributes.texture.empty());
}

TEST_F(Pn_subdivide_chord, WhatIsNotReachedIsAWarning)
{
  // the vertex has surroundings that shrink slowly
  folder.write("cone.off", cone_of_quads(60).off());
  const std::string options = "--linear --border fixed --chord 0.00003";
  const Outcome outcome = done(surface("cone.off", "o.ply", options + reported()));
  EXPECT_EQ(outcome.err.rfind("warning: ", 0), 0u) << outcome.err;
  for (const char* part : {"--chord", "not reached in 12 rounds", "near", "face"})
    expect_part(outcome.err, part);
  const Json json = report()["tessellation"];
  EXPECT_FALSE(json["reached"].get<bool>());
  EXPECT_GT(json["bound"].get<double>(), 0.00003);
  EXPECT_GT(read_mesh(folder.file("o.ply")).number_of_faces(), 100u);
  EXPECT_EQ(surface("cone.off", "o.ply", options + " --strict").code, 4);
}

TEST_F(Pn_subdivide_chord, WhatIsOutOfReachEndsEarly)
{
  const Outcome outcome = done(surface("cube.off", "o.ply", "--chord 1e-30%" + reported()));
  expect_part(outcome.err, "not reached, for which coordinates have too few digits");
  EXPECT_LT(report()["tessellation"]["bound"].get<double>(), 1e-4);
  EXPECT_LT(read_mesh(folder.file("o.ply")).number_of_faces(), 1000000u);
}

// \name Options

TEST_F(Pn_subdivide_chord, WhatDoesNotGoTogether)
{
  const auto refused = [&](const std::string& options, const std::string& other) {
    expect_refusal("cube.off", "o.ply", options, {other, "--chord"});
  };
  refused("--chord 0.1 --levels 3", "--levels 3");
  refused("--levels auto", "--levels N");
  for (const std::string scheme : {"sqrt3", "doo-sabin"})
    refused("--chord 0.1 --scheme " + scheme, scheme);
  for (const std::string normals : {"control", "both"})
    refused("--chord 0.1 --output-normals " + normals, "--output-normals " + normals);
  refused("--chord 0.1 --write-tags '" + folder.file("t.selection.txt") + "'", "--write-tags");
  for (const std::string option :
       {"--curvature mean", "--limit --limit-tolerance 1e-6", "--texture-rule boundaries"}) {
    const std::size_t first = option.rfind("--");
    refused("--chord 0.1 " + option, option.substr(first, option.find(' ', first) - first));
  }
  for (const char* const in_pieces : {"--pieces 2", "--memory 1G", "--resume"})
    refused(std::string("--chord 0.1 ") + in_pieces, "--levels N");
  refused("--chord-bound estimated", "--chord-bound");
  refused("--chord 0.1 --chord-bound exact", "--chord-bound 'exact'");
  for (const std::string chord : {"0", "-1", "-1%", "nan", "much"})
    refused("--chord " + chord, chord);
  const std::string proven = "--chord 0.1 --chord-bound proven";
  expect_refusal("cube.off", "o.ply", proven + " --sharp angle:30",
                 {"vertex number 0, which is sharp"}, 1);
  expect_refusal("cube.off", "o.ply", proven + " --scheme modified-catmull-clark", {"modified"}, 1);
  done(surface("cube.off", "o.ply", "--chord 0.1 --sharp angle:30 --sharpness 1.5"));
  done(surface("cube.off", "o.ply", "--chord 0.1 --chord-bound estimated"));
  const std::size_t estimated = read_mesh(folder.file("o.ply")).number_of_faces();
  done(surface("cube.off", "o.ply", proven + reported()));
  EXPECT_LE(report()["tessellation"]["bound"].get<double>(), 0.1);
  EXPECT_GT(read_mesh(folder.file("o.ply")).number_of_faces(), estimated);
}

} // namespace
} // namespace pn_subdivide

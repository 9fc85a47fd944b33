// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// --chord in pieces: the same points and triangles as of the whole, to the last bit, in another order.

#include "Pieces_test.h"

#include "io/mesh_io.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace pn_subdivide {
namespace {

using Json = nlohmann::json;
using Bits = std::vector<std::uint64_t>;

template <class Values>
void append(Bits& bits, const Values& values)
{
  for (const double x : values) {
    bits.emplace_back();
    std::memcpy(&bits.back(), &x, sizeof x);
  }
}

// What vertices and faces have, without their numbers.
struct Content
{
  std::vector<Bits> vertices; // in order
  std::vector<Bits>
    triangles; // of a row for each corner, the least first, and of what they have themselves

  explicit Content(const Mesh_data& mesh)
  {
    const Attributes& attributes = mesh.attributes;
    std::vector<Bits> rows(mesh.points.size());
    for (std::size_t v = 0; v < rows.size(); ++v) {
      append(rows[v], mesh.points[v]);
      if (!mesh.normals.empty()) append(rows[v], mesh.normals[v]);
      for (const Column& column : attributes.of_vertices)
        append(rows[v], std::array<double, 1>{column.values[v]});
    }
    for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
      const auto face = mesh.face(f);
      EXPECT_EQ(face.size(), 3u);
      std::vector<Bits> corners;
      for (std::size_t i = 0; i < face.size(); ++i) {
        corners.push_back(rows[face.begin()[i]]);
        if (!attributes.texture.empty())
          append(corners.back(), attributes.texture[mesh.first_corner(f) + i]);
      }
      std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
      Bits triangle;
      for (const Bits& corner : corners)
        triangle.insert(triangle.end(), corner.begin(), corner.end());
      for (const Column& column : attributes.of_faces)
        append(triangle, std::array<double, 1>{column.values[f]});
      triangles.push_back(std::move(triangle));
    }
    std::sort(triangles.begin(), triangles.end());
    vertices = std::move(rows);
  }
};

// a box of 3 x 2 x 1 squares, from a corner on; of a mesh the first vertex has this number
void add_box(double x, double y, double z, std::string& points, std::vector<std::string>& faces,
             int& first)
{
  std::map<std::array<int, 3>, int> number;
  const std::array<int, 3> n{3, 2, 1};
  const std::array<double, 3> from{x, y, z};
  const auto vertex = [&](const std::array<int, 3>& at) {
    const auto [it, is_new] = number.emplace(at, first);
    if (is_new) {
      for (std::size_t i = 0; i < 3; ++i)
        points +=
          std::to_string(from[i] + at[i] + 0.01 * ((at[i] * 7 + at[(i + 1) % 3]) % 3)) + " ";
      points += "\n";
      ++first;
    }
    return std::to_string(it->second);
  };
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const int side : {0, 1})
      for (int i = 0; i < n[(axis + 1) % 3]; ++i)
        for (int j = 0; j < n[(axis + 2) % 3]; ++j) {
          std::array<std::array<int, 2>, 4> c{{{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}}};
          if (side == 0) std::reverse(c.begin(), c.end());
          std::string face = "4";
          for (const auto& [s, t] : c) {
            std::array<int, 3> at{};
            at[axis] = side * n[axis];
            at[(axis + 1) % 3] = s;
            at[(axis + 2) % 3] = t;
            face += " " + vertex(at);
          }
          faces.push_back(face);
        }
}

class Chord_in_pieces : public Pieces
{
protected:
  void SetUp() override
  {
    Pieces::SetUp();
    std::string points;
    std::vector<std::string> faces;
    int vertices = 0;
    add_box(0, 0, 0, points, faces, vertices);
    add_box(5, 1, 2, points, faces, vertices);
    std::string off =
      "OFF\n" + std::to_string(vertices) + " " + std::to_string(faces.size()) + " 0\n" + points;
    for (const std::string& face : faces) off += face + "\n";
    folder.write("boxes.off", off);
    for (const char* const name : {"valences_3_to_12.ply", "mixed_borders.off", "vase.obj"})
      std::filesystem::copy_file(std::filesystem::path(PN_DATA_DIR) / name, folder.file(name));
  }

  Outcome tessellate(const std::string& input, const std::string& output,
                     const std::string& options)
  {
    return run("surface '" + folder.file(input) + "' '" + folder.file(output) +
               "' --quiet --report '" + folder.file("r.json") + "' " + options);
  }
  Json report() const { return Json::parse(content("r.json"))["tessellation"]; }

  // Returns the number of triangles.
  std::size_t expect_same(const std::string& input, const std::string& options,
                          const std::vector<std::string>& pieces = {"--pieces 1", "--pieces 2",
                                                                    "--pieces 7", "--pieces 40"})
  {
    SCOPED_TRACE(input + " " + options);
    const Outcome whole = tessellate(input, "whole.ply", options);
    EXPECT_EQ(whole.code, 0) << whole.err;
    const Mesh_data expected_mesh = read_mesh(folder.file("whole.ply"));
    const Content expected(expected_mesh);
    const Json expected_report = report();
    const std::size_t control = read_mesh(folder.file(input)).points.size();
    const std::size_t files = folder.number_of_files();
    for (const std::string& in_pieces : pieces) {
      SCOPED_TRACE(in_pieces);
      const Outcome outcome = tessellate(input, "out.ply", options + " " + in_pieces);
      EXPECT_EQ(outcome.code, 0) << outcome.err;
      EXPECT_EQ(outcome.err, whole_as_out(whole.err));
      EXPECT_EQ(report(), expected_report);
      Content part(read_mesh(folder.file("out.ply")));
      EXPECT_TRUE(part.triangles == expected.triangles);
      const auto end = std::ptrdiff_t(control);
      EXPECT_TRUE(
        std::equal(part.vertices.begin(), part.vertices.begin() + end, expected.vertices.begin()));
      std::vector<Bits> all = expected.vertices;
      std::sort(all.begin(), all.end());
      std::sort(part.vertices.begin(), part.vertices.end());
      EXPECT_TRUE(part.vertices == all);
      std::filesystem::remove(folder.file("out.ply"));
      EXPECT_LE(folder.number_of_files(), files);
    }
    return expected.triangles.size();
  }

  // what is said of one file, of the other
  std::string whole_as_out(std::string text) const
  {
    const std::string whole = folder.file("whole.ply"), out = folder.file("out.ply");
    for (std::size_t at = text.find(whole); at != std::string::npos; at = text.find(whole))
      text.replace(at, whole.size(), out);
    return text;
  }
};

TEST_F(Chord_in_pieces, QuadsWithBordersAHoleAndAVertexAlone)
{
  EXPECT_GT(expect_same("quads.off", "--chord 0.005"), 200u);
  EXPECT_GT(expect_same("quads.off", "--chord 0.01 --linear"), 50u);
  expect_same("quads.off", "--chord 0.01 --scheme modified-catmull-clark", {"--pieces 5"});
  expect_same("quads.off", "--chord 0.01 --output-normals none", {"--pieces 5"});
  expect_same("quads.off", "--chord 0.02 --scheme kobbelt", {"--pieces 5"});
}

TEST_F(Chord_in_pieces, TrianglesWithBordersAHoleAndAVertexAlone)
{
  EXPECT_GT(expect_same("triangles.off", "--chord 0.005"), 200u);
  expect_same("triangles.off", "--chord 0.01 --scheme modified-loop", {"--pieces 5"});
  expect_same("triangles.off", "--chord 0.02 --scheme butterfly", {"--pieces 5"});
}

TEST_F(Chord_in_pieces, IrregularVerticesAndMixedFaces)
{
  expect_same("valences_3_to_12.ply", "--chord 0.5%", {"--pieces 9"});
  expect_same("mixed_borders.off", "--chord 0.1%", {"--pieces 2", "--pieces 9"});
  // rulings: splits that are taken back depend on neighbors of neighbors
  expect_same("vase.obj", "--chord 0.2%", {"--pieces 9"});
}

TEST_F(Chord_in_pieces, CreasesAndComponents)
{
  expect_same("boxes.off", "--chord 0.01", {"--pieces 2", "--pieces 11"});
  expect_same("boxes.off", "--chord 0.01 --sharp angle:30", {"--pieces 2", "--pieces 11"});
  expect_same("boxes.off", "--chord 0.01 --sharp angle:30 --linear", {"--pieces 11"});
  expect_same("quads.off", "--chord 0.005 --border curve", {"--pieces 7"});
  expect_same("triangles.off", "--chord 0.005 --border corners", {"--pieces 7"});
}

TEST_F(Chord_in_pieces, AProvenBound)
{
  expect_same("boxes.off", "--chord 0.1 --chord-bound proven", {"--pieces 4"});
}

TEST_F(Chord_in_pieces, Attributes)
{
  std::ostringstream ply;
  ply
    << "ply\nformat ascii 1.0\nelement vertex 16\nproperty double x\nproperty double y\nproperty "
       "double z\nproperty double heat\nproperty uchar red\nproperty uchar green\nproperty uchar "
       "blue\nelement face 9\nproperty list uchar int vertex_indices\nproperty int part\nproperty "
       "list uchar double texcoord\nend_header\n";
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i)
      ply << i << ' ' << j << ' ' << 0.1 * ((i * i + 3 * j) % 5) << ' ' << 1000 * i - j << ' '
          << 60 * i << ' ' << 50 * j << " 7\n";
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i) {
      const std::array<int, 4> c{4 * j + i, 4 * j + i + 1, 4 * j + i + 5, 4 * j + i + 4};
      ply << 4;
      for (const int v : c) ply << ' ' << v;
      ply << ' ' << 10 + 3 * j + i << " 8";
      for (const int v : c) ply << ' ' << 0.3 * (v % 4) + (j == 1 ? 5 : 0) << ' ' << 0.2 * (v / 4);
      ply << '\n';
    }
  folder.write("plate.ply", ply.str());
  expect_same("plate.ply", "--chord 0.005 --texture-rule all", {"--pieces 1", "--pieces 4"});
}

TEST_F(Chord_in_pieces, FilesOfPieces)
{
  ASSERT_EQ(tessellate("boxes.off", "whole.ply", "--chord 0.01").code, 0);
  const Mesh_data whole = read_mesh(folder.file("whole.ply"));
  const Outcome outcome = tessellate("boxes.off", "out.pvtp", "--chord 0.01 --pieces 5");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  std::size_t triangles = 0;
  for (int i = 0; i < 5; ++i) {
    const std::string piece = content("out_pieces/piece_" + std::to_string(i) + ".vtp");
    const std::string name = "NumberOfPolys=\"";
    triangles += std::stoul(piece.substr(piece.find(name) + name.size()));
  }
  EXPECT_EQ(triangles, whole.number_of_faces());
}

TEST_F(Chord_in_pieces, ByMemory)
{
  expect_same("quads.off", "--chord 0.002", {"--memory 1G", "--memory 52M"});
  const Outcome outcome = tessellate("quads.off", "out.ply", "--chord 1e-7 --memory 50M");
  expect_one_line(outcome, 1, "--memory: 50M are not enough");
  EXPECT_FALSE(std::filesystem::exists(folder.file("out.ply")));
}

TEST_F(Chord_in_pieces, WhatIsNotReachedIsSaid)
{
  const std::string options = "--chord 1e-15 --pieces 3";
  folder.write("out.ply", "untouched");
  const std::size_t files = folder.number_of_files();
  expect_one_line(tessellate("quads.off", "out.ply", options), 1, "chord error");
  EXPECT_EQ(content("out.ply"), "untouched");
  EXPECT_EQ(folder.number_of_files(), files);
  expect_one_line(tessellate("quads.off", "out.ply", "--chord 0.01 --pieces 3 --resume"), 2,
                  "--chord and --resume");
  EXPECT_EQ(content("out.ply"), "untouched");
}

#ifdef __unix__
TEST_F(Chord_in_pieces, AFullDisk)
{
  const std::size_t files = folder.number_of_files();
  const std::string arguments = "surface '" + folder.file("quads.off") + "' '" +
                                folder.file("out.ply") + "' --quiet --chord 0.002 --pieces 7";
  expect_one_line(run(arguments, "ulimit -f 20; "), 1, "out.ply");
  EXPECT_EQ(folder.number_of_files(), files);
}
#endif

} // namespace
} // namespace pn_subdivide

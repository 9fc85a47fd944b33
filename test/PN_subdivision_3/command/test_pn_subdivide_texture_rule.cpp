// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// What --texture-rule says to texture coordinates. That the rules are right is tested where they are computed.

#include "Command_test.h"

#include "io/mesh_io.h"

#include <array>
#include <set>

using namespace pn_subdivide;

namespace {

const std::array<const char*, 6> rules{"none",          "corners-only", "corners-plus1",
                                       "corners-plus2", "boundaries",   "all"};

// 4 x 4 quads in the plane. Below y = 2 one chart but for a face at its edge, above two; a chart's texture points are
// 100 times its number off (x, y + x x y / 16).
class Pn_subdivide_texture_rule : public Command_test
{
protected:
  std::string patch() const
  {
    std::ostringstream s;
    for (int v = 0; v < 25; ++v) s << "v " << v % 5 << ' ' << v / 5 << " 0\n";
    std::ostringstream faces;
    int number = 0;
    for (int f = 0; f < 16; ++f) {
      const int x = f % 4, y = f / 4;
      const int chart = x == 3 && y == 0 ? 3 : y < 2 ? 0 : 1 + x / 2;
      faces << "f";
      for (const auto& d : {std::array<int, 2>{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
        const int i = x + d[0], j = y + d[1];
        s << "vt " << i + 100 * chart << ' ' << j + i * i * j / 16. << "\n";
        faces << ' ' << 5 * j + i + 1 << '/' << ++number;
      }
      faces << "\n";
    }
    return folder.write("patch.obj", s.str() + faces.str());
  }

  std::string refined(const std::string& options) const
  {
    const std::string output = folder.file("refined.obj");
    const Outcome outcome = done(
      run("'" + patch() + "' '" + output + "' --quiet --linear --scheme catmull-clark " + options));
    EXPECT_EQ(outcome.err, "");
    return folder.content(folder.file("refined.obj"));
  }

  // the texture points of one round at a vertex, in the order of the charts
  std::vector<Texture_point> at(int x, int y, const std::string& options) const
  {
    refined(options);
    const Mesh_data mesh = read_mesh(folder.file("refined.obj"));
    std::set<Texture_point> points;
    std::size_t corner = 0;
    for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
      for (const Mesh_data::Index v : mesh.face(f)) {
        if (v == Mesh_data::Index(5 * y + x)) points.insert(mesh.attributes.texture[corner]);
        ++corner;
      }
    return {points.begin(), points.end()};
  }
};

} // namespace

TEST_F(Pn_subdivide_texture_rule, EveryWordIsARuleOfItsOwn)
{
  std::map<std::string, std::string> output;
  for (const std::string rule : rules) output[refined("--levels 2 --texture-rule " + rule)] = rule;
  EXPECT_EQ(output.size(), rules.size());
  EXPECT_EQ(output[refined("--levels 2")], "corners-plus1");
}

// At a corner of one face (1, 6, 1)/8 or nothing; beside the chart of one face the chart of three moves or not; where
// three charts meet that of two faces does.
TEST_F(Pn_subdivide_texture_rule, WhatStays)
{
  using Points = std::vector<Texture_point>;
  EXPECT_EQ(at(0, 0, "--texture-rule none"), (Points{{0.125, 0.125, 0}}));
  for (const char* rule : {"corners-only", "corners-plus1", "corners-plus2", "boundaries", "all"})
    EXPECT_EQ(at(0, 0, std::string("--texture-rule ") + rule), (Points{{0, 0, 0}})) << rule;

  // (3, 1) in the chart of three faces, with (4, 1) and (3, 0) beside it
  const Texture_point moved{(6 * 3 + 4 + 3) / 8., (6 * (1 + 9 / 16.) + 2 + 0) / 8., 0};
  const Texture_point stays{3, 1 + 9 / 16., 0}, other{303, 1 + 9 / 16., 0};
  EXPECT_EQ(at(3, 1, "--texture-rule corners-plus1"), (Points{moved, other}));
  EXPECT_EQ(at(3, 1, "--texture-rule corners-plus2"), (Points{stays, other}));

  // (2, 2) in the chart below, with (1, 2) and (3, 2) beside it
  const Texture_point below{2, (6 * 2.5 + 2.125 + 3.125) / 8, 0};
  EXPECT_EQ(at(2, 2, "--texture-rule corners-only").front(), below);
  EXPECT_EQ(at(2, 2, "--texture-rule corners-plus1"),
            (Points{{2, 2.5, 0}, {102, 2.5, 0}, {202, 2.5, 0}}));
}

TEST_F(Pn_subdivide_texture_rule, UsageErrors)
{
  const std::string input = patch();
  const auto expect_error = [&](const std::string& options, const std::vector<std::string>& parts) {
    expect_refusal(input, "out.obj", options, parts);
  };
  for (const std::string rule : rules)
    expect_error("--drop-attributes --texture-rule " + rule,
                 {"--texture-rule", "--drop-attributes"});
  for (const std::string scheme : {"doo-sabin", "sqrt3"})
    for (const std::string rule : {"boundaries", "all"})
      expect_error("--scheme " + scheme + " --texture-rule " + rule,
                   {"--texture-rule " + rule, "--scheme " + scheme});
  expect_error("--texture-rule corners", {"--texture-rule 'corners'", "corners-only"});
  expect_error("--texture-rule corner-plus2", {"did you mean corners-plus2?"});
  expect_error("--texture-rul all", {"did you mean --texture-rule?"});
  expect_error("--texture-rule", {"--texture-rule"});
}

// With limits, in several threads, with creases, and piece by piece, where there is nothing that it could rule.
TEST_F(Pn_subdivide_texture_rule, GoesWithOtherOptions)
{
  const std::string plain = "--levels 2 --texture-rule corners-plus2";
  const auto texture_of = [](const std::string& obj) {
    std::string lines;
    std::istringstream s(obj);
    for (std::string line; std::getline(s, line);)
      if (line.rfind("vt ", 0) == 0) lines += line + "\n";
    return lines;
  };
  const std::string expected = texture_of(refined(plain));
  EXPECT_FALSE(expected.empty());
  for (const char* options : {" --limit", " --threads 2", " --border curve"})
    EXPECT_EQ(texture_of(refined(plain + options)), expected) << options;
  done(run("'" + folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n") + "' '" +
           folder.file("a.ply") + "' --quiet --pieces 2 --texture-rule boundaries"));
}

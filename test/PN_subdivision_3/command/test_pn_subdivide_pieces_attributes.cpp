// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
// What files carry besides points and normals, refined in pieces.

#include "Extent.h"
#include "Pieces_test.h"

#include "io/mesh_io.h"

namespace {

class Attributes_in_pieces : public Pieces
{
protected:
  // Numbers of vertices of several types, two of faces, and texture coordinates of corners in charts, or without seams.
  void write_ply(const std::string& off, bool has_seams)
  {
    using namespace pn_subdivide;
    Mesh_data mesh = read_mesh(folder.file(off));
    Attributes& a = mesh.attributes;
    a.texture_files = {"wood.png"};
    a.of_vertices = {{"heat", Scalar_type::float32, {}, {}},
                     {"red", Scalar_type::uint8, {}, {}},
                     {"green", Scalar_type::uint8, {}, {}},
                     {"blue", Scalar_type::uint8, {}, {}},
                     {"label", Scalar_type::int16, {}, {}}};
    a.of_faces = {{"material", Scalar_type::int32, {}, {"red", "two words"}},
                  {"weight", Scalar_type::float64, {}, {}}};
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      const double row[] = {double(v * v % 11) + .25, double(37 * v % 256), 255. - double(v), 7,
                            double(v % 5) - 2};
      for (std::size_t k = 0; k < 5; ++k) a.of_vertices[k].values.push_back(row[k]);
    }
    for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
      a.of_faces[0].values.push_back(double(f % 2));
      a.of_faces[1].values.push_back(double(f) + .5);
      for (const std::size_t v : mesh.face(f))
        a.texture.push_back(
          {(has_seams && f % 7 < 2 ? 100. : 0.) + double(v / 6) + .1 * double(v % 3), double(v % 6),
           0});
    }
    write_mesh(folder.file("in.ply"), mesh, Encoding::text);
  }
};

TEST_F(Attributes_in_pieces, AreThoseOfTheWholeFile)
{
  for (const bool has_seams : {false, true})
    for (const std::string scheme :
         {"catmull-clark", "loop", "butterfly", "kobbelt", "modified-loop", "bilinear"}) {
      write_ply(takes_triangles(scheme) ? "triangles.off" : "quads.off", has_seams);
      expect_same(scheme, "in.ply", "--levels 1", {"1", "2", "30"});
      if (tests_are_full)
        expect_same(scheme, "in.ply", "--levels 3", {"1", "2", "30"});
      else
        expect_same(scheme, "in.ply", "--levels 2", {has_seams ? "2" : "30"});
      expect_part(content("out.ply"), "property float heat");
    }
}

TEST_F(Attributes_in_pieces, WithOtherOptions)
{
  write_ply("quads.off", true);
  for (const std::string rule :
       {"none", "corners-only", "corners-plus1", "corners-plus2", "boundaries", "all"})
    expect_same("catmull-clark", "in.ply", "--levels 2 --texture-rule " + rule, {"5"});
  for (const char* const options :
       {"--levels 0", "--levels 2 --linear", "--levels 3 --sharp angle:25 --sharpness 1.5",
        "--levels 3 --sharp angle:25 --border curve", "--levels 2 --limit",
        "--levels 1 --output-normals surface", "--levels 3 --output-normals both",
        "--levels 2 --threads 2", "--levels 2 --resume"})
    expect_same("catmull-clark", "in.ply", options, {"5"});
}

TEST_F(Attributes_in_pieces, OfOtherFormats)
{
  folder.write("in.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0.5\nv 0 1 0\nv 2 0 0\nv 2 1 0\n"
                         "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 0.5 0.5\ng left\nusemtl red\n"
                         "f 1/1 2/2 3/3 4/4\ng right\nusemtl blue\nf 2/1 5/2 6/5 3/4\n");
  std::string off = content("triangles.off");
  std::istringstream in(off);
  std::string line, colored;
  for (int i = 0; std::getline(in, line); ++i)
    colored += (i == 0             ? "COFF"
                : i >= 2 && i < 39 ? line + " 0.1 0." + std::to_string(i) + " 1 1"
                                   : line) +
               "\n";
  folder.write("in.off", colored);
  for (const char* const levels : {"--levels 0", "--levels 2", "--levels 3"})
    for (const std::string name : {"in.obj", "in.off"})
      expect_same(name == "in.obj" ? "catmull-clark" : "loop", name, levels, {"4"});
  expect_part(content("out.ply"), "property uchar red");
}

TEST_F(Attributes_in_pieces, PvtpHasThoseOfTheVtpFile)
{
  for (const bool has_seams : {false, true}) {
    write_ply("quads.off", has_seams);
    done(run(job("catmull-clark", "in.ply", "whole.vtp") + "--levels 2"));
    const Outcome outcome =
      run(job("catmull-clark", "in.ply", "out.pvtp") + "--levels 2 --pieces 3");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err.find("texture coordinates") != std::string::npos, has_seams);
    const std::string index = content("out.pvtp");
    for (int i = 0; i < 3; ++i) {
      expect_rows<float>(i, "heat", 1);
      expect_rows<std::uint8_t>(i, "colors", 3);
      expect_rows<std::int16_t>(i, "label", 1);
      if (!has_seams) expect_rows<double>(i, "TCoords", 2);
      expect_rows<double>(i, "weight", 1, "GlobalCellIds");
    }
    for (const std::string name : {"heat", "colors", "label", "material", "weight"})
      EXPECT_NE(index.find("Name=\"" + name + "\""), std::string::npos) << name;
    EXPECT_EQ(index.find("TCoords=\"TCoords\"") != std::string::npos, !has_seams);
  }
}

TEST_F(Attributes_in_pieces, WhatSomeCornersLackIsRefused)
{
  write_ply("quads.off", false);
  std::string ply = content("in.ply");
  const std::size_t last = ply.rfind(" 8 ");
  folder.write("in.ply", ply.substr(0, last) + " 0\n");
  expect_one_line(run(job("catmull-clark", "in.ply", "out.ply") + "--levels 1 --pieces 2"), 1,
                  "--drop-attributes");
  done(run(job("catmull-clark", "in.ply", "out.pvtp") + "--levels 1 --pieces 2"));
}

} // namespace

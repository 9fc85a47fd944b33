// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The types in which colors and texture coordinates are written: those that other programs read, or those that a
// PLY file has had.

#include "Command_test.h"

#include "io/mesh_io.h"

#include <array>

using namespace pn_subdivide;

namespace {

// A quad, whose vertices all have the color, so that every new vertex has it, too.
struct Source
{
  std::string name, content;
  std::string type; // in which a PLY file has its colors, or empty
  std::array<double, 3> color;
};

std::string obj_with_colors()
{
  return "v 0 0 0 1 0.2 0.5\nv 1 0 0 1 0.2 0.5\nv 1 1 0 1 0.2 0.5\nv 0 1 0 1 0.2 0.5\nf 1 2 3 4\n";
}

std::string off_with_colors(const std::string& color)
{
  std::string s = "COFF\n4 1 0\n";
  for (const char* p : {"0 0 0 ", "1 0 0 ", "1 1 0 ", "0 1 0 "}) s += p + color + "\n";
  return s + "4 0 1 2 3\n";
}

std::string off_with_face_color(const std::string& color)
{
  return "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3 " + color + "\n";
}

std::string ply(const std::string& of_vertices, const std::vector<std::string>& rest,
                const std::string& of_faces = "", const std::string& rest_of_face = "")
{
  const char* const points[] = {"0 0 0", "1 0 0", "1 1 0", "0 1 0"};
  std::string s = "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\n"
                  "property double z\n" +
                  of_vertices + "element face 1\nproperty list uchar int vertex_indices\n" +
                  of_faces + "end_header\n";
  for (std::size_t v = 0; v < 4; ++v)
    s += points[v] + (rest.empty() ? "" : " " + rest[v % rest.size()]) + "\n";
  return s + "4 0 1 2 3 " + rest_of_face + "\n";
}

std::string ply_with_colors(const std::string& type, const std::string& color)
{
  return ply("property " + type + " red\nproperty " + type + " green\nproperty " + type + " blue\n",
             {color});
}

std::string vtk_name(const std::string& type)
{
  if (type == "uchar") return "UInt8";
  if (type == "ushort") return "UInt16";
  return type == "float" ? "Float32" : "Float64";
}

const std::vector<std::string> rounds_and_encodings = {"--levels 0", "--levels 0 --ascii",
                                                       "--levels 1", "--levels 2 --ascii"};

class Pn_subdivide_types : public Command_test
{
protected:
  std::string written(const std::string& input, const std::string& output,
                      const std::string& options)
  {
    const std::string all = "--quiet --linear --scheme catmull-clark " + options;
    EXPECT_EQ(done(surface(input, output, all)).err, "");
    return content(output);
  }

  void expect_colors(const std::vector<Source>& sources, Columns Attributes::*of)
  {
    for (const Source& source : sources)
      for (const std::string& options : rounds_and_encodings) {
        SCOPED_TRACE(source.name + " " + options);
        folder.write(source.name, source.content);
        const std::string type = source.type.empty() ? "uchar" : source.type;
        const std::string text = written(source.name, "b.ply", options);
        for (const char* channel : {"red", "green", "blue"})
          expect_part(text, "property " + type + " " + channel + "\n");
        const Columns columns = read_mesh(folder.file("b.ply")).attributes.*of;
        ASSERT_EQ(columns.size(), 3u);
        for (std::size_t i = 0; i < 3; ++i)
          for (const double x : columns[i].values) EXPECT_EQ(x, source.color[i]);
        expect_part(written(source.name, "b.vtp", options),
                    "type=\"" + vtk_name(type) + "\" Name=\"colors\"");
      }
  }
};

} // namespace

TEST_F(Pn_subdivide_types, ColorsAreBytesUnlessAPlyFileHasAnotherType)
{
  expect_colors({{"a.obj", obj_with_colors(), "", {255, 51, 128}},
                 {"fractions.off", off_with_colors("1.0 0.2 0.5"), "", {255, 51, 128}},
                 {"bytes.off", off_with_colors("255 51 7"), "", {255, 51, 7}},
                 {"uchar.ply", ply_with_colors("uchar", "255 51 7"), "uchar", {255, 51, 7}},
                 {"ushort.ply", ply_with_colors("ushort", "65535 51 7"), "ushort", {65535, 51, 7}},
                 {"float.ply", ply_with_colors("float", "1 0.25 0.5"), "float", {1, 0.25, 0.5}},
                 {"double.ply", ply_with_colors("double", "1 0.2 0.5"), "double", {1, 0.2, 0.5}}},
                &Attributes::of_vertices);
}

TEST_F(Pn_subdivide_types, ColorsOfFacesAreBytesToo)
{
  const std::string properties = "property float red\nproperty float green\nproperty float blue\n";
  expect_colors({{"fractions.off", off_with_face_color("1.0 0.2 0.5"), "", {255, 51, 128}},
                 {"bytes.off", off_with_face_color("255 51 7"), "", {255, 51, 7}},
                 {"float.ply", ply("", {}, properties, "1 0.25 0.5"), "float", {1, 0.25, 0.5}}},
                &Attributes::of_faces);
}

TEST_F(Pn_subdivide_types, TextureCoordinatesAreFloatsUnlessAPlyFileHasAnotherType)
{
  const std::string corners = "8 0.1 0.1 0.9 0.1 0.9 0.9 0.1 0.9";
  const std::vector<std::string> of_vertices = {"0.1 0.1", "0.9 0.1", "0.9 0.9", "0.1 0.9"};
  const std::string obj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0.1 0.1\nvt 0.9 0.1\n"
                          "vt 0.9 0.9\nvt 0.1 0.9\nf 1/1 2/2 3/3 4/4\n";
  const std::string off = "STOFF\n4 1 0\n0 0 0 0.1 0.1\n1 0 0 0.9 0.1\n1 1 0 0.9 0.9\n"
                          "0 1 0 0.1 0.9\n4 0 1 2 3\n";
  const auto list = [&](const std::string& type) {
    return ply("", {}, "property list uchar " + type + " texcoord\n", corners);
  };
  const auto pair = [&](const std::string& type) {
    return ply("property " + type + " s\nproperty " + type + " t\n", of_vertices);
  };
  struct Texture
  {
    std::string name, content, property;
    bool is_double;
  };
  const std::vector<Texture> sources = {
    {"a.obj", obj, "property list uchar float texcoord\n", false},
    {"a.off", off, "property float s\nproperty float t\n", false},
    {"list_float.ply", list("float"), "property list uchar float texcoord\n", false},
    {"list_double.ply", list("double"), "property list uchar double texcoord\n", true},
    {"float.ply", pair("float"), "property float s\nproperty float t\n", false},
    {"double.ply", pair("double"), "property double s\nproperty double t\n", true}};
  for (const Texture& source : sources)
    for (const std::string& options : rounds_and_encodings) {
      SCOPED_TRACE(source.name + " " + options);
      folder.write(source.name, source.content);
      const std::string text = written(source.name, "b.ply", options);
      expect_part(text, source.property);
      const Attributes a = read_mesh(folder.file("b.ply")).attributes;
      std::vector<double> numbers;
      for (const Texture_point& t : a.texture) numbers.insert(numbers.end(), t.begin(), t.end());
      for (const Column& column : a.of_vertices)
        numbers.insert(numbers.end(), column.values.begin(), column.values.end());
      ASSERT_FALSE(numbers.empty());
      if (contains(options, "--levels 0")) {
        for (const double x : numbers) {
          EXPECT_TRUE(x == 0 || x == (x < 0.5            ? source.is_double ? 0.1 : double(0.1f)
                                                 : source.is_double ? 0.9
                                                         : double(0.9f)));
        }
      }
      const auto is_float = [](double x) { return x == double(float(x)); };
      EXPECT_EQ(std::all_of(numbers.begin(), numbers.end(), is_float), !source.is_double);
      expect_part(written(source.name, "b.vtp", options), std::string("type=\"Float") +
                                                            (source.is_double ? "64" : "32") +
                                                            "\" Name=\"TCoords\"");
    }
}

// Where numbers are text, nothing is lost.
TEST_F(Pn_subdivide_types, ObjAndOffKeepTheirNumbers)
{
  folder.write("a.obj", obj_with_colors());
  expect_part(written("a.obj", "b.obj", "--levels 0"), " 1 0.20000000000000001 0.5\n");
  expect_part(written("a.obj", "b.off", "--levels 0"), "1.0 0.20000000000000001 0.5\n");
}

TEST_F(Pn_subdivide_types, TextureCoordinatesThatNoFloatHoldsStayAsTheyAre)
{
  folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 1e300 0\nf 1/1 2/1 3/1\n");
  expect_part(written("a.obj", "b.ply", "--levels 0"), "uchar double texcoord\n");
  EXPECT_EQ(read_mesh(folder.file("b.ply")).attributes.texture.at(0)[0], 1e300);
}

// From PLY to OBJ and back the numbers are those of the first file, up to their type.
TEST_F(Pn_subdivide_types, BytesComeBackFromFractions)
{
  std::string properties;
  for (const char* channel : {"red", "green", "blue"})
    properties += std::string("property uchar ") + channel + "\n";
  folder.write("a.ply", ply(properties, {"0 1 2", "3 127 128", "253 254 255", "9 99 199"}));
  written("a.ply", "b.obj", "--levels 0");
  written("b.obj", "c.ply", "--levels 0");
  const Columns first = read_mesh(folder.file("a.ply")).attributes.of_vertices;
  const Columns last = read_mesh(folder.file("c.ply")).attributes.of_vertices;
  ASSERT_EQ(last.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(last[i].type, Scalar_type::uint8);
    EXPECT_EQ(last[i].values, first[i].values);
  }
}

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// What files say besides points, normals and faces: read, written to the last bit, converted, and
// refused where it is damaged.

#include "Extent.h"
#include "File_test.h"
#include "Part_files.h"

#include "io/soup_repair.h"

#include <limits>

using namespace pn_subdivide;

namespace {

using Names = std::vector<std::string>;
using Numbers = std::vector<double>;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

void expect_same(const Columns& a, const Columns& b)
{
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].name, b[i].name);
    EXPECT_EQ(a[i].type, b[i].type) << a[i].name;
    EXPECT_EQ(bits(a[i].values), bits(b[i].values)) << a[i].name;
    EXPECT_EQ(a[i].words, b[i].words) << a[i].name;
  }
}

void expect_same(const Attributes& a, const Attributes& b)
{
  expect_same(a.of_vertices, b.of_vertices);
  expect_same(a.of_faces, b.of_faces);
  EXPECT_EQ(bits(a.texture), bits(b.texture));
  EXPECT_EQ(a.texture_files, b.texture_files);
  EXPECT_EQ(a.material_files, b.material_files);
}

const Numbers& values(const Columns& columns, const char* name)
{
  static const Numbers none;
  const Column* const column = find_column(columns, name);
  EXPECT_NE(column, nullptr) << name;
  return column == nullptr ? none : column->values;
}

class Pn_subdivide_attributes : public File_test
{
protected:
  // without attributes the file is read
  void expect_error(const std::string& name, const std::string& content,
                    const std::string& part) const
  {
    EXPECT_NO_THROW(read(name, content, false));
    File_test::expect_error(name, content, part);
  }

  Names not_held_by(const std::string& name, const Mesh_data& mesh) const
  {
    return not_held(output_mesh_file(name, std::nullopt), mesh);
  }
};

// A quad and two triangles around vertex 0; the seam is the edge 0-2.
const std::string obj =
  "mtllib house.mtl\nmtllib other one.mtl\no thing\n"
  "v 0 0 0 0 0.25 1\nv 1 0 0 0.1 0 0\nv 1 1 0 1 1 1\nv 0 1 0 0 0 0\nv -1 0.5 0 0.5 0.5 0.5\n"
  "vt 0 0\nvt 0.1 0\nvt 0.1 0.30000000000000004\nvt 0.7 1e-300\nvt -0.0 1\n"
  "f 1/1 2/2 3/3\n"
  "g left upper\nusemtl wood #2\ns 1 # not that\n"
  "f 1/4 3/-1 4/5\n"
  "usemtl red\ns off\n"
  "f 1 4 5\n";

// --- OBJ ---

TEST_F(Pn_subdivide_attributes, ObjIsRead)
{
  const Attributes a = read("a.obj", obj).attributes;
  EXPECT_EQ(a.material_files, (Names{"house.mtl", "other one.mtl"}));
  EXPECT_EQ(values(a.of_vertices, "green"), (Numbers{0.25, 0, 1, 0, 0.5}));
  ASSERT_EQ(a.texture.size(), 9u);
  EXPECT_EQ(a.texture[2], (Texture_point{0.1, 0.30000000000000004, 0}));
  EXPECT_EQ(a.texture[3], (Texture_point{0.7, 1e-300, 0}));
  EXPECT_EQ(a.texture[4], a.texture[5]); // -1 is the fifth
  EXPECT_TRUE(std::all_of(a.texture.begin() + 6, a.texture.end(), is_none));
  EXPECT_EQ(values(a.of_faces, "object"), (Numbers{0, 0, 0}));
  EXPECT_EQ(values(a.of_faces, "group"), (Numbers{-1, 0, 0}));
  EXPECT_EQ(values(a.of_faces, "material"), (Numbers{-1, 0, 1}));
  EXPECT_EQ(values(a.of_faces, "smoothing_group"), (Numbers{0, 1, 0}));
  EXPECT_EQ(find_column(a.of_faces, "material")->words, (Names{"wood #2", "red"}));
  EXPECT_EQ(find_column(a.of_faces, "group")->words, (Names{"left upper"}));
  EXPECT_TRUE(read("a.obj", obj, false).attributes.empty());
  EXPECT_TRUE(read("a.obj", obj, false).dropped.empty());
}

TEST_F(Pn_subdivide_attributes, ObjComesBackFromObjAndPlyAsItWas)
{
  const Mesh_data mesh = read("a.obj", obj);
  expect_same(written_and_read("b.obj", mesh).attributes, mesh.attributes);
  EXPECT_EQ(not_held_by("b.obj", mesh), Names());
  EXPECT_EQ(not_held_by("b.ply", mesh), Names());
  for (const Encoding encoding : {Encoding::binary, Encoding::text}) {
    const Mesh_data ply = written_and_read("b.ply", mesh, encoding);
    expect_same(ply.attributes, mesh.attributes);
    expect_same(written_and_read("c.obj", ply).attributes, mesh.attributes);
  }
  write_mesh(folder.file("b.obj"), mesh, Encoding::text);
  const std::string text = Temporary_folder::content(folder.file("b.obj"));
  expect_part(
    text,
    "\no thing\nf 1/1 2/2 3/3\ng left upper\nusemtl wood #2\ns 1\nf 1/4 3/5 4/6\n"); // texture points are written once a vertex
}

TEST_F(Pn_subdivide_attributes, ObjStatementsOfEveryKind)
{
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n", face = "f 1 2 3\n";
  // "s off" and texture coordinates without faces say nothing, "s on" is group 1, "g" is "default"
  EXPECT_TRUE(read("a.obj", points + "s off\ns 0\n" + face).attributes.empty());
  Mesh_data mesh = read("a.obj", points + "vt 0 0\ns on\ng\n" + face);
  EXPECT_EQ(values(mesh.attributes.of_faces, "smoothing_group"), Numbers{1});
  EXPECT_EQ(find_column(mesh.attributes.of_faces, "group")->words, Names{"default"});
  EXPECT_EQ(mesh.dropped, Names{"texture coordinates that no face has"});
  mesh = read("a.obj", points + "mg 3\ns x\nl 1 2\n" + face);
  EXPECT_EQ(mesh.dropped,
            (Names{"'mg'", "smoothing groups that are no number", "lines and points"}));
  // one, two or three numbers; three are kept if the last is not 0
  mesh = read("a.obj", points + "vt 0.5\nvt 1 2 0\nf 1/1 2/2 3/2\n");
  EXPECT_EQ(mesh.attributes.texture[0], (Texture_point{0.5, 0, 0}));
  EXPECT_EQ(not_held_by("a.ply", mesh), Names());
  mesh = read("a.obj", points + "vt 1 2 3\nf 1/1 2/1 3/1\n");
  EXPECT_EQ(mesh.attributes.texture[0], (Texture_point{1, 2, 3}));
  expect_same(written_and_read("b.obj", mesh).attributes, mesh.attributes);
  EXPECT_EQ(not_held_by("a.ply", mesh), Names{"third texture coordinates"});
}

// Four numbers behind the coordinates are a color with alpha, of which OBJ files of ours have none.
TEST_F(Pn_subdivide_attributes, ObjColorsWithAlpha)
{
  Mesh_data mesh = read("a.obj", "v 0 0 0 1 0.5 0.25 0.75\nv 1 0 0 0 0 1\nv 0 1 0 9\nf 1 2 3\n");
  const Columns& columns = mesh.attributes.of_vertices;
  ASSERT_EQ(columns.size(), 4u);
  EXPECT_EQ(values(columns, "red"), (Numbers{1, 0, 1}));
  EXPECT_EQ(values(columns, "green"), (Numbers{0.5, 0, 1}));
  EXPECT_EQ(values(columns, "blue"), (Numbers{0.25, 1, 1}));
  EXPECT_EQ(values(columns, "alpha"), (Numbers{0.75, 1, 1}));
  EXPECT_EQ(not_held_by("b.ply", mesh), Names());
  EXPECT_EQ(not_held_by("b.obj", mesh), Names{"'alpha' of vertices"});
  mesh = read("a.obj", "v 0 0 0 1 1\nv 1 0 0 1 1 0 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_TRUE(mesh.attributes.empty());
  EXPECT_EQ(mesh.dropped, Names{"numbers behind coordinates that are no color"});
}

// Names go to the end of the line; other statements have comments.
TEST_F(Pn_subdivide_attributes, ObjNames)
{
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n", face = "f 1 2 3\n";
  const Mesh_data mesh = read("a.obj", "mtllib C:\\my parts\\\nmtllib a #1.mtl # x\n" + points +
                                         "usemtl Material #25\no #1\n" + face +
                                         "usemtl Material #26\r\ng a\\\ns 3 # x\n" + face);
  const Attributes& a = mesh.attributes;
  EXPECT_EQ(a.material_files, (Names{"C:\\my parts\\", "a #1.mtl # x"}));
  EXPECT_EQ(find_column(a.of_faces, "material")->words, (Names{"Material #25", "Material #26"}));
  EXPECT_EQ(values(a.of_faces, "material"), (Numbers{0, 1}));
  EXPECT_EQ(find_column(a.of_faces, "object")->words, Names{"#1"});
  EXPECT_EQ(find_column(a.of_faces, "group")->words, Names{"a\\"});
  EXPECT_EQ(values(a.of_faces, "smoothing_group"), (Numbers{0, 3}));
  EXPECT_EQ(mesh.dropped, Names());
  for (const char* const name : {"b.obj", "b.ply"})
    expect_same(written_and_read(name, mesh).attributes, a);
}

TEST_F(Pn_subdivide_attributes, ObjDamage)
{
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\n";
  expect_error("a.obj", points + "f 1/1 2/2 3/1\n", "line 5: the face's texture index 2 is out of");
  expect_error("a.obj", points + "f 1/1 2/-2 3/1\n", "line 5: a texture index -2 is out of range");
  expect_error("a.obj", points + "f 1/1 2/0 3/1\n", "line 5: a texture index 0 is out of range");
  expect_error("a.obj", points + "f 1/x 2/1 3/1\n", "line 5: 'x' stands where a texture index");
  expect_error("a.obj", points + "vt nan 0\nf 1 2 3\n", "line 5: a texture coordinate that is not");
  expect_error("a.obj", points + "vt 0 inf\nf 1 2 3\n", "line 5: a texture coordinate that is not");
  expect_error("a.obj", points + "vt\nf 1 2 3\n", "line 5: the line ends where a texture coord");
  expect_error("a.obj", points + "v 0 0 0 0 1 2\nf 1 2 3\n", "line 5: a color out of range");
  expect_error("a.obj", points + "v 0 0 0 1 0 nan 0\nf 1 2 3\n", "line 5: a color out of range");
}

// --- PLY ---

// Every type at vertices and faces, and lists of texture coordinates, one of them empty.
std::string ply_with_every_type(const std::string& format, bool with_texture = true)
{
  std::string s = "ply\nformat " + format + " 1.0\ncomment TextureFile wood grain.png\n";
  for (const char* element : {"vertex 4\nproperty double x\nproperty double y\nproperty double z",
                              "face 2\nproperty list uchar int vertex_indices"}) {
    s += std::string("element ") + element + "\n";
    for (const char* type : {"char", "uint8", "short", "uint16", "int32", "uint", "float"})
      s += std::string("property ") + type + " a_" + type + "\n";
    s += "property double double#1\n";
  }
  if (with_texture) s += "property list ushort float texcoord\n";
  return s + "end_header\n";
}

const Numbers lowest = {-128, 0, -32768, 0, -2147483648., 0, -0.1, -1.7976931348623157e308};
const Numbers highest = {127,        255,        32767, 65535,
                         2147483647, 4294967295, 0.1,   4.9406564584124654e-324};

template <class Put>
void for_each_number(const Put& put)
{
  const auto put_types = [&put](const Numbers& n) {
    put(static_cast<std::int8_t>(n[0]));
    put(static_cast<std::uint8_t>(n[1]));
    put(static_cast<std::int16_t>(n[2]));
    put(static_cast<std::uint16_t>(n[3]));
    put(static_cast<std::int32_t>(n[4]));
    put(static_cast<std::uint32_t>(n[5]));
    put(static_cast<float>(n[6]));
    put(n[7]);
  };
  for (int v = 0; v < 4; ++v) {
    for (const double x : {v % 2 * 1., v / 2 * 1., 0.5}) put(x);
    put_types(v % 2 == 0 ? lowest : highest);
  }
  for (int f = 0; f < 2; ++f) {
    put(std::uint8_t(3));
    for (const int v : {0, 1 + f, 3 - f}) put(v); // wrong orientation does not matter here
    put_types(f == 0 ? highest : lowest);
    put(static_cast<std::uint16_t>(f == 0 ? 6 : 0));
    for (int i = 0; i < 6 && f == 0; ++i) put(0.1f * float(i));
  }
}

void expect_every_type(const Attributes& a)
{
  for (const auto& [columns, first] :
       {std::pair(&a.of_vertices, &lowest), std::pair(&a.of_faces, &highest)}) {
    ASSERT_EQ(columns->size(), 8u);
    const Numbers& second = first == &lowest ? highest : lowest;
    for (std::size_t i = 0; i < 8; ++i) {
      const Column& column = (*columns)[i];
      EXPECT_EQ(column.type, static_cast<Scalar_type>(i));
      const auto rounded = [i](double x) { return i == 6 ? double(float(x)) : x; };
      EXPECT_EQ(column.values[0], rounded((*first)[i])) << column.name;
      EXPECT_EQ(column.values[1], rounded(second[i])) << column.name;
    }
    EXPECT_EQ((*columns)[3].name, "a_uint16");
    EXPECT_EQ((*columns)[7].name, "double#1");
  }
  EXPECT_EQ(a.texture_files, Names{"wood grain.png"});
  EXPECT_EQ(a.texture_type, Scalar_type::float32);
  ASSERT_EQ(a.texture.size(), 6u);
  EXPECT_EQ(a.texture[1], (Texture_point{double(0.1f * 2.f), double(0.1f * 3.f), 0}));
  EXPECT_TRUE(std::all_of(a.texture.begin() + 3, a.texture.end(), is_none));
}

TEST_F(Pn_subdivide_attributes, PlyOfEveryTypeAndByteOrder)
{
  std::string text = ply_with_every_type("ascii");
  for_each_number([&text](auto x) {
    char digits[40];
    std::snprintf(digits, sizeof digits, std::is_same_v<decltype(x), float> ? "%.9g " : "%.17g ",
                  double(x));
    text += digits;
  });
  Names files = {text};
  for (const bool big : {false, true}) {
    files.push_back(ply_with_every_type(big ? "binary_big_endian" : "binary_little_endian"));
    for_each_number([&](auto x) { files.back() += raw(x, big); });
  }
  for (const std::string& file : files) {
    const Mesh_data mesh = read("a.ply", file);
    EXPECT_EQ(mesh.dropped, Names());
    expect_every_type(mesh.attributes);
    for (const Encoding encoding : {Encoding::binary, Encoding::text})
      expect_same(written_and_read("b.ply", mesh, encoding).attributes, mesh.attributes);
    EXPECT_TRUE(read("a.ply", file, false).attributes.empty());
    // truncated anywhere
    const std::size_t header = file.find("end_header\n") + 11;
    for (std::size_t n = header; n < file.size() - 2; n += tests_are_full ? 1 : 7) {
      folder.write("short.ply", file.substr(0, n));
      EXPECT_THROW(read_mesh(folder.file("short.ply")), Error) << n;
    }
  }
}

const std::string ply_head = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                             "property float y\nproperty float z\n";
const std::string ply_faces = "element face 1\nproperty list uchar int vertex_indices\n";

TEST_F(Pn_subdivide_attributes, PlyKeepsWhatIsNotANumber)
{
  const Mesh_data mesh = read(
    "a.ply", ply_head + "property double q\n" + ply_faces +
               "property float w\nend_header\n0 0 0 nan\n1 0 0 inf\n0 1 0 -inf\n3 0 1 2 nan\n");
  EXPECT_EQ(bits(values(mesh.attributes.of_vertices, "q")),
            bits(Numbers{not_a_number, infinity, -infinity}));
  for (const Encoding encoding : {Encoding::binary, Encoding::text})
    expect_same(written_and_read("b.ply", mesh, encoding).attributes, mesh.attributes);
}

TEST_F(Pn_subdivide_attributes, PlyDamage)
{
  const auto file = [](const std::string& of_vertices, const std::string& of_faces,
                       const std::string& vertex, const std::string& face) {
    return ply_head + of_vertices + ply_faces + of_faces + "end_header\n0 0 0 " + vertex +
           "\n1 0 0 " + vertex + "\n0 1 0 " + vertex + "\n3 0 1 2 " + face + "\n";
  };
  const std::string red = "property uchar red\n";
  expect_error(
    "a.ply", file(red, "", "256", ""),
    "line 11: 256 does not fit into 'red', which is of type uchar (whole numbers from 0 to "
    "255) (in vertex 0 of 3)");
  expect_error("a.ply", file(red, "", "0.5", ""), "0.5 does not fit into 'red'");
  expect_error("a.ply", file(red, "", "-1", ""), "-1 does not fit into 'red'");
  expect_error("a.ply", file(red, "", "nan", ""), "nan does not fit into 'red'");
  expect_error("a.ply", file("property float q\n", "", "1e39", ""), "does not fit into 'q'");
  expect_error("a.ply", file("", "property int id\n", "", "3e9"),
               "line 14: 3000000000 does not fit into 'id'");
  const std::string texture = "property list uchar float texcoord\n";
  expect_error("a.ply", file("", texture, "", "4 0 0 1 0"),
               "face 0 of 1 has 4 texture coordinates for 3 vertices");
  expect_error("a.ply", file("", texture, "", "6 0 0 1 0 1 nan"),
               "face 0 of 1 has a texture coordinate that is not finite");
  expect_error("a.ply", file("property float s\nproperty float t\n", "", "0 inf", ""),
               "vertex 0 of 3 has a texture coordinate that is not finite");
  EXPECT_EQ(
    read("a.ply", file("property list uchar int l\n", "property list uchar int m\n", "0", "1 7"))
      .dropped,
    (Names{"the property 'l'", "the property 'm'"}));
}

TEST_F(Pn_subdivide_attributes, PlyCommentsThatAreNoWords)
{
  const Mesh_data mesh =
    read("a.ply", "ply\nformat ascii 1.0\ncomment material 0 red  stone \ncomment material 2 gap\n"
                  "comment material\ncomment material 1 blue\ncomment area 0 no integer\n" +
                    ply_head.substr(21) + ply_faces +
                    "property uchar material\nproperty float area\nend_header\n0 0 0\n1 0 0\n0 1 "
                    "0\n3 0 1 2 1 0\n");
  EXPECT_EQ(find_column(mesh.attributes.of_faces, "material")->words,
            (Names{"red  stone", "blue"}));
  EXPECT_EQ(find_column(mesh.attributes.of_faces, "area")->words, Names());
}

// --- OFF ---

TEST_F(Pn_subdivide_attributes, OffColorsAndTexture)
{
  const std::string faces = "3 0 1 2 1 2 3\n3 0 2 1\n";
  for (const std::string texture : {"", "ST"}) {
    const std::string t = texture.empty() ? "" : " 0.1 -0.25";
    const Mesh_data mesh =
      read("a.off", texture + "CNOFF\n3 2 0\n0 0 0 0 0 1 255 0 7 128" + t + "\n1 0 0 0 0 1 0 0 0" +
                      t + "\n0 1 0 0 0 1" + t + "\n" + faces);
    const Attributes& a = mesh.attributes;
    EXPECT_EQ(values(a.of_vertices, "red"), (Numbers{255, 0, 170})); // gray without a color
    EXPECT_EQ(values(a.of_vertices, "alpha"), (Numbers{128, 255, 255}));
    EXPECT_EQ(a.of_vertices[0].type, Scalar_type::uint8);
    EXPECT_EQ(values(a.of_faces, "blue"), (Numbers{3, 170}));
    EXPECT_EQ(find_column(a.of_faces, "alpha"), nullptr);
    if (!texture.empty()) {
      EXPECT_EQ(values(a.of_vertices, "t"), (Numbers{-0.25, -0.25, -0.25}));
    }
    for (const char* name : {"b.off", "b.ply"}) {
      expect_same(written_and_read(name, mesh).attributes, a);
      EXPECT_EQ(not_held_by(name, mesh), Names());
    }
  }
}

// Some programs leave the C out; three numbers could be normals.
TEST_F(Pn_subdivide_attributes, OffColorsWithoutTheirLetter)
{
  const std::string colored = "OFF\n3 1 0\n0 0 0 255 0 0 255\n1 0 0 0 9 0 128\n0 1 0\n3 0 1 2\n";
  const Mesh_data mesh = read("a.off", colored);
  EXPECT_EQ(values(mesh.attributes.of_vertices, "green"), (Numbers{0, 9, 170}));
  EXPECT_EQ(values(mesh.attributes.of_vertices, "alpha"), (Numbers{255, 128, 255}));
  EXPECT_TRUE(read("a.off", colored, false).attributes.empty());
  for (const std::string rest : {" 1 2 3", " 1 2 3 4 5", " x"})
    expect_error("a.off", "OFF\n3 1 0\n0 0 0" + rest + "\n1 0 0\n0 1 0\n3 0 1 2\n",
                 "--drop-attributes");
}

TEST_F(Pn_subdivide_attributes, OffFractionsAndMixedColors)
{
  const std::string points = "3 3 0\n0 0 0\n1 0 0\n0 1 0\n";
  // among fractions 1 0 0 is a fraction, 255 0 51 is not
  Mesh_data mesh =
    read("a.off", "OFF\n" + points + "3 0 1 2 0.1 0 1e-3\n3 0 1 2 1 0 0\n3 0 1 2 255 0 51\n");
  EXPECT_EQ(values(mesh.attributes.of_faces, "red"), (Numbers{0.1, 1, 1}));
  EXPECT_EQ(values(mesh.attributes.of_faces, "blue"), (Numbers{1e-3, 0, 0.2}));
  expect_same(written_and_read("b.off", mesh).attributes, mesh.attributes);
  mesh = read("a.off", "OFF\n" + points + "3 0 1 2 1.0 0 0\n3 0 1 2 0 1. 0 0.\n3 0 1 2 0 0 1\n");
  EXPECT_EQ(values(mesh.attributes.of_faces, "alpha"), (Numbers{1, 0, 1}));
  expect_same(written_and_read("b.off", mesh).attributes, mesh.attributes); // 1 0 0 is no byte
  mesh = read("a.off", "OFF\n" + points + "3 0 1 2 7\n3 0 1 2\n3 0 1 2\n");
  EXPECT_EQ(mesh.dropped, Names{"colors that are numbers of a color map"});
  EXPECT_TRUE(mesh.attributes.empty());
}

TEST_F(Pn_subdivide_attributes, OffDamage)
{
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n";
  expect_error("a.off", "OFF\n3 1 0\n" + points + "3 0 1 2 256 0 0\n", "line 6: a color out of");
  expect_error("a.off", "OFF\n3 1 0\n" + points + "3 0 1 2 0.5 0 1.5\n", "line 6: a color out of");
  expect_error("a.off", "OFF\n3 1 0\n" + points + "3 0 1 2 0 -1 0\n", "line 6: a color out of");
  expect_error("a.off", "OFF\n3 1 0\n" + points + "3 0 1 2 nan 0 0\n", "line 6: a color out of");
  expect_error("a.off", "OFF\n3 1 0\n" + points + "3 0 1 2 1 2\n", "line 6: a color of 2 numbers");
  expect_error("a.off", "STOFF\n3 1 0\n0 0 0 0 0\n0 1 0 nan 0\n1 1 0 0 0\n3 0 1 2\n",
               "line 4: a texture coordinate that is not finite");
}

// --- from one format to another ---

TEST_F(Pn_subdivide_attributes, TextureOfVerticesAndOfCorners)
{
  for (const char* names : {"s t", "u v", "texture_u texture_v"}) {
    const std::string first(names, std::strchr(names, ' ')), second = std::strchr(names, ' ') + 1;
    const Mesh_data mesh =
      read("a.ply", ply_head + "property float " + first + "\nproperty float " + second + "\n" +
                      ply_faces +
                      "end_header\n0 0 0 0 0.1\n1 0 0 1 0.2\n0 1 0 2 0.3\n3 0 1 "
                      "2\n");
    const Mesh_data as_obj = written_and_read("b.obj", mesh);
    ASSERT_EQ(as_obj.attributes.texture.size(), 3u);
    EXPECT_EQ(as_obj.attributes.texture[1], (Texture_point{1, double(0.2f), 0}));
    // without a seam they fit vertices again
    const Mesh_data as_off = written_and_read("b.off", as_obj);
    EXPECT_EQ(values(as_off.attributes.of_vertices, "t"),
              (Numbers{double(0.1f), double(0.2f), double(0.3f)}));
    for (const char* format : {"x.obj", "x.off", "x.vtp"}) {
      EXPECT_EQ(not_held_by(format, mesh), Names()) << format;
      EXPECT_EQ(not_held_by(format, as_obj), Names()) << format;
    }
  }
  const Mesh_data with_seam = read("a.obj", obj);
  EXPECT_EQ(not_held_by("x.vtp", with_seam), Names{"texture coordinates"});
}

TEST_F(Pn_subdivide_attributes, ColorsAsBytesAndAsFractions)
{
  const Mesh_data bytes =
    read("a.off", "COFF\n3 1 0\n0 0 0 255 51 0\n1 0 0 1 2 3\n0 1 0 0 0 254\n3 "
                  "0 1 2\n");
  const Mesh_data fractions = written_and_read("b.obj", bytes);
  EXPECT_EQ(values(fractions.attributes.of_vertices, "green"), (Numbers{0.2, 2 / 255., 0}));
  expect_same(written_and_read("b.off", fractions).attributes, fractions.attributes);
  EXPECT_EQ(not_held_by("x.obj", bytes), Names());
  EXPECT_EQ(not_held_by("x.stl", bytes), Names{"colors of vertices"});
}

TEST_F(Pn_subdivide_attributes, WhatAFormatCannotHoldIsNamed)
{
  const Mesh_data mesh = read("a.obj", obj);
  EXPECT_EQ(not_held_by("x.off", mesh),
            (Names{"texture coordinates", "objects", "groups", "materials", "smoothing groups",
                   "names of material files"}));
  EXPECT_EQ(not_held_by("x.stl", mesh).size(), 7u);
  EXPECT_EQ(written_and_read("x.off", mesh).attributes.of_vertices.size(), 3u);

  std::string text = ply_with_every_type("ascii");
  for_each_number([&text](auto x) { text += std::to_string(x) + " "; });
  const Mesh_data ply = read("a.ply", text);
  EXPECT_EQ(not_held_by("x.ply", ply), Names());
  EXPECT_EQ(not_held_by("x.obj", ply).size(), 17u);
  EXPECT_EQ(not_held_by("x.obj", ply)[0], "'a_char' of vertices");
  EXPECT_EQ(not_held_by("x.obj", ply)[16], "names of texture files");

  // 16 bits a channel are neither bytes nor fractions; alpha has no place in OBJ
  const auto colored = [&](const std::string& type, const std::string& color) {
    std::string properties;
    for (const char* channel : {"red", "green", "blue", "alpha"})
      properties += "property " + type + " " + channel + "\n";
    return read("a.ply", ply_head + properties + ply_faces + "end_header\n0 0 0 " + color +
                           "\n1 0 0 " + color + "\n0 1 0 " + color + "\n3 0 1 2\n");
  };
  EXPECT_EQ(not_held_by("x.off", colored("ushort", "9 9 9 9")),
            (Names{"colors of vertices", "'alpha' of vertices"}));
  EXPECT_EQ(not_held_by("x.off", colored("float", "0 0 2 1")).size(), 2u);
  EXPECT_EQ(not_held_by("x.off", colored("float", "0 0 1 1")), Names());
  EXPECT_EQ(not_held_by("x.obj", colored("uchar", "1 2 3 4")), Names{"'alpha' of vertices"});
}

TEST_F(Pn_subdivide_attributes, NumbersThatObjTakesForNames)
{
  const Mesh_data mesh =
    read("a.ply", ply_head +
                    "element face 3\nproperty list uchar int vertex_indices\nproperty short "
                    "material\nproperty uchar smoothing_group\nproperty float group\n"
                    "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 12 0 1\n3 0 1 2 12 3 1\n3 0 1 2 -1 "
                    "0 1\n");
  EXPECT_EQ(not_held_by("b.obj", mesh), Names{"groups"}); // not whole
  const Attributes a = written_and_read("b.obj", mesh).attributes;
  EXPECT_EQ(find_column(a.of_faces, "material")->words, (Names{"12", "default"}));
  EXPECT_EQ(values(a.of_faces, "smoothing_group"), (Numbers{0, 3, 0}));
}

TEST_F(Pn_subdivide_attributes, VtpTextHoldsArraysAndWords)
{
  Mesh_data mesh = read("a.obj", obj);
  mesh.attributes.of_vertices.push_back({"a<b", Scalar_type::int16, {1, -2, 3, 4, 5}, {}});
  write_mesh(folder.file("a.vtp"), mesh, Encoding::text);
  const std::string s = Temporary_folder::content(folder.file("a.vtp"));
  for (const char* part :
       {"<PointData Scalars=\"a&lt;b\">", "type=\"Int16\" Name=\"a&lt;b\" NumberOfComponents=\"1\"",
        "\n1\n-2\n3\n4\n5\n", "type=\"Float64\" Name=\"colors\" NumberOfComponents=\"3\"",
        "\n0 0.25 1\n0.10000000000000001 0 0\n", "<CellData>",
        "type=\"Int32\" Name=\"material\" NumberOfComponents=\"1\" format=\"ascii\">\n-1\n0\n1\n",
        "<Array type=\"String\" Name=\"material\" NumberOfTuples=\"2\" format=\"ascii\">\n"
        "119 111 111 100 32 35 50 0\n114 101 100 0\n"})
    EXPECT_NE(s.find(part), std::string::npos) << part << "\n" << s;
  expect_no_part(s, "TCoords");
  EXPECT_LT(s.find("</FieldData>"), s.find("<Piece"));
}

TEST_F(Pn_subdivide_attributes, FileNamesFollowTheOutput)
{
  std::filesystem::create_directories(folder.file("in/maps"));
  std::filesystem::create_directories(folder.file("out"));
  folder.write("in/two words.mtl", "");
  const auto moved = [&](const std::string& from, const std::string& to, const std::string& name) {
    Attributes a;
    a.material_files = a.texture_files = {name};
    move_file_references(a, input_mesh_file(folder.file(from), std::nullopt),
                         output_mesh_file(folder.file(to), std::nullopt));
    return a.material_files[0] + "|" + a.texture_files[0];
  };
  EXPECT_EQ(moved("in/a.obj", "in/b.obj", "./a.mtl"), "./a.mtl|./a.mtl");
  EXPECT_EQ(moved("in/a.obj", "out/../in/b.obj", "a.mtl"), "a.mtl|a.mtl");
  EXPECT_EQ(moved("in/a.obj", "out/b.obj", "a.mtl"), "../in/a.mtl|../in/a.mtl");
  EXPECT_EQ(moved("in/a.obj", "b.obj", "maps/a.mtl"), "in/maps/a.mtl|in/maps/a.mtl");
  EXPECT_EQ(moved("in/a.obj", "out/b.obj", "/x/a.mtl"), "/x/a.mtl|/x/a.mtl");
  EXPECT_EQ(moved("in/a.obj", "b.obj", "a.mtl b.mtl"), "in/a.mtl in/b.mtl|in/a.mtl b.mtl");
  EXPECT_EQ(moved("in/a.obj", "b.obj", "two words.mtl"), "in/two words.mtl|in/two words.mtl");
  for (const std::string name : {"C:\\my parts\\a.mtl", "d:/a b.mtl", "\\\\server\\a.mtl"})
    EXPECT_EQ(moved("in/a.obj", "b.obj", name), name + "|" + name);
}

// --- vertices of their own on both sides of seams ---

// Two squares that are apart, with the same texture coordinates and a seam across each; one face has none.
const std::string two_squares =
  "v 0 0 0 1 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 5 0 0\nv 6 0 0\nv 6 1 0\nv 5 1 0\n"
  "vt 0 0\nvt 6 0\nvt 6 6\nvt 0.1 0\nvt 0.9 1\nvt 0 -1\n"
  "f 1/1 2/2 3/3\nf 1/4 3/5 4/6\nf 5/1 6/2 7/3\nf 5/4 7/5 8/6\n";

TEST_F(Pn_subdivide_attributes, SeamsAreSplit)
{
  const Mesh_data whole = read("a.obj", two_squares);
  Mesh_data mesh = whole;
  for (const Triple& p : whole.points) mesh.normals.push_back({p[0], 0, 1});
  EXPECT_EQ(split_at_seams(mesh), 0u);
  ASSERT_EQ(mesh.points.size(), 12u);
  for (std::size_t f = 0; f < 4; ++f)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto v = mesh.face(f)[std::ptrdiff_t(i)], old = whole.face(f)[std::ptrdiff_t(i)];
      EXPECT_TRUE(v == old || v >= 8); // copies are behind the others
      EXPECT_EQ(mesh.points[v], whole.points[old]);
      EXPECT_EQ(mesh.normals[v][0], whole.points[old][0]);
    }
  EXPECT_EQ(values(mesh.attributes.of_vertices, "green"),
            (Numbers{0, 1, 1, 1, 1, 1, 1, 1, 0, 1, 1, 1}));
  const std::vector<Texture_point> of_vertices = texture_of_vertices(mesh);
  ASSERT_EQ(of_vertices.size(), 12u);
  for (std::size_t f = 0, corner = 0; f < 4; ++f)
    for (const Mesh_data::Index v : mesh.face(f))
      EXPECT_EQ(of_vertices[v], whole.attributes.texture[corner++]);
  EXPECT_EQ(not_held_by("a.vtp", mesh), Names());

  // and joined again
  move_texture_to_vertices(mesh);
  EXPECT_TRUE(mesh.attributes.texture.empty());
  Mesh_data joined = written_and_read("a.ply", mesh);
  EXPECT_EQ(merge_equal_points(joined).merged_vertices, 4u);
  EXPECT_EQ(joined.points, whole.points);
  EXPECT_EQ(joined.attributes.texture, whole.attributes.texture);

  // nothing to split, and corners without
  Mesh_data plain = read("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_EQ(split_at_seams(plain), 0u);
  move_texture_to_vertices(plain);
  EXPECT_TRUE(plain.attributes.empty());
  Mesh_data some = read("a.obj", obj);
  EXPECT_EQ(split_at_seams(some), 3u);
  EXPECT_EQ(texture_of_vertices(some).size(), some.points.size());
}

// --- repair, merged points, split faces ---

// Face k has 'id' 10 k, and its i-th corner has the texture point (k, i); vertex v has 'w' v / 2.
Mesh_data marked_soup(const std::vector<Triple>& points, const std::vector<std::vector<int>>& faces)
{
  Mesh_data mesh;
  mesh.points = points;
  mesh.attributes.of_vertices.push_back({"w", Scalar_type::float64, {}, {}});
  mesh.attributes.of_faces.push_back({"id", Scalar_type::int32, {}, {}});
  for (std::size_t v = 0; v < points.size(); ++v)
    mesh.attributes.of_vertices[0].values.push_back(double(v) / 2);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    mesh.add_face(faces[f]);
    mesh.attributes.of_faces[0].values.push_back(10. * double(f));
    for (std::size_t i = 0; i < faces[f].size(); ++i)
      mesh.attributes.texture.push_back({double(f), double(i), 0});
  }
  return mesh;
}

// Every face has the attributes of the face of the old soup that it comes from.
void expect_marks_follow(const Mesh_data& mesh, const std::vector<std::vector<int>>& old_faces,
                         const std::vector<int>& originals)
{
  const Attributes& a = mesh.attributes;
  ASSERT_EQ(a.of_faces[0].values.size(), mesh.number_of_faces());
  ASSERT_EQ(a.texture.size(), mesh.number_of_corners());
  ASSERT_EQ(a.of_vertices[0].values.size(), mesh.points.size());
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    EXPECT_EQ(a.of_vertices[0].values[v], originals[v] / 2.) << v;
  std::size_t corner = 0;
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    for (const Mesh_data::Index v : mesh.face(f)) {
      const Texture_point t = a.texture[corner++];
      EXPECT_EQ(a.of_faces[0].values[f], 10 * t[0]);
      EXPECT_EQ(old_faces[std::size_t(t[0])][std::size_t(t[1])], originals[v]);
    }
}

TEST_F(Pn_subdivide_attributes, RepairCarriesThem)
{
  const std::vector<Triple> points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}};
  // one edge with three faces, one of them the other way round; a face that visits a vertex twice; a
  // duplicate and a degenerate face
  const std::vector<std::vector<int>> faces = {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}, {2, 3, 2, 4, 0},
                                               {1, 2, 0}, {3, 3, 4}, {2, 1, 3}};
  Mesh_data mesh = marked_soup(points, faces);
  const Soup_repair repair = repair_soup(mesh);
  EXPECT_GT(repair.added_vertices, 0u);
  EXPECT_GT(repair.reversed_faces, 0u);
  EXPECT_EQ(repair.split_faces, 1u);
  EXPECT_EQ(repair.removed_degenerate_faces, 1u);
  EXPECT_EQ(repair.removed_duplicate_faces, 1u);
  std::vector<int> originals = {0, 1, 2, 3, 4};
  for (const Mesh_data::Index v : mesh.copied_from) originals.push_back(originals[v]);
  expect_marks_follow(mesh, faces, originals);
}

TEST_F(Pn_subdivide_attributes, MergedPoints)
{
  const std::vector<Triple> points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0},
                                      {0, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const std::vector<std::vector<int>> faces = {{0, 1, 2}, {3, 4, 5}};
  Mesh_data mesh = marked_soup(points, faces);
  mesh.attributes.texture.clear();
  mesh.attributes.of_vertices.push_back({"s", Scalar_type::float32, {0, 1, 1, 0, 1, 0}, {}});
  mesh.attributes.of_vertices.push_back({"t", Scalar_type::float32, {0, 0, 1, 0, 1, 1}, {}});
  Mesh_data with_seam = mesh;
  with_seam.attributes.of_vertices[1].values = {0, 1, 1, 5, 6, 7};

  Point_merge merge = merge_equal_points(mesh);
  EXPECT_EQ(merge.merged_vertices, 2u);
  EXPECT_EQ(merge.differing_attributes, Names{"w"});
  EXPECT_EQ(values(mesh.attributes.of_vertices, "w"), (Numbers{0, 0.5, 1, 2.5}));
  EXPECT_EQ(values(mesh.attributes.of_vertices, "s"), (Numbers{0, 1, 1, 0}));
  EXPECT_TRUE(mesh.attributes.texture.empty());

  merge = merge_equal_points(with_seam);
  EXPECT_EQ(merge.differing_attributes, Names{"w"});
  EXPECT_EQ(find_column(with_seam.attributes.of_vertices, "s"), nullptr);
  EXPECT_EQ(
    with_seam.attributes.texture,
    (std::vector<Texture_point>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {5, 0, 0}, {6, 1, 0}, {7, 1, 0}}));
}

// --- damaged files ---

bool are_consistent(const Mesh_data& mesh)
{
  const Attributes& a = mesh.attributes;
  const auto all_have = [](const Columns& columns, std::size_t size) {
    return std::all_of(columns.begin(), columns.end(),
                       [size](const Column& column) { return column.values.size() == size; });
  };
  return all_have(a.of_vertices, mesh.points.size()) &&
         all_have(a.of_faces, mesh.number_of_faces()) &&
         (a.texture.empty() || a.texture.size() == mesh.number_of_corners());
}

// Whatever is in a file, it is read or refused by one line, and what is read can be written.
TEST_F(Pn_subdivide_attributes, DamagedFilesAreReadOrRefused)
{
  std::string ply = ply_with_every_type("ascii"), binary = ply_with_every_type("binary_big_endian");
  for_each_number([&](auto x) {
    ply += std::to_string(x) + " ";
    binary += raw(x, true);
  });
  const std::pair<std::string, std::string> files[] = {
    {"a.obj", obj},
    {"a.ply", ply},
    {"a.ply", binary},
    {"a.off", "STCOFF\n3 2 0\n0 0 0 255 0 7 128 0.5 1\n1 0 0 0 0 0 0.25 0\n0 1 0 0 0\n"
              "3 0 1 2 0.5 0.5 1\n3 0 2 1\n"}};
  std::mt19937 random(3);
  const std::string characters = "0123456789.-+eE/ \n#nvtgfusx\xff";
  int read_files = 0, refused_files = 0;
  for (const auto& [name, content] : files)
    for (int i = 0; i < (tests_are_full ? 300 : 75); ++i) {
      std::string damaged = content;
      for (int k = 0; k <= i % 3; ++k)
        damaged[random() % damaged.size()] = characters[random() % characters.size()];
      folder.write(name, damaged);
      try {
        const Mesh_data mesh = read_mesh(folder.file(name));
        ASSERT_TRUE(are_consistent(mesh)) << damaged;
        ++read_files;
        for (const char* format : {"b.obj", "b.off", "b.ply", "b.vtp"}) {
          not_held_by(format, mesh);
          if (i % 20 == 0) write_mesh(folder.file(format), mesh, Encoding::text);
        }
      } catch (const Error& e) {
        ++refused_files;
        EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos) << e.what();
      }
    }
  EXPECT_GT(read_files, tests_are_full ? 200 : 50);
  EXPECT_GT(refused_files, tests_are_full ? 200 : 50);
}

// --- the command ---

class Pn_subdivide_carries : public Command_test
{
protected:
  // The mesh of the output, which is a PLY file.
  Mesh_data refined(const std::string& input, const std::string& options,
                    const std::string& name = "refined.ply") const
  {
    EXPECT_EQ(done(surface(input, name, "--quiet " + options)).err, "");
    return read_mesh(folder.file(name));
  }
};

// A patch of 4 x 3 quads over the plane, each split in two if triangles are wanted, with a constant,
// x + 2 y + 3 z, bytes, a color of 0 and 255, an id for each face, and for each a chart of its own:
// its texture points are (10 id + i, i * i) for its i-th corner.
Mesh_data marked_patch(bool triangles, bool with_charts)
{
  Part patch = grid(4, 3, [](int i, int j) { return (i * i + j) / 8.; });
  if (triangles) patch.triangulate();
  const auto& points = patch.points;
  Mesh_data mesh;
  mesh.points = points;
  Columns& columns = mesh.attributes.of_vertices;
  for (const char* name : {"constant", "linear", "byte", "red", "green", "blue"})
    columns.push_back({name, Scalar_type::uint8, {}, {}});
  columns[0].type = columns[1].type = Scalar_type::float64;
  for (std::size_t v = 0; v < points.size(); ++v) {
    const Triple& p = points[v];
    const Numbers row = {0.1,         p[0] + 2 * p[1] + 3 * p[2], double(v), v % 2 * 255., 255,
                         v % 3 * 127.};
    for (std::size_t k = 0; k < row.size(); ++k) columns[k].values.push_back(row[k]);
  }
  mesh.attributes.of_faces.push_back({"id", Scalar_type::uint32, {}, {}});
  for (std::size_t f = 0; f < patch.faces.size(); ++f) {
    mesh.add_face(patch.faces[f]);
    mesh.attributes.of_faces[0].values.push_back(4294967295. - double(f));
    for (std::size_t i = 0; i < patch.faces[f].size() && with_charts; ++i)
      mesh.attributes.texture.push_back({10. * double(f) + double(i), double(i * i), 0});
  }
  return mesh;
}

double texture_area(const Mesh_data& mesh)
{
  double area = 0;
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
    const std::size_t first = mesh.first_corner(f), n = std::size_t(mesh.face(f).size());
    double of_face = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const Texture_point& a = mesh.attributes.texture[first + i];
      const Texture_point& b = mesh.attributes.texture[first + (i + 1) % n];
      of_face += (a[0] * b[1] - a[1] * b[0]) / 2;
    }
    area += std::abs(of_face);
  }
  return area;
}

TEST_F(Pn_subdivide_carries, NoRoundKeepsEveryBit)
{
  const std::string input = folder.write("a.obj", obj);
  const Attributes attributes = read_mesh(input).attributes;
  const std::string of_ply = folder.file("a.ply");
  write_mesh(of_ply, read_mesh(input), Encoding::binary); // with types of its own
  for (const auto& [from, output] : {std::pair(input, "b.obj"), std::pair(of_ply, "b.ply")})
    for (const char* options : {"", " --ascii", " --normals none"}) {
      const Outcome outcome =
        done(surface(from, folder.file(output), std::string("--quiet --levels 0") + options));
      EXPECT_EQ(outcome.err, "");
      expect_same(read_mesh(folder.file(output)).attributes, attributes);
    }
}

TEST_F(Pn_subdivide_carries, EverySchemeCarriesThem)
{
  for (const std::string scheme :
       {"catmull-clark", "loop", "doo-sabin", "sqrt3", "butterfly", "kobbelt",
        "modified-catmull-clark", "modified-loop", "midpoint", "bilinear"}) {
    const bool triangles = scheme == "loop" || scheme == "sqrt3" || scheme == "butterfly" ||
                           scheme == "modified-loop" || scheme == "midpoint";
    const bool keeps_edges = scheme != "doo-sabin" && scheme != "sqrt3";
    const Mesh_data control = marked_patch(triangles, keeps_edges);
    write_mesh(folder.file("patch.ply"), control, Encoding::binary);
    Numbers ids = control.attributes.of_faces[0].values;
    std::sort(ids.begin(), ids.end());
    for (const char* options : {" --linear", "", " --threads 2"}) {
      SCOPED_TRACE(scheme + options);
      const Mesh_data mesh =
        refined(folder.file("patch.ply"), "--levels 2 --scheme " + scheme + options);
      const Attributes& a = mesh.attributes;
      ASSERT_TRUE(are_consistent(mesh));
      ASSERT_EQ(a.of_vertices.size(), 6u);
      EXPECT_EQ(values(a.of_vertices, "constant"), Numbers(mesh.points.size(), 0.1));
      EXPECT_EQ(values(a.of_vertices, "green"), Numbers(mesh.points.size(), 255));
      EXPECT_EQ(a.of_vertices[2].type, Scalar_type::uint8);
      for (std::size_t v = 0; v < mesh.points.size() && options == std::string(" --linear"); ++v) {
        const Triple& p = mesh.points[v];
        EXPECT_NEAR(values(a.of_vertices, "linear")[v], p[0] + 2 * p[1] + 3 * p[2], 1e-14);
      }
      Numbers found = values(a.of_faces, "id");
      std::sort(found.begin(), found.end());
      found.erase(std::unique(found.begin(), found.end()), found.end());
      EXPECT_EQ(found, ids);
      // each face is in the chart of the face that it comes from
      ASSERT_EQ(a.texture.empty(), !keeps_edges);
      for (std::size_t f = 0; f < mesh.number_of_faces() && keeps_edges; ++f)
        for (std::size_t i = 0; i < std::size_t(mesh.face(f).size()); ++i) {
          const double u = a.texture[mesh.first_corner(f) + i][0];
          const double first = 10 * (4294967295. - values(a.of_faces, "id")[f]);
          EXPECT_TRUE(first <= u && u <= first + 3) << f;
        }
    }
  }
}

TEST_F(Pn_subdivide_carries, BytesAreRounded)
{
  const std::string input = folder.write(
    "a.off", "COFF\n4 1 0\n0 0 0 0 0 0\n1 0 0 255 1 0\n1 1 0 0 0 0\n0 1 0 0 0 2\n4 0 1 2 3\n");
  const Mesh_data mesh = refined(input, "--linear --scheme catmull-clark --border curve");
  const auto count = [&](const char* name, double x) {
    const Numbers& n = values(mesh.attributes.of_vertices, name);
    return std::count(n.begin(), n.end(), x);
  };
  EXPECT_EQ(count("red", 128), 2); // 127.5 at two edges
  EXPECT_EQ(count("red", 64), 1);  // 63.75 at the face
  EXPECT_EQ(count("red", 191), 1); // 191.25 at the vertex
  EXPECT_EQ(count("red", 32), 2);  // 31.875 beside it
  EXPECT_EQ(count("green", 1), 3); // 0.75, 0.5, 0.5
  EXPECT_EQ(count("blue", 2), 1);  // 1.5
}

TEST_F(Pn_subdivide_carries, TheTextureOfTheVaseKeepsItsArea)
{
  const Mesh_data control = read_mesh(data("vase.obj"));
  const double area = texture_area(control);
  EXPECT_NEAR(area, 0.6 + 0.09, 1e-12); // the side and the bottom
  for (const char* options : {"", " --linear", " --scheme kobbelt", " --triangulate",
                              " --triangulate --scheme butterfly"}) {
    SCOPED_TRACE(options);
    const Mesh_data mesh = refined(data("vase.obj"), std::string("--levels 3") + options);
    const Attributes& a = mesh.attributes;
    EXPECT_NEAR(texture_area(mesh), area, 0.01 * area);
    EXPECT_TRUE(std::none_of(a.texture.begin(), a.texture.end(), is_none));
    EXPECT_EQ(find_column(a.of_faces, "group")->words, (Names{"side", "bottom"}));
    const Numbers& group = values(a.of_faces, "group");
    EXPECT_EQ(std::count(group.begin(), group.end(), 1.) * 9,
              std::count(group.begin(), group.end(), 0.) * 1.125);
    for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
      for (std::size_t i = 0; i < std::size_t(mesh.face(f).size()); ++i)
        EXPECT_EQ(a.texture[mesh.first_corner(f) + i][1] < 0.32, group[f] == 1);
  }
}

TEST_F(Pn_subdivide_carries, NotANumberSpreadsAndNothingElse)
{
  std::string text = ply_head;
  text.replace(text.find("vertex 3"), 8, "vertex 6");
  const std::string input = folder.write(
    "a.ply",
    text + "property double q\n" +
      "element face 2\nproperty list uchar int "
      "vertex_indices\nend_header\n0 0 0 nan\n1 0 0 1\n2 0 0 1\n0 1 0 1\n1 1 0 1\n2 1 0 1\n4 0 "
      "1 4 3\n4 1 2 5 4\n");
  const Mesh_data mesh = refined(input, "--levels 1 --scheme catmull-clark");
  const Numbers& q = values(mesh.attributes.of_vertices, "q");
  EXPECT_TRUE(std::isnan(q[0]));
  EXPECT_EQ(q[2], 1); // it does not touch the face
  EXPECT_EQ(q[5], 1);
}

TEST_F(Pn_subdivide_carries, WhatIsLostIsSaidOnce)
{
  const std::string input = folder.write("a.obj", obj);
  const std::string off = folder.file("b.off");
  EXPECT_EQ(surface(input, off, "--quiet --levels 0").err,
            "warning: " + off +
              ": not written, off files cannot hold it: texture coordinates, objects, groups, "
              "materials, smoothing groups and names of material files\n");
  EXPECT_EQ(surface(input, off, "--quiet --levels 0 --drop-attributes").err, "");
  EXPECT_EQ(surface(input, "b.ply", "--quiet --drop-attributes").err, "");
  EXPECT_TRUE(read_mesh(folder.file("b.ply")).attributes.empty());

  // a seam would tear where edges are not kept
  for (const std::string scheme : {"doo-sabin", "sqrt3"}) {
    const Outcome outcome = surface(input, "b.ply", "--quiet --scheme " + scheme);
    EXPECT_EQ(outcome.err, "warning: " + input +
                             ": not carried over to the result: texture coordinates, because they "
                             "have seams and " +
                             scheme + " keeps no edges\n");
    const Attributes a = read_mesh(folder.file("b.ply")).attributes;
    EXPECT_TRUE(a.texture.empty());
    EXPECT_EQ(find_column(a.of_faces, "material")->words.size(), 2u);
  }
  const Outcome labels =
    done(surface(folder.write("a.ply", ply_head + "property short label\n" + ply_faces +
                                         "end_header\n0 0 0 1\n1 0 0 2\n0 1 0 4\n3 0 1 2\n"),
                 folder.file("b.ply")));
  expect_part(labels.err,
              "whole numbers of vertices are those of the nearest control vertex: 'label'");
}

TEST_F(Pn_subdivide_carries, LabelsAndDirections)
{
  const std::string input = folder.write(
    "a.ply",
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float "
    "z\n"
    "property short label\nproperty float part\nproperty float heat\nproperty float tx\nproperty "
    "float ty\n"
    "property float tz\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0 1 0.5 1 1 0 0\n4 0 0 3 2.5 2 0 1 0\n4 4 0 1 0.5 3 0 0 1\n0 4 0 3 2.5 4 0.6 0.8 0\n4 0 1 "
    "2 3\n");
  for (const char* how : {"--levels 3", "--levels 2 --scheme doo-sabin", "--chord 0.01",
                          "--levels 0", "--levels 2 --linear --sharp none"})
    for (const char* names : {"--directions t", "--directions tx,ty,tz"}) {
      SCOPED_TRACE(how);
      const Mesh_data mesh = refined(input, std::string("--nearest part ") + names + ' ' + how);
      const Columns& columns = mesh.attributes.of_vertices;
      const auto values = [&](const char* name) { return find_column(columns, name)->values; };
      ASSERT_EQ(values("label").size(), mesh.points.size());
      const bool is_linear = std::string(how).find("linear") != std::string::npos;
      for (std::size_t v = 0; v < mesh.points.size(); ++v) {
        const double label = values("label")[v], part = values("part")[v];
        EXPECT_TRUE(label == 1 || label == 3);
        EXPECT_EQ(part, label == 1 ? 0.5 : 2.5);
        const double x = values("tx")[v], y = values("ty")[v], z = values("tz")[v];
        EXPECT_NEAR(x * x + y * y + z * z, 1, 1e-6);
        const bool is_left = mesh.points[v][0] < 2 - 1e-6, is_low = mesh.points[v][1] < 2 - 1e-6;
        const bool is_between =
          std::abs(mesh.points[v][0] - 2) < 1e-6 || std::abs(mesh.points[v][1] - 2) < 1e-6;
        if (is_linear && !is_between) {
          EXPECT_EQ(label, is_left == is_low ? 1 : 3);
        }
      }
    }
  const std::string output = folder.file("o.ply");
  expect_one_line(surface(input, output, "--nearest speed"), 1,
                  "they have 'label', 'part', 'heat'");
  expect_one_line(surface(input, output, "--directions tx,ty"), 1, "a direction has three numbers");
  expect_one_line(surface(input, output, "--nearest tx --directions t"), 1,
                  "--nearest has it, too");
  expect_one_line(surface(input, output, "--nearest part --drop-attributes"), 2,
                  "exclude each other");
}

TEST_F(Pn_subdivide_carries, SeamsAreSplitInVtpAndWhereItIsAskedFor)
{
  const std::string input = folder.write("a.obj", two_squares);
  const std::string vtp = folder.file("b.vtp"), ply = folder.file("b.ply");
  EXPECT_EQ(surface(input, vtp, "--quiet --levels 0 --ascii").err, "");
  const std::string text = Temporary_folder::content(vtp);
  expect_part(text, "NumberOfPoints=\"12\"");
  expect_part(text, "Name=\"TCoords\"");
  EXPECT_EQ(surface(input, ply, "--quiet --levels 0").err, "");
  EXPECT_EQ(read_mesh(ply).points.size(), 8u);
  EXPECT_EQ(surface(input, ply, "--quiet --levels 0 --split-seams").err, "");
  const Mesh_data mesh = read_mesh(ply);
  EXPECT_EQ(mesh.points.size(), 12u);
  EXPECT_TRUE(mesh.attributes.texture.empty());
  EXPECT_EQ(values(mesh.attributes.of_vertices, "texture_v"),
            (Numbers{0, 0, 6, -1, 0, 0, 6, -1, 0, 1, 0, 1}));
  expect_one_line(surface(input, "b.off", "--split-seams"), 2, "--split-seams is for .ply");
  for (const char* const other :
       {"--pieces 2", "--output-normals both", "--write-tags x.selection.txt"})
    expect_one_line(surface(input, ply, std::string("--split-seams ") + other), 2, "--split-seams");
  // of the faces without any
  const Outcome some = surface(folder.write("c.obj", obj), vtp, "--quiet --levels 0");
  EXPECT_EQ(some.err, "warning: " + vtp +
                        ": 3 corners without texture coordinates have 0 0, since those of "
                        "vertices are written\n");
}

TEST_F(Pn_subdivide_carries, CurvatureTakesThePlaceOfColors)
{
  const std::string input = folder.file("patch.ply"), output = folder.file("b.ply");
  write_mesh(input, marked_patch(false, true), Encoding::binary);
  const Outcome outcome = surface(input, output, "--quiet --curvature mean");
  if (outcome.code == 2) GTEST_SKIP() << "left out: " << outcome.err; // without Eigen
  EXPECT_EQ(outcome.err, "warning: " + output +
                           ": the file's colors or values of vertices give way to those of the "
                           "curvature\n");
  const Columns columns = read_mesh(output).attributes.of_vertices;
  Names names;
  for (const Column& column : columns) names.push_back(column.name);
  EXPECT_EQ(names, (Names{"mean_curvature", "red", "green", "blue", "constant", "linear", "byte"}));
}

TEST_F(Pn_subdivide_carries, BadAttributesFailWithOneLineAndLeaveTheOutput)
{
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\n";
  const std::string output = folder.write("o.ply", "old");
  for (const char* rest : {"f 1/1 2/2 3/1\n", "vt nan 0\nf 1 2 3\n", "v 0 0 0 2 0 0\nf 1 2 3\n"}) {
    const std::string input = folder.write("a.obj", points + rest);
    expect_one_line(surface(input, output), 1, "line 5: ");
    EXPECT_EQ(Temporary_folder::content(output), "old");
    done(surface(input, "p.ply", "--drop-attributes"));
  }
}

TEST_F(Pn_subdivide_carries, MaterialFilesAreFoundFromTheOutput)
{
  std::filesystem::create_directories(folder.file("deep/er"));
  const std::string input = folder.write("a.obj", obj), output = folder.file("deep/er/b.obj");
  done(surface(input, output, "--levels 0"));
  EXPECT_EQ(read_mesh(output).attributes.material_files[0], "../../house.mtl");
}

TEST_F(Pn_subdivide_carries, SplitFacesAndMergedPoints)
{
  const std::string input = folder.file("patch.ply");
  const Mesh_data quads = marked_patch(false, true);
  write_mesh(input, quads, Encoding::binary);
  const Mesh_data mesh = refined(input, "--levels 0 --triangulate");
  ASSERT_EQ(mesh.number_of_faces(), 24u);
  ASSERT_TRUE(are_consistent(mesh));
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
    const auto parent = std::size_t(4294967295. - mesh.attributes.of_faces[0].values[f]);
    for (std::size_t i = 0; i < 3; ++i) {
      const Texture_point& t = mesh.attributes.texture[mesh.first_corner(f) + i];
      const auto corner = std::size_t(t[0] - 10. * double(parent));
      ASSERT_LT(corner, 4u);
      EXPECT_EQ(quads.face(parent).begin()[corner], mesh.face(f).begin()[i]);
    }
  }

  const std::string twice = folder.write(
    "a.off", "COFF\n4 2 0\n0 0 0 1 1 1\n1 0 0 2 2 2\n0 1 0 3 3 3\n0 0 0 9 1 1\n3 0 1 2\n3 3 2 1\n");
  const Outcome outcome =
    surface(twice, "b.off", "--quiet --levels 0 --merge-points --normals none");
  EXPECT_EQ(outcome.err,
            "warning: " + twice +
              ": merged vertices had different values of 'red'; those of the first are "
              "kept\n");
}

} // namespace

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Reading and writing of mesh files: every format, to the last bit where the format allows it, and
// every kind of damage.

#include "File_test.h"
#include "Part_files.h"

#include "io/soup_repair.h"
#include "surface/Surface.h"

#include <cfloat>
#include <limits>
#include <tuple>

using namespace pn_subdivide;

namespace {

using Faces = std::vector<std::vector<unsigned>>;

Faces faces_of(const Mesh_data& mesh)
{
  Faces faces;
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    faces.emplace_back(mesh.face(f).begin(), mesh.face(f).end());
  return faces;
}

void expect_same(const Mesh_data& a, const Mesh_data& b)
{
  EXPECT_EQ(bits(a.points), bits(b.points));
  EXPECT_EQ(bits(a.normals), bits(b.normals));
  EXPECT_EQ(faces_of(a), faces_of(b));
}

// A triangle, a quad, a hexagon and a vertex without faces, with awkward numbers.
Mesh_data awkward_mesh(bool with_normals)
{
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Mesh_data mesh;
  for (int i = 0; i < 20; ++i) {
    const double scale = std::ldexp(1.0, 13 * (i % 7) - 40);
    mesh.points.push_back({scale * uniform(random), uniform(random), uniform(random) / 3});
    if (with_normals) mesh.normals.push_back({uniform(random), uniform(random), uniform(random)});
  }
  mesh.points[3] = triple(DBL_MAX, DBL_TRUE_MIN, -0.0);
  mesh.points[4] = triple(1 + DBL_EPSILON, DBL_MIN, 0.1);
  if (with_normals) mesh.normals[5] = triple(0, 0, 0);
  mesh.add_face(std::vector<int>{0, 1, 2});
  mesh.add_face(std::vector<int>{2, 1, 3, 4});
  mesh.add_face(std::vector<int>{4, 3, 5, 6, 7, 8});
  return mesh;
}

class Mesh_io : public File_test
{};

// --- round trips ---

TEST_F(Mesh_io, EveryFormatThatIsReadAndWrittenKeepsEveryBit)
{
  for (const char* extension : {"ply", "PLY", "off", "obj"})
    for (const Encoding encoding : {Encoding::binary, Encoding::text})
      for (const bool with_normals : {true, false}) {
        SCOPED_TRACE(std::string(extension) + (encoding == Encoding::text ? " text" : " binary"));
        Mesh_data mesh = awkward_mesh(with_normals);
        // OBJ has no place for the normal of a vertex without faces
        if (with_normals && extension[0] == 'o' && extension[1] == 'b')
          std::fill(mesh.normals.begin() + 9, mesh.normals.end(), triple(0, 0, 0));
        expect_same(written_and_read(std::string("mesh.") + extension, mesh, encoding), mesh);
      }
}

TEST_F(Mesh_io, PlyFacesWithMoreThan255VerticesSurvive)
{
  Mesh_data mesh;
  std::vector<int> face;
  for (int i = 0; i < 300; ++i) {
    mesh.points.push_back({std::cos(i), std::sin(i), double(i)});
    face.push_back(i);
  }
  mesh.add_face(face);
  for (const Encoding encoding : {Encoding::binary, Encoding::text})
    expect_same(written_and_read("big.ply", mesh, encoding), mesh);
}

TEST_F(Mesh_io, TextHas17SignificantDigits)
{
  Mesh_data mesh = awkward_mesh(false);
  mesh.points[0] = triple(1.0 / 3, 0.1, 2);
  write_mesh(folder.file("t.ply"), mesh, Encoding::text);
  expect_part(Temporary_folder::content(folder.file("t.ply")),
              "0.33333333333333331 0.10000000000000001 2\n");
}

// --- PLY ---

TEST_F(Mesh_io, PlyTextWithOtherPropertiesAndElements)
{
  const Mesh_data mesh = read("a.ply", "ply\r\nformat ascii 1.0\r\ncomment some words\r\n"
                                       "obj_info more words\r\n"
                                       "element vertex 4\r\nproperty uchar red\r\n"
                                       "property float32 nx\r\nproperty float ny\r\n"
                                       "property float nz\r\nproperty double x\r\n"
                                       "property float64 y\r\nproperty double z\r\n"
                                       "element edge 2\r\nproperty int vertex1\r\n"
                                       "property int vertex2\r\n"
                                       "element face 1\r\nproperty float quality\r\n"
                                       "property list uchar float texcoord\r\n"
                                       "property list uint8 uint32 vertex_index\r\nend_header\r\n"
                                       "255 0 0 1 1 2 3\r\n255 0 1 0 4 5 6\r\n\r\n"
                                       "0 1 0 0 7 8 9\r\n0 0 0 0 +1e1 0.1 -2\r\n"
                                       "0 1\r\n1 2\r\n0.5 8 0 0 1 0 1 1 0 1 4 3 2 1 0\r\n");
  ASSERT_EQ(mesh.points.size(), 4u);
  EXPECT_EQ(mesh.points[0], triple(1, 2, 3));
  EXPECT_EQ(mesh.points[3], triple(10, 0.1, -2));
  EXPECT_EQ(mesh.normals[1], triple(0, 1, 0));
  EXPECT_EQ(mesh.normals[3], triple(0, 0, 0));
  EXPECT_EQ(faces_of(mesh), (Faces{{3, 2, 1, 0}}));
}

TEST_F(Mesh_io, PlyBinaryOfBothByteOrdersWithFloatsAndDoubles)
{
  for (const bool big : {false, true}) {
    std::string s = std::string("ply\nformat binary_") + (big ? "big" : "little") +
                    "_endian 1.0\nelement vertex 3\nproperty float x\nproperty double y\n"
                    "property short z\nproperty char flag\nelement face 1\n"
                    "property list ushort short vertex_indices\nend_header\n";
    for (int i = 0; i < 3; ++i)
      s += raw(0.1f * float(i), big) + raw(0.1 * i, big) +
           raw(static_cast<std::int16_t>(-300 * i), big) + raw(static_cast<std::int8_t>(-1), big);
    s += raw(std::uint16_t(3), big) + raw(std::int16_t(0), big) + raw(std::int16_t(1), big) +
         raw(std::int16_t(2), big);
    const Mesh_data mesh = read("b.ply", s);
    ASSERT_EQ(mesh.points.size(), 3u);
    EXPECT_EQ(mesh.points[2], triple(double(0.1f * 2.f), 0.1 * 2, -600));
    EXPECT_FALSE(mesh.has_normals());
    EXPECT_EQ(faces_of(mesh), (Faces{{0, 1, 2}}));

    for (std::size_t n = 1; n <= s.size() - s.find("end_header") - 11; ++n)
      expect_error("short.ply", s.substr(0, s.size() - n), "truncated");
    expect_error("long.ply", s + "x", "more data");
  }
}

TEST_F(Mesh_io, PlyDamage)
{
  const std::string head = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                           "property float y\nproperty float z\n";
  const std::string faces = "element face 1\nproperty list uchar int vertex_indices\n";
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n";
  EXPECT_EQ(read("ok.ply", head + faces + "end_header\n" + points + "3 0 1 2").points.size(), 3u);

  expect_error("a.ply", "", "empty");
  expect_error("a.ply", "solid\n", "not a PLY file");
  expect_error("a.ply", head + faces, "truncated");
  expect_error("a.ply", "ply\nend_header\n", "format");
  expect_error("a.ply", "ply\nformat binary_middle_endian 1.0\n", "binary_middle_endian");
  expect_error("a.ply", head + "property quaternion q\nend_header\n", "line 7: not a PLY type");
  expect_error("a.ply", head + "property \x1b[2J\xe4 q\nend_header\n", "'?[2J?'");
  expect_error("a.ply", head + faces + faces + "end_header\n" + points + "3 0 1 2\n3 0 2 1\n",
               "line 9: a second element 'face'");
  expect_error("a.ply", head + "end_header\n" + points, "no element 'face'");
  expect_error("a.ply", "ply\nformat ascii 1.0\n" + faces + "end_header\n3 0 1 2\n",
               "no element 'vertex'");
  expect_error("a.ply", head + "property float nx\nproperty float ny\n" + faces + "end_header\n",
               "only 2 of the properties nx ny nz");
  expect_error("a.ply", head + faces + "end_header\n" + points, "truncated (in face 0 of 1)");
  expect_error("a.ply", head + faces + "end_header\n0 0 0\n1 0 zero\n", "line 11: 'zero'");
  expect_error("a.ply", head + faces + "end_header\n" + points + "3 0 1 3", "out of range");
  expect_error("a.ply", head + faces + "end_header\n" + points + "3 0 1 -1", "negative");
  expect_error("a.ply", head + faces + "end_header\n" + points + "3 0 1 1.5", "broken");
  expect_error("a.ply", head + faces + "end_header\n" + points + "-3 0 1 2", "negative");
  expect_error("a.ply", head + faces + "end_header\n" + points + "3 0 1 2\n3 0 1 2\n", "more data");
  expect_error("a.ply",
               "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\n"
               "property double x\nproperty double y\nproperty double z\n" +
                 faces + "end_header\n",
               "truncated");
  expect_error("a.ply",
               head + "element face 1\nproperty list uint int vertex_indices\nend_header\n" +
                 points + "4000000000 0 1 2",
               "truncated");
}

// Every second triangle of a strip is turned; -1 ends a strip, and so does the list.
TEST_F(Mesh_io, PlyStripsOfTriangles)
{
  const std::string head = "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\n"
                           "property float y\nproperty float z\n";
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n1 2 0\n";
  const std::string strips = "element tristrips 2\nproperty list int int vertex_indices\n";
  const std::string lists = "6 0 1 2 3 4 5\n7 0 2 1 -1 3 4 5\n";
  const Faces expected{{0, 1, 2}, {2, 1, 3}, {2, 3, 4}, {4, 3, 5}, {0, 2, 1}, {3, 4, 5}};
  Mesh_data mesh = read("a.ply", head + strips + "end_header\n" + points + lists);
  EXPECT_EQ(faces_of(mesh), expected);
  EXPECT_TRUE(mesh.dropped.empty());
  const std::string empty = "element face 0\nproperty list uchar int vertex_indices\n";
  EXPECT_EQ(faces_of(read("a.ply", head + empty + strips + "end_header\n" + points + lists)),
            expected);
  // the strip goes on behind triangles that only lead to another place
  mesh =
    read("a.ply", head + "element tristrips 1\nproperty list int int vertex_index\nend_header\n" +
                    points + "8 0 1 2 2 3 3 5 4\n");
  EXPECT_EQ(faces_of(mesh), (Faces{{0, 1, 2}, {5, 3, 4}}));
  // beside faces they are named, as all that is not read
  std::string face = empty;
  face.replace(face.find('0'), 1, "1");
  mesh = read("a.ply", head + face + strips + "end_header\n" + points + "3 0 1 2\n" + lists);
  EXPECT_EQ(faces_of(mesh), (Faces{{0, 1, 2}}));
  EXPECT_EQ(mesh.dropped, std::vector<std::string>{"the element 'tristrips'"});
  expect_error("a.ply", head + strips + "end_header\n" + points + "3 0 1 -2\n3 0 1 2\n",
               "negative");
  expect_error("a.ply", head + strips + "end_header\n" + points + "3 0 1 6\n3 0 1 2\n",
               "out of range");
}

// --- OFF ---

TEST_F(Mesh_io, OffVariants)
{
  const Faces face{{0, 1, 2}};
  const std::string faces = "3 0 1 2\n";

  Mesh_data mesh = read("a.off", "# made by hand\nOFF # keyword\n\n3 1 0\n 0 0 0.1 # here\n\n"
                                 "1 0 0\n0 1 0\n3 0 1 2 255 0 0\n# the end\n");
  EXPECT_EQ(mesh.points[0], triple(0, 0, 0.1));
  EXPECT_EQ(faces_of(mesh), face);
  EXPECT_FALSE(mesh.has_normals());

  mesh = read("a.off", "NOFF 3 1 3\n0 0 0 0 0 2\n1 0 0 0 0 0\n0 1 0 0 1 0\n" + faces);
  EXPECT_EQ(mesh.normals[0], triple(0, 0, 2));
  EXPECT_EQ(mesh.normals[1], triple(0, 0, 0));

  mesh = read("a.off", "COFF\n3 1\n0 0 0 255 0 0 255\n1 0 0 0.5 0 0\n0 1 0 7\n" + faces);
  EXPECT_EQ(mesh.points[2], triple(0, 1, 0));
  EXPECT_FALSE(mesh.has_normals());

  for (const char* keyword : {"STCNOFF", "CNSTOFF", "NCSTOFF"}) {
    mesh = read("a.off", std::string(keyword) +
                           "\n3 1 0\n0 0 0 0 0 1 9 9 9 9 0.5 0.5\n1 0 0 0 0 1 9 9 9 9 0 0\n"
                           "0 1 0 0 1 0 9 9 9 9 0 1\n" +
                           faces);
    EXPECT_EQ(mesh.normals[2], triple(0, 1, 0));
  }

  mesh = read("a.off", "OFF3 1 0\n0 0 0\n1 0 0\n0 1 0\n" + faces);
  EXPECT_EQ(faces_of(mesh), face);
}

TEST_F(Mesh_io, OffDamage)
{
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n";
  expect_error("a.off", "", "empty");
  expect_error("a.off", "\n# nothing\n", "not an OFF file");
  expect_error("a.off", "hello\n", "not an OFF file");
  expect_error("a.off", "4OFF\n3 1 0\n", "not supported");
  expect_error("a.off", "OFF BINARY\n", "not supported");
  expect_error("a.off", "OFF\n", "number of vertices");
  expect_error("a.off", "OFF\n-3 1 0\n", "negative");
  expect_error("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n", "after 2 of 3 vertices");
  expect_error("a.off", "OFF\n3 2 0\n" + points + "3 0 1 2\n", "after 1 of 2 faces");
  expect_error("a.off", "OFF\n3 1 0\n0 0\n", "line 3");
  expect_error("a.off", "OFF\n3 1 0\n0 0 x\n", "'x'");
  expect_error("a.off", "OFF\n3 1 0\n0 0 0 1 1 1\n", "3 numbers behind its coordinates");
  expect_error("a.off", "OFF\n3 1 0\n0 0 0 1 1 1\n", "--drop-attributes");
  expect_error("a.off", "NOFF\n3 1 0\n0 0 0 1 1\n", "a normal's coordinate");
  expect_error("a.off", "NOFF\n3 1 0\n0 0 0 1 1 1 1\n", "1 numbers");
  expect_error("a.off", "OFF\n3 1 0\n" + points + "3 0 1 3\n", "index 3 is out of range");
  expect_error("a.off", "OFF\n3 1 0\n" + points + "3 0 1 -1\n", "index -1 is out of range");
  expect_error("a.off", "OFF\n3 1 0\n" + points + "4 0 1 2\n", "line 6");
  expect_error("a.off", "OFF\n3 1 0\n" + points + "-2 0 1\n", "-2 vertices");
  expect_error("a.off", "OFF\n3 1 0\n" + points + "3 0 1 2.5\n", "'2.5'");
  expect_error("a.off", "OFF\n3 1 0\n" + points + "3 0 1 2\n3 0 1 2\n", "more lines");
  expect_error("a.off", "OFF\n4000000000 4000000000 0\n0 0 0\n", "after 1 of 4000000000");
}

// --- OBJ ---

TEST_F(Mesh_io, ObjCornersAndNegativeIndices)
{
  const std::string head =
    "# c\nmtllib x.mtl\no thing\nv 0 0 0\nv 1 0 0 1.0\nv 1 1 0 0.5 0.5 0.5\n"
    "v 0 1 0.1\nvt 0 0\nvn 0 0 1\nvn 1 0 0\nvn 0 1 0\nvn 0 0 -1\ng a b\ns off\n";
  const Triple n[] = {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}};

  Mesh_data mesh = read("a.obj", head + "f 1//1 2//2 3//3 4//4\n");
  EXPECT_EQ(faces_of(mesh), (Faces{{0, 1, 2, 3}}));
  EXPECT_EQ(mesh.points[3], triple(0, 1, 0.1));
  for (std::size_t v = 0; v < 4; ++v) EXPECT_EQ(mesh.normals[v], n[v]);

  mesh = read("a.obj", head + "f -4/1/-4 -3/1/-3 \\\n -2/1/-2 -1/-1/-1\nl 1 2\nusemtl m\n");
  EXPECT_EQ(faces_of(mesh), (Faces{{0, 1, 2, 3}}));
  for (std::size_t v = 0; v < 4; ++v) EXPECT_EQ(mesh.normals[v], n[v]);

  mesh = read("a.obj", "f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n");
  EXPECT_EQ(faces_of(mesh), (Faces{{0, 1, 2}}));
  EXPECT_FALSE(mesh.has_normals());

  mesh = read("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1\n");
  EXPECT_EQ(faces_of(mesh), (Faces{{0, 1, 2}}));

  mesh = read("a.obj", head + "f 1//1 2 3//3\n"); // vertices 1 and 3 are given none
  EXPECT_EQ(mesh.normals[1], triple(0, 0, 0));
  EXPECT_EQ(mesh.normals[3], triple(0, 0, 0));
}

TEST_F(Mesh_io, ObjSeveralNormalsAtAVertexAreSummed)
{
  const std::string points = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
  // At vertex 0: (1,0,0) twice, once by another number, and (0,1,0). At vertex 2: opposite ones.
  const Mesh_data mesh =
    read("a.obj", points + "vn 1 0 0\nvn 0 1 0\nvn 1 0 0\nvn -1 0 0\nvn 0 0 3\n"
                           "f 1//1 2//5 3//1\nf 1//3 3//4 4//2\nf 1//2 4//2 2//5\n");
  EXPECT_NEAR(mesh.normals[0][0], std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(mesh.normals[0][1], std::sqrt(0.5), 1e-15);
  EXPECT_EQ(mesh.normals[0][2], 0);
  EXPECT_EQ(mesh.normals[1], triple(0, 0, 3)); // a single one as it is
  EXPECT_EQ(mesh.normals[2], triple(0, 0, 0));
  EXPECT_EQ(mesh.normals[3], triple(0, 1, 0));
}

TEST_F(Mesh_io, ObjNormalsThatNoFaceNames)
{
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 1 0 0\nvn 0 1 0\n";
  const Mesh_data mesh = read("a.obj", points + "vn 0 0 1\nf 1 2 3\n");
  ASSERT_EQ(mesh.normals.size(), 3u);
  EXPECT_EQ(mesh.normals[1], triple(0, 1, 0));
  expect_error("a.obj", points + "f 1 2 3\n", "2 normals (vn) for 3 vertices");
}

TEST_F(Mesh_io, ObjDamage)
{
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  expect_error("a.obj", "", "empty");
  expect_error("a.obj", "hello world\n", "not an OBJ mesh");
  expect_error("a.obj", "v 0 0\n", "line 1");
  expect_error("a.obj", "v 0 0 x\n", "'x'");
  expect_error("a.obj", points + "vn 0 1\n", "line 4");
  expect_error("a.obj", points + "f 1 2 4\n", "line 4: the face's vertex index 4");
  expect_error("a.obj", points + "f 1 2 0\n", "out of range");
  expect_error("a.obj", points + "f 1 2 -4\n", "out of range");
  expect_error("a.obj", points + "f 1 2 x\n", "'x'");
  expect_error("a.obj", points + "vn 0 0 1\nf 1//1 2//2 3//1\n", "normal index 2");
}

// In comments and in names a last backslash is a letter like others.
TEST_F(Mesh_io, ObjLinesGoOnBehindABackslash)
{
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  const Faces one{{0, 1, 2}}, two{{0, 1, 2}, {2, 1, 0}};
  for (const std::string end : {"\n", "\r\n"}) {
    const std::string on = "\\" + end;
    EXPECT_EQ(faces_of(read("a.obj", points + "f 1 " + on + " 2 " + on + on + "3 # x" + end)), one);
    EXPECT_EQ(faces_of(read("a.obj", points + "f 1" + on + "2" + on + "3")), one);
    EXPECT_EQ(faces_of(read("a.obj", points + "f 1 2 3 # C:" + on + "f 3 2 1" + end)), two);
    EXPECT_EQ(faces_of(read("a.obj", points + "# C:" + on + "f 1 2 3" + end + "f 3 2 1" + end)),
              two);
    EXPECT_EQ(
      faces_of(read("a.obj", points + "f 1 2 3" + end + "l 1 " + on + "2 3" + end + "f 3 2 1")),
      two);
    EXPECT_EQ(faces_of(read("a.obj", points + "f 1 2 3" + end + "l 1 " + on + "f 3 2 1")), one);
    for (const char* const keyword : {"usemtl", "mtllib", "g", "o"})
      for (const bool with_attributes : {true, false}) {
        const std::string file =
          folder.write("a.obj", points + "f 1 2 3" + end + keyword + " C:\\parts" + on + "f 3 2 1");
        EXPECT_EQ(faces_of(read_mesh(input_mesh_file(file, std::nullopt), with_attributes)), two);
      }
  }
  EXPECT_EQ(read("a.obj", "v 1 2 \\\n 3 \\\n 0.5 0.5 0.5\nf 1 1 1\n").attributes.of_vertices.size(),
            3u);
  EXPECT_EQ(faces_of(read("a.obj", points + "f 1 2 3 \\")), one);
  expect_error("a.obj", "v 0 0 \\\n 0\nv 1 \\\n 0 x\nv 0 1 0\n", "line 4: 'x'");
  expect_error("a.obj", "v 0 0 \\\n 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", "line 5: the face's");
  expect_error("a.obj", points + "l 1 \\\n 2 \\\n 3\nf 1 2 x\n", "line 7: 'x'");
}

// What Microsoft's programs write for nan and infinity. Behind other numbers '#' begins a comment.
TEST_F(Mesh_io, NumbersThatAreNoneAreNamed)
{
  for (const std::string word : {"-1.#IND00", "1.#INF", "1.#QNAN0", "-1.#J"}) {
    const std::string part = "'" + word + "' stands where";
    expect_error("a.obj", "v 0 0 " + word + "\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "line 1: " + part);
    expect_error("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 " + word + "\nf 1 2 3\n",
                 "line 4: " + part);
    expect_error("a.off", "OFF\n3 1 0\n0 0 " + word + "\n1 0 0\n0 1 0\n3 0 1 2\n",
                 "line 3: " + part);
  }
  const Mesh_data mesh =
    read("a.obj", "v 0 0 1.#up\nv 1 0 1#Index 1.#INF\nv 0 1 1. #INF\nf 1 2 3\n");
  for (const Triple& p : mesh.points) EXPECT_EQ(p[2], 1);
}

TEST_F(Mesh_io, FacesOfLessThanThreeVerticesAreLeftToRepair)
{
  const std::string ply =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
    "property float z\nelement face 3\nproperty list uchar int vertex_indices\n"
    "property int id\nproperty list uchar float texcoord\nend_header\n";
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n";
  const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 1\nvn 0 0 1\n";
  const std::tuple<std::string, std::string, std::string> files[] = {
    {"a.obj", obj + "g a\nf 1/1/1 2/1/1\nf 9\ng b\nf 1/1/1 2/1/1 3/1/1\n",
     "line 7 has a face with 2 vertices"},
    {"a.off", "OFF\n3 3 0\n" + points + "2 0 1 9 9 9\n1 7\n3 0 1 2 1 2 3\n",
     "line 6 has a face with less"},
    {"a.ply", ply + points + "2 0 1 5 4 0 0 0 0\n0 6 0\n3 0 1 2 7 6 0 1 0 1 0 1\n",
     "face 0 of 3 has 2 vertices"}};
  for (const auto& [name, content, part] : files) {
    SCOPED_TRACE(name);
    Mesh_data mesh = read(name, content);
    EXPECT_EQ(faces_of(mesh), (Faces{{0, 1, 2}}));
    EXPECT_EQ(mesh.short_faces.number, 2u);
    expect_part(mesh.short_faces.first, part);
    for (const Column& column : mesh.attributes.of_faces) EXPECT_EQ(column.values.size(), 1u);
    EXPECT_EQ(mesh.attributes.of_faces.size(), name == "a.off" ? 3u : 1u);
    EXPECT_THROW(require_sound_elements(mesh), Error);
    EXPECT_EQ(repair_soup(mesh).removed_degenerate_faces, 2u);
    EXPECT_NO_THROW(require_sound_elements(mesh));
  }
  expect_error("a.off", "OFF\n3 2 0\n" + points + "2 0 1\n", "after 1 of 2 faces");
}

// --- STL ---

// One group for each name, in the order of the file; without names none.
TEST_F(Mesh_io, StlSolidsWithNamesAreGroups)
{
  const auto facet = [](int i) {
    std::string text = "facet normal 0 0 1\nouter loop\n";
    for (const char* const xy : {" 0 0", " 1 0", " 0 1"})
      text += "vertex " + std::to_string(i) + xy + "\n";
    return text + "endloop\nendfacet\n";
  };
  const std::string text = "solid\n" + facet(0) + "endsolid\nsolid  two words #2 \r\n" + facet(1) +
                           facet(2) + "endsolid\nsolid b\n" + facet(3) +
                           "endsolid b\nsolid two words #2\n" + facet(4) + "endsolid\n";
  const Mesh_data mesh = read("a.stl", text);
  ASSERT_EQ(mesh.attributes.of_faces.size(), 1u);
  const Column& groups = mesh.attributes.of_faces[0];
  EXPECT_EQ(groups.name, "group");
  EXPECT_EQ(groups.values, (std::vector<double>{-1, 0, 0, 1, 0}));
  EXPECT_EQ(groups.words, (std::vector<std::string>{"two words #2", "b"}));
  EXPECT_TRUE(
    read_mesh(input_mesh_file(folder.file("a.stl"), std::nullopt), false).attributes.empty());
  EXPECT_TRUE(read("b.stl", "solid\n" + facet(0) + "endsolid\n").attributes.empty());

  // and back, faces of a group one after the other
  const Mesh_file output = output_mesh_file(folder.file("c.stl"), std::nullopt);
  EXPECT_TRUE(not_held(output, mesh, Encoding::text).empty());
  EXPECT_EQ(not_held(output, mesh, Encoding::binary), std::vector<std::string>{"groups"});
  write_mesh(output, mesh, Encoding::text);
  const Mesh_data again = read_mesh(folder.file("c.stl"));
  EXPECT_EQ(again.attributes.of_faces[0].values, (std::vector<double>{-1, 0, 0, 0, 1}));
  EXPECT_EQ(again.attributes.of_faces[0].words, groups.words);
  EXPECT_EQ(again.points[again.face(3).front()], triple(4, 0, 0));

  // one name has room in the head of a binary file
  const Mesh_data single = read("d.stl", "solid part\n" + facet(0) + facet(1) + "endsolid\n");
  EXPECT_TRUE(not_held(output, single, Encoding::binary).empty());
  write_mesh(output, single, Encoding::binary);
  EXPECT_EQ(Temporary_folder::content(folder.file("c.stl"))
              .find("binary STL written by pn_subdivide: part"),
            0u);
}

TEST_F(Mesh_io, StlTextHoldsEveryBit)
{
  Mesh_data mesh;
  mesh.points = {{1. / 3, 4399999.25, 1e-200}, {1, 0, 0.1}, {0, 1e300, 0}};
  mesh.add_face(std::vector<int>{2, 0, 1});
  const Mesh_data again = written_and_read("a.stl", mesh, Encoding::text);
  EXPECT_EQ(bits(again.points), bits({mesh.points[2], mesh.points[0], mesh.points[1]}));
  EXPECT_EQ(Temporary_folder::content(folder.file("a.stl")).rfind("solid\nfacet normal ", 0), 0u);
}

// In the middle of single precision nothing is said of what all files have.
TEST_F(Mesh_io, StlSaysWhatSinglePrecisionLoses)
{
  const auto loss = [](double at, double size, Encoding encoding = Encoding::binary) {
    Mesh_data mesh;
    for (const double x : {0., 0.3, 1.})
      mesh.points.push_back({at + size * x, at + size * x * x, 0});
    mesh.points.push_back({at, at + size / 7, size});
    mesh.add_face(std::vector<int>{0, 1, 2});
    mesh.add_face(std::vector<int>{0, 2, 3});
    return lost_precision({"a.stl", "stl"}, mesh, encoding);
  };
  for (const double size : {1e-30, 0.01, 1., 1000., 1e30}) {
    EXPECT_EQ(loss(0, size), "");
    EXPECT_EQ(loss(-3 * size, size), ""); // on the bed of a printer
    EXPECT_NE(loss(1000 * size, size), "");
  }
  expect_part(loss(4400001, 1), "moves points by up to 0.2");
  expect_part(loss(4400001, 0.1), "makes 2 equal to others");
  expect_part(loss(0, 1e-200), "makes 3 equal to others");
  EXPECT_EQ(loss(4400001, 1, Encoding::text), "");
  EXPECT_EQ(lost_precision({"a.ply", "ply"}, Mesh_data(), Encoding::binary), "");
}

TEST_F(Mesh_io, StlTextAndBinaryMergeEqualPoints)
{
  const double p[4][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0.5}, {0, 1, 0.25}};
  const int t[2][3] = {{0, 1, 2}, {0, 2, 3}};
  std::string text = "solid a square\n", binary(80, ' ');
  binary += raw(std::uint32_t(2), false);
  for (const auto& triangle : t) {
    text += "facet normal 0 0 1\nouter loop\n";
    binary += raw(0.f, false) + raw(0.f, false) + raw(1.f, false);
    for (const int v : triangle) {
      text += "vertex";
      for (const double x : p[v]) {
        text += " " + std::to_string(x);
        binary += raw(static_cast<float>(x), false);
      }
      text += "\n";
    }
    text += "endloop\nendfacet\n";
    binary += std::string(2, '\0');
  }
  text += "endsolid a square\n";
  std::string misleading = binary; // a binary file whose header begins like text
  misleading.replace(0, 6, "solid ");

  for (const std::string& content : {text, binary, misleading}) {
    const Mesh_data mesh = read("a.stl", content);
    ASSERT_EQ(mesh.points.size(), 4u);
    for (int v = 0; v < 4; ++v) EXPECT_EQ(mesh.points[v], triple(p[v][0], p[v][1], p[v][2]));
    EXPECT_EQ(faces_of(mesh), (Faces{{0, 1, 2}, {0, 2, 3}}));
    EXPECT_FALSE(mesh.has_normals());
  }
  expect_error("a.stl", "", "empty");
  expect_error("a.stl", "nonsense", "not an STL file");
  expect_error("a.stl", text.substr(0, text.size() - 30), "damaged or truncated");
  expect_error("a.stl", binary.substr(0, binary.size() - 1), "truncated");
  expect_error("a.stl", binary + "12", "truncated");
}

// No facet may get lost.
TEST_F(Mesh_io, StlIsWrittenAsBinaryTriangles)
{
  Mesh_data mesh;
  mesh.points = {{0, 0, 0}, {0.1, 0, 0}, {0, 3, 0}, {0, 0, -2}};
  mesh.add_face(std::vector<int>{0, 1, 2});
  mesh.add_face(std::vector<int>{0, 1, 3});
  write_mesh(folder.file("w.stl"), mesh, Encoding::binary);
  const std::string content = Temporary_folder::content(folder.file("w.stl"));
  ASSERT_EQ(content.size(), 84u + 2 * 50u);
  EXPECT_NE(content.rfind("solid", 0), 0u); // would be taken for text
  EXPECT_EQ(content.substr(80, 4), raw(std::uint32_t(2), false));
  const float first[] = {0, 0, 1, 0, 0, 0, 0.1f, 0, 0, 0, 3, 0}; // the normal, the corners
  for (std::size_t i = 0; i < 12; ++i)
    EXPECT_EQ(content.substr(84 + 4 * i, 4), raw(first[i], false)) << i;
  EXPECT_EQ(content.substr(134 + 4, 4), raw(1.f, false)); // the second normal is 0 1 0
  const Mesh_data again = read_mesh(folder.file("w.stl"));
  EXPECT_EQ(faces_of(again), faces_of(mesh));
  EXPECT_EQ(again.points[1], triple(double(0.1f), 0, 0));

  mesh.points[3] = {0, 1e39, 0};
  EXPECT_THROW(write_mesh(folder.file("w.stl"), mesh, Encoding::binary), Error);
  EXPECT_EQ(Temporary_folder::content(folder.file("w.stl")), content);
}

TEST_F(Mesh_io, WhatIsDroppedIsNamed)
{
  using Names = std::vector<std::string>;
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  EXPECT_EQ(read("a.obj", points + "s off\nf 1 2 3\n").dropped, Names());
  EXPECT_EQ(read("a.obj", "v 0 0 0 1\nv 1 0 0 1\nv 0 1 0 1\nf 1 2 3\n").dropped, Names());
  EXPECT_EQ(read("a.obj", points + "l 1 2\np 1\nusemap m\nf 1 2 3\n").dropped,
            (Names{"lines and points", "'usemap'"}));
  EXPECT_EQ(read("a.ply",
                 "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float "
                 "y\nproperty float z\nproperty list uchar int neighbors\nelement "
                 "face 1\nproperty list uchar int vertex_indices\nelement edge 1\nproperty "
                 "int a\nend_header\n0 0 0 1 1\n1 0 0 1 1\n0 1 0 0\n3 0 1 2\n0\n")
              .dropped,
            (Names{"the property 'neighbors'", "the element 'edge'"}));
}

TEST_F(Mesh_io, ObjNormalsThatDifferByMoreThanRoundingAreCounted)
{
  const auto several = [&](const std::string& second) {
    return read("n.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvn 0 0 1\nvn " + second +
                           "\nf 1//1 2//1 3//1\nf 2//2 4//2 3//2\n")
      .vertices_with_several_normals;
  };
  EXPECT_EQ(several("0 0 1"), 0u);
  EXPECT_EQ(several("0.001 0 1"), 0u);
  EXPECT_EQ(several("0 0 2"), 0u);
  EXPECT_EQ(several("0.003 0 1"), 2u);
}

TEST_F(Mesh_io, FilesOfOtherConventionsGetAHint)
{
  expect_error("n.off", "3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "put a line OFF in front");
  expect_error("s.stl", "SOLID a\nFACET NORMAL 0 0 1\nENDSOLID\n", "lower case");
}

// Texts of classic Mac OS, also in front of binary data with bytes of every kind.
TEST_F(Mesh_io, LinesMayEndWithCarriageReturns)
{
  const auto classic = [](std::string text) {
    std::replace(text.begin(), text.end(), '\n', '\r');
    return text;
  };
  const std::string head = "ply\nformat ascii 1.0\ncomment x\nelement vertex 3\nproperty float x\n"
                           "property float y\nproperty float z\nelement face 1\n"
                           "property list uchar int vertex_indices\nend_header\n";
  const std::pair<std::string, std::string> texts[] = {
    {"a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
    {"b.off", "OFF # \n3 1 0\n0 0 0\n1 0 0\n# f\n\n0 1 0\n3 0 1 2"},
    {"a.obj", "v 0 0 0\nv 1 0 \\\n0\nv 0 1 0\nusemtl m #1\nf 1 2 3\n"},
    {"a.ply", head + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
    {"a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
              "endloop\nendfacet\nendsolid a\n"}};
  for (const auto& [name, text] : texts) {
    SCOPED_TRACE(name);
    expect_same(read(name, classic(text)), read(name, text));
  }
  expect_error("c.off", classic("OFF\n3 1 0\n0 0 0\n1 0 x\n"), "line 4: 'x'");

  std::string binary = head;
  binary.replace(binary.find("ascii"), 5, "binary_little_endian");
  binary = classic(binary);
  const std::uint32_t line_ends = 0x0a0d0a0d; // where coordinates are
  float awkward;
  std::memcpy(&awkward, &line_ends, sizeof awkward);
  for (const float x : {awkward, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, awkward})
    binary += raw(x, false);
  binary += '\3';
  for (const int v : {0, 1, 2}) binary += raw(v, false);
  const Mesh_data mesh = read("b.ply", binary);
  EXPECT_EQ(mesh.points[0][0], double(awkward));
  EXPECT_EQ(mesh.points[2][2], double(awkward));
  EXPECT_EQ(faces_of(mesh), (Faces{{0, 1, 2}}));
}

TEST_F(Mesh_io, StlDamage)
{
  const std::string corners = "outer loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n";
  const std::string facet = "facet normal 0 0 -nan(ind)\n" + corners + "endfacet\n";
  EXPECT_EQ(read("a.stl", "\nsolid\n" + facet + facet + "endsolid\nsolid vertex facet\r\n" + facet +
                            "endsolid vertex facet\n\n")
              .number_of_faces(),
            3u);
  const auto damaged = [&](std::size_t at, char c) {
    std::string text = "solid a\n" + facet + facet + "endsolid a\n";
    text[at] = c;
    return text;
  };
  const std::size_t second = 8 + facet.size();
  expect_error("a.stl", damaged(second + 4, 'x'), "line 9: damaged or truncated STL file: 'facex'");
  expect_error("a.stl", damaged(second - 2, 'x'), "line 8: damaged");
  expect_error("a.stl", damaged(second + facet.find("vertex 1") + 7, 'x'), "'x' stands");
  expect_error("a.stl", damaged(second + facet.find("vertex 1") + 8, '7'), "stands where a coord");
  expect_error("a.stl", "solid a\n" + facet, "it ends where 'facet' or 'endsolid'");
  expect_error("a.stl", "solid a\n" + facet + "endsolid a\n" + facet, "'solid' is expected");
  expect_error("a.stl", "solid\nfacet\nouter loop\nvertex 0 0 0\nvertex 1 0 inf\nvertex 0 1 0\n",
               "finite");

  std::string binary = std::string(80, ' ') + raw(std::uint32_t(2), false);
  for (int f = 0; f < 2; ++f) {
    for (const float x : {0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f})
      binary += raw(x, false);
    binary += std::string(2, '\0');
  }
  EXPECT_EQ(read("b.stl", binary).number_of_faces(), 2u);
  // attribute bytes that are the same everywhere are no colors
  const auto dropped = [&](const char* one, const char* other) {
    std::string with_bytes = binary;
    with_bytes.replace(84 + 48, 2, one, 2).replace(84 + 98, 2, other, 2);
    return read("c.stl", with_bytes).dropped.size();
  };
  EXPECT_EQ(dropped("\xff\x7f", "\xff\x7f"), 0u);
  EXPECT_EQ(dropped("\xff\x7f", "\xff\x3f"), 1u);
  binary.replace(84 + 50 + 24, 4, raw(std::numeric_limits<float>::quiet_NaN(), false));
  expect_error("b.stl", binary, "triangle 1 has a coordinate that is not finite");
}

// --- files ---

TEST_F(Mesh_io, ByteOrderMarksAreSkipped)
{
  const std::string mark = "\xEF\xBB\xBF";
  EXPECT_EQ(read("a.off", mark + "OFF 3 1\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n").points.size(), 3u);
  EXPECT_EQ(read("a.obj", mark + "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").points.size(), 3u);
}

TEST_F(Mesh_io, TextsInUtf16AreNamed)
{
  const std::string ascii = "OFF 3 1\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  std::string low_first, high_first;
  for (const char c : ascii) {
    low_first += {c, '\0'};
    high_first += {'\0', c};
  }
  for (const std::string& text :
       {"\xFF\xFE" + low_first, "\xFE\xFF" + high_first, low_first, high_first})
    for (const char* file : {"a.off", "a.obj"}) expect_error(file, text, "UTF-16");
}

TEST_F(Mesh_io, ObjCornersMayEndWithSlashes)
{
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\n";
  for (const char* face :
       {"f 1/ 2/ 3/\n", "f 1// 2// 3//\n", "f 1/1/ 2/1/ 3/1/\n", "vn 0 0 1\nf 1//1 2// 3/1/1\n"}) {
    const Mesh_data mesh = read("a.obj", points + face);
    ASSERT_EQ(mesh.number_of_faces(), 1u) << face;
    for (Mesh_data::Index i = 0; i < 3; ++i) EXPECT_EQ(mesh.face(0).begin()[i], i);
    EXPECT_EQ(mesh.has_normals(), std::string(face).find("//1") != std::string::npos) << face;
  }
}

TEST_F(Mesh_io, MissingFilesFoldersAndUnknownFormats)
{
  expect_part(error_of(folder.file("missing.ply")), "No such file");
  std::filesystem::create_directory(folder.file("folder.ply"));
  expect_part(error_of(folder.file("folder.ply")), "directory");
  EXPECT_THROW(input_mesh_file("a.vtp", std::nullopt), Usage_error);
  EXPECT_THROW(input_mesh_file("a", std::nullopt), Usage_error);
  EXPECT_THROW(output_mesh_file("a.svg", std::nullopt), Usage_error);
  EXPECT_NO_THROW(input_mesh_file("a.STL", std::nullopt));
  EXPECT_NO_THROW(output_mesh_file("a.b.VTP", std::nullopt));
}

TEST_F(Mesh_io, WritingReplacesAFileAsAWholeAndLeavesNothingElse)
{
  const std::string file = folder.write("a.ply", "old");
  std::filesystem::permissions(file, std::filesystem::perms(0640));
  write_mesh(file, awkward_mesh(true), Encoding::binary);
  EXPECT_EQ(read_mesh(file).points.size(), 20u);
  EXPECT_EQ(std::filesystem::status(file).permissions(), std::filesystem::perms(0640));
  EXPECT_EQ(folder.number_of_files(), 1u);
}

TEST_F(Mesh_io, LinksAreFollowed)
{
  const std::string file = folder.write("a.ply", "old");
  std::filesystem::create_symlink("a.ply", folder.file("link.ply"));
  write_mesh(folder.file("link.ply"), awkward_mesh(true), Encoding::binary);
  EXPECT_TRUE(std::filesystem::is_symlink(folder.file("link.ply")));
  EXPECT_EQ(read_mesh(file).points.size(), 20u);
}

TEST_F(Mesh_io, FullDeviceIsAnError)
{
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "does not apply: no /dev/full";
  std::filesystem::create_symlink("/dev/full", folder.file("full.ply"));
  EXPECT_THROW(write_mesh(folder.file("full.ply"), awkward_mesh(true), Encoding::binary), Error);
  EXPECT_TRUE(std::filesystem::is_symlink(folder.file("full.ply")));
}

TEST_F(Mesh_io, VtpTextHoldsTheArrays)
{
  Mesh_data mesh;
  mesh.points = {triple(0, 0, 0), triple(1, 0, 0), triple(0, 1, 0.5)};
  mesh.normals.assign(3, triple(0, 0, 1));
  mesh.add_face(std::vector<int>{0, 1, 2});
  write_mesh(folder.file("a.vtp"), mesh, Encoding::text);
  const std::string s = Temporary_folder::content(folder.file("a.vtp"));
  expect_part(s, "0 0 0\n1 0 0\n0 1 0.5\n");
  expect_part(s, "NumberOfPoints=\"3\"");
  expect_part(s, "NumberOfPolys=\"1\"");
}

TEST_F(Mesh_io, VtpBinaryOffsetsLeadToTheArrays)
{
  const Mesh_data mesh = awkward_mesh(true);
  write_mesh(folder.file("a.vtp"), mesh, Encoding::binary);
  const std::string s = Temporary_folder::content(folder.file("a.vtp"));
  EXPECT_EQ(bits(raw_array<double>(s, "Points")), bits(mesh.points));
  EXPECT_EQ(bits(raw_array<double>(s, "Normals")), bits(mesh.normals));
  std::vector<std::int64_t> connectivity, offsets;
  for (const auto& face : faces_of(mesh)) {
    connectivity.insert(connectivity.end(), face.begin(), face.end());
    offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
  }
  EXPECT_EQ(raw_array<std::int64_t>(s, "connectivity"), connectivity);
  EXPECT_EQ(raw_array<std::int64_t>(s, "offsets"), offsets);
}

// --- checks and repair of soups ---

Mesh_data soup(std::size_t points, const Faces& faces)
{
  Mesh_data mesh;
  for (std::size_t i = 0; i < points; ++i) {
    mesh.points.push_back({double(i), double(i * i), 1.0});
    mesh.normals.push_back({0, double(i), 1});
  }
  for (const auto& face : faces) mesh.add_face(face);
  return mesh;
}

std::string element_error(const Mesh_data& mesh)
{
  try {
    require_sound_elements(mesh);
  } catch (const Error& e) {
    return e.what();
  }
  return "";
}

TEST(Soup, ManifoldsHaveNoDefects)
{
  EXPECT_TRUE(find_defects(soup(5, {{0, 1, 2}, {2, 1, 3}})).none());
  EXPECT_TRUE(find_defects(soup(4, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}})).none());
  EXPECT_TRUE(find_defects(soup(6, {{0, 1, 2}, {3, 4, 5}})).none());
}

TEST(Soup, DefectsAreCountedAndMended)
{
  // three pages of a book; two triangles of opposite orientation; a bow-tie of open fans; two
  // tetrahedra that share a vertex
  const Faces book{{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
  const Faces twisted{{0, 1, 2}, {1, 2, 3}};
  const Faces bow_tie{{0, 1, 2}, {0, 3, 4}};
  const Faces pinched{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2},
                      {0, 4, 5}, {0, 5, 6}, {0, 6, 4}, {4, 6, 5}};
  const Faces moebius{{0, 1, 3, 2}, {2, 3, 5, 4}, {4, 5, 0, 1}};

  EXPECT_EQ(find_defects(soup(5, book)).crowded.number, 1u);
  EXPECT_EQ(find_defects(soup(5, book)).description(soup(5, book)),
            "1 edge has more than two faces (first: 0-1)");
  EXPECT_EQ(find_defects(soup(4, twisted)).unoriented.number, 1u);
  EXPECT_EQ(find_defects(soup(5, bow_tie)).pinched.number, 1u);
  EXPECT_EQ(find_defects(soup(7, pinched)).pinched.number, 1u);
  EXPECT_EQ(find_defects(soup(6, moebius)).unoriented.number, 1u);

  const struct
  {
    Faces faces;
    std::size_t points, reversed, added;
  } cases[] = {{book, 5, 0, 4}, {twisted, 4, 1, 0}, {bow_tie, 5, 0, 1}, {pinched, 7, 0, 1}};
  for (const auto& c : cases) {
    Mesh_data mesh = soup(c.points, c.faces);
    const Mesh_data old = mesh;
    const Soup_repair repair = repair_soup(mesh);
    EXPECT_EQ(repair.reversed_faces, c.reversed);
    EXPECT_EQ(repair.added_vertices, c.added);
    EXPECT_TRUE(find_defects(mesh).none());
    EXPECT_EQ(mesh.number_of_faces(), c.faces.size());
    ASSERT_EQ(mesh.points.size(), c.points + c.added);
    ASSERT_EQ(mesh.normals.size(), mesh.points.size());
    for (std::size_t v = 0; v < mesh.points.size(); ++v) { // here y = x² marks each original
      const std::size_t original = static_cast<std::size_t>(mesh.points[v][0]);
      EXPECT_TRUE(original == v || v >= c.points);
      EXPECT_EQ(mesh.normals[v], old.normals[original]);
    }
  }
  Mesh_data mesh = soup(6, moebius);
  repair_soup(mesh);
  EXPECT_TRUE(find_defects(mesh).none());
  EXPECT_EQ(mesh.number_of_faces(), 3u);
}

TEST(Soup, UnsoundElementsAreNamed)
{
  const Faces face{{0, 1, 2}};
  EXPECT_EQ(element_error(soup(3, face)), "");
  expect_part(element_error(soup(3, {})), "no face");
  expect_part(element_error(soup(4, {{0, 1, 2}, {0, 1, 2, 1}})), "face 1 visits vertex 1 twice");
  expect_part(element_error(soup(2, face)), "out of range");

  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    Mesh_data mesh = soup(3, face);
    mesh.points[2] = triple(0, 0, bad);
    expect_part(element_error(mesh), "vertex 2 has a coordinate");
  }
  Mesh_data mesh = soup(3, face);
  mesh.normals.pop_back();
  expect_part(element_error(mesh), "2 normals for 3 vertices");
}

TEST(Soup, EqualPointsAreMergedIntoTheFirst)
{
  Mesh_data mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, -0.0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0}};
  mesh.normals = {{0, 0, 2}, {0, 0, 1}, {0, 3, 0}, {0, 0, 1}, {0, 0, 1}, {0, 0, 5}, {0, 0, 2}};
  mesh.add_face(std::vector<int>{0, 1, 2});
  mesh.add_face(std::vector<int>{3, 4, 5});
  EXPECT_EQ(merge_equal_points(mesh).merged_vertices, 3u);
  EXPECT_EQ(mesh.points.size(), 4u);
  EXPECT_EQ(faces_of(mesh), (Faces{{0, 1, 2}, {1, 3, 2}}));
  EXPECT_EQ(mesh.normals[0], triple(0, 0, 2)); // equal normals stay as they are
  EXPECT_EQ(mesh.normals[3], triple(0, 0, 1));
  EXPECT_NEAR(mesh.normals[2][1], std::sqrt(0.5), 1e-15); // of unit normals
  EXPECT_NEAR(mesh.normals[2][2], std::sqrt(0.5), 1e-15);
}

TEST(Soup, FacesThatVisitAVertexTwiceAreSplit)
{
  const struct
  {
    Faces faces, expected;
    std::size_t removed, split;
  } cases[] = {{{{0, 0, 1}}, {}, 1, 0},
               {{{0, 1, 0, 2}}, {}, 1, 0},
               {{{0, 1, 2, 0}}, {{0, 1, 2}}, 0, 1},
               {{{0, 0, 1, 2, 2}}, {{0, 1, 2}}, 0, 1},
               {{{0, 1, 2, 0, 3, 4}}, {{0, 1, 2}, {0, 3, 4}}, 0, 1},
               {{{1, 2, 3}, {0, 1, 2, 1, 3}}, {{1, 2, 3}, {0, 1, 3}}, 0, 1}};
  for (const auto& c : cases) {
    Mesh_data mesh = soup(5, c.faces);
    const Soup_repair repair = repair_soup(mesh);
    EXPECT_EQ(repair.removed_degenerate_faces, c.removed);
    EXPECT_EQ(repair.split_faces, c.split);
    if (repair.added_vertices + repair.reversed_faces == 0) {
      EXPECT_EQ(faces_of(mesh), c.expected);
    }
  }
}

TEST(Soup, DuplicateFacesAreRemovedFromSoupsWithDefectsOnly)
{
  const Faces twice{{0, 1, 2}, {1, 3, 2}, {2, 0, 1}, {2, 3, 1}};
  Mesh_data mesh = soup(4, twice);
  EXPECT_EQ(repair_soup(mesh).removed_duplicate_faces, 2u);
  EXPECT_EQ(faces_of(mesh), (Faces{{0, 1, 2}, {1, 3, 2}}));
  const Faces cushion{{0, 1, 2}, {0, 2, 1}}; // a closed surface, flat as it is
  mesh = soup(3, cushion);
  EXPECT_FALSE(repair_soup(mesh).changed_anything());
  EXPECT_EQ(faces_of(mesh), cushion);
  const Faces other_order{{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 1, 2, 3}}; // same vertices, another face
  mesh = soup(4, other_order);
  EXPECT_EQ(repair_soup(mesh).removed_duplicate_faces, 1u);
}

// --- the mesh of a soup ---

Surface by_add_face(const Mesh_data& mesh)
{
  Surface surface;
  for (const Triple& p : mesh.points) surface.add_vertex(to_point(p));
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
    std::vector<Surface::Vertex_index> face;
    for (const Mesh_data::Index v : mesh.face(f)) face.emplace_back(v);
    EXPECT_NE(surface.add_face(face), Surface::null_face());
  }
  return surface;
}

void expect_same_connectivity(const Surface& a, const Surface& b)
{
  ASSERT_EQ(a.number_of_halfedges(), b.number_of_halfedges());
  ASSERT_EQ(a.number_of_faces(), b.number_of_faces());
  for (const auto v : b.vertices()) ASSERT_EQ(a.halfedge(v), b.halfedge(v));
  for (const auto f : b.faces()) ASSERT_EQ(a.halfedge(f), b.halfedge(f));
  for (const auto h : b.halfedges()) {
    ASSERT_EQ(a.target(h), b.target(h));
    ASSERT_EQ(a.next(h), b.next(h));
    ASSERT_EQ(a.prev(h), b.prev(h));
    ASSERT_EQ(a.face(h), b.face(h));
  }
  EXPECT_TRUE(a.is_valid(false));
}

TEST(Soup, BecomesTheMeshThatAddFaceMakes)
{
  int meshes = 0;
  for (const char* const folder : {PN_DATA_DIR, PN_TEST_REAL_MESH_DIR}) {
    if (!std::filesystem::is_directory(folder)) continue;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      const std::string extension = entry.path().extension().string();
      if (extension != ".off" && extension != ".ply" && extension != ".obj") continue;
      Mesh_data mesh;
      try {
        mesh = read_mesh(entry.path().string());
        require_sound_elements(mesh);
      } catch (const Error&) {
        continue;
      }
      if (!find_defects(mesh).none()) continue;
      SCOPED_TRACE(entry.path());
      expect_same_connectivity(make_surface(mesh), by_add_face(mesh));
      ++meshes;
    }
  }
  EXPECT_GT(meshes, 15);
  EXPECT_THROW(make_surface(soup(5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}})), Error);
  EXPECT_THROW(make_surface(soup(4, {{0, 1, 2}, {1, 2, 3}})), Error);
}

// With a walk round the vertex for each face this would be 10^10 steps.
TEST(Soup, AVertexOfLargeValence)
{
  constexpr unsigned n = 100000;
  Mesh_data mesh;
  mesh.points.assign(n + 1, Triple{0, 0, 0});
  for (unsigned i = 0; i < n; ++i) mesh.add_face(std::vector<unsigned>{n, i, (i + 1) % n});
  EXPECT_TRUE(find_defects(mesh).none());
  const Surface surface = make_surface(mesh);
  EXPECT_EQ(surface.number_of_edges(), 2 * n);
  EXPECT_EQ(surface.face(surface.halfedge(Surface::Vertex_index(n))), Surface::Face_index(n - 1));
}

} // namespace

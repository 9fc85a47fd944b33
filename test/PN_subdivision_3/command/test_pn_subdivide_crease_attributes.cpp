// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Whatever makes the creases and wherever normals come from, what a file says besides them is carried.

#include "Command_test.h"
#include "Extent.h"

#include "io/mesh_io.h"

#include <utility>

using namespace pn_subdivide;

namespace {

// A box of 2 x 1 x 1 quads, folded where its sides meet, with a group and a color of its own for each face, texture
// points of corners (a chart for each face) and colors of vertices.
const double box_points[][3] = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0},
                                {0, 0, 1}, {1, 0, 1}, {2, 0, 1}, {0, 1, 1}, {1, 1, 1}, {2, 1, 1}};
const int box_faces[][4] = {{0, 3, 4, 1},  {1, 4, 5, 2}, {6, 7, 10, 9}, {7, 8, 11, 10},
                            {0, 1, 7, 6},  {1, 2, 8, 7}, {2, 5, 11, 8}, {5, 4, 10, 11},
                            {4, 3, 9, 10}, {3, 0, 6, 9}};

// that of the face's side: -z, -z, z, z, ...
const char* const side_normals[] = {"0 0 -1", "0 0 -1", "0 0 1", "0 0 1", "0 -1 0",
                                    "0 -1 0", "1 0 0",  "0 1 0", "0 1 0", "-1 0 0"};

enum class Given { none, of_vertices, of_corners };

std::string box_obj(Given normals)
{
  std::ostringstream s;
  s << "mtllib box.mtl\no box\n";
  for (const auto& p : box_points)
    s << "v " << p[0] << ' ' << p[1] << ' ' << p[2] << ' ' << p[0] / 2 << " 0.25 1\n";
  for (int i = 0; i < 40; ++i) s << "vt " << i << ' ' << i * i % 7 << "\n";
  if (normals == Given::of_vertices)
    for (const auto& p : box_points)
      s << "vn " << p[0] - 1 << ' ' << p[1] - 0.5 << ' ' << p[2] - 0.5 << "\n";
  if (normals == Given::of_corners)
    for (const char* const n : side_normals) s << "vn " << n << "\n";
  for (int f = 0; f < 10; ++f) {
    s << "g g" << f % 3 << "\nusemtl m" << f % 4 << "\ns " << f % 2 << "\nf";
    for (int i = 0; i < 4; ++i) {
      s << ' ' << box_faces[f][i] + 1 << '/' << 4 * f + i + 1;
      if (normals == Given::of_vertices) s << '/' << box_faces[f][i] + 1;
      if (normals == Given::of_corners) s << '/' << f + 1;
    }
    s << "\n";
  }
  return s.str();
}

// Scalars of every kind at vertices and faces; with `is_split` every face has vertices of its own, whose texture
// points make seams.
std::string box_ply(bool has_normals, bool is_split)
{
  std::ostringstream s;
  s << "ply\nformat ascii 1.0\ncomment TextureFile box.png\nelement vertex " << (is_split ? 40 : 12)
    << "\nproperty double x\nproperty double y\nproperty double z\n";
  if (has_normals) s << "property double nx\nproperty double ny\nproperty double nz\n";
  s << "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty float quality\n"
       "property int id\n";
  if (is_split) s << "property float s\nproperty float t\n";
  s << "element face 10\nproperty list uchar int vertex_indices\nproperty int label\n"
       "property double weight\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n";
  if (!is_split) s << "property list uchar float texcoord\n";
  s << "end_header\n";
  const auto vertex = [&](int v, int corner) {
    const auto& p = box_points[v];
    s << p[0] << ' ' << p[1] << ' ' << p[2] << ' ';
    if (has_normals) s << p[0] - 1 << ' ' << p[1] - 0.5 << ' ' << p[2] - 0.5 << ' ';
    s << 20 * v << " 7 255 " << 0.1 * v << ' ' << 10 * v;
    if (is_split) s << ' ' << corner << ' ' << corner * corner % 7;
    s << "\n";
  };
  if (is_split)
    for (int corner = 0; corner < 40; ++corner) vertex(box_faces[corner / 4][corner % 4], corner);
  else
    for (int v = 0; v < 12; ++v) vertex(v, 0);
  for (int f = 0; f < 10; ++f) {
    s << 4;
    for (int i = 0; i < 4; ++i) s << ' ' << (is_split ? 4 * f + i : box_faces[f][i]);
    s << ' ' << 100 + f << ' ' << 0.1 * f << ' ' << f << " 3 200";
    if (!is_split) {
      s << " 8";
      for (int i = 0; i < 4; ++i) s << ' ' << f + 0.25 * i << ' ' << i * i;
    }
    s << "\n";
  }
  return s.str();
}

std::string box_off(bool has_normals)
{
  std::ostringstream s;
  s << (has_normals ? "STCNOFF" : "STCOFF") << "\n12 10 0\n";
  for (int v = 0; v < 12; ++v) {
    const auto& p = box_points[v];
    s << p[0] << ' ' << p[1] << ' ' << p[2] << ' ';
    if (has_normals) s << p[0] - 1 << ' ' << p[1] - 0.5 << ' ' << p[2] - 0.5 << ' ';
    s << 20 * v << " 7 255 255 " << 0.1 * v << ' ' << 0.3 * v << "\n";
  }
  for (int f = 0; f < 10; ++f) {
    s << 4;
    for (const int v : box_faces[f]) s << ' ' << v;
    s << ' ' << 20 * f << " 1 2\n";
  }
  return s.str();
}

// All that is carried, as one text: what differs is seen.
std::string all_of(const Mesh_data& mesh)
{
  std::ostringstream s;
  s.precision(17);
  for (const Columns* columns : {&mesh.attributes.of_vertices, &mesh.attributes.of_faces})
    for (const Column& c : *columns) {
      s << c.name << ' ' << int(c.type) << ':';
      for (const double x : c.values) s << ' ' << x;
      for (const std::string& word : c.words) s << ' ' << word;
      s << '\n';
    }
  s << "texture:";
  for (const Texture_point& t : mesh.attributes.texture) s << ' ' << t[0] << ' ' << t[1];
  for (const std::string& file : mesh.attributes.texture_files) s << "\nfile " << file;
  for (const std::string& file : mesh.attributes.material_files) s << "\nfile " << file;
  return s.str();
}

class Pn_subdivide_crease_attributes : public Command_test
{
protected:
  std::string carried(const std::string& input, const std::string& options) const
  {
    const Outcome outcome = done(surface(input, "out.ply", "--quiet " + options));
    return outcome.code == 0 ? all_of(read_mesh(folder.file("out.ply"))) : "";
  }
};

} // namespace

// Attributes follow the rows of the linear scheme, so they are those of --linear, which needs no normals.
TEST_F(Pn_subdivide_crease_attributes, AreThoseOfTheLinearSurface)
{
  const std::string selection = folder.write("a.selection.txt", "0\n\n0 1 1 2 3 4\n");
  // those of the copies that --merge-points takes for one vertex
  const std::string split_selection = folder.write("b.selection.txt", "0\n\n0 3 4 7\n");
  const struct
  {
    std::string name, content;
    bool has_normals, has_corner_normals, is_split;
  } files[] = {{"plain.obj", box_obj(Given::none), false, false, false},
               {"vertices.obj", box_obj(Given::of_vertices), true, false, false},
               {"corners.obj", box_obj(Given::of_corners), true, true, false},
               {"plain.ply", box_ply(false, false), false, false, false},
               {"vertices.ply", box_ply(true, false), true, false, false},
               {"split.ply", box_ply(false, true), false, false, true},
               {"split_vertices.ply", box_ply(true, true), true, false, true},
               {"plain.off", box_off(false), false, false, false},
               {"vertices.off", box_off(true), true, false, false}};
  std::size_t compared = 0, offset = 0;
  for (const auto& file : files) {
    const std::string input = folder.write(file.name, file.content);
    std::vector<std::string> sharp = {"none", "auto", "angle:30",
                                      "'" + (file.is_split ? split_selection : selection) + "'"};
    if (file.has_corner_normals) sharp.emplace_back("file");
    std::vector<std::string> normals = {"auto", "estimate",         "angle",
                                        "none", "sphere:1,0.5,0.5", "cylinder:0,0.5,0.5,1,0,0"};
    if (file.has_normals) normals.emplace_back("file");
    for (const std::string& s : sharp)
      for (const std::string levels : {"0", "1"}) {
        // each source of normals meets each file, and each way to make creases
        const std::size_t step = tests_are_full ? 1 : 3;
        ++offset;
        const std::string options = "--scheme catmull-clark --levels " + levels + " --sharp " + s +
                                    (file.is_split ? " --merge-points" : "");
        const std::string expected = carried(input, options + " --linear");
        for (const char* part : {"red", "texture:"})
          EXPECT_NE(expected.find(part), std::string::npos) << file.name;
        for (std::size_t i = offset % step; i < normals.size(); i += step) {
          ++compared;
          EXPECT_EQ(carried(input, options + " --normals " + normals[i]), expected)
            << file.name << ": --normals " << normals[i] << ' ' << options;
        }
      }
  }
  EXPECT_GT(compared, tests_are_full ? 400u : 100u);
}

// With no round at all they are those of the file, to the last bit.
TEST_F(Pn_subdivide_crease_attributes, AreThoseOfTheFileWithoutRounds)
{
  for (const auto& [name, content] :
       {std::pair<std::string, std::string>("a.obj", box_obj(Given::none)),
        {"b.ply", box_ply(false, false)},
        {"c.ply", box_ply(true, false)},
        {"d.off", box_off(false)}}) {
    const Mesh_data mesh = read_mesh(folder.write(name, content));
    const std::string input = folder.file("with_types.ply"); // those of a PLY file stay
    write_mesh(input, mesh, Encoding::binary);
    EXPECT_EQ(carried(input, "--levels 0 --sharp angle:30"), all_of(mesh)) << name;
  }
}

// Before triangles are needed as after: faces hand over what they have.
TEST_F(Pn_subdivide_crease_attributes, AreCarriedByTrianglesToo)
{
  const std::string input = folder.write("a.obj", box_obj(Given::none));
  for (const std::string scheme : {"loop", "modified-loop", "ct-loop"}) {
    const std::string options = "--triangulate --sharp angle:30 --scheme " + scheme;
    const std::string carried_by_pn = carried(input, options);
    expect_part(carried_by_pn, "smoothing_group");
    if (scheme != "ct-loop") {
      EXPECT_EQ(carried_by_pn, carried(input, options + " --linear")) << scheme;
    }
  }
}

// What the output cannot hold is named, creases or not.
TEST_F(Pn_subdivide_crease_attributes, WhatIsNotWrittenIsNamed)
{
  const std::string input = folder.write("a.obj", box_obj(Given::none));
  for (const std::string sharp : {"none", "angle:30"}) {
    const Outcome outcome = done(surface(input, "b.off", "--quiet --sharp " + sharp));
    expect_part(outcome.err, "not written, off files cannot hold it: texture coordinates");
  }
}

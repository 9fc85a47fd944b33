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

#include "io/formats.h"
#include "io/mesh_io.h"

#include <cmath>
#include <utility>

using namespace pn_subdivide;

namespace {

// A box of 2 x 1 x 1 quads, folded where its sides meet.
const Triple box_points[] = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0},
                             {0, 0, 1}, {1, 0, 1}, {2, 0, 1}, {0, 1, 1}, {1, 1, 1}, {2, 1, 1}};
const int box_faces[][4] = {{0, 3, 4, 1},  {1, 4, 5, 2}, {6, 7, 10, 9}, {7, 8, 11, 10},
                            {0, 1, 7, 6},  {1, 2, 8, 7}, {2, 5, 11, 8}, {5, 4, 10, 11},
                            {4, 3, 9, 10}, {3, 0, 6, 9}};

// that of the face's side
const Triple side_normals[] = {{0, 0, -1}, {0, 0, -1}, {0, 0, 1}, {0, 0, 1}, {0, -1, 0},
                               {0, -1, 0}, {1, 0, 0},  {0, 1, 0}, {0, 1, 0}, {-1, 0, 0}};

enum class Normals { none, of_vertices, of_corners };
enum class Texture { of_corners, of_vertices }; // a chart for each face, or none

// Numbers of every kind at vertices and faces, of which each format holds some; with `is_split` every face has vertices
// of its own.
Mesh_data box(Normals normals, Texture texture, bool is_split)
{
  Mesh_data mesh;
  Attributes& a = mesh.attributes;
  for (const char* const name : {"red", "green", "blue"})
    for (Columns* const columns : {&a.of_vertices, &a.of_faces})
      columns->push_back({name, Scalar_type::uint8, {}, {}});
  a.of_vertices.push_back({"quality", Scalar_type::float32, {}, {}});
  a.of_vertices.push_back({"id", Scalar_type::int32, {}, {}});
  a.of_faces.push_back({"group", Scalar_type::int32, {}, {"g0", "g1", "g2"}});
  a.of_faces.push_back({"material", Scalar_type::int32, {}, {"m0", "m1", "m2", "m3"}});
  a.of_faces.push_back({"smoothing_group", Scalar_type::int32, {}, {}});
  a.of_faces.push_back({"weight", Scalar_type::float64, {}, {}});
  a.texture_files = a.material_files = {"box"};
  const auto add_row = [](Columns& columns, const std::vector<double>& row) {
    for (std::size_t k = 0; k < row.size(); ++k) columns[k].values.push_back(row[k]);
  };
  const auto add_vertex = [&](int v) {
    const Triple& p = box_points[v];
    mesh.points.push_back(p);
    if (normals == Normals::of_vertices) mesh.normals.push_back({p[0] - 1, p[1] - 0.5, p[2] - 0.5});
    add_row(a.of_vertices, {20. * v, 7, 255, 0.1 * v, 10. * v});
  };
  for (int v = 0; v < 12 && !is_split; ++v) add_vertex(v);
  for (int f = 0; f < 10; ++f) {
    std::vector<int> face;
    for (const int v : box_faces[f]) {
      if (is_split) add_vertex(v);
      face.push_back(is_split ? int(mesh.points.size()) - 1 : v);
      const double corner = texture == Texture::of_corners ? double(a.texture.size()) : 0.1 * v;
      a.texture.push_back({corner, std::fmod(corner * corner, 7), 0});
      if (normals == Normals::of_corners) mesh.corner_normals.push_back(side_normals[f]);
    }
    mesh.add_face(face);
    add_row(a.of_faces, {10. * f, 3, 200, f % 3 * 1., f % 4 * 1., f % 2 * 1., 0.1 * f});
  }
  if (normals == Normals::of_corners) mesh.normals.assign(mesh.points.size(), Triple{0, 0, 0});
  if (is_split) move_texture_to_vertices(mesh); // where vertices are merged these make seams
  return mesh;
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
  std::string written(const std::string& name, Normals normals = Normals::none,
                      Texture texture = Texture::of_corners, bool is_split = false) const
  {
    write_mesh(folder.file(name), box(normals, texture, is_split), Encoding::text);
    return folder.file(name);
  }

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
    std::string name;
    Normals normals;
    bool is_split;
  } files[] = {{"plain.obj", Normals::none, false},
               {"vertices.obj", Normals::of_vertices, false},
               {"corners.obj", Normals::of_corners, false},
               {"plain.ply", Normals::none, false},
               {"vertices.ply", Normals::of_vertices, false},
               {"split.ply", Normals::none, true},
               {"split_vertices.ply", Normals::of_vertices, true},
               {"plain.off", Normals::none, false},
               {"vertices.off", Normals::of_vertices, false}};
  std::size_t compared = 0, offset = 0;
  for (const auto& file : files) {
    const std::string input = written(
      file.name, file.normals,
      contains(file.name, ".off") ? Texture::of_vertices : Texture::of_corners, file.is_split);
    std::vector<std::string> sharp = {"none", "auto", "angle:30",
                                      "'" + (file.is_split ? split_selection : selection) + "'"};
    if (file.normals == Normals::of_corners) sharp.emplace_back("file");
    std::vector<std::string> normals = {"auto", "estimate",         "angle",
                                        "none", "sphere:1,0.5,0.5", "cylinder:0,0.5,0.5,1,0,0"};
    if (file.normals != Normals::none) normals.emplace_back("file");
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
  for (const std::string name : {"a.obj", "b.ply", "c.off"}) {
    const Mesh_data mesh = read_mesh(written(name));
    const std::string input = folder.file("with_types.ply"); // those of a PLY file stay
    write_mesh(input, mesh, Encoding::binary);
    EXPECT_EQ(carried(input, "--levels 0 --sharp angle:30"), all_of(mesh)) << name;
  }
}

// Before triangles are needed as after: faces hand over what they have.
TEST_F(Pn_subdivide_crease_attributes, AreCarriedByTrianglesToo)
{
  const std::string input = written("a.obj");
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
  const std::string input = written("a.obj");
  for (const std::string sharp : {"none", "angle:30"}) {
    const Outcome outcome = done(surface(input, "b.off", "--quiet --sharp " + sharp));
    expect_part(outcome.err, "not written, off files cannot hold it: texture coordinates");
  }
}

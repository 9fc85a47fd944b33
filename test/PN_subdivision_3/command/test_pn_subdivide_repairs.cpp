// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// --repair turns closed components outwards, and cavities the other way.

#include "Refined_files.h"

#include "io/mesh_io.h"
#include "io/soup_repair.h"

using namespace pn_subdivide;

namespace {

// A mesh of several components, each with the volume that it is to have.
struct Bodies
{
  Mesh_data mesh;
  std::vector<int> signs;
  std::vector<std::size_t> end; // of the faces of each

  void add(const Part& body, int sign, bool is_turned)
  {
    const std::size_t first = mesh.points.size();
    mesh.points.insert(mesh.points.end(), body.points.begin(), body.points.end());
    for (std::vector<std::size_t> face : body.faces) {
      for (std::size_t& v : face) v += first;
      if (is_turned) std::reverse(face.begin(), face.end());
      mesh.add_face(face);
    }
    signs.push_back(sign);
    end.push_back(mesh.number_of_faces());
  }

  // outwards, if it is not turned; pentagonal prisms, their sides quads
  void add_prism(const Triple& center, double size, int sign, bool is_turned)
  {
    std::vector<Triple> corners;
    const double turn = std::acos(-1.) * 2 / 5;
    for (int i = 0; i < 5; ++i)
      corners.push_back(sum(center, {std::cos(turn * i), std::sin(turn * i), -1}, size));
    add(prism(corners, center[2] + size), sign, is_turned);
  }

  void add_tetrahedron(const Triple& center, double size, int sign, bool is_turned)
  {
    Part body{{{-1, -1, -1}, {1, -1, -1}, {0, 1, -1}, {0, 0, 1}},
              {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
    for (Triple& p : body.points) p = sum(center, p, size);
    add(body, sign, is_turned);
  }
};

void expect_signs(const Bodies& bodies, const Mesh_data& mesh)
{
  ASSERT_EQ(mesh.number_of_faces(), bodies.end.back());
  std::size_t begin = 0;
  for (std::size_t i = 0; i < bodies.end.size(); ++i) {
    EXPECT_GT(volume(mesh, begin, bodies.end[i]) * bodies.signs[i], 0) << "component " << i;
    begin = bodies.end[i];
  }
}

// Every combination of turned components: side by side, in each other three deep, and with two bodies in one cavity.
Bodies nested(unsigned turned)
{
  Bodies b;
  const auto is_turned = [&turned] { return (turned & 1u) != 0; };
  const auto next = [&turned] { turned >>= 1u; };
  b.add_prism({0, 0, 0}, 10, 1, is_turned());
  next();
  b.add_prism({0, 0, 0.5}, 6, -1, is_turned());
  next();
  b.add_tetrahedron({2, 0, 0}, 1.5, 1, is_turned());
  next();
  b.add_prism({-2, 0, 0}, 1.5, 1, is_turned());
  next();
  b.add_tetrahedron({-2, 0, 0}, 0.3, -1, is_turned());
  next();
  b.add_tetrahedron({30, 0, 0}, 4, 1, is_turned()); // its box, but not it, holds the next
  next();
  b.add_tetrahedron({33.4, -3.4, 3}, 0.4, 1, is_turned());
  return b;
}

class Pn_subdivide_repairs : public Command_test
{};

} // namespace

TEST(Soup_repair_outwards, EveryNestingFromEveryOrientation)
{
  for (unsigned turned = 0; turned < 128; ++turned) {
    const Bodies bodies = nested(turned);
    Mesh_data mesh = bodies.mesh;
    const Soup_repair repair = repair_soup(mesh);
    expect_signs(bodies, mesh);
    std::size_t wrong = 0, begin = 0;
    for (std::size_t i = 0; i < bodies.end.size(); ++i) {
      wrong += volume(bodies.mesh, begin, bodies.end[i]) * bodies.signs[i] < 0;
      begin = bodies.end[i];
    }
    EXPECT_EQ(repair.turned_components, wrong);
    EXPECT_EQ(repair.changed_anything(), wrong > 0);
    EXPECT_FALSE(repair_soup(mesh).changed_anything()) << "once more";
    EXPECT_EQ(mesh.points, bodies.mesh.points);
  }
}

// Without a repair bodies are told of that are inside out, and no cavities, however these are oriented.
TEST(Soup_repair_outwards, BodiesInsideOutAreFound)
{
  for (unsigned turned = 0; turned < 128; ++turned) {
    const Bodies bodies = nested(turned);
    std::size_t number = 0, first_face = 0, begin = 0;
    for (std::size_t i = 0; i < bodies.end.size(); ++i) {
      if (bodies.signs[i] > 0 && volume(bodies.mesh, begin, bodies.end[i]) < 0 && ++number == 1)
        first_face = begin;
      begin = bodies.end[i];
    }
    const Inside_out found = find_inside_out(bodies.mesh);
    EXPECT_EQ(found.number, number) << turned;
    EXPECT_EQ(found.first_face, first_face) << turned;
  }
}

// Single faces that are turned are set right first, whichever way.
TEST(Soup_repair_outwards, FromFacesWithoutOrder)
{
  for (unsigned seed = 1; seed < 40; ++seed) {
    const Bodies bodies = nested(0);
    Mesh_data mesh = bodies.mesh;
    std::vector<std::vector<Mesh_data::Index>> faces;
    for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
      faces.emplace_back(mesh.face(f).begin(), mesh.face(f).end());
      if ((seed * (f + 3) * 2654435761u >> 7u) % 3 == 0)
        std::reverse(faces.back().begin(), faces.back().end());
    }
    mesh.clear_faces();
    for (const auto& face : faces) mesh.add_face(face);
    const Mesh_data before = mesh;
    const Soup_repair repair = repair_soup(mesh);
    expect_signs(bodies, mesh);
    std::size_t turned = 0; // in the end
    for (std::size_t f = 0; f < faces.size(); ++f) {
      const std::vector<Mesh_data::Index> now(mesh.face(f).begin(), mesh.face(f).end());
      const auto next_of = [](const std::vector<Mesh_data::Index>& face, Mesh_data::Index v) {
        const auto i = std::find(face.begin(), face.end(), v) - face.begin();
        return face[std::size_t(i + 1) % face.size()];
      };
      turned += next_of(now, now[0]) != next_of(faces[f], now[0]);
    }
    EXPECT_EQ(repair.reversed_faces, turned);
  }
}

// At any scale, and wherever it is.
TEST(Soup_repair_outwards, AtEveryScale)
{
  for (const int exponent : {-300, -100, 0, 100, 300}) {
    const Bodies bodies = nested(0x55);
    Mesh_data mesh = bodies.mesh;
    for (Triple& p : mesh.points)
      for (double& x : p) x = std::ldexp(x, exponent);
    EXPECT_EQ(repair_soup(mesh).turned_components, 4u) << exponent;
  }
}

TEST(Soup_repair_outwards, ComponentsThatCrossOrTouchAreOutside)
{
  for (const bool first : {false, true})
    for (const bool second : {false, true}) {
      Bodies crossing;
      crossing.add_prism({0, 0, 0}, 2, 1, first);
      crossing.add_prism({1, 0, 0.3}, 1.5, 1, second);
      repair_soup(crossing.mesh);
      expect_signs(crossing, crossing.mesh);
      Bodies equal; // the same twice, with vertices of its own
      equal.add_prism({0, 0, 0}, 2, 1, first);
      equal.add_prism({0, 0, 0}, 2, 1, second);
      repair_soup(equal.mesh);
      expect_signs(equal, equal.mesh);
    }
}

// A component that crosses itself is turned by what most of it is: here a prism with one dent through its other side.
TEST(Soup_repair_outwards, ComponentsThatCrossThemselves)
{
  for (const bool is_turned : {false, true}) {
    Bodies bodies;
    bodies.add_prism({0, 0, 0}, 2, 1, is_turned);
    // a pyramid on the upper side, pointing down through the lower one
    Mesh_data mesh;
    mesh.points = bodies.mesh.points;
    mesh.points.push_back({0, 0, -2.5});
    std::vector<Mesh_data::Index> top;
    for (std::size_t f = 0; f < bodies.mesh.number_of_faces(); ++f)
      if (f != 1)
        mesh.add_face(bodies.mesh.face(f));
      else
        top.assign(bodies.mesh.face(f).begin(), bodies.mesh.face(f).end());
    for (std::size_t i = 0; i < 5; ++i)
      mesh.add_face(std::vector<Mesh_data::Index>{top[i], top[(i + 1) % 5], 10});
    const double before = volume(mesh);
    EXPECT_EQ(before > 0, !is_turned);
    repair_soup(mesh);
    EXPECT_GT(volume(mesh), 0);
  }
}

// Surfaces with a border, and what bounds nothing, stay as they are.
TEST(Soup_repair_outwards, OpenAndFlatOnesStay)
{
  for (const bool is_turned : {false, true}) {
    Bodies b;
    b.add({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}}}, 0,
          is_turned); // a side is missing
    b.add({{{5, 0, 0}, {6, 0, 0}, {5, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}}, 0, is_turned);
    EXPECT_FALSE(repair_soup(b.mesh).changed_anything());
    EXPECT_EQ(find_inside_out(b.mesh).number, 0u);
  }
}

// What belongs to corners and faces goes along.
TEST(Soup_repair_outwards, AttributesGoAlong)
{
  Bodies b;
  b.add_prism({0, 0, 0}, 2, 1, true);
  Mesh_data& mesh = b.mesh;
  mesh.attributes.of_faces.push_back({"id", Scalar_type::int32, {}, {}});
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
    mesh.attributes.of_faces[0].values.push_back(double(f));
    for (const Mesh_data::Index v : mesh.face(f)) {
      mesh.attributes.texture.push_back({double(f), double(v), 0});
      mesh.corner_normals.push_back({double(f), double(v), 1});
    }
  }
  mesh.normals.assign(mesh.points.size(), Triple{0, 0, 1});
  EXPECT_EQ(repair_soup(mesh).turned_components, 1u);
  std::size_t corner = 0;
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    for (const Mesh_data::Index v : mesh.face(f)) {
      EXPECT_EQ(mesh.attributes.of_faces[0].values[f], double(f));
      EXPECT_EQ(mesh.attributes.texture[corner], (Texture_point{double(f), double(v), 0}));
      EXPECT_EQ(mesh.corner_normals[corner], (Triple{double(f), double(v), 1}));
      ++corner;
    }
}

TEST_F(Pn_subdivide_repairs, ComponentsFromFilesOfEveryFormat)
{
  const Bodies bodies = nested(0x2d);
  for (const std::string format : {"off", "ply", "obj"}) {
    const std::string input = folder.file("a." + format), output = folder.file("b.off");
    write_mesh(input, bodies.mesh, Encoding::binary);
    const Outcome outcome = done(surface(input, output, "--levels 0 --repair --quiet"));
    expect_part(outcome.err, " 6 closed components turned right side out");
    expect_signs(bodies, read_mesh(output));
    EXPECT_EQ(surface(output, "c.off", "--levels 0 --repair --quiet").err, "");
  }
}

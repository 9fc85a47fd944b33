// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Meshes of all types: polyhedra, exact points, borders, components, no faces, points that are no numbers; normals of corners.

#include "Part_marks.h"
#include "Trap_parts.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/property_map/property_map.hpp>

#include <gtest/gtest.h>

using namespace synthetic_parts;
namespace PN = CGAL::PN_subdivision_3;
using Recognized_kind = Recognized_surface::Kind;
using Exact_kernel = CGAL::Exact_predicates_exact_constructions_kernel;

namespace {

std::string marks(const Part& part, const Recognition& r)
{
  return Part_marks(part, r).text();
}

// without the faces of a surface
Part without(Part part, std::size_t surface)
{
  std::vector<std::vector<std::size_t>> faces;
  std::vector<std::size_t> surfaces;
  for (std::size_t f = 0; f < part.faces.size(); ++f)
    if (part.surface_of_face[f] != surface) {
      faces.push_back(part.faces[f]);
      surfaces.push_back(part.surface_of_face[f]);
    }
  part.faces = faces;
  part.surface_of_face = surfaces;
  return part;
}

// two parts side by side
Part together(const Part& a, Part b)
{
  Part part = a;
  Pose pose;
  pose.shift = {5, 0.5, 0.25};
  place(b, pose);
  part.points.insert(part.points.end(), b.points.begin(), b.points.end());
  for (std::size_t f = 0; f < b.faces.size(); ++f) {
    for (std::size_t& v : b.faces[f]) v += a.points.size();
    part.faces.push_back(b.faces[f]);
    part.surface_of_face.push_back(b.surface_of_face[f] + a.surfaces.size());
  }
  part.surfaces.insert(part.surfaces.end(), b.surfaces.begin(), b.surfaces.end());
  return part;
}

std::vector<Part> parts()
{
  Random random(41);
  return {bolt(8, 24), rounded_box({3, 2, 1.5}, 0.3, steps(4), steps(4), random), shaft(24, 6)};
}

TEST(Recognize_meshes, exact_points)
{
  for (const Part& part : parts()) {
    auto mesh = mesh_of<CGAL::Surface_mesh<Exact_kernel::Point_3>>(part);
    EXPECT_EQ(marks(part, recognition_of(mesh, CGAL::parameters::default_values())), "");
  }
}

TEST(Recognize_meshes, floats)
{
  using Float_mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<float>::Point_3>;
  for (Part part : parts()) {
    write_as(part, File::single);
    auto mesh = mesh_of<Float_mesh>(part);
    EXPECT_EQ(marks(part, recognition_of(mesh, CGAL::parameters::default_values())), "");
  }
}

TEST(Recognize_meshes, polyhedra)
{
  using Polyhedron = CGAL::Polyhedron_3<CGAL::Exact_predicates_inexact_constructions_kernel>;
  using Face = boost::graph_traits<Polyhedron>::face_descriptor;
  using Edge = boost::graph_traits<Polyhedron>::edge_descriptor;
  for (const Part& part : parts()) {
    const Mesh mesh = mesh_of<Mesh>(part);
    Polyhedron polyhedron;
    std::map<Face, int> numbers;
    std::map<Edge, bool> sharp;
    CGAL::copy_face_graph(mesh, polyhedron);
    const auto patches = boost::make_assoc_property_map(numbers);
    Recognition r;
    r.surfaces = PN::recognize_surfaces(polyhedron, patches);
    r.number_of_creases =
      PN::surface_creases(polyhedron, patches, r.surfaces, boost::make_assoc_property_map(sharp));
    for (const Face f : faces(polyhedron))
      r.segment_of_face.push_back(static_cast<std::size_t>(numbers.at(f)));
    EXPECT_EQ(numbers.size(), part.faces.size());
    for (const auto& [e, is_sharp] : sharp)
      if (is_sharp) ++r.number_of_creases;
    EXPECT_EQ(r.number_of_creases % 2, 0u);
    r.number_of_creases /= 2; // as returned and as in the map
    const Recognition expected = recognition_of(part);
    EXPECT_EQ(r.segment_of_face, expected.segment_of_face);
    EXPECT_EQ(r.number_of_creases, expected.number_of_creases);
  }
}

TEST(Recognize_meshes, other_point_map)
{
  const Part part = bolt(8, 24);
  Mesh mesh = mesh_of<Mesh>(part);
  auto points = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_3>("v:other").first;
  for (const auto v : mesh.vertices()) {
    points[v] = mesh.point(v);
    mesh.point(v) = Kernel::Point_3(0, 0, 0);
  }
  EXPECT_EQ(marks(part, recognition_of(mesh, CGAL::parameters::vertex_point_map(points))), "");
}

// What is missing makes no difference to what is there.
TEST(Recognize_meshes, borders)
{
  for (const Part& part : {bolt(6, 24), shaft(24, 6)})
    for (std::size_t s = 0; s < part.surfaces.size(); ++s) {
      const Part open = without(part, s);
      Mesh mesh = mesh_of<Mesh>(open);
      const Recognition r = recognition_of(mesh, CGAL::parameters::default_values());
      for (std::size_t f = 0; f < open.faces.size(); ++f) {
        const auto& found = r.surfaces.at(r.segment_of_face[f]);
        const True_surface& t = open.surfaces[open.surface_of_face[f]];
        ASSERT_EQ(found.kind, recognized(t.kind)) << part.name << " without " << s;
      }
      EXPECT_EQ(r.surfaces.size(), part.surfaces.size() - 1) << part.name << " without " << s;
    }
}

TEST(Recognize_meshes, components)
{
  const Part part = together(bolt(6, 24), regular_prism(5));
  EXPECT_EQ(marks(part, recognition_of(part)), "");
}

TEST(Recognize_meshes, empty)
{
  Mesh mesh;
  const Recognition r = recognition_of(mesh, CGAL::parameters::default_values());
  EXPECT_TRUE(r.surfaces.empty());
  EXPECT_EQ(r.number_of_creases, 0u);
}

TEST(Recognize_meshes, one_face)
{
  Mesh mesh;
  const auto a = mesh.add_vertex({0, 0, 0}), b = mesh.add_vertex({1, 0, 0}),
             c = mesh.add_vertex({0, 1, 0});
  mesh.add_face(a, b, c);
  const Recognition r = recognition_of(mesh, CGAL::parameters::default_values());
  ASSERT_EQ(r.surfaces.size(), 1u);
  EXPECT_EQ(r.surfaces[0].kind, Recognized_kind::plane);
  EXPECT_NEAR(r.surfaces[0].direction[2], 1, 1e-12);
  EXPECT_EQ(r.number_of_creases, 0u);
}

TEST(Recognize_meshes, all_points_in_one_place)
{
  Part part = bolt(6, 12);
  for (Vec& p : part.points) p = {1, 2, 3};
  const Recognition r = recognition_of(part);
  EXPECT_FALSE(r.surfaces.empty());
  for (std::size_t s : r.segment_of_face) EXPECT_LT(s, r.surfaces.size());
}

TEST(Recognize_meshes, points_that_are_no_numbers)
{
  const Part part = bolt(6, 12);
  for (double x :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    Mesh mesh = mesh_of<Mesh>(part);
    const auto patches = mesh.add_property_map<Mesh::Face_index, int>("f:p", -7).first;
    mesh.point(Mesh::Vertex_index(5)) = Kernel::Point_3(0, x, 0);
    try {
      PN::recognize_surfaces(mesh, patches);
      ADD_FAILURE();
    } catch (const std::invalid_argument& e) {
      EXPECT_NE(std::string(e.what()).find("PN_subdivision_3"), std::string::npos);
      EXPECT_NE(std::string(e.what()).find('5'), std::string::npos) << e.what();
    }
    for (const auto f : mesh.faces()) EXPECT_EQ(patches[f], -7);
  }
}

TEST(Recognize_meshes, parameters_that_make_no_sense)
{
  Mesh mesh = mesh_of<Mesh>(bolt(6, 12));
  const auto patches = mesh.add_property_map<Mesh::Face_index, int>("f:p", -7).first;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(PN::recognize_surfaces(mesh, patches, PN::parameters::surface_tolerance(-1.)),
               std::invalid_argument);
  EXPECT_THROW(PN::recognize_surfaces(mesh, patches, PN::parameters::surface_tolerance(nan)),
               std::invalid_argument);
  EXPECT_THROW(PN::recognize_surfaces(mesh, patches, PN::parameters::min_facets(2)),
               std::invalid_argument);
  for (const auto f : mesh.faces()) EXPECT_EQ(patches[f], -7);
}

// of a surface at a point of it, outward or inward; 0 at the apex
Vec normal_of(const True_surface& s, const Vec& p)
{
  const Vec d = p - s.point;
  const double z = dot(d, s.direction);
  const Vec across = d - z * s.direction;
  switch (s.kind) {
  case Kind::plane:
    return s.direction;
  case Kind::sphere:
    return unit(d);
  case Kind::cylinder:
    return unit(across);
  case Kind::torus:
    return unit(d - s.radius * unit(across));
  case Kind::cone:
    if (length(d) < 1e-9) return {0, 0, 0};
    return unit(std::cos(s.half_angle) * unit(across) -
                (z > 0 ? 1 : -1) * std::sin(s.half_angle) * s.direction);
  }
  return {};
}

// of the faces at a vertex that are on a surface, by area
Vec side_of(const Part& part, std::size_t face)
{
  Vec n{};
  const auto& f = part.faces[face];
  for (std::size_t i = 2; i < f.size(); ++i)
    n = n + cross(part.points[f[i - 1]] - part.points[f[0]], part.points[f[i]] - part.points[f[0]]);
  return n;
}

TEST(Recognize_meshes, apexes_of_cones_are_corners)
{
  Mesh mesh;
  CGAL::make_pyramid(12, mesh, Kernel::Point_3(0, 0, 0), 2., 1., true);
  const auto patches = mesh.add_property_map<Mesh::Face_index, int>("f:p").first;
  const auto creases = mesh.add_property_map<Mesh::Edge_index, bool>("e:c").first;
  const auto corners = mesh.add_property_map<Mesh::Vertex_index, bool>("v:c", true).first;
  const auto surfaces = PN::recognize_surfaces(mesh, patches);
  ASSERT_EQ(surfaces.size(), 2u);
  EXPECT_EQ(PN::surface_creases(mesh, patches, surfaces, creases,
                                CGAL::parameters::vertex_is_constrained_map(corners)),
            12u);
  std::size_t number = 0;
  for (const auto v : mesh.vertices()) number += corners[v];
  EXPECT_EQ(number, 1u);
  for (const auto v : mesh.vertices()) EXPECT_EQ(corners[v], mesh.point(v).y() > 1) << v;
}

TEST(Recognize_meshes, corner_normals)
{
  Random random(42);
  std::vector<Part> all = parts();
  all.push_back(elbow(steps(16), steps(4), 90, 0.2, random));
  all.push_back(plate_with_drilled_hole(24));
  for (const Part& part : all) {
    Mesh mesh = mesh_of<Mesh>(part);
    const auto patches = mesh.add_property_map<Mesh::Face_index, int>("f:p").first;
    const auto normals = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Vector_3>("h:n").first;
    const auto surfaces = PN::recognize_surfaces(mesh, patches);
    const auto creases = mesh.add_property_map<Mesh::Edge_index, bool>("e:c").first;
    PN::surface_creases(mesh, patches, surfaces, creases,
                        CGAL::parameters::vertex_normal_map(normals));
    for (const auto f : mesh.faces())
      for (const auto h : CGAL::halfedges_around_face(mesh.halfedge(f), mesh)) {
        const True_surface& s = part.surfaces[part.surface_of_face[f]];
        const Vec n{normals[h].x(), normals[h].y(), normals[h].z()};
        Vec expected = normal_of(s, part.points[mesh.target(h)]);
        if (dot(expected, side_of(part, f)) < 0) expected = -1 * expected;
        ASSERT_LT(length(n - expected), 1e-7)
          << part.name << ", " << name_of(s.kind) << ", vertex " << mesh.target(h);
      }
  }
}

} // namespace

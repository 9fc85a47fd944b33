// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Files in and out of a program: what a file says arrives at its elements, what it does not say is estimated, a file between two
// calls is as none, and what is wrong is refused by name.

#include "Messages.h"
#include "Temporary_folder.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/PN_subdivision_3/control_mesh_io.h>
#include <CGAL/PN_subdivision_3/estimate_control_normals.h>
#include <CGAL/PN_subdivision_3/parameters/parameters.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
#include <CGAL/PN_subdivision_3/subdivide.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>

namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Edge = Mesh::Edge_index;

// a pyramid of four sides, without its base
constexpr const char* points[] = {"1 0 0", "0 1 0", "-1 0 0", "0 -1 0", "0 0 1"};
constexpr const char* sides = "3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n";

std::string ply(const std::string& of_vertices, const std::vector<std::string>& columns,
                const std::string& faces = sides, const std::string& edges = "",
                const std::string& edge_lines = "")
{
  std::ostringstream text;
  text << "ply\nformat ascii 1.0\n" << (of_vertices[0] == 'c' ? of_vertices : "");
  text << "element vertex " << columns.size()
       << "\nproperty float x\nproperty float y\nproperty float z\n";
  text << (of_vertices[0] == 'c' ? "property float nx\nproperty float ny\nproperty float nz\n"
                                 : of_vertices);
  text << "element face " << std::count(faces.begin(), faces.end(), '\n')
       << "\nproperty list uchar int vertex_indices\n"
       << edges << "end_header\n";
  for (std::size_t i = 0; i < columns.size(); ++i)
    text << points[i % 5] << ' ' << columns[i] << '\n';
  text << faces << edge_lines;
  return text.str();
}
const std::string normal_properties = "property float nx\nproperty float ny\nproperty float nz\n";
const std::string edge_properties =
  "element edge 2\nproperty int vertex1\nproperty int vertex2\nproperty float sharpness\n";
const std::vector<std::string> nothing(5);

std::string off(const std::string& faces, int number_of_faces)
{
  std::string text = "OFF\n5 " + std::to_string(number_of_faces) + " 0\n";
  for (const char* point : points) text += std::string(point) + '\n';
  return text + faces;
}

Edge edge_of(const Mesh& mesh, unsigned a, unsigned b)
{
  return mesh.edge(mesh.halfedge(Vertex(a), Vertex(b)));
}

TEST(Control_mesh_io, What_a_file_says_arrives_at_its_elements)
{
  const Temporary_folder folder;
  const std::string file = folder.write(
    "a.ply", ply(normal_properties + "property double roundness\nproperty uchar sharpness\n",
                 {"1 0 0 0.5 0", "0 1 0 0.25 0", "-1 0 0 0 7", "0 -1 0 1 0", "0 0 1 0.75 0"}, sides,
                 edge_properties, "1 4 2.5\n0 3 1\n"));
  Mesh mesh;
  const auto sharp = mesh.add_property_map<Edge, double>("e:sharp", -1).first;
  const auto corners = mesh.add_property_map<Vertex, int>("v:corner", -1).first;
  PN::read_control_mesh(file, mesh,
                        params::edge_is_constrained_map(sharp).vertex_is_constrained_map(corners));
  ASSERT_EQ(mesh.number_of_vertices(), 5u);
  ASSERT_EQ(mesh.number_of_faces(), 4u);
  for (const Edge e : mesh.edges())
    EXPECT_EQ(sharp[e], e == edge_of(mesh, 1, 4) ? 2.5 : e == edge_of(mesh, 0, 3) ? 1 : 0);
  for (const Vertex v : mesh.vertices()) EXPECT_EQ(corners[v], v == Vertex(2) ? 7 : 0);

  Mesh smooth;
  const auto normals = PN::read_control_mesh(file, smooth);
  const double roundness[] = {0.5, 0.25, 0, 1, 0.75};
  for (const Vertex v : smooth.vertices()) {
    EXPECT_EQ(smooth.point(v), mesh.point(v));
    EXPECT_EQ(normals[v], smooth.point(v) - CGAL::ORIGIN);
    EXPECT_EQ(get(normals.roundness_map(), v), roundness[v]);
  }
}

// Of a vertex between wedges the file has one normal for all of them: these are estimated, with the creases.
TEST(Control_mesh_io, Normals_of_corners_are_the_files_where_a_vertex_has_one)
{
  const Temporary_folder folder;
  const std::vector<std::string> up(5, "0 0 1");
  const std::string file =
    folder.write("a.ply", ply(normal_properties, up, sides, edge_properties, "1 4 9\n4 3 9\n"));
  Mesh mesh;
  const auto sharp = mesh.add_property_map<Edge, bool>("e:sharp", true).first;
  const auto normals = PN::read_control_mesh(file, mesh, params::edge_is_constrained_map(sharp));
  const auto estimate = PN::estimate_control_normals(mesh, params::edge_is_constrained_map(sharp));
  EXPECT_TRUE(sharp[edge_of(mesh, 1, 4)]);
  EXPECT_FALSE(sharp[edge_of(mesh, 0, 4)]);
  for (const auto h : mesh.halfedges())
    if (!mesh.is_border(h)) {
      const unsigned v = mesh.target(h);
      EXPECT_EQ(normals[h], v == 0 || v == 2 ? Vector(0, 0, 1) : estimate[h]) << v;
    }
  EXPECT_NE(normals[mesh.halfedge(Vertex(0), Vertex(4))],
            normals[mesh.halfedge(Vertex(2), Vertex(4))]);
}

TEST(Control_mesh_io, What_a_file_does_not_say_is_estimated)
{
  const Temporary_folder folder;
  const std::string of_mesh = // the normals of a viewer, by the command
    ply("comment normals of the mesh\n", std::vector<std::string>(5, "0 0 1"));
  for (const std::string& text : {ply("", nothing), of_mesh}) {
    Mesh read, expected;
    const auto normals = PN::read_control_mesh(folder.write("a.ply", text), read);
    PN::subdivide(read, PN::Loop_scheme(),
                  params::vertex_normal_map(normals).number_of_iterations(2));
    PN::read_control_mesh(folder.write("b.off", off(sides, 4)), expected);
    PN::subdivide(expected, PN::Loop_scheme(), params::number_of_iterations(2));
    for (const Vertex v : expected.vertices()) EXPECT_EQ(read.point(v), expected.point(v));
  }
}

template <class PolygonMesh>
std::vector<std::vector<double>> numbers(const PolygonMesh& mesh)
{
  std::vector<std::vector<double>> all;
  const auto points_of = get(CGAL::vertex_point, mesh);
  for (const auto v : vertices(mesh)) {
    const auto& p = get(points_of, v);
    all.push_back({CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())});
  }
  return all;
}

// but for last bits: edges, and so new vertices, have other numbers
template <class PolygonMesh>
void expect_same_points(const PolygonMesh& a, const PolygonMesh& b)
{
  const auto of_a = numbers(a), of_b = numbers(b);
  ASSERT_EQ(of_a.size(), of_b.size());
  for (const auto& p : of_a) {
    const auto is_near = [&p](const auto& q) {
      return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) < 1e-15;
    };
    EXPECT_EQ(std::count_if(of_b.begin(), of_b.end(), is_near), 1);
  }
}

// two rounds in one call, and two calls with a file between them
template <class PolygonMesh>
void expect_file_between_rounds_is_as_none(const std::string& start, const std::string& between)
{
  PolygonMesh whole, first, second;
  const auto rounds = [](unsigned n, const auto& normals) {
    return params::vertex_normal_map(normals).number_of_iterations(n);
  };
  PN::subdivide(whole, PN::CatmullClark_scheme(), rounds(2, PN::read_control_mesh(start, whole)));
  const auto normals = PN::read_control_mesh(start, first);
  PN::subdivide(first, PN::CatmullClark_scheme(), rounds(1, normals));
  PN::write_refined_mesh(between, first, params::vertex_normal_map(normals));
  PN::subdivide(second, PN::CatmullClark_scheme(),
                rounds(1, PN::read_control_mesh(between, second)));
  expect_same_points(second, whole);
}

TEST(Control_mesh_io, A_file_between_two_rounds_is_as_none)
{
  const Temporary_folder folder;
  const std::string start =
    folder.write("a.ply", ply(normal_properties + "property double roundness\n",
                              {"1 0 0 0.5", "0 1 0 0.25", "-1 0 0 0", "0 -1 0 1", "0 0 1 0.75"}));
  expect_file_between_rounds_is_as_none<Mesh>(start, folder.file("b.ply"));
  expect_file_between_rounds_is_as_none<CGAL::Polyhedron_3<Kernel>>(start, folder.file("b.ply"));
}

TEST(Control_mesh_io, Sharpness_that_is_left_is_written)
{
  const Temporary_folder folder;
  const std::string start =
    folder.write("a.ply", ply("property float sharpness\n", {"0", "0", "3", "0", "0"}, sides,
                              edge_properties, "1 4 2.5\n4 3 0.5\n"));
  Mesh mesh, again;
  const auto maps = [](Mesh& m) {
    return params::edge_is_constrained_map(m.add_property_map<Edge, double>("e:sharp").first)
      .vertex_is_constrained_map(m.add_property_map<Vertex, double>("v:sharp").first);
  };
  const auto np = maps(mesh);
  const auto normals = PN::read_control_mesh(start, mesh, np);
  PN::subdivide(mesh, PN::Loop_scheme(), np.vertex_normal_map(normals));
  PN::write_refined_mesh(folder.file("b.ply"), mesh, np.vertex_normal_map(normals));
  PN::read_control_mesh(folder.file("b.ply"), again, maps(again));
  const auto sharp = mesh.add_property_map<Edge, double>("e:sharp").first;
  const auto sharp_again = again.add_property_map<Edge, double>("e:sharp").first;
  double sum = 0;
  for (const Edge e : mesh.edges()) {
    const double s = sharp_again[edge_of(again, mesh.vertex(e, 0), mesh.vertex(e, 1))];
    EXPECT_EQ(s, sharp[e]);
    sum += s;
  }
  EXPECT_EQ(sum, 3); // 1.5 on both halves
  const auto corners = again.add_property_map<Vertex, double>("v:sharp").first;
  for (const Vertex v : again.vertices()) EXPECT_EQ(corners[v], v == Vertex(2) ? 2 : 0);
}

TEST(Control_mesh_io, Infinite_sharpness_and_exact_numbers)
{
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  using Exact_mesh = CGAL::Surface_mesh<Exact::Point_3>;
  const Temporary_folder folder;
  Exact_mesh mesh, again;
  PN::read_control_mesh(folder.write("a.ply", ply("", nothing)), mesh);
  const auto sharp = mesh.add_property_map<Exact_mesh::Edge_index, bool>("e:sharp", true).first;
  PN::write_refined_mesh(folder.file("b.ply"), mesh, params::edge_is_constrained_map(sharp));
  const auto sharp_again = again.add_property_map<Exact_mesh::Edge_index, double>("e:sharp").first;
  PN::read_control_mesh(folder.file("b.ply"), again, params::edge_is_constrained_map(sharp_again));
  EXPECT_EQ(numbers(again), numbers(mesh));
  for (const auto e : again.edges())
    EXPECT_EQ(sharp_again[e], std::numeric_limits<double>::infinity());
}

TEST(Control_mesh_io, Formats)
{
  const Temporary_folder folder;
  Mesh mesh;
  const auto normals = PN::read_control_mesh(folder.write("a.off", off(sides, 4)), mesh);
  for (const auto& v : mesh.vertices()) put(normals, v, mesh.point(v) - CGAL::ORIGIN);
  mesh.point(Vertex(4)) = Kernel::Point_3(0, 0.1, 1 / 3.);
  for (const std::string ending : {"off", "OFF", "ply", "obj", "stl"}) {
    Mesh again;
    const std::string file = folder.file("b." + ending);
    PN::write_refined_mesh(file, mesh, params::vertex_normal_map(normals));
    const auto read = PN::read_control_mesh(file, again);
    ASSERT_EQ(again.number_of_vertices(), 5u) << ending;
    EXPECT_EQ(again.number_of_faces(), 4u) << ending;
    if (ending == "stl") continue; // which has other numbers
    EXPECT_EQ(numbers(again), numbers(mesh)) << ending;
    if (ending == "obj") continue; // which has no normals
    for (const auto v : again.vertices()) EXPECT_EQ(read[v], normals[v]) << ending;
  }
  Mesh empty, empty_again;
  PN::write_refined_mesh(folder.file("c.ply"), empty);
  PN::read_control_mesh(folder.file("c.ply"), empty_again);
  EXPECT_TRUE(empty_again.is_empty());
}

TEST(Control_mesh_io, What_is_wrong_is_named_and_the_mesh_stays_empty)
{
  const Temporary_folder folder;
  Mesh mesh;
  const auto sharp = mesh.add_property_map<Edge, double>("e:sharp", 0).first;
  const auto read = [&](const std::string& name, const std::string& text) {
    const std::string file = folder.write(name, text);
    return [&mesh, sharp, file] {
      PN::read_control_mesh(file, mesh, params::edge_is_constrained_map(sharp));
    };
  };
  const auto with_edges = [](const std::string& lines) {
    return ply("", nothing, sides, edge_properties, lines);
  };
  const struct
  {
    std::string name, text, words;
  } cases[] = {
    {"a.ply", ply("", nothing, "3 0 1 9\n"), "a.ply: face 0 has a vertex that is not there"},
    {"b.ply", ply("", nothing, "3 0 1 4\n3 1 2 -4\n"), "face 1 has a vertex that is not there"},
    {"c.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 4\n", "face 1 has a vertex"},
    {"d.ply", ply("", nothing, "3 0 1 4\n4 1 2 4 2\n"), "face 1 has not three or more different"},
    {"e.off", off("3 0 1 4\n3 4 1 2\n3 0 1 2\n", 3), "face 2 does not fit"},
    {"f.ply", with_edges("1 3 1\n1 4 1\n"), "sharp edge from vertex 1 to vertex 3"},
    {"g.ply", with_edges("1 4 1\n77 4 1\n"), "sharp edge from vertex 4 to vertex 77"},
    {"h.ply", ply("", nothing, "3 0 1 4\n3 1\n"), "face 1 cannot be read"},
    {"i.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\nend_header\n1\n",
     "x, y and z"},
    {"j.ply", "solid\n", "header"},
    {"k.abc", "solid\n", "k.abc: CGAL's reader does not take it"},
  };
  for (const auto& c : cases) {
    messages::expect_refused<std::runtime_error>(read(c.name, c.text), {c.words});
    EXPECT_TRUE(mesh.is_empty()) << c.words;
  }
  messages::expect_refused(read("m.ply", with_edges("1 4 1\n0 4 -1\n")),
                           {"the edge from vertex 0 to vertex 4 is negative"});
  messages::expect_refused(read("n.off", off("3 0 1 4\n3 2 3 4\n", 2)), {"bow-tie"});
  Mesh nowhere; // refused by the estimate, when the mesh is there
  const std::array<Mesh::Vertex_index, 3> face{nowhere.add_vertex({0, 0, 0}),
                                               nowhere.add_vertex({1, 0, 0}),
                                               nowhere.add_vertex({0, std::nan(""), 0})};
  nowhere.add_face(face);
  PN::write_refined_mesh(folder.file("o.ply"), nowhere);
  messages::expect_refused([&] { PN::read_control_mesh(folder.file("o.ply"), mesh); },
                           {"vertex 2"});
  EXPECT_TRUE(mesh.is_empty());
  messages::expect_refused<std::runtime_error>(
    [&] { PN::read_control_mesh(folder.file("none.ply"), mesh); }, {"is not there"});
}

TEST(Control_mesh_io, What_cannot_be_written_or_is_not_empty_is_refused)
{
  const Temporary_folder folder;
  Mesh mesh;
  const std::string file = folder.write("a.off", off("4 0 1 2 3\n", 1));
  PN::read_control_mesh(file, mesh);
  messages::expect_refused([&] { PN::read_control_mesh(file, mesh); }, {"must be empty"});
  EXPECT_EQ(mesh.number_of_faces(), 1u);
  messages::expect_refused<std::runtime_error>(
    [&] { PN::write_refined_mesh(folder.file("b.stl"), mesh); }, {"triangles only"});
  for (const char* name : {"b.xyz", "no/b.ply", "no/b.off"})
    messages::expect_refused<std::runtime_error>(
      [&] { PN::write_refined_mesh(folder.file(name), mesh); }, {"cannot be written"});
}

} // namespace

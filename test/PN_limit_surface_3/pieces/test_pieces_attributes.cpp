// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
// Maps of attributes that pieces fill, against those that subdivide() fills.

#include <CGAL/IO/Color.h>
#include <CGAL/PN_limit_surface_3/refine_in_pieces.h>
#include <CGAL/PN_subdivision_3/attributes.h>
#include <CGAL/PN_subdivision_3/parameters/parameters.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/subdivide.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>

namespace {

namespace PN = CGAL::PN_subdivision_3;
namespace params = PN::parameters;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Texture = std::array<float, 2>;

// a mesh with maps of everything
struct Case
{
  Mesh mesh;
  Mesh::Property_map<Mesh::Vertex_index, double> heat = add<Mesh::Vertex_index, double>("heat");
  Mesh::Property_map<Mesh::Vertex_index, int> label = add<Mesh::Vertex_index, int>("label");
  Mesh::Property_map<Mesh::Vertex_index, CGAL::IO::Color> color =
    add<Mesh::Vertex_index, CGAL::IO::Color>("color");
  Mesh::Property_map<Mesh::Halfedge_index, Texture> texture =
    add<Mesh::Halfedge_index, Texture>("texture");
  Mesh::Property_map<Mesh::Edge_index, int> mark = add<Mesh::Edge_index, int>("mark");
  Mesh::Property_map<Mesh::Face_index, int> material = add<Mesh::Face_index, int>("material");
  Mesh::Property_map<Mesh::Face_index, std::size_t> parent =
    add<Mesh::Face_index, std::size_t>("parent");

  template <class Key, class T>
  Mesh::Property_map<Key, T> add(const char* name)
  {
    return mesh.add_property_map<Key, T>(name, T()).first;
  }

  auto attributes() const
  {
    return params::attributes(params::vertex_attribute(heat), params::edge_attribute(mark),
                              params::corner_attribute(texture), params::face_parents(parent),
                              params::vertex_attribute(color), params::face_attribute(material),
                              params::vertex_attribute(label));
  }

  // a patch whose texture has a seam in the middle
  void fill()
  {
    constexpr unsigned n = 6;
    for (unsigned i = 0; i < n * n + 2 * n + 1; ++i)
      mesh.add_vertex(Kernel::Point_3(i % (n + 1), i / (n + 1), 0.1 * (i * i % 7)));
    for (unsigned i = 0; i < n; ++i)
      for (unsigned j = 0; j < n; ++j) {
        const unsigned a = i * (n + 1) + j;
        const auto v = [](unsigned k) { return Mesh::Vertex_index(k); };
        mesh.add_face(v(a), v(a + 1), v(a + n + 2), v(a + n + 1));
      }
    for (auto v : mesh.vertices()) {
      label[v] = int(1000 - v.idx());
      heat[v] = 0.1 * double(v.idx() * v.idx() % 13);
      color[v] = CGAL::IO::Color(std::uint8_t(5 * v.idx()), std::uint8_t(255 - v.idx()), 7);
    }
    for (auto h : mesh.halfedges()) {
      const unsigned v = mesh.target(h);
      const bool is_right = !mesh.is_border(h) && mesh.face(h).idx() % n >= n / 2;
      texture[h] = {float(v % 7) + (is_right ? 9 : 0), float(v / 7)};
    }
    for (auto e : mesh.edges()) mark[e] = int(e.idx() % 5);
    for (auto f : mesh.faces()) material[f] = int(f.idx() * 3);
  }
};

TEST(Attributes_of_pieces, FillMaps)
{
  const auto scheme = PN::linear(PN::CatmullClark_scheme());
  Case whole, control;
  whole.fill();
  control.fill();
  PN::subdivide(whole.mesh, scheme,
                params::join(whole.attributes(), CGAL::parameters::number_of_iterations(2)));
  const PN::Surface_pieces pieces(
    control.mesh, scheme,
    params::join(control.attributes(), params::number_of_pieces(2).number_of_iterations(2)));
  std::size_t faces = 0, marks = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    const auto piece = pieces.piece(i);
    EXPECT_EQ(piece.attributes(), nullptr);
    Case part;
    piece.build_mesh(part.mesh, part.attributes());
    const auto whole_vertex = [&](auto v) {
      return Mesh::Vertex_index(Mesh::size_type(piece.vertex_number(v)));
    };
    for (auto v : part.mesh.vertices()) {
      EXPECT_EQ(part.heat[v], whole.heat[whole_vertex(v)]);
      EXPECT_EQ(part.color[v], whole.color[whole_vertex(v)]);
      EXPECT_EQ(part.label[v], whole.label[whole_vertex(v)]);
      EXPECT_GT(part.label[v], 1000 - 49); // of a control vertex
    }
    for (auto f : part.mesh.faces()) {
      const Mesh::Face_index g(Mesh::size_type(piece.face_number(f)));
      EXPECT_EQ(part.material[f], whole.material[g]);
      EXPECT_EQ(part.parent[f], whole.parent[g]);
      auto k = whole.mesh.halfedge(g);
      for (auto h : halfedges_around_face(part.mesh.halfedge(f), part.mesh)) {
        EXPECT_EQ(whole_vertex(part.mesh.target(h)), whole.mesh.target(k));
        EXPECT_EQ(part.texture[h], whole.texture[k]);
        EXPECT_EQ(part.mark[part.mesh.edge(h)], whole.mark[whole.mesh.edge(k)]);
        marks += part.mark[part.mesh.edge(h)] != 0;
        k = whole.mesh.next(k);
      }
      ++faces;
    }
  }
  EXPECT_EQ(faces, whole.mesh.number_of_faces());
  EXPECT_GT(marks, 0u);
  EXPECT_EQ(control.mesh.number_of_faces(), 36u); // is as it was
}

TEST(Attributes_of_pieces, OthersThanThoseThatWereReadAreRefused)
{
  Case control;
  control.fill();
  const PN::Surface_pieces pieces(
    control.mesh, PN::linear(PN::CatmullClark_scheme()),
    params::join(control.attributes(), CGAL::parameters::number_of_iterations(1)));
  Case part;
  const auto piece = pieces.piece(0);
  EXPECT_THROW(piece.build_mesh(part.mesh, params::attributes(params::vertex_attribute(part.heat))),
               std::invalid_argument);
  EXPECT_EQ(part.mesh.number_of_vertices(), 0u);
}

// Without rounds values stay what they are.
TEST(Attributes_of_pieces, WithoutARound)
{
  Case control;
  control.fill();
  const PN::Surface_pieces pieces(
    control.mesh, PN::linear(PN::CatmullClark_scheme()),
    params::join(control.attributes(), CGAL::parameters::number_of_iterations(0)));
  Case part;
  pieces.piece(0).build_mesh(part.mesh, part.attributes());
  for (auto f : part.mesh.faces()) {
    auto k = control.mesh.halfedge(f);
    for (auto h : halfedges_around_face(part.mesh.halfedge(f), part.mesh)) {
      EXPECT_EQ(part.texture[h], control.texture[k]);
      k = control.mesh.next(k);
    }
  }
}

} // namespace

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVISION_3_TEST_TESSELLATION_PIECE_CASES_H
#define PN_SUBDIVISION_3_TEST_TESSELLATION_PIECE_CASES_H

#include <CGAL/PN_limit_surface_3/internal/tessellation/tessellate_in_pieces.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <utility>
#include <vector>

// Tessellations in pieces: the vertices and triangles of the whole, to the last bit, each once.
namespace tessellation_piece_cases {

namespace PN = CGAL::PN_subdivision_3;
using Vector = PN::internal::flatness::Vector;
using Bits = std::vector<std::uint64_t>;

template <class Values>
void append(Bits& bits, const Values& values)
{
  for (const double x : values) {
    bits.emplace_back();
    std::memcpy(&bits.back(), &x, sizeof x);
  }
}

inline Bits triangle_of(std::array<Bits, 3> corners)
{
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  Bits all;
  for (const Bits& c : corners) all.insert(all.end(), c.begin(), c.end());
  return all;
}

struct Content
{
  std::vector<Bits> vertices, triangles;
  void sort_triangles() { std::sort(triangles.begin(), triangles.end()); }
};

struct Whole : Content
{
  PN::Tessellation_result result;

  template <class Mesh, class Scheme, class NamedParameters>
  Whole(const Mesh& control, const Scheme& scheme, double eps, const NamedParameters& np,
        bool has_normals)
  {
    using Kernel = CGAL::Simple_cartesian<double>;
    CGAL::Surface_mesh<Kernel::Point_3> out;
    const auto normals =
      out.template add_property_map<typename decltype(out)::Vertex_index, Kernel::Vector_3>("v:n")
        .first;
    result =
      PN::tessellate(control, scheme, eps, out, np, CGAL::parameters::vertex_normal_map(normals));
    for (auto v : out.vertices()) {
      const auto p = out.point(v);
      vertices.emplace_back();
      append(vertices.back(), std::array<double, 3>{p.x(), p.y(), p.z()});
      if (has_normals)
        append(vertices.back(),
               std::array<double, 3>{normals[v].x(), normals[v].y(), normals[v].z()});
    }
    for (auto f : out.faces()) {
      std::array<Bits, 3> corners;
      std::size_t i = 0;
      for (auto v : CGAL::vertices_around_face(out.halfedge(f), out)) corners[i++] = vertices[v];
      triangles.push_back(triangle_of(corners));
    }
    sort_triangles();
  }
};

// has_normals: those of the vertices are compared, too
template <class Mesh, class Scheme, class NamedParameters>
void expect_same(const Mesh& control, const Scheme& scheme, double eps, const NamedParameters& np,
                 bool has_normals, std::initializer_list<std::size_t> numbers)
{
  const Whole whole(control, scheme, eps, np, has_normals);
  EXPECT_GT(whole.triangles.size(), 2 * num_faces(control));
  for (const std::size_t number : numbers) {
    SCOPED_TRACE(number);
    const auto pieces =
      PN::internal::tessellate_in_pieces<CGAL::Sequential_tag>(control, scheme, eps, np);
    const std::vector<double> weights = pieces->expected_triangles();
    ASSERT_EQ(weights.size(), num_faces(control));
    pieces->divide(number, weights);
    std::vector<Bits> vertices;
    Content all;
    double bound = 0;
    bool reached = true;
    for (std::size_t i = 0; i < number; ++i) {
      const auto piece = pieces->piece(i, [](const std::vector<Vector>& n) { return n[0]; });
      vertices.resize(pieces->number_of_vertices());
      for (std::size_t v = 0; v < piece.points.size(); ++v) {
        Bits bits;
        append(bits, piece.points[v]);
        if (has_normals) append(bits, piece.normals[v]);
        Bits& of_all = vertices[piece.vertices.number(v)];
        EXPECT_EQ(piece.vertices.is_owned(v), of_all.empty());
        if (of_all.empty()) of_all = bits;
        EXPECT_TRUE(of_all == bits);
      }
      for (std::uint32_t f = 0; f < piece.level.number_of_faces(); ++f) {
        EXPECT_EQ(piece.faces.number(f), all.triangles.size());
        std::array<Bits, 3> corners;
        auto h = piece.level.halfedge_of_face(f);
        for (Bits& c : corners) {
          c = vertices[piece.vertices.number(piece.level.target(h))];
          h = piece.level.next(h);
        }
        all.triangles.push_back(triangle_of(corners));
      }
      bound = (std::max)(bound, piece.bound);
      reached = reached && piece.reached;
    }
    all.sort_triangles();
    EXPECT_EQ(all.triangles.size(), whole.triangles.size());
    EXPECT_TRUE(all.triangles == whole.triangles);
    ASSERT_EQ(vertices.size(), whole.vertices.size());
    const auto control_end = std::ptrdiff_t(num_vertices(control));
    EXPECT_TRUE(
      std::equal(vertices.begin(), vertices.begin() + control_end, whole.vertices.begin()));
    std::vector<Bits> sorted = whole.vertices;
    std::sort(sorted.begin(), sorted.end());
    std::sort(vertices.begin(), vertices.end());
    EXPECT_TRUE(vertices == sorted);
    EXPECT_EQ(bound, whole.result.bound);
    EXPECT_EQ(reached, whole.result.reached);
  }
}

} // namespace tessellation_piece_cases

#endif // PN_SUBDIVISION_3_TEST_TESSELLATION_PIECE_CASES_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_TEST_PIECES_CASES_H
#define CGAL_PN_SUBDIVISION_3_TEST_PIECES_CASES_H

#include "Mesh_cases.h"
#include "Random_meshes.h"

#include <CGAL/PN_limit_surface_3/refine_in_pieces.h>
#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
#include <CGAL/PN_subdivision_3/subdivide.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <type_traits>

// A surface made piece by piece against the one that subdivide() makes.
namespace pieces_cases {

namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;
using random_meshes::Kind;
using test_meshes::Control_mesh;

template <class Scheme>
constexpr bool is_linear_v = PN::internal::Is_linear<Scheme>::value;

template <class FT>
struct Control
{
  using Kernel = CGAL::Simple_cartesian<FT>;
  using Point = typename Kernel::Point_3;
  using Vector = typename Kernel::Vector_3;
  using Mesh = CGAL::Surface_mesh<Point>;
  using Normals = typename Mesh::template Property_map<typename Mesh::Vertex_index, Vector>;

  explicit Control(const Control_mesh& control)
    : normals(mesh.template add_property_map<typename Mesh::Vertex_index, Vector>("n").first)
  {
    mesh_cases::build(control, mesh);
    mesh_cases::put_normals(control.normals, mesh, normals);
  }

  template <class Scheme>
  Mesh refined(const Scheme& scheme, unsigned rounds, std::vector<Vector>& refined_normals) const
  {
    Mesh result = mesh;
    const auto np = params::number_of_iterations(rounds);
    if constexpr (is_linear_v<Scheme>)
      PN::subdivide(result, scheme, np);
    else {
      const Normals map =
        PN::internal::find_property_map<typename Mesh::Vertex_index, Vector>(result, "n").value();
      PN::subdivide(result, scheme, np.vertex_normal_map(map));
      for (const auto v : result.vertices()) refined_normals.push_back(map[v]);
    }
    return result;
  }

  // a function of `const Surface_pieces&`
  template <class Scheme, class Function>
  void with_pieces(const Scheme& scheme, unsigned rounds, std::size_t pieces,
                   const Function& f) const
  {
    const auto np = params::number_of_iterations(rounds);
    if constexpr (is_linear_v<Scheme>)
      f(PN::Surface_pieces<Scheme, Kernel>(
        mesh, scheme, PN::parameters::join(PN::parameters::number_of_pieces(pieces), np)));
    else
      f(PN::Surface_pieces<Scheme, Kernel>(
        mesh, scheme,
        PN::parameters::join(PN::parameters::number_of_pieces(pieces),
                             np.vertex_normal_map(normals))));
  }

  Mesh mesh;
  Normals normals;
};

// The surface, put together from its pieces.
template <class FT>
class Collected_pieces
{
  using C = Control<FT>;
  using Mesh = typename C::Mesh;

public:
  template <class Pieces>
  explicit Collected_pieces(const Pieces& pieces, unsigned rings = 0)
    : vertex_owners_(pieces.size().vertices, 0)
    , face_owners_(pieces.size().faces, 0)
    , points_(pieces.size().vertices)
    , normals_(pieces.size().vertices)
    , faces_(pieces.size().faces)
  {
    std::vector<typename Pieces::Piece> all;
    for (std::size_t i = 0; i < pieces.number_of_pieces(); ++i) {
      all.push_back(pieces.piece(i, rings));
      EXPECT_EQ(pieces.is_empty(i), all.back().number_of_vertices() == 0) << "piece " << i;
      add(all.back());
    }
    // without gaps: what is not the owner has the same bits
    for (const auto& piece : all) {
      compare(piece);
      if (rings > 0) count_faces_at_own_vertices(piece);
    }
  }

  void expect(const Mesh& mesh, const std::vector<typename C::Vector>& normals) const
  {
    ASSERT_EQ(points_.size(), mesh.number_of_vertices());
    ASSERT_EQ(faces_.size(), mesh.number_of_faces());
    EXPECT_EQ(vertex_owners_, std::vector<int>(points_.size(), 1));
    EXPECT_EQ(face_owners_, std::vector<int>(faces_.size(), 1));
    EXPECT_EQ(other_values_, 0u);
    for (const auto& [v, n] : faces_at_vertices_)
      EXPECT_EQ(n, CGAL::degree(typename Mesh::Vertex_index(unsigned(v)), mesh) -
                     unsigned(mesh.is_border(typename Mesh::Vertex_index(unsigned(v)))));
    std::size_t wrong_points = 0, wrong_normals = 0, wrong_faces = 0;
    for (const auto v : mesh.vertices()) {
      wrong_points += points_[v] != mesh.point(v);
      if (!normals.empty()) wrong_normals += normals_[v] != normals[v];
    }
    for (const auto f : mesh.faces()) {
      std::vector<std::uint64_t> corners;
      for (const auto v : vertices_around_face(mesh.halfedge(f), mesh)) corners.push_back(v);
      wrong_faces += corners != faces_[f];
    }
    EXPECT_EQ(wrong_points, 0u) << "of " << points_.size();
    EXPECT_EQ(wrong_normals, 0u) << "of " << points_.size();
    EXPECT_EQ(wrong_faces, 0u) << "of " << faces_.size();
  }

private:
  template <class Piece>
  void add(const Piece& piece)
  {
    for (unsigned v = 0; v < piece.number_of_vertices(); ++v) {
      const auto number = piece.vertex_number(v);
      ASSERT_LT(number, points_.size());
      if (!piece.owns_vertex(v)) continue;
      ++vertex_owners_[number];
      points_[number] = piece.points()[v];
      if (!piece.normals().empty()) normals_[number] = piece.normals()[v];
    }
    for (unsigned f = 0; f < piece.number_of_faces(); ++f) {
      ASSERT_LT(piece.face_number(f), faces_.size());
      if (f > 0) {
        ASSERT_LT(piece.face_number(f - 1), piece.face_number(f));
      }
      if (!piece.owns_face(f)) continue;
      ++face_owners_[piece.face_number(f)];
      faces_[piece.face_number(f)] = corners(piece, f);
    }
  }

  template <class Piece>
  static std::vector<std::uint64_t> corners(const Piece& piece, unsigned f)
  {
    std::vector<std::uint64_t> result;
    const auto& level = piece.connectivity();
    const auto first = level.halfedge_of_face(f);
    auto h = first;
    do {
      result.push_back(piece.vertex_number(level.target(h)));
      h = level.next(h);
    } while (h != first && result.size() < 1000);
    return result;
  }

  // with its rings
  template <class Piece>
  void count_faces_at_own_vertices(const Piece& piece)
  {
    std::map<std::uint64_t, unsigned> number;
    for (const bool is_own : {true, false})
      for (unsigned f = 0; f < piece.number_of_faces(); ++f) {
        if (piece.owns_face(f) != is_own) continue;
        const auto vertices = corners(piece, f);
        other_values_ += vertices != faces_[piece.face_number(f)];
        for (const auto v : vertices)
          if (is_own || number.count(v) != 0) ++number[v];
      }
    faces_at_vertices_.insert(faces_at_vertices_.end(), number.begin(), number.end());
  }

  template <class Piece>
  void compare(const Piece& piece)
  {
    for (unsigned v = 0; v < piece.number_of_vertices(); ++v) {
      const auto number = piece.vertex_number(v);
      other_values_ += piece.points()[v] != points_[number] ||
                       (!piece.normals().empty() && piece.normals()[v] != normals_[number]);
    }
  }

  std::vector<int> vertex_owners_, face_owners_;
  std::vector<typename C::Point> points_;
  std::vector<typename C::Vector> normals_;
  std::vector<std::vector<std::uint64_t>> faces_;
  std::vector<std::pair<std::uint64_t, unsigned>> faces_at_vertices_; // of pieces with rings
  std::size_t other_values_ = 0;
};

template <class FT, class Scheme>
void expect_as_subdivide(const Control_mesh& control_mesh, const Scheme& scheme, unsigned rounds,
                         const std::vector<std::size_t>& numbers_of_pieces)
{
  const Control<FT> control(control_mesh);
  std::vector<typename Control<FT>::Vector> normals;
  const auto mesh = control.refined(scheme, rounds, normals);
  for (const std::size_t number : numbers_of_pieces) {
    SCOPED_TRACE(control_mesh.name + ", " + std::to_string(rounds) + " rounds, " +
                 std::to_string(number) + " pieces");
    control.with_pieces(scheme, rounds, number, [&](const auto& pieces) {
      EXPECT_EQ(pieces.size().vertices, mesh.number_of_vertices());
      EXPECT_EQ(pieces.size().edges, mesh.number_of_edges());
      Collected_pieces<FT>(pieces).expect(mesh, normals);
      Collected_pieces<FT>(pieces, 1).expect(mesh, normals);
    });
  }
}

// What Surface_pieces does, with another number of rings: how many points are not those of subdivide(), and how
// many faces are missing.
template <class Scheme>
std::size_t number_of_defects(const Control_mesh& control_mesh, const Scheme& scheme,
                              unsigned rounds, std::size_t number, unsigned rings)
{
  using Average = PN::PN_average<double, 3>;
  using Refiner = PN::internal::Piece_refiner<Scheme, Average>;
  using Elements = PN::internal::Global_ids;
  const Control<double> control(control_mesh);
  std::vector<Control<double>::Vector> normals;
  const auto mesh = control.refined(scheme, rounds, normals);
  std::size_t other = 0, faces = 0;
  PN::internal::with_mesh_access(control.mesh, [&](const auto& access) {
    auto level = PN::internal::checked_level(access);
    const auto values = PN::internal::read_values<Average>(
      access, level, control.mesh.points(), control.normals, PN::internal::normal_estimate(scheme));
    PN::internal::No_creases creases(level.number_of_vertices());
    const Refiner refiner(scheme, std::move(level), std::move(creases),
                          {values.begin(), values.end()}, {}, rounds, number, rings,
                          PN::internal::For_chunks());
    for (std::size_t i = 0; i < number; ++i) {
      Elements vertices;
      const auto begin = [&](PN::Level_connectivity& level_of_piece, Elements& v, Elements&) {
        vertices = v;
        faces += level_of_piece.number_of_faces();
      };
      using Index = PN::Level_connectivity::Index;
      using Limit = PN::internal::Limit_result<Average>;
      const auto put = [&](Index v, const typename Refiner::Value& value, const Limit*) {
        const auto& p = value.point;
        const auto place =
          typename Control<double>::Mesh::Vertex_index(static_cast<unsigned>(vertices.number(v)));
        other += mesh.point(place) != typename Control<double>::Point(p[0], p[1], p[2]);
      };
      const auto put_corner = [](Index, Index, const typename Refiner::Value&, const Limit*) {};
      const auto put_attributes = [](const auto&) {};
      refiner.refine(i, 0, {begin, put, put_corner, put_attributes});
    }
  });
  return other + (mesh.number_of_faces() - faces);
}

// A torus of which some pairs of faces are split in another way: the four vertices of each are extraordinary, all
// others regular.
inline Control_mesh torus_with_turned_edges(Kind kind, unsigned one_in)
{
  std::mt19937 generator(5);
  constexpr int n = 18;
  Control_mesh mesh{"torus with turned edges", {}, {}};
  const auto vertex = [](int i, int j) { return i % n * n + j % n; };
  const auto add = [&](std::vector<int> f) { mesh.faces.push_back(std::move(f)); };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double u = 6.283 * i / n, v = 6.283 * j / n, r = 3 + std::cos(v);
      mesh.points.push_back({r * std::cos(u), r * std::sin(u), std::sin(v)});
    }
  for (int i = 0; i < n; i += 2)
    for (int j = 0; j < n; ++j) {
      const int a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 2, j),
                d = vertex(i + 2, j + 1), e = vertex(i + 1, j + 1), f = vertex(i, j + 1);
      const bool is_turned = generator() % one_in == 0 && j % 2 == 0;
      if (kind == Kind::triangles) {
        if (is_turned) {
          add({a, b, f});
          add({b, e, f});
        } else {
          add({a, b, e});
          add({a, e, f});
        }
        add({b, c, d});
        add({b, d, e});
      } else if (is_turned) {
        add({a, b, c, d});
        add({a, d, e, f});
      } else {
        add({a, b, e, f});
        add({b, c, d, e});
      }
    }
  test_meshes::set_uneven_normals(mesh, 3);
  return mesh;
}

template <class Scheme>
constexpr Kind kind_of()
{
  using Host = typename Scheme::Host;
  if (std::is_same_v<Host, PN::PTQ_host> || std::is_same_v<Host, PN::Sqrt3_host>)
    return Kind::triangles;
  return PN::internal::Ghost_rings<Scheme>::value == 4 &&
             !PN::internal::Has_crease_rules<Scheme>::value
           ? Kind::quads // Kobbelt's
           : Kind::polygons;
}

} // namespace pieces_cases

#endif // CGAL_PN_SUBDIVISION_3_TEST_PIECES_CASES_H

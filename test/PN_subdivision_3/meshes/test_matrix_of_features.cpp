// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Schemes x normals x creases x attributes: what subdivide_to_limit() and a Surface_refiner carry is what subdivide()
// carries, by bytes, the points and normals of a refiner are those of subdivide(), and what one of them refuses the
// others refuse. Each call has all maps and a table, whatever is in them, so that few types
// are compiled.

#include "Extent.h"
#include "Feature_matrix.h"
#include "Pieces_cases.h"
#include "support/Options.h"

#include <CGAL/PN_limit_surface_3/subdivide_to_limit.h>
#include <CGAL/PN_subdivision_3/Surface_refiner.h>
#include <CGAL/PN_subdivision_3/estimate_control_normals.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>

namespace {

using namespace feature_matrix;

// Points and normals at the limit do not depend on what is carried.
struct At_the_limit
{
  template <class Scheme, class Np>
  void operator()(Case& c, const Scheme& scheme, const Np& np) const
  {
    test_options::Limit_options options;
    options.max_depth = 1;
    PN::subdivide_to_limit(c.mesh, scheme,
                           PN::parameters::join(PN::parameters::attributes(c.table), options.pack(),
                                                np.visitor(std::ref(c.log))));
  }
};

// The refined mesh replaces the control mesh of the case.
template <class Normals>
struct Refiner
{
  template <class Scheme, class Np>
  void operator()(Case& c, const Scheme& scheme, const Np& np) const
  {
    const PN::Surface_refiner refiner(
      c.mesh, scheme, PN::parameters::join(PN::parameters::attributes(c.table), np));
    c.mesh.clear_without_removing_property_maps();
    if constexpr (std::is_same_v<Normals, Of_corners>)
      refiner.build_mesh(c.mesh,
                         PN::parameters::attributes(c.table).vertex_normal_map(c.corner_normals));
    else
      refiner.build_mesh(c.mesh, PN::parameters::attributes(c.table).vertex_normal_map(c.normals));
  }
};

template <class Normals>
void compare_limits(const std::string& scheme, Crease_kind creases, const Normals& normals)
{
  const auto values = [](const Case& c) {
    return std::vector{c.points(), c.vertex_normals(), c.all_corner_normals()};
  };
  std::vector<std::vector<double>> without;
  for (const Attribute_kind attributes : attribute_kinds) {
    if (!tests_are_full && !std::is_same_v<Normals, Of_vertices> &&
        attributes != Attribute_kind::none && attributes != Attribute_kind::all)
      continue;
    SCOPED_TRACE(name(attributes));
    Case plain(scheme, creases, attributes), limit(scheme, creases, attributes);
    run(plain, normals, Plain());
    run(limit, normals, At_the_limit());
    expect_same_but_values(limit, plain);
    EXPECT_EQ(plain.error.empty(), is_known(scheme, creases, normals, attributes)) << plain.error;
    if (attributes == Attribute_kind::none) without = values(limit);
    for (std::size_t i = 0; i < 3 && limit.error.empty(); ++i)
      EXPECT_TRUE(same_bytes(values(limit)[i], without[i])) << i;
  }
}

TEST(Matrix_of_features, TheLimitCarriesWhatSubdivideCarries)
{
  for_each_cell([](const std::string& scheme, Crease_kind creases, const auto& normals) {
    if (scheme_named(scheme).keeps_vertices()) compare_limits(scheme, creases, normals);
  });
}

template <class Normals>
void compare_refiners(const std::string& scheme, Crease_kind creases, const Normals& normals)
{
  for (const Attribute_kind attributes : attribute_kinds) {
    SCOPED_TRACE(name(attributes));
    Case plain(scheme, creases, attributes), refiner(scheme, creases, attributes);
    run(plain, normals, Plain());
    run(refiner, normals, Refiner<Normals>());
    EXPECT_EQ(refiner.error, plain.error);
    expect_same_tables(refiner.table, plain.table);
    EXPECT_EQ(refiner.connectivity(), plain.connectivity());
    EXPECT_TRUE(same_bytes(refiner.points(), plain.points()));
    if (std::is_same_v<Normals, Of_vertices>) {
      EXPECT_TRUE(same_bytes(refiner.vertex_normals(), plain.vertex_normals()));
    }
    if (std::is_same_v<Normals, Of_corners>) {
      EXPECT_TRUE(same_bytes(refiner.all_corner_normals(), plain.all_corner_normals()));
    }
  }
}

TEST(Matrix_of_features, ARefinerCarriesWhatSubdivideCarries)
{
  for_each_cell([](const std::string& scheme, Crease_kind creases, const auto& normals) {
    if (!scheme_named(scheme).transfers_curvature()) compare_refiners(scheme, creases, normals);
  });
}

// --- the same for pieces: put together they are what subdivide() and subdivide_to_limit() make ---

constexpr double tolerance = 1e-5; // whose depth depends on the size of the box

// A refined surface, by its elements.
struct Whole
{
  std::vector<double> points, normals, corner_normals; // of corners: face by face
  std::vector<std::size_t> faces;
  std::map<std::pair<std::size_t, std::size_t>, std::vector<double>>
    edges;                   // the values of edges, by their ends
  PN::Attribute_table table; // corners face by face; edges are apart
  PN::Limit_report report;

  void add(std::vector<double>& values, std::size_t i, const Vector& v)
  {
    if (values.size() < 3 * (i + 1)) values.resize(3 * (i + 1), -99.);
    for (int k = 0; k < 3; ++k) values[3 * i + std::size_t(k)] = v[k];
  }
};

// arrays as those of the case, without values
PN::Attribute_table empty_table(const PN::Attribute_table& like)
{
  PN::Attribute_table table = like;
  for (auto* arrays : {&table.vertices, &table.corners, &table.edges})
    for (auto& array : *arrays) array.values.clear();
  table.face_parents.clear();
  return table;
}

void add_row(PN::Attribute_array& to, std::size_t row, const PN::Attribute_array& from,
             std::size_t i)
{
  const std::size_t d = from.dimension;
  ASSERT_EQ(to.dimension, d);
  if (to.values.size() < d * (row + 1)) to.values.resize(d * (row + 1), -99.);
  std::copy_n(from.values.begin() + std::ptrdiff_t(d * i), d,
              to.values.begin() + std::ptrdiff_t(d * row));
}

template <class Table>
void add_rows(Table& to, std::size_t row, const Table& from, std::size_t i)
{
  ASSERT_EQ(to.size(), from.size());
  for (std::size_t k = 0; k < to.size(); ++k) add_row(to[k], row, from[k], i);
}

// The values of an edge, beside the numbers of its ends.
using Edge_values = std::map<std::pair<std::size_t, std::size_t>, std::vector<double>>;

Edge_values::value_type edge_values(std::size_t a, std::size_t b, const PN::Attribute_table& table,
                                    std::size_t e)
{
  std::vector<double> values;
  for (const auto& array : table.edges)
    for (std::size_t k = 0; k < array.dimension; ++k)
      values.push_back(array.values[e * array.dimension + k]);
  return {std::minmax(a, b), values};
}

Whole whole(const Case& c, bool of_corners, bool has_normals)
{
  Whole w;
  w.table = empty_table(c.table);
  w.table.face_parents = c.table.face_parents;
  for (auto v : c.mesh.vertices()) {
    w.add(w.points, v.idx(), c.mesh.point(v) - CGAL::ORIGIN);
    if (has_normals && !of_corners) w.add(w.normals, v.idx(), c.normals[v]);
    add_rows(w.table.vertices, v.idx(), c.table.vertices, v.idx());
  }
  for (auto e : c.mesh.edges())
    w.edges.insert(
      edge_values(c.mesh.vertex(e, 0).idx(), c.mesh.vertex(e, 1).idx(), c.table, e.idx()));
  for (auto f : c.mesh.faces())
    for (auto h : halfedges_around_face(c.mesh.halfedge(f), c.mesh)) {
      if (has_normals && of_corners) w.add(w.corner_normals, w.faces.size(), c.corner_normals[h]);
      add_rows(w.table.corners, w.faces.size(), c.table.corners, h.idx());
      w.faces.push_back(c.mesh.target(h).idx());
    }
  return w;
}

template <class Pieces>
Whole collected(const Pieces& pieces, bool of_corners, const PN::Attribute_table& like)
{
  Whole w;
  w.table = empty_table(like);
  if (like.has_face_parents) w.table.face_parents.resize(pieces.size().faces);
  w.faces.resize(pieces.first_corner(pieces.size().faces));
  for (std::size_t i = 0; i < pieces.number_of_pieces(); ++i) {
    const auto piece = pieces.piece(i);
    const bool has_table = piece.attributes() != nullptr;
    const PN::Attribute_table table = has_table ? *piece.attributes() : empty_table(like);
    for (unsigned v = 0; v < piece.number_of_vertices(); ++v) {
      if (!piece.owns_vertex(v)) continue;
      w.add(w.points, piece.vertex_number(v), piece.points()[v] - CGAL::ORIGIN);
      if (!piece.normals().empty() && !of_corners)
        w.add(w.normals, piece.vertex_number(v), piece.normals()[v]);
      if (has_table) add_rows(w.table.vertices, piece.vertex_number(v), table.vertices, v);
    }
    const auto& level = piece.connectivity();
    for (unsigned f = 0; f < piece.number_of_faces(); ++f) {
      std::size_t corner = pieces.first_corner(piece.face_number(f));
      if (has_table && like.has_face_parents)
        w.table.face_parents[piece.face_number(f)] = table.face_parents[f];
      const auto first = level.halfedge_of_face(f);
      auto h = first;
      do {
        if (!piece.normals().empty() && of_corners)
          w.add(w.corner_normals, corner, piece.corner_normal(h));
        if (has_table) {
          add_rows(w.table.corners, corner, table.corners, h);
          const auto source = level.target(PN::Level_connectivity::opposite(h));
          const auto edge = edge_values(piece.vertex_number(source),
                                        piece.vertex_number(level.target(h)), table, h / 2);
          const auto it = w.edges.insert(edge).first;
          EXPECT_EQ(it->second, edge.second) << "of two pieces";
        }
        w.faces[corner++] = piece.vertex_number(level.target(h));
        h = level.next(h);
      } while (h != first);
    }
    w.report.error = (std::max)(w.report.error, piece.limit_report().error);
    w.report.normal_error = (std::max)(w.report.normal_error, piece.limit_report().normal_error);
    w.report.number_of_misses += piece.limit_report().number_of_misses;
    w.report.number_of_stand_ins += piece.limit_report().number_of_stand_ins;
    w.report.tolerance = (std::max)(w.report.tolerance, piece.limit_report().tolerance);
    w.report.depth = (std::max)(w.report.depth, piece.limit_report().depth);
  }
  return w;
}

void expect_same(const Whole& a, const Whole& b)
{
  EXPECT_EQ(a.faces, b.faces);
  expect_same_tables(a.table, b.table);
  EXPECT_EQ(a.edges, b.edges);
  EXPECT_TRUE(same_bytes(a.points, b.points));
  EXPECT_TRUE(same_bytes(a.normals, b.normals));
  EXPECT_TRUE(same_bytes(a.corner_normals, b.corner_normals));
  EXPECT_EQ(a.report.error, b.report.error);
  EXPECT_EQ(a.report.normal_error, b.report.normal_error);
  EXPECT_EQ(a.report.tolerance, b.report.tolerance);
  EXPECT_EQ(a.report.number_of_misses, b.report.number_of_misses);
  EXPECT_EQ(a.report.number_of_stand_ins, b.report.number_of_stand_ins);
  EXPECT_EQ(a.report.depth, b.report.depth);
}

// What is asked for, points and normals.
using Limits = std::pair<bool, bool>;

template <class Np>
auto with_limits(const Limits& limits, const Np& np)
{
  return PN::parameters::join(
    PN::parameters::points(limits.first).surface_normals(limits.second).tolerance(tolerance), np);
}

template <class Normals>
void compare_pieces(const std::string& name, Crease_kind creases, const Normals& normals,
                    const Limits& limits, const mesh_cases::Soup& soup,
                    std::size_t number_of_pieces, Attribute_kind attributes = Attribute_kind::all)
{
  if (!is_known(name, creases, normals, attributes)) attributes = Attribute_kind::vertices;
  if (!is_known(name, creases, normals, attributes)) attributes = Attribute_kind::none;
  SCOPED_TRACE(std::string(limits.first ? "limit points " : "") +
               (limits.second ? "surface normals" : ""));
  constexpr bool of_corners = std::is_same_v<Normals, Of_corners>;
  // estimated normals are in no map
  constexpr bool has_map = of_corners || std::is_same_v<Normals, Of_vertices>;
  const bool is_limit = limits.first || limits.second;
  Case mesh(name, creases, attributes, soup);
  Case parts(name, creases, attributes, soup);
  Whole a, b;
  run(mesh, normals, [&](Case& c, const auto& scheme, const auto& given) {
    const auto np = PN::parameters::join(PN::parameters::attributes(c.table), given);
    PN::Limit_report report;
    if (is_limit)
      report = PN::subdivide_to_limit(c.mesh, scheme, with_limits(limits, np));
    else
      PN::subdivide(c.mesh, scheme, np);
    a = whole(c, of_corners, has_map);
    a.report = report;
  });
  run(parts, normals, [&](Case& c, const auto& scheme, const auto& np) {
    const PN::Surface_pieces<std::decay_t<decltype(scheme)>, Kernel> pieces(
      c.mesh, scheme,
      with_limits(
        limits,
        PN::parameters::join(
          PN::parameters::attributes(c.table).number_of_pieces(number_of_pieces).to_limit(is_limit),
          np)));
    b = collected(pieces, of_corners, c.table);
    if (!has_map) b.normals.clear();
  });
  EXPECT_EQ(mesh.error.empty(), parts.error.empty()) << mesh.error << "\n" << parts.error;
  expect_same(b, a);
}

// A patch of so many faces that two pieces divide the control mesh, and all rounds are made in pieces.
mesh_cases::Soup patch_for(const std::string& scheme_name)
{
  constexpr std::size_t n = 6;
  mesh_cases::Soup soup;
  for (std::size_t j = 0; j <= n; ++j)
    for (std::size_t i = 0; i <= n; ++i)
      soup.points.push_back({double(i), double(j), 0.2 * double((i * 7 + j * 5) % 9)});
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t a = j * (n + 1) + i, b = a + 1, c = b + n + 1, d = a + n + 1;
      if (!scheme_named(scheme_name).needs_triangles())
        soup.faces.push_back({a, b, c, d});
      else if ((i + j) % 3 == 0)
        soup.faces.insert(soup.faces.end(), {{a, b, d}, {b, c, d}});
      else
        soup.faces.insert(soup.faces.end(), {{a, b, c}, {a, c, d}});
    }
  return soup;
}

TEST(Matrix_of_features, PiecesAreWhatSubdivideMakes)
{
  for_each_cell([](const std::string& scheme, Crease_kind creases, const auto& normals) {
    if (!scheme_named(scheme).splits_edges()) return;
    for (const std::size_t pieces : {2, 5})
      compare_pieces(scheme, creases, normals, {false, false}, soup_for(scheme), pieces);
    compare_pieces(scheme, creases, normals, {false, false}, patch_for(scheme), 2);
  });
}

TEST(Matrix_of_features, PiecesAtTheLimitAreWhatSubdivideToLimitMakes)
{
  for_each_cell([](const std::string& scheme, Crease_kind creases, const auto& normals) {
    if (!scheme_named(scheme).splits_edges()) return;
    for (const Limits& limits : {Limits{true, true}, Limits{true, false}, Limits{false, true}}) {
      compare_pieces(scheme, creases, normals, limits, soup_for(scheme), 2);
      if (!tests_are_full && !std::is_same_v<decltype(normals), const Of_vertices&>) return;
    }
  });
}

// Pieces that do not have the whole surface in their rings.
TEST(Matrix_of_features, PiecesOfALargerSurfaceAtTheLimit)
{
  for (const std::string scheme : {"catmull-clark", "modified-loop"}) {
    SCOPED_TRACE(scheme);
    const auto torus = pieces_cases::torus_with_turned_edges(
      scheme == "catmull-clark" ? random_meshes::Kind::polygons : random_meshes::Kind::triangles,
      5);
    mesh_cases::Soup soup{torus.points, {}};
    for (const auto& f : torus.faces) soup.faces.emplace_back(f.begin(), f.end());
    for (const Limits& limits : {Limits{true, true}, Limits{false, true}})
      compare_pieces(scheme, Crease_kind::edges, Of_vertices(), limits, soup, 20);
    compare_pieces(scheme, Crease_kind::none, Linear(), {true, true}, soup, 20);
  }
}

// Irregular vertices side by side, whose limits are sought some rounds further, and the rings around pieces: with fewer faces around
// pieces they would be others.
TEST(Matrix_of_features, LimitsInPiecesReachAsFarAsTheyAreSought)
{
  for (const std::string name : {"catmull-clark", "modified-loop", "kobbelt", "butterfly"}) {
    SCOPED_TRACE(name);
    const auto scheme = scheme_named(name);
    const bool is_of_triangles = scheme.needs_triangles();
    const auto torus = pieces_cases::torus_with_turned_edges(
      is_of_triangles ? random_meshes::Kind::triangles : random_meshes::Kind::polygons, 5);
    Mesh mesh;
    mesh_cases::Soup soup{torus.points, {}};
    for (const auto& f : torus.faces) soup.faces.emplace_back(f.begin(), f.end());
    mesh_cases::build(soup, mesh);
    if (name == "kobbelt") PN::subdivide(mesh, PN::CatmullClark_scheme()); // quads
    auto normals =
      mesh.add_property_map<CGAL::SM_Vertex_index, Vector>("v:n", Vector(0, 0, 0)).first;
    PN::estimate_control_normals(mesh, normals);
    const auto all =
      PN::parameters::surface_normals(true).number_of_iterations(0).vertex_normal_map(normals);
    const PN::Surface_pieces pieces(
      mesh, scheme, PN::parameters::join(PN::parameters::number_of_pieces(20).to_limit(true), all));
    std::size_t different = 0, known = 0;
    PN::subdivide_to_limit(mesh, scheme, all);
    for (std::size_t i = 0; i < pieces.number_of_pieces(); ++i) {
      const auto piece = pieces.piece(i, 1);
      for (unsigned v = 0; v < piece.number_of_vertices(); ++v) {
        const Mesh::Vertex_index of_whole(piece.vertex_number(v));
        ++known;
        if (piece.points()[v] != mesh.point(of_whole) || piece.normals()[v] != normals[of_whole])
          ++different;
      }
    }
    EXPECT_GT(known, mesh.number_of_vertices());
    EXPECT_EQ(different, 0u);
  }
}

} // namespace

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVISION_3_TEST_FEATURE_MATRIX_H
#define PN_SUBDIVISION_3_TEST_FEATURE_MATRIX_H

#include "Mesh_cases.h"
#include "Scheme_named.h"

#include <CGAL/PN_subdivision_3/attributes.h>
#include <CGAL/PN_subdivision_3/attributes/Attribute_traits.h>
#include <CGAL/PN_subdivision_3/internal/schemes/scheme_of_call.h>
#include <CGAL/PN_subdivision_3/parameters/Default_visitor.h>
#include <CGAL/PN_subdivision_3/subdivide.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstring>
#include <functional>
#include <limits>
#include <stdexcept>
#include <type_traits>

// A small mesh with everything that a call can be given, of which each cell of the matrix fills in some.
namespace feature_matrix {

namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vector = Kernel::Vector_3;

constexpr unsigned rounds = 2;

enum class Crease_kind { none, edges, corners, border, semi_sharp };
constexpr Crease_kind crease_kinds[] = {Crease_kind::none, Crease_kind::edges, Crease_kind::corners,
                                        Crease_kind::border, Crease_kind::semi_sharp};
enum class Attribute_kind { none, vertices, charts, edges, faces, all };
constexpr Attribute_kind attribute_kinds[] = {Attribute_kind::none,   Attribute_kind::vertices,
                                              Attribute_kind::charts, Attribute_kind::edges,
                                              Attribute_kind::faces,  Attribute_kind::all};

inline std::string name(Crease_kind kind)
{
  constexpr const char* names[] = {"no creases", "sharp edges", "corners", "border", "semi-sharp"};
  return names[int(kind)];
}
inline std::string name(Attribute_kind kind)
{
  constexpr const char* names[] = {"no attributes", "of vertices", "charts",
                                   "of edges",      "of faces",    "all attributes"};
  return names[int(kind)];
}

// what a visitor is told
struct Log
{
  std::vector<std::size_t> told;

  void round_done(unsigned k, std::size_t faces) { told.insert(told.end(), {k, faces}); }
  void vertex_created(Mesh::Vertex_index v, const PN::Control_element& e) { element(v.idx(), e); }
  void edge_created(Mesh::Edge_index v, const PN::Control_element& e) { element(v.idx(), e); }
  void face_created(Mesh::Face_index v, const PN::Control_element& e) { element(v.idx(), e); }
  void element(std::size_t i, const PN::Control_element& origin)
  {
    told.insert(told.end(), {i, std::size_t(origin.kind), std::size_t(origin.index)});
  }
};

inline mesh_cases::Soup two_quads()
{
  return {{{0, 0, 0}, {1, 0, 0.1}, {1, 1, 0}, {0, 1.2, 0.3}, {2, 0.1, 0.2}, {2.2, 1, 0}},
          {{0, 1, 2, 3}, {1, 4, 5, 2}}};
}

// a small one that the scheme takes
inline mesh_cases::Soup soup_for(const std::string& scheme_name)
{
  return scheme_named(scheme_name).needs_triangles() ? mesh_cases::triangles_with_border()
         : scheme_name == "kobbelt"                  ? two_quads() // it takes quadrilaterals only
                                                     : mesh_cases::mixed_with_border();
}

struct Case
{
  Case(const std::string& scheme_name, Crease_kind creases, Attribute_kind attributes)
    : Case(scheme_name, creases, attributes, soup_for(scheme_name))
  {}
  Case(const std::string& scheme_name, Crease_kind creases, Attribute_kind attributes,
       const mesh_cases::Soup& soup)
    : scheme(PN::internal::with_border(scheme_named(scheme_name), creases == Crease_kind::border
                                                                    ? PN::Border::curve
                                                                    : PN::Border::surface))
  {
    mesh_cases::build(soup, mesh);
    normals = mesh.add_property_map<Mesh::Vertex_index, Vector>("n", CGAL::NULL_VECTOR).first;
    corner_normals =
      mesh.add_property_map<Mesh::Halfedge_index, Vector>("c", CGAL::NULL_VECTOR).first;
    sharpness = mesh.add_property_map<Mesh::Edge_index, double>("e", 0).first;
    vertex_sharpness = mesh.add_property_map<Mesh::Vertex_index, double>("v", 0).first;
    mesh_cases::put_normals(mesh_cases::normals(soup), mesh, normals);
    for (auto h : mesh.halfedges()) {
      const Vector n = normals[mesh.target(h)];
      if (!mesh.is_border(h)) corner_normals[h] = n + Vector(0, 0.1 * (mesh.face(h).idx() % 3), 0);
    }
    set_sharpness(creases);
    set_attributes(attributes);
  }

  auto tags() const
  {
    return params::number_of_iterations(rounds)
      .edge_is_constrained_map(sharpness)
      .vertex_is_constrained_map(vertex_sharpness);
  }
  std::vector<double> points() const
  {
    return coordinates(mesh.vertices(), [&](auto v) { return mesh.point(v); });
  }
  std::vector<double> vertex_normals() const
  {
    return coordinates(mesh.vertices(), [&](auto v) { return normals[v]; });
  }
  std::vector<double> all_corner_normals() const
  {
    return coordinates(mesh.halfedges(), [&](auto h) { return corner_normals[h]; });
  }
  std::vector<double> all_sharpness() const
  {
    std::vector<double> result;
    for (auto e : mesh.edges()) result.push_back(sharpness[e]);
    for (auto v : mesh.vertices()) result.push_back(vertex_sharpness[v]);
    return result;
  }
  std::vector<std::size_t> connectivity() const
  {
    std::vector<std::size_t> result;
    for (auto h : mesh.halfedges())
      result.insert(result.end(), {mesh.target(h).idx(), mesh.next(h).idx(), mesh.face(h).idx()});
    return result;
  }

  PN::internal::Scheme_of_call<PN::Any_scheme<>, true, PN::internal::Not_given> scheme;
  Mesh mesh;
  Mesh::Property_map<Mesh::Vertex_index, Vector> normals;
  Mesh::Property_map<Mesh::Halfedge_index, Vector> corner_normals;
  Mesh::Property_map<Mesh::Edge_index, double> sharpness;
  Mesh::Property_map<Mesh::Vertex_index, double> vertex_sharpness;
  PN::Attribute_table table;
  Log log;
  std::string error; // why the call was refused

private:
  template <class Elements, class Function>
  static std::vector<double> coordinates(const Elements& elements, const Function& of)
  {
    std::vector<double> result;
    for (auto x : elements) {
      const auto p = of(x);
      result.insert(result.end(), {p.x(), p.y(), p.z()});
    }
    return result;
  }

  void set_sharpness(Crease_kind kind)
  {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    const auto inner = [this](auto e) { return !mesh.is_border(e); };
    int i = 0;
    for (auto e : mesh.edges()) {
      if (!inner(e)) continue;
      const int k = i++ % 11; // all over a larger mesh
      if (kind == Crease_kind::edges && k < 2) sharpness[e] = infinite;
      if (kind == Crease_kind::semi_sharp && k < 3) sharpness[e] = k == 0 ? infinite : 0.5 + k / 2.;
    }
    if (kind == Crease_kind::corners)
      for (auto v : mesh.vertices())
        if (v.idx() % 13 == 0) vertex_sharpness[v] = infinite;
  }

  void set_attributes(Attribute_kind kind)
  {
    const auto has = [&](Attribute_kind k) { return kind == k || kind == Attribute_kind::all; };
    const auto array = [](std::size_t dimension, std::size_t n, const auto& value) {
      PN::Attribute_array a;
      a.dimension = dimension;
      for (std::size_t i = 0; i < n * dimension; ++i) a.values.push_back(value(i));
      return a;
    };
    const auto uneven = [](std::size_t i) { return 0.1 * double(i * i % 17) - 0.3; };
    if (has(Attribute_kind::vertices)) {
      table.vertices.push_back(array(1, mesh.number_of_vertices(), uneven));
      table.vertices.push_back(array(3, mesh.number_of_vertices(), uneven));
    }
    // the first face has a chart of its own, and so have some of a larger mesh
    const auto in_charts = [&](std::size_t i) {
      const Mesh::Halfedge_index h(Mesh::size_type(i / 2));
      const bool is_first = !mesh.is_border(h) && mesh.face(h).idx() % 9 == 0;
      return uneven(2 * mesh.target(h).idx() + i % 2) + (is_first ? 5 : 0);
    };
    if (has(Attribute_kind::charts))
      for (const PN::Corner_rule rule : {PN::Corner_rule::corners_plus1, PN::Corner_rule::all}) {
        table.corners.push_back(array(2, mesh.number_of_halfedges(), in_charts));
        table.corners.back().rule = rule;
      }
    if (has(Attribute_kind::edges)) table.edges.push_back(array(1, mesh.number_of_edges(), uneven));
    table.has_face_parents = has(Attribute_kind::faces);
  }
};

// \name Normals: calls a function with the scheme and the named parameters of a case

#define PN_NORMALS(Name, words, scheme_of_case, parameters_of_case)                                \
  struct Name                                                                                      \
  {                                                                                                \
    static constexpr const char* name = words;                                                     \
    template <class Function>                                                                      \
    void operator()(Case& c, const Function& f) const                                              \
    {                                                                                              \
      f(scheme_of_case, parameters_of_case);                                                       \
    }                                                                                              \
  };
PN_NORMALS(Estimated, "estimated normals", c.scheme, c.tags())
PN_NORMALS(Linear, "linear", PN::linear(c.scheme), c.tags())
PN_NORMALS(Of_vertices, "normals of vertices", c.scheme, c.tags().vertex_normal_map(c.normals))
PN_NORMALS(Of_corners, "normals of corners", c.scheme, c.tags().vertex_normal_map(c.corner_normals))
#undef PN_NORMALS

struct Plain
{
  template <class Scheme, class Np>
  void operator()(Case& c, const Scheme& scheme, const Np& np) const
  {
    PN::subdivide(
      c.mesh, scheme,
      PN::parameters::join(PN::parameters::attributes(c.table), np.visitor(std::ref(c.log))));
  }
};

template <class Normals, class Function>
void run(Case& c, const Normals& normals, const Function& f)
{
  normals(c, [&](const auto& scheme, const auto& np) {
    try {
      f(c, scheme, np);
    } catch (const std::invalid_argument& e) {
      c.error = e.what();
    }
  });
}

// whether the scheme has rules for all this
template <class Normals>
bool is_known(const std::string& scheme_name, Crease_kind creases, const Normals&,
              Attribute_kind attributes)
{
  const auto scheme = scheme_named(scheme_name);
  const bool is_creased = creases != Crease_kind::none || std::is_same_v<Normals, Of_corners>;
  const bool is_split = attributes != Attribute_kind::none &&
                        attributes != Attribute_kind::vertices &&
                        attributes != Attribute_kind::faces; // at edges of the control mesh
  return (!is_creased || scheme.has_crease_rules()) && (!is_split || scheme.splits_edges());
}

// calls f(name of a scheme, creases, normals)
template <class Function>
void for_each_cell(const Function& f)
{
  for (const std::string& scheme : names_of_schemes())
    for (const Crease_kind creases : crease_kinds) {
      const auto call = [&](const auto& normals) {
        SCOPED_TRACE(scheme + ", " + name(creases) + ", " + normals.name);
        f(scheme, creases, normals);
      };
      call(Estimated());
      call(Linear());
      call(Of_vertices());
      call(Of_corners());
    }
}

template <class T>
bool same_bytes(const std::vector<T>& a, const std::vector<T>& b)
{
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

inline void expect_same(const std::vector<PN::Attribute_array>& a,
                        const std::vector<PN::Attribute_array>& b)
{
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_TRUE(same_bytes(a[i].values, b[i].values)) << i;
}

inline void expect_same_tables(const PN::Attribute_table& a, const PN::Attribute_table& b)
{
  expect_same(a.vertices, b.vertices);
  expect_same(a.corners, b.corners);
  expect_same(a.edges, b.edges);
  EXPECT_EQ(a.face_parents, b.face_parents);
}

// but points and normals
inline void expect_same_but_values(const Case& a, const Case& b)
{
  EXPECT_EQ(a.error, b.error);
  expect_same_tables(a.table, b.table);
  EXPECT_EQ(a.connectivity(), b.connectivity());
  EXPECT_TRUE(same_bytes(a.all_sharpness(), b.all_sharpness()));
  EXPECT_EQ(a.log.told, b.log.told);
}

} // namespace feature_matrix

#endif // PN_SUBDIVISION_3_TEST_FEATURE_MATRIX_H

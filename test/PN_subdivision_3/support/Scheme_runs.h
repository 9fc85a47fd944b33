// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Running a scheme on a control mesh, on Surface_mesh and in its reference form, and comparing
// results.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_SCHEME_RUNS_H
#define CGAL_PN_SUBDIVISION_3_TEST_SCHEME_RUNS_H

#include "Mesh_cases.h"
#include "Scheme_description.h"
#include "reference/PN_rule.h"

#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#include <CGAL/PN_subdivision_3/subdivide.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <set>

using Kernel = CGAL::Simple_cartesian<double>;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Normal_map = Surface_mesh::Property_map<Surface_mesh::Vertex_index, Kernel::Vector_3>;

inline Normal_map normal_map(Surface_mesh& mesh)
{
  return mesh
    .add_property_map<Surface_mesh::Vertex_index, Kernel::Vector_3>("v:normal", CGAL::NULL_VECTOR)
    .first;
}

inline Surface_mesh to_surface_mesh(const test_meshes::Control_mesh& control)
{
  Surface_mesh mesh;
  const Normal_map normals = normal_map(mesh);
  mesh_cases::build(control, mesh);
  if (control.normals.size() != control.points.size()) // shapes get theirs by with_normals()
    throw std::logic_error("the test mesh " + control.name + " has no normals");
  mesh_cases::put_normals(control.normals, mesh, normals);
  return mesh;
}

// --- runs ---

template <class Description, class Tag = CGAL::Sequential_tag>
void refine(Surface_mesh& mesh, unsigned rounds)
{
  CGAL::PN_subdivision_3::subdivide<Tag>(
    mesh, Description::scheme(),
    CGAL::parameters::number_of_iterations(rounds).vertex_normal_map(normal_map(mesh)));
}

template <class Description, class Tag = CGAL::Sequential_tag>
void refine_linearly(Surface_mesh& mesh, unsigned rounds)
{
  CGAL::PN_subdivision_3::subdivide<Tag>(mesh,
                                         CGAL::PN_subdivision_3::linear(Description::scheme()),
                                         CGAL::parameters::number_of_iterations(rounds));
}

// --- a result as plain data ---

struct Result
{
  reference::Values values;
  std::vector<reference::Face> faces;
};

inline reference::Face_list face_list(const Surface_mesh& mesh)
{
  std::vector<reference::Face> faces;
  for (auto f : mesh.faces()) {
    faces.emplace_back();
    for (auto v : mesh.vertices_around_face(mesh.halfedge(f))) faces.back().push_back(int(v.idx()));
  }
  std::vector<reference::Edge> edges;
  for (auto e : mesh.edges())
    edges.emplace_back(int(mesh.vertex(e, 0).idx()), int(mesh.vertex(e, 1).idx()));
  return reference::Face_list(int(mesh.number_of_vertices()), faces, edges);
}

inline Result result_of(Surface_mesh& mesh)
{
  mesh.collect_garbage(); // CGAL's Doo-Sabin leaves some
  Result result;
  const Normal_map normals = normal_map(mesh);
  for (auto v : mesh.vertices()) {
    const Kernel::Point_3& p = mesh.point(v);
    const Kernel::Vector_3& n = normals[v];
    result.values.points.emplace_back(p.x(), p.y(), p.z());
    result.values.normals.emplace_back(n.x(), n.y(), n.z());
  }
  result.faces = face_list(mesh).faces();
  return result;
}

enum class Rule { linear, pn };

// The reference form, on the mesh as it is; the order of new vertices is the documented one.
template <class Description>
Result reference_result(Surface_mesh& mesh, unsigned rounds, Rule rule)
{
  Result result = result_of(mesh);
  reference::Face_list level = face_list(mesh);
  for (unsigned k = 1; k <= rounds; ++k) {
    const reference::Refined refined = Description::refine(level, k);
    const reference::Matrix weights = refined.weights(level.number_of_vertices());
    result.values =
      rule == Rule::pn ? pn_round(weights, result.values) : linear_round(weights, result.values);
    if (rule == Rule::pn) Description::finish_round(level, result.values);
    result.faces = refined.faces;
    level = reference::Face_list(int(refined.points.size()), refined.faces);
  }
  return result;
}

// --- comparison ---

inline double size_of(const reference::Values& values)
{
  reference::Real size = 1;
  for (const reference::Vector& p : values.points) size = (std::max)(size, p.cwiseAbs().maxCoeff());
  return double(size);
}

// From the least vertex on, so that faces compare as cycles.
inline std::multiset<reference::Face> cycles(std::vector<reference::Face> faces)
{
  for (reference::Face& f : faces)
    std::rotate(f.begin(), std::min_element(f.begin(), f.end()), f.end());
  return {faces.begin(), faces.end()};
}

// The vertex of b at each point of a; -1 where there is none or it is taken.
inline std::vector<int> match_by_position(const Result& a, const Result& b)
{
  const double reach = 1e-9 * size_of(a.values);
  std::multimap<reference::Real, int> by_x;
  for (std::size_t i = 0; i < b.values.points.size(); ++i)
    by_x.emplace(b.values.points[i][0], int(i));
  std::vector<int> match;
  for (const reference::Vector& p : a.values.points) {
    auto best = by_x.end();
    reference::Real least = reach;
    for (auto it = by_x.lower_bound(p[0] - reach); it != by_x.upper_bound(p[0] + reach); ++it) {
      const reference::Real d = (b.values.points[std::size_t(it->second)] - p).norm();
      if (d < least) {
        least = d;
        best = it;
      }
    }
    match.push_back(best == by_x.end() ? -1 : best->second);
    if (best != by_x.end()) by_x.erase(best);
  }
  return match;
}

struct Difference
{
  double points = 0, normals = 0;
  std::string topology; // empty: the same faces
};

inline Difference difference(const Result& a, const Result& b, const std::vector<int>& match)
{
  Difference d;
  if (a.values.points.size() != b.values.points.size())
    d.topology = std::to_string(a.values.points.size()) + " and " +
                 std::to_string(b.values.points.size()) + " vertices";
  else if (std::count(match.begin(), match.end(), -1) != 0)
    d.topology =
      std::to_string(std::count(match.begin(), match.end(), -1)) + " vertices without a partner";
  if (!d.topology.empty()) return d;
  for (std::size_t i = 0; i < match.size(); ++i) {
    const std::size_t j = std::size_t(match[i]);
    const double p = double((a.values.points[i] - b.values.points[j]).norm());
    const double n = double((a.values.normals[i] - b.values.normals[j]).norm());
    if (!(p <= d.points)) d.points = p;
    if (!(n <= d.normals)) d.normals = n;
  }
  d.points /= size_of(a.values);
  std::vector<reference::Face> renumbered = a.faces;
  for (reference::Face& f : renumbered)
    for (int& v : f) v = match[std::size_t(v)];
  if (cycles(renumbered) != cycles(b.faces)) d.topology = "different faces";
  return d;
}

// Vertices by position, faces as cycles.
inline Difference difference(const Result& a, const Result& b)
{
  return difference(a, b, match_by_position(a, b));
}

// Vertices by index.
inline Difference difference_by_index(const Result& a, const Result& b)
{
  std::vector<int> same(a.values.points.size());
  for (std::size_t i = 0; i < same.size(); ++i) same[i] = int(i);
  return difference(a, b, same);
}

inline testing::AssertionResult is_within(const Difference& d, double tolerance)
{
  if (d.topology.empty() && d.points <= tolerance && d.normals <= tolerance)
    return testing::AssertionSuccess();
  return testing::AssertionFailure()
         << "points " << d.points << ", normals " << d.normals << ", " << d.topology;
}

// Every coordinate, every normal, all of the connectivity, bit for bit.
inline bool is_identical(Surface_mesh& a, Surface_mesh& b)
{
  if (a.number_of_vertices() != b.number_of_vertices() ||
      a.number_of_halfedges() != b.number_of_halfedges() ||
      a.number_of_faces() != b.number_of_faces())
    return false;
  const Normal_map na = normal_map(a), nb = normal_map(b);
  for (auto v : a.vertices())
    if (a.point(v) != b.point(v) || na[v] != nb[v] || a.halfedge(v) != b.halfedge(v)) return false;
  for (auto h : a.halfedges())
    if (a.target(h) != b.target(h) || a.next(h) != b.next(h) || a.face(h) != b.face(h))
      return false;
  for (auto f : a.faces())
    if (a.halfedge(f) != b.halfedge(f)) return false;
  return true;
}

// --- validity ---

// An oriented 2-manifold with border, with all that CGAL expects of its pointers.
inline testing::AssertionResult is_valid_manifold(const Surface_mesh& mesh)
{
  const auto wrong = [](const char* what, auto index) {
    return testing::AssertionFailure() << what << " " << index;
  };
  std::vector<std::size_t> incoming(mesh.number_of_vertices(), 0);
  for (auto h : mesh.halfedges()) {
    if (mesh.next(mesh.prev(h)) != h || mesh.prev(mesh.next(h)) != h)
      return wrong("next and prev of", h);
    if (mesh.target(h) != mesh.source(mesh.next(h))) return wrong("ends of", h);
    if (mesh.target(h) == mesh.source(h)) return wrong("loop", h);
    if (mesh.face(h) != mesh.face(mesh.next(h))) return wrong("face of", h);
    if (mesh.is_border(h) && mesh.is_border(mesh.opposite(h))) return wrong("edge without face", h);
    ++incoming[mesh.target(h).idx()];
  }
  for (auto f : mesh.faces()) {
    if (mesh.face(mesh.halfedge(f)) != f) return wrong("half-edge of", f);
    std::set<Surface_mesh::Vertex_index> corners;
    for (auto v : mesh.vertices_around_face(mesh.halfedge(f)))
      if (!corners.insert(v).second) return wrong("vertex twice in", f);
    if (corners.size() < 3) return wrong("degree of", f);
  }
  for (auto v : mesh.vertices()) {
    const auto first = mesh.halfedge(v);
    if (incoming[v.idx()] == 0) {
      if (first != Surface_mesh::null_halfedge()) return wrong("half-edge of isolated", v);
      continue;
    }
    if (mesh.target(first) != v) return wrong("half-edge of", v);
    std::size_t around = 0, gaps = 0;
    auto h = first;
    do {
      ++around;
      gaps += mesh.is_border(h);
      h = mesh.next_around_target(h);
    } while (h != first);
    if (around != incoming[v.idx()] || gaps > 1) return wrong("several fans at", v);
    if (gaps == 1 && !mesh.is_border(first)) return wrong("no border half-edge at", v);
  }
  return testing::AssertionSuccess();
}

inline long euler_characteristic(const Surface_mesh& mesh)
{
  return long(mesh.number_of_vertices()) - long(mesh.number_of_edges()) +
         long(mesh.number_of_faces());
}

#endif // CGAL_PN_SUBDIVISION_3_TEST_SCHEME_RUNS_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// One round of Catmull-Clark or Loop, or their modified forms, with creases, by the meaning of the rules: values belong to the
// corners of faces, rows are sums over faces, wedges are what can be reached without passing a crease.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_CREASES_H
#define CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_CREASES_H

#include "Crease_rule.h"
#include "Face_list.h"
#include "PN_rule.h"
#include "modified_CatmullClark.h"
#include "modified_Loop.h"

#include <set>

namespace reference {

using Corner = std::pair<int, int>; // (face, vertex)

inline Edge undirected(int a, int b)
{
  return {(std::min)(a, b), (std::max)(a, b)};
}

// A mesh with sharp edges and vertices. Border edges that are creases are among the sharp ones.
struct Creased_mesh
{
  Face_list mesh;
  std::vector<Vector> points;
  std::map<Corner, Vector> normals;
  std::map<Corner, Real> roundness; // 1 where there is none
  std::map<Edge, Real> sharp_edges; // undirected
  std::map<int, Real> sharp_vertices;
  std::map<Edge, Vector> tangents; // of (v, a) at v towards a
  bool is_linear = false;
  bool has_fixed_border = false;

  Real sharpness(int a, int b) const
  {
    const auto it = sharp_edges.find(undirected(a, b));
    return it == sharp_edges.end() ? 0 : it->second;
  }
  Real sharpness(int v) const
  {
    const auto it = sharp_vertices.find(v);
    return it == sharp_vertices.end() ? 0 : it->second;
  }
  const Vector& point(int v) const { return points[std::size_t(v)]; }
  const Vector& normal(const Corner& c) const { return normals.at(c); }
  Real round(const Corner& c) const
  {
    const auto it = roundness.find(c);
    return it == roundness.end() ? 1 : it->second;
  }
  const Vector& tangent(int v, int a) const { return tangents.at({v, a}); }
};

inline std::vector<int> sharp_neighbors(const Creased_mesh& mesh, int v)
{
  std::vector<int> result;
  for (const int u : mesh.mesh.ring(v))
    if (mesh.sharpness(v, u) > 0) result.push_back(u);
  return result;
}
inline bool is_crease_vertex(const Creased_mesh& mesh, int v)
{
  const std::vector<int> a = sharp_neighbors(mesh, v);
  if (a.size() != 2 || mesh.sharpness(v) > 0) return false;
  return !mesh.mesh.is_border(v) || (mesh.mesh.is_border(v, a[0]) && mesh.mesh.is_border(v, a[1]));
}

inline Real after_round(Real s)
{
  return (std::max)(s - 1, Real(0));
}

// for each face at v the wedge that it is in, if edges vu are passed where pass(u)
template <class Pass>
std::map<int, int> wedges_at(const Face_list& mesh, int v, const Pass& pass)
{
  std::map<int, int> wedge;
  for (const int u : mesh.ring(v))
    if (mesh.face(v, u) >= 0) wedge.emplace(mesh.face(v, u), int(wedge.size()));
  for (std::size_t i = 0; i < wedge.size(); ++i)
    for (const int u : mesh.ring(v)) {
      const int f = mesh.face(v, u), g = mesh.face(u, v);
      if (f < 0 || g < 0 || !pass(u)) continue;
      const int least = (std::min)(wedge[f], wedge[g]);
      wedge[f] = wedge[g] = least;
    }
  return wedge;
}
inline std::map<int, int> wedges_at(const Creased_mesh& mesh, int v)
{
  return wedges_at(mesh.mesh, v, [&](int u) { return !(mesh.sharpness(v, u) > 0); });
}

inline Vector unit_vector(const Vector& v)
{
  return v.norm() < 1e-12L ? Vector(Vector::Zero()) : Vector(v / v.norm());
}
inline Vector mean_direction(const std::map<int, Vector>& parts)
{
  Vector sum = Vector::Zero();
  for (const auto& part : parts) sum += part.second;
  return unit_vector(sum);
}

// Calls f(face) for the faces at v that touch an edge at v which ends there, in the wedge that is joined over it:
// large(face) is that wedge, ends(u) says whether the edge vu ends.
template <class Ends, class Function>
void for_each_touching_face(const Face_list& mesh, int v, const std::map<int, int>& large,
                            const Ends& ends, const Function& f)
{
  std::set<int> joined;
  for (const int u : mesh.ring(v))
    if (!mesh.is_border(v, u) && ends(u)) joined.insert(large.at(mesh.face(v, u)));
  for (const auto& [face, wedge] : large)
    if (joined.count(wedge) != 0) f(face);
}

// sets w in whole wedges
inline void set_roundness(Creased_mesh& mesh, const std::set<Corner>& corners, Real w)
{
  for (const auto& [face, v] : corners) {
    const std::map<int, int> wedge = wedges_at(mesh, v);
    for (const auto& [other, number] : wedge)
      if (number == wedge.at(face)) mesh.roundness[{other, v}] = w;
  }
}

enum class Kind { smooth, crease, corner };

// Weights of corners. Those of one vertex may differ in their normals only.
using Corner_row = std::map<Corner, Real>;

inline void add(Corner_row& row, const Corner_row& other, Real factor)
{
  for (const auto& [corner, w] : other) row[corner] += factor * w;
}

class Crease_round
{
public:
  Crease_round(const Creased_mesh& old, bool is_loop, bool is_modified = false)
    : old_(old)
    , mesh_(old.mesh)
    , is_loop_(is_loop)
  {
    if (is_modified)
      for (int i = 0; i < mesh_.number_of_vertices(); ++i) tune(i);
    const int v = mesh_.number_of_vertices(), e = int(mesh_.edges().size());
    for (int i = 0; i < e; ++i) {
      const auto& [a, b] = mesh_.edges()[std::size_t(i)];
      on_edge_[{a, b}] = on_edge_[{b, a}] = v + i;
    }
    result_.is_linear = old.is_linear;
    result_.has_fixed_border = old.has_fixed_border;
    result_.points.resize(std::size_t(v + e + (is_loop ? 0 : mesh_.number_of_faces())));
    make_faces();
    for (int i = 0; i < v; ++i) make_vertex(i);
    for (const auto& [a, b] : mesh_.edges()) make_edge(a, b);
    if (!is_loop)
      for (int f = 0; f < mesh_.number_of_faces(); ++f)
        set_point_normal(v + e + f, average(face_row(f)));
    if (old.is_linear)
      result_.roundness.clear();
    else
      flatten();
  }

  const Creased_mesh& result() const { return result_; }

  // the corners whose values a new vertex depends on
  std::set<Corner> reads(int v) const
  {
    const int n = mesh_.number_of_vertices(), e = int(mesh_.edges().size());
    std::set<Corner> corners;
    const auto add_row = [&](const Corner_row& row) {
      for (const auto& entry : row) corners.insert(entry.first);
    };
    const auto add_all = [&](int u) {
      for (const int f : faces_at(u)) corners.insert({f, u});
    };
    if (v >= n + e)
      add_row(face_row(v - n - e));
    else if (v >= n) {
      const auto& [a, b] = mesh_.edges()[std::size_t(v - n)];
      if (old_.sharpness(a, b) > 0)
        for (const int u : {a, b}) add_row(beside(u, u == a ? b : a));
      else
        add_row(edge_row(a, b));
    } else if (kind(v, false) == Kind::smooth) {
      const auto tuned = tuned_vertex_.find(v);
      if (!mesh_.ring(v).empty())
        add_row(tuned == tuned_vertex_.end() ? smooth_vertex(v) : tuned->second);
    } else {
      add_all(v);
      if (kind(v, false) == Kind::crease)
        for (const int u : crease_neighbors(v, false)) add_row(beside(u, v));
    }
    return corners;
  }

private:
  static Real limited(Real s) { return (std::min)(Real(1), s); }

  // \name Wedges
  template <class Pass>
  std::map<int, int> wedges(int v, const Pass& pass) const
  {
    return wedges_at(mesh_, v, pass);
  }
  std::map<int, int> wedges(int v) const
  {
    return wedges(v, [&](int u) { return !(old_.sharpness(v, u) > 0); });
  }
  std::vector<int> crease_neighbors(int v, bool afterwards) const
  {
    std::vector<int> result;
    for (const int u : mesh_.ring(v)) {
      const Real s = old_.sharpness(v, u);
      if ((afterwards ? after_round(s) : s) > 0) result.push_back(u);
    }
    return result;
  }
  Kind kind(int v, bool afterwards) const
  {
    const Real s = old_.sharpness(v);
    const std::vector<int> a = crease_neighbors(v, afterwards);
    bool inner = false;
    for (const int u : a) inner = inner || !mesh_.is_border(v, u);
    if ((afterwards ? after_round(s) : s) > 0 || a.size() > 2 || (mesh_.is_border(v) && inner))
      return Kind::corner;
    return a.size() == 2 ? Kind::crease : Kind::smooth;
  }

  // \name The schemes' own rules, as sums over faces
  Corner_row centroid(int f) const
  {
    Corner_row row;
    const Face& face = mesh_.faces()[std::size_t(f)];
    for (const int v : face) row[{f, v}] += 1 / Real(face.size());
    return row;
  }
  std::vector<int> faces_at(int v) const
  {
    std::vector<int> result;
    for (const int u : mesh_.ring(v))
      if (mesh_.face(v, u) >= 0) result.push_back(mesh_.face(v, u));
    return result;
  }
  Corner_row itself(int v) const
  {
    Corner_row row;
    const std::vector<int> faces = faces_at(v);
    for (const int f : faces) row[{f, v}] += 1 / Real(faces.size());
    return row;
  }
  // vertex u, half from either face at the edge uv
  Corner_row beside(int u, int v) const
  {
    Corner_row row;
    std::vector<int> faces;
    for (const int f : {mesh_.face(u, v), mesh_.face(v, u)})
      if (f >= 0) faces.push_back(f);
    for (const int f : faces) row[{f, u}] += 1 / Real(faces.size());
    return row;
  }

  Corner_row smooth_edge(int a, int b) const
  {
    Corner_row row;
    if (mesh_.is_border(a, b)) {
      add(row, beside(a, b), Real(0.5));
      add(row, beside(b, a), Real(0.5));
    } else if (is_loop_) {
      add(row, beside(a, b), Real(0.375));
      add(row, beside(b, a), Real(0.375));
      row[{mesh_.face(a, b), mesh_.after(a, b)}] += Real(0.125);
      row[{mesh_.face(b, a), mesh_.after(b, a)}] += Real(0.125);
    } else {
      add(row, beside(a, b), Real(0.25));
      add(row, beside(b, a), Real(0.25));
      add(row, centroid(mesh_.face(a, b)), Real(0.25));
      add(row, centroid(mesh_.face(b, a)), Real(0.25));
    }
    return row;
  }
  Corner_row smooth_vertex(int v) const
  {
    Corner_row row;
    const std::vector<int> ring = mesh_.ring(v);
    const Real n = Real(ring.size());
    if (mesh_.is_border(v)) {
      add(row, itself(v), Real(0.75));
      add(row, beside(ring.front(), v), Real(0.125));
      add(row, beside(ring.back(), v), Real(0.125));
    } else if (is_loop_) {
      const Real root = 3 + 2 * cosine(1 / n), alpha = (40 - root * root) / 64;
      add(row, itself(v), 1 - alpha);
      for (const int u : ring) add(row, beside(u, v), alpha / n);
    } else {
      for (const int u : ring) {
        add(row, centroid(mesh_.face(v, u)), 1 / (n * n));
        add(row, itself(v), 1 / (n * n));
        add(row, beside(u, v), 1 / (n * n));
      }
      add(row, itself(v), (n - 3) / n);
    }
    return row;
  }

  // \name The modified rules
  // Vertices at creases and corners are no extraordinary ones; darts count beside others, but have no
  // rules of their own.
  bool is_dart(int v) const
  {
    return kind(v, false) == Kind::smooth && !crease_neighbors(v, false).empty();
  }
  bool counts_as_extraordinary(int v) const
  {
    return !mesh_.is_border(v) && kind(v, false) == Kind::smooth &&
           mesh_.ring(v).size() != (is_loop_ ? 6u : 4u);
  }
  bool is_separated(int v) const
  {
    if (!counts_as_extraordinary(v) || is_dart(v) || mesh_.ring(v).size() < 3) return false;
    for (const int f : faces_at(v)) {
      const Face& face = mesh_.faces()[std::size_t(f)];
      if (face.size() != (is_loop_ ? 3u : 4u)) return false;
      for (const int u : face)
        if (u != v && counts_as_extraordinary(u)) return false;
    }
    return true;
  }
  void tune(int v)
  {
    if (mesh_.ring(v).empty() || !is_separated(v)) return;
    const std::vector<int> ring = mesh_.ring(v);
    const int n = int(ring.size());
    const Matrix& s =
      is_loop_ ? modified_loop_ring(n, Real(0.5)) : modified_catmull_clark_ring(n, Real(0.5));
    std::vector<Corner_row> old{itself(v)};
    for (const int u : ring) old.push_back(beside(u, v));
    if (!is_loop_)
      for (const int u : ring) old.push_back({{{mesh_.face(v, u), mesh_.after(v, u)}, Real(1)}});
    std::vector<Corner_row> rows(old.size());
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (std::size_t j = 0; j < old.size(); ++j)
        add(rows[i], old[j], s(Eigen::Index(i), Eigen::Index(j)));
    tuned_vertex_[v] = rows[0];
    for (std::size_t i = 0; i < ring.size(); ++i) {
      tuned_edge_[undirected(v, ring[i])] = rows[1 + i];
      if (!is_loop_) tuned_face_[mesh_.face(v, ring[i])] = rows[1 + ring.size() + i];
    }
  }
  Corner_row edge_row(int a, int b) const
  {
    const auto it = tuned_edge_.find(undirected(a, b));
    return it == tuned_edge_.end() ? smooth_edge(a, b) : it->second;
  }
  Corner_row face_row(int f) const
  {
    const auto it = tuned_face_.find(f);
    return it == tuned_face_.end() ? centroid(f) : it->second;
  }

  struct Average : Point_normal
  {
    Real round;
  };
  Average average(const Corner_row& row) const
  {
    Values values;
    Row weights(Eigen::Index(row.size()));
    Eigen::Index j = 0;
    Vector q = Vector::Zero();
    Real round = 0;
    for (const auto& [corner, w] : row) {
      weights[j++] = w;
      q += w * old_.point(corner.second);
      round += w * old_.round(corner);
      values.points.push_back(old_.point(corner.second));
      values.normals.push_back(old_.is_linear ? Vector(Vector::Zero()) : old_.normal(corner));
    }
    Average result{pn_rule(weights, weights, values), round};
    result.point = q + round * (result.point - q);
    return result;
  }

  // \name New vertices
  // what a rule gives for a vertex: a point, a normal for each of its faces, and tangents
  struct Star
  {
    Vector point;
    std::map<int, Vector> normals;
    std::map<int, Real> rounds;
    std::map<int, Vector> tangents; // by the neighbor
  };

  Star vertex_by_rule(int v, bool afterwards) const
  {
    Star star;
    const Kind rule = kind(v, afterwards);
    const std::vector<int> along = crease_neighbors(v, afterwards);
    if (rule == Kind::corner) {
      star.point = old_.point(v);
      for (const int f : faces_at(v)) {
        star.normals[f] = old_.normal({f, v});
        star.rounds[f] = old_.round({f, v});
      }
      for (const int u : along) star.tangents[u] = old_.tangent(v, u);
    } else if (rule == Kind::crease)
      crease_vertex(v, along[0], along[1], star);
    else {
      const auto tuned = tuned_vertex_.find(v);
      const Average value =
        average(tuned == tuned_vertex_.end() ? smooth_vertex(v) : tuned->second);
      star.point = value.point;
      for (const int f : faces_at(v)) {
        star.normals[f] = value.normal;
        star.rounds[f] = value.round;
      }
      for (const int u : along) {
        const Vector t = old_.tangent(v, u);
        star.tangents[u] = unit_vector(t - t.dot(value.normal) * value.normal);
      }
    }
    return star;
  }

  void crease_vertex(int v, int a, int b, Star& star) const
  {
    Crease_entries entries;
    entries.weights = {Real(0.125), Real(0.125), Real(0.75)};
    entries.points = {old_.point(a), old_.point(b), old_.point(v)};
    entries.tangents = {old_.tangent(a, v), -old_.tangent(b, v), old_.tangent(v, b)};
    if (old_.is_linear) entries.tangents.assign(3, Vector::Zero());
    const Crease_rule rule(entries);
    const std::map<int, int> wedge = wedges(v);
    star.tangents[a] = -rule.tangent();
    star.tangents[b] = rule.tangent();
    star.point = rule.point(1);
    if (old_.is_linear) {
      for (const int f : faces_at(v)) star.normals[f] = Vector::Zero();
      return;
    }
    Real all = 0;
    for (const int f : faces_at(v)) {
      const auto in_wedge = [&](int u) { // the face beside vu in the wedge of f
        for (const int g : {mesh_.face(v, u), mesh_.face(u, v)})
          if (g >= 0 && wedge.at(g) == wedge.at(f)) return g;
        throw std::logic_error("reference::Crease_round: no face of the wedge at the crease");
      };
      const Corner at_a{in_wedge(a), a}, at_b{in_wedge(b), b}, at_v{f, v};
      star.normals[f] = rule.normal({old_.normal(at_a), old_.normal(at_b), old_.normal(at_v)});
      star.rounds[f] =
        Real(0.125) * (old_.round(at_a) + old_.round(at_b)) + Real(0.75) * old_.round(at_v);
      all = std::max(all, star.rounds[f]);
    }
    star.point = rule.point(all); // a crease is as round as the rounder side
  }

  void make_vertex(int v)
  {
    if (mesh_.ring(v).empty()) {
      result_.points[std::size_t(v)] = old_.point(v);
      return;
    }
    Star star = vertex_by_rule(v, false);
    if (old_.is_linear && kind(v, false) != kind(v, true)) blend_with_child(v, star);
    if (!old_.is_linear && kind(v, false) == Kind::corner && kind(v, true) == Kind::crease) {
      // one direction of travel
      const std::vector<int> along = crease_neighbors(v, true);
      const Vector t = unit_vector(star.tangents.at(along[1]) - star.tangents.at(along[0]));
      star.tangents[along[1]] = t;
      star.tangents[along[0]] = -t;
    }
    // edges that end join wedges: the sum over the old wedges of each new one
    const std::map<int, int> small = wedges(v);
    const std::map<int, int> large =
      wedges(v, [&](int u) { return !(after_round(old_.sharpness(v, u)) > 0); });
    std::map<int, std::map<int, Vector>> parts;
    for (const int f : faces_at(v)) parts[large.at(f)][small.at(f)] = star.normals.at(f);
    std::map<int, Vector> normals;
    for (const int f : faces_at(v)) {
      const auto& own = parts[large.at(f)];
      normals[f] = own.size() == 1 ? own.begin()->second : mean_direction(own);
    }
    result_.points[std::size_t(v)] = star.point;
    for (const int f : faces_at(v)) {
      result_.normals[{child_.at({f, v}), v}] = normals[f];
      result_.roundness[{child_.at({f, v}), v}] = star.rounds[f];
    }
    for (const int u : crease_neighbors(v, true))
      result_.tangents[{v, on_edge_.at({v, u})}] = star.tangents.at(u);
    if (after_round(old_.sharpness(v)) > 0)
      result_.sharp_vertices[v] = after_round(old_.sharpness(v));
  }

  void blend_with_child(int v, Star& star) const
  {
    const Star child = vertex_by_rule(v, true);
    Real sum = 0;
    int number = 0;
    std::vector<Real> all{old_.sharpness(v)};
    for (const int u : mesh_.ring(v)) all.push_back(old_.sharpness(v, u));
    for (const Real s : all)
      if (s > 0 && after_round(s) == 0) {
        sum += s;
        ++number;
      }
    const Real f = limited(sum / number);
    star.point = f * star.point + (1 - f) * child.point;
  }

  void make_edge(int a, int b)
  {
    const int m = on_edge_.at({a, b});
    const Real s = old_.sharpness(a, b);
    if (!(s > 0)) return set_point_normal(m, average(edge_row(a, b)));
    const int f = mesh_.face(a, b), g = mesh_.face(b, a);
    Crease_entries entries;
    entries.weights = {Real(0.5), Real(0.5)};
    entries.points = {old_.point(a), old_.point(b)};
    entries.tangents = {old_.tangent(a, b), -old_.tangent(b, a)};
    if (old_.is_linear) entries.tangents.assign(2, Vector::Zero());
    const Crease_rule rule(entries);
    const auto round = [&](int face) {
      return face < 0 ? 0 : (old_.round({face, a}) + old_.round({face, b})) / 2;
    };
    Vector point = rule.point(std::max(round(f), round(g)));
    std::map<int, Vector> normals;
    for (const int face : {f, g})
      if (face >= 0)
        normals[face] = old_.is_linear
                          ? Vector(Vector::Zero())
                          : rule.normal({old_.normal({face, a}), old_.normal({face, b})});
    if (old_.is_linear && s < 1) point = s * point + (1 - s) * average(smooth_edge(a, b)).point;
    const Real child = after_round(s);
    if (child == 0) {
      const Vector joined = unit_vector(normals[f] + normals[g]);
      normals[f] = normals[g] = joined;
    }
    result_.points[std::size_t(m)] = point;
    for (const auto& [face, n] : normals) set_corners(face, a, b, m, n, round(face));
    if (child == 0) return;
    for (const int end : {a, b}) {
      result_.sharp_edges[undirected(end, m)] = child;
      result_.tangents[{m, end}] = end == b ? rule.tangent() : Vector(-rule.tangent());
    }
    if (old_.has_fixed_border && mesh_.is_border(a, b)) result_.sharp_vertices[m] = child;
  }

  // \name New faces
  void make_faces()
  {
    std::vector<Face> faces;
    for (int f = 0; f < mesh_.number_of_faces(); ++f) {
      const Face& face = mesh_.faces()[std::size_t(f)];
      const std::size_t m = face.size();
      const int center = mesh_.number_of_vertices() + int(mesh_.edges().size()) + f;
      Face middle;
      for (std::size_t i = 0; i < m; ++i) {
        const int before = on_edge_.at({face[(i + m - 1) % m], face[i]}),
                  after = on_edge_.at({face[i], face[(i + 1) % m]});
        child_[{f, face[i]}] = int(faces.size());
        faces.push_back(is_loop_ ? Face{face[i], after, before}
                                 : Face{face[i], after, center, before});
        middle.push_back(after);
      }
      middle_.push_back(int(faces.size()));
      if (is_loop_) faces.push_back(middle);
    }
    result_.mesh = Face_list(int(result_.points.size()), faces);
  }
  // the corners at the vertex m on the edge ab of the face
  void set_corners(int face, int a, int b, int m, const Vector& n, Real w)
  {
    const auto set = [&](int child) {
      result_.normals[{child, m}] = n;
      result_.roundness[{child, m}] = w;
    };
    for (const int end : {a, b}) set(child_.at({face, end}));
    if (is_loop_) set(middle_[std::size_t(face)]);
  }
  // what ends is not round
  void flatten()
  {
    std::set<Corner> corners;
    for (int v = 0; v < mesh_.number_of_vertices(); ++v) {
      const auto remains = [&](int u) { return after_round(old_.sharpness(v, u)) > 0; };
      for_each_touching_face(
        mesh_, v, wedges(v, [&](int u) { return !remains(u); }),
        [&](int u) { return old_.sharpness(v, u) > 0 && !remains(u); },
        [&](int face) {
          const int child = child_.at({face, v});
          for (const int u : result_.mesh.faces()[std::size_t(child)]) corners.insert({child, u});
        });
    }
    set_roundness(result_, corners, 0);
  }
  void set_point_normal(int v, const Average& value)
  {
    result_.points[std::size_t(v)] = value.point;
    for (const int u : result_.mesh.ring(v))
      if (result_.mesh.face(v, u) >= 0) {
        result_.normals[{result_.mesh.face(v, u), v}] = value.normal;
        result_.roundness[{result_.mesh.face(v, u), v}] = value.round;
      }
  }

  const Creased_mesh& old_;
  const Face_list& mesh_;
  bool is_loop_;
  Creased_mesh result_;
  std::map<Edge, int> on_edge_;
  std::map<Corner, int> child_; // the face at a corner
  std::vector<int> middle_;
  std::map<int, Corner_row> tuned_vertex_, tuned_face_;
  std::map<Edge, Corner_row> tuned_edge_;
};

} // namespace reference

#endif // CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_CREASES_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// A polygon mesh as a plain list of faces. The reference forms of the schemes are written on it,
// with nothing of the package: a point is a row of weights over the old vertices, and the textbook
// constructions (mean of a face, point beyond an edge) are carried out on such rows.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_FACE_LIST_H
#define CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_FACE_LIST_H

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <unordered_map>
#include <utility>
#include <vector>

namespace reference {

using Real = long double;
using Row = Eigen::Matrix<Real, 1, Eigen::Dynamic>;
using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Face = std::vector<int>;
using Edge = std::pair<int, int>;

class Face_list
{
public:
  Face_list() = default;

  // `edges` gives the order of the edges; without it they come in the order of the faces.
  Face_list(int number_of_vertices, std::vector<Face> faces, std::vector<Edge> edges = {})
    : number_of_vertices_(number_of_vertices)
    , faces_(std::move(faces))
    , edges_(std::move(edges))
    , some_neighbor_(std::size_t(number_of_vertices), -1)
  {
    for (int f = 0; f < int(faces_.size()); ++f) read_face(f);
    if (edges_.empty())
      for (const Face& face : faces_)
        for (std::size_t i = 0; i < face.size(); ++i) {
          const int a = face[i], b = face[(i + 1) % face.size()];
          if (a < b || this->face(b, a) < 0) edges_.emplace_back(a, b);
        }
  }

  int number_of_vertices() const { return number_of_vertices_; }
  int number_of_faces() const { return int(faces_.size()); }
  const std::vector<Face>& faces() const { return faces_; }
  const std::vector<Edge>& edges() const { return edges_; }

  // The face that has the side a -> b, -1 if there is none; its corner before a and that after b.
  int face(int a, int b) const
  {
    const auto it = face_of_side_.find(side(a, b));
    return it == face_of_side_.end() ? -1 : it->second;
  }
  int before(int a, int b) const { return corner(a, b, -1); }
  int after(int a, int b) const { return corner(a, b, 2); }

  bool is_border(int a, int b) const { return face(a, b) < 0 || face(b, a) < 0; }

  // The neighbors counter-clockwise, on the border from one border neighbor to the other.
  std::vector<int> ring(int v) const
  {
    std::vector<int> result;
    int first = some_neighbor_[std::size_t(v)];
    if (first < 0) return result;
    while (face(first, v) >= 0) { // go clockwise to the border, if there is one
      const int u = after(first, v);
      if (u == some_neighbor_[std::size_t(v)]) break;
      first = u;
    }
    int u = first;
    do {
      result.push_back(u);
      if (face(v, u) < 0) break;
      u = before(v, u);
    } while (u != first);
    return result;
  }
  bool is_border(int v) const
  {
    const std::vector<int> neighbors = ring(v);
    return !neighbors.empty() && face(v, neighbors.back()) < 0;
  }
  bool is_interior_of_valence_other_than(int n, int v) const
  {
    return !is_border(v) && int(ring(v).size()) != n;
  }

  // The border vertex that follows v when one comes from u along the border.
  int next_on_border(int u, int v) const
  {
    const std::vector<int> neighbors = ring(v);
    return neighbors.front() == u ? neighbors.back() : neighbors.front();
  }

  Row point(int v) const { return Row::Unit(number_of_vertices_, v); }
  Row zero() const { return Row::Zero(number_of_vertices_); }
  Row mean(const std::vector<int>& vertices) const
  {
    Row sum = zero();
    for (int v : vertices) sum[v] += 1;
    return sum / Real(vertices.size());
  }
  Row centroid(int f) const { return mean(faces_[std::size_t(f)]); }

private:
  static std::int64_t side(int a, int b) { return (std::int64_t(a) << 32) + b; }

  void read_face(int f)
  {
    const Face& face = faces_[std::size_t(f)];
    for (std::size_t i = 0; i < face.size(); ++i) {
      const int a = face[i], b = face[(i + 1) % face.size()];
      if (!face_of_side_.emplace(side(a, b), f).second)
        throw std::invalid_argument("reference::Face_list: two faces on one side of an edge");
      some_neighbor_[std::size_t(a)] = b;
    }
  }

  int corner(int a, int b, int shift) const
  {
    const Face& face = faces_[std::size_t(this->face(a, b))];
    const int m = int(face.size());
    for (int i = 0; i < m; ++i)
      if (face[std::size_t(i)] == a && face[std::size_t((i + 1) % m)] == b)
        return face[std::size_t((i + m + shift) % m)];
    throw std::logic_error("reference::Face_list: no such side");
  }

  int number_of_vertices_ = 0;
  std::vector<Face> faces_;
  std::vector<Edge> edges_;
  std::vector<int> some_neighbor_;
  std::unordered_map<std::int64_t, int> face_of_side_;
};

// One round of a linear scheme: the weights of every new vertex over the old ones, and the new
// faces.
struct Refined
{
  std::vector<Row> points;
  std::vector<Face> faces;

  int add(const Row& row)
  {
    points.push_back(row);
    return int(points.size()) - 1;
  }
  Matrix weights(int number_of_old_vertices) const
  {
    Matrix m(Eigen::Index(points.size()), number_of_old_vertices);
    for (std::size_t i = 0; i < points.size(); ++i) m.row(Eigen::Index(i)) = points[i];
    return m;
  }
};

inline Real cosine(Real turns)
{
  return std::cos(2 * std::acos(Real(-1)) * turns);
}

} // namespace reference

#endif // CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_FACE_LIST_H

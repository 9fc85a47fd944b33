// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_OBJ_NORMALS_H
#define PN_SUBDIVIDE_OBJ_NORMALS_H

#include "io/Error.h"
#include "io/Mesh_data.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace pn_subdivide {

// OBJ gives normals to the corners of faces; a vertex takes the normalized sum of the different
// normals at its corners, and a single one as it is.
class Obj_normals
{
public:
  std::size_t number_of_normals() const { return normals_.size(); }
  void add_normal(const Triple& n) { normals_.push_back(n); }

  void add_corner(Mesh_data::Index vertex, std::size_t normal, std::size_t line)
  {
    corners_.push_back({vertex, normal, line});
  }

  // Empty if the file has no normals; zero for vertices that are given none.
  std::vector<Triple> per_vertex(std::size_t number_of_vertices)
  {
    if (corners_.empty()) return in_order(number_of_vertices);
    for (const Corner& c : corners_)
      if (c.normal >= normals_.size())
        throw Error("line " + std::to_string(c.line) + ": the face's normal index " +
                    std::to_string(c.normal + 1) + " is out of range, there are " +
                    std::to_string(normals_.size()) + " normals");
    sort_and_unite();

    std::vector<Triple> result(number_of_vertices, Triple{0, 0, 0});
    for (std::size_t i = 0, end; i < corners_.size(); i = end) {
      const Mesh_data::Index v = corners_[i].vertex;
      const Triple& first = normals_[corners_[i].normal];
      Triple sum = first;
      bool differ = false;
      for (end = i + 1; end < corners_.size() && corners_[end].vertex == v; ++end) {
        const Triple& n = normals_[corners_[end].normal];
        for (std::size_t k = 0; k < 3; ++k) sum[k] += n[k];
        differ = differ || directions_differ(first, n);
      }
      result[v] = end == i + 1 ? sum : normalized(sum);
      if (differ) ++vertices_with_several_normals_;
    }
    return result;
  }

  // Those whose normals differ by more than files are rounded; per_vertex() counts them.
  std::size_t vertices_with_several_normals() const { return vertices_with_several_normals_; }

private:
  struct Corner
  {
    Mesh_data::Index vertex;
    std::size_t normal, line;
  };

  // Some programs (CGAL's writer among them) list one normal per vertex and leave it at that.
  std::vector<Triple> in_order(std::size_t number_of_vertices) const
  {
    if (!normals_.empty() && normals_.size() != number_of_vertices)
      throw Error(std::to_string(normals_.size()) + " normals (vn) for " +
                  std::to_string(number_of_vertices) +
                  " vertices, and no face says which belongs where (f v//n)");
    return normals_;
  }

  // Corners at the same vertex with the same normal count once. Normals are compared by value,
  // because programs repeat them. The order of the sums is that of the file's normals.
  void sort_and_unite()
  {
    const auto& normals = normals_;
    const auto same = [&](const Corner& a, const Corner& b) {
      return a.vertex == b.vertex && normals[a.normal] == normals[b.normal];
    };
    const auto by_value = [&](const Corner& a, const Corner& b) {
      if (a.vertex != b.vertex) return a.vertex < b.vertex;
      const Triple &m = normals[a.normal], &n = normals[b.normal];
      for (std::size_t i = 0; i < 3; ++i)
        if (m[i] < n[i] || n[i] < m[i]) return m[i] < n[i];
      return a.normal < b.normal;
    };
    const auto by_number = [](const Corner& a, const Corner& b) {
      return a.vertex != b.vertex ? a.vertex < b.vertex : a.normal < b.normal;
    };
    std::sort(corners_.begin(), corners_.end(), by_value);
    corners_.erase(std::unique(corners_.begin(), corners_.end(), same), corners_.end());
    std::sort(corners_.begin(), corners_.end(), by_number);
  }

  static Triple normalized(const Triple& n)
  {
    const double length = std::hypot(n[0], n[1], n[2]);
    if (!(length > 0)) return {0, 0, 0};
    return {n[0] / length, n[1] / length, n[2] / length};
  }

  // by more than 0.1 degrees
  static bool directions_differ(const Triple& m, const Triple& n)
  {
    const Triple a = normalized(m), b = normalized(n);
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]) > 0.0017;
  }

  std::vector<Triple> normals_;
  std::vector<Corner> corners_;
  std::size_t vertices_with_several_normals_ = 0;
};

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_OBJ_NORMALS_H

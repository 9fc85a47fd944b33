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
#include "io/corner_normals.h"

#include <algorithm>
#include <string>
#include <vector>

namespace pn_subdivide {

// OBJ gives normals to the corners of faces. A vertex takes the normalized sum of the different
// normals at its corners, and a single one as it is.
class Obj_normals
{
public:
  std::size_t number_of_normals() const { return normals_.size(); }
  void add_normal(const Triple& n) { normals_.push_back(n); }

  // `corner` counts through all faces.
  void add_corner(std::size_t corner, Mesh_data::Index vertex, std::size_t normal, std::size_t line)
  {
    corners_.push_back({vertex, corner, normal, line});
  }

  // To be called when all is read.
  void check() const
  {
    for (const Corner& c : corners_)
      if (c.normal >= normals_.size())
        throw Error("line " + std::to_string(c.line) + ": the face's normal index " +
                    std::to_string(c.normal + 1) + " is out of range, there are " +
                    std::to_string(normals_.size()) + " normals");
  }

  // Empty if those of each vertex are the same; zero for corners that are given none.
  std::vector<Triple> per_corner(std::size_t number_of_vertices,
                                 std::size_t number_of_corners) const
  {
    if (!differ_at_a_vertex(number_of_vertices)) return {};
    std::vector<Triple> result(number_of_corners, Triple{0, 0, 0});
    for (const Corner& c : corners_) result[c.corner] = normals_[c.normal];
    return result;
  }

  // Empty if the file has no normals; zero for vertices that are given none. To be called last.
  std::vector<Triple> per_vertex(std::size_t number_of_vertices)
  {
    if (corners_.empty()) return in_order(number_of_vertices);
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
    std::size_t corner, normal, line;
  };

  bool differ_at_a_vertex(std::size_t number_of_vertices) const
  {
    const auto none = static_cast<std::size_t>(-1);
    std::vector<std::size_t> first(number_of_vertices, none);
    return std::any_of(corners_.begin(), corners_.end(), [&](const Corner& c) {
      if (first[c.vertex] == none) first[c.vertex] = c.normal;
      return normals_[first[c.vertex]] != normals_[c.normal];
    });
  }

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

  std::vector<Triple> normals_;
  std::vector<Corner> corners_;
  std::size_t vertices_with_several_normals_ = 0;
};

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_OBJ_NORMALS_H

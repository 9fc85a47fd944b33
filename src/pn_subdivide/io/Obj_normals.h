// Copyright (c) 2026  PN_subdivision_3 developers
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

// OBJ gives normals to the corners of faces; a vertex takes the normalised sum of the different
// normals at its corners, and a single one as it is.
class Obj_normals
{
public:
  std::size_t number_of_normals() const { return normals_.size(); }
  void add_normal(const Vector_3& n) { normals_.push_back(n); }

  void add_corner(Mesh_data::Index vertex, std::size_t normal, std::size_t line)
  {
    corners_.push_back({vertex, normal, line});
  }

  // Empty if the file has no normals; zero for vertices that are given none.
  std::vector<Vector_3> per_vertex(std::size_t number_of_vertices)
  {
    if (corners_.empty()) return in_order(number_of_vertices);
    for (const Corner& c : corners_)
      if (c.normal >= normals_.size())
        throw Error("line " + std::to_string(c.line) + ": the face's normal index " +
                    std::to_string(c.normal + 1) + " is out of range, there are " +
                    std::to_string(normals_.size()) + " normals");
    sort_and_unite();

    std::vector<Vector_3> result(number_of_vertices, Vector_3(0, 0, 0));
    for (std::size_t i = 0, end; i < corners_.size(); i = end) {
      const Mesh_data::Index v = corners_[i].vertex;
      Vector_3 sum = normals_[corners_[i].normal];
      for (end = i + 1; end < corners_.size() && corners_[end].vertex == v; ++end)
        sum = sum + normals_[corners_[end].normal];
      result[v] = end == i + 1 ? sum : normalised(sum);
    }
    return result;
  }

private:
  struct Corner
  {
    Mesh_data::Index vertex;
    std::size_t normal, line;
  };

  // Some programs (CGAL's writer among them) list one normal per vertex and leave it at that.
  std::vector<Vector_3> in_order(std::size_t number_of_vertices) const
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
      const Vector_3 &m = normals[a.normal], &n = normals[b.normal];
      for (int i = 0; i < 3; ++i)
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

  static Vector_3 normalised(const Vector_3& n)
  {
    const double length = std::hypot(n.x(), n.y(), n.z());
    return length > 0 ? n / length : Vector_3(0, 0, 0);
  }

  std::vector<Vector_3> normals_;
  std::vector<Corner> corners_;
};

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_OBJ_NORMALS_H

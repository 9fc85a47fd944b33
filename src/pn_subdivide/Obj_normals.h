// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_OBJ_NORMALS_H
#define PN_SUBDIVIDE_OBJ_NORMALS_H

#include "Error.h"
#include "Mesh_data.h"

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
  std::size_t number_of_normals() const { return m_normals.size(); }
  void add_normal(const Vector_3& n) { m_normals.push_back(n); }

  void add_corner(Mesh_data::Index vertex, std::size_t normal, std::size_t line)
  {
    m_corners.push_back({vertex, normal, line});
  }

  // Empty if the file has no normals; zero for vertices that are given none.
  std::vector<Vector_3> per_vertex(std::size_t number_of_vertices)
  {
    if (m_corners.empty()) return in_order(number_of_vertices);
    for (const Corner& c : m_corners)
      if (c.normal >= m_normals.size())
        throw Error("line " + std::to_string(c.line) + ": the face's normal index " +
                    std::to_string(c.normal + 1) + " is out of range, there are " +
                    std::to_string(m_normals.size()) + " normals");
    sort_and_unite();

    std::vector<Vector_3> result(number_of_vertices, Vector_3(0, 0, 0));
    for (std::size_t i = 0, end; i < m_corners.size(); i = end) {
      const Mesh_data::Index v = m_corners[i].vertex;
      Vector_3 sum = m_normals[m_corners[i].normal];
      for (end = i + 1; end < m_corners.size() && m_corners[end].vertex == v; ++end)
        sum = sum + m_normals[m_corners[end].normal];
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
    if (!m_normals.empty() && m_normals.size() != number_of_vertices)
      throw Error(std::to_string(m_normals.size()) + " normals (vn) for " +
                  std::to_string(number_of_vertices) +
                  " vertices, and no face says which belongs where (f v//n)");
    return m_normals;
  }

  // Corners at the same vertex with the same normal count once. Normals are compared by value,
  // because programs repeat them. The order of the sums is that of the file's normals.
  void sort_and_unite()
  {
    const auto& normals = m_normals;
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
    std::sort(m_corners.begin(), m_corners.end(), by_value);
    m_corners.erase(std::unique(m_corners.begin(), m_corners.end(), same), m_corners.end());
    std::sort(m_corners.begin(), m_corners.end(), by_number);
  }

  static Vector_3 normalised(const Vector_3& n)
  {
    const double length = std::hypot(n.x(), n.y(), n.z());
    return length > 0 ? n / length : Vector_3(0, 0, 0);
  }

  std::vector<Vector_3> m_normals;
  std::vector<Corner> m_corners;
};

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_OBJ_NORMALS_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "Display_mesh.h"

#include <cmath>

namespace pn_demo {
namespace {

// Lists of `values` by key: those of key k are lists[end[k - 1]] ... lists[end[k] - 1].
template <class Key_of>
void sort_by_key(std::size_t number, std::size_t keys, const Key_of& key_of,
                 std::vector<Index>& end, std::vector<Index>& sorted)
{
  std::vector<Index> place(keys + 1, 0);
  for (std::size_t i = 0; i < number; ++i) ++place[key_of(i) + 1];
  for (std::size_t k = 0; k < keys; ++k) place[k + 1] += place[k];
  end.assign(place.begin() + 1, place.end());
  sorted.resize(number);
  for (std::size_t i = 0; i < number; ++i) sorted[place[key_of(i)]++] = Index(i);
}

} // namespace

Display_mesh::Display_mesh(const Faces& faces, const std::vector<Index>& vertices,
                           std::size_t points, const Point_3& origin)
  : faces_(faces)
  , origin_(origin)
  , vertices_(vertices)
{
  sort_by_key(
    vertices_.size(), points, [&](std::size_t v) { return vertices_[v]; }, copies_end_, copies_);
  sort_by_key(
    faces_.corners.size(), vertices_.size(), [&](std::size_t c) { return faces_.corners[c]; },
    incident_end_, incident_);
  std::vector<Index> face_of_corner(faces_.corners.size());
  for (Index f = 0; f < faces_.end.size(); ++f) {
    const Index first = first_corner(f);
    for (Index c = first; c < faces_.end[f]; ++c) face_of_corner[c] = f;
    for (Index c = first + 2; c < faces_.end[f]; ++c)
      triangles_.insert(triangles_.end(),
                        {faces_.corners[first], faces_.corners[c - 1], faces_.corners[c]});
  }
  for (Index& c : incident_) c = face_of_corner[c];
  face_normals_.resize(faces_.end.size());
  is_face_marked_.resize(faces_.end.size());
  is_vertex_marked_.resize(vertices_.size());
  positions_.resize(3 * vertices_.size());
  normals_.resize(3 * vertices_.size());
}

void Display_mesh::update(const std::vector<Index>& moved, const std::vector<Point_3>& points)
{
  std::vector<Index> touched_faces, touched_vertices;
  for (const Index p : moved)
    for (Index i = p == 0 ? 0 : copies_end_[p - 1]; i < copies_end_[p]; ++i) {
      const Index v = copies_[i];
      put_position(v, points[p]);
      for (Index k = v == 0 ? 0 : incident_end_[v - 1]; k < incident_end_[v]; ++k)
        if (!is_face_marked_[incident_[k]]) {
          is_face_marked_[incident_[k]] = true;
          touched_faces.push_back(incident_[k]);
        }
    }
  for (const Index f : touched_faces) {
    compute_face_normal(f, points);
    for (Index c = first_corner(f); c < faces_.end[f]; ++c)
      if (!is_vertex_marked_[faces_.corners[c]]) {
        is_vertex_marked_[faces_.corners[c]] = true;
        touched_vertices.push_back(faces_.corners[c]);
      }
    is_face_marked_[f] = false;
  }
  for (const Index v : touched_vertices) {
    sum_normals(v);
    is_vertex_marked_[v] = false;
  }
}

void Display_mesh::set(const std::vector<Point_3>& points, const std::vector<Vector_3>& normals)
{
  for (Index v = 0; v < vertices_.size(); ++v) {
    put_position(v, points[vertices_[v]]);
    for (int k = 0; k < 3; ++k)
      normals_[3 * v + Index(k)] = static_cast<float>(normals[vertices_[v]][k]);
  }
}

// The area vector.
void Display_mesh::compute_face_normal(Index f, const std::vector<Point_3>& points)
{
  const auto point = [&](Index c) -> const Point_3& {
    return points[vertices_[faces_.corners[c]]];
  };
  const Index first = first_corner(f), end = faces_.end[f];
  Vector_3 sum = CGAL::NULL_VECTOR;
  for (Index c = first + 2; c < end; ++c)
    sum += CGAL::cross_product(point(c - 1) - point(first), point(c) - point(first));
  face_normals_[f] = sum;
}

void Display_mesh::sum_normals(Index v)
{
  Vector_3 sum = CGAL::NULL_VECTOR;
  for (Index k = v == 0 ? 0 : incident_end_[v - 1]; k < incident_end_[v]; ++k)
    sum += face_normals_[incident_[k]];
  const double length = std::sqrt(sum.squared_length());
  for (int k = 0; k < 3; ++k)
    normals_[3 * v + Index(k)] = length > 0 ? static_cast<float>(sum[k] / length) : 0.f;
}

void Display_mesh::put_position(Index v, const Point_3& p)
{
  for (int k = 0; k < 3; ++k) positions_[3 * v + Index(k)] = static_cast<float>(p[k] - origin_[k]);
}

} // namespace pn_demo

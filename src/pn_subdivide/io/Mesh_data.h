// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_MESH_DATA_H
#define PN_SUBDIVIDE_MESH_DATA_H

#include <CGAL/Simple_cartesian.h>

#include <boost/range/iterator_range.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace pn_subdivide {

using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Vector_3 = Kernel::Vector_3;
using Color = std::array<std::uint8_t, 3>; // red, green, blue

// A polygon soup as the files hold it: nothing is said about manifoldness or orientation.
// `normals` is empty or has one vector per point, zero where a point has no control normal.
// `scalars` and `colors` are for writing only, and empty or one per point.
class Mesh_data
{
public:
  using Index = std::uint32_t;
  using Face = boost::iterator_range<const Index*>;
  static constexpr std::size_t max_number_of_points = std::numeric_limits<Index>::max();

  std::vector<Point_3> points;
  std::vector<Vector_3> normals;
  std::string scalar_name;
  std::vector<double> scalars;
  std::vector<Color> colors;

  bool has_normals() const { return !normals.empty(); }
  std::size_t number_of_faces() const { return face_end_.size(); }
  std::size_t number_of_corners() const { return corners_.size(); }

  Face face(std::size_t f) const
  {
    const std::size_t begin = f == 0 ? 0 : face_end_[f - 1];
    return Face(corners_.data() + begin, corners_.data() + face_end_[f]);
  }

  template <class Index_range>
  void add_face(const Index_range& vertices)
  {
    for (const auto& v : vertices) corners_.push_back(static_cast<Index>(v));
    face_end_.push_back(corners_.size());
  }

  void reserve_faces(std::size_t faces, std::size_t corners)
  {
    face_end_.reserve(faces);
    corners_.reserve(corners);
  }

  void clear_faces()
  {
    corners_.clear();
    face_end_.clear();
  }

private:
  std::vector<Index> corners_;        // the faces' vertices, one face after the other
  std::vector<std::size_t> face_end_; // where each face ends in `corners_`
};

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_MESH_DATA_H

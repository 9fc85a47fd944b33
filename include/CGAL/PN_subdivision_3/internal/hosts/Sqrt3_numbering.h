// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_HOSTS_SQRT3_NUMBERING_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_HOSTS_SQRT3_NUMBERING_H

#include <CGAL/PN_subdivision_3/hosts/Element_parent.h>
#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>

#include <boost/container/vector.hpp>

#include <algorithm>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The numbers of the children in the sqrt(3) refinement, and back. In a round that refines the border some
// faces have a border edge that is cut into three parts; `border_faces_before` counts those before a face,
// `face_of_center` has the faces of the new vertices. Both are empty in other rounds.
//
// vertices: old ones, then one a face and two in a face at a refined border. Edges: old ones (flipped, or
// the first parts of refined border edges), three a face, the last parts of refined border edges. Faces: the
// triangles of the first half-edges of all faces, then those of the second and third ones.
template <class Index, class Border_faces = boost::container::vector<Index>>
class Sqrt3_numbering
{
public:
  using Parent = Basic_element_parent<Index>;
  using Table = boost::container::vector<Index>;

  // the tables must stay
  Sqrt3_numbering(const Level_size& size, const Border_faces& border_faces_before,
                  const Table& face_of_center)
    : vertices_(static_cast<Index>(size.vertices))
    , edges_(static_cast<Index>(size.edges))
    , faces_(static_cast<Index>(size.faces))
    , border_faces_before_(border_faces_before)
    , face_of_center_(face_of_center)
  {}

  bool refines_border() const { return !border_faces_before_.empty(); }

  // the first one
  Index vertex_of_face(Index f) const
  {
    return vertices_ + f + (border_faces_before_.empty() ? 0 : border_faces_before_[f]);
  }
  // In an ordinary face the edge from the new vertex to corner i. In a face at the refined border: from the
  // first and the second new vertex to the corner opposite, and the part between them.
  Index inner_edge(Index f, Index i) const { return edges_ + 3 * f + i; }
  // of the border edge of a face
  Index last_part(Index f) const { return edges_ + 3 * faces_ + border_faces_before_[f]; }
  // of half-edge i of a face
  Index triangle(Index f, Index i) const { return i == 0 ? f : faces_ + 2 * f + i - 1; }

  // of a new vertex the face
  Parent parent_of_vertex(Index child) const
  {
    if (child < vertices_) return {Parent::Kind::vertex, child};
    const Index rank = child - vertices_;
    if (!refines_border()) return {Parent::Kind::face, rank};
    const Index f = face_of_center_[rank];
    return {Parent::Kind::face, f, child - vertex_of_face(f)};
  }
  // the face of a last part has the ordinal 3
  Parent parent_of_edge(Index child) const
  {
    if (child < edges_) return {Parent::Kind::edge, child};
    const Index i = child - edges_;
    if (i < 3 * faces_) return {Parent::Kind::face, i / 3, i % 3};
    const auto next =
      std::upper_bound(border_faces_before_.begin(), border_faces_before_.end(), i - 3 * faces_);
    return {Parent::Kind::face, static_cast<Index>(next - border_faces_before_.begin() - 1), 3};
  }
  Parent parent_of_face(Index child) const
  {
    if (child < faces_) return {Parent::Kind::face, child, 0};
    const Index i = child - faces_;
    return {Parent::Kind::face, i / 2, i % 2 + 1};
  }

private:
  Index vertices_, edges_, faces_;
  const Border_faces& border_faces_before_;
  const Table& face_of_center_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_HOSTS_SQRT3_NUMBERING_H

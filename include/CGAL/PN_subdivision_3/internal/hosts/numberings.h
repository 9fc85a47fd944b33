// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_HOSTS_NUMBERINGS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_HOSTS_NUMBERINGS_H

#include <CGAL/PN_subdivision_3/internal/hosts/Edge_split.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <boost/container/vector.hpp>

#include <algorithm>

namespace CGAL::PN_subdivision_3::internal {

// The numbers of the children in the primal quadrilateral quadrisection, and back. Corners are numbered
// face by face, in a face from the target of its half-edge on: the corner at the target of h has the quad
// there and the spoke from the new vertex of h's edge.
//
// vertices: old ones, edges, faces. Edges: halves of edges, spokes by corners. Faces: the first quads of
// all faces, then the other ones.
template <class Index>
class PQQ_numbering
{
public:
  using Parent = Basic_element_parent<Index>;

  // `corners` must stay
  PQQ_numbering(const Level_size& size, const Face_corners<Index>& corners)
    : halves_(size)
    , faces_(static_cast<Index>(size.faces))
    , corners_(corners)
  {}

  const Edge_halves<Index>& halves() const { return halves_; }

  Index vertex_of_face(Index f) const { return halves_.number_of_vertices() + f; }
  Index spoke(Index first_corner, Index ordinal) const
  {
    return halves_.number_of_edges() + first_corner + ordinal;
  }
  Index quad(Index f, Index first_corner, Index ordinal) const
  {
    return ordinal == 0 ? f : faces_ + (first_corner - f) + (ordinal - 1);
  }
  Index first_corner(Index f) const { return corners_.first(f); }

  Parent parent_of_vertex(Index child) const
  {
    if (child < halves_.number_of_vertices()) return halves_.parent_of_vertex(child);
    return {Parent::Kind::face, child - halves_.number_of_vertices()};
  }
  Parent parent_of_edge(Index child) const
  {
    if (child < halves_.number_of_edges()) return halves_.parent_of_edge(child);
    const auto [f, ordinal] = corners_.face_of_corner(child - halves_.number_of_edges());
    return {Parent::Kind::face, f, ordinal};
  }
  Parent parent_of_face(Index child) const
  {
    if (child < faces_) return {Parent::Kind::face, child, 0};
    const auto [f, ordinal] = corners_.face_of_later_corner(child - faces_);
    return {Parent::Kind::face, f, ordinal};
  }

private:
  Edge_halves<Index> halves_;
  Index faces_;
  const Face_corners<Index>& corners_;
};

// The numbers of the children in the primal triangle quadrisection, and back.
//
// vertices: old ones, edges. Edges: halves of edges, three inner ones a face. Faces: the middle triangles,
// then three corner triangles a face. Corner i of a face is at the target of its half-edge number i, and the
// inner edge i closes the triangle there.
template <class Index>
class PTQ_numbering
{
public:
  using Parent = Basic_element_parent<Index>;

  explicit PTQ_numbering(const Level_size& size)
    : halves_(size)
    , faces_(static_cast<Index>(size.faces))
  {}

  const Edge_halves<Index>& halves() const { return halves_; }

  Index inner_edge(Index f, Index corner) const
  {
    return halves_.number_of_edges() + 3 * f + corner;
  }
  Index middle_triangle(Index f) const { return f; }
  Index corner_triangle(Index f, Index corner) const { return faces_ + 3 * f + corner; }

  Parent parent_of_vertex(Index child) const { return halves_.parent_of_vertex(child); }
  Parent parent_of_edge(Index child) const
  {
    if (child < halves_.number_of_edges()) return halves_.parent_of_edge(child);
    const Index i = child - halves_.number_of_edges();
    return {Parent::Kind::face, i / 3, i % 3};
  }
  // the middle triangle has the ordinal 0, that of corner i has i + 1
  Parent parent_of_face(Index child) const
  {
    if (child < faces_) return {Parent::Kind::face, child, 0};
    const Index i = child - faces_;
    return {Parent::Kind::face, i / 3, i % 3 + 1};
  }

private:
  Edge_halves<Index> halves_;
  Index faces_;
};

// Numbers some of the elements of a level, in their order: closed if these are all.
template <class Index>
class Ranks
{
public:
  // all elements
  Ranks() = default;
  // the numbers below `number` for which is_counted(i) is true
  template <class Is_counted>
  Ranks(Index number, const Is_counted& is_counted)
  {
    rank_.resize(number, boost::container::default_init);
    Index rank = 0;
    for (Index i = 0; i < number; ++i) {
      rank_[i] = rank;
      if (is_counted(i)) ++rank;
    }
  }

  // \pre the element is counted
  Index rank(Index i) const { return rank_.empty() ? i : rank_[i]; }
  // the element that is counted and has this rank: the last one with it
  Index element(Index rank) const
  {
    if (rank_.empty()) return rank;
    const auto next = std::upper_bound(rank_.begin(), rank_.end(), rank);
    return static_cast<Index>(next - rank_.begin() - 1);
  }

private:
  boost::container::vector<Index> rank_;
};

// The numbers of the children in the dual quadrilateral quadrisection, and back. Corners are numbered face
// by face.
//
// vertices: corners. Edges: one a corner, on the smaller face; two for every interior edge, that cross
// it. Faces: smaller faces, quads of interior edges, polygons of interior vertices.
template <class Index>
class DQQ_numbering
{
public:
  using Parent = Basic_element_parent<Index>;

  // the ranks count interior edges and vertices, and must stay
  DQQ_numbering(const Level_size& size, const Ranks<Index>& edges, const Ranks<Index>& vertices)
    : corners_(static_cast<Index>(size.corners))
    , faces_(static_cast<Index>(size.faces))
    , interior_edges_(static_cast<Index>(size.corners - size.edges))
    , edges_(edges)
    , vertices_(vertices)
  {}

  Index edge_of_corner(Index corner) const { return corner; }
  // at the target of half-edge 2e + side
  Index crossing_edge(Index e, Index side) const { return corners_ + 2 * edges_.rank(e) + side; }
  Index face_of_face(Index f) const { return f; }
  Index face_of_edge(Index e) const { return faces_ + edges_.rank(e); }
  Index face_of_vertex(Index v) const { return faces_ + interior_edges_ + vertices_.rank(v); }

  bool is_edge_of_corner(Index child) const { return child < corners_; }
  // \pre not is_edge_of_corner(child)
  Parent parent_of_crossing_edge(Index child) const
  {
    const Index i = child - corners_;
    return {Parent::Kind::edge, edges_.element(i / 2), i % 2};
  }
  Parent parent_of_face(Index child) const
  {
    if (child < faces_) return {Parent::Kind::face, child};
    if (child < faces_ + interior_edges_)
      return {Parent::Kind::edge, edges_.element(child - faces_)};
    return {Parent::Kind::vertex, vertices_.element(child - faces_ - interior_edges_)};
  }

private:
  Index corners_, faces_, interior_edges_;
  const Ranks<Index>& edges_;
  const Ranks<Index>& vertices_;
};

// The numbers of the children in the sqrt(3) refinement, and back. In a round that refines the border some
// faces have a border edge that is cut into three parts; `border_faces_before` counts such faces before a face,
// `face_of_center` has the faces of the new vertices. Both are empty in other rounds.
//
// vertices: old ones, then one a face and two in a face at a refined border. Edges: old ones (flipped, or
// the first parts of refined border edges), three a face, the last parts of refined border edges. Faces: the
// triangles of the first half-edges of all faces, then of the second and third half-edges.
template <class Index>
class Sqrt3_numbering
{
public:
  using Parent = Basic_element_parent<Index>;
  using Table = boost::container::vector<Index>;

  // the tables must stay
  Sqrt3_numbering(const Level_size& size, const Table& border_faces_before,
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
  // the last part of the border edge of a face
  Index last_part(Index f) const { return edges_ + 3 * faces_ + border_faces_before_[f]; }
  // the triangle at half-edge i of a face
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
  const Table& border_faces_before_;
  const Table& face_of_center_;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_HOSTS_NUMBERINGS_H

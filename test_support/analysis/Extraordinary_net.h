// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_TEST_SUPPORT_EXTRAORDINARY_NET_H
#define CGAL_PN_SUBDIVISION_3_TEST_SUPPORT_EXTRAORDINARY_NET_H

#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {

/*!
A control net of quads or triangles with one vertex of any valence n in its middle and a number of
rings of regular vertices around it.

The net consists of n equal sectors, numbered counterclockwise. Sector s lies between the edges s
and s + 1 of the middle vertex; the vertex (s, i, j) is reached by i steps along the one and j steps
along the other, 1 &le; i, 0 &le; j. The <em>norm</em> of a vertex, the number of its ring, is
max(i, j) among quads and i + j among triangles. Vertex 0 is the middle one; the others follow
sector by sector, and in a sector in the order of (i, j).
*/
class Extraordinary_net
{
public:
  /// numbers vertices and faces.
  using Index = Level_connectivity::Index;

  /// the place of a vertex; the middle one has (0, 0, 0).
  struct Place
  {
    /// the sector.
    Index sector;
    /// the steps along its first edge.
    Index i;
    /// the steps along its second edge.
    Index j;
  };

  /// a face: its corners counterclockwise, as places (i, j) of one sector.
  struct Face
  {
    /// the sector of the face.
    Index sector;
    /// the places (i, j) of its corners.
    std::vector<std::array<Index, 2>> corners;
  };

  /*!
  makes the net of `rings` rings about a vertex of valence `valence`, of faces with `degree` corners.
  \throws std::invalid_argument if the valence is less than 3, `rings` is 0, or `degree` is neither 3
    nor 4
  */
  Extraordinary_net(Index degree, Index valence, Index rings)
    : degree_(degree)
    , valence_(valence)
    , rings_(rings)
  {
    if ((degree != 3 && degree != 4) || valence < 3 || rings == 0)
      throw std::invalid_argument("PN_subdivision_3: no net has faces of degree " +
                                  std::to_string(degree) + ", valence " + std::to_string(valence) +
                                  " and " + std::to_string(rings) +
                                  " rings: the degree is 3 or 4, the valence at least 3");
    places_.push_back({0, 0, 0});
    for (Index s = 0; s < valence; ++s)
      for (Index i = 1; i <= rings; ++i)
        for (Index j = 0; norm(i, j) <= rings; ++j) places_.push_back({s, i, j});
    for (Index s = 0; s < valence; ++s) add_faces(s);
  }

  /// the number of corners of a face, 3 or 4.
  Index degree() const { return degree_; }
  /// the valence of the middle vertex.
  Index valence() const { return valence_; }
  /// the number of rings.
  Index rings() const { return rings_; }
  /// the number of vertices.
  Index number_of_vertices() const { return static_cast<Index>(places_.size()); }
  /// the place of a vertex.
  const Place& place(Index v) const { return places_[v]; }
  /// all faces.
  const std::vector<Face>& faces() const { return faces_; }

  /// the number of the ring of vertex `v`.
  Index norm(Index v) const { return norm(places_[v].i, places_[v].j); }

  /// the norm of (i, j).
  Index norm(Index i, Index j) const { return degree_ == 4 ? (std::max)(i, j) : i + j; }

  /// the vertex (s, i, j); here i may be 0, (s, 0, j) is (s + 1, j, 0).
  /// \pre its norm is at most `rings()`
  Index vertex(Index s, Index i, Index j) const
  {
    if (i == 0) {
      if (j == 0) return 0;
      return vertex(s + 1, j, 0);
    }
    const Index per_sector = (number_of_vertices() - 1) / valence_;
    const Index rows = i - 1; // before row i
    const Index before = degree_ == 4 ? rows * (rings_ + 1) : rows * rings_ - rows * (rows - 1) / 2;
    return 1 + (s % valence_) * per_sector + before + j;
  }

  /// the net as a mesh. The half-edge of a face leads from its corner 0 to its corner 1.
  Level_connectivity level() const
  {
    Level_size size;
    size.vertices = places_.size();
    size.faces = faces_.size();
    size.edges = size.vertices + size.faces - 1; // a disk
    size.corners = degree_ * size.faces;
    Level_connectivity level(size);
    level.set_uniform_degree(degree_);
    connect_faces(level);
    connect_border(level);
    return level;
  }

private:
  void add_faces(Index s)
  {
    for (Index i = 0; i < rings_; ++i)
      for (Index j = 0; norm(i + 1, j + 1) <= rings_ + (degree_ == 3); ++j) {
        if (degree_ == 4) {
          faces_.push_back({s, {{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}}});
          continue;
        }
        faces_.push_back({s, {{i, j}, {i + 1, j}, {i, j + 1}}});
        if (norm(i + 1, j + 1) <= rings_)
          faces_.push_back({s, {{i + 1, j}, {i + 1, j + 1}, {i, j + 1}}});
      }
  }

  void connect_faces(Level_connectivity& level) const
  {
    std::map<std::pair<Index, Index>, Index> halfedges;
    Index edges = 0;
    for (Index f = 0; f < faces_.size(); ++f) {
      std::array<Index, 4> h{};
      for (Index k = 0; k < degree_; ++k) {
        const Index from = corner(f, k), to = corner(f, (k + 1) % degree_);
        const auto other = halfedges.find({to, from});
        h[k] = other != halfedges.end() ? Level_connectivity::opposite(other->second) : 2 * edges++;
        halfedges[{from, to}] = h[k];
        level.set_target(h[k], to);
        level.set_target(Level_connectivity::opposite(h[k]), from);
        level.set_face(h[k], f);
        if (other == halfedges.end()) level.set_border(Level_connectivity::opposite(h[k]));
        level.set_halfedge_of_vertex(to, h[k]);
      }
      for (Index k = 0; k < degree_; ++k) level.set_next(h[k], h[(k + 1) % degree_]);
      level.set_halfedge_of_face(f, h[0]);
    }
  }

  static void connect_border(Level_connectivity& level)
  {
    std::map<Index, Index> out;
    for (Index h = 0; h < level.number_of_halfedges(); ++h)
      if (level.is_border(h)) {
        out[level.source(h)] = h;
        level.set_halfedge_of_vertex(level.target(h), h);
      }
    for (const auto& [v, h] : out) level.set_next(h, out[level.target(h)]);
  }

  Index corner(Index f, Index k) const
  {
    const Face& face = faces_[f];
    return vertex(face.sector, face.corners[k][0], face.corners[k][1]);
  }

  Index degree_, valence_, rings_;
  std::vector<Place> places_;
  std::vector<Face> faces_;
};

/// appends a vertex and its 1-ring, clockwise.
/// \pre the vertex and its faces are regular
inline void append_regular_ring(const Level_connectivity& level, Level_connectivity::Index v,
                                std::vector<Level_connectivity::Index>& ring)
{
  Level_connectivity::Index h = level.halfedge_of_vertex(v);
  ring.push_back(v);
  for (auto n = level.valence(v); n > 0; --n) {
    h = level.next(h);
    ring.push_back(level.target(h));
    h = Level_connectivity::opposite(h);
    if (!level.has_degree(h, 3)) ring.push_back(level.target(level.next(level.next(h))));
  }
}

} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_TEST_SUPPORT_EXTRAORDINARY_NET_H

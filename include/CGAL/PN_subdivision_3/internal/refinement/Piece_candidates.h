// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_REFINEMENT_PIECE_CANDIDATES_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_REFINEMENT_PIECE_CANDIDATES_H

#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

using Face_marks = std::vector<char>;

// Marks the faces that share a vertex with a marked one, too.
inline void add_ring(const Level_connectivity& level, Face_marks& is_marked)
{
  using Index = Level_connectivity::Index;
  std::vector<char> is_touched(level.number_of_vertices(), 0);
  for (Index h = 0; h < level.number_of_halfedges(); ++h)
    if (!level.is_border(h) && is_marked[level.face(h)] != 0) is_touched[level.target(h)] = 1;
  for (Index h = 0; h < level.number_of_halfedges(); ++h)
    if (!level.is_border(h) && is_touched[level.target(h)] != 0) is_marked[level.face(h)] = 1;
}

// The elements of a level among which the elements of a piece are looked for: here all elements of a level that is
// not much larger than the piece.
class All_candidates
{
public:
  using Index = Level_connectivity::Index;

  // The level and the marks must stay.
  All_candidates(const Level_connectivity& level, const Face_marks& is_taken)
    : level_(level)
    , is_taken_(is_taken)
  {}

  bool is_taken(Index f) const { return is_taken_[f] != 0; }

  // The elements in increasing order, and the place of an edge in that order.
  Index number_of_vertices() const { return level_.number_of_vertices(); }
  Index number_of_edges() const { return level_.number_of_edges(); }
  Index number_of_faces() const { return level_.number_of_faces(); }
  Index vertex(Index i) const { return i; }
  Index edge(Index i) const { return i; }
  Index face(Index i) const { return i; }
  Index place_of_edge(Index e) const { return e; }
  // the half-edges that vertices and faces begin with, and which half of its edge a half-edge becomes
  Index halfedge_of_vertex(Index i) const { return level_.halfedge_of_vertex(i); }
  Index halfedge_of_face(Index i) const { return level_.halfedge_of_face(i); }
  static Index side(Index /*place*/, Index h) { return h & 1u; }

private:
  const Level_connectivity& level_;
  const Face_marks& is_taken_;
};

// A list of elements, and the place of each element in the list. The table of places is as large as the level, but
// need not be cleared before other elements are listed: places are counted on from one list to the next.
class Element_list
{
public:
  using Index = Level_connectivity::Index;

  explicit Element_list(std::size_t elements_of_level)
    : place_(elements_of_level, 0)
  {}

  const std::vector<Index>& elements() const { return elements_; }
  bool contains(Index i) const { return place_[i] >= begin_; }
  Index place(Index i) const { return place_[i] - begin_; }

  // \pre it is empty or sorted
  void clear()
  {
    if (place_.size() >= (std::numeric_limits<Index>::max)() - end_) { // might be counted too far
      std::fill(place_.begin(), place_.end(), Index(0));
      end_ = 1;
    }
    begin_ = end_;
    elements_.clear();
  }
  void add(Index i)
  {
    if (contains(i)) return;
    place_[i] = end_++;
    elements_.push_back(i);
  }
  void sort()
  {
    std::sort(elements_.begin(), elements_.end());
    for (std::size_t k = 0; k < elements_.size(); ++k)
      place_[elements_[k]] = begin_ + static_cast<Index>(k);
  }

private:
  std::vector<Index> elements_, place_;
  Index begin_ = 1, end_ = 1; // of the places of the list
};

// The elements of a few faces, at a cost that does not depend on the size of the level.
class Listed_candidates
{
public:
  using Index = Level_connectivity::Index;

  // The level must stay.
  explicit Listed_candidates(const Level_connectivity& level)
    : level_(level)
    , vertices_(level.size().vertices)
    , edges_(level.size().edges)
    , faces_(level.size().faces)
  {}

  // lists faces, the rings around these faces, and isolated vertices besides
  void list(const Index* begin, const Index* end, unsigned rings,
            const std::vector<Index>& isolated_vertices)
  {
    faces_.clear();
    vertices_.clear();
    edges_.clear();
    for (const Index* f = begin; f != end; ++f) faces_.add(*f);
    std::size_t first_face = 0;
    for (; rings > 0; --rings) {
      const std::size_t last_face = faces_.elements().size(), first = vertices_.elements().size();
      add_vertices(first_face);
      for (std::size_t i = first; i < vertices_.elements().size(); ++i)
        add_faces(vertices_.elements()[i]);
      first_face = last_face;
    }
    add_vertices(first_face);
    for_each_halfedge(0, [this](Index h) { edges_.add(Level_connectivity::edge(h)); });
    for (const Index v : isolated_vertices) vertices_.add(v);
    for (Element_list* elements : {&vertices_, &edges_, &faces_}) elements->sort();
  }

  bool is_taken(Index f) const { return faces_.contains(f); }

  Index number_of_vertices() const { return static_cast<Index>(vertices_.elements().size()); }
  Index number_of_edges() const { return static_cast<Index>(edges_.elements().size()); }
  Index number_of_faces() const { return static_cast<Index>(faces_.elements().size()); }
  Index vertex(Index i) const { return vertices_.elements()[i]; }
  Index edge(Index i) const { return edges_.elements()[i]; }
  Index face(Index i) const { return faces_.elements()[i]; }
  Index place_of_edge(Index e) const { return edges_.place(e); }
  Index halfedge_of_vertex(Index i) const { return level_.halfedge_of_vertex(vertex(i)); }
  Index halfedge_of_face(Index i) const { return level_.halfedge_of_face(face(i)); }
  static Index side(Index /*place*/, Index h) { return h & 1u; }

private:
  template <class Function>
  void for_each_halfedge(std::size_t first_face, const Function& f) const
  {
    for (std::size_t i = first_face; i < faces_.elements().size(); ++i)
      for (const Index h :
           halfedges_around_face(level_, level_.halfedge_of_face(faces_.elements()[i])))
        f(h);
  }
  // the vertices of the listed faces from this one on
  void add_vertices(std::size_t first_face)
  {
    for_each_halfedge(first_face, [this](Index h) { vertices_.add(level_.target(h)); });
  }
  void add_faces(Index v)
  {
    for (const Index h : halfedges_around_target(level_, level_.halfedge_of_vertex(v)))
      if (!level_.is_border(h)) faces_.add(level_.face(h));
  }

  const Level_connectivity& level_;
  Element_list vertices_, edges_, faces_;
};

// Tables of candidates, one for each thread that asks at the same time, made once.
class Candidate_tables
{
public:
  using Table = std::unique_ptr<Listed_candidates>;

  Table take(const Level_connectivity& level)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (free_.empty()) return std::make_unique<Listed_candidates>(level);
    Table table = std::move(free_.back());
    free_.pop_back();
    return table;
  }
  void give_back(Table table)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    free_.push_back(std::move(table));
  }

private:
  std::mutex mutex_;
  std::vector<Table> free_;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_REFINEMENT_PIECE_CANDIDATES_H

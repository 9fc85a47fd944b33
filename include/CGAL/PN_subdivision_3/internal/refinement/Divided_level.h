// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_REFINEMENT_DIVIDED_LEVEL_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_REFINEMENT_DIVIDED_LEVEL_H

#include <CGAL/PN_subdivision_3/hosts/Sqrt3_host.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Piece_extraction.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Whole_level.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// Closes the rim of a piece of triangles by fans, so that it is not taken for a border: sqrt(3) cuts border
// edges into three parts, and no triangle with two of them. Where the rim joins the border the fan gets three
// triangles on the border besides; they have one border edge each.
class Rim_closure
{
public:
  using Index = Level_connectivity::Index;

  // is_rim(b) tells it of the border half-edges
  template <class Is_rim>
  Rim_closure(Level_connectivity& level, const Is_rim& is_rim)
    : level_(level)
  {
    const Index old = level.number_of_halfedges();
    std::vector<char> is_seen(old, 0);
    for (Index b = 0; b < old; ++b)
      if (level.is_border(b) && is_seen[b] == 0) collect(b, is_rim, is_seen);
    if (runs_.empty()) return;
    grow();
    for (Run& run : runs_) close(run);
  }

  // a vertex of the piece for each vertex that was added, in their order
  const std::vector<Index>& neighbors_of_new_vertices() const { return neighbors_; }

private:
  // half-edges of the rim, one after the other; between two on the border, or all of a loop
  struct Run
  {
    std::vector<Index> halfedges;
    Index before = Level_connectivity::null; // null: a loop
  };

  static Index opposite(Index h) { return Level_connectivity::opposite(h); }

  template <class Is_rim>
  void collect(Index first, const Is_rim& is_rim, std::vector<char>& is_seen)
  {
    std::vector<Index> loop;
    Index b = first;
    do {
      is_seen[b] = 1;
      loop.push_back(b);
      b = level_.next(b);
    } while (b != first);
    std::size_t begin = 0; // behind a half-edge on the border, if there is one
    while (begin < loop.size() && is_rim(loop[begin])) ++begin;
    if (begin == loop.size()) return runs_.push_back({loop, Level_connectivity::null});
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Index h = loop[(begin + i) % loop.size()];
      if (!is_rim(h)) continue;
      const Index before = loop[(begin + i + loop.size() - 1) % loop.size()];
      if (!is_rim(before)) runs_.push_back({{}, before});
      runs_.back().halfedges.push_back(h);
    }
  }

  void grow()
  {
    Level_size size = level_.size();
    vertices_ = static_cast<Index>(size.vertices);
    edges_ = static_cast<Index>(size.edges);
    faces_ = static_cast<Index>(size.faces);
    for (const Run& run : runs_) {
      const bool is_loop = run.before == Level_connectivity::null;
      const std::size_t triangles = run.halfedges.size() + (is_loop ? 0 : 3);
      size.vertices += is_loop ? 1 : 3;
      size.edges += triangles + (is_loop ? 0 : 3);
      size.faces += triangles;
      size.corners += 3 * triangles;
    }
    level_.resize(size);
  }

  Index new_vertex(Index neighbor)
  {
    neighbors_.push_back(neighbor);
    return vertices_++;
  }

  void close(Run& run)
  {
    const Index source = level_.target(opposite(run.halfedges.front()));
    if (run.before != Level_connectivity::null) join_ends(run, source);
    const Index center = new_vertex(source);
    const std::size_t n = run.halfedges.size();
    const Index first_spoke = 2 * edges_; // to the center
    for (std::size_t i = 0; i < n; ++i) {
      const Index h = run.halfedges[i];
      const Index in = first_spoke + 2 * Index(i);
      const Index out = opposite(first_spoke + 2 * Index(i == 0 ? n - 1 : i - 1));
      const Index f = faces_++;
      level_.set_next(h, in);
      level_.set_next(in, out);
      level_.set_next(out, h);
      for (const Index g : {h, in, out}) level_.set_face(g, f);
      level_.set_target(in, center);
      level_.set_target(out, level_.target(opposite(h)));
      level_.set_halfedge_of_face(f, h);
      level_.set_halfedge_of_vertex(level_.target(h), h);
    }
    for (const Index b : new_border_) level_.set_halfedge_of_vertex(level_.target(b), b);
    new_border_.clear();
    if (run.before != Level_connectivity::null) level_.set_halfedge_of_vertex(source, run.before);
    level_.set_halfedge_of_vertex(center, first_spoke);
    edges_ += Index(n);
  }

  // three edges from the end of a run back to its start
  void join_ends(Run& run, Index source)
  {
    const Index last = run.halfedges.back(), end = level_.target(last), behind = level_.next(last);
    const Index corners[] = {end, new_vertex(end), new_vertex(source), source};
    Index next_border = behind;
    for (int i = 0; i < 3; ++i) {
      const Index h = 2 * edges_++, b = opposite(h);
      level_.set_target(h, corners[i + 1]);
      level_.set_target(b, corners[i]);
      level_.set_border(b);
      level_.set_next(b, next_border);
      next_border = b;
      run.halfedges.push_back(h);
      new_border_.push_back(b);
    }
    level_.set_next(run.before, next_border);
  }

  Level_connectivity& level_;
  std::vector<Run> runs_;
  std::vector<Index> neighbors_, new_border_;
  Index vertices_ = 0, edges_ = 0, faces_ = 0;
};

// Divides the faces of a level into pieces with about equally many corners, or of about equal weights, by planes across
// the longest extent of what is divided. The same on all machines: ties go by the numbers of the faces.
class Face_division
{
public:
  using Index = Level_connectivity::Index;
  using Center = std::array<double, 3>;

  // point(v): the coordinates of a vertex, as Center; weights: of the faces, or null
  template <class Point>
  Face_division(const Level_connectivity& level, std::size_t number_of_pieces, const Point& point,
                const std::vector<double>* weights = nullptr)
    : piece_(level.number_of_faces(), 0)
  {
    std::vector<Face> faces(level.number_of_faces());
    for (Index f = 0; f < faces.size(); ++f) {
      const Index first = level.halfedge_of_face(f);
      const double m = level.degree(first);
      Center center{0, 0, 0};
      Index h = first;
      do {
        const Center p = point(level.target(h));
        for (std::size_t i = 0; i < 3; ++i) center[i] += p[i] / m;
        h = level.next(h);
      } while (h != first);
      faces[f] = {center, weights == nullptr ? m : (*weights)[f], f};
    }
    const auto differs = [](const Face& f, const Face& g) { return f.corners != g.corners; };
    is_uniform_ = std::adjacent_find(faces.begin(), faces.end(), differs) == faces.end();
    divide(faces.data(), faces.data() + faces.size(), 0, number_of_pieces);
  }

  std::size_t piece_of_face(Index f) const { return piece_[f]; }

private:
  // moved as a whole: what is looked at lies in a row
  struct Face
  {
    Center center;
    double corners; // or another weight
    Index number;
  };

  // into pieces [first, first + number)
  void divide(Face* begin, Face* end, std::size_t first, std::size_t number)
  {
    if (number == 1 || begin == end) {
      for (const Face* f = begin; f != end; ++f) piece_[f->number] = first;
      return;
    }
    const std::size_t axis = longest_axis(begin, end);
    const auto is_before = [axis](const Face& f, const Face& g) {
      return f.center[axis] != g.center[axis] ? f.center[axis] < g.center[axis]
                                              : f.number < g.number;
    };
    if (!is_uniform_) std::sort(begin, end, is_before);
    const std::size_t half = number / 2;
    Face* const middle = end_of_share(begin, end, double(half) / double(number));
    if (is_uniform_ && middle != end) std::nth_element(begin, middle, end, is_before);
    divide(begin, middle, first, half);
    divide(middle, end, first + half, number - half);
  }

  // The order matters only where the faces have different numbers of corners.
  Face* end_of_share(Face* begin, Face* end, double share) const
  {
    if (is_uniform_) return end_of_uniform_share(begin, end, share);
    double total = 0;
    for (const Face* f = begin; f != end; ++f) total += f->corners;
    Face* middle = begin;
    for (double sum = middle->corners / 2; middle != end && sum < total * share;) {
      sum += middle->corners / 2;
      if (++middle != end) sum += middle->corners / 2;
    }
    return middle;
  }
  // the same sums, which are exact
  static Face* end_of_uniform_share(Face* begin, Face* end, double share)
  {
    const double m = begin->corners, wanted = double(end - begin) * m * share;
    auto i = static_cast<std::ptrdiff_t>(wanted / m - 0.5);
    while (i > 0 && m / 2 + double(i - 1) * m >= wanted) --i;
    while (begin + i != end && m / 2 + double(i) * m < wanted) ++i;
    return begin + i;
  }

  static std::size_t longest_axis(const Face* begin, const Face* end)
  {
    Center low = begin->center, high = low;
    for (const Face* f = begin; f != end; ++f)
      for (std::size_t i = 0; i < 3; ++i) {
        low[i] = (std::min)(low[i], f->center[i]);
        high[i] = (std::max)(high[i], f->center[i]);
      }
    std::size_t axis = 0;
    for (std::size_t i = 1; i < 3; ++i)
      if (high[i] - low[i] > high[axis] - low[axis]) axis = i;
    return axis;
  }

  std::vector<std::size_t> piece_;
  bool is_uniform_ = false;
};

// Which elements of a level each piece owns: its faces, listed once, so that no piece looks through the level, and
// what follows from them.
class Divided_level
{
public:
  using Index = Level_connectivity::Index;

  // point(v) and weights as for Face_division; the level must stay
  template <class Point>
  Divided_level(const Level_connectivity& level, std::size_t number_of_pieces, const Point& point,
                const std::vector<double>* weights = nullptr)
    : level_(level)
    , piece_of_face_(level.number_of_faces())
    , faces_by_piece_(level.number_of_faces())
    , first_of_piece_(number_of_pieces + 1, 0)
    , first_face_(level.number_of_vertices(), Level_connectivity::null)
  {
    list_faces(Face_division(level, number_of_pieces, point, weights));
    for (Index h = 0; h < level.number_of_halfedges(); ++h)
      if (!level.is_border(h)) {
        Index& first = first_face_[level.target(h)];
        first = (std::min)(first, level.face(h));
      }
    for (Index v = 0; v < level.number_of_vertices(); ++v)
      if (level.is_isolated(v)) isolated_vertices_.push_back(v);
    // where sqrt(3) refines the border other faces lose the vertex to their neighbors
    for (Index h = 0; h < level.number_of_halfedges(); ++h)
      if (level.is_border(h))
        first_face_[level.target(h)] = level.face(Level_connectivity::opposite(h));
  }

  // the faces of a piece, in increasing order
  const Index* begin(std::size_t piece) const
  {
    return faces_by_piece_.data() + first_of_piece_[piece];
  }
  const Index* end(std::size_t piece) const { return begin(piece + 1); }
  // all of them belong to the first piece
  const std::vector<Index>& isolated_vertices() const { return isolated_vertices_; }

  bool owns_face(std::size_t piece, Index f) const { return piece_of_face_[f] == piece; }
  bool owns_edge(std::size_t piece, Index e) const // null is the greatest number
  {
    return owns_face(piece, (std::min)(level_.face(2 * e), level_.face(2 * e + 1)));
  }
  bool owns_vertex(std::size_t piece, Index v) const
  {
    return level_.is_isolated(v) ? piece == 0 : owns_face(piece, first_face_[v]);
  }

private:
  void list_faces(const Face_division& division)
  {
    const Index faces = level_.number_of_faces();
    for (Index f = 0; f < faces; ++f) {
      piece_of_face_[f] = division.piece_of_face(f);
      ++first_of_piece_[piece_of_face_[f] + 1];
    }
    std::partial_sum(first_of_piece_.begin(), first_of_piece_.end(), first_of_piece_.begin());
    std::vector<Index> next(first_of_piece_.begin(), first_of_piece_.end() - 1);
    for (Index f = 0; f < faces; ++f) faces_by_piece_[next[piece_of_face_[f]]++] = f;
  }

  const Level_connectivity& level_;
  std::vector<std::size_t> piece_of_face_;
  std::vector<Index> faces_by_piece_, first_of_piece_;
  std::vector<Index> first_face_; // the face that decides on the piece of each vertex
  std::vector<Index> isolated_vertices_;
};

template <class Host>
bool refines_border([[maybe_unused]] unsigned round)
{
  if constexpr (std::is_same_v<Host, Sqrt3_host>)
    return Sqrt3_host::refines_border(round);
  else
    return false;
}

// Closes the rim of a piece before a round that refines the border. Before it there was a round that did
// not, after which the first half-edge of a face at the border lies there. Returns for each vertex that was
// added a neighbor in the piece.
inline std::vector<Level_connectivity::Index>
close_rim(Level_connectivity& level, Piece_elements& elements, const Whole_level& whole)
{
  using Index = Level_connectivity::Index;
  const auto is_rim = [&](Index b) {
    const Index h = Level_connectivity::opposite(b), f = level.face(h);
    return level.halfedge_of_face(f) != h || !whole.border_faces.contains(elements.faces.number(f));
  };
  const Rim_closure closure(level, is_rim);
  const auto add = [](Numbered_elements& of, std::uint64_t size) {
    while (of.size() < size) of.push_back(Numbered_elements::no_number, false);
  };
  add(elements.vertices, level.size().vertices);
  add(elements.edges, level.size().edges);
  add(elements.faces, level.size().faces);
  return closure.neighbors_of_new_vertices();
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_REFINEMENT_DIVIDED_LEVEL_H

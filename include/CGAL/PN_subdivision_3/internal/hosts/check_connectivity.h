// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_HOSTS_CHECK_CONNECTIVITY_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_HOSTS_CHECK_CONNECTIVITY_H

#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

inline std::string numbered_name(const char* kind, std::size_t number)
{
  return kind + (' ' + std::to_string(number));
}

// What the elements of a control level are called in messages. Virtual, so that checks need not be
// instantiated for every mesh.
class Element_names
{
public:
  using Index = Level_connectivity::Index;

  virtual std::string vertex_name(Index v) const = 0;
  virtual std::string halfedge_name(Index h) const = 0;
  virtual std::string face_name(Index f) const = 0;

protected:
  Element_names() = default;
  Element_names(const Element_names&) = default;
  Element_names& operator=(const Element_names&) = default;
  ~Element_names() = default;
};

// Refuses whatever is not an oriented 2-manifold with border, by the name of the element, and
// brings a valid level into the normal form of Level_connectivity: a border vertex stores a border
// half-edge.
//
// Linear in the size of the level. is_valid_polygon_mesh() does not serve: it rejects vertices
// without edges and accepts vertices with several border gaps.
class Connectivity_check
{
public:
  using Index = Level_connectivity::Index;

  Connectivity_check(Level_connectivity& level, const Element_names& names)
    : level_(level)
    , names_(names)
    , size_(level.size())
  {}

  void operator()()
  {
    check_links();
    check_faces();
    check_vertices();
    level_.set_size(size_);
  }

private:
  static constexpr Index null = Level_connectivity::null;

  [[noreturn]] static void refuse(const std::string& what)
  {
    throw std::invalid_argument("PN_subdivision_3: " + what);
  }

  void check_links()
  {
    const Index n = level_.number_of_halfedges();
    for (Index h = 0; h < n; ++h) {
      if (level_.is_border(h) && level_.is_border(Level_connectivity::opposite(h)))
        refuse("the edge of " + names_.halfedge_name(h) +
               " has no face on either side: remove the edge or add the face");
      if (level_.target(h) >= level_.number_of_vertices())
        refuse(names_.halfedge_name(h) + " has no valid target vertex: the connectivity is broken");
      if (level_.next(h) >= n)
        refuse(names_.halfedge_name(h) +
               " has no valid next half-edge: the connectivity is broken");
      if (level_.face(h) != null && level_.face(h) >= level_.number_of_faces())
        refuse(names_.halfedge_name(h) + " has no valid face: the connectivity is broken");
    }
    std::vector<bool> reached(n, false);
    for (Index h = 0; h < n; ++h) {
      const Index next = level_.next(h);
      if (level_.source(next) != level_.target(h) || level_.face(next) != level_.face(h) ||
          reached[next])
        refuse("the half-edge after " + names_.halfedge_name(h) +
               " does not continue it: the connectivity is broken");
      reached[next] = true;
      if (level_.next(h) == Level_connectivity::opposite(h))
        refuse(names_.vertex_name(level_.target(h)) +
               " has a single edge, inside a face or on the border: remove the dangling edge");
    }
  }

  void check_faces()
  {
    std::uint64_t corners = 0;
    Index least = null, greatest = 0;
    for (Index f = 0; f < level_.number_of_faces(); ++f) {
      const Index h = level_.halfedge_of_face(f);
      if (h >= level_.number_of_halfedges() || level_.face(h) != f)
        refuse(names_.face_name(f) + " has no valid half-edge: the connectivity is broken");
      const Index degree = level_.degree(h);
      if (degree < 3)
        refuse(names_.face_name(f) + " has " + std::to_string(degree) +
               " corners: a face needs at least three");
      corners += degree;
      least = (std::min)(least, degree);
      greatest = (std::max)(greatest, degree);
    }
    std::uint64_t with_face = 0;
    for (Index h = 0; h < level_.number_of_halfedges(); ++h)
      if (!level_.is_border(h)) ++with_face;
    if (with_face != corners) refuse_several_loops();
    size_.corners = corners;
    level_.set_uniform_degree(least == greatest ? least : 0);
  }

  void check_vertices()
  {
    std::vector<bool> reached(level_.number_of_halfedges(), false);
    for (Index v = 0; v < level_.number_of_vertices(); ++v) check_vertex(v, reached);
    for (Index h = 0; h < level_.number_of_halfedges(); ++h) {
      if (reached[h]) continue;
      if (level_.is_isolated(level_.target(h)))
        refuse(names_.vertex_name(level_.target(h)) + " stores no half-edge, but " +
               names_.halfedge_name(h) + " leads to it: the connectivity is broken");
      refuse_several_fans(level_.target(h));
    }
  }

  void check_vertex(Index v, std::vector<bool>& reached)
  {
    const Index first = level_.halfedge_of_vertex(v);
    if (first == null) {
      ++size_.isolated_vertices;
      return;
    }
    if (first >= level_.number_of_halfedges() || level_.target(first) != v)
      refuse(names_.vertex_name(v) + " has no valid half-edge: the connectivity is broken");
    Index gaps = 0, valence = 0;
    for (const Index h : halfedges_around_target(level_, first)) {
      ++valence;
      reached[h] = true;
      if (level_.is_border(h)) {
        ++gaps;
        level_.set_halfedge_of_vertex(v, h);
      }
    }
    if (gaps > 1) refuse_several_fans(v);
    if (gaps == 1) size_.border_valences += valence;
  }

  // \pre the loops that the faces store leave out a half-edge with a face
  [[noreturn]] void refuse_several_loops() const
  {
    std::vector<bool> reached(level_.number_of_halfedges(), false);
    for (Index f = 0; f < level_.number_of_faces(); ++f)
      for (const Index h : halfedges_around_face(level_, level_.halfedge_of_face(f)))
        reached[h] = true;
    Index h = 0;
    while (level_.is_border(h) || reached[h]) ++h;
    refuse(names_.face_name(level_.face(h)) + " has several loops of half-edges, one with " +
           names_.halfedge_name(h) + ": the connectivity is broken");
  }

  [[noreturn]] void refuse_several_fans(Index v) const
  {
    refuse(names_.vertex_name(v) +
           " joins several fans of faces (bow-tie): duplicate the vertex, for " +
           "instance with CGAL::Polygon_mesh_processing::duplicate_non_manifold_vertices()");
  }

  Level_connectivity& level_;
  const Element_names& names_;
  Level_size size_;
};

// A template only for the library, which has it compiled.
template <class Names>
void check_connectivity(Level_connectivity& level, const Names& names)
{
  Connectivity_check(level, names)();
}
#ifdef CGAL_PN_SUBDIVISION_3_DOUBLE
extern template void check_connectivity(Level_connectivity&, const Element_names&);
#endif

// What a scheme refuses in a control mesh, by the name of the element.

inline void check_face_degrees(const Level_connectivity& level, const Element_names& names,
                               Level_connectivity::Index degree, const char* advice)
{
  if (level.uniform_degree() == degree) return;
  for (Level_connectivity::Index f = 0; f < level.number_of_faces(); ++f) {
    const auto h = level.halfedge_of_face(f);
    if (!level.has_degree(h, degree))
      throw std::invalid_argument("PN_subdivision_3: " + names.face_name(f) + " has " +
                                  std::to_string(level.degree(h)) + " corners: the scheme takes " +
                                  advice);
  }
}

inline void check_triangles(const Level_connectivity& level, const Element_names& names)
{
  check_face_degrees(level, names, 3, "triangles only; triangulate the mesh");
}

inline void check_quadrilaterals(const Level_connectivity& level, const Element_names& names)
{
  check_face_degrees(level, names, 4,
                     "quadrilaterals only; apply one round of Catmull-Clark first");
}

// The interpolatory schemes have no rule for an interior vertex of valence 2, and Doo-Sabin would make a face
// with two corners of it, which is no face of a polygon mesh.
inline void check_interior_valences(const Level_connectivity& level, const Element_names& names)
{
  for (Level_connectivity::Index v = 0; v < level.number_of_vertices(); ++v) {
    const auto h = level.halfedge_of_vertex(v);
    if (h == Level_connectivity::null || level.is_border(h)) continue;
    if (level.next_around_target(level.next_around_target(h)) == h)
      throw std::invalid_argument("PN_subdivision_3: " + names.vertex_name(v) +
                                  " has valence 2: the scheme has no rule for an interior vertex "
                                  "with two edges; join them");
  }
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_HOSTS_CHECK_CONNECTIVITY_H

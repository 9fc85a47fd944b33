// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_SURFACE_PIECE_H
#define CGAL_PN_LIMIT_SURFACE_3_SURFACE_PIECE_H

#include <CGAL/PN_limit_surface_3/internal/pieces/Piece_levels.h>
#include <CGAL/PN_limit_surface_3/limit/Limit_point.h>
#include <CGAL/PN_subdivision_3/attributes.h>
#include <CGAL/PN_subdivision_3/internal/attributes/Refined_attributes.h>
#include <CGAL/PN_subdivision_3/internal/calls/concept_checks.h>
#include <CGAL/PN_subdivision_3/internal/meshes/Mesh_writer.h>
#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
#include <CGAL/PN_subdivision_3/internal/meshes/with_mesh_access.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::PN_subdivision_3 {

template <class Scheme, class GeomTraits, class Concurrency_tag>
class Surface_pieces;

/*!
\ingroup PkgPNSubdivision3Functions

A piece of a refined surface, made by `Surface_pieces`: the faces that it owns and, if asked for, rings of faces
around them; and the vertices of all these.

Vertices and faces are numbered from zero; `vertex_number()` and `face_number()` tell their numbers in the whole
surface, which increase. A vertex between several pieces is in each of them, with the same bits, and one of
them owns it. If faces of a piece touch in a vertex alone, the vertex is there twice, with one number.

\tparam GeomTraits a model of `Kernel`
*/
template <class GeomTraits>
class Surface_piece
{
public:
  /// a point.
  using Point_3 = typename GeomTraits::Point_3;
  /// a normal.
  using Vector_3 = typename GeomTraits::Vector_3;
  /// the number of an element in the piece.
  using Index = Level_connectivity::Index;
  /// the number of an element in the whole surface.
  using Number = std::uint64_t;

  /// the number of vertices of the piece.
  std::size_t number_of_vertices() const { return points_.size(); }
  /// the number of faces of the piece.
  std::size_t number_of_faces() const { return faces_.size(); }

  /// the number of a vertex in the whole surface.
  Number vertex_number(Index v) const { return vertices_.number(v); }
  /// the number of a face in the whole surface.
  Number face_number(Index f) const { return faces_.number(f); }
  /// Every vertex of the surface has one owner among the pieces.
  bool owns_vertex(Index v) const { return vertices_.is_owned(v); }
  /// So has every face, which without rings is in no other piece.
  bool owns_face(Index f) const { return faces_.is_owned(f); }

  /// the points of the vertices.
  const std::vector<Point_3>& points() const& { return points_; }
  const std::vector<Point_3>& points() const&& = delete; // of a piece that is gone
  /// the control normals of the vertices, or those of the limit surface if they are asked for; with a linear scheme
  /// none but these.
  const std::vector<Vector_3>& normals() const& { return normals_; }
  const std::vector<Vector_3>& normals() const&& = delete; // of a piece that is gone
  /// the roundness of the vertices; none with a linear scheme.
  const std::vector<typename GeomTraits::FT>& roundness() const& { return roundness_; }
  const std::vector<typename GeomTraits::FT>&
  roundness() const&& = delete; // of a piece that is gone
  /// the faces, as flat arrays. The first half-edge of a face is that of the whole surface.
  const Level_connectivity& connectivity() const& { return connectivity_; }
  const Level_connectivity& connectivity() const&& = delete; // of a piece that is gone

  /*!
  makes a mesh of the piece, with the same numbers of vertices and faces.
  \tparam PolygonMesh a model of `MutableFaceGraph`
  \param mesh an empty mesh
  \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `vertex_point_map`,
    `vertex_normal_map` and `attributes`, which are written. Attributes are a table, or maps of `mesh` of the same
    kinds and types, in the same order, as those that were read
  \throws std::invalid_argument if the mesh is not empty, or if the attributes are others
  */
  template <class PolygonMesh, class NamedParameters = parameters::Default_named_parameters>
  void build_mesh(PolygonMesh& mesh, const NamedParameters& np = parameters::default_values()) const
  {
    internal::check_are_read<NamedParameters, internal::attributes_t>();
    if constexpr (internal::check_build_arguments<PolygonMesh, NamedParameters>() &&
                  internal::check_attributes<PolygonMesh, NamedParameters>()) {
      using Parameters = internal::Surface_parameters<PolygonMesh, NamedParameters>;
      internal::with_mesh_access(mesh, [&](auto& access) {
        auto given = Parameters::attributes(np);
        auto& attributes = internal::unwrapped(given);
        internal::build_mesh(access, connectivity_, Parameters::point_map(mesh, np), points_,
                             Parameters::normal_map(np), normals_,
                             [&] { attributes_.put_all(access, connectivity_, attributes); });
      });
    }
  }

  /// \name Corners
  /// A corner of a face is named by its half-edge, at whose target it is. If sharp edges divide the faces around a
  /// vertex into several wedges, a corner has one of several normals.
  /// @{

  /// which of the wedges of its vertex a corner belongs to: a number, 0 where there is one wedge.
  Index corner_wedge(Index h) const
  {
    const Corner* corner = corner_at(h);
    return corner == nullptr ? 0 : corner->wedge;
  }
  /// the normal of a corner, of which `normals()` has the mean.
  /// \pre `normals()` has some
  Vector_3 corner_normal(Index h) const
  {
    const Corner* corner = corner_at(h);
    return corner == nullptr ? normals_[connectivity_.target(h)] : corner->normal;
  }
  /// a corner of a vertex with several wedges.
  struct Corner
  {
    Index halfedge;  ///< the half-edge.
    Index wedge;     ///< see `corner_wedge()`.
    Vector_3 normal; ///< see `corner_normal()`.
  };
  /// all such corners, in the order of the half-edges.
  const std::vector<Corner>& corners_of_several_wedges() const& { return corners_; }
  const std::vector<Corner>&
  corners_of_several_wedges() const&& = delete; // of a piece that is gone
  /// @}

  /// the attributes, if a table is given: of the vertices, half-edges, edges and faces of `connectivity()`, where parents of
  /// faces are control faces; else null.
  const Attribute_table* attributes() const& { return attributes_.table(); }
  const Attribute_table* attributes() const&& = delete; // of a piece that is gone

  /// what was reached at the vertices that the piece owns, if limits are asked for.
  const Limit_report& limit_report() const { return limit_report_; }

private:
  template <class Scheme, class Traits, class Concurrency_tag>
  friend class Surface_pieces;

  const Corner* corner_at(Index h) const
  {
    const auto it = std::lower_bound(corners_.begin(), corners_.end(), h,
                                     [](const Corner& c, Index i) { return c.halfedge < i; });
    return it != corners_.end() && it->halfedge == h ? &*it : nullptr;
  }

  Level_connectivity connectivity_;
  internal::Global_ids vertices_, faces_;
  std::vector<Point_3> points_;
  std::vector<Vector_3> normals_;
  std::vector<typename GeomTraits::FT> roundness_;
  std::vector<Corner> corners_; // of vertices with several wedges
  internal::Refined_attributes attributes_;
  Limit_report limit_report_;
};

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_LIMIT_SURFACE_3_SURFACE_PIECE_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_SURFACE_REFINER_H
#define CGAL_PN_SUBDIVISION_3_SURFACE_REFINER_H

#include <CGAL/PN_subdivision_3/attributes.h>
#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/attributes/Refined_attributes.h>
#include <CGAL/PN_subdivision_3/internal/average/input_checks.h>
#include <CGAL/PN_subdivision_3/internal/calls/concept_checks.h>
#include <CGAL/PN_subdivision_3/internal/creases/ended_creases.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/meshes/Mesh_values.h>
#include <CGAL/PN_subdivision_3/internal/meshes/Mesh_writer.h>
#include <CGAL/PN_subdivision_3/internal/meshes/slot_normals.h>
#include <CGAL/PN_subdivision_3/internal/refiner/Stored_refinement.h>
#include <CGAL/PN_subdivision_3/internal/refiner/Stored_rounds.h>
#include <CGAL/PN_subdivision_3/internal/rounds/Round.h>
#include <CGAL/PN_subdivision_3/internal/schemes/on_host.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/subdivide.h>

#include <cstddef>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Functions

A refined surface that follows its control points and control normals.

`subdivide()` pays for connectivity in every call. A refiner pays once: it keeps the levels and the masks
of a control mesh, a scheme and a number of rounds, and where control points or normals change it
recomputes only what they affect. This is what modeling tools
need. The result is that of `subdivide()`, bit for bit.

\code{.cpp}
Surface_refiner refiner(mesh, CatmullClark_scheme(),
                        CGAL::parameters::number_of_iterations(4).vertex_normal_map(normals));
refiner.build_mesh(refined);
refiner.set_normal(v, Vector_3(0, 0, 1)); // v: a vertex of mesh
refiner.update();
refiner.update_mesh(refined);
\endcode

Control vertices are named by their descriptors in the control mesh. The refiner keeps its `vertex_index_map`,
but no reference to the mesh. Flat arrays, for renderers, have the refined vertices in the order of `vertices()`
of the built mesh.

Without a `vertex_normal_map`, control normals are estimated from the points, and again with every
`update()` after a point was set; a normal that is set stays as it is.

<b>Creases.</b> Sharp edges and vertices and `border` are those of `subdivide()`: points and normals move, the
sharpness stays. The tangents of creases are made anew from the control points and normals. A control vertex between
creases has a normal on each side, which are estimated, or given by a `vertex_normal_map` of half-edges, and then
stay; `normals()` holds their mean, as does the `vertex_normal_map` of `subdivide()`. Every `update()` recomputes
all creases.

<b>Attributes.</b> Attributes are named as for `subdivide()` and do not depend on the points of the control mesh: they
are refined once, by the constructor, and `build_mesh()` puts them.

<b>Memory.</b> 12 bytes for each half-edge, 52 for each vertex and 4 for each face of every level but the last in
`double`, besides the results (`points()` and `normals()`, 48 bytes per vertex, and refined attributes). The first
`update()` that does not evaluate everything finds out which vertices each vertex reaches, and keeps it: 4 bytes for
each entry of the rows, 6.3 per refined vertex with Catmull-Clark subdivision. See `memory()`.

<b>Exceptions.</b> If `update()` throws, `points()` and `normals()` may hold old values and new ones; the
next call evaluates everything. All other members have the strong guarantee.

Different refiners may be used by different threads at the same time, one of them by one thread only.

\tparam PolygonMesh a model of `FaceListGraph`: the control mesh
\tparam Scheme a model of `PNSubdivisionScheme_3`, or its `linear()` twin; none that transfers curvature,
  such as `Loop_scheme::Transfer`
\tparam GeomTraits a model of `Kernel`, by default that of the points of the mesh; its `FT` is the number type of all
  computations
\tparam Concurrency_tag `Sequential_tag`, `Parallel_tag` (which needs TBB) or
  `Parallel_if_available_tag`. The result is the same, bit for bit, for any number of threads.
*/
template <class PolygonMesh, class Scheme,
          class GeomTraits = typename internal::Surface_parameters<
            PolygonMesh, parameters::Default_named_parameters>::Geom_traits,
          class Concurrency_tag = Sequential_tag>
class Surface_refiner
{
  static_assert(internal::check_no_grid_rows<Scheme>());
  static_assert(internal::Is_any<Scheme>::value || !internal::Has_curvature_transfer<Scheme>::value,
                "PN_subdivision_3: Surface_refiner takes no scheme that transfers curvature");

  using FT = typename GeomTraits::FT;
  static constexpr bool is_pn = internal::is_pn_v<Scheme>;
  using Average = internal::Average_of_scheme<Scheme, FT>;
  using Value = typename Average::Value;
  using Control = internal::Control_values<Average>;

public:
  /// a point.
  using Point_3 = typename GeomTraits::Point_3;
  /// a normal.
  using Vector_3 = typename GeomTraits::Vector_3;
  /// a vertex of the control mesh.
  using vertex_descriptor = typename boost::graph_traits<PolygonMesh>::vertex_descriptor;
  /// the number of a refined vertex in the flat arrays.
  using Index = Level_connectivity::Index;

  /// the refiner of an empty mesh, to which another one can be assigned.
  Surface_refiner() = default;

  /*!
  reads a mesh, and computes its refinement.

  \param mesh an oriented 2-manifold with border; it is not needed afterwards
  \param scheme the scheme
  \param np an optional sequence of \ref bgl_namedparameters "Named Parameters":
    `vertex_index_map`, a model of `ReadablePropertyMap` with different integers for different vertices, by default
    that of the mesh. As in `subdivide()` are `number_of_iterations`, `vertex_point_map`, `vertex_normal_map` with the
    control normals (without it they are estimated), `vertex_roundness_map` or `roundness`, `edge_is_constrained_map`,
    `vertex_is_constrained_map`, `border`, `control_normal_estimate`, `attributes` and `geom_traits`. Maps and
    attributes are read only

  \throws std::invalid_argument if two vertices have one index, or an index is negative
  \throws std::invalid_argument, std::length_error, std::overflow_error, std::domain_error as
    `subdivide()` does
  */
  template <class NamedParameters = parameters::Default_named_parameters>
  Surface_refiner(const PolygonMesh& mesh, const Scheme& scheme,
                  const NamedParameters& np = parameters::default_values())
  {
    internal::check_are_read<NamedParameters, internal::Read_of_control_mesh,
                             internal::attributes_t>();
    if constexpr (internal::check_named_parameters<NamedParameters>()) {
      control_vertices_ = internal::Control_vertices<PolygonMesh>(mesh, np);
      internal::with_scheme_of_call<void, internal::Surface_call<PolygonMesh, NamedParameters>>(
        scheme, np, [&](const auto& s, const auto& others) {
          if (internal::facts_of(s).transfers_curvature)
            throw std::invalid_argument("PN_subdivision_3: Surface_refiner takes no scheme that "
                                        "transfers curvature");
          this->read_mesh(mesh, s, others);
        });
    }
  }

  /// \name Size
  /// @{

  /// the number of vertices of the control mesh.
  std::size_t number_of_control_vertices() const { return control_ ? control_->size() : 0; }
  /// the number of refined vertices.
  std::size_t number_of_vertices() const { return points_.size(); }
  /// the number of refined faces.
  std::size_t number_of_faces() const
  {
    return rounds_ ? static_cast<std::size_t>(rounds_->refined_size().faces) : 0;
  }
  /// the bytes that the refiner keeps, without what the masks of a scheme may keep.
  std::size_t memory() const
  {
    if (!rounds_) return 0;
    return rounds_->memory() + control_->memory() + control_vertices_.memory() +
           points_.capacity() * sizeof(Point_3) + normals_.capacity() * sizeof(Vector_3) +
           changed_.capacity() * sizeof(Index) + attributes_.memory();
  }
  /// @}

  /// \name Control points and normals
  /// What is set counts from the next `update()` on.
  /// @{

  /// \throws std::out_of_range if the control mesh had no such vertex
  /// \throws std::invalid_argument if the point is not finite
  void set_point(vertex_descriptor v, const Point_3& p)
  {
    control_->set_point(control_vertices_.position(v), internal::coordinates_3<FT>(p));
  }

  /// the zero vector means that the vertex has no control normal, vectors of other lengths are
  /// normalized.
  /// \throws std::out_of_range if the control mesh had no such vertex
  /// \throws std::invalid_argument if the vector is not finite, or if the vertex has several normals, one on
  /// each side of its creases
  void set_normal(vertex_descriptor v, const Vector_3& n)
  {
    static_assert(is_pn, "PN_subdivision_3: a linear scheme has no control normals");
    control_->set_normal(control_vertices_.position(v), internal::coordinates_3<FT>(n));
  }

  /// \throws std::out_of_range if the control mesh had no such vertex
  Point_3 control_point(vertex_descriptor v) const
  {
    const Coordinates& p = internal::point_of((*control_)[control_vertices_.position(v)]);
    return Point_3(p[0], p[1], p[2]);
  }
  /// the normal that was set or read, normalized; an estimated one as of the last `update()`.
  /// \throws std::out_of_range if the control mesh had no such vertex
  Vector_3 control_normal(vertex_descriptor v) const
  {
    static_assert(is_pn, "PN_subdivision_3: a linear scheme has no control normals");
    const Coordinates& n = (*control_)[control_vertices_.position(v)].normal;
    return Vector_3(n[0], n[1], n[2]);
  }
  /// @}

  /// \name The refined surface
  /// @{

  /*!
  computes what the control points and normals that were set since the last call reach.
  \returns the numbers of the refined vertices that were computed, in increasing order, valid until the next call
  \throws std::overflow_error if a new point is out of the range of a floating point type
  \throws std::domain_error if an interval number type leaves a comparison undecided.
  <br><b>Cost:</b> Linear in the number of vertices that are reached. The first call that does not reach all of them
  is linear in the number of vertices
  */
  const std::vector<Index>& update()
  {
    if (!rounds_) return changed_;
    try {
      std::vector<Index> changed = rounds_->take(*control_);
      // where many vertices are changed nearly all are reached
      if (4 * changed.size() > control_->size())
        evaluate_all();
      else
        evaluate_from(std::move(changed));
    } catch (...) {
      control_->change_all();
      throw;
    }
    return changed_;
  }

  /// the points of the refined vertices, as of the last `update()`.
  const std::vector<Point_3>& points() const { return points_; }
  /// the control normals of the refined vertices, as of the last `update()`; none with a linear scheme.
  const std::vector<Vector_3>& normals() const { return normals_; }

  /// the connectivity of the refined surface, as flat arrays.
  /// <br><b>Cost:</b> linear in the size of the refined surface, in each call
  Level_connectivity connectivity() const
  {
    return rounds_ ? rounds_->refined_level() : Level_connectivity();
  }

  /*!
  makes a mesh of the refined surface.
  \tparam RefinedMesh a model of `MutableFaceGraph`
  \param mesh an empty mesh
  \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `vertex_point_map` and
    `vertex_normal_map`, which are written; the normal map may be of half-edges, and gets the normals of corners (after
    0 rounds those of their vertices). `attributes` is what gets the attributes: a table, or maps of `mesh` of the same
    kinds, with the same types of values, in the same order as the constructor was given
  \throws std::invalid_argument if the mesh is not empty, or if the attributes are others
  \throws std::length_error if the index type of the mesh cannot number the elements
  */
  template <class RefinedMesh, class NamedParameters = parameters::Default_named_parameters>
  void build_mesh(RefinedMesh& mesh, const NamedParameters& np = parameters::default_values()) const
  {
    internal::check_are_read<NamedParameters, internal::attributes_t>();
    if constexpr (internal::check_build_arguments<RefinedMesh, NamedParameters, true>() &&
                  internal::check_attributes<RefinedMesh, NamedParameters>()) {
      const Level_connectivity refined = connectivity();
      using Parameters = internal::Surface_parameters<RefinedMesh, NamedParameters>;
      internal::with_mesh_access(mesh, [&](auto& access) {
        auto given = Parameters::attributes(np);
        auto& attributes = internal::unwrapped(given);
        const auto map = Parameters::normal_map(np);
        using Writers =
          internal::Normal_writers<std::decay_t<decltype(access)>, std::decay_t<decltype(map)>>;
        internal::build_mesh(access, refined, Parameters::point_map(mesh, np), points_,
                             Writers::vertex_map(map), normals_, [&] {
                               if constexpr (is_pn && Writers::Corner_writer::takes_corners)
                                 put_corner_normals(access, refined, map);
                               attributes_.put_all(access, refined, attributes);
                             });
      });
    }
  }

  /*!
  puts the points and normals that the last `update()` computed into a mesh that `build_mesh()` made and that has not
  changed since.
  \tparam RefinedMesh the type of mesh that `build_mesh()` was given
  \param mesh the mesh
  \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `vertex_point_map` and
    `vertex_normal_map` of vertices, which are written
  \throws std::invalid_argument if the mesh has another number of vertices
  <br><b>Cost:</b> linear in the number of vertices computed for a `Surface_mesh`, in that of all for other meshes
  */
  template <class RefinedMesh, class NamedParameters = parameters::Default_named_parameters>
  void update_mesh(RefinedMesh& mesh,
                   const NamedParameters& np = parameters::default_values()) const
  {
    internal::check_are_read<NamedParameters>();
    if constexpr (internal::check_build_arguments<RefinedMesh, NamedParameters>()) {
      using Parameters = internal::Surface_parameters<RefinedMesh, NamedParameters>;
      const auto map = Parameters::normal_map(np);
      const auto points = Parameters::point_map(mesh, np);
      internal::with_mesh_access(mesh, [&](auto& access) {
        if (access.size().vertices != number_of_vertices())
          throw std::invalid_argument(
            "PN_subdivision_3: the mesh has another number of vertices than the refined surface");
        for (const Index v : changed_) {
          put(points, access.vertex(v), points_[v]);
          if constexpr (is_pn && internal::is_there_v<std::decay_t<decltype(map)>>)
            put(map, access.vertex(v), normals_[v]);
        }
      });
    }
  }
  /// @}

private:
  using Coordinates = PN_subdivision_3::Coordinates<FT, 3>;

  // the scheme has a host; a linear one has no use for normals
  template <class Hosted_scheme, class NamedParameters>
  void read_mesh(const PolygonMesh& mesh, const Hosted_scheme& scheme, const NamedParameters& np)
  {
    if constexpr (internal::check_refiner_arguments<PolygonMesh, Hosted_scheme,
                                                    NamedParameters>() &&
                  internal::check_attributes<PolygonMesh, NamedParameters, false>()) {
      internal::with_mesh_access(mesh, [&](const auto& access) {
        using Parameters = internal::Surface_parameters<PolygonMesh, NamedParameters>;
        this->read(access, mesh, scheme, Parameters::template used_normal_map<is_pn>(np), np);
      });
      update();
    }
  }

  template <class Access, class Hosted_scheme, class Normal_map, class NamedParameters>
  void read(const Access& access, const PolygonMesh& mesh, const Hosted_scheme& scheme,
            const Normal_map& normals, const NamedParameters& np)
  {
    using Parameters = internal::Surface_parameters<PolygonMesh, NamedParameters>;
    const auto roundness = internal::read_roundness<FT, Parameters>(access, np);
    const auto edge_map = Parameters::edge_constraint_map(np);
    const auto vertex_map = Parameters::vertex_constraint_map(np);
    internal::require_crease_rules(scheme, access, normals, edge_map, vertex_map);
    internal::Control_mesh control(scheme, access, normals, edge_map, vertex_map, FT());
    using Level_creases = typename decltype(control)::Level_creases;
    Level_connectivity& level = control.level;
    auto& creases = control.creases;
    const unsigned rounds = internal::number_of_rounds(level, Parameters::number_of_iterations(np));
    const Level_size size = internal::checked_refined_size<typename Hosted_scheme::Host>(
      level.size(), rounds, Level_connectivity::null);
    if (rounds == 0) creases = Level_creases(level.number_of_vertices());
    using Writers = internal::Normal_writers<Access, Normal_map>;
    constexpr bool takes_corners = Writers::Corner_writer::takes_corners;
    control_ = std::make_unique<Control>(
      access, level, Parameters::const_point_map(mesh, np), Writers::vertex_map(normals),
      internal::normal_estimate(scheme), takes_corners || !creases.empty());
    if constexpr (takes_corners) read_corners(access, level, creases, normals);
    control_->set_roundness(roundness);
    const auto for_chunks = internal::For_chunks::with(Concurrency_tag());
    auto given = Parameters::attributes(np);
    const auto& attributes = internal::unwrapped(given);
    if constexpr (internal::is_there_v<std::decay_t<decltype(attributes)>>)
      attributes_.refine<FT>(scheme, access, level, creases, control.maps.sharpness(level), rounds,
                             attributes, for_chunks);
    points_.assign(size.vertices, Point_3(0, 0, 0));
    if (is_pn) normals_.assign(size.vertices, Vector_3(0, 0, 0));
    rounds_ = std::make_unique<internal::Stored_rounds<Hosted_scheme, Average, Level_creases>>(
      scheme, std::move(level), std::move(creases), rounds, *control_, for_chunks);
  }

  template <class Access, class Level_creases, class Normal_map>
  void read_corners(const Access& access, const Level_connectivity& level,
                    const Level_creases& creases, const Normal_map& normals)
  {
    const auto read = [&](const auto& creases_of_slots) {
      std::vector<Value> values(creases_of_slots.number_of_slots);
      std::vector<bool> is_put(values.size(), !internal::is_of_estimate_v<Normal_map>);
      internal::read_corner_normals<FT>(access, level, creases_of_slots, normals, values, &is_put);
      return typename Control::Given_slots{std::move(values), std::move(is_put)};
    };
    control_->set_slots(read(creases));
    if constexpr (internal::are_creases_v<Level_creases>)
      if (internal::has_fractions(creases))
        control_->slots_without_fractions() =
          read(internal::Creases_without_fractions<FT>(level, creases).creases);
  }

  template <class Access, class Map>
  void put_corner_normals(const Access& access, const Level_connectivity& refined, Map map) const
  {
    rounds_->for_each_corner(refined, [&](Index h, const Value* value) {
      const Vector_3& n = normals_[refined.target(h)];
      put(map, access.halfedge_at(h),
          value == nullptr ? n : Vector_3(value->normal[0], value->normal[1], value->normal[2]));
    });
  }

  void evaluate_all()
  {
    changed_.resize(points_.size());
    std::iota(changed_.begin(), changed_.end(), Index(0));
    rounds_->evaluate([&](Index first, const Value* values, Index n) {
      for (Index i = 0; i < n; ++i) store(first + i, values[i]);
    });
  }

  void evaluate_from(std::vector<Index> control_vertices)
  {
    changed_ = rounds_->evaluate_from(std::move(control_vertices),
                                      [&](const Index* vertices, const Value* values, Index n) {
                                        for (Index i = 0; i < n; ++i) store(vertices[i], values[i]);
                                      });
  }

  void store(Index v, const Value& value)
  {
    const Coordinates& p = internal::point_of(value);
    if (control_->is_near_overflow())
      internal::check_in_range(p,
                               [&] { return "the point of the new vertex " + std::to_string(v); });
    points_[v] = Point_3(p[0], p[1], p[2]);
    if constexpr (is_pn) normals_[v] = Vector_3(value.normal[0], value.normal[1], value.normal[2]);
  }

  internal::Control_vertices<PolygonMesh> control_vertices_;
  std::unique_ptr<Control> control_;
  std::unique_ptr<internal::Stored_refinement<Average>> rounds_;
  std::vector<Point_3> points_;
  std::vector<Vector_3> normals_;
  std::vector<Index> changed_;
  internal::Refined_attributes attributes_;
};

template <class PolygonMesh, class Scheme,
          class NamedParameters = parameters::Default_named_parameters>
Surface_refiner(const PolygonMesh&, const Scheme&,
                const NamedParameters& = parameters::default_values())
  -> Surface_refiner<PolygonMesh, Scheme,
                     internal::Geom_traits_of_call<PolygonMesh, NamedParameters>>;

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_SUBDIVISION_3_SURFACE_REFINER_H

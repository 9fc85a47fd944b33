// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_REFINE_IN_PIECES_H
#define CGAL_PN_LIMIT_SURFACE_3_REFINE_IN_PIECES_H

#include <CGAL/Bbox_3.h>
#include <CGAL/PN_limit_surface_3/Surface_piece.h>
#include <CGAL/PN_limit_surface_3/internal/pieces/Piece_levels.h>
#include <CGAL/PN_limit_surface_3/internal/pieces/Piece_limits.h>
#include <CGAL/PN_limit_surface_3/internal/pieces/Piece_refiner.h>
#include <CGAL/PN_subdivision_3/attributes.h>
#include <CGAL/PN_subdivision_3/internal/attributes/Refined_attributes.h>
#include <CGAL/PN_subdivision_3/internal/average/input_checks.h>
#include <CGAL/PN_subdivision_3/internal/calls/concept_checks.h>
#include <CGAL/PN_subdivision_3/internal/meshes/Mesh_values.h>
#include <CGAL/PN_subdivision_3/internal/meshes/read_mesh.h>
#include <CGAL/PN_subdivision_3/internal/rounds/Round.h>
#include <CGAL/PN_subdivision_3/internal/schemes/on_host.h>
#include <CGAL/PN_subdivision_3/subdivide.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL::PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Functions

A refined surface that is made piece by piece, because it is too large for memory.

The pieces together are what `subdivide()` gives, bit for bit: the same points and normals under the same numbers,
without gaps between the pieces. Options that let the compiler fuse products and sums, such as `-march=native`, may
change last bits. Each is made from the control mesh alone, so that several threads or machines can make different
ones without communication.

\code{.cpp}
Surface_pieces pieces(mesh, CatmullClark_scheme(),
                      parameters::number_of_pieces(64).number_of_iterations(9).vertex_normal_map(normals));
for (std::size_t i = 0; i < pieces.number_of_pieces(); ++i) {
  const auto piece = pieces.piece(i); // 1/64 of the surface
  ...
}
\endcode

The control mesh is refined until there are at least 16 faces for each piece. These are divided, by planes,
into pieces with about equally many corners. A piece is refined together with `Scheme::ghost_rings` rings of
faces around it: as many as the scheme needs to get as many right in the next level, and one more if there are creases.
They are cut off in the last level. Numbers of children follow from those of their parents only where edges are split in halves:
other schemes (Doo-Sabin, \f$ \sqrt{3} \f$) are refused, and `subdivide()` refines the mesh as a whole.

<b>Creases.</b> Sharp edges and vertices, `border`, `crease_tangent_map` and normals of half-edges are
those of `subdivide()`. `Surface_piece::normals()` has the mean normal of the wedges of a vertex, as a vertex
normal map has it after `subdivide()`, and `Surface_piece::corner_normal()` returns that of each wedge.

<b>Limits.</b> With `parameters::to_limit(true)` the vertices are on the limit surface, with
`parameters::surface_normals(true)` beside it they have its normals: those of `subdivide_to_limit()`, bit for bit. The
`tolerance` is a part of the size of the refined surface. For this size the first piece that is made goes over all
pieces, without limits, which takes a small part of the time of limits. Several machines can share that work: each
computes `box_of_piece()` of some pieces, and passes the union of all boxes to `set_box()`. Pieces then have about
seven rings of faces around them instead of the ghost rings; after the rounds, sharpness must be infinite or used up.

<b>Memory.</b> The level that is divided, about 190 bytes a face, as long as the object lives. A call of
`piece()` needs 210 bytes for each quad of the piece in `double` (half as many for a triangle), 100 of which
are the result, its rings included.

<b>Exceptions.</b> All members have the strong guarantee.

<b>Attributes.</b> `attributes` are read as by `subdivide()`, and not changed: each piece has its part of what they become,
see `Surface_piece::attributes()` and `Surface_piece::build_mesh()`. With them the last round is held as the others are, and
where a map of corners has seams there is a ring more. The object keeps no reference to
the mesh. Its members may be called by several threads at the same time.

\tparam Scheme a model of `PNSubdivisionScheme_3` that splits edges and faces as Catmull-Clark or Loop do and has a static
  constant `ghost_rings`, or its `linear()` twin. All schemes of this package are but Doo-Sabin's and \f$ \sqrt{3} \f$.
\tparam GeomTraits a model of `Kernel`; its `FT` is the number type of all computations
\tparam Concurrency_tag `Sequential_tag`, `Parallel_tag` (which needs TBB) or
  `Parallel_if_available_tag`: how many threads work at a piece. The result is the same, bit for bit.
*/
template <class Scheme, class GeomTraits, class Concurrency_tag = Sequential_tag>
class Surface_pieces
{
  static_assert(internal::Is_any<Scheme>::value || internal::Ghost_rings<Scheme>::value != 0,
                "PN_subdivision_3: the scheme has no ghost_rings: it does not say how many rings "
                "of faces a piece needs around it");

  using FT = typename GeomTraits::FT;
  static constexpr bool is_pn = internal::is_pn_v<Scheme>;
  using Average = internal::Average_of_scheme<Scheme, FT>;
  using Value = typename Average::Value;

public:
  /// the type of a piece.
  using Piece = Surface_piece<GeomTraits>;
  /// the number of an element in a piece.
  using Index = typename Piece::Index;
  /// the number of an element in the whole surface.
  using Number = typename Piece::Number;

  /*!
  reads a mesh, refines it as far as it is refined as a whole, and divides it.

  \tparam PolygonMesh a model of `FaceListGraph`
  \param mesh an oriented 2-manifold with border; it is not needed afterwards
  \param scheme the scheme
  \param np an optional sequence of \ref bgl_namedparameters "Named Parameters":
    `number_of_iterations`, `vertex_point_map`, `vertex_normal_map` with the control normals (without it
    they are estimated), `vertex_roundness_map` or `roundness`, `edge_is_constrained_map`, `vertex_is_constrained_map`,
    `border`, `crease_tangent_map`, `control_normal_estimate`, `attributes` and `geom_traits`, as in `subdivide()`.
    The `number_of_pieces` is 1 by default; if there are fewer faces, some pieces are empty. The maps are read only.
    With `to_limit`, `points`, `surface_normals`, `tolerance`, `normal_tolerance` and `max_depth`, see above;
    `to_limit` is `false` by default

  \throws std::invalid_argument if there are to be no pieces, if the scheme does not split edges in halves, and as
    `subdivide_to_limit()` does if limits are asked for
  \throws std::invalid_argument, std::length_error, std::domain_error as `subdivide()` does; the limit of the
    size is \f$ 2^{60} \f$
  */
  template <class PolygonMesh, class NamedParameters = parameters::Default_named_parameters>
  Surface_pieces(const PolygonMesh& mesh, const Scheme& scheme,
                 const NamedParameters& np = parameters::default_values())
  {
    internal::check_are_read<NamedParameters, internal::Read_of_control_mesh,
                             internal::attributes_t, internal::number_of_pieces_t,
                             internal::to_limit_t, internal::tolerance_t,
                             internal::normal_tolerance_t, internal::max_depth_t,
                             internal::points_t, internal::surface_normals_t>();
    if constexpr (internal::check_named_parameters<NamedParameters>()) {
      number_of_pieces_ = internal::parameter_or<internal::number_of_pieces_t>(np, std::size_t(1));
      internal::with_scheme_of_call<void, internal::Surface_call<PolygonMesh, NamedParameters>>(
        scheme, np, [&](const auto& s, const auto& others) { this->read_mesh(mesh, s, others); });
    }
  }

  /*!
  about how many bytes the object takes, with one of its pieces, so that the number of pieces can be chosen. The level
  that is divided becomes larger with the number of pieces.
  \param scheme the scheme
  \param size the size of the control mesh
  \param rounds the number of rounds
  \param number_of_pieces how many pieces there are
  */
  static double memory([[maybe_unused]] const Scheme& scheme, const Level_size& size,
                       unsigned rounds, std::size_t number_of_pieces)
  {
    if constexpr (internal::Is_any<Scheme>::value)
      return internal::with_host<double>(scheme, [&](const auto& s) {
        return memory_with<typename std::decay_t<decltype(s)>::Host>(size, rounds,
                                                                     number_of_pieces);
      });
    else
      return memory_with<typename Scheme::Host>(size, rounds, number_of_pieces);
  }

  /// the number of pieces.
  std::size_t number_of_pieces() const { return number_of_pieces_; }
  /// whether a piece has neither faces nor vertices, because there are too few.
  /// \pre `i < number_of_pieces()`
  bool is_empty(std::size_t i) const { return refiner_->is_empty(i); }

  /// \name The whole surface
  /// @{

  /// the size of the refined surface; without isolated vertices and valences.
  const Level_size& size() const { return refiner_->result().size; }
  /// the number of the first corner of a face, if corners are counted face by face: the sum of the degrees of
  /// the faces before. For the number of faces, that of all corners.
  Number first_corner(Number face) const { return refiner_->result().corners.first(face); }
  /// the degree of the face with the most corners. <br><b>Cost:</b> linear in the level that is divided
  Index largest_degree() const
  {
    if (rounds_ > 0) return refiner_->refined_degree();
    const Level_connectivity& base = refiner_->base();
    Index degree = 0;
    for (Index f = 0; f < base.number_of_faces(); ++f)
      degree = (std::max)(degree, base.degree(base.halfedge_of_face(f)));
    return degree;
  }
  /// @}

  /*!
  makes a piece.
  \param i its number
  \param rings how many rings of faces around those that it owns it has, too, with the bits that they have in the whole
    surface; at most `Scheme::ghost_rings`, and one at the limit. With one it has all faces at the vertices of its own
  \throws std::out_of_range if there is no such piece
  \throws std::invalid_argument if these are too many rings
  \throws std::length_error if the piece is too large for 32 bit numbers
  \throws std::overflow_error if a new point is out of the range of a floating point type
  \throws std::domain_error if an interval number type leaves a comparison undecided
  */
  Piece piece(std::size_t i, unsigned rings = 0) const
  {
    if (i >= number_of_pieces_)
      throw std::out_of_range("PN_subdivision_3: there is no piece " + std::to_string(i) +
                              ": there are " + std::to_string(number_of_pieces_));
    const unsigned most_rings = limits_ ? 1 : ghost_rings_;
    if (rings > most_rings)
      throw std::invalid_argument("PN_subdivision_3: " + std::to_string(rings) +
                                  " rings around a piece, which " +
                                  (limits_ ? "at the limit" : "with this scheme") + " has " +
                                  std::to_string(most_rings) + " at most");
    if (!limits_) return piece_of(i, rings, nullptr);
    const auto demand = internal::limit_demand<FT>(limits_->options, size_of_surface());
    return piece_of(i, rings, &demand);
  }

  /// \name The size of the surface
  /// that the tolerance of limits is a part of. It is found when the first piece is made, unless it is set.
  /// @{

  /// the box of the vertices that a piece owns, as rounds make them, in `double`.
  Bbox_3 box_of_piece(std::size_t i) const
  {
    Bbox_3 box;
    if (is_empty(i)) return box;
    const Piece piece = piece_of(i, 0, nullptr);
    for (Index v = 0; v < piece.number_of_vertices(); ++v) {
      const auto& p = piece.points()[v];
      const double x = CGAL::to_double(p.x()), y = CGAL::to_double(p.y()),
                   z = CGAL::to_double(p.z());
      box += Bbox_3(x, y, z, x, y, z);
    }
    return box;
  }
  /// sets it to that of the box of all pieces, before the first piece is made.
  void set_box(const Bbox_3& box)
  {
    if (limits_) std::call_once(limits_->is_size_known, [&] { limits_->size = size_of(box); });
  }
  /// @}

private:
  struct Limits
  {
    internal::Limit_options options;
    std::once_flag is_size_known;
    double size = 0;
  };

  static double size_of(const Bbox_3& box)
  {
    return (std::max)({0., box.x_span(), box.y_span(), box.z_span()});
  }
  double size_of_surface() const
  {
    std::call_once(limits_->is_size_known, [this] {
      Bbox_3 box;
      for (std::size_t i = 0; i < number_of_pieces_; ++i) box += box_of_piece(i);
      limits_->size = size_of(box);
    });
    return limits_->size;
  }

  // demand: null, or of limits
  Piece piece_of(std::size_t i, unsigned rings, const internal::Limit_demand* demand) const
  {
    using Limit = internal::Limit_result<Average>;
    const bool has_surface_normals = demand != nullptr && demand->surface_normals;
    const bool has_normals = is_pn || has_surface_normals;
    const auto normal = [&]([[maybe_unused]] const Value& value, const Limit* limit) {
      if (limit != nullptr) return vector(internal::limit_normal(*limit, has_surface_normals));
      if constexpr (is_pn)
        return vector(value.normal);
      else
        return typename GeomTraits::Vector_3(0, 0, 0);
    };
    Piece piece;
    const auto begin = [&](Level_connectivity& connectivity, internal::Global_ids& vertices,
                           internal::Global_ids& faces) {
      piece.connectivity_ = std::move(connectivity);
      piece.vertices_ = std::move(vertices);
      piece.faces_ = std::move(faces);
      piece.points_.resize(piece.vertices_.size());
      if (has_normals) piece.normals_.resize(piece.vertices_.size());
      if (is_pn) piece.roundness_.resize(piece.vertices_.size());
    };
    const auto put = [&](Index v, const Value& refined, const Limit* limit) {
      const bool moves = limit != nullptr && demand->points;
      this->put_point(piece, v, internal::point_of(moves ? limit->value : refined));
      if (has_normals) piece.normals_[v] = normal(refined, limit);
      if constexpr (is_pn) piece.roundness_[v] = refined.roundness;
    };
    const auto put_corner = [&](Index h, Index wedge, const Value& refined, const Limit* limit) {
      piece.corners_.push_back({h, wedge, {}});
      if (has_normals) piece.corners_.back().normal = normal(refined, limit);
    };
    const auto put_attributes = [&](auto& carried) { piece.attributes_ = attributes_of_(carried); };
    const typename internal::Abstract_pieces<Average>::Output out{begin, put, put_corner,
                                                                  put_attributes};
    if (demand == nullptr)
      refiner_->refine(i, rings, out);
    else
      piece.limit_report_ = refiner_->refine_to_limit(i, rings, *demand, out);
    return piece;
  }

  template <class Host>
  static double memory_with(const Level_size& size, unsigned rounds, std::size_t number_of_pieces)
  {
    const auto bytes_of_level = [](const Level_size& s) {
      constexpr double value = 8 * sizeof(FT);
      return double(s.halfedges()) * 12 + double(s.vertices) * (value + 12) + double(s.faces) * 20;
    };
    const unsigned base_round = internal::dividing_round<Host>(size, rounds, number_of_pieces);
    Level_size base = size, parent = size, result = size;
    for (unsigned k = 1; k <= rounds; ++k) {
      if (k <= base_round) base = Host::refined_size(base, k);
      parent = result;
      result = Host::refined_size(result, k);
    }
    // the last level twice: with its rings, and without them
    constexpr double rings = 1.1, unequal = 1.1;
    const auto pieces = double(number_of_pieces);
    return 2 * bytes_of_level(base) +
           rings * unequal * (bytes_of_level(parent) + 2 * bytes_of_level(result)) / pieces;
  }

  // the scheme has a host
  template <class PolygonMesh, class Hosted_scheme, class NamedParameters>
  void read_mesh(const PolygonMesh& mesh, const Hosted_scheme& scheme, const NamedParameters& np)
  {
    if constexpr (!internal::halves_edges_v<Hosted_scheme>)
      throw std::invalid_argument(internal::no_halves(scheme, "by which pieces get their numbers",
                                                      "subdivide() for the mesh as a whole, or "));
    else if constexpr (internal::check_pieces_arguments<PolygonMesh, Hosted_scheme,
                                                        NamedParameters>() &&
                       internal::check_attributes<PolygonMesh, NamedParameters, false>()) {
      using Parameters = internal::Surface_parameters<PolygonMesh, NamedParameters>;
      ghost_rings_ = internal::facts_of(scheme).ghost_rings;
      if (ghost_rings_ == 0)
        throw std::invalid_argument("PN_subdivision_3: " + internal::name_in_message(scheme) +
                                    " has no ghost_rings: it does not say how many rings of "
                                    "faces a piece needs around it");
      if (number_of_pieces_ == 0)
        throw std::invalid_argument("PN_subdivision_3: no pieces: ask for at least one");
      const unsigned rounds = Parameters::number_of_iterations(np);
      if (internal::parameter_or<internal::to_limit_t>(np, false)) {
        limits_ = std::make_unique<Limits>();
        limits_->options = internal::limit_options(np);
        internal::limit_demand<FT>(limits_->options, 0); // refuses tolerances
      }
      internal::with_mesh_access(mesh, [&](const auto& access) {
        auto given = Parameters::attributes(np);
        const auto& attributes = internal::unwrapped(given);
        this->template read<internal::is_given_v<internal::to_limit_t, NamedParameters>>(
          access, scheme, Parameters::const_point_map(mesh, np),
          Parameters::template used_normal_map<is_pn>(np), Parameters::edge_constraint_map(np),
          Parameters::vertex_constraint_map(np),
          internal::read_roundness<FT, Parameters>(access, np), rounds, attributes);
      });
    }
  }

  template <bool may_be_limits, class Access, class Hosted_scheme, class Point_map,
            class Normal_map, class Edge_map, class Vertex_map, class Attributes>
  void read(const Access& access, const Hosted_scheme& scheme, Point_map points, Normal_map normals,
            Edge_map edge_map, Vertex_map vertex_map,
            const internal::Given_roundness<FT>& roundness, unsigned rounds,
            [[maybe_unused]] const Attributes& attributes)
  {
    using Host = typename Hosted_scheme::Host;
    if constexpr (!internal::check_corner_normals<Hosted_scheme, Access, Normal_map>()) return;
    internal::require_crease_rules(scheme, access, normals, edge_map, vertex_map);
    const internal::With_roundness<Hosted_scheme, FT> with_roundness{{scheme}, &roundness};
    internal::Control_mesh control(with_roundness, access, normals, edge_map, vertex_map, FT());
    using Level_creases = typename decltype(control)::Level_creases;
    Level_connectivity& level = control.level;
    auto& of_mesh = control.maps;
    auto& creases = control.creases;
    of_mesh.read_tangents(creases);
    rounds_ = internal::number_of_rounds(level, rounds);
    if (limits_)
      internal::require_sharp_for_ever<FT>(access, creases, rounds_);
    else if (rounds == 0)
      creases = Level_creases(level.number_of_vertices());
    constexpr std::uint64_t limit = std::uint64_t(1) << 60;
    internal::checked_refined_size<Host>(level.size(), rounds_, limit);
    const unsigned base_round =
      internal::dividing_round<Host>(level.size(), rounds_, number_of_pieces_);
    internal::checked_refined_size<Host>(level.size(), base_round, Level_connectivity::null);
    const auto values = of_mesh.values(level, points, normals, creases);
    is_near_overflow_ = std::any_of(values.begin(), values.end(), [](const Value& v) {
      return internal::is_near_overflow(internal::point_of(v));
    });
    constexpr bool has_attributes = internal::is_there_v<Attributes>;
    // as calls for all of a surface have them; no roundness of the call is read any more
    using Round_scheme = internal::Scheme_of_rounds<internal::With_roundness<Hosted_scheme, FT>>;
    using Refiner = internal::Piece_refiner<Round_scheme, Average, Level_creases, has_attributes>;
    typename Refiner::Attribute_rounds carried;
    if constexpr (has_attributes)
      if (!internal::is_empty(attributes)) {
        auto [all, of_part] = internal::Refined_attributes::for_pieces<FT, Host>(
          access, level, creases, of_mesh.sharpness(level), attributes,
          internal::For_chunks::with(Concurrency_tag()));
        carried = std::move(all);
        attributes_of_ = std::move(of_part);
      }
    const auto make = [&](auto* refiner) {
      refiner_ = std::make_unique<std::remove_pointer_t<decltype(refiner)>>(
        internal::scheme_of_rounds(internal::With_roundness<Hosted_scheme, FT>{{scheme}}),
        std::move(level), std::move(creases),
        typename Refiner::Values(values.begin(), values.end()), std::move(carried), rounds_,
        number_of_pieces_, ghost_rings_, internal::For_chunks::with(Concurrency_tag()));
    };
    if constexpr (may_be_limits)
      if (limits_)
        return make(static_cast<
                    internal::Piece_limits<Round_scheme, Average, Level_creases, has_attributes>*>(
          nullptr));
    make(static_cast<Refiner*>(nullptr));
  }

  void put_point(Piece& piece, Index v, const Coordinates<FT, 3>& p) const
  {
    if (is_near_overflow_)
      internal::check_in_range(
        p, [&] { return "the point of the new vertex " + std::to_string(piece.vertex_number(v)); });
    piece.points_[v] = typename GeomTraits::Point_3(p[0], p[1], p[2]);
  }
  static typename GeomTraits::Vector_3 vector(const Coordinates<FT, 3>& n)
  {
    return typename GeomTraits::Vector_3(n[0], n[1], n[2]);
  }

  std::size_t number_of_pieces_ = 1;
  unsigned rounds_ = 0, ghost_rings_ = 0;
  bool is_near_overflow_ = false;
  std::unique_ptr<Limits> limits_; // if they are asked for
  std::unique_ptr<internal::Abstract_pieces<Average>> refiner_;
  std::function<internal::Refined_attributes(internal::Control_attributes<FT>&)> attributes_of_;
};

template <class PolygonMesh, class Scheme,
          class NamedParameters = parameters::Default_named_parameters>
Surface_pieces(const PolygonMesh&, const Scheme&,
               const NamedParameters& = parameters::default_values())
  -> Surface_pieces<Scheme, internal::Geom_traits_of_call<PolygonMesh, NamedParameters>>;

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_LIMIT_SURFACE_3_REFINE_IN_PIECES_H

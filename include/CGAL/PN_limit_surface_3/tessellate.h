// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_TESSELLATE_H
#define CGAL_PN_LIMIT_SURFACE_3_TESSELLATE_H

#include <CGAL/Named_function_parameters.h>
#include <CGAL/PN_limit_surface_3/internal/limit/limits_at_slots.h>
#include <CGAL/PN_limit_surface_3/internal/tessellation/Proven_distance.h>
#include <CGAL/PN_limit_surface_3/internal/tessellation/run_tessellation.h>
#include <CGAL/PN_limit_surface_3/tessellation/Tessellation_result.h>
#include <CGAL/PN_subdivision_3/attributes/Attribute_traits.h>
#include <CGAL/PN_subdivision_3/internal/calls/concept_checks.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/meshes/Mesh_writer.h>
#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
#include <CGAL/PN_subdivision_3/internal/meshes/slot_normals.h>
#include <CGAL/PN_subdivision_3/internal/meshes/with_mesh_access.h>
#include <CGAL/PN_subdivision_3/internal/rounds/Round.h>
#include <CGAL/PN_subdivision_3/internal/schemes/on_host.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL::PN_subdivision_3 {
namespace internal {

// A call of tessellate(): reads the control mesh, refines it adaptively, and builds the mesh of the triangles.
template <class Concurrency_tag, class FaceGraph, class NamedParameters>
class Tessellation
{
  using Parameters = Surface_parameters<FaceGraph, NamedParameters>;
  using FT = typename Parameters::FT;
  using Index = Level_connectivity::Index;

public:
  Tessellation(double chord_error, const NamedParameters& np, Attribute_table* table)
    : chord_error_(chord_error)
    , np_(np)
    , table_(table)
    , for_chunks_(For_chunks::with(Concurrency_tag()))
  {}

  template <class OutputMesh, class Access, class Scheme, class Out_access, class Out_parameters>
  Tessellation_result operator()(const FaceGraph& control, const Access& access,
                                 const Scheme& scheme, OutputMesh& out, Out_access& out_access,
                                 const Out_parameters& np_out) const
  {
    const Level_size size = out_access.size();
    if (size.vertices != 0 || size.edges != 0 || size.faces != 0)
      throw std::invalid_argument("PN_subdivision_3: the mesh of the tessellation has vertices "
                                  "already: it must be empty");
    Tessellation_result report;
    Tessellation_runs<FT> runs(most_runs);
    const auto build_out = [&](const Split_edges<FT>& all, const Tessellation_mesh<FT>& mesh) {
      using Out = Surface_parameters<OutputMesh, Out_parameters>;
      build(all, mesh, out_access, Out::point_map(out, np_out), Out::normal_map(np_out));
    };
    with_roundness_of_call<Parameters>(access, scheme, np_, [&](const auto& s) {
      bool goes_on = false;
      do {
        read(access, s, Parameters::const_point_map(control, np_),
             [&](const Tessellation_demand& demand, auto& level, auto& creases, auto* bounds) {
               goes_on = run_tessellation<FT, may_carry_attributes<NamedParameters>()>(
                 scheme_of_rounds(s), demand, for_chunks_, table_, level, creases, bounds, runs,
                 report, build_out);
             });
      } while (goes_on);
    });
    return report;
  }

private:
  static constexpr bool may_be_proven =
    is_given_v<proven_bound_t, NamedParameters> && std::is_same_v<FT, double>;

  // calls sink(demand, level, creases, bounds)
  template <class Access, class Scheme, class Point_map, class Sink>
  void read(const Access& access, const Scheme& scheme, Point_map points, const Sink& sink) const
  {
    const auto take = [&](auto& control, auto& creases, const auto&) {
      const Tessellation_demand demand = this->demand(box_size(control));
      using Level_creases = std::decay_t<decltype(creases)>;
      std::unique_ptr<Face_bounds<typename Average_of_scheme<Scheme, FT>::Value, Level_creases>>
        bounds;
      if constexpr (may_be_proven)
        if (demand.is_proven)
          bounds = proven_bounds(scheme_of_rounds(scheme), demand.exponent, control, creases,
                                 chord_error_);
      sink(demand, control, creases, bounds.get());
    };
    with_slot_level<FT>(
      access, scheme, points, Parameters::template used_normal_map<is_pn_v<Scheme>>(np_),
      Parameters::edge_constraint_map(np_), Parameters::vertex_constraint_map(np_),
      rounds_of_all(access.size().faces), take);
  }

  static constexpr unsigned most_runs = 64;

  // how many rounds may be made of all faces, until nothing is sharp but forever
  static unsigned rounds_of_all(std::size_t faces)
  {
    constexpr std::size_t most_faces = std::size_t(1) << 22;
    unsigned rounds = 0;
    for (std::size_t n = 4 * faces; 0 < n && n <= most_faces; n *= 4) ++rounds;
    return rounds;
  }

  Tessellation_demand demand(double box) const
  {
    Tessellation_demand demand;
    // 2^-exponent is a number, too
    demand.exponent = box > 0 && std::isfinite(box) ? (std::max)(std::ilogb(box), -1000) : 0;
    demand.tolerance = std::ldexp(chord_error_, -demand.exponent);
    constexpr bool is_given = is_given_v<internal_np::number_of_iterations_t, NamedParameters>;
    demand.most_rounds = is_given ? Parameters::number_of_iterations(np_) : 12;
    demand.most_triangles = std::uint64_t(1) << 31;
    Limit_options options;
    options.surface_normals = true;
    options.normal_tolerance = 1e-4;
    demand.limits = limit_demand<FT>(options, box);
    demand.limits.tolerance =
      (std::min)(demand.limits.tolerance, (std::max)(chord_error_ / 1024, std::ldexp(box, -50)));
    demand.is_proven = parameter_or<proven_bound_t>(np_, false);
    if (demand.is_proven && !std::is_same_v<FT, double>)
      throw std::invalid_argument(
        "PN_subdivision_3: distances are proven of coordinates in double only: "
        "leave proven_bound out");
    return demand;
  }

  template <class Access, class Point_map, class Normal_map>
  static void build(const Split_edges<FT>& all, const Tessellation_mesh<FT>& mesh, Access& access,
                    Point_map point_map, Normal_map normal_map)
  {
    using Writers = Normal_writers<Access, Normal_map>;
    using Point = typename boost::property_traits<Point_map>::value_type;
    std::vector<Point> points;
    points.reserve(all.number_of_vertices());
    for (Index v = 0; v < all.number_of_vertices(); ++v) {
      const auto& p = all.point(v);
      points.emplace_back(p[0], p[1], p[2]);
    }
    build_mesh(access, mesh.level(), point_map, points, Writers::vertex_map(normal_map),
               vertex_normals<typename Writers::Vertex_map>(mesh), [&] {
                 if constexpr (Writers::Corner_writer::takes_corners)
                   mesh.for_each_corner([&](Index h, const flatness::Vector& n) {
                     using Normal = typename boost::property_traits<Normal_map>::value_type;
                     put(normal_map, access.halfedge_at(h), Normal(n[0], n[1], n[2]));
                   });
               });
  }

  template <class Normal_map>
  static auto vertex_normals([[maybe_unused]] const Tessellation_mesh<FT>& mesh)
  {
    if constexpr (!is_there_v<Normal_map>)
      return std::vector<char>();
    else {
      std::vector<typename boost::property_traits<Normal_map>::value_type> normals;
      normals.reserve(mesh.level().number_of_vertices());
      for (const flatness::Vector& n : mesh.normals()) normals.emplace_back(n[0], n[1], n[2]);
      return normals;
    }
  }

  double chord_error_;
  const NamedParameters& np_;
  const Tessellation_table table_;
  For_chunks for_chunks_;
};

// the table of attributes of a call, or null
template <class NamedParameters>
Attribute_table* attribute_table(const NamedParameters& np)
{
  if constexpr (!is_given_v<attributes_t, NamedParameters>)
    return nullptr;
  else {
    using Given = Parameter_type<attributes_t, NamedParameters>;
    static_assert(std::is_same_v<Given, std::reference_wrapper<Attribute_table>>,
                  "PN_subdivision_3: tessellate() carries the arrays of an Attribute_table: give "
                  "parameters::attributes(table)");
    if constexpr (std::is_same_v<Given, std::reference_wrapper<Attribute_table>>)
      return &parameter_or<attributes_t>(np, 0).get();
    else
      return nullptr;
  }
}

} // namespace internal

/*!
\ingroup PkgPNSubdivision3Limit

approximates the limit surface of a mesh by triangles, to a tolerance: large ones where the surface is flat,
small ones where it is curved, without cracks between them.

The vertices of the result are limit points, as from `limit_points()`, with normals of the surface. In each round only
the faces that are not flat enough are refined, with the rings of faces around them that the scheme reads, so that
time and memory are proportional to the result. Each vertex is moved to its limit once, when it is new. An edge is split
in the same way for the faces on both sides; if one of them is refined further, the triangles of the other one
include the vertices on the edge.

<b>The error.</b> The distance of the surface from the triangles of a face is estimated before they are refined, from
the limit points \f$ p_i \f$ and surface normals \f$ n_i \f$ at its corners. The height of the surface over the middle
of a chord is that of the point-normal average (`PN_average`) of its ends.
\f[ s_{ij} = \frac14\,(\tau_j-\tau_i)\cdot(p_j-p_i), \qquad \tau_i=\frac{n_i+n}{1+n_i\cdot n}, \quad
n=\frac{n_i+n_j}{|n_i+n_j|}, \f]
This height is exact on spheres and cylinders and of fourth order elsewhere. The height of a surface of second order
over a triangle is at most \f$ 4s_{12}s_{23}s_{31}/(\sum_{i<j} 2 s_is_j-\sum_i s_i^2) \f$ or the largest of the \f$
|s_{ij}| \f$. When a face is split, the distance of the new limit points from their expected places is measured; half
of it is added to the estimate of its children. At creases, corners, and where the ring has no tangent plane, there
are no surface normals. The estimate is then 0.27 to 0.45 of the distance that was measured on the parent, depending on the
limits of the control normals. On smooth surfaces a fourth of it remains. Faces of the control mesh, and children of
its polygons, always get a round, and their estimate is the measured distance. Edges on creases and borders must be as
close to their curve, which is estimated from the turns of the points of the level along it. Faces whose triangles,
with the vertices that finer neighbors put on their sides, turn out to miss the tolerance are split again. Everything
is multiplied by 1.1, at borders by 1.25. It is an estimate, not a proof.

<b>A proven bound.</b> With `parameters::proven_bound(true)` faces are split until a bound is within the tolerance.
The enclosure of `Limit_surface` bounds the distance from the limit of the linear scheme, after up to two more rounds
on the face. The linear limit lies in the hull of its Bezier points, next to an extraordinary vertex in that of
control points after up to 16 rounds. The distances of these points from the face's triangles and sides are known,
whatever vertices neighbors put on the sides. This is for coordinates in `double`, and for what
`Limit_surface::proven_bbox()` covers; it takes some milliseconds per face, and about twice as many triangles. Splits
are not undone.

<b>Surfaces bent in one direction.</b> Faces are split in both directions. In the end, a face gets the triangles with
only the vertices on its sides, if these are flat enough by the same estimate and by the distances of the vertices
inside. Sides that are straight lose their vertices, if both faces agree. So rulings of cylinders and cones stay
undivided, and planes within curved rims have few triangles, which may be long.

<b>Creases and borders</b> are those of `subdivide()`, of any sharpness. A plane stays as
coarse as the control mesh is, apart from faces with more than four corners, which are split once.

\tparam Concurrency_tag `Sequential_tag`, `Parallel_tag` (which needs TBB) or `Parallel_if_available_tag`. The result is
  the same, bit for bit.
\tparam FaceGraph a model of `FaceListGraph`
\tparam Scheme a model of `PNSubdivisionScheme_3` that splits edges and faces as Catmull-Clark or Loop do
\tparam OutputMesh a model of `MutableFaceGraph`

\param control an oriented 2-manifold with border; vertices without edges remain as they are
\param scheme the scheme
\param chord_error the largest distance between triangles and surface, in the unit of the coordinates
\param out an empty mesh, which becomes the result; the vertices of the control mesh come first
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" of the control mesh: `vertex_point_map`,
  `vertex_normal_map` with the control normals (without it they are estimated), `control_normal_estimate`, `vertex_roundness_map` or
  `roundness`, `edge_is_constrained_map`, `vertex_is_constrained_map`, `border`, `crease_tangent_map` and
  `geom_traits`, as in `subdivide()`. Further ones are `proven_bound` and `number_of_iterations`, the most rounds that
  are done about any vertex, 12 by default. The maps are read only. `attributes` of an `Attribute_table` are replaced
  by those of the result: numbers of vertices become their limits by the linear scheme. Numbers of corners are linear
  inside the control faces, as `Corner_rule::all` has them, and no other rule is known.
  `Attribute_table::face_parents` are the control faces that the triangles lie in
\param np_out an optional sequence of \ref bgl_namedparameters "Named Parameters" of the result: `vertex_point_map`
  and `vertex_normal_map`, which gets the unit normals of the surface. A map of half-edges gets those of the corners,
  which differ along creases; a map of vertices then has their mean. If the surface has no normal, the map gets the
  limit of the control normals

\returns what was reached. With as many rounds as are allowed faces that are not flat enough stay as they are. A
  tolerance for which more than \f$ 2^{31} \f$ triangles are foreseen, or that is less than \f$ 2^{-48} \f$ of the
  box, gives about 260,000 triangles. With more of them faces are split again only once. The result is complete,
  `Tessellation_result::reached` is false, and `Tessellation_result::obstacle` tells why

\throws std::invalid_argument as `limit_points()` does, and if
  - `chord_error` is not positive and finite, the scheme does not split edges, or `out` is not empty;
  - an array of attributes does not fit, belongs to edges, or to corners by another rule;
  - a bound is not proven: the message names the first vertex for which it is not, which may have coordinates so large
    that rounding alone takes more than the tolerance
\throws std::length_error,std::overflow_error,std::domain_error as `subdivide()` and `limit_points()` do; `out` stays
  empty
*/
template <class Concurrency_tag = Sequential_tag, class FaceGraph, class Scheme, class OutputMesh,
          class NamedParameters = parameters::Default_named_parameters,
          class NamedParametersOut = parameters::Default_named_parameters>
Tessellation_result tessellate(const FaceGraph& control, const Scheme& scheme, double chord_error,
                               OutputMesh& out,
                               const NamedParameters& np = parameters::default_values(),
                               const NamedParametersOut& np_out = parameters::default_values())
{
  internal::check_are_read<NamedParameters, internal::Read_of_control_mesh, internal::attributes_t,
                           internal::proven_bound_t>();
  internal::check_are_read<NamedParametersOut>();
  if constexpr (internal::is_open_v<Scheme, NamedParameters>)
    return internal::with_scheme_of_call<Tessellation_result,
                                         internal::Surface_call<FaceGraph, NamedParameters>>(
      scheme, np, [&](const auto& s, const auto& others) {
        return tessellate<Concurrency_tag>(control, s, chord_error, out, others, np_out);
      });
  else if constexpr (!internal::halves_edges_v<Scheme>)
    throw std::invalid_argument(internal::no_halves(scheme, "by which a tessellation is refined"));
  else {
    if (!(chord_error > 0) || !std::isfinite(chord_error))
      throw std::invalid_argument("PN_subdivision_3: the chord error is " +
                                  std::to_string(chord_error) + ": it must be positive and finite");
    if constexpr (internal::check_pieces_arguments<FaceGraph, Scheme, NamedParameters>() &&
                  internal::check_build_arguments<OutputMesh, NamedParametersOut, true>()) {
      return internal::with_mesh_access(control, [&](const auto& access) {
        return internal::with_mesh_access(out, [&](auto& out_access) {
          const internal::Tessellation<Concurrency_tag, FaceGraph, NamedParameters> tessellation(
            chord_error, np, internal::attribute_table(np));
          return tessellation(control, access, scheme, out, out_access, np_out);
        });
      });
    } else
      return {};
  }
}

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_LIMIT_SURFACE_3_TESSELLATE_H

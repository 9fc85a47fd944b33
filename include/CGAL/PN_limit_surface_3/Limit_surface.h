// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_LIMIT_SURFACE_3_LIMIT_SURFACE_H
#define CGAL_PN_LIMIT_SURFACE_3_LIMIT_SURFACE_H

#include <CGAL/Bbox_3.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/PN_limit_surface_3/internal/limit/limits_at_slots.h>
#include <CGAL/PN_limit_surface_3/internal/limit_surface/Surface_evaluation.h>
#include <CGAL/PN_subdivision_3/internal/calls/concept_checks.h>
#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
#include <CGAL/PN_subdivision_3/internal/meshes/with_mesh_access.h>
#include <CGAL/PN_subdivision_3/internal/schemes/on_host.h>
#include <CGAL/PN_subdivision_3/internal/schemes/scheme_of_call.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3 {
namespace internal {

// The points or vectors of another map, rounded to double.
template <class Map, class Value>
struct Map_in_double
{
  using key_type = typename boost::property_traits<Map>::key_type;
  using value_type = Value;
  using reference = Value;
  using category = boost::readable_property_map_tag;

  Map map;

  friend Value get(const Map_in_double& m, const key_type& key)
  {
    const auto& p = get(m.map, key);
    return Value(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
  }
};

template <class Map, class Value>
inline constexpr bool is_of_estimate_v<Map_in_double<Map, Value>> = is_of_estimate_v<Map>;
template <class Map, class Value>
inline constexpr bool goes_with_roundness_v<Map_in_double<Map, Value>> = goes_with_roundness_v<Map>;
template <class Map, class Value, class Key, class = std::enable_if_t<is_of_estimate_v<Map>>>
auto get_whole(const Map_in_double<Map, Value>& m, const Key& key)
{
  return get_whole(m.map, key);
}

// the named parameters of a call that computes in double, whatever the mesh has
template <class PolygonMesh, class NamedParameters>
struct Parameters_in_double : Surface_parameters<PolygonMesh, NamedParameters>
{
  using Base = Surface_parameters<PolygonMesh, NamedParameters>;
  using Kernel = Simple_cartesian<double>;
  using FT = double;

  static auto points(const PolygonMesh& mesh, const NamedParameters& np)
  {
    const auto map = Base::const_point_map(mesh, np);
    return Map_in_double<std::decay_t<decltype(map)>, Kernel::Point_3>{map};
  }
  template <bool are_used>
  static auto normals([[maybe_unused]] const NamedParameters& np)
  {
    if constexpr (!are_used || !is_there_v<typename Base::Normal_map>)
      return Not_given();
    else
      return Map_in_double<typename Base::Normal_map, Kernel::Vector_3>{Base::normal_map(np)};
  }
};

// A scheme that is kept beyond the call. The values have the roundness of vertices; one of all goes to where it stays.
template <class Scheme, class FT>
Scheme kept_scheme(Scheme scheme, [[maybe_unused]] Given_roundness<FT>& kept)
{
  if constexpr (Is_with_roundness<Scheme>::value) {
    if (scheme.given != nullptr) kept.of_all = scheme.given->of_all;
    scheme.given = &kept;
  }
  return scheme;
}

} // namespace internal

/*!
\ingroup PkgPNSubdivision3LimitSurface

The limit surface of a control mesh as a surface with parameters: points, normals and derivatives between limit points.

<b>Parameters.</b> Corner 0 of a face is the target of `halfedge(face, mesh)`, and corners follow in the order of the face.
- A quadrilateral (of schemes that split faces as Catmull-Clark does) has those of the unit square, with the corners
  (0,0), (1,0), (1,1) and (0,1).
- A triangle (of schemes that split faces as Loop does) has \f$ u, v\ge0, u+v\le1 \f$, with the corners (0,0), (1,0)
  and (0,1).
- Any other face with \f$ n \f$ corners becomes \f$ n \f$ quadrilaterals in the first round, one at each corner. The
  quadrilateral of corner \f$ i \f$ has the parameters \f$ u-2i \f$ and \f$ v \f$, from 0 to 1. The corner is at
  \f$ u=2i, v=0 \f$, the middle of the edge to the next corner at \f$ u=2i+1, v=0 \f$, the middle of the face at
  \f$ u=2i+1, v=1 \f$.

<b>How.</b> Catmull-Clark and Loop subdivision, and their modified forms, refine regular meshes to splines. If a face
of a level and the faces around it are regular, the limit of the linear scheme is \f$ \sum a_j(u,v)\,p_j \f$, with the
bicubic B-splines or the quartic box splines \f$ a_j \f$. At borders and creases the rows beyond are extrapolated,
which gives the rule of the border. Linear schemes are so evaluated exactly, with exact derivatives of second order.
The point-normal average \f$ L_k(u,v) \f$ (`PN_average`) of these weights over the net of round \f$ k \f$ converges to
the limit of a point-normal scheme. The functions \f$ a_j \f$ have the same second moments everywhere and no third
ones, so that \f$ |L_{k+1}-L_k| \f$ decreases to 1/16 in each round. Spheres and cylinders are exact. The face is
refined, with the rings of faces around it that its rounds read and no others, until this difference, and the angle
between the normals of both, are within the tolerances. Derivatives are those of \f$ L_k \f$. The error of first
derivatives is of the third order in the size of the face, that of second derivatives of second order. On borders and
creases of point-normal schemes derivatives across have first order only, and second derivatives do not converge.

Next to extraordinary vertices the face is refined until the point lies in a regular face. The vertices themselves are evaluated as by `limit_points()`, without derivatives, which in these
parameters do not exist there. Faces that are not regular after the maximal number of rounds, and schemes that are not
splines (Butterfly, Kobbelt), are evaluated by the `Face_patch` of the limits at the corners, with first derivatives.

Cost and memory of an evaluation do not depend on the size of the mesh. `evaluate()` of many places does the rounds of each face only once.
The mesh is read by the constructor, and is not needed afterwards. Calls from several threads are safe.

Everything is computed in `double`, from rounded coordinates of any number type.

\tparam FaceGraph a model of `FaceListGraph`
\tparam GeomTraits a kernel, in which points are returned, by default that of the points of the mesh

\sa `tessellate()`
\sa `limit_points()`
*/
template <class FaceGraph, class GeomTraits = typename internal::Surface_parameters<
                             FaceGraph, parameters::Default_named_parameters>::Geom_traits>
class Limit_surface
{
public:
  /// a face of the control mesh.
  using Face = typename boost::graph_traits<FaceGraph>::face_descriptor;
  /// a point.
  using Point_3 = typename GeomTraits::Point_3;
  /// a vector.
  using Vector_3 = typename GeomTraits::Vector_3;

  /// A place on a limit surface: a face of the control mesh, and parameters in it, see above.
  struct Location
  {
    /// the face.
    Face face;
    /// the first parameter.
    double u;
    /// the second one.
    double v;
  };

  /// What `evaluate()` returns for a point of a limit surface.
  struct Surface_point
  {
    /// the point.
    Point_3 point;
    /// the unit normal of the surface; where it has none, at vertices that are cusps or on creases of point-normal schemes, the limit of the
    /// control normals, and zero with a linear scheme.
    Vector_3 normal;
    /// the derivative by the first parameter of the face, if `derivatives` is at least 1.
    Vector_3 du;
    /// the same by the second one.
    Vector_3 dv;
    /// the second derivative by the first parameter, if `derivatives` is 2.
    Vector_3 duu;
    /// by both.
    Vector_3 duv;
    /// by the second one.
    Vector_3 dvv;
    /// up to which order derivatives are given, 2, 1 or 0; the others are zero.
    unsigned derivatives = 0;
    /// the estimated distance of `point` from the limit; with a linear scheme, where it is exact, a bound of rounding.
    double error = 0;
    /// the estimated error of the normal in radians, infinite where the surface has none.
    double normal_error = 0;
    /// how many rounds were done about the point.
    unsigned rounds = 0;
  };

  /*!
  reads a control mesh.

  \tparam Scheme a model of `PNSubdivisionScheme_3` that splits edges and faces as Catmull-Clark or Loop do; an `Any_scheme` is one of `double`
  \param mesh an oriented 2-manifold with border
  \param scheme the scheme
  \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `vertex_point_map`, `vertex_normal_map` with the control normals (without it
    they are estimated), `vertex_roundness_map` or `roundness`, `control_normal_estimate`, `edge_is_constrained_map`,
    `vertex_is_constrained_map`, `border`, `crease_tangent_map` and `geom_traits`, as in `subdivide()`. Further ones
    are `parameters::tolerance()` of points (by default 10<sup>-7</sup>), `parameters::normal_tolerance()`, and
    `number_of_iterations`, the most rounds that are done about a point, 12 by default. The maps are read only

  \throws std::invalid_argument as `limit_points()` does, if the scheme does not split edges in halves, and if a tolerance is negative or not a number
  */
  template <class Scheme, class NamedParameters = parameters::Default_named_parameters>
  Limit_surface(const FaceGraph& mesh, const Scheme& scheme,
                const NamedParameters& np = parameters::default_values())
  {
    internal::check_are_read<NamedParameters, internal::Read_of_control_mesh, internal::tolerance_t,
                             internal::normal_tolerance_t>();
    internal::with_scheme_of_call<void, internal::Number_call<double>>(
      scheme, np, [&](const auto& s, const auto& others) { this->read(mesh, s, others); });
  }

  /// \name Tolerances
  /// @{

  /// the largest estimated error of a point, in the unit of the coordinates.
  double tolerance() const { return demand_.tolerance; }
  /// the largest estimated error of a normal in radians.
  double normal_tolerance() const { return demand_.normal_tolerance; }
  /// @}

  /// \name Evaluation
  /// All throw `std::invalid_argument` if a face is not one of the mesh, or if parameters are outside the face.
  /// @{

  /// the point.
  Point_3 point(Face face, double u, double v) const { return evaluate(face, u, v).point; }
  /// the unit normal.
  Vector_3 normal(Face face, double u, double v) const { return evaluate(face, u, v).normal; }
  /// all data of a point.
  Surface_point evaluate(Face face, double u, double v) const
  {
    return evaluate(std::vector<Location>(1, Location{face, u, v})).front();
  }
  /// the same of many places, in their order.
  /// \tparam Locations a range of `Location`
  template <class Locations>
  std::vector<Surface_point> evaluate(const Locations& locations) const
  {
    std::map<std::pair<Index, Index>, internal::Surface_evaluation::Queries> of_faces;
    std::size_t number = 0;
    for (const Location& l : locations) {
      internal::Surface_query q{l.u, l.v};
      q.number = number++;
      const Index f = index(l.face);
      const Index corner = put_parameters(f, q);
      of_faces[{f, corner}].push_back(q);
    }
    std::vector<Surface_point> result(number);
    for (auto& [place, queries] : of_faces)
      for (const auto& q :
           evaluation_->evaluate(place.first, place.second, std::move(queries), demand_))
        result[q.number] = surface_point(q);
    return result;
  }
  /// @}

  /*!
  \name Enclosure
  Boxes that contain the part of a face of the limit surface, or all of it. After some rounds on the face, the limit
  of the linear scheme lies in the convex hull of the control points around each of the new faces. With a point-normal
  scheme the box of these points is grown by a bound of the distance between both limits, which falls by 1/4 a round.

  `bbox()` is for all surfaces, and estimates this distance: 2/5 of the product of the longest edge and the largest
  difference of normals over an edge, 3/10 in triangles. This is 1.2 times the distance of a sphere; a lesser proven
  bound is taken instead. Schemes with negative weights are taken to be as those without. `proven_bbox()` takes the
  bound that is proved (see \ref PN_subdivision_3_limit_surface). The proof is for Catmull-Clark and Loop subdivision,
  at vertices of valences from 3 to 12, neither on borders nor on creases, for roundness from 0 to 1. Up to 6 more
  rounds are done if normals differ too much for the proof.
  @{
  */

  /// contains the limit of a face, by estimate.
  Bbox_3 bbox(Face face, unsigned rounds = 1) const
  {
    return evaluation_->enclosure(index(face), rounds, false, more_rounds).box;
  }
  /// contains the limit surface, by estimate.
  Bbox_3 bbox(unsigned rounds = 0) const { return box_of_all(rounds, false).box; }
  /*!
  contains the limit of a face.
  \throws std::invalid_argument if that is not proven: the message names the first vertex of the face for which it is not
  \throws std::domain_error if the normals differ too much, after as many rounds as are done
  */
  Bbox_3 proven_bbox(Face face, unsigned rounds = 1) const
  {
    return evaluation_->enclosure(index(face), rounds, true, more_rounds).box;
  }
  /// contains the limit surface. Throws as for a face.
  Bbox_3 proven_bbox(unsigned rounds = 1) const { return box_of_all(rounds, true).box; }
  /*!
  a proven bound of the distance of each point of the limit of a face from the one that the linear scheme makes of the control points after some rounds.
  \throws std::invalid_argument if that is not proven, as for `proven_bbox()`
  \throws std::domain_error if the normals differ too much after these rounds
  */
  double proven_distance_to_linear(Face face, unsigned rounds = 1) const
  {
    return evaluation_->enclosure(index(face), rounds, true, 0).distance;
  }
  /// @}

  /// the number of pieces of a face that have parameters of their own: 1, or the number of corners of a face that becomes several
  /// quadrilaterals.
  std::size_t number_of_pieces(Face face) const { return pieces(index(face)); }
  /// whether parameters are those of triangles.
  bool is_triangular() const { return evaluation_->splits_triangles(); }
  /// the faces of the control mesh, in their order.
  const std::vector<Face>& faces() const { return faces_; }

private:
  using Index = Level_connectivity::Index;
  static constexpr unsigned more_rounds = 6; // of enclosures, where no bound is known

  template <class Scheme, class NamedParameters>
  void read(const FaceGraph& mesh, const Scheme& scheme, const NamedParameters& np)
  {
    if constexpr (!internal::halves_edges_v<Scheme>)
      throw std::invalid_argument(
        internal::no_halves(scheme, "so that its limit surface has no parameters here"));
    else if constexpr (internal::check_pieces_arguments<FaceGraph, Scheme, NamedParameters>()) {
      using Parameters = internal::Parameters_in_double<FaceGraph, NamedParameters>;
      if constexpr (internal::is_given_v<internal_np::number_of_iterations_t, NamedParameters>)
        demand_.most_rounds = (std::max)(1u, Parameters::number_of_iterations(np));
      internal::with_mesh_access(mesh, [&](const auto& access) {
        internal::with_roundness_of_call<Parameters>(
          access, scheme, np, [&](const auto& s) { this->read<Parameters>(mesh, access, s, np); });
        for (Index f = 0; f < access.size().faces; ++f) {
          faces_.push_back(access.face_at(f));
          index_.emplace(faces_.back(), f);
        }
      });
    }
  }

  template <class Parameters, class Access, class Scheme, class NamedParameters>
  void read(const FaceGraph& mesh, const Access& access, const Scheme& scheme,
            const NamedParameters& np)
  {
    const auto points = Parameters::points(mesh, np);
    const auto normals = Parameters::template normals<internal::is_pn_v<Scheme>>(np);
    const auto take = [&](auto& level, auto& creases, const auto&) {
      demand_.tolerance =
        internal::check_tolerance(internal::parameter_or<internal::tolerance_t>(np, 1e-7)) *
        internal::box_size(level);
      demand_.normal_tolerance = internal::check_tolerance(
        internal::parameter_or<internal::normal_tolerance_t>(np, demand_.normal_tolerance));
      using Round_scheme = internal::Scheme_of_rounds<Scheme>;
      evaluation_ = internal::make_surface_evaluation(
        internal::kept_scheme<Round_scheme>(internal::scheme_of_rounds(scheme), *roundness_),
        std::move(level), std::move(creases));
    };
    internal::with_slot_level<double>(access, scheme, points, normals,
                                      Parameters::edge_constraint_map(np),
                                      Parameters::vertex_constraint_map(np), 0, take);
  }

  internal::Surface_box box_of_all(unsigned rounds, bool is_proven) const
  {
    internal::Surface_box all;
    for (Index f = 0; f < faces_.size(); ++f) {
      const auto one = evaluation_->enclosure(f, rounds, is_proven, more_rounds);
      all.box += one.box;
      all.distance = (std::max)(all.distance, one.distance);
    }
    return all;
  }

  Index index(Face face) const
  {
    const auto it = index_.find(face);
    if (it == index_.end())
      throw std::invalid_argument("PN_subdivision_3: the face is none of the mesh that the limit "
                                  "surface was made of");
    return it->second;
  }

  Index pieces(Index f) const
  {
    const Level_connectivity& level = evaluation_->level();
    if (evaluation_->splits_triangles()) return 1;
    const Index n = level.degree(level.halfedge_of_face(f));
    return n == 4 ? 1 : n;
  }

  // turns the parameters in a face into parameters in a piece of it, which is returned
  Index put_parameters(Index f, internal::Surface_query& q) const
  {
    const Index n = pieces(f);
    const bool is_triangle = evaluation_->splits_triangles();
    Index corner = 0;
    const double u = q.u;
    if (n > 1 && u >= 0 && u <= 2. * n) {
      corner = static_cast<Index>(u / 2);
      q.u -= 2. * corner;
    }
    bool is_inside = corner < n && q.u >= 0 && q.u <= 1 && q.v >= 0 && q.v <= 1;
    if (is_triangle) {
      is_inside = is_inside && q.u + q.v <= 1 + 4 * std::numeric_limits<double>::epsilon();
      q.u = (std::min)(q.u, 1 - q.v);
    }
    if (!is_inside)
      throw std::invalid_argument(
        "PN_subdivision_3: (" + std::to_string(u) + ", " + std::to_string(q.v) +
        ") are not parameters of face number " + std::to_string(f) + ": take " +
        (is_triangle ? std::string("u, v >= 0 with u + v <= 1")
         : n == 1
           ? std::string("u and v from 0 to 1")
           : "u from 2i to 2i + 1 for corner i of " + std::to_string(n) + ", v from 0 to 1"));
    return corner;
  }

  static Surface_point surface_point(const internal::Surface_query& q)
  {
    Surface_point s;
    const auto& p = q.point;
    s.point = Point_3(p[0].value, p[1].value, p[2].value);
    s.normal = Vector_3(q.normal[0], q.normal[1], q.normal[2]);
    s.derivatives = q.derivatives;
    const auto vector = [&](double internal::Jet::*part, unsigned order) {
      return order <= q.derivatives ? Vector_3(p[0].*part, p[1].*part, p[2].*part)
                                    : Vector_3(0, 0, 0);
    };
    s.du = vector(&internal::Jet::u, 1);
    s.dv = vector(&internal::Jet::v, 1);
    s.duu = vector(&internal::Jet::uu, 2);
    s.duv = vector(&internal::Jet::uv, 2);
    s.dvv = vector(&internal::Jet::vv, 2);
    s.error = q.error;
    s.normal_error = q.normal_error;
    s.rounds = q.rounds;
    return s;
  }

  std::unique_ptr<internal::Given_roundness<double>> roundness_ =
    std::make_unique<internal::Given_roundness<double>>();
  std::unique_ptr<internal::Surface_evaluation> evaluation_;
  internal::Surface_demand demand_{0, 1e-3, 12};
  std::vector<Face> faces_;
  std::unordered_map<Face, Index> index_;
};

template <class FaceGraph, class Scheme,
          class NamedParameters = parameters::Default_named_parameters>
Limit_surface(const FaceGraph&, const Scheme&,
              const NamedParameters& = parameters::default_values())
  -> Limit_surface<FaceGraph, internal::Geom_traits_of_call<FaceGraph, NamedParameters>>;

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_LIMIT_SURFACE_3_LIMIT_SURFACE_H

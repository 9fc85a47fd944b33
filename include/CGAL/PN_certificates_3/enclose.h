// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_CERTIFICATES_3_ENCLOSE_H
#define CGAL_PN_CERTIFICATES_3_ENCLOSE_H

#include <CGAL/config.h>

// as CGAL's Gmpfi, it is there with MPFI only
#if defined(CGAL_USE_MPFI) || defined(DOXYGEN_RUNNING)

#  include <CGAL/Gmpfi.h>
#  include <CGAL/Gmpfr.h>
#  include <CGAL/PN_certificates_3/internal/measure_number.h>
#  include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
#  include <CGAL/PN_subdivision_3/subdivide.h>
#  include <CGAL/Simple_cartesian.h>
#  include <CGAL/Surface_mesh.h>
#  include <CGAL/boost/graph/iterator.h>

#  include <boost/graph/graph_traits.hpp>

#  include <algorithm>
#  include <map>
#  include <sstream>
#  include <stdexcept>
#  include <string>
#  include <vector>

namespace CGAL::PN_subdivision_3 {

/// \ingroup PkgPNSubdivision3Kernels
/// What `enclose()` returns.
struct Enclosure
{
  /// the kernel of the intervals.
  using Kernel = CGAL::Simple_cartesian<CGAL::Gmpfi>;
  /// the type of the refined mesh.
  using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

  /// the refined mesh. Its property map `"v:normal"` has the refined normals, also as intervals.
  Mesh mesh;
  /// the precision that was needed.
  long bits = 0;
  /// the largest width of a coordinate of a point.
  double width = 0;
};

namespace internal {

// intervals of a precision, until the end of a scope
class Precision_of_intervals
{
public:
  explicit Precision_of_intervals(long bits)
    : old_(CGAL::Gmpfi::set_default_precision(bits))
    , old_of_ends_(CGAL::Gmpfr::set_default_precision(bits))
  {}
  ~Precision_of_intervals()
  {
    CGAL::Gmpfi::set_default_precision(old_);
    CGAL::Gmpfr::set_default_precision(old_of_ends_);
  }
  Precision_of_intervals(const Precision_of_intervals&) = delete;
  Precision_of_intervals& operator=(const Precision_of_intervals&) = delete;

private:
  CGAL::Gmpfi::Precision_type old_;
  CGAL::Gmpfr::Precision_type old_of_ends_;
};

template <class Point_or_vector, class Source>
Point_or_vector in_intervals(const Source& p)
{
  using FT = CGAL::Gmpfi;
  return Point_or_vector(measure_number<FT>(p.x()), measure_number<FT>(p.y()),
                         measure_number<FT>(p.z()));
}

// the mesh with its points, and the normals if there are any
template <class PolygonMesh, class Point_map, class Normal_map>
Enclosure::Mesh mesh_of_intervals(const PolygonMesh& mesh, Point_map points,
                                  [[maybe_unused]] Normal_map normals)
{
  using Mesh = Enclosure::Mesh;
  using Vector = Enclosure::Kernel::Vector_3;
  Mesh result;
  auto result_normals = result.add_property_map<Mesh::Vertex_index, Vector>("v:normal").first;
  std::map<typename boost::graph_traits<PolygonMesh>::vertex_descriptor, Mesh::Vertex_index> copy;
  for (auto v : vertices(mesh)) {
    copy[v] = result.add_vertex(in_intervals<Enclosure::Kernel::Point_3>(get(points, v)));
    if constexpr (is_there_v<Normal_map>)
      result_normals[copy[v]] = in_intervals<Vector>(get(normals, v));
  }
  std::vector<Mesh::Vertex_index> corners;
  for (auto f : faces(mesh)) {
    corners.clear();
    for (auto v : vertices_around_face(halfedge(f, mesh), mesh)) corners.push_back(copy[v]);
    if (result.add_face(corners) == Mesh::null_face())
      throw std::invalid_argument("PN_subdivision_3: the mesh is not a 2-manifold with border");
  }
  return result;
}

// the roundness of the vertices of the copy, which are in the same order
template <class PolygonMesh, class Roundness_map>
auto roundness_in_intervals(const PolygonMesh& mesh, Enclosure::Mesh& copy, Roundness_map roundness)
{
  using Vertex = Enclosure::Mesh::Vertex_index;
  auto result = copy.add_property_map<Vertex, CGAL::Gmpfi>("v:roundness", 1).first;
  Enclosure::Mesh::size_type i = 0;
  for (auto v : vertices(mesh))
    result[Vertex(i++)] = measure_number<CGAL::Gmpfi>(get(roundness, v));
  return result;
}

inline double greatest_width(const Enclosure::Mesh& mesh)
{
  double width = 0;
  for (const auto& p : mesh.points())
    for (int c = 0; c < 3; ++c) {
      const CGAL::Gmpfi x = p[c];
      width =
        (std::max)(width, CGAL::to_interval(CGAL::Gmpfi(x.sup()) - CGAL::Gmpfi(x.inf())).second);
    }
  return width;
}

} // namespace internal

/*!
\ingroup PkgPNSubdivision3Kernels

refines a mesh in intervals that contain what the scheme makes of the control mesh with its real weights: not with rounded ones. The
precision is raised, from 64 bits on, until the intervals of the coordinates are no wider than asked for.

Coordinates of exact and of floating point kernels are taken as they are. Control normals that are estimated are rounded to double before;
give a `vertex_normal_map` for enclosures of given normals, and a `linear()` scheme where there are none.

The header `CGAL/PN_certificates_3/enclose.h` needs MPFI: it is empty unless `CGAL_USE_MPFI` is defined. The umbrella header does not include
it.

\tparam PolygonMesh a model of `FaceListGraph`
\tparam Scheme a model of `PNSubdivisionScheme_3`, or its `linear()` twin; none that transfers curvature
\param mesh an oriented 2-manifold with border
\param scheme the scheme
\param rounds how many rounds
\param width the largest width of a coordinate of a refined point
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `vertex_point_map`, `vertex_normal_map`,
  `vertex_roundness_map`, which is only read, and `roundness`, as in `subdivide()`
\param most_bits the ceiling of the precision

\throws std::domain_error if the ceiling is reached: the message tells how wide the intervals are then, or what is not decided
\throws std::invalid_argument as `subdivide()` does, and if the width is negative or not a number
*/
template <class PolygonMesh, class Scheme,
          class NamedParameters = parameters::Default_named_parameters>
Enclosure enclose(const PolygonMesh& mesh, const Scheme& scheme, unsigned rounds, double width,
                  const NamedParameters& np = parameters::default_values(), long most_bits = 4096)
{
  internal::check_are_read<NamedParameters, internal::roundness_t,
                           internal::vertex_roundness_map_t>();
  using Parameters = internal::Surface_parameters<PolygonMesh, NamedParameters>;
  if (!(width >= 0))
    throw std::invalid_argument(
      "PN_subdivision_3: the width must be a number that is not negative");
  std::string reason;
  for (long bits = (std::min)(64L, most_bits);; bits = (std::min)(2 * bits, most_bits)) {
    const internal::Precision_of_intervals precision(bits);
    try {
      Enclosure result;
      result.mesh = internal::mesh_of_intervals(mesh, Parameters::const_point_map(mesh, np),
                                                Parameters::normal_map(np));
      auto normals =
        result.mesh
          .add_property_map<Enclosure::Mesh::Vertex_index, Enclosure::Kernel::Vector_3>("v:normal")
          .first;

      const auto refine = [&](const auto& call) {
        if constexpr (!internal::is_there_v<typename Parameters::Normal_map>)
          subdivide(result.mesh, scheme, call);
        else
          subdivide(result.mesh, scheme, call.vertex_normal_map(normals));
      };
      if constexpr (internal::is_there_v<typename Parameters::Roundness_map>)
        refine(PN_subdivision_3::parameters::vertex_roundness_map(
                 internal::roundness_in_intervals(mesh, result.mesh, Parameters::roundness_map(np)))
                 .number_of_iterations(rounds));
      else if constexpr (internal::is_there_v<typename Parameters::Roundness>)
        refine(PN_subdivision_3::parameters::roundness(
                 internal::measure_number<CGAL::Gmpfi>(Parameters::roundness(np)))
                 .number_of_iterations(rounds));
      else
        refine(parameters::number_of_iterations(rounds));
      result.bits = bits;
      result.width = internal::greatest_width(result.mesh);
      if (result.width <= width) return result;
      std::ostringstream text;
      text << "the intervals are " << result.width << " wide, not " << width;
      reason = text.str();
    } catch (const std::domain_error& e) {
      reason = e.what();
    }
    if (bits == most_bits)
      throw std::domain_error("PN_subdivision_3: with " + std::to_string(bits) + " bits " + reason +
                              ": allow more bits, or wider intervals");
  }
}

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_USE_MPFI

#endif // CGAL_PN_CERTIFICATES_3_ENCLOSE_H

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_COMPILED_CALL_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_COMPILED_CALL_H

#include <CGAL/Kernel_traits.h>
#include <CGAL/PN_subdivision_3/internal/concepts/scheme_traits.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
#include <CGAL/PN_subdivision_3/internal/meshes/with_mesh_access.h>
#include <CGAL/boost/graph/properties.h>

#include <cstddef>
#include <type_traits>

namespace CGAL {
// declared, not included: a program that uses them has them
template <typename Point>
class Surface_mesh;
template <typename FT>
struct Simple_cartesian;
class Epick;
class SM_Vertex_index;
class SM_Edge_index;
} // namespace CGAL

namespace CGAL::PN_subdivision_3 {
struct DooSabin_scheme;
struct Sqrt3_scheme;
} // namespace CGAL::PN_subdivision_3

namespace CGAL::PN_subdivision_3::internal {

// The usual calls of subdivide() are compiled once, in the library PN_subdivision_3_double
// (src/PN_subdivision_3_double). What is linked to it leaves them to it; all others are compiled where they are.
template <class Mesh>
constexpr bool is_usual_mesh_v = false;
template <class Point>
constexpr bool is_usual_mesh_v<Surface_mesh<Point>> =
  is_one_of_v<typename Kernel_traits<Point>::type, Simple_cartesian<double>, Epick>;

template <class Scheme>
constexpr bool is_usual_scheme_v =
  is_one_of_v<Scheme, CatmullClark_scheme, Loop_scheme, DooSabin_scheme, Sqrt3_scheme>;
template <class Host>
constexpr bool is_usual_scheme_v<Scheme_on_host<Host, double>> = true;

template <class Mesh>
using Usual_normal_map = typename Mesh::template Property_map<
  SM_Vertex_index, typename Kernel_traits<typename Mesh::Point>::type::Vector_3>;
template <class Mesh>
using Usual_edge_map = typename Mesh::template Property_map<SM_Edge_index, bool>;

// A scheme of CGAL's own functions or one on its host, one thread, the mesh's own points, given normals or estimated ones, edges that
// are sharp for ever or none, attributes of any kind, and nothing else.
template <class Concurrency_tag, class Mesh, class Scheme, class Parameters, class Attributes>
constexpr bool is_compiled_call()
{
  if constexpr (!is_linked_to_library || is_parallel_v<Concurrency_tag> ||
                Attributes::visited.any() || !is_usual_mesh_v<Mesh>)
    return false;
  else {
    using Edges = typename Parameters::Edge_constraint_map;
    constexpr bool has_usual_points =
      std::is_same_v<typename Parameters::FT, double> &&
      std::is_same_v<typename Parameters::Point_map,
                     typename boost::property_map<Mesh, vertex_point_t>::type>;
    constexpr bool has_usual_maps =
      is_one_of_v<Edges, Not_given, Usual_edge_map<Mesh>> &&
      is_one_of_v<typename Parameters::Normal_map, Not_given, Usual_normal_map<Mesh>> &&
      !is_there_v<typename Parameters::Vertex_constraint_map>;
    return is_usual_scheme_v<Scheme> && has_usual_points && has_usual_maps &&
           !is_there_v<typename Parameters::Roundness> &&
           !is_there_v<typename Parameters::Roundness_map>;
  }
}

template <class Access>
class Any_attributes;

template <class Mesh, class Scheme, class Point_map, class Normal_map, class Edge_map>
void compiled_call(Mesh& mesh, const Scheme& scheme, unsigned rounds,
                   Function_ref<void(unsigned, std::size_t)> round_done, Point_map points,
                   Normal_map normals, Edge_map edges,
                   const Any_attributes<Surface_mesh_access<Mesh>>& attributes);

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_COMPILED_CALL_H

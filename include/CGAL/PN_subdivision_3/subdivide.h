// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_SUBDIVIDE_H
#define CGAL_PN_SUBDIVISION_3_SUBDIVIDE_H

#include <CGAL/PN_subdivision_3/internal/meshes/Bgl_mesh_access.h>
#include <CGAL/PN_subdivision_3/internal/meshes/Mesh_subdivision.h>
#include <CGAL/PN_subdivision_3/internal/meshes/concept_checks.h>
#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

template <class Mesh>
constexpr bool is_surface_mesh_v = false;
template <class Point>
constexpr bool is_surface_mesh_v<Surface_mesh<Point>> = true;

// calls f(access) with the access that fits the mesh
template <class Mesh, class Function>
void with_mesh_access(Mesh& mesh, const Function& f)
{
  if constexpr (is_surface_mesh_v<std::remove_const_t<Mesh>>)
    if (!mesh.has_garbage()) {
      Surface_mesh_access<Mesh> access(mesh);
      return f(access);
    }
  Bgl_mesh_access<Mesh> access(mesh);
  f(access);
}

} // namespace internal

/*!
\ingroup PkgPNSubdivision3Functions

applies point-normal subdivision by any scheme to a polygon mesh.

Points and unit control normals are refined together by the rule that `PN_average` documents. Points
and normals sampled from a sphere, a circular cylinder or a circle stay on it up to rounding; where
all control normals are equal or zero, the result is that of the linear scheme.

The vertex normal map holds the control normals. A zero vector means "no control normal here";
vectors of other lengths are normalized once. After the call it holds the refined normals. Without a
vertex normal map, control normals are estimated as by `estimate_control_normals()` and dropped
afterwards.

<b>Order.</b> The new mesh has the old vertices first, then the new ones in the order documented
with the host of the scheme. An old face's descriptor stays on one of its children and an old edge's
on one of its halves (Doo-Sabin keeps no vertices and edges, \f$ \sqrt{3} \f$ flips the edges: see
their hosts); all property maps remain valid, and all other new elements have default values. A `Surface_mesh` that holds removed elements keeps all its indices; the removed elements
stay removed, and new ones follow behind them. For a `Polyhedron_3` call `normalize_border()`
afterwards if you need it.

<b>New vertices.</b> Maps of the user's have to take vertices that the mesh gets while it grows: an
array of fixed size does not. New elements of a `Polyhedron_3` with `Polyhedron_items_with_id_3` have
no ids yet, so that a map which goes through `vertex->id()` would be written out of its bounds: use
dynamic property maps, and call `CGAL::set_halfedgeds_items_id()` afterwards. A mask of your own must
not read properties of the mesh, which grows at the same time: let the scheme hold a copy of them.

<b>Floating point.</b> Results in `float` and `double` are the same, bit for bit, on all processors
and for all compilers that round as IEEE 754 says. Where the compiler may fuse products and sums (all
processors with FMA that it generates code for, hence aarch64 by default), pass
`-ffp-contract=off`; results differ in their last bits otherwise. With `-ffast-math` the checks of the
input remain, but bits are not promised. If `CGAL_PN_SUBDIVISION_3_NO_AVX2` is defined, the form of the
average for processors with AVX2, which gives the same bits, is left out.

<b>Strong guarantee.</b> If an exception leaves the function, the mesh and its maps are as they
were. Beyond it is a property map of the user's whose `put()` throws also while old values are put
back, and what such a map stores for vertices that exist no longer.

\tparam Concurrency_tag `Sequential_tag`, `Parallel_tag` (which needs TBB) or
  `Parallel_if_available_tag`. The result is the same, bit for bit, for any number of threads. The
  maps of `Surface_mesh` are then written by several threads, other maps by one; other meshes by one
  thread, too, unless `Refinable_mesh_traits` says more.
\tparam PolygonMesh a model of `MutableFaceGraph` with hashable descriptors; a `Polyhedron_3` needs its
  default `HalfedgeDS_list`, since elements of a `HalfedgeDS_vector` cannot be removed
\tparam Scheme a model of `PNSubdivisionScheme_3`, or its `linear()` twin
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param mesh an oriented 2-manifold with border; it may be empty, have several components and have
  vertices without edges, which remain where they are
\param scheme the scheme
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
  below

\cgalNamedParamsBegin
  \cgalParamNBegin{number_of_iterations}
    \cgalParamDescription{the number of rounds; 0 leaves the mesh untouched}
    \cgalParamType{unsigned int}
    \cgalParamDefault{`1`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `mesh`}
    \cgalParamType{a class model of `ReadWritePropertyMap` with
                          `boost::graph_traits<PolygonMesh>::%vertex_descriptor` as key type and
                          `geom_traits::Point_3` as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_normal_map}
    \cgalParamDescription{a property map with the control normals, which become the refined normals}
    \cgalParamType{a class model of `ReadWritePropertyMap` with
                          `boost::graph_traits<PolygonMesh>::%vertex_descriptor` as key type and
                          `geom_traits::Vector_3` as value type}
    \cgalParamDefault{estimated normals, which are dropped afterwards}
    \cgalParamExtra{A linear scheme ignores it.}
  \cgalParamNEnd
  \cgalParamNBegin{geom_traits}
    \cgalParamDescription{an instance of a geometric traits class; its `FT` is the number type of
                          all computations}
    \cgalParamType{a class model of `Kernel`}
    \cgalParamDefault{a \cgal Kernel deduced from the point type, using `CGAL::Kernel_traits`}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{an object whose `round_done(unsigned k, std::size_t number_of_faces)` is
                          called after the k-th round is computed, also of a mesh without faces; an exception of it cancels the
                          subdivision. It must not look at the mesh, which is being written, and with
                          `Parallel_tag` it may be called from another thread.}
    \cgalParamType{a copyable class, or a `std::reference_wrapper` to one}
    \cgalParamDefault{no visitor}
  \cgalParamNEnd
\cgalNamedParamsEnd

\throws std::invalid_argument if the mesh is not an oriented 2-manifold with border (a vertex that
  joins several fans of faces, an edge without a face, broken connectivity), if the scheme cannot
  refine one of the faces, or if a point or normal is not finite. The message names the element. These
  checks do not depend on `NDEBUG`.
\throws std::length_error if a round needs more elements than the index type of the mesh can number
\throws std::overflow_error if a new point is out of the range of a floating point type
\throws std::domain_error if an interval number type leaves a comparison undecided

\cost linear in the size of the output, in time and memory, while the degrees of the faces and the
valences are bounded. Loop, Catmull-Clark and \f$ \sqrt{3} \f$ subdivision are linear whatever the
valences. A vertex of valence m takes time m<sup>2</sup> with the other schemes, and a face of degree m
with all that take polygons; `estimated_row_entries()` tells beforehand.
*/
template <class Concurrency_tag = Sequential_tag, class PolygonMesh, class Scheme,
          class NamedParameters = parameters::Default_named_parameters>
void subdivide(PolygonMesh& mesh, const Scheme& scheme,
               const NamedParameters& np = parameters::default_values())
{
  if constexpr (internal::check_subdivision_arguments<PolygonMesh, Scheme, NamedParameters>()) {
    using Parameters = internal::Surface_parameters<PolygonMesh, NamedParameters>;
    const unsigned iterations = Parameters::number_of_iterations(np);
    if (iterations == 0) return;
    auto visitor = Parameters::visitor(np);
    const auto round_done = [&](unsigned k, std::size_t number_of_faces) {
      internal::unwrapped(visitor).round_done(k, number_of_faces);
    };
    const internal::Mesh_subdivision<Concurrency_tag, Scheme, typename Parameters::FT> subdivision(
      scheme, iterations, round_done);
    internal::with_mesh_access(mesh, [&](auto& access) {
      subdivision(access, Parameters::point_map(mesh, np), Parameters::normal_map(np));
    });
  }
}

} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_SUBDIVIDE_H

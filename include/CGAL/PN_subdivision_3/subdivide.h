// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_SUBDIVIDE_H
#define CGAL_PN_SUBDIVISION_3_SUBDIVIDE_H

#include <CGAL/PN_subdivision_3/attributes.h>
#include <CGAL/PN_subdivision_3/internal/attributes/Call_attributes.h>
#include <CGAL/PN_subdivision_3/internal/calls/Mesh_subdivision.h>
#include <CGAL/PN_subdivision_3/internal/calls/concept_checks.h>
#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
#include <CGAL/PN_subdivision_3/internal/meshes/with_mesh_access.h>
#include <CGAL/PN_subdivision_3/internal/schemes/on_host.h>
#include <CGAL/tags.h>

#include <type_traits>

namespace CGAL::PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Functions

applies point-normal subdivision by any scheme to a polygon mesh.

Points and unit control normals are refined together by the rule that `PN_average` documents. Points and normals
sampled from a sphere, a circular cylinder or a circle stay on it up to rounding. If all control normals are equal or
zero, the result is that of the linear scheme (not if they are equal and the scheme transfers curvature).

The vertex normal map holds the control normals. A zero vector means "no control normal here"; vectors of other
lengths are normalized once. After the call it holds the refined normals. Without a vertex normal map, control normals
are estimated as by `estimate_control_normals()` and dropped afterwards.

<b>Creases.</b> Sharp edges and vertices are given by `edge_is_constrained_map` and `vertex_is_constrained_map`. Runs
of faces around a vertex between sharp edges are its wedges; points are shared by all wedges, normals belong to them.
A vertex with two sharp edges is on a crease. A vertex that is sharp itself or has more sharp edges is a corner and
stays where it is. At a vertex with a single sharp edge the crease fades out. Along creases `Crease_average` holds:
rims of spheres, cylinders and all surfaces of revolution stay exact circles, straight edges straight, and each
surface beside them stays what it is up to the crease. Normals per wedge come with a normal map whose keys are
half-edges. A half-edge that has a face has the normal of that face's surface at the target of the half-edge. If
normals differ within a wedge their sum counts. With a map of vertices, or none, the normals of vertices with several
wedges are estimated wedge by wedge. Afterwards a map of vertices holds the mean normal of the wedges. All boundaries
between different surfaces should be creases, also where the surfaces are tangent. A sharpness s that is finite holds
for s rounds: edges lose 1 in each round, and where less than 1 is left the sharp and the smooth rule are mixed. The
border is a crease by `border`, and the tangents of creases are given and got by `crease_tangent_map`.

<b>Order.</b> The new mesh has the old vertices first, then the new ones in the order documented
with the host of the scheme. An old face's descriptor stays on one of its children and an old edge's on one of its
halves (Doo-Sabin keeps no vertices and edges, \f$ \sqrt{3} \f$ flips the edges: see their hosts). All property maps
remain valid, and all other new elements have default values. A `Surface_mesh` that holds removed elements keeps all
its indices; the removed elements stay removed, and new ones follow behind them. For a `Polyhedron_3` call
`normalize_border()` afterwards if you need it.

<b>Attributes.</b> Other data of the mesh are named in `attributes`: values of vertices and corners are averaged
by the scheme's linear rows, in the same pass as the points; edges and faces pass theirs on. Parents of elements are
passed to the visitor or written into maps. Attributes change no bit of points and normals.

<b>New vertices.</b> Your maps must accept the new vertices of the mesh: an array
of fixed size does not. New elements of a `Polyhedron_3` with `Polyhedron_items_with_id_3` have
no ids yet, so that a map which goes through `vertex->id()` would be written out of its bounds: use
dynamic property maps, and call `CGAL::set_halfedgeds_items_id()` afterwards. A mask of your own must
not read properties of the mesh, which grows at the same time: let the scheme hold a copy of them.

<b>Floating point.</b> Results in `float` and `double` are the same, bit for bit, on all processors and for all
compilers that round as IEEE 754 says. If the compiler may fuse products and sums (on all processors with FMA that it
generates code for, hence aarch64 by default), pass `-ffp-contract=off`; results differ in their last bits otherwise.
With `-ffast-math` the checks of the input remain, but bits are not promised. If `CGAL_PN_SUBDIVISION_3_NO_AVX2` is
defined, the form of the average for processors with AVX2, which gives the same bits, is left out.

<b>Strong guarantee.</b> If an exception leaves the function, the mesh and its maps are as they
were. Beyond it is a property map of the user's whose `put()` throws also while old values are put
back, and what such a map stores for vertices that exist no longer. An exception of a visitor's `vertex_created()`,
`edge_created()` or `face_created()` leaves the refined mesh.

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
    \cgalParamExtra{For schemes with rules for creases the keys may be
                    `boost::graph_traits<PolygonMesh>::%halfedge_descriptor`s: a normal per corner.}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_roundness_map}
    \cgalParamDescription{the roundness of the vertices, see `PN_average`. If the map can be written it gets that of the
                          refined vertices.}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<PolygonMesh>::%vertex_descriptor` as key type and a number type as value type;
                   `parameters::vertex_roundness_map()` makes the parameter}
    \cgalParamDefault{1 where normals are given; where they are estimated that of the estimate, see
                      `estimate_control_normals()`}
    \cgalParamExtra{A linear scheme ignores it.}
  \cgalParamNEnd
  \cgalParamNBegin{roundness}
    \cgalParamDescription{the roundness of all vertices, in place of the map}
    \cgalParamType{a number from 0 to 1; `parameters::roundness()` makes the parameter}
    \cgalParamDefault{as that of `vertex_roundness_map`}
  \cgalParamNEnd
  \cgalParamNBegin{control_normal_estimate}
    \cgalParamDescription{how normals are estimated where none are given}
    \cgalParamType{`Control_normal_estimate`; `parameters::control_normal_estimate()` makes the parameter}
    \cgalParamDefault{`Control_normal_estimate::coherent`}
  \cgalParamNEnd
  \cgalParamNBegin{border}
    \cgalParamDescription{how the border is treated}
    \cgalParamType{`Border`; `parameters::border()` makes the parameter}
    \cgalParamDefault{`Border::surface`}
  \cgalParamNEnd
  \cgalParamNBegin{crease_tangent_map}
    \cgalParamDescription{the tangents of creases, which become those of the refined creases}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<PolygonMesh>::%halfedge_descriptor` as key type and
                   `geom_traits::Vector_3` as value type; `parameters::crease_tangent_map()` makes the parameter}
    \cgalParamDefault{they are made from the points and the normals}
  \cgalParamNEnd
  \cgalParamNBegin{attributes}
    \cgalParamDescription{the attributes to be refined}
    \cgalParamType{what `parameters::attributes()` is given: maps, or an `Attribute_table`, which is read and changed}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{the sharp edges of `mesh`. If the map can be written, the parts of a sharp
                          edge get its value, less the number of rounds if it is a finite number,
                          and all other edges 0 or `false`.}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<PolygonMesh>::%edge_descriptor` as key type and as value type `bool` or a
                   number type. A sharpness is not negative; `true` and the largest value of a built-in integer type
                   are infinitely sharp}
    \cgalParamDefault{no edge is sharp}
    \cgalParamExtra{A sharp border edge is infinitely sharp, and a border vertex with a sharp edge that
                    is not on the border is a corner. Schemes without rules for creases, all but
                    Catmull-Clark, Loop and their variants `Tuned` and `Transfer`, refuse sharp edges.}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_is_constrained_map}
    \cgalParamDescription{the corners of `mesh`, as with edges}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<PolygonMesh>::%vertex_descriptor` as key type and `bool` or a
                   number type as value type}
    \cgalParamDefault{no vertex is a corner by itself}
  \cgalParamNEnd
  \cgalParamNBegin{geom_traits}
    \cgalParamDescription{an instance of a geometric traits class; its `FT` is the number type of
                          all computations}
    \cgalParamType{a class model of `Kernel`}
    \cgalParamDefault{a \cgal Kernel deduced from the point type, using `CGAL::Kernel_traits`}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{an object whose members are called for rounds and for the elements of the refined mesh, with their
                          parents. A member that cannot be called with what it is to be given is refused when the
                          call is compiled. With `Parallel_tag` it may be called from another thread.}
    \cgalParamType{a copyable model of `PNSubdivisionVisitor_3`, or a `std::reference_wrapper` to one}
    \cgalParamDefault{no visitor}
  \cgalParamNEnd
\cgalNamedParamsEnd

\throws std::invalid_argument if one of these is found; the message names the element, and the checks do not depend on
  `NDEBUG`:
  - the mesh is not an oriented 2-manifold with border: a vertex joins several fans of faces, an edge has no face, or
    the connectivity is broken;
  - the scheme cannot refine one of the faces;
  - a point or normal is not finite, a roundness is not from 0 to 1, or a sharpness is negative or not a number;
  - an edge or vertex is sharp and the scheme has no rules for creases;
  - an array of `attributes` does not fit the mesh, or attributes need a scheme that splits edges and this one does not
    (`splits_edges_v`)
\throws std::length_error if a round needs more elements than the index type of the mesh can number
\throws std::overflow_error if a new point is out of the range of a floating point type
\throws std::domain_error if an interval number type leaves a comparison undecided

<br><b>Cost:</b> linear in the size of the output, in time and memory, while the degrees of the faces and the
valences are bounded. Loop, Catmull-Clark and \f$ \sqrt{3} \f$ subdivision are linear whatever the
valences. A vertex of valence m takes time m<sup>2</sup> with the other schemes, and a face of degree m
with all that take polygons; `estimated_row_entries()` estimates it.
*/
template <class Concurrency_tag = Sequential_tag, class PolygonMesh, class Scheme,
          class NamedParameters = parameters::Default_named_parameters>
void subdivide(PolygonMesh& mesh, const Scheme& scheme,
               const NamedParameters& np = parameters::default_values())
{
  internal::check_are_read<NamedParameters, internal::Read_of_control_mesh,
                           internal::attributes_t>();
  if constexpr (internal::is_open_v<Scheme, NamedParameters>)
    internal::with_scheme_of_call<void, internal::Surface_call<PolygonMesh, NamedParameters>>(
      scheme, np,
      [&](const auto& s, const auto& others) { subdivide<Concurrency_tag>(mesh, s, others); });
  else if constexpr (internal::check_subdivision_arguments<PolygonMesh, Scheme,
                                                           NamedParameters>() &&
                     internal::check_attributes<PolygonMesh, NamedParameters>()) {
    using Parameters = internal::Surface_parameters<PolygonMesh, NamedParameters>;
    const unsigned iterations = Parameters::number_of_iterations(np);
    if (iterations == 0) return;
    auto visitor = Parameters::visitor(np);
    auto& unwrapped = internal::unwrapped(visitor);
    using Visitor = std::remove_reference_t<decltype(unwrapped)>;
    const internal::Call_round_done<Visitor> round_done{unwrapped};
    if constexpr (!internal::check_visitor<Visitor, PolygonMesh>()) return;
    auto attributes = Parameters::attributes(np);
    auto& carried = internal::unwrapped(attributes);
    using Attributes_of_call =
      internal::Call_attributes<PolygonMesh, Visitor, std::remove_reference_t<decltype(carried)>>;
    const Attributes_of_call attributes_of_call{unwrapped, carried};
    if constexpr (internal::is_compiled_call<Concurrency_tag, PolygonMesh, Scheme, Parameters,
                                             Attributes_of_call>())
      internal::compiled_call(
        mesh, scheme, iterations, round_done, Parameters::point_map(mesh, np),
        Parameters::normal_map(np), Parameters::edge_constraint_map(np),
        internal::Any_attributes<internal::Surface_mesh_access<PolygonMesh>>(attributes_of_call));
    else
      internal::with_mesh_access(mesh, [&](auto& access) {
        internal::with_roundness_of_call<Parameters>(access, scheme, np, [&](const auto& s) {
          using Scheme_of_call = std::decay_t<decltype(s)>;
          const internal::Mesh_subdivision<Concurrency_tag, Scheme_of_call, typename Parameters::FT>
            subdivision(s, iterations, round_done);
          subdivision(access, Parameters::point_map(mesh, np), Parameters::normal_map(np),
                      Parameters::roundness_map(np), Parameters::edge_constraint_map(np),
                      Parameters::vertex_constraint_map(np), attributes_of_call);
        });
      });
  }
}

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_SUBDIVISION_3_SUBDIVIDE_H

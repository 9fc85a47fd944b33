// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Calls that must not compile, each with the line that the compiler is to say. The test
// rejected_arguments compiles this file and looks for the lines; nothing else may be an error.

#include <CGAL/PN_certificates_3/compare_with_linear.h>
#include <CGAL/PN_limit_surface_3/Limit_surface.h>
#include <CGAL/PN_limit_surface_3/limit_points.h>
#include <CGAL/PN_limit_surface_3/refine_in_pieces.h>
#include <CGAL/PN_limit_surface_3/subdivide_to_limit.h>
#include <CGAL/PN_subdivision_3.h>
#include <CGAL/PN_subdivision_3/Surface_refiner.h>
#include <CGAL/PN_subdivision_3/schemes/Any_scheme.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Dual.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>

#include <cstddef>
#include <string>
#include <vector>

namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;

using Kernel = CGAL::Simple_cartesian<double>;
using Float_kernel = CGAL::Simple_cartesian<float>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Edge = Mesh::Edge_index;

void reject(Mesh& mesh)
{
  const Mesh& constant = mesh;
  PN::CatmullClark_subdivision(constant);
  // expected: the mesh is const

  PN::CatmullClark_subdivision(mesh, 3);
  // expected: the last argument is not a named parameter: for a number of rounds write

  // said once for each type of number
  PN::Surface_refiner(mesh, PN::Loop_scheme(), 3u);
  // expected: the last argument is not a named parameter: for a number of rounds write

  PN::Surface_pieces(mesh, PN::Loop_scheme(), 3l);
  // expected: the last argument is not a named parameter: for a number of rounds write

  PN::Surface_pieces<PN::Loop_scheme, Kernel>(mesh, PN::Loop_scheme(), 3.);
  // expected: the last argument is not a named parameter: for a number of rounds write

  PN::Limit_surface(mesh, PN::Loop_scheme(), 3ul);
  // expected: the last argument is not a named parameter: for a number of rounds write

  PN::compare_with_linear(mesh, PN::Loop_scheme(), 3.f);
  // expected: the last argument is not a named parameter: for a number of rounds write

  std::vector<Kernel::Point_3> points_of_soup;
  std::vector<std::vector<std::size_t>> polygons;
  PN::CatmullClark_subdivision(points_of_soup, polygons);
  // expected: a soup becomes a mesh by CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh()

  PN::subdivide<CGAL::Parallel_tag>(mesh, PN::Loop_scheme()); // TBB is not linked
  // expected: Parallel_tag needs TBB: link CGAL::PN_subdivision_3_TBB

  PN::limit_points(mesh, PN::Loop_scheme(), mesh.points());
  // expected: the values of the map of limit points are not Limit_point

  PN::limit_points(mesh, PN::Loop_scheme(),
                   mesh.add_property_map<Edge, PN::Limit_point<Kernel>>("of edges").first);
  // expected: the map of limit points is not a property map of the mesh's vertices

  PN::limit_points(mesh, PN::Loop_scheme(), params::geom_traits(Kernel()));
  // expected: limit_points() has nothing to write

  PN::limit_points(mesh, PN::Loop_scheme(),
                   mesh.add_property_map<Vertex, PN::Limit_point<Kernel>>("limits").first,
                   PN::parameters::limit_point_map(mesh.points()));
  // expected: limit_points() writes a map of Limit_point, or limit_point_map, limit_normal_map and limit_error_map, not both

  PN::limit_points(mesh, PN::DooSabin_scheme(),
                   mesh.add_property_map<Mesh::Face_index, Kernel::Point_3>("of faces").first);
  // expected: the values of the map of limit points are not Limit_point

  CGAL::Face_filtered_graph<Mesh> part(mesh);
  PN::CatmullClark_subdivision(part);
  // expected: the mesh is not a model of MutableFaceGraph

  CGAL::Dual<Mesh> dual(mesh);
  PN::Loop_subdivision(dual);
  // expected: the mesh is not a model of MutableFaceGraph

  auto creases = mesh.add_property_map<Edge, bool>("creases").first;

  PN::CatmullClark_subdivision(mesh, params::edge_is_constrained_map(mesh.points()));
  // expected: edge_is_constrained_map is not a property map of the mesh's edges

  PN::estimate_control_normals(mesh, params::vertex_is_constrained_map(creases));
  // expected: vertex_is_constrained_map is not a property map of the mesh's vertices

  PN::subdivide(mesh, PN::Loop_scheme(), PN::parameters::crease_tangent_map(creases));
  // expected: crease_tangent_map is not a property map of the mesh's half-edges

  auto tangents = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_3>("tangents").first;
  PN::subdivide(mesh, PN::Loop_scheme(), PN::parameters::crease_tangent_map(tangents));
  // expected: the values of crease_tangent_map are not Vector_3

  PN::subdivide(mesh, PN::Sqrt3_scheme(), PN::parameters::crease_tangent_map(tangents));
  // expected: crease_tangent_map is given for a scheme without rules for creases

  PN::subdivide(mesh, PN::Any_scheme<float>(PN::Loop_scheme()));
  // expected: the points have another number type than the Any_scheme

  static_cast<void>(PN::Any_scheme<>(PN::linear(PN::Loop_scheme())));
  // expected: make an Any_scheme of the scheme that is adapted, and adapt it

  PN::limit_points(mesh, PN::CatmullClark_scheme::Grid(),
                   mesh.add_property_map<Vertex, PN::Limit_point<Kernel>>("of grids").first);
  // expected: CatmullClark_scheme::Grid is a scheme of subdivide() only

  PN::detect_creases(mesh, 60, mesh.add_property_map<Vertex, bool>("no edges").first);
  // expected: the map of creases is not a property map of the mesh's edges

  PN::CatmullClark_subdivision(mesh, params::number_of_iterations(2.5));
  // expected: number_of_iterations is not an integer

  PN::subdivide(mesh, 3);
  // expected: the scheme is no model of PNSubdivisionScheme_3

  PN::CatmullClark_subdivision(mesh, params::vertex_normal_map(mesh.points()));
  // expected: the values of the normal map are not Vector_3

  auto others = mesh.add_property_map<Vertex, Float_kernel::Vector_3>("others").first;
  PN::CatmullClark_subdivision(mesh, params::vertex_normal_map(others));
  // expected: the values of the normal map are not Vector_3

  const auto function = [](Vertex) { return Kernel::Vector_3(0, 0, 1); };
  PN::CatmullClark_subdivision(mesh, params::vertex_normal_map(function));
  // expected: the normal map is not a property map of the mesh's vertices

  auto normals = mesh.add_property_map<Vertex, Kernel::Vector_3>("normals").first;
  PN::CatmullClark_subdivision(mesh, params::vertex_point_map(normals));
  // expected: the values of vertex_point_map are not Point_3

  PN::CatmullClark_subdivision(mesh, params::vertex_point_map(function));
  // expected: vertex_point_map is not a property map of the mesh's vertices

  auto points = mesh.add_property_map<Vertex, Float_kernel::Point_3>("points").first;
  PN::estimate_control_normals(mesh, points);
  // expected: the values of the normal map are not Vector_3

  PN::subdivide(mesh, PN::with_normal_scheme(PN::Loop_scheme::Transfer(), PN::Loop_scheme()));
  // expected: a scheme that transfers curvature refines points and normals together

  PN::subdivide(mesh, PN::with_normal_scheme(
                        PN::CatmullClark_scheme(),
                        PN::internal::with_border(PN::CatmullClark_scheme(), PN::Border::curve)));
  // expected: the border is that of the scheme of the points

  struct Visitor
  {
    void face_made(Mesh::Face_index) {}
  };
  PN::CatmullClark_subdivision(mesh, params::visitor(Visitor()));
  // expected: the visitor has none of the members

  struct Wrong_face
  {
    void face_created(Mesh::Face_index, Mesh::Face_index) {}
    void round_done(unsigned, std::size_t) {}
  };
  PN::CatmullClark_subdivision(mesh, params::visitor(Wrong_face()));
  // expected: void face_created(face_descriptor, const Control_element& parent)

  struct Wrong_edge : PN::Default_visitor
  {
    void edge_created(Edge, PN::Control_element&) {}
  };
  PN::CatmullClark_subdivision(mesh, params::visitor(Wrong_edge()));
  // expected: void edge_created(edge_descriptor, const Control_element& origin)

  class Private_vertex
  {
    void vertex_created(Vertex, const PN::Control_element&) {}
  };
  PN::CatmullClark_subdivision(mesh, params::visitor(Private_vertex()));
  // expected: void vertex_created(vertex_descriptor, const Control_element& origin)

  struct Wrong_round
  {
    void round_done(unsigned) {}
    void round_done(const char*) {}
  };
  PN::CatmullClark_subdivision(mesh, params::visitor(Wrong_round()));
  // expected: void round_done(unsigned round, std::size_t number_of_faces)

  PN::subdivide(mesh, PN::Loop_scheme(),
                PN::parameters::attributes(PN::parameters::face_attribute(creases)));
  // expected: the map of an attribute is not a property map of the

  const PN::Attribute_table table;
  PN::subdivide(mesh, PN::Loop_scheme(), PN::parameters::attributes(table));
  // expected: the table of attributes is const

  PN::subdivide(mesh, PN::Loop_scheme(), PN::parameters::attributes(creases));
  // expected: the map of an attribute is not a property map of the

  auto names = mesh.add_property_map<Vertex, std::string>("names").first;
  PN::subdivide(mesh, PN::Loop_scheme(),
                PN::parameters::attributes(PN::parameters::vertex_attribute(names)));
  // expected: have no sum a + b, no product a * 0.5 or no default constructor

  struct Only_sums
  {
    Only_sums operator+(const Only_sums&) const { return *this; }
  };
  auto sums = mesh.add_property_map<Mesh::Halfedge_index, Only_sums>("sums").first;
  PN::Surface_refiner(mesh, PN::Loop_scheme(),
                      PN::parameters::attributes(PN::parameters::corner_attribute(sums)));
  // expected: see PNSubdivisionAttribute, or specialize Attribute_traits

  struct Not_compared
  {
    Not_compared operator+(const Not_compared&) const { return *this; }
    Not_compared operator*(double) const { return *this; }
  };
  auto not_compared = mesh.add_property_map<Mesh::Halfedge_index, Not_compared>("compared").first;
  PN::subdivide_to_limit(
    mesh, PN::Loop_scheme(),
    PN::parameters::attributes(PN::parameters::corner_attribute(not_compared)));
  // expected: the values of an attribute of corners cannot be compared by ==

  PN::subdivide_to_limit(mesh, PN::Loop_scheme(),
                         params::vertex_is_constrained_map(creases).number_of_iterations(0));
  // expected: vertex_is_constrained_map is not a property map of the mesh's vertices

  PN::Surface_refiner(mesh, PN::Loop_scheme(), PN::parameters::attributes(3));
  // expected: the map of an attribute is not a property map of the

  PN::subdivide_to_limit(mesh, PN::Loop_scheme(),
                         PN::parameters::attributes(PN::parameters::face_attribute(creases),
                                                    PN::parameters::face_attribute(creases)));
  // expected: the map of an attribute is not a property map of the

  PN::Surface_refiner(mesh, PN::CatmullClark_scheme(),
                      PN::parameters::crease_tangent_map(tangents));
  // expected: Surface_refiner makes the tangents of creases

  PN::subdivide(mesh, PN::Loop_scheme(), PN::parameters::limit_normal_map(normals));
  // expected: this function does not read limit_normal_map

  PN::CatmullClark_subdivision(mesh, PN::parameters::roundness(.5).max_depth(3));
  // expected: this function does not read max_depth

  PN::subdivide_to_limit(
    mesh, PN::Loop_scheme(),
    PN::parameters::join(params::number_of_iterations(1), PN::parameters::rings(2)));
  // expected: this function does not read rings

  PN::limit_points(mesh, PN::Loop_scheme(), PN::parameters::limit_normal_map(normals).tuned(true));
  // expected: this function does not read tuned

  PN::Surface_refiner(mesh, PN::Loop_scheme(), PN::parameters::number_of_pieces(3));
  // expected: this function does not read number_of_pieces

  PN::estimate_control_normals(mesh, PN::parameters::vertex_roundness_map(creases));
  // expected: this function does not read vertex_roundness_map

  PN::estimate_control_normals(mesh, normals, PN::parameters::roundness(1));
  // expected: this function does not read roundness

  PN::detect_creases(mesh, 60, creases, PN::parameters::sharp_angle(60));
  // expected: this function does not read sharp_angle

  PN::subdivide_to_limit(
    mesh, PN::Loop_scheme(),
    PN::parameters::limit_error_map(mesh.add_property_map<Mesh::Face_index, double>("e").first));
  // expected: limit_error_map is not a property map of the mesh's vertices

  PN::estimate_control_normals(mesh, params::vertex_point_map(function));
  // expected: vertex_point_map is not a property map of the mesh's vertices
}

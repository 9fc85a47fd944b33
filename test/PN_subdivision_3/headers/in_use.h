// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// How public headers are used, each alone: cmake/PN_headers_alone.cmake includes a header, defines its name and includes this.

namespace CGAL::PN_subdivision_3 {}
using namespace CGAL::PN_subdivision_3;

#if defined(IN_USE_CGAL_PN_certificates_3_compare_with_linear_h)
#  include "headers/mesh.h"
#  include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
bool use_comparison(const Mesh& mesh)
{
  return compare_with_linear(mesh, Loop_scheme()).is_swollen() ||
         compare_with_linear(mesh, mesh, mesh).is_folded();
}
#elif defined(IN_USE_CGAL_PN_cgal_masks_3_Subdivision_method_3_h)
#  include "headers/mesh.h"
void use_methods_of_cgal(Mesh& mesh)
{
  Subdivision_method_3::Sqrt3_subdivision(mesh);
}
#elif defined(IN_USE_CGAL_PN_curves_curve_limit_points_h)
#  include "headers/polygon.h"
#  include <CGAL/PN_curves/masks/curve_masks.h>
void use_limit_points(const Polygon& polygon)
{
  (void)curve_limit_points(polygon, B_spline_mask(3), Curve_end::closed);
}
#elif defined(IN_USE_CGAL_PN_curves_masks_curve_masks_h)
void use_masks()
{
  (void)B_spline_mask(3).coefficients<double>();
  (void)Dubuc_Deslauriers_mask(4).coefficients<double>();
}
#elif defined(IN_USE_CGAL_PN_curves_subdivide_curve_h)
#  include "headers/polygon.h"
#  include <CGAL/PN_curves/masks/curve_masks.h>
void use_subdivide_curve(const Polygon& polygon)
{
  (void)subdivide_curve(polygon, B_spline_mask(3), Curve_end::closed);
}
#elif defined(IN_USE_CGAL_PN_fitting_3_interpolate_curve_h)
#  include "headers/polygon.h"
#  include <CGAL/PN_curves/masks/curve_masks.h>
void use_interpolate_curve(const Polygon& polygon)
{
  (void)interpolate_curve(polygon, B_spline_mask(3), Curve_end::closed);
}
#elif defined(IN_USE_CGAL_PN_fitting_3_interpolate_limit_points_h)
#  include "headers/mesh.h"
#  include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#  include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
void use_interpolation(Mesh& mesh)
{
  interpolate_limit_points(mesh, linear(Loop_scheme()));
}
#elif defined(IN_USE_CGAL_PN_fitting_3_prescribe_limit_data_h)
#  include "headers/mesh.h"
#  include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#  include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
void use_prescription(Mesh& mesh)
{
  prescribe_limit_data(mesh, linear(Loop_scheme()));
}
#elif defined(IN_USE_CGAL_PN_limit_surface_3_estimate_curvature_h)
#  include "headers/mesh.h"
void use_curvature(Mesh& mesh)
{
  const auto map = mesh.add_property_map<Mesh::Vertex_index, Vertex_curvature<Kernel>>("v:k").first;
  estimate_curvature(mesh, map);
}
#elif defined(IN_USE_CGAL_PN_limit_surface_3_limit_points_h)
#  include "headers/mesh.h"
#  include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#  include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
void use_limits(Mesh& mesh)
{
  const auto limits =
    mesh.add_property_map<Mesh::Vertex_index, Limit_point<Kernel>>("v:limit").first;
  limit_points(mesh, linear(Loop_scheme()), limits);
}
#elif defined(IN_USE_CGAL_PN_limit_surface_3_refine_in_pieces_h)
#  include "headers/mesh.h"
#  include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#  include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
void use_pieces(Mesh& mesh)
{
  Surface_pieces pieces(mesh, linear(Loop_scheme()), parameters::number_of_pieces(2));
  const auto piece = pieces.piece(0);
  (void)piece.points();
}
#elif defined(IN_USE_CGAL_PN_limit_surface_3_subdivide_to_limit_h)
#  include "headers/mesh.h"
#  include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#  include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
void use_subdivide_to_limit(Mesh& mesh)
{
  subdivide_to_limit(mesh, linear(Loop_scheme()), parameters::tolerance(1e-3));
  subdivide_to_limit(mesh, linear(Loop_scheme()));
}
#elif defined(IN_USE_CGAL_PN_recognition_3_triangulate_planes_h)
#  include "headers/mesh.h"
#  include <vector>
std::size_t use_triangulate_planes(Mesh& mesh)
{
  const auto patches = mesh.add_property_map<Mesh::Face_index, int>("f:surface").first;
  const std::vector<Recognized_surface> surfaces(1);
  return triangulate_planes(mesh, patches, surfaces).size();
}
#elif defined(IN_USE_CGAL_PN_subdivision_3_Surface_refiner_h)
#  include "headers/mesh.h"
#  include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#  include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
void use_refiner(Mesh& mesh)
{
  Surface_refiner refiner(mesh, linear(Loop_scheme()));
  (void)refiner.number_of_control_vertices();
  Surface_refiner carrying(mesh, linear(Loop_scheme()), parameters::attributes());
  carrying.build_mesh(mesh, parameters::attributes());
}
#elif defined(IN_USE_CGAL_PN_subdivision_3_attributes_h)
#  include "headers/mesh.h"
void use_attributes(Mesh& mesh)
{
  const auto colors = mesh.add_property_map<Mesh::Vertex_index, double>("v:color").first;
  (void)parameters::attributes(parameters::vertex_attribute(colors));
}
#elif defined(IN_USE_CGAL_PN_subdivision_3_average_PN_average_h)
struct Entry
{
  int vertex;
  double weight;
};

void use_average()
{
  const PN_average<double, 3>::Value values[1] = {{{0, 0, 0}, {0, 0, 1}}};
  const Entry entries[2] = {{0, 0.5}, {0, 0.5}};
  (void)PN_average<double, 3>()(entries, entries + 2, values);
}
#elif defined(IN_USE_CGAL_PN_subdivision_3_boost_multiprecision_floats_h)
#  include <CGAL/Simple_cartesian.h>
bool is_positive(const boost::multiprecision::cpp_bin_float_50& x)
{
  return CGAL::is_finite(x) && CGAL::is_valid(x) && CGAL::is_positive(x);
}
#elif defined(IN_USE_CGAL_PN_subdivision_3_detect_creases_h)
#  include "headers/mesh.h"
void use_detect_creases(Mesh& mesh)
{
  detect_creases(mesh, 30, mesh.add_property_map<Mesh::Edge_index, int>("e:sharp").first);
}
#elif defined(IN_USE_CGAL_PN_subdivision_3_estimate_control_normals_h)
#  include "headers/mesh.h"
void use_estimate(Mesh& mesh)
{
  estimate_control_normals(mesh, normals_of(mesh));
  const auto normals = estimate_control_normals(mesh);
  put(normals, *mesh.vertices().begin(), normals[*mesh.vertices().begin()]);
}
#elif defined(IN_USE_CGAL_PN_subdivision_3_parameters_Default_visitor_h)
bool use_control_element(const Control_element& a, const Control_element& b)
{
  return a == b || a < b;
}

struct Visitor : Default_visitor
{
  void face_created(int, const Control_element&) {}
};
void use_default_visitor(Visitor& visitor)
{
  visitor.face_created(1, {Control_element::Kind::face, 0});
  visitor.round_done(1, 6);
  visitor.vertex_created(1, {Control_element::Kind::vertex, 0});
}
#elif defined(IN_USE_CGAL_PN_subdivision_3_rational_normals_h)
#  include <CGAL/Exact_rational.h>
#  include <CGAL/Simple_cartesian.h>
using Exact = CGAL::Simple_cartesian<CGAL::Exact_rational>;

Exact::Vector_3 short_normal(const Exact::Vector_3& v)
{
  const Rounded_exact_normals rounded(30);
  return rational_unit_normal(v, 30);
}
#elif defined(IN_USE_CGAL_PN_subdivision_3_rows_Stencil_h)
bool use_limit_neighborhood()
{
  constexpr Limit_neighborhood neighborhood{0, true, true, false};
  return neighborhood.is_spline;
}
#elif defined(IN_USE_CGAL_PN_subdivision_3_scheme_parts_scheme_adaptors_h)
#  include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
void use_adaptors()
{
  (void)linear(with_normal_scheme(CatmullClark_scheme(), CatmullClark_scheme()));
}
#elif defined(IN_USE_CGAL_PN_subdivision_3_schemes_Any_scheme_h)
struct Scheme
{
  using Host = PTQ_host;
  struct Mask
  {
    template <class Stencil>
    void vertex(Level_connectivity::Index v, Stencil& s) const
    {
      s.add_rest(v);
    }
    template <class Stencil>
    void edge(Level_connectivity::Index e, Stencil& s) const
    {
      s.add_rest(e);
    }
  };
  template <class FT>
  Mask mask(const Level_connectivity&, unsigned) const
  {
    return {};
  }
};

bool use_any_scheme()
{
  const Any_scheme<float> scheme{Scheme()};
  return scheme.name().empty() && scheme.needs_triangles();
}
#elif defined(IN_USE_CGAL_PN_subdivision_3_schemes_Bilinear_scheme_h)
#  include "headers/row.h"
template void use_quad_rules(const Bilinear_scheme&);
#elif defined(IN_USE_CGAL_PN_subdivision_3_schemes_Butterfly_scheme_h)
#  include "headers/row.h"
template void use_triangle_rules(const Butterfly_scheme&);
#elif defined(IN_USE_CGAL_PN_subdivision_3_schemes_CatmullClark_scheme_h)
#  include "headers/row.h"
template void use_quad_rules(const CatmullClark_scheme&);
#elif defined(IN_USE_CGAL_PN_subdivision_3_schemes_DooSabin_scheme_h)
#  include "headers/row.h"
void use_doosabin()
{
  const Level_connectivity level = connect();
  const auto mask = DooSabin_scheme().mask<double>(level, 1);
  Row row;
  mask.corner(0, row);
}
#elif defined(IN_USE_CGAL_PN_subdivision_3_schemes_Kobbelt_scheme_h)
#  include "headers/row.h"
template void use_quad_rules(const Kobbelt_scheme&);
#elif defined(IN_USE_CGAL_PN_subdivision_3_schemes_Loop_scheme_h)
#  include "headers/row.h"
template void use_triangle_rules(const Loop_scheme&);
#elif defined(IN_USE_CGAL_PN_subdivision_3_schemes_Midpoint_scheme_h)
#  include "headers/row.h"
template void use_triangle_rules(const Midpoint_scheme&);
#elif defined(IN_USE_CGAL_PN_subdivision_3_schemes_Sqrt3_scheme_h)
#  include "headers/row.h"
void use_sqrt3()
{
  const Level_connectivity level = connect();
  const auto mask = Sqrt3_scheme().mask<double>(level, 1);
  Row row;
  mask.vertex(0, row);
  mask.face(0, row);
}
#elif defined(IN_USE_CGAL_PN_subdivision_3_schemes_Transfer_schemes_h)
#  include "headers/row.h"
template void use_quad_rules(const CatmullClark_scheme::Transfer&);
template void use_triangle_rules(const Loop_scheme::Transfer&);
#elif defined(IN_USE_CGAL_PN_subdivision_3_schemes_Tuned_CatmullClark_scheme_h)
#  include "headers/row.h"
template void use_quad_rules(const CatmullClark_scheme::Tuned&);
#elif defined(IN_USE_CGAL_PN_subdivision_3_schemes_Tuned_Loop_scheme_h)
#  include "headers/row.h"
template void use_triangle_rules(const Loop_scheme::Tuned&);
#elif defined(IN_USE_CGAL_PN_subdivision_3_schemes_scheme_by_name_h)
bool use_scheme_by_name()
{
  return any_scheme("kobbelt", {{"tension", {1, 16}}}).interpolates();
}
#elif defined(IN_USE_CGAL_PN_subdivision_3_subdivide_h)
#  include "headers/mesh.h"
#  include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#  include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
void use_subdivide(Mesh& mesh)
{
  subdivide(mesh, linear(Loop_scheme()));
}
#elif defined(IN_USE_CGAL_PN_subdivision_3_subdivision_methods_3_h)
#  include "headers/mesh.h"
void use_methods(Mesh& mesh)
{
  Sqrt3_subdivision(mesh);
}
#elif defined(IN_USE_analysis_Extraordinary_net_h)
void use_extraordinary_net()
{
  Extraordinary_net net(4, 5, 2);
  (void)net;
}
#elif defined(IN_USE_analysis_extraordinary_curvature_h)
#  include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
void use_extraordinary_curvature()
{
  (void)Extraordinary_vertex_zoom<CatmullClark_scheme>(CatmullClark_scheme(), 5);
}
#elif defined(IN_USE_analysis_extraordinary_eigenvalues_h)
#  include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
void use_eigenvalues()
{
  (void)extraordinary_eigenvalues(CatmullClark_scheme(), 5);
}
#elif defined(IN_USE_analysis_subdivision_matrix_h)
#  include "headers/mesh.h"
#  include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#  include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
void use_matrix(const Mesh& mesh)
{
  (void)subdivision_matrix(mesh, Loop_scheme());
}
#endif

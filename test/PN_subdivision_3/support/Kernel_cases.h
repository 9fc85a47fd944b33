// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Every scheme and every function with a kernel: close to what the kernel with double gives.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_KERNEL_CASES_H
#define CGAL_PN_SUBDIVISION_3_TEST_KERNEL_CASES_H

#include "Curve_cases.h"
#include "Mesh_cases.h"
#include "Scheme_runs.h"
#include "Schemes.h"
#include "analysis/curve_analysis.h"

#include <CGAL/PN_certificates_3/reproduction.h>
#include <CGAL/PN_subdivision_3/estimate_control_normals.h>

namespace kernel_cases {

namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;
using test_meshes::Control_mesh;
using test_meshes::Triple;

// small: some kernels are slow
template <std::size_t degree>
Control_mesh control_mesh()
{
  using namespace test_meshes;
  Control_mesh mesh = degree == 3   ? with_centers(grid(2, 2, false, false, Cells::triangles), 4)
                      : degree == 4 ? grid(3, 2, false, false, Cells::quads)
                                    : house(3);
  set_uneven_normals(mesh, 1);
  return mesh;
}

// --- schemes ---

template <class FT>
using Point_normals = std::vector<PN::Point_normal<FT, 3>>;

template <class FT, class Scheme>
auto mask_of_normals(const Scheme& scheme, const PN::Level_connectivity& level)
{
  if constexpr (PN::internal::Has_normal_mask<Scheme>::value)
    return scheme.template normal_mask<FT>(level, 1);
  else
    return scheme.template mask<FT>(level, 1);
}

// One round in the number type FT: all of subdivide() that depends on the scheme and on FT, but not
// the mesh around it.
template <class FT, class Scheme>
Point_normals<FT> one_round(const Control_mesh& control, const Scheme& scheme)
{
  using Average = PN::PN_average<FT, 3>;
  Point_normals<FT> old, result;
  for (std::size_t i = 0; i < control.points.size(); ++i) {
    const Triple &p = control.points[i], &n = control.normals[i];
    old.push_back({{FT(p[0]), FT(p[1]), FT(p[2])}, {FT(n[0]), FT(n[1]), FT(n[2])}});
    PN::internal::normalize_control_normal<FT, 3>(old.back().normal);
  }
  const Surface_mesh mesh = to_surface_mesh(control);
  const PN::internal::Surface_mesh_access<const Surface_mesh> access(mesh);
  const PN::Level_connectivity level = PN::internal::checked_level(access);
  const typename Scheme::Host host(level, 1);
  const auto mask = scheme.template mask<FT>(level, 1);
  const auto normal_mask = mask_of_normals<FT>(scheme, level);
  const PN::Level_connectivity::Index size = Scheme::Host::refined_size(level.size(), 1).vertices;
  PN::internal::Stencil_block<FT> row, normal_row;
  for (PN::Level_connectivity::Index v = 0; v < size; ++v) {
    row.clear();
    normal_row.clear();
    host.stencil(mask, v, row.row());
    host.stencil(normal_mask, v, normal_row.row());
    row.close_row();
    normal_row.close_row();
    result.push_back(
      Average()(row.begin(0), row.end(0), normal_row.begin(0), normal_row.end(0), old.data()));
  }
  return result;
}

template <class FT>
constexpr bool has_exact_roots = PN::internal::is_exact_v<FT>&& PN::internal::has_sqrt_v<FT>;

// the largest difference to the numbers of double, and of a squared length of a normal to 1
template <class FT, class Scheme>
void expect_scheme(const Scheme& scheme, const Control_mesh& control, double tolerance, double unit,
                   const std::string& name)
{
  const auto values = one_round<FT>(control, scheme);
  const auto expected = one_round<double>(control, scheme);
  ASSERT_EQ(values.size(), expected.size()) << name;
  double largest = 0, excess = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    FT length(0);
    for (std::size_t k = 0; k < 3; ++k) {
      const FT &p = values[i].point[k], &n = values[i].normal[k];
      length += n * n;
      for (double d : {double(CGAL::to_double(p)) - expected[i].point[k],
                       double(CGAL::to_double(n)) - expected[i].normal[k]})
        if (!(std::abs(d) <= largest)) largest = std::abs(d);
    }
    if constexpr (!has_exact_roots<FT>) { // there, to tell a zero takes long
      const double e = std::abs(double(CGAL::to_double(FT(length - FT(1)))));
      if (!(e <= excess)) excess = e;
    }
  }
  EXPECT_LE(largest, tolerance) << name;
  EXPECT_LE(excess, unit) << name;
}

template <class FT, class... Description>
void expect_schemes(testing::Types<Description...>, double tolerance, double unit)
{
  (expect_scheme<FT>(Description::scheme(), control_mesh<Description::degree>(), tolerance, unit,
                     Scheme_names::GetName<Description>(0)),
   ...);
}

// --- functions of meshes ---

template <class K>
struct Mesh_with_normals
{
  using Vector = typename K::Vector_3;

  template <class Shape>
  explicit Mesh_with_normals(const Shape& control)
  {
    mesh_cases::build(control, mesh);
    PN::estimate_control_normals(mesh, normals);
  }

  CGAL::Surface_mesh<typename K::Point_3> mesh;
  typename CGAL::Surface_mesh<typename K::Point_3>::template Property_map<CGAL::SM_Vertex_index,
                                                                          Vector>
    normals = mesh.template add_property_map<CGAL::SM_Vertex_index, Vector>("n").first;
};

// Normals of another scheme, estimated normals, deviations.
template <class K>
void expect_mesh_functions(double tolerance, double unit)
{
  const Control_mesh control = control_mesh<4>();
  expect_scheme<typename K::FT>(
    PN::with_normal_scheme(PN::Kobbelt_scheme(), PN::CatmullClark_scheme()), control, tolerance,
    unit, "normals of another scheme");

  const Mesh_with_normals<K> m(control);
  const Mesh_with_normals<CGAL::Simple_cartesian<double>> expected(control);
  for (auto v : m.mesh.vertices())
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(double(CGAL::to_double(m.normals[v][c])), expected.normals[v][c], tolerance);

  const typename K::Sphere_3 sphere(typename K::Point_3(0, 0, -1), typename K::FT(2));
  const auto deviation = PN::mesh_deviation(m.mesh, sphere, params::vertex_normal_map(m.normals));
  EXPECT_EQ(deviation.number_of_points, control.points.size());
  EXPECT_FALSE(CGAL::certainly(deviation.points_are_on_shape));
  EXPECT_GT(deviation.distance.sup(), 0.5);
}

// All of subdivide(), with borders and a normal that is missing: points and normals, and the lengths of these, which are 1
// up to `unit`, or 0.
template <class K>
void expect_subdivision(double tolerance, double unit)
{
  const auto expect_near = [](const auto& a, const auto& b, double bound) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i)
      for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(a[i][c], b[i][c], bound) << i;
  };
  const auto refine = [](auto& m, const mesh_cases::Soup& soup) {
    mesh_cases::put_normals(mesh_cases::normals(soup), m.mesh, m.normals);
    const auto np = params::number_of_iterations(has_exact_roots<typename K::FT> ? 1 : 2)
                      .vertex_normal_map(m.normals);
    if (soup.faces[0].size() == 3)
      PN::subdivide(m.mesh, PN::Loop_scheme(), np);
    else
      PN::subdivide(m.mesh, PN::CatmullClark_scheme(), np);
  };
  for (const auto& soup : {mesh_cases::triangles_with_border(), mesh_cases::mixed_with_border()}) {
    Mesh_with_normals<K> m(soup);
    Mesh_with_normals<CGAL::Simple_cartesian<double>> expected(soup);
    refine(m, soup);
    refine(expected, soup);
    expect_near(mesh_cases::points(m.mesh), mesh_cases::points(expected.mesh), tolerance);
    expect_near(mesh_cases::values(m.mesh, m.normals),
                mesh_cases::values(expected.mesh, expected.normals), tolerance);
    EXPECT_EQ(mesh_cases::faces_of(m.mesh), mesh_cases::faces_of(expected.mesh));
    if constexpr (!has_exact_roots<typename K::FT>)
      for (auto v : m.mesh.vertices()) {
        const typename K::FT length = m.normals[v].squared_length();
        if (CGAL::to_double(length) == 0) continue;
        EXPECT_LE(std::abs(double(CGAL::to_double(typename K::FT(length - 1)))), unit) << v;
      }
  }
}

// --- curves ---

template <class K>
using Curve_2 = curve_cases::Curve_2<K>;

template <class K>
Curve_2<K> polygon_2()
{
  Curve_2<K> polygon;
  using FT = typename K::FT;
  for (const auto& [p, n] : curve_cases::wavy<curve_cases::Double>(7))
    polygon.emplace_back(typename K::Point_2(FT(p.x()), FT(p.y())),
                         typename K::Vector_2(FT(n.x()), FT(n.y())));
  return polygon;
}

template <class K>
curve_cases::Curve_3<K> polygon_3()
{
  curve_cases::Curve_3<K> polygon;
  using FT = typename K::FT;
  for (const auto& [p, n] : curve_cases::wavy<curve_cases::Double>(7))
    polygon.emplace_back(typename K::Point_3(FT(p.x()), FT(p.y()), FT(p.x() * p.y())),
                         typename K::Vector_3(FT(n.x()), FT(0), FT(n.y())));
  return polygon;
}

template <class Curve, class Double_curve>
double largest_difference(const Curve& curve, const Double_curve& expected)
{
  if (curve.size() != expected.size()) return HUGE_VAL;
  double largest = 0;
  const auto compare = [&largest](const auto& a, const auto& b) {
    for (int c = 0; c < b.dimension(); ++c) {
      const double d = std::abs(double(CGAL::to_double(a.cartesian(c))) - b.cartesian(c));
      if (!(d <= largest)) largest = d;
    }
  };
  for (std::size_t i = 0; i < curve.size(); ++i) {
    compare(curve[i].first, expected[i].first);
    compare(curve[i].second, expected[i].second);
  }
  return largest;
}

// One round by each kind of mask.
template <class K>
void expect_masks(double tolerance)
{
  using Double = curve_cases::Double;
  const auto expect_mask = [&](const auto& mask, curve_cases::Curve_end end, const char* what) {
    EXPECT_LE(largest_difference(PN::subdivide_curve(polygon_2<K>(), mask, end),
                                 PN::subdivide_curve(polygon_2<Double>(), mask, end)),
              tolerance)
      << what;
  };
  using PN::Curve_end;
  const PN::B_spline_mask cubic(3);
  const PN::Dubuc_Deslauriers_mask four_points(4), six_points(6);
  expect_mask(PN::B_spline_mask(2), Curve_end::closed, "quadratic B-spline");
  expect_mask(cubic, Curve_end::none, "cubic B-spline");
  expect_mask(four_points, Curve_end::reflect, "four points");
  expect_mask(six_points, Curve_end::closed, "six points");
  expect_mask(PN::linear(cubic), Curve_end::reflect, "linear");
  expect_mask(PN::with_normal_mask(cubic, four_points), Curve_end::closed, "normals by another");
  EXPECT_LE(largest_difference(PN::subdivide_curve(polygon_3<K>(), cubic, Curve_end::reflect),
                               PN::subdivide_curve(polygon_3<Double>(), cubic, Curve_end::reflect)),
            tolerance);
  expect_mask(PN::Univariate_mask<double>(-2, {0.125, 0.5, 0.75, 0.5, 0.125}), Curve_end::closed,
              "coefficients");
}

// Normals made and changed, measures.
template <class K>
void expect_curve_functions(double tolerance)
{
  using Double = curve_cases::Double;
  using PN::Curve_end;
  auto curve = PN::estimate_control_normals(polygon_2<K>(), Curve_end::closed);
  auto expected = PN::estimate_control_normals(polygon_2<Double>(), Curve_end::closed);
  PN::rotate_control_normals(curve, 0.3);
  PN::rotate_control_normals(expected, 0.3);
  EXPECT_LE(largest_difference(curve, expected), tolerance);

  const auto bends = PN::discrete_curvature(curve, Curve_end::closed);
  const auto expected_bends = PN::discrete_curvature(expected, Curve_end::closed);
  const auto comb = PN::curvature_comb(curve, Curve_end::closed, 0.5);
  const auto expected_comb = PN::curvature_comb(expected, Curve_end::closed, 0.5);
  ASSERT_EQ(comb.size(), curve.size());
  for (std::size_t i = 0; i < curve.size(); ++i) {
    EXPECT_NEAR(bends[i], expected_bends[i], 10 * tolerance);
    EXPECT_NEAR(double(CGAL::to_double(comb[i].x())), expected_comb[i].x(), 10 * tolerance);
    EXPECT_NEAR(double(CGAL::to_double(comb[i].y())), expected_comb[i].y(), 10 * tolerance);
  }
  const auto deviation =
    PN::curve_deviation(curve, typename K::Circle_2(typename K::Point_2(0, 0), typename K::FT(1)));
  EXPECT_EQ(deviation.number_of_points, curve.size());
  EXPECT_GT(deviation.distance.sup(), 0.5);
}

// everything, with points and normals within `tolerance` of those of double
template <class K>
void expect_everything(double tolerance, double unit)
{
  expect_schemes<typename K::FT>(Schemes_elsewhere(), tolerance, unit);
  expect_mesh_functions<K>(tolerance, unit);
  expect_subdivision<K>(tolerance / 5, unit);
  expect_masks<K>(tolerance);
  expect_curve_functions<K>(tolerance);
}

} // namespace kernel_cases

#endif // CGAL_PN_SUBDIVISION_3_TEST_KERNEL_CASES_H

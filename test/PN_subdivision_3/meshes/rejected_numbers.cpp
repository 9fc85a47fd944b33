// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Kernels, number types and points that cannot serve, of which nothing compiles; see rejected_arguments.cmake.

#include <CGAL/Gmpz.h>
#include <CGAL/Mpzf.h>
#include <CGAL/PN_certificates_3/reproduction.h>
#include <CGAL/PN_limit_surface_3/limit_points.h>
#include <CGAL/PN_limit_surface_3/subdivide_to_limit.h>
#include <CGAL/PN_subdivision_3.h>
#include <CGAL/PN_subdivision_curve.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Simple_homogeneous.h>
#include <CGAL/Surface_mesh.h>

#include <boost/numeric/interval.hpp>

#include <array>
#include <utility>
#include <vector>

namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;

// a number type without CGAL's traits
struct Own_number
{
  Own_number(double = 0) {}
  friend Own_number operator+(Own_number a, Own_number) { return a; }
  friend Own_number operator-(Own_number a, Own_number) { return a; }
  friend Own_number operator*(Own_number a, Own_number) { return a; }
  friend Own_number operator/(Own_number a, Own_number) { return a; }
  friend bool operator==(Own_number, Own_number) { return true; }
  friend bool operator<(Own_number, Own_number) { return true; }
};

// a field with CGAL's traits: 0 rounds, with a radix that nobody tells; 1 is an interval whose comparisons are bool
template <int kind>
struct Own_field : Own_number
{
  Own_field(double = 0) {}
  friend Own_field operator+(Own_field a, Own_field) { return a; }
  friend Own_field operator-(Own_field a, Own_field) { return a; }
  friend Own_field operator*(Own_field a, Own_field) { return a; }
  friend Own_field operator/(Own_field a, Own_field) { return a; }
  friend bool operator==(Own_field, Own_field) { return true; }
  friend bool operator<(Own_field, Own_field) { return true; }
};
double lower(const Own_field<1>&);
double upper(const Own_field<1>&);

namespace CGAL {
template <int kind>
class Algebraic_structure_traits<Own_field<kind>>
  : public Algebraic_structure_traits_base<Own_field<kind>, Field_tag>
{
public:
  using Is_exact = Tag_false;
};
template <int kind>
class Real_embeddable_traits<Own_field<kind>>
  : public INTERN_RET::Real_embeddable_traits_base<Own_field<kind>, Tag_true>
{
public:
  struct To_double
  {
    double operator()(const Own_field<kind>&) const;
  };
  struct To_interval
  {
    std::pair<double, double> operator()(const Own_field<kind>&) const;
  };
};
} // namespace CGAL

// points of no kernel
template <int>
struct Own_point
{
  double x, y, z;
};

template <class FT>
using Mesh_of = CGAL::Surface_mesh<CGAL::Point_3<CGAL::Simple_cartesian<FT>>>;

#ifdef __SIZEOF_FLOAT128__
__extension__ typedef __float128 Quadruple;
#endif

void reject()
{
  Mesh_of<int> integers;
  PN::CatmullClark_subdivision(integers);
  // expected: the number type of the kernel is not a field

  Mesh_of<CGAL::Mpzf> ring;
  PN::Loop_subdivision(ring);
  // expected: the number type of the kernel is not a field

  CGAL::Surface_mesh<CGAL::Simple_homogeneous<CGAL::Gmpz>::Point_3> homogeneous;
  PN::CatmullClark_subdivision(homogeneous);
  // expected: the kernel is homogeneous

  Mesh_of<boost::numeric::interval<double>> intervals;
  PN::CatmullClark_subdivision(intervals);
  // expected: has no CGAL::Algebraic_structure_traits

  Mesh_of<Own_number> numbers;
  PN::CatmullClark_subdivision(numbers);
  // expected: has no CGAL::Algebraic_structure_traits

  Mesh_of<Own_field<1>> intervals_of_bool;
  PN::CatmullClark_subdivision(intervals_of_bool);
  // expected: comparisons of this interval type cannot be undecided

  [[maybe_unused]] PN::Deviation_number<Own_field<0>>* deviation = nullptr;
  // expected: deviations of numbers that round are measured in exact ones

  CGAL::Surface_mesh<Own_point<1>> points;
  PN::CatmullClark_subdivision(points);
  // expected: the points do not belong to a CGAL kernel

  CGAL::Surface_mesh<Own_point<2>> more_points;
  PN::subdivide_to_limit(more_points, PN::Loop_scheme(), CGAL::parameters::number_of_iterations(0));
  // expected: the points do not belong to a CGAL kernel

  PN::subdivide_curve(std::vector<std::pair<Own_point<3>, Own_point<3>>>(), PN::B_spline_mask(3),
                      PN::Curve_end::closed);
  // expected: the points do not belong to a CGAL kernel

  Mesh_of<double> mesh;
  auto arrays =
    mesh.add_property_map<Mesh_of<double>::Vertex_index, std::array<double, 3>>("arrays").first;
  PN::CatmullClark_subdivision(mesh, params::vertex_normal_map(arrays));
  // expected: the values of the normal map are not Vector_3

#ifdef __SIZEOF_FLOAT128__
  Mesh_of<Quadruple> quadruple;
  PN::CatmullClark_subdivision(quadruple);
  // expected: has no CGAL::Algebraic_structure_traits
#endif
}

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The same polygon in all number types that serve: rational points of the unit circle with radial normals are refined by the cubic
// B-spline. Printed are, for each type, the largest deviation from the circle, in units of its last place (of 2^-52 in exact types),
// and whether the points may be, are or are not on it. Intervals grow; exact types without square root round lengths of normals.

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/PN_certificates_3/reproduction.h>
#include <CGAL/PN_curves/masks/curve_masks.h>
#include <CGAL/PN_curves/subdivide_curve.h>
#include <CGAL/PN_subdivision_3/boost_multiprecision_floats.h>
#include <CGAL/Simple_cartesian.h>

#ifdef CGAL_USE_GMP
#  include <CGAL/Gmpq.h>
#  include <CGAL/PN_subdivision_3/sqrt_extension_normals.h>
#endif
#ifdef CGAL_USE_MPFR
#  include <CGAL/Gmpfr.h>
#endif
#ifdef CGAL_USE_MPFI
#  include <CGAL/Gmpfi.h>
#endif
#ifdef CGAL_USE_GMPXX
#  include <CGAL/mpq_class.h>
#endif
#ifdef CGAL_USE_CORE
#  include <CGAL/Exact_predicates_exact_constructions_kernel_with_sqrt.h>
#endif

#include <algorithm>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace PN = CGAL::PN_subdivision_3;

// what is promised of a type: at most so many units, and whether "not on the circle" would be an error
struct Promise
{
  double units;
  bool is_certified;
};

template <class Kernel>
bool refine(const std::string& name, unsigned rounds, const Promise& promise)
{
  using FT = typename Kernel::FT;
  std::vector<std::pair<typename Kernel::Point_2, typename Kernel::Vector_2>> polygon;
  const int triples[][3] = {{3, 4, 5}, {-5, 12, 13}, {-15, -8, 17}, {7, -24, 25}}; // x, y, radius
  for (const auto& t : triples) {
    const FT x = FT(t[0]) / FT(t[2]), y = FT(t[1]) / FT(t[2]);
    polygon.emplace_back(typename Kernel::Point_2(x, y), typename Kernel::Vector_2(x, y));
  }
  const auto curve = PN::subdivide_curve(polygon, PN::B_spline_mask(3), PN::Curve_end::closed,
                                         CGAL::parameters::number_of_iterations(rounds));
  const typename Kernel::Circle_2 circle(typename Kernel::Point_2(0, 0), FT(1));
  double units = 0;
  for (const auto& item : curve)
    units = (std::max)(units, PN::distance_in_ulps(item.first, circle).sup());
  const auto on = PN::curve_deviation(curve, circle).points_are_on_shape;
  const bool is_kept = units <= promise.units && !(promise.is_certified && CGAL::certainly_not(on));
  std::cout << std::left << std::setw(55) << name << std::setw(12) << units << std::setw(10)
            << (CGAL::certainly(on)       ? "on"
                : CGAL::certainly_not(on) ? "near"
                                          : "maybe on")
            << (is_kept ? "" : "  not as promised") << "\n";
  return is_kept;
}

template <class FT>
bool refine_in(const std::string& name, unsigned rounds, const Promise& promise)
{
  return refine<CGAL::Simple_cartesian<FT>>(name, rounds, promise);
}

int main()
{
  const Promise rounded{5, false}, enclosed{1e6, true}, nearly_exact{64, false};
  std::cout << std::setprecision(3);
  bool is_kept = refine_in<float>("float", 4, rounded);
  is_kept &= refine_in<double>("double", 4, rounded);
  is_kept &= refine_in<long double>("long double", 4, rounded);
  is_kept &= refine<CGAL::Exact_predicates_inexact_constructions_kernel>(
    "Exact_predicates_inexact_constructions_kernel", 4, rounded);
  is_kept &= refine_in<CGAL::Interval_nt<>>("Interval_nt", 4, enclosed);
  is_kept &= refine_in<boost::multiprecision::cpp_bin_float_50>("cpp_bin_float_50", 4, rounded);
#ifdef CGAL_PN_SUBDIVISION_3_HAS_FLOAT128
  is_kept &= refine_in<boost::multiprecision::float128>("float128", 4, rounded);
#endif
#ifdef CGAL_USE_MPFR
  is_kept &= refine_in<boost::multiprecision::mpfr_float_50>("mpfr_float_50", 4, rounded);
  CGAL::Gmpfr::set_default_precision(300);
  is_kept &= refine_in<CGAL::Gmpfr>("Gmpfr, 300 bits", 4, rounded);
#endif
#ifdef CGAL_USE_MPFI
  CGAL::Gmpfi::set_default_precision(300);
  is_kept &= refine_in<CGAL::Gmpfi>("Gmpfi, 300 bits", 4, enclosed);
#endif
#ifdef CGAL_USE_GMP
  is_kept &= refine_in<CGAL::Gmpq>("Gmpq", 2, nearly_exact);
  is_kept &= refine_in<CGAL::Sqrt_extension<CGAL::Gmpq, CGAL::Gmpq, CGAL::Tag_true>>(
    "Sqrt_extension", 1, {0, true});
#endif
#ifdef CGAL_USE_GMPXX
  is_kept &= refine_in<mpq_class>("mpq_class", 2, nearly_exact);
#endif
  is_kept &= refine<CGAL::Exact_predicates_exact_constructions_kernel>(
    "Exact_predicates_exact_constructions_kernel", 2, nearly_exact);
#ifdef CGAL_USE_CORE
  is_kept &= refine<CGAL::Exact_predicates_exact_constructions_kernel_with_sqrt>(
    "Exact_predicates_exact_constructions_kernel_with_sqrt", 1, {0, true});
#endif
  return is_kept ? EXIT_SUCCESS : EXIT_FAILURE;
}

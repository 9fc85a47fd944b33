// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_VERIFICATION_H
#define PN_SUBDIVIDE_VERIFICATION_H

#include "curve/Curve_data.h"
#include "io/Limit_choice.h"
#include "io/Mesh_data.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/PN_certificates_3/reproduction.h>
#include <CGAL/Simple_cartesian.h>

#include <cstdio>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace pn_subdivide {

// The shape that a result is compared with.
class Verification
{
public:
  // sphere:X,Y,Z,R | cylinder:X,Y,Z,DX,DY,DZ,R | circle:X,Y,R | circle:X,Y,Z,NX,NY,NZ,R.
  // Throws Usage_error.
  explicit Verification(const Verify_options& options);

  // Throws Usage_error if it is a circle.
  void require_surface() const;

  // Measures points, or throws Error if they and the shape are of different dimensions.
  void measure(const std::vector<Triple>& points);
  void measure(const Curve_data& curve);

  // Prints what was measured to the stream; throws Error if that cannot be written. To be called
  // before a file is.
  void print(std::FILE* stream) const;
  // Throws Tolerance_error if what was measured is more than the tolerance.
  void require_tolerance() const;

private:
  // In exact numbers: the square of a double is not a double.
  using Exact = CGAL::Simple_cartesian<CGAL::Exact_rational>;
  using Shape =
    std::variant<Exact::Circle_2, Exact::Circle_3, Exact::Sphere_3, PN::Cylinder_3<Exact>>;

  struct Parts
  {
    Curve_kernel::Point_3 center;
    Curve_kernel::Vector_3 direction;
    double radius;
  };

  static Parts parse_parts(const std::string& text);
  static Shape make_shape(const std::string& text, const Parts& parts);
  template <class Points>
  void measure_points(const Points& points);
  template <class Points>
  double farthest_center(const Points& points) const;

  std::string text_;
  Parts parts_;
  Shape shape_;
  std::optional<double> tolerance_;
  double deviation_ = 0, bound_ = 0;
};

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_VERIFICATION_H

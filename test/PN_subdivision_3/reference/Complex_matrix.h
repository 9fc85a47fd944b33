// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_COMPLEX_MATRIX_H
#define CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_COMPLEX_MATRIX_H

#include "Face_list.h"

#include <complex>

namespace reference {

using Complex = std::complex<Real>;
using Complex_matrix = Eigen::Matrix<Complex, Eigen::Dynamic, Eigen::Dynamic>;
using Complex_vector = Eigen::Matrix<Complex, Eigen::Dynamic, 1>;

} // namespace reference

#endif // CGAL_PN_SUBDIVISION_3_TEST_REFERENCE_COMPLEX_MATRIX_H

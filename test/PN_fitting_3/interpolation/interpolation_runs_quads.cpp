// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "Interpolation_runs_definitions.h"

#include <CGAL/PN_subdivision_3/schemes/Tuned_CatmullClark_scheme.h>

namespace interpolation_cases {

template struct Interpolation_runs<PN::CatmullClark_scheme>;
template struct Interpolation_runs<PN::CatmullClark_scheme::Tuned>;
template struct Interpolation_runs<PN::Linear_scheme<PN::CatmullClark_scheme>>;
template struct Interpolation_runs<PN::Linear_scheme<PN::CatmullClark_scheme::Tuned>>;
template struct Distance_runs<PN::CatmullClark_scheme>;
template struct Distance_runs<PN::CatmullClark_scheme::Tuned>;
template struct Further_interpolation_runs<PN::CatmullClark_scheme::Tuned>;

} // namespace interpolation_cases

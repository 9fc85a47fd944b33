// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include <CGAL/PN_fitting_3/internal/find_control_net.h>

namespace CGAL::PN_subdivision_3::internal {

template Interpolation_result<2> interpolate_polygon(bool, const Interpolation_options&,
                                                     Interpolation_data<2>&);
template Interpolation_result<3> interpolate_polygon(bool, const Interpolation_options&,
                                                     Interpolation_data<3>&);

} // namespace CGAL::PN_subdivision_3::internal

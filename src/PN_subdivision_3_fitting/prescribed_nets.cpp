// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include <CGAL/PN_fitting_3/internal/find_control_net.h>
#include <CGAL/PN_fitting_3/interpolation/Limit_interpolation.h>
#include <CGAL/PN_fitting_3/smooth_control_normals.h>

namespace CGAL::PN_subdivision_3::internal {

template Interpolation_result<3> prescribe(const Level_connectivity&, const Interpolation_options&,
                                           const Interpolation_data<3>&, Surface_limits&,
                                           std::vector<Prescribed_vertex>,
                                           const std::vector<Prescribed_form>&,
                                           Function_ref<std::string(Level_connectivity::Index)>);
template Normal_smoothing_report smooth<3>(const Level_connectivity&, const Interpolation_data<3>&,
                                           Vectors<3>&);

} // namespace CGAL::PN_subdivision_3::internal

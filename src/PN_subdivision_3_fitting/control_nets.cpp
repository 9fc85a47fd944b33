// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include <CGAL/PN_fitting_3/internal/find_control_net.h>
#include <CGAL/PN_fitting_3/interpolation/Limit_interpolation.h>

namespace CGAL::PN_subdivision_3::internal {

template Interpolation_result<3> interpolate_estimated(const Level_connectivity&,
                                                       Control_normal_estimate,
                                                       Interpolation_data<3>&, Surface_limits&);
template Interpolation_result<3> slide_along_normals(const Level_connectivity&,
                                                     Control_normal_estimate,
                                                     Interpolation_data<3>&, Surface_limits&,
                                                     Surface_limits::Farthest);
template Interpolation_result<3> interpolate_strictly(const Level_connectivity&,
                                                      const Interpolation_options&,
                                                      Interpolation_data<3>&, Surface_limits&);
template Interpolation_result<3>
interpolate_evaluated(const Interpolation_data<3>&, bool,
                      Function_ref<Limit_interpolation(Vectors<3>&, double)>);
template void find_natural_normals(Interpolation_data<3>&, Surface_limits&);

} // namespace CGAL::PN_subdivision_3::internal

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include <CGAL/PN_fitting_3/internal/find_control_net.h>
#include <CGAL/PN_fitting_3/smooth_control_normals.h>
#include <CGAL/PN_subdivision_3/internal/meshes/compiled_levels.h>

namespace CGAL::PN_subdivision_3::internal {

CGAL_PN_SUBDIVISION_3_FUNCTIONALS(extern)

#define CGAL_PN_SUBDIVISION_3_PRESCRIBE(...)                                                       \
  template Interpolation_result<3> prescribe(                                                      \
    const Fitted_surface<__VA_ARGS__>&, const Interpolation_options&,                              \
    const Interpolation_data<3>&, std::vector<Prescribed_vertex>,                                  \
    const std::vector<Prescribed_form>&, Function_ref<std::string(Level_connectivity::Index)>);

CGAL_PN_SUBDIVISION_3_PRESCRIBE(Scheme_on_host<PQQ_host, double>)
CGAL_PN_SUBDIVISION_3_PRESCRIBE(Scheme_on_host<PTQ_host, double>)
CGAL_PN_SUBDIVISION_3_PRESCRIBE(compiled_once::Linear_of_quads)
CGAL_PN_SUBDIVISION_3_PRESCRIBE(compiled_once::Linear_of_triangles)
template Normal_smoothing_report smooth<3>(const Level_connectivity&, const Interpolation_data<3>&,
                                           Vectors<3>&);

} // namespace CGAL::PN_subdivision_3::internal

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include <CGAL/PN_fitting_3/internal/find_control_net.h>
#include <CGAL/PN_subdivision_3/internal/meshes/compiled_levels.h>

namespace CGAL::PN_subdivision_3::internal {

CGAL_PN_SUBDIVISION_3_FUNCTIONALS(extern)

#define CGAL_PN_SUBDIVISION_3_NET(ESTIMATES_NORMALS, ...)                                          \
  template Interpolation_result<3> find_control_net<ESTIMATES_NORMALS, true>(                      \
    const Fitted_surface<__VA_ARGS__>&, const Interpolation_options&, Control_normal_estimate,     \
    Interpolation_data<3>&);
#define CGAL_PN_SUBDIVISION_3_CREASED_NET(...)                                                     \
  template Interpolation_result<3> interpolate_creased(                                            \
    const Fitted_surface<__VA_ARGS__>&, std::vector<Slot_value<__VA_ARGS__>>,                      \
    const Creases<double>&, const Interpolation_data<3>&);
#define CGAL_PN_SUBDIVISION_3_NETS(HOST, OF_HOST)                                                  \
  CGAL_PN_SUBDIVISION_3_NET(false, Scheme_on_host<HOST, double>)                                   \
  CGAL_PN_SUBDIVISION_3_NET(true, Scheme_on_host<HOST, double>)                                    \
  CGAL_PN_SUBDIVISION_3_NET(false, compiled_once::Linear_of_##OF_HOST)                             \
  CGAL_PN_SUBDIVISION_3_CREASED_NET(compiled_once::Any_of_##OF_HOST)                               \
  CGAL_PN_SUBDIVISION_3_CREASED_NET(compiled_once::Linear_of_##OF_HOST)                            \
  template void find_natural_normals(const Fitted_surface<Scheme_on_host<HOST, double>>&,          \
                                     Interpolation_data<3>&);

CGAL_PN_SUBDIVISION_3_NETS(PQQ_host, quads)
CGAL_PN_SUBDIVISION_3_NETS(PTQ_host, triangles)

} // namespace CGAL::PN_subdivision_3::internal

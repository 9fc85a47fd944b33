// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "Control.h"

#include <CGAL/PN_limit_surface_3/subdivide_to_limit.h>
#include <CGAL/PN_subdivision_3/attributes.h>
#include <CGAL/PN_subdivision_3/subdivide.h>

namespace pn_python {
namespace {

void subdivide(Control& c, unsigned levels, const py::object& progress)
{
  const Progress told{progress};
  run(c.threads, [&] {
    with_parameters(c, [&](const auto& scheme, const auto& np, auto) {
      PN::subdivide<Tag>(
        c.mesh, scheme,
        PN::parameters::join(PN::parameters::attributes(c.table),
                             np.number_of_iterations(levels).visitor(std::cref(told))));
    });
  });
}

py::array_t<PN::Limit_report> limit(Control& c, unsigned levels, double tolerance,
                                    double normal_tolerance, const py::object& progress)
{
  const Progress told{progress};
  const auto of_vertices = c.mesh.add_property_map<Vertex, Vector_3>("v:limit_normal").first;
  PN::Limit_report report;
  run(c.threads, [&] {
    with_parameters(c, [&](const auto& scheme, const auto& np, auto are_of_corners) {
      report = PN::subdivide_to_limit<Tag>(
        c.mesh, scheme,
        PN::parameters::join(PN::parameters::attributes(c.table)
                               .tolerance(tolerance)
                               .normal_tolerance(normal_tolerance)
                               .surface_normals(true)
                               .limit_normal_map(of_vertices),
                             np.number_of_iterations(levels).visitor(std::cref(told))));
      if constexpr (are_of_corners)
        c.take_surface_normals(c.of_corners);
      else
        c.take_surface_normals(of_vertices);
    });
  });
  return py::array_t<PN::Limit_report>(1, &report);
}

} // namespace

void add_subdivide(py::module_& module)
{
  PYBIND11_NUMPY_DTYPE(PN::Limit_report, error, normal_error, tolerance, number_of_misses,
                       number_of_stand_ins, depth);
  module.def("subdivide", subdivide);
  module.def("limit", limit);
}

} // namespace pn_python

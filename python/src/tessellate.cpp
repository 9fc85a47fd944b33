// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "Control.h"

#include <CGAL/PN_limit_surface_3/tessellate.h>

namespace pn_python {
namespace {

using Result = PN::Tessellation_result;

py::array_t<Result> tessellate(Control& c, double chord)
{
  for (PN::Attribute_array& array : c.table.corners) array.rule = PN::Corner_rule::all;
  Mesh triangles;
  Result result;
  run(c.threads, [&] {
    with_parameters(c, [&](const auto& scheme, const auto& np, auto are_of_corners) {
      using Key = std::conditional_t<are_of_corners, Halfedge, Vertex>;
      const auto normals = triangles.add_property_map<Key, Vector_3>("normal").first;
      result = PN::tessellate<Tag>(c.mesh, scheme, chord, triangles,
                                   PN::parameters::join(PN::parameters::attributes(c.table), np),
                                   CGAL::parameters::vertex_normal_map(normals));
      c.take_result(std::move(triangles));
      c.take_surface_normals(normals);
    });
  });
  return py::array_t<Result>(1, &result);
}

} // namespace

void add_tessellate(py::module_& module)
{
  PYBIND11_NUMPY_DTYPE(Result, bound, worst_face, worst_place, reached, depth);
  module.def("tessellate", tessellate);
}

} // namespace pn_python

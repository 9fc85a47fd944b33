// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The linear functions of CGAL's Subdivision_method_3, on meshes without normals.

#include "Cgal_meshes.h"

#include <CGAL/subdivision_method_3.h>
#include <CGAL/version.h>

#include <string>

namespace {

namespace SM3 = CGAL::Subdivision_method_3;

template <class Subdivide>
void add(Jobs& jobs, const std::string& name, const Subdivide& subdivide)
{
  jobs["cgal/surface-mesh/" + name] = [subdivide](const Control& control, unsigned rounds,
                                                  unsigned) {
    Surface_mesh mesh = surface_mesh(control);
    Result result = timed([&] { subdivide(mesh, CGAL::parameters::number_of_iterations(rounds)); });
    result.faces = mesh.number_of_faces();
    return result;
  };
  jobs["cgal/polyhedron/" + name] = [subdivide](const Control& control, unsigned rounds, unsigned) {
    auto mesh = polyhedron<CGAL::Polyhedron_3<Kernel>>(control);
    Result result = timed([&] { subdivide(mesh, CGAL::parameters::number_of_iterations(rounds)); });
    result.faces = mesh.size_of_facets();
    return result;
  };
}

} // namespace

void add_cgal(Jobs& jobs)
{
  jobs.libraries.push_back("CGAL " CGAL_VERSION_STR);
  add(jobs, "catmull-clark",
      [](auto& mesh, const auto& np) { SM3::CatmullClark_subdivision(mesh, np); });
  add(jobs, "loop", [](auto& mesh, const auto& np) { SM3::Loop_subdivision(mesh, np); });
  add(jobs, "doo-sabin", [](auto& mesh, const auto& np) { SM3::DooSabin_subdivision(mesh, np); });
  add(jobs, "sqrt3", [](auto& mesh, const auto& np) { SM3::Sqrt3_subdivision(mesh, np); });
}

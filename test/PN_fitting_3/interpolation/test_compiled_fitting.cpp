// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// What the library PN_subdivision_3_fitting has the code of gives the same bits as the headers.

#include "Mesh_cases.h"

#include <CGAL/PN_fitting_3/interpolate_limit_points.h>
#include <CGAL/PN_subdivision_3/schemes/Any_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;

namespace {

using Kernel = CGAL::Simple_cartesian<double>;

// another type, which the library does not have
struct Of_headers_alone : PN::CatmullClark_scheme
{};

// points and normals that interpolate a mesh in three ways
template <class Scheme>
std::vector<mesh_cases::Triple> interpolated(const mesh_cases::Soup& soup, const Scheme& scheme)
{
  using Mode = PN::Limit_interpolation::Mode;
  using Normals = PN::Limit_interpolation::Normals;
  std::vector<mesh_cases::Triple> all;
  const auto interpolate = [&](Mode mode, Normals which, bool is_estimated) {
    CGAL::Surface_mesh<Kernel::Point_3> mesh;
    mesh_cases::build(soup, mesh);
    auto normals =
      mesh.add_property_map<CGAL::SM_Vertex_index, Kernel::Vector_3>("v:n", {0, 0, 0}).first;
    const auto np = PN::parameters::interpolation_mode(mode).interpolation_normals(which);
    if (is_estimated)
      PN::interpolate_limit_points(mesh, scheme, np);
    else
      PN::interpolate_limit_points(mesh, scheme, np.vertex_normal_map(normals));
    for (const auto& x : mesh_cases::values(mesh, mesh.points())) all.push_back(x);
    for (const auto& x : mesh_cases::values(mesh, normals)) all.push_back(x);
  };
  interpolate(Mode::strict, Normals::given, true);
  interpolate(Mode::slide, Normals::natural, false);
  interpolate(Mode::strict, Normals::given, false);
  return all;
}

TEST(Compiled_fitting, IsThatOfTheHeaders)
{
  const auto quads = interpolated(mesh_cases::cube(), PN::CatmullClark_scheme());
  EXPECT_EQ(quads, interpolated(mesh_cases::cube(), Of_headers_alone()));
  EXPECT_EQ(quads, interpolated(mesh_cases::cube(), PN::Any_scheme<>(PN::CatmullClark_scheme())));
  EXPECT_EQ(interpolated(mesh_cases::tetrahedron(), PN::Loop_scheme()),
            interpolated(mesh_cases::tetrahedron(), PN::Any_scheme<>(PN::Loop_scheme())));
}

// linear ones, of which the library has that of an Any_scheme
TEST(Compiled_fitting, MeetsPointsOnCreases)
{
  const auto interpolated = [](const auto& scheme, bool is_sharp) {
    CGAL::Surface_mesh<Kernel::Point_3> mesh;
    mesh_cases::build(mesh_cases::cube(), mesh);
    auto sharp = mesh.add_property_map<CGAL::SM_Edge_index, bool>("e:sharp", false).first;
    for (const auto h : halfedges_around_face(halfedge(*faces(mesh).begin(), mesh), mesh))
      sharp[edge(h, mesh)] = is_sharp;
    const auto report = PN::interpolate_limit_points(
      mesh, scheme,
      PN::parameters::interpolation_mode(PN::Limit_interpolation::Mode::strict)
        .edge_is_constrained_map(sharp));
    EXPECT_GT(report.steps, 0u);
    EXPECT_LE(report.residual, report.tolerance);
    return mesh_cases::values(mesh, mesh.points());
  };
  const PN::CatmullClark_scheme scheme;
  for (const bool is_sharp : {false, true})
    EXPECT_EQ(interpolated(PN::linear(scheme), is_sharp),
              interpolated(PN::linear(PN::Any_scheme<>(scheme)), is_sharp));
}

} // namespace

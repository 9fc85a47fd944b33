// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Recognized parts refined: planes, cylinders and spheres are kept, cones and tori are nearer than by the linear scheme.

#include "Part_marks.h"
#include "Random_parts.h"
#include "Trap_parts.h"

#include <CGAL/PN_subdivision_3.h>

#include <gtest/gtest.h>

using namespace synthetic_parts;
namespace PN = CGAL::PN_subdivision_3;

namespace {

// largest distance of refined vertices from their true surfaces, by kind, over the diagonal
using Deviations = std::array<double, 5>;

template <class Scheme>
Deviations refined(const Part& part, const Scheme& scheme)
{
  Mesh mesh = mesh_of<Mesh>(part);
  const auto patches = mesh.add_property_map<Mesh::Face_index, int>("f:p").first;
  const auto truth = mesh.add_property_map<Mesh::Face_index, int>("f:truth").first;
  const auto sharp = mesh.add_property_map<Mesh::Edge_index, bool>("e:s", false).first;
  const auto normals = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Vector_3>("h:n").first;
  const auto surfaces = PN::recognize_surfaces(mesh, patches);
  PN::surface_creases(mesh, patches, surfaces, sharp, CGAL::parameters::vertex_normal_map(normals));
  for (const auto f : mesh.faces()) truth[f] = static_cast<int>(part.surface_of_face[f]);
  PN::subdivide(mesh, scheme,
                PN::parameters::attributes(PN::parameters::face_attribute(truth))
                  .number_of_iterations(2)
                  .edge_is_constrained_map(sharp)
                  .vertex_normal_map(normals));
  EXPECT_EQ(num_faces(mesh), 16 * part.faces.size());
  Deviations largest{};
  for (const auto f : mesh.faces())
    for (const auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh)) {
      const auto& p = mesh.point(v);
      const True_surface& s = part.surfaces[static_cast<std::size_t>(truth[f])];
      double& d = largest[static_cast<std::size_t>(s.kind)];
      d = (std::max)(d, std::abs(signed_distance(s, {p.x(), p.y(), p.z()})));
    }
  for (double& d : largest) d /= diagonal(part.points);
  return largest;
}

void expect_kept(const Part& part)
{
  const double bar = 20 * rounding(part) / diagonal(part.points) + 1e-9;
  const Deviations pn = refined(part, PN::Loop_scheme());
  for (Kind k : {Kind::plane, Kind::cylinder, Kind::sphere})
    EXPECT_LE(pn[static_cast<std::size_t>(k)], bar) << part.name << ", " << name_of(k);
}

Part in_file(Part part, File file)
{
  Random random(51);
  place(part, random_pose(random, 0.5, 2));
  write_as(part, file);
  return part;
}

} // namespace

TEST(Recognized_refinement, planes_cylinders_and_spheres_are_kept)
{
  Random random(52);
  const std::vector<Part> parts{bolt(8, 24),
                                rounded_box({3, 2, 1.5}, 0.3, steps(4), steps(4), random),
                                shaft(24, 6), zone_of_a_sphere(16, true), plate_with_hole(24)};
  for (const Part& part : parts)
    for (File file : {File::exact, File::single, File::six_digits})
      expect_kept(in_file(part, file));
}

TEST(Recognized_refinement, cones_and_tori_are_nearer_than_linear)
{
  for (const Part& part : {shaft(24, 6), rounded_stub(24, 6), bolt(6, 24)}) {
    const Deviations pn = refined(part, PN::Loop_scheme());
    const Deviations linear = refined(part, PN::linear(PN::Loop_scheme()));
    for (Kind k : {Kind::cone, Kind::torus}) {
      const auto i = static_cast<std::size_t>(k);
      if (part.count(k) == 0) continue;
      EXPECT_GT(linear[i], 0);
      EXPECT_LT(pn[i], 0.1 * linear[i]) << part.name << ", " << name_of(k);
    }
  }
}

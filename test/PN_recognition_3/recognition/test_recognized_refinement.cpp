// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Recognized parts refined: planes, cylinders and spheres are kept, cones and tori are nearer than by the linear scheme. What is
// not recognized is refined as the linear scheme does it.

#include "Part_marks.h"
#include "Random_parts.h"
#include "Trap_parts.h"

#include <CGAL/PN_subdivision_3/parameters/parameters.h>
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
#include <CGAL/PN_subdivision_3/subdivide.h>

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

// three vertices are moved off their surfaces: facets that nothing recognizes beside planes and rounds
Part dented(std::uint32_t seed)
{
  Part part = Random_part(seed).part();
  Random random(seed * 31 + 7);
  const double most = 0.004 * diagonal(part.points);
  for (int i = 0; i < 3; ++i) {
    Vec& p = part.points[static_cast<std::size_t>(
      random.integer(0, static_cast<int>(part.points.size()) - 1))];
    p = p + Vec{random(-most, most), random(-most, most), random(-most, most)};
  }
  return part;
}

std::vector<Part> small_dented_parts()
{
  std::vector<Part> parts;
  for (std::uint32_t seed = 1000; parts.size() < 8; ++seed)
    if (Part part = dented(seed); part.faces.size() < 150) parts.push_back(part);
  return parts;
}

// with all that surface_creases() says
struct Recognized_mesh
{
  explicit Recognized_mesh(const Part& part)
    : mesh(mesh_of<Mesh>(part))
  {
    const auto patch = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:p").first;
    const auto surfaces = PN::recognize_surfaces(mesh, patch);
    auto [sharp, corner, normal, roundness] = maps();
    creases = PN::surface_creases(mesh, patch, surfaces, sharp,
                                  PN::parameters::vertex_roundness_map(roundness)
                                    .vertex_is_constrained_map(corner)
                                    .vertex_normal_map(normal));
    const auto unknown = mesh.add_property_map<Mesh::Face_index, bool>("f:unknown").first;
    for (const auto f : mesh.faces()) {
      unknown[f] = surfaces[patch[f]].kind == Recognized_surface::Kind::unknown;
      unknown_faces += unknown[f];
    }
  }

  template <class Scheme>
  Mesh refined(const Scheme& scheme, unsigned rounds) const
  {
    Recognized_mesh copy(*this);
    auto [sharp, corner, normal, roundness] = copy.maps();
    const auto unknown = copy.mesh.add_property_map<Mesh::Face_index, bool>("f:unknown").first;
    PN::subdivide(copy.mesh, scheme,
                  PN::parameters::attributes(PN::parameters::face_attribute(unknown))
                    .number_of_iterations(rounds)
                    .edge_is_constrained_map(sharp)
                    .vertex_is_constrained_map(corner)
                    .vertex_roundness_map(roundness)
                    .vertex_normal_map(normal));
    return copy.mesh;
  }

  std::tuple<Mesh::Property_map<Mesh::Edge_index, bool>,
             Mesh::Property_map<Mesh::Vertex_index, bool>,
             Mesh::Property_map<Mesh::Halfedge_index, Kernel::Vector_3>,
             Mesh::Property_map<Mesh::Vertex_index, double>>
  maps()
  {
    return {mesh.add_property_map<Mesh::Edge_index, bool>("e:s", false).first,
            mesh.add_property_map<Mesh::Vertex_index, bool>("v:c", false).first,
            mesh.add_property_map<Mesh::Halfedge_index, Kernel::Vector_3>("h:n").first,
            mesh.add_property_map<Mesh::Vertex_index, double>("v:w", 1).first};
  }

  Mesh mesh;
  std::size_t unknown_faces = 0, creases = 0;
};

// whether the rows of all that is refined here know nothing of recognized faces and creases beside them
bool is_inside_unknown(Mesh& mesh, Mesh::Vertex_index v)
{
  const auto unknown = mesh.add_property_map<Mesh::Face_index, bool>("f:unknown").first;
  const auto sharp = mesh.add_property_map<Mesh::Edge_index, bool>("e:s", false).first;
  bool is_unknown = true, is_sharp = false;
  for (const auto h : CGAL::halfedges_around_target(v, mesh)) {
    if (!mesh.is_border(h)) is_unknown = is_unknown && unknown[mesh.face(h)];
    is_sharp = is_sharp || sharp[mesh.edge(h)];
  }
  return is_unknown && !is_sharp;
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

// One round, for later ones read creases beside recognized faces.
TEST(Recognized_refinement, what_is_unknown_is_refined_as_linear)
{
  std::size_t inside = 0;
  for (const Part& dented : small_dented_parts()) {
    const Recognized_mesh part(dented);
    Mesh pn = part.refined(PN::CatmullClark_scheme(), 1);
    const Mesh linear = part.refined(PN::linear(PN::CatmullClark_scheme()), 1);
    for (const auto v : pn.vertices())
      if (is_inside_unknown(pn, v)) {
        ++inside;
        EXPECT_EQ(pn.point(v), linear.point(v)) << dented.name << ", " << v;
      }
  }
  EXPECT_GE(inside, 100u);
}

// With creases, too, that the angles of unknown faces make.
TEST(Recognized_refinement, what_is_unknown_altogether_is_linear)
{
  Part part = geodesic_ball(2);
  Random random(53);
  for (Vec& x : part.points) {
    x = {1.5 * x[0], x[1], x[2]};
    for (double& c : x) c += random(-.07, .07);
  }
  const Recognized_mesh mesh(part);
  EXPECT_EQ(mesh.unknown_faces, mesh.mesh.number_of_faces());
  EXPECT_GE(mesh.creases, 4u);
  const auto scheme = PN::Loop_scheme();
  const Mesh pn = mesh.refined(scheme, 2), linear = mesh.refined(PN::linear(scheme), 2);
  for (const auto v : pn.vertices())
    EXPECT_LE(CGAL::squared_distance(pn.point(v), linear.point(v)), 1e-30) << v;
}

// What is refined depends on the numbers of vertices and faces by rounding only, and not where nothing is known.
TEST(Recognized_refinement, does_not_depend_on_numbers)
{
  Random random(54);
  for (const Part& part : small_dented_parts()) {
    Part other = part;
    renumber(other, random);
    std::vector<Kernel::Point_3> points[2];
    for (int i = 0; i < 2; ++i) {
      const Mesh mesh =
        Recognized_mesh(i == 0 ? part : other).refined(PN::CatmullClark_scheme(), 1);
      for (const auto v : mesh.vertices()) points[i].push_back(mesh.point(v));
    }
    ASSERT_EQ(points[0].size(), points[1].size());
    const double tolerance = 1e-7 * diagonal(part.points);
    for (const auto& p : points[0]) {
      double nearest = std::numeric_limits<double>::infinity();
      for (const auto& q : points[1])
        nearest = (std::min)(nearest, CGAL::to_double(CGAL::squared_distance(p, q)));
      EXPECT_LE(std::sqrt(nearest), tolerance) << part.name;
    }
  }
}

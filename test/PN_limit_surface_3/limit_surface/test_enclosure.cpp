// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
// Boxes of limit surfaces: against points of them, and what is not proven.

#include "Messages.h"
#include "Named_shapes.h"
#include "Scheme_runs.h"
#include "Surface_checks.h"

#include <CGAL/PN_limit_surface_3/Limit_surface.h>
#include <CGAL/PN_subdivision_3/schemes/Butterfly_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Tuned_CatmullClark_scheme.h>

namespace {

namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;
using test_meshes::Cells;
using test_meshes::Control_mesh;
using Face = Surface_mesh::Face_index;
using Vertex = Surface_mesh::Vertex_index;

// on an ellipsoid, with its normals
Control_mesh on_ellipsoid(Control_mesh mesh)
{
  mesh.normals.clear();
  for (auto& p : mesh.points) {
    const auto n = test_meshes::unit(p);
    p = {n[0], 1.5 * n[1], 0.7 * n[2]};
    mesh.normals.push_back(test_meshes::unit({n[0], n[1] / 1.5, n[2] / 0.7}));
  }
  return mesh;
}

double excess(const CGAL::Bbox_3& box, const Kernel::Point_3& p)
{
  double most = -1e9;
  for (int c = 0; c < 3; ++c) most = (std::max)({most, box.min(c) - p[c], p[c] - box.max(c)});
  return most;
}

template <class Surface>
std::vector<Kernel::Point_3> samples(const Surface& surface, Face f)
{
  std::vector<Kernel::Point_3> all;
  for (const auto& s : surface.evaluate(surface_checks::grid_places(surface, f, 4)))
    all.push_back(s.point);
  return all;
}

// Boxes contain the surface, and are not much larger.
template <class Scheme>
void expect_boxes(Control_mesh shape, const Scheme& scheme, bool is_proven, double looseness)
{
  SCOPED_TRACE(shape.name);
  Surface_mesh mesh = to_surface_mesh(shape);
  const PN::Limit_surface surface(
    mesh, scheme, PN::parameters::tolerance(5e-4).vertex_normal_map(normal_map(mesh)));
  CGAL::Bbox_3 all;
  for (Face f : mesh.faces()) {
    const auto box = is_proven ? surface.proven_bbox(f, 2) : surface.bbox(f, 2);
    CGAL::Bbox_3 of_samples;
    for (const auto& p : samples(surface, f)) {
      EXPECT_LE(excess(box, p), 1e-9);
      of_samples += p.bbox();
    }
    for (int c = 0; c < 3; ++c) {
      EXPECT_LE(of_samples.min(c) - box.min(c), looseness);
      EXPECT_LE(box.max(c) - of_samples.max(c), looseness);
    }
    all += of_samples;
  }
  const auto box = is_proven ? surface.proven_bbox() : surface.bbox();
  for (int c = 0; c < 3; ++c) {
    EXPECT_LE(box.min(c), all.min(c));
    EXPECT_GE(box.max(c), all.max(c));
  }
}

TEST(Enclosure, Proven)
{
  expect_boxes(on_ellipsoid(named_shapes::cube()), PN::CatmullClark_scheme(), true, 0.5);
  expect_boxes(on_ellipsoid(named_shapes::prism(5)), PN::CatmullClark_scheme(), true, 0.5);
  expect_boxes(on_ellipsoid(test_meshes::bipyramid(5)), PN::Loop_scheme(), true, 0.8);
}
TEST(Enclosure, Estimated)
{
  expect_boxes(on_ellipsoid(named_shapes::cube()), PN::CatmullClark_scheme::Tuned(), false, 0.5);
  expect_boxes(on_ellipsoid(test_meshes::bipyramid(5)), PN::Butterfly_scheme(), false, 0.8);
  Control_mesh grid = test_meshes::grid(3, 2, false, false, Cells::quads);
  test_meshes::set_uneven_normals(grid, 4);
  expect_boxes(grid, PN::CatmullClark_scheme(), false, 2.5);
}
TEST(Enclosure, OfLinearSchemesItIsTheHull)
{
  expect_boxes(on_ellipsoid(named_shapes::cube()), PN::linear(PN::CatmullClark_scheme()), true,
               0.25);
}

// The limit of a sphere of radius 1 is 1 from its center, that of the linear scheme nearer.
TEST(Enclosure, TheDistanceToTheLinearLimitIsProvenAndNotMuchMore)
{
  Control_mesh shape =
    named_shapes::on_unit_sphere(test_meshes::with_centers(named_shapes::tetrahedron(), 1));
  for (int round = 0; round < 3; ++round) {
    Surface_mesh mesh = to_surface_mesh(shape);
    const PN::Limit_surface linear(mesh, PN::linear(PN::Loop_scheme())),
      surface(mesh, PN::Loop_scheme(), params::vertex_normal_map(normal_map(mesh)));
    double distance = 0, bound = 0;
    for (Face f : mesh.faces()) {
      double of_face = 0;
      for (const auto& p : samples(linear, f))
        of_face = (std::max)(of_face, 1 - std::sqrt((p - CGAL::ORIGIN).squared_length()));
      if (round == 2) {
        bound = (std::max)(bound, surface.proven_distance_to_linear(f, 0));
        EXPECT_LE(of_face, surface.proven_distance_to_linear(f, 0));
      }
      distance = (std::max)(distance, of_face);
    }
    if (round == 2) {
      EXPECT_LE(bound, 4 * distance);
    }
    // triangles a fourth as large, on the sphere
    Surface_mesh finer = mesh;
    PN::subdivide(finer, PN::Loop_scheme(), params::vertex_normal_map(normal_map(finer)));
    shape.points.clear();
    shape.faces.clear();
    for (Vertex v : finer.vertices()) {
      const auto& p = finer.point(v);
      shape.points.push_back({p.x(), p.y(), p.z()});
    }
    for (Face f : finer.faces()) {
      reference::Face face;
      for (Vertex v : CGAL::vertices_around_face(finer.halfedge(f), finer))
        face.push_back(int(v.idx()));
      shape.faces.push_back(face);
    }
    shape = named_shapes::on_unit_sphere(shape);
  }
}

// \name What is not proven

TEST(Enclosure, WhatIsNotCoveredIsNamed)
{
  Surface_mesh cube = to_surface_mesh(on_ellipsoid(named_shapes::cube()));
  const auto np = params::vertex_normal_map(normal_map(cube));
  const PN::Limit_surface modified(cube, PN::CatmullClark_scheme::Tuned(), np);
  messages::expect_refused([&] { modified.proven_bbox(Face(0)); }, {"modified"});
  auto sharp = cube.add_property_map<Surface_mesh::Edge_index, bool>("e:sharp", false).first;
  const auto h = cube.halfedge(Face(3));
  sharp[cube.edge(h)] = true;
  const PN::Limit_surface creased(cube, PN::CatmullClark_scheme(),
                                  np.edge_is_constrained_map(sharp));
  messages::expect_refused([&] { creased.proven_bbox(Face(3)); }, {"sharp"});
  messages::expect_refused([&] { creased.proven_bbox(); }, {"sharp"});

  Surface_mesh grid = to_surface_mesh([] {
    Control_mesh mesh = test_meshes::grid(4, 4, false, false, Cells::quads);
    mesh.normals.assign(mesh.points.size(), {0, 0, 1});
    return mesh;
  }());
  const PN::Limit_surface open(grid, PN::CatmullClark_scheme(),
                               params::vertex_normal_map(normal_map(grid)));
  unsigned refused = 0;
  for (Face f : grid.faces()) {
    bool at_border = false;
    for (Vertex v : CGAL::vertices_around_face(grid.halfedge(f), grid))
      at_border = at_border || grid.is_border(v);
    if (at_border) {
      messages::expect_refused([&] { open.proven_bbox(f); }, {"on the border"});
      ++refused;
    } else
      EXPECT_NO_THROW(open.proven_bbox(f));
  }
  EXPECT_GT(refused, 0u);

  Surface_mesh poles = to_surface_mesh(on_ellipsoid(test_meshes::bipyramid(13)));
  const PN::Limit_surface loop(poles, PN::Loop_scheme(),
                               params::vertex_normal_map(normal_map(poles)));
  messages::expect_refused([&] { loop.proven_bbox(); }, {"valence is 13"});
}

// Without a bound it says so.
TEST(Enclosure, NormalsThatDifferTooMuch)
{
  Surface_mesh mesh = to_surface_mesh(on_ellipsoid(named_shapes::cube()));
  const PN::Limit_surface surface(mesh, PN::CatmullClark_scheme(),
                                  params::vertex_normal_map(normal_map(mesh)));
  EXPECT_THROW(surface.proven_distance_to_linear(Face(0), 0), std::domain_error);
  EXPECT_NO_THROW(surface.proven_distance_to_linear(Face(0), 3));
  EXPECT_GT(surface.proven_distance_to_linear(Face(0), 3),
            surface.proven_distance_to_linear(Face(0), 4));
}

} // namespace

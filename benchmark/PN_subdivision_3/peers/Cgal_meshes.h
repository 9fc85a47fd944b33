// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_BENCHMARK_PEERS_CGAL_MESHES_H
#define CGAL_PN_SUBDIVISION_3_BENCHMARK_PEERS_CGAL_MESHES_H

#include "Job.h"

#include <CGAL/HalfedgeDS_vertex_base.h>
#include <CGAL/PN_subdivision_3/estimate_control_normals.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#ifdef CGAL_LINKED_WITH_TBB
#  include <tbb/global_control.h>
#endif

#include <utility>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Normals = Surface_mesh::Property_map<Surface_mesh::Vertex_index, Kernel::Vector_3>;

inline Surface_mesh surface_mesh(const Control& control)
{
  Surface_mesh mesh;
  for (const auto& p : control.points) mesh.add_vertex(Kernel::Point_3(p[0], p[1], p[2]));
  std::vector<Surface_mesh::Vertex_index> corners;
  for (const std::vector<int>& f : control.faces) {
    corners.clear();
    for (int v : f) corners.emplace_back(v);
    mesh.add_face(corners);
  }
  return mesh;
}

inline Normals add_normals(Surface_mesh& mesh)
{
  const Normals normals =
    mesh.add_property_map<Surface_mesh::Vertex_index, Kernel::Vector_3>("v:normal").first;
  CGAL::PN_subdivision_3::estimate_control_normals(mesh, normals);
  return normals;
}

// the same as a Polyhedron_3
template <class Polyhedron>
Polyhedron polyhedron(const Control& control)
{
  Polyhedron mesh;
  CGAL::copy_face_graph(surface_mesh(control), mesh);
  return mesh;
}

// calls f with as many threads as are allowed
template <class Function>
void with_threads([[maybe_unused]] unsigned threads, const Function& f)
{
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
#endif
  f();
}

#endif // CGAL_PN_SUBDIVISION_3_BENCHMARK_PEERS_CGAL_MESHES_H

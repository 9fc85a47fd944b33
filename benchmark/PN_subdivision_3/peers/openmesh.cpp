// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "Job.h"

#ifdef PN_BENCHMARK_WITH_OPENMESH
#  include <OpenMesh/Core/IO/MeshIO.hh> // OpenMesh wants it first
#  include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#  include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#  include <OpenMesh/Tools/Subdivider/Uniform/CatmullClarkT.hh>
#  include <OpenMesh/Tools/Subdivider/Uniform/LoopT.hh>
#  include <OpenMesh/Tools/Subdivider/Uniform/ModifiedButterFlyT.hh>
#  include <OpenMesh/Tools/Subdivider/Uniform/Sqrt3T.hh>

#  include <string>
#  include <vector>

namespace {

using Triangles = OpenMesh::TriMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>;
using Polygons = OpenMesh::PolyMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>;
namespace Uniform = OpenMesh::Subdivider::Uniform;

template <class Mesh>
Mesh mesh_of(const Control& control)
{
  Mesh mesh;
  for (const auto& p : control.points) mesh.add_vertex(typename Mesh::Point(p[0], p[1], p[2]));
  std::vector<typename Mesh::VertexHandle> corners;
  for (const std::vector<int>& f : control.faces) {
    corners.clear();
    for (int v : f) corners.emplace_back(v);
    mesh.add_face(corners);
  }
  return mesh;
}

template <class Subdivider, class Mesh>
void add(Jobs& jobs, const std::string& name)
{
  jobs["openmesh/mesh/" + name] = [](const Control& control, unsigned rounds, unsigned) {
    auto mesh = mesh_of<Mesh>(control);
    Subdivider subdivider;
    Result result = timed([&] {
      subdivider.attach(mesh);
      subdivider(rounds);
      subdivider.detach();
    });
    result.faces = mesh.n_faces();
    return result;
  };
}

} // namespace

void add_openmesh(Jobs& jobs)
{
  jobs.libraries.push_back("OpenMesh " + std::to_string(OM_GET_VER) + '.' +
                           std::to_string(OM_GET_MAJ));
  add<Uniform::CatmullClarkT<Polygons, double>, Polygons>(jobs, "catmull-clark");
  add<Uniform::LoopT<Triangles, double>, Triangles>(jobs, "loop");
  add<Uniform::Sqrt3T<Triangles, double>, Triangles>(jobs, "sqrt3");
  add<Uniform::ModifiedButterflyT<Triangles, double>, Triangles>(jobs, "butterfly");
}
#else
void add_openmesh(Jobs&)
{}
#endif

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Times tessellations beside uniform rounds that end on the limit surface, with surface normals: microseconds per vertex
// of the result, on one thread.
//
//   benchmark_tessellation [--benchmark_filter=...] [--benchmark_repetitions=N] [MESH [PERCENT [ROUNDS [DEGREES]]]]
//
// The tolerance is PERCENT of the diagonal; ROUNDS should make about as many vertices as the tessellation has. Edges that are
// sharper than DEGREES are creases.

#include <CGAL/PN_subdivision_3.h>
#include <CGAL/PN_subdivision_limit_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

namespace {

namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

struct Job
{
  Mesh control;
  double tolerance;
  unsigned rounds;

  Job(const std::string& file, double percent, unsigned number_of_rounds, double degrees)
    : rounds(number_of_rounds)
  {
    if (!CGAL::IO::read_polygon_mesh(file, control) || control.is_empty()) {
      std::cerr << "Invalid input: " << file << std::endl;
      std::exit(EXIT_FAILURE);
    }
    if (degrees < 180) PN::detect_creases(control, degrees, sharp_edges(control));
    CGAL::Bbox_3 box;
    for (const Kernel::Point_3& p : control.points()) box += p.bbox();
    tolerance = percent / 100 * std::hypot(box.x_span(), std::hypot(box.y_span(), box.z_span()));
  }

  static Mesh::Property_map<Mesh::Edge_index, bool> sharp_edges(Mesh& mesh)
  {
    return mesh.add_property_map<Mesh::Edge_index, bool>("e:sharp", false).first;
  }
};

Mesh::Property_map<Mesh::Vertex_index, Kernel::Vector_3> normals_of(Mesh& mesh)
{
  return mesh.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>("v:normal", CGAL::NULL_VECTOR)
    .first;
}

void report(benchmark::State& state, const Mesh& mesh)
{
  using benchmark::Counter;
  const double vertices = double(mesh.number_of_vertices());
  state.counters["vertices"] = vertices;
  state.counters["per_vertex"] =
    Counter(vertices, Counter::kIsIterationInvariantRate | Counter::kInvert);
}

void tessellate(benchmark::State& state, Job job)
{
  Mesh mesh;
  for ([[maybe_unused]] auto _ : state) {
    mesh = Mesh();
    const auto normals = normals_of(mesh);
    PN::tessellate(job.control, PN::CatmullClark_scheme(), job.tolerance, mesh,
                   params::edge_is_constrained_map(Job::sharp_edges(job.control)),
                   params::vertex_normal_map(normals));
  }
  report(state, mesh);
}

void uniform(benchmark::State& state, const Job& job)
{
  Mesh mesh;
  for ([[maybe_unused]] auto _ : state) {
    mesh = job.control;
    const auto normals = normals_of(mesh);
    PN::estimate_control_normals(mesh, normals);
    PN::subdivide_to_limit(mesh, PN::CatmullClark_scheme(),
                           PN::parameters::join(params::number_of_iterations(job.rounds)
                                                  .vertex_normal_map(normals)
                                                  .edge_is_constrained_map(Job::sharp_edges(mesh)),
                                                PN::parameters::surface_normals(true)));
  }
  report(state, mesh);
}

} // namespace

int main(int argc, char** argv)
{
  benchmark::Initialize(&argc, argv);
  const auto number = [&](int i, double otherwise) {
    return argc > i ? std::atof(argv[i]) : otherwise;
  };
  const Job job(argc > 1 ? argv[1] : "data/meshes/cube.off", number(2, 0.1), unsigned(number(3, 4)),
                number(4, 180));
  benchmark::RegisterBenchmark("uniform", uniform, job)->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark("tessellate", tessellate, job)->Unit(benchmark::kMillisecond);
  benchmark::RunSpecifiedBenchmarks();
  return EXIT_SUCCESS;
}

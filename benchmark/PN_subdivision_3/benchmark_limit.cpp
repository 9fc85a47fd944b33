// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Times limit points on one thread at level 3, where the tolerance asks for the error estimate at every vertex,
// beside one more round of subdivision, which makes four times as many vertices.
//
//   benchmark_limit [--benchmark_filter=...] [--benchmark_repetitions=N]

#include "Control_meshes.h"

#include <CGAL/PN_limit_surface_3/limit_points.h>
#include <CGAL/PN_subdivision_3.h>

#include <benchmark/benchmark.h>

namespace {

namespace PN = CGAL::PN_subdivision_3;
using Normal_map = Mesh::Property_map<Mesh::Vertex_index, Kernel::Vector_3>;

// at level 3, with some 100 000 vertices
template <class Scheme>
Mesh level_3(Mesh mesh, const Scheme& scheme)
{
  const Normal_map normals =
    mesh.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>("v:normal", CGAL::NULL_VECTOR)
      .first;
  PN::estimate_control_normals(mesh, normals);
  PN::subdivide(mesh, scheme, CGAL::parameters::number_of_iterations(3).vertex_normal_map(normals));
  return mesh;
}

Normal_map normals_of(Mesh& mesh)
{
  return mesh.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>("v:normal").first;
}

template <class Scheme>
void one_round(benchmark::State& state, const Mesh& control, const Scheme& scheme)
{
  const Mesh start = level_3(control, scheme);
  for ([[maybe_unused]] auto _ : state) {
    state.PauseTiming();
    Mesh mesh = start;
    state.ResumeTiming();
    PN::subdivide(mesh, scheme, CGAL::parameters::vertex_normal_map(normals_of(mesh)));
  }
  state.counters["vertices"] = double(start.number_of_vertices());
}

template <class Scheme>
void limits(benchmark::State& state, const Mesh& control, const Scheme& scheme, bool with_normals)
{
  Mesh mesh = level_3(control, scheme);
  const auto map =
    mesh.add_property_map<Mesh::Vertex_index, PN::Limit_point<Kernel>>("v:limit").first;
  PN::Limit_report report;
  for ([[maybe_unused]] auto _ : state)
    report = PN::limit_points(mesh, scheme, map,
                              PN::parameters::surface_normals(with_normals)
                                .rounds_done(3)
                                .vertex_normal_map(normals_of(mesh)));
  if (!report.is_within_tolerance()) state.SkipWithError("the tolerance is missed");
  state.counters["vertices"] = double(mesh.number_of_vertices());
  state.counters["depth"] = report.depth;
}

// of the kinds of meshes and schemes that `function` is called with
template <class Function>
void with_quads(const Function& function)
{
  function(Control_meshes::quads(40, 40), PN::CatmullClark_scheme::Tuned());
}
template <class Function>
void with_triangles(const Function& function)
{
  function(Control_meshes::triangles(40, 40), PN::Loop_scheme::Tuned());
}

void quads_round(benchmark::State& state)
{
  with_quads([&](const Mesh& m, const auto& s) { one_round(state, m, s); });
}
void quads_limit(benchmark::State& state, bool with_normals)
{
  with_quads([&](const Mesh& m, const auto& s) { limits(state, m, s, with_normals); });
}
void triangles_round(benchmark::State& state)
{
  with_triangles([&](const Mesh& m, const auto& s) { one_round(state, m, s); });
}
void triangles_limit(benchmark::State& state, bool with_normals)
{
  with_triangles([&](const Mesh& m, const auto& s) { limits(state, m, s, with_normals); });
}

BENCHMARK(quads_round)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(quads_limit, points, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(quads_limit, points_and_normals, true)->Unit(benchmark::kMillisecond);
BENCHMARK(triangles_round)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(triangles_limit, points, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(triangles_limit, points_and_normals, true)->Unit(benchmark::kMillisecond);

} // namespace

BENCHMARK_MAIN();

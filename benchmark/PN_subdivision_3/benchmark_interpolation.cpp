// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Times interpolation of some ten thousand points on one thread, at a tolerance of 1e-6 of the box:
// points alone with estimated normals, quads and triangles with irregular vertices.
//
//   benchmark_interpolation [--benchmark_filter=...] [--benchmark_repetitions=N]

#include "Control_meshes.h"

#include <CGAL/PN_fitting_3/interpolate_limit_points.h>
#include <CGAL/PN_subdivision_3.h>

#include <benchmark/benchmark.h>

namespace {

namespace PN = CGAL::PN_subdivision_3;
using Mode = PN::Limit_interpolation::Mode;

template <class Scheme>
void interpolate(benchmark::State& state, const Mesh& samples, const Scheme& scheme, Mode mode)
{
  Mesh data = samples;
  const auto normals =
    data.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>("v:normal", CGAL::NULL_VECTOR)
      .first;
  PN::estimate_control_normals(data, normals);
  PN::Limit_interpolation report;
  for ([[maybe_unused]] auto _ : state) {
    Mesh mesh = data;
    const auto map = mesh.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>("v:normal").first;
    report = PN::interpolate_limit_points(
      mesh, scheme,
      PN::parameters::interpolation_mode(mode).tolerance(1e-6).vertex_normal_map(map));
  }
  if (mode == Mode::strict && !report.is_within_tolerance())
    state.SkipWithError("the tolerance is missed");
  state.counters["points"] = double(data.number_of_vertices());
  state.counters["steps"] = report.steps;
  state.counters["depth"] = report.depth;
}

void quads(benchmark::State& state, Mode mode)
{
  interpolate(state, Control_meshes::quads(100, 100), PN::CatmullClark_scheme::Tuned(), mode);
}
void triangles(benchmark::State& state, Mode mode)
{
  interpolate(state, Control_meshes::triangles(100, 100), PN::Loop_scheme::Tuned(), mode);
}

BENCHMARK_CAPTURE(quads, slide, Mode::slide)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(quads, limit_points, Mode::strict)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(triangles, slide, Mode::slide)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(triangles, limit_points, Mode::strict)->Unit(benchmark::kMillisecond);

} // namespace

BENCHMARK_MAIN();

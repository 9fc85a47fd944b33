// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Times the estimate of the curvatures of a refined mesh, beside the refinement that has made it, in the same
// process. Copying the control mesh is not timed.
//
//   benchmark_curvature [--benchmark_filter=...] [--benchmark_repetitions=N]

#include "Control_meshes.h"
#include "Ratio_reporter.h"

#include <CGAL/PN_limit_surface_3/estimate_curvature.h>
#include <CGAL/PN_subdivision_3.h>

#include <benchmark/benchmark.h>

#include <chrono>
#include <string>
#include <vector>

#ifdef CGAL_LINKED_WITH_TBB
#  include <tbb/global_control.h>
#endif

namespace {

namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;
using Curvature = PN::Vertex_curvature<Kernel>;

template <class Function>
double seconds_of(const Function& f)
{
  const auto begin = std::chrono::steady_clock::now();
  f();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

template <class Tag, class Scheme>
Mesh refined(const Mesh& control, const Scheme& scheme, double& seconds)
{
  Mesh mesh = control;
  const auto normals = Control_meshes::add_normals(mesh);
  seconds = seconds_of([&] {
    PN::subdivide<Tag>(mesh, scheme, params::number_of_iterations(4).vertex_normal_map(normals));
  });
  return mesh;
}

template <class Tag, class Scheme>
void refine(benchmark::State& state, const Mesh& control, const Scheme& scheme)
{
  for ([[maybe_unused]] auto _ : state) {
    double seconds = 0;
    const Mesh mesh = refined<Tag>(control, scheme, seconds);
    state.SetIterationTime(seconds);
    state.counters["vertices"] = double(mesh.number_of_vertices());
  }
}

template <class Tag, class Scheme>
void estimate(benchmark::State& state, const Mesh& control, const Scheme& scheme)
{
  double ignored = 0;
  const Mesh surface = refined<Tag>(control, scheme, ignored);
  for ([[maybe_unused]] auto _ : state) {
    Mesh mesh = surface;
    const auto curvatures = mesh.add_property_map<Mesh::Vertex_index, Curvature>("c").first;
    state.SetIterationTime(seconds_of([&] { PN::estimate_curvature<Tag>(mesh, curvatures); }));
  }
}

template <class Tag, class Scheme>
void add_jobs(std::vector<std::string>& names, const std::string& group, Mesh (*make)(int, int),
              int rings, int segments, const Scheme& scheme)
{
  const auto add = [&](const char* job, const auto& function) {
    names.push_back(group + '/' + job);
    benchmark::RegisterBenchmark(
      names.back().c_str(),
      [=](benchmark::State& state) { function(state, make(rings, segments), scheme); })
      ->UseManualTime()
      ->Unit(benchmark::kMillisecond);
  };
  add("refinement", &refine<Tag, Scheme>);
  add("curvature", &estimate<Tag, Scheme>);
}

template <class Tag>
void add_groups(std::vector<std::string>& names, const std::string& suffix)
{
  for (const int segments : {20, 60}) {
    const std::string size = segments == 20 ? "100k" : "1M";
    add_jobs<Tag>(names, "Catmull-Clark" + suffix + '/' + size, &Control_meshes::quads, segments,
                  segments, PN::CatmullClark_scheme());
    add_jobs<Tag>(names, "Loop" + suffix + '/' + size, &Control_meshes::triangles, segments,
                  segments, PN::Loop_scheme());
  }
}

} // namespace

int main(int argc, char** argv)
{
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 2);
#endif
  return run_and_print_ratios(argc, argv, 5, [] {
    std::vector<std::string> names;
    add_groups<CGAL::Sequential_tag>(names, "");
#ifdef CGAL_LINKED_WITH_TBB
    add_groups<CGAL::Parallel_tag>(names, "-2-threads");
#endif
    return names;
  });
}

// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Times whole jobs, mesh in and mesh out, beside CGAL's linear functions in the same process, and
// prints the ratios of the medians. The runs of all jobs are interleaved, so that a change of the
// machine's speed meets all alike. Copying the control mesh is outside of the timed part.
//
//   benchmark_subdivision [--benchmark_filter=...] [--benchmark_repetitions=N]

#include "Control_meshes.h"
#include "Ratio_reporter.h"

#include <CGAL/PN_subdivision_3.h>
#include <CGAL/subdivision_method_3.h>

#include <benchmark/benchmark.h>

#include <chrono>
#include <functional>
#include <string>
#include <vector>

#ifdef CGAL_LINKED_WITH_TBB
#  include <tbb/global_control.h>
#endif

namespace {

namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;

using Normal_map = Mesh::Property_map<Mesh::Vertex_index, Kernel::Vector_3>;
using Job = std::function<void(Mesh&, Normal_map, unsigned)>;

void time_job(benchmark::State& state, const Mesh& control, unsigned rounds, const Job& job)
{
  std::size_t faces = 0;
  for (auto _ : state) {
    Mesh mesh = control;
    const Normal_map normals = Control_meshes::add_normals(mesh);
    const auto begin = std::chrono::steady_clock::now();
    job(mesh, normals, rounds);
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
    state.SetIterationTime(time.count());
    faces = mesh.number_of_faces();
  }
  state.counters["faces"] = static_cast<double>(faces);
  state.counters["ns/face"] =
    benchmark::Counter(static_cast<double>(faces) * 1e-9,
                       benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

std::vector<std::string> names;

void add(const std::string& name, const Mesh& control, unsigned rounds, const Job& job)
{
  names.push_back(name);
  benchmark::RegisterBenchmark(
    name.c_str(),
    [control, rounds, job](benchmark::State& state) { time_job(state, control, rounds, job); })
    ->UseManualTime()
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);
}

// The linear function of CGAL first: the ratios of a group are to its first job. It gets a mesh
// without normals.
template <class Linear, class Scheme>
void add_group(const std::string& group, const Mesh& control, unsigned rounds, Linear cgal,
               const Scheme& scheme)
{
  add(group + "/CGAL-linear", control, rounds, [cgal](Mesh& m, Normal_map n, unsigned k) {
    m.remove_property_map(n);
    cgal(m, k);
  });
  add(group + "/PN", control, rounds, [scheme](Mesh& m, Normal_map n, unsigned k) {
    PN::subdivide(m, scheme, params::number_of_iterations(k).vertex_normal_map(n));
  });
  add(group + "/linear", control, rounds, [scheme](Mesh& m, Normal_map n, unsigned k) {
    m.remove_property_map(n);
    PN::subdivide(m, PN::linear(scheme), params::number_of_iterations(k));
  });
#ifdef CGAL_LINKED_WITH_TBB
  add(group + "/PN-2-threads", control, rounds, [scheme](Mesh& m, Normal_map n, unsigned k) {
    const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, 2);
    PN::subdivide<CGAL::Parallel_tag>(m, scheme,
                                      params::number_of_iterations(k).vertex_normal_map(n));
  });
#endif
}

void add_all()
{
  const auto catmull_clark = [](Mesh& m, unsigned k) {
    CGAL::Subdivision_method_3::CatmullClark_subdivision(m, params::number_of_iterations(k));
  };
  const auto loop = [](Mesh& m, unsigned k) {
    CGAL::Subdivision_method_3::Loop_subdivision(m, params::number_of_iterations(k));
  };
  add_group("CatmullClark/100k", Control_meshes::quads(24, 18), 4, catmull_clark,
            PN::CatmullClark_scheme());
  add_group("CatmullClark/1M", Control_meshes::quads(72, 56), 4, catmull_clark,
            PN::CatmullClark_scheme());
  add_group("CatmullClark/1M-one-round", Control_meshes::quads(500, 500), 1, catmull_clark,
            PN::CatmullClark_scheme());
  add_group("Loop/100k", Control_meshes::triangles(16, 14), 4, loop, PN::Loop_scheme());
  add_group("Loop/1M", Control_meshes::triangles(50, 40), 4, loop, PN::Loop_scheme());
  add_group("Loop/1M-one-round", Control_meshes::triangles(360, 350), 1, loop, PN::Loop_scheme());
}

} // namespace

int main(int argc, char** argv)
{
  std::vector<std::string> defaults = {argv[0], "--benchmark_repetitions=9",
                                       "--benchmark_enable_random_interleaving=true",
                                       "--benchmark_report_aggregates_only=true"};
  std::vector<char*> arguments;
  for (std::string& s : defaults) arguments.push_back(s.data());
  arguments.insert(arguments.end(), argv + 1, argv + argc);
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return EXIT_FAILURE;
  add_all();
  Ratio_reporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  reporter.print_ratios(names);
  return EXIT_SUCCESS;
}

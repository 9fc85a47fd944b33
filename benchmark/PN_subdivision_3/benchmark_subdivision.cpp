// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Times whole jobs, mesh in and mesh out, beside the linear functions of CGAL (Butterfly: of
// OpenMesh) in the same process, and prints the ratios of the medians. The runs of a group's jobs are
// interleaved, see Ratio_reporter.h. Copying the control mesh is not timed. The linear functions get a
// mesh without normals.
//
//   benchmark_subdivision [--benchmark_filter=...] [--benchmark_repetitions=N]

#ifdef PN_BENCHMARK_WITH_OPENMESH
#  include <OpenMesh/Core/IO/MeshIO.hh> // OpenMesh wants it first
#  include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#  include <OpenMesh/Tools/Subdivider/Uniform/ModifiedButterFlyT.hh>

#  include <CGAL/boost/graph/copy_face_graph.h>
#  include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>
#endif

#include "Control_meshes.h"
#include "Ratio_reporter.h"

#include <CGAL/PN_cgal_masks_3/Subdivision_method_3.h>
#include <CGAL/PN_subdivision_3.h>
#include <CGAL/PN_subdivision_3/Surface_refiner.h>
#include <CGAL/subdivision_method_3.h>

#include <benchmark/benchmark.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#ifdef CGAL_LINKED_WITH_TBB
#  include <tbb/global_control.h>
#endif

namespace {

namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;

// A control mesh, made when the first job of its group runs. Only one is held: those of other groups
// would scatter the memory that the jobs get.
struct Control
{
  const Mesh& mesh() const
  {
    static Mesh mesh;
    static Control held{nullptr, 0, 0};
    if (make != held.make || rings != held.rings || segments != held.segments) {
      mesh = Mesh();
      mesh = make(rings, segments);
      held = *this;
    }
    return mesh;
  }

  Mesh (*make)(int rings, int segments);
  int rings, segments;
};

Control quads(int rings, int segments)
{
  return {&Control_meshes::quads, rings, segments};
}

Control triangles(int rings, int segments)
{
  return {&Control_meshes::triangles, rings, segments};
}

struct Result
{
  double seconds;
  std::size_t faces;
};

// copies the control mesh, which is not timed, and subdivides it
using Job = std::function<Result(const Mesh& control, unsigned rounds)>;

template <class Function>
double seconds_of(const Function& f)
{
  const auto begin = std::chrono::steady_clock::now();
  f();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

// a linear function: on a mesh without normals
template <class Subdivide>
Job linear_job(const Subdivide& subdivide)
{
  return [subdivide](const Mesh& control, unsigned rounds) -> Result {
    Mesh mesh = control;
    const double seconds = seconds_of([&] { subdivide(mesh, rounds); });
    return {seconds, mesh.number_of_faces()};
  };
}

// point-normal subdivision with given normals
template <class Concurrency_tag, class Scheme>
Job pn_job(const Scheme& scheme)
{
  return [scheme](const Mesh& control, unsigned rounds) -> Result {
    Mesh mesh = control;
    const auto normals = Control_meshes::add_normals(mesh);
    const double seconds = seconds_of([&] {
      PN::subdivide<Concurrency_tag>(
        mesh, scheme, params::number_of_iterations(rounds).vertex_normal_map(normals));
    });
    return {seconds, mesh.number_of_faces()};
  };
}

#ifdef PN_BENCHMARK_WITH_OPENMESH
using Openmesh = OpenMesh::TriMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>;

Result openmesh_butterfly(const Mesh& control, unsigned rounds)
{
  Openmesh mesh;
  CGAL::copy_face_graph(control, mesh);
  OpenMesh::Subdivider::Uniform::ModifiedButterflyT<Openmesh, double> butterfly;
  const double seconds = seconds_of([&] {
    butterfly.attach(mesh);
    butterfly(rounds);
    butterfly.detach();
  });
  return {seconds, mesh.n_faces()};
}
#endif

std::vector<std::string> names;

void add(const std::string& name, const Control& control, unsigned rounds, const Job& job)
{
  names.push_back(name);
  const auto run = [control, rounds, job](benchmark::State& state) {
    Result result{};
    for (auto _ : state) {
      result = job(control.mesh(), rounds);
      state.SetIterationTime(result.seconds);
    }
    state.counters["faces"] = static_cast<double>(result.faces);
  };
  benchmark::RegisterBenchmark(name.c_str(), run)
    ->UseManualTime()
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);
}

// The peer comes first: the ratios of a group are to its first job.
template <class Scheme>
void add_group(const std::string& group, const Control& control, unsigned rounds, const Job& peer,
               const Scheme& scheme)
{
  add(group + "/peer-linear", control, rounds, peer);
  add(group + "/PN", control, rounds, pn_job<CGAL::Sequential_tag>(scheme));
  add(group + "/linear", control, rounds, linear_job([scheme](Mesh& mesh, unsigned k) {
        PN::subdivide(mesh, PN::linear(scheme), params::number_of_iterations(k));
      }));
#ifdef CGAL_LINKED_WITH_TBB
  add(group + "/PN-2-threads", control, rounds, [scheme](const Mesh& mesh, unsigned k) {
    const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, 2);
    return pn_job<CGAL::Parallel_tag>(scheme)(mesh, k);
  });
#endif
}

// Two point-normal schemes side by side, with one and with two threads.
template <class Scheme, class Modified_scheme>
void add_modified(const std::string& name, const std::string& size, const Control& control,
                  unsigned rounds, const Scheme& scheme, const Modified_scheme& modified)
{
  const auto add_pair = [&](const std::string& group, const auto& job_of) {
    add(group + "/PN-unmodified", control, rounds, job_of(scheme));
    add(group + "/PN", control, rounds, job_of(modified));
  };
  add_pair(name + "/" + size, [](const auto& s) { return pn_job<CGAL::Sequential_tag>(s); });
#ifdef CGAL_LINKED_WITH_TBB
  add_pair(name + "/" + size + "-2-threads", [](const auto& s) {
    return [s](const Mesh& mesh, unsigned k) {
      const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, 2);
      return pn_job<CGAL::Parallel_tag>(s)(mesh, k);
    };
  });
#endif
}

void add_modified_schemes()
{
  // the triangles have extraordinary vertices that are separated after a round or two
  const PN::CatmullClark_scheme catmull_clark;
  const PN::CatmullClark_scheme::Tuned modified_catmull_clark;
  const auto add_catmull_clark = [&](const char* size, const Control& control, unsigned rounds) {
    add_modified("modified_CatmullClark", size, control, rounds, catmull_clark,
                 modified_catmull_clark);
  };
  add_catmull_clark("100k", triangles(20, 14), 4);
  add_catmull_clark("1M", triangles(54, 50), 4);
  add_catmull_clark("1M-one-round", quads(500, 500), 1);

  const PN::Loop_scheme loop;
  const PN::Loop_scheme::Tuned modified_loop;
  add_modified("modified_Loop", "100k", triangles(16, 14), 4, loop, modified_loop);
  add_modified("modified_Loop", "1M", triangles(50, 40), 4, loop, modified_loop);
  add_modified("modified_Loop", "1M-one-round", triangles(360, 350), 1, loop, modified_loop);
}

using Creases = Mesh::Property_map<Mesh::Edge_index, bool>;

// makes every tenth ring of edges, which is 5 % of the edges, a crease
Creases add_creases(Mesh& mesh, int segments)
{
  Creases sharp = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_sharp", false).first;
  for (const Mesh::Edge_index e : mesh.edges()) {
    const int a = int(mesh.vertex(e, 0)) / segments, b = int(mesh.vertex(e, 1)) / segments;
    sharp[e] = a == b && a % 10 == 0;
  }
  return sharp;
}

// The property that tells what is a crease belongs to the mesh, tagged or not.
template <class Concurrency_tag, class Scheme>
Job creased_job(const Scheme& scheme, int segments, bool is_tagged)
{
  return [scheme, segments, is_tagged](const Mesh& control, unsigned rounds) -> Result {
    Mesh mesh = control;
    const auto normals = Control_meshes::add_normals(mesh);
    const Creases sharp = add_creases(mesh, segments);
    const auto parameters = params::number_of_iterations(rounds).vertex_normal_map(normals);
    const double seconds = seconds_of([&] {
      if (is_tagged)
        PN::subdivide<Concurrency_tag>(mesh, scheme, parameters.edge_is_constrained_map(sharp));
      else
        PN::subdivide<Concurrency_tag>(mesh, scheme, parameters);
    });
    return {seconds, mesh.number_of_faces()};
  };
}

template <class Concurrency_tag, class Scheme>
void add_creased_pair(const std::string& group, const Control& control, unsigned rounds,
                      const Scheme& scheme)
{
  for (const bool is_tagged : {false, true}) {
    const Job job = creased_job<Concurrency_tag>(scheme, control.segments, is_tagged);
    add(group + (is_tagged ? "/creased" : "/untagged"), control, rounds,
        [job](const Mesh& mesh, unsigned k) {
#ifdef CGAL_LINKED_WITH_TBB
          const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, 2);
#endif
          return job(mesh, k);
        });
  }
}

template <class Scheme>
void add_creased(const std::string& name, const std::string& size, const Control& control,
                 unsigned rounds, const Scheme& scheme)
{
  const std::string group = "creases_" + name + "/" + size;
  add_creased_pair<CGAL::Sequential_tag>(group, control, rounds, scheme);
#ifdef CGAL_LINKED_WITH_TBB
  add_creased_pair<CGAL::Parallel_tag>(group + "-2-threads", control, rounds, scheme);
#endif
}

void add_creased_jobs()
{
  const PN::CatmullClark_scheme catmull_clark;
  add_creased("CatmullClark", "100k", quads(20, 20), 4, catmull_clark);
  add_creased("CatmullClark", "1M", quads(80, 50), 4, catmull_clark);
  const PN::Loop_scheme loop;
  add_creased("Loop", "100k", triangles(20, 12), 4, loop);
  add_creased("Loop", "1M", triangles(50, 40), 4, loop);
}

namespace SM3 = CGAL::Subdivision_method_3;

// What a Surface_mesh takes to grow to the size of the result of a host of faces split at their
// corners, which no subdivision of a closed one can do without.
Result resize_alone(const Mesh& control, unsigned rounds)
{
  Mesh mesh = control;
  Control_meshes::add_normals(mesh);
  auto vertices = mesh.number_of_vertices(), edges = mesh.number_of_edges(),
       faces = mesh.number_of_faces();
  for (unsigned k = 0; k < rounds; ++k) {
    vertices += edges + faces;
    faces = 2 * edges;
    edges *= 4;
  }
  return {seconds_of([&] { mesh.resize(vertices, edges, faces); }), mesh.number_of_faces()};
}

const Job cgal_catmull_clark = linear_job([](Mesh& mesh, unsigned k) {
  SM3::CatmullClark_subdivision(mesh, params::number_of_iterations(k));
});

const Job cgal_loop = linear_job(
  [](Mesh& mesh, unsigned k) { SM3::Loop_subdivision(mesh, params::number_of_iterations(k)); });

void add_quad_schemes()
{
  const PN::CatmullClark_scheme catmull_clark;
  add_group("CatmullClark/100k", quads(24, 18), 4, cgal_catmull_clark, catmull_clark);
  add("CatmullClark/100k/resize-alone", quads(24, 18), 4, resize_alone);
  add_group("CatmullClark/1M", quads(72, 56), 4, cgal_catmull_clark, catmull_clark);
  add("CatmullClark/1M/resize-alone", quads(72, 56), 4, resize_alone);
  add_group("CatmullClark/1M-one-round", quads(500, 500), 1, cgal_catmull_clark, catmull_clark);
  // CGAL has no interpolatory scheme: beside its Catmull-Clark
  add_group("Kobbelt/100k", quads(24, 18), 4, cgal_catmull_clark, PN::Kobbelt_scheme());

  const Job cgal_doo_sabin = linear_job([](Mesh& mesh, unsigned k) {
    SM3::DooSabin_subdivision(mesh, params::number_of_iterations(k));
  });
  add_group("DooSabin/100k", quads(24, 18), 4, cgal_doo_sabin, PN::DooSabin_scheme());
  add_group("DooSabin/1M", quads(72, 56), 4, cgal_doo_sabin, PN::DooSabin_scheme());
}

void add_triangle_schemes()
{
  add_group("Loop/100k", triangles(16, 14), 4, cgal_loop, PN::Loop_scheme());
  add_group("Loop/1M", triangles(50, 40), 4, cgal_loop, PN::Loop_scheme());
  add_group("Loop/1M-one-round", triangles(360, 350), 1, cgal_loop, PN::Loop_scheme());

  const Job cgal_sqrt3 = linear_job(
    [](Mesh& mesh, unsigned k) { SM3::Sqrt3_subdivision(mesh, params::number_of_iterations(k)); });
  add_group("Sqrt3/100k", triangles(16, 14), 5, cgal_sqrt3, PN::Sqrt3_scheme());
  add_group("Sqrt3/1M", triangles(50, 40), 5, cgal_sqrt3, PN::Sqrt3_scheme());
#ifdef PN_BENCHMARK_WITH_OPENMESH
  add_group("Butterfly/100k", triangles(16, 14), 4, openmesh_butterfly, PN::Butterfly_scheme());
  add_group("Butterfly/1M", triangles(50, 40), 4, openmesh_butterfly, PN::Butterfly_scheme());
#endif
}

// CGAL's functions, and those of the same names here, also with CGAL's masks in the hosts of both.
void add_functions_of_cgal()
{
  namespace Ours = PN::Subdivision_method_3;
  const auto rounds = [](unsigned k) { return params::number_of_iterations(k); };
  const Control q = quads(24, 18), t = triangles(16, 14);
  const auto add_pair = [](const std::string& name, const Control& control, unsigned k,
                           const auto& cgal, const auto& ours) {
    add("as-CGAL/" + name + "/CGAL", control, k, linear_job(cgal));
    add("as-CGAL/" + name + "/ours", control, k, linear_job(ours));
  };
  add_pair(
    "CatmullClark", q, 4, [=](Mesh& m, unsigned k) { SM3::CatmullClark_subdivision(m, rounds(k)); },
    [=](Mesh& m, unsigned k) { Ours::CatmullClark_subdivision(m, rounds(k)); });
  add_pair(
    "Loop", t, 4, [=](Mesh& m, unsigned k) { SM3::Loop_subdivision(m, rounds(k)); },
    [=](Mesh& m, unsigned k) { Ours::Loop_subdivision(m, rounds(k)); });
  add_pair(
    "DooSabin", q, 4, [=](Mesh& m, unsigned k) { SM3::DooSabin_subdivision(m, rounds(k)); },
    [=](Mesh& m, unsigned k) { Ours::DooSabin_subdivision(m, rounds(k)); });
  add_pair(
    "Sqrt3", t, 5, [=](Mesh& m, unsigned k) { SM3::Sqrt3_subdivision(m, rounds(k)); },
    [=](Mesh& m, unsigned k) { Ours::Sqrt3_subdivision(m, rounds(k)); });
  const auto mask = [](Mesh& m) { return CGAL::Loop_mask_3<Mesh>(&m, get(CGAL::vertex_point, m)); };
  add_pair(
    "PTQ", t, 4, [=](Mesh& m, unsigned k) { SM3::PTQ(m, mask(m), rounds(k)); },
    [=](Mesh& m, unsigned k) { Ours::PTQ(m, mask(m), rounds(k)); });
}

// The estimate of control normals beside the angle-weighted one, both on the mesh's reading. A rough
// mesh has wide fans, which need both.
void add_normal_estimates()
{
  const auto estimate = [](PN::Control_normal_estimate how) -> Job {
    return [how](const Mesh& control, unsigned /*rounds*/) -> Result {
      Mesh mesh = control;
      const auto normals = Control_meshes::add_normals(mesh);
      const double seconds = seconds_of([&] {
        PN::estimate_control_normals(mesh, normals, PN::parameters::control_normal_estimate(how));
      });
      return {seconds, mesh.number_of_faces()};
    };
  };
  const std::pair<const char*, Control> controls[] = {{"quads", quads(1000, 1000)},
                                                      {"triangles", triangles(1000, 500)}};
  for (const auto& [name, control] : controls) {
    const std::string group = std::string("normals/1M-") + name;
    add(group + "/angle", control, 0, estimate(PN::Control_normal_estimate::angle));
    add(group + "/reciprocal", control, 0, estimate(PN::Control_normal_estimate::reciprocal));
  }
}

// A control mesh in good order and in random order, and what the order costs the linear function.
template <class Scheme>
void add_order(const std::string& group, const Control& ordered, const Control& shuffled,
               unsigned rounds, const Job& peer, const Scheme& scheme)
{
  // both are held, lest each run makes its control mesh anew
  const auto on = [](const Control& control, const Job& job) -> Job {
    return [job, control, mesh = std::make_shared<Mesh>()](const Mesh&, unsigned k) {
      if (mesh->is_empty()) *mesh = control.make(control.rings, control.segments);
      return job(*mesh, k);
    };
  };
  const Job pn = pn_job<CGAL::Sequential_tag>(scheme);
  add(group + "/good-order", ordered, rounds, on(ordered, pn));
  add(group + "/random-order", ordered, rounds, on(shuffled, pn));
  add(group + "/peer-linear-good-order", ordered, rounds, on(ordered, peer));
  add(group + "/peer-linear-random-order", ordered, rounds, on(shuffled, peer));
}

void add_orders()
{
  const auto shuffled_quads = [](int rings, int segments) -> Control {
    return {&Control_meshes::shuffled_quads, rings, segments};
  };
  const auto shuffled_triangles = [](int rings, int segments) -> Control {
    return {&Control_meshes::shuffled_triangles, rings, segments};
  };
  const PN::CatmullClark_scheme catmull_clark;
  add_order("order/CatmullClark-1M", quads(72, 56), shuffled_quads(72, 56), 4, cgal_catmull_clark,
            catmull_clark);
  add_order("order/CatmullClark-1M-one-round", quads(500, 500), shuffled_quads(500, 500), 1,
            cgal_catmull_clark, catmull_clark);
  const PN::Loop_scheme loop;
  add_order("order/Loop-1M", triangles(50, 40), shuffled_triangles(50, 40), 4, cgal_loop, loop);
  add_order("order/Loop-1M-one-round", triangles(360, 350), shuffled_triangles(360, 350), 1,
            cgal_loop, loop);
}

// A whole job, and a refiner that has done it and gets all points and normals once more, or one normal.
// With creases if their distance is given.
template <class Concurrency_tag, class Scheme>
Job update_job(const Scheme& scheme, bool is_one_normal, std::size_t crease_segments = 0)
{
  return [=](const Mesh& control, unsigned rounds) -> Result {
    using Refiner = PN::Surface_refiner<Mesh, Scheme, Kernel, Concurrency_tag>;
    Mesh mesh = control;
    const auto parameters =
      params::number_of_iterations(rounds).vertex_normal_map(Control_meshes::add_normals(mesh));
    Refiner refiner = crease_segments == 0 ? Refiner(mesh, scheme, parameters)
                                           : Refiner(mesh, scheme,
                                                     parameters.edge_is_constrained_map(add_creases(
                                                       mesh, static_cast<int>(crease_segments))));
    const std::size_t n = mesh.number_of_vertices();
    const auto turn = [&](std::size_t i, double x) {
      const Mesh::Vertex_index v(static_cast<Mesh::size_type>(i));
      refiner.set_normal(v, refiner.control_normal(v) + Kernel::Vector_3(x, 0, 0));
    };
    // along creases, the normals on their sides are estimated and stay so
    const auto is_on_crease = [&](std::size_t v) {
      return crease_segments != 0 && v / crease_segments % 10 == 0;
    };
    const std::size_t one = n / 2 + 5 * crease_segments;
    turn(one, 0.1);
    refiner.update(); // finds out once what reaches what
    if (is_one_normal)
      turn(one, 0.1);
    else
      for (std::size_t v = 0; v < n; ++v) {
        if (!is_on_crease(v)) turn(v, 0.1);
        const Mesh::Vertex_index vertex(static_cast<Mesh::size_type>(v));
        refiner.set_point(vertex, refiner.control_point(vertex));
      }
    return {seconds_of([&] { refiner.update(); }), refiner.number_of_faces()};
  };
}

template <class Scheme>
void add_refiner(const std::string& group, const Control& control, unsigned rounds,
                 const Scheme& scheme)
{
  add(group + "/subdivide", control, rounds, pn_job<CGAL::Sequential_tag>(scheme));
  add(group + "/all-changed", control, rounds, update_job<CGAL::Sequential_tag>(scheme, false));
  add(group + "/one-normal-changed", control, rounds,
      update_job<CGAL::Sequential_tag>(scheme, true));
#ifdef CGAL_LINKED_WITH_TBB
  const auto on_two_threads = [](const Job& job) -> Job {
    return [job](const Mesh& mesh, unsigned k) {
      const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, 2);
      return job(mesh, k);
    };
  };
  using Tag = CGAL::Parallel_tag;
  add(group + "-2-threads/subdivide", control, rounds, on_two_threads(pn_job<Tag>(scheme)));
  add(group + "-2-threads/all-changed", control, rounds,
      on_two_threads(update_job<Tag>(scheme, false)));
  add(group + "-2-threads/one-normal-changed", control, rounds,
      on_two_threads(update_job<Tag>(scheme, true)));
#endif
}

void add_refiners()
{
  const PN::CatmullClark_scheme catmull_clark;
  add_refiner("refiner/CatmullClark-100k", quads(20, 15), 4, catmull_clark);
  add_refiner("refiner/CatmullClark-1M", quads(20, 15), 6, catmull_clark);
  const PN::Loop_scheme loop;
  add_refiner("refiner/Loop-100k", triangles(15, 10), 4, loop);
  add_refiner("refiner/Loop-1M", triangles(15, 10), 6, loop);
  const Control creased = quads(20, 15);
  add("refiner_creases/100k/subdivide", creased, 4,
      creased_job<CGAL::Sequential_tag>(catmull_clark, creased.segments, true));
  for (const bool is_one_normal : {false, true})
    add(is_one_normal ? "refiner_creases/100k/one-normal-changed"
                      : "refiner_creases/100k/all-changed",
        creased, 4,
        update_job<CGAL::Sequential_tag>(catmull_clark, is_one_normal,
                                         static_cast<std::size_t>(creased.segments)));
  add_refiner("refiner/DooSabin-100k", quads(20, 15), 4, PN::DooSabin_scheme());
  add_refiner("refiner/Sqrt3-100k", triangles(15, 10), 5, PN::Sqrt3_scheme());
  add_refiner("refiner/Butterfly-100k", triangles(15, 10), 4, PN::Butterfly_scheme());
  add_refiner("refiner/Kobbelt-100k", quads(20, 15), 4, PN::Kobbelt_scheme());
}

// What attributes cost beside the points and normals.
void add_attributes()
{
  const Control control = quads(72, 56);
  const std::string group = "attributes/1M";
  add(group + "/none", control, 4, pn_job<CGAL::Sequential_tag>(PN::CatmullClark_scheme()));
  // attributes_of(mesh) adds maps to the mesh, which is not timed, and returns what is carried
  const auto add_job = [&](const char* name, const auto& attributes_of) {
    add(group + name, control, 4,
        [attributes_of](const Mesh& mesh_of_group, unsigned rounds) -> Result {
          Mesh mesh = mesh_of_group;
          const auto normals = Control_meshes::add_normals(mesh);
          const auto attributes = attributes_of(mesh);
          const double seconds = seconds_of([&] {
            PN::subdivide(mesh, PN::CatmullClark_scheme(),
                          attributes.number_of_iterations(rounds).vertex_normal_map(normals));
          });
          return {seconds, mesh.number_of_faces()};
        });
  };
  const auto scalar = [](Mesh& mesh, const char* name) {
    auto map = mesh.add_property_map<Mesh::Vertex_index, double>(name).first;
    for (auto v : mesh.vertices()) map[v] = mesh.point(v).x();
    return map;
  };
  // the maps of a mesh grow with it, carried or not
  add_job("/3-maps-that-stay", [scalar](Mesh& mesh) {
    for (const char* name : {"a", "b", "c"}) scalar(mesh, name);
    return PN::parameters::attributes();
  });
  add_job("/1-scalar", [scalar](Mesh& mesh) {
    return PN::parameters::attributes(PN::parameters::vertex_attribute(scalar(mesh, "a")));
  });
  add_job("/3-scalars", [scalar](Mesh& mesh) {
    return PN::parameters::attributes(PN::parameters::vertex_attribute(scalar(mesh, "a")),
                                      PN::parameters::vertex_attribute(scalar(mesh, "b")),
                                      PN::parameters::vertex_attribute(scalar(mesh, "c")));
  });
  add_job("/texture", [](Mesh& mesh) {
    auto uv = mesh.add_property_map<Mesh::Halfedge_index, std::array<double, 2>>("uv").first;
    for (auto h : mesh.halfedges()) // a seam where x changes its sign
      if (!mesh.is_border(h)) {
        const auto f = mesh.face(h);
        double x = 0;
        for (auto v : mesh.vertices_around_face(mesh.halfedge(f))) x += mesh.point(v).x();
        uv[h] = {mesh.point(mesh.target(h)).y() + (x > 0 ? 10 : 0), mesh.point(mesh.target(h)).z()};
      }
    return PN::parameters::attributes(PN::parameters::corner_attribute(uv));
  });
  add_job("/patch-ids", [](Mesh& mesh) {
    return PN::parameters::attributes(PN::parameters::face_attribute(
      mesh.add_property_map<Mesh::Face_index, int>("patch", 1).first));
  });
}

} // namespace

int main(int argc, char** argv)
{
  return run_and_print_ratios(argc, argv, 9, [] {
    add_quad_schemes();
    add_triangle_schemes();
    add_functions_of_cgal();
    add_modified_schemes();
    add_creased_jobs();
    add_normal_estimates();
    add_refiners();
    add_attributes();
    add_orders();
    return names;
  });
}

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// OpenSubdiv: the topology of all levels, or of the last one without its edges, with the points of the
// last level in double; and its tables of stencils, which give these points once more in float.

#include "Job.h"

#ifdef PN_BENCHMARK_WITH_OPENSUBDIV
#  include <opensubdiv/far/primvarRefiner.h>
#  include <opensubdiv/far/stencilTableFactory.h>
#  include <opensubdiv/far/topologyDescriptor.h>
#  include <opensubdiv/osd/bufferDescriptor.h>
#  include <opensubdiv/osd/cpuEvaluator.h>
#  include <opensubdiv/osd/ompEvaluator.h>
#  include <opensubdiv/version.h>

#  include <memory>
#  include <string>
#  include <vector>

namespace {

namespace Far = OpenSubdiv::Far;
namespace Osd = OpenSubdiv::Osd;
namespace Sdc = OpenSubdiv::Sdc;

struct Point
{
  void Clear(void* = nullptr) { x = y = z = 0; }
  void AddWithWeight(const Point& p, double w)
  {
    x += w * p.x;
    y += w * p.y;
    z += w * p.z;
  }
  double x, y, z;
};

std::vector<Point> points_of(const Control& control)
{
  std::vector<Point> points;
  for (const auto& p : control.points) points.push_back({p[0], p[1], p[2]});
  return points;
}

// a control mesh as OpenSubdiv takes it
struct Topology
{
  explicit Topology(const Control& control)
  {
    for (const std::vector<int>& f : control.faces) {
      degrees.push_back(static_cast<int>(f.size()));
      corners.insert(corners.end(), f.begin(), f.end());
    }
    descriptor.numVertices = static_cast<int>(control.points.size());
    descriptor.numFaces = static_cast<int>(degrees.size());
    descriptor.numVertsPerFace = degrees.data();
    descriptor.vertIndicesPerFace = corners.data();
  }

  using Refiner = std::unique_ptr<Far::TopologyRefiner>;
  Refiner refined(Sdc::SchemeType type, unsigned rounds, bool is_full) const
  {
    using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
    Refiner refiner(Factory::Create(descriptor, Factory::Options(type)));
    Far::TopologyRefiner::UniformOptions options(static_cast<int>(rounds));
    options.fullTopologyInLastLevel = is_full;
    refiner->RefineUniform(options);
    return refiner;
  }

  std::vector<int> degrees, corners;
  Far::TopologyDescriptor descriptor;
};

Result refine(Sdc::SchemeType type, const Control& control, unsigned rounds, bool is_full)
{
  const Topology topology(control);
  const std::vector<Point> control_points = points_of(control);
  Topology::Refiner refiner;
  std::vector<Point> points, refined;
  Result result = timed([&] {
    refiner = topology.refined(type, rounds, is_full);
    const Far::PrimvarRefinerReal<double> interpolate(*refiner);
    points = control_points;
    for (int level = 1; level <= static_cast<int>(rounds); ++level) {
      refined.resize(static_cast<std::size_t>(refiner->GetLevel(level).GetNumVertices()));
      interpolate.Interpolate(level, points, refined);
      points.swap(refined);
    }
  });
  result.faces =
    static_cast<std::size_t>(refiner->GetLevel(static_cast<int>(rounds)).GetNumFaces());
  return result;
}

Result evaluate_stencils(Sdc::SchemeType type, const Control& control, unsigned rounds,
                         unsigned threads)
{
  const Topology topology(control);
  const Topology::Refiner refiner = topology.refined(type, rounds, false);
  Far::StencilTableFactory::Options options;
  options.generateIntermediateLevels = false;
  options.generateOffsets = true;
  const std::unique_ptr<const Far::StencilTable> table(
    Far::StencilTableFactory::Create(*refiner, options));
  std::vector<float> points;
  for (const auto& p : control.points)
    for (double x : p) points.push_back(static_cast<float>(x));
  std::vector<float> refined(3 * static_cast<std::size_t>(table->GetNumStencils()));
  const Osd::BufferDescriptor layout(0, 3, 3);
  Result result = timed([&] {
    const auto evaluate = [&](auto evaluator) {
      decltype(evaluator)::EvalStencils(points.data(), layout, refined.data(), layout,
                                        table->GetSizes().data(), table->GetOffsets().data(),
                                        table->GetControlIndices().data(),
                                        table->GetWeights().data(), 0, table->GetNumStencils());
    };
    if (threads > 1) // as many as OMP_NUM_THREADS says
      evaluate(Osd::OmpEvaluator());
    else
      evaluate(Osd::CpuEvaluator());
  });
  result.faces =
    static_cast<std::size_t>(refiner->GetLevel(static_cast<int>(rounds)).GetNumFaces());
  return result;
}

void add(Jobs& jobs, const std::string& name, Sdc::SchemeType type)
{
  for (const bool is_full : {false, true})
    jobs[std::string("opensubdiv/") + (is_full ? "full-topology/" : "last-level/") + name] =
      [type, is_full](const Control& control, unsigned rounds, unsigned) {
        return refine(type, control, rounds, is_full);
      };
  jobs["opensubdiv/stencils/" + name] = [type](const Control& control, unsigned rounds,
                                               unsigned threads) {
    return evaluate_stencils(type, control, rounds, threads);
  };
}

} // namespace

void add_opensubdiv(Jobs& jobs)
{
  jobs.libraries.push_back("OpenSubdiv " + std::to_string(OPENSUBDIV_VERSION_MAJOR) + '.' +
                           std::to_string(OPENSUBDIV_VERSION_MINOR));
  add(jobs, "catmull-clark", Sdc::SCHEME_CATMARK);
  add(jobs, "loop", Sdc::SCHEME_LOOP);
}
#else
void add_opensubdiv(Jobs&)
{}
#endif

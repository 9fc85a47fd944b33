// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Times curves of a million points in space, on one thread: the PN rule beside the linear rule on
// the same six coordinates (points and normals, not normalized) through the same code, the linear
// scheme on points alone, and a copy of the output's bytes. Releasing the memory is not timed. The
// runs of all jobs are interleaved; the ratios of the medians are to the linear rule on six
// coordinates.
//
//   benchmark_curves [--benchmark_filter=...] [--benchmark_repetitions=N]

#include "Ratio_reporter.h"

#include <CGAL/PN_subdivision_curve.h>
#include <CGAL/Simple_cartesian.h>

#include <benchmark/benchmark.h>

#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;
using Kernel = CGAL::Simple_cartesian<double>;
using Item = std::pair<Kernel::Point_3, Kernel::Vector_3>;
using Six = std::array<double, 6>;

constexpr std::size_t control_points = 1000;
constexpr unsigned rounds = 10;

// A knot that winds about a torus, with the normals of the torus.
std::vector<Item> control_polygon()
{
  std::vector<Item> polygon;
  for (std::size_t i = 0; i < control_points; ++i) {
    const double u = 2 * CGAL_PI * static_cast<double>(i) / control_points, v = 7 * u;
    const Kernel::Vector_3 n(std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v));
    polygon.emplace_back(Kernel::Point_3(3 * std::cos(u), 3 * std::sin(u), 0) + n, n);
  }
  return polygon;
}

template <class Mask>
std::vector<Item> subdivided(const std::vector<Item>& polygon, const Mask& mask)
{
  return PN::subdivide_curve(polygon, mask, PN::Curve_end::closed,
                             params::number_of_iterations(rounds));
}

// what a curve in six dimensions asks of a point
struct Point_6
{
  Six coordinates;
  double cartesian(int i) const { return coordinates[static_cast<std::size_t>(i)]; }
};

template <class Mask>
std::vector<Six> subdivided_6(const std::vector<Item>& polygon, const Mask& mask)
{
  using Linear = decltype(PN::linear(mask));
  PN::internal::Curve_subdivision<double, 6, Linear> curve(PN::linear(mask), PN::Curve_end::closed);
  const Point_6 zero{};
  for (const auto& [p, n] : polygon)
    curve.add(Point_6{{p.x(), p.y(), p.z(), n.x(), n.y(), n.z()}}, zero);
  return curve.template result<Six>(rounds, [](const Six& value) { return value; });
}

std::vector<std::string> names;

template <class Job>
void add(const std::string& name, const Job& job)
{
  names.push_back(name);
  const auto run = [job](benchmark::State& state) {
    std::size_t points = 0;
    for (auto _ : state) {
      const auto begin = std::chrono::steady_clock::now();
      const auto result = job();
      benchmark::DoNotOptimize(result.data());
      state.SetIterationTime(
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
      points = result.size();
    }
    state.counters["points"] = static_cast<double>(points);
  };
  benchmark::RegisterBenchmark(name.c_str(), run)
    ->UseManualTime()
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);
}

// The linear rule on six coordinates comes first: the ratios of a group are to its first job.
template <class Mask>
void add_group(const std::string& group, const Mask& mask)
{
  const auto polygon = control_polygon();
  add(group + "/linear-6-coordinates", [=] { return subdivided_6(polygon, mask); });
  add(group + "/PN", [=] { return subdivided(polygon, mask); });
  add(group + "/linear-points-alone", [=] { return subdivided(polygon, PN::linear(mask)); });
  const auto curve = subdivided(polygon, mask);
  add(group + "/copy-of-the-bytes", [=] { return std::vector<Item>(curve); });
}

} // namespace

int main(int argc, char** argv)
{
  return run_and_print_ratios(argc, argv, 15, [] {
    add_group("cubic-B-spline", PN::B_spline_mask(3));
    add_group("4-point", PN::Dubuc_Deslauriers_mask(4));
    return names;
  });
}

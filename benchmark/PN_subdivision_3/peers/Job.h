// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_BENCHMARK_PEERS_JOB_H
#define CGAL_PN_SUBDIVISION_3_BENCHMARK_PEERS_JOB_H

#include <sys/resource.h>

#include <array>
#include <chrono>
#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

// A control mesh as every library can read it.
struct Control
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::vector<int>> faces;
};

struct Result
{
  std::size_t faces = 0;
  double seconds = 0;
  long page_faults = 0;
};

// makes a library's mesh of the control mesh, which is not timed, and subdivides it
using Job = std::function<Result(const Control& control, unsigned rounds, unsigned threads)>;

struct Jobs
{
  std::map<std::string, Job> by_name; // `library/variant/scheme`
  std::vector<std::string> libraries; // with their versions

  Job& operator[](const std::string& name) { return by_name[name]; }
};

// times a function; the result has no faces yet
template <class Function>
Result timed(const Function& f)
{
  rusage before{}, after{};
  getrusage(RUSAGE_SELF, &before);
  const auto begin = std::chrono::steady_clock::now();
  f();
  const auto end = std::chrono::steady_clock::now();
  getrusage(RUSAGE_SELF, &after);
  Result result;
  result.seconds = std::chrono::duration<double>(end - begin).count();
  result.page_faults = after.ru_minflt - before.ru_minflt;
  return result;
}

// those of this program; a library that was not found has none
void add_floor(Jobs&);
void add_pn_surface_mesh(Jobs&);
void add_pn_polyhedron(Jobs&);
void add_pn_refiner(Jobs&);
void add_cgal(Jobs&);
void add_openmesh(Jobs&);
void add_opensubdiv(Jobs&);

#endif // CGAL_PN_SUBDIVISION_3_BENCHMARK_PEERS_JOB_H

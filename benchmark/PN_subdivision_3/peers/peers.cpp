// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Times whole jobs, mesh in and mesh out, of this package and of other libraries. It does what it is told
// line by line, so that scripts/compare_speed.py can run jobs of several processes in turn:
//
//   JOB CONTROL_MESH.off ROUNDS THREADS   ->   faces seconds page_faults
//
// `peers --list` prints the jobs, `peers --libraries` what they use.

#include "Job.h"

#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>

namespace {

// an OFF file without comments, as the script writes them
Control read(const std::string& file)
{
  std::ifstream in(file);
  std::string header;
  std::size_t vertices = 0, faces = 0, edges = 0;
  in >> header >> vertices >> faces >> edges;
  Control control;
  control.points.resize(vertices);
  for (auto& p : control.points) in >> p[0] >> p[1] >> p[2];
  control.faces.resize(faces);
  for (auto& f : control.faces) {
    std::size_t degree = 0;
    in >> degree;
    f.resize(degree);
    for (int& v : f) in >> v;
  }
  if (!in || faces == 0) throw std::runtime_error("cannot read " + file);
  return control;
}

} // namespace

int main(int argc, char** argv)
{
  Jobs jobs;
  add_floor(jobs);
  add_pn_surface_mesh(jobs);
  add_pn_polyhedron(jobs);
  add_pn_refiner(jobs);
  add_cgal(jobs);
  add_openmesh(jobs);
  add_opensubdiv(jobs);
  if (argc > 1 && std::string(argv[1]) == "--list") {
    for (const auto& [name, job] : jobs.by_name) std::cout << name << '\n';
    return EXIT_SUCCESS;
  }
  if (argc > 1 && std::string(argv[1]) == "--libraries") {
    for (const std::string& library : jobs.libraries) std::cout << library << '\n';
    return EXIT_SUCCESS;
  }
  try {
    std::string line, held;
    Control control;
    while (std::getline(std::cin, line)) {
      std::istringstream words(line);
      std::string name, file;
      unsigned rounds = 0, threads = 1;
      if (!(words >> name >> file >> rounds >> threads) || jobs.by_name.count(name) == 0)
        throw std::runtime_error("no such job: " + line);
      if (file != held) control = read(held = file);
      const Result result = jobs[name](control, rounds, threads);
      std::cout << result.faces << ' ' << result.seconds << ' ' << result.page_faults << std::endl;
    }
  } catch (const std::exception& e) {
    std::cerr << "peers: " << e.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Rules at extraordinary vertices compared: the plain PN scheme, the modified one, the modified one with
// the policy of Yang's paper, and the one with transfer of curvature. Prints how close the Gaussian
// curvature near the vertex is to that of the sampled surface, how fair the surfaces are (the integral of
// the squared gradient of the mean curvature), and how much the curvature wavers on two rings.
//
//   compare_extraordinary_rules [FOLDER_OF_CONTROL_MESHES]

#include "Extraordinary_fairness.h"
#include "Local_examples.h"

#include <CGAL/PN_subdivision_3.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#if __has_include(<Eigen/Core>)
#  include <CGAL/PN_limit_surface_3/estimate_curvature.h>
#endif

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>

namespace PN = CGAL::PN_subdivision_3;
namespace data = extraordinary_data;
using local_examples::Kernel;
using local_examples::Mesh;

namespace {

// The first round, plain or modified, makes five rings about the vertex of three. From there on.
template <class First, class Later>
void print_row(const char* name, Mesh mesh, const First& first, const Later& later)
{
  PN::subdivide(mesh, first, CGAL::parameters::vertex_normal_map(local_examples::normal_map(mesh)));
  const Mesh::Vertex_index middle(0);
  const data::Fairness_measure<Later> measure(later, mesh.degree(middle));
  const data::Values values = local_examples::values_around(mesh, middle, measure.zoom().net());
  const auto rings = measure.zoom().measure(values, 8).rings;
  std::printf("  %-34s %9.4f   %8.4f to %8.4f   %8.4f to %8.4f\n", name,
              measure(values, {}).variation, rings[0].gaussian_min, rings[0].gaussian_max,
              rings[8].gaussian_min, rings[8].gaussian_max);
}

template <class Plain, class Modified, class Transfer>
void print_rows(const Mesh& mesh, const Plain& plain, const Modified& modified,
                const Transfer& transfer)
{
  std::printf("  %-34s variation   K on ring 1              K on ring 9\n", "");
  print_row("PN", mesh, plain, plain);
  print_row("PN-modified", mesh, modified, modified);
  print_row("PN-modified, first round plain", mesh, plain, modified);
  print_row("with the paper's policy", mesh, plain, Modified::of_the_paper());
  print_row("PN with transfer of curvature", mesh, transfer, transfer);
}

#if __has_include(<Eigen/Core>)
// the integral over a refined mesh, by its curvature estimated from its points
template <class Scheme>
void print_variation(const char* name, Mesh mesh, const Scheme& scheme)
{
  PN::subdivide(mesh, scheme, CGAL::parameters::number_of_iterations(4));
  using Curvature = PN::Vertex_curvature<Kernel>;
  auto curvatures = mesh.add_property_map<Mesh::Vertex_index, Curvature>("v:curvature").first;
  PN::estimate_curvature(mesh, curvatures);
  double sum = 0;
  for (const auto f : mesh.faces()) {
    std::vector<Mesh::Vertex_index> v;
    for (const auto w : mesh.vertices_around_face(mesh.halfedge(f))) v.push_back(w);
    for (std::size_t k = 2; k < v.size(); ++k) {
      const Kernel::Point_3 p[] = {mesh.point(v[0]), mesh.point(v[k - 1]), mesh.point(v[k])};
      const double h[] = {curvatures[v[0]].mean, curvatures[v[k - 1]].mean, curvatures[v[k]].mean};
      const Kernel::Vector_3 g = h[0] * (p[2] - p[1]) + h[1] * (p[0] - p[2]) + h[2] * (p[1] - p[0]);
      const double twice_area =
        std::sqrt(CGAL::cross_product(p[1] - p[0], p[2] - p[0]).squared_length());
      if (twice_area > 0) sum += g.squared_length() / (2 * twice_area);
    }
  }
  std::printf("  %-34s variation %10.1f\n", name, sum);
}

template <class Plain, class Modified, class Transfer>
void print_mesh(const std::string& file, const Plain& plain, const Modified& modified,
                const Transfer& transfer)
{
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(file, mesh)) throw std::runtime_error("no mesh in " + file);
  std::printf("%s, four rounds\n", file.c_str());
  print_variation("PN", mesh, plain);
  print_variation("PN-modified", mesh, modified);
  print_variation("PN-modified, first round plain", mesh, Modified(.5, 2));
  print_variation("with the paper's policy", mesh, Modified::of_the_paper());
  print_variation("PN with transfer of curvature", mesh, transfer);
}
#endif

void print_transfer(data::Index n)
{
  const PN::CatmullClark_scheme::Tuned modified;
  const PN::CatmullClark_scheme::Transfer transfer;
  const data::Fairness_measure<PN::CatmullClark_scheme::Tuned> without(modified, n);
  const data::Fairness_measure<PN::CatmullClark_scheme::Transfer> with(transfer, n);
  const data::Values values = data::sampled(with.zoom().net(), data::ellipsoid, .15);
  const double k = data::exact_curvature(data::ellipsoid, 0, 0).gaussian;
  const data::Fairness a = without(values, data::ellipsoid), b = with(values, data::ellipsoid);
  std::printf("ellipsoid, valence %u: K at the vertex off by %.1f %%, with transfer %.1f %%; mean "
              "curvature by %.2f %% and %.2f %%\n",
              static_cast<unsigned>(n), 100 * std::abs(a.gaussian / k - 1),
              100 * std::abs(b.gaussian / k - 1), 100 * a.relative_error(),
              100 * b.relative_error());
}

} // namespace

int main(int argc, char** argv)
{
  try {
    const auto file = [&](const std::string& name) {
      return argc > 1 ? argv[1] + ("/" + name) : CGAL::data_file_path("meshes/" + name);
    };
    const PN::CatmullClark_scheme plain;
    const PN::CatmullClark_scheme::Tuned modified;
    const PN::CatmullClark_scheme::Transfer transfer;
    for (const auto& example : local_examples::all()) {
      std::printf("%s\n", example.file.c_str());
      print_rows(local_examples::read(file(example.file)), plain, modified, transfer);
    }
    for (const data::Index n : {3u, 5u, 6u, 8u, 12u}) print_transfer(n);
#if __has_include(<Eigen/Core>)
    print_mesh(file("spoon.obj"), plain, modified, transfer);
    print_mesh(file("head.obj"), plain, modified, transfer);
#endif
  } catch (const std::exception& e) {
    std::cerr << e.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}

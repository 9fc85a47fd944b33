// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Surfaces through uneven samples of an ellipsoid and a torus, of which the points alone are known: by
// linear subdivision, and by point-normal subdivision in both modes. Prints how far they are from the
// shapes, and writes each with its error and mean curvature at the vertices as a VTP file.
//
//   interpolate_samples [FOLDER]

#include "Interpolation_samples.h"
#include "write_vtp_arrays.h"

#include <CGAL/PN_fitting_3/interpolate_limit_points.h>
#include <CGAL/PN_limit_surface_3/limit_points.h>
#include <CGAL/PN_subdivision_3.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;
using namespace interpolation_samples;

namespace {

// The surface of a control net after two rounds, on its limit; its error and curvature.
template <class Scheme>
bool show(const std::string& title, const std::string& file, const Shape& shape, Mesh mesh,
          const Scheme& scheme, const PN::Limit_interpolation& report)
{
  const Normals normals = mesh.add_property_map<Mesh::Vertex_index, Vector>("v:normal").first;
  PN::subdivide(mesh, scheme, params::number_of_iterations(2).vertex_normal_map(normals));
  using Limit = PN::Limit_point<Kernel>;
  const auto limits = mesh.add_property_map<Mesh::Vertex_index, Limit>("v:limit").first;
  PN::limit_points(mesh, scheme, limits,
                   PN::parameters::curvatures(true).rounds_done(2).vertex_normal_map(normals));
  std::vector<double> error, curvature;
  double sum = 0, largest = 0;
  for (const auto v : mesh.vertices()) {
    mesh.point(v) = limits[v].point;
    error.push_back(shape.distance(mesh.point(v)));
    curvature.push_back(limits[v].mean);
    sum += error.back() * error.back();
    largest = (std::max)(largest, std::abs(error.back()));
  }
  std::printf("  %-24s error rms %.2g, largest %.2g; residual %.1g, %u steps\n", title.c_str(),
              std::sqrt(sum / double(error.size())), largest, report.residual, report.steps);
  return write_vtp(file, mesh, {{"error", error}, {"mean_curvature", curvature}});
}

bool interpolate(const Shape& shape, const std::string& folder)
{
  const PN::CatmullClark_scheme::Tuned scheme;
  Mesh samples = shape.samples();
  const Normals normals =
    samples.add_property_map<Mesh::Vertex_index, Vector>("v:normal", CGAL::NULL_VECTOR).first;
  // the normals of the surface that slides along them; all surfaces get them
  Mesh slid = samples;
  const Normals natural = slid.add_property_map<Mesh::Vertex_index, Vector>("v:normal").first;
  PN::interpolate_limit_points(
    slid, scheme,
    PN::parameters::interpolation_normals(PN::Limit_interpolation::Normals::natural)
      .vertex_normal_map(natural));
  for (const auto v : samples.vertices()) normals[v] = natural[v];
  std::printf("%s, %u points\n", shape.name.c_str(), unsigned(samples.number_of_vertices()));

  PN::Limit_interpolation::Mode mode = PN::Limit_interpolation::Mode::strict;
  const auto run = [&](const std::string& title, const std::string& name, const auto& s) {
    Mesh net = samples;
    const Normals map = net.add_property_map<Mesh::Vertex_index, Vector>("v:normal").first;
    const auto report = PN::interpolate_limit_points(
      net, s, PN::parameters::interpolation_mode(mode).vertex_normal_map(map));
    return show(title, folder + "/" + shape.name + "_" + name + ".vtp", shape, net, s, report);
  };
  bool good = run("linear", "linear", PN::linear(scheme));
  good = run("point-normal, limit points", "points", scheme) && good;
  mode = PN::Limit_interpolation::Mode::slide;
  return run("point-normal, slide", "slide", scheme) && good;
}

} // namespace

int main(int argc, char** argv)
{
  const std::string folder = argc > 1 ? argv[1] : ".";
  const bool good = interpolate(ellipsoid(), folder);
  return interpolate(torus(), folder) && good ? EXIT_SUCCESS : EXIT_FAILURE;
}

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// A mechanical part of planes, cylinders and spheres, with creases wherever two of them meet. How far
// is the refined part from them? By the linear scheme and by the point-normal one.
//
//   mechanical_part [PART.obj [ROUNDS]]
//
// The file has a group for each of the part's surfaces, which a comment describes, and a normal for
// each corner.

#include "Part_file.h"

#include <CGAL/PN_certificates_3/reproduction.h>
#include <CGAL/PN_subdivision_3.h>

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;
using part_file::Kernel;
using part_file::Mesh;
using part_file::Part;
using part_file::Surface;
using Exact = CGAL::Simple_cartesian<CGAL::Exact_rational>;

// The faces' groups after some rounds of Catmull-Clark subdivision: the first child of a face keeps
// its index, the others follow behind all old faces (see CGAL::PN_subdivision_3::PQQ_host).
std::vector<int> refined_groups(const Part& part, unsigned rounds)
{
  std::vector<int> groups = part.groups;
  for (unsigned k = 0; k < rounds; ++k) {
    const std::size_t n = groups.size();
    for (std::size_t f = 0; f < n; ++f) {
      const auto children =
        k > 0 ? 4u : part.mesh.degree(Mesh::Face_index(static_cast<unsigned>(f)));
      groups.insert(groups.end(), children - 1, groups[f]);
    }
  }
  return groups;
}

// The largest distance of a point, measured without rounding.
double deviation(const std::vector<Kernel::Point_3>& points, const Surface& s)
{
  const std::vector<double>& x = s.numbers;
  const Exact::Point_3 c(x[0], x[1], x[2]);
  if (s.kind == "sphere")
    return PN::curve_deviation(points, Exact::Sphere_3(c, CGAL::square(Exact::FT(x[3]))))
      .distance.sup();
  const Exact::Vector_3 d(x[3], x[4], x[5]);
  if (s.kind == "cylinder")
    return PN::curve_deviation(
             points, PN::Cylinder_3<Exact>(Exact::Line_3(c, d), CGAL::square(Exact::FT(x[6]))))
      .distance.sup();
  double largest = 0;
  for (const Kernel::Point_3& p : points) {
    const Exact::Vector_3 v = Exact::Point_3(p.x(), p.y(), p.z()) - c;
    largest = (std::max)(largest, std::abs(CGAL::to_double(v * d)));
  }
  return largest / std::sqrt(CGAL::to_double(d.squared_length()));
}

// One number for each surface of the part.
std::vector<double> deviations(const Part& part, const std::vector<int>& groups)
{
  std::vector<std::vector<Kernel::Point_3>> points(part.surfaces.size());
  for (const Mesh::Face_index f : part.mesh.faces())
    for (const Mesh::Vertex_index v : vertices_around_face(part.mesh.halfedge(f), part.mesh))
      points[groups[f]].push_back(part.mesh.point(v));
  std::vector<double> result;
  for (std::size_t i = 0; i < points.size(); ++i)
    result.push_back(deviation(points[i], part.surfaces[i]));
  return result;
}

auto mark_creases(Part& part)
{
  auto sharp = part.mesh.add_property_map<Mesh::Edge_index, bool>("e:is_sharp", false).first;
  for (const Mesh::Edge_index e : part.mesh.edges())
    sharp[e] = part_file::is_between_surfaces(part, e);
  return sharp;
}

int main(int argc, char** argv)
{
  const std::string filename =
    argc > 1 ? argv[1] : CGAL::data_file_path("meshes/parts/bearing_housing.obj");
  const unsigned rounds = argc > 2 ? static_cast<unsigned>(std::atoi(argv[2])) : 4;
  Part part, linear;
  if (!part_file::read(filename, part) || !part_file::read(filename, linear)) {
    std::cerr << "Invalid input: " << filename << std::endl;
    return EXIT_FAILURE;
  }
  const std::vector<int> groups = refined_groups(part, rounds);
  std::cout << filename << ": " << num_faces(part.mesh) << " faces, " << groups.size() << " after "
            << rounds << " rounds\n\n";

  PN::subdivide(part.mesh, PN::CatmullClark_scheme(),
                params::number_of_iterations(rounds)
                  .edge_is_constrained_map(mark_creases(part))
                  .vertex_normal_map(part.normals));
  PN::subdivide(linear.mesh, PN::linear(PN::CatmullClark_scheme()),
                params::number_of_iterations(rounds).edge_is_constrained_map(mark_creases(linear)));

  const std::vector<double> pn = deviations(part, groups), of_linear = deviations(linear, groups);
  std::cout << std::left << std::setw(20) << "surface" << std::setw(10) << "kind" << std::right
            << std::setw(8) << "faces" << std::setw(12) << "linear" << std::setw(12) << "PN"
            << std::setw(14) << "in 2^-52\n";
  for (std::size_t i = 0; i < pn.size(); ++i)
    std::cout << std::left << std::setw(20) << part.surfaces[i].name << std::setw(10)
              << part.surfaces[i].kind << std::right << std::setw(8)
              << std::count(groups.begin(), groups.end(), int(i)) << std::setprecision(3)
              << std::setw(12) << of_linear[i] << std::setw(12) << pn[i] << std::setw(12)
              << pn[i] / std::numeric_limits<double>::epsilon() << '\n';
  return EXIT_SUCCESS;
}

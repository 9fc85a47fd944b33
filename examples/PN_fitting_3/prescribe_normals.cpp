// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Limit surfaces with prescribed normals and curvatures: the tip of a head's nose is turned up, the ends of
// two patches are given common tangent planes, so that they meet smoothly, and a patch gets a dent.
//
//   prescribe_normals [HEAD [FOLDER]]

#include <CGAL/PN_fitting_3/prescribe_limit_data.h>
#include <CGAL/PN_limit_surface_3/limit_points.h>
#include <CGAL/PN_limit_surface_3/subdivide_to_limit.h>
#include <CGAL/PN_subdivision_3.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <string>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;
using Normals = CGAL::PN_subdivision_3::Estimated_control_normals<Vertex, Kernel>;
namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;

namespace {

const PN::CatmullClark_scheme::Tuned scheme;

// A mesh with control normals and what is prescribed.
struct Design
{
  Mesh mesh;
  Normals normals;
  Mesh::Property_map<Vertex, std::optional<Point>> points_of_limit;
  Mesh::Property_map<Vertex, std::optional<Vector>> normals_of_limit;
  Mesh::Property_map<Vertex, std::optional<PN::Prescribed_curvature<Kernel>>> curvatures_of_limit;
  Mesh::Property_map<Vertex, PN::Limit_point<Kernel>> limits;

  explicit Design(Mesh m)
    : mesh(std::move(m))
    , normals(PN::estimate_control_normals(mesh))
    , points_of_limit(mesh.add_property_map<Vertex, std::optional<Point>>("v:p").first)
    , normals_of_limit(mesh.add_property_map<Vertex, std::optional<Vector>>("v:n").first)
    , curvatures_of_limit(
        mesh.add_property_map<Vertex, std::optional<PN::Prescribed_curvature<Kernel>>>("v:c").first)
    , limits(mesh.add_property_map<Vertex, PN::Limit_point<Kernel>>("v:limit").first)
  {
    evaluate();
  }

  void evaluate()
  {
    PN::limit_points(mesh, scheme, limits,
                     PN::parameters::surface_normals(true).vertex_normal_map(normals));
  }

  void solve(const std::string& title)
  {
    const PN::Limit_interpolation report =
      PN::prescribe_limit_data(mesh, scheme,
                               PN::parameters::prescribed_point_map(points_of_limit)
                                 .prescribed_normal_map(normals_of_limit)
                                 .prescribed_curvature_map(curvatures_of_limit)
                                 .vertex_normal_map(normals));
    std::cout << title << ": points off by " << report.residual << ", normals by "
              << report.normal_residual << " radians, curvatures by " << report.curvature_residual
              << ", solves: " << report.steps << std::endl;
  }

  // the refined mesh on its limit, with the surface's normals
  bool write(const std::string& file) const
  {
    Mesh fine = mesh;
    const auto shading = fine.add_property_map<Vertex, Vector>("v:normal").first;
    PN::subdivide_to_limit(fine, scheme,
                           PN::parameters::surface_normals(true)
                             .limit_normal_map(shading)
                             .vertex_normal_map(normals.clone())
                             .number_of_iterations(4));
    return CGAL::IO::write_polygon_mesh(file, fine,
                                        params::stream_precision(17).vertex_normal_map(shading));
  }
};

// v turned about an axis, a unit vector
Vector turned(const Vector& v, const Vector& axis, double degrees)
{
  const double a = degrees * CGAL_PI / 180;
  return std::cos(a) * v + std::sin(a) * CGAL::cross_product(axis, v) +
         (1 - std::cos(a)) * (axis * v) * axis;
}

bool turn_nose_up(Mesh head, const std::string& folder)
{
  Design design(std::move(head));
  // the head looks along -y
  const Vertex tip = *std::min_element(
    design.mesh.vertices().begin(), design.mesh.vertices().end(),
    [&](Vertex a, Vertex b) { return design.mesh.point(a).y() < design.mesh.point(b).y(); });
  const bool good = design.write(folder + "/nose_before.ply");
  design.points_of_limit[tip] = design.limits[tip].point;
  design.normals_of_limit[tip] = turned(design.limits[tip].surface_normal, Vector(-1, 0, 0), 35);
  design.solve("nose");
  return design.write(folder + "/nose_after.ply") && good;
}

// a strip of 6 x 4 faces from x0 on, that rises to the left or to the right of the border x = 0
Mesh patch(bool left)
{
  Mesh mesh;
  constexpr int nx = 6, ny = 4;
  for (int j = 0; j <= ny; ++j)
    for (int i = 0; i <= nx; ++i) {
      const double x = 0.5 * i, y = 0.5 * j;
      mesh.add_vertex(left ? Point(0.5 * (i - nx), y, 0.35 * std::sin(1.2 * 0.5 * (nx - i)))
                           : Point(x, y, 0.5 * x - 0.1 * x * x));
    }
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) {
      const auto v = [&](int a, int b) { return Vertex(b * (nx + 1) + a); };
      mesh.add_face(v(i, j), v(i + 1, j), v(i + 1, j + 1), v(i, j + 1));
    }
  return mesh;
}

bool join_patches(const std::string& folder)
{
  bool good = true;
  for (const bool left : {true, false}) {
    Design design(patch(left));
    const std::string name = left ? "left" : "right";
    good = design.write(folder + "/" + name + "_before.ply") && good;
    for (const Vertex v : design.mesh.vertices()) {
      const Point& p = design.mesh.point(v);
      const bool is_end = p.y() < 0.1 || p.y() > 1.9; // a corner has no tangent plane
      if (p.x() != 0 || is_end) continue;
      design.points_of_limit[v] = p; // where the other patch passes, too
      design.normals_of_limit[v] = Vector(0, 0, 1);
    }
    design.solve(name + " patch");
    good = design.write(folder + "/" + name + "_after.ply") && good;
  }
  return good;
}

// Convex towards the viewer in one direction, concave in the other; point and normal stay.
bool dent_patch(const std::string& folder)
{
  Design design(patch(false));
  const bool good = design.write(folder + "/dent_before.ply");
  const Vertex middle(17);
  design.curvatures_of_limit[middle] = PN::Prescribed_curvature<Kernel>{-1.2, 0.6, Vector(1, 0, 0)};
  design.solve("dent");
  return design.write(folder + "/dent_after.ply") && good;
}

} // namespace

int main(int argc, char** argv)
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/head.obj");
  const std::string folder = argc > 2 ? argv[2] : ".";
  Mesh head;
  if (!CGAL::IO::read_polygon_mesh(filename, head) || head.is_empty()) {
    std::cerr << "Invalid input: " << filename << std::endl;
    return EXIT_FAILURE;
  }
  const bool nose = turn_nose_up(std::move(head), folder);
  const bool patches = join_patches(folder);
  return dent_patch(folder) && nose && patches ? EXIT_SUCCESS : EXIT_FAILURE;
}

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Spheres and cylinders are kept: radii in long double, uneven and irregular control data.

#include "Mesh_files.h"
#include "Schemes.h"

#include <CGAL/boost/graph/generators.h>

namespace {

using reference::Real;
using reference::Vector;
using test_meshes::Control_mesh;
using test_meshes::Triple;

constexpr double ulp = std::numeric_limits<double>::epsilon(); // 2^-52

// A sphere or, with an axis, a cylinder.
struct Surface
{
  Vector center = Vector::Zero();
  Real radius = 1;
  Vector axis = Vector::Zero();

  Vector from_center(const Vector& p) const
  {
    const Vector v = p - center;
    return v - v.dot(axis) * axis;
  }
};

struct Deviation
{
  double radius = 0; // relative
  double normal = 0;
  std::size_t vertices = 0;
};

Deviation deviation_from(const Surface& surface, Surface_mesh& mesh)
{
  Deviation d;
  const Normal_map normals = normal_map(mesh);
  for (auto v : mesh.vertices()) {
    const auto& p = mesh.point(v);
    const auto& n = normals[v];
    const Vector r = surface.from_center(Vector(p.x(), p.y(), p.z()));
    const double radius = double(std::abs(r.norm() / surface.radius - 1));
    const double normal = double((Vector(n.x(), n.y(), n.z()) - r / r.norm()).norm());
    if (!(radius <= d.radius)) d.radius = radius;
    if (!(normal <= d.normal)) d.normal = normal;
    ++d.vertices;
  }
  return d;
}

// --- control data ---

void shake(Control_mesh& mesh, double by, unsigned seed)
{
  std::mt19937 generator(seed);
  std::uniform_real_distribution<> noise(-by, by);
  for (Triple& p : mesh.points)
    for (double& x : p) x += noise(generator);
}

// Coordinates are rounded once, from long double.
void put_on(const Surface& surface, Control_mesh& mesh)
{
  mesh.normals.resize(mesh.points.size());
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const Vector v(mesh.points[i][0], mesh.points[i][1], mesh.points[i][2]);
    const Vector along = v.dot(surface.axis) * surface.axis;
    const Vector n = (v - along).normalized();
    const Vector p = surface.center + along + surface.radius * n;
    for (int k = 0; k < 3; ++k) {
      mesh.points[i][std::size_t(k)] = double(p[k]);
      mesh.normals[i][std::size_t(k)] = double(n[k]);
    }
  }
}

// A patch with x and y about the origin and z = height.
Control_mesh raised(Control_mesh patch, double half_width, double height)
{
  for (Triple& p : patch.points) p = {p[0] - half_width, p[1] - half_width, height};
  return patch;
}

// A patch with y as the angle about an axis and x along it.
Control_mesh rolled(const Control_mesh& patch, double radians_per_unit, const Vector& axis)
{
  const Vector u = axis.unitOrthogonal(), v = axis.cross(u);
  Control_mesh result = patch;
  for (Triple& p : result.points) {
    const Real angle = radians_per_unit * p[1];
    const Vector w = std::cos(angle) * u + std::sin(angle) * v + Real(p[0]) / 3 * axis;
    p = {double(w[0]), double(w[1]), double(w[2])};
  }
  return result;
}

std::vector<Control_mesh> irregular_patches()
{
  using namespace test_meshes;
  return {with_centers(grid(5, 5, false, false, Cells::triangles), 1),
          part_of(with_centers(grid(6, 6, false, false, Cells::triangles), 2), 3),
          in_quads(with_centers(grid(4, 4, false, false, Cells::triangles), 1)),
          part_of(in_quads(grid(5, 5, false, false, Cells::mixed)), 4),
          grid(6, 6, false, false, Cells::mixed)};
}

template <class Description>
std::vector<Control_mesh> samplings_of_sphere(const Surface& sphere)
{
  using namespace test_meshes;
  std::vector<Control_mesh> shapes{with_centers(with_centers(bipyramid(9), 2), 2),
                                   part_of(with_centers(bipyramid(11), 2), 1),
                                   bipyramid(12),
                                   in_quads(with_centers(bipyramid(4), 2)),
                                   part_of(in_quads(bipyramid(6)), 5),
                                   in_quads(bipyramid(12)),
                                   house(7),
                                   part_of(house(9), 4)};
  for (const Control_mesh& patch : irregular_patches()) shapes.push_back(raised(patch, 2.5, 3));
  std::vector<Control_mesh> result;
  unsigned seed = 0;
  for (Control_mesh& mesh : shapes) {
    if (!takes<Description>(mesh)) continue;
    shake(mesh, 0.05, ++seed);
    put_on(sphere, mesh);
    result.push_back(mesh);
  }
  return result;
}

template <class Description>
std::vector<Control_mesh> samplings_of_cylinder(const Surface& cylinder)
{
  std::vector<Control_mesh> result;
  unsigned seed = 0;
  for (const Control_mesh& patch : irregular_patches()) {
    if (!takes<Description>(patch)) continue;
    Control_mesh mesh = rolled(patch, 0.6, cylinder.axis);
    shake(mesh, 0.03, ++seed);
    put_on(cylinder, mesh);
    result.push_back(mesh);
  }
  return result;
}

// --- tests ---

// Unoptimized, the last rounds would take minutes.
#ifdef NDEBUG
constexpr unsigned rounds_left_out = 0;
#else
constexpr unsigned rounds_left_out = 2;
#endif

template <class Description>
class Reproduction : public testing::Test
{
public:
  ~Reproduction() override
  {
    std::cout << "largest radius error " << worst_.radius / ulp << ", normal error "
              << worst_.normal / ulp << " in 2^-52, " << worst_.vertices << " vertices\n";
  }

  // `offset` is that of the center, in radii: rounding of the coordinates is that much coarser.
  void check(Surface_mesh mesh, const Surface& surface, double offset, const std::string& name)
  {
    refine<Description>(mesh, Description::rounds_of_reproduction - rounds_left_out);
    const Deviation d = deviation_from(surface, mesh);
    EXPECT_LE(d.radius, (5 + 3 * offset) * ulp) << name << ": " << d.radius / ulp;
    EXPECT_LE(d.normal, (8 + 6 * offset) * ulp) << name << ": " << d.normal / ulp;
    worst_.radius = (std::max)(worst_.radius, d.radius);
    worst_.normal = (std::max)(worst_.normal, d.normal);
    worst_.vertices += d.vertices;
  }
  template <class Samplings>
  void check_all(const Surface& surface, double offset, const Samplings& samplings)
  {
    for (const Control_mesh& mesh : samplings(surface))
      check(to_surface_mesh(mesh), surface, offset, mesh.name);
  }

private:
  Deviation worst_;
};
TYPED_TEST_SUITE(Reproduction, Schemes, Scheme_names);

TYPED_TEST(Reproduction, OfSpheres)
{
  for (Real radius : {Real(1), Real(1234.5L)})
    this->check_all(Surface{Vector::Zero(), radius}, 0, samplings_of_sphere<TypeParam>);
  for (double distance : {3., 1e4})
    this->check_all(Surface{distance * Vector(2, -1, 2) / 3, 1}, distance,
                    samplings_of_sphere<TypeParam>);
}

TYPED_TEST(Reproduction, OfCylinders)
{
  for (const Vector& axis : {Vector(0, 0, 1), Vector(1, 2, 5)})
    this->check_all(Surface{Vector::Zero(), 1.5, axis.normalized()}, 0,
                    samplings_of_cylinder<TypeParam>);
  for (double distance : {3., 1e4})
    this->check_all(Surface{distance * Vector(2, 1, 2) / 3, 1, Vector(1, 2, -2) / 3}, distance,
                    samplings_of_cylinder<TypeParam>);
}

// The files name their surface in a comment.
bool read_surface(const std::string& file, Surface& surface)
{
  std::ifstream in(file);
  for (std::string line; std::getline(in, line) && line != "end_header";) {
    std::istringstream words(line);
    std::string comment, kind;
    double c[3], a[3] = {0, 0, 0}, radius;
    if (!(words >> comment >> kind) || comment != "comment") continue;
    if (kind != "sphere" && kind != "cylinder") continue;
    words >> c[0] >> c[1] >> c[2];
    if (kind == "cylinder") words >> a[0] >> a[1] >> a[2];
    words >> radius;
    surface = Surface{Vector(c[0], c[1], c[2]), radius, Vector(a[0], a[1], a[2])};
    if (kind == "cylinder") surface.axis.normalize();
    return bool(words);
  }
  return false;
}

TYPED_TEST(Reproduction, OfSampledSurfacesInData)
{
  int files = 0;
  for (const std::string& file : mesh_files::in_folder(PN_DATA_DIR)) {
    Surface surface;
    if (!read_surface(file, surface)) continue;
    const Surface_mesh mesh = mesh_files::read(file);
    if (!mesh_files::takes<TypeParam>(mesh)) continue;
    this->check(mesh, surface, 0, file);
    ++files;
  }
  EXPECT_GE(files, 2);
}

// An arc from a normal that points the other way is many edges long. On the sphere of 162 points edges are about 0.3 of the
// radius: the surface stays within about a third of one.
TEST(Reversed_normal, MovesASphereByLessThanAnEdge)
{
  for (unsigned reversed : {0u, 20u, 37u, 100u, 161u}) {
    Surface_mesh mesh;
    CGAL::make_icosahedron<Surface_mesh, Surface_mesh::Point>(mesh);
    const Normal_map normals = normal_map(mesh);
    Vector center = Vector::Zero();
    for (auto v : mesh.vertices())
      center += Vector(mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()) / 12;
    for (auto v : mesh.vertices()) {
      const auto& p = mesh.point(v);
      const Vector r = (Vector(p.x(), p.y(), p.z()) - center).normalized();
      mesh.point(v) = {double(r[0]), double(r[1]), double(r[2])};
      normals[v] = {double(r[0]), double(r[1]), double(r[2])};
    }
    const auto refine = [&](unsigned rounds) {
      CGAL::PN_subdivision_3::subdivide(
        mesh, CGAL::PN_subdivision_3::Loop_scheme(),
        CGAL::parameters::vertex_normal_map(normals).number_of_iterations(rounds));
    };
    refine(2);
    ASSERT_EQ(mesh.number_of_vertices(), 162u);
    auto& normal = normals[CGAL::SM_Vertex_index(reversed)];
    normal = -normal;
    refine(3);
    for (auto v : mesh.vertices()) {
      const double radius = std::sqrt((mesh.point(v) - CGAL::ORIGIN).squared_length());
      ASSERT_GT(radius, 0.9) << v << ", reversed at " << reversed;
      ASSERT_LT(radius, 1.02) << v << ", reversed at " << reversed;
    }
  }
}

} // namespace

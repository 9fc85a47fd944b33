// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Spheres and cylinders from points alone: no normals, no option, every scheme.

#include "Mesh_files.h"
#include "Sampled_surfaces.h"
#include "Schemes.h"

namespace {

using namespace sampled_surfaces;

using Estimate = CGAL::PN_subdivision_3::Control_normal_estimate;
constexpr double ulp = std::numeric_limits<double>::epsilon(); // 2^-52

template <class Description>
class Round_from_points : public testing::Test
{
public:
  ~Round_from_points() override
  {
    std::cout << "largest deviation " << worst_ / ulp << " in 2^-52 R\n";
  }

  // the largest deviation from the radius about `center`, measured across `axis`
  void check(Surface_mesh mesh, const Vector& center, const Vector& axis, Real radius, double bar,
             const std::string& name, Estimate estimate = Estimate::coherent)
  {
    CGAL::PN_subdivision_3::subdivide(
      mesh, CGAL::PN_subdivision_3::internal::with_normal_estimate(Description::scheme(), estimate),
      CGAL::parameters::number_of_iterations(3));
    double largest = 0;
    for (auto v : mesh.vertices()) {
      const auto& p = mesh.point(v);
      Vector d = Vector(p.x(), p.y(), p.z()) - center;
      d -= d.dot(axis) * axis;
      const double deviation = double(std::abs(d.norm() / radius - 1));
      if (!(deviation <= largest)) largest = deviation;
    }
    EXPECT_LE(largest, bar) << name << ": " << largest / ulp;
    worst_ = (std::max)(worst_, largest);
  }

private:
  double worst_ = 0;
};
TYPED_TEST_SUITE(Round_from_points, Schemes, Scheme_names);

TYPED_TEST(Round_from_points, Spheres)
{
  const auto sphere = [](const Vector& d) { return sampled_surfaces::on_sphere(d); };
  std::vector<Control_mesh> shapes{scattered(1, 0.3, 1, sphere), scattered(2, 0.3, 2, sphere)};
  for (Cells cells : {Cells::quads, Cells::triangles, Cells::mixed})
    shapes.push_back(patch(9, 7, 0.3, cells, 3, cap(0.6)));
  for (const Control_mesh& mesh : shapes)
    if (takes<TypeParam>(mesh))
      this->check(to_surface_mesh(mesh), Vector::Zero(), Vector::Zero(), 1, 64 * ulp, mesh.name);
}

TYPED_TEST(Round_from_points, CylindersWithRims)
{
  std::mt19937 generator(4);
  const Numbers u = uneven(12, 0.4, generator), v = uneven(6, 0.5, generator);
  for (Cells cells : {Cells::quads, Cells::triangles, Cells::mixed}) {
    const Control_mesh mesh = cylinder(u, v, 3, cells);
    if (takes<TypeParam>(mesh))
      this->check(to_surface_mesh(mesh), Vector::Zero(), Vector(0, 0, 1), 1, 64 * ulp, mesh.name);
  }
}

// Spheres of data/, with poor fans too; their own normals are not read. Some turn by more than 45 degrees, which
// the coherent estimate takes for edges. Scattered triangles on the cylinders there are not exact.
TYPED_TEST(Round_from_points, SpheresInData)
{
  int files = 0;
  for (const std::string& file : mesh_files::in_folder(PN_DATA_DIR)) {
    std::ifstream in(file);
    for (std::string line; std::getline(in, line) && line != "end_header";) {
      std::istringstream words(line);
      std::string comment, kind;
      double x = 0, y = 0, z = 0, radius = 0;
      if (!(words >> comment >> kind >> x >> y >> z >> radius) || comment != "comment" ||
          kind != "sphere")
        continue;
      const Surface_mesh mesh = mesh_files::read(file);
      if (!mesh_files::takes<TypeParam>(mesh)) continue;
      this->check(mesh, Vector(x, y, z), Vector::Zero(), radius, 1e-12, file, Estimate::reciprocal);
      ++files;
    }
  }
  EXPECT_GE(files, 1);
}

} // namespace

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Butterfly against OpenMesh; Kobbelt against the four-point rule on grids, and its virtual points.

#include "Scheme_runs.h"
#include "Schemes.h"

#ifdef PN_TEST_WITH_OPENMESH
#  if defined(__GNUC__) && !defined(__clang__)
#    pragma GCC diagnostic ignored "-Wmaybe-uninitialized" // OpenMesh copies fresh vectors
#  endif
#  include <OpenMesh/Core/IO/MeshIO.hh>
#  include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#  include <OpenMesh/Tools/Subdivider/Uniform/ModifiedButterFlyT.hh>
#endif

namespace {

using test_meshes::Control_mesh;

#ifdef PN_TEST_WITH_OPENMESH
struct Double_traits : OpenMesh::DefaultTraits
{
  using Point = OpenMesh::Vec3d;
};
using Open_mesh = OpenMesh::TriMesh_ArrayKernelT<Double_traits>;

Result open_mesh_butterfly(const Control_mesh& control, unsigned rounds)
{
  Open_mesh mesh;
  for (const auto& p : control.points) mesh.add_vertex(OpenMesh::Vec3d(p[0], p[1], p[2]));
  for (const reference::Face& f : control.faces)
    mesh.add_face(mesh.vertex_handle(unsigned(f[0])), mesh.vertex_handle(unsigned(f[1])),
                  mesh.vertex_handle(unsigned(f[2])));
  OpenMesh::Subdivider::Uniform::ModifiedButterflyT<Open_mesh, double> butterfly;
  butterfly.attach(mesh);
  butterfly(rounds);
  butterfly.detach(); // its destructor would call a pure virtual function
  Result result;
  for (auto v : mesh.vertices()) {
    const auto p = mesh.point(v);
    result.values.points.emplace_back(p[0], p[1], p[2]);
    result.values.normals.emplace_back(0, 0, 0);
  }
  for (auto f : mesh.faces()) {
    result.faces.emplace_back();
    for (auto v : mesh.fv_range(f)) result.faces.back().push_back(v.idx());
  }
  return result;
}

TEST(Butterfly, LinearTwinEqualsOpenMesh)
{
  double largest = 0;
  for (Control_mesh control : meshes_for<Butterfly_description>()) {
    if (test_meshes::has_isolated_vertex(control)) continue;
    control.normals.assign(control.points.size(), {0, 0, 0});
    for (unsigned rounds = 1; rounds <= 3; ++rounds) {
      Surface_mesh ours = to_surface_mesh(control);
      refine_linearly<Butterfly_description>(ours, rounds);
      const Difference d = difference(result_of(ours), open_mesh_butterfly(control, rounds));
      EXPECT_TRUE(is_within(d, 1e-13)) << control.name << ", rounds " << rounds;
      largest = (std::max)(largest, d.points);
    }
  }
  std::cout << "largest difference " << largest << '\n';
}
#endif

// One round of the four-point rule on an open polygon that is reflected at its ends.
std::vector<double> four_points(const std::vector<double>& p)
{
  const std::size_t n = p.size();
  std::vector<double> q{2 * p[0] - p[1]};
  q.insert(q.end(), p.begin(), p.end());
  q.push_back(2 * p[n - 1] - p[n - 2]);
  std::vector<double> result{p[0]};
  for (std::size_t i = 0; i + 1 < n; ++i) {
    result.push_back((9 * (q[i + 1] + q[i + 2]) - q[i] - q[i + 3]) / 16);
    result.push_back(p[i + 1]);
  }
  return result;
}

using Table = std::vector<std::vector<double>>;

Table tensor_product(const Table& rows, unsigned rounds)
{
  Table table = rows;
  for (unsigned k = 0; k < rounds; ++k)
    for (int direction = 0; direction < 2; ++direction) {
      for (auto& row : table) row = four_points(row);
      Table transposed(table[0].size(), std::vector<double>(table.size()));
      for (std::size_t i = 0; i < table.size(); ++i)
        for (std::size_t j = 0; j < table[i].size(); ++j) transposed[j][i] = table[i][j];
      table = transposed;
    }
  return table;
}

// A grid over whole numbers keeps these as x and y; its heights tell which vertex is which.
TEST(Kobbelt, IsTheTensorProductOfTheFourPointRuleOnGrids)
{
  std::mt19937 generator(4);
  std::uniform_real_distribution<> height(-1, 1);
  for (const auto& [nx, ny] : {std::pair(5, 4), std::pair(3, 7), std::pair(1, 4), std::pair(1, 1)})
    for (unsigned rounds = 1; rounds <= 3; ++rounds) {
      Control_mesh control = test_meshes::grid(nx, ny, false, false, test_meshes::Cells::quads);
      Table heights;
      for (int j = 0; j <= ny; ++j) {
        heights.emplace_back();
        for (int i = 0; i <= nx; ++i) {
          heights.back().push_back(height(generator));
          control.points[std::size_t(j * (nx + 1) + i)] = {double(i), double(j),
                                                           heights.back().back()};
        }
      }
      control.normals.assign(control.points.size(), {0, 0, 0});
      Surface_mesh mesh = to_surface_mesh(control);
      refine_linearly<Kobbelt_description>(mesh, rounds);
      const Table expected = tensor_product(heights, rounds);
      EXPECT_EQ(mesh.number_of_vertices(), expected.size() * expected[0].size());
      const double scale = double(1u << rounds);
      for (auto v : mesh.vertices()) {
        const double x = scale * mesh.point(v).x(), y = scale * mesh.point(v).y();
        EXPECT_NEAR(x, std::round(x), 1e-13);
        EXPECT_NEAR(y, std::round(y), 1e-13);
        EXPECT_NEAR(mesh.point(v).z(),
                    expected.at(std::size_t(std::lround(y))).at(std::size_t(std::lround(x))),
                    1e-13);
      }
    }
}

// Other tensions, against the reference form.
TEST(Kobbelt, TakesTheTension)
{
  for (double w : {0., 0.03, 0.1})
    for (const Control_mesh& control : meshes_for<Kobbelt_description>()) {
      Surface_mesh mesh = to_surface_mesh(control);
      const reference::Face_list list = face_list(mesh);
      Result expected = result_of(mesh);
      const reference::Refined refined = reference::kobbelt(list, w);
      expected.values = pn_round(refined.weights(list.number_of_vertices()), expected.values);
      expected.faces = refined.faces;
      CGAL::PN_subdivision_3::subdivide(mesh, CGAL::PN_subdivision_3::Kobbelt_scheme(w),
                                        CGAL::parameters::vertex_normal_map(normal_map(mesh)));
      EXPECT_TRUE(is_within(difference_by_index(result_of(mesh), expected), 1e-13)) << control.name;
    }
}

} // namespace

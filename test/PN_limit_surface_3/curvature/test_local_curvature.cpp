// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The local examples of data/ sample their surfaces, and the curvatures of the four Catmull-Clark
// schemes on them are as the manual's figures show.

#include "../../examples/PN_limit_surface_3/Extraordinary_data.h"
#include "../../examples/PN_limit_surface_3/Local_examples.h"

#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Tuned_CatmullClark_scheme.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <ostream>
#include <string>

namespace local_examples {

void PrintTo(const Local_example& example, std::ostream* out) // in the names of tests
{
  *out << example.file;
}

} // namespace local_examples

namespace {

namespace PN = CGAL::PN_subdivision_3;
namespace data = extraordinary_data;
using local_examples::Mesh;
using local_examples::Values;
using PN::CatmullClark_scheme;
using Tuned_CatmullClark_scheme = PN::CatmullClark_scheme::Tuned;
using Curvature = PN::Extraordinary_curvature<double>;

const std::string folder = PN_DATA_DIR;

bool is_named(const std::string& file, const std::string& surface)
{
  return file.compare(0, surface.size(), surface) == 0;
}

// The cubic Bernstein polynomials of x / 3, as a power basis, with the derivatives by x.
data::Height bezier(double x, double y)
{
  struct Row
  {
    double b[4], d[4];
  };
  const auto row = [](double t) {
    const double u = t / 3, v = 1 - u;
    return Row{{v * v * v, 3 * v * v * u, 3 * v * u * u, u * u * u},
               {-v * v, v * v - 2 * u * v, 2 * u * v - u * u, u * u}};
  };
  const Row a = row(x), b = row(y);
  data::Height h{0, 0, 0};
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      const double z = local_examples::bezier_heights[i][j];
      h.z += a.b[i] * b.b[j] * z;
      h.x += a.d[i] * b.b[j] * z;
      h.y += a.b[i] * b.d[j] * z;
    }
  return h;
}

class Local_curvature : public testing::TestWithParam<local_examples::Local_example>
{
protected:
  const std::string file = GetParam().file;
  Mesh mesh = local_examples::read(folder + "/" + file);
  const unsigned valence = mesh.degree(Mesh::Vertex_index(0));
  // the subdominant eigenvalue of the modified rules, by which oscillation decays from ring to ring
  const double lambda =
    std::map<unsigned, double>{{3, .5}, {5, .549988}, {6, .579682}, {7, .598510}, {8, .611117}}.at(
      valence);
  const double largest_rate = lambda + .09; // measured on rings that are not yet at the limit

  template <class Scheme>
  Curvature curvature(const Scheme& scheme) const
  {
    return local_examples::curvature(mesh, scheme);
  }
};

INSTANTIATE_TEST_SUITE_P(, Local_curvature, testing::ValuesIn(local_examples::all()),
                         [](const auto& test) {
                           return test.param.file.substr(0, test.param.file.find('.'));
                         });

double largest_curvature(const PN::Ring_curvature<double>& ring)
{
  return (std::max)(std::abs(ring.gaussian_min), std::abs(ring.gaussian_max));
}

TEST_P(Local_curvature, FileSamplesItsSurface)
{
  const auto normals = local_examples::normal_map(mesh);
  for (auto v : mesh.vertices()) {
    EXPECT_TRUE(v == Mesh::Vertex_index(0) || mesh.is_border(v) || mesh.degree(v) == 4);
    const auto& p = mesh.point(v);
    const auto& n = normals[v];
    if (is_named(file, "cylinder") && v == Mesh::Vertex_index(0)) {
      EXPECT_EQ(p, Mesh::Point(0, 0, 12));
      EXPECT_EQ(n, local_examples::Kernel::Vector_3(0, 0, 1));
    } else if (is_named(file, "cylinder")) {
      EXPECT_LE(p.z(), 10);
      EXPECT_NEAR(p.x(), 15 * n.x(), 1e-14);
      EXPECT_NEAR(p.y(), 15 * n.y(), 1e-14);
      EXPECT_NEAR(n.x() * n.x() + n.y() * n.y(), 1, 1e-15);
    } else {
      const auto value =
        data::on_graph(is_named(file, "saddle") ? data::saddle : bezier, p.x(), p.y());
      EXPECT_NEAR(p.z(), value.point[2], 1e-14);
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(n[c], value.normal[c], 1e-14);
    }
  }
}

TEST_P(Local_curvature, NetIsThatOfTheFile)
{
  const PN::Extraordinary_net net(4, valence, 2);
  const Values values = local_examples::values_around(mesh, Mesh::Vertex_index(0), net);
  const auto vertex = [&](unsigned k) {
    const auto& p = values[k].point;
    const auto found =
      std::find(mesh.points().begin(), mesh.points().end(), Mesh::Point(p[0], p[1], p[2]));
    return Mesh::Vertex_index(static_cast<unsigned>(found - mesh.points().begin()));
  };
  for (const auto& [sector, corners] : net.faces())
    for (std::size_t k = 0; k < 4; ++k) {
      const auto& [i, j] = corners[k];
      const auto& [next_i, next_j] = corners[(k + 1) % 4];
      const auto from = vertex(net.vertex(sector, i, j));
      EXPECT_NE(mesh.halfedge(from, vertex(net.vertex(sector, next_i, next_j))),
                Mesh::null_halfedge());
    }
}

// A round averages unit normals (-g, 1) / sqrt(1 + |g|^2), where g is the slope to the middle normal:
// the average of slopes but for weights that differ by a factor between 1 and sqrt(1 + G^2) <
// 1 + G^2/2, with the largest slope G. Slopes fall by lambda from round to round, which makes a
// relative error of G^2/2 / (1 - lambda^2), and the Gaussian curvature is of degree two in slopes.
TEST_P(Local_curvature, OfPNModifiedIsNearThatOfTheSampledSurface)
{
  if (!GetParam().gaussian_curvature) GTEST_SKIP() << "does not apply: no surface";
  const Tuned_CatmullClark_scheme scheme;
  const auto normals = local_examples::normal_map(mesh);
  const Mesh::Vertex_index middle(0);
  double cosine = 1;
  for (auto f : mesh.faces_around_target(mesh.halfedge(middle)))
    for (auto v : mesh.vertices_around_face(mesh.halfedge(f)))
      cosine = (std::min)(cosine, normals[middle] * normals[v]);
  const double square = 1 / (cosine * cosine) - 1; // G^2
  const Curvature c = curvature(scheme);
  EXPECT_NEAR(c.limit.gaussian / *GetParam().gaussian_curvature, 1, square / (1 - lambda * lambda));
  const double left = std::pow(largest_rate, 12) * std::abs(c.limit.gaussian);
  EXPECT_NEAR(c.rings[12].gaussian_min, c.limit.gaussian, left);
  EXPECT_NEAR(c.rings[12].gaussian_max, c.limit.gaussian, left);
}

// The principal curvatures decay by the expected rate from ring to ring.
TEST_P(Local_curvature, OfLinearModifiedVanishes)
{
  const Tuned_CatmullClark_scheme scheme;
  const Curvature c = curvature(PN::linear(scheme));
  EXPECT_NEAR(c.limit.gaussian, 0, 1e-14);
  EXPECT_LE(largest_curvature(c.rings[12]),
            std::pow(largest_rate, 2 * 8) * largest_curvature(c.rings[4]));
}

TEST_P(Local_curvature, OfThePlainSchemesDoesNotSettle)
{
  if (valence < 5) GTEST_SKIP() << "does not apply: only from valence 5 on";
  const Tuned_CatmullClark_scheme scheme;
  const CatmullClark_scheme plain;
  // by rates of more than 1.05 against less than 0.7 twelve times, which is 129 at equal amplitudes
  EXPECT_GE(curvature(plain).rings[12].oscillation(),
            10 * curvature(scheme).rings[12].oscillation());
  // with the plain linear scheme principal curvatures grow by more than 1.124, thus K by 4 in 6 rings
  const Curvature linear = curvature(PN::linear(plain));
  EXPECT_GE(largest_curvature(linear.rings[12]), 2 * largest_curvature(linear.rings[6]));
}

// K at the vertex of a surface sampled with steps of 0.12 `size` about (x, y).
double gaussian_at_vertex(const data::Graph& graph, double x, double y, unsigned valence,
                          double size)
{
  const PN::Extraordinary_vertex_zoom<Tuned_CatmullClark_scheme> zoom(Tuned_CatmullClark_scheme(),
                                                                      valence);
  const auto scaled = [&](double u, double v) {
    const data::Height h = graph(x + size * u, y + size * v);
    return data::Height{h.z / size, h.x, h.y};
  };
  return zoom.measure(data::sampled(zoom.net(), scaled)).limit.gaussian / (size * size);
}

// The relative error is of second order in the size, and what is left after extrapolation of fourth:
// like its square. (For the Bezier patch at valence 3, where slopes quadratic in x and y are not
// orthogonal to linear ones, the order is one less.)
TEST(Local_curvature_order, OfPNModifiedIsTwo)
{
  const auto check = [](const data::Graph& graph, double middle, unsigned valence, double exact) {
    SCOPED_TRACE(valence);
    const double coarse = gaussian_at_vertex(graph, middle, middle, valence, 1) / exact - 1;
    const double fine = gaussian_at_vertex(graph, middle, middle, valence, .5) / exact - 1;
    EXPECT_GE(std::abs(coarse), 3.5 * std::abs(fine));
    EXPECT_LE(std::abs(coarse), 4.5 * std::abs(fine));
    EXPECT_NEAR((4 * fine - coarse) / 3, 0, coarse * coarse);
  };
  for (unsigned valence : {3, 5, 6, 7, 8, 12}) check(data::saddle, 0, valence, -4);
  for (unsigned valence : {5, 6, 7, 8, 12})
    check(bezier, 1.5, valence, local_examples::gaussian_curvature_of_bezier());
}

} // namespace

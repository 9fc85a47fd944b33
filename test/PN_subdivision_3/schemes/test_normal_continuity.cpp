// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Normal continuity at extraordinary points, measured: the normals of the faces about such a point
// draw together as the net is refined (Yang, Theorem 4.9).

#include "analysis/Extraordinary_net.h"

#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
#include <CGAL/PN_subdivision_3/parameters/parameters.h>
#include <CGAL/PN_subdivision_3/schemes/Butterfly_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/DooSabin_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Kobbelt_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Sqrt3_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Tuned_CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Tuned_Loop_scheme.h>
#include <CGAL/PN_subdivision_3/subdivide.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

namespace {

namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;
using Face = Mesh::Face_index;
using Normals = Mesh::Property_map<Vertex, Vector>;

struct Net
{
  Mesh mesh;
  Normals normals;
  Net()
    : normals(mesh.add_property_map<Vertex, Vector>("n").first)
  {}
};

// An uneven, bent net, whose normals are tilted by up to 0.4.
void make_net(Net& net, unsigned degree, unsigned valence, unsigned rings)
{
  std::mt19937 generator(valence);
  std::uniform_real_distribution<> noise(-0.2, 0.2);
  const PN::Extraordinary_net shape(degree, valence, rings);
  for (unsigned v = 0; v < shape.number_of_vertices(); ++v) {
    const auto [s, i, j] = shape.place(v);
    const double sector = 2 * std::acos(-1.) / valence;
    const double x = i * std::cos(s * sector) + j * std::cos((s + 1) * sector) + noise(generator);
    const double y = i * std::sin(s * sector) + j * std::sin((s + 1) * sector) + noise(generator);
    const double z = 0.1 * x * x - 0.15 * x * y + noise(generator);
    const Vertex w = net.mesh.add_vertex(Point(x, y, z));
    net.normals[w] =
      Vector(2 * noise(generator) - 0.2 * x + 0.15 * y, 2 * noise(generator) + 0.15 * x, 1);
  }
  for (const auto& f : shape.faces()) {
    std::vector<Vertex> corners;
    for (const auto& [i, j] : f.corners) corners.push_back(Vertex(shape.vertex(f.sector, i, j)));
    CGAL::Euler::add_face(corners, net.mesh);
  }
}

// faces that share a vertex with the given ones
std::set<Face> grown(const Mesh& mesh, const std::set<Face>& faces)
{
  std::set<Face> result = faces;
  for (Face f : faces)
    for (Vertex v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
      for (Face g : CGAL::faces_around_target(mesh.halfedge(v), mesh))
        if (g != Mesh::null_face()) result.insert(g);
  return result;
}

// The middle is a vertex, always vertex 0; with dual schemes a face, which is face 0 after a crop().
std::set<Face> around_vertex(const Mesh& mesh)
{
  std::set<Face> faces;
  for (Face f : CGAL::faces_around_target(mesh.halfedge(Vertex(0)), mesh)) faces.insert(f);
  return faces;
}

// Keeps `rings` rings of faces about the middle, moved to the origin and scaled to the size 1.
void crop(Net& net, std::set<Face> faces, int rings)
{
  std::vector<Face> order(faces.begin(), faces.end());
  const bool is_face = order.size() == 1;
  for (int i = 0; i < rings; ++i) faces = grown(net.mesh, faces);
  for (Face f : faces)
    if (f != order[0]) order.push_back(f);
  if (!is_face) order.assign(faces.begin(), faces.end());

  const Point middle =
    net.mesh.point(is_face ? net.mesh.target(net.mesh.halfedge(order[0])) : Vertex(0));
  double size = 0;
  for (Face f : order)
    for (Vertex v : CGAL::vertices_around_face(net.mesh.halfedge(f), net.mesh))
      size = (std::max)(size, std::sqrt((net.mesh.point(v) - middle).squared_length()));
  Net small;
  std::map<Vertex, Vertex> copies;
  const auto copy = [&](Vertex v) {
    const auto [entry, is_new] = copies.emplace(v, Vertex());
    if (!is_new) return entry->second;
    entry->second = small.mesh.add_vertex(CGAL::ORIGIN + (net.mesh.point(v) - middle) / size);
    small.normals[entry->second] = net.normals[v];
    return entry->second;
  };
  if (!is_face) copy(Vertex(0));
  for (Face f : order) {
    std::vector<Vertex> corners;
    for (Vertex v : CGAL::vertices_around_face(net.mesh.halfedge(f), net.mesh))
      corners.push_back(copy(v));
    CGAL::Euler::add_face(corners, small.mesh);
  }
  net.mesh = small.mesh;
  net.normals = PN::internal::find_property_map<Vertex, Vector>(net.mesh, "n").value();
}

Vector area_vector(const Mesh& mesh, Face f)
{
  Vector sum(0, 0, 0);
  for (auto h : CGAL::halfedges_around_face(mesh.halfedge(f), mesh))
    sum += CGAL::cross_product(mesh.point(mesh.source(h)) - CGAL::ORIGIN,
                               mesh.point(mesh.target(h)) - CGAL::ORIGIN);
  return sum / std::sqrt(sum.squared_length());
}

// the largest angle between two normals of these faces and those about them
double spread(const Mesh& mesh, const std::set<Face>& faces)
{
  std::vector<Vector> normals;
  for (Face f : grown(mesh, faces)) normals.push_back(area_vector(mesh, f));
  double largest = 0;
  for (const Vector& a : normals)
    for (const Vector& b : normals) {
      const double sine = std::sqrt(CGAL::cross_product(a, b).squared_length());
      largest = (std::max)(largest, a * b > 0 ? std::asin((std::min)(1., sine)) : 2.);
    }
  return largest;
}

template <class Scheme>
double spread_after(unsigned rounds, const Scheme& scheme, unsigned degree, unsigned valence)
{
  constexpr bool is_face = !Scheme::Host::keeps_vertices;
  Net net;
  make_net(net, degree, valence, 6);
  std::set<Face> middle;
  for (unsigned k = 1; k <= rounds; ++k) {
    PN::subdivide(net.mesh, scheme, params::vertex_normal_map(net.normals));
    if (is_face && k == 1)
      middle = {*std::find_if(net.mesh.faces().begin(), net.mesh.faces().end(),
                              [&](Face f) { return net.mesh.degree(f) == valence; })};
    else
      middle = is_face ? std::set<Face>{Face(0)} : around_vertex(net.mesh);
    crop(net, middle, 4);
    middle = is_face ? std::set<Face>{Face(0)} : around_vertex(net.mesh);
  }
  return spread(net.mesh, middle);
}

// Ten rounds draw the normals together by (mu / lambda)^10 where the surface is linear, with the
// subdominant eigenvalue lambda and the next one mu; the slowest, Kobbelt's at valence 12, by 0.21.
template <class Scheme>
void expect_normals_to_converge(const Scheme& scheme, unsigned degree)
{
  const double factor = 0.3;
  for (const unsigned valence : {3u, 5u, 6u, 8u, 12u}) {
    const double early = spread_after(4, scheme, degree, valence);
    const double late = spread_after(14, scheme, degree, valence);
    EXPECT_LT(late, factor * early)
      << scheme.name() << ", valence " << valence << ": " << early << " to " << late;
  }
}

} // namespace

TEST(Normal_continuity, OfAllSchemes)
{
  expect_normals_to_converge(PN::CatmullClark_scheme(), 4);
  expect_normals_to_converge(PN::CatmullClark_scheme::Tuned(), 4);
  expect_normals_to_converge(PN::Kobbelt_scheme(), 4);
  expect_normals_to_converge(PN::DooSabin_scheme(), 4);
  expect_normals_to_converge(PN::Loop_scheme(), 3);
  expect_normals_to_converge(PN::Loop_scheme::Tuned(), 3);
  expect_normals_to_converge(PN::Butterfly_scheme(), 3);
  expect_normals_to_converge(PN::Sqrt3_scheme(), 3);
}

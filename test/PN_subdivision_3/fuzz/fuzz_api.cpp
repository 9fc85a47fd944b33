// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
// Polygon soups of any bytes, as meshes, through the functions of the package. What must hold: the result is a
// valid manifold with finite points and unit or zero normals, or an exception with a message is thrown and the
// mesh is as it was. Sanitizers watch the rest.

#include <CGAL/PN_limit_surface_3/limit_points.h>
#include <CGAL/PN_subdivision_3.h>
#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace PN = CGAL::PN_subdivision_3;
namespace np = CGAL::parameters;
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;

void fail(const std::string& what)
{
  std::fprintf(stderr, "fuzz_api: %s\n", what.c_str());
  std::abort();
}

// Zeros when it has come to its end.
class Bytes
{
public:
  Bytes(const std::uint8_t* data, std::size_t size)
    : data_(data)
    , end_(data + size)
  {}
  bool is_at_end() const { return data_ == end_; }
  unsigned next() { return is_at_end() ? 0 : *data_++; }
  // mostly small numbers, now and then one that tries the limits
  double coordinate()
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr double limits[] = {infinity, NAN, 1e308, -1e308, 5e-324, 1e-160, 1e160, -0.};
    const unsigned b = next();
    return b >= 248 ? limits[b - 248] : (double(b) - 124) / 16;
  }

private:
  const std::uint8_t *data_, *end_;
};

struct Input
{
  Mesh mesh;
  Mesh::Property_map<Vertex, Vector> normals;
  Mesh::Property_map<Mesh::Edge_index, double> creases;
};

Input input_of(Bytes& bytes)
{
  Input in;
  in.normals = in.mesh.add_property_map<Vertex, Vector>("v:normal", CGAL::NULL_VECTOR).first;
  in.creases = in.mesh.add_property_map<Mesh::Edge_index, double>("e:crease", 0.).first;
  const unsigned number = bytes.next() % 24;
  const bool has_normals = bytes.next() % 2 == 0;
  for (unsigned i = 0; i < number; ++i) {
    const double x = bytes.coordinate(), y = bytes.coordinate(), z = bytes.coordinate();
    const Vertex v = in.mesh.add_vertex(Point(x, y, z));
    if (!has_normals) continue;
    const double nx = bytes.coordinate(), ny = bytes.coordinate(), nz = bytes.coordinate();
    in.normals[v] = Vector(nx, ny, nz);
  }
  while (!bytes.is_at_end() && in.mesh.number_of_faces() < 40) {
    std::vector<Vertex> face;
    for (unsigned i = bytes.next() % 5 + 3; i > 0 && number > 0; --i) {
      const Vertex v(bytes.next() % number);
      if (std::find(face.begin(), face.end(), v) == face.end()) face.push_back(v);
    }
    if (face.size() >= 3 && CGAL::Euler::can_add_face(face, in.mesh)) in.mesh.add_face(face);
  }
  return in;
}

bool is_same(const Vector& a, const Vector& b)
{
  const auto is_equal = [](double x, double y) {
    return x == y || (std::isnan(x) && std::isnan(y));
  };
  return is_equal(a.x(), b.x()) && is_equal(a.y(), b.y()) && is_equal(a.z(), b.z());
}

auto normals_of(const Mesh& mesh)
{
  return PN::internal::find_property_map<Vertex, Vector>(mesh, "v:normal").value();
}

void require_untouched(const Mesh& a, const Mesh& b)
{
  const auto na = normals_of(a);
  const auto nb = normals_of(b);
  if (a.num_vertices() != b.num_vertices() || a.num_halfedges() != b.num_halfedges() ||
      a.num_faces() != b.num_faces())
    fail("elements were added to a mesh that was refused");
  for (Vertex v : a.vertices())
    if (!is_same(a.point(v) - CGAL::ORIGIN, b.point(v) - CGAL::ORIGIN) || !is_same(na[v], nb[v]) ||
        a.halfedge(v) != b.halfedge(v))
      fail("vertex " + std::to_string(v) + " of a mesh that was refused was changed");
  for (auto h : a.halfedges())
    if (a.next(h) != b.next(h) || a.target(h) != b.target(h) || a.face(h) != b.face(h))
      fail("a mesh that was refused was changed");
}

void require_valid(const Mesh& mesh, bool has_normals)
{
  const auto normals = normals_of(mesh);
  if (!mesh.is_valid(false)) fail("the result is no valid mesh");
  for (Vertex v : mesh.vertices()) {
    const Point& p = mesh.point(v);
    if (!std::isfinite(p.x()) || !std::isfinite(p.y()) || !std::isfinite(p.z()))
      fail("vertex " + std::to_string(v) + " of the result is not finite");
    const double length = normals[v].squared_length();
    if (has_normals && length != 0 && !(std::abs(length - 1) < 1e-10))
      fail("normal " + std::to_string(v) + " of the result is no unit vector");
  }
}

template <class Scheme>
void subdivide(const Input& in, const Scheme& scheme, unsigned how)
{
  Mesh mesh = in.mesh;
  const auto normals = normals_of(mesh);
  const auto creases =
    PN::internal::find_property_map<Mesh::Edge_index, double>(mesh, "e:crease").value();
  const unsigned rounds = 1 + how / 4 % 2;
  try {
    const auto iterations = np::number_of_iterations(rounds);
    if (how % 4 == 0)
      PN::subdivide(mesh, PN::linear(scheme), iterations);
    else if (how % 4 == 1)
      PN::subdivide(mesh, scheme, iterations); // estimated normals
    else if (how % 4 == 2)
      PN::subdivide(mesh, scheme, iterations.vertex_normal_map(normals));
    else if constexpr (PN::internal::Has_crease_rules<Scheme>::value) {
      unsigned i = 0;
      for (auto e : mesh.edges()) creases[e] = (how >> (i++ % 5)) & 4 ? 1.5 : 0;
      PN::subdivide(mesh, scheme, iterations.edge_is_constrained_map(creases));
    } else
      return; // no rules for creases
  } catch (const std::exception& e) {
    if (std::string(e.what()).empty()) fail("an exception without a message");
    require_untouched(mesh, in.mesh);
    return;
  }
  require_valid(mesh, how % 4 == 2);
}

void limit(const Input& in)
{
  Mesh mesh = in.mesh;
  const auto map = mesh.add_property_map<Vertex, PN::Limit_point<Kernel>>("v:limit").first;
  try {
    PN::limit_points(mesh, PN::CatmullClark_scheme(), map, PN::parameters::max_depth(4u));
  } catch (const std::exception& e) {
    if (std::string(e.what()).empty()) fail("an exception without a message");
    return;
  }
  for (Vertex v : mesh.vertices())
    if (!std::isfinite(map[v].point.x())) fail("a limit point is not finite");
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  Bytes bytes(data, size);
  const unsigned scheme = bytes.next(), how = bytes.next();
  const Input in = input_of(bytes);
  switch (scheme % 8) {
  case 0:
    subdivide(in, PN::CatmullClark_scheme(), how);
    break;
  case 1:
    subdivide(in, PN::Loop_scheme(), how);
    break;
  case 2:
    subdivide(in, PN::DooSabin_scheme(), how);
    break;
  case 3:
    subdivide(in, PN::Sqrt3_scheme(), how);
    break;
  case 4:
    subdivide(in, PN::Butterfly_scheme(), how);
    break;
  case 5:
    subdivide(in, PN::Kobbelt_scheme(), how);
    break;
  case 6:
    subdivide(in, PN::Loop_scheme::Tuned(), how);
    break;
  default:
    limit(in);
  }
  return 0;
}

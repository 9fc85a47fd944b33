// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
// Digests of what every scheme makes of a few meshes: two platforms that print the same have the same bits.
// No library is linked, so that it can be cross compiled: scripts/check_portability.sh.

#include <CGAL/PN_subdivision_3.h>
#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <vector>

namespace {

namespace PN = CGAL::PN_subdivision_3;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Vector = Kernel::Vector_3;

class Digest // FNV-1a
{
public:
  void add(double x)
  {
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof(bits));
    for (int i = 0; i < 8; ++i) {
      value_ = (value_ ^ (bits & 255)) * 1099511628211u;
      bits >>= 8;
    }
  }
  std::uint64_t value() const { return value_; }

private:
  std::uint64_t value_ = 14695981039346656037u;
};

// A bipyramid, or quads between two poles; with rational coordinates, the same everywhere.
Mesh poles(int n, bool triangles)
{
  Mesh mesh;
  const auto normals = mesh.add_property_map<Vertex, Vector>("v:normal", CGAL::NULL_VECTOR).first;
  const auto add = [&](double x, double y, double z) {
    const Vertex v = mesh.add_vertex(Kernel::Point_3(x, y, z));
    const double length = std::sqrt(x * x + y * y + z * z);
    normals[v] = Vector(x / length, y / length, z / length);
    return v;
  };
  const int m = triangles ? n : 2 * n;
  std::vector<Vertex> ring;
  for (int i = 0; i < m; ++i) { // the rational parametrization of the circle
    const double t = double(2 * i - m + 1) / m * 1.5, d = 1 + t * t;
    ring.push_back(add((1 - t * t) / d, 2 * t / d, i % 2 == 0 ? 0.25 : -0.125));
  }
  const Vertex top = add(0.125, 0, 1.25), bottom = add(0, 0.0625, -1.5);
  for (int i = 0; i < m; i += triangles ? 1 : 2) {
    const Vertex a = ring[std::size_t(i)], b = ring[std::size_t((i + 1) % m)];
    if (triangles) {
      mesh.add_face(a, b, top);
      mesh.add_face(b, a, bottom);
    } else {
      const Vertex c = ring[std::size_t((i + 2) % m)], d = ring[std::size_t((i + 3) % m)];
      mesh.add_face(top, a, b, c);
      mesh.add_face(bottom, d, c, b);
    }
  }
  return mesh;
}

template <class Scheme>
std::uint64_t digest(int n, bool triangles)
{
  Mesh mesh = poles(n, triangles);
  const auto normals = PN::internal::find_property_map<Vertex, Vector>(mesh, "v:normal").value();
  PN::subdivide(mesh, Scheme(),
                CGAL::parameters::number_of_iterations(2).vertex_normal_map(normals));
  Digest digest;
  for (Vertex v : mesh.vertices()) {
    const auto& p = mesh.point(v);
    const auto& q = normals[v];
    for (double x : {p.x(), p.y(), p.z(), q.x(), q.y(), q.z()}) digest.add(x);
  }
  return digest.value();
}

} // namespace

int main()
{
  PN::for_each_shipped_scheme([](auto scheme) {
    using Scheme = decltype(scheme);
    const bool triangles = std::is_same_v<typename Scheme::Host, PN::PTQ_host> ||
                           std::is_same_v<typename Scheme::Host, PN::Sqrt3_host>;
    for (int n : {3, 4, 5, 6, 7, 9, 12, 30, 53})
      std::printf("%-24s %2d %016llx\n", Scheme::name(), n,
                  static_cast<unsigned long long>(digest<Scheme>(n, triangles)));
  });
}

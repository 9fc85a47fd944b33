// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Attributes in floating point: every type of values, charts and seams, copies, tables, several threads, and what is
// refused.

#include "Mesh_cases.h"
#include "Messages.h"
#include "Turns.h"
#include "support/Options.h"

#include <CGAL/IO/Color.h>
#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#include <CGAL/PN_subdivision_3/schemes/Butterfly_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/DooSabin_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Kobbelt_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Sqrt3_scheme.h>
#include <CGAL/PN_subdivision_3/subdivide.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/Core>

#include <cstdint>
#include <cstring>
#include <limits>
#include <set>
#include <tuple>
#include <utility>

namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;
using namespace mesh_cases;

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using V = Mesh::Vertex_index;
using H = Mesh::Halfedge_index;

template <class Key, class T>
auto add(Mesh& mesh, const char* name, const T& value = T())
{
  return mesh.add_property_map<Key, T>(name, value).first;
}

// a type of the user's with + and a product only
struct Load
{
  double force = 0, mass = 0;
  friend Load operator+(const Load& a, const Load& b)
  {
    return {a.force + b.force, a.mass + b.mass};
  }
  friend Load operator*(double w, const Load& a) { return {w * a.force, w * a.mass}; }
};

double ulps(double a, double b, double size)
{
  return std::abs(a - b) / (size * std::numeric_limits<double>::epsilon());
}

double linear_function(const Kernel::Point_3& p)
{
  return 0.3 * p.x() - 0.7 * p.y() + 1.1 * p.z() + 0.1;
}

TEST(Attributes, ConstantsKeepTheirBits)
{
  const double inf = std::numeric_limits<double>::infinity();
  for (const double value : {0.1, -0.0, 1e308, 5e-324, inf, std::nan("")}) {
    Mesh mesh = built<Mesh>(mixed_with_border());
    auto t = add<V, double>(mesh, "t", value);
    auto f = add<V, float>(mesh, "f", float(value));
    auto l = add<V, Load>(mesh, "l", {0.1, 7});
    auto u = add<H, double>(mesh, "u", value);
    PN::subdivide(mesh, PN::CatmullClark_scheme(),
                  PN::parameters::attributes(
                    PN::parameters::vertex_attribute(t), PN::parameters::vertex_attribute(f),
                    PN::parameters::vertex_attribute(l), PN::parameters::corner_attribute(u))
                    .number_of_iterations(3));
    const auto same = [](auto a, auto b) {
      return std::memcmp(&a, &b, sizeof a) == 0 || (std::isnan(a) && std::isnan(b));
    };
    for (auto v : mesh.vertices()) {
      EXPECT_TRUE(same(t[v], value)) << t[v] << " " << value;
      EXPECT_TRUE(same(f[v], float(value)));
      EXPECT_TRUE(same(l[v].force, 0.1));
    }
    for (auto h : mesh.halfedges())
      if (!mesh.is_border(h)) {
        EXPECT_TRUE(same(u[h], value)) << u[h] << " " << value;
      }
  }
}

TEST(Attributes, LinearFunctionsStayToFourUlp)
{
  Mesh mesh = built<Mesh>(mixed_with_border());
  auto t = add<V, double>(mesh, "t");
  double size = 0;
  for (auto v : mesh.vertices()) {
    t[v] = linear_function(mesh.point(v));
    size = std::max(size, std::abs(t[v]));
  }
  PN::subdivide(
    mesh, PN::linear(PN::CatmullClark_scheme()),
    PN::parameters::attributes(PN::parameters::vertex_attribute(t)).number_of_iterations(4));
  for (auto v : mesh.vertices()) EXPECT_LE(ulps(t[v], linear_function(mesh.point(v)), size), 4);
}

// All types say what the coordinates of the points, which are refined by the same rows, say.
TEST(Attributes, OfEveryType)
{
  Mesh mesh = built<Mesh>(cube());
  auto f = add<V, float>(mesh, "f");
  auto a = add<V, std::array<float, 2>>(mesh, "a");
  auto e = add<V, Eigen::Vector3d>(mesh, "e", Eigen::Vector3d(0, 0, 0));
  auto p = add<V, Kernel::Point_2>(mesh, "p");
  auto w = add<V, Kernel::Vector_3>(mesh, "w", CGAL::NULL_VECTOR);
  auto l = add<V, Load>(mesh, "l");
  auto i = add<V, std::array<int, 1>>(mesh, "i");
  auto b = add<V, std::array<std::uint8_t, 1>>(mesh, "b");
  auto c = add<V, CGAL::IO::Color>(mesh, "c");
  for (auto v : mesh.vertices()) {
    const auto& q = mesh.point(v);
    const int level = int(v.idx());
    f[v] = float(q.x());
    a[v] = {float(q.x()), float(q.y())};
    e[v] = Eigen::Vector3d(q.x(), q.y(), q.z());
    p[v] = {q.x(), q.y()};
    w[v] = q - CGAL::ORIGIN;
    l[v] = {q.x(), q.y()};
    i[v] = {int(1000 * q.x())};
    b[v] = {std::uint8_t(level % 2 == 0 ? 255 : 0)};
    c[v] = CGAL::IO::Color((unsigned char)(q.x() > 0 ? 255 : 0), 7, 255, 0);
  }
  // Kobbelt's weights are negative, too: values beyond the greatest are cut off
  PN::subdivide(
    mesh, PN::linear(PN::Kobbelt_scheme()),
    PN::parameters::join(PN::parameters::attributes(
                           PN::parameters::vertex_attribute(f), PN::parameters::vertex_attribute(a),
                           PN::parameters::vertex_attribute(e), PN::parameters::vertex_attribute(p),
                           PN::parameters::vertex_attribute(w), PN::parameters::vertex_attribute(l),
                           PN::parameters::vertex_attribute(i), PN::parameters::vertex_attribute(b),
                           PN::parameters::vertex_attribute(c)),
                         params::number_of_iterations(2)));
  bool has_overshoot = false;
  for (auto v : mesh.vertices()) {
    const auto& q = mesh.point(v);
    const auto near = [](double x, double y) { return std::abs(x - y) < 1e-14; };
    EXPECT_FLOAT_EQ(f[v], float(q.x()));
    EXPECT_FLOAT_EQ(a[v][1], float(q.y()));
    EXPECT_TRUE(near(e[v].x(), q.x()) && near(e[v].y(), q.y()) && near(e[v].z(), q.z()));
    EXPECT_TRUE(near(p[v].x(), q.x()) && near(p[v].y(), q.y()));
    EXPECT_TRUE(near(w[v].x(), q.x()) && near(w[v].z(), q.z()));
    EXPECT_TRUE(near(l[v].force, q.x()) && near(l[v].mass, q.y()));
    EXPECT_NEAR(i[v][0], 1000 * q.x(), 0.5 + 1e-9);
    const double red = 255 * (q.x() + 1) / 2;
    has_overshoot = has_overshoot || red > 255.5 || red < -0.5;
    EXPECT_NEAR(c[v].red(), std::min(255., std::max(0., red)), 0.5 + 1e-9);
    EXPECT_EQ(c[v].green(), 7);
    EXPECT_EQ(c[v].blue(), 255);
    EXPECT_EQ(c[v].alpha(), 0);
  }
  EXPECT_TRUE(has_overshoot);
  EXPECT_EQ(b[V(0)][0], 255);
}

// One number each, in rows of one length, but with differences of their own: between 0.1 and 0.9 of a turn is 0.
TEST(Attributes, NumbersAreAveragedByTheirOwnDifferences)
{
  Mesh mesh;
  build(cube(), mesh, mesh.points());
  const auto turns = add<V, Turns>(mesh, "v:turns");
  for (const V v : mesh.vertices()) turns[v].part = v.idx() % 2 == 0 ? 0.1 : 0.9;
  PN::subdivide(mesh, PN::CatmullClark_scheme(),
                PN::parameters::attributes(PN::parameters::vertex_attribute(turns)));
  for (const V v : mesh.vertices())
    EXPECT_LE(std::abs(turns[v].part - std::round(turns[v].part)), 0.1 + 1e-15) << v;
}

TEST(Attributes, FacesAndEdgesInherit)
{
  Mesh mesh = built<Mesh>(mixed_with_border());
  auto patch = add<Mesh::Face_index, std::string>(mesh, "patch");
  auto mark = add<Mesh::Edge_index, bool>(mesh, "mark", false);
  auto parent = add<Mesh::Face_index, int>(mesh, "parent");
  for (auto f : mesh.faces()) patch[f] = "patch " + std::to_string(f.idx());
  std::size_t marks = 0;
  for (auto e : mesh.edges())
    if (e.idx() % 3 == 0) {
      mark[e] = true;
      ++marks;
    }
  PN::subdivide(mesh, PN::linear(PN::CatmullClark_scheme()),
                PN::parameters::attributes(PN::parameters::face_attribute(patch),
                                           PN::parameters::edge_attribute(mark),
                                           PN::parameters::face_parents(parent))
                  .number_of_iterations(2));
  std::size_t halves = 0;
  for (auto e : mesh.edges()) halves += mark[e];
  EXPECT_EQ(halves, 4 * marks);
  for (auto f : mesh.faces()) EXPECT_EQ(patch[f], "patch " + std::to_string(parent[f]));
}

// \name Charts

using Uv = std::array<double, 2>;

// a value for each corner of a soup: by face and position in the face
struct Charts
{
  Soup soup;
  std::vector<std::vector<Uv>> uv;
};

// a grid with several charts: three that meet in a point, one of a single face, and slits that end inside;
// of quads with two triangles, of quads or of triangles
Charts charts_of_grid(bool triangles, bool some_triangles = true)
{
  const std::size_t n = 6;
  Charts c;
  for (std::size_t i = 0; i <= n; ++i)
    for (std::size_t j = 0; j <= n; ++j)
      c.soup.points.push_back({double(i), double(j), std::sin(double(i + 2 * j))});
  const auto v = [&](std::size_t i, std::size_t j) { return i * (n + 1) + j; };
  const auto add_face = [&](const Polygon& f, std::size_t i, std::size_t j) {
    const int chart = i == 1 && j == 1 ? 3 : i < 3 ? 0 : j < 2 ? 1 : 2;
    c.soup.faces.push_back(f);
    c.uv.emplace_back();
    for (const std::size_t k : f) {
      const double x = double(k / (n + 1)), y = double(k % (n + 1));
      Uv uv{x + 0.2 * y * y + 20 * chart, y + 0.1 * x * y};
      // the slit along x = 5 from y = 6 down to y = 4, where it ends
      if (i == 5 && x == 5 && y > 4) uv[0] += 3 * (y - 4);
      if (i == 5 && x == 5 && y < 1) uv[0] -= 3; // and from y = 0 up to y = 1
      c.uv.back().push_back(uv);
    }
  };
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      const Polygon f{v(i, j), v(i + 1, j), v(i + 1, j + 1), v(i, j + 1)};
      if (triangles) {
        add_face({f[0], f[1], f[2]}, i, j);
        add_face({f[0], f[2], f[3]}, i, j);
      } else if (some_triangles && i == 4 && j == 3) { // other polygons
        add_face({f[0], f[1], f[2]}, i, j);
        add_face({f[0], f[2], f[3]}, i, j);
      } else
        add_face(f, i, j);
    }
  return c;
}

// the half-edge of the mesh's face that leads to a vertex
H corner(const Mesh& mesh, Mesh::Face_index f, std::size_t vertex)
{
  for (auto h : mesh.halfedges_around_face(mesh.halfedge(f)))
    if (mesh.target(h).idx() == vertex) return h;
  return Mesh::null_halfedge();
}

template <class Map>
void put_uv(const Charts& c, const Mesh& mesh, Map uv)
{
  for (auto f : mesh.faces())
    for (std::size_t i = 0; i < c.soup.faces[f.idx()].size(); ++i)
      uv[corner(mesh, f, c.soup.faces[f.idx()][i])] = c.uv[f.idx()][i];
}

// The charts as a surface of their own in the plane: the mesh cut open, with the vertices that are to stay.
struct Cut_open
{
  explicit Cut_open(const Charts& c)
  {
    Soup soup;
    std::map<std::pair<std::size_t, Uv>, std::size_t> number;
    std::vector<std::size_t> origin;
    for (std::size_t f = 0; f < c.soup.faces.size(); ++f) {
      soup.faces.emplace_back();
      for (std::size_t i = 0; i < c.soup.faces[f].size(); ++i) {
        const Uv uv = c.uv[f][i];
        const auto [it, is_new] = number.try_emplace({c.soup.faces[f][i], uv}, soup.points.size());
        if (is_new) {
          soup.points.push_back({uv[0], uv[1], 0});
          origin.push_back(c.soup.faces[f][i]);
        }
        soup.faces.back().push_back(it->second);
      }
    }
    build(soup, mesh);
    std::map<std::size_t, int> charts; // at vertices of the uncut surface
    for (const std::size_t v : origin) ++charts[v];
    stays = mesh.add_property_map<V, bool>("stays", false).first;
    for (auto v : mesh.vertices()) stays[v] = charts[origin[v.idx()]] > 2;
  }

  Mesh mesh;
  Mesh::Property_map<V, bool> stays;
};

// The faces as polygons in the plane, from their least corner on, in units of 1e-7. Nothing is near the bounds of
// rounding: coordinates are multiples of 1 / (10 2^n).
template <class Uv_of>
std::multiset<std::vector<std::pair<long, long>>> polygons(const Mesh& mesh, const Uv_of& uv_of)
{
  std::multiset<std::vector<std::pair<long, long>>> result;
  for (auto f : mesh.faces()) {
    std::vector<std::pair<long, long>> p;
    for (auto h : mesh.halfedges_around_face(mesh.halfedge(f))) {
      const Uv uv = uv_of(h);
      p.emplace_back(std::lround(1e7 * uv[0] + 0.3), std::lround(1e7 * uv[1] + 0.3));
    }
    std::rotate(p.begin(), std::min_element(p.begin(), p.end()), p.end());
    result.insert(p);
  }
  return result;
}

template <class Scheme>
class Chart_attributes : public ::testing::Test
{};
using Chart_schemes = ::testing::Types<PN::CatmullClark_scheme, PN::Loop_scheme,
                                       PN::Butterfly_scheme, PN::Kobbelt_scheme>;
TYPED_TEST_SUITE(Chart_attributes, Chart_schemes, );

// Charts are refined as if they were surfaces in the plane, with corners where they have one face, or three meet.
TYPED_TEST(Chart_attributes, AreThoseOfTheMeshCutOpen)
{
  constexpr bool creases = std::is_same_v<TypeParam, PN::CatmullClark_scheme> ||
                           std::is_same_v<TypeParam, PN::Loop_scheme>;
  const Charts c = charts_of_grid(TypeParam::Host::refined_degree == 3,
                                  !std::is_same_v<TypeParam, PN::Kobbelt_scheme>);
  Mesh mesh = built<Mesh>(c.soup);
  auto uv = add<H, Uv>(mesh, "uv");
  put_uv(c, mesh, uv);
  EXPECT_TRUE(PN::has_seam(mesh, uv));
  Cut_open cut(c);
  EXPECT_GT(cut.mesh.number_of_vertices(), mesh.number_of_vertices() + 10);
  PN::subdivide(
    mesh, PN::linear(TypeParam()),
    PN::parameters::attributes(PN::parameters::corner_attribute(uv)).number_of_iterations(2));
  if constexpr (creases)
    PN::subdivide(cut.mesh, PN::internal::with_border(PN::linear(TypeParam()), PN::Border::corners),
                  params::number_of_iterations(2).vertex_is_constrained_map(cut.stays));
  else // the control points stay anyhow
    PN::subdivide(cut.mesh, PN::linear(TypeParam()), params::number_of_iterations(2));
  const auto expected = polygons(cut.mesh, [&](H h) {
    const auto& p = cut.mesh.point(cut.mesh.target(h));
    return Uv{p.x(), p.y()};
  });
  EXPECT_EQ(polygons(mesh, [&](H h) { return uv[h]; }), expected);
}

// Linear values: corners of every face are refined as if it were alone.
TYPED_TEST(Chart_attributes, AreLinearInsideFacesIfAskedFor)
{
  const Charts c = charts_of_grid(TypeParam::Host::refined_degree == 3,
                                  !std::is_same_v<TypeParam, PN::Kobbelt_scheme>);
  Mesh mesh = built<Mesh>(c.soup);
  auto uv = add<H, Uv>(mesh, "uv");
  auto parent = add<Mesh::Face_index, int>(mesh, "parent");
  put_uv(c, mesh, uv);
  PN::subdivide(
    mesh, PN::linear(TypeParam()),
    PN::parameters::attributes(PN::parameters::corner_attribute(uv, PN::Corner_rule::all),
                               PN::parameters::face_parents(parent))
      .number_of_iterations(2));
  // the areas of the parts are the area of the face
  const auto area = [](const std::vector<Uv>& p) {
    double sum = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const Uv &a = p[i], &b = p[(i + 1) % p.size()];
      sum += (a[0] * b[1] - a[1] * b[0]) / 2;
    }
    return sum;
  };
  std::vector<double> areas(c.uv.size(), 0);
  std::vector<std::set<Uv>> corners(c.uv.size());
  for (auto f : mesh.faces()) {
    std::vector<Uv> p;
    for (auto h : mesh.halfedges_around_face(mesh.halfedge(f))) {
      p.push_back(uv[h]);
      corners[std::size_t(parent[f])].insert(uv[h]);
    }
    areas[std::size_t(parent[f])] += area(p);
  }
  for (std::size_t f = 0; f < c.uv.size(); ++f) {
    EXPECT_NEAR(areas[f], area(c.uv[f]), 1e-9);
    for (const Uv& p : c.uv[f]) EXPECT_EQ(corners[f].count(p), 1u);
    const std::size_t m = c.uv[f].size();
    EXPECT_EQ(corners[f].size(), TypeParam::Host::refined_degree == 3 ? 15u : 6 * m + 1);
    if (TypeParam::Host::refined_degree == 3) continue;
    Uv mean{0, 0};
    for (const Uv& p : c.uv[f]) mean[0] += p[0] / double(m), mean[1] += p[1] / double(m);
    EXPECT_TRUE(
      std::any_of(corners[f].begin(), corners[f].end(),
                  [&](const Uv& p) { return std::hypot(p[0] - mean[0], p[1] - mean[1]) < 1e-9; }))
      << "the middle of face " << f;
  }
}

// \name Labels and directions

enum class Label { none, red, blue };

template <class Scheme>
class Labels : public ::testing::Test
{};
using Label_schemes =
  ::testing::Types<PN::CatmullClark_scheme, PN::Loop_scheme, PN::Butterfly_scheme,
                   PN::Kobbelt_scheme, PN::DooSabin_scheme, PN::Sqrt3_scheme>;
TYPED_TEST_SUITE(Labels, Label_schemes, );

// a torus of m x m squares, or twice as many triangles
struct Flat_torus
{
  explicit Flat_torus(bool are_triangles, int m = 6)
  {
    for (int i = 0; i < m; ++i)
      for (int j = 0; j < m; ++j) {
        const double a = 2 * 3.14159265358979 * i / m, b = 2 * 3.14159265358979 * j / m;
        const double r = 2 + std::cos(b);
        soup.points.push_back({r * std::cos(a), r * std::sin(a), std::sin(b)});
      }
    const auto v = [m](int i, int j) { return std::size_t(i % m * m + j % m); };
    for (int i = 0; i < m; ++i)
      for (int j = 0; j < m; ++j)
        if (are_triangles) {
          soup.faces.push_back({v(i, j), v(i + 1, j), v(i + 1, j + 1)});
          soup.faces.push_back({v(i, j), v(i + 1, j + 1), v(i, j + 1)});
        } else
          soup.faces.push_back({v(i, j), v(i + 1, j), v(i + 1, j + 1), v(i, j + 1)});
  }
  Soup soup;
};

// Every vertex is as near to no other control vertex in its control face, where corners are carried linearly: in the plane of a
// regular polygon. Doo-Sabin and sqrt(3) subdivision keep no edges; there values are those of the faces' corners.
TYPED_TEST(Labels, AreThoseOfTheNearestControlVertex)
{
  constexpr bool splits = PN::splits_edges_v<TypeParam>;
  constexpr bool are_triangles =
    TypeParam::Host::refined_degree == 3 || std::is_same_v<TypeParam, PN::Sqrt3_scheme>;
  Mesh mesh = built<Mesh>(Flat_torus(are_triangles).soup);
  std::vector<std::vector<std::size_t>> corners; // of the control faces
  auto place = add<H, Uv>(mesh, "place");
  for (auto f : mesh.faces()) {
    corners.emplace_back();
    const double n = mesh.degree(f);
    for (auto h : mesh.halfedges_around_face(mesh.halfedge(f))) {
      const double angle = 2 * 3.14159265358979 * double(corners.back().size()) / n;
      place[h] = {std::cos(angle), std::sin(angle)};
      corners.back().push_back(mesh.target(h).idx());
    }
  }
  auto label = add<V, int>(mesh, "label");
  auto named = add<V, double>(mesh, "named");
  auto color = add<V, Label>(mesh, "color");
  for (auto v : mesh.vertices()) {
    label[v] = 7 * int(v.idx());
    named[v] = v.idx();
    color[v] = v.idx() % 2 == 0 ? Label::red : Label::blue;
  }
  auto parent = add<Mesh::Face_index, int>(mesh, "parent");
  PN::Attribute_table table;
  table.vertices.resize(1);
  table.vertices[0].rule_of_vertices = PN::Attribute_rule::nearest;
  for (auto v : mesh.vertices()) table.vertices[0].values.push_back(v.idx());
  Mesh other = mesh;
  const auto rounds = params::number_of_iterations(2);
  const auto labels = [&](const auto&... more) {
    return PN::parameters::join(
      PN::parameters::attributes(
        PN::parameters::vertex_attribute(label), PN::parameters::nearest_attribute(named),
        PN::parameters::vertex_attribute(color), PN::parameters::face_parents(parent), more...),
      rounds);
  };
  const PN::Linear_scheme<TypeParam> scheme = PN::linear(TypeParam());
  if constexpr (splits)
    PN::subdivide(mesh, scheme,
                  labels(PN::parameters::corner_attribute(place, PN::Corner_rule::all)));
  else
    PN::subdivide(mesh, scheme, labels());
  PN::subdivide(other, scheme, PN::parameters::join(PN::parameters::attributes(table), rounds));
  for (auto v : mesh.vertices()) {
    EXPECT_EQ(label[v], 7 * int(named[v]));
    EXPECT_EQ(table.vertices[0].values[v.idx()], named[v]);
    EXPECT_EQ(color[v], int(named[v]) % 2 == 0 ? Label::red : Label::blue);
  }
  if constexpr (splits)
    for (auto f : mesh.faces()) {
      const std::vector<std::size_t>& of_face = corners[std::size_t(parent[f])];
      for (auto h : mesh.halfedges_around_face(mesh.halfedge(f))) {
        double largest = -1, own = -1;
        for (std::size_t i = 0; i < of_face.size(); ++i) {
          const double angle = 2 * 3.14159265358979 * double(i) / double(of_face.size());
          const double x = place[h][0] * std::cos(angle) + place[h][1] * std::sin(angle);
          largest = (std::max)(largest, x);
          if (of_face[i] == std::size_t(named[mesh.target(h)])) own = x;
        }
        EXPECT_NEAR(own, largest, 1e-5);
      }
    }
}

// Control vertices keep theirs, polygons, borders and a crease included.
TEST(Attributes, LabelsAreNeverBetweenOthers)
{
  Mesh mesh = built<Mesh>(mixed_with_border());
  auto label = add<V, short>(mesh, "label");
  for (auto v : mesh.vertices()) label[v] = v.idx() % 2 == 0 ? 1 : 3;
  const std::size_t control = mesh.number_of_vertices();
  auto sharp = add<Mesh::Edge_index, bool>(mesh, "sharp", false);
  sharp[*mesh.edges().begin()] = true;
  PN::subdivide(
    mesh, PN::CatmullClark_scheme(),
    PN::parameters::join(PN::parameters::attributes(PN::parameters::vertex_attribute(label)),
                         params::number_of_iterations(3).edge_is_constrained_map(sharp)));
  for (auto v : mesh.vertices()) {
    EXPECT_TRUE(label[v] == 1 || label[v] == 3);
    if (v.idx() < control) {
      EXPECT_EQ(label[v], v.idx() % 2 == 0 ? 1 : 3);
    }
  }
}

TEST(Attributes, DirectionsAreUnitVectors)
{
  Mesh mesh = built<Mesh>(mixed_with_border());
  auto d = add<V, Kernel::Vector_3>(mesh, "d", CGAL::NULL_VECTOR);
  auto sum = add<V, Kernel::Vector_3>(mesh, "sum", CGAL::NULL_VECTOR);
  PN::Attribute_table table;
  table.vertices.resize(1);
  table.vertices[0].dimension = 3;
  table.vertices[0].rule_of_vertices = PN::Attribute_rule::direction;
  for (auto v : mesh.vertices()) {
    const double t = 0.4 * v.idx();
    sum[v] = d[v] = v.idx() == 0
                      ? Kernel::Vector_3(0, 0, 0)
                      : Kernel::Vector_3(std::cos(t), std::sin(t) * 0.6, std::sin(t) * 0.8);
    for (int k = 0; k < 3; ++k) table.vertices[0].values.push_back(d[v][k]);
  }
  Mesh other = mesh;
  const auto rounds = params::number_of_iterations(2);
  PN::subdivide(
    mesh, PN::CatmullClark_scheme(),
    PN::parameters::join(PN::parameters::attributes(PN::parameters::direction_attribute(d),
                                                    PN::parameters::vertex_attribute(sum)),
                         rounds));
  PN::subdivide(other, PN::CatmullClark_scheme(),
                PN::parameters::join(PN::parameters::attributes(table), rounds));
  bool was_shorter = false;
  for (auto v : mesh.vertices()) {
    const double length = std::sqrt(sum[v].squared_length());
    was_shorter = was_shorter || length < 0.9;
    if (length == 0) continue;
    EXPECT_NEAR(d[v].squared_length(), 1, 1e-14);
    EXPECT_NEAR(d[v] * sum[v], length, 1e-14);
    for (unsigned k = 0; k < 3; ++k)
      EXPECT_NEAR(table.vertices[0].values[3 * v.idx() + k], d[v][int(k)], 1e-15);
  }
  EXPECT_TRUE(was_shorter);
}

// \name Tables, threads

struct Results
{
  std::vector<double> scalar, color;
  std::vector<Uv> uv;
  std::vector<int> mark, parent;
  friend bool operator==(const Results& a, const Results& b)
  {
    return std::tie(a.scalar, a.color, a.uv, a.mark, a.parent) ==
           std::tie(b.scalar, b.color, b.uv, b.mark, b.parent);
  }
};

double scalar_of(V v)
{
  return std::sin(1.7 * v.idx());
}

// of values whose charts differ in the second component only, if asked for
void put_uv(const Charts& c, const Mesh& mesh, Mesh::Property_map<H, Uv>& uv, bool second_alone)
{
  put_uv(c, mesh, uv);
  if (second_alone)
    for (auto h : mesh.halfedges()) uv[h] = {0, uv[h][0] + 2 * uv[h][1]};
}

template <class Tag>
Results by_maps(const Charts& c, bool second_alone = false)
{
  Mesh mesh = built<Mesh>(c.soup);
  auto scalar = add<V, double>(mesh, "scalar");
  auto color = add<V, std::array<double, 3>>(mesh, "color");
  auto uv = add<H, Uv>(mesh, "uv");
  auto mark = add<Mesh::Edge_index, int>(mesh, "mark");
  auto parent = add<Mesh::Face_index, int>(mesh, "parent");
  for (auto v : mesh.vertices()) {
    scalar[v] = scalar_of(v);
    color[v] = {scalar[v], scalar[v] * scalar[v], 1};
  }
  for (auto e : mesh.edges()) mark[e] = int(e.idx() % 5);
  put_uv(c, mesh, uv, second_alone);
  PN::subdivide<Tag>(mesh, PN::CatmullClark_scheme(),
                     PN::parameters::attributes(PN::parameters::vertex_attribute(scalar),
                                                PN::parameters::vertex_attribute(color),
                                                PN::parameters::corner_attribute(uv),
                                                PN::parameters::edge_attribute(mark),
                                                PN::parameters::face_parents(parent))
                       .number_of_iterations(4));
  Results r;
  for (auto v : mesh.vertices()) {
    r.scalar.push_back(scalar[v]);
    r.color.insert(r.color.end(), color[v].begin(), color[v].end());
  }
  for (auto h : mesh.halfedges()) r.uv.push_back(mesh.is_border(h) ? Uv{0, 0} : uv[h]);
  for (auto e : mesh.edges()) r.mark.push_back(mark[e]);
  for (auto f : mesh.faces()) r.parent.push_back(parent[f]);
  return r;
}

template <class Tag>
Results by_table(const Charts& c, const Mesh& control, unsigned extra = 0,
                 bool second_alone = false)
{
  Mesh mesh = control;
  PN::Attribute_table table;
  table.vertices.resize(2);
  table.vertices[1].dimension = 3;
  for (auto v : mesh.vertices()) {
    const double s = scalar_of(v);
    table.vertices[0].values.push_back(s);
    for (double x : {s, s * s, 1.}) table.vertices[1].values.push_back(x);
  }
  for (unsigned i = 0; i < extra; ++i) table.vertices[0].values.push_back(0);
  auto uv = add<H, Uv>(mesh, "uv");
  put_uv(c, mesh, uv, second_alone);
  table.corners.resize(1);
  table.corners[0].dimension = 2;
  for (auto h : mesh.halfedges())
    for (double x : uv[h]) table.corners[0].values.push_back(x);
  EXPECT_TRUE(PN::has_seam(mesh, table.corners[0]));
  table.edges.resize(1);
  for (auto e : mesh.edges()) table.edges[0].values.push_back(double(e.idx() % 5));
  table.has_face_parents = true;
  PN::subdivide<Tag>(mesh, PN::CatmullClark_scheme(),
                     PN::parameters::attributes(table).number_of_iterations(4));
  Results r;
  r.scalar = table.vertices[0].values;
  r.color = table.vertices[1].values;
  for (std::size_t i = 0; i < table.corners[0].values.size(); i += 2)
    r.uv.push_back({table.corners[0].values[i], table.corners[0].values[i + 1]});
  for (double x : table.edges[0].values) r.mark.push_back(int(x));
  for (std::uint32_t p : table.face_parents) r.parent.push_back(int(p));
  return r;
}

TEST(Attributes, AreTheSameInTablesAndByThreads)
{
  const Charts c = charts_of_grid(false);
  const Mesh control = built<Mesh>(c.soup);
  const Results expected = by_maps<CGAL::Sequential_tag>(c);
  EXPECT_GT(expected.scalar.size(), 9000u);
  EXPECT_EQ(by_table<CGAL::Sequential_tag>(c, control), expected);
  EXPECT_EQ(by_table<CGAL::Sequential_tag>(c, control, 0, true),
            by_maps<CGAL::Sequential_tag>(c, true));
#ifdef CGAL_LINKED_WITH_TBB
  EXPECT_EQ(by_maps<CGAL::Parallel_tag>(c), expected);
  EXPECT_EQ(by_table<CGAL::Parallel_tag>(c, control), expected);
#endif
}

// Every vertex of the cube is a corner: its slots share one value.
TEST(Attributes, InTablesAlongCreases)
{
  for (const double sharpness : {1.5, std::numeric_limits<double>::infinity()}) {
    Mesh mesh = built<Mesh>(cube());
    auto sharp = add<Mesh::Edge_index, double>(mesh, "sharp", sharpness);
    PN::Attribute_table table;
    table.vertices.resize(1);
    table.vertices[0].dimension = 3;
    for (auto v : mesh.vertices())
      for (int k = 0; k < 3; ++k) table.vertices[0].values.push_back(mesh.point(v)[k]);
    PN::subdivide(
      mesh, PN::linear(PN::CatmullClark_scheme()),
      PN::parameters::attributes(table).number_of_iterations(3).edge_is_constrained_map(sharp));
    ASSERT_EQ(table.vertices[0].values.size(), 3 * mesh.number_of_vertices());
    for (auto v : mesh.vertices())
      for (unsigned k = 0; k < 3; ++k)
        EXPECT_NEAR(table.vertices[0].values[3 * v.idx() + k], mesh.point(v)[int(k)], 1e-15);
  }
}

// Values that are carried change no bit of the points and normals.
TEST(Attributes, LeaveThePointsAlone)
{
  Mesh mesh = built<Mesh>(mixed_with_border()), other = mesh;
  auto t = add<V, double>(mesh, "t", 1);
  const auto np = params::number_of_iterations(3);
  PN::subdivide(
    mesh, PN::CatmullClark_scheme(),
    PN::parameters::join(PN::parameters::attributes(PN::parameters::vertex_attribute(t)), np));
  PN::subdivide(other, PN::CatmullClark_scheme(), np);
  EXPECT_EQ(points(mesh), points(other));
  EXPECT_EQ(faces_of(mesh), faces_of(other));
}

// \name What is refused

TEST(Attributes, AreRefusedByNameAndLeaveTheMesh)
{
  const Charts c = charts_of_grid(false);
  Mesh mesh = built<Mesh>(c.soup);
  const auto before = points(mesh);
  EXPECT_NE(
    messages::message_of([&] { by_table<CGAL::Sequential_tag>(c, mesh, 1); }).find("50 values"),
    std::string::npos);
  PN::Attribute_table table;
  table.edges.resize(1);
  table.edges[0].dimension = 0;
  EXPECT_NE(messages::message_of([&] {
              PN::subdivide(mesh, PN::CatmullClark_scheme(), PN::parameters::attributes(table));
            }).find("edges has dimension 0"),
            std::string::npos);

  auto uv = add<H, Uv>(mesh, "uv");
  auto mark = add<Mesh::Edge_index, int>(mesh, "mark");
  EXPECT_FALSE(PN::has_seam(mesh, uv));
  put_uv(c, mesh, uv);
  const auto doo_sabin = [&](const auto& attributes) {
    return messages::message_of([&] {
      PN::subdivide(mesh, PN::linear(PN::DooSabin_scheme()),
                    PN::parameters::attributes(attributes));
    });
  };
  EXPECT_NE(doo_sabin(test_options::attributes(PN::parameters::corner_attribute(uv)))
              .find("seam at the edge of half-edge"),
            std::string::npos);
  EXPECT_NE(
    doo_sabin(test_options::attributes(PN::parameters::corner_attribute(uv, PN::Corner_rule::all)))
      .find("scheme keeps no edges"),
    std::string::npos);
  EXPECT_NE(doo_sabin(test_options::attributes(PN::parameters::edge_attribute(mark)))
              .find("scheme keeps no edges"),
            std::string::npos);
  EXPECT_EQ(points(mesh), before);
}

// A map without seams is carried by schemes that keep no edges, too.
TEST(Attributes, OfCornersWithoutSeamsAreThoseOfVertices)
{
  Mesh mesh = built<Mesh>(mixed_with_border());
  auto t = add<V, double>(mesh, "t");
  auto u = add<H, double>(mesh, "u");
  for (auto v : mesh.vertices()) t[v] = scalar_of(v);
  for (auto h : mesh.halfedges()) u[h] = t[mesh.target(h)];
  PN::subdivide(mesh, PN::DooSabin_scheme(),
                PN::parameters::attributes(PN::parameters::vertex_attribute(t),
                                           PN::parameters::corner_attribute(u))
                  .number_of_iterations(2));
  for (auto h : mesh.halfedges())
    if (!mesh.is_border(h)) {
      EXPECT_EQ(u[h], t[mesh.target(h)]);
    }
}

// \name Failures

struct Failure
{};

// a value whose n-th sum fails
struct Fragile
{
  double x = 0;
  friend Fragile operator+(const Fragile& a, const Fragile& b)
  {
    if (--left == 0) throw Failure();
    return {a.x + b.x};
  }
  friend Fragile operator*(const Fragile& a, double w) { return {a.x * w}; }
  static long left;
};
long Fragile::left = 0;

TEST(Attributes, ThatThrowLeaveEverythingAsItWas)
{
  const Charts c = charts_of_grid(false);
  const Mesh control = built<Mesh>(c.soup);
  for (long n : {1L, 2L, 100L, 5000L}) {
    Mesh mesh = control;
    auto fragile = add<V, Fragile>(mesh, "fragile");
    auto scalar = add<V, double>(mesh, "scalar");
    auto uv = add<H, Uv>(mesh, "uv");
    put_uv(c, mesh, uv);
    for (auto v : mesh.vertices()) scalar[v] = fragile[v].x = scalar_of(v);
    const Mesh before = mesh;
    Fragile::left = n;
    EXPECT_THROW(PN::subdivide(mesh, PN::CatmullClark_scheme(),
                               PN::parameters::attributes(PN::parameters::vertex_attribute(scalar),
                                                          PN::parameters::corner_attribute(uv),
                                                          PN::parameters::vertex_attribute(fragile))
                                 .number_of_iterations(2)),
                 Failure)
      << n;
    EXPECT_EQ(mesh.number_of_vertices(), before.number_of_vertices());
    EXPECT_EQ(points(mesh), points(before));
    EXPECT_EQ(faces_of(mesh), faces_of(before));
    for (auto v : mesh.vertices()) EXPECT_EQ(scalar[v], scalar_of(v));
    auto uv_before = PN::internal::find_property_map<H, Uv>(before, "uv").value();
    for (auto h : mesh.halfedges()) EXPECT_EQ(uv[h], uv_before[h]);
  }
}

} // namespace

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The six rules for values of corners are those of OpenSubdiv for face-varying data.

#include <gtest/gtest.h>

#ifdef PN_TEST_WITH_OPENSUBDIV

#  include "Extent.h"
#  include "OpenSubdiv_peer.h"

#  include <CGAL/PN_subdivision_3/parameters/parameters.h>
#  include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#  include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#  include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
#  include <CGAL/PN_subdivision_3/subdivide.h>
#  include <CGAL/Simple_cartesian.h>
#  include <CGAL/Surface_mesh.h>

#  include <algorithm>
#  include <array>
#  include <cmath>
#  include <functional>
#  include <map>
#  include <set>
#  include <string>
#  include <utility>
#  include <vector>

namespace {

using namespace opensubdiv_peer;
namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using H = Mesh::Halfedge_index;
using Uv = std::array<double, 2>;
using PN::Corner_rule;

// Corners at a vertex have the same value if they have the same label.
struct Textured : Control
{
  std::vector<std::vector<int>> labels; // of the corners of the faces
};

using Label = std::function<int(int face, int corner)>;

Textured textured(const Control& control, const Label& label)
{
  Textured result{control, {}};
  for (int f = 0; f < int(control.faces.size()); ++f) {
    result.labels.emplace_back();
    for (int i = 0; i < int(control.faces[std::size_t(f)].size()); ++i)
      result.labels.back().push_back(label(f, i));
  }
  return result;
}

Textured split_to_triangles(const Textured& t)
{
  Textured result{triangulated(t), {}};
  for (const std::vector<int>& of_face : t.labels)
    for (std::size_t i = 1; i + 1 < of_face.size(); ++i)
      result.labels.push_back({of_face[0], of_face[i], of_face[i + 1]});
  return result;
}

// --- situations: columns x rows of quads; face x + columns * y, its corners (0, 0) (1, 0) (1, 1) (0, 1) ---

Control grid(int columns, int rows, const std::set<std::pair<int, int>>& holes = {})
{
  Control c;
  std::map<Edge, int> index;
  const auto vertex = [&](int x, int y) {
    const auto [it, is_new] = index.try_emplace({x, y}, int(c.points.size()));
    if (is_new) c.points.push_back({double(x), double(y), std::sin(x + 0.7 * y)});
    return it->second;
  };
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x)
      if (holes.count({x, y}) == 0)
        c.faces.push_back({vertex(x, y), vertex(x + 1, y), vertex(x + 1, y + 1), vertex(x, y + 1)});
  return c;
}

// charts of whole faces
Textured charts(int columns, int rows, const std::function<int(int x, int y)>& chart)
{
  return textured(grid(columns, rows), [&](int f, int) { return chart(f % columns, f / columns); });
}

// a cut along the row y from x = first on up to x = last; these vertices have a value for each side
Textured slit(int columns, int rows, int y, int first, int last)
{
  return textured(grid(columns, rows), [&](int f, int i) {
    const int cx = f % columns + (i == 1 || i == 2 ? 1 : 0), cy = f / columns + (i >= 2 ? 1 : 0);
    return cy == y && f / columns == y && first <= cx && cx <= last ? 1 : 0;
  });
}

const int no_label = 0;
int one_chart(int, int)
{
  return no_label;
}

std::map<std::string, Textured> situations()
{
  std::map<std::string, Textured> s;
  s["one face"] = textured(grid(1, 1), one_chart);
  s["border with ends of one, two and three faces"] =
    textured(grid(3, 3, {{1, 0}, {2, 2}}), one_chart);
  s["two halves"] = charts(4, 4, [](int x, int) { return x / 2; });
  s["halves with a corner each at the border"] = charts(2, 1, [](int x, int) { return x; });
  s["one faces and two at a border"] = charts(3, 2, [](int x, int) { return x / 2; });
  s["convex and concave corner"] = charts(4, 4, [](int x, int y) { return x < 2 && y < 2; });
  s["island of one face"] = charts(3, 3, [](int x, int y) { return x == 1 && y == 1; });
  s["island of four faces"] = charts(4, 4, [](int x, int y) { return x % 3 != 0 && y % 3 != 0; });
  s["four quarters"] = charts(4, 4, [](int x, int y) { return x / 2 + 2 * (y / 2); });
  s["three charts at a vertex"] = charts(4, 4, [](int x, int y) { return y < 2 ? 0 : 1 + x / 2; });
  s["checkerboard"] = charts(4, 4, [](int x, int y) { return (x + y) % 2; });
  s["bow tie of two among three"] = charts(2, 2, [](int x, int y) { return x == y ? 0 : 1 + x; });
  s["every face a chart"] = charts(3, 3, [](int x, int y) { return x + 3 * y; });
  s["slit inside"] = slit(5, 4, 2, 2, 3);
  s["slit of two edges"] = slit(4, 4, 2, 2, 2);
  s["slit up to the border"] = slit(4, 4, 2, 2, 4);
  s["slit up to the vertex before the border"] = slit(4, 4, 2, 2, 3);
  s["one side of a seam equal at its ends at the border"] = slit(3, 4, 2, 1, 2);
  s["two slits of one edge from the border that meet"] = textured(grid(4, 2), [](int f, int i) {
    const int cx = f % 4 + (i == 1 || i == 2 ? 1 : 0), cy = f / 4 + (i >= 2 ? 1 : 0);
    return cx == 2 && cy != 1 && f % 4 == 2 ? 1 : 0;
  });
  s["sides of a box"] = textured(box(), [](int f, int) { return f / 4; });
  s["sides of a box, opposite ones alike"] = textured(box(), [](int f, int) { return f / 8; });
  s["patch"] = textured(patch(), one_chart);
  return s;
}

// --- comparison ---

struct Rule
{
  Corner_rule ours;
  Sdc::Options::FVarLinearInterpolation theirs;
  const char* name;
};
const std::array<Rule, 6> rules{
  {{Corner_rule::none, Sdc::Options::FVAR_LINEAR_NONE, "none"},
   {Corner_rule::corners_only, Sdc::Options::FVAR_LINEAR_CORNERS_ONLY, "corners only"},
   {Corner_rule::corners_plus1, Sdc::Options::FVAR_LINEAR_CORNERS_PLUS1, "plus 1"},
   {Corner_rule::corners_plus2, Sdc::Options::FVAR_LINEAR_CORNERS_PLUS2, "plus 2"},
   {Corner_rule::boundaries, Sdc::Options::FVAR_LINEAR_BOUNDARIES, "boundaries"},
   {Corner_rule::all, Sdc::Options::FVAR_LINEAR_ALL, "all"}}};

// values by vertices and labels, between 0 and 1
struct Values
{
  Values(const Textured& t, std::mt19937& random)
  {
    for (std::size_t f = 0; f < t.faces.size(); ++f)
      for (std::size_t i = 0; i < t.faces[f].size(); ++i) {
        const auto [it, is_new] =
          number.try_emplace({t.faces[f][i], t.labels[f][i]}, int(uv.size()));
        if (is_new) uv.push_back({random_between(random, 0, 1), random_between(random, 0, 1)});
        of_corners.push_back(it->second);
      }
  }
  std::map<Edge, int> number;
  std::vector<Uv> uv;
  std::vector<int> of_corners;
};

template <class Scheme>
class Refined
{
public:
  Refined(const Textured& t, const Values& values, Corner_rule rule, int rounds)
  {
    uv_ = mesh_.add_property_map<H, Uv>("h:uv").first;
    auto sharp = mesh_.add_property_map<Mesh::Edge_index, double>("e:sharp", 0).first;
    auto corner = mesh_.add_property_map<Mesh::Vertex_index, double>("v:sharp", 0).first;
    for (const Triple& p : t.points) mesh_.add_vertex(Point(p[0], p[1], p[2]));
    std::size_t next = 0;
    for (const Face& face : t.faces) {
      std::vector<Mesh::Vertex_index> v;
      for (const int i : face) v.emplace_back(i);
      const auto f = mesh_.add_face(v);
      EXPECT_NE(f, Mesh::null_face());
      for (const auto x : v) {
        H h = mesh_.halfedge(f);
        while (mesh_.target(h) != x) h = mesh_.next(h);
        uv_[h] = values.uv[std::size_t(values.of_corners[next++])];
      }
    }
    const auto index = [](int v) { return Mesh::Vertex_index(Mesh::size_type(v)); };
    for (const auto& [e, s] : t.sharp_edges)
      sharp[mesh_.edge(mesh_.halfedge(index(e.first), index(e.second)))] = s;
    for (const auto& [v, s] : t.sharp_vertices) corner[index(v)] = s;
    PN::subdivide(mesh_, PN::internal::with_border(PN::linear(Scheme()), t.border),
                  PN::parameters::attributes(PN::parameters::corner_attribute(uv_, rule))
                    .number_of_iterations(unsigned(rounds))
                    .edge_is_constrained_map(sharp)
                    .vertex_is_constrained_map(corner));
  }

  const Mesh& mesh() const { return mesh_; }
  const Uv& uv(H h) const { return uv_[h]; }

private:
  Mesh mesh_;
  Mesh::Property_map<H, Uv> uv_;
};

// the peer's vertex at a point; all are far from each other
class Vertex_finder
{
public:
  explicit Vertex_finder(const std::vector<Peer_point>& points)
  {
    for (int v = 0; v < int(points.size()); ++v) at_[cell(points[std::size_t(v)].x, 0)] = v;
  }
  int operator()(const Point& p) const
  {
    for (int k = 0; k < 27; ++k) {
      const auto it = at_.find(cell({p.x(), p.y(), p.z()}, k));
      if (it != at_.end()) return it->second;
    }
    return -1;
  }

private:
  using Cell = std::array<long long, 3>;
  static Cell cell(const Triple& p, int k)
  {
    const std::array<int, 3> shift{k % 3, k / 3 % 3, k / 9};
    Cell c{};
    for (std::size_t i = 0; i < 3; ++i)
      c[i] = std::llround(1e8 * p[i]) + (shift[i] == 2 ? -1 : shift[i]);
    return c;
  }
  std::map<Cell, int> at_;
};

// the greatest difference of values
template <class Scheme>
double greatest_difference(const Textured& t, const Rule& rule, Sdc::SchemeType peer_scheme,
                           int rounds, unsigned seed)
{
  std::mt19937 random(seed);
  const Values values(t, random);
  const Refined<Scheme> ours(t, values, rule.ours, rounds);

  const Peer_channel channel{values.of_corners, int(values.uv.size()), rule.theirs};
  const auto peer = make_peer(t, peer_scheme, &channel);
  Far::TopologyRefiner::UniformOptions options(rounds);
  options.fullTopologyInLastLevel = true;
  peer->RefineUniform(options);
  const Far::PrimvarRefinerReal<double> refiner(*peer);
  std::vector<Peer_point> points, uv;
  for (const Triple& p : t.points) points.push_back({p});
  for (const Uv& x : values.uv) uv.push_back({{x[0], x[1], 0}});
  for (int k = 1; k <= rounds; ++k) {
    const Far::TopologyLevel& level = peer->GetLevel(k);
    std::vector<Peer_point> new_points(std::size_t(level.GetNumVertices())),
      new_uv(std::size_t(level.GetNumFVarValues()));
    refiner.Interpolate(k, points, new_points);
    refiner.InterpolateFaceVarying(k, uv, new_uv);
    points = new_points;
    uv = new_uv;
  }

  const Far::TopologyLevel& last = peer->GetLevel(rounds);
  const Vertex_finder find(points);
  double greatest = 0;
  for (const auto f : ours.mesh().faces()) {
    std::vector<int> vertices;
    for (const H h : CGAL::halfedges_around_face(ours.mesh().halfedge(f), ours.mesh())) {
      vertices.push_back(find(ours.mesh().point(ours.mesh().target(h))));
      if (vertices.back() < 0) return infinity;
    }
    const int peer_face = face_of(last, vertices);
    if (peer_face < 0) return infinity;
    const auto peer_vertices = last.GetFaceVertices(peer_face);
    const auto peer_values = last.GetFaceFVarValues(peer_face);
    std::size_t next = 0;
    for (const H h : CGAL::halfedges_around_face(ours.mesh().halfedge(f), ours.mesh())) {
      const int v = vertices[next++];
      for (int i = 0; i < peer_vertices.size(); ++i)
        if (peer_vertices[i] == v)
          for (std::size_t c = 0; c < 2; ++c) {
            const double d = std::abs(ours.uv(h)[c] - uv[std::size_t(peer_values[i])].x[c]);
            if (!(d <= greatest)) greatest = d;
          }
    }
  }
  return greatest;
}

// Whether two charts meet twice each at a vertex. By `none` and `corners only` the peer takes one of them for two charts
// then, depending on which face comes first.
bool has_alternating_charts(const Textured& t)
{
  const Level_connectivity level = level_of(t);
  std::map<Edge, int> label; // by face and vertex
  for (std::size_t f = 0; f < t.faces.size(); ++f)
    for (std::size_t i = 0; i < t.faces[f].size(); ++i)
      label[{int(f), t.faces[f][i]}] = t.labels[f][i];
  for (Index v = 0; v < level.number_of_vertices(); ++v) {
    std::vector<int> round;
    const Index first = level.halfedge_of_vertex(v);
    Index h = first;
    do {
      if (!level.is_border(h)) round.push_back(label.at({int(level.face(h)), int(v)}));
      h = level.next_around_target(h);
    } while (h != first);
    std::map<int, int> spans;
    for (std::size_t i = 0; i < round.size(); ++i)
      if (round[i] != round[(i + 1) % round.size()]) ++spans[round[i]];
    if (std::count_if(spans.begin(), spans.end(), [](auto s) { return s.second > 1; }) > 1)
      return true;
  }
  return false;
}

void expect_equal(const Textured& t, const std::string& what, unsigned seed, int rounds)
{
  const Textured triangles = split_to_triangles(t);
  for (const Rule& rule : rules) {
    const std::string name = what + ", " + rule.name + ", seed " + std::to_string(seed);
    const bool may_alternate =
      rule.ours != Corner_rule::none && rule.ours != Corner_rule::corners_only;
    if (may_alternate || !has_alternating_charts(t)) {
      EXPECT_LE(
        (greatest_difference<PN::CatmullClark_scheme>(t, rule, Sdc::SCHEME_CATMARK, rounds, seed)),
        1e-12)
        << name << ", quads";
    }
    if (may_alternate || !has_alternating_charts(triangles)) {
      EXPECT_LE(
        (greatest_difference<PN::Loop_scheme>(triangles, rule, Sdc::SCHEME_LOOP, rounds, seed)),
        1e-12)
        << name << ", triangles";
    }
  }
}

TEST(Texture_of_OpenSubdiv, Situations)
{
  for (const auto& [name, shape] : situations())
    for (const Border border : {Border::surface, Border::corners}) {
      Textured t = shape;
      std::mt19937 random(7);
      perturb(t, random);
      t.border = border;
      expect_equal(t, name + (border == Border::corners ? ", corners" : ""), 1,
                   border == Border::surface || tests_are_full ? 3 : 2);
    }
}

TEST(Texture_of_OpenSubdiv, Situations_with_creases)
{
  for (const auto& [name, shape] : situations())
    for (unsigned seed = 1; seed <= 2; ++seed) {
      Textured t = shape;
      std::mt19937 random(seed);
      perturb(t, random);
      tag(t, random, 0.15, {infinity});
      expect_equal(t, name + ", creases", seed, 2);
    }
}

// anything at corners: a few labels, most of them the same
TEST(Texture_of_OpenSubdiv, Random_values)
{
  for (unsigned seed = 1; seed <= 12; ++seed) {
    std::mt19937 random(100 + seed);
    const Control shape = seed % 3 == 0 ? box() : seed % 3 == 1 ? patch() : grid(4, 3);
    const double share = std::array<double, 4>{0.05, 0.15, 0.4, 0.9}[seed % 4];
    Textured t = textured(shape, [&](int, int) {
      return random_between(random, 0, 1) < share ? int(1 + random() % 2) : 0;
    });
    perturb(t, random);
    if (seed % 2 == 0) tag(t, random, 0.1, {infinity});
    expect_equal(t, "random values", seed, 3);
  }
}

// faces in charts at random
TEST(Texture_of_OpenSubdiv, Random_charts)
{
  for (unsigned seed = 1; seed <= 12; ++seed) {
    std::mt19937 random(200 + seed);
    const Control shape = seed % 3 == 0 ? box() : seed % 3 == 1 ? patch() : grid(4, 4, {{1, 2}});
    std::vector<int> chart;
    for (std::size_t f = 0; f < shape.faces.size(); ++f)
      chart.push_back(int(random() % (2 + seed % 3)));
    Textured t = textured(shape, [&](int f, int) { return chart[std::size_t(f)]; });
    perturb(t, random);
    if (seed % 2 == 0) tag(t, random, 0.1, {infinity});
    expect_equal(t, "random charts", seed, 3);
  }
}

} // namespace

#else

TEST(Texture_of_OpenSubdiv, Situations)
{
  GTEST_SKIP() << "left out: OpenSubdiv not found (Debian package libosd-dev)";
}

#endif

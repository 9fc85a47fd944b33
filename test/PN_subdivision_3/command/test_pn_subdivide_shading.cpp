// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Normals that modelling programs make of those of the faces are no data; normals that oppose their faces are turned over.

#include "Extent.h"
#include "File_test.h"

#include "io/Mesh_data.h"
#include "io/mesh_io.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <functional>
#include <utility>

using namespace pn_subdivide;

namespace {

using Vector = std::array<long double, 3>;
constexpr long double pi = 3.14159265358979323846264338327950288L;

Vector cross(const Vector& a, const Vector& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
long double dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vector scaled(long double x, const Vector& v)
{
  return {x * v[0], x * v[1], x * v[2]};
}
Vector unit(const Vector& v)
{
  return scaled(1 / std::sqrt(dot(v, v)), v);
}
struct Shape
{
  std::vector<Vector> points;
  std::vector<std::vector<int>> faces;

  Vector edge(int a, int b) const
  {
    const Vector &p = points[std::size_t(a)], &q = points[std::size_t(b)];
    return {q[0] - p[0], q[1] - p[1], q[2] - p[2]};
  }
  // of a face by the triangles round its center
  Vector area(const std::vector<int>& f) const
  {
    Vector center = {0, 0, 0}, sum = {0, 0, 0};
    for (const int v : f)
      for (std::size_t k = 0; k < 3; ++k)
        center[k] += points[std::size_t(v)][k] / (long double)(f.size());
    for (std::size_t i = 0; i < f.size(); ++i) {
      Vector a = points[std::size_t(f[i])], b = points[std::size_t(f[(i + 1) % f.size()])];
      for (std::size_t k = 0; k < 3; ++k) {
        a[k] -= center[k];
        b[k] -= center[k];
      }
      const Vector c = cross(a, b);
      for (std::size_t k = 0; k < 3; ++k) sum[k] += c[k] / 2;
    }
    return sum;
  }
};

const char* const weights[] = {"with equal weights", "weighted by area", "weighted by angle",
                               "weighted by area times angle",
                               "weighted by the areas that their corners span"};

std::vector<Vector> shading(const Shape& s, std::size_t kind)
{
  std::vector<Vector> sums(s.points.size(), Vector{0, 0, 0});
  for (const std::vector<int>& f : s.faces) {
    const Vector area = s.area(f);
    const long double size = std::sqrt(dot(area, area));
    for (std::size_t i = 0; i < f.size(); ++i) {
      const Vector a = s.edge(f[i], f[(i + 1) % f.size()]),
                   b = s.edge(f[i], f[(i + f.size() - 1) % f.size()]), c = cross(a, b);
      const long double angle = std::acos(dot(a, b) / std::sqrt(dot(a, a) * dot(b, b)));
      const long double w[] = {1, size, angle, size * angle, std::sqrt(dot(c, c))};
      for (std::size_t k = 0; k < 3; ++k) sums[std::size_t(f[i])][k] += w[kind] * area[k] / size;
    }
  }
  for (Vector& n : sums) n = unit(n);
  return sums;
}

// Rings of n vertices round the z axis, of quads, closed by fans round two poles; points and true normals from the angles.
Shape ball(int n, int rings, const std::function<Vector(long double, long double)>& at)
{
  Shape s;
  s.points.push_back(at(0, 0));
  for (int j = 1; j < rings; ++j)
    for (int i = 0; i < n; ++i) s.points.push_back(at(pi * j / rings, 2 * pi * i / n));
  s.points.push_back(at(pi, 0));
  const auto number = [n](int j, int i) { return 1 + n * (j - 1) + i % n; };
  for (int i = 0; i < n; ++i) {
    s.faces.push_back({0, number(1, i), number(1, i + 1)});
    for (int j = 1; j + 1 < rings; ++j)
      s.faces.push_back({number(j, i), number(j + 1, i), number(j + 1, i + 1), number(j, i + 1)});
    s.faces.push_back({number(rings - 1, i), int(s.points.size()) - 1, number(rings - 1, i + 1)});
  }
  return s;
}

Vector on_sphere(long double t, long double u)
{
  return {std::sin(t) * std::cos(u), std::sin(t) * std::sin(u), std::cos(t)};
}

// neither round nor even
Shape potato()
{
  return ball(9, 8, [](long double t, long double u) {
    const long double a = t + 0.25L * std::sin(2 * t), b = u + 0.3L * std::sin(u);
    const long double r = 1 + 0.2L * std::sin(3 * b) * std::sin(a);
    return Vector{2 * r * std::sin(a) * std::cos(b), r * std::sin(a) * std::sin(b) + 0.1L * r * r,
                  1.5L * r * std::cos(a)};
  });
}

Shape triangulated(const Shape& s)
{
  Shape t{s.points, {}};
  for (const std::vector<int>& f : s.faces)
    for (std::size_t i = 2; i < f.size(); ++i) t.faces.push_back({f[0], f[i - 1], f[i]});
  return t;
}

// --- files ---

enum class Format { obj, off, ply, binary_float, binary_double };
const std::pair<Format, const char*> formats[] = {{Format::obj, ".obj"},
                                                  {Format::off, ".off"},
                                                  {Format::ply, ".ply"},
                                                  {Format::binary_float, ".ply"},
                                                  {Format::binary_double, ".ply"}};

// With so many decimals, or with at most so many digits and no zeros at the end.
std::string numbers(const Vector& v, int digits, bool is_fixed)
{
  std::ostringstream text;
  text.precision(digits);
  if (is_fixed) text << std::fixed;
  for (const long double x : v) text << ' ' << double(x);
  return text.str();
}

std::string binary_file(const Shape& s, const std::vector<Vector>& normals, bool is_float)
{
  const std::string type = is_float ? "float" : "double";
  std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex " +
                      std::to_string(s.points.size()) + "\n";
  for (const char* name : {"x", "y", "z"}) bytes += std::string("property double ") + name + "\n";
  for (const char* name : {"nx", "ny", "nz"}) bytes += "property " + type + " " + name + "\n";
  bytes += "element face " + std::to_string(s.faces.size()) +
           "\nproperty list uchar int vertex_indices\nend_header\n";
  for (std::size_t v = 0; v < s.points.size(); ++v) {
    for (const long double x : s.points[v]) bytes += raw(double(x), false);
    for (const long double x : normals[v])
      bytes += is_float ? raw(float(x), false) : raw(double(x), false);
  }
  for (const std::vector<int>& f : s.faces) {
    bytes += char(f.size());
    for (const int v : f) bytes += raw(v, false);
  }
  return bytes;
}

// Without normals if there are none.
std::string file(const Shape& s, const std::vector<Vector>& normals, Format format, int digits,
                 bool is_fixed = true)
{
  if (format == Format::binary_float || format == Format::binary_double)
    return binary_file(s, normals, format == Format::binary_float);
  const bool is_obj = format == Format::obj, has = !normals.empty();
  std::string text;
  if (format == Format::off)
    text = (has ? "NOFF\n" : "OFF\n") + std::to_string(s.points.size()) + " " +
           std::to_string(s.faces.size()) + " 0\n";
  if (format == Format::ply) {
    text = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(s.points.size()) + "\n";
    for (const char* name : {"x", "y", "z", "nx", "ny", "nz"})
      if (has || name[0] != 'n') text += std::string("property float ") + name + "\n";
    text += "element face " + std::to_string(s.faces.size()) +
            "\nproperty list uchar int vertex_indices\nend_header\n";
  }
  for (std::size_t v = 0; v < s.points.size(); ++v) {
    text += (is_obj ? "v" : "") + numbers(s.points[v], 17, false);
    if (has) text += (is_obj ? "\nvn" : "") + numbers(normals[v], digits, is_fixed);
    text += "\n";
  }
  for (const std::vector<int>& f : s.faces) {
    text += is_obj ? "f" : std::to_string(f.size());
    for (const int v : f) {
      const std::string number = std::to_string(v + int(is_obj));
      text += " " + number + (is_obj && has ? "//" + number : "");
    }
    text += "\n";
  }
  return text;
}

class Pn_subdivide_shading : public Command_test
{
protected:
  Outcome refine(const std::string& input, const std::string& options) const
  {
    return done(surface(input, "out.ply", options));
  }
  std::string refined(const std::string& input, const std::string& options) const
  {
    refine(input, "--quiet --output-normals control " + options);
    return content("out.ply");
  }
  std::string written(const Shape& s, const std::vector<Vector>& normals, std::size_t format,
                      int digits, bool is_fixed = true)
  {
    return folder.write(std::string("mesh") + formats[format].second,
                        file(s, normals, formats[format].first, digits, is_fixed));
  }
  void expect_data(const Shape& s, const std::vector<Vector>& normals, const std::string& name)
  {
    SCOPED_TRACE(name);
    for (const std::size_t format : {0u, 1u, 2u, 3u, 4u})
      for (const int digits : {4, 6, 9}) {
        const Outcome outcome = refine(written(s, normals, format, digits), "--levels 1");
        expect_no_part(outcome.err, "shading");
        expect_part(outcome.err, "normals of the file");
      }
  }
};

} // namespace

TEST_F(Pn_subdivide_shading, EachKindIsFoundWithItsDigits)
{
  const Shape quads = potato(), triangles = triangulated(quads);
  for (const Shape* s : {&quads, &triangles}) {
    const std::string plain = folder.write("plain.off", file(*s, {}, Format::off, 17));
    const std::string expected = refined(plain, "--levels 1");
    for (std::size_t kind = 0; kind < 5; ++kind)
      for (std::size_t format = 0; format < 5; ++format)
        for (const int digits : {4, 5, 6, 7, 8, 9})
          for (const bool is_fixed : {true, false}) {
            if (format >= 3 && (digits > 4 || !is_fixed)) continue;
            // all digits are written in each format, and for each kind
            if (!tests_are_full && format < 3 &&
                (std::size_t(digits) + kind + 2 * format) % 6 != (is_fixed ? 0u : 3u))
              continue;
            SCOPED_TRACE(std::to_string(kind) + formats[format].second + std::to_string(digits));
            const std::string input = written(*s, shading(*s, kind), format, digits, is_fixed);
            const Outcome outcome = refine(input, "--levels 1 --output-normals control");
            // a triangle's corners span its area
            const char* const name = s == &triangles && kind == 4 ? weights[1] : weights[kind];
            expect_part(outcome.err, std::string(name) + " (");
            expect_part(outcome.err, "estimated normals");
            expect_no_part(outcome.err, "warning");
            EXPECT_EQ(content("out.ply"), expected);
          }
  }
}

TEST_F(Pn_subdivide_shading, OthersAreTakenAndFileInsists)
{
  const Shape s = potato();
  const std::string input = written(s, shading(s, 2), 1, 4);
  const Outcome outcome = refine(input, "--normals file");
  expect_part(outcome.err, "normals of the file");
  expect_no_part(outcome.err, "shading");
  EXPECT_NE(refined(input, "--normals file"), refined(input, ""));
  for (const std::string options : {"--linear", "--normals estimate", "--normals sphere:0,0,0"})
    expect_no_part(refine(input, options).err, "shading");
  const std::string report = folder.file("r.json");
  refine(input, "--levels 1 --report '" + report + "'");
  const auto json = nlohmann::json::parse(Temporary_folder::content(report));
  ASSERT_EQ(json.at("notes").size(), 1u);
  expect_part(json.at("notes")[0].get<std::string>(), "shading normals");
}

// Four of five have to agree, within two units of the last digit and 2e-6.
TEST_F(Pn_subdivide_shading, HowManyAndHowClose)
{
  const Shape s = potato();
  const std::size_t all = s.points.size();
  const std::vector<Vector> exact = shading(s, 2);
  const auto is_found = [&](std::size_t others, long double off, int digits) {
    std::vector<Vector> normals = exact;
    for (std::size_t v = 0; v < others; ++v) {
      Vector side = cross(normals[v], {0.3L, 0.5L, 0.8L});
      // its largest coordinate is what is compared
      const long double largest =
        std::max({std::abs(side[0]), std::abs(side[1]), std::abs(side[2])});
      for (std::size_t k = 0; k < 3; ++k) normals[v][k] += off * side[k] / largest;
    }
    return contains(refine(written(s, normals, 1, digits), "").err, "shading");
  };
  EXPECT_TRUE(is_found(all / 5, 0.1L, 12));
  EXPECT_FALSE(is_found(all / 5 + 1, 0.1L, 12));
  EXPECT_TRUE(is_found(all, 1.95e-6L, 12));
  EXPECT_FALSE(is_found(all, 2.05e-6L, 12));
  EXPECT_TRUE(is_found(all, 1.2e-4L, 4)); // and rounding
  EXPECT_FALSE(is_found(all, 3.2e-4L, 4));
}

// Zero normals do not count, whatever their number.
TEST_F(Pn_subdivide_shading, MissingNormalsDoNotCount)
{
  const Shape s = potato();
  std::vector<Vector> normals = shading(s, 3);
  for (std::size_t v = 0; v < normals.size(); v += 2) normals[v] = {0, 0, 0};
  expect_part(refine(written(s, normals, 1, 6), "").err, "area times angle");
  // of any length
  for (std::size_t v = 0; v < normals.size(); ++v) normals[v] = scaled(0.01L * (1 + v), normals[v]);
  for (const bool is_fixed : {true, false})
    expect_part(refine(written(s, normals, 1, 7, is_fixed), "").err, "area times angle");
}

TEST_F(Pn_subdivide_shading, TrueNormalsAreData)
{
  const Shape even = ball(8, 6, on_sphere);
  expect_data(even, even.points, "sphere");
  const Shape uneven = ball(9, 7, [](long double t, long double u) {
    return on_sphere(t + 0.25L * std::sin(2 * t), u + 0.3L * std::sin(u));
  });
  expect_data(uneven, uneven.points, "uneven sphere");
  const Shape ellipsoid = ball(9, 7, [](long double t, long double u) {
    const Vector p = on_sphere(t, u + 0.3L * std::sin(u));
    return Vector{3 * p[0], 2 * p[1], p[2]};
  });
  std::vector<Vector> normals;
  for (const Vector& p : ellipsoid.points) normals.push_back(unit({p[0] / 9, p[1] / 4, p[2]}));
  expect_data(ellipsoid, normals, "ellipsoid");

  // by symmetry these agree with the sums, too
  const Shape tetrahedron{{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
                          {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
  normals.clear();
  for (const Vector& p : tetrahedron.points) normals.push_back(unit(p));
  expect_data(tetrahedron, normals, "tetrahedron");
  Shape torus;
  normals.clear();
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      const long double c[] = {1, 0, -1, 0}, z[] = {0, 1, 0, -1};
      const Vector n = {c[i] * c[j], z[i] * c[j], z[j]};
      torus.points.push_back({3 * c[i] + n[0], 3 * z[i] + n[1], n[2]});
      normals.push_back(n);
      torus.faces.push_back(
        {4 * i + j, 4 * ((i + 1) % 4) + j, 4 * ((i + 1) % 4) + (j + 1) % 4, 4 * i + (j + 1) % 4});
    }
  expect_data(torus, normals, "torus");
}

// A ring of rectangular section, its normals those of its four smooth parts at corners.
TEST_F(Pn_subdivide_shading, WedgesAndWashers)
{
  const int n = 12;
  const auto obj = [&](bool is_true, int digits) {
    Shape s; // of corners; vertex i of ring r is n r + i
    std::string text;
    const long double radius[] = {1, 2, 2, 1}, height[] = {0, 0, 0.7L, 0.7L};
    const auto turn = [&](int i) {
      return 2 * pi * i / n + (is_true ? 0.L : 0.3L * std::sin(2 * pi * i / n));
    };
    for (int r = 0; r < 4; ++r)
      for (int i = 0; i < n; ++i) {
        s.points.push_back(
          {radius[r] * std::cos(turn(i)), radius[r] * std::sin(turn(i)), height[r]});
        text += "v" + numbers(s.points.back(), 17, false) + "\n";
      }
    std::string faces;
    int number = 0;
    for (int r = 0; r < 4; ++r) { // each part with normals of its own
      Shape part{s.points, {}};
      for (int i = 0; i < n; ++i)
        part.faces.push_back(
          {n * r + i, n * r + (i + 1) % n, n * ((r + 1) % 4) + (i + 1) % n, n * ((r + 1) % 4) + i});
      const std::vector<Vector> sums = shading(part, 1);
      for (const std::vector<int>& f : part.faces) {
        faces += "f";
        for (const int v : f) {
          const Vector side = unit({s.points[std::size_t(v)][0], s.points[std::size_t(v)][1], 0});
          const Vector exact[] = {{0, 0, -1}, side, {0, 0, 1}, scaled(-1, side)};
          text += "vn" + numbers(is_true ? exact[r] : sums[std::size_t(v)], digits, true) + "\n";
          faces += " " + std::to_string(v + 1) + "//" + std::to_string(++number);
        }
        faces += "\n";
      }
    }
    return text + faces;
  };
  for (const int digits : {4, 9}) {
    Outcome outcome = refine(folder.write("washer.obj", obj(true, digits)), "");
    expect_no_part(outcome.err, "shading");
    expect_part(outcome.err, "48 edges, taken for creases");
    // planes agree with all sums, half of it; of uneven sides nothing agrees with the reciprocal one
    const std::string input = folder.write("washer.obj", obj(false, digits));
    outcome = refine(input, "");
    expect_part(outcome.err, "shading normals");
    expect_part(outcome.err, "48 edges, taken for creases");
    expect_part(outcome.err, "estimated normals, 48 sharp edges");
  }
}

// Their normals are then those of other faces; true ones are no more those of the faces than before.
TEST_F(Pn_subdivide_shading, PointsMayBeRounded)
{
  const auto rounded = [](Shape s, long double unit, long double scale) {
    for (Vector& p : s.points)
      for (long double& x : p) x = std::round(x / unit) * unit * scale;
    return s;
  };
  const Shape s = potato();
  std::vector<Vector> other = shading(s, 2);
  for (std::size_t v = 0; v < other.size(); ++v)
    other[v] = unit({other[v][0], other[v][1] + 0.15L, other[v][2]});
  for (const long double unit : {1e-3L, 1e-4L})
    for (const long double scale : {1.L, 1e-3L}) {
      const Shape coarse = rounded(s, unit, scale);
      for (std::size_t kind = 0; kind < 5; ++kind)
        expect_part(refine(written(coarse, shading(s, kind), 0, 6), "").err, weights[kind]);
      expect_no_part(refine(written(coarse, other, 0, 6), "").err, "shading");
    }
}

// Of a capsule and a ball beside it, both with the normals of balls.
TEST_F(Pn_subdivide_shading, NormalsFarFromTheFacesAreSetAside)
{
  Shape s = ball(10, 9, on_sphere);
  const std::size_t n = s.points.size();
  std::vector<Vector> normals;
  for (Vector& p : s.points) {
    p[2] += p[2] > 0 ? 0.8L : -0.8L;
    normals.push_back(unit(p));
  }
  const Shape one = ball(9, 8, on_sphere);
  Shape both = s;
  std::vector<Vector> normals_of_both = normals;
  for (const Vector& p : one.points) {
    both.points.push_back({p[0] + 4, p[1], p[2]});
    normals_of_both.push_back(p);
  }
  for (std::vector<int> f : one.faces) {
    for (int& v : f) v += int(n);
    both.faces.push_back(f);
  }
  const std::string options = "--levels 1 --normals ";
  Outcome outcome = refine(written(s, normals, 2, 9), "");
  expect_part(outcome.err, "on 1 of 1 components");
  expect_part(outcome.err, "estimated normals");
  const std::string input = written(both, normals_of_both, 2, 9);
  outcome = refine(input, "");
  expect_part(outcome.err, "on 1 of 2 components");
  for (const std::string more : {"file", "estimate", "auto --roundness 1"})
    EXPECT_EQ(contains(refine(input, options + more).err, "set aside"), more[0] == 'a') << more;
  const auto points = [&](const std::string& source) {
    refine(input, options + source);
    return read_mesh(folder.file("out.ply")).points;
  };
  const std::vector<Triple> now = points("auto"), file = points("file"),
                            estimate = points("estimate");
  for (std::size_t v = 0; v < n + one.points.size(); ++v)
    EXPECT_EQ(now[v], (v < n ? estimate : file)[v]) << v;
  EXPECT_NE(now, file);
  EXPECT_NE(now, estimate);
}

TEST_F(Pn_subdivide_shading, WhatAFileCallsControlNormalsAreData)
{
  const Shape s = potato();
  const std::string plain = folder.write("plain.off", file(s, {}, Format::off, 17));
  const std::string options = "--normals angle --levels 0 --output-normals ";
  for (const std::string choice : {"control", "both"}) {
    refine(plain, options + choice);
    const std::string input = folder.write("said.ply", content("out.ply"));
    expect_no_part(refine(input, "").err, "shading");
    EXPECT_EQ(refined(input, "--levels 2"), refined(plain, "--levels 2 --normals angle"));
  }
}

TEST_F(Pn_subdivide_shading, ExamplesOfThePackageAreData)
{
  for (const std::string name :
       {"sphere_quads", "sphere_mixed", "sphere_triangles", "sphere_cap", "torus_quads",
        "cylinder_quads", "cylinder_triangles", "cylinder_cap_8", "cube_on_sphere", "bezier_6",
        "saddle_5", "valences_3_to_12", "missing_normals"}) {
    const Outcome outcome = refine(std::string(PN_DATA_DIR "/") + name + ".ply", "");
    expect_part(outcome.err, "normals of the file");
  }
}

// --- digits ---

TEST(Written_digits, UnitOfTheLastDigit)
{
  const auto unit = [](std::vector<std::array<const char*, 3>> vectors, const Triple& of) {
    Written_digits digits;
    for (const auto& v : vectors) {
      Triple numbers;
      for (std::size_t k = 0; k < 3; ++k) numbers[k] = std::stod(v[k]);
      digits.see({v[0], v[1], v[2]}, numbers);
    }
    return digits.unit(of);
  };
  const Triple n = {0.6, 0, 0.8};
  EXPECT_EQ(unit({}, n), 0);
  EXPECT_DOUBLE_EQ(unit({{"0.6000", "0.0000", "0.8000"}}, n), 1e-4);
  EXPECT_DOUBLE_EQ(unit({{"0.6", "0", "0.8"}, {"1", "0", "0"}, {"0", "-.7071", ".7071"}}, n), 1e-4);
  EXPECT_DOUBLE_EQ(unit({{"0.70711", "0.70711", "1.2346e-05"}}, n), 1e-5);
  EXPECT_DOUBLE_EQ(unit({{"7.0711E-01", "7.0711E-01", "1.2346E-09"}}, n), 1e-5);
  EXPECT_DOUBLE_EQ(unit({{"1.0000e+00", "0", "0"}}, n), 1e-4); // 0.8 has one digit less
  EXPECT_DOUBLE_EQ(unit({{"71.2346", "0", "0"}, {"0.812346", "0", "0"}}, {71, 0, 0}), 1e-4);
  EXPECT_DOUBLE_EQ(unit({{"71.2346", "0", "0"}, {"0.812346", "0", "0"}}, n), 1e-6);
  EXPECT_EQ(unit({{"1", "0", "0"}}, {1, 0, 0}), 1);
}

// --- normals that oppose all their faces ---

TEST_F(Pn_subdivide_shading, RepairTurnsNormalsOver)
{
  const Shape s = ball(9, 7, on_sphere);
  const std::string good = folder.write("good.off", file(s, s.points, Format::off, 15));
  const std::string expected = refined(good, "--levels 2");
  for (const std::size_t step : {1u, 5u, 100u})
    for (const std::size_t format : {0u, 1u, 2u, 4u}) {
      std::vector<Vector> normals = s.points;
      std::size_t turned = 0;
      for (std::size_t v = 3 % step; v < normals.size(); v += step, ++turned)
        normals[v] = scaled(-1, normals[v]);
      const std::string input = written(s, normals, format, 15);
      const std::string number = std::to_string(turned);
      const Outcome without = refine(input, "--quiet");
      const std::string place = " (first: at vertex " + std::to_string(3 % step) + ")",
                        all = std::to_string(normals.size());
      expect_part(without.err, "warning: " + input + ": " + number + " of " + all +
                                 (turned == 1 ? " normals points" : " normals point") +
                                 " against the faces" + place);
      expect_part(without.err, "--repair turns");
      const std::string report = folder.file("r.json");
      const Outcome with = refine(input, "--quiet --repair --report '" + report + "'");
      expect_part(with.err, number + (turned == 1 ? " normal " : " normals ") +
                              "that opposed all faces turned over" + place);
      expect_no_part(with.err, "point against");
      EXPECT_EQ(nlohmann::json::parse(Temporary_folder::content(report)).at("repaired"),
                nlohmann::json({{"turned_normals", turned}}));
      if (format != 4) {
        EXPECT_EQ(refined(input, "--levels 2 --repair"), expected);
      }
      // which are not taken
      for (const std::string options :
           {"--linear", "--normals estimate", "--normals sphere:0,0,0"}) {
        EXPECT_EQ(refine(input, "--quiet --repair " + options).err, "");
        expect_no_part(refine(input, options).err, "point against");
      }
      for (const std::string options : {"--sharp angle:80", "--levels 0"})
        expect_part(refine(input, "--quiet " + options).err, place);
    }
  for (const char* const repair : {"--quiet --repair", "--quiet"})
    EXPECT_EQ(refine(good, repair).err, "");
}

// Of a box inside out with normals that point outwards the faces are turned, and the normals are right then.
TEST_F(Pn_subdivide_shading, FacesAreTurnedFirst)
{
  Shape s = ball(9, 7, on_sphere);
  for (std::vector<int>& f : s.faces) std::reverse(f.begin(), f.end());
  const Outcome outcome = refine(written(s, s.points, 1, 15), "--quiet --repair");
  expect_part(outcome.err, "1 closed component turned right side out");
  expect_no_part(outcome.err, "turned over");
}

// One that opposes some of its faces only stays as it is; of a wedge the faces of this wedge count.
TEST_F(Pn_subdivide_shading, OnlyThoseThatOpposeAllTheirFaces)
{
  const std::string points = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 -1\nv 1 0 -1\n";
  const std::string faces = "f 1//2 2//2 3//2 4//2\nf 5//1 6//1 2//1 1//1\n"; // up, and -y
  const auto err = [&](const std::string& up, const std::string& side) {
    return refine(folder.write("a.obj", points + "vn " + side + "\nvn " + up + "\n" + faces),
                  "--quiet --repair --sharp angle:30")
      .err;
  };
  expect_no_part(err("0 0 1", "0 -1 0"), "repaired");
  expect_part(err("0 0 -1", "0 -1 0"),
              "4 normals that opposed all faces turned over (first: at vertex 0)");
  expect_part(err("0 0 -1", "0 1 0"), "8 normals");
  const auto of_vertices = [&](const std::string& n) {
    std::string text =
      points + "vn " + n + "\nvn 0 0 1\nvn 0 -1 0\nf 1//1 2//1 3//2 4//2\nf 5//3 6//3 2//1 1//1\n";
    return refine(folder.write("a.obj", text), "--quiet --repair").err;
  };
  expect_no_part(of_vertices("0 0.8 0.6"), "turned over");
  expect_no_part(of_vertices("0 0.8 -0.0001"), "1 normal"); // both faces
  expect_part(of_vertices("0 0.8 -0.6"), "2 normals that opposed");
}

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
#include "Part_files.h"

#include "io/Mesh_data.h"
#include "io/mesh_io.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <utility>

using namespace pn_subdivide;

namespace {

const double pi = std::acos(-1.);

const char* const weights[] = {"with equal weights", "weighted by area", "weighted by angle",
                               "weighted by area times angle",
                               "weighted by the areas that their corners span"};

std::vector<Triple> shading(const Part& s, std::size_t kind)
{
  std::vector<Triple> sums(s.points.size(), Triple{0, 0, 0});
  for (std::size_t f = 0; f < s.faces.size(); ++f) {
    const std::vector<std::size_t>& face = s.faces[f];
    const double size = length(s.area(f));
    for (std::size_t i = 0; i < face.size(); ++i) {
      const auto edge_to = [&](std::size_t k) {
        return difference(s.points[face[(i + k) % face.size()]], s.points[face[i]]);
      };
      const Triple a = edge_to(1), b = edge_to(face.size() - 1);
      const double angle = std::acos(dot(unit(a), unit(b)));
      const double w[] = {1, size, angle, size * angle, length(cross(a, b))};
      sums[face[i]] = sum(sums[face[i]], unit(s.area(f)), w[kind]);
    }
  }
  for (Triple& n : sums) n = unit(n);
  return sums;
}

// neither round nor even
Part potato()
{
  return ball_of(9, 8, [](double t, double u) {
    const double a = t + 0.25 * std::sin(2 * t), b = u + 0.3 * std::sin(u);
    const double r = 1 + 0.2 * std::sin(3 * b) * std::sin(a);
    return Triple{2 * r * std::sin(a) * std::cos(b), r * std::sin(a) * std::sin(b) + 0.1 * r * r,
                  1.5 * r * std::cos(a)};
  });
}

// --- files ---

enum class Format { obj, off, ply, binary_float, binary_double };
const std::pair<Format, const char*> formats[] = {{Format::obj, ".obj"},
                                                  {Format::off, ".off"},
                                                  {Format::ply, ".ply"},
                                                  {Format::binary_float, ".ply"},
                                                  {Format::binary_double, ".ply"}};

std::string binary_file(const Part& s, const std::vector<Triple>& normals, bool is_float)
{
  std::string bytes = s.ply(normals);
  bytes.erase(bytes.find("end_header\n") + 11);
  bytes.replace(bytes.find("ascii"), 5, "binary_little_endian");
  for (const char* const name : {"nx", "ny", "nz"})
    if (is_float) bytes.replace(bytes.find("double " + std::string(name)), 6, "float");
  for (std::size_t v = 0; v < s.points.size(); ++v) {
    for (const double x : s.points[v]) bytes += raw(x, false);
    for (const double x : normals[v]) bytes += is_float ? raw(float(x), false) : raw(x, false);
  }
  for (const auto& f : s.faces) {
    bytes += char(f.size());
    for (const std::size_t v : f) bytes += raw(int(v), false);
  }
  return bytes;
}

std::string file(const Part& s, const std::vector<Triple>& normals, Format format,
                 const Digits& digits)
{
  switch (format) {
  case Format::obj:
    return s.obj(normals, digits);
  case Format::off:
    return s.off(normals, digits);
  case Format::ply:
    return s.ply(normals, {}, digits);
  default:
    return binary_file(s, normals, format == Format::binary_float);
  }
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
  std::string written(const Part& s, const std::vector<Triple>& normals, std::size_t format,
                      int digits, bool is_fixed = true)
  {
    return folder.write(std::string("mesh") + formats[format].second,
                        file(s, normals, formats[format].first, {digits, is_fixed}));
  }
  void expect_data(const Part& s, const std::vector<Triple>& normals, const std::string& name)
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
  const Part quads = potato(), triangles = triangulated(quads);
  for (const Part* s : {&quads, &triangles}) {
    const std::string plain = folder.write("plain.off", s->off());
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
  const Part s = potato();
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
  const Part s = potato();
  const std::size_t all = s.points.size();
  const std::vector<Triple> exact = shading(s, 2);
  const auto is_found = [&](std::size_t others, double off, int digits) {
    std::vector<Triple> normals = exact;
    for (std::size_t v = 0; v < others; ++v) {
      const Triple side = cross(normals[v], {0.3, 0.5, 0.8});
      // its largest coordinate is what is compared
      const double largest = std::max({std::abs(side[0]), std::abs(side[1]), std::abs(side[2])});
      normals[v] = sum(normals[v], side, off / largest);
    }
    return contains(refine(written(s, normals, 1, digits), "").err, "shading");
  };
  EXPECT_TRUE(is_found(all / 5, 0.1, 12));
  EXPECT_FALSE(is_found(all / 5 + 1, 0.1, 12));
  EXPECT_TRUE(is_found(all, 1.95e-6, 12));
  EXPECT_FALSE(is_found(all, 2.05e-6, 12));
  EXPECT_TRUE(is_found(all, 1.2e-4, 4)); // and rounding
  EXPECT_FALSE(is_found(all, 3.2e-4, 4));
}

// Zero normals do not count, whatever their number.
TEST_F(Pn_subdivide_shading, MissingNormalsDoNotCount)
{
  const Part s = potato();
  std::vector<Triple> normals = shading(s, 3);
  for (std::size_t v = 0; v < normals.size(); v += 2) normals[v] = {0, 0, 0};
  expect_part(refine(written(s, normals, 1, 6), "").err, "area times angle");
  // of any length
  for (std::size_t v = 0; v < normals.size(); ++v)
    normals[v] = sum({}, normals[v], 0.01 * double(1 + v));
  for (const bool is_fixed : {true, false})
    expect_part(refine(written(s, normals, 1, 7, is_fixed), "").err, "area times angle");
}

TEST_F(Pn_subdivide_shading, TrueNormalsAreData)
{
  const Part even = ball_of(8, 6, on_sphere);
  expect_data(even, even.points, "sphere");
  const Part uneven = ball_of(9, 7, [](double t, double u) {
    return on_sphere(t + 0.25 * std::sin(2 * t), u + 0.3 * std::sin(u));
  });
  expect_data(uneven, uneven.points, "uneven sphere");
  const Part ellipsoid = ball_of(9, 7, [](double t, double u) {
    const Triple p = on_sphere(t, u + 0.3 * std::sin(u));
    return Triple{3 * p[0], 2 * p[1], p[2]};
  });
  std::vector<Triple> normals;
  for (const Triple& p : ellipsoid.points) normals.push_back(unit({p[0] / 9, p[1] / 4, p[2]}));
  expect_data(ellipsoid, normals, "ellipsoid");

  // by symmetry these agree with the sums, too
  const Part tetrahedron{{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
                         {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
  normals.clear();
  for (const Triple& p : tetrahedron.points) normals.push_back(unit(p));
  expect_data(tetrahedron, normals, "tetrahedron");
  const Torus torus(4, 4, 3, 1);
  expect_data(torus, torus.normals, "torus");
}

// A ring of rectangular section, its normals those of its four smooth parts at corners.
TEST_F(Pn_subdivide_shading, WedgesAndWashers)
{
  constexpr std::size_t n = 12;
  const auto obj = [&](bool is_true, int digits) {
    Part s; // vertex i of ring r is n r + i, face i of part r as well
    const double radius[] = {1, 2, 2, 1}, height[] = {0, 0, 0.7, 0.7};
    for (std::size_t r = 0; r < 4; ++r)
      for (std::size_t i = 0; i < n; ++i) {
        const double a = 2 * pi * double(i) / n, u = a + (is_true ? 0 : 0.3 * std::sin(a));
        s.points.push_back({radius[r] * std::cos(u), radius[r] * std::sin(u), height[r]});
        const std::size_t j = (i + 1) % n, next = n * ((r + 1) % 4);
        s.faces.push_back({n * r + i, n * r + j, next + j, next + i});
      }
    const auto sums_of_part = [&](std::size_t r) {
      const auto begin = s.faces.begin() + std::ptrdiff_t(n * r);
      return shading({s.points, {begin, begin + std::ptrdiff_t(n)}}, 1);
    };
    const std::vector<Triple> sums[] = {sums_of_part(0), sums_of_part(1), sums_of_part(2),
                                        sums_of_part(3)};
    const auto normal = [&](std::size_t f, std::size_t i) {
      const std::size_t r = f / n, v = s.faces[f][i];
      const Triple side = unit({s.points[v][0], s.points[v][1], 0});
      const Triple exact[] = {{0, 0, -1}, side, {0, 0, 1}, sum({}, side, -1)};
      return is_true ? exact[r] : sums[r][v];
    };
    return s.obj_of_corners(normal, {digits, true});
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
  const auto rounded = [](Part s, double steps, double shrink) {
    for (Triple& p : s.points)
      for (double& x : p) x = std::round(steps * x) / (steps * shrink);
    return s;
  };
  const Part s = potato();
  std::vector<Triple> other = shading(s, 2);
  for (std::size_t v = 0; v < other.size(); ++v)
    other[v] = unit({other[v][0], other[v][1] + 0.15, other[v][2]});
  for (const double steps : {1e3, 1e4})
    for (const double shrink : {1., 1e3}) {
      const Part coarse = rounded(s, steps, shrink);
      for (std::size_t kind = 0; kind < 5; ++kind)
        expect_part(refine(written(coarse, shading(s, kind), 0, 6), "").err, weights[kind]);
      expect_no_part(refine(written(coarse, other, 0, 6), "").err, "shading");
    }
}

// Of a capsule and a ball beside it, both with the normals of balls.
TEST_F(Pn_subdivide_shading, NormalsFarFromTheFacesAreSetAside)
{
  Part s = ball_of(10, 9, on_sphere);
  const std::size_t n = s.points.size();
  std::vector<Triple> normals;
  for (Triple& p : s.points) {
    p[2] += p[2] > 0 ? 0.8 : -0.8;
    normals.push_back(unit(p));
  }
  const Part one = ball_of(9, 8, on_sphere);
  Part both = s;
  both.add(one, {4, 0, 0}, false);
  std::vector<Triple> normals_of_both = normals;
  normals_of_both.insert(normals_of_both.end(), one.points.begin(), one.points.end());
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
  const Part s = potato();
  const std::string plain = folder.write("plain.off", s.off());
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
  const Part s = ball_of(9, 7, on_sphere);
  const std::string good = folder.write("good.off", s.off(s.points, {15, true}));
  const std::string expected = refined(good, "--levels 2");
  for (const std::size_t step : {1u, 5u, 100u})
    for (const std::size_t format : {0u, 1u, 2u, 4u}) {
      std::vector<Triple> normals = s.points;
      std::size_t turned = 0;
      for (std::size_t v = 3 % step; v < normals.size(); v += step, ++turned)
        normals[v] = sum({}, normals[v], -1);
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
  Part s = ball_of(9, 7, on_sphere);
  for (auto& f : s.faces) std::reverse(f.begin(), f.end());
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

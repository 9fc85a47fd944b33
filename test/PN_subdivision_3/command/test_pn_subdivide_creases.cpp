// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Creases of the command: --sharp, --sharpness, --border, selections, and normals of corners.

#include "Command_test.h"
#include "Extent.h"
#include "Part_files.h"

#include <array>
#include <cmath>
#include <limits>
#include <utility>

using pn_subdivide::Triple;

namespace {

using Real = long double;
using Vec = std::array<Real, 3>;

Real dot(const Vec& a, const Vec& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vec sum(const Vec& a, const Vec& b, Real t = 1)
{
  return {a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2]};
}
Real length(const Vec& a)
{
  return std::sqrt(dot(a, a));
}

// plane, cylinder or sphere as the files of parts describe it
struct Shape
{
  std::string name, kind;
  Vec c{}, d{};
  Real r = 0;

  // from the surface, in the direction in which its normals are
  Vec away(const Vec& p) const
  {
    const Vec v = sum(p, c, -1);
    if (kind == "sphere") return v;
    if (kind == "plane") return d;
    return sum(v, d, -dot(v, d) / dot(d, d));
  }
  Real distance(const Vec& p) const
  {
    if (kind == "plane") return std::abs(dot(sum(p, c, -1), d)) / length(d);
    return std::abs(length(away(p)) - r);
  }
  // of normals, which may point inwards
  Real error(const Vec& p, const Vec& n) const
  {
    Vec m = away(p);
    const Real size = length(m) * (dot(m, n) < 0 ? -1 : 1);
    for (Real& x : m) x /= size;
    return length(sum(n, m, -1));
  }
};

// read with nothing of the package
struct Obj
{
  std::vector<Vec> points, normals;
  std::vector<std::vector<std::array<std::size_t, 2>>> faces; // (vertex, normal)
  std::vector<std::size_t> groups;                            // of faces
  std::vector<Shape> shapes;

  explicit Obj(const std::string& file)
  {
    std::ifstream in(file);
    std::size_t group = 0;
    for (std::string line; std::getline(in, line);) {
      std::istringstream words(line);
      std::string keyword;
      words >> keyword;
      Vec p{};
      if (keyword == "#") read_shape(words);
      if (keyword == "v" || keyword == "vn") {
        words >> p[0] >> p[1] >> p[2];
        (keyword == "v" ? points : normals).push_back(p);
      }
      if (keyword == "g") {
        std::string name;
        words >> name;
        for (std::size_t i = 0; i < shapes.size(); ++i)
          if (shapes[i].name == name) group = i;
      }
      if (keyword != "f") continue;
      faces.emplace_back();
      groups.push_back(group);
      for (std::string word; words >> word;) {
        const std::size_t slashes = word.find("//");
        faces.back().push_back(
          {std::stoul(word) - 1,
           slashes == std::string::npos ? 0 : std::stoul(word.substr(slashes + 2)) - 1});
      }
    }
  }

  void read_shape(std::istringstream& words)
  {
    Shape s;
    std::string group, is, text;
    words >> group >> s.name >> is >> text;
    if (group != "group") return;
    s.kind = text.substr(0, text.find(':'));
    std::replace(text.begin(), text.end(), ',', ' ');
    std::istringstream numbers(text.substr(s.kind.size() + 1));
    numbers >> s.c[0] >> s.c[1] >> s.c[2];
    if (s.kind != "sphere") numbers >> s.d[0] >> s.d[1] >> s.d[2];
    if (s.kind != "plane") numbers >> s.r;
    shapes.push_back(s);
  }

  Real greatest_coordinate() const
  {
    Real greatest = 0;
    for (const Vec& p : points)
      for (const Real x : p) greatest = (std::max)(greatest, std::abs(x));
    return greatest;
  }
};

// The first child of a face keeps its number, the others are behind all old faces, face by face.
std::vector<std::size_t> refined_groups(const Obj& control, int rounds)
{
  std::vector<std::size_t> groups = control.groups;
  for (int k = 0; k < rounds; ++k)
    for (std::size_t f = 0, n = groups.size(); f < n; ++f)
      groups.insert(groups.end(), (k == 0 ? control.faces[f].size() : 4) - 1, groups[f]);
  return groups;
}

const Real epsilon = std::numeric_limits<double>::epsilon();

std::string part(const std::string& name)
{
  return PN_DATA_DIR "/parts/" + name;
}

const char* const parts[] = {
  "capped_cylinder", "half_ball",        "lens",           "washer", "bolt", "d_section",
  "bracket",         "plate_with_holes", "bearing_housing"};

const std::string cube_obj = // from -1 to 1, a normal per face
  "v -1 -1 -1\nv 1 -1 -1\nv -1 1 -1\nv 1 1 -1\nv -1 -1 1\nv 1 -1 1\nv -1 1 1\nv 1 1 1\n"
  "vn -1 0 0\nvn 1 0 0\nvn 0 -1 0\nvn 0 1 0\nvn 0 0 -1\nvn 0 0 1\n"
  "f 1//1 5//1 7//1 3//1\nf 2//2 4//2 8//2 6//2\nf 1//3 2//3 6//3 5//3\n"
  "f 3//4 7//4 8//4 4//4\nf 1//5 3//5 4//5 2//5\nf 5//6 6//6 8//6 7//6\n";

// a prism without normals; its sides are those of the unit cylinder
std::string prism_off()
{
  std::vector<Triple> corners;
  for (const double a : {0, 11, 29, 40, 55, 72, 84})
    corners.push_back({std::cos(a * std::acos(-1.) / 50), std::sin(a * std::acos(-1.) / 50), 0});
  return pn_subdivide::prism(corners, 2).off();
}

class Pn_subdivide_creases : public Command_test
{
protected:
  // Runs the command, which must succeed; the result's path.
  std::string refine(const std::string& input, const std::string& options,
                     const std::string& name = "result.obj") const
  {
    warnings(input, options, name);
    return folder.file(name);
  }
  std::string warnings(const std::string& input, const std::string& options,
                       const std::string& name = "result.obj") const
  {
    return done(surface(input, name, options + " --quiet")).err;
  }

  void expect_refusal(const std::string& input, const std::string& options, int code,
                      const std::string& what) const
  {
    expect_one_line(surface(input, "no.obj", options), code, what);
    EXPECT_FALSE(std::filesystem::exists(folder.file("no.obj")));
  }
};

// The greatest deviations of points and of normals from the shapes of the faces, in units of 2^-52:
// points relative to the greatest coordinate or the radius. Normals are compared with those at the
// points as they are, which turn them by the error of the points over the radius.
struct Errors
{
  Real points = 0, normals = 0;
};
Errors errors(const Obj& control, const Obj& refined, const std::vector<std::size_t>& groups)
{
  Errors e;
  const Real size = control.greatest_coordinate();
  EXPECT_EQ(refined.faces.size(), groups.size());
  for (std::size_t f = 0; f < groups.size(); ++f)
    for (const auto& [v, n] : refined.faces[f]) {
      const Shape& shape = control.shapes[groups[f]];
      const Vec& p = refined.points[v];
      e.points = (std::max)(e.points, shape.distance(p) / epsilon / (std::max)(size, shape.r));
      if (!refined.normals.empty())
        e.normals = (std::max)(e.normals,
                               shape.error(p, refined.normals[n]) / epsilon /
                                 (shape.kind == "plane" ? 1 : (std::max)(size / shape.r, Real(1))));
    }
  return e;
}

// The points of the levels and of the limit, with control normals and those of the surface; linear ones are not there.
TEST_F(Pn_subdivide_creases, PartsKeepTheirPlanesCylindersAndSpheres)
{
  for (const std::string name : parts) {
    SCOPED_TRACE(name);
    const Obj control(part(name + ".obj"));
    const int rounds = tests_are_full ? 4 : 2;
    const auto errors_of = [&](const std::string& options) {
      return errors(control,
                    Obj(refine(part(name + ".obj"),
                               "--scheme catmull-clark --levels " + std::to_string(rounds) +
                                 " --sharp '" + part(name + ".selection.txt") + "'" + options)),
                    refined_groups(control, rounds));
    };
    for (const char* const limit : {"", " --limit"}) {
      const Errors pn = errors_of(std::string(" --output-normals control") + limit);
      EXPECT_LE(pn.points, 8) << limit;
      EXPECT_LE(pn.normals, 8) << limit;
    }
    EXPECT_LE(errors_of(" --limit --surface-normals").normals * epsilon, 1e-12);
    EXPECT_GE(errors_of(" --linear").points * epsilon, 1e-3);
  }
}

TEST_F(Pn_subdivide_creases, LimitsAreTheSameAtEveryLevel)
{
  const std::string plate = PN_DATA_DIR "/creased_plate.ply";
  for (const auto& [input, options] :
       {std::pair(part("lens.obj"), "--sharp file"),
        std::pair(part("lens.obj"), "--sharp file --linear --surface-normals"),
        std::pair(part("lens.obj"), "--sharp file --normal-scheme modified-catmull-clark"),
        std::pair(plate, "--border curve"),
        std::pair(plate, "--border corners --sharp angle:30")}) {
    std::vector<std::vector<Vec>> points;
    for (const char* levels : {"0", "1", "3"})
      points.push_back(Obj(refine(input, std::string("--scheme catmull-clark --limit ") + options +
                                           " --levels " + levels))
                         .points);
    for (std::size_t v = 0; v < points[0].size(); ++v) {
      EXPECT_LE(length(sum(points[0][v], points[1][v], -1)), 1e-8) << options;
      EXPECT_LE(length(sum(points[0][v], points[2][v], -1)), 1e-8) << options;
    }
  }
}

TEST_F(Pn_subdivide_creases, LimitsNeedWhatIsSmoothOrSharpForEver)
{
  const std::string input = part("lens.obj");
  const std::string options = "--sharp file --sharpness 1.5 --limit --levels ";
  expect_refusal(input, options + "1", 2, "take --levels 2 or more");
  done(surface(input, "limit.obj", options + "2"));
}

TEST_F(Pn_subdivide_creases, TrianglesOfPartsKeepTheNormalsOfTheirCorners)
{
  for (const std::string name : {"capped_cylinder", "lens", "plate_with_holes"}) {
    const Obj control(part(name + ".obj"));
    const Obj refined(
      refine(part(name + ".obj"), "--triangulate --levels 3 --output-normals control"));
    const Real size = control.greatest_coordinate();
    for (const auto& face : refined.faces) {
      EXPECT_EQ(face.size(), 3u);
      const auto fits = [&](const Shape& s) {
        return std::all_of(face.begin(), face.end(), [&](const auto& corner) {
          const Vec& p = refined.points[corner[0]];
          return s.distance(p) <= 8 * epsilon * (std::max)(size, s.r) &&
                 s.error(p, refined.normals[corner[1]]) <= 8 * epsilon;
        });
      };
      EXPECT_TRUE(std::any_of(control.shapes.begin(), control.shapes.end(), fits)) << name;
    }
  }
}

TEST_F(Pn_subdivide_creases, NormalsOfTheFileAnglesAndSelectionsFindTheSameCreases)
{
  const std::string input = part("capped_cylinder.obj");
  const std::string expected = content(refine(input, "--levels 2"));
  for (const std::string& sharp : {std::string("auto"), std::string("file"),
                                   std::string("angle:75"), part("capped_cylinder.selection.txt")})
    EXPECT_EQ(content(refine(input, "--levels 2 --sharp '" + sharp + "'")), expected) << sharp;
  expect_part(surface(input, "result.obj", "").err, "14 sharp edges");
  // tangent surfaces have the same normals along their edge
  const std::string bracket = part("bracket.obj");
  EXPECT_NE(content(refine(bracket, "--sharp file")),
            content(refine(bracket, "--sharp '" + part("bracket.selection.txt") + "'")));
}

TEST_F(Pn_subdivide_creases, PrismsNeedPointsAndAnAngleOnly)
{
  const std::string input = folder.write("prism.off", prism_off());
  const Obj refined(refine(input, "--levels 4 --sharp angle:75 --output-normals control"));
  Shape side;
  side.kind = "cylinder";
  side.d = {0, 0, 1};
  side.r = 1;
  for (const auto& face : refined.faces)
    for (const auto& [v, n] : face) {
      const Vec &p = refined.points[v], &normal = refined.normals[n];
      if (std::abs(normal[2]) > 0.5) {
        EXPECT_TRUE(p[2] == 0 || p[2] == 2);
        EXPECT_LE(length(sum(normal, {0, 0, p[2] - 1}, -1)), 8 * epsilon);
      } else {
        EXPECT_LE(side.distance(p), 16 * epsilon); // 8 of the size, which is 2
        EXPECT_LE(side.error(p, normal), 8 * epsilon);
      }
    }
}

// All edges of a prism of twelve sides that are not those of its rims meet at exactly 30 degrees.
TEST_F(Pn_subdivide_creases, AnglesAreMeantWithATenthOfADegree)
{
  for (int pose = 0; pose < (tests_are_full ? 12 : 3); ++pose) {
    const double a = 0.7 * pose, b = 1.1 * pose * pose;
    pn_subdivide::Part prism = pn_subdivide::regular_prism(12, 2);
    for (Triple& p : prism.points) {
      const double y = std::cos(a) * p[1] - std::sin(a) * p[2];
      p = {std::cos(b) * p[0] - std::sin(b) * y, std::sin(b) * p[0] + std::cos(b) * y,
           std::sin(a) * p[1] + std::cos(a) * p[2]};
    }
    const std::string input = folder.write("prism.off", prism.off());
    const auto said = [&](const std::string& angle) {
      return surface(input, "a.obj", "--sharp angle:" + angle).err;
    };
    expect_part(said("30"), ", 24 sharp edges, 12 edges within 1 degree of 30, ");
    expect_part(said("29.95"), ", 24 sharp edges, 12 edges within 1 degree of 29.95, ");
    expect_part(said("29.8"), ", 36 sharp edges, 12 edges within 1 degree of 29.8, ");
    expect_part(said("29"), ", 36 sharp edges, 12 edges within 1 degree of 29, ");
    expect_part(said("31"), ", 24 sharp edges, 12 edges within 1 degree of 31, ");
    expect_part(said("90"), ", 24 edges within 1 degree of 90, ");
    for (const char* angle : {"28.5", "32", "60", "180"})
      EXPECT_EQ(said(angle).find("within"), std::string::npos) << angle;
    expect_part(said("0.5"), ", 36 sharp edges, ");
  }
}

TEST_F(Pn_subdivide_creases, NoneSumsTheNormals)
{
  const std::string input = part("washer.obj");
  expect_part(warnings(input, "--sharp none --levels 0", "sums.ply"),
              "32 vertices have several normals; their normalized sum is taken");
  const std::string sums = folder.file("sums.ply");
  EXPECT_EQ(content(refine(input, "--sharp none --levels 2", "a.ply")),
            content(refine(sums, "--levels 2", "b.ply")));
  EXPECT_EQ(content(refine(input, "--sharp none --levels 2 --linear", "a.ply")),
            content(refine(sums, "--levels 2 --linear", "b.ply")));
}

TEST_F(Pn_subdivide_creases, CubesOfFlatShadingHaveCreases)
{
  const std::string input = folder.write("cube.obj", cube_obj);
  EXPECT_EQ(warnings(input, "--levels 3 --sharp file"), "");
  EXPECT_EQ(content(folder.file("result.obj")), content(refine(input, "--levels 3")));
  const Obj cube(folder.file("result.obj"));
  for (const auto& face : cube.faces)
    for (const auto& [v, n] : face) EXPECT_EQ(dot(cube.points[v], cube.normals[n]), 1);
  EXPECT_EQ(cube.normals.size(), 6u * 81);
  expect_part(surface(input, "result.obj", "--sharp file").err,
              "normals of the file, 12 sharp edges,");
}

TEST_F(Pn_subdivide_creases, NoRoundsCopyTheNormalsOfCorners)
{
  for (const std::string name : {"capped_cylinder", "bolt"}) {
    const Obj before(part(name + ".obj")), after(refine(part(name + ".obj"), "--levels 0"));
    EXPECT_EQ(before.points, after.points);
    ASSERT_EQ(before.faces.size(), after.faces.size());
    for (std::size_t f = 0; f < before.faces.size(); ++f)
      for (std::size_t i = 0; i < before.faces[f].size(); ++i) {
        EXPECT_EQ(before.faces[f][i][0], after.faces[f][i][0]);
        EXPECT_EQ(before.normals[before.faces[f][i][1]], after.normals[after.faces[f][i][1]]);
      }
  }
}

// What is left of it after some rounds, and that these are the rounds of one call: test_pn_subdivide_tags.
TEST_F(Pn_subdivide_creases, SharpnessIsTheNumberOfSharpRounds)
{
  const std::string cube = PN_DATA_DIR "/cube.off";
  const std::string sharp = "--linear --sharp angle:45 ";
  const std::string one = refine(cube, sharp + "--levels 1", "one.off");
  EXPECT_EQ(content(refine(cube, sharp + "--levels 1 --sharpness 1", "a.off")), content(one));
  EXPECT_EQ(content(refine(cube, sharp + "--levels 1 --sharpness inf", "a.off")), content(one));
  expect_part(surface(cube, "a.ply", sharp + "--sharpness 2.5").err,
              "12 sharp edges of sharpness 2.5");
  EXPECT_EQ(warnings(cube, sharp + "--sharpness 0", "a.off"),
            "warning: " + cube + ": no edge is sharp\n");
}

// a hexagon in the plane
TEST_F(Pn_subdivide_creases, Borders)
{
  pn_subdivide::Part hexagon = pn_subdivide::regular_prism(6, 1);
  hexagon.points.resize(6);
  hexagon.faces = {{0, 1, 2, 3, 4, 5}};
  const std::string input = folder.write("hexagon.off", hexagon.off());
  const auto border =
    [&](const std::string& rule) { // of the result: the points with one face or two
      const Obj refined(refine(input, "--levels 3 --border " + rule));
      std::map<std::size_t, int> faces;
      for (const auto& face : refined.faces)
        for (const auto& corner : face) ++faces[corner[0]];
      std::vector<Vec> points;
      for (const auto& [v, number] : faces)
        if (number <= 2) points.push_back(refined.points[v]);
      EXPECT_EQ(points.size(), 48u);
      return points;
    };
  const auto farthest = [](const std::vector<Vec>& points) {
    Real d = 0;
    for (const Vec& p : points) d = (std::max)(d, std::abs(length(p) - 1));
    return d;
  };
  EXPECT_LE(farthest(border("curve")), 8 * epsilon);
  EXPECT_GE(farthest(border("surface")), 0.05);
  EXPECT_EQ(border("surface"), border("surface --sharp none"));
  for (const char* rule : {"corners", "fixed"}) { // the hexagon stays
    Real least = 1;
    for (const Vec& p : border(rule)) {
      Real support = 0;
      for (int i = 0; i < 6; ++i)
        support = (std::max)(support, p[0] * std::cos((i + 0.5L) * std::acos(-1.L) / 3) +
                                        p[1] * std::sin((i + 0.5L) * std::acos(-1.L) / 3));
      EXPECT_NEAR(double(support), std::sqrt(0.75), 1e-15) << rule;
      least = (std::min)(least, length(p));
    }
    EXPECT_NEAR(double(least), std::sqrt(0.75), 1e-15) << rule;
  }
  expect_part(surface(input, "a.ply", "--border fixed").err, "the border fixed");
  EXPECT_EQ(warnings(PN_DATA_DIR "/cube.off", "--border curve"),
            "warning: " PN_DATA_DIR "/cube.off: there is no border for --border\n");
}

TEST_F(Pn_subdivide_creases, SelectionsNumberTheVerticesOfTheFile)
{
  // every face has vertices of its own; those of the first edge have the numbers 1 and 2
  const auto box = pn_subdivide::box_of_squares(1, {-1, -1, -1}, {2, 2, 2});
  pn_subdivide::Part apart;
  for (const auto& face : box.faces) {
    apart.faces.emplace_back();
    for (const std::size_t v : face) {
      apart.faces.back().push_back(apart.points.size());
      apart.points.push_back(box.points[v]);
    }
  }
  const std::string input = folder.write("cube24.off", apart.off());
  const std::string selection = folder.write("a.selection.txt", "\n\n21 22\n");
  const Outcome outcome = surface(input, "a.ply", "--merge-points --sharp '" + selection + "'");
  expect_part(outcome.err, ", 1 sharp edge,");
  // its middle is the only edge point of a crease: it stays on the edge's line
  const std::string refined =
    refine(input, "--linear --merge-points --sharp '" + selection + "'", "a.obj");
  int on_edges = 0;
  for (const Vec& p : Obj(refined).points)
    on_edges += std::count_if(p.begin(), p.end(), [](Real x) { return std::abs(x) == 1; }) >= 2;
  EXPECT_EQ(on_edges, 1);

  const std::string cube = PN_DATA_DIR "/cube.off";
  const std::string corner = folder.write("b.selection.txt", "0 3 \n \n\n");
  expect_part(surface(cube, "a.ply", "--sharp '" + corner + "'").err, ", 2 corners,");
  expect_part(warnings(cube, "--sharp '" + folder.write("c.selection.txt", "\n0 1\n0 1\n") + "'"),
              "c.selection.txt: the faces of the selection take no part");
}

TEST_F(Pn_subdivide_creases, RepairedFilesKeepTheNormalsOfCorners)
{
  std::string reversed = cube_obj;
  const std::string face = "f 5//6 6//6 8//6 7//6";
  reversed.replace(reversed.find(face), face.size(), "f 7//6 8//6 6//6 5//6");
  reversed += "f 5//6 6//6 8//6 7//6\n";
  reversed.insert(reversed.find("f 1"), "f 1//3 2//3 2//3\n"); // all others move up
  const std::string options = "--levels 2 --repair --sharp file";
  const Obj cube(refine(folder.write("reversed.obj", reversed), options));
  for (const auto& f : cube.faces)
    for (const auto& [v, n] : f) EXPECT_EQ(dot(cube.points[v], cube.normals[n]), 1);
  EXPECT_EQ(cube.faces.size(), 6u * 16);
}

TEST_F(Pn_subdivide_creases, WhatIsLostIsSaid)
{
  const std::string washer = part("washer.obj");
  for (const std::string format : {"ply", "off", "vtp"})
    expect_part(warnings(washer, "--output-normals auto", "result." + format),
                "result." + format +
                  ": vertices on creases have several "
                  "normals, " +
                  format);
  expect_no_part(warnings(washer, ""), "several normals");
  // normals of vertices
  const std::string ply = refine(washer, "--levels 0 --sharp none", "washer.ply");
  expect_part(warnings(ply, "--sharp angle:80"),
              "32 vertices on creases have one normal in the file and need several");
  // of corners that no crease separates: the outline is smooth at 45 degrees
  expect_part(warnings(washer, "--sharp '" + folder.write("a.selection.txt", "\n\n0 1\n") + "'"),
              "several normals that no crease separates");
  EXPECT_EQ(warnings(PN_DATA_DIR "/cube.off", "--sharp angle:100"),
            "warning: " PN_DATA_DIR "/cube.off: no edge is sharp\n");
}

TEST_F(Pn_subdivide_creases, CurvatureIsNotMeasuredAcrossCreases)
{
  const std::string input = folder.write("cube.obj", cube_obj);
  refine(input, "--levels 2 --sharp file --curvature gaussian --ascii", "k.ply");
  const std::vector<double> curvature = columns_of("k.ply").at("gaussian_curvature");
  EXPECT_EQ(curvature.size(), 98u);
  for (const double x : curvature) EXPECT_NEAR(x, 0, 1e-12);
}

TEST_F(Pn_subdivide_creases, SchemesWithoutCreases)
{
  const std::string washer = part("washer.obj");
  const std::string said = warnings(washer, "--scheme kobbelt");
  expect_part(said, "32 vertices have several normals; their normalized sum is taken");
  expect_refusal(washer, "--scheme kobbelt --sharp file", 2,
                 "--sharp file: kobbelt has no rules for creases");
  expect_refusal(washer, "--scheme doo-sabin --sharp angle:40", 2, "doo-sabin has no rules");
  expect_refusal(washer, "--scheme sqrt3 --border curve", 2, "--border curve: sqrt3 has no rules");
  expect_refusal(washer, "--scheme butterfly --sharpness 2", 2, "--sharpness 2: butterfly");
  expect_refusal(washer, "--scheme midpoint --sharp angle:40", 2, "--sharp angle:40: midpoint");
  expect_refusal(washer, "--scheme bilinear --border curve", 2, "--border curve: bilinear");
  expect_refusal(washer, "--scheme catmull-clark --normal-scheme kobbelt --border fixed", 2,
                 "kobbelt has no rules");
  done(surface(washer, "a.obj", "--scheme kobbelt --sharp none"));
}

TEST_F(Pn_subdivide_creases, WrongOptionsAreRefused)
{
  const std::string cube = PN_DATA_DIR "/cube.off";
  const struct
  {
    const char *options, *what;
  } wrong[] = {{"--sharp angle:181", "between 0 and 180"},
               {"--sharp angle:-1", "between 0 and 180"},
               {"--sharp angle:x", "'x' is not a number"},
               {"--sharp angle", "is not a number"},
               {"--sharp ''", "selection file"},
               {"--sharp -", "selection file"},
               {"--sharpness -1", "must not be negative"},
               {"--sharpness nan", "is not a number"},
               {"--sharpness x", "is not a number"},
               {"--sharpness 2 --sharp none", "exclude each other"},
               {"--border round", "expected surface, curve, corners or fixed"}};
  for (const auto& w : wrong) expect_refusal(cube, w.options, 2, w.what);
  expect_refusal(cube, "--sharp file", 1, "the file has no normals");
}

TEST_F(Pn_subdivide_creases, SelectionsThatDoNotFitAreRefused)
{
  const std::string cube = PN_DATA_DIR "/cube.off";
  const struct
  {
    const char *selection, *what;
  } wrong[] = {{"8\n\n\n", "a.selection.txt: vertex 8 is out of range, the mesh has 8 vertices"},
               {"\n\n0 9\n", "vertex 9 is out of range"},
               {"\n\n0 0\n", "no edge between the vertices 0 and 0"},
               {"\n\n0 1 2\n", "line 3: edges are pairs of vertex numbers, and there are 3"},
               {"0 x\n", "line 1: 'x' stands where a vertex number is expected"},
               {"\n1.5\n", "line 2: '1.5' stands where a face number is expected"},
               {"-1\n", "line 1: a vertex number is negative"},
               {"99999999999999999999\n", "stands where a vertex number is expected"},
               {"0\n\n0 1\n2 3\n", "line 4: a selection has three lines only"},
               {"", "the file is empty"}};
  for (const auto& w : wrong)
    expect_refusal(cube, "--sharp '" + folder.write("a.selection.txt", w.selection) + "'", 1,
                   w.what);
  expect_refusal(cube, "--sharp '" + folder.file("missing.selection.txt") + "'", 1,
                 "missing.selection.txt: cannot be opened");
  expect_refusal(cube, "--sharp '" + folder.file("") + "'", 1, "this is a directory");
}

} // namespace

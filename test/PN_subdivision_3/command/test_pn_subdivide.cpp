// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The command as its users meet it: run as a program, judged by its files, its messages and its
// exit code. Meshes are written and read here with the functions that test_pn_subdivide_io checks.

#include "Command_test.h"
#include "Part_files.h"

#include "io/mesh_io.h"

#include <cmath>

using namespace pn_subdivide;

namespace {

const char* const book =
  "OFF\n5 3 0\n0 0 0\n0 0 1\n1 0 0\n0 1 0\n-1 0 0\n3 0 1 2\n3 1 0 3\n3 0 1 4\n";
const char* const twisted = "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n3 0 1 2\n3 1 2 3\n";
const char* const bow_tie = "OFF\n5 2 0\n0 0 0\n1 0 0\n0 1 0\n-1 0 0\n0 -1 0\n3 0 1 2\n3 0 3 4\n";

class Pn_subdivide : public Command_test
{
protected:
  const std::string cube = folder.write("cube.off", cube_off);

  Mesh_data refined(const std::string& input, const std::string& options) const
  {
    EXPECT_EQ(done(surface(input, "refined.ply", options)).out, "");
    return read_mesh(folder.file("refined.ply"));
  }

  void expect_failure(const std::string& input, const std::string& options, int code,
                      const std::string& part, const std::string& extension = "ply") const
  {
    Command_test::expect_failure("surface '" + input + "'", extension, options, code, part);
  }
};

} // namespace

// --- results ---

TEST_F(Pn_subdivide, LinearCatmullClarkOfACubeAsComputedByHand)
{
  for (const char* options :
       {"--scheme catmull-clark --linear", "--normals none --scheme catmull-clark"}) {
    const Mesh_data mesh = refined(cube, options);
    ASSERT_EQ(mesh.points.size(), 26u);
    EXPECT_EQ(mesh.number_of_faces(), 24u);
    EXPECT_FALSE(mesh.has_normals());
    // old vertices come first
    EXPECT_LE(distance(mesh.points[0], triple(-5. / 9, -5. / 9, -5. / 9)), 1e-15);
    EXPECT_LE(distance(mesh.points[6], triple(5. / 9, 5. / 9, 5. / 9)), 1e-15);
    int edges = 0, faces = 0;
    for (std::size_t v = 8; v < 26; ++v) {
      const double d = length(mesh.points[v]);
      if (std::abs(d - 0.75 * std::sqrt(2.)) < 1e-15) ++edges;
      if (std::abs(d - 1) < 1e-15) ++faces;
    }
    EXPECT_EQ(edges, 12);
    EXPECT_EQ(faces, 6);
  }
}

// A cube has no separated vertices, its first round has.
TEST_F(Pn_subdivide, ModifiedSchemesAreModifiedWhereVerticesAreSeparated)
{
  const auto points = [&](const std::string& options) { return refined(cube, options).points; };
  EXPECT_EQ(points("--scheme modified-catmull-clark"), points("--scheme catmull-clark"));
  const auto half = points("--levels 2 --scheme modified-catmull-clark");
  EXPECT_NE(half, points("--levels 2 --scheme catmull-clark"));
  for (const std::string cap : {"0.5", "1/2"})
    EXPECT_EQ(half, points("--levels 2 --scheme modified-catmull-clark --cap " + cap));
  EXPECT_NE(half, points("--levels 2 --scheme modified-catmull-clark --cap 0.4"));
  const auto normals = points("--levels 2 --scheme catmull-clark --normal-scheme "
                              "modified-catmull-clark --cap 0.4");
  EXPECT_NE(normals, points("--levels 2 --scheme catmull-clark"));
  EXPECT_NE(normals, points("--levels 2 --scheme catmull-clark --normal-scheme "
                            "modified-catmull-clark"));
}

// The policy of the paper: a plain first round, and no rules for valence 3.
TEST_F(Pn_subdivide, TheFirstRoundOfModifiedSchemesIsAnOption)
{
  const std::string input = folder.write("seven.off", cone_of_quads(7).off());
  const auto points = [&](const std::string& file, const std::string& options) {
    return refined(file, options).points;
  };
  const std::string modified = " --scheme modified-catmull-clark ";
  EXPECT_NE(points(input, "--levels 1" + modified), points(input, "--scheme catmull-clark"));
  EXPECT_EQ(points(input, "--levels 1 --first-round 2" + modified),
            points(input, "--levels 1 --scheme catmull-clark"));
  EXPECT_NE(points(input, "--levels 2 --first-round 2" + modified),
            points(input, "--levels 2 --scheme catmull-clark"));
  EXPECT_EQ(points(input, "--levels 2 --first-round 1 --tuned-valences all" + modified),
            points(input, "--levels 2" + modified));
  EXPECT_EQ(points(cube, "--levels 3 --tuned-valences diverging" + modified),
            points(cube, "--levels 3 --scheme catmull-clark"));
  EXPECT_NE(points(cube, "--levels 3" + modified),
            points(cube, "--levels 3 --scheme catmull-clark"));
  // the limit counts the rounds
  EXPECT_NE(points(input, "--levels 1 --limit --first-round 2" + modified),
            points(input, "--levels 1 --limit" + modified));
  for (const char* wrong : {"--first-round 0", "--first-round -1", "--first-round x",
                            "--tuned-valences some", "--tuned-valences ''"})
    expect_failure(input, modified + wrong, 2, "--");
  expect_failure(input, "--scheme catmull-clark --first-round 2", 2, "belongs");
  expect_failure(input, "--scheme catmull-clark --tuned-valences all", 2, "belongs");
}

TEST_F(Pn_subdivide, NoRoundCopiesTheControlDataWithUnitNormals)
{
  const std::string input = folder.write("n.off", "NOFF\n4 1 0\n0.1 0 0 0 0 4\n1 0 0 0 0 0\n"
                                                  "0 1 0 3 0 4\n9 9 9 0 -2 0\n3 0 1 2\n");
  // far from those of the face: otherwise they are set aside
  const Mesh_data mesh = refined(input, "--scheme loop --levels 0 --normals file");
  ASSERT_EQ(mesh.points.size(), 4u);
  EXPECT_EQ(mesh.points[0], triple(0.1, 0, 0));
  EXPECT_EQ(mesh.points[3], triple(9, 9, 9));
  EXPECT_EQ(mesh.normals[0], triple(0, 0, 1));
  EXPECT_EQ(mesh.normals[1], triple(0, 0, 0)); // no control normal here
  EXPECT_NEAR(mesh.normals[2][0], 0.6, 2e-16);
  EXPECT_NEAR(mesh.normals[2][2], 0.8, 2e-16);
  EXPECT_EQ(mesh.normals[3], triple(0, -1, 0));
  EXPECT_EQ(mesh.number_of_faces(), 1u);
  const Mesh_data estimated = refined(input, "--scheme loop --levels 0 --normals estimate");
  for (int v = 0; v < 3; ++v) EXPECT_EQ(estimated.normals[v], triple(0, 0, 1));
  EXPECT_EQ(estimated.normals[3], triple(0, 0, 0));
}

TEST_F(Pn_subdivide, VerticesWithoutFacesAreKept)
{
  const Mesh_data mesh =
    refined(folder.write("i.off", "OFF\n4 1 0\n5 6 7\n0 0 0\n1 0 0\n0 1 0\n3 1 2 3\n"),
            "--scheme loop --levels 2");
  EXPECT_EQ(mesh.points.size(), 1u + 15u);
  EXPECT_EQ(mesh.points[0], triple(5, 6, 7));
}

TEST_F(Pn_subdivide, ThreadsDoNotChangeABit)
{
  const auto bytes = [&](const std::string& threads) {
    const std::string output = folder.file("t" + threads + ".ply");
    const Outcome outcome =
      surface(cube, output, "--scheme catmull-clark --levels 6 --threads " + threads);
    EXPECT_TRUE(outcome.code == 0 || outcome.err.find("without TBB") != std::string::npos);
    return outcome.code == 0 ? Temporary_folder::content(output) : std::string();
  };
  const std::string one = bytes("1");
  EXPECT_GT(one.size(), 1000000u);
  for (const char* threads : {"0", "2", "3"}) {
    const std::string several = bytes(threads);
    EXPECT_TRUE(several == one || several.empty()) << threads << " threads";
  }
}

TEST_F(Pn_subdivide, InputMayBeTheOutput)
{
  done(surface(cube, cube, "--scheme catmull-clark"));
  EXPECT_EQ(read_mesh(cube).points.size(), 26u);
  EXPECT_EQ(folder.number_of_files(), 1u);
}

TEST_F(Pn_subdivide, ProgressOnLongWorkOnlyAndNotWithQuiet)
{
  const std::string output = folder.file("c.ply");
  const std::string few = surface(cube, output, "--scheme catmull-clark --levels 3").err;
  EXPECT_EQ(few.rfind(output + ": 386 vertices, 384 faces, 3 rounds of catmull-clark, estimated "
                               "normals, ",
                      0),
            0u)
    << few;
  EXPECT_EQ(std::count(few.begin(), few.end(), '\n'), 1) << few;
  const std::string triangles = folder.write("octahedron.off", octahedron_off);
  const Outcome outcome = done(surface(triangles, output, "--levels 7 --curvature mean"));
  for (const char* step :
       {"round 7 of 7: 131072 faces", "measuring the curvature at 65538 vertices", "writing "})
    expect_part(outcome.err, step);
  const Outcome again = surface(output, "again.ply", "--levels 0 --normals file --ascii");
  expect_part(again.err, "read " + output + ": 65538 vertices, 131072 faces");
  expect_part(again.err, "normals of the file");
  const Outcome large = surface("again.ply", output, "--levels 0");
  EXPECT_EQ(large.err.rfind("reading " + folder.file("again.ply") + " (", 0), 0u) << large.err;
  EXPECT_EQ(surface(triangles, output, "--levels 7 --quiet").err, "");
}

// --- repair ---

TEST_F(Pn_subdivide, SoupsThatAreNoManifoldAreRefusedOrRepaired)
{
  const struct
  {
    const char *content, *error, *report;
    std::size_t points;
  } cases[] = {
    {book, "1 edge has more than two faces (first: 0-1)", "0 faces reversed, 4 vertices added", 9},
    {twisted, "1 edge has two faces of opposite orientation (first: 1-2)", "1 face reversed, 0", 4},
    {bow_tie, "1 vertex joins fans of faces that share no edge (first: 0)", "1 vertex added", 6}};
  for (const auto& c : cases) {
    const std::string input = folder.write("soup.off", c.content);
    expect_failure(input, "--scheme loop --no-mend", 1, c.error);
    expect_failure(input, "--scheme loop --strict", 1, "--repair");
    const Outcome outcome = done(surface(input, "o.ply", "--scheme loop --levels 0 --repair"));
    expect_part(outcome.err, c.report);
    const Mesh_data mesh = read_mesh(folder.file("o.ply"));
    EXPECT_EQ(mesh.points.size(), c.points);
    done(surface(input, "o.ply", "--scheme loop --levels 2 --repair"));
    std::filesystem::remove(folder.file("o.ply"));
  }
  const Outcome sound =
    done(surface(cube, folder.file("o.ply"), "--scheme catmull-clark --repair"));
  expect_no_part(sound.err, "repaired");
}

TEST_F(Pn_subdivide, DegenerateAndDuplicateFacesAreRemoved)
{
  // a square of two triangles; one of them again, and once more from the other side; a face that goes
  // to and fro, and a quad with a repeated vertex that closes the square's neighbor
  const std::string input = folder.write(
    "d.off", "OFF\n5 6 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0 0\n3 0 1 2\n3 0 2 3\n3 1 2 0\n3 3 2 0\n"
             "4 0 1 0 1\n4 1 4 4 2\n");
  expect_failure(input, "--scheme loop", 1, "face 4 visits vertex 0 twice; --repair");
  const std::string output = folder.file("o.ply");
  const Outcome outcome = done(surface(input, output, "--quiet --levels 0 --repair"));
  EXPECT_EQ(outcome.err,
            "warning: " + input +
              ": repaired: 1 degenerate face removed, 1 face split at vertices visited "
              "twice, 2 duplicate faces removed, 0 faces reversed, 0 vertices added as "
              "copies\n");
  const Mesh_data mesh = read_mesh(output);
  ASSERT_EQ(mesh.number_of_faces(), 3u);
  for (std::size_t f = 0; f < 3; ++f) EXPECT_EQ(mesh.face(f).size(), 3);
  EXPECT_EQ(mesh.points.size(), 5u);
}

TEST_F(Pn_subdivide, PointsAreMergedWhereWanted)
{
  // two triangles side by side with vertices of their own
  const std::string input = folder.write(
    "m.off", "OFF\n6 2 0\n0 0 0\n1 0 0\n0 1 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 3 4 5\n");
  EXPECT_EQ(refined(input, "--levels 1").points.size(), 12u);
  EXPECT_EQ(refined(input, "--levels 1 --merge-points").points.size(), 9u);
  expect_part(surface(input, "o.ply", "--merge-points").err, "2 vertices merged");
}

TEST_F(Pn_subdivide, FacesAreSplitForTriangleSchemes)
{
  expect_failure(cube, "--scheme loop", 1,
                 "face 0 has 4 vertices, and loop refines triangles only; --triangulate");
  const Mesh_data mesh = refined(cube, "--scheme loop --triangulate");
  EXPECT_EQ(mesh.number_of_faces(), 48u);
  EXPECT_EQ(mesh.points.size(), 26u);
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) EXPECT_EQ(mesh.face(f).size(), 3);
}

TEST_F(Pn_subdivide, WithoutASchemeTheFacesDecide)
{
  const std::string triangles = folder.write("o.off", octahedron_off);
  EXPECT_EQ(refined(cube, "").points, refined(cube, "--scheme catmull-clark").points);
  EXPECT_EQ(refined(triangles, "").points, refined(triangles, "--scheme loop").points);
  EXPECT_EQ(refined(cube, "--triangulate").points,
            refined(cube, "--triangulate --scheme loop").points);
  expect_part(surface(cube, "o.ply", "").err, "1 round of catmull-clark");
  expect_failure(cube, "--normal-scheme butterfly", 2, "does not go with --scheme catmull-clark");
  expect_failure(cube, "--cap 1/2", 2, "--cap belongs");
}

// --- warnings ---

TEST_F(Pn_subdivide, WhatIsNotCarriedIsSaidOnceTheOutputIsComplete)
{
  const std::string input = folder.write(
    "t.obj", "mtllib a.mtl\no thing\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\n"
             "vn 1 0 0\nusemtl red\nf 1/1/1 2/1/1 3/1/1\nf 1/1/2 3/1/2 2/1/2\nl 1 2\n");
  const Outcome outcome = surface(input, "o.ply", "--quiet --levels 0 --sharp none --normals file");
  EXPECT_EQ(outcome.err, "warning: " + input +
                           ": not carried over to the result: lines and points\nwarning: " + input +
                           ": 3 vertices have several normals; their normalized sum is taken\n");
  EXPECT_EQ(surface(input, "o.ply", "--quiet --levels 0 --sharp none --normals none").err,
            "warning: " + input + ": not carried over to the result: lines and points\n");
  expect_failure(input, "--quiet --scheme kobbelt", 1,
                 "quadrilaterals"); // one line, without warnings
}

// --- failures ---

// A normal that is not finite is none.
TEST_F(Pn_subdivide, BrokenNormalsAreNone)
{
  const std::string ply =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
    "property float z\nproperty float nx\nproperty float ny\nproperty float nz\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  const std::pair<std::string, std::string> files[] = {
    {"a.off", "NOFF\n3 1 0\n0 0 0 0 0 1\n1 0 0 0 nan 1\n0 1 0 0 inf 1\n3 0 1 2\n"},
    {"a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nvn nan 0 0\nvn 0 1e999 0\n"
              "f 1//1 2//2 3//3\n"},
    {"a.ply", ply + "0 0 0 0 0 1\n1 0 0 0 0 nan\n0 1 0 -inf 0 0\n3 0 1 2\n"}};
  for (const auto& [name, content] : files) {
    const std::string input = folder.write(name, content), output = folder.file("o.ply");
    const std::string place = name == "a.off" ? "line 4" : name == "a.obj" ? "line 5" : "vertex 1";
    EXPECT_EQ(surface(input, output, "--quiet --levels 0 --normals file").err,
              "warning: " + input + ": 2 normals are not finite (first: " + place +
                "), which means none there\n");
    const Mesh_data mesh = read_mesh(output);
    EXPECT_EQ(mesh.normals, (std::vector<Triple>{{0, 0, 1}, {0, 0, 0}, {0, 0, 0}}));
    for (const char* const options :
         {"--normals estimate", "--linear", "--normals none", "--normals sphere:0,0,5"})
      EXPECT_EQ(
        surface(input, output, "--quiet --strict --drop-attributes " + std::string(options)).err,
        "")
        << name << options;
  }
  // the others at a vertex count
  const std::string corners =
    folder.write("c.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvn 0 0 1\nvn nan 0 0\n"
                          "f 1//1 2//1 3//1\nf 2//2 4//2 3//2\n");
  const Mesh_data mesh = refined(corners, "--levels 0 --normals file --sharp none");
  EXPECT_EQ(mesh.normals[1], triple(0, 0, 1));
  EXPECT_EQ(mesh.normals[3], triple(0, 0, 0));
}

TEST_F(Pn_subdivide, BadMeshesFailWithOneLine)
{
  const std::string head = "OFF\n3 1 0\n0 0 0\n1 0 0\n";
  const struct
  {
    const char* name;
    std::string content, part;
  } cases[] = {
    {"empty.off", "", "empty"},
    {"no_mesh.off", "Dear Sir or Madam,\n", "not an OFF file"},
    {"no_mesh.ply", "Dear Sir or Madam,\n", "not a PLY file"},
    {"no_mesh.obj", "Dear Sir or Madam,\n", "not an OBJ mesh"},
    {"no_mesh.stl", "Dear Sir or Madam,\n", "not an STL file"},
    {"truncated.off", head, "truncated"},
    {"index.off", head + "0 1 0\n3 0 1 3\n", "out of range"},
    {"degenerate.off", head + "0 1 0\n3 0 1 1\n", "visits vertex 1 twice"},
    {"nan.off", head + "0 nan 0\n3 0 1 2\n", "vertex 2 has a coordinate"},
    {"inf.off", head + "0 1e999 0\n3 0 1 2\n", "vertex 2 has a coordinate"},
    {"short_normal.off", "NOFF\n3 1 0\n0 0 0 0 0 1\n1 0 0 0 1\n0 1 0 0 0 1\n3 0 1 2\n", "line 4"},
    {"faceless.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n", "no face"}};
  for (const auto& c : cases) {
    const std::string input = folder.write(c.name, c.content);
    expect_failure(input, "--scheme loop", 1, c.part);
    expect_failure(input, "--scheme loop", 1, input);
    expect_failure(input, "--scheme loop --levels 0 --normals none", 1, c.part);
  }
  expect_failure(folder.file("missing.off"), "--scheme loop", 1, "No such file");
  expect_failure(cube, "--scheme loop", 1, "face");
  expect_failure(cube, "--scheme catmull-clark --normals file", 1, "no vertex normals");
  expect_failure(cube, "--scheme catmull-clark --levels 20", 1, "round");
}

TEST_F(Pn_subdivide, WrongCommandLinesFailWithOneLine)
{
  const std::string scheme = "--scheme catmull-clark ";
  expect_failure(cube, "--scheme ''", 2, "--scheme");
  expect_failure(cube, "--scheme bezier", 2, "bezier");
  expect_failure(cube, scheme + "--levels -1", 2, "--levels");
  expect_failure(cube, scheme + "--levels two", 2, "--levels");
  for (const char* levels : {"''", "0x2", "+1", "' 1'", "1e1", "4294967296"})
    expect_failure(cube, scheme + "--levels " + levels, 2, "--levels");
  expect_failure(cube, scheme + "--threads ''", 2, "--threads");
  expect_failure(cube, scheme + "--colour red", 2, "--colour");
  expect_failure(cube, scheme + "--linear --normals none", 2, "exclude each other");
  for (const char* normals : {"guess", "sphere", "sphere:1,2", "sphere:1,2,x", "sphere:1,2,nan",
                              "cylinder:0,0,0", "cylinder:0,0,0,0,0,0", "file:1"})
    expect_failure(cube, scheme + "--normals " + normals, 2, "--normals");
  expect_failure(cube, scheme, 2, "must end in one of", "xyz");
  expect_failure(folder.write("cube.xyz", cube_off), scheme, 2, "must end in one of");
  expect_one_line(run(""), 2, "INPUT and OUTPUT are missing");
  expect_one_line(run("volume a b"), 2, "'b' is one argument too many");
  expect_one_line(run("surface"), 2, "required");
}

TEST_F(Pn_subdivide, NumbersWithZerosInFrontAreDecimal)
{
  const std::string output = folder.file("o.ply");
  done(surface(cube, output, "--scheme doo-sabin --linear --levels 002 --threads 08"));
  EXPECT_EQ(read_mesh(output).points.size(), 96u);
  done(surface(cube, output, "--scheme doo-sabin --linear --levels 00"));
  EXPECT_EQ(read_mesh(output).points.size(), 8u);
}

TEST_F(Pn_subdivide, SchemesThatDoNotGoTogether)
{
  expect_failure(cube, "--scheme catmull-clark --normal-scheme loop", 2, "split");
  expect_failure(cube, "--scheme catmull-clark --normal-scheme spline", 2, "no such scheme");
  expect_failure(cube, "--scheme catmull-clark --normal-scheme kobbelt --linear", 2, "exclude");
  expect_failure(cube, "--scheme catmull-clark --normal-scheme kobbelt --normals none", 2,
                 "exclude");
  expect_failure(cube, "--scheme catmull-clark --tension 1/16", 2, "kobbelt");
  for (const char* tension : {"x", "1/", "1/0", "1/16x", "0.5", "-1"})
    expect_failure(cube, std::string("--scheme kobbelt --tension ") + tension, 2, "--tension");
  expect_failure(cube, "--scheme catmull-clark --cap 1/2", 2, "modified-catmull-clark");
  expect_failure(cube, "--scheme kobbelt --cap 1/2 --tension 0", 2, "--cap belongs");
  for (const char* cap : {"x", "1/", "1/0", "1/2x", "0", "-0.5", "1.01", "3/2"})
    expect_failure(cube, std::string("--scheme modified-catmull-clark --cap ") + cap, 2, "--cap");
  expect_failure(cube, "--scheme modified-loop --normal-scheme modified-catmull-clark", 2, "split");
  expect_failure(cube, "--scheme modified-loop", 1, "triangle");
  expect_failure(cube, "--scheme sqrt3", 1, "triangles");
  expect_failure(cube, "--scheme butterfly", 1, "triangles");
}

TEST_F(Pn_subdivide, OutputThatCannotBeWritten)
{
  const std::string options = "--quiet --scheme catmull-clark --levels ";
  expect_one_line(surface(cube, folder.file("no/such/folder/o.ply"), options + "1"), 1, "folder");
  std::filesystem::create_directory(folder.file("folder.ply"));
  expect_one_line(surface(cube, "folder.ply", options + "1"), 1, "directory");
  if (std::filesystem::exists("/dev/full")) {
    std::filesystem::create_symlink("/dev/full", folder.file("full.ply"));
    expect_one_line(surface(cube, "full.ply", options + "5"), 1, "space");
  }
#ifdef __unix__
  const std::string output = folder.write("o.ply", "untouched");
  const std::size_t files = folder.number_of_files();
  const std::string arguments = "surface " + words(cube, output) + options + "6";
  expect_one_line(run(arguments, "ulimit -f 100; "), 1, "writing failed");
  EXPECT_EQ(Temporary_folder::content(output), "untouched");
  EXPECT_EQ(folder.number_of_files(), files);
#endif
}

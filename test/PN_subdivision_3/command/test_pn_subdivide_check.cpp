// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// --check, and the edges that the closing line names: what is printed is compared with what is computed here from
// the files that the command writes, with --linear and without.

#include "Refined_files.h"

#include <cmath>
#include <cstdio>
#include <utility>

using namespace pn_subdivide;

namespace {

// of the edges 2a, 2b, 2c
std::string box(double a, double b, double c)
{
  return box_of_squares(1, {-a, -b, -c}, {2 * a, 2 * b, 2 * c}).off();
}

// a plane of n x n squares, with normals of any direction or without
enum class Normals { none, of_any_direction };
std::string plane(std::size_t n, Normals normals)
{
  const Part squares = grid(n, n);
  std::mt19937 random(5);
  const auto number = [&] { return double(random() % 2001) - 1000; };
  std::vector<Triple> of_vertices;
  while (normals == Normals::of_any_direction && of_vertices.size() < squares.points.size()) {
    const double x = number(), y = number(), z = number();
    of_vertices.push_back({x, y, z});
  }
  return squares.obj(of_vertices);
}

// of the pyramids over the means of the faces
double volume_over_means(const Mesh_data& mesh)
{
  double result = 0;
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
    Triple mean{};
    for (const auto v : mesh.face(f))
      mean = sum(mean, mesh.points[v], 1. / double(mesh.face(f).size()));
    result += dot(mean, area_vector(mesh, f)) / 3;
  }
  return result;
}

// edges of two faces whose area vectors are at an angle with a smaller cosine
std::size_t edges_beyond(double cosine, const Mesh_data& mesh)
{
  std::map<std::pair<Mesh_data::Index, Mesh_data::Index>, Triple> normals;
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
    Mesh_data::Index last = mesh.face(f).begin()[mesh.face(f).size() - 1];
    for (const Mesh_data::Index v : mesh.face(f)) {
      normals[{last, v}] = unit(area_vector(mesh, f));
      last = v;
    }
  }
  std::size_t number = 0;
  for (const auto& [ends, n] : normals) {
    const auto other = normals.find({ends.second, ends.first});
    if (ends.first < ends.second && other != normals.end())
      number += dot(n, other->second) < cosine - 1e-9;
  }
  return number;
}

class Pn_subdivide_check : public Command_test
{
protected:
  const std::string beam = folder.write("beam.off", box(10, 1, 1)),
                    cube = folder.write("cube.off", box(1, 1, 1));

  // What is printed; the result is the same as without.
  std::string check(const std::string& input, const std::string& options,
                    const std::string& name = "o.obj") const
  {
    const std::string output = folder.file(name), plain = folder.file("plain." + name);
    done(run(words(input, plain) + options));
    const Outcome outcome = done(run(words(input, output) + options + " --check"));
    EXPECT_EQ(content(output), content(plain));
    return outcome.out;
  }

  std::string closing_line(const std::string& input, const std::string& options) const
  {
    const Outcome outcome = done(run(words(input, "closing.ply") + options));
    expect_no_part(outcome.err, "warning: ");
    EXPECT_EQ(outcome.out, "");
    return outcome.err;
  }
};

// "a of x (linear b)" as the command says it
std::string ratio_text(double volume, double linear)
{
  char text[100];
  std::snprintf(text, sizeof text, "check: volume %.3f of the control mesh (linear %.3f)\n", volume,
                linear);
  return text;
}

} // namespace

// --- what is measured ---

TEST_F(Pn_subdivide_check, VolumesAndFoldsAreThoseOfTheFiles)
{
  const std::string wild = folder.write("wild.obj", plane(6, Normals::of_any_direction));
  for (const auto& [input, options] :
       std::vector<std::pair<std::string, std::string>>{{beam, "--levels 3 --normals angle"},
                                                        {beam, "--levels 2 --limit"},
                                                        {beam, "--levels 2 --scheme doo-sabin"},
                                                        {beam, "--levels 2 --triangulate"},
                                                        {beam, "--levels 3 --sharp angle:40"},
                                                        {wild, "--levels 3 --normals file"}}) {
    SCOPED_TRACE(options);
    const std::string text = check(input, options), linear_file = folder.file("l.obj");
    const std::size_t normals = options.find(" --normals");
    done(run(words(input, linear_file) + options.substr(0, normals) + " --linear"));
    const Mesh_data result = read_mesh(path("o.obj")), linear = read_mesh(linear_file);
    ASSERT_EQ(result.points.size(), linear.points.size());
    if (input == beam)
      expect_part(text, ratio_text(volume_over_means(result) / 80, volume_over_means(linear) / 80));
    else
      expect_no_part(text, "volume");
    const double cosine = -std::sqrt(3.) / 2;
    std::ostringstream folds;
    folds << "check: " << edges_beyond(0, result)
          << (edges_beyond(0, result) == 1 ? " edge folds" : " edges fold")
          << " by more than 90 degrees (linear " << edges_beyond(0, linear) << "), "
          << edges_beyond(cosine, result) << " by more than 150 (linear "
          << edges_beyond(cosine, linear) << ")\n";
    expect_part(text, folds.str());
    expect_part(text, "check: farthest from the control mesh ");
  }
}

// --- verdicts and advice ---

TEST_F(Pn_subdivide_check, ABeamSwells)
{
  expect_part(check(beam, "--levels 3 --normals angle"),
              "check: SWOLLEN (linear LOST). It looks like a part: try --part\n");
  // nobody can tag these
  for (const char* options : {"--sharp none", "--scheme doo-sabin"}) {
    const std::string text = check(beam, std::string("--levels 3 --normals angle ") + options);
    expect_part(text, "check: SWOLLEN");
    expect_part(text, ". Try --roundness 0.5\n");
  }
  expect_part(check(beam, "--levels 3 --normals angle --sharp none --roundness 0.5"),
              "check: SWOLLEN (linear LOST). Try --linear\n");
  expect_part(check(beam, "--levels 3 --normals sphere:0,0,0 --sharp none"),
              "check: SWOLLEN (linear LOST). Try --roundness auto --normals estimate\n");
}

TEST_F(Pn_subdivide_check, NormalsOfAnyDirectionFold)
{
  const std::string wild = folder.write("wild.obj", plane(12, Normals::of_any_direction));
  const std::string text = check(wild, "--levels 3 --normals file");
  expect_part(text, "check: FOLDED (linear not folded). Try --roundness auto --normals estimate\n");
  expect_no_part(text, "SWOLLEN");
}

TEST_F(Pn_subdivide_check, TheShapeOfTheControlMeshCounts)
{
  const std::string flat = folder.write("flat.obj", plane(4, Normals::none));
  // a ball of 2.7 times the volume, and what is less than a half
  expect_part(check(cube, "--levels 3 --normals sphere:0,0,0"), "check: SWOLLEN (linear LOST). ");
  const std::string none = check(beam, "--levels 3 --normals none"); // the linear one itself
  expect_part(none, "check: LOST (linear LOST). ");
  expect_part(check(beam, "--levels 3 --sharp angle:40"), "check: kept (linear kept)\n");
  expect_part(check(flat, "--levels 3"), "check: not folded (linear not folded)\n");
  expect_part(check(cube, "--levels 2 --sharp none --roundness 0"),
              ". Try --interpolate slide, whose surface passes through the points\n");
}

TEST_F(Pn_subdivide_check, SharpEdgesAreNoFolds)
{
  const std::string prism = // three edges of it turn by some 120 degrees
    folder.write("prism.off", pn_subdivide::prism({{0, 0, 0}, {1, 0, 0}, {0.5, 0.8, 0}}, 1).off());
  expect_part(check(prism, "--levels 2 --sharp angle:40"),
              "check: 0 edges fold by more than 90 degrees (linear 0)");
  expect_no_part(check(prism, "--sharp angle:40 --chord 0.1"), "check: 0 edges fold");
}

// Each vertex of a Catmull-Clark cube of width 2 is inside of it.
TEST_F(Pn_subdivide_check, DistancesAreFromTheControlMesh)
{
  for (const std::string options : {"--levels 2 --normals none", "--chord 0.01 --normals none"}) {
    const std::string text = check(cube, options);
    double largest = 0;
    for (const Triple& p : read_mesh(path("o.obj")).points) {
      const double outmost = (std::max)({std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
      largest = (std::max)(largest, 1 - outmost);
    }
    char part[100];
    std::snprintf(part, sizeof part,
                  "farthest from the control mesh %.3g (linear %.3g), at vertex ", largest,
                  largest);
    expect_part(text, part);
  }
}

// Of many meshes, by scripts/never_worse.py: options behind -- replace its own, and what cannot be measured is no success.
TEST_F(Pn_subdivide_check, ManyAreCompared)
{
  if (std::system("python3 -c ''") != 0) GTEST_SKIP() << "left out: no python3";
  folder.write("block.off", box(2, 1.5, 1));
  folder.write("small.off", box(0.5, 0.5, 0.5));
  folder.write("large.off", box(2, 2, 2));
  folder.write("broken.off", "OFF\n1 2\n");
  const auto expect = [&](int code, const std::string& arguments, const std::string& part) {
    const std::string out = work.file("out");
    const int status = std::system(("cd '" + folder.file("") +
                                    "' && python3 -B '" PN_DATA_DIR
                                    "/../../scripts/never_worse.py' '" PN_SUBDIVIDE_COMMAND "' " +
                                    arguments + " >'" + out + "' 2>&1")
                                     .c_str());
    const std::string text = Temporary_folder::content(out);
    EXPECT_EQ(status, code << 8) << arguments << text;
    expect_part(text, part);
  };
  expect(0, "block.off beam.off", "2 meshes, 2 closed: volume beyond linear by 0.05 on 0,");
  expect(1, "beam.off -- --normals angle",
         "1 meshes, 1 closed: volume beyond linear by 0.05 on 1,");
  expect(0, "beam.off -- --normals angle --sharp angle:40", "by 0.05 on 0,");
  expect(2, "", "no mesh");
  expect(2, "-- --sharp angle:40", "no mesh");
  expect(2, "block.off broken.off", "refused: pn_subdivide: ");
  expect(2, "block.off broken.off", "1 meshes, 1 closed");
  expect(2, "block.off -- --no-such-option", "refused: ");
  // which the ball round the cube is closer to than the linear result, or farther from
  expect(0, "cube.off --reference large.off", "cube.off: mean distance ");
  expect(1, "cube.off --reference small.off", "cube.off: mean distance ");
  expect(2, "beam.off block.off --reference beam.off", "--reference is for one mesh");
}

// --- where it is said ---

TEST_F(Pn_subdivide_check, LinesAreOnStandardOutput)
{
  const std::string text = check(beam, "--levels 2 --normals angle");
  EXPECT_EQ(text.rfind("check: volume ", 0), 0u) << text;
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 4);
  const Outcome quiet =
    done(run(words(beam, "q.ply") + "--levels 2 --normals angle --check --quiet --strict"));
  EXPECT_EQ(quiet.out, text);
  EXPECT_EQ(quiet.err, "");
  const Outcome streams =
    done(run("'" + beam + "' - --format obj --levels 2 --normals angle --check --quiet"));
  EXPECT_EQ(streams.err, text);
  expect_no_part(streams.out, "check");
  // triangles of .stl are made of the faces that were compared
  EXPECT_EQ(check(beam, "--levels 2 --normals angle", "o.stl"), text);
}

TEST_F(Pn_subdivide_check, TheReportHasTheNumbers)
{
  const std::string wild = folder.write("wild.obj", plane(12, Normals::of_any_direction)),
                    file = work.file("r.json");
  const auto report = [&](const std::string& input, const std::string& options) {
    done(run(words(input, "o.obj") + options + " --report '" + file + "'"));
    return nlohmann::json::parse(Temporary_folder::content(file)).at("check");
  };
  nlohmann::json json = report(beam, "--levels 3 --normals angle --check");
  const Mesh_data result = read_mesh(path("o.obj"));
  EXPECT_NEAR(json.at("volume"), volume_over_means(result) / 80, 1e-9);
  EXPECT_LT(json.at("linear_volume"), 0.5);
  EXPECT_EQ(json.at("edges_that_turn_by_40_degrees"), 12);
  EXPECT_EQ(json.at("swollen"), true);
  EXPECT_EQ(json.at("folded"), false);
  EXPECT_EQ(json.at("edges_folded_by_90_degrees"), edges_beyond(0, result));
  EXPECT_LT(json.at("farthest_vertex"), result.points.size());
  EXPECT_GT(json.at("largest_distance"), 0.1);
  EXPECT_EQ(json.at("lost"), false);
  EXPECT_EQ(json.at("linear_lost"), true);
  expect_part(json.at("advice"), "--part");
  json = report(wild, "--levels 3 --normals file --check");
  EXPECT_FALSE(json.contains("volume"));
  EXPECT_EQ(json.at("folded"), true);
  EXPECT_FALSE(report(beam, "--levels 2 --sharp angle:40 --check").contains("advice"));
  EXPECT_EQ(report(beam, "--levels 2"), nlohmann::json::object());
}

TEST_F(Pn_subdivide_check, WrongCommandLines)
{
  const std::string polygon = folder.write("p.txt", "0 0\n4 0\n4 3\n0 3\n");
  const std::string files = words(beam, "o.ply");
  for (const auto& [options, part] :
       std::vector<std::pair<std::string, std::string>>{{"--linear", "--check and --linear"},
                                                        {"--levels 0", "--check and --levels 0"},
                                                        {"--pieces 2", "--check"},
                                                        {"--memory 1G", "--check"}})
    expect_one_line(run(files + "--check " + options), 2, part);
  EXPECT_FALSE(std::filesystem::exists(folder.file("o.ply")));
  expect_one_line(run("curve " + words(polygon, "o.txt") + "--check"), 2, "no option --check");
}

// --- the closing line ---

TEST_F(Pn_subdivide_check, TheClosingLineNamesEdgesThatTurn)
{
  const std::string flat = folder.write("flat.obj", plane(4, Normals::none)),
                    roof = folder.write("roof.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
                                                    "3 0 1 2\n3 1 0 3\n");
  const std::string named = ", 12 edges turn by more than 40 degrees: --part, ";
  expect_part(closing_line(cube, "--levels 2"), named);
  expect_part(closing_line(cube, "--levels 2 --sharp auto --strict"), named);
  // nothing is recognized in pieces, and a half and a fifth of the edges are too many for an angle
  expect_no_part(closing_line(cube, "--levels 2 --pieces 2"), "40 degrees");
  expect_no_part(closing_line(roof, ""), "40 degrees");
  for (const char* options : {"--linear", "--normals none", "--levels 0", "--sharp none",
                              "--sharp angle:40", "--sharp angle:95 --quiet", "--scheme doo-sabin",
                              "--normals sphere:0,0,0", "--interpolate points", "--quiet"}) {
    const Outcome outcome = done(run(words(cube, "closing.ply") + options));
    expect_no_part(outcome.err, "40 degrees");
  }
  expect_no_part(closing_line(flat, "--levels 2"), "turn");
}

// What the file tags is not named again.
TEST_F(Pn_subdivide_check, TaggedEdgesAreNotCounted)
{
  const std::string input = folder.write(
    "tagged.obj", uneven_box().obj() + "t crease 2/1/0 0 1 3.0\nt crease 2/1/0 1 2 3.0\n");
  const std::string line = run(words(input, "o.obj") + "--levels 2").err;
  expect_part(line, ", 2 sharp edges");
  expect_part(line, ", 10 edges turn by more than 40 degrees: --part, ");
}

// A surface far outside of its control mesh is not warned of any more: --check tells.
TEST_F(Pn_subdivide_check, NoWarningOfTheBox)
{
  closing_line(beam, "--levels 5 --normals sphere:0,0,0 --strict");
}

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// How the command talks: its help and manual page, near misses, what --strict and --report say.

#include "Command_test.h"

#include <CGAL/PN_subdivision_3/schemes/shipped_schemes.h>
#include <CGAL/PN_subdivision_3/version.h>

#include <nlohmann/json.hpp>

#include <set>

namespace {

// the second triangle is turned over, and a face has a color that .stl cannot hold
const char* const twisted =
  "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n3 0 1 2 255 0 0\n3 1 2 3 0 0 255\n";
const char* const polygon = "0 0\n4 0\n4 3\n0 3\n";

class Pn_subdivide_habits : public Command_test
{
protected:
  std::string content_after(const std::string& arguments, const std::string& output) const
  {
    done(run(arguments));
    return Temporary_folder::content(output);
  }

  nlohmann::json report(const std::string& arguments, int code = 0) const
  {
    const std::string file = work.file("report.json");
    std::filesystem::remove(file);
    const Outcome outcome = run(arguments + " --report '" + file + "'");
    EXPECT_EQ(outcome.code, code) << arguments << "\n" << outcome.err;
    return nlohmann::json::parse(Temporary_folder::content(file));
  }

  std::string help() const { return run("surface --help").out + run("curve --help").out; }
};

std::set<std::string> options_in(const std::string& text)
{
  std::set<std::string> options;
  for (std::size_t i = text.find("--"); i != std::string::npos; i = text.find("--", i + 2))
    options.insert(text.substr(i, text.find_first_not_of("abcdefghijklmnopqrstuvwxyz-", i) - i));
  return options;
}

std::string between(const std::string& text, const std::string& begin, const std::string& end)
{
  const std::size_t i = text.find(begin);
  EXPECT_NE(i, std::string::npos) << begin;
  return i == std::string::npos ? "" : text.substr(i, text.find(end, i + 1) - i);
}

} // namespace

// --- the command line ---

TEST_F(Pn_subdivide_habits, SurfaceMayBeLeftOut)
{
  const std::string input = folder.write("cube.off", cube_off), output = folder.file("o.obj");
  const std::string files = words(input, output);
  const std::string expected = content_after("surface " + files + " --levels 2", output);
  EXPECT_EQ(content_after(files + " --levels 2", output), expected);
  EXPECT_EQ(content_after("--levels 2 " + files, output), expected);
  EXPECT_EQ(content_after("--levels=2 --quiet " + files, output), expected);
  done(run("- - --format off <'" + input + "'"));
}

TEST_F(Pn_subdivide_habits, FilesWithTheNameOfACommandNeedAPath)
{
  for (const char* name : {"surface", "curve"}) {
    const std::string input = folder.write(name, cube_off);
    const std::string before = "cd '" + folder.file("") + "'; ";
    const std::string message = "must end in one of"; // and not: an option or a file is missing
    expect_one_line(run(std::string("./") + name + " o.off", before), 2, message);
    expect_one_line(run(std::string(name) + " o.off", before), 2, "OUTPUT is required");
  }
}

TEST_F(Pn_subdivide_habits, FilesThatBeginWithAHyphenNeedAPath)
{
  const std::string before = "cd '" + folder.file("") + "'; ";
  for (const std::string name : {"-x.off", "-h.off", "--help.off"}) {
    folder.write(name, cube_off);
    expect_one_line(run(name + " o.ply", before), 2,
                    "'" + name + "' looks like an option: the file is ./" + name);
    expect_one_line(run("./" + name + " " + name, before), 2, "./" + name);
    done(run("./" + name + " ./-o.ply", before));
  }
  folder.write("-p.txt", polygon);
  expect_one_line(run("curve -p.txt o.txt", before), 2, "./-p.txt");
}

TEST_F(Pn_subdivide_habits, NearMissesAreNamed)
{
  const std::string input = folder.write("cube.off", cube_off),
                    polygon_file = folder.write("p.txt", polygon);
  const auto expect_hint = [&](const std::string& arguments, const std::string& hint) {
    SCOPED_TRACE(arguments);
    expect_one_line(run(arguments), 2, hint);
    EXPECT_FALSE(std::filesystem::exists(folder.file("o.ply")));
  };
  const std::string files = words(input, "o.ply");
  const std::string curve = "curve " + words(polygon_file, "o.txt");
  for (const auto& [miss, meant] :
       std::vector<std::pair<std::string, std::string>>{{"--level 3", "--levels"},
                                                        {"--level=3", "--levels"},
                                                        {"--treads 2", "--threads"},
                                                        {"--triangle", "--triangulate"},
                                                        {"--normal none", "--normals"},
                                                        {"--curvatur mean", "--curvature"}})
    expect_hint(files + miss, "did you mean " + meant + "?");
  expect_hint(curve + "--close", "did you mean --closed?");
  expect_hint(files + "--sharp 40", "did you mean angle:40?");
  expect_hint(files + "--sharp autp", "did you mean auto?");
  expect_hint(files + "--scheme catmul-clark", "did you mean catmull-clark?");
  expect_hint(files + "--scheme kobelt", "did you mean kobbelt?");
  expect_hint(files + "--repa", "did you mean --repair?");
  for (const char* far_off : {"--colour red", "--x"}) {
    const Outcome outcome = run(files + far_off);
    EXPECT_EQ(outcome.code, 2);
    expect_no_part(outcome.err, "did you mean");
  }
}

TEST_F(Pn_subdivide_habits, CurvesHaveADefaultScheme)
{
  const std::string input = folder.write("p.txt", polygon), output = folder.file("o.txt");
  const std::string arguments = "curve " + words(input, output) + "--closed --levels 3";
  EXPECT_EQ(content_after(arguments, output),
            content_after(arguments + " --scheme bspline:3", output));
}

TEST_F(Pn_subdivide_habits, DrawingsAreSvg)
{
  const std::string input = folder.write("p.txt", polygon);
  const std::string arguments = "curve " + words(input, "o.txt") + "--comb ";
  expect_one_line(run(arguments + "'" + folder.file("x.png") + "'"), 2, ".svg");
  EXPECT_FALSE(std::filesystem::exists(folder.file("o.txt")));
  done(run(arguments + "'" + folder.file("x.SVG") + "'"));
}

// --- help and manual page ---

TEST_F(Pn_subdivide_habits, TheVersionHasTheName)
{
  EXPECT_EQ(run("--version").out, "pn_subdivide " CGAL_PN_SUBDIVISION_3_VERSION "\n");
}

TEST_F(Pn_subdivide_habits, HelpFitsIntoAHundredColumns)
{
  for (const char* arguments : {"--help", "surface --help", "curve --help"}) {
    const Outcome outcome = done(run(arguments));
    EXPECT_EQ(outcome.err, "");
    expect_part(outcome.out, "Exit code");
    for (const std::string& line : lines(outcome.out)) EXPECT_LE(line.size(), 100u) << line;
  }
}

// Every option has its group, the common ones come first and the examples last.
TEST_F(Pn_subdivide_habits, HelpIsInGroups)
{
  for (const char* command : {"surface", "curve"}) {
    const std::string help = run(std::string(command) + " --help").out;
    expect_no_part(help, "Other options");
    const std::size_t groups = help.find("Common options:\n  --levels"),
                      examples = help.find("\nExamples:");
    EXPECT_NE(groups, std::string::npos) << help;
    EXPECT_LT(groups, help.find("Schemes:"));
    ASSERT_NE(examples, std::string::npos);
    for (const std::string& line : lines(help.substr(examples + 11)))
      EXPECT_TRUE(line.empty() || line.rfind("  pn_subdivide ", 0) == 0) << line;
  }
}

// What the top level shows are whole commands; their options exist.
TEST_F(Pn_subdivide_habits, TheTopLevelShowsWhatPeopleLookFor)
{
  const std::string top = run("--help").out;
  const std::set<std::string> known = options_in(help());
  for (const char* word : {"smooth", "edges", "linear", "curvature", "points", "curve"})
    EXPECT_NE(top.find(word), std::string::npos) << word;
  for (const std::string& option : options_in(top))
    EXPECT_TRUE(option == "--version" || known.count(option) == 1) << option;
}

// What the help of a command names, the manual page has in the sections for it, and nothing else.
TEST_F(Pn_subdivide_habits, TheManualPageHasTheOptionsOfTheHelp)
{
  std::string page = Temporary_folder::content(PN_SUBDIVIDE_MANUAL);
  page.erase(std::remove(page.begin(), page.end(), '\\'), page.end());
  const auto headings = [](const std::string& section) {
    std::string names; // the lines below .TP
    const std::vector<std::string> all = lines(section);
    for (std::size_t i = 1; i < all.size(); ++i)
      if (all[i - 1] == ".TP") names += all[i] + "\n";
    return options_in(names);
  };
  const std::set<std::string> both =
    headings(between(page, ".SH OPTIONS OF BOTH", ".SH OPTIONS FOR"));
  const std::pair<const char*, const char*> sections[] = {{"surface", ".SH OPTIONS FOR SURFACES"},
                                                          {"curve", ".SH OPTIONS FOR CURVES"}};
  for (const auto& [command, section] : sections) {
    std::set<std::string> documented = headings(between(page, section, ".SH"));
    documented.insert(both.begin(), both.end());
    std::string names; // at the beginning of the help's lines
    for (const std::string& line : lines(run(std::string(command) + " --help").out))
      if (line.rfind("  -", 0) == 0) names += line.substr(0, 26) + "\n";
    std::set<std::string> options = options_in(names);
    options.erase("--help");
    EXPECT_GT(options.size(), 12u);
    EXPECT_EQ(documented, options) << command;
  }
}

TEST_F(Pn_subdivide_habits, TheManualPageNamesEveryScheme)
{
  std::string page = Temporary_folder::content(PN_SUBDIVIDE_MANUAL);
  page.erase(std::remove(page.begin(), page.end(), '\\'), page.end());
  const std::string text = help();
  CGAL::PN_subdivision_3::for_each_shipped_scheme([&](const auto& scheme) {
    EXPECT_NE(page.find(scheme.name()), std::string::npos) << scheme.name();
    EXPECT_NE(text.find(scheme.name()), std::string::npos) << scheme.name();
  });
}

// --- --strict ---

TEST_F(Pn_subdivide_habits, StrictTurnsWarningsIntoAnExitCode)
{
  const std::string bad = folder.write("twisted.off", twisted),
                    good = folder.write("cube.off", cube_off);
  const std::string output = folder.file("o.off");
  const auto arguments = [&](const std::string& input) { return words(input, output); };
  const std::string expected = content_after(arguments(bad) + "--repair", output);
  std::filesystem::remove(output);
  for (const char* quiet : {"", " --quiet"}) {
    const Outcome outcome = run(arguments(bad) + "--repair --strict" + quiet);
    EXPECT_EQ(outcome.code, 4) << outcome.err;
    expect_part(outcome.err, "warning: ");
    expect_part(outcome.err, "pn_subdivide: --strict: 1 warning");
    EXPECT_EQ(Temporary_folder::content(output), expected);
  }
  done(run(arguments(good) + "--strict"));
  EXPECT_EQ(run(arguments(folder.file("missing.off")) + "--strict").code, 1);
}

// Coordinates of a map, as a file that this program could not read back.
TEST_F(Pn_subdivide_habits, SinglePrecisionOfStlIsWarnedOf)
{
  std::string map = cube_off;
  for (const auto& [x, moved] : {std::pair("\n-1 ", "\n4400000 "), {"\n1 ", "\n4400002 "}})
    for (std::size_t i = map.find(x); i != std::string::npos; i = map.find(x))
      map.replace(i, std::string(x).size(), moved);
  const std::string input = folder.write("map.off", map), output = folder.file("o.stl");
  const std::string arguments =
    words(input, output) + "--levels 5 --strict --normals none --triangulate ";
  EXPECT_EQ(run(arguments).code, 4);
  expect_part(run(arguments + "--quiet").err,
              output + ": its single precision moves points by up to 0.");
  done(run(arguments + "--ascii"));
  done(run(words(output, "p.ply") + "--strict"));
  EXPECT_EQ(
    run("'" + folder.write("c.off", cube_off) + "' '" + output + "' --levels 5 --strict").code, 0);
}

TEST_F(Pn_subdivide_habits, TheToleranceWinsOverStrict)
{
  const std::string input = folder.write("twisted.off", twisted), output = folder.file("o.off");
  const std::string arguments = words(input, output) + "--repair --strict --verify sphere:0,0,0,1 ";
  EXPECT_EQ(run(arguments + "--tolerance 1e-9").code, 3);
  EXPECT_EQ(run(arguments + "--tolerance 9").code, 4);
}

// --- --report ---

TEST_F(Pn_subdivide_habits, TheReportSaysWhatWasDone)
{
  const std::string input = folder.write("twisted.off", twisted), output = folder.file("o.stl");
  const nlohmann::json json = report(words(input, output) + "--repair --levels 2 --limit");
  EXPECT_EQ(json.at("input"), input);
  EXPECT_EQ(json.at("output"), output);
  EXPECT_EQ(json.at("vertices"), 25); // a square of two triangles, cut twice
  EXPECT_EQ(json.at("faces"), 32);
  EXPECT_EQ(json.at("rounds"), 2);
  EXPECT_EQ(json.at("repaired"), nlohmann::json({{"reversed_faces", 1}}));
  EXPECT_EQ(json.at("warnings").size(), 2u); // of the repair and of the colors
  EXPECT_EQ(json.at("dropped").size(), 1u);
  EXPECT_GT(json.at("limit").at("tolerance"), 0);
  EXPECT_LE(json.at("limit").at("error"), json.at("limit").at("tolerance"));
}

TEST_F(Pn_subdivide_habits, TheReportOfALinearSchemeAndOfACurve)
{
  const std::string input = folder.write("cube.off", cube_off),
                    curve = folder.write("p.txt", polygon);
  nlohmann::json json = report(words(input, "o.ply") + "--linear --levels 0");
  EXPECT_EQ(json.at("vertices"), 8);
  EXPECT_EQ(json.at("faces"), 6);
  for (const char* list : {"warnings", "dropped"})
    EXPECT_EQ(json.at(list), nlohmann::json::array());
  for (const char* object : {"repaired", "limit"})
    EXPECT_EQ(json.at(object), nlohmann::json::object());
  json = report("curve " + words(curve, "o.txt") + "--closed --levels 3 --limit");
  EXPECT_EQ(json.at("vertices"), 32);
  EXPECT_EQ(json.at("faces"), 0);
  EXPECT_GT(json.at("limit").at("tolerance"), 0);
}

TEST_F(Pn_subdivide_habits, TheReportOfPieces)
{
  const std::string input = folder.write("cube.off", cube_off);
  const nlohmann::json json = report(words(input, "o.ply") + "--pieces 3 --levels 3");
  EXPECT_EQ(json.at("vertices"), 386);
  EXPECT_EQ(json.at("faces"), 384);
}

TEST_F(Pn_subdivide_habits, TheReportIsThereWhereTheResultIs)
{
  const std::string input = folder.write("twisted.off", twisted), file = folder.file("r.json");
  const std::string output = folder.file("o.off");
  const std::string arguments = words(input, output) + "--report '" + file + "' ";
  EXPECT_EQ(run(arguments).code, 1); // not oriented
  EXPECT_FALSE(std::filesystem::exists(file));
  EXPECT_EQ(run(arguments + "--repair --strict").code, 4);
  EXPECT_TRUE(std::filesystem::exists(file));
  std::filesystem::remove(file);
  EXPECT_EQ(run(arguments + "--repair --verify sphere:0,0,0,1 --tolerance 1e-9").code, 3);
  EXPECT_TRUE(std::filesystem::exists(file));
}

TEST_F(Pn_subdivide_habits, TheReportNeedsAFileOfItsOwn)
{
  const std::string input = folder.write("cube.off", cube_off), output = folder.file("o.off");
  const std::string arguments = words(input, output) + "--report ";
  expect_one_line(run(arguments + "-"), 2, "--report");
  expect_one_line(run(arguments + "''"), 2, "--report");
  expect_one_line(run(arguments + "'" + input + "'"), 2, "file of its own");
  expect_one_line(run(arguments + "'" + folder.file("./o.off") + "'"), 2, "file of its own");
  expect_one_line(run(arguments + "'" + folder.file("none/r.json") + "'"), 1, "r.json");
  EXPECT_FALSE(std::filesystem::exists(output));
  EXPECT_EQ(Temporary_folder::content(input), cube_off);
}

TEST_F(Pn_subdivide_habits, TheReportIsJsonWhateverTheNames)
{
  const std::string input = folder.write("a\"b\\c\t\xff.off", cube_off); // quotes, a tab, no UTF-8
  const nlohmann::json json = report(words(input, "o.off"));
  EXPECT_EQ(json.at("vertices"), 26);
  expect_part(json.at("input").get<std::string>(), "a\"b\\c\t");
}

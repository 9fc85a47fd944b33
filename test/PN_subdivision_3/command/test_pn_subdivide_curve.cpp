// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// `pn_subdivide curve` as its users meet it: run as a program, judged by its files, its messages
// and its exit code.

#include "Command_test.h"

#include <cmath>

namespace {

void expect_rows(const Rows& rows, const Rows& expected, double bound)
{
  ASSERT_EQ(rows.size(), expected.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    ASSERT_EQ(rows[i].size(), expected[i].size()) << "line " << i + 1;
    for (std::size_t j = 0; j < rows[i].size(); ++j)
      EXPECT_NEAR(rows[i][j], expected[i][j], bound) << "line " << i + 1;
  }
}

const char* const square = "1 0\n1 1\n0 1\n0 0\n";
const char* const zigzag = "0 0\n4 8\n8 0\n12 8\n16 0\n20 8\n";
// unit normals that are exact in binary, so that they are taken as they are
const char* const with_normals = "0 0 0 1\n1 0.10000000000000001 0 1\n2 0.5 -1 0\n3 1 0 1\n"
                                 "4 2 0 1\n5 2.25 0 -1\n";

class Pn_subdivide_curve : public Command_test
{
protected:
  std::string refined(const std::string& polygon, const std::string& options) const
  {
    SCOPED_TRACE(options);
    const Outcome outcome =
      done(curve(folder.write("polygon.txt", polygon), "curve.txt", "--quiet " + options));
    EXPECT_EQ(outcome.out + outcome.err, "");
    return content("curve.txt");
  }

  void expect_failure(const std::string& polygon, const std::string& options, int code,
                      const std::string& part) const
  {
    SCOPED_TRACE(polygon);
    Command_test::expect_failure("curve '" + folder.write("polygon.txt", polygon) + "'", "txt",
                                 options, code, part);
  }

  void expect_bad_file(const std::string& polygon, const std::string& part) const
  {
    expect_failure(polygon, "--scheme 4-point", 1, part);
    expect_failure(polygon, "--scheme chaikin --closed --levels 0", 1, "polygon.txt");
  }
};

} // namespace

// --- results ---

TEST_F(Pn_subdivide_curve, ResultsAsComputedByHand)
{
  const char* const chaikin = "1 0.25\n1 0.75\n0.75 1\n0.25 1\n0 0.75\n0 0.25\n0.25 0\n0.75 0\n";
  const struct
  {
    const char *polygon, *options, *expected;
  } cases[] = {
    {square, "--linear --closed --scheme chaikin", chaikin},
    {square, "--linear --closed --scheme bspline:2", chaikin},
    {"0 0\n8 16\n16 0\n", "--linear --scheme bspline:3", "0 0\n4 8\n8 12\n12 8\n16 0\n"},
    {"0 0 1\n8 16 1\n16 0 1\n", "--linear --scheme bspline:3 --end none",
     "4 8 1\n8 12 1\n12 8 1\n"},
    // the point of an edge is (-1, 9, 9, -1)/16; at an end (7, 10, -1)/16
    {"0 0\n4 16\n8 0\n12 16\n", "--linear --scheme 4-point",
     "0 0\n2 10\n4 16\n6 8\n8 0\n10 6\n12 16\n"},
    // zero normals mean none
    {"1 0 0 0\n1 1 0 0\n0 1 0 0\n0 0 0 0\n", "--closed --scheme chaikin",
     "1 0.25 0 0\n1 0.75 0 0\n0.75 1 0 0\n0.25 1 0 0\n0 0.75 0 0\n0 0.25 0 0\n0.25 0 0 0\n"
     "0.75 0 0 0\n"},
    // no round copies and normalizes
    {"0.10000000000000001 2 0 5\n3 4 -8 0\n", "--levels 0 --scheme 4-point",
     "0.10000000000000001 2 0 1\n3 4 -1 0\n"},
    {square, "--levels 0 --linear --scheme 4-point", square},
    // comments, blank lines, tabs and line ends of other systems
    {"# a square\r\n\r\n 1\t0 # first\r\n+1 1.0\r\n\n  \n0 1e0\r\n-0.0 0\n# end",
     "--closed --linear --scheme chaikin", chaikin},
    // few points
    {"1 2 0 1\n", "--scheme bspline:3 --levels 3", "1 2 0 1\n"},
    {"1 2\n3 4\n", "--scheme 4-point --linear --levels 2", "1 2\n1.5 2.5\n2 3\n2.5 3.5\n3 4\n"},
    // estimated normals of lines and of repeated points
    {"0 0\n0 2\n0 4\n", "--levels 0 --scheme chaikin", "0 0 1 0\n0 2 1 0\n0 4 1 0\n"},
    {"0 0\n2 0\n", "--scheme 4-point", "0 0 0 -1\n1 0 0 -1\n2 0 0 -1\n"},
    {"1 2\n1 2\n", "--levels 0 --scheme chaikin", "1 2 0 0\n1 2 0 0\n"}};
  for (const auto& c : cases) EXPECT_EQ(refined(c.polygon, c.options), c.expected) << c.options;
}

TEST_F(Pn_subdivide_curve, EqualNormalsGiveTheLinearCurve)
{
  const std::string upright = "0 0 0 1\n4 16 0 1\n8 0 0 1\n12 16 0 1\n";
  Rows expected = rows_of(refined("0 0\n4 16\n8 0\n12 16\n", "--linear --scheme 4-point"));
  for (auto& row : expected) row.insert(row.end(), {0, 1});
  expect_rows(rows_of(refined(upright, "--scheme 4-point")), expected, 4e-15);
}

TEST_F(Pn_subdivide_curve, NumbersOfPointsByEndRules)
{
  for (const auto& [options, number] : {std::pair("--closed --scheme bspline:3", 12u),
                                        {"--closed --scheme chaikin", 12u},
                                        {"--scheme bspline:3", 11u},
                                        {"--scheme 6-point", 11u},
                                        {"--scheme chaikin", 10u},
                                        {"--scheme bspline:4", 8u},
                                        {"--scheme chaikin --end none", 10u},
                                        {"--scheme bspline:4 --end reflect", 10u},
                                        {"--scheme bspline:3 --end none", 9u},
                                        {"--scheme 4-point --end none", 7u},
                                        {"--scheme bspline:3 --levels 3", 41u}})
    EXPECT_EQ(lines(refined(zigzag, std::string("--linear ") + options)).size(), number) << options;
}

// Stencils that leave no polygon reflect nothing.
TEST_F(Pn_subdivide_curve, ReflectionThatChangesNothingIsSaid)
{
  const std::string input = folder.write("p.txt", "0 0\n4 0\n4 3\n0 3\n"),
                    output = folder.file("o.txt");
  const auto err = [&](const std::string& options) {
    const Outcome outcome = done(curve(input, output, "--quiet --levels 2 " + options));
    return outcome.err;
  };
  for (const char* const scheme : {"chaikin", "bspline:2"}) {
    const std::string options = std::string("--scheme ") + scheme;
    EXPECT_EQ(err(options + " --end none"), "");
    const std::string curve = Temporary_folder::content(output);
    expect_part(err(options + " --end reflect"), "warning: --end reflect: ");
    EXPECT_EQ(Temporary_folder::content(output), curve);
  }
  EXPECT_EQ(err("--scheme bspline:4 --end reflect"), "");
  EXPECT_EQ(err("--scheme bspline:3 --end reflect"), "");
}

TEST_F(Pn_subdivide_curve, RoundsInOneCallEqualCallsWithOneRound)
{
  for (const char* options :
       {"--scheme bspline:3", "--scheme chaikin", "--scheme 4-point --closed"}) {
    const std::string twice = refined(refined(with_normals, options), options);
    EXPECT_EQ(refined(with_normals, std::string(options) + " --levels 2"), twice);
  }
}

TEST_F(Pn_subdivide_curve, NormalsByAnotherScheme)
{
  const std::string options = "--scheme bspline:3 --closed";
  const std::string plain = refined(with_normals, options);
  EXPECT_EQ(refined(with_normals, options + " --normal-scheme bspline:3"), plain);

  const Rows other = rows_of(refined(with_normals, options + " --normal-scheme 4-point"));
  const Rows control = rows_of(with_normals);
  ASSERT_EQ(other.size(), 12u);
  double points_moved = 0;
  for (std::size_t i = 0; i < control.size(); ++i) {
    EXPECT_EQ(other[2 * i][2], control[i][2]); // interpolated
    EXPECT_EQ(other[2 * i][3], control[i][3]);
    points_moved += std::abs(other[2 * i][1] - control[i][1]);
  }
  EXPECT_GT(points_moved, 0.01); // approximated
}

TEST_F(Pn_subdivide_curve, LinearTakesNoNoticeOfNormals)
{
  const std::string bare = refined("1 0 2\n1 1 3\n0 1 4\n0 0 5\n", "--linear --scheme bspline:3");
  EXPECT_EQ(
    refined("1 0 2 1 0 0\n1 1 3 0 1 0\n0 1 4 0 0 1\n0 0 5 0 0 7\n", "--linear --scheme bspline:3"),
    bare);
}

TEST_F(Pn_subdivide_curve, RepeatedPoints)
{
  for (const auto& row : rows_of(refined("1 2\n1 2\n1 2\n1 2\n", "--scheme 4-point --levels 4"))) {
    EXPECT_EQ(row[0], 1);
    EXPECT_EQ(row[1], 2);
    EXPECT_TRUE(std::isfinite(row[2]) && std::isfinite(row[3]));
  }
}

TEST_F(Pn_subdivide_curve, InputAndOutputMayBeTheSameFile)
{
  const std::string file = folder.write("same.txt", square);
  done(curve(file, file, "--scheme chaikin --closed --linear"));
  EXPECT_EQ(lines(Temporary_folder::content(file)).size(), 8u);
}

// --- errors ---

TEST_F(Pn_subdivide_curve, BadFiles)
{
  expect_bad_file("", "empty");
  expect_bad_file("# nothing\n\n", "no vertices");
  expect_bad_file("1\n2\n", "line 1: 1 number, but");
  expect_bad_file("# five\n1 2 3 4 5\n", "line 2: 5 numbers, but a vertex");
  expect_bad_file("1 2 3 4 5 6 7\n", "line 1: 7 numbers, but");
  expect_bad_file("0 0\n1 1\n\n2 2 0 1\n", "line 4: 4 numbers, but 2 in line 1");
  expect_bad_file("0 0 0 1\n1 1\n", "line 2: 2 numbers, but 4 in line 1");
  expect_bad_file("0 0 0 1\n1 1 1\n", "line 2: 3 numbers, but 4 in line 1");
  expect_bad_file("0 0\n1 one\n", "line 2: 'one'");
  expect_bad_file("0 0\n1 1,5\n", "line 2: '1,5'");
  expect_bad_file("0 0\nnan 1\n", "line 2: the position is not finite");
  expect_bad_file("0 0 0 1\n1 1e999 0 1\n", "line 2: the position is not finite");
  expect_bad_file("0 0 0 1\n1 1 inf 1\n", "line 2: the normal is not finite");
  expect_bad_file("0 0 0\n1 1 1\n3 3 3\n", "straight curve in space without normals");
}

TEST_F(Pn_subdivide_curve, CornersStaySharp)
{
  const std::string corners = folder.write("corners.txt", "# two\n0 2\n");
  // the parts are straight: their normals are equal, and points stay on them
  const Rows rows = rows_of(
    refined("0 0\n2 0\n4 0\n4 2\n", "--scheme 4-point --levels 2 --sharp '" + corners + "'"));
  ASSERT_EQ(rows.size(), 13u);
  for (std::size_t i = 0; i <= 8; ++i) EXPECT_EQ(rows[i][1], 0) << i;
  for (std::size_t i = 8; i < 13; ++i) EXPECT_EQ(rows[i][0], 4) << i;
  EXPECT_NEAR(rows[8][2], std::sqrt(0.5), 1e-15); // between the normals of both sides
}

TEST_F(Pn_subdivide_curve, ClosedPolygonsWithCornersBeginAtTheFirstVertex)
{
  const std::string corners = folder.write("corners.txt", "3 1\n");
  const Rows rows =
    rows_of(refined(square, "--scheme bspline:3 --levels 3 --closed --sharp '" + corners + "'"));
  ASSERT_EQ(rows.size(), 32u);
  EXPECT_EQ(rows[8], (std::vector<double>{1, 1, rows[8][2], rows[8][3]}));
  EXPECT_EQ(rows[24], (std::vector<double>{0, 0, rows[24][2], rows[24][3]}));
}

TEST_F(Pn_subdivide_curve, LinesAndArcsOfADrawingAreKept)
{
  const char* drawing = "1 0\n5 0\n5.5 0.1339746\n5.8660254 0.5\n6 1\n6 3\n0 3\n0 1\n"
                        "0.1339746 0.5\n0.5 0.1339746\n";
  const Rows rows =
    rows_of(refined(drawing, "--scheme bspline:3 --levels 3 --closed --sharp arcs"));
  ASSERT_EQ(rows.size(), 80u);
  for (const auto& row : rows) {
    const double x = row[0], y = row[1];
    const double center = x > 5 && y < 1 ? 5 : x < 1 && y < 1 ? 1 : -1;
    const double distance =
      center > 0 ? std::abs(std::hypot(x - center, y - 1) - 1)
                 : std::min({std::abs(y), std::abs(y - 3), std::abs(x), std::abs(x - 6)});
    EXPECT_LT(distance, 1e-7) << x << ' ' << y;
  }
  expect_failure(drawing, "--scheme bspline:3 --sharp arcs --interpolate points", 2,
                 "--sharp arcs and --interpolate");
}

TEST_F(Pn_subdivide_curve, CornersThatCannotBe)
{
  const auto sharp = [&](const char* text) {
    return " --sharp '" + folder.write("corners.txt", text) + "'";
  };
  expect_failure(square, "--scheme chaikin" + sharp("1"), 2, "primal");
  expect_failure(square, "--scheme 4-point --end none" + sharp("1"), 2, "--end none");
  expect_failure(square, "--scheme 4-point" + sharp("4"), 1, "no vertex 4");
  expect_failure(square, "--scheme 4-point" + sharp("# none"), 1, "no numbers");
  expect_failure(square, "--scheme 4-point" + sharp("one"), 1, "line 1");
}

TEST_F(Pn_subdivide_curve, FilesThatCannotBeReadOrWritten)
{
  const std::string input = folder.write("square.txt", square), output = folder.file("out.txt");
  const std::string options = " --scheme chaikin";
  expect_one_line(run("curve missing.txt '" + output + "'" + options), 1, "missing.txt: cannot be");
  expect_one_line(curve("", output, options), 1, "directory");
  expect_one_line(curve(input, folder.file("no/out.txt"), options), 1, "there is no folder");
  EXPECT_EQ(folder.number_of_files(), 1u);
}

TEST_F(Pn_subdivide_curve, BadCommandLines)
{
  for (const char* scheme :
       {"bspline:1", "bspline:10", "bspline:", "bspline:2x", "bspline", "0-point", "3-point",
        "22-point", "-4-point", "4point", "cubic", "catmull-clark"})
    expect_failure(square, std::string("--scheme ") + scheme, 2, scheme);
  expect_failure(square, "--scheme 4-point --end mirror", 2, "--end 'mirror'");
  expect_failure(square, "--scheme 4-point --closed --end none", 2, "--closed");
  expect_failure(square, "--scheme 4-point --linear --normal-scheme 6-point", 2, "--linear");
  expect_failure(square, "--scheme 4-point --normal-scheme chaikin", 2, "dual");
  expect_failure(square, "--scheme chaikin --normal-scheme bspline:3", 2, "dual");
  expect_failure(square, "--scheme chaikin --levels -1", 2, "--levels");
  expect_failure(square, "--scheme chaikin --levels two", 2, "--levels");
  expect_failure(square, "--scheme chaikin --threads 2", 2, "--threads");
}

TEST_F(Pn_subdivide_curve, TooShortForItsSchemeOrTooLongToBeNumbered)
{
  expect_failure(square, "--scheme 6-point --end none", 1, "4 points is too short");
  expect_failure(square, "--scheme bspline:8", 1, "4 points is too short");
  expect_failure(square, "--scheme chaikin --closed --levels 31", 1, "ask for fewer rounds");
  expect_failure(square, "--scheme 4-point --levels 4000000000", 1, "ask for fewer rounds");
}

TEST_F(Pn_subdivide_curve, TheClosingLineSaysWhatWasDone)
{
  const std::string input = folder.write("p.txt", "0 0\n1 0\n1 1\n"), output = folder.file("c.txt");
  const auto said = [&](const std::string& options) {
    return curve(input, output, "--closed --scheme chaikin " + options).err;
  };
  const std::string line = said("--levels 2");
  EXPECT_EQ(
    line.rfind(output + ": 12 points, PN quadratic B-spline, 2 rounds, estimated normals, ", 0), 0u)
    << line;
  expect_part(said("--linear"), "no normals");
  EXPECT_EQ(said("--quiet"), "");
}

TEST_F(Pn_subdivide_curve, TheClosingLineSaysWhetherThereAreArcs)
{
  const auto said = [&](double width) {
    const double step = std::acos(-1.) / 12;
    std::string ellipse;
    for (int i = 0; i < 24; ++i)
      ellipse += std::to_string(width * std::cos(i * step)) + ' ' +
                 std::to_string(std::sin(i * step)) + '\n';
    const std::string input = folder.write("e.txt", ellipse), output = folder.file("c.txt");
    return curve(input, output, "--closed --sharp arcs").err;
  };
  expect_part(said(1), "round, normals of lines and arcs");
  expect_part(said(3), "round, estimated normals");
}

// --- limits ---

TEST_F(Pn_subdivide_curve, LinearLimitsAsComputedByHand)
{
  const std::string polygon = "0 0\n6 0\n6 6\n0 6\n";
  expect_rows(rows_of(refined(polygon, "--closed --scheme bspline:3 --linear --levels 0 --limit")),
              {{1, 1}, {5, 1}, {5, 5}, {1, 5}}, 1e-14);
  // of dual schemes the middles of the edges
  expect_rows(rows_of(refined(polygon, "--closed --scheme chaikin --linear --levels 0 --limit")),
              {{3, 0}, {6, 3}, {3, 6}, {0, 3}}, 1e-14);
  const double r = std::sqrt(.5);
  expect_rows(rows_of(refined(polygon, "--closed --scheme bspline:3 --linear --levels 0 --limit "
                                       "--curve-normals")),
              {{1, 1, -r, -r}, {5, 1, r, -r}, {5, 5, r, r}, {1, 5, -r, r}}, 1e-14);
}

TEST_F(Pn_subdivide_curve, LimitsAreTheSameAtEveryLevel)
{
  const std::string polygon = "0 0\n2 0\n3 1\n3 3\n1 4\n0 2\n";
  const std::string sharp = " --sharp '" + folder.write("corners.txt", "2 3\n") + "'";
  for (const char* scheme : {"bspline:3", "bspline:5", "4-point"})
    for (const std::string& how : {std::string(" --closed"), std::string(), sharp}) {
      const std::string options = std::string("--limit --curve-normals --scheme ") + scheme + how;
      const Rows coarse = rows_of(refined(polygon, options + " --levels 0"));
      const Rows fine = rows_of(refined(polygon, options + " --levels 3"));
      ASSERT_EQ(coarse.size(), 6u);
      for (std::size_t i = 0; i < coarse.size(); ++i)
        for (std::size_t j = 0; j < 4; ++j)
          EXPECT_NEAR(coarse[i][j], fine.at(8 * i)[j], j < 2 ? 1e-8 : 2e-3) << options << i;
    }
}

TEST_F(Pn_subdivide_curve, NormalsOfTheCurveWithoutItsPoints)
{
  const std::string polygon = "0 0\n2 0\n3 1\n3 3\n";
  const std::string options = "--scheme bspline:3 --levels 2";
  const Rows control = rows_of(refined(polygon, options));
  const Rows normals = rows_of(refined(polygon, options + " --curve-normals"));
  const Rows both = rows_of(refined(polygon, options + " --curve-normals --limit"));
  ASSERT_EQ(normals.size(), control.size());
  for (std::size_t i = 0; i < normals.size(); ++i) {
    EXPECT_EQ(normals[i][0], control[i][0]);
    EXPECT_EQ(normals[i][2], both[i][2]);
  }
  EXPECT_NE(normals[2][2], control[2][2]);
}

TEST_F(Pn_subdivide_curve, SaysHowCloseTheLimitIs)
{
  const std::string input = folder.write("p.txt", "0 0\n1 0\n1 1\n3 2\n"),
                    output = folder.file("c.txt");
  const auto said = [&](const std::string& options) {
    return curve(input, output, "--scheme bspline:3 " + options).err;
  };
  const std::string all = said("--limit --curve-normals");
  expect_part(all, "limit points: estimated error");
  expect_part(all, "curve normals: estimated error");
  expect_no_part(said("--curve-normals"), "limit points");
  expect_part(said("--limit --limit-tolerance 1e-30"), "the tolerance of the limit is missed");
}

TEST_F(Pn_subdivide_curve, LimitsThatCannotBe)
{
  expect_failure(square, "--scheme bspline:3 --limit-tolerance 1e-6", 2, "--limit-tolerance");
  expect_failure(square, "--scheme bspline:3 --limit --limit-tolerance 0", 2, "greater than 0");
  expect_failure(square, "--scheme bspline:3 --surface-normals", 2, "--surface-normals");
  expect_failure(square, "--scheme chaikin --curve-normals", 2, "belong to the edges");
  expect_failure(square, "--scheme bspline:3 --end none --curve-normals", 2, "--end none");
  expect_failure("0 0 0\n1 0 0\n1 1 1\n", "--scheme bspline:3 --linear --limit --curve-normals", 1,
                 "in space");
}

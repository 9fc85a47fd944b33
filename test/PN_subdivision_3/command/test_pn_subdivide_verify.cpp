// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// --verify and --tolerance of the command, on data whose deviation is known.

#include "Command_test.h"

#include <cmath>
#include <cstdio>
#include <iomanip>

namespace {

const double ulp = std::ldexp(1., -52);

class Verify : public Command_test
{
protected:
  struct Printed
  {
    double deviation = -1, units = -1, bound = -1;
  };

  // the command's one line, in exactly the form that scripts rely on
  static Printed printed(const Outcome& outcome)
  {
    Printed p;
    int length = -1;
    EXPECT_EQ(std::sscanf(outcome.out.c_str(), "deviation %lf (D/R in 2^-52: %lf) bound %lf\n%n",
                          &p.deviation, &p.units, &p.bound, &length),
              3)
      << outcome.out << outcome.err;
    EXPECT_EQ(length, static_cast<int>(outcome.out.size())) << outcome.out;
    return p;
  }

  Printed verified(const std::string& arguments) const
  {
    SCOPED_TRACE(arguments);
    const Outcome outcome = done(run(arguments + " --quiet"));
    EXPECT_EQ(outcome.err, "");
    return printed(outcome);
  }

  std::string output = folder.file("output.ply"), curve_output = folder.file("output.txt");

  std::string surface(const std::string& file, const std::string& options) const
  {
    return "surface " + words(file, output) + "--scheme catmull-clark " + options;
  }
  std::string curve(const std::string& content, const std::string& options) const
  {
    return "curve '" + folder.write("polygon.txt", content) + "' '" + curve_output +
           "' --scheme 4-point " + options;
  }
};

// a box with 1 as distance of its corners from the axis x = 3, y = -4
const char* const box =
  "OFF\n8 6 0\n4 -4 0.5\n3 -3 0.5\n2 -4 0.5\n3 -5 0.5\n4 -4 3.5\n3 -3 3.5\n2 -4 3.5\n3 -5 3.5\n"
  "4 3 2 1 0\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";

std::string circle(double x, double y, double r)
{
  std::ostringstream out;
  out << std::setprecision(17);
  for (const double t : {0., 0.4, 1.2, 1.5, 2.4, 2.9, 3.8, 4.2, 5.1, 5.7})
    out << x + r * std::cos(t) << ' ' << y + r * std::sin(t) << ' ' << std::cos(t) << ' '
        << std::sin(t) << '\n';
  return out.str();
}

TEST_F(Verify, KnownDeviationsOfControlData)
{
  const std::string file = folder.write("box.off", box);
  const double corner = std::sqrt(1 + 2.25); // from the middle
  Printed p = verified(surface(file, "--levels 0 --verify sphere:3,-4,2,1.25"));
  EXPECT_NEAR(p.deviation, corner - 1.25, 1e-6);
  EXPECT_NEAR(p.units, (corner - 1.25) / 1.25 / ulp, 1e-5 * p.units);
  EXPECT_NEAR(p.bound, (5 * 1.25 + 3 * std::sqrt(29)) * ulp, 1e-5 * p.bound);
  p = verified(surface(file, "--levels 0 --verify cylinder:3,-4,100,0,0,-7,1"));
  EXPECT_EQ(p.deviation, 0);
  EXPECT_EQ(p.units, 0);
  // the axis beside the upper corners, not the point of it that was given
  EXPECT_NEAR(p.bound, (5 + 3 * std::sqrt(25 + 3.5 * 3.5)) * ulp, 1e-5 * p.bound);
  // however long the direction
  for (const char* length : {"1e-200", "5e-324", "-1e300"}) {
    const std::string axis = std::string("0,0,") + length;
    const Printed q =
      verified(surface(file, "--levels 0 --verify cylinder:3,-4,100," + axis + ",1"));
    EXPECT_EQ(q.deviation, 0) << length;
    EXPECT_EQ(q.bound, p.bound) << length;
  }
  p = verified(surface(file, "--levels 0 --verify cylinder:3,-4,0,0,0,1,0.75"));
  EXPECT_EQ(p.deviation, 0.25);

  p = verified(curve("3 1 1 0\n1 3.5 0 1\n", "--levels 0 --verify circle:1,1,2"));
  EXPECT_EQ(p.deviation, 0.5);
  EXPECT_EQ(p.units, std::round(0.25 / ulp / 1e10) * 1e10);
  EXPECT_NEAR(p.bound, (10 + 3 * std::sqrt(2)) * ulp, 1e-5 * p.bound);
  // 3 too far out and 4 out of the plane
  const std::string space = "5 2 4 1 0 0\n2 2 0 1 0 0\n";
  EXPECT_EQ(verified(curve(space, "--levels 0 --verify circle:0,2,0,0,0,7,2")).deviation, 5);
  EXPECT_EQ(verified(curve(space, "--levels 0 --verify cylinder:0,2,0,0,0,7,2")).deviation, 3);
  EXPECT_EQ(verified(curve(space, "--levels 0 --verify sphere:5,2,0,4")).deviation, 1);
}

TEST_F(Verify, ReproducedShapesKeepTheBound)
{
  const auto expect_kept = [this](const std::string& command) {
    const Printed p = verified(command);
    EXPECT_GT(p.deviation, 0) << command;
    EXPECT_LE(p.deviation, p.bound) << command;
    EXPECT_EQ(run(command + " --tolerance 1e-13").code, 0) << command;
  };
  const std::string data = PN_DATA_DIR;
  expect_kept(surface(data + "/sphere_quads.ply", "--levels 3 --verify sphere:0,0,0,1"));
  expect_kept(surface(data + "/cylinder_quads.ply", "--levels 3 --verify cylinder:0,0,0,0,0,1,1"));
  // with normals of the shape, which the file does not have; without them the uneven cylinder is left
  std::string open_box = box;
  for (std::size_t i = 0; (i = open_box.find("3 -3 ")) != std::string::npos;)
    open_box.replace(i, 4, "3.6 -3.2");
  open_box.replace(open_box.find("8 6"), 3, "8 4");
  open_box.erase(open_box.find("4 3 2 1 0"), 20);
  const std::string sides = folder.write("sides.off", open_box);
  expect_kept(surface(sides, "--levels 3 --normals cylinder:3,-4,7,0,0,-4 --verify "
                             "cylinder:3,-4,0,0,0,1,1"));
  EXPECT_GT(verified(surface(sides, "--levels 3 --verify cylinder:3,-4,0,0,0,1,1")).deviation, .01);
  expect_kept(surface(sides, "--levels 3 --normals sphere:3,-4,2 --verify "
                             "sphere:3,-4,2,1.8027756377319946"));
  expect_kept(curve(circle(0, 0, 1), "--closed --levels 6 --verify circle:0,0,1"));
  // estimated ones, of uneven samples
  std::istringstream lines(circle(0, 0, 1));
  std::string points;
  for (std::string x, y, n; lines >> x >> y; std::getline(lines, n)) points += x + ' ' + y + '\n';
  expect_kept(curve(points, "--closed --levels 6 --verify circle:0,0,1"));
  expect_kept(curve(circle(40, -30, 1), "--closed --levels 6 --verify circle:40,-30,1"));
  // the linear scheme does not
  const Printed linear =
    verified(surface(data + "/sphere_quads.ply", "--linear --levels 3 --verify sphere:0,0,0,1"));
  EXPECT_GT(linear.deviation, 1e-4);
  EXPECT_LT(linear.bound, 1.2e-15);
}

TEST_F(Verify, BeyondTheToleranceTheExitCodeIs3AndTheFileIsThere)
{
  const std::string file = folder.write("box.off", box);
  const std::string at_a_quarter = "--levels 0 --verify cylinder:3,-4,0,0,0,1,0.8";
  done(run(surface(file, at_a_quarter + " --tolerance 0.2500001")));
  const std::string before = Temporary_folder::content(output);
  std::remove(output.c_str());
  const Outcome beyond = run(surface(file, at_a_quarter + " --tolerance 0.2499999"));
  EXPECT_EQ(beyond.code, 3);
  EXPECT_NEAR(printed(beyond).deviation, 0.2, 1e-6);
  expect_part(beyond.err, "more than 0.25 times the radius 0.8");
  EXPECT_EQ(std::count(beyond.err.begin(), beyond.err.end(), '\n'), 1) << beyond.err;
  EXPECT_EQ(Temporary_folder::content(output), before);

  const std::string polygon = "3 1 1 0\n1 3.5 0 1\n";
  done(run(curve(polygon, "--levels 0 --verify circle:1,1,2 --tolerance 0.26")));
  std::remove(curve_output.c_str());
  EXPECT_EQ(run(curve(polygon, "--levels 0 --verify circle:1,1,2 --tolerance 0.24")).code, 3);
  EXPECT_NE(Temporary_folder::content(curve_output), "");
  // exact data has no deviation at all
  done(run(surface(file, "--levels 0 --verify cylinder:3,-4,0,0,0,1,1 --tolerance 0")));
}

// A script that reads the deviation must not take silence for success.
TEST_F(Verify, DeviationThatCannotBePrintedIsAnError)
{
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "does not apply: no /dev/full";
  const std::string file = folder.write("box.off", box), err = work.file("message");
  const std::string command = "'" PN_SUBDIVIDE_COMMAND "' ";
  for (const std::string& arguments : {surface(file, "--verify sphere:0,0,0,1"),
                                       curve("1 0 1 0\n0 1 0 1\n", "--verify circle:0,0,1")}) {
    EXPECT_NE(std::system((command + arguments + " >/dev/full 2>'" + err + "'").c_str()), 0);
    const std::string message = Temporary_folder::content(err);
    EXPECT_EQ(message.rfind("pn_subdivide: --verify", 0), 0u) << message;
    EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 1) << message;
  }
  EXPECT_FALSE(std::filesystem::exists(output));
  EXPECT_FALSE(std::filesystem::exists(curve_output));
}

TEST_F(Verify, WhatIsWrongIsSaidBeforeAnythingIsWritten)
{
  const std::string file = folder.write("box.off", box);
  struct Case
  {
    const char *options, *message;
  };
  for (const Case& c :
       std::vector<Case>{{"--verify torus:0,0,0,1", "'torus:0,0,0,1'"},
                         {"--verify sphere", "sphere:X,Y,Z,R"},
                         {"--verify sphere:0,0,0", "4 numbers"},
                         {"--verify sphere:0,0,x,1", "'x' is not a number"},
                         {"--verify sphere:0,0,0,0", "radius must be positive"},
                         {"--verify sphere:0,0,0,-1", "radius must be positive"},
                         {"--verify sphere:0,0,0,inf", "'inf' is not a number"},
                         {"--verify cylinder:0,0,0,0,0,0,1", "no direction"},
                         {"--verify cylinder:0,0,0,0,0,1", "7 numbers"},
                         {"--verify circle:0,0,1", "no surface is a circle"},
                         {"--verify circle:0,0,0,0,0,1,1", "no surface is a circle"},
                         {"--verify circle:0,0,0,1", "X,Y,R or"},
                         {"--verify sphere:0,0,0,1 --tolerance -1", "not negative"},
                         {"--verify sphere:0,0,0,1 --tolerance nan", "not negative"},
                         {"--verify sphere:0,0,0,1 --tolerance ''", "--tolerance"},
                         {"--verify sphere:0,0,0,1 --tolerance low", "--tolerance"},
                         {"--tolerance 1e-9", "--verify"}}) {
    SCOPED_TRACE(c.options);
    expect_one_line(run(surface(file, c.options)), 2, c.message);
    EXPECT_EQ(Temporary_folder::content(output), "");
  }
  const std::string planar = circle(0, 0, 1);
  expect_one_line(run(curve(planar, "--tolerance 1")), 2, "--verify");
  expect_one_line(run(curve(planar, "--verify circle:0,0,0,1")), 2, "X,Y,R or");
  for (const char* shape : {"sphere:0,0,0,1", "circle:0,0,0,0,0,1,1", "cylinder:0,0,0,0,0,1,1"})
    expect_one_line(run(curve(planar, std::string("--verify ") + shape)), 1,
                    "the curve is in the plane");
  expect_one_line(run(curve("1 0 0 1 0 0\n0 1 0 0 1 0\n", "--verify circle:0,0,1")), 1,
                  "the curve is in space");
  EXPECT_EQ(Temporary_folder::content(curve_output), "");
}

} // namespace

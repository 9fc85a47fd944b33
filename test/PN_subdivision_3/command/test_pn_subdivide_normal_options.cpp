// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
// --normals smooth of surfaces and --normals spherical:X,Y,Z of curves.

#include "Command_test.h"
#include "Part_files.h"

#include <cmath>

namespace {

const double pi = std::acos(-1.);

const pn_subdivide::Torus exact(24, 12, 2, .8);

class Normal_options : public Command_test
{
protected:
  // with normals that have a noise of so many radians
  static std::string torus(double noise, bool has_normals = true)
  {
    std::mt19937 generator(1);
    std::uniform_real_distribution<double> random(-noise, noise);
    pn_subdivide::Torus part = exact;
    for (pn_subdivide::Triple& n : part.normals)
      for (double& x : n) x += random(generator);
    return has_normals ? part.off(part.normals) : part.off();
  }

  // the root mean square angle of the normals of the last control net, in radians
  double error() const
  {
    const auto normals = pn_subdivide::read_mesh(path("out.off")).normals;
    EXPECT_EQ(normals.size(), 288u);
    double sum = 0;
    for (std::size_t v = 0; v < normals.size(); ++v)
      sum += std::pow(pn_subdivide::distance(normals[v], exact.normals[v]), 2);
    return std::sqrt(sum / 288);
  }

  std::string control_net(const std::string& input, const std::string& options) const
  {
    done(surface(folder.write("in.off", input), "out.off",
                 "--levels 0 --output-normals control --quiet " + options));
    return content("out.off");
  }
};

TEST_F(Normal_options, SmoothTakesNoiseOff)
{
  const std::string given = torus(.05);
  control_net(given, "--normals file");
  const double before = error();
  EXPECT_GT(before, .03);
  control_net(given, "--normals smooth");
  EXPECT_LT(error(), .5 * before);
  const Outcome outcome =
    done(surface(folder.write("in.off", given), "out.ply", "--normals smooth"));
  expect_part(outcome.err, "have a noise of about 2.");
  expect_part(outcome.err, "288 smoothed, by up to");
  expect_part(outcome.err, "smoothed normals of the file");
}

TEST_F(Normal_options, SmoothLeavesExactNormals)
{
  EXPECT_EQ(control_net(torus(0), "--normals smooth"), control_net(torus(0), "--normals file"));
  const Outcome outcome = surface(folder.write("in.off", torus(0)), "out.ply", "--normals smooth");
  expect_part(outcome.err, "left as they are");
  expect_no_part(outcome.err, "smoothed normals");
}

// A coarse head: its shape misses arcs by more than any noise.
TEST_F(Normal_options, SmoothSaysWhatIsRougherThanLinear)
{
  const std::string head = folder.file("head.obj");
  done(run("surface '" PN_DATA_DIR "/head.obj' '" + head +
           "' --levels 0 --normals estimate --output-normals control"));
  const Outcome outcome = done(surface(head, "out.ply", "--normals smooth"));
  const auto after = [&](const std::string& words) {
    const std::size_t place = outcome.err.find(words);
    EXPECT_NE(place, std::string::npos) << outcome.err;
    return place == std::string::npos ? 0. : std::stod(outcome.err.substr(place + words.size()));
  };
  EXPECT_GT(after("the faces turn by "), after("those of the linear result by "));
  expect_part(outcome.err, ": if that is rough take");
}

// wedge by wedge: those of the flat side stay
TEST_F(Normal_options, SmoothKnowsCreases)
{
  const std::string output = folder.file("out.ply");
  const Outcome outcome =
    done(run("surface '" PN_DATA_DIR "/parts/half_ball.obj' '" + output + "' --normals smooth"));
  expect_part(outcome.err, "normals in the file differ");
  expect_part(outcome.err, "miss arcs by");
}

TEST_F(Normal_options, SmoothIsRefusedWithoutNormals)
{
  const std::string command = "surface '" + folder.write("in.off", torus(0, false)) + "' '" +
                              folder.file("out.off") + "' --normals smooth";
  expect_one_line(run(command), 1, "--normals smooth, but the file has no vertex normals");
  expect_one_line(run(command + " --linear"), 2, "--normals and --linear");
}

TEST_F(Normal_options, SphericalKeepsTheSphere)
{
  std::ostringstream points, plane;
  points.precision(17);
  for (int i = 0; i < 8; ++i) {
    const double a = pi * i / 4 + .2 * (i % 2), z = .4 * std::sin(2 * a + .3);
    const double r = std::sqrt(1 - z * z);
    // other normals in the file do not count
    points << 1 + 2 * r * std::cos(a) << ' ' << 2 * r * std::sin(a) << ' ' << 2 * z << " 0 0 1\n";
    plane << r * std::cos(a) << ' ' << r * std::sin(a) << '\n';
  }
  const std::string files = "' '" + folder.file("out.txt") + "' --closed --levels 5 --normals ";
  const std::string curve = "curve '" + folder.write("in.txt", points.str()) + files;
  const Outcome outcome =
    done(run(curve + "spherical:1,0,0 --verify sphere:1,0,0,2 --tolerance 1e-14"));
  expect_part(outcome.err, "normals of the sphere");
  EXPECT_EQ(run(curve + "spherical:1,0,0.1 --verify sphere:1,0,0,2 --tolerance 1e-14").code, 3);
  expect_one_line(run(curve + "estimate"), 2, "spherical:X,Y,Z");
  expect_one_line(run(curve + "spherical:1,0"), 2, "spherical:X,Y,Z");
  expect_one_line(run(curve + "spherical:1,0,0 --linear"), 2, "--normals and --linear");
  expect_one_line(
    run("curve '" + folder.write("plane.txt", plane.str()) + files + "spherical:0,0,0"), 1,
    "the curve is in the plane");
}

} // namespace

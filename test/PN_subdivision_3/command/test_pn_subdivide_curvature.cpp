// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// `pn_subdivide surface --curvature`: the scalars, their colors, and the files that hold them.

#include "Command_test.h"
#include "Part_files.h"

#include "io/mesh_io.h"
#include "surface/vertex_curvature.h"

#include <cmath>

using namespace pn_subdivide;

namespace {

class Pn_subdivide_curvature : public Command_test
{
protected:
  Outcome catmull_clark(const std::string& input, const std::string& output,
                        const std::string& options) const
  {
    return surface(input, output, "--scheme catmull-clark " + options);
  }

  Values_by_name columns(const std::string& input, const std::string& options) const
  {
    EXPECT_EQ(done(catmull_clark(input, "columns.ply", "--ascii " + options)).out, "");
    return columns_of("columns.ply");
  }
};

} // namespace

TEST_F(Pn_subdivide_curvature, Sphere)
{
  for (const char* rounds : {"0 --threads 2", "0 --limit", "2", "2 --threads 2 --limit"}) {
    const std::string options = std::string("--normals sphere:0,0,0 --levels ") + rounds;
    const Values_by_name c = columns(data("cube.off"), options + " --curvature mean");
    const Values_by_name g = columns(data("cube.off"), options + " --curvature gaussian");
    const double mean = 1 / std::sqrt(3.), gaussian = 1. / 3;
    ASSERT_EQ(c.at("mean_curvature").size(), c.at("x").size());
    for (const double x : c.at("mean_curvature")) EXPECT_NEAR(x, mean, 1e-9);
    for (const double x : g.at("gaussian_curvature")) EXPECT_NEAR(x, gaussian, 1e-9);
    EXPECT_EQ(c.count("gaussian_curvature"), 0u);
    EXPECT_EQ(g.count("mean_curvature"), 0u);
  }
}

// A prism of twelve sides with sharp ends: these are planes, its side is a cylinder.
TEST_F(Pn_subdivide_curvature, CylinderBetweenCreases)
{
  const std::string input = folder.write("prism.off", regular_prism(12, 1).off());
  const std::string rims = "--sharp angle:60 --curvature mean ";
  const Values_by_name control = columns(input, rims + "--levels 0");
  for (const double x : control.at("mean_curvature")) EXPECT_NEAR(x, 0.25, 1e-4); // of both sides
  for (const char* limit : {"", " --limit"}) {
    const Values_by_name c = columns(input, rims + "--levels 2" + limit);
    std::size_t inside = 0;
    for (std::size_t v = 0; v < c.at("x").size(); ++v) {
      const double z = c.at("z")[v], r = std::hypot(c.at("x")[v], c.at("y")[v]);
      const bool is_on_wall = z > 1e-6 && z < 1 - 1e-6;
      if (is_on_wall) {
        EXPECT_NEAR(c.at("mean_curvature")[v], 0.5, 5e-4);
      } else if (r < 0.99) {
        EXPECT_NEAR(c.at("mean_curvature")[v], 0, 1e-4);
      }
      inside += is_on_wall;
    }
    EXPECT_EQ(inside, 3u * 48);
  }
}

// With equal normals the surface is that of the linear scheme, a paraboloid here, and these normals are not its own.
TEST_F(Pn_subdivide_curvature, IsThatOfTheLimitNotOfItsControlNormals)
{
  Part paraboloid = grid(8, 8);
  for (Triple& p : paraboloid.points) {
    const double x = p[0] / 10 - 0.4, y = p[1] / 10 - 0.4;
    p = {x, y, x * x + y * y};
  }
  const std::string input = folder.write(
    "flat.ply", paraboloid.ply(std::vector<Triple>(paraboloid.points.size(), Triple{0, 0, 1})));
  const std::string options = "--normals file --curvature mean --levels ";
  const Values_by_name c = columns(input, options + '2');
  std::size_t found = 0;
  for (std::size_t v = 0; v < c.at("x").size(); ++v)
    if (std::hypot(c.at("x")[v], c.at("y")[v]) < 1e-9) {
      EXPECT_NEAR(c.at("mean_curvature")[v], -2, 1e-3);
      ++found;
    }
  EXPECT_EQ(found, 1u);
}

// Without limits at the vertices, and with edges that are sharp for some more rounds, points alone are measured.
TEST_F(Pn_subdivide_curvature, WithoutLimits)
{
  for (const char* options :
       {"--scheme doo-sabin --levels 2", "--sharp angle:40 --sharpness 2.5"}) {
    done(surface(data("cube.off"), "o.ply", std::string("--curvature mean ") + options));
  }
}

// Red where the Gaussian curvature is positive, at the outer side of a torus, blue at the inner one.
TEST_F(Pn_subdivide_curvature, TorusIsRedOutsideAndBlueInside)
{
  const Values_by_name c = columns(data("torus_quads.ply"), "--levels 2 --curvature gaussian");
  const auto& k = c.at("gaussian_curvature");
  std::size_t full = 0;
  for (std::size_t v = 0; v < k.size(); ++v) {
    const double rho = std::hypot(c.at("x")[v], c.at("y")[v]);
    if (std::abs(rho - 2) > 0.1) {
      EXPECT_EQ(k[v] > 0, rho > 2);
      EXPECT_EQ(c.at("red")[v] > c.at("blue")[v], rho > 2);
    }
    const double exact = (rho - 2) / (0.75 * 0.75 * rho);
    EXPECT_NEAR(k[v], exact, 0.1);
    if (c.at("red")[v] == 59 && c.at("blue")[v] == 192) ++full;
  }
  EXPECT_GT(full, 0u); // the inner side has the largest values, and they are beyond the end
  EXPECT_LT(full, k.size() / 8);
}

TEST_F(Pn_subdivide_curvature, LinearSchemeWithoutNormals)
{
  const Values_by_name c = columns(data("spoon.obj"), "--levels 2 --linear --curvature mean");
  EXPECT_EQ(c.count("nx"), 0u);
  EXPECT_EQ(c.at("mean_curvature").size(), c.at("x").size());
  EXPECT_EQ(c.at("green").size(), c.at("x").size());
}

// What is added changes nothing else, and the file can be read again.
TEST_F(Pn_subdivide_curvature, RoundTrip)
{
  for (const char* options : {"--levels 1 --threads 1", "--levels 1 --ascii", "--levels 0"}) {
    const std::string plain = folder.file("plain.ply"), colored = folder.file("colored.ply");
    done(catmull_clark(data("creature.obj"), plain, options));
    ASSERT_EQ(
      catmull_clark(data("creature.obj"), colored, options + std::string(" --curvature mean")).code,
      0);
    const Mesh_data a = read_mesh(plain), b = read_mesh(colored);
    EXPECT_EQ(a.points, b.points);
    EXPECT_EQ(a.normals, b.normals);
    ASSERT_EQ(a.number_of_faces(), b.number_of_faces());
    for (std::size_t f = 0; f < a.number_of_faces(); ++f)
      EXPECT_TRUE(
        std::equal(a.face(f).begin(), a.face(f).end(), b.face(f).begin(), b.face(f).end()));
    EXPECT_NE(Temporary_folder::content(plain).size(), Temporary_folder::content(colored).size());
    done(catmull_clark(colored, plain, "--levels 1"));
  }
}

// The numbers of the text VTP are those of the text PLY, and the binary one has as many bytes.
TEST_F(Pn_subdivide_curvature, Vtp)
{
  const std::string input = data("mixed_borders.off"), output = folder.file("c.vtp");
  const Values_by_name ply = columns(input, "--curvature gaussian");
  done(catmull_clark(input, output, "--ascii --curvature gaussian"));
  const std::string text = Temporary_folder::content(output);
  expect_part(text, "<PointData Normals=\"Normals\" Scalars=\"gaussian_curvature\">");
  const auto expect_array = [&](const std::string& name, const std::vector<double>& expected) {
    std::size_t at = text.find(name);
    ASSERT_NE(at, std::string::npos);
    std::istringstream in(text.substr(text.find('\n', at)));
    for (const double x : expected) {
      double y = 0;
      ASSERT_TRUE(in >> y);
      EXPECT_EQ(x, y);
    }
    std::string end;
    in >> end;
    EXPECT_EQ(end, "</DataArray>");
  };
  expect_array("type=\"Float64\" Name=\"gaussian_curvature\" NumberOfComponents=\"1\"",
               ply.at("gaussian_curvature"));
  std::vector<double> colors;
  for (std::size_t v = 0; v < ply.at("red").size(); ++v)
    for (const char* channel : {"red", "green", "blue"}) colors.push_back(ply.at(channel)[v]);
  expect_array("type=\"UInt8\" Name=\"colors\" NumberOfComponents=\"3\"", colors);

  done(catmull_clark(input, output, ""));
  const std::string plain = Temporary_folder::content(output);
  done(catmull_clark(input, output, "--curvature gaussian"));
  const std::string binary = Temporary_folder::content(output);
  const auto appended = [](const std::string& file) { return file.size() - file.find("\n_"); };
  const std::size_t vertices = ply.at("x").size();
  EXPECT_EQ(appended(binary), appended(plain) + 2 * 8 + vertices * (8 + 3));
}

TEST_F(Pn_subdivide_curvature, PlaneIsWhiteAndHasNoCurvature)
{
  const auto height = [](int i, int j) { return 3 * i - 2 * j; };
  const std::string input = folder.write("plane.off", grid(5, 5, height).off());
  const Values_by_name c = columns(input, "--levels 2 --curvature mean");
  for (std::size_t v = 0; v < c.at("x").size(); ++v) {
    EXPECT_NEAR(c.at("mean_curvature")[v], 0, 1e-10);
    for (const char* channel : {"red", "green", "blue"}) EXPECT_NEAR(c.at(channel)[v], 242, 10);
  }
}

TEST_F(Pn_subdivide_curvature, SaysTheRange)
{
  const std::string output = folder.file("o.ply");
  const Outcome said = catmull_clark(data("torus_quads.ply"), output, "--curvature gaussian");
  EXPECT_EQ(said.err.rfind("Gaussian curvature from -", 0), 0u) << said.err;
  expect_part(said.err, ", colors from -");
  EXPECT_EQ(catmull_clark(data("torus_quads.ply"), output, "--quiet --curvature gaussian").err, "");
  const std::string lone =
    folder.write("lone.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n0 1 0\n5 5 5\n3 0 1 2\n");
  const Outcome few = catmull_clark(lone, output, "--levels 0 --normals none --curvature mean");
  expect_part(few.err, "4 vertices allow no estimate");
  EXPECT_EQ(few.code, 0);
}

// Before the input is read: it need not be there.
TEST_F(Pn_subdivide_curvature, WrongCommandLines)
{
  for (const char* extension : {"off", "obj"}) {
    const std::string output = folder.file(std::string("o.") + extension);
    expect_one_line(catmull_clark("missing.ply", output, "--curvature mean"), 2,
                    "only .ply and .vtp can");
  }
  expect_one_line(catmull_clark("missing.ply", folder.file("o.ply"), "--curvature maximal"), 2,
                  "expected gaussian or mean");
  EXPECT_EQ(folder.number_of_files(), 0u);
}

TEST(Diverging_color, WhiteAt0AndEvenOnBothSides)
{
  EXPECT_EQ(diverging_color(0), (Color{242, 242, 242}));
  EXPECT_EQ(diverging_color(-1), (Color{59, 76, 192}));
  EXPECT_EQ(diverging_color(1), (Color{180, 4, 38}));
  EXPECT_EQ(diverging_color(7), diverging_color(1));
  EXPECT_EQ(diverging_color(-7), diverging_color(-1));
  for (int i = 0; i < 20; ++i) { // green follows lightness
    EXPECT_GT(diverging_color(i / 20.)[1], diverging_color((i + 1) / 20.)[1]);
    EXPECT_GT(diverging_color(-i / 20.)[1], diverging_color(-(i + 1) / 20.)[1]);
  }
}

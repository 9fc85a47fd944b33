// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Parts without being asked, --part, and what --check says of them: files as openscad writes them, of known planes and cylinders.

#include "Extent.h"
#include "Part_files.h"
#include "Refined_files.h"

#include "io/mesh_io.h"

using namespace pn_subdivide;

namespace {

using Json = nlohmann::json;

// with_others: of some quads by the other diagonal, as openscad has them
Part triangles(Part part, bool with_others = false)
{
  for (std::size_t f = 0; with_others && f < part.faces.size(); ++f)
    if (f % 5 < 2)
      std::rotate(part.faces[f].begin(), part.faces[f].begin() + 1, part.faces[f].end());
  part.triangulate();
  return part;
}

// A cylinder of 20 facets, of radius 2 and height 3, of which the plane x = 1.3 has cut a piece off, through two facets.
Part cut_cylinder()
{
  std::vector<Triple> rim;
  for (int k = 0; k < 20; ++k) {
    const Triple p = on_circle(2, 18 * k, 0), q = on_circle(2, 18 * (k + 1), 0);
    if (p[0] < 1.3) rim.push_back(p);
    const double t = (1.3 - p[0]) / (q[0] - p[0]);
    if (t > 0 && t < 1) rim.push_back({1.3, p[1] + t * (q[1] - p[1]), 0});
  }
  return prism(rim, 3);
}

// The cylinder with a notch above z = 1 instead, whose wall is just beside a ruling.
Part notched_cylinder()
{
  constexpr double wall = 1.63;
  const Triple p = on_circle(2, 18, 0), q = on_circle(2, 36, 0);
  const double y = p[1] + (wall - p[0]) / (q[0] - p[0]) * (q[1] - p[1]);
  const Triple left{wall, -y, 1}, right{wall, y, 1}, upper_left{wall, -y, 3},
    upper_right{wall, y, 3};
  Part part;
  std::vector<Triple> bottom, top{upper_right};
  for (int k = 0; k < 20; ++k) {
    const auto a = [&](double z) { return on_circle(2, 18 * k, z); };
    const auto b = [&](double z) { return on_circle(2, 18 * (k + 1), z); };
    bottom.insert(bottom.begin(), a(0));
    if (k > 1 && k < 19) top.push_back(a(3));
    if (k == 0 || k == 19)
      part.add({a(0), b(0), b(1), a(1)});
    else if (k == 1)
      part.add({b(0), b(3), upper_right, right, a(1), a(0)});
    else if (k == 18)
      part.add({a(0), b(0), b(1), left, upper_left, a(3)});
    else
      part.add({a(0), b(0), b(3), a(3)});
  }
  top.push_back(upper_left);
  part.add({left, on_circle(2, -18, 1), on_circle(2, 0, 1), on_circle(2, 18, 1), right});
  part.add({left, right, upper_right, upper_left});
  part.add(top);
  part.add(bottom);
  return part;
}

// A cone of 20 facets of two triangles each, cut where its radius is 1.3.
Part cut_frustum()
{
  Part part;
  std::vector<Triple> bottom, top;
  for (int k = 0; k < 20; ++k) {
    const Triple a = on_circle(2, 18 * k, 0), b = on_circle(2, 18 * (k + 1), 0),
                 p = on_circle(1.3, 18 * k, 0.7), q = on_circle(1.3, 18 * (k + 1), 0.7),
                 m{p[0] + 0.7 * (q[0] - p[0]), p[1] + 0.7 * (q[1] - p[1]), 0.7};
    part.add({a, b, q, m});
    part.add({a, m, p});
    top.insert(top.end(), {p, m});
    bottom.insert(bottom.begin(), a);
  }
  part.add(top);
  part.add(bottom);
  return part;
}

// The top of a sphere of 40 sides, to 40 degrees below the pole, where a polygon is divided as openscad does.
Part top_of_sphere(bool has_base)
{
  const auto point = [](int k, int i) {
    const Triple p = on_circle(1, 9 * k + 4.5, 0); // height and radius
    return on_circle(p[1], 9 * i, p[0]);
  };
  Part top;
  std::vector<Triple> base;
  for (int i = 0; i < 40; ++i) {
    base.insert(base.begin(), point(4, i));
    for (int k = 0; k < 4; ++k) {
      const std::array<Triple, 4> p{point(k, i), point(k + 1, i), point(k + 1, i + 1),
                                    point(k, i + 1)};
      if (i % 2 == 0)
        top.add({p[0], p[1], p[2], p[3]});
      else
        top.add({p[1], p[2], p[3], p[0]});
    }
  }
  for (int i = 1; i < 20; ++i) {
    top.add({point(0, i), point(0, -i), point(0, 1 - i)});
    if (i > 1) top.add({point(0, i), point(0, 1 - i), point(0, i - 1)});
  }
  top.add({point(0, 20), point(0, -19), point(0, 19)});
  if (has_base) top.add(base);
  return top;
}

const Profile of_shaft{{2, 0}, {2, 1}, {1, 1}, {1, 3}},
  of_countersunk{{2.4, 0}, {.8, 1.6}, {.8, 3}}; // with a cone

// The distance of a point from what is turned, with flat ends.
double from_turned(const Triple& p, Profile profile)
{
  profile.insert(profile.begin(), {0, profile.front()[1]});
  profile.push_back({0, profile.back()[1]});
  const double r = std::hypot(p[0], p[1]), z = p[2];
  double nearest = HUGE_VAL;
  for (std::size_t k = 0; k + 1 < profile.size(); ++k) {
    const auto [r0, z0] = profile[k];
    const auto [r1, z1] = profile[k + 1];
    const double length = (r1 - r0) * (r1 - r0) + (z1 - z0) * (z1 - z0);
    double t = ((r - r0) * (r1 - r0) + (z - z0) * (z1 - z0)) / length;
    t = (std::min)(1., (std::max)(0., t));
    nearest = (std::min)(nearest, std::hypot(r - r0 - t * (r1 - r0), z - z0 - t * (z1 - z0)));
  }
  return nearest;
}

struct Distances
{
  double largest = 0, mean = 0;
};

// of the middles of the faces' edges, and of the faces
Distances from_turned(const Mesh_data& mesh, const Profile& profile)
{
  Distances d;
  std::size_t number = 0;
  const auto add = [&](const Triple& p) {
    const double distance = from_turned(p, profile);
    d.largest = (std::max)(d.largest, distance);
    d.mean += distance;
    ++number;
  };
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
    Triple middle{};
    for (const auto& [p, q] : sides(mesh, f)) {
      add(sum(p, difference(q, p), 0.5));
      middle = sum(middle, p, 1. / double(mesh.face(f).size()));
    }
    add(middle);
  }
  d.mean /= double(number);
  return d;
}

class Pn_subdivide_part : public Refined_files
{
protected:
  void SetUp() override
  {
    folder.write("shaft.stl", triangles(shaft()).stl());
    folder.write("shaft.ply", shaft().ply());
    folder.write("plate.ply", triangles(drilled_plate()).ply());
    folder.write("box.ply", box_of_squares(1, {0, 0, 0}, {1, 2, 3}).ply());
  }
  std::string said(const std::string& input, const std::string& options) const
  {
    const Outcome outcome = done(run(words(input, "said.ply") + options));
    return outcome.err;
  }
  std::string checked(const std::string& input, const std::string& options) const
  {
    const Outcome outcome = done(surface(input, "checked.stl", options + " --check"));
    return outcome.out;
  }
};

constexpr const char* taken = ": taken for a part, with ";

} // namespace

// --- without an option ---

// It is what --sharp surfaces makes where faces stay as they are.
TEST_F(Pn_subdivide_part, APartIsTakenForOne)
{
  for (const std::string input : {"shaft.stl", "shaft.ply", "plate.ply"}) {
    SCOPED_TRACE(input);
    const Mesh_data mesh = refined(input, "o.ply", "--levels 2"),
                    expected = refined(input, "p.ply",
                                       "--levels 2 --sharp surfaces --write-tags '" +
                                         folder.file("t.selection.txt") + "'"),
                    smooth = refined(input, "q.ply", "--levels 2 --sharp none");
    EXPECT_EQ(mesh.points, expected.points);
    EXPECT_EQ(mesh.number_of_faces(), smooth.number_of_faces());
    EXPECT_EQ(find_column(mesh.attributes.of_faces, "surface"), nullptr);
    EXPECT_EQ(mesh.attributes.of_faces.size(), smooth.attributes.of_faces.size());
    const std::string text = said(input, "--levels 2 --strict");
    expect_part(text, taken);
    expect_part(text, "--part");
    expect_part(text, "--sharp none");
    expect_no_part(text, "residual");
    expect_part(text, "normals of the surfaces");
  }
}

// A tenth of the vertices of this rod are at its ends, which is what the first look asks for, and it looks at some of them only.
TEST_F(Pn_subdivide_part, NumbersOfVerticesHaveNoSay)
{
  constexpr std::size_t sides = 64, rows = 20, n = sides * rows;
  for (const std::size_t factor : {1, 49, 163}) { // prime to n
    const auto number = [&](std::size_t row, std::size_t side) {
      return (row * sides + side % sides) * factor % n;
    };
    Part rod;
    rod.points.resize(n);
    std::vector<std::size_t> first, last;
    for (std::size_t side = 0; side < sides; ++side) {
      first.push_back(number(0, sides - side));
      last.push_back(number(rows - 1, side));
      for (std::size_t row = 0; row < rows; ++row) {
        rod.points[number(row, side)] =
          on_circle(1, 360. * double(side) / double(sides), 0.2 * double(row));
        if (row + 1 < rows)
          rod.faces.push_back({number(row, side), number(row, side + 1), number(row + 1, side + 1),
                               number(row + 1, side)});
      }
    }
    rod.faces.insert(rod.faces.end(), {first, last});
    folder.write("rod.off", rod.off());
    const std::string text = said("rod.off", "--levels 1");
    expect_part(text, taken);
  }
}

// By a tenth and less of what the file was, on cones, too, which subdivision does not keep.
TEST_F(Pn_subdivide_part, RoundSurfacesAreNearerThanTheFile)
{
  folder.write("countersunk.stl", triangles(turned(of_countersunk), true).stl());
  for (const char* const input : {"shaft.stl", "countersunk.stl"}) {
    SCOPED_TRACE(input);
    const Profile& profile = input[0] == 's' ? of_shaft : of_countersunk;
    const auto distances = [&](const char* output, const char* options) {
      return from_turned(refined(input, output, options), profile);
    };
    const Distances file = distances("o.ply", "--levels 0"), two = distances("p.ply", "--levels 2"),
                    surfaces = distances("p.ply", "--levels 2 --sharp surfaces"),
                    part = distances("q.stl", "--part");
    EXPECT_GT(file.largest, 0.01);
    EXPECT_LT(two.largest, file.largest / 10);
    EXPECT_LT(two.mean, file.mean / 10);
    EXPECT_LT(surfaces.largest, file.largest / 10);
    EXPECT_LT(part.largest, (std::max)(2e-4 * std::sqrt(41.), file.largest / 4));
  }
}

// The limit surface need not be the part: what a chord says is of the former.
TEST_F(Pn_subdivide_part, DistancesFromTheSurfacesAreTold)
{
  const std::string text = said("shaft.stl", "--part");
  expect_part(text, " against the limit surface");
  expect_part(text, "largest distance from the recognized surfaces 0.00");
  expect_no_part(text, "more than --chord");
  const std::string flat = said("shaft.stl", "--part --roundness 0");
  expect_part(flat, "from a recognized cylinder, more than --chord");
}

// What was cut were facets: the corners of the cut were on their chords.
TEST_F(Pn_subdivide_part, CutsEndOnTheSurface)
{
  folder.write("cut.ply", triangles(cut_cylinder()).ply());
  for (const std::string options :
       {"--levels 0", "--levels 2", "--levels 2 --sharp surfaces", "--part"}) {
    const Mesh_data mesh = refined("cut.ply", "o.ply", options);
    double widest = 0, off = 0;
    for (const Triple& p : mesh.points) {
      if (std::abs(p[0] - 1.3) < 1e-6) widest = (std::max)(widest, std::abs(p[1]));
      const double rho = std::hypot(p[0], p[1]),
                   end = (std::min)(std::abs(p[2]), std::abs(p[2] - 3));
      off = (std::max)(off, (std::min)({std::abs(rho - 2), std::abs(p[0] - 1.3), end}));
    }
    const bool is_copy = options == "--levels 0"; // which is the file's
    EXPECT_NEAR(widest, is_copy ? 1.5 : std::sqrt(4 - 1.3 * 1.3), is_copy ? 0.01 : 1e-5) << options;
    EXPECT_LT(off, 1e-5) << options;
  }
  expect_part(said("cut.ply", "--part"), "4 vertices that a cut left on chords");
  folder.write("frustum.ply", cut_frustum().ply());
  double off = 0;
  for (const Triple& p : refined("frustum.ply", "o.ply", "--part").points)
    off = (std::max)(off, std::abs(std::hypot(p[0], p[1]) - 2 + p[2]));
  EXPECT_LT(off, 1e-5);
}

TEST_F(Pn_subdivide_part, NarrowFacetsDoNotFold)
{
  folder.write("notch.ply", triangles(notched_cylinder()).ply());
  folder.write("top.ply", triangles(top_of_sphere(true)).ply());
  folder.write("open.ply", triangles(top_of_sphere(false)).ply());
  expect_no_part(said("open.ply", "--part"), "more than --chord");
  for (const std::string input : {"notch.ply", "top.ply"})
    for (const std::string options : {"--part", "--levels 2"}) {
      if (!tests_are_full && options != "--part") continue;
      const std::string text = checked(input, options + reported());
      EXPECT_EQ(report()["check"].at("edges_folded_by_150_degrees"), 0) << text;
      EXPECT_LT(report()["check"].at("largest_distance").get<double>(), 1e-4) << text;
    }
}

TEST_F(Pn_subdivide_part, WhatElseIsAskedForIsDone)
{
  const std::vector<std::string> others{"--sharp none",
                                        "--sharp angle:30",
                                        "--sharpness 1 --sharp angle:30",
                                        "--linear",
                                        "--normals estimate",
                                        "--normals none",
                                        "--interpolate points",
                                        "--scheme butterfly",
                                        "--normals cylinder:0,0,0,0,0,1",
                                        "--levels 0",
                                        "--output-normals none --levels 0",
                                        "--pieces 2"};
  for (const std::string& option : others) expect_no_part(said("plate.ply", option), taken);
  for (const std::string option :
       {"--sharp auto", "--normals auto", "--limit", "--chord 1%", "--border curve --levels 2",
        "--roundness 1", "--levels 0 --output-normals both", "--threads 2", "--scheme ct-loop"})
    expect_part(run(words("plate.ply", "o.ply") + option).err, taken);
}

// What the file says of edges and normals counts, if it says anything.
TEST_F(Pn_subdivide_part, FilesThatSayMoreAreNotTaken)
{
  const std::string tags = "--sharp surfaces --levels 0 --output-normals both";
  refined("plate.ply", "tagged.ply", tags);
  expect_no_part(said("tagged.ply", "--levels 1"), taken);
  const Part part = triangles(drilled_plate());
  std::vector<Triple> up(part.points.size(), Triple{0, 0, 1}), outwards, none(part.points.size());
  for (const Triple& p : part.points) outwards.push_back(unit({p[0], p[1], p[2] - .5}));
  folder.write("outwards.ply", part.ply(outwards));
  folder.write("none.ply", part.ply(none));
  expect_no_part(said("outwards.ply", "--levels 1 --normals file"), taken);
  expect_part(said("none.ply", "--levels 1"), taken);
}

// A vase of twelve sides is rows of cones above a plane, and meant to be smooth.
TEST_F(Pn_subdivide_part, RowsOfConesAreNoPart)
{
  for (const double height : {1., .4}) { // of a row, which turn by less, or more, than 40 degrees
    Profile profile;
    for (const double r : {1., 1.6, 1.9, 1.7, 1.1, .8, 1.})
      profile.push_back({r, height * double(profile.size())});
    folder.write("vase.ply", turned(profile, 12, true).ply());
    const std::string text = said("vase.ply", "--levels 1");
    expect_no_part(text, taken);
  }
}

TEST_F(Pn_subdivide_part, AColumnOfTheUsersStays)
{
  folder.write("own.ply", with_own_surfaces(triangles(drilled_plate()).ply(), "3"));
  const Mesh_data mesh = refined("own.ply", "o.ply", "--levels 1 --strict");
  const Column* const column = find_column(mesh.attributes.of_faces, "surface");
  ASSERT_NE(column, nullptr);
  EXPECT_EQ(mesh.attributes.of_faces.size(), 1u);
  for (const double s : column->values) EXPECT_EQ(s, 77);
}

// --- what is proposed ---

// A grid of squares with hills: no two of its faces are in one plane, and `steep` rows of edges turn much.
std::string hills(int n, int steep)
{
  const auto height = [&](int i, int j) {
    return 0.2 * std::sin(1.3 * i + 0.5 * j) + 0.1 * std::cos(2.1 * j - 0.7 * i) +
           (std::max)(0, i - n + steep) * 2.;
  };
  return triangulated(grid(std::size_t(n), std::size_t(n), height)).obj();
}

TEST_F(Pn_subdivide_part, TheClosingLineProposesWhatHelps)
{
  folder.write("few.obj", hills(12, 1));
  const std::string few = said("few.obj", "--levels 1");
  expect_part(few, " turn by more than 40 degrees: --sharp angle:40, ");
  const std::string in_pieces = said("few.obj", "--levels 1 --pieces 2");
  expect_part(in_pieces, " turn by more than 40 degrees: --sharp angle:40, ");
  // planes only
  const std::string planes = said("box.ply", "--levels 1");
  expect_part(planes, ", 12 edges turn by more than 40 degrees: --part, ");
  expect_no_part(planes, taken);
  // every face of it is a plane of its own, which says nothing, and half of its edges turn
  std::string gem_off = octahedron_off;
  gem_off.replace(gem_off.find("0 -1 0\n0 0 -1"), 13, "0 -1.1 0\n0 0 -1.2");
  folder.write("gem.off", gem_off);
  const std::string gem = said("gem.off", "--levels 1");
  expect_no_part(gem, "40 degrees");
  expect_no_part(said("shaft.stl", "--levels 1"), "40 degrees");
}

// --- --part ---

TEST_F(Pn_subdivide_part, PartStandsForThreeOptions)
{
  const std::string surfaces = "--sharp surfaces --planes rims ";
  for (const auto& [options, expected] : std::vector<std::pair<std::string, std::string>>{
         {"", "--chord 0.02%"},
         {" --chord 1%", "--chord 1%"},
         {" --levels 2", "--levels 2"},
         {" --sharp surfaces --min-facets 25", "--chord 0.02% --min-facets 25"},
         {" --roundness 0 --levels 1", "--roundness 0 --levels 1"},
         {" --curvature mean --levels 1", "--curvature mean --levels 1"}})
    EXPECT_EQ(written("shaft.stl", "o.ply", "--part" + options),
              written("shaft.stl", "p.ply", surfaces + expected))
      << options;
}

TEST_F(Pn_subdivide_part, WhatDoesNotGoWithPartIsNamed)
{
  for (const std::string option :
       {"--sharp none", "--sharp auto", "--sharp angle:30", "--sharpness", "--linear",
        "--interpolate", "--pieces", "--memory", "--write-tags", "--output-normals control",
        "--output-normals both", "--scheme doo-sabin", "--scheme sqrt3", "--scheme butterfly",
        "--curvature", "--limit-tolerance"}) {
    std::string given = option;
    if (option == "--pieces" || option == "--sharpness") given += " 2";
    if (option == "--interpolate") given += " slide";
    if (option == "--memory") given += " 1G";
    if (option == "--curvature") given += " mean";
    if (option == "--limit-tolerance") given += " 1e-6 --limit";
    if (option == "--write-tags") given += " '" + folder.file("t.selection.txt") + "'";
    const Outcome outcome = surface("shaft.stl", "o.ply", "--part " + given);
    expect_one_line(outcome, 2, "--part and ");
    expect_part(outcome.err, option);
  }
  expect_one_line(surface("shaft.stl", "o.ply", "--part --chord 1 --levels 2"), 2, "--levels 2");
}

// --- borders ---

// The bottom of the plate, an open sheet, and a stadium.
TEST_F(Pn_subdivide_part, BordersOfPlanesAreLinesAndArcs)
{
  const Part plate = drilled_plate();
  Part sheet, stadium;
  for (std::size_t f = 0; f < plate.faces.size(); f += 4) {
    std::vector<Triple> corners;
    for (const std::size_t v : plate.faces[f]) corners.push_back(plate.points[v]);
    sheet.add(corners);
  }
  std::vector<Triple> rim;
  for (const double x : {2., -2.})
    for (int i = 0; i <= 12; ++i) rim.push_back(sum(on_circle(1, 15. * i - 45 * x, 0), {x, 0, 0}));
  stadium.add(rim);
  const double pi = 4 * std::atan(1.);
  for (const auto& [part, exact] : {std::pair(sheet, 16 - pi), std::pair(stadium, 8 + pi)})
    for (const std::string options : {"--part", "--part --levels 3"}) {
      SCOPED_TRACE(options);
      for (const bool split : {false, true}) {
        folder.write("open.ply", (split ? triangles(part) : part).ply());
        const Mesh_data mesh = refined("open.ply", "o.ply", options);
        double area = 0;
        for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) area += area_vector(mesh, f)[2];
        EXPECT_NEAR(std::abs(area), exact, 4e-3);
        for (const Triple& p : mesh.points) EXPECT_NEAR(p[2], 0, 1e-12);
        for (const double x : {-2., 2.})
          for (const double y : {-2., 2.})
            if (exact > 12) {
              const auto is_at_corner = [&](const Triple& p) {
                return distance(p, {x, y, 0}) < 1e-9;
              };
              EXPECT_EQ(std::count_if(mesh.points.begin(), mesh.points.end(), is_at_corner), 1);
            }
      }
    }
}

// --- --check ---

TEST_F(Pn_subdivide_part, CheckKnowsRoundSurfaces)
{
  for (const std::string options :
       {"--levels 1", "--part --chord 0.2%", "--part --levels 1", "--sharp none --chord 2%"}) {
    SCOPED_TRACE(options);
    const std::string text = checked("shaft.stl", options + reported());
    const Json json = report()["check"];
    expect_part(text, " of the recognized surfaces (linear 0.");
    const bool is_smooth = contains(options, "none");
    // 2 pi 5/3 more: of the shaft, not of the prisms of 24 sides, which have 0.9886 of it
    EXPECT_NEAR(json.at("volume").get<double>(), 1, is_smooth ? 1 : 1e-2) << text;
    EXPECT_EQ(contains(text, "check: kept (linear "), !is_smooth) << text;
    if (is_smooth) continue;
    EXPECT_LT(json.at("largest_distance").get<double>(), 1e-5);
    EXPECT_LE(json.at("largest_distance").get<double>(),
              json.at("linear_largest_distance").get<double>());
    EXPECT_EQ(json.at("folded"), false);
    EXPECT_EQ(json.at("linear_folded"), false);
  }
}

TEST_F(Pn_subdivide_part, CheckProposesPartBesideTags)
{
  const std::string tagged = checked("shaft.stl", "--sharp angle:100");
  expect_part(tagged, ". It looks like a part: try --part\n");
  expect_no_part(checked("shaft.stl", "--sharp none"), "--part");
}

// A ball of 12 meridians and 5 parallels has 0.82 of the volume of its sphere, and is that again.
TEST_F(Pn_subdivide_part, CheckKnowsASphere)
{
  folder.write("ball.ply", ball_of(12, 6, on_sphere).ply());
  const std::string text = checked("ball.ply", "--levels 3 --normals sphere:0,0,0" + reported());
  expect_part(text, "check: kept (linear LOST)\n");
  const Json json = report()["check"];
  EXPECT_NEAR(json.at("volume").get<double>(), 1, 1e-2);
  EXPECT_LT(json.at("largest_distance").get<double>(), 1e-9);
  EXPECT_GT(json.at("linear_largest_distance").get<double>(), 0.05);
}

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// --sharp surfaces: parts that are written here, of known planes, cylinders and spheres.

#include "Part_files.h"
#include "Refined_files.h"

#include "io/mesh_io.h"

using namespace pn_subdivide;

namespace {

constexpr double pi = 3.14159265358979323846;
using Json = nlohmann::json;

// A bar along z whose section is a square of width 3 with quarters of circles of radius 1, in 6 steps, at its corners:
// they touch the planes beside them.
Part rounded_bar()
{
  std::vector<Triple> section;
  const double centers[4][2] = {{.5, .5}, {-.5, .5}, {-.5, -.5}, {.5, -.5}};
  for (int q = 0; q < 4; ++q)
    for (int i = 0; i <= 6; ++i) {
      const Triple p = on_circle(1, 90. * q + 15. * i, 0);
      section.push_back({centers[q][0] + p[0], centers[q][1] + p[1], 0});
    }
  return prism(section, 4);
}

// A sphere of radius 2, of 12 meridians and 6 parallels, all of whose points are moved about.
Part stone()
{
  return ball_of(12, 6, [](double t, double u) {
    const Triple p = on_sphere(t, u);
    const double r = 2 + .1 * std::sin(3 * p[0] + 5 * p[1]) + .1 * std::cos(4 * p[2] + 2 * p[0]);
    return sum({}, p, r);
  });
}

class Pn_subdivide_surfaces : public Refined_files
{
protected:
  void SetUp() override
  {
    // the thin plate is only a little wider than its hole, whose sides are parallel to those of the plate there: rounded,
    // the hole reaches through them
    const std::pair<const char*, Part> parts[] = {{"plate", drilled_plate()},
                                                  {"thin", drilled_plate(1, 1.99, 7.5)},
                                                  {"shaft", shaft()},
                                                  {"bar", rounded_bar()},
                                                  {"stone", stone()}};
    for (auto [name, part] : parts) {
      folder.write(std::string(name) + ".ply", part.ply());
      part.triangulate();
      folder.write(std::string(name) + "_3.ply", part.ply());
      folder.write(std::string(name) + ".stl", part.stl());
    }
  }

  std::string tags(const std::string& name) const
  {
    return " --write-tags '" + folder.file(name + ".selection.txt") + "' ";
  }
  std::vector<std::size_t> labels() const
  {
    std::istringstream in(content("labels.txt"));
    std::vector<std::size_t> result;
    for (std::size_t label = 0; in >> label;) result.push_back(label);
    return result;
  }
};

const std::vector<double>& surface_of(const Mesh_data& mesh)
{
  static const std::vector<double> none;
  const Column* const column = find_column(mesh.attributes.of_faces, "surface");
  EXPECT_NE(column, nullptr);
  if (column == nullptr) return none;
  EXPECT_EQ(column->type, Scalar_type::int32);
  EXPECT_EQ(column->values.size(), mesh.number_of_faces());
  return column->values;
}

// The vertices of the faces on each surface of the kind.
std::map<std::size_t, std::set<std::size_t>> vertices_on(const Mesh_data& mesh, const Json& report,
                                                         const std::string& kind)
{
  std::map<std::size_t, std::set<std::size_t>> result;
  const std::vector<double>& surface = surface_of(mesh);
  for (std::size_t f = 0; f < surface.size(); ++f) {
    const auto s = std::size_t(surface[f]);
    if (report["surfaces"].at(s)["kind"] != kind) continue;
    for (const auto v : mesh.face(f)) result[s].insert(v);
  }
  return result;
}

double off_axis(const Triple& p)
{
  return std::hypot(p[0], p[1]);
}

const std::vector<Triple> dart{{0, 0, 0}, {4, -2, 0}, {1, 0, 0}, {4, 2, 0}};

} // namespace

// --- what becomes of parts ---

TEST_F(Pn_subdivide_surfaces, AHoleIsRound)
{
  for (const char* const input : {"plate.ply", "plate_3.ply"}) {
    SCOPED_TRACE(input);
    const Mesh_data mesh = refined(input, "o.ply", "--sharp surfaces --levels 2" + reported());
    const Json json = report();
    const auto cylinders = vertices_on(mesh, json, "cylinder");
    ASSERT_EQ(cylinders.size(), 1u);
    EXPECT_NEAR(json["surfaces"][cylinders.begin()->first]["radius"].get<double>(), 1, 1e-9);
    const std::set<std::size_t>& vertices = cylinders.begin()->second;
    EXPECT_EQ(vertices.size(), 5u * 96u);
    for (const std::size_t v : vertices) EXPECT_NEAR(off_axis(mesh.points[v]), 1, 1e-6);
    EXPECT_EQ(vertices_on(mesh, json, "plane").size(), 6u);
  }
}

// Within the rounding of a file of floats, whose corners are not quite the same.
TEST_F(Pn_subdivide_surfaces, AnStlIsRoundAgain)
{
  const Mesh_data mesh = refined("shaft.stl", "o.ply", "--sharp surfaces --levels 2" + reported());
  const Json json = report();
  const auto cylinders = vertices_on(mesh, json, "cylinder");
  ASSERT_EQ(cylinders.size(), 2u);
  for (const auto& [s, vertices] : cylinders) {
    const double radius = off_axis(mesh.points[*vertices.begin()]) > 1.5 ? 2 : 1;
    EXPECT_NEAR(json["surfaces"][s]["radius"].get<double>(), radius, 1e-6);
    EXPECT_EQ(vertices.size(), 5u * 96u);
    for (const std::size_t v : vertices) EXPECT_NEAR(off_axis(mesh.points[v]), radius, 1e-6);
  }
  const auto planes = vertices_on(mesh, json, "plane");
  EXPECT_EQ(planes.size(), 3u);
  for (const auto& [s, vertices] : planes)
    for (const std::size_t v : vertices)
      EXPECT_NEAR(mesh.points[v][2], mesh.points[*vertices.begin()][2], 1e-6);
}

// Bodies that are inside out have the same surfaces, and are told of; cavities are not.
TEST_F(Pn_subdivide_surfaces, BodiesInsideOutAreTold)
{
  for (const bool is_turned : {false, true}) {
    Part part = shaft();
    part.add(shaft(), {10, 0, 0}, is_turned);
    Part block;
    block.add(rounded_bar(), {0, 0, 0}, false);
    for (Triple& p : block.points) p = {5 * p[0], 5 * p[1] + 20, 5 * p[2]};
    part.add(block, {0, 0, 0}, false);
    part.add(shaft(), {0, 20, 5}, true); // a cavity of the block
    const std::size_t first_face = shaft().faces.size();
    folder.write("bodies.ply", part.ply());
    const auto outcome = surface("bodies.ply", "o.ply", "--sharp surfaces" + reported());
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(contains(outcome.err, "1 body is inside out (first: at face " +
                                      std::to_string(first_face) +
                                      "); --repair turns it right side out"),
              is_turned)
      << outcome.err;
    EXPECT_EQ(contains(outcome.err, "inside out"), is_turned) << outcome.err;
    std::size_t cylinders = 0;
    const Json json = report();
    for (const Json& row : json["surfaces"]) cylinders += row["kind"] == "cylinder";
    EXPECT_EQ(cylinders, 3u * 2u + 4u);
    const auto repaired = surface("bodies.ply", "o.ply", "--sharp surfaces --repair");
    expect_no_part(repaired.err, "inside out");
    EXPECT_EQ(contains(repaired.err, "1 closed component turned right side out"), is_turned);
  }
}

// A file of six digits that has been scaled has all digits.
TEST_F(Pn_subdivide_surfaces, AScaledFileIsTold)
{
  for (const double scale : {1., 1. / 3}) {
    Part part = drilled_plate();
    for (Triple& p : part.points)
      for (double& x : p) x = scale * (std::round(1e4 * x) / 1e4);
    folder.write("scaled.ply", part.ply());
    const auto outcome = surface("scaled.ply", "o.ply", "--sharp surfaces");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(contains(outcome.err, "with --surface-tolerance"), scale < 1) << outcome.err;
  }
}

// Where planes touch cylinders, edges of 15 degrees part them.
TEST_F(Pn_subdivide_surfaces, TangentPlanesStayFlat)
{
  for (const char* const input : {"bar.ply", "bar_3.ply"}) {
    SCOPED_TRACE(input);
    const Mesh_data mesh = refined(input, "o.ply", "--sharp surfaces --levels 2" + reported());
    const Json json = report();
    EXPECT_EQ(vertices_on(mesh, json, "plane").size(), 6u);
    const auto cylinders = vertices_on(mesh, json, "cylinder");
    EXPECT_EQ(cylinders.size(), 4u);
    for (const auto& [s, vertices] : cylinders)
      for (const std::size_t v : vertices) {
        const Triple& p = mesh.points[v];
        EXPECT_NEAR(std::hypot(std::abs(p[0]) - .5, std::abs(p[1]) - .5), 1, 1e-6);
      }
    for (const auto& [s, vertices] : vertices_on(mesh, json, "plane")) {
      std::array<double, 3> low = mesh.points[*vertices.begin()], high = low;
      for (const std::size_t v : vertices)
        for (std::size_t k = 0; k < 3; ++k) {
          low[k] = (std::min)(low[k], mesh.points[v][k]);
          high[k] = (std::max)(high[k], mesh.points[v][k]);
        }
      double least = 1;
      for (std::size_t k = 0; k < 3; ++k) least = (std::min)(least, high[k] - low[k]);
      EXPECT_LT(least, 1e-9);
    }
  }
}

TEST_F(Pn_subdivide_surfaces, ChildrenHaveTheSurfaceOfTheirParents)
{
  for (const char* const encoding : {"", " --ascii"}) {
    const Mesh_data mesh =
      refined("shaft.ply", "o.ply", std::string("--sharp surfaces --levels 2") + encoding);
    std::map<double, std::set<std::string>> places; // of the faces of a surface
    const std::vector<double>& surface = surface_of(mesh);
    for (std::size_t f = 0; f < surface.size(); ++f) {
      double low = 10, high = -10, inmost = 10;
      for (const auto v : mesh.face(f)) {
        low = (std::min)(low, mesh.points[v][2]);
        high = (std::max)(high, mesh.points[v][2]);
        inmost = (std::min)(inmost, off_axis(mesh.points[v]));
      }
      char place[60];
      if (high - low < 1e-9)
        std::snprintf(place, sizeof place, "z = %.3f", high);
      else
        std::snprintf(place, sizeof place, "radius %.3f", inmost);
      places[surface[f]].insert(place);
    }
    std::set<std::string> all;
    for (const auto& [s, of_surface] : places) {
      EXPECT_EQ(of_surface.size(), 1u);
      all.insert(*of_surface.begin());
    }
    EXPECT_EQ(all, (std::set<std::string>{"z = 0.000", "z = 1.000", "z = 3.000", "radius 1.000",
                                          "radius 2.000"}));
  }
}

TEST_F(Pn_subdivide_surfaces, FilesWithoutPropertiesOfFacesAreAsBefore)
{
  expect_part(written("shaft.ply", "o.vtp", "--sharp surfaces --levels 1 --ascii"),
              "type=\"Int32\" Name=\"surface\"");
  for (const char* const output : {"o.obj", "o.off", "o.stl"}) {
    const Outcome outcome = done(surface("shaft.ply", output, "--sharp surfaces --levels 1"));
    expect_no_part(outcome.err, "not written");
  }
  // one of the user's with this name gives way
  folder.write("own.ply", with_own_surfaces(drilled_plate().ply(), "4"));
  const Outcome outcome = surface("own.ply", "o.ply", "--sharp surfaces --levels 1");
  expect_part(outcome.err, "gives way");
  for (const double s : surface_of(read_mesh(folder.file("o.ply")))) EXPECT_LT(s, 7);
}

// --- what is said of them ---

TEST_F(Pn_subdivide_surfaces, TheLabelsAreThoseOfTheReport)
{
  for (const std::string levels : {"0", "2"}) {
    written("shaft.ply", "o.obj",
            "--sharp surfaces --levels " + levels + " --surface-labels '" +
              folder.file("labels.txt") + "'" + reported());
    const Json json = report();
    const std::vector<std::size_t> all = labels();
    const Part part = shaft();
    ASSERT_EQ(all.size(), part.faces.size());
    std::map<std::size_t, std::size_t> faces;
    for (std::size_t f = 0; f < all.size(); ++f) {
      ++faces[all[f]];
      const bool is_plane = f % 3 == 1 || f >= 72;
      EXPECT_EQ(json["surfaces"].at(all[f])["kind"], is_plane ? "plane" : "cylinder");
      if (f >= 72) continue;
      EXPECT_EQ(all[f], all[f % 3]);
    }
    EXPECT_EQ(json["surfaces"].size(), 5u);
    for (const auto& [s, number] : faces) EXPECT_EQ(json["surfaces"][s]["faces"], number);
  }
}

// The middle of a chord of a circle of radius R is R (1 - cos) off, with half of its angle; two rounds divide this by 4.
TEST_F(Pn_subdivide_surfaces, TheReportHasParametersAndDeviations)
{
  const Outcome outcome =
    done(run(words("shaft.ply", "o.ply") + "--sharp surfaces --levels 2" + reported()));
  expect_part(outcome.err, "3 planes of 26 faces, 2 cylinders of 48 faces");
  expect_part(outcome.err, "; 96 crease edges");
  const Json json = report();
  std::set<double> radii;
  for (const Json& s : json["surfaces"]) {
    if (s["kind"] != "cylinder") {
      EXPECT_EQ(s["kind"], "plane");
      EXPECT_NEAR(std::abs(s["direction"][2].get<double>()), 1, 1e-9);
      EXPECT_LT(s["deviation_after"].get<double>(), 1e-9);
      continue;
    }
    const double r = s["radius"].get<double>();
    radii.insert(std::round(r * 1e6) / 1e6);
    EXPECT_NEAR(std::abs(s["direction"][2].get<double>()), 1, 1e-9);
    EXPECT_NEAR(s["point"][0].get<double>(), 0, 1e-9);
    EXPECT_NEAR(s["widest_step"].get<double>(), pi / 12, 1e-9);
    EXPECT_LT(s["residual"].get<double>(), 1e-9);
    EXPECT_NEAR(s["deviation_before"].get<double>(), r * (1 - std::cos(pi / 24)), 1e-9);
    EXPECT_NEAR(s["deviation_after"].get<double>(), r * (1 - std::cos(pi / 96)), 1e-9);
    EXPECT_LT(s["deviation_of_vertices"].get<double>(), 1e-9);
  }
  EXPECT_EQ(radii, (std::set<double>{1, 2}));
}

TEST_F(Pn_subdivide_surfaces, WhatIsNoPartIsSaid)
{
  const Outcome outcome = done(surface("stone.ply", "o.ply", "--sharp surfaces --levels 1"));
  expect_part(outcome.err, "no surface is recognized");
  EXPECT_EQ(surface("stone.ply", "o.ply", "--sharp surfaces --strict").code, 4);
  // a stone above a small plate
  Part part = stone();
  const Part plate = drilled_plate();
  for (const auto& face : plate.faces) {
    std::vector<Triple> corners;
    for (const std::size_t v : face) corners.push_back(sum({0, 0, -5}, plate.points[v], .2));
    part.add(corners);
  }
  folder.write("both.ply", part.ply());
  const Outcome both = done(surface("both.ply", "o.ply", "--sharp surfaces --levels 1"));
  expect_part(both.err, "% of the area is on no recognized surface");
  EXPECT_EQ(surface("plate.ply", "o.obj", "--sharp surfaces").err, "");
}

// --- tags and normals for others ---

TEST_F(Pn_subdivide_surfaces, TagsAreTheSameEveryTime)
{
  const std::string control = "--sharp surfaces --levels 0 --output-normals control";
  written("bar.ply", "a.ply", control + tags("a"));
  written("bar.ply", "b.obj", control + tags("b"));
  written("a.ply", "c.ply", control + tags("c"));
  const std::string selection = content("a.selection.txt");
  EXPECT_EQ(content("b.selection.txt"), selection);
  EXPECT_EQ(content("c.selection.txt"), selection);
  std::istringstream edges(selection.substr(selection.rfind('\n', selection.size() - 2)));
  std::size_t numbers = 0;
  for (int v = 0; edges >> v;) ++numbers;
  // around both ends, and where a plane touches a quarter of a circle
  EXPECT_EQ(numbers, 2u * (2 * 28 + 8));
}

// With these tags and normals another call does what this one does.
TEST_F(Pn_subdivide_surfaces, TagsAndNormalsSayAll)
{
  for (const std::string input : {"bar.ply", "shaft_3.ply"})
    for (const auto& [format, normals] :
         {std::pair("c.ply", "both"), std::pair("c.obj", "control")}) {
      SCOPED_TRACE(input + format);
      const Mesh_data expected = refined(input, "o.ply", "--sharp surfaces --levels 2");
      written(input, format,
              std::string("--sharp surfaces --levels 0 --output-normals ") + normals);
      const Mesh_data mesh = refined(format, "p.ply", "--levels 2");
      // those between planes' rims only
      for (const Triple& p : expected.points) EXPECT_LT(distance_to_nearest(p, mesh.points), 1e-12);
    }
}

// With `auto` the surfaces know better than the file, with `file` they know less.
TEST_F(Pn_subdivide_surfaces, NormalsOfTheFileAreTakenWhereAskedFor)
{
  const Part part = drilled_plate(2);
  std::vector<Triple> normals;
  for (const Triple& p : part.points) normals.push_back(unit({p[0], p[1], p[2] + .3}));
  folder.write("plain.ply", part.ply());
  folder.write("normals.ply", part.ply(normals));
  const Mesh_data plain = refined("plain.ply", "o.ply", "--sharp surfaces --levels 2");
  const Mesh_data automatic = refined("normals.ply", "o.ply", "--sharp surfaces --levels 2");
  EXPECT_EQ(plain.points, automatic.points);
  // vertices between creases have several normals, for which the one of the file will not do
  const Mesh_data control = refined(
    "normals.ply", "o.obj", "--sharp surfaces --levels 0 --output-normals control --normals file");
  ASSERT_EQ(control.corner_normals.size(), control.number_of_corners());
  for (std::size_t f = 0; f < control.number_of_faces(); ++f)
    for (std::size_t i = 0; i < 4; ++i) {
      const auto v = control.face(f).begin()[i];
      const Triple &n = control.corner_normals[control.first_corner(f) + i], &m = normals[v],
                   &p = control.points[v];
      const bool is_inside = p[2] == .5 && std::abs(std::abs(p[0]) - std::abs(p[1])) > 1e-9;
      if (is_inside || off_axis(p) < 1.1)
        EXPECT_EQ(distance(n, m) < 1e-12, p[2] == .5);
      else
        EXPECT_LT(std::abs(n[2]) * (1 - std::abs(n[2])), 1e-9); // a plane's
    }
  expect_one_line(surface("plate.ply", "o.ply", "--sharp surfaces --normals file"), 1,
                  "--normals file");
}

TEST_F(Pn_subdivide_surfaces, TheLinearTwinHasTheTags)
{
  const Mesh_data mesh = refined("shaft.ply", "o.ply", "--sharp surfaces --linear" + tags("a"));
  EXPECT_FALSE(mesh.has_normals());
  for (const Triple& p : mesh.points)
    EXPECT_TRUE(std::abs(p[2]) < 1e-12 || std::abs(p[2] - 1) < 1e-12 ||
                std::abs(p[2] - 3) < 1e-12 || off_axis(p) < 2);
  EXPECT_FALSE(content("a.selection.txt").empty());
}

// How much larger the faces of planes are than the planes.
double folded_area(const Mesh_data& mesh, const Json& report)
{
  std::map<std::size_t, std::pair<double, Triple>> areas;
  const std::vector<double>& surface = surface_of(mesh);
  for (std::size_t f = 0; f < surface.size(); ++f) {
    const auto s = std::size_t(surface[f]);
    if (report["surfaces"].at(s)["kind"] != "plane") continue;
    auto& [size, vector] = areas[s];
    size += length(area_vector(mesh, f));
    vector = sum(vector, area_vector(mesh, f));
  }
  double result = 0;
  for (const auto& [s, area] : areas) result += area.first - length(area.second);
  return result;
}

// Masks fold the planes of a prism over a dart at its notch, and those beside round holes where they are triangles as long as
// the plate. Neither rims nor control data do.
TEST_F(Pn_subdivide_surfaces, PlanesDoNotFold)
{
  Part part = prism(dart, 1);
  std::rotate(part.faces[0].begin(), part.faces[0].begin() + 1,
              part.faces[0].end()); // to the notch
  folder.write("dart.off", triangulated(part).off());
  for (const std::string input : {"dart.off", "plate_3.ply", "bar_3.ply"})
    for (const std::string& more : {std::string(), tags("t"), std::string(" --linear")}) {
      SCOPED_TRACE(input + more);
      const Outcome outcome =
        done(surface(input, "o.ply", "--sharp surfaces --levels 2" + more + reported()));
      expect_no_part(outcome.err, "folded");
      expect_no_part(outcome.err, "itself");
      EXPECT_EQ(report()["high_faces"], Json::array());
      const Mesh_data mesh = read_mesh(folder.file("o.ply"));
      EXPECT_LT(folded_area(mesh, report()), 1e-9);
      const bool has_control_data = contains(more, "tags");
      EXPECT_EQ(mesh.number_of_faces() == 12u * 16, has_control_data && input == "dart.off");
    }
}

// A plate of a dart as one face, whose middle is outside.
TEST_F(Pn_subdivide_surfaces, FoldsAreTold)
{
  folder.write("dart.off", prism(dart, 1).off());
  for (const bool has_control_data : {false, true}) {
    const Outcome outcome = done(
      surface("dart.off", "o.ply",
              "--sharp surfaces --levels 1" + (has_control_data ? tags("t") : "") + reported()));
    EXPECT_EQ(contains(outcome.err, "folded over on 2 faces of recognized surfaces: 0, 1"),
              has_control_data)
      << outcome.err;
    EXPECT_EQ(report()["high_faces"], has_control_data ? Json({0, 1}) : Json::array());
  }
}

// --- planes from their rims ---

std::size_t vertices_with_faces(const Mesh_data& mesh)
{
  std::set<std::size_t> all;
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    for (const auto v : mesh.face(f)) all.insert(v);
  return all.size();
}

// A polygon of n vertices with h holes is n - 2 + 2 h triangles.
TEST_F(Pn_subdivide_surfaces, PlanesAreTrianglesBetweenTheirRims)
{
  for (const std::string input : {"plate.ply", "plate_3.ply"})
    for (const std::string more : {"", " --limit", " --linear"}) {
      SCOPED_TRACE(input + more);
      const std::string options = "--sharp surfaces --levels 2" + more + reported();
      const Mesh_data all = refined(input, "a.ply", options);
      const Mesh_data mesh = refined(input, "o.ply", options + " --planes rims");
      EXPECT_TRUE(is_watertight(mesh));
      EXPECT_NEAR(volume(mesh), volume(all), 1e-9);
      EXPECT_EQ(vertices_with_faces(mesh), mesh.points.size());
      const Json json = report();
      const std::vector<double>& surface = surface_of(mesh);
      std::map<std::size_t, std::size_t> faces, sums;
      std::size_t of_cylinder = 0;
      for (std::size_t f = 0; f < surface.size(); ++f) {
        const auto s = std::size_t(surface[f]);
        if (json["surfaces"].at(s)["kind"] == "cylinder") {
          ++of_cylinder;
          continue;
        }
        ASSERT_EQ(mesh.face(f).size(), 3);
        ++faces[s];
        // all of the triangle is in the plane
        const Triple n = json["surfaces"][s]["direction"], p = json["surfaces"][s]["point"];
        for (const auto v : mesh.face(f))
          EXPECT_NEAR(dot(n, difference(mesh.points[v], p)), 0, 1e-9);
      }
      EXPECT_EQ(of_cylinder, (input == "plate.ply" ? 1u : 2u) * 24 * 16);
      for (const auto& [s, number] : faces) ++sums[number];
      EXPECT_EQ(sums, (std::map<std::size_t, std::size_t>{{54, 4}, {192, 2}}));
    }
}

// What is said of vertices, corners and faces follows, in all formats.
TEST_F(Pn_subdivide_surfaces, PlanesFromRimsKeepWhatIsSaidOfThem)
{
  const std::string options = "--sharp surfaces --planes rims --levels 2 ";
  const Mesh_data obj = refined("plate.ply", "o.obj", options);
  ASSERT_EQ(obj.corner_normals.size(), obj.number_of_corners());
  for (std::size_t f = 0; f < obj.number_of_faces(); ++f)
    for (std::size_t i = 0; i < std::size_t(obj.face(f).size()); ++i) {
      const Triple &n = obj.corner_normals[obj.first_corner(f) + i],
                   &p = obj.points[obj.face(f).begin()[i]];
      bool is_flat = true; // the face in a plane z = 0 or 1
      for (const auto v : obj.face(f)) is_flat = is_flat && obj.points[v][2] == p[2];
      EXPECT_NEAR(std::abs(n[2]), is_flat ? 1 : 0, 1e-9);
    }
  const Mesh_data stl = refined("plate.ply", "o.stl", options);
  EXPECT_TRUE(is_watertight(stl));
  EXPECT_EQ(stl.number_of_faces(), 2u * 192 + 4u * 54 + 2u * 24 * 16);
  const std::string vtp = written("plate.ply", "o.vtp", options + "--curvature mean --ascii");
  expect_part(vtp, "NumberOfPoints=\"" + std::to_string(obj.points.size()) + "\"");
  EXPECT_TRUE(
    is_watertight(refined("shaft.ply", "o.ply", "--sharp surfaces --planes rims --levels 0")));
}

TEST_F(Pn_subdivide_surfaces, PlanesWhoseRimsCrossKeepTheirFaces)
{
  const std::string options = "--sharp surfaces --levels 2 ";
  const Outcome outcome = done(surface("thin.ply", "o.ply", options));
  expect_part(outcome.err, "2 planes keep their faces: their rims cross");
  const Mesh_data mesh = read_mesh(folder.file("o.ply"));
  EXPECT_TRUE(is_watertight(mesh));
  std::size_t quads_in_planes = 0;
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
    bool is_flat = true;
    for (const auto v : mesh.face(f))
      is_flat = is_flat && mesh.points[v][2] == mesh.points[*mesh.face(f).begin()][2];
    quads_in_planes += is_flat && mesh.face(f).size() == 4;
  }
  EXPECT_EQ(quads_in_planes, 2u * 24 * 16);
  expect_no_part(surface("thin.ply", "o.ply", "--sharp surfaces --planes rims --levels 0").err,
                 "keep");
  for (const std::string& more : {std::string(), tags("t")})
    expect_part(surface("thin.ply", "o.ply", options + more).err,
                "2 planes intersect themselves: their rims cross");
}

// --- options ---

TEST_F(Pn_subdivide_surfaces, TheOptionsOfRecognition)
{
  // a prism of 6 sides is round if the user says so
  folder.write("nut.ply", regular_prism(6, 1).ply());
  const auto cylinders = [&](const std::string& input, const std::string& options) {
    written(input, "o.ply", "--sharp surfaces " + options + reported());
    const Json json = report();
    return std::count_if(json["surfaces"].begin(), json["surfaces"].end(),
                         [](const Json& s) { return s["kind"] == "cylinder"; });
  };
  EXPECT_EQ(cylinders("nut.ply", ""), 0);
  EXPECT_EQ(cylinders("nut.ply", "--min-facets 6"), 1);

  // a hole whose points are 1e-4 off
  Part part = drilled_plate();
  for (std::size_t v = 0; v < part.points.size(); ++v) {
    Triple& p = part.points[v];
    const double factor = 1 + (v % 3 == 0 ? 1e-4 : v % 3 == 1 ? -1e-4 : 0);
    if (off_axis(p) < 1.1) p = {p[0] * factor, p[1] * factor, p[2]};
  }
  folder.write("off.ply", part.ply());
  EXPECT_EQ(cylinders("off.ply", ""), 0);
  EXPECT_EQ(cylinders("off.ply", "--surface-tolerance 3e-4"), 1);

  // where nothing is recognized the angle counts
  const auto tagged = [&](const std::string& options) {
    written("stone.ply", "o.obj", "--sharp surfaces " + options + tags("s"));
    return content("s.selection.txt").size();
  };
  EXPECT_LT(tagged("--sharp-angle 170"), 5u);
  EXPECT_GT(tagged("--sharp-angle 5"), tagged("--sharp-angle 30"));
}

TEST_F(Pn_subdivide_surfaces, AFileOfThisName)
{
  folder.write("surfaces", "\n\n0 1\n");
  const std::string before = "cd '" + folder.file(".") + "' && ";
  const Outcome file = done(run("plate.ply o.ply --sharp ./surfaces", before));
  expect_part(file.err, ", 1 sharp edge,");
  expect_part(run("plate.ply o.ply --sharp surfaces", before).err, "1 cylinder of");
}

TEST_F(Pn_subdivide_surfaces, WhatExcludesEachOther)
{
  const auto refused = [&](const std::string& options, const std::vector<std::string>& parts) {
    expect_refusal("plate_3.ply", "o.ply", options, parts);
  };
  const std::string sharp = "--sharp surfaces ";
  refused(sharp + "--sharpness 2", {"--sharpness", "--sharp surfaces"});
  refused(sharp + "--interpolate slide", {"--interpolate", "--sharp surfaces"});
  refused(sharp + "--pieces 2", {"--pieces", "--sharp surfaces"});
  refused(sharp + "--memory 1G", {"--memory", "--sharp surfaces"});
  for (const std::string scheme : {"sqrt3", "butterfly"})
    refused(sharp + "--scheme " + scheme, {scheme, "--sharp surfaces"});
  const std::string labels = "--surface-labels '" + folder.file("labels.txt") + "'";
  const std::string options[] = {"--min-facets 9", "--surface-tolerance 0.1", "--sharp-angle 40",
                                 labels};
  for (const std::string& option : options)
    for (const char* const other : {"", " --sharp angle:30", " --sharp none"})
      refused(option + other, {option.substr(0, option.find(' ')), "--sharp surfaces"});
  refused(sharp + "--min-facets 2", {"--min-facets 2"});
  refused(sharp + "--min-facets 8.5", {"--min-facets 8.5"});
  refused(sharp + "--min-facets many", {"--min-facets"});
  refused(sharp + "--surface-tolerance 0", {"--surface-tolerance 0"});
  refused(sharp + "--surface-tolerance nan", {"--surface-tolerance"});
  refused(sharp + "--sharp-angle 181", {"--sharp-angle 181"});
  refused(sharp + "--sharp-angle -1", {"--sharp-angle -1"});
  refused(sharp + "--surface-labels -", {"--surface-labels"});
  refused(sharp + "--surface-labels '" + folder.file("o.ply") + "'", {"--surface-labels"});
  const std::vector<std::string> others = {"--output-normals control", "--output-normals both",
                                           "--write-tags '" + folder.file("t.selection.txt") + "'"};
  for (const std::string& other : others)
    refused(sharp + "--planes rims " + other, {"--planes", other.substr(0, other.find(' '))});
  refused("--planes rims", {"--planes", "--sharp surfaces"});
  refused("--planes rims --sharp angle:30", {"--planes", "--sharp surfaces"});
  refused(sharp + "--planes all", {"--planes 'all'"});
  refused(sharp + "--planes rims --pieces 2", {"--pieces"});
  refused(sharp + "--chord 1 --levels 3", {"--chord", "--levels 3"});
  refused("--levels automatic", {"--levels"});
  expect_one_line(surface("plate.ply", "o.ply", sharp + "--surface-labels /no/such/labels"), 1,
                  "/no/such");
}

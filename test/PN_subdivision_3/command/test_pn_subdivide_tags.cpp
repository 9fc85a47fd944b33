// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// What is sharp in the result: written to PLY, OBJ and selections, read again, and carried from call to call.

#include "Extent.h"
#include "Part_files.h"
#include "Refined_files.h"

#include "io/mesh_io.h"

#include <limits>

using namespace pn_subdivide;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::string obj_box(bool is_triangles = false, bool is_open = false)
{
  return uneven_box(is_triangles, is_open).obj();
}

// With a face between the points that is a mesh of the elements that the tags say.
std::string ply_box(const std::vector<Edge_tag>& edges, const std::vector<double>& vertices,
                    bool is_triangles = false)
{
  const auto of_vertices = vertices.empty() ? std::vector<double>(8) : vertices;
  return with_edges(uneven_box(is_triangles).ply({}, {{"sharpness", of_vertices}}), edges);
}

const std::vector<std::array<int, 2>> outline = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6},
                                                 {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};
// around the bottom and the top
const std::vector<std::array<int, 2>> rims = {{0, 1}, {1, 2}, {2, 3}, {3, 0},
                                              {4, 5}, {5, 6}, {6, 7}, {7, 4}};

std::string selection(const std::vector<std::array<int, 2>>& edges,
                      const std::string& vertices = "")
{
  std::string s = vertices + "\n\n";
  for (const auto& e : edges) s += std::to_string(e[0]) + " " + std::to_string(e[1]) + " ";
  return s + "\n";
}

const std::vector<std::string> schemes = {"catmull-clark", "loop", "modified-catmull-clark",
                                          "modified-loop"};

class Pn_subdivide_tags : public Refined_files
{
protected:
  void SetUp() override
  {
    folder.write("quads.obj", obj_box());
    folder.write("triangles.obj", obj_box(true));
    folder.write("open_quads.obj", obj_box(false, true));
    folder.write("open_triangles.obj", obj_box(true, true));
    folder.write("all.selection.txt", selection(outline));
    folder.write("rims.selection.txt", selection(rims));
    folder.write("corner.selection.txt", selection({{0, 1}, {1, 2}}, "6 4"));
  }

  std::string sharp(const std::string& name) const
  {
    return " --sharp '" + folder.file(name + ".selection.txt") + "' ";
  }
};

// Is it on one of the edges of the box, and which?
int edge_of_box(const Triple& p, const Triple& q)
{
  const std::vector<Triple> box_points = uneven_box().points;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Triple &a = box_points[std::size_t(outline[i][0])],
                 &b = box_points[std::size_t(outline[i][1])];
    bool is_on = true;
    for (std::size_t k = 0; k < 3; ++k)
      is_on = is_on && (a[k] != b[k] || (p[k] == a[k] && q[k] == a[k]));
    if (is_on) return int(i);
  }
  return -1;
}

} // namespace

// --- what is written ---

// All edges of the box are sharp, and straight: their parts are where they are.
TEST_F(Pn_subdivide_tags, PlyHasTheEdgesWithWhatIsLeftOfTheirSharpness)
{
  const std::pair<const char*, double> states[] = {
    {"inf", infinity}, {"3", 1}, {"2.5", 0.5}, {"2", 0}, {"1", 0}};
  for (const std::string& scheme : schemes)
    for (const auto& [sharpness, left] : states)
      for (const std::string choice : {"control", "both"})
        for (const char* const encoding : {"", " --ascii"}) {
          SCOPED_TRACE(scheme + sharpness + choice + encoding);
          const Mesh_data mesh =
            refined(takes_triangles(scheme) ? "triangles.obj" : "quads.obj", "o.ply",
                    "--levels 2 --scheme " + scheme + sharp("all") + " --sharpness " + sharpness +
                      " --output-normals " + choice + encoding);
          EXPECT_TRUE(mesh.attributes.of_vertices.empty());
          EXPECT_TRUE(mesh.dropped.empty());
          std::vector<int> parts(outline.size(), 0);
          for (const Crease_tags::Edge& edge : mesh.tags.edges) {
            EXPECT_EQ(edge.sharpness, left);
            const Triple &p = mesh.points[edge.ends[0]], &q = mesh.points[edge.ends[1]];
            const int e = edge_of_box(p, q);
            ASSERT_GE(e, 0);
            ++parts[std::size_t(e)];
            const double length = std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]);
            for (std::size_t k = 0; k < 3; ++k) {
              EXPECT_NEAR(edge.tangents[0][k], (q[k] - p[k]) / length, 1e-14);
              EXPECT_NEAR(edge.tangents[1][k], (p[k] - q[k]) / length, 1e-14);
            }
          }
          EXPECT_EQ(parts, std::vector<int>(outline.size(), left > 0 ? 4 : 0));
          EXPECT_TRUE(mesh.tags.vertices.empty());
        }
}

TEST_F(Pn_subdivide_tags, PlyHasTheCorners)
{
  const std::string text =
    written("quads.obj", "o.ply", "--ascii --levels 1 --output-normals control" + sharp("corner"));
  expect_part(
    text, "property double nz\nproperty double roundness\nproperty double sharpness\nelement face");
  expect_part(text, "element edge 4\nproperty int vertex1\nproperty int vertex2\n"
                    "property double sharpness\nproperty double t1x\n"
                    "property double t1y\nproperty double t1z\nproperty double t2x\n"
                    "property double t2y\nproperty double t2z\n");
  const Mesh_data mesh = read_mesh(folder.file("o.ply"));
  ASSERT_EQ(mesh.tags.vertices.size(), mesh.points.size());
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    EXPECT_EQ(mesh.tags.vertices[v], v == 4 || v == 6 ? infinity : 0);
}

TEST_F(Pn_subdivide_tags, ObjHasTheLinesOfOpenSubdiv)
{
  for (const auto& [sharpness, expected] :
       {std::pair("inf", " 10\n"), std::pair("3", " 2\n"), std::pair("2.25", " 1.25\n")}) {
    const std::string text =
      written("quads.obj", "o.obj",
              "--levels 1 --output-normals control" + sharp("all") + "--sharpness " + sharpness);
    EXPECT_EQ(number_of(text, "\nt crease 2/1/0 "), 24u);
    EXPECT_EQ(number_of(text, expected), 24u);
    const Mesh_data mesh = read_mesh(folder.file("o.obj"));
    for (const Crease_tags::Edge& edge : mesh.tags.edges)
      EXPECT_GE(edge_of_box(mesh.points[edge.ends[0]], mesh.points[edge.ends[1]]), 0);
  }
  const std::string text =
    written("quads.obj", "o.obj", "--levels 1 --output-normals control" + sharp("corner"));
  expect_part(text, "\nt corner 1/1/0 4 10\nt corner 1/1/0 6 10\n");
  EXPECT_EQ(number_of(text, "\nt "), 6u);
}

TEST_F(Pn_subdivide_tags, WithoutControlNormalsFilesArePlain)
{
  for (const std::string choice : {"", " --output-normals surface", " --output-normals none"})
    for (const char* const levels : {"--levels 0", "--levels 1"})
      for (const char* const output : {"o.ply", "o.obj"}) {
        const std::string text =
          written("quads.obj", output, levels + choice + sharp("corner") + " --ascii");
        expect_no_part(text, "edge ");
        expect_no_part(text, "sharpness");
        expect_no_part(text, "\nt ");
      }
}

TEST_F(Pn_subdivide_tags, ASelectionOfTheResultGoesWithEveryFormat)
{
  for (const char* const output : {"o.ply", "o.obj", "o.off", "o.stl", "o.vtp"})
    for (const char* const more : {"", " --linear", " --output-normals none"}) {
      const std::string tags = folder.file("tags.selection.txt");
      written("quads.obj", output,
              "--levels 1" + sharp("corner") + more + " --write-tags '" + tags + "'");
      // vertices 4 and 6; the two halves of two edges, with vertices of theirs, which come behind the old ones
      std::istringstream in(Temporary_folder::content(tags));
      std::string vertices, faces, edges;
      std::getline(in, vertices);
      std::getline(in, faces);
      std::getline(in, edges);
      EXPECT_EQ(vertices, "4 6");
      EXPECT_EQ(faces, "");
      std::istringstream numbers(edges);
      std::vector<int> ends;
      for (int v = 0; numbers >> v;) ends.push_back(v);
      ASSERT_EQ(ends.size(), 8u);
      for (const int old : {0, 2}) EXPECT_EQ(std::count(ends.begin(), ends.end(), old), 1);
      EXPECT_EQ(std::count(ends.begin(), ends.end(), 1), 2);
      EXPECT_EQ(std::count_if(ends.begin(), ends.end(), [](int v) { return v >= 8; }), 4);
    }
  // without creases it is an empty one
  written("quads.obj", "o.ply", "--write-tags '" + folder.file("tags.selection.txt") + "'");
  EXPECT_EQ(content("tags.selection.txt"), "\n\n\n");
}

TEST_F(Pn_subdivide_tags, ASelectionIsReadAgain)
{
  for (const std::string& scheme : schemes) {
    const std::string input = takes_triangles(scheme) ? "triangles.obj" : "quads.obj";
    const std::string tags = folder.file("tags.selection.txt");
    const std::string options = "--linear --scheme " + scheme;
    const Mesh_data two = refined(input, "two.ply", options + sharp("corner") + " --levels 2");
    written(input, "one.ply",
            options + sharp("corner") + " --levels 1 --write-tags '" + tags + "'");
    Mesh_data again =
      refined("one.ply", "again.ply", options + " --levels 1 --sharp '" + tags + "'");
    ASSERT_EQ(again.points.size(), two.points.size());
    std::vector<Triple> expected = two.points;
    std::vector<Triple>& points = again.points;
    for (std::vector<Triple>* all : {&expected, &points}) {
      for (Triple& p : *all)
        for (double& x : p)
          x = std::round(x * 1e10) / 1e10 + 0.; // numbers and last bits may differ
      std::sort(all->begin(), all->end());
    }
    EXPECT_EQ(points, expected) << scheme;
  }
}

TEST_F(Pn_subdivide_tags, WhatIsNotWrittenIsSaid)
{
  const std::string control = "--levels 1 --output-normals control" + sharp("rims");
  for (const char* const output : {"o.off", "o.vtp"})
    expect_part(surface("quads.obj", output, control).err, "--write-tags");
  for (const char* const output : {"o.ply", "o.obj"})
    expect_no_part(surface("quads.obj", output, control).err, "--write-tags");
  const std::string tags = " --write-tags '" + folder.file("tags.selection.txt") + "'";
  expect_no_part(surface("quads.obj", "o.off", control + tags).err, "what is sharp");
  expect_part(
    surface("quads.obj", "o.obj", "--levels 1 --sharpness 2.5" + sharp("rims") + tags).err,
    "16 edges are sharp for some rounds only");
  expect_no_part(surface("quads.obj", "o.obj", "--levels 1" + sharp("rims") + tags).err,
                 "for some rounds only");
}

// --- what is read ---

TEST_F(Pn_subdivide_tags, TagsOfAFileAreAsASelection)
{
  for (const std::string& scheme : schemes)
    for (const std::string sharpness : {"inf", "1", "2.5", "0.5"}) {
      const bool is_triangles = takes_triangles(scheme);
      const std::string input = is_triangles ? "triangles.obj" : "quads.obj";
      const std::string options = "--levels 2 --scheme " + scheme;
      const std::string expected =
        written(input, "expected.obj", options + sharp("rims") + "--sharpness " + sharpness);
      std::string obj = obj_box(is_triangles);
      std::vector<Edge_tag> tags;
      const double s = sharpness == "inf" ? infinity : std::stod(sharpness);
      for (const auto& e : rims) {
        // as OpenSubdiv has them: either way round, and 10 is for ever
        obj += "t crease 2/1/0 " + std::to_string(e[1]) + " " + std::to_string(e[0]) + " " +
               (sharpness == "inf" ? "10" : sharpness) + "\n";
        tags.push_back({e, s});
      }
      folder.write("tagged.obj", obj);
      folder.write("tagged.ply", ply_box(tags, {}, is_triangles));
      for (const char* const tagged : {"tagged.obj", "tagged.ply"})
        for (const char* const source : {"", " --sharp auto", " --sharp file"})
          EXPECT_EQ(written(tagged, "o.obj", options + source), expected)
            << scheme << sharpness << tagged << source;
    }
}

TEST_F(Pn_subdivide_tags, CornersOfAFileAreAsThoseOfASelection)
{
  folder.write("v.selection.txt", "4 6\n\n\n");
  const std::string expected = written("quads.obj", "e.obj", "--levels 2" + sharp("v"));
  folder.write("tagged.obj", obj_box() + "t corner 1/1/0 4 10\nt corner 1/1/0 6 11.5\n");
  folder.write("tagged.ply", ply_box({}, {0, 0, 0, 0, infinity, 0, infinity, 0}));
  for (const char* const tagged : {"tagged.obj", "tagged.ply"})
    EXPECT_EQ(written(tagged, "o.obj", "--levels 2"), expected) << tagged;
}

// Chains of edges with one sharpness, or with one each.
TEST_F(Pn_subdivide_tags, ObjTagsOfSeveralEdges)
{
  folder.write("a.obj", obj_box() + "t crease 4/1/0 0 1 2 3 2.5\nt crease 3/2/0 4 5 6 1 10\n"
                                    "t interpolateboundary 1/0/0 1\n");
  const Mesh_data mesh = read_mesh(folder.file("a.obj"));
  ASSERT_EQ(mesh.tags.edges.size(), 5u);
  const double sharpness[] = {2.5, 2.5, 2.5, 1, infinity};
  const std::uint32_t firsts[] = {0, 1, 2, 4, 5};
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(mesh.tags.edges[i].sharpness, sharpness[i]);
    EXPECT_EQ(mesh.tags.edges[i].ends, (std::array<std::uint32_t, 2>{firsts[i], firsts[i] + 1}));
  }
  EXPECT_EQ(mesh.dropped, std::vector<std::string>{"'t interpolateboundary'"});
}

TEST_F(Pn_subdivide_tags, EachEdgeHasItsOwnSharpnessUnlessOneIsGiven)
{
  std::vector<Edge_tag> tags;
  for (const auto& e : outline) tags.push_back({e, e[0] < 4 && e[1] < 4 ? 1 : 2.5});
  folder.write("mixed.ply", ply_box(tags, {}));
  const std::string options = "--levels 1 --output-normals control";
  const Mesh_data mesh = refined("mixed.ply", "o.ply", options);
  ASSERT_EQ(mesh.tags.edges.size(), 16u); // those of the bottom have had their round
  for (const Crease_tags::Edge& edge : mesh.tags.edges) {
    EXPECT_EQ(edge.sharpness, 1.5);
    const Triple &p = mesh.points[edge.ends[0]], &q = mesh.points[edge.ends[1]];
    EXPECT_FALSE(p[2] == -3 && q[2] == -3);
  }
  const Mesh_data given = refined("mixed.ply", "o.ply", options + " --sharpness 5");
  ASSERT_EQ(given.tags.edges.size(), 24u);
  for (const Crease_tags::Edge& edge : given.tags.edges) EXPECT_EQ(edge.sharpness, 4);
  expect_part(Command_test::surface("mixed.ply", "o.ply", "--levels 1").err,
              "12 sharp edges of sharpness 1 to 2.5");
}

TEST_F(Pn_subdivide_tags, OtherSourcesLeaveTheTagsOut)
{
  folder.write("tagged.obj", obj_box() + "t crease 2/1/0 0 1 10\n");
  EXPECT_EQ(written("tagged.obj", "a.obj", "--sharp none"),
            written("quads.obj", "b.obj", "--sharp none"));
  EXPECT_EQ(written("tagged.obj", "a.obj", sharp("rims")),
            written("quads.obj", "b.obj", sharp("rims")));
  EXPECT_EQ(written("tagged.obj", "a.obj", "--sharp angle:60"),
            written("quads.obj", "b.obj", "--sharp angle:60"));
  // without rules for creases
  const Outcome outcome = done(surface("tagged.obj", "a.obj", "--scheme kobbelt"));
  expect_part(outcome.err, "kobbelt has no rules for creases");
}

// A box whose faces have normals of their own has creases by these, unless tags say otherwise.
TEST_F(Pn_subdivide_tags, TagsComeBeforeNormalsThatDiffer)
{
  const Part box = uneven_box();
  const auto normal = [&](std::size_t f, std::size_t) { return unit(box.area(f)); };
  const std::string s = box.obj_of_corners(normal);
  folder.write("normals.obj", s);
  folder.write("both.obj", s + "t crease 2/1/0 0 1 10\n");
  const std::string options = "--levels 1 --output-normals control";
  EXPECT_EQ(refined("normals.obj", "o.obj", options).tags.edges.size(), 24u);
  for (const char* const source : {"", " --sharp auto", " --sharp file"})
    EXPECT_EQ(refined("both.obj", "o.obj", options + source).tags.edges.size(), 2u) << source;
}

TEST_F(Pn_subdivide_tags, TagsFollowWhatIsMended)
{
  // two halves of the box with vertices of their own, in quads that are split
  std::string s = obj_box();
  s += "v 1 -2 3\nv 1 2 3\nv -1 2 3\nv -1 -2 3\n"; // 8 to 11, equal to 5, 6, 7, 4
  s.replace(s.find("f 5 6 7 8"), 9, "f 12 9 10 11");
  s += "t crease 2/1/0 8 9 10\nt crease 2/1/0 0 1 10\nt corner 1/1/0 11 10\n";
  folder.write("apart.obj", s);
  for (const char* const more :
       {" --merge-points", " --merge-points --triangulate", " --merge-points --repair"}) {
    SCOPED_TRACE(more);
    const Mesh_data mesh =
      refined("apart.obj", "o.ply",
              std::string("--drop-attributes --levels 0 --output-normals control") + more);
    EXPECT_EQ(mesh.tags.edges.size(), 2u);
    for (const Crease_tags::Edge& edge : mesh.tags.edges)
      EXPECT_GE(edge_of_box(mesh.points[edge.ends[0]], mesh.points[edge.ends[1]]), 0);
    std::size_t corners = 0;
    for (std::size_t v = 0; v < mesh.tags.vertices.size(); ++v) {
      if (!(mesh.tags.vertices[v] > 0)) continue;
      ++corners;
      EXPECT_EQ(mesh.points[v], (Triple{-1, -2, 3}));
    }
    EXPECT_EQ(corners, 1u);
  }
}

TEST_F(Pn_subdivide_tags, DamagedTagsAreRefused)
{
  const auto expect_refusal = [&](const std::string& name, const std::string& content,
                                  const std::string& part) {
    folder.write(name, content);
    Command_test::expect_refusal(name, "o.ply", "", {part}, 1);
  };
  const auto obj = [](const std::string& line) { return obj_box() + line + "\n"; };
  expect_refusal("a.obj", obj("t crease 2/1/0 0 8 10"), "line 15: vertex 8 of a tag");
  expect_refusal("a.obj", obj("t corner 1/1/0 -1 10"), "line 15: vertex -1 of a tag");
  expect_refusal("a.obj", obj("t crease 2/1/0 0 1 -2"), "line 15: a sharpness");
  expect_refusal("a.obj", obj("t crease 2/1/0 0 1 nan"), "line 15: a sharpness");
  expect_refusal("a.obj", obj("t crease 2/1/0 0 1"), "line 15: the line ends");
  expect_refusal("a.obj", obj("t crease 1/1/0 0 1"), "t crease 2/1/0 A B S");
  expect_refusal("a.obj", obj("t crease x 0 1 2"), "line 15");
  expect_refusal("a.obj", obj("t crease 3/3/0 0 1 2 1 1 1"), "3 sharpnesses for 2");
  expect_refusal("a.obj", obj("t crease 2/1/0 0 6 10"), "no edge between the vertices 0 and 6");
  expect_refusal("a.ply", ply_box({{{0, 8}, 1}}, {}), "vertex 8 is out of range");
  expect_refusal("a.ply", ply_box({{{0, -1}, 1}}, {}), "vertex -1 is out of range");
  expect_refusal("a.ply", ply_box({{{0, 1}, -1}}, {}), "a sharpness");
  expect_refusal("a.ply", ply_box({}, {0, 0, -1, 0, 0, 0, 0, 0}), "vertex 2 of 8 has a sharpness");
  expect_refusal("a.ply", ply_box({{{0, 6}, 1}}, {}), "no edge between the vertices 0 and 6");
}

// Without sharpness of edges these are what other programs write, and a property of vertices is the user's own.
TEST_F(Pn_subdivide_tags, OtherEdgesAndNumbersAreNoTags)
{
  std::string s = ply_box({{{0, 1}, 1}}, {1, 2, 3, 4, 5, 6, 7, 8});
  const std::string property = "vertex2\nproperty double sharpness\n";
  s.replace(s.find(property), property.size(), "vertex2\nproperty double crease\n");
  folder.write("a.ply", s);
  const Mesh_data mesh = read_mesh(folder.file("a.ply"));
  EXPECT_FALSE(mesh.tags.any());
  EXPECT_EQ(mesh.dropped, std::vector<std::string>{"the element 'edge'"});
  ASSERT_EQ(mesh.attributes.of_vertices.size(), 1u);
  EXPECT_EQ(mesh.attributes.of_vertices[0].values[7], 8);
}

// --- from call to call ---

TEST_F(Pn_subdivide_tags, TwoCallsOfOneRoundAreOneOfTwo)
{
  const std::string inputs[] = {"quads.obj", "open_quads.obj"},
                    of_triangles[] = {"triangles.obj", "open_triangles.obj"};
  std::size_t k = 0;
  for (const std::string& scheme : schemes)
    for (const std::string& input : takes_triangles(scheme) ? of_triangles : inputs)
      for (const std::string name : {"", "rims", "corner"})
        for (const std::string sharpness : {"inf", "2", "1.5", "0.5", "3.25"})
          for (const std::string border : {"surface", "curve", "corners"}) {
            const bool is_open = contains(input, "open");
            if (!is_open && border != "surface") continue;
            if (is_open && name == "rims") continue; // its upper rim is the border
            if (name.empty() && sharpness != "inf") continue;
            if (!tests_are_full && k++ % 4 != 0) continue; // meets each sharpness and border
            SCOPED_TRACE(scheme + input + name + sharpness + border);
            const std::string options = "--output-normals both --scheme " + scheme +
                                        (is_open ? " --border " + border : std::string());
            const std::string first =
              options + (name.empty() ? "" : sharp(name) + "--sharpness " + sharpness);
            const Mesh_data one = refined(input, "one.ply", first + " --levels 2");
            written(input, "half.ply", first + " --levels 1");
            expect_same_but_for_numbers(one,
                                        refined("half.ply", "two.ply", options + " --levels 1"));
          }
}

TEST_F(Pn_subdivide_tags, OneRoundAndTwoAreThree)
{
  for (const char* const encoding : {"", " --ascii"})
    for (const std::string scheme : {"catmull-clark", "loop"}) {
      const std::string input = takes_triangles(scheme) ? "triangles.obj" : "quads.obj";
      const std::string options = "--output-normals both --scheme " + scheme + encoding;
      const std::string first = options + sharp("corner") + "--sharpness 2.5";
      const Mesh_data one = refined(input, "one.ply", first + " --levels 3");
      written(input, "a.ply", first + " --levels 1");
      expect_same_but_for_numbers(one, refined("a.ply", "b.ply", options + " --levels 2"));
      written(input, "a.ply", first + " --levels 2");
      expect_same_but_for_numbers(one, refined("a.ply", "b.ply", options + " --levels 1"));
    }
}

// --- refusals ---

TEST_F(Pn_subdivide_tags, WhatDoesNotGoWithWriteTags)
{
  const auto expect_refusal = [&](const std::string& options,
                                  const std::vector<std::string>& parts) {
    Command_test::expect_refusal("quads.obj", "o.ply", options, parts);
  };
  const std::string tags = " --write-tags '" + folder.file("t.selection.txt") + "' ";
  expect_refusal("--scheme doo-sabin" + tags, {"--write-tags", "doo-sabin"});
  expect_refusal("--scheme sqrt3 --triangulate" + tags, {"--write-tags", "sqrt3"});
  expect_refusal("--pieces 2" + tags, {"--write-tags", "--pieces"});
  expect_refusal("--write-tags t.txt", {".selection.txt"});
  expect_refusal("--write-tags -", {".selection.txt"});
  expect_refusal(sharp("all") + "--write-tags '" + folder.file("all.selection.txt") + "'",
                 {"a file of its own"});
  Command_test::expect_refusal("quads.obj", "o.ply", "--write-tags /no/such/t.selection.txt",
                               {"/no/such"}, 1);
}

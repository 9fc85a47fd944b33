// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// `pn_subdivide surface --output-normals`: which normals are written, and what files say of them.

#include "Extent.h"
#include "Part_files.h"
#include "Refined_files.h"

#include "io/mesh_io.h"

using namespace pn_subdivide;

namespace {

// The unit sums of the areas, of all faces at a vertex that have the same mark; by corner.
std::vector<Triple> area_normals(const Mesh_data& mesh, const std::vector<double>& marks)
{
  std::map<std::pair<Mesh_data::Index, double>, Triple> sums;
  const auto mark = [&](std::size_t f) { return marks.empty() ? 0 : marks[f]; };
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    for (const Mesh_data::Index v : mesh.face(f)) {
      Triple& of_mark = sums[{v, mark(f)}];
      of_mark = sum(of_mark, area_vector(mesh, f));
    }
  std::vector<Triple> result;
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    for (const Mesh_data::Index v : mesh.face(f)) result.push_back(unit(sums[{v, mark(f)}]));
  return result;
}

std::vector<Triple> normals_of_corners(const Mesh_data& mesh)
{
  if (mesh.has_corner_normals()) return mesh.corner_normals;
  std::vector<Triple> result;
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    for (const Mesh_data::Index v : mesh.face(f)) result.push_back(mesh.normals[v]);
  return result;
}

// Each side of the box is a group.
std::string box(bool is_triangles, bool is_open)
{
  Part part = uneven_box(is_triangles, is_open);
  const auto faces = std::exchange(part.faces, {});
  std::string s = part.obj();
  for (std::size_t f = 0; f < faces.size(); ++f) {
    s += "g side" + std::to_string(is_triangles ? f / 2 : f) + "\nf";
    for (const std::size_t v : faces[f]) s += " " + std::to_string(v + 1);
    s += "\n";
  }
  return s;
}

// The edges between the sides.
const char* const all_edges = "\n\n0 1 1 2 2 3 3 0 4 5 5 6 6 7 7 4 0 4 1 5 2 6 3 7\n";

class Pn_subdivide_output_normals : public Refined_files
{
protected:
  void SetUp() override
  {
    for (const bool is_open : {false, true}) {
      folder.write(is_open ? "open.obj" : "quads.obj", box(false, is_open));
      folder.write(is_open ? "open_triangles.obj" : "triangles.obj", box(true, is_open));
    }
    folder.write("all.selection.txt", all_edges);
  }

  std::string input_of(const std::string& scheme, bool is_open = false) const
  {
    if (takes_triangles(scheme)) return is_open ? "open_triangles.obj" : "triangles.obj";
    return is_open ? "open.obj" : "quads.obj";
  }

  // A file with both, read as if it had the first normals only.
  Mesh_data read_first_normals(const std::string& file) const
  {
    std::string content = Temporary_folder::content(folder.file(file));
    for (std::size_t i = content.find("control_n"); i != std::string::npos && i < 2000;
         i = content.find("control_n", i))
      content.replace(i, 9, "another_n");
    return read_mesh(folder.write("first_of_" + file, content));
  }

  std::string sharp() const { return " --sharp '" + folder.file("all.selection.txt") + "'"; }
};

const std::vector<std::string> all_schemes = {
  "catmull-clark",    "loop",    "doo-sabin",     "sqrt3",
  "butterfly",        "kobbelt", "modified-loop", "modified-catmull-clark",
  "ct-catmull-clark", "ct-loop"};
const std::vector<std::string> creasing_schemes = {"catmull-clark", "loop",
                                                   "modified-catmull-clark", "modified-loop"};

constexpr double rounding = 1e-14;

} // namespace

// --- auto ---

TEST_F(Pn_subdivide_output_normals, AutoIsThoseOfTheFacesForEveryScheme)
{
  std::size_t k = 0;
  for (const std::string& scheme : all_schemes)
    for (const bool is_open : {false, true})
      for (const char* const more : {" --levels 1", " --levels 2 --normals angle --threads 2"})
        for (const char* const output : {"o.ply", "o.obj", "o.off"}) {
          if (!tests_are_full && ++k % 2 == 0)
            continue; // three formats: the next choice has the others
          SCOPED_TRACE(scheme + more + output);
          const Mesh_data mesh = refined(input_of(scheme, is_open), output,
                                         "--drop-attributes --output-normals auto --scheme " +
                                           scheme + std::string(more));
          ASSERT_TRUE(mesh.has_normals());
          EXPECT_LE(largest_distance(normals_of_corners(mesh), area_normals(mesh, {})), rounding);
        }
}

TEST_F(Pn_subdivide_output_normals, AutoHasThemPerWedgeWhereEdgesAreSharp)
{
  // the sharpness, and the rounds for which it separates sides
  const std::pair<const char*, int> states[] = {{"inf", 9}, {"5", 9},   {"2", 1},   {"1", 0},
                                                {"1.5", 1}, {"0.5", 0}, {"2.25", 2}};
  std::size_t k = 0;
  for (const std::string& scheme : creasing_schemes)
    for (const auto& [sharpness, rounds] : states)
      for (const int levels : {1, 2})
        for (const bool is_open : {false, true}) {
          if (!tests_are_full && k++ % 3 != 0) continue;
          if (is_open) folder.write("all.selection.txt", "\n\n0 1 1 2 2 3 3 0 0 4 1 5 2 6 3 7\n");
          SCOPED_TRACE(scheme + " " + sharpness + " " + std::to_string(levels));
          const Mesh_data mesh = refined(input_of(scheme, is_open), "o.obj",
                                         "--scheme " + scheme + sharp() + " --sharpness " +
                                           sharpness + " --levels " + std::to_string(levels));
          folder.write("all.selection.txt", all_edges);
          const Columns& columns = mesh.attributes.of_faces;
          ASSERT_EQ(columns.size(), 1u);
          const bool is_sharp = levels <= rounds;
          EXPECT_EQ(mesh.has_corner_normals(), is_sharp);
          EXPECT_LE(largest_distance(
                      normals_of_corners(mesh),
                      area_normals(mesh, is_sharp ? columns[0].values : std::vector<double>())),
                    rounding);
        }
}

TEST_F(Pn_subdivide_output_normals, BordersThatAreCreasesHaveOneNormalAVertex)
{
  for (const char* const border : {"surface", "curve", "corners", "fixed"}) {
    const Mesh_data mesh =
      refined("open.obj", "o.obj", std::string("--levels 2 --border ") + border);
    EXPECT_FALSE(mesh.has_corner_normals());
    EXPECT_LE(largest_distance(normals_of_corners(mesh), area_normals(mesh, {})), rounding);
  }
}

// Where a format has one normal for a vertex it is the sum of those of the wedges.
TEST_F(Pn_subdivide_output_normals, AVertexOfSeveralWedgesHasTheirSumInPly)
{
  const std::string options = "--levels 2" + sharp();
  const Mesh_data by_corners = refined("quads.obj", "o.obj", options);
  const Mesh_data by_vertices = refined("quads.obj", "o.ply", options);
  std::vector<std::vector<Triple>> different(by_corners.points.size());
  std::size_t corner = 0;
  for (std::size_t f = 0; f < by_corners.number_of_faces(); ++f)
    for (const Mesh_data::Index v : by_corners.face(f)) {
      const Triple& n = by_corners.corner_normals[corner++];
      auto& known = different[v];
      if (std::find(known.begin(), known.end(), n) == known.end()) known.push_back(n);
    }
  for (std::size_t v = 0; v < different.size(); ++v) {
    Triple all{};
    for (const Triple& n : different[v]) all = sum(all, n);
    EXPECT_LE(distance(unit(all), by_vertices.normals[v]), rounding) << v;
  }
}

TEST_F(Pn_subdivide_output_normals, WithLimitAutoIsThoseOfTheSurface)
{
  for (const std::string& scheme : all_schemes) {
    if (scheme == "doo-sabin") continue;
    const std::string options = "--limit --levels 1 --scheme " + scheme;
    EXPECT_EQ(written(input_of(scheme), "a.ply", options),
              written(input_of(scheme), "b.ply", options + " --output-normals surface"))
      << scheme;
  }
  for (const std::string& scheme : creasing_schemes) {
    const std::string options = "--limit --levels 1 --scheme " + scheme + sharp();
    EXPECT_EQ(written(input_of(scheme), "a.obj", options),
              written(input_of(scheme), "b.obj", options + " --surface-normals"))
      << scheme;
  }
}

TEST_F(Pn_subdivide_output_normals, WithoutARoundAutoLeavesThemAsTheyAre)
{
  const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0.6 0 0.8\nvn 0 0.28 0.96\nvn 0 0 1\n"
                          "f 1//1 2//2 3//3\n";
  folder.write("a.obj", obj);
  for (const char* const output : {"b.ply", "b.obj", "b.off"}) {
    const Mesh_data mesh = refined("a.obj", output, "--levels 0 --normals file");
    EXPECT_EQ(mesh.normals, (std::vector<Triple>{{0.6, 0, 0.8}, {0, 0.28, 0.96}, {0, 0, 1}}));
    EXPECT_EQ(mesh.normal_kind, Normal_kind::control);
  }
}

TEST_F(Pn_subdivide_output_normals, LinearSchemesHaveThoseOfTheSurfaceOnlyIfAskedFor)
{
  for (const char* const none : {"--linear", "--normals none", "--linear --limit"})
    for (const char* const choice : {"", " --output-normals auto", " --output-normals none"}) {
      const std::string options = std::string("--levels 1 ") + none + choice;
      EXPECT_FALSE(refined("quads.obj", "o.ply", options).has_normals()) << options;
    }
  for (const char* const none : {"--linear", "--normals none", "--linear --limit"}) {
    const Mesh_data mesh =
      refined("quads.obj", "o.ply", std::string("--levels 1 --output-normals surface ") + none);
    EXPECT_TRUE(mesh.has_normals()) << none;
    EXPECT_EQ(mesh.normal_kind, Normal_kind::of_surface);
  }
}

// --- control, both, none, surface ---

// The corners of the box are on a sphere, and control normals that are those of the sphere stay so.
TEST_F(Pn_subdivide_output_normals, ControlIsTheControlNormals)
{
  const double radius = std::sqrt(14.);
  for (const std::string& scheme : all_schemes) {
    if (scheme.rfind("ct-", 0) == 0) continue; // they change control normals
    const std::string options = "--normals sphere:0,0,0 --levels 2 --drop-attributes --scheme " +
                                scheme + " --output-normals ";
    const Mesh_data control = refined(input_of(scheme), "c.ply", options + "control");
    for (std::size_t v = 0; v < control.points.size(); ++v)
      EXPECT_LE(distance(control.normals[v], sum({}, control.points[v], 1 / radius)), rounding)
        << scheme;
    const Mesh_data of_faces = refined(input_of(scheme), "a.ply", options + "auto");
    EXPECT_GT(largest_distance(of_faces.normals, control.normals), 0.01) << scheme;
  }
}

TEST_F(Pn_subdivide_output_normals, BothIsAutoAndControl)
{
  std::vector<std::pair<std::string, std::string>> modes;
  for (const std::string& scheme : all_schemes)
    for (const std::string more : {"--levels 0", "--levels 1", "--levels 1 --limit"})
      // without a round all schemes are the same
      if (tests_are_full || scheme == all_schemes[0] || more != "--levels 0")
        if (scheme != "doo-sabin" || !contains(more, "--limit")) modes.emplace_back(scheme, more);
  for (const std::string& scheme : creasing_schemes)
    for (const std::string more :
         {"--levels 2", "--levels 2 --sharpness 1.5", "--levels 0", "--levels 1 --limit"})
      modes.emplace_back(scheme, more + sharp());
  bool is_text = false;
  for (const auto& [scheme, more] : modes) {
    SCOPED_TRACE(scheme + " " + more);
    is_text = !is_text;
    const std::string input = input_of(scheme);
    const std::string options = "--drop-attributes --scheme " + scheme + " " + more +
                                (is_text ? " --ascii" : "") + " --output-normals ";
    const Mesh_data control = refined(input, "c.ply", options + "control");
    const Mesh_data of_auto = refined(input, "a.ply", options + "auto");
    const Mesh_data both = refined(input, "b.ply", options + "both");
    EXPECT_EQ(both.points, of_auto.points);
    EXPECT_EQ(both.normals, control.normals); // those win
    EXPECT_EQ(both.normal_kind, Normal_kind::control);
    EXPECT_EQ(read_first_normals("b.ply").normals, of_auto.normals);
    // a format that has several normals for a vertex says what they are
    const Mesh_data of_corners = refined(input, "c.obj", options + "control");
    EXPECT_EQ(normals_of_corners(both), normals_of_corners(of_corners));
    const std::string vtp = written(input, "b.vtp", options + "both");
    expect_part(vtp, "Name=\"Normals\" NumberOfComponents=\"3\"");
    expect_part(vtp, "Name=\"control_normals\" NumberOfComponents=\"3\"");
  }
}

TEST_F(Pn_subdivide_output_normals, NoneIsNone)
{
  for (const std::string more : {"--levels 0", "--levels 1", "--levels 1 --limit"})
    for (const char* const output : {"o.ply", "o.obj", "o.off", "o.vtp"}) {
      const std::string text =
        written("quads.obj", output, more + " --ascii --output-normals none");
      for (const char* const word : {"nx", "vn ", "NOFF", "Normals", "normals"})
        expect_no_part(text, word);
    }
  const std::string creased =
    written("quads.obj", "o.obj", "--levels 1 --output-normals none" + sharp());
  expect_no_part(creased, "vn ");
}

// Other programs refuse NOFF.
TEST_F(Pn_subdivide_output_normals, OffHasThemIfTheyAreAskedFor)
{
  const auto begins = [&](const std::string& options) {
    const std::string text = written("quads.obj", "o.off", "--drop-attributes " + options);
    return text.substr(0, text.find('\n'));
  };
  for (const char* const plain :
       {"--levels 1", "--levels 1 --normals angle", "--levels 0", "--levels 1 --limit"})
    EXPECT_EQ(begins(plain), "OFF") << plain;
  for (const char* const asked :
       {"--levels 1 --output-normals auto", "--levels 1 --output-normals surface",
        "--levels 1 --output-normals control", "--levels 1 --surface-normals",
        "--levels 0 --normals angle"})
    EXPECT_EQ(begins(asked), "NOFF") << asked;
  const Outcome outcome = run(words("quads.obj", "o.off"));
  expect_part(outcome.err, "(not written; --output-normals writes some)");
}

TEST_F(Pn_subdivide_output_normals, SurfaceIsTheOldFlag)
{
  for (const std::string more : {"", " --linear", " --limit", " --linear --limit"})
    for (const std::string& crease : {std::string(), sharp()}) {
      const std::string options = "--levels 1" + more + crease;
      const std::string flag = written("quads.obj", "a.obj", options + " --surface-normals");
      EXPECT_EQ(flag, written("quads.obj", "b.obj", options + " --output-normals surface"));
      EXPECT_EQ(flag, written("quads.obj", "b.obj",
                              options + " --surface-normals --output-normals surface"));
    }
}

// --- what files say ---

TEST_F(Pn_subdivide_output_normals, FilesSayWhatTheyAre)
{
  const std::pair<std::string, std::string> cases[] = {
    {"--levels 1", "normals of the mesh"},
    {"--levels 1 --output-normals auto", "normals of the mesh"},
    {"--levels 1 --output-normals both", "normals of the mesh"},
    {"--levels 1 --limit", "normals of the surface"},
    {"--levels 1 --limit --output-normals both", "normals of the surface"},
    {"--levels 1 --output-normals surface", "normals of the surface"},
    {"--levels 0 --output-normals surface", "normals of the surface"},
    {"--levels 1 --linear --surface-normals", "normals of the surface"},
    {"--levels 1 --output-normals control", "control normals"},
    {"--levels 1 --limit --output-normals control", "control normals"},
    {"--levels 0", "control normals"},
    {"--levels 0 --output-normals both", "control normals"},
    {"--levels 1 --linear", ""},
    {"--levels 1 --output-normals none", ""}};
  for (const auto& [options, comment] : cases)
    for (const std::string encoding : {"", " --ascii"}) {
      SCOPED_TRACE(options + encoding);
      const std::string ply = written("quads.obj", "o.ply", options + encoding);
      const std::string vtp = written("quads.obj", "o.vtp", options + encoding);
      for (const std::string other :
           {"normals of the mesh", "normals of the surface", "control normals"}) {
        EXPECT_EQ(number_of(ply, "\ncomment " + other + "\n"), other == comment ? 1u : 0u);
        EXPECT_EQ(number_of(vtp, "\n<!-- " + other + " -->\n"), other == comment ? 1u : 0u);
      }
    }
}

TEST_F(Pn_subdivide_output_normals, OthersReadAsControlNormalsGetOneWarning)
{
  const std::pair<std::string, bool> files[] = {{"--levels 1", true},
                                                {"--levels 1 --limit", true},
                                                {"--levels 1 --output-normals surface", true},
                                                {"--levels 1 --output-normals control", false},
                                                {"--levels 1 --output-normals both", false},
                                                {"--levels 1 --limit --output-normals both", false},
                                                {"--levels 1 --output-normals none", false}};
  for (const auto& [options, is_other] : files)
    for (const std::string encoding : {"", " --ascii"}) {
      bool is_next = encoding.empty();
      written("quads.obj", "a.ply", options + encoding);
      for (const std::string further :
           {"--levels 1", "--levels 2 --normals auto", "--levels 1 --output-normals both",
            "--levels 0 --output-normals control", "--levels 0 --limit"}) {
        if (!tests_are_full && (is_next = !is_next)) continue; // with the other encoding
        SCOPED_TRACE(options + encoding + ", " + further);
        const Outcome outcome = done(surface("a.ply", "b.ply", further));
        EXPECT_EQ(number_of(outcome.err, "\n"), is_other ? 1u : 0u) << outcome.err;
        EXPECT_EQ(contains(outcome.err, "--output-normals both"), is_other) << outcome.err;
        EXPECT_EQ(surface("a.ply", "b.ply", further + " --strict").code, is_other ? 4 : 0);
      }
      // nobody takes them for control normals
      for (const std::string further :
           {"--levels 1 --linear", "--levels 1 --normals none", "--levels 1 --normals estimate",
            "--levels 1 --normals sphere:0,0,0", "--levels 0"})
        if (tests_are_full || !(is_next = !is_next)) {
          EXPECT_EQ(surface("a.ply", "b.ply", further).err, "") << options << further;
        }
    }
}

TEST_F(Pn_subdivide_output_normals, ACopySaysWhatItsNormalsAre)
{
  for (const std::string options : {"--levels 1", "--levels 1 --limit"}) {
    const Mesh_data first = refined("quads.obj", "a.ply", options);
    const Mesh_data copy = refined("a.ply", "b.ply", "--levels 0");
    EXPECT_EQ(copy.normal_kind, first.normal_kind);
    EXPECT_NE(copy.normal_kind, Normal_kind::control);
    EXPECT_EQ(copy.normals, first.normals);
    if (surface("a.ply", "c.ply", "--levels 0 --curvature mean").code == 0) { // with Eigen
      EXPECT_EQ(read_mesh(folder.file("c.ply")).normal_kind, first.normal_kind);
    }
  }
}

TEST_F(Pn_subdivide_output_normals, TwoCallsWithBothAreOne)
{
  for (const std::string& scheme : all_schemes)
    for (const bool is_open : {false, true})
      for (const std::string encoding : {"", " --ascii"}) {
        if (!tests_are_full && is_open == encoding.empty()) continue;
        const std::string options =
          "--drop-attributes --output-normals both --scheme " + scheme + encoding;
        const std::string input = input_of(scheme, is_open);
        const Mesh_data one = refined(input, "one.ply", options + " --levels 2");
        written(input, "half.ply", options + " --levels 1");
        const Mesh_data two = refined("half.ply", "two.ply", options + " --levels 1");
        // from round to round they change their rules: the second round is that of another first one
        if (scheme == "sqrt3" && is_open) continue;
        SCOPED_TRACE(scheme + (is_open ? " open" : "") + encoding);
        expect_same_but_for_numbers(one, two);
      }
}

TEST_F(Pn_subdivide_output_normals, DamagedListsOfNormals)
{
  const auto ply = [](const std::string& list) {
    return "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
           "property double z\nproperty double control_nx\nproperty double control_ny\n"
           "property double control_nz\nelement face 1\nproperty list uchar int vertex_indices\n"
           "property list uchar double corner_control_normals\nend_header\n"
           "0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n3 0 1 2 " +
           list + "\n";
  };
  folder.write("a.ply", ply("9 0 0 1 0 0 1 0 1 0"));
  const Mesh_data mesh = read_mesh(folder.file("a.ply"));
  EXPECT_EQ(mesh.corner_normals, (std::vector<Triple>{{0, 0, 1}, {0, 0, 1}, {0, 1, 0}}));
  EXPECT_EQ(mesh.dropped, std::vector<std::string>());
  folder.write("a.ply", ply("0"));
  EXPECT_EQ(read_mesh(folder.file("a.ply")).corner_normals,
            (std::vector<Triple>{{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}));
  folder.write("a.ply", ply("9 0 0 1 0 1 nan 0 1 0")); // that one is none
  const Mesh_data broken = read_mesh(folder.file("a.ply"));
  EXPECT_EQ(broken.corner_normals, (std::vector<Triple>{{0, 0, 1}, {0, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(broken.broken_normals.first, "face 0 of 1");
  folder.write("o.ply", "old");
  for (const std::string list : {"3 0 0 1", "8 0 0 1 0 0 1 0 1"}) {
    folder.write("a.ply", ply(list));
    expect_one_line(surface("a.ply", "o.ply", ""), 1, "normal");
    EXPECT_EQ(content("o.ply"), "old");
  }
}

// --- refusals ---

TEST_F(Pn_subdivide_output_normals, WhatDoesNotGoTogetherIsRefused)
{
  const auto expect_refusal = [&](const std::string& output, const std::string& options,
                                  const std::vector<std::string>& parts) {
    Command_test::expect_refusal("quads.obj", output, options, parts);
  };
  for (const char* const output : {"o.obj", "o.off", "o.stl"})
    expect_refusal(output, "--output-normals both", {"--output-normals both", output, ".ply"});
  for (const std::string choice : {"control", "both"})
    for (const std::string other : {"--linear", "--normals none"})
      expect_refusal("o.ply", "--output-normals " + choice + " " + other,
                     {"--output-normals " + choice, other});
  for (const std::string choice : {"auto", "control", "both", "none"})
    expect_refusal("o.ply", "--surface-normals --output-normals " + choice,
                   {"--surface-normals", "--output-normals " + choice});
  expect_refusal("o.ply", "--output-normals contrl", {"did you mean control?"});
  expect_refusal("o.ply", "--output-normals ''", {"auto, surface, control, both or none"});
  expect_refusal("o.ply", "--output-normals surface --scheme doo-sabin",
                 {"--output-normals", "doo-sabin"});
  expect_refusal("o.ply", "--output-normals surface --levels 1 --sharpness 1.5" + sharp(),
                 {"--output-normals", "--levels 2"});
}

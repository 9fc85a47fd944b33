// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Refinement in pieces writes the file that refinement as a whole writes, alone and under mpirun; what fails or is
// interrupted leaves nothing behind, or what --resume needs.

#include "Pieces_test.h"

#ifdef __unix__
#  include <chrono>
#  include <csignal>
#  include <sys/wait.h>
#endif

namespace {

using pn_subdivide::raw_array;

const std::vector<std::string> schemes = {
  "catmull-clark",          "loop",          "butterfly", "kobbelt",
  "modified-catmull-clark", "modified-loop", "midpoint",  "bilinear"};

TEST_F(Pieces, AreTheWholeFile)
{
  for (const std::string& scheme : schemes)
    for (const char* const pieces : {"--pieces 2", "--pieces 7", "--pieces 64"})
      expect_whole(scheme, "--levels 3", pieces);
}

TEST_F(Pieces, OfOtherOptions)
{
  expect_whole("catmull-clark", "--levels 3 --linear", "--pieces 7");
  expect_whole("loop", "--levels 3 --linear", "--pieces 7");
  expect_whole("loop", "--levels 3 --normal-scheme modified-loop", "--pieces 7");
  expect_whole("kobbelt", "--levels 0", "--pieces 3");
  expect_whole("catmull-clark", "--levels 3", "--memory 1G");
  expect_whole("catmull-clark", "--levels 3", "--pieces 5 --threads 2");
  expect_whole("catmull-clark", "--levels 3", "--pieces 5 --resume");
  expect_whole("ct-catmull-clark", "--levels 4", "--pieces 7");
}

TEST_F(Pieces, OfEveryKindOfNormals)
{
  for (const std::string& scheme : schemes)
    for (const char* const normals : {"auto", "control", "both", "none"})
      for (const char* const levels : {"--levels 1 ", "--levels 2 ", "--levels 4 "})
        for (const char* const pieces : {"--pieces 1", "--pieces 7", "--pieces 64"})
          expect_whole(scheme, levels + ("--output-normals " + std::string(normals)), pieces);
  expect_whole("kobbelt", "--levels 0 --output-normals both", "--pieces 3");
  expect_whole("loop", "--levels 3 --output-normals both --normal-scheme modified-loop",
               "--pieces 7 --threads 2");
  expect_whole("ct-catmull-clark", "--levels 3 --output-normals both", "--pieces 7 --resume");
}

// Points on the limit surface, and its normals.
TEST_F(Pieces, AtTheLimit)
{
  for (const std::string& scheme : schemes) {
    for (const char* const pieces : {"--pieces 1", "--pieces 7", "--pieces 64"})
      expect_whole(scheme, "--levels 2 --limit", pieces);
    expect_whole(scheme, "--levels 1 --output-normals surface", "--pieces 7");
  }
  for (const char* const options :
       {"--limit --linear", "--output-normals surface --linear", "--limit --output-normals none",
        "--limit --output-normals control", "--limit --limit-tolerance 1e-4"})
    expect_whole("catmull-clark", "--levels 2 " + std::string(options), "--pieces 7");
  for (const char* const border : {"surface", "curve"})
    for (const char* const options : {"--limit", "--output-normals surface", "--limit --linear"})
      for (const char* const levels : {"0", "2"})
        expect_same("loop", "triangles.off",
                    std::string("--quiet --sharp angle:25 --border ") + border + " --levels " +
                      levels + " " + options,
                    {"7"});
}

// Also the warning is there that vertices have several normals; where all creases have run out it is not.
TEST_F(Pieces, OfCreases)
{
  int with_warning = 0, without = 0;
  const auto expect = [&](const std::string& scheme, const std::string& options,
                          const std::vector<std::string>& numbers_of_pieces) {
    const bool warns =
      expect_same(scheme, input_of(scheme), "--quiet " + options, numbers_of_pieces);
    ++(warns ? with_warning : without);
  };
  for (const std::string scheme : {"catmull-clark", "loop", "modified-loop", "ct-catmull-clark"})
    for (const char* const sharp : {"", "--sharp angle:25 ", "--sharp angle:25 --sharpness 1.5 ",
                                    "--sharp angle:25 --linear "})
      for (const char* const border : {"surface", "curve", "corners", "fixed"})
        expect(scheme, std::string(sharp) + "--levels 3 --border " + border, {"7"});
  for (const char* const levels : {"0", "1", "2", "4"})
    for (const char* const normals : {"auto", "none"})
      expect("catmull-clark",
             std::string("--sharp angle:25 --sharpness 2.3 --levels ") + levels +
               " --output-normals " + normals,
             {"1", "2", "64"});
  expect("loop", "--sharp angle:25 --levels 3 --normal-scheme modified-loop --threads 2", {"7"});
  EXPECT_GT(with_warning, 0);
  EXPECT_GT(without, 0);
}

// Normals of corners and tags of a file that a first call has written.
TEST_F(Pieces, OfCreasesOfTheFile)
{
  const std::string first = "--levels 1 --sharp angle:25 --sharpness 2.5 --output-normals both";
  done(run(in_out("catmull-clark", "first.ply") + first));
  for (const std::string levels : {"1", "2", "3"})
    expect_same("catmull-clark", "first.ply", "--quiet --levels " + levels, {"7"});
}

// Areas whose squares are no numbers.
TEST_F(Pieces, OfEverySize)
{
  std::istringstream in(content("quads.off"));
  for (const char* const exponent : {"e180", "e-180"}) {
    std::string scaled, line;
    in.clear();
    in.seekg(0);
    for (int i = 0; std::getline(in, line); ++i) {
      std::istringstream words(line);
      std::string x, y, z;
      if (i >= 2 && i < 39 && words >> x >> y >> z)
        line = x + exponent + " " + y + exponent + " " + z + exponent;
      scaled += line + "\n";
    }
    folder.write("quads.off", scaled);
    expect_whole("catmull-clark", "--levels 2", "--pieces 7");
    expect_no_part(content("whole.ply"), "nan");
  }
}

TEST_F(Pieces, LongFaces)
{
  std::string points, face = "300";
  for (int i = 0; i < 300; ++i) {
    points += std::to_string(i < 150 ? i : 299 - i) + (i < 150 ? " 0 0\n" : " 1 0\n");
    face += " " + std::to_string(i);
  }
  folder.write("quads.off", "OFF\n300 1 0\n" + points + face + "\n");
  for (const char* const levels : {"--levels 0", "--levels 1", "--levels 2"})
    expect_whole("catmull-clark", levels, "--pieces 2");
}

TEST_F(Pieces, WhatDoesNotGoWithThem)
{
  const auto expect_refusal = [&](const std::string& options, int code, const std::string& part,
                                  const std::string& out = "out.ply") {
    const std::size_t files = folder.number_of_files();
    expect_one_line(run(in_out("catmull-clark", out) + options), code, part);
    EXPECT_EQ(folder.number_of_files(), files);
  };
  expect_refusal("--pieces 0", 2, "--pieces");
  expect_refusal("--pieces 2 --memory 1G", 2, "--memory");
  expect_refusal("--memory 1X", 2, "500M");
  expect_refusal("--memory 1M --levels 6", 1, "at least");
  expect_refusal("--pieces 2", 2, ".ply or .pvtp", "out.obj");
  for (const std::string option :
       {"--curvature mean", "--verify sphere:0,0,0,1", "--interpolate slide",
        "--limit --output-normals both", "--ascii"})
    expect_refusal("--pieces 2 " + option, 2, option.substr(0, option.find(' ')));
  for (const char* const in_pieces : {"--pieces 2 ", "--memory 1G ", "--resume "})
    expect_refusal(in_pieces + std::string("--chord 0.1"), 2, "--levels N");
  expect_refusal("--chord 0.1", 2, "--levels N", "out.pvtp");
  for (const std::string scheme : {"sqrt3", "doo-sabin"})
    expect_one_line(run(in_out(scheme, "out.ply") + "--pieces 2"), 2,
                    "--scheme " + scheme + " and refinement in pieces");
  expect_refusal("--pieces 2 --sharp angle:5 --output-normals control", 1, "--sharp none");
  expect_refusal("--pieces 2 --border curve --output-normals both", 1, "--border surface");
}

// Each piece has the normals that the whole file has at its vertices, and those of faces around none of its own.
TEST_F(Pieces, PvtpHasTheNormalsOfTheWhole)
{
  for (const std::string& scheme : schemes)
    for (const std::string normals : {"auto", "control", "both", "none", "auto --sharp angle:25"}) {
      const bool is_creased = normals.size() > 7;
      if (is_creased && scheme != "catmull-clark" && scheme != "loop") continue;
      const std::string options = "--levels 2 --output-normals " + normals;
      done(run(in_out(scheme, "whole.vtp") + options));
      done(run(in_out(scheme, "out.pvtp") + options + " --pieces 5"));
      const std::string whole = content("whole.vtp");
      std::size_t faces = 0;
      for (int i = 0; i < 5; ++i) {
        SCOPED_TRACE(normals);
        faces += raw_array<std::int64_t>(piece(i), "offsets").size();
        for (const char* const name : {"Points", "Normals", "control_normals"})
          expect_rows<double>(i, name, 3, "GlobalPointIds", name[0] != 'P');
      }
      EXPECT_EQ(faces, raw_array<std::int64_t>(whole, "offsets").size());
      const std::string index = content("out.pvtp");
      for (const std::string name : {"Normals", "control_normals"})
        EXPECT_EQ(index.find("Name=\"" + name + "\"") != std::string::npos,
                  !raw_array<double>(whole, name).empty());
    }
}

TEST_F(Pieces, PvtpAndItsFolder)
{
  done(run(in_out("catmull-clark", "out.pvtp") + "--levels 3 --pieces 7"));
  const std::string index = content("out.pvtp");
  for (int i = 0; i < 7; ++i) {
    const std::string piece = "out_pieces/piece_" + std::to_string(i) + ".vtp";
    expect_part(index, "<Piece Source=\"" + piece + "\"/>");
    EXPECT_TRUE(std::filesystem::exists(folder.file(piece)));
  }
  // again, with fewer pieces: nothing of the first is left
  done(run(in_out("catmull-clark", "out.pvtp") + "--levels 3 --pieces 2"));
  EXPECT_FALSE(std::filesystem::exists(folder.file("out_pieces/piece_2.vtp")));
  EXPECT_TRUE(std::filesystem::exists(folder.file("out_pieces/piece_1.vtp")));
  // something of the user's in the folder
  std::ofstream(folder.file("out_pieces/mine.txt")) << "mine";
  expect_one_line(run(in_out("catmull-clark", "out.pvtp") + "--levels 3 --pieces 2"), 1,
                  "out_pieces");
  EXPECT_EQ(content("out_pieces/mine.txt"), "mine");
}

#ifdef __unix__

// The limit on the size of files stands for a full disk.
TEST_F(Pieces, AFullDisk)
{
  const std::size_t files = folder.number_of_files();
  expect_one_line(
    run(in_out("catmull-clark", "out.ply") + "--levels 5 --pieces 7", "ulimit -f 200; "), 1,
    "out.ply");
  EXPECT_EQ(folder.number_of_files(), files);
  expect_one_line(
    run(in_out("catmull-clark", "out.pvtp") + "--levels 5 --pieces 7", "ulimit -f 200; "), 1,
    "out.pvtp");
  EXPECT_EQ(folder.number_of_files(), files);
}

TEST_F(Pieces, ASignal)
{
  const std::size_t files = folder.number_of_files();
  int killed = 0;
  for (const std::string out : {"out.ply", "out.pvtp"})
    for (const int signal : {SIGINT, SIGTERM})
      for (int delay = 0; delay < 4; ++delay) {
        const int status = interrupt(in_out("loop", out) + "--levels 6 --pieces 40", signal,
                                     std::chrono::milliseconds(5 * delay));
        if (WIFSIGNALED(status)) {
          ++killed;
          EXPECT_EQ(folder.number_of_files(), files) << out << " " << signal << " " << delay;
        }
        std::filesystem::remove(folder.file(out));
        std::filesystem::remove_all(folder.file("out_pieces"));
      }
  EXPECT_GE(killed, 1);
}

#  ifdef PN_TEST_MPIRUN

class Ranks : public Pieces
{
protected:
  Ranks() { program = PN_TEST_COMMAND_OF_RANKS; }

  // hwloc looks for graphics cards on the display :0, which other tests open and close: Xlib then ends
  // the rank. Of networks only the one within the machine is there for certain.
  static std::string with_ranks(int number)
  {
    return "HWLOC_COMPONENTS=-gl OMPI_MCA_btl_tcp_if_include=lo OMPI_ALLOW_RUN_AS_ROOT=1 "
           "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 "
           "'" PN_TEST_MPIRUN "' --oversubscribe -n " +
           std::to_string(number) + " ";
  }
};

TEST_F(Ranks, WriteTheWholeFile)
{
  for (const std::string& scheme : schemes)
    for (const char* const pieces : {"--pieces 2", "--pieces 7", "--pieces 64"})
      for (const int number : {2, 3})
        expect_whole(scheme, "--levels 3", pieces, with_ranks(number));
}

// Each rank looks for the box of its own pieces.
TEST_F(Ranks, AtTheLimit)
{
  for (const int number : {2, 3})
    expect_whole("catmull-clark", "--levels 2 --limit", "--pieces 7", with_ranks(number));
}

TEST_F(Ranks, WithoutFurtherOptions)
{
  expect_whole("catmull-clark", "--levels 3", "", with_ranks(2));
  expect_whole("catmull-clark", "--levels 3", "--resume", with_ranks(2));
}

// one line of ours, and none under the final name
TEST_F(Ranks, FailTogether)
{
  const std::size_t files = folder.number_of_files();
  // The limit is that of the ranks: mpirun needs files of its own.
  const std::string full =
    "OMPI_MCA_btl=self,tcp " + with_ranks(2) + "sh -c 'ulimit -f 200; exec \"$0\" \"$@\"' ";
  for (const std::string& before : {with_ranks(2), full})
    for (const std::string out : {"out.ply", "out.pvtp", "out.obj"}) {
      const bool is_full = before == full;
      if (is_full && out == "out.obj") continue;
      const Outcome outcome =
        run(in_out("catmull-clark", out) + "--levels 5 --pieces 7" + (is_full ? "" : " --check"),
            before);
      EXPECT_NE(outcome.code, 0);
      EXPECT_EQ(number_of(outcome.err, "pn_subdivide: "), 1u) << outcome.err;
      EXPECT_EQ(folder.number_of_files(), files) << out << outcome.err;
    }
}

TEST_F(Ranks, ShareNoCurves)
{
  folder.write("square.txt", "0 0\n1 0\n1 1\n0 1\n");
  const Outcome outcome =
    run("curve '" + folder.file("square.txt") + "' - --scheme bspline:3 --closed", with_ranks(2));
  EXPECT_NE(outcome.code, 0);
  EXPECT_EQ(outcome.out, "");
  expect_part(outcome.err, "leave mpirun out");
}

TEST_F(Ranks, AKilledRank)
{
  const std::size_t files = folder.number_of_files();
  for (const std::string out : {"out.ply", "out.pvtp"}) {
    // rank 1 kills itself after a while
    const std::string script =
      "if [ $OMPI_COMM_WORLD_RANK = 1 ]; then (sleep 0.3; kill -9 $$) & fi; "
      "exec '" PN_TEST_COMMAND_OF_RANKS "' " +
      in_out("loop", out) + "--levels 8 --pieces 40";
    folder.write("script.sh", script);
    const std::string command = with_ranks(2) + "sh '" + folder.file("script.sh") + "' 2>/dev/null";
    EXPECT_NE(std::system(command.c_str()), 0);
    EXPECT_FALSE(std::filesystem::exists(folder.file(out)));
    EXPECT_EQ(folder.number_of_files(), files + 1) << out;
  }
}

#  endif
#endif

} // namespace

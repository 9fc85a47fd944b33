// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Where the command reads from and writes to: standard input and output, links, and what a signal
// leaves behind.

#include "Command_test.h"

#include "io/mesh_io.h"

#include <utility>

#ifdef __unix__
#  include <chrono>
#  include <csignal>
#  include <sys/stat.h>
#  include <thread>
#  include <unistd.h>
#endif

using namespace pn_subdivide;

namespace {

class Streams : public Command_test
{
protected:
  void SetUp() override
  {
    folder.write("cube.off", cube_off);
    folder.write("p.txt", "0 0\n1 0\n1 1\n");
  }
  std::string quoted(const std::string& name) const { return "'" + folder.file(name) + "'"; }
  std::string drawn_curve() const
  {
    return "curve " + quoted("p.txt") + " " + quoted("c.txt") + " --scheme chaikin --comb " +
           quoted("comb.svg") + " --quiet";
  }
};

} // namespace

TEST_F(Streams, TheSameBytesAsInFiles)
{
  for (const std::string format : {"ply", "off", "obj", "stl", "vtp"}) {
    const std::string file = "file." + format;
    done(run("surface " + quoted("cube.off") + " " + quoted(file) + " --levels 2"));
    const std::string expected = content(file);
    EXPECT_GT(expected.size(), 100u);

    const Outcome out =
      done(run("surface " + quoted("cube.off") + " - --levels 2 --quiet --format " + format));
    EXPECT_EQ(out.err, "");
    EXPECT_TRUE(out.out == expected) << format;
  }
  // the format of standard input says nothing about a file
  const Outcome in = done(run("surface - " + quoted("in.ply") + " --levels 2 --format off",
                              "cat " + quoted("cube.off") + " | "));
  EXPECT_EQ(content("in.ply"), content("file.ply"));

  const Outcome both =
    run("surface - - --levels 2 --quiet --format OFF", "cat " + quoted("cube.off") + " | ");
  EXPECT_EQ(both.out, content("file.off"));
  EXPECT_FALSE(std::filesystem::exists("-"));
}

TEST_F(Streams, Curves)
{
  const std::string options = "--closed --scheme chaikin --quiet";
  done(run("curve " + quoted("p.txt") + " " + quoted("c.txt") + " " + options));
  const Outcome both = done(run("curve - - " + options, "cat " + quoted("p.txt") + " | "));
  EXPECT_EQ(both.out, content("c.txt"));
  expect_one_line(run("curve - - --comb - " + options, "cat " + quoted("p.txt") + " | "), 2,
                  "--comb");
}

TEST_F(Streams, WhatTheyNeed)
{
  const std::string file = quoted("cube.off"), out = quoted("o.ply");
  expect_one_line(run("surface - " + out), 2, "--format");
  expect_one_line(run("surface " + file + " -"), 2, "--format");
  expect_one_line(run("surface - " + out + " --format vtp"), 2,
                  "one of ply off obj stl to be read");
  expect_one_line(run("surface " + file + " - --format svg"), 2, "--format 'svg'");
  expect_one_line(run("surface " + file + " " + out + " --format ply"), 2, "--format");
  expect_one_line(run("surface - - --format off </dev/null"), 1, "standard input: nothing came in");
  expect_one_line(run("surface - - --format off", "echo Dear Sir | "), 1, "not an OFF file");
  EXPECT_EQ(folder.number_of_files(), 2u);
}

#ifdef __unix__

// Whatever is read, in any format.
TEST_F(Streams, DevicesWithoutEnd)
{
  const std::string file = quoted("cube.off"), out = quoted("o.ply");
  const std::string bounded = "ulimit -v 4000000; timeout 60 ";
  for (const std::string& arguments : {"surface " + file + " " + out + " --sharp /dev/zero",
                                       "surface - " + out + " --format ply </dev/zero",
                                       "surface - " + out + " --format obj </dev/zero",
                                       "surface - " + out + " --format off </dev/zero",
                                       "surface - " + out + " --format stl </dev/zero",
                                       "curve /dev/zero " + quoted("o.txt") + " --scheme chaikin"})
    expect_one_line(run(arguments, bounded), 1, "device");
  EXPECT_EQ(folder.number_of_files(), 2u);
}

#endif

// A reader of standard output must not take the first half of a mesh for a mesh.
TEST_F(Streams, AFailureWritesNothing)
{
  const std::string start = "surface " + quoted("cube.off") + " - --quiet --format ply ";
  expect_one_line(run(start + "--scheme loop"), 1, "--triangulate");
  expect_one_line(run(start + "--levels 20"), 1, "round");
  expect_one_line(run(start + "--verify circle:0,0,1"), 2, "circle");
  if (std::filesystem::exists("/dev/full")) {
    const std::string err = work.file("message");
    EXPECT_NE(
      std::system(
        ("'" PN_SUBDIVIDE_COMMAND "' " + start + " --levels 4 >/dev/full 2>'" + err + "'").c_str()),
      0);
    EXPECT_EQ(
      Temporary_folder::content(err).rfind("pn_subdivide: standard output: writing failed", 0), 0u)
      << Temporary_folder::content(err);
  }
}

TEST_F(Streams, TheDeviationDoesNotGetIntoTheMesh)
{
  const std::string start = "surface " + quoted("cube.off") + " - --quiet --format off ";
  const Outcome plain = run(start), verified = run(start + "--verify sphere:0,0,0,2");
  EXPECT_EQ(verified.out, plain.out);
  EXPECT_EQ(verified.err.rfind("deviation ", 0), 0u) << verified.err;
}

#ifdef __unix__

TEST_F(Streams, LinksAreWrittenThrough)
{
  namespace fs = std::filesystem;
  const auto write_to = [&](const std::string& name) {
    done(run("surface " + quoted("cube.off") + " " + quoted(name) + " --quiet"));
    EXPECT_TRUE(fs::is_symlink(folder.file(name))) << name;
  };
  fs::create_directory(folder.file("deep"));
  folder.write("deep/old.ply", "old");
  fs::create_symlink("deep/old.ply", folder.file("to_old.ply"));
  write_to("to_old.ply");
  EXPECT_EQ(read_mesh(folder.file("deep/old.ply")).points.size(), 26u);

  fs::create_symlink("deep/new.ply", folder.file("to_new.ply")); // there is no such file yet
  fs::create_symlink("to_new.ply", folder.file("to_link.ply"));
  write_to("to_link.ply");
  EXPECT_TRUE(fs::is_symlink(folder.file("to_new.ply")));
  EXPECT_EQ(read_mesh(folder.file("deep/new.ply")).points.size(), 26u);

  fs::create_symlink(folder.file("gone/new.ply"), folder.file("nowhere.ply"));
  fs::create_symlink("loop.ply", folder.file("loop.ply"));
  for (const auto& [name, part] : {std::pair("nowhere.ply", "no folder"), {"loop.ply", "itself"}})
    expect_one_line(run("surface " + quoted("cube.off") + " " + quoted(name)), 1, part);
}

// The curve is written into its temporary file, then the command waits at the drawing, a pipe that
// nobody reads, until the signal comes.
TEST_F(Streams, ASignalLeavesNoFile)
{
  ASSERT_EQ(mkfifo(folder.file("comb.svg").c_str(), 0600), 0);
  const std::string output = folder.write("c.txt", "untouched");
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const int status = interrupt(drawn_curve(), signal, std::chrono::milliseconds(0));
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal) << status;
    EXPECT_EQ(folder.number_of_files(), 4u) << "after signal " << signal;
    EXPECT_EQ(Temporary_folder::content(output), "untouched");
  }
}

// As under nohup.
TEST_F(Streams, AnIgnoredSignalStaysIgnored)
{
  ASSERT_EQ(mkfifo(folder.file("comb.svg").c_str(), 0600), 0);
  const pid_t child = start_command(drawn_curve(), "trap '' HUP; ");
  for (int i = 0; i < 1000 && folder.number_of_files() != 4; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_EQ(kill(child, SIGHUP), 0);
  EXPECT_NE(content("comb.svg"), ""); // lets the command go on
  int status = 0;
  EXPECT_EQ(waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
  EXPECT_NE(content("c.txt"), "");
}

#endif

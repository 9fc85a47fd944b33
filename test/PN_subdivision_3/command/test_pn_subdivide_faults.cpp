// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
// Memory, disk and user fail the command at every place: what it was to write is complete or as it was, nothing
// else is left behind, and it says what happened.

#include "Command_test.h"
#include "Failing_allocations.h"

#include "io/Error.h"
#include "options.h"

#include <iostream>
#include <set>

#ifdef __unix__
#  include <chrono>
#  include <csignal>
#  include <sys/wait.h>
#  include <unistd.h>
#endif

using namespace pn_subdivide;

namespace {

const char* const two_triangles = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 1\nvn 0.1 0 1\n"
                                  "f 1//1 2//1 3//2\nf 1//1 3//2 4//2\n";

class Faults : public Command_test
{
protected:
  void SetUp() override
  {
    folder.write("cube.off", cube_off);
    folder.write("two.obj", two_triangles);
    folder.write("p.txt", "0 0\n1 0\n1 1\n0 1\n");
  }
};

Command parsed(const std::vector<std::string>& arguments)
{
  std::vector<std::string> words{"pn_subdivide"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& w : words) argv.push_back(w.data());
  argv.push_back(nullptr);
  return parse_command_line(int(words.size()), argv.data());
}

// The commands in this program, as main() runs them.
void run_in_process(const Command& command)
{
  if (const auto* surface = std::get_if<Surface_options>(&command)) run_surface_command(*surface);
  if (const auto* curve = std::get_if<Curve_options>(&command)) run_curve_command(*curve);
}

#ifdef __unix__

enum Ending { done, out_of_memory, other_message, aborted };

// A job whose k-th allocation and all that follow fail, in a process of its own.
Ending run_with_allocations(const std::vector<std::string>& job, long k)
{
  const pid_t child = fork();
  if (child == 0) {
    alarm(60);
    if (std::freopen("/dev/null", "w", stderr) == nullptr) _exit(other_message);
    std::string message;
    const Command command = parsed(job); // CLI11 2.4 allocates in functions that must not throw
    try {
      const failing_allocations::Allocation_limit limit(k);
      run_in_process(command);
      _exit(done);
    } catch (const std::bad_alloc&) {
      _exit(out_of_memory); // main() says so
    } catch (const std::exception& e) {
      message = e.what();
    }
    _exit(message.find("memory") != std::string::npos ? out_of_memory : other_message);
  }
  int status = 0;
  if (waitpid(child, &status, 0) != child || !WIFEXITED(status)) return aborted;
  return Ending(WEXITSTATUS(status));
}

#endif

} // namespace

#ifdef __unix__

// Of what a command throws for want of memory nothing speaks of C++. Without rounds: those are in
// test_strong_guarantee, and TBB, which the command sets up for them, does not survive a failure of its own.
TEST_F(Faults, EveryAllocation)
{
  const std::vector<std::vector<std::string>> jobs = {
    {"surface", "cube.off", "out.ply", "--levels", "0"},
    {"surface", "two.obj", "out.vtp", "--levels", "0"},
    {"surface", "cube.off", "out.stl", "--levels", "0", "--repair", "--merge-points",
     "--triangulate"},
    {"curve", "p.txt", "out.txt", "--scheme", "chaikin", "--closed"}};
  for (std::vector<std::string> job : jobs) {
    job[1] = folder.file(job[1]);
    const std::string name = job[2], out = job[2] = folder.file(name);
    job.emplace_back("--quiet");
    folder.write(name, "untouched");
    const std::size_t files = folder.number_of_files();
    std::set<std::string> written;
    long k = 1;
    for (Ending ending; (ending = run_with_allocations(job, k)) != Ending::done; ++k) {
      ASSERT_EQ(ending, out_of_memory) << out << ", allocation " << k;
      ASSERT_EQ(folder.number_of_files(), files) << "allocation " << k;
      const std::string content = Temporary_folder::content(out);
      if (content == "untouched") continue;
      written.insert(content); // the failure was in the message that closes the work
      folder.write(name, "untouched");
    }
    EXPECT_GE(k, 50) << out;
    written.insert(Temporary_folder::content(out));
    EXPECT_EQ(written.size(), 1u) << "half a file";
    EXPECT_EQ(written.count("untouched"), 0u);
    EXPECT_EQ(folder.number_of_files(), files);
    std::cout << k - 1 << " allocations\n";
  }
}

// A file may grow to so many blocks of 512 bytes or of 1 KiB, then the disk is full.
TEST_F(Faults, AFullDiskAtEveryBlock)
{
  const std::string out = folder.write("out.ply", "untouched");
  const std::string arguments = "surface " + words("cube.off", out) + "--levels 4 --quiet";
  const std::size_t files = folder.number_of_files();
  std::size_t failures = 0;
  for (int blocks = 0;; blocks += 8) {
    // dash's limit is on what comes after, its own redirections included: they are made before
    const Outcome outcome = run(arguments, "ulimit -f " + std::to_string(blocks) + "; ");
    EXPECT_EQ(folder.number_of_files(), files) << blocks << " blocks";
    if (outcome.code == 0) break;
    ++failures;
    EXPECT_EQ(outcome.code, 1) << blocks << " blocks: " << outcome.err;
    ASSERT_EQ(Temporary_folder::content(out), "untouched") << blocks << " blocks";
    ASSERT_LT(blocks, 4096);
  }
  EXPECT_GE(failures, 5u);
  EXPECT_GT(Temporary_folder::content(out).size(), 10000u);
}

// SIGINT and SIGTERM from the moment on when the temporary file is there, later and later.
TEST_F(Faults, ASignalInTheMiddleOfAWrite)
{
  const std::string out = folder.file("out.obj"), old = "untouched";
  const std::string arguments = "surface " + words("cube.off", out) + "--levels 6 --quiet";
  done(run(arguments));
  const std::string expected = Temporary_folder::content(out);
  const std::size_t files = folder.number_of_files();
  int killed = 0, complete = 0;
  for (const int signal : {SIGINT, SIGTERM})
    for (int delay = 0; delay < 12; ++delay) {
      folder.write("out.obj", old);
      const int status = interrupt(arguments, signal, std::chrono::microseconds(700 * delay));
      const std::string content = Temporary_folder::content(out);
      EXPECT_EQ(folder.number_of_files(), files) << "signal " << signal << ", delay " << delay;
      EXPECT_TRUE(content == old || content == expected)
        << content.size() << " of " << expected.size();
      killed += WIFSIGNALED(status) != 0;
      complete += content == expected;
      EXPECT_TRUE(WIFSIGNALED(status) || content == expected);
    }
  EXPECT_GE(killed, 1);
  std::cout << killed << " killed, " << complete << " complete\n";
}

#endif

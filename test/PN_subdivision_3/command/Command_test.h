// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVISION_3_TEST_COMMAND_TEST_H
#define PN_SUBDIVISION_3_TEST_COMMAND_TEST_H

#include "Temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <sstream>
#include <vector>
#ifdef __unix__
#  include <chrono>
#  include <csignal>
#  include <stdexcept>
#  include <sys/wait.h>
#  include <thread>
#  include <unistd.h>

// The command, while the test goes on.
inline pid_t start_command(const std::string& arguments, const std::string& before = "")
{
  const pid_t child = fork();
  if (child == -1) throw std::runtime_error("no process");
  if (child == 0) {
    execl("/bin/sh", "sh", "-c", (before + "exec '" PN_SUBDIVIDE_COMMAND "' " + arguments).c_str(),
          nullptr);
    _exit(127);
  }
  return child;
}
#endif

inline void expect_part(const std::string& text, const std::string& part)
{
  EXPECT_NE(text.find(part), std::string::npos) << text << "\nlacks: " << part;
}
inline void expect_no_part(const std::string& text, const std::string& part)
{
  EXPECT_EQ(text.find(part), std::string::npos) << text << "\nhas: " << part;
}
// The command run as a program.
inline std::vector<std::string> lines(const std::string& text)
{
  std::istringstream in(text);
  std::vector<std::string> all;
  for (std::string line; std::getline(in, line);) all.push_back(line);
  return all;
}

// of a file of points
using Rows = std::vector<std::vector<double>>;
inline Rows rows_of(const std::string& text)
{
  Rows rows;
  for (const std::string& line : lines(text)) {
    std::istringstream in(line);
    rows.emplace_back();
    for (double x = 0; in >> x;) rows.back().push_back(x);
    EXPECT_TRUE(in.eof()) << line;
  }
  return rows;
}

class Command_test : public testing::Test
{
protected:
  struct Outcome
  {
    int code;
    std::string out, err;
  };
  using Values_by_name = std::map<std::string, std::vector<double>>;

  Outcome run(const std::string& arguments, const std::string& before = "") const
  {
    const std::string out = work.file("out"), err = work.file("err");
    const int status = std::system(
      (before + "'" + program + "' " + arguments + " >'" + out + "' 2>'" + err + "'").c_str());
#ifdef __unix__
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
#else
    const int code = status;
#endif
    return {code, Temporary_folder::content(out), Temporary_folder::content(err)};
  }

  // names that do not begin with a folder are those of files of the user's
  std::string path(const std::string& name) const
  {
    return name.substr(0, 1) == "/" ? name : folder.file(name);
  }
  std::string words(const std::string& input, const std::string& output) const
  {
    return "'" + path(input) + "' '" + path(output) + "' ";
  }
  std::string content(const std::string& name) const
  {
    return Temporary_folder::content(path(name));
  }
  // the columns of the vertices of a text PLY, read without the command's own reader
  Values_by_name columns_of(const std::string& file) const
  {
    std::istringstream in(content(file));
    std::vector<std::string> names;
    std::size_t vertices = 0;
    for (std::string line; std::getline(in, line) && line != "end_header";) {
      std::istringstream words(line);
      std::string word, type, name;
      words >> word >> type >> name;
      if (word == "element" && type == "vertex") vertices = std::stoul(name);
      if (word == "property" && type != "list") names.push_back(name);
    }
    Values_by_name columns;
    for (std::size_t v = 0; v < vertices; ++v)
      for (const std::string& name : names) {
        double x = 0;
        EXPECT_TRUE(in >> x);
        columns[name].push_back(x);
      }
    return columns;
  }
  static std::string data(const std::string& name)
  {
    return PN_DATA_DIR "/" + name;
  }

  Outcome surface(const std::string& input, const std::string& output,
                  const std::string& options = "") const
  {
    return run("surface " + words(input, output) + options);
  }
  Outcome curve(const std::string& input, const std::string& output,
                const std::string& options = "") const
  {
    return run("curve " + words(input, output) + options);
  }
  // of a call that succeeds
  static Outcome done(const Outcome& outcome)
  {
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return outcome;
  }

#ifdef __unix__
  // The status of the command that gets the signal some time after a file more is in the folder.
  int interrupt(const std::string& arguments, int signal, std::chrono::microseconds delay) const
  {
    const std::size_t files = folder.number_of_files();
    const pid_t child = start_command(arguments);
    int status = 0;
    pid_t ended = 0;
    while (folder.number_of_files() == files && ended == 0)
      ended = waitpid(child, &status, WNOHANG);
    if (ended != 0) return status;
    std::this_thread::sleep_for(delay);
    kill(child, signal);
    EXPECT_EQ(waitpid(child, &status, 0), child);
    return status;
  }
#endif

  static void expect_one_line(const Outcome& outcome, int code, const std::string& part)
  {
    EXPECT_EQ(outcome.code, code) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_EQ(outcome.err.rfind("pn_subdivide: ", 0), 0u) << outcome.err;
    expect_part(outcome.err, part);
    EXPECT_EQ(outcome.out, "");
  }

  // An existing output must stay as it is, a missing one missing, and no other file may appear.
  void expect_failure(const std::string& command_and_input, const std::string& extension,
                      const std::string& options, int code, const std::string& part) const
  {
    SCOPED_TRACE(options);
    const std::string old_file = folder.write("old." + extension, "untouched");
    const std::size_t files = folder.number_of_files();
    for (const std::string& output : {old_file, folder.file("new." + extension)})
      expect_one_line(run(command_and_input + " '" + output + "' " + options), code, part);
    EXPECT_EQ(Temporary_folder::content(old_file), "untouched");
    EXPECT_EQ(folder.number_of_files(), files);
  }

  // refused in one line that has all parts; the output stays as it was
  void expect_refusal(const std::string& input, const std::string& output,
                      const std::string& options, const std::vector<std::string>& parts,
                      int code = 2) const
  {
    folder.write(output, "old");
    for (const std::string& part : parts)
      expect_one_line(surface(input, output, options), code, part);
    EXPECT_EQ(content(output), "old");
  }

  static bool contains(const std::string& text, const std::string& part)
  {
    return text.find(part) != std::string::npos;
  }
  static std::size_t number_of(const std::string& text, const std::string& part)
  {
    std::size_t n = 0;
    for (std::size_t i = text.find(part); i != std::string::npos; i = text.find(part, i + 1)) ++n;
    return n;
  }
  static bool takes_triangles(const std::string& scheme)
  {
    return contains(scheme, "loop") || scheme == "butterfly" || scheme == "sqrt3" ||
           scheme == "midpoint";
  }

  static constexpr const char* cube_off =
    "OFF\n8 6 0\n-1 -1 -1\n1 -1 -1\n1 1 -1\n-1 1 -1\n-1 -1 1\n1 -1 1\n1 1 1\n"
    "-1 1 1\n4 3 2 1 0\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";

  static constexpr const char* octahedron_off =
    "OFF\n6 8 0\n1 0 0\n0 1 0\n0 0 1\n-1 0 0\n0 -1 0\n0 0 -1\n3 0 1 2\n3 1 3 2\n3 3 4 2\n3 4 0 2\n"
    "3 1 0 5\n3 3 1 5\n3 4 3 5\n3 0 4 5\n";

  std::string program = PN_SUBDIVIDE_COMMAND;
  Temporary_folder folder; // of the user
  Temporary_folder work;   // of these tests
};

#endif // PN_SUBDIVISION_3_TEST_COMMAND_TEST_H

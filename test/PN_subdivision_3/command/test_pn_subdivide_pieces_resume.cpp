// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// --resume goes on from what is on the disk, and makes again what is not as it was written.

#include "Pieces_test.h"

#ifdef __unix__

#  include <algorithm>
#  include <chrono>
#  include <csignal>
#  include <cstddef>
#  include <filesystem>
#  include <fstream>
#  include <functional>
#  include <string>
#  include <sys/wait.h>
#  include <thread>
#  include <utility>
#  include <vector>

namespace fs = std::filesystem;

namespace {

// that are finished
std::size_t number_of_pieces(const std::string& done)
{
  std::size_t n = 0;
  for (int i = 0; i < 40; ++i) n += fs::exists(done + "/" + std::to_string(i)) ? 1 : 0;
  return n;
}

// Starts the command, and kills it as nothing can be done about when some pieces are finished.
void kill_in_the_middle(const std::string& arguments, const std::string& done)
{
  constexpr std::size_t pieces = 5;
  const pid_t child = start_command(arguments + " 2>/dev/null");
  int status = 0;
  while (number_of_pieces(done) < pieces && waitpid(child, &status, WNOHANG) == 0)
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  kill(child, SIGKILL);
  waitpid(child, &status, 0);
  ASSERT_TRUE(WIFSIGNALED(status)) << "it was faster than the test";
  ASSERT_GE(number_of_pieces(done), pieces);
}

using Change = std::function<void(std::string&)>;

const std::vector<std::pair<std::string, Change>> changes = {
  {"nothing", [](std::string&) {}},
  {"cut in half", [](std::string& s) { s.resize(s.size() / 2); }},
  {"a byte too short", [](std::string& s) { s.pop_back(); }},
  {"empty", [](std::string& s) { s.clear(); }},
  {"too long", [](std::string& s) { s += s.substr(0, 1000) + "\n"; }},
  {"overwritten at the beginning", [](std::string& s) { s.replace(0, 9, "something"); }},
  {"zeros",
   [](std::string& s) { std::fill(s.begin() + std::ptrdiff_t(s.size() / 3), s.end(), '\0'); }},
  {"single bits", [](std::string& s) {
     for (std::size_t i = s.size() / 4; i < s.size(); i += 97) s[i] = char(s[i] ^ 1);
   }}};

class Resume : public Pieces
{
protected:
  static constexpr const char* job = "--levels 5 --pieces 40";

  std::string arguments(const std::string& out) const
  {
    return in_out("loop", out) + job + " --resume";
  }

  // What a run that was killed leaves is kept in a folder of the tests.
  void interrupt(const std::string& out)
  {
    kill_in_the_middle(arguments(out), folder.file(out + ".part.done"));
    fs::remove_all(work.file("state"));
    fs::create_directories(work.file("state"));
    fs::copy(folder.file(""), work.file("state"),
             fs::copy_options::recursive | fs::copy_options::overwrite_existing);
    clear();
  }
  void restore()
  {
    clear();
    fs::copy(work.file("state"), folder.file(""), fs::copy_options::recursive);
  }
  void clear()
  {
    for (const fs::directory_entry& entry : fs::directory_iterator(folder.file("")))
      fs::remove_all(entry.path());
  }

  void change(const std::string& name, const Change& f) const
  {
    std::string s = content(name);
    f(s);
    folder.write(name, s);
  }

  std::string pieces_of(const std::string& name) const
  {
    std::string all = content(name + ".pvtp");
    for (int i = 0; i < 40; ++i)
      all += content(name + "_pieces/piece_" + std::to_string(i) + ".vtp");
    return all;
  }
};

} // namespace

TEST_F(Pieces, ResumeAfterAFullDisk)
{
  for (const std::string scheme : {"catmull-clark", "kobbelt"}) {
    const bool is_creased = scheme == "catmull-clark";
    const std::string sharp = is_creased ? " --sharp angle:25 --border fixed" : "";
    const std::string expected = whole(scheme, "--levels 6" + sharp);
    const std::string job = in_out(scheme, "out.ply") + "--levels 6 --pieces 40 --resume";
    const std::string arguments = job + sharp;
    kill_in_the_middle(arguments, folder.file("out.ply.part.done"));
    const std::string half = std::to_string(expected.size() / 1024);
    expect_one_line(run(arguments, "ulimit -f " + half + "; "), 1, "out.ply");
    EXPECT_FALSE(fs::exists(folder.file("out.ply")));
    // other options, and a run that does not know of it
    expect_one_line(run(in_out(scheme, "out.ply") + "--levels 4 --pieces 40 --resume"), 1,
                    "out.ply.part.done");
    if (is_creased)
      for (const char* const other : {"", " --sharp angle:25 --border curve",
                                      " --sharp angle:25 --sharpness 3 --border fixed"})
        expect_one_line(run(job + other), 1, "out.ply.part.done");
    expect_one_line(run(in_out(scheme, "out.ply") + "--levels 6 --pieces 40"), 1, "--resume");
    done(run(arguments));
    EXPECT_TRUE(content("out.ply") == expected);
    EXPECT_EQ(folder.number_of_files(), 4u);
    fs::remove(folder.file("out.ply"));
  }
}

TEST_F(Resume, OfADamagedPly)
{
  const std::string expected = whole("loop", job);
  interrupt("out.ply");
  const auto expect_whole_file = [&](const std::string& what) {
    done(run(arguments("out.ply")));
    EXPECT_TRUE(content("out.ply") == expected) << what;
    EXPECT_EQ(folder.number_of_files(), 4u) << what;
  };
  for (const auto& [what, damage] : changes) {
    restore();
    change("out.ply.part", damage);
    expect_whole_file(what);
  }
  restore();
  fs::remove(folder.file("out.ply.part"));
  expect_whole_file("gone");
}

TEST_F(Resume, OfADamagedPvtp)
{
  done(run(in_out("loop", "out.pvtp") + job));
  const std::string expected = pieces_of("out");
  fs::remove(folder.file("out.pvtp"));
  fs::remove_all(folder.file("out_pieces"));
  interrupt("out.pvtp");
  const auto expect_all_pieces = [&](const std::string& what) {
    done(run(arguments("out.pvtp")));
    EXPECT_TRUE(pieces_of("out") == expected) << what;
    EXPECT_EQ(folder.number_of_files(), 4u) << what;
  };
  for (const auto& [what, damage] : changes) {
    restore();
    for (const std::string i : {"0", "2", "3"}) change("out.pvtp.part/piece_" + i + ".vtp", damage);
    expect_all_pieces(what);
  }
  restore();
  fs::remove(folder.file("out.pvtp.part/piece_1.vtp"));
  expect_all_pieces("one is gone");
  restore();
  fs::copy(folder.file("out.pvtp.part/piece_1.vtp"), folder.file("out.pvtp.part/piece_2.vtp"),
           fs::copy_options::overwrite_existing);
  expect_all_pieces("another one's");
  restore();
  fs::remove_all(folder.file("out.pvtp.part"));
  expect_all_pieces("all are gone");
}

// If the file that names the job is damaged nobody knows what can be continued; nothing is changed then.
TEST_F(Resume, OfDamagedReceipts)
{
  for (const std::string out : {"out.ply", "out.pvtp"}) {
    const std::string complete = in_out("loop", out) + job;
    done(run(complete));
    const std::string expected = out == "out.ply" ? content(out) : pieces_of("out");
    clear();
    SetUp();
    interrupt(out);
    const auto expect_whole = [&](const std::string& what) {
      // a piece whose receipt is damaged, and one whose receipt is not
      if (out == "out.pvtp") fs::remove(folder.file("out.pvtp.part/piece_2.vtp"));
      done(run(arguments(out)));
      EXPECT_TRUE((out == "out.ply" ? content(out) : pieces_of("out")) == expected) << what;
      EXPECT_EQ(folder.number_of_files(), out == "out.ply" ? 3u : 4u) << what;
    };
    for (const auto& [what, damage] : changes) {
      restore();
      for (const std::string i : {"0", "2", "3"}) change(out + ".part.done/" + i, damage);
      expect_whole(what);
      if (what == "nothing") continue;
      restore();
      change(out + ".part.done/job", damage);
      expect_one_line(run(arguments(out)), 1, out + ".part");
      EXPECT_TRUE(fs::exists(folder.file(out + ".part"))) << what;
    }
    restore();
    for (const std::string i : {"0", "2", "3"}) fs::remove(folder.file(out + ".part.done/" + i));
    expect_whole("some are gone");
    restore();
    fs::copy(folder.file(out + ".part.done/1"), folder.file(out + ".part.done/30"),
             fs::copy_options::overwrite_existing);
    expect_whole("another one's");
    clear();
    SetUp();
  }
}

// What is finished is not made again: its files keep their time.
TEST_F(Resume, TakesFinishedPiecesAsTheyAre)
{
  interrupt("out.pvtp");
  restore();
  const std::size_t finished = number_of_pieces(folder.file("out.pvtp.part.done"));
  const auto long_ago = fs::file_time_type::clock::now() - std::chrono::hours(24);
  for (std::size_t i = 0; i < finished; ++i)
    fs::last_write_time(folder.file("out.pvtp.part/piece_" + std::to_string(i) + ".vtp"), long_ago);
  done(run(arguments("out.pvtp")));
  std::size_t kept = 0;
  for (int i = 0; i < 40; ++i)
    kept += fs::last_write_time(folder.file("out_pieces/piece_" + std::to_string(i) + ".vtp")) <
            long_ago + std::chrono::hours(1);
  EXPECT_EQ(kept, finished);
}

// The same corners, divided into other faces, are other data.
TEST_F(Resume, OfOtherFaces)
{
  const std::string begin = "OFF\n7 2 0\n0 0 0\n1 0 0\n1 1 0\n5 5 0\n6 5 0\n6 6 0\n5 6 1\n";
  const std::string scheme =
    in_out("catmull-clark", "out.ply") + "--levels 8 --linear --pieces 40 --resume";
  folder.write("quads.off", begin + "3 0 1 2\n4 3 4 5 6\n");
  kill_in_the_middle(scheme, folder.file("out.ply.part.done"));
  folder.write("quads.off", begin + "4 0 1 2 3\n3 4 5 6\n");
  expect_one_line(run(scheme), 1, "other data");
}

#endif

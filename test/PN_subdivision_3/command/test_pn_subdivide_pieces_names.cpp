// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// What others have in the folder of the output stays: a run in pieces takes no name that is taken.

#include "Pieces_test.h"

namespace fs = std::filesystem;

namespace {

class Pieces_names : public Pieces
{
protected:
  // name -> content; of folders "/"
  std::map<std::string, std::string> everything() const
  {
    std::map<std::string, std::string> result;
    const fs::path root = folder.file("");
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root))
      result[entry.path().lexically_relative(root).string()] =
        entry.is_directory() ? "/" : Temporary_folder::content(entry.path().string());
    return result;
  }

  void put(const std::string& name, const std::string& what) const
  {
    if (what == "/" || what == "/file") fs::create_directories(folder.file(name));
    if (what == "/") return;
    folder.write(what == "/file" ? name + "/mine" : name, what);
  }

  void expect_refusal(const std::string& out, const std::string& options, const std::string& name)
  {
    const auto before = everything();
    expect_one_line(run(in_out("catmull-clark", out) + "--levels 3 --pieces 5 " + options), 1,
                    name);
    EXPECT_TRUE(everything() == before) << out << " " << options << " " << name;
  }
};

std::string unescaped(std::string s)
{
  const std::vector<std::pair<std::string, std::string>> characters = {
    {"&lt;", "<"},   {"&gt;", ">"},   {"&quot;", "\""}, {"&#9;", "\t"},
    {"&#10;", "\n"}, {"&#13;", "\r"}, {"&amp;", "&"}};
  for (const auto& [name, character] : characters)
    for (std::size_t i = 0; (i = s.find(name, i)) != std::string::npos; i += character.size())
      s.replace(i, name.size(), character);
  return s;
}

std::vector<std::string> sources(const std::string& index)
{
  const std::string begin = "<Piece Source=\"";
  std::vector<std::string> result;
  for (std::size_t i = index.find(begin); i != std::string::npos; i = index.find(begin, i)) {
    i += begin.size();
    result.push_back(index.substr(i, index.find('"', i) - i));
  }
  return result;
}

} // namespace

// An index names files that are there, whatever its own name.
TEST_F(Pieces_names, OfPvtp)
{
  for (const std::string name :
       {"plain", "Geh\xc3\xa4use", "\xe6\x9b\xb2\xe9\x9d\xa2", "\xf0\x9f\x98\x80", "a&b", "a<b>c",
        "a\"b\"", "&amp;", "tab\tin", "line\nend", "100% #1 ?", "e\xcc\x81"}) {
    const Outcome outcome = run(in_out("catmull-clark", name + ".pvtp") + "--levels 2 --pieces 3");
    ASSERT_EQ(outcome.code, 0) << name << outcome.err;
    const std::string index = content(name + ".pvtp");
    EXPECT_EQ(sources(index).size(), 3u) << name;
    for (const std::string& source : sources(index)) {
      EXPECT_EQ(source.find_first_of("<>\t\n"), std::string::npos) << name;
      EXPECT_TRUE(fs::exists(folder.file(unescaped(source)))) << name << ": " << source;
    }
  }
}

// control characters, and what is no UTF-8: another encoding, a longer form, half of a pair, beyond the end
TEST_F(Pieces_names, OfPvtpThatXmlDoesNotHave)
{
  for (const std::string name :
       {"a\x01", "a\x1b[1m", "Geh\xe4use", "a\xc0\xaf", "a\xe0\x80\xaf", "a\xf0\x80\x80\xaf",
        "a\xed\xa0\x80", "a\xf4\x90\x80\x80", "a\xc3"})
    expect_refusal(name + ".pvtp", "", "name");
}

TEST_F(Pieces_names, ThatAreTaken)
{
  for (const std::string out : {"out.ply", "out.pvtp"})
    for (const std::string what : {"", "mine", "/", "/file"})
      for (const std::string name : {".part", ".part.done"})
        for (const std::string options : {"", "--resume"}) {
          if (name == ".part.done" && options.empty()) continue;
          put(out + name, what);
          expect_refusal(out, options, out + name);
          fs::remove_all(folder.file(out + name));
        }
}

// A run without --resume does not look at it.
TEST_F(Pieces_names, ADoneFileOfOthers)
{
  for (const std::string out : {"out.ply", "out.pvtp"}) {
    put(out + ".part.done", "mine");
    done(run(in_out("loop", out) + "--levels 2 --pieces 3"));
    EXPECT_EQ(content(out + ".part.done"), "mine");
  }
}

TEST_F(Pieces_names, OfFoldersThatAreTaken)
{
  const std::string again = in_out("catmull-clark", "out.pvtp") + "--levels 2 --pieces 3";
  for (const std::string what : {"", "mine", "/", "/file"})
    for (const std::string options : {"", "--resume"}) {
      put("out_pieces.old", what);
      done(run(again)); // it is not in the way
      expect_refusal("out.pvtp", options, "out_pieces.old");
      fs::remove_all(folder.file("out_pieces.old"));
      done(run(again));
      EXPECT_FALSE(fs::exists(folder.file("out_pieces.old")));

      fs::remove_all(folder.file("out_pieces"));
      if (what != "/") {
        put("out_pieces", what);
        expect_refusal("out.pvtp", options, "out_pieces");
        fs::remove_all(folder.file("out_pieces"));
      }
      put("out_pieces/piece_1.vtp", "/file");
      expect_refusal("out.pvtp", options, "out_pieces");
      fs::remove_all(folder.file("out_pieces"));
    }
}

#ifdef __unix__

TEST_F(Pieces_names, OfSeveralRunsAtOnce)
{
  const std::string expected = whole("loop", "--levels 5");
  for (const std::string out : {"out.ply", "out.pvtp"}) {
    std::string script;
    for (const std::string i : {"1", "2", "3"})
      script += "('" PN_SUBDIVIDE_COMMAND "' " + in_out("loop", out) +
                "--levels 5 --pieces 30 2>'" + work.file("err" + i) + "'; echo $? >'" +
                work.file("code" + i) + "') & ";
    ASSERT_EQ(std::system((script + "wait").c_str()), 0);
    int successes = 0;
    for (const std::string i : {"1", "2", "3"}) {
      const std::string err = Temporary_folder::content(work.file("err" + i));
      const bool succeeds = Temporary_folder::content(work.file("code" + i)) == "0\n";
      successes += succeeds ? 1 : 0;
      EXPECT_EQ(std::count(err.begin(), err.end(), '\n'), succeeds ? 0 : 1) << err;
      if (!succeeds) {
        expect_part(err, folder.file("out"));
      }
    }
    EXPECT_GE(successes, 1);
    if (out == "out.ply") {
      EXPECT_TRUE(content("out.ply") == expected);
    }
    EXPECT_EQ(folder.number_of_files(), out == "out.ply" ? 4u : 5u);
    fs::remove(folder.file(out));
  }
}

#endif

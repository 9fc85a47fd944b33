// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVISION_3_TEST_PIECES_TEST_H
#define PN_SUBDIVISION_3_TEST_PIECES_TEST_H

#include "File_test.h"
#include "Part_files.h"

class Pieces : public Command_test
{
protected:
  // A wavy grid with a hole in it, in quads or triangles, and a vertex without faces.
  void SetUp() override
  {
    using pn_subdivide::Part;
    Part quads = pn_subdivide::grid(5, 5, [](int i, int j) { return i * j % 7 / 10.; });
    quads.points.push_back({9, 9, 9});
    Part triangles{quads.points, {}};
    for (std::size_t f = 0; f < 25; ++f) {
      if (f == 13) continue; // the hole
      const auto& q = quads.faces[f];
      if (f % 2 == 0)
        triangles.faces.insert(triangles.faces.end(), {{q[0], q[1], q[2]}, {q[0], q[2], q[3]}});
      else
        triangles.faces.insert(triangles.faces.end(), {{q[0], q[1], q[3]}, {q[1], q[2], q[3]}});
    }
    quads.faces.erase(quads.faces.begin() + 13);
    folder.write("quads.off", quads.off());
    folder.write("triangles.off", triangles.off());
  }

  static std::string input_of(const std::string& scheme)
  {
    return takes_triangles(scheme) ? "triangles.off" : "quads.off";
  }
  std::string job(const std::string& scheme, const std::string& in, const std::string& out) const
  {
    return "surface " + words(in, out) + "--scheme " + scheme + " ";
  }
  std::string in_out(const std::string& scheme, const std::string& out) const
  {
    return job(scheme, input_of(scheme), out) + "--quiet ";
  }

  std::string whole(const std::string& scheme, const std::string& options)
  {
    done(run(in_out(scheme, "whole.ply") + options));
    return content("whole.ply");
  }

  void expect_whole(const std::string& scheme, const std::string& options, const std::string& more,
                    const std::string& before = "")
  {
    const std::string expected = whole(scheme, options);
    std::filesystem::remove(folder.file("out.ply"));
    const Outcome outcome = done(run(in_out(scheme, "out.ply") + options + " " + more, before));
    EXPECT_EQ(outcome.err, "");
    EXPECT_TRUE(content("out.ply") == expected) << scheme << " " << options << " " << more;
    EXPECT_EQ(folder.number_of_files(), 4u); // the two controls and the two results
  }
  std::string piece(int i) const
  {
    return content("out_pieces/piece_" + std::to_string(i) + ".vtp");
  }
  // the rows of an array of out.pvtp's i-th piece are those of whole.vtp under their numbers
  template <class T>
  void expect_rows(int i, const std::string& name, std::size_t components,
                   const std::string& numbers = "GlobalPointIds", bool may_be_missing = false) const
  {
    using pn_subdivide::raw_array;
    const auto rows = raw_array<std::int64_t>(piece(i), numbers);
    const auto values = raw_array<T>(piece(i), name),
               whole = raw_array<T>(content("whole.vtp"), name);
    ASSERT_FALSE(rows.empty());
    ASSERT_EQ(values.size(), may_be_missing && whole.empty() ? 0 : components * rows.size())
      << name;
    for (std::size_t k = 0; k < values.size(); ++k)
      ASSERT_EQ(values[k], whole[components * std::size_t(rows[k / components]) + k % components])
        << name;
  }
  // The same file, with as many notes and warnings; is one of them of several normals?
  bool expect_same(const std::string& scheme, const std::string& in, const std::string& options,
                   const std::vector<std::string>& numbers_of_pieces)
  {
    const Outcome whole = done(run(job(scheme, in, "whole.ply") + options));
    const bool warns = contains(whole.err, "several normals");
    for (const std::string& pieces : numbers_of_pieces) {
      const Outcome outcome =
        done(run(job(scheme, in, "out.ply") + options + " --pieces " + pieces));
      EXPECT_TRUE(content("out.ply") == content("whole.ply"))
        << scheme << " " << in << " " << options << " " << pieces;
      EXPECT_EQ(number_of(outcome.err, "\n"), number_of(whole.err, "\n"))
        << whole.err << outcome.err;
      EXPECT_EQ(contains(outcome.err, "several normals"), warns) << scheme << options;
    }
    return warns;
  }
};

#endif // PN_SUBDIVISION_3_TEST_PIECES_TEST_H

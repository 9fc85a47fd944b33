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

  std::string in_out(const std::string& scheme, const std::string& out) const
  {
    return "surface '" + folder.file(takes_triangles(scheme) ? "triangles.off" : "quads.off") +
           "' '" + folder.file(out) + "' --quiet --scheme " + scheme + " ";
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
  // where both may warn of several normals
  void expect_whole_with_warning(const std::string& scheme, const std::string& options)
  {
    const std::string expected = whole(scheme, options);
    done(run(in_out(scheme, "out.ply") + options + " --pieces 7"));
    EXPECT_TRUE(content("out.ply") == expected) << scheme << " " << options;
  }
};

#endif // PN_SUBDIVISION_3_TEST_PIECES_TEST_H

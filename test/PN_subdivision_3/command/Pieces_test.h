// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVISION_3_TEST_PIECES_TEST_H
#define PN_SUBDIVISION_3_TEST_PIECES_TEST_H

#include "Command_test.h"

#include <cstddef>
#include <cstdint>
#include <cstring>

// the numbers of an array of a VTP file with raw data
template <class T>
std::vector<T> raw_array(const std::string& vtp, const std::string& name)
{
  const std::size_t tag = vtp.find("Name=\"" + name + "\"");
  if (tag == std::string::npos) return {};
  const std::size_t offset = std::stoul(vtp.substr(vtp.find("offset=\"", tag) + 8));
  const std::size_t begin = vtp.find("\n_", vtp.find("<AppendedData")) + 2 + offset;
  std::uint64_t bytes = 0;
  std::memcpy(&bytes, vtp.data() + begin, sizeof bytes);
  std::vector<T> values(bytes / sizeof(T));
  std::memcpy(values.data(), vtp.data() + begin + sizeof bytes, bytes);
  return values;
}

class Pieces : public Command_test
{
protected:
  // A wavy grid with a hole in it, in quads or triangles, and a vertex without faces.
  void SetUp() override
  {
    std::string points, quads, triangles;
    const auto name = [](int i, int j) { return std::to_string(i * 6 + j); };
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j)
        points +=
          std::to_string(i) + " " + std::to_string(j) + " 0." + std::to_string(i * j % 7) + "\n";
    points += "9 9 9\n";
    int faces = 0;
    for (int i = 0; i < 5; ++i)
      for (int j = 0; j < 5; ++j) {
        if (i == 2 && j == 3) continue;
        const std::string a = name(i, j), b = name(i + 1, j), c = name(i + 1, j + 1),
                          d = name(i, j + 1);
        quads += "4 " + a + " " + b + " " + c + " " + d + "\n";
        triangles += (i + j) % 2 == 0
                       ? "3 " + a + " " + b + " " + c + "\n3 " + a + " " + c + " " + d
                       : "3 " + a + " " + b + " " + d + "\n3 " + b + " " + c + " " + d;
        triangles += "\n";
        ++faces;
      }
    const auto off = [&](int number, const std::string& lines) {
      return "OFF\n37 " + std::to_string(number) + " 0\n" + points + lines;
    };
    folder.write("quads.off", off(faces, quads));
    folder.write("triangles.off", off(2 * faces, triangles));
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

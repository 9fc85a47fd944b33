// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// CGAL's examples of Subdivision_method_3 as they are, and with this package's include and namespace: they write the same.

#include "Temporary_folder.h"

#include <CGAL/PN_cgal_masks_3/Subdivision_method_3.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Timer.h>
#include <CGAL/boost/graph/graph_traits_Surface_mesh.h>
#include <CGAL/subdivision_method_3.h>

#include <boost/lexical_cast.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iostream>
#include <set>
#include <sstream>
#include <vector>

// Unpacked, and changed, by the build; what they include is included above.
#if __has_include(<changed/Loop_subdivision.cpp>)
#  define PN_TEST_WITH_EXAMPLES
namespace cgal_CatmullClark {
#  include <Subdivision_method_3/CatmullClark_subdivision.cpp>
}
namespace changed_CatmullClark {
#  include <changed/CatmullClark_subdivision.cpp>
}
namespace cgal_Customized {
#  include <Subdivision_method_3/Customized_subdivision.cpp>
}
namespace changed_Customized {
#  include <changed/Customized_subdivision.cpp>
}
namespace cgal_DooSabin {
#  include <Subdivision_method_3/DooSabin_subdivision.cpp>
}
namespace changed_DooSabin {
#  include <changed/DooSabin_subdivision.cpp>
}
namespace cgal_Loop {
#  include <Subdivision_method_3/Loop_subdivision.cpp>
}
namespace changed_Loop {
#  include <changed/Loop_subdivision.cpp>
}
namespace cgal_Sqrt3 {
#  include <Subdivision_method_3/Sqrt3_subdivision.cpp>
}
namespace changed_Sqrt3 {
#  include <changed/Sqrt3_subdivision.cpp>
}
#endif

#ifdef PN_TEST_WITH_EXAMPLES
namespace {

using Main = std::function<int(int, char**)>;

std::string output_of(const Main& main, const std::string& rounds, std::string input,
                      std::string output)
{
  std::string name = "example", number = rounds;
  char* arguments[] = {name.data(), number.data(), input.data(), output.data(), nullptr};
  EXPECT_EQ(main(4, arguments), 0);
  return Temporary_folder::content(output);
}

struct Off
{
  explicit Off(const std::string& text)
  {
    std::istringstream in(text);
    std::string word;
    std::size_t vertices = 0, number = 0, edges = 0;
    in >> word >> vertices >> number >> edges;
    coordinates.resize(3 * vertices);
    for (double& x : coordinates) in >> x;
    faces.resize(number);
    for (auto& face : faces) {
      std::size_t degree = 0;
      in >> degree;
      face.resize(degree);
      for (std::size_t& v : face) in >> v;
    }
    EXPECT_TRUE(in);
  }
  // without the order of the faces, and where they begin
  void sort()
  {
    for (auto& f : faces) std::rotate(f.begin(), std::min_element(f.begin(), f.end()), f.end());
    std::sort(faces.begin(), faces.end());
  }

  std::multiset<std::size_t> degrees() const
  {
    std::multiset<std::size_t> result;
    for (const auto& f : faces) result.insert(f.size());
    return result;
  }
  std::multiset<std::array<long, 3>> points() const
  {
    std::multiset<std::array<long, 3>> result;
    for (std::size_t i = 0; i < coordinates.size(); i += 3)
      result.insert({std::lround(1e4 * coordinates[i]), std::lround(1e4 * coordinates[i + 1]),
                     std::lround(1e4 * coordinates[i + 2])});
    return result;
  }

  std::vector<double> coordinates;
  std::vector<std::vector<std::size_t>> faces;
};

// the coordinates by units in the last of the six digits that are written
void expect_same(Off a, Off b, bool in_order)
{
  ASSERT_EQ(a.coordinates.size(), b.coordinates.size());
  ASSERT_GT(a.coordinates.size(), 30u);
  for (std::size_t i = 0; i < a.coordinates.size(); ++i)
    ASSERT_NEAR(a.coordinates[i], b.coordinates[i], 2e-6) << "coordinate " << i;
  if (!in_order) a.sort(), b.sort();
  EXPECT_EQ(a.faces, b.faces);
}

void expect_same(const Main& cgal, const Main& changed, bool is_dual = false)
{
  const Temporary_folder folder;
  const std::string open =
    folder.write("open.off", "OFF\n6 6 0\n1 0 0\n0 1 0\n-1 0 0.2\n0 -1 0\n0 0 1\n0 0.1 -1\n"
                             "3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n3 1 0 5\n3 2 1 5\n");
  const std::string closed =
    folder.write("closed.off", "OFF\n5 6 0\n1 0 0\n-0.4 0.9 0\n-0.5 -0.8 0.1\n0 0 1\n0.1 0 -1.2\n"
                               "3 0 1 3\n3 1 2 3\n3 2 0 3\n3 1 0 4\n3 2 1 4\n3 0 2 4\n");
  for (const std::string& input : {open, closed})
    for (const char* rounds : {"1", "2", "3"}) {
      SCOPED_TRACE(input + ", rounds " + rounds);
      const Off a(output_of(cgal, rounds, input, folder.file("cgal.off")));
      const Off b(output_of(changed, rounds, input, folder.file("changed.off")));
      // at a border dual vertices begin where the vertex of the mesh read does, here at the border
      if (is_dual && input == open) {
        EXPECT_EQ(a.degrees(), b.degrees());
        EXPECT_EQ(a.points(), b.points());
      } else
        expect_same(a, b, !is_dual);
    }
}

} // namespace

TEST(Examples_of_cgal, WriteTheSame)
{
  expect_same(cgal_CatmullClark::main, changed_CatmullClark::main);
  expect_same(cgal_Customized::main, changed_Customized::main);
  expect_same(cgal_DooSabin::main, changed_DooSabin::main, true);
  expect_same(cgal_Loop::main, changed_Loop::main);
  expect_same(cgal_Sqrt3::main, changed_Sqrt3::main);
}
#else
TEST(Examples_of_cgal, AreNotFound)
{
  GTEST_SKIP() << "left out: CGAL's examples not found (Debian: examples.tar.gz of libcgal-dev)";
}
#endif

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
// `pn_subdivide curve --scheme levels:FILE`: masks that differ from round to round, against calls with the
// schemes that they are.

#include "Command_test.h"

namespace {

const char* const cubic = "-2 0.125 0.5 0.75 0.5 0.125\n";
const char* const four_point = "-3 -0.0625 0 0.5625 1 0.5625 0 -0.0625\n";
const char* const polygon = "0 0 -0.6 -0.8\n4 -1 0 -1\n6 2 1 0\n5 5 0.6 0.8\n1 4 -0.8 0.6\n";

std::vector<double> numbers(const std::string& text)
{
  std::istringstream in(text);
  std::vector<double> all;
  for (double x = 0; in >> x;) all.push_back(x);
  EXPECT_TRUE(in.eof()) << text;
  return all;
}

class Level_masks : public Command_test
{
protected:
  std::string refined(const std::string& control, const std::string& options) const
  {
    SCOPED_TRACE(options);
    done(curve(folder.write("polygon.txt", control), "curve.txt", "--quiet " + options));
    return content("curve.txt");
  }

  std::string by_masks(const std::string& control, const std::string& masks,
                       const std::string& options) const
  {
    return refined(control,
                   "--scheme 'levels:" + folder.write("masks.txt", masks) + "' " + options);
  }

  void expect_near(const std::string& found, const std::string& expected) const
  {
    const std::vector<double> a = numbers(found), b = numbers(expected);
    ASSERT_EQ(a.size(), b.size());
    ASSERT_FALSE(a.empty());
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], 1e-13) << "number " << i;
  }

  void expect_refusal(const std::string& masks, const std::string& options, int code,
                      const std::string& part) const
  {
    SCOPED_TRACE(options + "\n" + masks);
    expect_one_line(curve(folder.write("polygon.txt", polygon), "none.txt",
                          "--scheme 'levels:" + folder.write("masks.txt", masks) + "' " + options),
                    code, part);
  }
};

TEST_F(Level_masks, OfOneLineAreTheScheme)
{
  for (const std::string options : {"--closed --levels 3", "--levels 2", "--end none --levels 2",
                                    "--closed --linear --levels 3", "--closed --levels 2 --limit",
                                    "--closed --roundness 0.5 --levels 2"})
    expect_near(by_masks(polygon, std::string("# one for all\n\n") + cubic, options),
                refined(polygon, "--scheme bspline:3 " + options));
  const char* const chaikin = "-1 0.25 0.75 0.75 0.25\n";
  for (const std::string options : {"--closed --levels 3", "--levels 2"})
    expect_near(by_masks(polygon, chaikin, options),
                refined(polygon, "--scheme chaikin " + options));
}

TEST_F(Level_masks, AreTakenRoundByRound)
{
  const std::string first = refined(polygon, "--scheme bspline:3 --closed --levels 1");
  const std::string all = refined(first, "--scheme 4-point --closed --levels 3");
  expect_near(by_masks(polygon, std::string(cubic) + four_point, "--closed --levels 4"), all);
  const std::string limit =
    refined(first, "--scheme 4-point --closed --levels 3 --limit --curve-normals");
  expect_near(by_masks(polygon, std::string(cubic) + four_point,
                       "--closed --levels 4 --limit --curve-normals"),
              limit);
}

// Limits of all rounds are points of one curve.
TEST_F(Level_masks, HaveLimitsAfterEachRound)
{
  const std::string masks = std::string(cubic) + four_point + cubic;
  for (const std::string linear : {"", "--linear "}) {
    const std::string options = linear + "--closed --limit --limit-tolerance 1e-12 --levels ";
    const std::vector<double> all = numbers(by_masks(polygon, masks, options + "3"));
    const std::size_t columns = linear.empty() ? 4 : 2;
    ASSERT_EQ(all.size(), 40 * columns);
    for (const std::size_t rounds : {0, 1, 2}) {
      const auto some = numbers(by_masks(polygon, masks, options + std::to_string(rounds)));
      ASSERT_EQ(some.size(), (std::size_t(5) << rounds) * columns);
      for (std::size_t i = 0; i < some.size(); ++i)
        EXPECT_NEAR(some[i], all[(i / columns << (3 - rounds)) * columns + i % columns], 1e-10);
    }
  }
}

TEST_F(Level_masks, AreRefusedByTheLine)
{
  expect_refusal(std::string(cubic) + "-2 0.125 0.5 0.7 0.5 0.125\n", "--closed", 1,
                 "line 2: the coefficients of even index sum to 0.95 instead of 1");
  expect_refusal("-2 0.125 0.5 0.75 0.25 0.125\n", "--closed", 1,
                 "line 1: the coefficients of odd index sum to 0.75");
  expect_refusal(std::string(cubic) + "-1 0.25 0.75 0.75 0.25\n", "--closed", 1,
                 "line 2: the masks before are centered at 0");
  expect_refusal("-2 0.125 half\n", "--closed", 1, "line 1: a mask is an integer");
  expect_refusal("0.5 0.5 1 0.5\n", "--closed", 1, "line 1: a mask is an integer");
  expect_refusal("2000 1 1\n", "--closed", 1, "-1000 to 1000");
  expect_refusal("# nothing\n", "--closed", 1, "has no mask");
}

TEST_F(Level_masks, AreRefusedBesideWhatTheyDoNotKnow)
{
  const std::string two = std::string(cubic) + cubic + four_point;
  expect_refusal(two, "--closed --normal-scheme 4-point", 2, "--normal-scheme");
  expect_refusal(two, "--closed --interpolate points", 2, "--interpolate");
  expect_one_line(
    curve(folder.write("polygon.txt", polygon), "none.txt", "--scheme levels:/no/such/file"), 1,
    "/no/such/file");
}

} // namespace

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The same segments whatever the pose, the scale, the numbers of the faces and the kind of the file.

#include "Part_marks.h"
#include "Random_parts.h"
#include "Trap_parts.h"

#include <gtest/gtest.h>

using namespace synthetic_parts;

namespace {

// Numbers of the segments by their first faces, and the kinds of these.
struct Segmentation
{
  std::vector<std::size_t> segment;
  std::vector<int> kind;
};

// `order`: the numbers of the faces that count
Segmentation segmentation(const Part& part, const std::vector<std::size_t>& order)
{
  const Recognition r = recognition_of(part);
  std::vector<std::size_t> of_face(part.faces.size());
  for (std::size_t f = 0; f < order.size(); ++f) of_face[order[f]] = r.segment_of_face[f];
  Segmentation s;
  std::map<std::size_t, std::size_t> numbers;
  for (std::size_t k : of_face) {
    s.segment.push_back(numbers.emplace(k, numbers.size()).first->second);
    s.kind.push_back(static_cast<int>(r.surfaces.at(k).kind));
  }
  return s;
}
Segmentation segmentation(const Part& part)
{
  std::vector<std::size_t> order(part.faces.size());
  for (std::size_t f = 0; f < order.size(); ++f) order[f] = f;
  return segmentation(part, order);
}

void expect_same(const Segmentation& a, const Segmentation& b, const Part& part)
{
  EXPECT_EQ(a.segment, b.segment) << part.name;
  EXPECT_EQ(a.kind, b.kind) << part.name;
}

// Not only such as are recognized entirely.
std::vector<Part> parts()
{
  Random random(31);
  std::vector<Part> p{box_with_fillets_and_chamfers(),
                      bolt(8, 24),
                      bored_prism(7),
                      rounded_box({3, 2, 1.5}, 0.3, steps(4), steps(4), random),
                      rounded_box({3, 2, 2}, 0.3, steps(3), steps(3), random),
                      shaft(24, 6),
                      elbow(steps(16), steps(4), 90, 0.2, random),
                      plate_with_drilled_hole(24),
                      cut_at_side(24, 1, 0.52),
                      regular_prism(40)};
  for (Vec& x : p.back().points) x[0] *= 2.3; // nothing that is known
  return p;
}

Part placed(Part part, const Pose& pose)
{
  place(part, pose);
  return part;
}

} // namespace

TEST(Recognize_invariance, pose)
{
  Random random(32);
  for (const Part& part : parts())
    expect_same(segmentation(part), segmentation(placed(part, random_pose(random, 2, 0))), part);
}

TEST(Recognize_invariance, scale)
{
  for (const Part& part : parts())
    for (double scale : {1e-6, 1e-3, 0.3, 7., 1e6}) {
      Pose pose;
      pose.scale = scale;
      expect_same(segmentation(part), segmentation(placed(part, pose)), part);
    }
}

TEST(Recognize_invariance, numbers_of_vertices_and_faces)
{
  Random random(33);
  for (const Part& part : parts()) {
    Part other = part;
    const std::vector<std::size_t> order = renumber(other, random);
    expect_same(segmentation(part), segmentation(other, order), part);
  }
}

TEST(Recognize_invariance, inside_out)
{
  for (const Part& part : parts()) {
    Part other = part;
    for (auto& face : other.faces) std::reverse(face.begin(), face.end());
    expect_same(segmentation(part), segmentation(other), part);
  }
}

TEST(Recognize_invariance, mirrored)
{
  for (const Part& part : parts()) {
    Part other = part;
    for (auto& face : other.faces) std::reverse(face.begin(), face.end());
    for (Vec& p : other.points) p[1] = -p[1];
    expect_same(segmentation(part), segmentation(other), part);
  }
}

TEST(Recognize_invariance, kind_of_file)
{
  for (const Part& part : parts()) {
    Random random(34);
    const Segmentation expected = segmentation(part);
    for (File file :
         {File::exact, File::single, File::six_digits, File::seven_digits, File::six_decimals})
      for (double shift : {0., 0.3}) {
        Part other = placed(part, random_pose(random, shift, 0.5));
        write_as(other, file);
        expect_same(expected, segmentation(other), part);
      }
  }
}

// in the axes of the part, where the most points are equal but for rounding
TEST(Recognize_invariance, kind_of_file_as_it_stands)
{
  for (const Part& part : parts()) {
    const Segmentation expected = segmentation(part);
    for (File file : {File::six_digits, File::seven_digits, File::six_decimals}) {
      Part other = part;
      write_as(other, file);
      expect_same(expected, segmentation(other), part);
    }
  }
}

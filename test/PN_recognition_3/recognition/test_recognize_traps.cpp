// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Parts that look like what they are not.

// Parts that one rule each is there for. Rules without such a part, and a file of others that comes out differently without
// them (*.off of Debian's package libcgal-demo, *.stl of cura and prusa-slicer, *.obj of data/meshes/parts):
//   growing     less tolerance again (part.off), fewest points to fit (handle.off), tangent to the next one (BIQU_SSS.stl)
//   evidence    sizes, what is left of a region (STREAM20PRO_platform.STL), bend against residual (mk3_bed.stl) and tolerance
//               (pbr3d_g1_buildplate.stl), inner vertices of spheres (u.off) and tori (handle.off), three positions
//               between tangent ends (gmax2_bed.stl)
//   cuts        dropped (pinion.off), but for what has inner vertices (nozzle.stl), ends (ender3_bed.stl), is continued by
//               half a patch (part.off) or touches a plane (Jubilee_bed.stl)
//   rounds      small tori (couplingdown.off), contradicted by what is smaller (bearing_housing.obj), not by spheres (lens.obj)
//   borders     cut facets (helper_disk.stl), four corners (lens.obj), slivers to their own surface (ender3_bed.stl)
//   planes      four times as large (anchor.off), six faces (handle.off), fitted (nozzle.stl), about an apex (tripod.off),
//               joined (mini_bed.stl), patches grown again from their widest face (STREAM20PRO_platform.STL)
//   guesses     by rulings (dragknob.off), by fits of spheres (ender3_bed.stl), cylinders over rings (part.off), cones
//               among facets of one size (couplingdown.off)

#include "Part_marks.h"
#include "Random_parts.h"
#include "Trap_parts.h"

#include <gtest/gtest.h>

using namespace synthetic_parts;
using Recognized_kind = Recognized_surface::Kind;

namespace {

void expect_right(const Part& part)
{
  EXPECT_EQ(Part_marks(part, recognition_of(part)).text(), "") << part.name;
}

Part in_file(Part part, File file, double shift = 0.3)
{
  Random random(21);
  place(part, random_pose(random, shift, 0));
  write_as(part, file);
  return part;
}

} // namespace

TEST(Recognize_traps, plane_section_of_a_sphere)
{
  for (const bool are_triangles : {false, true}) expect_right(zone_of_a_sphere(32, are_triangles));
}

// No two joints of a triangle are without a vertex in common: no facets are in a row.
TEST(Recognize_traps, sphere_of_triangles_in_no_rows)
{
  for (int splits : {2, 3}) expect_right(geodesic_ball(splits));
}

TEST(Recognize_traps, frustum_whose_corners_are_on_a_sphere)
{
  for (double top : {0.3, 0.6, 0.9}) expect_right(regular_prism(6, top));
}

// All 24 facets are on a sphere, the lowest of which turn by 60 degrees: they are too far from it in between.
TEST(Recognize_traps, dome_of_six_sides)
{
  const Chain profile = Chain(1, 0).arc(0, 0, 90, {0, 1. / 3, 5. / 9, 7. / 9, 1});
  const Recognition r = recognition_of(turned_part("dome of six sides", profile, 6, false));
  for (const auto kind : {Recognized_kind::cylinder, Recognized_kind::cone, Recognized_kind::sphere,
                          Recognized_kind::torus})
    EXPECT_EQ(r.count(kind), 0u) << name_of(kind);
}

TEST(Recognize_traps, face_between_equal_fillets)
{
  for (int facets : {3, 4})
    for (double flat : {0.1, 0.16, 0.207, 0.25, 0.3}) {
      SCOPED_TRACE(flat);
      expect_right(narrow_plate(flat, facets));
    }
}

TEST(Recognize_traps, face_of_a_rounded_box_and_what_surrounds_it)
{
  Random random(22);
  for (int quarter : {3, 4, 6})
    for (double flat : {0.1, 0.2, 0.4}) {
      SCOPED_TRACE(flat);
      const Vec size{0.6 + flat, 0.6 + flat, 0.6 + 2 * flat};
      expect_right(rounded_box(size, 0.3, steps(quarter), steps(quarter), random));
    }
}

TEST(Recognize_traps, octagonal_head_on_a_finer_shank)
{
  for (int n : {16, 24, 48}) expect_right(bolt(8, n));
  for (int n : {16, 24}) expect_right(bolt(9, n, 0.7));
}

TEST(Recognize_traps, open_nut_trap)
{
  expect_right(open_nut_trap());
  expect_right(open_slot());
}

TEST(Recognize_traps, flat_of_a_shaft)
{
  for (int n : {18, 24, 36})
    for (double chord : {60., 80.}) expect_right(shaft_with_flat(n, chord));
}

TEST(Recognize_traps, disc_that_is_tangent_to_a_torus)
{
  for (int n : {12, 24}) expect_right(rounded_stub(n, n / 4));
}

TEST(Recognize_traps, coplanar_facets_of_pipe_and_bend)
{
  Random random(23);
  for (int n : {10, 12, 16, 24}) {
    SCOPED_TRACE(n);
    expect_right(elbow(steps(n), steps(5), 75, 0, random, pi / n));
    expect_right(elbow(steps(n), steps(5), 75, 0.3, random, pi / n));
  }
}

TEST(Recognize_traps, angles_about_the_tube_beyond_pi)
{
  expect_right(grooved_shaft(24, 6));
  expect_right(grooved_shaft(24, 7));
}

TEST(Recognize_traps, apex_of_a_drill_point_in_six_digits)
{
  for (int n : {12, 24, 36}) expect_right(in_file(plate_with_drilled_hole(n), File::six_digits));
}

TEST(Recognize_traps, sliver_between_planes)
{
  Part part = plate_with_hole(24);
  const std::size_t sliver = insert_sliver(part, Kind::plane, Kind::plane);
  const Recognition r = recognition_of(part);
  // either plane may have it
  for (const auto& [edge, f] : halfedges(part))
    if (f == sliver && r.segment_of_face[halfedges(part).at({edge.second, edge.first})] ==
                         r.segment_of_face[sliver])
      part.surface_of_face[sliver] =
        part.surface_of_face[halfedges(part).at({edge.second, edge.first})];
  EXPECT_EQ(Part_marks(part, r).text(), "");
}

TEST(Recognize_traps, sliver_along_a_rim)
{
  Part part = plate_with_hole(24);
  insert_sliver(part, Kind::plane, Kind::cylinder);
  expect_right(part);
  expect_right(in_file(part, File::single));
}

TEST(Recognize_traps, vertices_on_chords)
{
  const auto expect_segments = [](const Part& part) {
    const Part_marks marks(part, recognition_of(part));
    EXPECT_TRUE(marks.are_segments_right()) << marks.text();
  };
  for (int n : {16, 20, 24, 32}) {
    SCOPED_TRACE(n);
    for (double at : {0.13, 0.52})
      for (double top : {1., 0.6, 1.5}) expect_segments(cut_at_side(n, top, at));
    for (double slope : {0., 0.2})
      for (double top : {0.3, 0.6, 1.5}) expect_segments(cut_between_circles(n, top, 0.7, slope));
    expect_segments(cut_between_circles(n, 0.4, 0.2, 0)); // a flat cone
    expect_segments(cut_between_circles(n, 1, 4, 1));
    expect_segments(bitten_cylinder(n));
  }
}

TEST(Recognize_traps, far_from_the_origin)
{
  expect_right(in_file(shaft(24, 6), File::single, 15 * 3.5));
  expect_right(in_file(bolt(6, 24), File::exact, 15 * 3.5));
}

// Another program turns and scales a six-digit file, and writes all digits; the points keep the rounding of six.
TEST(Recognize_traps, six_digits_in_another_frame)
{
  Random random(23);
  for (Part part : {bolt(8, 24), shaft(48, 6), plate_with_drilled_hole(24), grooved_shaft(24, 8)}) {
    part = in_file(part, File::six_digits);
    const double before = rounding(part) / diagonal(part.points);
    Pose pose = random_pose(random, 0, 0);
    pose.scale = 1.7;
    place(part, pose);
    EXPECT_EQ(Part_marks(part, recognition_of(part), 8 * before).text(), "") << part.name;
    // far from the origin
    Pose away;
    away.shift = {1e5, -2e5, 3e4};
    Part moved = part;
    place(moved, away);
    const Recognition r = recognition_of(moved), here = recognition_of(part);
    EXPECT_EQ(r.segment_of_face, here.segment_of_face) << part.name;
    place(part, {{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {}, std::ldexp(1., 600)});
    EXPECT_EQ(recognition_of(part).segment_of_face, here.segment_of_face) << part.name;
  }
}

// All corners of a plane that cuts a cylinder are on it, and some of its edges turn by little.
TEST(Recognize_traps, oblique_end_of_a_cylinder)
{
  for (const double slope : {0.5, 1., 1.7}) expect_right(oblique_cylinder(24, slope));
}

// The facets around a square face are on a sphere with it, if all steps are equal: by symmetry.
TEST(Recognize_traps, square_faces_between_equal_fillets)
{
  Random random(24);
  for (const Vec& size : {Vec{2, 2, 2}, Vec{3, 2, 2}})
    for (double r : {0.1, 0.3}) expect_right(rounded_box(size, r, steps(3), steps(3), random));
}

// At the poles of the corners the faces are so narrow that they are in the planes of the fillets beside them, up to rounding.
TEST(Recognize_traps, narrow_faces_at_poles)
{
  Random random(25);
  Part part = rounded_box({3, 2, 1.5}, 0.05, steps(8), steps(8), random);
  write_as(part, File::six_digits);
  expect_right(part);
}

// Few facets, unevenly wide, of a cone and of the cylinder beside it are on a torus.
TEST(Recognize_traps, uneven_facets_on_a_torus)
{
  expect_right(Random_part(1134).part());
}

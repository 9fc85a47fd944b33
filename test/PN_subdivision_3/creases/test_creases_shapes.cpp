// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Parts of planes, cylinders and spheres stay exactly that, up to their creases.

#include "Crease_shapes.h"

#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/modified_CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/modified_Loop_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/scheme_adaptors.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>

namespace {

using namespace crease_shapes;
using crease_levels::Crease_run;
using crease_levels::Index;
using crease_levels::Level_connectivity;
using crease_levels::triangulated;
using namespace CGAL::PN_subdivision_3;

// the group of every face after a round, in the documented order of the children
template <class Host>
std::vector<std::size_t> refined_groups(const Level_connectivity& level,
                                        const std::vector<std::size_t>& group)
{
  std::vector<std::size_t> first = group, others;
  for (Index f = 0; f < level.number_of_faces(); ++f) {
    const Index m = level.degree(level.halfedge_of_face(f));
    for (Index i = 0; i + (std::is_same_v<Host, PQQ_host> ? 1 : 0) < m; ++i)
      others.push_back(group[f]);
  }
  first.insert(first.end(), others.begin(), others.end());
  return first;
}

struct Deviation
{
  Real points = 0, normals = 0, border = 0;
};

// of all corners from the surface of their face, and of the border
template <class FT, class Scheme>
Deviation deviation(const Part& part, const Control& control, std::vector<std::size_t> group,
                    const Scheme& scheme, int rounds)
{
  Crease_run<FT, Scheme> run(control, scheme);
  for (int k = 0; k < rounds; ++k) {
    group = refined_groups<typename Scheme::Host>(run.level(), group);
    run.refine();
  }
  const auto vector = [](const auto& x) { return Vector(Real(x[0]), Real(x[1]), Real(x[2])); };
  Deviation d;
  const auto grow = [](Real& greatest, Real x) {
    if (!(x <= greatest)) greatest = x;
  };
  run.for_each_corner([&](Index f, Index v, Index slot) {
    const Surface& s = part.surfaces[group[f]];
    const Vector p = vector(run.point(slot));
    grow(d.points, s.distance(p));
    if (Crease_run<FT, Scheme>::is_pn)
      grow(d.normals, (vector(run.normal(slot)) - s.normal(p)).norm());
    if (part.of_border.empty() || !run.level().is_border_vertex(v)) return;
    Real least = std::numeric_limits<Real>::infinity();
    for (const Surface& b : part.of_border) least = (std::min)(least, b.distance(p));
    grow(d.border, least);
  });
  return d;
}

struct Shape
{
  const char* name;
  std::function<Part()> make;
  int rounds = 6;
};

std::string name_of(const ::testing::TestParamInfo<Shape>& info)
{
  return info.param.name;
}

class Crease_shapes : public ::testing::TestWithParam<Shape>
{
protected:
  // calls f(scheme, control, groups) for the schemes
  template <class Function>
  static void for_each_scheme(const Part& part, bool with_normals, const Function& f)
  {
    const Control polygons = part.control(with_normals), triangles = triangulated(polygons);
    std::vector<std::size_t> groups;
    for (std::size_t i = 0; i < part.faces.size(); ++i)
      groups.insert(groups.end(), part.faces[i].size() - 2, part.group[i]);
    f(CatmullClark_scheme(), polygons, part.group, "Catmull-Clark");
    f(modified_CatmullClark_scheme(), polygons, part.group, "modified Catmull-Clark");
    f(Loop_scheme(), triangles, groups, "Loop");
    f(modified_Loop_scheme(), triangles, groups, "modified Loop");
  }
};

TEST_P(Crease_shapes, Stay_exact)
{
  Part part = GetParam().make();
  part.place();
  const Real epsilon = std::numeric_limits<double>::epsilon();
  for_each_scheme(
    part, true,
    [&](const auto& scheme, const Control& control, const std::vector<std::size_t>& group,
        const char* name) {
      const Deviation d = deviation<double>(part, control, group, scheme, GetParam().rounds);
      EXPECT_LE(d.points, 8 * epsilon * part.scale()) << name;
      EXPECT_LE(d.border, 8 * epsilon * part.scale()) << name;
      EXPECT_LE(d.normals, 8 * epsilon) << name;
      RecordProperty(std::string(name) + " points", std::to_string(double(d.points / epsilon)));
      std::printf("%s %s: points %.2f (scale %.2f) border %.2f normals %.2f\n", GetParam().name,
                  name, double(d.points / epsilon / part.scale()), double(part.scale()),
                  double(d.border / epsilon / part.scale()), double(d.normals / epsilon));
    });
}

INSTANTIATE_TEST_SUITE_P(
  Parts, Crease_shapes,
  ::testing::Values(Shape{"cylinder_of_7_sides", [] { return capped_cylinder(uneven(7)); }},
                    Shape{"cylinder_of_4_sides", [] { return capped_cylinder(uneven(4)); }},
                    Shape{"cylinder_of_3_sides",
                          [] {
                            return capped_cylinder({0, Real(165) / 180 * pi, Real(250) / 180 * pi});
                          },
                          3},
                    Shape{"half_ball", half_ball}, Shape{"lens", lens}, Shape{"bullet", bullet},
                    Shape{"washer", washer}, Shape{"countersink", countersink},
                    Shape{"d_section", d_section}, Shape{"rounded_box", rounded_box},
                    Shape{"bolt", bolt}, Shape{"cube", cube},
                    Shape{"plate_with_hole", plate_with_hole}, Shape{"ball_cap", ball_cap},
                    Shape{"octant", octant}),
  name_of);

} // namespace

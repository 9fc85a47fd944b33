// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// PN_mask_3 over CGAL's masks in CGAL's hosts: reproduction on all kinds of meshes. That its nodes are those of the PN rule
// is asked by suite/named_shapes.h.

#include "Messages.h"
#include "PN_mask_3_cases.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Epick_mesh = CGAL::Surface_mesh<Epick::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Epick>;

template <class Scheme_, class Mesh_>
struct Case
{
  using Scheme = Scheme_;
  using Mesh = Mesh_;
};

template <class>
class PN_mask_3 : public testing::Test
{};

using Cases =
  testing::Types<Case<CatmullClark, Surface_mesh>, Case<Loop, Surface_mesh>,
                 Case<DooSabin, Surface_mesh>, Case<Sqrt3, Surface_mesh>,
                 Case<CatmullClark, Epick_mesh>, Case<CatmullClark, Polyhedron>,
                 Case<Loop, Polyhedron>, Case<DooSabin, Polyhedron>, Case<Sqrt3, Polyhedron>>;
TYPED_TEST_SUITE(PN_mask_3, Cases, );

template <class Vector>
long double length(const Vector& v)
{
  const long double x = v.x(), y = v.y(), z = v.z();
  return std::sqrt(x * x + y * y + z * z);
}

// with control normals of any length
TYPED_TEST(PN_mask_3, KeepsSphere)
{
  using Scheme = typename TypeParam::Scheme;
  for (bool closed : {true, false})
    for (double factor : {1., 1e-250, 1e250}) {
      Control<typename TypeParam::Mesh> control(on_sphere(control_mesh<Scheme>(closed), 2, factor));
      subdivide_pn<Scheme>(control, factor == 1 ? 5 : 2);
      EXPECT_GT(num_vertices(control.mesh), factor == 1 ? 1000u : 20u);
      for (auto v : vertices(control.mesh)) {
        const auto radius = get(get(CGAL::vertex_point, control.mesh), v) - CGAL::ORIGIN;
        const auto normal = get(control.normals, v);
        ASSERT_NEAR(double(length(radius) / 2 - 1), 0, 4e-15);
        ASSERT_NEAR(double(length(normal) - 1), 0, 1e-15);
        ASSERT_NEAR(double(length(radius / 2 - normal)), 0, 1e-14);
      }
    }
}

// --- input that CGAL's hosts do not check ---

TEST(PN_mask_3_checks, NamesTheOffendingVertex)
{
  const Control_mesh house = on_sphere(control_mesh<CatmullClark>(true), 1);
  const auto message = [](Control<Surface_mesh>& control) {
    return messages::message_of([&] { CatmullClark::mask(control.mesh, control.point_normals()); });
  };
  {
    Control<Surface_mesh> control(house);
    EXPECT_EQ(message(control), "");
    control.mesh.point(CGAL::SM_Vertex_index(3)) =
      Kernel::Point_3(0, std::numeric_limits<double>::quiet_NaN(), 0);
    messages::expect_words(message(control), {"vertex 3 "});
  }
  {
    Control<Surface_mesh> control(house);
    put(control.normals, CGAL::SM_Vertex_index(5),
        Kernel::Vector_3(0, 0, -std::numeric_limits<double>::infinity()));
    messages::expect_words(message(control), {"vertex 5 "});
  }
  {
    Control<Surface_mesh> control(house);
    put(control.normals, control.mesh.add_vertex(Kernel::Point_3(9, 9, 9)), CGAL::NULL_VECTOR);
    messages::expect_words(message(control), {"vertex 11 "});
    messages::expect_words(message(control), {"has no edge"});
  }
}

} // namespace

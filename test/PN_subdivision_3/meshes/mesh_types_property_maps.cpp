// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Property maps of a Surface_mesh by name, with CGAL 5 and with CGAL 6.

#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <string>

namespace {

using CGAL::PN_subdivision_3::internal::find_property_map;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

template <class Element, class Value>
void expect_found_by_name_and_type(Mesh mesh, const Value& value)
{
  const Element first(0);
  EXPECT_FALSE((find_property_map<Element, Value>(mesh, "x")));
  mesh.add_property_map<Element, Value>("x").first[first] = value;
  const Mesh copy = mesh;
  const auto map = find_property_map<Element, Value>(copy, "x");
  ASSERT_TRUE(map);
  EXPECT_EQ((*map)[first], value);
  EXPECT_FALSE((find_property_map<Element, Value>(copy, "y")));
  EXPECT_FALSE((find_property_map<Element, char>(copy, "x")));
}

} // namespace

TEST(Property_maps, AreFoundByNameAndType)
{
  Mesh mesh;
  mesh.add_face(mesh.add_vertex({0, 0, 0}), mesh.add_vertex({1, 0, 0}), mesh.add_vertex({0, 1, 0}));
  expect_found_by_name_and_type<Mesh::Vertex_index>(mesh, Kernel::Vector_3(1, 2, 3));
  expect_found_by_name_and_type<Mesh::Halfedge_index>(mesh, Kernel::Vector_3(4, 5, 6));
  expect_found_by_name_and_type<Mesh::Edge_index>(mesh, 0.5);
  expect_found_by_name_and_type<Mesh::Face_index>(mesh, std::string("face"));
  const auto points = find_property_map<Mesh::Vertex_index, Kernel::Point_3>(mesh, "v:point");
  ASSERT_TRUE(points);
  EXPECT_EQ((*points)[Mesh::Vertex_index(1)], Kernel::Point_3(1, 0, 0));
}

// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include <CGAL/PN_subdivision_3/parameters/Default_visitor.h>

using namespace CGAL::PN_subdivision_3;

namespace header_in_use {

bool use_control_element(const Control_element& a, const Control_element& b)
{
  return a == b || a < b;
}

struct Visitor : Default_visitor
{
  void face_created(int, const Control_element&) {}
};
void use_default_visitor(Visitor& visitor)
{
  visitor.face_created(1, {Control_element::Kind::face, 0});
  visitor.round_done(1, 6);
  visitor.vertex_created(1, {Control_element::Kind::vertex, 0});
}

} // namespace header_in_use

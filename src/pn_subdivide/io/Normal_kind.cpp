// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/Normal_kind.h"

#include <algorithm>

namespace pn_subdivide {

const char* comment_of(Normal_kind kind)
{
  switch (kind) {
  case Normal_kind::of_mesh:
    return "normals of the mesh";
  case Normal_kind::of_surface:
    return "normals of the surface";
  case Normal_kind::control:
    break;
  }
  return "control normals";
}

namespace {

bool is_said(const std::vector<std::string>& comments, Normal_kind kind)
{
  return std::find(comments.begin(), comments.end(), comment_of(kind)) != comments.end();
}

} // namespace

Normal_kind normal_kind_of(const std::vector<std::string>& comments)
{
  for (const Normal_kind kind : {Normal_kind::of_mesh, Normal_kind::of_surface})
    if (is_said(comments, kind)) return kind;
  return Normal_kind::control;
}

bool are_said_to_be_control(const std::vector<std::string>& comments)
{
  return normal_kind_of(comments) == Normal_kind::control &&
         is_said(comments, Normal_kind::control);
}

} // namespace pn_subdivide

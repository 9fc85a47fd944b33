// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_ELEMENT_NAMES_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_ELEMENT_NAMES_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>

#include <string>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// What the elements of a control level are called in messages. Virtual, so that checks need not be
// instantiated for every mesh.
class Element_names
{
public:
  using Index = Level_connectivity::Index;

  virtual std::string vertex_name(Index v) const = 0;
  virtual std::string halfedge_name(Index h) const = 0;
  virtual std::string face_name(Index f) const = 0;

protected:
  Element_names() = default;
  Element_names(const Element_names&) = default;
  Element_names& operator=(const Element_names&) = default;
  ~Element_names() = default;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_ELEMENT_NAMES_H

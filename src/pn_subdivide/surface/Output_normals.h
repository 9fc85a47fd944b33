// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_OUTPUT_NORMALS_H
#define PN_SUBDIVIDE_OUTPUT_NORMALS_H

#include "io/Mesh_data.h"
#include "io/mesh_io.h"

#include <string>

namespace pn_subdivide {

struct Surface_options;

// Which normals are written, as --output-normals and the old --surface-normals say it.
struct Output_normals
{
  enum class Choice { automatic, surface, control, both, none };

  Choice choice = Choice::automatic;
  Normal_kind kind = Normal_kind::control; // of those that are written as the mesh's normals
  bool copies = false;                     // those of the control mesh are written as they are
  double scale = 1;                        // a power of 2, about one over the size of the mesh

  bool any() const { return choice != Choice::none; }
  bool with_control() const { return choice == Choice::both; }

  // Throws Usage_error if the options contradict each other.
  static Output_normals make(const Surface_options& options, const Mesh_file& output);

  // Are those of the faces to be computed?
  bool are_of_faces() const { return kind == Normal_kind::of_mesh && !copies; }

  // to the control mesh with its normals
  void suit(const Mesh_data& mesh);
};

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_OUTPUT_NORMALS_H

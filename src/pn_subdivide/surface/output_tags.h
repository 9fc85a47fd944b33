// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_OUTPUT_TAGS_H
#define PN_SUBDIVIDE_OUTPUT_TAGS_H

#include "io/Output_file.h"
#include "io/Report.h"
#include "io/mesh_io.h"
#include "surface/Output_normals.h"
#include "surface/surface_command.h"

#include <optional>
#include <string>
#include <vector>

namespace pn_subdivide {

// What is sharp in the result, as it is written beside control normals and by --write-tags.

// Throws Usage_error if --write-tags does not go with the other options, which name `other_files`, and Error if its
// file cannot be written.
void require_tags_place(const Surface_options& options,
                        const std::vector<std::string>& other_files);

// Are the tags of the result written anywhere?
bool are_tags_written(const Surface_options& options, const Output_normals& normals);

// Leaves those tags in the mesh that its own file gets, and warns of what is not written.
void suit_tags(Mesh_data& mesh, const Mesh_file& output, const Surface_options& options,
               const Output_normals& normals, Report& report);

// A file with a selection, which appears by commit().
class Tags_file
{
public:
  // Nothing without --write-tags.
  Tags_file(const Surface_options& options, const Crease_tags& tags, Report& report);
  void commit();

private:
  std::string name_;
  std::optional<Output_file> file_;
};

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_OUTPUT_TAGS_H

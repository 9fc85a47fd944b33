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
#include "surface/Recognized_part.h"
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

struct Surface_options;

// The numbers of segments: of control faces in a file, and as a property of the faces of the result.

// Throws Usage_error or Error if the file of --surface-labels cannot be one: it is none of `others`.
void require_labels_place(const Surface_options& options, const std::vector<std::string>& others);

// A file with the segment of each face, one a line, which appears by commit().
class Labels_file
{
public:
  // Nothing without --surface-labels.
  Labels_file(const Surface_options& options, const Recognized_part* part);
  void commit();

private:
  std::string name_;
  std::optional<Output_file> file_;
};

// Adds the property, which the children of the faces get, too. One of the user's with this name gives way.
void add_segments(Mesh_data& mesh, const Recognized_part& part, const std::string& name,
                  Report& report);
// The same of a part that was not asked for, under a name that no file has, and not to be written.
void add_hidden_segments(Mesh_data& mesh, const Recognized_part& part);
// That property; nullptr if there is none.
std::vector<double>* segments_of(Attributes& attributes);
// It stays where files have properties of faces, without a word elsewhere.
void suit_segments(Mesh_data& mesh, const Mesh_file& output);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_OUTPUT_TAGS_H
